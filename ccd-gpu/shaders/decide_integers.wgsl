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
    var phi_6405_: type_9;
    var phi_6406_: type_9;
    var phi_6407_: type_9;
    var phi_6408_: type_9;
    var phi_6409_: type_9;
    var phi_6410_: bool;

    let _e24 = ((param_26[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_26[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_27);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_6409_ = type_9();
        phi_6410_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_6408_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_6407_ = type_9((param_26[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_6406_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_26[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_26[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_6405_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_26[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_6405_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_6405_;
                    phi_6406_ = _e67;
                }
                let _e83 = phi_6406_;
                phi_6407_ = _e83;
            }
            let _e89 = phi_6407_;
            phi_6408_ = _e89;
        }
        let _e91 = phi_6408_;
        phi_6409_ = _e91;
        phi_6410_ = _e37;
    }
    let _e93 = phi_6409_;
    let _e95 = phi_6410_;
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
    var phi_3660_: type_17;
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
    var local_84: f32;
    var phi_3661_: bool;
    var phi_3662_: type_17;
    var phi_3663_: type_17;
    var local_85: u32;
    var local_86: u32;
    var phi_3664_: bool;
    var phi_3665_: type_17;
    var phi_3666_: type_17;
    var local_87: array<type_9, 4>;
    var local_88: array<type_9, 4>;
    var local_89: array<type_9, 4>;
    var phi_3733_: u32;
    var phi_3734_: u32;
    var phi_3735_: u32;
    var phi_3738_: type_14;
    var phi_3741_: u32;
    var phi_3743_: u32;
    var phi_3739_: type_14;
    var phi_3783_: type_15;
    var phi_3742_: u32;
    var local_90: u32;
    var phi_3959_: bool;
    var phi_3967_: bool;
    var phi_3968_: type_17;
    var phi_4989_: array<type_9, 2>;
    var phi_5018_: array<type_9, 2>;
    var phi_5047_: array<type_9, 2>;
    var phi_5061_: type_9;
    var phi_5383_: type_9;
    var phi_5384_: type_9;
    var phi_5385_: type_9;
    var phi_5386_: type_9;
    var phi_5500_: bool;
    var phi_5501_: bool;
    var phi_5502_: bool;
    var phi_5507_: u32;
    var phi_5508_: u32;
    var phi_5509_: bool;
    var phi_5510_: u32;
    var phi_5511_: bool;
    var phi_5512_: u32;
    var phi_5513_: bool;
    var phi_5518_: u32;
    var local_91: bool;
    var phi_5590_: bool;
    var phi_5591_: bool;
    var phi_5592_: bool;
    var phi_5593_: bool;
    var phi_5594_: bool;
    var phi_5601_: bool;
    var phi_5602_: bool;
    var phi_5603_: bool;
    var phi_5604_: bool;
    var phi_5605_: type_17;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: type_17;
    var phi_5609_: bool;
    var phi_5610_: bool;
    var phi_5611_: bool;
    var phi_5612_: bool;
    var phi_5613_: bool;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: type_17;
    var phi_5618_: bool;
    var phi_5619_: bool;
    var phi_5620_: type_17;
    var phi_5621_: bool;
    var phi_5622_: bool;
    var phi_5623_: bool;
    var phi_5624_: bool;
    var local_92: u32;
    var local_93: u32;
    var local_94: u32;
    var local_95: u32;
    var local_96: u32;
    var local_97: u32;
    var phi_5675_: u32;
    var phi_5676_: u32;
    var phi_5677_: bool;
    var phi_5678_: bool;
    var phi_5679_: u32;
    var phi_5680_: u32;
    var phi_5681_: bool;
    var phi_5682_: bool;
    var phi_5683_: bool;
    var phi_5684_: bool;
    var phi_5685_: u32;
    var phi_5686_: u32;
    var phi_5687_: bool;
    var phi_5688_: bool;
    var phi_5689_: bool;
    var phi_5714_: type_14;
    var phi_5717_: array<u32, 3>;
    var phi_5719_: array<type_9, 4>;
    var phi_5715_: type_14;
    var phi_5760_: type_15;
    var phi_5718_: array<u32, 3>;
    var phi_5720_: array<type_9, 4>;
    var phi_5913_: array<type_9, 4>;
    var phi_5914_: array<type_9, 4>;
    var phi_5915_: bool;
    var phi_5916_: bool;
    var phi_5917_: array<type_9, 4>;
    var phi_5918_: bool;
    var phi_5919_: bool;
    var phi_5920_: bool;
    var phi_5921_: bool;
    var phi_5922_: u32;
    var phi_5923_: u32;
    var phi_5924_: bool;
    var phi_5925_: bool;
    var phi_5926_: bool;
    var phi_5927_: bool;
    var phi_5928_: bool;
    var phi_5929_: bool;
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
    var phi_5930_: bool;
    var phi_5931_: type_17;
    var phi_5932_: bool;
    var phi_5933_: bool;
    var phi_5934_: bool;
    var phi_5935_: bool;
    var phi_5936_: bool;
    var phi_5937_: bool;
    var phi_5938_: bool;
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
    var local_111: bool;
    var phi_5980_: type_9;
    var phi_5981_: bool;
    var phi_5982_: bool;
    var phi_5983_: bool;
    var local_112: type_17;
    var phi_6019_: type_9;
    var phi_6023_: type_9;
    var phi_6024_: type_9;
    var phi_6058_: array<u32, 2>;
    var phi_6061_: type_26;
    var phi_6062_: bool;
    var phi_6066_: type_26;
    var phi_6106_: bool;
    var phi_6107_: bool;
    var phi_6108_: bool;
    var phi_6109_: bool;
    var phi_6114_: bool;
    var phi_6170_: bool;
    var phi_6171_: bool;
    var phi_6214_: u32;
    var phi_6296_: u32;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var local_116: bool;
    var local_117: bool;
    var local_118: bool;
    var local_119: bool;
    var local_120: u32;
    var local_121: u32;
    var local_122: array<type_9, 4>;
    var local_123: array<type_9, 4>;
    var local_124: u32;
    var local_125: u32;
    var local_126: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e92 = id_2;
    let _e93 = n_2;
    let _e94 = lane_2;
    let _e107 = ((_e92.y * _e93.x) + _e92.x);
    let _e110 = (_e93.x * _e93.y);
    let _e113 = params.member.member_1.member_2;
    let _e115 = input.member[0u];
    let _e117 = select(_e115, _e113, (_e113 < _e115));
    let _e119 = params.member.member_1.member_1;
    if (_e117 > _e119) {
        let _e122 = params.member.member_1.member_1;
        phi_264_ = (_e117 - _e122);
    } else {
        phi_264_ = 0u;
    }
    let _e125 = phi_264_;
    let _e127 = params.member.member_1.member;
    let _e129 = select(_e125, _e127, (_e127 < _e125));
    let _e131 = (_e129 / 64u);
    let _e135 = select(_e131, (_e131 + 1u), ((_e129 % 64u) > 0u));
    if (_e135 > _e107) {
        let _e137 = (_e135 - _e107);
        if (_e110 == 0u) {
            return;
        }
        let _e139 = (_e137 / _e110);
        if (_e110 == 0u) {
            return;
        }
        phi_310_ = select(_e139, (_e139 + 1u), ((_e137 % _e110) > 0u));
    } else {
        phi_310_ = 0u;
    }
    let _e146 = phi_310_;
    phi_313_ = type_9(0u, _e146);
    loop {
        let _e149 = phi_313_;
        let _e152 = (_e149.member < _e149.member_1);
        let _e165 = (bitcast<i32>(select(0u, 1u, _e152)) != 0i);
        if _e165 {
            let _e169 = (((_e107 + (select(type_9().member_1, _e149.member, _e152) * _e110)) * 64u) + _e94);
            if (_e169 < _e129) {
                let _e174 = params.member.member_1.member_1;
                let _e176 = (2u * (_e174 + _e169));
                let _e179 = input.member[(4u + _e176)];
                let _e182 = input.member[(_e176 + 5u)];
                let _e187 = (_e182 & 2147483647u);
                if (select(1u, 0u, ((_e182 & 2147483648u) == 0u)) == 0u) {
                    let _e206 = params.member.member.member[1u];
                    let _e209 = ((2u * _e206) + (3u * _e187));
                    let _e211 = elements.member[_e209];
                    let _e214 = elements.member[(_e209 + 1u)];
                    let _e217 = elements.member[(_e209 + 2u)];
                    phi_488_ = type_20(0u, array<u32, 4>(_e179, _e211, _e214, _e217));
                } else {
                    let _e190 = (2u * _e179);
                    let _e192 = elements.member[_e190];
                    let _e195 = elements.member[(_e190 + 1u)];
                    let _e196 = (2u * _e187);
                    let _e198 = elements.member[_e196];
                    let _e201 = elements.member[(_e196 + 1u)];
                    phi_488_ = type_20(1u, array<u32, 4>(_e192, _e195, _e198, _e201));
                }
                let _e221 = phi_488_;
                let _e226 = paths.member[_e221.member_1[0]];
                let _e241 = paths.member[_e221.member_1[1]];
                let _e256 = paths.member[_e221.member_1[2]];
                let _e271 = paths.member[_e221.member_1[3]];
                let _e285 = params.member.member.member_4;
                if (_e221.member != 0u) {
                    phi_623_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e256.member.x - _e226.member.x), (_e256.member.y - _e226.member.y), (_e256.member.z - _e226.member.z)), array<f32, 3>((_e256.member_1.x - _e226.member_1.x), (_e256.member_1.y - _e226.member_1.y), (_e256.member_1.z - _e226.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e241.member.x - _e226.member.x), (_e241.member.y - _e226.member.y), (_e241.member.z - _e226.member.z)), array<f32, 3>((_e241.member_1.x - _e226.member_1.x), (_e241.member_1.y - _e226.member_1.y), (_e241.member_1.z - _e226.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e256.member.x - _e271.member.x), (_e256.member.y - _e271.member.y), (_e256.member.z - _e271.member.z)), array<f32, 3>((_e256.member_1.x - _e271.member_1.x), (_e256.member_1.y - _e271.member_1.y), (_e256.member_1.z - _e271.member_1.z))), (_e285 + _e285));
                } else {
                    phi_623_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e226.member.x - _e241.member.x), (_e226.member.y - _e241.member.y), (_e226.member.z - _e241.member.z)), array<f32, 3>((_e226.member_1.x - _e241.member_1.x), (_e226.member_1.y - _e241.member_1.y), (_e226.member_1.z - _e241.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e256.member.x - _e241.member.x), (_e256.member.y - _e241.member.y), (_e256.member.z - _e241.member.z)), array<f32, 3>((_e256.member_1.x - _e241.member_1.x), (_e256.member_1.y - _e241.member_1.y), (_e256.member_1.z - _e241.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e271.member.x - _e241.member.x), (_e271.member.y - _e241.member.y), (_e271.member.z - _e241.member.z)), array<f32, 3>((_e271.member_1.x - _e241.member_1.x), (_e271.member_1.y - _e241.member_1.y), (_e271.member_1.z - _e241.member_1.z))), (_e285 + _e285));
                }
                let _e346 = phi_623_;
                let _e352 = select(_e346.member[0][0], -(_e346.member[0][0]), (_e346.member[0][0] < 0f));
                let _e356 = select(_e346.member[0][1], -(_e346.member[0][1]), (_e346.member[0][1] < 0f));
                let _e358 = select(_e356, _e352, (_e352 > _e356));
                let _e362 = select(_e346.member[0][2], -(_e346.member[0][2]), (_e346.member[0][2] < 0f));
                let _e364 = select(_e362, _e358, (_e358 > _e362));
                let _e370 = select(_e346.member[1][0], -(_e346.member[1][0]), (_e346.member[1][0] < 0f));
                let _e374 = select(_e346.member[1][1], -(_e346.member[1][1]), (_e346.member[1][1] < 0f));
                let _e376 = select(_e374, _e370, (_e370 > _e374));
                let _e380 = select(_e346.member[1][2], -(_e346.member[1][2]), (_e346.member[1][2] < 0f));
                let _e382 = select(_e380, _e376, (_e376 > _e380));
                let _e392 = select(_e346.member_1[0][0], -(_e346.member_1[0][0]), (_e346.member_1[0][0] < 0f));
                let _e396 = select(_e346.member_1[0][1], -(_e346.member_1[0][1]), (_e346.member_1[0][1] < 0f));
                let _e398 = select(_e396, _e392, (_e392 > _e396));
                let _e402 = select(_e346.member_1[0][2], -(_e346.member_1[0][2]), (_e346.member_1[0][2] < 0f));
                let _e404 = select(_e402, _e398, (_e398 > _e402));
                let _e410 = select(_e346.member_1[1][0], -(_e346.member_1[1][0]), (_e346.member_1[1][0] < 0f));
                let _e414 = select(_e346.member_1[1][1], -(_e346.member_1[1][1]), (_e346.member_1[1][1] < 0f));
                let _e416 = select(_e414, _e410, (_e410 > _e414));
                let _e420 = select(_e346.member_1[1][2], -(_e346.member_1[1][2]), (_e346.member_1[1][2] < 0f));
                let _e422 = select(_e420, _e416, (_e416 > _e420));
                let _e432 = select(_e346.member_2[0][0], -(_e346.member_2[0][0]), (_e346.member_2[0][0] < 0f));
                let _e436 = select(_e346.member_2[0][1], -(_e346.member_2[0][1]), (_e346.member_2[0][1] < 0f));
                let _e438 = select(_e436, _e432, (_e432 > _e436));
                let _e442 = select(_e346.member_2[0][2], -(_e346.member_2[0][2]), (_e346.member_2[0][2] < 0f));
                let _e444 = select(_e442, _e438, (_e438 > _e442));
                let _e450 = select(_e346.member_2[1][0], -(_e346.member_2[1][0]), (_e346.member_2[1][0] < 0f));
                let _e454 = select(_e346.member_2[1][1], -(_e346.member_2[1][1]), (_e346.member_2[1][1] < 0f));
                let _e456 = select(_e454, _e450, (_e450 > _e454));
                let _e460 = select(_e346.member_2[1][2], -(_e346.member_2[1][2]), (_e346.member_2[1][2] < 0f));
                let _e462 = select(_e460, _e456, (_e456 > _e460));
                let _e467 = function_((select(_e382, _e364, (_e364 > _e382)) + _e346.member_3), (select(_e422, _e404, (_e404 > _e422)) + _e346.member_3));
                let _e468 = function_(_e467, (select(_e462, _e444, (_e444 > _e462)) + _e346.member_3));
                let _e473 = bitcast<i32>(((bitcast<u32>(_e468) + 4u) >> bitcast<u32>(23i)));
                let _e474 = (_e473 >= 64i);
                let _e475 = (_e473 <= 190i);
                let _e481 = select(select(i32(), select(i32(), (_e473 - 126i), _e475), _e474), 2147483647i, select(true, select(true, false, _e475), _e474));
                if (_e481 == 2147483647i) {
                    phi_6019_ = type_9(2u, type_9().member_1);
                } else {
                    let _e484 = params.member.member.member_1;
                    let _e486 = ((_e484 & 8u) != 0u);
                    let _e489 = params.member.member.member_10[1u];
                    let _e495 = select((_e481 - (bitcast<i32>((_e489 >> bitcast<u32>(20i))) - 1023i)), _e481, _e486);
                    phi_890_ = type_14(0i, 4i);
                    phi_893_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u)), array<type_9, 3>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u))));
                    phi_895_ = _e221.member_1;
                    loop {
                        let _e497 = phi_890_;
                        let _e499 = phi_893_;
                        let _e501 = phi_895_;
                        local_3 = _e499;
                        local_4 = _e499;
                        local_5 = _e499;
                        local_6 = _e499;
                        local_7 = _e499;
                        local_8 = _e499;
                        local_9 = _e499;
                        local_10 = _e499;
                        local_11 = _e499;
                        local_12 = _e499;
                        local_13 = _e499;
                        local_14 = _e499;
                        local_15 = _e499;
                        local_16 = _e499;
                        local_17 = _e499;
                        local_18 = _e499;
                        local_19 = _e499;
                        local_20 = _e499;
                        local_21 = _e499;
                        local_22 = _e499;
                        local_23 = _e499;
                        local_24 = _e499;
                        local_25 = _e499;
                        local_26 = _e499;
                        if (_e497.member < _e497.member_1) {
                            let _e508 = (_e497.member + 1i);
                            phi_891_ = type_14(select(_e508, type_15().member_1, select(false, true, ((false == (_e508 > _e497.member)) != false))), _e497.member_1);
                            phi_936_ = type_15(1u, _e497.member);
                        } else {
                            phi_891_ = _e497;
                            phi_936_ = type_15(0u, type_15().member_1);
                        }
                        let _e519 = phi_891_;
                        let _e521 = phi_936_;
                        let _e524 = (bitcast<i32>(_e521.member) != 0i);
                        if _e524 {
                            if _e486 {
                                let _e575 = paths.member[_e501[0]];
                                let _e588 = bitcast<u32>(_e575.member.x);
                                let _e589 = (_e588 & 2147483647u);
                                let _e590 = (_e589 < 8388608u);
                                let _e601 = bitcast<u32>(_e575.member.y);
                                let _e602 = (_e601 & 2147483647u);
                                let _e603 = (_e602 < 8388608u);
                                let _e614 = bitcast<u32>(_e575.member.z);
                                let _e615 = (_e614 & 2147483647u);
                                let _e616 = (_e615 < 8388608u);
                                let _e628 = bitcast<u32>(_e575.member_1.x);
                                let _e629 = (_e628 & 2147483647u);
                                let _e630 = (_e629 < 8388608u);
                                let _e641 = bitcast<u32>(_e575.member_1.y);
                                let _e642 = (_e641 & 2147483647u);
                                let _e643 = (_e642 < 8388608u);
                                let _e654 = bitcast<u32>(_e575.member_1.z);
                                let _e655 = (_e654 & 2147483647u);
                                let _e656 = (_e655 < 8388608u);
                                phi_1186_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e628 << bitcast<u32>(29i)), 0u, _e630), select(((_e628 ^ _e629) | ((_e629 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e630)), array<u32, 2>(select((_e641 << bitcast<u32>(29i)), 0u, _e643), select(((_e641 ^ _e642) | ((_e642 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e643)), array<u32, 2>(select((_e654 << bitcast<u32>(29i)), 0u, _e656), select(((_e654 ^ _e655) | ((_e655 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e656)));
                                phi_1187_ = array<array<u32, 2>, 3>(array<u32, 2>(select((_e588 << bitcast<u32>(29i)), 0u, _e590), select(((_e588 ^ _e589) | ((_e589 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e590)), array<u32, 2>(select((_e601 << bitcast<u32>(29i)), 0u, _e603), select(((_e601 ^ _e602) | ((_e602 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e603)), array<u32, 2>(select((_e614 << bitcast<u32>(29i)), 0u, _e616), select(((_e614 ^ _e615) | ((_e615 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e616)));
                            } else {
                                let _e528 = params.member.member.member[0u];
                                let _e530 = (6u * _e501[0]);
                                let _e532 = positions.member[_e530];
                                let _e535 = positions.member[(_e530 + 1u)];
                                let _e539 = positions.member[(_e530 + 2u)];
                                let _e542 = positions.member[(_e530 + 3u)];
                                let _e546 = positions.member[(_e530 + 4u)];
                                let _e549 = positions.member[(_e530 + 5u)];
                                let _e552 = (6u * (_e528 + _e501[0]));
                                let _e554 = positions.member[_e552];
                                let _e557 = positions.member[(_e552 + 1u)];
                                let _e561 = positions.member[(_e552 + 2u)];
                                let _e564 = positions.member[(_e552 + 3u)];
                                let _e568 = positions.member[(_e552 + 4u)];
                                let _e571 = positions.member[(_e552 + 5u)];
                                phi_1186_ = array<array<u32, 2>, 3>(array<u32, 2>(_e554, _e557), array<u32, 2>(_e561, _e564), array<u32, 2>(_e568, _e571));
                                phi_1187_ = array<array<u32, 2>, 3>(array<u32, 2>(_e532, _e535), array<u32, 2>(_e539, _e542), array<u32, 2>(_e546, _e549));
                            }
                            let _e669 = phi_1186_;
                            let _e671 = phi_1187_;
                            let _e678 = function_10(_e671[0], _e495);
                            let _e679 = function_10(_e671[1], _e495);
                            let _e680 = function_10(_e671[2], _e495);
                            let _e685 = function_10(_e669[0], _e495);
                            let _e686 = function_10(_e669[1], _e495);
                            let _e687 = function_10(_e669[2], _e495);
                            phi_894_ = array<array<array<type_9, 3>, 2>, 4>(_e499[1], _e499[2], _e499[3], array<array<type_9, 3>, 2>(array<type_9, 3>(_e678, _e679, _e680), array<type_9, 3>(_e685, _e686, _e687)));
                            phi_896_ = array<u32, 4>(_e501[1], _e501[2], _e501[3], _e501[0]);
                        } else {
                            phi_894_ = array<array<array<type_9, 3>, 2>, 4>();
                            phi_896_ = array<u32, 4>();
                        }
                        let _e697 = phi_894_;
                        let _e699 = phi_896_;
                        continue;
                        continuing {
                            phi_890_ = _e519;
                            phi_893_ = _e697;
                            phi_895_ = _e699;
                            break if !(_e524);
                        }
                    }
                    let _e702 = params.member.member_2.member_1;
                    let _e704 = params.member.member_2.member_2;
                    let _e706 = params.member.member_2.member_3;
                    if (_e221.member != 0u) {
                        let _e1019 = local_15;
                        let _e1023 = local_16;
                        let _e1070 = local_17;
                        let _e1074 = local_18;
                        let _e1122 = local_19;
                        let _e1126 = local_20;
                        let _e1173 = local_21;
                        let _e1177 = local_22;
                        let _e1225 = local_23;
                        let _e1229 = local_24;
                        let _e1276 = local_25;
                        let _e1280 = local_26;
                        phi_1780_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1019[2][0][0].member - _e1023[0][0][0].member) - select(0u, 1u, (_e1019[2][0][0].member_1 < _e1023[0][0][0].member_1))), (_e1019[2][0][0].member_1 - _e1023[0][0][0].member_1)), type_9(((_e1019[2][0][1].member - _e1023[0][0][1].member) - select(0u, 1u, (_e1019[2][0][1].member_1 < _e1023[0][0][1].member_1))), (_e1019[2][0][1].member_1 - _e1023[0][0][1].member_1)), type_9(((_e1019[2][0][2].member - _e1023[0][0][2].member) - select(0u, 1u, (_e1019[2][0][2].member_1 < _e1023[0][0][2].member_1))), (_e1019[2][0][2].member_1 - _e1023[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1070[2][1][0].member - _e1074[0][1][0].member) - select(0u, 1u, (_e1070[2][1][0].member_1 < _e1074[0][1][0].member_1))), (_e1070[2][1][0].member_1 - _e1074[0][1][0].member_1)), type_9(((_e1070[2][1][1].member - _e1074[0][1][1].member) - select(0u, 1u, (_e1070[2][1][1].member_1 < _e1074[0][1][1].member_1))), (_e1070[2][1][1].member_1 - _e1074[0][1][1].member_1)), type_9(((_e1070[2][1][2].member - _e1074[0][1][2].member) - select(0u, 1u, (_e1070[2][1][2].member_1 < _e1074[0][1][2].member_1))), (_e1070[2][1][2].member_1 - _e1074[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1122[1][0][0].member - _e1126[0][0][0].member) - select(0u, 1u, (_e1122[1][0][0].member_1 < _e1126[0][0][0].member_1))), (_e1122[1][0][0].member_1 - _e1126[0][0][0].member_1)), type_9(((_e1122[1][0][1].member - _e1126[0][0][1].member) - select(0u, 1u, (_e1122[1][0][1].member_1 < _e1126[0][0][1].member_1))), (_e1122[1][0][1].member_1 - _e1126[0][0][1].member_1)), type_9(((_e1122[1][0][2].member - _e1126[0][0][2].member) - select(0u, 1u, (_e1122[1][0][2].member_1 < _e1126[0][0][2].member_1))), (_e1122[1][0][2].member_1 - _e1126[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1173[1][1][0].member - _e1177[0][1][0].member) - select(0u, 1u, (_e1173[1][1][0].member_1 < _e1177[0][1][0].member_1))), (_e1173[1][1][0].member_1 - _e1177[0][1][0].member_1)), type_9(((_e1173[1][1][1].member - _e1177[0][1][1].member) - select(0u, 1u, (_e1173[1][1][1].member_1 < _e1177[0][1][1].member_1))), (_e1173[1][1][1].member_1 - _e1177[0][1][1].member_1)), type_9(((_e1173[1][1][2].member - _e1177[0][1][2].member) - select(0u, 1u, (_e1173[1][1][2].member_1 < _e1177[0][1][2].member_1))), (_e1173[1][1][2].member_1 - _e1177[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1225[2][0][0].member - _e1229[3][0][0].member) - select(0u, 1u, (_e1225[2][0][0].member_1 < _e1229[3][0][0].member_1))), (_e1225[2][0][0].member_1 - _e1229[3][0][0].member_1)), type_9(((_e1225[2][0][1].member - _e1229[3][0][1].member) - select(0u, 1u, (_e1225[2][0][1].member_1 < _e1229[3][0][1].member_1))), (_e1225[2][0][1].member_1 - _e1229[3][0][1].member_1)), type_9(((_e1225[2][0][2].member - _e1229[3][0][2].member) - select(0u, 1u, (_e1225[2][0][2].member_1 < _e1229[3][0][2].member_1))), (_e1225[2][0][2].member_1 - _e1229[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1276[2][1][0].member - _e1280[3][1][0].member) - select(0u, 1u, (_e1276[2][1][0].member_1 < _e1280[3][1][0].member_1))), (_e1276[2][1][0].member_1 - _e1280[3][1][0].member_1)), type_9(((_e1276[2][1][1].member - _e1280[3][1][1].member) - select(0u, 1u, (_e1276[2][1][1].member_1 < _e1280[3][1][1].member_1))), (_e1276[2][1][1].member_1 - _e1280[3][1][1].member_1)), type_9(((_e1276[2][1][2].member - _e1280[3][1][2].member) - select(0u, 1u, (_e1276[2][1][2].member_1 < _e1280[3][1][2].member_1))), (_e1276[2][1][2].member_1 - _e1280[3][1][2].member_1)))));
                    } else {
                        let _e709 = local_3;
                        let _e713 = local_4;
                        let _e760 = local_5;
                        let _e764 = local_6;
                        let _e812 = local_7;
                        let _e816 = local_8;
                        let _e863 = local_9;
                        let _e867 = local_10;
                        let _e915 = local_11;
                        let _e919 = local_12;
                        let _e966 = local_13;
                        let _e970 = local_14;
                        phi_1780_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e709[0][0][0].member - _e713[1][0][0].member) - select(0u, 1u, (_e709[0][0][0].member_1 < _e713[1][0][0].member_1))), (_e709[0][0][0].member_1 - _e713[1][0][0].member_1)), type_9(((_e709[0][0][1].member - _e713[1][0][1].member) - select(0u, 1u, (_e709[0][0][1].member_1 < _e713[1][0][1].member_1))), (_e709[0][0][1].member_1 - _e713[1][0][1].member_1)), type_9(((_e709[0][0][2].member - _e713[1][0][2].member) - select(0u, 1u, (_e709[0][0][2].member_1 < _e713[1][0][2].member_1))), (_e709[0][0][2].member_1 - _e713[1][0][2].member_1))), array<type_9, 3>(type_9(((_e760[0][1][0].member - _e764[1][1][0].member) - select(0u, 1u, (_e760[0][1][0].member_1 < _e764[1][1][0].member_1))), (_e760[0][1][0].member_1 - _e764[1][1][0].member_1)), type_9(((_e760[0][1][1].member - _e764[1][1][1].member) - select(0u, 1u, (_e760[0][1][1].member_1 < _e764[1][1][1].member_1))), (_e760[0][1][1].member_1 - _e764[1][1][1].member_1)), type_9(((_e760[0][1][2].member - _e764[1][1][2].member) - select(0u, 1u, (_e760[0][1][2].member_1 < _e764[1][1][2].member_1))), (_e760[0][1][2].member_1 - _e764[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e812[2][0][0].member - _e816[1][0][0].member) - select(0u, 1u, (_e812[2][0][0].member_1 < _e816[1][0][0].member_1))), (_e812[2][0][0].member_1 - _e816[1][0][0].member_1)), type_9(((_e812[2][0][1].member - _e816[1][0][1].member) - select(0u, 1u, (_e812[2][0][1].member_1 < _e816[1][0][1].member_1))), (_e812[2][0][1].member_1 - _e816[1][0][1].member_1)), type_9(((_e812[2][0][2].member - _e816[1][0][2].member) - select(0u, 1u, (_e812[2][0][2].member_1 < _e816[1][0][2].member_1))), (_e812[2][0][2].member_1 - _e816[1][0][2].member_1))), array<type_9, 3>(type_9(((_e863[2][1][0].member - _e867[1][1][0].member) - select(0u, 1u, (_e863[2][1][0].member_1 < _e867[1][1][0].member_1))), (_e863[2][1][0].member_1 - _e867[1][1][0].member_1)), type_9(((_e863[2][1][1].member - _e867[1][1][1].member) - select(0u, 1u, (_e863[2][1][1].member_1 < _e867[1][1][1].member_1))), (_e863[2][1][1].member_1 - _e867[1][1][1].member_1)), type_9(((_e863[2][1][2].member - _e867[1][1][2].member) - select(0u, 1u, (_e863[2][1][2].member_1 < _e867[1][1][2].member_1))), (_e863[2][1][2].member_1 - _e867[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e915[3][0][0].member - _e919[1][0][0].member) - select(0u, 1u, (_e915[3][0][0].member_1 < _e919[1][0][0].member_1))), (_e915[3][0][0].member_1 - _e919[1][0][0].member_1)), type_9(((_e915[3][0][1].member - _e919[1][0][1].member) - select(0u, 1u, (_e915[3][0][1].member_1 < _e919[1][0][1].member_1))), (_e915[3][0][1].member_1 - _e919[1][0][1].member_1)), type_9(((_e915[3][0][2].member - _e919[1][0][2].member) - select(0u, 1u, (_e915[3][0][2].member_1 < _e919[1][0][2].member_1))), (_e915[3][0][2].member_1 - _e919[1][0][2].member_1))), array<type_9, 3>(type_9(((_e966[3][1][0].member - _e970[1][1][0].member) - select(0u, 1u, (_e966[3][1][0].member_1 < _e970[1][1][0].member_1))), (_e966[3][1][0].member_1 - _e970[1][1][0].member_1)), type_9(((_e966[3][1][1].member - _e970[1][1][1].member) - select(0u, 1u, (_e966[3][1][1].member_1 < _e970[1][1][1].member_1))), (_e966[3][1][1].member_1 - _e970[1][1][1].member_1)), type_9(((_e966[3][1][2].member - _e970[1][1][2].member) - select(0u, 1u, (_e966[3][1][2].member_1 < _e970[1][1][2].member_1))), (_e966[3][1][2].member_1 - _e970[1][1][2].member_1)))));
                    }
                    let _e1329 = phi_1780_;
                    phi_1794_ = type_14(0i, 3i);
                    phi_1797_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                    phi_1799_ = _e1329[2];
                    phi_1801_ = _e1329[1];
                    phi_1803_ = _e1329[0];
                    loop {
                        let _e1334 = phi_1794_;
                        let _e1336 = phi_1797_;
                        let _e1338 = phi_1799_;
                        let _e1340 = phi_1801_;
                        let _e1342 = phi_1803_;
                        local_27 = _e1336;
                        local_28 = _e1336;
                        local_29 = _e1336;
                        local_30 = _e1336;
                        local_31 = _e1336;
                        local_32 = _e1336;
                        local_33 = _e1336;
                        local_34 = _e1336;
                        local_35 = _e1336;
                        local_36 = _e1336;
                        if (_e1334.member < _e1334.member_1) {
                            let _e1349 = (_e1334.member + 1i);
                            phi_1795_ = type_14(select(_e1349, type_15().member_1, select(false, true, ((false == (_e1349 > _e1334.member)) != false))), _e1334.member_1);
                            phi_1844_ = type_15(1u, _e1334.member);
                        } else {
                            phi_1795_ = _e1334;
                            phi_1844_ = type_15(0u, type_15().member_1);
                        }
                        let _e1360 = phi_1795_;
                        let _e1362 = phi_1844_;
                        let _e1365 = (bitcast<i32>(_e1362.member) != 0i);
                        if _e1365 {
                            let _e1376 = function_4(_e1340[0][1].member, _e1340[0][1].member_1, _e1338[0][2].member, _e1338[0][2].member_1);
                            let _e1387 = function_4(_e1340[0][2].member, _e1340[0][2].member_1, _e1338[0][1].member, _e1338[0][1].member_1);
                            let _e1393 = ((_e1376.member - _e1387.member) - select(0u, 1u, (_e1376.member_1 < _e1387.member_1)));
                            let _e1394 = (_e1376.member_1 - _e1387.member_1);
                            let _e1405 = function_4(_e1340[1][1].member, _e1340[1][1].member_1, _e1338[1][2].member, _e1338[1][2].member_1);
                            let _e1416 = function_4(_e1340[1][2].member, _e1340[1][2].member_1, _e1338[1][1].member, _e1338[1][1].member_1);
                            let _e1422 = ((_e1405.member - _e1416.member) - select(0u, 1u, (_e1405.member_1 < _e1416.member_1)));
                            let _e1423 = (_e1405.member_1 - _e1416.member_1);
                            let _e1434 = function_4(_e1340[0][1].member, _e1340[0][1].member_1, _e1338[1][2].member, _e1338[1][2].member_1);
                            let _e1445 = function_4(_e1340[0][2].member, _e1340[0][2].member_1, _e1338[1][1].member, _e1338[1][1].member_1);
                            let _e1452 = (_e1434.member_1 - _e1445.member_1);
                            let _e1463 = function_4(_e1340[1][1].member, _e1340[1][1].member_1, _e1338[0][2].member, _e1338[0][2].member_1);
                            let _e1474 = function_4(_e1340[1][2].member, _e1340[1][2].member_1, _e1338[0][1].member, _e1338[0][1].member_1);
                            let _e1482 = (_e1452 + (_e1463.member_1 - _e1474.member_1));
                            let _e1486 = ((((_e1434.member - _e1445.member) - select(0u, 1u, (_e1434.member_1 < _e1445.member_1))) + ((_e1463.member - _e1474.member) - select(0u, 1u, (_e1463.member_1 < _e1474.member_1)))) + select(0u, 1u, (_e1482 < _e1452)));
                            let _e1503 = function_4(_e1342[0][0].member, _e1342[0][0].member_1, _e1393, _e1394);
                            let _e1506 = (_e1336[0].member_1 + _e1503.member_1);
                            let _e1516 = function_4(_e1342[1][0].member, _e1342[1][0].member_1, _e1393, _e1394);
                            let _e1519 = (_e1336[1].member_1 + _e1516.member_1);
                            let _e1524 = function_4(_e1342[0][0].member, _e1342[0][0].member_1, _e1486, _e1482);
                            let _e1527 = (_e1519 + _e1524.member_1);
                            let _e1537 = function_4(_e1342[0][0].member, _e1342[0][0].member_1, _e1422, _e1423);
                            let _e1540 = (_e1336[2].member_1 + _e1537.member_1);
                            let _e1545 = function_4(_e1342[1][0].member, _e1342[1][0].member_1, _e1486, _e1482);
                            let _e1548 = (_e1540 + _e1545.member_1);
                            let _e1558 = function_4(_e1342[1][0].member, _e1342[1][0].member_1, _e1422, _e1423);
                            let _e1561 = (_e1336[3].member_1 + _e1558.member_1);
                            phi_1798_ = array<type_9, 4>(type_9(((_e1336[0].member + _e1503.member) + select(0u, 1u, (_e1506 < _e1336[0].member_1))), _e1506), type_9(((((_e1336[1].member + _e1516.member) + select(0u, 1u, (_e1519 < _e1336[1].member_1))) + _e1524.member) + select(0u, 1u, (_e1527 < _e1519))), _e1527), type_9(((((_e1336[2].member + _e1537.member) + select(0u, 1u, (_e1540 < _e1336[2].member_1))) + _e1545.member) + select(0u, 1u, (_e1548 < _e1540))), _e1548), type_9(((_e1336[3].member + _e1558.member) + select(0u, 1u, (_e1561 < _e1336[3].member_1))), _e1561));
                            phi_1800_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1338[0][1], _e1338[0][2], _e1338[0][0]), array<type_9, 3>(_e1338[1][1], _e1338[1][2], _e1338[1][0]));
                            phi_1802_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1340[0][1], _e1340[0][2], _e1340[0][0]), array<type_9, 3>(_e1340[1][1], _e1340[1][2], _e1340[1][0]));
                            phi_1804_ = array<array<type_9, 3>, 2>(array<type_9, 3>(_e1342[0][1], _e1342[0][2], _e1342[0][0]), array<type_9, 3>(_e1342[1][1], _e1342[1][2], _e1342[1][0]));
                        } else {
                            phi_1798_ = array<type_9, 4>();
                            phi_1800_ = array<array<type_9, 3>, 2>();
                            phi_1802_ = array<array<type_9, 3>, 2>();
                            phi_1804_ = array<array<type_9, 3>, 2>();
                        }
                        let _e1602 = phi_1798_;
                        let _e1604 = phi_1800_;
                        let _e1606 = phi_1802_;
                        let _e1608 = phi_1804_;
                        continue;
                        continuing {
                            phi_1794_ = _e1360;
                            phi_1797_ = _e1602;
                            phi_1799_ = _e1604;
                            phi_1801_ = _e1606;
                            phi_1803_ = _e1608;
                            break if !(_e1365);
                        }
                    }
                    let _e1611 = local_27;
                    let _e1615 = local_28;
                    let _e1618 = function_9(_e1611[0].member, _e1615[0].member_1);
                    let _e1622 = local_29;
                    let _e1626 = local_30;
                    let _e1630 = local_31;
                    let _e1634 = local_32;
                    let _e1638 = local_33;
                    let _e1642 = local_34;
                    let _e1645 = function_9(_e1638[3].member, _e1642[3].member_1);
                    let _e1649 = local_35;
                    let _e1652 = local_36;
                    let _e1659 = select((bitcast<u32>(31i) - firstLeadingBit(_e706)), 32u, (_e706 == 0u));
                    let _e1661 = select(18u, _e1659, (18u < _e1659));
                    phi_2155_ = array<type_9, 4>(_e1618, _e1649[1], _e1652[2], _e1645);
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
                        let _e1663 = phi_2155_;
                        let _e1665 = phi_2158_;
                        let _e1667 = phi_2160_;
                        let _e1669 = phi_2162_;
                        let _e1671 = phi_2164_;
                        let _e1673 = phi_2166_;
                        let _e1675 = phi_2170_;
                        let _e1677 = phi_2172_;
                        let _e1679 = phi_2174_;
                        let _e1681 = phi_2176_;
                        let _e1683 = phi_2178_;
                        if (_e1679 < 64u) {
                            phi_2187_ = _e1663;
                            phi_2190_ = _e1669;
                            phi_2192_ = _e1671;
                            phi_2196_ = _e1665;
                            phi_2198_ = false;
                            phi_2200_ = false;
                            phi_2202_ = false;
                            phi_2204_ = _e1675;
                            phi_2206_ = _e1677;
                            phi_2208_ = _e1679;
                            phi_2210_ = _e1681;
                            phi_2212_ = _e1683;
                            loop {
                                let _e1686 = phi_2187_;
                                let _e1688 = phi_2190_;
                                let _e1690 = phi_2192_;
                                let _e1692 = phi_2196_;
                                let _e1694 = phi_2198_;
                                let _e1696 = phi_2200_;
                                let _e1698 = phi_2202_;
                                let _e1700 = phi_2204_;
                                let _e1702 = phi_2206_;
                                let _e1704 = phi_2208_;
                                let _e1706 = phi_2210_;
                                let _e1708 = phi_2212_;
                                local_37 = _e1692;
                                local_38 = _e1698;
                                local_39 = _e1686;
                                local_40 = _e1686;
                                local_41 = _e1686;
                                local_42 = _e1686;
                                local_43 = _e1686;
                                local_44 = _e1686;
                                local_45 = _e1686;
                                local_46 = _e1686;
                                local_47 = _e1686;
                                local_48 = _e1686;
                                local_49 = _e1686;
                                local_50 = _e1686;
                                local_51 = _e1706;
                                local_52 = _e1702;
                                local_53 = _e1700;
                                local_54 = _e1706;
                                local_55 = _e1686;
                                local_56 = _e1686;
                                local_57 = _e1686;
                                local_58 = _e1686;
                                local_59 = _e1686;
                                local_60 = _e1686;
                                local_61 = _e1706;
                                local_62 = _e1696;
                                local_63 = _e1694;
                                local_64 = _e1694;
                                local_65 = _e1706;
                                local_66 = _e1686;
                                local_67 = _e1686;
                                local_68 = _e1686;
                                local_69 = _e1694;
                                local_70 = _e1694;
                                local_71 = _e1702;
                                local_72 = _e1702;
                                local_73 = _e1702;
                                local_74 = _e1700;
                                local_75 = _e1686;
                                local_76 = _e1686;
                                local_77 = _e1686;
                                local_78 = _e1686;
                                local_79 = _e1686;
                                local_80 = _e1686;
                                local_81 = _e1686;
                                local_82 = _e1686;
                                local_85 = _e1702;
                                local_86 = _e1702;
                                local_87 = _e1686;
                                local_88 = _e1686;
                                local_89 = _e1686;
                                local_91 = _e1694;
                                local_113 = _e1698;
                                local_114 = _e1688;
                                local_115 = _e1690;
                                local_116 = _e1698;
                                local_117 = _e1688;
                                local_118 = _e1690;
                                local_119 = _e1698;
                                local_92 = _e1708;
                                local_93 = _e1708;
                                local_94 = _e1706;
                                local_95 = _e1706;
                                local_96 = _e1706;
                                local_97 = _e1702;
                                local_120 = _e1706;
                                local_121 = _e1708;
                                local_123 = _e1686;
                                local_124 = _e1700;
                                local_125 = _e1702;
                                local_126 = _e1704;
                                if (_e1704 < 64u) {
                                    if _e1698 {
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
                                        if _e1692 {
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
                                            let _e1711 = (31u - _e1706);
                                            let _e1714 = (_e1708 << bitcast<u32>((_e1711 & 31u)));
                                            let _e1718 = ((_e1708 + 1u) << bitcast<u32>((_e1711 & 31u)));
                                            if (_e1714 > _e704) {
                                                phi_2418_ = bool();
                                                phi_2419_ = true;
                                            } else {
                                                let _e1720 = (_e1718 < _e702);
                                                if _e1720 {
                                                    phi_2417_ = bool();
                                                } else {
                                                    let _e1725 = function_8(128u);
                                                    let _e1730 = ((_e1686[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1758 = function_8(128u);
                                                    let _e1763 = ((_e1686[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1792 = function_8(128u);
                                                    let _e1797 = ((_e1686[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e1826 = function_8(128u);
                                                    let _e1831 = ((_e1686[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_2417_ = ((((select(0u, select(1u, 2u, ((_e1686[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e1725.member - select(_e1686[0].member, (~(_e1686[0].member) + select(0u, 1u, (_e1686[0].member_1 == 0u))), _e1730)) - select(0u, 1u, (_e1725.member_1 < select(_e1686[0].member_1, (~(_e1686[0].member_1) + 1u), _e1730)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e1686[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1758.member - select(_e1686[1].member, (~(_e1686[1].member) + select(0u, 1u, (_e1686[1].member_1 == 0u))), _e1763)) - select(0u, 1u, (_e1758.member_1 < select(_e1686[1].member_1, (~(_e1686[1].member_1) + 1u), _e1763)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e1686[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1792.member - select(_e1686[2].member, (~(_e1686[2].member) + select(0u, 1u, (_e1686[2].member_1 == 0u))), _e1797)) - select(0u, 1u, (_e1792.member_1 < select(_e1686[2].member_1, (~(_e1686[2].member_1) + 1u), _e1797)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e1686[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e1826.member - select(_e1686[3].member, (~(_e1686[3].member) + select(0u, 1u, (_e1686[3].member_1 == 0u))), _e1831)) - select(0u, 1u, (_e1826.member_1 < select(_e1686[3].member_1, (~(_e1686[3].member_1) + 1u), _e1831)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e1858 = phi_2417_;
                                                phi_2418_ = _e1858;
                                                phi_2419_ = _e1720;
                                            }
                                            let _e1860 = phi_2418_;
                                            let _e1862 = phi_2419_;
                                            let _e1863 = select(_e1860, true, _e1862);
                                            let _e1868 = function_8(128u);
                                            let _e1873 = ((_e1686[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1896 = select(0u, select(1u, 2u, ((_e1686[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e1868.member - select(_e1686[0].member, (~(_e1686[0].member) + select(0u, 1u, (_e1686[0].member_1 == 0u))), _e1873)) - select(0u, 1u, (_e1868.member_1 < select(_e1686[0].member_1, (~(_e1686[0].member_1) + 1u), _e1873)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1901 = function_8(128u);
                                            let _e1906 = ((_e1686[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1929 = select(0u, select(1u, 2u, ((_e1686[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e1901.member - select(_e1686[1].member, (~(_e1686[1].member) + select(0u, 1u, (_e1686[1].member_1 == 0u))), _e1906)) - select(0u, 1u, (_e1901.member_1 < select(_e1686[1].member_1, (~(_e1686[1].member_1) + 1u), _e1906)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1934 = function_8(128u);
                                            let _e1939 = ((_e1686[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1962 = select(0u, select(1u, 2u, ((_e1686[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e1934.member - select(_e1686[2].member, (~(_e1686[2].member) + select(0u, 1u, (_e1686[2].member_1 == 0u))), _e1939)) - select(0u, 1u, (_e1934.member_1 < select(_e1686[2].member_1, (~(_e1686[2].member_1) + 1u), _e1939)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e1967 = function_8(128u);
                                            let _e1972 = ((_e1686[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e1995 = select(0u, select(1u, 2u, ((_e1686[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e1967.member - select(_e1686[3].member, (~(_e1686[3].member) + select(0u, 1u, (_e1686[3].member_1 == 0u))), _e1972)) - select(0u, 1u, (_e1967.member_1 < select(_e1686[3].member_1, (~(_e1686[3].member_1) + 1u), _e1972)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e2005 = select(false, select(true, select(false, (_e1929 != 0u), (_e1962 == _e1995)), select(true, (_e1962 == 0u), (_e1929 == _e1896))), ((_e1896 | _e1995) == 3u));
                                            let _e2010 = function_8(128u);
                                            let _e2015 = ((_e1686[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e2041 = select(false, (_e1714 >= _e702), (select(0u, select(1u, 2u, ((_e1686[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2010.member - select(_e1686[0].member, (~(_e1686[0].member) + select(0u, 1u, (_e1686[0].member_1 == 0u))), _e2015)) - select(0u, 1u, (_e2010.member_1 < select(_e1686[0].member_1, (~(_e1686[0].member_1) + 1u), _e2015)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e2042 = (_e1706 == 3u);
                                            let _e2043 = (_e1706 == 8u);
                                            let _e2048 = select(select(select((_e1706 == 14u), bool(), _e2043), bool(), _e2042), true, select(_e2043, true, _e2042));
                                            let _e2050 = select(false, !(_e1688), _e2041);
                                            let _e2051 = (_e1706 == 31u);
                                            let _e2062 = select(select(false, !(_e1690), select(select(select(select(select(false, !(_e1667), _e2005), bool(), _e2041), bool(), _e2048), bool(), _e2051), true, select(select(_e2041, true, _e2048), true, _e2051))), true, _e2050);
                                            if _e1863 {
                                                phi_3070_ = _e1686;
                                                phi_3071_ = _e1688;
                                                phi_3072_ = _e1690;
                                                phi_3074_ = _e1706;
                                                phi_3075_ = _e1708;
                                            } else {
                                                if _e2062 {
                                                    phi_3064_ = _e1686;
                                                    phi_3065_ = _e1688;
                                                    phi_3066_ = _e1690;
                                                    phi_3068_ = _e1706;
                                                    phi_3069_ = _e1708;
                                                } else {
                                                    let _e2071 = (_e1686[0].member_1 + _e1686[1].member_1);
                                                    let _e2075 = ((_e1686[0].member + _e1686[1].member) + select(0u, 1u, (_e2071 < _e1686[0].member_1)));
                                                    let _e2083 = bitcast<u32>((bitcast<i32>(_e2075) >> bitcast<u32>(1u)));
                                                    let _e2086 = ((_e2071 >> bitcast<u32>(1u)) | ((_e2075 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2095 = (_e1686[1].member_1 + _e1686[2].member_1);
                                                    let _e2099 = ((_e1686[1].member + _e1686[2].member) + select(0u, 1u, (_e2095 < _e1686[1].member_1)));
                                                    let _e2107 = bitcast<u32>((bitcast<i32>(_e2099) >> bitcast<u32>(1u)));
                                                    let _e2110 = ((_e2095 >> bitcast<u32>(1u)) | ((_e2099 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2119 = (_e1686[2].member_1 + _e1686[3].member_1);
                                                    let _e2123 = ((_e1686[2].member + _e1686[3].member) + select(0u, 1u, (_e2119 < _e1686[2].member_1)));
                                                    let _e2131 = bitcast<u32>((bitcast<i32>(_e2123) >> bitcast<u32>(1u)));
                                                    let _e2134 = ((_e2119 >> bitcast<u32>(1u)) | ((_e2123 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2135 = (_e2086 + _e2110);
                                                    let _e2139 = ((_e2083 + _e2107) + select(0u, 1u, (_e2135 < _e2086)));
                                                    let _e2147 = bitcast<u32>((bitcast<i32>(_e2139) >> bitcast<u32>(1u)));
                                                    let _e2150 = ((_e2135 >> bitcast<u32>(1u)) | ((_e2139 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2151 = (_e2110 + _e2134);
                                                    let _e2155 = ((_e2107 + _e2131) + select(0u, 1u, (_e2151 < _e2110)));
                                                    let _e2163 = bitcast<u32>((bitcast<i32>(_e2155) >> bitcast<u32>(1u)));
                                                    let _e2166 = ((_e2151 >> bitcast<u32>(1u)) | ((_e2155 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2167 = (_e2150 + _e2166);
                                                    let _e2171 = ((_e2147 + _e2163) + select(0u, 1u, (_e2167 < _e2150)));
                                                    let _e2179 = bitcast<u32>((bitcast<i32>(_e2171) >> bitcast<u32>(1u)));
                                                    let _e2182 = ((_e2167 >> bitcast<u32>(1u)) | ((_e2171 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e2183 = (2u * _e1708);
                                                    let _e2194 = function_8(128u);
                                                    let _e2199 = ((_e1686[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2223 = function_8(128u);
                                                    let _e2228 = ((_e2083 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2250 = function_8(128u);
                                                    let _e2255 = ((_e2147 >> bitcast<u32>(31i)) != 0u);
                                                    let _e2277 = function_8(128u);
                                                    let _e2282 = ((_e2179 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e1686[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2194.member - select(_e1686[0].member, (~(_e1686[0].member) + select(0u, 1u, (_e1686[0].member_1 == 0u))), _e2199)) - select(0u, 1u, (_e2194.member_1 < select(_e1686[0].member_1, (~(_e1686[0].member_1) + 1u), _e2199)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2083 >> bitcast<u32>(31i)) != 0u)), ((((_e2223.member - select(_e2083, (~(_e2083) + select(0u, 1u, (_e2086 == 0u))), _e2228)) - select(0u, 1u, (_e2223.member_1 < select(_e2086, (~(_e2086) + 1u), _e2228)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2147 >> bitcast<u32>(31i)) != 0u)), ((((_e2250.member - select(_e2147, (~(_e2147) + select(0u, 1u, (_e2150 == 0u))), _e2255)) - select(0u, 1u, (_e2250.member_1 < select(_e2150, (~(_e2150) + 1u), _e2255)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2179 >> bitcast<u32>(31i)) != 0u)), ((((_e2277.member - select(_e2179, (~(_e2179) + select(0u, 1u, (_e2182 == 0u))), _e2282)) - select(0u, 1u, (_e2277.member_1 < select(_e2182, (~(_e2182) + 1u), _e2282)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_3061_ = array<type_9, 4>(type_9(_e2179, _e2182), type_9(_e2163, _e2166), type_9(_e2131, _e2134), _e1686[3]);
                                                        phi_3062_ = false;
                                                        phi_3063_ = (_e2183 + 1u);
                                                    } else {
                                                        phi_3061_ = array<type_9, 4>(_e1686[0], type_9(_e2083, _e2086), type_9(_e2147, _e2150), type_9(_e2179, _e2182));
                                                        phi_3062_ = _e1688;
                                                        phi_3063_ = _e2183;
                                                    }
                                                    let _e2312 = phi_3061_;
                                                    let _e2314 = phi_3062_;
                                                    let _e2316 = phi_3063_;
                                                    phi_3064_ = _e2312;
                                                    phi_3065_ = _e2314;
                                                    phi_3066_ = false;
                                                    phi_3068_ = (_e1706 + 1u);
                                                    phi_3069_ = _e2316;
                                                }
                                                let _e2318 = phi_3064_;
                                                let _e2320 = phi_3065_;
                                                let _e2322 = phi_3066_;
                                                let _e2324 = phi_3068_;
                                                let _e2326 = phi_3069_;
                                                phi_3070_ = _e2318;
                                                phi_3071_ = _e2320;
                                                phi_3072_ = _e2322;
                                                phi_3074_ = _e2324;
                                                phi_3075_ = _e2326;
                                            }
                                            let _e2328 = phi_3070_;
                                            let _e2330 = phi_3071_;
                                            let _e2332 = phi_3072_;
                                            let _e2334 = phi_3074_;
                                            let _e2336 = phi_3075_;
                                            phi_3076_ = _e2328;
                                            phi_3077_ = _e2330;
                                            phi_3078_ = _e2332;
                                            phi_3080_ = _e2062;
                                            phi_3081_ = _e2050;
                                            phi_3082_ = _e2005;
                                            phi_3083_ = _e1863;
                                            phi_3084_ = _e1718;
                                            phi_3085_ = _e1714;
                                            phi_3086_ = (_e1704 + 1u);
                                            phi_3087_ = _e2334;
                                            phi_3088_ = _e2336;
                                            phi_3089_ = true;
                                        }
                                        let _e2338 = phi_3076_;
                                        let _e2340 = phi_3077_;
                                        let _e2342 = phi_3078_;
                                        let _e2344 = phi_3080_;
                                        let _e2346 = phi_3081_;
                                        let _e2348 = phi_3082_;
                                        let _e2350 = phi_3083_;
                                        let _e2352 = phi_3084_;
                                        let _e2354 = phi_3085_;
                                        let _e2356 = phi_3086_;
                                        let _e2358 = phi_3087_;
                                        let _e2360 = phi_3088_;
                                        let _e2362 = phi_3089_;
                                        phi_3090_ = _e2338;
                                        phi_3091_ = _e2340;
                                        phi_3092_ = _e2342;
                                        phi_3094_ = _e2344;
                                        phi_3095_ = _e2346;
                                        phi_3096_ = _e2348;
                                        phi_3097_ = _e2350;
                                        phi_3098_ = _e2352;
                                        phi_3099_ = _e2354;
                                        phi_3100_ = _e2356;
                                        phi_3101_ = _e2358;
                                        phi_3102_ = _e2360;
                                        phi_3103_ = _e2362;
                                    }
                                    let _e2364 = phi_3090_;
                                    let _e2366 = phi_3091_;
                                    let _e2368 = phi_3092_;
                                    let _e2370 = phi_3094_;
                                    let _e2372 = phi_3095_;
                                    let _e2374 = phi_3096_;
                                    let _e2376 = phi_3097_;
                                    let _e2378 = phi_3098_;
                                    let _e2380 = phi_3099_;
                                    let _e2382 = phi_3100_;
                                    let _e2384 = phi_3101_;
                                    let _e2386 = phi_3102_;
                                    let _e2388 = phi_3103_;
                                    phi_2188_ = _e2364;
                                    phi_2191_ = _e2366;
                                    phi_2193_ = _e2368;
                                    phi_2197_ = _e2370;
                                    phi_2199_ = _e2372;
                                    phi_2201_ = _e2374;
                                    phi_2203_ = _e2376;
                                    phi_2205_ = _e2378;
                                    phi_2207_ = _e2380;
                                    phi_2209_ = _e2382;
                                    phi_2211_ = _e2384;
                                    phi_2213_ = _e2386;
                                    phi_3104_ = _e2388;
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
                                let _e2390 = phi_2188_;
                                let _e2392 = phi_2191_;
                                let _e2394 = phi_2193_;
                                let _e2396 = phi_2197_;
                                let _e2398 = phi_2199_;
                                let _e2400 = phi_2201_;
                                let _e2402 = phi_2203_;
                                let _e2404 = phi_2205_;
                                let _e2406 = phi_2207_;
                                let _e2408 = phi_2209_;
                                let _e2410 = phi_2211_;
                                let _e2412 = phi_2213_;
                                let _e2414 = phi_3104_;
                                continue;
                                continuing {
                                    phi_2187_ = _e2390;
                                    phi_2190_ = _e2392;
                                    phi_2192_ = _e2394;
                                    phi_2196_ = _e2396;
                                    phi_2198_ = _e2398;
                                    phi_2200_ = _e2400;
                                    phi_2202_ = _e2402;
                                    phi_2204_ = _e2404;
                                    phi_2206_ = _e2406;
                                    phi_2208_ = _e2408;
                                    phi_2210_ = _e2410;
                                    phi_2212_ = _e2412;
                                    break if !(_e2414);
                                }
                            }
                            let _e2417 = local_37;
                            if _e2417 {
                                let _e2419 = local_38;
                                if _e2419 {
                                    phi_5601_ = _e1665;
                                    phi_5602_ = _e1667;
                                    let _e5047 = local_114;
                                    phi_5603_ = _e5047;
                                    let _e5050 = local_115;
                                    phi_5604_ = _e5050;
                                    phi_5605_ = _e1673;
                                    let _e5054 = local_116;
                                    phi_5606_ = _e5054;
                                    phi_5607_ = bool();
                                    phi_5608_ = type_17();
                                    phi_5609_ = true;
                                    phi_5610_ = false;
                                    phi_5611_ = false;
                                    phi_5612_ = false;
                                } else {
                                    let _e2421 = local_39;
                                    let _e2425 = local_40;
                                    let _e2428 = function_8(128u);
                                    let _e2433 = ((_e2421[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2441 = local_41;
                                    let _e2460 = local_42;
                                    let _e2464 = local_43;
                                    let _e2467 = function_8(128u);
                                    let _e2472 = ((_e2460[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2480 = local_44;
                                    let _e2500 = local_45;
                                    let _e2504 = local_46;
                                    let _e2507 = function_8(128u);
                                    let _e2512 = ((_e2500[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2520 = local_47;
                                    let _e2540 = local_48;
                                    let _e2544 = local_49;
                                    let _e2547 = function_8(128u);
                                    let _e2552 = ((_e2540[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2560 = local_50;
                                    let _e2581 = local_51;
                                    let _e2586 = local_52;
                                    let _e2588 = local_53;
                                    let _e2590 = local_54;
                                    let _e2591 = type_17(_e2586, _e2588, _e2590);
                                    let _e2593 = local_55;
                                    let _e2597 = local_56;
                                    let _e2600 = function_8(128u);
                                    let _e2605 = ((_e2593[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2613 = local_57;
                                    let _e2632 = local_58;
                                    let _e2636 = local_59;
                                    let _e2639 = function_8(128u);
                                    let _e2644 = ((_e2632[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e2652 = local_60;
                                    let _e2671 = ((select(0u, select(1u, 2u, ((_e2593[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2600.member - select(_e2613[0].member, (~(_e2593[0].member) + select(0u, 1u, (_e2597[0].member_1 == 0u))), _e2605)) - select(0u, 1u, (_e2600.member_1 < select(_e2613[0].member_1, (~(_e2597[0].member_1) + 1u), _e2605)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2632[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2639.member - select(_e2652[3].member, (~(_e2632[3].member) + select(0u, 1u, (_e2636[3].member_1 == 0u))), _e2644)) - select(0u, 1u, (_e2639.member_1 < select(_e2652[3].member_1, (~(_e2636[3].member_1) + 1u), _e2644)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e2673 = local_61;
                                    let _e2676 = local_62;
                                    let _e2680 = local_63;
                                    let _e2681 = select(select(select(false, (_e2673 < _e1661), _e2676), true, _e1665), false, _e2680);
                                    let _e2683 = local_64;
                                    if _e2683 {
                                        phi_3463_ = bool();
                                        phi_3464_ = true;
                                    } else {
                                        if _e2681 {
                                            phi_3461_ = bool();
                                            phi_3462_ = true;
                                        } else {
                                            let _e2685 = local_65;
                                            if (_e2685 == 31u) {
                                                if _e2671 {
                                                    phi_3458_ = bool();
                                                } else {
                                                    let _e2688 = local_66;
                                                    let _e2692 = local_67;
                                                    let _e2695 = function_8(128u);
                                                    let _e2700 = ((_e2688[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2708 = local_68;
                                                    phi_3458_ = (select(0u, select(1u, 2u, ((_e2688[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2695.member - select(_e2708[0].member, (~(_e2688[0].member) + select(0u, 1u, (_e2692[0].member_1 == 0u))), _e2700)) - select(0u, 1u, (_e2695.member_1 < select(_e2708[0].member_1, (~(_e2692[0].member_1) + 1u), _e2700)))) >> bitcast<u32>(31i)) != 0u)) != 0u);
                                                }
                                                let _e2728 = phi_3458_;
                                                phi_3459_ = _e2728;
                                                phi_3460_ = _e2671;
                                            } else {
                                                phi_3459_ = bool();
                                                phi_3460_ = true;
                                            }
                                            let _e2730 = phi_3459_;
                                            let _e2732 = phi_3460_;
                                            phi_3461_ = _e2730;
                                            phi_3462_ = _e2732;
                                        }
                                        let _e2734 = phi_3461_;
                                        let _e2736 = phi_3462_;
                                        phi_3463_ = _e2734;
                                        phi_3464_ = _e2736;
                                    }
                                    let _e2738 = phi_3463_;
                                    let _e2740 = phi_3464_;
                                    let _e2741 = select(_e2738, false, _e2740);
                                    let _e2743 = local_69;
                                    let _e2746 = local_70;
                                    if _e2746 {
                                        let _e2924 = local_85;
                                        let _e2927 = local_86;
                                        phi_3664_ = _e1667;
                                        phi_3665_ = type_17(_e2927, (_e2924 + 1u), 31u);
                                        phi_3666_ = _e1673;
                                    } else {
                                        if _e2681 {
                                            let _e2764 = select(_e1661, 31u, _e1665);
                                            let _e2767 = local_73;
                                            let _e2768 = select(_e2767, _e1673.member, _e1665);
                                            let _e2771 = local_74;
                                            let _e2772 = select(_e2771, _e1673.member_1, _e1665);
                                            let _e2774 = local_75;
                                            let _e2778 = local_76;
                                            let _e2785 = ((f32(bitcast<i32>(_e2774[0].member)) * 4294967300f) + f32(_e2778[0].member_1));
                                            let _e2787 = local_77;
                                            let _e2791 = local_78;
                                            let _e2798 = ((f32(bitcast<i32>(_e2787[1].member)) * 4294967300f) + f32(_e2791[1].member_1));
                                            let _e2800 = local_79;
                                            let _e2804 = local_80;
                                            let _e2811 = ((f32(bitcast<i32>(_e2800[2].member)) * 4294967300f) + f32(_e2804[2].member_1));
                                            let _e2813 = local_81;
                                            let _e2817 = local_82;
                                            let _e2824 = ((f32(bitcast<i32>(_e2813[3].member)) * 4294967300f) + f32(_e2817[3].member_1));
                                            phi_3515_ = type_14(0i, 6i);
                                            phi_3518_ = 1f;
                                            phi_3520_ = 0f;
                                            phi_3522_ = (_e2785 / (_e2785 - _e2824));
                                            loop {
                                                let _e2828 = phi_3515_;
                                                let _e2830 = phi_3518_;
                                                let _e2832 = phi_3520_;
                                                let _e2834 = phi_3522_;
                                                local_83 = _e2834;
                                                local_84 = _e2834;
                                                if (_e2828.member < _e2828.member_1) {
                                                    let _e2841 = (_e2828.member + 1i);
                                                    phi_3516_ = type_14(select(_e2841, type_15().member_1, select(false, true, ((false == (_e2841 > _e2828.member)) != false))), _e2828.member_1);
                                                    phi_3563_ = type_15(1u, _e2828.member);
                                                } else {
                                                    phi_3516_ = _e2828;
                                                    phi_3563_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e2852 = phi_3516_;
                                                let _e2854 = phi_3563_;
                                                let _e2857 = (bitcast<i32>(_e2854.member) != 0i);
                                                if _e2857 {
                                                    let _e2858 = function_7(_e2785, _e2798, _e2834);
                                                    let _e2859 = function_7(_e2798, _e2811, _e2834);
                                                    let _e2860 = function_7(_e2811, _e2824, _e2834);
                                                    let _e2861 = function_7(_e2858, _e2859, _e2834);
                                                    let _e2862 = function_7(_e2859, _e2860, _e2834);
                                                    let _e2863 = function_7(_e2861, _e2862, _e2834);
                                                    let _e2866 = ((_e2863 < 0f) == (_e2785 < 0f));
                                                    let _e2867 = select(_e2834, _e2830, _e2866);
                                                    let _e2868 = select(_e2832, _e2834, _e2866);
                                                    let _e2872 = (_e2834 - (_e2863 / (3f * (_e2862 - _e2861))));
                                                    phi_3519_ = _e2867;
                                                    phi_3521_ = _e2868;
                                                    phi_3523_ = select(_e2872, (0.5f * (_e2868 + _e2867)), select(true, select(true, false, (_e2872 <= _e2867)), (_e2872 >= _e2868)));
                                                } else {
                                                    phi_3519_ = f32();
                                                    phi_3521_ = f32();
                                                    phi_3523_ = f32();
                                                }
                                                let _e2881 = phi_3519_;
                                                let _e2883 = phi_3521_;
                                                let _e2885 = phi_3523_;
                                                continue;
                                                continuing {
                                                    phi_3515_ = _e2852;
                                                    phi_3518_ = _e2881;
                                                    phi_3520_ = _e2883;
                                                    phi_3522_ = _e2885;
                                                    break if !(_e2857);
                                                }
                                            }
                                            let _e2890 = (1u << bitcast<u32>(((31u - _e2764) & 31u)));
                                            let _e2891 = (_e2772 - _e2768);
                                            let _e2893 = local_83;
                                            let _e2897 = local_84;
                                            let _e2900 = (select(0.5f, _e2897, (bitcast<u32>(_e2893) <= 1065353216u)) * f32(_e2891));
                                            let _e2905 = select(select(u32(_e2900), 0u, (_e2900 < 0f)), 4294967295u, (_e2900 > 4294967000f));
                                            let _e2907 = select(_e2905, _e2891, (_e2891 < _e2905));
                                            let _e2909 = (_e2890 / 2u);
                                            let _e2912 = ((_e2768 + _e2907) - select(_e2909, _e2907, (_e2907 < _e2909)));
                                            let _e2913 = (_e2912 + _e2890);
                                            phi_3661_ = true;
                                            phi_3662_ = _e2591;
                                            phi_3663_ = type_17(_e2912, select(_e2913, _e2772, (_e2772 < _e2913)), _e2764);
                                        } else {
                                            if _e2741 {
                                                let _e2751 = select((bitcast<u32>(31i) - firstLeadingBit(_e706)), 32u, (_e706 == 0u));
                                                let _e2757 = local_71;
                                                let _e2760 = local_72;
                                                phi_3660_ = type_17(_e2760, (_e2757 + (1u << bitcast<u32>(((31u - _e2751) & 31u)))), _e2751);
                                            } else {
                                                phi_3660_ = _e2591;
                                            }
                                            let _e2763 = phi_3660_;
                                            phi_3661_ = _e1667;
                                            phi_3662_ = _e2763;
                                            phi_3663_ = _e1673;
                                        }
                                        let _e2918 = phi_3661_;
                                        let _e2920 = phi_3662_;
                                        let _e2922 = phi_3663_;
                                        phi_3664_ = _e2918;
                                        phi_3665_ = _e2920;
                                        phi_3666_ = _e2922;
                                    }
                                    let _e2930 = phi_3664_;
                                    let _e2932 = phi_3665_;
                                    let _e2934 = phi_3666_;
                                    if select(select(false, (_e2932.member_1 <= 2147483648u), _e2741), true, _e2681) {
                                        if _e2681 {
                                            phi_3733_ = 0u;
                                            phi_3734_ = _e2934.member_1;
                                            phi_3735_ = _e2934.member;
                                        } else {
                                            let _e2942 = local_87;
                                            let _e2946 = local_88;
                                            let _e2949 = function_8(128u);
                                            let _e2954 = ((_e2942[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e2962 = local_89;
                                            phi_3733_ = select(0u, select(1u, 2u, ((_e2942[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2949.member - select(_e2962[0].member, (~(_e2942[0].member) + select(0u, 1u, (_e2946[0].member_1 == 0u))), _e2954)) - select(0u, 1u, (_e2949.member_1 < select(_e2962[0].member_1, (~(_e2946[0].member_1) + 1u), _e2954)))) >> bitcast<u32>(31i)) != 0u));
                                            phi_3734_ = _e2932.member_1;
                                            phi_3735_ = _e2932.member_1;
                                        }
                                        let _e2983 = phi_3733_;
                                        let _e2985 = phi_3734_;
                                        let _e2987 = phi_3735_;
                                        phi_3738_ = type_14(0i, 2i);
                                        phi_3741_ = _e2983;
                                        phi_3743_ = _e2987;
                                        loop {
                                            let _e2989 = phi_3738_;
                                            let _e2991 = phi_3741_;
                                            let _e2993 = phi_3743_;
                                            local_90 = _e2991;
                                            if (_e2989.member < _e2989.member_1) {
                                                let _e3000 = (_e2989.member + 1i);
                                                phi_3739_ = type_14(select(_e3000, type_15().member_1, select(false, true, ((false == (_e3000 > _e2989.member)) != false))), _e2989.member_1);
                                                phi_3783_ = type_15(1u, _e2989.member);
                                            } else {
                                                phi_3739_ = _e2989;
                                                phi_3783_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3011 = phi_3739_;
                                            let _e3013 = phi_3783_;
                                            let _e3016 = (bitcast<i32>(_e3013.member) != 0i);
                                            if _e3016 {
                                                let _e3022 = function_6(((_e1622[1].member - _e1618.member) - select(0u, 1u, (_e1626[1].member_1 < _e1618.member_1))), (_e1626[1].member_1 - _e1618.member_1), _e2993);
                                                let _e3025 = (_e1618.member_1 + _e3022.member_1);
                                                let _e3029 = ((_e1618.member + _e3022.member) + select(0u, 1u, (_e3025 < _e1618.member_1)));
                                                let _e3035 = function_6(((_e1630[2].member - _e1622[1].member) - select(0u, 1u, (_e1634[2].member_1 < _e1626[1].member_1))), (_e1634[2].member_1 - _e1626[1].member_1), _e2993);
                                                let _e3038 = (_e1626[1].member_1 + _e3035.member_1);
                                                let _e3042 = ((_e1622[1].member + _e3035.member) + select(0u, 1u, (_e3038 < _e1626[1].member_1)));
                                                let _e3048 = function_6(((_e1645.member - _e1630[2].member) - select(0u, 1u, (_e1645.member_1 < _e1634[2].member_1))), (_e1645.member_1 - _e1634[2].member_1), _e2993);
                                                let _e3051 = (_e1634[2].member_1 + _e3048.member_1);
                                                let _e3061 = function_6(((_e3042 - _e3029) - select(0u, 1u, (_e3038 < _e3025))), (_e3038 - _e3025), _e2993);
                                                let _e3064 = (_e3025 + _e3061.member_1);
                                                let _e3068 = ((_e3029 + _e3061.member) + select(0u, 1u, (_e3064 < _e3025)));
                                                let _e3074 = function_6(((((_e1630[2].member + _e3048.member) + select(0u, 1u, (_e3051 < _e1634[2].member_1))) - _e3042) - select(0u, 1u, (_e3051 < _e3038))), (_e3051 - _e3038), _e2993);
                                                let _e3077 = (_e3038 + _e3074.member_1);
                                                let _e3087 = function_6(((((_e3042 + _e3074.member) + select(0u, 1u, (_e3077 < _e3038))) - _e3068) - select(0u, 1u, (_e3077 < _e3064))), (_e3077 - _e3064), _e2993);
                                                let _e3090 = (_e3064 + _e3087.member_1);
                                                let _e3094 = ((_e3068 + _e3087.member) + select(0u, 1u, (_e3090 < _e3064)));
                                                let _e3095 = function_8(128u);
                                                let _e3100 = ((_e3094 >> bitcast<u32>(31i)) != 0u);
                                                phi_3742_ = (_e2991 | select(0u, select(1u, 2u, ((_e3094 >> bitcast<u32>(31i)) != 0u)), ((((_e3095.member - select(_e3094, (~(_e3094) + select(0u, 1u, (_e3090 == 0u))), _e3100)) - select(0u, 1u, (_e3095.member_1 < select(_e3090, (~(_e3090) + 1u), _e3100)))) >> bitcast<u32>(31i)) != 0u)));
                                            } else {
                                                phi_3742_ = u32();
                                            }
                                            let _e3123 = phi_3742_;
                                            continue;
                                            continuing {
                                                phi_3738_ = _e3011;
                                                phi_3741_ = _e3123;
                                                phi_3743_ = _e2985;
                                                break if !(_e3016);
                                            }
                                        }
                                        let _e3126 = local_90;
                                        phi_3959_ = (_e3126 == 3u);
                                    } else {
                                        phi_3959_ = _e2671;
                                    }
                                    let _e3129 = phi_3959_;
                                    if _e2681 {
                                        phi_3967_ = _e3129;
                                        phi_3968_ = type_17(select(_e2932.member, _e2934.member, _e3129), select(_e2932.member_1, _e2934.member_1, _e3129), select(_e2932.member_2, _e2934.member_2, _e3129));
                                    } else {
                                        phi_3967_ = _e1665;
                                        phi_3968_ = _e2932;
                                    }
                                    let _e3141 = phi_3967_;
                                    let _e3143 = phi_3968_;
                                    let _e3162 = ((_e1329[0][1][0].member - _e1329[0][0][0].member) - select(0u, 1u, (_e1329[0][1][0].member_1 < _e1329[0][0][0].member_1)));
                                    let _e3163 = (_e1329[0][1][0].member_1 - _e1329[0][0][0].member_1);
                                    let _e3175 = ((_e1329[0][1][1].member - _e1329[0][0][1].member) - select(0u, 1u, (_e1329[0][1][1].member_1 < _e1329[0][0][1].member_1)));
                                    let _e3176 = (_e1329[0][1][1].member_1 - _e1329[0][0][1].member_1);
                                    let _e3188 = ((_e1329[0][1][2].member - _e1329[0][0][2].member) - select(0u, 1u, (_e1329[0][1][2].member_1 < _e1329[0][0][2].member_1)));
                                    let _e3189 = (_e1329[0][1][2].member_1 - _e1329[0][0][2].member_1);
                                    let _e3192 = ((_e3162 >> bitcast<u32>(31i)) != 0u);
                                    let _e3199 = select(_e3162, (~(_e3162) + select(0u, 1u, (_e3163 == 0u))), _e3192);
                                    let _e3200 = select(_e3163, (~(_e3163) + 1u), _e3192);
                                    let _e3203 = ((_e3175 >> bitcast<u32>(31i)) != 0u);
                                    let _e3210 = select(_e3175, (~(_e3175) + select(0u, 1u, (_e3176 == 0u))), _e3203);
                                    let _e3211 = select(_e3176, (~(_e3176) + 1u), _e3203);
                                    let _e3218 = ((((_e3210 - _e3199) - select(0u, 1u, (_e3211 < _e3200))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3219 = select(_e3210, _e3199, _e3218);
                                    let _e3220 = select(_e3211, _e3200, _e3218);
                                    let _e3223 = ((_e3188 >> bitcast<u32>(31i)) != 0u);
                                    let _e3230 = select(_e3188, (~(_e3188) + select(0u, 1u, (_e3189 == 0u))), _e3223);
                                    let _e3231 = select(_e3189, (~(_e3189) + 1u), _e3223);
                                    let _e3238 = ((((_e3230 - _e3219) - select(0u, 1u, (_e3231 < _e3220))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3240 = select(_e3231, _e3220, _e3238);
                                    let _e3241 = function_8(4u);
                                    let _e3244 = (_e3240 + _e3241.member_1);
                                    let _e3248 = ((select(_e3230, _e3219, _e3238) + _e3241.member) + select(0u, 1u, (_e3244 < _e3240)));
                                    let _e3263 = ((_e3244 >> bitcast<u32>((_e3143.member_2 & 31u))) | ((_e3248 << bitcast<u32>(((31u - _e3143.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3264 = function_8(4u);
                                    let _e3267 = (_e3263 + _e3264.member_1);
                                    let _e3285 = ((_e1329[1][1][0].member - _e1329[1][0][0].member) - select(0u, 1u, (_e1329[1][1][0].member_1 < _e1329[1][0][0].member_1)));
                                    let _e3286 = (_e1329[1][1][0].member_1 - _e1329[1][0][0].member_1);
                                    let _e3298 = ((_e1329[1][1][1].member - _e1329[1][0][1].member) - select(0u, 1u, (_e1329[1][1][1].member_1 < _e1329[1][0][1].member_1)));
                                    let _e3299 = (_e1329[1][1][1].member_1 - _e1329[1][0][1].member_1);
                                    let _e3311 = ((_e1329[1][1][2].member - _e1329[1][0][2].member) - select(0u, 1u, (_e1329[1][1][2].member_1 < _e1329[1][0][2].member_1)));
                                    let _e3312 = (_e1329[1][1][2].member_1 - _e1329[1][0][2].member_1);
                                    let _e3315 = ((_e3285 >> bitcast<u32>(31i)) != 0u);
                                    let _e3322 = select(_e3285, (~(_e3285) + select(0u, 1u, (_e3286 == 0u))), _e3315);
                                    let _e3323 = select(_e3286, (~(_e3286) + 1u), _e3315);
                                    let _e3326 = ((_e3298 >> bitcast<u32>(31i)) != 0u);
                                    let _e3333 = select(_e3298, (~(_e3298) + select(0u, 1u, (_e3299 == 0u))), _e3326);
                                    let _e3334 = select(_e3299, (~(_e3299) + 1u), _e3326);
                                    let _e3341 = ((((_e3333 - _e3322) - select(0u, 1u, (_e3334 < _e3323))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3342 = select(_e3333, _e3322, _e3341);
                                    let _e3343 = select(_e3334, _e3323, _e3341);
                                    let _e3346 = ((_e3311 >> bitcast<u32>(31i)) != 0u);
                                    let _e3353 = select(_e3311, (~(_e3311) + select(0u, 1u, (_e3312 == 0u))), _e3346);
                                    let _e3354 = select(_e3312, (~(_e3312) + 1u), _e3346);
                                    let _e3361 = ((((_e3353 - _e3342) - select(0u, 1u, (_e3354 < _e3343))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3363 = select(_e3354, _e3343, _e3361);
                                    let _e3364 = function_8(4u);
                                    let _e3367 = (_e3363 + _e3364.member_1);
                                    let _e3371 = ((select(_e3353, _e3342, _e3361) + _e3364.member) + select(0u, 1u, (_e3367 < _e3363)));
                                    let _e3386 = ((_e3367 >> bitcast<u32>((_e3143.member_2 & 31u))) | ((_e3371 << bitcast<u32>(((31u - _e3143.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3387 = function_8(4u);
                                    let _e3390 = (_e3386 + _e3387.member_1);
                                    let _e3408 = ((_e1329[2][1][0].member - _e1329[2][0][0].member) - select(0u, 1u, (_e1329[2][1][0].member_1 < _e1329[2][0][0].member_1)));
                                    let _e3409 = (_e1329[2][1][0].member_1 - _e1329[2][0][0].member_1);
                                    let _e3421 = ((_e1329[2][1][1].member - _e1329[2][0][1].member) - select(0u, 1u, (_e1329[2][1][1].member_1 < _e1329[2][0][1].member_1)));
                                    let _e3422 = (_e1329[2][1][1].member_1 - _e1329[2][0][1].member_1);
                                    let _e3434 = ((_e1329[2][1][2].member - _e1329[2][0][2].member) - select(0u, 1u, (_e1329[2][1][2].member_1 < _e1329[2][0][2].member_1)));
                                    let _e3435 = (_e1329[2][1][2].member_1 - _e1329[2][0][2].member_1);
                                    let _e3438 = ((_e3408 >> bitcast<u32>(31i)) != 0u);
                                    let _e3445 = select(_e3408, (~(_e3408) + select(0u, 1u, (_e3409 == 0u))), _e3438);
                                    let _e3446 = select(_e3409, (~(_e3409) + 1u), _e3438);
                                    let _e3449 = ((_e3421 >> bitcast<u32>(31i)) != 0u);
                                    let _e3456 = select(_e3421, (~(_e3421) + select(0u, 1u, (_e3422 == 0u))), _e3449);
                                    let _e3457 = select(_e3422, (~(_e3422) + 1u), _e3449);
                                    let _e3464 = ((((_e3456 - _e3445) - select(0u, 1u, (_e3457 < _e3446))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3465 = select(_e3456, _e3445, _e3464);
                                    let _e3466 = select(_e3457, _e3446, _e3464);
                                    let _e3469 = ((_e3434 >> bitcast<u32>(31i)) != 0u);
                                    let _e3476 = select(_e3434, (~(_e3434) + select(0u, 1u, (_e3435 == 0u))), _e3469);
                                    let _e3477 = select(_e3435, (~(_e3435) + 1u), _e3469);
                                    let _e3484 = ((((_e3476 - _e3465) - select(0u, 1u, (_e3477 < _e3466))) >> bitcast<u32>(31i)) != 0u);
                                    let _e3486 = select(_e3477, _e3466, _e3484);
                                    let _e3487 = function_8(4u);
                                    let _e3490 = (_e3486 + _e3487.member_1);
                                    let _e3494 = ((select(_e3476, _e3465, _e3484) + _e3487.member) + select(0u, 1u, (_e3490 < _e3486)));
                                    let _e3509 = ((_e3490 >> bitcast<u32>((_e3143.member_2 & 31u))) | ((_e3494 << bitcast<u32>(((31u - _e3143.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e3510 = function_8(4u);
                                    let _e3513 = (_e3509 + _e3510.member_1);
                                    local_1[0u].member = ((bitcast<u32>((bitcast<i32>(_e3248) >> bitcast<u32>((_e3143.member_2 & 31u)))) + _e3264.member) + select(0u, 1u, (_e3267 < _e3263)));
                                    local_1[0u].member_1 = _e3267;
                                    local_1[1u].member = ((bitcast<u32>((bitcast<i32>(_e3371) >> bitcast<u32>((_e3143.member_2 & 31u)))) + _e3387.member) + select(0u, 1u, (_e3390 < _e3386)));
                                    local_1[1u].member_1 = _e3390;
                                    local_1[2u].member = ((bitcast<u32>((bitcast<i32>(_e3494) >> bitcast<u32>((_e3143.member_2 & 31u)))) + _e3510.member) + select(0u, 1u, (_e3513 < _e3509)));
                                    local_1[2u].member_1 = _e3513;
                                    let _e3543 = function_6(((_e1329[0][1][0].member - _e1329[0][0][0].member) - select(0u, 1u, (_e1329[0][1][0].member_1 < _e1329[0][0][0].member_1))), (_e1329[0][1][0].member_1 - _e1329[0][0][0].member_1), _e3143.member);
                                    let _e3546 = (_e1329[0][0][0].member_1 + _e3543.member_1);
                                    let _e3550 = ((_e1329[0][0][0].member + _e3543.member) + select(0u, 1u, (_e3546 < _e1329[0][0][0].member_1)));
                                    let _e3564 = function_6(((_e1329[0][1][1].member - _e1329[0][0][1].member) - select(0u, 1u, (_e1329[0][1][1].member_1 < _e1329[0][0][1].member_1))), (_e1329[0][1][1].member_1 - _e1329[0][0][1].member_1), _e3143.member);
                                    let _e3567 = (_e1329[0][0][1].member_1 + _e3564.member_1);
                                    let _e3571 = ((_e1329[0][0][1].member + _e3564.member) + select(0u, 1u, (_e3567 < _e1329[0][0][1].member_1)));
                                    let _e3585 = function_6(((_e1329[0][1][2].member - _e1329[0][0][2].member) - select(0u, 1u, (_e1329[0][1][2].member_1 < _e1329[0][0][2].member_1))), (_e1329[0][1][2].member_1 - _e1329[0][0][2].member_1), _e3143.member);
                                    let _e3588 = (_e1329[0][0][2].member_1 + _e3585.member_1);
                                    let _e3592 = ((_e1329[0][0][2].member + _e3585.member) + select(0u, 1u, (_e3588 < _e1329[0][0][2].member_1)));
                                    let _e3608 = function_6(((_e1329[1][1][0].member - _e1329[1][0][0].member) - select(0u, 1u, (_e1329[1][1][0].member_1 < _e1329[1][0][0].member_1))), (_e1329[1][1][0].member_1 - _e1329[1][0][0].member_1), _e3143.member);
                                    let _e3611 = (_e1329[1][0][0].member_1 + _e3608.member_1);
                                    let _e3615 = ((_e1329[1][0][0].member + _e3608.member) + select(0u, 1u, (_e3611 < _e1329[1][0][0].member_1)));
                                    let _e3629 = function_6(((_e1329[1][1][1].member - _e1329[1][0][1].member) - select(0u, 1u, (_e1329[1][1][1].member_1 < _e1329[1][0][1].member_1))), (_e1329[1][1][1].member_1 - _e1329[1][0][1].member_1), _e3143.member);
                                    let _e3632 = (_e1329[1][0][1].member_1 + _e3629.member_1);
                                    let _e3636 = ((_e1329[1][0][1].member + _e3629.member) + select(0u, 1u, (_e3632 < _e1329[1][0][1].member_1)));
                                    let _e3650 = function_6(((_e1329[1][1][2].member - _e1329[1][0][2].member) - select(0u, 1u, (_e1329[1][1][2].member_1 < _e1329[1][0][2].member_1))), (_e1329[1][1][2].member_1 - _e1329[1][0][2].member_1), _e3143.member);
                                    let _e3653 = (_e1329[1][0][2].member_1 + _e3650.member_1);
                                    let _e3657 = ((_e1329[1][0][2].member + _e3650.member) + select(0u, 1u, (_e3653 < _e1329[1][0][2].member_1)));
                                    let _e3673 = function_6(((_e1329[2][1][0].member - _e1329[2][0][0].member) - select(0u, 1u, (_e1329[2][1][0].member_1 < _e1329[2][0][0].member_1))), (_e1329[2][1][0].member_1 - _e1329[2][0][0].member_1), _e3143.member);
                                    let _e3676 = (_e1329[2][0][0].member_1 + _e3673.member_1);
                                    let _e3680 = ((_e1329[2][0][0].member + _e3673.member) + select(0u, 1u, (_e3676 < _e1329[2][0][0].member_1)));
                                    let _e3694 = function_6(((_e1329[2][1][1].member - _e1329[2][0][1].member) - select(0u, 1u, (_e1329[2][1][1].member_1 < _e1329[2][0][1].member_1))), (_e1329[2][1][1].member_1 - _e1329[2][0][1].member_1), _e3143.member);
                                    let _e3697 = (_e1329[2][0][1].member_1 + _e3694.member_1);
                                    let _e3701 = ((_e1329[2][0][1].member + _e3694.member) + select(0u, 1u, (_e3697 < _e1329[2][0][1].member_1)));
                                    let _e3715 = function_6(((_e1329[2][1][2].member - _e1329[2][0][2].member) - select(0u, 1u, (_e1329[2][1][2].member_1 < _e1329[2][0][2].member_1))), (_e1329[2][1][2].member_1 - _e1329[2][0][2].member_1), _e3143.member);
                                    let _e3718 = (_e1329[2][0][2].member_1 + _e3715.member_1);
                                    let _e3722 = ((_e1329[2][0][2].member + _e3715.member) + select(0u, 1u, (_e3718 < _e1329[2][0][2].member_1)));
                                    let _e3723 = function_4(_e3636, _e3632, _e3722, _e3718);
                                    let _e3726 = function_4(_e3657, _e3653, _e3701, _e3697);
                                    let _e3732 = ((_e3723.member - _e3726.member) - select(0u, 1u, (_e3723.member_1 < _e3726.member_1)));
                                    let _e3733 = (_e3723.member_1 - _e3726.member_1);
                                    let _e3734 = function_4(_e3657, _e3653, _e3680, _e3676);
                                    let _e3737 = function_4(_e3615, _e3611, _e3722, _e3718);
                                    let _e3743 = ((_e3734.member - _e3737.member) - select(0u, 1u, (_e3734.member_1 < _e3737.member_1)));
                                    let _e3744 = (_e3734.member_1 - _e3737.member_1);
                                    let _e3745 = function_4(_e3615, _e3611, _e3701, _e3697);
                                    let _e3748 = function_4(_e3636, _e3632, _e3680, _e3676);
                                    let _e3754 = ((_e3745.member - _e3748.member) - select(0u, 1u, (_e3745.member_1 < _e3748.member_1)));
                                    let _e3755 = (_e3745.member_1 - _e3748.member_1);
                                    let _e3758 = ((_e3732 >> bitcast<u32>(31i)) != 0u);
                                    let _e3765 = select(_e3732, (~(_e3732) + select(0u, 1u, (_e3733 == 0u))), _e3758);
                                    let _e3766 = select(_e3733, (~(_e3733) + 1u), _e3758);
                                    let _e3769 = ((_e3743 >> bitcast<u32>(31i)) != 0u);
                                    let _e3776 = select(_e3743, (~(_e3743) + select(0u, 1u, (_e3744 == 0u))), _e3769);
                                    let _e3777 = select(_e3744, (~(_e3744) + 1u), _e3769);
                                    let _e3780 = ((_e3754 >> bitcast<u32>(31i)) != 0u);
                                    let _e3787 = select(_e3754, (~(_e3754) + select(0u, 1u, (_e3755 == 0u))), _e3780);
                                    let _e3788 = select(_e3755, (~(_e3755) + 1u), _e3780);
                                    let _e3813 = select(0i, select(2i, 1i, ((((_e3787 - _e3776) - select(0u, 1u, (_e3788 < _e3777))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e3787 - _e3765) - select(0u, 1u, (_e3788 < _e3766))) >> bitcast<u32>(31i)) != 0u)), ((((_e3776 - _e3765) - select(0u, 1u, (_e3777 < _e3766))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e3813 {
                                        case 0: {
                                            phi_4989_ = array<type_9, 2>(type_9(_e3571, _e3567), type_9(_e3592, _e3588));
                                            break;
                                        }
                                        case 1: {
                                            phi_4989_ = array<type_9, 2>(type_9(_e3592, _e3588), type_9(_e3550, _e3546));
                                            break;
                                        }
                                        default: {
                                            phi_4989_ = array<type_9, 2>(type_9(_e3550, _e3546), type_9(_e3571, _e3567));
                                            break;
                                        }
                                    }
                                    let _e3824 = phi_4989_;
                                    switch _e3813 {
                                        case 0: {
                                            phi_5018_ = array<type_9, 2>(type_9(_e3636, _e3632), type_9(_e3657, _e3653));
                                            break;
                                        }
                                        case 1: {
                                            phi_5018_ = array<type_9, 2>(type_9(_e3657, _e3653), type_9(_e3615, _e3611));
                                            break;
                                        }
                                        default: {
                                            phi_5018_ = array<type_9, 2>(type_9(_e3615, _e3611), type_9(_e3636, _e3632));
                                            break;
                                        }
                                    }
                                    let _e3835 = phi_5018_;
                                    switch _e3813 {
                                        case 0: {
                                            phi_5047_ = array<type_9, 2>(type_9(_e3701, _e3697), type_9(_e3722, _e3718));
                                            break;
                                        }
                                        case 1: {
                                            phi_5047_ = array<type_9, 2>(type_9(_e3722, _e3718), type_9(_e3680, _e3676));
                                            break;
                                        }
                                        default: {
                                            phi_5047_ = array<type_9, 2>(type_9(_e3680, _e3676), type_9(_e3701, _e3697));
                                            break;
                                        }
                                    }
                                    let _e3846 = phi_5047_;
                                    switch _e3813 {
                                        case 0: {
                                            phi_5061_ = type_9(_e3732, _e3733);
                                            break;
                                        }
                                        case 1: {
                                            phi_5061_ = type_9(_e3743, _e3744);
                                            break;
                                        }
                                        default: {
                                            phi_5061_ = type_9(_e3754, _e3755);
                                            break;
                                        }
                                    }
                                    let _e3851 = phi_5061_;
                                    let _e3854 = local_1[1u].member;
                                    let _e3856 = local_1[1u].member_1;
                                    let _e3859 = local_1[2u].member;
                                    let _e3861 = local_1[2u].member_1;
                                    let _e3862 = (_e3856 + _e3861);
                                    let _e3866 = ((_e3854 + _e3859) + select(0u, 1u, (_e3862 < _e3856)));
                                    let _e3877 = ((_e3862 >> bitcast<u32>(1u)) | ((_e3866 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3878 = function_8(17u);
                                    let _e3881 = (_e3877 + _e3878.member_1);
                                    let _e3885 = ((bitcast<u32>((bitcast<i32>(_e3866) >> bitcast<u32>(1u))) + _e3878.member) + select(0u, 1u, (_e3881 < _e3877)));
                                    let _e3888 = local_1[0u].member;
                                    let _e3890 = local_1[0u].member_1;
                                    let _e3893 = local_1[2u].member;
                                    let _e3895 = local_1[2u].member_1;
                                    let _e3896 = (_e3890 + _e3895);
                                    let _e3900 = ((_e3888 + _e3893) + select(0u, 1u, (_e3896 < _e3890)));
                                    let _e3911 = ((_e3896 >> bitcast<u32>(1u)) | ((_e3900 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3912 = function_8(17u);
                                    let _e3915 = (_e3911 + _e3912.member_1);
                                    let _e3919 = ((bitcast<u32>((bitcast<i32>(_e3900) >> bitcast<u32>(1u))) + _e3912.member) + select(0u, 1u, (_e3915 < _e3911)));
                                    let _e3922 = local_1[0u].member;
                                    let _e3924 = local_1[0u].member_1;
                                    let _e3927 = local_1[1u].member;
                                    let _e3929 = local_1[1u].member_1;
                                    let _e3930 = (_e3924 + _e3929);
                                    let _e3934 = ((_e3922 + _e3927) + select(0u, 1u, (_e3930 < _e3924)));
                                    let _e3945 = ((_e3930 >> bitcast<u32>(1u)) | ((_e3934 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e3946 = function_8(17u);
                                    let _e3949 = (_e3945 + _e3946.member_1);
                                    let _e3953 = ((bitcast<u32>((bitcast<i32>(_e3934) >> bitcast<u32>(1u))) + _e3946.member) + select(0u, 1u, (_e3949 < _e3945)));
                                    let _e3958 = ((_e3851.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e3885 - select(_e3851.member, (~(_e3851.member) + select(0u, 1u, (_e3851.member_1 == 0u))), _e3958)) - select(0u, 1u, (_e3881 < select(_e3851.member_1, (~(_e3851.member_1) + 1u), _e3958)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e3979 = ((_e3851.member >> bitcast<u32>(31i)) != 0u);
                                        let _e3989 = select(_e3851.member, (~(_e3851.member) + select(0u, 1u, (_e3851.member_1 == 0u))), _e3979);
                                        let _e3991 = select(_e3851.member_1, (~(_e3851.member_1) + 1u), _e3979);
                                        let _e3992 = function_5(_e3824, _e3846);
                                        let _e4002 = select(_e3992.member, (~(_e3992.member) + select(0u, 1u, (_e3992.member_1 == 0u))), _e3979);
                                        let _e4004 = select(_e3992.member_1, (~(_e3992.member_1) + 1u), _e3979);
                                        let _e4005 = function_5(_e3835, _e3824);
                                        let _e4015 = select(_e4005.member, (~(_e4005.member) + select(0u, 1u, (_e4005.member_1 == 0u))), _e3979);
                                        let _e4017 = select(_e4005.member_1, (~(_e4005.member_1) + 1u), _e3979);
                                        if (_e221.member != 0u) {
                                            let _e4049 = (_e3881 + _e3915);
                                            let _e4061 = (_e3881 + _e3949);
                                            phi_5383_ = type_9(((_e3885 + _e3953) + select(0u, 1u, (_e4061 < _e3881))), _e4061);
                                            phi_5384_ = type_9(((_e3989 - _e4015) - select(0u, 1u, (_e3991 < _e4017))), (_e3991 - _e4017));
                                            phi_5385_ = type_9(((_e3885 + _e3919) + select(0u, 1u, (_e4049 < _e3881))), _e4049);
                                            phi_5386_ = type_9(((_e3989 - _e4002) - select(0u, 1u, (_e3991 < _e4004))), (_e3991 - _e4004));
                                        } else {
                                            let _e4023 = (_e3991 - _e4004);
                                            let _e4027 = ((((_e3989 - _e4002) - select(0u, 1u, (_e3991 < _e4004))) - _e4015) - select(0u, 1u, (_e4023 < _e4017)));
                                            let _e4028 = (_e4023 - _e4017);
                                            let _e4030 = (_e3881 + _e3915);
                                            let _e4035 = (_e4030 + _e3949);
                                            let _e4039 = ((((_e3885 + _e3919) + select(0u, 1u, (_e4030 < _e3881))) + _e3953) + select(0u, 1u, (_e4035 < _e4030)));
                                            phi_5383_ = type_9(_e4039, _e4035);
                                            phi_5384_ = type_9(_e4027, _e4028);
                                            phi_5385_ = type_9(_e4039, _e4035);
                                            phi_5386_ = type_9(_e4027, _e4028);
                                        }
                                        let _e4068 = phi_5383_;
                                        let _e4070 = phi_5384_;
                                        let _e4072 = phi_5385_;
                                        let _e4074 = phi_5386_;
                                        let _e4075 = function_2(_e4002, _e4004, _e3919, _e3915);
                                        if _e4075 {
                                            phi_5512_ = u32();
                                            phi_5513_ = true;
                                        } else {
                                            let _e4076 = function_2(_e4015, _e4017, _e3953, _e3949);
                                            if _e4076 {
                                                phi_5510_ = u32();
                                                phi_5511_ = true;
                                            } else {
                                                let _e4081 = function_2(_e4074.member, _e4074.member_1, _e4072.member, _e4072.member_1);
                                                if _e4081 {
                                                    phi_5508_ = u32();
                                                    phi_5509_ = true;
                                                } else {
                                                    let _e4086 = function_2(_e4070.member, _e4070.member_1, _e4068.member, _e4068.member_1);
                                                    if _e4086 {
                                                        phi_5507_ = u32();
                                                    } else {
                                                        let _e4087 = function_1(_e4002, _e4004, _e3919, _e3915);
                                                        if _e4087 {
                                                            let _e4088 = function_1(_e4015, _e4017, _e3953, _e3949);
                                                            if _e4088 {
                                                                let _e4093 = function_1(_e4074.member, _e4074.member_1, _e4072.member, _e4072.member_1);
                                                                if _e4093 {
                                                                    let _e4098 = function_1(_e4070.member, _e4070.member_1, _e4068.member, _e4068.member_1);
                                                                    phi_5500_ = select(true, false, _e4098);
                                                                } else {
                                                                    phi_5500_ = true;
                                                                }
                                                                let _e4101 = phi_5500_;
                                                                phi_5501_ = _e4101;
                                                            } else {
                                                                phi_5501_ = true;
                                                            }
                                                            let _e4103 = phi_5501_;
                                                            phi_5502_ = _e4103;
                                                        } else {
                                                            phi_5502_ = true;
                                                        }
                                                        let _e4105 = phi_5502_;
                                                        phi_5507_ = select(0u, 2u, _e4105);
                                                    }
                                                    let _e4108 = phi_5507_;
                                                    phi_5508_ = _e4108;
                                                    phi_5509_ = _e4086;
                                                }
                                                let _e4110 = phi_5508_;
                                                let _e4112 = phi_5509_;
                                                phi_5510_ = _e4110;
                                                phi_5511_ = _e4112;
                                            }
                                            let _e4114 = phi_5510_;
                                            let _e4116 = phi_5511_;
                                            phi_5512_ = _e4114;
                                            phi_5513_ = _e4116;
                                        }
                                        let _e4118 = phi_5512_;
                                        let _e4120 = phi_5513_;
                                        phi_5518_ = select(_e4118, 1u, _e4120);
                                    } else {
                                        phi_5518_ = 2u;
                                    }
                                    let _e4123 = phi_5518_;
                                    let _e4124 = (_e4123 == 1u);
                                    let _e4125 = (_e4123 == 0u);
                                    let _e4141 = local_91;
                                    if _e4141 {
                                        let _e5038 = local_113;
                                        phi_5590_ = _e5038;
                                        phi_5591_ = _e4124;
                                        phi_5592_ = select(true, false, _e4124);
                                        phi_5593_ = false;
                                        phi_5594_ = false;
                                    } else {
                                        let _e4145 = select(true, select(true, select(true, select(true, false, ((_e3143.member_1 - _e3143.member) <= _e706)), select(false, (_e3143.member_1 <= _e704), (_e3143.member >= _e702))), _e3129), _e4125);
                                        let _e4147 = select(select(false, select((_e3143.member > _e704), true, (_e3143.member_1 < _e702)), _e3141), true, _e4124);
                                        let _e4148 = select(true, _e4147, select(((((select(0u, select(1u, 2u, ((_e2421[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2428.member - select(_e2441[0].member, (~(_e2421[0].member) + select(0u, 1u, (_e2425[0].member_1 == 0u))), _e2433)) - select(0u, 1u, (_e2428.member_1 < select(_e2441[0].member_1, (~(_e2425[0].member_1) + 1u), _e2433)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2460[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2467.member - select(_e2480[1].member, (~(_e2460[1].member) + select(0u, 1u, (_e2464[1].member_1 == 0u))), _e2472)) - select(0u, 1u, (_e2467.member_1 < select(_e2480[1].member_1, (~(_e2464[1].member_1) + 1u), _e2472)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e2500[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2507.member - select(_e2520[2].member, (~(_e2500[2].member) + select(0u, 1u, (_e2504[2].member_1 == 0u))), _e2512)) - select(0u, 1u, (_e2507.member_1 < select(_e2520[2].member_1, (~(_e2504[2].member_1) + 1u), _e2512)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e2540[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2547.member - select(_e2560[3].member, (~(_e2540[3].member) + select(0u, 1u, (_e2544[3].member_1 == 0u))), _e2552)) - select(0u, 1u, (_e2547.member_1 < select(_e2560[3].member_1, (~(_e2544[3].member_1) + 1u), _e2552)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e2581 == 31u), true, _e1665)));
                                        phi_5590_ = select(bool(), _e4147, _e4145);
                                        phi_5591_ = select(false, _e4148, _e4145);
                                        phi_5592_ = false;
                                        phi_5593_ = select(false, select(true, false, _e4148), _e4145);
                                        phi_5594_ = select(true, false, _e4145);
                                    }
                                    let _e4156 = phi_5590_;
                                    let _e4158 = phi_5591_;
                                    let _e4160 = phi_5592_;
                                    let _e4162 = phi_5593_;
                                    let _e4164 = phi_5594_;
                                    phi_5601_ = _e3141;
                                    phi_5602_ = _e2930;
                                    phi_5603_ = true;
                                    phi_5604_ = !(_e2743);
                                    phi_5605_ = _e2934;
                                    phi_5606_ = _e4156;
                                    phi_5607_ = _e4125;
                                    phi_5608_ = _e3143;
                                    phi_5609_ = _e4158;
                                    phi_5610_ = select(_e4160, false, _e4158);
                                    phi_5611_ = select(_e4162, false, _e4158);
                                    phi_5612_ = select(_e4164, false, _e4158);
                                }
                                let _e4169 = phi_5601_;
                                let _e4171 = phi_5602_;
                                let _e4173 = phi_5603_;
                                let _e4175 = phi_5604_;
                                let _e4177 = phi_5605_;
                                let _e4179 = phi_5606_;
                                let _e4181 = phi_5607_;
                                let _e4183 = phi_5608_;
                                let _e4185 = phi_5609_;
                                let _e4187 = phi_5610_;
                                let _e4189 = phi_5611_;
                                let _e4191 = phi_5612_;
                                phi_5613_ = _e4169;
                                phi_5614_ = _e4171;
                                phi_5615_ = _e4173;
                                phi_5616_ = _e4175;
                                phi_5617_ = _e4177;
                                phi_5618_ = _e4179;
                                phi_5619_ = _e4181;
                                phi_5620_ = _e4183;
                                phi_5621_ = _e4185;
                                phi_5622_ = _e4187;
                                phi_5623_ = _e4189;
                                phi_5624_ = _e4191;
                            } else {
                                phi_5613_ = _e1665;
                                phi_5614_ = _e1667;
                                let _e5065 = local_117;
                                phi_5615_ = _e5065;
                                let _e5068 = local_118;
                                phi_5616_ = _e5068;
                                phi_5617_ = _e1673;
                                let _e5072 = local_119;
                                phi_5618_ = _e5072;
                                phi_5619_ = bool();
                                phi_5620_ = type_17();
                                phi_5621_ = true;
                                phi_5622_ = false;
                                phi_5623_ = false;
                                phi_5624_ = false;
                            }
                            let _e4193 = phi_5613_;
                            let _e4195 = phi_5614_;
                            let _e4197 = phi_5615_;
                            let _e4199 = phi_5616_;
                            let _e4201 = phi_5617_;
                            let _e4203 = phi_5618_;
                            let _e4205 = phi_5619_;
                            let _e4207 = phi_5620_;
                            let _e4209 = phi_5621_;
                            let _e4211 = phi_5622_;
                            let _e4213 = phi_5623_;
                            let _e4215 = phi_5624_;
                            if _e4209 {
                                if _e4203 {
                                    let _e4219 = local_92;
                                    let _e4220 = (_e4219 + 1u);
                                    let _e4222 = local_93;
                                    let _e4224 = (_e4220 & (4294967295u - _e4222));
                                    let _e4230 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4224)), 32u, (_e4224 == 0u)));
                                    let _e4232 = local_94;
                                    let _e4235 = local_95;
                                    let _e4236 = select(_e4230, _e4235, (_e4232 < _e4230));
                                    let _e4239 = (_e4220 >> bitcast<u32>((_e4236 & 31u)));
                                    let _e4241 = local_96;
                                    let _e4242 = (_e4241 - _e4236);
                                    let _e4244 = local_97;
                                    let _e4245 = (_e4244 > _e704);
                                    if _e4245 {
                                        phi_5675_ = u32();
                                        phi_5676_ = u32();
                                        phi_5677_ = false;
                                        phi_5678_ = false;
                                    } else {
                                        let _e4249 = select(true, select(true, false, (_e4242 == 0u)), (_e4239 == 1u));
                                        let _e4250 = (31u - _e4242);
                                        phi_5675_ = select(u32(), ((_e4239 + 1u) << bitcast<u32>((_e4250 & 31u))), _e4249);
                                        phi_5676_ = select(u32(), (_e4239 << bitcast<u32>((_e4250 & 31u))), _e4249);
                                        phi_5677_ = _e4249;
                                        phi_5678_ = select(true, false, _e4249);
                                    }
                                    let _e4262 = phi_5675_;
                                    let _e4264 = phi_5676_;
                                    let _e4266 = phi_5677_;
                                    let _e4268 = phi_5678_;
                                    phi_5679_ = _e4262;
                                    phi_5680_ = _e4264;
                                    phi_5681_ = false;
                                    phi_5682_ = false;
                                    phi_5683_ = false;
                                    phi_5684_ = false;
                                    phi_5685_ = _e4242;
                                    phi_5686_ = _e4239;
                                    phi_5687_ = _e4266;
                                    phi_5688_ = _e4245;
                                    phi_5689_ = _e4268;
                                } else {
                                    phi_5679_ = _e4201.member_1;
                                    phi_5680_ = _e4201.member;
                                    phi_5681_ = _e4193;
                                    phi_5682_ = _e4195;
                                    phi_5683_ = _e4197;
                                    phi_5684_ = _e4199;
                                    let _e5097 = local_120;
                                    phi_5685_ = _e5097;
                                    let _e5100 = local_121;
                                    phi_5686_ = _e5100;
                                    phi_5687_ = true;
                                    phi_5688_ = false;
                                    phi_5689_ = false;
                                }
                                let _e4270 = phi_5679_;
                                let _e4272 = phi_5680_;
                                let _e4274 = phi_5681_;
                                let _e4276 = phi_5682_;
                                let _e4278 = phi_5683_;
                                let _e4280 = phi_5684_;
                                let _e4282 = phi_5685_;
                                let _e4284 = phi_5686_;
                                let _e4286 = phi_5687_;
                                let _e4288 = phi_5688_;
                                let _e4290 = phi_5689_;
                                if _e4286 {
                                    if select(_e4274, true, _e4203) {
                                        phi_5714_ = type_14(0i, 4i);
                                        phi_5717_ = array<u32, 3>(_e4272, _e4272, _e4272);
                                        phi_5719_ = array<type_9, 4>(type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u), type_9(0u, 0u));
                                        loop {
                                            let _e4294 = phi_5714_;
                                            let _e4296 = phi_5717_;
                                            let _e4298 = phi_5719_;
                                            local_122 = _e4298;
                                            if (_e4294.member < _e4294.member_1) {
                                                let _e4305 = (_e4294.member + 1i);
                                                phi_5715_ = type_14(select(_e4305, type_15().member_1, select(false, true, ((false == (_e4305 > _e4294.member)) != false))), _e4294.member_1);
                                                phi_5760_ = type_15(1u, _e4294.member);
                                            } else {
                                                phi_5715_ = _e4294;
                                                phi_5760_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e4316 = phi_5715_;
                                            let _e4318 = phi_5760_;
                                            let _e4321 = (bitcast<i32>(_e4318.member) != 0i);
                                            if _e4321 {
                                                let _e4330 = function_6(((_e1622[1].member - _e1618.member) - select(0u, 1u, (_e1626[1].member_1 < _e1618.member_1))), (_e1626[1].member_1 - _e1618.member_1), _e4296[0]);
                                                let _e4333 = (_e1618.member_1 + _e4330.member_1);
                                                let _e4337 = ((_e1618.member + _e4330.member) + select(0u, 1u, (_e4333 < _e1618.member_1)));
                                                let _e4343 = function_6(((_e1630[2].member - _e1622[1].member) - select(0u, 1u, (_e1634[2].member_1 < _e1626[1].member_1))), (_e1634[2].member_1 - _e1626[1].member_1), _e4296[0]);
                                                let _e4346 = (_e1626[1].member_1 + _e4343.member_1);
                                                let _e4350 = ((_e1622[1].member + _e4343.member) + select(0u, 1u, (_e4346 < _e1626[1].member_1)));
                                                let _e4356 = function_6(((_e1645.member - _e1630[2].member) - select(0u, 1u, (_e1645.member_1 < _e1634[2].member_1))), (_e1645.member_1 - _e1634[2].member_1), _e4296[0]);
                                                let _e4359 = (_e1634[2].member_1 + _e4356.member_1);
                                                let _e4369 = function_6(((_e4350 - _e4337) - select(0u, 1u, (_e4346 < _e4333))), (_e4346 - _e4333), _e4296[1]);
                                                let _e4372 = (_e4333 + _e4369.member_1);
                                                let _e4376 = ((_e4337 + _e4369.member) + select(0u, 1u, (_e4372 < _e4333)));
                                                let _e4382 = function_6(((((_e1630[2].member + _e4356.member) + select(0u, 1u, (_e4359 < _e1634[2].member_1))) - _e4350) - select(0u, 1u, (_e4359 < _e4346))), (_e4359 - _e4346), _e4296[1]);
                                                let _e4385 = (_e4346 + _e4382.member_1);
                                                let _e4395 = function_6(((((_e4350 + _e4382.member) + select(0u, 1u, (_e4385 < _e4346))) - _e4376) - select(0u, 1u, (_e4385 < _e4372))), (_e4385 - _e4372), _e4296[2]);
                                                let _e4398 = (_e4372 + _e4395.member_1);
                                                phi_5718_ = array<u32, 3>(_e4296[1], _e4296[2], _e4270);
                                                phi_5720_ = array<type_9, 4>(_e4298[1], _e4298[2], _e4298[3], type_9(((_e4376 + _e4395.member) + select(0u, 1u, (_e4398 < _e4372))), _e4398));
                                            } else {
                                                phi_5718_ = array<u32, 3>();
                                                phi_5720_ = array<type_9, 4>();
                                            }
                                            let _e4412 = phi_5718_;
                                            let _e4414 = phi_5720_;
                                            continue;
                                            continuing {
                                                phi_5714_ = _e4316;
                                                phi_5717_ = _e4412;
                                                phi_5719_ = _e4414;
                                                break if !(_e4321);
                                            }
                                        }
                                        let _e5113 = local_122;
                                        phi_5913_ = _e5113;
                                    } else {
                                        let _e5115 = local_123;
                                        phi_5913_ = _e5115;
                                    }
                                    let _e4417 = phi_5913_;
                                    phi_5914_ = _e4417;
                                    phi_5915_ = false;
                                    phi_5916_ = false;
                                } else {
                                    phi_5914_ = array<type_9, 4>();
                                    phi_5915_ = _e4288;
                                    phi_5916_ = _e4290;
                                }
                                let _e4419 = phi_5914_;
                                let _e4421 = phi_5915_;
                                let _e4423 = phi_5916_;
                                phi_5917_ = _e4419;
                                phi_5918_ = _e4274;
                                phi_5919_ = _e4276;
                                phi_5920_ = _e4278;
                                phi_5921_ = _e4280;
                                phi_5922_ = _e4282;
                                phi_5923_ = _e4284;
                                phi_5924_ = _e4286;
                                phi_5925_ = _e4421;
                                phi_5926_ = _e4423;
                                phi_5927_ = false;
                                phi_5928_ = false;
                                phi_5929_ = false;
                            } else {
                                phi_5917_ = array<type_9, 4>();
                                phi_5918_ = bool();
                                phi_5919_ = bool();
                                phi_5920_ = bool();
                                phi_5921_ = bool();
                                phi_5922_ = u32();
                                phi_5923_ = u32();
                                phi_5924_ = false;
                                phi_5925_ = false;
                                phi_5926_ = false;
                                phi_5927_ = _e4211;
                                phi_5928_ = _e4213;
                                phi_5929_ = _e4215;
                            }
                            let _e4425 = phi_5917_;
                            let _e4427 = phi_5918_;
                            let _e4429 = phi_5919_;
                            let _e4431 = phi_5920_;
                            let _e4433 = phi_5921_;
                            let _e4435 = phi_5922_;
                            let _e4437 = phi_5923_;
                            let _e4439 = phi_5924_;
                            let _e4441 = phi_5925_;
                            let _e4443 = phi_5926_;
                            let _e4445 = phi_5927_;
                            let _e4447 = phi_5928_;
                            let _e4449 = phi_5929_;
                            phi_2156_ = _e4425;
                            phi_2159_ = _e4427;
                            phi_2161_ = _e4429;
                            phi_2163_ = _e4431;
                            phi_2165_ = _e4433;
                            phi_2167_ = _e4201;
                            let _e5140 = local_124;
                            phi_2171_ = _e5140;
                            let _e5143 = local_125;
                            phi_2173_ = _e5143;
                            let _e5146 = local_126;
                            phi_2175_ = _e5146;
                            phi_2177_ = _e4435;
                            phi_2179_ = _e4437;
                            phi_5930_ = _e4205;
                            phi_5931_ = _e4207;
                            phi_5932_ = _e4439;
                            phi_5933_ = false;
                            phi_5934_ = _e4441;
                            phi_5935_ = _e4443;
                            phi_5936_ = _e4445;
                            phi_5937_ = _e4447;
                            phi_5938_ = _e4449;
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
                            phi_5930_ = bool();
                            phi_5931_ = type_17();
                            phi_5932_ = false;
                            phi_5933_ = true;
                            phi_5934_ = false;
                            phi_5935_ = false;
                            phi_5936_ = false;
                            phi_5937_ = false;
                            phi_5938_ = false;
                        }
                        let _e4451 = phi_2156_;
                        let _e4453 = phi_2159_;
                        let _e4455 = phi_2161_;
                        let _e4457 = phi_2163_;
                        let _e4459 = phi_2165_;
                        let _e4461 = phi_2167_;
                        let _e4463 = phi_2171_;
                        let _e4465 = phi_2173_;
                        let _e4467 = phi_2175_;
                        let _e4469 = phi_2177_;
                        let _e4471 = phi_2179_;
                        let _e4473 = phi_5930_;
                        let _e4475 = phi_5931_;
                        let _e4477 = phi_5932_;
                        let _e4479 = phi_5933_;
                        let _e4481 = phi_5934_;
                        let _e4483 = phi_5935_;
                        let _e4485 = phi_5936_;
                        let _e4487 = phi_5937_;
                        let _e4489 = phi_5938_;
                        local_98 = _e4479;
                        local_99 = _e4479;
                        local_100 = _e4479;
                        local_101 = _e4481;
                        local_102 = _e4479;
                        local_103 = _e4483;
                        local_104 = _e4479;
                        local_105 = _e4485;
                        local_106 = _e4479;
                        local_107 = _e4487;
                        local_108 = _e4479;
                        local_109 = _e4489;
                        local_110 = _e4473;
                        local_111 = _e4473;
                        local_112 = _e4475;
                        continue;
                        continuing {
                            phi_2155_ = _e4451;
                            phi_2158_ = _e4453;
                            phi_2160_ = _e4455;
                            phi_2162_ = _e4457;
                            phi_2164_ = _e4459;
                            phi_2166_ = _e4461;
                            phi_2170_ = _e4463;
                            phi_2172_ = _e4465;
                            phi_2174_ = _e4467;
                            phi_2176_ = _e4469;
                            phi_2178_ = _e4471;
                            break if !(_e4477);
                        }
                    }
                    let _e4493 = local_98;
                    let _e4498 = local_99;
                    let _e4501 = local_100;
                    let _e4503 = local_101;
                    let _e4504 = select(_e4503, false, _e4501);
                    let _e4506 = local_102;
                    let _e4508 = local_103;
                    let _e4511 = local_104;
                    let _e4513 = local_105;
                    let _e4516 = local_106;
                    let _e4518 = local_107;
                    let _e4521 = local_108;
                    let _e4523 = local_109;
                    let _e4525 = select(select(_e4508, false, _e4506), false, _e4504);
                    let _e4529 = select(_e4504, true, _e4525);
                    let _e4538 = select(select(select(select(_e4513, false, _e4511), false, _e4504), false, _e4525), false, _e4529);
                    if _e4538 {
                        let _e4542 = local_110;
                        let _e4547 = local_111;
                        phi_5980_ = type_9(select(2u, 3u, _e4542), select(type_9().member_1, type_9().member_1, _e4547));
                        phi_5981_ = false;
                        phi_5982_ = false;
                        phi_5983_ = false;
                    } else {
                        phi_5980_ = type_9();
                        phi_5981_ = select(select(select(select(_e4518, false, _e4516), false, _e4504), false, _e4525), false, _e4529);
                        phi_5982_ = select(select(select(select(_e4523, false, _e4521), false, _e4504), false, _e4525), false, _e4529);
                        phi_5983_ = _e4529;
                    }
                    let _e4551 = phi_5980_;
                    let _e4553 = phi_5981_;
                    let _e4555 = phi_5982_;
                    let _e4557 = phi_5983_;
                    let _e4563 = select(_e4555, false, _e4553);
                    let _e4567 = local_112;
                    let _e4571 = select(_e4553, true, _e4563);
                    let _e4578 = select(select(select(_e4538, false, _e4553), false, _e4563), true, _e4571);
                    let _e4582 = select(select(select(select(_e4557, false, _e4553), false, _e4563), false, _e4571), true, _e4578);
                    phi_6019_ = type_9(select(select(type_9().member, 2u, _e4493), select(select(type_9().member, 0u, _e4529), select(_e4551.member, select(select(type_9().member, 2u, _e4553), 1u, _e4563), _e4571), _e4578), _e4582), select(select(type_9().member_1, type_9().member_1, _e4498), select(select(type_9().member_1, type_9().member_1, _e4529), select(_e4551.member_1, select(select(type_9().member_1, type_9().member_1, _e4553), _e4567.member, _e4563), _e4571), _e4578), _e4582));
                }
                let _e4589 = phi_6019_;
                phi_6023_ = _e4589;
                phi_6024_ = type_9(_e179, _e182);
            } else {
                phi_6023_ = type_9(0u, u32());
                phi_6024_ = type_9(0u, 0u);
            }
            let _e4591 = phi_6023_;
            let _e4593 = phi_6024_;
            let _e4597 = params.member.member_2.member_1;
            switch bitcast<i32>(_e4591.member) {
                case 0: {
                    phi_6061_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                    phi_6062_ = false;
                    break;
                }
                case 1: {
                    if (_e4591.member_1 == 0u) {
                        phi_6058_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e4606 = select((bitcast<u32>(31i) - firstLeadingBit(_e4591.member_1)), 32u, (_e4591.member_1 == 0u));
                        let _e4611 = ((_e4591.member_1 << bitcast<u32>((_e4606 & 31u))) << bitcast<u32>(1i));
                        phi_6058_ = array<u32, 2>((_e4611 << bitcast<u32>(20i)), (((1023u - _e4606) << bitcast<u32>(20i)) | (_e4611 >> bitcast<u32>(12i))));
                    }
                    let _e4622 = phi_6058_;
                    phi_6061_ = type_26(0u, select(0u, 1u, (_e4591.member_1 > _e4597)), _e4622, true);
                    phi_6062_ = false;
                    break;
                }
                case 2: {
                    phi_6061_ = type_26();
                    phi_6062_ = true;
                    break;
                }
                case 3: {
                    phi_6061_ = type_26();
                    phi_6062_ = true;
                    break;
                }
                default: {
                    phi_6061_ = type_26();
                    phi_6062_ = bool();
                    break;
                }
            }
            let _e4625 = phi_6061_;
            let _e4627 = phi_6062_;
            if _e4627 {
                phi_6066_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
            } else {
                phi_6066_ = _e4625;
            }
            let _e4629 = phi_6066_;
            local_2 = type_26(_e4629.member, _e4629.member_1, array<u32, 2>(_e4629.member_2[0], _e4629.member_2[1]), _e4629.member_3);
            let _e4642 = global.member;
            if (bitcast<i32>(_e4591.member) == bitcast<i32>(_e4642)) {
                if (bitcast<i32>(_e4591.member) == 1i) {
                    let _e4649 = global.member;
                    if (bitcast<i32>(_e4649) == 1i) {
                        let _e4654 = global.member_1;
                        phi_6106_ = (_e4591.member_1 == _e4654);
                        phi_6107_ = false;
                    } else {
                        phi_6106_ = bool();
                        phi_6107_ = true;
                    }
                    let _e4657 = phi_6106_;
                    let _e4659 = phi_6107_;
                    phi_6108_ = _e4657;
                    phi_6109_ = _e4659;
                } else {
                    phi_6108_ = bool();
                    phi_6109_ = true;
                }
                let _e4661 = phi_6108_;
                let _e4663 = phi_6109_;
                phi_6114_ = select(_e4661, true, _e4663);
            } else {
                phi_6114_ = false;
            }
            let _e4666 = phi_6114_;
            let _e4671 = params.member.member_2.member.member;
            let _e4674 = local_2.member;
            let _e4675 = (_e4674 == 0u);
            let _e4680 = select(select(select((_e4671 > 0u), bool(), _e4666), bool(), _e4675), false, select(_e4666, true, _e4675));
            if _e4680 {
                local = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e4681 = local_2;
                local = _e4681;
            }
            let _e4683 = local.member;
            let _e4685 = select(true, false, (_e4683 == 0u));
            let _e4687 = local.member_3;
            if _e4687 {
                if _e4685 {
                    phi_6170_ = true;
                } else {
                    let _e4689 = params.member.member.member_1;
                    phi_6170_ = ((_e4689 & 16u) != 0u);
                }
                let _e4693 = phi_6170_;
                phi_6171_ = _e4693;
            } else {
                phi_6171_ = false;
            }
            let _e4695 = phi_6171_;
            let _e4697 = local.member_3;
            if _e4697 {
                if _e4685 {
                } else {
                    let _e4699 = local.member_2;
                    let _e4703 = (_e4699[1] >> bitcast<u32>(20i));
                    let _e4717 = atomicMin((&earliest.member[0u]), select(((((_e4703 - 896u) << bitcast<u32>(23i)) | ((_e4699[1] & 1048575u) << bitcast<u32>(3i))) | (_e4699[0] >> bitcast<u32>(29i))), 0u, (_e4703 <= 896u)));
                }
            }
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4695 {
                let _e4721 = atomicAdd((&counters[0u]), 1u);
                phi_6214_ = _e4721;
            } else {
                phi_6214_ = 0u;
            }
            let _e4723 = phi_6214_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e4726 = atomicLoad((&counters[0u]));
                if (_e4726 > 0u) {
                    let _e4729 = atomicAdd((&contacts.member[0u]), _e4726);
                    atomicStore((&counters[1u]), _e4729);
                }
            }
            workgroupBarrier();
            let _e4732 = atomicLoad((&counters[1u]));
            let _e4733 = (_e4732 + _e4723);
            if _e4695 {
                let _e4735 = params.member.member_1.member_3;
                if (_e4733 < _e4735) {
                    let _e4741 = (7u * _e4733);
                    atomicStore((&contacts.member[(4u + _e4741)]), select(1u, 0u, ((_e4593.member_1 & 2147483648u) == 0u)));
                    let _e4746 = local.member;
                    atomicStore((&contacts.member[(_e4741 + 5u)]), _e4746);
                    atomicStore((&contacts.member[(_e4741 + 6u)]), _e4593.member);
                    atomicStore((&contacts.member[(_e4741 + 7u)]), (_e4593.member_1 & 2147483647u));
                    let _e4755 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e4741 + 8u)]), _e4755);
                    let _e4760 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e4741 + 9u)]), _e4760);
                    let _e4764 = local.member_1;
                    atomicStore((&contacts.member[(_e4741 + 10u)]), _e4764);
                }
            }
            workgroupBarrier();
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4680 {
                let _e4769 = atomicAdd((&counters[0u]), 1u);
                phi_6296_ = _e4769;
            } else {
                phi_6296_ = 0u;
            }
            let _e4771 = phi_6296_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e4774 = atomicLoad((&counters[0u]));
                if (_e4774 > 0u) {
                    let _e4777 = atomicAdd((&left.member[0u]), _e4774);
                    atomicStore((&counters[1u]), _e4777);
                }
            }
            workgroupBarrier();
            let _e4780 = atomicLoad((&counters[1u]));
            let _e4781 = (_e4780 + _e4771);
            if _e4680 {
                if (_e4781 < _e4671) {
                    let _e4783 = (2u * _e4781);
                    atomicStore((&left.member[(4u + _e4783)]), _e4593.member);
                    atomicStore((&left.member[(_e4783 + 5u)]), _e4593.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_313_ = type_9(select(_e149.member, (_e149.member + 1u), _e152), select(_e149.member_1, _e149.member_1, _e152));
            break if !(_e165);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
