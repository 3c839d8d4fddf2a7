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

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_19 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_20 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_22 {
    member: array<type_20>,
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
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
@group(0) @binding(1) 
var<storage> paths: type_22;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(0) 
var<storage> params: type_30;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(7) 
var<storage, read_write> left: type_39;
@group(0) @binding(8) 
var<storage, read_write> earliest: type_39;
var<private> global: type_9 = type_9(2u, u32());

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: u32, param_3: u32, param_4: u32) -> type_9 {
    let _e11 = ((param_2 >> bitcast<u32>(31i)) != 0u);
    let _e18 = select(param_2, (~(param_2) + select(0u, 1u, (param_3 == 0u))), _e11);
    let _e19 = select(param_3, (~(param_3) + 1u), _e11);
    let _e21 = (_e18 >> bitcast<u32>(16i));
    let _e22 = (_e18 & 65535u);
    let _e24 = (param_4 >> bitcast<u32>(16i));
    let _e25 = (param_4 & 65535u);
    let _e30 = ((_e21 * _e25) + ((_e22 * _e25) >> bitcast<u32>(16i)));
    let _e41 = (_e18 * param_4);
    let _e43 = (_e19 >> bitcast<u32>(16i));
    let _e44 = (_e19 & 65535u);
    let _e46 = (param_4 >> bitcast<u32>(16i));
    let _e47 = (param_4 & 65535u);
    let _e52 = ((_e43 * _e47) + ((_e44 * _e47) >> bitcast<u32>(16i)));
    let _e64 = (_e41 + (((_e43 * _e46) + (_e52 >> bitcast<u32>(16i))) + (((_e44 * _e46) + (_e52 & 65535u)) >> bitcast<u32>(16i))));
    let _e72 = ((((((_e21 * _e24) + (_e30 >> bitcast<u32>(16i))) + (((_e22 * _e24) + (_e30 & 65535u)) >> bitcast<u32>(16i))) + select(0u, 1u, (_e64 < _e41))) << bitcast<u32>(1i)) | (_e64 >> bitcast<u32>(31i)));
    let _e77 = ((_e64 << bitcast<u32>(1i)) | ((_e19 * param_4) >> bitcast<u32>(31i)));
    let _e80 = ((param_2 >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e72, (~(_e72) + select(0u, 1u, (_e77 == 0u))), _e80), select(_e77, (~(_e77) + 1u), _e80));
}

fn function_2(param_5: array<type_9, 3>, param_6: u32) -> array<type_9, 2> {
    let _e17 = function_1(((param_5[1].member - param_5[0].member) - select(0u, 1u, (param_5[1].member_1 < param_5[0].member_1))), (param_5[1].member_1 - param_5[0].member_1), param_6);
    let _e20 = (param_5[0].member_1 + _e17.member_1);
    let _e38 = function_1(((param_5[2].member - param_5[1].member) - select(0u, 1u, (param_5[2].member_1 < param_5[1].member_1))), (param_5[2].member_1 - param_5[1].member_1), param_6);
    let _e41 = (param_5[1].member_1 + _e38.member_1);
    return array<type_9, 2>(type_9(((param_5[0].member + _e17.member) + select(0u, 1u, (_e20 < param_5[0].member_1))), _e20), type_9(((param_5[1].member + _e38.member) + select(0u, 1u, (_e41 < param_5[1].member_1))), _e41));
}

fn function_3(param_7: u32, param_8: u32, param_9: u32, param_10: u32) -> bool {
    return ((((param_9 - param_7) - select(0u, 1u, (param_10 < param_8))) >> bitcast<u32>(31i)) != 0u);
}

fn function_4(param_11: u32, param_12: u32, param_13: u32, param_14: u32) -> bool {
    return ((((param_13 - (~(param_11) + select(0u, 1u, (param_12 == 0u)))) - select(0u, 1u, (param_14 < (~(param_12) + 1u)))) >> bitcast<u32>(31i)) != 0u);
}

fn function_5(param_15: u32, param_16: u32, param_17: u32, param_18: u32) -> type_9 {
    let _e13 = ((param_15 >> bitcast<u32>(31i)) != 0u);
    let _e20 = select(param_15, (~(param_15) + select(0u, 1u, (param_16 == 0u))), _e13);
    let _e21 = select(param_16, (~(param_16) + 1u), _e13);
    let _e24 = ((param_17 >> bitcast<u32>(31i)) != 0u);
    let _e31 = select(param_17, (~(param_17) + select(0u, 1u, (param_18 == 0u))), _e24);
    let _e32 = select(param_18, (~(param_18) + 1u), _e24);
    let _e34 = (_e20 >> bitcast<u32>(16i));
    let _e35 = (_e20 & 65535u);
    let _e37 = (_e31 >> bitcast<u32>(16i));
    let _e38 = (_e31 & 65535u);
    let _e43 = ((_e34 * _e38) + ((_e35 * _e38) >> bitcast<u32>(16i)));
    let _e54 = (_e20 * _e31);
    let _e56 = (_e20 >> bitcast<u32>(16i));
    let _e57 = (_e20 & 65535u);
    let _e59 = (_e32 >> bitcast<u32>(16i));
    let _e60 = (_e32 & 65535u);
    let _e65 = ((_e56 * _e60) + ((_e57 * _e60) >> bitcast<u32>(16i)));
    let _e78 = (_e21 >> bitcast<u32>(16i));
    let _e79 = (_e21 & 65535u);
    let _e81 = (_e31 >> bitcast<u32>(16i));
    let _e82 = (_e31 & 65535u);
    let _e87 = ((_e78 * _e82) + ((_e79 * _e82) >> bitcast<u32>(16i)));
    let _e98 = (_e21 * _e31);
    let _e99 = ((_e20 * _e32) + _e98);
    let _e102 = (_e54 + (((_e56 * _e59) + (_e65 >> bitcast<u32>(16i))) + (((_e57 * _e59) + (_e65 & 65535u)) >> bitcast<u32>(16i))));
    let _e106 = (_e102 + (((_e78 * _e81) + (_e87 >> bitcast<u32>(16i))) + (((_e79 * _e81) + (_e87 & 65535u)) >> bitcast<u32>(16i))));
    let _e110 = (_e106 + select(0u, 1u, (_e99 < _e98)));
    let _e118 = ((_e110 << bitcast<u32>(2i)) | (_e99 >> bitcast<u32>(30i)));
    let _e123 = ((((((((_e34 * _e37) + (_e43 >> bitcast<u32>(16i))) + (((_e35 * _e37) + (_e43 & 65535u)) >> bitcast<u32>(16i))) + select(0u, 1u, (_e102 < _e54))) + select(0u, 1u, (_e106 < _e102))) + select(0u, 1u, (_e110 < _e106))) << bitcast<u32>(2i)) | (_e110 >> bitcast<u32>(30i)));
    let _e130 = (((param_15 >> bitcast<u32>(31i)) != 0u) != ((param_17 >> bitcast<u32>(31i)) != 0u));
    return type_9(select(_e123, (~(_e123) + select(0u, 1u, (_e118 == 0u))), _e130), select(_e118, (~(_e118) + 1u), _e130));
}

fn function_6(param_19: array<type_9, 2>, param_20: array<type_9, 2>) -> type_9 {
    let _e12 = function_5(param_19[0].member, param_19[0].member_1, param_20[1].member, param_20[1].member_1);
    let _e23 = function_5(param_19[1].member, param_19[1].member_1, param_20[0].member, param_20[0].member_1);
    return type_9(((_e12.member - _e23.member) - select(0u, 1u, (_e12.member_1 < _e23.member_1))), (_e12.member_1 - _e23.member_1));
}

fn function_7(param_21: f32, param_22: f32, param_23: f32) -> f32 {
    return (param_21 + ((param_22 - param_21) * param_23));
}

fn function_8(param_24: u32) -> type_9 {
    return type_9(0u, param_24);
}

