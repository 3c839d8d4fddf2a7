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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_37 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_42 {
    member: type_33,
    member_1: f64,
}

struct type_43 {
    member: u32,
    member_1: f64,
}

struct type_44 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_48 {
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
@group(0) @binding(6) 
var<storage, read_write> earliest: type_48;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_240_: f64;
    var phi_283_: f64;
    var phi_326_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_240_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_240_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_240_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_283_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_283_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_283_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_326_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_326_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_326_;
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
    var phi_7499_: array<array<f64, 3>, 4>;

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
        phi_7499_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
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
        phi_7499_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7499_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_7098_: bool;
    var phi_7132_: array<f64, 3>;
    var phi_7133_: bool;
    var phi_7134_: array<f64, 3>;
    var phi_7135_: bool;
    var phi_7140_: array<f64, 3>;

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
        phi_7098_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7098_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7098_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7132_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_7133_ = false;
        } else {
            phi_7132_ = array<f64, 3>();
            phi_7133_ = true;
        }
        let _e132 = phi_7132_;
        let _e134 = phi_7133_;
        phi_7134_ = _e132;
        phi_7135_ = _e134;
    } else {
        phi_7134_ = array<f64, 3>();
        phi_7135_ = true;
    }
    let _e136 = phi_7134_;
    let _e138 = phi_7135_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_7140_ = _e139;
    } else {
        phi_7140_ = _e136;
    }
    let _e141 = phi_7140_;
    return _e141;
}

