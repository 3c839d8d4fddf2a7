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

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_36 {
    member: type_33,
    member_1: f64,
}

struct type_37 {
    member: u32,
    member_1: f64,
}

struct type_38 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_42 {
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
var<storage, read_write> contacts: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_223_: f64;
    var phi_266_: f64;
    var phi_309_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_223_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_223_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_223_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_266_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_266_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_266_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_309_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_309_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_309_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f64, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_4784_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e163 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_4[0] - param_6[0]);
        let _e272 = (param_4[1] - param_6[1]);
        let _e275 = (param_4[2] - param_6[2]);
        let _e295 = ((((_e269 * param_5[0]) + (_e272 * param_5[1])) + (_e275 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_4784_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_4784_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_4784_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_4383_: bool;
    var phi_4417_: array<f64, 3>;
    var phi_4418_: bool;
    var phi_4419_: array<f64, 3>;
    var phi_4420_: bool;
    var phi_4425_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_4383_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_4383_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_4383_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_4417_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_4418_ = false;
        } else {
            phi_4417_ = array<f64, 3>();
            phi_4418_ = true;
        }
        let _e132 = phi_4417_;
        let _e134 = phi_4418_;
        phi_4419_ = _e132;
        phi_4420_ = _e134;
    } else {
        phi_4419_ = array<f64, 3>();
        phi_4420_ = true;
    }
    let _e136 = phi_4419_;
    let _e138 = phi_4420_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_4425_ = _e139;
    } else {
        phi_4425_ = _e136;
    }
    let _e141 = phi_4425_;
    return _e141;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_38;
    var local_1: type_38;
    var local_2: type_33;
    var local_3: type_35;
    var phi_372_: u32;
    var phi_417_: u32;
    var phi_420_: type_9;
    var phi_594_: type_23;
    var phi_790_: type_31;
    var phi_951_: type_33;
    var phi_1217_: bool;
    var phi_1313_: type_36;
    var phi_1314_: bool;
    var phi_1315_: type_36;
    var phi_1316_: bool;
    var phi_1317_: type_36;
    var phi_1318_: bool;
    var phi_1323_: type_36;
    var phi_1786_: type_9;
    var phi_1789_: f64;
    var phi_1791_: f64;
    var phi_1793_: f64;
    var phi_1795_: f64;
    var phi_1797_: bool;
    var phi_1799_: u32;
    var phi_1951_: array<f64, 3>;
    var phi_2019_: type_16;
    var phi_2022_: f64;
    var phi_2020_: type_16;
    var phi_2063_: type_17;
    var phi_2023_: f64;
    var local_4: f64;
    var phi_2076_: f64;
    var phi_2202_: type_38;
    var phi_2203_: bool;
    var phi_2204_: type_38;
    var phi_2205_: bool;
    var phi_2215_: type_38;
    var phi_2387_: bool;
    var phi_2388_: bool;
    var phi_2389_: bool;
    var phi_2390_: bool;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2694_: bool;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var phi_2707_: bool;
    var phi_2817_: f64;
    var phi_2818_: bool;
    var phi_2819_: f64;
    var phi_2820_: bool;
    var phi_2821_: f64;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2889_: f64;
    var phi_2890_: bool;
    var phi_2891_: f64;
    var phi_2892_: bool;
    var phi_2893_: f64;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2966_: f64;
    var phi_2967_: bool;
    var phi_2968_: f64;
    var phi_2969_: bool;
    var phi_2970_: f64;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_3038_: f64;
    var phi_3039_: bool;
    var phi_3040_: f64;
    var phi_3041_: bool;
    var phi_3042_: f64;
    var phi_3043_: bool;
    var phi_3044_: bool;
    var phi_3221_: type_16;
    var phi_3224_: f64;
    var phi_3222_: type_16;
    var phi_3265_: type_17;
    var phi_3225_: f64;
    var local_5: f64;
    var phi_3278_: f64;
    var phi_3555_: bool;
    var phi_3556_: bool;
    var phi_3583_: f64;
    var phi_3584_: f64;
    var phi_3585_: bool;
    var phi_3586_: f64;
    var phi_3587_: f64;
    var phi_3588_: bool;
    var phi_3589_: bool;
    var phi_3590_: f64;
    var phi_3591_: f64;
    var phi_3592_: f64;
    var phi_3593_: f64;
    var phi_3594_: bool;
    var phi_3595_: bool;
    var phi_3596_: bool;
    var phi_3597_: bool;
    var phi_3598_: f64;
    var phi_3599_: f64;
    var phi_3600_: f64;
    var phi_3601_: f64;
    var phi_3602_: bool;
    var phi_3603_: bool;
    var phi_3604_: bool;
    var phi_3605_: bool;
    var phi_3606_: bool;
    var phi_3607_: f64;
    var phi_3608_: f64;
    var phi_3609_: f64;
    var phi_3610_: f64;
    var phi_3611_: bool;
    var phi_3612_: bool;
    var phi_3613_: bool;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3953_: f64;
    var phi_3955_: u32;
    var phi_3956_: f64;
    var phi_3957_: bool;
    var phi_3958_: bool;
    var phi_3959_: bool;
    var phi_3960_: u32;
    var phi_3961_: f64;
    var phi_3962_: f64;
    var phi_3963_: f64;
    var phi_3964_: f64;
    var phi_3965_: bool;
    var phi_3966_: u32;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3970_: bool;
    var phi_3971_: bool;
    var phi_3972_: bool;
    var phi_4000_: f64;
    var phi_4001_: f64;
    var phi_4002_: f64;
    var phi_4003_: f64;
    var phi_4004_: bool;
    var phi_4005_: u32;
    var phi_4006_: bool;
    var phi_4007_: bool;
    var phi_4008_: bool;
    var phi_4009_: bool;
    var phi_4010_: bool;
    var phi_4011_: bool;
    var phi_1790_: f64;
    var phi_1792_: f64;
    var phi_1794_: f64;
    var phi_1796_: f64;
    var phi_1798_: bool;
    var phi_1800_: u32;
    var phi_4012_: f64;
    var phi_4013_: f64;
    var phi_4014_: bool;
    var phi_4015_: bool;
    var phi_4016_: bool;
    var phi_4017_: bool;
    var phi_4018_: bool;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f64;
    var local_17: bool;
    var local_18: f64;
    var local_19: f64;
    var local_20: f64;
    var phi_4111_: type_35;
    var phi_4120_: type_9;
    var phi_4149_: bool;
    var phi_4150_: bool;
    var phi_4193_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e86 = id_2;
    let _e87 = n_2;
    let _e88 = lane_2;
    let _e100 = ((_e86.y * _e87.x) + _e86.x);
    let _e103 = (_e87.x * _e87.y);
    let _e106 = params.member.member_1.member_2;
    let _e108 = input.member[0u];
    let _e110 = select(_e108, _e106, (_e106 < _e108));
    let _e112 = params.member.member_1.member_1;
    if (_e110 > _e112) {
        let _e115 = params.member.member_1.member_1;
        phi_372_ = (_e110 - _e115);
    } else {
        phi_372_ = 0u;
    }
    let _e118 = phi_372_;
    let _e120 = params.member.member_1.member;
    let _e122 = select(_e118, _e120, (_e120 < _e118));
    let _e123 = (_e122 / 64u);
    let _e127 = select(_e123, (_e123 + 1u), ((_e122 % 64u) > 0u));
    if (_e127 > _e100) {
        let _e129 = (_e127 - _e100);
        if (_e103 == 0u) {
            return;
        }
        let _e131 = (_e129 / _e103);
        if (_e103 == 0u) {
            return;
        }
        phi_417_ = select(_e131, (_e131 + 1u), ((_e129 % _e103) > 0u));
    } else {
        phi_417_ = 0u;
    }
    let _e138 = phi_417_;
    phi_420_ = type_9(0u, _e138);
    loop {
        let _e141 = phi_420_;
        let _e144 = (_e141.member < _e141.member_1);
        let _e157 = (bitcast<i32>(select(0u, 1u, _e144)) != 0i);
        if _e157 {
            let _e161 = (((_e100 + (select(type_9().member_1, _e141.member, _e144) * _e103)) * 64u) + _e88);
            local_3 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e161 < _e122) {
                let _e165 = params.member.member_1.member_1;
                let _e167 = (2u * (_e165 + _e161));
                let _e170 = input.member[(4u + _e167)];
                let _e173 = input.member[(_e167 + 5u)];
                let _e178 = (_e173 & 2147483647u);
                if (select(1u, 0u, ((_e173 & 2147483648u) == 0u)) == 0u) {
                    let _e197 = params.member.member.member[1u];
                    let _e200 = ((2u * _e197) + (3u * _e178));
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    let _e208 = elements.member[(_e200 + 2u)];
                    phi_594_ = type_23(0u, array<u32, 4>(_e170, _e202, _e205, _e208));
                } else {
                    let _e181 = (2u * _e170);
                    let _e183 = elements.member[_e181];
                    let _e186 = elements.member[(_e181 + 1u)];
                    let _e187 = (2u * _e178);
                    let _e189 = elements.member[_e187];
                    let _e192 = elements.member[(_e187 + 1u)];
                    phi_594_ = type_23(1u, array<u32, 4>(_e183, _e186, _e189, _e192));
                }
                let _e212 = phi_594_;
                let _e216 = params.member.member.member_1;
                if ((_e216 & 8u) != 0u) {
                    let _e260 = paths.member[_e212.member_1[0]];
                    let _e275 = paths.member[_e212.member_1[1]];
                    let _e290 = paths.member[_e212.member_1[2]];
                    let _e305 = paths.member[_e212.member_1[3]];
                    let _e326 = function_(array<f32, 3>(_e260.member.x, _e260.member.y, _e260.member.z));
                    let _e327 = function_(array<f32, 3>(_e275.member.x, _e275.member.y, _e275.member.z));
                    let _e328 = function_(array<f32, 3>(_e290.member.x, _e290.member.y, _e290.member.z));
                    let _e329 = function_(array<f32, 3>(_e305.member.x, _e305.member.y, _e305.member.z));
                    let _e331 = function_(array<f32, 3>(_e260.member_1.x, _e260.member_1.y, _e260.member_1.z));
                    let _e332 = function_(array<f32, 3>(_e275.member_1.x, _e275.member_1.y, _e275.member_1.z));
                    let _e333 = function_(array<f32, 3>(_e290.member_1.x, _e290.member_1.y, _e290.member_1.z));
                    let _e334 = function_(array<f32, 3>(_e305.member_1.x, _e305.member_1.y, _e305.member_1.z));
                    phi_790_ = type_31(array<array<f64, 3>, 4>(_e326, _e327, _e328, _e329), array<array<f64, 3>, 4>(_e331, _e332, _e333, _e334));
                } else {
                    let _e221 = positions.member[_e212.member_1[0]];
                    let _e224 = params.member.member.member[0u];
                    let _e227 = positions.member[(_e224 + _e212.member_1[0])];
                    let _e230 = positions.member[_e212.member_1[1]];
                    let _e233 = params.member.member.member[0u];
                    let _e236 = positions.member[(_e233 + _e212.member_1[1])];
                    let _e239 = positions.member[_e212.member_1[2]];
                    let _e242 = params.member.member.member[0u];
                    let _e245 = positions.member[(_e242 + _e212.member_1[2])];
                    let _e248 = positions.member[_e212.member_1[3]];
                    let _e251 = params.member.member.member[0u];
                    let _e254 = positions.member[(_e251 + _e212.member_1[3])];
                    phi_790_ = type_31(array<array<f64, 3>, 4>(_e221, _e230, _e239, _e248), array<array<f64, 3>, 4>(_e227, _e236, _e245, _e254));
                }
                let _e338 = phi_790_;
                if (_e212.member != 0u) {
                    phi_951_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[2][0] - _e338.member[0][0]), (_e338.member[2][1] - _e338.member[0][1]), (_e338.member[2][2] - _e338.member[0][2])), array<f64, 3>((_e338.member_1[2][0] - _e338.member_1[0][0]), (_e338.member_1[2][1] - _e338.member_1[0][1]), (_e338.member_1[2][2] - _e338.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[1][0] - _e338.member[0][0]), (_e338.member[1][1] - _e338.member[0][1]), (_e338.member[1][2] - _e338.member[0][2])), array<f64, 3>((_e338.member_1[1][0] - _e338.member_1[0][0]), (_e338.member_1[1][1] - _e338.member_1[0][1]), (_e338.member_1[1][2] - _e338.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[2][0] - _e338.member[3][0]), (_e338.member[2][1] - _e338.member[3][1]), (_e338.member[2][2] - _e338.member[3][2])), array<f64, 3>((_e338.member_1[2][0] - _e338.member_1[3][0]), (_e338.member_1[2][1] - _e338.member_1[3][1]), (_e338.member_1[2][2] - _e338.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_951_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[0][0] - _e338.member[1][0]), (_e338.member[0][1] - _e338.member[1][1]), (_e338.member[0][2] - _e338.member[1][2])), array<f64, 3>((_e338.member_1[0][0] - _e338.member_1[1][0]), (_e338.member_1[0][1] - _e338.member_1[1][1]), (_e338.member_1[0][2] - _e338.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[2][0] - _e338.member[1][0]), (_e338.member[2][1] - _e338.member[1][1]), (_e338.member[2][2] - _e338.member[1][2])), array<f64, 3>((_e338.member_1[2][0] - _e338.member_1[1][0]), (_e338.member_1[2][1] - _e338.member_1[1][1]), (_e338.member_1[2][2] - _e338.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e338.member[3][0] - _e338.member[1][0]), (_e338.member[3][1] - _e338.member[1][1]), (_e338.member[3][2] - _e338.member[1][2])), array<f64, 3>((_e338.member_1[3][0] - _e338.member_1[1][0]), (_e338.member_1[3][1] - _e338.member_1[1][1]), (_e338.member_1[3][2] - _e338.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e497 = phi_951_;
                let _e499 = params.member.member.member_14;
                let _e506 = bitcast<f64>(((u64(_e499[1]) * 4294967296lu) + u64(_e499[0])));
                let _e508 = params.member.member.member_15;
                let _e515 = bitcast<f64>(((u64(_e508[1]) * 4294967296lu) + u64(_e508[0])));
                let _e517 = params.member.member.member_16;
                let _e524 = bitcast<f64>(((u64(_e517[1]) * 4294967296lu) + u64(_e517[0])));
                let _e525 = f64(0f);
                let _e531 = select(_e497.member[0][0], -(_e497.member[0][0]), (_e497.member[0][0] < 0.0lf));
                let _e535 = select(_e497.member[0][1], -(_e497.member[0][1]), (_e497.member[0][1] < 0.0lf));
                let _e537 = select(_e535, _e531, (_e531 > _e535));
                let _e541 = select(_e497.member[0][2], -(_e497.member[0][2]), (_e497.member[0][2] < 0.0lf));
                let _e543 = select(_e541, _e537, (_e537 > _e541));
                let _e549 = select(_e497.member[1][0], -(_e497.member[1][0]), (_e497.member[1][0] < 0.0lf));
                let _e553 = select(_e497.member[1][1], -(_e497.member[1][1]), (_e497.member[1][1] < 0.0lf));
                let _e555 = select(_e553, _e549, (_e549 > _e553));
                let _e559 = select(_e497.member[1][2], -(_e497.member[1][2]), (_e497.member[1][2] < 0.0lf));
                let _e561 = select(_e559, _e555, (_e555 > _e559));
                let _e565 = (select(_e561, _e543, (_e543 > _e561)) + _e497.member_3);
                let _e571 = select(_e497.member_1[0][0], -(_e497.member_1[0][0]), (_e497.member_1[0][0] < 0.0lf));
                let _e575 = select(_e497.member_1[0][1], -(_e497.member_1[0][1]), (_e497.member_1[0][1] < 0.0lf));
                let _e577 = select(_e575, _e571, (_e571 > _e575));
                let _e581 = select(_e497.member_1[0][2], -(_e497.member_1[0][2]), (_e497.member_1[0][2] < 0.0lf));
                let _e583 = select(_e581, _e577, (_e577 > _e581));
                let _e589 = select(_e497.member_1[1][0], -(_e497.member_1[1][0]), (_e497.member_1[1][0] < 0.0lf));
                let _e593 = select(_e497.member_1[1][1], -(_e497.member_1[1][1]), (_e497.member_1[1][1] < 0.0lf));
                let _e595 = select(_e593, _e589, (_e589 > _e593));
                let _e599 = select(_e497.member_1[1][2], -(_e497.member_1[1][2]), (_e497.member_1[1][2] < 0.0lf));
                let _e601 = select(_e599, _e595, (_e595 > _e599));
                let _e605 = (select(_e601, _e583, (_e583 > _e601)) + _e497.member_3);
                let _e611 = select(_e497.member_2[0][0], -(_e497.member_2[0][0]), (_e497.member_2[0][0] < 0.0lf));
                let _e615 = select(_e497.member_2[0][1], -(_e497.member_2[0][1]), (_e497.member_2[0][1] < 0.0lf));
                let _e617 = select(_e615, _e611, (_e611 > _e615));
                let _e621 = select(_e497.member_2[0][2], -(_e497.member_2[0][2]), (_e497.member_2[0][2] < 0.0lf));
                let _e623 = select(_e621, _e617, (_e617 > _e621));
                let _e629 = select(_e497.member_2[1][0], -(_e497.member_2[1][0]), (_e497.member_2[1][0] < 0.0lf));
                let _e633 = select(_e497.member_2[1][1], -(_e497.member_2[1][1]), (_e497.member_2[1][1] < 0.0lf));
                let _e635 = select(_e633, _e629, (_e629 > _e633));
                let _e639 = select(_e497.member_2[1][2], -(_e497.member_2[1][2]), (_e497.member_2[1][2] < 0.0lf));
                let _e641 = select(_e639, _e635, (_e635 > _e639));
                let _e645 = (select(_e641, _e623, (_e623 > _e641)) + _e497.member_3);
                let _e647 = select(_e605, _e565, (_e565 > _e605));
                let _e649 = select(_e645, _e647, (_e647 > _e645));
                if (_e649 <= f64(65536f)) {
                    phi_1217_ = (_e649 >= f64((1f / 65536f)));
                } else {
                    phi_1217_ = false;
                }
                let _e656 = phi_1217_;
                if _e656 {
                    phi_1317_ = type_36();
                    phi_1318_ = true;
                } else {
                    if (_e649 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e649) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e663 = (9214364837600034816lu - (bitcast<u64>(_e649) & 9218868437227405312lu));
                            let _e666 = bitcast<f64>(select(4503599627370496lu, _e663, (_e663 > 4503599627370496lu)));
                            let _e667 = (_e525 * _e666);
                            phi_1313_ = type_36(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e497.member[0][0] * _e666), (_e497.member[0][1] * _e666), (_e497.member[0][2] * _e666)), array<f64, 3>((_e497.member[1][0] * _e666), (_e497.member[1][1] * _e666), (_e497.member[1][2] * _e666))), array<array<f64, 3>, 2>(array<f64, 3>((_e497.member_1[0][0] * _e666), (_e497.member_1[0][1] * _e666), (_e497.member_1[0][2] * _e666)), array<f64, 3>((_e497.member_1[1][0] * _e666), (_e497.member_1[1][1] * _e666), (_e497.member_1[1][2] * _e666))), array<array<f64, 3>, 2>(array<f64, 3>((_e497.member_2[0][0] * _e666), (_e497.member_2[0][1] * _e666), (_e497.member_2[0][2] * _e666)), array<f64, 3>((_e497.member_2[1][0] * _e666), (_e497.member_2[1][1] * _e666), (_e497.member_2[1][2] * _e666))), ((_e497.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e666)), select(_e667, select(2.2250738585072014e-308lf, _e667, (_e667 > 2.2250738585072014e-308lf)), (_e525 > f64(0f))));
                            phi_1314_ = false;
                        } else {
                            phi_1313_ = type_36();
                            phi_1314_ = true;
                        }
                        let _e738 = phi_1313_;
                        let _e740 = phi_1314_;
                        phi_1315_ = _e738;
                        phi_1316_ = _e740;
                    } else {
                        phi_1315_ = type_36();
                        phi_1316_ = true;
                    }
                    let _e742 = phi_1315_;
                    let _e744 = phi_1316_;
                    phi_1317_ = _e742;
                    phi_1318_ = _e744;
                }
                let _e746 = phi_1317_;
                let _e748 = phi_1318_;
                if _e748 {
                    phi_1323_ = type_36(_e497, _e525);
                } else {
                    phi_1323_ = _e746;
                }
                let _e751 = phi_1323_;
                local_2 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e751.member.member[0][0], _e751.member.member[0][1], _e751.member.member[0][2]), array<f64, 3>(_e751.member.member[1][0], _e751.member.member[1][1], _e751.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e751.member.member_1[0][0], _e751.member.member_1[0][1], _e751.member.member_1[0][2]), array<f64, 3>(_e751.member.member_1[1][0], _e751.member.member_1[1][1], _e751.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e751.member.member_2[0][0], _e751.member.member_2[0][1], _e751.member.member_2[0][2]), array<f64, 3>(_e751.member.member_2[1][0], _e751.member.member_2[1][1], _e751.member.member_2[1][2])), _e751.member.member_3);
                let _e793 = local_2.member[0u];
                let _e799 = local_2.member_1[0u];
                let _e805 = local_2.member_2[0u];
                let _e809 = (_e793[0] - _e799[0]);
                let _e810 = (_e793[1] - _e799[1]);
                let _e811 = (_e793[2] - _e799[2]);
                let _e812 = (_e212.member == 0u);
                let _e824 = local_2.member[1u];
                let _e830 = local_2.member_1[1u];
                let _e836 = local_2.member_2[1u];
                let _e840 = (_e824[0] - _e830[0]);
                let _e841 = (_e824[1] - _e830[1]);
                let _e842 = (_e824[2] - _e830[2]);
                let _e843 = (_e212.member == 0u);
                let _e855 = local_2.member[0u];
                let _e861 = select(_e855[0], -(_e855[0]), (_e855[0] < 0.0lf));
                let _e864 = select(_e855[1], -(_e855[1]), (_e855[1] < 0.0lf));
                let _e866 = select(_e864, _e861, (_e861 > _e864));
                let _e869 = select(_e855[2], -(_e855[2]), (_e855[2] < 0.0lf));
                let _e871 = select(_e869, _e866, (_e866 > _e869));
                let _e874 = local_2.member[1u];
                let _e880 = select(_e874[0], -(_e874[0]), (_e874[0] < 0.0lf));
                let _e883 = select(_e874[1], -(_e874[1]), (_e874[1] < 0.0lf));
                let _e885 = select(_e883, _e880, (_e880 > _e883));
                let _e888 = select(_e874[2], -(_e874[2]), (_e874[2] < 0.0lf));
                let _e890 = select(_e888, _e885, (_e885 > _e888));
                let _e894 = local_2.member_3;
                let _e898 = local_2.member_1[0u];
                let _e904 = select(_e898[0], -(_e898[0]), (_e898[0] < 0.0lf));
                let _e907 = select(_e898[1], -(_e898[1]), (_e898[1] < 0.0lf));
                let _e909 = select(_e907, _e904, (_e904 > _e907));
                let _e912 = select(_e898[2], -(_e898[2]), (_e898[2] < 0.0lf));
                let _e914 = select(_e912, _e909, (_e909 > _e912));
                let _e917 = local_2.member_1[1u];
                let _e923 = select(_e917[0], -(_e917[0]), (_e917[0] < 0.0lf));
                let _e926 = select(_e917[1], -(_e917[1]), (_e917[1] < 0.0lf));
                let _e928 = select(_e926, _e923, (_e923 > _e926));
                let _e931 = select(_e917[2], -(_e917[2]), (_e917[2] < 0.0lf));
                let _e933 = select(_e931, _e928, (_e928 > _e931));
                let _e937 = local_2.member_3;
                let _e941 = local_2.member_2[0u];
                let _e947 = select(_e941[0], -(_e941[0]), (_e941[0] < 0.0lf));
                let _e950 = select(_e941[1], -(_e941[1]), (_e941[1] < 0.0lf));
                let _e952 = select(_e950, _e947, (_e947 > _e950));
                let _e955 = select(_e941[2], -(_e941[2]), (_e941[2] < 0.0lf));
                let _e957 = select(_e955, _e952, (_e952 > _e955));
                let _e960 = local_2.member_2[1u];
                let _e966 = select(_e960[0], -(_e960[0]), (_e960[0] < 0.0lf));
                let _e969 = select(_e960[1], -(_e960[1]), (_e960[1] < 0.0lf));
                let _e971 = select(_e969, _e966, (_e966 > _e969));
                let _e974 = select(_e960[2], -(_e960[2]), (_e960[2] < 0.0lf));
                let _e976 = select(_e974, _e971, (_e971 > _e974));
                let _e980 = local_2.member_3;
                let _e988 = local_2.member_3;
                let _e996 = (_e506 * f64(0.00390625f));
                let _e997 = f64(0f);
                let _e998 = f64(1f);
                local = type_38(array<f64, 4>(_e997, _e997, _e997, _e997), array<f64, 4>(_e997, _e997, _e997, _e997), array<f64, 4>(_e998, _e998, _e998, _e998));
                phi_1786_ = type_9(0u, 96u);
                phi_1789_ = _e515;
                phi_1791_ = _e515;
                phi_1793_ = (_e524 - _e515);
                phi_1795_ = _e515;
                phi_1797_ = false;
                phi_1799_ = 0u;
                loop {
                    let _e1005 = phi_1786_;
                    let _e1007 = phi_1789_;
                    let _e1009 = phi_1791_;
                    let _e1011 = phi_1793_;
                    let _e1013 = phi_1795_;
                    let _e1015 = phi_1797_;
                    let _e1017 = phi_1799_;
                    local_16 = _e1007;
                    local_20 = _e1009;
                    let _e1020 = (_e1005.member < _e1005.member_1);
                    if (bitcast<i32>(select(0u, 1u, _e1020)) != 0i) {
                        let _e1034 = local_2.member[0u];
                        let _e1040 = local_2.member[1u];
                        let _e1056 = local_2.member_1[0u];
                        let _e1062 = local_2.member_1[1u];
                        let _e1078 = local_2.member_2[0u];
                        let _e1084 = local_2.member_2[1u];
                        let _e1098 = function_4(array<f64, 3>((_e1034[0] + ((_e1040[0] - _e1034[0]) * _e1007)), (_e1034[1] + ((_e1040[1] - _e1034[1]) * _e1007)), (_e1034[2] + ((_e1040[2] - _e1034[2]) * _e1007))), array<f64, 3>((_e1056[0] + ((_e1062[0] - _e1056[0]) * _e1007)), (_e1056[1] + ((_e1062[1] - _e1056[1]) * _e1007)), (_e1056[2] + ((_e1062[2] - _e1056[2]) * _e1007))), array<f64, 3>((_e1078[0] + ((_e1084[0] - _e1078[0]) * _e1007)), (_e1078[1] + ((_e1084[1] - _e1078[1]) * _e1007)), (_e1078[2] + ((_e1084[2] - _e1078[2]) * _e1007))), _e212.member);
                        if (_e1017 == 0u) {
                            phi_1951_ = _e1098;
                        } else {
                            let _e1100 = f64(0f);
                            phi_1951_ = array<f64, 3>(select(_e1100, _e1098[0], (_e1017 == 1u)), select(_e1100, _e1098[1], (_e1017 == 2u)), select(_e1100, _e1098[2], (_e1017 == 3u)));
                        }
                        let _e1112 = phi_1951_;
                        let _e1126 = ((select(_e1112[0], -(_e1112[0]), (_e1112[0] < 0.0lf)) + select(_e1112[1], -(_e1112[1]), (_e1112[1] < 0.0lf))) + select(_e1112[2], -(_e1112[2]), (_e1112[2] < 0.0lf)));
                        if (_e1126 > f64(0f)) {
                            if ((bitcast<u64>(_e1126) & 9218868437227405312lu) != 9218868437227405312lu) {
                                let _e1133 = (f64(1f) / _e1126);
                                let _e1135 = (_e1112[0] * _e1133);
                                let _e1137 = (_e1112[1] * _e1133);
                                let _e1139 = (_e1112[2] * _e1133);
                                let _e1144 = (((_e1135 * _e1135) + (_e1137 * _e1137)) + (_e1139 * _e1139));
                                if (_e1144 <= 2.2250738585072014e-308lf) {
                                    phi_2076_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1144 > 0.0lf));
                                } else {
                                    phi_2019_ = type_16(0i, 5i);
                                    phi_2022_ = bitcast<f64>(((bitcast<u64>(_e1144) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1151 = phi_2019_;
                                        let _e1153 = phi_2022_;
                                        local_4 = _e1153;
                                        if (_e1151.member < _e1151.member_1) {
                                            let _e1160 = (_e1151.member + 1i);
                                            phi_2020_ = type_16(select(_e1160, type_17().member_1, select(false, true, ((false == (_e1160 > _e1151.member)) != false))), _e1151.member_1);
                                            phi_2063_ = type_17(1u, _e1151.member);
                                        } else {
                                            phi_2020_ = _e1151;
                                            phi_2063_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1171 = phi_2020_;
                                        let _e1173 = phi_2063_;
                                        let _e1176 = (bitcast<i32>(_e1173.member) != 0i);
                                        if _e1176 {
                                            phi_2023_ = (0.5lf * (_e1153 + (_e1144 / _e1153)));
                                        } else {
                                            phi_2023_ = f64();
                                        }
                                        let _e1181 = phi_2023_;
                                        continue;
                                        continuing {
                                            phi_2019_ = _e1171;
                                            phi_2022_ = _e1181;
                                            break if !(_e1176);
                                        }
                                    }
                                    let _e1186 = local_4;
                                    phi_2076_ = (_e1186 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1192 = phi_2076_;
                                let _e1194 = (1.1102230246251565e-16lf * f64(12f));
                                let _e1201 = ((((((((select(_e890, _e871, (_e871 > _e890)) + _e894) + (select(_e933, _e914, (_e914 > _e933)) + _e937)) + (select(_e976, _e957, (_e957 > _e976)) + _e980)) * (1.1102230246251565e-16lf * f64(16f))) + (_e988 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e525 * _e1192) * (f64(1f) + _e1194)));
                                let _e1206 = (((_e1135 * _e793[0]) + (_e1137 * _e793[1])) + (_e1139 * _e793[2]));
                                let _e1211 = (((_e1135 * _e809) + (_e1137 * _e810)) + (_e1139 * _e811));
                                let _e1216 = (((_e1135 * (_e793[0] - _e805[0])) + (_e1137 * (_e793[1] - _e805[1]))) + (_e1139 * (_e793[2] - _e805[2])));
                                let _e1221 = (((_e1135 * select((_e809 - _e805[0]), _e793[0], _e812)) + (_e1137 * select((_e810 - _e805[1]), _e793[1], _e812))) + (_e1139 * select((_e811 - _e805[2]), _e793[2], _e812)));
                                let _e1227 = (((_e1135 * _e824[0]) + (_e1137 * _e824[1])) + (_e1139 * _e824[2]));
                                let _e1232 = (((_e1135 * _e840) + (_e1137 * _e841)) + (_e1139 * _e842));
                                let _e1237 = (((_e1135 * (_e824[0] - _e836[0])) + (_e1137 * (_e824[1] - _e836[1]))) + (_e1139 * (_e824[2] - _e836[2])));
                                let _e1242 = (((_e1135 * select((_e840 - _e836[0]), _e824[0], _e843)) + (_e1137 * select((_e841 - _e836[1]), _e824[1], _e843))) + (_e1139 * select((_e842 - _e836[2]), _e824[2], _e843)));
                                phi_2202_ = type_38(array<f64, 4>(_e1206, _e1211, _e1216, _e1221), array<f64, 4>(_e1227, _e1232, _e1237, _e1242), array<f64, 4>((_e1201 + ((select(_e1206, -(_e1206), (_e1206 < 0.0lf)) + select(_e1227, -(_e1227), (_e1227 < 0.0lf))) * _e1194)), (_e1201 + ((select(_e1211, -(_e1211), (_e1211 < 0.0lf)) + select(_e1232, -(_e1232), (_e1232 < 0.0lf))) * _e1194)), (_e1201 + ((select(_e1216, -(_e1216), (_e1216 < 0.0lf)) + select(_e1237, -(_e1237), (_e1237 < 0.0lf))) * _e1194)), (_e1201 + ((select(_e1221, -(_e1221), (_e1221 < 0.0lf)) + select(_e1242, -(_e1242), (_e1242 < 0.0lf))) * _e1194))));
                                phi_2203_ = false;
                            } else {
                                phi_2202_ = type_38();
                                phi_2203_ = true;
                            }
                            let _e1283 = phi_2202_;
                            let _e1285 = phi_2203_;
                            phi_2204_ = _e1283;
                            phi_2205_ = _e1285;
                        } else {
                            phi_2204_ = type_38();
                            phi_2205_ = true;
                        }
                        let _e1287 = phi_2204_;
                        let _e1289 = phi_2205_;
                        if _e1289 {
                            let _e1290 = f64(0f);
                            let _e1291 = f64(1f);
                            phi_2215_ = type_38(array<f64, 4>(_e1290, _e1290, _e1290, _e1290), array<f64, 4>(_e1290, _e1290, _e1290, _e1290), array<f64, 4>(_e1291, _e1291, _e1291, _e1291));
                        } else {
                            phi_2215_ = _e1287;
                        }
                        let _e1297 = phi_2215_;
                        local_1 = type_38(array<f64, 4>(_e1297.member[0], _e1297.member[1], _e1297.member[2], _e1297.member[3]), array<f64, 4>(_e1297.member_1[0], _e1297.member_1[1], _e1297.member_1[2], _e1297.member_1[3]), array<f64, 4>(_e1297.member_2[0], _e1297.member_2[1], _e1297.member_2[2], _e1297.member_2[3]));
                        let _e1317 = (_e1007 - _e1013);
                        let _e1319 = f64(0f);
                        let _e1322 = local_1.member[0u];
                        let _e1325 = local_1.member_1[0u];
                        let _e1328 = local_1.member[0u];
                        let _e1334 = local_1.member_2[0u];
                        if (((_e1322 + ((_e1325 - _e1328) * _e1007)) - _e1334) > _e1319) {
                            let _e1339 = local_1.member[1u];
                            let _e1342 = local_1.member_1[1u];
                            let _e1345 = local_1.member[1u];
                            let _e1351 = local_1.member_2[1u];
                            if (((_e1339 + ((_e1342 - _e1345) * _e1007)) - _e1351) > _e1319) {
                                let _e1356 = local_1.member[2u];
                                let _e1359 = local_1.member_1[2u];
                                let _e1362 = local_1.member[2u];
                                let _e1368 = local_1.member_2[2u];
                                if (((_e1356 + ((_e1359 - _e1362) * _e1007)) - _e1368) > _e1319) {
                                    let _e1373 = local_1.member[3u];
                                    let _e1376 = local_1.member_1[3u];
                                    let _e1379 = local_1.member[3u];
                                    let _e1385 = local_1.member_2[3u];
                                    phi_2387_ = (((_e1373 + ((_e1376 - _e1379) * _e1007)) - _e1385) > _e1319);
                                    phi_2388_ = false;
                                } else {
                                    phi_2387_ = bool();
                                    phi_2388_ = true;
                                }
                                let _e1389 = phi_2387_;
                                let _e1391 = phi_2388_;
                                phi_2389_ = _e1389;
                                phi_2390_ = _e1391;
                            } else {
                                phi_2389_ = bool();
                                phi_2390_ = true;
                            }
                            let _e1393 = phi_2389_;
                            let _e1395 = phi_2390_;
                            phi_2391_ = _e1393;
                            phi_2392_ = _e1395;
                        } else {
                            phi_2391_ = bool();
                            phi_2392_ = true;
                        }
                        let _e1397 = phi_2391_;
                        let _e1399 = phi_2392_;
                        if select(_e1397, false, _e1399) {
                            if (_e1007 <= _e1009) {
                                phi_2707_ = true;
                            } else {
                                let _e1402 = f64(0f);
                                let _e1405 = local.member[0u];
                                let _e1408 = local.member_1[0u];
                                let _e1411 = local.member[0u];
                                let _e1417 = local.member_2[0u];
                                let _e1421 = local_1.member[0u];
                                let _e1424 = local_1.member_1[0u];
                                let _e1427 = local_1.member[0u];
                                let _e1433 = local_1.member_2[0u];
                                if ((((_e1405 + ((_e1408 - _e1411) * _e1007)) - _e1417) + ((_e1421 + ((_e1424 - _e1427) * _e1013)) - _e1433)) > _e1402) {
                                    let _e1439 = local.member[1u];
                                    let _e1442 = local.member_1[1u];
                                    let _e1445 = local.member[1u];
                                    let _e1451 = local.member_2[1u];
                                    let _e1455 = local_1.member[1u];
                                    let _e1458 = local_1.member_1[1u];
                                    let _e1461 = local_1.member[1u];
                                    let _e1467 = local_1.member_2[1u];
                                    if ((((_e1439 + ((_e1442 - _e1445) * _e1007)) - _e1451) + ((_e1455 + ((_e1458 - _e1461) * _e1013)) - _e1467)) > _e1402) {
                                        let _e1473 = local.member[2u];
                                        let _e1476 = local.member_1[2u];
                                        let _e1479 = local.member[2u];
                                        let _e1485 = local.member_2[2u];
                                        let _e1489 = local_1.member[2u];
                                        let _e1492 = local_1.member_1[2u];
                                        let _e1495 = local_1.member[2u];
                                        let _e1501 = local_1.member_2[2u];
                                        if ((((_e1473 + ((_e1476 - _e1479) * _e1007)) - _e1485) + ((_e1489 + ((_e1492 - _e1495) * _e1013)) - _e1501)) > _e1402) {
                                            let _e1507 = local.member[3u];
                                            let _e1510 = local.member_1[3u];
                                            let _e1513 = local.member[3u];
                                            let _e1519 = local.member_2[3u];
                                            let _e1523 = local_1.member[3u];
                                            let _e1526 = local_1.member_1[3u];
                                            let _e1529 = local_1.member[3u];
                                            let _e1535 = local_1.member_2[3u];
                                            phi_2694_ = ((((_e1507 + ((_e1510 - _e1513) * _e1007)) - _e1519) + ((_e1523 + ((_e1526 - _e1529) * _e1013)) - _e1535)) > _e1402);
                                            phi_2695_ = false;
                                        } else {
                                            phi_2694_ = bool();
                                            phi_2695_ = true;
                                        }
                                        let _e1540 = phi_2694_;
                                        let _e1542 = phi_2695_;
                                        phi_2696_ = _e1540;
                                        phi_2697_ = _e1542;
                                    } else {
                                        phi_2696_ = bool();
                                        phi_2697_ = true;
                                    }
                                    let _e1544 = phi_2696_;
                                    let _e1546 = phi_2697_;
                                    phi_2698_ = _e1544;
                                    phi_2699_ = _e1546;
                                } else {
                                    phi_2698_ = bool();
                                    phi_2699_ = true;
                                }
                                let _e1548 = phi_2698_;
                                let _e1550 = phi_2699_;
                                phi_2707_ = select(_e1548, false, _e1550);
                            }
                            let _e1553 = phi_2707_;
                            if _e1553 {
                                if select(true, select(true, false, (_e1007 >= _e524)), _e1015) {
                                    local = type_38(array<f64, 4>(_e1297.member[0], _e1297.member[1], _e1297.member[2], _e1297.member[3]), array<f64, 4>(_e1297.member_1[0], _e1297.member_1[1], _e1297.member_1[2], _e1297.member_1[3]), array<f64, 4>(_e1297.member_2[0], _e1297.member_2[1], _e1297.member_2[2], _e1297.member_2[3]));
                                    let _e1578 = local.member[0u];
                                    let _e1581 = local.member_1[0u];
                                    let _e1584 = local.member_2[0u];
                                    if select(true, select(true, false, (_e1581 > _e1584)), (_e1578 > _e1584)) {
                                        let _e1589 = (_e1581 >= _e1578);
                                        if _e1589 {
                                            phi_2819_ = f64();
                                            phi_2820_ = false;
                                        } else {
                                            if ((_e1578 - _e1581) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                phi_2817_ = (((_e1578 - _e1584) / (_e1578 - _e1581)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                phi_2818_ = false;
                                            } else {
                                                phi_2817_ = f64();
                                                phi_2818_ = true;
                                            }
                                            let _e1603 = phi_2817_;
                                            let _e1605 = phi_2818_;
                                            phi_2819_ = _e1603;
                                            phi_2820_ = _e1605;
                                        }
                                        let _e1607 = phi_2819_;
                                        let _e1609 = phi_2820_;
                                        phi_2821_ = _e1607;
                                        phi_2822_ = _e1589;
                                        phi_2823_ = _e1609;
                                    } else {
                                        phi_2821_ = f64();
                                        phi_2822_ = true;
                                        phi_2823_ = false;
                                    }
                                    let _e1611 = phi_2821_;
                                    let _e1613 = phi_2822_;
                                    let _e1615 = phi_2823_;
                                    let _e1619 = select(_e1611, select(_e1007, f64(2f), _e1613), select(_e1615, true, _e1613));
                                    let _e1622 = local.member[1u];
                                    let _e1625 = local.member_1[1u];
                                    let _e1628 = local.member_2[1u];
                                    if select(true, select(true, false, (_e1625 > _e1628)), (_e1622 > _e1628)) {
                                        let _e1633 = (_e1625 >= _e1622);
                                        if _e1633 {
                                            phi_2891_ = f64();
                                            phi_2892_ = false;
                                        } else {
                                            if ((_e1622 - _e1625) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                phi_2889_ = (((_e1622 - _e1628) / (_e1622 - _e1625)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                phi_2890_ = false;
                                            } else {
                                                phi_2889_ = f64();
                                                phi_2890_ = true;
                                            }
                                            let _e1647 = phi_2889_;
                                            let _e1649 = phi_2890_;
                                            phi_2891_ = _e1647;
                                            phi_2892_ = _e1649;
                                        }
                                        let _e1651 = phi_2891_;
                                        let _e1653 = phi_2892_;
                                        phi_2893_ = _e1651;
                                        phi_2894_ = _e1633;
                                        phi_2895_ = _e1653;
                                    } else {
                                        phi_2893_ = f64();
                                        phi_2894_ = true;
                                        phi_2895_ = false;
                                    }
                                    let _e1655 = phi_2893_;
                                    let _e1657 = phi_2894_;
                                    let _e1659 = phi_2895_;
                                    let _e1663 = select(_e1655, select(_e1007, f64(2f), _e1657), select(_e1659, true, _e1657));
                                    let _e1665 = select(_e1663, _e1619, (_e1619 < _e1663));
                                    let _e1668 = local.member[2u];
                                    let _e1671 = local.member_1[2u];
                                    let _e1674 = local.member_2[2u];
                                    if select(true, select(true, false, (_e1671 > _e1674)), (_e1668 > _e1674)) {
                                        let _e1679 = (_e1671 >= _e1668);
                                        if _e1679 {
                                            phi_2968_ = f64();
                                            phi_2969_ = false;
                                        } else {
                                            if ((_e1668 - _e1671) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                phi_2966_ = (((_e1668 - _e1674) / (_e1668 - _e1671)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                phi_2967_ = false;
                                            } else {
                                                phi_2966_ = f64();
                                                phi_2967_ = true;
                                            }
                                            let _e1693 = phi_2966_;
                                            let _e1695 = phi_2967_;
                                            phi_2968_ = _e1693;
                                            phi_2969_ = _e1695;
                                        }
                                        let _e1697 = phi_2968_;
                                        let _e1699 = phi_2969_;
                                        phi_2970_ = _e1697;
                                        phi_2971_ = _e1679;
                                        phi_2972_ = _e1699;
                                    } else {
                                        phi_2970_ = f64();
                                        phi_2971_ = true;
                                        phi_2972_ = false;
                                    }
                                    let _e1701 = phi_2970_;
                                    let _e1703 = phi_2971_;
                                    let _e1705 = phi_2972_;
                                    let _e1709 = select(_e1701, select(_e1007, f64(2f), _e1703), select(_e1705, true, _e1703));
                                    let _e1712 = local.member[3u];
                                    let _e1715 = local.member_1[3u];
                                    let _e1718 = local.member_2[3u];
                                    if select(true, select(true, false, (_e1715 > _e1718)), (_e1712 > _e1718)) {
                                        let _e1723 = (_e1715 >= _e1712);
                                        if _e1723 {
                                            phi_3040_ = f64();
                                            phi_3041_ = false;
                                        } else {
                                            if ((_e1712 - _e1715) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                phi_3038_ = (((_e1712 - _e1718) / (_e1712 - _e1715)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                phi_3039_ = false;
                                            } else {
                                                phi_3038_ = f64();
                                                phi_3039_ = true;
                                            }
                                            let _e1737 = phi_3038_;
                                            let _e1739 = phi_3039_;
                                            phi_3040_ = _e1737;
                                            phi_3041_ = _e1739;
                                        }
                                        let _e1741 = phi_3040_;
                                        let _e1743 = phi_3041_;
                                        phi_3042_ = _e1741;
                                        phi_3043_ = _e1723;
                                        phi_3044_ = _e1743;
                                    } else {
                                        phi_3042_ = f64();
                                        phi_3043_ = true;
                                        phi_3044_ = false;
                                    }
                                    let _e1745 = phi_3042_;
                                    let _e1747 = phi_3043_;
                                    let _e1749 = phi_3044_;
                                    let _e1753 = select(_e1745, select(_e1007, f64(2f), _e1747), select(_e1749, true, _e1747));
                                    let _e1755 = select(_e1753, _e1709, (_e1709 < _e1753));
                                    let _e1757 = select(_e1755, _e1665, (_e1665 < _e1755));
                                    let _e1759 = select(_e1007, _e1757, (_e1757 > _e1007));
                                    let _e1760 = (_e1759 > _e524);
                                    if _e1760 {
                                        phi_3586_ = f64();
                                        phi_3587_ = f64();
                                        phi_3588_ = false;
                                        phi_3589_ = false;
                                    } else {
                                        let _e1761 = (_e1759 - _e1007);
                                        let _e1762 = (_e1761 <= _e996);
                                        let _e1765 = (_e1759 + (_e506 * f64(0.01f)));
                                        let _e1767 = select(_e524, _e1765, (_e1765 < _e524));
                                        if _e1762 {
                                            if (_e525 > f64(0f)) {
                                                let _e1772 = local_2.member[0u];
                                                let _e1778 = local_2.member[1u];
                                                let _e1794 = local_2.member_1[0u];
                                                let _e1800 = local_2.member_1[1u];
                                                let _e1816 = local_2.member_2[0u];
                                                let _e1822 = local_2.member_2[1u];
                                                let _e1836 = function_4(array<f64, 3>((_e1772[0] + ((_e1778[0] - _e1772[0]) * _e1767)), (_e1772[1] + ((_e1778[1] - _e1772[1]) * _e1767)), (_e1772[2] + ((_e1778[2] - _e1772[2]) * _e1767))), array<f64, 3>((_e1794[0] + ((_e1800[0] - _e1794[0]) * _e1767)), (_e1794[1] + ((_e1800[1] - _e1794[1]) * _e1767)), (_e1794[2] + ((_e1800[2] - _e1794[2]) * _e1767))), array<f64, 3>((_e1816[0] + ((_e1822[0] - _e1816[0]) * _e1767)), (_e1816[1] + ((_e1822[1] - _e1816[1]) * _e1767)), (_e1816[2] + ((_e1822[2] - _e1816[2]) * _e1767))), _e212.member);
                                                let _e1847 = (((_e1836[0] * _e1836[0]) + (_e1836[1] * _e1836[1])) + (_e1836[2] * _e1836[2]));
                                                if (_e1847 <= 2.2250738585072014e-308lf) {
                                                    phi_3278_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1847 > 0.0lf));
                                                } else {
                                                    phi_3221_ = type_16(0i, 5i);
                                                    phi_3224_ = bitcast<f64>(((bitcast<u64>(_e1847) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e1854 = phi_3221_;
                                                        let _e1856 = phi_3224_;
                                                        local_5 = _e1856;
                                                        if (_e1854.member < _e1854.member_1) {
                                                            let _e1863 = (_e1854.member + 1i);
                                                            phi_3222_ = type_16(select(_e1863, type_17().member_1, select(false, true, ((false == (_e1863 > _e1854.member)) != false))), _e1854.member_1);
                                                            phi_3265_ = type_17(1u, _e1854.member);
                                                        } else {
                                                            phi_3222_ = _e1854;
                                                            phi_3265_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e1874 = phi_3222_;
                                                        let _e1876 = phi_3265_;
                                                        let _e1879 = (bitcast<i32>(_e1876.member) != 0i);
                                                        if _e1879 {
                                                            phi_3225_ = (0.5lf * (_e1856 + (_e1847 / _e1856)));
                                                        } else {
                                                            phi_3225_ = f64();
                                                        }
                                                        let _e1884 = phi_3225_;
                                                        continue;
                                                        continuing {
                                                            phi_3221_ = _e1874;
                                                            phi_3224_ = _e1884;
                                                            break if !(_e1879);
                                                        }
                                                    }
                                                    let _e1889 = local_5;
                                                    phi_3278_ = (_e1889 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e1895 = phi_3278_;
                                                let _e1903 = local_2.member[0u];
                                                let _e1909 = select(_e1903[0], -(_e1903[0]), (_e1903[0] < 0.0lf));
                                                let _e1912 = select(_e1903[1], -(_e1903[1]), (_e1903[1] < 0.0lf));
                                                let _e1914 = select(_e1912, _e1909, (_e1909 > _e1912));
                                                let _e1917 = select(_e1903[2], -(_e1903[2]), (_e1903[2] < 0.0lf));
                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                let _e1922 = local_2.member[1u];
                                                let _e1928 = select(_e1922[0], -(_e1922[0]), (_e1922[0] < 0.0lf));
                                                let _e1931 = select(_e1922[1], -(_e1922[1]), (_e1922[1] < 0.0lf));
                                                let _e1933 = select(_e1931, _e1928, (_e1928 > _e1931));
                                                let _e1936 = select(_e1922[2], -(_e1922[2]), (_e1922[2] < 0.0lf));
                                                let _e1938 = select(_e1936, _e1933, (_e1933 > _e1936));
                                                let _e1942 = local_2.member_3;
                                                let _e1946 = local_2.member_1[0u];
                                                let _e1952 = select(_e1946[0], -(_e1946[0]), (_e1946[0] < 0.0lf));
                                                let _e1955 = select(_e1946[1], -(_e1946[1]), (_e1946[1] < 0.0lf));
                                                let _e1957 = select(_e1955, _e1952, (_e1952 > _e1955));
                                                let _e1960 = select(_e1946[2], -(_e1946[2]), (_e1946[2] < 0.0lf));
                                                let _e1962 = select(_e1960, _e1957, (_e1957 > _e1960));
                                                let _e1965 = local_2.member_1[1u];
                                                let _e1971 = select(_e1965[0], -(_e1965[0]), (_e1965[0] < 0.0lf));
                                                let _e1974 = select(_e1965[1], -(_e1965[1]), (_e1965[1] < 0.0lf));
                                                let _e1976 = select(_e1974, _e1971, (_e1971 > _e1974));
                                                let _e1979 = select(_e1965[2], -(_e1965[2]), (_e1965[2] < 0.0lf));
                                                let _e1981 = select(_e1979, _e1976, (_e1976 > _e1979));
                                                let _e1985 = local_2.member_3;
                                                let _e1989 = local_2.member_2[0u];
                                                let _e1995 = select(_e1989[0], -(_e1989[0]), (_e1989[0] < 0.0lf));
                                                let _e1998 = select(_e1989[1], -(_e1989[1]), (_e1989[1] < 0.0lf));
                                                let _e2000 = select(_e1998, _e1995, (_e1995 > _e1998));
                                                let _e2003 = select(_e1989[2], -(_e1989[2]), (_e1989[2] < 0.0lf));
                                                let _e2005 = select(_e2003, _e2000, (_e2000 > _e2003));
                                                let _e2008 = local_2.member_2[1u];
                                                let _e2014 = select(_e2008[0], -(_e2008[0]), (_e2008[0] < 0.0lf));
                                                let _e2017 = select(_e2008[1], -(_e2008[1]), (_e2008[1] < 0.0lf));
                                                let _e2019 = select(_e2017, _e2014, (_e2014 > _e2017));
                                                let _e2022 = select(_e2008[2], -(_e2008[2]), (_e2008[2] < 0.0lf));
                                                let _e2024 = select(_e2022, _e2019, (_e2019 > _e2022));
                                                let _e2028 = local_2.member_3;
                                                let _e2036 = local_2.member_3;
                                                phi_3555_ = select(true, false, (((_e1895 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e1938, _e1919, (_e1919 > _e1938)) + _e1942) + (select(_e1981, _e1962, (_e1962 > _e1981)) + _e1985)) + (select(_e2024, _e2005, (_e2005 > _e2024)) + _e2028)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2036 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e525));
                                            } else {
                                                phi_3555_ = true;
                                            }
                                            let _e2049 = phi_3555_;
                                            phi_3556_ = _e2049;
                                        } else {
                                            phi_3556_ = true;
                                        }
                                        let _e2051 = phi_3556_;
                                        if _e2051 {
                                            if _e1015 {
                                                let _e2055 = (_e1761 <= (_e1011 * f64(0.25f)));
                                                phi_3583_ = select(select(select(f64(), f64(0f), _e2055), f64(), _e1762), (_e1317 + _e1317), select(select(true, false, _e2055), true, _e1762));
                                            } else {
                                                phi_3583_ = (_e524 - _e1007);
                                            }
                                            let _e2064 = phi_3583_;
                                            phi_3584_ = _e2064;
                                            phi_3585_ = false;
                                        } else {
                                            phi_3584_ = f64();
                                            phi_3585_ = true;
                                        }
                                        let _e2066 = phi_3584_;
                                        let _e2068 = phi_3585_;
                                        phi_3586_ = _e2066;
                                        phi_3587_ = _e1761;
                                        phi_3588_ = _e2051;
                                        phi_3589_ = _e2068;
                                    }
                                    let _e2070 = phi_3586_;
                                    let _e2072 = phi_3587_;
                                    let _e2074 = phi_3588_;
                                    let _e2076 = phi_3589_;
                                    phi_3590_ = _e1759;
                                    phi_3591_ = _e2070;
                                    phi_3592_ = _e2072;
                                    phi_3593_ = _e1759;
                                    phi_3594_ = _e2074;
                                    phi_3595_ = _e1760;
                                    phi_3596_ = _e2076;
                                    phi_3597_ = false;
                                } else {
                                    phi_3590_ = f64();
                                    phi_3591_ = f64();
                                    phi_3592_ = f64();
                                    phi_3593_ = f64();
                                    phi_3594_ = false;
                                    phi_3595_ = false;
                                    phi_3596_ = false;
                                    phi_3597_ = true;
                                }
                                let _e2078 = phi_3590_;
                                let _e2080 = phi_3591_;
                                let _e2082 = phi_3592_;
                                let _e2084 = phi_3593_;
                                let _e2086 = phi_3594_;
                                let _e2088 = phi_3595_;
                                let _e2090 = phi_3596_;
                                let _e2092 = phi_3597_;
                                phi_3598_ = _e2078;
                                phi_3599_ = _e2080;
                                phi_3600_ = _e2082;
                                phi_3601_ = _e2084;
                                phi_3602_ = false;
                                phi_3603_ = _e2086;
                                phi_3604_ = _e2088;
                                phi_3605_ = _e2090;
                                phi_3606_ = _e2092;
                            } else {
                                phi_3598_ = f64();
                                phi_3599_ = f64();
                                phi_3600_ = f64();
                                phi_3601_ = f64();
                                phi_3602_ = true;
                                phi_3603_ = false;
                                phi_3604_ = false;
                                phi_3605_ = false;
                                phi_3606_ = false;
                            }
                            let _e2094 = phi_3598_;
                            let _e2096 = phi_3599_;
                            let _e2098 = phi_3600_;
                            let _e2100 = phi_3601_;
                            let _e2102 = phi_3602_;
                            let _e2104 = phi_3603_;
                            let _e2106 = phi_3604_;
                            let _e2108 = phi_3605_;
                            let _e2110 = phi_3606_;
                            phi_3607_ = _e2094;
                            phi_3608_ = _e2096;
                            phi_3609_ = _e2098;
                            phi_3610_ = _e2100;
                            phi_3611_ = _e2102;
                            phi_3612_ = _e2104;
                            phi_3613_ = _e2106;
                            phi_3614_ = _e2108;
                            phi_3615_ = _e2110;
                        } else {
                            phi_3607_ = f64();
                            phi_3608_ = f64();
                            phi_3609_ = f64();
                            phi_3610_ = f64();
                            phi_3611_ = true;
                            phi_3612_ = false;
                            phi_3613_ = false;
                            phi_3614_ = false;
                            phi_3615_ = false;
                        }
                        let _e2112 = phi_3607_;
                        let _e2114 = phi_3608_;
                        let _e2116 = phi_3609_;
                        let _e2118 = phi_3610_;
                        let _e2120 = phi_3611_;
                        let _e2122 = phi_3612_;
                        let _e2124 = phi_3613_;
                        let _e2126 = phi_3614_;
                        let _e2128 = phi_3615_;
                        if _e2120 {
                            if (_e1007 <= _e1009) {
                                let _e2286 = (_e1017 + 1u);
                                let _e2287 = (_e2286 > 3u);
                                phi_3955_ = _e2286;
                                phi_3956_ = f64();
                                phi_3957_ = false;
                                phi_3958_ = select(true, false, _e2287);
                                phi_3959_ = _e2287;
                            } else {
                                let _e2132 = local.member[0u];
                                let _e2135 = local.member_1[0u];
                                let _e2138 = local.member[0u];
                                let _e2144 = local.member_2[0u];
                                let _e2145 = ((_e2132 + ((_e2135 - _e2138) * _e1013)) - _e2144);
                                let _e2148 = local.member[1u];
                                let _e2151 = local.member_1[1u];
                                let _e2154 = local.member[1u];
                                let _e2160 = local.member_2[1u];
                                let _e2161 = ((_e2148 + ((_e2151 - _e2154) * _e1013)) - _e2160);
                                let _e2163 = select(_e2161, _e2145, (_e2145 < _e2161));
                                let _e2166 = local.member[2u];
                                let _e2169 = local.member_1[2u];
                                let _e2172 = local.member[2u];
                                let _e2178 = local.member_2[2u];
                                let _e2179 = ((_e2166 + ((_e2169 - _e2172) * _e1013)) - _e2178);
                                let _e2182 = local.member[3u];
                                let _e2185 = local.member_1[3u];
                                let _e2188 = local.member[3u];
                                let _e2194 = local.member_2[3u];
                                let _e2195 = ((_e2182 + ((_e2185 - _e2188) * _e1013)) - _e2194);
                                let _e2197 = select(_e2195, _e2179, (_e2179 < _e2195));
                                let _e2199 = select(_e2197, _e2163, (_e2163 < _e2197));
                                let _e2202 = local_1.member[0u];
                                let _e2205 = local_1.member_1[0u];
                                let _e2208 = local_1.member[0u];
                                let _e2214 = local_1.member_2[0u];
                                let _e2215 = ((_e2202 + ((_e2205 - _e2208) * _e1007)) - _e2214);
                                let _e2218 = local_1.member[1u];
                                let _e2221 = local_1.member_1[1u];
                                let _e2224 = local_1.member[1u];
                                let _e2230 = local_1.member_2[1u];
                                let _e2231 = ((_e2218 + ((_e2221 - _e2224) * _e1007)) - _e2230);
                                let _e2233 = select(_e2231, _e2215, (_e2215 < _e2231));
                                let _e2236 = local_1.member[2u];
                                let _e2239 = local_1.member_1[2u];
                                let _e2242 = local_1.member[2u];
                                let _e2248 = local_1.member_2[2u];
                                let _e2249 = ((_e2236 + ((_e2239 - _e2242) * _e1007)) - _e2248);
                                let _e2252 = local_1.member[3u];
                                let _e2255 = local_1.member_1[3u];
                                let _e2258 = local_1.member[3u];
                                let _e2264 = local_1.member_2[3u];
                                let _e2265 = ((_e2252 + ((_e2255 - _e2258) * _e1007)) - _e2264);
                                let _e2267 = select(_e2265, _e2249, (_e2249 < _e2265));
                                let _e2269 = select(_e2267, _e2233, (_e2233 < _e2267));
                                let _e2270 = f64(0.0625f);
                                let _e2272 = f64(0.9f);
                                if (_e2269 > f64(0f)) {
                                    phi_3953_ = f64(0.5f);
                                } else {
                                    let _e2278 = (f64(0.95f) * (_e2199 / (_e2199 - _e2269)));
                                    phi_3953_ = select(_e2270, select(_e2272, _e2278, (_e2278 < _e2272)), (_e2278 > _e2270));
                                }
                                let _e2284 = phi_3953_;
                                phi_3955_ = u32();
                                phi_3956_ = (_e1317 * _e2284);
                                phi_3957_ = true;
                                phi_3958_ = false;
                                phi_3959_ = false;
                            }
                            let _e2290 = phi_3955_;
                            let _e2292 = phi_3956_;
                            let _e2294 = phi_3957_;
                            let _e2296 = phi_3958_;
                            let _e2298 = phi_3959_;
                            phi_3960_ = _e2290;
                            phi_3961_ = _e1009;
                            phi_3962_ = _e2292;
                            phi_3963_ = _e1011;
                            phi_3964_ = _e1013;
                            phi_3965_ = _e1015;
                            phi_3966_ = _e1017;
                            phi_3967_ = _e2294;
                            phi_3968_ = _e2296;
                            phi_3969_ = _e2298;
                            phi_3970_ = false;
                            phi_3971_ = false;
                            phi_3972_ = false;
                        } else {
                            phi_3960_ = u32();
                            phi_3961_ = _e2112;
                            phi_3962_ = _e2114;
                            phi_3963_ = _e2116;
                            phi_3964_ = _e1007;
                            phi_3965_ = true;
                            phi_3966_ = 0u;
                            phi_3967_ = _e2122;
                            phi_3968_ = false;
                            phi_3969_ = false;
                            phi_3970_ = _e2124;
                            phi_3971_ = _e2126;
                            phi_3972_ = _e2128;
                        }
                        let _e2300 = phi_3960_;
                        let _e2302 = phi_3961_;
                        let _e2304 = phi_3962_;
                        let _e2306 = phi_3963_;
                        let _e2308 = phi_3964_;
                        let _e2310 = phi_3965_;
                        let _e2312 = phi_3966_;
                        let _e2314 = phi_3967_;
                        let _e2316 = phi_3968_;
                        let _e2318 = phi_3969_;
                        let _e2320 = phi_3970_;
                        let _e2322 = phi_3971_;
                        let _e2324 = phi_3972_;
                        if _e2314 {
                            let _e2325 = (_e2308 + _e2304);
                            let _e2327 = select(_e2302, _e2325, (_e2325 > _e2302));
                            let _e2329 = select(_e524, _e2327, (_e2327 < _e524));
                            let _e2332 = select(((_e2329 - _e2308) > _e996), true, !(_e1015));
                            phi_4000_ = _e2329;
                            phi_4001_ = _e2302;
                            phi_4002_ = _e2306;
                            phi_4003_ = _e2308;
                            phi_4004_ = _e2310;
                            phi_4005_ = _e2312;
                            phi_4006_ = _e2332;
                            phi_4007_ = select(true, false, _e2332);
                            phi_4008_ = false;
                            phi_4009_ = false;
                            phi_4010_ = false;
                            phi_4011_ = false;
                        } else {
                            phi_4000_ = _e1007;
                            phi_4001_ = _e1009;
                            phi_4002_ = _e1011;
                            phi_4003_ = _e1013;
                            phi_4004_ = _e1015;
                            phi_4005_ = _e2300;
                            phi_4006_ = _e2316;
                            phi_4007_ = false;
                            phi_4008_ = _e2318;
                            phi_4009_ = _e2320;
                            phi_4010_ = _e2322;
                            phi_4011_ = _e2324;
                        }
                        let _e2335 = phi_4000_;
                        let _e2337 = phi_4001_;
                        let _e2339 = phi_4002_;
                        let _e2341 = phi_4003_;
                        let _e2343 = phi_4004_;
                        let _e2345 = phi_4005_;
                        let _e2347 = phi_4006_;
                        let _e2349 = phi_4007_;
                        let _e2351 = phi_4008_;
                        let _e2353 = phi_4009_;
                        let _e2355 = phi_4010_;
                        let _e2357 = phi_4011_;
                        phi_1790_ = _e2335;
                        phi_1792_ = _e2337;
                        phi_1794_ = _e2339;
                        phi_1796_ = _e2341;
                        phi_1798_ = _e2343;
                        phi_1800_ = _e2345;
                        phi_4012_ = _e2302;
                        phi_4013_ = _e2118;
                        phi_4014_ = _e2347;
                        phi_4015_ = _e2349;
                        phi_4016_ = _e2351;
                        phi_4017_ = _e2353;
                        phi_4018_ = _e2355;
                        phi_4019_ = false;
                        phi_4020_ = _e2357;
                    } else {
                        phi_1790_ = f64();
                        phi_1792_ = f64();
                        phi_1794_ = f64();
                        phi_1796_ = f64();
                        phi_1798_ = bool();
                        phi_1800_ = u32();
                        phi_4012_ = f64();
                        phi_4013_ = f64();
                        phi_4014_ = false;
                        phi_4015_ = false;
                        phi_4016_ = false;
                        phi_4017_ = false;
                        phi_4018_ = false;
                        phi_4019_ = true;
                        phi_4020_ = false;
                    }
                    let _e2359 = phi_1790_;
                    let _e2361 = phi_1792_;
                    let _e2363 = phi_1794_;
                    let _e2365 = phi_1796_;
                    let _e2367 = phi_1798_;
                    let _e2369 = phi_1800_;
                    let _e2371 = phi_4012_;
                    let _e2373 = phi_4013_;
                    let _e2375 = phi_4014_;
                    let _e2377 = phi_4015_;
                    let _e2379 = phi_4016_;
                    let _e2381 = phi_4017_;
                    let _e2383 = phi_4018_;
                    let _e2385 = phi_4019_;
                    let _e2387 = phi_4020_;
                    local_6 = _e2377;
                    local_7 = _e2379;
                    local_8 = _e2377;
                    local_9 = _e2381;
                    local_10 = _e2377;
                    local_11 = _e2383;
                    local_12 = _e2377;
                    local_13 = _e2385;
                    local_14 = _e2377;
                    local_15 = _e2387;
                    local_17 = _e2377;
                    local_18 = _e2373;
                    local_19 = _e2371;
                    continue;
                    continuing {
                        phi_1786_ = type_9(select(_e1005.member, (_e1005.member + 1u), _e1020), select(_e1005.member_1, _e1005.member_1, _e1020));
                        phi_1789_ = _e2359;
                        phi_1791_ = _e2361;
                        phi_1793_ = _e2363;
                        phi_1795_ = _e2365;
                        phi_1797_ = _e2367;
                        phi_1799_ = _e2369;
                        break if !(_e2375);
                    }
                }
                let _e2390 = local_6;
                let _e2392 = local_7;
                let _e2393 = select(_e2392, false, _e2390);
                let _e2395 = local_8;
                let _e2397 = local_9;
                let _e2400 = local_10;
                let _e2402 = local_11;
                let _e2405 = local_12;
                let _e2407 = local_13;
                let _e2410 = local_14;
                let _e2412 = local_15;
                let _e2418 = local_16;
                let _e2420 = select(select(_e2397, false, _e2395), false, _e2393);
                let _e2423 = local_17;
                let _e2430 = select(select(select(_e2402, false, _e2400), false, _e2393), false, _e2420);
                let _e2436 = local_18;
                let _e2438 = local_19;
                let _e2440 = select(select(select(_e2423, false, _e2393), false, _e2420), true, _e2430);
                let _e2445 = local_20;
                let _e2447 = select(select(select(select(select(_e2407, false, _e2405), false, _e2393), false, _e2420), false, _e2430), true, _e2440);
                let _e2454 = select(select(select(select(select(select(_e2412, false, _e2410), false, _e2393), false, _e2420), false, _e2430), false, _e2440), false, _e2447);
                let _e2459 = select(select(select(select(select(_e2393, true, _e2420), false, _e2430), false, _e2440), false, _e2447), true, _e2454);
                let _e2462 = (select(select(type_37().member, 1u, _e2447), select(select(select(type_37().member, 1u, _e2393), 0u, _e2420), 0u, _e2454), _e2459) != 0u);
                let _e2465 = select(type_37().member_1, select(select(type_37().member_1, select(_e2445, select(_e2438, _e2436, _e2430), _e2440), _e2447), select(select(select(type_37().member_1, _e2418, _e2393), type_37().member_1, _e2420), type_37().member_1, _e2454), _e2459), _e2462);
                switch bitcast<i32>(select(0u, 2u, _e2462)) {
                    case 0: {
                        phi_4111_ = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e2469 = function_1(_e2465);
                        phi_4111_ = type_35(0u, 0u, _e2469, true);
                        break;
                    }
                    case 2: {
                        let _e2467 = function_1(_e2465);
                        phi_4111_ = type_35(1u, 0u, _e2467, true);
                        break;
                    }
                    default: {
                        phi_4111_ = type_35();
                        break;
                    }
                }
                let _e2472 = phi_4111_;
                local_3 = type_35(_e2472.member, _e2472.member_1, array<u32, 2>(_e2472.member_2[0], _e2472.member_2[1]), _e2472.member_3);
                phi_4120_ = type_9(_e170, _e173);
            } else {
                phi_4120_ = type_9(0u, 0u);
            }
            let _e2482 = phi_4120_;
            let _e2488 = local_3.member;
            let _e2490 = select(true, false, (_e2488 == 0u));
            let _e2492 = local_3.member_3;
            if _e2492 {
                if _e2490 {
                    phi_4149_ = true;
                } else {
                    let _e2494 = params.member.member.member_1;
                    phi_4149_ = ((_e2494 & 16u) != 0u);
                }
                let _e2498 = phi_4149_;
                phi_4150_ = _e2498;
            } else {
                phi_4150_ = false;
            }
            let _e2500 = phi_4150_;
            let _e2502 = local_3.member_3;
            if _e2502 {
                if _e2490 {
                } else {
                    let _e2504 = local_3.member_2;
                    let _e2508 = (_e2504[1] >> bitcast<u32>(20i));
                    let _e2522 = atomicMin((&earliest.member[0u]), select(((((_e2508 - 896u) << bitcast<u32>(23i)) | ((_e2504[1] & 1048575u) << bitcast<u32>(3i))) | (_e2504[0] >> bitcast<u32>(29i))), 0u, (_e2508 <= 896u)));
                }
            }
            if (_e88 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e2500 {
                let _e2526 = atomicAdd((&counters[0u]), 1u);
                phi_4193_ = _e2526;
            } else {
                phi_4193_ = 0u;
            }
            let _e2528 = phi_4193_;
            workgroupBarrier();
            if (_e88 == 0u) {
                let _e2531 = atomicLoad((&counters[0u]));
                if (_e2531 > 0u) {
                    let _e2534 = atomicAdd((&contacts.member[0u]), _e2531);
                    atomicStore((&counters[1u]), _e2534);
                }
            }
            workgroupBarrier();
            let _e2537 = atomicLoad((&counters[1u]));
            let _e2538 = (_e2537 + _e2528);
            if _e2500 {
                let _e2540 = params.member.member_1.member_3;
                if (_e2538 < _e2540) {
                    let _e2546 = (7u * _e2538);
                    atomicStore((&contacts.member[(4u + _e2546)]), select(1u, 0u, ((_e2482.member_1 & 2147483648u) == 0u)));
                    let _e2551 = local_3.member;
                    atomicStore((&contacts.member[(_e2546 + 5u)]), _e2551);
                    atomicStore((&contacts.member[(_e2546 + 6u)]), _e2482.member);
                    atomicStore((&contacts.member[(_e2546 + 7u)]), (_e2482.member_1 & 2147483647u));
                    let _e2560 = local_3.member_2[0u];
                    atomicStore((&contacts.member[(_e2546 + 8u)]), _e2560);
                    let _e2565 = local_3.member_2[1u];
                    atomicStore((&contacts.member[(_e2546 + 9u)]), _e2565);
                    let _e2569 = local_3.member_1;
                    atomicStore((&contacts.member[(_e2546 + 10u)]), _e2569);
                }
            }
        }
        continue;
        continuing {
            phi_420_ = type_9(select(_e141.member, (_e141.member + 1u), _e144), select(_e141.member_1, _e141.member_1, _e144));
            break if !(_e157);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn advance_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
