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
    var phi_174_: u32;
    var phi_177_: type_9;
    var phi_178_: type_9;
    var phi_201_: type_9;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_418_: f32;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_438_: f32;
    var phi_443_: f32;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_522_: type_33;
    var phi_594_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_631_: f32;
    var phi_636_: f32;
    var phi_641_: f32;
    var phi_698_: type_33;
    var phi_715_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_737_: f32;
    var phi_745_: f32;
    var phi_752_: f32;
    var phi_757_: f32;
    var phi_764_: f32;
    var phi_769_: f32;
    var phi_774_: f32;
    var phi_782_: f32;
    var phi_789_: f32;
    var phi_794_: f32;
    var phi_801_: f32;
    var phi_806_: f32;
    var phi_811_: f32;
    var phi_832_: u32;
    var phi_834_: f32;
    var phi_835_: bool;
    var phi_836_: f32;
    var phi_837_: bool;
    var phi_841_: f32;
    var phi_1108_: f32;
    var phi_1115_: f32;
    var phi_1120_: f32;
    var phi_1127_: f32;
    var phi_1132_: f32;
    var phi_1141_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1168_: f32;
    var phi_1189_: u32;
    var phi_1234_: type_14;
    var phi_1237_: f32;
    var phi_1258_: bool;
    var phi_1264_: type_15;
    var phi_1235_: type_14;
    var phi_1278_: type_15;
    var phi_1238_: f32;
    var local: f32;
    var phi_1227_: f32;
    var phi_1291_: f32;
    var phi_1303_: type_34;
    var phi_1342_: type_9;
    var phi_1345_: type_36;
    var phi_1343_: type_9;
    var phi_1368_: type_9;
    var phi_1388_: f32;
    var phi_1395_: f32;
    var phi_1428_: type_14;
    var phi_1431_: f32;
    var phi_1452_: bool;
    var phi_1458_: type_15;
    var phi_1429_: type_14;
    var phi_1472_: type_15;
    var phi_1432_: f32;
    var local_1: f32;
    var phi_1421_: f32;
    var phi_1485_: f32;
    var phi_1492_: f32;
    var phi_1526_: type_14;
    var phi_1529_: f32;
    var phi_1550_: bool;
    var phi_1556_: type_15;
    var phi_1527_: type_14;
    var phi_1570_: type_15;
    var phi_1530_: f32;
    var local_2: f32;
    var phi_1519_: f32;
    var phi_1583_: f32;
    var phi_1595_: type_34;
    var phi_1691_: type_14;
    var phi_1694_: f32;
    var phi_1715_: bool;
    var phi_1721_: type_15;
    var phi_1692_: type_14;
    var phi_1735_: type_15;
    var phi_1695_: f32;
    var local_3: f32;
    var phi_1684_: f32;
    var phi_1748_: f32;
    var phi_1760_: type_34;
    var phi_1827_: type_36;
    var phi_1828_: bool;
    var phi_1829_: type_36;
    var phi_1830_: bool;
    var phi_2119_: type_14;
    var phi_2122_: f32;
    var phi_2143_: bool;
    var phi_2149_: type_15;
    var phi_2120_: type_14;
    var phi_2163_: type_15;
    var phi_2123_: f32;
    var local_4: f32;
    var phi_2112_: f32;
    var phi_2176_: f32;
    var phi_2183_: f32;
    var phi_2217_: type_14;
    var phi_2220_: f32;
    var phi_2241_: bool;
    var phi_2247_: type_15;
    var phi_2218_: type_14;
    var phi_2261_: type_15;
    var phi_2221_: f32;
    var local_5: f32;
    var phi_2210_: f32;
    var phi_2274_: f32;
    var phi_2286_: type_34;
    var phi_2348_: type_36;
    var phi_1862_: type_14;
    var phi_1865_: f32;
    var phi_1886_: bool;
    var phi_1892_: type_15;
    var phi_1863_: type_14;
    var phi_1906_: type_15;
    var phi_1866_: f32;
    var local_6: f32;
    var phi_1855_: f32;
    var phi_1919_: f32;
    var phi_1926_: f32;
    var phi_1960_: type_14;
    var phi_1963_: f32;
    var phi_1984_: bool;
    var phi_1990_: type_15;
    var phi_1961_: type_14;
    var phi_2004_: type_15;
    var phi_1964_: f32;
    var local_7: f32;
    var phi_1953_: f32;
    var phi_2017_: f32;
    var phi_2029_: type_34;
    var phi_2349_: type_36;
    var phi_2350_: type_36;
    var phi_2354_: bool;
    var phi_2358_: bool;
    var phi_1346_: type_36;
    var phi_2359_: type_36;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var local_8: bool;
    var phi_2365_: type_36;
    var phi_2377_: u32;
    var phi_2510_: f32;
    var phi_2516_: f32;
    var phi_2522_: f32;
    var phi_2528_: f32;
    var phi_2534_: f32;
    var phi_2540_: f32;
    var phi_2584_: f32;
    var phi_2590_: f32;
    var phi_2596_: f32;
    var phi_2602_: f32;
    var phi_2608_: f32;
    var phi_2614_: f32;
    var phi_2658_: f32;
    var phi_2664_: f32;
    var phi_2670_: f32;
    var phi_2676_: f32;
    var phi_2682_: f32;
    var phi_2688_: f32;
    var phi_2729_: f32;
    var phi_2735_: f32;
    var phi_2740_: f32;
    var phi_2746_: f32;
    var phi_2751_: f32;
    var phi_2757_: f32;
    var phi_2763_: f32;
    var phi_2768_: f32;
    var phi_2774_: f32;
    var phi_2779_: f32;
    var phi_2784_: f32;
    var phi_2795_: array<array<f32, 3>, 3>;
    var phi_2797_: type_37;
    var phi_2798_: bool;
    var phi_2799_: type_37;
    var phi_2800_: bool;
    var phi_2813_: type_37;
    var phi_2858_: f32;
    var phi_2864_: f32;
    var phi_2870_: f32;
    var phi_2922_: f32;
    var phi_2928_: f32;
    var phi_2934_: f32;
    var phi_2986_: f32;
    var phi_2992_: f32;
    var phi_2998_: f32;
    var phi_3050_: f32;
    var phi_3056_: f32;
    var phi_3062_: f32;
    var phi_3114_: f32;
    var phi_3120_: f32;
    var phi_3126_: f32;
    var phi_3178_: f32;
    var phi_3184_: f32;
    var phi_3190_: f32;
    var phi_3236_: f32;
    var phi_3241_: f32;
    var phi_3246_: f32;
    var phi_3254_: f32;
    var phi_3259_: f32;
    var phi_3264_: f32;
    var phi_3313_: f32;
    var phi_3320_: f32;
    var phi_3327_: f32;
    var phi_3335_: f32;
    var phi_3342_: f32;
    var phi_3349_: f32;
    var phi_3354_: f32;
    var phi_3359_: f32;
    var phi_3364_: f32;
    var phi_3377_: f32;
    var phi_3383_: f32;
    var phi_3390_: f32;
    var phi_3401_: f32;
    var phi_3408_: f32;
    var phi_3415_: f32;
    var phi_3428_: f32;
    var phi_3435_: f32;
    var phi_3442_: f32;
    var phi_3455_: f32;
    var phi_3462_: f32;
    var phi_3469_: f32;
    var phi_3496_: f32;
    var phi_3503_: f32;
    var phi_3511_: f32;
    var phi_3520_: f32;
    var phi_3526_: f32;
    var phi_3532_: f32;
    var phi_3540_: f32;
    var phi_3547_: f32;
    var phi_3554_: f32;
    var phi_3567_: f32;
    var phi_3574_: f32;
    var phi_3581_: f32;
    var phi_3594_: f32;
    var phi_3601_: f32;
    var phi_3608_: f32;
    var phi_3655_: f32;
    var phi_3661_: f32;
    var phi_3667_: f32;
    var phi_3711_: f32;
    var phi_3717_: f32;
    var phi_3723_: f32;
    var phi_3775_: f32;
    var phi_3781_: f32;
    var phi_3787_: f32;
    var phi_3839_: f32;
    var phi_3845_: f32;
    var phi_3851_: f32;
    var phi_3880_: f32;
    var phi_3887_: f32;
    var phi_3895_: f32;
    var phi_3904_: f32;
    var phi_3910_: f32;
    var phi_3916_: f32;
    var phi_3924_: f32;
    var phi_3931_: f32;
    var phi_3938_: f32;
    var phi_3951_: f32;
    var phi_3958_: f32;
    var phi_3965_: f32;
    var phi_3978_: f32;
    var phi_3985_: f32;
    var phi_3992_: f32;
    var phi_4039_: f32;
    var phi_4045_: f32;
    var phi_4051_: f32;
    var phi_4095_: f32;
    var phi_4101_: f32;
    var phi_4107_: f32;
    var phi_4159_: f32;
    var phi_4165_: f32;
    var phi_4171_: f32;
    var phi_4223_: f32;
    var phi_4229_: f32;
    var phi_4235_: f32;
    var phi_4271_: bool;
    var phi_4272_: bool;
    var phi_4273_: bool;
    var phi_4274_: bool;
    var phi_4278_: bool;
    var phi_4297_: bool;
    var phi_4298_: bool;
    var phi_4299_: bool;
    var phi_4300_: bool;
    var phi_4304_: bool;
    var phi_4312_: f32;
    var phi_4317_: f32;
    var phi_4322_: f32;
    var phi_4325_: type_33;
    var phi_4326_: bool;
    var phi_4327_: type_33;
    var phi_4328_: bool;
    var phi_4342_: u32;
    var phi_4352_: type_33;
    var phi_4384_: bool;
    var phi_4385_: bool;
    var local_9: type_36;
    var local_10: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e71 = far.member[0u];
    let _e74 = params.member.member_2.member_1;
    let _e78 = params.member.member.member_2[_e74];
    let _e81 = params.member.member_1.member_1;
    let _e82 = ((_e52.x * _e52.y) * 128u);
    if (_e82 == 0u) {
        return;
    }
    let _e84 = (_e71 / _e82);
    if (_e82 == 0u) {
        return;
    }
    if ((_e71 % _e82) > 0u) {
        phi_174_ = (_e84 + 1u);
    } else {
        phi_174_ = _e84;
    }
    let _e90 = phi_174_;
    phi_177_ = type_9(0u, _e90);
    loop {
        let _e93 = phi_177_;
        if (_e93.member < _e93.member_1) {
            phi_178_ = type_9((_e93.member + 1u), _e93.member_1);
            phi_201_ = type_9(1u, _e93.member);
        } else {
            phi_178_ = _e93;
            phi_201_ = type_9(0u, type_9().member_1);
        }
        let _e105 = phi_178_;
        let _e107 = phi_201_;
        if (bitcast<i32>(_e107.member) != 0i) {
            let _e113 = ((_e107.member_1 * _e82) + ((((_e51.y * _e52.x) + _e51.x) * 128u) + _e53));
            if (_e113 >= _e71) {
                phi_4384_ = false;
            } else {
                let _e117 = far.member[(4u + _e113)];
                let _e118 = (_e78 + _e117);
                let _e120 = atomicLoad((&stamps.member[_e118]));
                if (_e120 == 0u) {
                    let _e123 = branches.member[_e117];
                    let _e128 = params.member.member_2.member_1;
                    let _e133 = params.member.member.member[_e128];
                    if ((_e123.x + 1u) >= _e133) {
                        phi_296_ = true;
                    } else {
                        let _e138 = params.member.member.member_2[_e128];
                        let _e141 = atomicLoad((&stamps.member[(_e138 + _e123.x)]));
                        let _e144 = params.member.member_1.member_1;
                        if (_e141 == 0u) {
                            phi_295_ = false;
                        } else {
                            phi_295_ = (_e141 < _e144);
                        }
                        let _e148 = phi_295_;
                        phi_296_ = _e148;
                    }
                    let _e150 = phi_296_;
                    if _e150 {
                        let _e153 = params.member.member_2.member_1;
                        let _e158 = params.member.member.member[_e153];
                        if ((_e123.y + 1u) >= _e158) {
                            phi_343_ = true;
                        } else {
                            let _e163 = params.member.member.member_2[_e153];
                            let _e166 = atomicLoad((&stamps.member[(_e163 + _e123.y)]));
                            let _e169 = params.member.member_1.member_1;
                            if (_e166 == 0u) {
                                phi_342_ = false;
                            } else {
                                phi_342_ = (_e166 < _e169);
                            }
                            let _e173 = phi_342_;
                            phi_343_ = _e173;
                        }
                        let _e175 = phi_343_;
                        if _e175 {
                            let _e178 = params.member.member_2.member_1;
                            let _e183 = params.member.member.member[_e178];
                            if ((_e123.x + 1u) >= _e183) {
                                let _e231 = params.member.member_2.member_1;
                                let _e235 = params.member.member.member[_e231];
                                let _e242 = params.member.member_2.member[0u][_e231];
                                let _e245 = block_nodes.member[(_e242 + (_e123.x - (_e235 - 1u)))];
                                let _e264 = ((_e245.member.x * 0.5f) + (_e245.member_1.y * 0.5f));
                                let _e265 = ((_e245.member.y * 0.5f) + (_e245.member_2.x * 0.5f));
                                let _e266 = ((_e245.member_1.x * 0.5f) + (_e245.member_2.y * 0.5f));
                                if (_e264 < _e245.member_1.y) {
                                    phi_418_ = _e264;
                                } else {
                                    phi_418_ = _e245.member_1.y;
                                }
                                let _e269 = phi_418_;
                                if (_e265 < _e245.member_2.x) {
                                    phi_423_ = _e265;
                                } else {
                                    phi_423_ = _e245.member_2.x;
                                }
                                let _e272 = phi_423_;
                                if (_e266 < _e245.member_2.y) {
                                    phi_428_ = _e266;
                                } else {
                                    phi_428_ = _e245.member_2.y;
                                }
                                let _e275 = phi_428_;
                                if (_e269 > _e245.member.x) {
                                    phi_433_ = _e269;
                                } else {
                                    phi_433_ = _e245.member.x;
                                }
                                let _e278 = phi_433_;
                                if (_e272 > _e245.member.y) {
                                    phi_438_ = _e272;
                                } else {
                                    phi_438_ = _e245.member.y;
                                }
                                let _e281 = phi_438_;
                                if (_e275 > _e245.member_1.x) {
                                    phi_443_ = _e275;
                                } else {
                                    phi_443_ = _e245.member_1.x;
                                }
                                let _e284 = phi_443_;
                                let _e286 = (_e245.member_1.y - _e278);
                                let _e287 = (_e245.member_2.x - _e281);
                                let _e288 = (_e245.member_2.y - _e284);
                                let _e289 = (_e278 - _e245.member.x);
                                let _e290 = (_e281 - _e245.member.y);
                                let _e291 = (_e284 - _e245.member_1.x);
                                if (_e286 > _e289) {
                                    phi_455_ = _e286;
                                } else {
                                    phi_455_ = _e289;
                                }
                                let _e294 = phi_455_;
                                if (_e287 > _e290) {
                                    phi_460_ = _e287;
                                } else {
                                    phi_460_ = _e290;
                                }
                                let _e297 = phi_460_;
                                if (_e288 > _e291) {
                                    phi_465_ = _e288;
                                } else {
                                    phi_465_ = _e291;
                                }
                                let _e300 = phi_465_;
                                let _e302 = (1f + (0.000000059604645f * 4f));
                                let _e306 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_522_ = type_33(array<f32, 3>(_e278, _e281, _e284), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e294 * _e302) + _e306), ((_e297 * _e302) + _e306), ((_e300 * _e302) + _e306)));
                            } else {
                                let _e188 = params.member.member.member_2[_e178];
                                let _e191 = oriented.member[(_e188 + _e123.x)];
                                phi_522_ = type_33(array<f32, 3>(_e191.member.x, _e191.member.y, _e191.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e191.member.w, _e191.member_1.x, _e191.member_1.y), array<f32, 3>(_e191.member_1.z, _e191.member_1.w, _e191.member_2.x), array<f32, 3>(_e191.member_2.y, _e191.member_2.z, _e191.member_2.w)), array<f32, 3>(_e191.member_3.x, _e191.member_3.y, _e191.member_3.z));
                            }
                            let _e313 = phi_522_;
                            let _e316 = params.member.member_2.member_1;
                            let _e321 = params.member.member.member[_e316];
                            if ((_e123.y + 1u) >= _e321) {
                                let _e369 = params.member.member_2.member_1;
                                let _e373 = params.member.member.member[_e369];
                                let _e380 = params.member.member_2.member[0u][_e369];
                                let _e383 = block_nodes.member[(_e380 + (_e123.y - (_e373 - 1u)))];
                                let _e402 = ((_e383.member.x * 0.5f) + (_e383.member_1.y * 0.5f));
                                let _e403 = ((_e383.member.y * 0.5f) + (_e383.member_2.x * 0.5f));
                                let _e404 = ((_e383.member_1.x * 0.5f) + (_e383.member_2.y * 0.5f));
                                if (_e402 < _e383.member_1.y) {
                                    phi_594_ = _e402;
                                } else {
                                    phi_594_ = _e383.member_1.y;
                                }
                                let _e407 = phi_594_;
                                if (_e403 < _e383.member_2.x) {
                                    phi_599_ = _e403;
                                } else {
                                    phi_599_ = _e383.member_2.x;
                                }
                                let _e410 = phi_599_;
                                if (_e404 < _e383.member_2.y) {
                                    phi_604_ = _e404;
                                } else {
                                    phi_604_ = _e383.member_2.y;
                                }
                                let _e413 = phi_604_;
                                if (_e407 > _e383.member.x) {
                                    phi_609_ = _e407;
                                } else {
                                    phi_609_ = _e383.member.x;
                                }
                                let _e416 = phi_609_;
                                if (_e410 > _e383.member.y) {
                                    phi_614_ = _e410;
                                } else {
                                    phi_614_ = _e383.member.y;
                                }
                                let _e419 = phi_614_;
                                if (_e413 > _e383.member_1.x) {
                                    phi_619_ = _e413;
                                } else {
                                    phi_619_ = _e383.member_1.x;
                                }
                                let _e422 = phi_619_;
                                let _e424 = (_e383.member_1.y - _e416);
                                let _e425 = (_e383.member_2.x - _e419);
                                let _e426 = (_e383.member_2.y - _e422);
                                let _e427 = (_e416 - _e383.member.x);
                                let _e428 = (_e419 - _e383.member.y);
                                let _e429 = (_e422 - _e383.member_1.x);
                                if (_e424 > _e427) {
                                    phi_631_ = _e424;
                                } else {
                                    phi_631_ = _e427;
                                }
                                let _e432 = phi_631_;
                                if (_e425 > _e428) {
                                    phi_636_ = _e425;
                                } else {
                                    phi_636_ = _e428;
                                }
                                let _e435 = phi_636_;
                                if (_e426 > _e429) {
                                    phi_641_ = _e426;
                                } else {
                                    phi_641_ = _e429;
                                }
                                let _e438 = phi_641_;
                                let _e440 = (1f + (0.000000059604645f * 4f));
                                let _e444 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_698_ = type_33(array<f32, 3>(_e416, _e419, _e422), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e432 * _e440) + _e444), ((_e435 * _e440) + _e444), ((_e438 * _e440) + _e444)));
                            } else {
                                let _e326 = params.member.member.member_2[_e316];
                                let _e329 = oriented.member[(_e326 + _e123.y)];
                                phi_698_ = type_33(array<f32, 3>(_e329.member.x, _e329.member.y, _e329.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e329.member.w, _e329.member_1.x, _e329.member_1.y), array<f32, 3>(_e329.member_1.z, _e329.member_1.w, _e329.member_2.x), array<f32, 3>(_e329.member_2.y, _e329.member_2.z, _e329.member_2.w)), array<f32, 3>(_e329.member_3.x, _e329.member_3.y, _e329.member_3.z));
                            }
                            let _e451 = phi_698_;
                            let _e456 = (_e451.member[0] - _e313.member[0]);
                            let _e459 = (_e451.member[1] - _e313.member[1]);
                            let _e462 = (_e451.member[2] - _e313.member[2]);
                            if (_e456 < 0f) {
                                phi_715_ = -(_e456);
                            } else {
                                phi_715_ = _e456;
                            }
                            let _e466 = phi_715_;
                            if (_e459 < 0f) {
                                phi_721_ = -(_e459);
                            } else {
                                phi_721_ = _e459;
                            }
                            let _e470 = phi_721_;
                            if (_e466 > _e470) {
                                phi_726_ = _e466;
                            } else {
                                phi_726_ = _e470;
                            }
                            let _e473 = phi_726_;
                            if (_e462 < 0f) {
                                phi_732_ = -(_e462);
                            } else {
                                phi_732_ = _e462;
                            }
                            let _e477 = phi_732_;
                            if (_e473 > _e477) {
                                phi_737_ = _e473;
                            } else {
                                phi_737_ = _e477;
                            }
                            let _e480 = phi_737_;
                            if (_e313.member_2[0] < 0f) {
                                phi_745_ = -(_e313.member_2[0]);
                            } else {
                                phi_745_ = _e313.member_2[0];
                            }
                            let _e486 = phi_745_;
                            if (_e313.member_2[1] < 0f) {
                                phi_752_ = -(_e313.member_2[1]);
                            } else {
                                phi_752_ = _e313.member_2[1];
                            }
                            let _e491 = phi_752_;
                            if (_e486 > _e491) {
                                phi_757_ = _e486;
                            } else {
                                phi_757_ = _e491;
                            }
                            let _e494 = phi_757_;
                            if (_e313.member_2[2] < 0f) {
                                phi_764_ = -(_e313.member_2[2]);
                            } else {
                                phi_764_ = _e313.member_2[2];
                            }
                            let _e499 = phi_764_;
                            if (_e494 > _e499) {
                                phi_769_ = _e494;
                            } else {
                                phi_769_ = _e499;
                            }
                            let _e502 = phi_769_;
                            if (_e480 > _e502) {
                                phi_774_ = _e480;
                            } else {
                                phi_774_ = _e502;
                            }
                            let _e505 = phi_774_;
                            if (_e451.member_2[0] < 0f) {
                                phi_782_ = -(_e451.member_2[0]);
                            } else {
                                phi_782_ = _e451.member_2[0];
                            }
                            let _e511 = phi_782_;
                            if (_e451.member_2[1] < 0f) {
                                phi_789_ = -(_e451.member_2[1]);
                            } else {
                                phi_789_ = _e451.member_2[1];
                            }
                            let _e516 = phi_789_;
                            if (_e511 > _e516) {
                                phi_794_ = _e511;
                            } else {
                                phi_794_ = _e516;
                            }
                            let _e519 = phi_794_;
                            if (_e451.member_2[2] < 0f) {
                                phi_801_ = -(_e451.member_2[2]);
                            } else {
                                phi_801_ = _e451.member_2[2];
                            }
                            let _e524 = phi_801_;
                            if (_e519 > _e524) {
                                phi_806_ = _e519;
                            } else {
                                phi_806_ = _e524;
                            }
                            let _e527 = phi_806_;
                            if (_e505 > _e527) {
                                phi_811_ = _e505;
                            } else {
                                phi_811_ = _e527;
                            }
                            let _e530 = phi_811_;
                            if (_e530 > 0.000000000000000000000000000000000000011754944f) {
                                if ((bitcast<u32>(_e530) & 2139095040u) != 2139095040u) {
                                    let _e537 = (2130706432u - (bitcast<u32>(_e530) & 2139095040u));
                                    if (_e537 > 8388608u) {
                                        phi_832_ = _e537;
                                    } else {
                                        phi_832_ = 8388608u;
                                    }
                                    let _e540 = phi_832_;
                                    phi_834_ = bitcast<f32>(_e540);
                                    phi_835_ = false;
                                } else {
                                    phi_834_ = f32();
                                    phi_835_ = true;
                                }
                                let _e543 = phi_834_;
                                let _e545 = phi_835_;
                                phi_836_ = _e543;
                                phi_837_ = _e545;
                            } else {
                                phi_836_ = f32();
                                phi_837_ = true;
                            }
                            let _e547 = phi_836_;
                            let _e549 = phi_837_;
                            if _e549 {
                                phi_841_ = 0f;
                            } else {
                                phi_841_ = _e547;
                            }
                            let _e551 = phi_841_;
                            let _e552 = (_e456 * _e551);
                            let _e553 = (_e459 * _e551);
                            let _e554 = (_e462 * _e551);
                            let _e555 = (_e552 * 0.5f);
                            let _e556 = (_e553 * 0.5f);
                            let _e574 = (_e313.member_2[0] * _e551);
                            let _e576 = (_e313.member_1[0][0] * _e574);
                            let _e578 = (_e313.member_1[0][1] * _e574);
                            let _e580 = (_e313.member_1[0][2] * _e574);
                            let _e581 = (_e576 * 1f);
                            let _e582 = (_e578 * 1f);
                            let _e600 = (_e313.member_2[1] * _e551);
                            let _e602 = (_e313.member_1[1][0] * _e600);
                            let _e604 = (_e313.member_1[1][1] * _e600);
                            let _e606 = (_e313.member_1[1][2] * _e600);
                            let _e607 = (_e602 * 1f);
                            let _e608 = (_e604 * 1f);
                            let _e626 = (_e313.member_2[2] * _e551);
                            let _e628 = (_e313.member_1[2][0] * _e626);
                            let _e630 = (_e313.member_1[2][1] * _e626);
                            let _e632 = (_e313.member_1[2][2] * _e626);
                            let _e633 = (_e628 * 1f);
                            let _e634 = (_e630 * 1f);
                            let _e652 = (_e451.member_2[0] * _e551);
                            let _e654 = (_e451.member_1[0][0] * _e652);
                            let _e656 = (_e451.member_1[0][1] * _e652);
                            let _e658 = (_e451.member_1[0][2] * _e652);
                            let _e659 = (_e654 * 1f);
                            let _e660 = (_e656 * 1f);
                            let _e678 = (_e451.member_2[1] * _e551);
                            let _e680 = (_e451.member_1[1][0] * _e678);
                            let _e682 = (_e451.member_1[1][1] * _e678);
                            let _e684 = (_e451.member_1[1][2] * _e678);
                            let _e685 = (_e680 * 1f);
                            let _e686 = (_e682 * 1f);
                            let _e704 = (_e451.member_2[2] * _e551);
                            let _e706 = (_e451.member_1[2][0] * _e704);
                            let _e708 = (_e451.member_1[2][1] * _e704);
                            let _e710 = (_e451.member_1[2][2] * _e704);
                            let _e711 = (_e706 * 1f);
                            let _e712 = (_e708 * 1f);
                            let _e717 = (((((((0f + (_e552 * _e555)) + (_e576 * _e581)) + (_e602 * _e607)) + (_e628 * _e633)) + (_e654 * _e659)) + (_e680 * _e685)) + (_e706 * _e711));
                            let _e718 = (((((((0f + (_e553 * _e555)) + (_e578 * _e581)) + (_e604 * _e607)) + (_e630 * _e633)) + (_e656 * _e659)) + (_e682 * _e685)) + (_e708 * _e711));
                            let _e719 = (((((((0f + (_e554 * _e555)) + (_e580 * _e581)) + (_e606 * _e607)) + (_e632 * _e633)) + (_e658 * _e659)) + (_e684 * _e685)) + (_e710 * _e711));
                            let _e721 = (((((((0f + (_e556 * _e553)) + (_e582 * _e578)) + (_e608 * _e604)) + (_e634 * _e630)) + (_e660 * _e656)) + (_e686 * _e682)) + (_e712 * _e708));
                            let _e723 = (((((((0f + (_e556 * _e554)) + (_e582 * _e580)) + (_e608 * _e606)) + (_e634 * _e632)) + (_e660 * _e658)) + (_e686 * _e684)) + (_e712 * _e710));
                            let _e725 = (((((((0f + ((_e554 * 0.5f) * _e554)) + ((_e580 * 1f) * _e580)) + ((_e606 * 1f) * _e606)) + ((_e632 * 1f) * _e632)) + ((_e658 * 1f) * _e658)) + ((_e684 * 1f) * _e684)) + ((_e710 * 1f) * _e710));
                            if (_e717 < 0f) {
                                phi_1108_ = -(_e717);
                            } else {
                                phi_1108_ = _e717;
                            }
                            let _e729 = phi_1108_;
                            if (_e718 < 0f) {
                                phi_1115_ = -(_e718);
                            } else {
                                phi_1115_ = _e718;
                            }
                            let _e733 = phi_1115_;
                            if (_e729 > _e733) {
                                phi_1120_ = _e729;
                            } else {
                                phi_1120_ = _e733;
                            }
                            let _e736 = phi_1120_;
                            if (_e719 < 0f) {
                                phi_1127_ = -(_e719);
                            } else {
                                phi_1127_ = _e719;
                            }
                            let _e740 = phi_1127_;
                            if (_e736 > _e740) {
                                phi_1132_ = _e736;
                            } else {
                                phi_1132_ = _e740;
                            }
                            let _e743 = phi_1132_;
                            if (_e721 < 0f) {
                                phi_1141_ = -(_e721);
                            } else {
                                phi_1141_ = _e721;
                            }
                            let _e747 = phi_1141_;
                            if (_e723 < 0f) {
                                phi_1147_ = -(_e723);
                            } else {
                                phi_1147_ = _e723;
                            }
                            let _e751 = phi_1147_;
                            if (_e747 > _e751) {
                                phi_1152_ = _e747;
                            } else {
                                phi_1152_ = _e751;
                            }
                            let _e754 = phi_1152_;
                            if (_e725 < 0f) {
                                phi_1158_ = -(_e725);
                            } else {
                                phi_1158_ = _e725;
                            }
                            let _e758 = phi_1158_;
                            if (_e754 > _e758) {
                                phi_1163_ = _e754;
                            } else {
                                phi_1163_ = _e758;
                            }
                            let _e761 = phi_1163_;
                            if (_e743 > _e761) {
                                phi_1168_ = _e743;
                            } else {
                                phi_1168_ = _e761;
                            }
                            let _e764 = phi_1168_;
                            if (_e764 > 0.000000000000000000000000000000000000011754944f) {
                                if ((bitcast<u32>(_e764) & 2139095040u) != 2139095040u) {
                                    let _e771 = (2130706432u - (bitcast<u32>(_e764) & 2139095040u));
                                    if (_e771 > 8388608u) {
                                        phi_1189_ = _e771;
                                    } else {
                                        phi_1189_ = 8388608u;
                                    }
                                    let _e774 = phi_1189_;
                                    let _e775 = bitcast<f32>(_e774);
                                    let _e777 = (_e718 * _e775);
                                    let _e778 = (_e719 * _e775);
                                    let _e779 = (_e721 * _e775);
                                    let _e780 = (_e723 * _e775);
                                    let _e781 = (_e725 * _e775);
                                    let _e784 = ((_e777 * _e777) + (_e778 * _e778));
                                    if (_e784 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                        if (_e784 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e784 > 0f) {
                                                phi_1227_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1227_ = 0f;
                                            }
                                            let _e841 = phi_1227_;
                                            phi_1291_ = _e841;
                                        } else {
                                            phi_1234_ = type_14(0i, 5i);
                                            phi_1237_ = bitcast<f32>(((bitcast<u32>(_e784) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e796 = phi_1234_;
                                                let _e798 = phi_1237_;
                                                local = _e798;
                                                if (_e796.member < _e796.member_1) {
                                                    let _e805 = (_e796.member + 1i);
                                                    if ((false == (_e805 > _e796.member)) != false) {
                                                        phi_1258_ = true;
                                                    } else {
                                                        phi_1258_ = false;
                                                    }
                                                    let _e810 = phi_1258_;
                                                    if _e810 {
                                                        phi_1264_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1264_ = type_15(1u, _e805);
                                                    }
                                                    let _e815 = phi_1264_;
                                                    phi_1235_ = type_14(_e815.member_1, _e796.member_1);
                                                    phi_1278_ = type_15(1u, _e796.member);
                                                } else {
                                                    phi_1235_ = _e796;
                                                    phi_1278_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e821 = phi_1235_;
                                                let _e823 = phi_1278_;
                                                let _e826 = (bitcast<i32>(_e823.member) != 0i);
                                                if _e826 {
                                                    phi_1238_ = (0.5f * (_e798 + (_e784 / _e798)));
                                                } else {
                                                    phi_1238_ = f32();
                                                }
                                                let _e831 = phi_1238_;
                                                continue;
                                                continuing {
                                                    phi_1234_ = _e821;
                                                    phi_1237_ = _e831;
                                                    break if !(_e826);
                                                }
                                            }
                                            let _e836 = local;
                                            phi_1291_ = (_e836 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e843 = phi_1291_;
                                        let _e844 = (_e777 / _e843);
                                        let _e845 = (_e778 / _e843);
                                        let _e850 = (1.5f - (((_e844 * _e844) + (_e845 * _e845)) * 0.5f));
                                        phi_1303_ = type_34((_e844 * _e850), (_e845 * _e850));
                                    } else {
                                        phi_1303_ = type_34(1f, 0f);
                                    }
                                    let _e855 = phi_1303_;
                                    let _e860 = (((_e855.member * _e855.member_1) * _e780) * 2f);
                                    phi_1342_ = type_9(0u, 16u);
                                    phi_1345_ = type_36(array<f32, 2>(((_e855.member * _e777) + (_e855.member_1 * _e778)), (((_e855.member * _e855.member_1) * (_e779 - _e781)) + (((_e855.member_1 * _e855.member_1) - (_e855.member * _e855.member)) * _e780))), array<f32, 3>((_e717 * _e775), ((((_e855.member * _e855.member) * _e779) + _e860) + ((_e855.member_1 * _e855.member_1) * _e781)), ((((_e855.member_1 * _e855.member_1) * _e779) - _e860) + ((_e855.member * _e855.member) * _e781))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e855.member, _e855.member_1), array<f32, 3>(0f, _e855.member_1, -(_e855.member))));
                                    loop {
                                        let _e892 = phi_1342_;
                                        let _e894 = phi_1345_;
                                        local_10 = _e894;
                                        if (_e892.member < _e892.member_1) {
                                            phi_1343_ = type_9((_e892.member + 1u), _e892.member_1);
                                            phi_1368_ = type_9(1u, _e892.member);
                                        } else {
                                            phi_1343_ = _e892;
                                            phi_1368_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e906 = phi_1343_;
                                        let _e908 = phi_1368_;
                                        if (bitcast<i32>(_e908.member) != 0i) {
                                            let _e912 = (0.000000059604645f * 0.5f);
                                            if (_e894.member[0] < 0f) {
                                                phi_1388_ = -(_e894.member[0]);
                                            } else {
                                                phi_1388_ = _e894.member[0];
                                            }
                                            let _e923 = phi_1388_;
                                            let _e924 = (_e923 > _e912);
                                            if (_e894.member[1] < 0f) {
                                                phi_1395_ = -(_e894.member[1]);
                                            } else {
                                                phi_1395_ = _e894.member[1];
                                            }
                                            let _e928 = phi_1395_;
                                            let _e929 = (_e928 > _e912);
                                            if _e924 {
                                                if _e929 {
                                                    let _e932 = ((_e894.member_1[1] - _e894.member_1[0]) / (_e894.member[0] * 2f));
                                                    let _e934 = ((_e932 * _e932) + 1f);
                                                    if (_e934 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e934 > 0f) {
                                                            phi_1421_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_1421_ = 0f;
                                                        }
                                                        let _e987 = phi_1421_;
                                                        phi_1485_ = _e987;
                                                    } else {
                                                        phi_1428_ = type_14(0i, 5i);
                                                        phi_1431_ = bitcast<f32>(((bitcast<u32>(_e934) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e942 = phi_1428_;
                                                            let _e944 = phi_1431_;
                                                            local_1 = _e944;
                                                            if (_e942.member < _e942.member_1) {
                                                                let _e951 = (_e942.member + 1i);
                                                                if ((false == (_e951 > _e942.member)) != false) {
                                                                    phi_1452_ = true;
                                                                } else {
                                                                    phi_1452_ = false;
                                                                }
                                                                let _e956 = phi_1452_;
                                                                if _e956 {
                                                                    phi_1458_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_1458_ = type_15(1u, _e951);
                                                                }
                                                                let _e961 = phi_1458_;
                                                                phi_1429_ = type_14(_e961.member_1, _e942.member_1);
                                                                phi_1472_ = type_15(1u, _e942.member);
                                                            } else {
                                                                phi_1429_ = _e942;
                                                                phi_1472_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e967 = phi_1429_;
                                                            let _e969 = phi_1472_;
                                                            let _e972 = (bitcast<i32>(_e969.member) != 0i);
                                                            if _e972 {
                                                                phi_1432_ = (0.5f * (_e944 + (_e934 / _e944)));
                                                            } else {
                                                                phi_1432_ = f32();
                                                            }
                                                            let _e977 = phi_1432_;
                                                            continue;
                                                            continuing {
                                                                phi_1428_ = _e967;
                                                                phi_1431_ = _e977;
                                                                break if !(_e972);
                                                            }
                                                        }
                                                        let _e982 = local_1;
                                                        phi_1485_ = (_e982 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e989 = phi_1485_;
                                                    if (_e932 > 0f) {
                                                        phi_1492_ = (_e932 + _e989);
                                                    } else {
                                                        phi_1492_ = (_e932 - _e989);
                                                    }
                                                    let _e994 = phi_1492_;
                                                    let _e997 = (_e894.member_1[2] - (_e894.member_1[0] - (_e894.member[0] / _e994)));
                                                    let _e1000 = ((_e997 * _e997) + (_e894.member[1] * _e894.member[1]));
                                                    if (_e1000 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1000 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1000 > 0f) {
                                                                phi_1519_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1519_ = 0f;
                                                            }
                                                            let _e1057 = phi_1519_;
                                                            phi_1583_ = _e1057;
                                                        } else {
                                                            phi_1526_ = type_14(0i, 5i);
                                                            phi_1529_ = bitcast<f32>(((bitcast<u32>(_e1000) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1012 = phi_1526_;
                                                                let _e1014 = phi_1529_;
                                                                local_2 = _e1014;
                                                                if (_e1012.member < _e1012.member_1) {
                                                                    let _e1021 = (_e1012.member + 1i);
                                                                    if ((false == (_e1021 > _e1012.member)) != false) {
                                                                        phi_1550_ = true;
                                                                    } else {
                                                                        phi_1550_ = false;
                                                                    }
                                                                    let _e1026 = phi_1550_;
                                                                    if _e1026 {
                                                                        phi_1556_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1556_ = type_15(1u, _e1021);
                                                                    }
                                                                    let _e1031 = phi_1556_;
                                                                    phi_1527_ = type_14(_e1031.member_1, _e1012.member_1);
                                                                    phi_1570_ = type_15(1u, _e1012.member);
                                                                } else {
                                                                    phi_1527_ = _e1012;
                                                                    phi_1570_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1037 = phi_1527_;
                                                                let _e1039 = phi_1570_;
                                                                let _e1042 = (bitcast<i32>(_e1039.member) != 0i);
                                                                if _e1042 {
                                                                    phi_1530_ = (0.5f * (_e1014 + (_e1000 / _e1014)));
                                                                } else {
                                                                    phi_1530_ = f32();
                                                                }
                                                                let _e1047 = phi_1530_;
                                                                continue;
                                                                continuing {
                                                                    phi_1526_ = _e1037;
                                                                    phi_1529_ = _e1047;
                                                                    break if !(_e1042);
                                                                }
                                                            }
                                                            let _e1052 = local_2;
                                                            phi_1583_ = (_e1052 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1059 = phi_1583_;
                                                        let _e1060 = (_e997 / _e1059);
                                                        let _e1061 = (_e894.member[1] / _e1059);
                                                        let _e1066 = (1.5f - (((_e1060 * _e1060) + (_e1061 * _e1061)) * 0.5f));
                                                        phi_1595_ = type_34((_e1060 * _e1066), (_e1061 * _e1066));
                                                    } else {
                                                        phi_1595_ = type_34(1f, 0f);
                                                    }
                                                    let _e1071 = phi_1595_;
                                                    let _e1088 = (((_e894.member_1[1] - _e894.member_1[2]) * _e1071.member_1) + ((_e1071.member * _e894.member[1]) * 2f));
                                                    let _e1090 = (_e894.member_1[1] - (_e1071.member_1 * _e1088));
                                                    let _e1094 = ((_e1071.member * _e1088) - _e894.member[1]);
                                                    let _e1107 = ((_e894.member_2[1][0] * _e1071.member) - (_e894.member_2[2][0] * _e1071.member_1));
                                                    let _e1108 = ((_e894.member_2[1][1] * _e1071.member) - (_e894.member_2[2][1] * _e1071.member_1));
                                                    let _e1109 = ((_e894.member_2[1][2] * _e1071.member) - (_e894.member_2[2][2] * _e1071.member_1));
                                                    let _e1126 = (_e1071.member * _e894.member[0]);
                                                    let _e1127 = (_e1071.member_1 * _e894.member[0]);
                                                    let _e1130 = ((_e1094 * _e1094) + (_e1127 * _e1127));
                                                    if (_e1130 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1130 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1130 > 0f) {
                                                                phi_1684_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1684_ = 0f;
                                                            }
                                                            let _e1187 = phi_1684_;
                                                            phi_1748_ = _e1187;
                                                        } else {
                                                            phi_1691_ = type_14(0i, 5i);
                                                            phi_1694_ = bitcast<f32>(((bitcast<u32>(_e1130) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1142 = phi_1691_;
                                                                let _e1144 = phi_1694_;
                                                                local_3 = _e1144;
                                                                if (_e1142.member < _e1142.member_1) {
                                                                    let _e1151 = (_e1142.member + 1i);
                                                                    if ((false == (_e1151 > _e1142.member)) != false) {
                                                                        phi_1715_ = true;
                                                                    } else {
                                                                        phi_1715_ = false;
                                                                    }
                                                                    let _e1156 = phi_1715_;
                                                                    if _e1156 {
                                                                        phi_1721_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1721_ = type_15(1u, _e1151);
                                                                    }
                                                                    let _e1161 = phi_1721_;
                                                                    phi_1692_ = type_14(_e1161.member_1, _e1142.member_1);
                                                                    phi_1735_ = type_15(1u, _e1142.member);
                                                                } else {
                                                                    phi_1692_ = _e1142;
                                                                    phi_1735_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1167 = phi_1692_;
                                                                let _e1169 = phi_1735_;
                                                                let _e1172 = (bitcast<i32>(_e1169.member) != 0i);
                                                                if _e1172 {
                                                                    phi_1695_ = (0.5f * (_e1144 + (_e1130 / _e1144)));
                                                                } else {
                                                                    phi_1695_ = f32();
                                                                }
                                                                let _e1177 = phi_1695_;
                                                                continue;
                                                                continuing {
                                                                    phi_1691_ = _e1167;
                                                                    phi_1694_ = _e1177;
                                                                    break if !(_e1172);
                                                                }
                                                            }
                                                            let _e1182 = local_3;
                                                            phi_1748_ = (_e1182 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1189 = phi_1748_;
                                                        let _e1190 = (_e1094 / _e1189);
                                                        let _e1191 = (_e1127 / _e1189);
                                                        let _e1196 = (1.5f - (((_e1190 * _e1190) + (_e1191 * _e1191)) * 0.5f));
                                                        phi_1760_ = type_34((_e1190 * _e1196), (_e1191 * _e1196));
                                                    } else {
                                                        phi_1760_ = type_34(1f, 0f);
                                                    }
                                                    let _e1201 = phi_1760_;
                                                    let _e1211 = (((_e894.member_1[0] - _e1090) * _e1201.member_1) + ((_e1201.member * _e1126) * 2f));
                                                    phi_1827_ = type_36(array<f32, 2>(((_e1201.member * _e1211) - _e1126), ((_e1201.member_1 * _e1127) + (_e1201.member * _e1094))), array<f32, 3>((_e894.member_1[0] - (_e1201.member_1 * _e1211)), (_e1090 + (_e1201.member_1 * _e1211)), (_e894.member_1[2] + (_e1071.member_1 * _e1088))), array<array<f32, 3>, 3>(array<f32, 3>(((_e894.member_2[0][0] * _e1201.member) - (_e1107 * _e1201.member_1)), ((_e894.member_2[0][1] * _e1201.member) - (_e1108 * _e1201.member_1)), ((_e894.member_2[0][2] * _e1201.member) - (_e1109 * _e1201.member_1))), array<f32, 3>(((_e894.member_2[0][0] * _e1201.member_1) + (_e1107 * _e1201.member)), ((_e894.member_2[0][1] * _e1201.member_1) + (_e1108 * _e1201.member)), ((_e894.member_2[0][2] * _e1201.member_1) + (_e1109 * _e1201.member))), array<f32, 3>(((_e894.member_2[1][0] * _e1071.member_1) + (_e894.member_2[2][0] * _e1071.member)), ((_e894.member_2[1][1] * _e1071.member_1) + (_e894.member_2[2][1] * _e1071.member)), ((_e894.member_2[1][2] * _e1071.member_1) + (_e894.member_2[2][2] * _e1071.member)))));
                                                    phi_1828_ = false;
                                                } else {
                                                    phi_1827_ = type_36();
                                                    phi_1828_ = true;
                                                }
                                                let _e1249 = phi_1827_;
                                                let _e1251 = phi_1828_;
                                                phi_1829_ = _e1249;
                                                phi_1830_ = _e1251;
                                            } else {
                                                phi_1829_ = type_36();
                                                phi_1830_ = true;
                                            }
                                            let _e1253 = phi_1829_;
                                            let _e1255 = phi_1830_;
                                            if _e1255 {
                                                if _e924 {
                                                    let _e1499 = ((_e894.member_1[1] - _e894.member_1[0]) / (_e894.member[0] * 2f));
                                                    let _e1501 = ((_e1499 * _e1499) + 1f);
                                                    if (_e1501 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e1501 > 0f) {
                                                            phi_1855_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_1855_ = 0f;
                                                        }
                                                        let _e1554 = phi_1855_;
                                                        phi_1919_ = _e1554;
                                                    } else {
                                                        phi_1862_ = type_14(0i, 5i);
                                                        phi_1865_ = bitcast<f32>(((bitcast<u32>(_e1501) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1509 = phi_1862_;
                                                            let _e1511 = phi_1865_;
                                                            local_6 = _e1511;
                                                            if (_e1509.member < _e1509.member_1) {
                                                                let _e1518 = (_e1509.member + 1i);
                                                                if ((false == (_e1518 > _e1509.member)) != false) {
                                                                    phi_1886_ = true;
                                                                } else {
                                                                    phi_1886_ = false;
                                                                }
                                                                let _e1523 = phi_1886_;
                                                                if _e1523 {
                                                                    phi_1892_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_1892_ = type_15(1u, _e1518);
                                                                }
                                                                let _e1528 = phi_1892_;
                                                                phi_1863_ = type_14(_e1528.member_1, _e1509.member_1);
                                                                phi_1906_ = type_15(1u, _e1509.member);
                                                            } else {
                                                                phi_1863_ = _e1509;
                                                                phi_1906_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e1534 = phi_1863_;
                                                            let _e1536 = phi_1906_;
                                                            let _e1539 = (bitcast<i32>(_e1536.member) != 0i);
                                                            if _e1539 {
                                                                phi_1866_ = (0.5f * (_e1511 + (_e1501 / _e1511)));
                                                            } else {
                                                                phi_1866_ = f32();
                                                            }
                                                            let _e1544 = phi_1866_;
                                                            continue;
                                                            continuing {
                                                                phi_1862_ = _e1534;
                                                                phi_1865_ = _e1544;
                                                                break if !(_e1539);
                                                            }
                                                        }
                                                        let _e1549 = local_6;
                                                        phi_1919_ = (_e1549 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1556 = phi_1919_;
                                                    if (_e1499 > 0f) {
                                                        phi_1926_ = (_e1499 + _e1556);
                                                    } else {
                                                        phi_1926_ = (_e1499 - _e1556);
                                                    }
                                                    let _e1561 = phi_1926_;
                                                    let _e1564 = (_e894.member_1[1] - (_e894.member_1[0] - (_e894.member[0] / _e1561)));
                                                    let _e1567 = ((_e1564 * _e1564) + (_e894.member[0] * _e894.member[0]));
                                                    if (_e1567 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1567 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1567 > 0f) {
                                                                phi_1953_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1953_ = 0f;
                                                            }
                                                            let _e1624 = phi_1953_;
                                                            phi_2017_ = _e1624;
                                                        } else {
                                                            phi_1960_ = type_14(0i, 5i);
                                                            phi_1963_ = bitcast<f32>(((bitcast<u32>(_e1567) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1579 = phi_1960_;
                                                                let _e1581 = phi_1963_;
                                                                local_7 = _e1581;
                                                                if (_e1579.member < _e1579.member_1) {
                                                                    let _e1588 = (_e1579.member + 1i);
                                                                    if ((false == (_e1588 > _e1579.member)) != false) {
                                                                        phi_1984_ = true;
                                                                    } else {
                                                                        phi_1984_ = false;
                                                                    }
                                                                    let _e1593 = phi_1984_;
                                                                    if _e1593 {
                                                                        phi_1990_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1990_ = type_15(1u, _e1588);
                                                                    }
                                                                    let _e1598 = phi_1990_;
                                                                    phi_1961_ = type_14(_e1598.member_1, _e1579.member_1);
                                                                    phi_2004_ = type_15(1u, _e1579.member);
                                                                } else {
                                                                    phi_1961_ = _e1579;
                                                                    phi_2004_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1604 = phi_1961_;
                                                                let _e1606 = phi_2004_;
                                                                let _e1609 = (bitcast<i32>(_e1606.member) != 0i);
                                                                if _e1609 {
                                                                    phi_1964_ = (0.5f * (_e1581 + (_e1567 / _e1581)));
                                                                } else {
                                                                    phi_1964_ = f32();
                                                                }
                                                                let _e1614 = phi_1964_;
                                                                continue;
                                                                continuing {
                                                                    phi_1960_ = _e1604;
                                                                    phi_1963_ = _e1614;
                                                                    break if !(_e1609);
                                                                }
                                                            }
                                                            let _e1619 = local_7;
                                                            phi_2017_ = (_e1619 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1626 = phi_2017_;
                                                        let _e1627 = (_e1564 / _e1626);
                                                        let _e1628 = (_e894.member[0] / _e1626);
                                                        let _e1633 = (1.5f - (((_e1627 * _e1627) + (_e1628 * _e1628)) * 0.5f));
                                                        phi_2029_ = type_34((_e1627 * _e1633), (_e1628 * _e1633));
                                                    } else {
                                                        phi_2029_ = type_34(1f, 0f);
                                                    }
                                                    let _e1638 = phi_2029_;
                                                    let _e1655 = (((_e894.member_1[0] - _e894.member_1[1]) * _e1638.member_1) + ((_e1638.member * _e894.member[0]) * 2f));
                                                    let _e1657 = (_e894.member_1[0] - (_e1638.member_1 * _e1655));
                                                    let _e1659 = (_e894.member_1[1] + (_e1638.member_1 * _e1655));
                                                    let _e1668 = type_36(_e894.member, array<f32, 3>(_e1657, _e894.member_1[1], _e894.member_1[2]), _e894.member_2);
                                                    let _e1675 = type_36(_e1668.member, array<f32, 3>(_e1668.member_1[0], _e1659, _e1668.member_1[2]), _e1668.member_2);
                                                    let _e1679 = type_36(_e1675.member, array<f32, 3>(_e1657, _e1659, _e894.member_1[2]), _e1675.member_2);
                                                    let _e1685 = type_36(array<f32, 2>(((_e1638.member * _e1655) - _e894.member[0]), _e1679.member[1]), _e1679.member_1, _e1679.member_2);
                                                    let _e1701 = array<f32, 3>(((_e894.member_2[0][0] * _e1638.member) - (_e894.member_2[1][0] * _e1638.member_1)), ((_e894.member_2[0][1] * _e1638.member) - (_e894.member_2[1][1] * _e1638.member_1)), ((_e894.member_2[0][2] * _e1638.member) - (_e894.member_2[1][2] * _e1638.member_1)));
                                                    let _e1717 = array<f32, 3>(((_e894.member_2[0][0] * _e1638.member_1) + (_e894.member_2[1][0] * _e1638.member)), ((_e894.member_2[0][1] * _e1638.member_1) + (_e894.member_2[1][1] * _e1638.member)), ((_e894.member_2[0][2] * _e1638.member_1) + (_e894.member_2[1][2] * _e1638.member)));
                                                    let _e1724 = type_36(_e1685.member, _e1685.member_1, array<array<f32, 3>, 3>(_e1701, _e1685.member_2[1], _e1685.member_2[2]));
                                                    let _e1731 = type_36(_e1724.member, _e1724.member_1, array<array<f32, 3>, 3>(_e1724.member_2[0], _e1717, _e1724.member_2[2]));
                                                    phi_2349_ = type_36(_e1731.member, _e1731.member_1, array<array<f32, 3>, 3>(_e1701, _e1717, _e894.member_2[2]));
                                                } else {
                                                    if _e929 {
                                                        let _e1258 = ((_e894.member_1[2] - _e894.member_1[1]) / (_e894.member[1] * 2f));
                                                        let _e1260 = ((_e1258 * _e1258) + 1f);
                                                        if (_e1260 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1260 > 0f) {
                                                                phi_2112_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_2112_ = 0f;
                                                            }
                                                            let _e1313 = phi_2112_;
                                                            phi_2176_ = _e1313;
                                                        } else {
                                                            phi_2119_ = type_14(0i, 5i);
                                                            phi_2122_ = bitcast<f32>(((bitcast<u32>(_e1260) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1268 = phi_2119_;
                                                                let _e1270 = phi_2122_;
                                                                local_4 = _e1270;
                                                                if (_e1268.member < _e1268.member_1) {
                                                                    let _e1277 = (_e1268.member + 1i);
                                                                    if ((false == (_e1277 > _e1268.member)) != false) {
                                                                        phi_2143_ = true;
                                                                    } else {
                                                                        phi_2143_ = false;
                                                                    }
                                                                    let _e1282 = phi_2143_;
                                                                    if _e1282 {
                                                                        phi_2149_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_2149_ = type_15(1u, _e1277);
                                                                    }
                                                                    let _e1287 = phi_2149_;
                                                                    phi_2120_ = type_14(_e1287.member_1, _e1268.member_1);
                                                                    phi_2163_ = type_15(1u, _e1268.member);
                                                                } else {
                                                                    phi_2120_ = _e1268;
                                                                    phi_2163_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1293 = phi_2120_;
                                                                let _e1295 = phi_2163_;
                                                                let _e1298 = (bitcast<i32>(_e1295.member) != 0i);
                                                                if _e1298 {
                                                                    phi_2123_ = (0.5f * (_e1270 + (_e1260 / _e1270)));
                                                                } else {
                                                                    phi_2123_ = f32();
                                                                }
                                                                let _e1303 = phi_2123_;
                                                                continue;
                                                                continuing {
                                                                    phi_2119_ = _e1293;
                                                                    phi_2122_ = _e1303;
                                                                    break if !(_e1298);
                                                                }
                                                            }
                                                            let _e1308 = local_4;
                                                            phi_2176_ = (_e1308 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1315 = phi_2176_;
                                                        if (_e1258 > 0f) {
                                                            phi_2183_ = (_e1258 + _e1315);
                                                        } else {
                                                            phi_2183_ = (_e1258 - _e1315);
                                                        }
                                                        let _e1320 = phi_2183_;
                                                        let _e1323 = (_e894.member_1[2] - (_e894.member_1[1] - (_e894.member[1] / _e1320)));
                                                        let _e1326 = ((_e1323 * _e1323) + (_e894.member[1] * _e894.member[1]));
                                                        if (_e1326 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                            if (_e1326 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e1326 > 0f) {
                                                                    phi_2210_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_2210_ = 0f;
                                                                }
                                                                let _e1383 = phi_2210_;
                                                                phi_2274_ = _e1383;
                                                            } else {
                                                                phi_2217_ = type_14(0i, 5i);
                                                                phi_2220_ = bitcast<f32>(((bitcast<u32>(_e1326) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e1338 = phi_2217_;
                                                                    let _e1340 = phi_2220_;
                                                                    local_5 = _e1340;
                                                                    if (_e1338.member < _e1338.member_1) {
                                                                        let _e1347 = (_e1338.member + 1i);
                                                                        if ((false == (_e1347 > _e1338.member)) != false) {
                                                                            phi_2241_ = true;
                                                                        } else {
                                                                            phi_2241_ = false;
                                                                        }
                                                                        let _e1352 = phi_2241_;
                                                                        if _e1352 {
                                                                            phi_2247_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_2247_ = type_15(1u, _e1347);
                                                                        }
                                                                        let _e1357 = phi_2247_;
                                                                        phi_2218_ = type_14(_e1357.member_1, _e1338.member_1);
                                                                        phi_2261_ = type_15(1u, _e1338.member);
                                                                    } else {
                                                                        phi_2218_ = _e1338;
                                                                        phi_2261_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e1363 = phi_2218_;
                                                                    let _e1365 = phi_2261_;
                                                                    let _e1368 = (bitcast<i32>(_e1365.member) != 0i);
                                                                    if _e1368 {
                                                                        phi_2221_ = (0.5f * (_e1340 + (_e1326 / _e1340)));
                                                                    } else {
                                                                        phi_2221_ = f32();
                                                                    }
                                                                    let _e1373 = phi_2221_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2217_ = _e1363;
                                                                        phi_2220_ = _e1373;
                                                                        break if !(_e1368);
                                                                    }
                                                                }
                                                                let _e1378 = local_5;
                                                                phi_2274_ = (_e1378 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e1385 = phi_2274_;
                                                            let _e1386 = (_e1323 / _e1385);
                                                            let _e1387 = (_e894.member[1] / _e1385);
                                                            let _e1392 = (1.5f - (((_e1386 * _e1386) + (_e1387 * _e1387)) * 0.5f));
                                                            phi_2286_ = type_34((_e1386 * _e1392), (_e1387 * _e1392));
                                                        } else {
                                                            phi_2286_ = type_34(1f, 0f);
                                                        }
                                                        let _e1397 = phi_2286_;
                                                        let _e1414 = (((_e894.member_1[1] - _e894.member_1[2]) * _e1397.member_1) + ((_e1397.member * _e894.member[1]) * 2f));
                                                        let _e1416 = (_e894.member_1[1] - (_e1397.member_1 * _e1414));
                                                        let _e1427 = type_36(_e894.member, array<f32, 3>(_e894.member_1[0], _e894.member_1[1], _e894.member_1[2]), _e894.member_2);
                                                        let _e1434 = type_36(_e1427.member, array<f32, 3>(_e1427.member_1[0], _e1416, _e1427.member_1[2]), _e1427.member_2);
                                                        let _e1438 = type_36(_e1434.member, array<f32, 3>(_e894.member_1[0], _e1416, (_e894.member_1[2] + (_e1397.member_1 * _e1414))), _e1434.member_2);
                                                        let _e1444 = type_36(array<f32, 2>(_e1438.member[0], ((_e1397.member * _e1414) - _e894.member[1])), _e1438.member_1, _e1438.member_2);
                                                        let _e1460 = array<f32, 3>(((_e894.member_2[1][0] * _e1397.member) - (_e894.member_2[2][0] * _e1397.member_1)), ((_e894.member_2[1][1] * _e1397.member) - (_e894.member_2[2][1] * _e1397.member_1)), ((_e894.member_2[1][2] * _e1397.member) - (_e894.member_2[2][2] * _e1397.member_1)));
                                                        let _e1483 = type_36(_e1444.member, _e1444.member_1, array<array<f32, 3>, 3>(_e894.member_2[0], _e1444.member_2[1], _e1444.member_2[2]));
                                                        let _e1490 = type_36(_e1483.member, _e1483.member_1, array<array<f32, 3>, 3>(_e1483.member_2[0], _e1460, _e1483.member_2[2]));
                                                        phi_2348_ = type_36(_e1490.member, _e1490.member_1, array<array<f32, 3>, 3>(_e894.member_2[0], _e1460, array<f32, 3>(((_e894.member_2[1][0] * _e1397.member_1) + (_e894.member_2[2][0] * _e1397.member)), ((_e894.member_2[1][1] * _e1397.member_1) + (_e894.member_2[2][1] * _e1397.member)), ((_e894.member_2[1][2] * _e1397.member_1) + (_e894.member_2[2][2] * _e1397.member)))));
                                                    } else {
                                                        phi_2348_ = _e894;
                                                    }
                                                    let _e1496 = phi_2348_;
                                                    phi_2349_ = _e1496;
                                                }
                                                let _e1737 = phi_2349_;
                                                phi_2350_ = _e1737;
                                            } else {
                                                phi_2350_ = _e1253;
                                            }
                                            let _e1739 = phi_2350_;
                                            if _e924 {
                                                phi_2354_ = true;
                                            } else {
                                                phi_2354_ = _e929;
                                            }
                                            let _e1741 = phi_2354_;
                                            if _e1741 {
                                                phi_2358_ = false;
                                            } else {
                                                phi_2358_ = true;
                                            }
                                            let _e1743 = phi_2358_;
                                            phi_1346_ = _e1739;
                                            phi_2359_ = _e1739;
                                            phi_2360_ = _e1741;
                                            phi_2361_ = _e1743;
                                        } else {
                                            phi_1346_ = type_36();
                                            phi_2359_ = type_36();
                                            phi_2360_ = false;
                                            phi_2361_ = false;
                                        }
                                        let _e1745 = phi_1346_;
                                        let _e1747 = phi_2359_;
                                        let _e1749 = phi_2360_;
                                        let _e1751 = phi_2361_;
                                        local_8 = _e1751;
                                        local_9 = _e1747;
                                        continue;
                                        continuing {
                                            phi_1342_ = _e906;
                                            phi_1345_ = _e1745;
                                            break if !(_e1749);
                                        }
                                    }
                                    let _e1754 = local_8;
                                    if _e1754 {
                                        let _e3683 = local_9;
                                        phi_2365_ = _e3683;
                                    } else {
                                        let _e3685 = local_10;
                                        phi_2365_ = _e3685;
                                    }
                                    let _e1756 = phi_2365_;
                                    let _e1760 = (2130706432u - (bitcast<u32>(_e775) & 2139095040u));
                                    if (_e1760 > 8388608u) {
                                        phi_2377_ = _e1760;
                                    } else {
                                        phi_2377_ = 8388608u;
                                    }
                                    let _e1763 = phi_2377_;
                                    let _e1764 = bitcast<f32>(_e1763);
                                    let _e1786 = ((((_e1756.member_2[0][0] * _e1756.member_2[0][0]) + (_e1756.member_2[0][1] * _e1756.member_2[0][1])) + (_e1756.member_2[0][2] * _e1756.member_2[0][2])) - 1f);
                                    let _e1800 = ((((_e1756.member_2[1][0] * _e1756.member_2[1][0]) + (_e1756.member_2[1][1] * _e1756.member_2[1][1])) + (_e1756.member_2[1][2] * _e1756.member_2[1][2])) - 1f);
                                    let _e1814 = ((((_e1756.member_2[2][0] * _e1756.member_2[2][0]) + (_e1756.member_2[2][1] * _e1756.member_2[2][1])) + (_e1756.member_2[2][2] * _e1756.member_2[2][2])) - 1f);
                                    let _e1827 = (((_e1756.member_2[0][0] * _e1756.member_2[1][0]) + (_e1756.member_2[0][1] * _e1756.member_2[1][1])) + (_e1756.member_2[0][2] * _e1756.member_2[1][2]));
                                    let _e1840 = (((_e1756.member_2[0][0] * _e1756.member_2[2][0]) + (_e1756.member_2[0][1] * _e1756.member_2[2][1])) + (_e1756.member_2[0][2] * _e1756.member_2[2][2]));
                                    let _e1853 = (((_e1756.member_2[1][0] * _e1756.member_2[2][0]) + (_e1756.member_2[1][1] * _e1756.member_2[2][1])) + (_e1756.member_2[1][2] * _e1756.member_2[2][2]));
                                    let _e1886 = (_e1756.member_2[0][0] - ((((_e1756.member_2[0][0] * _e1786) + (_e1756.member_2[1][0] * _e1827)) + (_e1756.member_2[2][0] * _e1840)) * 0.5f));
                                    let _e1888 = (_e1756.member_2[0][1] - ((((_e1756.member_2[0][1] * _e1786) + (_e1756.member_2[1][1] * _e1827)) + (_e1756.member_2[2][1] * _e1840)) * 0.5f));
                                    let _e1890 = (_e1756.member_2[0][2] - ((((_e1756.member_2[0][2] * _e1786) + (_e1756.member_2[1][2] * _e1827)) + (_e1756.member_2[2][2] * _e1840)) * 0.5f));
                                    if (_e1886 < 0f) {
                                        phi_2510_ = -(_e1886);
                                    } else {
                                        phi_2510_ = _e1886;
                                    }
                                    let _e1894 = phi_2510_;
                                    if (_e1894 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2516_ = _e1886;
                                    } else {
                                        phi_2516_ = 0f;
                                    }
                                    let _e1898 = phi_2516_;
                                    if (_e1888 < 0f) {
                                        phi_2522_ = -(_e1888);
                                    } else {
                                        phi_2522_ = _e1888;
                                    }
                                    let _e1902 = phi_2522_;
                                    if (_e1902 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2528_ = _e1888;
                                    } else {
                                        phi_2528_ = 0f;
                                    }
                                    let _e1906 = phi_2528_;
                                    if (_e1890 < 0f) {
                                        phi_2534_ = -(_e1890);
                                    } else {
                                        phi_2534_ = _e1890;
                                    }
                                    let _e1910 = phi_2534_;
                                    if (_e1910 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2540_ = _e1890;
                                    } else {
                                        phi_2540_ = 0f;
                                    }
                                    let _e1914 = phi_2540_;
                                    let _e1948 = (_e1756.member_2[1][0] - ((((_e1756.member_2[0][0] * _e1827) + (_e1756.member_2[1][0] * _e1800)) + (_e1756.member_2[2][0] * _e1853)) * 0.5f));
                                    let _e1950 = (_e1756.member_2[1][1] - ((((_e1756.member_2[0][1] * _e1827) + (_e1756.member_2[1][1] * _e1800)) + (_e1756.member_2[2][1] * _e1853)) * 0.5f));
                                    let _e1952 = (_e1756.member_2[1][2] - ((((_e1756.member_2[0][2] * _e1827) + (_e1756.member_2[1][2] * _e1800)) + (_e1756.member_2[2][2] * _e1853)) * 0.5f));
                                    if (_e1948 < 0f) {
                                        phi_2584_ = -(_e1948);
                                    } else {
                                        phi_2584_ = _e1948;
                                    }
                                    let _e1956 = phi_2584_;
                                    if (_e1956 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2590_ = _e1948;
                                    } else {
                                        phi_2590_ = 0f;
                                    }
                                    let _e1960 = phi_2590_;
                                    if (_e1950 < 0f) {
                                        phi_2596_ = -(_e1950);
                                    } else {
                                        phi_2596_ = _e1950;
                                    }
                                    let _e1964 = phi_2596_;
                                    if (_e1964 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2602_ = _e1950;
                                    } else {
                                        phi_2602_ = 0f;
                                    }
                                    let _e1968 = phi_2602_;
                                    if (_e1952 < 0f) {
                                        phi_2608_ = -(_e1952);
                                    } else {
                                        phi_2608_ = _e1952;
                                    }
                                    let _e1972 = phi_2608_;
                                    if (_e1972 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2614_ = _e1952;
                                    } else {
                                        phi_2614_ = 0f;
                                    }
                                    let _e1976 = phi_2614_;
                                    let _e2010 = (_e1756.member_2[2][0] - ((((_e1756.member_2[0][0] * _e1840) + (_e1756.member_2[1][0] * _e1853)) + (_e1756.member_2[2][0] * _e1814)) * 0.5f));
                                    let _e2012 = (_e1756.member_2[2][1] - ((((_e1756.member_2[0][1] * _e1840) + (_e1756.member_2[1][1] * _e1853)) + (_e1756.member_2[2][1] * _e1814)) * 0.5f));
                                    let _e2014 = (_e1756.member_2[2][2] - ((((_e1756.member_2[0][2] * _e1840) + (_e1756.member_2[1][2] * _e1853)) + (_e1756.member_2[2][2] * _e1814)) * 0.5f));
                                    if (_e2010 < 0f) {
                                        phi_2658_ = -(_e2010);
                                    } else {
                                        phi_2658_ = _e2010;
                                    }
                                    let _e2018 = phi_2658_;
                                    if (_e2018 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2664_ = _e2010;
                                    } else {
                                        phi_2664_ = 0f;
                                    }
                                    let _e2022 = phi_2664_;
                                    if (_e2012 < 0f) {
                                        phi_2670_ = -(_e2012);
                                    } else {
                                        phi_2670_ = _e2012;
                                    }
                                    let _e2026 = phi_2670_;
                                    if (_e2026 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2676_ = _e2012;
                                    } else {
                                        phi_2676_ = 0f;
                                    }
                                    let _e2030 = phi_2676_;
                                    if (_e2014 < 0f) {
                                        phi_2682_ = -(_e2014);
                                    } else {
                                        phi_2682_ = _e2014;
                                    }
                                    let _e2034 = phi_2682_;
                                    if (_e2034 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2688_ = _e2014;
                                    } else {
                                        phi_2688_ = 0f;
                                    }
                                    let _e2038 = phi_2688_;
                                    let _e2046 = ((((_e1898 * _e1898) + (_e1906 * _e1906)) + (_e1914 * _e1914)) - 1f);
                                    let _e2052 = ((((_e1960 * _e1960) + (_e1968 * _e1968)) + (_e1976 * _e1976)) - 1f);
                                    let _e2058 = ((((_e2022 * _e2022) + (_e2030 * _e2030)) + (_e2038 * _e2038)) - 1f);
                                    let _e2063 = (((_e1898 * _e1960) + (_e1906 * _e1968)) + (_e1914 * _e1976));
                                    let _e2068 = (((_e1898 * _e2022) + (_e1906 * _e2030)) + (_e1914 * _e2038));
                                    let _e2073 = (((_e1960 * _e2022) + (_e1968 * _e2030)) + (_e1976 * _e2038));
                                    if (_e2046 < 0f) {
                                        phi_2729_ = -(_e2046);
                                    } else {
                                        phi_2729_ = _e2046;
                                    }
                                    let _e2077 = phi_2729_;
                                    if (_e2052 < 0f) {
                                        phi_2735_ = -(_e2052);
                                    } else {
                                        phi_2735_ = _e2052;
                                    }
                                    let _e2081 = phi_2735_;
                                    if (_e2077 > _e2081) {
                                        phi_2740_ = _e2077;
                                    } else {
                                        phi_2740_ = _e2081;
                                    }
                                    let _e2084 = phi_2740_;
                                    if (_e2058 < 0f) {
                                        phi_2746_ = -(_e2058);
                                    } else {
                                        phi_2746_ = _e2058;
                                    }
                                    let _e2088 = phi_2746_;
                                    if (_e2084 > _e2088) {
                                        phi_2751_ = _e2084;
                                    } else {
                                        phi_2751_ = _e2088;
                                    }
                                    let _e2091 = phi_2751_;
                                    if (_e2063 < 0f) {
                                        phi_2757_ = -(_e2063);
                                    } else {
                                        phi_2757_ = _e2063;
                                    }
                                    let _e2095 = phi_2757_;
                                    if (_e2068 < 0f) {
                                        phi_2763_ = -(_e2068);
                                    } else {
                                        phi_2763_ = _e2068;
                                    }
                                    let _e2099 = phi_2763_;
                                    if (_e2095 > _e2099) {
                                        phi_2768_ = _e2095;
                                    } else {
                                        phi_2768_ = _e2099;
                                    }
                                    let _e2102 = phi_2768_;
                                    if (_e2073 < 0f) {
                                        phi_2774_ = -(_e2073);
                                    } else {
                                        phi_2774_ = _e2073;
                                    }
                                    let _e2106 = phi_2774_;
                                    if (_e2102 > _e2106) {
                                        phi_2779_ = _e2102;
                                    } else {
                                        phi_2779_ = _e2106;
                                    }
                                    let _e2109 = phi_2779_;
                                    if (_e2091 > _e2109) {
                                        phi_2784_ = _e2091;
                                    } else {
                                        phi_2784_ = _e2109;
                                    }
                                    let _e2112 = phi_2784_;
                                    if (_e2112 <= (0.000000059604645f * (16f - 6f))) {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1898, _e1906, _e1914), array<f32, 3>(_e1960, _e1968, _e1976), array<f32, 3>(_e2022, _e2030, _e2038));
                                    } else {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                                    }
                                    let _e2117 = phi_2795_;
                                    phi_2797_ = type_37(array<f32, 3>((_e1756.member_1[0] * _e1764), (_e1756.member_1[1] * _e1764), (_e1756.member_1[2] * _e1764)), _e2117);
                                    phi_2798_ = false;
                                } else {
                                    phi_2797_ = type_37();
                                    phi_2798_ = true;
                                }
                                let _e2120 = phi_2797_;
                                let _e2122 = phi_2798_;
                                phi_2799_ = _e2120;
                                phi_2800_ = _e2122;
                            } else {
                                phi_2799_ = type_37();
                                phi_2800_ = true;
                            }
                            let _e2124 = phi_2799_;
                            let _e2126 = phi_2800_;
                            if _e2126 {
                                phi_2813_ = type_37(array<f32, 3>(_e717, _e721, _e725), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                            } else {
                                phi_2813_ = _e2124;
                            }
                            let _e2130 = phi_2813_;
                            let _e2145 = (((_e313.member_1[0][0] * _e2130.member_1[0][0]) + (_e313.member_1[0][1] * _e2130.member_1[0][1])) + (_e313.member_1[0][2] * _e2130.member_1[0][2]));
                            let _e2158 = (((_e313.member_1[1][0] * _e2130.member_1[0][0]) + (_e313.member_1[1][1] * _e2130.member_1[0][1])) + (_e313.member_1[1][2] * _e2130.member_1[0][2]));
                            let _e2171 = (((_e313.member_1[2][0] * _e2130.member_1[0][0]) + (_e313.member_1[2][1] * _e2130.member_1[0][1])) + (_e313.member_1[2][2] * _e2130.member_1[0][2]));
                            if (_e2145 < 0f) {
                                phi_2858_ = -(_e2145);
                            } else {
                                phi_2858_ = _e2145;
                            }
                            let _e2176 = phi_2858_;
                            if (_e2158 < 0f) {
                                phi_2864_ = -(_e2158);
                            } else {
                                phi_2864_ = _e2158;
                            }
                            let _e2180 = phi_2864_;
                            if (_e2171 < 0f) {
                                phi_2870_ = -(_e2171);
                            } else {
                                phi_2870_ = _e2171;
                            }
                            let _e2184 = phi_2870_;
                            let _e2192 = (((_e2176 * _e313.member_2[0]) + (_e2180 * _e313.member_2[1])) + (_e2184 * _e313.member_2[2]));
                            let _e2206 = (((_e313.member_1[0][0] * _e2130.member_1[1][0]) + (_e313.member_1[0][1] * _e2130.member_1[1][1])) + (_e313.member_1[0][2] * _e2130.member_1[1][2]));
                            let _e2219 = (((_e313.member_1[1][0] * _e2130.member_1[1][0]) + (_e313.member_1[1][1] * _e2130.member_1[1][1])) + (_e313.member_1[1][2] * _e2130.member_1[1][2]));
                            let _e2232 = (((_e313.member_1[2][0] * _e2130.member_1[1][0]) + (_e313.member_1[2][1] * _e2130.member_1[1][1])) + (_e313.member_1[2][2] * _e2130.member_1[1][2]));
                            if (_e2206 < 0f) {
                                phi_2922_ = -(_e2206);
                            } else {
                                phi_2922_ = _e2206;
                            }
                            let _e2237 = phi_2922_;
                            if (_e2219 < 0f) {
                                phi_2928_ = -(_e2219);
                            } else {
                                phi_2928_ = _e2219;
                            }
                            let _e2241 = phi_2928_;
                            if (_e2232 < 0f) {
                                phi_2934_ = -(_e2232);
                            } else {
                                phi_2934_ = _e2232;
                            }
                            let _e2245 = phi_2934_;
                            let _e2253 = (((_e2237 * _e313.member_2[0]) + (_e2241 * _e313.member_2[1])) + (_e2245 * _e313.member_2[2]));
                            let _e2267 = (((_e313.member_1[0][0] * _e2130.member_1[2][0]) + (_e313.member_1[0][1] * _e2130.member_1[2][1])) + (_e313.member_1[0][2] * _e2130.member_1[2][2]));
                            let _e2280 = (((_e313.member_1[1][0] * _e2130.member_1[2][0]) + (_e313.member_1[1][1] * _e2130.member_1[2][1])) + (_e313.member_1[1][2] * _e2130.member_1[2][2]));
                            let _e2293 = (((_e313.member_1[2][0] * _e2130.member_1[2][0]) + (_e313.member_1[2][1] * _e2130.member_1[2][1])) + (_e313.member_1[2][2] * _e2130.member_1[2][2]));
                            if (_e2267 < 0f) {
                                phi_2986_ = -(_e2267);
                            } else {
                                phi_2986_ = _e2267;
                            }
                            let _e2298 = phi_2986_;
                            if (_e2280 < 0f) {
                                phi_2992_ = -(_e2280);
                            } else {
                                phi_2992_ = _e2280;
                            }
                            let _e2302 = phi_2992_;
                            if (_e2293 < 0f) {
                                phi_2998_ = -(_e2293);
                            } else {
                                phi_2998_ = _e2293;
                            }
                            let _e2306 = phi_2998_;
                            let _e2314 = (((_e2298 * _e313.member_2[0]) + (_e2302 * _e313.member_2[1])) + (_e2306 * _e313.member_2[2]));
                            let _e2328 = (((_e451.member_1[0][0] * _e2130.member_1[0][0]) + (_e451.member_1[0][1] * _e2130.member_1[0][1])) + (_e451.member_1[0][2] * _e2130.member_1[0][2]));
                            let _e2341 = (((_e451.member_1[1][0] * _e2130.member_1[0][0]) + (_e451.member_1[1][1] * _e2130.member_1[0][1])) + (_e451.member_1[1][2] * _e2130.member_1[0][2]));
                            let _e2354 = (((_e451.member_1[2][0] * _e2130.member_1[0][0]) + (_e451.member_1[2][1] * _e2130.member_1[0][1])) + (_e451.member_1[2][2] * _e2130.member_1[0][2]));
                            if (_e2328 < 0f) {
                                phi_3050_ = -(_e2328);
                            } else {
                                phi_3050_ = _e2328;
                            }
                            let _e2359 = phi_3050_;
                            if (_e2341 < 0f) {
                                phi_3056_ = -(_e2341);
                            } else {
                                phi_3056_ = _e2341;
                            }
                            let _e2363 = phi_3056_;
                            if (_e2354 < 0f) {
                                phi_3062_ = -(_e2354);
                            } else {
                                phi_3062_ = _e2354;
                            }
                            let _e2367 = phi_3062_;
                            let _e2375 = (((_e2359 * _e451.member_2[0]) + (_e2363 * _e451.member_2[1])) + (_e2367 * _e451.member_2[2]));
                            let _e2389 = (((_e451.member_1[0][0] * _e2130.member_1[1][0]) + (_e451.member_1[0][1] * _e2130.member_1[1][1])) + (_e451.member_1[0][2] * _e2130.member_1[1][2]));
                            let _e2402 = (((_e451.member_1[1][0] * _e2130.member_1[1][0]) + (_e451.member_1[1][1] * _e2130.member_1[1][1])) + (_e451.member_1[1][2] * _e2130.member_1[1][2]));
                            let _e2415 = (((_e451.member_1[2][0] * _e2130.member_1[1][0]) + (_e451.member_1[2][1] * _e2130.member_1[1][1])) + (_e451.member_1[2][2] * _e2130.member_1[1][2]));
                            if (_e2389 < 0f) {
                                phi_3114_ = -(_e2389);
                            } else {
                                phi_3114_ = _e2389;
                            }
                            let _e2420 = phi_3114_;
                            if (_e2402 < 0f) {
                                phi_3120_ = -(_e2402);
                            } else {
                                phi_3120_ = _e2402;
                            }
                            let _e2424 = phi_3120_;
                            if (_e2415 < 0f) {
                                phi_3126_ = -(_e2415);
                            } else {
                                phi_3126_ = _e2415;
                            }
                            let _e2428 = phi_3126_;
                            let _e2436 = (((_e2420 * _e451.member_2[0]) + (_e2424 * _e451.member_2[1])) + (_e2428 * _e451.member_2[2]));
                            let _e2450 = (((_e451.member_1[0][0] * _e2130.member_1[2][0]) + (_e451.member_1[0][1] * _e2130.member_1[2][1])) + (_e451.member_1[0][2] * _e2130.member_1[2][2]));
                            let _e2463 = (((_e451.member_1[1][0] * _e2130.member_1[2][0]) + (_e451.member_1[1][1] * _e2130.member_1[2][1])) + (_e451.member_1[1][2] * _e2130.member_1[2][2]));
                            let _e2476 = (((_e451.member_1[2][0] * _e2130.member_1[2][0]) + (_e451.member_1[2][1] * _e2130.member_1[2][1])) + (_e451.member_1[2][2] * _e2130.member_1[2][2]));
                            if (_e2450 < 0f) {
                                phi_3178_ = -(_e2450);
                            } else {
                                phi_3178_ = _e2450;
                            }
                            let _e2481 = phi_3178_;
                            if (_e2463 < 0f) {
                                phi_3184_ = -(_e2463);
                            } else {
                                phi_3184_ = _e2463;
                            }
                            let _e2485 = phi_3184_;
                            if (_e2476 < 0f) {
                                phi_3190_ = -(_e2476);
                            } else {
                                phi_3190_ = _e2476;
                            }
                            let _e2489 = phi_3190_;
                            let _e2497 = (((_e2481 * _e451.member_2[0]) + (_e2485 * _e451.member_2[1])) + (_e2489 * _e451.member_2[2]));
                            let _e2506 = (((_e2130.member_1[0][0] * _e456) + (_e2130.member_1[0][1] * _e459)) + (_e2130.member_1[0][2] * _e462));
                            let _e2515 = (((_e2130.member_1[1][0] * _e456) + (_e2130.member_1[1][1] * _e459)) + (_e2130.member_1[1][2] * _e462));
                            let _e2524 = (((_e2130.member_1[2][0] * _e456) + (_e2130.member_1[2][1] * _e459)) + (_e2130.member_1[2][2] * _e462));
                            let _e2525 = (_e2192 * -1f);
                            let _e2526 = (_e2253 * -1f);
                            let _e2527 = (_e2314 * -1f);
                            let _e2528 = (_e2506 - _e2375);
                            let _e2529 = (_e2515 - _e2436);
                            let _e2530 = (_e2524 - _e2497);
                            if (_e2525 < _e2528) {
                                phi_3236_ = _e2525;
                            } else {
                                phi_3236_ = _e2528;
                            }
                            let _e2533 = phi_3236_;
                            if (_e2526 < _e2529) {
                                phi_3241_ = _e2526;
                            } else {
                                phi_3241_ = _e2529;
                            }
                            let _e2536 = phi_3241_;
                            if (_e2527 < _e2530) {
                                phi_3246_ = _e2527;
                            } else {
                                phi_3246_ = _e2530;
                            }
                            let _e2539 = phi_3246_;
                            let _e2540 = (_e2506 + _e2375);
                            let _e2541 = (_e2515 + _e2436);
                            let _e2542 = (_e2524 + _e2497);
                            if (_e2192 > _e2540) {
                                phi_3254_ = _e2192;
                            } else {
                                phi_3254_ = _e2540;
                            }
                            let _e2545 = phi_3254_;
                            if (_e2253 > _e2541) {
                                phi_3259_ = _e2253;
                            } else {
                                phi_3259_ = _e2541;
                            }
                            let _e2548 = phi_3259_;
                            if (_e2314 > _e2542) {
                                phi_3264_ = _e2314;
                            } else {
                                phi_3264_ = _e2542;
                            }
                            let _e2551 = phi_3264_;
                            let _e2556 = ((_e2533 + _e2545) * 0.5f);
                            let _e2557 = ((_e2536 + _e2548) * 0.5f);
                            let _e2558 = ((_e2539 + _e2551) * 0.5f);
                            let _e2587 = (_e313.member[0] + (((_e2130.member_1[0][0] * _e2556) + (_e2130.member_1[1][0] * _e2557)) + (_e2130.member_1[2][0] * _e2558)));
                            let _e2589 = (_e313.member[1] + (((_e2130.member_1[0][1] * _e2556) + (_e2130.member_1[1][1] * _e2557)) + (_e2130.member_1[2][1] * _e2558)));
                            let _e2591 = (_e313.member[2] + (((_e2130.member_1[0][2] * _e2556) + (_e2130.member_1[1][2] * _e2557)) + (_e2130.member_1[2][2] * _e2558)));
                            if (_e313.member[0] < 0f) {
                                phi_3313_ = -(_e313.member[0]);
                            } else {
                                phi_3313_ = _e313.member[0];
                            }
                            let _e2598 = phi_3313_;
                            if (_e313.member[1] < 0f) {
                                phi_3320_ = -(_e313.member[1]);
                            } else {
                                phi_3320_ = _e313.member[1];
                            }
                            let _e2603 = phi_3320_;
                            if (_e313.member[2] < 0f) {
                                phi_3327_ = -(_e313.member[2]);
                            } else {
                                phi_3327_ = _e313.member[2];
                            }
                            let _e2608 = phi_3327_;
                            if (_e451.member[0] < 0f) {
                                phi_3335_ = -(_e451.member[0]);
                            } else {
                                phi_3335_ = _e451.member[0];
                            }
                            let _e2614 = phi_3335_;
                            if (_e451.member[1] < 0f) {
                                phi_3342_ = -(_e451.member[1]);
                            } else {
                                phi_3342_ = _e451.member[1];
                            }
                            let _e2619 = phi_3342_;
                            if (_e451.member[2] < 0f) {
                                phi_3349_ = -(_e451.member[2]);
                            } else {
                                phi_3349_ = _e451.member[2];
                            }
                            let _e2624 = phi_3349_;
                            if (_e2598 > _e2614) {
                                phi_3354_ = _e2598;
                            } else {
                                phi_3354_ = _e2614;
                            }
                            let _e2627 = phi_3354_;
                            if (_e2603 > _e2619) {
                                phi_3359_ = _e2603;
                            } else {
                                phi_3359_ = _e2619;
                            }
                            let _e2630 = phi_3359_;
                            if (_e2608 > _e2624) {
                                phi_3364_ = _e2608;
                            } else {
                                phi_3364_ = _e2624;
                            }
                            let _e2633 = phi_3364_;
                            let _e2636 = (_e313.member[0] - _e2587);
                            let _e2638 = (_e313.member[1] - _e2589);
                            let _e2640 = (_e313.member[2] - _e2591);
                            if (_e2636 < 0f) {
                                phi_3377_ = -(_e2636);
                            } else {
                                phi_3377_ = _e2636;
                            }
                            let _e2644 = phi_3377_;
                            if (_e2638 < 0f) {
                                phi_3383_ = -(_e2638);
                            } else {
                                phi_3383_ = _e2638;
                            }
                            let _e2648 = phi_3383_;
                            if (_e2640 < 0f) {
                                phi_3390_ = -(_e2640);
                            } else {
                                phi_3390_ = _e2640;
                            }
                            let _e2653 = phi_3390_;
                            let _e2656 = (((_e2644 + _e2648) + _e2653) * (0.000000059604645f * 16f));
                            if (_e2130.member_1[0][0] < 0f) {
                                phi_3401_ = -(_e2130.member_1[0][0]);
                            } else {
                                phi_3401_ = _e2130.member_1[0][0];
                            }
                            let _e2662 = phi_3401_;
                            if (_e2130.member_1[0][1] < 0f) {
                                phi_3408_ = -(_e2130.member_1[0][1]);
                            } else {
                                phi_3408_ = _e2130.member_1[0][1];
                            }
                            let _e2667 = phi_3408_;
                            if (_e2130.member_1[0][2] < 0f) {
                                phi_3415_ = -(_e2130.member_1[0][2]);
                            } else {
                                phi_3415_ = _e2130.member_1[0][2];
                            }
                            let _e2672 = phi_3415_;
                            if (_e2130.member_1[1][0] < 0f) {
                                phi_3428_ = -(_e2130.member_1[1][0]);
                            } else {
                                phi_3428_ = _e2130.member_1[1][0];
                            }
                            let _e2683 = phi_3428_;
                            if (_e2130.member_1[1][1] < 0f) {
                                phi_3435_ = -(_e2130.member_1[1][1]);
                            } else {
                                phi_3435_ = _e2130.member_1[1][1];
                            }
                            let _e2688 = phi_3435_;
                            if (_e2130.member_1[1][2] < 0f) {
                                phi_3442_ = -(_e2130.member_1[1][2]);
                            } else {
                                phi_3442_ = _e2130.member_1[1][2];
                            }
                            let _e2693 = phi_3442_;
                            if (_e2130.member_1[2][0] < 0f) {
                                phi_3455_ = -(_e2130.member_1[2][0]);
                            } else {
                                phi_3455_ = _e2130.member_1[2][0];
                            }
                            let _e2704 = phi_3455_;
                            if (_e2130.member_1[2][1] < 0f) {
                                phi_3462_ = -(_e2130.member_1[2][1]);
                            } else {
                                phi_3462_ = _e2130.member_1[2][1];
                            }
                            let _e2709 = phi_3462_;
                            if (_e2130.member_1[2][2] < 0f) {
                                phi_3469_ = -(_e2130.member_1[2][2]);
                            } else {
                                phi_3469_ = _e2130.member_1[2][2];
                            }
                            let _e2714 = phi_3469_;
                            let _e2720 = (0.000000059604645f * 12f);
                            let _e2724 = (((((_e2662 * _e2627) + (_e2667 * _e2630)) + (_e2672 * _e2633)) * _e2720) + _e2656);
                            let _e2725 = (((((_e2683 * _e2627) + (_e2688 * _e2630)) + (_e2693 * _e2633)) * _e2720) + _e2656);
                            let _e2726 = (((((_e2704 * _e2627) + (_e2709 * _e2630)) + (_e2714 * _e2633)) * _e2720) + _e2656);
                            let _e2729 = (_e313.member[0] - _e2587);
                            let _e2731 = (_e313.member[1] - _e2589);
                            let _e2733 = (_e313.member[2] - _e2591);
                            if (_e313.member_2[0] < 0f) {
                                phi_3496_ = -(_e313.member_2[0]);
                            } else {
                                phi_3496_ = _e313.member_2[0];
                            }
                            let _e2739 = phi_3496_;
                            if (_e313.member_2[1] < 0f) {
                                phi_3503_ = -(_e313.member_2[1]);
                            } else {
                                phi_3503_ = _e313.member_2[1];
                            }
                            let _e2744 = phi_3503_;
                            if (_e313.member_2[2] < 0f) {
                                phi_3511_ = -(_e313.member_2[2]);
                            } else {
                                phi_3511_ = _e313.member_2[2];
                            }
                            let _e2750 = phi_3511_;
                            if (_e2729 < 0f) {
                                phi_3520_ = -(_e2729);
                            } else {
                                phi_3520_ = _e2729;
                            }
                            let _e2757 = phi_3520_;
                            if (_e2731 < 0f) {
                                phi_3526_ = -(_e2731);
                            } else {
                                phi_3526_ = _e2731;
                            }
                            let _e2761 = phi_3526_;
                            if (_e2733 < 0f) {
                                phi_3532_ = -(_e2733);
                            } else {
                                phi_3532_ = _e2733;
                            }
                            let _e2765 = phi_3532_;
                            if (_e2130.member_1[0][0] < 0f) {
                                phi_3540_ = -(_e2130.member_1[0][0]);
                            } else {
                                phi_3540_ = _e2130.member_1[0][0];
                            }
                            let _e2771 = phi_3540_;
                            if (_e2130.member_1[0][1] < 0f) {
                                phi_3547_ = -(_e2130.member_1[0][1]);
                            } else {
                                phi_3547_ = _e2130.member_1[0][1];
                            }
                            let _e2776 = phi_3547_;
                            if (_e2130.member_1[0][2] < 0f) {
                                phi_3554_ = -(_e2130.member_1[0][2]);
                            } else {
                                phi_3554_ = _e2130.member_1[0][2];
                            }
                            let _e2781 = phi_3554_;
                            if (_e2130.member_1[1][0] < 0f) {
                                phi_3567_ = -(_e2130.member_1[1][0]);
                            } else {
                                phi_3567_ = _e2130.member_1[1][0];
                            }
                            let _e2792 = phi_3567_;
                            if (_e2130.member_1[1][1] < 0f) {
                                phi_3574_ = -(_e2130.member_1[1][1]);
                            } else {
                                phi_3574_ = _e2130.member_1[1][1];
                            }
                            let _e2797 = phi_3574_;
                            if (_e2130.member_1[1][2] < 0f) {
                                phi_3581_ = -(_e2130.member_1[1][2]);
                            } else {
                                phi_3581_ = _e2130.member_1[1][2];
                            }
                            let _e2802 = phi_3581_;
                            if (_e2130.member_1[2][0] < 0f) {
                                phi_3594_ = -(_e2130.member_1[2][0]);
                            } else {
                                phi_3594_ = _e2130.member_1[2][0];
                            }
                            let _e2813 = phi_3594_;
                            if (_e2130.member_1[2][1] < 0f) {
                                phi_3601_ = -(_e2130.member_1[2][1]);
                            } else {
                                phi_3601_ = _e2130.member_1[2][1];
                            }
                            let _e2818 = phi_3601_;
                            if (_e2130.member_1[2][2] < 0f) {
                                phi_3608_ = -(_e2130.member_1[2][2]);
                            } else {
                                phi_3608_ = _e2130.member_1[2][2];
                            }
                            let _e2823 = phi_3608_;
                            let _e2829 = (0.000000059604645f * 8f);
                            let _e2834 = ((((_e2739 + _e2744) + _e2750) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2846 = (((_e2130.member_1[0][0] * _e2729) + (_e2130.member_1[0][1] * _e2731)) + (_e2130.member_1[0][2] * _e2733));
                            let _e2855 = (((_e2130.member_1[1][0] * _e2729) + (_e2130.member_1[1][1] * _e2731)) + (_e2130.member_1[1][2] * _e2733));
                            let _e2864 = (((_e2130.member_1[2][0] * _e2729) + (_e2130.member_1[2][1] * _e2731)) + (_e2130.member_1[2][2] * _e2733));
                            if (_e2846 < 0f) {
                                phi_3655_ = -(_e2846);
                            } else {
                                phi_3655_ = _e2846;
                            }
                            let _e2868 = phi_3655_;
                            if (_e2855 < 0f) {
                                phi_3661_ = -(_e2855);
                            } else {
                                phi_3661_ = _e2855;
                            }
                            let _e2872 = phi_3661_;
                            if (_e2864 < 0f) {
                                phi_3667_ = -(_e2864);
                            } else {
                                phi_3667_ = _e2864;
                            }
                            let _e2876 = phi_3667_;
                            let _e2890 = (((_e313.member_1[0][0] * _e2130.member_1[0][0]) + (_e313.member_1[0][1] * _e2130.member_1[0][1])) + (_e313.member_1[0][2] * _e2130.member_1[0][2]));
                            let _e2903 = (((_e313.member_1[1][0] * _e2130.member_1[0][0]) + (_e313.member_1[1][1] * _e2130.member_1[0][1])) + (_e313.member_1[1][2] * _e2130.member_1[0][2]));
                            let _e2916 = (((_e313.member_1[2][0] * _e2130.member_1[0][0]) + (_e313.member_1[2][1] * _e2130.member_1[0][1])) + (_e313.member_1[2][2] * _e2130.member_1[0][2]));
                            if (_e2890 < 0f) {
                                phi_3711_ = -(_e2890);
                            } else {
                                phi_3711_ = _e2890;
                            }
                            let _e2921 = phi_3711_;
                            if (_e2903 < 0f) {
                                phi_3717_ = -(_e2903);
                            } else {
                                phi_3717_ = _e2903;
                            }
                            let _e2925 = phi_3717_;
                            if (_e2916 < 0f) {
                                phi_3723_ = -(_e2916);
                            } else {
                                phi_3723_ = _e2916;
                            }
                            let _e2929 = phi_3723_;
                            let _e2951 = (((_e313.member_1[0][0] * _e2130.member_1[1][0]) + (_e313.member_1[0][1] * _e2130.member_1[1][1])) + (_e313.member_1[0][2] * _e2130.member_1[1][2]));
                            let _e2964 = (((_e313.member_1[1][0] * _e2130.member_1[1][0]) + (_e313.member_1[1][1] * _e2130.member_1[1][1])) + (_e313.member_1[1][2] * _e2130.member_1[1][2]));
                            let _e2977 = (((_e313.member_1[2][0] * _e2130.member_1[1][0]) + (_e313.member_1[2][1] * _e2130.member_1[1][1])) + (_e313.member_1[2][2] * _e2130.member_1[1][2]));
                            if (_e2951 < 0f) {
                                phi_3775_ = -(_e2951);
                            } else {
                                phi_3775_ = _e2951;
                            }
                            let _e2982 = phi_3775_;
                            if (_e2964 < 0f) {
                                phi_3781_ = -(_e2964);
                            } else {
                                phi_3781_ = _e2964;
                            }
                            let _e2986 = phi_3781_;
                            if (_e2977 < 0f) {
                                phi_3787_ = -(_e2977);
                            } else {
                                phi_3787_ = _e2977;
                            }
                            let _e2990 = phi_3787_;
                            let _e3012 = (((_e313.member_1[0][0] * _e2130.member_1[2][0]) + (_e313.member_1[0][1] * _e2130.member_1[2][1])) + (_e313.member_1[0][2] * _e2130.member_1[2][2]));
                            let _e3025 = (((_e313.member_1[1][0] * _e2130.member_1[2][0]) + (_e313.member_1[1][1] * _e2130.member_1[2][1])) + (_e313.member_1[1][2] * _e2130.member_1[2][2]));
                            let _e3038 = (((_e313.member_1[2][0] * _e2130.member_1[2][0]) + (_e313.member_1[2][1] * _e2130.member_1[2][1])) + (_e313.member_1[2][2] * _e2130.member_1[2][2]));
                            if (_e3012 < 0f) {
                                phi_3839_ = -(_e3012);
                            } else {
                                phi_3839_ = _e3012;
                            }
                            let _e3043 = phi_3839_;
                            if (_e3025 < 0f) {
                                phi_3845_ = -(_e3025);
                            } else {
                                phi_3845_ = _e3025;
                            }
                            let _e3047 = phi_3845_;
                            if (_e3038 < 0f) {
                                phi_3851_ = -(_e3038);
                            } else {
                                phi_3851_ = _e3038;
                            }
                            let _e3051 = phi_3851_;
                            let _e3068 = (_e451.member[0] - _e2587);
                            let _e3070 = (_e451.member[1] - _e2589);
                            let _e3072 = (_e451.member[2] - _e2591);
                            if (_e451.member_2[0] < 0f) {
                                phi_3880_ = -(_e451.member_2[0]);
                            } else {
                                phi_3880_ = _e451.member_2[0];
                            }
                            let _e3078 = phi_3880_;
                            if (_e451.member_2[1] < 0f) {
                                phi_3887_ = -(_e451.member_2[1]);
                            } else {
                                phi_3887_ = _e451.member_2[1];
                            }
                            let _e3083 = phi_3887_;
                            if (_e451.member_2[2] < 0f) {
                                phi_3895_ = -(_e451.member_2[2]);
                            } else {
                                phi_3895_ = _e451.member_2[2];
                            }
                            let _e3089 = phi_3895_;
                            if (_e3068 < 0f) {
                                phi_3904_ = -(_e3068);
                            } else {
                                phi_3904_ = _e3068;
                            }
                            let _e3096 = phi_3904_;
                            if (_e3070 < 0f) {
                                phi_3910_ = -(_e3070);
                            } else {
                                phi_3910_ = _e3070;
                            }
                            let _e3100 = phi_3910_;
                            if (_e3072 < 0f) {
                                phi_3916_ = -(_e3072);
                            } else {
                                phi_3916_ = _e3072;
                            }
                            let _e3104 = phi_3916_;
                            if (_e2130.member_1[0][0] < 0f) {
                                phi_3924_ = -(_e2130.member_1[0][0]);
                            } else {
                                phi_3924_ = _e2130.member_1[0][0];
                            }
                            let _e3110 = phi_3924_;
                            if (_e2130.member_1[0][1] < 0f) {
                                phi_3931_ = -(_e2130.member_1[0][1]);
                            } else {
                                phi_3931_ = _e2130.member_1[0][1];
                            }
                            let _e3115 = phi_3931_;
                            if (_e2130.member_1[0][2] < 0f) {
                                phi_3938_ = -(_e2130.member_1[0][2]);
                            } else {
                                phi_3938_ = _e2130.member_1[0][2];
                            }
                            let _e3120 = phi_3938_;
                            if (_e2130.member_1[1][0] < 0f) {
                                phi_3951_ = -(_e2130.member_1[1][0]);
                            } else {
                                phi_3951_ = _e2130.member_1[1][0];
                            }
                            let _e3131 = phi_3951_;
                            if (_e2130.member_1[1][1] < 0f) {
                                phi_3958_ = -(_e2130.member_1[1][1]);
                            } else {
                                phi_3958_ = _e2130.member_1[1][1];
                            }
                            let _e3136 = phi_3958_;
                            if (_e2130.member_1[1][2] < 0f) {
                                phi_3965_ = -(_e2130.member_1[1][2]);
                            } else {
                                phi_3965_ = _e2130.member_1[1][2];
                            }
                            let _e3141 = phi_3965_;
                            if (_e2130.member_1[2][0] < 0f) {
                                phi_3978_ = -(_e2130.member_1[2][0]);
                            } else {
                                phi_3978_ = _e2130.member_1[2][0];
                            }
                            let _e3152 = phi_3978_;
                            if (_e2130.member_1[2][1] < 0f) {
                                phi_3985_ = -(_e2130.member_1[2][1]);
                            } else {
                                phi_3985_ = _e2130.member_1[2][1];
                            }
                            let _e3157 = phi_3985_;
                            if (_e2130.member_1[2][2] < 0f) {
                                phi_3992_ = -(_e2130.member_1[2][2]);
                            } else {
                                phi_3992_ = _e2130.member_1[2][2];
                            }
                            let _e3162 = phi_3992_;
                            let _e3168 = (0.000000059604645f * 8f);
                            let _e3173 = ((((_e3078 + _e3083) + _e3089) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e3185 = (((_e2130.member_1[0][0] * _e3068) + (_e2130.member_1[0][1] * _e3070)) + (_e2130.member_1[0][2] * _e3072));
                            let _e3194 = (((_e2130.member_1[1][0] * _e3068) + (_e2130.member_1[1][1] * _e3070)) + (_e2130.member_1[1][2] * _e3072));
                            let _e3203 = (((_e2130.member_1[2][0] * _e3068) + (_e2130.member_1[2][1] * _e3070)) + (_e2130.member_1[2][2] * _e3072));
                            if (_e3185 < 0f) {
                                phi_4039_ = -(_e3185);
                            } else {
                                phi_4039_ = _e3185;
                            }
                            let _e3207 = phi_4039_;
                            if (_e3194 < 0f) {
                                phi_4045_ = -(_e3194);
                            } else {
                                phi_4045_ = _e3194;
                            }
                            let _e3211 = phi_4045_;
                            if (_e3203 < 0f) {
                                phi_4051_ = -(_e3203);
                            } else {
                                phi_4051_ = _e3203;
                            }
                            let _e3215 = phi_4051_;
                            let _e3229 = (((_e451.member_1[0][0] * _e2130.member_1[0][0]) + (_e451.member_1[0][1] * _e2130.member_1[0][1])) + (_e451.member_1[0][2] * _e2130.member_1[0][2]));
                            let _e3242 = (((_e451.member_1[1][0] * _e2130.member_1[0][0]) + (_e451.member_1[1][1] * _e2130.member_1[0][1])) + (_e451.member_1[1][2] * _e2130.member_1[0][2]));
                            let _e3255 = (((_e451.member_1[2][0] * _e2130.member_1[0][0]) + (_e451.member_1[2][1] * _e2130.member_1[0][1])) + (_e451.member_1[2][2] * _e2130.member_1[0][2]));
                            if (_e3229 < 0f) {
                                phi_4095_ = -(_e3229);
                            } else {
                                phi_4095_ = _e3229;
                            }
                            let _e3260 = phi_4095_;
                            if (_e3242 < 0f) {
                                phi_4101_ = -(_e3242);
                            } else {
                                phi_4101_ = _e3242;
                            }
                            let _e3264 = phi_4101_;
                            if (_e3255 < 0f) {
                                phi_4107_ = -(_e3255);
                            } else {
                                phi_4107_ = _e3255;
                            }
                            let _e3268 = phi_4107_;
                            let _e3290 = (((_e451.member_1[0][0] * _e2130.member_1[1][0]) + (_e451.member_1[0][1] * _e2130.member_1[1][1])) + (_e451.member_1[0][2] * _e2130.member_1[1][2]));
                            let _e3303 = (((_e451.member_1[1][0] * _e2130.member_1[1][0]) + (_e451.member_1[1][1] * _e2130.member_1[1][1])) + (_e451.member_1[1][2] * _e2130.member_1[1][2]));
                            let _e3316 = (((_e451.member_1[2][0] * _e2130.member_1[1][0]) + (_e451.member_1[2][1] * _e2130.member_1[1][1])) + (_e451.member_1[2][2] * _e2130.member_1[1][2]));
                            if (_e3290 < 0f) {
                                phi_4159_ = -(_e3290);
                            } else {
                                phi_4159_ = _e3290;
                            }
                            let _e3321 = phi_4159_;
                            if (_e3303 < 0f) {
                                phi_4165_ = -(_e3303);
                            } else {
                                phi_4165_ = _e3303;
                            }
                            let _e3325 = phi_4165_;
                            if (_e3316 < 0f) {
                                phi_4171_ = -(_e3316);
                            } else {
                                phi_4171_ = _e3316;
                            }
                            let _e3329 = phi_4171_;
                            let _e3351 = (((_e451.member_1[0][0] * _e2130.member_1[2][0]) + (_e451.member_1[0][1] * _e2130.member_1[2][1])) + (_e451.member_1[0][2] * _e2130.member_1[2][2]));
                            let _e3364 = (((_e451.member_1[1][0] * _e2130.member_1[2][0]) + (_e451.member_1[1][1] * _e2130.member_1[2][1])) + (_e451.member_1[1][2] * _e2130.member_1[2][2]));
                            let _e3377 = (((_e451.member_1[2][0] * _e2130.member_1[2][0]) + (_e451.member_1[2][1] * _e2130.member_1[2][1])) + (_e451.member_1[2][2] * _e2130.member_1[2][2]));
                            if (_e3351 < 0f) {
                                phi_4223_ = -(_e3351);
                            } else {
                                phi_4223_ = _e3351;
                            }
                            let _e3382 = phi_4223_;
                            if (_e3364 < 0f) {
                                phi_4229_ = -(_e3364);
                            } else {
                                phi_4229_ = _e3364;
                            }
                            let _e3386 = phi_4229_;
                            if (_e3377 < 0f) {
                                phi_4235_ = -(_e3377);
                            } else {
                                phi_4235_ = _e3377;
                            }
                            let _e3390 = phi_4235_;
                            let _e3405 = (((_e2868 + (((_e2921 * _e313.member_2[0]) + (_e2925 * _e313.member_2[1])) + (_e2929 * _e313.member_2[2]))) + (((((_e2771 * _e2757) + (_e2776 * _e2761)) + (_e2781 * _e2765)) * _e2829) + _e2834)) + _e2724);
                            let _e3406 = (((_e2872 + (((_e2982 * _e313.member_2[0]) + (_e2986 * _e313.member_2[1])) + (_e2990 * _e313.member_2[2]))) + (((((_e2792 * _e2757) + (_e2797 * _e2761)) + (_e2802 * _e2765)) * _e2829) + _e2834)) + _e2725);
                            let _e3407 = (((_e2876 + (((_e3043 * _e313.member_2[0]) + (_e3047 * _e313.member_2[1])) + (_e3051 * _e313.member_2[2]))) + (((((_e2813 * _e2757) + (_e2818 * _e2761)) + (_e2823 * _e2765)) * _e2829) + _e2834)) + _e2726);
                            let _e3408 = (((_e3207 + (((_e3260 * _e451.member_2[0]) + (_e3264 * _e451.member_2[1])) + (_e3268 * _e451.member_2[2]))) + (((((_e3110 * _e3096) + (_e3115 * _e3100)) + (_e3120 * _e3104)) * _e3168) + _e3173)) + _e2724);
                            let _e3409 = (((_e3211 + (((_e3321 * _e451.member_2[0]) + (_e3325 * _e451.member_2[1])) + (_e3329 * _e451.member_2[2]))) + (((((_e3131 * _e3096) + (_e3136 * _e3100)) + (_e3141 * _e3104)) * _e3168) + _e3173)) + _e2725);
                            let _e3410 = (((_e3215 + (((_e3382 * _e451.member_2[0]) + (_e3386 * _e451.member_2[1])) + (_e3390 * _e451.member_2[2]))) + (((((_e3152 * _e3096) + (_e3157 * _e3100)) + (_e3162 * _e3104)) * _e3168) + _e3173)) + _e2726);
                            if ((bitcast<u32>(_e3405) & 2139095040u) != 2139095040u) {
                                if ((bitcast<u32>(_e3406) & 2139095040u) != 2139095040u) {
                                    phi_4271_ = ((bitcast<u32>(_e3407) & 2139095040u) != 2139095040u);
                                    phi_4272_ = false;
                                } else {
                                    phi_4271_ = bool();
                                    phi_4272_ = true;
                                }
                                let _e3421 = phi_4271_;
                                let _e3423 = phi_4272_;
                                phi_4273_ = _e3421;
                                phi_4274_ = _e3423;
                            } else {
                                phi_4273_ = bool();
                                phi_4274_ = true;
                            }
                            let _e3425 = phi_4273_;
                            let _e3427 = phi_4274_;
                            if _e3427 {
                                phi_4278_ = false;
                            } else {
                                phi_4278_ = _e3425;
                            }
                            let _e3429 = phi_4278_;
                            if _e3429 {
                                if ((bitcast<u32>(_e3408) & 2139095040u) != 2139095040u) {
                                    if ((bitcast<u32>(_e3409) & 2139095040u) != 2139095040u) {
                                        phi_4297_ = ((bitcast<u32>(_e3410) & 2139095040u) != 2139095040u);
                                        phi_4298_ = false;
                                    } else {
                                        phi_4297_ = bool();
                                        phi_4298_ = true;
                                    }
                                    let _e3440 = phi_4297_;
                                    let _e3442 = phi_4298_;
                                    phi_4299_ = _e3440;
                                    phi_4300_ = _e3442;
                                } else {
                                    phi_4299_ = bool();
                                    phi_4300_ = true;
                                }
                                let _e3444 = phi_4299_;
                                let _e3446 = phi_4300_;
                                if _e3446 {
                                    phi_4304_ = false;
                                } else {
                                    phi_4304_ = _e3444;
                                }
                                let _e3448 = phi_4304_;
                                if _e3448 {
                                    if (_e3405 > _e3408) {
                                        phi_4312_ = _e3405;
                                    } else {
                                        phi_4312_ = _e3408;
                                    }
                                    let _e3451 = phi_4312_;
                                    if (_e3406 > _e3409) {
                                        phi_4317_ = _e3406;
                                    } else {
                                        phi_4317_ = _e3409;
                                    }
                                    let _e3454 = phi_4317_;
                                    if (_e3407 > _e3410) {
                                        phi_4322_ = _e3407;
                                    } else {
                                        phi_4322_ = _e3410;
                                    }
                                    let _e3457 = phi_4322_;
                                    phi_4325_ = type_33(array<f32, 3>(_e2587, _e2589, _e2591), _e2130.member_1, array<f32, 3>(_e3451, _e3454, _e3457));
                                    phi_4326_ = false;
                                } else {
                                    phi_4325_ = type_33();
                                    phi_4326_ = true;
                                }
                                let _e3461 = phi_4325_;
                                let _e3463 = phi_4326_;
                                phi_4327_ = _e3461;
                                phi_4328_ = _e3463;
                            } else {
                                phi_4327_ = type_33();
                                phi_4328_ = true;
                            }
                            let _e3465 = phi_4327_;
                            let _e3467 = phi_4328_;
                            if _e3467 {
                                if true {
                                    phi_4342_ = 2122317824u;
                                } else {
                                    phi_4342_ = 8388608u;
                                }
                                let _e3469 = phi_4342_;
                                let _e3471 = (bitcast<f32>(_e3469) * 3.9999998f);
                                phi_4352_ = type_33(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3471, _e3471, _e3471));
                            } else {
                                phi_4352_ = _e3465;
                            }
                            let _e3475 = phi_4352_;
                            oriented.member[_e118] = type_29(vec4<f32>(_e3475.member[0], _e3475.member[1], _e3475.member[2], _e3475.member_1[0][0]), vec4<f32>(_e3475.member_1[0][1], _e3475.member_1[0][2], _e3475.member_1[1][0], _e3475.member_1[1][1]), vec4<f32>(_e3475.member_1[1][2], _e3475.member_1[2][0], _e3475.member_1[2][1], _e3475.member_1[2][2]), vec4<f32>(_e3475.member_2[0], _e3475.member_2[1], _e3475.member_2[2], 0f));
                            let _e3504 = atomicMax((&stamps.member[_e118]), _e81);
                        }
                    }
                }
                phi_4384_ = true;
            }
            let _e3506 = phi_4384_;
            phi_4385_ = _e3506;
        } else {
            phi_4385_ = false;
        }
        let _e3508 = phi_4385_;
        continue;
        continuing {
            phi_177_ = _e105;
            break if !(_e3508);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn orient_far(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
