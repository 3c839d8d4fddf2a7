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

struct type_31 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_33 {
    member: array<type_31>,
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

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> branches: type_23;
@group(0) @binding(2) 
var<storage> block_nodes: type_27;
var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(3) 
var<storage, read_write> oriented: type_33;
@group(0) @binding(4) 
var<storage, read_write> stamps: type_11;
@group(0) @binding(5) 
var<storage, read_write> far: type_42;
var<workgroup> done: array<atomic<u32>, 8>;
var<workgroup> boxes: array<type_34, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_193_: bool;
    var phi_197_: u32;
    var phi_198_: type_8;
    var phi_199_: u32;
    var phi_202_: type_9;
    var phi_205_: u32;
    var phi_203_: type_9;
    var phi_228_: type_9;
    var phi_253_: u32;
    var phi_268_: u32;
    var phi_270_: u32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_367_: f32;
    var phi_372_: f32;
    var phi_384_: f32;
    var phi_389_: f32;
    var phi_394_: f32;
    var phi_441_: type_34;
    var phi_514_: f32;
    var phi_519_: f32;
    var phi_524_: f32;
    var phi_529_: f32;
    var phi_534_: f32;
    var phi_539_: f32;
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_561_: f32;
    var phi_608_: type_34;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_636_: f32;
    var phi_642_: f32;
    var phi_647_: f32;
    var phi_655_: f32;
    var phi_662_: f32;
    var phi_667_: f32;
    var phi_674_: f32;
    var phi_679_: f32;
    var phi_684_: f32;
    var phi_692_: f32;
    var phi_699_: f32;
    var phi_704_: f32;
    var phi_711_: f32;
    var phi_716_: f32;
    var phi_721_: f32;
    var phi_742_: u32;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_751_: f32;
    var phi_1018_: f32;
    var phi_1025_: f32;
    var phi_1030_: f32;
    var phi_1037_: f32;
    var phi_1042_: f32;
    var phi_1051_: f32;
    var phi_1057_: f32;
    var phi_1062_: f32;
    var phi_1068_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1099_: u32;
    var phi_1144_: type_14;
    var phi_1147_: f32;
    var phi_1168_: bool;
    var phi_1174_: type_15;
    var phi_1145_: type_14;
    var phi_1188_: type_15;
    var phi_1148_: f32;
    var local: f32;
    var phi_1137_: f32;
    var phi_1201_: f32;
    var phi_1213_: type_16;
    var phi_1252_: type_9;
    var phi_1255_: type_36;
    var phi_1253_: type_9;
    var phi_1278_: type_9;
    var phi_1298_: f32;
    var phi_1305_: f32;
    var phi_1338_: type_14;
    var phi_1341_: f32;
    var phi_1362_: bool;
    var phi_1368_: type_15;
    var phi_1339_: type_14;
    var phi_1382_: type_15;
    var phi_1342_: f32;
    var local_1: f32;
    var phi_1331_: f32;
    var phi_1395_: f32;
    var phi_1402_: f32;
    var phi_1436_: type_14;
    var phi_1439_: f32;
    var phi_1460_: bool;
    var phi_1466_: type_15;
    var phi_1437_: type_14;
    var phi_1480_: type_15;
    var phi_1440_: f32;
    var local_2: f32;
    var phi_1429_: f32;
    var phi_1493_: f32;
    var phi_1505_: type_16;
    var phi_1601_: type_14;
    var phi_1604_: f32;
    var phi_1625_: bool;
    var phi_1631_: type_15;
    var phi_1602_: type_14;
    var phi_1645_: type_15;
    var phi_1605_: f32;
    var local_3: f32;
    var phi_1594_: f32;
    var phi_1658_: f32;
    var phi_1670_: type_16;
    var phi_1737_: type_36;
    var phi_1738_: bool;
    var phi_1739_: type_36;
    var phi_1740_: bool;
    var phi_2029_: type_14;
    var phi_2032_: f32;
    var phi_2053_: bool;
    var phi_2059_: type_15;
    var phi_2030_: type_14;
    var phi_2073_: type_15;
    var phi_2033_: f32;
    var local_4: f32;
    var phi_2022_: f32;
    var phi_2086_: f32;
    var phi_2093_: f32;
    var phi_2127_: type_14;
    var phi_2130_: f32;
    var phi_2151_: bool;
    var phi_2157_: type_15;
    var phi_2128_: type_14;
    var phi_2171_: type_15;
    var phi_2131_: f32;
    var local_5: f32;
    var phi_2120_: f32;
    var phi_2184_: f32;
    var phi_2196_: type_16;
    var phi_2258_: type_36;
    var phi_1772_: type_14;
    var phi_1775_: f32;
    var phi_1796_: bool;
    var phi_1802_: type_15;
    var phi_1773_: type_14;
    var phi_1816_: type_15;
    var phi_1776_: f32;
    var local_6: f32;
    var phi_1765_: f32;
    var phi_1829_: f32;
    var phi_1836_: f32;
    var phi_1870_: type_14;
    var phi_1873_: f32;
    var phi_1894_: bool;
    var phi_1900_: type_15;
    var phi_1871_: type_14;
    var phi_1914_: type_15;
    var phi_1874_: f32;
    var local_7: f32;
    var phi_1863_: f32;
    var phi_1927_: f32;
    var phi_1939_: type_16;
    var phi_2259_: type_36;
    var phi_2260_: type_36;
    var phi_2264_: bool;
    var phi_2268_: bool;
    var phi_1256_: type_36;
    var phi_2269_: type_36;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var local_8: bool;
    var phi_2275_: type_36;
    var phi_2287_: u32;
    var phi_2420_: f32;
    var phi_2426_: f32;
    var phi_2432_: f32;
    var phi_2438_: f32;
    var phi_2444_: f32;
    var phi_2450_: f32;
    var phi_2494_: f32;
    var phi_2500_: f32;
    var phi_2506_: f32;
    var phi_2512_: f32;
    var phi_2518_: f32;
    var phi_2524_: f32;
    var phi_2568_: f32;
    var phi_2574_: f32;
    var phi_2580_: f32;
    var phi_2586_: f32;
    var phi_2592_: f32;
    var phi_2598_: f32;
    var phi_2639_: f32;
    var phi_2645_: f32;
    var phi_2650_: f32;
    var phi_2656_: f32;
    var phi_2661_: f32;
    var phi_2667_: f32;
    var phi_2673_: f32;
    var phi_2678_: f32;
    var phi_2684_: f32;
    var phi_2689_: f32;
    var phi_2694_: f32;
    var phi_2705_: array<array<f32, 3>, 3>;
    var phi_2707_: type_37;
    var phi_2708_: bool;
    var phi_2709_: type_37;
    var phi_2710_: bool;
    var phi_2723_: type_37;
    var phi_2768_: f32;
    var phi_2774_: f32;
    var phi_2780_: f32;
    var phi_2832_: f32;
    var phi_2838_: f32;
    var phi_2844_: f32;
    var phi_2896_: f32;
    var phi_2902_: f32;
    var phi_2908_: f32;
    var phi_2960_: f32;
    var phi_2966_: f32;
    var phi_2972_: f32;
    var phi_3024_: f32;
    var phi_3030_: f32;
    var phi_3036_: f32;
    var phi_3088_: f32;
    var phi_3094_: f32;
    var phi_3100_: f32;
    var phi_3146_: f32;
    var phi_3151_: f32;
    var phi_3156_: f32;
    var phi_3164_: f32;
    var phi_3169_: f32;
    var phi_3174_: f32;
    var phi_3223_: f32;
    var phi_3230_: f32;
    var phi_3237_: f32;
    var phi_3245_: f32;
    var phi_3252_: f32;
    var phi_3259_: f32;
    var phi_3264_: f32;
    var phi_3269_: f32;
    var phi_3274_: f32;
    var phi_3287_: f32;
    var phi_3293_: f32;
    var phi_3300_: f32;
    var phi_3311_: f32;
    var phi_3318_: f32;
    var phi_3325_: f32;
    var phi_3338_: f32;
    var phi_3345_: f32;
    var phi_3352_: f32;
    var phi_3365_: f32;
    var phi_3372_: f32;
    var phi_3379_: f32;
    var phi_3406_: f32;
    var phi_3413_: f32;
    var phi_3421_: f32;
    var phi_3430_: f32;
    var phi_3436_: f32;
    var phi_3442_: f32;
    var phi_3450_: f32;
    var phi_3457_: f32;
    var phi_3464_: f32;
    var phi_3477_: f32;
    var phi_3484_: f32;
    var phi_3491_: f32;
    var phi_3504_: f32;
    var phi_3511_: f32;
    var phi_3518_: f32;
    var phi_3565_: f32;
    var phi_3571_: f32;
    var phi_3577_: f32;
    var phi_3621_: f32;
    var phi_3627_: f32;
    var phi_3633_: f32;
    var phi_3685_: f32;
    var phi_3691_: f32;
    var phi_3697_: f32;
    var phi_3749_: f32;
    var phi_3755_: f32;
    var phi_3761_: f32;
    var phi_3790_: f32;
    var phi_3797_: f32;
    var phi_3805_: f32;
    var phi_3814_: f32;
    var phi_3820_: f32;
    var phi_3826_: f32;
    var phi_3834_: f32;
    var phi_3841_: f32;
    var phi_3848_: f32;
    var phi_3861_: f32;
    var phi_3868_: f32;
    var phi_3875_: f32;
    var phi_3888_: f32;
    var phi_3895_: f32;
    var phi_3902_: f32;
    var phi_3949_: f32;
    var phi_3955_: f32;
    var phi_3961_: f32;
    var phi_4005_: f32;
    var phi_4011_: f32;
    var phi_4017_: f32;
    var phi_4069_: f32;
    var phi_4075_: f32;
    var phi_4081_: f32;
    var phi_4133_: f32;
    var phi_4139_: f32;
    var phi_4145_: f32;
    var phi_4181_: bool;
    var phi_4182_: bool;
    var phi_4183_: bool;
    var phi_4184_: bool;
    var phi_4188_: bool;
    var phi_4207_: bool;
    var phi_4208_: bool;
    var phi_4209_: bool;
    var phi_4210_: bool;
    var phi_4214_: bool;
    var phi_4222_: f32;
    var phi_4227_: f32;
    var phi_4232_: f32;
    var phi_4235_: type_34;
    var phi_4236_: bool;
    var phi_4237_: type_34;
    var phi_4238_: bool;
    var phi_4252_: u32;
    var phi_4262_: type_34;
    var phi_4298_: u32;
    var phi_206_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_4307_: bool;
    var phi_4313_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_4415_: u32;
    var local_13: type_36;
    var local_14: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e62 = id_2;
    let _e63 = n_2;
    let _e64 = lane_2;
    let _e76 = (((_e62.y * _e63.x) + _e62.x) * 256u);
    let _e77 = (_e76 + _e64);
    let _e80 = params.member.member_2.member_1;
    let _e84 = params.member.member.member[_e80];
    if (_e64 < 8u) {
        atomicStore((&done[_e64]), 0u);
    }
    if (_e64 < 2u) {
        atomicStore((&counters[_e64]), 0u);
    }
    if ((_e77 + 1u) < _e84) {
        let _e93 = branches.member[_e77];
        if (_e93.z >= _e76) {
            phi_193_ = (_e93.w < (_e76 + 256u));
        } else {
            phi_193_ = false;
        }
        let _e103 = phi_193_;
        if _e103 {
            phi_197_ = 1u;
        } else {
            phi_197_ = 3u;
        }
        let _e105 = phi_197_;
        phi_198_ = type_8(_e93.x, _e93.y, _e93.z, _e93.w);
        phi_199_ = _e105;
    } else {
        phi_198_ = type_8(0u, 0u, _e76, _e76);
        phi_199_ = 0u;
    }
    let _e107 = phi_198_;
    let _e109 = phi_199_;
    workgroupBarrier();
    phi_202_ = type_9(0u, 38u);
    phi_205_ = _e109;
    loop {
        let _e111 = phi_202_;
        let _e113 = phi_205_;
        local_9 = _e113;
        local_10 = _e113;
        local_11 = _e113;
        local_12 = _e113;
        if (_e111.member < _e111.member_1) {
            phi_203_ = type_9((_e111.member + 1u), _e111.member_1);
            phi_228_ = type_9(1u, _e111.member);
        } else {
            phi_203_ = _e111;
            phi_228_ = type_9(0u, type_9().member_1);
        }
        let _e125 = phi_203_;
        let _e127 = phi_228_;
        let _e130 = (bitcast<i32>(_e127.member) != 0i);
        if _e130 {
            if (_e113 == 1u) {
                if ((_e107.member + 1u) >= _e84) {
                    phi_253_ = 1u;
                } else {
                    let _e135 = (_e107.member - _e76);
                    let _e138 = atomicLoad((&done[(_e135 / 32u)]));
                    phi_253_ = ((_e138 >> bitcast<u32>(((_e135 % 32u) & 31u))) & 1u);
                }
                let _e145 = phi_253_;
                if ((_e107.member_1 + 1u) >= _e84) {
                    phi_268_ = 1u;
                } else {
                    let _e149 = (_e107.member_1 - _e76);
                    let _e152 = atomicLoad((&done[(_e149 / 32u)]));
                    phi_268_ = ((_e152 >> bitcast<u32>(((_e149 % 32u) & 31u))) & 1u);
                }
                let _e159 = phi_268_;
                phi_270_ = (_e145 & _e159);
            } else {
                phi_270_ = 0u;
            }
            let _e162 = phi_270_;
            workgroupBarrier();
            if (_e162 == 0u) {
                phi_4298_ = _e113;
            } else {
                let _e168 = params.member.member_2.member_1;
                let _e172 = params.member.member.member[_e168];
                if ((_e107.member + 1u) >= _e172) {
                    let _e207 = params.member.member_2.member_1;
                    let _e211 = params.member.member.member[_e207];
                    let _e218 = params.member.member_2.member[0u][_e207];
                    let _e221 = block_nodes.member[(_e218 + (_e107.member - (_e211 - 1u)))];
                    let _e240 = ((_e221.member.x * 0.5f) + (_e221.member_1.y * 0.5f));
                    let _e241 = ((_e221.member.y * 0.5f) + (_e221.member_2.x * 0.5f));
                    let _e242 = ((_e221.member_1.x * 0.5f) + (_e221.member_2.y * 0.5f));
                    if (_e240 < _e221.member_1.y) {
                        phi_347_ = _e240;
                    } else {
                        phi_347_ = _e221.member_1.y;
                    }
                    let _e245 = phi_347_;
                    if (_e241 < _e221.member_2.x) {
                        phi_352_ = _e241;
                    } else {
                        phi_352_ = _e221.member_2.x;
                    }
                    let _e248 = phi_352_;
                    if (_e242 < _e221.member_2.y) {
                        phi_357_ = _e242;
                    } else {
                        phi_357_ = _e221.member_2.y;
                    }
                    let _e251 = phi_357_;
                    if (_e245 > _e221.member.x) {
                        phi_362_ = _e245;
                    } else {
                        phi_362_ = _e221.member.x;
                    }
                    let _e254 = phi_362_;
                    if (_e248 > _e221.member.y) {
                        phi_367_ = _e248;
                    } else {
                        phi_367_ = _e221.member.y;
                    }
                    let _e257 = phi_367_;
                    if (_e251 > _e221.member_1.x) {
                        phi_372_ = _e251;
                    } else {
                        phi_372_ = _e221.member_1.x;
                    }
                    let _e260 = phi_372_;
                    let _e262 = (_e221.member_1.y - _e254);
                    let _e263 = (_e221.member_2.x - _e257);
                    let _e264 = (_e221.member_2.y - _e260);
                    let _e265 = (_e254 - _e221.member.x);
                    let _e266 = (_e257 - _e221.member.y);
                    let _e267 = (_e260 - _e221.member_1.x);
                    if (_e262 > _e265) {
                        phi_384_ = _e262;
                    } else {
                        phi_384_ = _e265;
                    }
                    let _e270 = phi_384_;
                    if (_e263 > _e266) {
                        phi_389_ = _e263;
                    } else {
                        phi_389_ = _e266;
                    }
                    let _e273 = phi_389_;
                    if (_e264 > _e267) {
                        phi_394_ = _e264;
                    } else {
                        phi_394_ = _e267;
                    }
                    let _e276 = phi_394_;
                    let _e278 = (1f + (0.000000059604645f * 4f));
                    let _e282 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_441_ = type_34(array<f32, 3>(_e254, _e257, _e260), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e270 * _e278) + _e282), ((_e273 * _e278) + _e282), ((_e276 * _e278) + _e282)));
                } else {
                    let _e176 = boxes[(_e107.member - _e76)];
                    phi_441_ = type_34(array<f32, 3>(_e176.member[0], _e176.member[1], _e176.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e176.member_1[0][0], _e176.member_1[0][1], _e176.member_1[0][2]), array<f32, 3>(_e176.member_1[1][0], _e176.member_1[1][1], _e176.member_1[1][2]), array<f32, 3>(_e176.member_1[2][0], _e176.member_1[2][1], _e176.member_1[2][2])), array<f32, 3>(_e176.member_2[0], _e176.member_2[1], _e176.member_2[2]));
                }
                let _e289 = phi_441_;
                let _e294 = params.member.member_2.member_1;
                let _e298 = params.member.member.member[_e294];
                if ((_e107.member_1 + 1u) >= _e298) {
                    let _e333 = params.member.member_2.member_1;
                    let _e337 = params.member.member.member[_e333];
                    let _e344 = params.member.member_2.member[0u][_e333];
                    let _e347 = block_nodes.member[(_e344 + (_e107.member_1 - (_e337 - 1u)))];
                    let _e366 = ((_e347.member.x * 0.5f) + (_e347.member_1.y * 0.5f));
                    let _e367 = ((_e347.member.y * 0.5f) + (_e347.member_2.x * 0.5f));
                    let _e368 = ((_e347.member_1.x * 0.5f) + (_e347.member_2.y * 0.5f));
                    if (_e366 < _e347.member_1.y) {
                        phi_514_ = _e366;
                    } else {
                        phi_514_ = _e347.member_1.y;
                    }
                    let _e371 = phi_514_;
                    if (_e367 < _e347.member_2.x) {
                        phi_519_ = _e367;
                    } else {
                        phi_519_ = _e347.member_2.x;
                    }
                    let _e374 = phi_519_;
                    if (_e368 < _e347.member_2.y) {
                        phi_524_ = _e368;
                    } else {
                        phi_524_ = _e347.member_2.y;
                    }
                    let _e377 = phi_524_;
                    if (_e371 > _e347.member.x) {
                        phi_529_ = _e371;
                    } else {
                        phi_529_ = _e347.member.x;
                    }
                    let _e380 = phi_529_;
                    if (_e374 > _e347.member.y) {
                        phi_534_ = _e374;
                    } else {
                        phi_534_ = _e347.member.y;
                    }
                    let _e383 = phi_534_;
                    if (_e377 > _e347.member_1.x) {
                        phi_539_ = _e377;
                    } else {
                        phi_539_ = _e347.member_1.x;
                    }
                    let _e386 = phi_539_;
                    let _e388 = (_e347.member_1.y - _e380);
                    let _e389 = (_e347.member_2.x - _e383);
                    let _e390 = (_e347.member_2.y - _e386);
                    let _e391 = (_e380 - _e347.member.x);
                    let _e392 = (_e383 - _e347.member.y);
                    let _e393 = (_e386 - _e347.member_1.x);
                    if (_e388 > _e391) {
                        phi_551_ = _e388;
                    } else {
                        phi_551_ = _e391;
                    }
                    let _e396 = phi_551_;
                    if (_e389 > _e392) {
                        phi_556_ = _e389;
                    } else {
                        phi_556_ = _e392;
                    }
                    let _e399 = phi_556_;
                    if (_e390 > _e393) {
                        phi_561_ = _e390;
                    } else {
                        phi_561_ = _e393;
                    }
                    let _e402 = phi_561_;
                    let _e404 = (1f + (0.000000059604645f * 4f));
                    let _e408 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_608_ = type_34(array<f32, 3>(_e380, _e383, _e386), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e396 * _e404) + _e408), ((_e399 * _e404) + _e408), ((_e402 * _e404) + _e408)));
                } else {
                    let _e302 = boxes[(_e107.member_1 - _e76)];
                    phi_608_ = type_34(array<f32, 3>(_e302.member[0], _e302.member[1], _e302.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e302.member_1[0][0], _e302.member_1[0][1], _e302.member_1[0][2]), array<f32, 3>(_e302.member_1[1][0], _e302.member_1[1][1], _e302.member_1[1][2]), array<f32, 3>(_e302.member_1[2][0], _e302.member_1[2][1], _e302.member_1[2][2])), array<f32, 3>(_e302.member_2[0], _e302.member_2[1], _e302.member_2[2]));
                }
                let _e415 = phi_608_;
                let _e420 = (_e415.member[0] - _e289.member[0]);
                let _e423 = (_e415.member[1] - _e289.member[1]);
                let _e426 = (_e415.member[2] - _e289.member[2]);
                if (_e420 < 0f) {
                    phi_625_ = -(_e420);
                } else {
                    phi_625_ = _e420;
                }
                let _e430 = phi_625_;
                if (_e423 < 0f) {
                    phi_631_ = -(_e423);
                } else {
                    phi_631_ = _e423;
                }
                let _e434 = phi_631_;
                if (_e430 > _e434) {
                    phi_636_ = _e430;
                } else {
                    phi_636_ = _e434;
                }
                let _e437 = phi_636_;
                if (_e426 < 0f) {
                    phi_642_ = -(_e426);
                } else {
                    phi_642_ = _e426;
                }
                let _e441 = phi_642_;
                if (_e437 > _e441) {
                    phi_647_ = _e437;
                } else {
                    phi_647_ = _e441;
                }
                let _e444 = phi_647_;
                if (_e289.member_2[0] < 0f) {
                    phi_655_ = -(_e289.member_2[0]);
                } else {
                    phi_655_ = _e289.member_2[0];
                }
                let _e450 = phi_655_;
                if (_e289.member_2[1] < 0f) {
                    phi_662_ = -(_e289.member_2[1]);
                } else {
                    phi_662_ = _e289.member_2[1];
                }
                let _e455 = phi_662_;
                if (_e450 > _e455) {
                    phi_667_ = _e450;
                } else {
                    phi_667_ = _e455;
                }
                let _e458 = phi_667_;
                if (_e289.member_2[2] < 0f) {
                    phi_674_ = -(_e289.member_2[2]);
                } else {
                    phi_674_ = _e289.member_2[2];
                }
                let _e463 = phi_674_;
                if (_e458 > _e463) {
                    phi_679_ = _e458;
                } else {
                    phi_679_ = _e463;
                }
                let _e466 = phi_679_;
                if (_e444 > _e466) {
                    phi_684_ = _e444;
                } else {
                    phi_684_ = _e466;
                }
                let _e469 = phi_684_;
                if (_e415.member_2[0] < 0f) {
                    phi_692_ = -(_e415.member_2[0]);
                } else {
                    phi_692_ = _e415.member_2[0];
                }
                let _e475 = phi_692_;
                if (_e415.member_2[1] < 0f) {
                    phi_699_ = -(_e415.member_2[1]);
                } else {
                    phi_699_ = _e415.member_2[1];
                }
                let _e480 = phi_699_;
                if (_e475 > _e480) {
                    phi_704_ = _e475;
                } else {
                    phi_704_ = _e480;
                }
                let _e483 = phi_704_;
                if (_e415.member_2[2] < 0f) {
                    phi_711_ = -(_e415.member_2[2]);
                } else {
                    phi_711_ = _e415.member_2[2];
                }
                let _e488 = phi_711_;
                if (_e483 > _e488) {
                    phi_716_ = _e483;
                } else {
                    phi_716_ = _e488;
                }
                let _e491 = phi_716_;
                if (_e469 > _e491) {
                    phi_721_ = _e469;
                } else {
                    phi_721_ = _e491;
                }
                let _e494 = phi_721_;
                if (_e494 > 0.000000000000000000000000000000000000011754944f) {
                    if ((bitcast<u32>(_e494) & 2139095040u) != 2139095040u) {
                        let _e501 = (2130706432u - (bitcast<u32>(_e494) & 2139095040u));
                        if (_e501 > 8388608u) {
                            phi_742_ = _e501;
                        } else {
                            phi_742_ = 8388608u;
                        }
                        let _e504 = phi_742_;
                        phi_744_ = bitcast<f32>(_e504);
                        phi_745_ = false;
                    } else {
                        phi_744_ = f32();
                        phi_745_ = true;
                    }
                    let _e507 = phi_744_;
                    let _e509 = phi_745_;
                    phi_746_ = _e507;
                    phi_747_ = _e509;
                } else {
                    phi_746_ = f32();
                    phi_747_ = true;
                }
                let _e511 = phi_746_;
                let _e513 = phi_747_;
                if _e513 {
                    phi_751_ = 0f;
                } else {
                    phi_751_ = _e511;
                }
                let _e515 = phi_751_;
                let _e516 = (_e420 * _e515);
                let _e517 = (_e423 * _e515);
                let _e518 = (_e426 * _e515);
                let _e519 = (_e516 * 0.5f);
                let _e520 = (_e517 * 0.5f);
                let _e538 = (_e289.member_2[0] * _e515);
                let _e540 = (_e289.member_1[0][0] * _e538);
                let _e542 = (_e289.member_1[0][1] * _e538);
                let _e544 = (_e289.member_1[0][2] * _e538);
                let _e545 = (_e540 * 1f);
                let _e546 = (_e542 * 1f);
                let _e564 = (_e289.member_2[1] * _e515);
                let _e566 = (_e289.member_1[1][0] * _e564);
                let _e568 = (_e289.member_1[1][1] * _e564);
                let _e570 = (_e289.member_1[1][2] * _e564);
                let _e571 = (_e566 * 1f);
                let _e572 = (_e568 * 1f);
                let _e590 = (_e289.member_2[2] * _e515);
                let _e592 = (_e289.member_1[2][0] * _e590);
                let _e594 = (_e289.member_1[2][1] * _e590);
                let _e596 = (_e289.member_1[2][2] * _e590);
                let _e597 = (_e592 * 1f);
                let _e598 = (_e594 * 1f);
                let _e616 = (_e415.member_2[0] * _e515);
                let _e618 = (_e415.member_1[0][0] * _e616);
                let _e620 = (_e415.member_1[0][1] * _e616);
                let _e622 = (_e415.member_1[0][2] * _e616);
                let _e623 = (_e618 * 1f);
                let _e624 = (_e620 * 1f);
                let _e642 = (_e415.member_2[1] * _e515);
                let _e644 = (_e415.member_1[1][0] * _e642);
                let _e646 = (_e415.member_1[1][1] * _e642);
                let _e648 = (_e415.member_1[1][2] * _e642);
                let _e649 = (_e644 * 1f);
                let _e650 = (_e646 * 1f);
                let _e668 = (_e415.member_2[2] * _e515);
                let _e670 = (_e415.member_1[2][0] * _e668);
                let _e672 = (_e415.member_1[2][1] * _e668);
                let _e674 = (_e415.member_1[2][2] * _e668);
                let _e675 = (_e670 * 1f);
                let _e676 = (_e672 * 1f);
                let _e681 = (((((((0f + (_e516 * _e519)) + (_e540 * _e545)) + (_e566 * _e571)) + (_e592 * _e597)) + (_e618 * _e623)) + (_e644 * _e649)) + (_e670 * _e675));
                let _e682 = (((((((0f + (_e517 * _e519)) + (_e542 * _e545)) + (_e568 * _e571)) + (_e594 * _e597)) + (_e620 * _e623)) + (_e646 * _e649)) + (_e672 * _e675));
                let _e683 = (((((((0f + (_e518 * _e519)) + (_e544 * _e545)) + (_e570 * _e571)) + (_e596 * _e597)) + (_e622 * _e623)) + (_e648 * _e649)) + (_e674 * _e675));
                let _e685 = (((((((0f + (_e520 * _e517)) + (_e546 * _e542)) + (_e572 * _e568)) + (_e598 * _e594)) + (_e624 * _e620)) + (_e650 * _e646)) + (_e676 * _e672));
                let _e687 = (((((((0f + (_e520 * _e518)) + (_e546 * _e544)) + (_e572 * _e570)) + (_e598 * _e596)) + (_e624 * _e622)) + (_e650 * _e648)) + (_e676 * _e674));
                let _e689 = (((((((0f + ((_e518 * 0.5f) * _e518)) + ((_e544 * 1f) * _e544)) + ((_e570 * 1f) * _e570)) + ((_e596 * 1f) * _e596)) + ((_e622 * 1f) * _e622)) + ((_e648 * 1f) * _e648)) + ((_e674 * 1f) * _e674));
                if (_e681 < 0f) {
                    phi_1018_ = -(_e681);
                } else {
                    phi_1018_ = _e681;
                }
                let _e693 = phi_1018_;
                if (_e682 < 0f) {
                    phi_1025_ = -(_e682);
                } else {
                    phi_1025_ = _e682;
                }
                let _e697 = phi_1025_;
                if (_e693 > _e697) {
                    phi_1030_ = _e693;
                } else {
                    phi_1030_ = _e697;
                }
                let _e700 = phi_1030_;
                if (_e683 < 0f) {
                    phi_1037_ = -(_e683);
                } else {
                    phi_1037_ = _e683;
                }
                let _e704 = phi_1037_;
                if (_e700 > _e704) {
                    phi_1042_ = _e700;
                } else {
                    phi_1042_ = _e704;
                }
                let _e707 = phi_1042_;
                if (_e685 < 0f) {
                    phi_1051_ = -(_e685);
                } else {
                    phi_1051_ = _e685;
                }
                let _e711 = phi_1051_;
                if (_e687 < 0f) {
                    phi_1057_ = -(_e687);
                } else {
                    phi_1057_ = _e687;
                }
                let _e715 = phi_1057_;
                if (_e711 > _e715) {
                    phi_1062_ = _e711;
                } else {
                    phi_1062_ = _e715;
                }
                let _e718 = phi_1062_;
                if (_e689 < 0f) {
                    phi_1068_ = -(_e689);
                } else {
                    phi_1068_ = _e689;
                }
                let _e722 = phi_1068_;
                if (_e718 > _e722) {
                    phi_1073_ = _e718;
                } else {
                    phi_1073_ = _e722;
                }
                let _e725 = phi_1073_;
                if (_e707 > _e725) {
                    phi_1078_ = _e707;
                } else {
                    phi_1078_ = _e725;
                }
                let _e728 = phi_1078_;
                if (_e728 > 0.000000000000000000000000000000000000011754944f) {
                    if ((bitcast<u32>(_e728) & 2139095040u) != 2139095040u) {
                        let _e735 = (2130706432u - (bitcast<u32>(_e728) & 2139095040u));
                        if (_e735 > 8388608u) {
                            phi_1099_ = _e735;
                        } else {
                            phi_1099_ = 8388608u;
                        }
                        let _e738 = phi_1099_;
                        let _e739 = bitcast<f32>(_e738);
                        let _e741 = (_e682 * _e739);
                        let _e742 = (_e683 * _e739);
                        let _e743 = (_e685 * _e739);
                        let _e744 = (_e687 * _e739);
                        let _e745 = (_e689 * _e739);
                        let _e748 = ((_e741 * _e741) + (_e742 * _e742));
                        if (_e748 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                            if (_e748 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e748 > 0f) {
                                    phi_1137_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_1137_ = 0f;
                                }
                                let _e805 = phi_1137_;
                                phi_1201_ = _e805;
                            } else {
                                phi_1144_ = type_14(0i, 5i);
                                phi_1147_ = bitcast<f32>(((bitcast<u32>(_e748) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e760 = phi_1144_;
                                    let _e762 = phi_1147_;
                                    local = _e762;
                                    if (_e760.member < _e760.member_1) {
                                        let _e769 = (_e760.member + 1i);
                                        if ((false == (_e769 > _e760.member)) != false) {
                                            phi_1168_ = true;
                                        } else {
                                            phi_1168_ = false;
                                        }
                                        let _e774 = phi_1168_;
                                        if _e774 {
                                            phi_1174_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_1174_ = type_15(1u, _e769);
                                        }
                                        let _e779 = phi_1174_;
                                        phi_1145_ = type_14(_e779.member_1, _e760.member_1);
                                        phi_1188_ = type_15(1u, _e760.member);
                                    } else {
                                        phi_1145_ = _e760;
                                        phi_1188_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e785 = phi_1145_;
                                    let _e787 = phi_1188_;
                                    let _e790 = (bitcast<i32>(_e787.member) != 0i);
                                    if _e790 {
                                        phi_1148_ = (0.5f * (_e762 + (_e748 / _e762)));
                                    } else {
                                        phi_1148_ = f32();
                                    }
                                    let _e795 = phi_1148_;
                                    continue;
                                    continuing {
                                        phi_1144_ = _e785;
                                        phi_1147_ = _e795;
                                        break if !(_e790);
                                    }
                                }
                                let _e800 = local;
                                phi_1201_ = (_e800 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e807 = phi_1201_;
                            let _e808 = (_e741 / _e807);
                            let _e809 = (_e742 / _e807);
                            let _e814 = (1.5f - (((_e808 * _e808) + (_e809 * _e809)) * 0.5f));
                            phi_1213_ = type_16((_e808 * _e814), (_e809 * _e814));
                        } else {
                            phi_1213_ = type_16(1f, 0f);
                        }
                        let _e819 = phi_1213_;
                        let _e824 = (((_e819.member * _e819.member_1) * _e744) * 2f);
                        phi_1252_ = type_9(0u, 16u);
                        phi_1255_ = type_36(array<f32, 2>(((_e819.member * _e741) + (_e819.member_1 * _e742)), (((_e819.member * _e819.member_1) * (_e743 - _e745)) + (((_e819.member_1 * _e819.member_1) - (_e819.member * _e819.member)) * _e744))), array<f32, 3>((_e681 * _e739), ((((_e819.member * _e819.member) * _e743) + _e824) + ((_e819.member_1 * _e819.member_1) * _e745)), ((((_e819.member_1 * _e819.member_1) * _e743) - _e824) + ((_e819.member * _e819.member) * _e745))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e819.member, _e819.member_1), array<f32, 3>(0f, _e819.member_1, -(_e819.member))));
                        loop {
                            let _e856 = phi_1252_;
                            let _e858 = phi_1255_;
                            local_14 = _e858;
                            if (_e856.member < _e856.member_1) {
                                phi_1253_ = type_9((_e856.member + 1u), _e856.member_1);
                                phi_1278_ = type_9(1u, _e856.member);
                            } else {
                                phi_1253_ = _e856;
                                phi_1278_ = type_9(0u, type_9().member_1);
                            }
                            let _e870 = phi_1253_;
                            let _e872 = phi_1278_;
                            if (bitcast<i32>(_e872.member) != 0i) {
                                let _e876 = (0.000000059604645f * 0.5f);
                                if (_e858.member[0] < 0f) {
                                    phi_1298_ = -(_e858.member[0]);
                                } else {
                                    phi_1298_ = _e858.member[0];
                                }
                                let _e887 = phi_1298_;
                                let _e888 = (_e887 > _e876);
                                if (_e858.member[1] < 0f) {
                                    phi_1305_ = -(_e858.member[1]);
                                } else {
                                    phi_1305_ = _e858.member[1];
                                }
                                let _e892 = phi_1305_;
                                let _e893 = (_e892 > _e876);
                                if _e888 {
                                    if _e893 {
                                        let _e896 = ((_e858.member_1[1] - _e858.member_1[0]) / (_e858.member[0] * 2f));
                                        let _e898 = ((_e896 * _e896) + 1f);
                                        if (_e898 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e898 > 0f) {
                                                phi_1331_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1331_ = 0f;
                                            }
                                            let _e951 = phi_1331_;
                                            phi_1395_ = _e951;
                                        } else {
                                            phi_1338_ = type_14(0i, 5i);
                                            phi_1341_ = bitcast<f32>(((bitcast<u32>(_e898) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e906 = phi_1338_;
                                                let _e908 = phi_1341_;
                                                local_1 = _e908;
                                                if (_e906.member < _e906.member_1) {
                                                    let _e915 = (_e906.member + 1i);
                                                    if ((false == (_e915 > _e906.member)) != false) {
                                                        phi_1362_ = true;
                                                    } else {
                                                        phi_1362_ = false;
                                                    }
                                                    let _e920 = phi_1362_;
                                                    if _e920 {
                                                        phi_1368_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1368_ = type_15(1u, _e915);
                                                    }
                                                    let _e925 = phi_1368_;
                                                    phi_1339_ = type_14(_e925.member_1, _e906.member_1);
                                                    phi_1382_ = type_15(1u, _e906.member);
                                                } else {
                                                    phi_1339_ = _e906;
                                                    phi_1382_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e931 = phi_1339_;
                                                let _e933 = phi_1382_;
                                                let _e936 = (bitcast<i32>(_e933.member) != 0i);
                                                if _e936 {
                                                    phi_1342_ = (0.5f * (_e908 + (_e898 / _e908)));
                                                } else {
                                                    phi_1342_ = f32();
                                                }
                                                let _e941 = phi_1342_;
                                                continue;
                                                continuing {
                                                    phi_1338_ = _e931;
                                                    phi_1341_ = _e941;
                                                    break if !(_e936);
                                                }
                                            }
                                            let _e946 = local_1;
                                            phi_1395_ = (_e946 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e953 = phi_1395_;
                                        if (_e896 > 0f) {
                                            phi_1402_ = (_e896 + _e953);
                                        } else {
                                            phi_1402_ = (_e896 - _e953);
                                        }
                                        let _e958 = phi_1402_;
                                        let _e961 = (_e858.member_1[2] - (_e858.member_1[0] - (_e858.member[0] / _e958)));
                                        let _e964 = ((_e961 * _e961) + (_e858.member[1] * _e858.member[1]));
                                        if (_e964 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e964 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e964 > 0f) {
                                                    phi_1429_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1429_ = 0f;
                                                }
                                                let _e1021 = phi_1429_;
                                                phi_1493_ = _e1021;
                                            } else {
                                                phi_1436_ = type_14(0i, 5i);
                                                phi_1439_ = bitcast<f32>(((bitcast<u32>(_e964) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e976 = phi_1436_;
                                                    let _e978 = phi_1439_;
                                                    local_2 = _e978;
                                                    if (_e976.member < _e976.member_1) {
                                                        let _e985 = (_e976.member + 1i);
                                                        if ((false == (_e985 > _e976.member)) != false) {
                                                            phi_1460_ = true;
                                                        } else {
                                                            phi_1460_ = false;
                                                        }
                                                        let _e990 = phi_1460_;
                                                        if _e990 {
                                                            phi_1466_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1466_ = type_15(1u, _e985);
                                                        }
                                                        let _e995 = phi_1466_;
                                                        phi_1437_ = type_14(_e995.member_1, _e976.member_1);
                                                        phi_1480_ = type_15(1u, _e976.member);
                                                    } else {
                                                        phi_1437_ = _e976;
                                                        phi_1480_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1001 = phi_1437_;
                                                    let _e1003 = phi_1480_;
                                                    let _e1006 = (bitcast<i32>(_e1003.member) != 0i);
                                                    if _e1006 {
                                                        phi_1440_ = (0.5f * (_e978 + (_e964 / _e978)));
                                                    } else {
                                                        phi_1440_ = f32();
                                                    }
                                                    let _e1011 = phi_1440_;
                                                    continue;
                                                    continuing {
                                                        phi_1436_ = _e1001;
                                                        phi_1439_ = _e1011;
                                                        break if !(_e1006);
                                                    }
                                                }
                                                let _e1016 = local_2;
                                                phi_1493_ = (_e1016 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1023 = phi_1493_;
                                            let _e1024 = (_e961 / _e1023);
                                            let _e1025 = (_e858.member[1] / _e1023);
                                            let _e1030 = (1.5f - (((_e1024 * _e1024) + (_e1025 * _e1025)) * 0.5f));
                                            phi_1505_ = type_16((_e1024 * _e1030), (_e1025 * _e1030));
                                        } else {
                                            phi_1505_ = type_16(1f, 0f);
                                        }
                                        let _e1035 = phi_1505_;
                                        let _e1052 = (((_e858.member_1[1] - _e858.member_1[2]) * _e1035.member_1) + ((_e1035.member * _e858.member[1]) * 2f));
                                        let _e1054 = (_e858.member_1[1] - (_e1035.member_1 * _e1052));
                                        let _e1058 = ((_e1035.member * _e1052) - _e858.member[1]);
                                        let _e1071 = ((_e858.member_2[1][0] * _e1035.member) - (_e858.member_2[2][0] * _e1035.member_1));
                                        let _e1072 = ((_e858.member_2[1][1] * _e1035.member) - (_e858.member_2[2][1] * _e1035.member_1));
                                        let _e1073 = ((_e858.member_2[1][2] * _e1035.member) - (_e858.member_2[2][2] * _e1035.member_1));
                                        let _e1090 = (_e1035.member * _e858.member[0]);
                                        let _e1091 = (_e1035.member_1 * _e858.member[0]);
                                        let _e1094 = ((_e1058 * _e1058) + (_e1091 * _e1091));
                                        if (_e1094 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1094 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1094 > 0f) {
                                                    phi_1594_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1594_ = 0f;
                                                }
                                                let _e1151 = phi_1594_;
                                                phi_1658_ = _e1151;
                                            } else {
                                                phi_1601_ = type_14(0i, 5i);
                                                phi_1604_ = bitcast<f32>(((bitcast<u32>(_e1094) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1106 = phi_1601_;
                                                    let _e1108 = phi_1604_;
                                                    local_3 = _e1108;
                                                    if (_e1106.member < _e1106.member_1) {
                                                        let _e1115 = (_e1106.member + 1i);
                                                        if ((false == (_e1115 > _e1106.member)) != false) {
                                                            phi_1625_ = true;
                                                        } else {
                                                            phi_1625_ = false;
                                                        }
                                                        let _e1120 = phi_1625_;
                                                        if _e1120 {
                                                            phi_1631_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1631_ = type_15(1u, _e1115);
                                                        }
                                                        let _e1125 = phi_1631_;
                                                        phi_1602_ = type_14(_e1125.member_1, _e1106.member_1);
                                                        phi_1645_ = type_15(1u, _e1106.member);
                                                    } else {
                                                        phi_1602_ = _e1106;
                                                        phi_1645_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1131 = phi_1602_;
                                                    let _e1133 = phi_1645_;
                                                    let _e1136 = (bitcast<i32>(_e1133.member) != 0i);
                                                    if _e1136 {
                                                        phi_1605_ = (0.5f * (_e1108 + (_e1094 / _e1108)));
                                                    } else {
                                                        phi_1605_ = f32();
                                                    }
                                                    let _e1141 = phi_1605_;
                                                    continue;
                                                    continuing {
                                                        phi_1601_ = _e1131;
                                                        phi_1604_ = _e1141;
                                                        break if !(_e1136);
                                                    }
                                                }
                                                let _e1146 = local_3;
                                                phi_1658_ = (_e1146 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1153 = phi_1658_;
                                            let _e1154 = (_e1058 / _e1153);
                                            let _e1155 = (_e1091 / _e1153);
                                            let _e1160 = (1.5f - (((_e1154 * _e1154) + (_e1155 * _e1155)) * 0.5f));
                                            phi_1670_ = type_16((_e1154 * _e1160), (_e1155 * _e1160));
                                        } else {
                                            phi_1670_ = type_16(1f, 0f);
                                        }
                                        let _e1165 = phi_1670_;
                                        let _e1175 = (((_e858.member_1[0] - _e1054) * _e1165.member_1) + ((_e1165.member * _e1090) * 2f));
                                        phi_1737_ = type_36(array<f32, 2>(((_e1165.member * _e1175) - _e1090), ((_e1165.member_1 * _e1091) + (_e1165.member * _e1058))), array<f32, 3>((_e858.member_1[0] - (_e1165.member_1 * _e1175)), (_e1054 + (_e1165.member_1 * _e1175)), (_e858.member_1[2] + (_e1035.member_1 * _e1052))), array<array<f32, 3>, 3>(array<f32, 3>(((_e858.member_2[0][0] * _e1165.member) - (_e1071 * _e1165.member_1)), ((_e858.member_2[0][1] * _e1165.member) - (_e1072 * _e1165.member_1)), ((_e858.member_2[0][2] * _e1165.member) - (_e1073 * _e1165.member_1))), array<f32, 3>(((_e858.member_2[0][0] * _e1165.member_1) + (_e1071 * _e1165.member)), ((_e858.member_2[0][1] * _e1165.member_1) + (_e1072 * _e1165.member)), ((_e858.member_2[0][2] * _e1165.member_1) + (_e1073 * _e1165.member))), array<f32, 3>(((_e858.member_2[1][0] * _e1035.member_1) + (_e858.member_2[2][0] * _e1035.member)), ((_e858.member_2[1][1] * _e1035.member_1) + (_e858.member_2[2][1] * _e1035.member)), ((_e858.member_2[1][2] * _e1035.member_1) + (_e858.member_2[2][2] * _e1035.member)))));
                                        phi_1738_ = false;
                                    } else {
                                        phi_1737_ = type_36();
                                        phi_1738_ = true;
                                    }
                                    let _e1213 = phi_1737_;
                                    let _e1215 = phi_1738_;
                                    phi_1739_ = _e1213;
                                    phi_1740_ = _e1215;
                                } else {
                                    phi_1739_ = type_36();
                                    phi_1740_ = true;
                                }
                                let _e1217 = phi_1739_;
                                let _e1219 = phi_1740_;
                                if _e1219 {
                                    if _e888 {
                                        let _e1435 = ((_e858.member_1[1] - _e858.member_1[0]) / (_e858.member[0] * 2f));
                                        let _e1437 = ((_e1435 * _e1435) + 1f);
                                        if (_e1437 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1437 > 0f) {
                                                phi_1765_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1765_ = 0f;
                                            }
                                            let _e1490 = phi_1765_;
                                            phi_1829_ = _e1490;
                                        } else {
                                            phi_1772_ = type_14(0i, 5i);
                                            phi_1775_ = bitcast<f32>(((bitcast<u32>(_e1437) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1445 = phi_1772_;
                                                let _e1447 = phi_1775_;
                                                local_6 = _e1447;
                                                if (_e1445.member < _e1445.member_1) {
                                                    let _e1454 = (_e1445.member + 1i);
                                                    if ((false == (_e1454 > _e1445.member)) != false) {
                                                        phi_1796_ = true;
                                                    } else {
                                                        phi_1796_ = false;
                                                    }
                                                    let _e1459 = phi_1796_;
                                                    if _e1459 {
                                                        phi_1802_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1802_ = type_15(1u, _e1454);
                                                    }
                                                    let _e1464 = phi_1802_;
                                                    phi_1773_ = type_14(_e1464.member_1, _e1445.member_1);
                                                    phi_1816_ = type_15(1u, _e1445.member);
                                                } else {
                                                    phi_1773_ = _e1445;
                                                    phi_1816_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1470 = phi_1773_;
                                                let _e1472 = phi_1816_;
                                                let _e1475 = (bitcast<i32>(_e1472.member) != 0i);
                                                if _e1475 {
                                                    phi_1776_ = (0.5f * (_e1447 + (_e1437 / _e1447)));
                                                } else {
                                                    phi_1776_ = f32();
                                                }
                                                let _e1480 = phi_1776_;
                                                continue;
                                                continuing {
                                                    phi_1772_ = _e1470;
                                                    phi_1775_ = _e1480;
                                                    break if !(_e1475);
                                                }
                                            }
                                            let _e1485 = local_6;
                                            phi_1829_ = (_e1485 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1492 = phi_1829_;
                                        if (_e1435 > 0f) {
                                            phi_1836_ = (_e1435 + _e1492);
                                        } else {
                                            phi_1836_ = (_e1435 - _e1492);
                                        }
                                        let _e1497 = phi_1836_;
                                        let _e1500 = (_e858.member_1[1] - (_e858.member_1[0] - (_e858.member[0] / _e1497)));
                                        let _e1503 = ((_e1500 * _e1500) + (_e858.member[0] * _e858.member[0]));
                                        if (_e1503 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1503 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1503 > 0f) {
                                                    phi_1863_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_1863_ = 0f;
                                                }
                                                let _e1560 = phi_1863_;
                                                phi_1927_ = _e1560;
                                            } else {
                                                phi_1870_ = type_14(0i, 5i);
                                                phi_1873_ = bitcast<f32>(((bitcast<u32>(_e1503) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1515 = phi_1870_;
                                                    let _e1517 = phi_1873_;
                                                    local_7 = _e1517;
                                                    if (_e1515.member < _e1515.member_1) {
                                                        let _e1524 = (_e1515.member + 1i);
                                                        if ((false == (_e1524 > _e1515.member)) != false) {
                                                            phi_1894_ = true;
                                                        } else {
                                                            phi_1894_ = false;
                                                        }
                                                        let _e1529 = phi_1894_;
                                                        if _e1529 {
                                                            phi_1900_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_1900_ = type_15(1u, _e1524);
                                                        }
                                                        let _e1534 = phi_1900_;
                                                        phi_1871_ = type_14(_e1534.member_1, _e1515.member_1);
                                                        phi_1914_ = type_15(1u, _e1515.member);
                                                    } else {
                                                        phi_1871_ = _e1515;
                                                        phi_1914_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1540 = phi_1871_;
                                                    let _e1542 = phi_1914_;
                                                    let _e1545 = (bitcast<i32>(_e1542.member) != 0i);
                                                    if _e1545 {
                                                        phi_1874_ = (0.5f * (_e1517 + (_e1503 / _e1517)));
                                                    } else {
                                                        phi_1874_ = f32();
                                                    }
                                                    let _e1550 = phi_1874_;
                                                    continue;
                                                    continuing {
                                                        phi_1870_ = _e1540;
                                                        phi_1873_ = _e1550;
                                                        break if !(_e1545);
                                                    }
                                                }
                                                let _e1555 = local_7;
                                                phi_1927_ = (_e1555 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1562 = phi_1927_;
                                            let _e1563 = (_e1500 / _e1562);
                                            let _e1564 = (_e858.member[0] / _e1562);
                                            let _e1569 = (1.5f - (((_e1563 * _e1563) + (_e1564 * _e1564)) * 0.5f));
                                            phi_1939_ = type_16((_e1563 * _e1569), (_e1564 * _e1569));
                                        } else {
                                            phi_1939_ = type_16(1f, 0f);
                                        }
                                        let _e1574 = phi_1939_;
                                        let _e1591 = (((_e858.member_1[0] - _e858.member_1[1]) * _e1574.member_1) + ((_e1574.member * _e858.member[0]) * 2f));
                                        let _e1601 = type_36(_e858.member, array<f32, 3>((_e858.member_1[0] - (_e1574.member_1 * _e1591)), (_e858.member_1[1] + (_e1574.member_1 * _e1591)), _e858.member_1[2]), _e858.member_2);
                                        let _e1607 = type_36(array<f32, 2>(((_e1574.member * _e1591) - _e858.member[0]), _e1601.member[1]), _e1601.member_1, _e1601.member_2);
                                        phi_2259_ = type_36(_e1607.member, _e1607.member_1, array<array<f32, 3>, 3>(array<f32, 3>(((_e858.member_2[0][0] * _e1574.member) - (_e858.member_2[1][0] * _e1574.member_1)), ((_e858.member_2[0][1] * _e1574.member) - (_e858.member_2[1][1] * _e1574.member_1)), ((_e858.member_2[0][2] * _e1574.member) - (_e858.member_2[1][2] * _e1574.member_1))), array<f32, 3>(((_e858.member_2[0][0] * _e1574.member_1) + (_e858.member_2[1][0] * _e1574.member)), ((_e858.member_2[0][1] * _e1574.member_1) + (_e858.member_2[1][1] * _e1574.member)), ((_e858.member_2[0][2] * _e1574.member_1) + (_e858.member_2[1][2] * _e1574.member))), _e858.member_2[2]));
                                    } else {
                                        if _e893 {
                                            let _e1222 = ((_e858.member_1[2] - _e858.member_1[1]) / (_e858.member[1] * 2f));
                                            let _e1224 = ((_e1222 * _e1222) + 1f);
                                            if (_e1224 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1224 > 0f) {
                                                    phi_2022_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_2022_ = 0f;
                                                }
                                                let _e1277 = phi_2022_;
                                                phi_2086_ = _e1277;
                                            } else {
                                                phi_2029_ = type_14(0i, 5i);
                                                phi_2032_ = bitcast<f32>(((bitcast<u32>(_e1224) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1232 = phi_2029_;
                                                    let _e1234 = phi_2032_;
                                                    local_4 = _e1234;
                                                    if (_e1232.member < _e1232.member_1) {
                                                        let _e1241 = (_e1232.member + 1i);
                                                        if ((false == (_e1241 > _e1232.member)) != false) {
                                                            phi_2053_ = true;
                                                        } else {
                                                            phi_2053_ = false;
                                                        }
                                                        let _e1246 = phi_2053_;
                                                        if _e1246 {
                                                            phi_2059_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_2059_ = type_15(1u, _e1241);
                                                        }
                                                        let _e1251 = phi_2059_;
                                                        phi_2030_ = type_14(_e1251.member_1, _e1232.member_1);
                                                        phi_2073_ = type_15(1u, _e1232.member);
                                                    } else {
                                                        phi_2030_ = _e1232;
                                                        phi_2073_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1257 = phi_2030_;
                                                    let _e1259 = phi_2073_;
                                                    let _e1262 = (bitcast<i32>(_e1259.member) != 0i);
                                                    if _e1262 {
                                                        phi_2033_ = (0.5f * (_e1234 + (_e1224 / _e1234)));
                                                    } else {
                                                        phi_2033_ = f32();
                                                    }
                                                    let _e1267 = phi_2033_;
                                                    continue;
                                                    continuing {
                                                        phi_2029_ = _e1257;
                                                        phi_2032_ = _e1267;
                                                        break if !(_e1262);
                                                    }
                                                }
                                                let _e1272 = local_4;
                                                phi_2086_ = (_e1272 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1279 = phi_2086_;
                                            if (_e1222 > 0f) {
                                                phi_2093_ = (_e1222 + _e1279);
                                            } else {
                                                phi_2093_ = (_e1222 - _e1279);
                                            }
                                            let _e1284 = phi_2093_;
                                            let _e1287 = (_e858.member_1[2] - (_e858.member_1[1] - (_e858.member[1] / _e1284)));
                                            let _e1290 = ((_e1287 * _e1287) + (_e858.member[1] * _e858.member[1]));
                                            if (_e1290 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                if (_e1290 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e1290 > 0f) {
                                                        phi_2120_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_2120_ = 0f;
                                                    }
                                                    let _e1347 = phi_2120_;
                                                    phi_2184_ = _e1347;
                                                } else {
                                                    phi_2127_ = type_14(0i, 5i);
                                                    phi_2130_ = bitcast<f32>(((bitcast<u32>(_e1290) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1302 = phi_2127_;
                                                        let _e1304 = phi_2130_;
                                                        local_5 = _e1304;
                                                        if (_e1302.member < _e1302.member_1) {
                                                            let _e1311 = (_e1302.member + 1i);
                                                            if ((false == (_e1311 > _e1302.member)) != false) {
                                                                phi_2151_ = true;
                                                            } else {
                                                                phi_2151_ = false;
                                                            }
                                                            let _e1316 = phi_2151_;
                                                            if _e1316 {
                                                                phi_2157_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_2157_ = type_15(1u, _e1311);
                                                            }
                                                            let _e1321 = phi_2157_;
                                                            phi_2128_ = type_14(_e1321.member_1, _e1302.member_1);
                                                            phi_2171_ = type_15(1u, _e1302.member);
                                                        } else {
                                                            phi_2128_ = _e1302;
                                                            phi_2171_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1327 = phi_2128_;
                                                        let _e1329 = phi_2171_;
                                                        let _e1332 = (bitcast<i32>(_e1329.member) != 0i);
                                                        if _e1332 {
                                                            phi_2131_ = (0.5f * (_e1304 + (_e1290 / _e1304)));
                                                        } else {
                                                            phi_2131_ = f32();
                                                        }
                                                        let _e1337 = phi_2131_;
                                                        continue;
                                                        continuing {
                                                            phi_2127_ = _e1327;
                                                            phi_2130_ = _e1337;
                                                            break if !(_e1332);
                                                        }
                                                    }
                                                    let _e1342 = local_5;
                                                    phi_2184_ = (_e1342 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1349 = phi_2184_;
                                                let _e1350 = (_e1287 / _e1349);
                                                let _e1351 = (_e858.member[1] / _e1349);
                                                let _e1356 = (1.5f - (((_e1350 * _e1350) + (_e1351 * _e1351)) * 0.5f));
                                                phi_2196_ = type_16((_e1350 * _e1356), (_e1351 * _e1356));
                                            } else {
                                                phi_2196_ = type_16(1f, 0f);
                                            }
                                            let _e1361 = phi_2196_;
                                            let _e1378 = (((_e858.member_1[1] - _e858.member_1[2]) * _e1361.member_1) + ((_e1361.member * _e858.member[1]) * 2f));
                                            let _e1388 = type_36(_e858.member, array<f32, 3>(_e858.member_1[0], (_e858.member_1[1] - (_e1361.member_1 * _e1378)), (_e858.member_1[2] + (_e1361.member_1 * _e1378))), _e858.member_2);
                                            let _e1394 = type_36(array<f32, 2>(_e1388.member[0], ((_e1361.member * _e1378) - _e858.member[1])), _e1388.member_1, _e1388.member_2);
                                            phi_2258_ = type_36(_e1394.member, _e1394.member_1, array<array<f32, 3>, 3>(_e858.member_2[0], array<f32, 3>(((_e858.member_2[1][0] * _e1361.member) - (_e858.member_2[2][0] * _e1361.member_1)), ((_e858.member_2[1][1] * _e1361.member) - (_e858.member_2[2][1] * _e1361.member_1)), ((_e858.member_2[1][2] * _e1361.member) - (_e858.member_2[2][2] * _e1361.member_1))), array<f32, 3>(((_e858.member_2[1][0] * _e1361.member_1) + (_e858.member_2[2][0] * _e1361.member)), ((_e858.member_2[1][1] * _e1361.member_1) + (_e858.member_2[2][1] * _e1361.member)), ((_e858.member_2[1][2] * _e1361.member_1) + (_e858.member_2[2][2] * _e1361.member)))));
                                        } else {
                                            phi_2258_ = _e858;
                                        }
                                        let _e1432 = phi_2258_;
                                        phi_2259_ = _e1432;
                                    }
                                    let _e1645 = phi_2259_;
                                    phi_2260_ = _e1645;
                                } else {
                                    phi_2260_ = _e1217;
                                }
                                let _e1647 = phi_2260_;
                                if _e888 {
                                    phi_2264_ = true;
                                } else {
                                    phi_2264_ = _e893;
                                }
                                let _e1649 = phi_2264_;
                                if _e1649 {
                                    phi_2268_ = false;
                                } else {
                                    phi_2268_ = true;
                                }
                                let _e1651 = phi_2268_;
                                phi_1256_ = _e1647;
                                phi_2269_ = _e1647;
                                phi_2270_ = _e1649;
                                phi_2271_ = _e1651;
                            } else {
                                phi_1256_ = type_36();
                                phi_2269_ = type_36();
                                phi_2270_ = false;
                                phi_2271_ = false;
                            }
                            let _e1653 = phi_1256_;
                            let _e1655 = phi_2269_;
                            let _e1657 = phi_2270_;
                            let _e1659 = phi_2271_;
                            local_8 = _e1659;
                            local_13 = _e1655;
                            continue;
                            continuing {
                                phi_1252_ = _e870;
                                phi_1255_ = _e1653;
                                break if !(_e1657);
                            }
                        }
                        let _e1662 = local_8;
                        if _e1662 {
                            let _e3674 = local_13;
                            phi_2275_ = _e3674;
                        } else {
                            let _e3676 = local_14;
                            phi_2275_ = _e3676;
                        }
                        let _e1664 = phi_2275_;
                        let _e1668 = (2130706432u - (bitcast<u32>(_e739) & 2139095040u));
                        if (_e1668 > 8388608u) {
                            phi_2287_ = _e1668;
                        } else {
                            phi_2287_ = 8388608u;
                        }
                        let _e1671 = phi_2287_;
                        let _e1672 = bitcast<f32>(_e1671);
                        let _e1694 = ((((_e1664.member_2[0][0] * _e1664.member_2[0][0]) + (_e1664.member_2[0][1] * _e1664.member_2[0][1])) + (_e1664.member_2[0][2] * _e1664.member_2[0][2])) - 1f);
                        let _e1708 = ((((_e1664.member_2[1][0] * _e1664.member_2[1][0]) + (_e1664.member_2[1][1] * _e1664.member_2[1][1])) + (_e1664.member_2[1][2] * _e1664.member_2[1][2])) - 1f);
                        let _e1722 = ((((_e1664.member_2[2][0] * _e1664.member_2[2][0]) + (_e1664.member_2[2][1] * _e1664.member_2[2][1])) + (_e1664.member_2[2][2] * _e1664.member_2[2][2])) - 1f);
                        let _e1735 = (((_e1664.member_2[0][0] * _e1664.member_2[1][0]) + (_e1664.member_2[0][1] * _e1664.member_2[1][1])) + (_e1664.member_2[0][2] * _e1664.member_2[1][2]));
                        let _e1748 = (((_e1664.member_2[0][0] * _e1664.member_2[2][0]) + (_e1664.member_2[0][1] * _e1664.member_2[2][1])) + (_e1664.member_2[0][2] * _e1664.member_2[2][2]));
                        let _e1761 = (((_e1664.member_2[1][0] * _e1664.member_2[2][0]) + (_e1664.member_2[1][1] * _e1664.member_2[2][1])) + (_e1664.member_2[1][2] * _e1664.member_2[2][2]));
                        let _e1794 = (_e1664.member_2[0][0] - ((((_e1664.member_2[0][0] * _e1694) + (_e1664.member_2[1][0] * _e1735)) + (_e1664.member_2[2][0] * _e1748)) * 0.5f));
                        let _e1796 = (_e1664.member_2[0][1] - ((((_e1664.member_2[0][1] * _e1694) + (_e1664.member_2[1][1] * _e1735)) + (_e1664.member_2[2][1] * _e1748)) * 0.5f));
                        let _e1798 = (_e1664.member_2[0][2] - ((((_e1664.member_2[0][2] * _e1694) + (_e1664.member_2[1][2] * _e1735)) + (_e1664.member_2[2][2] * _e1748)) * 0.5f));
                        if (_e1794 < 0f) {
                            phi_2420_ = -(_e1794);
                        } else {
                            phi_2420_ = _e1794;
                        }
                        let _e1802 = phi_2420_;
                        if (_e1802 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2426_ = _e1794;
                        } else {
                            phi_2426_ = 0f;
                        }
                        let _e1806 = phi_2426_;
                        if (_e1796 < 0f) {
                            phi_2432_ = -(_e1796);
                        } else {
                            phi_2432_ = _e1796;
                        }
                        let _e1810 = phi_2432_;
                        if (_e1810 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2438_ = _e1796;
                        } else {
                            phi_2438_ = 0f;
                        }
                        let _e1814 = phi_2438_;
                        if (_e1798 < 0f) {
                            phi_2444_ = -(_e1798);
                        } else {
                            phi_2444_ = _e1798;
                        }
                        let _e1818 = phi_2444_;
                        if (_e1818 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2450_ = _e1798;
                        } else {
                            phi_2450_ = 0f;
                        }
                        let _e1822 = phi_2450_;
                        let _e1856 = (_e1664.member_2[1][0] - ((((_e1664.member_2[0][0] * _e1735) + (_e1664.member_2[1][0] * _e1708)) + (_e1664.member_2[2][0] * _e1761)) * 0.5f));
                        let _e1858 = (_e1664.member_2[1][1] - ((((_e1664.member_2[0][1] * _e1735) + (_e1664.member_2[1][1] * _e1708)) + (_e1664.member_2[2][1] * _e1761)) * 0.5f));
                        let _e1860 = (_e1664.member_2[1][2] - ((((_e1664.member_2[0][2] * _e1735) + (_e1664.member_2[1][2] * _e1708)) + (_e1664.member_2[2][2] * _e1761)) * 0.5f));
                        if (_e1856 < 0f) {
                            phi_2494_ = -(_e1856);
                        } else {
                            phi_2494_ = _e1856;
                        }
                        let _e1864 = phi_2494_;
                        if (_e1864 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2500_ = _e1856;
                        } else {
                            phi_2500_ = 0f;
                        }
                        let _e1868 = phi_2500_;
                        if (_e1858 < 0f) {
                            phi_2506_ = -(_e1858);
                        } else {
                            phi_2506_ = _e1858;
                        }
                        let _e1872 = phi_2506_;
                        if (_e1872 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2512_ = _e1858;
                        } else {
                            phi_2512_ = 0f;
                        }
                        let _e1876 = phi_2512_;
                        if (_e1860 < 0f) {
                            phi_2518_ = -(_e1860);
                        } else {
                            phi_2518_ = _e1860;
                        }
                        let _e1880 = phi_2518_;
                        if (_e1880 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2524_ = _e1860;
                        } else {
                            phi_2524_ = 0f;
                        }
                        let _e1884 = phi_2524_;
                        let _e1918 = (_e1664.member_2[2][0] - ((((_e1664.member_2[0][0] * _e1748) + (_e1664.member_2[1][0] * _e1761)) + (_e1664.member_2[2][0] * _e1722)) * 0.5f));
                        let _e1920 = (_e1664.member_2[2][1] - ((((_e1664.member_2[0][1] * _e1748) + (_e1664.member_2[1][1] * _e1761)) + (_e1664.member_2[2][1] * _e1722)) * 0.5f));
                        let _e1922 = (_e1664.member_2[2][2] - ((((_e1664.member_2[0][2] * _e1748) + (_e1664.member_2[1][2] * _e1761)) + (_e1664.member_2[2][2] * _e1722)) * 0.5f));
                        if (_e1918 < 0f) {
                            phi_2568_ = -(_e1918);
                        } else {
                            phi_2568_ = _e1918;
                        }
                        let _e1926 = phi_2568_;
                        if (_e1926 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2574_ = _e1918;
                        } else {
                            phi_2574_ = 0f;
                        }
                        let _e1930 = phi_2574_;
                        if (_e1920 < 0f) {
                            phi_2580_ = -(_e1920);
                        } else {
                            phi_2580_ = _e1920;
                        }
                        let _e1934 = phi_2580_;
                        if (_e1934 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2586_ = _e1920;
                        } else {
                            phi_2586_ = 0f;
                        }
                        let _e1938 = phi_2586_;
                        if (_e1922 < 0f) {
                            phi_2592_ = -(_e1922);
                        } else {
                            phi_2592_ = _e1922;
                        }
                        let _e1942 = phi_2592_;
                        if (_e1942 > (0.000000059604645f * 0.000000059604645f)) {
                            phi_2598_ = _e1922;
                        } else {
                            phi_2598_ = 0f;
                        }
                        let _e1946 = phi_2598_;
                        let _e1954 = ((((_e1806 * _e1806) + (_e1814 * _e1814)) + (_e1822 * _e1822)) - 1f);
                        let _e1960 = ((((_e1868 * _e1868) + (_e1876 * _e1876)) + (_e1884 * _e1884)) - 1f);
                        let _e1966 = ((((_e1930 * _e1930) + (_e1938 * _e1938)) + (_e1946 * _e1946)) - 1f);
                        let _e1971 = (((_e1806 * _e1868) + (_e1814 * _e1876)) + (_e1822 * _e1884));
                        let _e1976 = (((_e1806 * _e1930) + (_e1814 * _e1938)) + (_e1822 * _e1946));
                        let _e1981 = (((_e1868 * _e1930) + (_e1876 * _e1938)) + (_e1884 * _e1946));
                        if (_e1954 < 0f) {
                            phi_2639_ = -(_e1954);
                        } else {
                            phi_2639_ = _e1954;
                        }
                        let _e1985 = phi_2639_;
                        if (_e1960 < 0f) {
                            phi_2645_ = -(_e1960);
                        } else {
                            phi_2645_ = _e1960;
                        }
                        let _e1989 = phi_2645_;
                        if (_e1985 > _e1989) {
                            phi_2650_ = _e1985;
                        } else {
                            phi_2650_ = _e1989;
                        }
                        let _e1992 = phi_2650_;
                        if (_e1966 < 0f) {
                            phi_2656_ = -(_e1966);
                        } else {
                            phi_2656_ = _e1966;
                        }
                        let _e1996 = phi_2656_;
                        if (_e1992 > _e1996) {
                            phi_2661_ = _e1992;
                        } else {
                            phi_2661_ = _e1996;
                        }
                        let _e1999 = phi_2661_;
                        if (_e1971 < 0f) {
                            phi_2667_ = -(_e1971);
                        } else {
                            phi_2667_ = _e1971;
                        }
                        let _e2003 = phi_2667_;
                        if (_e1976 < 0f) {
                            phi_2673_ = -(_e1976);
                        } else {
                            phi_2673_ = _e1976;
                        }
                        let _e2007 = phi_2673_;
                        if (_e2003 > _e2007) {
                            phi_2678_ = _e2003;
                        } else {
                            phi_2678_ = _e2007;
                        }
                        let _e2010 = phi_2678_;
                        if (_e1981 < 0f) {
                            phi_2684_ = -(_e1981);
                        } else {
                            phi_2684_ = _e1981;
                        }
                        let _e2014 = phi_2684_;
                        if (_e2010 > _e2014) {
                            phi_2689_ = _e2010;
                        } else {
                            phi_2689_ = _e2014;
                        }
                        let _e2017 = phi_2689_;
                        if (_e1999 > _e2017) {
                            phi_2694_ = _e1999;
                        } else {
                            phi_2694_ = _e2017;
                        }
                        let _e2020 = phi_2694_;
                        if (_e2020 <= (0.000000059604645f * (16f - 6f))) {
                            phi_2705_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1806, _e1814, _e1822), array<f32, 3>(_e1868, _e1876, _e1884), array<f32, 3>(_e1930, _e1938, _e1946));
                        } else {
                            phi_2705_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                        }
                        let _e2025 = phi_2705_;
                        phi_2707_ = type_37(array<f32, 3>((_e1664.member_1[0] * _e1672), (_e1664.member_1[1] * _e1672), (_e1664.member_1[2] * _e1672)), _e2025);
                        phi_2708_ = false;
                    } else {
                        phi_2707_ = type_37();
                        phi_2708_ = true;
                    }
                    let _e2028 = phi_2707_;
                    let _e2030 = phi_2708_;
                    phi_2709_ = _e2028;
                    phi_2710_ = _e2030;
                } else {
                    phi_2709_ = type_37();
                    phi_2710_ = true;
                }
                let _e2032 = phi_2709_;
                let _e2034 = phi_2710_;
                if _e2034 {
                    phi_2723_ = type_37(array<f32, 3>(_e681, _e685, _e689), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                } else {
                    phi_2723_ = _e2032;
                }
                let _e2038 = phi_2723_;
                let _e2053 = (((_e289.member_1[0][0] * _e2038.member_1[0][0]) + (_e289.member_1[0][1] * _e2038.member_1[0][1])) + (_e289.member_1[0][2] * _e2038.member_1[0][2]));
                let _e2066 = (((_e289.member_1[1][0] * _e2038.member_1[0][0]) + (_e289.member_1[1][1] * _e2038.member_1[0][1])) + (_e289.member_1[1][2] * _e2038.member_1[0][2]));
                let _e2079 = (((_e289.member_1[2][0] * _e2038.member_1[0][0]) + (_e289.member_1[2][1] * _e2038.member_1[0][1])) + (_e289.member_1[2][2] * _e2038.member_1[0][2]));
                if (_e2053 < 0f) {
                    phi_2768_ = -(_e2053);
                } else {
                    phi_2768_ = _e2053;
                }
                let _e2084 = phi_2768_;
                if (_e2066 < 0f) {
                    phi_2774_ = -(_e2066);
                } else {
                    phi_2774_ = _e2066;
                }
                let _e2088 = phi_2774_;
                if (_e2079 < 0f) {
                    phi_2780_ = -(_e2079);
                } else {
                    phi_2780_ = _e2079;
                }
                let _e2092 = phi_2780_;
                let _e2100 = (((_e2084 * _e289.member_2[0]) + (_e2088 * _e289.member_2[1])) + (_e2092 * _e289.member_2[2]));
                let _e2114 = (((_e289.member_1[0][0] * _e2038.member_1[1][0]) + (_e289.member_1[0][1] * _e2038.member_1[1][1])) + (_e289.member_1[0][2] * _e2038.member_1[1][2]));
                let _e2127 = (((_e289.member_1[1][0] * _e2038.member_1[1][0]) + (_e289.member_1[1][1] * _e2038.member_1[1][1])) + (_e289.member_1[1][2] * _e2038.member_1[1][2]));
                let _e2140 = (((_e289.member_1[2][0] * _e2038.member_1[1][0]) + (_e289.member_1[2][1] * _e2038.member_1[1][1])) + (_e289.member_1[2][2] * _e2038.member_1[1][2]));
                if (_e2114 < 0f) {
                    phi_2832_ = -(_e2114);
                } else {
                    phi_2832_ = _e2114;
                }
                let _e2145 = phi_2832_;
                if (_e2127 < 0f) {
                    phi_2838_ = -(_e2127);
                } else {
                    phi_2838_ = _e2127;
                }
                let _e2149 = phi_2838_;
                if (_e2140 < 0f) {
                    phi_2844_ = -(_e2140);
                } else {
                    phi_2844_ = _e2140;
                }
                let _e2153 = phi_2844_;
                let _e2161 = (((_e2145 * _e289.member_2[0]) + (_e2149 * _e289.member_2[1])) + (_e2153 * _e289.member_2[2]));
                let _e2175 = (((_e289.member_1[0][0] * _e2038.member_1[2][0]) + (_e289.member_1[0][1] * _e2038.member_1[2][1])) + (_e289.member_1[0][2] * _e2038.member_1[2][2]));
                let _e2188 = (((_e289.member_1[1][0] * _e2038.member_1[2][0]) + (_e289.member_1[1][1] * _e2038.member_1[2][1])) + (_e289.member_1[1][2] * _e2038.member_1[2][2]));
                let _e2201 = (((_e289.member_1[2][0] * _e2038.member_1[2][0]) + (_e289.member_1[2][1] * _e2038.member_1[2][1])) + (_e289.member_1[2][2] * _e2038.member_1[2][2]));
                if (_e2175 < 0f) {
                    phi_2896_ = -(_e2175);
                } else {
                    phi_2896_ = _e2175;
                }
                let _e2206 = phi_2896_;
                if (_e2188 < 0f) {
                    phi_2902_ = -(_e2188);
                } else {
                    phi_2902_ = _e2188;
                }
                let _e2210 = phi_2902_;
                if (_e2201 < 0f) {
                    phi_2908_ = -(_e2201);
                } else {
                    phi_2908_ = _e2201;
                }
                let _e2214 = phi_2908_;
                let _e2222 = (((_e2206 * _e289.member_2[0]) + (_e2210 * _e289.member_2[1])) + (_e2214 * _e289.member_2[2]));
                let _e2236 = (((_e415.member_1[0][0] * _e2038.member_1[0][0]) + (_e415.member_1[0][1] * _e2038.member_1[0][1])) + (_e415.member_1[0][2] * _e2038.member_1[0][2]));
                let _e2249 = (((_e415.member_1[1][0] * _e2038.member_1[0][0]) + (_e415.member_1[1][1] * _e2038.member_1[0][1])) + (_e415.member_1[1][2] * _e2038.member_1[0][2]));
                let _e2262 = (((_e415.member_1[2][0] * _e2038.member_1[0][0]) + (_e415.member_1[2][1] * _e2038.member_1[0][1])) + (_e415.member_1[2][2] * _e2038.member_1[0][2]));
                if (_e2236 < 0f) {
                    phi_2960_ = -(_e2236);
                } else {
                    phi_2960_ = _e2236;
                }
                let _e2267 = phi_2960_;
                if (_e2249 < 0f) {
                    phi_2966_ = -(_e2249);
                } else {
                    phi_2966_ = _e2249;
                }
                let _e2271 = phi_2966_;
                if (_e2262 < 0f) {
                    phi_2972_ = -(_e2262);
                } else {
                    phi_2972_ = _e2262;
                }
                let _e2275 = phi_2972_;
                let _e2283 = (((_e2267 * _e415.member_2[0]) + (_e2271 * _e415.member_2[1])) + (_e2275 * _e415.member_2[2]));
                let _e2297 = (((_e415.member_1[0][0] * _e2038.member_1[1][0]) + (_e415.member_1[0][1] * _e2038.member_1[1][1])) + (_e415.member_1[0][2] * _e2038.member_1[1][2]));
                let _e2310 = (((_e415.member_1[1][0] * _e2038.member_1[1][0]) + (_e415.member_1[1][1] * _e2038.member_1[1][1])) + (_e415.member_1[1][2] * _e2038.member_1[1][2]));
                let _e2323 = (((_e415.member_1[2][0] * _e2038.member_1[1][0]) + (_e415.member_1[2][1] * _e2038.member_1[1][1])) + (_e415.member_1[2][2] * _e2038.member_1[1][2]));
                if (_e2297 < 0f) {
                    phi_3024_ = -(_e2297);
                } else {
                    phi_3024_ = _e2297;
                }
                let _e2328 = phi_3024_;
                if (_e2310 < 0f) {
                    phi_3030_ = -(_e2310);
                } else {
                    phi_3030_ = _e2310;
                }
                let _e2332 = phi_3030_;
                if (_e2323 < 0f) {
                    phi_3036_ = -(_e2323);
                } else {
                    phi_3036_ = _e2323;
                }
                let _e2336 = phi_3036_;
                let _e2344 = (((_e2328 * _e415.member_2[0]) + (_e2332 * _e415.member_2[1])) + (_e2336 * _e415.member_2[2]));
                let _e2358 = (((_e415.member_1[0][0] * _e2038.member_1[2][0]) + (_e415.member_1[0][1] * _e2038.member_1[2][1])) + (_e415.member_1[0][2] * _e2038.member_1[2][2]));
                let _e2371 = (((_e415.member_1[1][0] * _e2038.member_1[2][0]) + (_e415.member_1[1][1] * _e2038.member_1[2][1])) + (_e415.member_1[1][2] * _e2038.member_1[2][2]));
                let _e2384 = (((_e415.member_1[2][0] * _e2038.member_1[2][0]) + (_e415.member_1[2][1] * _e2038.member_1[2][1])) + (_e415.member_1[2][2] * _e2038.member_1[2][2]));
                if (_e2358 < 0f) {
                    phi_3088_ = -(_e2358);
                } else {
                    phi_3088_ = _e2358;
                }
                let _e2389 = phi_3088_;
                if (_e2371 < 0f) {
                    phi_3094_ = -(_e2371);
                } else {
                    phi_3094_ = _e2371;
                }
                let _e2393 = phi_3094_;
                if (_e2384 < 0f) {
                    phi_3100_ = -(_e2384);
                } else {
                    phi_3100_ = _e2384;
                }
                let _e2397 = phi_3100_;
                let _e2405 = (((_e2389 * _e415.member_2[0]) + (_e2393 * _e415.member_2[1])) + (_e2397 * _e415.member_2[2]));
                let _e2414 = (((_e2038.member_1[0][0] * _e420) + (_e2038.member_1[0][1] * _e423)) + (_e2038.member_1[0][2] * _e426));
                let _e2423 = (((_e2038.member_1[1][0] * _e420) + (_e2038.member_1[1][1] * _e423)) + (_e2038.member_1[1][2] * _e426));
                let _e2432 = (((_e2038.member_1[2][0] * _e420) + (_e2038.member_1[2][1] * _e423)) + (_e2038.member_1[2][2] * _e426));
                let _e2433 = (_e2100 * -1f);
                let _e2434 = (_e2161 * -1f);
                let _e2435 = (_e2222 * -1f);
                let _e2436 = (_e2414 - _e2283);
                let _e2437 = (_e2423 - _e2344);
                let _e2438 = (_e2432 - _e2405);
                if (_e2433 < _e2436) {
                    phi_3146_ = _e2433;
                } else {
                    phi_3146_ = _e2436;
                }
                let _e2441 = phi_3146_;
                if (_e2434 < _e2437) {
                    phi_3151_ = _e2434;
                } else {
                    phi_3151_ = _e2437;
                }
                let _e2444 = phi_3151_;
                if (_e2435 < _e2438) {
                    phi_3156_ = _e2435;
                } else {
                    phi_3156_ = _e2438;
                }
                let _e2447 = phi_3156_;
                let _e2448 = (_e2414 + _e2283);
                let _e2449 = (_e2423 + _e2344);
                let _e2450 = (_e2432 + _e2405);
                if (_e2100 > _e2448) {
                    phi_3164_ = _e2100;
                } else {
                    phi_3164_ = _e2448;
                }
                let _e2453 = phi_3164_;
                if (_e2161 > _e2449) {
                    phi_3169_ = _e2161;
                } else {
                    phi_3169_ = _e2449;
                }
                let _e2456 = phi_3169_;
                if (_e2222 > _e2450) {
                    phi_3174_ = _e2222;
                } else {
                    phi_3174_ = _e2450;
                }
                let _e2459 = phi_3174_;
                let _e2464 = ((_e2441 + _e2453) * 0.5f);
                let _e2465 = ((_e2444 + _e2456) * 0.5f);
                let _e2466 = ((_e2447 + _e2459) * 0.5f);
                let _e2495 = (_e289.member[0] + (((_e2038.member_1[0][0] * _e2464) + (_e2038.member_1[1][0] * _e2465)) + (_e2038.member_1[2][0] * _e2466)));
                let _e2497 = (_e289.member[1] + (((_e2038.member_1[0][1] * _e2464) + (_e2038.member_1[1][1] * _e2465)) + (_e2038.member_1[2][1] * _e2466)));
                let _e2499 = (_e289.member[2] + (((_e2038.member_1[0][2] * _e2464) + (_e2038.member_1[1][2] * _e2465)) + (_e2038.member_1[2][2] * _e2466)));
                if (_e289.member[0] < 0f) {
                    phi_3223_ = -(_e289.member[0]);
                } else {
                    phi_3223_ = _e289.member[0];
                }
                let _e2506 = phi_3223_;
                if (_e289.member[1] < 0f) {
                    phi_3230_ = -(_e289.member[1]);
                } else {
                    phi_3230_ = _e289.member[1];
                }
                let _e2511 = phi_3230_;
                if (_e289.member[2] < 0f) {
                    phi_3237_ = -(_e289.member[2]);
                } else {
                    phi_3237_ = _e289.member[2];
                }
                let _e2516 = phi_3237_;
                if (_e415.member[0] < 0f) {
                    phi_3245_ = -(_e415.member[0]);
                } else {
                    phi_3245_ = _e415.member[0];
                }
                let _e2522 = phi_3245_;
                if (_e415.member[1] < 0f) {
                    phi_3252_ = -(_e415.member[1]);
                } else {
                    phi_3252_ = _e415.member[1];
                }
                let _e2527 = phi_3252_;
                if (_e415.member[2] < 0f) {
                    phi_3259_ = -(_e415.member[2]);
                } else {
                    phi_3259_ = _e415.member[2];
                }
                let _e2532 = phi_3259_;
                if (_e2506 > _e2522) {
                    phi_3264_ = _e2506;
                } else {
                    phi_3264_ = _e2522;
                }
                let _e2535 = phi_3264_;
                if (_e2511 > _e2527) {
                    phi_3269_ = _e2511;
                } else {
                    phi_3269_ = _e2527;
                }
                let _e2538 = phi_3269_;
                if (_e2516 > _e2532) {
                    phi_3274_ = _e2516;
                } else {
                    phi_3274_ = _e2532;
                }
                let _e2541 = phi_3274_;
                let _e2544 = (_e289.member[0] - _e2495);
                let _e2546 = (_e289.member[1] - _e2497);
                let _e2548 = (_e289.member[2] - _e2499);
                if (_e2544 < 0f) {
                    phi_3287_ = -(_e2544);
                } else {
                    phi_3287_ = _e2544;
                }
                let _e2552 = phi_3287_;
                if (_e2546 < 0f) {
                    phi_3293_ = -(_e2546);
                } else {
                    phi_3293_ = _e2546;
                }
                let _e2556 = phi_3293_;
                if (_e2548 < 0f) {
                    phi_3300_ = -(_e2548);
                } else {
                    phi_3300_ = _e2548;
                }
                let _e2561 = phi_3300_;
                let _e2564 = (((_e2552 + _e2556) + _e2561) * (0.000000059604645f * 16f));
                if (_e2038.member_1[0][0] < 0f) {
                    phi_3311_ = -(_e2038.member_1[0][0]);
                } else {
                    phi_3311_ = _e2038.member_1[0][0];
                }
                let _e2570 = phi_3311_;
                if (_e2038.member_1[0][1] < 0f) {
                    phi_3318_ = -(_e2038.member_1[0][1]);
                } else {
                    phi_3318_ = _e2038.member_1[0][1];
                }
                let _e2575 = phi_3318_;
                if (_e2038.member_1[0][2] < 0f) {
                    phi_3325_ = -(_e2038.member_1[0][2]);
                } else {
                    phi_3325_ = _e2038.member_1[0][2];
                }
                let _e2580 = phi_3325_;
                if (_e2038.member_1[1][0] < 0f) {
                    phi_3338_ = -(_e2038.member_1[1][0]);
                } else {
                    phi_3338_ = _e2038.member_1[1][0];
                }
                let _e2591 = phi_3338_;
                if (_e2038.member_1[1][1] < 0f) {
                    phi_3345_ = -(_e2038.member_1[1][1]);
                } else {
                    phi_3345_ = _e2038.member_1[1][1];
                }
                let _e2596 = phi_3345_;
                if (_e2038.member_1[1][2] < 0f) {
                    phi_3352_ = -(_e2038.member_1[1][2]);
                } else {
                    phi_3352_ = _e2038.member_1[1][2];
                }
                let _e2601 = phi_3352_;
                if (_e2038.member_1[2][0] < 0f) {
                    phi_3365_ = -(_e2038.member_1[2][0]);
                } else {
                    phi_3365_ = _e2038.member_1[2][0];
                }
                let _e2612 = phi_3365_;
                if (_e2038.member_1[2][1] < 0f) {
                    phi_3372_ = -(_e2038.member_1[2][1]);
                } else {
                    phi_3372_ = _e2038.member_1[2][1];
                }
                let _e2617 = phi_3372_;
                if (_e2038.member_1[2][2] < 0f) {
                    phi_3379_ = -(_e2038.member_1[2][2]);
                } else {
                    phi_3379_ = _e2038.member_1[2][2];
                }
                let _e2622 = phi_3379_;
                let _e2628 = (0.000000059604645f * 12f);
                let _e2632 = (((((_e2570 * _e2535) + (_e2575 * _e2538)) + (_e2580 * _e2541)) * _e2628) + _e2564);
                let _e2633 = (((((_e2591 * _e2535) + (_e2596 * _e2538)) + (_e2601 * _e2541)) * _e2628) + _e2564);
                let _e2634 = (((((_e2612 * _e2535) + (_e2617 * _e2538)) + (_e2622 * _e2541)) * _e2628) + _e2564);
                let _e2637 = (_e289.member[0] - _e2495);
                let _e2639 = (_e289.member[1] - _e2497);
                let _e2641 = (_e289.member[2] - _e2499);
                if (_e289.member_2[0] < 0f) {
                    phi_3406_ = -(_e289.member_2[0]);
                } else {
                    phi_3406_ = _e289.member_2[0];
                }
                let _e2647 = phi_3406_;
                if (_e289.member_2[1] < 0f) {
                    phi_3413_ = -(_e289.member_2[1]);
                } else {
                    phi_3413_ = _e289.member_2[1];
                }
                let _e2652 = phi_3413_;
                if (_e289.member_2[2] < 0f) {
                    phi_3421_ = -(_e289.member_2[2]);
                } else {
                    phi_3421_ = _e289.member_2[2];
                }
                let _e2658 = phi_3421_;
                if (_e2637 < 0f) {
                    phi_3430_ = -(_e2637);
                } else {
                    phi_3430_ = _e2637;
                }
                let _e2665 = phi_3430_;
                if (_e2639 < 0f) {
                    phi_3436_ = -(_e2639);
                } else {
                    phi_3436_ = _e2639;
                }
                let _e2669 = phi_3436_;
                if (_e2641 < 0f) {
                    phi_3442_ = -(_e2641);
                } else {
                    phi_3442_ = _e2641;
                }
                let _e2673 = phi_3442_;
                if (_e2038.member_1[0][0] < 0f) {
                    phi_3450_ = -(_e2038.member_1[0][0]);
                } else {
                    phi_3450_ = _e2038.member_1[0][0];
                }
                let _e2679 = phi_3450_;
                if (_e2038.member_1[0][1] < 0f) {
                    phi_3457_ = -(_e2038.member_1[0][1]);
                } else {
                    phi_3457_ = _e2038.member_1[0][1];
                }
                let _e2684 = phi_3457_;
                if (_e2038.member_1[0][2] < 0f) {
                    phi_3464_ = -(_e2038.member_1[0][2]);
                } else {
                    phi_3464_ = _e2038.member_1[0][2];
                }
                let _e2689 = phi_3464_;
                if (_e2038.member_1[1][0] < 0f) {
                    phi_3477_ = -(_e2038.member_1[1][0]);
                } else {
                    phi_3477_ = _e2038.member_1[1][0];
                }
                let _e2700 = phi_3477_;
                if (_e2038.member_1[1][1] < 0f) {
                    phi_3484_ = -(_e2038.member_1[1][1]);
                } else {
                    phi_3484_ = _e2038.member_1[1][1];
                }
                let _e2705 = phi_3484_;
                if (_e2038.member_1[1][2] < 0f) {
                    phi_3491_ = -(_e2038.member_1[1][2]);
                } else {
                    phi_3491_ = _e2038.member_1[1][2];
                }
                let _e2710 = phi_3491_;
                if (_e2038.member_1[2][0] < 0f) {
                    phi_3504_ = -(_e2038.member_1[2][0]);
                } else {
                    phi_3504_ = _e2038.member_1[2][0];
                }
                let _e2721 = phi_3504_;
                if (_e2038.member_1[2][1] < 0f) {
                    phi_3511_ = -(_e2038.member_1[2][1]);
                } else {
                    phi_3511_ = _e2038.member_1[2][1];
                }
                let _e2726 = phi_3511_;
                if (_e2038.member_1[2][2] < 0f) {
                    phi_3518_ = -(_e2038.member_1[2][2]);
                } else {
                    phi_3518_ = _e2038.member_1[2][2];
                }
                let _e2731 = phi_3518_;
                let _e2737 = (0.000000059604645f * 8f);
                let _e2742 = ((((_e2647 + _e2652) + _e2658) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e2754 = (((_e2038.member_1[0][0] * _e2637) + (_e2038.member_1[0][1] * _e2639)) + (_e2038.member_1[0][2] * _e2641));
                let _e2763 = (((_e2038.member_1[1][0] * _e2637) + (_e2038.member_1[1][1] * _e2639)) + (_e2038.member_1[1][2] * _e2641));
                let _e2772 = (((_e2038.member_1[2][0] * _e2637) + (_e2038.member_1[2][1] * _e2639)) + (_e2038.member_1[2][2] * _e2641));
                if (_e2754 < 0f) {
                    phi_3565_ = -(_e2754);
                } else {
                    phi_3565_ = _e2754;
                }
                let _e2776 = phi_3565_;
                if (_e2763 < 0f) {
                    phi_3571_ = -(_e2763);
                } else {
                    phi_3571_ = _e2763;
                }
                let _e2780 = phi_3571_;
                if (_e2772 < 0f) {
                    phi_3577_ = -(_e2772);
                } else {
                    phi_3577_ = _e2772;
                }
                let _e2784 = phi_3577_;
                let _e2798 = (((_e289.member_1[0][0] * _e2038.member_1[0][0]) + (_e289.member_1[0][1] * _e2038.member_1[0][1])) + (_e289.member_1[0][2] * _e2038.member_1[0][2]));
                let _e2811 = (((_e289.member_1[1][0] * _e2038.member_1[0][0]) + (_e289.member_1[1][1] * _e2038.member_1[0][1])) + (_e289.member_1[1][2] * _e2038.member_1[0][2]));
                let _e2824 = (((_e289.member_1[2][0] * _e2038.member_1[0][0]) + (_e289.member_1[2][1] * _e2038.member_1[0][1])) + (_e289.member_1[2][2] * _e2038.member_1[0][2]));
                if (_e2798 < 0f) {
                    phi_3621_ = -(_e2798);
                } else {
                    phi_3621_ = _e2798;
                }
                let _e2829 = phi_3621_;
                if (_e2811 < 0f) {
                    phi_3627_ = -(_e2811);
                } else {
                    phi_3627_ = _e2811;
                }
                let _e2833 = phi_3627_;
                if (_e2824 < 0f) {
                    phi_3633_ = -(_e2824);
                } else {
                    phi_3633_ = _e2824;
                }
                let _e2837 = phi_3633_;
                let _e2859 = (((_e289.member_1[0][0] * _e2038.member_1[1][0]) + (_e289.member_1[0][1] * _e2038.member_1[1][1])) + (_e289.member_1[0][2] * _e2038.member_1[1][2]));
                let _e2872 = (((_e289.member_1[1][0] * _e2038.member_1[1][0]) + (_e289.member_1[1][1] * _e2038.member_1[1][1])) + (_e289.member_1[1][2] * _e2038.member_1[1][2]));
                let _e2885 = (((_e289.member_1[2][0] * _e2038.member_1[1][0]) + (_e289.member_1[2][1] * _e2038.member_1[1][1])) + (_e289.member_1[2][2] * _e2038.member_1[1][2]));
                if (_e2859 < 0f) {
                    phi_3685_ = -(_e2859);
                } else {
                    phi_3685_ = _e2859;
                }
                let _e2890 = phi_3685_;
                if (_e2872 < 0f) {
                    phi_3691_ = -(_e2872);
                } else {
                    phi_3691_ = _e2872;
                }
                let _e2894 = phi_3691_;
                if (_e2885 < 0f) {
                    phi_3697_ = -(_e2885);
                } else {
                    phi_3697_ = _e2885;
                }
                let _e2898 = phi_3697_;
                let _e2920 = (((_e289.member_1[0][0] * _e2038.member_1[2][0]) + (_e289.member_1[0][1] * _e2038.member_1[2][1])) + (_e289.member_1[0][2] * _e2038.member_1[2][2]));
                let _e2933 = (((_e289.member_1[1][0] * _e2038.member_1[2][0]) + (_e289.member_1[1][1] * _e2038.member_1[2][1])) + (_e289.member_1[1][2] * _e2038.member_1[2][2]));
                let _e2946 = (((_e289.member_1[2][0] * _e2038.member_1[2][0]) + (_e289.member_1[2][1] * _e2038.member_1[2][1])) + (_e289.member_1[2][2] * _e2038.member_1[2][2]));
                if (_e2920 < 0f) {
                    phi_3749_ = -(_e2920);
                } else {
                    phi_3749_ = _e2920;
                }
                let _e2951 = phi_3749_;
                if (_e2933 < 0f) {
                    phi_3755_ = -(_e2933);
                } else {
                    phi_3755_ = _e2933;
                }
                let _e2955 = phi_3755_;
                if (_e2946 < 0f) {
                    phi_3761_ = -(_e2946);
                } else {
                    phi_3761_ = _e2946;
                }
                let _e2959 = phi_3761_;
                let _e2976 = (_e415.member[0] - _e2495);
                let _e2978 = (_e415.member[1] - _e2497);
                let _e2980 = (_e415.member[2] - _e2499);
                if (_e415.member_2[0] < 0f) {
                    phi_3790_ = -(_e415.member_2[0]);
                } else {
                    phi_3790_ = _e415.member_2[0];
                }
                let _e2986 = phi_3790_;
                if (_e415.member_2[1] < 0f) {
                    phi_3797_ = -(_e415.member_2[1]);
                } else {
                    phi_3797_ = _e415.member_2[1];
                }
                let _e2991 = phi_3797_;
                if (_e415.member_2[2] < 0f) {
                    phi_3805_ = -(_e415.member_2[2]);
                } else {
                    phi_3805_ = _e415.member_2[2];
                }
                let _e2997 = phi_3805_;
                if (_e2976 < 0f) {
                    phi_3814_ = -(_e2976);
                } else {
                    phi_3814_ = _e2976;
                }
                let _e3004 = phi_3814_;
                if (_e2978 < 0f) {
                    phi_3820_ = -(_e2978);
                } else {
                    phi_3820_ = _e2978;
                }
                let _e3008 = phi_3820_;
                if (_e2980 < 0f) {
                    phi_3826_ = -(_e2980);
                } else {
                    phi_3826_ = _e2980;
                }
                let _e3012 = phi_3826_;
                if (_e2038.member_1[0][0] < 0f) {
                    phi_3834_ = -(_e2038.member_1[0][0]);
                } else {
                    phi_3834_ = _e2038.member_1[0][0];
                }
                let _e3018 = phi_3834_;
                if (_e2038.member_1[0][1] < 0f) {
                    phi_3841_ = -(_e2038.member_1[0][1]);
                } else {
                    phi_3841_ = _e2038.member_1[0][1];
                }
                let _e3023 = phi_3841_;
                if (_e2038.member_1[0][2] < 0f) {
                    phi_3848_ = -(_e2038.member_1[0][2]);
                } else {
                    phi_3848_ = _e2038.member_1[0][2];
                }
                let _e3028 = phi_3848_;
                if (_e2038.member_1[1][0] < 0f) {
                    phi_3861_ = -(_e2038.member_1[1][0]);
                } else {
                    phi_3861_ = _e2038.member_1[1][0];
                }
                let _e3039 = phi_3861_;
                if (_e2038.member_1[1][1] < 0f) {
                    phi_3868_ = -(_e2038.member_1[1][1]);
                } else {
                    phi_3868_ = _e2038.member_1[1][1];
                }
                let _e3044 = phi_3868_;
                if (_e2038.member_1[1][2] < 0f) {
                    phi_3875_ = -(_e2038.member_1[1][2]);
                } else {
                    phi_3875_ = _e2038.member_1[1][2];
                }
                let _e3049 = phi_3875_;
                if (_e2038.member_1[2][0] < 0f) {
                    phi_3888_ = -(_e2038.member_1[2][0]);
                } else {
                    phi_3888_ = _e2038.member_1[2][0];
                }
                let _e3060 = phi_3888_;
                if (_e2038.member_1[2][1] < 0f) {
                    phi_3895_ = -(_e2038.member_1[2][1]);
                } else {
                    phi_3895_ = _e2038.member_1[2][1];
                }
                let _e3065 = phi_3895_;
                if (_e2038.member_1[2][2] < 0f) {
                    phi_3902_ = -(_e2038.member_1[2][2]);
                } else {
                    phi_3902_ = _e2038.member_1[2][2];
                }
                let _e3070 = phi_3902_;
                let _e3076 = (0.000000059604645f * 8f);
                let _e3081 = ((((_e2986 + _e2991) + _e2997) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e3093 = (((_e2038.member_1[0][0] * _e2976) + (_e2038.member_1[0][1] * _e2978)) + (_e2038.member_1[0][2] * _e2980));
                let _e3102 = (((_e2038.member_1[1][0] * _e2976) + (_e2038.member_1[1][1] * _e2978)) + (_e2038.member_1[1][2] * _e2980));
                let _e3111 = (((_e2038.member_1[2][0] * _e2976) + (_e2038.member_1[2][1] * _e2978)) + (_e2038.member_1[2][2] * _e2980));
                if (_e3093 < 0f) {
                    phi_3949_ = -(_e3093);
                } else {
                    phi_3949_ = _e3093;
                }
                let _e3115 = phi_3949_;
                if (_e3102 < 0f) {
                    phi_3955_ = -(_e3102);
                } else {
                    phi_3955_ = _e3102;
                }
                let _e3119 = phi_3955_;
                if (_e3111 < 0f) {
                    phi_3961_ = -(_e3111);
                } else {
                    phi_3961_ = _e3111;
                }
                let _e3123 = phi_3961_;
                let _e3137 = (((_e415.member_1[0][0] * _e2038.member_1[0][0]) + (_e415.member_1[0][1] * _e2038.member_1[0][1])) + (_e415.member_1[0][2] * _e2038.member_1[0][2]));
                let _e3150 = (((_e415.member_1[1][0] * _e2038.member_1[0][0]) + (_e415.member_1[1][1] * _e2038.member_1[0][1])) + (_e415.member_1[1][2] * _e2038.member_1[0][2]));
                let _e3163 = (((_e415.member_1[2][0] * _e2038.member_1[0][0]) + (_e415.member_1[2][1] * _e2038.member_1[0][1])) + (_e415.member_1[2][2] * _e2038.member_1[0][2]));
                if (_e3137 < 0f) {
                    phi_4005_ = -(_e3137);
                } else {
                    phi_4005_ = _e3137;
                }
                let _e3168 = phi_4005_;
                if (_e3150 < 0f) {
                    phi_4011_ = -(_e3150);
                } else {
                    phi_4011_ = _e3150;
                }
                let _e3172 = phi_4011_;
                if (_e3163 < 0f) {
                    phi_4017_ = -(_e3163);
                } else {
                    phi_4017_ = _e3163;
                }
                let _e3176 = phi_4017_;
                let _e3198 = (((_e415.member_1[0][0] * _e2038.member_1[1][0]) + (_e415.member_1[0][1] * _e2038.member_1[1][1])) + (_e415.member_1[0][2] * _e2038.member_1[1][2]));
                let _e3211 = (((_e415.member_1[1][0] * _e2038.member_1[1][0]) + (_e415.member_1[1][1] * _e2038.member_1[1][1])) + (_e415.member_1[1][2] * _e2038.member_1[1][2]));
                let _e3224 = (((_e415.member_1[2][0] * _e2038.member_1[1][0]) + (_e415.member_1[2][1] * _e2038.member_1[1][1])) + (_e415.member_1[2][2] * _e2038.member_1[1][2]));
                if (_e3198 < 0f) {
                    phi_4069_ = -(_e3198);
                } else {
                    phi_4069_ = _e3198;
                }
                let _e3229 = phi_4069_;
                if (_e3211 < 0f) {
                    phi_4075_ = -(_e3211);
                } else {
                    phi_4075_ = _e3211;
                }
                let _e3233 = phi_4075_;
                if (_e3224 < 0f) {
                    phi_4081_ = -(_e3224);
                } else {
                    phi_4081_ = _e3224;
                }
                let _e3237 = phi_4081_;
                let _e3259 = (((_e415.member_1[0][0] * _e2038.member_1[2][0]) + (_e415.member_1[0][1] * _e2038.member_1[2][1])) + (_e415.member_1[0][2] * _e2038.member_1[2][2]));
                let _e3272 = (((_e415.member_1[1][0] * _e2038.member_1[2][0]) + (_e415.member_1[1][1] * _e2038.member_1[2][1])) + (_e415.member_1[1][2] * _e2038.member_1[2][2]));
                let _e3285 = (((_e415.member_1[2][0] * _e2038.member_1[2][0]) + (_e415.member_1[2][1] * _e2038.member_1[2][1])) + (_e415.member_1[2][2] * _e2038.member_1[2][2]));
                if (_e3259 < 0f) {
                    phi_4133_ = -(_e3259);
                } else {
                    phi_4133_ = _e3259;
                }
                let _e3290 = phi_4133_;
                if (_e3272 < 0f) {
                    phi_4139_ = -(_e3272);
                } else {
                    phi_4139_ = _e3272;
                }
                let _e3294 = phi_4139_;
                if (_e3285 < 0f) {
                    phi_4145_ = -(_e3285);
                } else {
                    phi_4145_ = _e3285;
                }
                let _e3298 = phi_4145_;
                let _e3313 = (((_e2776 + (((_e2829 * _e289.member_2[0]) + (_e2833 * _e289.member_2[1])) + (_e2837 * _e289.member_2[2]))) + (((((_e2679 * _e2665) + (_e2684 * _e2669)) + (_e2689 * _e2673)) * _e2737) + _e2742)) + _e2632);
                let _e3314 = (((_e2780 + (((_e2890 * _e289.member_2[0]) + (_e2894 * _e289.member_2[1])) + (_e2898 * _e289.member_2[2]))) + (((((_e2700 * _e2665) + (_e2705 * _e2669)) + (_e2710 * _e2673)) * _e2737) + _e2742)) + _e2633);
                let _e3315 = (((_e2784 + (((_e2951 * _e289.member_2[0]) + (_e2955 * _e289.member_2[1])) + (_e2959 * _e289.member_2[2]))) + (((((_e2721 * _e2665) + (_e2726 * _e2669)) + (_e2731 * _e2673)) * _e2737) + _e2742)) + _e2634);
                let _e3316 = (((_e3115 + (((_e3168 * _e415.member_2[0]) + (_e3172 * _e415.member_2[1])) + (_e3176 * _e415.member_2[2]))) + (((((_e3018 * _e3004) + (_e3023 * _e3008)) + (_e3028 * _e3012)) * _e3076) + _e3081)) + _e2632);
                let _e3317 = (((_e3119 + (((_e3229 * _e415.member_2[0]) + (_e3233 * _e415.member_2[1])) + (_e3237 * _e415.member_2[2]))) + (((((_e3039 * _e3004) + (_e3044 * _e3008)) + (_e3049 * _e3012)) * _e3076) + _e3081)) + _e2633);
                let _e3318 = (((_e3123 + (((_e3290 * _e415.member_2[0]) + (_e3294 * _e415.member_2[1])) + (_e3298 * _e415.member_2[2]))) + (((((_e3060 * _e3004) + (_e3065 * _e3008)) + (_e3070 * _e3012)) * _e3076) + _e3081)) + _e2634);
                if ((bitcast<u32>(_e3313) & 2139095040u) != 2139095040u) {
                    if ((bitcast<u32>(_e3314) & 2139095040u) != 2139095040u) {
                        phi_4181_ = ((bitcast<u32>(_e3315) & 2139095040u) != 2139095040u);
                        phi_4182_ = false;
                    } else {
                        phi_4181_ = bool();
                        phi_4182_ = true;
                    }
                    let _e3329 = phi_4181_;
                    let _e3331 = phi_4182_;
                    phi_4183_ = _e3329;
                    phi_4184_ = _e3331;
                } else {
                    phi_4183_ = bool();
                    phi_4184_ = true;
                }
                let _e3333 = phi_4183_;
                let _e3335 = phi_4184_;
                if _e3335 {
                    phi_4188_ = false;
                } else {
                    phi_4188_ = _e3333;
                }
                let _e3337 = phi_4188_;
                if _e3337 {
                    if ((bitcast<u32>(_e3316) & 2139095040u) != 2139095040u) {
                        if ((bitcast<u32>(_e3317) & 2139095040u) != 2139095040u) {
                            phi_4207_ = ((bitcast<u32>(_e3318) & 2139095040u) != 2139095040u);
                            phi_4208_ = false;
                        } else {
                            phi_4207_ = bool();
                            phi_4208_ = true;
                        }
                        let _e3348 = phi_4207_;
                        let _e3350 = phi_4208_;
                        phi_4209_ = _e3348;
                        phi_4210_ = _e3350;
                    } else {
                        phi_4209_ = bool();
                        phi_4210_ = true;
                    }
                    let _e3352 = phi_4209_;
                    let _e3354 = phi_4210_;
                    if _e3354 {
                        phi_4214_ = false;
                    } else {
                        phi_4214_ = _e3352;
                    }
                    let _e3356 = phi_4214_;
                    if _e3356 {
                        if (_e3313 > _e3316) {
                            phi_4222_ = _e3313;
                        } else {
                            phi_4222_ = _e3316;
                        }
                        let _e3359 = phi_4222_;
                        if (_e3314 > _e3317) {
                            phi_4227_ = _e3314;
                        } else {
                            phi_4227_ = _e3317;
                        }
                        let _e3362 = phi_4227_;
                        if (_e3315 > _e3318) {
                            phi_4232_ = _e3315;
                        } else {
                            phi_4232_ = _e3318;
                        }
                        let _e3365 = phi_4232_;
                        phi_4235_ = type_34(array<f32, 3>(_e2495, _e2497, _e2499), _e2038.member_1, array<f32, 3>(_e3359, _e3362, _e3365));
                        phi_4236_ = false;
                    } else {
                        phi_4235_ = type_34();
                        phi_4236_ = true;
                    }
                    let _e3369 = phi_4235_;
                    let _e3371 = phi_4236_;
                    phi_4237_ = _e3369;
                    phi_4238_ = _e3371;
                } else {
                    phi_4237_ = type_34();
                    phi_4238_ = true;
                }
                let _e3373 = phi_4237_;
                let _e3375 = phi_4238_;
                if _e3375 {
                    if true {
                        phi_4252_ = 2122317824u;
                    } else {
                        phi_4252_ = 8388608u;
                    }
                    let _e3377 = phi_4252_;
                    let _e3379 = (bitcast<f32>(_e3377) * 3.9999998f);
                    phi_4262_ = type_34(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3379, _e3379, _e3379));
                } else {
                    phi_4262_ = _e3373;
                }
                let _e3383 = phi_4262_;
                boxes[_e64] = type_34(array<f32, 3>(_e3383.member[0], _e3383.member[1], _e3383.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e3383.member_1[0][0], _e3383.member_1[0][1], _e3383.member_1[0][2]), array<f32, 3>(_e3383.member_1[1][0], _e3383.member_1[1][1], _e3383.member_1[1][2]), array<f32, 3>(_e3383.member_1[2][0], _e3383.member_1[2][1], _e3383.member_1[2][2])), array<f32, 3>(_e3383.member_2[0], _e3383.member_2[1], _e3383.member_2[2]));
                let _e3419 = atomicOr((&done[(_e64 / 32u)]), (1u << bitcast<u32>(((_e64 % 32u) & 31u))));
                phi_4298_ = 2u;
            }
            let _e3421 = phi_4298_;
            workgroupBarrier();
            phi_206_ = _e3421;
        } else {
            phi_206_ = u32();
        }
        let _e3423 = phi_206_;
        continue;
        continuing {
            phi_202_ = _e125;
            phi_205_ = _e3423;
            break if !(_e130);
        }
    }
    let _e3426 = local_9;
    if (_e3426 == 1u) {
        phi_4307_ = true;
    } else {
        let _e3429 = local_10;
        phi_4307_ = (_e3429 == 3u);
    }
    let _e3432 = phi_4307_;
    if _e3432 {
        let _e3434 = atomicAdd((&counters[0u]), 1u);
        phi_4313_ = _e3434;
    } else {
        phi_4313_ = 0u;
    }
    let _e3436 = phi_4313_;
    workgroupBarrier();
    if (_e64 == 0u) {
        let _e3439 = atomicLoad((&counters[0u]));
        if (_e3439 > 0u) {
            let _e3442 = atomicAdd((&far.member[0u]), _e3439);
            atomicStore((&counters[1u]), _e3442);
        }
    }
    workgroupBarrier();
    let _e3447 = params.member.member.member_2[_e80];
    let _e3448 = (_e3447 + _e77);
    let _e3450 = local_11;
    if (_e3450 == 2u) {
        let _e3469 = boxes[_e64];
        oriented.member[_e3448] = type_31(vec4<f32>(_e3469.member[0], _e3469.member[1], _e3469.member[2], _e3469.member_1[0][0]), vec4<f32>(_e3469.member_1[0][1], _e3469.member_1[0][2], _e3469.member_1[1][0], _e3469.member_1[1][1]), vec4<f32>(_e3469.member_1[1][2], _e3469.member_1[2][0], _e3469.member_1[2][1], _e3469.member_1[2][2]), vec4<f32>(_e3469.member_2[0], _e3469.member_2[1], _e3469.member_2[2], 0f));
        stamps.member[_e3448] = 1u;
    } else {
        let _e3453 = local_12;
        if (_e3453 != 0u) {
            if true {
                phi_4415_ = 2122317824u;
            } else {
                phi_4415_ = 8388608u;
            }
            let _e3456 = phi_4415_;
            let _e3458 = (bitcast<f32>(_e3456) * 3.9999998f);
            oriented.member[_e3448] = type_31(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(_e3458, _e3458, _e3458, 0f));
            stamps.member[_e3448] = 0u;
            let _e3464 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e3464 + _e3436))]), _e77);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn orient_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
