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

struct type_16 {
    member: f32,
    member_1: f32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
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
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> branches: type_23;
@group(0) @binding(2) 
var<storage> block_nodes: type_27;
@group(0) @binding(3) 
var<storage> far: type_11;
@group(0) @binding(4) 
var<storage, read_write> oriented: type_32;
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
    var phi_522_: type_34;
    var phi_594_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_631_: f32;
    var phi_636_: f32;
    var phi_641_: f32;
    var phi_698_: type_34;
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
    var phi_1303_: type_16;
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
    var phi_1595_: type_16;
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
    var phi_1760_: type_16;
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
    var phi_2286_: type_16;
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
    var phi_2029_: type_16;
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
    var phi_4325_: type_34;
    var phi_4326_: bool;
    var phi_4327_: type_34;
    var phi_4328_: bool;
    var phi_4342_: u32;
    var phi_4352_: type_34;
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
                                phi_522_ = type_34(array<f32, 3>(_e278, _e281, _e284), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e294 * _e302) + _e306), ((_e297 * _e302) + _e306), ((_e300 * _e302) + _e306)));
                            } else {
                                let _e188 = params.member.member.member_2[_e178];
                                let _e191 = oriented.member[(_e188 + _e123.x)];
                                phi_522_ = type_34(array<f32, 3>(_e191.member.x, _e191.member.y, _e191.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e191.member.w, _e191.member_1.x, _e191.member_1.y), array<f32, 3>(_e191.member_1.z, _e191.member_1.w, _e191.member_2.x), array<f32, 3>(_e191.member_2.y, _e191.member_2.z, _e191.member_2.w)), array<f32, 3>(_e191.member_3.x, _e191.member_3.y, _e191.member_3.z));
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
                                phi_698_ = type_34(array<f32, 3>(_e416, _e419, _e422), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e432 * _e440) + _e444), ((_e435 * _e440) + _e444), ((_e438 * _e440) + _e444)));
                            } else {
                                let _e326 = params.member.member.member_2[_e316];
                                let _e329 = oriented.member[(_e326 + _e123.y)];
                                phi_698_ = type_34(array<f32, 3>(_e329.member.x, _e329.member.y, _e329.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e329.member.w, _e329.member_1.x, _e329.member_1.y), array<f32, 3>(_e329.member_1.z, _e329.member_1.w, _e329.member_2.x), array<f32, 3>(_e329.member_2.y, _e329.member_2.z, _e329.member_2.w)), array<f32, 3>(_e329.member_3.x, _e329.member_3.y, _e329.member_3.z));
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
                                        phi_1303_ = type_16((_e844 * _e850), (_e845 * _e850));
                                    } else {
                                        phi_1303_ = type_16(1f, 0f);
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
                                                        phi_1595_ = type_16((_e1060 * _e1066), (_e1061 * _e1066));
                                                    } else {
                                                        phi_1595_ = type_16(1f, 0f);
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
                                                        phi_1760_ = type_16((_e1190 * _e1196), (_e1191 * _e1196));
                                                    } else {
                                                        phi_1760_ = type_16(1f, 0f);
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
                                                    let _e1471 = ((_e894.member_1[1] - _e894.member_1[0]) / (_e894.member[0] * 2f));
                                                    let _e1473 = ((_e1471 * _e1471) + 1f);
                                                    if (_e1473 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e1473 > 0f) {
                                                            phi_1855_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_1855_ = 0f;
                                                        }
                                                        let _e1526 = phi_1855_;
                                                        phi_1919_ = _e1526;
                                                    } else {
                                                        phi_1862_ = type_14(0i, 5i);
                                                        phi_1865_ = bitcast<f32>(((bitcast<u32>(_e1473) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1481 = phi_1862_;
                                                            let _e1483 = phi_1865_;
                                                            local_6 = _e1483;
                                                            if (_e1481.member < _e1481.member_1) {
                                                                let _e1490 = (_e1481.member + 1i);
                                                                if ((false == (_e1490 > _e1481.member)) != false) {
                                                                    phi_1886_ = true;
                                                                } else {
                                                                    phi_1886_ = false;
                                                                }
                                                                let _e1495 = phi_1886_;
                                                                if _e1495 {
                                                                    phi_1892_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_1892_ = type_15(1u, _e1490);
                                                                }
                                                                let _e1500 = phi_1892_;
                                                                phi_1863_ = type_14(_e1500.member_1, _e1481.member_1);
                                                                phi_1906_ = type_15(1u, _e1481.member);
                                                            } else {
                                                                phi_1863_ = _e1481;
                                                                phi_1906_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e1506 = phi_1863_;
                                                            let _e1508 = phi_1906_;
                                                            let _e1511 = (bitcast<i32>(_e1508.member) != 0i);
                                                            if _e1511 {
                                                                phi_1866_ = (0.5f * (_e1483 + (_e1473 / _e1483)));
                                                            } else {
                                                                phi_1866_ = f32();
                                                            }
                                                            let _e1516 = phi_1866_;
                                                            continue;
                                                            continuing {
                                                                phi_1862_ = _e1506;
                                                                phi_1865_ = _e1516;
                                                                break if !(_e1511);
                                                            }
                                                        }
                                                        let _e1521 = local_6;
                                                        phi_1919_ = (_e1521 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1528 = phi_1919_;
                                                    if (_e1471 > 0f) {
                                                        phi_1926_ = (_e1471 + _e1528);
                                                    } else {
                                                        phi_1926_ = (_e1471 - _e1528);
                                                    }
                                                    let _e1533 = phi_1926_;
                                                    let _e1536 = (_e894.member_1[1] - (_e894.member_1[0] - (_e894.member[0] / _e1533)));
                                                    let _e1539 = ((_e1536 * _e1536) + (_e894.member[0] * _e894.member[0]));
                                                    if (_e1539 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1539 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1539 > 0f) {
                                                                phi_1953_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1953_ = 0f;
                                                            }
                                                            let _e1596 = phi_1953_;
                                                            phi_2017_ = _e1596;
                                                        } else {
                                                            phi_1960_ = type_14(0i, 5i);
                                                            phi_1963_ = bitcast<f32>(((bitcast<u32>(_e1539) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1551 = phi_1960_;
                                                                let _e1553 = phi_1963_;
                                                                local_7 = _e1553;
                                                                if (_e1551.member < _e1551.member_1) {
                                                                    let _e1560 = (_e1551.member + 1i);
                                                                    if ((false == (_e1560 > _e1551.member)) != false) {
                                                                        phi_1984_ = true;
                                                                    } else {
                                                                        phi_1984_ = false;
                                                                    }
                                                                    let _e1565 = phi_1984_;
                                                                    if _e1565 {
                                                                        phi_1990_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1990_ = type_15(1u, _e1560);
                                                                    }
                                                                    let _e1570 = phi_1990_;
                                                                    phi_1961_ = type_14(_e1570.member_1, _e1551.member_1);
                                                                    phi_2004_ = type_15(1u, _e1551.member);
                                                                } else {
                                                                    phi_1961_ = _e1551;
                                                                    phi_2004_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1576 = phi_1961_;
                                                                let _e1578 = phi_2004_;
                                                                let _e1581 = (bitcast<i32>(_e1578.member) != 0i);
                                                                if _e1581 {
                                                                    phi_1964_ = (0.5f * (_e1553 + (_e1539 / _e1553)));
                                                                } else {
                                                                    phi_1964_ = f32();
                                                                }
                                                                let _e1586 = phi_1964_;
                                                                continue;
                                                                continuing {
                                                                    phi_1960_ = _e1576;
                                                                    phi_1963_ = _e1586;
                                                                    break if !(_e1581);
                                                                }
                                                            }
                                                            let _e1591 = local_7;
                                                            phi_2017_ = (_e1591 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1598 = phi_2017_;
                                                        let _e1599 = (_e1536 / _e1598);
                                                        let _e1600 = (_e894.member[0] / _e1598);
                                                        let _e1605 = (1.5f - (((_e1599 * _e1599) + (_e1600 * _e1600)) * 0.5f));
                                                        phi_2029_ = type_16((_e1599 * _e1605), (_e1600 * _e1605));
                                                    } else {
                                                        phi_2029_ = type_16(1f, 0f);
                                                    }
                                                    let _e1610 = phi_2029_;
                                                    let _e1627 = (((_e894.member_1[0] - _e894.member_1[1]) * _e1610.member_1) + ((_e1610.member * _e894.member[0]) * 2f));
                                                    let _e1637 = type_36(_e894.member, array<f32, 3>((_e894.member_1[0] - (_e1610.member_1 * _e1627)), (_e894.member_1[1] + (_e1610.member_1 * _e1627)), _e894.member_1[2]), _e894.member_2);
                                                    let _e1643 = type_36(array<f32, 2>(((_e1610.member * _e1627) - _e894.member[0]), _e1637.member[1]), _e1637.member_1, _e1637.member_2);
                                                    phi_2349_ = type_36(_e1643.member, _e1643.member_1, array<array<f32, 3>, 3>(array<f32, 3>(((_e894.member_2[0][0] * _e1610.member) - (_e894.member_2[1][0] * _e1610.member_1)), ((_e894.member_2[0][1] * _e1610.member) - (_e894.member_2[1][1] * _e1610.member_1)), ((_e894.member_2[0][2] * _e1610.member) - (_e894.member_2[1][2] * _e1610.member_1))), array<f32, 3>(((_e894.member_2[0][0] * _e1610.member_1) + (_e894.member_2[1][0] * _e1610.member)), ((_e894.member_2[0][1] * _e1610.member_1) + (_e894.member_2[1][1] * _e1610.member)), ((_e894.member_2[0][2] * _e1610.member_1) + (_e894.member_2[1][2] * _e1610.member))), _e894.member_2[2]));
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
                                                            phi_2286_ = type_16((_e1386 * _e1392), (_e1387 * _e1392));
                                                        } else {
                                                            phi_2286_ = type_16(1f, 0f);
                                                        }
                                                        let _e1397 = phi_2286_;
                                                        let _e1414 = (((_e894.member_1[1] - _e894.member_1[2]) * _e1397.member_1) + ((_e1397.member * _e894.member[1]) * 2f));
                                                        let _e1424 = type_36(_e894.member, array<f32, 3>(_e894.member_1[0], (_e894.member_1[1] - (_e1397.member_1 * _e1414)), (_e894.member_1[2] + (_e1397.member_1 * _e1414))), _e894.member_2);
                                                        let _e1430 = type_36(array<f32, 2>(_e1424.member[0], ((_e1397.member * _e1414) - _e894.member[1])), _e1424.member_1, _e1424.member_2);
                                                        phi_2348_ = type_36(_e1430.member, _e1430.member_1, array<array<f32, 3>, 3>(_e894.member_2[0], array<f32, 3>(((_e894.member_2[1][0] * _e1397.member) - (_e894.member_2[2][0] * _e1397.member_1)), ((_e894.member_2[1][1] * _e1397.member) - (_e894.member_2[2][1] * _e1397.member_1)), ((_e894.member_2[1][2] * _e1397.member) - (_e894.member_2[2][2] * _e1397.member_1))), array<f32, 3>(((_e894.member_2[1][0] * _e1397.member_1) + (_e894.member_2[2][0] * _e1397.member)), ((_e894.member_2[1][1] * _e1397.member_1) + (_e894.member_2[2][1] * _e1397.member)), ((_e894.member_2[1][2] * _e1397.member_1) + (_e894.member_2[2][2] * _e1397.member)))));
                                                    } else {
                                                        phi_2348_ = _e894;
                                                    }
                                                    let _e1468 = phi_2348_;
                                                    phi_2349_ = _e1468;
                                                }
                                                let _e1681 = phi_2349_;
                                                phi_2350_ = _e1681;
                                            } else {
                                                phi_2350_ = _e1253;
                                            }
                                            let _e1683 = phi_2350_;
                                            if _e924 {
                                                phi_2354_ = true;
                                            } else {
                                                phi_2354_ = _e929;
                                            }
                                            let _e1685 = phi_2354_;
                                            if _e1685 {
                                                phi_2358_ = false;
                                            } else {
                                                phi_2358_ = true;
                                            }
                                            let _e1687 = phi_2358_;
                                            phi_1346_ = _e1683;
                                            phi_2359_ = _e1683;
                                            phi_2360_ = _e1685;
                                            phi_2361_ = _e1687;
                                        } else {
                                            phi_1346_ = type_36();
                                            phi_2359_ = type_36();
                                            phi_2360_ = false;
                                            phi_2361_ = false;
                                        }
                                        let _e1689 = phi_1346_;
                                        let _e1691 = phi_2359_;
                                        let _e1693 = phi_2360_;
                                        let _e1695 = phi_2361_;
                                        local_8 = _e1695;
                                        local_9 = _e1691;
                                        continue;
                                        continuing {
                                            phi_1342_ = _e906;
                                            phi_1345_ = _e1689;
                                            break if !(_e1693);
                                        }
                                    }
                                    let _e1698 = local_8;
                                    if _e1698 {
                                        let _e3627 = local_9;
                                        phi_2365_ = _e3627;
                                    } else {
                                        let _e3629 = local_10;
                                        phi_2365_ = _e3629;
                                    }
                                    let _e1700 = phi_2365_;
                                    let _e1704 = (2130706432u - (bitcast<u32>(_e775) & 2139095040u));
                                    if (_e1704 > 8388608u) {
                                        phi_2377_ = _e1704;
                                    } else {
                                        phi_2377_ = 8388608u;
                                    }
                                    let _e1707 = phi_2377_;
                                    let _e1708 = bitcast<f32>(_e1707);
                                    let _e1730 = ((((_e1700.member_2[0][0] * _e1700.member_2[0][0]) + (_e1700.member_2[0][1] * _e1700.member_2[0][1])) + (_e1700.member_2[0][2] * _e1700.member_2[0][2])) - 1f);
                                    let _e1744 = ((((_e1700.member_2[1][0] * _e1700.member_2[1][0]) + (_e1700.member_2[1][1] * _e1700.member_2[1][1])) + (_e1700.member_2[1][2] * _e1700.member_2[1][2])) - 1f);
                                    let _e1758 = ((((_e1700.member_2[2][0] * _e1700.member_2[2][0]) + (_e1700.member_2[2][1] * _e1700.member_2[2][1])) + (_e1700.member_2[2][2] * _e1700.member_2[2][2])) - 1f);
                                    let _e1771 = (((_e1700.member_2[0][0] * _e1700.member_2[1][0]) + (_e1700.member_2[0][1] * _e1700.member_2[1][1])) + (_e1700.member_2[0][2] * _e1700.member_2[1][2]));
                                    let _e1784 = (((_e1700.member_2[0][0] * _e1700.member_2[2][0]) + (_e1700.member_2[0][1] * _e1700.member_2[2][1])) + (_e1700.member_2[0][2] * _e1700.member_2[2][2]));
                                    let _e1797 = (((_e1700.member_2[1][0] * _e1700.member_2[2][0]) + (_e1700.member_2[1][1] * _e1700.member_2[2][1])) + (_e1700.member_2[1][2] * _e1700.member_2[2][2]));
                                    let _e1830 = (_e1700.member_2[0][0] - ((((_e1700.member_2[0][0] * _e1730) + (_e1700.member_2[1][0] * _e1771)) + (_e1700.member_2[2][0] * _e1784)) * 0.5f));
                                    let _e1832 = (_e1700.member_2[0][1] - ((((_e1700.member_2[0][1] * _e1730) + (_e1700.member_2[1][1] * _e1771)) + (_e1700.member_2[2][1] * _e1784)) * 0.5f));
                                    let _e1834 = (_e1700.member_2[0][2] - ((((_e1700.member_2[0][2] * _e1730) + (_e1700.member_2[1][2] * _e1771)) + (_e1700.member_2[2][2] * _e1784)) * 0.5f));
                                    if (_e1830 < 0f) {
                                        phi_2510_ = -(_e1830);
                                    } else {
                                        phi_2510_ = _e1830;
                                    }
                                    let _e1838 = phi_2510_;
                                    if (_e1838 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2516_ = _e1830;
                                    } else {
                                        phi_2516_ = 0f;
                                    }
                                    let _e1842 = phi_2516_;
                                    if (_e1832 < 0f) {
                                        phi_2522_ = -(_e1832);
                                    } else {
                                        phi_2522_ = _e1832;
                                    }
                                    let _e1846 = phi_2522_;
                                    if (_e1846 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2528_ = _e1832;
                                    } else {
                                        phi_2528_ = 0f;
                                    }
                                    let _e1850 = phi_2528_;
                                    if (_e1834 < 0f) {
                                        phi_2534_ = -(_e1834);
                                    } else {
                                        phi_2534_ = _e1834;
                                    }
                                    let _e1854 = phi_2534_;
                                    if (_e1854 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2540_ = _e1834;
                                    } else {
                                        phi_2540_ = 0f;
                                    }
                                    let _e1858 = phi_2540_;
                                    let _e1892 = (_e1700.member_2[1][0] - ((((_e1700.member_2[0][0] * _e1771) + (_e1700.member_2[1][0] * _e1744)) + (_e1700.member_2[2][0] * _e1797)) * 0.5f));
                                    let _e1894 = (_e1700.member_2[1][1] - ((((_e1700.member_2[0][1] * _e1771) + (_e1700.member_2[1][1] * _e1744)) + (_e1700.member_2[2][1] * _e1797)) * 0.5f));
                                    let _e1896 = (_e1700.member_2[1][2] - ((((_e1700.member_2[0][2] * _e1771) + (_e1700.member_2[1][2] * _e1744)) + (_e1700.member_2[2][2] * _e1797)) * 0.5f));
                                    if (_e1892 < 0f) {
                                        phi_2584_ = -(_e1892);
                                    } else {
                                        phi_2584_ = _e1892;
                                    }
                                    let _e1900 = phi_2584_;
                                    if (_e1900 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2590_ = _e1892;
                                    } else {
                                        phi_2590_ = 0f;
                                    }
                                    let _e1904 = phi_2590_;
                                    if (_e1894 < 0f) {
                                        phi_2596_ = -(_e1894);
                                    } else {
                                        phi_2596_ = _e1894;
                                    }
                                    let _e1908 = phi_2596_;
                                    if (_e1908 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2602_ = _e1894;
                                    } else {
                                        phi_2602_ = 0f;
                                    }
                                    let _e1912 = phi_2602_;
                                    if (_e1896 < 0f) {
                                        phi_2608_ = -(_e1896);
                                    } else {
                                        phi_2608_ = _e1896;
                                    }
                                    let _e1916 = phi_2608_;
                                    if (_e1916 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2614_ = _e1896;
                                    } else {
                                        phi_2614_ = 0f;
                                    }
                                    let _e1920 = phi_2614_;
                                    let _e1954 = (_e1700.member_2[2][0] - ((((_e1700.member_2[0][0] * _e1784) + (_e1700.member_2[1][0] * _e1797)) + (_e1700.member_2[2][0] * _e1758)) * 0.5f));
                                    let _e1956 = (_e1700.member_2[2][1] - ((((_e1700.member_2[0][1] * _e1784) + (_e1700.member_2[1][1] * _e1797)) + (_e1700.member_2[2][1] * _e1758)) * 0.5f));
                                    let _e1958 = (_e1700.member_2[2][2] - ((((_e1700.member_2[0][2] * _e1784) + (_e1700.member_2[1][2] * _e1797)) + (_e1700.member_2[2][2] * _e1758)) * 0.5f));
                                    if (_e1954 < 0f) {
                                        phi_2658_ = -(_e1954);
                                    } else {
                                        phi_2658_ = _e1954;
                                    }
                                    let _e1962 = phi_2658_;
                                    if (_e1962 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2664_ = _e1954;
                                    } else {
                                        phi_2664_ = 0f;
                                    }
                                    let _e1966 = phi_2664_;
                                    if (_e1956 < 0f) {
                                        phi_2670_ = -(_e1956);
                                    } else {
                                        phi_2670_ = _e1956;
                                    }
                                    let _e1970 = phi_2670_;
                                    if (_e1970 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2676_ = _e1956;
                                    } else {
                                        phi_2676_ = 0f;
                                    }
                                    let _e1974 = phi_2676_;
                                    if (_e1958 < 0f) {
                                        phi_2682_ = -(_e1958);
                                    } else {
                                        phi_2682_ = _e1958;
                                    }
                                    let _e1978 = phi_2682_;
                                    if (_e1978 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2688_ = _e1958;
                                    } else {
                                        phi_2688_ = 0f;
                                    }
                                    let _e1982 = phi_2688_;
                                    let _e1990 = ((((_e1842 * _e1842) + (_e1850 * _e1850)) + (_e1858 * _e1858)) - 1f);
                                    let _e1996 = ((((_e1904 * _e1904) + (_e1912 * _e1912)) + (_e1920 * _e1920)) - 1f);
                                    let _e2002 = ((((_e1966 * _e1966) + (_e1974 * _e1974)) + (_e1982 * _e1982)) - 1f);
                                    let _e2007 = (((_e1842 * _e1904) + (_e1850 * _e1912)) + (_e1858 * _e1920));
                                    let _e2012 = (((_e1842 * _e1966) + (_e1850 * _e1974)) + (_e1858 * _e1982));
                                    let _e2017 = (((_e1904 * _e1966) + (_e1912 * _e1974)) + (_e1920 * _e1982));
                                    if (_e1990 < 0f) {
                                        phi_2729_ = -(_e1990);
                                    } else {
                                        phi_2729_ = _e1990;
                                    }
                                    let _e2021 = phi_2729_;
                                    if (_e1996 < 0f) {
                                        phi_2735_ = -(_e1996);
                                    } else {
                                        phi_2735_ = _e1996;
                                    }
                                    let _e2025 = phi_2735_;
                                    if (_e2021 > _e2025) {
                                        phi_2740_ = _e2021;
                                    } else {
                                        phi_2740_ = _e2025;
                                    }
                                    let _e2028 = phi_2740_;
                                    if (_e2002 < 0f) {
                                        phi_2746_ = -(_e2002);
                                    } else {
                                        phi_2746_ = _e2002;
                                    }
                                    let _e2032 = phi_2746_;
                                    if (_e2028 > _e2032) {
                                        phi_2751_ = _e2028;
                                    } else {
                                        phi_2751_ = _e2032;
                                    }
                                    let _e2035 = phi_2751_;
                                    if (_e2007 < 0f) {
                                        phi_2757_ = -(_e2007);
                                    } else {
                                        phi_2757_ = _e2007;
                                    }
                                    let _e2039 = phi_2757_;
                                    if (_e2012 < 0f) {
                                        phi_2763_ = -(_e2012);
                                    } else {
                                        phi_2763_ = _e2012;
                                    }
                                    let _e2043 = phi_2763_;
                                    if (_e2039 > _e2043) {
                                        phi_2768_ = _e2039;
                                    } else {
                                        phi_2768_ = _e2043;
                                    }
                                    let _e2046 = phi_2768_;
                                    if (_e2017 < 0f) {
                                        phi_2774_ = -(_e2017);
                                    } else {
                                        phi_2774_ = _e2017;
                                    }
                                    let _e2050 = phi_2774_;
                                    if (_e2046 > _e2050) {
                                        phi_2779_ = _e2046;
                                    } else {
                                        phi_2779_ = _e2050;
                                    }
                                    let _e2053 = phi_2779_;
                                    if (_e2035 > _e2053) {
                                        phi_2784_ = _e2035;
                                    } else {
                                        phi_2784_ = _e2053;
                                    }
                                    let _e2056 = phi_2784_;
                                    if (_e2056 <= (0.000000059604645f * (16f - 6f))) {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1842, _e1850, _e1858), array<f32, 3>(_e1904, _e1912, _e1920), array<f32, 3>(_e1966, _e1974, _e1982));
                                    } else {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                                    }
                                    let _e2061 = phi_2795_;
                                    phi_2797_ = type_37(array<f32, 3>((_e1700.member_1[0] * _e1708), (_e1700.member_1[1] * _e1708), (_e1700.member_1[2] * _e1708)), _e2061);
                                    phi_2798_ = false;
                                } else {
                                    phi_2797_ = type_37();
                                    phi_2798_ = true;
                                }
                                let _e2064 = phi_2797_;
                                let _e2066 = phi_2798_;
                                phi_2799_ = _e2064;
                                phi_2800_ = _e2066;
                            } else {
                                phi_2799_ = type_37();
                                phi_2800_ = true;
                            }
                            let _e2068 = phi_2799_;
                            let _e2070 = phi_2800_;
                            if _e2070 {
                                phi_2813_ = type_37(array<f32, 3>(_e717, _e721, _e725), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                            } else {
                                phi_2813_ = _e2068;
                            }
                            let _e2074 = phi_2813_;
                            let _e2089 = (((_e313.member_1[0][0] * _e2074.member_1[0][0]) + (_e313.member_1[0][1] * _e2074.member_1[0][1])) + (_e313.member_1[0][2] * _e2074.member_1[0][2]));
                            let _e2102 = (((_e313.member_1[1][0] * _e2074.member_1[0][0]) + (_e313.member_1[1][1] * _e2074.member_1[0][1])) + (_e313.member_1[1][2] * _e2074.member_1[0][2]));
                            let _e2115 = (((_e313.member_1[2][0] * _e2074.member_1[0][0]) + (_e313.member_1[2][1] * _e2074.member_1[0][1])) + (_e313.member_1[2][2] * _e2074.member_1[0][2]));
                            if (_e2089 < 0f) {
                                phi_2858_ = -(_e2089);
                            } else {
                                phi_2858_ = _e2089;
                            }
                            let _e2120 = phi_2858_;
                            if (_e2102 < 0f) {
                                phi_2864_ = -(_e2102);
                            } else {
                                phi_2864_ = _e2102;
                            }
                            let _e2124 = phi_2864_;
                            if (_e2115 < 0f) {
                                phi_2870_ = -(_e2115);
                            } else {
                                phi_2870_ = _e2115;
                            }
                            let _e2128 = phi_2870_;
                            let _e2136 = (((_e2120 * _e313.member_2[0]) + (_e2124 * _e313.member_2[1])) + (_e2128 * _e313.member_2[2]));
                            let _e2150 = (((_e313.member_1[0][0] * _e2074.member_1[1][0]) + (_e313.member_1[0][1] * _e2074.member_1[1][1])) + (_e313.member_1[0][2] * _e2074.member_1[1][2]));
                            let _e2163 = (((_e313.member_1[1][0] * _e2074.member_1[1][0]) + (_e313.member_1[1][1] * _e2074.member_1[1][1])) + (_e313.member_1[1][2] * _e2074.member_1[1][2]));
                            let _e2176 = (((_e313.member_1[2][0] * _e2074.member_1[1][0]) + (_e313.member_1[2][1] * _e2074.member_1[1][1])) + (_e313.member_1[2][2] * _e2074.member_1[1][2]));
                            if (_e2150 < 0f) {
                                phi_2922_ = -(_e2150);
                            } else {
                                phi_2922_ = _e2150;
                            }
                            let _e2181 = phi_2922_;
                            if (_e2163 < 0f) {
                                phi_2928_ = -(_e2163);
                            } else {
                                phi_2928_ = _e2163;
                            }
                            let _e2185 = phi_2928_;
                            if (_e2176 < 0f) {
                                phi_2934_ = -(_e2176);
                            } else {
                                phi_2934_ = _e2176;
                            }
                            let _e2189 = phi_2934_;
                            let _e2197 = (((_e2181 * _e313.member_2[0]) + (_e2185 * _e313.member_2[1])) + (_e2189 * _e313.member_2[2]));
                            let _e2211 = (((_e313.member_1[0][0] * _e2074.member_1[2][0]) + (_e313.member_1[0][1] * _e2074.member_1[2][1])) + (_e313.member_1[0][2] * _e2074.member_1[2][2]));
                            let _e2224 = (((_e313.member_1[1][0] * _e2074.member_1[2][0]) + (_e313.member_1[1][1] * _e2074.member_1[2][1])) + (_e313.member_1[1][2] * _e2074.member_1[2][2]));
                            let _e2237 = (((_e313.member_1[2][0] * _e2074.member_1[2][0]) + (_e313.member_1[2][1] * _e2074.member_1[2][1])) + (_e313.member_1[2][2] * _e2074.member_1[2][2]));
                            if (_e2211 < 0f) {
                                phi_2986_ = -(_e2211);
                            } else {
                                phi_2986_ = _e2211;
                            }
                            let _e2242 = phi_2986_;
                            if (_e2224 < 0f) {
                                phi_2992_ = -(_e2224);
                            } else {
                                phi_2992_ = _e2224;
                            }
                            let _e2246 = phi_2992_;
                            if (_e2237 < 0f) {
                                phi_2998_ = -(_e2237);
                            } else {
                                phi_2998_ = _e2237;
                            }
                            let _e2250 = phi_2998_;
                            let _e2258 = (((_e2242 * _e313.member_2[0]) + (_e2246 * _e313.member_2[1])) + (_e2250 * _e313.member_2[2]));
                            let _e2272 = (((_e451.member_1[0][0] * _e2074.member_1[0][0]) + (_e451.member_1[0][1] * _e2074.member_1[0][1])) + (_e451.member_1[0][2] * _e2074.member_1[0][2]));
                            let _e2285 = (((_e451.member_1[1][0] * _e2074.member_1[0][0]) + (_e451.member_1[1][1] * _e2074.member_1[0][1])) + (_e451.member_1[1][2] * _e2074.member_1[0][2]));
                            let _e2298 = (((_e451.member_1[2][0] * _e2074.member_1[0][0]) + (_e451.member_1[2][1] * _e2074.member_1[0][1])) + (_e451.member_1[2][2] * _e2074.member_1[0][2]));
                            if (_e2272 < 0f) {
                                phi_3050_ = -(_e2272);
                            } else {
                                phi_3050_ = _e2272;
                            }
                            let _e2303 = phi_3050_;
                            if (_e2285 < 0f) {
                                phi_3056_ = -(_e2285);
                            } else {
                                phi_3056_ = _e2285;
                            }
                            let _e2307 = phi_3056_;
                            if (_e2298 < 0f) {
                                phi_3062_ = -(_e2298);
                            } else {
                                phi_3062_ = _e2298;
                            }
                            let _e2311 = phi_3062_;
                            let _e2319 = (((_e2303 * _e451.member_2[0]) + (_e2307 * _e451.member_2[1])) + (_e2311 * _e451.member_2[2]));
                            let _e2333 = (((_e451.member_1[0][0] * _e2074.member_1[1][0]) + (_e451.member_1[0][1] * _e2074.member_1[1][1])) + (_e451.member_1[0][2] * _e2074.member_1[1][2]));
                            let _e2346 = (((_e451.member_1[1][0] * _e2074.member_1[1][0]) + (_e451.member_1[1][1] * _e2074.member_1[1][1])) + (_e451.member_1[1][2] * _e2074.member_1[1][2]));
                            let _e2359 = (((_e451.member_1[2][0] * _e2074.member_1[1][0]) + (_e451.member_1[2][1] * _e2074.member_1[1][1])) + (_e451.member_1[2][2] * _e2074.member_1[1][2]));
                            if (_e2333 < 0f) {
                                phi_3114_ = -(_e2333);
                            } else {
                                phi_3114_ = _e2333;
                            }
                            let _e2364 = phi_3114_;
                            if (_e2346 < 0f) {
                                phi_3120_ = -(_e2346);
                            } else {
                                phi_3120_ = _e2346;
                            }
                            let _e2368 = phi_3120_;
                            if (_e2359 < 0f) {
                                phi_3126_ = -(_e2359);
                            } else {
                                phi_3126_ = _e2359;
                            }
                            let _e2372 = phi_3126_;
                            let _e2380 = (((_e2364 * _e451.member_2[0]) + (_e2368 * _e451.member_2[1])) + (_e2372 * _e451.member_2[2]));
                            let _e2394 = (((_e451.member_1[0][0] * _e2074.member_1[2][0]) + (_e451.member_1[0][1] * _e2074.member_1[2][1])) + (_e451.member_1[0][2] * _e2074.member_1[2][2]));
                            let _e2407 = (((_e451.member_1[1][0] * _e2074.member_1[2][0]) + (_e451.member_1[1][1] * _e2074.member_1[2][1])) + (_e451.member_1[1][2] * _e2074.member_1[2][2]));
                            let _e2420 = (((_e451.member_1[2][0] * _e2074.member_1[2][0]) + (_e451.member_1[2][1] * _e2074.member_1[2][1])) + (_e451.member_1[2][2] * _e2074.member_1[2][2]));
                            if (_e2394 < 0f) {
                                phi_3178_ = -(_e2394);
                            } else {
                                phi_3178_ = _e2394;
                            }
                            let _e2425 = phi_3178_;
                            if (_e2407 < 0f) {
                                phi_3184_ = -(_e2407);
                            } else {
                                phi_3184_ = _e2407;
                            }
                            let _e2429 = phi_3184_;
                            if (_e2420 < 0f) {
                                phi_3190_ = -(_e2420);
                            } else {
                                phi_3190_ = _e2420;
                            }
                            let _e2433 = phi_3190_;
                            let _e2441 = (((_e2425 * _e451.member_2[0]) + (_e2429 * _e451.member_2[1])) + (_e2433 * _e451.member_2[2]));
                            let _e2450 = (((_e2074.member_1[0][0] * _e456) + (_e2074.member_1[0][1] * _e459)) + (_e2074.member_1[0][2] * _e462));
                            let _e2459 = (((_e2074.member_1[1][0] * _e456) + (_e2074.member_1[1][1] * _e459)) + (_e2074.member_1[1][2] * _e462));
                            let _e2468 = (((_e2074.member_1[2][0] * _e456) + (_e2074.member_1[2][1] * _e459)) + (_e2074.member_1[2][2] * _e462));
                            let _e2469 = (_e2136 * -1f);
                            let _e2470 = (_e2197 * -1f);
                            let _e2471 = (_e2258 * -1f);
                            let _e2472 = (_e2450 - _e2319);
                            let _e2473 = (_e2459 - _e2380);
                            let _e2474 = (_e2468 - _e2441);
                            if (_e2469 < _e2472) {
                                phi_3236_ = _e2469;
                            } else {
                                phi_3236_ = _e2472;
                            }
                            let _e2477 = phi_3236_;
                            if (_e2470 < _e2473) {
                                phi_3241_ = _e2470;
                            } else {
                                phi_3241_ = _e2473;
                            }
                            let _e2480 = phi_3241_;
                            if (_e2471 < _e2474) {
                                phi_3246_ = _e2471;
                            } else {
                                phi_3246_ = _e2474;
                            }
                            let _e2483 = phi_3246_;
                            let _e2484 = (_e2450 + _e2319);
                            let _e2485 = (_e2459 + _e2380);
                            let _e2486 = (_e2468 + _e2441);
                            if (_e2136 > _e2484) {
                                phi_3254_ = _e2136;
                            } else {
                                phi_3254_ = _e2484;
                            }
                            let _e2489 = phi_3254_;
                            if (_e2197 > _e2485) {
                                phi_3259_ = _e2197;
                            } else {
                                phi_3259_ = _e2485;
                            }
                            let _e2492 = phi_3259_;
                            if (_e2258 > _e2486) {
                                phi_3264_ = _e2258;
                            } else {
                                phi_3264_ = _e2486;
                            }
                            let _e2495 = phi_3264_;
                            let _e2500 = ((_e2477 + _e2489) * 0.5f);
                            let _e2501 = ((_e2480 + _e2492) * 0.5f);
                            let _e2502 = ((_e2483 + _e2495) * 0.5f);
                            let _e2531 = (_e313.member[0] + (((_e2074.member_1[0][0] * _e2500) + (_e2074.member_1[1][0] * _e2501)) + (_e2074.member_1[2][0] * _e2502)));
                            let _e2533 = (_e313.member[1] + (((_e2074.member_1[0][1] * _e2500) + (_e2074.member_1[1][1] * _e2501)) + (_e2074.member_1[2][1] * _e2502)));
                            let _e2535 = (_e313.member[2] + (((_e2074.member_1[0][2] * _e2500) + (_e2074.member_1[1][2] * _e2501)) + (_e2074.member_1[2][2] * _e2502)));
                            if (_e313.member[0] < 0f) {
                                phi_3313_ = -(_e313.member[0]);
                            } else {
                                phi_3313_ = _e313.member[0];
                            }
                            let _e2542 = phi_3313_;
                            if (_e313.member[1] < 0f) {
                                phi_3320_ = -(_e313.member[1]);
                            } else {
                                phi_3320_ = _e313.member[1];
                            }
                            let _e2547 = phi_3320_;
                            if (_e313.member[2] < 0f) {
                                phi_3327_ = -(_e313.member[2]);
                            } else {
                                phi_3327_ = _e313.member[2];
                            }
                            let _e2552 = phi_3327_;
                            if (_e451.member[0] < 0f) {
                                phi_3335_ = -(_e451.member[0]);
                            } else {
                                phi_3335_ = _e451.member[0];
                            }
                            let _e2558 = phi_3335_;
                            if (_e451.member[1] < 0f) {
                                phi_3342_ = -(_e451.member[1]);
                            } else {
                                phi_3342_ = _e451.member[1];
                            }
                            let _e2563 = phi_3342_;
                            if (_e451.member[2] < 0f) {
                                phi_3349_ = -(_e451.member[2]);
                            } else {
                                phi_3349_ = _e451.member[2];
                            }
                            let _e2568 = phi_3349_;
                            if (_e2542 > _e2558) {
                                phi_3354_ = _e2542;
                            } else {
                                phi_3354_ = _e2558;
                            }
                            let _e2571 = phi_3354_;
                            if (_e2547 > _e2563) {
                                phi_3359_ = _e2547;
                            } else {
                                phi_3359_ = _e2563;
                            }
                            let _e2574 = phi_3359_;
                            if (_e2552 > _e2568) {
                                phi_3364_ = _e2552;
                            } else {
                                phi_3364_ = _e2568;
                            }
                            let _e2577 = phi_3364_;
                            let _e2580 = (_e313.member[0] - _e2531);
                            let _e2582 = (_e313.member[1] - _e2533);
                            let _e2584 = (_e313.member[2] - _e2535);
                            if (_e2580 < 0f) {
                                phi_3377_ = -(_e2580);
                            } else {
                                phi_3377_ = _e2580;
                            }
                            let _e2588 = phi_3377_;
                            if (_e2582 < 0f) {
                                phi_3383_ = -(_e2582);
                            } else {
                                phi_3383_ = _e2582;
                            }
                            let _e2592 = phi_3383_;
                            if (_e2584 < 0f) {
                                phi_3390_ = -(_e2584);
                            } else {
                                phi_3390_ = _e2584;
                            }
                            let _e2597 = phi_3390_;
                            let _e2600 = (((_e2588 + _e2592) + _e2597) * (0.000000059604645f * 16f));
                            if (_e2074.member_1[0][0] < 0f) {
                                phi_3401_ = -(_e2074.member_1[0][0]);
                            } else {
                                phi_3401_ = _e2074.member_1[0][0];
                            }
                            let _e2606 = phi_3401_;
                            if (_e2074.member_1[0][1] < 0f) {
                                phi_3408_ = -(_e2074.member_1[0][1]);
                            } else {
                                phi_3408_ = _e2074.member_1[0][1];
                            }
                            let _e2611 = phi_3408_;
                            if (_e2074.member_1[0][2] < 0f) {
                                phi_3415_ = -(_e2074.member_1[0][2]);
                            } else {
                                phi_3415_ = _e2074.member_1[0][2];
                            }
                            let _e2616 = phi_3415_;
                            if (_e2074.member_1[1][0] < 0f) {
                                phi_3428_ = -(_e2074.member_1[1][0]);
                            } else {
                                phi_3428_ = _e2074.member_1[1][0];
                            }
                            let _e2627 = phi_3428_;
                            if (_e2074.member_1[1][1] < 0f) {
                                phi_3435_ = -(_e2074.member_1[1][1]);
                            } else {
                                phi_3435_ = _e2074.member_1[1][1];
                            }
                            let _e2632 = phi_3435_;
                            if (_e2074.member_1[1][2] < 0f) {
                                phi_3442_ = -(_e2074.member_1[1][2]);
                            } else {
                                phi_3442_ = _e2074.member_1[1][2];
                            }
                            let _e2637 = phi_3442_;
                            if (_e2074.member_1[2][0] < 0f) {
                                phi_3455_ = -(_e2074.member_1[2][0]);
                            } else {
                                phi_3455_ = _e2074.member_1[2][0];
                            }
                            let _e2648 = phi_3455_;
                            if (_e2074.member_1[2][1] < 0f) {
                                phi_3462_ = -(_e2074.member_1[2][1]);
                            } else {
                                phi_3462_ = _e2074.member_1[2][1];
                            }
                            let _e2653 = phi_3462_;
                            if (_e2074.member_1[2][2] < 0f) {
                                phi_3469_ = -(_e2074.member_1[2][2]);
                            } else {
                                phi_3469_ = _e2074.member_1[2][2];
                            }
                            let _e2658 = phi_3469_;
                            let _e2664 = (0.000000059604645f * 12f);
                            let _e2668 = (((((_e2606 * _e2571) + (_e2611 * _e2574)) + (_e2616 * _e2577)) * _e2664) + _e2600);
                            let _e2669 = (((((_e2627 * _e2571) + (_e2632 * _e2574)) + (_e2637 * _e2577)) * _e2664) + _e2600);
                            let _e2670 = (((((_e2648 * _e2571) + (_e2653 * _e2574)) + (_e2658 * _e2577)) * _e2664) + _e2600);
                            let _e2673 = (_e313.member[0] - _e2531);
                            let _e2675 = (_e313.member[1] - _e2533);
                            let _e2677 = (_e313.member[2] - _e2535);
                            if (_e313.member_2[0] < 0f) {
                                phi_3496_ = -(_e313.member_2[0]);
                            } else {
                                phi_3496_ = _e313.member_2[0];
                            }
                            let _e2683 = phi_3496_;
                            if (_e313.member_2[1] < 0f) {
                                phi_3503_ = -(_e313.member_2[1]);
                            } else {
                                phi_3503_ = _e313.member_2[1];
                            }
                            let _e2688 = phi_3503_;
                            if (_e313.member_2[2] < 0f) {
                                phi_3511_ = -(_e313.member_2[2]);
                            } else {
                                phi_3511_ = _e313.member_2[2];
                            }
                            let _e2694 = phi_3511_;
                            if (_e2673 < 0f) {
                                phi_3520_ = -(_e2673);
                            } else {
                                phi_3520_ = _e2673;
                            }
                            let _e2701 = phi_3520_;
                            if (_e2675 < 0f) {
                                phi_3526_ = -(_e2675);
                            } else {
                                phi_3526_ = _e2675;
                            }
                            let _e2705 = phi_3526_;
                            if (_e2677 < 0f) {
                                phi_3532_ = -(_e2677);
                            } else {
                                phi_3532_ = _e2677;
                            }
                            let _e2709 = phi_3532_;
                            if (_e2074.member_1[0][0] < 0f) {
                                phi_3540_ = -(_e2074.member_1[0][0]);
                            } else {
                                phi_3540_ = _e2074.member_1[0][0];
                            }
                            let _e2715 = phi_3540_;
                            if (_e2074.member_1[0][1] < 0f) {
                                phi_3547_ = -(_e2074.member_1[0][1]);
                            } else {
                                phi_3547_ = _e2074.member_1[0][1];
                            }
                            let _e2720 = phi_3547_;
                            if (_e2074.member_1[0][2] < 0f) {
                                phi_3554_ = -(_e2074.member_1[0][2]);
                            } else {
                                phi_3554_ = _e2074.member_1[0][2];
                            }
                            let _e2725 = phi_3554_;
                            if (_e2074.member_1[1][0] < 0f) {
                                phi_3567_ = -(_e2074.member_1[1][0]);
                            } else {
                                phi_3567_ = _e2074.member_1[1][0];
                            }
                            let _e2736 = phi_3567_;
                            if (_e2074.member_1[1][1] < 0f) {
                                phi_3574_ = -(_e2074.member_1[1][1]);
                            } else {
                                phi_3574_ = _e2074.member_1[1][1];
                            }
                            let _e2741 = phi_3574_;
                            if (_e2074.member_1[1][2] < 0f) {
                                phi_3581_ = -(_e2074.member_1[1][2]);
                            } else {
                                phi_3581_ = _e2074.member_1[1][2];
                            }
                            let _e2746 = phi_3581_;
                            if (_e2074.member_1[2][0] < 0f) {
                                phi_3594_ = -(_e2074.member_1[2][0]);
                            } else {
                                phi_3594_ = _e2074.member_1[2][0];
                            }
                            let _e2757 = phi_3594_;
                            if (_e2074.member_1[2][1] < 0f) {
                                phi_3601_ = -(_e2074.member_1[2][1]);
                            } else {
                                phi_3601_ = _e2074.member_1[2][1];
                            }
                            let _e2762 = phi_3601_;
                            if (_e2074.member_1[2][2] < 0f) {
                                phi_3608_ = -(_e2074.member_1[2][2]);
                            } else {
                                phi_3608_ = _e2074.member_1[2][2];
                            }
                            let _e2767 = phi_3608_;
                            let _e2773 = (0.000000059604645f * 8f);
                            let _e2778 = ((((_e2683 + _e2688) + _e2694) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2790 = (((_e2074.member_1[0][0] * _e2673) + (_e2074.member_1[0][1] * _e2675)) + (_e2074.member_1[0][2] * _e2677));
                            let _e2799 = (((_e2074.member_1[1][0] * _e2673) + (_e2074.member_1[1][1] * _e2675)) + (_e2074.member_1[1][2] * _e2677));
                            let _e2808 = (((_e2074.member_1[2][0] * _e2673) + (_e2074.member_1[2][1] * _e2675)) + (_e2074.member_1[2][2] * _e2677));
                            if (_e2790 < 0f) {
                                phi_3655_ = -(_e2790);
                            } else {
                                phi_3655_ = _e2790;
                            }
                            let _e2812 = phi_3655_;
                            if (_e2799 < 0f) {
                                phi_3661_ = -(_e2799);
                            } else {
                                phi_3661_ = _e2799;
                            }
                            let _e2816 = phi_3661_;
                            if (_e2808 < 0f) {
                                phi_3667_ = -(_e2808);
                            } else {
                                phi_3667_ = _e2808;
                            }
                            let _e2820 = phi_3667_;
                            let _e2834 = (((_e313.member_1[0][0] * _e2074.member_1[0][0]) + (_e313.member_1[0][1] * _e2074.member_1[0][1])) + (_e313.member_1[0][2] * _e2074.member_1[0][2]));
                            let _e2847 = (((_e313.member_1[1][0] * _e2074.member_1[0][0]) + (_e313.member_1[1][1] * _e2074.member_1[0][1])) + (_e313.member_1[1][2] * _e2074.member_1[0][2]));
                            let _e2860 = (((_e313.member_1[2][0] * _e2074.member_1[0][0]) + (_e313.member_1[2][1] * _e2074.member_1[0][1])) + (_e313.member_1[2][2] * _e2074.member_1[0][2]));
                            if (_e2834 < 0f) {
                                phi_3711_ = -(_e2834);
                            } else {
                                phi_3711_ = _e2834;
                            }
                            let _e2865 = phi_3711_;
                            if (_e2847 < 0f) {
                                phi_3717_ = -(_e2847);
                            } else {
                                phi_3717_ = _e2847;
                            }
                            let _e2869 = phi_3717_;
                            if (_e2860 < 0f) {
                                phi_3723_ = -(_e2860);
                            } else {
                                phi_3723_ = _e2860;
                            }
                            let _e2873 = phi_3723_;
                            let _e2895 = (((_e313.member_1[0][0] * _e2074.member_1[1][0]) + (_e313.member_1[0][1] * _e2074.member_1[1][1])) + (_e313.member_1[0][2] * _e2074.member_1[1][2]));
                            let _e2908 = (((_e313.member_1[1][0] * _e2074.member_1[1][0]) + (_e313.member_1[1][1] * _e2074.member_1[1][1])) + (_e313.member_1[1][2] * _e2074.member_1[1][2]));
                            let _e2921 = (((_e313.member_1[2][0] * _e2074.member_1[1][0]) + (_e313.member_1[2][1] * _e2074.member_1[1][1])) + (_e313.member_1[2][2] * _e2074.member_1[1][2]));
                            if (_e2895 < 0f) {
                                phi_3775_ = -(_e2895);
                            } else {
                                phi_3775_ = _e2895;
                            }
                            let _e2926 = phi_3775_;
                            if (_e2908 < 0f) {
                                phi_3781_ = -(_e2908);
                            } else {
                                phi_3781_ = _e2908;
                            }
                            let _e2930 = phi_3781_;
                            if (_e2921 < 0f) {
                                phi_3787_ = -(_e2921);
                            } else {
                                phi_3787_ = _e2921;
                            }
                            let _e2934 = phi_3787_;
                            let _e2956 = (((_e313.member_1[0][0] * _e2074.member_1[2][0]) + (_e313.member_1[0][1] * _e2074.member_1[2][1])) + (_e313.member_1[0][2] * _e2074.member_1[2][2]));
                            let _e2969 = (((_e313.member_1[1][0] * _e2074.member_1[2][0]) + (_e313.member_1[1][1] * _e2074.member_1[2][1])) + (_e313.member_1[1][2] * _e2074.member_1[2][2]));
                            let _e2982 = (((_e313.member_1[2][0] * _e2074.member_1[2][0]) + (_e313.member_1[2][1] * _e2074.member_1[2][1])) + (_e313.member_1[2][2] * _e2074.member_1[2][2]));
                            if (_e2956 < 0f) {
                                phi_3839_ = -(_e2956);
                            } else {
                                phi_3839_ = _e2956;
                            }
                            let _e2987 = phi_3839_;
                            if (_e2969 < 0f) {
                                phi_3845_ = -(_e2969);
                            } else {
                                phi_3845_ = _e2969;
                            }
                            let _e2991 = phi_3845_;
                            if (_e2982 < 0f) {
                                phi_3851_ = -(_e2982);
                            } else {
                                phi_3851_ = _e2982;
                            }
                            let _e2995 = phi_3851_;
                            let _e3012 = (_e451.member[0] - _e2531);
                            let _e3014 = (_e451.member[1] - _e2533);
                            let _e3016 = (_e451.member[2] - _e2535);
                            if (_e451.member_2[0] < 0f) {
                                phi_3880_ = -(_e451.member_2[0]);
                            } else {
                                phi_3880_ = _e451.member_2[0];
                            }
                            let _e3022 = phi_3880_;
                            if (_e451.member_2[1] < 0f) {
                                phi_3887_ = -(_e451.member_2[1]);
                            } else {
                                phi_3887_ = _e451.member_2[1];
                            }
                            let _e3027 = phi_3887_;
                            if (_e451.member_2[2] < 0f) {
                                phi_3895_ = -(_e451.member_2[2]);
                            } else {
                                phi_3895_ = _e451.member_2[2];
                            }
                            let _e3033 = phi_3895_;
                            if (_e3012 < 0f) {
                                phi_3904_ = -(_e3012);
                            } else {
                                phi_3904_ = _e3012;
                            }
                            let _e3040 = phi_3904_;
                            if (_e3014 < 0f) {
                                phi_3910_ = -(_e3014);
                            } else {
                                phi_3910_ = _e3014;
                            }
                            let _e3044 = phi_3910_;
                            if (_e3016 < 0f) {
                                phi_3916_ = -(_e3016);
                            } else {
                                phi_3916_ = _e3016;
                            }
                            let _e3048 = phi_3916_;
                            if (_e2074.member_1[0][0] < 0f) {
                                phi_3924_ = -(_e2074.member_1[0][0]);
                            } else {
                                phi_3924_ = _e2074.member_1[0][0];
                            }
                            let _e3054 = phi_3924_;
                            if (_e2074.member_1[0][1] < 0f) {
                                phi_3931_ = -(_e2074.member_1[0][1]);
                            } else {
                                phi_3931_ = _e2074.member_1[0][1];
                            }
                            let _e3059 = phi_3931_;
                            if (_e2074.member_1[0][2] < 0f) {
                                phi_3938_ = -(_e2074.member_1[0][2]);
                            } else {
                                phi_3938_ = _e2074.member_1[0][2];
                            }
                            let _e3064 = phi_3938_;
                            if (_e2074.member_1[1][0] < 0f) {
                                phi_3951_ = -(_e2074.member_1[1][0]);
                            } else {
                                phi_3951_ = _e2074.member_1[1][0];
                            }
                            let _e3075 = phi_3951_;
                            if (_e2074.member_1[1][1] < 0f) {
                                phi_3958_ = -(_e2074.member_1[1][1]);
                            } else {
                                phi_3958_ = _e2074.member_1[1][1];
                            }
                            let _e3080 = phi_3958_;
                            if (_e2074.member_1[1][2] < 0f) {
                                phi_3965_ = -(_e2074.member_1[1][2]);
                            } else {
                                phi_3965_ = _e2074.member_1[1][2];
                            }
                            let _e3085 = phi_3965_;
                            if (_e2074.member_1[2][0] < 0f) {
                                phi_3978_ = -(_e2074.member_1[2][0]);
                            } else {
                                phi_3978_ = _e2074.member_1[2][0];
                            }
                            let _e3096 = phi_3978_;
                            if (_e2074.member_1[2][1] < 0f) {
                                phi_3985_ = -(_e2074.member_1[2][1]);
                            } else {
                                phi_3985_ = _e2074.member_1[2][1];
                            }
                            let _e3101 = phi_3985_;
                            if (_e2074.member_1[2][2] < 0f) {
                                phi_3992_ = -(_e2074.member_1[2][2]);
                            } else {
                                phi_3992_ = _e2074.member_1[2][2];
                            }
                            let _e3106 = phi_3992_;
                            let _e3112 = (0.000000059604645f * 8f);
                            let _e3117 = ((((_e3022 + _e3027) + _e3033) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e3129 = (((_e2074.member_1[0][0] * _e3012) + (_e2074.member_1[0][1] * _e3014)) + (_e2074.member_1[0][2] * _e3016));
                            let _e3138 = (((_e2074.member_1[1][0] * _e3012) + (_e2074.member_1[1][1] * _e3014)) + (_e2074.member_1[1][2] * _e3016));
                            let _e3147 = (((_e2074.member_1[2][0] * _e3012) + (_e2074.member_1[2][1] * _e3014)) + (_e2074.member_1[2][2] * _e3016));
                            if (_e3129 < 0f) {
                                phi_4039_ = -(_e3129);
                            } else {
                                phi_4039_ = _e3129;
                            }
                            let _e3151 = phi_4039_;
                            if (_e3138 < 0f) {
                                phi_4045_ = -(_e3138);
                            } else {
                                phi_4045_ = _e3138;
                            }
                            let _e3155 = phi_4045_;
                            if (_e3147 < 0f) {
                                phi_4051_ = -(_e3147);
                            } else {
                                phi_4051_ = _e3147;
                            }
                            let _e3159 = phi_4051_;
                            let _e3173 = (((_e451.member_1[0][0] * _e2074.member_1[0][0]) + (_e451.member_1[0][1] * _e2074.member_1[0][1])) + (_e451.member_1[0][2] * _e2074.member_1[0][2]));
                            let _e3186 = (((_e451.member_1[1][0] * _e2074.member_1[0][0]) + (_e451.member_1[1][1] * _e2074.member_1[0][1])) + (_e451.member_1[1][2] * _e2074.member_1[0][2]));
                            let _e3199 = (((_e451.member_1[2][0] * _e2074.member_1[0][0]) + (_e451.member_1[2][1] * _e2074.member_1[0][1])) + (_e451.member_1[2][2] * _e2074.member_1[0][2]));
                            if (_e3173 < 0f) {
                                phi_4095_ = -(_e3173);
                            } else {
                                phi_4095_ = _e3173;
                            }
                            let _e3204 = phi_4095_;
                            if (_e3186 < 0f) {
                                phi_4101_ = -(_e3186);
                            } else {
                                phi_4101_ = _e3186;
                            }
                            let _e3208 = phi_4101_;
                            if (_e3199 < 0f) {
                                phi_4107_ = -(_e3199);
                            } else {
                                phi_4107_ = _e3199;
                            }
                            let _e3212 = phi_4107_;
                            let _e3234 = (((_e451.member_1[0][0] * _e2074.member_1[1][0]) + (_e451.member_1[0][1] * _e2074.member_1[1][1])) + (_e451.member_1[0][2] * _e2074.member_1[1][2]));
                            let _e3247 = (((_e451.member_1[1][0] * _e2074.member_1[1][0]) + (_e451.member_1[1][1] * _e2074.member_1[1][1])) + (_e451.member_1[1][2] * _e2074.member_1[1][2]));
                            let _e3260 = (((_e451.member_1[2][0] * _e2074.member_1[1][0]) + (_e451.member_1[2][1] * _e2074.member_1[1][1])) + (_e451.member_1[2][2] * _e2074.member_1[1][2]));
                            if (_e3234 < 0f) {
                                phi_4159_ = -(_e3234);
                            } else {
                                phi_4159_ = _e3234;
                            }
                            let _e3265 = phi_4159_;
                            if (_e3247 < 0f) {
                                phi_4165_ = -(_e3247);
                            } else {
                                phi_4165_ = _e3247;
                            }
                            let _e3269 = phi_4165_;
                            if (_e3260 < 0f) {
                                phi_4171_ = -(_e3260);
                            } else {
                                phi_4171_ = _e3260;
                            }
                            let _e3273 = phi_4171_;
                            let _e3295 = (((_e451.member_1[0][0] * _e2074.member_1[2][0]) + (_e451.member_1[0][1] * _e2074.member_1[2][1])) + (_e451.member_1[0][2] * _e2074.member_1[2][2]));
                            let _e3308 = (((_e451.member_1[1][0] * _e2074.member_1[2][0]) + (_e451.member_1[1][1] * _e2074.member_1[2][1])) + (_e451.member_1[1][2] * _e2074.member_1[2][2]));
                            let _e3321 = (((_e451.member_1[2][0] * _e2074.member_1[2][0]) + (_e451.member_1[2][1] * _e2074.member_1[2][1])) + (_e451.member_1[2][2] * _e2074.member_1[2][2]));
                            if (_e3295 < 0f) {
                                phi_4223_ = -(_e3295);
                            } else {
                                phi_4223_ = _e3295;
                            }
                            let _e3326 = phi_4223_;
                            if (_e3308 < 0f) {
                                phi_4229_ = -(_e3308);
                            } else {
                                phi_4229_ = _e3308;
                            }
                            let _e3330 = phi_4229_;
                            if (_e3321 < 0f) {
                                phi_4235_ = -(_e3321);
                            } else {
                                phi_4235_ = _e3321;
                            }
                            let _e3334 = phi_4235_;
                            let _e3349 = (((_e2812 + (((_e2865 * _e313.member_2[0]) + (_e2869 * _e313.member_2[1])) + (_e2873 * _e313.member_2[2]))) + (((((_e2715 * _e2701) + (_e2720 * _e2705)) + (_e2725 * _e2709)) * _e2773) + _e2778)) + _e2668);
                            let _e3350 = (((_e2816 + (((_e2926 * _e313.member_2[0]) + (_e2930 * _e313.member_2[1])) + (_e2934 * _e313.member_2[2]))) + (((((_e2736 * _e2701) + (_e2741 * _e2705)) + (_e2746 * _e2709)) * _e2773) + _e2778)) + _e2669);
                            let _e3351 = (((_e2820 + (((_e2987 * _e313.member_2[0]) + (_e2991 * _e313.member_2[1])) + (_e2995 * _e313.member_2[2]))) + (((((_e2757 * _e2701) + (_e2762 * _e2705)) + (_e2767 * _e2709)) * _e2773) + _e2778)) + _e2670);
                            let _e3352 = (((_e3151 + (((_e3204 * _e451.member_2[0]) + (_e3208 * _e451.member_2[1])) + (_e3212 * _e451.member_2[2]))) + (((((_e3054 * _e3040) + (_e3059 * _e3044)) + (_e3064 * _e3048)) * _e3112) + _e3117)) + _e2668);
                            let _e3353 = (((_e3155 + (((_e3265 * _e451.member_2[0]) + (_e3269 * _e451.member_2[1])) + (_e3273 * _e451.member_2[2]))) + (((((_e3075 * _e3040) + (_e3080 * _e3044)) + (_e3085 * _e3048)) * _e3112) + _e3117)) + _e2669);
                            let _e3354 = (((_e3159 + (((_e3326 * _e451.member_2[0]) + (_e3330 * _e451.member_2[1])) + (_e3334 * _e451.member_2[2]))) + (((((_e3096 * _e3040) + (_e3101 * _e3044)) + (_e3106 * _e3048)) * _e3112) + _e3117)) + _e2670);
                            if ((bitcast<u32>(_e3349) & 2139095040u) != 2139095040u) {
                                if ((bitcast<u32>(_e3350) & 2139095040u) != 2139095040u) {
                                    phi_4271_ = ((bitcast<u32>(_e3351) & 2139095040u) != 2139095040u);
                                    phi_4272_ = false;
                                } else {
                                    phi_4271_ = bool();
                                    phi_4272_ = true;
                                }
                                let _e3365 = phi_4271_;
                                let _e3367 = phi_4272_;
                                phi_4273_ = _e3365;
                                phi_4274_ = _e3367;
                            } else {
                                phi_4273_ = bool();
                                phi_4274_ = true;
                            }
                            let _e3369 = phi_4273_;
                            let _e3371 = phi_4274_;
                            if _e3371 {
                                phi_4278_ = false;
                            } else {
                                phi_4278_ = _e3369;
                            }
                            let _e3373 = phi_4278_;
                            if _e3373 {
                                if ((bitcast<u32>(_e3352) & 2139095040u) != 2139095040u) {
                                    if ((bitcast<u32>(_e3353) & 2139095040u) != 2139095040u) {
                                        phi_4297_ = ((bitcast<u32>(_e3354) & 2139095040u) != 2139095040u);
                                        phi_4298_ = false;
                                    } else {
                                        phi_4297_ = bool();
                                        phi_4298_ = true;
                                    }
                                    let _e3384 = phi_4297_;
                                    let _e3386 = phi_4298_;
                                    phi_4299_ = _e3384;
                                    phi_4300_ = _e3386;
                                } else {
                                    phi_4299_ = bool();
                                    phi_4300_ = true;
                                }
                                let _e3388 = phi_4299_;
                                let _e3390 = phi_4300_;
                                if _e3390 {
                                    phi_4304_ = false;
                                } else {
                                    phi_4304_ = _e3388;
                                }
                                let _e3392 = phi_4304_;
                                if _e3392 {
                                    if (_e3349 > _e3352) {
                                        phi_4312_ = _e3349;
                                    } else {
                                        phi_4312_ = _e3352;
                                    }
                                    let _e3395 = phi_4312_;
                                    if (_e3350 > _e3353) {
                                        phi_4317_ = _e3350;
                                    } else {
                                        phi_4317_ = _e3353;
                                    }
                                    let _e3398 = phi_4317_;
                                    if (_e3351 > _e3354) {
                                        phi_4322_ = _e3351;
                                    } else {
                                        phi_4322_ = _e3354;
                                    }
                                    let _e3401 = phi_4322_;
                                    phi_4325_ = type_34(array<f32, 3>(_e2531, _e2533, _e2535), _e2074.member_1, array<f32, 3>(_e3395, _e3398, _e3401));
                                    phi_4326_ = false;
                                } else {
                                    phi_4325_ = type_34();
                                    phi_4326_ = true;
                                }
                                let _e3405 = phi_4325_;
                                let _e3407 = phi_4326_;
                                phi_4327_ = _e3405;
                                phi_4328_ = _e3407;
                            } else {
                                phi_4327_ = type_34();
                                phi_4328_ = true;
                            }
                            let _e3409 = phi_4327_;
                            let _e3411 = phi_4328_;
                            if _e3411 {
                                if true {
                                    phi_4342_ = 2122317824u;
                                } else {
                                    phi_4342_ = 8388608u;
                                }
                                let _e3413 = phi_4342_;
                                let _e3415 = (bitcast<f32>(_e3413) * 3.9999998f);
                                phi_4352_ = type_34(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3415, _e3415, _e3415));
                            } else {
                                phi_4352_ = _e3409;
                            }
                            let _e3419 = phi_4352_;
                            oriented.member[_e118] = type_30(vec4<f32>(_e3419.member[0], _e3419.member[1], _e3419.member[2], _e3419.member_1[0][0]), vec4<f32>(_e3419.member_1[0][1], _e3419.member_1[0][2], _e3419.member_1[1][0], _e3419.member_1[1][1]), vec4<f32>(_e3419.member_1[1][2], _e3419.member_1[2][0], _e3419.member_1[2][1], _e3419.member_1[2][2]), vec4<f32>(_e3419.member_2[0], _e3419.member_2[1], _e3419.member_2[2], 0f));
                            let _e3448 = atomicMax((&stamps.member[_e118]), _e81);
                        }
                    }
                }
                phi_4384_ = true;
            }
            let _e3450 = phi_4384_;
            phi_4385_ = _e3450;
        } else {
            phi_4385_ = false;
        }
        let _e3452 = phi_4385_;
        continue;
        continuing {
            phi_177_ = _e105;
            break if !(_e3452);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn orient_far(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