fn function_5(param_12: ptr<function, type_40>, param_13: f64, param_14: f64, param_15: f64) -> bool {
    var phi_6973_: bool;
    var phi_6974_: bool;
    var phi_6979_: bool;

    let _e15 = (*param_12).member_3;
    let _e17 = (*param_12).member_3;
    let _e19 = (param_13 + (_e15 + _e17));
    if (_e19 < param_15) {
        let _e22 = (f64(1f) - param_14);
        let _e25 = (*param_12).member[0u];
        let _e28 = (*param_12).member[1u];
        let _e31 = (*param_12).member[2u];
        let _e34 = (*param_12).member[3u];
        let _e45 = ((((_e25 * _e22) + (_e28 * param_14)) * (_e22 * _e22)) + (((_e31 * _e22) + (_e34 * param_14)) * (param_14 * param_14)));
        let _e47 = select(param_14, _e19, (_e19 > param_14));
        let _e49 = (f64(1f) - _e47);
        let _e52 = (*param_12).member[0u];
        let _e55 = (*param_12).member[1u];
        let _e58 = (*param_12).member[2u];
        let _e61 = (*param_12).member[3u];
        let _e72 = ((((_e52 * _e49) + (_e55 * _e47)) * (_e49 * _e49)) + (((_e58 * _e49) + (_e61 * _e47)) * (_e47 * _e47)));
        let _e74 = (*param_12).member_1;
        let _e76 = (*param_12).member_1;
        let _e82 = (*param_12).member_1;
        if (select(_e45, -(_e45), (_e45 < 0.0lf)) > _e82) {
            let _e87 = (select(_e72, -(_e72), (_e72 < 0.0lf)) > (_e74 + _e76));
            phi_6973_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_6974_ = select(true, false, _e87);
        } else {
            phi_6973_ = bool();
            phi_6974_ = true;
        }
        let _e96 = phi_6973_;
        let _e98 = phi_6974_;
        phi_6979_ = select(_e96, false, _e98);
    } else {
        phi_6979_ = false;
    }
    let _e101 = phi_6979_;
    return _e101;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_36;
    var local_1: type_36;
    var local_2: array<type_37, 4>;
    var local_3: array<f64, 4>;
    var local_4: array<f64, 2>;
    var local_5: type_40;
    var local_6: array<f64, 4>;
    var local_7: type_33;
    var phi_386_: u32;
    var phi_431_: u32;
    var phi_434_: type_9;
    var phi_606_: type_23;
    var phi_802_: type_31;
    var phi_963_: type_33;
    var phi_1236_: bool;
    var phi_1332_: type_42;
    var phi_1333_: bool;
    var phi_1334_: type_42;
    var phi_1335_: bool;
    var phi_1336_: type_42;
    var phi_1337_: bool;
    var phi_1342_: type_42;
    var phi_2082_: bool;
    var phi_2097_: f64;
    var phi_2173_: type_16;
    var phi_2176_: f64;
    var phi_2174_: type_16;
    var phi_2217_: type_17;
    var phi_2177_: f64;
    var local_8: f64;
    var phi_2230_: f64;
    var phi_2261_: type_9;
    var phi_2264_: u32;
    var phi_2331_: u32;
    var phi_2332_: u32;
    var phi_2265_: u32;
    var phi_2333_: u32;
    var phi_2391_: type_9;
    var phi_2551_: type_44;
    var phi_2552_: bool;
    var phi_2553_: type_44;
    var phi_2554_: bool;
    var phi_2589_: type_9;
    var phi_2592_: f64;
    var phi_2594_: f64;
    var phi_2596_: f64;
    var phi_2710_: bool;
    var phi_2717_: f64;
    var phi_2718_: bool;
    var phi_2593_: f64;
    var phi_2595_: f64;
    var phi_2597_: f64;
    var phi_2719_: f64;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var local_9: bool;
    var local_10: f64;
    var local_11: f64;
    var phi_2726_: f64;
    var phi_2744_: type_9;
    var phi_2747_: f64;
    var phi_2813_: f64;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2817_: f64;
    var phi_2748_: f64;
    var phi_2818_: bool;
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f64;
    var phi_2835_: f64;
    var phi_2837_: type_44;
    var phi_3698_: array<type_37, 4>;
    var phi_3718_: type_9;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3773_: bool;
    var phi_3774_: bool;
    var local_17: bool;
    var local_18: bool;
    var phi_3788_: u32;
    var phi_3789_: u32;
    var phi_3790_: bool;
    var phi_3821_: bool;
    var phi_3822_: bool;
    var phi_3823_: bool;
    var phi_3824_: bool;
    var phi_3825_: bool;
    var phi_3826_: bool;
    var phi_3827_: bool;
    var phi_3828_: bool;
    var phi_3829_: bool;
    var phi_3830_: bool;
    var phi_3831_: bool;
    var phi_3832_: bool;
    var phi_3833_: type_44;
    var phi_3834_: bool;
    var phi_3835_: type_44;
    var phi_3836_: bool;
    var phi_3837_: bool;
    var phi_3838_: bool;
    var phi_3839_: bool;
    var phi_3840_: type_44;
    var phi_3841_: bool;
    var phi_3842_: type_44;
    var phi_3843_: bool;
    var phi_3844_: bool;
    var phi_3845_: bool;
    var phi_3846_: bool;
    var phi_3847_: bool;
    var phi_3855_: type_44;
    var phi_3856_: bool;
    var phi_3857_: type_44;
    var phi_3858_: bool;
    var phi_3859_: bool;
    var phi_3860_: bool;
    var phi_3861_: bool;
    var phi_3862_: bool;
    var phi_4291_: type_9;
    var phi_4294_: f64;
    var phi_4296_: f64;
    var phi_4298_: f64;
    var phi_4300_: f64;
    var phi_4302_: bool;
    var phi_4304_: u32;
    var phi_4456_: array<f64, 3>;
    var phi_4524_: type_16;
    var phi_4527_: f64;
    var phi_4525_: type_16;
    var phi_4568_: type_17;
    var phi_4528_: f64;
    var local_19: f64;
    var phi_4581_: f64;
    var phi_4707_: type_36;
    var phi_4708_: bool;
    var phi_4709_: type_36;
    var phi_4710_: bool;
    var phi_4720_: type_36;
    var phi_4892_: bool;
    var phi_4893_: bool;
    var phi_4894_: bool;
    var phi_4895_: bool;
    var phi_4896_: bool;
    var phi_4897_: bool;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5204_: bool;
    var phi_5212_: bool;
    var phi_5322_: f64;
    var phi_5323_: bool;
    var phi_5324_: f64;
    var phi_5325_: bool;
    var phi_5326_: f64;
    var phi_5327_: bool;
    var phi_5328_: bool;
    var phi_5394_: f64;
    var phi_5395_: bool;
    var phi_5396_: f64;
    var phi_5397_: bool;
    var phi_5398_: f64;
    var phi_5399_: bool;
    var phi_5400_: bool;
    var phi_5471_: f64;
    var phi_5472_: bool;
    var phi_5473_: f64;
    var phi_5474_: bool;
    var phi_5475_: f64;
    var phi_5476_: bool;
    var phi_5477_: bool;
    var phi_5543_: f64;
    var phi_5544_: bool;
    var phi_5545_: f64;
    var phi_5546_: bool;
    var phi_5547_: f64;
    var phi_5548_: bool;
    var phi_5549_: bool;
    var phi_5726_: type_16;
    var phi_5729_: f64;
    var phi_5727_: type_16;
    var phi_5770_: type_17;
    var phi_5730_: f64;
    var local_20: f64;
    var phi_5783_: f64;
    var phi_6060_: bool;
    var phi_6061_: bool;
    var phi_6088_: f64;
    var phi_6089_: f64;
    var phi_6090_: bool;
    var phi_6091_: f64;
    var phi_6092_: f64;
    var phi_6093_: bool;
    var phi_6094_: bool;
    var phi_6095_: f64;
    var phi_6096_: f64;
    var phi_6097_: f64;
    var phi_6098_: f64;
    var phi_6099_: bool;
    var phi_6100_: bool;
    var phi_6101_: bool;
    var phi_6102_: bool;
    var phi_6103_: f64;
    var phi_6104_: f64;
    var phi_6105_: f64;
    var phi_6106_: f64;
    var phi_6107_: bool;
    var phi_6108_: bool;
    var phi_6109_: bool;
    var phi_6110_: bool;
    var phi_6111_: bool;
    var phi_6112_: f64;
    var phi_6113_: f64;
    var phi_6114_: f64;
    var phi_6115_: f64;
    var phi_6116_: bool;
    var phi_6117_: bool;
    var phi_6118_: bool;
    var phi_6119_: bool;
    var phi_6120_: bool;
    var phi_6458_: f64;
    var phi_6460_: u32;
    var phi_6461_: f64;
    var phi_6462_: bool;
    var phi_6463_: bool;
    var phi_6464_: bool;
    var phi_6465_: u32;
    var phi_6466_: f64;
    var phi_6467_: f64;
    var phi_6468_: f64;
    var phi_6469_: f64;
    var phi_6470_: bool;
    var phi_6471_: u32;
    var phi_6472_: bool;
    var phi_6473_: bool;
    var phi_6474_: bool;
    var phi_6475_: bool;
    var phi_6476_: bool;
    var phi_6477_: bool;
    var phi_6505_: f64;
    var phi_6506_: f64;
    var phi_6507_: f64;
    var phi_6508_: f64;
    var phi_6509_: bool;
    var phi_6510_: u32;
    var phi_6511_: bool;
    var phi_6512_: bool;
    var phi_6513_: bool;
    var phi_6514_: bool;
    var phi_6515_: bool;
    var phi_6516_: bool;
    var phi_4295_: f64;
    var phi_4297_: f64;
    var phi_4299_: f64;
    var phi_4301_: f64;
    var phi_4303_: bool;
    var phi_4305_: u32;
    var phi_6517_: f64;
    var phi_6518_: f64;
    var phi_6519_: bool;
    var phi_6520_: bool;
    var phi_6521_: bool;
    var phi_6522_: bool;
    var phi_6523_: bool;
    var phi_6524_: bool;
    var phi_6525_: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: bool;
    var local_29: bool;
    var local_30: bool;
    var local_31: f64;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
    var phi_6593_: f64;
    var phi_6594_: bool;
    var phi_6595_: bool;
    var phi_6596_: bool;
    var phi_6597_: bool;
    var phi_6598_: bool;
    var phi_6599_: type_44;
    var phi_6600_: bool;
    var phi_6601_: f64;
    var phi_6602_: type_44;
    var phi_6603_: bool;
    var phi_6604_: bool;
    var phi_6605_: bool;
    var phi_6606_: bool;
    var phi_6607_: bool;
    var phi_6608_: bool;
    var local_36: bool;
    var local_37: bool;
    var local_38: type_44;
    var local_39: f64;
    var local_40: f64;
    var phi_6624_: type_43;
    var phi_6625_: bool;
    var local_41: f64;
    var phi_6631_: type_43;
    var phi_6632_: bool;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var phi_6635_: bool;
    var local_42: bool;
    var local_43: type_44;
    var phi_6677_: type_43;
    var phi_6678_: type_43;
    var phi_6679_: bool;
    var phi_6723_: type_35;
    var phi_6724_: type_35;
    var phi_6725_: type_9;
    var phi_6771_: u32;
    var phi_6785_: u32;
    var phi_6855_: bool;
    var phi_6856_: bool;
    var local_44: u32;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e105 = id_2;
    let _e106 = n_2;
    let _e107 = lane_2;
    let _e119 = ((_e105.y * _e106.x) + _e105.x);
    let _e122 = (_e106.x * _e106.y);
    let _e125 = params.member.member_1.member_2;
    let _e127 = input.member[0u];
    let _e129 = select(_e127, _e125, (_e125 < _e127));
    let _e131 = params.member.member_1.member_1;
    if (_e129 > _e131) {
        let _e134 = params.member.member_1.member_1;
        phi_386_ = (_e129 - _e134);
    } else {
        phi_386_ = 0u;
    }
    let _e137 = phi_386_;
    let _e139 = params.member.member_1.member;
    let _e141 = select(_e137, _e139, (_e139 < _e137));
    let _e142 = (_e141 / 64u);
    let _e146 = select(_e142, (_e142 + 1u), ((_e141 % 64u) > 0u));
    if (_e146 > _e119) {
        let _e148 = (_e146 - _e119);
        if (_e122 == 0u) {
            return;
        }
        let _e150 = (_e148 / _e122);
        if (_e122 == 0u) {
            return;
        }
        phi_431_ = select(_e150, (_e150 + 1u), ((_e148 % _e122) > 0u));
    } else {
        phi_431_ = 0u;
    }
    let _e157 = phi_431_;
    phi_434_ = type_9(0u, _e157);
    loop {
        let _e160 = phi_434_;
        let _e163 = (_e160.member < _e160.member_1);
        let _e176 = (bitcast<i32>(select(0u, 1u, _e163)) != 0i);
        if _e176 {
            let _e180 = (((_e119 + (select(type_9().member_1, _e160.member, _e163) * _e122)) * 64u) + _e107);
            if (_e180 < _e141) {
                let _e184 = params.member.member_1.member_1;
                let _e186 = (2u * (_e184 + _e180));
                let _e189 = input.member[(4u + _e186)];
                let _e192 = input.member[(_e186 + 5u)];
                let _e197 = (_e192 & 2147483647u);
                if (select(1u, 0u, ((_e192 & 2147483648u) == 0u)) == 0u) {
                    let _e216 = params.member.member.member[1u];
                    let _e219 = ((2u * _e216) + (3u * _e197));
                    let _e221 = elements.member[_e219];
                    let _e224 = elements.member[(_e219 + 1u)];
                    let _e227 = elements.member[(_e219 + 2u)];
                    phi_606_ = type_23(0u, array<u32, 4>(_e189, _e221, _e224, _e227));
                } else {
                    let _e200 = (2u * _e189);
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    let _e206 = (2u * _e197);
                    let _e208 = elements.member[_e206];
                    let _e211 = elements.member[(_e206 + 1u)];
                    phi_606_ = type_23(1u, array<u32, 4>(_e202, _e205, _e208, _e211));
                }
                let _e231 = phi_606_;
                let _e235 = params.member.member.member_1;
                if ((_e235 & 8u) != 0u) {
                    let _e279 = paths.member[_e231.member_1[0]];
                    let _e294 = paths.member[_e231.member_1[1]];
                    let _e309 = paths.member[_e231.member_1[2]];
                    let _e324 = paths.member[_e231.member_1[3]];
                    let _e345 = function_(array<f32, 3>(_e279.member.x, _e279.member.y, _e279.member.z));
                    let _e346 = function_(array<f32, 3>(_e294.member.x, _e294.member.y, _e294.member.z));
                    let _e347 = function_(array<f32, 3>(_e309.member.x, _e309.member.y, _e309.member.z));
                    let _e348 = function_(array<f32, 3>(_e324.member.x, _e324.member.y, _e324.member.z));
                    let _e350 = function_(array<f32, 3>(_e279.member_1.x, _e279.member_1.y, _e279.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e294.member_1.x, _e294.member_1.y, _e294.member_1.z));
                    let _e352 = function_(array<f32, 3>(_e309.member_1.x, _e309.member_1.y, _e309.member_1.z));
                    let _e353 = function_(array<f32, 3>(_e324.member_1.x, _e324.member_1.y, _e324.member_1.z));
                    phi_802_ = type_31(array<array<f64, 3>, 4>(_e345, _e346, _e347, _e348), array<array<f64, 3>, 4>(_e350, _e351, _e352, _e353));
                } else {
                    let _e240 = positions.member[_e231.member_1[0]];
                    let _e243 = params.member.member.member[0u];
                    let _e246 = positions.member[(_e243 + _e231.member_1[0])];
                    let _e249 = positions.member[_e231.member_1[1]];
                    let _e252 = params.member.member.member[0u];
                    let _e255 = positions.member[(_e252 + _e231.member_1[1])];
                    let _e258 = positions.member[_e231.member_1[2]];
                    let _e261 = params.member.member.member[0u];
                    let _e264 = positions.member[(_e261 + _e231.member_1[2])];
                    let _e267 = positions.member[_e231.member_1[3]];
                    let _e270 = params.member.member.member[0u];
                    let _e273 = positions.member[(_e270 + _e231.member_1[3])];
                    phi_802_ = type_31(array<array<f64, 3>, 4>(_e240, _e249, _e258, _e267), array<array<f64, 3>, 4>(_e246, _e255, _e264, _e273));
                }
                let _e357 = phi_802_;
                if (_e231.member != 0u) {
                    phi_963_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[0][0]), (_e357.member[2][1] - _e357.member[0][1]), (_e357.member[2][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[0][0]), (_e357.member_1[2][1] - _e357.member_1[0][1]), (_e357.member_1[2][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[1][0] - _e357.member[0][0]), (_e357.member[1][1] - _e357.member[0][1]), (_e357.member[1][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[1][0] - _e357.member_1[0][0]), (_e357.member_1[1][1] - _e357.member_1[0][1]), (_e357.member_1[1][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[3][0]), (_e357.member[2][1] - _e357.member[3][1]), (_e357.member[2][2] - _e357.member[3][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[3][0]), (_e357.member_1[2][1] - _e357.member_1[3][1]), (_e357.member_1[2][2] - _e357.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_963_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[0][0] - _e357.member[1][0]), (_e357.member[0][1] - _e357.member[1][1]), (_e357.member[0][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[0][0] - _e357.member_1[1][0]), (_e357.member_1[0][1] - _e357.member_1[1][1]), (_e357.member_1[0][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[1][0]), (_e357.member[2][1] - _e357.member[1][1]), (_e357.member[2][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[1][0]), (_e357.member_1[2][1] - _e357.member_1[1][1]), (_e357.member_1[2][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[3][0] - _e357.member[1][0]), (_e357.member[3][1] - _e357.member[1][1]), (_e357.member[3][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[3][0] - _e357.member_1[1][0]), (_e357.member_1[3][1] - _e357.member_1[1][1]), (_e357.member_1[3][2] - _e357.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e516 = phi_963_;
                let _e518 = params.member.member.member_14;
                let _e525 = bitcast<f64>(((u64(_e518[1]) * 4294967296lu) + u64(_e518[0])));
                let _e527 = params.member.member.member_15;
                let _e534 = bitcast<f64>(((u64(_e527[1]) * 4294967296lu) + u64(_e527[0])));
                let _e536 = params.member.member.member_16;
                let _e543 = bitcast<f64>(((u64(_e536[1]) * 4294967296lu) + u64(_e536[0])));
                let _e545 = params.member.member.member_16;
                let _e552 = bitcast<f64>(((u64(_e545[1]) * 4294967296lu) + u64(_e545[0])));
                let _e553 = f64(0f);
                let _e559 = select(_e516.member[0][0], -(_e516.member[0][0]), (_e516.member[0][0] < 0.0lf));
                let _e563 = select(_e516.member[0][1], -(_e516.member[0][1]), (_e516.member[0][1] < 0.0lf));
                let _e565 = select(_e563, _e559, (_e559 > _e563));
                let _e569 = select(_e516.member[0][2], -(_e516.member[0][2]), (_e516.member[0][2] < 0.0lf));
                let _e571 = select(_e569, _e565, (_e565 > _e569));
                let _e577 = select(_e516.member[1][0], -(_e516.member[1][0]), (_e516.member[1][0] < 0.0lf));
                let _e581 = select(_e516.member[1][1], -(_e516.member[1][1]), (_e516.member[1][1] < 0.0lf));
                let _e583 = select(_e581, _e577, (_e577 > _e581));
                let _e587 = select(_e516.member[1][2], -(_e516.member[1][2]), (_e516.member[1][2] < 0.0lf));
                let _e589 = select(_e587, _e583, (_e583 > _e587));
                let _e593 = (select(_e589, _e571, (_e571 > _e589)) + _e516.member_3);
                let _e599 = select(_e516.member_1[0][0], -(_e516.member_1[0][0]), (_e516.member_1[0][0] < 0.0lf));
                let _e603 = select(_e516.member_1[0][1], -(_e516.member_1[0][1]), (_e516.member_1[0][1] < 0.0lf));
                let _e605 = select(_e603, _e599, (_e599 > _e603));
                let _e609 = select(_e516.member_1[0][2], -(_e516.member_1[0][2]), (_e516.member_1[0][2] < 0.0lf));
                let _e611 = select(_e609, _e605, (_e605 > _e609));
                let _e617 = select(_e516.member_1[1][0], -(_e516.member_1[1][0]), (_e516.member_1[1][0] < 0.0lf));
                let _e621 = select(_e516.member_1[1][1], -(_e516.member_1[1][1]), (_e516.member_1[1][1] < 0.0lf));
                let _e623 = select(_e621, _e617, (_e617 > _e621));
                let _e627 = select(_e516.member_1[1][2], -(_e516.member_1[1][2]), (_e516.member_1[1][2] < 0.0lf));
                let _e629 = select(_e627, _e623, (_e623 > _e627));
                let _e633 = (select(_e629, _e611, (_e611 > _e629)) + _e516.member_3);
                let _e639 = select(_e516.member_2[0][0], -(_e516.member_2[0][0]), (_e516.member_2[0][0] < 0.0lf));
                let _e643 = select(_e516.member_2[0][1], -(_e516.member_2[0][1]), (_e516.member_2[0][1] < 0.0lf));
                let _e645 = select(_e643, _e639, (_e639 > _e643));
                let _e649 = select(_e516.member_2[0][2], -(_e516.member_2[0][2]), (_e516.member_2[0][2] < 0.0lf));
                let _e651 = select(_e649, _e645, (_e645 > _e649));
                let _e657 = select(_e516.member_2[1][0], -(_e516.member_2[1][0]), (_e516.member_2[1][0] < 0.0lf));
                let _e661 = select(_e516.member_2[1][1], -(_e516.member_2[1][1]), (_e516.member_2[1][1] < 0.0lf));
                let _e663 = select(_e661, _e657, (_e657 > _e661));
                let _e667 = select(_e516.member_2[1][2], -(_e516.member_2[1][2]), (_e516.member_2[1][2] < 0.0lf));
                let _e669 = select(_e667, _e663, (_e663 > _e667));
                let _e673 = (select(_e669, _e651, (_e651 > _e669)) + _e516.member_3);
                let _e675 = select(_e633, _e593, (_e593 > _e633));
                let _e677 = select(_e673, _e675, (_e675 > _e673));
                if (_e677 <= f64(65536f)) {
                    phi_1236_ = (_e677 >= f64((1f / 65536f)));
                } else {
                    phi_1236_ = false;
                }
                let _e684 = phi_1236_;
                if _e684 {
                    phi_1336_ = type_42();
                    phi_1337_ = true;
                } else {
                    if (_e677 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e677) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e691 = (9214364837600034816lu - (bitcast<u64>(_e677) & 9218868437227405312lu));
                            let _e694 = bitcast<f64>(select(4503599627370496lu, _e691, (_e691 > 4503599627370496lu)));
                            let _e695 = (_e553 * _e694);
                            phi_1332_ = type_42(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e516.member[0][0] * _e694), (_e516.member[0][1] * _e694), (_e516.member[0][2] * _e694)), array<f64, 3>((_e516.member[1][0] * _e694), (_e516.member[1][1] * _e694), (_e516.member[1][2] * _e694))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_1[0][0] * _e694), (_e516.member_1[0][1] * _e694), (_e516.member_1[0][2] * _e694)), array<f64, 3>((_e516.member_1[1][0] * _e694), (_e516.member_1[1][1] * _e694), (_e516.member_1[1][2] * _e694))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_2[0][0] * _e694), (_e516.member_2[0][1] * _e694), (_e516.member_2[0][2] * _e694)), array<f64, 3>((_e516.member_2[1][0] * _e694), (_e516.member_2[1][1] * _e694), (_e516.member_2[1][2] * _e694))), ((_e516.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e694)), select(_e695, select(2.2250738585072014e-308lf, _e695, (_e695 > 2.2250738585072014e-308lf)), (_e553 > f64(0f))));
                            phi_1333_ = false;
                        } else {
                            phi_1332_ = type_42();
                            phi_1333_ = true;
                        }
                        let _e766 = phi_1332_;
                        let _e768 = phi_1333_;
                        phi_1334_ = _e766;
                        phi_1335_ = _e768;
                    } else {
                        phi_1334_ = type_42();
                        phi_1335_ = true;
                    }
                    let _e770 = phi_1334_;
                    let _e772 = phi_1335_;
                    phi_1336_ = _e770;
                    phi_1337_ = _e772;
                }
                let _e774 = phi_1336_;
                let _e776 = phi_1337_;
                if _e776 {
                    phi_1342_ = type_42(_e516, _e553);
                } else {
                    phi_1342_ = _e774;
                }
                let _e779 = phi_1342_;
                local_7 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e779.member.member[0][0], _e779.member.member[0][1], _e779.member.member[0][2]), array<f64, 3>(_e779.member.member[1][0], _e779.member.member[1][1], _e779.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e779.member.member_1[0][0], _e779.member.member_1[0][1], _e779.member.member_1[0][2]), array<f64, 3>(_e779.member.member_1[1][0], _e779.member.member_1[1][1], _e779.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e779.member.member_2[0][0], _e779.member.member_2[0][1], _e779.member.member_2[0][2]), array<f64, 3>(_e779.member.member_2[1][0], _e779.member.member_2[1][1], _e779.member.member_2[1][2])), _e779.member.member_3);
                let _e819 = f64(0f);
                let _e822 = local_7.member_1[0u];
                let _e828 = local_7.member_2[0u];
                let _e834 = ((_e822[1] * _e828[2]) - (_e822[2] * _e828[1]));
                let _e837 = ((_e822[2] * _e828[0]) - (_e822[0] * _e828[2]));
                let _e840 = ((_e822[0] * _e828[1]) - (_e822[1] * _e828[0]));
                let _e843 = local_7.member_1[1u];
                let _e849 = local_7.member_2[1u];
                let _e855 = ((_e843[1] * _e849[2]) - (_e843[2] * _e849[1]));
                let _e858 = ((_e843[2] * _e849[0]) - (_e843[0] * _e849[2]));
                let _e861 = ((_e843[0] * _e849[1]) - (_e843[1] * _e849[0]));
                let _e864 = local_7.member_1[0u];
                let _e870 = local_7.member_2[1u];
                let _e885 = local_7.member_1[1u];
                let _e891 = local_7.member_2[0u];
                let _e904 = (((_e864[1] * _e870[2]) - (_e864[2] * _e870[1])) + ((_e885[1] * _e891[2]) - (_e885[2] * _e891[1])));
                let _e905 = (((_e864[2] * _e870[0]) - (_e864[0] * _e870[2])) + ((_e885[2] * _e891[0]) - (_e885[0] * _e891[2])));
                let _e906 = (((_e864[0] * _e870[1]) - (_e864[1] * _e870[0])) + ((_e885[0] * _e891[1]) - (_e885[1] * _e891[0])));
                let _e909 = local_7.member[0u];
                let _e917 = (((_e909[0] * _e834) + (_e909[1] * _e837)) + (_e909[2] * _e840));
                let _e920 = local_7.member[1u];
                let _e931 = local_7.member[0u];
                let _e940 = ((((_e920[0] * _e834) + (_e920[1] * _e837)) + (_e920[2] * _e840)) + (((_e931[0] * _e904) + (_e931[1] * _e905)) + (_e931[2] * _e906)));
                let _e943 = local_7.member[0u];
                let _e954 = local_7.member[1u];
                let _e963 = ((((_e943[0] * _e855) + (_e943[1] * _e858)) + (_e943[2] * _e861)) + (((_e954[0] * _e904) + (_e954[1] * _e905)) + (_e954[2] * _e906)));
                let _e966 = local_7.member[1u];
                let _e974 = (((_e966[0] * _e855) + (_e966[1] * _e858)) + (_e966[2] * _e861));
                let _e977 = local_7.member[0u];
                let _e983 = select(_e977[0], -(_e977[0]), (_e977[0] < 0.0lf));
                let _e986 = select(_e977[1], -(_e977[1]), (_e977[1] < 0.0lf));
                let _e988 = select(_e986, _e983, (_e983 > _e986));
                let _e991 = select(_e977[2], -(_e977[2]), (_e977[2] < 0.0lf));
                let _e993 = select(_e991, _e988, (_e988 > _e991));
                let _e996 = local_7.member[1u];
                let _e1002 = select(_e996[0], -(_e996[0]), (_e996[0] < 0.0lf));
                let _e1005 = select(_e996[1], -(_e996[1]), (_e996[1] < 0.0lf));
                let _e1007 = select(_e1005, _e1002, (_e1002 > _e1005));
                let _e1010 = select(_e996[2], -(_e996[2]), (_e996[2] < 0.0lf));
                let _e1012 = select(_e1010, _e1007, (_e1007 > _e1010));
                let _e1016 = local_7.member_3;
                let _e1017 = (select(_e1012, _e993, (_e993 > _e1012)) + _e1016);
                let _e1020 = local_7.member_1[0u];
                let _e1026 = select(_e1020[0], -(_e1020[0]), (_e1020[0] < 0.0lf));
                let _e1029 = select(_e1020[1], -(_e1020[1]), (_e1020[1] < 0.0lf));
                let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                let _e1034 = select(_e1020[2], -(_e1020[2]), (_e1020[2] < 0.0lf));
                let _e1036 = select(_e1034, _e1031, (_e1031 > _e1034));
                let _e1039 = local_7.member_1[1u];
                let _e1045 = select(_e1039[0], -(_e1039[0]), (_e1039[0] < 0.0lf));
                let _e1048 = select(_e1039[1], -(_e1039[1]), (_e1039[1] < 0.0lf));
                let _e1050 = select(_e1048, _e1045, (_e1045 > _e1048));
                let _e1053 = select(_e1039[2], -(_e1039[2]), (_e1039[2] < 0.0lf));
                let _e1055 = select(_e1053, _e1050, (_e1050 > _e1053));
                let _e1059 = local_7.member_3;
                let _e1060 = (select(_e1055, _e1036, (_e1036 > _e1055)) + _e1059);
                let _e1063 = local_7.member_2[0u];
                let _e1069 = select(_e1063[0], -(_e1063[0]), (_e1063[0] < 0.0lf));
                let _e1072 = select(_e1063[1], -(_e1063[1]), (_e1063[1] < 0.0lf));
                let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                let _e1077 = select(_e1063[2], -(_e1063[2]), (_e1063[2] < 0.0lf));
                let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                let _e1082 = local_7.member_2[1u];
                let _e1088 = select(_e1082[0], -(_e1082[0]), (_e1082[0] < 0.0lf));
                let _e1091 = select(_e1082[1], -(_e1082[1]), (_e1082[1] < 0.0lf));
                let _e1093 = select(_e1091, _e1088, (_e1088 > _e1091));
                let _e1096 = select(_e1082[2], -(_e1082[2]), (_e1082[2] < 0.0lf));
                let _e1098 = select(_e1096, _e1093, (_e1093 > _e1096));
                let _e1102 = local_7.member_3;
                let _e1103 = (select(_e1098, _e1079, (_e1079 > _e1098)) + _e1102);
                let _e1104 = f64(1f);
                let _e1105 = f64(8f);
                let _e1107 = ((_e1060 * _e1105) * _e1103);
                let _e1115 = local_7.member_3;
                let _e1142 = ((select(_e834, -(_e834), (_e834 < 0.0lf)) + select(_e837, -(_e837), (_e837 < 0.0lf))) + select(_e840, -(_e840), (_e840 < 0.0lf)));
                let _e1153 = ((select(_e855, -(_e855), (_e855 < 0.0lf)) + select(_e858, -(_e858), (_e858 < 0.0lf))) + select(_e861, -(_e861), (_e861 < 0.0lf)));
                let _e1155 = select(_e1153, _e1142, (_e1142 > _e1153));
                let _e1167 = (((select(_e904, -(_e904), (_e904 < 0.0lf)) + select(_e905, -(_e905), (_e905 < 0.0lf))) + select(_e906, -(_e906), (_e906 < 0.0lf))) * f64(0.5f));
                let _e1175 = local_7.member_3;
                let _e1189 = (((((_e1017 * _e1105) * _e1107) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1115 * f64(19f)) * ((_e1017 * (_e1060 + _e1103)) + (_e1060 * _e1103)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1104 + _e1017) * ((_e1104 + _e1060) * (_e1104 + _e1103)))));
                let _e1190 = f64(3f);
                let _e1191 = (_e917 * _e1190);
                let _e1192 = (_e974 * _e1190);
                let _e1194 = select(_e1192, _e1191, (_e1191 < _e1192));
                let _e1196 = select(_e963, _e940, (_e940 < _e963));
                let _e1198 = select(_e1196, _e1194, (_e1194 < _e1196));
                let _e1200 = select(_e1192, _e1191, (_e1191 > _e1192));
                let _e1202 = select(_e963, _e940, (_e940 > _e963));
                let _e1205 = -(select(_e1202, _e1200, (_e1200 > _e1202)));
                if ((select(_e1205, _e1198, (_e1198 > _e1205)) - (_e1189 + ((_e819 * (((select(_e1167, _e1155, (_e1155 > _e1167)) + (_e1107 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1175 * f64(6f)) * (_e1060 + _e1103))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1104 + _e1060) * (_e1104 + _e1103))))) * f64((3f * 1.0001f))))) > _e819) {
                    phi_6677_ = type_43(0u, type_43().member_1);
                    phi_6678_ = type_43();
                    phi_6679_ = true;
                } else {
                    let _e1219 = select(_e917, -(_e917), (_e917 < 0.0lf));
                    let _e1222 = select(_e940, -(_e940), (_e940 < 0.0lf));
                    let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                    let _e1227 = select(_e963, -(_e963), (_e963 < 0.0lf));
                    let _e1230 = select(_e974, -(_e974), (_e974 < 0.0lf));
                    let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                    let _e1234 = select(_e1232, _e1224, (_e1224 > _e1232));
                    let _e1236 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1237 = f64(1f);
                    if (_e1234 >= _e1236) {
                        phi_2082_ = (_e1234 <= (_e1237 / _e1236));
                    } else {
                        phi_2082_ = false;
                    }
                    let _e1242 = phi_2082_;
                    if _e1242 {
                        phi_2097_ = (_e1237 / _e1234);
                    } else {
                        phi_2097_ = f64(0f);
                    }
                    let _e1252 = phi_2097_;
                    let _e1253 = f64(0.00000000000022737368f);
                    let _e1255 = (_e525 * f64(0.0625f));
                    local_5 = type_40(array<f64, 4>(_e917, _e940, _e963, _e974), ((_e1189 * f64(0.34f)) + (_e1234 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1242))), _e1252, select(_e1255, _e1253, (_e1253 < _e1255)));
                    let _e1260 = f64(0f);
                    let _e1261 = f64(1f);
                    let _e1262 = f64(3f);
                    let _e1265 = local_5.member[0u];
                    let _e1268 = local_5.member[1u];
                    let _e1271 = local_5.member[2u];
                    let _e1274 = local_5.member[3u];
                    let _e1281 = local_5.member_2;
                    let _e1282 = ((_e1268 - (_e1262 * _e1265)) * _e1281);
                    let _e1284 = local_5.member_2;
                    let _e1285 = ((_e1271 - _e1268) * _e1284);
                    let _e1287 = local_5.member_2;
                    let _e1288 = (((_e1262 * _e1274) - _e1271) * _e1287);
                    local_3[0u] = _e1260;
                    local_3[1u] = _e1261;
                    local_3[2u] = _e1261;
                    local_3[3u] = _e1261;
                    let _e1295 = ((_e1285 * _e1285) - (_e1282 * _e1288));
                    if (_e1295 > _e1260) {
                        if (_e1295 <= 2.2250738585072014e-308lf) {
                            phi_2230_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1295 > 0.0lf));
                        } else {
                            phi_2173_ = type_16(0i, 5i);
                            phi_2176_ = bitcast<f64>(((bitcast<u64>(_e1295) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1303 = phi_2173_;
                                let _e1305 = phi_2176_;
                                local_8 = _e1305;
                                if (_e1303.member < _e1303.member_1) {
                                    let _e1312 = (_e1303.member + 1i);
                                    phi_2174_ = type_16(select(_e1312, type_17().member_1, select(false, true, ((false == (_e1312 > _e1303.member)) != false))), _e1303.member_1);
                                    phi_2217_ = type_17(1u, _e1303.member);
                                } else {
                                    phi_2174_ = _e1303;
                                    phi_2217_ = type_17(0u, type_17().member_1);
                                }
                                let _e1323 = phi_2174_;
                                let _e1325 = phi_2217_;
                                let _e1328 = (bitcast<i32>(_e1325.member) != 0i);
                                if _e1328 {
                                    phi_2177_ = (0.5lf * (_e1305 + (_e1295 / _e1305)));
                                } else {
                                    phi_2177_ = f64();
                                }
                                let _e1333 = phi_2177_;
                                continue;
                                continuing {
                                    phi_2173_ = _e1323;
                                    phi_2176_ = _e1333;
                                    break if !(_e1328);
                                }
                            }
                            let _e1338 = local_8;
                            phi_2230_ = (_e1338 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1344 = phi_2230_;
                        let _e1349 = -((_e1285 + select(_e1344, -(_e1344), (_e1285 < _e1260))));
                        local_4[0u] = (_e1349 / (_e1349 + _e1288));
                        local_4[1u] = (_e1282 / (_e1282 + _e1349));
                        let _e1358 = local_4[1u];
                        let _e1359 = local_4[0u];
                        if (_e1358 < _e1359) {
                            let _e1362 = local_4[1u];
                            let _e1364 = local_4[0u];
                            local_4[0u] = _e1362;
                            local_4[1u] = _e1364;
                        }
                        phi_2261_ = type_9(0u, 2u);
                        phi_2264_ = 1u;
                        loop {
                            let _e1368 = phi_2261_;
                            let _e1370 = phi_2264_;
                            local_44 = _e1370;
                            let _e1373 = (_e1368.member < _e1368.member_1);
                            let _e1384 = select(type_9().member_1, _e1368.member, _e1373);
                            let _e1386 = (bitcast<i32>(select(0u, 1u, _e1373)) != 0i);
                            if _e1386 {
                                let _e1388 = local_4[_e1384];
                                if (_e1388 > _e1260) {
                                    let _e1391 = local_4[_e1384];
                                    if (_e1391 < _e1261) {
                                        let _e1394 = local_4[_e1384];
                                        local_3[_e1370] = _e1394;
                                        phi_2331_ = (_e1370 + 1u);
                                    } else {
                                        phi_2331_ = _e1370;
                                    }
                                    let _e1398 = phi_2331_;
                                    phi_2332_ = _e1398;
                                } else {
                                    phi_2332_ = _e1370;
                                }
                                let _e1400 = phi_2332_;
                                phi_2265_ = _e1400;
                            } else {
                                phi_2265_ = u32();
                            }
                            let _e1402 = phi_2265_;
                            continue;
                            continuing {
                                phi_2261_ = type_9(select(_e1368.member, (_e1368.member + 1u), _e1373), select(_e1368.member_1, _e1368.member_1, _e1373));
                                phi_2264_ = _e1402;
                                break if !(_e1386);
                            }
                        }
                        let _e4421 = local_44;
                        phi_2333_ = _e4421;
                    } else {
                        phi_2333_ = 1u;
                    }
                    let _e1405 = phi_2333_;
                    local_3[_e1405] = _e1261;
                    let _e1407 = local_3;
                    local_6 = _e1407;
                    let _e1409 = (_e525 * f64(0.99f));
                    let _e1411 = (f64(1f) - _e534);
                    let _e1414 = local_5.member[0u];
                    let _e1417 = local_5.member[1u];
                    let _e1420 = local_5.member[2u];
                    let _e1423 = local_5.member[3u];
                    let _e1434 = ((((_e1414 * _e1411) + (_e1417 * _e534)) * (_e1411 * _e1411)) + (((_e1420 * _e1411) + (_e1423 * _e534)) * (_e534 * _e534)));
                    let _e1439 = local_5.member_1;
                    phi_2391_ = type_9(select(1u, 0u, !((select(_e1434, -(_e1434), (_e1434 < 0.0lf)) > _e1439))), (_e1405 + 1u));
                    loop {
                        let _e1446 = phi_2391_;
                        let _e1449 = (_e1446.member < _e1446.member_1);
                        let _e1460 = select(type_9().member_1, _e1446.member, _e1449);
                        if (bitcast<i32>(select(0u, 1u, _e1449)) != 0i) {
                            if (_e1460 > 0u) {
                                let _e1467 = local_6[(_e1460 - 1u)];
                                let _e1469 = select(_e534, _e1467, (_e1467 > _e534));
                                let _e1471 = local_6[_e1460];
                                let _e1473 = select(_e543, _e1471, (_e1471 < _e543));
                                if (_e1469 <= _e1473) {
                                    let _e1475 = function_5((&local_5), _e552, _e1469, _e1473);
                                    if _e1475 {
                                        phi_3833_ = type_44();
                                        phi_3834_ = bool();
                                        phi_3835_ = type_44();
                                        phi_3836_ = false;
                                        phi_3837_ = false;
                                        phi_3838_ = false;
                                        phi_3839_ = false;
                                    } else {
                                        let _e1477 = (f64(1f) - _e1469);
                                        let _e1480 = local_5.member[0u];
                                        let _e1483 = local_5.member[1u];
                                        let _e1486 = local_5.member[2u];
                                        let _e1489 = local_5.member[3u];
                                        let _e1500 = ((((_e1480 * _e1477) + (_e1483 * _e1469)) * (_e1477 * _e1477)) + (((_e1486 * _e1477) + (_e1489 * _e1469)) * (_e1469 * _e1469)));
                                        let _e1502 = (f64(1f) - _e1473);
                                        let _e1505 = local_5.member[0u];
                                        let _e1508 = local_5.member[1u];
                                        let _e1511 = local_5.member[2u];
                                        let _e1514 = local_5.member[3u];
                                        let _e1525 = ((((_e1505 * _e1502) + (_e1508 * _e1473)) * (_e1502 * _e1502)) + (((_e1511 * _e1502) + (_e1514 * _e1473)) * (_e1473 * _e1473)));
                                        let _e1530 = local_5.member_1;
                                        let _e1531 = (select(_e1500, -(_e1500), (_e1500 < 0.0lf)) > _e1530);
                                        let _e1536 = local_5.member_1;
                                        let _e1537 = (select(_e1525, -(_e1525), (_e1525 < 0.0lf)) > _e1536);
                                        let _e1538 = f64(0f);
                                        let _e1546 = select(select(bool(), select(bool(), ((_e1500 > _e1538) != (_e1525 > _e1538)), _e1537), _e1531), false, select(true, select(true, false, _e1537), _e1531));
                                        if _e1531 {
                                            if _e1537 {
                                                phi_2551_ = type_44(select(f64(1f), type_44().member, _e1546), select(_e1538, type_44().member_1, _e1546), select(_e1546, type_44().member_2, _e1546));
                                                phi_2552_ = _e1546;
                                            } else {
                                                phi_2551_ = type_44();
                                                phi_2552_ = true;
                                            }
                                            let _e1556 = phi_2551_;
                                            let _e1558 = phi_2552_;
                                            phi_2553_ = _e1556;
                                            phi_2554_ = _e1558;
                                        } else {
                                            phi_2553_ = type_44();
                                            phi_2554_ = true;
                                        }
                                        let _e1560 = phi_2553_;
                                        let _e1562 = phi_2554_;
                                        if _e1562 {
                                            if _e1531 {
                                                let _e1566 = select(f64(1f), f64(-1f), (_e1500 < _e1538));
                                                let _e1568 = local_5.member_3;
                                                let _e1569 = f64(0.5f);
                                                let _e1570 = f64(3f);
                                                let _e1573 = local_5.member[0u];
                                                let _e1576 = local_5.member[1u];
                                                let _e1579 = local_5.member[2u];
                                                let _e1582 = local_5.member[3u];
                                                let _e1585 = (_e1579 - _e1576);
                                                phi_2589_ = type_9(0u, 64u);
                                                phi_2592_ = _e1473;
                                                phi_2594_ = _e1469;
                                                phi_2596_ = (_e1569 * (_e1469 + _e1473));
                                                loop {
                                                    let _e1591 = phi_2589_;
                                                    let _e1593 = phi_2592_;
                                                    let _e1595 = phi_2594_;
                                                    let _e1597 = phi_2596_;
                                                    local_11 = _e1595;
                                                    let _e1600 = (_e1591.member < _e1591.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1600)) != 0i) {
                                                        let _e1613 = (f64(1f) - _e1597);
                                                        let _e1616 = local_5.member[0u];
                                                        let _e1619 = local_5.member[1u];
                                                        let _e1622 = local_5.member[2u];
                                                        let _e1625 = local_5.member[3u];
                                                        let _e1639 = local_5.member_1;
                                                        let _e1640 = ((_e1566 * ((((_e1616 * _e1613) + (_e1619 * _e1597)) * (_e1613 * _e1613)) + (((_e1622 * _e1613) + (_e1625 * _e1597)) * (_e1597 * _e1597)))) - _e1639);
                                                        let _e1642 = (_e1640 > f64(0f));
                                                        let _e1643 = select(_e1597, _e1593, _e1642);
                                                        let _e1644 = select(_e1595, _e1597, _e1642);
                                                        let _e1646 = ((_e1643 - _e1644) > _e1568);
                                                        if _e1646 {
                                                            let _e1648 = (f64(1f) - _e1597);
                                                            let _e1660 = (-(_e1640) / (_e1566 * (((((_e1576 - (_e1570 * _e1573)) * _e1648) + (_e1585 * _e1597)) * _e1648) + (((_e1585 * _e1648) + (((_e1570 * _e1582) - _e1579) * _e1597)) * _e1597))));
                                                            let _e1668 = ((_e1597 + _e1660) + select(-((_e1569 * _e1568)), (_e1569 * _e1568), (_e1640 > f64(0f))));
                                                            if (_e1668 > _e1644) {
                                                                phi_2710_ = select(true, select(true, false, (select(_e1660, -(_e1660), (_e1660 < 0.0lf)) < (_e1569 * (_e1643 - _e1644)))), (_e1668 < _e1643));
                                                            } else {
                                                                phi_2710_ = true;
                                                            }
                                                            let _e1680 = phi_2710_;
                                                            phi_2717_ = select(_e1668, (_e1569 * (_e1644 + _e1643)), _e1680);
                                                            phi_2718_ = false;
                                                        } else {
                                                            phi_2717_ = f64();
                                                            phi_2718_ = true;
                                                        }
                                                        let _e1685 = phi_2717_;
                                                        let _e1687 = phi_2718_;
                                                        phi_2593_ = _e1643;
                                                        phi_2595_ = _e1644;
                                                        phi_2597_ = _e1685;
                                                        phi_2719_ = _e1644;
                                                        phi_2720_ = _e1646;
                                                        phi_2721_ = _e1687;
                                                    } else {
                                                        phi_2593_ = f64();
                                                        phi_2595_ = f64();
                                                        phi_2597_ = f64();
                                                        phi_2719_ = f64();
                                                        phi_2720_ = false;
                                                        phi_2721_ = false;
                                                    }
                                                    let _e1689 = phi_2593_;
                                                    let _e1691 = phi_2595_;
                                                    let _e1693 = phi_2597_;
                                                    let _e1695 = phi_2719_;
                                                    let _e1697 = phi_2720_;
                                                    let _e1699 = phi_2721_;
                                                    local_9 = _e1699;
                                                    local_10 = _e1695;
                                                    continue;
                                                    continuing {
                                                        phi_2589_ = type_9(select(_e1591.member, (_e1591.member + 1u), _e1600), select(_e1591.member_1, _e1591.member_1, _e1600));
                                                        phi_2592_ = _e1689;
                                                        phi_2594_ = _e1691;
                                                        phi_2596_ = _e1693;
                                                        break if !(_e1697);
                                                    }
                                                }
                                                let _e1702 = local_9;
                                                let _e1704 = local_10;
                                                let _e1706 = local_11;
                                                phi_2726_ = select(_e1706, _e1704, _e1702);
                                            } else {
                                                phi_2726_ = _e1469;
                                            }
                                            let _e1709 = phi_2726_;
                                            if _e1537 {
                                                let _e1715 = local_5.member_3;
                                                let _e1717 = local_5.member_3;
                                                phi_2744_ = type_9(0u, 64u);
                                                phi_2747_ = (_e1715 + _e1717);
                                                loop {
                                                    let _e1720 = phi_2744_;
                                                    let _e1722 = phi_2747_;
                                                    let _e1725 = (_e1720.member < _e1720.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1725)) != 0i) {
                                                        let _e1737 = (_e1709 + _e1722);
                                                        if (_e1737 < _e1473) {
                                                            let _e1740 = (f64(1f) - _e1737);
                                                            let _e1743 = local_5.member[0u];
                                                            let _e1746 = local_5.member[1u];
                                                            let _e1749 = local_5.member[2u];
                                                            let _e1752 = local_5.member[3u];
                                                            let _e1766 = local_5.member_1;
                                                            let _e1767 = ((select(f64(1f), f64(-1f), (_e1525 < _e1538)) * ((((_e1743 * _e1740) + (_e1746 * _e1737)) * (_e1740 * _e1740)) + (((_e1749 * _e1740) + (_e1752 * _e1737)) * (_e1737 * _e1737)))) > _e1766);
                                                            phi_2813_ = select((_e1722 + _e1722), f64(), _e1767);
                                                            phi_2814_ = select(true, false, _e1767);
                                                            phi_2815_ = _e1767;
                                                            phi_2816_ = false;
                                                        } else {
                                                            phi_2813_ = f64();
                                                            phi_2814_ = false;
                                                            phi_2815_ = false;
                                                            phi_2816_ = true;
                                                        }
                                                        let _e1772 = phi_2813_;
                                                        let _e1774 = phi_2814_;
                                                        let _e1776 = phi_2815_;
                                                        let _e1778 = phi_2816_;
                                                        phi_2817_ = _e1737;
                                                        phi_2748_ = _e1772;
                                                        phi_2818_ = _e1774;
                                                        phi_2819_ = _e1776;
                                                        phi_2820_ = _e1778;
                                                        phi_2821_ = false;
                                                    } else {
                                                        phi_2817_ = f64();
                                                        phi_2748_ = f64();
                                                        phi_2818_ = false;
                                                        phi_2819_ = false;
                                                        phi_2820_ = false;
                                                        phi_2821_ = true;
                                                    }
                                                    let _e1780 = phi_2817_;
                                                    let _e1782 = phi_2748_;
                                                    let _e1784 = phi_2818_;
                                                    let _e1786 = phi_2819_;
                                                    let _e1788 = phi_2820_;
                                                    let _e1790 = phi_2821_;
                                                    local_12 = _e1786;
                                                    local_13 = _e1788;
                                                    local_14 = _e1786;
                                                    local_15 = _e1790;
                                                    local_16 = _e1780;
                                                    continue;
                                                    continuing {
                                                        phi_2744_ = type_9(select(_e1720.member, (_e1720.member + 1u), _e1725), select(_e1720.member_1, _e1720.member_1, _e1725));
                                                        phi_2747_ = _e1782;
                                                        break if !(_e1784);
                                                    }
                                                }
                                                let _e1793 = local_12;
                                                let _e1795 = local_13;
                                                let _e1798 = local_14;
                                                let _e1800 = local_15;
                                                let _e1804 = local_16;
                                                phi_2835_ = select(_e1804, _e1473, select(select(_e1800, false, _e1798), true, select(_e1795, false, _e1793)));
                                            } else {
                                                phi_2835_ = _e1473;
                                            }
                                            let _e1807 = phi_2835_;
                                            phi_2837_ = type_44(_e1709, _e1807, _e1546);
                                        } else {
                                            phi_2837_ = _e1560;
                                        }
                                        let _e1810 = phi_2837_;
                                        if (_e1810.member > _e1810.member_1) {
                                            phi_3828_ = bool();
                                            phi_3829_ = true;
                                            phi_3830_ = false;
                                            phi_3831_ = false;
                                            phi_3832_ = false;
                                        } else {
                                            let _e1815 = (_e1810.member > _e552);
                                            if _e1815 {
                                                phi_3824_ = bool();
                                                phi_3825_ = false;
                                                phi_3826_ = false;
                                                phi_3827_ = false;
                                            } else {
                                                let _e1820 = ((_e1810.member_1 - _e1810.member) * f64(0.5f));
                                                let _e1821 = (_e1810.member + _e1820);
                                                let _e1824 = (_e1820 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1826 = local_7.member_3;
                                                let _e1829 = local_7.member[0u];
                                                let _e1835 = select(_e1829[0], -(_e1829[0]), (_e1829[0] < 0.0lf));
                                                let _e1838 = select(_e1829[1], -(_e1829[1]), (_e1829[1] < 0.0lf));
                                                let _e1840 = select(_e1838, _e1835, (_e1835 > _e1838));
                                                let _e1843 = select(_e1829[2], -(_e1829[2]), (_e1829[2] < 0.0lf));
                                                let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                let _e1847 = local_7.member[1u];
                                                let _e1853 = select(_e1847[0], -(_e1847[0]), (_e1847[0] < 0.0lf));
                                                let _e1856 = select(_e1847[1], -(_e1847[1]), (_e1847[1] < 0.0lf));
                                                let _e1858 = select(_e1856, _e1853, (_e1853 > _e1856));
                                                let _e1861 = select(_e1847[2], -(_e1847[2]), (_e1847[2] < 0.0lf));
                                                let _e1863 = select(_e1861, _e1858, (_e1858 > _e1861));
                                                let _e1868 = local_7.member[0u];
                                                let _e1873 = local_7.member[1u];
                                                let _e1883 = (_e1868[0] + ((_e1873[0] - _e1868[0]) * _e1821));
                                                let _e1884 = (_e1868[1] + ((_e1873[1] - _e1868[1]) * _e1821));
                                                let _e1885 = (_e1868[2] + ((_e1873[2] - _e1868[2]) * _e1821));
                                                let _e1887 = local_7.member[1u];
                                                let _e1892 = local_7.member[0u];
                                                let _e1896 = (_e1887[0] - _e1892[0]);
                                                let _e1897 = (_e1887[1] - _e1892[1]);
                                                let _e1898 = (_e1887[2] - _e1892[2]);
                                                let _e1901 = select(_e1896, -(_e1896), (_e1896 < 0.0lf));
                                                let _e1904 = select(_e1897, -(_e1897), (_e1897 < 0.0lf));
                                                let _e1906 = select(_e1904, _e1901, (_e1901 > _e1904));
                                                let _e1909 = select(_e1898, -(_e1898), (_e1898 < 0.0lf));
                                                let _e1919 = ((((_e1824 * select(_e1909, _e1906, (_e1906 > _e1909))) * f64(1.01f)) + ((select(_e1863, _e1845, (_e1845 > _e1863)) + _e1826) * (1.1102230246251565e-16lf * f64(8f)))) + _e1826);
                                                let _e1922 = select(_e1883, -(_e1883), (_e1883 < 0.0lf));
                                                let _e1925 = select(_e1884, -(_e1884), (_e1884 < 0.0lf));
                                                let _e1927 = select(_e1925, _e1922, (_e1922 > _e1925));
                                                let _e1930 = select(_e1885, -(_e1885), (_e1885 < 0.0lf));
                                                let _e1933 = (select(_e1930, _e1927, (_e1927 > _e1930)) + _e1919);
                                                let _e1936 = local_7.member_3;
                                                let _e1938 = local_7.member_1[0u];
                                                let _e1944 = select(_e1938[0], -(_e1938[0]), (_e1938[0] < 0.0lf));
                                                let _e1947 = select(_e1938[1], -(_e1938[1]), (_e1938[1] < 0.0lf));
                                                let _e1949 = select(_e1947, _e1944, (_e1944 > _e1947));
                                                let _e1952 = select(_e1938[2], -(_e1938[2]), (_e1938[2] < 0.0lf));
                                                let _e1954 = select(_e1952, _e1949, (_e1949 > _e1952));
                                                let _e1956 = local_7.member_1[1u];
                                                let _e1962 = select(_e1956[0], -(_e1956[0]), (_e1956[0] < 0.0lf));
                                                let _e1965 = select(_e1956[1], -(_e1956[1]), (_e1956[1] < 0.0lf));
                                                let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                let _e1970 = select(_e1956[2], -(_e1956[2]), (_e1956[2] < 0.0lf));
                                                let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                let _e1977 = local_7.member_1[0u];
                                                let _e1982 = local_7.member_1[1u];
                                                let _e1992 = (_e1977[0] + ((_e1982[0] - _e1977[0]) * _e1821));
                                                let _e1993 = (_e1977[1] + ((_e1982[1] - _e1977[1]) * _e1821));
                                                let _e1994 = (_e1977[2] + ((_e1982[2] - _e1977[2]) * _e1821));
                                                let _e1996 = local_7.member_1[1u];
                                                let _e2001 = local_7.member_1[0u];
                                                let _e2005 = (_e1996[0] - _e2001[0]);
                                                let _e2006 = (_e1996[1] - _e2001[1]);
                                                let _e2007 = (_e1996[2] - _e2001[2]);
                                                let _e2010 = select(_e2005, -(_e2005), (_e2005 < 0.0lf));
                                                let _e2013 = select(_e2006, -(_e2006), (_e2006 < 0.0lf));
                                                let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                let _e2018 = select(_e2007, -(_e2007), (_e2007 < 0.0lf));
                                                let _e2028 = ((((_e1824 * select(_e2018, _e2015, (_e2015 > _e2018))) * f64(1.01f)) + ((select(_e1972, _e1954, (_e1954 > _e1972)) + _e1936) * (1.1102230246251565e-16lf * f64(8f)))) + _e1936);
                                                let _e2031 = select(_e1992, -(_e1992), (_e1992 < 0.0lf));
                                                let _e2034 = select(_e1993, -(_e1993), (_e1993 < 0.0lf));
                                                let _e2036 = select(_e2034, _e2031, (_e2031 > _e2034));
                                                let _e2039 = select(_e1994, -(_e1994), (_e1994 < 0.0lf));
                                                let _e2042 = (select(_e2039, _e2036, (_e2036 > _e2039)) + _e2028);
                                                let _e2045 = local_7.member_3;
                                                let _e2047 = local_7.member_2[0u];
                                                let _e2053 = select(_e2047[0], -(_e2047[0]), (_e2047[0] < 0.0lf));
                                                let _e2056 = select(_e2047[1], -(_e2047[1]), (_e2047[1] < 0.0lf));
                                                let _e2058 = select(_e2056, _e2053, (_e2053 > _e2056));
                                                let _e2061 = select(_e2047[2], -(_e2047[2]), (_e2047[2] < 0.0lf));
                                                let _e2063 = select(_e2061, _e2058, (_e2058 > _e2061));
                                                let _e2065 = local_7.member_2[1u];
                                                let _e2071 = select(_e2065[0], -(_e2065[0]), (_e2065[0] < 0.0lf));
                                                let _e2074 = select(_e2065[1], -(_e2065[1]), (_e2065[1] < 0.0lf));
                                                let _e2076 = select(_e2074, _e2071, (_e2071 > _e2074));
                                                let _e2079 = select(_e2065[2], -(_e2065[2]), (_e2065[2] < 0.0lf));
                                                let _e2081 = select(_e2079, _e2076, (_e2076 > _e2079));
                                                let _e2086 = local_7.member_2[0u];
                                                let _e2091 = local_7.member_2[1u];
                                                let _e2101 = (_e2086[0] + ((_e2091[0] - _e2086[0]) * _e1821));
                                                let _e2102 = (_e2086[1] + ((_e2091[1] - _e2086[1]) * _e1821));
                                                let _e2103 = (_e2086[2] + ((_e2091[2] - _e2086[2]) * _e1821));
                                                let _e2105 = local_7.member_2[1u];
                                                let _e2110 = local_7.member_2[0u];
                                                let _e2114 = (_e2105[0] - _e2110[0]);
                                                let _e2115 = (_e2105[1] - _e2110[1]);
                                                let _e2116 = (_e2105[2] - _e2110[2]);
                                                let _e2119 = select(_e2114, -(_e2114), (_e2114 < 0.0lf));
                                                let _e2122 = select(_e2115, -(_e2115), (_e2115 < 0.0lf));
                                                let _e2124 = select(_e2122, _e2119, (_e2119 > _e2122));
                                                let _e2127 = select(_e2116, -(_e2116), (_e2116 < 0.0lf));
                                                let _e2137 = ((((_e1824 * select(_e2127, _e2124, (_e2124 > _e2127))) * f64(1.01f)) + ((select(_e2081, _e2063, (_e2063 > _e2081)) + _e2045) * (1.1102230246251565e-16lf * f64(8f)))) + _e2045);
                                                let _e2140 = select(_e2101, -(_e2101), (_e2101 < 0.0lf));
                                                let _e2143 = select(_e2102, -(_e2102), (_e2102 < 0.0lf));
                                                let _e2145 = select(_e2143, _e2140, (_e2140 > _e2143));
                                                let _e2148 = select(_e2103, -(_e2103), (_e2103 < 0.0lf));
                                                let _e2151 = (select(_e2148, _e2145, (_e2145 > _e2148)) + _e2137);
                                                let _e2154 = ((_e1993 * _e2103) - (_e1994 * _e2102));
                                                let _e2157 = ((_e1994 * _e2101) - (_e1992 * _e2103));
                                                let _e2160 = ((_e1992 * _e2102) - (_e1993 * _e2101));
                                                let _e2175 = select(false, (select(_e2154, -(_e2154), (_e2154 < 0.0lf)) > select(_e2160, -(_e2160), (_e2160 < 0.0lf))), (select(_e2154, -(_e2154), (_e2154 < 0.0lf)) > select(_e2157, -(_e2157), (_e2157 < 0.0lf))));
                                                let _e2190 = select((select(_e2157, -(_e2157), (_e2157 < 0.0lf)) > select(_e2160, -(_e2160), (_e2160 < 0.0lf))), false, (select(_e2154, -(_e2154), (_e2154 < 0.0lf)) > select(_e2157, -(_e2157), (_e2157 < 0.0lf))));
                                                let _e2193 = select(select(_e1883, _e1884, _e2175), _e1885, _e2190);
                                                let _e2194 = select(select(_e1884, _e1885, _e2175), _e1883, _e2190);
                                                let _e2197 = select(select(_e1992, _e1993, _e2175), _e1994, _e2190);
                                                let _e2198 = select(select(_e1993, _e1994, _e2175), _e1992, _e2190);
                                                let _e2201 = select(select(_e2101, _e2102, _e2175), _e2103, _e2190);
                                                let _e2202 = select(select(_e2102, _e2103, _e2175), _e2101, _e2190);
                                                let _e2205 = ((_e2197 * _e2202) - (_e2198 * _e2201));
                                                let _e2206 = f64(1f);
                                                let _e2207 = f64(2f);
                                                let _e2225 = (((((_e2028 * _e2151) + (_e2042 * _e2137)) * f64(2.01f)) + (((_e2042 * _e2207) * (_e2151 * _e2207)) * (1.1102230246251565e-16lf * _e2207))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2206 + _e2042) * (_e2206 + _e2151))));
                                                if (select(_e2205, -(_e2205), (_e2205 < 0.0lf)) > _e2225) {
                                                    let _e2234 = select(f64(1f), f64(-1f), (_e2205 < f64(0f)));
                                                    let _e2238 = f64(1f);
                                                    let _e2239 = f64(2f);
                                                    let _e2257 = (((((_e1919 * _e2151) + (_e1933 * _e2137)) * f64(2.01f)) + (((_e1933 * _e2239) * (_e2151 * _e2239)) * (1.1102230246251565e-16lf * _e2239))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2238 + _e1933) * (_e2238 + _e2151))));
                                                    let _e2261 = f64(1f);
                                                    let _e2262 = f64(2f);
                                                    let _e2280 = (((((_e2028 * _e1933) + (_e2042 * _e1919)) * f64(2.01f)) + (((_e2042 * _e2262) * (_e1933 * _e2262)) * (1.1102230246251565e-16lf * _e2262))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2261 + _e2042) * (_e2261 + _e1933))));
                                                    let _e2281 = (_e2205 * _e2234);
                                                    let _e2282 = (((_e2193 * _e2202) - (_e2194 * _e2201)) * _e2234);
                                                    let _e2283 = (((_e2197 * _e2194) - (_e2198 * _e2193)) * _e2234);
                                                    let _e2297 = (((select(_e2281, -(_e2281), (_e2281 < 0.0lf)) + select(_e2282, -(_e2282), (_e2282 < 0.0lf))) + select(_e2283, -(_e2283), (_e2283 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e231.member != 0u) {
                                                        phi_3698_ = array<type_37, 4>(type_37(_e2282, _e2257), type_37(_e2283, _e2280), type_37((_e2281 - _e2282), ((_e2225 + _e2257) + _e2297)), type_37((_e2281 - _e2283), ((_e2225 + _e2280) + _e2297)));
                                                    } else {
                                                        let _e2300 = ((_e2281 - _e2282) - _e2283);
                                                        let _e2303 = (((_e2225 + _e2257) + _e2280) + _e2297);
                                                        phi_3698_ = array<type_37, 4>(type_37(_e2282, _e2257), type_37(_e2283, _e2280), type_37(_e2300, _e2303), type_37(_e2300, _e2303));
                                                    }
                                                    let _e2321 = phi_3698_;
                                                    local_2 = array<type_37, 4>(type_37(_e2321[0].member, _e2321[0].member_1), type_37(_e2321[1].member, _e2321[1].member_1), type_37(_e2321[2].member, _e2321[2].member_1), type_37(_e2321[3].member, _e2321[3].member_1));
                                                    phi_3718_ = type_9(0u, 4u);
                                                    phi_3721_ = true;
                                                    loop {
                                                        let _e2340 = phi_3718_;
                                                        let _e2342 = phi_3721_;
                                                        local_18 = _e2342;
                                                        let _e2345 = (_e2340.member < _e2340.member_1);
                                                        let _e2356 = select(type_9().member_1, _e2340.member, _e2345);
                                                        if (bitcast<i32>(select(0u, 1u, _e2345)) != 0i) {
                                                            let _e2361 = local_2[_e2356].member;
                                                            let _e2364 = local_2[_e2356].member_1;
                                                            let _e2366 = (_e2361 < -(_e2364));
                                                            phi_3722_ = select((_e2342 && (_e2361 > _e2364)), bool(), _e2366);
                                                            phi_3773_ = select(true, false, _e2366);
                                                            phi_3774_ = _e2366;
                                                        } else {
                                                            phi_3722_ = bool();
                                                            phi_3773_ = false;
                                                            phi_3774_ = false;
                                                        }
                                                        let _e2372 = phi_3722_;
                                                        let _e2374 = phi_3773_;
                                                        let _e2376 = phi_3774_;
                                                        local_17 = _e2376;
                                                        continue;
                                                        continuing {
                                                            phi_3718_ = type_9(select(_e2340.member, (_e2340.member + 1u), _e2345), select(_e2340.member_1, _e2340.member_1, _e2345));
                                                            phi_3721_ = _e2372;
                                                            break if !(_e2374);
                                                        }
                                                    }
                                                    let _e2379 = local_17;
                                                    let _e2380 = select(true, false, _e2379);
                                                    let _e2382 = local_18;
                                                    phi_3788_ = select(u32(), select(2u, 1u, _e2382), _e2380);
                                                    phi_3789_ = 0u;
                                                    phi_3790_ = select(true, false, _e2380);
                                                } else {
                                                    phi_3788_ = u32();
                                                    phi_3789_ = 2u;
                                                    phi_3790_ = true;
                                                }
                                                let _e2387 = phi_3788_;
                                                let _e2389 = phi_3789_;
                                                let _e2391 = phi_3790_;
                                                let _e2392 = select(_e2387, _e2389, _e2391);
                                                let _e2393 = (_e2392 == 0u);
                                                if _e2393 {
                                                    phi_3821_ = bool();
                                                    phi_3822_ = false;
                                                    phi_3823_ = false;
                                                } else {
                                                    let _e2396 = select(false, _e1810.member_2, (_e2392 == 1u));
                                                    let _e2402 = select(true, select(true, false, ((_e1810.member_1 - _e1810.member) <= _e1409)), _e2396);
                                                    phi_3821_ = _e2396;
                                                    phi_3822_ = _e2402;
                                                    phi_3823_ = select(true, false, _e2402);
                                                }
                                                let _e2405 = phi_3821_;
                                                let _e2407 = phi_3822_;
                                                let _e2409 = phi_3823_;
                                                phi_3824_ = _e2405;
                                                phi_3825_ = _e2393;
                                                phi_3826_ = _e2407;
                                                phi_3827_ = _e2409;
                                            }
                                            let _e2411 = phi_3824_;
                                            let _e2413 = phi_3825_;
                                            let _e2415 = phi_3826_;
                                            let _e2417 = phi_3827_;
                                            phi_3828_ = _e2411;
                                            phi_3829_ = _e2413;
                                            phi_3830_ = _e2415;
                                            phi_3831_ = _e1815;
                                            phi_3832_ = _e2417;
                                        }
                                        let _e2419 = phi_3828_;
                                        let _e2421 = phi_3829_;
                                        let _e2423 = phi_3830_;
                                        let _e2425 = phi_3831_;
                                        let _e2427 = phi_3832_;
                                        phi_3833_ = _e1810;
                                        phi_3834_ = _e2419;
                                        phi_3835_ = _e1810;
                                        phi_3836_ = _e2421;
                                        phi_3837_ = _e2423;
                                        phi_3838_ = _e2425;
                                        phi_3839_ = _e2427;
                                    }
                                    let _e2429 = phi_3833_;
                                    let _e2431 = phi_3834_;
                                    let _e2433 = phi_3835_;
                                    let _e2435 = phi_3836_;
                                    let _e2437 = phi_3837_;
                                    let _e2439 = phi_3838_;
                                    let _e2441 = phi_3839_;
                                    phi_3840_ = _e2429;
                                    phi_3841_ = _e2431;
                                    phi_3842_ = _e2433;
                                    phi_3843_ = _e2435;
                                    phi_3844_ = _e2437;
                                    phi_3845_ = _e1475;
                                    phi_3846_ = _e2439;
                                    phi_3847_ = _e2441;
                                } else {
                                    phi_3840_ = type_44();
                                    phi_3841_ = bool();
                                    phi_3842_ = type_44();
                                    phi_3843_ = true;
                                    phi_3844_ = false;
                                    phi_3845_ = false;
                                    phi_3846_ = false;
                                    phi_3847_ = false;
                                }
                                let _e2443 = phi_3840_;
                                let _e2445 = phi_3841_;
                                let _e2447 = phi_3842_;
                                let _e2449 = phi_3843_;
                                let _e2451 = phi_3844_;
                                let _e2453 = phi_3845_;
                                let _e2455 = phi_3846_;
                                let _e2457 = phi_3847_;
                                phi_3855_ = _e2443;
                                phi_3856_ = _e2445;
                                phi_3857_ = _e2447;
                                phi_3858_ = select(_e2451, false, _e2449);
                                phi_3859_ = _e2449;
                                phi_3860_ = select(_e2453, false, _e2449);
                                phi_3861_ = select(_e2455, false, _e2449);
                                phi_3862_ = select(_e2457, false, _e2449);
                            } else {
                                phi_3855_ = type_44(_e534, _e534, false);
                                phi_3856_ = false;
                                phi_3857_ = type_44();
                                phi_3858_ = true;
                                phi_3859_ = false;
                                phi_3860_ = false;
                                phi_3861_ = false;
                                phi_3862_ = false;
                            }
                            let _e2463 = phi_3855_;
                            let _e2465 = phi_3856_;
                            let _e2467 = phi_3857_;
                            let _e2469 = phi_3858_;
                            let _e2471 = phi_3859_;
                            let _e2473 = phi_3860_;
                            let _e2475 = phi_3861_;
                            let _e2477 = phi_3862_;
                            if _e2469 {
                                let _e2482 = local_7.member[0u];
                                let _e2488 = local_7.member_1[0u];
                                let _e2494 = local_7.member_2[0u];
                                let _e2498 = (_e2482[0] - _e2488[0]);
                                let _e2499 = (_e2482[1] - _e2488[1]);
                                let _e2500 = (_e2482[2] - _e2488[2]);
                                let _e2501 = (_e231.member == 0u);
                                let _e2513 = local_7.member[1u];
                                let _e2519 = local_7.member_1[1u];
                                let _e2525 = local_7.member_2[1u];
                                let _e2529 = (_e2513[0] - _e2519[0]);
                                let _e2530 = (_e2513[1] - _e2519[1]);
                                let _e2531 = (_e2513[2] - _e2519[2]);
                                let _e2532 = (_e231.member == 0u);
                                let _e2544 = local_7.member[0u];
                                let _e2550 = select(_e2544[0], -(_e2544[0]), (_e2544[0] < 0.0lf));
                                let _e2553 = select(_e2544[1], -(_e2544[1]), (_e2544[1] < 0.0lf));
                                let _e2555 = select(_e2553, _e2550, (_e2550 > _e2553));
                                let _e2558 = select(_e2544[2], -(_e2544[2]), (_e2544[2] < 0.0lf));
                                let _e2560 = select(_e2558, _e2555, (_e2555 > _e2558));
                                let _e2563 = local_7.member[1u];
                                let _e2569 = select(_e2563[0], -(_e2563[0]), (_e2563[0] < 0.0lf));
                                let _e2572 = select(_e2563[1], -(_e2563[1]), (_e2563[1] < 0.0lf));
                                let _e2574 = select(_e2572, _e2569, (_e2569 > _e2572));
                                let _e2577 = select(_e2563[2], -(_e2563[2]), (_e2563[2] < 0.0lf));
                                let _e2579 = select(_e2577, _e2574, (_e2574 > _e2577));
                                let _e2583 = local_7.member_3;
                                let _e2587 = local_7.member_1[0u];
                                let _e2593 = select(_e2587[0], -(_e2587[0]), (_e2587[0] < 0.0lf));
                                let _e2596 = select(_e2587[1], -(_e2587[1]), (_e2587[1] < 0.0lf));
                                let _e2598 = select(_e2596, _e2593, (_e2593 > _e2596));
                                let _e2601 = select(_e2587[2], -(_e2587[2]), (_e2587[2] < 0.0lf));
                                let _e2603 = select(_e2601, _e2598, (_e2598 > _e2601));
                                let _e2606 = local_7.member_1[1u];
                                let _e2612 = select(_e2606[0], -(_e2606[0]), (_e2606[0] < 0.0lf));
                                let _e2615 = select(_e2606[1], -(_e2606[1]), (_e2606[1] < 0.0lf));
                                let _e2617 = select(_e2615, _e2612, (_e2612 > _e2615));
                                let _e2620 = select(_e2606[2], -(_e2606[2]), (_e2606[2] < 0.0lf));
                                let _e2622 = select(_e2620, _e2617, (_e2617 > _e2620));
                                let _e2626 = local_7.member_3;
                                let _e2630 = local_7.member_2[0u];
                                let _e2636 = select(_e2630[0], -(_e2630[0]), (_e2630[0] < 0.0lf));
                                let _e2639 = select(_e2630[1], -(_e2630[1]), (_e2630[1] < 0.0lf));
                                let _e2641 = select(_e2639, _e2636, (_e2636 > _e2639));
                                let _e2644 = select(_e2630[2], -(_e2630[2]), (_e2630[2] < 0.0lf));
                                let _e2646 = select(_e2644, _e2641, (_e2641 > _e2644));
                                let _e2649 = local_7.member_2[1u];
                                let _e2655 = select(_e2649[0], -(_e2649[0]), (_e2649[0] < 0.0lf));
                                let _e2658 = select(_e2649[1], -(_e2649[1]), (_e2649[1] < 0.0lf));
                                let _e2660 = select(_e2658, _e2655, (_e2655 > _e2658));
                                let _e2663 = select(_e2649[2], -(_e2649[2]), (_e2649[2] < 0.0lf));
                                let _e2665 = select(_e2663, _e2660, (_e2660 > _e2663));
                                let _e2669 = local_7.member_3;
                                let _e2677 = local_7.member_3;
                                let _e2685 = (_e525 * f64(0.00390625f));
                                let _e2686 = f64(0f);
                                let _e2687 = f64(1f);
                                local = type_36(array<f64, 4>(_e2686, _e2686, _e2686, _e2686), array<f64, 4>(_e2686, _e2686, _e2686, _e2686), array<f64, 4>(_e2687, _e2687, _e2687, _e2687));
                                phi_4291_ = type_9(0u, 96u);
                                phi_4294_ = _e2463.member;
                                phi_4296_ = _e2463.member;
                                phi_4298_ = (_e2463.member_1 - _e2463.member);
                                phi_4300_ = _e2463.member;
                                phi_4302_ = false;
                                phi_4304_ = 0u;
                                loop {
                                    let _e2694 = phi_4291_;
                                    let _e2696 = phi_4294_;
                                    let _e2698 = phi_4296_;
                                    let _e2700 = phi_4298_;
                                    let _e2702 = phi_4300_;
                                    let _e2704 = phi_4302_;
                                    let _e2706 = phi_4304_;
                                    local_31 = _e2696;
                                    local_35 = _e2698;
                                    let _e2709 = (_e2694.member < _e2694.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2709)) != 0i) {
                                        let _e2723 = local_7.member[0u];
                                        let _e2729 = local_7.member[1u];
                                        let _e2745 = local_7.member_1[0u];
                                        let _e2751 = local_7.member_1[1u];
                                        let _e2767 = local_7.member_2[0u];
                                        let _e2773 = local_7.member_2[1u];
                                        let _e2787 = function_4(array<f64, 3>((_e2723[0] + ((_e2729[0] - _e2723[0]) * _e2696)), (_e2723[1] + ((_e2729[1] - _e2723[1]) * _e2696)), (_e2723[2] + ((_e2729[2] - _e2723[2]) * _e2696))), array<f64, 3>((_e2745[0] + ((_e2751[0] - _e2745[0]) * _e2696)), (_e2745[1] + ((_e2751[1] - _e2745[1]) * _e2696)), (_e2745[2] + ((_e2751[2] - _e2745[2]) * _e2696))), array<f64, 3>((_e2767[0] + ((_e2773[0] - _e2767[0]) * _e2696)), (_e2767[1] + ((_e2773[1] - _e2767[1]) * _e2696)), (_e2767[2] + ((_e2773[2] - _e2767[2]) * _e2696))), _e231.member);
                                        if (_e2706 == 0u) {
                                            phi_4456_ = _e2787;
                                        } else {
                                            let _e2789 = f64(0f);
                                            phi_4456_ = array<f64, 3>(select(_e2789, _e2787[0], (_e2706 == 1u)), select(_e2789, _e2787[1], (_e2706 == 2u)), select(_e2789, _e2787[2], (_e2706 == 3u)));
                                        }
                                        let _e2801 = phi_4456_;
                                        let _e2815 = ((select(_e2801[0], -(_e2801[0]), (_e2801[0] < 0.0lf)) + select(_e2801[1], -(_e2801[1]), (_e2801[1] < 0.0lf))) + select(_e2801[2], -(_e2801[2]), (_e2801[2] < 0.0lf)));
                                        if (_e2815 > f64(0f)) {
                                            if ((bitcast<u64>(_e2815) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2822 = (f64(1f) / _e2815);
                                                let _e2824 = (_e2801[0] * _e2822);
                                                let _e2826 = (_e2801[1] * _e2822);
                                                let _e2828 = (_e2801[2] * _e2822);
                                                let _e2833 = (((_e2824 * _e2824) + (_e2826 * _e2826)) + (_e2828 * _e2828));
                                                if (_e2833 <= 2.2250738585072014e-308lf) {
                                                    phi_4581_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2833 > 0.0lf));
                                                } else {
                                                    phi_4524_ = type_16(0i, 5i);
                                                    phi_4527_ = bitcast<f64>(((bitcast<u64>(_e2833) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2840 = phi_4524_;
                                                        let _e2842 = phi_4527_;
                                                        local_19 = _e2842;
                                                        if (_e2840.member < _e2840.member_1) {
                                                            let _e2849 = (_e2840.member + 1i);
                                                            phi_4525_ = type_16(select(_e2849, type_17().member_1, select(false, true, ((false == (_e2849 > _e2840.member)) != false))), _e2840.member_1);
                                                            phi_4568_ = type_17(1u, _e2840.member);
                                                        } else {
                                                            phi_4525_ = _e2840;
                                                            phi_4568_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2860 = phi_4525_;
                                                        let _e2862 = phi_4568_;
                                                        let _e2865 = (bitcast<i32>(_e2862.member) != 0i);
                                                        if _e2865 {
                                                            phi_4528_ = (0.5lf * (_e2842 + (_e2833 / _e2842)));
                                                        } else {
                                                            phi_4528_ = f64();
                                                        }
                                                        let _e2870 = phi_4528_;
                                                        continue;
                                                        continuing {
                                                            phi_4524_ = _e2860;
                                                            phi_4527_ = _e2870;
                                                            break if !(_e2865);
                                                        }
                                                    }
                                                    let _e2875 = local_19;
                                                    phi_4581_ = (_e2875 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2881 = phi_4581_;
                                                let _e2883 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2890 = ((((((((select(_e2579, _e2560, (_e2560 > _e2579)) + _e2583) + (select(_e2622, _e2603, (_e2603 > _e2622)) + _e2626)) + (select(_e2665, _e2646, (_e2646 > _e2665)) + _e2669)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2677 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e819 * _e2881) * (f64(1f) + _e2883)));
                                                let _e2895 = (((_e2824 * _e2482[0]) + (_e2826 * _e2482[1])) + (_e2828 * _e2482[2]));
                                                let _e2900 = (((_e2824 * _e2498) + (_e2826 * _e2499)) + (_e2828 * _e2500));
                                                let _e2905 = (((_e2824 * (_e2482[0] - _e2494[0])) + (_e2826 * (_e2482[1] - _e2494[1]))) + (_e2828 * (_e2482[2] - _e2494[2])));
                                                let _e2910 = (((_e2824 * select((_e2498 - _e2494[0]), _e2482[0], _e2501)) + (_e2826 * select((_e2499 - _e2494[1]), _e2482[1], _e2501))) + (_e2828 * select((_e2500 - _e2494[2]), _e2482[2], _e2501)));
                                                let _e2916 = (((_e2824 * _e2513[0]) + (_e2826 * _e2513[1])) + (_e2828 * _e2513[2]));
                                                let _e2921 = (((_e2824 * _e2529) + (_e2826 * _e2530)) + (_e2828 * _e2531));
                                                let _e2926 = (((_e2824 * (_e2513[0] - _e2525[0])) + (_e2826 * (_e2513[1] - _e2525[1]))) + (_e2828 * (_e2513[2] - _e2525[2])));
                                                let _e2931 = (((_e2824 * select((_e2529 - _e2525[0]), _e2513[0], _e2532)) + (_e2826 * select((_e2530 - _e2525[1]), _e2513[1], _e2532))) + (_e2828 * select((_e2531 - _e2525[2]), _e2513[2], _e2532)));
                                                phi_4707_ = type_36(array<f64, 4>(_e2895, _e2900, _e2905, _e2910), array<f64, 4>(_e2916, _e2921, _e2926, _e2931), array<f64, 4>((_e2890 + ((select(_e2895, -(_e2895), (_e2895 < 0.0lf)) + select(_e2916, -(_e2916), (_e2916 < 0.0lf))) * _e2883)), (_e2890 + ((select(_e2900, -(_e2900), (_e2900 < 0.0lf)) + select(_e2921, -(_e2921), (_e2921 < 0.0lf))) * _e2883)), (_e2890 + ((select(_e2905, -(_e2905), (_e2905 < 0.0lf)) + select(_e2926, -(_e2926), (_e2926 < 0.0lf))) * _e2883)), (_e2890 + ((select(_e2910, -(_e2910), (_e2910 < 0.0lf)) + select(_e2931, -(_e2931), (_e2931 < 0.0lf))) * _e2883))));
                                                phi_4708_ = false;
                                            } else {
                                                phi_4707_ = type_36();
                                                phi_4708_ = true;
                                            }
                                            let _e2972 = phi_4707_;
                                            let _e2974 = phi_4708_;
                                            phi_4709_ = _e2972;
                                            phi_4710_ = _e2974;
                                        } else {
                                            phi_4709_ = type_36();
                                            phi_4710_ = true;
                                        }
                                        let _e2976 = phi_4709_;
                                        let _e2978 = phi_4710_;
                                        if _e2978 {
                                            let _e2979 = f64(0f);
                                            let _e2980 = f64(1f);
                                            phi_4720_ = type_36(array<f64, 4>(_e2979, _e2979, _e2979, _e2979), array<f64, 4>(_e2979, _e2979, _e2979, _e2979), array<f64, 4>(_e2980, _e2980, _e2980, _e2980));
                                        } else {
                                            phi_4720_ = _e2976;
                                        }
                                        let _e2986 = phi_4720_;
                                        local_1 = type_36(array<f64, 4>(_e2986.member[0], _e2986.member[1], _e2986.member[2], _e2986.member[3]), array<f64, 4>(_e2986.member_1[0], _e2986.member_1[1], _e2986.member_1[2], _e2986.member_1[3]), array<f64, 4>(_e2986.member_2[0], _e2986.member_2[1], _e2986.member_2[2], _e2986.member_2[3]));
                                        let _e3006 = (_e2696 - _e2702);
                                        let _e3008 = f64(0f);
                                        let _e3011 = local_1.member[0u];
                                        let _e3014 = local_1.member_1[0u];
                                        let _e3017 = local_1.member[0u];
                                        let _e3023 = local_1.member_2[0u];
                                        if (((_e3011 + ((_e3014 - _e3017) * _e2696)) - _e3023) > _e3008) {
                                            let _e3028 = local_1.member[1u];
                                            let _e3031 = local_1.member_1[1u];
                                            let _e3034 = local_1.member[1u];
                                            let _e3040 = local_1.member_2[1u];
                                            if (((_e3028 + ((_e3031 - _e3034) * _e2696)) - _e3040) > _e3008) {
                                                let _e3045 = local_1.member[2u];
                                                let _e3048 = local_1.member_1[2u];
                                                let _e3051 = local_1.member[2u];
                                                let _e3057 = local_1.member_2[2u];
                                                if (((_e3045 + ((_e3048 - _e3051) * _e2696)) - _e3057) > _e3008) {
                                                    let _e3062 = local_1.member[3u];
                                                    let _e3065 = local_1.member_1[3u];
                                                    let _e3068 = local_1.member[3u];
                                                    let _e3074 = local_1.member_2[3u];
                                                    phi_4892_ = (((_e3062 + ((_e3065 - _e3068) * _e2696)) - _e3074) > _e3008);
                                                    phi_4893_ = false;
                                                } else {
                                                    phi_4892_ = bool();
                                                    phi_4893_ = true;
                                                }
                                                let _e3078 = phi_4892_;
                                                let _e3080 = phi_4893_;
                                                phi_4894_ = _e3078;
                                                phi_4895_ = _e3080;
                                            } else {
                                                phi_4894_ = bool();
                                                phi_4895_ = true;
                                            }
                                            let _e3082 = phi_4894_;
                                            let _e3084 = phi_4895_;
                                            phi_4896_ = _e3082;
                                            phi_4897_ = _e3084;
                                        } else {
                                            phi_4896_ = bool();
                                            phi_4897_ = true;
                                        }
                                        let _e3086 = phi_4896_;
                                        let _e3088 = phi_4897_;
                                        if select(_e3086, false, _e3088) {
                                            if (_e2696 <= _e2698) {
                                                phi_5212_ = true;
                                            } else {
                                                let _e3091 = f64(0f);
                                                let _e3094 = local.member[0u];
                                                let _e3097 = local.member_1[0u];
                                                let _e3100 = local.member[0u];
                                                let _e3106 = local.member_2[0u];
                                                let _e3110 = local_1.member[0u];
                                                let _e3113 = local_1.member_1[0u];
                                                let _e3116 = local_1.member[0u];
                                                let _e3122 = local_1.member_2[0u];
                                                if ((((_e3094 + ((_e3097 - _e3100) * _e2696)) - _e3106) + ((_e3110 + ((_e3113 - _e3116) * _e2702)) - _e3122)) > _e3091) {
                                                    let _e3128 = local.member[1u];
                                                    let _e3131 = local.member_1[1u];
                                                    let _e3134 = local.member[1u];
                                                    let _e3140 = local.member_2[1u];
                                                    let _e3144 = local_1.member[1u];
                                                    let _e3147 = local_1.member_1[1u];
                                                    let _e3150 = local_1.member[1u];
                                                    let _e3156 = local_1.member_2[1u];
                                                    if ((((_e3128 + ((_e3131 - _e3134) * _e2696)) - _e3140) + ((_e3144 + ((_e3147 - _e3150) * _e2702)) - _e3156)) > _e3091) {
                                                        let _e3162 = local.member[2u];
                                                        let _e3165 = local.member_1[2u];
                                                        let _e3168 = local.member[2u];
                                                        let _e3174 = local.member_2[2u];
                                                        let _e3178 = local_1.member[2u];
                                                        let _e3181 = local_1.member_1[2u];
                                                        let _e3184 = local_1.member[2u];
                                                        let _e3190 = local_1.member_2[2u];
                                                        if ((((_e3162 + ((_e3165 - _e3168) * _e2696)) - _e3174) + ((_e3178 + ((_e3181 - _e3184) * _e2702)) - _e3190)) > _e3091) {
                                                            let _e3196 = local.member[3u];
                                                            let _e3199 = local.member_1[3u];
                                                            let _e3202 = local.member[3u];
                                                            let _e3208 = local.member_2[3u];
                                                            let _e3212 = local_1.member[3u];
                                                            let _e3215 = local_1.member_1[3u];
                                                            let _e3218 = local_1.member[3u];
                                                            let _e3224 = local_1.member_2[3u];
                                                            phi_5199_ = ((((_e3196 + ((_e3199 - _e3202) * _e2696)) - _e3208) + ((_e3212 + ((_e3215 - _e3218) * _e2702)) - _e3224)) > _e3091);
                                                            phi_5200_ = false;
                                                        } else {
                                                            phi_5199_ = bool();
                                                            phi_5200_ = true;
                                                        }
                                                        let _e3229 = phi_5199_;
                                                        let _e3231 = phi_5200_;
                                                        phi_5201_ = _e3229;
                                                        phi_5202_ = _e3231;
                                                    } else {
                                                        phi_5201_ = bool();
                                                        phi_5202_ = true;
                                                    }
                                                    let _e3233 = phi_5201_;
                                                    let _e3235 = phi_5202_;
                                                    phi_5203_ = _e3233;
                                                    phi_5204_ = _e3235;
                                                } else {
                                                    phi_5203_ = bool();
                                                    phi_5204_ = true;
                                                }
                                                let _e3237 = phi_5203_;
                                                let _e3239 = phi_5204_;
                                                phi_5212_ = select(_e3237, false, _e3239);
                                            }
                                            let _e3242 = phi_5212_;
                                            if _e3242 {
                                                if select(true, select(true, false, (_e2696 >= _e2463.member_1)), _e2704) {
                                                    local = type_36(array<f64, 4>(_e2986.member[0], _e2986.member[1], _e2986.member[2], _e2986.member[3]), array<f64, 4>(_e2986.member_1[0], _e2986.member_1[1], _e2986.member_1[2], _e2986.member_1[3]), array<f64, 4>(_e2986.member_2[0], _e2986.member_2[1], _e2986.member_2[2], _e2986.member_2[3]));
                                                    let _e3267 = local.member[0u];
                                                    let _e3270 = local.member_1[0u];
                                                    let _e3273 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3270 > _e3273)), (_e3267 > _e3273)) {
                                                        let _e3278 = (_e3270 >= _e3267);
                                                        if _e3278 {
                                                            phi_5324_ = f64();
                                                            phi_5325_ = false;
                                                        } else {
                                                            if ((_e3267 - _e3270) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5322_ = (((_e3267 - _e3273) / (_e3267 - _e3270)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5323_ = false;
                                                            } else {
                                                                phi_5322_ = f64();
                                                                phi_5323_ = true;
                                                            }
                                                            let _e3292 = phi_5322_;
                                                            let _e3294 = phi_5323_;
                                                            phi_5324_ = _e3292;
                                                            phi_5325_ = _e3294;
                                                        }
                                                        let _e3296 = phi_5324_;
                                                        let _e3298 = phi_5325_;
                                                        phi_5326_ = _e3296;
                                                        phi_5327_ = _e3278;
                                                        phi_5328_ = _e3298;
                                                    } else {
                                                        phi_5326_ = f64();
                                                        phi_5327_ = true;
                                                        phi_5328_ = false;
                                                    }
                                                    let _e3300 = phi_5326_;
                                                    let _e3302 = phi_5327_;
                                                    let _e3304 = phi_5328_;
                                                    let _e3308 = select(_e3300, select(_e2696, f64(2f), _e3302), select(_e3304, true, _e3302));
                                                    let _e3311 = local.member[1u];
                                                    let _e3314 = local.member_1[1u];
                                                    let _e3317 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3314 > _e3317)), (_e3311 > _e3317)) {
                                                        let _e3322 = (_e3314 >= _e3311);
                                                        if _e3322 {
                                                            phi_5396_ = f64();
                                                            phi_5397_ = false;
                                                        } else {
                                                            if ((_e3311 - _e3314) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5394_ = (((_e3311 - _e3317) / (_e3311 - _e3314)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5395_ = false;
                                                            } else {
                                                                phi_5394_ = f64();
                                                                phi_5395_ = true;
                                                            }
                                                            let _e3336 = phi_5394_;
                                                            let _e3338 = phi_5395_;
                                                            phi_5396_ = _e3336;
                                                            phi_5397_ = _e3338;
                                                        }
                                                        let _e3340 = phi_5396_;
                                                        let _e3342 = phi_5397_;
                                                        phi_5398_ = _e3340;
                                                        phi_5399_ = _e3322;
                                                        phi_5400_ = _e3342;
                                                    } else {
                                                        phi_5398_ = f64();
                                                        phi_5399_ = true;
                                                        phi_5400_ = false;
                                                    }
                                                    let _e3344 = phi_5398_;
                                                    let _e3346 = phi_5399_;
                                                    let _e3348 = phi_5400_;
                                                    let _e3352 = select(_e3344, select(_e2696, f64(2f), _e3346), select(_e3348, true, _e3346));
                                                    let _e3354 = select(_e3352, _e3308, (_e3308 < _e3352));
                                                    let _e3357 = local.member[2u];
                                                    let _e3360 = local.member_1[2u];
                                                    let _e3363 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3360 > _e3363)), (_e3357 > _e3363)) {
                                                        let _e3368 = (_e3360 >= _e3357);
                                                        if _e3368 {
                                                            phi_5473_ = f64();
                                                            phi_5474_ = false;
                                                        } else {
                                                            if ((_e3357 - _e3360) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5471_ = (((_e3357 - _e3363) / (_e3357 - _e3360)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5472_ = false;
                                                            } else {
                                                                phi_5471_ = f64();
                                                                phi_5472_ = true;
                                                            }
                                                            let _e3382 = phi_5471_;
                                                            let _e3384 = phi_5472_;
                                                            phi_5473_ = _e3382;
                                                            phi_5474_ = _e3384;
                                                        }
                                                        let _e3386 = phi_5473_;
                                                        let _e3388 = phi_5474_;
                                                        phi_5475_ = _e3386;
                                                        phi_5476_ = _e3368;
                                                        phi_5477_ = _e3388;
                                                    } else {
                                                        phi_5475_ = f64();
                                                        phi_5476_ = true;
                                                        phi_5477_ = false;
                                                    }
                                                    let _e3390 = phi_5475_;
                                                    let _e3392 = phi_5476_;
                                                    let _e3394 = phi_5477_;
                                                    let _e3398 = select(_e3390, select(_e2696, f64(2f), _e3392), select(_e3394, true, _e3392));
                                                    let _e3401 = local.member[3u];
                                                    let _e3404 = local.member_1[3u];
                                                    let _e3407 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3404 > _e3407)), (_e3401 > _e3407)) {
                                                        let _e3412 = (_e3404 >= _e3401);
                                                        if _e3412 {
                                                            phi_5545_ = f64();
                                                            phi_5546_ = false;
                                                        } else {
                                                            if ((_e3401 - _e3404) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5543_ = (((_e3401 - _e3407) / (_e3401 - _e3404)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5544_ = false;
                                                            } else {
                                                                phi_5543_ = f64();
                                                                phi_5544_ = true;
                                                            }
                                                            let _e3426 = phi_5543_;
                                                            let _e3428 = phi_5544_;
                                                            phi_5545_ = _e3426;
                                                            phi_5546_ = _e3428;
                                                        }
                                                        let _e3430 = phi_5545_;
                                                        let _e3432 = phi_5546_;
                                                        phi_5547_ = _e3430;
                                                        phi_5548_ = _e3412;
                                                        phi_5549_ = _e3432;
                                                    } else {
                                                        phi_5547_ = f64();
                                                        phi_5548_ = true;
                                                        phi_5549_ = false;
                                                    }
                                                    let _e3434 = phi_5547_;
                                                    let _e3436 = phi_5548_;
                                                    let _e3438 = phi_5549_;
                                                    let _e3442 = select(_e3434, select(_e2696, f64(2f), _e3436), select(_e3438, true, _e3436));
                                                    let _e3444 = select(_e3442, _e3398, (_e3398 < _e3442));
                                                    let _e3446 = select(_e3444, _e3354, (_e3354 < _e3444));
                                                    let _e3448 = select(_e2696, _e3446, (_e3446 > _e2696));
                                                    let _e3449 = (_e3448 > _e2463.member_1);
                                                    if _e3449 {
                                                        phi_6091_ = f64();
                                                        phi_6092_ = f64();
                                                        phi_6093_ = false;
                                                        phi_6094_ = false;
                                                    } else {
                                                        let _e3450 = (_e3448 - _e2696);
                                                        let _e3451 = (_e3450 <= _e2685);
                                                        let _e3454 = (_e3448 + (_e525 * f64(0.01f)));
                                                        let _e3456 = select(_e2463.member_1, _e3454, (_e3454 < _e2463.member_1));
                                                        if _e3451 {
                                                            if (_e819 > f64(0f)) {
                                                                let _e3461 = local_7.member[0u];
                                                                let _e3467 = local_7.member[1u];
                                                                let _e3483 = local_7.member_1[0u];
                                                                let _e3489 = local_7.member_1[1u];
                                                                let _e3505 = local_7.member_2[0u];
                                                                let _e3511 = local_7.member_2[1u];
                                                                let _e3525 = function_4(array<f64, 3>((_e3461[0] + ((_e3467[0] - _e3461[0]) * _e3456)), (_e3461[1] + ((_e3467[1] - _e3461[1]) * _e3456)), (_e3461[2] + ((_e3467[2] - _e3461[2]) * _e3456))), array<f64, 3>((_e3483[0] + ((_e3489[0] - _e3483[0]) * _e3456)), (_e3483[1] + ((_e3489[1] - _e3483[1]) * _e3456)), (_e3483[2] + ((_e3489[2] - _e3483[2]) * _e3456))), array<f64, 3>((_e3505[0] + ((_e3511[0] - _e3505[0]) * _e3456)), (_e3505[1] + ((_e3511[1] - _e3505[1]) * _e3456)), (_e3505[2] + ((_e3511[2] - _e3505[2]) * _e3456))), _e231.member);
                                                                let _e3536 = (((_e3525[0] * _e3525[0]) + (_e3525[1] * _e3525[1])) + (_e3525[2] * _e3525[2]));
                                                                if (_e3536 <= 2.2250738585072014e-308lf) {
                                                                    phi_5783_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3536 > 0.0lf));
                                                                } else {
                                                                    phi_5726_ = type_16(0i, 5i);
                                                                    phi_5729_ = bitcast<f64>(((bitcast<u64>(_e3536) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3543 = phi_5726_;
                                                                        let _e3545 = phi_5729_;
                                                                        local_20 = _e3545;
                                                                        if (_e3543.member < _e3543.member_1) {
                                                                            let _e3552 = (_e3543.member + 1i);
                                                                            phi_5727_ = type_16(select(_e3552, type_17().member_1, select(false, true, ((false == (_e3552 > _e3543.member)) != false))), _e3543.member_1);
                                                                            phi_5770_ = type_17(1u, _e3543.member);
                                                                        } else {
                                                                            phi_5727_ = _e3543;
                                                                            phi_5770_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e3563 = phi_5727_;
                                                                        let _e3565 = phi_5770_;
                                                                        let _e3568 = (bitcast<i32>(_e3565.member) != 0i);
                                                                        if _e3568 {
                                                                            phi_5730_ = (0.5lf * (_e3545 + (_e3536 / _e3545)));
                                                                        } else {
                                                                            phi_5730_ = f64();
                                                                        }
                                                                        let _e3573 = phi_5730_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5726_ = _e3563;
                                                                            phi_5729_ = _e3573;
                                                                            break if !(_e3568);
                                                                        }
                                                                    }
                                                                    let _e3578 = local_20;
                                                                    phi_5783_ = (_e3578 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3584 = phi_5783_;
                                                                let _e3592 = local_7.member[0u];
                                                                let _e3598 = select(_e3592[0], -(_e3592[0]), (_e3592[0] < 0.0lf));
                                                                let _e3601 = select(_e3592[1], -(_e3592[1]), (_e3592[1] < 0.0lf));
                                                                let _e3603 = select(_e3601, _e3598, (_e3598 > _e3601));
                                                                let _e3606 = select(_e3592[2], -(_e3592[2]), (_e3592[2] < 0.0lf));
                                                                let _e3608 = select(_e3606, _e3603, (_e3603 > _e3606));
                                                                let _e3611 = local_7.member[1u];
                                                                let _e3617 = select(_e3611[0], -(_e3611[0]), (_e3611[0] < 0.0lf));
                                                                let _e3620 = select(_e3611[1], -(_e3611[1]), (_e3611[1] < 0.0lf));
                                                                let _e3622 = select(_e3620, _e3617, (_e3617 > _e3620));
                                                                let _e3625 = select(_e3611[2], -(_e3611[2]), (_e3611[2] < 0.0lf));
                                                                let _e3627 = select(_e3625, _e3622, (_e3622 > _e3625));
                                                                let _e3631 = local_7.member_3;
                                                                let _e3635 = local_7.member_1[0u];
                                                                let _e3641 = select(_e3635[0], -(_e3635[0]), (_e3635[0] < 0.0lf));
                                                                let _e3644 = select(_e3635[1], -(_e3635[1]), (_e3635[1] < 0.0lf));
                                                                let _e3646 = select(_e3644, _e3641, (_e3641 > _e3644));
                                                                let _e3649 = select(_e3635[2], -(_e3635[2]), (_e3635[2] < 0.0lf));
                                                                let _e3651 = select(_e3649, _e3646, (_e3646 > _e3649));
                                                                let _e3654 = local_7.member_1[1u];
                                                                let _e3660 = select(_e3654[0], -(_e3654[0]), (_e3654[0] < 0.0lf));
                                                                let _e3663 = select(_e3654[1], -(_e3654[1]), (_e3654[1] < 0.0lf));
                                                                let _e3665 = select(_e3663, _e3660, (_e3660 > _e3663));
                                                                let _e3668 = select(_e3654[2], -(_e3654[2]), (_e3654[2] < 0.0lf));
                                                                let _e3670 = select(_e3668, _e3665, (_e3665 > _e3668));
                                                                let _e3674 = local_7.member_3;
                                                                let _e3678 = local_7.member_2[0u];
                                                                let _e3684 = select(_e3678[0], -(_e3678[0]), (_e3678[0] < 0.0lf));
                                                                let _e3687 = select(_e3678[1], -(_e3678[1]), (_e3678[1] < 0.0lf));
                                                                let _e3689 = select(_e3687, _e3684, (_e3684 > _e3687));
                                                                let _e3692 = select(_e3678[2], -(_e3678[2]), (_e3678[2] < 0.0lf));
                                                                let _e3694 = select(_e3692, _e3689, (_e3689 > _e3692));
                                                                let _e3697 = local_7.member_2[1u];
                                                                let _e3703 = select(_e3697[0], -(_e3697[0]), (_e3697[0] < 0.0lf));
                                                                let _e3706 = select(_e3697[1], -(_e3697[1]), (_e3697[1] < 0.0lf));
                                                                let _e3708 = select(_e3706, _e3703, (_e3703 > _e3706));
                                                                let _e3711 = select(_e3697[2], -(_e3697[2]), (_e3697[2] < 0.0lf));
                                                                let _e3713 = select(_e3711, _e3708, (_e3708 > _e3711));
                                                                let _e3717 = local_7.member_3;
                                                                let _e3725 = local_7.member_3;
                                                                phi_6060_ = select(true, false, (((_e3584 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3627, _e3608, (_e3608 > _e3627)) + _e3631) + (select(_e3670, _e3651, (_e3651 > _e3670)) + _e3674)) + (select(_e3713, _e3694, (_e3694 > _e3713)) + _e3717)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3725 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e819));
                                                            } else {
                                                                phi_6060_ = true;
                                                            }
                                                            let _e3738 = phi_6060_;
                                                            phi_6061_ = _e3738;
                                                        } else {
                                                            phi_6061_ = true;
                                                        }
                                                        let _e3740 = phi_6061_;
                                                        if _e3740 {
                                                            if _e2704 {
                                                                let _e3744 = (_e3450 <= (_e2700 * f64(0.25f)));
                                                                phi_6088_ = select(select(select(f64(), f64(0f), _e3744), f64(), _e3451), (_e3006 + _e3006), select(select(true, false, _e3744), true, _e3451));
                                                            } else {
                                                                phi_6088_ = (_e2463.member_1 - _e2696);
                                                            }
                                                            let _e3753 = phi_6088_;
                                                            phi_6089_ = _e3753;
                                                            phi_6090_ = false;
                                                        } else {
                                                            phi_6089_ = f64();
                                                            phi_6090_ = true;
                                                        }
                                                        let _e3755 = phi_6089_;
                                                        let _e3757 = phi_6090_;
                                                        phi_6091_ = _e3755;
                                                        phi_6092_ = _e3450;
                                                        phi_6093_ = _e3740;
                                                        phi_6094_ = _e3757;
                                                    }
                                                    let _e3759 = phi_6091_;
                                                    let _e3761 = phi_6092_;
                                                    let _e3763 = phi_6093_;
                                                    let _e3765 = phi_6094_;
                                                    phi_6095_ = _e3448;
                                                    phi_6096_ = _e3759;
                                                    phi_6097_ = _e3761;
                                                    phi_6098_ = _e3448;
                                                    phi_6099_ = _e3763;
                                                    phi_6100_ = _e3449;
                                                    phi_6101_ = _e3765;
                                                    phi_6102_ = false;
                                                } else {
                                                    phi_6095_ = f64();
                                                    phi_6096_ = f64();
                                                    phi_6097_ = f64();
                                                    phi_6098_ = f64();
                                                    phi_6099_ = false;
                                                    phi_6100_ = false;
                                                    phi_6101_ = false;
                                                    phi_6102_ = true;
                                                }
                                                let _e3767 = phi_6095_;
                                                let _e3769 = phi_6096_;
                                                let _e3771 = phi_6097_;
                                                let _e3773 = phi_6098_;
                                                let _e3775 = phi_6099_;
                                                let _e3777 = phi_6100_;
                                                let _e3779 = phi_6101_;
                                                let _e3781 = phi_6102_;
                                                phi_6103_ = _e3767;
                                                phi_6104_ = _e3769;
                                                phi_6105_ = _e3771;
                                                phi_6106_ = _e3773;
                                                phi_6107_ = false;
                                                phi_6108_ = _e3775;
                                                phi_6109_ = _e3777;
                                                phi_6110_ = _e3779;
                                                phi_6111_ = _e3781;
                                            } else {
                                                phi_6103_ = f64();
                                                phi_6104_ = f64();
                                                phi_6105_ = f64();
                                                phi_6106_ = f64();
                                                phi_6107_ = true;
                                                phi_6108_ = false;
                                                phi_6109_ = false;
                                                phi_6110_ = false;
                                                phi_6111_ = false;
                                            }
                                            let _e3783 = phi_6103_;
                                            let _e3785 = phi_6104_;
                                            let _e3787 = phi_6105_;
                                            let _e3789 = phi_6106_;
                                            let _e3791 = phi_6107_;
                                            let _e3793 = phi_6108_;
                                            let _e3795 = phi_6109_;
                                            let _e3797 = phi_6110_;
                                            let _e3799 = phi_6111_;
                                            phi_6112_ = _e3783;
                                            phi_6113_ = _e3785;
                                            phi_6114_ = _e3787;
                                            phi_6115_ = _e3789;
                                            phi_6116_ = _e3791;
                                            phi_6117_ = _e3793;
                                            phi_6118_ = _e3795;
                                            phi_6119_ = _e3797;
                                            phi_6120_ = _e3799;
                                        } else {
                                            phi_6112_ = f64();
                                            phi_6113_ = f64();
                                            phi_6114_ = f64();
                                            phi_6115_ = f64();
                                            phi_6116_ = true;
                                            phi_6117_ = false;
                                            phi_6118_ = false;
                                            phi_6119_ = false;
                                            phi_6120_ = false;
                                        }
                                        let _e3801 = phi_6112_;
                                        let _e3803 = phi_6113_;
                                        let _e3805 = phi_6114_;
                                        let _e3807 = phi_6115_;
                                        let _e3809 = phi_6116_;
                                        let _e3811 = phi_6117_;
                                        let _e3813 = phi_6118_;
                                        let _e3815 = phi_6119_;
                                        let _e3817 = phi_6120_;
                                        if _e3809 {
                                            if (_e2696 <= _e2698) {
                                                let _e3975 = (_e2706 + 1u);
                                                let _e3976 = (_e3975 > 3u);
                                                phi_6460_ = _e3975;
                                                phi_6461_ = f64();
                                                phi_6462_ = false;
                                                phi_6463_ = select(true, false, _e3976);
                                                phi_6464_ = _e3976;
                                            } else {
                                                let _e3821 = local.member[0u];
                                                let _e3824 = local.member_1[0u];
                                                let _e3827 = local.member[0u];
                                                let _e3833 = local.member_2[0u];
                                                let _e3834 = ((_e3821 + ((_e3824 - _e3827) * _e2702)) - _e3833);
                                                let _e3837 = local.member[1u];
                                                let _e3840 = local.member_1[1u];
                                                let _e3843 = local.member[1u];
                                                let _e3849 = local.member_2[1u];
                                                let _e3850 = ((_e3837 + ((_e3840 - _e3843) * _e2702)) - _e3849);
                                                let _e3852 = select(_e3850, _e3834, (_e3834 < _e3850));
                                                let _e3855 = local.member[2u];
                                                let _e3858 = local.member_1[2u];
                                                let _e3861 = local.member[2u];
                                                let _e3867 = local.member_2[2u];
                                                let _e3868 = ((_e3855 + ((_e3858 - _e3861) * _e2702)) - _e3867);
                                                let _e3871 = local.member[3u];
                                                let _e3874 = local.member_1[3u];
                                                let _e3877 = local.member[3u];
                                                let _e3883 = local.member_2[3u];
                                                let _e3884 = ((_e3871 + ((_e3874 - _e3877) * _e2702)) - _e3883);
                                                let _e3886 = select(_e3884, _e3868, (_e3868 < _e3884));
                                                let _e3888 = select(_e3886, _e3852, (_e3852 < _e3886));
                                                let _e3891 = local_1.member[0u];
                                                let _e3894 = local_1.member_1[0u];
                                                let _e3897 = local_1.member[0u];
                                                let _e3903 = local_1.member_2[0u];
                                                let _e3904 = ((_e3891 + ((_e3894 - _e3897) * _e2696)) - _e3903);
                                                let _e3907 = local_1.member[1u];
                                                let _e3910 = local_1.member_1[1u];
                                                let _e3913 = local_1.member[1u];
                                                let _e3919 = local_1.member_2[1u];
                                                let _e3920 = ((_e3907 + ((_e3910 - _e3913) * _e2696)) - _e3919);
                                                let _e3922 = select(_e3920, _e3904, (_e3904 < _e3920));
                                                let _e3925 = local_1.member[2u];
                                                let _e3928 = local_1.member_1[2u];
                                                let _e3931 = local_1.member[2u];
                                                let _e3937 = local_1.member_2[2u];
                                                let _e3938 = ((_e3925 + ((_e3928 - _e3931) * _e2696)) - _e3937);
                                                let _e3941 = local_1.member[3u];
                                                let _e3944 = local_1.member_1[3u];
                                                let _e3947 = local_1.member[3u];
                                                let _e3953 = local_1.member_2[3u];
                                                let _e3954 = ((_e3941 + ((_e3944 - _e3947) * _e2696)) - _e3953);
                                                let _e3956 = select(_e3954, _e3938, (_e3938 < _e3954));
                                                let _e3958 = select(_e3956, _e3922, (_e3922 < _e3956));
                                                let _e3959 = f64(0.0625f);
                                                let _e3961 = f64(0.9f);
                                                if (_e3958 > f64(0f)) {
                                                    phi_6458_ = f64(0.5f);
                                                } else {
                                                    let _e3967 = (f64(0.95f) * (_e3888 / (_e3888 - _e3958)));
                                                    phi_6458_ = select(_e3959, select(_e3961, _e3967, (_e3967 < _e3961)), (_e3967 > _e3959));
                                                }
                                                let _e3973 = phi_6458_;
                                                phi_6460_ = u32();
                                                phi_6461_ = (_e3006 * _e3973);
                                                phi_6462_ = true;
                                                phi_6463_ = false;
                                                phi_6464_ = false;
                                            }
                                            let _e3979 = phi_6460_;
                                            let _e3981 = phi_6461_;
                                            let _e3983 = phi_6462_;
                                            let _e3985 = phi_6463_;
                                            let _e3987 = phi_6464_;
                                            phi_6465_ = _e3979;
                                            phi_6466_ = _e2698;
                                            phi_6467_ = _e3981;
                                            phi_6468_ = _e2700;
                                            phi_6469_ = _e2702;
                                            phi_6470_ = _e2704;
                                            phi_6471_ = _e2706;
                                            phi_6472_ = _e3983;
                                            phi_6473_ = _e3985;
                                            phi_6474_ = _e3987;
                                            phi_6475_ = false;
                                            phi_6476_ = false;
                                            phi_6477_ = false;
                                        } else {
                                            phi_6465_ = u32();
                                            phi_6466_ = _e3801;
                                            phi_6467_ = _e3803;
                                            phi_6468_ = _e3805;
                                            phi_6469_ = _e2696;
                                            phi_6470_ = true;
                                            phi_6471_ = 0u;
                                            phi_6472_ = _e3811;
                                            phi_6473_ = false;
                                            phi_6474_ = false;
                                            phi_6475_ = _e3813;
                                            phi_6476_ = _e3815;
                                            phi_6477_ = _e3817;
                                        }
                                        let _e3989 = phi_6465_;
                                        let _e3991 = phi_6466_;
                                        let _e3993 = phi_6467_;
                                        let _e3995 = phi_6468_;
                                        let _e3997 = phi_6469_;
                                        let _e3999 = phi_6470_;
                                        let _e4001 = phi_6471_;
                                        let _e4003 = phi_6472_;
                                        let _e4005 = phi_6473_;
                                        let _e4007 = phi_6474_;
                                        let _e4009 = phi_6475_;
                                        let _e4011 = phi_6476_;
                                        let _e4013 = phi_6477_;
                                        if _e4003 {
                                            let _e4014 = (_e3997 + _e3993);
                                            let _e4016 = select(_e3991, _e4014, (_e4014 > _e3991));
                                            let _e4018 = select(_e2463.member_1, _e4016, (_e4016 < _e2463.member_1));
                                            let _e4021 = select(((_e4018 - _e3997) > _e2685), true, !(_e2704));
                                            phi_6505_ = _e4018;
                                            phi_6506_ = _e3991;
                                            phi_6507_ = _e3995;
                                            phi_6508_ = _e3997;
                                            phi_6509_ = _e3999;
                                            phi_6510_ = _e4001;
                                            phi_6511_ = _e4021;
                                            phi_6512_ = select(true, false, _e4021);
                                            phi_6513_ = false;
                                            phi_6514_ = false;
                                            phi_6515_ = false;
                                            phi_6516_ = false;
                                        } else {
                                            phi_6505_ = _e2696;
                                            phi_6506_ = _e2698;
                                            phi_6507_ = _e2700;
                                            phi_6508_ = _e2702;
                                            phi_6509_ = _e2704;
                                            phi_6510_ = _e3989;
                                            phi_6511_ = _e4005;
                                            phi_6512_ = false;
                                            phi_6513_ = _e4007;
                                            phi_6514_ = _e4009;
                                            phi_6515_ = _e4011;
                                            phi_6516_ = _e4013;
                                        }
                                        let _e4024 = phi_6505_;
                                        let _e4026 = phi_6506_;
                                        let _e4028 = phi_6507_;
                                        let _e4030 = phi_6508_;
                                        let _e4032 = phi_6509_;
                                        let _e4034 = phi_6510_;
                                        let _e4036 = phi_6511_;
                                        let _e4038 = phi_6512_;
                                        let _e4040 = phi_6513_;
                                        let _e4042 = phi_6514_;
                                        let _e4044 = phi_6515_;
                                        let _e4046 = phi_6516_;
                                        phi_4295_ = _e4024;
                                        phi_4297_ = _e4026;
                                        phi_4299_ = _e4028;
                                        phi_4301_ = _e4030;
                                        phi_4303_ = _e4032;
                                        phi_4305_ = _e4034;
                                        phi_6517_ = _e3991;
                                        phi_6518_ = _e3807;
                                        phi_6519_ = _e4036;
                                        phi_6520_ = _e4038;
                                        phi_6521_ = _e4040;
                                        phi_6522_ = _e4042;
                                        phi_6523_ = _e4044;
                                        phi_6524_ = false;
                                        phi_6525_ = _e4046;
                                    } else {
                                        phi_4295_ = f64();
                                        phi_4297_ = f64();
                                        phi_4299_ = f64();
                                        phi_4301_ = f64();
                                        phi_4303_ = bool();
                                        phi_4305_ = u32();
                                        phi_6517_ = f64();
                                        phi_6518_ = f64();
                                        phi_6519_ = false;
                                        phi_6520_ = false;
                                        phi_6521_ = false;
                                        phi_6522_ = false;
                                        phi_6523_ = false;
                                        phi_6524_ = true;
                                        phi_6525_ = false;
                                    }
                                    let _e4048 = phi_4295_;
                                    let _e4050 = phi_4297_;
                                    let _e4052 = phi_4299_;
                                    let _e4054 = phi_4301_;
                                    let _e4056 = phi_4303_;
                                    let _e4058 = phi_4305_;
                                    let _e4060 = phi_6517_;
                                    let _e4062 = phi_6518_;
                                    let _e4064 = phi_6519_;
                                    let _e4066 = phi_6520_;
                                    let _e4068 = phi_6521_;
                                    let _e4070 = phi_6522_;
                                    let _e4072 = phi_6523_;
                                    let _e4074 = phi_6524_;
                                    let _e4076 = phi_6525_;
                                    local_21 = _e4066;
                                    local_22 = _e4068;
                                    local_23 = _e4066;
                                    local_24 = _e4070;
                                    local_25 = _e4066;
                                    local_26 = _e4072;
                                    local_27 = _e4066;
                                    local_28 = _e4074;
                                    local_29 = _e4066;
                                    local_30 = _e4076;
                                    local_32 = _e4066;
                                    local_33 = _e4062;
                                    local_34 = _e4060;
                                    continue;
                                    continuing {
                                        phi_4291_ = type_9(select(_e2694.member, (_e2694.member + 1u), _e2709), select(_e2694.member_1, _e2694.member_1, _e2709));
                                        phi_4294_ = _e4048;
                                        phi_4296_ = _e4050;
                                        phi_4298_ = _e4052;
                                        phi_4300_ = _e4054;
                                        phi_4302_ = _e4056;
                                        phi_4304_ = _e4058;
                                        break if !(_e4064);
                                    }
                                }
                                let _e4079 = local_21;
                                let _e4081 = local_22;
                                let _e4082 = select(_e4081, false, _e4079);
                                let _e4084 = local_23;
                                let _e4086 = local_24;
                                let _e4089 = local_25;
                                let _e4091 = local_26;
                                let _e4094 = local_27;
                                let _e4096 = local_28;
                                let _e4099 = local_29;
                                let _e4101 = local_30;
                                let _e4107 = local_31;
                                let _e4109 = select(select(_e4086, false, _e4084), false, _e4082);
                                let _e4112 = local_32;
                                let _e4119 = select(select(select(_e4091, false, _e4089), false, _e4082), false, _e4109);
                                let _e4125 = local_33;
                                let _e4127 = local_34;
                                let _e4129 = select(select(select(_e4112, false, _e4082), false, _e4109), true, _e4119);
                                let _e4134 = local_35;
                                let _e4136 = select(select(select(select(select(_e4096, false, _e4094), false, _e4082), false, _e4109), false, _e4119), true, _e4129);
                                let _e4143 = select(select(select(select(select(select(_e4101, false, _e4099), false, _e4082), false, _e4109), false, _e4119), false, _e4129), false, _e4136);
                                let _e4148 = select(select(select(select(select(_e4082, true, _e4109), false, _e4119), false, _e4129), false, _e4136), true, _e4143);
                                let _e4151 = (select(select(type_43().member, 1u, _e4136), select(select(select(type_43().member, 1u, _e4082), 0u, _e4109), 0u, _e4143), _e4148) != 0u);
                                phi_6593_ = select(select(type_43().member_1, select(_e4134, select(_e4127, _e4125, _e4119), _e4129), _e4136), select(select(select(type_43().member_1, _e4107, _e4082), type_43().member_1, _e4109), type_43().member_1, _e4143), _e4148);
                                phi_6594_ = select(true, false, _e4151);
                                phi_6595_ = _e4151;
                                phi_6596_ = false;
                                phi_6597_ = false;
                                phi_6598_ = false;
                            } else {
                                phi_6593_ = f64();
                                phi_6594_ = _e2471;
                                phi_6595_ = false;
                                phi_6596_ = _e2473;
                                phi_6597_ = _e2475;
                                phi_6598_ = _e2477;
                            }
                            let _e4154 = phi_6593_;
                            let _e4156 = phi_6594_;
                            let _e4158 = phi_6595_;
                            let _e4160 = phi_6596_;
                            let _e4162 = phi_6597_;
                            let _e4164 = phi_6598_;
                            phi_6599_ = _e2463;
                            phi_6600_ = _e2465;
                            phi_6601_ = _e4154;
                            phi_6602_ = _e2467;
                            phi_6603_ = _e4156;
                            phi_6604_ = _e4158;
                            phi_6605_ = false;
                            phi_6606_ = _e4160;
                            phi_6607_ = _e4162;
                            phi_6608_ = _e4164;
                        } else {
                            phi_6599_ = type_44();
                            phi_6600_ = bool();
                            phi_6601_ = f64();
                            phi_6602_ = type_44();
                            phi_6603_ = false;
                            phi_6604_ = false;
                            phi_6605_ = true;
                            phi_6606_ = false;
                            phi_6607_ = false;
                            phi_6608_ = false;
                        }
                        let _e4166 = phi_6599_;
                        let _e4168 = phi_6600_;
                        let _e4170 = phi_6601_;
                        let _e4172 = phi_6602_;
                        let _e4174 = phi_6603_;
                        let _e4176 = phi_6604_;
                        let _e4178 = phi_6605_;
                        let _e4180 = phi_6606_;
                        let _e4182 = phi_6607_;
                        let _e4184 = phi_6608_;
                        local_36 = _e4176;
                        local_37 = _e4168;
                        local_38 = _e4166;
                        local_39 = _e4170;
                        local_40 = _e4170;
                        local_41 = _e4170;
                        local_45 = _e4178;
                        local_46 = _e4180;
                        local_47 = _e4182;
                        local_48 = _e4184;
                        local_42 = _e4176;
                        local_43 = _e4172;
                        continue;
                        continuing {
                            phi_2391_ = type_9(select(_e1446.member, (_e1446.member + 1u), _e1449), select(_e1446.member_1, _e1446.member_1, _e1449));
                            break if !(_e4174);
                        }
                    }
                    let _e4187 = local_36;
                    if _e4187 {
                        let _e4189 = local_37;
                        if _e4189 {
                            let _e4191 = local_38;
                            let _e4194 = local_39;
                            let _e4196 = ((_e4191.member_1 - _e4194) <= _e1409);
                            let _e4201 = local_40;
                            phi_6624_ = type_43(select(type_43().member, 1u, _e4196), select(type_43().member_1, _e4201, _e4196));
                            phi_6625_ = select(true, false, _e4196);
                        } else {
                            phi_6624_ = type_43();
                            phi_6625_ = true;
                        }
                        let _e4206 = phi_6624_;
                        let _e4208 = phi_6625_;
                        let _e4213 = local_41;
                        phi_6631_ = type_43(select(_e4206.member, 2u, _e4208), select(_e4206.member_1, _e4213, _e4208));
                        phi_6632_ = false;
                        phi_6633_ = false;
                        phi_6634_ = false;
                        phi_6635_ = false;
                    } else {
                        phi_6631_ = type_43();
                        let _e4700 = local_45;
                        phi_6632_ = _e4700;
                        let _e4703 = local_46;
                        phi_6633_ = _e4703;
                        let _e4706 = local_47;
                        phi_6634_ = _e4706;
                        let _e4709 = local_48;
                        phi_6635_ = _e4709;
                    }
                    let _e4217 = phi_6631_;
                    let _e4219 = phi_6632_;
                    let _e4221 = phi_6633_;
                    let _e4223 = phi_6634_;
                    let _e4225 = phi_6635_;
                    let _e4232 = select(_e4221, false, _e4219);
                    let _e4236 = local_42;
                    let _e4243 = select(select(_e4223, false, _e4219), false, _e4232);
                    let _e4249 = select(select(select(_e4225, false, _e4219), false, _e4232), false, _e4243);
                    let _e4253 = local_43;
                    let _e4257 = select(select(_e4232, true, _e4243), true, _e4249);
                    phi_6677_ = type_43(select(_e4217.member, select(select(select(type_43().member, 0u, _e4232), 0u, _e4243), 1u, _e4249), _e4257), select(_e4217.member_1, select(select(select(type_43().member_1, type_43().member_1, _e4232), type_43().member_1, _e4243), _e4253.member, _e4249), _e4257));
                    phi_6678_ = type_43(select(type_43().member, 0u, _e4219), select(type_43().member_1, type_43().member_1, _e4219));
                    phi_6679_ = select(select(select(select(select(_e4236, false, _e4219), false, _e4232), false, _e4243), false, _e4249), true, _e4257);
                }
                let _e4268 = phi_6677_;
                let _e4270 = phi_6678_;
                let _e4272 = phi_6679_;
                let _e4275 = select(_e4270.member, _e4268.member, _e4272);
                let _e4278 = select(_e4270.member_1, _e4268.member_1, _e4272);
                let _e4284 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4278 > _e534)), (_e4275 == 1u))));
                switch bitcast<i32>(_e4275) {
                    case 0: {
                        phi_6723_ = type_35(0u, _e4284, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4288 = function_1(_e4278);
                        phi_6723_ = type_35(0u, _e4284, _e4288, true);
                        break;
                    }
                    case 2: {
                        let _e4286 = function_1(_e4278);
                        phi_6723_ = type_35(1u, _e4284, _e4286, true);
                        break;
                    }
                    default: {
                        phi_6723_ = type_35();
                        break;
                    }
                }
                let _e4292 = phi_6723_;
                phi_6724_ = _e4292;
                phi_6725_ = type_9(_e189, _e192);
            } else {
                phi_6724_ = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6725_ = type_9(0u, 0u);
            }
            let _e4294 = phi_6724_;
            let _e4296 = phi_6725_;
            let _e4301 = params.member.member.member_1;
            let _e4303 = ((_e4301 & 16u) != 0u);
            let _e4306 = select(true, false, (_e4294.member == 0u));
            let _e4309 = select(false, select(_e4306, true, _e4303), _e4294.member_3);
            if _e4294.member_3 {
                if _e4306 {
                } else {
                    let _e4314 = (_e4294.member_2[1] >> bitcast<u32>(20i));
                    if (_e4314 <= 896u) {
                        phi_6771_ = 0u;
                    } else {
                        phi_6771_ = ((((_e4314 - 896u) << bitcast<u32>(23i)) | ((_e4294.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4294.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e4329 = phi_6771_;
                    let _e4331 = atomicMin((&earliest.member[0u]), _e4329);
                }
            }
            if (_e107 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4309 {
                let _e4335 = atomicAdd((&counters[0u]), 1u);
                phi_6785_ = _e4335;
            } else {
                phi_6785_ = 0u;
            }
            let _e4337 = phi_6785_;
            workgroupBarrier();
            if (_e107 == 0u) {
                let _e4340 = atomicLoad((&counters[0u]));
                if (_e4340 > 0u) {
                    let _e4343 = atomicAdd((&contacts.member[0u]), _e4340);
                    atomicStore((&counters[1u]), _e4343);
                }
            }
            workgroupBarrier();
            let _e4346 = atomicLoad((&counters[1u]));
            let _e4347 = (_e4346 + _e4337);
            if _e4309 {
                if _e4303 {
                    let _e4350 = params.member.member_1.member_3;
                    if (_e4347 < _e4350) {
                        let _e4356 = (7u * _e4347);
                        atomicStore((&contacts.member[(4u + _e4356)]), select(1u, 0u, ((_e4296.member_1 & 2147483648u) == 0u)));
                        atomicStore((&contacts.member[(_e4356 + 5u)]), _e4294.member);
                        atomicStore((&contacts.member[(_e4356 + 6u)]), _e4296.member);
                        atomicStore((&contacts.member[(_e4356 + 7u)]), (_e4296.member_1 & 2147483647u));
                        atomicStore((&contacts.member[(_e4356 + 8u)]), _e4294.member_2[0]);
                        atomicStore((&contacts.member[(_e4356 + 9u)]), _e4294.member_2[1]);
                        atomicStore((&contacts.member[(_e4356 + 10u)]), _e4294.member_1);
                    }
                    phi_6855_ = false;
                } else {
                    phi_6855_ = true;
                }
                let _e4378 = phi_6855_;
                phi_6856_ = _e4378;
            } else {
                phi_6856_ = true;
            }
            let _e4380 = phi_6856_;
            if _e4380 {
                if _e4309 {
                    let _e4383 = params.member.member_2.member;
                    if (_e4347 < _e4383) {
                        let _e4385 = (2u * _e4347);
                        atomicStore((&contacts.member[(4u + _e4385)]), _e4296.member);
                        atomicStore((&contacts.member[(_e4385 + 5u)]), _e4296.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_434_ = type_9(select(_e160.member, (_e160.member + 1u), _e163), select(_e160.member_1, _e160.member_1, _e163));
            break if !(_e176);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
