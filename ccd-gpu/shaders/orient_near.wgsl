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

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_32 {
    member: array<type_30>,
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

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> branches: type_22;
@group(0) @binding(2) 
var<storage> block_nodes: type_26;
var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(3) 
var<storage, read_write> oriented: type_32;
@group(0) @binding(4) 
var<storage, read_write> stamps: type_11;
@group(0) @binding(5) 
var<storage, read_write> far: type_42;
var<workgroup> done: array<atomic<u32>, 8>;
var<workgroup> boxes: array<type_33, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_191_: bool;
    var phi_195_: u32;
    var phi_196_: type_8;
    var phi_197_: u32;
    var phi_200_: type_9;
    var phi_203_: u32;
    var phi_201_: type_9;
    var phi_226_: type_9;
    var phi_251_: u32;
    var phi_266_: u32;
    var phi_268_: u32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_409_: type_33;
    var phi_489_: f32;
    var phi_494_: f32;
    var phi_499_: f32;
    var phi_546_: type_33;
    var phi_563_: f32;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_593_: f32;
    var phi_600_: f32;
    var phi_605_: f32;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_622_: f32;
    var phi_630_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_649_: f32;
    var phi_654_: f32;
    var phi_659_: f32;
    var phi_680_: u32;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_684_: f32;
    var phi_685_: bool;
    var phi_689_: f32;
    var phi_956_: f32;
    var phi_963_: f32;
    var phi_968_: f32;
    var phi_975_: f32;
    var phi_980_: f32;
    var phi_989_: f32;
    var phi_995_: f32;
    var phi_1000_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1037_: u32;
    var phi_1082_: type_14;
    var phi_1085_: f32;
    var phi_1106_: bool;
    var phi_1112_: type_15;
    var phi_1083_: type_14;
    var phi_1126_: type_15;
    var phi_1086_: f32;
    var local: f32;
    var phi_1075_: f32;
    var phi_1139_: f32;
    var phi_1151_: type_34;
    var phi_1190_: type_9;
    var phi_1193_: type_36;
    var phi_1191_: type_9;
    var phi_1216_: type_9;
    var phi_1236_: f32;
    var phi_1243_: f32;
    var phi_1276_: type_14;
    var phi_1279_: f32;
    var phi_1300_: bool;
    var phi_1306_: type_15;
    var phi_1277_: type_14;
    var phi_1320_: type_15;
    var phi_1280_: f32;
    var local_1: f32;
    var phi_1269_: f32;
    var phi_1333_: f32;
    var phi_1340_: f32;
    var phi_1374_: type_14;
    var phi_1377_: f32;
    var phi_1398_: bool;
    var phi_1404_: type_15;
    var phi_1375_: type_14;
    var phi_1418_: type_15;
    var phi_1378_: f32;
    var local_2: f32;
    var phi_1367_: f32;
    var phi_1431_: f32;
    var phi_1443_: type_34;
    var phi_1539_: type_14;
    var phi_1542_: f32;
    var phi_1563_: bool;
    var phi_1569_: type_15;
    var phi_1540_: type_14;
    var phi_1583_: type_15;
    var phi_1543_: f32;
    var local_3: f32;
    var phi_1532_: f32;
    var phi_1596_: f32;
    var phi_1608_: type_34;
    var phi_1675_: type_36;
    var phi_1676_: bool;
    var phi_1677_: type_36;
    var phi_1678_: bool;
    var phi_1967_: type_14;
    var phi_1970_: f32;
    var phi_1991_: bool;
    var phi_1997_: type_15;
    var phi_1968_: type_14;
    var phi_2011_: type_15;
    var phi_1971_: f32;
    var local_4: f32;
    var phi_1960_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2065_: type_14;
    var phi_2068_: f32;
    var phi_2089_: bool;
    var phi_2095_: type_15;
    var phi_2066_: type_14;
    var phi_2109_: type_15;
    var phi_2069_: f32;
    var local_5: f32;
    var phi_2058_: f32;
    var phi_2122_: f32;
    var phi_2134_: type_34;
    var phi_2196_: type_36;
    var phi_1710_: type_14;
    var phi_1713_: f32;
    var phi_1734_: bool;
    var phi_1740_: type_15;
    var phi_1711_: type_14;
    var phi_1754_: type_15;
    var phi_1714_: f32;
    var local_6: f32;
    var phi_1703_: f32;
    var phi_1767_: f32;
    var phi_1774_: f32;
    var phi_1808_: type_14;
    var phi_1811_: f32;
    var phi_1832_: bool;
    var phi_1838_: type_15;
    var phi_1809_: type_14;
    var phi_1852_: type_15;
    var phi_1812_: f32;
    var local_7: f32;
    var phi_1801_: f32;
    var phi_1865_: f32;
    var phi_1877_: type_34;
    var phi_2197_: type_36;
    var phi_2198_: type_36;
    var phi_2202_: bool;
    var phi_2206_: bool;
    var phi_1194_: type_36;
    var phi_2207_: type_36;
    var phi_2208_: bool;
    var phi_2209_: bool;
    var local_8: bool;
    var phi_2213_: type_36;
    var phi_2225_: u32;
    var phi_2358_: f32;
    var phi_2364_: f32;
    var phi_2370_: f32;
    var phi_2376_: f32;
    var phi_2382_: f32;
    var phi_2388_: f32;
    var phi_2432_: f32;
    var phi_2438_: f32;
    var phi_2444_: f32;
    var phi_2450_: f32;
    var phi_2456_: f32;
    var phi_2462_: f32;
    var phi_2506_: f32;
    var phi_2512_: f32;
    var phi_2518_: f32;
    var phi_2524_: f32;
    var phi_2530_: f32;
    var phi_2536_: f32;
    var phi_2577_: f32;
    var phi_2583_: f32;
    var phi_2588_: f32;
    var phi_2594_: f32;
    var phi_2599_: f32;
    var phi_2605_: f32;
    var phi_2611_: f32;
    var phi_2616_: f32;
    var phi_2622_: f32;
    var phi_2627_: f32;
    var phi_2632_: f32;
    var phi_2643_: array<array<f32, 3>, 3>;
    var phi_2645_: type_37;
    var phi_2646_: bool;
    var phi_2647_: type_37;
    var phi_2648_: bool;
    var phi_2661_: type_37;
    var phi_2706_: f32;
    var phi_2712_: f32;
    var phi_2718_: f32;
    var phi_2770_: f32;
    var phi_2776_: f32;
    var phi_2782_: f32;
    var phi_2834_: f32;
    var phi_2840_: f32;
    var phi_2846_: f32;
    var phi_2898_: f32;
    var phi_2904_: f32;
    var phi_2910_: f32;
    var phi_2962_: f32;
    var phi_2968_: f32;
    var phi_2974_: f32;
    var phi_3026_: f32;
    var phi_3032_: f32;
    var phi_3038_: f32;
    var phi_3084_: f32;
    var phi_3089_: f32;
    var phi_3094_: f32;
    var phi_3102_: f32;
    var phi_3107_: f32;
    var phi_3112_: f32;
    var phi_3168_: f32;
    var phi_3175_: f32;
    var phi_3183_: f32;
    var phi_3192_: f32;
    var phi_3198_: f32;
    var phi_3204_: f32;
    var phi_3212_: f32;
    var phi_3219_: f32;
    var phi_3226_: f32;
    var phi_3239_: f32;
    var phi_3246_: f32;
    var phi_3253_: f32;
    var phi_3266_: f32;
    var phi_3273_: f32;
    var phi_3280_: f32;
    var phi_3327_: f32;
    var phi_3333_: f32;
    var phi_3339_: f32;
    var phi_3383_: f32;
    var phi_3389_: f32;
    var phi_3395_: f32;
    var phi_3447_: f32;
    var phi_3453_: f32;
    var phi_3459_: f32;
    var phi_3511_: f32;
    var phi_3517_: f32;
    var phi_3523_: f32;
    var phi_3552_: f32;
    var phi_3559_: f32;
    var phi_3567_: f32;
    var phi_3576_: f32;
    var phi_3582_: f32;
    var phi_3588_: f32;
    var phi_3596_: f32;
    var phi_3603_: f32;
    var phi_3610_: f32;
    var phi_3623_: f32;
    var phi_3630_: f32;
    var phi_3637_: f32;
    var phi_3650_: f32;
    var phi_3657_: f32;
    var phi_3664_: f32;
    var phi_3711_: f32;
    var phi_3717_: f32;
    var phi_3723_: f32;
    var phi_3767_: f32;
    var phi_3773_: f32;
    var phi_3779_: f32;
    var phi_3831_: f32;
    var phi_3837_: f32;
    var phi_3843_: f32;
    var phi_3895_: f32;
    var phi_3901_: f32;
    var phi_3907_: f32;
    var phi_3937_: bool;
    var phi_3938_: bool;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3944_: bool;
    var phi_3963_: bool;
    var phi_3964_: bool;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3970_: bool;
    var phi_3978_: f32;
    var phi_3983_: f32;
    var phi_3988_: f32;
    var phi_3991_: type_33;
    var phi_3992_: bool;
    var phi_3993_: type_33;
    var phi_3994_: bool;
    var phi_4008_: u32;
    var phi_4018_: type_33;
    var phi_4054_: u32;
    var phi_204_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_4063_: bool;
    var phi_4069_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_4171_: u32;
    var local_13: type_36;
    var local_14: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e60 = id_2;
    let _e61 = n_2;
    let _e62 = lane_2;
    let _e74 = (((_e60.y * _e61.x) + _e60.x) * 256u);
    let _e75 = (_e74 + _e62);
    let _e78 = params.member.member_2.member_1;
    let _e82 = params.member.member.member[_e78];
    if (_e62 < 8u) {
        atomicStore((&done[_e62]), 0u);
    }
    if (_e62 < 2u) {
        atomicStore((&counters[_e62]), 0u);
    }
    if ((_e75 + 1u) < _e82) {
        let _e91 = branches.member[_e75];
        if (_e91.z >= _e74) {
            phi_191_ = (_e91.w < (_e74 + 256u));
        } else {
            phi_191_ = false;
        }
        let _e101 = phi_191_;
        if _e101 {
            phi_195_ = 1u;
        } else {
            phi_195_ = 3u;
        }
        let _e103 = phi_195_;
        phi_196_ = type_8(_e91.x, _e91.y, _e91.z, _e91.w);
        phi_197_ = _e103;
    } else {
        phi_196_ = type_8(0u, 0u, _e74, _e74);
        phi_197_ = 0u;
    }
    let _e105 = phi_196_;
    let _e107 = phi_197_;
    workgroupBarrier();
    phi_200_ = type_9(0u, 38u);
    phi_203_ = _e107;
    loop {
        let _e109 = phi_200_;
        let _e111 = phi_203_;
        local_9 = _e111;
        local_10 = _e111;
        local_11 = _e111;
        local_12 = _e111;
        if (_e109.member < _e109.member_1) {
            phi_201_ = type_9((_e109.member + 1u), _e109.member_1);
            phi_226_ = type_9(1u, _e109.member);
        } else {
            phi_201_ = _e109;
            phi_226_ = type_9(0u, type_9().member_1);
        }
        let _e123 = phi_201_;
        let _e125 = phi_226_;
        let _e128 = (bitcast<i32>(_e125.member) != 0i);
        if _e128 {
            if (_e111 == 1u) {
                if ((_e105.member + 1u) >= _e82) {
                    phi_251_ = 1u;
                } else {
                    let _e133 = (_e105.member - _e74);
                    let _e136 = atomicLoad((&done[(_e133 / 32u)]));
                    phi_251_ = ((_e136 >> bitcast<u32>(((_e133 % 32u) & 31u))) & 1u);
                }
                let _e143 = phi_251_;
                if ((_e105.member_1 + 1u) >= _e82) {
                    phi_266_ = 1u;
                } else {
                    let _e147 = (_e105.member_1 - _e74);
                    let _e150 = atomicLoad((&done[(_e147 / 32u)]));
                    phi_266_ = ((_e150 >> bitcast<u32>(((_e147 % 32u) & 31u))) & 1u);
                }
                let _e157 = phi_266_;
                phi_268_ = (_e143 & _e157);
            } else {
                phi_268_ = 0u;
            }
            let _e160 = phi_268_;
            workgroupBarrier();
            if (_e160 == 0u) {
                phi_4054_ = _e111;
            } else {
                let _e166 = params.member.member_2.member_1;
                let _e170 = params.member.member.member[_e166];
                if ((_e105.member + 1u) >= _e170) {
                    let _e205 = params.member.member_2.member_1;
                    let _e209 = params.member.member.member[_e205];
                    let _e216 = params.member.member_2.member[0u][_e205];
                    let _e219 = block_nodes.member[(_e216 + (_e105.member - (_e209 - 1u)))];
                    let _e238 = ((_e219.member.x * 0.5f) + (_e219.member_1.y * 0.5f));
                    let _e239 = ((_e219.member.y * 0.5f) + (_e219.member_2.x * 0.5f));
                    let _e240 = ((_e219.member_1.x * 0.5f) + (_e219.member_2.y * 0.5f));
                    let _e242 = (_e219.member_1.y - _e238);
                    let _e243 = (_e219.member_2.x - _e239);
                    let _e244 = (_e219.member_2.y - _e240);
                    let _e245 = (_e238 - _e219.member.x);
                    let _e246 = (_e239 - _e219.member.y);
                    let _e247 = (_e240 - _e219.member_1.x);
                    if (_e242 > _e245) {
                        phi_352_ = _e242;
                    } else {
                        phi_352_ = _e245;
                    }
                    let _e250 = phi_352_;
                    if (_e243 > _e246) {
                        phi_357_ = _e243;
                    } else {
                        phi_357_ = _e246;
                    }
                    let _e253 = phi_357_;
                    if (_e244 > _e247) {
                        phi_362_ = _e244;
                    } else {
                        phi_362_ = _e247;
                    }
                    let _e256 = phi_362_;
                    let _e258 = (1f + (0.000000059604645f * 4f));
                    let _e262 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_409_ = type_33(array<f32, 3>(_e238, _e239, _e240), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e250 * _e258) + _e262), ((_e253 * _e258) + _e262), ((_e256 * _e258) + _e262)));
                } else {
                    let _e174 = boxes[(_e105.member - _e74)];
                    phi_409_ = type_33(array<f32, 3>(_e174.member[0], _e174.member[1], _e174.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e174.member_1[0][0], _e174.member_1[0][1], _e174.member_1[0][2]), array<f32, 3>(_e174.member_1[1][0], _e174.member_1[1][1], _e174.member_1[1][2]), array<f32, 3>(_e174.member_1[2][0], _e174.member_1[2][1], _e174.member_1[2][2])), array<f32, 3>(_e174.member_2[0], _e174.member_2[1], _e174.member_2[2]));
                }
                let _e269 = phi_409_;
                let _e274 = params.member.member_2.member_1;
                let _e278 = params.member.member.member[_e274];
                if ((_e105.member_1 + 1u) >= _e278) {
                    let _e313 = params.member.member_2.member_1;
                    let _e317 = params.member.member.member[_e313];
                    let _e324 = params.member.member_2.member[0u][_e313];
                    let _e327 = block_nodes.member[(_e324 + (_e105.member_1 - (_e317 - 1u)))];
                    let _e346 = ((_e327.member.x * 0.5f) + (_e327.member_1.y * 0.5f));
                    let _e347 = ((_e327.member.y * 0.5f) + (_e327.member_2.x * 0.5f));
                    let _e348 = ((_e327.member_1.x * 0.5f) + (_e327.member_2.y * 0.5f));
                    let _e350 = (_e327.member_1.y - _e346);
                    let _e351 = (_e327.member_2.x - _e347);
                    let _e352 = (_e327.member_2.y - _e348);
                    let _e353 = (_e346 - _e327.member.x);
                    let _e354 = (_e347 - _e327.member.y);
                    let _e355 = (_e348 - _e327.member_1.x);
                    if (_e350 > _e353) {
                        phi_489_ = _e350;
                    } else {
                        phi_489_ = _e353;
                    }
                    let _e358 = phi_489_;
                    if (_e351 > _e354) {
                        phi_494_ = _e351;
                    } else {
                        phi_494_ = _e354;
                    }
                    let _e361 = phi_494_;
                    if (_e352 > _e355) {
                        phi_499_ = _e352;
                    } else {
                        phi_499_ = _e355;
                    }
                    let _e364 = phi_499_;
                    let _e366 = (1f + (0.000000059604645f * 4f));
                    let _e370 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_546_ = type_33(array<f32, 3>(_e346, _e347, _e348), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e358 * _e366) + _e370), ((_e361 * _e366) + _e370), ((_e364 * _e366) + _e370)));
                } else {
                    let _e282 = boxes[(_e105.member_1 - _e74)];
                    phi_546_ = type_33(array<f32, 3>(_e282.member[0], _e282.member[1], _e282.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e282.member_1[0][0], _e282.member_1[0][1], _e282.member_1[0][2]), array<f32, 3>(_e282.member_1[1][0], _e282.member_1[1][1], _e282.member_1[1][2]), array<f32, 3>(_e282.member_1[2][0], _e282.member_1[2][1], _e282.member_1[2][2])), array<f32, 3>(_e282.member_2[0], _e282.member_2[1], _e282.member_2[2]));
                }
                let _e377 = phi_546_;
                let _e382 = (_e377.member[0] - _e269.member[0]);
                let _e385 = (_e377.member[1] - _e269.member[1]);
                let _e388 = (_e377.member[2] - _e269.member[2]);
                if (_e382 < 0f) {
                    phi_563_ = -(_e382);
                } else {
                    phi_563_ = _e382;
                }
                let _e392 = phi_563_;
                if (_e385 < 0f) {
                    phi_569_ = -(_e385);
                } else {
                    phi_569_ = _e385;
                }
                let _e396 = phi_569_;
                if (_e392 > _e396) {
                    phi_574_ = _e392;
                } else {
                    phi_574_ = _e396;
                }
                let _e399 = phi_574_;
                if (_e388 < 0f) {
                    phi_580_ = -(_e388);
                } else {
                    phi_580_ = _e388;
                }
                let _e403 = phi_580_;
                if (_e399 > _e403) {
                    phi_585_ = _e399;
                } else {
                    phi_585_ = _e403;
                }
                let _e406 = phi_585_;
                if (_e269.member_2[0] < 0f) {
                    phi_593_ = -(_e269.member_2[0]);
                } else {
                    phi_593_ = _e269.member_2[0];
                }
                let _e412 = phi_593_;
                if (_e269.member_2[1] < 0f) {
                    phi_600_ = -(_e269.member_2[1]);
                } else {
                    phi_600_ = _e269.member_2[1];
                }
                let _e417 = phi_600_;
                if (_e412 > _e417) {
                    phi_605_ = _e412;
                } else {
                    phi_605_ = _e417;
                }
                let _e420 = phi_605_;
                if (_e269.member_2[2] < 0f) {
                    phi_612_ = -(_e269.member_2[2]);
                } else {
                    phi_612_ = _e269.member_2[2];
                }
                let _e425 = phi_612_;
                if (_e420 > _e425) {
                    phi_617_ = _e420;
                } else {
                    phi_617_ = _e425;
                }
                let _e428 = phi_617_;
                if (_e406 > _e428) {
                    phi_622_ = _e406;
                } else {
                    phi_622_ = _e428;
                }
                let _e431 = phi_622_;
                if (_e377.member_2[0] < 0f) {
                    phi_630_ = -(_e377.member_2[0]);
                } else {
                    phi_630_ = _e377.member_2[0];
                }
                let _e437 = phi_630_;
                if (_e377.member_2[1] < 0f) {
                    phi_637_ = -(_e377.member_2[1]);
                } else {
                    phi_637_ = _e377.member_2[1];
                }
                let _e442 = phi_637_;
                if (_e437 > _e442) {
                    phi_642_ = _e437;
                } else {
                    phi_642_ = _e442;
                }
                let _e445 = phi_642_;
                if (_e377.member_2[2] < 0f) {
                    phi_649_ = -(_e377.member_2[2]);
                } else {
                    phi_649_ = _e377.member_2[2];
                }
                let _e450 = phi_649_;
                if (_e445 > _e450) {
                    phi_654_ = _e445;
                } else {
                    phi_654_ = _e450;
                }
                let _e453 = phi_654_;
                if (_e431 > _e453) {
                    phi_659_ = _e431;
                } else {
                    phi_659_ = _e453;
                }
                let _e456 = phi_659_;
                if (_e456 > 0.000000000000000000000000000000000000011754944f) {
                    if ((bitcast<u32>(_e456) & 2139095040u) != 2139095040u) {
                        let _e463 = (2130706432u - (bitcast<u32>(_e456) & 2139095040u));
                        if (_e463 > 8388608u) {
                            phi_680_ = _e463;
                        } else {
                            phi_680_ = 8388608u;
                        }
                        let _e466 = phi_680_;
                        phi_682_ = bitcast<f32>(_e466);
                        phi_683_ = false;
                    } else {
                        phi_682_ = f32();
                        phi_683_ = true;
                    }
                    let _e469 = phi_682_;
                    let _e471 = phi_683_;
                    phi_684_ = _e469;
                    phi_685_ = _e471;
                } else {
                    phi_684_ = f32();
                    phi_685_ = true;
                }
                let _e473 = phi_684_;
                let _e475 = phi_685_;
                if _e475 {
                    phi_689_ = 0f;
                } else {
                    phi_689_ = _e473;
                }
                let _e477 = phi_689_;
                let _e478 = (_e382 * _e477);
                let _e479 = (_e385 * _e477);
                let _e480 = (_e388 * _e477);
                let _e481 = (_e478 * 0.5f);
                let _e482 = (_e479 * 0.5f);
                let _e500 = (_e269.member_2[0] * _e477);
                let _e502 = (_e269.member_1[0][0] * _e500);
                let _e504 = (_e269.member_1[0][1] * _e500);
                let _e506 = (_e269.member_1[0][2] * _e500);
                let _e507 = (_e502 * 1f);
                let _e508 = (_e504 * 1f);
                let _e526 = (_e269.member_2[1] * _e477);
                let _e528 = (_e269.member_1[1][0] * _e526);
                let _e530 = (_e269.member_1[1][1] * _e526);
                let _e532 = (_e269.member_1[1][2] * _e526);
                let _e533 = (_e528 * 1f);
                let _e534 = (_e530 * 1f);
                let _e552 = (_e269.member_2[2] * _e477);
                let _e554 = (_e269.member_1[2][0] * _e552);
                let _e556 = (_e269.member_1[2][1] * _e552);
                let _e558 = (_e269.member_1[2][2] * _e552);
                let _e559 = (_e554 * 1f);
                let _e560 = (_e556 * 1f);
                let _e578 = (_e377.member_2[0] * _e477);
                let _e580 = (_e377.member_1[0][0] * _e578);
                let _e582 = (_e377.member_1[0][1] * _e578);
                let _e584 = (_e377.member_1[0][2] * _e578);
                let _e585 = (_e580 * 1f);
                let _e586 = (_e582 * 1f);
                let _e604 = (_e377.member_2[1] * _e477);
                let _e606 = (_e377.member_1[1][0] * _e604);
                let _e608 = (_e377.member_1[1][1] * _e604);
                let _e610 = (_e377.member_1[1][2] * _e604);
                let _e611 = (_e606 * 1f);
                let _e612 = (_e608 * 1f);
                let _e630 = (_e377.member_2[2] * _e477);
                let _e632 = (_e377.member_1[2][0] * _e630);
                let _e634 = (_e377.member_1[2][1] * _e630);
                let _e636 = (_e377.member_1[2][2] * _e630);
                let _e637 = (_e632 * 1f);
                let _e638 = (_e634 * 1f);
                let _e643 = (((((((0f + (_e478 * _e481)) + (_e502 * _e507)) + (_e528 * _e533)) + (_e554 * _e559)) + (_e580 * _e585)) + (_e606 * _e611)) + (_e632 * _e637));
                let _e644 = (((((((0f + (_e479 * _e481)) + (_e504 * _e507)) + (_e530 * _e533)) + (_e556 * _e559)) + (_e582 * _e585)) + (_e608 * _e611)) + (_e634 * _e637));
                let _e645 = (((((((0f + (_e480 * _e481)) + (_e506 * _e507)) + (_e532 * _e533)) + (_e558 * _e559)) + (_e584 * _e585)) + (_e610 * _e611)) + (_e636 * _e637));
                let _e647 = (((((((0f + (_e482 * _e479)) + (_e508 * _e504)) + (_e534 * _e530)) + (_e560 * _e556)) + (_e586 * _e582)) + (_e612 * _e608)) + (_e638 * _e634));
                let _e649 = (((((((0f + (_e482 * _e480)) + (_e508 * _e506)) + (_e534 * _e532)) + (_e560 * _e558)) + (_e586 * _e584)) + (_e612 * _e610)) + (_e638 * _e636));
                let _e651 = (((((((0f + ((_e480 * 0.5f) * _e480)) + ((_e506 * 1f) * _e506)) + ((_e532 * 1f) * _e532)) + ((_e558 * 1f) * _e558)) + ((_e584 * 1f) * _e584)) + ((_e610 * 1f) * _e610)) + ((_e636 * 1f) * _e636));
                if (_e643 < 0f) {
                    phi_956_ = -(_e643);
                } else {
                    phi_956_ = _e643;
                }
                let _e655 = phi_956_;
                if (_e644 < 0f) {
                    phi_963_ = -(_e644);
                } else {
                    phi_963_ = _e644;
                }
                let _e659 = phi_963_;
                if (_e655 > _e659) {
                    phi_968_ = _e655;
                } else {
                    phi_968_ = _e659;
                }
                let _e662 = phi_968_;
                if (_e645 < 0f) {
                    phi_975_ = -(_e645);
                } else {
                    phi_975_ = _e645;
                }
                let _e666 = phi_975_;
                if (_e662 > _e666) {
                    phi_980_ = _e662;
                } else {
                    phi_980_ = _e666;
                }
                let _e669 = phi_980_;
                if (_e647 < 0f) {
                    phi_989_ = -(_e647);
                } else {
                    phi_989_ = _e647;
                }
                let _e673 = phi_989_;
                if (_e649 < 0f) {
                    phi_995_ = -(_e649);
                } else {
                    phi_995_ = _e649;
                }
                let _e677 = phi_995_;
                if (_e673 > _e677) {
                    phi_1000_ = _e673;
                } else {
                    phi_1000_ = _e677;
                }
                let _e680 = phi_1000_;
                if (_e651 < 0f) {
                    phi_1006_ = -(_e651);
                } else {
                    phi_1006_ = _e651;
                }
                let _e684 = phi_1006_;
                if (_e680 > _e684) {
                    phi_1011_ = _e680;
                } else {
                    phi_1011_ = _e684;
                }
                let _e687 = phi_1011_;
                if (_e669 > _e687) {
                    phi_1016_ = _e669;
                } else {
                    phi_1016_ = _e687;
                }
                let _e690 = phi_1016_;
                if (_e690 > 0.000000000000000000000000000000000000011754944f) {
                    if ((bitcast<u32>(_e690) & 2139095040u) != 2139095040u) {
                        let _e697 = (2130706432u - (bitcast<u32>(_e690) & 2139095040u));
                        if (_e697 > 8388608u) {
                            phi_1037_ = _e697;
                        } else {
                            phi_1037_ = 8388608u;
                        }
                        let _e700 = phi_1037_;
                        let _e701 = bitcast<f32>(_e700);
                        let _e703 = (_e644 * _e701);
                        let _e704 = (_e645 * _e701);
                        let _e705 = (_e647 * _e701);
                        let _e706 = (_e649 * _e701);
                        let _e707 = (_e651 * _e701);
                        let _e710 = ((_e703 * _e703) + (_e704 * _e704));
                        if (_e710 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                            if (_e710 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e710 > 0f) {
                                    phi_1075_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_1075_ = 0f;
                                }
                                let _e767 = phi_1075_;
                                phi_1139_ = _e767;
                            } else {
                                phi_1082_ = type_14(0i, 5i);
                                phi_1085_ = bitcast<f32>(((bitcast<u32>(_e710) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e722 = phi_1082_;
                                    let _e724 = phi_1085_;
                                    local = _e724;
                                    if (_e722.member < _e722.member_1) {
                                        let _e731 = (_e722.member + 1i);
                                        if ((false == (_e731 > _e722.member)) != false) {
                                            phi_1106_ = true;
                                        } else {
                                            phi_1106_ = false;
                                        }
                                        let _e736 = phi_1106_;
                                        if _e736 {
                                            phi_1112_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_1112_ = type_15(1u, _e731);
                                        }
                                        let _e741 = phi_1112_;
                                        phi_1083_ = type_14(_e741.member_1, _e722.member_1);
                                        phi_1126_ = type_15(1u, _e722.member);
                                    } else {
                                        phi_1083_ = _e722;
                                        phi_1126_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e747 = phi_1083_;
                                    let _e749 = phi_1126_;
                                    let _e752 = (bitcast<i32>(_e749.member) != 0i);
                                    if _e752 {
                                        phi_1086_ = (0.5f * (_e724 + (_e710 / _e724)));
                                    } else {
                                        phi_1086_ = f32();
                                    }
                                    let _e757 = phi_1086_;
                                    continue;
                                    continuing {
                                        phi_1082_ = _e747;
                                        phi_1085_ = _e757;
                                        break if !(_e752);
                                    }
                                }
                                let _e762 = local;
                                phi_1139_ = (_e762 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e769 = phi_1139_;
                            let _e770 = (_e703 / _e769);
                            let _e771 = (_e704 / _e769);
                            let _e776 = (1.5f - (((_e770 * _e770) + (_e771 * _e771)) * 0.5f));
                            phi_1151_ = type_34((_e770 * _e776), (_e771 * _e776));
                        } else {
                            phi_1151_ = type_34(1f, 0f);
                        }
                        let _e781 = phi_1151_;
                        let _e786 = (((_e781.member * _e781.member_1) * _e706) * 2f);
                        phi_1190_ = type_9(0u, 16u);
                        phi_1193_ = type_36(array<f32, 2>(((_e781.member * _e703) + (_e781.member_1 * _e704)), (((_e781.member * _e781.member_1) * (_e705 - _e707)) + (((_e781.member_1 * _e781.member_1) - (_e781.member * _e781.member)) * _e706))), array<f32, 3>((_e643 * _e701), ((((_e781.member * _e781.member) * _e705) + _e786) + ((_e781.member_1 * _e781.member_1) * _e707)), ((((_e781.member_1 * _e781.member_1) * _e705) - _e786) + ((_e781.member * _e781.member) * _e707))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e781.member, _e781.member_1), array<f32, 3>(0f, _e781.member_1, -(_e781.member))));
                        loop {
                            let _e818 = phi_1190_;
                            let _e820 = phi_1193_;
                            local_14 = _e820;
                            if (_e818.member < _e818.member_1) {
                                phi_1191_ = type_9((_e818.member + 1u), _e818.member_1);
                                phi_1216_ = type_9(1u, _e818.member);
                            } else {
                                phi_1191_ = _e818;
                                phi_1216_ = type_9(0u, type_9().member_1);
                            }
                            let _e832 = phi_1191_;
                            let _e834 = phi_1216_;
                            if (bitcast<i32>(_e834.member) != 0i) {
                                let _e838 = (0.000000059604645f * 0.5f);
                                if (_e820.member[0] < 0f) {
                                    phi_1236_ = -(_e820.member[0]);
                                } else {
                                    phi_1236_ = _e820.member[0];
                                }
                                let _e849 = phi_1236_;
                                let _e850 = (_e849 > _e838);
                                if (_e820.member[1] < 0f) {
                                    phi_1243_ = -(_e820.member[1]);
                                } else {
                                    phi_1243_ = _e820.member[1];
                                }
                                let _e854 = phi_1243_;
                                let _e855 = (_e854 > _e838);
                                if _e850 {
                                    if _e855 {
                                        let _e858 = ((_e820.member_1[1] - _e820.member_1[0]) / (_e820.member[0] * 2f));
                                        let _e860 = ((_e858 * _e858) + 1f);
                                        if (_e860 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e860 > 0f) {
                                                phi_1269_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1269_ = 0f;
                                            }
                                            let _e913 = phi_1269_;
                                            phi_1333_ = _e913;
                                        } else {
                                            phi_1276_ = type_14(0i, 5i);
                                            phi_1279_ = bitcast<f32>(((bitcast<u32>(_e860) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e868 = phi_1276_;
                                                let _e870 = phi_1279_;
                                                local_1 = _e870;
                                                if (_e868.member < _e868.member_1) {
                                                    let _e877 = (_e868.member + 1i);
                                                    if ((false == (_e877 > _e868.member)) != false) {
                                                        phi_1300_ = true;
                                                    } else {
                                                        phi_1300_ = false;
                                                    }
                                                    let _e882 = phi_1300_;
                                                    if _e882 {
                                                        phi_1306_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1306_ = type_15(1u, _e877);
                                                    }
                                                    let _e887 = phi_1306_;
                                                    phi_1277_ = type_14(_e887.member_1, _e868.member_1);
                                                    phi_1320_ = type_15(1u, _e868.member);
                                                } else {
                                                    phi_1277_ = _e868;
                                                    phi_1320_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e893 = phi_1277_;
                                                let _e895 = phi_1320_;
                                                let _e898 = (bitcast<i32>(_e895.member) != 0i);
                                                if _e898 {
                                                    phi_1280_ = (0.5f * (_e870 + (_e860 / _e870)));
                                                } else {
                                                    phi_1280_ = f32();
                                                }
                                                let _e903 = phi_1280_;
                                                continue;
                                                continuing {
                                                    phi_1276_ = _e893;
                                                    phi_1279_ = _e903;
                                                    break if !(_e898);
                                                }
                                            }
                                            let _e908 = local_1;
                                            phi_1333_ = (_e908 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e915 = phi_1333_;
                                        if (_e858 > 0f) {
                                            phi_1340_ = (_e858 + _e915);
                                        } else {
                                            phi_1340_ = (_e858 - _e915);
                                        }
                                        let _e920 = phi_1340_;
                                        let _e923 = (_e820.member_1[2] - (_e820.member_1[0] - (_e820.member[0] / _e920)));
                                        let _e926 = ((_e923 * _e923) + (_e820.member[1] * _e820.member[1]));
                                        if (_e926 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e926 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e926 > 0f) {
                                                    phi_1367_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1367_ = 0f;
                                                }
                                                let _e983 = phi_1367_;
                                                phi_1431_ = _e983;
                                            } else {
                                                phi_1374_ = type_14(0i, 5i);
                                                phi_1377_ = bitcast<f32>(((bitcast<u32>(_e926) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e938 = phi_1374_;
                                                    let _e940 = phi_1377_;
                                                    local_2 = _e940;
                                                    if (_e938.member < _e938.member_1) {
                                                        let _e947 = (_e938.member + 1i);
                                                        if ((false == (_e947 > _e938.member)) != false) {
                                                            phi_1398_ = true;
                                                        } else {
                                                            phi_1398_ = false;
                                                        }
                                                        let _e952 = phi_1398_;
                                                        if _e952 {
                                                            phi_1404_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1404_ = type_15(1u, _e947);
                                                        }
                                                        let _e957 = phi_1404_;
                                                        phi_1375_ = type_14(_e957.member_1, _e938.member_1);
                                                        phi_1418_ = type_15(1u, _e938.member);
                                                    } else {
                                                        phi_1375_ = _e938;
                                                        phi_1418_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e963 = phi_1375_;
                                                    let _e965 = phi_1418_;
                                                    let _e968 = (bitcast<i32>(_e965.member) != 0i);
                                                    if _e968 {
                                                        phi_1378_ = (0.5f * (_e940 + (_e926 / _e940)));
                                                    } else {
                                                        phi_1378_ = f32();
                                                    }
                                                    let _e973 = phi_1378_;
                                                    continue;
                                                    continuing {
                                                        phi_1374_ = _e963;
                                                        phi_1377_ = _e973;
                                                        break if !(_e968);
                                                    }
                                                }
                                                let _e978 = local_2;
                                                phi_1431_ = (_e978 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e985 = phi_1431_;
                                            let _e986 = (_e923 / _e985);
                                            let _e987 = (_e820.member[1] / _e985);
                                            let _e992 = (1.5f - (((_e986 * _e986) + (_e987 * _e987)) * 0.5f));
                                            phi_1443_ = type_34((_e986 * _e992), (_e987 * _e992));
                                        } else {
                                            phi_1443_ = type_34(1f, 0f);
                                        }
                                        let _e997 = phi_1443_;
                                        let _e1014 = (((_e820.member_1[1] - _e820.member_1[2]) * _e997.member_1) + ((_e997.member * _e820.member[1]) * 2f));
                                        let _e1016 = (_e820.member_1[1] - (_e997.member_1 * _e1014));
                                        let _e1020 = ((_e997.member * _e1014) - _e820.member[1]);
                                        let _e1033 = ((_e820.member_2[1][0] * _e997.member) - (_e820.member_2[2][0] * _e997.member_1));
                                        let _e1034 = ((_e820.member_2[1][1] * _e997.member) - (_e820.member_2[2][1] * _e997.member_1));
                                        let _e1035 = ((_e820.member_2[1][2] * _e997.member) - (_e820.member_2[2][2] * _e997.member_1));
                                        let _e1052 = (_e997.member * _e820.member[0]);
                                        let _e1053 = (_e997.member_1 * _e820.member[0]);
                                        let _e1056 = ((_e1020 * _e1020) + (_e1053 * _e1053));
                                        if (_e1056 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1056 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1056 > 0f) {
                                                    phi_1532_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1532_ = 0f;
                                                }
                                                let _e1113 = phi_1532_;
                                                phi_1596_ = _e1113;
                                            } else {
                                                phi_1539_ = type_14(0i, 5i);
                                                phi_1542_ = bitcast<f32>(((bitcast<u32>(_e1056) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1068 = phi_1539_;
                                                    let _e1070 = phi_1542_;
                                                    local_3 = _e1070;
                                                    if (_e1068.member < _e1068.member_1) {
                                                        let _e1077 = (_e1068.member + 1i);
                                                        if ((false == (_e1077 > _e1068.member)) != false) {
                                                            phi_1563_ = true;
                                                        } else {
                                                            phi_1563_ = false;
                                                        }
                                                        let _e1082 = phi_1563_;
                                                        if _e1082 {
                                                            phi_1569_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1569_ = type_15(1u, _e1077);
                                                        }
                                                        let _e1087 = phi_1569_;
                                                        phi_1540_ = type_14(_e1087.member_1, _e1068.member_1);
                                                        phi_1583_ = type_15(1u, _e1068.member);
                                                    } else {
                                                        phi_1540_ = _e1068;
                                                        phi_1583_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1093 = phi_1540_;
                                                    let _e1095 = phi_1583_;
                                                    let _e1098 = (bitcast<i32>(_e1095.member) != 0i);
                                                    if _e1098 {
                                                        phi_1543_ = (0.5f * (_e1070 + (_e1056 / _e1070)));
                                                    } else {
                                                        phi_1543_ = f32();
                                                    }
                                                    let _e1103 = phi_1543_;
                                                    continue;
                                                    continuing {
                                                        phi_1539_ = _e1093;
                                                        phi_1542_ = _e1103;
                                                        break if !(_e1098);
                                                    }
                                                }
                                                let _e1108 = local_3;
                                                phi_1596_ = (_e1108 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1115 = phi_1596_;
                                            let _e1116 = (_e1020 / _e1115);
                                            let _e1117 = (_e1053 / _e1115);
                                            let _e1122 = (1.5f - (((_e1116 * _e1116) + (_e1117 * _e1117)) * 0.5f));
                                            phi_1608_ = type_34((_e1116 * _e1122), (_e1117 * _e1122));
                                        } else {
                                            phi_1608_ = type_34(1f, 0f);
                                        }
                                        let _e1127 = phi_1608_;
                                        let _e1137 = (((_e820.member_1[0] - _e1016) * _e1127.member_1) + ((_e1127.member * _e1052) * 2f));
                                        phi_1675_ = type_36(array<f32, 2>(((_e1127.member * _e1137) - _e1052), ((_e1127.member_1 * _e1053) + (_e1127.member * _e1020))), array<f32, 3>((_e820.member_1[0] - (_e1127.member_1 * _e1137)), (_e1016 + (_e1127.member_1 * _e1137)), (_e820.member_1[2] + (_e997.member_1 * _e1014))), array<array<f32, 3>, 3>(array<f32, 3>(((_e820.member_2[0][0] * _e1127.member) - (_e1033 * _e1127.member_1)), ((_e820.member_2[0][1] * _e1127.member) - (_e1034 * _e1127.member_1)), ((_e820.member_2[0][2] * _e1127.member) - (_e1035 * _e1127.member_1))), array<f32, 3>(((_e820.member_2[0][0] * _e1127.member_1) + (_e1033 * _e1127.member)), ((_e820.member_2[0][1] * _e1127.member_1) + (_e1034 * _e1127.member)), ((_e820.member_2[0][2] * _e1127.member_1) + (_e1035 * _e1127.member))), array<f32, 3>(((_e820.member_2[1][0] * _e997.member_1) + (_e820.member_2[2][0] * _e997.member)), ((_e820.member_2[1][1] * _e997.member_1) + (_e820.member_2[2][1] * _e997.member)), ((_e820.member_2[1][2] * _e997.member_1) + (_e820.member_2[2][2] * _e997.member)))));
                                        phi_1676_ = false;
                                    } else {
                                        phi_1675_ = type_36();
                                        phi_1676_ = true;
                                    }
                                    let _e1175 = phi_1675_;
                                    let _e1177 = phi_1676_;
                                    phi_1677_ = _e1175;
                                    phi_1678_ = _e1177;
                                } else {
                                    phi_1677_ = type_36();
                                    phi_1678_ = true;
                                }
                                let _e1179 = phi_1677_;
                                let _e1181 = phi_1678_;
                                if _e1181 {
                                    if _e850 {
                                        let _e1425 = ((_e820.member_1[1] - _e820.member_1[0]) / (_e820.member[0] * 2f));
                                        let _e1427 = ((_e1425 * _e1425) + 1f);
                                        if (_e1427 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1427 > 0f) {
                                                phi_1703_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1703_ = 0f;
                                            }
                                            let _e1480 = phi_1703_;
                                            phi_1767_ = _e1480;
                                        } else {
                                            phi_1710_ = type_14(0i, 5i);
                                            phi_1713_ = bitcast<f32>(((bitcast<u32>(_e1427) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1435 = phi_1710_;
                                                let _e1437 = phi_1713_;
                                                local_6 = _e1437;
                                                if (_e1435.member < _e1435.member_1) {
                                                    let _e1444 = (_e1435.member + 1i);
                                                    if ((false == (_e1444 > _e1435.member)) != false) {
                                                        phi_1734_ = true;
                                                    } else {
                                                        phi_1734_ = false;
                                                    }
                                                    let _e1449 = phi_1734_;
                                                    if _e1449 {
                                                        phi_1740_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1740_ = type_15(1u, _e1444);
                                                    }
                                                    let _e1454 = phi_1740_;
                                                    phi_1711_ = type_14(_e1454.member_1, _e1435.member_1);
                                                    phi_1754_ = type_15(1u, _e1435.member);
                                                } else {
                                                    phi_1711_ = _e1435;
                                                    phi_1754_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1460 = phi_1711_;
                                                let _e1462 = phi_1754_;
                                                let _e1465 = (bitcast<i32>(_e1462.member) != 0i);
                                                if _e1465 {
                                                    phi_1714_ = (0.5f * (_e1437 + (_e1427 / _e1437)));
                                                } else {
                                                    phi_1714_ = f32();
                                                }
                                                let _e1470 = phi_1714_;
                                                continue;
                                                continuing {
                                                    phi_1710_ = _e1460;
                                                    phi_1713_ = _e1470;
                                                    break if !(_e1465);
                                                }
                                            }
                                            let _e1475 = local_6;
                                            phi_1767_ = (_e1475 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1482 = phi_1767_;
                                        if (_e1425 > 0f) {
                                            phi_1774_ = (_e1425 + _e1482);
                                        } else {
                                            phi_1774_ = (_e1425 - _e1482);
                                        }
                                        let _e1487 = phi_1774_;
                                        let _e1490 = (_e820.member_1[1] - (_e820.member_1[0] - (_e820.member[0] / _e1487)));
                                        let _e1493 = ((_e1490 * _e1490) + (_e820.member[0] * _e820.member[0]));
                                        if (_e1493 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1493 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1493 > 0f) {
                                                    phi_1801_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1801_ = 0f;
                                                }
                                                let _e1550 = phi_1801_;
                                                phi_1865_ = _e1550;
                                            } else {
                                                phi_1808_ = type_14(0i, 5i);
                                                phi_1811_ = bitcast<f32>(((bitcast<u32>(_e1493) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1505 = phi_1808_;
                                                    let _e1507 = phi_1811_;
                                                    local_7 = _e1507;
                                                    if (_e1505.member < _e1505.member_1) {
                                                        let _e1514 = (_e1505.member + 1i);
                                                        if ((false == (_e1514 > _e1505.member)) != false) {
                                                            phi_1832_ = true;
                                                        } else {
                                                            phi_1832_ = false;
                                                        }
                                                        let _e1519 = phi_1832_;
                                                        if _e1519 {
                                                            phi_1838_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1838_ = type_15(1u, _e1514);
                                                        }
                                                        let _e1524 = phi_1838_;
                                                        phi_1809_ = type_14(_e1524.member_1, _e1505.member_1);
                                                        phi_1852_ = type_15(1u, _e1505.member);
                                                    } else {
                                                        phi_1809_ = _e1505;
                                                        phi_1852_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1530 = phi_1809_;
                                                    let _e1532 = phi_1852_;
                                                    let _e1535 = (bitcast<i32>(_e1532.member) != 0i);
                                                    if _e1535 {
                                                        phi_1812_ = (0.5f * (_e1507 + (_e1493 / _e1507)));
                                                    } else {
                                                        phi_1812_ = f32();
                                                    }
                                                    let _e1540 = phi_1812_;
                                                    continue;
                                                    continuing {
                                                        phi_1808_ = _e1530;
                                                        phi_1811_ = _e1540;
                                                        break if !(_e1535);
                                                    }
                                                }
                                                let _e1545 = local_7;
                                                phi_1865_ = (_e1545 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1552 = phi_1865_;
                                            let _e1553 = (_e1490 / _e1552);
                                            let _e1554 = (_e820.member[0] / _e1552);
                                            let _e1559 = (1.5f - (((_e1553 * _e1553) + (_e1554 * _e1554)) * 0.5f));
                                            phi_1877_ = type_34((_e1553 * _e1559), (_e1554 * _e1559));
                                        } else {
                                            phi_1877_ = type_34(1f, 0f);
                                        }
                                        let _e1564 = phi_1877_;
                                        let _e1581 = (((_e820.member_1[0] - _e820.member_1[1]) * _e1564.member_1) + ((_e1564.member * _e820.member[0]) * 2f));
                                        let _e1583 = (_e820.member_1[0] - (_e1564.member_1 * _e1581));
                                        let _e1585 = (_e820.member_1[1] + (_e1564.member_1 * _e1581));
                                        let _e1594 = type_36(_e820.member, array<f32, 3>(_e1583, _e820.member_1[1], _e820.member_1[2]), _e820.member_2);
                                        let _e1601 = type_36(_e1594.member, array<f32, 3>(_e1594.member_1[0], _e1585, _e1594.member_1[2]), _e1594.member_2);
                                        let _e1605 = type_36(_e1601.member, array<f32, 3>(_e1583, _e1585, _e820.member_1[2]), _e1601.member_2);
                                        let _e1611 = type_36(array<f32, 2>(((_e1564.member * _e1581) - _e820.member[0]), _e1605.member[1]), _e1605.member_1, _e1605.member_2);
                                        let _e1627 = array<f32, 3>(((_e820.member_2[0][0] * _e1564.member) - (_e820.member_2[1][0] * _e1564.member_1)), ((_e820.member_2[0][1] * _e1564.member) - (_e820.member_2[1][1] * _e1564.member_1)), ((_e820.member_2[0][2] * _e1564.member) - (_e820.member_2[1][2] * _e1564.member_1)));
                                        let _e1643 = array<f32, 3>(((_e820.member_2[0][0] * _e1564.member_1) + (_e820.member_2[1][0] * _e1564.member)), ((_e820.member_2[0][1] * _e1564.member_1) + (_e820.member_2[1][1] * _e1564.member)), ((_e820.member_2[0][2] * _e1564.member_1) + (_e820.member_2[1][2] * _e1564.member)));
                                        let _e1650 = type_36(_e1611.member, _e1611.member_1, array<array<f32, 3>, 3>(_e1627, _e1611.member_2[1], _e1611.member_2[2]));
                                        let _e1657 = type_36(_e1650.member, _e1650.member_1, array<array<f32, 3>, 3>(_e1650.member_2[0], _e1643, _e1650.member_2[2]));
                                        phi_2197_ = type_36(_e1657.member, _e1657.member_1, array<array<f32, 3>, 3>(_e1627, _e1643, _e820.member_2[2]));
                                    } else {
                                        if _e855 {
                                            let _e1184 = ((_e820.member_1[2] - _e820.member_1[1]) / (_e820.member[1] * 2f));
                                            let _e1186 = ((_e1184 * _e1184) + 1f);
                                            if (_e1186 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1186 > 0f) {
                                                    phi_1960_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1960_ = 0f;
                                                }
                                                let _e1239 = phi_1960_;
                                                phi_2024_ = _e1239;
                                            } else {
                                                phi_1967_ = type_14(0i, 5i);
                                                phi_1970_ = bitcast<f32>(((bitcast<u32>(_e1186) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1194 = phi_1967_;
                                                    let _e1196 = phi_1970_;
                                                    local_4 = _e1196;
                                                    if (_e1194.member < _e1194.member_1) {
                                                        let _e1203 = (_e1194.member + 1i);
                                                        if ((false == (_e1203 > _e1194.member)) != false) {
                                                            phi_1991_ = true;
                                                        } else {
                                                            phi_1991_ = false;
                                                        }
                                                        let _e1208 = phi_1991_;
                                                        if _e1208 {
                                                            phi_1997_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1997_ = type_15(1u, _e1203);
                                                        }
                                                        let _e1213 = phi_1997_;
                                                        phi_1968_ = type_14(_e1213.member_1, _e1194.member_1);
                                                        phi_2011_ = type_15(1u, _e1194.member);
                                                    } else {
                                                        phi_1968_ = _e1194;
                                                        phi_2011_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1219 = phi_1968_;
                                                    let _e1221 = phi_2011_;
                                                    let _e1224 = (bitcast<i32>(_e1221.member) != 0i);
                                                    if _e1224 {
                                                        phi_1971_ = (0.5f * (_e1196 + (_e1186 / _e1196)));
                                                    } else {
                                                        phi_1971_ = f32();
                                                    }
                                                    let _e1229 = phi_1971_;
                                                    continue;
                                                    continuing {
                                                        phi_1967_ = _e1219;
                                                        phi_1970_ = _e1229;
                                                        break if !(_e1224);
                                                    }
                                                }
                                                let _e1234 = local_4;
                                                phi_2024_ = (_e1234 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1241 = phi_2024_;
                                            if (_e1184 > 0f) {
                                                phi_2031_ = (_e1184 + _e1241);
                                            } else {
                                                phi_2031_ = (_e1184 - _e1241);
                                            }
                                            let _e1246 = phi_2031_;
                                            let _e1249 = (_e820.member_1[2] - (_e820.member_1[1] - (_e820.member[1] / _e1246)));
                                            let _e1252 = ((_e1249 * _e1249) + (_e820.member[1] * _e820.member[1]));
                                            if (_e1252 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                if (_e1252 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e1252 > 0f) {
                                                        phi_2058_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_2058_ = 0f;
                                                    }
                                                    let _e1309 = phi_2058_;
                                                    phi_2122_ = _e1309;
                                                } else {
                                                    phi_2065_ = type_14(0i, 5i);
                                                    phi_2068_ = bitcast<f32>(((bitcast<u32>(_e1252) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1264 = phi_2065_;
                                                        let _e1266 = phi_2068_;
                                                        local_5 = _e1266;
                                                        if (_e1264.member < _e1264.member_1) {
                                                            let _e1273 = (_e1264.member + 1i);
                                                            if ((false == (_e1273 > _e1264.member)) != false) {
                                                                phi_2089_ = true;
                                                            } else {
                                                                phi_2089_ = false;
                                                            }
                                                            let _e1278 = phi_2089_;
                                                            if _e1278 {
                                                                phi_2095_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_2095_ = type_15(1u, _e1273);
                                                            }
                                                            let _e1283 = phi_2095_;
                                                            phi_2066_ = type_14(_e1283.member_1, _e1264.member_1);
                                                            phi_2109_ = type_15(1u, _e1264.member);
                                                        } else {
                                                            phi_2066_ = _e1264;
                                                            phi_2109_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1289 = phi_2066_;
                                                        let _e1291 = phi_2109_;
                                                        let _e1294 = (bitcast<i32>(_e1291.member) != 0i);
                                                        if _e1294 {
                                                            phi_2069_ = (0.5f * (_e1266 + (_e1252 / _e1266)));
                                                        } else {
                                                            phi_2069_ = f32();
                                                        }
                                                        let _e1299 = phi_2069_;
                                                        continue;
                                                        continuing {
                                                            phi_2065_ = _e1289;
                                                            phi_2068_ = _e1299;
                                                            break if !(_e1294);
                                                        }
                                                    }
                                                    let _e1304 = local_5;
                                                    phi_2122_ = (_e1304 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1311 = phi_2122_;
                                                let _e1312 = (_e1249 / _e1311);
                                                let _e1313 = (_e820.member[1] / _e1311);
                                                let _e1318 = (1.5f - (((_e1312 * _e1312) + (_e1313 * _e1313)) * 0.5f));
                                                phi_2134_ = type_34((_e1312 * _e1318), (_e1313 * _e1318));
                                            } else {
                                                phi_2134_ = type_34(1f, 0f);
                                            }
                                            let _e1323 = phi_2134_;
                                            let _e1340 = (((_e820.member_1[1] - _e820.member_1[2]) * _e1323.member_1) + ((_e1323.member * _e820.member[1]) * 2f));
                                            let _e1342 = (_e820.member_1[1] - (_e1323.member_1 * _e1340));
                                            let _e1353 = type_36(_e820.member, array<f32, 3>(_e820.member_1[0], _e820.member_1[1], _e820.member_1[2]), _e820.member_2);
                                            let _e1360 = type_36(_e1353.member, array<f32, 3>(_e1353.member_1[0], _e1342, _e1353.member_1[2]), _e1353.member_2);
                                            let _e1364 = type_36(_e1360.member, array<f32, 3>(_e820.member_1[0], _e1342, (_e820.member_1[2] + (_e1323.member_1 * _e1340))), _e1360.member_2);
                                            let _e1370 = type_36(array<f32, 2>(_e1364.member[0], ((_e1323.member * _e1340) - _e820.member[1])), _e1364.member_1, _e1364.member_2);
                                            let _e1386 = array<f32, 3>(((_e820.member_2[1][0] * _e1323.member) - (_e820.member_2[2][0] * _e1323.member_1)), ((_e820.member_2[1][1] * _e1323.member) - (_e820.member_2[2][1] * _e1323.member_1)), ((_e820.member_2[1][2] * _e1323.member) - (_e820.member_2[2][2] * _e1323.member_1)));
                                            let _e1409 = type_36(_e1370.member, _e1370.member_1, array<array<f32, 3>, 3>(_e820.member_2[0], _e1370.member_2[1], _e1370.member_2[2]));
                                            let _e1416 = type_36(_e1409.member, _e1409.member_1, array<array<f32, 3>, 3>(_e1409.member_2[0], _e1386, _e1409.member_2[2]));
                                            phi_2196_ = type_36(_e1416.member, _e1416.member_1, array<array<f32, 3>, 3>(_e820.member_2[0], _e1386, array<f32, 3>(((_e820.member_2[1][0] * _e1323.member_1) + (_e820.member_2[2][0] * _e1323.member)), ((_e820.member_2[1][1] * _e1323.member_1) + (_e820.member_2[2][1] * _e1323.member)), ((_e820.member_2[1][2] * _e1323.member_1) + (_e820.member_2[2][2] * _e1323.member)))));
                                        } else {
                                            phi_2196_ = _e820;
                                        }
                                        let _e1422 = phi_2196_;
                                        phi_2197_ = _e1422;
                                    }
                                    let _e1663 = phi_2197_;
                                    phi_2198_ = _e1663;
                                } else {
                                    phi_2198_ = _e1179;
                                }
                                let _e1665 = phi_2198_;
                                if _e850 {
                                    phi_2202_ = true;
                                } else {
                                    phi_2202_ = _e855;
                                }
                                let _e1667 = phi_2202_;
                                if _e1667 {
                                    phi_2206_ = false;
                                } else {
                                    phi_2206_ = true;
                                }
                                let _e1669 = phi_2206_;
                                phi_1194_ = _e1665;
                                phi_2207_ = _e1665;
                                phi_2208_ = _e1667;
                                phi_2209_ = _e1669;
                            } else {
                                phi_1194_ = type_36();
                                phi_2207_ = type_36();
                                phi_2208_ = false;
                                phi_2209_ = false;
                            }
                            let _e1671 = phi_1194_;
                            let _e1673 = phi_2207_;
                            let _e1675 = phi_2208_;
                            let _e1677 = phi_2209_;
                            local_8 = _e1677;
                            local_13 = _e1673;
                            continue;
                            continuing {
                                phi_1190_ = _e832;
                                phi_1193_ = _e1671;
                                break if !(_e1675);
                            }
                        }
                        let _e1680 = local_8;
                        if _e1680 {
                            let _e3540 = local_13;
                            phi_2213_ = _e3540;
                        } else {
                            let _e3542 = local_14;
                            phi_2213_ = _e3542;
                        }
                        let _e1682 = phi_2213_;
                        let _e1686 = (2130706432u - (bitcast<u32>(_e701) & 2139095040u));
                        if (_e1686 > 8388608u) {
                            phi_2225_ = _e1686;
                        } else {
                            phi_2225_ = 8388608u;
                        }
                        let _e1689 = phi_2225_;
                        let _e1690 = bitcast<f32>(_e1689);
                        let _e1712 = ((((_e1682.member_2[0][0] * _e1682.member_2[0][0]) + (_e1682.member_2[0][1] * _e1682.member_2[0][1])) + (_e1682.member_2[0][2] * _e1682.member_2[0][2])) - 1f);
                        let _e1726 = ((((_e1682.member_2[1][0] * _e1682.member_2[1][0]) + (_e1682.member_2[1][1] * _e1682.member_2[1][1])) + (_e1682.member_2[1][2] * _e1682.member_2[1][2])) - 1f);
                        let _e1740 = ((((_e1682.member_2[2][0] * _e1682.member_2[2][0]) + (_e1682.member_2[2][1] * _e1682.member_2[2][1])) + (_e1682.member_2[2][2] * _e1682.member_2[2][2])) - 1f);
                        let _e1753 = (((_e1682.member_2[0][0] * _e1682.member_2[1][0]) + (_e1682.member_2[0][1] * _e1682.member_2[1][1])) + (_e1682.member_2[0][2] * _e1682.member_2[1][2]));
                        let _e1766 = (((_e1682.member_2[0][0] * _e1682.member_2[2][0]) + (_e1682.member_2[0][1] * _e1682.member_2[2][1])) + (_e1682.member_2[0][2] * _e1682.member_2[2][2]));
                        let _e1779 = (((_e1682.member_2[1][0] * _e1682.member_2[2][0]) + (_e1682.member_2[1][1] * _e1682.member_2[2][1])) + (_e1682.member_2[1][2] * _e1682.member_2[2][2]));
                        let _e1812 = (_e1682.member_2[0][0] - ((((_e1682.member_2[0][0] * _e1712) + (_e1682.member_2[1][0] * _e1753)) + (_e1682.member_2[2][0] * _e1766)) * 0.5f));
                        let _e1814 = (_e1682.member_2[0][1] - ((((_e1682.member_2[0][1] * _e1712) + (_e1682.member_2[1][1] * _e1753)) + (_e1682.member_2[2][1] * _e1766)) * 0.5f));
                        let _e1816 = (_e1682.member_2[0][2] - ((((_e1682.member_2[0][2] * _e1712) + (_e1682.member_2[1][2] * _e1753)) + (_e1682.member_2[2][2] * _e1766)) * 0.5f));
                        if (_e1812 < 0f) {
                            phi_2358_ = -(_e1812);
                        } else {
                            phi_2358_ = _e1812;
                        }
                        let _e1820 = phi_2358_;
                        if (_e1820 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2364_ = _e1812;
                        } else {
                            phi_2364_ = 0f;
                        }
                        let _e1824 = phi_2364_;
                        if (_e1814 < 0f) {
                            phi_2370_ = -(_e1814);
                        } else {
                            phi_2370_ = _e1814;
                        }
                        let _e1828 = phi_2370_;
                        if (_e1828 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2376_ = _e1814;
                        } else {
                            phi_2376_ = 0f;
                        }
                        let _e1832 = phi_2376_;
                        if (_e1816 < 0f) {
                            phi_2382_ = -(_e1816);
                        } else {
                            phi_2382_ = _e1816;
                        }
                        let _e1836 = phi_2382_;
                        if (_e1836 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2388_ = _e1816;
                        } else {
                            phi_2388_ = 0f;
                        }
                        let _e1840 = phi_2388_;
                        let _e1874 = (_e1682.member_2[1][0] - ((((_e1682.member_2[0][0] * _e1753) + (_e1682.member_2[1][0] * _e1726)) + (_e1682.member_2[2][0] * _e1779)) * 0.5f));
                        let _e1876 = (_e1682.member_2[1][1] - ((((_e1682.member_2[0][1] * _e1753) + (_e1682.member_2[1][1] * _e1726)) + (_e1682.member_2[2][1] * _e1779)) * 0.5f));
                        let _e1878 = (_e1682.member_2[1][2] - ((((_e1682.member_2[0][2] * _e1753) + (_e1682.member_2[1][2] * _e1726)) + (_e1682.member_2[2][2] * _e1779)) * 0.5f));
                        if (_e1874 < 0f) {
                            phi_2432_ = -(_e1874);
                        } else {
                            phi_2432_ = _e1874;
                        }
                        let _e1882 = phi_2432_;
                        if (_e1882 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2438_ = _e1874;
                        } else {
                            phi_2438_ = 0f;
                        }
                        let _e1886 = phi_2438_;
                        if (_e1876 < 0f) {
                            phi_2444_ = -(_e1876);
                        } else {
                            phi_2444_ = _e1876;
                        }
                        let _e1890 = phi_2444_;
                        if (_e1890 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2450_ = _e1876;
                        } else {
                            phi_2450_ = 0f;
                        }
                        let _e1894 = phi_2450_;
                        if (_e1878 < 0f) {
                            phi_2456_ = -(_e1878);
                        } else {
                            phi_2456_ = _e1878;
                        }
                        let _e1898 = phi_2456_;
                        if (_e1898 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2462_ = _e1878;
                        } else {
                            phi_2462_ = 0f;
                        }
                        let _e1902 = phi_2462_;
                        let _e1936 = (_e1682.member_2[2][0] - ((((_e1682.member_2[0][0] * _e1766) + (_e1682.member_2[1][0] * _e1779)) + (_e1682.member_2[2][0] * _e1740)) * 0.5f));
                        let _e1938 = (_e1682.member_2[2][1] - ((((_e1682.member_2[0][1] * _e1766) + (_e1682.member_2[1][1] * _e1779)) + (_e1682.member_2[2][1] * _e1740)) * 0.5f));
                        let _e1940 = (_e1682.member_2[2][2] - ((((_e1682.member_2[0][2] * _e1766) + (_e1682.member_2[1][2] * _e1779)) + (_e1682.member_2[2][2] * _e1740)) * 0.5f));
                        if (_e1936 < 0f) {
                            phi_2506_ = -(_e1936);
                        } else {
                            phi_2506_ = _e1936;
                        }
                        let _e1944 = phi_2506_;
                        if (_e1944 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2512_ = _e1936;
                        } else {
                            phi_2512_ = 0f;
                        }
                        let _e1948 = phi_2512_;
                        if (_e1938 < 0f) {
                            phi_2518_ = -(_e1938);
                        } else {
                            phi_2518_ = _e1938;
                        }
                        let _e1952 = phi_2518_;
                        if (_e1952 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2524_ = _e1938;
                        } else {
                            phi_2524_ = 0f;
                        }
                        let _e1956 = phi_2524_;
                        if (_e1940 < 0f) {
                            phi_2530_ = -(_e1940);
                        } else {
                            phi_2530_ = _e1940;
                        }
                        let _e1960 = phi_2530_;
                        if (_e1960 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2536_ = _e1940;
                        } else {
                            phi_2536_ = 0f;
                        }
                        let _e1964 = phi_2536_;
                        let _e1972 = ((((_e1824 * _e1824) + (_e1832 * _e1832)) + (_e1840 * _e1840)) - 1f);
                        let _e1978 = ((((_e1886 * _e1886) + (_e1894 * _e1894)) + (_e1902 * _e1902)) - 1f);
                        let _e1984 = ((((_e1948 * _e1948) + (_e1956 * _e1956)) + (_e1964 * _e1964)) - 1f);
                        let _e1989 = (((_e1824 * _e1886) + (_e1832 * _e1894)) + (_e1840 * _e1902));
                        let _e1994 = (((_e1824 * _e1948) + (_e1832 * _e1956)) + (_e1840 * _e1964));
                        let _e1999 = (((_e1886 * _e1948) + (_e1894 * _e1956)) + (_e1902 * _e1964));
                        if (_e1972 < 0f) {
                            phi_2577_ = -(_e1972);
                        } else {
                            phi_2577_ = _e1972;
                        }
                        let _e2003 = phi_2577_;
                        if (_e1978 < 0f) {
                            phi_2583_ = -(_e1978);
                        } else {
                            phi_2583_ = _e1978;
                        }
                        let _e2007 = phi_2583_;
                        if (_e2003 > _e2007) {
                            phi_2588_ = _e2003;
                        } else {
                            phi_2588_ = _e2007;
                        }
                        let _e2010 = phi_2588_;
                        if (_e1984 < 0f) {
                            phi_2594_ = -(_e1984);
                        } else {
                            phi_2594_ = _e1984;
                        }
                        let _e2014 = phi_2594_;
                        if (_e2010 > _e2014) {
                            phi_2599_ = _e2010;
                        } else {
                            phi_2599_ = _e2014;
                        }
                        let _e2017 = phi_2599_;
                        if (_e1989 < 0f) {
                            phi_2605_ = -(_e1989);
                        } else {
                            phi_2605_ = _e1989;
                        }
                        let _e2021 = phi_2605_;
                        if (_e1994 < 0f) {
                            phi_2611_ = -(_e1994);
                        } else {
                            phi_2611_ = _e1994;
                        }
                        let _e2025 = phi_2611_;
                        if (_e2021 > _e2025) {
                            phi_2616_ = _e2021;
                        } else {
                            phi_2616_ = _e2025;
                        }
                        let _e2028 = phi_2616_;
                        if (_e1999 < 0f) {
                            phi_2622_ = -(_e1999);
                        } else {
                            phi_2622_ = _e1999;
                        }
                        let _e2032 = phi_2622_;
                        if (_e2028 > _e2032) {
                            phi_2627_ = _e2028;
                        } else {
                            phi_2627_ = _e2032;
                        }
                        let _e2035 = phi_2627_;
                        if (_e2017 > _e2035) {
                            phi_2632_ = _e2017;
                        } else {
                            phi_2632_ = _e2035;
                        }
                        let _e2038 = phi_2632_;
                        if (_e2038 <= (0.000000059604645f * (16f - 4f))) {
                            phi_2643_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1824, _e1832, _e1840), array<f32, 3>(_e1886, _e1894, _e1902), array<f32, 3>(_e1948, _e1956, _e1964));
                        } else {
                            phi_2643_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                        }
                        let _e2043 = phi_2643_;
                        phi_2645_ = type_37(array<f32, 3>((_e1682.member_1[0] * _e1690), (_e1682.member_1[1] * _e1690), (_e1682.member_1[2] * _e1690)), _e2043);
                        phi_2646_ = false;
                    } else {
                        phi_2645_ = type_37();
                        phi_2646_ = true;
                    }
                    let _e2046 = phi_2645_;
                    let _e2048 = phi_2646_;
                    phi_2647_ = _e2046;
                    phi_2648_ = _e2048;
                } else {
                    phi_2647_ = type_37();
                    phi_2648_ = true;
                }
                let _e2050 = phi_2647_;
                let _e2052 = phi_2648_;
                if _e2052 {
                    phi_2661_ = type_37(array<f32, 3>(_e643, _e647, _e651), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                } else {
                    phi_2661_ = _e2050;
                }
                let _e2056 = phi_2661_;
                let _e2071 = (((_e269.member_1[0][0] * _e2056.member_1[0][0]) + (_e269.member_1[0][1] * _e2056.member_1[0][1])) + (_e269.member_1[0][2] * _e2056.member_1[0][2]));
                let _e2084 = (((_e269.member_1[1][0] * _e2056.member_1[0][0]) + (_e269.member_1[1][1] * _e2056.member_1[0][1])) + (_e269.member_1[1][2] * _e2056.member_1[0][2]));
                let _e2097 = (((_e269.member_1[2][0] * _e2056.member_1[0][0]) + (_e269.member_1[2][1] * _e2056.member_1[0][1])) + (_e269.member_1[2][2] * _e2056.member_1[0][2]));
                if (_e2071 < 0f) {
                    phi_2706_ = -(_e2071);
                } else {
                    phi_2706_ = _e2071;
                }
                let _e2102 = phi_2706_;
                if (_e2084 < 0f) {
                    phi_2712_ = -(_e2084);
                } else {
                    phi_2712_ = _e2084;
                }
                let _e2106 = phi_2712_;
                if (_e2097 < 0f) {
                    phi_2718_ = -(_e2097);
                } else {
                    phi_2718_ = _e2097;
                }
                let _e2110 = phi_2718_;
                let _e2118 = (((_e2102 * _e269.member_2[0]) + (_e2106 * _e269.member_2[1])) + (_e2110 * _e269.member_2[2]));
                let _e2132 = (((_e269.member_1[0][0] * _e2056.member_1[1][0]) + (_e269.member_1[0][1] * _e2056.member_1[1][1])) + (_e269.member_1[0][2] * _e2056.member_1[1][2]));
                let _e2145 = (((_e269.member_1[1][0] * _e2056.member_1[1][0]) + (_e269.member_1[1][1] * _e2056.member_1[1][1])) + (_e269.member_1[1][2] * _e2056.member_1[1][2]));
                let _e2158 = (((_e269.member_1[2][0] * _e2056.member_1[1][0]) + (_e269.member_1[2][1] * _e2056.member_1[1][1])) + (_e269.member_1[2][2] * _e2056.member_1[1][2]));
                if (_e2132 < 0f) {
                    phi_2770_ = -(_e2132);
                } else {
                    phi_2770_ = _e2132;
                }
                let _e2163 = phi_2770_;
                if (_e2145 < 0f) {
                    phi_2776_ = -(_e2145);
                } else {
                    phi_2776_ = _e2145;
                }
                let _e2167 = phi_2776_;
                if (_e2158 < 0f) {
                    phi_2782_ = -(_e2158);
                } else {
                    phi_2782_ = _e2158;
                }
                let _e2171 = phi_2782_;
                let _e2179 = (((_e2163 * _e269.member_2[0]) + (_e2167 * _e269.member_2[1])) + (_e2171 * _e269.member_2[2]));
                let _e2193 = (((_e269.member_1[0][0] * _e2056.member_1[2][0]) + (_e269.member_1[0][1] * _e2056.member_1[2][1])) + (_e269.member_1[0][2] * _e2056.member_1[2][2]));
                let _e2206 = (((_e269.member_1[1][0] * _e2056.member_1[2][0]) + (_e269.member_1[1][1] * _e2056.member_1[2][1])) + (_e269.member_1[1][2] * _e2056.member_1[2][2]));
                let _e2219 = (((_e269.member_1[2][0] * _e2056.member_1[2][0]) + (_e269.member_1[2][1] * _e2056.member_1[2][1])) + (_e269.member_1[2][2] * _e2056.member_1[2][2]));
                if (_e2193 < 0f) {
                    phi_2834_ = -(_e2193);
                } else {
                    phi_2834_ = _e2193;
                }
                let _e2224 = phi_2834_;
                if (_e2206 < 0f) {
                    phi_2840_ = -(_e2206);
                } else {
                    phi_2840_ = _e2206;
                }
                let _e2228 = phi_2840_;
                if (_e2219 < 0f) {
                    phi_2846_ = -(_e2219);
                } else {
                    phi_2846_ = _e2219;
                }
                let _e2232 = phi_2846_;
                let _e2240 = (((_e2224 * _e269.member_2[0]) + (_e2228 * _e269.member_2[1])) + (_e2232 * _e269.member_2[2]));
                let _e2254 = (((_e377.member_1[0][0] * _e2056.member_1[0][0]) + (_e377.member_1[0][1] * _e2056.member_1[0][1])) + (_e377.member_1[0][2] * _e2056.member_1[0][2]));
                let _e2267 = (((_e377.member_1[1][0] * _e2056.member_1[0][0]) + (_e377.member_1[1][1] * _e2056.member_1[0][1])) + (_e377.member_1[1][2] * _e2056.member_1[0][2]));
                let _e2280 = (((_e377.member_1[2][0] * _e2056.member_1[0][0]) + (_e377.member_1[2][1] * _e2056.member_1[0][1])) + (_e377.member_1[2][2] * _e2056.member_1[0][2]));
                if (_e2254 < 0f) {
                    phi_2898_ = -(_e2254);
                } else {
                    phi_2898_ = _e2254;
                }
                let _e2285 = phi_2898_;
                if (_e2267 < 0f) {
                    phi_2904_ = -(_e2267);
                } else {
                    phi_2904_ = _e2267;
                }
                let _e2289 = phi_2904_;
                if (_e2280 < 0f) {
                    phi_2910_ = -(_e2280);
                } else {
                    phi_2910_ = _e2280;
                }
                let _e2293 = phi_2910_;
                let _e2301 = (((_e2285 * _e377.member_2[0]) + (_e2289 * _e377.member_2[1])) + (_e2293 * _e377.member_2[2]));
                let _e2315 = (((_e377.member_1[0][0] * _e2056.member_1[1][0]) + (_e377.member_1[0][1] * _e2056.member_1[1][1])) + (_e377.member_1[0][2] * _e2056.member_1[1][2]));
                let _e2328 = (((_e377.member_1[1][0] * _e2056.member_1[1][0]) + (_e377.member_1[1][1] * _e2056.member_1[1][1])) + (_e377.member_1[1][2] * _e2056.member_1[1][2]));
                let _e2341 = (((_e377.member_1[2][0] * _e2056.member_1[1][0]) + (_e377.member_1[2][1] * _e2056.member_1[1][1])) + (_e377.member_1[2][2] * _e2056.member_1[1][2]));
                if (_e2315 < 0f) {
                    phi_2962_ = -(_e2315);
                } else {
                    phi_2962_ = _e2315;
                }
                let _e2346 = phi_2962_;
                if (_e2328 < 0f) {
                    phi_2968_ = -(_e2328);
                } else {
                    phi_2968_ = _e2328;
                }
                let _e2350 = phi_2968_;
                if (_e2341 < 0f) {
                    phi_2974_ = -(_e2341);
                } else {
                    phi_2974_ = _e2341;
                }
                let _e2354 = phi_2974_;
                let _e2362 = (((_e2346 * _e377.member_2[0]) + (_e2350 * _e377.member_2[1])) + (_e2354 * _e377.member_2[2]));
                let _e2376 = (((_e377.member_1[0][0] * _e2056.member_1[2][0]) + (_e377.member_1[0][1] * _e2056.member_1[2][1])) + (_e377.member_1[0][2] * _e2056.member_1[2][2]));
                let _e2389 = (((_e377.member_1[1][0] * _e2056.member_1[2][0]) + (_e377.member_1[1][1] * _e2056.member_1[2][1])) + (_e377.member_1[1][2] * _e2056.member_1[2][2]));
                let _e2402 = (((_e377.member_1[2][0] * _e2056.member_1[2][0]) + (_e377.member_1[2][1] * _e2056.member_1[2][1])) + (_e377.member_1[2][2] * _e2056.member_1[2][2]));
                if (_e2376 < 0f) {
                    phi_3026_ = -(_e2376);
                } else {
                    phi_3026_ = _e2376;
                }
                let _e2407 = phi_3026_;
                if (_e2389 < 0f) {
                    phi_3032_ = -(_e2389);
                } else {
                    phi_3032_ = _e2389;
                }
                let _e2411 = phi_3032_;
                if (_e2402 < 0f) {
                    phi_3038_ = -(_e2402);
                } else {
                    phi_3038_ = _e2402;
                }
                let _e2415 = phi_3038_;
                let _e2423 = (((_e2407 * _e377.member_2[0]) + (_e2411 * _e377.member_2[1])) + (_e2415 * _e377.member_2[2]));
                let _e2432 = (((_e2056.member_1[0][0] * _e382) + (_e2056.member_1[0][1] * _e385)) + (_e2056.member_1[0][2] * _e388));
                let _e2441 = (((_e2056.member_1[1][0] * _e382) + (_e2056.member_1[1][1] * _e385)) + (_e2056.member_1[1][2] * _e388));
                let _e2450 = (((_e2056.member_1[2][0] * _e382) + (_e2056.member_1[2][1] * _e385)) + (_e2056.member_1[2][2] * _e388));
                let _e2451 = (_e2118 * -1f);
                let _e2452 = (_e2179 * -1f);
                let _e2453 = (_e2240 * -1f);
                let _e2454 = (_e2432 - _e2301);
                let _e2455 = (_e2441 - _e2362);
                let _e2456 = (_e2450 - _e2423);
                if (_e2451 < _e2454) {
                    phi_3084_ = _e2451;
                } else {
                    phi_3084_ = _e2454;
                }
                let _e2459 = phi_3084_;
                if (_e2452 < _e2455) {
                    phi_3089_ = _e2452;
                } else {
                    phi_3089_ = _e2455;
                }
                let _e2462 = phi_3089_;
                if (_e2453 < _e2456) {
                    phi_3094_ = _e2453;
                } else {
                    phi_3094_ = _e2456;
                }
                let _e2465 = phi_3094_;
                let _e2466 = (_e2432 + _e2301);
                let _e2467 = (_e2441 + _e2362);
                let _e2468 = (_e2450 + _e2423);
                if (_e2118 > _e2466) {
                    phi_3102_ = _e2118;
                } else {
                    phi_3102_ = _e2466;
                }
                let _e2471 = phi_3102_;
                if (_e2179 > _e2467) {
                    phi_3107_ = _e2179;
                } else {
                    phi_3107_ = _e2467;
                }
                let _e2474 = phi_3107_;
                if (_e2240 > _e2468) {
                    phi_3112_ = _e2240;
                } else {
                    phi_3112_ = _e2468;
                }
                let _e2477 = phi_3112_;
                let _e2482 = ((_e2459 + _e2471) * 0.5f);
                let _e2483 = ((_e2462 + _e2474) * 0.5f);
                let _e2484 = ((_e2465 + _e2477) * 0.5f);
                let _e2513 = (_e269.member[0] + (((_e2056.member_1[0][0] * _e2482) + (_e2056.member_1[1][0] * _e2483)) + (_e2056.member_1[2][0] * _e2484)));
                let _e2515 = (_e269.member[1] + (((_e2056.member_1[0][1] * _e2482) + (_e2056.member_1[1][1] * _e2483)) + (_e2056.member_1[2][1] * _e2484)));
                let _e2517 = (_e269.member[2] + (((_e2056.member_1[0][2] * _e2482) + (_e2056.member_1[1][2] * _e2483)) + (_e2056.member_1[2][2] * _e2484)));
                let _e2521 = (_e269.member[0] - _e2513);
                let _e2523 = (_e269.member[1] - _e2515);
                let _e2525 = (_e269.member[2] - _e2517);
                if (_e269.member_2[0] < 0f) {
                    phi_3168_ = -(_e269.member_2[0]);
                } else {
                    phi_3168_ = _e269.member_2[0];
                }
                let _e2531 = phi_3168_;
                if (_e269.member_2[1] < 0f) {
                    phi_3175_ = -(_e269.member_2[1]);
                } else {
                    phi_3175_ = _e269.member_2[1];
                }
                let _e2536 = phi_3175_;
                if (_e269.member_2[2] < 0f) {
                    phi_3183_ = -(_e269.member_2[2]);
                } else {
                    phi_3183_ = _e269.member_2[2];
                }
                let _e2542 = phi_3183_;
                if (_e2521 < 0f) {
                    phi_3192_ = -(_e2521);
                } else {
                    phi_3192_ = _e2521;
                }
                let _e2549 = phi_3192_;
                if (_e2523 < 0f) {
                    phi_3198_ = -(_e2523);
                } else {
                    phi_3198_ = _e2523;
                }
                let _e2553 = phi_3198_;
                if (_e2525 < 0f) {
                    phi_3204_ = -(_e2525);
                } else {
                    phi_3204_ = _e2525;
                }
                let _e2557 = phi_3204_;
                if (_e2056.member_1[0][0] < 0f) {
                    phi_3212_ = -(_e2056.member_1[0][0]);
                } else {
                    phi_3212_ = _e2056.member_1[0][0];
                }
                let _e2563 = phi_3212_;
                if (_e2056.member_1[0][1] < 0f) {
                    phi_3219_ = -(_e2056.member_1[0][1]);
                } else {
                    phi_3219_ = _e2056.member_1[0][1];
                }
                let _e2568 = phi_3219_;
                if (_e2056.member_1[0][2] < 0f) {
                    phi_3226_ = -(_e2056.member_1[0][2]);
                } else {
                    phi_3226_ = _e2056.member_1[0][2];
                }
                let _e2573 = phi_3226_;
                if (_e2056.member_1[1][0] < 0f) {
                    phi_3239_ = -(_e2056.member_1[1][0]);
                } else {
                    phi_3239_ = _e2056.member_1[1][0];
                }
                let _e2584 = phi_3239_;
                if (_e2056.member_1[1][1] < 0f) {
                    phi_3246_ = -(_e2056.member_1[1][1]);
                } else {
                    phi_3246_ = _e2056.member_1[1][1];
                }
                let _e2589 = phi_3246_;
                if (_e2056.member_1[1][2] < 0f) {
                    phi_3253_ = -(_e2056.member_1[1][2]);
                } else {
                    phi_3253_ = _e2056.member_1[1][2];
                }
                let _e2594 = phi_3253_;
                if (_e2056.member_1[2][0] < 0f) {
                    phi_3266_ = -(_e2056.member_1[2][0]);
                } else {
                    phi_3266_ = _e2056.member_1[2][0];
                }
                let _e2605 = phi_3266_;
                if (_e2056.member_1[2][1] < 0f) {
                    phi_3273_ = -(_e2056.member_1[2][1]);
                } else {
                    phi_3273_ = _e2056.member_1[2][1];
                }
                let _e2610 = phi_3273_;
                if (_e2056.member_1[2][2] < 0f) {
                    phi_3280_ = -(_e2056.member_1[2][2]);
                } else {
                    phi_3280_ = _e2056.member_1[2][2];
                }
                let _e2615 = phi_3280_;
                let _e2621 = (0.000000059604645f * 8f);
                let _e2626 = ((((_e2531 + _e2536) + _e2542) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e2638 = (((_e2056.member_1[0][0] * _e2521) + (_e2056.member_1[0][1] * _e2523)) + (_e2056.member_1[0][2] * _e2525));
                let _e2647 = (((_e2056.member_1[1][0] * _e2521) + (_e2056.member_1[1][1] * _e2523)) + (_e2056.member_1[1][2] * _e2525));
                let _e2656 = (((_e2056.member_1[2][0] * _e2521) + (_e2056.member_1[2][1] * _e2523)) + (_e2056.member_1[2][2] * _e2525));
                if (_e2638 < 0f) {
                    phi_3327_ = -(_e2638);
                } else {
                    phi_3327_ = _e2638;
                }
                let _e2660 = phi_3327_;
                if (_e2647 < 0f) {
                    phi_3333_ = -(_e2647);
                } else {
                    phi_3333_ = _e2647;
                }
                let _e2664 = phi_3333_;
                if (_e2656 < 0f) {
                    phi_3339_ = -(_e2656);
                } else {
                    phi_3339_ = _e2656;
                }
                let _e2668 = phi_3339_;
                let _e2682 = (((_e269.member_1[0][0] * _e2056.member_1[0][0]) + (_e269.member_1[0][1] * _e2056.member_1[0][1])) + (_e269.member_1[0][2] * _e2056.member_1[0][2]));
                let _e2695 = (((_e269.member_1[1][0] * _e2056.member_1[0][0]) + (_e269.member_1[1][1] * _e2056.member_1[0][1])) + (_e269.member_1[1][2] * _e2056.member_1[0][2]));
                let _e2708 = (((_e269.member_1[2][0] * _e2056.member_1[0][0]) + (_e269.member_1[2][1] * _e2056.member_1[0][1])) + (_e269.member_1[2][2] * _e2056.member_1[0][2]));
                if (_e2682 < 0f) {
                    phi_3383_ = -(_e2682);
                } else {
                    phi_3383_ = _e2682;
                }
                let _e2713 = phi_3383_;
                if (_e2695 < 0f) {
                    phi_3389_ = -(_e2695);
                } else {
                    phi_3389_ = _e2695;
                }
                let _e2717 = phi_3389_;
                if (_e2708 < 0f) {
                    phi_3395_ = -(_e2708);
                } else {
                    phi_3395_ = _e2708;
                }
                let _e2721 = phi_3395_;
                let _e2743 = (((_e269.member_1[0][0] * _e2056.member_1[1][0]) + (_e269.member_1[0][1] * _e2056.member_1[1][1])) + (_e269.member_1[0][2] * _e2056.member_1[1][2]));
                let _e2756 = (((_e269.member_1[1][0] * _e2056.member_1[1][0]) + (_e269.member_1[1][1] * _e2056.member_1[1][1])) + (_e269.member_1[1][2] * _e2056.member_1[1][2]));
                let _e2769 = (((_e269.member_1[2][0] * _e2056.member_1[1][0]) + (_e269.member_1[2][1] * _e2056.member_1[1][1])) + (_e269.member_1[2][2] * _e2056.member_1[1][2]));
                if (_e2743 < 0f) {
                    phi_3447_ = -(_e2743);
                } else {
                    phi_3447_ = _e2743;
                }
                let _e2774 = phi_3447_;
                if (_e2756 < 0f) {
                    phi_3453_ = -(_e2756);
                } else {
                    phi_3453_ = _e2756;
                }
                let _e2778 = phi_3453_;
                if (_e2769 < 0f) {
                    phi_3459_ = -(_e2769);
                } else {
                    phi_3459_ = _e2769;
                }
                let _e2782 = phi_3459_;
                let _e2804 = (((_e269.member_1[0][0] * _e2056.member_1[2][0]) + (_e269.member_1[0][1] * _e2056.member_1[2][1])) + (_e269.member_1[0][2] * _e2056.member_1[2][2]));
                let _e2817 = (((_e269.member_1[1][0] * _e2056.member_1[2][0]) + (_e269.member_1[1][1] * _e2056.member_1[2][1])) + (_e269.member_1[1][2] * _e2056.member_1[2][2]));
                let _e2830 = (((_e269.member_1[2][0] * _e2056.member_1[2][0]) + (_e269.member_1[2][1] * _e2056.member_1[2][1])) + (_e269.member_1[2][2] * _e2056.member_1[2][2]));
                if (_e2804 < 0f) {
                    phi_3511_ = -(_e2804);
                } else {
                    phi_3511_ = _e2804;
                }
                let _e2835 = phi_3511_;
                if (_e2817 < 0f) {
                    phi_3517_ = -(_e2817);
                } else {
                    phi_3517_ = _e2817;
                }
                let _e2839 = phi_3517_;
                if (_e2830 < 0f) {
                    phi_3523_ = -(_e2830);
                } else {
                    phi_3523_ = _e2830;
                }
                let _e2843 = phi_3523_;
                let _e2855 = ((_e2660 + (((_e2713 * _e269.member_2[0]) + (_e2717 * _e269.member_2[1])) + (_e2721 * _e269.member_2[2]))) + (((((_e2563 * _e2549) + (_e2568 * _e2553)) + (_e2573 * _e2557)) * _e2621) + _e2626));
                let _e2856 = ((_e2664 + (((_e2774 * _e269.member_2[0]) + (_e2778 * _e269.member_2[1])) + (_e2782 * _e269.member_2[2]))) + (((((_e2584 * _e2549) + (_e2589 * _e2553)) + (_e2594 * _e2557)) * _e2621) + _e2626));
                let _e2857 = ((_e2668 + (((_e2835 * _e269.member_2[0]) + (_e2839 * _e269.member_2[1])) + (_e2843 * _e269.member_2[2]))) + (((((_e2605 * _e2549) + (_e2610 * _e2553)) + (_e2615 * _e2557)) * _e2621) + _e2626));
                let _e2860 = (_e377.member[0] - _e2513);
                let _e2862 = (_e377.member[1] - _e2515);
                let _e2864 = (_e377.member[2] - _e2517);
                if (_e377.member_2[0] < 0f) {
                    phi_3552_ = -(_e377.member_2[0]);
                } else {
                    phi_3552_ = _e377.member_2[0];
                }
                let _e2870 = phi_3552_;
                if (_e377.member_2[1] < 0f) {
                    phi_3559_ = -(_e377.member_2[1]);
                } else {
                    phi_3559_ = _e377.member_2[1];
                }
                let _e2875 = phi_3559_;
                if (_e377.member_2[2] < 0f) {
                    phi_3567_ = -(_e377.member_2[2]);
                } else {
                    phi_3567_ = _e377.member_2[2];
                }
                let _e2881 = phi_3567_;
                if (_e2860 < 0f) {
                    phi_3576_ = -(_e2860);
                } else {
                    phi_3576_ = _e2860;
                }
                let _e2888 = phi_3576_;
                if (_e2862 < 0f) {
                    phi_3582_ = -(_e2862);
                } else {
                    phi_3582_ = _e2862;
                }
                let _e2892 = phi_3582_;
                if (_e2864 < 0f) {
                    phi_3588_ = -(_e2864);
                } else {
                    phi_3588_ = _e2864;
                }
                let _e2896 = phi_3588_;
                if (_e2056.member_1[0][0] < 0f) {
                    phi_3596_ = -(_e2056.member_1[0][0]);
                } else {
                    phi_3596_ = _e2056.member_1[0][0];
                }
                let _e2902 = phi_3596_;
                if (_e2056.member_1[0][1] < 0f) {
                    phi_3603_ = -(_e2056.member_1[0][1]);
                } else {
                    phi_3603_ = _e2056.member_1[0][1];
                }
                let _e2907 = phi_3603_;
                if (_e2056.member_1[0][2] < 0f) {
                    phi_3610_ = -(_e2056.member_1[0][2]);
                } else {
                    phi_3610_ = _e2056.member_1[0][2];
                }
                let _e2912 = phi_3610_;
                if (_e2056.member_1[1][0] < 0f) {
                    phi_3623_ = -(_e2056.member_1[1][0]);
                } else {
                    phi_3623_ = _e2056.member_1[1][0];
                }
                let _e2923 = phi_3623_;
                if (_e2056.member_1[1][1] < 0f) {
                    phi_3630_ = -(_e2056.member_1[1][1]);
                } else {
                    phi_3630_ = _e2056.member_1[1][1];
                }
                let _e2928 = phi_3630_;
                if (_e2056.member_1[1][2] < 0f) {
                    phi_3637_ = -(_e2056.member_1[1][2]);
                } else {
                    phi_3637_ = _e2056.member_1[1][2];
                }
                let _e2933 = phi_3637_;
                if (_e2056.member_1[2][0] < 0f) {
                    phi_3650_ = -(_e2056.member_1[2][0]);
                } else {
                    phi_3650_ = _e2056.member_1[2][0];
                }
                let _e2944 = phi_3650_;
                if (_e2056.member_1[2][1] < 0f) {
                    phi_3657_ = -(_e2056.member_1[2][1]);
                } else {
                    phi_3657_ = _e2056.member_1[2][1];
                }
                let _e2949 = phi_3657_;
                if (_e2056.member_1[2][2] < 0f) {
                    phi_3664_ = -(_e2056.member_1[2][2]);
                } else {
                    phi_3664_ = _e2056.member_1[2][2];
                }
                let _e2954 = phi_3664_;
                let _e2960 = (0.000000059604645f * 8f);
                let _e2965 = ((((_e2870 + _e2875) + _e2881) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e2977 = (((_e2056.member_1[0][0] * _e2860) + (_e2056.member_1[0][1] * _e2862)) + (_e2056.member_1[0][2] * _e2864));
                let _e2986 = (((_e2056.member_1[1][0] * _e2860) + (_e2056.member_1[1][1] * _e2862)) + (_e2056.member_1[1][2] * _e2864));
                let _e2995 = (((_e2056.member_1[2][0] * _e2860) + (_e2056.member_1[2][1] * _e2862)) + (_e2056.member_1[2][2] * _e2864));
                if (_e2977 < 0f) {
                    phi_3711_ = -(_e2977);
                } else {
                    phi_3711_ = _e2977;
                }
                let _e2999 = phi_3711_;
                if (_e2986 < 0f) {
                    phi_3717_ = -(_e2986);
                } else {
                    phi_3717_ = _e2986;
                }
                let _e3003 = phi_3717_;
                if (_e2995 < 0f) {
                    phi_3723_ = -(_e2995);
                } else {
                    phi_3723_ = _e2995;
                }
                let _e3007 = phi_3723_;
                let _e3021 = (((_e377.member_1[0][0] * _e2056.member_1[0][0]) + (_e377.member_1[0][1] * _e2056.member_1[0][1])) + (_e377.member_1[0][2] * _e2056.member_1[0][2]));
                let _e3034 = (((_e377.member_1[1][0] * _e2056.member_1[0][0]) + (_e377.member_1[1][1] * _e2056.member_1[0][1])) + (_e377.member_1[1][2] * _e2056.member_1[0][2]));
                let _e3047 = (((_e377.member_1[2][0] * _e2056.member_1[0][0]) + (_e377.member_1[2][1] * _e2056.member_1[0][1])) + (_e377.member_1[2][2] * _e2056.member_1[0][2]));
                if (_e3021 < 0f) {
                    phi_3767_ = -(_e3021);
                } else {
                    phi_3767_ = _e3021;
                }
                let _e3052 = phi_3767_;
                if (_e3034 < 0f) {
                    phi_3773_ = -(_e3034);
                } else {
                    phi_3773_ = _e3034;
                }
                let _e3056 = phi_3773_;
                if (_e3047 < 0f) {
                    phi_3779_ = -(_e3047);
                } else {
                    phi_3779_ = _e3047;
                }
                let _e3060 = phi_3779_;
                let _e3082 = (((_e377.member_1[0][0] * _e2056.member_1[1][0]) + (_e377.member_1[0][1] * _e2056.member_1[1][1])) + (_e377.member_1[0][2] * _e2056.member_1[1][2]));
                let _e3095 = (((_e377.member_1[1][0] * _e2056.member_1[1][0]) + (_e377.member_1[1][1] * _e2056.member_1[1][1])) + (_e377.member_1[1][2] * _e2056.member_1[1][2]));
                let _e3108 = (((_e377.member_1[2][0] * _e2056.member_1[1][0]) + (_e377.member_1[2][1] * _e2056.member_1[1][1])) + (_e377.member_1[2][2] * _e2056.member_1[1][2]));
                if (_e3082 < 0f) {
                    phi_3831_ = -(_e3082);
                } else {
                    phi_3831_ = _e3082;
                }
                let _e3113 = phi_3831_;
                if (_e3095 < 0f) {
                    phi_3837_ = -(_e3095);
                } else {
                    phi_3837_ = _e3095;
                }
                let _e3117 = phi_3837_;
                if (_e3108 < 0f) {
                    phi_3843_ = -(_e3108);
                } else {
                    phi_3843_ = _e3108;
                }
                let _e3121 = phi_3843_;
                let _e3143 = (((_e377.member_1[0][0] * _e2056.member_1[2][0]) + (_e377.member_1[0][1] * _e2056.member_1[2][1])) + (_e377.member_1[0][2] * _e2056.member_1[2][2]));
                let _e3156 = (((_e377.member_1[1][0] * _e2056.member_1[2][0]) + (_e377.member_1[1][1] * _e2056.member_1[2][1])) + (_e377.member_1[1][2] * _e2056.member_1[2][2]));
                let _e3169 = (((_e377.member_1[2][0] * _e2056.member_1[2][0]) + (_e377.member_1[2][1] * _e2056.member_1[2][1])) + (_e377.member_1[2][2] * _e2056.member_1[2][2]));
                if (_e3143 < 0f) {
                    phi_3895_ = -(_e3143);
                } else {
                    phi_3895_ = _e3143;
                }
                let _e3174 = phi_3895_;
                if (_e3156 < 0f) {
                    phi_3901_ = -(_e3156);
                } else {
                    phi_3901_ = _e3156;
                }
                let _e3178 = phi_3901_;
                if (_e3169 < 0f) {
                    phi_3907_ = -(_e3169);
                } else {
                    phi_3907_ = _e3169;
                }
                let _e3182 = phi_3907_;
                let _e3194 = ((_e2999 + (((_e3052 * _e377.member_2[0]) + (_e3056 * _e377.member_2[1])) + (_e3060 * _e377.member_2[2]))) + (((((_e2902 * _e2888) + (_e2907 * _e2892)) + (_e2912 * _e2896)) * _e2960) + _e2965));
                let _e3195 = ((_e3003 + (((_e3113 * _e377.member_2[0]) + (_e3117 * _e377.member_2[1])) + (_e3121 * _e377.member_2[2]))) + (((((_e2923 * _e2888) + (_e2928 * _e2892)) + (_e2933 * _e2896)) * _e2960) + _e2965));
                let _e3196 = ((_e3007 + (((_e3174 * _e377.member_2[0]) + (_e3178 * _e377.member_2[1])) + (_e3182 * _e377.member_2[2]))) + (((((_e2944 * _e2888) + (_e2949 * _e2892)) + (_e2954 * _e2896)) * _e2960) + _e2965));
                if ((bitcast<u32>(_e2855) & 2139095040u) != 2139095040u) {
                    if ((bitcast<u32>(_e2856) & 2139095040u) != 2139095040u) {
                        phi_3937_ = ((bitcast<u32>(_e2857) & 2139095040u) != 2139095040u);
                        phi_3938_ = false;
                    } else {
                        phi_3937_ = bool();
                        phi_3938_ = true;
                    }
                    let _e3207 = phi_3937_;
                    let _e3209 = phi_3938_;
                    phi_3939_ = _e3207;
                    phi_3940_ = _e3209;
                } else {
                    phi_3939_ = bool();
                    phi_3940_ = true;
                }
                let _e3211 = phi_3939_;
                let _e3213 = phi_3940_;
                if _e3213 {
                    phi_3944_ = false;
                } else {
                    phi_3944_ = _e3211;
                }
                let _e3215 = phi_3944_;
                if _e3215 {
                    if ((bitcast<u32>(_e3194) & 2139095040u) != 2139095040u) {
                        if ((bitcast<u32>(_e3195) & 2139095040u) != 2139095040u) {
                            phi_3963_ = ((bitcast<u32>(_e3196) & 2139095040u) != 2139095040u);
                            phi_3964_ = false;
                        } else {
                            phi_3963_ = bool();
                            phi_3964_ = true;
                        }
                        let _e3226 = phi_3963_;
                        let _e3228 = phi_3964_;
                        phi_3965_ = _e3226;
                        phi_3966_ = _e3228;
                    } else {
                        phi_3965_ = bool();
                        phi_3966_ = true;
                    }
                    let _e3230 = phi_3965_;
                    let _e3232 = phi_3966_;
                    if _e3232 {
                        phi_3970_ = false;
                    } else {
                        phi_3970_ = _e3230;
                    }
                    let _e3234 = phi_3970_;
                    if _e3234 {
                        if (_e2855 > _e3194) {
                            phi_3978_ = _e2855;
                        } else {
                            phi_3978_ = _e3194;
                        }
                        let _e3237 = phi_3978_;
                        if (_e2856 > _e3195) {
                            phi_3983_ = _e2856;
                        } else {
                            phi_3983_ = _e3195;
                        }
                        let _e3240 = phi_3983_;
                        if (_e2857 > _e3196) {
                            phi_3988_ = _e2857;
                        } else {
                            phi_3988_ = _e3196;
                        }
                        let _e3243 = phi_3988_;
                        phi_3991_ = type_33(array<f32, 3>(_e2513, _e2515, _e2517), _e2056.member_1, array<f32, 3>(_e3237, _e3240, _e3243));
                        phi_3992_ = false;
                    } else {
                        phi_3991_ = type_33();
                        phi_3992_ = true;
                    }
                    let _e3247 = phi_3991_;
                    let _e3249 = phi_3992_;
                    phi_3993_ = _e3247;
                    phi_3994_ = _e3249;
                } else {
                    phi_3993_ = type_33();
                    phi_3994_ = true;
                }
                let _e3251 = phi_3993_;
                let _e3253 = phi_3994_;
                if _e3253 {
                    if true {
                        phi_4008_ = 2122317824u;
                    } else {
                        phi_4008_ = 8388608u;
                    }
                    let _e3255 = phi_4008_;
                    let _e3257 = (bitcast<f32>(_e3255) * 3.9999998f);
                    phi_4018_ = type_33(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3257, _e3257, _e3257));
                } else {
                    phi_4018_ = _e3251;
                }
                let _e3261 = phi_4018_;
                boxes[_e62] = type_33(array<f32, 3>(_e3261.member[0], _e3261.member[1], _e3261.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e3261.member_1[0][0], _e3261.member_1[0][1], _e3261.member_1[0][2]), array<f32, 3>(_e3261.member_1[1][0], _e3261.member_1[1][1], _e3261.member_1[1][2]), array<f32, 3>(_e3261.member_1[2][0], _e3261.member_1[2][1], _e3261.member_1[2][2])), array<f32, 3>(_e3261.member_2[0], _e3261.member_2[1], _e3261.member_2[2]));
                let _e3297 = atomicOr((&done[(_e62 / 32u)]), (1u << bitcast<u32>(((_e62 % 32u) & 31u))));
                phi_4054_ = 2u;
            }
            let _e3299 = phi_4054_;
            workgroupBarrier();
            phi_204_ = _e3299;
        } else {
            phi_204_ = u32();
        }
        let _e3301 = phi_204_;
        continue;
        continuing {
            phi_200_ = _e123;
            phi_203_ = _e3301;
            break if !(_e128);
        }
    }
    let _e3304 = local_9;
    if (_e3304 == 1u) {
        phi_4063_ = true;
    } else {
        let _e3307 = local_10;
        phi_4063_ = (_e3307 == 3u);
    }
    let _e3310 = phi_4063_;
    if _e3310 {
        let _e3312 = atomicAdd((&counters[0u]), 1u);
        phi_4069_ = _e3312;
    } else {
        phi_4069_ = 0u;
    }
    let _e3314 = phi_4069_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e3317 = atomicLoad((&counters[0u]));
        if (_e3317 > 0u) {
            let _e3320 = atomicAdd((&far.member[0u]), _e3317);
            atomicStore((&counters[1u]), _e3320);
        }
    }
    workgroupBarrier();
    let _e3325 = params.member.member.member_2[_e78];
    let _e3326 = (_e3325 + _e75);
    let _e3328 = local_11;
    if (_e3328 == 2u) {
        let _e3347 = boxes[_e62];
        oriented.member[_e3326] = type_30(vec4<f32>(_e3347.member[0], _e3347.member[1], _e3347.member[2], _e3347.member_1[0][0]), vec4<f32>(_e3347.member_1[0][1], _e3347.member_1[0][2], _e3347.member_1[1][0], _e3347.member_1[1][1]), vec4<f32>(_e3347.member_1[1][2], _e3347.member_1[2][0], _e3347.member_1[2][1], _e3347.member_1[2][2]), vec4<f32>(_e3347.member_2[0], _e3347.member_2[1], _e3347.member_2[2], 0f));
        stamps.member[_e3326] = 1u;
    } else {
        let _e3331 = local_12;
        if (_e3331 != 0u) {
            if true {
                phi_4171_ = 2122317824u;
            } else {
                phi_4171_ = 8388608u;
            }
            let _e3334 = phi_4171_;
            let _e3336 = (bitcast<f32>(_e3334) * 3.9999998f);
            oriented.member[_e3326] = type_30(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(_e3336, _e3336, _e3336, 0f));
            stamps.member[_e3326] = 0u;
            let _e3342 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e3342 + _e3314))]), _e75);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn orient_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
