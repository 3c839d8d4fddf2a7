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
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_33 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_34 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_35 {
    member: f64,
    member_1: f64,
}

struct type_39 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_41 {
    member: type_33,
    member_1: f64,
}

struct type_42 {
    member: u32,
    member_1: f64,
}

struct type_43 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_47 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage> positions: type_29;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_47;
@group(0) @binding(6) 
var<storage, read_write> left: type_47;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_47;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_228_: f64;
    var phi_271_: f64;
    var phi_314_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_228_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_228_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_228_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_271_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_271_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_271_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_314_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_314_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_314_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: ptr<function, type_39>, param_3: f64, param_4: f64, param_5: f64) -> bool {
    var phi_4208_: bool;
    var phi_4209_: bool;
    var phi_4214_: bool;

    let _e15 = (*param_2).member_3;
    let _e17 = (*param_2).member_3;
    let _e19 = (param_3 + (_e15 + _e17));
    if (_e19 < param_5) {
        let _e22 = (f64(1f) - param_4);
        let _e25 = (*param_2).member[0u];
        let _e28 = (*param_2).member[1u];
        let _e31 = (*param_2).member[2u];
        let _e34 = (*param_2).member[3u];
        let _e45 = ((((_e25 * _e22) + (_e28 * param_4)) * (_e22 * _e22)) + (((_e31 * _e22) + (_e34 * param_4)) * (param_4 * param_4)));
        let _e47 = select(param_4, _e19, (_e19 > param_4));
        let _e49 = (f64(1f) - _e47);
        let _e52 = (*param_2).member[0u];
        let _e55 = (*param_2).member[1u];
        let _e58 = (*param_2).member[2u];
        let _e61 = (*param_2).member[3u];
        let _e72 = ((((_e52 * _e49) + (_e55 * _e47)) * (_e49 * _e49)) + (((_e58 * _e49) + (_e61 * _e47)) * (_e47 * _e47)));
        let _e74 = (*param_2).member_1;
        let _e76 = (*param_2).member_1;
        let _e82 = (*param_2).member_1;
        if (select(_e45, -(_e45), (_e45 < 0.0lf)) > _e82) {
            let _e87 = (select(_e72, -(_e72), (_e72 < 0.0lf)) > (_e74 + _e76));
            phi_4208_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_4209_ = select(true, false, _e87);
        } else {
            phi_4208_ = bool();
            phi_4209_ = true;
        }
        let _e96 = phi_4208_;
        let _e98 = phi_4209_;
        phi_4214_ = select(_e96, false, _e98);
    } else {
        phi_4214_ = false;
    }
    let _e101 = phi_4214_;
    return _e101;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_34;
    var local_1: array<type_35, 4>;
    var local_2: array<f64, 4>;
    var local_3: array<f64, 2>;
    var local_4: type_39;
    var local_5: array<f64, 4>;
    var local_6: type_34;
    var phi_374_: u32;
    var phi_419_: u32;
    var phi_422_: type_9;
    var phi_596_: type_23;
    var phi_792_: type_31;
    var phi_953_: type_33;
    var phi_1449_: bool;
    var phi_1545_: type_41;
    var phi_1546_: bool;
    var phi_1547_: type_41;
    var phi_1548_: bool;
    var phi_1549_: type_41;
    var phi_1550_: bool;
    var phi_1555_: type_41;
    var phi_2100_: bool;
    var phi_2115_: f64;
    var phi_2191_: type_16;
    var phi_2194_: f64;
    var phi_2192_: type_16;
    var phi_2235_: type_17;
    var phi_2195_: f64;
    var local_7: f64;
    var phi_2248_: f64;
    var phi_2279_: type_9;
    var phi_2282_: u32;
    var phi_2349_: u32;
    var phi_2350_: u32;
    var phi_2283_: u32;
    var phi_2351_: u32;
    var phi_2409_: type_9;
    var phi_2569_: type_43;
    var phi_2570_: bool;
    var phi_2571_: type_43;
    var phi_2572_: bool;
    var phi_2607_: type_9;
    var phi_2610_: f64;
    var phi_2612_: f64;
    var phi_2614_: f64;
    var phi_2728_: bool;
    var phi_2735_: f64;
    var phi_2736_: bool;
    var phi_2611_: f64;
    var phi_2613_: f64;
    var phi_2615_: f64;
    var phi_2737_: f64;
    var phi_2738_: bool;
    var phi_2739_: bool;
    var local_8: bool;
    var local_9: f64;
    var local_10: f64;
    var phi_2744_: f64;
    var phi_2762_: type_9;
    var phi_2765_: f64;
    var phi_2831_: f64;
    var phi_2832_: bool;
    var phi_2833_: bool;
    var phi_2834_: bool;
    var phi_2835_: f64;
    var phi_2766_: f64;
    var phi_2836_: bool;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: f64;
    var phi_2853_: f64;
    var phi_2855_: type_43;
    var phi_3620_: array<type_35, 4>;
    var phi_3640_: type_9;
    var phi_3643_: bool;
    var phi_3644_: bool;
    var phi_3695_: bool;
    var phi_3696_: bool;
    var local_16: bool;
    var local_17: bool;
    var phi_3710_: u32;
    var phi_3711_: u32;
    var phi_3712_: bool;
    var phi_3722_: u32;
    var phi_3723_: bool;
    var phi_3724_: bool;
    var phi_3725_: u32;
    var phi_3726_: bool;
    var phi_3727_: bool;
    var phi_3728_: bool;
    var phi_3729_: type_43;
    var phi_3730_: u32;
    var phi_3731_: bool;
    var phi_3732_: bool;
    var phi_3733_: bool;
    var phi_3734_: type_43;
    var phi_3735_: u32;
    var phi_3736_: bool;
    var phi_3737_: bool;
    var phi_3738_: bool;
    var phi_3739_: bool;
    var phi_3746_: type_43;
    var phi_3747_: u32;
    var phi_3748_: bool;
    var phi_3749_: bool;
    var phi_3750_: bool;
    var phi_3751_: bool;
    var phi_3752_: bool;
    var phi_3753_: type_43;
    var phi_3754_: u32;
    var phi_3755_: type_43;
    var phi_3756_: bool;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3759_: bool;
    var phi_3760_: bool;
    var phi_3761_: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: u32;
    var local_29: type_43;
    var local_30: type_43;
    var local_31: type_43;
    var local_32: type_43;
    var phi_3810_: type_42;
    var phi_3811_: bool;
    var phi_3816_: type_42;
    var phi_3817_: bool;
    var phi_3818_: bool;
    var phi_3819_: bool;
    var local_33: type_43;
    var local_34: type_43;
    var phi_3841_: type_42;
    var phi_3842_: type_42;
    var phi_3843_: bool;
    var phi_3887_: type_34;
    var phi_3896_: type_9;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3998_: u32;
    var phi_4080_: u32;
    var local_35: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e95 = id_2;
    let _e96 = n_2;
    let _e97 = lane_2;
    let _e110 = ((_e95.y * _e96.x) + _e95.x);
    let _e113 = (_e96.x * _e96.y);
    let _e116 = params.member.member_1.member_2;
    let _e118 = input.member[0u];
    let _e120 = select(_e118, _e116, (_e116 < _e118));
    let _e122 = params.member.member_1.member_1;
    if (_e120 > _e122) {
        let _e125 = params.member.member_1.member_1;
        phi_374_ = (_e120 - _e125);
    } else {
        phi_374_ = 0u;
    }
    let _e128 = phi_374_;
    let _e130 = params.member.member_1.member;
    let _e132 = select(_e128, _e130, (_e130 < _e128));
    let _e133 = (_e132 / 64u);
    let _e137 = select(_e133, (_e133 + 1u), ((_e132 % 64u) > 0u));
    if (_e137 > _e110) {
        let _e139 = (_e137 - _e110);
        if (_e113 == 0u) {
            return;
        }
        let _e141 = (_e139 / _e113);
        if (_e113 == 0u) {
            return;
        }
        phi_419_ = select(_e141, (_e141 + 1u), ((_e139 % _e113) > 0u));
    } else {
        phi_419_ = 0u;
    }
    let _e148 = phi_419_;
    phi_422_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_422_;
        let _e154 = (_e151.member < _e151.member_1);
        let _e167 = (bitcast<i32>(select(0u, 1u, _e154)) != 0i);
        if _e167 {
            let _e171 = (((_e110 + (select(type_9().member_1, _e151.member, _e154) * _e113)) * 64u) + _e97);
            local_6 = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e171 < _e132) {
                let _e175 = params.member.member_1.member_1;
                let _e177 = (2u * (_e175 + _e171));
                let _e180 = input.member[(4u + _e177)];
                let _e183 = input.member[(_e177 + 5u)];
                let _e188 = (_e183 & 2147483647u);
                if (select(1u, 0u, ((_e183 & 2147483648u) == 0u)) == 0u) {
                    let _e207 = params.member.member.member[1u];
                    let _e210 = ((2u * _e207) + (3u * _e188));
                    let _e212 = elements.member[_e210];
                    let _e215 = elements.member[(_e210 + 1u)];
                    let _e218 = elements.member[(_e210 + 2u)];
                    phi_596_ = type_23(0u, array<u32, 4>(_e180, _e212, _e215, _e218));
                } else {
                    let _e191 = (2u * _e180);
                    let _e193 = elements.member[_e191];
                    let _e196 = elements.member[(_e191 + 1u)];
                    let _e197 = (2u * _e188);
                    let _e199 = elements.member[_e197];
                    let _e202 = elements.member[(_e197 + 1u)];
                    phi_596_ = type_23(1u, array<u32, 4>(_e193, _e196, _e199, _e202));
                }
                let _e222 = phi_596_;
                let _e226 = params.member.member.member_1;
                if ((_e226 & 8u) != 0u) {
                    let _e270 = paths.member[_e222.member_1[0]];
                    let _e285 = paths.member[_e222.member_1[1]];
                    let _e300 = paths.member[_e222.member_1[2]];
                    let _e315 = paths.member[_e222.member_1[3]];
                    let _e336 = function_(array<f32, 3>(_e270.member.x, _e270.member.y, _e270.member.z));
                    let _e337 = function_(array<f32, 3>(_e285.member.x, _e285.member.y, _e285.member.z));
                    let _e338 = function_(array<f32, 3>(_e300.member.x, _e300.member.y, _e300.member.z));
                    let _e339 = function_(array<f32, 3>(_e315.member.x, _e315.member.y, _e315.member.z));
                    let _e341 = function_(array<f32, 3>(_e270.member_1.x, _e270.member_1.y, _e270.member_1.z));
                    let _e342 = function_(array<f32, 3>(_e285.member_1.x, _e285.member_1.y, _e285.member_1.z));
                    let _e343 = function_(array<f32, 3>(_e300.member_1.x, _e300.member_1.y, _e300.member_1.z));
                    let _e344 = function_(array<f32, 3>(_e315.member_1.x, _e315.member_1.y, _e315.member_1.z));
                    phi_792_ = type_31(array<array<f64, 3>, 4>(_e336, _e337, _e338, _e339), array<array<f64, 3>, 4>(_e341, _e342, _e343, _e344));
                } else {
                    let _e231 = positions.member[_e222.member_1[0]];
                    let _e234 = params.member.member.member[0u];
                    let _e237 = positions.member[(_e234 + _e222.member_1[0])];
                    let _e240 = positions.member[_e222.member_1[1]];
                    let _e243 = params.member.member.member[0u];
                    let _e246 = positions.member[(_e243 + _e222.member_1[1])];
                    let _e249 = positions.member[_e222.member_1[2]];
                    let _e252 = params.member.member.member[0u];
                    let _e255 = positions.member[(_e252 + _e222.member_1[2])];
                    let _e258 = positions.member[_e222.member_1[3]];
                    let _e261 = params.member.member.member[0u];
                    let _e264 = positions.member[(_e261 + _e222.member_1[3])];
                    phi_792_ = type_31(array<array<f64, 3>, 4>(_e231, _e240, _e249, _e258), array<array<f64, 3>, 4>(_e237, _e246, _e255, _e264));
                }
                let _e348 = phi_792_;
                if (_e222.member != 0u) {
                    phi_953_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[2][0] - _e348.member[0][0]), (_e348.member[2][1] - _e348.member[0][1]), (_e348.member[2][2] - _e348.member[0][2])), array<f64, 3>((_e348.member_1[2][0] - _e348.member_1[0][0]), (_e348.member_1[2][1] - _e348.member_1[0][1]), (_e348.member_1[2][2] - _e348.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[1][0] - _e348.member[0][0]), (_e348.member[1][1] - _e348.member[0][1]), (_e348.member[1][2] - _e348.member[0][2])), array<f64, 3>((_e348.member_1[1][0] - _e348.member_1[0][0]), (_e348.member_1[1][1] - _e348.member_1[0][1]), (_e348.member_1[1][2] - _e348.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[2][0] - _e348.member[3][0]), (_e348.member[2][1] - _e348.member[3][1]), (_e348.member[2][2] - _e348.member[3][2])), array<f64, 3>((_e348.member_1[2][0] - _e348.member_1[3][0]), (_e348.member_1[2][1] - _e348.member_1[3][1]), (_e348.member_1[2][2] - _e348.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_953_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[0][0] - _e348.member[1][0]), (_e348.member[0][1] - _e348.member[1][1]), (_e348.member[0][2] - _e348.member[1][2])), array<f64, 3>((_e348.member_1[0][0] - _e348.member_1[1][0]), (_e348.member_1[0][1] - _e348.member_1[1][1]), (_e348.member_1[0][2] - _e348.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[2][0] - _e348.member[1][0]), (_e348.member[2][1] - _e348.member[1][1]), (_e348.member[2][2] - _e348.member[1][2])), array<f64, 3>((_e348.member_1[2][0] - _e348.member_1[1][0]), (_e348.member_1[2][1] - _e348.member_1[1][1]), (_e348.member_1[2][2] - _e348.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e348.member[3][0] - _e348.member[1][0]), (_e348.member[3][1] - _e348.member[1][1]), (_e348.member[3][2] - _e348.member[1][2])), array<f64, 3>((_e348.member_1[3][0] - _e348.member_1[1][0]), (_e348.member_1[3][1] - _e348.member_1[1][1]), (_e348.member_1[3][2] - _e348.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e507 = phi_953_;
                let _e509 = params.member.member.member_14;
                let _e516 = bitcast<f64>(((u64(_e509[1]) * 4294967296lu) + u64(_e509[0])));
                let _e518 = params.member.member.member_15;
                let _e525 = bitcast<f64>(((u64(_e518[1]) * 4294967296lu) + u64(_e518[0])));
                let _e527 = params.member.member.member_16;
                let _e534 = bitcast<f64>(((u64(_e527[1]) * 4294967296lu) + u64(_e527[0])));
                let _e536 = params.member.member.member_16;
                let _e543 = bitcast<f64>(((u64(_e536[1]) * 4294967296lu) + u64(_e536[0])));
                let _e544 = f64(0f);
                let _e550 = select(_e507.member[0][0], -(_e507.member[0][0]), (_e507.member[0][0] < 0.0lf));
                let _e554 = select(_e507.member[0][1], -(_e507.member[0][1]), (_e507.member[0][1] < 0.0lf));
                let _e556 = select(_e554, _e550, (_e550 > _e554));
                let _e560 = select(_e507.member[0][2], -(_e507.member[0][2]), (_e507.member[0][2] < 0.0lf));
                let _e562 = select(_e560, _e556, (_e556 > _e560));
                let _e568 = select(_e507.member[1][0], -(_e507.member[1][0]), (_e507.member[1][0] < 0.0lf));
                let _e572 = select(_e507.member[1][1], -(_e507.member[1][1]), (_e507.member[1][1] < 0.0lf));
                let _e574 = select(_e572, _e568, (_e568 > _e572));
                let _e578 = select(_e507.member[1][2], -(_e507.member[1][2]), (_e507.member[1][2] < 0.0lf));
                let _e580 = select(_e578, _e574, (_e574 > _e578));
                let _e584 = (select(_e580, _e562, (_e562 > _e580)) + _e507.member_3);
                let _e590 = select(_e507.member_1[0][0], -(_e507.member_1[0][0]), (_e507.member_1[0][0] < 0.0lf));
                let _e594 = select(_e507.member_1[0][1], -(_e507.member_1[0][1]), (_e507.member_1[0][1] < 0.0lf));
                let _e596 = select(_e594, _e590, (_e590 > _e594));
                let _e600 = select(_e507.member_1[0][2], -(_e507.member_1[0][2]), (_e507.member_1[0][2] < 0.0lf));
                let _e602 = select(_e600, _e596, (_e596 > _e600));
                let _e608 = select(_e507.member_1[1][0], -(_e507.member_1[1][0]), (_e507.member_1[1][0] < 0.0lf));
                let _e612 = select(_e507.member_1[1][1], -(_e507.member_1[1][1]), (_e507.member_1[1][1] < 0.0lf));
                let _e614 = select(_e612, _e608, (_e608 > _e612));
                let _e618 = select(_e507.member_1[1][2], -(_e507.member_1[1][2]), (_e507.member_1[1][2] < 0.0lf));
                let _e620 = select(_e618, _e614, (_e614 > _e618));
                let _e624 = (select(_e620, _e602, (_e602 > _e620)) + _e507.member_3);
                let _e630 = select(_e507.member_2[0][0], -(_e507.member_2[0][0]), (_e507.member_2[0][0] < 0.0lf));
                let _e634 = select(_e507.member_2[0][1], -(_e507.member_2[0][1]), (_e507.member_2[0][1] < 0.0lf));
                let _e636 = select(_e634, _e630, (_e630 > _e634));
                let _e640 = select(_e507.member_2[0][2], -(_e507.member_2[0][2]), (_e507.member_2[0][2] < 0.0lf));
                let _e642 = select(_e640, _e636, (_e636 > _e640));
                let _e648 = select(_e507.member_2[1][0], -(_e507.member_2[1][0]), (_e507.member_2[1][0] < 0.0lf));
                let _e652 = select(_e507.member_2[1][1], -(_e507.member_2[1][1]), (_e507.member_2[1][1] < 0.0lf));
                let _e654 = select(_e652, _e648, (_e648 > _e652));
                let _e658 = select(_e507.member_2[1][2], -(_e507.member_2[1][2]), (_e507.member_2[1][2] < 0.0lf));
                let _e660 = select(_e658, _e654, (_e654 > _e658));
                let _e664 = (select(_e660, _e642, (_e642 > _e660)) + _e507.member_3);
                let _e666 = select(_e624, _e584, (_e584 > _e624));
                let _e668 = select(_e664, _e666, (_e666 > _e664));
                let _e674 = select(_e507.member[0][0], -(_e507.member[0][0]), (_e507.member[0][0] < 0.0lf));
                let _e678 = select(_e507.member[0][1], -(_e507.member[0][1]), (_e507.member[0][1] < 0.0lf));
                let _e680 = select(_e678, _e674, (_e674 > _e678));
                let _e684 = select(_e507.member[0][2], -(_e507.member[0][2]), (_e507.member[0][2] < 0.0lf));
                let _e686 = select(_e684, _e680, (_e680 > _e684));
                let _e692 = select(_e507.member[1][0], -(_e507.member[1][0]), (_e507.member[1][0] < 0.0lf));
                let _e696 = select(_e507.member[1][1], -(_e507.member[1][1]), (_e507.member[1][1] < 0.0lf));
                let _e698 = select(_e696, _e692, (_e692 > _e696));
                let _e702 = select(_e507.member[1][2], -(_e507.member[1][2]), (_e507.member[1][2] < 0.0lf));
                let _e704 = select(_e702, _e698, (_e698 > _e702));
                let _e708 = (select(_e704, _e686, (_e686 > _e704)) + _e507.member_3);
                let _e714 = select(_e507.member_1[0][0], -(_e507.member_1[0][0]), (_e507.member_1[0][0] < 0.0lf));
                let _e718 = select(_e507.member_1[0][1], -(_e507.member_1[0][1]), (_e507.member_1[0][1] < 0.0lf));
                let _e720 = select(_e718, _e714, (_e714 > _e718));
                let _e724 = select(_e507.member_1[0][2], -(_e507.member_1[0][2]), (_e507.member_1[0][2] < 0.0lf));
                let _e726 = select(_e724, _e720, (_e720 > _e724));
                let _e732 = select(_e507.member_1[1][0], -(_e507.member_1[1][0]), (_e507.member_1[1][0] < 0.0lf));
                let _e736 = select(_e507.member_1[1][1], -(_e507.member_1[1][1]), (_e507.member_1[1][1] < 0.0lf));
                let _e738 = select(_e736, _e732, (_e732 > _e736));
                let _e742 = select(_e507.member_1[1][2], -(_e507.member_1[1][2]), (_e507.member_1[1][2] < 0.0lf));
                let _e744 = select(_e742, _e738, (_e738 > _e742));
                let _e748 = (select(_e744, _e726, (_e726 > _e744)) + _e507.member_3);
                let _e754 = select(_e507.member_2[0][0], -(_e507.member_2[0][0]), (_e507.member_2[0][0] < 0.0lf));
                let _e758 = select(_e507.member_2[0][1], -(_e507.member_2[0][1]), (_e507.member_2[0][1] < 0.0lf));
                let _e760 = select(_e758, _e754, (_e754 > _e758));
                let _e764 = select(_e507.member_2[0][2], -(_e507.member_2[0][2]), (_e507.member_2[0][2] < 0.0lf));
                let _e766 = select(_e764, _e760, (_e760 > _e764));
                let _e772 = select(_e507.member_2[1][0], -(_e507.member_2[1][0]), (_e507.member_2[1][0] < 0.0lf));
                let _e776 = select(_e507.member_2[1][1], -(_e507.member_2[1][1]), (_e507.member_2[1][1] < 0.0lf));
                let _e778 = select(_e776, _e772, (_e772 > _e776));
                let _e782 = select(_e507.member_2[1][2], -(_e507.member_2[1][2]), (_e507.member_2[1][2] < 0.0lf));
                let _e784 = select(_e782, _e778, (_e778 > _e782));
                let _e788 = (select(_e784, _e766, (_e766 > _e784)) + _e507.member_3);
                let _e790 = select(_e748, _e708, (_e708 > _e748));
                let _e792 = select(_e788, _e790, (_e790 > _e788));
                if (_e792 <= f64(65536f)) {
                    phi_1449_ = (_e792 >= f64((1f / 65536f)));
                } else {
                    phi_1449_ = false;
                }
                let _e799 = phi_1449_;
                if _e799 {
                    phi_1549_ = type_41();
                    phi_1550_ = true;
                } else {
                    if (_e668 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e668) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e806 = (9214364837600034816lu - (bitcast<u64>(_e668) & 9218868437227405312lu));
                            let _e809 = bitcast<f64>(select(4503599627370496lu, _e806, (_e806 > 4503599627370496lu)));
                            let _e810 = (_e544 * _e809);
                            phi_1545_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e507.member[0][0] * _e809), (_e507.member[0][1] * _e809), (_e507.member[0][2] * _e809)), array<f64, 3>((_e507.member[1][0] * _e809), (_e507.member[1][1] * _e809), (_e507.member[1][2] * _e809))), array<array<f64, 3>, 2>(array<f64, 3>((_e507.member_1[0][0] * _e809), (_e507.member_1[0][1] * _e809), (_e507.member_1[0][2] * _e809)), array<f64, 3>((_e507.member_1[1][0] * _e809), (_e507.member_1[1][1] * _e809), (_e507.member_1[1][2] * _e809))), array<array<f64, 3>, 2>(array<f64, 3>((_e507.member_2[0][0] * _e809), (_e507.member_2[0][1] * _e809), (_e507.member_2[0][2] * _e809)), array<f64, 3>((_e507.member_2[1][0] * _e809), (_e507.member_2[1][1] * _e809), (_e507.member_2[1][2] * _e809))), ((_e507.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e809)), select(_e810, select(2.2250738585072014e-308lf, _e810, (_e810 > 2.2250738585072014e-308lf)), (_e544 > f64(0f))));
                            phi_1546_ = false;
                        } else {
                            phi_1545_ = type_41();
                            phi_1546_ = true;
                        }
                        let _e881 = phi_1545_;
                        let _e883 = phi_1546_;
                        phi_1547_ = _e881;
                        phi_1548_ = _e883;
                    } else {
                        phi_1547_ = type_41();
                        phi_1548_ = true;
                    }
                    let _e885 = phi_1547_;
                    let _e887 = phi_1548_;
                    phi_1549_ = _e885;
                    phi_1550_ = _e887;
                }
                let _e889 = phi_1549_;
                let _e891 = phi_1550_;
                if _e891 {
                    phi_1555_ = type_41(_e507, _e544);
                } else {
                    phi_1555_ = _e889;
                }
                let _e894 = phi_1555_;
                let _e906 = ((_e894.member.member_1[0][1] * _e894.member.member_2[0][2]) - (_e894.member.member_1[0][2] * _e894.member.member_2[0][1]));
                let _e913 = ((_e894.member.member_1[0][2] * _e894.member.member_2[0][0]) - (_e894.member.member_1[0][0] * _e894.member.member_2[0][2]));
                let _e920 = ((_e894.member.member_1[0][0] * _e894.member.member_2[0][1]) - (_e894.member.member_1[0][1] * _e894.member.member_2[0][0]));
                let _e931 = ((_e894.member.member_1[1][1] * _e894.member.member_2[1][2]) - (_e894.member.member_1[1][2] * _e894.member.member_2[1][1]));
                let _e938 = ((_e894.member.member_1[1][2] * _e894.member.member_2[1][0]) - (_e894.member.member_1[1][0] * _e894.member.member_2[1][2]));
                let _e945 = ((_e894.member.member_1[1][0] * _e894.member.member_2[1][1]) - (_e894.member.member_1[1][1] * _e894.member.member_2[1][0]));
                let _e996 = (((_e894.member.member_1[0][1] * _e894.member.member_2[1][2]) - (_e894.member.member_1[0][2] * _e894.member.member_2[1][1])) + ((_e894.member.member_1[1][1] * _e894.member.member_2[0][2]) - (_e894.member.member_1[1][2] * _e894.member.member_2[0][1])));
                let _e997 = (((_e894.member.member_1[0][2] * _e894.member.member_2[1][0]) - (_e894.member.member_1[0][0] * _e894.member.member_2[1][2])) + ((_e894.member.member_1[1][2] * _e894.member.member_2[0][0]) - (_e894.member.member_1[1][0] * _e894.member.member_2[0][2])));
                let _e998 = (((_e894.member.member_1[0][0] * _e894.member.member_2[1][1]) - (_e894.member.member_1[0][1] * _e894.member.member_2[1][0])) + ((_e894.member.member_1[1][0] * _e894.member.member_2[0][1]) - (_e894.member.member_1[1][1] * _e894.member.member_2[0][0])));
                let _e1008 = (((_e894.member.member[0][0] * _e906) + (_e894.member.member[0][1] * _e913)) + (_e894.member.member[0][2] * _e920));
                let _e1029 = ((((_e894.member.member[1][0] * _e906) + (_e894.member.member[1][1] * _e913)) + (_e894.member.member[1][2] * _e920)) + (((_e894.member.member[0][0] * _e996) + (_e894.member.member[0][1] * _e997)) + (_e894.member.member[0][2] * _e998)));
                let _e1050 = ((((_e894.member.member[0][0] * _e931) + (_e894.member.member[0][1] * _e938)) + (_e894.member.member[0][2] * _e945)) + (((_e894.member.member[1][0] * _e996) + (_e894.member.member[1][1] * _e997)) + (_e894.member.member[1][2] * _e998)));
                let _e1060 = (((_e894.member.member[1][0] * _e931) + (_e894.member.member[1][1] * _e938)) + (_e894.member.member[1][2] * _e945));
                let _e1066 = select(_e894.member.member[0][0], -(_e894.member.member[0][0]), (_e894.member.member[0][0] < 0.0lf));
                let _e1070 = select(_e894.member.member[0][1], -(_e894.member.member[0][1]), (_e894.member.member[0][1] < 0.0lf));
                let _e1072 = select(_e1070, _e1066, (_e1066 > _e1070));
                let _e1076 = select(_e894.member.member[0][2], -(_e894.member.member[0][2]), (_e894.member.member[0][2] < 0.0lf));
                let _e1078 = select(_e1076, _e1072, (_e1072 > _e1076));
                let _e1084 = select(_e894.member.member[1][0], -(_e894.member.member[1][0]), (_e894.member.member[1][0] < 0.0lf));
                let _e1088 = select(_e894.member.member[1][1], -(_e894.member.member[1][1]), (_e894.member.member[1][1] < 0.0lf));
                let _e1090 = select(_e1088, _e1084, (_e1084 > _e1088));
                let _e1094 = select(_e894.member.member[1][2], -(_e894.member.member[1][2]), (_e894.member.member[1][2] < 0.0lf));
                let _e1096 = select(_e1094, _e1090, (_e1090 > _e1094));
                let _e1100 = (select(_e1096, _e1078, (_e1078 > _e1096)) + _e894.member.member_3);
                let _e1106 = select(_e894.member.member_1[0][0], -(_e894.member.member_1[0][0]), (_e894.member.member_1[0][0] < 0.0lf));
                let _e1110 = select(_e894.member.member_1[0][1], -(_e894.member.member_1[0][1]), (_e894.member.member_1[0][1] < 0.0lf));
                let _e1112 = select(_e1110, _e1106, (_e1106 > _e1110));
                let _e1116 = select(_e894.member.member_1[0][2], -(_e894.member.member_1[0][2]), (_e894.member.member_1[0][2] < 0.0lf));
                let _e1118 = select(_e1116, _e1112, (_e1112 > _e1116));
                let _e1124 = select(_e894.member.member_1[1][0], -(_e894.member.member_1[1][0]), (_e894.member.member_1[1][0] < 0.0lf));
                let _e1128 = select(_e894.member.member_1[1][1], -(_e894.member.member_1[1][1]), (_e894.member.member_1[1][1] < 0.0lf));
                let _e1130 = select(_e1128, _e1124, (_e1124 > _e1128));
                let _e1134 = select(_e894.member.member_1[1][2], -(_e894.member.member_1[1][2]), (_e894.member.member_1[1][2] < 0.0lf));
                let _e1136 = select(_e1134, _e1130, (_e1130 > _e1134));
                let _e1140 = (select(_e1136, _e1118, (_e1118 > _e1136)) + _e894.member.member_3);
                let _e1146 = select(_e894.member.member_2[0][0], -(_e894.member.member_2[0][0]), (_e894.member.member_2[0][0] < 0.0lf));
                let _e1150 = select(_e894.member.member_2[0][1], -(_e894.member.member_2[0][1]), (_e894.member.member_2[0][1] < 0.0lf));
                let _e1152 = select(_e1150, _e1146, (_e1146 > _e1150));
                let _e1156 = select(_e894.member.member_2[0][2], -(_e894.member.member_2[0][2]), (_e894.member.member_2[0][2] < 0.0lf));
                let _e1158 = select(_e1156, _e1152, (_e1152 > _e1156));
                let _e1164 = select(_e894.member.member_2[1][0], -(_e894.member.member_2[1][0]), (_e894.member.member_2[1][0] < 0.0lf));
                let _e1168 = select(_e894.member.member_2[1][1], -(_e894.member.member_2[1][1]), (_e894.member.member_2[1][1] < 0.0lf));
                let _e1170 = select(_e1168, _e1164, (_e1164 > _e1168));
                let _e1174 = select(_e894.member.member_2[1][2], -(_e894.member.member_2[1][2]), (_e894.member.member_2[1][2] < 0.0lf));
                let _e1176 = select(_e1174, _e1170, (_e1170 > _e1174));
                let _e1180 = (select(_e1176, _e1158, (_e1158 > _e1176)) + _e894.member.member_3);
                let _e1181 = f64(1f);
                let _e1182 = f64(8f);
                let _e1208 = (((((_e1100 * _e1182) * ((_e1140 * _e1182) * _e1180)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e894.member.member_3 * f64(19f)) * ((_e1100 * (_e1140 + _e1180)) + (_e1140 * _e1180)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1181 + _e1100) * ((_e1181 + _e1140) * (_e1181 + _e1180)))));
                let _e1209 = f64(3f);
                let _e1210 = (_e1008 * _e1209);
                let _e1211 = (_e1060 * _e1209);
                let _e1213 = select(_e1211, _e1210, (_e1210 < _e1211));
                let _e1215 = select(_e1050, _e1029, (_e1029 < _e1050));
                let _e1217 = select(_e1215, _e1213, (_e1213 < _e1215));
                let _e1219 = select(_e1211, _e1210, (_e1210 > _e1211));
                let _e1221 = select(_e1050, _e1029, (_e1029 > _e1050));
                let _e1224 = -(select(_e1221, _e1219, (_e1219 > _e1221)));
                if (select(_e1224, _e1217, (_e1217 > _e1224)) > _e1208) {
                    phi_3841_ = type_42(0u, type_42().member_1);
                    phi_3842_ = type_42();
                    phi_3843_ = true;
                } else {
                    let _e1232 = select(_e1008, -(_e1008), (_e1008 < 0.0lf));
                    let _e1235 = select(_e1029, -(_e1029), (_e1029 < 0.0lf));
                    let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                    let _e1240 = select(_e1050, -(_e1050), (_e1050 < 0.0lf));
                    let _e1243 = select(_e1060, -(_e1060), (_e1060 < 0.0lf));
                    let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                    let _e1247 = select(_e1245, _e1237, (_e1237 > _e1245));
                    let _e1249 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1250 = f64(1f);
                    if (_e1247 >= _e1249) {
                        phi_2100_ = (_e1247 <= (_e1250 / _e1249));
                    } else {
                        phi_2100_ = false;
                    }
                    let _e1255 = phi_2100_;
                    if _e1255 {
                        phi_2115_ = (_e1250 / _e1247);
                    } else {
                        phi_2115_ = f64(0f);
                    }
                    let _e1265 = phi_2115_;
                    let _e1266 = f64(0.00000000000022737368f);
                    let _e1268 = (_e516 * f64(0.0625f));
                    local_4 = type_39(array<f64, 4>(_e1008, _e1029, _e1050, _e1060), ((_e1208 * f64(0.34f)) + (_e1247 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1255))), _e1265, select(_e1268, _e1266, (_e1266 < _e1268)));
                    let _e1273 = f64(0f);
                    let _e1274 = f64(1f);
                    let _e1275 = f64(3f);
                    let _e1278 = local_4.member[0u];
                    let _e1281 = local_4.member[1u];
                    let _e1284 = local_4.member[2u];
                    let _e1287 = local_4.member[3u];
                    let _e1294 = local_4.member_2;
                    let _e1295 = ((_e1281 - (_e1275 * _e1278)) * _e1294);
                    let _e1297 = local_4.member_2;
                    let _e1298 = ((_e1284 - _e1281) * _e1297);
                    let _e1300 = local_4.member_2;
                    let _e1301 = (((_e1275 * _e1287) - _e1284) * _e1300);
                    local_2[0u] = _e1273;
                    local_2[1u] = _e1274;
                    local_2[2u] = _e1274;
                    local_2[3u] = _e1274;
                    let _e1308 = ((_e1298 * _e1298) - (_e1295 * _e1301));
                    if (_e1308 > _e1273) {
                        if (_e1308 <= 2.2250738585072014e-308lf) {
                            phi_2248_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1308 > 0.0lf));
                        } else {
                            phi_2191_ = type_16(0i, 5i);
                            phi_2194_ = bitcast<f64>(((bitcast<u64>(_e1308) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1316 = phi_2191_;
                                let _e1318 = phi_2194_;
                                local_7 = _e1318;
                                if (_e1316.member < _e1316.member_1) {
                                    let _e1325 = (_e1316.member + 1i);
                                    phi_2192_ = type_16(select(_e1325, type_17().member_1, select(false, true, ((false == (_e1325 > _e1316.member)) != false))), _e1316.member_1);
                                    phi_2235_ = type_17(1u, _e1316.member);
                                } else {
                                    phi_2192_ = _e1316;
                                    phi_2235_ = type_17(0u, type_17().member_1);
                                }
                                let _e1336 = phi_2192_;
                                let _e1338 = phi_2235_;
                                let _e1341 = (bitcast<i32>(_e1338.member) != 0i);
                                if _e1341 {
                                    phi_2195_ = (0.5lf * (_e1318 + (_e1308 / _e1318)));
                                } else {
                                    phi_2195_ = f64();
                                }
                                let _e1346 = phi_2195_;
                                continue;
                                continuing {
                                    phi_2191_ = _e1336;
                                    phi_2194_ = _e1346;
                                    break if !(_e1341);
                                }
                            }
                            let _e1351 = local_7;
                            phi_2248_ = (_e1351 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1357 = phi_2248_;
                        let _e1362 = -((_e1298 + select(_e1357, -(_e1357), (_e1298 < _e1273))));
                        local_3[0u] = (_e1362 / (_e1362 + _e1301));
                        local_3[1u] = (_e1295 / (_e1295 + _e1362));
                        let _e1371 = local_3[1u];
                        let _e1372 = local_3[0u];
                        if (_e1371 < _e1372) {
                            let _e1375 = local_3[1u];
                            let _e1377 = local_3[0u];
                            local_3[0u] = _e1375;
                            local_3[1u] = _e1377;
                        }
                        phi_2279_ = type_9(0u, 2u);
                        phi_2282_ = 1u;
                        loop {
                            let _e1381 = phi_2279_;
                            let _e1383 = phi_2282_;
                            local_35 = _e1383;
                            let _e1386 = (_e1381.member < _e1381.member_1);
                            let _e1397 = select(type_9().member_1, _e1381.member, _e1386);
                            let _e1399 = (bitcast<i32>(select(0u, 1u, _e1386)) != 0i);
                            if _e1399 {
                                let _e1401 = local_3[_e1397];
                                if (_e1401 > _e1273) {
                                    let _e1404 = local_3[_e1397];
                                    if (_e1404 < _e1274) {
                                        let _e1407 = local_3[_e1397];
                                        local_2[_e1383] = _e1407;
                                        phi_2349_ = (_e1383 + 1u);
                                    } else {
                                        phi_2349_ = _e1383;
                                    }
                                    let _e1411 = phi_2349_;
                                    phi_2350_ = _e1411;
                                } else {
                                    phi_2350_ = _e1383;
                                }
                                let _e1413 = phi_2350_;
                                phi_2283_ = _e1413;
                            } else {
                                phi_2283_ = u32();
                            }
                            let _e1415 = phi_2283_;
                            continue;
                            continuing {
                                phi_2279_ = type_9(select(_e1381.member, (_e1381.member + 1u), _e1386), select(_e1381.member_1, _e1381.member_1, _e1386));
                                phi_2282_ = _e1415;
                                break if !(_e1399);
                            }
                        }
                        let _e2772 = local_35;
                        phi_2351_ = _e2772;
                    } else {
                        phi_2351_ = 1u;
                    }
                    let _e1418 = phi_2351_;
                    local_2[_e1418] = _e1274;
                    let _e1420 = local_2;
                    local_5 = _e1420;
                    let _e1424 = (f64(1f) - _e525);
                    let _e1427 = local_4.member[0u];
                    let _e1430 = local_4.member[1u];
                    let _e1433 = local_4.member[2u];
                    let _e1436 = local_4.member[3u];
                    let _e1447 = ((((_e1427 * _e1424) + (_e1430 * _e525)) * (_e1424 * _e1424)) + (((_e1433 * _e1424) + (_e1436 * _e525)) * (_e525 * _e525)));
                    let _e1452 = local_4.member_1;
                    phi_2409_ = type_9(select(1u, 0u, !((select(_e1447, -(_e1447), (_e1447 < 0.0lf)) > _e1452))), (_e1418 + 1u));
                    loop {
                        let _e1459 = phi_2409_;
                        let _e1462 = (_e1459.member < _e1459.member_1);
                        let _e1473 = select(type_9().member_1, _e1459.member, _e1462);
                        if (bitcast<i32>(select(0u, 1u, _e1462)) != 0i) {
                            if (_e1473 > 0u) {
                                let _e1480 = local_5[(_e1473 - 1u)];
                                let _e1482 = select(_e525, _e1480, (_e1480 > _e525));
                                let _e1484 = local_5[_e1473];
                                let _e1486 = select(_e534, _e1484, (_e1484 < _e534));
                                if (_e1482 <= _e1486) {
                                    let _e1488 = function_2((&local_4), _e543, _e1482, _e1486);
                                    if _e1488 {
                                        phi_3729_ = type_43();
                                        phi_3730_ = u32();
                                        phi_3731_ = false;
                                        phi_3732_ = false;
                                        phi_3733_ = false;
                                    } else {
                                        let _e1490 = (f64(1f) - _e1482);
                                        let _e1493 = local_4.member[0u];
                                        let _e1496 = local_4.member[1u];
                                        let _e1499 = local_4.member[2u];
                                        let _e1502 = local_4.member[3u];
                                        let _e1513 = ((((_e1493 * _e1490) + (_e1496 * _e1482)) * (_e1490 * _e1490)) + (((_e1499 * _e1490) + (_e1502 * _e1482)) * (_e1482 * _e1482)));
                                        let _e1515 = (f64(1f) - _e1486);
                                        let _e1518 = local_4.member[0u];
                                        let _e1521 = local_4.member[1u];
                                        let _e1524 = local_4.member[2u];
                                        let _e1527 = local_4.member[3u];
                                        let _e1538 = ((((_e1518 * _e1515) + (_e1521 * _e1486)) * (_e1515 * _e1515)) + (((_e1524 * _e1515) + (_e1527 * _e1486)) * (_e1486 * _e1486)));
                                        let _e1543 = local_4.member_1;
                                        let _e1544 = (select(_e1513, -(_e1513), (_e1513 < 0.0lf)) > _e1543);
                                        let _e1549 = local_4.member_1;
                                        let _e1550 = (select(_e1538, -(_e1538), (_e1538 < 0.0lf)) > _e1549);
                                        let _e1551 = f64(0f);
                                        let _e1559 = select(select(bool(), select(bool(), ((_e1513 > _e1551) != (_e1538 > _e1551)), _e1550), _e1544), false, select(true, select(true, false, _e1550), _e1544));
                                        if _e1544 {
                                            if _e1550 {
                                                phi_2569_ = type_43(select(f64(1f), type_43().member, _e1559), select(_e1551, type_43().member_1, _e1559), select(_e1559, type_43().member_2, _e1559));
                                                phi_2570_ = _e1559;
                                            } else {
                                                phi_2569_ = type_43();
                                                phi_2570_ = true;
                                            }
                                            let _e1569 = phi_2569_;
                                            let _e1571 = phi_2570_;
                                            phi_2571_ = _e1569;
                                            phi_2572_ = _e1571;
                                        } else {
                                            phi_2571_ = type_43();
                                            phi_2572_ = true;
                                        }
                                        let _e1573 = phi_2571_;
                                        let _e1575 = phi_2572_;
                                        if _e1575 {
                                            if _e1544 {
                                                let _e1579 = select(f64(1f), f64(-1f), (_e1513 < _e1551));
                                                let _e1581 = local_4.member_3;
                                                let _e1582 = f64(0.5f);
                                                let _e1583 = f64(3f);
                                                let _e1586 = local_4.member[0u];
                                                let _e1589 = local_4.member[1u];
                                                let _e1592 = local_4.member[2u];
                                                let _e1595 = local_4.member[3u];
                                                let _e1598 = (_e1592 - _e1589);
                                                phi_2607_ = type_9(0u, 64u);
                                                phi_2610_ = _e1486;
                                                phi_2612_ = _e1482;
                                                phi_2614_ = (_e1582 * (_e1482 + _e1486));
                                                loop {
                                                    let _e1604 = phi_2607_;
                                                    let _e1606 = phi_2610_;
                                                    let _e1608 = phi_2612_;
                                                    let _e1610 = phi_2614_;
                                                    local_10 = _e1608;
                                                    let _e1613 = (_e1604.member < _e1604.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1613)) != 0i) {
                                                        let _e1626 = (f64(1f) - _e1610);
                                                        let _e1629 = local_4.member[0u];
                                                        let _e1632 = local_4.member[1u];
                                                        let _e1635 = local_4.member[2u];
                                                        let _e1638 = local_4.member[3u];
                                                        let _e1652 = local_4.member_1;
                                                        let _e1653 = ((_e1579 * ((((_e1629 * _e1626) + (_e1632 * _e1610)) * (_e1626 * _e1626)) + (((_e1635 * _e1626) + (_e1638 * _e1610)) * (_e1610 * _e1610)))) - _e1652);
                                                        let _e1655 = (_e1653 > f64(0f));
                                                        let _e1656 = select(_e1610, _e1606, _e1655);
                                                        let _e1657 = select(_e1608, _e1610, _e1655);
                                                        let _e1659 = ((_e1656 - _e1657) > _e1581);
                                                        if _e1659 {
                                                            let _e1661 = (f64(1f) - _e1610);
                                                            let _e1673 = (-(_e1653) / (_e1579 * (((((_e1589 - (_e1583 * _e1586)) * _e1661) + (_e1598 * _e1610)) * _e1661) + (((_e1598 * _e1661) + (((_e1583 * _e1595) - _e1592) * _e1610)) * _e1610))));
                                                            let _e1681 = ((_e1610 + _e1673) + select(-((_e1582 * _e1581)), (_e1582 * _e1581), (_e1653 > f64(0f))));
                                                            if (_e1681 > _e1657) {
                                                                phi_2728_ = select(true, select(true, false, (select(_e1673, -(_e1673), (_e1673 < 0.0lf)) < (_e1582 * (_e1656 - _e1657)))), (_e1681 < _e1656));
                                                            } else {
                                                                phi_2728_ = true;
                                                            }
                                                            let _e1693 = phi_2728_;
                                                            phi_2735_ = select(_e1681, (_e1582 * (_e1657 + _e1656)), _e1693);
                                                            phi_2736_ = false;
                                                        } else {
                                                            phi_2735_ = f64();
                                                            phi_2736_ = true;
                                                        }
                                                        let _e1698 = phi_2735_;
                                                        let _e1700 = phi_2736_;
                                                        phi_2611_ = _e1656;
                                                        phi_2613_ = _e1657;
                                                        phi_2615_ = _e1698;
                                                        phi_2737_ = _e1657;
                                                        phi_2738_ = _e1659;
                                                        phi_2739_ = _e1700;
                                                    } else {
                                                        phi_2611_ = f64();
                                                        phi_2613_ = f64();
                                                        phi_2615_ = f64();
                                                        phi_2737_ = f64();
                                                        phi_2738_ = false;
                                                        phi_2739_ = false;
                                                    }
                                                    let _e1702 = phi_2611_;
                                                    let _e1704 = phi_2613_;
                                                    let _e1706 = phi_2615_;
                                                    let _e1708 = phi_2737_;
                                                    let _e1710 = phi_2738_;
                                                    let _e1712 = phi_2739_;
                                                    local_8 = _e1712;
                                                    local_9 = _e1708;
                                                    continue;
                                                    continuing {
                                                        phi_2607_ = type_9(select(_e1604.member, (_e1604.member + 1u), _e1613), select(_e1604.member_1, _e1604.member_1, _e1613));
                                                        phi_2610_ = _e1702;
                                                        phi_2612_ = _e1704;
                                                        phi_2614_ = _e1706;
                                                        break if !(_e1710);
                                                    }
                                                }
                                                let _e1715 = local_8;
                                                let _e1717 = local_9;
                                                let _e1719 = local_10;
                                                phi_2744_ = select(_e1719, _e1717, _e1715);
                                            } else {
                                                phi_2744_ = _e1482;
                                            }
                                            let _e1722 = phi_2744_;
                                            if _e1550 {
                                                let _e1728 = local_4.member_3;
                                                let _e1730 = local_4.member_3;
                                                phi_2762_ = type_9(0u, 64u);
                                                phi_2765_ = (_e1728 + _e1730);
                                                loop {
                                                    let _e1733 = phi_2762_;
                                                    let _e1735 = phi_2765_;
                                                    let _e1738 = (_e1733.member < _e1733.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1738)) != 0i) {
                                                        let _e1750 = (_e1722 + _e1735);
                                                        if (_e1750 < _e1486) {
                                                            let _e1753 = (f64(1f) - _e1750);
                                                            let _e1756 = local_4.member[0u];
                                                            let _e1759 = local_4.member[1u];
                                                            let _e1762 = local_4.member[2u];
                                                            let _e1765 = local_4.member[3u];
                                                            let _e1779 = local_4.member_1;
                                                            let _e1780 = ((select(f64(1f), f64(-1f), (_e1538 < _e1551)) * ((((_e1756 * _e1753) + (_e1759 * _e1750)) * (_e1753 * _e1753)) + (((_e1762 * _e1753) + (_e1765 * _e1750)) * (_e1750 * _e1750)))) > _e1779);
                                                            phi_2831_ = select((_e1735 + _e1735), f64(), _e1780);
                                                            phi_2832_ = select(true, false, _e1780);
                                                            phi_2833_ = _e1780;
                                                            phi_2834_ = false;
                                                        } else {
                                                            phi_2831_ = f64();
                                                            phi_2832_ = false;
                                                            phi_2833_ = false;
                                                            phi_2834_ = true;
                                                        }
                                                        let _e1785 = phi_2831_;
                                                        let _e1787 = phi_2832_;
                                                        let _e1789 = phi_2833_;
                                                        let _e1791 = phi_2834_;
                                                        phi_2835_ = _e1750;
                                                        phi_2766_ = _e1785;
                                                        phi_2836_ = _e1787;
                                                        phi_2837_ = _e1789;
                                                        phi_2838_ = _e1791;
                                                        phi_2839_ = false;
                                                    } else {
                                                        phi_2835_ = f64();
                                                        phi_2766_ = f64();
                                                        phi_2836_ = false;
                                                        phi_2837_ = false;
                                                        phi_2838_ = false;
                                                        phi_2839_ = true;
                                                    }
                                                    let _e1793 = phi_2835_;
                                                    let _e1795 = phi_2766_;
                                                    let _e1797 = phi_2836_;
                                                    let _e1799 = phi_2837_;
                                                    let _e1801 = phi_2838_;
                                                    let _e1803 = phi_2839_;
                                                    local_11 = _e1799;
                                                    local_12 = _e1801;
                                                    local_13 = _e1799;
                                                    local_14 = _e1803;
                                                    local_15 = _e1793;
                                                    continue;
                                                    continuing {
                                                        phi_2762_ = type_9(select(_e1733.member, (_e1733.member + 1u), _e1738), select(_e1733.member_1, _e1733.member_1, _e1738));
                                                        phi_2765_ = _e1795;
                                                        break if !(_e1797);
                                                    }
                                                }
                                                let _e1806 = local_11;
                                                let _e1808 = local_12;
                                                let _e1811 = local_13;
                                                let _e1813 = local_14;
                                                let _e1817 = local_15;
                                                phi_2853_ = select(_e1817, _e1486, select(select(_e1813, false, _e1811), true, select(_e1808, false, _e1806)));
                                            } else {
                                                phi_2853_ = _e1486;
                                            }
                                            let _e1820 = phi_2853_;
                                            phi_2855_ = type_43(_e1722, _e1820, _e1559);
                                        } else {
                                            phi_2855_ = _e1573;
                                        }
                                        let _e1823 = phi_2855_;
                                        if (_e1823.member > _e1823.member_1) {
                                            phi_3725_ = u32();
                                            phi_3726_ = true;
                                            phi_3727_ = false;
                                            phi_3728_ = false;
                                        } else {
                                            let _e1828 = (_e1823.member > _e543);
                                            if _e1828 {
                                                phi_3722_ = u32();
                                                phi_3723_ = false;
                                                phi_3724_ = false;
                                            } else {
                                                let _e1833 = ((_e1823.member_1 - _e1823.member) * f64(0.5f));
                                                let _e1834 = (_e1823.member + _e1833);
                                                let _e1837 = (_e1833 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1844 = select(_e894.member.member[0][0], -(_e894.member.member[0][0]), (_e894.member.member[0][0] < 0.0lf));
                                                let _e1848 = select(_e894.member.member[0][1], -(_e894.member.member[0][1]), (_e894.member.member[0][1] < 0.0lf));
                                                let _e1850 = select(_e1848, _e1844, (_e1844 > _e1848));
                                                let _e1854 = select(_e894.member.member[0][2], -(_e894.member.member[0][2]), (_e894.member.member[0][2] < 0.0lf));
                                                let _e1856 = select(_e1854, _e1850, (_e1850 > _e1854));
                                                let _e1862 = select(_e894.member.member[1][0], -(_e894.member.member[1][0]), (_e894.member.member[1][0] < 0.0lf));
                                                let _e1866 = select(_e894.member.member[1][1], -(_e894.member.member[1][1]), (_e894.member.member[1][1] < 0.0lf));
                                                let _e1868 = select(_e1866, _e1862, (_e1862 > _e1866));
                                                let _e1872 = select(_e894.member.member[1][2], -(_e894.member.member[1][2]), (_e894.member.member[1][2] < 0.0lf));
                                                let _e1874 = select(_e1872, _e1868, (_e1868 > _e1872));
                                                let _e1895 = (_e894.member.member[0][0] + ((_e894.member.member[1][0] - _e894.member.member[0][0]) * _e1834));
                                                let _e1897 = (_e894.member.member[0][1] + ((_e894.member.member[1][1] - _e894.member.member[0][1]) * _e1834));
                                                let _e1899 = (_e894.member.member[0][2] + ((_e894.member.member[1][2] - _e894.member.member[0][2]) * _e1834));
                                                let _e1906 = (_e894.member.member[1][0] - _e894.member.member[0][0]);
                                                let _e1909 = (_e894.member.member[1][1] - _e894.member.member[0][1]);
                                                let _e1912 = (_e894.member.member[1][2] - _e894.member.member[0][2]);
                                                let _e1915 = select(_e1906, -(_e1906), (_e1906 < 0.0lf));
                                                let _e1918 = select(_e1909, -(_e1909), (_e1909 < 0.0lf));
                                                let _e1920 = select(_e1918, _e1915, (_e1915 > _e1918));
                                                let _e1923 = select(_e1912, -(_e1912), (_e1912 < 0.0lf));
                                                let _e1933 = ((((_e1837 * select(_e1923, _e1920, (_e1920 > _e1923))) * f64(1.01f)) + ((select(_e1874, _e1856, (_e1856 > _e1874)) + _e894.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e894.member.member_3);
                                                let _e1936 = select(_e1895, -(_e1895), (_e1895 < 0.0lf));
                                                let _e1939 = select(_e1897, -(_e1897), (_e1897 < 0.0lf));
                                                let _e1941 = select(_e1939, _e1936, (_e1936 > _e1939));
                                                let _e1944 = select(_e1899, -(_e1899), (_e1899 < 0.0lf));
                                                let _e1947 = (select(_e1944, _e1941, (_e1941 > _e1944)) + _e1933);
                                                let _e1954 = select(_e894.member.member_1[0][0], -(_e894.member.member_1[0][0]), (_e894.member.member_1[0][0] < 0.0lf));
                                                let _e1958 = select(_e894.member.member_1[0][1], -(_e894.member.member_1[0][1]), (_e894.member.member_1[0][1] < 0.0lf));
                                                let _e1960 = select(_e1958, _e1954, (_e1954 > _e1958));
                                                let _e1964 = select(_e894.member.member_1[0][2], -(_e894.member.member_1[0][2]), (_e894.member.member_1[0][2] < 0.0lf));
                                                let _e1966 = select(_e1964, _e1960, (_e1960 > _e1964));
                                                let _e1972 = select(_e894.member.member_1[1][0], -(_e894.member.member_1[1][0]), (_e894.member.member_1[1][0] < 0.0lf));
                                                let _e1976 = select(_e894.member.member_1[1][1], -(_e894.member.member_1[1][1]), (_e894.member.member_1[1][1] < 0.0lf));
                                                let _e1978 = select(_e1976, _e1972, (_e1972 > _e1976));
                                                let _e1982 = select(_e894.member.member_1[1][2], -(_e894.member.member_1[1][2]), (_e894.member.member_1[1][2] < 0.0lf));
                                                let _e1984 = select(_e1982, _e1978, (_e1978 > _e1982));
                                                let _e2005 = (_e894.member.member_1[0][0] + ((_e894.member.member_1[1][0] - _e894.member.member_1[0][0]) * _e1834));
                                                let _e2007 = (_e894.member.member_1[0][1] + ((_e894.member.member_1[1][1] - _e894.member.member_1[0][1]) * _e1834));
                                                let _e2009 = (_e894.member.member_1[0][2] + ((_e894.member.member_1[1][2] - _e894.member.member_1[0][2]) * _e1834));
                                                let _e2016 = (_e894.member.member_1[1][0] - _e894.member.member_1[0][0]);
                                                let _e2019 = (_e894.member.member_1[1][1] - _e894.member.member_1[0][1]);
                                                let _e2022 = (_e894.member.member_1[1][2] - _e894.member.member_1[0][2]);
                                                let _e2025 = select(_e2016, -(_e2016), (_e2016 < 0.0lf));
                                                let _e2028 = select(_e2019, -(_e2019), (_e2019 < 0.0lf));
                                                let _e2030 = select(_e2028, _e2025, (_e2025 > _e2028));
                                                let _e2033 = select(_e2022, -(_e2022), (_e2022 < 0.0lf));
                                                let _e2043 = ((((_e1837 * select(_e2033, _e2030, (_e2030 > _e2033))) * f64(1.01f)) + ((select(_e1984, _e1966, (_e1966 > _e1984)) + _e894.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e894.member.member_3);
                                                let _e2046 = select(_e2005, -(_e2005), (_e2005 < 0.0lf));
                                                let _e2049 = select(_e2007, -(_e2007), (_e2007 < 0.0lf));
                                                let _e2051 = select(_e2049, _e2046, (_e2046 > _e2049));
                                                let _e2054 = select(_e2009, -(_e2009), (_e2009 < 0.0lf));
                                                let _e2057 = (select(_e2054, _e2051, (_e2051 > _e2054)) + _e2043);
                                                let _e2064 = select(_e894.member.member_2[0][0], -(_e894.member.member_2[0][0]), (_e894.member.member_2[0][0] < 0.0lf));
                                                let _e2068 = select(_e894.member.member_2[0][1], -(_e894.member.member_2[0][1]), (_e894.member.member_2[0][1] < 0.0lf));
                                                let _e2070 = select(_e2068, _e2064, (_e2064 > _e2068));
                                                let _e2074 = select(_e894.member.member_2[0][2], -(_e894.member.member_2[0][2]), (_e894.member.member_2[0][2] < 0.0lf));
                                                let _e2076 = select(_e2074, _e2070, (_e2070 > _e2074));
                                                let _e2082 = select(_e894.member.member_2[1][0], -(_e894.member.member_2[1][0]), (_e894.member.member_2[1][0] < 0.0lf));
                                                let _e2086 = select(_e894.member.member_2[1][1], -(_e894.member.member_2[1][1]), (_e894.member.member_2[1][1] < 0.0lf));
                                                let _e2088 = select(_e2086, _e2082, (_e2082 > _e2086));
                                                let _e2092 = select(_e894.member.member_2[1][2], -(_e894.member.member_2[1][2]), (_e894.member.member_2[1][2] < 0.0lf));
                                                let _e2094 = select(_e2092, _e2088, (_e2088 > _e2092));
                                                let _e2115 = (_e894.member.member_2[0][0] + ((_e894.member.member_2[1][0] - _e894.member.member_2[0][0]) * _e1834));
                                                let _e2117 = (_e894.member.member_2[0][1] + ((_e894.member.member_2[1][1] - _e894.member.member_2[0][1]) * _e1834));
                                                let _e2119 = (_e894.member.member_2[0][2] + ((_e894.member.member_2[1][2] - _e894.member.member_2[0][2]) * _e1834));
                                                let _e2126 = (_e894.member.member_2[1][0] - _e894.member.member_2[0][0]);
                                                let _e2129 = (_e894.member.member_2[1][1] - _e894.member.member_2[0][1]);
                                                let _e2132 = (_e894.member.member_2[1][2] - _e894.member.member_2[0][2]);
                                                let _e2135 = select(_e2126, -(_e2126), (_e2126 < 0.0lf));
                                                let _e2138 = select(_e2129, -(_e2129), (_e2129 < 0.0lf));
                                                let _e2140 = select(_e2138, _e2135, (_e2135 > _e2138));
                                                let _e2143 = select(_e2132, -(_e2132), (_e2132 < 0.0lf));
                                                let _e2153 = ((((_e1837 * select(_e2143, _e2140, (_e2140 > _e2143))) * f64(1.01f)) + ((select(_e2094, _e2076, (_e2076 > _e2094)) + _e894.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e894.member.member_3);
                                                let _e2156 = select(_e2115, -(_e2115), (_e2115 < 0.0lf));
                                                let _e2159 = select(_e2117, -(_e2117), (_e2117 < 0.0lf));
                                                let _e2161 = select(_e2159, _e2156, (_e2156 > _e2159));
                                                let _e2164 = select(_e2119, -(_e2119), (_e2119 < 0.0lf));
                                                let _e2167 = (select(_e2164, _e2161, (_e2161 > _e2164)) + _e2153);
                                                let _e2170 = ((_e2007 * _e2119) - (_e2009 * _e2117));
                                                let _e2173 = ((_e2009 * _e2115) - (_e2005 * _e2119));
                                                let _e2176 = ((_e2005 * _e2117) - (_e2007 * _e2115));
                                                let _e2191 = select(false, (select(_e2170, -(_e2170), (_e2170 < 0.0lf)) > select(_e2176, -(_e2176), (_e2176 < 0.0lf))), (select(_e2170, -(_e2170), (_e2170 < 0.0lf)) > select(_e2173, -(_e2173), (_e2173 < 0.0lf))));
                                                let _e2206 = select((select(_e2173, -(_e2173), (_e2173 < 0.0lf)) > select(_e2176, -(_e2176), (_e2176 < 0.0lf))), false, (select(_e2170, -(_e2170), (_e2170 < 0.0lf)) > select(_e2173, -(_e2173), (_e2173 < 0.0lf))));
                                                let _e2209 = select(select(_e1895, _e1897, _e2191), _e1899, _e2206);
                                                let _e2210 = select(select(_e1897, _e1899, _e2191), _e1895, _e2206);
                                                let _e2213 = select(select(_e2005, _e2007, _e2191), _e2009, _e2206);
                                                let _e2214 = select(select(_e2007, _e2009, _e2191), _e2005, _e2206);
                                                let _e2217 = select(select(_e2115, _e2117, _e2191), _e2119, _e2206);
                                                let _e2218 = select(select(_e2117, _e2119, _e2191), _e2115, _e2206);
                                                let _e2221 = ((_e2213 * _e2218) - (_e2214 * _e2217));
                                                let _e2222 = f64(1f);
                                                let _e2223 = f64(2f);
                                                let _e2241 = (((((_e2043 * _e2167) + (_e2057 * _e2153)) * f64(2.01f)) + (((_e2057 * _e2223) * (_e2167 * _e2223)) * (1.1102230246251565e-16lf * _e2223))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2222 + _e2057) * (_e2222 + _e2167))));
                                                if (select(_e2221, -(_e2221), (_e2221 < 0.0lf)) > _e2241) {
                                                    let _e2250 = select(f64(1f), f64(-1f), (_e2221 < f64(0f)));
                                                    let _e2254 = f64(1f);
                                                    let _e2255 = f64(2f);
                                                    let _e2273 = (((((_e1933 * _e2167) + (_e1947 * _e2153)) * f64(2.01f)) + (((_e1947 * _e2255) * (_e2167 * _e2255)) * (1.1102230246251565e-16lf * _e2255))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2254 + _e1947) * (_e2254 + _e2167))));
                                                    let _e2277 = f64(1f);
                                                    let _e2278 = f64(2f);
                                                    let _e2296 = (((((_e2043 * _e1947) + (_e2057 * _e1933)) * f64(2.01f)) + (((_e2057 * _e2278) * (_e1947 * _e2278)) * (1.1102230246251565e-16lf * _e2278))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2277 + _e2057) * (_e2277 + _e1947))));
                                                    let _e2297 = (_e2221 * _e2250);
                                                    let _e2298 = (((_e2209 * _e2218) - (_e2210 * _e2217)) * _e2250);
                                                    let _e2299 = (((_e2213 * _e2210) - (_e2214 * _e2209)) * _e2250);
                                                    let _e2313 = (((select(_e2297, -(_e2297), (_e2297 < 0.0lf)) + select(_e2298, -(_e2298), (_e2298 < 0.0lf))) + select(_e2299, -(_e2299), (_e2299 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e222.member != 0u) {
                                                        phi_3620_ = array<type_35, 4>(type_35(_e2298, _e2273), type_35(_e2299, _e2296), type_35((_e2297 - _e2298), ((_e2241 + _e2273) + _e2313)), type_35((_e2297 - _e2299), ((_e2241 + _e2296) + _e2313)));
                                                    } else {
                                                        let _e2316 = ((_e2297 - _e2298) - _e2299);
                                                        let _e2319 = (((_e2241 + _e2273) + _e2296) + _e2313);
                                                        phi_3620_ = array<type_35, 4>(type_35(_e2298, _e2273), type_35(_e2299, _e2296), type_35(_e2316, _e2319), type_35(_e2316, _e2319));
                                                    }
                                                    let _e2337 = phi_3620_;
                                                    local_1 = array<type_35, 4>(type_35(_e2337[0].member, _e2337[0].member_1), type_35(_e2337[1].member, _e2337[1].member_1), type_35(_e2337[2].member, _e2337[2].member_1), type_35(_e2337[3].member, _e2337[3].member_1));
                                                    phi_3640_ = type_9(0u, 4u);
                                                    phi_3643_ = true;
                                                    loop {
                                                        let _e2356 = phi_3640_;
                                                        let _e2358 = phi_3643_;
                                                        local_17 = _e2358;
                                                        let _e2361 = (_e2356.member < _e2356.member_1);
                                                        let _e2372 = select(type_9().member_1, _e2356.member, _e2361);
                                                        if (bitcast<i32>(select(0u, 1u, _e2361)) != 0i) {
                                                            let _e2377 = local_1[_e2372].member;
                                                            let _e2380 = local_1[_e2372].member_1;
                                                            let _e2382 = (_e2377 < -(_e2380));
                                                            phi_3644_ = select((_e2358 && (_e2377 > _e2380)), bool(), _e2382);
                                                            phi_3695_ = select(true, false, _e2382);
                                                            phi_3696_ = _e2382;
                                                        } else {
                                                            phi_3644_ = bool();
                                                            phi_3695_ = false;
                                                            phi_3696_ = false;
                                                        }
                                                        let _e2388 = phi_3644_;
                                                        let _e2390 = phi_3695_;
                                                        let _e2392 = phi_3696_;
                                                        local_16 = _e2392;
                                                        continue;
                                                        continuing {
                                                            phi_3640_ = type_9(select(_e2356.member, (_e2356.member + 1u), _e2361), select(_e2356.member_1, _e2356.member_1, _e2361));
                                                            phi_3643_ = _e2388;
                                                            break if !(_e2390);
                                                        }
                                                    }
                                                    let _e2395 = local_16;
                                                    let _e2396 = select(true, false, _e2395);
                                                    let _e2398 = local_17;
                                                    phi_3710_ = select(u32(), select(2u, 1u, _e2398), _e2396);
                                                    phi_3711_ = 0u;
                                                    phi_3712_ = select(true, false, _e2396);
                                                } else {
                                                    phi_3710_ = u32();
                                                    phi_3711_ = 2u;
                                                    phi_3712_ = true;
                                                }
                                                let _e2403 = phi_3710_;
                                                let _e2405 = phi_3711_;
                                                let _e2407 = phi_3712_;
                                                let _e2408 = select(_e2403, _e2405, _e2407);
                                                let _e2409 = (_e2408 == 0u);
                                                phi_3722_ = _e2408;
                                                phi_3723_ = _e2409;
                                                phi_3724_ = select(true, false, _e2409);
                                            }
                                            let _e2412 = phi_3722_;
                                            let _e2414 = phi_3723_;
                                            let _e2416 = phi_3724_;
                                            phi_3725_ = _e2412;
                                            phi_3726_ = _e2414;
                                            phi_3727_ = _e1828;
                                            phi_3728_ = _e2416;
                                        }
                                        let _e2418 = phi_3725_;
                                        let _e2420 = phi_3726_;
                                        let _e2422 = phi_3727_;
                                        let _e2424 = phi_3728_;
                                        phi_3729_ = _e1823;
                                        phi_3730_ = _e2418;
                                        phi_3731_ = _e2420;
                                        phi_3732_ = _e2422;
                                        phi_3733_ = _e2424;
                                    }
                                    let _e2426 = phi_3729_;
                                    let _e2428 = phi_3730_;
                                    let _e2430 = phi_3731_;
                                    let _e2432 = phi_3732_;
                                    let _e2434 = phi_3733_;
                                    phi_3734_ = _e2426;
                                    phi_3735_ = _e2428;
                                    phi_3736_ = _e2430;
                                    phi_3737_ = _e1488;
                                    phi_3738_ = _e2432;
                                    phi_3739_ = _e2434;
                                } else {
                                    phi_3734_ = type_43();
                                    phi_3735_ = u32();
                                    phi_3736_ = true;
                                    phi_3737_ = false;
                                    phi_3738_ = false;
                                    phi_3739_ = false;
                                }
                                let _e2436 = phi_3734_;
                                let _e2438 = phi_3735_;
                                let _e2440 = phi_3736_;
                                let _e2442 = phi_3737_;
                                let _e2444 = phi_3738_;
                                let _e2446 = phi_3739_;
                                phi_3746_ = _e2436;
                                phi_3747_ = _e2438;
                                phi_3748_ = _e2440;
                                phi_3749_ = select(_e2442, false, _e2440);
                                phi_3750_ = select(_e2444, false, _e2440);
                                phi_3751_ = select(_e2446, false, _e2440);
                                phi_3752_ = false;
                            } else {
                                phi_3746_ = type_43();
                                phi_3747_ = u32();
                                phi_3748_ = false;
                                phi_3749_ = false;
                                phi_3750_ = false;
                                phi_3751_ = false;
                                phi_3752_ = true;
                            }
                            let _e2451 = phi_3746_;
                            let _e2453 = phi_3747_;
                            let _e2455 = phi_3748_;
                            let _e2457 = phi_3749_;
                            let _e2459 = phi_3750_;
                            let _e2461 = phi_3751_;
                            let _e2463 = phi_3752_;
                            phi_3753_ = _e2451;
                            phi_3754_ = _e2453;
                            phi_3755_ = type_43(_e525, _e525, false);
                            phi_3756_ = _e2455;
                            phi_3757_ = false;
                            phi_3758_ = _e2457;
                            phi_3759_ = _e2459;
                            phi_3760_ = _e2461;
                            phi_3761_ = _e2463;
                        } else {
                            phi_3753_ = type_43();
                            phi_3754_ = u32();
                            phi_3755_ = type_43();
                            phi_3756_ = false;
                            phi_3757_ = true;
                            phi_3758_ = false;
                            phi_3759_ = false;
                            phi_3760_ = false;
                            phi_3761_ = false;
                        }
                        let _e2465 = phi_3753_;
                        let _e2467 = phi_3754_;
                        let _e2469 = phi_3755_;
                        let _e2471 = phi_3756_;
                        let _e2473 = phi_3757_;
                        let _e2475 = phi_3758_;
                        let _e2477 = phi_3759_;
                        let _e2479 = phi_3760_;
                        let _e2481 = phi_3761_;
                        local_18 = _e2473;
                        local_19 = _e2473;
                        local_20 = _e2473;
                        local_21 = _e2475;
                        local_22 = _e2473;
                        local_23 = _e2477;
                        local_24 = _e2473;
                        local_25 = _e2479;
                        local_26 = _e2473;
                        local_27 = _e2481;
                        local_28 = _e2467;
                        local_29 = _e2465;
                        local_30 = _e2465;
                        local_31 = _e2465;
                        local_32 = _e2465;
                        local_33 = _e2469;
                        local_34 = _e2465;
                        continue;
                        continuing {
                            phi_2409_ = type_9(select(_e1459.member, (_e1459.member + 1u), _e1462), select(_e1459.member_1, _e1459.member_1, _e1462));
                            break if !(_e2471);
                        }
                    }
                    let _e2485 = local_18;
                    let _e2490 = local_19;
                    let _e2494 = local_20;
                    let _e2496 = local_21;
                    let _e2497 = select(_e2496, false, _e2494);
                    let _e2499 = local_22;
                    let _e2501 = local_23;
                    let _e2504 = local_24;
                    let _e2506 = local_25;
                    let _e2509 = local_26;
                    let _e2511 = local_27;
                    let _e2518 = select(select(_e2501, false, _e2499), false, _e2497);
                    if select(select(select(_e2506, false, _e2504), false, _e2497), false, _e2518) {
                        let _e2529 = local_28;
                        let _e2532 = local_29;
                        if select(false, _e2532.member_2, (_e2529 == 1u)) {
                            let _e2536 = local_30;
                            let _e2539 = local_31;
                            let _e2542 = ((_e2536.member_1 - _e2539.member) <= (_e516 * f64(0.99f)));
                            let _e2544 = local_32;
                            phi_3810_ = type_42(select(type_42().member, 1u, _e2542), select(type_42().member_1, _e2544.member, _e2542));
                            phi_3811_ = select(true, false, _e2542);
                        } else {
                            phi_3810_ = type_42();
                            phi_3811_ = true;
                        }
                        let _e2553 = phi_3810_;
                        let _e2555 = phi_3811_;
                        phi_3816_ = _e2553;
                        phi_3817_ = select(true, false, _e2555);
                        phi_3818_ = false;
                        phi_3819_ = _e2555;
                    } else {
                        phi_3816_ = type_42(select(select(type_42().member, 0u, _e2497), 0u, _e2518), select(select(type_42().member_1, type_42().member_1, _e2497), type_42().member_1, _e2518));
                        phi_3817_ = select(_e2497, true, _e2518);
                        phi_3818_ = select(select(select(_e2511, false, _e2509), false, _e2497), false, _e2518);
                        phi_3819_ = false;
                    }
                    let _e2558 = phi_3816_;
                    let _e2560 = phi_3817_;
                    let _e2562 = phi_3818_;
                    let _e2564 = phi_3819_;
                    let _e2565 = select(_e2562, false, _e2560);
                    let _e2568 = local_33;
                    let _e2571 = local_34;
                    let _e2574 = select(select(_e2564, false, _e2560), true, _e2565);
                    phi_3841_ = type_42(select(_e2558.member, 2u, _e2574), select(_e2558.member_1, select(_e2571.member, _e2568.member, _e2565), _e2574));
                    phi_3842_ = type_42(select(type_42().member, 0u, _e2485), select(type_42().member_1, type_42().member_1, _e2490));
                    phi_3843_ = select(select(_e2560, false, _e2565), true, _e2574);
                }
                let _e2585 = phi_3841_;
                let _e2587 = phi_3842_;
                let _e2589 = phi_3843_;
                let _e2592 = select(_e2587.member, _e2585.member, _e2589);
                let _e2595 = select(_e2587.member_1, _e2585.member_1, _e2589);
                let _e2601 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e2595 > _e525)), (_e2592 == 1u))));
                switch bitcast<i32>(_e2592) {
                    case 0: {
                        phi_3887_ = type_34(0u, _e2601, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e2605 = function_1(_e2595);
                        phi_3887_ = type_34(0u, _e2601, _e2605, true);
                        break;
                    }
                    case 2: {
                        let _e2603 = function_1(_e2595);
                        phi_3887_ = type_34(1u, _e2601, _e2603, true);
                        break;
                    }
                    default: {
                        phi_3887_ = type_34();
                        break;
                    }
                }
                let _e2609 = phi_3887_;
                local_6 = type_34(_e2609.member, _e2609.member_1, array<u32, 2>(_e2609.member_2[0], _e2609.member_2[1]), _e2609.member_3);
                phi_3896_ = type_9(_e180, _e183);
            } else {
                phi_3896_ = type_9(0u, 0u);
            }
            let _e2619 = phi_3896_;
            let _e2625 = params.member.member_2.member;
            let _e2628 = local_6.member;
            let _e2629 = (_e2628 == 0u);
            let _e2632 = select(select((_e2625 > 0u), bool(), _e2629), false, _e2629);
            if _e2632 {
                local = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e2633 = local_6;
                local = _e2633;
            }
            let _e2635 = local.member;
            let _e2637 = select(true, false, (_e2635 == 0u));
            let _e2639 = local.member_3;
            if _e2639 {
                if _e2637 {
                    phi_3953_ = true;
                } else {
                    let _e2641 = params.member.member.member_1;
                    phi_3953_ = ((_e2641 & 16u) != 0u);
                }
                let _e2645 = phi_3953_;
                phi_3954_ = _e2645;
            } else {
                phi_3954_ = false;
            }
            let _e2647 = phi_3954_;
            let _e2649 = local.member_3;
            if _e2649 {
                if _e2637 {
                } else {
                    let _e2651 = local.member_2;
                    let _e2656 = ((_e2651[1] >> bitcast<u32>(20i)) & 2047u);
                    let _e2670 = atomicMin((&earliest.member[0u]), select(((((_e2656 - 896u) << bitcast<u32>(23i)) | ((_e2651[1] & 1048575u) << bitcast<u32>(3i))) | (_e2651[0] >> bitcast<u32>(29i))), 0u, (_e2656 <= 896u)));
                }
            }
            if (_e97 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2647 {
                let _e2674 = atomicAdd((&counters[0u]), 1u);
                phi_3998_ = _e2674;
            } else {
                phi_3998_ = 0u;
            }
            let _e2676 = phi_3998_;
            workgroupBarrier();
            if (_e97 == 0u) {
                let _e2679 = atomicLoad((&counters[0u]));
                if (_e2679 > 0u) {
                    let _e2682 = atomicAdd((&contacts.member[0u]), _e2679);
                    atomicStore((&counters[1u]), _e2682);
                }
            }
            workgroupBarrier();
            let _e2685 = atomicLoad((&counters[1u]));
            let _e2686 = (_e2685 + _e2676);
            if _e2647 {
                let _e2688 = params.member.member_1.member_3;
                if (_e2686 < _e2688) {
                    let _e2694 = (7u * _e2686);
                    atomicStore((&contacts.member[(4u + _e2694)]), select(1u, 0u, ((_e2619.member_1 & 2147483648u) == 0u)));
                    let _e2699 = local.member;
                    atomicStore((&contacts.member[(_e2694 + 5u)]), _e2699);
                    atomicStore((&contacts.member[(_e2694 + 6u)]), _e2619.member);
                    atomicStore((&contacts.member[(_e2694 + 7u)]), (_e2619.member_1 & 2147483647u));
                    let _e2708 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e2694 + 8u)]), _e2708);
                    let _e2713 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e2694 + 9u)]), _e2713);
                    let _e2717 = local.member_1;
                    atomicStore((&contacts.member[(_e2694 + 10u)]), _e2717);
                }
            }
            workgroupBarrier();
            if (_e97 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2632 {
                let _e2722 = atomicAdd((&counters[0u]), 1u);
                phi_4080_ = _e2722;
            } else {
                phi_4080_ = 0u;
            }
            let _e2724 = phi_4080_;
            workgroupBarrier();
            if (_e97 == 0u) {
                let _e2727 = atomicLoad((&counters[0u]));
                if (_e2727 > 0u) {
                    let _e2730 = atomicAdd((&left.member[0u]), _e2727);
                    atomicStore((&counters[1u]), _e2730);
                }
            }
            workgroupBarrier();
            let _e2733 = atomicLoad((&counters[1u]));
            let _e2734 = (_e2733 + _e2724);
            if _e2632 {
                if (_e2734 < _e2625) {
                    let _e2736 = (2u * _e2734);
                    atomicStore((&left.member[(4u + _e2736)]), _e2619.member);
                    atomicStore((&left.member[(_e2736 + 5u)]), _e2619.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_422_ = type_9(select(_e151.member, (_e151.member + 1u), _e154), select(_e151.member_1, _e151.member_1, _e154));
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
