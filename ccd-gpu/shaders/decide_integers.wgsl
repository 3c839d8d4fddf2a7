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

struct type_28 {
    member: type_19,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_29 {
    member: type_7,
    member_1: type_8,
    member_2: type_28,
}

struct type_30 {
    member: type_29,
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
var<storage> params: type_30;
@group(0) @binding(2) 
var<storage> positions: type_11;
var<private> global: type_9 = type_9(3u, u32());

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: u32, param_3: u32, param_4: u32, param_5: u32) -> bool {
    return ((((param_4 - param_2) - select(0u, 1u, (param_5 < param_3))) >> bitcast<u32>(31i)) != 0u);
}

fn function_2(param_6: u32, param_7: u32, param_8: u32, param_9: u32) -> bool {
    return ((((param_8 - (~(param_6) + select(0u, 1u, (param_7 == 0u)))) - select(0u, 1u, (param_9 < (~(param_7) + 1u)))) >> bitcast<u32>(31i)) != 0u);
}

fn function_3(param_10: u32) -> type_9 {
    return type_9(0u, param_10);
}

fn function_4(param_11: u32, param_12: u32, param_13: u32, param_14: u32) -> type_9 {
    let _e14 = bitcast<u32>((bitcast<i32>(param_11) >> bitcast<u32>(31i)));
    let _e18 = bitcast<u32>((bitcast<i32>(param_13) >> bitcast<u32>(31i)));
    let _e20 = (param_11 >> bitcast<u32>(16i));
    let _e21 = (param_11 & 65535u);
    let _e23 = (param_13 >> bitcast<u32>(16i));
    let _e24 = (param_13 & 65535u);
    let _e29 = ((_e20 * _e24) + ((_e21 * _e24) >> bitcast<u32>(16i)));
    let _e40 = (param_11 * param_13);
    let _e42 = (param_11 >> bitcast<u32>(16i));
    let _e43 = (param_11 & 65535u);
    let _e45 = (param_14 >> bitcast<u32>(16i));
    let _e46 = (param_14 & 65535u);
    let _e51 = ((_e42 * _e46) + ((_e43 * _e46) >> bitcast<u32>(16i)));
    let _e64 = (param_12 >> bitcast<u32>(16i));
    let _e65 = (param_12 & 65535u);
    let _e67 = (param_13 >> bitcast<u32>(16i));
    let _e68 = (param_13 & 65535u);
    let _e73 = ((_e64 * _e68) + ((_e65 * _e68) >> bitcast<u32>(16i)));
    let _e84 = (param_12 * param_13);
    let _e90 = ((((_e42 * _e45) + (_e51 >> bitcast<u32>(16i))) + (((_e43 * _e45) + (_e51 & 65535u)) >> bitcast<u32>(16i))) - (_e14 & param_14));
    let _e92 = ((((_e64 * _e67) + (_e73 >> bitcast<u32>(16i))) + (((_e65 * _e67) + (_e73 & 65535u)) >> bitcast<u32>(16i))) - (_e18 & param_12));
    let _e93 = ((param_11 * param_14) + _e84);
    let _e100 = (_e40 + _e90);
    let _e109 = (_e100 + _e92);
    let _e114 = function_3(select(0u, 1u, (_e93 < _e84)));
    let _e117 = (_e109 + _e114.member_1);
    return type_9((((((((((((((_e20 * _e23) + (_e29 >> bitcast<u32>(16i))) + (((_e21 * _e23) + (_e29 & 65535u)) >> bitcast<u32>(16i))) - (_e14 & param_13)) - (_e18 & param_11)) + bitcast<u32>((bitcast<i32>(_e90) >> bitcast<u32>(31i)))) + select(0u, 1u, (_e100 < _e40))) + bitcast<u32>((bitcast<i32>(_e92) >> bitcast<u32>(31i)))) + select(0u, 1u, (_e109 < _e100))) + _e114.member) + select(0u, 1u, (_e117 < _e109))) << bitcast<u32>(2i)) | (_e117 >> bitcast<u32>(30i))), ((_e117 << bitcast<u32>(2i)) | (_e93 >> bitcast<u32>(30i))));
}

fn function_5(param_15: array<type_9, 2>, param_16: array<type_9, 2>) -> type_9 {
    let _e12 = function_4(param_15[0].member, param_15[0].member_1, param_16[1].member, param_16[1].member_1);
    let _e23 = function_4(param_15[1].member, param_15[1].member_1, param_16[0].member, param_16[0].member_1);
    return type_9(((_e12.member - _e23.member) - select(0u, 1u, (_e12.member_1 < _e23.member_1))), (_e12.member_1 - _e23.member_1));
}

fn function_6(param_17: u32, param_18: u32, param_19: u32) -> type_9 {
    let _e10 = (param_17 >> bitcast<u32>(16i));
    let _e11 = (param_17 & 65535u);
    let _e13 = (param_19 >> bitcast<u32>(16i));
    let _e14 = (param_19 & 65535u);
    let _e19 = ((_e10 * _e14) + ((_e11 * _e14) >> bitcast<u32>(16i)));
    let _e30 = (param_17 * param_19);
    let _e32 = (param_18 >> bitcast<u32>(16i));
    let _e33 = (param_18 & 65535u);
    let _e35 = (param_19 >> bitcast<u32>(16i));
    let _e36 = (param_19 & 65535u);
    let _e41 = ((_e32 * _e36) + ((_e33 * _e36) >> bitcast<u32>(16i)));
    let _e59 = function_3((((_e32 * _e35) + (_e41 >> bitcast<u32>(16i))) + (((_e33 * _e35) + (_e41 & 65535u)) >> bitcast<u32>(16i))));
    let _e62 = (_e30 + _e59.member_1);
    return type_9(((((((((_e10 * _e13) + (_e19 >> bitcast<u32>(16i))) + (((_e11 * _e13) + (_e19 & 65535u)) >> bitcast<u32>(16i))) - (bitcast<u32>((bitcast<i32>(param_17) >> bitcast<u32>(31i))) & param_19)) + _e59.member) + select(0u, 1u, (_e62 < _e30))) << bitcast<u32>(1i)) | (_e62 >> bitcast<u32>(31i))), ((_e62 << bitcast<u32>(1i)) | ((param_18 * param_19) >> bitcast<u32>(31i))));
}

fn function_7(param_20: f32, param_21: f32, param_22: f32) -> f32 {
    return (param_20 + ((param_21 - param_20) * param_22));
}

fn function_8(param_23: u32) -> type_9 {
    return type_9(0u, param_23);
}

fn function_9(param_24: u32, param_25: u32) -> type_9 {
    let _e4 = (param_25 + param_25);
    let _e9 = (_e4 + param_25);
    return type_9(((((param_24 + param_24) + select(0u, 1u, (_e4 < param_25))) + param_24) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_10(param_26: array<u32, 2>, param_27: i32) -> type_9 {
    var phi_6398_: type_9;
    var phi_6399_: type_9;
    var phi_6400_: type_9;
    var phi_6401_: type_9;
    var phi_6402_: type_9;
    var phi_6403_: bool;

    let _e24 = ((param_26[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_26[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_27);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_6402_ = type_9();
        phi_6403_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_6401_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_6400_ = type_9((param_26[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_6399_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_26[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_26[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_6398_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_26[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_6398_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_6398_;
                    phi_6399_ = _e67;
                }
                let _e83 = phi_6399_;
                phi_6400_ = _e83;
            }
            let _e89 = phi_6400_;
            phi_6401_ = _e89;
        }
        let _e91 = phi_6401_;
        phi_6402_ = _e91;
        phi_6403_ = _e37;
    }
    let _e93 = phi_6402_;
    let _e95 = phi_6403_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_26[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_11(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<type_9, 3>;
    var local_2: type_26;
    var phi_264_: u32;
    var phi_310_: u32;
    var phi_313_: type_9;
    var phi_488_: type_20;
    var phi_623_: type_25;
    var phi_890_: type_14;
    var phi_893_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_895_: array<u32, 4>;
    var phi_891_: type_14;
    var phi_936_: type_15;
    var phi_1186_: array<array<u32, 2>, 3>;
    var phi_1187_: array<array<u32, 2>, 3>;
    var phi_894_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_896_: array<u32, 4>;
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
    var local_26: array<array<array<type_9, 3>, 2>, 4>;
    var phi_1780_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_1794_: type_14;
    var phi_1797_: array<type_9, 4>;
    var phi_1799_: array<array<type_9, 3>, 2>;
    var phi_1801_: array<array<type_9, 3>, 2>;
    var phi_1803_: array<array<type_9, 3>, 2>;
    var phi_1795_: type_14;
    var phi_1844_: type_15;
    var phi_1798_: array<type_9, 4>;
    var phi_1800_: array<array<type_9, 3>, 2>;
    var phi_1802_: array<array<type_9, 3>, 2>;
    var phi_1804_: array<array<type_9, 3>, 2>;
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
    var phi_2155_: array<type_9, 4>;
    var phi_2158_: bool;
    var phi_2160_: bool;
    var phi_2162_: bool;
    var phi_2164_: bool;
    var phi_2166_: type_17;
    var phi_2170_: u32;
    var phi_2172_: u32;
    var phi_2174_: u32;
    var phi_2176_: u32;
    var phi_2178_: u32;
    var phi_2187_: array<type_9, 4>;
    var phi_2190_: bool;
    var phi_2192_: bool;
    var phi_2196_: bool;
    var phi_2198_: bool;
    var phi_2200_: bool;
    var phi_2202_: bool;
    var phi_2204_: u32;
    var phi_2206_: u32;
    var phi_2208_: u32;
    var phi_2210_: u32;
    var phi_2212_: u32;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var phi_2419_: bool;
    var phi_3061_: array<type_9, 4>;
    var phi_3062_: bool;
    var phi_3063_: u32;
    var phi_3064_: array<type_9, 4>;
    var phi_3065_: bool;
    var phi_3066_: bool;
    var phi_3068_: u32;
    var phi_3069_: u32;
    var phi_3070_: array<type_9, 4>;
    var phi_3071_: bool;
    var phi_3072_: bool;
    var phi_3074_: u32;
    var phi_3075_: u32;
    var phi_3076_: array<type_9, 4>;
    var phi_3077_: bool;
    var phi_3078_: bool;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3084_: u32;
    var phi_3085_: u32;
    var phi_3086_: u32;
    var phi_3087_: u32;
    var phi_3088_: u32;
    var phi_3089_: bool;
    var phi_3090_: array<type_9, 4>;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: u32;
    var phi_3099_: u32;
    var phi_3100_: u32;
    var phi_3101_: u32;
    var phi_3102_: u32;
    var phi_3103_: bool;
    var phi_2188_: array<type_9, 4>;
    var phi_2191_: bool;
    var phi_2193_: bool;
    var phi_2197_: bool;
    var phi_2199_: bool;
    var phi_2201_: bool;
    var phi_2203_: bool;
    var phi_2205_: u32;
    var phi_2207_: u32;
    var phi_2209_: u32;
    var phi_2211_: u32;
    var phi_2213_: u32;
    var phi_3104_: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: array<type_9, 4>;
    var local_40: array<type_9, 4>;
    var local_41: array<type_9, 4>;
    var local_42: array<type_9, 4>;
    var local_43: array<type_9, 4>;
    var local_44: array<type_9, 4>;
    var local_45: array<type_9, 4>;
    var local_46: array<type_9, 4>;
    var local_47: array<type_9, 4>;
    var local_48: array<type_9, 4>;
    var local_49: array<type_9, 4>;
    var local_50: array<type_9, 4>;
    var local_51: u32;
    var local_52: u32;
    var local_53: u32;
    var local_54: u32;
    var local_55: array<type_9, 4>;
    var local_56: array<type_9, 4>;
    var local_57: array<type_9, 4>;
    var local_58: array<type_9, 4>;
    var local_59: array<type_9, 4>;
    var local_60: array<type_9, 4>;
    var local_61: u32;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: u32;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var local_68: array<type_9, 4>;
    var phi_3458_: bool;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3464_: bool;
    var local_69: bool;
    var local_70: bool;
    var local_71: u32;
    var local_72: u32;
    var phi_3653_: type_17;
    var local_73: u32;
    var local_74: u32;
    var local_75: array<type_9, 4>;
    var local_76: array<type_9, 4>;
    var local_77: array<type_9, 4>;
    var local_78: array<type_9, 4>;
    var local_79: array<type_9, 4>;
    var local_80: array<type_9, 4>;
    var local_81: array<type_9, 4>;
    var local_82: array<type_9, 4>;
    var phi_3515_: type_14;
    var phi_3518_: f32;
    var phi_3520_: f32;
    var phi_3522_: f32;
    var phi_3516_: type_14;
    var phi_3563_: type_15;
    var phi_3519_: f32;
    var phi_3521_: f32;
    var phi_3523_: f32;
    var local_83: f32;
    var phi_3654_: bool;
    var phi_3655_: type_17;
    var phi_3656_: type_17;
    var local_84: u32;
    var local_85: u32;
    var phi_3657_: bool;
    var phi_3658_: type_17;
    var phi_3659_: type_17;
    var local_86: array<type_9, 4>;
    var local_87: array<type_9, 4>;
    var local_88: array<type_9, 4>;
    var phi_3726_: u32;
    var phi_3727_: u32;
    var phi_3728_: u32;
    var phi_3731_: type_14;
    var phi_3734_: u32;
    var phi_3736_: u32;
    var phi_3732_: type_14;
    var phi_3776_: type_15;
    var phi_3735_: u32;
    var local_89: u32;
    var phi_3952_: bool;
    var phi_3960_: bool;
    var phi_3961_: type_17;
    var phi_4982_: array<type_9, 2>;
    var phi_5011_: array<type_9, 2>;
    var phi_5040_: array<type_9, 2>;
    var phi_5054_: type_9;
    var phi_5376_: type_9;
    var phi_5377_: type_9;
    var phi_5378_: type_9;
    var phi_5379_: type_9;
    var phi_5493_: bool;
    var phi_5494_: bool;
    var phi_5495_: bool;
    var phi_5500_: u32;
    var phi_5501_: u32;
    var phi_5502_: bool;
    var phi_5503_: u32;
    var phi_5504_: bool;
    var phi_5505_: u32;
    var phi_5506_: bool;
    var phi_5511_: u32;
    var local_90: bool;
    var phi_5583_: bool;
    var phi_5584_: bool;
    var phi_5585_: bool;
    var phi_5586_: bool;
    var phi_5587_: bool;
    var phi_5594_: bool;
    var phi_5595_: bool;
    var phi_5596_: bool;
    var phi_5597_: bool;
    var phi_5598_: type_17;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_5601_: type_17;
    var phi_5602_: bool;
    var phi_5603_: bool;
    var phi_5604_: bool;
    var phi_5605_: bool;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5609_: bool;
    var phi_5610_: type_17;
    var phi_5611_: bool;
    var phi_5612_: bool;
    var phi_5613_: type_17;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: bool;
    var local_91: u32;
    var local_92: u32;
    var local_93: u32;
    var local_94: u32;
    var local_95: u32;
    var local_96: u32;
    var phi_5668_: u32;
    var phi_5669_: u32;
    var phi_5670_: bool;
    var phi_5671_: bool;
    var phi_5672_: u32;
    var phi_5673_: u32;
    var phi_5674_: bool;
    var phi_5675_: bool;
    var phi_5676_: bool;
    var phi_5677_: bool;
    var phi_5678_: u32;
    var phi_5679_: u32;
    var phi_5680_: bool;
    var phi_5681_: bool;
    var phi_5682_: bool;
    var phi_5707_: type_14;
    var phi_5710_: array<u32, 3>;
    var phi_5712_: array<type_9, 4>;
    var phi_5708_: type_14;
    var phi_5753_: type_15;
    var phi_5711_: array<u32, 3>;
    var phi_5713_: array<type_9, 4>;
    var phi_5906_: array<type_9, 4>;
    var phi_5907_: array<type_9, 4>;
    var phi_5908_: bool;
    var phi_5909_: bool;
    var phi_5910_: array<type_9, 4>;
    var phi_5911_: bool;
    var phi_5912_: bool;
    var phi_5913_: bool;
    var phi_5914_: bool;
    var phi_5915_: u32;
    var phi_5916_: u32;
    var phi_5917_: bool;
    var phi_5918_: bool;
    var phi_5919_: bool;
    var phi_5920_: bool;
    var phi_5921_: bool;
    var phi_5922_: bool;
    var phi_2156_: array<type_9, 4>;
    var phi_2159_: bool;
    var phi_2161_: bool;
    var phi_2163_: bool;
    var phi_2165_: bool;
    var phi_2167_: type_17;
    var phi_2171_: u32;
    var phi_2173_: u32;
    var phi_2175_: u32;
    var phi_2177_: u32;
    var phi_2179_: u32;
    var phi_5923_: bool;
    var phi_5924_: type_17;
    var phi_5925_: bool;
    var phi_5926_: bool;
    var phi_5927_: bool;
    var phi_5928_: bool;
    var phi_5929_: bool;
    var phi_5930_: bool;
    var phi_5931_: bool;
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
    var local_107: bool;
    var local_108: bool;
    var local_109: bool;
    var local_110: bool;
    var phi_5973_: type_9;
    var phi_5974_: bool;
    var phi_5975_: bool;
    var phi_5976_: bool;
    var local_111: type_17;
    var phi_6012_: type_9;
    var phi_6016_: type_9;
    var phi_6017_: type_9;
    var phi_6051_: array<u32, 2>;
    var phi_6054_: type_26;
    var phi_6055_: bool;
    var phi_6059_: type_26;
    var phi_6099_: bool;
    var phi_6100_: bool;
    var phi_6101_: bool;
    var phi_6102_: bool;
    var phi_6107_: bool;
    var phi_6163_: bool;
    var phi_6164_: bool;
    var phi_6207_: u32;
    var phi_6289_: u32;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var local_116: bool;
    var local_117: bool;
    var local_118: bool;
    var local_119: u32;
    var local_120: u32;
    var local_121: array<type_9, 4>;
    var local_122: array<type_9, 4>;
    var local_123: u32;
    var local_124: u32;
    var local_125: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e91 = id_2;
    let _e92 = n_2;
    let _e93 = lane_2;
    let _e106 = ((_e91.y * _e92.x) + _e91.x);
    let _e109 = (_e92.x * _e92.y);
    let _e112 = params.member.member_1.member_2;
    let _e114 = input.member[0u];
    let _e116 = select(_e114, _e112, (_e112 < _e114));
    let _e118 = params.member.member_1.member_1;
    if (_e116 > _e118) {
        let _e121 = params.member.member_1.member_1;
        phi_264_ = (_e116 - _e121);
    } else {
        phi_264_ = 0u;
    }
    let _e124 = phi_264_;
    let _e126 = params.member.member_1.member;
    let _e128 = select(_e124, _e126, (_e126 < _e124));
    let _e130 = (_e128 / 64u);
    let _e134 = select(_e130, (_e130 + 1u), ((_e128 % 64u) > 0u));
    if (_e134 > _e106) {
        let _e136 = (_e134 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e138 = (_e136 / _e109);
        if (_e109 == 0u) {
            return;
        }
        phi_310_ = select(_e138, (_e138 + 1u), ((_e136 % _e109) > 0u));
    } else {
        phi_310_ = 0u;
    }
    let _e145 = phi_310_;
    phi_313_ = type_9(0u, _e145);
    loop {
        let _e148 = phi_313_;
        let _e151 = (_e148.member < _e148.member_1);
        let _e164 = (bitcast<i32>(select(0u, 1u, _e151)) != 0i);
        if _e164 {
            let _e168 = (((_e106 + (select(type_9().member_1, _e148.member, _e151) * _e109)) * 64u) + _e93);
            if (_e168 < _e128) {
                let _e173 = params.member.member_1.member_1;
                let _e175 = (2u * (_e173 + _e168));
                let _e178 = input.member[(4u + _e175)];
                let _e181 = input.member[(_e175 + 5u)];
                let _e186 = (_e181 & 2147483647u);
                if (select(1u, 0u, ((_e181 & 2147483648u) == 0u)) == 0u) {
                    let _e205 = params.member.member.member[1u];
                    let _e208 = ((2u * _e205) + (3u * _e186));
                    let _e210 = elements.member[_e208];
                    let _e213 = elements.member[(_e208 + 1u)];
                    let _e216 = elements.member[(_e208 + 2u)];
                    phi_488_ = type_20(0u, array<u32, 4>(_e178, _e210, _e213, _e216));
                } else {
                    let _e189 = (2u * _e178);
                    let _e191 = elements.member[_e189];
                    let _e194 = elements.member[(_e189 + 1u)];
                    let _e195 = (2u * _e186);
                    let _e197 = elements.member[_e195];
                    let _e200 = elements.member[(_e195 + 1u)];
                    phi_488_ = type_20(1u, array<u32, 4>(_e191, _e194, _e197, _e200));
                }
                let _e220 = phi_488_;
                let _e225 = paths.member[_e220.member_1[0]];
                let _e240 = paths.member[_e220.member_1[1]];
                let _e255 = paths.member[_e220.member_1[2]];
                let _e270 = paths.member[_e220.member_1[3]];
                let _e284 = params.member.member.member_4;
                if (_e220.member != 0u) {
                    phi_623_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e225.member.x), (_e255.member.y - _e225.member.y), (_e255.member.z - _e225.member.z)), array<f32, 3>((_e255.member_1.x - _e225.member_1.x), (_e255.member_1.y - _e225.member_1.y), (_e255.member_1.z - _e225.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e240.member.x - _e225.member.x), (_e240.member.y - _e225.member.y), (_e240.member.z - _e225.member.z)), array<f32, 3>((_e240.member_1.x - _e225.member_1.x), (_e240.member_1.y - _e225.member_1.y), (_e240.member_1.z - _e225.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e270.member.x), (_e255.member.y - _e270.member.y), (_e255.member.z - _e270.member.z)), array<f32, 3>((_e255.member_1.x - _e270.member_1.x), (_e255.member_1.y - _e270.member_1.y), (_e255.member_1.z - _e270.member_1.z))), (_e284 + _e284));
                } else {
                    phi_623_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e225.member.x - _e240.member.x), (_e225.member.y - _e240.member.y), (_e225.member.z - _e240.member.z)), array<f32, 3>((_e225.member_1.x - _e240.member_1.x), (_e225.member_1.y - _e240.member_1.y), (_e225.member_1.z - _e240.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e240.member.x), (_e255.member.y - _e240.member.y), (_e255.member.z - _e240.member.z)), array<f32, 3>((_e255.member_1.x - _e240.member_1.x), (_e255.member_1.y - _e240.member_1.y), (_e255.member_1.z - _e240.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e270.member.x - _e240.member.x), (_e270.member.y - _e240.member.y), (_e270.member.z - _e240.member.z)), array<f32, 3>((_e270.member_1.x - _e240.member_1.x), (_e270.member_1.y - _e240.member_1.y), (_e270.member_1.z - _e240.member_1.z))), (_e284 + _e284));
                }
                let _e345 = phi_623_;
                let _e351 = select(_e345.member[0][0], -(_e345.member[0][0]), (_e345.member[0][0] < 0f));
                let _e355 = select(_e345.member[0][1], -(_e345.member[0][1]), (_e345.member[0][1] < 0f));
                let _e357 = select(_e355, _e351, (_e351 > _e355));
                let _e361 = select(_e345.member[0][2], -(_e345.member[0][2]), (_e345.member[0][2] < 0f));
                let _e363 = select(_e361, _e357, (_e357 > _e361));
                let _e369 = select(_e345.member[1][0], -(_e345.member[1][0]), (_e345.member[1][0] < 0f));
                let _e373 = select(_e345.member[1][1], -(_e345.member[1][1]), (_e345.member[1][1] < 0f));
                let _e375 = select(_e373, _e369, (_e369 > _e373));
                let _e379 = select(_e345.member[1][2], -(_e345.member[1][2]), (_e345.member[1][2] < 0f));
                let _e381 = select(_e379, _e375, (_e375 > _e379));
                let _e391 = select(_e345.member_1[0][0], -(_e345.member_1[0][0]), (_e345.member_1[0][0] < 0f));
                let _e395 = select(_e345.member_1[0][1], -(_e345.member_1[0][1]), (_e345.member_1[0][1] < 0f));
                let _e397 = select(_e395, _e391, (_e391 > _e395));
                let _e401 = select(_e345.member_1[0][2], -(_e345.member_1[0][2]), (_e345.member_1[0][2] < 0f));
                let _e403 = select(_e401, _e397, (_e397 > _e401));
                let _e409 = select(_e345.member_1[1][0], -(_e345.member_1[1][0]), (_e345.member_1[1][0] < 0f));
                let _e413 = select(_e345.member_1[1][1], -(_e345.member_1[1][1]), (_e345.member_1[1][1] < 0f));
                let _e415 = select(_e413, _e409, (_e409 > _e413));
                let _e419 = select(_e345.member_1[1][2], -(_e345.member_1[1][2]), (_e345.member_1[1][2] < 0f));
                let _e421 = select(_e419, _e415, (_e415 > _e419));
                let _e431 = select(_e345.member_2[0][0], -(_e345.member_2[0][0]), (_e345.member_2[0][0] < 0f));
                let _e435 = select(_e345.member_2[0][1], -(_e345.member_2[0][1]), (_e345.member_2[0][1] < 0f));
                let _e437 = select(_e435, _e431, (_e431 > _e435));
                let _e441 = select(_e345.member_2[0][2], -(_e345.member_2[0][2]), (_e345.member_2[0][2] < 0f));
                let _e443 = select(_e441, _e437, (_e437 > _e441));
                let _e449 = select(_e345.member_2[1][0], -(_e345.member_2[1][0]), (_e345.member_2[1][0] < 0f));
                let _e453 = select(_e345.member_2[1][1], -(_e345.member_2[1][1]), (_e345.member_2[1][1] < 0f));
                let _e455 = select(_e453, _e449, (_e449 > _e453));
                let _e459 = select(_e345.member_2[1][2], -(_e345.member_2[1][2]), (_e345.member_2[1][2] < 0f));
                let _e461 = select(_e459, _e455, (_e455 > _e459));
                let _e466 = function_((select(_e381, _e363, (_e363 > _e381)) + _e345.member_3), (select(_e421, _e403, (_e403 > _e421)) + _e345.member_3));
                let _e467 = function_(_e466, (select(_e461, _e443, (_e443 > _e461)) + _e345.member_3));
                let _e472 = bitcast<i32>(((bitcast<u32>(_e467) + 4u) >> bitcast<u32>(23i)));
                let _e473 = (_e472 >= 64i);
                let _e474 = (_e472 <= 190i);
                let _e480 = select(select(i32(), select(i32(), (_e472 - 126i), _e474), _e473), 2147483647i, select(true, select(true, false, _e474), _e473));
                if (_e480 == 2147483647i) {
                    phi_6012_ = type_9(2u, type_9().member_1);
                } else {
                    let _e483 = params.member.member.member_1;
                    let _e485 = ((_e483 & 8u) != 0u);
                    let _e488 = params.member.member.member_10[1u];
                    let _e494 = select((_e480 - (bitcast<i32>((_e488 >> bitcast<u32>(20i))) - 1023i)), _e480, _e485);
                    phi_890_ = type_14(0i, 4i);
                    phi_893_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))));
                    phi_895_ = _e220.member_1;
                    loop {
                        let _e496 = phi_890_;
                        let _e498 = phi_893_;
                        let _e500 = phi_895_;
                        local_3 = _e498;
                        local_4 = _e498;
                        local_5 = _e498;
                        local_6 = _e498;
                        local_7 = _e498;
                        local_8 = _e498;
                        local_9 = _e498;
                        local_10 = _e498;
                        local_11 = _e498;
                        local_12 = _e498;
                        local_13 = _e498;
                        local_14 = _e498;
                        local_15 = _e498;
                        local_16 = _e498;
                        local_17 = _e498;
                        local_18 = _e498;
                        local_19 = _e498;
                        local_20 = _e498;
                        local_21 = _e498;
                        local_22 = _e498;
                        local_23 = _e498;
                        local_24 = _e498;
                        local_25 = _e498;
                        local_26 = _e498;
                        if (_e496.member < _e496.member_1) {
                            let _e507 = (_e496.member + 1i);
                            phi_891_ = type_14(select(_e507, type_15().member_1, select(false, true, ((false == (_e507 > _e496.member)) != false))), _e496.member_1);
                            phi_936_ = type_15(1u, _e496.member);
                        } else {
                            phi_891_ = _e496;
                            phi_936_ = type_15(0u, type_15().member_1);
                        }
                        let _e518 = phi_891_;
                        let _e520 = phi_936_;
                        let _e523 = (bitcast<i32>(_e520.member) != 0i);
                        if _e523 {
                            if _e485 {
                                let _e574 = paths.member[_e500[0]];
                                let _e587 = bitcast<u32>(_e574.member.x);
                                let _e588 = (_e587 & 2147483647u);
                                let _e589 = (_e588 < 8388608u);
                                let _e600 = bitcast<u32>(_e574.member.y);
                                let _e601 = (_e600 & 2147483647u);
                                let _e602 = (_e601 < 8388608u);
                                let _e613 = bitcast<u32>(_e574.member.z);
                                let _e614 = (_e613 & 2147483647u);
                                let _e615 = (_e614 < 8388608u);
                                let _e627 = bitcast<u32>(_e574.member_1.x);
                                let _e628 = (_e627 & 2147483647u);
                                let _e629 = (_e628 < 8388608u);
                                let _e640 = bitcast<u32>(_e574.member_1.y);
                                let _e641 = (_e640 & 2147483647u);
                                let _e642 = (_e641 < 8388608u);
                                let _e653 = bitcast<u32>(_e574.member_1.z);
                                let _e654 = (_e653 & 2147483647u);
                                let _e655 = (_e654 < 8388608u);
                                phi_1186_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e627 << bitcast<u32>(29i)), 0u, _e629), select(((_e627 ^ _e628) | ((_e628 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e629)), array<u32, 2>(select((_e640 << bitcast<u32>(29i)), 0u, _e642), select(((_e640 ^ _e641) | ((_e641 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e642)), array<u32, 2>(select((_e653 << bitcast<u32>(29i)), 0u, _e655), select(((_e653 ^ _e654) | ((_e654 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e655)));
                                phi_1187_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e587 << bitcast<u32>(29i)), 0u, _e589), select(((_e587 ^ _e588) | ((_e588 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e589)), array<u32, 2>(select((_e600 << bitcast<u32>(29i)), 0u, _e602), select(((_e600 ^ _e601) | ((_e601 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e602)), array<u32, 2>(select((_e613 << bitcast<u32>(29i)), 0u, _e615), select(((_e613 ^ _e614) | ((_e614 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e615)));
                            } else {
                                let _e527 = params.member.member.member[0u];
                                let _e529 = (6u * _e500[0]);
                                let _e531 = positions.member[_e529];
                                let _e534 = positions.member[(_e529 + 1u)];
                                let _e538 = positions.member[(_e529 + 2u)];
                                let _e541 = positions.member[(_e529 + 3u)];
                                let _e545 = positions.member[(_e529 + 4u)];
                                let _e548 = positions.member[(_e529 + 5u)];
                                let _e551 = (6u * (_e527 + _e500[0]));
                                let _e553 = positions.member[_e551];
                                let _e556 = positions.member[(_e551 + 1u)];
                                let _e560 = positions.member[(_e551 + 2u)];
                                let _e563 = positions.member[(_e551 + 3u)];
                                let _e567 = positions.member[(_e551 + 4u)];
                                let _e570 = positions.member[(_e551 + 5u)];
                                phi_1186_ = array<array<u32, 2>, 3>(array<u32, 2>(_e553, _e556), array<u32, 2>(_e560, _e563), array<u32, 2>(_e567, _e570));
                                phi_1187_ = array<array<u32, 2>, 3>(array<u32, 2>(_e531, _e534), array<u32, 2>(_e538, _e541), array<u32, 2>(_e545, _e548));
                            }
                            let _e668 = phi_1186_;
                            let _e670 = phi_1187_;
                            let _e677 = function_10(_e670[0], _e494);
                            let _e678 = function_10(_e670[1], _e494);
                            let _e679 = function_10(_e670[2], _e494);
                            let _e684 = function_10(_e668[0], _e494);
                            let _e685 = function_10(_e668[1], _e494);
                            let _e686 = function_10(_e668[2], _e494);
                            phi_894_ = array<array<array<type_9, 3>, 2>, 4>(_e498[1], _e498[2], _e498[3], array<array<type_9, 3>, 2>(array<type_9, 3>(_e677, _e678, _e679), array<type_9, 3>(_e684, _e685, _e686)));
                            phi_896_ = array<u32, 4>(_e500[1], _e500[2], _e500[3], _e500[0]);
                        } else {
                            phi_894_ = array<array<array<type_9, 3>, 2>, 4>();
                            phi_896_ = array<u32, 4>();
                        }
                        let _e696 = phi_894_;
                        let _e698 = phi_896_;
                        continue;
                        continuing {
                            phi_890_ = _e518;
                            phi_893_ = _e696;
                            phi_895_ = _e698;
                            break if !(_e523);
                        }
                    }
                    let _e701 = params.member.member_2.member_1;
                    let _e703 = params.member.member_2.member_2;
                    let _e705 = params.member.member_2.member_3;
                    if (_e220.member != 0u) {
                        let _e1018 = local_15;
                        let _e1022 = local_16;
                        let _e1069 = local_17;
                        let _e1073 = local_18;
                        let _e1121 = local_19;
                        let _e1125 = local_20;
                        let _e1172 = local_21;
                        let _e1176 = local_22;
                        let _e1224 = local_23;
                        let _e1228 = local_24;
                        let _e1275 = local_25;
                        let _e1279 = local_26;
                        phi_1780_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1018[2][0][0].member - _e1022[0][0][0].member) - select(0u, 1u, (_e1018[2][0][0].member_1 < _e1022[0][0][0].member_1))), (_e1018[2][0][0].member_1 - _e1022[0][0][0].member_1)), type_9(((_e1018[2][0][1].member - _e1022[0][0][1].member) - select(0u, 1u, (_e1018[2][0][1].member_1 < _e1022[0][0][1].member_1))), (_e1018[2][0][1].member_1 - _e1022[0][0][1].member_1)), type_9(((_e1018[2][0][2].member - _e1022[0][0][2].member) - select(0u, 1u, (_e1018[2][0][2].member_1 < _e1022[0][0][2].member_1))), (_e1018[2][0][2].member_1 - _e1022[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1069[2][1][0].member - _e1073[0][1][0].member) - select(0u, 1u, (_e1069[2][1][0].member_1 < _e1073[0][1][0].member_1))), (_e1069[2][1][0].member_1 - _e1073[0][1][0].member_1)), type_9(((_e1069[2][1][1].member - _e1073[0][1][1].member) - select(0u, 1u, (_e1069[2][1][1].member_1 < _e1073[0][1][1].member_1))), (_e1069[2][1][1].member_1 - _e1073[0][1][1].member_1)), type_9(((_e1069[2][1][2].member - _e1073[0][1][2].member) - select(0u, 1u, (_e1069[2][1][2].member_1 < _e1073[0][1][2].member_1))), (_e1069[2][1][2].member_1 - _e1073[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1121[1][0][0].member - _e1125[0][0][0].member) - select(0u, 1u, (_e1121[1][0][0].member_1 < _e1125[0][0][0].member_1))), (_e1121[1][0][0].member_1 - _e1125[0][0][0].member_1)), type_9(((_e1121[1][0][1].member - _e1125[0][0][1].member) - select(0u, 1u, (_e1121[1][0][1].member_1 < _e1125[0][0][1].member_1))), (_e1121[1][0][1].member_1 - _e1125[0][0][1].member_1)), type_9(((_e1121[1][0][2].member - _e1125[0][0][2].member) - select(0u, 1u, (_e1121[1][0][2].member_1 < _e1125[0][0][2].member_1))), (_e1121[1][0][2].member_1 - _e1125[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1172[1][1][0].member - _e1176[0][1][0].member) - select(0u, 1u, (_e1172[1][1][0].member_1 < _e1176[0][1][0].member_1))), (_e1172[1][1][0].member_1 - _e1176[0][1][0].member_1)), type_9(((_e1172[1][1][1].member - _e1176[0][1][1].member) - select(0u, 1u, (_e1172[1][1][1].member_1 < _e1176[0][1][1].member_1))), (_e1172[1][1][1].member_1 - _e1176[0][1][1].member_1)), type_9(((_e1172[1][1][2].member - _e1176[0][1][2].member) - select(0u, 1u, (_e1172[1][1][2].member_1 < _e1176[0][1][2].member_1))), (_e1172[1][1][2].member_1 - _e1176[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1224[2][0][0].member - _e1228[3][0][0].member) - select(0u, 1u, (_e1224[2][0][0].member_1 < _e1228[3][0][0].member_1))), (_e1224[2][0][0].member_1 - _e1228[3][0][0].member_1)), type_9(((_e1224[2][0][1].member - _e1228[3][0][1].member) - select(0u, 1u, (_e1224[2][0][1].member_1 < _e1228[3][0][1].member_1))), (_e1224[2][0][1].member_1 - _e1228[3][0][1].member_1)), type_9(((_e1224[2][0][2].member - _e1228[3][0][2].member) - select(0u, 1u, (_e1224[2][0][2].member_1 < _e1228[3][0][2].member_1))), (_e1224[2][0][2].member_1 - _e1228[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1275[2][1][0].member - _e1279[3][1][0].member) - select(0u, 1u, (_e1275[2][1][0].member_1 < _e1279[3][1][0].member_1))), (_e1275[2][1][0].member_1 - _e1279[3][1][0].member_1)), type_9(((_e1275[2][1][1].member - _e1279[3][1][1].member) - select(0u, 1u, (_e1275[2][1][1].member_1 < _e1279[3][1][1].member_1))), (_e1275[2][1][1].member_1 - _e1279[3][1][1].member_1)), type_9(((_e1275[2][1][2].member - _e1279[3][1][2].member) - select(0u, 1u, (_e1275[2][1][2].member_1 < _e1279[3][1][2].member_1))), (_e1275[2][1][2].member_1 - _e1279[3][1][2].member_1)))));
                    } else {
                        let _e708 = local_3;
                        let _e712 = local_4;
                        let _e759 = local_5;
                        let _e763 = local_6;
                        let _e811 = local_7;
                        let _e815 = local_8;
                        let _e862 = local_9;
                        let _e866 = local_10;
                        let _e914 = local_11;
                        let _e918 = local_12;
                        let _e965 = local_13;
                        let _e969 = local_14;
                        phi_1780_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e708[0][0][0].member - _e712[1][0][0].member) - select(0u, 1u, (_e708[0][0][0].member_1 < _e712[1][0][0].member_1))), (_e708[0][0][0].member_1 - _e712[1][0][0].member_1)), type_9(((_e708[0][0][1].member - _e712[1][0][1].member) - select(0u, 1u, (_e708[0][0][1].member_1 < _e712[1][0][1].member_1))), (_e708[0][0][1].member_1 - _e712[1][0][1].member_1)), type_9(((_e708[0][0][2].member - _e712[1][0][2].member) - select(0u, 1u, (_e708[0][0][2].member_1 < _e712[1][0][2].member_1))), (_e708[0][0][2].member_1 - _e712[1][0][2].member_1))), array<type_9, 3>(type_9(((_e759[0][1][0].member - _e763[1][1][0].member) - select(0u, 1u, (_e759[0][1][0].member_1 < _e763[1][1][0].member_1))), (_e759[0][1][0].member_1 - _e763[1][1][0].member_1)), type_9(((_e759[0][1][1].member - _e763[1][1][1].member) - select(0u, 1u, (_e759[0][1][1].member_1 < _e763[1][1][1].member_1))), (_e759[0][1][1].member_1 - _e763[1][1][1].member_1)), type_9(((_e759[0][1][2].member - _e763[1][1][2].member) - select(0u, 1u, (_e759[0][1][2].member_1 < _e763[1][1][2].member_1))), (_e759[0][1][2].member_1 - _e763[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e811[2][0][0].member - _e815[1][0][0].member) - select(0u, 1u, (_e811[2][0][0].member_1 < _e815[1][0][0].member_1))), (_e811[2][0][0].member_1 - _e815[1][0][0].member_1)), type_9(((_e811[2][0][1].member - _e815[1][0][1].member) - select(0u, 1u, (_e811[2][0][1].member_1 < _e815[1][0][1].member_1))), (_e811[2][0][1].member_1 - _e815[1][0][1].member_1)), type_9(((_e811[2][0][2].member - _e815[1][0][2].member) - select(0u, 1u, (_e811[2][0][2].member_1 < _e815[1][0][2].member_1))), (_e811[2][0][2].member_1 - _e815[1][0][2].member_1))), array<type_9, 3>(type_9(((_e862[2][1][0].member - _e866[1][1][0].member) - select(0u, 1u, (_e862[2][1][0].member_1 < _e866[1][1][0].member_1))), (_e862[2][1][0].member_1 - _e866[1][1][0].member_1)), type_9(((_e862[2][1][1].member - _e866[1][1][1].member) - select(0u, 1u, (_e862[2][1][1].member_1 < _e866[1][1][1].member_1))), (_e862[2][1][1].member_1 - _e866[1][1][1].member_1)), type_9(((_e862[2][1][2].member - _e866[1][1][2].member) - select(0u, 1u, (_e862[2][1][2].member_1 < _e866[1][1][2].member_1))), (_e862[2][1][2].member_1 - _e866[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e914[3][0][0].member - _e918[1][0][0].member) - select(0u, 1u, (_e914[3][0][0].member_1 < _e918[1][0][0].member_1))), (_e914[3][0][0].member_1 - _e918[1][0][0].member_1)), type_9(((_e914[3][0][1].member - _e918[1][0][1].member) - select(0u, 1u, (_e914[3][0][1].member_1 < _e918[1][0][1].member_1))), (_e914[3][0][1].member_1 - _e918[1][0][1].member_1)), type_9(((_e914[3][0][2].member - _e918[1][0][2].member) - select(0u, 1u, (_e914[3][0][2].member_1 < _e918[1][0][2].member_1))), (_e914[3][0][2].member_1 - _e918[1][0][2].member_1))), array<type_9, 3>(type_9(((_e965[3][1][0].member - _e969[1][1][0].member) - select(0u, 1u, (_e965[3][1][0].member_1 < _e969[1][1][0].member_1))), (_e965[3][1][0].member_1 - _e969[1][1][0].member_1)), type_9(((_e965[3][1][1].member - _e969[1][1][1].member) - select(0u, 1u, (_e965[3][1][1].member_1 < _e969[1][1][1].member_1))), (_e965[3][1][1].member_1 - _e969[1][1][1].member_1)), type_9(((_e965[3][1][2].member - _e969[1][1][2].member) - select(0u, 1u, (_e965[3][1][2].member_1 < _e969[1][1][2].member_1))), (_e965[3][1][2].member_1 - _e969[1][1][2].member_1)))));
                    }
                    let _e1328 = phi_1780_;
                    phi_1794_ = type_14(0i, 3i);
                    phi_1797_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                    phi_1799_ = _e1328[2];
                    phi_1801_ = _e1328[1];
                    phi_1803_ = _e1328[0];
                    loop {
                        let _e1333 = phi_1794_;
                        let _e1335 = phi_1797_;
                        let _e1337 = phi_1799_;
                        let _e1339 = phi_1801_;
                        let _e1341 = phi_1803_;
                        local_27 = _e1335;
                        local_28 = _e1335;
                        local_29 = _e1335;
                        local_30 = _e1335;
                        local_31 = _e1335;
                        local_32 = _e1335;
                        local_33 = _e1335;
                        local_34 = _e1335;
                        local_35 = _e1335;
                        local_36 = _e1335;
                        if (_e1333.member < _e1333.member_1) {
                            let _e1348 = (_e1333.member + 1i);
                            phi_1795_ = type_14(select(_e1348, type_15().member_1, select(false, true, ((false == (_e1348 > _e1333.member)) != false))), _e1333.member_1);
                            phi_1844_ = type_15(1u, _e1333.member);
                        } else {
                            phi_1795_ = _e1333;
                            phi_1844_ = type_15(0u, type_15().member_1);
                        }
                        let _e1359 = phi_1795_;
                        let _e1361 = phi_1844_;
                        let _e1364 = (bitcast<i32>(_e1361.member) != 0i);
                        if _e1364 {
                            let _e1375 = function_4(_e1339[0][1].member, _e1339[0][1].member_1, _e1337[0][2].member, _e1337[0][2].member_1);
                            let _e1386 = function_4(_e1339[0][2].member, _e1339[0][2].member_1, _e1337[0][1].member, _e1337[0][1].member_1);
                            let _e1392 = ((_e1375.member - _e1386.member) - select(0u, 1u, (_e1375.member_1 < _e1386.member_1)));
                            let _e1393 = (_e1375.member_1 - _e1386.member_1);
                            let _e1404 = function_4(_e1339[1][1].member, _e1339[1][1].member_1, _e1337[1][2].member, _e1337[1][2].member_1);
                            let _e1415 = function_4(_e1339[1][2].member, _e1339[1][2].member_1, _e1337[1][1].member, _e1337[1][1].member_1);
                            let _e1421 = ((_e1404.member - _e1415.member) - select(0u, 1u, (_e1404.member_1 < _e1415.member_1)));
                            let _e1422 = (_e1404.member_1 - _e1415.member_1);
                            let _e1433 = function_4(_e1339[0][1].member, _e1339[0][1].member_1, _e1337[1][2].member, _e1337[1][2].member_1);
                            let _e1444 = function_4(_e1339[0][2].member, _e1339[0][2].member_1, _e1337[1][1].member, _e1337[1][1].member_1);
                            let _e1451 = (_e1433.member_1 - _e1444.member_1);
                            let _e1462 = function_4(_e1339[1][1].member, _e1339[1][1].member_1, _e1337[0][2].member, _e1337[0][2].member_1);
                            let _e1473 = function_4(_e1339[1][2].member, _e1339[1][2].member_1, _e1337[0][1].member, _e1337[0][1].member_1);
                            let _e1481 = (_e1451 + (_e1462.member_1 - _e1473.member_1));
                            let _e1485 = ((((_e1433.member - _e1444.member) - select(0u, 1u, (_e1433.member_1 < _e1444.member_1))) + ((_e1462.member - _e1473.member) - select(0u, 1u, (_e1462.member_1 < _e1473.member_1)))) + select(0u, 1u, (_e1481 < _e1451)));
                            let _e1502 = function_4(_e1341[0][0].member, _e1341[0][0].member_1, _e1392, _e1393);
                            let _e1505 = (_e1335[0].member_1 + _e1502.member_1);
                            let _e1515 = function_4(_e1341[1][0].member, _e1341[1][0].member_1, _e1392, _e1393);
                            let _e1518 = (_e1335[1].member_1 + _e1515.member_1);
                            let _e1523 = function_4(_e1341[0][0].member, _e1341[0][0].member_1, _e1485, _e1481);
                            let _e1526 = (_e1518 + _e1523.member_1);
                            let _e1536 = function_4(_e1341[0][0].member, _e1341[0][0].member_1, _e1421, _e1422);
                            let _e1539 = (_e1335[2].member_1 + _e1536.member_1);
                            let _e1544 = function_4(_e1341[1][0].member, _e1341[1][0].member_1, _e1485, _e1481);
                            let _e1547 = (_e1539 + _e1544.member_1);
                            let _e1557 = function_4(_e1341[1][0].member, _e1341[1][0].member_1, _e1421, _e1422);
                            let _e1560 = (_e1335[3].member_1 + _e1557.member_1);
                            phi_1798_ = array<type_9, 4>(type_9(((_e1335[0].member + _e1502.member) + select(0u, 1u, (_e1505 < _e1335[0].member_1))), _e1505), type_9(((((_e1335[1].member + _e1515.member) + select(0u, 1u, (_e1518 < _e1335[1].member_1))) + _e1523.member) + select(0u, 1u, (_e1526 < _e1518))), _e1526), type_9(((((_e1335[2].member + _e1536.member) + select(0u, 1u, (_e1539 < _e1335[2].member_1))) + _e1544.member) + select(0u, 1u, (_e1547 < _e1539))), _e1547), type_9(((_e1335[3].member + _e1557.member) + select(0u, 1u, (_e1560 < _e1335[3].member_1))), _e1560));
                            phi_1800_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1337[0][1], _e1337[0][2], _e1337[0][0]), array<type_9, 3>(_e1337[1][1], _e1337[1][2], _e1337[1][0]));
                            phi_1802_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1339[0][1], _e1339[0][2], _e1339[0][0]), array<type_9, 3>(_e1339[1][1], _e1339[1][2], _e1339[1][0]));
                            phi_1804_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1341[0][1], _e1341[0][2], _e1341[0][0]), array<type_9, 3>(_e1341[1][1], _e1341[1][2], _e1341[1][0]));
                        } else {
                            phi_1798_ = array<type_9, 4>();
                            phi_1800_ = array<array<type_9, 3>, 2>();
                            phi_1802_ = array<array<type_9, 3>, 2>();
                            phi_1804_ = array<array<type_9, 3>, 2>();
                        }
                        let _e1601 = phi_1798_;
                        let _e1603 = phi_1800_;
                        let _e1605 = phi_1802_;
                        let _e1607 = phi_1804_;
                        continue;
                        continuing {
                            phi_1794_ = _e1359;
                            phi_1797_ = _e1601;
                            phi_1799_ = _e1603;
                            phi_1801_ = _e1605;
                            phi_1803_ = _e1607;
                            break if !(_e1364);
                        }
                    }
                    let _e1610 = local_27;
                    let _e1614 = local_28;
                    let _e1617 = function_9(_e1610[0].member, _e1614[0].member_1);
                    let _e1621 = local_29;
                    let _e1625 = local_30;
                    let _e1629 = local_31;
                    let _e1633 = local_32;
                    let _e1637 = local_33;
                    let _e1641 = local_34;
                    let _e1644 = function_9(_e1637[3].member, _e1641[3].member_1);
                    let _e1648 = local_35;
                    let _e1651 = local_36;
                    let _e1658 = select((bitcast<u32>(31i) - firstLeadingBit(_e705)), 32u, (_e705 == 0u));
                    let _e1660 = select(18u, _e1658, (18u < _e1658));
                    phi_2155_ = array<type_9, 4>(_e1617, _e1648[1], _e1651[2], _e1644);
                    phi_2158_ = false;
                    phi_2160_ = false;
                    phi_2162_ = false;
                    phi_2164_ = false;
                    phi_2166_ = type_17(0u, 0u, 0u);
                    phi_2170_ = 0u;
                    phi_2172_ = 0u;
                    phi_2174_ = 0u;
                    phi_2176_ = 0u;
                    phi_2178_ = 0u;
                    loop {
                        let _e1662 = phi_2155_;
                        let _e1664 = phi_2158_;
                        let _e1666 = phi_2160_;
                        let _e1668 = phi_2162_;
                        let _e1670 = phi_2164_;
                        let _e1672 = phi_2166_;
                        let _e1674 = phi_2170_;
                        let _e1676 = phi_2172_;
                        let _e1678 = phi_2174_;
                        let _e1680 = phi_2176_;
                        let _e1682 = phi_2178_;
                        if (_e1678 < 64u) {
                            phi_2187_ = _e1662;
                            phi_2190_ = _e1668;
                            phi_2192_ = _e1670;
                            phi_2196_ = _e1664;
                            phi_2198_ = false;
                            phi_2200_ = false;
                            phi_2202_ = false;
                            phi_2204_ = _e1674;
                            phi_2206_ = _e1676;
                            phi_2208_ = _e1678;
                            phi_2210_ = _e1680;
                            phi_2212_ = _e1682;
                            loop {
                                let _e1685 = phi_2187_;
                                let _e1687 = phi_2190_;
                                let _e1689 = phi_2192_;
                                let _e1691 = phi_2196_;
                                let _e1693 = phi_2198_;
                                let _e1695 = phi_2200_;
                                let _e1697 = phi_2202_;
                                let _e1699 = phi_2204_;
                                let _e1701 = phi_2206_;
                                let _e1703 = phi_2208_;
                                let _e1705 = phi_2210_;
                                let _e1707 = phi_2212_;
                                local_37 = _e1691;
                                local_38 = _e1697;
                                local_39 = _e1685;
                                local_40 = _e1685;
                                local_41 = _e1685;
                                local_42 = _e1685;
                                local_43 = _e1685;
                                local_44 = _e1685;
                                local_45 = _e1685;
                                local_46 = _e1685;
                                local_47 = _e1685;
                                local_48 = _e1685;
                                local_49 = _e1685;
                                local_50 = _e1685;
                                local_51 = _e1705;
                                local_52 = _e1701;
                                local_53 = _e1699;
                                local_54 = _e1705;
                                local_55 = _e1685;
                                local_56 = _e1685;
                                local_57 = _e1685;
                                local_58 = _e1685;
                                local_59 = _e1685;
                                local_60 = _e1685;
                                local_61 = _e1705;
                                local_62 = _e1695;
                                local_63 = _e1693;
                                local_64 = _e1693;
                                local_65 = _e1705;
                                local_66 = _e1685;
                                local_67 = _e1685;
                                local_68 = _e1685;
                                local_69 = _e1693;
                                local_70 = _e1693;
                                local_71 = _e1701;
                                local_72 = _e1701;
                                local_73 = _e1701;
                                local_74 = _e1699;
                                local_75 = _e1685;
                                local_76 = _e1685;
                                local_77 = _e1685;
                                local_78 = _e1685;
                                local_79 = _e1685;
                                local_80 = _e1685;
                                local_81 = _e1685;
                                local_82 = _e1685;
                                local_84 = _e1701;
                                local_85 = _e1701;
                                local_86 = _e1685;
                                local_87 = _e1685;
                                local_88 = _e1685;
                                local_90 = _e1693;
                                local_112 = _e1697;
                                local_113 = _e1687;
                                local_114 = _e1689;
                                local_115 = _e1697;
                                local_116 = _e1687;
                                local_117 = _e1689;
                                local_118 = _e1697;
                                local_91 = _e1707;
                                local_92 = _e1707;
                                local_93 = _e1705;
                                local_94 = _e1705;
                                local_95 = _e1705;
                                local_96 = _e1701;
                                local_119 = _e1705;
                                local_120 = _e1707;
                                local_122 = _e1685;
                                local_123 = _e1699;
                                local_124 = _e1701;
                                local_125 = _e1703;
                                if (_e1703 < 64u) {
                                    if _e1697 {
                                        phi_3090_ = array<type_9, 4>();
                                        phi_3091_ = bool();
                                        phi_3092_ = bool();
                                        phi_3094_ = bool();
                                        phi_3095_ = bool();
                                        phi_3096_ = bool();
                                        phi_3097_ = bool();
                                        phi_3098_ = u32();
                                        phi_3099_ = u32();
                                        phi_3100_ = u32();
                                        phi_3101_ = u32();
                                        phi_3102_ = u32();
                                        phi_3103_ = false;
                                    } else {
                                        if _e1691 {
                                            phi_3076_ = array<type_9, 4>();
                                            phi_3077_ = bool();
                                            phi_3078_ = bool();
                                            phi_3080_ = bool();
                                            phi_3081_ = bool();
                                            phi_3082_ = bool();
                                            phi_3083_ = bool();
                                            phi_3084_ = u32();
                                            phi_3085_ = u32();
                                            phi_3086_ = u32();
                                            phi_3087_ = u32();
                                            phi_3088_ = u32();
                                            phi_3089_ = false;
                                        } else {
                                            let _e1710 = (31u - _e1705);
                                            let _e1713 = (_e1707 << bitcast<u32>((_e1710 & 31u)));
                                            let _e1717 = ((_e1707 + 1u) << bitcast<u32>((_e1710 & 31u)));
                                            if (_e1713 > _e703) {
                                                phi_2418_ = bool();
                                                phi_2419_ = true;
                                            } else {
                                                let _e1719 = (_e1717 < _e701);
                                                if _e1719 {
                                                    phi_2417_ = bool();
                                                } else {
                                                    let _e1724 = function_8(128u);
                                                    let _e1729 = ((_e1685[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1757 = function_8(128u);
                                                    let _e1762 = ((_e1685[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1791 = function_8(128u);
                                                    let _e1796 = ((_e1685[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1825 = function_8(128u);
                                                    let _e1830 = ((_e1685[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_2417_ = ((((select(0u, select(1u, 2u, ((_e1685[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e1724.member - select(_e1685[0].member, (~(_e1685[0].member) + select(0u, 1u, (_e1685[0].member_1 == 0u))), _e1729)) - select(0u, 1u, (_e1724.member_1 < select(_e1685[0].member_1, (~(_e1685[0].member_1) + 1u), _e1729)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e1685[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1757.member - select(_e1685[1].member, (~(_e1685[1].member) + select(0u, 1u, (_e1685[1].member_1 == 0u))), _e1762)) - select(0u, 1u, (_e1757.member_1 < select(_e1685[1].member_1, (~(_e1685[1].member_1) + 1u), _e1762)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e1685[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1791.member - select(_e1685[2].member, (~(_e1685[2].member) + select(0u, 1u, (_e1685[2].member_1 == 0u))), _e1796)) - select(0u, 1u, (_e1791.member_1 < select(_e1685[2].member_1, (~(_e1685[2].member_1) + 1u), _e1796)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e1685[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e1825.member - select(_e1685[3].member, (~(_e1685[3].member) + select(0u, 1u, (_e1685[3].member_1 == 0u))), _e1830)) - select(0u, 1u, (_e1825.member_1 < select(_e1685[3].member_1, (~(_e1685[3].member_1) + 1u), _e1830)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e1857 = phi_2417_;
                                                phi_2418_ = _e1857;
                                                phi_2419_ = _e1719;
                                            }
                                            let _e1859 = phi_2418_;
                                            let _e1861 = phi_2419_;
                                            let _e1862 = select(_e1859, true, _e1861);
                                            let _e1867 = function_8(128u);
                                            let _e1872 = ((_e1685[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1895 = select(0u, select(1u, 2u, ((_e1685[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e1867.member - select(_e1685[0].member, (~(_e1685[0].member) + select(0u, 1u, (_e1685[0].member_1 == 0u))), _e1872)) - select(0u, 1u, (_e1867.member_1 < select(_e1685[0].member_1, (~(_e1685[0].member_1) + 1u), _e1872)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1900 = function_8(128u);
                                            let _e1905 = ((_e1685[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1928 = select(0u, select(1u, 2u, ((_e1685[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1900.member - select(_e1685[1].member, (~(_e1685[1].member) + select(0u, 1u, (_e1685[1].member_1 == 0u))), _e1905)) - select(0u, 1u, (_e1900.member_1 < select(_e1685[1].member_1, (~(_e1685[1].member_1) + 1u), _e1905)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1933 = function_8(128u);
                                            let _e1938 = ((_e1685[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1961 = select(0u, select(1u, 2u, ((_e1685[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1933.member - select(_e1685[2].member, (~(_e1685[2].member) + select(0u, 1u, (_e1685[2].member_1 == 0u))), _e1938)) - select(0u, 1u, (_e1933.member_1 < select(_e1685[2].member_1, (~(_e1685[2].member_1) + 1u), _e1938)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1966 = function_8(128u);
                                            let _e1971 = ((_e1685[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1994 = select(0u, select(1u, 2u, ((_e1685[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e1966.member - select(_e1685[3].member, (~(_e1685[3].member) + select(0u, 1u, (_e1685[3].member_1 == 0u))), _e1971)) - select(0u, 1u, (_e1966.member_1 < select(_e1685[3].member_1, (~(_e1685[3].member_1) + 1u), _e1971)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e2004 = select(false, select(true, select(false, (_e1928 != 0u), (_e1961 == _e1994)), select(true, (_e1961 == 0u), (_e1928 == _e1895))), ((_e1895 | _e1994) == 3u));
                                            let _e2009 = function_8(128u);
                                            let _e2014 = ((_e1685[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e2040 = select(false, (_e1713 >= _e701), (select(0u, select(1u, 2u, ((_e1685[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2009.member - select(_e1685[0].member, (~(_e1685[0].member) + select(0u, 1u, (_e1685[0].member_1 == 0u))), _e2014)) - select(0u, 1u, (_e2009.member_1 < select(_e1685[0].member_1, (~(_e1685[0].member_1) + 1u), _e2014)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e2041 = (_e1705 == 3u);
                                            let _e2042 = (_e1705 == 8u);
                                            let _e2047 = select(select(select((_e1705 == 14u), bool(), _e2042), bool(), _e2041), true, select(_e2042, true, _e2041));
                                            let _e2049 = select(false, !(_e1687), _e2040);
                                            let _e2050 = (_e1705 == 31u);
                                            let _e2061 = select(select(false, !(_e1689), select(select(select(select(select(false, !(_e1666), _e2004), bool(), _e2040), bool(), _e2047), bool(), _e2050), true, select(select(_e2040, true, _e2047), true, _e2050))), true, _e2049);
                                            if _e1862 {
                                                phi_3070_ = _e1685;
                                                phi_3071_ = _e1687;
                                                phi_3072_ = _e1689;
                                                phi_3074_ = _e1705;
                                                phi_3075_ = _e1707;
                                            } else {
                                                if _e2061 {
                                                    phi_3064_ = _e1685;
                                                    phi_3065_ = _e1687;
                                                    phi_3066_ = _e1689;
                                                    phi_3068_ = _e1705;
                                                    phi_3069_ = _e1707;
                                                } else {
                                                    let _e2070 = (_e1685[0].member_1 + _e1685[1].member_1);
                                                    let _e2074 = ((_e1685[0].member + _e1685[1].member) + select(0u, 1u, (_e2070 < _e1685[0].member_1)));
                                                    let _e2082 = bitcast<u32>((bitcast<i32>(_e2074) >> bitcast<u32>(1u)));
                                                    let _e2085 = ((_e2070 >> bitcast<u32>(1u)) | ((_e2074 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2094 = (_e1685[1].member_1 + _e1685[2].member_1);
                                                    let _e2098 = ((_e1685[1].member + _e1685[2].member) + select(0u, 1u, (_e2094 < _e1685[1].member_1)));
                                                    let _e2106 = bitcast<u32>((bitcast<i32>(_e2098) >> bitcast<u32>(1u)));
                                                    let _e2109 = ((_e2094 >> bitcast<u32>(1u)) | ((_e2098 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2118 = (_e1685[2].member_1 + _e1685[3].member_1);
                                                    let _e2122 = ((_e1685[2].member + _e1685[3].member) + select(0u, 1u, (_e2118 < _e1685[2].member_1)));
                                                    let _e2130 = bitcast<u32>((bitcast<i32>(_e2122) >> bitcast<u32>(1u)));
                                                    let _e2133 = ((_e2118 >> bitcast<u32>(1u)) | ((_e2122 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2134 = (_e2085 + _e2109);
                                                    let _e2138 = ((_e2082 + _e2106) + select(0u, 1u, (_e2134 < _e2085)));
                                                    let _e2146 = bitcast<u32>((bitcast<i32>(_e2138) >> bitcast<u32>(1u)));
                                                    let _e2149 = ((_e2134 >> bitcast<u32>(1u)) | ((_e2138 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2150 = (_e2109 + _e2133);
                                                    let _e2154 = ((_e2106 + _e2130) + select(0u, 1u, (_e2150 < _e2109)));
                                                    let _e2162 = bitcast<u32>((bitcast<i32>(_e2154) >> bitcast<u32>(1u)));
                                                    let _e2165 = ((_e2150 >> bitcast<u32>(1u)) | ((_e2154 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2166 = (_e2149 + _e2165);
                                                    let _e2170 = ((_e2146 + _e2162) + select(0u, 1u, (_e2166 < _e2149)));
                                                    let _e2178 = bitcast<u32>((bitcast<i32>(_e2170) >> bitcast<u32>(1u)));
                                                    let _e2181 = ((_e2166 >> bitcast<u32>(1u)) | ((_e2170 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2182 = (2u * _e1707);
                                                    let _e2193 = function_8(128u);
                                                    let _e2198 = ((_e1685[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2222 = function_8(128u);
                                                    let _e2227 = ((_e2082 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2249 = function_8(128u);
                                                    let _e2254 = ((_e2146 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2276 = function_8(128u);
                                                    let _e2281 = ((_e2178 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e1685[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2193.member - select(_e1685[0].member, (~(_e1685[0].member) + select(0u, 1u, (_e1685[0].member_1 == 0u))), _e2198)) - select(0u, 1u, (_e2193.member_1 < select(_e1685[0].member_1, (~(_e1685[0].member_1) + 1u), _e2198)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2082 >> bitcast<u32>(31i)) != 0u)), ((((_e2222.member - select(_e2082, (~(_e2082) + select(0u, 1u, (_e2085 == 0u))), _e2227)) - select(0u, 1u, (_e2222.member_1 < select(_e2085, (~(_e2085) + 1u), _e2227)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2146 >> bitcast<u32>(31i)) != 0u)), ((((_e2249.member - select(_e2146, (~(_e2146) + select(0u, 1u, (_e2149 == 0u))), _e2254)) - select(0u, 1u, (_e2249.member_1 < select(_e2149, (~(_e2149) + 1u), _e2254)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2178 >> bitcast<u32>(31i)) != 0u)), ((((_e2276.member - select(_e2178, (~(_e2178) + select(0u, 1u, (_e2181 == 0u))), _e2281)) - select(0u, 1u, (_e2276.member_1 < select(_e2181, (~(_e2181) + 1u), _e2281)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_3061_ = array<type_9, 4>(type_9(_e2178, _e2181), type_9(_e2162, _e2165), type_9(_e2130, _e2133), _e1685[3]);
                                                        phi_3062_ = false;
                                                        phi_3063_ = (_e2182 + 1u);
                                                    } else {
                                                        phi_3061_ = array<type_9, 4>(_e1685[0], type_9(_e2082, _e2085), type_9(_e2146, _e2149), type_9(_e2178, _e2181));
                                                        phi_3062_ = _e1687;
                                                        phi_3063_ = _e2182;
                                                    }
                                                    let _e2311 = phi_3061_;
                                                    let _e2313 = phi_3062_;
                                                    let _e2315 = phi_3063_;
                                                    phi_3064_ = _e2311;
                                                    phi_3065_ = _e2313;
                                                    phi_3066_ = false;
                                                    phi_3068_ = (_e1705 + 1u);
                                                    phi_3069_ = _e2315;
                                                }
                                                let _e2317 = phi_3064_;
                                                let _e2319 = phi_3065_;
                                                let _e2321 = phi_3066_;
                                                let _e2323 = phi_3068_;
                                                let _e2325 = phi_3069_;
                                                phi_3070_ = _e2317;
                                                phi_3071_ = _e2319;
                                                phi_3072_ = _e2321;
                                                phi_3074_ = _e2323;
                                                phi_3075_ = _e2325;
                                            }
                                            let _e2327 = phi_3070_;
                                            let _e2329 = phi_3071_;
                                            let _e2331 = phi_3072_;
                                            let _e2333 = phi_3074_;
                                            let _e2335 = phi_3075_;
                                            phi_3076_ = _e2327;
                                            phi_3077_ = _e2329;
                                            phi_3078_ = _e2331;
                                            phi_3080_ = _e2061;
                                            phi_3081_ = _e2049;
                                            phi_3082_ = _e2004;
                                            phi_3083_ = _e1862;
                                            phi_3084_ = _e1717;
                                            phi_3085_ = _e1713;
                                            phi_3086_ = (_e1703 + 1u);
                                            phi_3087_ = _e2333;
                                            phi_3088_ = _e2335;
                                            phi_3089_ = true;
                                        }
                                        let _e2337 = phi_3076_;
                                        let _e2339 = phi_3077_;
                                        let _e2341 = phi_3078_;
                                        let _e2343 = phi_3080_;
                                        let _e2345 = phi_3081_;
                                        let _e2347 = phi_3082_;
                                        let _e2349 = phi_3083_;
                                        let _e2351 = phi_3084_;
                                        let _e2353 = phi_3085_;
                                        let _e2355 = phi_3086_;
                                        let _e2357 = phi_3087_;
                                        let _e2359 = phi_3088_;
                                        let _e2361 = phi_3089_;
                                        phi_3090_ = _e2337;
                                        phi_3091_ = _e2339;
                                        phi_3092_ = _e2341;
                                        phi_3094_ = _e2343;
                                        phi_3095_ = _e2345;
                                        phi_3096_ = _e2347;
                                        phi_3097_ = _e2349;
                                        phi_3098_ = _e2351;
                                        phi_3099_ = _e2353;
                                        phi_3100_ = _e2355;
                                        phi_3101_ = _e2357;
                                        phi_3102_ = _e2359;
                                        phi_3103_ = _e2361;
                                    }
                                    let _e2363 = phi_3090_;
                                    let _e2365 = phi_3091_;
                                    let _e2367 = phi_3092_;
                                    let _e2369 = phi_3094_;
                                    let _e2371 = phi_3095_;
                                    let _e2373 = phi_3096_;
                                    let _e2375 = phi_3097_;
                                    let _e2377 = phi_3098_;
                                    let _e2379 = phi_3099_;
                                    let _e2381 = phi_3100_;
                                    let _e2383 = phi_3101_;
                                    let _e2385 = phi_3102_;
                                    let _e2387 = phi_3103_;
                                    phi_2188_ = _e2363;
                                    phi_2191_ = _e2365;
                                    phi_2193_ = _e2367;
                                    phi_2197_ = _e2369;
                                    phi_2199_ = _e2371;
                                    phi_2201_ = _e2373;
                                    phi_2203_ = _e2375;
                                    phi_2205_ = _e2377;
                                    phi_2207_ = _e2379;
                                    phi_2209_ = _e2381;
                                    phi_2211_ = _e2383;
                                    phi_2213_ = _e2385;
                                    phi_3104_ = _e2387;
                                } else {
                                    phi_2188_ = array<type_9, 4>();
                                    phi_2191_ = bool();
                                    phi_2193_ = bool();
                                    phi_2197_ = bool();
                                    phi_2199_ = bool();
                                    phi_2201_ = bool();
                                    phi_2203_ = bool();
                                    phi_2205_ = u32();
                                    phi_2207_ = u32();
                                    phi_2209_ = u32();
                                    phi_2211_ = u32();
                                    phi_2213_ = u32();
                                    phi_3104_ = false;
                                }
                                let _e2389 = phi_2188_;
                                let _e2391 = phi_2191_;
                                let _e2393 = phi_2193_;
                                let _e2395 = phi_2197_;
                                let _e2397 = phi_2199_;
                                let _e2399 = phi_2201_;
                                let _e2401 = phi_2203_;
                                let _e2403 = phi_2205_;
                                let _e2405 = phi_2207_;
                                let _e2407 = phi_2209_;
                                let _e2409 = phi_2211_;
                                let _e2411 = phi_2213_;
                                let _e2413 = phi_3104_;
                                continue;
                                continuing {
                                    phi_2187_ = _e2389;
                                    phi_2190_ = _e2391;
                                    phi_2192_ = _e2393;
                                    phi_2196_ = _e2395;
                                    phi_2198_ = _e2397;
                                    phi_2200_ = _e2399;
                                    phi_2202_ = _e2401;
                                    phi_2204_ = _e2403;
                                    phi_2206_ = _e2405;
                                    phi_2208_ = _e2407;
                                    phi_2210_ = _e2409;
                                    phi_2212_ = _e2411;
                                    break if !(_e2413);
                                }
                            }
                            let _e2416 = local_37;
                            if _e2416 {
                                let _e2418 = local_38;
                                if _e2418 {
                                    phi_5594_ = _e1664;
                                    phi_5595_ = _e1666;
                                    let _e5040 = local_113;
                                    phi_5596_ = _e5040;
                                    let _e5043 = local_114;
                                    phi_5597_ = _e5043;
                                    phi_5598_ = _e1672;
                                    let _e5047 = local_115;
                                    phi_5599_ = _e5047;
                                    phi_5600_ = bool();
                                    phi_5601_ = type_17();
                                    phi_5602_ = true;
                                    phi_5603_ = false;
                                    phi_5604_ = false;
                                    phi_5605_ = false;
                                } else {
                                    let _e2420 = local_39;
                                    let _e2424 = local_40;
                                    let _e2427 = function_8(128u);
                                    let _e2432 = ((_e2420[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2440 = local_41;
                                    let _e2459 = local_42;
                                    let _e2463 = local_43;
                                    let _e2466 = function_8(128u);
                                    let _e2471 = ((_e2459[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2479 = local_44;
                                    let _e2499 = local_45;
                                    let _e2503 = local_46;
                                    let _e2506 = function_8(128u);
                                    let _e2511 = ((_e2499[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2519 = local_47;
                                    let _e2539 = local_48;
                                    let _e2543 = local_49;
                                    let _e2546 = function_8(128u);
                                    let _e2551 = ((_e2539[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2559 = local_50;
                                    let _e2580 = local_51;
                                    let _e2585 = local_52;
                                    let _e2587 = local_53;
                                    let _e2589 = local_54;
                                    let _e2590 = type_17(_e2585, _e2587, _e2589);
                                    let _e2592 = local_55;
                                    let _e2596 = local_56;
                                    let _e2599 = function_8(128u);
                                    let _e2604 = ((_e2592[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2612 = local_57;
                                    let _e2631 = local_58;
                                    let _e2635 = local_59;
                                    let _e2638 = function_8(128u);
                                    let _e2643 = ((_e2631[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2651 = local_60;
                                    let _e2670 = ((select(0u, select(1u, 2u, ((_e2592[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2599.member - select(_e2612[0].member, (~(_e2592[0].member) + select(0u, 1u, (_e2596[0].member_1 == 0u))), _e2604)) - select(0u, 1u, (_e2599.member_1 < select(_e2612[0].member_1, (~(_e2596[0].member_1) + 1u), _e2604)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2631[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2638.member - select(_e2651[3].member, (~(_e2631[3].member) + select(0u, 1u, (_e2635[3].member_1 == 0u))), _e2643)) - select(0u, 1u, (_e2638.member_1 < select(_e2651[3].member_1, (~(_e2635[3].member_1) + 1u), _e2643)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e2672 = local_61;
                                    let _e2675 = local_62;
                                    let _e2679 = local_63;
                                    let _e2680 = select(select(select(false, (_e2672 < _e1660), _e2675), true, _e1664), false, _e2679);
                                    let _e2682 = local_64;
                                    if _e2682 {
                                        phi_3463_ = bool();
                                        phi_3464_ = true;
                                    } else {
                                        if _e2680 {
                                            phi_3461_ = bool();
                                            phi_3462_ = true;
                                        } else {
                                            let _e2684 = local_65;
                                            if (_e2684 == 31u) {
                                                if _e2670 {
                                                    phi_3458_ = bool();
                                                } else {
                                                    let _e2687 = local_66;
                                                    let _e2691 = local_67;
                                                    let _e2694 = function_8(128u);
                                                    let _e2699 = ((_e2687[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2707 = local_68;
                                                    phi_3458_ = (select(0u, select(1u, 2u, ((_e2687[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2694.member - select(_e2707[0].member, (~(_e2687[0].member) + select(0u, 1u, (_e2691[0].member_1 == 0u))), _e2699)) - select(0u, 1u, (_e2694.member_1 < select(_e2707[0].member_1, (~(_e2691[0].member_1) + 1u), _e2699)))) >> bitcast<u32>(31i)) != 0u)) != 0u);
                                                }
                                                let _e2727 = phi_3458_;
                                                phi_3459_ = _e2727;
                                                phi_3460_ = _e2670;
                                            } else {
                                                phi_3459_ = bool();
                                                phi_3460_ = true;
                                            }
                                            let _e2729 = phi_3459_;
                                            let _e2731 = phi_3460_;
                                            phi_3461_ = _e2729;
                                            phi_3462_ = _e2731;
                                        }
                                        let _e2733 = phi_3461_;
                                        let _e2735 = phi_3462_;
                                        phi_3463_ = _e2733;
                                        phi_3464_ = _e2735;
                                    }
                                    let _e2737 = phi_3463_;
                                    let _e2739 = phi_3464_;
                                    let _e2740 = select(_e2737, false, _e2739);
                                    let _e2742 = local_69;
                                    let _e2745 = local_70;
                                    if _e2745 {
                                        let _e2918 = local_84;
                                        let _e2921 = local_85;
                                        phi_3657_ = _e1666;
                                        phi_3658_ = type_17(_e2921, (_e2918 + 1u), 31u);
                                        phi_3659_ = _e1672;
                                    } else {
                                        if _e2680 {
                                            let _e2763 = select(_e1660, 31u, _e1664);
                                            let _e2766 = local_73;
                                            let _e2767 = select(_e2766, _e1672.member, _e1664);
                                            let _e2770 = local_74;
                                            let _e2771 = select(_e2770, _e1672.member_1, _e1664);
                                            let _e2773 = local_75;
                                            let _e2777 = local_76;
                                            let _e2784 = ((f32(bitcast<i32>(_e2773[0].member)) * 4294967300f) + f32(_e2777[0].member_1));
                                            let _e2786 = local_77;
                                            let _e2790 = local_78;
                                            let _e2797 = ((f32(bitcast<i32>(_e2786[1].member)) * 4294967300f) + f32(_e2790[1].member_1));
                                            let _e2799 = local_79;
                                            let _e2803 = local_80;
                                            let _e2810 = ((f32(bitcast<i32>(_e2799[2].member)) * 4294967300f) + f32(_e2803[2].member_1));
                                            let _e2812 = local_81;
                                            let _e2816 = local_82;
                                            let _e2823 = ((f32(bitcast<i32>(_e2812[3].member)) * 4294967300f) + f32(_e2816[3].member_1));
                                            phi_3515_ = type_14(0i, 6i);
                                            phi_3518_ = 1f;
                                            phi_3520_ = 0f;
                                            phi_3522_ = (_e2784 / (_e2784 - _e2823));
                                            loop {
                                                let _e2827 = phi_3515_;
                                                let _e2829 = phi_3518_;
                                                let _e2831 = phi_3520_;
                                                let _e2833 = phi_3522_;
                                                local_83 = _e2833;
                                                if (_e2827.member < _e2827.member_1) {
                                                    let _e2840 = (_e2827.member + 1i);
                                                    phi_3516_ = type_14(select(_e2840, type_15().member_1, select(false, true, ((false == (_e2840 > _e2827.member)) != false))), _e2827.member_1);
                                                    phi_3563_ = type_15(1u, _e2827.member);
                                                } else {
                                                    phi_3516_ = _e2827;
                                                    phi_3563_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e2851 = phi_3516_;
                                                let _e2853 = phi_3563_;
                                                let _e2856 = (bitcast<i32>(_e2853.member) != 0i);
                                                if _e2856 {
                                                    let _e2857 = function_7(_e2784, _e2797, _e2833);
                                                    let _e2858 = function_7(_e2797, _e2810, _e2833);
                                                    let _e2859 = function_7(_e2810, _e2823, _e2833);
                                                    let _e2860 = function_7(_e2857, _e2858, _e2833);
                                                    let _e2861 = function_7(_e2858, _e2859, _e2833);
                                                    let _e2862 = function_7(_e2860, _e2861, _e2833);
                                                    let _e2865 = ((_e2862 < 0f) == (_e2784 < 0f));
                                                    let _e2866 = select(_e2833, _e2829, _e2865);
                                                    let _e2867 = select(_e2831, _e2833, _e2865);
                                                    let _e2871 = (_e2833 - (_e2862 / (3f * (_e2861 - _e2860))));
                                                    phi_3519_ = _e2866;
                                                    phi_3521_ = _e2867;
                                                    phi_3523_ = select(_e2871, (0.5f * (_e2867 + _e2866)), select(true, select(true, false, (_e2871 <= _e2866)), (_e2871 >= _e2867)));
                                                } else {
                                                    phi_3519_ = f32();
                                                    phi_3521_ = f32();
                                                    phi_3523_ = f32();
                                                }
                                                let _e2880 = phi_3519_;
                                                let _e2882 = phi_3521_;
                                                let _e2884 = phi_3523_;
                                                continue;
                                                continuing {
                                                    phi_3515_ = _e2851;
                                                    phi_3518_ = _e2880;
                                                    phi_3520_ = _e2882;
                                                    phi_3522_ = _e2884;
                                                    break if !(_e2856);
                                                }
                                            }
                                            let _e2889 = (1u << bitcast<u32>(((31u - _e2763) & 31u)));
                                            let _e2890 = (_e2771 - _e2767);
                                            let _e2893 = local_83;
                                            let _e2894 = (_e2893 * f32(_e2890));
                                            let _e2899 = select(select(u32(_e2894), 0u, (_e2894 < 0f)), 4294967295u, (_e2894 > 4294967000f));
                                            let _e2901 = select(_e2899, _e2890, (_e2890 < _e2899));
                                            let _e2903 = (_e2889 / 2u);
                                            let _e2906 = ((_e2767 + _e2901) - select(_e2903, _e2901, (_e2901 < _e2903)));
                                            let _e2907 = (_e2906 + _e2889);
                                            phi_3654_ = true;
                                            phi_3655_ = _e2590;
                                            phi_3656_ = type_17(_e2906, select(_e2907, _e2771, (_e2771 < _e2907)), _e2763);
                                        } else {
                                            if _e2740 {
                                                let _e2750 = select((bitcast<u32>(31i) - firstLeadingBit(_e705)), 32u, (_e705 == 0u));
                                                let _e2756 = local_71;
                                                let _e2759 = local_72;
                                                phi_3653_ = type_17(_e2759, (_e2756 + (1u << bitcast<u32>(((31u - _e2750) & 31u)))), _e2750);
                                            } else {
                                                phi_3653_ = _e2590;
                                            }
                                            let _e2762 = phi_3653_;
                                            phi_3654_ = _e1666;
                                            phi_3655_ = _e2762;
                                            phi_3656_ = _e1672;
                                        }
                                        let _e2912 = phi_3654_;
                                        let _e2914 = phi_3655_;
                                        let _e2916 = phi_3656_;
                                        phi_3657_ = _e2912;
                                        phi_3658_ = _e2914;
                                        phi_3659_ = _e2916;
                                    }
                                    let _e2924 = phi_3657_;
                                    let _e2926 = phi_3658_;
                                    let _e2928 = phi_3659_;
                                    if select(select(false, (_e2926.member_1 <= 2147483648u), _e2740), true, _e2680) {
                                        if _e2680 {
                                            phi_3726_ = 0u;
                                            phi_3727_ = _e2928.member_1;
                                            phi_3728_ = _e2928.member;
                                        } else {
                                            let _e2936 = local_86;
                                            let _e2940 = local_87;
                                            let _e2943 = function_8(128u);
                                            let _e2948 = ((_e2936[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e2956 = local_88;
                                            phi_3726_ = select(0u, select(1u, 2u, ((_e2936[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2943.member - select(_e2956[0].member, (~(_e2936[0].member) + select(0u, 1u, (_e2940[0].member_1 == 0u))), _e2948)) - select(0u, 1u, (_e2943.member_1 < select(_e2956[0].member_1, (~(_e2940[0].member_1) + 1u), _e2948)))) >> bitcast<u32>(31i)) != 0u));
                                            phi_3727_ = _e2926.member_1;
                                            phi_3728_ = _e2926.member_1;
                                        }
                                        let _e2977 = phi_3726_;
                                        let _e2979 = phi_3727_;
                                        let _e2981 = phi_3728_;
                                        phi_3731_ = type_14(0i, 2i);
                                        phi_3734_ = _e2977;
                                        phi_3736_ = _e2981;
                                        loop {
                                            let _e2983 = phi_3731_;
                                            let _e2985 = phi_3734_;
                                            let _e2987 = phi_3736_;
                                            local_89 = _e2985;
                                            if (_e2983.member < _e2983.member_1) {
                                                let _e2994 = (_e2983.member + 1i);
                                                phi_3732_ = type_14(select(_e2994, type_15().member_1, select(false, true, ((false == (_e2994 > _e2983.member)) != false))), _e2983.member_1);
                                                phi_3776_ = type_15(1u, _e2983.member);
                                            } else {
                                                phi_3732_ = _e2983;
                                                phi_3776_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3005 = phi_3732_;
                                            let _e3007 = phi_3776_;
                                            let _e3010 = (bitcast<i32>(_e3007.member) != 0i);
                                            if _e3010 {
                                                let _e3016 = function_6(((_e1621[1].member - _e1617.member) - select(0u, 1u, (_e1625[1].member_1 < _e1617.member_1))), (_e1625[1].member_1 - _e1617.member_1), _e2987);
                                                let _e3019 = (_e1617.member_1 + _e3016.member_1);
                                                let _e3023 = ((_e1617.member + _e3016.member) + select(0u, 1u, (_e3019 < _e1617.member_1)));
                                                let _e3029 = function_6(((_e1629[2].member - _e1621[1].member) - select(0u, 1u, (_e1633[2].member_1 < _e1625[1].member_1))), (_e1633[2].member_1 - _e1625[1].member_1), _e2987);
                                                let _e3032 = (_e1625[1].member_1 + _e3029.member_1);
                                                let _e3036 = ((_e1621[1].member + _e3029.member) + select(0u, 1u, (_e3032 < _e1625[1].member_1)));
                                                let _e3042 = function_6(((_e1644.member - _e1629[2].member) - select(0u, 1u, (_e1644.member_1 < _e1633[2].member_1))), (_e1644.member_1 - _e1633[2].member_1), _e2987);
                                                let _e3045 = (_e1633[2].member_1 + _e3042.member_1);
                                                let _e3055 = function_6(((_e3036 - _e3023) - select(0u, 1u, (_e3032 < _e3019))), (_e3032 - _e3019), _e2987);
                                                let _e3058 = (_e3019 + _e3055.member_1);
                                                let _e3062 = ((_e3023 + _e3055.member) + select(0u, 1u, (_e3058 < _e3019)));
                                                let _e3068 = function_6(((((_e1629[2].member + _e3042.member) + select(0u, 1u, (_e3045 < _e1633[2].member_1))) - _e3036) - select(0u, 1u, (_e3045 < _e3032))), (_e3045 - _e3032), _e2987);
                                                let _e3071 = (_e3032 + _e3068.member_1);
                                                let _e3081 = function_6(((((_e3036 + _e3068.member) + select(0u, 1u, (_e3071 < _e3032))) - _e3062) - select(0u, 1u, (_e3071 < _e3058))), (_e3071 - _e3058), _e2987);
                                                let _e3084 = (_e3058 + _e3081.member_1);
                                                let _e3088 = ((_e3062 + _e3081.member) + select(0u, 1u, (_e3084 < _e3058)));
                                                let _e3089 = function_8(128u);
                                                let _e3094 = ((_e3088 >> bitcast<u32>(31i)) != 0u);
                                                phi_3735_ = (_e2985 | select(0u, select(1u, 2u, ((_e3088 >> bitcast<u32>(31i)) != 0u)), ((((_e3089.member - select(_e3088, (~(_e3088) + select(0u, 1u, (_e3084 == 0u))), _e3094)) - select(0u, 1u, (_e3089.member_1 < select(_e3084, (~(_e3084) + 1u), _e3094)))) >> bitcast<u32>(31i)) != 0u)));
                                            } else {
                                                phi_3735_ = u32();
                                            }
                                            let _e3117 = phi_3735_;
                                            continue;
                                            continuing {
                                                phi_3731_ = _e3005;
                                                phi_3734_ = _e3117;
                                                phi_3736_ = _e2979;
                                                break if !(_e3010);
                                            }
                                        }
                                        let _e3120 = local_89;
                                        phi_3952_ = (_e3120 == 3u);
                                    } else {
                                        phi_3952_ = _e2670;
                                    }
                                    let _e3123 = phi_3952_;
                                    if _e2680 {
                                        phi_3960_ = _e3123;
                                        phi_3961_ = type_17(select(_e2926.member, _e2928.member, _e3123), select(_e2926.member_1, _e2928.member_1, _e3123), select(_e2926.member_2, _e2928.member_2, _e3123));
                                    } else {
                                        phi_3960_ = _e1664;
                                        phi_3961_ = _e2926;
                                    }
                                    let _e3135 = phi_3960_;
                                    let _e3137 = phi_3961_;
                                    let _e3156 = ((_e1328[0][1][0].member - _e1328[0][0][0].member) - select(0u, 1u, (_e1328[0][1][0].member_1 < _e1328[0][0][0].member_1)));
                                    let _e3157 = (_e1328[0][1][0].member_1 - _e1328[0][0][0].member_1);
                                    let _e3169 = ((_e1328[0][1][1].member - _e1328[0][0][1].member) - select(0u, 1u, (_e1328[0][1][1].member_1 < _e1328[0][0][1].member_1)));
                                    let _e3170 = (_e1328[0][1][1].member_1 - _e1328[0][0][1].member_1);
                                    let _e3182 = ((_e1328[0][1][2].member - _e1328[0][0][2].member) - select(0u, 1u, (_e1328[0][1][2].member_1 < _e1328[0][0][2].member_1)));
                                    let _e3183 = (_e1328[0][1][2].member_1 - _e1328[0][0][2].member_1);
                                    let _e3186 = ((_e3156 >> bitcast<u32>(31i)) != 0u);
                                    let _e3193 = select(_e3156, (~(_e3156) + select(0u, 1u, (_e3157 == 0u))), _e3186);
                                    let _e3194 = select(_e3157, (~(_e3157) + 1u), _e3186);
                                    let _e3197 = ((_e3169 >> bitcast<u32>(31i)) != 0u);
                                    let _e3204 = select(_e3169, (~(_e3169) + select(0u, 1u, (_e3170 == 0u))), _e3197);
                                    let _e3205 = select(_e3170, (~(_e3170) + 1u), _e3197);
                                    let _e3212 = ((((_e3204 - _e3193) - select(0u, 1u, (_e3205 < _e3194))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3213 = select(_e3204, _e3193, _e3212);
                                    let _e3214 = select(_e3205, _e3194, _e3212);
                                    let _e3217 = ((_e3182 >> bitcast<u32>(31i)) != 0u);
                                    let _e3224 = select(_e3182, (~(_e3182) + select(0u, 1u, (_e3183 == 0u))), _e3217);
                                    let _e3225 = select(_e3183, (~(_e3183) + 1u), _e3217);
                                    let _e3232 = ((((_e3224 - _e3213) - select(0u, 1u, (_e3225 < _e3214))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3234 = select(_e3225, _e3214, _e3232);
                                    let _e3235 = function_8(4u);
                                    let _e3238 = (_e3234 + _e3235.member_1);
                                    let _e3242 = ((select(_e3224, _e3213, _e3232) + _e3235.member) + select(0u, 1u, (_e3238 < _e3234)));
                                    let _e3257 = ((_e3238 >> bitcast<u32>((_e3137.member_2 & 31u))) | ((_e3242 << bitcast<u32>(((31u - _e3137.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3258 = function_8(4u);
                                    let _e3261 = (_e3257 + _e3258.member_1);
                                    let _e3279 = ((_e1328[1][1][0].member - _e1328[1][0][0].member) - select(0u, 1u, (_e1328[1][1][0].member_1 < _e1328[1][0][0].member_1)));
                                    let _e3280 = (_e1328[1][1][0].member_1 - _e1328[1][0][0].member_1);
                                    let _e3292 = ((_e1328[1][1][1].member - _e1328[1][0][1].member) - select(0u, 1u, (_e1328[1][1][1].member_1 < _e1328[1][0][1].member_1)));
                                    let _e3293 = (_e1328[1][1][1].member_1 - _e1328[1][0][1].member_1);
                                    let _e3305 = ((_e1328[1][1][2].member - _e1328[1][0][2].member) - select(0u, 1u, (_e1328[1][1][2].member_1 < _e1328[1][0][2].member_1)));
                                    let _e3306 = (_e1328[1][1][2].member_1 - _e1328[1][0][2].member_1);
                                    let _e3309 = ((_e3279 >> bitcast<u32>(31i)) != 0u);
                                    let _e3316 = select(_e3279, (~(_e3279) + select(0u, 1u, (_e3280 == 0u))), _e3309);
                                    let _e3317 = select(_e3280, (~(_e3280) + 1u), _e3309);
                                    let _e3320 = ((_e3292 >> bitcast<u32>(31i)) != 0u);
                                    let _e3327 = select(_e3292, (~(_e3292) + select(0u, 1u, (_e3293 == 0u))), _e3320);
                                    let _e3328 = select(_e3293, (~(_e3293) + 1u), _e3320);
                                    let _e3335 = ((((_e3327 - _e3316) - select(0u, 1u, (_e3328 < _e3317))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3336 = select(_e3327, _e3316, _e3335);
                                    let _e3337 = select(_e3328, _e3317, _e3335);
                                    let _e3340 = ((_e3305 >> bitcast<u32>(31i)) != 0u);
                                    let _e3347 = select(_e3305, (~(_e3305) + select(0u, 1u, (_e3306 == 0u))), _e3340);
                                    let _e3348 = select(_e3306, (~(_e3306) + 1u), _e3340);
                                    let _e3355 = ((((_e3347 - _e3336) - select(0u, 1u, (_e3348 < _e3337))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3357 = select(_e3348, _e3337, _e3355);
                                    let _e3358 = function_8(4u);
                                    let _e3361 = (_e3357 + _e3358.member_1);
                                    let _e3365 = ((select(_e3347, _e3336, _e3355) + _e3358.member) + select(0u, 1u, (_e3361 < _e3357)));
                                    let _e3380 = ((_e3361 >> bitcast<u32>((_e3137.member_2 & 31u))) | ((_e3365 << bitcast<u32>(((31u - _e3137.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3381 = function_8(4u);
                                    let _e3384 = (_e3380 + _e3381.member_1);
                                    let _e3402 = ((_e1328[2][1][0].member - _e1328[2][0][0].member) - select(0u, 1u, (_e1328[2][1][0].member_1 < _e1328[2][0][0].member_1)));
                                    let _e3403 = (_e1328[2][1][0].member_1 - _e1328[2][0][0].member_1);
                                    let _e3415 = ((_e1328[2][1][1].member - _e1328[2][0][1].member) - select(0u, 1u, (_e1328[2][1][1].member_1 < _e1328[2][0][1].member_1)));
                                    let _e3416 = (_e1328[2][1][1].member_1 - _e1328[2][0][1].member_1);
                                    let _e3428 = ((_e1328[2][1][2].member - _e1328[2][0][2].member) - select(0u, 1u, (_e1328[2][1][2].member_1 < _e1328[2][0][2].member_1)));
                                    let _e3429 = (_e1328[2][1][2].member_1 - _e1328[2][0][2].member_1);
                                    let _e3432 = ((_e3402 >> bitcast<u32>(31i)) != 0u);
                                    let _e3439 = select(_e3402, (~(_e3402) + select(0u, 1u, (_e3403 == 0u))), _e3432);
                                    let _e3440 = select(_e3403, (~(_e3403) + 1u), _e3432);
                                    let _e3443 = ((_e3415 >> bitcast<u32>(31i)) != 0u);
                                    let _e3450 = select(_e3415, (~(_e3415) + select(0u, 1u, (_e3416 == 0u))), _e3443);
                                    let _e3451 = select(_e3416, (~(_e3416) + 1u), _e3443);
                                    let _e3458 = ((((_e3450 - _e3439) - select(0u, 1u, (_e3451 < _e3440))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3459 = select(_e3450, _e3439, _e3458);
                                    let _e3460 = select(_e3451, _e3440, _e3458);
                                    let _e3463 = ((_e3428 >> bitcast<u32>(31i)) != 0u);
                                    let _e3470 = select(_e3428, (~(_e3428) + select(0u, 1u, (_e3429 == 0u))), _e3463);
                                    let _e3471 = select(_e3429, (~(_e3429) + 1u), _e3463);
                                    let _e3478 = ((((_e3470 - _e3459) - select(0u, 1u, (_e3471 < _e3460))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3480 = select(_e3471, _e3460, _e3478);
                                    let _e3481 = function_8(4u);
                                    let _e3484 = (_e3480 + _e3481.member_1);
                                    let _e3488 = ((select(_e3470, _e3459, _e3478) + _e3481.member) + select(0u, 1u, (_e3484 < _e3480)));
                                    let _e3503 = ((_e3484 >> bitcast<u32>((_e3137.member_2 & 31u))) | ((_e3488 << bitcast<u32>(((31u - _e3137.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3504 = function_8(4u);
                                    let _e3507 = (_e3503 + _e3504.member_1);
                                    local_1[0u].member = ((bitcast<u32>((bitcast<i32>(_e3242) >> bitcast<u32>((_e3137.member_2 & 31u)))) + _e3258.member) + select(0u, 1u, (_e3261 < _e3257)));
                                    local_1[0u].member_1 = _e3261;
                                    local_1[1u].member = ((bitcast<u32>((bitcast<i32>(_e3365) >> bitcast<u32>((_e3137.member_2 & 31u)))) + _e3381.member) + select(0u, 1u, (_e3384 < _e3380)));
                                    local_1[1u].member_1 = _e3384;
                                    local_1[2u].member = ((bitcast<u32>((bitcast<i32>(_e3488) >> bitcast<u32>((_e3137.member_2 & 31u)))) + _e3504.member) + select(0u, 1u, (_e3507 < _e3503)));
                                    local_1[2u].member_1 = _e3507;
                                    let _e3537 = function_6(((_e1328[0][1][0].member - _e1328[0][0][0].member) - select(0u, 1u, (_e1328[0][1][0].member_1 < _e1328[0][0][0].member_1))), (_e1328[0][1][0].member_1 - _e1328[0][0][0].member_1), _e3137.member);
                                    let _e3540 = (_e1328[0][0][0].member_1 + _e3537.member_1);
                                    let _e3544 = ((_e1328[0][0][0].member + _e3537.member) + select(0u, 1u, (_e3540 < _e1328[0][0][0].member_1)));
                                    let _e3558 = function_6(((_e1328[0][1][1].member - _e1328[0][0][1].member) - select(0u, 1u, (_e1328[0][1][1].member_1 < _e1328[0][0][1].member_1))), (_e1328[0][1][1].member_1 - _e1328[0][0][1].member_1), _e3137.member);
                                    let _e3561 = (_e1328[0][0][1].member_1 + _e3558.member_1);
                                    let _e3565 = ((_e1328[0][0][1].member + _e3558.member) + select(0u, 1u, (_e3561 < _e1328[0][0][1].member_1)));
                                    let _e3579 = function_6(((_e1328[0][1][2].member - _e1328[0][0][2].member) - select(0u, 1u, (_e1328[0][1][2].member_1 < _e1328[0][0][2].member_1))), (_e1328[0][1][2].member_1 - _e1328[0][0][2].member_1), _e3137.member);
                                    let _e3582 = (_e1328[0][0][2].member_1 + _e3579.member_1);
                                    let _e3586 = ((_e1328[0][0][2].member + _e3579.member) + select(0u, 1u, (_e3582 < _e1328[0][0][2].member_1)));
                                    let _e3602 = function_6(((_e1328[1][1][0].member - _e1328[1][0][0].member) - select(0u, 1u, (_e1328[1][1][0].member_1 < _e1328[1][0][0].member_1))), (_e1328[1][1][0].member_1 - _e1328[1][0][0].member_1), _e3137.member);
                                    let _e3605 = (_e1328[1][0][0].member_1 + _e3602.member_1);
                                    let _e3609 = ((_e1328[1][0][0].member + _e3602.member) + select(0u, 1u, (_e3605 < _e1328[1][0][0].member_1)));
                                    let _e3623 = function_6(((_e1328[1][1][1].member - _e1328[1][0][1].member) - select(0u, 1u, (_e1328[1][1][1].member_1 < _e1328[1][0][1].member_1))), (_e1328[1][1][1].member_1 - _e1328[1][0][1].member_1), _e3137.member);
                                    let _e3626 = (_e1328[1][0][1].member_1 + _e3623.member_1);
                                    let _e3630 = ((_e1328[1][0][1].member + _e3623.member) + select(0u, 1u, (_e3626 < _e1328[1][0][1].member_1)));
                                    let _e3644 = function_6(((_e1328[1][1][2].member - _e1328[1][0][2].member) - select(0u, 1u, (_e1328[1][1][2].member_1 < _e1328[1][0][2].member_1))), (_e1328[1][1][2].member_1 - _e1328[1][0][2].member_1), _e3137.member);
                                    let _e3647 = (_e1328[1][0][2].member_1 + _e3644.member_1);
                                    let _e3651 = ((_e1328[1][0][2].member + _e3644.member) + select(0u, 1u, (_e3647 < _e1328[1][0][2].member_1)));
                                    let _e3667 = function_6(((_e1328[2][1][0].member - _e1328[2][0][0].member) - select(0u, 1u, (_e1328[2][1][0].member_1 < _e1328[2][0][0].member_1))), (_e1328[2][1][0].member_1 - _e1328[2][0][0].member_1), _e3137.member);
                                    let _e3670 = (_e1328[2][0][0].member_1 + _e3667.member_1);
                                    let _e3674 = ((_e1328[2][0][0].member + _e3667.member) + select(0u, 1u, (_e3670 < _e1328[2][0][0].member_1)));
                                    let _e3688 = function_6(((_e1328[2][1][1].member - _e1328[2][0][1].member) - select(0u, 1u, (_e1328[2][1][1].member_1 < _e1328[2][0][1].member_1))), (_e1328[2][1][1].member_1 - _e1328[2][0][1].member_1), _e3137.member);
                                    let _e3691 = (_e1328[2][0][1].member_1 + _e3688.member_1);
                                    let _e3695 = ((_e1328[2][0][1].member + _e3688.member) + select(0u, 1u, (_e3691 < _e1328[2][0][1].member_1)));
                                    let _e3709 = function_6(((_e1328[2][1][2].member - _e1328[2][0][2].member) - select(0u, 1u, (_e1328[2][1][2].member_1 < _e1328[2][0][2].member_1))), (_e1328[2][1][2].member_1 - _e1328[2][0][2].member_1), _e3137.member);
                                    let _e3712 = (_e1328[2][0][2].member_1 + _e3709.member_1);
                                    let _e3716 = ((_e1328[2][0][2].member + _e3709.member) + select(0u, 1u, (_e3712 < _e1328[2][0][2].member_1)));
                                    let _e3717 = function_4(_e3630, _e3626, _e3716, _e3712);
                                    let _e3720 = function_4(_e3651, _e3647, _e3695, _e3691);
                                    let _e3726 = ((_e3717.member - _e3720.member) - select(0u, 1u, (_e3717.member_1 < _e3720.member_1)));
                                    let _e3727 = (_e3717.member_1 - _e3720.member_1);
                                    let _e3728 = function_4(_e3651, _e3647, _e3674, _e3670);
                                    let _e3731 = function_4(_e3609, _e3605, _e3716, _e3712);
                                    let _e3737 = ((_e3728.member - _e3731.member) - select(0u, 1u, (_e3728.member_1 < _e3731.member_1)));
                                    let _e3738 = (_e3728.member_1 - _e3731.member_1);
                                    let _e3739 = function_4(_e3609, _e3605, _e3695, _e3691);
                                    let _e3742 = function_4(_e3630, _e3626, _e3674, _e3670);
                                    let _e3748 = ((_e3739.member - _e3742.member) - select(0u, 1u, (_e3739.member_1 < _e3742.member_1)));
                                    let _e3749 = (_e3739.member_1 - _e3742.member_1);
                                    let _e3752 = ((_e3726 >> bitcast<u32>(31i)) != 0u);
                                    let _e3759 = select(_e3726, (~(_e3726) + select(0u, 1u, (_e3727 == 0u))), _e3752);
                                    let _e3760 = select(_e3727, (~(_e3727) + 1u), _e3752);
                                    let _e3763 = ((_e3737 >> bitcast<u32>(31i)) != 0u);
                                    let _e3770 = select(_e3737, (~(_e3737) + select(0u, 1u, (_e3738 == 0u))), _e3763);
                                    let _e3771 = select(_e3738, (~(_e3738) + 1u), _e3763);
                                    let _e3774 = ((_e3748 >> bitcast<u32>(31i)) != 0u);
                                    let _e3781 = select(_e3748, (~(_e3748) + select(0u, 1u, (_e3749 == 0u))), _e3774);
                                    let _e3782 = select(_e3749, (~(_e3749) + 1u), _e3774);
                                    let _e3807 = select(0i, select(2i, 1i, ((((_e3781 - _e3770) - select(0u, 1u, (_e3782 < _e3771))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e3781 - _e3759) - select(0u, 1u, (_e3782 < _e3760))) >> bitcast<u32>(31i)) != 0u)), ((((_e3770 - _e3759) - select(0u, 1u, (_e3771 < _e3760))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e3807 {
                                        case 0: {
                                            phi_4982_ = array<type_9, 2>(type_9(_e3565, _e3561), type_9(_e3586, _e3582));
                                            break;
                                        }
                                        case 1: {
                                            phi_4982_ = array<type_9, 2>(type_9(_e3586, _e3582), type_9(_e3544, _e3540));
                                            break;
                                        }
                                        default: {
                                            phi_4982_ = array<type_9, 2>(type_9(_e3544, _e3540), type_9(_e3565, _e3561));
                                            break;
                                        }
                                    }
                                    let _e3818 = phi_4982_;
                                    switch _e3807 {
                                        case 0: {
                                            phi_5011_ = array<type_9, 2>(type_9(_e3630, _e3626), type_9(_e3651, _e3647));
                                            break;
                                        }
                                        case 1: {
                                            phi_5011_ = array<type_9, 2>(type_9(_e3651, _e3647), type_9(_e3609, _e3605));
                                            break;
                                        }
                                        default: {
                                            phi_5011_ = array<type_9, 2>(type_9(_e3609, _e3605), type_9(_e3630, _e3626));
                                            break;
                                        }
                                    }
                                    let _e3829 = phi_5011_;
                                    switch _e3807 {
                                        case 0: {
                                            phi_5040_ = array<type_9, 2>(type_9(_e3695, _e3691), type_9(_e3716, _e3712));
                                            break;
                                        }
                                        case 1: {
                                            phi_5040_ = array<type_9, 2>(type_9(_e3716, _e3712), type_9(_e3674, _e3670));
                                            break;
                                        }
                                        default: {
                                            phi_5040_ = array<type_9, 2>(type_9(_e3674, _e3670), type_9(_e3695, _e3691));
                                            break;
                                        }
                                    }
                                    let _e3840 = phi_5040_;
                                    switch _e3807 {
                                        case 0: {
                                            phi_5054_ = type_9(_e3726, _e3727);
                                            break;
                                        }
                                        case 1: {
                                            phi_5054_ = type_9(_e3737, _e3738);
                                            break;
                                        }
                                        default: {
                                            phi_5054_ = type_9(_e3748, _e3749);
                                            break;
                                        }
                                    }
                                    let _e3845 = phi_5054_;
                                    let _e3848 = local_1[1u].member;
                                    let _e3850 = local_1[1u].member_1;
                                    let _e3853 = local_1[2u].member;
                                    let _e3855 = local_1[2u].member_1;
                                    let _e3856 = (_e3850 + _e3855);
                                    let _e3860 = ((_e3848 + _e3853) + select(0u, 1u, (_e3856 < _e3850)));
                                    let _e3871 = ((_e3856 >> bitcast<u32>(1u)) | ((_e3860 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3872 = function_8(17u);
                                    let _e3875 = (_e3871 + _e3872.member_1);
                                    let _e3879 = ((bitcast<u32>((bitcast<i32>(_e3860) >> bitcast<u32>(1u))) + _e3872.member) + select(0u, 1u, (_e3875 < _e3871)));
                                    let _e3882 = local_1[0u].member;
                                    let _e3884 = local_1[0u].member_1;
                                    let _e3887 = local_1[2u].member;
                                    let _e3889 = local_1[2u].member_1;
                                    let _e3890 = (_e3884 + _e3889);
                                    let _e3894 = ((_e3882 + _e3887) + select(0u, 1u, (_e3890 < _e3884)));
                                    let _e3905 = ((_e3890 >> bitcast<u32>(1u)) | ((_e3894 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3906 = function_8(17u);
                                    let _e3909 = (_e3905 + _e3906.member_1);
                                    let _e3913 = ((bitcast<u32>((bitcast<i32>(_e3894) >> bitcast<u32>(1u))) + _e3906.member) + select(0u, 1u, (_e3909 < _e3905)));
                                    let _e3916 = local_1[0u].member;
                                    let _e3918 = local_1[0u].member_1;
                                    let _e3921 = local_1[1u].member;
                                    let _e3923 = local_1[1u].member_1;
                                    let _e3924 = (_e3918 + _e3923);
                                    let _e3928 = ((_e3916 + _e3921) + select(0u, 1u, (_e3924 < _e3918)));
                                    let _e3939 = ((_e3924 >> bitcast<u32>(1u)) | ((_e3928 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3940 = function_8(17u);
                                    let _e3943 = (_e3939 + _e3940.member_1);
                                    let _e3947 = ((bitcast<u32>((bitcast<i32>(_e3928) >> bitcast<u32>(1u))) + _e3940.member) + select(0u, 1u, (_e3943 < _e3939)));
                                    let _e3952 = ((_e3845.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e3879 - select(_e3845.member, (~(_e3845.member) + select(0u, 1u, (_e3845.member_1 == 0u))), _e3952)) - select(0u, 1u, (_e3875 < select(_e3845.member_1, (~(_e3845.member_1) + 1u), _e3952)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e3973 = ((_e3845.member >> bitcast<u32>(31i)) != 0u);
                                        let _e3983 = select(_e3845.member, (~(_e3845.member) + select(0u, 1u, (_e3845.member_1 == 0u))), _e3973);
                                        let _e3985 = select(_e3845.member_1, (~(_e3845.member_1) + 1u), _e3973);
                                        let _e3986 = function_5(_e3818, _e3840);
                                        let _e3996 = select(_e3986.member, (~(_e3986.member) + select(0u, 1u, (_e3986.member_1 == 0u))), _e3973);
                                        let _e3998 = select(_e3986.member_1, (~(_e3986.member_1) + 1u), _e3973);
                                        let _e3999 = function_5(_e3829, _e3818);
                                        let _e4009 = select(_e3999.member, (~(_e3999.member) + select(0u, 1u, (_e3999.member_1 == 0u))), _e3973);
                                        let _e4011 = select(_e3999.member_1, (~(_e3999.member_1) + 1u), _e3973);
                                        if (_e220.member != 0u) {
                                            let _e4043 = (_e3875 + _e3909);
                                            let _e4055 = (_e3875 + _e3943);
                                            phi_5376_ = type_9(((_e3879 + _e3947) + select(0u, 1u, (_e4055 < _e3875))), _e4055);
                                            phi_5377_ = type_9(((_e3983 - _e4009) - select(0u, 1u, (_e3985 < _e4011))), (_e3985 - _e4011));
                                            phi_5378_ = type_9(((_e3879 + _e3913) + select(0u, 1u, (_e4043 < _e3875))), _e4043);
                                            phi_5379_ = type_9(((_e3983 - _e3996) - select(0u, 1u, (_e3985 < _e3998))), (_e3985 - _e3998));
                                        } else {
                                            let _e4017 = (_e3985 - _e3998);
                                            let _e4021 = ((((_e3983 - _e3996) - select(0u, 1u, (_e3985 < _e3998))) - _e4009) - select(0u, 1u, (_e4017 < _e4011)));
                                            let _e4022 = (_e4017 - _e4011);
                                            let _e4024 = (_e3875 + _e3909);
                                            let _e4029 = (_e4024 + _e3943);
                                            let _e4033 = ((((_e3879 + _e3913) + select(0u, 1u, (_e4024 < _e3875))) + _e3947) + select(0u, 1u, (_e4029 < _e4024)));
                                            phi_5376_ = type_9(_e4033, _e4029);
                                            phi_5377_ = type_9(_e4021, _e4022);
                                            phi_5378_ = type_9(_e4033, _e4029);
                                            phi_5379_ = type_9(_e4021, _e4022);
                                        }
                                        let _e4062 = phi_5376_;
                                        let _e4064 = phi_5377_;
                                        let _e4066 = phi_5378_;
                                        let _e4068 = phi_5379_;
                                        let _e4069 = function_2(_e3996, _e3998, _e3913, _e3909);
                                        if _e4069 {
                                            phi_5505_ = u32();
                                            phi_5506_ = true;
                                        } else {
                                            let _e4070 = function_2(_e4009, _e4011, _e3947, _e3943);
                                            if _e4070 {
                                                phi_5503_ = u32();
                                                phi_5504_ = true;
                                            } else {
                                                let _e4075 = function_2(_e4068.member, _e4068.member_1, _e4066.member, _e4066.member_1);
                                                if _e4075 {
                                                    phi_5501_ = u32();
                                                    phi_5502_ = true;
                                                } else {
                                                    let _e4080 = function_2(_e4064.member, _e4064.member_1, _e4062.member, _e4062.member_1);
                                                    if _e4080 {
                                                        phi_5500_ = u32();
                                                    } else {
                                                        let _e4081 = function_1(_e3996, _e3998, _e3913, _e3909);
                                                        if _e4081 {
                                                            let _e4082 = function_1(_e4009, _e4011, _e3947, _e3943);
                                                            if _e4082 {
                                                                let _e4087 = function_1(_e4068.member, _e4068.member_1, _e4066.member, _e4066.member_1);
                                                                if _e4087 {
                                                                    let _e4092 = function_1(_e4064.member, _e4064.member_1, _e4062.member, _e4062.member_1);
                                                                    phi_5493_ = select(true, false, _e4092);
                                                                } else {
                                                                    phi_5493_ = true;
                                                                }
                                                                let _e4095 = phi_5493_;
                                                                phi_5494_ = _e4095;
                                                            } else {
                                                                phi_5494_ = true;
                                                            }
                                                            let _e4097 = phi_5494_;
                                                            phi_5495_ = _e4097;
                                                        } else {
                                                            phi_5495_ = true;
                                                        }
                                                        let _e4099 = phi_5495_;
                                                        phi_5500_ = select(0u, 2u, _e4099);
                                                    }
                                                    let _e4102 = phi_5500_;
                                                    phi_5501_ = _e4102;
                                                    phi_5502_ = _e4080;
                                                }
                                                let _e4104 = phi_5501_;
                                                let _e4106 = phi_5502_;
                                                phi_5503_ = _e4104;
                                                phi_5504_ = _e4106;
                                            }
                                            let _e4108 = phi_5503_;
                                            let _e4110 = phi_5504_;
                                            phi_5505_ = _e4108;
                                            phi_5506_ = _e4110;
                                        }
                                        let _e4112 = phi_5505_;
                                        let _e4114 = phi_5506_;
                                        phi_5511_ = select(_e4112, 1u, _e4114);
                                    } else {
                                        phi_5511_ = 2u;
                                    }
                                    let _e4117 = phi_5511_;
                                    let _e4118 = (_e4117 == 1u);
                                    let _e4119 = (_e4117 == 0u);
                                    let _e4135 = local_90;
                                    if _e4135 {
                                        let _e5031 = local_112;
                                        phi_5583_ = _e5031;
                                        phi_5584_ = _e4118;
                                        phi_5585_ = select(true, false, _e4118);
                                        phi_5586_ = false;
                                        phi_5587_ = false;
                                    } else {
                                        let _e4139 = select(true, select(true, select(true, select(true, false, ((_e3137.member_1 - _e3137.member) <= _e705)), select(false, (_e3137.member_1 <= _e703), (_e3137.member >= _e701))), _e3123), _e4119);
                                        let _e4141 = select(select(false, select((_e3137.member > _e703), true, (_e3137.member_1 < _e701)), _e3135), true, _e4118);
                                        let _e4142 = select(true, _e4141, select(((((select(0u, select(1u, 2u, ((_e2420[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2427.member - select(_e2440[0].member, (~(_e2420[0].member) + select(0u, 1u, (_e2424[0].member_1 == 0u))), _e2432)) - select(0u, 1u, (_e2427.member_1 < select(_e2440[0].member_1, (~(_e2424[0].member_1) + 1u), _e2432)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2459[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2466.member - select(_e2479[1].member, (~(_e2459[1].member) + select(0u, 1u, (_e2463[1].member_1 == 0u))), _e2471)) - select(0u, 1u, (_e2466.member_1 < select(_e2479[1].member_1, (~(_e2463[1].member_1) + 1u), _e2471)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e2499[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2506.member - select(_e2519[2].member, (~(_e2499[2].member) + select(0u, 1u, (_e2503[2].member_1 == 0u))), _e2511)) - select(0u, 1u, (_e2506.member_1 < select(_e2519[2].member_1, (~(_e2503[2].member_1) + 1u), _e2511)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e2539[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2546.member - select(_e2559[3].member, (~(_e2539[3].member) + select(0u, 1u, (_e2543[3].member_1 == 0u))), _e2551)) - select(0u, 1u, (_e2546.member_1 < select(_e2559[3].member_1, (~(_e2543[3].member_1) + 1u), _e2551)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e2580 == 31u), true, _e1664)));
                                        phi_5583_ = select(bool(), _e4141, _e4139);
                                        phi_5584_ = select(false, _e4142, _e4139);
                                        phi_5585_ = false;
                                        phi_5586_ = select(false, select(true, false, _e4142), _e4139);
                                        phi_5587_ = select(true, false, _e4139);
                                    }
                                    let _e4150 = phi_5583_;
                                    let _e4152 = phi_5584_;
                                    let _e4154 = phi_5585_;
                                    let _e4156 = phi_5586_;
                                    let _e4158 = phi_5587_;
                                    phi_5594_ = _e3135;
                                    phi_5595_ = _e2924;
                                    phi_5596_ = true;
                                    phi_5597_ = !(_e2742);
                                    phi_5598_ = _e2928;
                                    phi_5599_ = _e4150;
                                    phi_5600_ = _e4119;
                                    phi_5601_ = _e3137;
                                    phi_5602_ = _e4152;
                                    phi_5603_ = select(_e4154, false, _e4152);
                                    phi_5604_ = select(_e4156, false, _e4152);
                                    phi_5605_ = select(_e4158, false, _e4152);
                                }
                                let _e4163 = phi_5594_;
                                let _e4165 = phi_5595_;
                                let _e4167 = phi_5596_;
                                let _e4169 = phi_5597_;
                                let _e4171 = phi_5598_;
                                let _e4173 = phi_5599_;
                                let _e4175 = phi_5600_;
                                let _e4177 = phi_5601_;
                                let _e4179 = phi_5602_;
                                let _e4181 = phi_5603_;
                                let _e4183 = phi_5604_;
                                let _e4185 = phi_5605_;
                                phi_5606_ = _e4163;
                                phi_5607_ = _e4165;
                                phi_5608_ = _e4167;
                                phi_5609_ = _e4169;
                                phi_5610_ = _e4171;
                                phi_5611_ = _e4173;
                                phi_5612_ = _e4175;
                                phi_5613_ = _e4177;
                                phi_5614_ = _e4179;
                                phi_5615_ = _e4181;
                                phi_5616_ = _e4183;
                                phi_5617_ = _e4185;
                            } else {
                                phi_5606_ = _e1664;
                                phi_5607_ = _e1666;
                                let _e5058 = local_116;
                                phi_5608_ = _e5058;
                                let _e5061 = local_117;
                                phi_5609_ = _e5061;
                                phi_5610_ = _e1672;
                                let _e5065 = local_118;
                                phi_5611_ = _e5065;
                                phi_5612_ = bool();
                                phi_5613_ = type_17();
                                phi_5614_ = true;
                                phi_5615_ = false;
                                phi_5616_ = false;
                                phi_5617_ = false;
                            }
                            let _e4187 = phi_5606_;
                            let _e4189 = phi_5607_;
                            let _e4191 = phi_5608_;
                            let _e4193 = phi_5609_;
                            let _e4195 = phi_5610_;
                            let _e4197 = phi_5611_;
                            let _e4199 = phi_5612_;
                            let _e4201 = phi_5613_;
                            let _e4203 = phi_5614_;
                            let _e4205 = phi_5615_;
                            let _e4207 = phi_5616_;
                            let _e4209 = phi_5617_;
                            if _e4203 {
                                if _e4197 {
                                    let _e4213 = local_91;
                                    let _e4214 = (_e4213 + 1u);
                                    let _e4216 = local_92;
                                    let _e4218 = (_e4214 & (4294967295u - _e4216));
                                    let _e4224 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4218)), 32u, (_e4218 == 0u)));
                                    let _e4226 = local_93;
                                    let _e4229 = local_94;
                                    let _e4230 = select(_e4224, _e4229, (_e4226 < _e4224));
                                    let _e4233 = (_e4214 >> bitcast<u32>((_e4230 & 31u)));
                                    let _e4235 = local_95;
                                    let _e4236 = (_e4235 - _e4230);
                                    let _e4238 = local_96;
                                    let _e4239 = (_e4238 > _e703);
                                    if _e4239 {
                                        phi_5668_ = u32();
                                        phi_5669_ = u32();
                                        phi_5670_ = false;
                                        phi_5671_ = false;
                                    } else {
                                        let _e4243 = select(true, select(true, false, (_e4236 == 0u)), (_e4233 == 1u));
                                        let _e4244 = (31u - _e4236);
                                        phi_5668_ = select(u32(), ((_e4233 + 1u) << bitcast<u32>((_e4244 & 31u))), _e4243);
                                        phi_5669_ = select(u32(), (_e4233 << bitcast<u32>((_e4244 & 31u))), _e4243);
                                        phi_5670_ = _e4243;
                                        phi_5671_ = select(true, false, _e4243);
                                    }
                                    let _e4256 = phi_5668_;
                                    let _e4258 = phi_5669_;
                                    let _e4260 = phi_5670_;
                                    let _e4262 = phi_5671_;
                                    phi_5672_ = _e4256;
                                    phi_5673_ = _e4258;
                                    phi_5674_ = false;
                                    phi_5675_ = false;
                                    phi_5676_ = false;
                                    phi_5677_ = false;
                                    phi_5678_ = _e4236;
                                    phi_5679_ = _e4233;
                                    phi_5680_ = _e4260;
                                    phi_5681_ = _e4239;
                                    phi_5682_ = _e4262;
                                } else {
                                    phi_5672_ = _e4195.member_1;
                                    phi_5673_ = _e4195.member;
                                    phi_5674_ = _e4187;
                                    phi_5675_ = _e4189;
                                    phi_5676_ = _e4191;
                                    phi_5677_ = _e4193;
                                    let _e5090 = local_119;
                                    phi_5678_ = _e5090;
                                    let _e5093 = local_120;
                                    phi_5679_ = _e5093;
                                    phi_5680_ = true;
                                    phi_5681_ = false;
                                    phi_5682_ = false;
                                }
                                let _e4264 = phi_5672_;
                                let _e4266 = phi_5673_;
                                let _e4268 = phi_5674_;
                                let _e4270 = phi_5675_;
                                let _e4272 = phi_5676_;
                                let _e4274 = phi_5677_;
                                let _e4276 = phi_5678_;
                                let _e4278 = phi_5679_;
                                let _e4280 = phi_5680_;
                                let _e4282 = phi_5681_;
                                let _e4284 = phi_5682_;
                                if _e4280 {
                                    if select(_e4268, true, _e4197) {
                                        phi_5707_ = type_14(0i, 4i);
                                        phi_5710_ = array<u32, 3>(_e4266, _e4266, _e4266);
                                        phi_5712_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                                        loop {
                                            let _e4288 = phi_5707_;
                                            let _e4290 = phi_5710_;
                                            let _e4292 = phi_5712_;
                                            local_121 = _e4292;
                                            if (_e4288.member < _e4288.member_1) {
                                                let _e4299 = (_e4288.member + 1i);
                                                phi_5708_ = type_14(select(_e4299, type_15().member_1, select(false, true, ((false == (_e4299 > _e4288.member)) != false))), _e4288.member_1);
                                                phi_5753_ = type_15(1u, _e4288.member);
                                            } else {
                                                phi_5708_ = _e4288;
                                                phi_5753_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e4310 = phi_5708_;
                                            let _e4312 = phi_5753_;
                                            let _e4315 = (bitcast<i32>(_e4312.member) != 0i);
                                            if _e4315 {
                                                let _e4324 = function_6(((_e1621[1].member - _e1617.member) - select(0u, 1u, (_e1625[1].member_1 < _e1617.member_1))), (_e1625[1].member_1 - _e1617.member_1), _e4290[0]);
                                                let _e4327 = (_e1617.member_1 + _e4324.member_1);
                                                let _e4331 = ((_e1617.member + _e4324.member) + select(0u, 1u, (_e4327 < _e1617.member_1)));
                                                let _e4337 = function_6(((_e1629[2].member - _e1621[1].member) - select(0u, 1u, (_e1633[2].member_1 < _e1625[1].member_1))), (_e1633[2].member_1 - _e1625[1].member_1), _e4290[0]);
                                                let _e4340 = (_e1625[1].member_1 + _e4337.member_1);
                                                let _e4344 = ((_e1621[1].member + _e4337.member) + select(0u, 1u, (_e4340 < _e1625[1].member_1)));
                                                let _e4350 = function_6(((_e1644.member - _e1629[2].member) - select(0u, 1u, (_e1644.member_1 < _e1633[2].member_1))), (_e1644.member_1 - _e1633[2].member_1), _e4290[0]);
                                                let _e4353 = (_e1633[2].member_1 + _e4350.member_1);
                                                let _e4363 = function_6(((_e4344 - _e4331) - select(0u, 1u, (_e4340 < _e4327))), (_e4340 - _e4327), _e4290[1]);
                                                let _e4366 = (_e4327 + _e4363.member_1);
                                                let _e4370 = ((_e4331 + _e4363.member) + select(0u, 1u, (_e4366 < _e4327)));
                                                let _e4376 = function_6(((((_e1629[2].member + _e4350.member) + select(0u, 1u, (_e4353 < _e1633[2].member_1))) - _e4344) - select(0u, 1u, (_e4353 < _e4340))), (_e4353 - _e4340), _e4290[1]);
                                                let _e4379 = (_e4340 + _e4376.member_1);
                                                let _e4389 = function_6(((((_e4344 + _e4376.member) + select(0u, 1u, (_e4379 < _e4340))) - _e4370) - select(0u, 1u, (_e4379 < _e4366))), (_e4379 - _e4366), _e4290[2]);
                                                let _e4392 = (_e4366 + _e4389.member_1);
                                                phi_5711_ = array<u32, 3>(_e4290[1], _e4290[2], _e4264);
                                                phi_5713_ = array<type_9, 4>(_e4292[1], _e4292[2], _e4292[3], type_9(((_e4370 + _e4389.member) + select(0u, 1u, (_e4392 < _e4366))), _e4392));
                                            } else {
                                                phi_5711_ = array<u32, 3>();
                                                phi_5713_ = array<type_9, 4>();
                                            }
                                            let _e4406 = phi_5711_;
                                            let _e4408 = phi_5713_;
                                            continue;
                                            continuing {
                                                phi_5707_ = _e4310;
                                                phi_5710_ = _e4406;
                                                phi_5712_ = _e4408;
                                                break if !(_e4315);
                                            }
                                        }
                                        let _e5106 = local_121;
                                        phi_5906_ = _e5106;
                                    } else {
                                        let _e5108 = local_122;
                                        phi_5906_ = _e5108;
                                    }
                                    let _e4411 = phi_5906_;
                                    phi_5907_ = _e4411;
                                    phi_5908_ = false;
                                    phi_5909_ = false;
                                } else {
                                    phi_5907_ = array<type_9, 4>();
                                    phi_5908_ = _e4282;
                                    phi_5909_ = _e4284;
                                }
                                let _e4413 = phi_5907_;
                                let _e4415 = phi_5908_;
                                let _e4417 = phi_5909_;
                                phi_5910_ = _e4413;
                                phi_5911_ = _e4268;
                                phi_5912_ = _e4270;
                                phi_5913_ = _e4272;
                                phi_5914_ = _e4274;
                                phi_5915_ = _e4276;
                                phi_5916_ = _e4278;
                                phi_5917_ = _e4280;
                                phi_5918_ = _e4415;
                                phi_5919_ = _e4417;
                                phi_5920_ = false;
                                phi_5921_ = false;
                                phi_5922_ = false;
                            } else {
                                phi_5910_ = array<type_9, 4>();
                                phi_5911_ = bool();
                                phi_5912_ = bool();
                                phi_5913_ = bool();
                                phi_5914_ = bool();
                                phi_5915_ = u32();
                                phi_5916_ = u32();
                                phi_5917_ = false;
                                phi_5918_ = false;
                                phi_5919_ = false;
                                phi_5920_ = _e4205;
                                phi_5921_ = _e4207;
                                phi_5922_ = _e4209;
                            }
                            let _e4419 = phi_5910_;
                            let _e4421 = phi_5911_;
                            let _e4423 = phi_5912_;
                            let _e4425 = phi_5913_;
                            let _e4427 = phi_5914_;
                            let _e4429 = phi_5915_;
                            let _e4431 = phi_5916_;
                            let _e4433 = phi_5917_;
                            let _e4435 = phi_5918_;
                            let _e4437 = phi_5919_;
                            let _e4439 = phi_5920_;
                            let _e4441 = phi_5921_;
                            let _e4443 = phi_5922_;
                            phi_2156_ = _e4419;
                            phi_2159_ = _e4421;
                            phi_2161_ = _e4423;
                            phi_2163_ = _e4425;
                            phi_2165_ = _e4427;
                            phi_2167_ = _e4195;
                            let _e5133 = local_123;
                            phi_2171_ = _e5133;
                            let _e5136 = local_124;
                            phi_2173_ = _e5136;
                            let _e5139 = local_125;
                            phi_2175_ = _e5139;
                            phi_2177_ = _e4429;
                            phi_2179_ = _e4431;
                            phi_5923_ = _e4199;
                            phi_5924_ = _e4201;
                            phi_5925_ = _e4433;
                            phi_5926_ = false;
                            phi_5927_ = _e4435;
                            phi_5928_ = _e4437;
                            phi_5929_ = _e4439;
                            phi_5930_ = _e4441;
                            phi_5931_ = _e4443;
                        } else {
                            phi_2156_ = array<type_9, 4>();
                            phi_2159_ = bool();
                            phi_2161_ = bool();
                            phi_2163_ = bool();
                            phi_2165_ = bool();
                            phi_2167_ = type_17();
                            phi_2171_ = u32();
                            phi_2173_ = u32();
                            phi_2175_ = u32();
                            phi_2177_ = u32();
                            phi_2179_ = u32();
                            phi_5923_ = bool();
                            phi_5924_ = type_17();
                            phi_5925_ = false;
                            phi_5926_ = true;
                            phi_5927_ = false;
                            phi_5928_ = false;
                            phi_5929_ = false;
                            phi_5930_ = false;
                            phi_5931_ = false;
                        }
                        let _e4445 = phi_2156_;
                        let _e4447 = phi_2159_;
                        let _e4449 = phi_2161_;
                        let _e4451 = phi_2163_;
                        let _e4453 = phi_2165_;
                        let _e4455 = phi_2167_;
                        let _e4457 = phi_2171_;
                        let _e4459 = phi_2173_;
                        let _e4461 = phi_2175_;
                        let _e4463 = phi_2177_;
                        let _e4465 = phi_2179_;
                        let _e4467 = phi_5923_;
                        let _e4469 = phi_5924_;
                        let _e4471 = phi_5925_;
                        let _e4473 = phi_5926_;
                        let _e4475 = phi_5927_;
                        let _e4477 = phi_5928_;
                        let _e4479 = phi_5929_;
                        let _e4481 = phi_5930_;
                        let _e4483 = phi_5931_;
                        local_97 = _e4473;
                        local_98 = _e4473;
                        local_99 = _e4473;
                        local_100 = _e4475;
                        local_101 = _e4473;
                        local_102 = _e4477;
                        local_103 = _e4473;
                        local_104 = _e4479;
                        local_105 = _e4473;
                        local_106 = _e4481;
                        local_107 = _e4473;
                        local_108 = _e4483;
                        local_109 = _e4467;
                        local_110 = _e4467;
                        local_111 = _e4469;
                        continue;
                        continuing {
                            phi_2155_ = _e4445;
                            phi_2158_ = _e4447;
                            phi_2160_ = _e4449;
                            phi_2162_ = _e4451;
                            phi_2164_ = _e4453;
                            phi_2166_ = _e4455;
                            phi_2170_ = _e4457;
                            phi_2172_ = _e4459;
                            phi_2174_ = _e4461;
                            phi_2176_ = _e4463;
                            phi_2178_ = _e4465;
                            break if !(_e4471);
                        }
                    }
                    let _e4487 = local_97;
                    let _e4492 = local_98;
                    let _e4495 = local_99;
                    let _e4497 = local_100;
                    let _e4498 = select(_e4497, false, _e4495);
                    let _e4500 = local_101;
                    let _e4502 = local_102;
                    let _e4505 = local_103;
                    let _e4507 = local_104;
                    let _e4510 = local_105;
                    let _e4512 = local_106;
                    let _e4515 = local_107;
                    let _e4517 = local_108;
                    let _e4519 = select(select(_e4502, false, _e4500), false, _e4498);
                    let _e4523 = select(_e4498, true, _e4519);
                    let _e4532 = select(select(select(select(_e4507, false, _e4505), false, _e4498), false, _e4519), false, _e4523);
                    if _e4532 {
                        let _e4536 = local_109;
                        let _e4541 = local_110;
                        phi_5973_ = type_9(select(2u, 3u, _e4536), select(type_9().member_1, type_9().member_1, _e4541));
                        phi_5974_ = false;
                        phi_5975_ = false;
                        phi_5976_ = false;
                    } else {
                        phi_5973_ = type_9();
                        phi_5974_ = select(select(select(select(_e4512, false, _e4510), false, _e4498), false, _e4519), false, _e4523);
                        phi_5975_ = select(select(select(select(_e4517, false, _e4515), false, _e4498), false, _e4519), false, _e4523);
                        phi_5976_ = _e4523;
                    }
                    let _e4545 = phi_5973_;
                    let _e4547 = phi_5974_;
                    let _e4549 = phi_5975_;
                    let _e4551 = phi_5976_;
                    let _e4557 = select(_e4549, false, _e4547);
                    let _e4561 = local_111;
                    let _e4565 = select(_e4547, true, _e4557);
                    let _e4572 = select(select(select(_e4532, false, _e4547), false, _e4557), true, _e4565);
                    let _e4576 = select(select(select(select(_e4551, false, _e4547), false, _e4557), false, _e4565), true, _e4572);
                    phi_6012_ = type_9(select(select(type_9().member, 2u, _e4487), select(select(type_9().member, 0u, _e4523), select(_e4545.member, select(select(type_9().member, 2u, _e4547), 1u, _e4557), _e4565), _e4572), _e4576), select(select(type_9().member_1, type_9().member_1, _e4492), select(select(type_9().member_1, type_9().member_1, _e4523), select(_e4545.member_1, select(select(type_9().member_1, type_9().member_1, _e4547), _e4561.member, _e4557), _e4565), _e4572), _e4576));
                }
                let _e4583 = phi_6012_;
                phi_6016_ = _e4583;
                phi_6017_ = type_9(_e178, _e181);
            } else {
                phi_6016_ = type_9(0u, u32());
                phi_6017_ = type_9(0u, 0u);
            }
            let _e4585 = phi_6016_;
            let _e4587 = phi_6017_;
            let _e4591 = params.member.member_2.member_1;
            switch bitcast<i32>(_e4585.member) {
                case 0: {
                    phi_6054_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                    phi_6055_ = false;
                    break;
                }
                case 1: {
                    if (_e4585.member_1 == 0u) {
                        phi_6051_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e4600 = select((bitcast<u32>(31i) - firstLeadingBit(_e4585.member_1)), 32u, (_e4585.member_1 == 0u));
                        let _e4605 = ((_e4585.member_1 << bitcast<u32>((_e4600 & 31u))) << bitcast<u32>(1i));
                        phi_6051_ = array<u32, 2>((_e4605 << bitcast<u32>(20i)), (((1023u - _e4600) << bitcast<u32>(20i)) | (_e4605 >> bitcast<u32>(12i))));
                    }
                    let _e4616 = phi_6051_;
                    phi_6054_ = type_26(0u, select(0u, 1u, (_e4585.member_1 > _e4591)), _e4616, true);
                    phi_6055_ = false;
                    break;
                }
                case 2: {
                    phi_6054_ = type_26();
                    phi_6055_ = true;
                    break;
                }
                case 3: {
                    phi_6054_ = type_26();
                    phi_6055_ = true;
                    break;
                }
                default: {
                    phi_6054_ = type_26();
                    phi_6055_ = bool();
                    break;
                }
            }
            let _e4619 = phi_6054_;
            let _e4621 = phi_6055_;
            if _e4621 {
                phi_6059_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
            } else {
                phi_6059_ = _e4619;
            }
            let _e4623 = phi_6059_;
            local_2 = type_26(_e4623.member, _e4623.member_1, array<u32, 2>(_e4623.member_2[0], _e4623.member_2[1]), _e4623.member_3);
            let _e4636 = global.member;
            if (bitcast<i32>(_e4585.member) == bitcast<i32>(_e4636)) {
                if (bitcast<i32>(_e4585.member) == 1i) {
                    let _e4643 = global.member;
                    if (bitcast<i32>(_e4643) == 1i) {
                        let _e4648 = global.member_1;
                        phi_6099_ = (_e4585.member_1 == _e4648);
                        phi_6100_ = false;
                    } else {
                        phi_6099_ = bool();
                        phi_6100_ = true;
                    }
                    let _e4651 = phi_6099_;
                    let _e4653 = phi_6100_;
                    phi_6101_ = _e4651;
                    phi_6102_ = _e4653;
                } else {
                    phi_6101_ = bool();
                    phi_6102_ = true;
                }
                let _e4655 = phi_6101_;
                let _e4657 = phi_6102_;
                phi_6107_ = select(_e4655, true, _e4657);
            } else {
                phi_6107_ = false;
            }
            let _e4660 = phi_6107_;
            let _e4665 = params.member.member_2.member.member;
            let _e4668 = local_2.member;
            let _e4669 = (_e4668 == 0u);
            let _e4674 = select(select(select((_e4665 > 0u), bool(), _e4660), bool(), _e4669), false, select(_e4660, true, _e4669));
            if _e4674 {
                local = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e4675 = local_2;
                local = _e4675;
            }
            let _e4677 = local.member;
            let _e4679 = select(true, false, (_e4677 == 0u));
            let _e4681 = local.member_3;
            if _e4681 {
                if _e4679 {
                    phi_6163_ = true;
                } else {
                    let _e4683 = params.member.member.member_1;
                    phi_6163_ = ((_e4683 & 16u) != 0u);
                }
                let _e4687 = phi_6163_;
                phi_6164_ = _e4687;
            } else {
                phi_6164_ = false;
            }
            let _e4689 = phi_6164_;
            let _e4691 = local.member_3;
            if _e4691 {
                if _e4679 {
                } else {
                    let _e4693 = local.member_2;
                    let _e4697 = (_e4693[1] >> bitcast<u32>(20i));
                    let _e4711 = atomicMin((&earliest.member[0u]), select(((((_e4697 - 896u) << bitcast<u32>(23i)) | ((_e4693[1] & 1048575u) << bitcast<u32>(3i))) | (_e4693[0] >> bitcast<u32>(29i))), 0u, (_e4697 <= 896u)));
                }
            }
            if (_e93 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4689 {
                let _e4715 = atomicAdd((&counters[0u]), 1u);
                phi_6207_ = _e4715;
            } else {
                phi_6207_ = 0u;
            }
            let _e4717 = phi_6207_;
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4720 = atomicLoad((&counters[0u]));
                if (_e4720 > 0u) {
                    let _e4723 = atomicAdd((&contacts.member[0u]), _e4720);
                    atomicStore((&counters[1u]), _e4723);
                }
            }
            workgroupBarrier();
            let _e4726 = atomicLoad((&counters[1u]));
            let _e4727 = (_e4726 + _e4717);
            if _e4689 {
                let _e4729 = params.member.member_1.member_3;
                if (_e4727 < _e4729) {
                    let _e4735 = (7u * _e4727);
                    atomicStore((&contacts.member[(4u + _e4735)]), select(1u, 0u, ((_e4587.member_1 & 2147483648u) == 0u)));
                    let _e4740 = local.member;
                    atomicStore((&contacts.member[(_e4735 + 5u)]), _e4740);
                    atomicStore((&contacts.member[(_e4735 + 6u)]), _e4587.member);
                    atomicStore((&contacts.member[(_e4735 + 7u)]), (_e4587.member_1 & 2147483647u));
                    let _e4749 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e4735 + 8u)]), _e4749);
                    let _e4754 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e4735 + 9u)]), _e4754);
                    let _e4758 = local.member_1;
                    atomicStore((&contacts.member[(_e4735 + 10u)]), _e4758);
                }
            }
            workgroupBarrier();
            if (_e93 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4674 {
                let _e4763 = atomicAdd((&counters[0u]), 1u);
                phi_6289_ = _e4763;
            } else {
                phi_6289_ = 0u;
            }
            let _e4765 = phi_6289_;
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4768 = atomicLoad((&counters[0u]));
                if (_e4768 > 0u) {
                    let _e4771 = atomicAdd((&left.member[0u]), _e4768);
                    atomicStore((&counters[1u]), _e4771);
                }
            }
            workgroupBarrier();
            let _e4774 = atomicLoad((&counters[1u]));
            let _e4775 = (_e4774 + _e4765);
            if _e4674 {
                if (_e4775 < _e4665) {
                    let _e4777 = (2u * _e4775);
                    atomicStore((&left.member[(4u + _e4777)]), _e4587.member);
                    atomicStore((&left.member[(_e4777 + 5u)]), _e4587.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_313_ = type_9(select(_e148.member, (_e148.member + 1u), _e151), select(_e148.member_1, _e148.member_1, _e151));
            break if !(_e164);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
