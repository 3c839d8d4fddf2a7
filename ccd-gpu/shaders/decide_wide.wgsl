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
    var phi_227_: f64;
    var phi_270_: f64;
    var phi_313_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_227_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_227_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_227_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_270_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_270_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_270_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_313_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_313_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_313_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: ptr<function, type_39>, param_3: f64, param_4: f64, param_5: f64) -> bool {
    var phi_4206_: bool;
    var phi_4207_: bool;
    var phi_4212_: bool;

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
            phi_4206_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_4207_ = select(true, false, _e87);
        } else {
            phi_4206_ = bool();
            phi_4207_ = true;
        }
        let _e96 = phi_4206_;
        let _e98 = phi_4207_;
        phi_4212_ = select(_e96, false, _e98);
    } else {
        phi_4212_ = false;
    }
    let _e101 = phi_4212_;
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
    var phi_373_: u32;
    var phi_418_: u32;
    var phi_421_: type_9;
    var phi_595_: type_23;
    var phi_791_: type_31;
    var phi_952_: type_33;
    var phi_1448_: bool;
    var phi_1544_: type_41;
    var phi_1545_: bool;
    var phi_1546_: type_41;
    var phi_1547_: bool;
    var phi_1548_: type_41;
    var phi_1549_: bool;
    var phi_1554_: type_41;
    var phi_2099_: bool;
    var phi_2114_: f64;
    var phi_2190_: type_16;
    var phi_2193_: f64;
    var phi_2191_: type_16;
    var phi_2234_: type_17;
    var phi_2194_: f64;
    var local_7: f64;
    var phi_2247_: f64;
    var phi_2278_: type_9;
    var phi_2281_: u32;
    var phi_2348_: u32;
    var phi_2349_: u32;
    var phi_2282_: u32;
    var phi_2350_: u32;
    var phi_2408_: type_9;
    var phi_2568_: type_43;
    var phi_2569_: bool;
    var phi_2570_: type_43;
    var phi_2571_: bool;
    var phi_2606_: type_9;
    var phi_2609_: f64;
    var phi_2611_: f64;
    var phi_2613_: f64;
    var phi_2727_: bool;
    var phi_2734_: f64;
    var phi_2735_: bool;
    var phi_2610_: f64;
    var phi_2612_: f64;
    var phi_2614_: f64;
    var phi_2736_: f64;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var local_8: bool;
    var local_9: f64;
    var local_10: f64;
    var phi_2743_: f64;
    var phi_2761_: type_9;
    var phi_2764_: f64;
    var phi_2830_: f64;
    var phi_2831_: bool;
    var phi_2832_: bool;
    var phi_2833_: bool;
    var phi_2834_: f64;
    var phi_2765_: f64;
    var phi_2835_: bool;
    var phi_2836_: bool;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: f64;
    var phi_2852_: f64;
    var phi_2854_: type_43;
    var phi_3619_: array<type_35, 4>;
    var phi_3639_: type_9;
    var phi_3642_: bool;
    var phi_3643_: bool;
    var phi_3694_: bool;
    var phi_3695_: bool;
    var local_16: bool;
    var local_17: bool;
    var phi_3709_: u32;
    var phi_3710_: u32;
    var phi_3711_: bool;
    var phi_3721_: u32;
    var phi_3722_: bool;
    var phi_3723_: bool;
    var phi_3724_: u32;
    var phi_3725_: bool;
    var phi_3726_: bool;
    var phi_3727_: bool;
    var phi_3728_: type_43;
    var phi_3729_: u32;
    var phi_3730_: bool;
    var phi_3731_: bool;
    var phi_3732_: bool;
    var phi_3733_: type_43;
    var phi_3734_: u32;
    var phi_3735_: bool;
    var phi_3736_: bool;
    var phi_3737_: bool;
    var phi_3738_: bool;
    var phi_3745_: type_43;
    var phi_3746_: u32;
    var phi_3747_: bool;
    var phi_3748_: bool;
    var phi_3749_: bool;
    var phi_3750_: bool;
    var phi_3751_: bool;
    var phi_3752_: type_43;
    var phi_3753_: u32;
    var phi_3754_: type_43;
    var phi_3755_: bool;
    var phi_3756_: bool;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3759_: bool;
    var phi_3760_: bool;
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
    var phi_3809_: type_42;
    var phi_3810_: bool;
    var phi_3815_: type_42;
    var phi_3816_: bool;
    var phi_3817_: bool;
    var phi_3818_: bool;
    var local_33: type_43;
    var local_34: type_43;
    var phi_3840_: type_42;
    var phi_3841_: type_42;
    var phi_3842_: bool;
    var phi_3886_: type_34;
    var phi_3895_: type_9;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3996_: u32;
    var phi_4078_: u32;
    var local_35: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e94 = id_2;
    let _e95 = n_2;
    let _e96 = lane_2;
    let _e109 = ((_e94.y * _e95.x) + _e94.x);
    let _e112 = (_e95.x * _e95.y);
    let _e115 = params.member.member_1.member_2;
    let _e117 = input.member[0u];
    let _e119 = select(_e117, _e115, (_e115 < _e117));
    let _e121 = params.member.member_1.member_1;
    if (_e119 > _e121) {
        let _e124 = params.member.member_1.member_1;
        phi_373_ = (_e119 - _e124);
    } else {
        phi_373_ = 0u;
    }
    let _e127 = phi_373_;
    let _e129 = params.member.member_1.member;
    let _e131 = select(_e127, _e129, (_e129 < _e127));
    let _e132 = (_e131 / 64u);
    let _e136 = select(_e132, (_e132 + 1u), ((_e131 % 64u) > 0u));
    if (_e136 > _e109) {
        let _e138 = (_e136 - _e109);
        if (_e112 == 0u) {
            return;
        }
        let _e140 = (_e138 / _e112);
        if (_e112 == 0u) {
            return;
        }
        phi_418_ = select(_e140, (_e140 + 1u), ((_e138 % _e112) > 0u));
    } else {
        phi_418_ = 0u;
    }
    let _e147 = phi_418_;
    phi_421_ = type_9(0u, _e147);
    loop {
        let _e150 = phi_421_;
        let _e153 = (_e150.member < _e150.member_1);
        let _e166 = (bitcast<i32>(select(0u, 1u, _e153)) != 0i);
        if _e166 {
            let _e170 = (((_e109 + (select(type_9().member_1, _e150.member, _e153) * _e112)) * 64u) + _e96);
            local_6 = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e170 < _e131) {
                let _e174 = params.member.member_1.member_1;
                let _e176 = (2u * (_e174 + _e170));
                let _e179 = input.member[(4u + _e176)];
                let _e182 = input.member[(_e176 + 5u)];
                let _e187 = (_e182 & 2147483647u);
                if (select(1u, 0u, ((_e182 & 2147483648u) == 0u)) == 0u) {
                    let _e206 = params.member.member.member[1u];
                    let _e209 = ((2u * _e206) + (3u * _e187));
                    let _e211 = elements.member[_e209];
                    let _e214 = elements.member[(_e209 + 1u)];
                    let _e217 = elements.member[(_e209 + 2u)];
                    phi_595_ = type_23(0u, array<u32, 4>(_e179, _e211, _e214, _e217));
                } else {
                    let _e190 = (2u * _e179);
                    let _e192 = elements.member[_e190];
                    let _e195 = elements.member[(_e190 + 1u)];
                    let _e196 = (2u * _e187);
                    let _e198 = elements.member[_e196];
                    let _e201 = elements.member[(_e196 + 1u)];
                    phi_595_ = type_23(1u, array<u32, 4>(_e192, _e195, _e198, _e201));
                }
                let _e221 = phi_595_;
                let _e225 = params.member.member.member_1;
                if ((_e225 & 8u) != 0u) {
                    let _e269 = paths.member[_e221.member_1[0]];
                    let _e284 = paths.member[_e221.member_1[1]];
                    let _e299 = paths.member[_e221.member_1[2]];
                    let _e314 = paths.member[_e221.member_1[3]];
                    let _e335 = function_(array<f32, 3>(_e269.member.x, _e269.member.y, _e269.member.z));
                    let _e336 = function_(array<f32, 3>(_e284.member.x, _e284.member.y, _e284.member.z));
                    let _e337 = function_(array<f32, 3>(_e299.member.x, _e299.member.y, _e299.member.z));
                    let _e338 = function_(array<f32, 3>(_e314.member.x, _e314.member.y, _e314.member.z));
                    let _e340 = function_(array<f32, 3>(_e269.member_1.x, _e269.member_1.y, _e269.member_1.z));
                    let _e341 = function_(array<f32, 3>(_e284.member_1.x, _e284.member_1.y, _e284.member_1.z));
                    let _e342 = function_(array<f32, 3>(_e299.member_1.x, _e299.member_1.y, _e299.member_1.z));
                    let _e343 = function_(array<f32, 3>(_e314.member_1.x, _e314.member_1.y, _e314.member_1.z));
                    phi_791_ = type_31(array<array<f64, 3>, 4>(_e335, _e336, _e337, _e338), array<array<f64, 3>, 4>(_e340, _e341, _e342, _e343));
                } else {
                    let _e230 = positions.member[_e221.member_1[0]];
                    let _e233 = params.member.member.member[0u];
                    let _e236 = positions.member[(_e233 + _e221.member_1[0])];
                    let _e239 = positions.member[_e221.member_1[1]];
                    let _e242 = params.member.member.member[0u];
                    let _e245 = positions.member[(_e242 + _e221.member_1[1])];
                    let _e248 = positions.member[_e221.member_1[2]];
                    let _e251 = params.member.member.member[0u];
                    let _e254 = positions.member[(_e251 + _e221.member_1[2])];
                    let _e257 = positions.member[_e221.member_1[3]];
                    let _e260 = params.member.member.member[0u];
                    let _e263 = positions.member[(_e260 + _e221.member_1[3])];
                    phi_791_ = type_31(array<array<f64, 3>, 4>(_e230, _e239, _e248, _e257), array<array<f64, 3>, 4>(_e236, _e245, _e254, _e263));
                }
                let _e347 = phi_791_;
                if (_e221.member != 0u) {
                    phi_952_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[0][0]), (_e347.member[2][1] - _e347.member[0][1]), (_e347.member[2][2] - _e347.member[0][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[0][0]), (_e347.member_1[2][1] - _e347.member_1[0][1]), (_e347.member_1[2][2] - _e347.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[1][0] - _e347.member[0][0]), (_e347.member[1][1] - _e347.member[0][1]), (_e347.member[1][2] - _e347.member[0][2])), array<f64, 3>((_e347.member_1[1][0] - _e347.member_1[0][0]), (_e347.member_1[1][1] - _e347.member_1[0][1]), (_e347.member_1[1][2] - _e347.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[3][0]), (_e347.member[2][1] - _e347.member[3][1]), (_e347.member[2][2] - _e347.member[3][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[3][0]), (_e347.member_1[2][1] - _e347.member_1[3][1]), (_e347.member_1[2][2] - _e347.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_952_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[0][0] - _e347.member[1][0]), (_e347.member[0][1] - _e347.member[1][1]), (_e347.member[0][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[0][0] - _e347.member_1[1][0]), (_e347.member_1[0][1] - _e347.member_1[1][1]), (_e347.member_1[0][2] - _e347.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[1][0]), (_e347.member[2][1] - _e347.member[1][1]), (_e347.member[2][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[1][0]), (_e347.member_1[2][1] - _e347.member_1[1][1]), (_e347.member_1[2][2] - _e347.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[3][0] - _e347.member[1][0]), (_e347.member[3][1] - _e347.member[1][1]), (_e347.member[3][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[3][0] - _e347.member_1[1][0]), (_e347.member_1[3][1] - _e347.member_1[1][1]), (_e347.member_1[3][2] - _e347.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e506 = phi_952_;
                let _e508 = params.member.member.member_14;
                let _e515 = bitcast<f64>(((u64(_e508[1]) * 4294967296lu) + u64(_e508[0])));
                let _e517 = params.member.member.member_15;
                let _e524 = bitcast<f64>(((u64(_e517[1]) * 4294967296lu) + u64(_e517[0])));
                let _e526 = params.member.member.member_16;
                let _e533 = bitcast<f64>(((u64(_e526[1]) * 4294967296lu) + u64(_e526[0])));
                let _e535 = params.member.member.member_16;
                let _e542 = bitcast<f64>(((u64(_e535[1]) * 4294967296lu) + u64(_e535[0])));
                let _e543 = f64(0f);
                let _e549 = select(_e506.member[0][0], -(_e506.member[0][0]), (_e506.member[0][0] < 0.0lf));
                let _e553 = select(_e506.member[0][1], -(_e506.member[0][1]), (_e506.member[0][1] < 0.0lf));
                let _e555 = select(_e553, _e549, (_e549 > _e553));
                let _e559 = select(_e506.member[0][2], -(_e506.member[0][2]), (_e506.member[0][2] < 0.0lf));
                let _e561 = select(_e559, _e555, (_e555 > _e559));
                let _e567 = select(_e506.member[1][0], -(_e506.member[1][0]), (_e506.member[1][0] < 0.0lf));
                let _e571 = select(_e506.member[1][1], -(_e506.member[1][1]), (_e506.member[1][1] < 0.0lf));
                let _e573 = select(_e571, _e567, (_e567 > _e571));
                let _e577 = select(_e506.member[1][2], -(_e506.member[1][2]), (_e506.member[1][2] < 0.0lf));
                let _e579 = select(_e577, _e573, (_e573 > _e577));
                let _e583 = (select(_e579, _e561, (_e561 > _e579)) + _e506.member_3);
                let _e589 = select(_e506.member_1[0][0], -(_e506.member_1[0][0]), (_e506.member_1[0][0] < 0.0lf));
                let _e593 = select(_e506.member_1[0][1], -(_e506.member_1[0][1]), (_e506.member_1[0][1] < 0.0lf));
                let _e595 = select(_e593, _e589, (_e589 > _e593));
                let _e599 = select(_e506.member_1[0][2], -(_e506.member_1[0][2]), (_e506.member_1[0][2] < 0.0lf));
                let _e601 = select(_e599, _e595, (_e595 > _e599));
                let _e607 = select(_e506.member_1[1][0], -(_e506.member_1[1][0]), (_e506.member_1[1][0] < 0.0lf));
                let _e611 = select(_e506.member_1[1][1], -(_e506.member_1[1][1]), (_e506.member_1[1][1] < 0.0lf));
                let _e613 = select(_e611, _e607, (_e607 > _e611));
                let _e617 = select(_e506.member_1[1][2], -(_e506.member_1[1][2]), (_e506.member_1[1][2] < 0.0lf));
                let _e619 = select(_e617, _e613, (_e613 > _e617));
                let _e623 = (select(_e619, _e601, (_e601 > _e619)) + _e506.member_3);
                let _e629 = select(_e506.member_2[0][0], -(_e506.member_2[0][0]), (_e506.member_2[0][0] < 0.0lf));
                let _e633 = select(_e506.member_2[0][1], -(_e506.member_2[0][1]), (_e506.member_2[0][1] < 0.0lf));
                let _e635 = select(_e633, _e629, (_e629 > _e633));
                let _e639 = select(_e506.member_2[0][2], -(_e506.member_2[0][2]), (_e506.member_2[0][2] < 0.0lf));
                let _e641 = select(_e639, _e635, (_e635 > _e639));
                let _e647 = select(_e506.member_2[1][0], -(_e506.member_2[1][0]), (_e506.member_2[1][0] < 0.0lf));
                let _e651 = select(_e506.member_2[1][1], -(_e506.member_2[1][1]), (_e506.member_2[1][1] < 0.0lf));
                let _e653 = select(_e651, _e647, (_e647 > _e651));
                let _e657 = select(_e506.member_2[1][2], -(_e506.member_2[1][2]), (_e506.member_2[1][2] < 0.0lf));
                let _e659 = select(_e657, _e653, (_e653 > _e657));
                let _e663 = (select(_e659, _e641, (_e641 > _e659)) + _e506.member_3);
                let _e665 = select(_e623, _e583, (_e583 > _e623));
                let _e667 = select(_e663, _e665, (_e665 > _e663));
                let _e673 = select(_e506.member[0][0], -(_e506.member[0][0]), (_e506.member[0][0] < 0.0lf));
                let _e677 = select(_e506.member[0][1], -(_e506.member[0][1]), (_e506.member[0][1] < 0.0lf));
                let _e679 = select(_e677, _e673, (_e673 > _e677));
                let _e683 = select(_e506.member[0][2], -(_e506.member[0][2]), (_e506.member[0][2] < 0.0lf));
                let _e685 = select(_e683, _e679, (_e679 > _e683));
                let _e691 = select(_e506.member[1][0], -(_e506.member[1][0]), (_e506.member[1][0] < 0.0lf));
                let _e695 = select(_e506.member[1][1], -(_e506.member[1][1]), (_e506.member[1][1] < 0.0lf));
                let _e697 = select(_e695, _e691, (_e691 > _e695));
                let _e701 = select(_e506.member[1][2], -(_e506.member[1][2]), (_e506.member[1][2] < 0.0lf));
                let _e703 = select(_e701, _e697, (_e697 > _e701));
                let _e707 = (select(_e703, _e685, (_e685 > _e703)) + _e506.member_3);
                let _e713 = select(_e506.member_1[0][0], -(_e506.member_1[0][0]), (_e506.member_1[0][0] < 0.0lf));
                let _e717 = select(_e506.member_1[0][1], -(_e506.member_1[0][1]), (_e506.member_1[0][1] < 0.0lf));
                let _e719 = select(_e717, _e713, (_e713 > _e717));
                let _e723 = select(_e506.member_1[0][2], -(_e506.member_1[0][2]), (_e506.member_1[0][2] < 0.0lf));
                let _e725 = select(_e723, _e719, (_e719 > _e723));
                let _e731 = select(_e506.member_1[1][0], -(_e506.member_1[1][0]), (_e506.member_1[1][0] < 0.0lf));
                let _e735 = select(_e506.member_1[1][1], -(_e506.member_1[1][1]), (_e506.member_1[1][1] < 0.0lf));
                let _e737 = select(_e735, _e731, (_e731 > _e735));
                let _e741 = select(_e506.member_1[1][2], -(_e506.member_1[1][2]), (_e506.member_1[1][2] < 0.0lf));
                let _e743 = select(_e741, _e737, (_e737 > _e741));
                let _e747 = (select(_e743, _e725, (_e725 > _e743)) + _e506.member_3);
                let _e753 = select(_e506.member_2[0][0], -(_e506.member_2[0][0]), (_e506.member_2[0][0] < 0.0lf));
                let _e757 = select(_e506.member_2[0][1], -(_e506.member_2[0][1]), (_e506.member_2[0][1] < 0.0lf));
                let _e759 = select(_e757, _e753, (_e753 > _e757));
                let _e763 = select(_e506.member_2[0][2], -(_e506.member_2[0][2]), (_e506.member_2[0][2] < 0.0lf));
                let _e765 = select(_e763, _e759, (_e759 > _e763));
                let _e771 = select(_e506.member_2[1][0], -(_e506.member_2[1][0]), (_e506.member_2[1][0] < 0.0lf));
                let _e775 = select(_e506.member_2[1][1], -(_e506.member_2[1][1]), (_e506.member_2[1][1] < 0.0lf));
                let _e777 = select(_e775, _e771, (_e771 > _e775));
                let _e781 = select(_e506.member_2[1][2], -(_e506.member_2[1][2]), (_e506.member_2[1][2] < 0.0lf));
                let _e783 = select(_e781, _e777, (_e777 > _e781));
                let _e787 = (select(_e783, _e765, (_e765 > _e783)) + _e506.member_3);
                let _e789 = select(_e747, _e707, (_e707 > _e747));
                let _e791 = select(_e787, _e789, (_e789 > _e787));
                if (_e791 <= f64(65536f)) {
                    phi_1448_ = (_e791 >= f64((1f / 65536f)));
                } else {
                    phi_1448_ = false;
                }
                let _e798 = phi_1448_;
                if _e798 {
                    phi_1548_ = type_41();
                    phi_1549_ = true;
                } else {
                    if (_e667 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e667) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e805 = (9214364837600034816lu - (bitcast<u64>(_e667) & 9218868437227405312lu));
                            let _e808 = bitcast<f64>(select(4503599627370496lu, _e805, (_e805 > 4503599627370496lu)));
                            let _e809 = (_e543 * _e808);
                            phi_1544_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e506.member[0][0] * _e808), (_e506.member[0][1] * _e808), (_e506.member[0][2] * _e808)), array<f64, 3>((_e506.member[1][0] * _e808), (_e506.member[1][1] * _e808), (_e506.member[1][2] * _e808))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_1[0][0] * _e808), (_e506.member_1[0][1] * _e808), (_e506.member_1[0][2] * _e808)), array<f64, 3>((_e506.member_1[1][0] * _e808), (_e506.member_1[1][1] * _e808), (_e506.member_1[1][2] * _e808))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_2[0][0] * _e808), (_e506.member_2[0][1] * _e808), (_e506.member_2[0][2] * _e808)), array<f64, 3>((_e506.member_2[1][0] * _e808), (_e506.member_2[1][1] * _e808), (_e506.member_2[1][2] * _e808))), ((_e506.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e808)), select(_e809, select(2.2250738585072014e-308lf, _e809, (_e809 > 2.2250738585072014e-308lf)), (_e543 > f64(0f))));
                            phi_1545_ = false;
                        } else {
                            phi_1544_ = type_41();
                            phi_1545_ = true;
                        }
                        let _e880 = phi_1544_;
                        let _e882 = phi_1545_;
                        phi_1546_ = _e880;
                        phi_1547_ = _e882;
                    } else {
                        phi_1546_ = type_41();
                        phi_1547_ = true;
                    }
                    let _e884 = phi_1546_;
                    let _e886 = phi_1547_;
                    phi_1548_ = _e884;
                    phi_1549_ = _e886;
                }
                let _e888 = phi_1548_;
                let _e890 = phi_1549_;
                if _e890 {
                    phi_1554_ = type_41(_e506, _e543);
                } else {
                    phi_1554_ = _e888;
                }
                let _e893 = phi_1554_;
                let _e905 = ((_e893.member.member_1[0][1] * _e893.member.member_2[0][2]) - (_e893.member.member_1[0][2] * _e893.member.member_2[0][1]));
                let _e912 = ((_e893.member.member_1[0][2] * _e893.member.member_2[0][0]) - (_e893.member.member_1[0][0] * _e893.member.member_2[0][2]));
                let _e919 = ((_e893.member.member_1[0][0] * _e893.member.member_2[0][1]) - (_e893.member.member_1[0][1] * _e893.member.member_2[0][0]));
                let _e930 = ((_e893.member.member_1[1][1] * _e893.member.member_2[1][2]) - (_e893.member.member_1[1][2] * _e893.member.member_2[1][1]));
                let _e937 = ((_e893.member.member_1[1][2] * _e893.member.member_2[1][0]) - (_e893.member.member_1[1][0] * _e893.member.member_2[1][2]));
                let _e944 = ((_e893.member.member_1[1][0] * _e893.member.member_2[1][1]) - (_e893.member.member_1[1][1] * _e893.member.member_2[1][0]));
                let _e995 = (((_e893.member.member_1[0][1] * _e893.member.member_2[1][2]) - (_e893.member.member_1[0][2] * _e893.member.member_2[1][1])) + ((_e893.member.member_1[1][1] * _e893.member.member_2[0][2]) - (_e893.member.member_1[1][2] * _e893.member.member_2[0][1])));
                let _e996 = (((_e893.member.member_1[0][2] * _e893.member.member_2[1][0]) - (_e893.member.member_1[0][0] * _e893.member.member_2[1][2])) + ((_e893.member.member_1[1][2] * _e893.member.member_2[0][0]) - (_e893.member.member_1[1][0] * _e893.member.member_2[0][2])));
                let _e997 = (((_e893.member.member_1[0][0] * _e893.member.member_2[1][1]) - (_e893.member.member_1[0][1] * _e893.member.member_2[1][0])) + ((_e893.member.member_1[1][0] * _e893.member.member_2[0][1]) - (_e893.member.member_1[1][1] * _e893.member.member_2[0][0])));
                let _e1007 = (((_e893.member.member[0][0] * _e905) + (_e893.member.member[0][1] * _e912)) + (_e893.member.member[0][2] * _e919));
                let _e1028 = ((((_e893.member.member[1][0] * _e905) + (_e893.member.member[1][1] * _e912)) + (_e893.member.member[1][2] * _e919)) + (((_e893.member.member[0][0] * _e995) + (_e893.member.member[0][1] * _e996)) + (_e893.member.member[0][2] * _e997)));
                let _e1049 = ((((_e893.member.member[0][0] * _e930) + (_e893.member.member[0][1] * _e937)) + (_e893.member.member[0][2] * _e944)) + (((_e893.member.member[1][0] * _e995) + (_e893.member.member[1][1] * _e996)) + (_e893.member.member[1][2] * _e997)));
                let _e1059 = (((_e893.member.member[1][0] * _e930) + (_e893.member.member[1][1] * _e937)) + (_e893.member.member[1][2] * _e944));
                let _e1065 = select(_e893.member.member[0][0], -(_e893.member.member[0][0]), (_e893.member.member[0][0] < 0.0lf));
                let _e1069 = select(_e893.member.member[0][1], -(_e893.member.member[0][1]), (_e893.member.member[0][1] < 0.0lf));
                let _e1071 = select(_e1069, _e1065, (_e1065 > _e1069));
                let _e1075 = select(_e893.member.member[0][2], -(_e893.member.member[0][2]), (_e893.member.member[0][2] < 0.0lf));
                let _e1077 = select(_e1075, _e1071, (_e1071 > _e1075));
                let _e1083 = select(_e893.member.member[1][0], -(_e893.member.member[1][0]), (_e893.member.member[1][0] < 0.0lf));
                let _e1087 = select(_e893.member.member[1][1], -(_e893.member.member[1][1]), (_e893.member.member[1][1] < 0.0lf));
                let _e1089 = select(_e1087, _e1083, (_e1083 > _e1087));
                let _e1093 = select(_e893.member.member[1][2], -(_e893.member.member[1][2]), (_e893.member.member[1][2] < 0.0lf));
                let _e1095 = select(_e1093, _e1089, (_e1089 > _e1093));
                let _e1099 = (select(_e1095, _e1077, (_e1077 > _e1095)) + _e893.member.member_3);
                let _e1105 = select(_e893.member.member_1[0][0], -(_e893.member.member_1[0][0]), (_e893.member.member_1[0][0] < 0.0lf));
                let _e1109 = select(_e893.member.member_1[0][1], -(_e893.member.member_1[0][1]), (_e893.member.member_1[0][1] < 0.0lf));
                let _e1111 = select(_e1109, _e1105, (_e1105 > _e1109));
                let _e1115 = select(_e893.member.member_1[0][2], -(_e893.member.member_1[0][2]), (_e893.member.member_1[0][2] < 0.0lf));
                let _e1117 = select(_e1115, _e1111, (_e1111 > _e1115));
                let _e1123 = select(_e893.member.member_1[1][0], -(_e893.member.member_1[1][0]), (_e893.member.member_1[1][0] < 0.0lf));
                let _e1127 = select(_e893.member.member_1[1][1], -(_e893.member.member_1[1][1]), (_e893.member.member_1[1][1] < 0.0lf));
                let _e1129 = select(_e1127, _e1123, (_e1123 > _e1127));
                let _e1133 = select(_e893.member.member_1[1][2], -(_e893.member.member_1[1][2]), (_e893.member.member_1[1][2] < 0.0lf));
                let _e1135 = select(_e1133, _e1129, (_e1129 > _e1133));
                let _e1139 = (select(_e1135, _e1117, (_e1117 > _e1135)) + _e893.member.member_3);
                let _e1145 = select(_e893.member.member_2[0][0], -(_e893.member.member_2[0][0]), (_e893.member.member_2[0][0] < 0.0lf));
                let _e1149 = select(_e893.member.member_2[0][1], -(_e893.member.member_2[0][1]), (_e893.member.member_2[0][1] < 0.0lf));
                let _e1151 = select(_e1149, _e1145, (_e1145 > _e1149));
                let _e1155 = select(_e893.member.member_2[0][2], -(_e893.member.member_2[0][2]), (_e893.member.member_2[0][2] < 0.0lf));
                let _e1157 = select(_e1155, _e1151, (_e1151 > _e1155));
                let _e1163 = select(_e893.member.member_2[1][0], -(_e893.member.member_2[1][0]), (_e893.member.member_2[1][0] < 0.0lf));
                let _e1167 = select(_e893.member.member_2[1][1], -(_e893.member.member_2[1][1]), (_e893.member.member_2[1][1] < 0.0lf));
                let _e1169 = select(_e1167, _e1163, (_e1163 > _e1167));
                let _e1173 = select(_e893.member.member_2[1][2], -(_e893.member.member_2[1][2]), (_e893.member.member_2[1][2] < 0.0lf));
                let _e1175 = select(_e1173, _e1169, (_e1169 > _e1173));
                let _e1179 = (select(_e1175, _e1157, (_e1157 > _e1175)) + _e893.member.member_3);
                let _e1180 = f64(1f);
                let _e1181 = f64(8f);
                let _e1207 = (((((_e1099 * _e1181) * ((_e1139 * _e1181) * _e1179)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e893.member.member_3 * f64(19f)) * ((_e1099 * (_e1139 + _e1179)) + (_e1139 * _e1179)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1180 + _e1099) * ((_e1180 + _e1139) * (_e1180 + _e1179)))));
                let _e1208 = f64(3f);
                let _e1209 = (_e1007 * _e1208);
                let _e1210 = (_e1059 * _e1208);
                let _e1212 = select(_e1210, _e1209, (_e1209 < _e1210));
                let _e1214 = select(_e1049, _e1028, (_e1028 < _e1049));
                let _e1216 = select(_e1214, _e1212, (_e1212 < _e1214));
                let _e1218 = select(_e1210, _e1209, (_e1209 > _e1210));
                let _e1220 = select(_e1049, _e1028, (_e1028 > _e1049));
                let _e1223 = -(select(_e1220, _e1218, (_e1218 > _e1220)));
                if (select(_e1223, _e1216, (_e1216 > _e1223)) > _e1207) {
                    phi_3840_ = type_42(0u, type_42().member_1);
                    phi_3841_ = type_42();
                    phi_3842_ = true;
                } else {
                    let _e1231 = select(_e1007, -(_e1007), (_e1007 < 0.0lf));
                    let _e1234 = select(_e1028, -(_e1028), (_e1028 < 0.0lf));
                    let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                    let _e1239 = select(_e1049, -(_e1049), (_e1049 < 0.0lf));
                    let _e1242 = select(_e1059, -(_e1059), (_e1059 < 0.0lf));
                    let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                    let _e1246 = select(_e1244, _e1236, (_e1236 > _e1244));
                    let _e1248 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1249 = f64(1f);
                    if (_e1246 >= _e1248) {
                        phi_2099_ = (_e1246 <= (_e1249 / _e1248));
                    } else {
                        phi_2099_ = false;
                    }
                    let _e1254 = phi_2099_;
                    if _e1254 {
                        phi_2114_ = (_e1249 / _e1246);
                    } else {
                        phi_2114_ = f64(0f);
                    }
                    let _e1264 = phi_2114_;
                    let _e1265 = f64(0.00000000000022737368f);
                    let _e1267 = (_e515 * f64(0.0625f));
                    local_4 = type_39(array<f64, 4>(_e1007, _e1028, _e1049, _e1059), ((_e1207 * f64(0.34f)) + (_e1246 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1254))), _e1264, select(_e1267, _e1265, (_e1265 < _e1267)));
                    let _e1272 = f64(0f);
                    let _e1273 = f64(1f);
                    let _e1274 = f64(3f);
                    let _e1277 = local_4.member[0u];
                    let _e1280 = local_4.member[1u];
                    let _e1283 = local_4.member[2u];
                    let _e1286 = local_4.member[3u];
                    let _e1293 = local_4.member_2;
                    let _e1294 = ((_e1280 - (_e1274 * _e1277)) * _e1293);
                    let _e1296 = local_4.member_2;
                    let _e1297 = ((_e1283 - _e1280) * _e1296);
                    let _e1299 = local_4.member_2;
                    let _e1300 = (((_e1274 * _e1286) - _e1283) * _e1299);
                    local_2[0u] = _e1272;
                    local_2[1u] = _e1273;
                    local_2[2u] = _e1273;
                    local_2[3u] = _e1273;
                    let _e1307 = ((_e1297 * _e1297) - (_e1294 * _e1300));
                    if (_e1307 > _e1272) {
                        if (_e1307 <= 2.2250738585072014e-308lf) {
                            phi_2247_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1307 > 0.0lf));
                        } else {
                            phi_2190_ = type_16(0i, 5i);
                            phi_2193_ = bitcast<f64>(((bitcast<u64>(_e1307) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1315 = phi_2190_;
                                let _e1317 = phi_2193_;
                                local_7 = _e1317;
                                if (_e1315.member < _e1315.member_1) {
                                    let _e1324 = (_e1315.member + 1i);
                                    phi_2191_ = type_16(select(_e1324, type_17().member_1, select(false, true, ((false == (_e1324 > _e1315.member)) != false))), _e1315.member_1);
                                    phi_2234_ = type_17(1u, _e1315.member);
                                } else {
                                    phi_2191_ = _e1315;
                                    phi_2234_ = type_17(0u, type_17().member_1);
                                }
                                let _e1335 = phi_2191_;
                                let _e1337 = phi_2234_;
                                let _e1340 = (bitcast<i32>(_e1337.member) != 0i);
                                if _e1340 {
                                    phi_2194_ = (0.5lf * (_e1317 + (_e1307 / _e1317)));
                                } else {
                                    phi_2194_ = f64();
                                }
                                let _e1345 = phi_2194_;
                                continue;
                                continuing {
                                    phi_2190_ = _e1335;
                                    phi_2193_ = _e1345;
                                    break if !(_e1340);
                                }
                            }
                            let _e1350 = local_7;
                            phi_2247_ = (_e1350 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1356 = phi_2247_;
                        let _e1361 = -((_e1297 + select(_e1356, -(_e1356), (_e1297 < _e1272))));
                        local_3[0u] = (_e1361 / (_e1361 + _e1300));
                        local_3[1u] = (_e1294 / (_e1294 + _e1361));
                        let _e1370 = local_3[1u];
                        let _e1371 = local_3[0u];
                        if (_e1370 < _e1371) {
                            let _e1374 = local_3[1u];
                            let _e1376 = local_3[0u];
                            local_3[0u] = _e1374;
                            local_3[1u] = _e1376;
                        }
                        phi_2278_ = type_9(0u, 2u);
                        phi_2281_ = 1u;
                        loop {
                            let _e1380 = phi_2278_;
                            let _e1382 = phi_2281_;
                            local_35 = _e1382;
                            let _e1385 = (_e1380.member < _e1380.member_1);
                            let _e1396 = select(type_9().member_1, _e1380.member, _e1385);
                            let _e1398 = (bitcast<i32>(select(0u, 1u, _e1385)) != 0i);
                            if _e1398 {
                                let _e1400 = local_3[_e1396];
                                if (_e1400 > _e1272) {
                                    let _e1403 = local_3[_e1396];
                                    if (_e1403 < _e1273) {
                                        let _e1406 = local_3[_e1396];
                                        local_2[_e1382] = _e1406;
                                        phi_2348_ = (_e1382 + 1u);
                                    } else {
                                        phi_2348_ = _e1382;
                                    }
                                    let _e1410 = phi_2348_;
                                    phi_2349_ = _e1410;
                                } else {
                                    phi_2349_ = _e1382;
                                }
                                let _e1412 = phi_2349_;
                                phi_2282_ = _e1412;
                            } else {
                                phi_2282_ = u32();
                            }
                            let _e1414 = phi_2282_;
                            continue;
                            continuing {
                                phi_2278_ = type_9(select(_e1380.member, (_e1380.member + 1u), _e1385), select(_e1380.member_1, _e1380.member_1, _e1385));
                                phi_2281_ = _e1414;
                                break if !(_e1398);
                            }
                        }
                        let _e2770 = local_35;
                        phi_2350_ = _e2770;
                    } else {
                        phi_2350_ = 1u;
                    }
                    let _e1417 = phi_2350_;
                    local_2[_e1417] = _e1273;
                    let _e1419 = local_2;
                    local_5 = _e1419;
                    let _e1423 = (f64(1f) - _e524);
                    let _e1426 = local_4.member[0u];
                    let _e1429 = local_4.member[1u];
                    let _e1432 = local_4.member[2u];
                    let _e1435 = local_4.member[3u];
                    let _e1446 = ((((_e1426 * _e1423) + (_e1429 * _e524)) * (_e1423 * _e1423)) + (((_e1432 * _e1423) + (_e1435 * _e524)) * (_e524 * _e524)));
                    let _e1451 = local_4.member_1;
                    phi_2408_ = type_9(select(1u, 0u, !((select(_e1446, -(_e1446), (_e1446 < 0.0lf)) > _e1451))), (_e1417 + 1u));
                    loop {
                        let _e1458 = phi_2408_;
                        let _e1461 = (_e1458.member < _e1458.member_1);
                        let _e1472 = select(type_9().member_1, _e1458.member, _e1461);
                        if (bitcast<i32>(select(0u, 1u, _e1461)) != 0i) {
                            if (_e1472 > 0u) {
                                let _e1479 = local_5[(_e1472 - 1u)];
                                let _e1481 = select(_e524, _e1479, (_e1479 > _e524));
                                let _e1483 = local_5[_e1472];
                                let _e1485 = select(_e533, _e1483, (_e1483 < _e533));
                                if (_e1481 <= _e1485) {
                                    let _e1487 = function_2((&local_4), _e542, _e1481, _e1485);
                                    if _e1487 {
                                        phi_3728_ = type_43();
                                        phi_3729_ = u32();
                                        phi_3730_ = false;
                                        phi_3731_ = false;
                                        phi_3732_ = false;
                                    } else {
                                        let _e1489 = (f64(1f) - _e1481);
                                        let _e1492 = local_4.member[0u];
                                        let _e1495 = local_4.member[1u];
                                        let _e1498 = local_4.member[2u];
                                        let _e1501 = local_4.member[3u];
                                        let _e1512 = ((((_e1492 * _e1489) + (_e1495 * _e1481)) * (_e1489 * _e1489)) + (((_e1498 * _e1489) + (_e1501 * _e1481)) * (_e1481 * _e1481)));
                                        let _e1514 = (f64(1f) - _e1485);
                                        let _e1517 = local_4.member[0u];
                                        let _e1520 = local_4.member[1u];
                                        let _e1523 = local_4.member[2u];
                                        let _e1526 = local_4.member[3u];
                                        let _e1537 = ((((_e1517 * _e1514) + (_e1520 * _e1485)) * (_e1514 * _e1514)) + (((_e1523 * _e1514) + (_e1526 * _e1485)) * (_e1485 * _e1485)));
                                        let _e1542 = local_4.member_1;
                                        let _e1543 = (select(_e1512, -(_e1512), (_e1512 < 0.0lf)) > _e1542);
                                        let _e1548 = local_4.member_1;
                                        let _e1549 = (select(_e1537, -(_e1537), (_e1537 < 0.0lf)) > _e1548);
                                        let _e1550 = f64(0f);
                                        let _e1558 = select(select(bool(), select(bool(), ((_e1512 > _e1550) != (_e1537 > _e1550)), _e1549), _e1543), false, select(true, select(true, false, _e1549), _e1543));
                                        if _e1543 {
                                            if _e1549 {
                                                phi_2568_ = type_43(select(f64(1f), type_43().member, _e1558), select(_e1550, type_43().member_1, _e1558), select(_e1558, type_43().member_2, _e1558));
                                                phi_2569_ = _e1558;
                                            } else {
                                                phi_2568_ = type_43();
                                                phi_2569_ = true;
                                            }
                                            let _e1568 = phi_2568_;
                                            let _e1570 = phi_2569_;
                                            phi_2570_ = _e1568;
                                            phi_2571_ = _e1570;
                                        } else {
                                            phi_2570_ = type_43();
                                            phi_2571_ = true;
                                        }
                                        let _e1572 = phi_2570_;
                                        let _e1574 = phi_2571_;
                                        if _e1574 {
                                            if _e1543 {
                                                let _e1578 = select(f64(1f), f64(-1f), (_e1512 < _e1550));
                                                let _e1580 = local_4.member_3;
                                                let _e1581 = f64(0.5f);
                                                let _e1582 = f64(3f);
                                                let _e1585 = local_4.member[0u];
                                                let _e1588 = local_4.member[1u];
                                                let _e1591 = local_4.member[2u];
                                                let _e1594 = local_4.member[3u];
                                                let _e1597 = (_e1591 - _e1588);
                                                phi_2606_ = type_9(0u, 64u);
                                                phi_2609_ = _e1485;
                                                phi_2611_ = _e1481;
                                                phi_2613_ = (_e1581 * (_e1481 + _e1485));
                                                loop {
                                                    let _e1603 = phi_2606_;
                                                    let _e1605 = phi_2609_;
                                                    let _e1607 = phi_2611_;
                                                    let _e1609 = phi_2613_;
                                                    local_10 = _e1607;
                                                    let _e1612 = (_e1603.member < _e1603.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1612)) != 0i) {
                                                        let _e1625 = (f64(1f) - _e1609);
                                                        let _e1628 = local_4.member[0u];
                                                        let _e1631 = local_4.member[1u];
                                                        let _e1634 = local_4.member[2u];
                                                        let _e1637 = local_4.member[3u];
                                                        let _e1651 = local_4.member_1;
                                                        let _e1652 = ((_e1578 * ((((_e1628 * _e1625) + (_e1631 * _e1609)) * (_e1625 * _e1625)) + (((_e1634 * _e1625) + (_e1637 * _e1609)) * (_e1609 * _e1609)))) - _e1651);
                                                        let _e1654 = (_e1652 > f64(0f));
                                                        let _e1655 = select(_e1609, _e1605, _e1654);
                                                        let _e1656 = select(_e1607, _e1609, _e1654);
                                                        let _e1658 = ((_e1655 - _e1656) > _e1580);
                                                        if _e1658 {
                                                            let _e1660 = (f64(1f) - _e1609);
                                                            let _e1672 = (-(_e1652) / (_e1578 * (((((_e1588 - (_e1582 * _e1585)) * _e1660) + (_e1597 * _e1609)) * _e1660) + (((_e1597 * _e1660) + (((_e1582 * _e1594) - _e1591) * _e1609)) * _e1609))));
                                                            let _e1680 = ((_e1609 + _e1672) + select(-((_e1581 * _e1580)), (_e1581 * _e1580), (_e1652 > f64(0f))));
                                                            if (_e1680 > _e1656) {
                                                                phi_2727_ = select(true, select(true, false, (select(_e1672, -(_e1672), (_e1672 < 0.0lf)) < (_e1581 * (_e1655 - _e1656)))), (_e1680 < _e1655));
                                                            } else {
                                                                phi_2727_ = true;
                                                            }
                                                            let _e1692 = phi_2727_;
                                                            phi_2734_ = select(_e1680, (_e1581 * (_e1656 + _e1655)), _e1692);
                                                            phi_2735_ = false;
                                                        } else {
                                                            phi_2734_ = f64();
                                                            phi_2735_ = true;
                                                        }
                                                        let _e1697 = phi_2734_;
                                                        let _e1699 = phi_2735_;
                                                        phi_2610_ = _e1655;
                                                        phi_2612_ = _e1656;
                                                        phi_2614_ = _e1697;
                                                        phi_2736_ = _e1656;
                                                        phi_2737_ = _e1658;
                                                        phi_2738_ = _e1699;
                                                    } else {
                                                        phi_2610_ = f64();
                                                        phi_2612_ = f64();
                                                        phi_2614_ = f64();
                                                        phi_2736_ = f64();
                                                        phi_2737_ = false;
                                                        phi_2738_ = false;
                                                    }
                                                    let _e1701 = phi_2610_;
                                                    let _e1703 = phi_2612_;
                                                    let _e1705 = phi_2614_;
                                                    let _e1707 = phi_2736_;
                                                    let _e1709 = phi_2737_;
                                                    let _e1711 = phi_2738_;
                                                    local_8 = _e1711;
                                                    local_9 = _e1707;
                                                    continue;
                                                    continuing {
                                                        phi_2606_ = type_9(select(_e1603.member, (_e1603.member + 1u), _e1612), select(_e1603.member_1, _e1603.member_1, _e1612));
                                                        phi_2609_ = _e1701;
                                                        phi_2611_ = _e1703;
                                                        phi_2613_ = _e1705;
                                                        break if !(_e1709);
                                                    }
                                                }
                                                let _e1714 = local_8;
                                                let _e1716 = local_9;
                                                let _e1718 = local_10;
                                                phi_2743_ = select(_e1718, _e1716, _e1714);
                                            } else {
                                                phi_2743_ = _e1481;
                                            }
                                            let _e1721 = phi_2743_;
                                            if _e1549 {
                                                let _e1727 = local_4.member_3;
                                                let _e1729 = local_4.member_3;
                                                phi_2761_ = type_9(0u, 64u);
                                                phi_2764_ = (_e1727 + _e1729);
                                                loop {
                                                    let _e1732 = phi_2761_;
                                                    let _e1734 = phi_2764_;
                                                    let _e1737 = (_e1732.member < _e1732.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1737)) != 0i) {
                                                        let _e1749 = (_e1721 + _e1734);
                                                        if (_e1749 < _e1485) {
                                                            let _e1752 = (f64(1f) - _e1749);
                                                            let _e1755 = local_4.member[0u];
                                                            let _e1758 = local_4.member[1u];
                                                            let _e1761 = local_4.member[2u];
                                                            let _e1764 = local_4.member[3u];
                                                            let _e1778 = local_4.member_1;
                                                            let _e1779 = ((select(f64(1f), f64(-1f), (_e1537 < _e1550)) * ((((_e1755 * _e1752) + (_e1758 * _e1749)) * (_e1752 * _e1752)) + (((_e1761 * _e1752) + (_e1764 * _e1749)) * (_e1749 * _e1749)))) > _e1778);
                                                            phi_2830_ = select((_e1734 + _e1734), f64(), _e1779);
                                                            phi_2831_ = select(true, false, _e1779);
                                                            phi_2832_ = _e1779;
                                                            phi_2833_ = false;
                                                        } else {
                                                            phi_2830_ = f64();
                                                            phi_2831_ = false;
                                                            phi_2832_ = false;
                                                            phi_2833_ = true;
                                                        }
                                                        let _e1784 = phi_2830_;
                                                        let _e1786 = phi_2831_;
                                                        let _e1788 = phi_2832_;
                                                        let _e1790 = phi_2833_;
                                                        phi_2834_ = _e1749;
                                                        phi_2765_ = _e1784;
                                                        phi_2835_ = _e1786;
                                                        phi_2836_ = _e1788;
                                                        phi_2837_ = _e1790;
                                                        phi_2838_ = false;
                                                    } else {
                                                        phi_2834_ = f64();
                                                        phi_2765_ = f64();
                                                        phi_2835_ = false;
                                                        phi_2836_ = false;
                                                        phi_2837_ = false;
                                                        phi_2838_ = true;
                                                    }
                                                    let _e1792 = phi_2834_;
                                                    let _e1794 = phi_2765_;
                                                    let _e1796 = phi_2835_;
                                                    let _e1798 = phi_2836_;
                                                    let _e1800 = phi_2837_;
                                                    let _e1802 = phi_2838_;
                                                    local_11 = _e1798;
                                                    local_12 = _e1800;
                                                    local_13 = _e1798;
                                                    local_14 = _e1802;
                                                    local_15 = _e1792;
                                                    continue;
                                                    continuing {
                                                        phi_2761_ = type_9(select(_e1732.member, (_e1732.member + 1u), _e1737), select(_e1732.member_1, _e1732.member_1, _e1737));
                                                        phi_2764_ = _e1794;
                                                        break if !(_e1796);
                                                    }
                                                }
                                                let _e1805 = local_11;
                                                let _e1807 = local_12;
                                                let _e1810 = local_13;
                                                let _e1812 = local_14;
                                                let _e1816 = local_15;
                                                phi_2852_ = select(_e1816, _e1485, select(select(_e1812, false, _e1810), true, select(_e1807, false, _e1805)));
                                            } else {
                                                phi_2852_ = _e1485;
                                            }
                                            let _e1819 = phi_2852_;
                                            phi_2854_ = type_43(_e1721, _e1819, _e1558);
                                        } else {
                                            phi_2854_ = _e1572;
                                        }
                                        let _e1822 = phi_2854_;
                                        if (_e1822.member > _e1822.member_1) {
                                            phi_3724_ = u32();
                                            phi_3725_ = true;
                                            phi_3726_ = false;
                                            phi_3727_ = false;
                                        } else {
                                            let _e1827 = (_e1822.member > _e542);
                                            if _e1827 {
                                                phi_3721_ = u32();
                                                phi_3722_ = false;
                                                phi_3723_ = false;
                                            } else {
                                                let _e1832 = ((_e1822.member_1 - _e1822.member) * f64(0.5f));
                                                let _e1833 = (_e1822.member + _e1832);
                                                let _e1836 = (_e1832 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1843 = select(_e893.member.member[0][0], -(_e893.member.member[0][0]), (_e893.member.member[0][0] < 0.0lf));
                                                let _e1847 = select(_e893.member.member[0][1], -(_e893.member.member[0][1]), (_e893.member.member[0][1] < 0.0lf));
                                                let _e1849 = select(_e1847, _e1843, (_e1843 > _e1847));
                                                let _e1853 = select(_e893.member.member[0][2], -(_e893.member.member[0][2]), (_e893.member.member[0][2] < 0.0lf));
                                                let _e1855 = select(_e1853, _e1849, (_e1849 > _e1853));
                                                let _e1861 = select(_e893.member.member[1][0], -(_e893.member.member[1][0]), (_e893.member.member[1][0] < 0.0lf));
                                                let _e1865 = select(_e893.member.member[1][1], -(_e893.member.member[1][1]), (_e893.member.member[1][1] < 0.0lf));
                                                let _e1867 = select(_e1865, _e1861, (_e1861 > _e1865));
                                                let _e1871 = select(_e893.member.member[1][2], -(_e893.member.member[1][2]), (_e893.member.member[1][2] < 0.0lf));
                                                let _e1873 = select(_e1871, _e1867, (_e1867 > _e1871));
                                                let _e1894 = (_e893.member.member[0][0] + ((_e893.member.member[1][0] - _e893.member.member[0][0]) * _e1833));
                                                let _e1896 = (_e893.member.member[0][1] + ((_e893.member.member[1][1] - _e893.member.member[0][1]) * _e1833));
                                                let _e1898 = (_e893.member.member[0][2] + ((_e893.member.member[1][2] - _e893.member.member[0][2]) * _e1833));
                                                let _e1905 = (_e893.member.member[1][0] - _e893.member.member[0][0]);
                                                let _e1908 = (_e893.member.member[1][1] - _e893.member.member[0][1]);
                                                let _e1911 = (_e893.member.member[1][2] - _e893.member.member[0][2]);
                                                let _e1914 = select(_e1905, -(_e1905), (_e1905 < 0.0lf));
                                                let _e1917 = select(_e1908, -(_e1908), (_e1908 < 0.0lf));
                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                let _e1922 = select(_e1911, -(_e1911), (_e1911 < 0.0lf));
                                                let _e1932 = ((((_e1836 * select(_e1922, _e1919, (_e1919 > _e1922))) * f64(1.01f)) + ((select(_e1873, _e1855, (_e1855 > _e1873)) + _e893.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e893.member.member_3);
                                                let _e1935 = select(_e1894, -(_e1894), (_e1894 < 0.0lf));
                                                let _e1938 = select(_e1896, -(_e1896), (_e1896 < 0.0lf));
                                                let _e1940 = select(_e1938, _e1935, (_e1935 > _e1938));
                                                let _e1943 = select(_e1898, -(_e1898), (_e1898 < 0.0lf));
                                                let _e1946 = (select(_e1943, _e1940, (_e1940 > _e1943)) + _e1932);
                                                let _e1953 = select(_e893.member.member_1[0][0], -(_e893.member.member_1[0][0]), (_e893.member.member_1[0][0] < 0.0lf));
                                                let _e1957 = select(_e893.member.member_1[0][1], -(_e893.member.member_1[0][1]), (_e893.member.member_1[0][1] < 0.0lf));
                                                let _e1959 = select(_e1957, _e1953, (_e1953 > _e1957));
                                                let _e1963 = select(_e893.member.member_1[0][2], -(_e893.member.member_1[0][2]), (_e893.member.member_1[0][2] < 0.0lf));
                                                let _e1965 = select(_e1963, _e1959, (_e1959 > _e1963));
                                                let _e1971 = select(_e893.member.member_1[1][0], -(_e893.member.member_1[1][0]), (_e893.member.member_1[1][0] < 0.0lf));
                                                let _e1975 = select(_e893.member.member_1[1][1], -(_e893.member.member_1[1][1]), (_e893.member.member_1[1][1] < 0.0lf));
                                                let _e1977 = select(_e1975, _e1971, (_e1971 > _e1975));
                                                let _e1981 = select(_e893.member.member_1[1][2], -(_e893.member.member_1[1][2]), (_e893.member.member_1[1][2] < 0.0lf));
                                                let _e1983 = select(_e1981, _e1977, (_e1977 > _e1981));
                                                let _e2004 = (_e893.member.member_1[0][0] + ((_e893.member.member_1[1][0] - _e893.member.member_1[0][0]) * _e1833));
                                                let _e2006 = (_e893.member.member_1[0][1] + ((_e893.member.member_1[1][1] - _e893.member.member_1[0][1]) * _e1833));
                                                let _e2008 = (_e893.member.member_1[0][2] + ((_e893.member.member_1[1][2] - _e893.member.member_1[0][2]) * _e1833));
                                                let _e2015 = (_e893.member.member_1[1][0] - _e893.member.member_1[0][0]);
                                                let _e2018 = (_e893.member.member_1[1][1] - _e893.member.member_1[0][1]);
                                                let _e2021 = (_e893.member.member_1[1][2] - _e893.member.member_1[0][2]);
                                                let _e2024 = select(_e2015, -(_e2015), (_e2015 < 0.0lf));
                                                let _e2027 = select(_e2018, -(_e2018), (_e2018 < 0.0lf));
                                                let _e2029 = select(_e2027, _e2024, (_e2024 > _e2027));
                                                let _e2032 = select(_e2021, -(_e2021), (_e2021 < 0.0lf));
                                                let _e2042 = ((((_e1836 * select(_e2032, _e2029, (_e2029 > _e2032))) * f64(1.01f)) + ((select(_e1983, _e1965, (_e1965 > _e1983)) + _e893.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e893.member.member_3);
                                                let _e2045 = select(_e2004, -(_e2004), (_e2004 < 0.0lf));
                                                let _e2048 = select(_e2006, -(_e2006), (_e2006 < 0.0lf));
                                                let _e2050 = select(_e2048, _e2045, (_e2045 > _e2048));
                                                let _e2053 = select(_e2008, -(_e2008), (_e2008 < 0.0lf));
                                                let _e2056 = (select(_e2053, _e2050, (_e2050 > _e2053)) + _e2042);
                                                let _e2063 = select(_e893.member.member_2[0][0], -(_e893.member.member_2[0][0]), (_e893.member.member_2[0][0] < 0.0lf));
                                                let _e2067 = select(_e893.member.member_2[0][1], -(_e893.member.member_2[0][1]), (_e893.member.member_2[0][1] < 0.0lf));
                                                let _e2069 = select(_e2067, _e2063, (_e2063 > _e2067));
                                                let _e2073 = select(_e893.member.member_2[0][2], -(_e893.member.member_2[0][2]), (_e893.member.member_2[0][2] < 0.0lf));
                                                let _e2075 = select(_e2073, _e2069, (_e2069 > _e2073));
                                                let _e2081 = select(_e893.member.member_2[1][0], -(_e893.member.member_2[1][0]), (_e893.member.member_2[1][0] < 0.0lf));
                                                let _e2085 = select(_e893.member.member_2[1][1], -(_e893.member.member_2[1][1]), (_e893.member.member_2[1][1] < 0.0lf));
                                                let _e2087 = select(_e2085, _e2081, (_e2081 > _e2085));
                                                let _e2091 = select(_e893.member.member_2[1][2], -(_e893.member.member_2[1][2]), (_e893.member.member_2[1][2] < 0.0lf));
                                                let _e2093 = select(_e2091, _e2087, (_e2087 > _e2091));
                                                let _e2114 = (_e893.member.member_2[0][0] + ((_e893.member.member_2[1][0] - _e893.member.member_2[0][0]) * _e1833));
                                                let _e2116 = (_e893.member.member_2[0][1] + ((_e893.member.member_2[1][1] - _e893.member.member_2[0][1]) * _e1833));
                                                let _e2118 = (_e893.member.member_2[0][2] + ((_e893.member.member_2[1][2] - _e893.member.member_2[0][2]) * _e1833));
                                                let _e2125 = (_e893.member.member_2[1][0] - _e893.member.member_2[0][0]);
                                                let _e2128 = (_e893.member.member_2[1][1] - _e893.member.member_2[0][1]);
                                                let _e2131 = (_e893.member.member_2[1][2] - _e893.member.member_2[0][2]);
                                                let _e2134 = select(_e2125, -(_e2125), (_e2125 < 0.0lf));
                                                let _e2137 = select(_e2128, -(_e2128), (_e2128 < 0.0lf));
                                                let _e2139 = select(_e2137, _e2134, (_e2134 > _e2137));
                                                let _e2142 = select(_e2131, -(_e2131), (_e2131 < 0.0lf));
                                                let _e2152 = ((((_e1836 * select(_e2142, _e2139, (_e2139 > _e2142))) * f64(1.01f)) + ((select(_e2093, _e2075, (_e2075 > _e2093)) + _e893.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e893.member.member_3);
                                                let _e2155 = select(_e2114, -(_e2114), (_e2114 < 0.0lf));
                                                let _e2158 = select(_e2116, -(_e2116), (_e2116 < 0.0lf));
                                                let _e2160 = select(_e2158, _e2155, (_e2155 > _e2158));
                                                let _e2163 = select(_e2118, -(_e2118), (_e2118 < 0.0lf));
                                                let _e2166 = (select(_e2163, _e2160, (_e2160 > _e2163)) + _e2152);
                                                let _e2169 = ((_e2006 * _e2118) - (_e2008 * _e2116));
                                                let _e2172 = ((_e2008 * _e2114) - (_e2004 * _e2118));
                                                let _e2175 = ((_e2004 * _e2116) - (_e2006 * _e2114));
                                                let _e2190 = select(false, (select(_e2169, -(_e2169), (_e2169 < 0.0lf)) > select(_e2175, -(_e2175), (_e2175 < 0.0lf))), (select(_e2169, -(_e2169), (_e2169 < 0.0lf)) > select(_e2172, -(_e2172), (_e2172 < 0.0lf))));
                                                let _e2205 = select((select(_e2172, -(_e2172), (_e2172 < 0.0lf)) > select(_e2175, -(_e2175), (_e2175 < 0.0lf))), false, (select(_e2169, -(_e2169), (_e2169 < 0.0lf)) > select(_e2172, -(_e2172), (_e2172 < 0.0lf))));
                                                let _e2208 = select(select(_e1894, _e1896, _e2190), _e1898, _e2205);
                                                let _e2209 = select(select(_e1896, _e1898, _e2190), _e1894, _e2205);
                                                let _e2212 = select(select(_e2004, _e2006, _e2190), _e2008, _e2205);
                                                let _e2213 = select(select(_e2006, _e2008, _e2190), _e2004, _e2205);
                                                let _e2216 = select(select(_e2114, _e2116, _e2190), _e2118, _e2205);
                                                let _e2217 = select(select(_e2116, _e2118, _e2190), _e2114, _e2205);
                                                let _e2220 = ((_e2212 * _e2217) - (_e2213 * _e2216));
                                                let _e2221 = f64(1f);
                                                let _e2222 = f64(2f);
                                                let _e2240 = (((((_e2042 * _e2166) + (_e2056 * _e2152)) * f64(2.01f)) + (((_e2056 * _e2222) * (_e2166 * _e2222)) * (1.1102230246251565e-16lf * _e2222))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2221 + _e2056) * (_e2221 + _e2166))));
                                                if (select(_e2220, -(_e2220), (_e2220 < 0.0lf)) > _e2240) {
                                                    let _e2249 = select(f64(1f), f64(-1f), (_e2220 < f64(0f)));
                                                    let _e2253 = f64(1f);
                                                    let _e2254 = f64(2f);
                                                    let _e2272 = (((((_e1932 * _e2166) + (_e1946 * _e2152)) * f64(2.01f)) + (((_e1946 * _e2254) * (_e2166 * _e2254)) * (1.1102230246251565e-16lf * _e2254))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2253 + _e1946) * (_e2253 + _e2166))));
                                                    let _e2276 = f64(1f);
                                                    let _e2277 = f64(2f);
                                                    let _e2295 = (((((_e2042 * _e1946) + (_e2056 * _e1932)) * f64(2.01f)) + (((_e2056 * _e2277) * (_e1946 * _e2277)) * (1.1102230246251565e-16lf * _e2277))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2276 + _e2056) * (_e2276 + _e1946))));
                                                    let _e2296 = (_e2220 * _e2249);
                                                    let _e2297 = (((_e2208 * _e2217) - (_e2209 * _e2216)) * _e2249);
                                                    let _e2298 = (((_e2212 * _e2209) - (_e2213 * _e2208)) * _e2249);
                                                    let _e2312 = (((select(_e2296, -(_e2296), (_e2296 < 0.0lf)) + select(_e2297, -(_e2297), (_e2297 < 0.0lf))) + select(_e2298, -(_e2298), (_e2298 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e221.member != 0u) {
                                                        phi_3619_ = array<type_35, 4>(type_35(_e2297, _e2272), type_35(_e2298, _e2295), type_35((_e2296 - _e2297), ((_e2240 + _e2272) + _e2312)), type_35((_e2296 - _e2298), ((_e2240 + _e2295) + _e2312)));
                                                    } else {
                                                        let _e2315 = ((_e2296 - _e2297) - _e2298);
                                                        let _e2318 = (((_e2240 + _e2272) + _e2295) + _e2312);
                                                        phi_3619_ = array<type_35, 4>(type_35(_e2297, _e2272), type_35(_e2298, _e2295), type_35(_e2315, _e2318), type_35(_e2315, _e2318));
                                                    }
                                                    let _e2336 = phi_3619_;
                                                    local_1 = array<type_35, 4>(type_35(_e2336[0].member, _e2336[0].member_1), type_35(_e2336[1].member, _e2336[1].member_1), type_35(_e2336[2].member, _e2336[2].member_1), type_35(_e2336[3].member, _e2336[3].member_1));
                                                    phi_3639_ = type_9(0u, 4u);
                                                    phi_3642_ = true;
                                                    loop {
                                                        let _e2355 = phi_3639_;
                                                        let _e2357 = phi_3642_;
                                                        local_17 = _e2357;
                                                        let _e2360 = (_e2355.member < _e2355.member_1);
                                                        let _e2371 = select(type_9().member_1, _e2355.member, _e2360);
                                                        if (bitcast<i32>(select(0u, 1u, _e2360)) != 0i) {
                                                            let _e2376 = local_1[_e2371].member;
                                                            let _e2379 = local_1[_e2371].member_1;
                                                            let _e2381 = (_e2376 < -(_e2379));
                                                            phi_3643_ = select((_e2357 && (_e2376 > _e2379)), bool(), _e2381);
                                                            phi_3694_ = select(true, false, _e2381);
                                                            phi_3695_ = _e2381;
                                                        } else {
                                                            phi_3643_ = bool();
                                                            phi_3694_ = false;
                                                            phi_3695_ = false;
                                                        }
                                                        let _e2387 = phi_3643_;
                                                        let _e2389 = phi_3694_;
                                                        let _e2391 = phi_3695_;
                                                        local_16 = _e2391;
                                                        continue;
                                                        continuing {
                                                            phi_3639_ = type_9(select(_e2355.member, (_e2355.member + 1u), _e2360), select(_e2355.member_1, _e2355.member_1, _e2360));
                                                            phi_3642_ = _e2387;
                                                            break if !(_e2389);
                                                        }
                                                    }
                                                    let _e2394 = local_16;
                                                    let _e2395 = select(true, false, _e2394);
                                                    let _e2397 = local_17;
                                                    phi_3709_ = select(u32(), select(2u, 1u, _e2397), _e2395);
                                                    phi_3710_ = 0u;
                                                    phi_3711_ = select(true, false, _e2395);
                                                } else {
                                                    phi_3709_ = u32();
                                                    phi_3710_ = 2u;
                                                    phi_3711_ = true;
                                                }
                                                let _e2402 = phi_3709_;
                                                let _e2404 = phi_3710_;
                                                let _e2406 = phi_3711_;
                                                let _e2407 = select(_e2402, _e2404, _e2406);
                                                let _e2408 = (_e2407 == 0u);
                                                phi_3721_ = _e2407;
                                                phi_3722_ = _e2408;
                                                phi_3723_ = select(true, false, _e2408);
                                            }
                                            let _e2411 = phi_3721_;
                                            let _e2413 = phi_3722_;
                                            let _e2415 = phi_3723_;
                                            phi_3724_ = _e2411;
                                            phi_3725_ = _e2413;
                                            phi_3726_ = _e1827;
                                            phi_3727_ = _e2415;
                                        }
                                        let _e2417 = phi_3724_;
                                        let _e2419 = phi_3725_;
                                        let _e2421 = phi_3726_;
                                        let _e2423 = phi_3727_;
                                        phi_3728_ = _e1822;
                                        phi_3729_ = _e2417;
                                        phi_3730_ = _e2419;
                                        phi_3731_ = _e2421;
                                        phi_3732_ = _e2423;
                                    }
                                    let _e2425 = phi_3728_;
                                    let _e2427 = phi_3729_;
                                    let _e2429 = phi_3730_;
                                    let _e2431 = phi_3731_;
                                    let _e2433 = phi_3732_;
                                    phi_3733_ = _e2425;
                                    phi_3734_ = _e2427;
                                    phi_3735_ = _e2429;
                                    phi_3736_ = _e1487;
                                    phi_3737_ = _e2431;
                                    phi_3738_ = _e2433;
                                } else {
                                    phi_3733_ = type_43();
                                    phi_3734_ = u32();
                                    phi_3735_ = true;
                                    phi_3736_ = false;
                                    phi_3737_ = false;
                                    phi_3738_ = false;
                                }
                                let _e2435 = phi_3733_;
                                let _e2437 = phi_3734_;
                                let _e2439 = phi_3735_;
                                let _e2441 = phi_3736_;
                                let _e2443 = phi_3737_;
                                let _e2445 = phi_3738_;
                                phi_3745_ = _e2435;
                                phi_3746_ = _e2437;
                                phi_3747_ = _e2439;
                                phi_3748_ = select(_e2441, false, _e2439);
                                phi_3749_ = select(_e2443, false, _e2439);
                                phi_3750_ = select(_e2445, false, _e2439);
                                phi_3751_ = false;
                            } else {
                                phi_3745_ = type_43();
                                phi_3746_ = u32();
                                phi_3747_ = false;
                                phi_3748_ = false;
                                phi_3749_ = false;
                                phi_3750_ = false;
                                phi_3751_ = true;
                            }
                            let _e2450 = phi_3745_;
                            let _e2452 = phi_3746_;
                            let _e2454 = phi_3747_;
                            let _e2456 = phi_3748_;
                            let _e2458 = phi_3749_;
                            let _e2460 = phi_3750_;
                            let _e2462 = phi_3751_;
                            phi_3752_ = _e2450;
                            phi_3753_ = _e2452;
                            phi_3754_ = type_43(_e524, _e524, false);
                            phi_3755_ = _e2454;
                            phi_3756_ = false;
                            phi_3757_ = _e2456;
                            phi_3758_ = _e2458;
                            phi_3759_ = _e2460;
                            phi_3760_ = _e2462;
                        } else {
                            phi_3752_ = type_43();
                            phi_3753_ = u32();
                            phi_3754_ = type_43();
                            phi_3755_ = false;
                            phi_3756_ = true;
                            phi_3757_ = false;
                            phi_3758_ = false;
                            phi_3759_ = false;
                            phi_3760_ = false;
                        }
                        let _e2464 = phi_3752_;
                        let _e2466 = phi_3753_;
                        let _e2468 = phi_3754_;
                        let _e2470 = phi_3755_;
                        let _e2472 = phi_3756_;
                        let _e2474 = phi_3757_;
                        let _e2476 = phi_3758_;
                        let _e2478 = phi_3759_;
                        let _e2480 = phi_3760_;
                        local_18 = _e2472;
                        local_19 = _e2472;
                        local_20 = _e2472;
                        local_21 = _e2474;
                        local_22 = _e2472;
                        local_23 = _e2476;
                        local_24 = _e2472;
                        local_25 = _e2478;
                        local_26 = _e2472;
                        local_27 = _e2480;
                        local_28 = _e2466;
                        local_29 = _e2464;
                        local_30 = _e2464;
                        local_31 = _e2464;
                        local_32 = _e2464;
                        local_33 = _e2468;
                        local_34 = _e2464;
                        continue;
                        continuing {
                            phi_2408_ = type_9(select(_e1458.member, (_e1458.member + 1u), _e1461), select(_e1458.member_1, _e1458.member_1, _e1461));
                            break if !(_e2470);
                        }
                    }
                    let _e2484 = local_18;
                    let _e2489 = local_19;
                    let _e2493 = local_20;
                    let _e2495 = local_21;
                    let _e2496 = select(_e2495, false, _e2493);
                    let _e2498 = local_22;
                    let _e2500 = local_23;
                    let _e2503 = local_24;
                    let _e2505 = local_25;
                    let _e2508 = local_26;
                    let _e2510 = local_27;
                    let _e2517 = select(select(_e2500, false, _e2498), false, _e2496);
                    if select(select(select(_e2505, false, _e2503), false, _e2496), false, _e2517) {
                        let _e2528 = local_28;
                        let _e2531 = local_29;
                        if select(false, _e2531.member_2, (_e2528 == 1u)) {
                            let _e2535 = local_30;
                            let _e2538 = local_31;
                            let _e2541 = ((_e2535.member_1 - _e2538.member) <= (_e515 * f64(0.99f)));
                            let _e2543 = local_32;
                            phi_3809_ = type_42(select(type_42().member, 1u, _e2541), select(type_42().member_1, _e2543.member, _e2541));
                            phi_3810_ = select(true, false, _e2541);
                        } else {
                            phi_3809_ = type_42();
                            phi_3810_ = true;
                        }
                        let _e2552 = phi_3809_;
                        let _e2554 = phi_3810_;
                        phi_3815_ = _e2552;
                        phi_3816_ = select(true, false, _e2554);
                        phi_3817_ = false;
                        phi_3818_ = _e2554;
                    } else {
                        phi_3815_ = type_42(select(select(type_42().member, 0u, _e2496), 0u, _e2517), select(select(type_42().member_1, type_42().member_1, _e2496), type_42().member_1, _e2517));
                        phi_3816_ = select(_e2496, true, _e2517);
                        phi_3817_ = select(select(select(_e2510, false, _e2508), false, _e2496), false, _e2517);
                        phi_3818_ = false;
                    }
                    let _e2557 = phi_3815_;
                    let _e2559 = phi_3816_;
                    let _e2561 = phi_3817_;
                    let _e2563 = phi_3818_;
                    let _e2564 = select(_e2561, false, _e2559);
                    let _e2567 = local_33;
                    let _e2570 = local_34;
                    let _e2573 = select(select(_e2563, false, _e2559), true, _e2564);
                    phi_3840_ = type_42(select(_e2557.member, 2u, _e2573), select(_e2557.member_1, select(_e2570.member, _e2567.member, _e2564), _e2573));
                    phi_3841_ = type_42(select(type_42().member, 0u, _e2484), select(type_42().member_1, type_42().member_1, _e2489));
                    phi_3842_ = select(select(_e2559, false, _e2564), true, _e2573);
                }
                let _e2584 = phi_3840_;
                let _e2586 = phi_3841_;
                let _e2588 = phi_3842_;
                let _e2591 = select(_e2586.member, _e2584.member, _e2588);
                let _e2594 = select(_e2586.member_1, _e2584.member_1, _e2588);
                let _e2600 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e2594 > _e524)), (_e2591 == 1u))));
                switch bitcast<i32>(_e2591) {
                    case 0: {
                        phi_3886_ = type_34(0u, _e2600, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e2604 = function_1(_e2594);
                        phi_3886_ = type_34(0u, _e2600, _e2604, true);
                        break;
                    }
                    case 2: {
                        let _e2602 = function_1(_e2594);
                        phi_3886_ = type_34(1u, _e2600, _e2602, true);
                        break;
                    }
                    default: {
                        phi_3886_ = type_34();
                        break;
                    }
                }
                let _e2608 = phi_3886_;
                local_6 = type_34(_e2608.member, _e2608.member_1, array<u32, 2>(_e2608.member_2[0], _e2608.member_2[1]), _e2608.member_3);
                phi_3895_ = type_9(_e179, _e182);
            } else {
                phi_3895_ = type_9(0u, 0u);
            }
            let _e2618 = phi_3895_;
            let _e2624 = params.member.member_2.member;
            let _e2627 = local_6.member;
            let _e2628 = (_e2627 == 0u);
            let _e2631 = select(select((_e2624 > 0u), bool(), _e2628), false, _e2628);
            if _e2631 {
                local = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e2632 = local_6;
                local = _e2632;
            }
            let _e2634 = local.member;
            let _e2636 = select(true, false, (_e2634 == 0u));
            let _e2638 = local.member_3;
            if _e2638 {
                if _e2636 {
                    phi_3952_ = true;
                } else {
                    let _e2640 = params.member.member.member_1;
                    phi_3952_ = ((_e2640 & 16u) != 0u);
                }
                let _e2644 = phi_3952_;
                phi_3953_ = _e2644;
            } else {
                phi_3953_ = false;
            }
            let _e2646 = phi_3953_;
            let _e2648 = local.member_3;
            if _e2648 {
                if _e2636 {
                } else {
                    let _e2650 = local.member_2;
                    let _e2654 = (_e2650[1] >> bitcast<u32>(20i));
                    let _e2668 = atomicMin((&earliest.member[0u]), select(((((_e2654 - 896u) << bitcast<u32>(23i)) | ((_e2650[1] & 1048575u) << bitcast<u32>(3i))) | (_e2650[0] >> bitcast<u32>(29i))), 0u, (_e2654 <= 896u)));
                }
            }
            if (_e96 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2646 {
                let _e2672 = atomicAdd((&counters[0u]), 1u);
                phi_3996_ = _e2672;
            } else {
                phi_3996_ = 0u;
            }
            let _e2674 = phi_3996_;
            workgroupBarrier();
            if (_e96 == 0u) {
                let _e2677 = atomicLoad((&counters[0u]));
                if (_e2677 > 0u) {
                    let _e2680 = atomicAdd((&contacts.member[0u]), _e2677);
                    atomicStore((&counters[1u]), _e2680);
                }
            }
            workgroupBarrier();
            let _e2683 = atomicLoad((&counters[1u]));
            let _e2684 = (_e2683 + _e2674);
            if _e2646 {
                let _e2686 = params.member.member_1.member_3;
                if (_e2684 < _e2686) {
                    let _e2692 = (7u * _e2684);
                    atomicStore((&contacts.member[(4u + _e2692)]), select(1u, 0u, ((_e2618.member_1 & 2147483648u) == 0u)));
                    let _e2697 = local.member;
                    atomicStore((&contacts.member[(_e2692 + 5u)]), _e2697);
                    atomicStore((&contacts.member[(_e2692 + 6u)]), _e2618.member);
                    atomicStore((&contacts.member[(_e2692 + 7u)]), (_e2618.member_1 & 2147483647u));
                    let _e2706 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e2692 + 8u)]), _e2706);
                    let _e2711 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e2692 + 9u)]), _e2711);
                    let _e2715 = local.member_1;
                    atomicStore((&contacts.member[(_e2692 + 10u)]), _e2715);
                }
            }
            workgroupBarrier();
            if (_e96 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2631 {
                let _e2720 = atomicAdd((&counters[0u]), 1u);
                phi_4078_ = _e2720;
            } else {
                phi_4078_ = 0u;
            }
            let _e2722 = phi_4078_;
            workgroupBarrier();
            if (_e96 == 0u) {
                let _e2725 = atomicLoad((&counters[0u]));
                if (_e2725 > 0u) {
                    let _e2728 = atomicAdd((&left.member[0u]), _e2725);
                    atomicStore((&counters[1u]), _e2728);
                }
            }
            workgroupBarrier();
            let _e2731 = atomicLoad((&counters[1u]));
            let _e2732 = (_e2731 + _e2722);
            if _e2631 {
                if (_e2732 < _e2624) {
                    let _e2734 = (2u * _e2732);
                    atomicStore((&left.member[(4u + _e2734)]), _e2618.member);
                    atomicStore((&left.member[(_e2734 + 5u)]), _e2618.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_421_ = type_9(select(_e150.member, (_e150.member + 1u), _e153), select(_e150.member_1, _e150.member_1, _e153));
            break if !(_e166);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