fn function_9(param_25: u32, param_26: u32) -> type_9 {
    let _e4 = (param_26 + param_26);
    let _e9 = (_e4 + param_26);
    return type_9(((((param_25 + param_25) + select(0u, 1u, (_e4 < param_26))) + param_25) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_10(param_27: array<u32, 2>, param_28: i32) -> type_9 {
    var phi_9124_: type_9;
    var phi_9125_: type_9;
    var phi_9126_: type_9;
    var phi_9127_: type_9;
    var phi_9128_: type_9;
    var phi_9129_: bool;

    let _e24 = ((param_27[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_27[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_28);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_9128_ = type_9();
        phi_9129_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_9127_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_9126_ = type_9((param_27[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_9125_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_27[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_27[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_9124_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_27[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_9124_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_9124_;
                    phi_9125_ = _e67;
                }
                let _e83 = phi_9125_;
                phi_9126_ = _e83;
            }
            let _e89 = phi_9126_;
            phi_9127_ = _e89;
        }
        let _e91 = phi_9127_;
        phi_9128_ = _e91;
        phi_9129_ = _e37;
    }
    let _e93 = phi_9128_;
    let _e95 = phi_9129_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_27[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_11(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<type_9, 3>;
    var local_1: array<type_9, 3>;
    var local_2: array<type_9, 3>;
    var local_3: array<type_9, 3>;
    var local_4: array<type_9, 3>;
    var local_5: array<type_9, 3>;
    var local_6: array<type_9, 3>;
    var local_7: array<type_9, 3>;
    var local_8: array<type_9, 3>;
    var local_9: array<type_9, 3>;
    var local_10: array<type_9, 3>;
    var local_11: array<type_9, 3>;
    var local_12: array<type_9, 3>;
    var local_13: array<type_9, 3>;
    var local_14: array<type_9, 3>;
    var local_15: array<type_9, 3>;
    var local_16: array<type_9, 3>;
    var local_17: array<type_9, 3>;
    var local_18: array<type_9, 3>;
    var local_19: array<type_9, 3>;
    var local_20: array<type_9, 3>;
    var local_21: array<type_9, 3>;
    var local_22: array<type_9, 3>;
    var local_23: array<type_9, 3>;
    var local_24: array<type_9, 3>;
    var local_25: array<type_9, 3>;
    var local_26: array<type_9, 3>;
    var local_27: array<type_9, 3>;
    var local_28: array<type_9, 3>;
    var local_29: array<type_9, 3>;
    var local_30: array<type_9, 3>;
    var local_31: array<u32, 4>;
    var local_32: array<array<f32, 3>, 4>;
    var local_33: array<array<f32, 3>, 4>;
    var phi_300_: u32;
    var phi_346_: u32;
    var phi_349_: type_9;
    var phi_508_: type_19;
    var phi_922_: type_25;
    var phi_2625_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3172_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_4476_: array<type_9, 4>;
    var phi_4479_: bool;
    var phi_4481_: bool;
    var phi_4483_: bool;
    var phi_4485_: bool;
    var phi_4487_: type_18;
    var phi_4491_: u32;
    var phi_4493_: u32;
    var phi_4495_: u32;
    var phi_4497_: u32;
    var phi_4499_: u32;
    var phi_4508_: array<type_9, 4>;
    var phi_4511_: bool;
    var phi_4513_: bool;
    var phi_4517_: bool;
    var phi_4519_: bool;
    var phi_4521_: bool;
    var phi_4523_: bool;
    var phi_4525_: u32;
    var phi_4527_: u32;
    var phi_4529_: u32;
    var phi_4531_: u32;
    var phi_4533_: u32;
    var phi_4738_: bool;
    var phi_4739_: bool;
    var phi_4740_: bool;
    var phi_5382_: array<type_9, 4>;
    var phi_5383_: bool;
    var phi_5384_: u32;
    var phi_5385_: array<type_9, 4>;
    var phi_5386_: bool;
    var phi_5387_: bool;
    var phi_5389_: u32;
    var phi_5390_: u32;
    var phi_5391_: array<type_9, 4>;
    var phi_5392_: bool;
    var phi_5393_: bool;
    var phi_5395_: u32;
    var phi_5396_: u32;
    var phi_5397_: array<type_9, 4>;
    var phi_5398_: bool;
    var phi_5399_: bool;
    var phi_5401_: bool;
    var phi_5402_: bool;
    var phi_5403_: bool;
    var phi_5404_: bool;
    var phi_5405_: u32;
    var phi_5406_: u32;
    var phi_5407_: u32;
    var phi_5408_: u32;
    var phi_5409_: u32;
    var phi_5410_: bool;
    var phi_5411_: array<type_9, 4>;
    var phi_5412_: bool;
    var phi_5413_: bool;
    var phi_5415_: bool;
    var phi_5416_: bool;
    var phi_5417_: bool;
    var phi_5418_: bool;
    var phi_5419_: u32;
    var phi_5420_: u32;
    var phi_5421_: u32;
    var phi_5422_: u32;
    var phi_5423_: u32;
    var phi_5424_: bool;
    var phi_4509_: array<type_9, 4>;
    var phi_4512_: bool;
    var phi_4514_: bool;
    var phi_4518_: bool;
    var phi_4520_: bool;
    var phi_4522_: bool;
    var phi_4524_: bool;
    var phi_4526_: u32;
    var phi_4528_: u32;
    var phi_4530_: u32;
    var phi_4532_: u32;
    var phi_4534_: u32;
    var phi_5425_: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: array<type_9, 4>;
    var local_37: array<type_9, 4>;
    var local_38: array<type_9, 4>;
    var local_39: array<type_9, 4>;
    var local_40: array<type_9, 4>;
    var local_41: array<type_9, 4>;
    var local_42: array<type_9, 4>;
    var local_43: array<type_9, 4>;
    var local_44: array<type_9, 4>;
    var local_45: array<type_9, 4>;
    var local_46: array<type_9, 4>;
    var local_47: array<type_9, 4>;
    var local_48: u32;
    var local_49: u32;
    var local_50: u32;
    var local_51: u32;
    var local_52: array<type_9, 4>;
    var local_53: array<type_9, 4>;
    var local_54: array<type_9, 4>;
    var local_55: array<type_9, 4>;
    var local_56: array<type_9, 4>;
    var local_57: array<type_9, 4>;
    var local_58: bool;
    var local_59: bool;
    var local_60: u32;
    var local_61: bool;
    var local_62: u32;
    var local_63: array<type_9, 4>;
    var local_64: array<type_9, 4>;
    var local_65: array<type_9, 4>;
    var local_66: u32;
    var local_67: u32;
    var local_68: array<type_9, 4>;
    var local_69: array<type_9, 4>;
    var local_70: array<type_9, 4>;
    var phi_6009_: bool;
    var phi_6010_: bool;
    var phi_6011_: type_18;
    var phi_6012_: bool;
    var phi_6013_: type_18;
    var phi_6014_: bool;
    var phi_6015_: type_18;
    var phi_6016_: bool;
    var phi_6017_: type_18;
    var phi_6018_: bool;
    var phi_6019_: bool;
    var phi_6020_: type_18;
    var phi_6021_: bool;
    var local_71: u32;
    var local_72: u32;
    var local_73: array<type_9, 4>;
    var local_74: array<type_9, 4>;
    var local_75: array<type_9, 4>;
    var local_76: array<type_9, 4>;
    var local_77: array<type_9, 4>;
    var local_78: array<type_9, 4>;
    var local_79: array<type_9, 4>;
    var local_80: array<type_9, 4>;
    var phi_6062_: type_14;
    var phi_6065_: f32;
    var phi_6067_: f32;
    var phi_6069_: f32;
    var phi_6063_: type_14;
    var phi_6110_: type_15;
    var phi_6066_: f32;
    var phi_6068_: f32;
    var phi_6070_: f32;
    var local_81: f32;
    var local_82: u32;
    var local_83: u32;
    var local_84: u32;
    var phi_6528_: bool;
    var phi_6529_: bool;
    var phi_6530_: bool;
    var phi_6531_: type_18;
    var phi_6532_: type_18;
    var local_85: u32;
    var local_86: u32;
    var phi_6533_: bool;
    var phi_6534_: bool;
    var phi_6535_: bool;
    var phi_6536_: type_18;
    var phi_6537_: type_18;
    var phi_7684_: array<type_9, 2>;
    var phi_7713_: array<type_9, 2>;
    var phi_7742_: array<type_9, 2>;
    var phi_7756_: type_9;
    var phi_8078_: type_9;
    var phi_8079_: type_9;
    var phi_8080_: type_9;
    var phi_8081_: type_9;
    var phi_8195_: bool;
    var phi_8196_: bool;
    var phi_8197_: bool;
    var phi_8202_: u32;
    var phi_8203_: u32;
    var phi_8204_: bool;
    var phi_8205_: u32;
    var phi_8206_: bool;
    var phi_8207_: u32;
    var phi_8208_: bool;
    var phi_8213_: u32;
    var local_87: bool;
    var phi_8285_: bool;
    var phi_8286_: bool;
    var phi_8287_: bool;
    var phi_8288_: bool;
    var phi_8289_: bool;
    var phi_8296_: bool;
    var phi_8297_: bool;
    var phi_8298_: bool;
    var phi_8299_: bool;
    var phi_8300_: type_18;
    var phi_8301_: bool;
    var phi_8302_: bool;
    var phi_8303_: type_18;
    var phi_8304_: bool;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8307_: bool;
    var phi_8308_: bool;
    var phi_8309_: bool;
    var phi_8310_: bool;
    var phi_8311_: bool;
    var phi_8312_: type_18;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: type_18;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: bool;
    var phi_8319_: bool;
    var local_88: u32;
    var local_89: u32;
    var local_90: u32;
    var local_91: u32;
    var local_92: u32;
    var local_93: u32;
    var phi_8370_: u32;
    var phi_8371_: u32;
    var phi_8372_: bool;
    var phi_8373_: bool;
    var phi_8374_: u32;
    var phi_8375_: u32;
    var phi_8376_: bool;
    var phi_8377_: bool;
    var phi_8378_: bool;
    var phi_8379_: bool;
    var phi_8380_: u32;
    var phi_8381_: u32;
    var phi_8382_: bool;
    var phi_8383_: bool;
    var phi_8384_: bool;
    var phi_8651_: array<type_9, 4>;
    var phi_8652_: array<type_9, 4>;
    var phi_8653_: bool;
    var phi_8654_: bool;
    var phi_8655_: array<type_9, 4>;
    var phi_8656_: bool;
    var phi_8657_: bool;
    var phi_8658_: bool;
    var phi_8659_: bool;
    var phi_8660_: u32;
    var phi_8661_: u32;
    var phi_8662_: bool;
    var phi_8663_: bool;
    var phi_8664_: bool;
    var phi_8665_: bool;
    var phi_8666_: bool;
    var phi_8667_: bool;
    var phi_4477_: array<type_9, 4>;
    var phi_4480_: bool;
    var phi_4482_: bool;
    var phi_4484_: bool;
    var phi_4486_: bool;
    var phi_4488_: type_18;
    var phi_4492_: u32;
    var phi_4494_: u32;
    var phi_4496_: u32;
    var phi_4498_: u32;
    var phi_4500_: u32;
    var phi_8668_: bool;
    var phi_8669_: type_18;
    var phi_8670_: bool;
    var phi_8671_: bool;
    var phi_8672_: bool;
    var phi_8673_: bool;
    var phi_8674_: bool;
    var phi_8675_: bool;
    var phi_8676_: bool;
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
    var local_107: bool;
    var phi_8718_: type_9;
    var phi_8719_: bool;
    var phi_8720_: bool;
    var phi_8721_: bool;
    var local_108: type_18;
    var phi_8757_: type_9;
    var phi_8761_: type_9;
    var phi_8762_: type_9;
    var phi_8797_: array<u32, 2>;
    var phi_8803_: type_26;
    var phi_8804_: bool;
    var phi_8808_: type_26;
    var phi_8839_: u32;
    var phi_8861_: u32;
    var phi_8927_: u32;
    var phi_8991_: bool;
    var phi_8992_: bool;
    var phi_8993_: bool;
    var phi_8994_: bool;
    var phi_8999_: bool;
    var phi_9010_: u32;
    var local_109: bool;
    var local_110: bool;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var local_116: u32;
    var local_117: u32;
    var local_118: array<type_9, 4>;
    var local_119: u32;
    var local_120: u32;
    var local_121: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e113 = id_2;
    let _e114 = n_2;
    let _e115 = lane_2;
    let _e129 = ((_e113.y * _e114.x) + _e113.x);
    let _e132 = (_e114.x * _e114.y);
    let _e135 = params.member.member_1.member_2;
    let _e137 = input.member[0u];
    let _e139 = select(_e137, _e135, (_e135 < _e137));
    let _e141 = params.member.member_1.member_1;
    if (_e139 > _e141) {
        let _e144 = params.member.member_1.member_1;
        phi_300_ = (_e139 - _e144);
    } else {
        phi_300_ = 0u;
    }
    let _e147 = phi_300_;
    let _e149 = params.member.member_1.member;
    let _e151 = select(_e147, _e149, (_e149 < _e147));
    let _e153 = (_e151 / 64u);
    let _e157 = select(_e153, (_e153 + 1u), ((_e151 % 64u) > 0u));
    if (_e157 > _e129) {
        let _e159 = (_e157 - _e129);
        if (_e132 == 0u) {
            return;
        }
        let _e161 = (_e159 / _e132);
        if (_e132 == 0u) {
            return;
        }
        phi_346_ = select(_e161, (_e161 + 1u), ((_e159 % _e132) > 0u));
    } else {
        phi_346_ = 0u;
    }
    let _e168 = phi_346_;
    phi_349_ = type_9(0u, _e168);
    loop {
        let _e171 = phi_349_;
        let _e174 = (_e171.member < _e171.member_1);
        let _e187 = (bitcast<i32>(select(0u, 1u, _e174)) != 0i);
        if _e187 {
            let _e191 = (((_e129 + (select(type_9().member_1, _e171.member, _e174) * _e132)) * 64u) + _e115);
            if (_e191 < _e151) {
                let _e196 = params.member.member_1.member_1;
                let _e198 = (2u * (_e196 + _e191));
                let _e201 = input.member[(4u + _e198)];
                let _e204 = input.member[(_e198 + 5u)];
                let _e210 = params.member.member_2.member.member;
                if (_e210 == 0u) {
                    let _e226 = (3u * _e204);
                    let _e228 = elements.member[_e226];
                    let _e231 = elements.member[(_e226 + 1u)];
                    let _e234 = elements.member[(_e226 + 2u)];
                    phi_508_ = type_19(0u, array<u32, 4>(_e201, _e228, _e231, _e234));
                } else {
                    let _e212 = (2u * _e201);
                    let _e213 = (2u * _e204);
                    let _e215 = elements.member[_e212];
                    let _e217 = elements.member[_e213];
                    let _e220 = elements.member[(_e212 + 1u)];
                    let _e223 = elements.member[(_e213 + 1u)];
                    phi_508_ = type_19(1u, array<u32, 4>(_e215, _e220, _e217, _e223));
                }
                let _e238 = phi_508_;
                local_31 = array<u32, 4>(_e238.member_1[0], _e238.member_1[1], _e238.member_1[2], _e238.member_1[3]);
                let _e247 = paths.member[_e238.member_1[0]];
                let _e261 = paths.member[_e238.member_1[1]];
                let _e275 = paths.member[_e238.member_1[2]];
                let _e289 = paths.member[_e238.member_1[3]];
                local_32 = array<array<f32, 3>, 4>(array<f32, 3>(_e247.member.x, _e247.member.y, _e247.member.z), array<f32, 3>(_e261.member.x, _e261.member.y, _e261.member.z), array<f32, 3>(_e275.member.x, _e275.member.y, _e275.member.z), array<f32, 3>(_e289.member.x, _e289.member.y, _e289.member.z));
                local_33 = array<array<f32, 3>, 4>(array<f32, 3>(_e247.member_1.x, _e247.member_1.y, _e247.member_1.z), array<f32, 3>(_e261.member_1.x, _e261.member_1.y, _e261.member_1.z), array<f32, 3>(_e275.member_1.x, _e275.member_1.y, _e275.member_1.z), array<f32, 3>(_e289.member_1.x, _e289.member_1.y, _e289.member_1.z));
                let _e313 = params.member.member.member_4;
                if (_e238.member != 0u) {
                    let _e404 = local_32;
                    let _e409 = local_32;
                    let _e418 = local_33;
                    let _e423 = local_33;
                    let _e433 = local_32;
                    let _e438 = local_32;
                    let _e447 = local_33;
                    let _e452 = local_33;
                    let _e462 = local_32;
                    let _e467 = local_32;
                    let _e476 = local_33;
                    let _e481 = local_33;
                    phi_922_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e404[2][0] - _e409[0][0]), (_e404[2][1] - _e409[0][1]), (_e404[2][2] - _e409[0][2])), array<f32, 3>((_e418[2][0] - _e423[0][0]), (_e418[2][1] - _e423[0][1]), (_e418[2][2] - _e423[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e433[1][0] - _e438[0][0]), (_e433[1][1] - _e438[0][1]), (_e433[1][2] - _e438[0][2])), array<f32, 3>((_e447[1][0] - _e452[0][0]), (_e447[1][1] - _e452[0][1]), (_e447[1][2] - _e452[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e462[2][0] - _e467[3][0]), (_e462[2][1] - _e467[3][1]), (_e462[2][2] - _e467[3][2])), array<f32, 3>((_e476[2][0] - _e481[3][0]), (_e476[2][1] - _e481[3][1]), (_e476[2][2] - _e481[3][2]))), (_e313 + _e313));
                } else {
                    let _e315 = local_32;
                    let _e320 = local_32;
                    let _e329 = local_33;
                    let _e334 = local_33;
                    let _e344 = local_32;
                    let _e349 = local_32;
                    let _e358 = local_33;
                    let _e363 = local_33;
                    let _e373 = local_32;
                    let _e378 = local_32;
                    let _e387 = local_33;
                    let _e392 = local_33;
                    phi_922_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e315[0][0] - _e320[1][0]), (_e315[0][1] - _e320[1][1]), (_e315[0][2] - _e320[1][2])), array<f32, 3>((_e329[0][0] - _e334[1][0]), (_e329[0][1] - _e334[1][1]), (_e329[0][2] - _e334[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e344[2][0] - _e349[1][0]), (_e344[2][1] - _e349[1][1]), (_e344[2][2] - _e349[1][2])), array<f32, 3>((_e358[2][0] - _e363[1][0]), (_e358[2][1] - _e363[1][1]), (_e358[2][2] - _e363[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e373[3][0] - _e378[1][0]), (_e373[3][1] - _e378[1][1]), (_e373[3][2] - _e378[1][2])), array<f32, 3>((_e387[3][0] - _e392[1][0]), (_e387[3][1] - _e392[1][1]), (_e387[3][2] - _e392[1][2]))), (_e313 + _e313));
                }
                let _e494 = phi_922_;
                let _e500 = select(_e494.member[0][0], -(_e494.member[0][0]), (_e494.member[0][0] < 0f));
                let _e504 = select(_e494.member[0][1], -(_e494.member[0][1]), (_e494.member[0][1] < 0f));
                let _e506 = select(_e504, _e500, (_e500 > _e504));
                let _e510 = select(_e494.member[0][2], -(_e494.member[0][2]), (_e494.member[0][2] < 0f));
                let _e512 = select(_e510, _e506, (_e506 > _e510));
                let _e518 = select(_e494.member[1][0], -(_e494.member[1][0]), (_e494.member[1][0] < 0f));
                let _e522 = select(_e494.member[1][1], -(_e494.member[1][1]), (_e494.member[1][1] < 0f));
                let _e524 = select(_e522, _e518, (_e518 > _e522));
                let _e528 = select(_e494.member[1][2], -(_e494.member[1][2]), (_e494.member[1][2] < 0f));
                let _e530 = select(_e528, _e524, (_e524 > _e528));
                let _e540 = select(_e494.member_1[0][0], -(_e494.member_1[0][0]), (_e494.member_1[0][0] < 0f));
                let _e544 = select(_e494.member_1[0][1], -(_e494.member_1[0][1]), (_e494.member_1[0][1] < 0f));
                let _e546 = select(_e544, _e540, (_e540 > _e544));
                let _e550 = select(_e494.member_1[0][2], -(_e494.member_1[0][2]), (_e494.member_1[0][2] < 0f));
                let _e552 = select(_e550, _e546, (_e546 > _e550));
                let _e558 = select(_e494.member_1[1][0], -(_e494.member_1[1][0]), (_e494.member_1[1][0] < 0f));
                let _e562 = select(_e494.member_1[1][1], -(_e494.member_1[1][1]), (_e494.member_1[1][1] < 0f));
                let _e564 = select(_e562, _e558, (_e558 > _e562));
                let _e568 = select(_e494.member_1[1][2], -(_e494.member_1[1][2]), (_e494.member_1[1][2] < 0f));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e580 = select(_e494.member_2[0][0], -(_e494.member_2[0][0]), (_e494.member_2[0][0] < 0f));
                let _e584 = select(_e494.member_2[0][1], -(_e494.member_2[0][1]), (_e494.member_2[0][1] < 0f));
                let _e586 = select(_e584, _e580, (_e580 > _e584));
                let _e590 = select(_e494.member_2[0][2], -(_e494.member_2[0][2]), (_e494.member_2[0][2] < 0f));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e598 = select(_e494.member_2[1][0], -(_e494.member_2[1][0]), (_e494.member_2[1][0] < 0f));
                let _e602 = select(_e494.member_2[1][1], -(_e494.member_2[1][1]), (_e494.member_2[1][1] < 0f));
                let _e604 = select(_e602, _e598, (_e598 > _e602));
                let _e608 = select(_e494.member_2[1][2], -(_e494.member_2[1][2]), (_e494.member_2[1][2] < 0f));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e615 = function_((select(_e530, _e512, (_e512 > _e530)) + _e494.member_3), (select(_e570, _e552, (_e552 > _e570)) + _e494.member_3));
                let _e616 = function_(_e615, (select(_e610, _e592, (_e592 > _e610)) + _e494.member_3));
                let _e621 = bitcast<i32>(((bitcast<u32>(_e616) + 4u) >> bitcast<u32>(23i)));
                let _e622 = (_e621 >= 64i);
                let _e623 = (_e621 <= 190i);
                let _e629 = select(select(i32(), select(i32(), (_e621 - 126i), _e623), _e622), 2147483647i, select(true, select(true, false, _e623), _e622));
                if (_e629 == 2147483647i) {
                    phi_8757_ = type_9(2u, type_9().member_1);
                } else {
                    let _e632 = params.member.member.member_1;
                    if ((_e632 & 8u) != 0u) {
                        let _e872 = local_32;
                        let _e877 = bitcast<u32>(_e872[0][0]);
                        let _e878 = (_e877 & 2147483647u);
                        let _e879 = (_e878 < 8388608u);
                        let _e890 = function_10(array<u32, 2>(select((_e877 << bitcast<u32>(29i)), 0u, _e879), select(((_e877 ^ _e878) | ((_e878 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e879)), _e629);
                        let _e891 = bitcast<u32>(_e872[0][1]);
                        let _e892 = (_e891 & 2147483647u);
                        let _e893 = (_e892 < 8388608u);
                        let _e904 = function_10(array<u32, 2>(select((_e891 << bitcast<u32>(29i)), 0u, _e893), select(((_e891 ^ _e892) | ((_e892 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e893)), _e629);
                        let _e905 = bitcast<u32>(_e872[0][2]);
                        let _e906 = (_e905 & 2147483647u);
                        let _e907 = (_e906 < 8388608u);
                        let _e918 = function_10(array<u32, 2>(select((_e905 << bitcast<u32>(29i)), 0u, _e907), select(((_e905 ^ _e906) | ((_e906 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e907)), _e629);
                        let _e920 = local_33;
                        let _e925 = bitcast<u32>(_e920[0][0]);
                        let _e926 = (_e925 & 2147483647u);
                        let _e927 = (_e926 < 8388608u);
                        let _e938 = function_10(array<u32, 2>(select((_e925 << bitcast<u32>(29i)), 0u, _e927), select(((_e925 ^ _e926) | ((_e926 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e927)), _e629);
                        let _e939 = bitcast<u32>(_e920[0][1]);
                        let _e940 = (_e939 & 2147483647u);
                        let _e941 = (_e940 < 8388608u);
                        let _e952 = function_10(array<u32, 2>(select((_e939 << bitcast<u32>(29i)), 0u, _e941), select(((_e939 ^ _e940) | ((_e940 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e941)), _e629);
                        let _e953 = bitcast<u32>(_e920[0][2]);
                        let _e954 = (_e953 & 2147483647u);
                        let _e955 = (_e954 < 8388608u);
                        let _e966 = function_10(array<u32, 2>(select((_e953 << bitcast<u32>(29i)), 0u, _e955), select(((_e953 ^ _e954) | ((_e954 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e955)), _e629);
                        let _e969 = local_32;
                        let _e974 = bitcast<u32>(_e969[1][0]);
                        let _e975 = (_e974 & 2147483647u);
                        let _e976 = (_e975 < 8388608u);
                        let _e987 = function_10(array<u32, 2>(select((_e974 << bitcast<u32>(29i)), 0u, _e976), select(((_e974 ^ _e975) | ((_e975 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e976)), _e629);
                        let _e988 = bitcast<u32>(_e969[1][1]);
                        let _e989 = (_e988 & 2147483647u);
                        let _e990 = (_e989 < 8388608u);
                        let _e1001 = function_10(array<u32, 2>(select((_e988 << bitcast<u32>(29i)), 0u, _e990), select(((_e988 ^ _e989) | ((_e989 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e990)), _e629);
                        let _e1002 = bitcast<u32>(_e969[1][2]);
                        let _e1003 = (_e1002 & 2147483647u);
                        let _e1004 = (_e1003 < 8388608u);
                        let _e1015 = function_10(array<u32, 2>(select((_e1002 << bitcast<u32>(29i)), 0u, _e1004), select(((_e1002 ^ _e1003) | ((_e1003 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1004)), _e629);
                        let _e1017 = local_33;
                        let _e1022 = bitcast<u32>(_e1017[1][0]);
                        let _e1023 = (_e1022 & 2147483647u);
                        let _e1024 = (_e1023 < 8388608u);
                        let _e1035 = function_10(array<u32, 2>(select((_e1022 << bitcast<u32>(29i)), 0u, _e1024), select(((_e1022 ^ _e1023) | ((_e1023 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1024)), _e629);
                        let _e1036 = bitcast<u32>(_e1017[1][1]);
                        let _e1037 = (_e1036 & 2147483647u);
                        let _e1038 = (_e1037 < 8388608u);
                        let _e1049 = function_10(array<u32, 2>(select((_e1036 << bitcast<u32>(29i)), 0u, _e1038), select(((_e1036 ^ _e1037) | ((_e1037 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1038)), _e629);
                        let _e1050 = bitcast<u32>(_e1017[1][2]);
                        let _e1051 = (_e1050 & 2147483647u);
                        let _e1052 = (_e1051 < 8388608u);
                        let _e1063 = function_10(array<u32, 2>(select((_e1050 << bitcast<u32>(29i)), 0u, _e1052), select(((_e1050 ^ _e1051) | ((_e1051 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1052)), _e629);
                        let _e1066 = local_32;
                        let _e1071 = bitcast<u32>(_e1066[2][0]);
                        let _e1072 = (_e1071 & 2147483647u);
                        let _e1073 = (_e1072 < 8388608u);
                        let _e1084 = function_10(array<u32, 2>(select((_e1071 << bitcast<u32>(29i)), 0u, _e1073), select(((_e1071 ^ _e1072) | ((_e1072 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1073)), _e629);
                        let _e1085 = bitcast<u32>(_e1066[2][1]);
                        let _e1086 = (_e1085 & 2147483647u);
                        let _e1087 = (_e1086 < 8388608u);
                        let _e1098 = function_10(array<u32, 2>(select((_e1085 << bitcast<u32>(29i)), 0u, _e1087), select(((_e1085 ^ _e1086) | ((_e1086 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1087)), _e629);
                        let _e1099 = bitcast<u32>(_e1066[2][2]);
                        let _e1100 = (_e1099 & 2147483647u);
                        let _e1101 = (_e1100 < 8388608u);
                        let _e1112 = function_10(array<u32, 2>(select((_e1099 << bitcast<u32>(29i)), 0u, _e1101), select(((_e1099 ^ _e1100) | ((_e1100 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1101)), _e629);
                        let _e1114 = local_33;
                        let _e1119 = bitcast<u32>(_e1114[2][0]);
                        let _e1120 = (_e1119 & 2147483647u);
                        let _e1121 = (_e1120 < 8388608u);
                        let _e1132 = function_10(array<u32, 2>(select((_e1119 << bitcast<u32>(29i)), 0u, _e1121), select(((_e1119 ^ _e1120) | ((_e1120 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1121)), _e629);
                        let _e1133 = bitcast<u32>(_e1114[2][1]);
                        let _e1134 = (_e1133 & 2147483647u);
                        let _e1135 = (_e1134 < 8388608u);
                        let _e1146 = function_10(array<u32, 2>(select((_e1133 << bitcast<u32>(29i)), 0u, _e1135), select(((_e1133 ^ _e1134) | ((_e1134 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1135)), _e629);
                        let _e1147 = bitcast<u32>(_e1114[2][2]);
                        let _e1148 = (_e1147 & 2147483647u);
                        let _e1149 = (_e1148 < 8388608u);
                        let _e1160 = function_10(array<u32, 2>(select((_e1147 << bitcast<u32>(29i)), 0u, _e1149), select(((_e1147 ^ _e1148) | ((_e1148 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1149)), _e629);
                        let _e1163 = local_32;
                        let _e1168 = bitcast<u32>(_e1163[3][0]);
                        let _e1169 = (_e1168 & 2147483647u);
                        let _e1170 = (_e1169 < 8388608u);
                        let _e1181 = function_10(array<u32, 2>(select((_e1168 << bitcast<u32>(29i)), 0u, _e1170), select(((_e1168 ^ _e1169) | ((_e1169 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1170)), _e629);
                        let _e1182 = bitcast<u32>(_e1163[3][1]);
                        let _e1183 = (_e1182 & 2147483647u);
                        let _e1184 = (_e1183 < 8388608u);
                        let _e1195 = function_10(array<u32, 2>(select((_e1182 << bitcast<u32>(29i)), 0u, _e1184), select(((_e1182 ^ _e1183) | ((_e1183 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1184)), _e629);
                        let _e1196 = bitcast<u32>(_e1163[3][2]);
                        let _e1197 = (_e1196 & 2147483647u);
                        let _e1198 = (_e1197 < 8388608u);
                        let _e1209 = function_10(array<u32, 2>(select((_e1196 << bitcast<u32>(29i)), 0u, _e1198), select(((_e1196 ^ _e1197) | ((_e1197 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1198)), _e629);
                        let _e1211 = local_33;
                        let _e1216 = bitcast<u32>(_e1211[3][0]);
                        let _e1217 = (_e1216 & 2147483647u);
                        let _e1218 = (_e1217 < 8388608u);
                        let _e1229 = function_10(array<u32, 2>(select((_e1216 << bitcast<u32>(29i)), 0u, _e1218), select(((_e1216 ^ _e1217) | ((_e1217 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1218)), _e629);
                        let _e1230 = bitcast<u32>(_e1211[3][1]);
                        let _e1231 = (_e1230 & 2147483647u);
                        let _e1232 = (_e1231 < 8388608u);
                        let _e1243 = function_10(array<u32, 2>(select((_e1230 << bitcast<u32>(29i)), 0u, _e1232), select(((_e1230 ^ _e1231) | ((_e1231 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1232)), _e629);
                        let _e1244 = bitcast<u32>(_e1211[3][2]);
                        let _e1245 = (_e1244 & 2147483647u);
                        let _e1246 = (_e1245 < 8388608u);
                        let _e1257 = function_10(array<u32, 2>(select((_e1244 << bitcast<u32>(29i)), 0u, _e1246), select(((_e1244 ^ _e1245) | ((_e1245 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1246)), _e629);
                        phi_2625_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e890, _e904, _e918), array<type_9, 3>(_e938, _e952, _e966)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e987, _e1001, _e1015), array<type_9, 3>(_e1035, _e1049, _e1063)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1084, _e1098, _e1112), array<type_9, 3>(_e1132, _e1146, _e1160)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1181, _e1195, _e1209), array<type_9, 3>(_e1229, _e1243, _e1257)));
                    } else {
                        let _e637 = params.member.member.member_10[1u];
                        let _e642 = (_e629 - (bitcast<i32>((_e637 >> bitcast<u32>(20i))) - 1023i));
                        let _e643 = local_31;
                        let _e647 = params.member.member.member[0u];
                        let _e649 = (6u * (_e647 + _e643[0]));
                        let _e650 = (6u * _e643[0]);
                        let _e652 = positions.member[_e650];
                        let _e655 = positions.member[(_e650 + 1u)];
                        let _e657 = function_10(array<u32, 2>(_e652, _e655), _e642);
                        let _e660 = positions.member[(_e650 + 2u)];
                        let _e663 = positions.member[(_e650 + 3u)];
                        let _e665 = function_10(array<u32, 2>(_e660, _e663), _e642);
                        let _e668 = positions.member[(_e650 + 4u)];
                        let _e671 = positions.member[(_e650 + 5u)];
                        let _e673 = function_10(array<u32, 2>(_e668, _e671), _e642);
                        let _e676 = positions.member[_e649];
                        let _e679 = positions.member[(_e649 + 1u)];
                        let _e681 = function_10(array<u32, 2>(_e676, _e679), _e642);
                        let _e684 = positions.member[(_e649 + 2u)];
                        let _e687 = positions.member[(_e649 + 3u)];
                        let _e689 = function_10(array<u32, 2>(_e684, _e687), _e642);
                        let _e692 = positions.member[(_e649 + 4u)];
                        let _e695 = positions.member[(_e649 + 5u)];
                        let _e697 = function_10(array<u32, 2>(_e692, _e695), _e642);
                        let _e700 = local_31;
                        let _e704 = params.member.member.member[0u];
                        let _e706 = (6u * (_e704 + _e700[1]));
                        let _e707 = (6u * _e700[1]);
                        let _e709 = positions.member[_e707];
                        let _e712 = positions.member[(_e707 + 1u)];
                        let _e714 = function_10(array<u32, 2>(_e709, _e712), _e642);
                        let _e717 = positions.member[(_e707 + 2u)];
                        let _e720 = positions.member[(_e707 + 3u)];
                        let _e722 = function_10(array<u32, 2>(_e717, _e720), _e642);
                        let _e725 = positions.member[(_e707 + 4u)];
                        let _e728 = positions.member[(_e707 + 5u)];
                        let _e730 = function_10(array<u32, 2>(_e725, _e728), _e642);
                        let _e733 = positions.member[_e706];
                        let _e736 = positions.member[(_e706 + 1u)];
                        let _e738 = function_10(array<u32, 2>(_e733, _e736), _e642);
                        let _e741 = positions.member[(_e706 + 2u)];
                        let _e744 = positions.member[(_e706 + 3u)];
                        let _e746 = function_10(array<u32, 2>(_e741, _e744), _e642);
                        let _e749 = positions.member[(_e706 + 4u)];
                        let _e752 = positions.member[(_e706 + 5u)];
                        let _e754 = function_10(array<u32, 2>(_e749, _e752), _e642);
                        let _e757 = local_31;
                        let _e761 = params.member.member.member[0u];
                        let _e763 = (6u * (_e761 + _e757[2]));
                        let _e764 = (6u * _e757[2]);
                        let _e766 = positions.member[_e764];
                        let _e769 = positions.member[(_e764 + 1u)];
                        let _e771 = function_10(array<u32, 2>(_e766, _e769), _e642);
                        let _e774 = positions.member[(_e764 + 2u)];
                        let _e777 = positions.member[(_e764 + 3u)];
                        let _e779 = function_10(array<u32, 2>(_e774, _e777), _e642);
                        let _e782 = positions.member[(_e764 + 4u)];
                        let _e785 = positions.member[(_e764 + 5u)];
                        let _e787 = function_10(array<u32, 2>(_e782, _e785), _e642);
                        let _e790 = positions.member[_e763];
                        let _e793 = positions.member[(_e763 + 1u)];
                        let _e795 = function_10(array<u32, 2>(_e790, _e793), _e642);
                        let _e798 = positions.member[(_e763 + 2u)];
                        let _e801 = positions.member[(_e763 + 3u)];
                        let _e803 = function_10(array<u32, 2>(_e798, _e801), _e642);
                        let _e806 = positions.member[(_e763 + 4u)];
                        let _e809 = positions.member[(_e763 + 5u)];
                        let _e811 = function_10(array<u32, 2>(_e806, _e809), _e642);
                        let _e814 = local_31;
                        let _e818 = params.member.member.member[0u];
                        let _e820 = (6u * (_e818 + _e814[3]));
                        let _e821 = (6u * _e814[3]);
                        let _e823 = positions.member[_e821];
                        let _e826 = positions.member[(_e821 + 1u)];
                        let _e828 = function_10(array<u32, 2>(_e823, _e826), _e642);
                        let _e831 = positions.member[(_e821 + 2u)];
                        let _e834 = positions.member[(_e821 + 3u)];
                        let _e836 = function_10(array<u32, 2>(_e831, _e834), _e642);
                        let _e839 = positions.member[(_e821 + 4u)];
                        let _e842 = positions.member[(_e821 + 5u)];
                        let _e844 = function_10(array<u32, 2>(_e839, _e842), _e642);
                        let _e847 = positions.member[_e820];
                        let _e850 = positions.member[(_e820 + 1u)];
                        let _e852 = function_10(array<u32, 2>(_e847, _e850), _e642);
                        let _e855 = positions.member[(_e820 + 2u)];
                        let _e858 = positions.member[(_e820 + 3u)];
                        let _e860 = function_10(array<u32, 2>(_e855, _e858), _e642);
                        let _e863 = positions.member[(_e820 + 4u)];
                        let _e866 = positions.member[(_e820 + 5u)];
                        let _e868 = function_10(array<u32, 2>(_e863, _e866), _e642);
                        phi_2625_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e657, _e665, _e673), array<type_9, 3>(_e681, _e689, _e697)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e714, _e722, _e730), array<type_9, 3>(_e738, _e746, _e754)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e771, _e779, _e787), array<type_9, 3>(_e795, _e803, _e811)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e828, _e836, _e844), array<type_9, 3>(_e852, _e860, _e868)));
                    }
                    let _e1262 = phi_2625_;
                    let _e1264 = params.member.member_2.member_1;
                    let _e1266 = params.member.member_2.member_2;
                    let _e1268 = params.member.member_2.member_3;
                    if (_e238.member != 0u) {
                        phi_3172_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[2][0][0].member - _e1262[0][0][0].member) - select(0u, 1u, (_e1262[2][0][0].member_1 < _e1262[0][0][0].member_1))), (_e1262[2][0][0].member_1 - _e1262[0][0][0].member_1)), type_9(((_e1262[2][0][1].member - _e1262[0][0][1].member) - select(0u, 1u, (_e1262[2][0][1].member_1 < _e1262[0][0][1].member_1))), (_e1262[2][0][1].member_1 - _e1262[0][0][1].member_1)), type_9(((_e1262[2][0][2].member - _e1262[0][0][2].member) - select(0u, 1u, (_e1262[2][0][2].member_1 < _e1262[0][0][2].member_1))), (_e1262[2][0][2].member_1 - _e1262[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[2][1][0].member - _e1262[0][1][0].member) - select(0u, 1u, (_e1262[2][1][0].member_1 < _e1262[0][1][0].member_1))), (_e1262[2][1][0].member_1 - _e1262[0][1][0].member_1)), type_9(((_e1262[2][1][1].member - _e1262[0][1][1].member) - select(0u, 1u, (_e1262[2][1][1].member_1 < _e1262[0][1][1].member_1))), (_e1262[2][1][1].member_1 - _e1262[0][1][1].member_1)), type_9(((_e1262[2][1][2].member - _e1262[0][1][2].member) - select(0u, 1u, (_e1262[2][1][2].member_1 < _e1262[0][1][2].member_1))), (_e1262[2][1][2].member_1 - _e1262[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[1][0][0].member - _e1262[0][0][0].member) - select(0u, 1u, (_e1262[1][0][0].member_1 < _e1262[0][0][0].member_1))), (_e1262[1][0][0].member_1 - _e1262[0][0][0].member_1)), type_9(((_e1262[1][0][1].member - _e1262[0][0][1].member) - select(0u, 1u, (_e1262[1][0][1].member_1 < _e1262[0][0][1].member_1))), (_e1262[1][0][1].member_1 - _e1262[0][0][1].member_1)), type_9(((_e1262[1][0][2].member - _e1262[0][0][2].member) - select(0u, 1u, (_e1262[1][0][2].member_1 < _e1262[0][0][2].member_1))), (_e1262[1][0][2].member_1 - _e1262[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[1][1][0].member - _e1262[0][1][0].member) - select(0u, 1u, (_e1262[1][1][0].member_1 < _e1262[0][1][0].member_1))), (_e1262[1][1][0].member_1 - _e1262[0][1][0].member_1)), type_9(((_e1262[1][1][1].member - _e1262[0][1][1].member) - select(0u, 1u, (_e1262[1][1][1].member_1 < _e1262[0][1][1].member_1))), (_e1262[1][1][1].member_1 - _e1262[0][1][1].member_1)), type_9(((_e1262[1][1][2].member - _e1262[0][1][2].member) - select(0u, 1u, (_e1262[1][1][2].member_1 < _e1262[0][1][2].member_1))), (_e1262[1][1][2].member_1 - _e1262[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[2][0][0].member - _e1262[3][0][0].member) - select(0u, 1u, (_e1262[2][0][0].member_1 < _e1262[3][0][0].member_1))), (_e1262[2][0][0].member_1 - _e1262[3][0][0].member_1)), type_9(((_e1262[2][0][1].member - _e1262[3][0][1].member) - select(0u, 1u, (_e1262[2][0][1].member_1 < _e1262[3][0][1].member_1))), (_e1262[2][0][1].member_1 - _e1262[3][0][1].member_1)), type_9(((_e1262[2][0][2].member - _e1262[3][0][2].member) - select(0u, 1u, (_e1262[2][0][2].member_1 < _e1262[3][0][2].member_1))), (_e1262[2][0][2].member_1 - _e1262[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[2][1][0].member - _e1262[3][1][0].member) - select(0u, 1u, (_e1262[2][1][0].member_1 < _e1262[3][1][0].member_1))), (_e1262[2][1][0].member_1 - _e1262[3][1][0].member_1)), type_9(((_e1262[2][1][1].member - _e1262[3][1][1].member) - select(0u, 1u, (_e1262[2][1][1].member_1 < _e1262[3][1][1].member_1))), (_e1262[2][1][1].member_1 - _e1262[3][1][1].member_1)), type_9(((_e1262[2][1][2].member - _e1262[3][1][2].member) - select(0u, 1u, (_e1262[2][1][2].member_1 < _e1262[3][1][2].member_1))), (_e1262[2][1][2].member_1 - _e1262[3][1][2].member_1)))));
                    } else {
                        phi_3172_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[0][0][0].member - _e1262[1][0][0].member) - select(0u, 1u, (_e1262[0][0][0].member_1 < _e1262[1][0][0].member_1))), (_e1262[0][0][0].member_1 - _e1262[1][0][0].member_1)), type_9(((_e1262[0][0][1].member - _e1262[1][0][1].member) - select(0u, 1u, (_e1262[0][0][1].member_1 < _e1262[1][0][1].member_1))), (_e1262[0][0][1].member_1 - _e1262[1][0][1].member_1)), type_9(((_e1262[0][0][2].member - _e1262[1][0][2].member) - select(0u, 1u, (_e1262[0][0][2].member_1 < _e1262[1][0][2].member_1))), (_e1262[0][0][2].member_1 - _e1262[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[0][1][0].member - _e1262[1][1][0].member) - select(0u, 1u, (_e1262[0][1][0].member_1 < _e1262[1][1][0].member_1))), (_e1262[0][1][0].member_1 - _e1262[1][1][0].member_1)), type_9(((_e1262[0][1][1].member - _e1262[1][1][1].member) - select(0u, 1u, (_e1262[0][1][1].member_1 < _e1262[1][1][1].member_1))), (_e1262[0][1][1].member_1 - _e1262[1][1][1].member_1)), type_9(((_e1262[0][1][2].member - _e1262[1][1][2].member) - select(0u, 1u, (_e1262[0][1][2].member_1 < _e1262[1][1][2].member_1))), (_e1262[0][1][2].member_1 - _e1262[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[2][0][0].member - _e1262[1][0][0].member) - select(0u, 1u, (_e1262[2][0][0].member_1 < _e1262[1][0][0].member_1))), (_e1262[2][0][0].member_1 - _e1262[1][0][0].member_1)), type_9(((_e1262[2][0][1].member - _e1262[1][0][1].member) - select(0u, 1u, (_e1262[2][0][1].member_1 < _e1262[1][0][1].member_1))), (_e1262[2][0][1].member_1 - _e1262[1][0][1].member_1)), type_9(((_e1262[2][0][2].member - _e1262[1][0][2].member) - select(0u, 1u, (_e1262[2][0][2].member_1 < _e1262[1][0][2].member_1))), (_e1262[2][0][2].member_1 - _e1262[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[2][1][0].member - _e1262[1][1][0].member) - select(0u, 1u, (_e1262[2][1][0].member_1 < _e1262[1][1][0].member_1))), (_e1262[2][1][0].member_1 - _e1262[1][1][0].member_1)), type_9(((_e1262[2][1][1].member - _e1262[1][1][1].member) - select(0u, 1u, (_e1262[2][1][1].member_1 < _e1262[1][1][1].member_1))), (_e1262[2][1][1].member_1 - _e1262[1][1][1].member_1)), type_9(((_e1262[2][1][2].member - _e1262[1][1][2].member) - select(0u, 1u, (_e1262[2][1][2].member_1 < _e1262[1][1][2].member_1))), (_e1262[2][1][2].member_1 - _e1262[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1262[3][0][0].member - _e1262[1][0][0].member) - select(0u, 1u, (_e1262[3][0][0].member_1 < _e1262[1][0][0].member_1))), (_e1262[3][0][0].member_1 - _e1262[1][0][0].member_1)), type_9(((_e1262[3][0][1].member - _e1262[1][0][1].member) - select(0u, 1u, (_e1262[3][0][1].member_1 < _e1262[1][0][1].member_1))), (_e1262[3][0][1].member_1 - _e1262[1][0][1].member_1)), type_9(((_e1262[3][0][2].member - _e1262[1][0][2].member) - select(0u, 1u, (_e1262[3][0][2].member_1 < _e1262[1][0][2].member_1))), (_e1262[3][0][2].member_1 - _e1262[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1262[3][1][0].member - _e1262[1][1][0].member) - select(0u, 1u, (_e1262[3][1][0].member_1 < _e1262[1][1][0].member_1))), (_e1262[3][1][0].member_1 - _e1262[1][1][0].member_1)), type_9(((_e1262[3][1][1].member - _e1262[1][1][1].member) - select(0u, 1u, (_e1262[3][1][1].member_1 < _e1262[1][1][1].member_1))), (_e1262[3][1][1].member_1 - _e1262[1][1][1].member_1)), type_9(((_e1262[3][1][2].member - _e1262[1][1][2].member) - select(0u, 1u, (_e1262[3][1][2].member_1 < _e1262[1][1][2].member_1))), (_e1262[3][1][2].member_1 - _e1262[1][1][2].member_1)))));
                    }
                    let _e1843 = phi_3172_;
                    local_29 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_30 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e1876 = local_29[1u].member;
                    let _e1878 = local_29[1u].member_1;
                    let _e1881 = local_30[2u].member;
                    let _e1883 = local_30[2u].member_1;
                    let _e1884 = function_5(_e1876, _e1878, _e1881, _e1883);
                    let _e1889 = local_29[2u].member;
                    let _e1891 = local_29[2u].member_1;
                    let _e1894 = local_30[1u].member;
                    let _e1896 = local_30[1u].member_1;
                    let _e1897 = function_5(_e1889, _e1891, _e1894, _e1896);
                    let _e1903 = ((_e1884.member - _e1897.member) - select(0u, 1u, (_e1884.member_1 < _e1897.member_1)));
                    let _e1904 = (_e1884.member_1 - _e1897.member_1);
                    local_27 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_28 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e1933 = local_27[2u].member;
                    let _e1935 = local_27[2u].member_1;
                    let _e1938 = local_28[0u].member;
                    let _e1940 = local_28[0u].member_1;
                    let _e1941 = function_5(_e1933, _e1935, _e1938, _e1940);
                    let _e1946 = local_27[0u].member;
                    let _e1948 = local_27[0u].member_1;
                    let _e1951 = local_28[2u].member;
                    let _e1953 = local_28[2u].member_1;
                    let _e1954 = function_5(_e1946, _e1948, _e1951, _e1953);
                    let _e1960 = ((_e1941.member - _e1954.member) - select(0u, 1u, (_e1941.member_1 < _e1954.member_1)));
                    let _e1961 = (_e1941.member_1 - _e1954.member_1);
                    local_25 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_26 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e1990 = local_25[0u].member;
                    let _e1992 = local_25[0u].member_1;
                    let _e1995 = local_26[1u].member;
                    let _e1997 = local_26[1u].member_1;
                    let _e1998 = function_5(_e1990, _e1992, _e1995, _e1997);
                    let _e2003 = local_25[1u].member;
                    let _e2005 = local_25[1u].member_1;
                    let _e2008 = local_26[0u].member;
                    let _e2010 = local_26[0u].member_1;
                    let _e2011 = function_5(_e2003, _e2005, _e2008, _e2010);
                    let _e2017 = ((_e1998.member - _e2011.member) - select(0u, 1u, (_e1998.member_1 < _e2011.member_1)));
                    let _e2018 = (_e1998.member_1 - _e2011.member_1);
                    local_23 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_24 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2051 = local_23[1u].member;
                    let _e2053 = local_23[1u].member_1;
                    let _e2056 = local_24[2u].member;
                    let _e2058 = local_24[2u].member_1;
                    let _e2059 = function_5(_e2051, _e2053, _e2056, _e2058);
                    let _e2064 = local_23[2u].member;
                    let _e2066 = local_23[2u].member_1;
                    let _e2069 = local_24[1u].member;
                    let _e2071 = local_24[1u].member_1;
                    let _e2072 = function_5(_e2064, _e2066, _e2069, _e2071);
                    let _e2078 = ((_e2059.member - _e2072.member) - select(0u, 1u, (_e2059.member_1 < _e2072.member_1)));
                    let _e2079 = (_e2059.member_1 - _e2072.member_1);
                    local_21 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_22 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2108 = local_21[2u].member;
                    let _e2110 = local_21[2u].member_1;
                    let _e2113 = local_22[0u].member;
                    let _e2115 = local_22[0u].member_1;
                    let _e2116 = function_5(_e2108, _e2110, _e2113, _e2115);
                    let _e2121 = local_21[0u].member;
                    let _e2123 = local_21[0u].member_1;
                    let _e2126 = local_22[2u].member;
                    let _e2128 = local_22[2u].member_1;
                    let _e2129 = function_5(_e2121, _e2123, _e2126, _e2128);
                    let _e2135 = ((_e2116.member - _e2129.member) - select(0u, 1u, (_e2116.member_1 < _e2129.member_1)));
                    let _e2136 = (_e2116.member_1 - _e2129.member_1);
                    local_19 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_20 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2165 = local_19[0u].member;
                    let _e2167 = local_19[0u].member_1;
                    let _e2170 = local_20[1u].member;
                    let _e2172 = local_20[1u].member_1;
                    let _e2173 = function_5(_e2165, _e2167, _e2170, _e2172);
                    let _e2178 = local_19[1u].member;
                    let _e2180 = local_19[1u].member_1;
                    let _e2183 = local_20[0u].member;
                    let _e2185 = local_20[0u].member_1;
                    let _e2186 = function_5(_e2178, _e2180, _e2183, _e2185);
                    let _e2192 = ((_e2173.member - _e2186.member) - select(0u, 1u, (_e2173.member_1 < _e2186.member_1)));
                    let _e2193 = (_e2173.member_1 - _e2186.member_1);
                    local_17 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_18 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2226 = local_17[1u].member;
                    let _e2228 = local_17[1u].member_1;
                    let _e2231 = local_18[2u].member;
                    let _e2233 = local_18[2u].member_1;
                    let _e2234 = function_5(_e2226, _e2228, _e2231, _e2233);
                    let _e2239 = local_17[2u].member;
                    let _e2241 = local_17[2u].member_1;
                    let _e2244 = local_18[1u].member;
                    let _e2246 = local_18[1u].member_1;
                    let _e2247 = function_5(_e2239, _e2241, _e2244, _e2246);
                    let _e2254 = (_e2234.member_1 - _e2247.member_1);
                    local_15 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_16 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2283 = local_15[2u].member;
                    let _e2285 = local_15[2u].member_1;
                    let _e2288 = local_16[0u].member;
                    let _e2290 = local_16[0u].member_1;
                    let _e2291 = function_5(_e2283, _e2285, _e2288, _e2290);
                    let _e2296 = local_15[0u].member;
                    let _e2298 = local_15[0u].member_1;
                    let _e2301 = local_16[2u].member;
                    let _e2303 = local_16[2u].member_1;
                    let _e2304 = function_5(_e2296, _e2298, _e2301, _e2303);
                    let _e2311 = (_e2291.member_1 - _e2304.member_1);
                    local_13 = array<type_9, 3>(type_9(_e1843[1][0][0].member, _e1843[1][0][0].member_1), type_9(_e1843[1][0][1].member, _e1843[1][0][1].member_1), type_9(_e1843[1][0][2].member, _e1843[1][0][2].member_1));
                    local_14 = array<type_9, 3>(type_9(_e1843[2][1][0].member, _e1843[2][1][0].member_1), type_9(_e1843[2][1][1].member, _e1843[2][1][1].member_1), type_9(_e1843[2][1][2].member, _e1843[2][1][2].member_1));
                    let _e2340 = local_13[0u].member;
                    let _e2342 = local_13[0u].member_1;
                    let _e2345 = local_14[1u].member;
                    let _e2347 = local_14[1u].member_1;
                    let _e2348 = function_5(_e2340, _e2342, _e2345, _e2347);
                    let _e2353 = local_13[1u].member;
                    let _e2355 = local_13[1u].member_1;
                    let _e2358 = local_14[0u].member;
                    let _e2360 = local_14[0u].member_1;
                    let _e2361 = function_5(_e2353, _e2355, _e2358, _e2360);
                    let _e2368 = (_e2348.member_1 - _e2361.member_1);
                    local_11 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_12 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e2401 = local_11[1u].member;
                    let _e2403 = local_11[1u].member_1;
                    let _e2406 = local_12[2u].member;
                    let _e2408 = local_12[2u].member_1;
                    let _e2409 = function_5(_e2401, _e2403, _e2406, _e2408);
                    let _e2414 = local_11[2u].member;
                    let _e2416 = local_11[2u].member_1;
                    let _e2419 = local_12[1u].member;
                    let _e2421 = local_12[1u].member_1;
                    let _e2422 = function_5(_e2414, _e2416, _e2419, _e2421);
                    local_9 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_10 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e2458 = local_9[2u].member;
                    let _e2460 = local_9[2u].member_1;
                    let _e2463 = local_10[0u].member;
                    let _e2465 = local_10[0u].member_1;
                    let _e2466 = function_5(_e2458, _e2460, _e2463, _e2465);
                    let _e2471 = local_9[0u].member;
                    let _e2473 = local_9[0u].member_1;
                    let _e2476 = local_10[2u].member;
                    let _e2478 = local_10[2u].member_1;
                    let _e2479 = function_5(_e2471, _e2473, _e2476, _e2478);
                    local_7 = array<type_9, 3>(type_9(_e1843[1][1][0].member, _e1843[1][1][0].member_1), type_9(_e1843[1][1][1].member, _e1843[1][1][1].member_1), type_9(_e1843[1][1][2].member, _e1843[1][1][2].member_1));
                    local_8 = array<type_9, 3>(type_9(_e1843[2][0][0].member, _e1843[2][0][0].member_1), type_9(_e1843[2][0][1].member, _e1843[2][0][1].member_1), type_9(_e1843[2][0][2].member, _e1843[2][0][2].member_1));
                    let _e2515 = local_7[0u].member;
                    let _e2517 = local_7[0u].member_1;
                    let _e2520 = local_8[1u].member;
                    let _e2522 = local_8[1u].member_1;
                    let _e2523 = function_5(_e2515, _e2517, _e2520, _e2522);
                    let _e2528 = local_7[1u].member;
                    let _e2530 = local_7[1u].member_1;
                    let _e2533 = local_8[0u].member;
                    let _e2535 = local_8[0u].member_1;
                    let _e2536 = function_5(_e2528, _e2530, _e2533, _e2535);
                    let _e2544 = (_e2254 + (_e2409.member_1 - _e2422.member_1));
                    let _e2548 = ((((_e2234.member - _e2247.member) - select(0u, 1u, (_e2234.member_1 < _e2247.member_1))) + ((_e2409.member - _e2422.member) - select(0u, 1u, (_e2409.member_1 < _e2422.member_1)))) + select(0u, 1u, (_e2544 < _e2254)));
                    let _e2549 = (_e2311 + (_e2466.member_1 - _e2479.member_1));
                    let _e2553 = ((((_e2291.member - _e2304.member) - select(0u, 1u, (_e2291.member_1 < _e2304.member_1))) + ((_e2466.member - _e2479.member) - select(0u, 1u, (_e2466.member_1 < _e2479.member_1)))) + select(0u, 1u, (_e2549 < _e2311)));
                    let _e2554 = (_e2368 + (_e2523.member_1 - _e2536.member_1));
                    let _e2558 = ((((_e2348.member - _e2361.member) - select(0u, 1u, (_e2348.member_1 < _e2361.member_1))) + ((_e2523.member - _e2536.member) - select(0u, 1u, (_e2523.member_1 < _e2536.member_1)))) + select(0u, 1u, (_e2554 < _e2368)));
                    let _e2565 = function_5(_e1843[0][0][0].member, _e1843[0][0][0].member_1, _e1903, _e1904);
                    let _e2572 = function_5(_e1843[0][0][1].member, _e1843[0][0][1].member_1, _e1960, _e1961);
                    let _e2575 = (_e2565.member_1 + _e2572.member_1);
                    let _e2584 = function_5(_e1843[0][0][2].member, _e1843[0][0][2].member_1, _e2017, _e2018);
                    let _e2587 = (_e2575 + _e2584.member_1);
                    let _e2592 = function_9(((((_e2565.member + _e2572.member) + select(0u, 1u, (_e2575 < _e2565.member_1))) + _e2584.member) + select(0u, 1u, (_e2587 < _e2575))), _e2587);
                    let _e2601 = function_5(_e1843[0][1][0].member, _e1843[0][1][0].member_1, _e1903, _e1904);
                    let _e2608 = function_5(_e1843[0][1][1].member, _e1843[0][1][1].member_1, _e1960, _e1961);
                    let _e2611 = (_e2601.member_1 + _e2608.member_1);
                    let _e2620 = function_5(_e1843[0][1][2].member, _e1843[0][1][2].member_1, _e2017, _e2018);
                    let _e2623 = (_e2611 + _e2620.member_1);
                    let _e2634 = function_5(_e1843[0][0][0].member, _e1843[0][0][0].member_1, _e2548, _e2544);
                    let _e2641 = function_5(_e1843[0][0][1].member, _e1843[0][0][1].member_1, _e2553, _e2549);
                    let _e2644 = (_e2634.member_1 + _e2641.member_1);
                    let _e2653 = function_5(_e1843[0][0][2].member, _e1843[0][0][2].member_1, _e2558, _e2554);
                    let _e2656 = (_e2644 + _e2653.member_1);
                    let _e2661 = (_e2623 + _e2656);
                    let _e2665 = ((((((_e2601.member + _e2608.member) + select(0u, 1u, (_e2611 < _e2601.member_1))) + _e2620.member) + select(0u, 1u, (_e2623 < _e2611))) + ((((_e2634.member + _e2641.member) + select(0u, 1u, (_e2644 < _e2634.member_1))) + _e2653.member) + select(0u, 1u, (_e2656 < _e2644)))) + select(0u, 1u, (_e2661 < _e2623)));
                    let _e2672 = function_5(_e1843[0][0][0].member, _e1843[0][0][0].member_1, _e2078, _e2079);
                    let _e2679 = function_5(_e1843[0][0][1].member, _e1843[0][0][1].member_1, _e2135, _e2136);
                    let _e2682 = (_e2672.member_1 + _e2679.member_1);
                    let _e2691 = function_5(_e1843[0][0][2].member, _e1843[0][0][2].member_1, _e2192, _e2193);
                    let _e2694 = (_e2682 + _e2691.member_1);
                    let _e2705 = function_5(_e1843[0][1][0].member, _e1843[0][1][0].member_1, _e2548, _e2544);
                    let _e2712 = function_5(_e1843[0][1][1].member, _e1843[0][1][1].member_1, _e2553, _e2549);
                    let _e2715 = (_e2705.member_1 + _e2712.member_1);
                    let _e2724 = function_5(_e1843[0][1][2].member, _e1843[0][1][2].member_1, _e2558, _e2554);
                    let _e2727 = (_e2715 + _e2724.member_1);
                    let _e2732 = (_e2694 + _e2727);
                    let _e2736 = ((((((_e2672.member + _e2679.member) + select(0u, 1u, (_e2682 < _e2672.member_1))) + _e2691.member) + select(0u, 1u, (_e2694 < _e2682))) + ((((_e2705.member + _e2712.member) + select(0u, 1u, (_e2715 < _e2705.member_1))) + _e2724.member) + select(0u, 1u, (_e2727 < _e2715)))) + select(0u, 1u, (_e2732 < _e2694)));
                    let _e2743 = function_5(_e1843[0][1][0].member, _e1843[0][1][0].member_1, _e2078, _e2079);
                    let _e2750 = function_5(_e1843[0][1][1].member, _e1843[0][1][1].member_1, _e2135, _e2136);
                    let _e2753 = (_e2743.member_1 + _e2750.member_1);
                    let _e2762 = function_5(_e1843[0][1][2].member, _e1843[0][1][2].member_1, _e2192, _e2193);
                    let _e2765 = (_e2753 + _e2762.member_1);
                    let _e2770 = function_9(((((_e2743.member + _e2750.member) + select(0u, 1u, (_e2753 < _e2743.member_1))) + _e2762.member) + select(0u, 1u, (_e2765 < _e2753))), _e2765);
                    let _e2780 = select((bitcast<u32>(31i) - firstLeadingBit(_e1268)), 32u, (_e1268 == 0u));
                    let _e2782 = select(18u, _e2780, (18u < _e2780));
                    phi_4476_ = array<type_9, 4>(_e2592, type_9(_e2665, _e2661), type_9(_e2736, _e2732), _e2770);
                    phi_4479_ = false;
                    phi_4481_ = false;
                    phi_4483_ = false;
                    phi_4485_ = false;
                    phi_4487_ = type_18(0u, 0u, 0u);
                    phi_4491_ = 0u;
                    phi_4493_ = 0u;
                    phi_4495_ = 0u;
                    phi_4497_ = 0u;
                    phi_4499_ = 0u;
                    loop {
                        let _e2784 = phi_4476_;
                        let _e2786 = phi_4479_;
                        let _e2788 = phi_4481_;
                        let _e2790 = phi_4483_;
                        let _e2792 = phi_4485_;
                        let _e2794 = phi_4487_;
                        let _e2796 = phi_4491_;
                        let _e2798 = phi_4493_;
                        let _e2800 = phi_4495_;
                        let _e2802 = phi_4497_;
                        let _e2804 = phi_4499_;
                        if (_e2800 < 64u) {
                            phi_4508_ = _e2784;
                            phi_4511_ = _e2790;
                            phi_4513_ = _e2792;
                            phi_4517_ = _e2786;
                            phi_4519_ = false;
                            phi_4521_ = false;
                            phi_4523_ = false;
                            phi_4525_ = _e2796;
                            phi_4527_ = _e2798;
                            phi_4529_ = _e2800;
                            phi_4531_ = _e2802;
                            phi_4533_ = _e2804;
                            loop {
                                let _e2807 = phi_4508_;
                                let _e2809 = phi_4511_;
                                let _e2811 = phi_4513_;
                                let _e2813 = phi_4517_;
                                let _e2815 = phi_4519_;
                                let _e2817 = phi_4521_;
                                let _e2819 = phi_4523_;
                                let _e2821 = phi_4525_;
                                let _e2823 = phi_4527_;
                                let _e2825 = phi_4529_;
                                let _e2827 = phi_4531_;
                                let _e2829 = phi_4533_;
                                local_34 = _e2813;
                                local_35 = _e2819;
                                local_36 = _e2807;
                                local_37 = _e2807;
                                local_38 = _e2807;
                                local_39 = _e2807;
                                local_40 = _e2807;
                                local_41 = _e2807;
                                local_42 = _e2807;
                                local_43 = _e2807;
                                local_44 = _e2807;
                                local_45 = _e2807;
                                local_46 = _e2807;
                                local_47 = _e2807;
                                local_48 = _e2827;
                                local_49 = _e2823;
                                local_50 = _e2821;
                                local_51 = _e2827;
                                local_52 = _e2807;
                                local_53 = _e2807;
                                local_54 = _e2807;
                                local_55 = _e2807;
                                local_56 = _e2807;
                                local_57 = _e2807;
                                local_58 = _e2815;
                                local_59 = _e2815;
                                local_60 = _e2827;
                                local_61 = _e2817;
                                local_62 = _e2827;
                                local_63 = _e2807;
                                local_64 = _e2807;
                                local_65 = _e2807;
                                local_66 = _e2823;
                                local_67 = _e2823;
                                local_68 = _e2807;
                                local_69 = _e2807;
                                local_70 = _e2807;
                                local_71 = _e2823;
                                local_72 = _e2821;
                                local_73 = _e2807;
                                local_74 = _e2807;
                                local_75 = _e2807;
                                local_76 = _e2807;
                                local_77 = _e2807;
                                local_78 = _e2807;
                                local_79 = _e2807;
                                local_80 = _e2807;
                                local_82 = _e2823;
                                local_83 = _e2821;
                                local_84 = _e2827;
                                local_85 = _e2823;
                                local_86 = _e2823;
                                local_87 = _e2815;
                                local_109 = _e2819;
                                local_110 = _e2809;
                                local_111 = _e2811;
                                local_112 = _e2819;
                                local_113 = _e2809;
                                local_114 = _e2811;
                                local_115 = _e2819;
                                local_88 = _e2829;
                                local_89 = _e2829;
                                local_90 = _e2827;
                                local_91 = _e2827;
                                local_92 = _e2827;
                                local_93 = _e2823;
                                local_116 = _e2827;
                                local_117 = _e2829;
                                local_118 = _e2807;
                                local_119 = _e2821;
                                local_120 = _e2823;
                                local_121 = _e2825;
                                if (_e2825 < 64u) {
                                    if _e2819 {
                                        phi_5411_ = array<type_9, 4>();
                                        phi_5412_ = bool();
                                        phi_5413_ = bool();
                                        phi_5415_ = bool();
                                        phi_5416_ = bool();
                                        phi_5417_ = bool();
                                        phi_5418_ = bool();
                                        phi_5419_ = u32();
                                        phi_5420_ = u32();
                                        phi_5421_ = u32();
                                        phi_5422_ = u32();
                                        phi_5423_ = u32();
                                        phi_5424_ = false;
                                    } else {
                                        if _e2813 {
                                            phi_5397_ = array<type_9, 4>();
                                            phi_5398_ = bool();
                                            phi_5399_ = bool();
                                            phi_5401_ = bool();
                                            phi_5402_ = bool();
                                            phi_5403_ = bool();
                                            phi_5404_ = bool();
                                            phi_5405_ = u32();
                                            phi_5406_ = u32();
                                            phi_5407_ = u32();
                                            phi_5408_ = u32();
                                            phi_5409_ = u32();
                                            phi_5410_ = false;
                                        } else {
                                            let _e2832 = (31u - _e2827);
                                            let _e2835 = (_e2829 << bitcast<u32>((_e2832 & 31u)));
                                            let _e2839 = ((_e2829 + 1u) << bitcast<u32>((_e2832 & 31u)));
                                            if (_e2835 > _e1266) {
                                                phi_4739_ = bool();
                                                phi_4740_ = true;
                                            } else {
                                                let _e2841 = (_e2839 < _e1264);
                                                if _e2841 {
                                                    phi_4738_ = bool();
                                                } else {
                                                    let _e2846 = function_8(128u);
                                                    let _e2851 = ((_e2807[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2879 = function_8(128u);
                                                    let _e2884 = ((_e2807[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2913 = function_8(128u);
                                                    let _e2918 = ((_e2807[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2947 = function_8(128u);
                                                    let _e2952 = ((_e2807[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_4738_ = ((((select(0u, select(1u, 2u, ((_e2807[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2846.member - select(_e2807[0].member, (~(_e2807[0].member) + select(0u, 1u, (_e2807[0].member_1 == 0u))), _e2851)) - select(0u, 1u, (_e2846.member_1 < select(_e2807[0].member_1, (~(_e2807[0].member_1) + 1u), _e2851)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2807[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2879.member - select(_e2807[1].member, (~(_e2807[1].member) + select(0u, 1u, (_e2807[1].member_1 == 0u))), _e2884)) - select(0u, 1u, (_e2879.member_1 < select(_e2807[1].member_1, (~(_e2807[1].member_1) + 1u), _e2884)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2807[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2913.member - select(_e2807[2].member, (~(_e2807[2].member) + select(0u, 1u, (_e2807[2].member_1 == 0u))), _e2918)) - select(0u, 1u, (_e2913.member_1 < select(_e2807[2].member_1, (~(_e2807[2].member_1) + 1u), _e2918)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2807[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2947.member - select(_e2807[3].member, (~(_e2807[3].member) + select(0u, 1u, (_e2807[3].member_1 == 0u))), _e2952)) - select(0u, 1u, (_e2947.member_1 < select(_e2807[3].member_1, (~(_e2807[3].member_1) + 1u), _e2952)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e2979 = phi_4738_;
                                                phi_4739_ = _e2979;
                                                phi_4740_ = _e2841;
                                            }
                                            let _e2981 = phi_4739_;
                                            let _e2983 = phi_4740_;
                                            let _e2984 = select(_e2981, true, _e2983);
                                            let _e2989 = function_8(128u);
                                            let _e2994 = ((_e2807[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3017 = select(0u, select(1u, 2u, ((_e2807[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2989.member - select(_e2807[0].member, (~(_e2807[0].member) + select(0u, 1u, (_e2807[0].member_1 == 0u))), _e2994)) - select(0u, 1u, (_e2989.member_1 < select(_e2807[0].member_1, (~(_e2807[0].member_1) + 1u), _e2994)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3022 = function_8(128u);
                                            let _e3027 = ((_e2807[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3050 = select(0u, select(1u, 2u, ((_e2807[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3022.member - select(_e2807[1].member, (~(_e2807[1].member) + select(0u, 1u, (_e2807[1].member_1 == 0u))), _e3027)) - select(0u, 1u, (_e3022.member_1 < select(_e2807[1].member_1, (~(_e2807[1].member_1) + 1u), _e3027)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3055 = function_8(128u);
                                            let _e3060 = ((_e2807[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3083 = select(0u, select(1u, 2u, ((_e2807[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3055.member - select(_e2807[2].member, (~(_e2807[2].member) + select(0u, 1u, (_e2807[2].member_1 == 0u))), _e3060)) - select(0u, 1u, (_e3055.member_1 < select(_e2807[2].member_1, (~(_e2807[2].member_1) + 1u), _e3060)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3088 = function_8(128u);
                                            let _e3093 = ((_e2807[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3116 = select(0u, select(1u, 2u, ((_e2807[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3088.member - select(_e2807[3].member, (~(_e2807[3].member) + select(0u, 1u, (_e2807[3].member_1 == 0u))), _e3093)) - select(0u, 1u, (_e3088.member_1 < select(_e2807[3].member_1, (~(_e2807[3].member_1) + 1u), _e3093)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3126 = select(false, select(true, select(false, (_e3050 != 0u), (_e3083 == _e3116)), select(true, (_e3083 == 0u), (_e3050 == _e3017))), ((_e3017 | _e3116) == 3u));
                                            let _e3131 = function_8(128u);
                                            let _e3136 = ((_e2807[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3162 = select(false, (_e2835 >= _e1264), (select(0u, select(1u, 2u, ((_e2807[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3131.member - select(_e2807[0].member, (~(_e2807[0].member) + select(0u, 1u, (_e2807[0].member_1 == 0u))), _e3136)) - select(0u, 1u, (_e3131.member_1 < select(_e2807[0].member_1, (~(_e2807[0].member_1) + 1u), _e3136)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e3163 = (_e2827 == 3u);
                                            let _e3164 = (_e2827 == 8u);
                                            let _e3169 = select(select(select((_e2827 == 14u), bool(), _e3164), bool(), _e3163), true, select(_e3164, true, _e3163));
                                            let _e3171 = select(false, !(_e2809), _e3162);
                                            let _e3172 = (_e2827 == 31u);
                                            let _e3183 = select(select(false, !(_e2811), select(select(select(select(select(false, !(_e2788), _e3126), bool(), _e3162), bool(), _e3169), bool(), _e3172), true, select(select(_e3162, true, _e3169), true, _e3172))), true, _e3171);
                                            if _e2984 {
                                                phi_5391_ = _e2807;
                                                phi_5392_ = _e2809;
                                                phi_5393_ = _e2811;
                                                phi_5395_ = _e2827;
                                                phi_5396_ = _e2829;
                                            } else {
                                                if _e3183 {
                                                    phi_5385_ = _e2807;
                                                    phi_5386_ = _e2809;
                                                    phi_5387_ = _e2811;
                                                    phi_5389_ = _e2827;
                                                    phi_5390_ = _e2829;
                                                } else {
                                                    let _e3192 = (_e2807[0].member_1 + _e2807[1].member_1);
                                                    let _e3196 = ((_e2807[0].member + _e2807[1].member) + select(0u, 1u, (_e3192 < _e2807[0].member_1)));
                                                    let _e3204 = bitcast<u32>((bitcast<i32>(_e3196) >> bitcast<u32>(1u)));
                                                    let _e3207 = ((_e3192 >> bitcast<u32>(1u)) | ((_e3196 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3216 = (_e2807[1].member_1 + _e2807[2].member_1);
                                                    let _e3220 = ((_e2807[1].member + _e2807[2].member) + select(0u, 1u, (_e3216 < _e2807[1].member_1)));
                                                    let _e3228 = bitcast<u32>((bitcast<i32>(_e3220) >> bitcast<u32>(1u)));
                                                    let _e3231 = ((_e3216 >> bitcast<u32>(1u)) | ((_e3220 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3240 = (_e2807[2].member_1 + _e2807[3].member_1);
                                                    let _e3244 = ((_e2807[2].member + _e2807[3].member) + select(0u, 1u, (_e3240 < _e2807[2].member_1)));
                                                    let _e3252 = bitcast<u32>((bitcast<i32>(_e3244) >> bitcast<u32>(1u)));
                                                    let _e3255 = ((_e3240 >> bitcast<u32>(1u)) | ((_e3244 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3256 = (_e3207 + _e3231);
                                                    let _e3260 = ((_e3204 + _e3228) + select(0u, 1u, (_e3256 < _e3207)));
                                                    let _e3268 = bitcast<u32>((bitcast<i32>(_e3260) >> bitcast<u32>(1u)));
                                                    let _e3271 = ((_e3256 >> bitcast<u32>(1u)) | ((_e3260 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3272 = (_e3231 + _e3255);
                                                    let _e3276 = ((_e3228 + _e3252) + select(0u, 1u, (_e3272 < _e3231)));
                                                    let _e3284 = bitcast<u32>((bitcast<i32>(_e3276) >> bitcast<u32>(1u)));
                                                    let _e3287 = ((_e3272 >> bitcast<u32>(1u)) | ((_e3276 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3288 = (_e3271 + _e3287);
                                                    let _e3292 = ((_e3268 + _e3284) + select(0u, 1u, (_e3288 < _e3271)));
                                                    let _e3300 = bitcast<u32>((bitcast<i32>(_e3292) >> bitcast<u32>(1u)));
                                                    let _e3303 = ((_e3288 >> bitcast<u32>(1u)) | ((_e3292 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3304 = (2u * _e2829);
                                                    let _e3315 = function_8(128u);
                                                    let _e3320 = ((_e2807[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e3344 = function_8(128u);
                                                    let _e3349 = ((_e3204 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3371 = function_8(128u);
                                                    let _e3376 = ((_e3268 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3398 = function_8(128u);
                                                    let _e3403 = ((_e3300 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e2807[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3315.member - select(_e2807[0].member, (~(_e2807[0].member) + select(0u, 1u, (_e2807[0].member_1 == 0u))), _e3320)) - select(0u, 1u, (_e3315.member_1 < select(_e2807[0].member_1, (~(_e2807[0].member_1) + 1u), _e3320)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3204 >> bitcast<u32>(31i)) != 0u)), ((((_e3344.member - select(_e3204, (~(_e3204) + select(0u, 1u, (_e3207 == 0u))), _e3349)) - select(0u, 1u, (_e3344.member_1 < select(_e3207, (~(_e3207) + 1u), _e3349)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3268 >> bitcast<u32>(31i)) != 0u)), ((((_e3371.member - select(_e3268, (~(_e3268) + select(0u, 1u, (_e3271 == 0u))), _e3376)) - select(0u, 1u, (_e3371.member_1 < select(_e3271, (~(_e3271) + 1u), _e3376)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3300 >> bitcast<u32>(31i)) != 0u)), ((((_e3398.member - select(_e3300, (~(_e3300) + select(0u, 1u, (_e3303 == 0u))), _e3403)) - select(0u, 1u, (_e3398.member_1 < select(_e3303, (~(_e3303) + 1u), _e3403)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_5382_ = array<type_9, 4>(type_9(_e3300, _e3303), type_9(_e3284, _e3287), type_9(_e3252, _e3255), _e2807[3]);
                                                        phi_5383_ = false;
                                                        phi_5384_ = (_e3304 + 1u);
                                                    } else {
                                                        phi_5382_ = array<type_9, 4>(_e2807[0], type_9(_e3204, _e3207), type_9(_e3268, _e3271), type_9(_e3300, _e3303));
                                                        phi_5383_ = _e2809;
                                                        phi_5384_ = _e3304;
                                                    }
                                                    let _e3433 = phi_5382_;
                                                    let _e3435 = phi_5383_;
                                                    let _e3437 = phi_5384_;
                                                    phi_5385_ = _e3433;
                                                    phi_5386_ = _e3435;
                                                    phi_5387_ = false;
                                                    phi_5389_ = (_e2827 + 1u);
                                                    phi_5390_ = _e3437;
                                                }
                                                let _e3439 = phi_5385_;
                                                let _e3441 = phi_5386_;
                                                let _e3443 = phi_5387_;
                                                let _e3445 = phi_5389_;
                                                let _e3447 = phi_5390_;
                                                phi_5391_ = _e3439;
                                                phi_5392_ = _e3441;
                                                phi_5393_ = _e3443;
                                                phi_5395_ = _e3445;
                                                phi_5396_ = _e3447;
                                            }
                                            let _e3449 = phi_5391_;
                                            let _e3451 = phi_5392_;
                                            let _e3453 = phi_5393_;
                                            let _e3455 = phi_5395_;
                                            let _e3457 = phi_5396_;
                                            phi_5397_ = _e3449;
                                            phi_5398_ = _e3451;
                                            phi_5399_ = _e3453;
                                            phi_5401_ = _e3183;
                                            phi_5402_ = _e3171;
                                            phi_5403_ = _e3126;
                                            phi_5404_ = _e2984;
                                            phi_5405_ = _e2839;
                                            phi_5406_ = _e2835;
                                            phi_5407_ = (_e2825 + 1u);
                                            phi_5408_ = _e3455;
                                            phi_5409_ = _e3457;
                                            phi_5410_ = true;
                                        }
                                        let _e3459 = phi_5397_;
                                        let _e3461 = phi_5398_;
                                        let _e3463 = phi_5399_;
                                        let _e3465 = phi_5401_;
                                        let _e3467 = phi_5402_;
                                        let _e3469 = phi_5403_;
                                        let _e3471 = phi_5404_;
                                        let _e3473 = phi_5405_;
                                        let _e3475 = phi_5406_;
                                        let _e3477 = phi_5407_;
                                        let _e3479 = phi_5408_;
                                        let _e3481 = phi_5409_;
                                        let _e3483 = phi_5410_;
                                        phi_5411_ = _e3459;
                                        phi_5412_ = _e3461;
                                        phi_5413_ = _e3463;
                                        phi_5415_ = _e3465;
                                        phi_5416_ = _e3467;
                                        phi_5417_ = _e3469;
                                        phi_5418_ = _e3471;
                                        phi_5419_ = _e3473;
                                        phi_5420_ = _e3475;
                                        phi_5421_ = _e3477;
                                        phi_5422_ = _e3479;
                                        phi_5423_ = _e3481;
                                        phi_5424_ = _e3483;
                                    }
                                    let _e3485 = phi_5411_;
                                    let _e3487 = phi_5412_;
                                    let _e3489 = phi_5413_;
                                    let _e3491 = phi_5415_;
                                    let _e3493 = phi_5416_;
                                    let _e3495 = phi_5417_;
                                    let _e3497 = phi_5418_;
                                    let _e3499 = phi_5419_;
                                    let _e3501 = phi_5420_;
                                    let _e3503 = phi_5421_;
                                    let _e3505 = phi_5422_;
                                    let _e3507 = phi_5423_;
                                    let _e3509 = phi_5424_;
                                    phi_4509_ = _e3485;
                                    phi_4512_ = _e3487;
                                    phi_4514_ = _e3489;
                                    phi_4518_ = _e3491;
                                    phi_4520_ = _e3493;
                                    phi_4522_ = _e3495;
                                    phi_4524_ = _e3497;
                                    phi_4526_ = _e3499;
                                    phi_4528_ = _e3501;
                                    phi_4530_ = _e3503;
                                    phi_4532_ = _e3505;
                                    phi_4534_ = _e3507;
                                    phi_5425_ = _e3509;
                                } else {
                                    phi_4509_ = array<type_9, 4>();
                                    phi_4512_ = bool();
                                    phi_4514_ = bool();
                                    phi_4518_ = bool();
                                    phi_4520_ = bool();
                                    phi_4522_ = bool();
                                    phi_4524_ = bool();
                                    phi_4526_ = u32();
                                    phi_4528_ = u32();
                                    phi_4530_ = u32();
                                    phi_4532_ = u32();
                                    phi_4534_ = u32();
                                    phi_5425_ = false;
                                }
                                let _e3511 = phi_4509_;
                                let _e3513 = phi_4512_;
                                let _e3515 = phi_4514_;
                                let _e3517 = phi_4518_;
                                let _e3519 = phi_4520_;
                                let _e3521 = phi_4522_;
                                let _e3523 = phi_4524_;
                                let _e3525 = phi_4526_;
                                let _e3527 = phi_4528_;
                                let _e3529 = phi_4530_;
                                let _e3531 = phi_4532_;
                                let _e3533 = phi_4534_;
                                let _e3535 = phi_5425_;
                                continue;
                                continuing {
                                    phi_4508_ = _e3511;
                                    phi_4511_ = _e3513;
                                    phi_4513_ = _e3515;
                                    phi_4517_ = _e3517;
                                    phi_4519_ = _e3519;
                                    phi_4521_ = _e3521;
                                    phi_4523_ = _e3523;
                                    phi_4525_ = _e3525;
                                    phi_4527_ = _e3527;
                                    phi_4529_ = _e3529;
                                    phi_4531_ = _e3531;
                                    phi_4533_ = _e3533;
                                    break if !(_e3535);
                                }
                            }
                            let _e3538 = local_34;
                            if _e3538 {
                                let _e3540 = local_35;
                                if _e3540 {
                                    phi_8296_ = _e2786;
                                    phi_8297_ = _e2788;
                                    let _e6412 = local_110;
                                    phi_8298_ = _e6412;
                                    let _e6415 = local_111;
                                    phi_8299_ = _e6415;
                                    phi_8300_ = _e2794;
                                    let _e6419 = local_112;
                                    phi_8301_ = _e6419;
                                    phi_8302_ = bool();
                                    phi_8303_ = type_18();
                                    phi_8304_ = true;
                                    phi_8305_ = false;
                                    phi_8306_ = false;
                                    phi_8307_ = false;
                                } else {
                                    let _e3542 = local_36;
                                    let _e3546 = local_37;
                                    let _e3549 = function_8(128u);
                                    let _e3554 = ((_e3542[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3562 = local_38;
                                    let _e3581 = local_39;
                                    let _e3585 = local_40;
                                    let _e3588 = function_8(128u);
                                    let _e3593 = ((_e3581[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3601 = local_41;
                                    let _e3621 = local_42;
                                    let _e3625 = local_43;
                                    let _e3628 = function_8(128u);
                                    let _e3633 = ((_e3621[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3641 = local_44;
                                    let _e3661 = local_45;
                                    let _e3665 = local_46;
                                    let _e3668 = function_8(128u);
                                    let _e3673 = ((_e3661[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3681 = local_47;
                                    let _e3702 = local_48;
                                    let _e3707 = local_49;
                                    let _e3709 = local_50;
                                    let _e3711 = local_51;
                                    let _e3712 = type_18(_e3707, _e3709, _e3711);
                                    let _e3714 = local_52;
                                    let _e3718 = local_53;
                                    let _e3721 = function_8(128u);
                                    let _e3726 = ((_e3714[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3734 = local_54;
                                    let _e3753 = local_55;
                                    let _e3757 = local_56;
                                    let _e3760 = function_8(128u);
                                    let _e3765 = ((_e3753[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3773 = local_57;
                                    let _e3792 = ((select(0u, select(1u, 2u, ((_e3714[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3721.member - select(_e3734[0].member, (~(_e3714[0].member) + select(0u, 1u, (_e3718[0].member_1 == 0u))), _e3726)) - select(0u, 1u, (_e3721.member_1 < select(_e3734[0].member_1, (~(_e3718[0].member_1) + 1u), _e3726)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3753[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3760.member - select(_e3773[3].member, (~(_e3753[3].member) + select(0u, 1u, (_e3757[3].member_1 == 0u))), _e3765)) - select(0u, 1u, (_e3760.member_1 < select(_e3773[3].member_1, (~(_e3757[3].member_1) + 1u), _e3765)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e3794 = local_58;
                                    let _e3797 = local_59;
                                    if _e3797 {
                                        let _e4414 = local_85;
                                        let _e4417 = local_86;
                                        phi_6533_ = _e2786;
                                        phi_6534_ = _e2788;
                                        phi_6535_ = _e3792;
                                        phi_6536_ = type_18(_e4417, (_e4414 + 1u), 31u);
                                        phi_6537_ = _e2794;
                                    } else {
                                        if _e2786 {
                                            phi_6019_ = bool();
                                            phi_6020_ = type_18();
                                            phi_6021_ = true;
                                        } else {
                                            let _e3799 = local_60;
                                            let _e3803 = local_61;
                                            if select(true, select(true, false, (_e3799 < _e2782)), _e3803) {
                                                let _e3806 = local_62;
                                                if (_e3806 == 31u) {
                                                    if _e3792 {
                                                        phi_6012_ = _e3792;
                                                        phi_6013_ = _e3712;
                                                    } else {
                                                        let _e3809 = local_63;
                                                        let _e3813 = local_64;
                                                        let _e3816 = function_8(128u);
                                                        let _e3821 = ((_e3809[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3829 = local_65;
                                                        if (select(0u, select(1u, 2u, ((_e3809[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3816.member - select(_e3829[0].member, (~(_e3809[0].member) + select(0u, 1u, (_e3813[0].member_1 == 0u))), _e3821)) - select(0u, 1u, (_e3816.member_1 < select(_e3829[0].member_1, (~(_e3813[0].member_1) + 1u), _e3821)))) >> bitcast<u32>(31i)) != 0u)) == 0u) {
                                                            phi_6010_ = _e3792;
                                                            phi_6011_ = _e3712;
                                                        } else {
                                                            let _e3852 = select((bitcast<u32>(31i) - firstLeadingBit(_e1268)), 32u, (_e1268 == 0u));
                                                            let _e3858 = local_66;
                                                            let _e3859 = (_e3858 + (1u << bitcast<u32>(((31u - _e3852) & 31u))));
                                                            let _e3861 = local_67;
                                                            if (_e3859 <= 2147483648u) {
                                                                let _e3865 = local_68;
                                                                let _e3869 = local_69;
                                                                let _e3872 = function_8(128u);
                                                                let _e3877 = ((_e3865[0].member >> bitcast<u32>(31i)) != 0u);
                                                                let _e3885 = local_70;
                                                                let _e3908 = function_1(((_e2665 - _e2592.member) - select(0u, 1u, (_e2661 < _e2592.member_1))), (_e2661 - _e2592.member_1), _e3859);
                                                                let _e3911 = (_e2592.member_1 + _e3908.member_1);
                                                                let _e3915 = ((_e2592.member + _e3908.member) + select(0u, 1u, (_e3911 < _e2592.member_1)));
                                                                let _e3921 = function_1(((_e2736 - _e2665) - select(0u, 1u, (_e2732 < _e2661))), (_e2732 - _e2661), _e3859);
                                                                let _e3924 = (_e2661 + _e3921.member_1);
                                                                let _e3928 = ((_e2665 + _e3921.member) + select(0u, 1u, (_e3924 < _e2661)));
                                                                let _e3934 = function_1(((_e2770.member - _e2736) - select(0u, 1u, (_e2770.member_1 < _e2732))), (_e2770.member_1 - _e2732), _e3859);
                                                                let _e3937 = (_e2732 + _e3934.member_1);
                                                                let _e3947 = function_1(((_e3928 - _e3915) - select(0u, 1u, (_e3924 < _e3911))), (_e3924 - _e3911), _e3859);
                                                                let _e3950 = (_e3911 + _e3947.member_1);
                                                                let _e3954 = ((_e3915 + _e3947.member) + select(0u, 1u, (_e3950 < _e3911)));
                                                                let _e3960 = function_1(((((_e2736 + _e3934.member) + select(0u, 1u, (_e3937 < _e2732))) - _e3928) - select(0u, 1u, (_e3937 < _e3924))), (_e3937 - _e3924), _e3859);
                                                                let _e3963 = (_e3924 + _e3960.member_1);
                                                                let _e3973 = function_1(((((_e3928 + _e3960.member) + select(0u, 1u, (_e3963 < _e3924))) - _e3954) - select(0u, 1u, (_e3963 < _e3950))), (_e3963 - _e3950), _e3859);
                                                                let _e3976 = (_e3950 + _e3973.member_1);
                                                                let _e3980 = ((_e3954 + _e3973.member) + select(0u, 1u, (_e3976 < _e3950)));
                                                                let _e3981 = function_8(128u);
                                                                let _e3986 = ((_e3980 >> bitcast<u32>(31i)) != 0u);
                                                                phi_6009_ = ((select(0u, select(1u, 2u, ((_e3865[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3872.member - select(_e3885[0].member, (~(_e3865[0].member) + select(0u, 1u, (_e3869[0].member_1 == 0u))), _e3877)) - select(0u, 1u, (_e3872.member_1 < select(_e3885[0].member_1, (~(_e3869[0].member_1) + 1u), _e3877)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3980 >> bitcast<u32>(31i)) != 0u)), ((((_e3981.member - select(_e3980, (~(_e3980) + select(0u, 1u, (_e3976 == 0u))), _e3986)) - select(0u, 1u, (_e3981.member_1 < select(_e3976, (~(_e3976) + 1u), _e3986)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                            } else {
                                                                phi_6009_ = false;
                                                            }
                                                            let _e4010 = phi_6009_;
                                                            phi_6010_ = _e4010;
                                                            phi_6011_ = type_18(_e3861, _e3859, _e3852);
                                                        }
                                                        let _e4012 = phi_6010_;
                                                        let _e4014 = phi_6011_;
                                                        phi_6012_ = _e4012;
                                                        phi_6013_ = _e4014;
                                                    }
                                                    let _e4016 = phi_6012_;
                                                    let _e4018 = phi_6013_;
                                                    phi_6014_ = _e4016;
                                                    phi_6015_ = _e4018;
                                                } else {
                                                    phi_6014_ = _e3792;
                                                    phi_6015_ = _e3712;
                                                }
                                                let _e4020 = phi_6014_;
                                                let _e4022 = phi_6015_;
                                                phi_6016_ = _e4020;
                                                phi_6017_ = _e4022;
                                                phi_6018_ = false;
                                            } else {
                                                phi_6016_ = bool();
                                                phi_6017_ = type_18();
                                                phi_6018_ = true;
                                            }
                                            let _e4024 = phi_6016_;
                                            let _e4026 = phi_6017_;
                                            let _e4028 = phi_6018_;
                                            phi_6019_ = _e4024;
                                            phi_6020_ = _e4026;
                                            phi_6021_ = _e4028;
                                        }
                                        let _e4030 = phi_6019_;
                                        let _e4032 = phi_6020_;
                                        let _e4034 = phi_6021_;
                                        if _e4034 {
                                            let _e4035 = select(_e2782, 31u, _e2786);
                                            let _e4038 = local_71;
                                            let _e4039 = select(_e4038, _e2794.member, _e2786);
                                            let _e4042 = local_72;
                                            let _e4043 = select(_e4042, _e2794.member_1, _e2786);
                                            let _e4045 = local_73;
                                            let _e4049 = local_74;
                                            let _e4056 = ((f32(bitcast<i32>(_e4045[0].member)) * 4294967300f) + f32(_e4049[0].member_1));
                                            let _e4058 = local_75;
                                            let _e4062 = local_76;
                                            let _e4069 = ((f32(bitcast<i32>(_e4058[1].member)) * 4294967300f) + f32(_e4062[1].member_1));
                                            let _e4071 = local_77;
                                            let _e4075 = local_78;
                                            let _e4082 = ((f32(bitcast<i32>(_e4071[2].member)) * 4294967300f) + f32(_e4075[2].member_1));
                                            let _e4084 = local_79;
                                            let _e4088 = local_80;
                                            let _e4095 = ((f32(bitcast<i32>(_e4084[3].member)) * 4294967300f) + f32(_e4088[3].member_1));
                                            phi_6062_ = type_14(0i, 6i);
                                            phi_6065_ = 1f;
                                            phi_6067_ = 0f;
                                            phi_6069_ = (_e4056 / (_e4056 - _e4095));
                                            loop {
                                                let _e4099 = phi_6062_;
                                                let _e4101 = phi_6065_;
                                                let _e4103 = phi_6067_;
                                                let _e4105 = phi_6069_;
                                                local_81 = _e4105;
                                                if (_e4099.member < _e4099.member_1) {
                                                    let _e4112 = (_e4099.member + 1i);
                                                    phi_6063_ = type_14(select(_e4112, type_15().member_1, select(false, true, ((false == (_e4112 > _e4099.member)) != false))), _e4099.member_1);
                                                    phi_6110_ = type_15(1u, _e4099.member);
                                                } else {
                                                    phi_6063_ = _e4099;
                                                    phi_6110_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e4123 = phi_6063_;
                                                let _e4125 = phi_6110_;
                                                let _e4128 = (bitcast<i32>(_e4125.member) != 0i);
                                                if _e4128 {
                                                    let _e4129 = function_7(_e4056, _e4069, _e4105);
                                                    let _e4130 = function_7(_e4069, _e4082, _e4105);
                                                    let _e4131 = function_7(_e4082, _e4095, _e4105);
                                                    let _e4132 = function_7(_e4129, _e4130, _e4105);
                                                    let _e4133 = function_7(_e4130, _e4131, _e4105);
                                                    let _e4134 = function_7(_e4132, _e4133, _e4105);
                                                    let _e4137 = ((_e4134 < 0f) == (_e4056 < 0f));
                                                    let _e4138 = select(_e4105, _e4101, _e4137);
                                                    let _e4139 = select(_e4103, _e4105, _e4137);
                                                    let _e4143 = (_e4105 - (_e4134 / (3f * (_e4133 - _e4132))));
                                                    phi_6066_ = _e4138;
                                                    phi_6068_ = _e4139;
                                                    phi_6070_ = select(_e4143, (0.5f * (_e4139 + _e4138)), select(true, select(true, false, (_e4143 <= _e4138)), (_e4143 >= _e4139)));
                                                } else {
                                                    phi_6066_ = f32();
                                                    phi_6068_ = f32();
                                                    phi_6070_ = f32();
                                                }
                                                let _e4152 = phi_6066_;
                                                let _e4154 = phi_6068_;
                                                let _e4156 = phi_6070_;
                                                continue;
                                                continuing {
                                                    phi_6062_ = _e4123;
                                                    phi_6065_ = _e4152;
                                                    phi_6067_ = _e4154;
                                                    phi_6069_ = _e4156;
                                                    break if !(_e4128);
                                                }
                                            }
                                            let _e4161 = (1u << bitcast<u32>(((31u - _e4035) & 31u)));
                                            let _e4162 = (_e4043 - _e4039);
                                            let _e4165 = local_81;
                                            let _e4166 = (_e4165 * f32(_e4162));
                                            let _e4171 = select(select(u32(_e4166), 0u, (_e4166 < 0f)), 4294967295u, (_e4166 > 4294967000f));
                                            let _e4173 = select(_e4171, _e4162, (_e4162 < _e4171));
                                            let _e4175 = (_e4161 / 2u);
                                            let _e4178 = ((_e4039 + _e4173) - select(_e4175, _e4173, (_e4173 < _e4175)));
                                            let _e4179 = (_e4178 + _e4161);
                                            let _e4181 = select(_e4179, _e4043, (_e4043 < _e4179));
                                            let _e4187 = function_1(((_e2665 - _e2592.member) - select(0u, 1u, (_e2661 < _e2592.member_1))), (_e2661 - _e2592.member_1), _e4178);
                                            let _e4190 = (_e2592.member_1 + _e4187.member_1);
                                            let _e4194 = ((_e2592.member + _e4187.member) + select(0u, 1u, (_e4190 < _e2592.member_1)));
                                            let _e4200 = function_1(((_e2736 - _e2665) - select(0u, 1u, (_e2732 < _e2661))), (_e2732 - _e2661), _e4178);
                                            let _e4203 = (_e2661 + _e4200.member_1);
                                            let _e4207 = ((_e2665 + _e4200.member) + select(0u, 1u, (_e4203 < _e2661)));
                                            let _e4213 = function_1(((_e2770.member - _e2736) - select(0u, 1u, (_e2770.member_1 < _e2732))), (_e2770.member_1 - _e2732), _e4178);
                                            let _e4216 = (_e2732 + _e4213.member_1);
                                            let _e4226 = function_1(((_e4207 - _e4194) - select(0u, 1u, (_e4203 < _e4190))), (_e4203 - _e4190), _e4178);
                                            let _e4229 = (_e4190 + _e4226.member_1);
                                            let _e4233 = ((_e4194 + _e4226.member) + select(0u, 1u, (_e4229 < _e4190)));
                                            let _e4239 = function_1(((((_e2736 + _e4213.member) + select(0u, 1u, (_e4216 < _e2732))) - _e4207) - select(0u, 1u, (_e4216 < _e4203))), (_e4216 - _e4203), _e4178);
                                            let _e4242 = (_e4203 + _e4239.member_1);
                                            let _e4252 = function_1(((((_e4207 + _e4239.member) + select(0u, 1u, (_e4242 < _e4203))) - _e4233) - select(0u, 1u, (_e4242 < _e4229))), (_e4242 - _e4229), _e4178);
                                            let _e4255 = (_e4229 + _e4252.member_1);
                                            let _e4259 = ((_e4233 + _e4252.member) + select(0u, 1u, (_e4255 < _e4229)));
                                            let _e4260 = function_8(128u);
                                            let _e4265 = ((_e4259 >> bitcast<u32>(31i)) != 0u);
                                            let _e4291 = function_1(((_e2665 - _e2592.member) - select(0u, 1u, (_e2661 < _e2592.member_1))), (_e2661 - _e2592.member_1), _e4181);
                                            let _e4294 = (_e2592.member_1 + _e4291.member_1);
                                            let _e4298 = ((_e2592.member + _e4291.member) + select(0u, 1u, (_e4294 < _e2592.member_1)));
                                            let _e4304 = function_1(((_e2736 - _e2665) - select(0u, 1u, (_e2732 < _e2661))), (_e2732 - _e2661), _e4181);
                                            let _e4307 = (_e2661 + _e4304.member_1);
                                            let _e4311 = ((_e2665 + _e4304.member) + select(0u, 1u, (_e4307 < _e2661)));
                                            let _e4317 = function_1(((_e2770.member - _e2736) - select(0u, 1u, (_e2770.member_1 < _e2732))), (_e2770.member_1 - _e2732), _e4181);
                                            let _e4320 = (_e2732 + _e4317.member_1);
                                            let _e4330 = function_1(((_e4311 - _e4298) - select(0u, 1u, (_e4307 < _e4294))), (_e4307 - _e4294), _e4181);
                                            let _e4333 = (_e4294 + _e4330.member_1);
                                            let _e4337 = ((_e4298 + _e4330.member) + select(0u, 1u, (_e4333 < _e4294)));
                                            let _e4343 = function_1(((((_e2736 + _e4317.member) + select(0u, 1u, (_e4320 < _e2732))) - _e4311) - select(0u, 1u, (_e4320 < _e4307))), (_e4320 - _e4307), _e4181);
                                            let _e4346 = (_e4307 + _e4343.member_1);
                                            let _e4356 = function_1(((((_e4311 + _e4343.member) + select(0u, 1u, (_e4346 < _e4307))) - _e4337) - select(0u, 1u, (_e4346 < _e4333))), (_e4346 - _e4333), _e4181);
                                            let _e4359 = (_e4333 + _e4356.member_1);
                                            let _e4363 = ((_e4337 + _e4356.member) + select(0u, 1u, (_e4359 < _e4333)));
                                            let _e4364 = function_8(128u);
                                            let _e4369 = ((_e4363 >> bitcast<u32>(31i)) != 0u);
                                            let _e4391 = ((select(0u, select(1u, 2u, ((_e4259 >> bitcast<u32>(31i)) != 0u)), ((((_e4260.member - select(_e4259, (~(_e4259) + select(0u, 1u, (_e4255 == 0u))), _e4265)) - select(0u, 1u, (_e4260.member_1 < select(_e4255, (~(_e4255) + 1u), _e4265)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4363 >> bitcast<u32>(31i)) != 0u)), ((((_e4364.member - select(_e4363, (~(_e4363) + select(0u, 1u, (_e4359 == 0u))), _e4369)) - select(0u, 1u, (_e4364.member_1 < select(_e4359, (~(_e4359) + 1u), _e4369)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e4394 = local_82;
                                            let _e4397 = local_83;
                                            let _e4400 = local_84;
                                            phi_6528_ = _e4391;
                                            phi_6529_ = true;
                                            phi_6530_ = _e4391;
                                            phi_6531_ = type_18(select(_e4394, _e4178, _e4391), select(_e4397, _e4181, _e4391), select(_e4400, _e4035, _e4391));
                                            phi_6532_ = type_18(_e4178, _e4181, _e4035);
                                        } else {
                                            phi_6528_ = _e2786;
                                            phi_6529_ = _e2788;
                                            phi_6530_ = _e4030;
                                            phi_6531_ = _e4032;
                                            phi_6532_ = _e2794;
                                        }
                                        let _e4404 = phi_6528_;
                                        let _e4406 = phi_6529_;
                                        let _e4408 = phi_6530_;
                                        let _e4410 = phi_6531_;
                                        let _e4412 = phi_6532_;
                                        phi_6533_ = _e4404;
                                        phi_6534_ = _e4406;
                                        phi_6535_ = _e4408;
                                        phi_6536_ = _e4410;
                                        phi_6537_ = _e4412;
                                    }
                                    let _e4420 = phi_6533_;
                                    let _e4422 = phi_6534_;
                                    let _e4424 = phi_6535_;
                                    let _e4426 = phi_6536_;
                                    let _e4428 = phi_6537_;
                                    let _e4447 = ((_e1843[0][1][0].member - _e1843[0][0][0].member) - select(0u, 1u, (_e1843[0][1][0].member_1 < _e1843[0][0][0].member_1)));
                                    let _e4448 = (_e1843[0][1][0].member_1 - _e1843[0][0][0].member_1);
                                    let _e4460 = ((_e1843[0][1][1].member - _e1843[0][0][1].member) - select(0u, 1u, (_e1843[0][1][1].member_1 < _e1843[0][0][1].member_1)));
                                    let _e4461 = (_e1843[0][1][1].member_1 - _e1843[0][0][1].member_1);
                                    let _e4473 = ((_e1843[0][1][2].member - _e1843[0][0][2].member) - select(0u, 1u, (_e1843[0][1][2].member_1 < _e1843[0][0][2].member_1)));
                                    let _e4474 = (_e1843[0][1][2].member_1 - _e1843[0][0][2].member_1);
                                    let _e4477 = ((_e4447 >> bitcast<u32>(31i)) != 0u);
                                    let _e4484 = select(_e4447, (~(_e4447) + select(0u, 1u, (_e4448 == 0u))), _e4477);
                                    let _e4485 = select(_e4448, (~(_e4448) + 1u), _e4477);
                                    let _e4488 = ((_e4460 >> bitcast<u32>(31i)) != 0u);
                                    let _e4495 = select(_e4460, (~(_e4460) + select(0u, 1u, (_e4461 == 0u))), _e4488);
                                    let _e4496 = select(_e4461, (~(_e4461) + 1u), _e4488);
                                    let _e4503 = ((((_e4495 - _e4484) - select(0u, 1u, (_e4496 < _e4485))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4504 = select(_e4495, _e4484, _e4503);
                                    let _e4505 = select(_e4496, _e4485, _e4503);
                                    let _e4508 = ((_e4473 >> bitcast<u32>(31i)) != 0u);
                                    let _e4515 = select(_e4473, (~(_e4473) + select(0u, 1u, (_e4474 == 0u))), _e4508);
                                    let _e4516 = select(_e4474, (~(_e4474) + 1u), _e4508);
                                    let _e4523 = ((((_e4515 - _e4504) - select(0u, 1u, (_e4516 < _e4505))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4525 = select(_e4516, _e4505, _e4523);
                                    let _e4526 = function_8(4u);
                                    let _e4529 = (_e4525 + _e4526.member_1);
                                    let _e4533 = ((select(_e4515, _e4504, _e4523) + _e4526.member) + select(0u, 1u, (_e4529 < _e4525)));
                                    let _e4548 = ((_e4529 >> bitcast<u32>((_e4426.member_2 & 31u))) | ((_e4533 << bitcast<u32>(((31u - _e4426.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4549 = function_8(4u);
                                    let _e4552 = (_e4548 + _e4549.member_1);
                                    let _e4570 = ((_e1843[1][1][0].member - _e1843[1][0][0].member) - select(0u, 1u, (_e1843[1][1][0].member_1 < _e1843[1][0][0].member_1)));
                                    let _e4571 = (_e1843[1][1][0].member_1 - _e1843[1][0][0].member_1);
                                    let _e4583 = ((_e1843[1][1][1].member - _e1843[1][0][1].member) - select(0u, 1u, (_e1843[1][1][1].member_1 < _e1843[1][0][1].member_1)));
                                    let _e4584 = (_e1843[1][1][1].member_1 - _e1843[1][0][1].member_1);
                                    let _e4596 = ((_e1843[1][1][2].member - _e1843[1][0][2].member) - select(0u, 1u, (_e1843[1][1][2].member_1 < _e1843[1][0][2].member_1)));
                                    let _e4597 = (_e1843[1][1][2].member_1 - _e1843[1][0][2].member_1);
                                    let _e4600 = ((_e4570 >> bitcast<u32>(31i)) != 0u);
                                    let _e4607 = select(_e4570, (~(_e4570) + select(0u, 1u, (_e4571 == 0u))), _e4600);
                                    let _e4608 = select(_e4571, (~(_e4571) + 1u), _e4600);
                                    let _e4611 = ((_e4583 >> bitcast<u32>(31i)) != 0u);
                                    let _e4618 = select(_e4583, (~(_e4583) + select(0u, 1u, (_e4584 == 0u))), _e4611);
                                    let _e4619 = select(_e4584, (~(_e4584) + 1u), _e4611);
                                    let _e4626 = ((((_e4618 - _e4607) - select(0u, 1u, (_e4619 < _e4608))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4627 = select(_e4618, _e4607, _e4626);
                                    let _e4628 = select(_e4619, _e4608, _e4626);
                                    let _e4631 = ((_e4596 >> bitcast<u32>(31i)) != 0u);
                                    let _e4638 = select(_e4596, (~(_e4596) + select(0u, 1u, (_e4597 == 0u))), _e4631);
                                    let _e4639 = select(_e4597, (~(_e4597) + 1u), _e4631);
                                    let _e4646 = ((((_e4638 - _e4627) - select(0u, 1u, (_e4639 < _e4628))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4648 = select(_e4639, _e4628, _e4646);
                                    let _e4649 = function_8(4u);
                                    let _e4652 = (_e4648 + _e4649.member_1);
                                    let _e4656 = ((select(_e4638, _e4627, _e4646) + _e4649.member) + select(0u, 1u, (_e4652 < _e4648)));
                                    let _e4671 = ((_e4652 >> bitcast<u32>((_e4426.member_2 & 31u))) | ((_e4656 << bitcast<u32>(((31u - _e4426.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4672 = function_8(4u);
                                    let _e4675 = (_e4671 + _e4672.member_1);
                                    let _e4693 = ((_e1843[2][1][0].member - _e1843[2][0][0].member) - select(0u, 1u, (_e1843[2][1][0].member_1 < _e1843[2][0][0].member_1)));
                                    let _e4694 = (_e1843[2][1][0].member_1 - _e1843[2][0][0].member_1);
                                    let _e4706 = ((_e1843[2][1][1].member - _e1843[2][0][1].member) - select(0u, 1u, (_e1843[2][1][1].member_1 < _e1843[2][0][1].member_1)));
                                    let _e4707 = (_e1843[2][1][1].member_1 - _e1843[2][0][1].member_1);
                                    let _e4719 = ((_e1843[2][1][2].member - _e1843[2][0][2].member) - select(0u, 1u, (_e1843[2][1][2].member_1 < _e1843[2][0][2].member_1)));
                                    let _e4720 = (_e1843[2][1][2].member_1 - _e1843[2][0][2].member_1);
                                    let _e4723 = ((_e4693 >> bitcast<u32>(31i)) != 0u);
                                    let _e4730 = select(_e4693, (~(_e4693) + select(0u, 1u, (_e4694 == 0u))), _e4723);
                                    let _e4731 = select(_e4694, (~(_e4694) + 1u), _e4723);
                                    let _e4734 = ((_e4706 >> bitcast<u32>(31i)) != 0u);
                                    let _e4741 = select(_e4706, (~(_e4706) + select(0u, 1u, (_e4707 == 0u))), _e4734);
                                    let _e4742 = select(_e4707, (~(_e4707) + 1u), _e4734);
                                    let _e4749 = ((((_e4741 - _e4730) - select(0u, 1u, (_e4742 < _e4731))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4750 = select(_e4741, _e4730, _e4749);
                                    let _e4751 = select(_e4742, _e4731, _e4749);
                                    let _e4754 = ((_e4719 >> bitcast<u32>(31i)) != 0u);
                                    let _e4761 = select(_e4719, (~(_e4719) + select(0u, 1u, (_e4720 == 0u))), _e4754);
                                    let _e4762 = select(_e4720, (~(_e4720) + 1u), _e4754);
                                    let _e4769 = ((((_e4761 - _e4750) - select(0u, 1u, (_e4762 < _e4751))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4771 = select(_e4762, _e4751, _e4769);
                                    let _e4772 = function_8(4u);
                                    let _e4775 = (_e4771 + _e4772.member_1);
                                    let _e4779 = ((select(_e4761, _e4750, _e4769) + _e4772.member) + select(0u, 1u, (_e4775 < _e4771)));
                                    let _e4794 = ((_e4775 >> bitcast<u32>((_e4426.member_2 & 31u))) | ((_e4779 << bitcast<u32>(((31u - _e4426.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4795 = function_8(4u);
                                    let _e4798 = (_e4794 + _e4795.member_1);
                                    local_6[0u].member = ((bitcast<u32>((bitcast<i32>(_e4533) >> bitcast<u32>((_e4426.member_2 & 31u)))) + _e4549.member) + select(0u, 1u, (_e4552 < _e4548)));
                                    local_6[0u].member_1 = _e4552;
                                    local_6[1u].member = ((bitcast<u32>((bitcast<i32>(_e4656) >> bitcast<u32>((_e4426.member_2 & 31u)))) + _e4672.member) + select(0u, 1u, (_e4675 < _e4671)));
                                    local_6[1u].member_1 = _e4675;
                                    local_6[2u].member = ((bitcast<u32>((bitcast<i32>(_e4779) >> bitcast<u32>((_e4426.member_2 & 31u)))) + _e4795.member) + select(0u, 1u, (_e4798 < _e4794)));
                                    local_6[2u].member_1 = _e4798;
                                    let _e4828 = function_1(((_e1843[0][1][0].member - _e1843[0][0][0].member) - select(0u, 1u, (_e1843[0][1][0].member_1 < _e1843[0][0][0].member_1))), (_e1843[0][1][0].member_1 - _e1843[0][0][0].member_1), _e4426.member);
                                    let _e4831 = (_e1843[0][0][0].member_1 + _e4828.member_1);
                                    let _e4835 = ((_e1843[0][0][0].member + _e4828.member) + select(0u, 1u, (_e4831 < _e1843[0][0][0].member_1)));
                                    let _e4849 = function_1(((_e1843[0][1][1].member - _e1843[0][0][1].member) - select(0u, 1u, (_e1843[0][1][1].member_1 < _e1843[0][0][1].member_1))), (_e1843[0][1][1].member_1 - _e1843[0][0][1].member_1), _e4426.member);
                                    let _e4852 = (_e1843[0][0][1].member_1 + _e4849.member_1);
                                    let _e4856 = ((_e1843[0][0][1].member + _e4849.member) + select(0u, 1u, (_e4852 < _e1843[0][0][1].member_1)));
                                    let _e4870 = function_1(((_e1843[0][1][2].member - _e1843[0][0][2].member) - select(0u, 1u, (_e1843[0][1][2].member_1 < _e1843[0][0][2].member_1))), (_e1843[0][1][2].member_1 - _e1843[0][0][2].member_1), _e4426.member);
                                    let _e4873 = (_e1843[0][0][2].member_1 + _e4870.member_1);
                                    let _e4877 = ((_e1843[0][0][2].member + _e4870.member) + select(0u, 1u, (_e4873 < _e1843[0][0][2].member_1)));
                                    let _e4893 = function_1(((_e1843[1][1][0].member - _e1843[1][0][0].member) - select(0u, 1u, (_e1843[1][1][0].member_1 < _e1843[1][0][0].member_1))), (_e1843[1][1][0].member_1 - _e1843[1][0][0].member_1), _e4426.member);
                                    let _e4896 = (_e1843[1][0][0].member_1 + _e4893.member_1);
                                    let _e4900 = ((_e1843[1][0][0].member + _e4893.member) + select(0u, 1u, (_e4896 < _e1843[1][0][0].member_1)));
                                    let _e4914 = function_1(((_e1843[1][1][1].member - _e1843[1][0][1].member) - select(0u, 1u, (_e1843[1][1][1].member_1 < _e1843[1][0][1].member_1))), (_e1843[1][1][1].member_1 - _e1843[1][0][1].member_1), _e4426.member);
                                    let _e4917 = (_e1843[1][0][1].member_1 + _e4914.member_1);
                                    let _e4921 = ((_e1843[1][0][1].member + _e4914.member) + select(0u, 1u, (_e4917 < _e1843[1][0][1].member_1)));
                                    let _e4935 = function_1(((_e1843[1][1][2].member - _e1843[1][0][2].member) - select(0u, 1u, (_e1843[1][1][2].member_1 < _e1843[1][0][2].member_1))), (_e1843[1][1][2].member_1 - _e1843[1][0][2].member_1), _e4426.member);
                                    let _e4938 = (_e1843[1][0][2].member_1 + _e4935.member_1);
                                    let _e4942 = ((_e1843[1][0][2].member + _e4935.member) + select(0u, 1u, (_e4938 < _e1843[1][0][2].member_1)));
                                    let _e4958 = function_1(((_e1843[2][1][0].member - _e1843[2][0][0].member) - select(0u, 1u, (_e1843[2][1][0].member_1 < _e1843[2][0][0].member_1))), (_e1843[2][1][0].member_1 - _e1843[2][0][0].member_1), _e4426.member);
                                    let _e4961 = (_e1843[2][0][0].member_1 + _e4958.member_1);
                                    let _e4965 = ((_e1843[2][0][0].member + _e4958.member) + select(0u, 1u, (_e4961 < _e1843[2][0][0].member_1)));
                                    let _e4979 = function_1(((_e1843[2][1][1].member - _e1843[2][0][1].member) - select(0u, 1u, (_e1843[2][1][1].member_1 < _e1843[2][0][1].member_1))), (_e1843[2][1][1].member_1 - _e1843[2][0][1].member_1), _e4426.member);
                                    let _e4982 = (_e1843[2][0][1].member_1 + _e4979.member_1);
                                    let _e4986 = ((_e1843[2][0][1].member + _e4979.member) + select(0u, 1u, (_e4982 < _e1843[2][0][1].member_1)));
                                    let _e5000 = function_1(((_e1843[2][1][2].member - _e1843[2][0][2].member) - select(0u, 1u, (_e1843[2][1][2].member_1 < _e1843[2][0][2].member_1))), (_e1843[2][1][2].member_1 - _e1843[2][0][2].member_1), _e4426.member);
                                    let _e5003 = (_e1843[2][0][2].member_1 + _e5000.member_1);
                                    let _e5007 = ((_e1843[2][0][2].member + _e5000.member) + select(0u, 1u, (_e5003 < _e1843[2][0][2].member_1)));
                                    local_4 = array<type_9, 3>(type_9(_e4900, _e4896), type_9(_e4921, _e4917), type_9(_e4942, _e4938));
                                    local_5 = array<type_9, 3>(type_9(_e4965, _e4961), type_9(_e4986, _e4982), type_9(_e5007, _e5003));
                                    let _e5018 = local_4[1u].member;
                                    let _e5020 = local_4[1u].member_1;
                                    let _e5023 = local_5[2u].member;
                                    let _e5025 = local_5[2u].member_1;
                                    let _e5026 = function_5(_e5018, _e5020, _e5023, _e5025);
                                    let _e5031 = local_4[2u].member;
                                    let _e5033 = local_4[2u].member_1;
                                    let _e5036 = local_5[1u].member;
                                    let _e5038 = local_5[1u].member_1;
                                    let _e5039 = function_5(_e5031, _e5033, _e5036, _e5038);
                                    let _e5045 = ((_e5026.member - _e5039.member) - select(0u, 1u, (_e5026.member_1 < _e5039.member_1)));
                                    let _e5046 = (_e5026.member_1 - _e5039.member_1);
                                    local_2 = array<type_9, 3>(type_9(_e4900, _e4896), type_9(_e4921, _e4917), type_9(_e4942, _e4938));
                                    local_3 = array<type_9, 3>(type_9(_e4965, _e4961), type_9(_e4986, _e4982), type_9(_e5007, _e5003));
                                    let _e5057 = local_2[2u].member;
                                    let _e5059 = local_2[2u].member_1;
                                    let _e5062 = local_3[0u].member;
                                    let _e5064 = local_3[0u].member_1;
                                    let _e5065 = function_5(_e5057, _e5059, _e5062, _e5064);
                                    let _e5070 = local_2[0u].member;
                                    let _e5072 = local_2[0u].member_1;
                                    let _e5075 = local_3[2u].member;
                                    let _e5077 = local_3[2u].member_1;
                                    let _e5078 = function_5(_e5070, _e5072, _e5075, _e5077);
                                    let _e5084 = ((_e5065.member - _e5078.member) - select(0u, 1u, (_e5065.member_1 < _e5078.member_1)));
                                    let _e5085 = (_e5065.member_1 - _e5078.member_1);
                                    local = array<type_9, 3>(type_9(_e4900, _e4896), type_9(_e4921, _e4917), type_9(_e4942, _e4938));
                                    local_1 = array<type_9, 3>(type_9(_e4965, _e4961), type_9(_e4986, _e4982), type_9(_e5007, _e5003));
                                    let _e5096 = local[0u].member;
                                    let _e5098 = local[0u].member_1;
                                    let _e5101 = local_1[1u].member;
                                    let _e5103 = local_1[1u].member_1;
                                    let _e5104 = function_5(_e5096, _e5098, _e5101, _e5103);
                                    let _e5109 = local[1u].member;
                                    let _e5111 = local[1u].member_1;
                                    let _e5114 = local_1[0u].member;
                                    let _e5116 = local_1[0u].member_1;
                                    let _e5117 = function_5(_e5109, _e5111, _e5114, _e5116);
                                    let _e5123 = ((_e5104.member - _e5117.member) - select(0u, 1u, (_e5104.member_1 < _e5117.member_1)));
                                    let _e5124 = (_e5104.member_1 - _e5117.member_1);
                                    let _e5127 = ((_e5045 >> bitcast<u32>(31i)) != 0u);
                                    let _e5134 = select(_e5045, (~(_e5045) + select(0u, 1u, (_e5046 == 0u))), _e5127);
                                    let _e5135 = select(_e5046, (~(_e5046) + 1u), _e5127);
                                    let _e5138 = ((_e5084 >> bitcast<u32>(31i)) != 0u);
                                    let _e5145 = select(_e5084, (~(_e5084) + select(0u, 1u, (_e5085 == 0u))), _e5138);
                                    let _e5146 = select(_e5085, (~(_e5085) + 1u), _e5138);
                                    let _e5149 = ((_e5123 >> bitcast<u32>(31i)) != 0u);
                                    let _e5156 = select(_e5123, (~(_e5123) + select(0u, 1u, (_e5124 == 0u))), _e5149);
                                    let _e5157 = select(_e5124, (~(_e5124) + 1u), _e5149);
                                    let _e5182 = select(0i, select(2i, 1i, ((((_e5156 - _e5145) - select(0u, 1u, (_e5157 < _e5146))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e5156 - _e5134) - select(0u, 1u, (_e5157 < _e5135))) >> bitcast<u32>(31i)) != 0u)), ((((_e5145 - _e5134) - select(0u, 1u, (_e5146 < _e5135))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e5182 {
                                        case 0: {
                                            phi_7684_ = array<type_9, 2>(type_9(_e4856, _e4852), type_9(_e4877, _e4873));
                                            break;
                                        }
                                        case 1: {
                                            phi_7684_ = array<type_9, 2>(type_9(_e4877, _e4873), type_9(_e4835, _e4831));
                                            break;
                                        }
                                        default: {
                                            phi_7684_ = array<type_9, 2>(type_9(_e4835, _e4831), type_9(_e4856, _e4852));
                                            break;
                                        }
                                    }
                                    let _e5193 = phi_7684_;
                                    switch _e5182 {
                                        case 0: {
                                            phi_7713_ = array<type_9, 2>(type_9(_e4921, _e4917), type_9(_e4942, _e4938));
                                            break;
                                        }
                                        case 1: {
                                            phi_7713_ = array<type_9, 2>(type_9(_e4942, _e4938), type_9(_e4900, _e4896));
                                            break;
                                        }
                                        default: {
                                            phi_7713_ = array<type_9, 2>(type_9(_e4900, _e4896), type_9(_e4921, _e4917));
                                            break;
                                        }
                                    }
                                    let _e5204 = phi_7713_;
                                    switch _e5182 {
                                        case 0: {
                                            phi_7742_ = array<type_9, 2>(type_9(_e4986, _e4982), type_9(_e5007, _e5003));
                                            break;
                                        }
                                        case 1: {
                                            phi_7742_ = array<type_9, 2>(type_9(_e5007, _e5003), type_9(_e4965, _e4961));
                                            break;
                                        }
                                        default: {
                                            phi_7742_ = array<type_9, 2>(type_9(_e4965, _e4961), type_9(_e4986, _e4982));
                                            break;
                                        }
                                    }
                                    let _e5215 = phi_7742_;
                                    switch _e5182 {
                                        case 0: {
                                            phi_7756_ = type_9(_e5045, _e5046);
                                            break;
                                        }
                                        case 1: {
                                            phi_7756_ = type_9(_e5084, _e5085);
                                            break;
                                        }
                                        default: {
                                            phi_7756_ = type_9(_e5123, _e5124);
                                            break;
                                        }
                                    }
                                    let _e5220 = phi_7756_;
                                    let _e5223 = local_6[1u].member;
                                    let _e5225 = local_6[1u].member_1;
                                    let _e5228 = local_6[2u].member;
                                    let _e5230 = local_6[2u].member_1;
                                    let _e5231 = (_e5225 + _e5230);
                                    let _e5235 = ((_e5223 + _e5228) + select(0u, 1u, (_e5231 < _e5225)));
                                    let _e5246 = ((_e5231 >> bitcast<u32>(1u)) | ((_e5235 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5247 = function_8(17u);
                                    let _e5250 = (_e5246 + _e5247.member_1);
                                    let _e5254 = ((bitcast<u32>((bitcast<i32>(_e5235) >> bitcast<u32>(1u))) + _e5247.member) + select(0u, 1u, (_e5250 < _e5246)));
                                    let _e5257 = local_6[0u].member;
                                    let _e5259 = local_6[0u].member_1;
                                    let _e5262 = local_6[2u].member;
                                    let _e5264 = local_6[2u].member_1;
                                    let _e5265 = (_e5259 + _e5264);
                                    let _e5269 = ((_e5257 + _e5262) + select(0u, 1u, (_e5265 < _e5259)));
                                    let _e5280 = ((_e5265 >> bitcast<u32>(1u)) | ((_e5269 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5281 = function_8(17u);
                                    let _e5284 = (_e5280 + _e5281.member_1);
                                    let _e5288 = ((bitcast<u32>((bitcast<i32>(_e5269) >> bitcast<u32>(1u))) + _e5281.member) + select(0u, 1u, (_e5284 < _e5280)));
                                    let _e5291 = local_6[0u].member;
                                    let _e5293 = local_6[0u].member_1;
                                    let _e5296 = local_6[1u].member;
                                    let _e5298 = local_6[1u].member_1;
                                    let _e5299 = (_e5293 + _e5298);
                                    let _e5303 = ((_e5291 + _e5296) + select(0u, 1u, (_e5299 < _e5293)));
                                    let _e5314 = ((_e5299 >> bitcast<u32>(1u)) | ((_e5303 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5315 = function_8(17u);
                                    let _e5318 = (_e5314 + _e5315.member_1);
                                    let _e5322 = ((bitcast<u32>((bitcast<i32>(_e5303) >> bitcast<u32>(1u))) + _e5315.member) + select(0u, 1u, (_e5318 < _e5314)));
                                    let _e5327 = ((_e5220.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e5254 - select(_e5220.member, (~(_e5220.member) + select(0u, 1u, (_e5220.member_1 == 0u))), _e5327)) - select(0u, 1u, (_e5250 < select(_e5220.member_1, (~(_e5220.member_1) + 1u), _e5327)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e5348 = ((_e5220.member >> bitcast<u32>(31i)) != 0u);
                                        let _e5358 = select(_e5220.member, (~(_e5220.member) + select(0u, 1u, (_e5220.member_1 == 0u))), _e5348);
                                        let _e5360 = select(_e5220.member_1, (~(_e5220.member_1) + 1u), _e5348);
                                        let _e5361 = function_6(_e5193, _e5215);
                                        let _e5371 = select(_e5361.member, (~(_e5361.member) + select(0u, 1u, (_e5361.member_1 == 0u))), _e5348);
                                        let _e5373 = select(_e5361.member_1, (~(_e5361.member_1) + 1u), _e5348);
                                        let _e5374 = function_6(_e5204, _e5193);
                                        let _e5384 = select(_e5374.member, (~(_e5374.member) + select(0u, 1u, (_e5374.member_1 == 0u))), _e5348);
                                        let _e5386 = select(_e5374.member_1, (~(_e5374.member_1) + 1u), _e5348);
                                        if (_e238.member != 0u) {
                                            let _e5418 = (_e5250 + _e5284);
                                            let _e5430 = (_e5250 + _e5318);
                                            phi_8078_ = type_9(((_e5254 + _e5322) + select(0u, 1u, (_e5430 < _e5250))), _e5430);
                                            phi_8079_ = type_9(((_e5358 - _e5384) - select(0u, 1u, (_e5360 < _e5386))), (_e5360 - _e5386));
                                            phi_8080_ = type_9(((_e5254 + _e5288) + select(0u, 1u, (_e5418 < _e5250))), _e5418);
                                            phi_8081_ = type_9(((_e5358 - _e5371) - select(0u, 1u, (_e5360 < _e5373))), (_e5360 - _e5373));
                                        } else {
                                            let _e5392 = (_e5360 - _e5373);
                                            let _e5396 = ((((_e5358 - _e5371) - select(0u, 1u, (_e5360 < _e5373))) - _e5384) - select(0u, 1u, (_e5392 < _e5386)));
                                            let _e5397 = (_e5392 - _e5386);
                                            let _e5399 = (_e5250 + _e5284);
                                            let _e5404 = (_e5399 + _e5318);
                                            let _e5408 = ((((_e5254 + _e5288) + select(0u, 1u, (_e5399 < _e5250))) + _e5322) + select(0u, 1u, (_e5404 < _e5399)));
                                            phi_8078_ = type_9(_e5408, _e5404);
                                            phi_8079_ = type_9(_e5396, _e5397);
                                            phi_8080_ = type_9(_e5408, _e5404);
                                            phi_8081_ = type_9(_e5396, _e5397);
                                        }
                                        let _e5437 = phi_8078_;
                                        let _e5439 = phi_8079_;
                                        let _e5441 = phi_8080_;
                                        let _e5443 = phi_8081_;
                                        let _e5444 = function_4(_e5371, _e5373, _e5288, _e5284);
                                        if _e5444 {
                                            phi_8207_ = u32();
                                            phi_8208_ = true;
                                        } else {
                                            let _e5445 = function_4(_e5384, _e5386, _e5322, _e5318);
                                            if _e5445 {
                                                phi_8205_ = u32();
                                                phi_8206_ = true;
                                            } else {
                                                let _e5450 = function_4(_e5443.member, _e5443.member_1, _e5441.member, _e5441.member_1);
                                                if _e5450 {
                                                    phi_8203_ = u32();
                                                    phi_8204_ = true;
                                                } else {
                                                    let _e5455 = function_4(_e5439.member, _e5439.member_1, _e5437.member, _e5437.member_1);
                                                    if _e5455 {
                                                        phi_8202_ = u32();
                                                    } else {
                                                        let _e5456 = function_3(_e5371, _e5373, _e5288, _e5284);
                                                        if _e5456 {
                                                            let _e5457 = function_3(_e5384, _e5386, _e5322, _e5318);
                                                            if _e5457 {
                                                                let _e5462 = function_3(_e5443.member, _e5443.member_1, _e5441.member, _e5441.member_1);
                                                                if _e5462 {
                                                                    let _e5467 = function_3(_e5439.member, _e5439.member_1, _e5437.member, _e5437.member_1);
                                                                    phi_8195_ = select(true, false, _e5467);
                                                                } else {
                                                                    phi_8195_ = true;
                                                                }
                                                                let _e5470 = phi_8195_;
                                                                phi_8196_ = _e5470;
                                                            } else {
                                                                phi_8196_ = true;
                                                            }
                                                            let _e5472 = phi_8196_;
                                                            phi_8197_ = _e5472;
                                                        } else {
                                                            phi_8197_ = true;
                                                        }
                                                        let _e5474 = phi_8197_;
                                                        phi_8202_ = select(0u, 2u, _e5474);
                                                    }
                                                    let _e5477 = phi_8202_;
                                                    phi_8203_ = _e5477;
                                                    phi_8204_ = _e5455;
                                                }
                                                let _e5479 = phi_8203_;
                                                let _e5481 = phi_8204_;
                                                phi_8205_ = _e5479;
                                                phi_8206_ = _e5481;
                                            }
                                            let _e5483 = phi_8205_;
                                            let _e5485 = phi_8206_;
                                            phi_8207_ = _e5483;
                                            phi_8208_ = _e5485;
                                        }
                                        let _e5487 = phi_8207_;
                                        let _e5489 = phi_8208_;
                                        phi_8213_ = select(_e5487, 1u, _e5489);
                                    } else {
                                        phi_8213_ = 2u;
                                    }
                                    let _e5492 = phi_8213_;
                                    let _e5493 = (_e5492 == 1u);
                                    let _e5494 = (_e5492 == 0u);
                                    let _e5510 = local_87;
                                    if _e5510 {
                                        let _e6403 = local_109;
                                        phi_8285_ = _e6403;
                                        phi_8286_ = _e5493;
                                        phi_8287_ = select(true, false, _e5493);
                                        phi_8288_ = false;
                                        phi_8289_ = false;
                                    } else {
                                        let _e5514 = select(true, select(true, select(true, select(true, false, ((_e4426.member_1 - _e4426.member) <= _e1268)), select(false, (_e4426.member_1 <= _e1266), (_e4426.member >= _e1264))), _e4424), _e5494);
                                        let _e5516 = select(select(false, select((_e4426.member > _e1266), true, (_e4426.member_1 < _e1264)), _e4420), true, _e5493);
                                        let _e5517 = select(true, _e5516, select(((((select(0u, select(1u, 2u, ((_e3542[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3549.member - select(_e3562[0].member, (~(_e3542[0].member) + select(0u, 1u, (_e3546[0].member_1 == 0u))), _e3554)) - select(0u, 1u, (_e3549.member_1 < select(_e3562[0].member_1, (~(_e3546[0].member_1) + 1u), _e3554)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3581[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3588.member - select(_e3601[1].member, (~(_e3581[1].member) + select(0u, 1u, (_e3585[1].member_1 == 0u))), _e3593)) - select(0u, 1u, (_e3588.member_1 < select(_e3601[1].member_1, (~(_e3585[1].member_1) + 1u), _e3593)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3621[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3628.member - select(_e3641[2].member, (~(_e3621[2].member) + select(0u, 1u, (_e3625[2].member_1 == 0u))), _e3633)) - select(0u, 1u, (_e3628.member_1 < select(_e3641[2].member_1, (~(_e3625[2].member_1) + 1u), _e3633)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3661[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3668.member - select(_e3681[3].member, (~(_e3661[3].member) + select(0u, 1u, (_e3665[3].member_1 == 0u))), _e3673)) - select(0u, 1u, (_e3668.member_1 < select(_e3681[3].member_1, (~(_e3665[3].member_1) + 1u), _e3673)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e3702 == 31u), true, _e2786)));
                                        phi_8285_ = select(bool(), _e5516, _e5514);
                                        phi_8286_ = select(false, _e5517, _e5514);
                                        phi_8287_ = false;
                                        phi_8288_ = select(false, select(true, false, _e5517), _e5514);
                                        phi_8289_ = select(true, false, _e5514);
                                    }
                                    let _e5525 = phi_8285_;
                                    let _e5527 = phi_8286_;
                                    let _e5529 = phi_8287_;
                                    let _e5531 = phi_8288_;
                                    let _e5533 = phi_8289_;
                                    phi_8296_ = _e4420;
                                    phi_8297_ = _e4422;
                                    phi_8298_ = true;
                                    phi_8299_ = !(_e3794);
                                    phi_8300_ = _e4428;
                                    phi_8301_ = _e5525;
                                    phi_8302_ = _e5494;
                                    phi_8303_ = _e4426;
                                    phi_8304_ = _e5527;
                                    phi_8305_ = select(_e5529, false, _e5527);
                                    phi_8306_ = select(_e5531, false, _e5527);
                                    phi_8307_ = select(_e5533, false, _e5527);
                                }
                                let _e5538 = phi_8296_;
                                let _e5540 = phi_8297_;
                                let _e5542 = phi_8298_;
                                let _e5544 = phi_8299_;
                                let _e5546 = phi_8300_;
                                let _e5548 = phi_8301_;
                                let _e5550 = phi_8302_;
                                let _e5552 = phi_8303_;
                                let _e5554 = phi_8304_;
                                let _e5556 = phi_8305_;
                                let _e5558 = phi_8306_;
                                let _e5560 = phi_8307_;
                                phi_8308_ = _e5538;
                                phi_8309_ = _e5540;
                                phi_8310_ = _e5542;
                                phi_8311_ = _e5544;
                                phi_8312_ = _e5546;
                                phi_8313_ = _e5548;
                                phi_8314_ = _e5550;
                                phi_8315_ = _e5552;
                                phi_8316_ = _e5554;
                                phi_8317_ = _e5556;
                                phi_8318_ = _e5558;
                                phi_8319_ = _e5560;
                            } else {
                                phi_8308_ = _e2786;
                                phi_8309_ = _e2788;
                                let _e6430 = local_113;
                                phi_8310_ = _e6430;
                                let _e6433 = local_114;
                                phi_8311_ = _e6433;
                                phi_8312_ = _e2794;
                                let _e6437 = local_115;
                                phi_8313_ = _e6437;
                                phi_8314_ = bool();
                                phi_8315_ = type_18();
                                phi_8316_ = true;
                                phi_8317_ = false;
                                phi_8318_ = false;
                                phi_8319_ = false;
                            }
                            let _e5562 = phi_8308_;
                            let _e5564 = phi_8309_;
                            let _e5566 = phi_8310_;
                            let _e5568 = phi_8311_;
                            let _e5570 = phi_8312_;
                            let _e5572 = phi_8313_;
                            let _e5574 = phi_8314_;
                            let _e5576 = phi_8315_;
                            let _e5578 = phi_8316_;
                            let _e5580 = phi_8317_;
                            let _e5582 = phi_8318_;
                            let _e5584 = phi_8319_;
                            if _e5578 {
                                if _e5572 {
                                    let _e5588 = local_88;
                                    let _e5589 = (_e5588 + 1u);
                                    let _e5591 = local_89;
                                    let _e5593 = (_e5589 & (4294967295u - _e5591));
                                    let _e5599 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5593)), 32u, (_e5593 == 0u)));
                                    let _e5601 = local_90;
                                    let _e5604 = local_91;
                                    let _e5605 = select(_e5599, _e5604, (_e5601 < _e5599));
                                    let _e5608 = (_e5589 >> bitcast<u32>((_e5605 & 31u)));
                                    let _e5610 = local_92;
                                    let _e5611 = (_e5610 - _e5605);
                                    let _e5613 = local_93;
                                    let _e5614 = (_e5613 > _e1266);
                                    if _e5614 {
                                        phi_8370_ = u32();
                                        phi_8371_ = u32();
                                        phi_8372_ = false;
                                        phi_8373_ = false;
                                    } else {
                                        let _e5618 = select(true, select(true, false, (_e5611 == 0u)), (_e5608 == 1u));
                                        let _e5619 = (31u - _e5611);
                                        phi_8370_ = select(u32(), ((_e5608 + 1u) << bitcast<u32>((_e5619 & 31u))), _e5618);
                                        phi_8371_ = select(u32(), (_e5608 << bitcast<u32>((_e5619 & 31u))), _e5618);
                                        phi_8372_ = _e5618;
                                        phi_8373_ = select(true, false, _e5618);
                                    }
                                    let _e5631 = phi_8370_;
                                    let _e5633 = phi_8371_;
                                    let _e5635 = phi_8372_;
                                    let _e5637 = phi_8373_;
                                    phi_8374_ = _e5631;
                                    phi_8375_ = _e5633;
                                    phi_8376_ = false;
                                    phi_8377_ = false;
                                    phi_8378_ = false;
                                    phi_8379_ = false;
                                    phi_8380_ = _e5611;
                                    phi_8381_ = _e5608;
                                    phi_8382_ = _e5635;
                                    phi_8383_ = _e5614;
                                    phi_8384_ = _e5637;
                                } else {
                                    phi_8374_ = _e5570.member_1;
                                    phi_8375_ = _e5570.member;
                                    phi_8376_ = _e5562;
                                    phi_8377_ = _e5564;
                                    phi_8378_ = _e5566;
                                    phi_8379_ = _e5568;
                                    let _e6462 = local_116;
                                    phi_8380_ = _e6462;
                                    let _e6465 = local_117;
                                    phi_8381_ = _e6465;
                                    phi_8382_ = true;
                                    phi_8383_ = false;
                                    phi_8384_ = false;
                                }
                                let _e5639 = phi_8374_;
                                let _e5641 = phi_8375_;
                                let _e5643 = phi_8376_;
                                let _e5645 = phi_8377_;
                                let _e5647 = phi_8378_;
                                let _e5649 = phi_8379_;
                                let _e5651 = phi_8380_;
                                let _e5653 = phi_8381_;
                                let _e5655 = phi_8382_;
                                let _e5657 = phi_8383_;
                                let _e5659 = phi_8384_;
                                if _e5655 {
                                    if select(_e5643, true, _e5572) {
                                        let _e5666 = function_1(((_e2665 - _e2592.member) - select(0u, 1u, (_e2661 < _e2592.member_1))), (_e2661 - _e2592.member_1), _e5641);
                                        let _e5669 = (_e2592.member_1 + _e5666.member_1);
                                        let _e5679 = function_1(((_e2736 - _e2665) - select(0u, 1u, (_e2732 < _e2661))), (_e2732 - _e2661), _e5641);
                                        let _e5682 = (_e2661 + _e5679.member_1);
                                        let _e5692 = function_1(((_e2770.member - _e2736) - select(0u, 1u, (_e2770.member_1 < _e2732))), (_e2770.member_1 - _e2732), _e5641);
                                        let _e5695 = (_e2732 + _e5692.member_1);
                                        let _e5703 = array<type_9, 3>(type_9(((_e2592.member + _e5666.member) + select(0u, 1u, (_e5669 < _e2592.member_1))), _e5669), type_9(((_e2665 + _e5679.member) + select(0u, 1u, (_e5682 < _e2661))), _e5682), type_9(((_e2736 + _e5692.member) + select(0u, 1u, (_e5695 < _e2732))), _e5695));
                                        let _e5709 = function_1(((_e2665 - _e2592.member) - select(0u, 1u, (_e2661 < _e2592.member_1))), (_e2661 - _e2592.member_1), _e5639);
                                        let _e5712 = (_e2592.member_1 + _e5709.member_1);
                                        let _e5722 = function_1(((_e2736 - _e2665) - select(0u, 1u, (_e2732 < _e2661))), (_e2732 - _e2661), _e5639);
                                        let _e5725 = (_e2661 + _e5722.member_1);
                                        let _e5735 = function_1(((_e2770.member - _e2736) - select(0u, 1u, (_e2770.member_1 < _e2732))), (_e2770.member_1 - _e2732), _e5639);
                                        let _e5738 = (_e2732 + _e5735.member_1);
                                        let _e5747 = function_2(_e5703, _e5641);
                                        let _e5748 = function_2(_e5703, _e5639);
                                        let _e5749 = function_2(array<type_9, 3>(type_9(((_e2592.member + _e5709.member) + select(0u, 1u, (_e5712 < _e2592.member_1))), _e5712), type_9(((_e2665 + _e5722.member) + select(0u, 1u, (_e5725 < _e2661))), _e5725), type_9(((_e2736 + _e5735.member) + select(0u, 1u, (_e5738 < _e2732))), _e5738)), _e5639);
                                        let _e5763 = function_1(((_e5747[1].member - _e5747[0].member) - select(0u, 1u, (_e5747[1].member_1 < _e5747[0].member_1))), (_e5747[1].member_1 - _e5747[0].member_1), _e5641);
                                        let _e5766 = (_e5747[0].member_1 + _e5763.member_1);
                                        let _e5784 = function_1(((_e5747[1].member - _e5747[0].member) - select(0u, 1u, (_e5747[1].member_1 < _e5747[0].member_1))), (_e5747[1].member_1 - _e5747[0].member_1), _e5639);
                                        let _e5787 = (_e5747[0].member_1 + _e5784.member_1);
                                        let _e5805 = function_1(((_e5748[1].member - _e5748[0].member) - select(0u, 1u, (_e5748[1].member_1 < _e5748[0].member_1))), (_e5748[1].member_1 - _e5748[0].member_1), _e5639);
                                        let _e5808 = (_e5748[0].member_1 + _e5805.member_1);
                                        let _e5826 = function_1(((_e5749[1].member - _e5749[0].member) - select(0u, 1u, (_e5749[1].member_1 < _e5749[0].member_1))), (_e5749[1].member_1 - _e5749[0].member_1), _e5639);
                                        let _e5829 = (_e5749[0].member_1 + _e5826.member_1);
                                        phi_8651_ = array<type_9, 4>(type_9(((_e5747[0].member + _e5763.member) + select(0u, 1u, (_e5766 < _e5747[0].member_1))), _e5766), type_9(((_e5747[0].member + _e5784.member) + select(0u, 1u, (_e5787 < _e5747[0].member_1))), _e5787), type_9(((_e5748[0].member + _e5805.member) + select(0u, 1u, (_e5808 < _e5748[0].member_1))), _e5808), type_9(((_e5749[0].member + _e5826.member) + select(0u, 1u, (_e5829 < _e5749[0].member_1))), _e5829));
                                    } else {
                                        let _e6471 = local_118;
                                        phi_8651_ = _e6471;
                                    }
                                    let _e5840 = phi_8651_;
                                    phi_8652_ = _e5840;
                                    phi_8653_ = false;
                                    phi_8654_ = false;
                                } else {
                                    phi_8652_ = array<type_9, 4>();
                                    phi_8653_ = _e5657;
                                    phi_8654_ = _e5659;
                                }
                                let _e5842 = phi_8652_;
                                let _e5844 = phi_8653_;
                                let _e5846 = phi_8654_;
                                phi_8655_ = _e5842;
                                phi_8656_ = _e5643;
                                phi_8657_ = _e5645;
                                phi_8658_ = _e5647;
                                phi_8659_ = _e5649;
                                phi_8660_ = _e5651;
                                phi_8661_ = _e5653;
                                phi_8662_ = _e5655;
                                phi_8663_ = _e5844;
                                phi_8664_ = _e5846;
                                phi_8665_ = false;
                                phi_8666_ = false;
                                phi_8667_ = false;
                            } else {
                                phi_8655_ = array<type_9, 4>();
                                phi_8656_ = bool();
                                phi_8657_ = bool();
                                phi_8658_ = bool();
                                phi_8659_ = bool();
                                phi_8660_ = u32();
                                phi_8661_ = u32();
                                phi_8662_ = false;
                                phi_8663_ = false;
                                phi_8664_ = false;
                                phi_8665_ = _e5580;
                                phi_8666_ = _e5582;
                                phi_8667_ = _e5584;
                            }
                            let _e5848 = phi_8655_;
                            let _e5850 = phi_8656_;
                            let _e5852 = phi_8657_;
                            let _e5854 = phi_8658_;
                            let _e5856 = phi_8659_;
                            let _e5858 = phi_8660_;
                            let _e5860 = phi_8661_;
                            let _e5862 = phi_8662_;
                            let _e5864 = phi_8663_;
                            let _e5866 = phi_8664_;
                            let _e5868 = phi_8665_;
                            let _e5870 = phi_8666_;
                            let _e5872 = phi_8667_;
                            phi_4477_ = _e5848;
                            phi_4480_ = _e5850;
                            phi_4482_ = _e5852;
                            phi_4484_ = _e5854;
                            phi_4486_ = _e5856;
                            phi_4488_ = _e5570;
                            let _e6496 = local_119;
                            phi_4492_ = _e6496;
                            let _e6499 = local_120;
                            phi_4494_ = _e6499;
                            let _e6502 = local_121;
                            phi_4496_ = _e6502;
                            phi_4498_ = _e5858;
                            phi_4500_ = _e5860;
                            phi_8668_ = _e5574;
                            phi_8669_ = _e5576;
                            phi_8670_ = _e5862;
                            phi_8671_ = false;
                            phi_8672_ = _e5864;
                            phi_8673_ = _e5866;
                            phi_8674_ = _e5868;
                            phi_8675_ = _e5870;
                            phi_8676_ = _e5872;
                        } else {
                            phi_4477_ = array<type_9, 4>();
                            phi_4480_ = bool();
                            phi_4482_ = bool();
                            phi_4484_ = bool();
                            phi_4486_ = bool();
                            phi_4488_ = type_18();
                            phi_4492_ = u32();
                            phi_4494_ = u32();
                            phi_4496_ = u32();
                            phi_4498_ = u32();
                            phi_4500_ = u32();
                            phi_8668_ = bool();
                            phi_8669_ = type_18();
                            phi_8670_ = false;
                            phi_8671_ = true;
                            phi_8672_ = false;
                            phi_8673_ = false;
                            phi_8674_ = false;
                            phi_8675_ = false;
                            phi_8676_ = false;
                        }
                        let _e5874 = phi_4477_;
                        let _e5876 = phi_4480_;
                        let _e5878 = phi_4482_;
                        let _e5880 = phi_4484_;
                        let _e5882 = phi_4486_;
                        let _e5884 = phi_4488_;
                        let _e5886 = phi_4492_;
                        let _e5888 = phi_4494_;
                        let _e5890 = phi_4496_;
                        let _e5892 = phi_4498_;
                        let _e5894 = phi_4500_;
                        let _e5896 = phi_8668_;
                        let _e5898 = phi_8669_;
                        let _e5900 = phi_8670_;
                        let _e5902 = phi_8671_;
                        let _e5904 = phi_8672_;
                        let _e5906 = phi_8673_;
                        let _e5908 = phi_8674_;
                        let _e5910 = phi_8675_;
                        let _e5912 = phi_8676_;
                        local_94 = _e5902;
                        local_95 = _e5902;
                        local_96 = _e5902;
                        local_97 = _e5904;
                        local_98 = _e5902;
                        local_99 = _e5906;
                        local_100 = _e5902;
                        local_101 = _e5908;
                        local_102 = _e5902;
                        local_103 = _e5910;
                        local_104 = _e5902;
                        local_105 = _e5912;
                        local_106 = _e5896;
                        local_107 = _e5896;
                        local_108 = _e5898;
                        continue;
                        continuing {
                            phi_4476_ = _e5874;
                            phi_4479_ = _e5876;
                            phi_4481_ = _e5878;
                            phi_4483_ = _e5880;
                            phi_4485_ = _e5882;
                            phi_4487_ = _e5884;
                            phi_4491_ = _e5886;
                            phi_4493_ = _e5888;
                            phi_4495_ = _e5890;
                            phi_4497_ = _e5892;
                            phi_4499_ = _e5894;
                            break if !(_e5900);
                        }
                    }
                    let _e5916 = local_94;
                    let _e5921 = local_95;
                    let _e5924 = local_96;
                    let _e5926 = local_97;
                    let _e5927 = select(_e5926, false, _e5924);
                    let _e5929 = local_98;
                    let _e5931 = local_99;
                    let _e5934 = local_100;
                    let _e5936 = local_101;
                    let _e5939 = local_102;
                    let _e5941 = local_103;
                    let _e5944 = local_104;
                    let _e5946 = local_105;
                    let _e5948 = select(select(_e5931, false, _e5929), false, _e5927);
                    let _e5952 = select(_e5927, true, _e5948);
                    let _e5961 = select(select(select(select(_e5936, false, _e5934), false, _e5927), false, _e5948), false, _e5952);
                    if _e5961 {
                        let _e5965 = local_106;
                        let _e5970 = local_107;
                        phi_8718_ = type_9(select(2u, 3u, _e5965), select(type_9().member_1, type_9().member_1, _e5970));
                        phi_8719_ = false;
                        phi_8720_ = false;
                        phi_8721_ = false;
                    } else {
                        phi_8718_ = type_9();
                        phi_8719_ = select(select(select(select(_e5941, false, _e5939), false, _e5927), false, _e5948), false, _e5952);
                        phi_8720_ = select(select(select(select(_e5946, false, _e5944), false, _e5927), false, _e5948), false, _e5952);
                        phi_8721_ = _e5952;
                    }
                    let _e5974 = phi_8718_;
                    let _e5976 = phi_8719_;
                    let _e5978 = phi_8720_;
                    let _e5980 = phi_8721_;
                    let _e5986 = select(_e5978, false, _e5976);
                    let _e5990 = local_108;
                    let _e5994 = select(_e5976, true, _e5986);
                    let _e6001 = select(select(select(_e5961, false, _e5976), false, _e5986), true, _e5994);
                    let _e6005 = select(select(select(select(_e5980, false, _e5976), false, _e5986), false, _e5994), true, _e6001);
                    phi_8757_ = type_9(select(select(type_9().member, 2u, _e5916), select(select(type_9().member, 0u, _e5952), select(_e5974.member, select(select(type_9().member, 2u, _e5976), 1u, _e5986), _e5994), _e6001), _e6005), select(select(type_9().member_1, type_9().member_1, _e5921), select(select(type_9().member_1, type_9().member_1, _e5952), select(_e5974.member_1, select(select(type_9().member_1, type_9().member_1, _e5976), _e5990.member, _e5986), _e5994), _e6001), _e6005));
                }
                let _e6012 = phi_8757_;
                phi_8761_ = _e6012;
                phi_8762_ = type_9(_e201, _e204);
            } else {
                phi_8761_ = type_9(0u, u32());
                phi_8762_ = type_9(0u, 0u);
            }
            let _e6014 = phi_8761_;
            let _e6016 = phi_8762_;
            let _e6021 = params.member.member_2.member_1;
            switch bitcast<i32>(_e6014.member) {
                case 0: {
                    phi_8803_ = type_26();
                    phi_8804_ = true;
                    break;
                }
                case 1: {
                    if (_e6014.member_1 == 0u) {
                        phi_8797_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e6030 = select((bitcast<u32>(31i) - firstLeadingBit(_e6014.member_1)), 32u, (_e6014.member_1 == 0u));
                        let _e6035 = ((_e6014.member_1 << bitcast<u32>((_e6030 & 31u))) << bitcast<u32>(1i));
                        phi_8797_ = array<u32, 2>((_e6035 << bitcast<u32>(20i)), (((1023u - _e6030) << bitcast<u32>(20i)) | (_e6035 >> bitcast<u32>(12i))));
                    }
                    let _e6046 = phi_8797_;
                    phi_8803_ = type_26(0u, select(0u, 1u, (_e6014.member_1 > _e6021)), _e6046, true);
                    phi_8804_ = false;
                    break;
                }
                case 2: {
                    phi_8803_ = type_26();
                    phi_8804_ = true;
                    break;
                }
                case 3: {
                    phi_8803_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
                    phi_8804_ = false;
                    break;
                }
                default: {
                    phi_8803_ = type_26();
                    phi_8804_ = bool();
                    break;
                }
            }
            let _e6049 = phi_8803_;
            let _e6051 = phi_8804_;
            if _e6051 {
                phi_8808_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                phi_8808_ = _e6049;
            }
            let _e6053 = phi_8808_;
            let _e6058 = (_e6053.member != 0u);
            let _e6061 = select(false, !(_e6058), _e6053.member_3);
            if _e6061 {
                let _e6065 = (_e6053.member_2[1] >> bitcast<u32>(20i));
                if (_e6065 <= 896u) {
                    phi_8839_ = 0u;
                } else {
                    phi_8839_ = ((((_e6065 - 896u) << bitcast<u32>(23i)) | ((_e6053.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e6053.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e6080 = phi_8839_;
                let _e6082 = atomicMin((&earliest.member[0u]), _e6080);
            }
            let _e6085 = params.member.member.member_1;
            if ((_e6085 & 16u) != 0u) {
                if (_e115 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e6061 {
                    let _e6091 = atomicAdd((&counters[0u]), 1u);
                    phi_8861_ = _e6091;
                } else {
                    phi_8861_ = 0u;
                }
                let _e6093 = phi_8861_;
                workgroupBarrier();
                if (_e115 == 0u) {
                    let _e6096 = atomicLoad((&counters[0u]));
                    if (_e6096 > 0u) {
                        let _e6099 = atomicAdd((&contacts.member[0u]), _e6096);
                        atomicStore((&counters[1u]), _e6099);
                    }
                }
                workgroupBarrier();
                let _e6102 = atomicLoad((&counters[1u]));
                let _e6103 = (_e6102 + _e6093);
                if _e6061 {
                    let _e6106 = params.member.member_1.member_3;
                    let _e6108 = params.member.member_2.member.member;
                    if (_e6103 < _e6106) {
                        let _e6110 = (7u * _e6103);
                        atomicStore((&contacts.member[(4u + _e6110)]), _e6108);
                        atomicStore((&contacts.member[(_e6110 + 5u)]), _e6053.member);
                        atomicStore((&contacts.member[(_e6110 + 6u)]), _e6016.member);
                        atomicStore((&contacts.member[(_e6110 + 7u)]), _e6016.member_1);
                        atomicStore((&contacts.member[(_e6110 + 8u)]), _e6053.member_2[0]);
                        atomicStore((&contacts.member[(_e6110 + 9u)]), _e6053.member_2[1]);
                        atomicStore((&contacts.member[(_e6110 + 10u)]), _e6053.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e115 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6058 {
                let _e6134 = atomicAdd((&counters[0u]), 1u);
                phi_8927_ = _e6134;
            } else {
                phi_8927_ = 0u;
            }
            let _e6136 = phi_8927_;
            workgroupBarrier();
            if (_e115 == 0u) {
                let _e6139 = atomicLoad((&counters[0u]));
                if (_e6139 > 0u) {
                    let _e6142 = atomicAdd((&undecided.member[0u]), _e6139);
                    atomicStore((&counters[1u]), _e6142);
                }
            }
            workgroupBarrier();
            let _e6145 = atomicLoad((&counters[1u]));
            let _e6146 = (_e6145 + _e6136);
            if _e6058 {
                let _e6148 = params.member.member_2.member.member_1;
                if (_e6146 < _e6148) {
                    let _e6150 = (2u * _e6146);
                    atomicStore((&undecided.member[(4u + _e6150)]), _e6016.member);
                    atomicStore((&undecided.member[(_e6150 + 5u)]), _e6016.member_1);
                }
            }
            workgroupBarrier();
            let _e6158 = global.member;
            if (bitcast<i32>(_e6014.member) == bitcast<i32>(_e6158)) {
                if (bitcast<i32>(_e6014.member) == 1i) {
                    let _e6165 = global.member;
                    if (bitcast<i32>(_e6165) == 1i) {
                        let _e6170 = global.member_1;
                        phi_8991_ = (_e6014.member_1 == _e6170);
                        phi_8992_ = false;
                    } else {
                        phi_8991_ = bool();
                        phi_8992_ = true;
                    }
                    let _e6173 = phi_8991_;
                    let _e6175 = phi_8992_;
                    phi_8993_ = _e6173;
                    phi_8994_ = _e6175;
                } else {
                    phi_8993_ = bool();
                    phi_8994_ = true;
                }
                let _e6177 = phi_8993_;
                let _e6179 = phi_8994_;
                phi_8999_ = select(_e6177, true, _e6179);
            } else {
                phi_8999_ = false;
            }
            let _e6182 = phi_8999_;
            if (_e115 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6182 {
                let _e6186 = atomicAdd((&counters[0u]), 1u);
                phi_9010_ = _e6186;
            } else {
                phi_9010_ = 0u;
            }
            let _e6188 = phi_9010_;
            workgroupBarrier();
            if (_e115 == 0u) {
                let _e6191 = atomicLoad((&counters[0u]));
                if (_e6191 > 0u) {
                    let _e6194 = atomicAdd((&left.member[0u]), _e6191);
                    atomicStore((&counters[1u]), _e6194);
                }
            }
            workgroupBarrier();
            let _e6197 = atomicLoad((&counters[1u]));
            let _e6198 = (_e6197 + _e6188);
            if _e6182 {
                let _e6201 = params.member.member_2.member_4;
                if (_e6198 < _e6201) {
                    let _e6205 = (2u * _e6198);
                    atomicStore((&left.member[(4u + _e6205)]), _e6016.member);
                    atomicStore((&left.member[(_e6205 + 5u)]), _e6016.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_349_ = type_9(select(_e171.member, (_e171.member + 1u), _e174), select(_e171.member_1, _e171.member_1, _e174));
            break if !(_e187);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
