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
var<storage, read_write> left: type_39;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_39;
var<private> global: type_9 = type_9(3u, u32());

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
    var phi_9074_: type_9;
    var phi_9075_: type_9;
    var phi_9076_: type_9;
    var phi_9077_: type_9;
    var phi_9078_: type_9;
    var phi_9079_: bool;

    let _e24 = ((param_27[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_27[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_28);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_9078_ = type_9();
        phi_9079_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_9077_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_9076_ = type_9((param_27[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_9075_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_27[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_27[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_9074_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_27[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_9074_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_9074_;
                    phi_9075_ = _e67;
                }
                let _e83 = phi_9075_;
                phi_9076_ = _e83;
            }
            let _e89 = phi_9076_;
            phi_9077_ = _e89;
        }
        let _e91 = phi_9077_;
        phi_9078_ = _e91;
        phi_9079_ = _e37;
    }
    let _e93 = phi_9078_;
    let _e95 = phi_9079_;
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
    var phi_299_: u32;
    var phi_345_: u32;
    var phi_348_: type_9;
    var phi_505_: type_19;
    var phi_919_: type_25;
    var phi_2622_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3169_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_4473_: array<type_9, 4>;
    var phi_4476_: bool;
    var phi_4478_: bool;
    var phi_4480_: bool;
    var phi_4482_: bool;
    var phi_4484_: type_18;
    var phi_4488_: u32;
    var phi_4490_: u32;
    var phi_4492_: u32;
    var phi_4494_: u32;
    var phi_4496_: u32;
    var phi_4505_: array<type_9, 4>;
    var phi_4508_: bool;
    var phi_4510_: bool;
    var phi_4514_: bool;
    var phi_4516_: bool;
    var phi_4518_: bool;
    var phi_4520_: bool;
    var phi_4522_: u32;
    var phi_4524_: u32;
    var phi_4526_: u32;
    var phi_4528_: u32;
    var phi_4530_: u32;
    var phi_4735_: bool;
    var phi_4736_: bool;
    var phi_4737_: bool;
    var phi_5379_: array<type_9, 4>;
    var phi_5380_: bool;
    var phi_5381_: u32;
    var phi_5382_: array<type_9, 4>;
    var phi_5383_: bool;
    var phi_5384_: bool;
    var phi_5386_: u32;
    var phi_5387_: u32;
    var phi_5388_: array<type_9, 4>;
    var phi_5389_: bool;
    var phi_5390_: bool;
    var phi_5392_: u32;
    var phi_5393_: u32;
    var phi_5394_: array<type_9, 4>;
    var phi_5395_: bool;
    var phi_5396_: bool;
    var phi_5398_: bool;
    var phi_5399_: bool;
    var phi_5400_: bool;
    var phi_5401_: bool;
    var phi_5402_: u32;
    var phi_5403_: u32;
    var phi_5404_: u32;
    var phi_5405_: u32;
    var phi_5406_: u32;
    var phi_5407_: bool;
    var phi_5408_: array<type_9, 4>;
    var phi_5409_: bool;
    var phi_5410_: bool;
    var phi_5412_: bool;
    var phi_5413_: bool;
    var phi_5414_: bool;
    var phi_5415_: bool;
    var phi_5416_: u32;
    var phi_5417_: u32;
    var phi_5418_: u32;
    var phi_5419_: u32;
    var phi_5420_: u32;
    var phi_5421_: bool;
    var phi_4506_: array<type_9, 4>;
    var phi_4509_: bool;
    var phi_4511_: bool;
    var phi_4515_: bool;
    var phi_4517_: bool;
    var phi_4519_: bool;
    var phi_4521_: bool;
    var phi_4523_: u32;
    var phi_4525_: u32;
    var phi_4527_: u32;
    var phi_4529_: u32;
    var phi_4531_: u32;
    var phi_5422_: bool;
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
    var phi_6006_: bool;
    var phi_6007_: bool;
    var phi_6008_: type_18;
    var phi_6009_: bool;
    var phi_6010_: type_18;
    var phi_6011_: bool;
    var phi_6012_: type_18;
    var phi_6013_: bool;
    var phi_6014_: type_18;
    var phi_6015_: bool;
    var phi_6016_: bool;
    var phi_6017_: type_18;
    var phi_6018_: bool;
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
    var phi_6059_: type_14;
    var phi_6062_: f32;
    var phi_6064_: f32;
    var phi_6066_: f32;
    var phi_6060_: type_14;
    var phi_6107_: type_15;
    var phi_6063_: f32;
    var phi_6065_: f32;
    var phi_6067_: f32;
    var local_81: f32;
    var local_82: u32;
    var local_83: u32;
    var local_84: u32;
    var phi_6525_: bool;
    var phi_6526_: bool;
    var phi_6527_: bool;
    var phi_6528_: type_18;
    var phi_6529_: type_18;
    var local_85: u32;
    var local_86: u32;
    var phi_6530_: bool;
    var phi_6531_: bool;
    var phi_6532_: bool;
    var phi_6533_: type_18;
    var phi_6534_: type_18;
    var phi_7681_: array<type_9, 2>;
    var phi_7710_: array<type_9, 2>;
    var phi_7739_: array<type_9, 2>;
    var phi_7753_: type_9;
    var phi_8075_: type_9;
    var phi_8076_: type_9;
    var phi_8077_: type_9;
    var phi_8078_: type_9;
    var phi_8192_: bool;
    var phi_8193_: bool;
    var phi_8194_: bool;
    var phi_8199_: u32;
    var phi_8200_: u32;
    var phi_8201_: bool;
    var phi_8202_: u32;
    var phi_8203_: bool;
    var phi_8204_: u32;
    var phi_8205_: bool;
    var phi_8210_: u32;
    var local_87: bool;
    var phi_8282_: bool;
    var phi_8283_: bool;
    var phi_8284_: bool;
    var phi_8285_: bool;
    var phi_8286_: bool;
    var phi_8293_: bool;
    var phi_8294_: bool;
    var phi_8295_: bool;
    var phi_8296_: bool;
    var phi_8297_: type_18;
    var phi_8298_: bool;
    var phi_8299_: bool;
    var phi_8300_: type_18;
    var phi_8301_: bool;
    var phi_8302_: bool;
    var phi_8303_: bool;
    var phi_8304_: bool;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8307_: bool;
    var phi_8308_: bool;
    var phi_8309_: type_18;
    var phi_8310_: bool;
    var phi_8311_: bool;
    var phi_8312_: type_18;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var local_88: u32;
    var local_89: u32;
    var local_90: u32;
    var local_91: u32;
    var local_92: u32;
    var local_93: u32;
    var phi_8367_: u32;
    var phi_8368_: u32;
    var phi_8369_: bool;
    var phi_8370_: bool;
    var phi_8371_: u32;
    var phi_8372_: u32;
    var phi_8373_: bool;
    var phi_8374_: bool;
    var phi_8375_: bool;
    var phi_8376_: bool;
    var phi_8377_: u32;
    var phi_8378_: u32;
    var phi_8379_: bool;
    var phi_8380_: bool;
    var phi_8381_: bool;
    var phi_8648_: array<type_9, 4>;
    var phi_8649_: array<type_9, 4>;
    var phi_8650_: bool;
    var phi_8651_: bool;
    var phi_8652_: array<type_9, 4>;
    var phi_8653_: bool;
    var phi_8654_: bool;
    var phi_8655_: bool;
    var phi_8656_: bool;
    var phi_8657_: u32;
    var phi_8658_: u32;
    var phi_8659_: bool;
    var phi_8660_: bool;
    var phi_8661_: bool;
    var phi_8662_: bool;
    var phi_8663_: bool;
    var phi_8664_: bool;
    var phi_4474_: array<type_9, 4>;
    var phi_4477_: bool;
    var phi_4479_: bool;
    var phi_4481_: bool;
    var phi_4483_: bool;
    var phi_4485_: type_18;
    var phi_4489_: u32;
    var phi_4491_: u32;
    var phi_4493_: u32;
    var phi_4495_: u32;
    var phi_4497_: u32;
    var phi_8665_: bool;
    var phi_8666_: type_18;
    var phi_8667_: bool;
    var phi_8668_: bool;
    var phi_8669_: bool;
    var phi_8670_: bool;
    var phi_8671_: bool;
    var phi_8672_: bool;
    var phi_8673_: bool;
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
    var phi_8715_: type_9;
    var phi_8716_: bool;
    var phi_8717_: bool;
    var phi_8718_: bool;
    var local_108: type_18;
    var phi_8754_: type_9;
    var phi_8788_: array<u32, 2>;
    var phi_8791_: type_26;
    var phi_8792_: bool;
    var phi_8796_: type_26;
    var phi_8824_: bool;
    var phi_8825_: bool;
    var phi_8826_: bool;
    var phi_8827_: bool;
    var phi_8832_: bool;
    var phi_8843_: type_26;
    var phi_8844_: type_9;
    var phi_8875_: u32;
    var phi_8897_: u32;
    var phi_8963_: u32;
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
    let _e112 = id_2;
    let _e113 = n_2;
    let _e114 = lane_2;
    let _e127 = ((_e112.y * _e113.x) + _e112.x);
    let _e130 = (_e113.x * _e113.y);
    let _e133 = params.member.member_1.member_2;
    let _e135 = input.member[0u];
    let _e137 = select(_e135, _e133, (_e133 < _e135));
    let _e139 = params.member.member_1.member_1;
    if (_e137 > _e139) {
        let _e142 = params.member.member_1.member_1;
        phi_299_ = (_e137 - _e142);
    } else {
        phi_299_ = 0u;
    }
    let _e145 = phi_299_;
    let _e147 = params.member.member_1.member;
    let _e149 = select(_e145, _e147, (_e147 < _e145));
    let _e151 = (_e149 / 64u);
    let _e155 = select(_e151, (_e151 + 1u), ((_e149 % 64u) > 0u));
    if (_e155 > _e127) {
        let _e157 = (_e155 - _e127);
        if (_e130 == 0u) {
            return;
        }
        let _e159 = (_e157 / _e130);
        if (_e130 == 0u) {
            return;
        }
        phi_345_ = select(_e159, (_e159 + 1u), ((_e157 % _e130) > 0u));
    } else {
        phi_345_ = 0u;
    }
    let _e166 = phi_345_;
    phi_348_ = type_9(0u, _e166);
    loop {
        let _e169 = phi_348_;
        let _e172 = (_e169.member < _e169.member_1);
        let _e185 = (bitcast<i32>(select(0u, 1u, _e172)) != 0i);
        if _e185 {
            let _e189 = (((_e127 + (select(type_9().member_1, _e169.member, _e172) * _e130)) * 64u) + _e114);
            if (_e189 < _e149) {
                let _e193 = params.member.member_1.member_1;
                let _e195 = (2u * (_e193 + _e189));
                let _e198 = input.member[(4u + _e195)];
                let _e201 = input.member[(_e195 + 5u)];
                let _e206 = params.member.member_2.member.member;
                if (_e206 == 0u) {
                    let _e222 = (3u * _e201);
                    let _e224 = elements.member[_e222];
                    let _e227 = elements.member[(_e222 + 1u)];
                    let _e230 = elements.member[(_e222 + 2u)];
                    phi_505_ = type_19(0u, array<u32, 4>(_e198, _e224, _e227, _e230));
                } else {
                    let _e208 = (2u * _e198);
                    let _e209 = (2u * _e201);
                    let _e211 = elements.member[_e208];
                    let _e213 = elements.member[_e209];
                    let _e216 = elements.member[(_e208 + 1u)];
                    let _e219 = elements.member[(_e209 + 1u)];
                    phi_505_ = type_19(1u, array<u32, 4>(_e211, _e216, _e213, _e219));
                }
                let _e234 = phi_505_;
                local_31 = array<u32, 4>(_e234.member_1[0], _e234.member_1[1], _e234.member_1[2], _e234.member_1[3]);
                let _e243 = paths.member[_e234.member_1[0]];
                let _e257 = paths.member[_e234.member_1[1]];
                let _e271 = paths.member[_e234.member_1[2]];
                let _e285 = paths.member[_e234.member_1[3]];
                local_32 = array<array<f32, 3>, 4>(array<f32, 3>(_e243.member.x, _e243.member.y, _e243.member.z), array<f32, 3>(_e257.member.x, _e257.member.y, _e257.member.z), array<f32, 3>(_e271.member.x, _e271.member.y, _e271.member.z), array<f32, 3>(_e285.member.x, _e285.member.y, _e285.member.z));
                local_33 = array<array<f32, 3>, 4>(array<f32, 3>(_e243.member_1.x, _e243.member_1.y, _e243.member_1.z), array<f32, 3>(_e257.member_1.x, _e257.member_1.y, _e257.member_1.z), array<f32, 3>(_e271.member_1.x, _e271.member_1.y, _e271.member_1.z), array<f32, 3>(_e285.member_1.x, _e285.member_1.y, _e285.member_1.z));
                let _e309 = params.member.member.member_4;
                if (_e234.member != 0u) {
                    let _e400 = local_32;
                    let _e405 = local_32;
                    let _e414 = local_33;
                    let _e419 = local_33;
                    let _e429 = local_32;
                    let _e434 = local_32;
                    let _e443 = local_33;
                    let _e448 = local_33;
                    let _e458 = local_32;
                    let _e463 = local_32;
                    let _e472 = local_33;
                    let _e477 = local_33;
                    phi_919_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e400[2][0] - _e405[0][0]), (_e400[2][1] - _e405[0][1]), (_e400[2][2] - _e405[0][2])), array<f32, 3>((_e414[2][0] - _e419[0][0]), (_e414[2][1] - _e419[0][1]), (_e414[2][2] - _e419[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e429[1][0] - _e434[0][0]), (_e429[1][1] - _e434[0][1]), (_e429[1][2] - _e434[0][2])), array<f32, 3>((_e443[1][0] - _e448[0][0]), (_e443[1][1] - _e448[0][1]), (_e443[1][2] - _e448[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e458[2][0] - _e463[3][0]), (_e458[2][1] - _e463[3][1]), (_e458[2][2] - _e463[3][2])), array<f32, 3>((_e472[2][0] - _e477[3][0]), (_e472[2][1] - _e477[3][1]), (_e472[2][2] - _e477[3][2]))), (_e309 + _e309));
                } else {
                    let _e311 = local_32;
                    let _e316 = local_32;
                    let _e325 = local_33;
                    let _e330 = local_33;
                    let _e340 = local_32;
                    let _e345 = local_32;
                    let _e354 = local_33;
                    let _e359 = local_33;
                    let _e369 = local_32;
                    let _e374 = local_32;
                    let _e383 = local_33;
                    let _e388 = local_33;
                    phi_919_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e311[0][0] - _e316[1][0]), (_e311[0][1] - _e316[1][1]), (_e311[0][2] - _e316[1][2])), array<f32, 3>((_e325[0][0] - _e330[1][0]), (_e325[0][1] - _e330[1][1]), (_e325[0][2] - _e330[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e340[2][0] - _e345[1][0]), (_e340[2][1] - _e345[1][1]), (_e340[2][2] - _e345[1][2])), array<f32, 3>((_e354[2][0] - _e359[1][0]), (_e354[2][1] - _e359[1][1]), (_e354[2][2] - _e359[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e369[3][0] - _e374[1][0]), (_e369[3][1] - _e374[1][1]), (_e369[3][2] - _e374[1][2])), array<f32, 3>((_e383[3][0] - _e388[1][0]), (_e383[3][1] - _e388[1][1]), (_e383[3][2] - _e388[1][2]))), (_e309 + _e309));
                }
                let _e490 = phi_919_;
                let _e496 = select(_e490.member[0][0], -(_e490.member[0][0]), (_e490.member[0][0] < 0f));
                let _e500 = select(_e490.member[0][1], -(_e490.member[0][1]), (_e490.member[0][1] < 0f));
                let _e502 = select(_e500, _e496, (_e496 > _e500));
                let _e506 = select(_e490.member[0][2], -(_e490.member[0][2]), (_e490.member[0][2] < 0f));
                let _e508 = select(_e506, _e502, (_e502 > _e506));
                let _e514 = select(_e490.member[1][0], -(_e490.member[1][0]), (_e490.member[1][0] < 0f));
                let _e518 = select(_e490.member[1][1], -(_e490.member[1][1]), (_e490.member[1][1] < 0f));
                let _e520 = select(_e518, _e514, (_e514 > _e518));
                let _e524 = select(_e490.member[1][2], -(_e490.member[1][2]), (_e490.member[1][2] < 0f));
                let _e526 = select(_e524, _e520, (_e520 > _e524));
                let _e536 = select(_e490.member_1[0][0], -(_e490.member_1[0][0]), (_e490.member_1[0][0] < 0f));
                let _e540 = select(_e490.member_1[0][1], -(_e490.member_1[0][1]), (_e490.member_1[0][1] < 0f));
                let _e542 = select(_e540, _e536, (_e536 > _e540));
                let _e546 = select(_e490.member_1[0][2], -(_e490.member_1[0][2]), (_e490.member_1[0][2] < 0f));
                let _e548 = select(_e546, _e542, (_e542 > _e546));
                let _e554 = select(_e490.member_1[1][0], -(_e490.member_1[1][0]), (_e490.member_1[1][0] < 0f));
                let _e558 = select(_e490.member_1[1][1], -(_e490.member_1[1][1]), (_e490.member_1[1][1] < 0f));
                let _e560 = select(_e558, _e554, (_e554 > _e558));
                let _e564 = select(_e490.member_1[1][2], -(_e490.member_1[1][2]), (_e490.member_1[1][2] < 0f));
                let _e566 = select(_e564, _e560, (_e560 > _e564));
                let _e576 = select(_e490.member_2[0][0], -(_e490.member_2[0][0]), (_e490.member_2[0][0] < 0f));
                let _e580 = select(_e490.member_2[0][1], -(_e490.member_2[0][1]), (_e490.member_2[0][1] < 0f));
                let _e582 = select(_e580, _e576, (_e576 > _e580));
                let _e586 = select(_e490.member_2[0][2], -(_e490.member_2[0][2]), (_e490.member_2[0][2] < 0f));
                let _e588 = select(_e586, _e582, (_e582 > _e586));
                let _e594 = select(_e490.member_2[1][0], -(_e490.member_2[1][0]), (_e490.member_2[1][0] < 0f));
                let _e598 = select(_e490.member_2[1][1], -(_e490.member_2[1][1]), (_e490.member_2[1][1] < 0f));
                let _e600 = select(_e598, _e594, (_e594 > _e598));
                let _e604 = select(_e490.member_2[1][2], -(_e490.member_2[1][2]), (_e490.member_2[1][2] < 0f));
                let _e606 = select(_e604, _e600, (_e600 > _e604));
                let _e611 = function_((select(_e526, _e508, (_e508 > _e526)) + _e490.member_3), (select(_e566, _e548, (_e548 > _e566)) + _e490.member_3));
                let _e612 = function_(_e611, (select(_e606, _e588, (_e588 > _e606)) + _e490.member_3));
                let _e617 = bitcast<i32>(((bitcast<u32>(_e612) + 4u) >> bitcast<u32>(23i)));
                let _e618 = (_e617 >= 64i);
                let _e619 = (_e617 <= 190i);
                let _e625 = select(select(i32(), select(i32(), (_e617 - 126i), _e619), _e618), 2147483647i, select(true, select(true, false, _e619), _e618));
                if (_e625 == 2147483647i) {
                    phi_8754_ = type_9(2u, type_9().member_1);
                } else {
                    let _e628 = params.member.member.member_1;
                    if ((_e628 & 8u) != 0u) {
                        let _e868 = local_32;
                        let _e873 = bitcast<u32>(_e868[0][0]);
                        let _e874 = (_e873 & 2147483647u);
                        let _e875 = (_e874 < 8388608u);
                        let _e886 = function_10(array<u32, 2>(select((_e873 << bitcast<u32>(29i)), 0u, _e875), select(((_e873 ^ _e874) | ((_e874 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e875)), _e625);
                        let _e887 = bitcast<u32>(_e868[0][1]);
                        let _e888 = (_e887 & 2147483647u);
                        let _e889 = (_e888 < 8388608u);
                        let _e900 = function_10(array<u32, 2>(select((_e887 << bitcast<u32>(29i)), 0u, _e889), select(((_e887 ^ _e888) | ((_e888 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e889)), _e625);
                        let _e901 = bitcast<u32>(_e868[0][2]);
                        let _e902 = (_e901 & 2147483647u);
                        let _e903 = (_e902 < 8388608u);
                        let _e914 = function_10(array<u32, 2>(select((_e901 << bitcast<u32>(29i)), 0u, _e903), select(((_e901 ^ _e902) | ((_e902 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e903)), _e625);
                        let _e916 = local_33;
                        let _e921 = bitcast<u32>(_e916[0][0]);
                        let _e922 = (_e921 & 2147483647u);
                        let _e923 = (_e922 < 8388608u);
                        let _e934 = function_10(array<u32, 2>(select((_e921 << bitcast<u32>(29i)), 0u, _e923), select(((_e921 ^ _e922) | ((_e922 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e923)), _e625);
                        let _e935 = bitcast<u32>(_e916[0][1]);
                        let _e936 = (_e935 & 2147483647u);
                        let _e937 = (_e936 < 8388608u);
                        let _e948 = function_10(array<u32, 2>(select((_e935 << bitcast<u32>(29i)), 0u, _e937), select(((_e935 ^ _e936) | ((_e936 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e937)), _e625);
                        let _e949 = bitcast<u32>(_e916[0][2]);
                        let _e950 = (_e949 & 2147483647u);
                        let _e951 = (_e950 < 8388608u);
                        let _e962 = function_10(array<u32, 2>(select((_e949 << bitcast<u32>(29i)), 0u, _e951), select(((_e949 ^ _e950) | ((_e950 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e951)), _e625);
                        let _e965 = local_32;
                        let _e970 = bitcast<u32>(_e965[1][0]);
                        let _e971 = (_e970 & 2147483647u);
                        let _e972 = (_e971 < 8388608u);
                        let _e983 = function_10(array<u32, 2>(select((_e970 << bitcast<u32>(29i)), 0u, _e972), select(((_e970 ^ _e971) | ((_e971 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e972)), _e625);
                        let _e984 = bitcast<u32>(_e965[1][1]);
                        let _e985 = (_e984 & 2147483647u);
                        let _e986 = (_e985 < 8388608u);
                        let _e997 = function_10(array<u32, 2>(select((_e984 << bitcast<u32>(29i)), 0u, _e986), select(((_e984 ^ _e985) | ((_e985 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e986)), _e625);
                        let _e998 = bitcast<u32>(_e965[1][2]);
                        let _e999 = (_e998 & 2147483647u);
                        let _e1000 = (_e999 < 8388608u);
                        let _e1011 = function_10(array<u32, 2>(select((_e998 << bitcast<u32>(29i)), 0u, _e1000), select(((_e998 ^ _e999) | ((_e999 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1000)), _e625);
                        let _e1013 = local_33;
                        let _e1018 = bitcast<u32>(_e1013[1][0]);
                        let _e1019 = (_e1018 & 2147483647u);
                        let _e1020 = (_e1019 < 8388608u);
                        let _e1031 = function_10(array<u32, 2>(select((_e1018 << bitcast<u32>(29i)), 0u, _e1020), select(((_e1018 ^ _e1019) | ((_e1019 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1020)), _e625);
                        let _e1032 = bitcast<u32>(_e1013[1][1]);
                        let _e1033 = (_e1032 & 2147483647u);
                        let _e1034 = (_e1033 < 8388608u);
                        let _e1045 = function_10(array<u32, 2>(select((_e1032 << bitcast<u32>(29i)), 0u, _e1034), select(((_e1032 ^ _e1033) | ((_e1033 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1034)), _e625);
                        let _e1046 = bitcast<u32>(_e1013[1][2]);
                        let _e1047 = (_e1046 & 2147483647u);
                        let _e1048 = (_e1047 < 8388608u);
                        let _e1059 = function_10(array<u32, 2>(select((_e1046 << bitcast<u32>(29i)), 0u, _e1048), select(((_e1046 ^ _e1047) | ((_e1047 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1048)), _e625);
                        let _e1062 = local_32;
                        let _e1067 = bitcast<u32>(_e1062[2][0]);
                        let _e1068 = (_e1067 & 2147483647u);
                        let _e1069 = (_e1068 < 8388608u);
                        let _e1080 = function_10(array<u32, 2>(select((_e1067 << bitcast<u32>(29i)), 0u, _e1069), select(((_e1067 ^ _e1068) | ((_e1068 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1069)), _e625);
                        let _e1081 = bitcast<u32>(_e1062[2][1]);
                        let _e1082 = (_e1081 & 2147483647u);
                        let _e1083 = (_e1082 < 8388608u);
                        let _e1094 = function_10(array<u32, 2>(select((_e1081 << bitcast<u32>(29i)), 0u, _e1083), select(((_e1081 ^ _e1082) | ((_e1082 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1083)), _e625);
                        let _e1095 = bitcast<u32>(_e1062[2][2]);
                        let _e1096 = (_e1095 & 2147483647u);
                        let _e1097 = (_e1096 < 8388608u);
                        let _e1108 = function_10(array<u32, 2>(select((_e1095 << bitcast<u32>(29i)), 0u, _e1097), select(((_e1095 ^ _e1096) | ((_e1096 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1097)), _e625);
                        let _e1110 = local_33;
                        let _e1115 = bitcast<u32>(_e1110[2][0]);
                        let _e1116 = (_e1115 & 2147483647u);
                        let _e1117 = (_e1116 < 8388608u);
                        let _e1128 = function_10(array<u32, 2>(select((_e1115 << bitcast<u32>(29i)), 0u, _e1117), select(((_e1115 ^ _e1116) | ((_e1116 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1117)), _e625);
                        let _e1129 = bitcast<u32>(_e1110[2][1]);
                        let _e1130 = (_e1129 & 2147483647u);
                        let _e1131 = (_e1130 < 8388608u);
                        let _e1142 = function_10(array<u32, 2>(select((_e1129 << bitcast<u32>(29i)), 0u, _e1131), select(((_e1129 ^ _e1130) | ((_e1130 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1131)), _e625);
                        let _e1143 = bitcast<u32>(_e1110[2][2]);
                        let _e1144 = (_e1143 & 2147483647u);
                        let _e1145 = (_e1144 < 8388608u);
                        let _e1156 = function_10(array<u32, 2>(select((_e1143 << bitcast<u32>(29i)), 0u, _e1145), select(((_e1143 ^ _e1144) | ((_e1144 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1145)), _e625);
                        let _e1159 = local_32;
                        let _e1164 = bitcast<u32>(_e1159[3][0]);
                        let _e1165 = (_e1164 & 2147483647u);
                        let _e1166 = (_e1165 < 8388608u);
                        let _e1177 = function_10(array<u32, 2>(select((_e1164 << bitcast<u32>(29i)), 0u, _e1166), select(((_e1164 ^ _e1165) | ((_e1165 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1166)), _e625);
                        let _e1178 = bitcast<u32>(_e1159[3][1]);
                        let _e1179 = (_e1178 & 2147483647u);
                        let _e1180 = (_e1179 < 8388608u);
                        let _e1191 = function_10(array<u32, 2>(select((_e1178 << bitcast<u32>(29i)), 0u, _e1180), select(((_e1178 ^ _e1179) | ((_e1179 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1180)), _e625);
                        let _e1192 = bitcast<u32>(_e1159[3][2]);
                        let _e1193 = (_e1192 & 2147483647u);
                        let _e1194 = (_e1193 < 8388608u);
                        let _e1205 = function_10(array<u32, 2>(select((_e1192 << bitcast<u32>(29i)), 0u, _e1194), select(((_e1192 ^ _e1193) | ((_e1193 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1194)), _e625);
                        let _e1207 = local_33;
                        let _e1212 = bitcast<u32>(_e1207[3][0]);
                        let _e1213 = (_e1212 & 2147483647u);
                        let _e1214 = (_e1213 < 8388608u);
                        let _e1225 = function_10(array<u32, 2>(select((_e1212 << bitcast<u32>(29i)), 0u, _e1214), select(((_e1212 ^ _e1213) | ((_e1213 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1214)), _e625);
                        let _e1226 = bitcast<u32>(_e1207[3][1]);
                        let _e1227 = (_e1226 & 2147483647u);
                        let _e1228 = (_e1227 < 8388608u);
                        let _e1239 = function_10(array<u32, 2>(select((_e1226 << bitcast<u32>(29i)), 0u, _e1228), select(((_e1226 ^ _e1227) | ((_e1227 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1228)), _e625);
                        let _e1240 = bitcast<u32>(_e1207[3][2]);
                        let _e1241 = (_e1240 & 2147483647u);
                        let _e1242 = (_e1241 < 8388608u);
                        let _e1253 = function_10(array<u32, 2>(select((_e1240 << bitcast<u32>(29i)), 0u, _e1242), select(((_e1240 ^ _e1241) | ((_e1241 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1242)), _e625);
                        phi_2622_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e886, _e900, _e914), array<type_9, 3>(_e934, _e948, _e962)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e983, _e997, _e1011), array<type_9, 3>(_e1031, _e1045, _e1059)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1080, _e1094, _e1108), array<type_9, 3>(_e1128, _e1142, _e1156)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1177, _e1191, _e1205), array<type_9, 3>(_e1225, _e1239, _e1253)));
                    } else {
                        let _e633 = params.member.member.member_10[1u];
                        let _e638 = (_e625 - (bitcast<i32>((_e633 >> bitcast<u32>(20i))) - 1023i));
                        let _e639 = local_31;
                        let _e643 = params.member.member.member[0u];
                        let _e645 = (6u * (_e643 + _e639[0]));
                        let _e646 = (6u * _e639[0]);
                        let _e648 = positions.member[_e646];
                        let _e651 = positions.member[(_e646 + 1u)];
                        let _e653 = function_10(array<u32, 2>(_e648, _e651), _e638);
                        let _e656 = positions.member[(_e646 + 2u)];
                        let _e659 = positions.member[(_e646 + 3u)];
                        let _e661 = function_10(array<u32, 2>(_e656, _e659), _e638);
                        let _e664 = positions.member[(_e646 + 4u)];
                        let _e667 = positions.member[(_e646 + 5u)];
                        let _e669 = function_10(array<u32, 2>(_e664, _e667), _e638);
                        let _e672 = positions.member[_e645];
                        let _e675 = positions.member[(_e645 + 1u)];
                        let _e677 = function_10(array<u32, 2>(_e672, _e675), _e638);
                        let _e680 = positions.member[(_e645 + 2u)];
                        let _e683 = positions.member[(_e645 + 3u)];
                        let _e685 = function_10(array<u32, 2>(_e680, _e683), _e638);
                        let _e688 = positions.member[(_e645 + 4u)];
                        let _e691 = positions.member[(_e645 + 5u)];
                        let _e693 = function_10(array<u32, 2>(_e688, _e691), _e638);
                        let _e696 = local_31;
                        let _e700 = params.member.member.member[0u];
                        let _e702 = (6u * (_e700 + _e696[1]));
                        let _e703 = (6u * _e696[1]);
                        let _e705 = positions.member[_e703];
                        let _e708 = positions.member[(_e703 + 1u)];
                        let _e710 = function_10(array<u32, 2>(_e705, _e708), _e638);
                        let _e713 = positions.member[(_e703 + 2u)];
                        let _e716 = positions.member[(_e703 + 3u)];
                        let _e718 = function_10(array<u32, 2>(_e713, _e716), _e638);
                        let _e721 = positions.member[(_e703 + 4u)];
                        let _e724 = positions.member[(_e703 + 5u)];
                        let _e726 = function_10(array<u32, 2>(_e721, _e724), _e638);
                        let _e729 = positions.member[_e702];
                        let _e732 = positions.member[(_e702 + 1u)];
                        let _e734 = function_10(array<u32, 2>(_e729, _e732), _e638);
                        let _e737 = positions.member[(_e702 + 2u)];
                        let _e740 = positions.member[(_e702 + 3u)];
                        let _e742 = function_10(array<u32, 2>(_e737, _e740), _e638);
                        let _e745 = positions.member[(_e702 + 4u)];
                        let _e748 = positions.member[(_e702 + 5u)];
                        let _e750 = function_10(array<u32, 2>(_e745, _e748), _e638);
                        let _e753 = local_31;
                        let _e757 = params.member.member.member[0u];
                        let _e759 = (6u * (_e757 + _e753[2]));
                        let _e760 = (6u * _e753[2]);
                        let _e762 = positions.member[_e760];
                        let _e765 = positions.member[(_e760 + 1u)];
                        let _e767 = function_10(array<u32, 2>(_e762, _e765), _e638);
                        let _e770 = positions.member[(_e760 + 2u)];
                        let _e773 = positions.member[(_e760 + 3u)];
                        let _e775 = function_10(array<u32, 2>(_e770, _e773), _e638);
                        let _e778 = positions.member[(_e760 + 4u)];
                        let _e781 = positions.member[(_e760 + 5u)];
                        let _e783 = function_10(array<u32, 2>(_e778, _e781), _e638);
                        let _e786 = positions.member[_e759];
                        let _e789 = positions.member[(_e759 + 1u)];
                        let _e791 = function_10(array<u32, 2>(_e786, _e789), _e638);
                        let _e794 = positions.member[(_e759 + 2u)];
                        let _e797 = positions.member[(_e759 + 3u)];
                        let _e799 = function_10(array<u32, 2>(_e794, _e797), _e638);
                        let _e802 = positions.member[(_e759 + 4u)];
                        let _e805 = positions.member[(_e759 + 5u)];
                        let _e807 = function_10(array<u32, 2>(_e802, _e805), _e638);
                        let _e810 = local_31;
                        let _e814 = params.member.member.member[0u];
                        let _e816 = (6u * (_e814 + _e810[3]));
                        let _e817 = (6u * _e810[3]);
                        let _e819 = positions.member[_e817];
                        let _e822 = positions.member[(_e817 + 1u)];
                        let _e824 = function_10(array<u32, 2>(_e819, _e822), _e638);
                        let _e827 = positions.member[(_e817 + 2u)];
                        let _e830 = positions.member[(_e817 + 3u)];
                        let _e832 = function_10(array<u32, 2>(_e827, _e830), _e638);
                        let _e835 = positions.member[(_e817 + 4u)];
                        let _e838 = positions.member[(_e817 + 5u)];
                        let _e840 = function_10(array<u32, 2>(_e835, _e838), _e638);
                        let _e843 = positions.member[_e816];
                        let _e846 = positions.member[(_e816 + 1u)];
                        let _e848 = function_10(array<u32, 2>(_e843, _e846), _e638);
                        let _e851 = positions.member[(_e816 + 2u)];
                        let _e854 = positions.member[(_e816 + 3u)];
                        let _e856 = function_10(array<u32, 2>(_e851, _e854), _e638);
                        let _e859 = positions.member[(_e816 + 4u)];
                        let _e862 = positions.member[(_e816 + 5u)];
                        let _e864 = function_10(array<u32, 2>(_e859, _e862), _e638);
                        phi_2622_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e653, _e661, _e669), array<type_9, 3>(_e677, _e685, _e693)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e710, _e718, _e726), array<type_9, 3>(_e734, _e742, _e750)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e767, _e775, _e783), array<type_9, 3>(_e791, _e799, _e807)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e824, _e832, _e840), array<type_9, 3>(_e848, _e856, _e864)));
                    }
                    let _e1258 = phi_2622_;
                    let _e1260 = params.member.member_2.member_1;
                    let _e1262 = params.member.member_2.member_2;
                    let _e1264 = params.member.member_2.member_3;
                    if (_e234.member != 0u) {
                        phi_3169_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[2][0][0].member - _e1258[0][0][0].member) - select(0u, 1u, (_e1258[2][0][0].member_1 < _e1258[0][0][0].member_1))), (_e1258[2][0][0].member_1 - _e1258[0][0][0].member_1)), type_9(((_e1258[2][0][1].member - _e1258[0][0][1].member) - select(0u, 1u, (_e1258[2][0][1].member_1 < _e1258[0][0][1].member_1))), (_e1258[2][0][1].member_1 - _e1258[0][0][1].member_1)), type_9(((_e1258[2][0][2].member - _e1258[0][0][2].member) - select(0u, 1u, (_e1258[2][0][2].member_1 < _e1258[0][0][2].member_1))), (_e1258[2][0][2].member_1 - _e1258[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[2][1][0].member - _e1258[0][1][0].member) - select(0u, 1u, (_e1258[2][1][0].member_1 < _e1258[0][1][0].member_1))), (_e1258[2][1][0].member_1 - _e1258[0][1][0].member_1)), type_9(((_e1258[2][1][1].member - _e1258[0][1][1].member) - select(0u, 1u, (_e1258[2][1][1].member_1 < _e1258[0][1][1].member_1))), (_e1258[2][1][1].member_1 - _e1258[0][1][1].member_1)), type_9(((_e1258[2][1][2].member - _e1258[0][1][2].member) - select(0u, 1u, (_e1258[2][1][2].member_1 < _e1258[0][1][2].member_1))), (_e1258[2][1][2].member_1 - _e1258[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[1][0][0].member - _e1258[0][0][0].member) - select(0u, 1u, (_e1258[1][0][0].member_1 < _e1258[0][0][0].member_1))), (_e1258[1][0][0].member_1 - _e1258[0][0][0].member_1)), type_9(((_e1258[1][0][1].member - _e1258[0][0][1].member) - select(0u, 1u, (_e1258[1][0][1].member_1 < _e1258[0][0][1].member_1))), (_e1258[1][0][1].member_1 - _e1258[0][0][1].member_1)), type_9(((_e1258[1][0][2].member - _e1258[0][0][2].member) - select(0u, 1u, (_e1258[1][0][2].member_1 < _e1258[0][0][2].member_1))), (_e1258[1][0][2].member_1 - _e1258[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[1][1][0].member - _e1258[0][1][0].member) - select(0u, 1u, (_e1258[1][1][0].member_1 < _e1258[0][1][0].member_1))), (_e1258[1][1][0].member_1 - _e1258[0][1][0].member_1)), type_9(((_e1258[1][1][1].member - _e1258[0][1][1].member) - select(0u, 1u, (_e1258[1][1][1].member_1 < _e1258[0][1][1].member_1))), (_e1258[1][1][1].member_1 - _e1258[0][1][1].member_1)), type_9(((_e1258[1][1][2].member - _e1258[0][1][2].member) - select(0u, 1u, (_e1258[1][1][2].member_1 < _e1258[0][1][2].member_1))), (_e1258[1][1][2].member_1 - _e1258[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[2][0][0].member - _e1258[3][0][0].member) - select(0u, 1u, (_e1258[2][0][0].member_1 < _e1258[3][0][0].member_1))), (_e1258[2][0][0].member_1 - _e1258[3][0][0].member_1)), type_9(((_e1258[2][0][1].member - _e1258[3][0][1].member) - select(0u, 1u, (_e1258[2][0][1].member_1 < _e1258[3][0][1].member_1))), (_e1258[2][0][1].member_1 - _e1258[3][0][1].member_1)), type_9(((_e1258[2][0][2].member - _e1258[3][0][2].member) - select(0u, 1u, (_e1258[2][0][2].member_1 < _e1258[3][0][2].member_1))), (_e1258[2][0][2].member_1 - _e1258[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[2][1][0].member - _e1258[3][1][0].member) - select(0u, 1u, (_e1258[2][1][0].member_1 < _e1258[3][1][0].member_1))), (_e1258[2][1][0].member_1 - _e1258[3][1][0].member_1)), type_9(((_e1258[2][1][1].member - _e1258[3][1][1].member) - select(0u, 1u, (_e1258[2][1][1].member_1 < _e1258[3][1][1].member_1))), (_e1258[2][1][1].member_1 - _e1258[3][1][1].member_1)), type_9(((_e1258[2][1][2].member - _e1258[3][1][2].member) - select(0u, 1u, (_e1258[2][1][2].member_1 < _e1258[3][1][2].member_1))), (_e1258[2][1][2].member_1 - _e1258[3][1][2].member_1)))));
                    } else {
                        phi_3169_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[0][0][0].member - _e1258[1][0][0].member) - select(0u, 1u, (_e1258[0][0][0].member_1 < _e1258[1][0][0].member_1))), (_e1258[0][0][0].member_1 - _e1258[1][0][0].member_1)), type_9(((_e1258[0][0][1].member - _e1258[1][0][1].member) - select(0u, 1u, (_e1258[0][0][1].member_1 < _e1258[1][0][1].member_1))), (_e1258[0][0][1].member_1 - _e1258[1][0][1].member_1)), type_9(((_e1258[0][0][2].member - _e1258[1][0][2].member) - select(0u, 1u, (_e1258[0][0][2].member_1 < _e1258[1][0][2].member_1))), (_e1258[0][0][2].member_1 - _e1258[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[0][1][0].member - _e1258[1][1][0].member) - select(0u, 1u, (_e1258[0][1][0].member_1 < _e1258[1][1][0].member_1))), (_e1258[0][1][0].member_1 - _e1258[1][1][0].member_1)), type_9(((_e1258[0][1][1].member - _e1258[1][1][1].member) - select(0u, 1u, (_e1258[0][1][1].member_1 < _e1258[1][1][1].member_1))), (_e1258[0][1][1].member_1 - _e1258[1][1][1].member_1)), type_9(((_e1258[0][1][2].member - _e1258[1][1][2].member) - select(0u, 1u, (_e1258[0][1][2].member_1 < _e1258[1][1][2].member_1))), (_e1258[0][1][2].member_1 - _e1258[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[2][0][0].member - _e1258[1][0][0].member) - select(0u, 1u, (_e1258[2][0][0].member_1 < _e1258[1][0][0].member_1))), (_e1258[2][0][0].member_1 - _e1258[1][0][0].member_1)), type_9(((_e1258[2][0][1].member - _e1258[1][0][1].member) - select(0u, 1u, (_e1258[2][0][1].member_1 < _e1258[1][0][1].member_1))), (_e1258[2][0][1].member_1 - _e1258[1][0][1].member_1)), type_9(((_e1258[2][0][2].member - _e1258[1][0][2].member) - select(0u, 1u, (_e1258[2][0][2].member_1 < _e1258[1][0][2].member_1))), (_e1258[2][0][2].member_1 - _e1258[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[2][1][0].member - _e1258[1][1][0].member) - select(0u, 1u, (_e1258[2][1][0].member_1 < _e1258[1][1][0].member_1))), (_e1258[2][1][0].member_1 - _e1258[1][1][0].member_1)), type_9(((_e1258[2][1][1].member - _e1258[1][1][1].member) - select(0u, 1u, (_e1258[2][1][1].member_1 < _e1258[1][1][1].member_1))), (_e1258[2][1][1].member_1 - _e1258[1][1][1].member_1)), type_9(((_e1258[2][1][2].member - _e1258[1][1][2].member) - select(0u, 1u, (_e1258[2][1][2].member_1 < _e1258[1][1][2].member_1))), (_e1258[2][1][2].member_1 - _e1258[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1258[3][0][0].member - _e1258[1][0][0].member) - select(0u, 1u, (_e1258[3][0][0].member_1 < _e1258[1][0][0].member_1))), (_e1258[3][0][0].member_1 - _e1258[1][0][0].member_1)), type_9(((_e1258[3][0][1].member - _e1258[1][0][1].member) - select(0u, 1u, (_e1258[3][0][1].member_1 < _e1258[1][0][1].member_1))), (_e1258[3][0][1].member_1 - _e1258[1][0][1].member_1)), type_9(((_e1258[3][0][2].member - _e1258[1][0][2].member) - select(0u, 1u, (_e1258[3][0][2].member_1 < _e1258[1][0][2].member_1))), (_e1258[3][0][2].member_1 - _e1258[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1258[3][1][0].member - _e1258[1][1][0].member) - select(0u, 1u, (_e1258[3][1][0].member_1 < _e1258[1][1][0].member_1))), (_e1258[3][1][0].member_1 - _e1258[1][1][0].member_1)), type_9(((_e1258[3][1][1].member - _e1258[1][1][1].member) - select(0u, 1u, (_e1258[3][1][1].member_1 < _e1258[1][1][1].member_1))), (_e1258[3][1][1].member_1 - _e1258[1][1][1].member_1)), type_9(((_e1258[3][1][2].member - _e1258[1][1][2].member) - select(0u, 1u, (_e1258[3][1][2].member_1 < _e1258[1][1][2].member_1))), (_e1258[3][1][2].member_1 - _e1258[1][1][2].member_1)))));
                    }
                    let _e1839 = phi_3169_;
                    local_29 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_30 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e1872 = local_29[1u].member;
                    let _e1874 = local_29[1u].member_1;
                    let _e1877 = local_30[2u].member;
                    let _e1879 = local_30[2u].member_1;
                    let _e1880 = function_5(_e1872, _e1874, _e1877, _e1879);
                    let _e1885 = local_29[2u].member;
                    let _e1887 = local_29[2u].member_1;
                    let _e1890 = local_30[1u].member;
                    let _e1892 = local_30[1u].member_1;
                    let _e1893 = function_5(_e1885, _e1887, _e1890, _e1892);
                    let _e1899 = ((_e1880.member - _e1893.member) - select(0u, 1u, (_e1880.member_1 < _e1893.member_1)));
                    let _e1900 = (_e1880.member_1 - _e1893.member_1);
                    local_27 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_28 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e1929 = local_27[2u].member;
                    let _e1931 = local_27[2u].member_1;
                    let _e1934 = local_28[0u].member;
                    let _e1936 = local_28[0u].member_1;
                    let _e1937 = function_5(_e1929, _e1931, _e1934, _e1936);
                    let _e1942 = local_27[0u].member;
                    let _e1944 = local_27[0u].member_1;
                    let _e1947 = local_28[2u].member;
                    let _e1949 = local_28[2u].member_1;
                    let _e1950 = function_5(_e1942, _e1944, _e1947, _e1949);
                    let _e1956 = ((_e1937.member - _e1950.member) - select(0u, 1u, (_e1937.member_1 < _e1950.member_1)));
                    let _e1957 = (_e1937.member_1 - _e1950.member_1);
                    local_25 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_26 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e1986 = local_25[0u].member;
                    let _e1988 = local_25[0u].member_1;
                    let _e1991 = local_26[1u].member;
                    let _e1993 = local_26[1u].member_1;
                    let _e1994 = function_5(_e1986, _e1988, _e1991, _e1993);
                    let _e1999 = local_25[1u].member;
                    let _e2001 = local_25[1u].member_1;
                    let _e2004 = local_26[0u].member;
                    let _e2006 = local_26[0u].member_1;
                    let _e2007 = function_5(_e1999, _e2001, _e2004, _e2006);
                    let _e2013 = ((_e1994.member - _e2007.member) - select(0u, 1u, (_e1994.member_1 < _e2007.member_1)));
                    let _e2014 = (_e1994.member_1 - _e2007.member_1);
                    local_23 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_24 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2047 = local_23[1u].member;
                    let _e2049 = local_23[1u].member_1;
                    let _e2052 = local_24[2u].member;
                    let _e2054 = local_24[2u].member_1;
                    let _e2055 = function_5(_e2047, _e2049, _e2052, _e2054);
                    let _e2060 = local_23[2u].member;
                    let _e2062 = local_23[2u].member_1;
                    let _e2065 = local_24[1u].member;
                    let _e2067 = local_24[1u].member_1;
                    let _e2068 = function_5(_e2060, _e2062, _e2065, _e2067);
                    let _e2074 = ((_e2055.member - _e2068.member) - select(0u, 1u, (_e2055.member_1 < _e2068.member_1)));
                    let _e2075 = (_e2055.member_1 - _e2068.member_1);
                    local_21 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_22 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2104 = local_21[2u].member;
                    let _e2106 = local_21[2u].member_1;
                    let _e2109 = local_22[0u].member;
                    let _e2111 = local_22[0u].member_1;
                    let _e2112 = function_5(_e2104, _e2106, _e2109, _e2111);
                    let _e2117 = local_21[0u].member;
                    let _e2119 = local_21[0u].member_1;
                    let _e2122 = local_22[2u].member;
                    let _e2124 = local_22[2u].member_1;
                    let _e2125 = function_5(_e2117, _e2119, _e2122, _e2124);
                    let _e2131 = ((_e2112.member - _e2125.member) - select(0u, 1u, (_e2112.member_1 < _e2125.member_1)));
                    let _e2132 = (_e2112.member_1 - _e2125.member_1);
                    local_19 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_20 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2161 = local_19[0u].member;
                    let _e2163 = local_19[0u].member_1;
                    let _e2166 = local_20[1u].member;
                    let _e2168 = local_20[1u].member_1;
                    let _e2169 = function_5(_e2161, _e2163, _e2166, _e2168);
                    let _e2174 = local_19[1u].member;
                    let _e2176 = local_19[1u].member_1;
                    let _e2179 = local_20[0u].member;
                    let _e2181 = local_20[0u].member_1;
                    let _e2182 = function_5(_e2174, _e2176, _e2179, _e2181);
                    let _e2188 = ((_e2169.member - _e2182.member) - select(0u, 1u, (_e2169.member_1 < _e2182.member_1)));
                    let _e2189 = (_e2169.member_1 - _e2182.member_1);
                    local_17 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_18 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2222 = local_17[1u].member;
                    let _e2224 = local_17[1u].member_1;
                    let _e2227 = local_18[2u].member;
                    let _e2229 = local_18[2u].member_1;
                    let _e2230 = function_5(_e2222, _e2224, _e2227, _e2229);
                    let _e2235 = local_17[2u].member;
                    let _e2237 = local_17[2u].member_1;
                    let _e2240 = local_18[1u].member;
                    let _e2242 = local_18[1u].member_1;
                    let _e2243 = function_5(_e2235, _e2237, _e2240, _e2242);
                    let _e2250 = (_e2230.member_1 - _e2243.member_1);
                    local_15 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_16 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2279 = local_15[2u].member;
                    let _e2281 = local_15[2u].member_1;
                    let _e2284 = local_16[0u].member;
                    let _e2286 = local_16[0u].member_1;
                    let _e2287 = function_5(_e2279, _e2281, _e2284, _e2286);
                    let _e2292 = local_15[0u].member;
                    let _e2294 = local_15[0u].member_1;
                    let _e2297 = local_16[2u].member;
                    let _e2299 = local_16[2u].member_1;
                    let _e2300 = function_5(_e2292, _e2294, _e2297, _e2299);
                    let _e2307 = (_e2287.member_1 - _e2300.member_1);
                    local_13 = array<type_9, 3>(type_9(_e1839[1][0][0].member, _e1839[1][0][0].member_1), type_9(_e1839[1][0][1].member, _e1839[1][0][1].member_1), type_9(_e1839[1][0][2].member, _e1839[1][0][2].member_1));
                    local_14 = array<type_9, 3>(type_9(_e1839[2][1][0].member, _e1839[2][1][0].member_1), type_9(_e1839[2][1][1].member, _e1839[2][1][1].member_1), type_9(_e1839[2][1][2].member, _e1839[2][1][2].member_1));
                    let _e2336 = local_13[0u].member;
                    let _e2338 = local_13[0u].member_1;
                    let _e2341 = local_14[1u].member;
                    let _e2343 = local_14[1u].member_1;
                    let _e2344 = function_5(_e2336, _e2338, _e2341, _e2343);
                    let _e2349 = local_13[1u].member;
                    let _e2351 = local_13[1u].member_1;
                    let _e2354 = local_14[0u].member;
                    let _e2356 = local_14[0u].member_1;
                    let _e2357 = function_5(_e2349, _e2351, _e2354, _e2356);
                    let _e2364 = (_e2344.member_1 - _e2357.member_1);
                    local_11 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_12 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e2397 = local_11[1u].member;
                    let _e2399 = local_11[1u].member_1;
                    let _e2402 = local_12[2u].member;
                    let _e2404 = local_12[2u].member_1;
                    let _e2405 = function_5(_e2397, _e2399, _e2402, _e2404);
                    let _e2410 = local_11[2u].member;
                    let _e2412 = local_11[2u].member_1;
                    let _e2415 = local_12[1u].member;
                    let _e2417 = local_12[1u].member_1;
                    let _e2418 = function_5(_e2410, _e2412, _e2415, _e2417);
                    local_9 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_10 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e2454 = local_9[2u].member;
                    let _e2456 = local_9[2u].member_1;
                    let _e2459 = local_10[0u].member;
                    let _e2461 = local_10[0u].member_1;
                    let _e2462 = function_5(_e2454, _e2456, _e2459, _e2461);
                    let _e2467 = local_9[0u].member;
                    let _e2469 = local_9[0u].member_1;
                    let _e2472 = local_10[2u].member;
                    let _e2474 = local_10[2u].member_1;
                    let _e2475 = function_5(_e2467, _e2469, _e2472, _e2474);
                    local_7 = array<type_9, 3>(type_9(_e1839[1][1][0].member, _e1839[1][1][0].member_1), type_9(_e1839[1][1][1].member, _e1839[1][1][1].member_1), type_9(_e1839[1][1][2].member, _e1839[1][1][2].member_1));
                    local_8 = array<type_9, 3>(type_9(_e1839[2][0][0].member, _e1839[2][0][0].member_1), type_9(_e1839[2][0][1].member, _e1839[2][0][1].member_1), type_9(_e1839[2][0][2].member, _e1839[2][0][2].member_1));
                    let _e2511 = local_7[0u].member;
                    let _e2513 = local_7[0u].member_1;
                    let _e2516 = local_8[1u].member;
                    let _e2518 = local_8[1u].member_1;
                    let _e2519 = function_5(_e2511, _e2513, _e2516, _e2518);
                    let _e2524 = local_7[1u].member;
                    let _e2526 = local_7[1u].member_1;
                    let _e2529 = local_8[0u].member;
                    let _e2531 = local_8[0u].member_1;
                    let _e2532 = function_5(_e2524, _e2526, _e2529, _e2531);
                    let _e2540 = (_e2250 + (_e2405.member_1 - _e2418.member_1));
                    let _e2544 = ((((_e2230.member - _e2243.member) - select(0u, 1u, (_e2230.member_1 < _e2243.member_1))) + ((_e2405.member - _e2418.member) - select(0u, 1u, (_e2405.member_1 < _e2418.member_1)))) + select(0u, 1u, (_e2540 < _e2250)));
                    let _e2545 = (_e2307 + (_e2462.member_1 - _e2475.member_1));
                    let _e2549 = ((((_e2287.member - _e2300.member) - select(0u, 1u, (_e2287.member_1 < _e2300.member_1))) + ((_e2462.member - _e2475.member) - select(0u, 1u, (_e2462.member_1 < _e2475.member_1)))) + select(0u, 1u, (_e2545 < _e2307)));
                    let _e2550 = (_e2364 + (_e2519.member_1 - _e2532.member_1));
                    let _e2554 = ((((_e2344.member - _e2357.member) - select(0u, 1u, (_e2344.member_1 < _e2357.member_1))) + ((_e2519.member - _e2532.member) - select(0u, 1u, (_e2519.member_1 < _e2532.member_1)))) + select(0u, 1u, (_e2550 < _e2364)));
                    let _e2561 = function_5(_e1839[0][0][0].member, _e1839[0][0][0].member_1, _e1899, _e1900);
                    let _e2568 = function_5(_e1839[0][0][1].member, _e1839[0][0][1].member_1, _e1956, _e1957);
                    let _e2571 = (_e2561.member_1 + _e2568.member_1);
                    let _e2580 = function_5(_e1839[0][0][2].member, _e1839[0][0][2].member_1, _e2013, _e2014);
                    let _e2583 = (_e2571 + _e2580.member_1);
                    let _e2588 = function_9(((((_e2561.member + _e2568.member) + select(0u, 1u, (_e2571 < _e2561.member_1))) + _e2580.member) + select(0u, 1u, (_e2583 < _e2571))), _e2583);
                    let _e2597 = function_5(_e1839[0][1][0].member, _e1839[0][1][0].member_1, _e1899, _e1900);
                    let _e2604 = function_5(_e1839[0][1][1].member, _e1839[0][1][1].member_1, _e1956, _e1957);
                    let _e2607 = (_e2597.member_1 + _e2604.member_1);
                    let _e2616 = function_5(_e1839[0][1][2].member, _e1839[0][1][2].member_1, _e2013, _e2014);
                    let _e2619 = (_e2607 + _e2616.member_1);
                    let _e2630 = function_5(_e1839[0][0][0].member, _e1839[0][0][0].member_1, _e2544, _e2540);
                    let _e2637 = function_5(_e1839[0][0][1].member, _e1839[0][0][1].member_1, _e2549, _e2545);
                    let _e2640 = (_e2630.member_1 + _e2637.member_1);
                    let _e2649 = function_5(_e1839[0][0][2].member, _e1839[0][0][2].member_1, _e2554, _e2550);
                    let _e2652 = (_e2640 + _e2649.member_1);
                    let _e2657 = (_e2619 + _e2652);
                    let _e2661 = ((((((_e2597.member + _e2604.member) + select(0u, 1u, (_e2607 < _e2597.member_1))) + _e2616.member) + select(0u, 1u, (_e2619 < _e2607))) + ((((_e2630.member + _e2637.member) + select(0u, 1u, (_e2640 < _e2630.member_1))) + _e2649.member) + select(0u, 1u, (_e2652 < _e2640)))) + select(0u, 1u, (_e2657 < _e2619)));
                    let _e2668 = function_5(_e1839[0][0][0].member, _e1839[0][0][0].member_1, _e2074, _e2075);
                    let _e2675 = function_5(_e1839[0][0][1].member, _e1839[0][0][1].member_1, _e2131, _e2132);
                    let _e2678 = (_e2668.member_1 + _e2675.member_1);
                    let _e2687 = function_5(_e1839[0][0][2].member, _e1839[0][0][2].member_1, _e2188, _e2189);
                    let _e2690 = (_e2678 + _e2687.member_1);
                    let _e2701 = function_5(_e1839[0][1][0].member, _e1839[0][1][0].member_1, _e2544, _e2540);
                    let _e2708 = function_5(_e1839[0][1][1].member, _e1839[0][1][1].member_1, _e2549, _e2545);
                    let _e2711 = (_e2701.member_1 + _e2708.member_1);
                    let _e2720 = function_5(_e1839[0][1][2].member, _e1839[0][1][2].member_1, _e2554, _e2550);
                    let _e2723 = (_e2711 + _e2720.member_1);
                    let _e2728 = (_e2690 + _e2723);
                    let _e2732 = ((((((_e2668.member + _e2675.member) + select(0u, 1u, (_e2678 < _e2668.member_1))) + _e2687.member) + select(0u, 1u, (_e2690 < _e2678))) + ((((_e2701.member + _e2708.member) + select(0u, 1u, (_e2711 < _e2701.member_1))) + _e2720.member) + select(0u, 1u, (_e2723 < _e2711)))) + select(0u, 1u, (_e2728 < _e2690)));
                    let _e2739 = function_5(_e1839[0][1][0].member, _e1839[0][1][0].member_1, _e2074, _e2075);
                    let _e2746 = function_5(_e1839[0][1][1].member, _e1839[0][1][1].member_1, _e2131, _e2132);
                    let _e2749 = (_e2739.member_1 + _e2746.member_1);
                    let _e2758 = function_5(_e1839[0][1][2].member, _e1839[0][1][2].member_1, _e2188, _e2189);
                    let _e2761 = (_e2749 + _e2758.member_1);
                    let _e2766 = function_9(((((_e2739.member + _e2746.member) + select(0u, 1u, (_e2749 < _e2739.member_1))) + _e2758.member) + select(0u, 1u, (_e2761 < _e2749))), _e2761);
                    let _e2776 = select((bitcast<u32>(31i) - firstLeadingBit(_e1264)), 32u, (_e1264 == 0u));
                    let _e2778 = select(18u, _e2776, (18u < _e2776));
                    phi_4473_ = array<type_9, 4>(_e2588, type_9(_e2661, _e2657), type_9(_e2732, _e2728), _e2766);
                    phi_4476_ = false;
                    phi_4478_ = false;
                    phi_4480_ = false;
                    phi_4482_ = false;
                    phi_4484_ = type_18(0u, 0u, 0u);
                    phi_4488_ = 0u;
                    phi_4490_ = 0u;
                    phi_4492_ = 0u;
                    phi_4494_ = 0u;
                    phi_4496_ = 0u;
                    loop {
                        let _e2780 = phi_4473_;
                        let _e2782 = phi_4476_;
                        let _e2784 = phi_4478_;
                        let _e2786 = phi_4480_;
                        let _e2788 = phi_4482_;
                        let _e2790 = phi_4484_;
                        let _e2792 = phi_4488_;
                        let _e2794 = phi_4490_;
                        let _e2796 = phi_4492_;
                        let _e2798 = phi_4494_;
                        let _e2800 = phi_4496_;
                        if (_e2796 < 64u) {
                            phi_4505_ = _e2780;
                            phi_4508_ = _e2786;
                            phi_4510_ = _e2788;
                            phi_4514_ = _e2782;
                            phi_4516_ = false;
                            phi_4518_ = false;
                            phi_4520_ = false;
                            phi_4522_ = _e2792;
                            phi_4524_ = _e2794;
                            phi_4526_ = _e2796;
                            phi_4528_ = _e2798;
                            phi_4530_ = _e2800;
                            loop {
                                let _e2803 = phi_4505_;
                                let _e2805 = phi_4508_;
                                let _e2807 = phi_4510_;
                                let _e2809 = phi_4514_;
                                let _e2811 = phi_4516_;
                                let _e2813 = phi_4518_;
                                let _e2815 = phi_4520_;
                                let _e2817 = phi_4522_;
                                let _e2819 = phi_4524_;
                                let _e2821 = phi_4526_;
                                let _e2823 = phi_4528_;
                                let _e2825 = phi_4530_;
                                local_34 = _e2809;
                                local_35 = _e2815;
                                local_36 = _e2803;
                                local_37 = _e2803;
                                local_38 = _e2803;
                                local_39 = _e2803;
                                local_40 = _e2803;
                                local_41 = _e2803;
                                local_42 = _e2803;
                                local_43 = _e2803;
                                local_44 = _e2803;
                                local_45 = _e2803;
                                local_46 = _e2803;
                                local_47 = _e2803;
                                local_48 = _e2823;
                                local_49 = _e2819;
                                local_50 = _e2817;
                                local_51 = _e2823;
                                local_52 = _e2803;
                                local_53 = _e2803;
                                local_54 = _e2803;
                                local_55 = _e2803;
                                local_56 = _e2803;
                                local_57 = _e2803;
                                local_58 = _e2811;
                                local_59 = _e2811;
                                local_60 = _e2823;
                                local_61 = _e2813;
                                local_62 = _e2823;
                                local_63 = _e2803;
                                local_64 = _e2803;
                                local_65 = _e2803;
                                local_66 = _e2819;
                                local_67 = _e2819;
                                local_68 = _e2803;
                                local_69 = _e2803;
                                local_70 = _e2803;
                                local_71 = _e2819;
                                local_72 = _e2817;
                                local_73 = _e2803;
                                local_74 = _e2803;
                                local_75 = _e2803;
                                local_76 = _e2803;
                                local_77 = _e2803;
                                local_78 = _e2803;
                                local_79 = _e2803;
                                local_80 = _e2803;
                                local_82 = _e2819;
                                local_83 = _e2817;
                                local_84 = _e2823;
                                local_85 = _e2819;
                                local_86 = _e2819;
                                local_87 = _e2811;
                                local_109 = _e2815;
                                local_110 = _e2805;
                                local_111 = _e2807;
                                local_112 = _e2815;
                                local_113 = _e2805;
                                local_114 = _e2807;
                                local_115 = _e2815;
                                local_88 = _e2825;
                                local_89 = _e2825;
                                local_90 = _e2823;
                                local_91 = _e2823;
                                local_92 = _e2823;
                                local_93 = _e2819;
                                local_116 = _e2823;
                                local_117 = _e2825;
                                local_118 = _e2803;
                                local_119 = _e2817;
                                local_120 = _e2819;
                                local_121 = _e2821;
                                if (_e2821 < 64u) {
                                    if _e2815 {
                                        phi_5408_ = array<type_9, 4>();
                                        phi_5409_ = bool();
                                        phi_5410_ = bool();
                                        phi_5412_ = bool();
                                        phi_5413_ = bool();
                                        phi_5414_ = bool();
                                        phi_5415_ = bool();
                                        phi_5416_ = u32();
                                        phi_5417_ = u32();
                                        phi_5418_ = u32();
                                        phi_5419_ = u32();
                                        phi_5420_ = u32();
                                        phi_5421_ = false;
                                    } else {
                                        if _e2809 {
                                            phi_5394_ = array<type_9, 4>();
                                            phi_5395_ = bool();
                                            phi_5396_ = bool();
                                            phi_5398_ = bool();
                                            phi_5399_ = bool();
                                            phi_5400_ = bool();
                                            phi_5401_ = bool();
                                            phi_5402_ = u32();
                                            phi_5403_ = u32();
                                            phi_5404_ = u32();
                                            phi_5405_ = u32();
                                            phi_5406_ = u32();
                                            phi_5407_ = false;
                                        } else {
                                            let _e2828 = (31u - _e2823);
                                            let _e2831 = (_e2825 << bitcast<u32>((_e2828 & 31u)));
                                            let _e2835 = ((_e2825 + 1u) << bitcast<u32>((_e2828 & 31u)));
                                            if (_e2831 > _e1262) {
                                                phi_4736_ = bool();
                                                phi_4737_ = true;
                                            } else {
                                                let _e2837 = (_e2835 < _e1260);
                                                if _e2837 {
                                                    phi_4735_ = bool();
                                                } else {
                                                    let _e2842 = function_8(128u);
                                                    let _e2847 = ((_e2803[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2875 = function_8(128u);
                                                    let _e2880 = ((_e2803[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2909 = function_8(128u);
                                                    let _e2914 = ((_e2803[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2943 = function_8(128u);
                                                    let _e2948 = ((_e2803[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_4735_ = ((((select(0u, select(1u, 2u, ((_e2803[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2842.member - select(_e2803[0].member, (~(_e2803[0].member) + select(0u, 1u, (_e2803[0].member_1 == 0u))), _e2847)) - select(0u, 1u, (_e2842.member_1 < select(_e2803[0].member_1, (~(_e2803[0].member_1) + 1u), _e2847)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2803[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2875.member - select(_e2803[1].member, (~(_e2803[1].member) + select(0u, 1u, (_e2803[1].member_1 == 0u))), _e2880)) - select(0u, 1u, (_e2875.member_1 < select(_e2803[1].member_1, (~(_e2803[1].member_1) + 1u), _e2880)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2803[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2909.member - select(_e2803[2].member, (~(_e2803[2].member) + select(0u, 1u, (_e2803[2].member_1 == 0u))), _e2914)) - select(0u, 1u, (_e2909.member_1 < select(_e2803[2].member_1, (~(_e2803[2].member_1) + 1u), _e2914)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2803[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2943.member - select(_e2803[3].member, (~(_e2803[3].member) + select(0u, 1u, (_e2803[3].member_1 == 0u))), _e2948)) - select(0u, 1u, (_e2943.member_1 < select(_e2803[3].member_1, (~(_e2803[3].member_1) + 1u), _e2948)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e2975 = phi_4735_;
                                                phi_4736_ = _e2975;
                                                phi_4737_ = _e2837;
                                            }
                                            let _e2977 = phi_4736_;
                                            let _e2979 = phi_4737_;
                                            let _e2980 = select(_e2977, true, _e2979);
                                            let _e2985 = function_8(128u);
                                            let _e2990 = ((_e2803[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3013 = select(0u, select(1u, 2u, ((_e2803[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2985.member - select(_e2803[0].member, (~(_e2803[0].member) + select(0u, 1u, (_e2803[0].member_1 == 0u))), _e2990)) - select(0u, 1u, (_e2985.member_1 < select(_e2803[0].member_1, (~(_e2803[0].member_1) + 1u), _e2990)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3018 = function_8(128u);
                                            let _e3023 = ((_e2803[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3046 = select(0u, select(1u, 2u, ((_e2803[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3018.member - select(_e2803[1].member, (~(_e2803[1].member) + select(0u, 1u, (_e2803[1].member_1 == 0u))), _e3023)) - select(0u, 1u, (_e3018.member_1 < select(_e2803[1].member_1, (~(_e2803[1].member_1) + 1u), _e3023)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3051 = function_8(128u);
                                            let _e3056 = ((_e2803[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3079 = select(0u, select(1u, 2u, ((_e2803[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3051.member - select(_e2803[2].member, (~(_e2803[2].member) + select(0u, 1u, (_e2803[2].member_1 == 0u))), _e3056)) - select(0u, 1u, (_e3051.member_1 < select(_e2803[2].member_1, (~(_e2803[2].member_1) + 1u), _e3056)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3084 = function_8(128u);
                                            let _e3089 = ((_e2803[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3112 = select(0u, select(1u, 2u, ((_e2803[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3084.member - select(_e2803[3].member, (~(_e2803[3].member) + select(0u, 1u, (_e2803[3].member_1 == 0u))), _e3089)) - select(0u, 1u, (_e3084.member_1 < select(_e2803[3].member_1, (~(_e2803[3].member_1) + 1u), _e3089)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3122 = select(false, select(true, select(false, (_e3046 != 0u), (_e3079 == _e3112)), select(true, (_e3079 == 0u), (_e3046 == _e3013))), ((_e3013 | _e3112) == 3u));
                                            let _e3127 = function_8(128u);
                                            let _e3132 = ((_e2803[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3158 = select(false, (_e2831 >= _e1260), (select(0u, select(1u, 2u, ((_e2803[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3127.member - select(_e2803[0].member, (~(_e2803[0].member) + select(0u, 1u, (_e2803[0].member_1 == 0u))), _e3132)) - select(0u, 1u, (_e3127.member_1 < select(_e2803[0].member_1, (~(_e2803[0].member_1) + 1u), _e3132)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e3159 = (_e2823 == 3u);
                                            let _e3160 = (_e2823 == 8u);
                                            let _e3165 = select(select(select((_e2823 == 14u), bool(), _e3160), bool(), _e3159), true, select(_e3160, true, _e3159));
                                            let _e3167 = select(false, !(_e2805), _e3158);
                                            let _e3168 = (_e2823 == 31u);
                                            let _e3179 = select(select(false, !(_e2807), select(select(select(select(select(false, !(_e2784), _e3122), bool(), _e3158), bool(), _e3165), bool(), _e3168), true, select(select(_e3158, true, _e3165), true, _e3168))), true, _e3167);
                                            if _e2980 {
                                                phi_5388_ = _e2803;
                                                phi_5389_ = _e2805;
                                                phi_5390_ = _e2807;
                                                phi_5392_ = _e2823;
                                                phi_5393_ = _e2825;
                                            } else {
                                                if _e3179 {
                                                    phi_5382_ = _e2803;
                                                    phi_5383_ = _e2805;
                                                    phi_5384_ = _e2807;
                                                    phi_5386_ = _e2823;
                                                    phi_5387_ = _e2825;
                                                } else {
                                                    let _e3188 = (_e2803[0].member_1 + _e2803[1].member_1);
                                                    let _e3192 = ((_e2803[0].member + _e2803[1].member) + select(0u, 1u, (_e3188 < _e2803[0].member_1)));
                                                    let _e3200 = bitcast<u32>((bitcast<i32>(_e3192) >> bitcast<u32>(1u)));
                                                    let _e3203 = ((_e3188 >> bitcast<u32>(1u)) | ((_e3192 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3212 = (_e2803[1].member_1 + _e2803[2].member_1);
                                                    let _e3216 = ((_e2803[1].member + _e2803[2].member) + select(0u, 1u, (_e3212 < _e2803[1].member_1)));
                                                    let _e3224 = bitcast<u32>((bitcast<i32>(_e3216) >> bitcast<u32>(1u)));
                                                    let _e3227 = ((_e3212 >> bitcast<u32>(1u)) | ((_e3216 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3236 = (_e2803[2].member_1 + _e2803[3].member_1);
                                                    let _e3240 = ((_e2803[2].member + _e2803[3].member) + select(0u, 1u, (_e3236 < _e2803[2].member_1)));
                                                    let _e3248 = bitcast<u32>((bitcast<i32>(_e3240) >> bitcast<u32>(1u)));
                                                    let _e3251 = ((_e3236 >> bitcast<u32>(1u)) | ((_e3240 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3252 = (_e3203 + _e3227);
                                                    let _e3256 = ((_e3200 + _e3224) + select(0u, 1u, (_e3252 < _e3203)));
                                                    let _e3264 = bitcast<u32>((bitcast<i32>(_e3256) >> bitcast<u32>(1u)));
                                                    let _e3267 = ((_e3252 >> bitcast<u32>(1u)) | ((_e3256 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3268 = (_e3227 + _e3251);
                                                    let _e3272 = ((_e3224 + _e3248) + select(0u, 1u, (_e3268 < _e3227)));
                                                    let _e3280 = bitcast<u32>((bitcast<i32>(_e3272) >> bitcast<u32>(1u)));
                                                    let _e3283 = ((_e3268 >> bitcast<u32>(1u)) | ((_e3272 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3284 = (_e3267 + _e3283);
                                                    let _e3288 = ((_e3264 + _e3280) + select(0u, 1u, (_e3284 < _e3267)));
                                                    let _e3296 = bitcast<u32>((bitcast<i32>(_e3288) >> bitcast<u32>(1u)));
                                                    let _e3299 = ((_e3284 >> bitcast<u32>(1u)) | ((_e3288 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3300 = (2u * _e2825);
                                                    let _e3311 = function_8(128u);
                                                    let _e3316 = ((_e2803[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e3340 = function_8(128u);
                                                    let _e3345 = ((_e3200 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3367 = function_8(128u);
                                                    let _e3372 = ((_e3264 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3394 = function_8(128u);
                                                    let _e3399 = ((_e3296 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e2803[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3311.member - select(_e2803[0].member, (~(_e2803[0].member) + select(0u, 1u, (_e2803[0].member_1 == 0u))), _e3316)) - select(0u, 1u, (_e3311.member_1 < select(_e2803[0].member_1, (~(_e2803[0].member_1) + 1u), _e3316)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3200 >> bitcast<u32>(31i)) != 0u)), ((((_e3340.member - select(_e3200, (~(_e3200) + select(0u, 1u, (_e3203 == 0u))), _e3345)) - select(0u, 1u, (_e3340.member_1 < select(_e3203, (~(_e3203) + 1u), _e3345)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3264 >> bitcast<u32>(31i)) != 0u)), ((((_e3367.member - select(_e3264, (~(_e3264) + select(0u, 1u, (_e3267 == 0u))), _e3372)) - select(0u, 1u, (_e3367.member_1 < select(_e3267, (~(_e3267) + 1u), _e3372)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3296 >> bitcast<u32>(31i)) != 0u)), ((((_e3394.member - select(_e3296, (~(_e3296) + select(0u, 1u, (_e3299 == 0u))), _e3399)) - select(0u, 1u, (_e3394.member_1 < select(_e3299, (~(_e3299) + 1u), _e3399)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_5379_ = array<type_9, 4>(type_9(_e3296, _e3299), type_9(_e3280, _e3283), type_9(_e3248, _e3251), _e2803[3]);
                                                        phi_5380_ = false;
                                                        phi_5381_ = (_e3300 + 1u);
                                                    } else {
                                                        phi_5379_ = array<type_9, 4>(_e2803[0], type_9(_e3200, _e3203), type_9(_e3264, _e3267), type_9(_e3296, _e3299));
                                                        phi_5380_ = _e2805;
                                                        phi_5381_ = _e3300;
                                                    }
                                                    let _e3429 = phi_5379_;
                                                    let _e3431 = phi_5380_;
                                                    let _e3433 = phi_5381_;
                                                    phi_5382_ = _e3429;
                                                    phi_5383_ = _e3431;
                                                    phi_5384_ = false;
                                                    phi_5386_ = (_e2823 + 1u);
                                                    phi_5387_ = _e3433;
                                                }
                                                let _e3435 = phi_5382_;
                                                let _e3437 = phi_5383_;
                                                let _e3439 = phi_5384_;
                                                let _e3441 = phi_5386_;
                                                let _e3443 = phi_5387_;
                                                phi_5388_ = _e3435;
                                                phi_5389_ = _e3437;
                                                phi_5390_ = _e3439;
                                                phi_5392_ = _e3441;
                                                phi_5393_ = _e3443;
                                            }
                                            let _e3445 = phi_5388_;
                                            let _e3447 = phi_5389_;
                                            let _e3449 = phi_5390_;
                                            let _e3451 = phi_5392_;
                                            let _e3453 = phi_5393_;
                                            phi_5394_ = _e3445;
                                            phi_5395_ = _e3447;
                                            phi_5396_ = _e3449;
                                            phi_5398_ = _e3179;
                                            phi_5399_ = _e3167;
                                            phi_5400_ = _e3122;
                                            phi_5401_ = _e2980;
                                            phi_5402_ = _e2835;
                                            phi_5403_ = _e2831;
                                            phi_5404_ = (_e2821 + 1u);
                                            phi_5405_ = _e3451;
                                            phi_5406_ = _e3453;
                                            phi_5407_ = true;
                                        }
                                        let _e3455 = phi_5394_;
                                        let _e3457 = phi_5395_;
                                        let _e3459 = phi_5396_;
                                        let _e3461 = phi_5398_;
                                        let _e3463 = phi_5399_;
                                        let _e3465 = phi_5400_;
                                        let _e3467 = phi_5401_;
                                        let _e3469 = phi_5402_;
                                        let _e3471 = phi_5403_;
                                        let _e3473 = phi_5404_;
                                        let _e3475 = phi_5405_;
                                        let _e3477 = phi_5406_;
                                        let _e3479 = phi_5407_;
                                        phi_5408_ = _e3455;
                                        phi_5409_ = _e3457;
                                        phi_5410_ = _e3459;
                                        phi_5412_ = _e3461;
                                        phi_5413_ = _e3463;
                                        phi_5414_ = _e3465;
                                        phi_5415_ = _e3467;
                                        phi_5416_ = _e3469;
                                        phi_5417_ = _e3471;
                                        phi_5418_ = _e3473;
                                        phi_5419_ = _e3475;
                                        phi_5420_ = _e3477;
                                        phi_5421_ = _e3479;
                                    }
                                    let _e3481 = phi_5408_;
                                    let _e3483 = phi_5409_;
                                    let _e3485 = phi_5410_;
                                    let _e3487 = phi_5412_;
                                    let _e3489 = phi_5413_;
                                    let _e3491 = phi_5414_;
                                    let _e3493 = phi_5415_;
                                    let _e3495 = phi_5416_;
                                    let _e3497 = phi_5417_;
                                    let _e3499 = phi_5418_;
                                    let _e3501 = phi_5419_;
                                    let _e3503 = phi_5420_;
                                    let _e3505 = phi_5421_;
                                    phi_4506_ = _e3481;
                                    phi_4509_ = _e3483;
                                    phi_4511_ = _e3485;
                                    phi_4515_ = _e3487;
                                    phi_4517_ = _e3489;
                                    phi_4519_ = _e3491;
                                    phi_4521_ = _e3493;
                                    phi_4523_ = _e3495;
                                    phi_4525_ = _e3497;
                                    phi_4527_ = _e3499;
                                    phi_4529_ = _e3501;
                                    phi_4531_ = _e3503;
                                    phi_5422_ = _e3505;
                                } else {
                                    phi_4506_ = array<type_9, 4>();
                                    phi_4509_ = bool();
                                    phi_4511_ = bool();
                                    phi_4515_ = bool();
                                    phi_4517_ = bool();
                                    phi_4519_ = bool();
                                    phi_4521_ = bool();
                                    phi_4523_ = u32();
                                    phi_4525_ = u32();
                                    phi_4527_ = u32();
                                    phi_4529_ = u32();
                                    phi_4531_ = u32();
                                    phi_5422_ = false;
                                }
                                let _e3507 = phi_4506_;
                                let _e3509 = phi_4509_;
                                let _e3511 = phi_4511_;
                                let _e3513 = phi_4515_;
                                let _e3515 = phi_4517_;
                                let _e3517 = phi_4519_;
                                let _e3519 = phi_4521_;
                                let _e3521 = phi_4523_;
                                let _e3523 = phi_4525_;
                                let _e3525 = phi_4527_;
                                let _e3527 = phi_4529_;
                                let _e3529 = phi_4531_;
                                let _e3531 = phi_5422_;
                                continue;
                                continuing {
                                    phi_4505_ = _e3507;
                                    phi_4508_ = _e3509;
                                    phi_4510_ = _e3511;
                                    phi_4514_ = _e3513;
                                    phi_4516_ = _e3515;
                                    phi_4518_ = _e3517;
                                    phi_4520_ = _e3519;
                                    phi_4522_ = _e3521;
                                    phi_4524_ = _e3523;
                                    phi_4526_ = _e3525;
                                    phi_4528_ = _e3527;
                                    phi_4530_ = _e3529;
                                    break if !(_e3531);
                                }
                            }
                            let _e3534 = local_34;
                            if _e3534 {
                                let _e3536 = local_35;
                                if _e3536 {
                                    phi_8293_ = _e2782;
                                    phi_8294_ = _e2784;
                                    let _e6380 = local_110;
                                    phi_8295_ = _e6380;
                                    let _e6383 = local_111;
                                    phi_8296_ = _e6383;
                                    phi_8297_ = _e2790;
                                    let _e6387 = local_112;
                                    phi_8298_ = _e6387;
                                    phi_8299_ = bool();
                                    phi_8300_ = type_18();
                                    phi_8301_ = true;
                                    phi_8302_ = false;
                                    phi_8303_ = false;
                                    phi_8304_ = false;
                                } else {
                                    let _e3538 = local_36;
                                    let _e3542 = local_37;
                                    let _e3545 = function_8(128u);
                                    let _e3550 = ((_e3538[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3558 = local_38;
                                    let _e3577 = local_39;
                                    let _e3581 = local_40;
                                    let _e3584 = function_8(128u);
                                    let _e3589 = ((_e3577[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3597 = local_41;
                                    let _e3617 = local_42;
                                    let _e3621 = local_43;
                                    let _e3624 = function_8(128u);
                                    let _e3629 = ((_e3617[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3637 = local_44;
                                    let _e3657 = local_45;
                                    let _e3661 = local_46;
                                    let _e3664 = function_8(128u);
                                    let _e3669 = ((_e3657[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3677 = local_47;
                                    let _e3698 = local_48;
                                    let _e3703 = local_49;
                                    let _e3705 = local_50;
                                    let _e3707 = local_51;
                                    let _e3708 = type_18(_e3703, _e3705, _e3707);
                                    let _e3710 = local_52;
                                    let _e3714 = local_53;
                                    let _e3717 = function_8(128u);
                                    let _e3722 = ((_e3710[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3730 = local_54;
                                    let _e3749 = local_55;
                                    let _e3753 = local_56;
                                    let _e3756 = function_8(128u);
                                    let _e3761 = ((_e3749[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3769 = local_57;
                                    let _e3788 = ((select(0u, select(1u, 2u, ((_e3710[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3717.member - select(_e3730[0].member, (~(_e3710[0].member) + select(0u, 1u, (_e3714[0].member_1 == 0u))), _e3722)) - select(0u, 1u, (_e3717.member_1 < select(_e3730[0].member_1, (~(_e3714[0].member_1) + 1u), _e3722)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3749[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3756.member - select(_e3769[3].member, (~(_e3749[3].member) + select(0u, 1u, (_e3753[3].member_1 == 0u))), _e3761)) - select(0u, 1u, (_e3756.member_1 < select(_e3769[3].member_1, (~(_e3753[3].member_1) + 1u), _e3761)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e3790 = local_58;
                                    let _e3793 = local_59;
                                    if _e3793 {
                                        let _e4410 = local_85;
                                        let _e4413 = local_86;
                                        phi_6530_ = _e2782;
                                        phi_6531_ = _e2784;
                                        phi_6532_ = _e3788;
                                        phi_6533_ = type_18(_e4413, (_e4410 + 1u), 31u);
                                        phi_6534_ = _e2790;
                                    } else {
                                        if _e2782 {
                                            phi_6016_ = bool();
                                            phi_6017_ = type_18();
                                            phi_6018_ = true;
                                        } else {
                                            let _e3795 = local_60;
                                            let _e3799 = local_61;
                                            if select(true, select(true, false, (_e3795 < _e2778)), _e3799) {
                                                let _e3802 = local_62;
                                                if (_e3802 == 31u) {
                                                    if _e3788 {
                                                        phi_6009_ = _e3788;
                                                        phi_6010_ = _e3708;
                                                    } else {
                                                        let _e3805 = local_63;
                                                        let _e3809 = local_64;
                                                        let _e3812 = function_8(128u);
                                                        let _e3817 = ((_e3805[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3825 = local_65;
                                                        if (select(0u, select(1u, 2u, ((_e3805[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3812.member - select(_e3825[0].member, (~(_e3805[0].member) + select(0u, 1u, (_e3809[0].member_1 == 0u))), _e3817)) - select(0u, 1u, (_e3812.member_1 < select(_e3825[0].member_1, (~(_e3809[0].member_1) + 1u), _e3817)))) >> bitcast<u32>(31i)) != 0u)) == 0u) {
                                                            phi_6007_ = _e3788;
                                                            phi_6008_ = _e3708;
                                                        } else {
                                                            let _e3848 = select((bitcast<u32>(31i) - firstLeadingBit(_e1264)), 32u, (_e1264 == 0u));
                                                            let _e3854 = local_66;
                                                            let _e3855 = (_e3854 + (1u << bitcast<u32>(((31u - _e3848) & 31u))));
                                                            let _e3857 = local_67;
                                                            if (_e3855 <= 2147483648u) {
                                                                let _e3861 = local_68;
                                                                let _e3865 = local_69;
                                                                let _e3868 = function_8(128u);
                                                                let _e3873 = ((_e3861[0].member >> bitcast<u32>(31i)) != 0u);
                                                                let _e3881 = local_70;
                                                                let _e3904 = function_1(((_e2661 - _e2588.member) - select(0u, 1u, (_e2657 < _e2588.member_1))), (_e2657 - _e2588.member_1), _e3855);
                                                                let _e3907 = (_e2588.member_1 + _e3904.member_1);
                                                                let _e3911 = ((_e2588.member + _e3904.member) + select(0u, 1u, (_e3907 < _e2588.member_1)));
                                                                let _e3917 = function_1(((_e2732 - _e2661) - select(0u, 1u, (_e2728 < _e2657))), (_e2728 - _e2657), _e3855);
                                                                let _e3920 = (_e2657 + _e3917.member_1);
                                                                let _e3924 = ((_e2661 + _e3917.member) + select(0u, 1u, (_e3920 < _e2657)));
                                                                let _e3930 = function_1(((_e2766.member - _e2732) - select(0u, 1u, (_e2766.member_1 < _e2728))), (_e2766.member_1 - _e2728), _e3855);
                                                                let _e3933 = (_e2728 + _e3930.member_1);
                                                                let _e3943 = function_1(((_e3924 - _e3911) - select(0u, 1u, (_e3920 < _e3907))), (_e3920 - _e3907), _e3855);
                                                                let _e3946 = (_e3907 + _e3943.member_1);
                                                                let _e3950 = ((_e3911 + _e3943.member) + select(0u, 1u, (_e3946 < _e3907)));
                                                                let _e3956 = function_1(((((_e2732 + _e3930.member) + select(0u, 1u, (_e3933 < _e2728))) - _e3924) - select(0u, 1u, (_e3933 < _e3920))), (_e3933 - _e3920), _e3855);
                                                                let _e3959 = (_e3920 + _e3956.member_1);
                                                                let _e3969 = function_1(((((_e3924 + _e3956.member) + select(0u, 1u, (_e3959 < _e3920))) - _e3950) - select(0u, 1u, (_e3959 < _e3946))), (_e3959 - _e3946), _e3855);
                                                                let _e3972 = (_e3946 + _e3969.member_1);
                                                                let _e3976 = ((_e3950 + _e3969.member) + select(0u, 1u, (_e3972 < _e3946)));
                                                                let _e3977 = function_8(128u);
                                                                let _e3982 = ((_e3976 >> bitcast<u32>(31i)) != 0u);
                                                                phi_6006_ = ((select(0u, select(1u, 2u, ((_e3861[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3868.member - select(_e3881[0].member, (~(_e3861[0].member) + select(0u, 1u, (_e3865[0].member_1 == 0u))), _e3873)) - select(0u, 1u, (_e3868.member_1 < select(_e3881[0].member_1, (~(_e3865[0].member_1) + 1u), _e3873)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3976 >> bitcast<u32>(31i)) != 0u)), ((((_e3977.member - select(_e3976, (~(_e3976) + select(0u, 1u, (_e3972 == 0u))), _e3982)) - select(0u, 1u, (_e3977.member_1 < select(_e3972, (~(_e3972) + 1u), _e3982)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                            } else {
                                                                phi_6006_ = false;
                                                            }
                                                            let _e4006 = phi_6006_;
                                                            phi_6007_ = _e4006;
                                                            phi_6008_ = type_18(_e3857, _e3855, _e3848);
                                                        }
                                                        let _e4008 = phi_6007_;
                                                        let _e4010 = phi_6008_;
                                                        phi_6009_ = _e4008;
                                                        phi_6010_ = _e4010;
                                                    }
                                                    let _e4012 = phi_6009_;
                                                    let _e4014 = phi_6010_;
                                                    phi_6011_ = _e4012;
                                                    phi_6012_ = _e4014;
                                                } else {
                                                    phi_6011_ = _e3788;
                                                    phi_6012_ = _e3708;
                                                }
                                                let _e4016 = phi_6011_;
                                                let _e4018 = phi_6012_;
                                                phi_6013_ = _e4016;
                                                phi_6014_ = _e4018;
                                                phi_6015_ = false;
                                            } else {
                                                phi_6013_ = bool();
                                                phi_6014_ = type_18();
                                                phi_6015_ = true;
                                            }
                                            let _e4020 = phi_6013_;
                                            let _e4022 = phi_6014_;
                                            let _e4024 = phi_6015_;
                                            phi_6016_ = _e4020;
                                            phi_6017_ = _e4022;
                                            phi_6018_ = _e4024;
                                        }
                                        let _e4026 = phi_6016_;
                                        let _e4028 = phi_6017_;
                                        let _e4030 = phi_6018_;
                                        if _e4030 {
                                            let _e4031 = select(_e2778, 31u, _e2782);
                                            let _e4034 = local_71;
                                            let _e4035 = select(_e4034, _e2790.member, _e2782);
                                            let _e4038 = local_72;
                                            let _e4039 = select(_e4038, _e2790.member_1, _e2782);
                                            let _e4041 = local_73;
                                            let _e4045 = local_74;
                                            let _e4052 = ((f32(bitcast<i32>(_e4041[0].member)) * 4294967300f) + f32(_e4045[0].member_1));
                                            let _e4054 = local_75;
                                            let _e4058 = local_76;
                                            let _e4065 = ((f32(bitcast<i32>(_e4054[1].member)) * 4294967300f) + f32(_e4058[1].member_1));
                                            let _e4067 = local_77;
                                            let _e4071 = local_78;
                                            let _e4078 = ((f32(bitcast<i32>(_e4067[2].member)) * 4294967300f) + f32(_e4071[2].member_1));
                                            let _e4080 = local_79;
                                            let _e4084 = local_80;
                                            let _e4091 = ((f32(bitcast<i32>(_e4080[3].member)) * 4294967300f) + f32(_e4084[3].member_1));
                                            phi_6059_ = type_14(0i, 6i);
                                            phi_6062_ = 1f;
                                            phi_6064_ = 0f;
                                            phi_6066_ = (_e4052 / (_e4052 - _e4091));
                                            loop {
                                                let _e4095 = phi_6059_;
                                                let _e4097 = phi_6062_;
                                                let _e4099 = phi_6064_;
                                                let _e4101 = phi_6066_;
                                                local_81 = _e4101;
                                                if (_e4095.member < _e4095.member_1) {
                                                    let _e4108 = (_e4095.member + 1i);
                                                    phi_6060_ = type_14(select(_e4108, type_15().member_1, select(false, true, ((false == (_e4108 > _e4095.member)) != false))), _e4095.member_1);
                                                    phi_6107_ = type_15(1u, _e4095.member);
                                                } else {
                                                    phi_6060_ = _e4095;
                                                    phi_6107_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e4119 = phi_6060_;
                                                let _e4121 = phi_6107_;
                                                let _e4124 = (bitcast<i32>(_e4121.member) != 0i);
                                                if _e4124 {
                                                    let _e4125 = function_7(_e4052, _e4065, _e4101);
                                                    let _e4126 = function_7(_e4065, _e4078, _e4101);
                                                    let _e4127 = function_7(_e4078, _e4091, _e4101);
                                                    let _e4128 = function_7(_e4125, _e4126, _e4101);
                                                    let _e4129 = function_7(_e4126, _e4127, _e4101);
                                                    let _e4130 = function_7(_e4128, _e4129, _e4101);
                                                    let _e4133 = ((_e4130 < 0f) == (_e4052 < 0f));
                                                    let _e4134 = select(_e4101, _e4097, _e4133);
                                                    let _e4135 = select(_e4099, _e4101, _e4133);
                                                    let _e4139 = (_e4101 - (_e4130 / (3f * (_e4129 - _e4128))));
                                                    phi_6063_ = _e4134;
                                                    phi_6065_ = _e4135;
                                                    phi_6067_ = select(_e4139, (0.5f * (_e4135 + _e4134)), select(true, select(true, false, (_e4139 <= _e4134)), (_e4139 >= _e4135)));
                                                } else {
                                                    phi_6063_ = f32();
                                                    phi_6065_ = f32();
                                                    phi_6067_ = f32();
                                                }
                                                let _e4148 = phi_6063_;
                                                let _e4150 = phi_6065_;
                                                let _e4152 = phi_6067_;
                                                continue;
                                                continuing {
                                                    phi_6059_ = _e4119;
                                                    phi_6062_ = _e4148;
                                                    phi_6064_ = _e4150;
                                                    phi_6066_ = _e4152;
                                                    break if !(_e4124);
                                                }
                                            }
                                            let _e4157 = (1u << bitcast<u32>(((31u - _e4031) & 31u)));
                                            let _e4158 = (_e4039 - _e4035);
                                            let _e4161 = local_81;
                                            let _e4162 = (_e4161 * f32(_e4158));
                                            let _e4167 = select(select(u32(_e4162), 0u, (_e4162 < 0f)), 4294967295u, (_e4162 > 4294967000f));
                                            let _e4169 = select(_e4167, _e4158, (_e4158 < _e4167));
                                            let _e4171 = (_e4157 / 2u);
                                            let _e4174 = ((_e4035 + _e4169) - select(_e4171, _e4169, (_e4169 < _e4171)));
                                            let _e4175 = (_e4174 + _e4157);
                                            let _e4177 = select(_e4175, _e4039, (_e4039 < _e4175));
                                            let _e4183 = function_1(((_e2661 - _e2588.member) - select(0u, 1u, (_e2657 < _e2588.member_1))), (_e2657 - _e2588.member_1), _e4174);
                                            let _e4186 = (_e2588.member_1 + _e4183.member_1);
                                            let _e4190 = ((_e2588.member + _e4183.member) + select(0u, 1u, (_e4186 < _e2588.member_1)));
                                            let _e4196 = function_1(((_e2732 - _e2661) - select(0u, 1u, (_e2728 < _e2657))), (_e2728 - _e2657), _e4174);
                                            let _e4199 = (_e2657 + _e4196.member_1);
                                            let _e4203 = ((_e2661 + _e4196.member) + select(0u, 1u, (_e4199 < _e2657)));
                                            let _e4209 = function_1(((_e2766.member - _e2732) - select(0u, 1u, (_e2766.member_1 < _e2728))), (_e2766.member_1 - _e2728), _e4174);
                                            let _e4212 = (_e2728 + _e4209.member_1);
                                            let _e4222 = function_1(((_e4203 - _e4190) - select(0u, 1u, (_e4199 < _e4186))), (_e4199 - _e4186), _e4174);
                                            let _e4225 = (_e4186 + _e4222.member_1);
                                            let _e4229 = ((_e4190 + _e4222.member) + select(0u, 1u, (_e4225 < _e4186)));
                                            let _e4235 = function_1(((((_e2732 + _e4209.member) + select(0u, 1u, (_e4212 < _e2728))) - _e4203) - select(0u, 1u, (_e4212 < _e4199))), (_e4212 - _e4199), _e4174);
                                            let _e4238 = (_e4199 + _e4235.member_1);
                                            let _e4248 = function_1(((((_e4203 + _e4235.member) + select(0u, 1u, (_e4238 < _e4199))) - _e4229) - select(0u, 1u, (_e4238 < _e4225))), (_e4238 - _e4225), _e4174);
                                            let _e4251 = (_e4225 + _e4248.member_1);
                                            let _e4255 = ((_e4229 + _e4248.member) + select(0u, 1u, (_e4251 < _e4225)));
                                            let _e4256 = function_8(128u);
                                            let _e4261 = ((_e4255 >> bitcast<u32>(31i)) != 0u);
                                            let _e4287 = function_1(((_e2661 - _e2588.member) - select(0u, 1u, (_e2657 < _e2588.member_1))), (_e2657 - _e2588.member_1), _e4177);
                                            let _e4290 = (_e2588.member_1 + _e4287.member_1);
                                            let _e4294 = ((_e2588.member + _e4287.member) + select(0u, 1u, (_e4290 < _e2588.member_1)));
                                            let _e4300 = function_1(((_e2732 - _e2661) - select(0u, 1u, (_e2728 < _e2657))), (_e2728 - _e2657), _e4177);
                                            let _e4303 = (_e2657 + _e4300.member_1);
                                            let _e4307 = ((_e2661 + _e4300.member) + select(0u, 1u, (_e4303 < _e2657)));
                                            let _e4313 = function_1(((_e2766.member - _e2732) - select(0u, 1u, (_e2766.member_1 < _e2728))), (_e2766.member_1 - _e2728), _e4177);
                                            let _e4316 = (_e2728 + _e4313.member_1);
                                            let _e4326 = function_1(((_e4307 - _e4294) - select(0u, 1u, (_e4303 < _e4290))), (_e4303 - _e4290), _e4177);
                                            let _e4329 = (_e4290 + _e4326.member_1);
                                            let _e4333 = ((_e4294 + _e4326.member) + select(0u, 1u, (_e4329 < _e4290)));
                                            let _e4339 = function_1(((((_e2732 + _e4313.member) + select(0u, 1u, (_e4316 < _e2728))) - _e4307) - select(0u, 1u, (_e4316 < _e4303))), (_e4316 - _e4303), _e4177);
                                            let _e4342 = (_e4303 + _e4339.member_1);
                                            let _e4352 = function_1(((((_e4307 + _e4339.member) + select(0u, 1u, (_e4342 < _e4303))) - _e4333) - select(0u, 1u, (_e4342 < _e4329))), (_e4342 - _e4329), _e4177);
                                            let _e4355 = (_e4329 + _e4352.member_1);
                                            let _e4359 = ((_e4333 + _e4352.member) + select(0u, 1u, (_e4355 < _e4329)));
                                            let _e4360 = function_8(128u);
                                            let _e4365 = ((_e4359 >> bitcast<u32>(31i)) != 0u);
                                            let _e4387 = ((select(0u, select(1u, 2u, ((_e4255 >> bitcast<u32>(31i)) != 0u)), ((((_e4256.member - select(_e4255, (~(_e4255) + select(0u, 1u, (_e4251 == 0u))), _e4261)) - select(0u, 1u, (_e4256.member_1 < select(_e4251, (~(_e4251) + 1u), _e4261)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4359 >> bitcast<u32>(31i)) != 0u)), ((((_e4360.member - select(_e4359, (~(_e4359) + select(0u, 1u, (_e4355 == 0u))), _e4365)) - select(0u, 1u, (_e4360.member_1 < select(_e4355, (~(_e4355) + 1u), _e4365)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e4390 = local_82;
                                            let _e4393 = local_83;
                                            let _e4396 = local_84;
                                            phi_6525_ = _e4387;
                                            phi_6526_ = true;
                                            phi_6527_ = _e4387;
                                            phi_6528_ = type_18(select(_e4390, _e4174, _e4387), select(_e4393, _e4177, _e4387), select(_e4396, _e4031, _e4387));
                                            phi_6529_ = type_18(_e4174, _e4177, _e4031);
                                        } else {
                                            phi_6525_ = _e2782;
                                            phi_6526_ = _e2784;
                                            phi_6527_ = _e4026;
                                            phi_6528_ = _e4028;
                                            phi_6529_ = _e2790;
                                        }
                                        let _e4400 = phi_6525_;
                                        let _e4402 = phi_6526_;
                                        let _e4404 = phi_6527_;
                                        let _e4406 = phi_6528_;
                                        let _e4408 = phi_6529_;
                                        phi_6530_ = _e4400;
                                        phi_6531_ = _e4402;
                                        phi_6532_ = _e4404;
                                        phi_6533_ = _e4406;
                                        phi_6534_ = _e4408;
                                    }
                                    let _e4416 = phi_6530_;
                                    let _e4418 = phi_6531_;
                                    let _e4420 = phi_6532_;
                                    let _e4422 = phi_6533_;
                                    let _e4424 = phi_6534_;
                                    let _e4443 = ((_e1839[0][1][0].member - _e1839[0][0][0].member) - select(0u, 1u, (_e1839[0][1][0].member_1 < _e1839[0][0][0].member_1)));
                                    let _e4444 = (_e1839[0][1][0].member_1 - _e1839[0][0][0].member_1);
                                    let _e4456 = ((_e1839[0][1][1].member - _e1839[0][0][1].member) - select(0u, 1u, (_e1839[0][1][1].member_1 < _e1839[0][0][1].member_1)));
                                    let _e4457 = (_e1839[0][1][1].member_1 - _e1839[0][0][1].member_1);
                                    let _e4469 = ((_e1839[0][1][2].member - _e1839[0][0][2].member) - select(0u, 1u, (_e1839[0][1][2].member_1 < _e1839[0][0][2].member_1)));
                                    let _e4470 = (_e1839[0][1][2].member_1 - _e1839[0][0][2].member_1);
                                    let _e4473 = ((_e4443 >> bitcast<u32>(31i)) != 0u);
                                    let _e4480 = select(_e4443, (~(_e4443) + select(0u, 1u, (_e4444 == 0u))), _e4473);
                                    let _e4481 = select(_e4444, (~(_e4444) + 1u), _e4473);
                                    let _e4484 = ((_e4456 >> bitcast<u32>(31i)) != 0u);
                                    let _e4491 = select(_e4456, (~(_e4456) + select(0u, 1u, (_e4457 == 0u))), _e4484);
                                    let _e4492 = select(_e4457, (~(_e4457) + 1u), _e4484);
                                    let _e4499 = ((((_e4491 - _e4480) - select(0u, 1u, (_e4492 < _e4481))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4500 = select(_e4491, _e4480, _e4499);
                                    let _e4501 = select(_e4492, _e4481, _e4499);
                                    let _e4504 = ((_e4469 >> bitcast<u32>(31i)) != 0u);
                                    let _e4511 = select(_e4469, (~(_e4469) + select(0u, 1u, (_e4470 == 0u))), _e4504);
                                    let _e4512 = select(_e4470, (~(_e4470) + 1u), _e4504);
                                    let _e4519 = ((((_e4511 - _e4500) - select(0u, 1u, (_e4512 < _e4501))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4521 = select(_e4512, _e4501, _e4519);
                                    let _e4522 = function_8(4u);
                                    let _e4525 = (_e4521 + _e4522.member_1);
                                    let _e4529 = ((select(_e4511, _e4500, _e4519) + _e4522.member) + select(0u, 1u, (_e4525 < _e4521)));
                                    let _e4544 = ((_e4525 >> bitcast<u32>((_e4422.member_2 & 31u))) | ((_e4529 << bitcast<u32>(((31u - _e4422.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4545 = function_8(4u);
                                    let _e4548 = (_e4544 + _e4545.member_1);
                                    let _e4566 = ((_e1839[1][1][0].member - _e1839[1][0][0].member) - select(0u, 1u, (_e1839[1][1][0].member_1 < _e1839[1][0][0].member_1)));
                                    let _e4567 = (_e1839[1][1][0].member_1 - _e1839[1][0][0].member_1);
                                    let _e4579 = ((_e1839[1][1][1].member - _e1839[1][0][1].member) - select(0u, 1u, (_e1839[1][1][1].member_1 < _e1839[1][0][1].member_1)));
                                    let _e4580 = (_e1839[1][1][1].member_1 - _e1839[1][0][1].member_1);
                                    let _e4592 = ((_e1839[1][1][2].member - _e1839[1][0][2].member) - select(0u, 1u, (_e1839[1][1][2].member_1 < _e1839[1][0][2].member_1)));
                                    let _e4593 = (_e1839[1][1][2].member_1 - _e1839[1][0][2].member_1);
                                    let _e4596 = ((_e4566 >> bitcast<u32>(31i)) != 0u);
                                    let _e4603 = select(_e4566, (~(_e4566) + select(0u, 1u, (_e4567 == 0u))), _e4596);
                                    let _e4604 = select(_e4567, (~(_e4567) + 1u), _e4596);
                                    let _e4607 = ((_e4579 >> bitcast<u32>(31i)) != 0u);
                                    let _e4614 = select(_e4579, (~(_e4579) + select(0u, 1u, (_e4580 == 0u))), _e4607);
                                    let _e4615 = select(_e4580, (~(_e4580) + 1u), _e4607);
                                    let _e4622 = ((((_e4614 - _e4603) - select(0u, 1u, (_e4615 < _e4604))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4623 = select(_e4614, _e4603, _e4622);
                                    let _e4624 = select(_e4615, _e4604, _e4622);
                                    let _e4627 = ((_e4592 >> bitcast<u32>(31i)) != 0u);
                                    let _e4634 = select(_e4592, (~(_e4592) + select(0u, 1u, (_e4593 == 0u))), _e4627);
                                    let _e4635 = select(_e4593, (~(_e4593) + 1u), _e4627);
                                    let _e4642 = ((((_e4634 - _e4623) - select(0u, 1u, (_e4635 < _e4624))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4644 = select(_e4635, _e4624, _e4642);
                                    let _e4645 = function_8(4u);
                                    let _e4648 = (_e4644 + _e4645.member_1);
                                    let _e4652 = ((select(_e4634, _e4623, _e4642) + _e4645.member) + select(0u, 1u, (_e4648 < _e4644)));
                                    let _e4667 = ((_e4648 >> bitcast<u32>((_e4422.member_2 & 31u))) | ((_e4652 << bitcast<u32>(((31u - _e4422.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4668 = function_8(4u);
                                    let _e4671 = (_e4667 + _e4668.member_1);
                                    let _e4689 = ((_e1839[2][1][0].member - _e1839[2][0][0].member) - select(0u, 1u, (_e1839[2][1][0].member_1 < _e1839[2][0][0].member_1)));
                                    let _e4690 = (_e1839[2][1][0].member_1 - _e1839[2][0][0].member_1);
                                    let _e4702 = ((_e1839[2][1][1].member - _e1839[2][0][1].member) - select(0u, 1u, (_e1839[2][1][1].member_1 < _e1839[2][0][1].member_1)));
                                    let _e4703 = (_e1839[2][1][1].member_1 - _e1839[2][0][1].member_1);
                                    let _e4715 = ((_e1839[2][1][2].member - _e1839[2][0][2].member) - select(0u, 1u, (_e1839[2][1][2].member_1 < _e1839[2][0][2].member_1)));
                                    let _e4716 = (_e1839[2][1][2].member_1 - _e1839[2][0][2].member_1);
                                    let _e4719 = ((_e4689 >> bitcast<u32>(31i)) != 0u);
                                    let _e4726 = select(_e4689, (~(_e4689) + select(0u, 1u, (_e4690 == 0u))), _e4719);
                                    let _e4727 = select(_e4690, (~(_e4690) + 1u), _e4719);
                                    let _e4730 = ((_e4702 >> bitcast<u32>(31i)) != 0u);
                                    let _e4737 = select(_e4702, (~(_e4702) + select(0u, 1u, (_e4703 == 0u))), _e4730);
                                    let _e4738 = select(_e4703, (~(_e4703) + 1u), _e4730);
                                    let _e4745 = ((((_e4737 - _e4726) - select(0u, 1u, (_e4738 < _e4727))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4746 = select(_e4737, _e4726, _e4745);
                                    let _e4747 = select(_e4738, _e4727, _e4745);
                                    let _e4750 = ((_e4715 >> bitcast<u32>(31i)) != 0u);
                                    let _e4757 = select(_e4715, (~(_e4715) + select(0u, 1u, (_e4716 == 0u))), _e4750);
                                    let _e4758 = select(_e4716, (~(_e4716) + 1u), _e4750);
                                    let _e4765 = ((((_e4757 - _e4746) - select(0u, 1u, (_e4758 < _e4747))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4767 = select(_e4758, _e4747, _e4765);
                                    let _e4768 = function_8(4u);
                                    let _e4771 = (_e4767 + _e4768.member_1);
                                    let _e4775 = ((select(_e4757, _e4746, _e4765) + _e4768.member) + select(0u, 1u, (_e4771 < _e4767)));
                                    let _e4790 = ((_e4771 >> bitcast<u32>((_e4422.member_2 & 31u))) | ((_e4775 << bitcast<u32>(((31u - _e4422.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4791 = function_8(4u);
                                    let _e4794 = (_e4790 + _e4791.member_1);
                                    local_6[0u].member = ((bitcast<u32>((bitcast<i32>(_e4529) >> bitcast<u32>((_e4422.member_2 & 31u)))) + _e4545.member) + select(0u, 1u, (_e4548 < _e4544)));
                                    local_6[0u].member_1 = _e4548;
                                    local_6[1u].member = ((bitcast<u32>((bitcast<i32>(_e4652) >> bitcast<u32>((_e4422.member_2 & 31u)))) + _e4668.member) + select(0u, 1u, (_e4671 < _e4667)));
                                    local_6[1u].member_1 = _e4671;
                                    local_6[2u].member = ((bitcast<u32>((bitcast<i32>(_e4775) >> bitcast<u32>((_e4422.member_2 & 31u)))) + _e4791.member) + select(0u, 1u, (_e4794 < _e4790)));
                                    local_6[2u].member_1 = _e4794;
                                    let _e4824 = function_1(((_e1839[0][1][0].member - _e1839[0][0][0].member) - select(0u, 1u, (_e1839[0][1][0].member_1 < _e1839[0][0][0].member_1))), (_e1839[0][1][0].member_1 - _e1839[0][0][0].member_1), _e4422.member);
                                    let _e4827 = (_e1839[0][0][0].member_1 + _e4824.member_1);
                                    let _e4831 = ((_e1839[0][0][0].member + _e4824.member) + select(0u, 1u, (_e4827 < _e1839[0][0][0].member_1)));
                                    let _e4845 = function_1(((_e1839[0][1][1].member - _e1839[0][0][1].member) - select(0u, 1u, (_e1839[0][1][1].member_1 < _e1839[0][0][1].member_1))), (_e1839[0][1][1].member_1 - _e1839[0][0][1].member_1), _e4422.member);
                                    let _e4848 = (_e1839[0][0][1].member_1 + _e4845.member_1);
                                    let _e4852 = ((_e1839[0][0][1].member + _e4845.member) + select(0u, 1u, (_e4848 < _e1839[0][0][1].member_1)));
                                    let _e4866 = function_1(((_e1839[0][1][2].member - _e1839[0][0][2].member) - select(0u, 1u, (_e1839[0][1][2].member_1 < _e1839[0][0][2].member_1))), (_e1839[0][1][2].member_1 - _e1839[0][0][2].member_1), _e4422.member);
                                    let _e4869 = (_e1839[0][0][2].member_1 + _e4866.member_1);
                                    let _e4873 = ((_e1839[0][0][2].member + _e4866.member) + select(0u, 1u, (_e4869 < _e1839[0][0][2].member_1)));
                                    let _e4889 = function_1(((_e1839[1][1][0].member - _e1839[1][0][0].member) - select(0u, 1u, (_e1839[1][1][0].member_1 < _e1839[1][0][0].member_1))), (_e1839[1][1][0].member_1 - _e1839[1][0][0].member_1), _e4422.member);
                                    let _e4892 = (_e1839[1][0][0].member_1 + _e4889.member_1);
                                    let _e4896 = ((_e1839[1][0][0].member + _e4889.member) + select(0u, 1u, (_e4892 < _e1839[1][0][0].member_1)));
                                    let _e4910 = function_1(((_e1839[1][1][1].member - _e1839[1][0][1].member) - select(0u, 1u, (_e1839[1][1][1].member_1 < _e1839[1][0][1].member_1))), (_e1839[1][1][1].member_1 - _e1839[1][0][1].member_1), _e4422.member);
                                    let _e4913 = (_e1839[1][0][1].member_1 + _e4910.member_1);
                                    let _e4917 = ((_e1839[1][0][1].member + _e4910.member) + select(0u, 1u, (_e4913 < _e1839[1][0][1].member_1)));
                                    let _e4931 = function_1(((_e1839[1][1][2].member - _e1839[1][0][2].member) - select(0u, 1u, (_e1839[1][1][2].member_1 < _e1839[1][0][2].member_1))), (_e1839[1][1][2].member_1 - _e1839[1][0][2].member_1), _e4422.member);
                                    let _e4934 = (_e1839[1][0][2].member_1 + _e4931.member_1);
                                    let _e4938 = ((_e1839[1][0][2].member + _e4931.member) + select(0u, 1u, (_e4934 < _e1839[1][0][2].member_1)));
                                    let _e4954 = function_1(((_e1839[2][1][0].member - _e1839[2][0][0].member) - select(0u, 1u, (_e1839[2][1][0].member_1 < _e1839[2][0][0].member_1))), (_e1839[2][1][0].member_1 - _e1839[2][0][0].member_1), _e4422.member);
                                    let _e4957 = (_e1839[2][0][0].member_1 + _e4954.member_1);
                                    let _e4961 = ((_e1839[2][0][0].member + _e4954.member) + select(0u, 1u, (_e4957 < _e1839[2][0][0].member_1)));
                                    let _e4975 = function_1(((_e1839[2][1][1].member - _e1839[2][0][1].member) - select(0u, 1u, (_e1839[2][1][1].member_1 < _e1839[2][0][1].member_1))), (_e1839[2][1][1].member_1 - _e1839[2][0][1].member_1), _e4422.member);
                                    let _e4978 = (_e1839[2][0][1].member_1 + _e4975.member_1);
                                    let _e4982 = ((_e1839[2][0][1].member + _e4975.member) + select(0u, 1u, (_e4978 < _e1839[2][0][1].member_1)));
                                    let _e4996 = function_1(((_e1839[2][1][2].member - _e1839[2][0][2].member) - select(0u, 1u, (_e1839[2][1][2].member_1 < _e1839[2][0][2].member_1))), (_e1839[2][1][2].member_1 - _e1839[2][0][2].member_1), _e4422.member);
                                    let _e4999 = (_e1839[2][0][2].member_1 + _e4996.member_1);
                                    let _e5003 = ((_e1839[2][0][2].member + _e4996.member) + select(0u, 1u, (_e4999 < _e1839[2][0][2].member_1)));
                                    local_4 = array<type_9, 3>(type_9(_e4896, _e4892), type_9(_e4917, _e4913), type_9(_e4938, _e4934));
                                    local_5 = array<type_9, 3>(type_9(_e4961, _e4957), type_9(_e4982, _e4978), type_9(_e5003, _e4999));
                                    let _e5014 = local_4[1u].member;
                                    let _e5016 = local_4[1u].member_1;
                                    let _e5019 = local_5[2u].member;
                                    let _e5021 = local_5[2u].member_1;
                                    let _e5022 = function_5(_e5014, _e5016, _e5019, _e5021);
                                    let _e5027 = local_4[2u].member;
                                    let _e5029 = local_4[2u].member_1;
                                    let _e5032 = local_5[1u].member;
                                    let _e5034 = local_5[1u].member_1;
                                    let _e5035 = function_5(_e5027, _e5029, _e5032, _e5034);
                                    let _e5041 = ((_e5022.member - _e5035.member) - select(0u, 1u, (_e5022.member_1 < _e5035.member_1)));
                                    let _e5042 = (_e5022.member_1 - _e5035.member_1);
                                    local_2 = array<type_9, 3>(type_9(_e4896, _e4892), type_9(_e4917, _e4913), type_9(_e4938, _e4934));
                                    local_3 = array<type_9, 3>(type_9(_e4961, _e4957), type_9(_e4982, _e4978), type_9(_e5003, _e4999));
                                    let _e5053 = local_2[2u].member;
                                    let _e5055 = local_2[2u].member_1;
                                    let _e5058 = local_3[0u].member;
                                    let _e5060 = local_3[0u].member_1;
                                    let _e5061 = function_5(_e5053, _e5055, _e5058, _e5060);
                                    let _e5066 = local_2[0u].member;
                                    let _e5068 = local_2[0u].member_1;
                                    let _e5071 = local_3[2u].member;
                                    let _e5073 = local_3[2u].member_1;
                                    let _e5074 = function_5(_e5066, _e5068, _e5071, _e5073);
                                    let _e5080 = ((_e5061.member - _e5074.member) - select(0u, 1u, (_e5061.member_1 < _e5074.member_1)));
                                    let _e5081 = (_e5061.member_1 - _e5074.member_1);
                                    local = array<type_9, 3>(type_9(_e4896, _e4892), type_9(_e4917, _e4913), type_9(_e4938, _e4934));
                                    local_1 = array<type_9, 3>(type_9(_e4961, _e4957), type_9(_e4982, _e4978), type_9(_e5003, _e4999));
                                    let _e5092 = local[0u].member;
                                    let _e5094 = local[0u].member_1;
                                    let _e5097 = local_1[1u].member;
                                    let _e5099 = local_1[1u].member_1;
                                    let _e5100 = function_5(_e5092, _e5094, _e5097, _e5099);
                                    let _e5105 = local[1u].member;
                                    let _e5107 = local[1u].member_1;
                                    let _e5110 = local_1[0u].member;
                                    let _e5112 = local_1[0u].member_1;
                                    let _e5113 = function_5(_e5105, _e5107, _e5110, _e5112);
                                    let _e5119 = ((_e5100.member - _e5113.member) - select(0u, 1u, (_e5100.member_1 < _e5113.member_1)));
                                    let _e5120 = (_e5100.member_1 - _e5113.member_1);
                                    let _e5123 = ((_e5041 >> bitcast<u32>(31i)) != 0u);
                                    let _e5130 = select(_e5041, (~(_e5041) + select(0u, 1u, (_e5042 == 0u))), _e5123);
                                    let _e5131 = select(_e5042, (~(_e5042) + 1u), _e5123);
                                    let _e5134 = ((_e5080 >> bitcast<u32>(31i)) != 0u);
                                    let _e5141 = select(_e5080, (~(_e5080) + select(0u, 1u, (_e5081 == 0u))), _e5134);
                                    let _e5142 = select(_e5081, (~(_e5081) + 1u), _e5134);
                                    let _e5145 = ((_e5119 >> bitcast<u32>(31i)) != 0u);
                                    let _e5152 = select(_e5119, (~(_e5119) + select(0u, 1u, (_e5120 == 0u))), _e5145);
                                    let _e5153 = select(_e5120, (~(_e5120) + 1u), _e5145);
                                    let _e5178 = select(0i, select(2i, 1i, ((((_e5152 - _e5141) - select(0u, 1u, (_e5153 < _e5142))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e5152 - _e5130) - select(0u, 1u, (_e5153 < _e5131))) >> bitcast<u32>(31i)) != 0u)), ((((_e5141 - _e5130) - select(0u, 1u, (_e5142 < _e5131))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e5178 {
                                        case 0: {
                                            phi_7681_ = array<type_9, 2>(type_9(_e4852, _e4848), type_9(_e4873, _e4869));
                                            break;
                                        }
                                        case 1: {
                                            phi_7681_ = array<type_9, 2>(type_9(_e4873, _e4869), type_9(_e4831, _e4827));
                                            break;
                                        }
                                        default: {
                                            phi_7681_ = array<type_9, 2>(type_9(_e4831, _e4827), type_9(_e4852, _e4848));
                                            break;
                                        }
                                    }
                                    let _e5189 = phi_7681_;
                                    switch _e5178 {
                                        case 0: {
                                            phi_7710_ = array<type_9, 2>(type_9(_e4917, _e4913), type_9(_e4938, _e4934));
                                            break;
                                        }
                                        case 1: {
                                            phi_7710_ = array<type_9, 2>(type_9(_e4938, _e4934), type_9(_e4896, _e4892));
                                            break;
                                        }
                                        default: {
                                            phi_7710_ = array<type_9, 2>(type_9(_e4896, _e4892), type_9(_e4917, _e4913));
                                            break;
                                        }
                                    }
                                    let _e5200 = phi_7710_;
                                    switch _e5178 {
                                        case 0: {
                                            phi_7739_ = array<type_9, 2>(type_9(_e4982, _e4978), type_9(_e5003, _e4999));
                                            break;
                                        }
                                        case 1: {
                                            phi_7739_ = array<type_9, 2>(type_9(_e5003, _e4999), type_9(_e4961, _e4957));
                                            break;
                                        }
                                        default: {
                                            phi_7739_ = array<type_9, 2>(type_9(_e4961, _e4957), type_9(_e4982, _e4978));
                                            break;
                                        }
                                    }
                                    let _e5211 = phi_7739_;
                                    switch _e5178 {
                                        case 0: {
                                            phi_7753_ = type_9(_e5041, _e5042);
                                            break;
                                        }
                                        case 1: {
                                            phi_7753_ = type_9(_e5080, _e5081);
                                            break;
                                        }
                                        default: {
                                            phi_7753_ = type_9(_e5119, _e5120);
                                            break;
                                        }
                                    }
                                    let _e5216 = phi_7753_;
                                    let _e5219 = local_6[1u].member;
                                    let _e5221 = local_6[1u].member_1;
                                    let _e5224 = local_6[2u].member;
                                    let _e5226 = local_6[2u].member_1;
                                    let _e5227 = (_e5221 + _e5226);
                                    let _e5231 = ((_e5219 + _e5224) + select(0u, 1u, (_e5227 < _e5221)));
                                    let _e5242 = ((_e5227 >> bitcast<u32>(1u)) | ((_e5231 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5243 = function_8(17u);
                                    let _e5246 = (_e5242 + _e5243.member_1);
                                    let _e5250 = ((bitcast<u32>((bitcast<i32>(_e5231) >> bitcast<u32>(1u))) + _e5243.member) + select(0u, 1u, (_e5246 < _e5242)));
                                    let _e5253 = local_6[0u].member;
                                    let _e5255 = local_6[0u].member_1;
                                    let _e5258 = local_6[2u].member;
                                    let _e5260 = local_6[2u].member_1;
                                    let _e5261 = (_e5255 + _e5260);
                                    let _e5265 = ((_e5253 + _e5258) + select(0u, 1u, (_e5261 < _e5255)));
                                    let _e5276 = ((_e5261 >> bitcast<u32>(1u)) | ((_e5265 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5277 = function_8(17u);
                                    let _e5280 = (_e5276 + _e5277.member_1);
                                    let _e5284 = ((bitcast<u32>((bitcast<i32>(_e5265) >> bitcast<u32>(1u))) + _e5277.member) + select(0u, 1u, (_e5280 < _e5276)));
                                    let _e5287 = local_6[0u].member;
                                    let _e5289 = local_6[0u].member_1;
                                    let _e5292 = local_6[1u].member;
                                    let _e5294 = local_6[1u].member_1;
                                    let _e5295 = (_e5289 + _e5294);
                                    let _e5299 = ((_e5287 + _e5292) + select(0u, 1u, (_e5295 < _e5289)));
                                    let _e5310 = ((_e5295 >> bitcast<u32>(1u)) | ((_e5299 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5311 = function_8(17u);
                                    let _e5314 = (_e5310 + _e5311.member_1);
                                    let _e5318 = ((bitcast<u32>((bitcast<i32>(_e5299) >> bitcast<u32>(1u))) + _e5311.member) + select(0u, 1u, (_e5314 < _e5310)));
                                    let _e5323 = ((_e5216.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e5250 - select(_e5216.member, (~(_e5216.member) + select(0u, 1u, (_e5216.member_1 == 0u))), _e5323)) - select(0u, 1u, (_e5246 < select(_e5216.member_1, (~(_e5216.member_1) + 1u), _e5323)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e5344 = ((_e5216.member >> bitcast<u32>(31i)) != 0u);
                                        let _e5354 = select(_e5216.member, (~(_e5216.member) + select(0u, 1u, (_e5216.member_1 == 0u))), _e5344);
                                        let _e5356 = select(_e5216.member_1, (~(_e5216.member_1) + 1u), _e5344);
                                        let _e5357 = function_6(_e5189, _e5211);
                                        let _e5367 = select(_e5357.member, (~(_e5357.member) + select(0u, 1u, (_e5357.member_1 == 0u))), _e5344);
                                        let _e5369 = select(_e5357.member_1, (~(_e5357.member_1) + 1u), _e5344);
                                        let _e5370 = function_6(_e5200, _e5189);
                                        let _e5380 = select(_e5370.member, (~(_e5370.member) + select(0u, 1u, (_e5370.member_1 == 0u))), _e5344);
                                        let _e5382 = select(_e5370.member_1, (~(_e5370.member_1) + 1u), _e5344);
                                        if (_e234.member != 0u) {
                                            let _e5414 = (_e5246 + _e5280);
                                            let _e5426 = (_e5246 + _e5314);
                                            phi_8075_ = type_9(((_e5250 + _e5318) + select(0u, 1u, (_e5426 < _e5246))), _e5426);
                                            phi_8076_ = type_9(((_e5354 - _e5380) - select(0u, 1u, (_e5356 < _e5382))), (_e5356 - _e5382));
                                            phi_8077_ = type_9(((_e5250 + _e5284) + select(0u, 1u, (_e5414 < _e5246))), _e5414);
                                            phi_8078_ = type_9(((_e5354 - _e5367) - select(0u, 1u, (_e5356 < _e5369))), (_e5356 - _e5369));
                                        } else {
                                            let _e5388 = (_e5356 - _e5369);
                                            let _e5392 = ((((_e5354 - _e5367) - select(0u, 1u, (_e5356 < _e5369))) - _e5380) - select(0u, 1u, (_e5388 < _e5382)));
                                            let _e5393 = (_e5388 - _e5382);
                                            let _e5395 = (_e5246 + _e5280);
                                            let _e5400 = (_e5395 + _e5314);
                                            let _e5404 = ((((_e5250 + _e5284) + select(0u, 1u, (_e5395 < _e5246))) + _e5318) + select(0u, 1u, (_e5400 < _e5395)));
                                            phi_8075_ = type_9(_e5404, _e5400);
                                            phi_8076_ = type_9(_e5392, _e5393);
                                            phi_8077_ = type_9(_e5404, _e5400);
                                            phi_8078_ = type_9(_e5392, _e5393);
                                        }
                                        let _e5433 = phi_8075_;
                                        let _e5435 = phi_8076_;
                                        let _e5437 = phi_8077_;
                                        let _e5439 = phi_8078_;
                                        let _e5440 = function_4(_e5367, _e5369, _e5284, _e5280);
                                        if _e5440 {
                                            phi_8204_ = u32();
                                            phi_8205_ = true;
                                        } else {
                                            let _e5441 = function_4(_e5380, _e5382, _e5318, _e5314);
                                            if _e5441 {
                                                phi_8202_ = u32();
                                                phi_8203_ = true;
                                            } else {
                                                let _e5446 = function_4(_e5439.member, _e5439.member_1, _e5437.member, _e5437.member_1);
                                                if _e5446 {
                                                    phi_8200_ = u32();
                                                    phi_8201_ = true;
                                                } else {
                                                    let _e5451 = function_4(_e5435.member, _e5435.member_1, _e5433.member, _e5433.member_1);
                                                    if _e5451 {
                                                        phi_8199_ = u32();
                                                    } else {
                                                        let _e5452 = function_3(_e5367, _e5369, _e5284, _e5280);
                                                        if _e5452 {
                                                            let _e5453 = function_3(_e5380, _e5382, _e5318, _e5314);
                                                            if _e5453 {
                                                                let _e5458 = function_3(_e5439.member, _e5439.member_1, _e5437.member, _e5437.member_1);
                                                                if _e5458 {
                                                                    let _e5463 = function_3(_e5435.member, _e5435.member_1, _e5433.member, _e5433.member_1);
                                                                    phi_8192_ = select(true, false, _e5463);
                                                                } else {
                                                                    phi_8192_ = true;
                                                                }
                                                                let _e5466 = phi_8192_;
                                                                phi_8193_ = _e5466;
                                                            } else {
                                                                phi_8193_ = true;
                                                            }
                                                            let _e5468 = phi_8193_;
                                                            phi_8194_ = _e5468;
                                                        } else {
                                                            phi_8194_ = true;
                                                        }
                                                        let _e5470 = phi_8194_;
                                                        phi_8199_ = select(0u, 2u, _e5470);
                                                    }
                                                    let _e5473 = phi_8199_;
                                                    phi_8200_ = _e5473;
                                                    phi_8201_ = _e5451;
                                                }
                                                let _e5475 = phi_8200_;
                                                let _e5477 = phi_8201_;
                                                phi_8202_ = _e5475;
                                                phi_8203_ = _e5477;
                                            }
                                            let _e5479 = phi_8202_;
                                            let _e5481 = phi_8203_;
                                            phi_8204_ = _e5479;
                                            phi_8205_ = _e5481;
                                        }
                                        let _e5483 = phi_8204_;
                                        let _e5485 = phi_8205_;
                                        phi_8210_ = select(_e5483, 1u, _e5485);
                                    } else {
                                        phi_8210_ = 2u;
                                    }
                                    let _e5488 = phi_8210_;
                                    let _e5489 = (_e5488 == 1u);
                                    let _e5490 = (_e5488 == 0u);
                                    let _e5506 = local_87;
                                    if _e5506 {
                                        let _e6371 = local_109;
                                        phi_8282_ = _e6371;
                                        phi_8283_ = _e5489;
                                        phi_8284_ = select(true, false, _e5489);
                                        phi_8285_ = false;
                                        phi_8286_ = false;
                                    } else {
                                        let _e5510 = select(true, select(true, select(true, select(true, false, ((_e4422.member_1 - _e4422.member) <= _e1264)), select(false, (_e4422.member_1 <= _e1262), (_e4422.member >= _e1260))), _e4420), _e5490);
                                        let _e5512 = select(select(false, select((_e4422.member > _e1262), true, (_e4422.member_1 < _e1260)), _e4416), true, _e5489);
                                        let _e5513 = select(true, _e5512, select(((((select(0u, select(1u, 2u, ((_e3538[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3545.member - select(_e3558[0].member, (~(_e3538[0].member) + select(0u, 1u, (_e3542[0].member_1 == 0u))), _e3550)) - select(0u, 1u, (_e3545.member_1 < select(_e3558[0].member_1, (~(_e3542[0].member_1) + 1u), _e3550)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3577[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3584.member - select(_e3597[1].member, (~(_e3577[1].member) + select(0u, 1u, (_e3581[1].member_1 == 0u))), _e3589)) - select(0u, 1u, (_e3584.member_1 < select(_e3597[1].member_1, (~(_e3581[1].member_1) + 1u), _e3589)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3617[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3624.member - select(_e3637[2].member, (~(_e3617[2].member) + select(0u, 1u, (_e3621[2].member_1 == 0u))), _e3629)) - select(0u, 1u, (_e3624.member_1 < select(_e3637[2].member_1, (~(_e3621[2].member_1) + 1u), _e3629)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3657[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3664.member - select(_e3677[3].member, (~(_e3657[3].member) + select(0u, 1u, (_e3661[3].member_1 == 0u))), _e3669)) - select(0u, 1u, (_e3664.member_1 < select(_e3677[3].member_1, (~(_e3661[3].member_1) + 1u), _e3669)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e3698 == 31u), true, _e2782)));
                                        phi_8282_ = select(bool(), _e5512, _e5510);
                                        phi_8283_ = select(false, _e5513, _e5510);
                                        phi_8284_ = false;
                                        phi_8285_ = select(false, select(true, false, _e5513), _e5510);
                                        phi_8286_ = select(true, false, _e5510);
                                    }
                                    let _e5521 = phi_8282_;
                                    let _e5523 = phi_8283_;
                                    let _e5525 = phi_8284_;
                                    let _e5527 = phi_8285_;
                                    let _e5529 = phi_8286_;
                                    phi_8293_ = _e4416;
                                    phi_8294_ = _e4418;
                                    phi_8295_ = true;
                                    phi_8296_ = !(_e3790);
                                    phi_8297_ = _e4424;
                                    phi_8298_ = _e5521;
                                    phi_8299_ = _e5490;
                                    phi_8300_ = _e4422;
                                    phi_8301_ = _e5523;
                                    phi_8302_ = select(_e5525, false, _e5523);
                                    phi_8303_ = select(_e5527, false, _e5523);
                                    phi_8304_ = select(_e5529, false, _e5523);
                                }
                                let _e5534 = phi_8293_;
                                let _e5536 = phi_8294_;
                                let _e5538 = phi_8295_;
                                let _e5540 = phi_8296_;
                                let _e5542 = phi_8297_;
                                let _e5544 = phi_8298_;
                                let _e5546 = phi_8299_;
                                let _e5548 = phi_8300_;
                                let _e5550 = phi_8301_;
                                let _e5552 = phi_8302_;
                                let _e5554 = phi_8303_;
                                let _e5556 = phi_8304_;
                                phi_8305_ = _e5534;
                                phi_8306_ = _e5536;
                                phi_8307_ = _e5538;
                                phi_8308_ = _e5540;
                                phi_8309_ = _e5542;
                                phi_8310_ = _e5544;
                                phi_8311_ = _e5546;
                                phi_8312_ = _e5548;
                                phi_8313_ = _e5550;
                                phi_8314_ = _e5552;
                                phi_8315_ = _e5554;
                                phi_8316_ = _e5556;
                            } else {
                                phi_8305_ = _e2782;
                                phi_8306_ = _e2784;
                                let _e6398 = local_113;
                                phi_8307_ = _e6398;
                                let _e6401 = local_114;
                                phi_8308_ = _e6401;
                                phi_8309_ = _e2790;
                                let _e6405 = local_115;
                                phi_8310_ = _e6405;
                                phi_8311_ = bool();
                                phi_8312_ = type_18();
                                phi_8313_ = true;
                                phi_8314_ = false;
                                phi_8315_ = false;
                                phi_8316_ = false;
                            }
                            let _e5558 = phi_8305_;
                            let _e5560 = phi_8306_;
                            let _e5562 = phi_8307_;
                            let _e5564 = phi_8308_;
                            let _e5566 = phi_8309_;
                            let _e5568 = phi_8310_;
                            let _e5570 = phi_8311_;
                            let _e5572 = phi_8312_;
                            let _e5574 = phi_8313_;
                            let _e5576 = phi_8314_;
                            let _e5578 = phi_8315_;
                            let _e5580 = phi_8316_;
                            if _e5574 {
                                if _e5568 {
                                    let _e5584 = local_88;
                                    let _e5585 = (_e5584 + 1u);
                                    let _e5587 = local_89;
                                    let _e5589 = (_e5585 & (4294967295u - _e5587));
                                    let _e5595 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5589)), 32u, (_e5589 == 0u)));
                                    let _e5597 = local_90;
                                    let _e5600 = local_91;
                                    let _e5601 = select(_e5595, _e5600, (_e5597 < _e5595));
                                    let _e5604 = (_e5585 >> bitcast<u32>((_e5601 & 31u)));
                                    let _e5606 = local_92;
                                    let _e5607 = (_e5606 - _e5601);
                                    let _e5609 = local_93;
                                    let _e5610 = (_e5609 > _e1262);
                                    if _e5610 {
                                        phi_8367_ = u32();
                                        phi_8368_ = u32();
                                        phi_8369_ = false;
                                        phi_8370_ = false;
                                    } else {
                                        let _e5614 = select(true, select(true, false, (_e5607 == 0u)), (_e5604 == 1u));
                                        let _e5615 = (31u - _e5607);
                                        phi_8367_ = select(u32(), ((_e5604 + 1u) << bitcast<u32>((_e5615 & 31u))), _e5614);
                                        phi_8368_ = select(u32(), (_e5604 << bitcast<u32>((_e5615 & 31u))), _e5614);
                                        phi_8369_ = _e5614;
                                        phi_8370_ = select(true, false, _e5614);
                                    }
                                    let _e5627 = phi_8367_;
                                    let _e5629 = phi_8368_;
                                    let _e5631 = phi_8369_;
                                    let _e5633 = phi_8370_;
                                    phi_8371_ = _e5627;
                                    phi_8372_ = _e5629;
                                    phi_8373_ = false;
                                    phi_8374_ = false;
                                    phi_8375_ = false;
                                    phi_8376_ = false;
                                    phi_8377_ = _e5607;
                                    phi_8378_ = _e5604;
                                    phi_8379_ = _e5631;
                                    phi_8380_ = _e5610;
                                    phi_8381_ = _e5633;
                                } else {
                                    phi_8371_ = _e5566.member_1;
                                    phi_8372_ = _e5566.member;
                                    phi_8373_ = _e5558;
                                    phi_8374_ = _e5560;
                                    phi_8375_ = _e5562;
                                    phi_8376_ = _e5564;
                                    let _e6430 = local_116;
                                    phi_8377_ = _e6430;
                                    let _e6433 = local_117;
                                    phi_8378_ = _e6433;
                                    phi_8379_ = true;
                                    phi_8380_ = false;
                                    phi_8381_ = false;
                                }
                                let _e5635 = phi_8371_;
                                let _e5637 = phi_8372_;
                                let _e5639 = phi_8373_;
                                let _e5641 = phi_8374_;
                                let _e5643 = phi_8375_;
                                let _e5645 = phi_8376_;
                                let _e5647 = phi_8377_;
                                let _e5649 = phi_8378_;
                                let _e5651 = phi_8379_;
                                let _e5653 = phi_8380_;
                                let _e5655 = phi_8381_;
                                if _e5651 {
                                    if select(_e5639, true, _e5568) {
                                        let _e5662 = function_1(((_e2661 - _e2588.member) - select(0u, 1u, (_e2657 < _e2588.member_1))), (_e2657 - _e2588.member_1), _e5637);
                                        let _e5665 = (_e2588.member_1 + _e5662.member_1);
                                        let _e5675 = function_1(((_e2732 - _e2661) - select(0u, 1u, (_e2728 < _e2657))), (_e2728 - _e2657), _e5637);
                                        let _e5678 = (_e2657 + _e5675.member_1);
                                        let _e5688 = function_1(((_e2766.member - _e2732) - select(0u, 1u, (_e2766.member_1 < _e2728))), (_e2766.member_1 - _e2728), _e5637);
                                        let _e5691 = (_e2728 + _e5688.member_1);
                                        let _e5699 = array<type_9, 3>(type_9(((_e2588.member + _e5662.member) + select(0u, 1u, (_e5665 < _e2588.member_1))), _e5665), type_9(((_e2661 + _e5675.member) + select(0u, 1u, (_e5678 < _e2657))), _e5678), type_9(((_e2732 + _e5688.member) + select(0u, 1u, (_e5691 < _e2728))), _e5691));
                                        let _e5705 = function_1(((_e2661 - _e2588.member) - select(0u, 1u, (_e2657 < _e2588.member_1))), (_e2657 - _e2588.member_1), _e5635);
                                        let _e5708 = (_e2588.member_1 + _e5705.member_1);
                                        let _e5718 = function_1(((_e2732 - _e2661) - select(0u, 1u, (_e2728 < _e2657))), (_e2728 - _e2657), _e5635);
                                        let _e5721 = (_e2657 + _e5718.member_1);
                                        let _e5731 = function_1(((_e2766.member - _e2732) - select(0u, 1u, (_e2766.member_1 < _e2728))), (_e2766.member_1 - _e2728), _e5635);
                                        let _e5734 = (_e2728 + _e5731.member_1);
                                        let _e5743 = function_2(_e5699, _e5637);
                                        let _e5744 = function_2(_e5699, _e5635);
                                        let _e5745 = function_2(array<type_9, 3>(type_9(((_e2588.member + _e5705.member) + select(0u, 1u, (_e5708 < _e2588.member_1))), _e5708), type_9(((_e2661 + _e5718.member) + select(0u, 1u, (_e5721 < _e2657))), _e5721), type_9(((_e2732 + _e5731.member) + select(0u, 1u, (_e5734 < _e2728))), _e5734)), _e5635);
                                        let _e5759 = function_1(((_e5743[1].member - _e5743[0].member) - select(0u, 1u, (_e5743[1].member_1 < _e5743[0].member_1))), (_e5743[1].member_1 - _e5743[0].member_1), _e5637);
                                        let _e5762 = (_e5743[0].member_1 + _e5759.member_1);
                                        let _e5780 = function_1(((_e5743[1].member - _e5743[0].member) - select(0u, 1u, (_e5743[1].member_1 < _e5743[0].member_1))), (_e5743[1].member_1 - _e5743[0].member_1), _e5635);
                                        let _e5783 = (_e5743[0].member_1 + _e5780.member_1);
                                        let _e5801 = function_1(((_e5744[1].member - _e5744[0].member) - select(0u, 1u, (_e5744[1].member_1 < _e5744[0].member_1))), (_e5744[1].member_1 - _e5744[0].member_1), _e5635);
                                        let _e5804 = (_e5744[0].member_1 + _e5801.member_1);
                                        let _e5822 = function_1(((_e5745[1].member - _e5745[0].member) - select(0u, 1u, (_e5745[1].member_1 < _e5745[0].member_1))), (_e5745[1].member_1 - _e5745[0].member_1), _e5635);
                                        let _e5825 = (_e5745[0].member_1 + _e5822.member_1);
                                        phi_8648_ = array<type_9, 4>(type_9(((_e5743[0].member + _e5759.member) + select(0u, 1u, (_e5762 < _e5743[0].member_1))), _e5762), type_9(((_e5743[0].member + _e5780.member) + select(0u, 1u, (_e5783 < _e5743[0].member_1))), _e5783), type_9(((_e5744[0].member + _e5801.member) + select(0u, 1u, (_e5804 < _e5744[0].member_1))), _e5804), type_9(((_e5745[0].member + _e5822.member) + select(0u, 1u, (_e5825 < _e5745[0].member_1))), _e5825));
                                    } else {
                                        let _e6439 = local_118;
                                        phi_8648_ = _e6439;
                                    }
                                    let _e5836 = phi_8648_;
                                    phi_8649_ = _e5836;
                                    phi_8650_ = false;
                                    phi_8651_ = false;
                                } else {
                                    phi_8649_ = array<type_9, 4>();
                                    phi_8650_ = _e5653;
                                    phi_8651_ = _e5655;
                                }
                                let _e5838 = phi_8649_;
                                let _e5840 = phi_8650_;
                                let _e5842 = phi_8651_;
                                phi_8652_ = _e5838;
                                phi_8653_ = _e5639;
                                phi_8654_ = _e5641;
                                phi_8655_ = _e5643;
                                phi_8656_ = _e5645;
                                phi_8657_ = _e5647;
                                phi_8658_ = _e5649;
                                phi_8659_ = _e5651;
                                phi_8660_ = _e5840;
                                phi_8661_ = _e5842;
                                phi_8662_ = false;
                                phi_8663_ = false;
                                phi_8664_ = false;
                            } else {
                                phi_8652_ = array<type_9, 4>();
                                phi_8653_ = bool();
                                phi_8654_ = bool();
                                phi_8655_ = bool();
                                phi_8656_ = bool();
                                phi_8657_ = u32();
                                phi_8658_ = u32();
                                phi_8659_ = false;
                                phi_8660_ = false;
                                phi_8661_ = false;
                                phi_8662_ = _e5576;
                                phi_8663_ = _e5578;
                                phi_8664_ = _e5580;
                            }
                            let _e5844 = phi_8652_;
                            let _e5846 = phi_8653_;
                            let _e5848 = phi_8654_;
                            let _e5850 = phi_8655_;
                            let _e5852 = phi_8656_;
                            let _e5854 = phi_8657_;
                            let _e5856 = phi_8658_;
                            let _e5858 = phi_8659_;
                            let _e5860 = phi_8660_;
                            let _e5862 = phi_8661_;
                            let _e5864 = phi_8662_;
                            let _e5866 = phi_8663_;
                            let _e5868 = phi_8664_;
                            phi_4474_ = _e5844;
                            phi_4477_ = _e5846;
                            phi_4479_ = _e5848;
                            phi_4481_ = _e5850;
                            phi_4483_ = _e5852;
                            phi_4485_ = _e5566;
                            let _e6464 = local_119;
                            phi_4489_ = _e6464;
                            let _e6467 = local_120;
                            phi_4491_ = _e6467;
                            let _e6470 = local_121;
                            phi_4493_ = _e6470;
                            phi_4495_ = _e5854;
                            phi_4497_ = _e5856;
                            phi_8665_ = _e5570;
                            phi_8666_ = _e5572;
                            phi_8667_ = _e5858;
                            phi_8668_ = false;
                            phi_8669_ = _e5860;
                            phi_8670_ = _e5862;
                            phi_8671_ = _e5864;
                            phi_8672_ = _e5866;
                            phi_8673_ = _e5868;
                        } else {
                            phi_4474_ = array<type_9, 4>();
                            phi_4477_ = bool();
                            phi_4479_ = bool();
                            phi_4481_ = bool();
                            phi_4483_ = bool();
                            phi_4485_ = type_18();
                            phi_4489_ = u32();
                            phi_4491_ = u32();
                            phi_4493_ = u32();
                            phi_4495_ = u32();
                            phi_4497_ = u32();
                            phi_8665_ = bool();
                            phi_8666_ = type_18();
                            phi_8667_ = false;
                            phi_8668_ = true;
                            phi_8669_ = false;
                            phi_8670_ = false;
                            phi_8671_ = false;
                            phi_8672_ = false;
                            phi_8673_ = false;
                        }
                        let _e5870 = phi_4474_;
                        let _e5872 = phi_4477_;
                        let _e5874 = phi_4479_;
                        let _e5876 = phi_4481_;
                        let _e5878 = phi_4483_;
                        let _e5880 = phi_4485_;
                        let _e5882 = phi_4489_;
                        let _e5884 = phi_4491_;
                        let _e5886 = phi_4493_;
                        let _e5888 = phi_4495_;
                        let _e5890 = phi_4497_;
                        let _e5892 = phi_8665_;
                        let _e5894 = phi_8666_;
                        let _e5896 = phi_8667_;
                        let _e5898 = phi_8668_;
                        let _e5900 = phi_8669_;
                        let _e5902 = phi_8670_;
                        let _e5904 = phi_8671_;
                        let _e5906 = phi_8672_;
                        let _e5908 = phi_8673_;
                        local_94 = _e5898;
                        local_95 = _e5898;
                        local_96 = _e5898;
                        local_97 = _e5900;
                        local_98 = _e5898;
                        local_99 = _e5902;
                        local_100 = _e5898;
                        local_101 = _e5904;
                        local_102 = _e5898;
                        local_103 = _e5906;
                        local_104 = _e5898;
                        local_105 = _e5908;
                        local_106 = _e5892;
                        local_107 = _e5892;
                        local_108 = _e5894;
                        continue;
                        continuing {
                            phi_4473_ = _e5870;
                            phi_4476_ = _e5872;
                            phi_4478_ = _e5874;
                            phi_4480_ = _e5876;
                            phi_4482_ = _e5878;
                            phi_4484_ = _e5880;
                            phi_4488_ = _e5882;
                            phi_4490_ = _e5884;
                            phi_4492_ = _e5886;
                            phi_4494_ = _e5888;
                            phi_4496_ = _e5890;
                            break if !(_e5896);
                        }
                    }
                    let _e5912 = local_94;
                    let _e5917 = local_95;
                    let _e5920 = local_96;
                    let _e5922 = local_97;
                    let _e5923 = select(_e5922, false, _e5920);
                    let _e5925 = local_98;
                    let _e5927 = local_99;
                    let _e5930 = local_100;
                    let _e5932 = local_101;
                    let _e5935 = local_102;
                    let _e5937 = local_103;
                    let _e5940 = local_104;
                    let _e5942 = local_105;
                    let _e5944 = select(select(_e5927, false, _e5925), false, _e5923);
                    let _e5948 = select(_e5923, true, _e5944);
                    let _e5957 = select(select(select(select(_e5932, false, _e5930), false, _e5923), false, _e5944), false, _e5948);
                    if _e5957 {
                        let _e5961 = local_106;
                        let _e5966 = local_107;
                        phi_8715_ = type_9(select(2u, 3u, _e5961), select(type_9().member_1, type_9().member_1, _e5966));
                        phi_8716_ = false;
                        phi_8717_ = false;
                        phi_8718_ = false;
                    } else {
                        phi_8715_ = type_9();
                        phi_8716_ = select(select(select(select(_e5937, false, _e5935), false, _e5923), false, _e5944), false, _e5948);
                        phi_8717_ = select(select(select(select(_e5942, false, _e5940), false, _e5923), false, _e5944), false, _e5948);
                        phi_8718_ = _e5948;
                    }
                    let _e5970 = phi_8715_;
                    let _e5972 = phi_8716_;
                    let _e5974 = phi_8717_;
                    let _e5976 = phi_8718_;
                    let _e5982 = select(_e5974, false, _e5972);
                    let _e5986 = local_108;
                    let _e5990 = select(_e5972, true, _e5982);
                    let _e5997 = select(select(select(_e5957, false, _e5972), false, _e5982), true, _e5990);
                    let _e6001 = select(select(select(select(_e5976, false, _e5972), false, _e5982), false, _e5990), true, _e5997);
                    phi_8754_ = type_9(select(select(type_9().member, 2u, _e5912), select(select(type_9().member, 0u, _e5948), select(_e5970.member, select(select(type_9().member, 2u, _e5972), 1u, _e5982), _e5990), _e5997), _e6001), select(select(type_9().member_1, type_9().member_1, _e5917), select(select(type_9().member_1, type_9().member_1, _e5948), select(_e5970.member_1, select(select(type_9().member_1, type_9().member_1, _e5972), _e5986.member, _e5982), _e5990), _e5997), _e6001));
                }
                let _e6008 = phi_8754_;
                let _e6012 = params.member.member_2.member_1;
                switch bitcast<i32>(_e6008.member) {
                    case 0: {
                        phi_8791_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                        phi_8792_ = false;
                        break;
                    }
                    case 1: {
                        if (_e6008.member_1 == 0u) {
                            phi_8788_ = array<u32, 2>(0u, 0u);
                        } else {
                            let _e6021 = select((bitcast<u32>(31i) - firstLeadingBit(_e6008.member_1)), 32u, (_e6008.member_1 == 0u));
                            let _e6026 = ((_e6008.member_1 << bitcast<u32>((_e6021 & 31u))) << bitcast<u32>(1i));
                            phi_8788_ = array<u32, 2>((_e6026 << bitcast<u32>(20i)), (((1023u - _e6021) << bitcast<u32>(20i)) | (_e6026 >> bitcast<u32>(12i))));
                        }
                        let _e6037 = phi_8788_;
                        phi_8791_ = type_26(0u, select(0u, 1u, (_e6008.member_1 > _e6012)), _e6037, true);
                        phi_8792_ = false;
                        break;
                    }
                    case 2: {
                        phi_8791_ = type_26();
                        phi_8792_ = true;
                        break;
                    }
                    case 3: {
                        phi_8791_ = type_26();
                        phi_8792_ = true;
                        break;
                    }
                    default: {
                        phi_8791_ = type_26();
                        phi_8792_ = bool();
                        break;
                    }
                }
                let _e6040 = phi_8791_;
                let _e6042 = phi_8792_;
                if _e6042 {
                    phi_8796_ = type_26(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    phi_8796_ = _e6040;
                }
                let _e6044 = phi_8796_;
                let _e6047 = global.member;
                if (bitcast<i32>(_e6008.member) == bitcast<i32>(_e6047)) {
                    if (bitcast<i32>(_e6008.member) == 1i) {
                        let _e6053 = global.member;
                        if (bitcast<i32>(_e6053) == 1i) {
                            let _e6057 = global.member_1;
                            phi_8824_ = (_e6008.member_1 == _e6057);
                            phi_8825_ = false;
                        } else {
                            phi_8824_ = bool();
                            phi_8825_ = true;
                        }
                        let _e6060 = phi_8824_;
                        let _e6062 = phi_8825_;
                        phi_8826_ = _e6060;
                        phi_8827_ = _e6062;
                    } else {
                        phi_8826_ = bool();
                        phi_8827_ = true;
                    }
                    let _e6064 = phi_8826_;
                    let _e6066 = phi_8827_;
                    phi_8832_ = select(_e6064, true, _e6066);
                } else {
                    phi_8832_ = false;
                }
                let _e6069 = phi_8832_;
                phi_8843_ = _e6044;
                phi_8844_ = type_9(select(_e198, (_e198 | 2147483648u), _e6069), _e201);
            } else {
                phi_8843_ = type_26(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_8844_ = type_9(0u, 0u);
            }
            let _e6074 = phi_8843_;
            let _e6076 = phi_8844_;
            let _e6081 = (_e6074.member != 0u);
            let _e6084 = select(false, !(_e6081), _e6074.member_3);
            if _e6084 {
                let _e6088 = (_e6074.member_2[1] >> bitcast<u32>(20i));
                if (_e6088 <= 896u) {
                    phi_8875_ = 0u;
                } else {
                    phi_8875_ = ((((_e6088 - 896u) << bitcast<u32>(23i)) | ((_e6074.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e6074.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e6103 = phi_8875_;
                let _e6105 = atomicMin((&earliest.member[0u]), _e6103);
            }
            let _e6108 = params.member.member.member_1;
            if ((_e6108 & 16u) != 0u) {
                if (_e114 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e6084 {
                    let _e6114 = atomicAdd((&counters[0u]), 1u);
                    phi_8897_ = _e6114;
                } else {
                    phi_8897_ = 0u;
                }
                let _e6116 = phi_8897_;
                workgroupBarrier();
                if (_e114 == 0u) {
                    let _e6119 = atomicLoad((&counters[0u]));
                    if (_e6119 > 0u) {
                        let _e6122 = atomicAdd((&contacts.member[0u]), _e6119);
                        atomicStore((&counters[1u]), _e6122);
                    }
                }
                workgroupBarrier();
                let _e6125 = atomicLoad((&counters[1u]));
                let _e6126 = (_e6125 + _e6116);
                if _e6084 {
                    let _e6129 = params.member.member_1.member_3;
                    let _e6131 = params.member.member_2.member.member;
                    if (_e6126 < _e6129) {
                        let _e6133 = (7u * _e6126);
                        atomicStore((&contacts.member[(4u + _e6133)]), _e6131);
                        atomicStore((&contacts.member[(_e6133 + 5u)]), _e6074.member);
                        atomicStore((&contacts.member[(_e6133 + 6u)]), _e6076.member);
                        atomicStore((&contacts.member[(_e6133 + 7u)]), _e6076.member_1);
                        atomicStore((&contacts.member[(_e6133 + 8u)]), _e6074.member_2[0]);
                        atomicStore((&contacts.member[(_e6133 + 9u)]), _e6074.member_2[1]);
                        atomicStore((&contacts.member[(_e6133 + 10u)]), _e6074.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e114 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6081 {
                let _e6157 = atomicAdd((&counters[0u]), 1u);
                phi_8963_ = _e6157;
            } else {
                phi_8963_ = 0u;
            }
            let _e6159 = phi_8963_;
            workgroupBarrier();
            if (_e114 == 0u) {
                let _e6162 = atomicLoad((&counters[0u]));
                if (_e6162 > 0u) {
                    let _e6165 = atomicAdd((&left.member[0u]), _e6162);
                    atomicStore((&counters[1u]), _e6165);
                }
            }
            workgroupBarrier();
            let _e6168 = atomicLoad((&counters[1u]));
            let _e6169 = (_e6168 + _e6159);
            if _e6081 {
                let _e6171 = params.member.member_2.member.member_1;
                if (_e6169 < _e6171) {
                    let _e6173 = (2u * _e6169);
                    atomicStore((&left.member[(4u + _e6173)]), _e6076.member);
                    atomicStore((&left.member[(_e6173 + 5u)]), _e6076.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_348_ = type_9(select(_e169.member, (_e169.member + 1u), _e172), select(_e169.member_1, _e169.member_1, _e172));
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
