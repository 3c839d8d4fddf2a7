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

struct type_33 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(6) 
var<storage, read_write> output: type_33;
@group(0) @binding(3) 
var<storage> oriented: type_28;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> levels: type_33;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_33;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var local_1: array<array<u32, 2>, 4>;
    var phi_149_: array<u32, 2>;
    var phi_175_: u32;
    var phi_193_: u32;
    var phi_213_: u32;
    var phi_216_: type_9;
    var phi_217_: type_9;
    var phi_240_: type_9;
    var phi_348_: array<u32, 2>;
    var phi_362_: array<u32, 2>;
    var phi_399_: array<u32, 2>;
    var phi_401_: type_22;
    var phi_402_: type_22;
    var phi_403_: bool;
    var phi_404_: type_22;
    var phi_405_: bool;
    var phi_421_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_576_: array<u32, 2>;
    var phi_605_: array<u32, 2>;
    var phi_634_: array<u32, 2>;
    var phi_663_: array<u32, 2>;
    var phi_665_: type_22;
    var phi_666_: bool;
    var phi_667_: type_22;
    var phi_668_: bool;
    var phi_841_: array<u32, 2>;
    var phi_873_: array<u32, 2>;
    var phi_741_: array<u32, 2>;
    var phi_773_: array<u32, 2>;
    var phi_875_: type_22;
    var phi_876_: type_22;
    var phi_877_: type_22;
    var phi_878_: bool;
    var phi_879_: type_22;
    var phi_880_: type_22;
    var phi_881_: bool;
    var phi_885_: type_22;
    var phi_900_: array<u32, 2>;
    var phi_928_: array<u32, 2>;
    var phi_966_: type_9;
    var phi_967_: type_9;
    var phi_990_: type_9;
    var phi_1019_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1105_: f32;
    var phi_1111_: f32;
    var phi_1117_: f32;
    var phi_1123_: f32;
    var phi_1129_: f32;
    var phi_1135_: f32;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1179_: type_29;
    var phi_1249_: f32;
    var phi_1255_: f32;
    var phi_1261_: f32;
    var phi_1267_: f32;
    var phi_1273_: f32;
    var phi_1279_: f32;
    var phi_1297_: f32;
    var phi_1302_: f32;
    var phi_1307_: f32;
    var phi_1323_: type_29;
    var phi_1513_: f32;
    var phi_1519_: f32;
    var phi_1526_: f32;
    var phi_1535_: f32;
    var phi_1542_: f32;
    var phi_1550_: f32;
    var phi_1559_: f32;
    var phi_1566_: f32;
    var phi_1574_: f32;
    var phi_1667_: f32;
    var phi_1674_: f32;
    var phi_1680_: f32;
    var phi_1686_: f32;
    var phi_1705_: f32;
    var phi_1712_: f32;
    var phi_1718_: f32;
    var phi_1724_: f32;
    var phi_1743_: f32;
    var phi_1750_: f32;
    var phi_1756_: f32;
    var phi_1762_: f32;
    var phi_1781_: f32;
    var phi_1788_: f32;
    var phi_1794_: f32;
    var phi_1800_: f32;
    var phi_1819_: f32;
    var phi_1826_: f32;
    var phi_1832_: f32;
    var phi_1838_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1870_: f32;
    var phi_1876_: f32;
    var phi_1891_: f32;
    var phi_1896_: f32;
    var phi_1901_: f32;
    var phi_1906_: f32;
    var phi_1911_: f32;
    var phi_1970_: f32;
    var phi_1993_: f32;
    var phi_2016_: f32;
    var phi_2038_: f32;
    var phi_2054_: f32;
    var phi_2109_: f32;
    var phi_2132_: f32;
    var phi_2155_: f32;
    var phi_2177_: f32;
    var phi_2193_: f32;
    var phi_2248_: f32;
    var phi_2271_: f32;
    var phi_2294_: f32;
    var phi_2316_: f32;
    var phi_2332_: f32;
    var phi_2387_: f32;
    var phi_2410_: f32;
    var phi_2434_: f32;
    var phi_2457_: f32;
    var phi_2473_: f32;
    var phi_2528_: f32;
    var phi_2551_: f32;
    var phi_2575_: f32;
    var phi_2598_: f32;
    var phi_2614_: f32;
    var phi_2669_: f32;
    var phi_2692_: f32;
    var phi_2716_: f32;
    var phi_2739_: f32;
    var phi_2755_: f32;
    var phi_2810_: f32;
    var phi_2833_: f32;
    var phi_2857_: f32;
    var phi_2880_: f32;
    var phi_2896_: f32;
    var phi_2951_: f32;
    var phi_2974_: f32;
    var phi_2998_: f32;
    var phi_3021_: f32;
    var phi_3037_: f32;
    var phi_3092_: f32;
    var phi_3115_: f32;
    var phi_3139_: f32;
    var phi_3162_: f32;
    var phi_3178_: f32;
    var phi_3185_: f32;
    var phi_3190_: f32;
    var phi_3195_: f32;
    var phi_3200_: f32;
    var phi_3205_: f32;
    var phi_3210_: f32;
    var phi_3215_: f32;
    var phi_3220_: f32;
    var phi_3224_: bool;
    var phi_3226_: bool;
    var phi_3227_: bool;
    var phi_3228_: bool;
    var phi_3229_: bool;
    var phi_3233_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3282_: u32;
    var phi_3283_: u32;
    var phi_3289_: array<u32, 2>;
    var phi_3290_: array<u32, 2>;
    var phi_3291_: array<u32, 2>;
    var phi_3292_: array<u32, 2>;
    var phi_3293_: array<u32, 2>;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3314_: u32;
    var phi_3315_: u32;
    var phi_3324_: u32;
    var phi_3327_: u32;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3348_: u32;
    var phi_3349_: u32;
    var phi_3358_: u32;
    var phi_3361_: u32;
    var phi_3377_: bool;
    var phi_3378_: bool;
    var phi_3382_: u32;
    var phi_3383_: u32;
    var phi_3392_: u32;
    var phi_3395_: u32;
    var phi_3411_: bool;
    var phi_3412_: bool;
    var phi_3416_: u32;
    var phi_3417_: u32;
    var phi_3426_: u32;
    var phi_3429_: u32;
    var phi_3495_: bool;
    var phi_3496_: bool;
    var phi_3500_: u32;
    var phi_3501_: u32;
    var phi_3564_: type_9;
    var phi_3569_: type_9;
    var phi_3602_: bool;
    var phi_3603_: bool;
    var phi_3607_: u32;
    var phi_3608_: u32;
    var phi_3671_: type_9;
    var phi_3676_: type_9;
    var phi_3709_: bool;
    var phi_3710_: bool;
    var phi_3714_: u32;
    var phi_3715_: u32;
    var phi_3778_: type_9;
    var phi_3783_: type_9;
    var phi_3816_: bool;
    var phi_3817_: bool;
    var phi_3821_: u32;
    var phi_3822_: u32;
    var phi_3885_: type_9;
    var phi_3890_: type_9;
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
    let _e71 = params.member.member_2.member;
    if (_e71 == 0u) {
        phi_149_ = array<u32, 2>(0u, 2u);
    } else {
        phi_149_ = array<u32, 2>(1u, 1u);
    }
    let _e74 = phi_149_;
    let _e80 = params.member.member.member[_e74[0]];
    let _e81 = (_e80 - 1u);
    let _e85 = params.member.member.member[_e74[1]];
    let _e86 = (_e85 - 1u);
    let _e89 = params.member.member_2.member_1;
    if (_e89 == 0u) {
        phi_175_ = 1u;
    } else {
        phi_175_ = 0u;
    }
    let _e92 = phi_175_;
    let _e94 = atomicLoad((&levels.member[_e68]));
    let _e97 = params.member.member_1.member_2;
    if (_e97 < _e94) {
        phi_193_ = _e97;
    } else {
        phi_193_ = _e94;
    }
    let _e100 = phi_193_;
    let _e103 = params.member.member_1.member_2;
    let _e104 = (_e62 * 128u);
    if (_e104 == 0u) {
        return;
    }
    let _e106 = (_e103 / _e104);
    if (_e104 == 0u) {
        return;
    }
    if ((_e103 % _e104) > 0u) {
        phi_213_ = (_e106 + 1u);
    } else {
        phi_213_ = _e106;
    }
    let _e112 = phi_213_;
    phi_216_ = type_9(0u, _e112);
    loop {
        let _e115 = phi_216_;
        if (_e115.member < _e115.member_1) {
            phi_217_ = type_9((_e115.member + 1u), _e115.member_1);
            phi_240_ = type_9(1u, _e115.member);
        } else {
            phi_217_ = _e115;
            phi_240_ = type_9(0u, type_9().member_1);
        }
        let _e127 = phi_217_;
        let _e129 = phi_240_;
        let _e133 = (bitcast<i32>(_e129.member) != 0i);
        if _e133 {
            let _e137 = (((((_e44.y * _e45.x) + _e44.x) + (_e129.member_1 * _e62)) * 128u) + _e46);
            if (_e46 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e137 < _e100) {
                let _e142 = (2u * _e137);
                let _e145 = input.member[(4u + _e142)];
                let _e148 = input.member[(_e142 + 5u)];
                let _e151 = a_nodes.member[_e145];
                let _e153 = b_nodes.member[_e148];
                if (_e65 == 1u) {
                    if (_e145 == _e148) {
                        if (_e151.member_3 == 4294967295u) {
                            phi_401_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e159 = a_nodes.member[_e151.member_1];
                            let _e162 = a_nodes.member[_e151.member_3];
                            if !((_e159.member_3 == 4294967295u)) {
                                phi_348_ = array<u32, 2>(_e151.member_1, _e151.member_1);
                            } else {
                                phi_348_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e169 = phi_348_;
                            let _e176 = type_22(array<array<u32, 2>, 4>(_e169, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e188 = type_22(array<array<u32, 2>, 4>(_e176.member[0], array<u32, 2>(_e151.member_1, _e176.member[1][1]), _e176.member[2], _e176.member[3]), _e176.member_1);
                            let _e189 = array<u32, 2>(_e151.member_1, _e151.member_3);
                            let _e196 = type_22(array<array<u32, 2>, 4>(_e188.member[0], _e189, _e188.member[2], _e188.member[3]), _e188.member_1);
                            if !((_e162.member_3 == 4294967295u)) {
                                phi_362_ = array<u32, 2>(_e151.member_3, _e151.member_3);
                            } else {
                                phi_362_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e203 = phi_362_;
                            let _e210 = type_22(array<array<u32, 2>, 4>(_e196.member[0], _e196.member[1], _e203, _e196.member[3]), _e196.member_1);
                            let _e213 = type_22(_e210.member, _e210.member);
                            if ((((((_e159.member[0] <= _e162.member_2[0]) && (_e162.member[0] <= _e159.member_2[0])) && (_e159.member[1] <= _e162.member_2[1])) && (_e162.member[1] <= _e159.member_2[1])) && (_e159.member[2] <= _e162.member_2[2])) && (_e162.member[2] <= _e159.member_2[2])) {
                                phi_399_ = _e189;
                            } else {
                                phi_399_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e242 = phi_399_;
                            phi_401_ = type_22(_e213.member, array<array<u32, 2>, 4>(_e213.member_1[0], _e242, _e213.member_1[2], _e213.member_1[3]));
                        }
                        let _e251 = phi_401_;
                        phi_402_ = _e251;
                        phi_403_ = false;
                    } else {
                        phi_402_ = type_22();
                        phi_403_ = true;
                    }
                    let _e253 = phi_402_;
                    let _e255 = phi_403_;
                    phi_404_ = _e253;
                    phi_405_ = _e255;
                } else {
                    phi_404_ = type_22();
                    phi_405_ = true;
                }
                let _e257 = phi_404_;
                let _e259 = phi_405_;
                if _e259 {
                    let _e262 = !((_e151.member_3 == 4294967295u));
                    let _e265 = !((_e153.member_3 == 4294967295u));
                    if _e262 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = _e265;
                    }
                    let _e267 = phi_421_;
                    if _e267 {
                        if _e262 {
                            if _e265 {
                                if (_e92 == 0u) {
                                    let _e295 = ((((_e153.member_2[0] - _e153.member[0]) * (_e153.member_2[1] - _e153.member[1])) * (_e153.member_2[2] - _e153.member[2])) > (((_e151.member_2[0] - _e151.member[0]) * (_e151.member_2[1] - _e151.member[1])) * (_e151.member_2[2] - _e151.member[2])));
                                    phi_465_ = _e295;
                                    phi_466_ = !(_e295);
                                } else {
                                    phi_465_ = _e265;
                                    phi_466_ = _e262;
                                }
                                let _e298 = phi_465_;
                                let _e300 = phi_466_;
                                phi_467_ = _e298;
                                phi_468_ = _e300;
                            } else {
                                phi_467_ = _e265;
                                phi_468_ = _e262;
                            }
                            let _e302 = phi_467_;
                            let _e304 = phi_468_;
                            phi_469_ = _e302;
                            phi_470_ = _e304;
                        } else {
                            phi_469_ = _e265;
                            phi_470_ = _e262;
                        }
                        let _e306 = phi_469_;
                        let _e308 = phi_470_;
                        if _e308 {
                            if _e306 {
                                let _e311 = a_nodes.member[_e151.member_1];
                                let _e316 = a_nodes.member[_e151.member_3];
                                let _e321 = b_nodes.member[_e153.member_1];
                                let _e326 = b_nodes.member[_e153.member_3];
                                let _e331 = array<u32, 2>(_e151.member_1, _e153.member_1);
                                let _e334 = array<u32, 2>(_e151.member_1, _e153.member_3);
                                let _e337 = array<u32, 2>(_e151.member_3, _e153.member_1);
                                let _e340 = array<u32, 2>(_e151.member_3, _e153.member_3);
                                if ((((((_e311.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e311.member_2[0])) && (_e311.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e311.member_2[1])) && (_e311.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e311.member_2[2])) {
                                    phi_576_ = _e331;
                                } else {
                                    phi_576_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e366 = phi_576_;
                                if ((((((_e311.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e311.member_2[0])) && (_e311.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e311.member_2[1])) && (_e311.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e311.member_2[2])) {
                                    phi_605_ = _e334;
                                } else {
                                    phi_605_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e391 = phi_605_;
                                if ((((((_e316.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e316.member_2[2])) {
                                    phi_634_ = _e337;
                                } else {
                                    phi_634_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e416 = phi_634_;
                                if ((((((_e316.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e316.member_2[2])) {
                                    phi_663_ = _e340;
                                } else {
                                    phi_663_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e441 = phi_663_;
                                phi_665_ = type_22(array<array<u32, 2>, 4>(_e331, _e334, _e337, _e340), array<array<u32, 2>, 4>(_e366, _e391, _e416, _e441));
                                phi_666_ = false;
                            } else {
                                phi_665_ = type_22();
                                phi_666_ = true;
                            }
                            let _e445 = phi_665_;
                            let _e447 = phi_666_;
                            phi_667_ = _e445;
                            phi_668_ = _e447;
                        } else {
                            phi_667_ = type_22();
                            phi_668_ = true;
                        }
                        let _e449 = phi_667_;
                        let _e451 = phi_668_;
                        if _e451 {
                            if _e308 {
                                let _e550 = a_nodes.member[_e151.member_1];
                                let _e555 = a_nodes.member[_e151.member_3];
                                let _e559 = array<u32, 2>(_e151.member_1, _e148);
                                let _e561 = array<u32, 2>(_e151.member_3, _e148);
                                let _e568 = type_22(array<array<u32, 2>, 4>(_e559, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e575 = type_22(array<array<u32, 2>, 4>(_e568.member[0], _e561, _e568.member[2], _e568.member[3]), _e568.member_1);
                                if ((((((_e550.member[0] <= _e153.member_2[0]) && (_e153.member[0] <= _e550.member_2[0])) && (_e550.member[1] <= _e153.member_2[1])) && (_e153.member[1] <= _e550.member_2[1])) && (_e550.member[2] <= _e153.member_2[2])) && (_e153.member[2] <= _e550.member_2[2])) {
                                    phi_741_ = _e559;
                                } else {
                                    phi_741_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e602 = phi_741_;
                                let _e609 = type_22(_e575.member, array<array<u32, 2>, 4>(_e602, _e575.member_1[1], _e575.member_1[2], _e575.member_1[3]));
                                if ((((((_e555.member[0] <= _e153.member_2[0]) && (_e153.member[0] <= _e555.member_2[0])) && (_e555.member[1] <= _e153.member_2[1])) && (_e153.member[1] <= _e555.member_2[1])) && (_e555.member[2] <= _e153.member_2[2])) && (_e153.member[2] <= _e555.member_2[2])) {
                                    phi_773_ = _e561;
                                } else {
                                    phi_773_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e636 = phi_773_;
                                phi_875_ = type_22(_e609.member, array<array<u32, 2>, 4>(_e609.member_1[0], _e636, _e609.member_1[2], _e609.member_1[3]));
                            } else {
                                let _e454 = b_nodes.member[_e153.member_1];
                                let _e459 = b_nodes.member[_e153.member_3];
                                let _e463 = array<u32, 2>(_e145, _e153.member_1);
                                let _e465 = array<u32, 2>(_e145, _e153.member_3);
                                let _e472 = type_22(array<array<u32, 2>, 4>(_e463, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e479 = type_22(array<array<u32, 2>, 4>(_e472.member[0], _e465, _e472.member[2], _e472.member[3]), _e472.member_1);
                                if ((((((_e151.member[0] <= _e454.member_2[0]) && (_e454.member[0] <= _e151.member_2[0])) && (_e151.member[1] <= _e454.member_2[1])) && (_e454.member[1] <= _e151.member_2[1])) && (_e151.member[2] <= _e454.member_2[2])) && (_e454.member[2] <= _e151.member_2[2])) {
                                    phi_841_ = _e463;
                                } else {
                                    phi_841_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e506 = phi_841_;
                                let _e513 = type_22(_e479.member, array<array<u32, 2>, 4>(_e506, _e479.member_1[1], _e479.member_1[2], _e479.member_1[3]));
                                if ((((((_e151.member[0] <= _e459.member_2[0]) && (_e459.member[0] <= _e151.member_2[0])) && (_e151.member[1] <= _e459.member_2[1])) && (_e459.member[1] <= _e151.member_2[1])) && (_e151.member[2] <= _e459.member_2[2])) && (_e459.member[2] <= _e151.member_2[2])) {
                                    phi_873_ = _e465;
                                } else {
                                    phi_873_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e540 = phi_873_;
                                phi_875_ = type_22(_e513.member, array<array<u32, 2>, 4>(_e513.member_1[0], _e540, _e513.member_1[2], _e513.member_1[3]));
                            }
                            let _e645 = phi_875_;
                            phi_876_ = _e645;
                        } else {
                            phi_876_ = _e449;
                        }
                        let _e647 = phi_876_;
                        phi_877_ = _e647;
                        phi_878_ = false;
                    } else {
                        phi_877_ = type_22();
                        phi_878_ = true;
                    }
                    let _e649 = phi_877_;
                    let _e651 = phi_878_;
                    phi_879_ = _e649;
                    phi_880_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_881_ = _e651;
                } else {
                    phi_879_ = type_22();
                    phi_880_ = _e257;
                    phi_881_ = true;
                }
                let _e653 = phi_879_;
                let _e655 = phi_880_;
                let _e657 = phi_881_;
                if _e657 {
                    phi_885_ = _e655;
                } else {
                    phi_885_ = _e653;
                }
                let _e659 = phi_885_;
                let _e663 = params.member.member_2.member;
                let _e667 = params.member.member_2.member;
                if (_e667 == 0u) {
                    phi_900_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_900_ = array<u32, 2>(1u, 1u);
                }
                let _e670 = phi_900_;
                let _e676 = params.member.member.member[_e670[0]];
                let _e677 = (_e676 - 1u);
                let _e681 = params.member.member.member[_e670[1]];
                let _e682 = (_e681 - 1u);
                let _e685 = params.member.member_2.member;
                if (_e685 == 0u) {
                    phi_928_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_928_ = array<u32, 2>(1u, 1u);
                }
                let _e688 = phi_928_;
                let _e694 = params.member.member.member_2[_e688[0]];
                let _e698 = params.member.member.member_2[_e688[1]];
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e659.member_1[0][0], _e659.member_1[0][1]), array<u32, 2>(_e659.member_1[1][0], _e659.member_1[1][1]), array<u32, 2>(_e659.member_1[2][0], _e659.member_1[2][1]), array<u32, 2>(_e659.member_1[3][0], _e659.member_1[3][1]));
                phi_966_ = type_9(0u, 4u);
                loop {
                    let _e717 = phi_966_;
                    if (_e717.member < _e717.member_1) {
                        phi_967_ = type_9((_e717.member + 1u), _e717.member_1);
                        phi_990_ = type_9(1u, _e717.member);
                    } else {
                        phi_967_ = _e717;
                        phi_990_ = type_9(0u, type_9().member_1);
                    }
                    let _e729 = phi_967_;
                    let _e731 = phi_990_;
                    let _e735 = (bitcast<i32>(_e731.member) != 0i);
                    if _e735 {
                        let _e737 = local_1[_e731.member_1];
                        if (_e737[0] != 4294967295u) {
                            if (_e663 == 1u) {
                                phi_1019_ = (_e737[0] == _e737[1]);
                            } else {
                                phi_1019_ = false;
                            }
                            let _e743 = phi_1019_;
                            if _e743 {
                                phi_3228_ = bool();
                                phi_3229_ = true;
                            } else {
                                if (_e737[0] >= _e677) {
                                    if (_e737[1] >= _e682) {
                                        phi_1031_ = false;
                                    } else {
                                        phi_1031_ = true;
                                    }
                                    let _e747 = phi_1031_;
                                    phi_1032_ = _e747;
                                } else {
                                    phi_1032_ = true;
                                }
                                let _e749 = phi_1032_;
                                if _e749 {
                                    if (_e737[0] < _e677) {
                                        let _e829 = oriented.member[(_e694 + _e737[0])];
                                        phi_1179_ = type_29(array<f32, 3>(_e829.member.x, _e829.member.y, _e829.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e829.member.w, _e829.member_1.x, _e829.member_1.y), array<f32, 3>(_e829.member_1.z, _e829.member_1.w, _e829.member_2.x), array<f32, 3>(_e829.member_2.y, _e829.member_2.z, _e829.member_2.w)), array<f32, 3>(_e829.member_3.x, _e829.member_3.y, _e829.member_3.z));
                                    } else {
                                        let _e752 = a_nodes.member[_e737[0]];
                                        let _e767 = ((_e752.member[0] * 0.5f) + (_e752.member_2[0] * 0.5f));
                                        let _e768 = ((_e752.member[1] * 0.5f) + (_e752.member_2[1] * 0.5f));
                                        let _e769 = ((_e752.member[2] * 0.5f) + (_e752.member_2[2] * 0.5f));
                                        if (_e767 < _e752.member_2[0]) {
                                            phi_1105_ = _e767;
                                        } else {
                                            phi_1105_ = _e752.member_2[0];
                                        }
                                        let _e773 = phi_1105_;
                                        if (_e768 < _e752.member_2[1]) {
                                            phi_1111_ = _e768;
                                        } else {
                                            phi_1111_ = _e752.member_2[1];
                                        }
                                        let _e777 = phi_1111_;
                                        if (_e769 < _e752.member_2[2]) {
                                            phi_1117_ = _e769;
                                        } else {
                                            phi_1117_ = _e752.member_2[2];
                                        }
                                        let _e781 = phi_1117_;
                                        if (_e773 > _e752.member[0]) {
                                            phi_1123_ = _e773;
                                        } else {
                                            phi_1123_ = _e752.member[0];
                                        }
                                        let _e785 = phi_1123_;
                                        if (_e777 > _e752.member[1]) {
                                            phi_1129_ = _e777;
                                        } else {
                                            phi_1129_ = _e752.member[1];
                                        }
                                        let _e789 = phi_1129_;
                                        if (_e781 > _e752.member[2]) {
                                            phi_1135_ = _e781;
                                        } else {
                                            phi_1135_ = _e752.member[2];
                                        }
                                        let _e793 = phi_1135_;
                                        let _e796 = (_e752.member_2[0] - _e785);
                                        let _e798 = (_e752.member_2[1] - _e789);
                                        let _e800 = (_e752.member_2[2] - _e793);
                                        let _e802 = (_e785 - _e752.member[0]);
                                        let _e804 = (_e789 - _e752.member[1]);
                                        let _e806 = (_e793 - _e752.member[2]);
                                        if (_e796 > _e802) {
                                            phi_1153_ = _e796;
                                        } else {
                                            phi_1153_ = _e802;
                                        }
                                        let _e809 = phi_1153_;
                                        if (_e798 > _e804) {
                                            phi_1158_ = _e798;
                                        } else {
                                            phi_1158_ = _e804;
                                        }
                                        let _e812 = phi_1158_;
                                        if (_e800 > _e806) {
                                            phi_1163_ = _e800;
                                        } else {
                                            phi_1163_ = _e806;
                                        }
                                        let _e815 = phi_1163_;
                                        let _e817 = (1f + (0.000000059604645f * 4f));
                                        let _e821 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1179_ = type_29(array<f32, 3>(_e785, _e789, _e793), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e809 * _e817) + _e821), ((_e812 * _e817) + _e821), ((_e815 * _e817) + _e821)));
                                    }
                                    let _e868 = phi_1179_;
                                    if (_e737[1] < _e682) {
                                        let _e948 = oriented.member[(_e698 + _e737[1])];
                                        phi_1323_ = type_29(array<f32, 3>(_e948.member.x, _e948.member.y, _e948.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e948.member.w, _e948.member_1.x, _e948.member_1.y), array<f32, 3>(_e948.member_1.z, _e948.member_1.w, _e948.member_2.x), array<f32, 3>(_e948.member_2.y, _e948.member_2.z, _e948.member_2.w)), array<f32, 3>(_e948.member_3.x, _e948.member_3.y, _e948.member_3.z));
                                    } else {
                                        let _e871 = b_nodes.member[_e737[1]];
                                        let _e886 = ((_e871.member[0] * 0.5f) + (_e871.member_2[0] * 0.5f));
                                        let _e887 = ((_e871.member[1] * 0.5f) + (_e871.member_2[1] * 0.5f));
                                        let _e888 = ((_e871.member[2] * 0.5f) + (_e871.member_2[2] * 0.5f));
                                        if (_e886 < _e871.member_2[0]) {
                                            phi_1249_ = _e886;
                                        } else {
                                            phi_1249_ = _e871.member_2[0];
                                        }
                                        let _e892 = phi_1249_;
                                        if (_e887 < _e871.member_2[1]) {
                                            phi_1255_ = _e887;
                                        } else {
                                            phi_1255_ = _e871.member_2[1];
                                        }
                                        let _e896 = phi_1255_;
                                        if (_e888 < _e871.member_2[2]) {
                                            phi_1261_ = _e888;
                                        } else {
                                            phi_1261_ = _e871.member_2[2];
                                        }
                                        let _e900 = phi_1261_;
                                        if (_e892 > _e871.member[0]) {
                                            phi_1267_ = _e892;
                                        } else {
                                            phi_1267_ = _e871.member[0];
                                        }
                                        let _e904 = phi_1267_;
                                        if (_e896 > _e871.member[1]) {
                                            phi_1273_ = _e896;
                                        } else {
                                            phi_1273_ = _e871.member[1];
                                        }
                                        let _e908 = phi_1273_;
                                        if (_e900 > _e871.member[2]) {
                                            phi_1279_ = _e900;
                                        } else {
                                            phi_1279_ = _e871.member[2];
                                        }
                                        let _e912 = phi_1279_;
                                        let _e915 = (_e871.member_2[0] - _e904);
                                        let _e917 = (_e871.member_2[1] - _e908);
                                        let _e919 = (_e871.member_2[2] - _e912);
                                        let _e921 = (_e904 - _e871.member[0]);
                                        let _e923 = (_e908 - _e871.member[1]);
                                        let _e925 = (_e912 - _e871.member[2]);
                                        if (_e915 > _e921) {
                                            phi_1297_ = _e915;
                                        } else {
                                            phi_1297_ = _e921;
                                        }
                                        let _e928 = phi_1297_;
                                        if (_e917 > _e923) {
                                            phi_1302_ = _e917;
                                        } else {
                                            phi_1302_ = _e923;
                                        }
                                        let _e931 = phi_1302_;
                                        if (_e919 > _e925) {
                                            phi_1307_ = _e919;
                                        } else {
                                            phi_1307_ = _e925;
                                        }
                                        let _e934 = phi_1307_;
                                        let _e936 = (1f + (0.000000059604645f * 4f));
                                        let _e940 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1323_ = type_29(array<f32, 3>(_e904, _e908, _e912), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e928 * _e936) + _e940), ((_e931 * _e936) + _e940), ((_e934 * _e936) + _e940)));
                                    }
                                    let _e987 = phi_1323_;
                                    let _e992 = (_e987.member[0] - _e868.member[0]);
                                    let _e995 = (_e987.member[1] - _e868.member[1]);
                                    let _e998 = (_e987.member[2] - _e868.member[2]);
                                    if (_e992 < 0f) {
                                        phi_1513_ = -(_e992);
                                    } else {
                                        phi_1513_ = _e992;
                                    }
                                    let _e1187 = phi_1513_;
                                    if (_e995 < 0f) {
                                        phi_1519_ = -(_e995);
                                    } else {
                                        phi_1519_ = _e995;
                                    }
                                    let _e1191 = phi_1519_;
                                    if (_e998 < 0f) {
                                        phi_1526_ = -(_e998);
                                    } else {
                                        phi_1526_ = _e998;
                                    }
                                    let _e1196 = phi_1526_;
                                    if (_e868.member_2[0] < 0f) {
                                        phi_1535_ = -(_e868.member_2[0]);
                                    } else {
                                        phi_1535_ = _e868.member_2[0];
                                    }
                                    let _e1203 = phi_1535_;
                                    if (_e868.member_2[1] < 0f) {
                                        phi_1542_ = -(_e868.member_2[1]);
                                    } else {
                                        phi_1542_ = _e868.member_2[1];
                                    }
                                    let _e1208 = phi_1542_;
                                    if (_e868.member_2[2] < 0f) {
                                        phi_1550_ = -(_e868.member_2[2]);
                                    } else {
                                        phi_1550_ = _e868.member_2[2];
                                    }
                                    let _e1214 = phi_1550_;
                                    if (_e987.member_2[0] < 0f) {
                                        phi_1559_ = -(_e987.member_2[0]);
                                    } else {
                                        phi_1559_ = _e987.member_2[0];
                                    }
                                    let _e1221 = phi_1559_;
                                    if (_e987.member_2[1] < 0f) {
                                        phi_1566_ = -(_e987.member_2[1]);
                                    } else {
                                        phi_1566_ = _e987.member_2[1];
                                    }
                                    let _e1226 = phi_1566_;
                                    if (_e987.member_2[2] < 0f) {
                                        phi_1574_ = -(_e987.member_2[2]);
                                    } else {
                                        phi_1574_ = _e987.member_2[2];
                                    }
                                    let _e1232 = phi_1574_;
                                    local = type_24(array<array<f32, 3>, 3>(array<f32, 3>((((_e987.member_1[0][0] * _e868.member_1[0][0]) + (_e987.member_1[0][1] * _e868.member_1[0][1])) + (_e987.member_1[0][2] * _e868.member_1[0][2])), (((_e987.member_1[1][0] * _e868.member_1[0][0]) + (_e987.member_1[1][1] * _e868.member_1[0][1])) + (_e987.member_1[1][2] * _e868.member_1[0][2])), (((_e987.member_1[2][0] * _e868.member_1[0][0]) + (_e987.member_1[2][1] * _e868.member_1[0][1])) + (_e987.member_1[2][2] * _e868.member_1[0][2]))), array<f32, 3>((((_e987.member_1[0][0] * _e868.member_1[1][0]) + (_e987.member_1[0][1] * _e868.member_1[1][1])) + (_e987.member_1[0][2] * _e868.member_1[1][2])), (((_e987.member_1[1][0] * _e868.member_1[1][0]) + (_e987.member_1[1][1] * _e868.member_1[1][1])) + (_e987.member_1[1][2] * _e868.member_1[1][2])), (((_e987.member_1[2][0] * _e868.member_1[1][0]) + (_e987.member_1[2][1] * _e868.member_1[1][1])) + (_e987.member_1[2][2] * _e868.member_1[1][2]))), array<f32, 3>((((_e987.member_1[0][0] * _e868.member_1[2][0]) + (_e987.member_1[0][1] * _e868.member_1[2][1])) + (_e987.member_1[0][2] * _e868.member_1[2][2])), (((_e987.member_1[1][0] * _e868.member_1[2][0]) + (_e987.member_1[1][1] * _e868.member_1[2][1])) + (_e987.member_1[1][2] * _e868.member_1[2][2])), (((_e987.member_1[2][0] * _e868.member_1[2][0]) + (_e987.member_1[2][1] * _e868.member_1[2][1])) + (_e987.member_1[2][2] * _e868.member_1[2][2])))), array<f32, 3>((((_e868.member_1[0][0] * _e992) + (_e868.member_1[0][1] * _e995)) + (_e868.member_1[0][2] * _e998)), (((_e868.member_1[1][0] * _e992) + (_e868.member_1[1][1] * _e995)) + (_e868.member_1[1][2] * _e998)), (((_e868.member_1[2][0] * _e992) + (_e868.member_1[2][1] * _e995)) + (_e868.member_1[2][2] * _e998))), array<f32, 3>((((_e987.member_1[0][0] * _e992) + (_e987.member_1[0][1] * _e995)) + (_e987.member_1[0][2] * _e998)), (((_e987.member_1[1][0] * _e992) + (_e987.member_1[1][1] * _e995)) + (_e987.member_1[1][2] * _e998)), (((_e987.member_1[2][0] * _e992) + (_e987.member_1[2][1] * _e995)) + (_e987.member_1[2][2] * _e998))), array<f32, 3>(_e868.member_2[0], _e868.member_2[1], _e868.member_2[2]), array<f32, 3>(_e987.member_2[0], _e987.member_2[1], _e987.member_2[2]), ((((((_e1187 + _e1191) + _e1196) + (((_e1203 + _e1208) + _e1214) + ((_e1221 + _e1226) + _e1232))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1259 = local.member[0u][0u];
                                    let _e1263 = local.member[0u][1u];
                                    let _e1267 = local.member[0u][2u];
                                    let _e1271 = local.member[1u][0u];
                                    let _e1275 = local.member[1u][1u];
                                    let _e1279 = local.member[1u][2u];
                                    let _e1283 = local.member[2u][0u];
                                    let _e1287 = local.member[2u][1u];
                                    let _e1291 = local.member[2u][2u];
                                    let _e1293 = local.member_3;
                                    let _e1298 = local.member_4;
                                    let _e1304 = local.member_1[0u];
                                    if (_e1304 < 0f) {
                                        phi_1667_ = -(_e1304);
                                    } else {
                                        phi_1667_ = _e1304;
                                    }
                                    let _e1308 = phi_1667_;
                                    if (_e1259 < 0f) {
                                        phi_1674_ = -(_e1259);
                                    } else {
                                        phi_1674_ = _e1259;
                                    }
                                    let _e1312 = phi_1674_;
                                    if (_e1263 < 0f) {
                                        phi_1680_ = -(_e1263);
                                    } else {
                                        phi_1680_ = _e1263;
                                    }
                                    let _e1316 = phi_1680_;
                                    if (_e1267 < 0f) {
                                        phi_1686_ = -(_e1267);
                                    } else {
                                        phi_1686_ = _e1267;
                                    }
                                    let _e1320 = phi_1686_;
                                    let _e1327 = (_e1308 - (_e1293[0] + (((_e1312 * _e1298[0]) + (_e1316 * _e1298[1])) + (_e1320 * _e1298[2]))));
                                    let _e1330 = local.member_1[1u];
                                    if (_e1330 < 0f) {
                                        phi_1705_ = -(_e1330);
                                    } else {
                                        phi_1705_ = _e1330;
                                    }
                                    let _e1334 = phi_1705_;
                                    if (_e1271 < 0f) {
                                        phi_1712_ = -(_e1271);
                                    } else {
                                        phi_1712_ = _e1271;
                                    }
                                    let _e1338 = phi_1712_;
                                    if (_e1275 < 0f) {
                                        phi_1718_ = -(_e1275);
                                    } else {
                                        phi_1718_ = _e1275;
                                    }
                                    let _e1342 = phi_1718_;
                                    if (_e1279 < 0f) {
                                        phi_1724_ = -(_e1279);
                                    } else {
                                        phi_1724_ = _e1279;
                                    }
                                    let _e1346 = phi_1724_;
                                    let _e1353 = (_e1334 - (_e1293[1] + (((_e1338 * _e1298[0]) + (_e1342 * _e1298[1])) + (_e1346 * _e1298[2]))));
                                    let _e1356 = local.member_1[2u];
                                    if (_e1356 < 0f) {
                                        phi_1743_ = -(_e1356);
                                    } else {
                                        phi_1743_ = _e1356;
                                    }
                                    let _e1360 = phi_1743_;
                                    if (_e1283 < 0f) {
                                        phi_1750_ = -(_e1283);
                                    } else {
                                        phi_1750_ = _e1283;
                                    }
                                    let _e1364 = phi_1750_;
                                    if (_e1287 < 0f) {
                                        phi_1756_ = -(_e1287);
                                    } else {
                                        phi_1756_ = _e1287;
                                    }
                                    let _e1368 = phi_1756_;
                                    if (_e1291 < 0f) {
                                        phi_1762_ = -(_e1291);
                                    } else {
                                        phi_1762_ = _e1291;
                                    }
                                    let _e1372 = phi_1762_;
                                    let _e1379 = (_e1360 - (_e1293[2] + (((_e1364 * _e1298[0]) + (_e1368 * _e1298[1])) + (_e1372 * _e1298[2]))));
                                    let _e1382 = local.member_2[0u];
                                    if (_e1382 < 0f) {
                                        phi_1781_ = -(_e1382);
                                    } else {
                                        phi_1781_ = _e1382;
                                    }
                                    let _e1386 = phi_1781_;
                                    if (_e1259 < 0f) {
                                        phi_1788_ = -(_e1259);
                                    } else {
                                        phi_1788_ = _e1259;
                                    }
                                    let _e1390 = phi_1788_;
                                    if (_e1271 < 0f) {
                                        phi_1794_ = -(_e1271);
                                    } else {
                                        phi_1794_ = _e1271;
                                    }
                                    let _e1394 = phi_1794_;
                                    if (_e1283 < 0f) {
                                        phi_1800_ = -(_e1283);
                                    } else {
                                        phi_1800_ = _e1283;
                                    }
                                    let _e1398 = phi_1800_;
                                    let _e1405 = (_e1386 - (_e1298[0] + (((_e1390 * _e1293[0]) + (_e1394 * _e1293[1])) + (_e1398 * _e1293[2]))));
                                    let _e1408 = local.member_2[1u];
                                    if (_e1408 < 0f) {
                                        phi_1819_ = -(_e1408);
                                    } else {
                                        phi_1819_ = _e1408;
                                    }
                                    let _e1412 = phi_1819_;
                                    if (_e1263 < 0f) {
                                        phi_1826_ = -(_e1263);
                                    } else {
                                        phi_1826_ = _e1263;
                                    }
                                    let _e1416 = phi_1826_;
                                    if (_e1275 < 0f) {
                                        phi_1832_ = -(_e1275);
                                    } else {
                                        phi_1832_ = _e1275;
                                    }
                                    let _e1420 = phi_1832_;
                                    if (_e1287 < 0f) {
                                        phi_1838_ = -(_e1287);
                                    } else {
                                        phi_1838_ = _e1287;
                                    }
                                    let _e1424 = phi_1838_;
                                    let _e1431 = (_e1412 - (_e1298[1] + (((_e1416 * _e1293[0]) + (_e1420 * _e1293[1])) + (_e1424 * _e1293[2]))));
                                    let _e1434 = local.member_2[2u];
                                    if (_e1434 < 0f) {
                                        phi_1857_ = -(_e1434);
                                    } else {
                                        phi_1857_ = _e1434;
                                    }
                                    let _e1438 = phi_1857_;
                                    if (_e1267 < 0f) {
                                        phi_1864_ = -(_e1267);
                                    } else {
                                        phi_1864_ = _e1267;
                                    }
                                    let _e1442 = phi_1864_;
                                    if (_e1279 < 0f) {
                                        phi_1870_ = -(_e1279);
                                    } else {
                                        phi_1870_ = _e1279;
                                    }
                                    let _e1446 = phi_1870_;
                                    if (_e1291 < 0f) {
                                        phi_1876_ = -(_e1291);
                                    } else {
                                        phi_1876_ = _e1291;
                                    }
                                    let _e1450 = phi_1876_;
                                    let _e1457 = (_e1438 - (_e1298[2] + (((_e1442 * _e1293[0]) + (_e1446 * _e1293[1])) + (_e1450 * _e1293[2]))));
                                    if (_e1327 > _e1353) {
                                        phi_1891_ = _e1327;
                                    } else {
                                        phi_1891_ = _e1353;
                                    }
                                    let _e1460 = phi_1891_;
                                    if (_e1460 > _e1379) {
                                        phi_1896_ = _e1460;
                                    } else {
                                        phi_1896_ = _e1379;
                                    }
                                    let _e1463 = phi_1896_;
                                    if (_e1405 > _e1431) {
                                        phi_1901_ = _e1405;
                                    } else {
                                        phi_1901_ = _e1431;
                                    }
                                    let _e1466 = phi_1901_;
                                    if (_e1466 > _e1457) {
                                        phi_1906_ = _e1466;
                                    } else {
                                        phi_1906_ = _e1457;
                                    }
                                    let _e1469 = phi_1906_;
                                    if (_e1463 > _e1469) {
                                        phi_1911_ = _e1463;
                                    } else {
                                        phi_1911_ = _e1469;
                                    }
                                    let _e1472 = phi_1911_;
                                    let _e1474 = local.member_5;
                                    if (_e1472 > _e1474) {
                                        phi_3224_ = true;
                                    } else {
                                        let _e1479 = local.member[1u][0u];
                                        let _e1482 = local.member_1[2u];
                                        let _e1487 = local.member[2u][0u];
                                        let _e1490 = local.member_1[1u];
                                        let _e1492 = ((_e1479 * _e1482) - (_e1487 * _e1490));
                                        let _e1496 = local.member[2u][0u];
                                        if (_e1496 < 0f) {
                                            phi_1970_ = -(_e1496);
                                        } else {
                                            phi_1970_ = _e1496;
                                        }
                                        let _e1500 = phi_1970_;
                                        let _e1503 = local.member_3[1u];
                                        let _e1508 = local.member[1u][0u];
                                        if (_e1508 < 0f) {
                                            phi_1993_ = -(_e1508);
                                        } else {
                                            phi_1993_ = _e1508;
                                        }
                                        let _e1512 = phi_1993_;
                                        let _e1515 = local.member_3[2u];
                                        let _e1521 = local.member[0u][2u];
                                        if (_e1521 < 0f) {
                                            phi_2016_ = -(_e1521);
                                        } else {
                                            phi_2016_ = _e1521;
                                        }
                                        let _e1525 = phi_2016_;
                                        let _e1528 = local.member_4[1u];
                                        let _e1533 = local.member[0u][1u];
                                        if (_e1533 < 0f) {
                                            phi_2038_ = -(_e1533);
                                        } else {
                                            phi_2038_ = _e1533;
                                        }
                                        let _e1537 = phi_2038_;
                                        let _e1540 = local.member_4[2u];
                                        if (_e1492 < 0f) {
                                            phi_2054_ = -(_e1492);
                                        } else {
                                            phi_2054_ = _e1492;
                                        }
                                        let _e1546 = phi_2054_;
                                        let _e1548 = (_e1546 - (((_e1500 * _e1503) + (_e1512 * _e1515)) + ((_e1525 * _e1528) + (_e1537 * _e1540))));
                                        let _e1552 = local.member[1u][1u];
                                        let _e1555 = local.member_1[2u];
                                        let _e1560 = local.member[2u][1u];
                                        let _e1563 = local.member_1[1u];
                                        let _e1565 = ((_e1552 * _e1555) - (_e1560 * _e1563));
                                        let _e1569 = local.member[2u][1u];
                                        if (_e1569 < 0f) {
                                            phi_2109_ = -(_e1569);
                                        } else {
                                            phi_2109_ = _e1569;
                                        }
                                        let _e1573 = phi_2109_;
                                        let _e1576 = local.member_3[1u];
                                        let _e1581 = local.member[1u][1u];
                                        if (_e1581 < 0f) {
                                            phi_2132_ = -(_e1581);
                                        } else {
                                            phi_2132_ = _e1581;
                                        }
                                        let _e1585 = phi_2132_;
                                        let _e1588 = local.member_3[2u];
                                        let _e1594 = local.member[0u][0u];
                                        if (_e1594 < 0f) {
                                            phi_2155_ = -(_e1594);
                                        } else {
                                            phi_2155_ = _e1594;
                                        }
                                        let _e1598 = phi_2155_;
                                        let _e1601 = local.member_4[2u];
                                        let _e1606 = local.member[0u][2u];
                                        if (_e1606 < 0f) {
                                            phi_2177_ = -(_e1606);
                                        } else {
                                            phi_2177_ = _e1606;
                                        }
                                        let _e1610 = phi_2177_;
                                        let _e1613 = local.member_4[0u];
                                        if (_e1565 < 0f) {
                                            phi_2193_ = -(_e1565);
                                        } else {
                                            phi_2193_ = _e1565;
                                        }
                                        let _e1619 = phi_2193_;
                                        let _e1621 = (_e1619 - (((_e1573 * _e1576) + (_e1585 * _e1588)) + ((_e1598 * _e1601) + (_e1610 * _e1613))));
                                        let _e1625 = local.member[1u][2u];
                                        let _e1628 = local.member_1[2u];
                                        let _e1633 = local.member[2u][2u];
                                        let _e1636 = local.member_1[1u];
                                        let _e1638 = ((_e1625 * _e1628) - (_e1633 * _e1636));
                                        let _e1642 = local.member[2u][2u];
                                        if (_e1642 < 0f) {
                                            phi_2248_ = -(_e1642);
                                        } else {
                                            phi_2248_ = _e1642;
                                        }
                                        let _e1646 = phi_2248_;
                                        let _e1649 = local.member_3[1u];
                                        let _e1654 = local.member[1u][2u];
                                        if (_e1654 < 0f) {
                                            phi_2271_ = -(_e1654);
                                        } else {
                                            phi_2271_ = _e1654;
                                        }
                                        let _e1658 = phi_2271_;
                                        let _e1661 = local.member_3[2u];
                                        let _e1667 = local.member[0u][1u];
                                        if (_e1667 < 0f) {
                                            phi_2294_ = -(_e1667);
                                        } else {
                                            phi_2294_ = _e1667;
                                        }
                                        let _e1671 = phi_2294_;
                                        let _e1674 = local.member_4[0u];
                                        let _e1679 = local.member[0u][0u];
                                        if (_e1679 < 0f) {
                                            phi_2316_ = -(_e1679);
                                        } else {
                                            phi_2316_ = _e1679;
                                        }
                                        let _e1683 = phi_2316_;
                                        let _e1686 = local.member_4[1u];
                                        if (_e1638 < 0f) {
                                            phi_2332_ = -(_e1638);
                                        } else {
                                            phi_2332_ = _e1638;
                                        }
                                        let _e1692 = phi_2332_;
                                        let _e1694 = (_e1692 - (((_e1646 * _e1649) + (_e1658 * _e1661)) + ((_e1671 * _e1674) + (_e1683 * _e1686))));
                                        let _e1698 = local.member[2u][0u];
                                        let _e1701 = local.member_1[0u];
                                        let _e1706 = local.member[0u][0u];
                                        let _e1709 = local.member_1[2u];
                                        let _e1711 = ((_e1698 * _e1701) - (_e1706 * _e1709));
                                        let _e1715 = local.member[0u][0u];
                                        if (_e1715 < 0f) {
                                            phi_2387_ = -(_e1715);
                                        } else {
                                            phi_2387_ = _e1715;
                                        }
                                        let _e1719 = phi_2387_;
                                        let _e1722 = local.member_3[2u];
                                        let _e1727 = local.member[2u][0u];
                                        if (_e1727 < 0f) {
                                            phi_2410_ = -(_e1727);
                                        } else {
                                            phi_2410_ = _e1727;
                                        }
                                        let _e1731 = phi_2410_;
                                        let _e1734 = local.member_3[0u];
                                        let _e1740 = local.member[1u][2u];
                                        if (_e1740 < 0f) {
                                            phi_2434_ = -(_e1740);
                                        } else {
                                            phi_2434_ = _e1740;
                                        }
                                        let _e1744 = phi_2434_;
                                        let _e1747 = local.member_4[1u];
                                        let _e1752 = local.member[1u][1u];
                                        if (_e1752 < 0f) {
                                            phi_2457_ = -(_e1752);
                                        } else {
                                            phi_2457_ = _e1752;
                                        }
                                        let _e1756 = phi_2457_;
                                        let _e1759 = local.member_4[2u];
                                        if (_e1711 < 0f) {
                                            phi_2473_ = -(_e1711);
                                        } else {
                                            phi_2473_ = _e1711;
                                        }
                                        let _e1765 = phi_2473_;
                                        let _e1767 = (_e1765 - (((_e1719 * _e1722) + (_e1731 * _e1734)) + ((_e1744 * _e1747) + (_e1756 * _e1759))));
                                        let _e1771 = local.member[2u][1u];
                                        let _e1774 = local.member_1[0u];
                                        let _e1779 = local.member[0u][1u];
                                        let _e1782 = local.member_1[2u];
                                        let _e1784 = ((_e1771 * _e1774) - (_e1779 * _e1782));
                                        let _e1788 = local.member[0u][1u];
                                        if (_e1788 < 0f) {
                                            phi_2528_ = -(_e1788);
                                        } else {
                                            phi_2528_ = _e1788;
                                        }
                                        let _e1792 = phi_2528_;
                                        let _e1795 = local.member_3[2u];
                                        let _e1800 = local.member[2u][1u];
                                        if (_e1800 < 0f) {
                                            phi_2551_ = -(_e1800);
                                        } else {
                                            phi_2551_ = _e1800;
                                        }
                                        let _e1804 = phi_2551_;
                                        let _e1807 = local.member_3[0u];
                                        let _e1813 = local.member[1u][0u];
                                        if (_e1813 < 0f) {
                                            phi_2575_ = -(_e1813);
                                        } else {
                                            phi_2575_ = _e1813;
                                        }
                                        let _e1817 = phi_2575_;
                                        let _e1820 = local.member_4[2u];
                                        let _e1825 = local.member[1u][2u];
                                        if (_e1825 < 0f) {
                                            phi_2598_ = -(_e1825);
                                        } else {
                                            phi_2598_ = _e1825;
                                        }
                                        let _e1829 = phi_2598_;
                                        let _e1832 = local.member_4[0u];
                                        if (_e1784 < 0f) {
                                            phi_2614_ = -(_e1784);
                                        } else {
                                            phi_2614_ = _e1784;
                                        }
                                        let _e1838 = phi_2614_;
                                        let _e1840 = (_e1838 - (((_e1792 * _e1795) + (_e1804 * _e1807)) + ((_e1817 * _e1820) + (_e1829 * _e1832))));
                                        let _e1844 = local.member[2u][2u];
                                        let _e1847 = local.member_1[0u];
                                        let _e1852 = local.member[0u][2u];
                                        let _e1855 = local.member_1[2u];
                                        let _e1857 = ((_e1844 * _e1847) - (_e1852 * _e1855));
                                        let _e1861 = local.member[0u][2u];
                                        if (_e1861 < 0f) {
                                            phi_2669_ = -(_e1861);
                                        } else {
                                            phi_2669_ = _e1861;
                                        }
                                        let _e1865 = phi_2669_;
                                        let _e1868 = local.member_3[2u];
                                        let _e1873 = local.member[2u][2u];
                                        if (_e1873 < 0f) {
                                            phi_2692_ = -(_e1873);
                                        } else {
                                            phi_2692_ = _e1873;
                                        }
                                        let _e1877 = phi_2692_;
                                        let _e1880 = local.member_3[0u];
                                        let _e1886 = local.member[1u][1u];
                                        if (_e1886 < 0f) {
                                            phi_2716_ = -(_e1886);
                                        } else {
                                            phi_2716_ = _e1886;
                                        }
                                        let _e1890 = phi_2716_;
                                        let _e1893 = local.member_4[0u];
                                        let _e1898 = local.member[1u][0u];
                                        if (_e1898 < 0f) {
                                            phi_2739_ = -(_e1898);
                                        } else {
                                            phi_2739_ = _e1898;
                                        }
                                        let _e1902 = phi_2739_;
                                        let _e1905 = local.member_4[1u];
                                        if (_e1857 < 0f) {
                                            phi_2755_ = -(_e1857);
                                        } else {
                                            phi_2755_ = _e1857;
                                        }
                                        let _e1911 = phi_2755_;
                                        let _e1913 = (_e1911 - (((_e1865 * _e1868) + (_e1877 * _e1880)) + ((_e1890 * _e1893) + (_e1902 * _e1905))));
                                        let _e1917 = local.member[0u][0u];
                                        let _e1920 = local.member_1[1u];
                                        let _e1925 = local.member[1u][0u];
                                        let _e1928 = local.member_1[0u];
                                        let _e1930 = ((_e1917 * _e1920) - (_e1925 * _e1928));
                                        let _e1934 = local.member[1u][0u];
                                        if (_e1934 < 0f) {
                                            phi_2810_ = -(_e1934);
                                        } else {
                                            phi_2810_ = _e1934;
                                        }
                                        let _e1938 = phi_2810_;
                                        let _e1941 = local.member_3[0u];
                                        let _e1946 = local.member[0u][0u];
                                        if (_e1946 < 0f) {
                                            phi_2833_ = -(_e1946);
                                        } else {
                                            phi_2833_ = _e1946;
                                        }
                                        let _e1950 = phi_2833_;
                                        let _e1953 = local.member_3[1u];
                                        let _e1959 = local.member[2u][2u];
                                        if (_e1959 < 0f) {
                                            phi_2857_ = -(_e1959);
                                        } else {
                                            phi_2857_ = _e1959;
                                        }
                                        let _e1963 = phi_2857_;
                                        let _e1966 = local.member_4[1u];
                                        let _e1971 = local.member[2u][1u];
                                        if (_e1971 < 0f) {
                                            phi_2880_ = -(_e1971);
                                        } else {
                                            phi_2880_ = _e1971;
                                        }
                                        let _e1975 = phi_2880_;
                                        let _e1978 = local.member_4[2u];
                                        if (_e1930 < 0f) {
                                            phi_2896_ = -(_e1930);
                                        } else {
                                            phi_2896_ = _e1930;
                                        }
                                        let _e1984 = phi_2896_;
                                        let _e1986 = (_e1984 - (((_e1938 * _e1941) + (_e1950 * _e1953)) + ((_e1963 * _e1966) + (_e1975 * _e1978))));
                                        let _e1990 = local.member[0u][1u];
                                        let _e1993 = local.member_1[1u];
                                        let _e1998 = local.member[1u][1u];
                                        let _e2001 = local.member_1[0u];
                                        let _e2003 = ((_e1990 * _e1993) - (_e1998 * _e2001));
                                        let _e2007 = local.member[1u][1u];
                                        if (_e2007 < 0f) {
                                            phi_2951_ = -(_e2007);
                                        } else {
                                            phi_2951_ = _e2007;
                                        }
                                        let _e2011 = phi_2951_;
                                        let _e2014 = local.member_3[0u];
                                        let _e2019 = local.member[0u][1u];
                                        if (_e2019 < 0f) {
                                            phi_2974_ = -(_e2019);
                                        } else {
                                            phi_2974_ = _e2019;
                                        }
                                        let _e2023 = phi_2974_;
                                        let _e2026 = local.member_3[1u];
                                        let _e2032 = local.member[2u][0u];
                                        if (_e2032 < 0f) {
                                            phi_2998_ = -(_e2032);
                                        } else {
                                            phi_2998_ = _e2032;
                                        }
                                        let _e2036 = phi_2998_;
                                        let _e2039 = local.member_4[2u];
                                        let _e2044 = local.member[2u][2u];
                                        if (_e2044 < 0f) {
                                            phi_3021_ = -(_e2044);
                                        } else {
                                            phi_3021_ = _e2044;
                                        }
                                        let _e2048 = phi_3021_;
                                        let _e2051 = local.member_4[0u];
                                        if (_e2003 < 0f) {
                                            phi_3037_ = -(_e2003);
                                        } else {
                                            phi_3037_ = _e2003;
                                        }
                                        let _e2057 = phi_3037_;
                                        let _e2059 = (_e2057 - (((_e2011 * _e2014) + (_e2023 * _e2026)) + ((_e2036 * _e2039) + (_e2048 * _e2051))));
                                        let _e2063 = local.member[0u][2u];
                                        let _e2066 = local.member_1[1u];
                                        let _e2071 = local.member[1u][2u];
                                        let _e2074 = local.member_1[0u];
                                        let _e2076 = ((_e2063 * _e2066) - (_e2071 * _e2074));
                                        let _e2080 = local.member[1u][2u];
                                        if (_e2080 < 0f) {
                                            phi_3092_ = -(_e2080);
                                        } else {
                                            phi_3092_ = _e2080;
                                        }
                                        let _e2084 = phi_3092_;
                                        let _e2087 = local.member_3[0u];
                                        let _e2092 = local.member[0u][2u];
                                        if (_e2092 < 0f) {
                                            phi_3115_ = -(_e2092);
                                        } else {
                                            phi_3115_ = _e2092;
                                        }
                                        let _e2096 = phi_3115_;
                                        let _e2099 = local.member_3[1u];
                                        let _e2105 = local.member[2u][1u];
                                        if (_e2105 < 0f) {
                                            phi_3139_ = -(_e2105);
                                        } else {
                                            phi_3139_ = _e2105;
                                        }
                                        let _e2109 = phi_3139_;
                                        let _e2112 = local.member_4[0u];
                                        let _e2117 = local.member[2u][0u];
                                        if (_e2117 < 0f) {
                                            phi_3162_ = -(_e2117);
                                        } else {
                                            phi_3162_ = _e2117;
                                        }
                                        let _e2121 = phi_3162_;
                                        let _e2124 = local.member_4[1u];
                                        if (_e2076 < 0f) {
                                            phi_3178_ = -(_e2076);
                                        } else {
                                            phi_3178_ = _e2076;
                                        }
                                        let _e2130 = phi_3178_;
                                        let _e2132 = (_e2130 - (((_e2084 * _e2087) + (_e2096 * _e2099)) + ((_e2109 * _e2112) + (_e2121 * _e2124))));
                                        if (_e1548 > _e1621) {
                                            phi_3185_ = _e1548;
                                        } else {
                                            phi_3185_ = _e1621;
                                        }
                                        let _e2135 = phi_3185_;
                                        if (_e2135 > _e1694) {
                                            phi_3190_ = _e2135;
                                        } else {
                                            phi_3190_ = _e1694;
                                        }
                                        let _e2138 = phi_3190_;
                                        if (_e1767 > _e1840) {
                                            phi_3195_ = _e1767;
                                        } else {
                                            phi_3195_ = _e1840;
                                        }
                                        let _e2141 = phi_3195_;
                                        if (_e2141 > _e1913) {
                                            phi_3200_ = _e2141;
                                        } else {
                                            phi_3200_ = _e1913;
                                        }
                                        let _e2144 = phi_3200_;
                                        if (_e2138 > _e2144) {
                                            phi_3205_ = _e2138;
                                        } else {
                                            phi_3205_ = _e2144;
                                        }
                                        let _e2147 = phi_3205_;
                                        if (_e1986 > _e2059) {
                                            phi_3210_ = _e1986;
                                        } else {
                                            phi_3210_ = _e2059;
                                        }
                                        let _e2150 = phi_3210_;
                                        if (_e2150 > _e2132) {
                                            phi_3215_ = _e2150;
                                        } else {
                                            phi_3215_ = _e2132;
                                        }
                                        let _e2153 = phi_3215_;
                                        if (_e2147 > _e2153) {
                                            phi_3220_ = _e2147;
                                        } else {
                                            phi_3220_ = _e2153;
                                        }
                                        let _e2156 = phi_3220_;
                                        let _e2158 = local.member_5;
                                        phi_3224_ = (_e2156 > _e2158);
                                    }
                                    let _e2161 = phi_3224_;
                                    phi_3226_ = !(_e2161);
                                    phi_3227_ = false;
                                } else {
                                    phi_3226_ = bool();
                                    phi_3227_ = true;
                                }
                                let _e2164 = phi_3226_;
                                let _e2166 = phi_3227_;
                                phi_3228_ = _e2164;
                                phi_3229_ = _e2166;
                            }
                            let _e2168 = phi_3228_;
                            let _e2170 = phi_3229_;
                            if _e2170 {
                                phi_3233_ = true;
                            } else {
                                phi_3233_ = _e2168;
                            }
                            let _e2172 = phi_3233_;
                            if _e2172 {
                            } else {
                                local_1[_e731.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_966_ = _e729;
                        break if !(_e735);
                    }
                }
                let _e2175 = local_1;
                if (_e145 == 4294967295u) {
                    phi_3283_ = 0u;
                } else {
                    if (_e145 >= _e81) {
                        if (_e148 >= _e86) {
                            phi_3277_ = false;
                        } else {
                            phi_3277_ = true;
                        }
                        let _e2196 = phi_3277_;
                        phi_3278_ = _e2196;
                    } else {
                        phi_3278_ = true;
                    }
                    let _e2198 = phi_3278_;
                    if _e2198 {
                        phi_3282_ = 1u;
                    } else {
                        phi_3282_ = 2u;
                    }
                    let _e2200 = phi_3282_;
                    phi_3283_ = _e2200;
                }
                let _e2202 = phi_3283_;
                if (_e2202 == 2u) {
                    phi_3289_ = array<u32, 2>(_e145, _e148);
                } else {
                    phi_3289_ = array<u32, 2>(_e2175[0][0], _e2175[0][1]);
                }
                let _e2206 = phi_3289_;
                phi_3290_ = array<u32, 2>(_e2175[3][0], _e2175[3][1]);
                phi_3291_ = array<u32, 2>(_e2175[2][0], _e2175[2][1]);
                phi_3292_ = array<u32, 2>(_e2175[1][0], _e2175[1][1]);
                phi_3293_ = _e2206;
            } else {
                phi_3290_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3291_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3292_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3293_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2208 = phi_3290_;
            let _e2210 = phi_3291_;
            let _e2212 = phi_3292_;
            let _e2214 = phi_3293_;
            if (_e2214[0] == 4294967295u) {
                phi_3315_ = 0u;
            } else {
                if (_e2214[0] >= _e81) {
                    if (_e2214[1] >= _e86) {
                        phi_3309_ = false;
                    } else {
                        phi_3309_ = true;
                    }
                    let _e2222 = phi_3309_;
                    phi_3310_ = _e2222;
                } else {
                    phi_3310_ = true;
                }
                let _e2224 = phi_3310_;
                if _e2224 {
                    phi_3314_ = 1u;
                } else {
                    phi_3314_ = 2u;
                }
                let _e2226 = phi_3314_;
                phi_3315_ = _e2226;
            }
            let _e2228 = phi_3315_;
            if (_e2228 == 0u) {
                phi_3327_ = 0u;
            } else {
                if (_e2228 == 1u) {
                    phi_3324_ = 0u;
                } else {
                    phi_3324_ = 1u;
                }
                let _e2232 = phi_3324_;
                let _e2234 = atomicAdd((&counters[_e2232]), 1u);
                phi_3327_ = _e2234;
            }
            let _e2236 = phi_3327_;
            if (_e2212[0] == 4294967295u) {
                phi_3349_ = 0u;
            } else {
                if (_e2212[0] >= _e81) {
                    if (_e2212[1] >= _e86) {
                        phi_3343_ = false;
                    } else {
                        phi_3343_ = true;
                    }
                    let _e2244 = phi_3343_;
                    phi_3344_ = _e2244;
                } else {
                    phi_3344_ = true;
                }
                let _e2246 = phi_3344_;
                if _e2246 {
                    phi_3348_ = 1u;
                } else {
                    phi_3348_ = 2u;
                }
                let _e2248 = phi_3348_;
                phi_3349_ = _e2248;
            }
            let _e2250 = phi_3349_;
            if (_e2250 == 0u) {
                phi_3361_ = 0u;
            } else {
                if (_e2250 == 1u) {
                    phi_3358_ = 0u;
                } else {
                    phi_3358_ = 1u;
                }
                let _e2254 = phi_3358_;
                let _e2256 = atomicAdd((&counters[_e2254]), 1u);
                phi_3361_ = _e2256;
            }
            let _e2258 = phi_3361_;
            if (_e2210[0] == 4294967295u) {
                phi_3383_ = 0u;
            } else {
                if (_e2210[0] >= _e81) {
                    if (_e2210[1] >= _e86) {
                        phi_3377_ = false;
                    } else {
                        phi_3377_ = true;
                    }
                    let _e2266 = phi_3377_;
                    phi_3378_ = _e2266;
                } else {
                    phi_3378_ = true;
                }
                let _e2268 = phi_3378_;
                if _e2268 {
                    phi_3382_ = 1u;
                } else {
                    phi_3382_ = 2u;
                }
                let _e2270 = phi_3382_;
                phi_3383_ = _e2270;
            }
            let _e2272 = phi_3383_;
            if (_e2272 == 0u) {
                phi_3395_ = 0u;
            } else {
                if (_e2272 == 1u) {
                    phi_3392_ = 0u;
                } else {
                    phi_3392_ = 1u;
                }
                let _e2276 = phi_3392_;
                let _e2278 = atomicAdd((&counters[_e2276]), 1u);
                phi_3395_ = _e2278;
            }
            let _e2280 = phi_3395_;
            if (_e2208[0] == 4294967295u) {
                phi_3417_ = 0u;
            } else {
                if (_e2208[0] >= _e81) {
                    if (_e2208[1] >= _e86) {
                        phi_3411_ = false;
                    } else {
                        phi_3411_ = true;
                    }
                    let _e2288 = phi_3411_;
                    phi_3412_ = _e2288;
                } else {
                    phi_3412_ = true;
                }
                let _e2290 = phi_3412_;
                if _e2290 {
                    phi_3416_ = 1u;
                } else {
                    phi_3416_ = 2u;
                }
                let _e2292 = phi_3416_;
                phi_3417_ = _e2292;
            }
            let _e2294 = phi_3417_;
            if (_e2294 == 0u) {
                phi_3429_ = 0u;
            } else {
                if (_e2294 == 1u) {
                    phi_3426_ = 0u;
                } else {
                    phi_3426_ = 1u;
                }
                let _e2298 = phi_3426_;
                let _e2300 = atomicAdd((&counters[_e2298]), 1u);
                phi_3429_ = _e2300;
            }
            let _e2302 = phi_3429_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e2305 = atomicLoad((&counters[0u]));
                let _e2307 = atomicLoad((&counters[1u]));
                if (_e2305 > 0u) {
                    let _e2311 = atomicAdd((&levels.member[(_e68 + 1u)]), _e2305);
                    let _e2314 = atomicMax((&output.member[0u]), (_e2311 + _e2305));
                    if ((_e2311 + _e2305) < _e2311) {
                        let _e2318 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2311);
                }
                if (_e2307 > 0u) {
                    let _e2322 = atomicAdd((&pairs.member[0u]), _e2307);
                    if ((_e2322 + _e2307) < _e2322) {
                        let _e2326 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2322);
                }
            }
            workgroupBarrier();
            let _e2329 = atomicLoad((&counters[2u]));
            let _e2331 = atomicLoad((&counters[3u]));
            if (_e2214[0] == 4294967295u) {
                phi_3501_ = 0u;
            } else {
                if (_e2214[0] >= _e81) {
                    if (_e2214[1] >= _e86) {
                        phi_3495_ = false;
                    } else {
                        phi_3495_ = true;
                    }
                    let _e2339 = phi_3495_;
                    phi_3496_ = _e2339;
                } else {
                    phi_3496_ = true;
                }
                let _e2341 = phi_3496_;
                if _e2341 {
                    phi_3500_ = 1u;
                } else {
                    phi_3500_ = 2u;
                }
                let _e2343 = phi_3500_;
                phi_3501_ = _e2343;
            }
            let _e2345 = phi_3501_;
            if (_e2345 == 1u) {
                let _e2384 = params.member.member_2.member_3;
                let _e2385 = (_e2329 + _e2236);
                if (_e2385 < _e2384) {
                    let _e2387 = (2u * _e2385);
                    atomicStore((&output.member[(4u + _e2387)]), _e2214[0]);
                    atomicStore((&output.member[(_e2387 + 5u)]), _e2214[1]);
                }
            } else {
                if (_e2345 == 2u) {
                    let _e2350 = a_nodes.member[_e2214[0]];
                    let _e2354 = b_nodes.member[_e2214[1]];
                    let _e2358 = params.member.member_2.member;
                    if (_e2358 == 1u) {
                        if (_e2350.member_1 < _e2354.member_1) {
                            phi_3564_ = type_9(_e2350.member_1, _e2354.member_1);
                        } else {
                            phi_3564_ = type_9(_e2354.member_1, _e2350.member_1);
                        }
                        let _e2365 = phi_3564_;
                        phi_3569_ = _e2365;
                    } else {
                        phi_3569_ = type_9(_e2350.member_1, _e2354.member_1);
                    }
                    let _e2367 = phi_3569_;
                    let _e2370 = params.member.member_1.member_3;
                    let _e2371 = (_e2331 + _e2236);
                    if (_e2371 < _e2370) {
                        let _e2375 = (2u * _e2371);
                        atomicStore((&pairs.member[(4u + _e2375)]), _e2367.member);
                        atomicStore((&pairs.member[(_e2375 + 5u)]), _e2367.member_1);
                    }
                }
            }
            if (_e2212[0] == 4294967295u) {
                phi_3608_ = 0u;
            } else {
                if (_e2212[0] >= _e81) {
                    if (_e2212[1] >= _e86) {
                        phi_3602_ = false;
                    } else {
                        phi_3602_ = true;
                    }
                    let _e2399 = phi_3602_;
                    phi_3603_ = _e2399;
                } else {
                    phi_3603_ = true;
                }
                let _e2401 = phi_3603_;
                if _e2401 {
                    phi_3607_ = 1u;
                } else {
                    phi_3607_ = 2u;
                }
                let _e2403 = phi_3607_;
                phi_3608_ = _e2403;
            }
            let _e2405 = phi_3608_;
            if (_e2405 == 1u) {
                let _e2444 = params.member.member_2.member_3;
                let _e2445 = (_e2329 + _e2258);
                if (_e2445 < _e2444) {
                    let _e2447 = (2u * _e2445);
                    atomicStore((&output.member[(4u + _e2447)]), _e2212[0]);
                    atomicStore((&output.member[(_e2447 + 5u)]), _e2212[1]);
                }
            } else {
                if (_e2405 == 2u) {
                    let _e2410 = a_nodes.member[_e2212[0]];
                    let _e2414 = b_nodes.member[_e2212[1]];
                    let _e2418 = params.member.member_2.member;
                    if (_e2418 == 1u) {
                        if (_e2410.member_1 < _e2414.member_1) {
                            phi_3671_ = type_9(_e2410.member_1, _e2414.member_1);
                        } else {
                            phi_3671_ = type_9(_e2414.member_1, _e2410.member_1);
                        }
                        let _e2425 = phi_3671_;
                        phi_3676_ = _e2425;
                    } else {
                        phi_3676_ = type_9(_e2410.member_1, _e2414.member_1);
                    }
                    let _e2427 = phi_3676_;
                    let _e2430 = params.member.member_1.member_3;
                    let _e2431 = (_e2331 + _e2258);
                    if (_e2431 < _e2430) {
                        let _e2435 = (2u * _e2431);
                        atomicStore((&pairs.member[(4u + _e2435)]), _e2427.member);
                        atomicStore((&pairs.member[(_e2435 + 5u)]), _e2427.member_1);
                    }
                }
            }
            if (_e2210[0] == 4294967295u) {
                phi_3715_ = 0u;
            } else {
                if (_e2210[0] >= _e81) {
                    if (_e2210[1] >= _e86) {
                        phi_3709_ = false;
                    } else {
                        phi_3709_ = true;
                    }
                    let _e2459 = phi_3709_;
                    phi_3710_ = _e2459;
                } else {
                    phi_3710_ = true;
                }
                let _e2461 = phi_3710_;
                if _e2461 {
                    phi_3714_ = 1u;
                } else {
                    phi_3714_ = 2u;
                }
                let _e2463 = phi_3714_;
                phi_3715_ = _e2463;
            }
            let _e2465 = phi_3715_;
            if (_e2465 == 1u) {
                let _e2504 = params.member.member_2.member_3;
                let _e2505 = (_e2329 + _e2280);
                if (_e2505 < _e2504) {
                    let _e2507 = (2u * _e2505);
                    atomicStore((&output.member[(4u + _e2507)]), _e2210[0]);
                    atomicStore((&output.member[(_e2507 + 5u)]), _e2210[1]);
                }
            } else {
                if (_e2465 == 2u) {
                    let _e2470 = a_nodes.member[_e2210[0]];
                    let _e2474 = b_nodes.member[_e2210[1]];
                    let _e2478 = params.member.member_2.member;
                    if (_e2478 == 1u) {
                        if (_e2470.member_1 < _e2474.member_1) {
                            phi_3778_ = type_9(_e2470.member_1, _e2474.member_1);
                        } else {
                            phi_3778_ = type_9(_e2474.member_1, _e2470.member_1);
                        }
                        let _e2485 = phi_3778_;
                        phi_3783_ = _e2485;
                    } else {
                        phi_3783_ = type_9(_e2470.member_1, _e2474.member_1);
                    }
                    let _e2487 = phi_3783_;
                    let _e2490 = params.member.member_1.member_3;
                    let _e2491 = (_e2331 + _e2280);
                    if (_e2491 < _e2490) {
                        let _e2495 = (2u * _e2491);
                        atomicStore((&pairs.member[(4u + _e2495)]), _e2487.member);
                        atomicStore((&pairs.member[(_e2495 + 5u)]), _e2487.member_1);
                    }
                }
            }
            if (_e2208[0] == 4294967295u) {
                phi_3822_ = 0u;
            } else {
                if (_e2208[0] >= _e81) {
                    if (_e2208[1] >= _e86) {
                        phi_3816_ = false;
                    } else {
                        phi_3816_ = true;
                    }
                    let _e2519 = phi_3816_;
                    phi_3817_ = _e2519;
                } else {
                    phi_3817_ = true;
                }
                let _e2521 = phi_3817_;
                if _e2521 {
                    phi_3821_ = 1u;
                } else {
                    phi_3821_ = 2u;
                }
                let _e2523 = phi_3821_;
                phi_3822_ = _e2523;
            }
            let _e2525 = phi_3822_;
            if (_e2525 == 1u) {
                let _e2564 = params.member.member_2.member_3;
                let _e2565 = (_e2329 + _e2302);
                if (_e2565 < _e2564) {
                    let _e2567 = (2u * _e2565);
                    atomicStore((&output.member[(4u + _e2567)]), _e2208[0]);
                    atomicStore((&output.member[(_e2567 + 5u)]), _e2208[1]);
                }
            } else {
                if (_e2525 == 2u) {
                    let _e2530 = a_nodes.member[_e2208[0]];
                    let _e2534 = b_nodes.member[_e2208[1]];
                    let _e2538 = params.member.member_2.member;
                    if (_e2538 == 1u) {
                        if (_e2530.member_1 < _e2534.member_1) {
                            phi_3885_ = type_9(_e2530.member_1, _e2534.member_1);
                        } else {
                            phi_3885_ = type_9(_e2534.member_1, _e2530.member_1);
                        }
                        let _e2545 = phi_3885_;
                        phi_3890_ = _e2545;
                    } else {
                        phi_3890_ = type_9(_e2530.member_1, _e2534.member_1);
                    }
                    let _e2547 = phi_3890_;
                    let _e2550 = params.member.member_1.member_3;
                    let _e2551 = (_e2331 + _e2302);
                    if (_e2551 < _e2550) {
                        let _e2555 = (2u * _e2551);
                        atomicStore((&pairs.member[(4u + _e2555)]), _e2547.member);
                        atomicStore((&pairs.member[(_e2555 + 5u)]), _e2547.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_216_ = _e127;
            break if !(_e133);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
