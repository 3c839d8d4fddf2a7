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
    var phi_229_: f64;
    var phi_272_: f64;
    var phi_315_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_229_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_229_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_229_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_272_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_272_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_272_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_315_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_315_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_315_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: ptr<function, type_39>, param_3: f64, param_4: f64, param_5: f64) -> bool {
    var phi_4025_: bool;
    var phi_4026_: bool;
    var phi_4031_: bool;

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
            phi_4025_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_4026_ = select(true, false, _e87);
        } else {
            phi_4025_ = bool();
            phi_4026_ = true;
        }
        let _e96 = phi_4025_;
        let _e98 = phi_4026_;
        phi_4031_ = select(_e96, false, _e98);
    } else {
        phi_4031_ = false;
    }
    let _e101 = phi_4031_;
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
    var phi_375_: u32;
    var phi_420_: u32;
    var phi_423_: type_9;
    var phi_597_: type_23;
    var phi_793_: type_31;
    var phi_954_: type_33;
    var phi_1227_: bool;
    var phi_1323_: type_41;
    var phi_1324_: bool;
    var phi_1325_: type_41;
    var phi_1326_: bool;
    var phi_1327_: type_41;
    var phi_1328_: bool;
    var phi_1333_: type_41;
    var phi_1918_: bool;
    var phi_1933_: f64;
    var phi_2009_: type_16;
    var phi_2012_: f64;
    var phi_2010_: type_16;
    var phi_2053_: type_17;
    var phi_2013_: f64;
    var local_7: f64;
    var phi_2066_: f64;
    var phi_2097_: type_9;
    var phi_2100_: u32;
    var phi_2167_: u32;
    var phi_2168_: u32;
    var phi_2101_: u32;
    var phi_2169_: u32;
    var phi_2227_: type_9;
    var phi_2387_: type_43;
    var phi_2388_: bool;
    var phi_2389_: type_43;
    var phi_2390_: bool;
    var phi_2425_: type_9;
    var phi_2428_: f64;
    var phi_2430_: f64;
    var phi_2432_: f64;
    var phi_2546_: bool;
    var phi_2553_: f64;
    var phi_2554_: bool;
    var phi_2429_: f64;
    var phi_2431_: f64;
    var phi_2433_: f64;
    var phi_2555_: f64;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var local_8: bool;
    var local_9: f64;
    var local_10: f64;
    var phi_2562_: f64;
    var phi_2580_: type_9;
    var phi_2583_: f64;
    var phi_2649_: f64;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: f64;
    var phi_2584_: f64;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: f64;
    var phi_2671_: f64;
    var phi_2673_: type_43;
    var phi_3438_: array<type_35, 4>;
    var phi_3458_: type_9;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3513_: bool;
    var phi_3514_: bool;
    var local_16: bool;
    var local_17: bool;
    var phi_3528_: u32;
    var phi_3529_: u32;
    var phi_3530_: bool;
    var phi_3540_: u32;
    var phi_3541_: bool;
    var phi_3542_: bool;
    var phi_3543_: u32;
    var phi_3544_: bool;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var phi_3547_: type_43;
    var phi_3548_: u32;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3551_: bool;
    var phi_3552_: type_43;
    var phi_3553_: u32;
    var phi_3554_: bool;
    var phi_3555_: bool;
    var phi_3556_: bool;
    var phi_3557_: bool;
    var phi_3564_: type_43;
    var phi_3565_: u32;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var phi_3570_: bool;
    var phi_3571_: type_43;
    var phi_3572_: u32;
    var phi_3573_: type_43;
    var phi_3574_: bool;
    var phi_3575_: bool;
    var phi_3576_: bool;
    var phi_3577_: bool;
    var phi_3578_: bool;
    var phi_3579_: bool;
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
    var phi_3628_: type_42;
    var phi_3629_: bool;
    var phi_3634_: type_42;
    var phi_3635_: bool;
    var phi_3636_: bool;
    var phi_3637_: bool;
    var local_33: type_43;
    var local_34: type_43;
    var phi_3659_: type_42;
    var phi_3660_: type_42;
    var phi_3661_: bool;
    var phi_3705_: type_34;
    var phi_3714_: type_9;
    var phi_3771_: bool;
    var phi_3772_: bool;
    var phi_3815_: u32;
    var phi_3897_: u32;
    var local_35: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e96 = id_2;
    let _e97 = n_2;
    let _e98 = lane_2;
    let _e111 = ((_e96.y * _e97.x) + _e96.x);
    let _e114 = (_e97.x * _e97.y);
    let _e117 = params.member.member_1.member_2;
    let _e119 = input.member[0u];
    let _e121 = select(_e119, _e117, (_e117 < _e119));
    let _e123 = params.member.member_1.member_1;
    if (_e121 > _e123) {
        let _e126 = params.member.member_1.member_1;
        phi_375_ = (_e121 - _e126);
    } else {
        phi_375_ = 0u;
    }
    let _e129 = phi_375_;
    let _e131 = params.member.member_1.member;
    let _e133 = select(_e129, _e131, (_e131 < _e129));
    let _e134 = (_e133 / 64u);
    let _e138 = select(_e134, (_e134 + 1u), ((_e133 % 64u) > 0u));
    if (_e138 > _e111) {
        let _e140 = (_e138 - _e111);
        if (_e114 == 0u) {
            return;
        }
        let _e142 = (_e140 / _e114);
        if (_e114 == 0u) {
            return;
        }
        phi_420_ = select(_e142, (_e142 + 1u), ((_e140 % _e114) > 0u));
    } else {
        phi_420_ = 0u;
    }
    let _e149 = phi_420_;
    phi_423_ = type_9(0u, _e149);
    loop {
        let _e152 = phi_423_;
        let _e155 = (_e152.member < _e152.member_1);
        let _e168 = (bitcast<i32>(select(0u, 1u, _e155)) != 0i);
        if _e168 {
            let _e172 = (((_e111 + (select(type_9().member_1, _e152.member, _e155) * _e114)) * 64u) + _e98);
            local_6 = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e172 < _e133) {
                let _e176 = params.member.member_1.member_1;
                let _e178 = (2u * (_e176 + _e172));
                let _e181 = input.member[(4u + _e178)];
                let _e184 = input.member[(_e178 + 5u)];
                let _e189 = (_e184 & 2147483647u);
                if (select(1u, 0u, ((_e184 & 2147483648u) == 0u)) == 0u) {
                    let _e208 = params.member.member.member[1u];
                    let _e211 = ((2u * _e208) + (3u * _e189));
                    let _e213 = elements.member[_e211];
                    let _e216 = elements.member[(_e211 + 1u)];
                    let _e219 = elements.member[(_e211 + 2u)];
                    phi_597_ = type_23(0u, array<u32, 4>(_e181, _e213, _e216, _e219));
                } else {
                    let _e192 = (2u * _e181);
                    let _e194 = elements.member[_e192];
                    let _e197 = elements.member[(_e192 + 1u)];
                    let _e198 = (2u * _e189);
                    let _e200 = elements.member[_e198];
                    let _e203 = elements.member[(_e198 + 1u)];
                    phi_597_ = type_23(1u, array<u32, 4>(_e194, _e197, _e200, _e203));
                }
                let _e223 = phi_597_;
                let _e227 = params.member.member.member_1;
                if ((_e227 & 8u) != 0u) {
                    let _e271 = paths.member[_e223.member_1[0]];
                    let _e286 = paths.member[_e223.member_1[1]];
                    let _e301 = paths.member[_e223.member_1[2]];
                    let _e316 = paths.member[_e223.member_1[3]];
                    let _e337 = function_(array<f32, 3>(_e271.member.x, _e271.member.y, _e271.member.z));
                    let _e338 = function_(array<f32, 3>(_e286.member.x, _e286.member.y, _e286.member.z));
                    let _e339 = function_(array<f32, 3>(_e301.member.x, _e301.member.y, _e301.member.z));
                    let _e340 = function_(array<f32, 3>(_e316.member.x, _e316.member.y, _e316.member.z));
                    let _e342 = function_(array<f32, 3>(_e271.member_1.x, _e271.member_1.y, _e271.member_1.z));
                    let _e343 = function_(array<f32, 3>(_e286.member_1.x, _e286.member_1.y, _e286.member_1.z));
                    let _e344 = function_(array<f32, 3>(_e301.member_1.x, _e301.member_1.y, _e301.member_1.z));
                    let _e345 = function_(array<f32, 3>(_e316.member_1.x, _e316.member_1.y, _e316.member_1.z));
                    phi_793_ = type_31(array<array<f64, 3>, 4>(_e337, _e338, _e339, _e340), array<array<f64, 3>, 4>(_e342, _e343, _e344, _e345));
                } else {
                    let _e232 = positions.member[_e223.member_1[0]];
                    let _e235 = params.member.member.member[0u];
                    let _e238 = positions.member[(_e235 + _e223.member_1[0])];
                    let _e241 = positions.member[_e223.member_1[1]];
                    let _e244 = params.member.member.member[0u];
                    let _e247 = positions.member[(_e244 + _e223.member_1[1])];
                    let _e250 = positions.member[_e223.member_1[2]];
                    let _e253 = params.member.member.member[0u];
                    let _e256 = positions.member[(_e253 + _e223.member_1[2])];
                    let _e259 = positions.member[_e223.member_1[3]];
                    let _e262 = params.member.member.member[0u];
                    let _e265 = positions.member[(_e262 + _e223.member_1[3])];
                    phi_793_ = type_31(array<array<f64, 3>, 4>(_e232, _e241, _e250, _e259), array<array<f64, 3>, 4>(_e238, _e247, _e256, _e265));
                }
                let _e349 = phi_793_;
                if (_e223.member != 0u) {
                    phi_954_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[0][0]), (_e349.member[2][1] - _e349.member[0][1]), (_e349.member[2][2] - _e349.member[0][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[0][0]), (_e349.member_1[2][1] - _e349.member_1[0][1]), (_e349.member_1[2][2] - _e349.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[1][0] - _e349.member[0][0]), (_e349.member[1][1] - _e349.member[0][1]), (_e349.member[1][2] - _e349.member[0][2])), array<f64, 3>((_e349.member_1[1][0] - _e349.member_1[0][0]), (_e349.member_1[1][1] - _e349.member_1[0][1]), (_e349.member_1[1][2] - _e349.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[3][0]), (_e349.member[2][1] - _e349.member[3][1]), (_e349.member[2][2] - _e349.member[3][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[3][0]), (_e349.member_1[2][1] - _e349.member_1[3][1]), (_e349.member_1[2][2] - _e349.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_954_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[0][0] - _e349.member[1][0]), (_e349.member[0][1] - _e349.member[1][1]), (_e349.member[0][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[0][0] - _e349.member_1[1][0]), (_e349.member_1[0][1] - _e349.member_1[1][1]), (_e349.member_1[0][2] - _e349.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[1][0]), (_e349.member[2][1] - _e349.member[1][1]), (_e349.member[2][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[1][0]), (_e349.member_1[2][1] - _e349.member_1[1][1]), (_e349.member_1[2][2] - _e349.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[3][0] - _e349.member[1][0]), (_e349.member[3][1] - _e349.member[1][1]), (_e349.member[3][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[3][0] - _e349.member_1[1][0]), (_e349.member_1[3][1] - _e349.member_1[1][1]), (_e349.member_1[3][2] - _e349.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e508 = phi_954_;
                let _e510 = params.member.member.member_14;
                let _e517 = bitcast<f64>(((u64(_e510[1]) * 4294967296lu) + u64(_e510[0])));
                let _e519 = params.member.member.member_15;
                let _e526 = bitcast<f64>(((u64(_e519[1]) * 4294967296lu) + u64(_e519[0])));
                let _e528 = params.member.member.member_16;
                let _e535 = bitcast<f64>(((u64(_e528[1]) * 4294967296lu) + u64(_e528[0])));
                let _e537 = params.member.member.member_16;
                let _e544 = bitcast<f64>(((u64(_e537[1]) * 4294967296lu) + u64(_e537[0])));
                let _e545 = f64(0f);
                let _e551 = select(_e508.member[0][0], -(_e508.member[0][0]), (_e508.member[0][0] < 0.0lf));
                let _e555 = select(_e508.member[0][1], -(_e508.member[0][1]), (_e508.member[0][1] < 0.0lf));
                let _e557 = select(_e555, _e551, (_e551 > _e555));
                let _e561 = select(_e508.member[0][2], -(_e508.member[0][2]), (_e508.member[0][2] < 0.0lf));
                let _e563 = select(_e561, _e557, (_e557 > _e561));
                let _e569 = select(_e508.member[1][0], -(_e508.member[1][0]), (_e508.member[1][0] < 0.0lf));
                let _e573 = select(_e508.member[1][1], -(_e508.member[1][1]), (_e508.member[1][1] < 0.0lf));
                let _e575 = select(_e573, _e569, (_e569 > _e573));
                let _e579 = select(_e508.member[1][2], -(_e508.member[1][2]), (_e508.member[1][2] < 0.0lf));
                let _e581 = select(_e579, _e575, (_e575 > _e579));
                let _e585 = (select(_e581, _e563, (_e563 > _e581)) + _e508.member_3);
                let _e591 = select(_e508.member_1[0][0], -(_e508.member_1[0][0]), (_e508.member_1[0][0] < 0.0lf));
                let _e595 = select(_e508.member_1[0][1], -(_e508.member_1[0][1]), (_e508.member_1[0][1] < 0.0lf));
                let _e597 = select(_e595, _e591, (_e591 > _e595));
                let _e601 = select(_e508.member_1[0][2], -(_e508.member_1[0][2]), (_e508.member_1[0][2] < 0.0lf));
                let _e603 = select(_e601, _e597, (_e597 > _e601));
                let _e609 = select(_e508.member_1[1][0], -(_e508.member_1[1][0]), (_e508.member_1[1][0] < 0.0lf));
                let _e613 = select(_e508.member_1[1][1], -(_e508.member_1[1][1]), (_e508.member_1[1][1] < 0.0lf));
                let _e615 = select(_e613, _e609, (_e609 > _e613));
                let _e619 = select(_e508.member_1[1][2], -(_e508.member_1[1][2]), (_e508.member_1[1][2] < 0.0lf));
                let _e621 = select(_e619, _e615, (_e615 > _e619));
                let _e625 = (select(_e621, _e603, (_e603 > _e621)) + _e508.member_3);
                let _e631 = select(_e508.member_2[0][0], -(_e508.member_2[0][0]), (_e508.member_2[0][0] < 0.0lf));
                let _e635 = select(_e508.member_2[0][1], -(_e508.member_2[0][1]), (_e508.member_2[0][1] < 0.0lf));
                let _e637 = select(_e635, _e631, (_e631 > _e635));
                let _e641 = select(_e508.member_2[0][2], -(_e508.member_2[0][2]), (_e508.member_2[0][2] < 0.0lf));
                let _e643 = select(_e641, _e637, (_e637 > _e641));
                let _e649 = select(_e508.member_2[1][0], -(_e508.member_2[1][0]), (_e508.member_2[1][0] < 0.0lf));
                let _e653 = select(_e508.member_2[1][1], -(_e508.member_2[1][1]), (_e508.member_2[1][1] < 0.0lf));
                let _e655 = select(_e653, _e649, (_e649 > _e653));
                let _e659 = select(_e508.member_2[1][2], -(_e508.member_2[1][2]), (_e508.member_2[1][2] < 0.0lf));
                let _e661 = select(_e659, _e655, (_e655 > _e659));
                let _e665 = (select(_e661, _e643, (_e643 > _e661)) + _e508.member_3);
                let _e667 = select(_e625, _e585, (_e585 > _e625));
                let _e669 = select(_e665, _e667, (_e667 > _e665));
                if (_e669 <= f64(65536f)) {
                    phi_1227_ = (_e669 >= f64((1f / 65536f)));
                } else {
                    phi_1227_ = false;
                }
                let _e676 = phi_1227_;
                if _e676 {
                    phi_1327_ = type_41();
                    phi_1328_ = true;
                } else {
                    if (_e669 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e669) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e683 = (9214364837600034816lu - (bitcast<u64>(_e669) & 9218868437227405312lu));
                            let _e686 = bitcast<f64>(select(4503599627370496lu, _e683, (_e683 > 4503599627370496lu)));
                            let _e687 = (_e545 * _e686);
                            phi_1323_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e508.member[0][0] * _e686), (_e508.member[0][1] * _e686), (_e508.member[0][2] * _e686)), array<f64, 3>((_e508.member[1][0] * _e686), (_e508.member[1][1] * _e686), (_e508.member[1][2] * _e686))), array<array<f64, 3>, 2>(array<f64, 3>((_e508.member_1[0][0] * _e686), (_e508.member_1[0][1] * _e686), (_e508.member_1[0][2] * _e686)), array<f64, 3>((_e508.member_1[1][0] * _e686), (_e508.member_1[1][1] * _e686), (_e508.member_1[1][2] * _e686))), array<array<f64, 3>, 2>(array<f64, 3>((_e508.member_2[0][0] * _e686), (_e508.member_2[0][1] * _e686), (_e508.member_2[0][2] * _e686)), array<f64, 3>((_e508.member_2[1][0] * _e686), (_e508.member_2[1][1] * _e686), (_e508.member_2[1][2] * _e686))), ((_e508.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e686)), select(_e687, select(2.2250738585072014e-308lf, _e687, (_e687 > 2.2250738585072014e-308lf)), (_e545 > f64(0f))));
                            phi_1324_ = false;
                        } else {
                            phi_1323_ = type_41();
                            phi_1324_ = true;
                        }
                        let _e758 = phi_1323_;
                        let _e760 = phi_1324_;
                        phi_1325_ = _e758;
                        phi_1326_ = _e760;
                    } else {
                        phi_1325_ = type_41();
                        phi_1326_ = true;
                    }
                    let _e762 = phi_1325_;
                    let _e764 = phi_1326_;
                    phi_1327_ = _e762;
                    phi_1328_ = _e764;
                }
                let _e766 = phi_1327_;
                let _e768 = phi_1328_;
                if _e768 {
                    phi_1333_ = type_41(_e508, _e545);
                } else {
                    phi_1333_ = _e766;
                }
                let _e771 = phi_1333_;
                let _e773 = f64(0f);
                let _e784 = ((_e771.member.member_1[0][1] * _e771.member.member_2[0][2]) - (_e771.member.member_1[0][2] * _e771.member.member_2[0][1]));
                let _e791 = ((_e771.member.member_1[0][2] * _e771.member.member_2[0][0]) - (_e771.member.member_1[0][0] * _e771.member.member_2[0][2]));
                let _e798 = ((_e771.member.member_1[0][0] * _e771.member.member_2[0][1]) - (_e771.member.member_1[0][1] * _e771.member.member_2[0][0]));
                let _e809 = ((_e771.member.member_1[1][1] * _e771.member.member_2[1][2]) - (_e771.member.member_1[1][2] * _e771.member.member_2[1][1]));
                let _e816 = ((_e771.member.member_1[1][2] * _e771.member.member_2[1][0]) - (_e771.member.member_1[1][0] * _e771.member.member_2[1][2]));
                let _e823 = ((_e771.member.member_1[1][0] * _e771.member.member_2[1][1]) - (_e771.member.member_1[1][1] * _e771.member.member_2[1][0]));
                let _e874 = (((_e771.member.member_1[0][1] * _e771.member.member_2[1][2]) - (_e771.member.member_1[0][2] * _e771.member.member_2[1][1])) + ((_e771.member.member_1[1][1] * _e771.member.member_2[0][2]) - (_e771.member.member_1[1][2] * _e771.member.member_2[0][1])));
                let _e875 = (((_e771.member.member_1[0][2] * _e771.member.member_2[1][0]) - (_e771.member.member_1[0][0] * _e771.member.member_2[1][2])) + ((_e771.member.member_1[1][2] * _e771.member.member_2[0][0]) - (_e771.member.member_1[1][0] * _e771.member.member_2[0][2])));
                let _e876 = (((_e771.member.member_1[0][0] * _e771.member.member_2[1][1]) - (_e771.member.member_1[0][1] * _e771.member.member_2[1][0])) + ((_e771.member.member_1[1][0] * _e771.member.member_2[0][1]) - (_e771.member.member_1[1][1] * _e771.member.member_2[0][0])));
                let _e886 = (((_e771.member.member[0][0] * _e784) + (_e771.member.member[0][1] * _e791)) + (_e771.member.member[0][2] * _e798));
                let _e907 = ((((_e771.member.member[1][0] * _e784) + (_e771.member.member[1][1] * _e791)) + (_e771.member.member[1][2] * _e798)) + (((_e771.member.member[0][0] * _e874) + (_e771.member.member[0][1] * _e875)) + (_e771.member.member[0][2] * _e876)));
                let _e928 = ((((_e771.member.member[0][0] * _e809) + (_e771.member.member[0][1] * _e816)) + (_e771.member.member[0][2] * _e823)) + (((_e771.member.member[1][0] * _e874) + (_e771.member.member[1][1] * _e875)) + (_e771.member.member[1][2] * _e876)));
                let _e938 = (((_e771.member.member[1][0] * _e809) + (_e771.member.member[1][1] * _e816)) + (_e771.member.member[1][2] * _e823));
                let _e944 = select(_e771.member.member[0][0], -(_e771.member.member[0][0]), (_e771.member.member[0][0] < 0.0lf));
                let _e948 = select(_e771.member.member[0][1], -(_e771.member.member[0][1]), (_e771.member.member[0][1] < 0.0lf));
                let _e950 = select(_e948, _e944, (_e944 > _e948));
                let _e954 = select(_e771.member.member[0][2], -(_e771.member.member[0][2]), (_e771.member.member[0][2] < 0.0lf));
                let _e956 = select(_e954, _e950, (_e950 > _e954));
                let _e962 = select(_e771.member.member[1][0], -(_e771.member.member[1][0]), (_e771.member.member[1][0] < 0.0lf));
                let _e966 = select(_e771.member.member[1][1], -(_e771.member.member[1][1]), (_e771.member.member[1][1] < 0.0lf));
                let _e968 = select(_e966, _e962, (_e962 > _e966));
                let _e972 = select(_e771.member.member[1][2], -(_e771.member.member[1][2]), (_e771.member.member[1][2] < 0.0lf));
                let _e974 = select(_e972, _e968, (_e968 > _e972));
                let _e978 = (select(_e974, _e956, (_e956 > _e974)) + _e771.member.member_3);
                let _e984 = select(_e771.member.member_1[0][0], -(_e771.member.member_1[0][0]), (_e771.member.member_1[0][0] < 0.0lf));
                let _e988 = select(_e771.member.member_1[0][1], -(_e771.member.member_1[0][1]), (_e771.member.member_1[0][1] < 0.0lf));
                let _e990 = select(_e988, _e984, (_e984 > _e988));
                let _e994 = select(_e771.member.member_1[0][2], -(_e771.member.member_1[0][2]), (_e771.member.member_1[0][2] < 0.0lf));
                let _e996 = select(_e994, _e990, (_e990 > _e994));
                let _e1002 = select(_e771.member.member_1[1][0], -(_e771.member.member_1[1][0]), (_e771.member.member_1[1][0] < 0.0lf));
                let _e1006 = select(_e771.member.member_1[1][1], -(_e771.member.member_1[1][1]), (_e771.member.member_1[1][1] < 0.0lf));
                let _e1008 = select(_e1006, _e1002, (_e1002 > _e1006));
                let _e1012 = select(_e771.member.member_1[1][2], -(_e771.member.member_1[1][2]), (_e771.member.member_1[1][2] < 0.0lf));
                let _e1014 = select(_e1012, _e1008, (_e1008 > _e1012));
                let _e1018 = (select(_e1014, _e996, (_e996 > _e1014)) + _e771.member.member_3);
                let _e1024 = select(_e771.member.member_2[0][0], -(_e771.member.member_2[0][0]), (_e771.member.member_2[0][0] < 0.0lf));
                let _e1028 = select(_e771.member.member_2[0][1], -(_e771.member.member_2[0][1]), (_e771.member.member_2[0][1] < 0.0lf));
                let _e1030 = select(_e1028, _e1024, (_e1024 > _e1028));
                let _e1034 = select(_e771.member.member_2[0][2], -(_e771.member.member_2[0][2]), (_e771.member.member_2[0][2] < 0.0lf));
                let _e1036 = select(_e1034, _e1030, (_e1030 > _e1034));
                let _e1042 = select(_e771.member.member_2[1][0], -(_e771.member.member_2[1][0]), (_e771.member.member_2[1][0] < 0.0lf));
                let _e1046 = select(_e771.member.member_2[1][1], -(_e771.member.member_2[1][1]), (_e771.member.member_2[1][1] < 0.0lf));
                let _e1048 = select(_e1046, _e1042, (_e1042 > _e1046));
                let _e1052 = select(_e771.member.member_2[1][2], -(_e771.member.member_2[1][2]), (_e771.member.member_2[1][2] < 0.0lf));
                let _e1054 = select(_e1052, _e1048, (_e1048 > _e1052));
                let _e1058 = (select(_e1054, _e1036, (_e1036 > _e1054)) + _e771.member.member_3);
                let _e1059 = f64(1f);
                let _e1060 = f64(8f);
                let _e1062 = ((_e1018 * _e1060) * _e1058);
                let _e1096 = ((select(_e784, -(_e784), (_e784 < 0.0lf)) + select(_e791, -(_e791), (_e791 < 0.0lf))) + select(_e798, -(_e798), (_e798 < 0.0lf)));
                let _e1107 = ((select(_e809, -(_e809), (_e809 < 0.0lf)) + select(_e816, -(_e816), (_e816 < 0.0lf))) + select(_e823, -(_e823), (_e823 < 0.0lf)));
                let _e1109 = select(_e1107, _e1096, (_e1096 > _e1107));
                let _e1121 = (((select(_e874, -(_e874), (_e874 < 0.0lf)) + select(_e875, -(_e875), (_e875 < 0.0lf))) + select(_e876, -(_e876), (_e876 < 0.0lf))) * f64(0.5f));
                let _e1142 = (((((_e978 * _e1060) * _e1062) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e771.member.member_3 * f64(19f)) * ((_e978 * (_e1018 + _e1058)) + (_e1018 * _e1058)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1059 + _e978) * ((_e1059 + _e1018) * (_e1059 + _e1058)))));
                let _e1143 = f64(3f);
                let _e1144 = (_e886 * _e1143);
                let _e1145 = (_e938 * _e1143);
                let _e1147 = select(_e1145, _e1144, (_e1144 < _e1145));
                let _e1149 = select(_e928, _e907, (_e907 < _e928));
                let _e1151 = select(_e1149, _e1147, (_e1147 < _e1149));
                let _e1153 = select(_e1145, _e1144, (_e1144 > _e1145));
                let _e1155 = select(_e928, _e907, (_e907 > _e928));
                let _e1158 = -(select(_e1155, _e1153, (_e1153 > _e1155)));
                if ((select(_e1158, _e1151, (_e1151 > _e1158)) - (_e1142 + ((_e773 * (((select(_e1121, _e1109, (_e1109 > _e1121)) + (_e1062 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e771.member.member_3 * f64(6f)) * (_e1018 + _e1058))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1059 + _e1018) * (_e1059 + _e1058))))) * f64((3f * 1.0001f))))) > _e773) {
                    phi_3659_ = type_42(0u, type_42().member_1);
                    phi_3660_ = type_42();
                    phi_3661_ = true;
                } else {
                    let _e1172 = select(_e886, -(_e886), (_e886 < 0.0lf));
                    let _e1175 = select(_e907, -(_e907), (_e907 < 0.0lf));
                    let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                    let _e1180 = select(_e928, -(_e928), (_e928 < 0.0lf));
                    let _e1183 = select(_e938, -(_e938), (_e938 < 0.0lf));
                    let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                    let _e1187 = select(_e1185, _e1177, (_e1177 > _e1185));
                    let _e1189 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1190 = f64(1f);
                    if (_e1187 >= _e1189) {
                        phi_1918_ = (_e1187 <= (_e1190 / _e1189));
                    } else {
                        phi_1918_ = false;
                    }
                    let _e1195 = phi_1918_;
                    if _e1195 {
                        phi_1933_ = (_e1190 / _e1187);
                    } else {
                        phi_1933_ = f64(0f);
                    }
                    let _e1205 = phi_1933_;
                    let _e1206 = f64(0.00000000000022737368f);
                    let _e1208 = (_e517 * f64(0.0625f));
                    local_4 = type_39(array<f64, 4>(_e886, _e907, _e928, _e938), ((_e1142 * f64(0.34f)) + (_e1187 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1195))), _e1205, select(_e1208, _e1206, (_e1206 < _e1208)));
                    let _e1213 = f64(0f);
                    let _e1214 = f64(1f);
                    let _e1215 = f64(3f);
                    let _e1218 = local_4.member[0u];
                    let _e1221 = local_4.member[1u];
                    let _e1224 = local_4.member[2u];
                    let _e1227 = local_4.member[3u];
                    let _e1234 = local_4.member_2;
                    let _e1235 = ((_e1221 - (_e1215 * _e1218)) * _e1234);
                    let _e1237 = local_4.member_2;
                    let _e1238 = ((_e1224 - _e1221) * _e1237);
                    let _e1240 = local_4.member_2;
                    let _e1241 = (((_e1215 * _e1227) - _e1224) * _e1240);
                    local_2[0u] = _e1213;
                    local_2[1u] = _e1214;
                    local_2[2u] = _e1214;
                    local_2[3u] = _e1214;
                    let _e1248 = ((_e1238 * _e1238) - (_e1235 * _e1241));
                    if (_e1248 > _e1213) {
                        if (_e1248 <= 2.2250738585072014e-308lf) {
                            phi_2066_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1248 > 0.0lf));
                        } else {
                            phi_2009_ = type_16(0i, 5i);
                            phi_2012_ = bitcast<f64>(((bitcast<u64>(_e1248) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1256 = phi_2009_;
                                let _e1258 = phi_2012_;
                                local_7 = _e1258;
                                if (_e1256.member < _e1256.member_1) {
                                    let _e1265 = (_e1256.member + 1i);
                                    phi_2010_ = type_16(select(_e1265, type_17().member_1, select(false, true, ((false == (_e1265 > _e1256.member)) != false))), _e1256.member_1);
                                    phi_2053_ = type_17(1u, _e1256.member);
                                } else {
                                    phi_2010_ = _e1256;
                                    phi_2053_ = type_17(0u, type_17().member_1);
                                }
                                let _e1276 = phi_2010_;
                                let _e1278 = phi_2053_;
                                let _e1281 = (bitcast<i32>(_e1278.member) != 0i);
                                if _e1281 {
                                    phi_2013_ = (0.5lf * (_e1258 + (_e1248 / _e1258)));
                                } else {
                                    phi_2013_ = f64();
                                }
                                let _e1286 = phi_2013_;
                                continue;
                                continuing {
                                    phi_2009_ = _e1276;
                                    phi_2012_ = _e1286;
                                    break if !(_e1281);
                                }
                            }
                            let _e1291 = local_7;
                            phi_2066_ = (_e1291 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1297 = phi_2066_;
                        let _e1302 = -((_e1238 + select(_e1297, -(_e1297), (_e1238 < _e1213))));
                        local_3[0u] = (_e1302 / (_e1302 + _e1241));
                        local_3[1u] = (_e1235 / (_e1235 + _e1302));
                        let _e1311 = local_3[1u];
                        let _e1312 = local_3[0u];
                        if (_e1311 < _e1312) {
                            let _e1315 = local_3[1u];
                            let _e1317 = local_3[0u];
                            local_3[0u] = _e1315;
                            local_3[1u] = _e1317;
                        }
                        phi_2097_ = type_9(0u, 2u);
                        phi_2100_ = 1u;
                        loop {
                            let _e1321 = phi_2097_;
                            let _e1323 = phi_2100_;
                            local_35 = _e1323;
                            let _e1326 = (_e1321.member < _e1321.member_1);
                            let _e1337 = select(type_9().member_1, _e1321.member, _e1326);
                            let _e1339 = (bitcast<i32>(select(0u, 1u, _e1326)) != 0i);
                            if _e1339 {
                                let _e1341 = local_3[_e1337];
                                if (_e1341 > _e1213) {
                                    let _e1344 = local_3[_e1337];
                                    if (_e1344 < _e1214) {
                                        let _e1347 = local_3[_e1337];
                                        local_2[_e1323] = _e1347;
                                        phi_2167_ = (_e1323 + 1u);
                                    } else {
                                        phi_2167_ = _e1323;
                                    }
                                    let _e1351 = phi_2167_;
                                    phi_2168_ = _e1351;
                                } else {
                                    phi_2168_ = _e1323;
                                }
                                let _e1353 = phi_2168_;
                                phi_2101_ = _e1353;
                            } else {
                                phi_2101_ = u32();
                            }
                            let _e1355 = phi_2101_;
                            continue;
                            continuing {
                                phi_2097_ = type_9(select(_e1321.member, (_e1321.member + 1u), _e1326), select(_e1321.member_1, _e1321.member_1, _e1326));
                                phi_2100_ = _e1355;
                                break if !(_e1339);
                            }
                        }
                        let _e2711 = local_35;
                        phi_2169_ = _e2711;
                    } else {
                        phi_2169_ = 1u;
                    }
                    let _e1358 = phi_2169_;
                    local_2[_e1358] = _e1214;
                    let _e1360 = local_2;
                    local_5 = _e1360;
                    let _e1364 = (f64(1f) - _e526);
                    let _e1367 = local_4.member[0u];
                    let _e1370 = local_4.member[1u];
                    let _e1373 = local_4.member[2u];
                    let _e1376 = local_4.member[3u];
                    let _e1387 = ((((_e1367 * _e1364) + (_e1370 * _e526)) * (_e1364 * _e1364)) + (((_e1373 * _e1364) + (_e1376 * _e526)) * (_e526 * _e526)));
                    let _e1392 = local_4.member_1;
                    phi_2227_ = type_9(select(1u, 0u, !((select(_e1387, -(_e1387), (_e1387 < 0.0lf)) > _e1392))), (_e1358 + 1u));
                    loop {
                        let _e1399 = phi_2227_;
                        let _e1402 = (_e1399.member < _e1399.member_1);
                        let _e1413 = select(type_9().member_1, _e1399.member, _e1402);
                        if (bitcast<i32>(select(0u, 1u, _e1402)) != 0i) {
                            if (_e1413 > 0u) {
                                let _e1420 = local_5[(_e1413 - 1u)];
                                let _e1422 = select(_e526, _e1420, (_e1420 > _e526));
                                let _e1424 = local_5[_e1413];
                                let _e1426 = select(_e535, _e1424, (_e1424 < _e535));
                                if (_e1422 <= _e1426) {
                                    let _e1428 = function_2((&local_4), _e544, _e1422, _e1426);
                                    if _e1428 {
                                        phi_3547_ = type_43();
                                        phi_3548_ = u32();
                                        phi_3549_ = false;
                                        phi_3550_ = false;
                                        phi_3551_ = false;
                                    } else {
                                        let _e1430 = (f64(1f) - _e1422);
                                        let _e1433 = local_4.member[0u];
                                        let _e1436 = local_4.member[1u];
                                        let _e1439 = local_4.member[2u];
                                        let _e1442 = local_4.member[3u];
                                        let _e1453 = ((((_e1433 * _e1430) + (_e1436 * _e1422)) * (_e1430 * _e1430)) + (((_e1439 * _e1430) + (_e1442 * _e1422)) * (_e1422 * _e1422)));
                                        let _e1455 = (f64(1f) - _e1426);
                                        let _e1458 = local_4.member[0u];
                                        let _e1461 = local_4.member[1u];
                                        let _e1464 = local_4.member[2u];
                                        let _e1467 = local_4.member[3u];
                                        let _e1478 = ((((_e1458 * _e1455) + (_e1461 * _e1426)) * (_e1455 * _e1455)) + (((_e1464 * _e1455) + (_e1467 * _e1426)) * (_e1426 * _e1426)));
                                        let _e1483 = local_4.member_1;
                                        let _e1484 = (select(_e1453, -(_e1453), (_e1453 < 0.0lf)) > _e1483);
                                        let _e1489 = local_4.member_1;
                                        let _e1490 = (select(_e1478, -(_e1478), (_e1478 < 0.0lf)) > _e1489);
                                        let _e1491 = f64(0f);
                                        let _e1499 = select(select(bool(), select(bool(), ((_e1453 > _e1491) != (_e1478 > _e1491)), _e1490), _e1484), false, select(true, select(true, false, _e1490), _e1484));
                                        if _e1484 {
                                            if _e1490 {
                                                phi_2387_ = type_43(select(f64(1f), type_43().member, _e1499), select(_e1491, type_43().member_1, _e1499), select(_e1499, type_43().member_2, _e1499));
                                                phi_2388_ = _e1499;
                                            } else {
                                                phi_2387_ = type_43();
                                                phi_2388_ = true;
                                            }
                                            let _e1509 = phi_2387_;
                                            let _e1511 = phi_2388_;
                                            phi_2389_ = _e1509;
                                            phi_2390_ = _e1511;
                                        } else {
                                            phi_2389_ = type_43();
                                            phi_2390_ = true;
                                        }
                                        let _e1513 = phi_2389_;
                                        let _e1515 = phi_2390_;
                                        if _e1515 {
                                            if _e1484 {
                                                let _e1519 = select(f64(1f), f64(-1f), (_e1453 < _e1491));
                                                let _e1521 = local_4.member_3;
                                                let _e1522 = f64(0.5f);
                                                let _e1523 = f64(3f);
                                                let _e1526 = local_4.member[0u];
                                                let _e1529 = local_4.member[1u];
                                                let _e1532 = local_4.member[2u];
                                                let _e1535 = local_4.member[3u];
                                                let _e1538 = (_e1532 - _e1529);
                                                phi_2425_ = type_9(0u, 64u);
                                                phi_2428_ = _e1426;
                                                phi_2430_ = _e1422;
                                                phi_2432_ = (_e1522 * (_e1422 + _e1426));
                                                loop {
                                                    let _e1544 = phi_2425_;
                                                    let _e1546 = phi_2428_;
                                                    let _e1548 = phi_2430_;
                                                    let _e1550 = phi_2432_;
                                                    local_10 = _e1548;
                                                    let _e1553 = (_e1544.member < _e1544.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1553)) != 0i) {
                                                        let _e1566 = (f64(1f) - _e1550);
                                                        let _e1569 = local_4.member[0u];
                                                        let _e1572 = local_4.member[1u];
                                                        let _e1575 = local_4.member[2u];
                                                        let _e1578 = local_4.member[3u];
                                                        let _e1592 = local_4.member_1;
                                                        let _e1593 = ((_e1519 * ((((_e1569 * _e1566) + (_e1572 * _e1550)) * (_e1566 * _e1566)) + (((_e1575 * _e1566) + (_e1578 * _e1550)) * (_e1550 * _e1550)))) - _e1592);
                                                        let _e1595 = (_e1593 > f64(0f));
                                                        let _e1596 = select(_e1550, _e1546, _e1595);
                                                        let _e1597 = select(_e1548, _e1550, _e1595);
                                                        let _e1599 = ((_e1596 - _e1597) > _e1521);
                                                        if _e1599 {
                                                            let _e1601 = (f64(1f) - _e1550);
                                                            let _e1613 = (-(_e1593) / (_e1519 * (((((_e1529 - (_e1523 * _e1526)) * _e1601) + (_e1538 * _e1550)) * _e1601) + (((_e1538 * _e1601) + (((_e1523 * _e1535) - _e1532) * _e1550)) * _e1550))));
                                                            let _e1621 = ((_e1550 + _e1613) + select(-((_e1522 * _e1521)), (_e1522 * _e1521), (_e1593 > f64(0f))));
                                                            if (_e1621 > _e1597) {
                                                                phi_2546_ = select(true, select(true, false, (select(_e1613, -(_e1613), (_e1613 < 0.0lf)) < (_e1522 * (_e1596 - _e1597)))), (_e1621 < _e1596));
                                                            } else {
                                                                phi_2546_ = true;
                                                            }
                                                            let _e1633 = phi_2546_;
                                                            phi_2553_ = select(_e1621, (_e1522 * (_e1597 + _e1596)), _e1633);
                                                            phi_2554_ = false;
                                                        } else {
                                                            phi_2553_ = f64();
                                                            phi_2554_ = true;
                                                        }
                                                        let _e1638 = phi_2553_;
                                                        let _e1640 = phi_2554_;
                                                        phi_2429_ = _e1596;
                                                        phi_2431_ = _e1597;
                                                        phi_2433_ = _e1638;
                                                        phi_2555_ = _e1597;
                                                        phi_2556_ = _e1599;
                                                        phi_2557_ = _e1640;
                                                    } else {
                                                        phi_2429_ = f64();
                                                        phi_2431_ = f64();
                                                        phi_2433_ = f64();
                                                        phi_2555_ = f64();
                                                        phi_2556_ = false;
                                                        phi_2557_ = false;
                                                    }
                                                    let _e1642 = phi_2429_;
                                                    let _e1644 = phi_2431_;
                                                    let _e1646 = phi_2433_;
                                                    let _e1648 = phi_2555_;
                                                    let _e1650 = phi_2556_;
                                                    let _e1652 = phi_2557_;
                                                    local_8 = _e1652;
                                                    local_9 = _e1648;
                                                    continue;
                                                    continuing {
                                                        phi_2425_ = type_9(select(_e1544.member, (_e1544.member + 1u), _e1553), select(_e1544.member_1, _e1544.member_1, _e1553));
                                                        phi_2428_ = _e1642;
                                                        phi_2430_ = _e1644;
                                                        phi_2432_ = _e1646;
                                                        break if !(_e1650);
                                                    }
                                                }
                                                let _e1655 = local_8;
                                                let _e1657 = local_9;
                                                let _e1659 = local_10;
                                                phi_2562_ = select(_e1659, _e1657, _e1655);
                                            } else {
                                                phi_2562_ = _e1422;
                                            }
                                            let _e1662 = phi_2562_;
                                            if _e1490 {
                                                let _e1668 = local_4.member_3;
                                                let _e1670 = local_4.member_3;
                                                phi_2580_ = type_9(0u, 64u);
                                                phi_2583_ = (_e1668 + _e1670);
                                                loop {
                                                    let _e1673 = phi_2580_;
                                                    let _e1675 = phi_2583_;
                                                    let _e1678 = (_e1673.member < _e1673.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1678)) != 0i) {
                                                        let _e1690 = (_e1662 + _e1675);
                                                        if (_e1690 < _e1426) {
                                                            let _e1693 = (f64(1f) - _e1690);
                                                            let _e1696 = local_4.member[0u];
                                                            let _e1699 = local_4.member[1u];
                                                            let _e1702 = local_4.member[2u];
                                                            let _e1705 = local_4.member[3u];
                                                            let _e1719 = local_4.member_1;
                                                            let _e1720 = ((select(f64(1f), f64(-1f), (_e1478 < _e1491)) * ((((_e1696 * _e1693) + (_e1699 * _e1690)) * (_e1693 * _e1693)) + (((_e1702 * _e1693) + (_e1705 * _e1690)) * (_e1690 * _e1690)))) > _e1719);
                                                            phi_2649_ = select((_e1675 + _e1675), f64(), _e1720);
                                                            phi_2650_ = select(true, false, _e1720);
                                                            phi_2651_ = _e1720;
                                                            phi_2652_ = false;
                                                        } else {
                                                            phi_2649_ = f64();
                                                            phi_2650_ = false;
                                                            phi_2651_ = false;
                                                            phi_2652_ = true;
                                                        }
                                                        let _e1725 = phi_2649_;
                                                        let _e1727 = phi_2650_;
                                                        let _e1729 = phi_2651_;
                                                        let _e1731 = phi_2652_;
                                                        phi_2653_ = _e1690;
                                                        phi_2584_ = _e1725;
                                                        phi_2654_ = _e1727;
                                                        phi_2655_ = _e1729;
                                                        phi_2656_ = _e1731;
                                                        phi_2657_ = false;
                                                    } else {
                                                        phi_2653_ = f64();
                                                        phi_2584_ = f64();
                                                        phi_2654_ = false;
                                                        phi_2655_ = false;
                                                        phi_2656_ = false;
                                                        phi_2657_ = true;
                                                    }
                                                    let _e1733 = phi_2653_;
                                                    let _e1735 = phi_2584_;
                                                    let _e1737 = phi_2654_;
                                                    let _e1739 = phi_2655_;
                                                    let _e1741 = phi_2656_;
                                                    let _e1743 = phi_2657_;
                                                    local_11 = _e1739;
                                                    local_12 = _e1741;
                                                    local_13 = _e1739;
                                                    local_14 = _e1743;
                                                    local_15 = _e1733;
                                                    continue;
                                                    continuing {
                                                        phi_2580_ = type_9(select(_e1673.member, (_e1673.member + 1u), _e1678), select(_e1673.member_1, _e1673.member_1, _e1678));
                                                        phi_2583_ = _e1735;
                                                        break if !(_e1737);
                                                    }
                                                }
                                                let _e1746 = local_11;
                                                let _e1748 = local_12;
                                                let _e1751 = local_13;
                                                let _e1753 = local_14;
                                                let _e1757 = local_15;
                                                phi_2671_ = select(_e1757, _e1426, select(select(_e1753, false, _e1751), true, select(_e1748, false, _e1746)));
                                            } else {
                                                phi_2671_ = _e1426;
                                            }
                                            let _e1760 = phi_2671_;
                                            phi_2673_ = type_43(_e1662, _e1760, _e1499);
                                        } else {
                                            phi_2673_ = _e1513;
                                        }
                                        let _e1763 = phi_2673_;
                                        if (_e1763.member > _e1763.member_1) {
                                            phi_3543_ = u32();
                                            phi_3544_ = true;
                                            phi_3545_ = false;
                                            phi_3546_ = false;
                                        } else {
                                            let _e1768 = (_e1763.member > _e544);
                                            if _e1768 {
                                                phi_3540_ = u32();
                                                phi_3541_ = false;
                                                phi_3542_ = false;
                                            } else {
                                                let _e1773 = ((_e1763.member_1 - _e1763.member) * f64(0.5f));
                                                let _e1774 = (_e1763.member + _e1773);
                                                let _e1777 = (_e1773 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1784 = select(_e771.member.member[0][0], -(_e771.member.member[0][0]), (_e771.member.member[0][0] < 0.0lf));
                                                let _e1788 = select(_e771.member.member[0][1], -(_e771.member.member[0][1]), (_e771.member.member[0][1] < 0.0lf));
                                                let _e1790 = select(_e1788, _e1784, (_e1784 > _e1788));
                                                let _e1794 = select(_e771.member.member[0][2], -(_e771.member.member[0][2]), (_e771.member.member[0][2] < 0.0lf));
                                                let _e1796 = select(_e1794, _e1790, (_e1790 > _e1794));
                                                let _e1802 = select(_e771.member.member[1][0], -(_e771.member.member[1][0]), (_e771.member.member[1][0] < 0.0lf));
                                                let _e1806 = select(_e771.member.member[1][1], -(_e771.member.member[1][1]), (_e771.member.member[1][1] < 0.0lf));
                                                let _e1808 = select(_e1806, _e1802, (_e1802 > _e1806));
                                                let _e1812 = select(_e771.member.member[1][2], -(_e771.member.member[1][2]), (_e771.member.member[1][2] < 0.0lf));
                                                let _e1814 = select(_e1812, _e1808, (_e1808 > _e1812));
                                                let _e1835 = (_e771.member.member[0][0] + ((_e771.member.member[1][0] - _e771.member.member[0][0]) * _e1774));
                                                let _e1837 = (_e771.member.member[0][1] + ((_e771.member.member[1][1] - _e771.member.member[0][1]) * _e1774));
                                                let _e1839 = (_e771.member.member[0][2] + ((_e771.member.member[1][2] - _e771.member.member[0][2]) * _e1774));
                                                let _e1846 = (_e771.member.member[1][0] - _e771.member.member[0][0]);
                                                let _e1849 = (_e771.member.member[1][1] - _e771.member.member[0][1]);
                                                let _e1852 = (_e771.member.member[1][2] - _e771.member.member[0][2]);
                                                let _e1855 = select(_e1846, -(_e1846), (_e1846 < 0.0lf));
                                                let _e1858 = select(_e1849, -(_e1849), (_e1849 < 0.0lf));
                                                let _e1860 = select(_e1858, _e1855, (_e1855 > _e1858));
                                                let _e1863 = select(_e1852, -(_e1852), (_e1852 < 0.0lf));
                                                let _e1873 = ((((_e1777 * select(_e1863, _e1860, (_e1860 > _e1863))) * f64(1.01f)) + ((select(_e1814, _e1796, (_e1796 > _e1814)) + _e771.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e771.member.member_3);
                                                let _e1876 = select(_e1835, -(_e1835), (_e1835 < 0.0lf));
                                                let _e1879 = select(_e1837, -(_e1837), (_e1837 < 0.0lf));
                                                let _e1881 = select(_e1879, _e1876, (_e1876 > _e1879));
                                                let _e1884 = select(_e1839, -(_e1839), (_e1839 < 0.0lf));
                                                let _e1887 = (select(_e1884, _e1881, (_e1881 > _e1884)) + _e1873);
                                                let _e1894 = select(_e771.member.member_1[0][0], -(_e771.member.member_1[0][0]), (_e771.member.member_1[0][0] < 0.0lf));
                                                let _e1898 = select(_e771.member.member_1[0][1], -(_e771.member.member_1[0][1]), (_e771.member.member_1[0][1] < 0.0lf));
                                                let _e1900 = select(_e1898, _e1894, (_e1894 > _e1898));
                                                let _e1904 = select(_e771.member.member_1[0][2], -(_e771.member.member_1[0][2]), (_e771.member.member_1[0][2] < 0.0lf));
                                                let _e1906 = select(_e1904, _e1900, (_e1900 > _e1904));
                                                let _e1912 = select(_e771.member.member_1[1][0], -(_e771.member.member_1[1][0]), (_e771.member.member_1[1][0] < 0.0lf));
                                                let _e1916 = select(_e771.member.member_1[1][1], -(_e771.member.member_1[1][1]), (_e771.member.member_1[1][1] < 0.0lf));
                                                let _e1918 = select(_e1916, _e1912, (_e1912 > _e1916));
                                                let _e1922 = select(_e771.member.member_1[1][2], -(_e771.member.member_1[1][2]), (_e771.member.member_1[1][2] < 0.0lf));
                                                let _e1924 = select(_e1922, _e1918, (_e1918 > _e1922));
                                                let _e1945 = (_e771.member.member_1[0][0] + ((_e771.member.member_1[1][0] - _e771.member.member_1[0][0]) * _e1774));
                                                let _e1947 = (_e771.member.member_1[0][1] + ((_e771.member.member_1[1][1] - _e771.member.member_1[0][1]) * _e1774));
                                                let _e1949 = (_e771.member.member_1[0][2] + ((_e771.member.member_1[1][2] - _e771.member.member_1[0][2]) * _e1774));
                                                let _e1956 = (_e771.member.member_1[1][0] - _e771.member.member_1[0][0]);
                                                let _e1959 = (_e771.member.member_1[1][1] - _e771.member.member_1[0][1]);
                                                let _e1962 = (_e771.member.member_1[1][2] - _e771.member.member_1[0][2]);
                                                let _e1965 = select(_e1956, -(_e1956), (_e1956 < 0.0lf));
                                                let _e1968 = select(_e1959, -(_e1959), (_e1959 < 0.0lf));
                                                let _e1970 = select(_e1968, _e1965, (_e1965 > _e1968));
                                                let _e1973 = select(_e1962, -(_e1962), (_e1962 < 0.0lf));
                                                let _e1983 = ((((_e1777 * select(_e1973, _e1970, (_e1970 > _e1973))) * f64(1.01f)) + ((select(_e1924, _e1906, (_e1906 > _e1924)) + _e771.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e771.member.member_3);
                                                let _e1986 = select(_e1945, -(_e1945), (_e1945 < 0.0lf));
                                                let _e1989 = select(_e1947, -(_e1947), (_e1947 < 0.0lf));
                                                let _e1991 = select(_e1989, _e1986, (_e1986 > _e1989));
                                                let _e1994 = select(_e1949, -(_e1949), (_e1949 < 0.0lf));
                                                let _e1997 = (select(_e1994, _e1991, (_e1991 > _e1994)) + _e1983);
                                                let _e2004 = select(_e771.member.member_2[0][0], -(_e771.member.member_2[0][0]), (_e771.member.member_2[0][0] < 0.0lf));
                                                let _e2008 = select(_e771.member.member_2[0][1], -(_e771.member.member_2[0][1]), (_e771.member.member_2[0][1] < 0.0lf));
                                                let _e2010 = select(_e2008, _e2004, (_e2004 > _e2008));
                                                let _e2014 = select(_e771.member.member_2[0][2], -(_e771.member.member_2[0][2]), (_e771.member.member_2[0][2] < 0.0lf));
                                                let _e2016 = select(_e2014, _e2010, (_e2010 > _e2014));
                                                let _e2022 = select(_e771.member.member_2[1][0], -(_e771.member.member_2[1][0]), (_e771.member.member_2[1][0] < 0.0lf));
                                                let _e2026 = select(_e771.member.member_2[1][1], -(_e771.member.member_2[1][1]), (_e771.member.member_2[1][1] < 0.0lf));
                                                let _e2028 = select(_e2026, _e2022, (_e2022 > _e2026));
                                                let _e2032 = select(_e771.member.member_2[1][2], -(_e771.member.member_2[1][2]), (_e771.member.member_2[1][2] < 0.0lf));
                                                let _e2034 = select(_e2032, _e2028, (_e2028 > _e2032));
                                                let _e2055 = (_e771.member.member_2[0][0] + ((_e771.member.member_2[1][0] - _e771.member.member_2[0][0]) * _e1774));
                                                let _e2057 = (_e771.member.member_2[0][1] + ((_e771.member.member_2[1][1] - _e771.member.member_2[0][1]) * _e1774));
                                                let _e2059 = (_e771.member.member_2[0][2] + ((_e771.member.member_2[1][2] - _e771.member.member_2[0][2]) * _e1774));
                                                let _e2066 = (_e771.member.member_2[1][0] - _e771.member.member_2[0][0]);
                                                let _e2069 = (_e771.member.member_2[1][1] - _e771.member.member_2[0][1]);
                                                let _e2072 = (_e771.member.member_2[1][2] - _e771.member.member_2[0][2]);
                                                let _e2075 = select(_e2066, -(_e2066), (_e2066 < 0.0lf));
                                                let _e2078 = select(_e2069, -(_e2069), (_e2069 < 0.0lf));
                                                let _e2080 = select(_e2078, _e2075, (_e2075 > _e2078));
                                                let _e2083 = select(_e2072, -(_e2072), (_e2072 < 0.0lf));
                                                let _e2093 = ((((_e1777 * select(_e2083, _e2080, (_e2080 > _e2083))) * f64(1.01f)) + ((select(_e2034, _e2016, (_e2016 > _e2034)) + _e771.member.member_3) * (1.1102230246251565e-16lf * f64(8f)))) + _e771.member.member_3);
                                                let _e2096 = select(_e2055, -(_e2055), (_e2055 < 0.0lf));
                                                let _e2099 = select(_e2057, -(_e2057), (_e2057 < 0.0lf));
                                                let _e2101 = select(_e2099, _e2096, (_e2096 > _e2099));
                                                let _e2104 = select(_e2059, -(_e2059), (_e2059 < 0.0lf));
                                                let _e2107 = (select(_e2104, _e2101, (_e2101 > _e2104)) + _e2093);
                                                let _e2110 = ((_e1947 * _e2059) - (_e1949 * _e2057));
                                                let _e2113 = ((_e1949 * _e2055) - (_e1945 * _e2059));
                                                let _e2116 = ((_e1945 * _e2057) - (_e1947 * _e2055));
                                                let _e2131 = select(false, (select(_e2110, -(_e2110), (_e2110 < 0.0lf)) > select(_e2116, -(_e2116), (_e2116 < 0.0lf))), (select(_e2110, -(_e2110), (_e2110 < 0.0lf)) > select(_e2113, -(_e2113), (_e2113 < 0.0lf))));
                                                let _e2146 = select((select(_e2113, -(_e2113), (_e2113 < 0.0lf)) > select(_e2116, -(_e2116), (_e2116 < 0.0lf))), false, (select(_e2110, -(_e2110), (_e2110 < 0.0lf)) > select(_e2113, -(_e2113), (_e2113 < 0.0lf))));
                                                let _e2149 = select(select(_e1835, _e1837, _e2131), _e1839, _e2146);
                                                let _e2150 = select(select(_e1837, _e1839, _e2131), _e1835, _e2146);
                                                let _e2153 = select(select(_e1945, _e1947, _e2131), _e1949, _e2146);
                                                let _e2154 = select(select(_e1947, _e1949, _e2131), _e1945, _e2146);
                                                let _e2157 = select(select(_e2055, _e2057, _e2131), _e2059, _e2146);
                                                let _e2158 = select(select(_e2057, _e2059, _e2131), _e2055, _e2146);
                                                let _e2161 = ((_e2153 * _e2158) - (_e2154 * _e2157));
                                                let _e2162 = f64(1f);
                                                let _e2163 = f64(2f);
                                                let _e2181 = (((((_e1983 * _e2107) + (_e1997 * _e2093)) * f64(2.01f)) + (((_e1997 * _e2163) * (_e2107 * _e2163)) * (1.1102230246251565e-16lf * _e2163))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2162 + _e1997) * (_e2162 + _e2107))));
                                                if (select(_e2161, -(_e2161), (_e2161 < 0.0lf)) > _e2181) {
                                                    let _e2190 = select(f64(1f), f64(-1f), (_e2161 < f64(0f)));
                                                    let _e2194 = f64(1f);
                                                    let _e2195 = f64(2f);
                                                    let _e2213 = (((((_e1873 * _e2107) + (_e1887 * _e2093)) * f64(2.01f)) + (((_e1887 * _e2195) * (_e2107 * _e2195)) * (1.1102230246251565e-16lf * _e2195))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2194 + _e1887) * (_e2194 + _e2107))));
                                                    let _e2217 = f64(1f);
                                                    let _e2218 = f64(2f);
                                                    let _e2236 = (((((_e1983 * _e1887) + (_e1997 * _e1873)) * f64(2.01f)) + (((_e1997 * _e2218) * (_e1887 * _e2218)) * (1.1102230246251565e-16lf * _e2218))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2217 + _e1997) * (_e2217 + _e1887))));
                                                    let _e2237 = (_e2161 * _e2190);
                                                    let _e2238 = (((_e2149 * _e2158) - (_e2150 * _e2157)) * _e2190);
                                                    let _e2239 = (((_e2153 * _e2150) - (_e2154 * _e2149)) * _e2190);
                                                    let _e2253 = (((select(_e2237, -(_e2237), (_e2237 < 0.0lf)) + select(_e2238, -(_e2238), (_e2238 < 0.0lf))) + select(_e2239, -(_e2239), (_e2239 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e223.member != 0u) {
                                                        phi_3438_ = array<type_35, 4>(type_35(_e2238, _e2213), type_35(_e2239, _e2236), type_35((_e2237 - _e2238), ((_e2181 + _e2213) + _e2253)), type_35((_e2237 - _e2239), ((_e2181 + _e2236) + _e2253)));
                                                    } else {
                                                        let _e2256 = ((_e2237 - _e2238) - _e2239);
                                                        let _e2259 = (((_e2181 + _e2213) + _e2236) + _e2253);
                                                        phi_3438_ = array<type_35, 4>(type_35(_e2238, _e2213), type_35(_e2239, _e2236), type_35(_e2256, _e2259), type_35(_e2256, _e2259));
                                                    }
                                                    let _e2277 = phi_3438_;
                                                    local_1 = array<type_35, 4>(type_35(_e2277[0].member, _e2277[0].member_1), type_35(_e2277[1].member, _e2277[1].member_1), type_35(_e2277[2].member, _e2277[2].member_1), type_35(_e2277[3].member, _e2277[3].member_1));
                                                    phi_3458_ = type_9(0u, 4u);
                                                    phi_3461_ = true;
                                                    loop {
                                                        let _e2296 = phi_3458_;
                                                        let _e2298 = phi_3461_;
                                                        local_17 = _e2298;
                                                        let _e2301 = (_e2296.member < _e2296.member_1);
                                                        let _e2312 = select(type_9().member_1, _e2296.member, _e2301);
                                                        if (bitcast<i32>(select(0u, 1u, _e2301)) != 0i) {
                                                            let _e2317 = local_1[_e2312].member;
                                                            let _e2320 = local_1[_e2312].member_1;
                                                            let _e2322 = (_e2317 < -(_e2320));
                                                            phi_3462_ = select((_e2298 && (_e2317 > _e2320)), bool(), _e2322);
                                                            phi_3513_ = select(true, false, _e2322);
                                                            phi_3514_ = _e2322;
                                                        } else {
                                                            phi_3462_ = bool();
                                                            phi_3513_ = false;
                                                            phi_3514_ = false;
                                                        }
                                                        let _e2328 = phi_3462_;
                                                        let _e2330 = phi_3513_;
                                                        let _e2332 = phi_3514_;
                                                        local_16 = _e2332;
                                                        continue;
                                                        continuing {
                                                            phi_3458_ = type_9(select(_e2296.member, (_e2296.member + 1u), _e2301), select(_e2296.member_1, _e2296.member_1, _e2301));
                                                            phi_3461_ = _e2328;
                                                            break if !(_e2330);
                                                        }
                                                    }
                                                    let _e2335 = local_16;
                                                    let _e2336 = select(true, false, _e2335);
                                                    let _e2338 = local_17;
                                                    phi_3528_ = select(u32(), select(2u, 1u, _e2338), _e2336);
                                                    phi_3529_ = 0u;
                                                    phi_3530_ = select(true, false, _e2336);
                                                } else {
                                                    phi_3528_ = u32();
                                                    phi_3529_ = 2u;
                                                    phi_3530_ = true;
                                                }
                                                let _e2343 = phi_3528_;
                                                let _e2345 = phi_3529_;
                                                let _e2347 = phi_3530_;
                                                let _e2348 = select(_e2343, _e2345, _e2347);
                                                let _e2349 = (_e2348 == 0u);
                                                phi_3540_ = _e2348;
                                                phi_3541_ = _e2349;
                                                phi_3542_ = select(true, false, _e2349);
                                            }
                                            let _e2352 = phi_3540_;
                                            let _e2354 = phi_3541_;
                                            let _e2356 = phi_3542_;
                                            phi_3543_ = _e2352;
                                            phi_3544_ = _e2354;
                                            phi_3545_ = _e1768;
                                            phi_3546_ = _e2356;
                                        }
                                        let _e2358 = phi_3543_;
                                        let _e2360 = phi_3544_;
                                        let _e2362 = phi_3545_;
                                        let _e2364 = phi_3546_;
                                        phi_3547_ = _e1763;
                                        phi_3548_ = _e2358;
                                        phi_3549_ = _e2360;
                                        phi_3550_ = _e2362;
                                        phi_3551_ = _e2364;
                                    }
                                    let _e2366 = phi_3547_;
                                    let _e2368 = phi_3548_;
                                    let _e2370 = phi_3549_;
                                    let _e2372 = phi_3550_;
                                    let _e2374 = phi_3551_;
                                    phi_3552_ = _e2366;
                                    phi_3553_ = _e2368;
                                    phi_3554_ = _e2370;
                                    phi_3555_ = _e1428;
                                    phi_3556_ = _e2372;
                                    phi_3557_ = _e2374;
                                } else {
                                    phi_3552_ = type_43();
                                    phi_3553_ = u32();
                                    phi_3554_ = true;
                                    phi_3555_ = false;
                                    phi_3556_ = false;
                                    phi_3557_ = false;
                                }
                                let _e2376 = phi_3552_;
                                let _e2378 = phi_3553_;
                                let _e2380 = phi_3554_;
                                let _e2382 = phi_3555_;
                                let _e2384 = phi_3556_;
                                let _e2386 = phi_3557_;
                                phi_3564_ = _e2376;
                                phi_3565_ = _e2378;
                                phi_3566_ = _e2380;
                                phi_3567_ = select(_e2382, false, _e2380);
                                phi_3568_ = select(_e2384, false, _e2380);
                                phi_3569_ = select(_e2386, false, _e2380);
                                phi_3570_ = false;
                            } else {
                                phi_3564_ = type_43();
                                phi_3565_ = u32();
                                phi_3566_ = false;
                                phi_3567_ = false;
                                phi_3568_ = false;
                                phi_3569_ = false;
                                phi_3570_ = true;
                            }
                            let _e2391 = phi_3564_;
                            let _e2393 = phi_3565_;
                            let _e2395 = phi_3566_;
                            let _e2397 = phi_3567_;
                            let _e2399 = phi_3568_;
                            let _e2401 = phi_3569_;
                            let _e2403 = phi_3570_;
                            phi_3571_ = _e2391;
                            phi_3572_ = _e2393;
                            phi_3573_ = type_43(_e526, _e526, false);
                            phi_3574_ = _e2395;
                            phi_3575_ = false;
                            phi_3576_ = _e2397;
                            phi_3577_ = _e2399;
                            phi_3578_ = _e2401;
                            phi_3579_ = _e2403;
                        } else {
                            phi_3571_ = type_43();
                            phi_3572_ = u32();
                            phi_3573_ = type_43();
                            phi_3574_ = false;
                            phi_3575_ = true;
                            phi_3576_ = false;
                            phi_3577_ = false;
                            phi_3578_ = false;
                            phi_3579_ = false;
                        }
                        let _e2405 = phi_3571_;
                        let _e2407 = phi_3572_;
                        let _e2409 = phi_3573_;
                        let _e2411 = phi_3574_;
                        let _e2413 = phi_3575_;
                        let _e2415 = phi_3576_;
                        let _e2417 = phi_3577_;
                        let _e2419 = phi_3578_;
                        let _e2421 = phi_3579_;
                        local_18 = _e2413;
                        local_19 = _e2413;
                        local_20 = _e2413;
                        local_21 = _e2415;
                        local_22 = _e2413;
                        local_23 = _e2417;
                        local_24 = _e2413;
                        local_25 = _e2419;
                        local_26 = _e2413;
                        local_27 = _e2421;
                        local_28 = _e2407;
                        local_29 = _e2405;
                        local_30 = _e2405;
                        local_31 = _e2405;
                        local_32 = _e2405;
                        local_33 = _e2409;
                        local_34 = _e2405;
                        continue;
                        continuing {
                            phi_2227_ = type_9(select(_e1399.member, (_e1399.member + 1u), _e1402), select(_e1399.member_1, _e1399.member_1, _e1402));
                            break if !(_e2411);
                        }
                    }
                    let _e2425 = local_18;
                    let _e2430 = local_19;
                    let _e2434 = local_20;
                    let _e2436 = local_21;
                    let _e2437 = select(_e2436, false, _e2434);
                    let _e2439 = local_22;
                    let _e2441 = local_23;
                    let _e2444 = local_24;
                    let _e2446 = local_25;
                    let _e2449 = local_26;
                    let _e2451 = local_27;
                    let _e2458 = select(select(_e2441, false, _e2439), false, _e2437);
                    if select(select(select(_e2446, false, _e2444), false, _e2437), false, _e2458) {
                        let _e2469 = local_28;
                        let _e2472 = local_29;
                        if select(false, _e2472.member_2, (_e2469 == 1u)) {
                            let _e2476 = local_30;
                            let _e2479 = local_31;
                            let _e2482 = ((_e2476.member_1 - _e2479.member) <= (_e517 * f64(0.99f)));
                            let _e2484 = local_32;
                            phi_3628_ = type_42(select(type_42().member, 1u, _e2482), select(type_42().member_1, _e2484.member, _e2482));
                            phi_3629_ = select(true, false, _e2482);
                        } else {
                            phi_3628_ = type_42();
                            phi_3629_ = true;
                        }
                        let _e2493 = phi_3628_;
                        let _e2495 = phi_3629_;
                        phi_3634_ = _e2493;
                        phi_3635_ = select(true, false, _e2495);
                        phi_3636_ = false;
                        phi_3637_ = _e2495;
                    } else {
                        phi_3634_ = type_42(select(select(type_42().member, 0u, _e2437), 0u, _e2458), select(select(type_42().member_1, type_42().member_1, _e2437), type_42().member_1, _e2458));
                        phi_3635_ = select(_e2437, true, _e2458);
                        phi_3636_ = select(select(select(_e2451, false, _e2449), false, _e2437), false, _e2458);
                        phi_3637_ = false;
                    }
                    let _e2498 = phi_3634_;
                    let _e2500 = phi_3635_;
                    let _e2502 = phi_3636_;
                    let _e2504 = phi_3637_;
                    let _e2505 = select(_e2502, false, _e2500);
                    let _e2508 = local_33;
                    let _e2511 = local_34;
                    let _e2514 = select(select(_e2504, false, _e2500), true, _e2505);
                    phi_3659_ = type_42(select(_e2498.member, 2u, _e2514), select(_e2498.member_1, select(_e2511.member, _e2508.member, _e2505), _e2514));
                    phi_3660_ = type_42(select(type_42().member, 0u, _e2425), select(type_42().member_1, type_42().member_1, _e2430));
                    phi_3661_ = select(select(_e2500, false, _e2505), true, _e2514);
                }
                let _e2525 = phi_3659_;
                let _e2527 = phi_3660_;
                let _e2529 = phi_3661_;
                let _e2532 = select(_e2527.member, _e2525.member, _e2529);
                let _e2535 = select(_e2527.member_1, _e2525.member_1, _e2529);
                let _e2541 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e2535 > _e526)), (_e2532 == 1u))));
                switch bitcast<i32>(_e2532) {
                    case 0: {
                        phi_3705_ = type_34(0u, _e2541, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e2545 = function_1(_e2535);
                        phi_3705_ = type_34(0u, _e2541, _e2545, true);
                        break;
                    }
                    case 2: {
                        let _e2543 = function_1(_e2535);
                        phi_3705_ = type_34(1u, _e2541, _e2543, true);
                        break;
                    }
                    default: {
                        phi_3705_ = type_34();
                        break;
                    }
                }
                let _e2549 = phi_3705_;
                local_6 = type_34(_e2549.member, _e2549.member_1, array<u32, 2>(_e2549.member_2[0], _e2549.member_2[1]), _e2549.member_3);
                phi_3714_ = type_9(_e181, _e184);
            } else {
                phi_3714_ = type_9(0u, 0u);
            }
            let _e2559 = phi_3714_;
            let _e2565 = params.member.member_2.member;
            let _e2568 = local_6.member;
            let _e2569 = (_e2568 == 0u);
            let _e2572 = select(select((_e2565 > 0u), bool(), _e2569), false, _e2569);
            if _e2572 {
                local = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e2573 = local_6;
                local = _e2573;
            }
            let _e2575 = local.member;
            let _e2577 = select(true, false, (_e2575 == 0u));
            let _e2579 = local.member_3;
            if _e2579 {
                if _e2577 {
                    phi_3771_ = true;
                } else {
                    let _e2581 = params.member.member.member_1;
                    phi_3771_ = ((_e2581 & 16u) != 0u);
                }
                let _e2585 = phi_3771_;
                phi_3772_ = _e2585;
            } else {
                phi_3772_ = false;
            }
            let _e2587 = phi_3772_;
            let _e2589 = local.member_3;
            if _e2589 {
                if _e2577 {
                } else {
                    let _e2591 = local.member_2;
                    let _e2595 = (_e2591[1] >> bitcast<u32>(20i));
                    let _e2609 = atomicMin((&earliest.member[0u]), select(((((_e2595 - 896u) << bitcast<u32>(23i)) | ((_e2591[1] & 1048575u) << bitcast<u32>(3i))) | (_e2591[0] >> bitcast<u32>(29i))), 0u, (_e2595 <= 896u)));
                }
            }
            if (_e98 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2587 {
                let _e2613 = atomicAdd((&counters[0u]), 1u);
                phi_3815_ = _e2613;
            } else {
                phi_3815_ = 0u;
            }
            let _e2615 = phi_3815_;
            workgroupBarrier();
            if (_e98 == 0u) {
                let _e2618 = atomicLoad((&counters[0u]));
                if (_e2618 > 0u) {
                    let _e2621 = atomicAdd((&contacts.member[0u]), _e2618);
                    atomicStore((&counters[1u]), _e2621);
                }
            }
            workgroupBarrier();
            let _e2624 = atomicLoad((&counters[1u]));
            let _e2625 = (_e2624 + _e2615);
            if _e2587 {
                let _e2627 = params.member.member_1.member_3;
                if (_e2625 < _e2627) {
                    let _e2633 = (7u * _e2625);
                    atomicStore((&contacts.member[(4u + _e2633)]), select(1u, 0u, ((_e2559.member_1 & 2147483648u) == 0u)));
                    let _e2638 = local.member;
                    atomicStore((&contacts.member[(_e2633 + 5u)]), _e2638);
                    atomicStore((&contacts.member[(_e2633 + 6u)]), _e2559.member);
                    atomicStore((&contacts.member[(_e2633 + 7u)]), (_e2559.member_1 & 2147483647u));
                    let _e2647 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e2633 + 8u)]), _e2647);
                    let _e2652 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e2633 + 9u)]), _e2652);
                    let _e2656 = local.member_1;
                    atomicStore((&contacts.member[(_e2633 + 10u)]), _e2656);
                }
            }
            workgroupBarrier();
            if (_e98 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2572 {
                let _e2661 = atomicAdd((&counters[0u]), 1u);
                phi_3897_ = _e2661;
            } else {
                phi_3897_ = 0u;
            }
            let _e2663 = phi_3897_;
            workgroupBarrier();
            if (_e98 == 0u) {
                let _e2666 = atomicLoad((&counters[0u]));
                if (_e2666 > 0u) {
                    let _e2669 = atomicAdd((&left.member[0u]), _e2666);
                    atomicStore((&counters[1u]), _e2669);
                }
            }
            workgroupBarrier();
            let _e2672 = atomicLoad((&counters[1u]));
            let _e2673 = (_e2672 + _e2663);
            if _e2572 {
                if (_e2673 < _e2565) {
                    let _e2675 = (2u * _e2673);
                    atomicStore((&left.member[(4u + _e2675)]), _e2559.member);
                    atomicStore((&left.member[(_e2675 + 5u)]), _e2559.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_423_ = type_9(select(_e152.member, (_e152.member + 1u), _e155), select(_e152.member_1, _e152.member_1, _e155));
            break if !(_e168);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
