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

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_19 {
    member: u32,
}

struct type_20 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_21 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_26 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_27 {
    member: type_19,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_28 {
    member: type_7,
    member_1: type_8,
    member_2: type_27,
}

struct type_29 {
    member: type_28,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(6) 
var<storage, read_write> left: type_39;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_39;
@group(0) @binding(0) 
var<storage> params: type_29;
@group(0) @binding(2) 
var<storage> positions: type_11;
var<private> global: type_9 = type_9(3u, u32());

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: u32) -> type_9 {
    return type_9(0u, param_2);
}

fn function_2(param_3: u32, param_4: u32, param_5: u32, param_6: u32) -> type_9 {
    let _e9 = (param_4 + param_6);
    let _e13 = ((param_3 + param_5) + select(0u, 1u, (_e9 < param_4)));
    let _e24 = ((_e9 >> bitcast<u32>(1u)) | ((_e13 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
    let _e25 = function_1(17u);
    let _e28 = (_e24 + _e25.member_1);
    return type_9(((bitcast<u32>((bitcast<i32>(_e13) >> bitcast<u32>(1u))) + _e25.member) + select(0u, 1u, (_e28 < _e24))), _e28);
}

fn function_3(param_7: u32) -> type_9 {
    return type_9(0u, param_7);
}

fn function_4(param_8: u32, param_9: u32, param_10: u32) -> type_9 {
    let _e10 = (param_8 >> bitcast<u32>(16i));
    let _e11 = (param_8 & 65535u);
    let _e13 = (param_10 >> bitcast<u32>(16i));
    let _e14 = (param_10 & 65535u);
    let _e19 = ((_e10 * _e14) + ((_e11 * _e14) >> bitcast<u32>(16i)));
    let _e30 = (param_8 * param_10);
    let _e32 = (param_9 >> bitcast<u32>(16i));
    let _e33 = (param_9 & 65535u);
    let _e35 = (param_10 >> bitcast<u32>(16i));
    let _e36 = (param_10 & 65535u);
    let _e41 = ((_e32 * _e36) + ((_e33 * _e36) >> bitcast<u32>(16i)));
    let _e59 = function_3((((_e32 * _e35) + (_e41 >> bitcast<u32>(16i))) + (((_e33 * _e35) + (_e41 & 65535u)) >> bitcast<u32>(16i))));
    let _e62 = (_e30 + _e59.member_1);
    return type_9(((((((((_e10 * _e13) + (_e19 >> bitcast<u32>(16i))) + (((_e11 * _e13) + (_e19 & 65535u)) >> bitcast<u32>(16i))) - (bitcast<u32>((bitcast<i32>(param_8) >> bitcast<u32>(31i))) & param_10)) + _e59.member) + select(0u, 1u, (_e62 < _e30))) << bitcast<u32>(1i)) | (_e62 >> bitcast<u32>(31i))), ((_e62 << bitcast<u32>(1i)) | ((param_9 * param_10) >> bitcast<u32>(31i))));
}

fn function_5(param_11: f32, param_12: f32, param_13: f32) -> f32 {
    return (param_11 + ((param_12 - param_11) * param_13));
}

fn function_6(param_14: u32, param_15: u32) -> type_9 {
    let _e4 = (param_15 + param_15);
    let _e9 = (_e4 + param_15);
    return type_9(((((param_14 + param_14) + select(0u, 1u, (_e4 < param_15))) + param_14) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_7(param_16: u32, param_17: u32, param_18: u32, param_19: u32) -> type_9 {
    let _e14 = bitcast<u32>((bitcast<i32>(param_16) >> bitcast<u32>(31i)));
    let _e18 = bitcast<u32>((bitcast<i32>(param_18) >> bitcast<u32>(31i)));
    let _e20 = (param_16 >> bitcast<u32>(16i));
    let _e21 = (param_16 & 65535u);
    let _e23 = (param_18 >> bitcast<u32>(16i));
    let _e24 = (param_18 & 65535u);
    let _e29 = ((_e20 * _e24) + ((_e21 * _e24) >> bitcast<u32>(16i)));
    let _e40 = (param_16 * param_18);
    let _e42 = (param_16 >> bitcast<u32>(16i));
    let _e43 = (param_16 & 65535u);
    let _e45 = (param_19 >> bitcast<u32>(16i));
    let _e46 = (param_19 & 65535u);
    let _e51 = ((_e42 * _e46) + ((_e43 * _e46) >> bitcast<u32>(16i)));
    let _e64 = (param_17 >> bitcast<u32>(16i));
    let _e65 = (param_17 & 65535u);
    let _e67 = (param_18 >> bitcast<u32>(16i));
    let _e68 = (param_18 & 65535u);
    let _e73 = ((_e64 * _e68) + ((_e65 * _e68) >> bitcast<u32>(16i)));
    let _e84 = (param_17 * param_18);
    let _e90 = ((((_e42 * _e45) + (_e51 >> bitcast<u32>(16i))) + (((_e43 * _e45) + (_e51 & 65535u)) >> bitcast<u32>(16i))) - (_e14 & param_19));
    let _e92 = ((((_e64 * _e67) + (_e73 >> bitcast<u32>(16i))) + (((_e65 * _e67) + (_e73 & 65535u)) >> bitcast<u32>(16i))) - (_e18 & param_17));
    let _e93 = ((param_16 * param_19) + _e84);
    let _e100 = (_e40 + _e90);
    let _e109 = (_e100 + _e92);
    let _e114 = function_3(select(0u, 1u, (_e93 < _e84)));
    let _e117 = (_e109 + _e114.member_1);
    return type_9((((((((((((((_e20 * _e23) + (_e29 >> bitcast<u32>(16i))) + (((_e21 * _e23) + (_e29 & 65535u)) >> bitcast<u32>(16i))) - (_e14 & param_18)) - (_e18 & param_16)) + bitcast<u32>((bitcast<i32>(_e90) >> bitcast<u32>(31i)))) + select(0u, 1u, (_e100 < _e40))) + bitcast<u32>((bitcast<i32>(_e92) >> bitcast<u32>(31i)))) + select(0u, 1u, (_e109 < _e100))) + _e114.member) + select(0u, 1u, (_e117 < _e109))) << bitcast<u32>(2i)) | (_e117 >> bitcast<u32>(30i))), ((_e117 << bitcast<u32>(2i)) | (_e93 >> bitcast<u32>(30i))));
}

fn function_8(param_20: array<u32, 2>, param_21: i32) -> type_9 {
    var phi_6067_: type_9;
    var phi_6068_: type_9;
    var phi_6069_: type_9;
    var phi_6070_: type_9;
    var phi_6071_: type_9;
    var phi_6072_: bool;

    let _e24 = ((param_20[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_20[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_21);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_6071_ = type_9();
        phi_6072_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_6070_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_6069_ = type_9((param_20[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_6068_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_20[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_20[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_6067_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_20[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_6067_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_6067_;
                    phi_6068_ = _e67;
                }
                let _e83 = phi_6068_;
                phi_6069_ = _e83;
            }
            let _e89 = phi_6069_;
            phi_6070_ = _e89;
        }
        let _e91 = phi_6070_;
        phi_6071_ = _e91;
        phi_6072_ = _e37;
    }
    let _e93 = phi_6071_;
    let _e95 = phi_6072_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_20[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_9(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: type_26;
    var phi_262_: u32;
    var phi_308_: u32;
    var phi_311_: type_9;
    var phi_486_: type_20;
    var phi_621_: type_25;
    var phi_888_: type_14;
    var phi_891_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_893_: array<u32, 4>;
    var phi_889_: type_14;
    var phi_934_: type_15;
    var phi_1184_: array<array<u32, 2>, 3>;
    var phi_1185_: array<array<u32, 2>, 3>;
    var phi_892_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_894_: array<u32, 4>;
    var local_2: array<array<array<type_9, 3>, 2>, 4>;
    var local_3: array<array<array<type_9, 3>, 2>, 4>;
    var local_4: array<array<array<type_9, 3>, 2>, 4>;
    var local_5: array<array<array<type_9, 3>, 2>, 4>;
    var local_6: array<array<array<type_9, 3>, 2>, 4>;
    var local_7: array<array<array<type_9, 3>, 2>, 4>;
    var local_8: array<array<array<type_9, 3>, 2>, 4>;
    var local_9: array<array<array<type_9, 3>, 2>, 4>;
    var local_10: array<array<array<type_9, 3>, 2>, 4>;
    var local_11: array<array<array<type_9, 3>, 2>, 4>;
    var local_12: array<array<array<type_9, 3>, 2>, 4>;
    var local_13: array<array<array<type_9, 3>, 2>, 4>;
    var local_14: array<array<array<type_9, 3>, 2>, 4>;
    var local_15: array<array<array<type_9, 3>, 2>, 4>;
    var local_16: array<array<array<type_9, 3>, 2>, 4>;
    var local_17: array<array<array<type_9, 3>, 2>, 4>;
    var local_18: array<array<array<type_9, 3>, 2>, 4>;
    var local_19: array<array<array<type_9, 3>, 2>, 4>;
    var local_20: array<array<array<type_9, 3>, 2>, 4>;
    var local_21: array<array<array<type_9, 3>, 2>, 4>;
    var local_22: array<array<array<type_9, 3>, 2>, 4>;
    var local_23: array<array<array<type_9, 3>, 2>, 4>;
    var local_24: array<array<array<type_9, 3>, 2>, 4>;
    var local_25: array<array<array<type_9, 3>, 2>, 4>;
    var phi_1778_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_1792_: type_14;
    var phi_1795_: array<type_9, 4>;
    var phi_1797_: array<array<type_9, 3>, 2>;
    var phi_1799_: array<array<type_9, 3>, 2>;
    var phi_1801_: array<array<type_9, 3>, 2>;
    var phi_1793_: type_14;
    var phi_1842_: type_15;
    var phi_1796_: array<type_9, 4>;
    var phi_1798_: array<array<type_9, 3>, 2>;
    var phi_1800_: array<array<type_9, 3>, 2>;
    var phi_1802_: array<array<type_9, 3>, 2>;
    var local_26: array<type_9, 4>;
    var local_27: array<type_9, 4>;
    var local_28: array<type_9, 4>;
    var local_29: array<type_9, 4>;
    var local_30: array<type_9, 4>;
    var local_31: array<type_9, 4>;
    var local_32: array<type_9, 4>;
    var local_33: array<type_9, 4>;
    var local_34: array<type_9, 4>;
    var local_35: array<type_9, 4>;
    var local_36: array<type_9, 4>;
    var local_37: array<type_9, 4>;
    var phi_2395_: u32;
    var phi_2398_: array<type_9, 4>;
    var phi_2400_: bool;
    var phi_2402_: bool;
    var phi_2404_: bool;
    var phi_2406_: bool;
    var phi_2408_: type_17;
    var phi_2410_: u32;
    var phi_2412_: u32;
    var phi_2414_: u32;
    var phi_2416_: u32;
    var phi_2418_: u32;
    var phi_2427_: u32;
    var phi_2430_: array<type_9, 4>;
    var phi_2432_: bool;
    var phi_2434_: bool;
    var phi_2436_: bool;
    var phi_2438_: bool;
    var phi_2440_: bool;
    var phi_2442_: bool;
    var phi_2444_: u32;
    var phi_2446_: u32;
    var phi_2448_: u32;
    var phi_2450_: u32;
    var phi_2452_: u32;
    var phi_3101_: u32;
    var phi_3102_: array<type_9, 4>;
    var phi_3103_: bool;
    var phi_3104_: u32;
    var phi_3105_: u32;
    var phi_3106_: array<type_9, 4>;
    var phi_3107_: bool;
    var phi_3108_: bool;
    var phi_3109_: u32;
    var phi_3110_: u32;
    var phi_3111_: u32;
    var phi_3112_: array<type_9, 4>;
    var phi_3113_: bool;
    var phi_3114_: bool;
    var phi_3115_: u32;
    var phi_3116_: u32;
    var phi_3117_: u32;
    var phi_3118_: array<type_9, 4>;
    var phi_3119_: bool;
    var phi_3120_: bool;
    var phi_3121_: bool;
    var phi_3122_: bool;
    var phi_3123_: bool;
    var phi_3124_: bool;
    var phi_3125_: u32;
    var phi_3126_: u32;
    var phi_3127_: u32;
    var phi_3128_: u32;
    var phi_3129_: u32;
    var phi_3130_: bool;
    var phi_3131_: u32;
    var phi_3132_: array<type_9, 4>;
    var phi_3133_: bool;
    var phi_3134_: bool;
    var phi_3135_: bool;
    var phi_3136_: bool;
    var phi_3137_: bool;
    var phi_3138_: bool;
    var phi_3139_: u32;
    var phi_3140_: u32;
    var phi_3141_: u32;
    var phi_3142_: u32;
    var phi_3143_: u32;
    var phi_3144_: bool;
    var phi_2428_: u32;
    var phi_2431_: array<type_9, 4>;
    var phi_2433_: bool;
    var phi_2435_: bool;
    var phi_2437_: bool;
    var phi_2439_: bool;
    var phi_2441_: bool;
    var phi_2443_: bool;
    var phi_2445_: u32;
    var phi_2447_: u32;
    var phi_2449_: u32;
    var phi_2451_: u32;
    var phi_2453_: u32;
    var phi_3145_: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: u32;
    var local_41: u32;
    var local_42: u32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: bool;
    var local_49: bool;
    var local_50: u32;
    var local_51: u32;
    var local_52: bool;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: u32;
    var local_57: u32;
    var phi_3402_: type_17;
    var local_58: u32;
    var local_59: u32;
    var local_60: array<type_9, 4>;
    var local_61: array<type_9, 4>;
    var local_62: array<type_9, 4>;
    var local_63: array<type_9, 4>;
    var local_64: array<type_9, 4>;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var phi_3257_: type_14;
    var phi_3260_: f32;
    var phi_3262_: f32;
    var phi_3264_: f32;
    var phi_3258_: type_14;
    var phi_3305_: type_15;
    var phi_3261_: f32;
    var phi_3263_: f32;
    var phi_3265_: f32;
    var local_68: f32;
    var local_69: f32;
    var phi_3403_: bool;
    var phi_3404_: type_17;
    var phi_3405_: type_17;
    var local_70: u32;
    var local_71: u32;
    var phi_3406_: bool;
    var phi_3407_: type_17;
    var phi_3408_: type_17;
    var local_72: u32;
    var phi_3438_: type_14;
    var phi_3441_: u32;
    var phi_3443_: u32;
    var phi_3439_: type_14;
    var phi_3483_: type_15;
    var phi_3442_: u32;
    var local_73: u32;
    var phi_3659_: bool;
    var phi_3667_: bool;
    var phi_3668_: type_17;
    var phi_3891_: array<type_9, 2>;
    var phi_3892_: array<type_9, 2>;
    var phi_3926_: array<type_9, 2>;
    var phi_3927_: array<type_9, 2>;
    var phi_3961_: array<type_9, 2>;
    var phi_3962_: array<type_9, 2>;
    var phi_3996_: array<type_9, 2>;
    var phi_3997_: array<type_9, 2>;
    var phi_4031_: array<type_9, 2>;
    var phi_4032_: array<type_9, 2>;
    var phi_4066_: array<type_9, 2>;
    var phi_4067_: array<type_9, 2>;
    var phi_4825_: type_9;
    var phi_4826_: type_9;
    var phi_4827_: type_9;
    var phi_4828_: type_9;
    var phi_4918_: bool;
    var phi_4919_: bool;
    var phi_4920_: bool;
    var phi_4921_: bool;
    var phi_4922_: bool;
    var phi_4980_: bool;
    var phi_4981_: bool;
    var phi_4982_: bool;
    var phi_4983_: bool;
    var phi_4984_: bool;
    var phi_4985_: bool;
    var phi_4998_: u32;
    var local_74: bool;
    var phi_5070_: bool;
    var phi_5071_: bool;
    var phi_5072_: bool;
    var phi_5073_: bool;
    var phi_5074_: bool;
    var phi_5081_: bool;
    var phi_5082_: bool;
    var phi_5083_: bool;
    var phi_5084_: bool;
    var phi_5085_: type_17;
    var phi_5086_: bool;
    var phi_5087_: bool;
    var phi_5088_: type_17;
    var phi_5089_: bool;
    var phi_5090_: bool;
    var phi_5091_: bool;
    var phi_5092_: bool;
    var phi_5093_: bool;
    var phi_5094_: bool;
    var phi_5095_: bool;
    var phi_5096_: bool;
    var phi_5097_: type_17;
    var phi_5098_: bool;
    var phi_5099_: bool;
    var phi_5100_: type_17;
    var phi_5101_: bool;
    var phi_5102_: bool;
    var phi_5103_: bool;
    var phi_5104_: bool;
    var local_75: u32;
    var local_76: u32;
    var local_77: u32;
    var local_78: u32;
    var local_79: u32;
    var local_80: u32;
    var phi_5155_: u32;
    var phi_5156_: u32;
    var phi_5157_: bool;
    var phi_5158_: bool;
    var phi_5159_: u32;
    var phi_5160_: u32;
    var phi_5161_: bool;
    var phi_5162_: bool;
    var phi_5163_: bool;
    var phi_5164_: bool;
    var phi_5165_: u32;
    var phi_5166_: u32;
    var phi_5167_: bool;
    var phi_5168_: bool;
    var phi_5169_: bool;
    var phi_5194_: type_14;
    var phi_5197_: array<u32, 3>;
    var phi_5199_: array<type_9, 4>;
    var phi_5195_: type_14;
    var phi_5240_: type_15;
    var phi_5198_: array<u32, 3>;
    var phi_5200_: array<type_9, 4>;
    var local_81: array<type_9, 4>;
    var local_82: array<type_9, 4>;
    var local_83: array<type_9, 4>;
    var local_84: array<type_9, 4>;
    var local_85: array<type_9, 4>;
    var local_86: array<type_9, 4>;
    var local_87: array<type_9, 4>;
    var local_88: array<type_9, 4>;
    var local_89: array<type_9, 4>;
    var local_90: array<type_9, 4>;
    var local_91: array<type_9, 4>;
    var local_92: array<type_9, 4>;
    var phi_5571_: u32;
    var phi_5572_: array<type_9, 4>;
    var phi_5573_: u32;
    var phi_5574_: array<type_9, 4>;
    var phi_5575_: bool;
    var phi_5576_: bool;
    var phi_5577_: u32;
    var phi_5578_: array<type_9, 4>;
    var phi_5579_: bool;
    var phi_5580_: bool;
    var phi_5581_: bool;
    var phi_5582_: bool;
    var phi_5583_: u32;
    var phi_5584_: u32;
    var phi_5585_: bool;
    var phi_5586_: bool;
    var phi_5587_: bool;
    var phi_5588_: bool;
    var phi_5589_: bool;
    var phi_5590_: bool;
    var phi_2396_: u32;
    var phi_2399_: array<type_9, 4>;
    var phi_2401_: bool;
    var phi_2403_: bool;
    var phi_2405_: bool;
    var phi_2407_: bool;
    var phi_2409_: type_17;
    var phi_2411_: u32;
    var phi_2413_: u32;
    var phi_2415_: u32;
    var phi_2417_: u32;
    var phi_2419_: u32;
    var phi_5591_: bool;
    var phi_5592_: type_17;
    var phi_5593_: bool;
    var phi_5594_: bool;
    var phi_5595_: bool;
    var phi_5596_: bool;
    var phi_5597_: bool;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: bool;
    var local_96: bool;
    var local_97: bool;
    var local_98: bool;
    var local_99: bool;
    var local_100: bool;
    var local_101: bool;
    var local_102: bool;
    var local_103: bool;
    var local_104: bool;
    var local_105: bool;
    var local_106: bool;
    var phi_5641_: type_9;
    var phi_5642_: bool;
    var phi_5643_: bool;
    var phi_5644_: bool;
    var local_107: type_17;
    var phi_5680_: type_9;
    var phi_5684_: type_9;
    var phi_5685_: type_9;
    var phi_5719_: array<u32, 2>;
    var phi_5722_: type_26;
    var phi_5723_: bool;
    var phi_5727_: type_26;
    var phi_5767_: bool;
    var phi_5768_: bool;
    var phi_5769_: bool;
    var phi_5770_: bool;
    var phi_5775_: bool;
    var phi_5831_: bool;
    var phi_5832_: bool;
    var phi_5876_: u32;
    var phi_5958_: u32;
    var local_108: bool;
    var local_109: bool;
    var local_110: bool;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: u32;
    var local_116: u32;
    var local_117: u32;
    var local_118: array<type_9, 4>;
    var local_119: array<type_9, 4>;
    var local_120: u32;
    var local_121: u32;
    var local_122: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e100 = id_2;
    let _e101 = n_2;
    let _e102 = lane_2;
    let _e115 = ((_e100.y * _e101.x) + _e100.x);
    let _e118 = (_e101.x * _e101.y);
    let _e121 = params.member.member_1.member_2;
    let _e123 = input.member[0u];
    let _e125 = select(_e123, _e121, (_e121 < _e123));
    let _e127 = params.member.member_1.member_1;
    if (_e125 > _e127) {
        let _e130 = params.member.member_1.member_1;
        phi_262_ = (_e125 - _e130);
    } else {
        phi_262_ = 0u;
    }
    let _e133 = phi_262_;
    let _e135 = params.member.member_1.member;
    let _e137 = select(_e133, _e135, (_e135 < _e133));
    let _e139 = (_e137 / 64u);
    let _e143 = select(_e139, (_e139 + 1u), ((_e137 % 64u) > 0u));
    if (_e143 > _e115) {
        let _e145 = (_e143 - _e115);
        if (_e118 == 0u) {
            return;
        }
        let _e147 = (_e145 / _e118);
        if (_e118 == 0u) {
            return;
        }
        phi_308_ = select(_e147, (_e147 + 1u), ((_e145 % _e118) > 0u));
    } else {
        phi_308_ = 0u;
    }
    let _e154 = phi_308_;
    phi_311_ = type_9(0u, _e154);
    loop {
        let _e157 = phi_311_;
        let _e160 = (_e157.member < _e157.member_1);
        let _e173 = (bitcast<i32>(select(0u, 1u, _e160)) != 0i);
        if _e173 {
            let _e177 = (((_e115 + (select(type_9().member_1, _e157.member, _e160) * _e118)) * 64u) + _e102);
            if (_e177 < _e137) {
                let _e182 = params.member.member_1.member_1;
                let _e184 = (2u * (_e182 + _e177));
                let _e187 = input.member[(4u + _e184)];
                let _e190 = input.member[(_e184 + 5u)];
                let _e195 = (_e190 & 2147483647u);
                if (select(1u, 0u, ((_e190 & 2147483648u) == 0u)) == 0u) {
                    let _e214 = params.member.member.member[1u];
                    let _e217 = ((2u * _e214) + (3u * _e195));
                    let _e219 = elements.member[_e217];
                    let _e222 = elements.member[(_e217 + 1u)];
                    let _e225 = elements.member[(_e217 + 2u)];
                    phi_486_ = type_20(0u, array<u32, 4>(_e187, _e219, _e222, _e225));
                } else {
                    let _e198 = (2u * _e187);
                    let _e200 = elements.member[_e198];
                    let _e203 = elements.member[(_e198 + 1u)];
                    let _e204 = (2u * _e195);
                    let _e206 = elements.member[_e204];
                    let _e209 = elements.member[(_e204 + 1u)];
                    phi_486_ = type_20(1u, array<u32, 4>(_e200, _e203, _e206, _e209));
                }
                let _e229 = phi_486_;
                let _e234 = paths.member[_e229.member_1[0]];
                let _e249 = paths.member[_e229.member_1[1]];
                let _e264 = paths.member[_e229.member_1[2]];
                let _e279 = paths.member[_e229.member_1[3]];
                let _e293 = params.member.member.member_4;
                if (_e229.member != 0u) {
                    phi_621_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e264.member.x - _e234.member.x), (_e264.member.y - _e234.member.y), (_e264.member.z - _e234.member.z)), array<f32, 3>((_e264.member_1.x - _e234.member_1.x), (_e264.member_1.y - _e234.member_1.y), (_e264.member_1.z - _e234.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e249.member.x - _e234.member.x), (_e249.member.y - _e234.member.y), (_e249.member.z - _e234.member.z)), array<f32, 3>((_e249.member_1.x - _e234.member_1.x), (_e249.member_1.y - _e234.member_1.y), (_e249.member_1.z - _e234.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e264.member.x - _e279.member.x), (_e264.member.y - _e279.member.y), (_e264.member.z - _e279.member.z)), array<f32, 3>((_e264.member_1.x - _e279.member_1.x), (_e264.member_1.y - _e279.member_1.y), (_e264.member_1.z - _e279.member_1.z))), (_e293 + _e293));
                } else {
                    phi_621_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e234.member.x - _e249.member.x), (_e234.member.y - _e249.member.y), (_e234.member.z - _e249.member.z)), array<f32, 3>((_e234.member_1.x - _e249.member_1.x), (_e234.member_1.y - _e249.member_1.y), (_e234.member_1.z - _e249.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e264.member.x - _e249.member.x), (_e264.member.y - _e249.member.y), (_e264.member.z - _e249.member.z)), array<f32, 3>((_e264.member_1.x - _e249.member_1.x), (_e264.member_1.y - _e249.member_1.y), (_e264.member_1.z - _e249.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e279.member.x - _e249.member.x), (_e279.member.y - _e249.member.y), (_e279.member.z - _e249.member.z)), array<f32, 3>((_e279.member_1.x - _e249.member_1.x), (_e279.member_1.y - _e249.member_1.y), (_e279.member_1.z - _e249.member_1.z))), (_e293 + _e293));
                }
                let _e354 = phi_621_;
                let _e360 = select(_e354.member[0][0], -(_e354.member[0][0]), (_e354.member[0][0] < 0f));
                let _e364 = select(_e354.member[0][1], -(_e354.member[0][1]), (_e354.member[0][1] < 0f));
                let _e366 = select(_e364, _e360, (_e360 > _e364));
                let _e370 = select(_e354.member[0][2], -(_e354.member[0][2]), (_e354.member[0][2] < 0f));
                let _e372 = select(_e370, _e366, (_e366 > _e370));
                let _e378 = select(_e354.member[1][0], -(_e354.member[1][0]), (_e354.member[1][0] < 0f));
                let _e382 = select(_e354.member[1][1], -(_e354.member[1][1]), (_e354.member[1][1] < 0f));
                let _e384 = select(_e382, _e378, (_e378 > _e382));
                let _e388 = select(_e354.member[1][2], -(_e354.member[1][2]), (_e354.member[1][2] < 0f));
                let _e390 = select(_e388, _e384, (_e384 > _e388));
                let _e400 = select(_e354.member_1[0][0], -(_e354.member_1[0][0]), (_e354.member_1[0][0] < 0f));
                let _e404 = select(_e354.member_1[0][1], -(_e354.member_1[0][1]), (_e354.member_1[0][1] < 0f));
                let _e406 = select(_e404, _e400, (_e400 > _e404));
                let _e410 = select(_e354.member_1[0][2], -(_e354.member_1[0][2]), (_e354.member_1[0][2] < 0f));
                let _e412 = select(_e410, _e406, (_e406 > _e410));
                let _e418 = select(_e354.member_1[1][0], -(_e354.member_1[1][0]), (_e354.member_1[1][0] < 0f));
                let _e422 = select(_e354.member_1[1][1], -(_e354.member_1[1][1]), (_e354.member_1[1][1] < 0f));
                let _e424 = select(_e422, _e418, (_e418 > _e422));
                let _e428 = select(_e354.member_1[1][2], -(_e354.member_1[1][2]), (_e354.member_1[1][2] < 0f));
                let _e430 = select(_e428, _e424, (_e424 > _e428));
                let _e440 = select(_e354.member_2[0][0], -(_e354.member_2[0][0]), (_e354.member_2[0][0] < 0f));
                let _e444 = select(_e354.member_2[0][1], -(_e354.member_2[0][1]), (_e354.member_2[0][1] < 0f));
                let _e446 = select(_e444, _e440, (_e440 > _e444));
                let _e450 = select(_e354.member_2[0][2], -(_e354.member_2[0][2]), (_e354.member_2[0][2] < 0f));
                let _e452 = select(_e450, _e446, (_e446 > _e450));
                let _e458 = select(_e354.member_2[1][0], -(_e354.member_2[1][0]), (_e354.member_2[1][0] < 0f));
                let _e462 = select(_e354.member_2[1][1], -(_e354.member_2[1][1]), (_e354.member_2[1][1] < 0f));
                let _e464 = select(_e462, _e458, (_e458 > _e462));
                let _e468 = select(_e354.member_2[1][2], -(_e354.member_2[1][2]), (_e354.member_2[1][2] < 0f));
                let _e470 = select(_e468, _e464, (_e464 > _e468));
                let _e475 = function_((select(_e390, _e372, (_e372 > _e390)) + _e354.member_3), (select(_e430, _e412, (_e412 > _e430)) + _e354.member_3));
                let _e476 = function_(_e475, (select(_e470, _e452, (_e452 > _e470)) + _e354.member_3));
                let _e481 = bitcast<i32>(((bitcast<u32>(_e476) + 4u) >> bitcast<u32>(23i)));
                let _e482 = (_e481 >= 64i);
                let _e483 = (_e481 <= 190i);
                let _e489 = select(select(i32(), select(i32(), (_e481 - 126i), _e483), _e482), 2147483647i, select(true, select(true, false, _e483), _e482));
                if (_e489 == 2147483647i) {
                    phi_5680_ = type_9(2u, type_9().member_1);
                } else {
                    let _e492 = params.member.member.member_1;
                    let _e494 = ((_e492 & 8u) != 0u);
                    let _e497 = params.member.member.member_10[1u];
                    let _e503 = select((_e489 - (bitcast<i32>((_e497 >> bitcast<u32>(20i))) - 1023i)), _e489, _e494);
                    phi_888_ = type_14(0i, 4i);
                    phi_891_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))));
                    phi_893_ = _e229.member_1;
                    loop {
                        let _e505 = phi_888_;
                        let _e507 = phi_891_;
                        let _e509 = phi_893_;
                        local_2 = _e507;
                        local_3 = _e507;
                        local_4 = _e507;
                        local_5 = _e507;
                        local_6 = _e507;
                        local_7 = _e507;
                        local_8 = _e507;
                        local_9 = _e507;
                        local_10 = _e507;
                        local_11 = _e507;
                        local_12 = _e507;
                        local_13 = _e507;
                        local_14 = _e507;
                        local_15 = _e507;
                        local_16 = _e507;
                        local_17 = _e507;
                        local_18 = _e507;
                        local_19 = _e507;
                        local_20 = _e507;
                        local_21 = _e507;
                        local_22 = _e507;
                        local_23 = _e507;
                        local_24 = _e507;
                        local_25 = _e507;
                        if (_e505.member < _e505.member_1) {
                            let _e516 = (_e505.member + 1i);
                            phi_889_ = type_14(select(_e516, type_15().member_1, select(false, true, ((false == (_e516 > _e505.member)) != false))), _e505.member_1);
                            phi_934_ = type_15(1u, _e505.member);
                        } else {
                            phi_889_ = _e505;
                            phi_934_ = type_15(0u, type_15().member_1);
                        }
                        let _e527 = phi_889_;
                        let _e529 = phi_934_;
                        let _e532 = (bitcast<i32>(_e529.member) != 0i);
                        if _e532 {
                            if _e494 {
                                let _e583 = paths.member[_e509[0]];
                                let _e596 = bitcast<u32>(_e583.member.x);
                                let _e597 = (_e596 & 2147483647u);
                                let _e598 = (_e597 < 8388608u);
                                let _e609 = bitcast<u32>(_e583.member.y);
                                let _e610 = (_e609 & 2147483647u);
                                let _e611 = (_e610 < 8388608u);
                                let _e622 = bitcast<u32>(_e583.member.z);
                                let _e623 = (_e622 & 2147483647u);
                                let _e624 = (_e623 < 8388608u);
                                let _e636 = bitcast<u32>(_e583.member_1.x);
                                let _e637 = (_e636 & 2147483647u);
                                let _e638 = (_e637 < 8388608u);
                                let _e649 = bitcast<u32>(_e583.member_1.y);
                                let _e650 = (_e649 & 2147483647u);
                                let _e651 = (_e650 < 8388608u);
                                let _e662 = bitcast<u32>(_e583.member_1.z);
                                let _e663 = (_e662 & 2147483647u);
                                let _e664 = (_e663 < 8388608u);
                                phi_1184_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e636 << bitcast<u32>(29i)), 0u, _e638), select(((_e636 ^ _e637) | ((_e637 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e638)), array<u32, 2>(select((_e649 << bitcast<u32>(29i)), 0u, _e651), select(((_e649 ^ _e650) | ((_e650 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e651)), array<u32, 2>(select((_e662 << bitcast<u32>(29i)), 0u, _e664), select(((_e662 ^ _e663) | ((_e663 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e664)));
                                phi_1185_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e596 << bitcast<u32>(29i)), 0u, _e598), select(((_e596 ^ _e597) | ((_e597 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e598)), array<u32, 2>(select((_e609 << bitcast<u32>(29i)), 0u, _e611), select(((_e609 ^ _e610) | ((_e610 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e611)), array<u32, 2>(select((_e622 << bitcast<u32>(29i)), 0u, _e624), select(((_e622 ^ _e623) | ((_e623 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e624)));
                            } else {
                                let _e536 = params.member.member.member[0u];
                                let _e538 = (6u * _e509[0]);
                                let _e540 = positions.member[_e538];
                                let _e543 = positions.member[(_e538 + 1u)];
                                let _e547 = positions.member[(_e538 + 2u)];
                                let _e550 = positions.member[(_e538 + 3u)];
                                let _e554 = positions.member[(_e538 + 4u)];
                                let _e557 = positions.member[(_e538 + 5u)];
                                let _e560 = (6u * (_e536 + _e509[0]));
                                let _e562 = positions.member[_e560];
                                let _e565 = positions.member[(_e560 + 1u)];
                                let _e569 = positions.member[(_e560 + 2u)];
                                let _e572 = positions.member[(_e560 + 3u)];
                                let _e576 = positions.member[(_e560 + 4u)];
                                let _e579 = positions.member[(_e560 + 5u)];
                                phi_1184_ = array<array<u32, 2>, 3>(array<u32, 2>(_e562, _e565), array<u32, 2>(_e569, _e572), array<u32, 2>(_e576, _e579));
                                phi_1185_ = array<array<u32, 2>, 3>(array<u32, 2>(_e540, _e543), array<u32, 2>(_e547, _e550), array<u32, 2>(_e554, _e557));
                            }
                            let _e677 = phi_1184_;
                            let _e679 = phi_1185_;
                            let _e686 = function_8(_e679[0], _e503);
                            let _e687 = function_8(_e679[1], _e503);
                            let _e688 = function_8(_e679[2], _e503);
                            let _e693 = function_8(_e677[0], _e503);
                            let _e694 = function_8(_e677[1], _e503);
                            let _e695 = function_8(_e677[2], _e503);
                            phi_892_ = array<array<array<type_9, 3>, 2>, 4>(_e507[1], _e507[2], _e507[3], array<array<type_9, 3>, 2>(array<type_9, 3>(_e686, _e687, _e688), array<type_9, 3>(_e693, _e694, _e695)));
                            phi_894_ = array<u32, 4>(_e509[1], _e509[2], _e509[3], _e509[0]);
                        } else {
                            phi_892_ = array<array<array<type_9, 3>, 2>, 4>();
                            phi_894_ = array<u32, 4>();
                        }
                        let _e705 = phi_892_;
                        let _e707 = phi_894_;
                        continue;
                        continuing {
                            phi_888_ = _e527;
                            phi_891_ = _e705;
                            phi_893_ = _e707;
                            break if !(_e532);
                        }
                    }
                    let _e710 = params.member.member_2.member_1;
                    let _e712 = params.member.member_2.member_2;
                    let _e714 = params.member.member_2.member_3;
                    if (_e229.member != 0u) {
                        let _e1027 = local_14;
                        let _e1031 = local_15;
                        let _e1078 = local_16;
                        let _e1082 = local_17;
                        let _e1130 = local_18;
                        let _e1134 = local_19;
                        let _e1181 = local_20;
                        let _e1185 = local_21;
                        let _e1233 = local_22;
                        let _e1237 = local_23;
                        let _e1284 = local_24;
                        let _e1288 = local_25;
                        phi_1778_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1027[2][0][0].member - _e1031[0][0][0].member) - select(0u, 1u, (_e1027[2][0][0].member_1 < _e1031[0][0][0].member_1))), (_e1027[2][0][0].member_1 - _e1031[0][0][0].member_1)), type_9(((_e1027[2][0][1].member - _e1031[0][0][1].member) - select(0u, 1u, (_e1027[2][0][1].member_1 < _e1031[0][0][1].member_1))), (_e1027[2][0][1].member_1 - _e1031[0][0][1].member_1)), type_9(((_e1027[2][0][2].member - _e1031[0][0][2].member) - select(0u, 1u, (_e1027[2][0][2].member_1 < _e1031[0][0][2].member_1))), (_e1027[2][0][2].member_1 - _e1031[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1078[2][1][0].member - _e1082[0][1][0].member) - select(0u, 1u, (_e1078[2][1][0].member_1 < _e1082[0][1][0].member_1))), (_e1078[2][1][0].member_1 - _e1082[0][1][0].member_1)), type_9(((_e1078[2][1][1].member - _e1082[0][1][1].member) - select(0u, 1u, (_e1078[2][1][1].member_1 < _e1082[0][1][1].member_1))), (_e1078[2][1][1].member_1 - _e1082[0][1][1].member_1)), type_9(((_e1078[2][1][2].member - _e1082[0][1][2].member) - select(0u, 1u, (_e1078[2][1][2].member_1 < _e1082[0][1][2].member_1))), (_e1078[2][1][2].member_1 - _e1082[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1130[1][0][0].member - _e1134[0][0][0].member) - select(0u, 1u, (_e1130[1][0][0].member_1 < _e1134[0][0][0].member_1))), (_e1130[1][0][0].member_1 - _e1134[0][0][0].member_1)), type_9(((_e1130[1][0][1].member - _e1134[0][0][1].member) - select(0u, 1u, (_e1130[1][0][1].member_1 < _e1134[0][0][1].member_1))), (_e1130[1][0][1].member_1 - _e1134[0][0][1].member_1)), type_9(((_e1130[1][0][2].member - _e1134[0][0][2].member) - select(0u, 1u, (_e1130[1][0][2].member_1 < _e1134[0][0][2].member_1))), (_e1130[1][0][2].member_1 - _e1134[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1181[1][1][0].member - _e1185[0][1][0].member) - select(0u, 1u, (_e1181[1][1][0].member_1 < _e1185[0][1][0].member_1))), (_e1181[1][1][0].member_1 - _e1185[0][1][0].member_1)), type_9(((_e1181[1][1][1].member - _e1185[0][1][1].member) - select(0u, 1u, (_e1181[1][1][1].member_1 < _e1185[0][1][1].member_1))), (_e1181[1][1][1].member_1 - _e1185[0][1][1].member_1)), type_9(((_e1181[1][1][2].member - _e1185[0][1][2].member) - select(0u, 1u, (_e1181[1][1][2].member_1 < _e1185[0][1][2].member_1))), (_e1181[1][1][2].member_1 - _e1185[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1233[2][0][0].member - _e1237[3][0][0].member) - select(0u, 1u, (_e1233[2][0][0].member_1 < _e1237[3][0][0].member_1))), (_e1233[2][0][0].member_1 - _e1237[3][0][0].member_1)), type_9(((_e1233[2][0][1].member - _e1237[3][0][1].member) - select(0u, 1u, (_e1233[2][0][1].member_1 < _e1237[3][0][1].member_1))), (_e1233[2][0][1].member_1 - _e1237[3][0][1].member_1)), type_9(((_e1233[2][0][2].member - _e1237[3][0][2].member) - select(0u, 1u, (_e1233[2][0][2].member_1 < _e1237[3][0][2].member_1))), (_e1233[2][0][2].member_1 - _e1237[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1284[2][1][0].member - _e1288[3][1][0].member) - select(0u, 1u, (_e1284[2][1][0].member_1 < _e1288[3][1][0].member_1))), (_e1284[2][1][0].member_1 - _e1288[3][1][0].member_1)), type_9(((_e1284[2][1][1].member - _e1288[3][1][1].member) - select(0u, 1u, (_e1284[2][1][1].member_1 < _e1288[3][1][1].member_1))), (_e1284[2][1][1].member_1 - _e1288[3][1][1].member_1)), type_9(((_e1284[2][1][2].member - _e1288[3][1][2].member) - select(0u, 1u, (_e1284[2][1][2].member_1 < _e1288[3][1][2].member_1))), (_e1284[2][1][2].member_1 - _e1288[3][1][2].member_1)))));
                    } else {
                        let _e717 = local_2;
                        let _e721 = local_3;
                        let _e768 = local_4;
                        let _e772 = local_5;
                        let _e820 = local_6;
                        let _e824 = local_7;
                        let _e871 = local_8;
                        let _e875 = local_9;
                        let _e923 = local_10;
                        let _e927 = local_11;
                        let _e974 = local_12;
                        let _e978 = local_13;
                        phi_1778_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e717[0][0][0].member - _e721[1][0][0].member) - select(0u, 1u, (_e717[0][0][0].member_1 < _e721[1][0][0].member_1))), (_e717[0][0][0].member_1 - _e721[1][0][0].member_1)), type_9(((_e717[0][0][1].member - _e721[1][0][1].member) - select(0u, 1u, (_e717[0][0][1].member_1 < _e721[1][0][1].member_1))), (_e717[0][0][1].member_1 - _e721[1][0][1].member_1)), type_9(((_e717[0][0][2].member - _e721[1][0][2].member) - select(0u, 1u, (_e717[0][0][2].member_1 < _e721[1][0][2].member_1))), (_e717[0][0][2].member_1 - _e721[1][0][2].member_1))), array<type_9, 3>(type_9(((_e768[0][1][0].member - _e772[1][1][0].member) - select(0u, 1u, (_e768[0][1][0].member_1 < _e772[1][1][0].member_1))), (_e768[0][1][0].member_1 - _e772[1][1][0].member_1)), type_9(((_e768[0][1][1].member - _e772[1][1][1].member) - select(0u, 1u, (_e768[0][1][1].member_1 < _e772[1][1][1].member_1))), (_e768[0][1][1].member_1 - _e772[1][1][1].member_1)), type_9(((_e768[0][1][2].member - _e772[1][1][2].member) - select(0u, 1u, (_e768[0][1][2].member_1 < _e772[1][1][2].member_1))), (_e768[0][1][2].member_1 - _e772[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e820[2][0][0].member - _e824[1][0][0].member) - select(0u, 1u, (_e820[2][0][0].member_1 < _e824[1][0][0].member_1))), (_e820[2][0][0].member_1 - _e824[1][0][0].member_1)), type_9(((_e820[2][0][1].member - _e824[1][0][1].member) - select(0u, 1u, (_e820[2][0][1].member_1 < _e824[1][0][1].member_1))), (_e820[2][0][1].member_1 - _e824[1][0][1].member_1)), type_9(((_e820[2][0][2].member - _e824[1][0][2].member) - select(0u, 1u, (_e820[2][0][2].member_1 < _e824[1][0][2].member_1))), (_e820[2][0][2].member_1 - _e824[1][0][2].member_1))), array<type_9, 3>(type_9(((_e871[2][1][0].member - _e875[1][1][0].member) - select(0u, 1u, (_e871[2][1][0].member_1 < _e875[1][1][0].member_1))), (_e871[2][1][0].member_1 - _e875[1][1][0].member_1)), type_9(((_e871[2][1][1].member - _e875[1][1][1].member) - select(0u, 1u, (_e871[2][1][1].member_1 < _e875[1][1][1].member_1))), (_e871[2][1][1].member_1 - _e875[1][1][1].member_1)), type_9(((_e871[2][1][2].member - _e875[1][1][2].member) - select(0u, 1u, (_e871[2][1][2].member_1 < _e875[1][1][2].member_1))), (_e871[2][1][2].member_1 - _e875[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e923[3][0][0].member - _e927[1][0][0].member) - select(0u, 1u, (_e923[3][0][0].member_1 < _e927[1][0][0].member_1))), (_e923[3][0][0].member_1 - _e927[1][0][0].member_1)), type_9(((_e923[3][0][1].member - _e927[1][0][1].member) - select(0u, 1u, (_e923[3][0][1].member_1 < _e927[1][0][1].member_1))), (_e923[3][0][1].member_1 - _e927[1][0][1].member_1)), type_9(((_e923[3][0][2].member - _e927[1][0][2].member) - select(0u, 1u, (_e923[3][0][2].member_1 < _e927[1][0][2].member_1))), (_e923[3][0][2].member_1 - _e927[1][0][2].member_1))), array<type_9, 3>(type_9(((_e974[3][1][0].member - _e978[1][1][0].member) - select(0u, 1u, (_e974[3][1][0].member_1 < _e978[1][1][0].member_1))), (_e974[3][1][0].member_1 - _e978[1][1][0].member_1)), type_9(((_e974[3][1][1].member - _e978[1][1][1].member) - select(0u, 1u, (_e974[3][1][1].member_1 < _e978[1][1][1].member_1))), (_e974[3][1][1].member_1 - _e978[1][1][1].member_1)), type_9(((_e974[3][1][2].member - _e978[1][1][2].member) - select(0u, 1u, (_e974[3][1][2].member_1 < _e978[1][1][2].member_1))), (_e974[3][1][2].member_1 - _e978[1][1][2].member_1)))));
                    }
                    let _e1337 = phi_1778_;
                    phi_1792_ = type_14(0i, 3i);
                    phi_1795_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                    phi_1797_ = _e1337[2];
                    phi_1799_ = _e1337[1];
                    phi_1801_ = _e1337[0];
                    loop {
                        let _e1342 = phi_1792_;
                        let _e1344 = phi_1795_;
                        let _e1346 = phi_1797_;
                        let _e1348 = phi_1799_;
                        let _e1350 = phi_1801_;
                        local_26 = _e1344;
                        local_27 = _e1344;
                        local_28 = _e1344;
                        local_29 = _e1344;
                        local_30 = _e1344;
                        local_31 = _e1344;
                        local_32 = _e1344;
                        local_33 = _e1344;
                        local_34 = _e1344;
                        local_35 = _e1344;
                        local_36 = _e1344;
                        local_37 = _e1344;
                        if (_e1342.member < _e1342.member_1) {
                            let _e1357 = (_e1342.member + 1i);
                            phi_1793_ = type_14(select(_e1357, type_15().member_1, select(false, true, ((false == (_e1357 > _e1342.member)) != false))), _e1342.member_1);
                            phi_1842_ = type_15(1u, _e1342.member);
                        } else {
                            phi_1793_ = _e1342;
                            phi_1842_ = type_15(0u, type_15().member_1);
                        }
                        let _e1368 = phi_1793_;
                        let _e1370 = phi_1842_;
                        let _e1373 = (bitcast<i32>(_e1370.member) != 0i);
                        if _e1373 {
                            let _e1392 = function_7(_e1348[0][1].member, _e1348[0][1].member_1, _e1346[0][2].member, _e1346[0][2].member_1);
                            let _e1395 = function_7(_e1348[0][2].member, _e1348[0][2].member_1, _e1346[0][1].member, _e1346[0][1].member_1);
                            let _e1401 = ((_e1392.member - _e1395.member) - select(0u, 1u, (_e1392.member_1 < _e1395.member_1)));
                            let _e1402 = (_e1392.member_1 - _e1395.member_1);
                            let _e1421 = function_7(_e1348[1][1].member, _e1348[1][1].member_1, _e1346[1][2].member, _e1346[1][2].member_1);
                            let _e1424 = function_7(_e1348[1][2].member, _e1348[1][2].member_1, _e1346[1][1].member, _e1346[1][1].member_1);
                            let _e1430 = ((_e1421.member - _e1424.member) - select(0u, 1u, (_e1421.member_1 < _e1424.member_1)));
                            let _e1431 = (_e1421.member_1 - _e1424.member_1);
                            let _e1450 = function_7(_e1348[0][1].member, _e1348[0][1].member_1, _e1346[1][2].member, _e1346[1][2].member_1);
                            let _e1453 = function_7(_e1348[0][2].member, _e1348[0][2].member_1, _e1346[1][1].member, _e1346[1][1].member_1);
                            let _e1460 = (_e1450.member_1 - _e1453.member_1);
                            let _e1479 = function_7(_e1348[1][1].member, _e1348[1][1].member_1, _e1346[0][2].member, _e1346[0][2].member_1);
                            let _e1482 = function_7(_e1348[1][2].member, _e1348[1][2].member_1, _e1346[0][1].member, _e1346[0][1].member_1);
                            let _e1490 = (_e1460 + (_e1479.member_1 - _e1482.member_1));
                            let _e1494 = ((((_e1450.member - _e1453.member) - select(0u, 1u, (_e1450.member_1 < _e1453.member_1))) + ((_e1479.member - _e1482.member) - select(0u, 1u, (_e1479.member_1 < _e1482.member_1)))) + select(0u, 1u, (_e1490 < _e1460)));
                            let _e1511 = function_7(_e1350[0][0].member, _e1350[0][0].member_1, _e1401, _e1402);
                            let _e1514 = (_e1344[0].member_1 + _e1511.member_1);
                            let _e1524 = function_7(_e1350[1][0].member, _e1350[1][0].member_1, _e1401, _e1402);
                            let _e1527 = (_e1344[1].member_1 + _e1524.member_1);
                            let _e1532 = function_7(_e1350[0][0].member, _e1350[0][0].member_1, _e1494, _e1490);
                            let _e1535 = (_e1527 + _e1532.member_1);
                            let _e1545 = function_7(_e1350[0][0].member, _e1350[0][0].member_1, _e1430, _e1431);
                            let _e1548 = (_e1344[2].member_1 + _e1545.member_1);
                            let _e1553 = function_7(_e1350[1][0].member, _e1350[1][0].member_1, _e1494, _e1490);
                            let _e1556 = (_e1548 + _e1553.member_1);
                            let _e1566 = function_7(_e1350[1][0].member, _e1350[1][0].member_1, _e1430, _e1431);
                            let _e1569 = (_e1344[3].member_1 + _e1566.member_1);
                            phi_1796_ = array<type_9, 4>(type_9(((_e1344[0].member + _e1511.member) + select(0u, 1u, (_e1514 < _e1344[0].member_1))), _e1514), type_9(((((_e1344[1].member + _e1524.member) + select(0u, 1u, (_e1527 < _e1344[1].member_1))) + _e1532.member) + select(0u, 1u, (_e1535 < _e1527))), _e1535), type_9(((((_e1344[2].member + _e1545.member) + select(0u, 1u, (_e1548 < _e1344[2].member_1))) + _e1553.member) + select(0u, 1u, (_e1556 < _e1548))), _e1556), type_9(((_e1344[3].member + _e1566.member) + select(0u, 1u, (_e1569 < _e1344[3].member_1))), _e1569));
                            phi_1798_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1346[0][1], _e1346[0][2], _e1346[0][0]), array<type_9, 3>(_e1346[1][1], _e1346[1][2], _e1346[1][0]));
                            phi_1800_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1348[0][1], _e1348[0][2], _e1348[0][0]), array<type_9, 3>(_e1348[1][1], _e1348[1][2], _e1348[1][0]));
                            phi_1802_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1350[0][1], _e1350[0][2], _e1350[0][0]), array<type_9, 3>(_e1350[1][1], _e1350[1][2], _e1350[1][0]));
                        } else {
                            phi_1796_ = array<type_9, 4>();
                            phi_1798_ = array<array<type_9, 3>, 2>();
                            phi_1800_ = array<array<type_9, 3>, 2>();
                            phi_1802_ = array<array<type_9, 3>, 2>();
                        }
                        let _e1610 = phi_1796_;
                        let _e1612 = phi_1798_;
                        let _e1614 = phi_1800_;
                        let _e1616 = phi_1802_;
                        continue;
                        continuing {
                            phi_1792_ = _e1368;
                            phi_1795_ = _e1610;
                            phi_1797_ = _e1612;
                            phi_1799_ = _e1614;
                            phi_1801_ = _e1616;
                            break if !(_e1373);
                        }
                    }
                    let _e1619 = local_26;
                    let _e1623 = local_27;
                    let _e1626 = function_6(_e1619[0].member, _e1623[0].member_1);
                    let _e1630 = local_28;
                    let _e1634 = local_29;
                    let _e1638 = local_30;
                    let _e1642 = local_31;
                    let _e1646 = local_32;
                    let _e1650 = local_33;
                    let _e1653 = function_6(_e1646[3].member, _e1650[3].member_1);
                    let _e1657 = local_34;
                    let _e1660 = local_35;
                    let _e1667 = select((bitcast<u32>(31i) - firstLeadingBit(_e714)), 32u, (_e714 == 0u));
                    let _e1669 = select(18u, _e1667, (18u < _e1667));
                    let _e1670 = function_1(128u);
                    let _e1675 = ((_e1626.member >> bitcast<u32>(31i)) != 0u);
                    let _e1698 = function_1(128u);
                    let _e1703 = ((_e1630[1].member >> bitcast<u32>(31i)) != 0u);
                    let _e1711 = local_36;
                    let _e1732 = function_1(128u);
                    let _e1737 = ((_e1638[2].member >> bitcast<u32>(31i)) != 0u);
                    let _e1745 = local_37;
                    let _e1766 = function_1(128u);
                    let _e1771 = ((_e1653.member >> bitcast<u32>(31i)) != 0u);
                    phi_2395_ = (((select(0u, select(1u, 2u, ((_e1626.member >> bitcast<u32>(31i)) != 0u)), ((((_e1670.member - select(_e1626.member, (~(_e1626.member) + select(0u, 1u, (_e1626.member_1 == 0u))), _e1675)) - select(0u, 1u, (_e1670.member_1 < select(_e1626.member_1, (~(_e1626.member_1) + 1u), _e1675)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e1630[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1698.member - select(_e1711[1].member, (~(_e1630[1].member) + select(0u, 1u, (_e1634[1].member_1 == 0u))), _e1703)) - select(0u, 1u, (_e1698.member_1 < select(_e1711[1].member_1, (~(_e1634[1].member_1) + 1u), _e1703)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1638[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1732.member - select(_e1745[2].member, (~(_e1638[2].member) + select(0u, 1u, (_e1642[2].member_1 == 0u))), _e1737)) - select(0u, 1u, (_e1732.member_1 < select(_e1745[2].member_1, (~(_e1642[2].member_1) + 1u), _e1737)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e1653.member >> bitcast<u32>(31i)) != 0u)), ((((_e1766.member - select(_e1653.member, (~(_e1653.member) + select(0u, 1u, (_e1653.member_1 == 0u))), _e1771)) - select(0u, 1u, (_e1766.member_1 < select(_e1653.member_1, (~(_e1653.member_1) + 1u), _e1771)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                    phi_2398_ = array<type_9, 4>(_e1626, _e1657[1], _e1660[2], _e1653);
                    phi_2400_ = false;
                    phi_2402_ = false;
                    phi_2404_ = false;
                    phi_2406_ = false;
                    phi_2408_ = type_17(0u, 0u, 0u);
                    phi_2410_ = 0u;
                    phi_2412_ = 0u;
                    phi_2414_ = 0u;
                    phi_2416_ = 0u;
                    phi_2418_ = 0u;
                    loop {
                        let _e1798 = phi_2395_;
                        let _e1800 = phi_2398_;
                        let _e1802 = phi_2400_;
                        let _e1804 = phi_2402_;
                        let _e1806 = phi_2404_;
                        let _e1808 = phi_2406_;
                        let _e1810 = phi_2408_;
                        let _e1812 = phi_2410_;
                        let _e1814 = phi_2412_;
                        let _e1816 = phi_2414_;
                        let _e1818 = phi_2416_;
                        let _e1820 = phi_2418_;
                        if (_e1816 < 64u) {
                            phi_2427_ = _e1798;
                            phi_2430_ = _e1800;
                            phi_2432_ = _e1806;
                            phi_2434_ = _e1808;
                            phi_2436_ = _e1802;
                            phi_2438_ = false;
                            phi_2440_ = false;
                            phi_2442_ = false;
                            phi_2444_ = _e1812;
                            phi_2446_ = _e1814;
                            phi_2448_ = _e1816;
                            phi_2450_ = _e1818;
                            phi_2452_ = _e1820;
                            loop {
                                let _e1823 = phi_2427_;
                                let _e1825 = phi_2430_;
                                let _e1827 = phi_2432_;
                                let _e1829 = phi_2434_;
                                let _e1831 = phi_2436_;
                                let _e1833 = phi_2438_;
                                let _e1835 = phi_2440_;
                                let _e1837 = phi_2442_;
                                let _e1839 = phi_2444_;
                                let _e1841 = phi_2446_;
                                let _e1843 = phi_2448_;
                                let _e1845 = phi_2450_;
                                let _e1847 = phi_2452_;
                                local_38 = _e1831;
                                local_39 = _e1837;
                                local_40 = _e1845;
                                local_41 = _e1823;
                                local_42 = _e1841;
                                local_43 = _e1839;
                                local_44 = _e1845;
                                local_45 = _e1823;
                                local_46 = _e1823;
                                local_47 = _e1845;
                                local_48 = _e1835;
                                local_49 = _e1833;
                                local_50 = _e1845;
                                local_51 = _e1823;
                                local_52 = _e1833;
                                local_53 = _e1833;
                                local_54 = _e1833;
                                local_55 = _e1833;
                                local_56 = _e1841;
                                local_57 = _e1841;
                                local_58 = _e1841;
                                local_59 = _e1839;
                                local_60 = _e1825;
                                local_61 = _e1825;
                                local_62 = _e1825;
                                local_63 = _e1825;
                                local_64 = _e1825;
                                local_65 = _e1825;
                                local_66 = _e1825;
                                local_67 = _e1825;
                                local_70 = _e1841;
                                local_71 = _e1841;
                                local_72 = _e1823;
                                local_74 = _e1833;
                                local_108 = _e1837;
                                local_109 = _e1827;
                                local_110 = _e1829;
                                local_111 = _e1837;
                                local_112 = _e1827;
                                local_113 = _e1829;
                                local_114 = _e1837;
                                local_75 = _e1847;
                                local_76 = _e1847;
                                local_77 = _e1845;
                                local_78 = _e1845;
                                local_79 = _e1845;
                                local_80 = _e1841;
                                local_115 = _e1845;
                                local_116 = _e1847;
                                local_117 = _e1823;
                                local_119 = _e1825;
                                local_120 = _e1839;
                                local_121 = _e1841;
                                local_122 = _e1843;
                                if (_e1843 < 64u) {
                                    if _e1837 {
                                        phi_3131_ = u32();
                                        phi_3132_ = array<type_9, 4>();
                                        phi_3133_ = bool();
                                        phi_3134_ = bool();
                                        phi_3135_ = bool();
                                        phi_3136_ = bool();
                                        phi_3137_ = bool();
                                        phi_3138_ = bool();
                                        phi_3139_ = u32();
                                        phi_3140_ = u32();
                                        phi_3141_ = u32();
                                        phi_3142_ = u32();
                                        phi_3143_ = u32();
                                        phi_3144_ = false;
                                    } else {
                                        if _e1831 {
                                            phi_3117_ = u32();
                                            phi_3118_ = array<type_9, 4>();
                                            phi_3119_ = bool();
                                            phi_3120_ = bool();
                                            phi_3121_ = bool();
                                            phi_3122_ = bool();
                                            phi_3123_ = bool();
                                            phi_3124_ = bool();
                                            phi_3125_ = u32();
                                            phi_3126_ = u32();
                                            phi_3127_ = u32();
                                            phi_3128_ = u32();
                                            phi_3129_ = u32();
                                            phi_3130_ = false;
                                        } else {
                                            let _e1850 = (31u - _e1845);
                                            let _e1853 = (_e1847 << bitcast<u32>((_e1850 & 31u)));
                                            let _e1857 = ((_e1847 + 1u) << bitcast<u32>((_e1850 & 31u)));
                                            let _e1858 = (_e1853 > _e712);
                                            let _e1859 = (_e1857 < _e710);
                                            let _e1866 = select(select(select(select((_e1823 == 170u), true, (_e1823 == 85u)), bool(), _e1859), bool(), _e1858), true, select(_e1859, true, _e1858));
                                            let _e1870 = select((_e1823 ^ 255u), _e1823, ((_e1823 & 3u) == 1u));
                                            let _e1871 = (_e1870 == 149u);
                                            let _e1872 = (_e1870 == 165u);
                                            let _e1877 = select(select(select((_e1870 == 169u), bool(), _e1872), bool(), _e1871), true, select(_e1872, true, _e1871));
                                            let _e1881 = select(false, (_e1853 >= _e710), ((_e1823 & 3u) == 0u));
                                            let _e1882 = (_e1845 == 3u);
                                            let _e1883 = (_e1845 == 8u);
                                            let _e1888 = select(select(select((_e1845 == 14u), bool(), _e1883), bool(), _e1882), true, select(_e1883, true, _e1882));
                                            let _e1890 = select(false, !(_e1827), _e1881);
                                            let _e1891 = (_e1845 == 31u);
                                            let _e1902 = select(select(false, !(_e1829), select(select(select(select(select(false, !(_e1804), _e1877), bool(), _e1881), bool(), _e1888), bool(), _e1891), true, select(select(_e1881, true, _e1888), true, _e1891))), true, _e1890);
                                            if _e1866 {
                                                phi_3111_ = _e1823;
                                                phi_3112_ = _e1825;
                                                phi_3113_ = _e1827;
                                                phi_3114_ = _e1829;
                                                phi_3115_ = _e1845;
                                                phi_3116_ = _e1847;
                                            } else {
                                                if _e1902 {
                                                    phi_3105_ = _e1823;
                                                    phi_3106_ = _e1825;
                                                    phi_3107_ = _e1827;
                                                    phi_3108_ = _e1829;
                                                    phi_3109_ = _e1845;
                                                    phi_3110_ = _e1847;
                                                } else {
                                                    let _e1911 = (_e1825[0].member_1 + _e1825[1].member_1);
                                                    let _e1915 = ((_e1825[0].member + _e1825[1].member) + select(0u, 1u, (_e1911 < _e1825[0].member_1)));
                                                    let _e1923 = bitcast<u32>((bitcast<i32>(_e1915) >> bitcast<u32>(1u)));
                                                    let _e1926 = ((_e1911 >> bitcast<u32>(1u)) | ((_e1915 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1935 = (_e1825[1].member_1 + _e1825[2].member_1);
                                                    let _e1939 = ((_e1825[1].member + _e1825[2].member) + select(0u, 1u, (_e1935 < _e1825[1].member_1)));
                                                    let _e1947 = bitcast<u32>((bitcast<i32>(_e1939) >> bitcast<u32>(1u)));
                                                    let _e1950 = ((_e1935 >> bitcast<u32>(1u)) | ((_e1939 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1959 = (_e1825[2].member_1 + _e1825[3].member_1);
                                                    let _e1963 = ((_e1825[2].member + _e1825[3].member) + select(0u, 1u, (_e1959 < _e1825[2].member_1)));
                                                    let _e1971 = bitcast<u32>((bitcast<i32>(_e1963) >> bitcast<u32>(1u)));
                                                    let _e1974 = ((_e1959 >> bitcast<u32>(1u)) | ((_e1963 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1975 = (_e1926 + _e1950);
                                                    let _e1979 = ((_e1923 + _e1947) + select(0u, 1u, (_e1975 < _e1926)));
                                                    let _e1987 = bitcast<u32>((bitcast<i32>(_e1979) >> bitcast<u32>(1u)));
                                                    let _e1990 = ((_e1975 >> bitcast<u32>(1u)) | ((_e1979 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1991 = (_e1950 + _e1974);
                                                    let _e1995 = ((_e1947 + _e1971) + select(0u, 1u, (_e1991 < _e1950)));
                                                    let _e2003 = bitcast<u32>((bitcast<i32>(_e1995) >> bitcast<u32>(1u)));
                                                    let _e2006 = ((_e1991 >> bitcast<u32>(1u)) | ((_e1995 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2007 = (_e1990 + _e2006);
                                                    let _e2011 = ((_e1987 + _e2003) + select(0u, 1u, (_e2007 < _e1990)));
                                                    let _e2019 = bitcast<u32>((bitcast<i32>(_e2011) >> bitcast<u32>(1u)));
                                                    let _e2022 = ((_e2007 >> bitcast<u32>(1u)) | ((_e2011 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2023 = (2u * _e1847);
                                                    let _e2038 = function_1(128u);
                                                    let _e2043 = ((_e1825[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2067 = function_1(128u);
                                                    let _e2072 = ((_e1923 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2096 = function_1(128u);
                                                    let _e2101 = ((_e1987 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2125 = function_1(128u);
                                                    let _e2130 = ((_e2019 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2153 = (((select(0u, select(1u, 2u, ((_e1825[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2038.member - select(_e1825[0].member, (~(_e1825[0].member) + select(0u, 1u, (_e1825[0].member_1 == 0u))), _e2043)) - select(0u, 1u, (_e2038.member_1 < select(_e1825[0].member_1, (~(_e1825[0].member_1) + 1u), _e2043)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e1923 >> bitcast<u32>(31i)) != 0u)), ((((_e2067.member - select(_e1923, (~(_e1923) + select(0u, 1u, (_e1926 == 0u))), _e2072)) - select(0u, 1u, (_e2067.member_1 < select(_e1926, (~(_e1926) + 1u), _e2072)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1987 >> bitcast<u32>(31i)) != 0u)), ((((_e2096.member - select(_e1987, (~(_e1987) + select(0u, 1u, (_e1990 == 0u))), _e2101)) - select(0u, 1u, (_e2096.member_1 < select(_e1990, (~(_e1990) + 1u), _e2101)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e2019 >> bitcast<u32>(31i)) != 0u)), ((((_e2125.member - select(_e2019, (~(_e2019) + select(0u, 1u, (_e2022 == 0u))), _e2130)) - select(0u, 1u, (_e2125.member_1 < select(_e2022, (~(_e2022) + 1u), _e2130)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                                    if select((_e2153 == 170u), true, (_e2153 == 85u)) {
                                                        let _e2163 = function_1(128u);
                                                        let _e2168 = ((_e2019 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2189 = function_1(128u);
                                                        let _e2194 = ((_e2003 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2218 = function_1(128u);
                                                        let _e2223 = ((_e1971 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2247 = function_1(128u);
                                                        let _e2252 = ((_e1825[3].member >> bitcast<u32>(31i)) != 0u);
                                                        phi_3101_ = (((select(0u, select(1u, 2u, ((_e2019 >> bitcast<u32>(31i)) != 0u)), ((((_e2163.member - select(_e2019, (~(_e2019) + select(0u, 1u, (_e2022 == 0u))), _e2168)) - select(0u, 1u, (_e2163.member_1 < select(_e2022, (~(_e2022) + 1u), _e2168)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e2003 >> bitcast<u32>(31i)) != 0u)), ((((_e2189.member - select(_e2003, (~(_e2003) + select(0u, 1u, (_e2006 == 0u))), _e2194)) - select(0u, 1u, (_e2189.member_1 < select(_e2006, (~(_e2006) + 1u), _e2194)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1971 >> bitcast<u32>(31i)) != 0u)), ((((_e2218.member - select(_e1971, (~(_e1971) + select(0u, 1u, (_e1974 == 0u))), _e2223)) - select(0u, 1u, (_e2218.member_1 < select(_e1974, (~(_e1974) + 1u), _e2223)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e1825[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2247.member - select(_e1825[3].member, (~(_e1825[3].member) + select(0u, 1u, (_e1825[3].member_1 == 0u))), _e2252)) - select(0u, 1u, (_e2247.member_1 < select(_e1825[3].member_1, (~(_e1825[3].member_1) + 1u), _e2252)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                                        phi_3102_ = array<type_9, 4>(type_9(_e2019, _e2022), type_9(_e2003, _e2006), type_9(_e1971, _e1974), _e1825[3]);
                                                        phi_3103_ = false;
                                                        phi_3104_ = (_e2023 + 1u);
                                                    } else {
                                                        phi_3101_ = _e2153;
                                                        phi_3102_ = array<type_9, 4>(_e1825[0], type_9(_e1923, _e1926), type_9(_e1987, _e1990), type_9(_e2019, _e2022));
                                                        phi_3103_ = _e1827;
                                                        phi_3104_ = _e2023;
                                                    }
                                                    let _e2280 = phi_3101_;
                                                    let _e2282 = phi_3102_;
                                                    let _e2284 = phi_3103_;
                                                    let _e2286 = phi_3104_;
                                                    phi_3105_ = _e2280;
                                                    phi_3106_ = _e2282;
                                                    phi_3107_ = _e2284;
                                                    phi_3108_ = false;
                                                    phi_3109_ = (_e1845 + 1u);
                                                    phi_3110_ = _e2286;
                                                }
                                                let _e2288 = phi_3105_;
                                                let _e2290 = phi_3106_;
                                                let _e2292 = phi_3107_;
                                                let _e2294 = phi_3108_;
                                                let _e2296 = phi_3109_;
                                                let _e2298 = phi_3110_;
                                                phi_3111_ = _e2288;
                                                phi_3112_ = _e2290;
                                                phi_3113_ = _e2292;
                                                phi_3114_ = _e2294;
                                                phi_3115_ = _e2296;
                                                phi_3116_ = _e2298;
                                            }
                                            let _e2300 = phi_3111_;
                                            let _e2302 = phi_3112_;
                                            let _e2304 = phi_3113_;
                                            let _e2306 = phi_3114_;
                                            let _e2308 = phi_3115_;
                                            let _e2310 = phi_3116_;
                                            phi_3117_ = _e2300;
                                            phi_3118_ = _e2302;
                                            phi_3119_ = _e2304;
                                            phi_3120_ = _e2306;
                                            phi_3121_ = _e1902;
                                            phi_3122_ = _e1890;
                                            phi_3123_ = _e1877;
                                            phi_3124_ = _e1866;
                                            phi_3125_ = _e1857;
                                            phi_3126_ = _e1853;
                                            phi_3127_ = (_e1843 + 1u);
                                            phi_3128_ = _e2308;
                                            phi_3129_ = _e2310;
                                            phi_3130_ = true;
                                        }
                                        let _e2312 = phi_3117_;
                                        let _e2314 = phi_3118_;
                                        let _e2316 = phi_3119_;
                                        let _e2318 = phi_3120_;
                                        let _e2320 = phi_3121_;
                                        let _e2322 = phi_3122_;
                                        let _e2324 = phi_3123_;
                                        let _e2326 = phi_3124_;
                                        let _e2328 = phi_3125_;
                                        let _e2330 = phi_3126_;
                                        let _e2332 = phi_3127_;
                                        let _e2334 = phi_3128_;
                                        let _e2336 = phi_3129_;
                                        let _e2338 = phi_3130_;
                                        phi_3131_ = _e2312;
                                        phi_3132_ = _e2314;
                                        phi_3133_ = _e2316;
                                        phi_3134_ = _e2318;
                                        phi_3135_ = _e2320;
                                        phi_3136_ = _e2322;
                                        phi_3137_ = _e2324;
                                        phi_3138_ = _e2326;
                                        phi_3139_ = _e2328;
                                        phi_3140_ = _e2330;
                                        phi_3141_ = _e2332;
                                        phi_3142_ = _e2334;
                                        phi_3143_ = _e2336;
                                        phi_3144_ = _e2338;
                                    }
                                    let _e2340 = phi_3131_;
                                    let _e2342 = phi_3132_;
                                    let _e2344 = phi_3133_;
                                    let _e2346 = phi_3134_;
                                    let _e2348 = phi_3135_;
                                    let _e2350 = phi_3136_;
                                    let _e2352 = phi_3137_;
                                    let _e2354 = phi_3138_;
                                    let _e2356 = phi_3139_;
                                    let _e2358 = phi_3140_;
                                    let _e2360 = phi_3141_;
                                    let _e2362 = phi_3142_;
                                    let _e2364 = phi_3143_;
                                    let _e2366 = phi_3144_;
                                    phi_2428_ = _e2340;
                                    phi_2431_ = _e2342;
                                    phi_2433_ = _e2344;
                                    phi_2435_ = _e2346;
                                    phi_2437_ = _e2348;
                                    phi_2439_ = _e2350;
                                    phi_2441_ = _e2352;
                                    phi_2443_ = _e2354;
                                    phi_2445_ = _e2356;
                                    phi_2447_ = _e2358;
                                    phi_2449_ = _e2360;
                                    phi_2451_ = _e2362;
                                    phi_2453_ = _e2364;
                                    phi_3145_ = _e2366;
                                } else {
                                    phi_2428_ = u32();
                                    phi_2431_ = array<type_9, 4>();
                                    phi_2433_ = bool();
                                    phi_2435_ = bool();
                                    phi_2437_ = bool();
                                    phi_2439_ = bool();
                                    phi_2441_ = bool();
                                    phi_2443_ = bool();
                                    phi_2445_ = u32();
                                    phi_2447_ = u32();
                                    phi_2449_ = u32();
                                    phi_2451_ = u32();
                                    phi_2453_ = u32();
                                    phi_3145_ = false;
                                }
                                let _e2368 = phi_2428_;
                                let _e2370 = phi_2431_;
                                let _e2372 = phi_2433_;
                                let _e2374 = phi_2435_;
                                let _e2376 = phi_2437_;
                                let _e2378 = phi_2439_;
                                let _e2380 = phi_2441_;
                                let _e2382 = phi_2443_;
                                let _e2384 = phi_2445_;
                                let _e2386 = phi_2447_;
                                let _e2388 = phi_2449_;
                                let _e2390 = phi_2451_;
                                let _e2392 = phi_2453_;
                                let _e2394 = phi_3145_;
                                continue;
                                continuing {
                                    phi_2427_ = _e2368;
                                    phi_2430_ = _e2370;
                                    phi_2432_ = _e2372;
                                    phi_2434_ = _e2374;
                                    phi_2436_ = _e2376;
                                    phi_2438_ = _e2378;
                                    phi_2440_ = _e2380;
                                    phi_2442_ = _e2382;
                                    phi_2444_ = _e2384;
                                    phi_2446_ = _e2386;
                                    phi_2448_ = _e2388;
                                    phi_2450_ = _e2390;
                                    phi_2452_ = _e2392;
                                    break if !(_e2394);
                                }
                            }
                            let _e2397 = local_38;
                            if _e2397 {
                                let _e2399 = local_39;
                                if _e2399 {
                                    phi_5081_ = _e1802;
                                    phi_5082_ = _e1804;
                                    let _e4857 = local_109;
                                    phi_5083_ = _e4857;
                                    let _e4860 = local_110;
                                    phi_5084_ = _e4860;
                                    phi_5085_ = _e1810;
                                    let _e4864 = local_111;
                                    phi_5086_ = _e4864;
                                    phi_5087_ = bool();
                                    phi_5088_ = type_17();
                                    phi_5089_ = true;
                                    phi_5090_ = false;
                                    phi_5091_ = false;
                                    phi_5092_ = false;
                                } else {
                                    let _e2401 = local_40;
                                    let _e2402 = (_e2401 == 31u);
                                    let _e2404 = local_41;
                                    let _e2411 = local_42;
                                    let _e2413 = local_43;
                                    let _e2415 = local_44;
                                    let _e2416 = type_17(_e2411, _e2413, _e2415);
                                    let _e2418 = local_45;
                                    let _e2421 = local_46;
                                    let _e2425 = (((_e2418 & 3u) | (_e2421 >> bitcast<u32>(6i))) == 3u);
                                    let _e2427 = local_47;
                                    let _e2430 = local_48;
                                    let _e2434 = local_49;
                                    let _e2435 = select(select(select(false, (_e2427 < _e1669), _e2430), true, _e1802), false, _e2434);
                                    let _e2437 = local_50;
                                    let _e2438 = (_e2437 == 31u);
                                    let _e2440 = local_51;
                                    let _e2449 = local_52;
                                    let _e2452 = local_53;
                                    let _e2454 = select(select(select(select(bool(), select(((_e2440 & 3u) != 0u), bool(), _e2425), _e2438), bool(), _e2435), bool(), _e2449), false, select(select(select(true, _e2425, _e2438), true, _e2435), true, _e2452));
                                    let _e2456 = local_54;
                                    let _e2459 = local_55;
                                    if _e2459 {
                                        let _e2637 = local_70;
                                        let _e2640 = local_71;
                                        phi_3406_ = _e1804;
                                        phi_3407_ = type_17(_e2640, (_e2637 + 1u), 31u);
                                        phi_3408_ = _e1810;
                                    } else {
                                        if _e2435 {
                                            let _e2477 = select(_e1669, 31u, _e1802);
                                            let _e2480 = local_58;
                                            let _e2481 = select(_e2480, _e1810.member, _e1802);
                                            let _e2484 = local_59;
                                            let _e2485 = select(_e2484, _e1810.member_1, _e1802);
                                            let _e2487 = local_60;
                                            let _e2491 = local_61;
                                            let _e2498 = ((f32(bitcast<i32>(_e2487[0].member)) * 4294967300f) + f32(_e2491[0].member_1));
                                            let _e2500 = local_62;
                                            let _e2504 = local_63;
                                            let _e2511 = ((f32(bitcast<i32>(_e2500[1].member)) * 4294967300f) + f32(_e2504[1].member_1));
                                            let _e2513 = local_64;
                                            let _e2517 = local_65;
                                            let _e2524 = ((f32(bitcast<i32>(_e2513[2].member)) * 4294967300f) + f32(_e2517[2].member_1));
                                            let _e2526 = local_66;
                                            let _e2530 = local_67;
                                            let _e2537 = ((f32(bitcast<i32>(_e2526[3].member)) * 4294967300f) + f32(_e2530[3].member_1));
                                            phi_3257_ = type_14(0i, 6i);
                                            phi_3260_ = 1f;
                                            phi_3262_ = 0f;
                                            phi_3264_ = (_e2498 / (_e2498 - _e2537));
                                            loop {
                                                let _e2541 = phi_3257_;
                                                let _e2543 = phi_3260_;
                                                let _e2545 = phi_3262_;
                                                let _e2547 = phi_3264_;
                                                local_68 = _e2547;
                                                local_69 = _e2547;
                                                if (_e2541.member < _e2541.member_1) {
                                                    let _e2554 = (_e2541.member + 1i);
                                                    phi_3258_ = type_14(select(_e2554, type_15().member_1, select(false, true, ((false == (_e2554 > _e2541.member)) != false))), _e2541.member_1);
                                                    phi_3305_ = type_15(1u, _e2541.member);
                                                } else {
                                                    phi_3258_ = _e2541;
                                                    phi_3305_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e2565 = phi_3258_;
                                                let _e2567 = phi_3305_;
                                                let _e2570 = (bitcast<i32>(_e2567.member) != 0i);
                                                if _e2570 {
                                                    let _e2571 = function_5(_e2498, _e2511, _e2547);
                                                    let _e2572 = function_5(_e2511, _e2524, _e2547);
                                                    let _e2573 = function_5(_e2524, _e2537, _e2547);
                                                    let _e2574 = function_5(_e2571, _e2572, _e2547);
                                                    let _e2575 = function_5(_e2572, _e2573, _e2547);
                                                    let _e2576 = function_5(_e2574, _e2575, _e2547);
                                                    let _e2579 = ((_e2576 < 0f) == (_e2498 < 0f));
                                                    let _e2580 = select(_e2547, _e2543, _e2579);
                                                    let _e2581 = select(_e2545, _e2547, _e2579);
                                                    let _e2585 = (_e2547 - (_e2576 / (3f * (_e2575 - _e2574))));
                                                    phi_3261_ = _e2580;
                                                    phi_3263_ = _e2581;
                                                    phi_3265_ = select(_e2585, (0.5f * (_e2581 + _e2580)), select(true, select(true, false, (_e2585 <= _e2580)), (_e2585 >= _e2581)));
                                                } else {
                                                    phi_3261_ = f32();
                                                    phi_3263_ = f32();
                                                    phi_3265_ = f32();
                                                }
                                                let _e2594 = phi_3261_;
                                                let _e2596 = phi_3263_;
                                                let _e2598 = phi_3265_;
                                                continue;
                                                continuing {
                                                    phi_3257_ = _e2565;
                                                    phi_3260_ = _e2594;
                                                    phi_3262_ = _e2596;
                                                    phi_3264_ = _e2598;
                                                    break if !(_e2570);
                                                }
                                            }
                                            let _e2603 = (1u << bitcast<u32>(((31u - _e2477) & 31u)));
                                            let _e2604 = (_e2485 - _e2481);
                                            let _e2606 = local_68;
                                            let _e2610 = local_69;
                                            let _e2613 = (select(0.5f, _e2610, (bitcast<u32>(_e2606) <= 1065353216u)) * f32(_e2604));
                                            let _e2618 = select(select(u32(_e2613), 0u, (_e2613 < 0f)), 4294967295u, (_e2613 > 4294967000f));
                                            let _e2620 = select(_e2618, _e2604, (_e2604 < _e2618));
                                            let _e2622 = (_e2603 / 2u);
                                            let _e2625 = ((_e2481 + _e2620) - select(_e2622, _e2620, (_e2620 < _e2622)));
                                            let _e2626 = (_e2625 + _e2603);
                                            phi_3403_ = true;
                                            phi_3404_ = _e2416;
                                            phi_3405_ = type_17(_e2625, select(_e2626, _e2485, (_e2485 < _e2626)), _e2477);
                                        } else {
                                            if _e2454 {
                                                let _e2464 = select((bitcast<u32>(31i) - firstLeadingBit(_e714)), 32u, (_e714 == 0u));
                                                let _e2470 = local_56;
                                                let _e2473 = local_57;
                                                phi_3402_ = type_17(_e2473, (_e2470 + (1u << bitcast<u32>(((31u - _e2464) & 31u)))), _e2464);
                                            } else {
                                                phi_3402_ = _e2416;
                                            }
                                            let _e2476 = phi_3402_;
                                            phi_3403_ = _e1804;
                                            phi_3404_ = _e2476;
                                            phi_3405_ = _e1810;
                                        }
                                        let _e2631 = phi_3403_;
                                        let _e2633 = phi_3404_;
                                        let _e2635 = phi_3405_;
                                        phi_3406_ = _e2631;
                                        phi_3407_ = _e2633;
                                        phi_3408_ = _e2635;
                                    }
                                    let _e2643 = phi_3406_;
                                    let _e2645 = phi_3407_;
                                    let _e2647 = phi_3408_;
                                    if select(select(false, (_e2645.member_1 <= 2147483648u), _e2454), true, _e2435) {
                                        let _e2657 = local_72;
                                        phi_3438_ = type_14(0i, 2i);
                                        phi_3441_ = select((_e2657 & 3u), 0u, _e2435);
                                        phi_3443_ = select(_e2645.member_1, _e2647.member, _e2435);
                                        loop {
                                            let _e2663 = phi_3438_;
                                            let _e2665 = phi_3441_;
                                            let _e2667 = phi_3443_;
                                            local_73 = _e2665;
                                            if (_e2663.member < _e2663.member_1) {
                                                let _e2674 = (_e2663.member + 1i);
                                                phi_3439_ = type_14(select(_e2674, type_15().member_1, select(false, true, ((false == (_e2674 > _e2663.member)) != false))), _e2663.member_1);
                                                phi_3483_ = type_15(1u, _e2663.member);
                                            } else {
                                                phi_3439_ = _e2663;
                                                phi_3483_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e2685 = phi_3439_;
                                            let _e2687 = phi_3483_;
                                            let _e2690 = (bitcast<i32>(_e2687.member) != 0i);
                                            if _e2690 {
                                                let _e2696 = function_4(((_e1630[1].member - _e1626.member) - select(0u, 1u, (_e1634[1].member_1 < _e1626.member_1))), (_e1634[1].member_1 - _e1626.member_1), _e2667);
                                                let _e2699 = (_e1626.member_1 + _e2696.member_1);
                                                let _e2703 = ((_e1626.member + _e2696.member) + select(0u, 1u, (_e2699 < _e1626.member_1)));
                                                let _e2709 = function_4(((_e1638[2].member - _e1630[1].member) - select(0u, 1u, (_e1642[2].member_1 < _e1634[1].member_1))), (_e1642[2].member_1 - _e1634[1].member_1), _e2667);
                                                let _e2712 = (_e1634[1].member_1 + _e2709.member_1);
                                                let _e2716 = ((_e1630[1].member + _e2709.member) + select(0u, 1u, (_e2712 < _e1634[1].member_1)));
                                                let _e2722 = function_4(((_e1653.member - _e1638[2].member) - select(0u, 1u, (_e1653.member_1 < _e1642[2].member_1))), (_e1653.member_1 - _e1642[2].member_1), _e2667);
                                                let _e2725 = (_e1642[2].member_1 + _e2722.member_1);
                                                let _e2735 = function_4(((_e2716 - _e2703) - select(0u, 1u, (_e2712 < _e2699))), (_e2712 - _e2699), _e2667);
                                                let _e2738 = (_e2699 + _e2735.member_1);
                                                let _e2742 = ((_e2703 + _e2735.member) + select(0u, 1u, (_e2738 < _e2699)));
                                                let _e2748 = function_4(((((_e1638[2].member + _e2722.member) + select(0u, 1u, (_e2725 < _e1642[2].member_1))) - _e2716) - select(0u, 1u, (_e2725 < _e2712))), (_e2725 - _e2712), _e2667);
                                                let _e2751 = (_e2712 + _e2748.member_1);
                                                let _e2761 = function_4(((((_e2716 + _e2748.member) + select(0u, 1u, (_e2751 < _e2712))) - _e2742) - select(0u, 1u, (_e2751 < _e2738))), (_e2751 - _e2738), _e2667);
                                                let _e2764 = (_e2738 + _e2761.member_1);
                                                let _e2768 = ((_e2742 + _e2761.member) + select(0u, 1u, (_e2764 < _e2738)));
                                                let _e2769 = function_1(128u);
                                                let _e2774 = ((_e2768 >> bitcast<u32>(31i)) != 0u);
                                                phi_3442_ = (_e2665 | select(0u, select(1u, 2u, ((_e2768 >> bitcast<u32>(31i)) != 0u)), ((((_e2769.member - select(_e2768, (~(_e2768) + select(0u, 1u, (_e2764 == 0u))), _e2774)) - select(0u, 1u, (_e2769.member_1 < select(_e2764, (~(_e2764) + 1u), _e2774)))) >> bitcast<u32>(31i)) != 0u)));
                                            } else {
                                                phi_3442_ = u32();
                                            }
                                            let _e2797 = phi_3442_;
                                            continue;
                                            continuing {
                                                phi_3438_ = _e2685;
                                                phi_3441_ = _e2797;
                                                phi_3443_ = select(_e2645.member_1, _e2647.member_1, _e2435);
                                                break if !(_e2690);
                                            }
                                        }
                                        let _e2800 = local_73;
                                        phi_3659_ = (_e2800 == 3u);
                                    } else {
                                        phi_3659_ = _e2425;
                                    }
                                    let _e2803 = phi_3659_;
                                    if _e2435 {
                                        phi_3667_ = _e2803;
                                        phi_3668_ = type_17(select(_e2645.member, _e2647.member, _e2803), select(_e2645.member_1, _e2647.member_1, _e2803), select(_e2645.member_2, _e2647.member_2, _e2803));
                                    } else {
                                        phi_3667_ = _e1802;
                                        phi_3668_ = _e2645;
                                    }
                                    let _e2815 = phi_3667_;
                                    let _e2817 = phi_3668_;
                                    let _e2821 = (f32(_e2817.member) / 2147483600f);
                                    let _e2842 = ((f32(bitcast<i32>(_e1337[1][0][0].member)) * 4294967300f) + f32(_e1337[1][0][0].member_1));
                                    let _e2850 = (_e2842 + ((((f32(bitcast<i32>(_e1337[1][1][0].member)) * 4294967300f) + f32(_e1337[1][1][0].member_1)) - _e2842) * _e2821));
                                    let _e2871 = ((f32(bitcast<i32>(_e1337[1][0][1].member)) * 4294967300f) + f32(_e1337[1][0][1].member_1));
                                    let _e2879 = (_e2871 + ((((f32(bitcast<i32>(_e1337[1][1][1].member)) * 4294967300f) + f32(_e1337[1][1][1].member_1)) - _e2871) * _e2821));
                                    let _e2900 = ((f32(bitcast<i32>(_e1337[1][0][2].member)) * 4294967300f) + f32(_e1337[1][0][2].member_1));
                                    let _e2908 = (_e2900 + ((((f32(bitcast<i32>(_e1337[1][1][2].member)) * 4294967300f) + f32(_e1337[1][1][2].member_1)) - _e2900) * _e2821));
                                    let _e2929 = ((f32(bitcast<i32>(_e1337[2][0][0].member)) * 4294967300f) + f32(_e1337[2][0][0].member_1));
                                    let _e2937 = (_e2929 + ((((f32(bitcast<i32>(_e1337[2][1][0].member)) * 4294967300f) + f32(_e1337[2][1][0].member_1)) - _e2929) * _e2821));
                                    let _e2958 = ((f32(bitcast<i32>(_e1337[2][0][1].member)) * 4294967300f) + f32(_e1337[2][0][1].member_1));
                                    let _e2966 = (_e2958 + ((((f32(bitcast<i32>(_e1337[2][1][1].member)) * 4294967300f) + f32(_e1337[2][1][1].member_1)) - _e2958) * _e2821));
                                    let _e2987 = ((f32(bitcast<i32>(_e1337[2][0][2].member)) * 4294967300f) + f32(_e1337[2][0][2].member_1));
                                    let _e2995 = (_e2987 + ((((f32(bitcast<i32>(_e1337[2][1][2].member)) * 4294967300f) + f32(_e1337[2][1][2].member_1)) - _e2987) * _e2821));
                                    let _e3005 = abs(((_e2879 * _e2995) - (_e2908 * _e2966)));
                                    let _e3006 = abs(((_e2908 * _e2937) - (_e2850 * _e2995)));
                                    let _e3007 = abs(((_e2850 * _e2966) - (_e2879 * _e2937)));
                                    let _e3014 = select(0u, select(2u, 1u, (_e3006 > _e3007)), select(true, select(true, false, (_e3005 > _e3007)), (_e3005 > _e3006)));
                                    if (_e3014 == 0u) {
                                        phi_3892_ = array<type_9, 2>(_e1337[0][0][1], _e1337[0][0][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_3891_ = array<type_9, 2>(_e1337[0][0][2], _e1337[0][0][0]);
                                        } else {
                                            phi_3891_ = array<type_9, 2>(_e1337[0][0][0], _e1337[0][0][1]);
                                        }
                                        let _e3028 = phi_3891_;
                                        phi_3892_ = _e3028;
                                    }
                                    let _e3033 = phi_3892_;
                                    if (_e3014 == 0u) {
                                        phi_3927_ = array<type_9, 2>(_e1337[0][1][1], _e1337[0][1][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_3926_ = array<type_9, 2>(_e1337[0][1][2], _e1337[0][1][0]);
                                        } else {
                                            phi_3926_ = array<type_9, 2>(_e1337[0][1][0], _e1337[0][1][1]);
                                        }
                                        let _e3044 = phi_3926_;
                                        phi_3927_ = _e3044;
                                    }
                                    let _e3049 = phi_3927_;
                                    if (_e3014 == 0u) {
                                        phi_3962_ = array<type_9, 2>(_e1337[1][0][1], _e1337[1][0][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_3961_ = array<type_9, 2>(_e1337[1][0][2], _e1337[1][0][0]);
                                        } else {
                                            phi_3961_ = array<type_9, 2>(_e1337[1][0][0], _e1337[1][0][1]);
                                        }
                                        let _e3060 = phi_3961_;
                                        phi_3962_ = _e3060;
                                    }
                                    let _e3065 = phi_3962_;
                                    if (_e3014 == 0u) {
                                        phi_3997_ = array<type_9, 2>(_e1337[1][1][1], _e1337[1][1][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_3996_ = array<type_9, 2>(_e1337[1][1][2], _e1337[1][1][0]);
                                        } else {
                                            phi_3996_ = array<type_9, 2>(_e1337[1][1][0], _e1337[1][1][1]);
                                        }
                                        let _e3076 = phi_3996_;
                                        phi_3997_ = _e3076;
                                    }
                                    let _e3081 = phi_3997_;
                                    if (_e3014 == 0u) {
                                        phi_4032_ = array<type_9, 2>(_e1337[2][0][1], _e1337[2][0][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_4031_ = array<type_9, 2>(_e1337[2][0][2], _e1337[2][0][0]);
                                        } else {
                                            phi_4031_ = array<type_9, 2>(_e1337[2][0][0], _e1337[2][0][1]);
                                        }
                                        let _e3092 = phi_4031_;
                                        phi_4032_ = _e3092;
                                    }
                                    let _e3097 = phi_4032_;
                                    if (_e3014 == 0u) {
                                        phi_4067_ = array<type_9, 2>(_e1337[2][1][1], _e1337[2][1][2]);
                                    } else {
                                        if (_e3014 == 1u) {
                                            phi_4066_ = array<type_9, 2>(_e1337[2][1][2], _e1337[2][1][0]);
                                        } else {
                                            phi_4066_ = array<type_9, 2>(_e1337[2][1][0], _e1337[2][1][1]);
                                        }
                                        let _e3108 = phi_4066_;
                                        phi_4067_ = _e3108;
                                    }
                                    let _e3113 = phi_4067_;
                                    let _e3125 = ((_e3049[0].member - _e3033[0].member) - select(0u, 1u, (_e3049[0].member_1 < _e3033[0].member_1)));
                                    let _e3126 = (_e3049[0].member_1 - _e3033[0].member_1);
                                    let _e3129 = ((_e3125 >> bitcast<u32>(31i)) != 0u);
                                    let _e3136 = select(_e3125, (~(_e3125) + select(0u, 1u, (_e3126 == 0u))), _e3129);
                                    let _e3137 = select(_e3126, (~(_e3126) + 1u), _e3129);
                                    let _e3149 = ((_e3049[1].member - _e3033[1].member) - select(0u, 1u, (_e3049[1].member_1 < _e3033[1].member_1)));
                                    let _e3150 = (_e3049[1].member_1 - _e3033[1].member_1);
                                    let _e3153 = ((_e3149 >> bitcast<u32>(31i)) != 0u);
                                    let _e3160 = select(_e3149, (~(_e3149) + select(0u, 1u, (_e3150 == 0u))), _e3153);
                                    let _e3161 = select(_e3150, (~(_e3150) + 1u), _e3153);
                                    let _e3168 = ((((_e3160 - _e3136) - select(0u, 1u, (_e3161 < _e3137))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3170 = select(_e3161, _e3137, _e3168);
                                    let _e3171 = function_1(4u);
                                    let _e3174 = (_e3170 + _e3171.member_1);
                                    let _e3178 = ((select(_e3160, _e3136, _e3168) + _e3171.member) + select(0u, 1u, (_e3174 < _e3170)));
                                    let _e3193 = ((_e3174 >> bitcast<u32>((_e2817.member_2 & 31u))) | ((_e3178 << bitcast<u32>(((31u - _e2817.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3194 = function_1(4u);
                                    let _e3197 = (_e3193 + _e3194.member_1);
                                    let _e3201 = ((bitcast<u32>((bitcast<i32>(_e3178) >> bitcast<u32>((_e2817.member_2 & 31u)))) + _e3194.member) + select(0u, 1u, (_e3197 < _e3193)));
                                    let _e3213 = ((_e3081[0].member - _e3065[0].member) - select(0u, 1u, (_e3081[0].member_1 < _e3065[0].member_1)));
                                    let _e3214 = (_e3081[0].member_1 - _e3065[0].member_1);
                                    let _e3217 = ((_e3213 >> bitcast<u32>(31i)) != 0u);
                                    let _e3224 = select(_e3213, (~(_e3213) + select(0u, 1u, (_e3214 == 0u))), _e3217);
                                    let _e3225 = select(_e3214, (~(_e3214) + 1u), _e3217);
                                    let _e3237 = ((_e3081[1].member - _e3065[1].member) - select(0u, 1u, (_e3081[1].member_1 < _e3065[1].member_1)));
                                    let _e3238 = (_e3081[1].member_1 - _e3065[1].member_1);
                                    let _e3241 = ((_e3237 >> bitcast<u32>(31i)) != 0u);
                                    let _e3248 = select(_e3237, (~(_e3237) + select(0u, 1u, (_e3238 == 0u))), _e3241);
                                    let _e3249 = select(_e3238, (~(_e3238) + 1u), _e3241);
                                    let _e3256 = ((((_e3248 - _e3224) - select(0u, 1u, (_e3249 < _e3225))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3258 = select(_e3249, _e3225, _e3256);
                                    let _e3259 = function_1(4u);
                                    let _e3262 = (_e3258 + _e3259.member_1);
                                    let _e3266 = ((select(_e3248, _e3224, _e3256) + _e3259.member) + select(0u, 1u, (_e3262 < _e3258)));
                                    let _e3281 = ((_e3262 >> bitcast<u32>((_e2817.member_2 & 31u))) | ((_e3266 << bitcast<u32>(((31u - _e2817.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3282 = function_1(4u);
                                    let _e3285 = (_e3281 + _e3282.member_1);
                                    let _e3289 = ((bitcast<u32>((bitcast<i32>(_e3266) >> bitcast<u32>((_e2817.member_2 & 31u)))) + _e3282.member) + select(0u, 1u, (_e3285 < _e3281)));
                                    let _e3301 = ((_e3113[0].member - _e3097[0].member) - select(0u, 1u, (_e3113[0].member_1 < _e3097[0].member_1)));
                                    let _e3302 = (_e3113[0].member_1 - _e3097[0].member_1);
                                    let _e3305 = ((_e3301 >> bitcast<u32>(31i)) != 0u);
                                    let _e3312 = select(_e3301, (~(_e3301) + select(0u, 1u, (_e3302 == 0u))), _e3305);
                                    let _e3313 = select(_e3302, (~(_e3302) + 1u), _e3305);
                                    let _e3325 = ((_e3113[1].member - _e3097[1].member) - select(0u, 1u, (_e3113[1].member_1 < _e3097[1].member_1)));
                                    let _e3326 = (_e3113[1].member_1 - _e3097[1].member_1);
                                    let _e3329 = ((_e3325 >> bitcast<u32>(31i)) != 0u);
                                    let _e3336 = select(_e3325, (~(_e3325) + select(0u, 1u, (_e3326 == 0u))), _e3329);
                                    let _e3337 = select(_e3326, (~(_e3326) + 1u), _e3329);
                                    let _e3344 = ((((_e3336 - _e3312) - select(0u, 1u, (_e3337 < _e3313))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3346 = select(_e3337, _e3313, _e3344);
                                    let _e3347 = function_1(4u);
                                    let _e3350 = (_e3346 + _e3347.member_1);
                                    let _e3354 = ((select(_e3336, _e3312, _e3344) + _e3347.member) + select(0u, 1u, (_e3350 < _e3346)));
                                    let _e3369 = ((_e3350 >> bitcast<u32>((_e2817.member_2 & 31u))) | ((_e3354 << bitcast<u32>(((31u - _e2817.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3370 = function_1(4u);
                                    let _e3373 = (_e3369 + _e3370.member_1);
                                    let _e3377 = ((bitcast<u32>((bitcast<i32>(_e3354) >> bitcast<u32>((_e2817.member_2 & 31u)))) + _e3370.member) + select(0u, 1u, (_e3373 < _e3369)));
                                    let _e3391 = function_4(((_e3049[0].member - _e3033[0].member) - select(0u, 1u, (_e3049[0].member_1 < _e3033[0].member_1))), (_e3049[0].member_1 - _e3033[0].member_1), _e2817.member);
                                    let _e3394 = (_e3033[0].member_1 + _e3391.member_1);
                                    let _e3398 = ((_e3033[0].member + _e3391.member) + select(0u, 1u, (_e3394 < _e3033[0].member_1)));
                                    let _e3412 = function_4(((_e3049[1].member - _e3033[1].member) - select(0u, 1u, (_e3049[1].member_1 < _e3033[1].member_1))), (_e3049[1].member_1 - _e3033[1].member_1), _e2817.member);
                                    let _e3415 = (_e3033[1].member_1 + _e3412.member_1);
                                    let _e3419 = ((_e3033[1].member + _e3412.member) + select(0u, 1u, (_e3415 < _e3033[1].member_1)));
                                    let _e3433 = function_4(((_e3081[0].member - _e3065[0].member) - select(0u, 1u, (_e3081[0].member_1 < _e3065[0].member_1))), (_e3081[0].member_1 - _e3065[0].member_1), _e2817.member);
                                    let _e3436 = (_e3065[0].member_1 + _e3433.member_1);
                                    let _e3440 = ((_e3065[0].member + _e3433.member) + select(0u, 1u, (_e3436 < _e3065[0].member_1)));
                                    let _e3454 = function_4(((_e3081[1].member - _e3065[1].member) - select(0u, 1u, (_e3081[1].member_1 < _e3065[1].member_1))), (_e3081[1].member_1 - _e3065[1].member_1), _e2817.member);
                                    let _e3457 = (_e3065[1].member_1 + _e3454.member_1);
                                    let _e3461 = ((_e3065[1].member + _e3454.member) + select(0u, 1u, (_e3457 < _e3065[1].member_1)));
                                    let _e3475 = function_4(((_e3113[0].member - _e3097[0].member) - select(0u, 1u, (_e3113[0].member_1 < _e3097[0].member_1))), (_e3113[0].member_1 - _e3097[0].member_1), _e2817.member);
                                    let _e3478 = (_e3097[0].member_1 + _e3475.member_1);
                                    let _e3482 = ((_e3097[0].member + _e3475.member) + select(0u, 1u, (_e3478 < _e3097[0].member_1)));
                                    let _e3496 = function_4(((_e3113[1].member - _e3097[1].member) - select(0u, 1u, (_e3113[1].member_1 < _e3097[1].member_1))), (_e3113[1].member_1 - _e3097[1].member_1), _e2817.member);
                                    let _e3499 = (_e3097[1].member_1 + _e3496.member_1);
                                    let _e3503 = ((_e3097[1].member + _e3496.member) + select(0u, 1u, (_e3499 < _e3097[1].member_1)));
                                    let _e3504 = function_2(_e3289, _e3285, _e3377, _e3373);
                                    let _e3507 = function_2(_e3201, _e3197, _e3377, _e3373);
                                    let _e3510 = function_2(_e3201, _e3197, _e3289, _e3285);
                                    let _e3513 = function_7(_e3440, _e3436, _e3503, _e3499);
                                    let _e3516 = function_7(_e3461, _e3457, _e3482, _e3478);
                                    let _e3522 = ((_e3513.member - _e3516.member) - select(0u, 1u, (_e3513.member_1 < _e3516.member_1)));
                                    let _e3523 = (_e3513.member_1 - _e3516.member_1);
                                    let _e3526 = ((_e3522 >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e3504.member - select(_e3522, (~(_e3522) + select(0u, 1u, (_e3523 == 0u))), _e3526)) - select(0u, 1u, (_e3504.member_1 < select(_e3523, (~(_e3523) + 1u), _e3526)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e3544 = ((_e3522 >> bitcast<u32>(31i)) != 0u);
                                        let _e3551 = select(_e3522, (~(_e3522) + select(0u, 1u, (_e3523 == 0u))), _e3544);
                                        let _e3552 = select(_e3523, (~(_e3523) + 1u), _e3544);
                                        let _e3553 = function_7(_e3398, _e3394, _e3503, _e3499);
                                        let _e3556 = function_7(_e3419, _e3415, _e3482, _e3478);
                                        let _e3562 = ((_e3553.member - _e3556.member) - select(0u, 1u, (_e3553.member_1 < _e3556.member_1)));
                                        let _e3563 = (_e3553.member_1 - _e3556.member_1);
                                        let _e3570 = select(_e3562, (~(_e3562) + select(0u, 1u, (_e3563 == 0u))), _e3544);
                                        let _e3571 = select(_e3563, (~(_e3563) + 1u), _e3544);
                                        let _e3572 = function_7(_e3440, _e3436, _e3419, _e3415);
                                        let _e3575 = function_7(_e3461, _e3457, _e3398, _e3394);
                                        let _e3581 = ((_e3572.member - _e3575.member) - select(0u, 1u, (_e3572.member_1 < _e3575.member_1)));
                                        let _e3582 = (_e3572.member_1 - _e3575.member_1);
                                        let _e3589 = select(_e3581, (~(_e3581) + select(0u, 1u, (_e3582 == 0u))), _e3544);
                                        let _e3590 = select(_e3582, (~(_e3582) + 1u), _e3544);
                                        if (_e229.member != 0u) {
                                            let _e3622 = (_e3504.member_1 + _e3507.member_1);
                                            let _e3634 = (_e3504.member_1 + _e3510.member_1);
                                            phi_4825_ = type_9(((_e3504.member + _e3510.member) + select(0u, 1u, (_e3634 < _e3504.member_1))), _e3634);
                                            phi_4826_ = type_9(((_e3551 - _e3589) - select(0u, 1u, (_e3552 < _e3590))), (_e3552 - _e3590));
                                            phi_4827_ = type_9(((_e3504.member + _e3507.member) + select(0u, 1u, (_e3622 < _e3504.member_1))), _e3622);
                                            phi_4828_ = type_9(((_e3551 - _e3570) - select(0u, 1u, (_e3552 < _e3571))), (_e3552 - _e3571));
                                        } else {
                                            let _e3596 = (_e3552 - _e3571);
                                            let _e3600 = ((((_e3551 - _e3570) - select(0u, 1u, (_e3552 < _e3571))) - _e3589) - select(0u, 1u, (_e3596 < _e3590)));
                                            let _e3601 = (_e3596 - _e3590);
                                            let _e3603 = (_e3504.member_1 + _e3507.member_1);
                                            let _e3608 = (_e3603 + _e3510.member_1);
                                            let _e3612 = ((((_e3504.member + _e3507.member) + select(0u, 1u, (_e3603 < _e3504.member_1))) + _e3510.member) + select(0u, 1u, (_e3608 < _e3603)));
                                            phi_4825_ = type_9(_e3612, _e3608);
                                            phi_4826_ = type_9(_e3600, _e3601);
                                            phi_4827_ = type_9(_e3612, _e3608);
                                            phi_4828_ = type_9(_e3600, _e3601);
                                        }
                                        let _e3641 = phi_4825_;
                                        let _e3643 = phi_4826_;
                                        let _e3645 = phi_4827_;
                                        let _e3647 = phi_4828_;
                                        if ((((_e3507.member - (~(_e3570) + select(0u, 1u, (_e3571 == 0u)))) - select(0u, 1u, (_e3507.member_1 < (~(_e3571) + 1u)))) >> bitcast<u32>(31i)) != 0u) {
                                            phi_4921_ = bool();
                                            phi_4922_ = true;
                                        } else {
                                            if ((((_e3510.member - (~(_e3589) + select(0u, 1u, (_e3590 == 0u)))) - select(0u, 1u, (_e3510.member_1 < (~(_e3590) + 1u)))) >> bitcast<u32>(31i)) != 0u) {
                                                phi_4919_ = bool();
                                                phi_4920_ = true;
                                            } else {
                                                let _e3690 = ((((_e3645.member - (~(_e3647.member) + select(0u, 1u, (_e3647.member_1 == 0u)))) - select(0u, 1u, (_e3645.member_1 < (~(_e3647.member_1) + 1u)))) >> bitcast<u32>(31i)) != 0u);
                                                if _e3690 {
                                                    phi_4918_ = bool();
                                                } else {
                                                    phi_4918_ = ((((_e3641.member - (~(_e3643.member) + select(0u, 1u, (_e3643.member_1 == 0u)))) - select(0u, 1u, (_e3641.member_1 < (~(_e3643.member_1) + 1u)))) >> bitcast<u32>(31i)) != 0u);
                                                }
                                                let _e3709 = phi_4918_;
                                                phi_4919_ = _e3709;
                                                phi_4920_ = _e3690;
                                            }
                                            let _e3711 = phi_4919_;
                                            let _e3713 = phi_4920_;
                                            phi_4921_ = _e3711;
                                            phi_4922_ = _e3713;
                                        }
                                        let _e3715 = phi_4921_;
                                        let _e3717 = phi_4922_;
                                        if ((((_e3507.member - _e3570) - select(0u, 1u, (_e3507.member_1 < _e3571))) >> bitcast<u32>(31i)) != 0u) {
                                            if ((((_e3510.member - _e3589) - select(0u, 1u, (_e3510.member_1 < _e3590))) >> bitcast<u32>(31i)) != 0u) {
                                                if ((((_e3645.member - _e3647.member) - select(0u, 1u, (_e3645.member_1 < _e3647.member_1))) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4980_ = ((((_e3641.member - _e3643.member) - select(0u, 1u, (_e3641.member_1 < _e3643.member_1))) >> bitcast<u32>(31i)) != 0u);
                                                    phi_4981_ = false;
                                                } else {
                                                    phi_4980_ = bool();
                                                    phi_4981_ = true;
                                                }
                                                let _e3756 = phi_4980_;
                                                let _e3758 = phi_4981_;
                                                phi_4982_ = _e3756;
                                                phi_4983_ = _e3758;
                                            } else {
                                                phi_4982_ = bool();
                                                phi_4983_ = true;
                                            }
                                            let _e3760 = phi_4982_;
                                            let _e3762 = phi_4983_;
                                            phi_4984_ = _e3760;
                                            phi_4985_ = _e3762;
                                        } else {
                                            phi_4984_ = bool();
                                            phi_4985_ = true;
                                        }
                                        let _e3764 = phi_4984_;
                                        let _e3766 = phi_4985_;
                                        phi_4998_ = select(select(2u, 0u, select(_e3764, false, _e3766)), 1u, select(_e3715, true, _e3717));
                                    } else {
                                        phi_4998_ = 2u;
                                    }
                                    let _e3771 = phi_4998_;
                                    let _e3772 = (_e3771 == 1u);
                                    let _e3773 = (_e3771 == 0u);
                                    let _e3789 = local_74;
                                    if _e3789 {
                                        let _e4848 = local_108;
                                        phi_5070_ = _e4848;
                                        phi_5071_ = _e3772;
                                        phi_5072_ = select(true, false, _e3772);
                                        phi_5073_ = false;
                                        phi_5074_ = false;
                                    } else {
                                        let _e3793 = select(true, select(true, select(true, select(true, false, ((_e2817.member_1 - _e2817.member) <= _e714)), select(false, (_e2817.member_1 <= _e712), (_e2817.member >= _e710))), _e2803), _e3773);
                                        let _e3795 = select(select(false, select((_e2817.member > _e712), true, (_e2817.member_1 < _e710)), _e2815), true, _e3772);
                                        let _e3796 = select(true, _e3795, select(select(select((_e2404 == 0u), bool(), _e2402), bool(), _e1802), true, select(_e2402, true, _e1802)));
                                        phi_5070_ = select(bool(), _e3795, _e3793);
                                        phi_5071_ = select(false, _e3796, _e3793);
                                        phi_5072_ = false;
                                        phi_5073_ = select(false, select(true, false, _e3796), _e3793);
                                        phi_5074_ = select(true, false, _e3793);
                                    }
                                    let _e3804 = phi_5070_;
                                    let _e3806 = phi_5071_;
                                    let _e3808 = phi_5072_;
                                    let _e3810 = phi_5073_;
                                    let _e3812 = phi_5074_;
                                    phi_5081_ = _e2815;
                                    phi_5082_ = _e2643;
                                    phi_5083_ = true;
                                    phi_5084_ = !(_e2456);
                                    phi_5085_ = _e2647;
                                    phi_5086_ = _e3804;
                                    phi_5087_ = _e3773;
                                    phi_5088_ = _e2817;
                                    phi_5089_ = _e3806;
                                    phi_5090_ = select(_e3808, false, _e3806);
                                    phi_5091_ = select(_e3810, false, _e3806);
                                    phi_5092_ = select(_e3812, false, _e3806);
                                }
                                let _e3817 = phi_5081_;
                                let _e3819 = phi_5082_;
                                let _e3821 = phi_5083_;
                                let _e3823 = phi_5084_;
                                let _e3825 = phi_5085_;
                                let _e3827 = phi_5086_;
                                let _e3829 = phi_5087_;
                                let _e3831 = phi_5088_;
                                let _e3833 = phi_5089_;
                                let _e3835 = phi_5090_;
                                let _e3837 = phi_5091_;
                                let _e3839 = phi_5092_;
                                phi_5093_ = _e3817;
                                phi_5094_ = _e3819;
                                phi_5095_ = _e3821;
                                phi_5096_ = _e3823;
                                phi_5097_ = _e3825;
                                phi_5098_ = _e3827;
                                phi_5099_ = _e3829;
                                phi_5100_ = _e3831;
                                phi_5101_ = _e3833;
                                phi_5102_ = _e3835;
                                phi_5103_ = _e3837;
                                phi_5104_ = _e3839;
                            } else {
                                phi_5093_ = _e1802;
                                phi_5094_ = _e1804;
                                let _e4875 = local_112;
                                phi_5095_ = _e4875;
                                let _e4878 = local_113;
                                phi_5096_ = _e4878;
                                phi_5097_ = _e1810;
                                let _e4882 = local_114;
                                phi_5098_ = _e4882;
                                phi_5099_ = bool();
                                phi_5100_ = type_17();
                                phi_5101_ = true;
                                phi_5102_ = false;
                                phi_5103_ = false;
                                phi_5104_ = false;
                            }
                            let _e3841 = phi_5093_;
                            let _e3843 = phi_5094_;
                            let _e3845 = phi_5095_;
                            let _e3847 = phi_5096_;
                            let _e3849 = phi_5097_;
                            let _e3851 = phi_5098_;
                            let _e3853 = phi_5099_;
                            let _e3855 = phi_5100_;
                            let _e3857 = phi_5101_;
                            let _e3859 = phi_5102_;
                            let _e3861 = phi_5103_;
                            let _e3863 = phi_5104_;
                            if _e3857 {
                                if _e3851 {
                                    let _e3867 = local_75;
                                    let _e3868 = (_e3867 + 1u);
                                    let _e3870 = local_76;
                                    let _e3872 = (_e3868 & (4294967295u - _e3870));
                                    let _e3878 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3872)), 32u, (_e3872 == 0u)));
                                    let _e3880 = local_77;
                                    let _e3883 = local_78;
                                    let _e3884 = select(_e3878, _e3883, (_e3880 < _e3878));
                                    let _e3887 = (_e3868 >> bitcast<u32>((_e3884 & 31u)));
                                    let _e3889 = local_79;
                                    let _e3890 = (_e3889 - _e3884);
                                    let _e3892 = local_80;
                                    let _e3893 = (_e3892 > _e712);
                                    if _e3893 {
                                        phi_5155_ = u32();
                                        phi_5156_ = u32();
                                        phi_5157_ = false;
                                        phi_5158_ = false;
                                    } else {
                                        let _e3897 = select(true, select(true, false, (_e3890 == 0u)), (_e3887 == 1u));
                                        let _e3898 = (31u - _e3890);
                                        phi_5155_ = select(u32(), ((_e3887 + 1u) << bitcast<u32>((_e3898 & 31u))), _e3897);
                                        phi_5156_ = select(u32(), (_e3887 << bitcast<u32>((_e3898 & 31u))), _e3897);
                                        phi_5157_ = _e3897;
                                        phi_5158_ = select(true, false, _e3897);
                                    }
                                    let _e3910 = phi_5155_;
                                    let _e3912 = phi_5156_;
                                    let _e3914 = phi_5157_;
                                    let _e3916 = phi_5158_;
                                    phi_5159_ = _e3910;
                                    phi_5160_ = _e3912;
                                    phi_5161_ = false;
                                    phi_5162_ = false;
                                    phi_5163_ = false;
                                    phi_5164_ = false;
                                    phi_5165_ = _e3890;
                                    phi_5166_ = _e3887;
                                    phi_5167_ = _e3914;
                                    phi_5168_ = _e3893;
                                    phi_5169_ = _e3916;
                                } else {
                                    phi_5159_ = _e3849.member_1;
                                    phi_5160_ = _e3849.member;
                                    phi_5161_ = _e3841;
                                    phi_5162_ = _e3843;
                                    phi_5163_ = _e3845;
                                    phi_5164_ = _e3847;
                                    let _e4907 = local_115;
                                    phi_5165_ = _e4907;
                                    let _e4910 = local_116;
                                    phi_5166_ = _e4910;
                                    phi_5167_ = true;
                                    phi_5168_ = false;
                                    phi_5169_ = false;
                                }
                                let _e3918 = phi_5159_;
                                let _e3920 = phi_5160_;
                                let _e3922 = phi_5161_;
                                let _e3924 = phi_5162_;
                                let _e3926 = phi_5163_;
                                let _e3928 = phi_5164_;
                                let _e3930 = phi_5165_;
                                let _e3932 = phi_5166_;
                                let _e3934 = phi_5167_;
                                let _e3936 = phi_5168_;
                                let _e3938 = phi_5169_;
                                if _e3934 {
                                    if select(_e3922, true, _e3851) {
                                        phi_5194_ = type_14(0i, 4i);
                                        phi_5197_ = array<u32, 3>(_e3920, _e3920, _e3920);
                                        phi_5199_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                                        loop {
                                            let _e3942 = phi_5194_;
                                            let _e3944 = phi_5197_;
                                            let _e3946 = phi_5199_;
                                            local_81 = _e3946;
                                            local_82 = _e3946;
                                            local_83 = _e3946;
                                            local_84 = _e3946;
                                            local_85 = _e3946;
                                            local_86 = _e3946;
                                            local_87 = _e3946;
                                            local_88 = _e3946;
                                            local_89 = _e3946;
                                            local_90 = _e3946;
                                            local_91 = _e3946;
                                            local_92 = _e3946;
                                            local_118 = _e3946;
                                            if (_e3942.member < _e3942.member_1) {
                                                let _e3953 = (_e3942.member + 1i);
                                                phi_5195_ = type_14(select(_e3953, type_15().member_1, select(false, true, ((false == (_e3953 > _e3942.member)) != false))), _e3942.member_1);
                                                phi_5240_ = type_15(1u, _e3942.member);
                                            } else {
                                                phi_5195_ = _e3942;
                                                phi_5240_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3964 = phi_5195_;
                                            let _e3966 = phi_5240_;
                                            let _e3969 = (bitcast<i32>(_e3966.member) != 0i);
                                            if _e3969 {
                                                let _e3978 = function_4(((_e1630[1].member - _e1626.member) - select(0u, 1u, (_e1634[1].member_1 < _e1626.member_1))), (_e1634[1].member_1 - _e1626.member_1), _e3944[0]);
                                                let _e3981 = (_e1626.member_1 + _e3978.member_1);
                                                let _e3985 = ((_e1626.member + _e3978.member) + select(0u, 1u, (_e3981 < _e1626.member_1)));
                                                let _e3991 = function_4(((_e1638[2].member - _e1630[1].member) - select(0u, 1u, (_e1642[2].member_1 < _e1634[1].member_1))), (_e1642[2].member_1 - _e1634[1].member_1), _e3944[0]);
                                                let _e3994 = (_e1634[1].member_1 + _e3991.member_1);
                                                let _e3998 = ((_e1630[1].member + _e3991.member) + select(0u, 1u, (_e3994 < _e1634[1].member_1)));
                                                let _e4004 = function_4(((_e1653.member - _e1638[2].member) - select(0u, 1u, (_e1653.member_1 < _e1642[2].member_1))), (_e1653.member_1 - _e1642[2].member_1), _e3944[0]);
                                                let _e4007 = (_e1642[2].member_1 + _e4004.member_1);
                                                let _e4017 = function_4(((_e3998 - _e3985) - select(0u, 1u, (_e3994 < _e3981))), (_e3994 - _e3981), _e3944[1]);
                                                let _e4020 = (_e3981 + _e4017.member_1);
                                                let _e4024 = ((_e3985 + _e4017.member) + select(0u, 1u, (_e4020 < _e3981)));
                                                let _e4030 = function_4(((((_e1638[2].member + _e4004.member) + select(0u, 1u, (_e4007 < _e1642[2].member_1))) - _e3998) - select(0u, 1u, (_e4007 < _e3994))), (_e4007 - _e3994), _e3944[1]);
                                                let _e4033 = (_e3994 + _e4030.member_1);
                                                let _e4043 = function_4(((((_e3998 + _e4030.member) + select(0u, 1u, (_e4033 < _e3994))) - _e4024) - select(0u, 1u, (_e4033 < _e4020))), (_e4033 - _e4020), _e3944[2]);
                                                let _e4046 = (_e4020 + _e4043.member_1);
                                                phi_5198_ = array<u32, 3>(_e3944[1], _e3944[2], _e3918);
                                                phi_5200_ = array<type_9, 4>(_e3946[1], _e3946[2], _e3946[3], type_9(((_e4024 + _e4043.member) + select(0u, 1u, (_e4046 < _e4020))), _e4046));
                                            } else {
                                                phi_5198_ = array<u32, 3>();
                                                phi_5200_ = array<type_9, 4>();
                                            }
                                            let _e4060 = phi_5198_;
                                            let _e4062 = phi_5200_;
                                            continue;
                                            continuing {
                                                phi_5194_ = _e3964;
                                                phi_5197_ = _e4060;
                                                phi_5199_ = _e4062;
                                                break if !(_e3969);
                                            }
                                        }
                                        let _e4065 = local_81;
                                        let _e4069 = local_82;
                                        let _e4072 = function_1(128u);
                                        let _e4077 = ((_e4065[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4085 = local_83;
                                        let _e4104 = local_84;
                                        let _e4108 = local_85;
                                        let _e4111 = function_1(128u);
                                        let _e4116 = ((_e4104[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4124 = local_86;
                                        let _e4146 = local_87;
                                        let _e4150 = local_88;
                                        let _e4153 = function_1(128u);
                                        let _e4158 = ((_e4146[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4166 = local_89;
                                        let _e4188 = local_90;
                                        let _e4192 = local_91;
                                        let _e4195 = function_1(128u);
                                        let _e4200 = ((_e4188[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4208 = local_92;
                                        phi_5571_ = (((select(0u, select(1u, 2u, ((_e4065[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4072.member - select(_e4085[0].member, (~(_e4065[0].member) + select(0u, 1u, (_e4069[0].member_1 == 0u))), _e4077)) - select(0u, 1u, (_e4072.member_1 < select(_e4085[0].member_1, (~(_e4069[0].member_1) + 1u), _e4077)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e4104[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e4111.member - select(_e4124[1].member, (~(_e4104[1].member) + select(0u, 1u, (_e4108[1].member_1 == 0u))), _e4116)) - select(0u, 1u, (_e4111.member_1 < select(_e4124[1].member_1, (~(_e4108[1].member_1) + 1u), _e4116)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e4146[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e4153.member - select(_e4166[2].member, (~(_e4146[2].member) + select(0u, 1u, (_e4150[2].member_1 == 0u))), _e4158)) - select(0u, 1u, (_e4153.member_1 < select(_e4166[2].member_1, (~(_e4150[2].member_1) + 1u), _e4158)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e4188[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e4195.member - select(_e4208[3].member, (~(_e4188[3].member) + select(0u, 1u, (_e4192[3].member_1 == 0u))), _e4200)) - select(0u, 1u, (_e4195.member_1 < select(_e4208[3].member_1, (~(_e4192[3].member_1) + 1u), _e4200)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                        let _e4938 = local_118;
                                        phi_5572_ = _e4938;
                                    } else {
                                        let _e4935 = local_117;
                                        phi_5571_ = _e4935;
                                        let _e4940 = local_119;
                                        phi_5572_ = _e4940;
                                    }
                                    let _e4230 = phi_5571_;
                                    let _e4232 = phi_5572_;
                                    phi_5573_ = _e4230;
                                    phi_5574_ = _e4232;
                                    phi_5575_ = false;
                                    phi_5576_ = false;
                                } else {
                                    phi_5573_ = u32();
                                    phi_5574_ = array<type_9, 4>();
                                    phi_5575_ = _e3936;
                                    phi_5576_ = _e3938;
                                }
                                let _e4234 = phi_5573_;
                                let _e4236 = phi_5574_;
                                let _e4238 = phi_5575_;
                                let _e4240 = phi_5576_;
                                phi_5577_ = _e4234;
                                phi_5578_ = _e4236;
                                phi_5579_ = _e3922;
                                phi_5580_ = _e3924;
                                phi_5581_ = _e3926;
                                phi_5582_ = _e3928;
                                phi_5583_ = _e3930;
                                phi_5584_ = _e3932;
                                phi_5585_ = _e3934;
                                phi_5586_ = _e4238;
                                phi_5587_ = _e4240;
                                phi_5588_ = false;
                                phi_5589_ = false;
                                phi_5590_ = false;
                            } else {
                                phi_5577_ = u32();
                                phi_5578_ = array<type_9, 4>();
                                phi_5579_ = bool();
                                phi_5580_ = bool();
                                phi_5581_ = bool();
                                phi_5582_ = bool();
                                phi_5583_ = u32();
                                phi_5584_ = u32();
                                phi_5585_ = false;
                                phi_5586_ = false;
                                phi_5587_ = false;
                                phi_5588_ = _e3859;
                                phi_5589_ = _e3861;
                                phi_5590_ = _e3863;
                            }
                            let _e4242 = phi_5577_;
                            let _e4244 = phi_5578_;
                            let _e4246 = phi_5579_;
                            let _e4248 = phi_5580_;
                            let _e4250 = phi_5581_;
                            let _e4252 = phi_5582_;
                            let _e4254 = phi_5583_;
                            let _e4256 = phi_5584_;
                            let _e4258 = phi_5585_;
                            let _e4260 = phi_5586_;
                            let _e4262 = phi_5587_;
                            let _e4264 = phi_5588_;
                            let _e4266 = phi_5589_;
                            let _e4268 = phi_5590_;
                            phi_2396_ = _e4242;
                            phi_2399_ = _e4244;
                            phi_2401_ = _e4246;
                            phi_2403_ = _e4248;
                            phi_2405_ = _e4250;
                            phi_2407_ = _e4252;
                            phi_2409_ = _e3849;
                            let _e4968 = local_120;
                            phi_2411_ = _e4968;
                            let _e4971 = local_121;
                            phi_2413_ = _e4971;
                            let _e4974 = local_122;
                            phi_2415_ = _e4974;
                            phi_2417_ = _e4254;
                            phi_2419_ = _e4256;
                            phi_5591_ = _e3853;
                            phi_5592_ = _e3855;
                            phi_5593_ = _e4258;
                            phi_5594_ = false;
                            phi_5595_ = _e4260;
                            phi_5596_ = _e4262;
                            phi_5597_ = _e4264;
                            phi_5598_ = _e4266;
                            phi_5599_ = _e4268;
                        } else {
                            phi_2396_ = u32();
                            phi_2399_ = array<type_9, 4>();
                            phi_2401_ = bool();
                            phi_2403_ = bool();
                            phi_2405_ = bool();
                            phi_2407_ = bool();
                            phi_2409_ = type_17();
                            phi_2411_ = u32();
                            phi_2413_ = u32();
                            phi_2415_ = u32();
                            phi_2417_ = u32();
                            phi_2419_ = u32();
                            phi_5591_ = bool();
                            phi_5592_ = type_17();
                            phi_5593_ = false;
                            phi_5594_ = true;
                            phi_5595_ = false;
                            phi_5596_ = false;
                            phi_5597_ = false;
                            phi_5598_ = false;
                            phi_5599_ = false;
                        }
                        let _e4270 = phi_2396_;
                        let _e4272 = phi_2399_;
                        let _e4274 = phi_2401_;
                        let _e4276 = phi_2403_;
                        let _e4278 = phi_2405_;
                        let _e4280 = phi_2407_;
                        let _e4282 = phi_2409_;
                        let _e4284 = phi_2411_;
                        let _e4286 = phi_2413_;
                        let _e4288 = phi_2415_;
                        let _e4290 = phi_2417_;
                        let _e4292 = phi_2419_;
                        let _e4294 = phi_5591_;
                        let _e4296 = phi_5592_;
                        let _e4298 = phi_5593_;
                        let _e4300 = phi_5594_;
                        let _e4302 = phi_5595_;
                        let _e4304 = phi_5596_;
                        let _e4306 = phi_5597_;
                        let _e4308 = phi_5598_;
                        let _e4310 = phi_5599_;
                        local_93 = _e4300;
                        local_94 = _e4300;
                        local_95 = _e4300;
                        local_96 = _e4302;
                        local_97 = _e4300;
                        local_98 = _e4304;
                        local_99 = _e4300;
                        local_100 = _e4306;
                        local_101 = _e4300;
                        local_102 = _e4308;
                        local_103 = _e4300;
                        local_104 = _e4310;
                        local_105 = _e4294;
                        local_106 = _e4294;
                        local_107 = _e4296;
                        continue;
                        continuing {
                            phi_2395_ = _e4270;
                            phi_2398_ = _e4272;
                            phi_2400_ = _e4274;
                            phi_2402_ = _e4276;
                            phi_2404_ = _e4278;
                            phi_2406_ = _e4280;
                            phi_2408_ = _e4282;
                            phi_2410_ = _e4284;
                            phi_2412_ = _e4286;
                            phi_2414_ = _e4288;
                            phi_2416_ = _e4290;
                            phi_2418_ = _e4292;
                            break if !(_e4298);
                        }
                    }
                    let _e4314 = local_93;
                    let _e4319 = local_94;
                    let _e4322 = local_95;
                    let _e4324 = local_96;
                    let _e4325 = select(_e4324, false, _e4322);
                    let _e4327 = local_97;
                    let _e4329 = local_98;
                    let _e4332 = local_99;
                    let _e4334 = local_100;
                    let _e4337 = local_101;
                    let _e4339 = local_102;
                    let _e4342 = local_103;
                    let _e4344 = local_104;
                    let _e4346 = select(select(_e4329, false, _e4327), false, _e4325);
                    let _e4350 = select(_e4325, true, _e4346);
                    let _e4359 = select(select(select(select(_e4334, false, _e4332), false, _e4325), false, _e4346), false, _e4350);
                    if _e4359 {
                        let _e4363 = local_105;
                        let _e4368 = local_106;
                        phi_5641_ = type_9(select(2u, 3u, _e4363), select(type_9().member_1, type_9().member_1, _e4368));
                        phi_5642_ = false;
                        phi_5643_ = false;
                        phi_5644_ = false;
                    } else {
                        phi_5641_ = type_9();
                        phi_5642_ = select(select(select(select(_e4339, false, _e4337), false, _e4325), false, _e4346), false, _e4350);
                        phi_5643_ = select(select(select(select(_e4344, false, _e4342), false, _e4325), false, _e4346), false, _e4350);
                        phi_5644_ = _e4350;
                    }
                    let _e4372 = phi_5641_;
                    let _e4374 = phi_5642_;
                    let _e4376 = phi_5643_;
                    let _e4378 = phi_5644_;
                    let _e4384 = select(_e4376, false, _e4374);
                    let _e4388 = local_107;
                    let _e4392 = select(_e4374, true, _e4384);
                    let _e4399 = select(select(select(_e4359, false, _e4374), false, _e4384), true, _e4392);
                    let _e4403 = select(select(select(select(_e4378, false, _e4374), false, _e4384), false, _e4392), true, _e4399);
                    phi_5680_ = type_9(select(select(type_9().member, 2u, _e4314), select(select(type_9().member, 0u, _e4350), select(_e4372.member, select(select(type_9().member, 2u, _e4374), 1u, _e4384), _e4392), _e4399), _e4403), select(select(type_9().member_1, type_9().member_1, _e4319), select(select(type_9().member_1, type_9().member_1, _e4350), select(_e4372.member_1, select(select(type_9().member_1, type_9().member_1, _e4374), _e4388.member, _e4384), _e4392), _e4399), _e4403));
                }
                let _e4410 = phi_5680_;
                phi_5684_ = _e4410;
                phi_5685_ = type_9(_e187, _e190);
            } else {
                phi_5684_ = type_9(0u, u32());
                phi_5685_ = type_9(0u, 0u);
            }
            let _e4412 = phi_5684_;
            let _e4414 = phi_5685_;
            let _e4418 = params.member.member_2.member_1;
            switch bitcast<i32>(_e4412.member) {
                case 0: {
                    phi_5722_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                    phi_5723_ = false;
                    break;
                }
                case 1: {
                    if (_e4412.member_1 == 0u) {
                        phi_5719_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e4427 = select((bitcast<u32>(31i) - firstLeadingBit(_e4412.member_1)), 32u, (_e4412.member_1 == 0u));
                        let _e4432 = ((_e4412.member_1 << bitcast<u32>((_e4427 & 31u))) << bitcast<u32>(1i));
                        phi_5719_ = array<u32, 2>((_e4432 << bitcast<u32>(20i)), (((1023u - _e4427) << bitcast<u32>(20i)) | (_e4432 >> bitcast<u32>(12i))));
                    }
                    let _e4443 = phi_5719_;
                    phi_5722_ = type_26(0u, select(0u, 1u, (_e4412.member_1 > _e4418)), _e4443, true);
                    phi_5723_ = false;
                    break;
                }
                case 2: {
                    phi_5722_ = type_26();
                    phi_5723_ = true;
                    break;
                }
                case 3: {
                    phi_5722_ = type_26();
                    phi_5723_ = true;
                    break;
                }
                default: {
                    phi_5722_ = type_26();
                    phi_5723_ = bool();
                    break;
                }
            }
            let _e4446 = phi_5722_;
            let _e4448 = phi_5723_;
            if _e4448 {
                phi_5727_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
            } else {
                phi_5727_ = _e4446;
            }
            let _e4450 = phi_5727_;
            local_1 = type_26(_e4450.member, _e4450.member_1, array<u32, 2>(_e4450.member_2[0], _e4450.member_2[1]), _e4450.member_3);
            let _e4463 = global.member;
            if (bitcast<i32>(_e4412.member) == bitcast<i32>(_e4463)) {
                if (bitcast<i32>(_e4412.member) == 1i) {
                    let _e4470 = global.member;
                    if (bitcast<i32>(_e4470) == 1i) {
                        let _e4475 = global.member_1;
                        phi_5767_ = (_e4412.member_1 == _e4475);
                        phi_5768_ = false;
                    } else {
                        phi_5767_ = bool();
                        phi_5768_ = true;
                    }
                    let _e4478 = phi_5767_;
                    let _e4480 = phi_5768_;
                    phi_5769_ = _e4478;
                    phi_5770_ = _e4480;
                } else {
                    phi_5769_ = bool();
                    phi_5770_ = true;
                }
                let _e4482 = phi_5769_;
                let _e4484 = phi_5770_;
                phi_5775_ = select(_e4482, true, _e4484);
            } else {
                phi_5775_ = false;
            }
            let _e4487 = phi_5775_;
            let _e4492 = params.member.member_2.member.member;
            let _e4495 = local_1.member;
            let _e4496 = (_e4495 == 0u);
            let _e4501 = select(select(select((_e4492 > 0u), bool(), _e4487), bool(), _e4496), false, select(_e4487, true, _e4496));
            if _e4501 {
                local = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e4502 = local_1;
                local = _e4502;
            }
            let _e4504 = local.member;
            let _e4506 = select(true, false, (_e4504 == 0u));
            let _e4508 = local.member_3;
            if _e4508 {
                if _e4506 {
                    phi_5831_ = true;
                } else {
                    let _e4510 = params.member.member.member_1;
                    phi_5831_ = ((_e4510 & 16u) != 0u);
                }
                let _e4514 = phi_5831_;
                phi_5832_ = _e4514;
            } else {
                phi_5832_ = false;
            }
            let _e4516 = phi_5832_;
            let _e4518 = local.member_3;
            if _e4518 {
                if _e4506 {
                } else {
                    let _e4520 = local.member_2;
                    let _e4525 = ((_e4520[1] >> bitcast<u32>(20i)) & 2047u);
                    let _e4539 = atomicMin((&earliest.member[0u]), select(((((_e4525 - 896u) << bitcast<u32>(23i)) | ((_e4520[1] & 1048575u) << bitcast<u32>(3i))) | (_e4520[0] >> bitcast<u32>(29i))), 0u, (_e4525 <= 896u)));
                }
            }
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4516 {
                let _e4543 = atomicAdd((&counters[0u]), 1u);
                phi_5876_ = _e4543;
            } else {
                phi_5876_ = 0u;
            }
            let _e4545 = phi_5876_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e4548 = atomicLoad((&counters[0u]));
                if (_e4548 > 0u) {
                    let _e4551 = atomicAdd((&contacts.member[0u]), _e4548);
                    atomicStore((&counters[1u]), _e4551);
                }
            }
            workgroupBarrier();
            let _e4554 = atomicLoad((&counters[1u]));
            let _e4555 = (_e4554 + _e4545);
            if _e4516 {
                let _e4557 = params.member.member_1.member_3;
                if (_e4555 < _e4557) {
                    let _e4563 = (7u * _e4555);
                    atomicStore((&contacts.member[(4u + _e4563)]), select(1u, 0u, ((_e4414.member_1 & 2147483648u) == 0u)));
                    let _e4568 = local.member;
                    atomicStore((&contacts.member[(_e4563 + 5u)]), _e4568);
                    atomicStore((&contacts.member[(_e4563 + 6u)]), _e4414.member);
                    atomicStore((&contacts.member[(_e4563 + 7u)]), (_e4414.member_1 & 2147483647u));
                    let _e4577 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e4563 + 8u)]), _e4577);
                    let _e4582 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e4563 + 9u)]), _e4582);
                    let _e4586 = local.member_1;
                    atomicStore((&contacts.member[(_e4563 + 10u)]), _e4586);
                }
            }
            workgroupBarrier();
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4501 {
                let _e4591 = atomicAdd((&counters[0u]), 1u);
                phi_5958_ = _e4591;
            } else {
                phi_5958_ = 0u;
            }
            let _e4593 = phi_5958_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e4596 = atomicLoad((&counters[0u]));
                if (_e4596 > 0u) {
                    let _e4599 = atomicAdd((&left.member[0u]), _e4596);
                    atomicStore((&counters[1u]), _e4599);
                }
            }
            workgroupBarrier();
            let _e4602 = atomicLoad((&counters[1u]));
            let _e4603 = (_e4602 + _e4593);
            if _e4501 {
                if (_e4603 < _e4492) {
                    let _e4605 = (2u * _e4603);
                    atomicStore((&left.member[(4u + _e4605)]), _e4414.member);
                    atomicStore((&left.member[(_e4605 + 5u)]), _e4414.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_311_ = type_9(select(_e157.member, (_e157.member + 1u), _e160), select(_e157.member_1, _e157.member_1, _e160));
            break if !(_e173);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_9(id, n, lane);
}
