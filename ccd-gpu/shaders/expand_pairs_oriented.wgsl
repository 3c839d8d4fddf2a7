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
    member_18: u32,
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

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> oriented: type_28;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(6) 
var<storage, read_write> output: type_32;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_32;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(5) 
var<storage, read_write> levels: type_32;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var local_1: array<array<u32, 2>, 4>;
    var phi_159_: array<u32, 2>;
    var phi_197_: u32;
    var phi_217_: u32;
    var phi_220_: type_9;
    var phi_221_: type_9;
    var phi_244_: type_9;
    var phi_297_: u32;
    var phi_369_: array<u32, 2>;
    var phi_383_: array<u32, 2>;
    var phi_420_: array<u32, 2>;
    var phi_422_: type_22;
    var phi_423_: type_22;
    var phi_424_: bool;
    var phi_425_: type_22;
    var phi_426_: bool;
    var phi_442_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_597_: array<u32, 2>;
    var phi_626_: array<u32, 2>;
    var phi_655_: array<u32, 2>;
    var phi_684_: array<u32, 2>;
    var phi_686_: type_22;
    var phi_687_: bool;
    var phi_688_: type_22;
    var phi_689_: bool;
    var phi_862_: array<u32, 2>;
    var phi_894_: array<u32, 2>;
    var phi_762_: array<u32, 2>;
    var phi_794_: array<u32, 2>;
    var phi_896_: type_22;
    var phi_897_: type_22;
    var phi_898_: type_22;
    var phi_899_: bool;
    var phi_900_: type_22;
    var phi_901_: type_22;
    var phi_902_: bool;
    var phi_906_: type_22;
    var phi_924_: array<u32, 2>;
    var phi_955_: array<u32, 2>;
    var phi_1000_: type_9;
    var phi_1001_: type_9;
    var phi_1024_: type_9;
    var phi_1053_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1139_: f32;
    var phi_1145_: f32;
    var phi_1151_: f32;
    var phi_1157_: f32;
    var phi_1163_: f32;
    var phi_1169_: f32;
    var phi_1187_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1213_: type_29;
    var phi_1283_: f32;
    var phi_1289_: f32;
    var phi_1295_: f32;
    var phi_1301_: f32;
    var phi_1307_: f32;
    var phi_1313_: f32;
    var phi_1331_: f32;
    var phi_1336_: f32;
    var phi_1341_: f32;
    var phi_1357_: type_29;
    var phi_1547_: f32;
    var phi_1553_: f32;
    var phi_1560_: f32;
    var phi_1569_: f32;
    var phi_1576_: f32;
    var phi_1584_: f32;
    var phi_1593_: f32;
    var phi_1600_: f32;
    var phi_1608_: f32;
    var phi_1701_: f32;
    var phi_1708_: f32;
    var phi_1714_: f32;
    var phi_1720_: f32;
    var phi_1739_: f32;
    var phi_1746_: f32;
    var phi_1752_: f32;
    var phi_1758_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1790_: f32;
    var phi_1796_: f32;
    var phi_1815_: f32;
    var phi_1822_: f32;
    var phi_1828_: f32;
    var phi_1834_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1866_: f32;
    var phi_1872_: f32;
    var phi_1891_: f32;
    var phi_1898_: f32;
    var phi_1904_: f32;
    var phi_1910_: f32;
    var phi_1925_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1945_: f32;
    var phi_2004_: f32;
    var phi_2027_: f32;
    var phi_2050_: f32;
    var phi_2072_: f32;
    var phi_2088_: f32;
    var phi_2143_: f32;
    var phi_2166_: f32;
    var phi_2189_: f32;
    var phi_2211_: f32;
    var phi_2227_: f32;
    var phi_2282_: f32;
    var phi_2305_: f32;
    var phi_2328_: f32;
    var phi_2350_: f32;
    var phi_2366_: f32;
    var phi_2421_: f32;
    var phi_2444_: f32;
    var phi_2468_: f32;
    var phi_2491_: f32;
    var phi_2507_: f32;
    var phi_2562_: f32;
    var phi_2585_: f32;
    var phi_2609_: f32;
    var phi_2632_: f32;
    var phi_2648_: f32;
    var phi_2703_: f32;
    var phi_2726_: f32;
    var phi_2750_: f32;
    var phi_2773_: f32;
    var phi_2789_: f32;
    var phi_2844_: f32;
    var phi_2867_: f32;
    var phi_2891_: f32;
    var phi_2914_: f32;
    var phi_2930_: f32;
    var phi_2985_: f32;
    var phi_3008_: f32;
    var phi_3032_: f32;
    var phi_3055_: f32;
    var phi_3071_: f32;
    var phi_3126_: f32;
    var phi_3149_: f32;
    var phi_3173_: f32;
    var phi_3196_: f32;
    var phi_3212_: f32;
    var phi_3219_: f32;
    var phi_3224_: f32;
    var phi_3229_: f32;
    var phi_3234_: f32;
    var phi_3239_: f32;
    var phi_3244_: f32;
    var phi_3249_: f32;
    var phi_3254_: f32;
    var phi_3258_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3267_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var phi_3316_: u32;
    var phi_3317_: u32;
    var phi_3323_: array<u32, 2>;
    var phi_3324_: array<u32, 2>;
    var phi_3325_: array<u32, 2>;
    var phi_3326_: array<u32, 2>;
    var phi_3327_: array<u32, 2>;
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
    var phi_3445_: bool;
    var phi_3446_: bool;
    var phi_3450_: u32;
    var phi_3451_: u32;
    var phi_3460_: u32;
    var phi_3463_: u32;
    var phi_3529_: bool;
    var phi_3530_: bool;
    var phi_3534_: u32;
    var phi_3535_: u32;
    var phi_3609_: type_9;
    var phi_3614_: type_9;
    var phi_3643_: bool;
    var phi_3644_: bool;
    var phi_3648_: u32;
    var phi_3649_: u32;
    var phi_3723_: type_9;
    var phi_3728_: type_9;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3762_: u32;
    var phi_3763_: u32;
    var phi_3837_: type_9;
    var phi_3842_: type_9;
    var phi_3871_: bool;
    var phi_3872_: bool;
    var phi_3876_: u32;
    var phi_3877_: u32;
    var phi_3951_: type_9;
    var phi_3956_: type_9;
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
    let _e65 = params.member.member_1.member_1;
    let _e68 = params.member.member_2.member;
    if (_e68 == 0u) {
        phi_159_ = array<u32, 2>(0u, 2u);
    } else {
        phi_159_ = array<u32, 2>(1u, 1u);
    }
    let _e71 = phi_159_;
    let _e77 = params.member.member.member[_e71[0]];
    let _e78 = (_e77 - 1u);
    let _e82 = params.member.member.member[_e71[1]];
    let _e83 = (_e82 - 1u);
    let _e85 = atomicLoad((&levels.member[_e65]));
    let _e88 = params.member.member_1.member_2;
    if (_e88 < _e85) {
        phi_197_ = _e88;
    } else {
        phi_197_ = _e85;
    }
    let _e91 = phi_197_;
    let _e94 = params.member.member_1.member_2;
    let _e95 = (_e62 * 128u);
    if (_e95 == 0u) {
        return;
    }
    let _e97 = (_e94 / _e95);
    if (_e95 == 0u) {
        return;
    }
    if ((_e94 % _e95) > 0u) {
        phi_217_ = (_e97 + 1u);
    } else {
        phi_217_ = _e97;
    }
    let _e103 = phi_217_;
    phi_220_ = type_9(0u, _e103);
    loop {
        let _e106 = phi_220_;
        if (_e106.member < _e106.member_1) {
            phi_221_ = type_9((_e106.member + 1u), _e106.member_1);
            phi_244_ = type_9(1u, _e106.member);
        } else {
            phi_221_ = _e106;
            phi_244_ = type_9(0u, type_9().member_1);
        }
        let _e118 = phi_221_;
        let _e120 = phi_244_;
        let _e124 = (bitcast<i32>(_e120.member) != 0i);
        if _e124 {
            let _e128 = (((((_e44.y * _e45.x) + _e44.x) + (_e120.member_1 * _e62)) * 128u) + _e46);
            if (_e46 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e128 < _e91) {
                let _e133 = (2u * _e128);
                let _e136 = input.member[(4u + _e133)];
                let _e139 = input.member[(_e133 + 5u)];
                let _e142 = params.member.member_2.member_1;
                if (_e142 == 0u) {
                    phi_297_ = 1u;
                } else {
                    phi_297_ = 0u;
                }
                let _e145 = phi_297_;
                let _e148 = params.member.member_2.member;
                let _e151 = a_nodes.member[_e136];
                let _e153 = b_nodes.member[_e139];
                if (_e148 == 1u) {
                    if (_e136 == _e139) {
                        if (_e151.member_3 == 4294967295u) {
                            phi_422_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e159 = a_nodes.member[_e151.member_1];
                            let _e162 = a_nodes.member[_e151.member_3];
                            if !((_e159.member_3 == 4294967295u)) {
                                phi_369_ = array<u32, 2>(_e151.member_1, _e151.member_1);
                            } else {
                                phi_369_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e169 = phi_369_;
                            let _e176 = type_22(array<array<u32, 2>, 4>(_e169, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e188 = type_22(array<array<u32, 2>, 4>(_e176.member[0], array<u32, 2>(_e151.member_1, _e176.member[1][1]), _e176.member[2], _e176.member[3]), _e176.member_1);
                            let _e189 = array<u32, 2>(_e151.member_1, _e151.member_3);
                            let _e196 = type_22(array<array<u32, 2>, 4>(_e188.member[0], _e189, _e188.member[2], _e188.member[3]), _e188.member_1);
                            if !((_e162.member_3 == 4294967295u)) {
                                phi_383_ = array<u32, 2>(_e151.member_3, _e151.member_3);
                            } else {
                                phi_383_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e203 = phi_383_;
                            let _e210 = type_22(array<array<u32, 2>, 4>(_e196.member[0], _e196.member[1], _e203, _e196.member[3]), _e196.member_1);
                            let _e213 = type_22(_e210.member, _e210.member);
                            if ((((((_e159.member[0] <= _e162.member_2[0]) && (_e162.member[0] <= _e159.member_2[0])) && (_e159.member[1] <= _e162.member_2[1])) && (_e162.member[1] <= _e159.member_2[1])) && (_e159.member[2] <= _e162.member_2[2])) && (_e162.member[2] <= _e159.member_2[2])) {
                                phi_420_ = _e189;
                            } else {
                                phi_420_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e242 = phi_420_;
                            phi_422_ = type_22(_e213.member, array<array<u32, 2>, 4>(_e213.member_1[0], _e242, _e213.member_1[2], _e213.member_1[3]));
                        }
                        let _e251 = phi_422_;
                        phi_423_ = _e251;
                        phi_424_ = false;
                    } else {
                        phi_423_ = type_22();
                        phi_424_ = true;
                    }
                    let _e253 = phi_423_;
                    let _e255 = phi_424_;
                    phi_425_ = _e253;
                    phi_426_ = _e255;
                } else {
                    phi_425_ = type_22();
                    phi_426_ = true;
                }
                let _e257 = phi_425_;
                let _e259 = phi_426_;
                if _e259 {
                    let _e262 = !((_e151.member_3 == 4294967295u));
                    let _e265 = !((_e153.member_3 == 4294967295u));
                    if _e262 {
                        phi_442_ = true;
                    } else {
                        phi_442_ = _e265;
                    }
                    let _e267 = phi_442_;
                    if _e267 {
                        if _e262 {
                            if _e265 {
                                if (_e145 == 0u) {
                                    let _e295 = ((((_e153.member_2[0] - _e153.member[0]) * (_e153.member_2[1] - _e153.member[1])) * (_e153.member_2[2] - _e153.member[2])) > (((_e151.member_2[0] - _e151.member[0]) * (_e151.member_2[1] - _e151.member[1])) * (_e151.member_2[2] - _e151.member[2])));
                                    phi_486_ = _e295;
                                    phi_487_ = !(_e295);
                                } else {
                                    phi_486_ = _e265;
                                    phi_487_ = _e262;
                                }
                                let _e298 = phi_486_;
                                let _e300 = phi_487_;
                                phi_488_ = _e298;
                                phi_489_ = _e300;
                            } else {
                                phi_488_ = _e265;
                                phi_489_ = _e262;
                            }
                            let _e302 = phi_488_;
                            let _e304 = phi_489_;
                            phi_490_ = _e302;
                            phi_491_ = _e304;
                        } else {
                            phi_490_ = _e265;
                            phi_491_ = _e262;
                        }
                        let _e306 = phi_490_;
                        let _e308 = phi_491_;
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
                                    phi_597_ = _e331;
                                } else {
                                    phi_597_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e366 = phi_597_;
                                if ((((((_e311.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e311.member_2[0])) && (_e311.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e311.member_2[1])) && (_e311.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e311.member_2[2])) {
                                    phi_626_ = _e334;
                                } else {
                                    phi_626_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e391 = phi_626_;
                                if ((((((_e316.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e316.member_2[2])) {
                                    phi_655_ = _e337;
                                } else {
                                    phi_655_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e416 = phi_655_;
                                if ((((((_e316.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e316.member_2[0])) && (_e316.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e316.member_2[1])) && (_e316.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e316.member_2[2])) {
                                    phi_684_ = _e340;
                                } else {
                                    phi_684_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e441 = phi_684_;
                                phi_686_ = type_22(array<array<u32, 2>, 4>(_e331, _e334, _e337, _e340), array<array<u32, 2>, 4>(_e366, _e391, _e416, _e441));
                                phi_687_ = false;
                            } else {
                                phi_686_ = type_22();
                                phi_687_ = true;
                            }
                            let _e445 = phi_686_;
                            let _e447 = phi_687_;
                            phi_688_ = _e445;
                            phi_689_ = _e447;
                        } else {
                            phi_688_ = type_22();
                            phi_689_ = true;
                        }
                        let _e449 = phi_688_;
                        let _e451 = phi_689_;
                        if _e451 {
                            if _e308 {
                                let _e536 = a_nodes.member[_e151.member_1];
                                let _e541 = a_nodes.member[_e151.member_3];
                                if ((((((_e536.member[0] <= _e153.member_2[0]) && (_e153.member[0] <= _e536.member_2[0])) && (_e536.member[1] <= _e153.member_2[1])) && (_e153.member[1] <= _e536.member_2[1])) && (_e536.member[2] <= _e153.member_2[2])) && (_e153.member[2] <= _e536.member_2[2])) {
                                    phi_762_ = array<u32, 2>(_e151.member_1, _e139);
                                } else {
                                    phi_762_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e574 = phi_762_;
                                let _e581 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e574, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e541.member[0] <= _e153.member_2[0]) && (_e153.member[0] <= _e541.member_2[0])) && (_e541.member[1] <= _e153.member_2[1])) && (_e153.member[1] <= _e541.member_2[1])) && (_e541.member[2] <= _e153.member_2[2])) && (_e153.member[2] <= _e541.member_2[2])) {
                                    phi_794_ = array<u32, 2>(_e151.member_3, _e139);
                                } else {
                                    phi_794_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e608 = phi_794_;
                                phi_896_ = type_22(_e581.member, array<array<u32, 2>, 4>(_e581.member_1[0], _e608, _e581.member_1[2], _e581.member_1[3]));
                            } else {
                                let _e454 = b_nodes.member[_e153.member_1];
                                let _e459 = b_nodes.member[_e153.member_3];
                                if ((((((_e151.member[0] <= _e454.member_2[0]) && (_e454.member[0] <= _e151.member_2[0])) && (_e151.member[1] <= _e454.member_2[1])) && (_e454.member[1] <= _e151.member_2[1])) && (_e151.member[2] <= _e454.member_2[2])) && (_e454.member[2] <= _e151.member_2[2])) {
                                    phi_862_ = array<u32, 2>(_e136, _e153.member_1);
                                } else {
                                    phi_862_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e492 = phi_862_;
                                let _e499 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e492, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e151.member[0] <= _e459.member_2[0]) && (_e459.member[0] <= _e151.member_2[0])) && (_e151.member[1] <= _e459.member_2[1])) && (_e459.member[1] <= _e151.member_2[1])) && (_e151.member[2] <= _e459.member_2[2])) && (_e459.member[2] <= _e151.member_2[2])) {
                                    phi_894_ = array<u32, 2>(_e136, _e153.member_3);
                                } else {
                                    phi_894_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e526 = phi_894_;
                                phi_896_ = type_22(_e499.member, array<array<u32, 2>, 4>(_e499.member_1[0], _e526, _e499.member_1[2], _e499.member_1[3]));
                            }
                            let _e617 = phi_896_;
                            phi_897_ = _e617;
                        } else {
                            phi_897_ = _e449;
                        }
                        let _e619 = phi_897_;
                        phi_898_ = _e619;
                        phi_899_ = false;
                    } else {
                        phi_898_ = type_22();
                        phi_899_ = true;
                    }
                    let _e621 = phi_898_;
                    let _e623 = phi_899_;
                    phi_900_ = _e621;
                    phi_901_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_902_ = _e623;
                } else {
                    phi_900_ = type_22();
                    phi_901_ = _e257;
                    phi_902_ = true;
                }
                let _e625 = phi_900_;
                let _e627 = phi_901_;
                let _e629 = phi_902_;
                if _e629 {
                    phi_906_ = _e627;
                } else {
                    phi_906_ = _e625;
                }
                let _e631 = phi_906_;
                let _e635 = params.member.member_2.member;
                if (_e635 == 0u) {
                    phi_924_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_924_ = array<u32, 2>(1u, 1u);
                }
                let _e638 = phi_924_;
                let _e644 = params.member.member.member[_e638[0]];
                let _e645 = (_e644 - 1u);
                let _e649 = params.member.member.member[_e638[1]];
                let _e650 = (_e649 - 1u);
                let _e653 = params.member.member_2.member;
                if (_e653 == 0u) {
                    phi_955_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_955_ = array<u32, 2>(1u, 1u);
                }
                let _e656 = phi_955_;
                let _e662 = params.member.member.member_2[_e656[0]];
                let _e666 = params.member.member.member_2[_e656[1]];
                let _e669 = params.member.member_2.member;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e631.member_1[0][0], _e631.member_1[0][1]), array<u32, 2>(_e631.member_1[1][0], _e631.member_1[1][1]), array<u32, 2>(_e631.member_1[2][0], _e631.member_1[2][1]), array<u32, 2>(_e631.member_1[3][0], _e631.member_1[3][1]));
                phi_1000_ = type_9(0u, 4u);
                loop {
                    let _e689 = phi_1000_;
                    if (_e689.member < _e689.member_1) {
                        phi_1001_ = type_9((_e689.member + 1u), _e689.member_1);
                        phi_1024_ = type_9(1u, _e689.member);
                    } else {
                        phi_1001_ = _e689;
                        phi_1024_ = type_9(0u, type_9().member_1);
                    }
                    let _e701 = phi_1001_;
                    let _e703 = phi_1024_;
                    let _e707 = (bitcast<i32>(_e703.member) != 0i);
                    if _e707 {
                        let _e709 = local_1[_e703.member_1];
                        if (_e709[0] != 4294967295u) {
                            if (_e669 == 1u) {
                                phi_1053_ = (_e709[0] == _e709[1]);
                            } else {
                                phi_1053_ = false;
                            }
                            let _e715 = phi_1053_;
                            if _e715 {
                                phi_3262_ = bool();
                                phi_3263_ = true;
                            } else {
                                if (_e709[0] >= _e645) {
                                    if (_e709[1] >= _e650) {
                                        phi_1065_ = false;
                                    } else {
                                        phi_1065_ = true;
                                    }
                                    let _e719 = phi_1065_;
                                    phi_1066_ = _e719;
                                } else {
                                    phi_1066_ = true;
                                }
                                let _e721 = phi_1066_;
                                if _e721 {
                                    if (_e709[0] < _e645) {
                                        let _e801 = oriented.member[(_e662 + _e709[0])];
                                        phi_1213_ = type_29(array<f32, 3>(_e801.member.x, _e801.member.y, _e801.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e801.member.w, _e801.member_1.x, _e801.member_1.y), array<f32, 3>(_e801.member_1.z, _e801.member_1.w, _e801.member_2.x), array<f32, 3>(_e801.member_2.y, _e801.member_2.z, _e801.member_2.w)), array<f32, 3>(_e801.member_3.x, _e801.member_3.y, _e801.member_3.z));
                                    } else {
                                        let _e724 = a_nodes.member[_e709[0]];
                                        let _e739 = ((_e724.member[0] * 0.5f) + (_e724.member_2[0] * 0.5f));
                                        let _e740 = ((_e724.member[1] * 0.5f) + (_e724.member_2[1] * 0.5f));
                                        let _e741 = ((_e724.member[2] * 0.5f) + (_e724.member_2[2] * 0.5f));
                                        if (_e739 < _e724.member_2[0]) {
                                            phi_1139_ = _e739;
                                        } else {
                                            phi_1139_ = _e724.member_2[0];
                                        }
                                        let _e745 = phi_1139_;
                                        if (_e740 < _e724.member_2[1]) {
                                            phi_1145_ = _e740;
                                        } else {
                                            phi_1145_ = _e724.member_2[1];
                                        }
                                        let _e749 = phi_1145_;
                                        if (_e741 < _e724.member_2[2]) {
                                            phi_1151_ = _e741;
                                        } else {
                                            phi_1151_ = _e724.member_2[2];
                                        }
                                        let _e753 = phi_1151_;
                                        if (_e745 > _e724.member[0]) {
                                            phi_1157_ = _e745;
                                        } else {
                                            phi_1157_ = _e724.member[0];
                                        }
                                        let _e757 = phi_1157_;
                                        if (_e749 > _e724.member[1]) {
                                            phi_1163_ = _e749;
                                        } else {
                                            phi_1163_ = _e724.member[1];
                                        }
                                        let _e761 = phi_1163_;
                                        if (_e753 > _e724.member[2]) {
                                            phi_1169_ = _e753;
                                        } else {
                                            phi_1169_ = _e724.member[2];
                                        }
                                        let _e765 = phi_1169_;
                                        let _e768 = (_e724.member_2[0] - _e757);
                                        let _e770 = (_e724.member_2[1] - _e761);
                                        let _e772 = (_e724.member_2[2] - _e765);
                                        let _e774 = (_e757 - _e724.member[0]);
                                        let _e776 = (_e761 - _e724.member[1]);
                                        let _e778 = (_e765 - _e724.member[2]);
                                        if (_e768 > _e774) {
                                            phi_1187_ = _e768;
                                        } else {
                                            phi_1187_ = _e774;
                                        }
                                        let _e781 = phi_1187_;
                                        if (_e770 > _e776) {
                                            phi_1192_ = _e770;
                                        } else {
                                            phi_1192_ = _e776;
                                        }
                                        let _e784 = phi_1192_;
                                        if (_e772 > _e778) {
                                            phi_1197_ = _e772;
                                        } else {
                                            phi_1197_ = _e778;
                                        }
                                        let _e787 = phi_1197_;
                                        let _e789 = (1f + (0.000000059604645f * 4f));
                                        let _e793 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1213_ = type_29(array<f32, 3>(_e757, _e761, _e765), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e781 * _e789) + _e793), ((_e784 * _e789) + _e793), ((_e787 * _e789) + _e793)));
                                    }
                                    let _e840 = phi_1213_;
                                    if (_e709[1] < _e650) {
                                        let _e920 = oriented.member[(_e666 + _e709[1])];
                                        phi_1357_ = type_29(array<f32, 3>(_e920.member.x, _e920.member.y, _e920.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e920.member.w, _e920.member_1.x, _e920.member_1.y), array<f32, 3>(_e920.member_1.z, _e920.member_1.w, _e920.member_2.x), array<f32, 3>(_e920.member_2.y, _e920.member_2.z, _e920.member_2.w)), array<f32, 3>(_e920.member_3.x, _e920.member_3.y, _e920.member_3.z));
                                    } else {
                                        let _e843 = b_nodes.member[_e709[1]];
                                        let _e858 = ((_e843.member[0] * 0.5f) + (_e843.member_2[0] * 0.5f));
                                        let _e859 = ((_e843.member[1] * 0.5f) + (_e843.member_2[1] * 0.5f));
                                        let _e860 = ((_e843.member[2] * 0.5f) + (_e843.member_2[2] * 0.5f));
                                        if (_e858 < _e843.member_2[0]) {
                                            phi_1283_ = _e858;
                                        } else {
                                            phi_1283_ = _e843.member_2[0];
                                        }
                                        let _e864 = phi_1283_;
                                        if (_e859 < _e843.member_2[1]) {
                                            phi_1289_ = _e859;
                                        } else {
                                            phi_1289_ = _e843.member_2[1];
                                        }
                                        let _e868 = phi_1289_;
                                        if (_e860 < _e843.member_2[2]) {
                                            phi_1295_ = _e860;
                                        } else {
                                            phi_1295_ = _e843.member_2[2];
                                        }
                                        let _e872 = phi_1295_;
                                        if (_e864 > _e843.member[0]) {
                                            phi_1301_ = _e864;
                                        } else {
                                            phi_1301_ = _e843.member[0];
                                        }
                                        let _e876 = phi_1301_;
                                        if (_e868 > _e843.member[1]) {
                                            phi_1307_ = _e868;
                                        } else {
                                            phi_1307_ = _e843.member[1];
                                        }
                                        let _e880 = phi_1307_;
                                        if (_e872 > _e843.member[2]) {
                                            phi_1313_ = _e872;
                                        } else {
                                            phi_1313_ = _e843.member[2];
                                        }
                                        let _e884 = phi_1313_;
                                        let _e887 = (_e843.member_2[0] - _e876);
                                        let _e889 = (_e843.member_2[1] - _e880);
                                        let _e891 = (_e843.member_2[2] - _e884);
                                        let _e893 = (_e876 - _e843.member[0]);
                                        let _e895 = (_e880 - _e843.member[1]);
                                        let _e897 = (_e884 - _e843.member[2]);
                                        if (_e887 > _e893) {
                                            phi_1331_ = _e887;
                                        } else {
                                            phi_1331_ = _e893;
                                        }
                                        let _e900 = phi_1331_;
                                        if (_e889 > _e895) {
                                            phi_1336_ = _e889;
                                        } else {
                                            phi_1336_ = _e895;
                                        }
                                        let _e903 = phi_1336_;
                                        if (_e891 > _e897) {
                                            phi_1341_ = _e891;
                                        } else {
                                            phi_1341_ = _e897;
                                        }
                                        let _e906 = phi_1341_;
                                        let _e908 = (1f + (0.000000059604645f * 4f));
                                        let _e912 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1357_ = type_29(array<f32, 3>(_e876, _e880, _e884), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e900 * _e908) + _e912), ((_e903 * _e908) + _e912), ((_e906 * _e908) + _e912)));
                                    }
                                    let _e959 = phi_1357_;
                                    let _e964 = (_e959.member[0] - _e840.member[0]);
                                    let _e967 = (_e959.member[1] - _e840.member[1]);
                                    let _e970 = (_e959.member[2] - _e840.member[2]);
                                    if (_e964 < 0f) {
                                        phi_1547_ = -(_e964);
                                    } else {
                                        phi_1547_ = _e964;
                                    }
                                    let _e1159 = phi_1547_;
                                    if (_e967 < 0f) {
                                        phi_1553_ = -(_e967);
                                    } else {
                                        phi_1553_ = _e967;
                                    }
                                    let _e1163 = phi_1553_;
                                    if (_e970 < 0f) {
                                        phi_1560_ = -(_e970);
                                    } else {
                                        phi_1560_ = _e970;
                                    }
                                    let _e1168 = phi_1560_;
                                    if (_e840.member_2[0] < 0f) {
                                        phi_1569_ = -(_e840.member_2[0]);
                                    } else {
                                        phi_1569_ = _e840.member_2[0];
                                    }
                                    let _e1175 = phi_1569_;
                                    if (_e840.member_2[1] < 0f) {
                                        phi_1576_ = -(_e840.member_2[1]);
                                    } else {
                                        phi_1576_ = _e840.member_2[1];
                                    }
                                    let _e1180 = phi_1576_;
                                    if (_e840.member_2[2] < 0f) {
                                        phi_1584_ = -(_e840.member_2[2]);
                                    } else {
                                        phi_1584_ = _e840.member_2[2];
                                    }
                                    let _e1186 = phi_1584_;
                                    if (_e959.member_2[0] < 0f) {
                                        phi_1593_ = -(_e959.member_2[0]);
                                    } else {
                                        phi_1593_ = _e959.member_2[0];
                                    }
                                    let _e1193 = phi_1593_;
                                    if (_e959.member_2[1] < 0f) {
                                        phi_1600_ = -(_e959.member_2[1]);
                                    } else {
                                        phi_1600_ = _e959.member_2[1];
                                    }
                                    let _e1198 = phi_1600_;
                                    if (_e959.member_2[2] < 0f) {
                                        phi_1608_ = -(_e959.member_2[2]);
                                    } else {
                                        phi_1608_ = _e959.member_2[2];
                                    }
                                    let _e1204 = phi_1608_;
                                    local = type_24(array<array<f32, 3>, 3>(array<f32, 3>((((_e959.member_1[0][0] * _e840.member_1[0][0]) + (_e959.member_1[0][1] * _e840.member_1[0][1])) + (_e959.member_1[0][2] * _e840.member_1[0][2])), (((_e959.member_1[1][0] * _e840.member_1[0][0]) + (_e959.member_1[1][1] * _e840.member_1[0][1])) + (_e959.member_1[1][2] * _e840.member_1[0][2])), (((_e959.member_1[2][0] * _e840.member_1[0][0]) + (_e959.member_1[2][1] * _e840.member_1[0][1])) + (_e959.member_1[2][2] * _e840.member_1[0][2]))), array<f32, 3>((((_e959.member_1[0][0] * _e840.member_1[1][0]) + (_e959.member_1[0][1] * _e840.member_1[1][1])) + (_e959.member_1[0][2] * _e840.member_1[1][2])), (((_e959.member_1[1][0] * _e840.member_1[1][0]) + (_e959.member_1[1][1] * _e840.member_1[1][1])) + (_e959.member_1[1][2] * _e840.member_1[1][2])), (((_e959.member_1[2][0] * _e840.member_1[1][0]) + (_e959.member_1[2][1] * _e840.member_1[1][1])) + (_e959.member_1[2][2] * _e840.member_1[1][2]))), array<f32, 3>((((_e959.member_1[0][0] * _e840.member_1[2][0]) + (_e959.member_1[0][1] * _e840.member_1[2][1])) + (_e959.member_1[0][2] * _e840.member_1[2][2])), (((_e959.member_1[1][0] * _e840.member_1[2][0]) + (_e959.member_1[1][1] * _e840.member_1[2][1])) + (_e959.member_1[1][2] * _e840.member_1[2][2])), (((_e959.member_1[2][0] * _e840.member_1[2][0]) + (_e959.member_1[2][1] * _e840.member_1[2][1])) + (_e959.member_1[2][2] * _e840.member_1[2][2])))), array<f32, 3>((((_e840.member_1[0][0] * _e964) + (_e840.member_1[0][1] * _e967)) + (_e840.member_1[0][2] * _e970)), (((_e840.member_1[1][0] * _e964) + (_e840.member_1[1][1] * _e967)) + (_e840.member_1[1][2] * _e970)), (((_e840.member_1[2][0] * _e964) + (_e840.member_1[2][1] * _e967)) + (_e840.member_1[2][2] * _e970))), array<f32, 3>((((_e959.member_1[0][0] * _e964) + (_e959.member_1[0][1] * _e967)) + (_e959.member_1[0][2] * _e970)), (((_e959.member_1[1][0] * _e964) + (_e959.member_1[1][1] * _e967)) + (_e959.member_1[1][2] * _e970)), (((_e959.member_1[2][0] * _e964) + (_e959.member_1[2][1] * _e967)) + (_e959.member_1[2][2] * _e970))), array<f32, 3>(_e840.member_2[0], _e840.member_2[1], _e840.member_2[2]), array<f32, 3>(_e959.member_2[0], _e959.member_2[1], _e959.member_2[2]), ((((((_e1159 + _e1163) + _e1168) + (((_e1175 + _e1180) + _e1186) + ((_e1193 + _e1198) + _e1204))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1231 = local.member[0u][0u];
                                    let _e1235 = local.member[0u][1u];
                                    let _e1239 = local.member[0u][2u];
                                    let _e1243 = local.member[1u][0u];
                                    let _e1247 = local.member[1u][1u];
                                    let _e1251 = local.member[1u][2u];
                                    let _e1255 = local.member[2u][0u];
                                    let _e1259 = local.member[2u][1u];
                                    let _e1263 = local.member[2u][2u];
                                    let _e1265 = local.member_3;
                                    let _e1270 = local.member_4;
                                    let _e1276 = local.member_1[0u];
                                    if (_e1276 < 0f) {
                                        phi_1701_ = -(_e1276);
                                    } else {
                                        phi_1701_ = _e1276;
                                    }
                                    let _e1280 = phi_1701_;
                                    if (_e1231 < 0f) {
                                        phi_1708_ = -(_e1231);
                                    } else {
                                        phi_1708_ = _e1231;
                                    }
                                    let _e1284 = phi_1708_;
                                    if (_e1235 < 0f) {
                                        phi_1714_ = -(_e1235);
                                    } else {
                                        phi_1714_ = _e1235;
                                    }
                                    let _e1288 = phi_1714_;
                                    if (_e1239 < 0f) {
                                        phi_1720_ = -(_e1239);
                                    } else {
                                        phi_1720_ = _e1239;
                                    }
                                    let _e1292 = phi_1720_;
                                    let _e1299 = (_e1280 - (_e1265[0] + (((_e1284 * _e1270[0]) + (_e1288 * _e1270[1])) + (_e1292 * _e1270[2]))));
                                    let _e1302 = local.member_1[1u];
                                    if (_e1302 < 0f) {
                                        phi_1739_ = -(_e1302);
                                    } else {
                                        phi_1739_ = _e1302;
                                    }
                                    let _e1306 = phi_1739_;
                                    if (_e1243 < 0f) {
                                        phi_1746_ = -(_e1243);
                                    } else {
                                        phi_1746_ = _e1243;
                                    }
                                    let _e1310 = phi_1746_;
                                    if (_e1247 < 0f) {
                                        phi_1752_ = -(_e1247);
                                    } else {
                                        phi_1752_ = _e1247;
                                    }
                                    let _e1314 = phi_1752_;
                                    if (_e1251 < 0f) {
                                        phi_1758_ = -(_e1251);
                                    } else {
                                        phi_1758_ = _e1251;
                                    }
                                    let _e1318 = phi_1758_;
                                    let _e1325 = (_e1306 - (_e1265[1] + (((_e1310 * _e1270[0]) + (_e1314 * _e1270[1])) + (_e1318 * _e1270[2]))));
                                    let _e1328 = local.member_1[2u];
                                    if (_e1328 < 0f) {
                                        phi_1777_ = -(_e1328);
                                    } else {
                                        phi_1777_ = _e1328;
                                    }
                                    let _e1332 = phi_1777_;
                                    if (_e1255 < 0f) {
                                        phi_1784_ = -(_e1255);
                                    } else {
                                        phi_1784_ = _e1255;
                                    }
                                    let _e1336 = phi_1784_;
                                    if (_e1259 < 0f) {
                                        phi_1790_ = -(_e1259);
                                    } else {
                                        phi_1790_ = _e1259;
                                    }
                                    let _e1340 = phi_1790_;
                                    if (_e1263 < 0f) {
                                        phi_1796_ = -(_e1263);
                                    } else {
                                        phi_1796_ = _e1263;
                                    }
                                    let _e1344 = phi_1796_;
                                    let _e1351 = (_e1332 - (_e1265[2] + (((_e1336 * _e1270[0]) + (_e1340 * _e1270[1])) + (_e1344 * _e1270[2]))));
                                    let _e1354 = local.member_2[0u];
                                    if (_e1354 < 0f) {
                                        phi_1815_ = -(_e1354);
                                    } else {
                                        phi_1815_ = _e1354;
                                    }
                                    let _e1358 = phi_1815_;
                                    if (_e1231 < 0f) {
                                        phi_1822_ = -(_e1231);
                                    } else {
                                        phi_1822_ = _e1231;
                                    }
                                    let _e1362 = phi_1822_;
                                    if (_e1243 < 0f) {
                                        phi_1828_ = -(_e1243);
                                    } else {
                                        phi_1828_ = _e1243;
                                    }
                                    let _e1366 = phi_1828_;
                                    if (_e1255 < 0f) {
                                        phi_1834_ = -(_e1255);
                                    } else {
                                        phi_1834_ = _e1255;
                                    }
                                    let _e1370 = phi_1834_;
                                    let _e1377 = (_e1358 - (_e1270[0] + (((_e1362 * _e1265[0]) + (_e1366 * _e1265[1])) + (_e1370 * _e1265[2]))));
                                    let _e1380 = local.member_2[1u];
                                    if (_e1380 < 0f) {
                                        phi_1853_ = -(_e1380);
                                    } else {
                                        phi_1853_ = _e1380;
                                    }
                                    let _e1384 = phi_1853_;
                                    if (_e1235 < 0f) {
                                        phi_1860_ = -(_e1235);
                                    } else {
                                        phi_1860_ = _e1235;
                                    }
                                    let _e1388 = phi_1860_;
                                    if (_e1247 < 0f) {
                                        phi_1866_ = -(_e1247);
                                    } else {
                                        phi_1866_ = _e1247;
                                    }
                                    let _e1392 = phi_1866_;
                                    if (_e1259 < 0f) {
                                        phi_1872_ = -(_e1259);
                                    } else {
                                        phi_1872_ = _e1259;
                                    }
                                    let _e1396 = phi_1872_;
                                    let _e1403 = (_e1384 - (_e1270[1] + (((_e1388 * _e1265[0]) + (_e1392 * _e1265[1])) + (_e1396 * _e1265[2]))));
                                    let _e1406 = local.member_2[2u];
                                    if (_e1406 < 0f) {
                                        phi_1891_ = -(_e1406);
                                    } else {
                                        phi_1891_ = _e1406;
                                    }
                                    let _e1410 = phi_1891_;
                                    if (_e1239 < 0f) {
                                        phi_1898_ = -(_e1239);
                                    } else {
                                        phi_1898_ = _e1239;
                                    }
                                    let _e1414 = phi_1898_;
                                    if (_e1251 < 0f) {
                                        phi_1904_ = -(_e1251);
                                    } else {
                                        phi_1904_ = _e1251;
                                    }
                                    let _e1418 = phi_1904_;
                                    if (_e1263 < 0f) {
                                        phi_1910_ = -(_e1263);
                                    } else {
                                        phi_1910_ = _e1263;
                                    }
                                    let _e1422 = phi_1910_;
                                    let _e1429 = (_e1410 - (_e1270[2] + (((_e1414 * _e1265[0]) + (_e1418 * _e1265[1])) + (_e1422 * _e1265[2]))));
                                    if (_e1299 > _e1325) {
                                        phi_1925_ = _e1299;
                                    } else {
                                        phi_1925_ = _e1325;
                                    }
                                    let _e1432 = phi_1925_;
                                    if (_e1432 > _e1351) {
                                        phi_1930_ = _e1432;
                                    } else {
                                        phi_1930_ = _e1351;
                                    }
                                    let _e1435 = phi_1930_;
                                    if (_e1377 > _e1403) {
                                        phi_1935_ = _e1377;
                                    } else {
                                        phi_1935_ = _e1403;
                                    }
                                    let _e1438 = phi_1935_;
                                    if (_e1438 > _e1429) {
                                        phi_1940_ = _e1438;
                                    } else {
                                        phi_1940_ = _e1429;
                                    }
                                    let _e1441 = phi_1940_;
                                    if (_e1435 > _e1441) {
                                        phi_1945_ = _e1435;
                                    } else {
                                        phi_1945_ = _e1441;
                                    }
                                    let _e1444 = phi_1945_;
                                    let _e1446 = local.member_5;
                                    if (_e1444 > _e1446) {
                                        phi_3258_ = true;
                                    } else {
                                        let _e1451 = local.member[1u][0u];
                                        let _e1454 = local.member_1[2u];
                                        let _e1459 = local.member[2u][0u];
                                        let _e1462 = local.member_1[1u];
                                        let _e1464 = ((_e1451 * _e1454) - (_e1459 * _e1462));
                                        let _e1468 = local.member[2u][0u];
                                        if (_e1468 < 0f) {
                                            phi_2004_ = -(_e1468);
                                        } else {
                                            phi_2004_ = _e1468;
                                        }
                                        let _e1472 = phi_2004_;
                                        let _e1475 = local.member_3[1u];
                                        let _e1480 = local.member[1u][0u];
                                        if (_e1480 < 0f) {
                                            phi_2027_ = -(_e1480);
                                        } else {
                                            phi_2027_ = _e1480;
                                        }
                                        let _e1484 = phi_2027_;
                                        let _e1487 = local.member_3[2u];
                                        let _e1493 = local.member[0u][2u];
                                        if (_e1493 < 0f) {
                                            phi_2050_ = -(_e1493);
                                        } else {
                                            phi_2050_ = _e1493;
                                        }
                                        let _e1497 = phi_2050_;
                                        let _e1500 = local.member_4[1u];
                                        let _e1505 = local.member[0u][1u];
                                        if (_e1505 < 0f) {
                                            phi_2072_ = -(_e1505);
                                        } else {
                                            phi_2072_ = _e1505;
                                        }
                                        let _e1509 = phi_2072_;
                                        let _e1512 = local.member_4[2u];
                                        if (_e1464 < 0f) {
                                            phi_2088_ = -(_e1464);
                                        } else {
                                            phi_2088_ = _e1464;
                                        }
                                        let _e1518 = phi_2088_;
                                        let _e1520 = (_e1518 - (((_e1472 * _e1475) + (_e1484 * _e1487)) + ((_e1497 * _e1500) + (_e1509 * _e1512))));
                                        let _e1524 = local.member[1u][1u];
                                        let _e1527 = local.member_1[2u];
                                        let _e1532 = local.member[2u][1u];
                                        let _e1535 = local.member_1[1u];
                                        let _e1537 = ((_e1524 * _e1527) - (_e1532 * _e1535));
                                        let _e1541 = local.member[2u][1u];
                                        if (_e1541 < 0f) {
                                            phi_2143_ = -(_e1541);
                                        } else {
                                            phi_2143_ = _e1541;
                                        }
                                        let _e1545 = phi_2143_;
                                        let _e1548 = local.member_3[1u];
                                        let _e1553 = local.member[1u][1u];
                                        if (_e1553 < 0f) {
                                            phi_2166_ = -(_e1553);
                                        } else {
                                            phi_2166_ = _e1553;
                                        }
                                        let _e1557 = phi_2166_;
                                        let _e1560 = local.member_3[2u];
                                        let _e1566 = local.member[0u][0u];
                                        if (_e1566 < 0f) {
                                            phi_2189_ = -(_e1566);
                                        } else {
                                            phi_2189_ = _e1566;
                                        }
                                        let _e1570 = phi_2189_;
                                        let _e1573 = local.member_4[2u];
                                        let _e1578 = local.member[0u][2u];
                                        if (_e1578 < 0f) {
                                            phi_2211_ = -(_e1578);
                                        } else {
                                            phi_2211_ = _e1578;
                                        }
                                        let _e1582 = phi_2211_;
                                        let _e1585 = local.member_4[0u];
                                        if (_e1537 < 0f) {
                                            phi_2227_ = -(_e1537);
                                        } else {
                                            phi_2227_ = _e1537;
                                        }
                                        let _e1591 = phi_2227_;
                                        let _e1593 = (_e1591 - (((_e1545 * _e1548) + (_e1557 * _e1560)) + ((_e1570 * _e1573) + (_e1582 * _e1585))));
                                        let _e1597 = local.member[1u][2u];
                                        let _e1600 = local.member_1[2u];
                                        let _e1605 = local.member[2u][2u];
                                        let _e1608 = local.member_1[1u];
                                        let _e1610 = ((_e1597 * _e1600) - (_e1605 * _e1608));
                                        let _e1614 = local.member[2u][2u];
                                        if (_e1614 < 0f) {
                                            phi_2282_ = -(_e1614);
                                        } else {
                                            phi_2282_ = _e1614;
                                        }
                                        let _e1618 = phi_2282_;
                                        let _e1621 = local.member_3[1u];
                                        let _e1626 = local.member[1u][2u];
                                        if (_e1626 < 0f) {
                                            phi_2305_ = -(_e1626);
                                        } else {
                                            phi_2305_ = _e1626;
                                        }
                                        let _e1630 = phi_2305_;
                                        let _e1633 = local.member_3[2u];
                                        let _e1639 = local.member[0u][1u];
                                        if (_e1639 < 0f) {
                                            phi_2328_ = -(_e1639);
                                        } else {
                                            phi_2328_ = _e1639;
                                        }
                                        let _e1643 = phi_2328_;
                                        let _e1646 = local.member_4[0u];
                                        let _e1651 = local.member[0u][0u];
                                        if (_e1651 < 0f) {
                                            phi_2350_ = -(_e1651);
                                        } else {
                                            phi_2350_ = _e1651;
                                        }
                                        let _e1655 = phi_2350_;
                                        let _e1658 = local.member_4[1u];
                                        if (_e1610 < 0f) {
                                            phi_2366_ = -(_e1610);
                                        } else {
                                            phi_2366_ = _e1610;
                                        }
                                        let _e1664 = phi_2366_;
                                        let _e1666 = (_e1664 - (((_e1618 * _e1621) + (_e1630 * _e1633)) + ((_e1643 * _e1646) + (_e1655 * _e1658))));
                                        let _e1670 = local.member[2u][0u];
                                        let _e1673 = local.member_1[0u];
                                        let _e1678 = local.member[0u][0u];
                                        let _e1681 = local.member_1[2u];
                                        let _e1683 = ((_e1670 * _e1673) - (_e1678 * _e1681));
                                        let _e1687 = local.member[0u][0u];
                                        if (_e1687 < 0f) {
                                            phi_2421_ = -(_e1687);
                                        } else {
                                            phi_2421_ = _e1687;
                                        }
                                        let _e1691 = phi_2421_;
                                        let _e1694 = local.member_3[2u];
                                        let _e1699 = local.member[2u][0u];
                                        if (_e1699 < 0f) {
                                            phi_2444_ = -(_e1699);
                                        } else {
                                            phi_2444_ = _e1699;
                                        }
                                        let _e1703 = phi_2444_;
                                        let _e1706 = local.member_3[0u];
                                        let _e1712 = local.member[1u][2u];
                                        if (_e1712 < 0f) {
                                            phi_2468_ = -(_e1712);
                                        } else {
                                            phi_2468_ = _e1712;
                                        }
                                        let _e1716 = phi_2468_;
                                        let _e1719 = local.member_4[1u];
                                        let _e1724 = local.member[1u][1u];
                                        if (_e1724 < 0f) {
                                            phi_2491_ = -(_e1724);
                                        } else {
                                            phi_2491_ = _e1724;
                                        }
                                        let _e1728 = phi_2491_;
                                        let _e1731 = local.member_4[2u];
                                        if (_e1683 < 0f) {
                                            phi_2507_ = -(_e1683);
                                        } else {
                                            phi_2507_ = _e1683;
                                        }
                                        let _e1737 = phi_2507_;
                                        let _e1739 = (_e1737 - (((_e1691 * _e1694) + (_e1703 * _e1706)) + ((_e1716 * _e1719) + (_e1728 * _e1731))));
                                        let _e1743 = local.member[2u][1u];
                                        let _e1746 = local.member_1[0u];
                                        let _e1751 = local.member[0u][1u];
                                        let _e1754 = local.member_1[2u];
                                        let _e1756 = ((_e1743 * _e1746) - (_e1751 * _e1754));
                                        let _e1760 = local.member[0u][1u];
                                        if (_e1760 < 0f) {
                                            phi_2562_ = -(_e1760);
                                        } else {
                                            phi_2562_ = _e1760;
                                        }
                                        let _e1764 = phi_2562_;
                                        let _e1767 = local.member_3[2u];
                                        let _e1772 = local.member[2u][1u];
                                        if (_e1772 < 0f) {
                                            phi_2585_ = -(_e1772);
                                        } else {
                                            phi_2585_ = _e1772;
                                        }
                                        let _e1776 = phi_2585_;
                                        let _e1779 = local.member_3[0u];
                                        let _e1785 = local.member[1u][0u];
                                        if (_e1785 < 0f) {
                                            phi_2609_ = -(_e1785);
                                        } else {
                                            phi_2609_ = _e1785;
                                        }
                                        let _e1789 = phi_2609_;
                                        let _e1792 = local.member_4[2u];
                                        let _e1797 = local.member[1u][2u];
                                        if (_e1797 < 0f) {
                                            phi_2632_ = -(_e1797);
                                        } else {
                                            phi_2632_ = _e1797;
                                        }
                                        let _e1801 = phi_2632_;
                                        let _e1804 = local.member_4[0u];
                                        if (_e1756 < 0f) {
                                            phi_2648_ = -(_e1756);
                                        } else {
                                            phi_2648_ = _e1756;
                                        }
                                        let _e1810 = phi_2648_;
                                        let _e1812 = (_e1810 - (((_e1764 * _e1767) + (_e1776 * _e1779)) + ((_e1789 * _e1792) + (_e1801 * _e1804))));
                                        let _e1816 = local.member[2u][2u];
                                        let _e1819 = local.member_1[0u];
                                        let _e1824 = local.member[0u][2u];
                                        let _e1827 = local.member_1[2u];
                                        let _e1829 = ((_e1816 * _e1819) - (_e1824 * _e1827));
                                        let _e1833 = local.member[0u][2u];
                                        if (_e1833 < 0f) {
                                            phi_2703_ = -(_e1833);
                                        } else {
                                            phi_2703_ = _e1833;
                                        }
                                        let _e1837 = phi_2703_;
                                        let _e1840 = local.member_3[2u];
                                        let _e1845 = local.member[2u][2u];
                                        if (_e1845 < 0f) {
                                            phi_2726_ = -(_e1845);
                                        } else {
                                            phi_2726_ = _e1845;
                                        }
                                        let _e1849 = phi_2726_;
                                        let _e1852 = local.member_3[0u];
                                        let _e1858 = local.member[1u][1u];
                                        if (_e1858 < 0f) {
                                            phi_2750_ = -(_e1858);
                                        } else {
                                            phi_2750_ = _e1858;
                                        }
                                        let _e1862 = phi_2750_;
                                        let _e1865 = local.member_4[0u];
                                        let _e1870 = local.member[1u][0u];
                                        if (_e1870 < 0f) {
                                            phi_2773_ = -(_e1870);
                                        } else {
                                            phi_2773_ = _e1870;
                                        }
                                        let _e1874 = phi_2773_;
                                        let _e1877 = local.member_4[1u];
                                        if (_e1829 < 0f) {
                                            phi_2789_ = -(_e1829);
                                        } else {
                                            phi_2789_ = _e1829;
                                        }
                                        let _e1883 = phi_2789_;
                                        let _e1885 = (_e1883 - (((_e1837 * _e1840) + (_e1849 * _e1852)) + ((_e1862 * _e1865) + (_e1874 * _e1877))));
                                        let _e1889 = local.member[0u][0u];
                                        let _e1892 = local.member_1[1u];
                                        let _e1897 = local.member[1u][0u];
                                        let _e1900 = local.member_1[0u];
                                        let _e1902 = ((_e1889 * _e1892) - (_e1897 * _e1900));
                                        let _e1906 = local.member[1u][0u];
                                        if (_e1906 < 0f) {
                                            phi_2844_ = -(_e1906);
                                        } else {
                                            phi_2844_ = _e1906;
                                        }
                                        let _e1910 = phi_2844_;
                                        let _e1913 = local.member_3[0u];
                                        let _e1918 = local.member[0u][0u];
                                        if (_e1918 < 0f) {
                                            phi_2867_ = -(_e1918);
                                        } else {
                                            phi_2867_ = _e1918;
                                        }
                                        let _e1922 = phi_2867_;
                                        let _e1925 = local.member_3[1u];
                                        let _e1931 = local.member[2u][2u];
                                        if (_e1931 < 0f) {
                                            phi_2891_ = -(_e1931);
                                        } else {
                                            phi_2891_ = _e1931;
                                        }
                                        let _e1935 = phi_2891_;
                                        let _e1938 = local.member_4[1u];
                                        let _e1943 = local.member[2u][1u];
                                        if (_e1943 < 0f) {
                                            phi_2914_ = -(_e1943);
                                        } else {
                                            phi_2914_ = _e1943;
                                        }
                                        let _e1947 = phi_2914_;
                                        let _e1950 = local.member_4[2u];
                                        if (_e1902 < 0f) {
                                            phi_2930_ = -(_e1902);
                                        } else {
                                            phi_2930_ = _e1902;
                                        }
                                        let _e1956 = phi_2930_;
                                        let _e1958 = (_e1956 - (((_e1910 * _e1913) + (_e1922 * _e1925)) + ((_e1935 * _e1938) + (_e1947 * _e1950))));
                                        let _e1962 = local.member[0u][1u];
                                        let _e1965 = local.member_1[1u];
                                        let _e1970 = local.member[1u][1u];
                                        let _e1973 = local.member_1[0u];
                                        let _e1975 = ((_e1962 * _e1965) - (_e1970 * _e1973));
                                        let _e1979 = local.member[1u][1u];
                                        if (_e1979 < 0f) {
                                            phi_2985_ = -(_e1979);
                                        } else {
                                            phi_2985_ = _e1979;
                                        }
                                        let _e1983 = phi_2985_;
                                        let _e1986 = local.member_3[0u];
                                        let _e1991 = local.member[0u][1u];
                                        if (_e1991 < 0f) {
                                            phi_3008_ = -(_e1991);
                                        } else {
                                            phi_3008_ = _e1991;
                                        }
                                        let _e1995 = phi_3008_;
                                        let _e1998 = local.member_3[1u];
                                        let _e2004 = local.member[2u][0u];
                                        if (_e2004 < 0f) {
                                            phi_3032_ = -(_e2004);
                                        } else {
                                            phi_3032_ = _e2004;
                                        }
                                        let _e2008 = phi_3032_;
                                        let _e2011 = local.member_4[2u];
                                        let _e2016 = local.member[2u][2u];
                                        if (_e2016 < 0f) {
                                            phi_3055_ = -(_e2016);
                                        } else {
                                            phi_3055_ = _e2016;
                                        }
                                        let _e2020 = phi_3055_;
                                        let _e2023 = local.member_4[0u];
                                        if (_e1975 < 0f) {
                                            phi_3071_ = -(_e1975);
                                        } else {
                                            phi_3071_ = _e1975;
                                        }
                                        let _e2029 = phi_3071_;
                                        let _e2031 = (_e2029 - (((_e1983 * _e1986) + (_e1995 * _e1998)) + ((_e2008 * _e2011) + (_e2020 * _e2023))));
                                        let _e2035 = local.member[0u][2u];
                                        let _e2038 = local.member_1[1u];
                                        let _e2043 = local.member[1u][2u];
                                        let _e2046 = local.member_1[0u];
                                        let _e2048 = ((_e2035 * _e2038) - (_e2043 * _e2046));
                                        let _e2052 = local.member[1u][2u];
                                        if (_e2052 < 0f) {
                                            phi_3126_ = -(_e2052);
                                        } else {
                                            phi_3126_ = _e2052;
                                        }
                                        let _e2056 = phi_3126_;
                                        let _e2059 = local.member_3[0u];
                                        let _e2064 = local.member[0u][2u];
                                        if (_e2064 < 0f) {
                                            phi_3149_ = -(_e2064);
                                        } else {
                                            phi_3149_ = _e2064;
                                        }
                                        let _e2068 = phi_3149_;
                                        let _e2071 = local.member_3[1u];
                                        let _e2077 = local.member[2u][1u];
                                        if (_e2077 < 0f) {
                                            phi_3173_ = -(_e2077);
                                        } else {
                                            phi_3173_ = _e2077;
                                        }
                                        let _e2081 = phi_3173_;
                                        let _e2084 = local.member_4[0u];
                                        let _e2089 = local.member[2u][0u];
                                        if (_e2089 < 0f) {
                                            phi_3196_ = -(_e2089);
                                        } else {
                                            phi_3196_ = _e2089;
                                        }
                                        let _e2093 = phi_3196_;
                                        let _e2096 = local.member_4[1u];
                                        if (_e2048 < 0f) {
                                            phi_3212_ = -(_e2048);
                                        } else {
                                            phi_3212_ = _e2048;
                                        }
                                        let _e2102 = phi_3212_;
                                        let _e2104 = (_e2102 - (((_e2056 * _e2059) + (_e2068 * _e2071)) + ((_e2081 * _e2084) + (_e2093 * _e2096))));
                                        if (_e1520 > _e1593) {
                                            phi_3219_ = _e1520;
                                        } else {
                                            phi_3219_ = _e1593;
                                        }
                                        let _e2107 = phi_3219_;
                                        if (_e2107 > _e1666) {
                                            phi_3224_ = _e2107;
                                        } else {
                                            phi_3224_ = _e1666;
                                        }
                                        let _e2110 = phi_3224_;
                                        if (_e1739 > _e1812) {
                                            phi_3229_ = _e1739;
                                        } else {
                                            phi_3229_ = _e1812;
                                        }
                                        let _e2113 = phi_3229_;
                                        if (_e2113 > _e1885) {
                                            phi_3234_ = _e2113;
                                        } else {
                                            phi_3234_ = _e1885;
                                        }
                                        let _e2116 = phi_3234_;
                                        if (_e2110 > _e2116) {
                                            phi_3239_ = _e2110;
                                        } else {
                                            phi_3239_ = _e2116;
                                        }
                                        let _e2119 = phi_3239_;
                                        if (_e1958 > _e2031) {
                                            phi_3244_ = _e1958;
                                        } else {
                                            phi_3244_ = _e2031;
                                        }
                                        let _e2122 = phi_3244_;
                                        if (_e2122 > _e2104) {
                                            phi_3249_ = _e2122;
                                        } else {
                                            phi_3249_ = _e2104;
                                        }
                                        let _e2125 = phi_3249_;
                                        if (_e2119 > _e2125) {
                                            phi_3254_ = _e2119;
                                        } else {
                                            phi_3254_ = _e2125;
                                        }
                                        let _e2128 = phi_3254_;
                                        let _e2130 = local.member_5;
                                        phi_3258_ = (_e2128 > _e2130);
                                    }
                                    let _e2133 = phi_3258_;
                                    phi_3260_ = !(_e2133);
                                    phi_3261_ = false;
                                } else {
                                    phi_3260_ = bool();
                                    phi_3261_ = true;
                                }
                                let _e2136 = phi_3260_;
                                let _e2138 = phi_3261_;
                                phi_3262_ = _e2136;
                                phi_3263_ = _e2138;
                            }
                            let _e2140 = phi_3262_;
                            let _e2142 = phi_3263_;
                            if _e2142 {
                                phi_3267_ = true;
                            } else {
                                phi_3267_ = _e2140;
                            }
                            let _e2144 = phi_3267_;
                            if _e2144 {
                            } else {
                                local_1[_e703.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_1000_ = _e701;
                        break if !(_e707);
                    }
                }
                let _e2147 = local_1;
                if (_e136 == 4294967295u) {
                    phi_3317_ = 0u;
                } else {
                    if (_e136 >= _e78) {
                        if (_e139 >= _e83) {
                            phi_3311_ = false;
                        } else {
                            phi_3311_ = true;
                        }
                        let _e2168 = phi_3311_;
                        phi_3312_ = _e2168;
                    } else {
                        phi_3312_ = true;
                    }
                    let _e2170 = phi_3312_;
                    if _e2170 {
                        phi_3316_ = 1u;
                    } else {
                        phi_3316_ = 2u;
                    }
                    let _e2172 = phi_3316_;
                    phi_3317_ = _e2172;
                }
                let _e2174 = phi_3317_;
                if (_e2174 == 2u) {
                    phi_3323_ = array<u32, 2>(_e136, _e139);
                } else {
                    phi_3323_ = array<u32, 2>(_e2147[0][0], _e2147[0][1]);
                }
                let _e2178 = phi_3323_;
                phi_3324_ = array<u32, 2>(_e2147[3][0], _e2147[3][1]);
                phi_3325_ = array<u32, 2>(_e2147[2][0], _e2147[2][1]);
                phi_3326_ = array<u32, 2>(_e2147[1][0], _e2147[1][1]);
                phi_3327_ = _e2178;
            } else {
                phi_3324_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3325_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3326_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3327_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2180 = phi_3324_;
            let _e2182 = phi_3325_;
            let _e2184 = phi_3326_;
            let _e2186 = phi_3327_;
            if (_e2186[0] == 4294967295u) {
                phi_3349_ = 0u;
            } else {
                if (_e2186[0] >= _e78) {
                    if (_e2186[1] >= _e83) {
                        phi_3343_ = false;
                    } else {
                        phi_3343_ = true;
                    }
                    let _e2194 = phi_3343_;
                    phi_3344_ = _e2194;
                } else {
                    phi_3344_ = true;
                }
                let _e2196 = phi_3344_;
                if _e2196 {
                    phi_3348_ = 1u;
                } else {
                    phi_3348_ = 2u;
                }
                let _e2198 = phi_3348_;
                phi_3349_ = _e2198;
            }
            let _e2200 = phi_3349_;
            if (_e2200 == 0u) {
                phi_3361_ = 0u;
            } else {
                if (_e2200 == 1u) {
                    phi_3358_ = 0u;
                } else {
                    phi_3358_ = 1u;
                }
                let _e2204 = phi_3358_;
                let _e2206 = atomicAdd((&counters[_e2204]), 1u);
                phi_3361_ = _e2206;
            }
            let _e2208 = phi_3361_;
            if (_e2184[0] == 4294967295u) {
                phi_3383_ = 0u;
            } else {
                if (_e2184[0] >= _e78) {
                    if (_e2184[1] >= _e83) {
                        phi_3377_ = false;
                    } else {
                        phi_3377_ = true;
                    }
                    let _e2216 = phi_3377_;
                    phi_3378_ = _e2216;
                } else {
                    phi_3378_ = true;
                }
                let _e2218 = phi_3378_;
                if _e2218 {
                    phi_3382_ = 1u;
                } else {
                    phi_3382_ = 2u;
                }
                let _e2220 = phi_3382_;
                phi_3383_ = _e2220;
            }
            let _e2222 = phi_3383_;
            if (_e2222 == 0u) {
                phi_3395_ = 0u;
            } else {
                if (_e2222 == 1u) {
                    phi_3392_ = 0u;
                } else {
                    phi_3392_ = 1u;
                }
                let _e2226 = phi_3392_;
                let _e2228 = atomicAdd((&counters[_e2226]), 1u);
                phi_3395_ = _e2228;
            }
            let _e2230 = phi_3395_;
            if (_e2182[0] == 4294967295u) {
                phi_3417_ = 0u;
            } else {
                if (_e2182[0] >= _e78) {
                    if (_e2182[1] >= _e83) {
                        phi_3411_ = false;
                    } else {
                        phi_3411_ = true;
                    }
                    let _e2238 = phi_3411_;
                    phi_3412_ = _e2238;
                } else {
                    phi_3412_ = true;
                }
                let _e2240 = phi_3412_;
                if _e2240 {
                    phi_3416_ = 1u;
                } else {
                    phi_3416_ = 2u;
                }
                let _e2242 = phi_3416_;
                phi_3417_ = _e2242;
            }
            let _e2244 = phi_3417_;
            if (_e2244 == 0u) {
                phi_3429_ = 0u;
            } else {
                if (_e2244 == 1u) {
                    phi_3426_ = 0u;
                } else {
                    phi_3426_ = 1u;
                }
                let _e2248 = phi_3426_;
                let _e2250 = atomicAdd((&counters[_e2248]), 1u);
                phi_3429_ = _e2250;
            }
            let _e2252 = phi_3429_;
            if (_e2180[0] == 4294967295u) {
                phi_3451_ = 0u;
            } else {
                if (_e2180[0] >= _e78) {
                    if (_e2180[1] >= _e83) {
                        phi_3445_ = false;
                    } else {
                        phi_3445_ = true;
                    }
                    let _e2260 = phi_3445_;
                    phi_3446_ = _e2260;
                } else {
                    phi_3446_ = true;
                }
                let _e2262 = phi_3446_;
                if _e2262 {
                    phi_3450_ = 1u;
                } else {
                    phi_3450_ = 2u;
                }
                let _e2264 = phi_3450_;
                phi_3451_ = _e2264;
            }
            let _e2266 = phi_3451_;
            if (_e2266 == 0u) {
                phi_3463_ = 0u;
            } else {
                if (_e2266 == 1u) {
                    phi_3460_ = 0u;
                } else {
                    phi_3460_ = 1u;
                }
                let _e2270 = phi_3460_;
                let _e2272 = atomicAdd((&counters[_e2270]), 1u);
                phi_3463_ = _e2272;
            }
            let _e2274 = phi_3463_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e2277 = atomicLoad((&counters[0u]));
                let _e2279 = atomicLoad((&counters[1u]));
                if (_e2277 > 0u) {
                    let _e2283 = atomicAdd((&levels.member[(_e65 + 1u)]), _e2277);
                    let _e2286 = atomicMax((&output.member[0u]), (_e2283 + _e2277));
                    if ((_e2283 + _e2277) < _e2283) {
                        let _e2290 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2283);
                }
                if (_e2279 > 0u) {
                    let _e2294 = atomicAdd((&pairs.member[0u]), _e2279);
                    if ((_e2294 + _e2279) < _e2294) {
                        let _e2298 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2294);
                }
            }
            workgroupBarrier();
            let _e2301 = atomicLoad((&counters[2u]));
            let _e2303 = atomicLoad((&counters[3u]));
            if (_e2186[0] == 4294967295u) {
                phi_3535_ = 0u;
            } else {
                if (_e2186[0] >= _e78) {
                    if (_e2186[1] >= _e83) {
                        phi_3529_ = false;
                    } else {
                        phi_3529_ = true;
                    }
                    let _e2311 = phi_3529_;
                    phi_3530_ = _e2311;
                } else {
                    phi_3530_ = true;
                }
                let _e2313 = phi_3530_;
                if _e2313 {
                    phi_3534_ = 1u;
                } else {
                    phi_3534_ = 2u;
                }
                let _e2315 = phi_3534_;
                phi_3535_ = _e2315;
            }
            let _e2317 = phi_3535_;
            if (_e2317 == 1u) {
                let _e2356 = params.member.member_2.member_3;
                let _e2357 = (_e2301 + _e2208);
                if (_e2357 < _e2356) {
                    let _e2359 = (2u * _e2357);
                    atomicStore((&output.member[(4u + _e2359)]), _e2186[0]);
                    atomicStore((&output.member[(_e2359 + 5u)]), _e2186[1]);
                }
            } else {
                if (_e2317 == 2u) {
                    let _e2322 = params.member.member_1.member_3;
                    let _e2323 = (_e2303 + _e2208);
                    let _e2326 = a_nodes.member[_e2186[0]];
                    let _e2330 = b_nodes.member[_e2186[1]];
                    let _e2334 = params.member.member_2.member;
                    if (_e2334 == 1u) {
                        if (_e2326.member_1 < _e2330.member_1) {
                            phi_3609_ = type_9(_e2326.member_1, _e2330.member_1);
                        } else {
                            phi_3609_ = type_9(_e2330.member_1, _e2326.member_1);
                        }
                        let _e2341 = phi_3609_;
                        phi_3614_ = _e2341;
                    } else {
                        phi_3614_ = type_9(_e2326.member_1, _e2330.member_1);
                    }
                    let _e2343 = phi_3614_;
                    if (_e2323 < _e2322) {
                        let _e2347 = (2u * _e2323);
                        atomicStore((&pairs.member[(4u + _e2347)]), _e2343.member);
                        atomicStore((&pairs.member[(_e2347 + 5u)]), _e2343.member_1);
                    }
                }
            }
            if (_e2184[0] == 4294967295u) {
                phi_3649_ = 0u;
            } else {
                if (_e2184[0] >= _e78) {
                    if (_e2184[1] >= _e83) {
                        phi_3643_ = false;
                    } else {
                        phi_3643_ = true;
                    }
                    let _e2371 = phi_3643_;
                    phi_3644_ = _e2371;
                } else {
                    phi_3644_ = true;
                }
                let _e2373 = phi_3644_;
                if _e2373 {
                    phi_3648_ = 1u;
                } else {
                    phi_3648_ = 2u;
                }
                let _e2375 = phi_3648_;
                phi_3649_ = _e2375;
            }
            let _e2377 = phi_3649_;
            if (_e2377 == 1u) {
                let _e2416 = params.member.member_2.member_3;
                let _e2417 = (_e2301 + _e2230);
                if (_e2417 < _e2416) {
                    let _e2419 = (2u * _e2417);
                    atomicStore((&output.member[(4u + _e2419)]), _e2184[0]);
                    atomicStore((&output.member[(_e2419 + 5u)]), _e2184[1]);
                }
            } else {
                if (_e2377 == 2u) {
                    let _e2382 = params.member.member_1.member_3;
                    let _e2383 = (_e2303 + _e2230);
                    let _e2386 = a_nodes.member[_e2184[0]];
                    let _e2390 = b_nodes.member[_e2184[1]];
                    let _e2394 = params.member.member_2.member;
                    if (_e2394 == 1u) {
                        if (_e2386.member_1 < _e2390.member_1) {
                            phi_3723_ = type_9(_e2386.member_1, _e2390.member_1);
                        } else {
                            phi_3723_ = type_9(_e2390.member_1, _e2386.member_1);
                        }
                        let _e2401 = phi_3723_;
                        phi_3728_ = _e2401;
                    } else {
                        phi_3728_ = type_9(_e2386.member_1, _e2390.member_1);
                    }
                    let _e2403 = phi_3728_;
                    if (_e2383 < _e2382) {
                        let _e2407 = (2u * _e2383);
                        atomicStore((&pairs.member[(4u + _e2407)]), _e2403.member);
                        atomicStore((&pairs.member[(_e2407 + 5u)]), _e2403.member_1);
                    }
                }
            }
            if (_e2182[0] == 4294967295u) {
                phi_3763_ = 0u;
            } else {
                if (_e2182[0] >= _e78) {
                    if (_e2182[1] >= _e83) {
                        phi_3757_ = false;
                    } else {
                        phi_3757_ = true;
                    }
                    let _e2431 = phi_3757_;
                    phi_3758_ = _e2431;
                } else {
                    phi_3758_ = true;
                }
                let _e2433 = phi_3758_;
                if _e2433 {
                    phi_3762_ = 1u;
                } else {
                    phi_3762_ = 2u;
                }
                let _e2435 = phi_3762_;
                phi_3763_ = _e2435;
            }
            let _e2437 = phi_3763_;
            if (_e2437 == 1u) {
                let _e2476 = params.member.member_2.member_3;
                let _e2477 = (_e2301 + _e2252);
                if (_e2477 < _e2476) {
                    let _e2479 = (2u * _e2477);
                    atomicStore((&output.member[(4u + _e2479)]), _e2182[0]);
                    atomicStore((&output.member[(_e2479 + 5u)]), _e2182[1]);
                }
            } else {
                if (_e2437 == 2u) {
                    let _e2442 = params.member.member_1.member_3;
                    let _e2443 = (_e2303 + _e2252);
                    let _e2446 = a_nodes.member[_e2182[0]];
                    let _e2450 = b_nodes.member[_e2182[1]];
                    let _e2454 = params.member.member_2.member;
                    if (_e2454 == 1u) {
                        if (_e2446.member_1 < _e2450.member_1) {
                            phi_3837_ = type_9(_e2446.member_1, _e2450.member_1);
                        } else {
                            phi_3837_ = type_9(_e2450.member_1, _e2446.member_1);
                        }
                        let _e2461 = phi_3837_;
                        phi_3842_ = _e2461;
                    } else {
                        phi_3842_ = type_9(_e2446.member_1, _e2450.member_1);
                    }
                    let _e2463 = phi_3842_;
                    if (_e2443 < _e2442) {
                        let _e2467 = (2u * _e2443);
                        atomicStore((&pairs.member[(4u + _e2467)]), _e2463.member);
                        atomicStore((&pairs.member[(_e2467 + 5u)]), _e2463.member_1);
                    }
                }
            }
            if (_e2180[0] == 4294967295u) {
                phi_3877_ = 0u;
            } else {
                if (_e2180[0] >= _e78) {
                    if (_e2180[1] >= _e83) {
                        phi_3871_ = false;
                    } else {
                        phi_3871_ = true;
                    }
                    let _e2491 = phi_3871_;
                    phi_3872_ = _e2491;
                } else {
                    phi_3872_ = true;
                }
                let _e2493 = phi_3872_;
                if _e2493 {
                    phi_3876_ = 1u;
                } else {
                    phi_3876_ = 2u;
                }
                let _e2495 = phi_3876_;
                phi_3877_ = _e2495;
            }
            let _e2497 = phi_3877_;
            if (_e2497 == 1u) {
                let _e2536 = params.member.member_2.member_3;
                let _e2537 = (_e2301 + _e2274);
                if (_e2537 < _e2536) {
                    let _e2539 = (2u * _e2537);
                    atomicStore((&output.member[(4u + _e2539)]), _e2180[0]);
                    atomicStore((&output.member[(_e2539 + 5u)]), _e2180[1]);
                }
            } else {
                if (_e2497 == 2u) {
                    let _e2502 = params.member.member_1.member_3;
                    let _e2503 = (_e2303 + _e2274);
                    let _e2506 = a_nodes.member[_e2180[0]];
                    let _e2510 = b_nodes.member[_e2180[1]];
                    let _e2514 = params.member.member_2.member;
                    if (_e2514 == 1u) {
                        if (_e2506.member_1 < _e2510.member_1) {
                            phi_3951_ = type_9(_e2506.member_1, _e2510.member_1);
                        } else {
                            phi_3951_ = type_9(_e2510.member_1, _e2506.member_1);
                        }
                        let _e2521 = phi_3951_;
                        phi_3956_ = _e2521;
                    } else {
                        phi_3956_ = type_9(_e2506.member_1, _e2510.member_1);
                    }
                    let _e2523 = phi_3956_;
                    if (_e2503 < _e2502) {
                        let _e2527 = (2u * _e2503);
                        atomicStore((&pairs.member[(4u + _e2527)]), _e2523.member);
                        atomicStore((&pairs.member[(_e2527 + 5u)]), _e2523.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_220_ = _e118;
            break if !(_e124);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
