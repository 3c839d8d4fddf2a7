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
    var phi_6066_: type_9;
    var phi_6067_: type_9;
    var phi_6068_: type_9;
    var phi_6069_: type_9;
    var phi_6070_: type_9;
    var phi_6071_: bool;

    let _e24 = ((param_20[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_20[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_21);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_6070_ = type_9();
        phi_6071_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_6069_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_6068_ = type_9((param_20[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_6067_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_20[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_20[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_6066_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_20[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_6066_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_6066_;
                    phi_6067_ = _e67;
                }
                let _e83 = phi_6067_;
                phi_6068_ = _e83;
            }
            let _e89 = phi_6068_;
            phi_6069_ = _e89;
        }
        let _e91 = phi_6069_;
        phi_6070_ = _e91;
        phi_6071_ = _e37;
    }
    let _e93 = phi_6070_;
    let _e95 = phi_6071_;
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
    var phi_5875_: u32;
    var phi_5957_: u32;
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
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e114 = ((_e99.y * _e100.x) + _e99.x);
    let _e117 = (_e100.x * _e100.y);
    let _e120 = params.member.member_1.member_2;
    let _e122 = input.member[0u];
    let _e124 = select(_e122, _e120, (_e120 < _e122));
    let _e126 = params.member.member_1.member_1;
    if (_e124 > _e126) {
        let _e129 = params.member.member_1.member_1;
        phi_262_ = (_e124 - _e129);
    } else {
        phi_262_ = 0u;
    }
    let _e132 = phi_262_;
    let _e134 = params.member.member_1.member;
    let _e136 = select(_e132, _e134, (_e134 < _e132));
    let _e138 = (_e136 / 64u);
    let _e142 = select(_e138, (_e138 + 1u), ((_e136 % 64u) > 0u));
    if (_e142 > _e114) {
        let _e144 = (_e142 - _e114);
        if (_e117 == 0u) {
            return;
        }
        let _e146 = (_e144 / _e117);
        if (_e117 == 0u) {
            return;
        }
        phi_308_ = select(_e146, (_e146 + 1u), ((_e144 % _e117) > 0u));
    } else {
        phi_308_ = 0u;
    }
    let _e153 = phi_308_;
    phi_311_ = type_9(0u, _e153);
    loop {
        let _e156 = phi_311_;
        let _e159 = (_e156.member < _e156.member_1);
        let _e172 = (bitcast<i32>(select(0u, 1u, _e159)) != 0i);
        if _e172 {
            let _e176 = (((_e114 + (select(type_9().member_1, _e156.member, _e159) * _e117)) * 64u) + _e101);
            if (_e176 < _e136) {
                let _e181 = params.member.member_1.member_1;
                let _e183 = (2u * (_e181 + _e176));
                let _e186 = input.member[(4u + _e183)];
                let _e189 = input.member[(_e183 + 5u)];
                let _e194 = (_e189 & 2147483647u);
                if (select(1u, 0u, ((_e189 & 2147483648u) == 0u)) == 0u) {
                    let _e213 = params.member.member.member[1u];
                    let _e216 = ((2u * _e213) + (3u * _e194));
                    let _e218 = elements.member[_e216];
                    let _e221 = elements.member[(_e216 + 1u)];
                    let _e224 = elements.member[(_e216 + 2u)];
                    phi_486_ = type_20(0u, array<u32, 4>(_e186, _e218, _e221, _e224));
                } else {
                    let _e197 = (2u * _e186);
                    let _e199 = elements.member[_e197];
                    let _e202 = elements.member[(_e197 + 1u)];
                    let _e203 = (2u * _e194);
                    let _e205 = elements.member[_e203];
                    let _e208 = elements.member[(_e203 + 1u)];
                    phi_486_ = type_20(1u, array<u32, 4>(_e199, _e202, _e205, _e208));
                }
                let _e228 = phi_486_;
                let _e233 = paths.member[_e228.member_1[0]];
                let _e248 = paths.member[_e228.member_1[1]];
                let _e263 = paths.member[_e228.member_1[2]];
                let _e278 = paths.member[_e228.member_1[3]];
                let _e292 = params.member.member.member_4;
                if (_e228.member != 0u) {
                    phi_621_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e263.member.x - _e233.member.x), (_e263.member.y - _e233.member.y), (_e263.member.z - _e233.member.z)), array<f32, 3>((_e263.member_1.x - _e233.member_1.x), (_e263.member_1.y - _e233.member_1.y), (_e263.member_1.z - _e233.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e248.member.x - _e233.member.x), (_e248.member.y - _e233.member.y), (_e248.member.z - _e233.member.z)), array<f32, 3>((_e248.member_1.x - _e233.member_1.x), (_e248.member_1.y - _e233.member_1.y), (_e248.member_1.z - _e233.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e263.member.x - _e278.member.x), (_e263.member.y - _e278.member.y), (_e263.member.z - _e278.member.z)), array<f32, 3>((_e263.member_1.x - _e278.member_1.x), (_e263.member_1.y - _e278.member_1.y), (_e263.member_1.z - _e278.member_1.z))), (_e292 + _e292));
                } else {
                    phi_621_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e233.member.x - _e248.member.x), (_e233.member.y - _e248.member.y), (_e233.member.z - _e248.member.z)), array<f32, 3>((_e233.member_1.x - _e248.member_1.x), (_e233.member_1.y - _e248.member_1.y), (_e233.member_1.z - _e248.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e263.member.x - _e248.member.x), (_e263.member.y - _e248.member.y), (_e263.member.z - _e248.member.z)), array<f32, 3>((_e263.member_1.x - _e248.member_1.x), (_e263.member_1.y - _e248.member_1.y), (_e263.member_1.z - _e248.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e278.member.x - _e248.member.x), (_e278.member.y - _e248.member.y), (_e278.member.z - _e248.member.z)), array<f32, 3>((_e278.member_1.x - _e248.member_1.x), (_e278.member_1.y - _e248.member_1.y), (_e278.member_1.z - _e248.member_1.z))), (_e292 + _e292));
                }
                let _e353 = phi_621_;
                let _e359 = select(_e353.member[0][0], -(_e353.member[0][0]), (_e353.member[0][0] < 0f));
                let _e363 = select(_e353.member[0][1], -(_e353.member[0][1]), (_e353.member[0][1] < 0f));
                let _e365 = select(_e363, _e359, (_e359 > _e363));
                let _e369 = select(_e353.member[0][2], -(_e353.member[0][2]), (_e353.member[0][2] < 0f));
                let _e371 = select(_e369, _e365, (_e365 > _e369));
                let _e377 = select(_e353.member[1][0], -(_e353.member[1][0]), (_e353.member[1][0] < 0f));
                let _e381 = select(_e353.member[1][1], -(_e353.member[1][1]), (_e353.member[1][1] < 0f));
                let _e383 = select(_e381, _e377, (_e377 > _e381));
                let _e387 = select(_e353.member[1][2], -(_e353.member[1][2]), (_e353.member[1][2] < 0f));
                let _e389 = select(_e387, _e383, (_e383 > _e387));
                let _e399 = select(_e353.member_1[0][0], -(_e353.member_1[0][0]), (_e353.member_1[0][0] < 0f));
                let _e403 = select(_e353.member_1[0][1], -(_e353.member_1[0][1]), (_e353.member_1[0][1] < 0f));
                let _e405 = select(_e403, _e399, (_e399 > _e403));
                let _e409 = select(_e353.member_1[0][2], -(_e353.member_1[0][2]), (_e353.member_1[0][2] < 0f));
                let _e411 = select(_e409, _e405, (_e405 > _e409));
                let _e417 = select(_e353.member_1[1][0], -(_e353.member_1[1][0]), (_e353.member_1[1][0] < 0f));
                let _e421 = select(_e353.member_1[1][1], -(_e353.member_1[1][1]), (_e353.member_1[1][1] < 0f));
                let _e423 = select(_e421, _e417, (_e417 > _e421));
                let _e427 = select(_e353.member_1[1][2], -(_e353.member_1[1][2]), (_e353.member_1[1][2] < 0f));
                let _e429 = select(_e427, _e423, (_e423 > _e427));
                let _e439 = select(_e353.member_2[0][0], -(_e353.member_2[0][0]), (_e353.member_2[0][0] < 0f));
                let _e443 = select(_e353.member_2[0][1], -(_e353.member_2[0][1]), (_e353.member_2[0][1] < 0f));
                let _e445 = select(_e443, _e439, (_e439 > _e443));
                let _e449 = select(_e353.member_2[0][2], -(_e353.member_2[0][2]), (_e353.member_2[0][2] < 0f));
                let _e451 = select(_e449, _e445, (_e445 > _e449));
                let _e457 = select(_e353.member_2[1][0], -(_e353.member_2[1][0]), (_e353.member_2[1][0] < 0f));
                let _e461 = select(_e353.member_2[1][1], -(_e353.member_2[1][1]), (_e353.member_2[1][1] < 0f));
                let _e463 = select(_e461, _e457, (_e457 > _e461));
                let _e467 = select(_e353.member_2[1][2], -(_e353.member_2[1][2]), (_e353.member_2[1][2] < 0f));
                let _e469 = select(_e467, _e463, (_e463 > _e467));
                let _e474 = function_((select(_e389, _e371, (_e371 > _e389)) + _e353.member_3), (select(_e429, _e411, (_e411 > _e429)) + _e353.member_3));
                let _e475 = function_(_e474, (select(_e469, _e451, (_e451 > _e469)) + _e353.member_3));
                let _e480 = bitcast<i32>(((bitcast<u32>(_e475) + 4u) >> bitcast<u32>(23i)));
                let _e481 = (_e480 >= 64i);
                let _e482 = (_e480 <= 190i);
                let _e488 = select(select(i32(), select(i32(), (_e480 - 126i), _e482), _e481), 2147483647i, select(true, select(true, false, _e482), _e481));
                if (_e488 == 2147483647i) {
                    phi_5680_ = type_9(2u, type_9().member_1);
                } else {
                    let _e491 = params.member.member.member_1;
                    let _e493 = ((_e491 & 8u) != 0u);
                    let _e496 = params.member.member.member_10[1u];
                    let _e502 = select((_e488 - (bitcast<i32>((_e496 >> bitcast<u32>(20i))) - 1023i)), _e488, _e493);
                    phi_888_ = type_14(0i, 4i);
                    phi_891_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))));
                    phi_893_ = _e228.member_1;
                    loop {
                        let _e504 = phi_888_;
                        let _e506 = phi_891_;
                        let _e508 = phi_893_;
                        local_2 = _e506;
                        local_3 = _e506;
                        local_4 = _e506;
                        local_5 = _e506;
                        local_6 = _e506;
                        local_7 = _e506;
                        local_8 = _e506;
                        local_9 = _e506;
                        local_10 = _e506;
                        local_11 = _e506;
                        local_12 = _e506;
                        local_13 = _e506;
                        local_14 = _e506;
                        local_15 = _e506;
                        local_16 = _e506;
                        local_17 = _e506;
                        local_18 = _e506;
                        local_19 = _e506;
                        local_20 = _e506;
                        local_21 = _e506;
                        local_22 = _e506;
                        local_23 = _e506;
                        local_24 = _e506;
                        local_25 = _e506;
                        if (_e504.member < _e504.member_1) {
                            let _e515 = (_e504.member + 1i);
                            phi_889_ = type_14(select(_e515, type_15().member_1, select(false, true, ((false == (_e515 > _e504.member)) != false))), _e504.member_1);
                            phi_934_ = type_15(1u, _e504.member);
                        } else {
                            phi_889_ = _e504;
                            phi_934_ = type_15(0u, type_15().member_1);
                        }
                        let _e526 = phi_889_;
                        let _e528 = phi_934_;
                        let _e531 = (bitcast<i32>(_e528.member) != 0i);
                        if _e531 {
                            if _e493 {
                                let _e582 = paths.member[_e508[0]];
                                let _e595 = bitcast<u32>(_e582.member.x);
                                let _e596 = (_e595 & 2147483647u);
                                let _e597 = (_e596 < 8388608u);
                                let _e608 = bitcast<u32>(_e582.member.y);
                                let _e609 = (_e608 & 2147483647u);
                                let _e610 = (_e609 < 8388608u);
                                let _e621 = bitcast<u32>(_e582.member.z);
                                let _e622 = (_e621 & 2147483647u);
                                let _e623 = (_e622 < 8388608u);
                                let _e635 = bitcast<u32>(_e582.member_1.x);
                                let _e636 = (_e635 & 2147483647u);
                                let _e637 = (_e636 < 8388608u);
                                let _e648 = bitcast<u32>(_e582.member_1.y);
                                let _e649 = (_e648 & 2147483647u);
                                let _e650 = (_e649 < 8388608u);
                                let _e661 = bitcast<u32>(_e582.member_1.z);
                                let _e662 = (_e661 & 2147483647u);
                                let _e663 = (_e662 < 8388608u);
                                phi_1184_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e635 << bitcast<u32>(29i)), 0u, _e637), select(((_e635 ^ _e636) | ((_e636 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e637)), array<u32, 2>(select((_e648 << bitcast<u32>(29i)), 0u, _e650), select(((_e648 ^ _e649) | ((_e649 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e650)), array<u32, 2>(select((_e661 << bitcast<u32>(29i)), 0u, _e663), select(((_e661 ^ _e662) | ((_e662 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e663)));
                                phi_1185_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e595 << bitcast<u32>(29i)), 0u, _e597), select(((_e595 ^ _e596) | ((_e596 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e597)), array<u32, 2>(select((_e608 << bitcast<u32>(29i)), 0u, _e610), select(((_e608 ^ _e609) | ((_e609 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e610)), array<u32, 2>(select((_e621 << bitcast<u32>(29i)), 0u, _e623), select(((_e621 ^ _e622) | ((_e622 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e623)));
                            } else {
                                let _e535 = params.member.member.member[0u];
                                let _e537 = (6u * _e508[0]);
                                let _e539 = positions.member[_e537];
                                let _e542 = positions.member[(_e537 + 1u)];
                                let _e546 = positions.member[(_e537 + 2u)];
                                let _e549 = positions.member[(_e537 + 3u)];
                                let _e553 = positions.member[(_e537 + 4u)];
                                let _e556 = positions.member[(_e537 + 5u)];
                                let _e559 = (6u * (_e535 + _e508[0]));
                                let _e561 = positions.member[_e559];
                                let _e564 = positions.member[(_e559 + 1u)];
                                let _e568 = positions.member[(_e559 + 2u)];
                                let _e571 = positions.member[(_e559 + 3u)];
                                let _e575 = positions.member[(_e559 + 4u)];
                                let _e578 = positions.member[(_e559 + 5u)];
                                phi_1184_ = array<array<u32, 2>, 3>(array<u32, 2>(_e561, _e564), array<u32, 2>(_e568, _e571), array<u32, 2>(_e575, _e578));
                                phi_1185_ = array<array<u32, 2>, 3>(array<u32, 2>(_e539, _e542), array<u32, 2>(_e546, _e549), array<u32, 2>(_e553, _e556));
                            }
                            let _e676 = phi_1184_;
                            let _e678 = phi_1185_;
                            let _e685 = function_8(_e678[0], _e502);
                            let _e686 = function_8(_e678[1], _e502);
                            let _e687 = function_8(_e678[2], _e502);
                            let _e692 = function_8(_e676[0], _e502);
                            let _e693 = function_8(_e676[1], _e502);
                            let _e694 = function_8(_e676[2], _e502);
                            phi_892_ = array<array<array<type_9, 3>, 2>, 4>(_e506[1], _e506[2], _e506[3], array<array<type_9, 3>, 2>(array<type_9, 3>(_e685, _e686, _e687), array<type_9, 3>(_e692, _e693, _e694)));
                            phi_894_ = array<u32, 4>(_e508[1], _e508[2], _e508[3], _e508[0]);
                        } else {
                            phi_892_ = array<array<array<type_9, 3>, 2>, 4>();
                            phi_894_ = array<u32, 4>();
                        }
                        let _e704 = phi_892_;
                        let _e706 = phi_894_;
                        continue;
                        continuing {
                            phi_888_ = _e526;
                            phi_891_ = _e704;
                            phi_893_ = _e706;
                            break if !(_e531);
                        }
                    }
                    let _e709 = params.member.member_2.member_1;
                    let _e711 = params.member.member_2.member_2;
                    let _e713 = params.member.member_2.member_3;
                    if (_e228.member != 0u) {
                        let _e1026 = local_14;
                        let _e1030 = local_15;
                        let _e1077 = local_16;
                        let _e1081 = local_17;
                        let _e1129 = local_18;
                        let _e1133 = local_19;
                        let _e1180 = local_20;
                        let _e1184 = local_21;
                        let _e1232 = local_22;
                        let _e1236 = local_23;
                        let _e1283 = local_24;
                        let _e1287 = local_25;
                        phi_1778_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1026[2][0][0].member - _e1030[0][0][0].member) - select(0u, 1u, (_e1026[2][0][0].member_1 < _e1030[0][0][0].member_1))), (_e1026[2][0][0].member_1 - _e1030[0][0][0].member_1)), type_9(((_e1026[2][0][1].member - _e1030[0][0][1].member) - select(0u, 1u, (_e1026[2][0][1].member_1 < _e1030[0][0][1].member_1))), (_e1026[2][0][1].member_1 - _e1030[0][0][1].member_1)), type_9(((_e1026[2][0][2].member - _e1030[0][0][2].member) - select(0u, 1u, (_e1026[2][0][2].member_1 < _e1030[0][0][2].member_1))), (_e1026[2][0][2].member_1 - _e1030[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1077[2][1][0].member - _e1081[0][1][0].member) - select(0u, 1u, (_e1077[2][1][0].member_1 < _e1081[0][1][0].member_1))), (_e1077[2][1][0].member_1 - _e1081[0][1][0].member_1)), type_9(((_e1077[2][1][1].member - _e1081[0][1][1].member) - select(0u, 1u, (_e1077[2][1][1].member_1 < _e1081[0][1][1].member_1))), (_e1077[2][1][1].member_1 - _e1081[0][1][1].member_1)), type_9(((_e1077[2][1][2].member - _e1081[0][1][2].member) - select(0u, 1u, (_e1077[2][1][2].member_1 < _e1081[0][1][2].member_1))), (_e1077[2][1][2].member_1 - _e1081[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1129[1][0][0].member - _e1133[0][0][0].member) - select(0u, 1u, (_e1129[1][0][0].member_1 < _e1133[0][0][0].member_1))), (_e1129[1][0][0].member_1 - _e1133[0][0][0].member_1)), type_9(((_e1129[1][0][1].member - _e1133[0][0][1].member) - select(0u, 1u, (_e1129[1][0][1].member_1 < _e1133[0][0][1].member_1))), (_e1129[1][0][1].member_1 - _e1133[0][0][1].member_1)), type_9(((_e1129[1][0][2].member - _e1133[0][0][2].member) - select(0u, 1u, (_e1129[1][0][2].member_1 < _e1133[0][0][2].member_1))), (_e1129[1][0][2].member_1 - _e1133[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1180[1][1][0].member - _e1184[0][1][0].member) - select(0u, 1u, (_e1180[1][1][0].member_1 < _e1184[0][1][0].member_1))), (_e1180[1][1][0].member_1 - _e1184[0][1][0].member_1)), type_9(((_e1180[1][1][1].member - _e1184[0][1][1].member) - select(0u, 1u, (_e1180[1][1][1].member_1 < _e1184[0][1][1].member_1))), (_e1180[1][1][1].member_1 - _e1184[0][1][1].member_1)), type_9(((_e1180[1][1][2].member - _e1184[0][1][2].member) - select(0u, 1u, (_e1180[1][1][2].member_1 < _e1184[0][1][2].member_1))), (_e1180[1][1][2].member_1 - _e1184[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1232[2][0][0].member - _e1236[3][0][0].member) - select(0u, 1u, (_e1232[2][0][0].member_1 < _e1236[3][0][0].member_1))), (_e1232[2][0][0].member_1 - _e1236[3][0][0].member_1)), type_9(((_e1232[2][0][1].member - _e1236[3][0][1].member) - select(0u, 1u, (_e1232[2][0][1].member_1 < _e1236[3][0][1].member_1))), (_e1232[2][0][1].member_1 - _e1236[3][0][1].member_1)), type_9(((_e1232[2][0][2].member - _e1236[3][0][2].member) - select(0u, 1u, (_e1232[2][0][2].member_1 < _e1236[3][0][2].member_1))), (_e1232[2][0][2].member_1 - _e1236[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1283[2][1][0].member - _e1287[3][1][0].member) - select(0u, 1u, (_e1283[2][1][0].member_1 < _e1287[3][1][0].member_1))), (_e1283[2][1][0].member_1 - _e1287[3][1][0].member_1)), type_9(((_e1283[2][1][1].member - _e1287[3][1][1].member) - select(0u, 1u, (_e1283[2][1][1].member_1 < _e1287[3][1][1].member_1))), (_e1283[2][1][1].member_1 - _e1287[3][1][1].member_1)), type_9(((_e1283[2][1][2].member - _e1287[3][1][2].member) - select(0u, 1u, (_e1283[2][1][2].member_1 < _e1287[3][1][2].member_1))), (_e1283[2][1][2].member_1 - _e1287[3][1][2].member_1)))));
                    } else {
                        let _e716 = local_2;
                        let _e720 = local_3;
                        let _e767 = local_4;
                        let _e771 = local_5;
                        let _e819 = local_6;
                        let _e823 = local_7;
                        let _e870 = local_8;
                        let _e874 = local_9;
                        let _e922 = local_10;
                        let _e926 = local_11;
                        let _e973 = local_12;
                        let _e977 = local_13;
                        phi_1778_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e716[0][0][0].member - _e720[1][0][0].member) - select(0u, 1u, (_e716[0][0][0].member_1 < _e720[1][0][0].member_1))), (_e716[0][0][0].member_1 - _e720[1][0][0].member_1)), type_9(((_e716[0][0][1].member - _e720[1][0][1].member) - select(0u, 1u, (_e716[0][0][1].member_1 < _e720[1][0][1].member_1))), (_e716[0][0][1].member_1 - _e720[1][0][1].member_1)), type_9(((_e716[0][0][2].member - _e720[1][0][2].member) - select(0u, 1u, (_e716[0][0][2].member_1 < _e720[1][0][2].member_1))), (_e716[0][0][2].member_1 - _e720[1][0][2].member_1))), array<type_9, 3>(type_9(((_e767[0][1][0].member - _e771[1][1][0].member) - select(0u, 1u, (_e767[0][1][0].member_1 < _e771[1][1][0].member_1))), (_e767[0][1][0].member_1 - _e771[1][1][0].member_1)), type_9(((_e767[0][1][1].member - _e771[1][1][1].member) - select(0u, 1u, (_e767[0][1][1].member_1 < _e771[1][1][1].member_1))), (_e767[0][1][1].member_1 - _e771[1][1][1].member_1)), type_9(((_e767[0][1][2].member - _e771[1][1][2].member) - select(0u, 1u, (_e767[0][1][2].member_1 < _e771[1][1][2].member_1))), (_e767[0][1][2].member_1 - _e771[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e819[2][0][0].member - _e823[1][0][0].member) - select(0u, 1u, (_e819[2][0][0].member_1 < _e823[1][0][0].member_1))), (_e819[2][0][0].member_1 - _e823[1][0][0].member_1)), type_9(((_e819[2][0][1].member - _e823[1][0][1].member) - select(0u, 1u, (_e819[2][0][1].member_1 < _e823[1][0][1].member_1))), (_e819[2][0][1].member_1 - _e823[1][0][1].member_1)), type_9(((_e819[2][0][2].member - _e823[1][0][2].member) - select(0u, 1u, (_e819[2][0][2].member_1 < _e823[1][0][2].member_1))), (_e819[2][0][2].member_1 - _e823[1][0][2].member_1))), array<type_9, 3>(type_9(((_e870[2][1][0].member - _e874[1][1][0].member) - select(0u, 1u, (_e870[2][1][0].member_1 < _e874[1][1][0].member_1))), (_e870[2][1][0].member_1 - _e874[1][1][0].member_1)), type_9(((_e870[2][1][1].member - _e874[1][1][1].member) - select(0u, 1u, (_e870[2][1][1].member_1 < _e874[1][1][1].member_1))), (_e870[2][1][1].member_1 - _e874[1][1][1].member_1)), type_9(((_e870[2][1][2].member - _e874[1][1][2].member) - select(0u, 1u, (_e870[2][1][2].member_1 < _e874[1][1][2].member_1))), (_e870[2][1][2].member_1 - _e874[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e922[3][0][0].member - _e926[1][0][0].member) - select(0u, 1u, (_e922[3][0][0].member_1 < _e926[1][0][0].member_1))), (_e922[3][0][0].member_1 - _e926[1][0][0].member_1)), type_9(((_e922[3][0][1].member - _e926[1][0][1].member) - select(0u, 1u, (_e922[3][0][1].member_1 < _e926[1][0][1].member_1))), (_e922[3][0][1].member_1 - _e926[1][0][1].member_1)), type_9(((_e922[3][0][2].member - _e926[1][0][2].member) - select(0u, 1u, (_e922[3][0][2].member_1 < _e926[1][0][2].member_1))), (_e922[3][0][2].member_1 - _e926[1][0][2].member_1))), array<type_9, 3>(type_9(((_e973[3][1][0].member - _e977[1][1][0].member) - select(0u, 1u, (_e973[3][1][0].member_1 < _e977[1][1][0].member_1))), (_e973[3][1][0].member_1 - _e977[1][1][0].member_1)), type_9(((_e973[3][1][1].member - _e977[1][1][1].member) - select(0u, 1u, (_e973[3][1][1].member_1 < _e977[1][1][1].member_1))), (_e973[3][1][1].member_1 - _e977[1][1][1].member_1)), type_9(((_e973[3][1][2].member - _e977[1][1][2].member) - select(0u, 1u, (_e973[3][1][2].member_1 < _e977[1][1][2].member_1))), (_e973[3][1][2].member_1 - _e977[1][1][2].member_1)))));
                    }
                    let _e1336 = phi_1778_;
                    phi_1792_ = type_14(0i, 3i);
                    phi_1795_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                    phi_1797_ = _e1336[2];
                    phi_1799_ = _e1336[1];
                    phi_1801_ = _e1336[0];
                    loop {
                        let _e1341 = phi_1792_;
                        let _e1343 = phi_1795_;
                        let _e1345 = phi_1797_;
                        let _e1347 = phi_1799_;
                        let _e1349 = phi_1801_;
                        local_26 = _e1343;
                        local_27 = _e1343;
                        local_28 = _e1343;
                        local_29 = _e1343;
                        local_30 = _e1343;
                        local_31 = _e1343;
                        local_32 = _e1343;
                        local_33 = _e1343;
                        local_34 = _e1343;
                        local_35 = _e1343;
                        local_36 = _e1343;
                        local_37 = _e1343;
                        if (_e1341.member < _e1341.member_1) {
                            let _e1356 = (_e1341.member + 1i);
                            phi_1793_ = type_14(select(_e1356, type_15().member_1, select(false, true, ((false == (_e1356 > _e1341.member)) != false))), _e1341.member_1);
                            phi_1842_ = type_15(1u, _e1341.member);
                        } else {
                            phi_1793_ = _e1341;
                            phi_1842_ = type_15(0u, type_15().member_1);
                        }
                        let _e1367 = phi_1793_;
                        let _e1369 = phi_1842_;
                        let _e1372 = (bitcast<i32>(_e1369.member) != 0i);
                        if _e1372 {
                            let _e1391 = function_7(_e1347[0][1].member, _e1347[0][1].member_1, _e1345[0][2].member, _e1345[0][2].member_1);
                            let _e1394 = function_7(_e1347[0][2].member, _e1347[0][2].member_1, _e1345[0][1].member, _e1345[0][1].member_1);
                            let _e1400 = ((_e1391.member - _e1394.member) - select(0u, 1u, (_e1391.member_1 < _e1394.member_1)));
                            let _e1401 = (_e1391.member_1 - _e1394.member_1);
                            let _e1420 = function_7(_e1347[1][1].member, _e1347[1][1].member_1, _e1345[1][2].member, _e1345[1][2].member_1);
                            let _e1423 = function_7(_e1347[1][2].member, _e1347[1][2].member_1, _e1345[1][1].member, _e1345[1][1].member_1);
                            let _e1429 = ((_e1420.member - _e1423.member) - select(0u, 1u, (_e1420.member_1 < _e1423.member_1)));
                            let _e1430 = (_e1420.member_1 - _e1423.member_1);
                            let _e1449 = function_7(_e1347[0][1].member, _e1347[0][1].member_1, _e1345[1][2].member, _e1345[1][2].member_1);
                            let _e1452 = function_7(_e1347[0][2].member, _e1347[0][2].member_1, _e1345[1][1].member, _e1345[1][1].member_1);
                            let _e1459 = (_e1449.member_1 - _e1452.member_1);
                            let _e1478 = function_7(_e1347[1][1].member, _e1347[1][1].member_1, _e1345[0][2].member, _e1345[0][2].member_1);
                            let _e1481 = function_7(_e1347[1][2].member, _e1347[1][2].member_1, _e1345[0][1].member, _e1345[0][1].member_1);
                            let _e1489 = (_e1459 + (_e1478.member_1 - _e1481.member_1));
                            let _e1493 = ((((_e1449.member - _e1452.member) - select(0u, 1u, (_e1449.member_1 < _e1452.member_1))) + ((_e1478.member - _e1481.member) - select(0u, 1u, (_e1478.member_1 < _e1481.member_1)))) + select(0u, 1u, (_e1489 < _e1459)));
                            let _e1510 = function_7(_e1349[0][0].member, _e1349[0][0].member_1, _e1400, _e1401);
                            let _e1513 = (_e1343[0].member_1 + _e1510.member_1);
                            let _e1523 = function_7(_e1349[1][0].member, _e1349[1][0].member_1, _e1400, _e1401);
                            let _e1526 = (_e1343[1].member_1 + _e1523.member_1);
                            let _e1531 = function_7(_e1349[0][0].member, _e1349[0][0].member_1, _e1493, _e1489);
                            let _e1534 = (_e1526 + _e1531.member_1);
                            let _e1544 = function_7(_e1349[0][0].member, _e1349[0][0].member_1, _e1429, _e1430);
                            let _e1547 = (_e1343[2].member_1 + _e1544.member_1);
                            let _e1552 = function_7(_e1349[1][0].member, _e1349[1][0].member_1, _e1493, _e1489);
                            let _e1555 = (_e1547 + _e1552.member_1);
                            let _e1565 = function_7(_e1349[1][0].member, _e1349[1][0].member_1, _e1429, _e1430);
                            let _e1568 = (_e1343[3].member_1 + _e1565.member_1);
                            phi_1796_ = array<type_9, 4>(type_9(((_e1343[0].member + _e1510.member) + select(0u, 1u, (_e1513 < _e1343[0].member_1))), _e1513), type_9(((((_e1343[1].member + _e1523.member) + select(0u, 1u, (_e1526 < _e1343[1].member_1))) + _e1531.member) + select(0u, 1u, (_e1534 < _e1526))), _e1534), type_9(((((_e1343[2].member + _e1544.member) + select(0u, 1u, (_e1547 < _e1343[2].member_1))) + _e1552.member) + select(0u, 1u, (_e1555 < _e1547))), _e1555), type_9(((_e1343[3].member + _e1565.member) + select(0u, 1u, (_e1568 < _e1343[3].member_1))), _e1568));
                            phi_1798_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1345[0][1], _e1345[0][2], _e1345[0][0]), array<type_9, 3>(_e1345[1][1], _e1345[1][2], _e1345[1][0]));
                            phi_1800_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1347[0][1], _e1347[0][2], _e1347[0][0]), array<type_9, 3>(_e1347[1][1], _e1347[1][2], _e1347[1][0]));
                            phi_1802_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1349[0][1], _e1349[0][2], _e1349[0][0]), array<type_9, 3>(_e1349[1][1], _e1349[1][2], _e1349[1][0]));
                        } else {
                            phi_1796_ = array<type_9, 4>();
                            phi_1798_ = array<array<type_9, 3>, 2>();
                            phi_1800_ = array<array<type_9, 3>, 2>();
                            phi_1802_ = array<array<type_9, 3>, 2>();
                        }
                        let _e1609 = phi_1796_;
                        let _e1611 = phi_1798_;
                        let _e1613 = phi_1800_;
                        let _e1615 = phi_1802_;
                        continue;
                        continuing {
                            phi_1792_ = _e1367;
                            phi_1795_ = _e1609;
                            phi_1797_ = _e1611;
                            phi_1799_ = _e1613;
                            phi_1801_ = _e1615;
                            break if !(_e1372);
                        }
                    }
                    let _e1618 = local_26;
                    let _e1622 = local_27;
                    let _e1625 = function_6(_e1618[0].member, _e1622[0].member_1);
                    let _e1629 = local_28;
                    let _e1633 = local_29;
                    let _e1637 = local_30;
                    let _e1641 = local_31;
                    let _e1645 = local_32;
                    let _e1649 = local_33;
                    let _e1652 = function_6(_e1645[3].member, _e1649[3].member_1);
                    let _e1656 = local_34;
                    let _e1659 = local_35;
                    let _e1666 = select((bitcast<u32>(31i) - firstLeadingBit(_e713)), 32u, (_e713 == 0u));
                    let _e1668 = select(18u, _e1666, (18u < _e1666));
                    let _e1669 = function_1(128u);
                    let _e1674 = ((_e1625.member >> bitcast<u32>(31i)) != 0u);
                    let _e1697 = function_1(128u);
                    let _e1702 = ((_e1629[1].member >> bitcast<u32>(31i)) != 0u);
                    let _e1710 = local_36;
                    let _e1731 = function_1(128u);
                    let _e1736 = ((_e1637[2].member >> bitcast<u32>(31i)) != 0u);
                    let _e1744 = local_37;
                    let _e1765 = function_1(128u);
                    let _e1770 = ((_e1652.member >> bitcast<u32>(31i)) != 0u);
                    phi_2395_ = (((select(0u, select(1u, 2u, ((_e1625.member >> bitcast<u32>(31i)) != 0u)), ((((_e1669.member - select(_e1625.member, (~(_e1625.member) + select(0u, 1u, (_e1625.member_1 == 0u))), _e1674)) - select(0u, 1u, (_e1669.member_1 < select(_e1625.member_1, (~(_e1625.member_1) + 1u), _e1674)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e1629[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1697.member - select(_e1710[1].member, (~(_e1629[1].member) + select(0u, 1u, (_e1633[1].member_1 == 0u))), _e1702)) - select(0u, 1u, (_e1697.member_1 < select(_e1710[1].member_1, (~(_e1633[1].member_1) + 1u), _e1702)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1637[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1731.member - select(_e1744[2].member, (~(_e1637[2].member) + select(0u, 1u, (_e1641[2].member_1 == 0u))), _e1736)) - select(0u, 1u, (_e1731.member_1 < select(_e1744[2].member_1, (~(_e1641[2].member_1) + 1u), _e1736)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e1652.member >> bitcast<u32>(31i)) != 0u)), ((((_e1765.member - select(_e1652.member, (~(_e1652.member) + select(0u, 1u, (_e1652.member_1 == 0u))), _e1770)) - select(0u, 1u, (_e1765.member_1 < select(_e1652.member_1, (~(_e1652.member_1) + 1u), _e1770)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                    phi_2398_ = array<type_9, 4>(_e1625, _e1656[1], _e1659[2], _e1652);
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
                        let _e1797 = phi_2395_;
                        let _e1799 = phi_2398_;
                        let _e1801 = phi_2400_;
                        let _e1803 = phi_2402_;
                        let _e1805 = phi_2404_;
                        let _e1807 = phi_2406_;
                        let _e1809 = phi_2408_;
                        let _e1811 = phi_2410_;
                        let _e1813 = phi_2412_;
                        let _e1815 = phi_2414_;
                        let _e1817 = phi_2416_;
                        let _e1819 = phi_2418_;
                        if (_e1815 < 64u) {
                            phi_2427_ = _e1797;
                            phi_2430_ = _e1799;
                            phi_2432_ = _e1805;
                            phi_2434_ = _e1807;
                            phi_2436_ = _e1801;
                            phi_2438_ = false;
                            phi_2440_ = false;
                            phi_2442_ = false;
                            phi_2444_ = _e1811;
                            phi_2446_ = _e1813;
                            phi_2448_ = _e1815;
                            phi_2450_ = _e1817;
                            phi_2452_ = _e1819;
                            loop {
                                let _e1822 = phi_2427_;
                                let _e1824 = phi_2430_;
                                let _e1826 = phi_2432_;
                                let _e1828 = phi_2434_;
                                let _e1830 = phi_2436_;
                                let _e1832 = phi_2438_;
                                let _e1834 = phi_2440_;
                                let _e1836 = phi_2442_;
                                let _e1838 = phi_2444_;
                                let _e1840 = phi_2446_;
                                let _e1842 = phi_2448_;
                                let _e1844 = phi_2450_;
                                let _e1846 = phi_2452_;
                                local_38 = _e1830;
                                local_39 = _e1836;
                                local_40 = _e1844;
                                local_41 = _e1822;
                                local_42 = _e1840;
                                local_43 = _e1838;
                                local_44 = _e1844;
                                local_45 = _e1822;
                                local_46 = _e1822;
                                local_47 = _e1844;
                                local_48 = _e1834;
                                local_49 = _e1832;
                                local_50 = _e1844;
                                local_51 = _e1822;
                                local_52 = _e1832;
                                local_53 = _e1832;
                                local_54 = _e1832;
                                local_55 = _e1832;
                                local_56 = _e1840;
                                local_57 = _e1840;
                                local_58 = _e1840;
                                local_59 = _e1838;
                                local_60 = _e1824;
                                local_61 = _e1824;
                                local_62 = _e1824;
                                local_63 = _e1824;
                                local_64 = _e1824;
                                local_65 = _e1824;
                                local_66 = _e1824;
                                local_67 = _e1824;
                                local_70 = _e1840;
                                local_71 = _e1840;
                                local_72 = _e1822;
                                local_74 = _e1832;
                                local_108 = _e1836;
                                local_109 = _e1826;
                                local_110 = _e1828;
                                local_111 = _e1836;
                                local_112 = _e1826;
                                local_113 = _e1828;
                                local_114 = _e1836;
                                local_75 = _e1846;
                                local_76 = _e1846;
                                local_77 = _e1844;
                                local_78 = _e1844;
                                local_79 = _e1844;
                                local_80 = _e1840;
                                local_115 = _e1844;
                                local_116 = _e1846;
                                local_117 = _e1822;
                                local_119 = _e1824;
                                local_120 = _e1838;
                                local_121 = _e1840;
                                local_122 = _e1842;
                                if (_e1842 < 64u) {
                                    if _e1836 {
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
                                        if _e1830 {
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
                                            let _e1849 = (31u - _e1844);
                                            let _e1852 = (_e1846 << bitcast<u32>((_e1849 & 31u)));
                                            let _e1856 = ((_e1846 + 1u) << bitcast<u32>((_e1849 & 31u)));
                                            let _e1857 = (_e1852 > _e711);
                                            let _e1858 = (_e1856 < _e709);
                                            let _e1865 = select(select(select(select((_e1822 == 170u), true, (_e1822 == 85u)), bool(), _e1858), bool(), _e1857), true, select(_e1858, true, _e1857));
                                            let _e1869 = select((_e1822 ^ 255u), _e1822, ((_e1822 & 3u) == 1u));
                                            let _e1870 = (_e1869 == 149u);
                                            let _e1871 = (_e1869 == 165u);
                                            let _e1876 = select(select(select((_e1869 == 169u), bool(), _e1871), bool(), _e1870), true, select(_e1871, true, _e1870));
                                            let _e1880 = select(false, (_e1852 >= _e709), ((_e1822 & 3u) == 0u));
                                            let _e1881 = (_e1844 == 3u);
                                            let _e1882 = (_e1844 == 8u);
                                            let _e1887 = select(select(select((_e1844 == 14u), bool(), _e1882), bool(), _e1881), true, select(_e1882, true, _e1881));
                                            let _e1889 = select(false, !(_e1826), _e1880);
                                            let _e1890 = (_e1844 == 31u);
                                            let _e1901 = select(select(false, !(_e1828), select(select(select(select(select(false, !(_e1803), _e1876), bool(), _e1880), bool(), _e1887), bool(), _e1890), true, select(select(_e1880, true, _e1887), true, _e1890))), true, _e1889);
                                            if _e1865 {
                                                phi_3111_ = _e1822;
                                                phi_3112_ = _e1824;
                                                phi_3113_ = _e1826;
                                                phi_3114_ = _e1828;
                                                phi_3115_ = _e1844;
                                                phi_3116_ = _e1846;
                                            } else {
                                                if _e1901 {
                                                    phi_3105_ = _e1822;
                                                    phi_3106_ = _e1824;
                                                    phi_3107_ = _e1826;
                                                    phi_3108_ = _e1828;
                                                    phi_3109_ = _e1844;
                                                    phi_3110_ = _e1846;
                                                } else {
                                                    let _e1910 = (_e1824[0].member_1 + _e1824[1].member_1);
                                                    let _e1914 = ((_e1824[0].member + _e1824[1].member) + select(0u, 1u, (_e1910 < _e1824[0].member_1)));
                                                    let _e1922 = bitcast<u32>((bitcast<i32>(_e1914) >> bitcast<u32>(1u)));
                                                    let _e1925 = ((_e1910 >> bitcast<u32>(1u)) | ((_e1914 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1934 = (_e1824[1].member_1 + _e1824[2].member_1);
                                                    let _e1938 = ((_e1824[1].member + _e1824[2].member) + select(0u, 1u, (_e1934 < _e1824[1].member_1)));
                                                    let _e1946 = bitcast<u32>((bitcast<i32>(_e1938) >> bitcast<u32>(1u)));
                                                    let _e1949 = ((_e1934 >> bitcast<u32>(1u)) | ((_e1938 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1958 = (_e1824[2].member_1 + _e1824[3].member_1);
                                                    let _e1962 = ((_e1824[2].member + _e1824[3].member) + select(0u, 1u, (_e1958 < _e1824[2].member_1)));
                                                    let _e1970 = bitcast<u32>((bitcast<i32>(_e1962) >> bitcast<u32>(1u)));
                                                    let _e1973 = ((_e1958 >> bitcast<u32>(1u)) | ((_e1962 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1974 = (_e1925 + _e1949);
                                                    let _e1978 = ((_e1922 + _e1946) + select(0u, 1u, (_e1974 < _e1925)));
                                                    let _e1986 = bitcast<u32>((bitcast<i32>(_e1978) >> bitcast<u32>(1u)));
                                                    let _e1989 = ((_e1974 >> bitcast<u32>(1u)) | ((_e1978 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e1990 = (_e1949 + _e1973);
                                                    let _e1994 = ((_e1946 + _e1970) + select(0u, 1u, (_e1990 < _e1949)));
                                                    let _e2002 = bitcast<u32>((bitcast<i32>(_e1994) >> bitcast<u32>(1u)));
                                                    let _e2005 = ((_e1990 >> bitcast<u32>(1u)) | ((_e1994 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2006 = (_e1989 + _e2005);
                                                    let _e2010 = ((_e1986 + _e2002) + select(0u, 1u, (_e2006 < _e1989)));
                                                    let _e2018 = bitcast<u32>((bitcast<i32>(_e2010) >> bitcast<u32>(1u)));
                                                    let _e2021 = ((_e2006 >> bitcast<u32>(1u)) | ((_e2010 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2022 = (2u * _e1846);
                                                    let _e2037 = function_1(128u);
                                                    let _e2042 = ((_e1824[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2066 = function_1(128u);
                                                    let _e2071 = ((_e1922 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2095 = function_1(128u);
                                                    let _e2100 = ((_e1986 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2124 = function_1(128u);
                                                    let _e2129 = ((_e2018 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2152 = (((select(0u, select(1u, 2u, ((_e1824[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2037.member - select(_e1824[0].member, (~(_e1824[0].member) + select(0u, 1u, (_e1824[0].member_1 == 0u))), _e2042)) - select(0u, 1u, (_e2037.member_1 < select(_e1824[0].member_1, (~(_e1824[0].member_1) + 1u), _e2042)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e1922 >> bitcast<u32>(31i)) != 0u)), ((((_e2066.member - select(_e1922, (~(_e1922) + select(0u, 1u, (_e1925 == 0u))), _e2071)) - select(0u, 1u, (_e2066.member_1 < select(_e1925, (~(_e1925) + 1u), _e2071)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1986 >> bitcast<u32>(31i)) != 0u)), ((((_e2095.member - select(_e1986, (~(_e1986) + select(0u, 1u, (_e1989 == 0u))), _e2100)) - select(0u, 1u, (_e2095.member_1 < select(_e1989, (~(_e1989) + 1u), _e2100)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e2018 >> bitcast<u32>(31i)) != 0u)), ((((_e2124.member - select(_e2018, (~(_e2018) + select(0u, 1u, (_e2021 == 0u))), _e2129)) - select(0u, 1u, (_e2124.member_1 < select(_e2021, (~(_e2021) + 1u), _e2129)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                                    if select((_e2152 == 170u), true, (_e2152 == 85u)) {
                                                        let _e2162 = function_1(128u);
                                                        let _e2167 = ((_e2018 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2188 = function_1(128u);
                                                        let _e2193 = ((_e2002 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2217 = function_1(128u);
                                                        let _e2222 = ((_e1970 >> bitcast<u32>(31i)) != 0u);
                                                        let _e2246 = function_1(128u);
                                                        let _e2251 = ((_e1824[3].member >> bitcast<u32>(31i)) != 0u);
                                                        phi_3101_ = (((select(0u, select(1u, 2u, ((_e2018 >> bitcast<u32>(31i)) != 0u)), ((((_e2162.member - select(_e2018, (~(_e2018) + select(0u, 1u, (_e2021 == 0u))), _e2167)) - select(0u, 1u, (_e2162.member_1 < select(_e2021, (~(_e2021) + 1u), _e2167)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e2002 >> bitcast<u32>(31i)) != 0u)), ((((_e2188.member - select(_e2002, (~(_e2002) + select(0u, 1u, (_e2005 == 0u))), _e2193)) - select(0u, 1u, (_e2188.member_1 < select(_e2005, (~(_e2005) + 1u), _e2193)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e1970 >> bitcast<u32>(31i)) != 0u)), ((((_e2217.member - select(_e1970, (~(_e1970) + select(0u, 1u, (_e1973 == 0u))), _e2222)) - select(0u, 1u, (_e2217.member_1 < select(_e1973, (~(_e1973) + 1u), _e2222)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e1824[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2246.member - select(_e1824[3].member, (~(_e1824[3].member) + select(0u, 1u, (_e1824[3].member_1 == 0u))), _e2251)) - select(0u, 1u, (_e2246.member_1 < select(_e1824[3].member_1, (~(_e1824[3].member_1) + 1u), _e2251)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                                        phi_3102_ = array<type_9, 4>(type_9(_e2018, _e2021), type_9(_e2002, _e2005), type_9(_e1970, _e1973), _e1824[3]);
                                                        phi_3103_ = false;
                                                        phi_3104_ = (_e2022 + 1u);
                                                    } else {
                                                        phi_3101_ = _e2152;
                                                        phi_3102_ = array<type_9, 4>(_e1824[0], type_9(_e1922, _e1925), type_9(_e1986, _e1989), type_9(_e2018, _e2021));
                                                        phi_3103_ = _e1826;
                                                        phi_3104_ = _e2022;
                                                    }
                                                    let _e2279 = phi_3101_;
                                                    let _e2281 = phi_3102_;
                                                    let _e2283 = phi_3103_;
                                                    let _e2285 = phi_3104_;
                                                    phi_3105_ = _e2279;
                                                    phi_3106_ = _e2281;
                                                    phi_3107_ = _e2283;
                                                    phi_3108_ = false;
                                                    phi_3109_ = (_e1844 + 1u);
                                                    phi_3110_ = _e2285;
                                                }
                                                let _e2287 = phi_3105_;
                                                let _e2289 = phi_3106_;
                                                let _e2291 = phi_3107_;
                                                let _e2293 = phi_3108_;
                                                let _e2295 = phi_3109_;
                                                let _e2297 = phi_3110_;
                                                phi_3111_ = _e2287;
                                                phi_3112_ = _e2289;
                                                phi_3113_ = _e2291;
                                                phi_3114_ = _e2293;
                                                phi_3115_ = _e2295;
                                                phi_3116_ = _e2297;
                                            }
                                            let _e2299 = phi_3111_;
                                            let _e2301 = phi_3112_;
                                            let _e2303 = phi_3113_;
                                            let _e2305 = phi_3114_;
                                            let _e2307 = phi_3115_;
                                            let _e2309 = phi_3116_;
                                            phi_3117_ = _e2299;
                                            phi_3118_ = _e2301;
                                            phi_3119_ = _e2303;
                                            phi_3120_ = _e2305;
                                            phi_3121_ = _e1901;
                                            phi_3122_ = _e1889;
                                            phi_3123_ = _e1876;
                                            phi_3124_ = _e1865;
                                            phi_3125_ = _e1856;
                                            phi_3126_ = _e1852;
                                            phi_3127_ = (_e1842 + 1u);
                                            phi_3128_ = _e2307;
                                            phi_3129_ = _e2309;
                                            phi_3130_ = true;
                                        }
                                        let _e2311 = phi_3117_;
                                        let _e2313 = phi_3118_;
                                        let _e2315 = phi_3119_;
                                        let _e2317 = phi_3120_;
                                        let _e2319 = phi_3121_;
                                        let _e2321 = phi_3122_;
                                        let _e2323 = phi_3123_;
                                        let _e2325 = phi_3124_;
                                        let _e2327 = phi_3125_;
                                        let _e2329 = phi_3126_;
                                        let _e2331 = phi_3127_;
                                        let _e2333 = phi_3128_;
                                        let _e2335 = phi_3129_;
                                        let _e2337 = phi_3130_;
                                        phi_3131_ = _e2311;
                                        phi_3132_ = _e2313;
                                        phi_3133_ = _e2315;
                                        phi_3134_ = _e2317;
                                        phi_3135_ = _e2319;
                                        phi_3136_ = _e2321;
                                        phi_3137_ = _e2323;
                                        phi_3138_ = _e2325;
                                        phi_3139_ = _e2327;
                                        phi_3140_ = _e2329;
                                        phi_3141_ = _e2331;
                                        phi_3142_ = _e2333;
                                        phi_3143_ = _e2335;
                                        phi_3144_ = _e2337;
                                    }
                                    let _e2339 = phi_3131_;
                                    let _e2341 = phi_3132_;
                                    let _e2343 = phi_3133_;
                                    let _e2345 = phi_3134_;
                                    let _e2347 = phi_3135_;
                                    let _e2349 = phi_3136_;
                                    let _e2351 = phi_3137_;
                                    let _e2353 = phi_3138_;
                                    let _e2355 = phi_3139_;
                                    let _e2357 = phi_3140_;
                                    let _e2359 = phi_3141_;
                                    let _e2361 = phi_3142_;
                                    let _e2363 = phi_3143_;
                                    let _e2365 = phi_3144_;
                                    phi_2428_ = _e2339;
                                    phi_2431_ = _e2341;
                                    phi_2433_ = _e2343;
                                    phi_2435_ = _e2345;
                                    phi_2437_ = _e2347;
                                    phi_2439_ = _e2349;
                                    phi_2441_ = _e2351;
                                    phi_2443_ = _e2353;
                                    phi_2445_ = _e2355;
                                    phi_2447_ = _e2357;
                                    phi_2449_ = _e2359;
                                    phi_2451_ = _e2361;
                                    phi_2453_ = _e2363;
                                    phi_3145_ = _e2365;
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
                                let _e2367 = phi_2428_;
                                let _e2369 = phi_2431_;
                                let _e2371 = phi_2433_;
                                let _e2373 = phi_2435_;
                                let _e2375 = phi_2437_;
                                let _e2377 = phi_2439_;
                                let _e2379 = phi_2441_;
                                let _e2381 = phi_2443_;
                                let _e2383 = phi_2445_;
                                let _e2385 = phi_2447_;
                                let _e2387 = phi_2449_;
                                let _e2389 = phi_2451_;
                                let _e2391 = phi_2453_;
                                let _e2393 = phi_3145_;
                                continue;
                                continuing {
                                    phi_2427_ = _e2367;
                                    phi_2430_ = _e2369;
                                    phi_2432_ = _e2371;
                                    phi_2434_ = _e2373;
                                    phi_2436_ = _e2375;
                                    phi_2438_ = _e2377;
                                    phi_2440_ = _e2379;
                                    phi_2442_ = _e2381;
                                    phi_2444_ = _e2383;
                                    phi_2446_ = _e2385;
                                    phi_2448_ = _e2387;
                                    phi_2450_ = _e2389;
                                    phi_2452_ = _e2391;
                                    break if !(_e2393);
                                }
                            }
                            let _e2396 = local_38;
                            if _e2396 {
                                let _e2398 = local_39;
                                if _e2398 {
                                    phi_5081_ = _e1801;
                                    phi_5082_ = _e1803;
                                    let _e4855 = local_109;
                                    phi_5083_ = _e4855;
                                    let _e4858 = local_110;
                                    phi_5084_ = _e4858;
                                    phi_5085_ = _e1809;
                                    let _e4862 = local_111;
                                    phi_5086_ = _e4862;
                                    phi_5087_ = bool();
                                    phi_5088_ = type_17();
                                    phi_5089_ = true;
                                    phi_5090_ = false;
                                    phi_5091_ = false;
                                    phi_5092_ = false;
                                } else {
                                    let _e2400 = local_40;
                                    let _e2401 = (_e2400 == 31u);
                                    let _e2403 = local_41;
                                    let _e2410 = local_42;
                                    let _e2412 = local_43;
                                    let _e2414 = local_44;
                                    let _e2415 = type_17(_e2410, _e2412, _e2414);
                                    let _e2417 = local_45;
                                    let _e2420 = local_46;
                                    let _e2424 = (((_e2417 & 3u) | (_e2420 >> bitcast<u32>(6i))) == 3u);
                                    let _e2426 = local_47;
                                    let _e2429 = local_48;
                                    let _e2433 = local_49;
                                    let _e2434 = select(select(select(false, (_e2426 < _e1668), _e2429), true, _e1801), false, _e2433);
                                    let _e2436 = local_50;
                                    let _e2437 = (_e2436 == 31u);
                                    let _e2439 = local_51;
                                    let _e2448 = local_52;
                                    let _e2451 = local_53;
                                    let _e2453 = select(select(select(select(bool(), select(((_e2439 & 3u) != 0u), bool(), _e2424), _e2437), bool(), _e2434), bool(), _e2448), false, select(select(select(true, _e2424, _e2437), true, _e2434), true, _e2451));
                                    let _e2455 = local_54;
                                    let _e2458 = local_55;
                                    if _e2458 {
                                        let _e2636 = local_70;
                                        let _e2639 = local_71;
                                        phi_3406_ = _e1803;
                                        phi_3407_ = type_17(_e2639, (_e2636 + 1u), 31u);
                                        phi_3408_ = _e1809;
                                    } else {
                                        if _e2434 {
                                            let _e2476 = select(_e1668, 31u, _e1801);
                                            let _e2479 = local_58;
                                            let _e2480 = select(_e2479, _e1809.member, _e1801);
                                            let _e2483 = local_59;
                                            let _e2484 = select(_e2483, _e1809.member_1, _e1801);
                                            let _e2486 = local_60;
                                            let _e2490 = local_61;
                                            let _e2497 = ((f32(bitcast<i32>(_e2486[0].member)) * 4294967300f) + f32(_e2490[0].member_1));
                                            let _e2499 = local_62;
                                            let _e2503 = local_63;
                                            let _e2510 = ((f32(bitcast<i32>(_e2499[1].member)) * 4294967300f) + f32(_e2503[1].member_1));
                                            let _e2512 = local_64;
                                            let _e2516 = local_65;
                                            let _e2523 = ((f32(bitcast<i32>(_e2512[2].member)) * 4294967300f) + f32(_e2516[2].member_1));
                                            let _e2525 = local_66;
                                            let _e2529 = local_67;
                                            let _e2536 = ((f32(bitcast<i32>(_e2525[3].member)) * 4294967300f) + f32(_e2529[3].member_1));
                                            phi_3257_ = type_14(0i, 6i);
                                            phi_3260_ = 1f;
                                            phi_3262_ = 0f;
                                            phi_3264_ = (_e2497 / (_e2497 - _e2536));
                                            loop {
                                                let _e2540 = phi_3257_;
                                                let _e2542 = phi_3260_;
                                                let _e2544 = phi_3262_;
                                                let _e2546 = phi_3264_;
                                                local_68 = _e2546;
                                                local_69 = _e2546;
                                                if (_e2540.member < _e2540.member_1) {
                                                    let _e2553 = (_e2540.member + 1i);
                                                    phi_3258_ = type_14(select(_e2553, type_15().member_1, select(false, true, ((false == (_e2553 > _e2540.member)) != false))), _e2540.member_1);
                                                    phi_3305_ = type_15(1u, _e2540.member);
                                                } else {
                                                    phi_3258_ = _e2540;
                                                    phi_3305_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e2564 = phi_3258_;
                                                let _e2566 = phi_3305_;
                                                let _e2569 = (bitcast<i32>(_e2566.member) != 0i);
                                                if _e2569 {
                                                    let _e2570 = function_5(_e2497, _e2510, _e2546);
                                                    let _e2571 = function_5(_e2510, _e2523, _e2546);
                                                    let _e2572 = function_5(_e2523, _e2536, _e2546);
                                                    let _e2573 = function_5(_e2570, _e2571, _e2546);
                                                    let _e2574 = function_5(_e2571, _e2572, _e2546);
                                                    let _e2575 = function_5(_e2573, _e2574, _e2546);
                                                    let _e2578 = ((_e2575 < 0f) == (_e2497 < 0f));
                                                    let _e2579 = select(_e2546, _e2542, _e2578);
                                                    let _e2580 = select(_e2544, _e2546, _e2578);
                                                    let _e2584 = (_e2546 - (_e2575 / (3f * (_e2574 - _e2573))));
                                                    phi_3261_ = _e2579;
                                                    phi_3263_ = _e2580;
                                                    phi_3265_ = select(_e2584, (0.5f * (_e2580 + _e2579)), select(true, select(true, false, (_e2584 <= _e2579)), (_e2584 >= _e2580)));
                                                } else {
                                                    phi_3261_ = f32();
                                                    phi_3263_ = f32();
                                                    phi_3265_ = f32();
                                                }
                                                let _e2593 = phi_3261_;
                                                let _e2595 = phi_3263_;
                                                let _e2597 = phi_3265_;
                                                continue;
                                                continuing {
                                                    phi_3257_ = _e2564;
                                                    phi_3260_ = _e2593;
                                                    phi_3262_ = _e2595;
                                                    phi_3264_ = _e2597;
                                                    break if !(_e2569);
                                                }
                                            }
                                            let _e2602 = (1u << bitcast<u32>(((31u - _e2476) & 31u)));
                                            let _e2603 = (_e2484 - _e2480);
                                            let _e2605 = local_68;
                                            let _e2609 = local_69;
                                            let _e2612 = (select(0.5f, _e2609, (bitcast<u32>(_e2605) <= 1065353216u)) * f32(_e2603));
                                            let _e2617 = select(select(u32(_e2612), 0u, (_e2612 < 0f)), 4294967295u, (_e2612 > 4294967000f));
                                            let _e2619 = select(_e2617, _e2603, (_e2603 < _e2617));
                                            let _e2621 = (_e2602 / 2u);
                                            let _e2624 = ((_e2480 + _e2619) - select(_e2621, _e2619, (_e2619 < _e2621)));
                                            let _e2625 = (_e2624 + _e2602);
                                            phi_3403_ = true;
                                            phi_3404_ = _e2415;
                                            phi_3405_ = type_17(_e2624, select(_e2625, _e2484, (_e2484 < _e2625)), _e2476);
                                        } else {
                                            if _e2453 {
                                                let _e2463 = select((bitcast<u32>(31i) - firstLeadingBit(_e713)), 32u, (_e713 == 0u));
                                                let _e2469 = local_56;
                                                let _e2472 = local_57;
                                                phi_3402_ = type_17(_e2472, (_e2469 + (1u << bitcast<u32>(((31u - _e2463) & 31u)))), _e2463);
                                            } else {
                                                phi_3402_ = _e2415;
                                            }
                                            let _e2475 = phi_3402_;
                                            phi_3403_ = _e1803;
                                            phi_3404_ = _e2475;
                                            phi_3405_ = _e1809;
                                        }
                                        let _e2630 = phi_3403_;
                                        let _e2632 = phi_3404_;
                                        let _e2634 = phi_3405_;
                                        phi_3406_ = _e2630;
                                        phi_3407_ = _e2632;
                                        phi_3408_ = _e2634;
                                    }
                                    let _e2642 = phi_3406_;
                                    let _e2644 = phi_3407_;
                                    let _e2646 = phi_3408_;
                                    if select(select(false, (_e2644.member_1 <= 2147483648u), _e2453), true, _e2434) {
                                        let _e2656 = local_72;
                                        phi_3438_ = type_14(0i, 2i);
                                        phi_3441_ = select((_e2656 & 3u), 0u, _e2434);
                                        phi_3443_ = select(_e2644.member_1, _e2646.member, _e2434);
                                        loop {
                                            let _e2662 = phi_3438_;
                                            let _e2664 = phi_3441_;
                                            let _e2666 = phi_3443_;
                                            local_73 = _e2664;
                                            if (_e2662.member < _e2662.member_1) {
                                                let _e2673 = (_e2662.member + 1i);
                                                phi_3439_ = type_14(select(_e2673, type_15().member_1, select(false, true, ((false == (_e2673 > _e2662.member)) != false))), _e2662.member_1);
                                                phi_3483_ = type_15(1u, _e2662.member);
                                            } else {
                                                phi_3439_ = _e2662;
                                                phi_3483_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e2684 = phi_3439_;
                                            let _e2686 = phi_3483_;
                                            let _e2689 = (bitcast<i32>(_e2686.member) != 0i);
                                            if _e2689 {
                                                let _e2695 = function_4(((_e1629[1].member - _e1625.member) - select(0u, 1u, (_e1633[1].member_1 < _e1625.member_1))), (_e1633[1].member_1 - _e1625.member_1), _e2666);
                                                let _e2698 = (_e1625.member_1 + _e2695.member_1);
                                                let _e2702 = ((_e1625.member + _e2695.member) + select(0u, 1u, (_e2698 < _e1625.member_1)));
                                                let _e2708 = function_4(((_e1637[2].member - _e1629[1].member) - select(0u, 1u, (_e1641[2].member_1 < _e1633[1].member_1))), (_e1641[2].member_1 - _e1633[1].member_1), _e2666);
                                                let _e2711 = (_e1633[1].member_1 + _e2708.member_1);
                                                let _e2715 = ((_e1629[1].member + _e2708.member) + select(0u, 1u, (_e2711 < _e1633[1].member_1)));
                                                let _e2721 = function_4(((_e1652.member - _e1637[2].member) - select(0u, 1u, (_e1652.member_1 < _e1641[2].member_1))), (_e1652.member_1 - _e1641[2].member_1), _e2666);
                                                let _e2724 = (_e1641[2].member_1 + _e2721.member_1);
                                                let _e2734 = function_4(((_e2715 - _e2702) - select(0u, 1u, (_e2711 < _e2698))), (_e2711 - _e2698), _e2666);
                                                let _e2737 = (_e2698 + _e2734.member_1);
                                                let _e2741 = ((_e2702 + _e2734.member) + select(0u, 1u, (_e2737 < _e2698)));
                                                let _e2747 = function_4(((((_e1637[2].member + _e2721.member) + select(0u, 1u, (_e2724 < _e1641[2].member_1))) - _e2715) - select(0u, 1u, (_e2724 < _e2711))), (_e2724 - _e2711), _e2666);
                                                let _e2750 = (_e2711 + _e2747.member_1);
                                                let _e2760 = function_4(((((_e2715 + _e2747.member) + select(0u, 1u, (_e2750 < _e2711))) - _e2741) - select(0u, 1u, (_e2750 < _e2737))), (_e2750 - _e2737), _e2666);
                                                let _e2763 = (_e2737 + _e2760.member_1);
                                                let _e2767 = ((_e2741 + _e2760.member) + select(0u, 1u, (_e2763 < _e2737)));
                                                let _e2768 = function_1(128u);
                                                let _e2773 = ((_e2767 >> bitcast<u32>(31i)) != 0u);
                                                phi_3442_ = (_e2664 | select(0u, select(1u, 2u, ((_e2767 >> bitcast<u32>(31i)) != 0u)), ((((_e2768.member - select(_e2767, (~(_e2767) + select(0u, 1u, (_e2763 == 0u))), _e2773)) - select(0u, 1u, (_e2768.member_1 < select(_e2763, (~(_e2763) + 1u), _e2773)))) >> bitcast<u32>(31i)) != 0u)));
                                            } else {
                                                phi_3442_ = u32();
                                            }
                                            let _e2796 = phi_3442_;
                                            continue;
                                            continuing {
                                                phi_3438_ = _e2684;
                                                phi_3441_ = _e2796;
                                                phi_3443_ = select(_e2644.member_1, _e2646.member_1, _e2434);
                                                break if !(_e2689);
                                            }
                                        }
                                        let _e2799 = local_73;
                                        phi_3659_ = (_e2799 == 3u);
                                    } else {
                                        phi_3659_ = _e2424;
                                    }
                                    let _e2802 = phi_3659_;
                                    if _e2434 {
                                        phi_3667_ = _e2802;
                                        phi_3668_ = type_17(select(_e2644.member, _e2646.member, _e2802), select(_e2644.member_1, _e2646.member_1, _e2802), select(_e2644.member_2, _e2646.member_2, _e2802));
                                    } else {
                                        phi_3667_ = _e1801;
                                        phi_3668_ = _e2644;
                                    }
                                    let _e2814 = phi_3667_;
                                    let _e2816 = phi_3668_;
                                    let _e2820 = (f32(_e2816.member) / 2147483600f);
                                    let _e2841 = ((f32(bitcast<i32>(_e1336[1][0][0].member)) * 4294967300f) + f32(_e1336[1][0][0].member_1));
                                    let _e2849 = (_e2841 + ((((f32(bitcast<i32>(_e1336[1][1][0].member)) * 4294967300f) + f32(_e1336[1][1][0].member_1)) - _e2841) * _e2820));
                                    let _e2870 = ((f32(bitcast<i32>(_e1336[1][0][1].member)) * 4294967300f) + f32(_e1336[1][0][1].member_1));
                                    let _e2878 = (_e2870 + ((((f32(bitcast<i32>(_e1336[1][1][1].member)) * 4294967300f) + f32(_e1336[1][1][1].member_1)) - _e2870) * _e2820));
                                    let _e2899 = ((f32(bitcast<i32>(_e1336[1][0][2].member)) * 4294967300f) + f32(_e1336[1][0][2].member_1));
                                    let _e2907 = (_e2899 + ((((f32(bitcast<i32>(_e1336[1][1][2].member)) * 4294967300f) + f32(_e1336[1][1][2].member_1)) - _e2899) * _e2820));
                                    let _e2928 = ((f32(bitcast<i32>(_e1336[2][0][0].member)) * 4294967300f) + f32(_e1336[2][0][0].member_1));
                                    let _e2936 = (_e2928 + ((((f32(bitcast<i32>(_e1336[2][1][0].member)) * 4294967300f) + f32(_e1336[2][1][0].member_1)) - _e2928) * _e2820));
                                    let _e2957 = ((f32(bitcast<i32>(_e1336[2][0][1].member)) * 4294967300f) + f32(_e1336[2][0][1].member_1));
                                    let _e2965 = (_e2957 + ((((f32(bitcast<i32>(_e1336[2][1][1].member)) * 4294967300f) + f32(_e1336[2][1][1].member_1)) - _e2957) * _e2820));
                                    let _e2986 = ((f32(bitcast<i32>(_e1336[2][0][2].member)) * 4294967300f) + f32(_e1336[2][0][2].member_1));
                                    let _e2994 = (_e2986 + ((((f32(bitcast<i32>(_e1336[2][1][2].member)) * 4294967300f) + f32(_e1336[2][1][2].member_1)) - _e2986) * _e2820));
                                    let _e3004 = abs(((_e2878 * _e2994) - (_e2907 * _e2965)));
                                    let _e3005 = abs(((_e2907 * _e2936) - (_e2849 * _e2994)));
                                    let _e3006 = abs(((_e2849 * _e2965) - (_e2878 * _e2936)));
                                    let _e3013 = select(0u, select(2u, 1u, (_e3005 > _e3006)), select(true, select(true, false, (_e3004 > _e3006)), (_e3004 > _e3005)));
                                    if (_e3013 == 0u) {
                                        phi_3892_ = array<type_9, 2>(_e1336[0][0][1], _e1336[0][0][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_3891_ = array<type_9, 2>(_e1336[0][0][2], _e1336[0][0][0]);
                                        } else {
                                            phi_3891_ = array<type_9, 2>(_e1336[0][0][0], _e1336[0][0][1]);
                                        }
                                        let _e3027 = phi_3891_;
                                        phi_3892_ = _e3027;
                                    }
                                    let _e3032 = phi_3892_;
                                    if (_e3013 == 0u) {
                                        phi_3927_ = array<type_9, 2>(_e1336[0][1][1], _e1336[0][1][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_3926_ = array<type_9, 2>(_e1336[0][1][2], _e1336[0][1][0]);
                                        } else {
                                            phi_3926_ = array<type_9, 2>(_e1336[0][1][0], _e1336[0][1][1]);
                                        }
                                        let _e3043 = phi_3926_;
                                        phi_3927_ = _e3043;
                                    }
                                    let _e3048 = phi_3927_;
                                    if (_e3013 == 0u) {
                                        phi_3962_ = array<type_9, 2>(_e1336[1][0][1], _e1336[1][0][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_3961_ = array<type_9, 2>(_e1336[1][0][2], _e1336[1][0][0]);
                                        } else {
                                            phi_3961_ = array<type_9, 2>(_e1336[1][0][0], _e1336[1][0][1]);
                                        }
                                        let _e3059 = phi_3961_;
                                        phi_3962_ = _e3059;
                                    }
                                    let _e3064 = phi_3962_;
                                    if (_e3013 == 0u) {
                                        phi_3997_ = array<type_9, 2>(_e1336[1][1][1], _e1336[1][1][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_3996_ = array<type_9, 2>(_e1336[1][1][2], _e1336[1][1][0]);
                                        } else {
                                            phi_3996_ = array<type_9, 2>(_e1336[1][1][0], _e1336[1][1][1]);
                                        }
                                        let _e3075 = phi_3996_;
                                        phi_3997_ = _e3075;
                                    }
                                    let _e3080 = phi_3997_;
                                    if (_e3013 == 0u) {
                                        phi_4032_ = array<type_9, 2>(_e1336[2][0][1], _e1336[2][0][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_4031_ = array<type_9, 2>(_e1336[2][0][2], _e1336[2][0][0]);
                                        } else {
                                            phi_4031_ = array<type_9, 2>(_e1336[2][0][0], _e1336[2][0][1]);
                                        }
                                        let _e3091 = phi_4031_;
                                        phi_4032_ = _e3091;
                                    }
                                    let _e3096 = phi_4032_;
                                    if (_e3013 == 0u) {
                                        phi_4067_ = array<type_9, 2>(_e1336[2][1][1], _e1336[2][1][2]);
                                    } else {
                                        if (_e3013 == 1u) {
                                            phi_4066_ = array<type_9, 2>(_e1336[2][1][2], _e1336[2][1][0]);
                                        } else {
                                            phi_4066_ = array<type_9, 2>(_e1336[2][1][0], _e1336[2][1][1]);
                                        }
                                        let _e3107 = phi_4066_;
                                        phi_4067_ = _e3107;
                                    }
                                    let _e3112 = phi_4067_;
                                    let _e3124 = ((_e3048[0].member - _e3032[0].member) - select(0u, 1u, (_e3048[0].member_1 < _e3032[0].member_1)));
                                    let _e3125 = (_e3048[0].member_1 - _e3032[0].member_1);
                                    let _e3128 = ((_e3124 >> bitcast<u32>(31i)) != 0u);
                                    let _e3135 = select(_e3124, (~(_e3124) + select(0u, 1u, (_e3125 == 0u))), _e3128);
                                    let _e3136 = select(_e3125, (~(_e3125) + 1u), _e3128);
                                    let _e3148 = ((_e3048[1].member - _e3032[1].member) - select(0u, 1u, (_e3048[1].member_1 < _e3032[1].member_1)));
                                    let _e3149 = (_e3048[1].member_1 - _e3032[1].member_1);
                                    let _e3152 = ((_e3148 >> bitcast<u32>(31i)) != 0u);
                                    let _e3159 = select(_e3148, (~(_e3148) + select(0u, 1u, (_e3149 == 0u))), _e3152);
                                    let _e3160 = select(_e3149, (~(_e3149) + 1u), _e3152);
                                    let _e3167 = ((((_e3159 - _e3135) - select(0u, 1u, (_e3160 < _e3136))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3169 = select(_e3160, _e3136, _e3167);
                                    let _e3170 = function_1(4u);
                                    let _e3173 = (_e3169 + _e3170.member_1);
                                    let _e3177 = ((select(_e3159, _e3135, _e3167) + _e3170.member) + select(0u, 1u, (_e3173 < _e3169)));
                                    let _e3192 = ((_e3173 >> bitcast<u32>((_e2816.member_2 & 31u))) | ((_e3177 << bitcast<u32>(((31u - _e2816.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3193 = function_1(4u);
                                    let _e3196 = (_e3192 + _e3193.member_1);
                                    let _e3200 = ((bitcast<u32>((bitcast<i32>(_e3177) >> bitcast<u32>((_e2816.member_2 & 31u)))) + _e3193.member) + select(0u, 1u, (_e3196 < _e3192)));
                                    let _e3212 = ((_e3080[0].member - _e3064[0].member) - select(0u, 1u, (_e3080[0].member_1 < _e3064[0].member_1)));
                                    let _e3213 = (_e3080[0].member_1 - _e3064[0].member_1);
                                    let _e3216 = ((_e3212 >> bitcast<u32>(31i)) != 0u);
                                    let _e3223 = select(_e3212, (~(_e3212) + select(0u, 1u, (_e3213 == 0u))), _e3216);
                                    let _e3224 = select(_e3213, (~(_e3213) + 1u), _e3216);
                                    let _e3236 = ((_e3080[1].member - _e3064[1].member) - select(0u, 1u, (_e3080[1].member_1 < _e3064[1].member_1)));
                                    let _e3237 = (_e3080[1].member_1 - _e3064[1].member_1);
                                    let _e3240 = ((_e3236 >> bitcast<u32>(31i)) != 0u);
                                    let _e3247 = select(_e3236, (~(_e3236) + select(0u, 1u, (_e3237 == 0u))), _e3240);
                                    let _e3248 = select(_e3237, (~(_e3237) + 1u), _e3240);
                                    let _e3255 = ((((_e3247 - _e3223) - select(0u, 1u, (_e3248 < _e3224))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3257 = select(_e3248, _e3224, _e3255);
                                    let _e3258 = function_1(4u);
                                    let _e3261 = (_e3257 + _e3258.member_1);
                                    let _e3265 = ((select(_e3247, _e3223, _e3255) + _e3258.member) + select(0u, 1u, (_e3261 < _e3257)));
                                    let _e3280 = ((_e3261 >> bitcast<u32>((_e2816.member_2 & 31u))) | ((_e3265 << bitcast<u32>(((31u - _e2816.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3281 = function_1(4u);
                                    let _e3284 = (_e3280 + _e3281.member_1);
                                    let _e3288 = ((bitcast<u32>((bitcast<i32>(_e3265) >> bitcast<u32>((_e2816.member_2 & 31u)))) + _e3281.member) + select(0u, 1u, (_e3284 < _e3280)));
                                    let _e3300 = ((_e3112[0].member - _e3096[0].member) - select(0u, 1u, (_e3112[0].member_1 < _e3096[0].member_1)));
                                    let _e3301 = (_e3112[0].member_1 - _e3096[0].member_1);
                                    let _e3304 = ((_e3300 >> bitcast<u32>(31i)) != 0u);
                                    let _e3311 = select(_e3300, (~(_e3300) + select(0u, 1u, (_e3301 == 0u))), _e3304);
                                    let _e3312 = select(_e3301, (~(_e3301) + 1u), _e3304);
                                    let _e3324 = ((_e3112[1].member - _e3096[1].member) - select(0u, 1u, (_e3112[1].member_1 < _e3096[1].member_1)));
                                    let _e3325 = (_e3112[1].member_1 - _e3096[1].member_1);
                                    let _e3328 = ((_e3324 >> bitcast<u32>(31i)) != 0u);
                                    let _e3335 = select(_e3324, (~(_e3324) + select(0u, 1u, (_e3325 == 0u))), _e3328);
                                    let _e3336 = select(_e3325, (~(_e3325) + 1u), _e3328);
                                    let _e3343 = ((((_e3335 - _e3311) - select(0u, 1u, (_e3336 < _e3312))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3345 = select(_e3336, _e3312, _e3343);
                                    let _e3346 = function_1(4u);
                                    let _e3349 = (_e3345 + _e3346.member_1);
                                    let _e3353 = ((select(_e3335, _e3311, _e3343) + _e3346.member) + select(0u, 1u, (_e3349 < _e3345)));
                                    let _e3368 = ((_e3349 >> bitcast<u32>((_e2816.member_2 & 31u))) | ((_e3353 << bitcast<u32>(((31u - _e2816.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3369 = function_1(4u);
                                    let _e3372 = (_e3368 + _e3369.member_1);
                                    let _e3376 = ((bitcast<u32>((bitcast<i32>(_e3353) >> bitcast<u32>((_e2816.member_2 & 31u)))) + _e3369.member) + select(0u, 1u, (_e3372 < _e3368)));
                                    let _e3390 = function_4(((_e3048[0].member - _e3032[0].member) - select(0u, 1u, (_e3048[0].member_1 < _e3032[0].member_1))), (_e3048[0].member_1 - _e3032[0].member_1), _e2816.member);
                                    let _e3393 = (_e3032[0].member_1 + _e3390.member_1);
                                    let _e3397 = ((_e3032[0].member + _e3390.member) + select(0u, 1u, (_e3393 < _e3032[0].member_1)));
                                    let _e3411 = function_4(((_e3048[1].member - _e3032[1].member) - select(0u, 1u, (_e3048[1].member_1 < _e3032[1].member_1))), (_e3048[1].member_1 - _e3032[1].member_1), _e2816.member);
                                    let _e3414 = (_e3032[1].member_1 + _e3411.member_1);
                                    let _e3418 = ((_e3032[1].member + _e3411.member) + select(0u, 1u, (_e3414 < _e3032[1].member_1)));
                                    let _e3432 = function_4(((_e3080[0].member - _e3064[0].member) - select(0u, 1u, (_e3080[0].member_1 < _e3064[0].member_1))), (_e3080[0].member_1 - _e3064[0].member_1), _e2816.member);
                                    let _e3435 = (_e3064[0].member_1 + _e3432.member_1);
                                    let _e3439 = ((_e3064[0].member + _e3432.member) + select(0u, 1u, (_e3435 < _e3064[0].member_1)));
                                    let _e3453 = function_4(((_e3080[1].member - _e3064[1].member) - select(0u, 1u, (_e3080[1].member_1 < _e3064[1].member_1))), (_e3080[1].member_1 - _e3064[1].member_1), _e2816.member);
                                    let _e3456 = (_e3064[1].member_1 + _e3453.member_1);
                                    let _e3460 = ((_e3064[1].member + _e3453.member) + select(0u, 1u, (_e3456 < _e3064[1].member_1)));
                                    let _e3474 = function_4(((_e3112[0].member - _e3096[0].member) - select(0u, 1u, (_e3112[0].member_1 < _e3096[0].member_1))), (_e3112[0].member_1 - _e3096[0].member_1), _e2816.member);
                                    let _e3477 = (_e3096[0].member_1 + _e3474.member_1);
                                    let _e3481 = ((_e3096[0].member + _e3474.member) + select(0u, 1u, (_e3477 < _e3096[0].member_1)));
                                    let _e3495 = function_4(((_e3112[1].member - _e3096[1].member) - select(0u, 1u, (_e3112[1].member_1 < _e3096[1].member_1))), (_e3112[1].member_1 - _e3096[1].member_1), _e2816.member);
                                    let _e3498 = (_e3096[1].member_1 + _e3495.member_1);
                                    let _e3502 = ((_e3096[1].member + _e3495.member) + select(0u, 1u, (_e3498 < _e3096[1].member_1)));
                                    let _e3503 = function_2(_e3288, _e3284, _e3376, _e3372);
                                    let _e3506 = function_2(_e3200, _e3196, _e3376, _e3372);
                                    let _e3509 = function_2(_e3200, _e3196, _e3288, _e3284);
                                    let _e3512 = function_7(_e3439, _e3435, _e3502, _e3498);
                                    let _e3515 = function_7(_e3460, _e3456, _e3481, _e3477);
                                    let _e3521 = ((_e3512.member - _e3515.member) - select(0u, 1u, (_e3512.member_1 < _e3515.member_1)));
                                    let _e3522 = (_e3512.member_1 - _e3515.member_1);
                                    let _e3525 = ((_e3521 >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e3503.member - select(_e3521, (~(_e3521) + select(0u, 1u, (_e3522 == 0u))), _e3525)) - select(0u, 1u, (_e3503.member_1 < select(_e3522, (~(_e3522) + 1u), _e3525)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e3543 = ((_e3521 >> bitcast<u32>(31i)) != 0u);
                                        let _e3550 = select(_e3521, (~(_e3521) + select(0u, 1u, (_e3522 == 0u))), _e3543);
                                        let _e3551 = select(_e3522, (~(_e3522) + 1u), _e3543);
                                        let _e3552 = function_7(_e3397, _e3393, _e3502, _e3498);
                                        let _e3555 = function_7(_e3418, _e3414, _e3481, _e3477);
                                        let _e3561 = ((_e3552.member - _e3555.member) - select(0u, 1u, (_e3552.member_1 < _e3555.member_1)));
                                        let _e3562 = (_e3552.member_1 - _e3555.member_1);
                                        let _e3569 = select(_e3561, (~(_e3561) + select(0u, 1u, (_e3562 == 0u))), _e3543);
                                        let _e3570 = select(_e3562, (~(_e3562) + 1u), _e3543);
                                        let _e3571 = function_7(_e3439, _e3435, _e3418, _e3414);
                                        let _e3574 = function_7(_e3460, _e3456, _e3397, _e3393);
                                        let _e3580 = ((_e3571.member - _e3574.member) - select(0u, 1u, (_e3571.member_1 < _e3574.member_1)));
                                        let _e3581 = (_e3571.member_1 - _e3574.member_1);
                                        let _e3588 = select(_e3580, (~(_e3580) + select(0u, 1u, (_e3581 == 0u))), _e3543);
                                        let _e3589 = select(_e3581, (~(_e3581) + 1u), _e3543);
                                        if (_e228.member != 0u) {
                                            let _e3621 = (_e3503.member_1 + _e3506.member_1);
                                            let _e3633 = (_e3503.member_1 + _e3509.member_1);
                                            phi_4825_ = type_9(((_e3503.member + _e3509.member) + select(0u, 1u, (_e3633 < _e3503.member_1))), _e3633);
                                            phi_4826_ = type_9(((_e3550 - _e3588) - select(0u, 1u, (_e3551 < _e3589))), (_e3551 - _e3589));
                                            phi_4827_ = type_9(((_e3503.member + _e3506.member) + select(0u, 1u, (_e3621 < _e3503.member_1))), _e3621);
                                            phi_4828_ = type_9(((_e3550 - _e3569) - select(0u, 1u, (_e3551 < _e3570))), (_e3551 - _e3570));
                                        } else {
                                            let _e3595 = (_e3551 - _e3570);
                                            let _e3599 = ((((_e3550 - _e3569) - select(0u, 1u, (_e3551 < _e3570))) - _e3588) - select(0u, 1u, (_e3595 < _e3589)));
                                            let _e3600 = (_e3595 - _e3589);
                                            let _e3602 = (_e3503.member_1 + _e3506.member_1);
                                            let _e3607 = (_e3602 + _e3509.member_1);
                                            let _e3611 = ((((_e3503.member + _e3506.member) + select(0u, 1u, (_e3602 < _e3503.member_1))) + _e3509.member) + select(0u, 1u, (_e3607 < _e3602)));
                                            phi_4825_ = type_9(_e3611, _e3607);
                                            phi_4826_ = type_9(_e3599, _e3600);
                                            phi_4827_ = type_9(_e3611, _e3607);
                                            phi_4828_ = type_9(_e3599, _e3600);
                                        }
                                        let _e3640 = phi_4825_;
                                        let _e3642 = phi_4826_;
                                        let _e3644 = phi_4827_;
                                        let _e3646 = phi_4828_;
                                        if ((((_e3506.member - (~(_e3569) + select(0u, 1u, (_e3570 == 0u)))) - select(0u, 1u, (_e3506.member_1 < (~(_e3570) + 1u)))) >> bitcast<u32>(31i)) != 0u) {
                                            phi_4921_ = bool();
                                            phi_4922_ = true;
                                        } else {
                                            if ((((_e3509.member - (~(_e3588) + select(0u, 1u, (_e3589 == 0u)))) - select(0u, 1u, (_e3509.member_1 < (~(_e3589) + 1u)))) >> bitcast<u32>(31i)) != 0u) {
                                                phi_4919_ = bool();
                                                phi_4920_ = true;
                                            } else {
                                                let _e3689 = ((((_e3644.member - (~(_e3646.member) + select(0u, 1u, (_e3646.member_1 == 0u)))) - select(0u, 1u, (_e3644.member_1 < (~(_e3646.member_1) + 1u)))) >> bitcast<u32>(31i)) != 0u);
                                                if _e3689 {
                                                    phi_4918_ = bool();
                                                } else {
                                                    phi_4918_ = ((((_e3640.member - (~(_e3642.member) + select(0u, 1u, (_e3642.member_1 == 0u)))) - select(0u, 1u, (_e3640.member_1 < (~(_e3642.member_1) + 1u)))) >> bitcast<u32>(31i)) != 0u);
                                                }
                                                let _e3708 = phi_4918_;
                                                phi_4919_ = _e3708;
                                                phi_4920_ = _e3689;
                                            }
                                            let _e3710 = phi_4919_;
                                            let _e3712 = phi_4920_;
                                            phi_4921_ = _e3710;
                                            phi_4922_ = _e3712;
                                        }
                                        let _e3714 = phi_4921_;
                                        let _e3716 = phi_4922_;
                                        if ((((_e3506.member - _e3569) - select(0u, 1u, (_e3506.member_1 < _e3570))) >> bitcast<u32>(31i)) != 0u) {
                                            if ((((_e3509.member - _e3588) - select(0u, 1u, (_e3509.member_1 < _e3589))) >> bitcast<u32>(31i)) != 0u) {
                                                if ((((_e3644.member - _e3646.member) - select(0u, 1u, (_e3644.member_1 < _e3646.member_1))) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4980_ = ((((_e3640.member - _e3642.member) - select(0u, 1u, (_e3640.member_1 < _e3642.member_1))) >> bitcast<u32>(31i)) != 0u);
                                                    phi_4981_ = false;
                                                } else {
                                                    phi_4980_ = bool();
                                                    phi_4981_ = true;
                                                }
                                                let _e3755 = phi_4980_;
                                                let _e3757 = phi_4981_;
                                                phi_4982_ = _e3755;
                                                phi_4983_ = _e3757;
                                            } else {
                                                phi_4982_ = bool();
                                                phi_4983_ = true;
                                            }
                                            let _e3759 = phi_4982_;
                                            let _e3761 = phi_4983_;
                                            phi_4984_ = _e3759;
                                            phi_4985_ = _e3761;
                                        } else {
                                            phi_4984_ = bool();
                                            phi_4985_ = true;
                                        }
                                        let _e3763 = phi_4984_;
                                        let _e3765 = phi_4985_;
                                        phi_4998_ = select(select(2u, 0u, select(_e3763, false, _e3765)), 1u, select(_e3714, true, _e3716));
                                    } else {
                                        phi_4998_ = 2u;
                                    }
                                    let _e3770 = phi_4998_;
                                    let _e3771 = (_e3770 == 1u);
                                    let _e3772 = (_e3770 == 0u);
                                    let _e3788 = local_74;
                                    if _e3788 {
                                        let _e4846 = local_108;
                                        phi_5070_ = _e4846;
                                        phi_5071_ = _e3771;
                                        phi_5072_ = select(true, false, _e3771);
                                        phi_5073_ = false;
                                        phi_5074_ = false;
                                    } else {
                                        let _e3792 = select(true, select(true, select(true, select(true, false, ((_e2816.member_1 - _e2816.member) <= _e713)), select(false, (_e2816.member_1 <= _e711), (_e2816.member >= _e709))), _e2802), _e3772);
                                        let _e3794 = select(select(false, select((_e2816.member > _e711), true, (_e2816.member_1 < _e709)), _e2814), true, _e3771);
                                        let _e3795 = select(true, _e3794, select(select(select((_e2403 == 0u), bool(), _e2401), bool(), _e1801), true, select(_e2401, true, _e1801)));
                                        phi_5070_ = select(bool(), _e3794, _e3792);
                                        phi_5071_ = select(false, _e3795, _e3792);
                                        phi_5072_ = false;
                                        phi_5073_ = select(false, select(true, false, _e3795), _e3792);
                                        phi_5074_ = select(true, false, _e3792);
                                    }
                                    let _e3803 = phi_5070_;
                                    let _e3805 = phi_5071_;
                                    let _e3807 = phi_5072_;
                                    let _e3809 = phi_5073_;
                                    let _e3811 = phi_5074_;
                                    phi_5081_ = _e2814;
                                    phi_5082_ = _e2642;
                                    phi_5083_ = true;
                                    phi_5084_ = !(_e2455);
                                    phi_5085_ = _e2646;
                                    phi_5086_ = _e3803;
                                    phi_5087_ = _e3772;
                                    phi_5088_ = _e2816;
                                    phi_5089_ = _e3805;
                                    phi_5090_ = select(_e3807, false, _e3805);
                                    phi_5091_ = select(_e3809, false, _e3805);
                                    phi_5092_ = select(_e3811, false, _e3805);
                                }
                                let _e3816 = phi_5081_;
                                let _e3818 = phi_5082_;
                                let _e3820 = phi_5083_;
                                let _e3822 = phi_5084_;
                                let _e3824 = phi_5085_;
                                let _e3826 = phi_5086_;
                                let _e3828 = phi_5087_;
                                let _e3830 = phi_5088_;
                                let _e3832 = phi_5089_;
                                let _e3834 = phi_5090_;
                                let _e3836 = phi_5091_;
                                let _e3838 = phi_5092_;
                                phi_5093_ = _e3816;
                                phi_5094_ = _e3818;
                                phi_5095_ = _e3820;
                                phi_5096_ = _e3822;
                                phi_5097_ = _e3824;
                                phi_5098_ = _e3826;
                                phi_5099_ = _e3828;
                                phi_5100_ = _e3830;
                                phi_5101_ = _e3832;
                                phi_5102_ = _e3834;
                                phi_5103_ = _e3836;
                                phi_5104_ = _e3838;
                            } else {
                                phi_5093_ = _e1801;
                                phi_5094_ = _e1803;
                                let _e4873 = local_112;
                                phi_5095_ = _e4873;
                                let _e4876 = local_113;
                                phi_5096_ = _e4876;
                                phi_5097_ = _e1809;
                                let _e4880 = local_114;
                                phi_5098_ = _e4880;
                                phi_5099_ = bool();
                                phi_5100_ = type_17();
                                phi_5101_ = true;
                                phi_5102_ = false;
                                phi_5103_ = false;
                                phi_5104_ = false;
                            }
                            let _e3840 = phi_5093_;
                            let _e3842 = phi_5094_;
                            let _e3844 = phi_5095_;
                            let _e3846 = phi_5096_;
                            let _e3848 = phi_5097_;
                            let _e3850 = phi_5098_;
                            let _e3852 = phi_5099_;
                            let _e3854 = phi_5100_;
                            let _e3856 = phi_5101_;
                            let _e3858 = phi_5102_;
                            let _e3860 = phi_5103_;
                            let _e3862 = phi_5104_;
                            if _e3856 {
                                if _e3850 {
                                    let _e3866 = local_75;
                                    let _e3867 = (_e3866 + 1u);
                                    let _e3869 = local_76;
                                    let _e3871 = (_e3867 & (4294967295u - _e3869));
                                    let _e3877 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3871)), 32u, (_e3871 == 0u)));
                                    let _e3879 = local_77;
                                    let _e3882 = local_78;
                                    let _e3883 = select(_e3877, _e3882, (_e3879 < _e3877));
                                    let _e3886 = (_e3867 >> bitcast<u32>((_e3883 & 31u)));
                                    let _e3888 = local_79;
                                    let _e3889 = (_e3888 - _e3883);
                                    let _e3891 = local_80;
                                    let _e3892 = (_e3891 > _e711);
                                    if _e3892 {
                                        phi_5155_ = u32();
                                        phi_5156_ = u32();
                                        phi_5157_ = false;
                                        phi_5158_ = false;
                                    } else {
                                        let _e3896 = select(true, select(true, false, (_e3889 == 0u)), (_e3886 == 1u));
                                        let _e3897 = (31u - _e3889);
                                        phi_5155_ = select(u32(), ((_e3886 + 1u) << bitcast<u32>((_e3897 & 31u))), _e3896);
                                        phi_5156_ = select(u32(), (_e3886 << bitcast<u32>((_e3897 & 31u))), _e3896);
                                        phi_5157_ = _e3896;
                                        phi_5158_ = select(true, false, _e3896);
                                    }
                                    let _e3909 = phi_5155_;
                                    let _e3911 = phi_5156_;
                                    let _e3913 = phi_5157_;
                                    let _e3915 = phi_5158_;
                                    phi_5159_ = _e3909;
                                    phi_5160_ = _e3911;
                                    phi_5161_ = false;
                                    phi_5162_ = false;
                                    phi_5163_ = false;
                                    phi_5164_ = false;
                                    phi_5165_ = _e3889;
                                    phi_5166_ = _e3886;
                                    phi_5167_ = _e3913;
                                    phi_5168_ = _e3892;
                                    phi_5169_ = _e3915;
                                } else {
                                    phi_5159_ = _e3848.member_1;
                                    phi_5160_ = _e3848.member;
                                    phi_5161_ = _e3840;
                                    phi_5162_ = _e3842;
                                    phi_5163_ = _e3844;
                                    phi_5164_ = _e3846;
                                    let _e4905 = local_115;
                                    phi_5165_ = _e4905;
                                    let _e4908 = local_116;
                                    phi_5166_ = _e4908;
                                    phi_5167_ = true;
                                    phi_5168_ = false;
                                    phi_5169_ = false;
                                }
                                let _e3917 = phi_5159_;
                                let _e3919 = phi_5160_;
                                let _e3921 = phi_5161_;
                                let _e3923 = phi_5162_;
                                let _e3925 = phi_5163_;
                                let _e3927 = phi_5164_;
                                let _e3929 = phi_5165_;
                                let _e3931 = phi_5166_;
                                let _e3933 = phi_5167_;
                                let _e3935 = phi_5168_;
                                let _e3937 = phi_5169_;
                                if _e3933 {
                                    if select(_e3921, true, _e3850) {
                                        phi_5194_ = type_14(0i, 4i);
                                        phi_5197_ = array<u32, 3>(_e3919, _e3919, _e3919);
                                        phi_5199_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                                        loop {
                                            let _e3941 = phi_5194_;
                                            let _e3943 = phi_5197_;
                                            let _e3945 = phi_5199_;
                                            local_81 = _e3945;
                                            local_82 = _e3945;
                                            local_83 = _e3945;
                                            local_84 = _e3945;
                                            local_85 = _e3945;
                                            local_86 = _e3945;
                                            local_87 = _e3945;
                                            local_88 = _e3945;
                                            local_89 = _e3945;
                                            local_90 = _e3945;
                                            local_91 = _e3945;
                                            local_92 = _e3945;
                                            local_118 = _e3945;
                                            if (_e3941.member < _e3941.member_1) {
                                                let _e3952 = (_e3941.member + 1i);
                                                phi_5195_ = type_14(select(_e3952, type_15().member_1, select(false, true, ((false == (_e3952 > _e3941.member)) != false))), _e3941.member_1);
                                                phi_5240_ = type_15(1u, _e3941.member);
                                            } else {
                                                phi_5195_ = _e3941;
                                                phi_5240_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3963 = phi_5195_;
                                            let _e3965 = phi_5240_;
                                            let _e3968 = (bitcast<i32>(_e3965.member) != 0i);
                                            if _e3968 {
                                                let _e3977 = function_4(((_e1629[1].member - _e1625.member) - select(0u, 1u, (_e1633[1].member_1 < _e1625.member_1))), (_e1633[1].member_1 - _e1625.member_1), _e3943[0]);
                                                let _e3980 = (_e1625.member_1 + _e3977.member_1);
                                                let _e3984 = ((_e1625.member + _e3977.member) + select(0u, 1u, (_e3980 < _e1625.member_1)));
                                                let _e3990 = function_4(((_e1637[2].member - _e1629[1].member) - select(0u, 1u, (_e1641[2].member_1 < _e1633[1].member_1))), (_e1641[2].member_1 - _e1633[1].member_1), _e3943[0]);
                                                let _e3993 = (_e1633[1].member_1 + _e3990.member_1);
                                                let _e3997 = ((_e1629[1].member + _e3990.member) + select(0u, 1u, (_e3993 < _e1633[1].member_1)));
                                                let _e4003 = function_4(((_e1652.member - _e1637[2].member) - select(0u, 1u, (_e1652.member_1 < _e1641[2].member_1))), (_e1652.member_1 - _e1641[2].member_1), _e3943[0]);
                                                let _e4006 = (_e1641[2].member_1 + _e4003.member_1);
                                                let _e4016 = function_4(((_e3997 - _e3984) - select(0u, 1u, (_e3993 < _e3980))), (_e3993 - _e3980), _e3943[1]);
                                                let _e4019 = (_e3980 + _e4016.member_1);
                                                let _e4023 = ((_e3984 + _e4016.member) + select(0u, 1u, (_e4019 < _e3980)));
                                                let _e4029 = function_4(((((_e1637[2].member + _e4003.member) + select(0u, 1u, (_e4006 < _e1641[2].member_1))) - _e3997) - select(0u, 1u, (_e4006 < _e3993))), (_e4006 - _e3993), _e3943[1]);
                                                let _e4032 = (_e3993 + _e4029.member_1);
                                                let _e4042 = function_4(((((_e3997 + _e4029.member) + select(0u, 1u, (_e4032 < _e3993))) - _e4023) - select(0u, 1u, (_e4032 < _e4019))), (_e4032 - _e4019), _e3943[2]);
                                                let _e4045 = (_e4019 + _e4042.member_1);
                                                phi_5198_ = array<u32, 3>(_e3943[1], _e3943[2], _e3917);
                                                phi_5200_ = array<type_9, 4>(_e3945[1], _e3945[2], _e3945[3], type_9(((_e4023 + _e4042.member) + select(0u, 1u, (_e4045 < _e4019))), _e4045));
                                            } else {
                                                phi_5198_ = array<u32, 3>();
                                                phi_5200_ = array<type_9, 4>();
                                            }
                                            let _e4059 = phi_5198_;
                                            let _e4061 = phi_5200_;
                                            continue;
                                            continuing {
                                                phi_5194_ = _e3963;
                                                phi_5197_ = _e4059;
                                                phi_5199_ = _e4061;
                                                break if !(_e3968);
                                            }
                                        }
                                        let _e4064 = local_81;
                                        let _e4068 = local_82;
                                        let _e4071 = function_1(128u);
                                        let _e4076 = ((_e4064[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4084 = local_83;
                                        let _e4103 = local_84;
                                        let _e4107 = local_85;
                                        let _e4110 = function_1(128u);
                                        let _e4115 = ((_e4103[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4123 = local_86;
                                        let _e4145 = local_87;
                                        let _e4149 = local_88;
                                        let _e4152 = function_1(128u);
                                        let _e4157 = ((_e4145[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4165 = local_89;
                                        let _e4187 = local_90;
                                        let _e4191 = local_91;
                                        let _e4194 = function_1(128u);
                                        let _e4199 = ((_e4187[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e4207 = local_92;
                                        phi_5571_ = (((select(0u, select(1u, 2u, ((_e4064[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4071.member - select(_e4084[0].member, (~(_e4064[0].member) + select(0u, 1u, (_e4068[0].member_1 == 0u))), _e4076)) - select(0u, 1u, (_e4071.member_1 < select(_e4084[0].member_1, (~(_e4068[0].member_1) + 1u), _e4076)))) >> bitcast<u32>(31i)) != 0u)) | (select(0u, select(1u, 2u, ((_e4103[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e4110.member - select(_e4123[1].member, (~(_e4103[1].member) + select(0u, 1u, (_e4107[1].member_1 == 0u))), _e4115)) - select(0u, 1u, (_e4110.member_1 < select(_e4123[1].member_1, (~(_e4107[1].member_1) + 1u), _e4115)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(2i))) | (select(0u, select(1u, 2u, ((_e4145[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e4152.member - select(_e4165[2].member, (~(_e4145[2].member) + select(0u, 1u, (_e4149[2].member_1 == 0u))), _e4157)) - select(0u, 1u, (_e4152.member_1 < select(_e4165[2].member_1, (~(_e4149[2].member_1) + 1u), _e4157)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(4i))) | (select(0u, select(1u, 2u, ((_e4187[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e4194.member - select(_e4207[3].member, (~(_e4187[3].member) + select(0u, 1u, (_e4191[3].member_1 == 0u))), _e4199)) - select(0u, 1u, (_e4194.member_1 < select(_e4207[3].member_1, (~(_e4191[3].member_1) + 1u), _e4199)))) >> bitcast<u32>(31i)) != 0u)) << bitcast<u32>(6i)));
                                        let _e4936 = local_118;
                                        phi_5572_ = _e4936;
                                    } else {
                                        let _e4933 = local_117;
                                        phi_5571_ = _e4933;
                                        let _e4938 = local_119;
                                        phi_5572_ = _e4938;
                                    }
                                    let _e4229 = phi_5571_;
                                    let _e4231 = phi_5572_;
                                    phi_5573_ = _e4229;
                                    phi_5574_ = _e4231;
                                    phi_5575_ = false;
                                    phi_5576_ = false;
                                } else {
                                    phi_5573_ = u32();
                                    phi_5574_ = array<type_9, 4>();
                                    phi_5575_ = _e3935;
                                    phi_5576_ = _e3937;
                                }
                                let _e4233 = phi_5573_;
                                let _e4235 = phi_5574_;
                                let _e4237 = phi_5575_;
                                let _e4239 = phi_5576_;
                                phi_5577_ = _e4233;
                                phi_5578_ = _e4235;
                                phi_5579_ = _e3921;
                                phi_5580_ = _e3923;
                                phi_5581_ = _e3925;
                                phi_5582_ = _e3927;
                                phi_5583_ = _e3929;
                                phi_5584_ = _e3931;
                                phi_5585_ = _e3933;
                                phi_5586_ = _e4237;
                                phi_5587_ = _e4239;
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
                                phi_5588_ = _e3858;
                                phi_5589_ = _e3860;
                                phi_5590_ = _e3862;
                            }
                            let _e4241 = phi_5577_;
                            let _e4243 = phi_5578_;
                            let _e4245 = phi_5579_;
                            let _e4247 = phi_5580_;
                            let _e4249 = phi_5581_;
                            let _e4251 = phi_5582_;
                            let _e4253 = phi_5583_;
                            let _e4255 = phi_5584_;
                            let _e4257 = phi_5585_;
                            let _e4259 = phi_5586_;
                            let _e4261 = phi_5587_;
                            let _e4263 = phi_5588_;
                            let _e4265 = phi_5589_;
                            let _e4267 = phi_5590_;
                            phi_2396_ = _e4241;
                            phi_2399_ = _e4243;
                            phi_2401_ = _e4245;
                            phi_2403_ = _e4247;
                            phi_2405_ = _e4249;
                            phi_2407_ = _e4251;
                            phi_2409_ = _e3848;
                            let _e4966 = local_120;
                            phi_2411_ = _e4966;
                            let _e4969 = local_121;
                            phi_2413_ = _e4969;
                            let _e4972 = local_122;
                            phi_2415_ = _e4972;
                            phi_2417_ = _e4253;
                            phi_2419_ = _e4255;
                            phi_5591_ = _e3852;
                            phi_5592_ = _e3854;
                            phi_5593_ = _e4257;
                            phi_5594_ = false;
                            phi_5595_ = _e4259;
                            phi_5596_ = _e4261;
                            phi_5597_ = _e4263;
                            phi_5598_ = _e4265;
                            phi_5599_ = _e4267;
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
                        let _e4269 = phi_2396_;
                        let _e4271 = phi_2399_;
                        let _e4273 = phi_2401_;
                        let _e4275 = phi_2403_;
                        let _e4277 = phi_2405_;
                        let _e4279 = phi_2407_;
                        let _e4281 = phi_2409_;
                        let _e4283 = phi_2411_;
                        let _e4285 = phi_2413_;
                        let _e4287 = phi_2415_;
                        let _e4289 = phi_2417_;
                        let _e4291 = phi_2419_;
                        let _e4293 = phi_5591_;
                        let _e4295 = phi_5592_;
                        let _e4297 = phi_5593_;
                        let _e4299 = phi_5594_;
                        let _e4301 = phi_5595_;
                        let _e4303 = phi_5596_;
                        let _e4305 = phi_5597_;
                        let _e4307 = phi_5598_;
                        let _e4309 = phi_5599_;
                        local_93 = _e4299;
                        local_94 = _e4299;
                        local_95 = _e4299;
                        local_96 = _e4301;
                        local_97 = _e4299;
                        local_98 = _e4303;
                        local_99 = _e4299;
                        local_100 = _e4305;
                        local_101 = _e4299;
                        local_102 = _e4307;
                        local_103 = _e4299;
                        local_104 = _e4309;
                        local_105 = _e4293;
                        local_106 = _e4293;
                        local_107 = _e4295;
                        continue;
                        continuing {
                            phi_2395_ = _e4269;
                            phi_2398_ = _e4271;
                            phi_2400_ = _e4273;
                            phi_2402_ = _e4275;
                            phi_2404_ = _e4277;
                            phi_2406_ = _e4279;
                            phi_2408_ = _e4281;
                            phi_2410_ = _e4283;
                            phi_2412_ = _e4285;
                            phi_2414_ = _e4287;
                            phi_2416_ = _e4289;
                            phi_2418_ = _e4291;
                            break if !(_e4297);
                        }
                    }
                    let _e4313 = local_93;
                    let _e4318 = local_94;
                    let _e4321 = local_95;
                    let _e4323 = local_96;
                    let _e4324 = select(_e4323, false, _e4321);
                    let _e4326 = local_97;
                    let _e4328 = local_98;
                    let _e4331 = local_99;
                    let _e4333 = local_100;
                    let _e4336 = local_101;
                    let _e4338 = local_102;
                    let _e4341 = local_103;
                    let _e4343 = local_104;
                    let _e4345 = select(select(_e4328, false, _e4326), false, _e4324);
                    let _e4349 = select(_e4324, true, _e4345);
                    let _e4358 = select(select(select(select(_e4333, false, _e4331), false, _e4324), false, _e4345), false, _e4349);
                    if _e4358 {
                        let _e4362 = local_105;
                        let _e4367 = local_106;
                        phi_5641_ = type_9(select(2u, 3u, _e4362), select(type_9().member_1, type_9().member_1, _e4367));
                        phi_5642_ = false;
                        phi_5643_ = false;
                        phi_5644_ = false;
                    } else {
                        phi_5641_ = type_9();
                        phi_5642_ = select(select(select(select(_e4338, false, _e4336), false, _e4324), false, _e4345), false, _e4349);
                        phi_5643_ = select(select(select(select(_e4343, false, _e4341), false, _e4324), false, _e4345), false, _e4349);
                        phi_5644_ = _e4349;
                    }
                    let _e4371 = phi_5641_;
                    let _e4373 = phi_5642_;
                    let _e4375 = phi_5643_;
                    let _e4377 = phi_5644_;
                    let _e4383 = select(_e4375, false, _e4373);
                    let _e4387 = local_107;
                    let _e4391 = select(_e4373, true, _e4383);
                    let _e4398 = select(select(select(_e4358, false, _e4373), false, _e4383), true, _e4391);
                    let _e4402 = select(select(select(select(_e4377, false, _e4373), false, _e4383), false, _e4391), true, _e4398);
                    phi_5680_ = type_9(select(select(type_9().member, 2u, _e4313), select(select(type_9().member, 0u, _e4349), select(_e4371.member, select(select(type_9().member, 2u, _e4373), 1u, _e4383), _e4391), _e4398), _e4402), select(select(type_9().member_1, type_9().member_1, _e4318), select(select(type_9().member_1, type_9().member_1, _e4349), select(_e4371.member_1, select(select(type_9().member_1, type_9().member_1, _e4373), _e4387.member, _e4383), _e4391), _e4398), _e4402));
                }
                let _e4409 = phi_5680_;
                phi_5684_ = _e4409;
                phi_5685_ = type_9(_e186, _e189);
            } else {
                phi_5684_ = type_9(0u, u32());
                phi_5685_ = type_9(0u, 0u);
            }
            let _e4411 = phi_5684_;
            let _e4413 = phi_5685_;
            let _e4417 = params.member.member_2.member_1;
            switch bitcast<i32>(_e4411.member) {
                case 0: {
                    phi_5722_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                    phi_5723_ = false;
                    break;
                }
                case 1: {
                    if (_e4411.member_1 == 0u) {
                        phi_5719_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e4426 = select((bitcast<u32>(31i) - firstLeadingBit(_e4411.member_1)), 32u, (_e4411.member_1 == 0u));
                        let _e4431 = ((_e4411.member_1 << bitcast<u32>((_e4426 & 31u))) << bitcast<u32>(1i));
                        phi_5719_ = array<u32, 2>((_e4431 << bitcast<u32>(20i)), (((1023u - _e4426) << bitcast<u32>(20i)) | (_e4431 >> bitcast<u32>(12i))));
                    }
                    let _e4442 = phi_5719_;
                    phi_5722_ = type_26(0u, select(0u, 1u, (_e4411.member_1 > _e4417)), _e4442, true);
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
            let _e4445 = phi_5722_;
            let _e4447 = phi_5723_;
            if _e4447 {
                phi_5727_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
            } else {
                phi_5727_ = _e4445;
            }
            let _e4449 = phi_5727_;
            local_1 = type_26(_e4449.member, _e4449.member_1, array<u32, 2>(_e4449.member_2[0], _e4449.member_2[1]), _e4449.member_3);
            let _e4462 = global.member;
            if (bitcast<i32>(_e4411.member) == bitcast<i32>(_e4462)) {
                if (bitcast<i32>(_e4411.member) == 1i) {
                    let _e4469 = global.member;
                    if (bitcast<i32>(_e4469) == 1i) {
                        let _e4474 = global.member_1;
                        phi_5767_ = (_e4411.member_1 == _e4474);
                        phi_5768_ = false;
                    } else {
                        phi_5767_ = bool();
                        phi_5768_ = true;
                    }
                    let _e4477 = phi_5767_;
                    let _e4479 = phi_5768_;
                    phi_5769_ = _e4477;
                    phi_5770_ = _e4479;
                } else {
                    phi_5769_ = bool();
                    phi_5770_ = true;
                }
                let _e4481 = phi_5769_;
                let _e4483 = phi_5770_;
                phi_5775_ = select(_e4481, true, _e4483);
            } else {
                phi_5775_ = false;
            }
            let _e4486 = phi_5775_;
            let _e4491 = params.member.member_2.member.member;
            let _e4494 = local_1.member;
            let _e4495 = (_e4494 == 0u);
            let _e4500 = select(select(select((_e4491 > 0u), bool(), _e4486), bool(), _e4495), false, select(_e4486, true, _e4495));
            if _e4500 {
                local = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e4501 = local_1;
                local = _e4501;
            }
            let _e4503 = local.member;
            let _e4505 = select(true, false, (_e4503 == 0u));
            let _e4507 = local.member_3;
            if _e4507 {
                if _e4505 {
                    phi_5831_ = true;
                } else {
                    let _e4509 = params.member.member.member_1;
                    phi_5831_ = ((_e4509 & 16u) != 0u);
                }
                let _e4513 = phi_5831_;
                phi_5832_ = _e4513;
            } else {
                phi_5832_ = false;
            }
            let _e4515 = phi_5832_;
            let _e4517 = local.member_3;
            if _e4517 {
                if _e4505 {
                } else {
                    let _e4519 = local.member_2;
                    let _e4523 = (_e4519[1] >> bitcast<u32>(20i));
                    let _e4537 = atomicMin((&earliest.member[0u]), select(((((_e4523 - 896u) << bitcast<u32>(23i)) | ((_e4519[1] & 1048575u) << bitcast<u32>(3i))) | (_e4519[0] >> bitcast<u32>(29i))), 0u, (_e4523 <= 896u)));
                }
            }
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4515 {
                let _e4541 = atomicAdd((&counters[0u]), 1u);
                phi_5875_ = _e4541;
            } else {
                phi_5875_ = 0u;
            }
            let _e4543 = phi_5875_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e4546 = atomicLoad((&counters[0u]));
                if (_e4546 > 0u) {
                    let _e4549 = atomicAdd((&contacts.member[0u]), _e4546);
                    atomicStore((&counters[1u]), _e4549);
                }
            }
            workgroupBarrier();
            let _e4552 = atomicLoad((&counters[1u]));
            let _e4553 = (_e4552 + _e4543);
            if _e4515 {
                let _e4555 = params.member.member_1.member_3;
                if (_e4553 < _e4555) {
                    let _e4561 = (7u * _e4553);
                    atomicStore((&contacts.member[(4u + _e4561)]), select(1u, 0u, ((_e4413.member_1 & 2147483648u) == 0u)));
                    let _e4566 = local.member;
                    atomicStore((&contacts.member[(_e4561 + 5u)]), _e4566);
                    atomicStore((&contacts.member[(_e4561 + 6u)]), _e4413.member);
                    atomicStore((&contacts.member[(_e4561 + 7u)]), (_e4413.member_1 & 2147483647u));
                    let _e4575 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e4561 + 8u)]), _e4575);
                    let _e4580 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e4561 + 9u)]), _e4580);
                    let _e4584 = local.member_1;
                    atomicStore((&contacts.member[(_e4561 + 10u)]), _e4584);
                }
            }
            workgroupBarrier();
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4500 {
                let _e4589 = atomicAdd((&counters[0u]), 1u);
                phi_5957_ = _e4589;
            } else {
                phi_5957_ = 0u;
            }
            let _e4591 = phi_5957_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e4594 = atomicLoad((&counters[0u]));
                if (_e4594 > 0u) {
                    let _e4597 = atomicAdd((&left.member[0u]), _e4594);
                    atomicStore((&counters[1u]), _e4597);
                }
            }
            workgroupBarrier();
            let _e4600 = atomicLoad((&counters[1u]));
            let _e4601 = (_e4600 + _e4591);
            if _e4500 {
                if (_e4601 < _e4491) {
                    let _e4603 = (2u * _e4601);
                    atomicStore((&left.member[(4u + _e4603)]), _e4413.member);
                    atomicStore((&left.member[(_e4603 + 5u)]), _e4413.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_311_ = type_9(select(_e156.member, (_e156.member + 1u), _e159), select(_e156.member_1, _e156.member_1, _e159));
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_9(id, n, lane);
}
