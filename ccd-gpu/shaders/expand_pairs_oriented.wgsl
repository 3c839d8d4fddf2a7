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

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
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

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_24 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_26 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(6) 
var<storage, read_write> output: type_32;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(3) 
var<storage> oriented: type_28;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(5) 
var<storage, read_write> levels: type_32;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_32;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var local_1: array<array<u32, 2>, 4>;
    var phi_146_: array<u32, 2>;
    var phi_188_: u32;
    var phi_206_: u32;
    var phi_226_: u32;
    var phi_229_: type_12;
    var phi_230_: type_12;
    var phi_253_: type_12;
    var phi_361_: array<u32, 2>;
    var phi_375_: array<u32, 2>;
    var phi_412_: array<u32, 2>;
    var phi_414_: type_22;
    var phi_415_: type_22;
    var phi_416_: bool;
    var phi_417_: type_22;
    var phi_418_: bool;
    var phi_434_: bool;
    var phi_478_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_589_: array<u32, 2>;
    var phi_618_: array<u32, 2>;
    var phi_647_: array<u32, 2>;
    var phi_676_: array<u32, 2>;
    var phi_678_: type_22;
    var phi_679_: bool;
    var phi_680_: type_22;
    var phi_681_: bool;
    var phi_854_: array<u32, 2>;
    var phi_886_: array<u32, 2>;
    var phi_754_: array<u32, 2>;
    var phi_786_: array<u32, 2>;
    var phi_888_: type_22;
    var phi_889_: type_22;
    var phi_890_: type_22;
    var phi_891_: bool;
    var phi_892_: type_22;
    var phi_893_: type_22;
    var phi_894_: bool;
    var phi_898_: type_22;
    var phi_920_: type_12;
    var phi_921_: type_12;
    var phi_944_: type_12;
    var phi_973_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_1059_: f32;
    var phi_1065_: f32;
    var phi_1071_: f32;
    var phi_1077_: f32;
    var phi_1083_: f32;
    var phi_1089_: f32;
    var phi_1107_: f32;
    var phi_1112_: f32;
    var phi_1117_: f32;
    var phi_1133_: type_29;
    var phi_1203_: f32;
    var phi_1209_: f32;
    var phi_1215_: f32;
    var phi_1221_: f32;
    var phi_1227_: f32;
    var phi_1233_: f32;
    var phi_1251_: f32;
    var phi_1256_: f32;
    var phi_1261_: f32;
    var phi_1277_: type_29;
    var phi_1467_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1489_: f32;
    var phi_1496_: f32;
    var phi_1504_: f32;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1528_: f32;
    var phi_1621_: f32;
    var phi_1628_: f32;
    var phi_1634_: f32;
    var phi_1640_: f32;
    var phi_1659_: f32;
    var phi_1666_: f32;
    var phi_1672_: f32;
    var phi_1678_: f32;
    var phi_1697_: f32;
    var phi_1704_: f32;
    var phi_1710_: f32;
    var phi_1716_: f32;
    var phi_1735_: f32;
    var phi_1742_: f32;
    var phi_1748_: f32;
    var phi_1754_: f32;
    var phi_1773_: f32;
    var phi_1780_: f32;
    var phi_1786_: f32;
    var phi_1792_: f32;
    var phi_1811_: f32;
    var phi_1818_: f32;
    var phi_1824_: f32;
    var phi_1830_: f32;
    var phi_1845_: f32;
    var phi_1850_: f32;
    var phi_1855_: f32;
    var phi_1860_: f32;
    var phi_1865_: f32;
    var phi_1924_: f32;
    var phi_1947_: f32;
    var phi_1970_: f32;
    var phi_1992_: f32;
    var phi_2008_: f32;
    var phi_2063_: f32;
    var phi_2086_: f32;
    var phi_2109_: f32;
    var phi_2131_: f32;
    var phi_2147_: f32;
    var phi_2202_: f32;
    var phi_2225_: f32;
    var phi_2248_: f32;
    var phi_2270_: f32;
    var phi_2286_: f32;
    var phi_2341_: f32;
    var phi_2364_: f32;
    var phi_2388_: f32;
    var phi_2411_: f32;
    var phi_2427_: f32;
    var phi_2482_: f32;
    var phi_2505_: f32;
    var phi_2529_: f32;
    var phi_2552_: f32;
    var phi_2568_: f32;
    var phi_2623_: f32;
    var phi_2646_: f32;
    var phi_2670_: f32;
    var phi_2693_: f32;
    var phi_2709_: f32;
    var phi_2764_: f32;
    var phi_2787_: f32;
    var phi_2811_: f32;
    var phi_2834_: f32;
    var phi_2850_: f32;
    var phi_2905_: f32;
    var phi_2928_: f32;
    var phi_2952_: f32;
    var phi_2975_: f32;
    var phi_2991_: f32;
    var phi_3046_: f32;
    var phi_3069_: f32;
    var phi_3093_: f32;
    var phi_3116_: f32;
    var phi_3132_: f32;
    var phi_3139_: f32;
    var phi_3144_: f32;
    var phi_3149_: f32;
    var phi_3154_: f32;
    var phi_3159_: f32;
    var phi_3164_: f32;
    var phi_3169_: f32;
    var phi_3174_: f32;
    var phi_3178_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3187_: bool;
    var phi_3231_: bool;
    var phi_3232_: bool;
    var phi_3236_: u32;
    var phi_3237_: u32;
    var phi_3243_: array<u32, 2>;
    var phi_3244_: array<u32, 2>;
    var phi_3245_: array<u32, 2>;
    var phi_3246_: array<u32, 2>;
    var phi_3247_: array<u32, 2>;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3268_: u32;
    var phi_3269_: u32;
    var phi_3278_: u32;
    var phi_3281_: u32;
    var phi_3297_: bool;
    var phi_3298_: bool;
    var phi_3302_: u32;
    var phi_3303_: u32;
    var phi_3312_: u32;
    var phi_3315_: u32;
    var phi_3331_: bool;
    var phi_3332_: bool;
    var phi_3336_: u32;
    var phi_3337_: u32;
    var phi_3346_: u32;
    var phi_3349_: u32;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3370_: u32;
    var phi_3371_: u32;
    var phi_3380_: u32;
    var phi_3383_: u32;
    var phi_3449_: bool;
    var phi_3450_: bool;
    var phi_3454_: u32;
    var phi_3455_: u32;
    var phi_3518_: type_12;
    var phi_3523_: type_12;
    var phi_3556_: bool;
    var phi_3557_: bool;
    var phi_3561_: u32;
    var phi_3562_: u32;
    var phi_3625_: type_12;
    var phi_3630_: type_12;
    var phi_3663_: bool;
    var phi_3664_: bool;
    var phi_3668_: u32;
    var phi_3669_: u32;
    var phi_3732_: type_12;
    var phi_3737_: type_12;
    var phi_3770_: bool;
    var phi_3771_: bool;
    var phi_3775_: u32;
    var phi_3776_: u32;
    var phi_3839_: type_12;
    var phi_3844_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e62 = (_e45.x * _e45.y);
    let _e65 = params.member.member_2.member;
    let _e68 = params.member.member_1.member_1;
    if (_e65 == 0u) {
        phi_146_ = array<u32, 2>(0u, 2u);
    } else {
        phi_146_ = array<u32, 2>(1u, 1u);
    }
    let _e71 = phi_146_;
    let _e77 = params.member.member.member[_e71[0]];
    let _e78 = (_e77 - 1u);
    let _e82 = params.member.member.member[_e71[1]];
    let _e83 = (_e82 - 1u);
    let _e87 = params.member.member.member_2[_e71[0]];
    let _e91 = params.member.member.member_2[_e71[1]];
    let _e94 = params.member.member_2.member_1;
    if (_e94 == 0u) {
        phi_188_ = 1u;
    } else {
        phi_188_ = 0u;
    }
    let _e97 = phi_188_;
    let _e99 = atomicLoad((&levels.member[_e68]));
    let _e102 = params.member.member_1.member_2;
    if (_e102 < _e99) {
        phi_206_ = _e102;
    } else {
        phi_206_ = _e99;
    }
    let _e105 = phi_206_;
    let _e108 = params.member.member_1.member_2;
    let _e109 = (_e62 * 128u);
    if (_e109 == 0u) {
        return;
    }
    let _e111 = (_e108 / _e109);
    if (_e109 == 0u) {
        return;
    }
    if ((_e108 % _e109) > 0u) {
        phi_226_ = (_e111 + 1u);
    } else {
        phi_226_ = _e111;
    }
    let _e117 = phi_226_;
    phi_229_ = type_12(0u, _e117);
    loop {
        let _e120 = phi_229_;
        if (_e120.member < _e120.member_1) {
            phi_230_ = type_12((_e120.member + 1u), _e120.member_1);
            phi_253_ = type_12(1u, _e120.member);
        } else {
            phi_230_ = _e120;
            phi_253_ = type_12(0u, type_12().member_1);
        }
        let _e132 = phi_230_;
        let _e134 = phi_253_;
        let _e138 = (bitcast<i32>(_e134.member) != 0i);
        if _e138 {
            let _e142 = (((((_e44.y * _e45.x) + _e44.x) + (_e134.member_1 * _e62)) * 128u) + _e46);
            if (_e46 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e142 < _e105) {
                let _e147 = (2u * _e142);
                let _e150 = input.member[(4u + _e147)];
                let _e153 = input.member[(_e147 + 5u)];
                let _e156 = a_nodes.member[_e150];
                let _e158 = b_nodes.member[_e153];
                if (_e65 == 1u) {
                    if (_e150 == _e153) {
                        if (_e156.member_3 == 4294967295u) {
                            phi_414_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e164 = a_nodes.member[_e156.member_1];
                            let _e167 = a_nodes.member[_e156.member_3];
                            if !((_e164.member_3 == 4294967295u)) {
                                phi_361_ = array<u32, 2>(_e156.member_1, _e156.member_1);
                            } else {
                                phi_361_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e174 = phi_361_;
                            let _e181 = type_22(array<array<u32, 2>, 4>(_e174, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e193 = type_22(array<array<u32, 2>, 4>(_e181.member[0], array<u32, 2>(_e156.member_1, _e181.member[1][1]), _e181.member[2], _e181.member[3]), _e181.member_1);
                            let _e194 = array<u32, 2>(_e156.member_1, _e156.member_3);
                            let _e201 = type_22(array<array<u32, 2>, 4>(_e193.member[0], _e194, _e193.member[2], _e193.member[3]), _e193.member_1);
                            if !((_e167.member_3 == 4294967295u)) {
                                phi_375_ = array<u32, 2>(_e156.member_3, _e156.member_3);
                            } else {
                                phi_375_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e208 = phi_375_;
                            let _e215 = type_22(array<array<u32, 2>, 4>(_e201.member[0], _e201.member[1], _e208, _e201.member[3]), _e201.member_1);
                            let _e218 = type_22(_e215.member, _e215.member);
                            if ((((((_e164.member[0] <= _e167.member_2[0]) && (_e167.member[0] <= _e164.member_2[0])) && (_e164.member[1] <= _e167.member_2[1])) && (_e167.member[1] <= _e164.member_2[1])) && (_e164.member[2] <= _e167.member_2[2])) && (_e167.member[2] <= _e164.member_2[2])) {
                                phi_412_ = _e194;
                            } else {
                                phi_412_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e247 = phi_412_;
                            phi_414_ = type_22(_e218.member, array<array<u32, 2>, 4>(_e218.member_1[0], _e247, _e218.member_1[2], _e218.member_1[3]));
                        }
                        let _e256 = phi_414_;
                        phi_415_ = _e256;
                        phi_416_ = false;
                    } else {
                        phi_415_ = type_22();
                        phi_416_ = true;
                    }
                    let _e258 = phi_415_;
                    let _e260 = phi_416_;
                    phi_417_ = _e258;
                    phi_418_ = _e260;
                } else {
                    phi_417_ = type_22();
                    phi_418_ = true;
                }
                let _e262 = phi_417_;
                let _e264 = phi_418_;
                if _e264 {
                    let _e267 = !((_e156.member_3 == 4294967295u));
                    let _e270 = !((_e158.member_3 == 4294967295u));
                    if _e267 {
                        phi_434_ = true;
                    } else {
                        phi_434_ = _e270;
                    }
                    let _e272 = phi_434_;
                    if _e272 {
                        if _e267 {
                            if _e270 {
                                if (_e97 == 0u) {
                                    let _e300 = ((((_e158.member_2[0] - _e158.member[0]) * (_e158.member_2[1] - _e158.member[1])) * (_e158.member_2[2] - _e158.member[2])) > (((_e156.member_2[0] - _e156.member[0]) * (_e156.member_2[1] - _e156.member[1])) * (_e156.member_2[2] - _e156.member[2])));
                                    phi_478_ = _e300;
                                    phi_479_ = !(_e300);
                                } else {
                                    phi_478_ = _e270;
                                    phi_479_ = _e267;
                                }
                                let _e303 = phi_478_;
                                let _e305 = phi_479_;
                                phi_480_ = _e303;
                                phi_481_ = _e305;
                            } else {
                                phi_480_ = _e270;
                                phi_481_ = _e267;
                            }
                            let _e307 = phi_480_;
                            let _e309 = phi_481_;
                            phi_482_ = _e307;
                            phi_483_ = _e309;
                        } else {
                            phi_482_ = _e270;
                            phi_483_ = _e267;
                        }
                        let _e311 = phi_482_;
                        let _e313 = phi_483_;
                        if _e313 {
                            if _e311 {
                                let _e316 = a_nodes.member[_e156.member_1];
                                let _e321 = a_nodes.member[_e156.member_3];
                                let _e326 = b_nodes.member[_e158.member_1];
                                let _e331 = b_nodes.member[_e158.member_3];
                                let _e336 = array<u32, 2>(_e156.member_1, _e158.member_1);
                                let _e339 = array<u32, 2>(_e156.member_1, _e158.member_3);
                                let _e342 = array<u32, 2>(_e156.member_3, _e158.member_1);
                                let _e345 = array<u32, 2>(_e156.member_3, _e158.member_3);
                                if ((((((_e316.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e316.member_2[2])) {
                                    phi_589_ = _e336;
                                } else {
                                    phi_589_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e371 = phi_589_;
                                if ((((((_e316.member[0] <= _e331.member_2[0]) && (_e331.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e331.member_2[1])) && (_e331.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e331.member_2[2])) && (_e331.member[2] <= _e316.member_2[2])) {
                                    phi_618_ = _e339;
                                } else {
                                    phi_618_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e396 = phi_618_;
                                if ((((((_e321.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e321.member_2[0])) && (_e321.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e321.member_2[1])) && (_e321.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e321.member_2[2])) {
                                    phi_647_ = _e342;
                                } else {
                                    phi_647_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e421 = phi_647_;
                                if ((((((_e321.member[0] <= _e331.member_2[0]) && (_e331.member[0] <= _e321.member_2[0])) && (_e321.member[1] <= _e331.member_2[1])) && (_e331.member[1] <= _e321.member_2[1])) && (_e321.member[2] <= _e331.member_2[2])) && (_e331.member[2] <= _e321.member_2[2])) {
                                    phi_676_ = _e345;
                                } else {
                                    phi_676_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e446 = phi_676_;
                                phi_678_ = type_22(array<array<u32, 2>, 4>(_e336, _e339, _e342, _e345), array<array<u32, 2>, 4>(_e371, _e396, _e421, _e446));
                                phi_679_ = false;
                            } else {
                                phi_678_ = type_22();
                                phi_679_ = true;
                            }
                            let _e450 = phi_678_;
                            let _e452 = phi_679_;
                            phi_680_ = _e450;
                            phi_681_ = _e452;
                        } else {
                            phi_680_ = type_22();
                            phi_681_ = true;
                        }
                        let _e454 = phi_680_;
                        let _e456 = phi_681_;
                        if _e456 {
                            if _e313 {
                                let _e555 = a_nodes.member[_e156.member_1];
                                let _e560 = a_nodes.member[_e156.member_3];
                                let _e564 = array<u32, 2>(_e156.member_1, _e153);
                                let _e566 = array<u32, 2>(_e156.member_3, _e153);
                                let _e573 = type_22(array<array<u32, 2>, 4>(_e564, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e580 = type_22(array<array<u32, 2>, 4>(_e573.member[0], _e566, _e573.member[2], _e573.member[3]), _e573.member_1);
                                if ((((((_e555.member[0] <= _e158.member_2[0]) && (_e158.member[0] <= _e555.member_2[0])) && (_e555.member[1] <= _e158.member_2[1])) && (_e158.member[1] <= _e555.member_2[1])) && (_e555.member[2] <= _e158.member_2[2])) && (_e158.member[2] <= _e555.member_2[2])) {
                                    phi_754_ = _e564;
                                } else {
                                    phi_754_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e607 = phi_754_;
                                let _e614 = type_22(_e580.member, array<array<u32, 2>, 4>(_e607, _e580.member_1[1], _e580.member_1[2], _e580.member_1[3]));
                                if ((((((_e560.member[0] <= _e158.member_2[0]) && (_e158.member[0] <= _e560.member_2[0])) && (_e560.member[1] <= _e158.member_2[1])) && (_e158.member[1] <= _e560.member_2[1])) && (_e560.member[2] <= _e158.member_2[2])) && (_e158.member[2] <= _e560.member_2[2])) {
                                    phi_786_ = _e566;
                                } else {
                                    phi_786_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e641 = phi_786_;
                                phi_888_ = type_22(_e614.member, array<array<u32, 2>, 4>(_e614.member_1[0], _e641, _e614.member_1[2], _e614.member_1[3]));
                            } else {
                                let _e459 = b_nodes.member[_e158.member_1];
                                let _e464 = b_nodes.member[_e158.member_3];
                                let _e468 = array<u32, 2>(_e150, _e158.member_1);
                                let _e470 = array<u32, 2>(_e150, _e158.member_3);
                                let _e477 = type_22(array<array<u32, 2>, 4>(_e468, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e484 = type_22(array<array<u32, 2>, 4>(_e477.member[0], _e470, _e477.member[2], _e477.member[3]), _e477.member_1);
                                if ((((((_e156.member[0] <= _e459.member_2[0]) && (_e459.member[0] <= _e156.member_2[0])) && (_e156.member[1] <= _e459.member_2[1])) && (_e459.member[1] <= _e156.member_2[1])) && (_e156.member[2] <= _e459.member_2[2])) && (_e459.member[2] <= _e156.member_2[2])) {
                                    phi_854_ = _e468;
                                } else {
                                    phi_854_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e511 = phi_854_;
                                let _e518 = type_22(_e484.member, array<array<u32, 2>, 4>(_e511, _e484.member_1[1], _e484.member_1[2], _e484.member_1[3]));
                                if ((((((_e156.member[0] <= _e464.member_2[0]) && (_e464.member[0] <= _e156.member_2[0])) && (_e156.member[1] <= _e464.member_2[1])) && (_e464.member[1] <= _e156.member_2[1])) && (_e156.member[2] <= _e464.member_2[2])) && (_e464.member[2] <= _e156.member_2[2])) {
                                    phi_886_ = _e470;
                                } else {
                                    phi_886_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e545 = phi_886_;
                                phi_888_ = type_22(_e518.member, array<array<u32, 2>, 4>(_e518.member_1[0], _e545, _e518.member_1[2], _e518.member_1[3]));
                            }
                            let _e650 = phi_888_;
                            phi_889_ = _e650;
                        } else {
                            phi_889_ = _e454;
                        }
                        let _e652 = phi_889_;
                        phi_890_ = _e652;
                        phi_891_ = false;
                    } else {
                        phi_890_ = type_22();
                        phi_891_ = true;
                    }
                    let _e654 = phi_890_;
                    let _e656 = phi_891_;
                    phi_892_ = _e654;
                    phi_893_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_894_ = _e656;
                } else {
                    phi_892_ = type_22();
                    phi_893_ = _e262;
                    phi_894_ = true;
                }
                let _e658 = phi_892_;
                let _e660 = phi_893_;
                let _e662 = phi_894_;
                if _e662 {
                    phi_898_ = _e660;
                } else {
                    phi_898_ = _e658;
                }
                let _e664 = phi_898_;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e664.member_1[0][0], _e664.member_1[0][1]), array<u32, 2>(_e664.member_1[1][0], _e664.member_1[1][1]), array<u32, 2>(_e664.member_1[2][0], _e664.member_1[2][1]), array<u32, 2>(_e664.member_1[3][0], _e664.member_1[3][1]));
                phi_920_ = type_12(0u, 4u);
                loop {
                    let _e685 = phi_920_;
                    if (_e685.member < _e685.member_1) {
                        phi_921_ = type_12((_e685.member + 1u), _e685.member_1);
                        phi_944_ = type_12(1u, _e685.member);
                    } else {
                        phi_921_ = _e685;
                        phi_944_ = type_12(0u, type_12().member_1);
                    }
                    let _e697 = phi_921_;
                    let _e699 = phi_944_;
                    let _e703 = (bitcast<i32>(_e699.member) != 0i);
                    if _e703 {
                        let _e705 = local_1[_e699.member_1];
                        if (_e705[0] != 4294967295u) {
                            if (_e65 == 1u) {
                                phi_973_ = (_e705[0] == _e705[1]);
                            } else {
                                phi_973_ = false;
                            }
                            let _e711 = phi_973_;
                            if _e711 {
                                phi_3182_ = bool();
                                phi_3183_ = true;
                            } else {
                                if (_e705[0] >= _e78) {
                                    if (_e705[1] >= _e83) {
                                        phi_985_ = false;
                                    } else {
                                        phi_985_ = true;
                                    }
                                    let _e715 = phi_985_;
                                    phi_986_ = _e715;
                                } else {
                                    phi_986_ = true;
                                }
                                let _e717 = phi_986_;
                                if _e717 {
                                    if (_e705[0] < _e78) {
                                        let _e797 = oriented.member[(_e87 + _e705[0])];
                                        phi_1133_ = type_29(array<f32, 3>(_e797.member.x, _e797.member.y, _e797.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e797.member.w, _e797.member_1.x, _e797.member_1.y), array<f32, 3>(_e797.member_1.z, _e797.member_1.w, _e797.member_2.x), array<f32, 3>(_e797.member_2.y, _e797.member_2.z, _e797.member_2.w)), array<f32, 3>(_e797.member_3.x, _e797.member_3.y, _e797.member_3.z));
                                    } else {
                                        let _e720 = a_nodes.member[_e705[0]];
                                        let _e735 = ((_e720.member[0] * 0.5f) + (_e720.member_2[0] * 0.5f));
                                        let _e736 = ((_e720.member[1] * 0.5f) + (_e720.member_2[1] * 0.5f));
                                        let _e737 = ((_e720.member[2] * 0.5f) + (_e720.member_2[2] * 0.5f));
                                        if (_e735 < _e720.member_2[0]) {
                                            phi_1059_ = _e735;
                                        } else {
                                            phi_1059_ = _e720.member_2[0];
                                        }
                                        let _e741 = phi_1059_;
                                        if (_e736 < _e720.member_2[1]) {
                                            phi_1065_ = _e736;
                                        } else {
                                            phi_1065_ = _e720.member_2[1];
                                        }
                                        let _e745 = phi_1065_;
                                        if (_e737 < _e720.member_2[2]) {
                                            phi_1071_ = _e737;
                                        } else {
                                            phi_1071_ = _e720.member_2[2];
                                        }
                                        let _e749 = phi_1071_;
                                        if (_e741 > _e720.member[0]) {
                                            phi_1077_ = _e741;
                                        } else {
                                            phi_1077_ = _e720.member[0];
                                        }
                                        let _e753 = phi_1077_;
                                        if (_e745 > _e720.member[1]) {
                                            phi_1083_ = _e745;
                                        } else {
                                            phi_1083_ = _e720.member[1];
                                        }
                                        let _e757 = phi_1083_;
                                        if (_e749 > _e720.member[2]) {
                                            phi_1089_ = _e749;
                                        } else {
                                            phi_1089_ = _e720.member[2];
                                        }
                                        let _e761 = phi_1089_;
                                        let _e764 = (_e720.member_2[0] - _e753);
                                        let _e766 = (_e720.member_2[1] - _e757);
                                        let _e768 = (_e720.member_2[2] - _e761);
                                        let _e770 = (_e753 - _e720.member[0]);
                                        let _e772 = (_e757 - _e720.member[1]);
                                        let _e774 = (_e761 - _e720.member[2]);
                                        if (_e764 > _e770) {
                                            phi_1107_ = _e764;
                                        } else {
                                            phi_1107_ = _e770;
                                        }
                                        let _e777 = phi_1107_;
                                        if (_e766 > _e772) {
                                            phi_1112_ = _e766;
                                        } else {
                                            phi_1112_ = _e772;
                                        }
                                        let _e780 = phi_1112_;
                                        if (_e768 > _e774) {
                                            phi_1117_ = _e768;
                                        } else {
                                            phi_1117_ = _e774;
                                        }
                                        let _e783 = phi_1117_;
                                        let _e785 = (1f + (0.000000059604645f * 4f));
                                        let _e789 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1133_ = type_29(array<f32, 3>(_e753, _e757, _e761), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e777 * _e785) + _e789), ((_e780 * _e785) + _e789), ((_e783 * _e785) + _e789)));
                                    }
                                    let _e836 = phi_1133_;
                                    if (_e705[1] < _e83) {
                                        let _e916 = oriented.member[(_e91 + _e705[1])];
                                        phi_1277_ = type_29(array<f32, 3>(_e916.member.x, _e916.member.y, _e916.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e916.member.w, _e916.member_1.x, _e916.member_1.y), array<f32, 3>(_e916.member_1.z, _e916.member_1.w, _e916.member_2.x), array<f32, 3>(_e916.member_2.y, _e916.member_2.z, _e916.member_2.w)), array<f32, 3>(_e916.member_3.x, _e916.member_3.y, _e916.member_3.z));
                                    } else {
                                        let _e839 = b_nodes.member[_e705[1]];
                                        let _e854 = ((_e839.member[0] * 0.5f) + (_e839.member_2[0] * 0.5f));
                                        let _e855 = ((_e839.member[1] * 0.5f) + (_e839.member_2[1] * 0.5f));
                                        let _e856 = ((_e839.member[2] * 0.5f) + (_e839.member_2[2] * 0.5f));
                                        if (_e854 < _e839.member_2[0]) {
                                            phi_1203_ = _e854;
                                        } else {
                                            phi_1203_ = _e839.member_2[0];
                                        }
                                        let _e860 = phi_1203_;
                                        if (_e855 < _e839.member_2[1]) {
                                            phi_1209_ = _e855;
                                        } else {
                                            phi_1209_ = _e839.member_2[1];
                                        }
                                        let _e864 = phi_1209_;
                                        if (_e856 < _e839.member_2[2]) {
                                            phi_1215_ = _e856;
                                        } else {
                                            phi_1215_ = _e839.member_2[2];
                                        }
                                        let _e868 = phi_1215_;
                                        if (_e860 > _e839.member[0]) {
                                            phi_1221_ = _e860;
                                        } else {
                                            phi_1221_ = _e839.member[0];
                                        }
                                        let _e872 = phi_1221_;
                                        if (_e864 > _e839.member[1]) {
                                            phi_1227_ = _e864;
                                        } else {
                                            phi_1227_ = _e839.member[1];
                                        }
                                        let _e876 = phi_1227_;
                                        if (_e868 > _e839.member[2]) {
                                            phi_1233_ = _e868;
                                        } else {
                                            phi_1233_ = _e839.member[2];
                                        }
                                        let _e880 = phi_1233_;
                                        let _e883 = (_e839.member_2[0] - _e872);
                                        let _e885 = (_e839.member_2[1] - _e876);
                                        let _e887 = (_e839.member_2[2] - _e880);
                                        let _e889 = (_e872 - _e839.member[0]);
                                        let _e891 = (_e876 - _e839.member[1]);
                                        let _e893 = (_e880 - _e839.member[2]);
                                        if (_e883 > _e889) {
                                            phi_1251_ = _e883;
                                        } else {
                                            phi_1251_ = _e889;
                                        }
                                        let _e896 = phi_1251_;
                                        if (_e885 > _e891) {
                                            phi_1256_ = _e885;
                                        } else {
                                            phi_1256_ = _e891;
                                        }
                                        let _e899 = phi_1256_;
                                        if (_e887 > _e893) {
                                            phi_1261_ = _e887;
                                        } else {
                                            phi_1261_ = _e893;
                                        }
                                        let _e902 = phi_1261_;
                                        let _e904 = (1f + (0.000000059604645f * 4f));
                                        let _e908 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1277_ = type_29(array<f32, 3>(_e872, _e876, _e880), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e896 * _e904) + _e908), ((_e899 * _e904) + _e908), ((_e902 * _e904) + _e908)));
                                    }
                                    let _e955 = phi_1277_;
                                    let _e960 = (_e955.member[0] - _e836.member[0]);
                                    let _e963 = (_e955.member[1] - _e836.member[1]);
                                    let _e966 = (_e955.member[2] - _e836.member[2]);
                                    if (_e960 < 0f) {
                                        phi_1467_ = -(_e960);
                                    } else {
                                        phi_1467_ = _e960;
                                    }
                                    let _e1155 = phi_1467_;
                                    if (_e963 < 0f) {
                                        phi_1473_ = -(_e963);
                                    } else {
                                        phi_1473_ = _e963;
                                    }
                                    let _e1159 = phi_1473_;
                                    if (_e966 < 0f) {
                                        phi_1480_ = -(_e966);
                                    } else {
                                        phi_1480_ = _e966;
                                    }
                                    let _e1164 = phi_1480_;
                                    if (_e836.member_2[0] < 0f) {
                                        phi_1489_ = -(_e836.member_2[0]);
                                    } else {
                                        phi_1489_ = _e836.member_2[0];
                                    }
                                    let _e1171 = phi_1489_;
                                    if (_e836.member_2[1] < 0f) {
                                        phi_1496_ = -(_e836.member_2[1]);
                                    } else {
                                        phi_1496_ = _e836.member_2[1];
                                    }
                                    let _e1176 = phi_1496_;
                                    if (_e836.member_2[2] < 0f) {
                                        phi_1504_ = -(_e836.member_2[2]);
                                    } else {
                                        phi_1504_ = _e836.member_2[2];
                                    }
                                    let _e1182 = phi_1504_;
                                    if (_e955.member_2[0] < 0f) {
                                        phi_1513_ = -(_e955.member_2[0]);
                                    } else {
                                        phi_1513_ = _e955.member_2[0];
                                    }
                                    let _e1189 = phi_1513_;
                                    if (_e955.member_2[1] < 0f) {
                                        phi_1520_ = -(_e955.member_2[1]);
                                    } else {
                                        phi_1520_ = _e955.member_2[1];
                                    }
                                    let _e1194 = phi_1520_;
                                    if (_e955.member_2[2] < 0f) {
                                        phi_1528_ = -(_e955.member_2[2]);
                                    } else {
                                        phi_1528_ = _e955.member_2[2];
                                    }
                                    let _e1200 = phi_1528_;
                                    local = type_24(array<array<f32, 3>, 3>(array<f32, 3>((((_e955.member_1[0][0] * _e836.member_1[0][0]) + (_e955.member_1[0][1] * _e836.member_1[0][1])) + (_e955.member_1[0][2] * _e836.member_1[0][2])), (((_e955.member_1[1][0] * _e836.member_1[0][0]) + (_e955.member_1[1][1] * _e836.member_1[0][1])) + (_e955.member_1[1][2] * _e836.member_1[0][2])), (((_e955.member_1[2][0] * _e836.member_1[0][0]) + (_e955.member_1[2][1] * _e836.member_1[0][1])) + (_e955.member_1[2][2] * _e836.member_1[0][2]))), array<f32, 3>((((_e955.member_1[0][0] * _e836.member_1[1][0]) + (_e955.member_1[0][1] * _e836.member_1[1][1])) + (_e955.member_1[0][2] * _e836.member_1[1][2])), (((_e955.member_1[1][0] * _e836.member_1[1][0]) + (_e955.member_1[1][1] * _e836.member_1[1][1])) + (_e955.member_1[1][2] * _e836.member_1[1][2])), (((_e955.member_1[2][0] * _e836.member_1[1][0]) + (_e955.member_1[2][1] * _e836.member_1[1][1])) + (_e955.member_1[2][2] * _e836.member_1[1][2]))), array<f32, 3>((((_e955.member_1[0][0] * _e836.member_1[2][0]) + (_e955.member_1[0][1] * _e836.member_1[2][1])) + (_e955.member_1[0][2] * _e836.member_1[2][2])), (((_e955.member_1[1][0] * _e836.member_1[2][0]) + (_e955.member_1[1][1] * _e836.member_1[2][1])) + (_e955.member_1[1][2] * _e836.member_1[2][2])), (((_e955.member_1[2][0] * _e836.member_1[2][0]) + (_e955.member_1[2][1] * _e836.member_1[2][1])) + (_e955.member_1[2][2] * _e836.member_1[2][2])))), array<f32, 3>((((_e836.member_1[0][0] * _e960) + (_e836.member_1[0][1] * _e963)) + (_e836.member_1[0][2] * _e966)), (((_e836.member_1[1][0] * _e960) + (_e836.member_1[1][1] * _e963)) + (_e836.member_1[1][2] * _e966)), (((_e836.member_1[2][0] * _e960) + (_e836.member_1[2][1] * _e963)) + (_e836.member_1[2][2] * _e966))), array<f32, 3>((((_e955.member_1[0][0] * _e960) + (_e955.member_1[0][1] * _e963)) + (_e955.member_1[0][2] * _e966)), (((_e955.member_1[1][0] * _e960) + (_e955.member_1[1][1] * _e963)) + (_e955.member_1[1][2] * _e966)), (((_e955.member_1[2][0] * _e960) + (_e955.member_1[2][1] * _e963)) + (_e955.member_1[2][2] * _e966))), array<f32, 3>(_e836.member_2[0], _e836.member_2[1], _e836.member_2[2]), array<f32, 3>(_e955.member_2[0], _e955.member_2[1], _e955.member_2[2]), ((((((_e1155 + _e1159) + _e1164) + (((_e1171 + _e1176) + _e1182) + ((_e1189 + _e1194) + _e1200))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1227 = local.member[0u][0u];
                                    let _e1231 = local.member[0u][1u];
                                    let _e1235 = local.member[0u][2u];
                                    let _e1239 = local.member[1u][0u];
                                    let _e1243 = local.member[1u][1u];
                                    let _e1247 = local.member[1u][2u];
                                    let _e1251 = local.member[2u][0u];
                                    let _e1255 = local.member[2u][1u];
                                    let _e1259 = local.member[2u][2u];
                                    let _e1261 = local.member_3;
                                    let _e1266 = local.member_4;
                                    let _e1272 = local.member_1[0u];
                                    if (_e1272 < 0f) {
                                        phi_1621_ = -(_e1272);
                                    } else {
                                        phi_1621_ = _e1272;
                                    }
                                    let _e1276 = phi_1621_;
                                    if (_e1227 < 0f) {
                                        phi_1628_ = -(_e1227);
                                    } else {
                                        phi_1628_ = _e1227;
                                    }
                                    let _e1280 = phi_1628_;
                                    if (_e1231 < 0f) {
                                        phi_1634_ = -(_e1231);
                                    } else {
                                        phi_1634_ = _e1231;
                                    }
                                    let _e1284 = phi_1634_;
                                    if (_e1235 < 0f) {
                                        phi_1640_ = -(_e1235);
                                    } else {
                                        phi_1640_ = _e1235;
                                    }
                                    let _e1288 = phi_1640_;
                                    let _e1295 = (_e1276 - (_e1261[0] + (((_e1280 * _e1266[0]) + (_e1284 * _e1266[1])) + (_e1288 * _e1266[2]))));
                                    let _e1298 = local.member_1[1u];
                                    if (_e1298 < 0f) {
                                        phi_1659_ = -(_e1298);
                                    } else {
                                        phi_1659_ = _e1298;
                                    }
                                    let _e1302 = phi_1659_;
                                    if (_e1239 < 0f) {
                                        phi_1666_ = -(_e1239);
                                    } else {
                                        phi_1666_ = _e1239;
                                    }
                                    let _e1306 = phi_1666_;
                                    if (_e1243 < 0f) {
                                        phi_1672_ = -(_e1243);
                                    } else {
                                        phi_1672_ = _e1243;
                                    }
                                    let _e1310 = phi_1672_;
                                    if (_e1247 < 0f) {
                                        phi_1678_ = -(_e1247);
                                    } else {
                                        phi_1678_ = _e1247;
                                    }
                                    let _e1314 = phi_1678_;
                                    let _e1321 = (_e1302 - (_e1261[1] + (((_e1306 * _e1266[0]) + (_e1310 * _e1266[1])) + (_e1314 * _e1266[2]))));
                                    let _e1324 = local.member_1[2u];
                                    if (_e1324 < 0f) {
                                        phi_1697_ = -(_e1324);
                                    } else {
                                        phi_1697_ = _e1324;
                                    }
                                    let _e1328 = phi_1697_;
                                    if (_e1251 < 0f) {
                                        phi_1704_ = -(_e1251);
                                    } else {
                                        phi_1704_ = _e1251;
                                    }
                                    let _e1332 = phi_1704_;
                                    if (_e1255 < 0f) {
                                        phi_1710_ = -(_e1255);
                                    } else {
                                        phi_1710_ = _e1255;
                                    }
                                    let _e1336 = phi_1710_;
                                    if (_e1259 < 0f) {
                                        phi_1716_ = -(_e1259);
                                    } else {
                                        phi_1716_ = _e1259;
                                    }
                                    let _e1340 = phi_1716_;
                                    let _e1347 = (_e1328 - (_e1261[2] + (((_e1332 * _e1266[0]) + (_e1336 * _e1266[1])) + (_e1340 * _e1266[2]))));
                                    let _e1350 = local.member_2[0u];
                                    if (_e1350 < 0f) {
                                        phi_1735_ = -(_e1350);
                                    } else {
                                        phi_1735_ = _e1350;
                                    }
                                    let _e1354 = phi_1735_;
                                    if (_e1227 < 0f) {
                                        phi_1742_ = -(_e1227);
                                    } else {
                                        phi_1742_ = _e1227;
                                    }
                                    let _e1358 = phi_1742_;
                                    if (_e1239 < 0f) {
                                        phi_1748_ = -(_e1239);
                                    } else {
                                        phi_1748_ = _e1239;
                                    }
                                    let _e1362 = phi_1748_;
                                    if (_e1251 < 0f) {
                                        phi_1754_ = -(_e1251);
                                    } else {
                                        phi_1754_ = _e1251;
                                    }
                                    let _e1366 = phi_1754_;
                                    let _e1373 = (_e1354 - (_e1266[0] + (((_e1358 * _e1261[0]) + (_e1362 * _e1261[1])) + (_e1366 * _e1261[2]))));
                                    let _e1376 = local.member_2[1u];
                                    if (_e1376 < 0f) {
                                        phi_1773_ = -(_e1376);
                                    } else {
                                        phi_1773_ = _e1376;
                                    }
                                    let _e1380 = phi_1773_;
                                    if (_e1231 < 0f) {
                                        phi_1780_ = -(_e1231);
                                    } else {
                                        phi_1780_ = _e1231;
                                    }
                                    let _e1384 = phi_1780_;
                                    if (_e1243 < 0f) {
                                        phi_1786_ = -(_e1243);
                                    } else {
                                        phi_1786_ = _e1243;
                                    }
                                    let _e1388 = phi_1786_;
                                    if (_e1255 < 0f) {
                                        phi_1792_ = -(_e1255);
                                    } else {
                                        phi_1792_ = _e1255;
                                    }
                                    let _e1392 = phi_1792_;
                                    let _e1399 = (_e1380 - (_e1266[1] + (((_e1384 * _e1261[0]) + (_e1388 * _e1261[1])) + (_e1392 * _e1261[2]))));
                                    let _e1402 = local.member_2[2u];
                                    if (_e1402 < 0f) {
                                        phi_1811_ = -(_e1402);
                                    } else {
                                        phi_1811_ = _e1402;
                                    }
                                    let _e1406 = phi_1811_;
                                    if (_e1235 < 0f) {
                                        phi_1818_ = -(_e1235);
                                    } else {
                                        phi_1818_ = _e1235;
                                    }
                                    let _e1410 = phi_1818_;
                                    if (_e1247 < 0f) {
                                        phi_1824_ = -(_e1247);
                                    } else {
                                        phi_1824_ = _e1247;
                                    }
                                    let _e1414 = phi_1824_;
                                    if (_e1259 < 0f) {
                                        phi_1830_ = -(_e1259);
                                    } else {
                                        phi_1830_ = _e1259;
                                    }
                                    let _e1418 = phi_1830_;
                                    let _e1425 = (_e1406 - (_e1266[2] + (((_e1410 * _e1261[0]) + (_e1414 * _e1261[1])) + (_e1418 * _e1261[2]))));
                                    if (_e1295 > _e1321) {
                                        phi_1845_ = _e1295;
                                    } else {
                                        phi_1845_ = _e1321;
                                    }
                                    let _e1428 = phi_1845_;
                                    if (_e1428 > _e1347) {
                                        phi_1850_ = _e1428;
                                    } else {
                                        phi_1850_ = _e1347;
                                    }
                                    let _e1431 = phi_1850_;
                                    if (_e1373 > _e1399) {
                                        phi_1855_ = _e1373;
                                    } else {
                                        phi_1855_ = _e1399;
                                    }
                                    let _e1434 = phi_1855_;
                                    if (_e1434 > _e1425) {
                                        phi_1860_ = _e1434;
                                    } else {
                                        phi_1860_ = _e1425;
                                    }
                                    let _e1437 = phi_1860_;
                                    if (_e1431 > _e1437) {
                                        phi_1865_ = _e1431;
                                    } else {
                                        phi_1865_ = _e1437;
                                    }
                                    let _e1440 = phi_1865_;
                                    let _e1442 = local.member_5;
                                    if (_e1440 > _e1442) {
                                        phi_3178_ = true;
                                    } else {
                                        let _e1447 = local.member[1u][0u];
                                        let _e1450 = local.member_1[2u];
                                        let _e1455 = local.member[2u][0u];
                                        let _e1458 = local.member_1[1u];
                                        let _e1460 = ((_e1447 * _e1450) - (_e1455 * _e1458));
                                        let _e1464 = local.member[2u][0u];
                                        if (_e1464 < 0f) {
                                            phi_1924_ = -(_e1464);
                                        } else {
                                            phi_1924_ = _e1464;
                                        }
                                        let _e1468 = phi_1924_;
                                        let _e1471 = local.member_3[1u];
                                        let _e1476 = local.member[1u][0u];
                                        if (_e1476 < 0f) {
                                            phi_1947_ = -(_e1476);
                                        } else {
                                            phi_1947_ = _e1476;
                                        }
                                        let _e1480 = phi_1947_;
                                        let _e1483 = local.member_3[2u];
                                        let _e1489 = local.member[0u][2u];
                                        if (_e1489 < 0f) {
                                            phi_1970_ = -(_e1489);
                                        } else {
                                            phi_1970_ = _e1489;
                                        }
                                        let _e1493 = phi_1970_;
                                        let _e1496 = local.member_4[1u];
                                        let _e1501 = local.member[0u][1u];
                                        if (_e1501 < 0f) {
                                            phi_1992_ = -(_e1501);
                                        } else {
                                            phi_1992_ = _e1501;
                                        }
                                        let _e1505 = phi_1992_;
                                        let _e1508 = local.member_4[2u];
                                        if (_e1460 < 0f) {
                                            phi_2008_ = -(_e1460);
                                        } else {
                                            phi_2008_ = _e1460;
                                        }
                                        let _e1514 = phi_2008_;
                                        let _e1516 = (_e1514 - (((_e1468 * _e1471) + (_e1480 * _e1483)) + ((_e1493 * _e1496) + (_e1505 * _e1508))));
                                        let _e1520 = local.member[1u][1u];
                                        let _e1523 = local.member_1[2u];
                                        let _e1528 = local.member[2u][1u];
                                        let _e1531 = local.member_1[1u];
                                        let _e1533 = ((_e1520 * _e1523) - (_e1528 * _e1531));
                                        let _e1537 = local.member[2u][1u];
                                        if (_e1537 < 0f) {
                                            phi_2063_ = -(_e1537);
                                        } else {
                                            phi_2063_ = _e1537;
                                        }
                                        let _e1541 = phi_2063_;
                                        let _e1544 = local.member_3[1u];
                                        let _e1549 = local.member[1u][1u];
                                        if (_e1549 < 0f) {
                                            phi_2086_ = -(_e1549);
                                        } else {
                                            phi_2086_ = _e1549;
                                        }
                                        let _e1553 = phi_2086_;
                                        let _e1556 = local.member_3[2u];
                                        let _e1562 = local.member[0u][0u];
                                        if (_e1562 < 0f) {
                                            phi_2109_ = -(_e1562);
                                        } else {
                                            phi_2109_ = _e1562;
                                        }
                                        let _e1566 = phi_2109_;
                                        let _e1569 = local.member_4[2u];
                                        let _e1574 = local.member[0u][2u];
                                        if (_e1574 < 0f) {
                                            phi_2131_ = -(_e1574);
                                        } else {
                                            phi_2131_ = _e1574;
                                        }
                                        let _e1578 = phi_2131_;
                                        let _e1581 = local.member_4[0u];
                                        if (_e1533 < 0f) {
                                            phi_2147_ = -(_e1533);
                                        } else {
                                            phi_2147_ = _e1533;
                                        }
                                        let _e1587 = phi_2147_;
                                        let _e1589 = (_e1587 - (((_e1541 * _e1544) + (_e1553 * _e1556)) + ((_e1566 * _e1569) + (_e1578 * _e1581))));
                                        let _e1593 = local.member[1u][2u];
                                        let _e1596 = local.member_1[2u];
                                        let _e1601 = local.member[2u][2u];
                                        let _e1604 = local.member_1[1u];
                                        let _e1606 = ((_e1593 * _e1596) - (_e1601 * _e1604));
                                        let _e1610 = local.member[2u][2u];
                                        if (_e1610 < 0f) {
                                            phi_2202_ = -(_e1610);
                                        } else {
                                            phi_2202_ = _e1610;
                                        }
                                        let _e1614 = phi_2202_;
                                        let _e1617 = local.member_3[1u];
                                        let _e1622 = local.member[1u][2u];
                                        if (_e1622 < 0f) {
                                            phi_2225_ = -(_e1622);
                                        } else {
                                            phi_2225_ = _e1622;
                                        }
                                        let _e1626 = phi_2225_;
                                        let _e1629 = local.member_3[2u];
                                        let _e1635 = local.member[0u][1u];
                                        if (_e1635 < 0f) {
                                            phi_2248_ = -(_e1635);
                                        } else {
                                            phi_2248_ = _e1635;
                                        }
                                        let _e1639 = phi_2248_;
                                        let _e1642 = local.member_4[0u];
                                        let _e1647 = local.member[0u][0u];
                                        if (_e1647 < 0f) {
                                            phi_2270_ = -(_e1647);
                                        } else {
                                            phi_2270_ = _e1647;
                                        }
                                        let _e1651 = phi_2270_;
                                        let _e1654 = local.member_4[1u];
                                        if (_e1606 < 0f) {
                                            phi_2286_ = -(_e1606);
                                        } else {
                                            phi_2286_ = _e1606;
                                        }
                                        let _e1660 = phi_2286_;
                                        let _e1662 = (_e1660 - (((_e1614 * _e1617) + (_e1626 * _e1629)) + ((_e1639 * _e1642) + (_e1651 * _e1654))));
                                        let _e1666 = local.member[2u][0u];
                                        let _e1669 = local.member_1[0u];
                                        let _e1674 = local.member[0u][0u];
                                        let _e1677 = local.member_1[2u];
                                        let _e1679 = ((_e1666 * _e1669) - (_e1674 * _e1677));
                                        let _e1683 = local.member[0u][0u];
                                        if (_e1683 < 0f) {
                                            phi_2341_ = -(_e1683);
                                        } else {
                                            phi_2341_ = _e1683;
                                        }
                                        let _e1687 = phi_2341_;
                                        let _e1690 = local.member_3[2u];
                                        let _e1695 = local.member[2u][0u];
                                        if (_e1695 < 0f) {
                                            phi_2364_ = -(_e1695);
                                        } else {
                                            phi_2364_ = _e1695;
                                        }
                                        let _e1699 = phi_2364_;
                                        let _e1702 = local.member_3[0u];
                                        let _e1708 = local.member[1u][2u];
                                        if (_e1708 < 0f) {
                                            phi_2388_ = -(_e1708);
                                        } else {
                                            phi_2388_ = _e1708;
                                        }
                                        let _e1712 = phi_2388_;
                                        let _e1715 = local.member_4[1u];
                                        let _e1720 = local.member[1u][1u];
                                        if (_e1720 < 0f) {
                                            phi_2411_ = -(_e1720);
                                        } else {
                                            phi_2411_ = _e1720;
                                        }
                                        let _e1724 = phi_2411_;
                                        let _e1727 = local.member_4[2u];
                                        if (_e1679 < 0f) {
                                            phi_2427_ = -(_e1679);
                                        } else {
                                            phi_2427_ = _e1679;
                                        }
                                        let _e1733 = phi_2427_;
                                        let _e1735 = (_e1733 - (((_e1687 * _e1690) + (_e1699 * _e1702)) + ((_e1712 * _e1715) + (_e1724 * _e1727))));
                                        let _e1739 = local.member[2u][1u];
                                        let _e1742 = local.member_1[0u];
                                        let _e1747 = local.member[0u][1u];
                                        let _e1750 = local.member_1[2u];
                                        let _e1752 = ((_e1739 * _e1742) - (_e1747 * _e1750));
                                        let _e1756 = local.member[0u][1u];
                                        if (_e1756 < 0f) {
                                            phi_2482_ = -(_e1756);
                                        } else {
                                            phi_2482_ = _e1756;
                                        }
                                        let _e1760 = phi_2482_;
                                        let _e1763 = local.member_3[2u];
                                        let _e1768 = local.member[2u][1u];
                                        if (_e1768 < 0f) {
                                            phi_2505_ = -(_e1768);
                                        } else {
                                            phi_2505_ = _e1768;
                                        }
                                        let _e1772 = phi_2505_;
                                        let _e1775 = local.member_3[0u];
                                        let _e1781 = local.member[1u][0u];
                                        if (_e1781 < 0f) {
                                            phi_2529_ = -(_e1781);
                                        } else {
                                            phi_2529_ = _e1781;
                                        }
                                        let _e1785 = phi_2529_;
                                        let _e1788 = local.member_4[2u];
                                        let _e1793 = local.member[1u][2u];
                                        if (_e1793 < 0f) {
                                            phi_2552_ = -(_e1793);
                                        } else {
                                            phi_2552_ = _e1793;
                                        }
                                        let _e1797 = phi_2552_;
                                        let _e1800 = local.member_4[0u];
                                        if (_e1752 < 0f) {
                                            phi_2568_ = -(_e1752);
                                        } else {
                                            phi_2568_ = _e1752;
                                        }
                                        let _e1806 = phi_2568_;
                                        let _e1808 = (_e1806 - (((_e1760 * _e1763) + (_e1772 * _e1775)) + ((_e1785 * _e1788) + (_e1797 * _e1800))));
                                        let _e1812 = local.member[2u][2u];
                                        let _e1815 = local.member_1[0u];
                                        let _e1820 = local.member[0u][2u];
                                        let _e1823 = local.member_1[2u];
                                        let _e1825 = ((_e1812 * _e1815) - (_e1820 * _e1823));
                                        let _e1829 = local.member[0u][2u];
                                        if (_e1829 < 0f) {
                                            phi_2623_ = -(_e1829);
                                        } else {
                                            phi_2623_ = _e1829;
                                        }
                                        let _e1833 = phi_2623_;
                                        let _e1836 = local.member_3[2u];
                                        let _e1841 = local.member[2u][2u];
                                        if (_e1841 < 0f) {
                                            phi_2646_ = -(_e1841);
                                        } else {
                                            phi_2646_ = _e1841;
                                        }
                                        let _e1845 = phi_2646_;
                                        let _e1848 = local.member_3[0u];
                                        let _e1854 = local.member[1u][1u];
                                        if (_e1854 < 0f) {
                                            phi_2670_ = -(_e1854);
                                        } else {
                                            phi_2670_ = _e1854;
                                        }
                                        let _e1858 = phi_2670_;
                                        let _e1861 = local.member_4[0u];
                                        let _e1866 = local.member[1u][0u];
                                        if (_e1866 < 0f) {
                                            phi_2693_ = -(_e1866);
                                        } else {
                                            phi_2693_ = _e1866;
                                        }
                                        let _e1870 = phi_2693_;
                                        let _e1873 = local.member_4[1u];
                                        if (_e1825 < 0f) {
                                            phi_2709_ = -(_e1825);
                                        } else {
                                            phi_2709_ = _e1825;
                                        }
                                        let _e1879 = phi_2709_;
                                        let _e1881 = (_e1879 - (((_e1833 * _e1836) + (_e1845 * _e1848)) + ((_e1858 * _e1861) + (_e1870 * _e1873))));
                                        let _e1885 = local.member[0u][0u];
                                        let _e1888 = local.member_1[1u];
                                        let _e1893 = local.member[1u][0u];
                                        let _e1896 = local.member_1[0u];
                                        let _e1898 = ((_e1885 * _e1888) - (_e1893 * _e1896));
                                        let _e1902 = local.member[1u][0u];
                                        if (_e1902 < 0f) {
                                            phi_2764_ = -(_e1902);
                                        } else {
                                            phi_2764_ = _e1902;
                                        }
                                        let _e1906 = phi_2764_;
                                        let _e1909 = local.member_3[0u];
                                        let _e1914 = local.member[0u][0u];
                                        if (_e1914 < 0f) {
                                            phi_2787_ = -(_e1914);
                                        } else {
                                            phi_2787_ = _e1914;
                                        }
                                        let _e1918 = phi_2787_;
                                        let _e1921 = local.member_3[1u];
                                        let _e1927 = local.member[2u][2u];
                                        if (_e1927 < 0f) {
                                            phi_2811_ = -(_e1927);
                                        } else {
                                            phi_2811_ = _e1927;
                                        }
                                        let _e1931 = phi_2811_;
                                        let _e1934 = local.member_4[1u];
                                        let _e1939 = local.member[2u][1u];
                                        if (_e1939 < 0f) {
                                            phi_2834_ = -(_e1939);
                                        } else {
                                            phi_2834_ = _e1939;
                                        }
                                        let _e1943 = phi_2834_;
                                        let _e1946 = local.member_4[2u];
                                        if (_e1898 < 0f) {
                                            phi_2850_ = -(_e1898);
                                        } else {
                                            phi_2850_ = _e1898;
                                        }
                                        let _e1952 = phi_2850_;
                                        let _e1954 = (_e1952 - (((_e1906 * _e1909) + (_e1918 * _e1921)) + ((_e1931 * _e1934) + (_e1943 * _e1946))));
                                        let _e1958 = local.member[0u][1u];
                                        let _e1961 = local.member_1[1u];
                                        let _e1966 = local.member[1u][1u];
                                        let _e1969 = local.member_1[0u];
                                        let _e1971 = ((_e1958 * _e1961) - (_e1966 * _e1969));
                                        let _e1975 = local.member[1u][1u];
                                        if (_e1975 < 0f) {
                                            phi_2905_ = -(_e1975);
                                        } else {
                                            phi_2905_ = _e1975;
                                        }
                                        let _e1979 = phi_2905_;
                                        let _e1982 = local.member_3[0u];
                                        let _e1987 = local.member[0u][1u];
                                        if (_e1987 < 0f) {
                                            phi_2928_ = -(_e1987);
                                        } else {
                                            phi_2928_ = _e1987;
                                        }
                                        let _e1991 = phi_2928_;
                                        let _e1994 = local.member_3[1u];
                                        let _e2000 = local.member[2u][0u];
                                        if (_e2000 < 0f) {
                                            phi_2952_ = -(_e2000);
                                        } else {
                                            phi_2952_ = _e2000;
                                        }
                                        let _e2004 = phi_2952_;
                                        let _e2007 = local.member_4[2u];
                                        let _e2012 = local.member[2u][2u];
                                        if (_e2012 < 0f) {
                                            phi_2975_ = -(_e2012);
                                        } else {
                                            phi_2975_ = _e2012;
                                        }
                                        let _e2016 = phi_2975_;
                                        let _e2019 = local.member_4[0u];
                                        if (_e1971 < 0f) {
                                            phi_2991_ = -(_e1971);
                                        } else {
                                            phi_2991_ = _e1971;
                                        }
                                        let _e2025 = phi_2991_;
                                        let _e2027 = (_e2025 - (((_e1979 * _e1982) + (_e1991 * _e1994)) + ((_e2004 * _e2007) + (_e2016 * _e2019))));
                                        let _e2031 = local.member[0u][2u];
                                        let _e2034 = local.member_1[1u];
                                        let _e2039 = local.member[1u][2u];
                                        let _e2042 = local.member_1[0u];
                                        let _e2044 = ((_e2031 * _e2034) - (_e2039 * _e2042));
                                        let _e2048 = local.member[1u][2u];
                                        if (_e2048 < 0f) {
                                            phi_3046_ = -(_e2048);
                                        } else {
                                            phi_3046_ = _e2048;
                                        }
                                        let _e2052 = phi_3046_;
                                        let _e2055 = local.member_3[0u];
                                        let _e2060 = local.member[0u][2u];
                                        if (_e2060 < 0f) {
                                            phi_3069_ = -(_e2060);
                                        } else {
                                            phi_3069_ = _e2060;
                                        }
                                        let _e2064 = phi_3069_;
                                        let _e2067 = local.member_3[1u];
                                        let _e2073 = local.member[2u][1u];
                                        if (_e2073 < 0f) {
                                            phi_3093_ = -(_e2073);
                                        } else {
                                            phi_3093_ = _e2073;
                                        }
                                        let _e2077 = phi_3093_;
                                        let _e2080 = local.member_4[0u];
                                        let _e2085 = local.member[2u][0u];
                                        if (_e2085 < 0f) {
                                            phi_3116_ = -(_e2085);
                                        } else {
                                            phi_3116_ = _e2085;
                                        }
                                        let _e2089 = phi_3116_;
                                        let _e2092 = local.member_4[1u];
                                        if (_e2044 < 0f) {
                                            phi_3132_ = -(_e2044);
                                        } else {
                                            phi_3132_ = _e2044;
                                        }
                                        let _e2098 = phi_3132_;
                                        let _e2100 = (_e2098 - (((_e2052 * _e2055) + (_e2064 * _e2067)) + ((_e2077 * _e2080) + (_e2089 * _e2092))));
                                        if (_e1516 > _e1589) {
                                            phi_3139_ = _e1516;
                                        } else {
                                            phi_3139_ = _e1589;
                                        }
                                        let _e2103 = phi_3139_;
                                        if (_e2103 > _e1662) {
                                            phi_3144_ = _e2103;
                                        } else {
                                            phi_3144_ = _e1662;
                                        }
                                        let _e2106 = phi_3144_;
                                        if (_e1735 > _e1808) {
                                            phi_3149_ = _e1735;
                                        } else {
                                            phi_3149_ = _e1808;
                                        }
                                        let _e2109 = phi_3149_;
                                        if (_e2109 > _e1881) {
                                            phi_3154_ = _e2109;
                                        } else {
                                            phi_3154_ = _e1881;
                                        }
                                        let _e2112 = phi_3154_;
                                        if (_e2106 > _e2112) {
                                            phi_3159_ = _e2106;
                                        } else {
                                            phi_3159_ = _e2112;
                                        }
                                        let _e2115 = phi_3159_;
                                        if (_e1954 > _e2027) {
                                            phi_3164_ = _e1954;
                                        } else {
                                            phi_3164_ = _e2027;
                                        }
                                        let _e2118 = phi_3164_;
                                        if (_e2118 > _e2100) {
                                            phi_3169_ = _e2118;
                                        } else {
                                            phi_3169_ = _e2100;
                                        }
                                        let _e2121 = phi_3169_;
                                        if (_e2115 > _e2121) {
                                            phi_3174_ = _e2115;
                                        } else {
                                            phi_3174_ = _e2121;
                                        }
                                        let _e2124 = phi_3174_;
                                        let _e2126 = local.member_5;
                                        phi_3178_ = (_e2124 > _e2126);
                                    }
                                    let _e2129 = phi_3178_;
                                    phi_3180_ = !(_e2129);
                                    phi_3181_ = false;
                                } else {
                                    phi_3180_ = bool();
                                    phi_3181_ = true;
                                }
                                let _e2132 = phi_3180_;
                                let _e2134 = phi_3181_;
                                phi_3182_ = _e2132;
                                phi_3183_ = _e2134;
                            }
                            let _e2136 = phi_3182_;
                            let _e2138 = phi_3183_;
                            if _e2138 {
                                phi_3187_ = true;
                            } else {
                                phi_3187_ = _e2136;
                            }
                            let _e2140 = phi_3187_;
                            if _e2140 {
                            } else {
                                local_1[_e699.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_920_ = _e697;
                        break if !(_e703);
                    }
                }
                let _e2143 = local_1;
                if (_e150 == 4294967295u) {
                    phi_3237_ = 0u;
                } else {
                    if (_e150 >= _e78) {
                        if (_e153 >= _e83) {
                            phi_3231_ = false;
                        } else {
                            phi_3231_ = true;
                        }
                        let _e2164 = phi_3231_;
                        phi_3232_ = _e2164;
                    } else {
                        phi_3232_ = true;
                    }
                    let _e2166 = phi_3232_;
                    if _e2166 {
                        phi_3236_ = 1u;
                    } else {
                        phi_3236_ = 2u;
                    }
                    let _e2168 = phi_3236_;
                    phi_3237_ = _e2168;
                }
                let _e2170 = phi_3237_;
                if (_e2170 == 2u) {
                    phi_3243_ = array<u32, 2>(_e150, _e153);
                } else {
                    phi_3243_ = array<u32, 2>(_e2143[0][0], _e2143[0][1]);
                }
                let _e2174 = phi_3243_;
                phi_3244_ = array<u32, 2>(_e2143[3][0], _e2143[3][1]);
                phi_3245_ = array<u32, 2>(_e2143[2][0], _e2143[2][1]);
                phi_3246_ = array<u32, 2>(_e2143[1][0], _e2143[1][1]);
                phi_3247_ = _e2174;
            } else {
                phi_3244_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3245_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3246_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3247_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2176 = phi_3244_;
            let _e2178 = phi_3245_;
            let _e2180 = phi_3246_;
            let _e2182 = phi_3247_;
            if (_e2182[0] == 4294967295u) {
                phi_3269_ = 0u;
            } else {
                if (_e2182[0] >= _e78) {
                    if (_e2182[1] >= _e83) {
                        phi_3263_ = false;
                    } else {
                        phi_3263_ = true;
                    }
                    let _e2190 = phi_3263_;
                    phi_3264_ = _e2190;
                } else {
                    phi_3264_ = true;
                }
                let _e2192 = phi_3264_;
                if _e2192 {
                    phi_3268_ = 1u;
                } else {
                    phi_3268_ = 2u;
                }
                let _e2194 = phi_3268_;
                phi_3269_ = _e2194;
            }
            let _e2196 = phi_3269_;
            if (_e2196 == 0u) {
                phi_3281_ = 0u;
            } else {
                if (_e2196 == 1u) {
                    phi_3278_ = 0u;
                } else {
                    phi_3278_ = 1u;
                }
                let _e2200 = phi_3278_;
                let _e2202 = atomicAdd((&counters[_e2200]), 1u);
                phi_3281_ = _e2202;
            }
            let _e2204 = phi_3281_;
            if (_e2180[0] == 4294967295u) {
                phi_3303_ = 0u;
            } else {
                if (_e2180[0] >= _e78) {
                    if (_e2180[1] >= _e83) {
                        phi_3297_ = false;
                    } else {
                        phi_3297_ = true;
                    }
                    let _e2212 = phi_3297_;
                    phi_3298_ = _e2212;
                } else {
                    phi_3298_ = true;
                }
                let _e2214 = phi_3298_;
                if _e2214 {
                    phi_3302_ = 1u;
                } else {
                    phi_3302_ = 2u;
                }
                let _e2216 = phi_3302_;
                phi_3303_ = _e2216;
            }
            let _e2218 = phi_3303_;
            if (_e2218 == 0u) {
                phi_3315_ = 0u;
            } else {
                if (_e2218 == 1u) {
                    phi_3312_ = 0u;
                } else {
                    phi_3312_ = 1u;
                }
                let _e2222 = phi_3312_;
                let _e2224 = atomicAdd((&counters[_e2222]), 1u);
                phi_3315_ = _e2224;
            }
            let _e2226 = phi_3315_;
            if (_e2178[0] == 4294967295u) {
                phi_3337_ = 0u;
            } else {
                if (_e2178[0] >= _e78) {
                    if (_e2178[1] >= _e83) {
                        phi_3331_ = false;
                    } else {
                        phi_3331_ = true;
                    }
                    let _e2234 = phi_3331_;
                    phi_3332_ = _e2234;
                } else {
                    phi_3332_ = true;
                }
                let _e2236 = phi_3332_;
                if _e2236 {
                    phi_3336_ = 1u;
                } else {
                    phi_3336_ = 2u;
                }
                let _e2238 = phi_3336_;
                phi_3337_ = _e2238;
            }
            let _e2240 = phi_3337_;
            if (_e2240 == 0u) {
                phi_3349_ = 0u;
            } else {
                if (_e2240 == 1u) {
                    phi_3346_ = 0u;
                } else {
                    phi_3346_ = 1u;
                }
                let _e2244 = phi_3346_;
                let _e2246 = atomicAdd((&counters[_e2244]), 1u);
                phi_3349_ = _e2246;
            }
            let _e2248 = phi_3349_;
            if (_e2176[0] == 4294967295u) {
                phi_3371_ = 0u;
            } else {
                if (_e2176[0] >= _e78) {
                    if (_e2176[1] >= _e83) {
                        phi_3365_ = false;
                    } else {
                        phi_3365_ = true;
                    }
                    let _e2256 = phi_3365_;
                    phi_3366_ = _e2256;
                } else {
                    phi_3366_ = true;
                }
                let _e2258 = phi_3366_;
                if _e2258 {
                    phi_3370_ = 1u;
                } else {
                    phi_3370_ = 2u;
                }
                let _e2260 = phi_3370_;
                phi_3371_ = _e2260;
            }
            let _e2262 = phi_3371_;
            if (_e2262 == 0u) {
                phi_3383_ = 0u;
            } else {
                if (_e2262 == 1u) {
                    phi_3380_ = 0u;
                } else {
                    phi_3380_ = 1u;
                }
                let _e2266 = phi_3380_;
                let _e2268 = atomicAdd((&counters[_e2266]), 1u);
                phi_3383_ = _e2268;
            }
            let _e2270 = phi_3383_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e2273 = atomicLoad((&counters[0u]));
                let _e2275 = atomicLoad((&counters[1u]));
                if (_e2273 > 0u) {
                    let _e2279 = atomicAdd((&levels.member[(_e68 + 1u)]), _e2273);
                    let _e2282 = atomicMax((&output.member[0u]), (_e2279 + _e2273));
                    if ((_e2279 + _e2273) < _e2279) {
                        let _e2286 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2279);
                }
                if (_e2275 > 0u) {
                    let _e2290 = atomicAdd((&pairs.member[0u]), _e2275);
                    if ((_e2290 + _e2275) < _e2290) {
                        let _e2294 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2290);
                }
            }
            workgroupBarrier();
            let _e2297 = atomicLoad((&counters[2u]));
            let _e2299 = atomicLoad((&counters[3u]));
            if (_e2182[0] == 4294967295u) {
                phi_3455_ = 0u;
            } else {
                if (_e2182[0] >= _e78) {
                    if (_e2182[1] >= _e83) {
                        phi_3449_ = false;
                    } else {
                        phi_3449_ = true;
                    }
                    let _e2307 = phi_3449_;
                    phi_3450_ = _e2307;
                } else {
                    phi_3450_ = true;
                }
                let _e2309 = phi_3450_;
                if _e2309 {
                    phi_3454_ = 1u;
                } else {
                    phi_3454_ = 2u;
                }
                let _e2311 = phi_3454_;
                phi_3455_ = _e2311;
            }
            let _e2313 = phi_3455_;
            if (_e2313 == 1u) {
                let _e2352 = params.member.member_2.member_3;
                let _e2353 = (_e2297 + _e2204);
                if (_e2353 < _e2352) {
                    let _e2355 = (2u * _e2353);
                    atomicStore((&output.member[(4u + _e2355)]), _e2182[0]);
                    atomicStore((&output.member[(_e2355 + 5u)]), _e2182[1]);
                }
            } else {
                if (_e2313 == 2u) {
                    let _e2318 = a_nodes.member[_e2182[0]];
                    let _e2322 = b_nodes.member[_e2182[1]];
                    let _e2326 = params.member.member_2.member;
                    if (_e2326 == 1u) {
                        if (_e2318.member_1 < _e2322.member_1) {
                            phi_3518_ = type_12(_e2318.member_1, _e2322.member_1);
                        } else {
                            phi_3518_ = type_12(_e2322.member_1, _e2318.member_1);
                        }
                        let _e2333 = phi_3518_;
                        phi_3523_ = _e2333;
                    } else {
                        phi_3523_ = type_12(_e2318.member_1, _e2322.member_1);
                    }
                    let _e2335 = phi_3523_;
                    let _e2338 = params.member.member_1.member_3;
                    let _e2339 = (_e2299 + _e2204);
                    if (_e2339 < _e2338) {
                        let _e2343 = (2u * _e2339);
                        atomicStore((&pairs.member[(4u + _e2343)]), _e2335.member);
                        atomicStore((&pairs.member[(_e2343 + 5u)]), _e2335.member_1);
                    }
                }
            }
            if (_e2180[0] == 4294967295u) {
                phi_3562_ = 0u;
            } else {
                if (_e2180[0] >= _e78) {
                    if (_e2180[1] >= _e83) {
                        phi_3556_ = false;
                    } else {
                        phi_3556_ = true;
                    }
                    let _e2367 = phi_3556_;
                    phi_3557_ = _e2367;
                } else {
                    phi_3557_ = true;
                }
                let _e2369 = phi_3557_;
                if _e2369 {
                    phi_3561_ = 1u;
                } else {
                    phi_3561_ = 2u;
                }
                let _e2371 = phi_3561_;
                phi_3562_ = _e2371;
            }
            let _e2373 = phi_3562_;
            if (_e2373 == 1u) {
                let _e2412 = params.member.member_2.member_3;
                let _e2413 = (_e2297 + _e2226);
                if (_e2413 < _e2412) {
                    let _e2415 = (2u * _e2413);
                    atomicStore((&output.member[(4u + _e2415)]), _e2180[0]);
                    atomicStore((&output.member[(_e2415 + 5u)]), _e2180[1]);
                }
            } else {
                if (_e2373 == 2u) {
                    let _e2378 = a_nodes.member[_e2180[0]];
                    let _e2382 = b_nodes.member[_e2180[1]];
                    let _e2386 = params.member.member_2.member;
                    if (_e2386 == 1u) {
                        if (_e2378.member_1 < _e2382.member_1) {
                            phi_3625_ = type_12(_e2378.member_1, _e2382.member_1);
                        } else {
                            phi_3625_ = type_12(_e2382.member_1, _e2378.member_1);
                        }
                        let _e2393 = phi_3625_;
                        phi_3630_ = _e2393;
                    } else {
                        phi_3630_ = type_12(_e2378.member_1, _e2382.member_1);
                    }
                    let _e2395 = phi_3630_;
                    let _e2398 = params.member.member_1.member_3;
                    let _e2399 = (_e2299 + _e2226);
                    if (_e2399 < _e2398) {
                        let _e2403 = (2u * _e2399);
                        atomicStore((&pairs.member[(4u + _e2403)]), _e2395.member);
                        atomicStore((&pairs.member[(_e2403 + 5u)]), _e2395.member_1);
                    }
                }
            }
            if (_e2178[0] == 4294967295u) {
                phi_3669_ = 0u;
            } else {
                if (_e2178[0] >= _e78) {
                    if (_e2178[1] >= _e83) {
                        phi_3663_ = false;
                    } else {
                        phi_3663_ = true;
                    }
                    let _e2427 = phi_3663_;
                    phi_3664_ = _e2427;
                } else {
                    phi_3664_ = true;
                }
                let _e2429 = phi_3664_;
                if _e2429 {
                    phi_3668_ = 1u;
                } else {
                    phi_3668_ = 2u;
                }
                let _e2431 = phi_3668_;
                phi_3669_ = _e2431;
            }
            let _e2433 = phi_3669_;
            if (_e2433 == 1u) {
                let _e2472 = params.member.member_2.member_3;
                let _e2473 = (_e2297 + _e2248);
                if (_e2473 < _e2472) {
                    let _e2475 = (2u * _e2473);
                    atomicStore((&output.member[(4u + _e2475)]), _e2178[0]);
                    atomicStore((&output.member[(_e2475 + 5u)]), _e2178[1]);
                }
            } else {
                if (_e2433 == 2u) {
                    let _e2438 = a_nodes.member[_e2178[0]];
                    let _e2442 = b_nodes.member[_e2178[1]];
                    let _e2446 = params.member.member_2.member;
                    if (_e2446 == 1u) {
                        if (_e2438.member_1 < _e2442.member_1) {
                            phi_3732_ = type_12(_e2438.member_1, _e2442.member_1);
                        } else {
                            phi_3732_ = type_12(_e2442.member_1, _e2438.member_1);
                        }
                        let _e2453 = phi_3732_;
                        phi_3737_ = _e2453;
                    } else {
                        phi_3737_ = type_12(_e2438.member_1, _e2442.member_1);
                    }
                    let _e2455 = phi_3737_;
                    let _e2458 = params.member.member_1.member_3;
                    let _e2459 = (_e2299 + _e2248);
                    if (_e2459 < _e2458) {
                        let _e2463 = (2u * _e2459);
                        atomicStore((&pairs.member[(4u + _e2463)]), _e2455.member);
                        atomicStore((&pairs.member[(_e2463 + 5u)]), _e2455.member_1);
                    }
                }
            }
            if (_e2176[0] == 4294967295u) {
                phi_3776_ = 0u;
            } else {
                if (_e2176[0] >= _e78) {
                    if (_e2176[1] >= _e83) {
                        phi_3770_ = false;
                    } else {
                        phi_3770_ = true;
                    }
                    let _e2487 = phi_3770_;
                    phi_3771_ = _e2487;
                } else {
                    phi_3771_ = true;
                }
                let _e2489 = phi_3771_;
                if _e2489 {
                    phi_3775_ = 1u;
                } else {
                    phi_3775_ = 2u;
                }
                let _e2491 = phi_3775_;
                phi_3776_ = _e2491;
            }
            let _e2493 = phi_3776_;
            if (_e2493 == 1u) {
                let _e2532 = params.member.member_2.member_3;
                let _e2533 = (_e2297 + _e2270);
                if (_e2533 < _e2532) {
                    let _e2535 = (2u * _e2533);
                    atomicStore((&output.member[(4u + _e2535)]), _e2176[0]);
                    atomicStore((&output.member[(_e2535 + 5u)]), _e2176[1]);
                }
            } else {
                if (_e2493 == 2u) {
                    let _e2498 = a_nodes.member[_e2176[0]];
                    let _e2502 = b_nodes.member[_e2176[1]];
                    let _e2506 = params.member.member_2.member;
                    if (_e2506 == 1u) {
                        if (_e2498.member_1 < _e2502.member_1) {
                            phi_3839_ = type_12(_e2498.member_1, _e2502.member_1);
                        } else {
                            phi_3839_ = type_12(_e2502.member_1, _e2498.member_1);
                        }
                        let _e2513 = phi_3839_;
                        phi_3844_ = _e2513;
                    } else {
                        phi_3844_ = type_12(_e2498.member_1, _e2502.member_1);
                    }
                    let _e2515 = phi_3844_;
                    let _e2518 = params.member.member_1.member_3;
                    let _e2519 = (_e2299 + _e2270);
                    if (_e2519 < _e2518) {
                        let _e2523 = (2u * _e2519);
                        atomicStore((&pairs.member[(4u + _e2523)]), _e2515.member);
                        atomicStore((&pairs.member[(_e2523 + 5u)]), _e2515.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_229_ = _e132;
            break if !(_e138);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
