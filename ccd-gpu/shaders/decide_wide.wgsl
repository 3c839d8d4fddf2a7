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
    var phi_3983_: bool;
    var phi_3984_: bool;
    var phi_3989_: bool;

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
            phi_3983_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_3984_ = select(true, false, _e87);
        } else {
            phi_3983_ = bool();
            phi_3984_ = true;
        }
        let _e96 = phi_3983_;
        let _e98 = phi_3984_;
        phi_3989_ = select(_e96, false, _e98);
    } else {
        phi_3989_ = false;
    }
    let _e101 = phi_3989_;
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
    var phi_1225_: bool;
    var phi_1321_: type_41;
    var phi_1322_: bool;
    var phi_1323_: type_41;
    var phi_1324_: bool;
    var phi_1325_: type_41;
    var phi_1326_: bool;
    var phi_1331_: type_41;
    var phi_1876_: bool;
    var phi_1891_: f64;
    var phi_1967_: type_16;
    var phi_1970_: f64;
    var phi_1968_: type_16;
    var phi_2011_: type_17;
    var phi_1971_: f64;
    var local_7: f64;
    var phi_2024_: f64;
    var phi_2055_: type_9;
    var phi_2058_: u32;
    var phi_2125_: u32;
    var phi_2126_: u32;
    var phi_2059_: u32;
    var phi_2127_: u32;
    var phi_2185_: type_9;
    var phi_2345_: type_43;
    var phi_2346_: bool;
    var phi_2347_: type_43;
    var phi_2348_: bool;
    var phi_2383_: type_9;
    var phi_2386_: f64;
    var phi_2388_: f64;
    var phi_2390_: f64;
    var phi_2504_: bool;
    var phi_2511_: f64;
    var phi_2512_: bool;
    var phi_2387_: f64;
    var phi_2389_: f64;
    var phi_2391_: f64;
    var phi_2513_: f64;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var local_8: bool;
    var local_9: f64;
    var local_10: f64;
    var phi_2520_: f64;
    var phi_2538_: type_9;
    var phi_2541_: f64;
    var phi_2607_: f64;
    var phi_2608_: bool;
    var phi_2609_: bool;
    var phi_2610_: bool;
    var phi_2611_: f64;
    var phi_2542_: f64;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2615_: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: f64;
    var phi_2629_: f64;
    var phi_2631_: type_43;
    var phi_3396_: array<type_35, 4>;
    var phi_3416_: type_9;
    var phi_3419_: bool;
    var phi_3420_: bool;
    var phi_3471_: bool;
    var phi_3472_: bool;
    var local_16: bool;
    var local_17: bool;
    var phi_3486_: u32;
    var phi_3487_: u32;
    var phi_3488_: bool;
    var phi_3498_: u32;
    var phi_3499_: bool;
    var phi_3500_: bool;
    var phi_3501_: u32;
    var phi_3502_: bool;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3505_: type_43;
    var phi_3506_: u32;
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var phi_3510_: type_43;
    var phi_3511_: u32;
    var phi_3512_: bool;
    var phi_3513_: bool;
    var phi_3514_: bool;
    var phi_3515_: bool;
    var phi_3522_: type_43;
    var phi_3523_: u32;
    var phi_3524_: bool;
    var phi_3525_: bool;
    var phi_3526_: bool;
    var phi_3527_: bool;
    var phi_3528_: bool;
    var phi_3529_: type_43;
    var phi_3530_: u32;
    var phi_3531_: type_43;
    var phi_3532_: bool;
    var phi_3533_: bool;
    var phi_3534_: bool;
    var phi_3535_: bool;
    var phi_3536_: bool;
    var phi_3537_: bool;
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
    var phi_3586_: type_42;
    var phi_3587_: bool;
    var phi_3592_: type_42;
    var phi_3593_: bool;
    var phi_3594_: bool;
    var phi_3595_: bool;
    var local_33: type_43;
    var local_34: type_43;
    var phi_3617_: type_42;
    var phi_3618_: type_42;
    var phi_3619_: bool;
    var phi_3663_: type_34;
    var phi_3672_: type_9;
    var phi_3729_: bool;
    var phi_3730_: bool;
    var phi_3773_: u32;
    var phi_3855_: u32;
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
                if (_e667 <= f64(65536f)) {
                    phi_1225_ = (_e667 >= f64((1f / 65536f)));
                } else {
                    phi_1225_ = false;
                }
                let _e674 = phi_1225_;
                if _e674 {
                    phi_1325_ = type_41();
                    phi_1326_ = true;
                } else {
                    if (_e667 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e667) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e681 = (9214364837600034816lu - (bitcast<u64>(_e667) & 9218868437227405312lu));
                            let _e684 = bitcast<f64>(select(4503599627370496lu, _e681, (_e681 > 4503599627370496lu)));
                            let _e685 = (_e543 * _e684);
                            phi_1321_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e506.member[0][0] * _e684), (_e506.member[0][1] * _e684), (_e506.member[0][2] * _e684)), array<f64, 3>((_e506.member[1][0] * _e684), (_e506.member[1][1] * _e684), (_e506.member[1][2] * _e684))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_1[0][0] * _e684), (_e506.member_1[0][1] * _e684), (_e506.member_1[0][2] * _e684)), array<f64, 3>((_e506.member_1[1][0] * _e684), (_e506.member_1[1][1] * _e684), (_e506.member_1[1][2] * _e684))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_2[0][0] * _e684), (_e506.member_2[0][1] * _e684), (_e506.member_2[0][2] * _e684)), array<f64, 3>((_e506.member_2[1][0] * _e684), (_e506.member_2[1][1] * _e684), (_e506.member_2[1][2] * _e684))), ((_e506.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e684)), select(_e685, select(2.2250738585072014e-308lf, _e685, (_e685 > 2.2250738585072014e-308lf)), (_e543 > f64(0f))));
                            phi_1322_ = false;
                        } else {
                            phi_1321_ = type_41();
                            phi_1322_ = true;
                        }
                        let _e756 = phi_1321_;
                        let _e758 = phi_1322_;
                        phi_1323_ = _e756;
                        phi_1324_ = _e758;
                    } else {
                        phi_1323_ = type_41();
                        phi_1324_ = true;
                    }
                    let _e760 = phi_1323_;
                    let _e762 = phi_1324_;
                    phi_1325_ = _e760;
                    phi_1326_ = _e762;
                }
                let _e764 = phi_1325_;
                let _e766 = phi_1326_;
                if _e766 {
                    phi_1331_ = type_41(_e506, _e543);
                } else {
                    phi_1331_ = _e764;
                }
                let _e769 = phi_1331_;
                let _e781 = ((_e769.member.member_1[0][1] * _e769.member.member_2[0][2]) - (_e769.member.member_1[0][2] * _e769.member.member_2[0][1]));
                let _e788 = ((_e769.member.member_1[0][2] * _e769.member.member_2[0][0]) - (_e769.member.member_1[0][0] * _e769.member.member_2[0][2]));
                let _e795 = ((_e769.member.member_1[0][0] * _e769.member.member_2[0][1]) - (_e769.member.member_1[0][1] * _e769.member.member_2[0][0]));
                let _e806 = ((_e769.member.member_1[1][1] * _e769.member.member_2[1][2]) - (_e769.member.member_1[1][2] * _e769.member.member_2[1][1]));
                let _e813 = ((_e769.member.member_1[1][2] * _e769.member.member_2[1][0]) - (_e769.member.member_1[1][0] * _e769.member.member_2[1][2]));
                let _e820 = ((_e769.member.member_1[1][0] * _e769.member.member_2[1][1]) - (_e769.member.member_1[1][1] * _e769.member.member_2[1][0]));
                let _e871 = (((_e769.member.member_1[0][1] * _e769.member.member_2[1][2]) - (_e769.member.member_1[0][2] * _e769.member.member_2[1][1])) + ((_e769.member.member_1[1][1] * _e769.member.member_2[0][2]) - (_e769.member.member_1[1][2] * _e769.member.member_2[0][1])));
                let _e872 = (((_e769.member.member_1[0][2] * _e769.member.member_2[1][0]) - (_e769.member.member_1[0][0] * _e769.member.member_2[1][2])) + ((_e769.member.member_1[1][2] * _e769.member.member_2[0][0]) - (_e769.member.member_1[1][0] * _e769.member.member_2[0][2])));
                let _e873 = (((_e769.member.member_1[0][0] * _e769.member.member_2[1][1]) - (_e769.member.member_1[0][1] * _e769.member.member_2[1][0])) + ((_e769.member.member_1[1][0] * _e769.member.member_2[0][1]) - (_e769.member.member_1[1][1] * _e769.member.member_2[0][0])));
                let _e883 = (((_e769.member.member[0][0] * _e781) + (_e769.member.member[0][1] * _e788)) + (_e769.member.member[0][2] * _e795));
                let _e904 = ((((_e769.member.member[1][0] * _e781) + (_e769.member.member[1][1] * _e788)) + (_e769.member.member[1][2] * _e795)) + (((_e769.member.member[0][0] * _e871) + (_e769.member.member[0][1] * _e872)) + (_e769.member.member[0][2] * _e873)));
                let _e925 = ((((_e769.member.member[0][0] * _e806) + (_e769.member.member[0][1] * _e813)) + (_e769.member.member[0][2] * _e820)) + (((_e769.member.member[1][0] * _e871) + (_e769.member.member[1][1] * _e872)) + (_e769.member.member[1][2] * _e873)));
                let _e935 = (((_e769.member.member[1][0] * _e806) + (_e769.member.member[1][1] * _e813)) + (_e769.member.member[1][2] * _e820));
                let _e941 = select(_e769.member.member[0][0], -(_e769.member.member[0][0]), (_e769.member.member[0][0] < 0.0lf));
                let _e945 = select(_e769.member.member[0][1], -(_e769.member.member[0][1]), (_e769.member.member[0][1] < 0.0lf));
                let _e947 = select(_e945, _e941, (_e941 > _e945));
                let _e951 = select(_e769.member.member[0][2], -(_e769.member.member[0][2]), (_e769.member.member[0][2] < 0.0lf));
                let _e953 = select(_e951, _e947, (_e947 > _e951));
                let _e959 = select(_e769.member.member[1][0], -(_e769.member.member[1][0]), (_e769.member.member[1][0] < 0.0lf));
                let _e963 = select(_e769.member.member[1][1], -(_e769.member.member[1][1]), (_e769.member.member[1][1] < 0.0lf));
                let _e965 = select(_e963, _e959, (_e959 > _e963));
                let _e969 = select(_e769.member.member[1][2], -(_e769.member.member[1][2]), (_e769.member.member[1][2] < 0.0lf));
                let _e971 = select(_e969, _e965, (_e965 > _e969));
                let _e975 = (select(_e971, _e953, (_e953 > _e971)) + _e769.member.member_3);
                let _e981 = select(_e769.member.member_1[0][0], -(_e769.member.member_1[0][0]), (_e769.member.member_1[0][0] < 0.0lf));
                let _e985 = select(_e769.member.member_1[0][1], -(_e769.member.member_1[0][1]), (_e769.member.member_1[0][1] < 0.0lf));
                let _e987 = select(_e985, _e981, (_e981 > _e985));
                let _e991 = select(_e769.member.member_1[0][2], -(_e769.member.member_1[0][2]), (_e769.member.member_1[0][2] < 0.0lf));
                let _e993 = select(_e991, _e987, (_e987 > _e991));
                let _e999 = select(_e769.member.member_1[1][0], -(_e769.member.member_1[1][0]), (_e769.member.member_1[1][0] < 0.0lf));
                let _e1003 = select(_e769.member.member_1[1][1], -(_e769.member.member_1[1][1]), (_e769.member.member_1[1][1] < 0.0lf));
                let _e1005 = select(_e1003, _e999, (_e999 > _e1003));
                let _e1009 = select(_e769.member.member_1[1][2], -(_e769.member.member_1[1][2]), (_e769.member.member_1[1][2] < 0.0lf));
                let _e1011 = select(_e1009, _e1005, (_e1005 > _e1009));
                let _e1015 = (select(_e1011, _e993, (_e993 > _e1011)) + _e769.member.member_3);
                let _e1021 = select(_e769.member.member_2[0][0], -(_e769.member.member_2[0][0]), (_e769.member.member_2[0][0] < 0.0lf));
                let _e1025 = select(_e769.member.member_2[0][1], -(_e769.member.member_2[0][1]), (_e769.member.member_2[0][1] < 0.0lf));
                let _e1027 = select(_e1025, _e1021, (_e1021 > _e1025));
                let _e1031 = select(_e769.member.member_2[0][2], -(_e769.member.member_2[0][2]), (_e769.member.member_2[0][2] < 0.0lf));
                let _e1033 = select(_e1031, _e1027, (_e1027 > _e1031));
                let _e1039 = select(_e769.member.member_2[1][0], -(_e769.member.member_2[1][0]), (_e769.member.member_2[1][0] < 0.0lf));
                let _e1043 = select(_e769.member.member_2[1][1], -(_e769.member.member_2[1][1]), (_e769.member.member_2[1][1] < 0.0lf));
                let _e1045 = select(_e1043, _e1039, (_e1039 > _e1043));
                let _e1049 = select(_e769.member.member_2[1][2], -(_e769.member.member_2[1][2]), (_e769.member.member_2[1][2] < 0.0lf));
                let _e1051 = select(_e1049, _e1045, (_e1045 > _e1049));
                let _e1055 = (select(_e1051, _e1033, (_e1033 > _e1051)) + _e769.member.member_3);
                let _e1056 = f64(1f);
                let _e1057 = f64(8f);
                let _e1083 = (((((_e975 * _e1057) * ((_e1015 * _e1057) * _e1055)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e769.member.member_3 * f64(19f)) * ((_e975 * (_e1015 + _e1055)) + (_e1015 * _e1055)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1056 + _e975) * ((_e1056 + _e1015) * (_e1056 + _e1055)))));
                let _e1084 = f64(3f);
                let _e1085 = (_e883 * _e1084);
                let _e1086 = (_e935 * _e1084);
                let _e1088 = select(_e1086, _e1085, (_e1085 < _e1086));
                let _e1090 = select(_e925, _e904, (_e904 < _e925));
                let _e1092 = select(_e1090, _e1088, (_e1088 < _e1090));
                let _e1094 = select(_e1086, _e1085, (_e1085 > _e1086));
                let _e1096 = select(_e925, _e904, (_e904 > _e925));
                let _e1099 = -(select(_e1096, _e1094, (_e1094 > _e1096)));
                if (select(_e1099, _e1092, (_e1092 > _e1099)) > _e1083) {
                    phi_3617_ = type_42(0u, type_42().member_1);
                    phi_3618_ = type_42();
                    phi_3619_ = true;
                } else {
                    let _e1107 = select(_e883, -(_e883), (_e883 < 0.0lf));
                    let _e1110 = select(_e904, -(_e904), (_e904 < 0.0lf));
                    let _e1112 = select(_e1110, _e1107, (_e1107 > _e1110));
                    let _e1115 = select(_e925, -(_e925), (_e925 < 0.0lf));
                    let _e1118 = select(_e935, -(_e935), (_e935 < 0.0lf));
                    let _e1120 = select(_e1118, _e1115, (_e1115 > _e1118));
                    let _e1122 = select(_e1120, _e1112, (_e1112 > _e1120));
                    let _e1124 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1125 = f64(1f);
                    if (_e1122 >= _e1124) {
                        phi_1876_ = (_e1122 <= (_e1125 / _e1124));
                    } else {
                        phi_1876_ = false;
                    }
                    let _e1130 = phi_1876_;
                    if _e1130 {
                        phi_1891_ = (_e1125 / _e1122);
                    } else {
                        phi_1891_ = f64(0f);
                    }
                    let _e1140 = phi_1891_;
                    let _e1141 = f64(0.00000000000022737368f);
                    let _e1143 = (_e515 * f64(0.0625f));
                    local_4 = type_39(array<f64, 4>(_e883, _e904, _e925, _e935), ((_e1083 * f64(0.34f)) + (_e1122 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1130))), _e1140, select(_e1143, _e1141, (_e1141 < _e1143)));
                    let _e1148 = f64(0f);
                    let _e1149 = f64(1f);
                    let _e1150 = f64(3f);
                    let _e1153 = local_4.member[0u];
                    let _e1156 = local_4.member[1u];
                    let _e1159 = local_4.member[2u];
                    let _e1162 = local_4.member[3u];
                    let _e1169 = local_4.member_2;
                    let _e1170 = ((_e1156 - (_e1150 * _e1153)) * _e1169);
                    let _e1172 = local_4.member_2;
                    let _e1173 = ((_e1159 - _e1156) * _e1172);
                    let _e1175 = local_4.member_2;
                    let _e1176 = (((_e1150 * _e1162) - _e1159) * _e1175);
                    local_2[0u] = _e1148;
                    local_2[1u] = _e1149;
                    local_2[2u] = _e1149;
                    local_2[3u] = _e1149;
                    let _e1183 = ((_e1173 * _e1173) - (_e1170 * _e1176));
                    if (_e1183 > _e1148) {
                        if (_e1183 <= 2.2250738585072014e-308lf) {
                            phi_2024_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1183 > 0.0lf));
                        } else {
                            phi_1967_ = type_16(0i, 5i);
                            phi_1970_ = bitcast<f64>(((bitcast<u64>(_e1183) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1191 = phi_1967_;
                                let _e1193 = phi_1970_;
                                local_7 = _e1193;
                                if (_e1191.member < _e1191.member_1) {
                                    let _e1200 = (_e1191.member + 1i);
                                    phi_1968_ = type_16(select(_e1200, type_17().member_1, select(false, true, ((false == (_e1200 > _e1191.member)) != false))), _e1191.member_1);
                                    phi_2011_ = type_17(1u, _e1191.member);
                                } else {
                                    phi_1968_ = _e1191;
                                    phi_2011_ = type_17(0u, type_17().member_1);
                                }
                                let _e1211 = phi_1968_;
                                let _e1213 = phi_2011_;
                                let _e1216 = (bitcast<i32>(_e1213.member) != 0i);
                                if _e1216 {
                                    phi_1971_ = (0.5lf * (_e1193 + (_e1183 / _e1193)));
                                } else {
                                    phi_1971_ = f64();
                                }
                                let _e1221 = phi_1971_;
                                continue;
                                continuing {
                                    phi_1967_ = _e1211;
                                    phi_1970_ = _e1221;
                                    break if !(_e1216);
                                }
                            }
                            let _e1226 = local_7;
                            phi_2024_ = (_e1226 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1232 = phi_2024_;
                        let _e1237 = -((_e1173 + select(_e1232, -(_e1232), (_e1173 < _e1148))));
                        local_3[0u] = (_e1237 / (_e1237 + _e1176));
                        local_3[1u] = (_e1170 / (_e1170 + _e1237));
                        let _e1246 = local_3[1u];
                        let _e1247 = local_3[0u];
                        if (_e1246 < _e1247) {
                            let _e1250 = local_3[1u];
                            let _e1252 = local_3[0u];
                            local_3[0u] = _e1250;
                            local_3[1u] = _e1252;
                        }
                        phi_2055_ = type_9(0u, 2u);
                        phi_2058_ = 1u;
                        loop {
                            let _e1256 = phi_2055_;
                            let _e1258 = phi_2058_;
                            local_35 = _e1258;
                            let _e1261 = (_e1256.member < _e1256.member_1);
                            let _e1272 = select(type_9().member_1, _e1256.member, _e1261);
                            let _e1274 = (bitcast<i32>(select(0u, 1u, _e1261)) != 0i);
                            if _e1274 {
                                let _e1276 = local_3[_e1272];
                                if (_e1276 > _e1148) {
                                    let _e1279 = local_3[_e1272];
                                    if (_e1279 < _e1149) {
                                        let _e1282 = local_3[_e1272];
                                        local_2[_e1258] = _e1282;
                                        phi_2125_ = (_e1258 + 1u);
                                    } else {
                                        phi_2125_ = _e1258;
                                    }
                                    let _e1286 = phi_2125_;
                                    phi_2126_ = _e1286;
                                } else {
                                    phi_2126_ = _e1258;
                                }
                                let _e1288 = phi_2126_;
                                phi_2059_ = _e1288;
                            } else {
                                phi_2059_ = u32();
                            }
                            let _e1290 = phi_2059_;
                            continue;
                            continuing {
                                phi_2055_ = type_9(select(_e1256.member, (_e1256.member + 1u), _e1261), select(_e1256.member_1, _e1256.member_1, _e1261));
                                phi_2058_ = _e1290;
                                break if !(_e1274);
                            }
                        }
                        let _e2646 = local_35;
                        phi_2127_ = _e2646;
                    } else {
                        phi_2127_ = 1u;
                    }
                    let _e1293 = phi_2127_;
                    local_2[_e1293] = _e1149;
                    let _e1295 = local_2;
                    local_5 = _e1295;
                    let _e1299 = (f64(1f) - _e524);
                    let _e1302 = local_4.member[0u];
                    let _e1305 = local_4.member[1u];
                    let _e1308 = local_4.member[2u];
                    let _e1311 = local_4.member[3u];
                    let _e1322 = ((((_e1302 * _e1299) + (_e1305 * _e524)) * (_e1299 * _e1299)) + (((_e1308 * _e1299) + (_e1311 * _e524)) * (_e524 * _e524)));
                    let _e1327 = local_4.member_1;
                    phi_2185_ = type_9(select(1u, 0u, !((select(_e1322, -(_e1322), (_e1322 < 0.0lf)) > _e1327))), (_e1293 + 1u));
                    loop {
                        let _e1334 = phi_2185_;
                        let _e1337 = (_e1334.member < _e1334.member_1);
                        let _e1348 = select(type_9().member_1, _e1334.member, _e1337);
                        if (bitcast<i32>(select(0u, 1u, _e1337)) != 0i) {
                            if (_e1348 > 0u) {
                                let _e1355 = local_5[(_e1348 - 1u)];
                                let _e1357 = select(_e524, _e1355, (_e1355 > _e524));
                                let _e1359 = local_5[_e1348];
                                let _e1361 = select(_e533, _e1359, (_e1359 < _e533));
                                if (_e1357 <= _e1361) {
                                    let _e1363 = function_2((&local_4), _e542, _e1357, _e1361);
                                    if _e1363 {
                                        phi_3505_ = type_43();
                                        phi_3506_ = u32();
                                        phi_3507_ = false;
                                        phi_3508_ = false;
                                        phi_3509_ = false;
                                    } else {
                                        let _e1365 = (f64(1f) - _e1357);
                                        let _e1368 = local_4.member[0u];
                                        let _e1371 = local_4.member[1u];
                                        let _e1374 = local_4.member[2u];
                                        let _e1377 = local_4.member[3u];
                                        let _e1388 = ((((_e1368 * _e1365) + (_e1371 * _e1357)) * (_e1365 * _e1365)) + (((_e1374 * _e1365) + (_e1377 * _e1357)) * (_e1357 * _e1357)));
                                        let _e1390 = (f64(1f) - _e1361);
                                        let _e1393 = local_4.member[0u];
                                        let _e1396 = local_4.member[1u];
                                        let _e1399 = local_4.member[2u];
                                        let _e1402 = local_4.member[3u];
                                        let _e1413 = ((((_e1393 * _e1390) + (_e1396 * _e1361)) * (_e1390 * _e1390)) + (((_e1399 * _e1390) + (_e1402 * _e1361)) * (_e1361 * _e1361)));
                                        let _e1418 = local_4.member_1;
                                        let _e1419 = (select(_e1388, -(_e1388), (_e1388 < 0.0lf)) > _e1418);
                                        let _e1424 = local_4.member_1;
                                        let _e1425 = (select(_e1413, -(_e1413), (_e1413 < 0.0lf)) > _e1424);
                                        let _e1426 = f64(0f);
                                        let _e1434 = select(select(bool(), select(bool(), ((_e1388 > _e1426) != (_e1413 > _e1426)), _e1425), _e1419), false, select(true, select(true, false, _e1425), _e1419));
                                        if _e1419 {
                                            if _e1425 {
                                                phi_2345_ = type_43(select(f64(1f), type_43().member, _e1434), select(_e1426, type_43().member_1, _e1434), select(_e1434, type_43().member_2, _e1434));
                                                phi_2346_ = _e1434;
                                            } else {
                                                phi_2345_ = type_43();
                                                phi_2346_ = true;
                                            }
                                            let _e1444 = phi_2345_;
                                            let _e1446 = phi_2346_;
                                            phi_2347_ = _e1444;
                                            phi_2348_ = _e1446;
                                        } else {
                                            phi_2347_ = type_43();
                                            phi_2348_ = true;
                                        }
                                        let _e1448 = phi_2347_;
                                        let _e1450 = phi_2348_;
                                        if _e1450 {
                                            if _e1419 {
                                                let _e1454 = select(f64(1f), f64(-1f), (_e1388 < _e1426));
                                                let _e1456 = local_4.member_3;
                                                let _e1457 = f64(0.5f);
                                                let _e1458 = f64(3f);
                                                let _e1461 = local_4.member[0u];
                                                let _e1464 = local_4.member[1u];
                                                let _e1467 = local_4.member[2u];
                                                let _e1470 = local_4.member[3u];
                                                let _e1473 = (_e1467 - _e1464);
                                                phi_2383_ = type_9(0u, 64u);
                                                phi_2386_ = _e1361;
                                                phi_2388_ = _e1357;
                                                phi_2390_ = (_e1457 * (_e1357 + _e1361));
                                                loop {
                                                    let _e1479 = phi_2383_;
                                                    let _e1481 = phi_2386_;
                                                    let _e1483 = phi_2388_;
                                                    let _e1485 = phi_2390_;
                                                    local_10 = _e1483;
                                                    let _e1488 = (_e1479.member < _e1479.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1488)) != 0i) {
                                                        let _e1501 = (f64(1f) - _e1485);
                                                        let _e1504 = local_4.member[0u];
                                                        let _e1507 = local_4.member[1u];
                                                        let _e1510 = local_4.member[2u];
                                                        let _e1513 = local_4.member[3u];
                                                        let _e1527 = local_4.member_1;
                                                        let _e1528 = ((_e1454 * ((((_e1504 * _e1501) + (_e1507 * _e1485)) * (_e1501 * _e1501)) + (((_e1510 * _e1501) + (_e1513 * _e1485)) * (_e1485 * _e1485)))) - _e1527);
                                                        let _e1530 = (_e1528 > f64(0f));
                                                        let _e1531 = select(_e1485, _e1481, _e1530);
                                                        let _e1532 = select(_e1483, _e1485, _e1530);
                                                        let _e1534 = ((_e1531 - _e1532) > _e1456);
                                                        if _e1534 {
                                                            let _e1536 = (f64(1f) - _e1485);
                                                            let _e1548 = (-(_e1528) / (_e1454 * (((((_e1464 - (_e1458 * _e1461)) * _e1536) + (_e1473 * _e1485)) * _e1536) + (((_e1473 * _e1536) + (((_e1458 * _e1470) - _e1467) * _e1485)) * _e1485))));
                                                            let _e1556 = ((_e1485 + _e1548) + select(-((_e1457 * _e1456)), (_e1457 * _e1456), (_e1528 > f64(0f))));
                                                            if (_e1556 > _e1532) {
                                                                phi_2504_ = select(true, select(true, false, (select(_e1548, -(_e1548), (_e1548 < 0.0lf)) < (_e1457 * (_e1531 - _e1532)))), (_e1556 < _e1531));
                                                            } else {
                                                                phi_2504_ = true;
                                                            }
                                                            let _e1568 = phi_2504_;
                                                            phi_2511_ = select(_e1556, (_e1457 * (_e1532 + _e1531)), _e1568);
                                                            phi_2512_ = false;
                                                        } else {
                                                            phi_2511_ = f64();
                                                            phi_2512_ = true;
                                                        }
                                                        let _e1573 = phi_2511_;
                                                        let _e1575 = phi_2512_;
                                                        phi_2387_ = _e1531;
                                                        phi_2389_ = _e1532;
                                                        phi_2391_ = _e1573;
                                                        phi_2513_ = _e1532;
                                                        phi_2514_ = _e1534;
                                                        phi_2515_ = _e1575;
                                                    } else {
                                                        phi_2387_ = f64();
                                                        phi_2389_ = f64();
                                                        phi_2391_ = f64();
                                                        phi_2513_ = f64();
                                                        phi_2514_ = false;
                                                        phi_2515_ = false;
                                                    }
                                                    let _e1577 = phi_2387_;
                                                    let _e1579 = phi_2389_;
                                                    let _e1581 = phi_2391_;
                                                    let _e1583 = phi_2513_;
                                                    let _e1585 = phi_2514_;
                                                    let _e1587 = phi_2515_;
                                                    local_8 = _e1587;
                                                    local_9 = _e1583;
                                                    continue;
                                                    continuing {
                                                        phi_2383_ = type_9(select(_e1479.member, (_e1479.member + 1u), _e1488), select(_e1479.member_1, _e1479.member_1, _e1488));
                                                        phi_2386_ = _e1577;
                                                        phi_2388_ = _e1579;
                                                        phi_2390_ = _e1581;
                                                        break if !(_e1585);
                                                    }
                                                }
                                                let _e1590 = local_8;
                                                let _e1592 = local_9;
                                                let _e1594 = local_10;
                                                phi_2520_ = select(_e1594, _e1592, _e1590);
                                            } else {
                                                phi_2520_ = _e1357;
                                            }
                                            let _e1597 = phi_2520_;
                                            if _e1425 {
                                                let _e1603 = local_4.member_3;
                                                let _e1605 = local_4.member_3;
                                                phi_2538_ = type_9(0u, 64u);
                                                phi_2541_ = (_e1603 + _e1605);
                                                loop {
                                                    let _e1608 = phi_2538_;
                                                    let _e1610 = phi_2541_;
                                                    let _e1613 = (_e1608.member < _e1608.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1613)) != 0i) {
                                                        let _e1625 = (_e1597 + _e1610);
                                                        if (_e1625 < _e1361) {
                                                            let _e1628 = (f64(1f) - _e1625);
                                                            let _e1631 = local_4.member[0u];
                                                            let _e1634 = local_4.member[1u];
                                                            let _e1637 = local_4.member[2u];
                                                            let _e1640 = local_4.member[3u];
                                                            let _e1654 = local_4.member_1;
                                                            let _e1655 = ((select(f64(1f), f64(-1f), (_e1413 < _e1426)) * ((((_e1631 * _e1628) + (_e1634 * _e1625)) * (_e1628 * _e1628)) + (((_e1637 * _e1628) + (_e1640 * _e1625)) * (_e1625 * _e1625)))) > _e1654);
                                                            phi_2607_ = select((_e1610 + _e1610), f64(), _e1655);
                                                            phi_2608_ = select(true, false, _e1655);
                                                            phi_2609_ = _e1655;
                                                            phi_2610_ = false;
                                                        } else {
                                                            phi_2607_ = f64();
                                                            phi_2608_ = false;
                                                            phi_2609_ = false;
                                                            phi_2610_ = true;
                                                        }
                                                        let _e1660 = phi_2607_;
                                                        let _e1662 = phi_2608_;
                                                        let _e1664 = phi_2609_;
                                                        let _e1666 = phi_2610_;
                                                        phi_2611_ = _e1625;
                                                        phi_2542_ = _e1660;
                                                        phi_2612_ = _e1662;
                                                        phi_2613_ = _e1664;
                                                        phi_2614_ = _e1666;
                                                        phi_2615_ = false;
                                                    } else {
                                                        phi_2611_ = f64();
                                                        phi_2542_ = f64();
                                                        phi_2612_ = false;
                                                        phi_2613_ = false;
                                                        phi_2614_ = false;
                                                        phi_2615_ = true;
                                                    }
                                                    let _e1668 = phi_2611_;
                                                    let _e1670 = phi_2542_;
                                                    let _e1672 = phi_2612_;
                                                    let _e1674 = phi_2613_;
                                                    let _e1676 = phi_2614_;
                                                    let _e1678 = phi_2615_;
                                                    local_11 = _e1674;
                                                    local_12 = _e1676;
                                                    local_13 = _e1674;
                                                    local_14 = _e1678;
                                                    local_15 = _e1668;
                                                    continue;
                                                    continuing {
                                                        phi_2538_ = type_9(select(_e1608.member, (_e1608.member + 1u), _e1613), select(_e1608.member_1, _e1608.member_1, _e1613));
                                                        phi_2541_ = _e1670;
                                                        break if !(_e1672);
                                                    }
                                                }
                                                let _e1681 = local_11;
                                                let _e1683 = local_12;
                                                let _e1686 = local_13;
                                                let _e1688 = local_14;
                                                let _e1692 = local_15;
                                                phi_2629_ = select(_e1692, _e1361, select(select(_e1688, false, _e1686), true, select(_e1683, false, _e1681)));
                                            } else {
                                                phi_2629_ = _e1361;
                                            }
                                            let _e1695 = phi_2629_;
                                            phi_2631_ = type_43(_e1597, _e1695, _e1434);
                                        } else {
                                            phi_2631_ = _e1448;
                                        }
                                        let _e1698 = phi_2631_;
                                        if (_e1698.member > _e1698.member_1) {
                                            phi_3501_ = u32();
                                            phi_3502_ = true;
                                            phi_3503_ = false;
                                            phi_3504_ = false;
                                        } else {
                                            let _e1703 = (_e1698.member > _e542);
                                            if _e1703 {
                                                phi_3498_ = u32();
                                                phi_3499_ = false;
                                                phi_3500_ = false;
                                            } else {
                                                let _e1708 = ((_e1698.member_1 - _e1698.member) * f64(0.5f));
                                                let _e1709 = (_e1698.member + _e1708);
                                                let _e1712 = (_e1708 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1719 = select(_e769.member.member[0][0], -(_e769.member.member[0][0]), (_e769.member.member[0][0] < 0.0lf));
                                                let _e1723 = select(_e769.member.member[0][1], -(_e769.member.member[0][1]), (_e769.member.member[0][1] < 0.0lf));
                                                let _e1725 = select(_e1723, _e1719, (_e1719 > _e1723));
                                                let _e1729 = select(_e769.member.member[0][2], -(_e769.member.member[0][2]), (_e769.member.member[0][2] < 0.0lf));
                                                let _e1731 = select(_e1729, _e1725, (_e1725 > _e1729));
                                                let _e1737 = select(_e769.member.member[1][0], -(_e769.member.member[1][0]), (_e769.member.member[1][0] < 0.0lf));
                                                let _e1741 = select(_e769.member.member[1][1], -(_e769.member.member[1][1]), (_e769.member.member[1][1] < 0.0lf));
                                                let _e1743 = select(_e1741, _e1737, (_e1737 > _e1741));
                                                let _e1747 = select(_e769.member.member[1][2], -(_e769.member.member[1][2]), (_e769.member.member[1][2] < 0.0lf));
                                                let _e1749 = select(_e1747, _e1743, (_e1743 > _e1747));
                                                let _e1770 = (_e769.member.member[0][0] + ((_e769.member.member[1][0] - _e769.member.member[0][0]) * _e1709));
                                                let _e1772 = (_e769.member.member[0][1] + ((_e769.member.member[1][1] - _e769.member.member[0][1]) * _e1709));
                                                let _e1774 = (_e769.member.member[0][2] + ((_e769.member.member[1][2] - _e769.member.member[0][2]) * _e1709));
                                                let _e1781 = (_e769.member.member[1][0] - _e769.member.member[0][0]);
                                                let _e1784 = (_e769.member.member[1][1] - _e769.member.member[0][1]);
                                                let _e1787 = (_e769.member.member[1][2] - _e769.member.member[0][2]);
                                                let _e1790 = select(_e1781, -(_e1781), (_e1781 < 0.0lf));
                                                let _e1793 = select(_e1784, -(_e1784), (_e1784 < 0.0lf));
                                                let _e1795 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                let _e1798 = select(_e1787, -(_e1787), (_e1787 < 0.0lf));
                                                let _e1808 = ((((_e1712 * select(_e1798, _e1795, (_e1795 > _e1798))) * f64(1.01f)) + ((select(_e1749, _e1731, (_e1731 > _e1749)) + _e769.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e769.member.member_3);
                                                let _e1811 = select(_e1770, -(_e1770), (_e1770 < 0.0lf));
                                                let _e1814 = select(_e1772, -(_e1772), (_e1772 < 0.0lf));
                                                let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                let _e1819 = select(_e1774, -(_e1774), (_e1774 < 0.0lf));
                                                let _e1822 = (select(_e1819, _e1816, (_e1816 > _e1819)) + _e1808);
                                                let _e1829 = select(_e769.member.member_1[0][0], -(_e769.member.member_1[0][0]), (_e769.member.member_1[0][0] < 0.0lf));
                                                let _e1833 = select(_e769.member.member_1[0][1], -(_e769.member.member_1[0][1]), (_e769.member.member_1[0][1] < 0.0lf));
                                                let _e1835 = select(_e1833, _e1829, (_e1829 > _e1833));
                                                let _e1839 = select(_e769.member.member_1[0][2], -(_e769.member.member_1[0][2]), (_e769.member.member_1[0][2] < 0.0lf));
                                                let _e1841 = select(_e1839, _e1835, (_e1835 > _e1839));
                                                let _e1847 = select(_e769.member.member_1[1][0], -(_e769.member.member_1[1][0]), (_e769.member.member_1[1][0] < 0.0lf));
                                                let _e1851 = select(_e769.member.member_1[1][1], -(_e769.member.member_1[1][1]), (_e769.member.member_1[1][1] < 0.0lf));
                                                let _e1853 = select(_e1851, _e1847, (_e1847 > _e1851));
                                                let _e1857 = select(_e769.member.member_1[1][2], -(_e769.member.member_1[1][2]), (_e769.member.member_1[1][2] < 0.0lf));
                                                let _e1859 = select(_e1857, _e1853, (_e1853 > _e1857));
                                                let _e1880 = (_e769.member.member_1[0][0] + ((_e769.member.member_1[1][0] - _e769.member.member_1[0][0]) * _e1709));
                                                let _e1882 = (_e769.member.member_1[0][1] + ((_e769.member.member_1[1][1] - _e769.member.member_1[0][1]) * _e1709));
                                                let _e1884 = (_e769.member.member_1[0][2] + ((_e769.member.member_1[1][2] - _e769.member.member_1[0][2]) * _e1709));
                                                let _e1891 = (_e769.member.member_1[1][0] - _e769.member.member_1[0][0]);
                                                let _e1894 = (_e769.member.member_1[1][1] - _e769.member.member_1[0][1]);
                                                let _e1897 = (_e769.member.member_1[1][2] - _e769.member.member_1[0][2]);
                                                let _e1900 = select(_e1891, -(_e1891), (_e1891 < 0.0lf));
                                                let _e1903 = select(_e1894, -(_e1894), (_e1894 < 0.0lf));
                                                let _e1905 = select(_e1903, _e1900, (_e1900 > _e1903));
                                                let _e1908 = select(_e1897, -(_e1897), (_e1897 < 0.0lf));
                                                let _e1918 = ((((_e1712 * select(_e1908, _e1905, (_e1905 > _e1908))) * f64(1.01f)) + ((select(_e1859, _e1841, (_e1841 > _e1859)) + _e769.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e769.member.member_3);
                                                let _e1921 = select(_e1880, -(_e1880), (_e1880 < 0.0lf));
                                                let _e1924 = select(_e1882, -(_e1882), (_e1882 < 0.0lf));
                                                let _e1926 = select(_e1924, _e1921, (_e1921 > _e1924));
                                                let _e1929 = select(_e1884, -(_e1884), (_e1884 < 0.0lf));
                                                let _e1932 = (select(_e1929, _e1926, (_e1926 > _e1929)) + _e1918);
                                                let _e1939 = select(_e769.member.member_2[0][0], -(_e769.member.member_2[0][0]), (_e769.member.member_2[0][0] < 0.0lf));
                                                let _e1943 = select(_e769.member.member_2[0][1], -(_e769.member.member_2[0][1]), (_e769.member.member_2[0][1] < 0.0lf));
                                                let _e1945 = select(_e1943, _e1939, (_e1939 > _e1943));
                                                let _e1949 = select(_e769.member.member_2[0][2], -(_e769.member.member_2[0][2]), (_e769.member.member_2[0][2] < 0.0lf));
                                                let _e1951 = select(_e1949, _e1945, (_e1945 > _e1949));
                                                let _e1957 = select(_e769.member.member_2[1][0], -(_e769.member.member_2[1][0]), (_e769.member.member_2[1][0] < 0.0lf));
                                                let _e1961 = select(_e769.member.member_2[1][1], -(_e769.member.member_2[1][1]), (_e769.member.member_2[1][1] < 0.0lf));
                                                let _e1963 = select(_e1961, _e1957, (_e1957 > _e1961));
                                                let _e1967 = select(_e769.member.member_2[1][2], -(_e769.member.member_2[1][2]), (_e769.member.member_2[1][2] < 0.0lf));
                                                let _e1969 = select(_e1967, _e1963, (_e1963 > _e1967));
                                                let _e1990 = (_e769.member.member_2[0][0] + ((_e769.member.member_2[1][0] - _e769.member.member_2[0][0]) * _e1709));
                                                let _e1992 = (_e769.member.member_2[0][1] + ((_e769.member.member_2[1][1] - _e769.member.member_2[0][1]) * _e1709));
                                                let _e1994 = (_e769.member.member_2[0][2] + ((_e769.member.member_2[1][2] - _e769.member.member_2[0][2]) * _e1709));
                                                let _e2001 = (_e769.member.member_2[1][0] - _e769.member.member_2[0][0]);
                                                let _e2004 = (_e769.member.member_2[1][1] - _e769.member.member_2[0][1]);
                                                let _e2007 = (_e769.member.member_2[1][2] - _e769.member.member_2[0][2]);
                                                let _e2010 = select(_e2001, -(_e2001), (_e2001 < 0.0lf));
                                                let _e2013 = select(_e2004, -(_e2004), (_e2004 < 0.0lf));
                                                let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                let _e2018 = select(_e2007, -(_e2007), (_e2007 < 0.0lf));
                                                let _e2028 = ((((_e1712 * select(_e2018, _e2015, (_e2015 > _e2018))) * f64(1.01f)) + ((select(_e1969, _e1951, (_e1951 > _e1969)) + _e769.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e769.member.member_3);
                                                let _e2031 = select(_e1990, -(_e1990), (_e1990 < 0.0lf));
                                                let _e2034 = select(_e1992, -(_e1992), (_e1992 < 0.0lf));
                                                let _e2036 = select(_e2034, _e2031, (_e2031 > _e2034));
                                                let _e2039 = select(_e1994, -(_e1994), (_e1994 < 0.0lf));
                                                let _e2042 = (select(_e2039, _e2036, (_e2036 > _e2039)) + _e2028);
                                                let _e2045 = ((_e1882 * _e1994) - (_e1884 * _e1992));
                                                let _e2048 = ((_e1884 * _e1990) - (_e1880 * _e1994));
                                                let _e2051 = ((_e1880 * _e1992) - (_e1882 * _e1990));
                                                let _e2066 = select(false, (select(_e2045, -(_e2045), (_e2045 < 0.0lf)) > select(_e2051, -(_e2051), (_e2051 < 0.0lf))), (select(_e2045, -(_e2045), (_e2045 < 0.0lf)) > select(_e2048, -(_e2048), (_e2048 < 0.0lf))));
                                                let _e2081 = select((select(_e2048, -(_e2048), (_e2048 < 0.0lf)) > select(_e2051, -(_e2051), (_e2051 < 0.0lf))), false, (select(_e2045, -(_e2045), (_e2045 < 0.0lf)) > select(_e2048, -(_e2048), (_e2048 < 0.0lf))));
                                                let _e2084 = select(select(_e1770, _e1772, _e2066), _e1774, _e2081);
                                                let _e2085 = select(select(_e1772, _e1774, _e2066), _e1770, _e2081);
                                                let _e2088 = select(select(_e1880, _e1882, _e2066), _e1884, _e2081);
                                                let _e2089 = select(select(_e1882, _e1884, _e2066), _e1880, _e2081);
                                                let _e2092 = select(select(_e1990, _e1992, _e2066), _e1994, _e2081);
                                                let _e2093 = select(select(_e1992, _e1994, _e2066), _e1990, _e2081);
                                                let _e2096 = ((_e2088 * _e2093) - (_e2089 * _e2092));
                                                let _e2097 = f64(1f);
                                                let _e2098 = f64(2f);
                                                let _e2116 = (((((_e1918 * _e2042) + (_e1932 * _e2028)) * f64(2.01f)) + (((_e1932 * _e2098) * (_e2042 * _e2098)) * (1.1102230246251565e-16lf * _e2098))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2097 + _e1932) * (_e2097 + _e2042))));
                                                if (select(_e2096, -(_e2096), (_e2096 < 0.0lf)) > _e2116) {
                                                    let _e2125 = select(f64(1f), f64(-1f), (_e2096 < f64(0f)));
                                                    let _e2129 = f64(1f);
                                                    let _e2130 = f64(2f);
                                                    let _e2148 = (((((_e1808 * _e2042) + (_e1822 * _e2028)) * f64(2.01f)) + (((_e1822 * _e2130) * (_e2042 * _e2130)) * (1.1102230246251565e-16lf * _e2130))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2129 + _e1822) * (_e2129 + _e2042))));
                                                    let _e2152 = f64(1f);
                                                    let _e2153 = f64(2f);
                                                    let _e2171 = (((((_e1918 * _e1822) + (_e1932 * _e1808)) * f64(2.01f)) + (((_e1932 * _e2153) * (_e1822 * _e2153)) * (1.1102230246251565e-16lf * _e2153))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2152 + _e1932) * (_e2152 + _e1822))));
                                                    let _e2172 = (_e2096 * _e2125);
                                                    let _e2173 = (((_e2084 * _e2093) - (_e2085 * _e2092)) * _e2125);
                                                    let _e2174 = (((_e2088 * _e2085) - (_e2089 * _e2084)) * _e2125);
                                                    let _e2188 = (((select(_e2172, -(_e2172), (_e2172 < 0.0lf)) + select(_e2173, -(_e2173), (_e2173 < 0.0lf))) + select(_e2174, -(_e2174), (_e2174 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e221.member != 0u) {
                                                        phi_3396_ = array<type_35, 4>(type_35(_e2173, _e2148), type_35(_e2174, _e2171), type_35((_e2172 - _e2173), ((_e2116 + _e2148) + _e2188)), type_35((_e2172 - _e2174), ((_e2116 + _e2171) + _e2188)));
                                                    } else {
                                                        let _e2191 = ((_e2172 - _e2173) - _e2174);
                                                        let _e2194 = (((_e2116 + _e2148) + _e2171) + _e2188);
                                                        phi_3396_ = array<type_35, 4>(type_35(_e2173, _e2148), type_35(_e2174, _e2171), type_35(_e2191, _e2194), type_35(_e2191, _e2194));
                                                    }
                                                    let _e2212 = phi_3396_;
                                                    local_1 = array<type_35, 4>(type_35(_e2212[0].member, _e2212[0].member_1), type_35(_e2212[1].member, _e2212[1].member_1), type_35(_e2212[2].member, _e2212[2].member_1), type_35(_e2212[3].member, _e2212[3].member_1));
                                                    phi_3416_ = type_9(0u, 4u);
                                                    phi_3419_ = true;
                                                    loop {
                                                        let _e2231 = phi_3416_;
                                                        let _e2233 = phi_3419_;
                                                        local_17 = _e2233;
                                                        let _e2236 = (_e2231.member < _e2231.member_1);
                                                        let _e2247 = select(type_9().member_1, _e2231.member, _e2236);
                                                        if (bitcast<i32>(select(0u, 1u, _e2236)) != 0i) {
                                                            let _e2252 = local_1[_e2247].member;
                                                            let _e2255 = local_1[_e2247].member_1;
                                                            let _e2257 = (_e2252 < -(_e2255));
                                                            phi_3420_ = select((_e2233 && (_e2252 > _e2255)), bool(), _e2257);
                                                            phi_3471_ = select(true, false, _e2257);
                                                            phi_3472_ = _e2257;
                                                        } else {
                                                            phi_3420_ = bool();
                                                            phi_3471_ = false;
                                                            phi_3472_ = false;
                                                        }
                                                        let _e2263 = phi_3420_;
                                                        let _e2265 = phi_3471_;
                                                        let _e2267 = phi_3472_;
                                                        local_16 = _e2267;
                                                        continue;
                                                        continuing {
                                                            phi_3416_ = type_9(select(_e2231.member, (_e2231.member + 1u), _e2236), select(_e2231.member_1, _e2231.member_1, _e2236));
                                                            phi_3419_ = _e2263;
                                                            break if !(_e2265);
                                                        }
                                                    }
                                                    let _e2270 = local_16;
                                                    let _e2271 = select(true, false, _e2270);
                                                    let _e2273 = local_17;
                                                    phi_3486_ = select(u32(), select(2u, 1u, _e2273), _e2271);
                                                    phi_3487_ = 0u;
                                                    phi_3488_ = select(true, false, _e2271);
                                                } else {
                                                    phi_3486_ = u32();
                                                    phi_3487_ = 2u;
                                                    phi_3488_ = true;
                                                }
                                                let _e2278 = phi_3486_;
                                                let _e2280 = phi_3487_;
                                                let _e2282 = phi_3488_;
                                                let _e2283 = select(_e2278, _e2280, _e2282);
                                                let _e2284 = (_e2283 == 0u);
                                                phi_3498_ = _e2283;
                                                phi_3499_ = _e2284;
                                                phi_3500_ = select(true, false, _e2284);
                                            }
                                            let _e2287 = phi_3498_;
                                            let _e2289 = phi_3499_;
                                            let _e2291 = phi_3500_;
                                            phi_3501_ = _e2287;
                                            phi_3502_ = _e2289;
                                            phi_3503_ = _e1703;
                                            phi_3504_ = _e2291;
                                        }
                                        let _e2293 = phi_3501_;
                                        let _e2295 = phi_3502_;
                                        let _e2297 = phi_3503_;
                                        let _e2299 = phi_3504_;
                                        phi_3505_ = _e1698;
                                        phi_3506_ = _e2293;
                                        phi_3507_ = _e2295;
                                        phi_3508_ = _e2297;
                                        phi_3509_ = _e2299;
                                    }
                                    let _e2301 = phi_3505_;
                                    let _e2303 = phi_3506_;
                                    let _e2305 = phi_3507_;
                                    let _e2307 = phi_3508_;
                                    let _e2309 = phi_3509_;
                                    phi_3510_ = _e2301;
                                    phi_3511_ = _e2303;
                                    phi_3512_ = _e2305;
                                    phi_3513_ = _e1363;
                                    phi_3514_ = _e2307;
                                    phi_3515_ = _e2309;
                                } else {
                                    phi_3510_ = type_43();
                                    phi_3511_ = u32();
                                    phi_3512_ = true;
                                    phi_3513_ = false;
                                    phi_3514_ = false;
                                    phi_3515_ = false;
                                }
                                let _e2311 = phi_3510_;
                                let _e2313 = phi_3511_;
                                let _e2315 = phi_3512_;
                                let _e2317 = phi_3513_;
                                let _e2319 = phi_3514_;
                                let _e2321 = phi_3515_;
                                phi_3522_ = _e2311;
                                phi_3523_ = _e2313;
                                phi_3524_ = _e2315;
                                phi_3525_ = select(_e2317, false, _e2315);
                                phi_3526_ = select(_e2319, false, _e2315);
                                phi_3527_ = select(_e2321, false, _e2315);
                                phi_3528_ = false;
                            } else {
                                phi_3522_ = type_43();
                                phi_3523_ = u32();
                                phi_3524_ = false;
                                phi_3525_ = false;
                                phi_3526_ = false;
                                phi_3527_ = false;
                                phi_3528_ = true;
                            }
                            let _e2326 = phi_3522_;
                            let _e2328 = phi_3523_;
                            let _e2330 = phi_3524_;
                            let _e2332 = phi_3525_;
                            let _e2334 = phi_3526_;
                            let _e2336 = phi_3527_;
                            let _e2338 = phi_3528_;
                            phi_3529_ = _e2326;
                            phi_3530_ = _e2328;
                            phi_3531_ = type_43(_e524, _e524, false);
                            phi_3532_ = _e2330;
                            phi_3533_ = false;
                            phi_3534_ = _e2332;
                            phi_3535_ = _e2334;
                            phi_3536_ = _e2336;
                            phi_3537_ = _e2338;
                        } else {
                            phi_3529_ = type_43();
                            phi_3530_ = u32();
                            phi_3531_ = type_43();
                            phi_3532_ = false;
                            phi_3533_ = true;
                            phi_3534_ = false;
                            phi_3535_ = false;
                            phi_3536_ = false;
                            phi_3537_ = false;
                        }
                        let _e2340 = phi_3529_;
                        let _e2342 = phi_3530_;
                        let _e2344 = phi_3531_;
                        let _e2346 = phi_3532_;
                        let _e2348 = phi_3533_;
                        let _e2350 = phi_3534_;
                        let _e2352 = phi_3535_;
                        let _e2354 = phi_3536_;
                        let _e2356 = phi_3537_;
                        local_18 = _e2348;
                        local_19 = _e2348;
                        local_20 = _e2348;
                        local_21 = _e2350;
                        local_22 = _e2348;
                        local_23 = _e2352;
                        local_24 = _e2348;
                        local_25 = _e2354;
                        local_26 = _e2348;
                        local_27 = _e2356;
                        local_28 = _e2342;
                        local_29 = _e2340;
                        local_30 = _e2340;
                        local_31 = _e2340;
                        local_32 = _e2340;
                        local_33 = _e2344;
                        local_34 = _e2340;
                        continue;
                        continuing {
                            phi_2185_ = type_9(select(_e1334.member, (_e1334.member + 1u), _e1337), select(_e1334.member_1, _e1334.member_1, _e1337));
                            break if !(_e2346);
                        }
                    }
                    let _e2360 = local_18;
                    let _e2365 = local_19;
                    let _e2369 = local_20;
                    let _e2371 = local_21;
                    let _e2372 = select(_e2371, false, _e2369);
                    let _e2374 = local_22;
                    let _e2376 = local_23;
                    let _e2379 = local_24;
                    let _e2381 = local_25;
                    let _e2384 = local_26;
                    let _e2386 = local_27;
                    let _e2393 = select(select(_e2376, false, _e2374), false, _e2372);
                    if select(select(select(_e2381, false, _e2379), false, _e2372), false, _e2393) {
                        let _e2404 = local_28;
                        let _e2407 = local_29;
                        if select(false, _e2407.member_2, (_e2404 == 1u)) {
                            let _e2411 = local_30;
                            let _e2414 = local_31;
                            let _e2417 = ((_e2411.member_1 - _e2414.member) <= (_e515 * f64(0.99f)));
                            let _e2419 = local_32;
                            phi_3586_ = type_42(select(type_42().member, 1u, _e2417), select(type_42().member_1, _e2419.member, _e2417));
                            phi_3587_ = select(true, false, _e2417);
                        } else {
                            phi_3586_ = type_42();
                            phi_3587_ = true;
                        }
                        let _e2428 = phi_3586_;
                        let _e2430 = phi_3587_;
                        phi_3592_ = _e2428;
                        phi_3593_ = select(true, false, _e2430);
                        phi_3594_ = false;
                        phi_3595_ = _e2430;
                    } else {
                        phi_3592_ = type_42(select(select(type_42().member, 0u, _e2372), 0u, _e2393), select(select(type_42().member_1, type_42().member_1, _e2372), type_42().member_1, _e2393));
                        phi_3593_ = select(_e2372, true, _e2393);
                        phi_3594_ = select(select(select(_e2386, false, _e2384), false, _e2372), false, _e2393);
                        phi_3595_ = false;
                    }
                    let _e2433 = phi_3592_;
                    let _e2435 = phi_3593_;
                    let _e2437 = phi_3594_;
                    let _e2439 = phi_3595_;
                    let _e2440 = select(_e2437, false, _e2435);
                    let _e2443 = local_33;
                    let _e2446 = local_34;
                    let _e2449 = select(select(_e2439, false, _e2435), true, _e2440);
                    phi_3617_ = type_42(select(_e2433.member, 2u, _e2449), select(_e2433.member_1, select(_e2446.member, _e2443.member, _e2440), _e2449));
                    phi_3618_ = type_42(select(type_42().member, 0u, _e2360), select(type_42().member_1, type_42().member_1, _e2365));
                    phi_3619_ = select(select(_e2435, false, _e2440), true, _e2449);
                }
                let _e2460 = phi_3617_;
                let _e2462 = phi_3618_;
                let _e2464 = phi_3619_;
                let _e2467 = select(_e2462.member, _e2460.member, _e2464);
                let _e2470 = select(_e2462.member_1, _e2460.member_1, _e2464);
                let _e2476 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e2470 > _e524)), (_e2467 == 1u))));
                switch bitcast<i32>(_e2467) {
                    case 0: {
                        phi_3663_ = type_34(0u, _e2476, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e2480 = function_1(_e2470);
                        phi_3663_ = type_34(0u, _e2476, _e2480, true);
                        break;
                    }
                    case 2: {
                        let _e2478 = function_1(_e2470);
                        phi_3663_ = type_34(1u, _e2476, _e2478, true);
                        break;
                    }
                    default: {
                        phi_3663_ = type_34();
                        break;
                    }
                }
                let _e2484 = phi_3663_;
                local_6 = type_34(_e2484.member, _e2484.member_1, array<u32, 2>(_e2484.member_2[0], _e2484.member_2[1]), _e2484.member_3);
                phi_3672_ = type_9(_e179, _e182);
            } else {
                phi_3672_ = type_9(0u, 0u);
            }
            let _e2494 = phi_3672_;
            let _e2500 = params.member.member_2.member;
            let _e2503 = local_6.member;
            let _e2504 = (_e2503 == 0u);
            let _e2507 = select(select((_e2500 > 0u), bool(), _e2504), false, _e2504);
            if _e2507 {
                local = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e2508 = local_6;
                local = _e2508;
            }
            let _e2510 = local.member;
            let _e2512 = select(true, false, (_e2510 == 0u));
            let _e2514 = local.member_3;
            if _e2514 {
                if _e2512 {
                    phi_3729_ = true;
                } else {
                    let _e2516 = params.member.member.member_1;
                    phi_3729_ = ((_e2516 & 16u) != 0u);
                }
                let _e2520 = phi_3729_;
                phi_3730_ = _e2520;
            } else {
                phi_3730_ = false;
            }
            let _e2522 = phi_3730_;
            let _e2524 = local.member_3;
            if _e2524 {
                if _e2512 {
                } else {
                    let _e2526 = local.member_2;
                    let _e2530 = (_e2526[1] >> bitcast<u32>(20i));
                    let _e2544 = atomicMin((&earliest.member[0u]), select(((((_e2530 - 896u) << bitcast<u32>(23i)) | ((_e2526[1] & 1048575u) << bitcast<u32>(3i))) | (_e2526[0] >> bitcast<u32>(29i))), 0u, (_e2530 <= 896u)));
                }
            }
            if (_e96 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2522 {
                let _e2548 = atomicAdd((&counters[0u]), 1u);
                phi_3773_ = _e2548;
            } else {
                phi_3773_ = 0u;
            }
            let _e2550 = phi_3773_;
            workgroupBarrier();
            if (_e96 == 0u) {
                let _e2553 = atomicLoad((&counters[0u]));
                if (_e2553 > 0u) {
                    let _e2556 = atomicAdd((&contacts.member[0u]), _e2553);
                    atomicStore((&counters[1u]), _e2556);
                }
            }
            workgroupBarrier();
            let _e2559 = atomicLoad((&counters[1u]));
            let _e2560 = (_e2559 + _e2550);
            if _e2522 {
                let _e2562 = params.member.member_1.member_3;
                if (_e2560 < _e2562) {
                    let _e2568 = (7u * _e2560);
                    atomicStore((&contacts.member[(4u + _e2568)]), select(1u, 0u, ((_e2494.member_1 & 2147483648u) == 0u)));
                    let _e2573 = local.member;
                    atomicStore((&contacts.member[(_e2568 + 5u)]), _e2573);
                    atomicStore((&contacts.member[(_e2568 + 6u)]), _e2494.member);
                    atomicStore((&contacts.member[(_e2568 + 7u)]), (_e2494.member_1 & 2147483647u));
                    let _e2582 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e2568 + 8u)]), _e2582);
                    let _e2587 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e2568 + 9u)]), _e2587);
                    let _e2591 = local.member_1;
                    atomicStore((&contacts.member[(_e2568 + 10u)]), _e2591);
                }
            }
            workgroupBarrier();
            if (_e96 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2507 {
                let _e2596 = atomicAdd((&counters[0u]), 1u);
                phi_3855_ = _e2596;
            } else {
                phi_3855_ = 0u;
            }
            let _e2598 = phi_3855_;
            workgroupBarrier();
            if (_e96 == 0u) {
                let _e2601 = atomicLoad((&counters[0u]));
                if (_e2601 > 0u) {
                    let _e2604 = atomicAdd((&left.member[0u]), _e2601);
                    atomicStore((&counters[1u]), _e2604);
                }
            }
            workgroupBarrier();
            let _e2607 = atomicLoad((&counters[1u]));
            let _e2608 = (_e2607 + _e2598);
            if _e2507 {
                if (_e2608 < _e2500) {
                    let _e2610 = (2u * _e2608);
                    atomicStore((&left.member[(4u + _e2610)]), _e2494.member);
                    atomicStore((&left.member[(_e2610 + 5u)]), _e2494.member_1);
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
