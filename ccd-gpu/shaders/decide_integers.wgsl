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

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_29 {
    member: type_19,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_30 {
    member: type_7,
    member_1: type_8,
    member_2: type_29,
}

struct type_31 {
    member: type_30,
}

struct type_40 {
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
var<storage, read_write> contacts: type_40;
@group(0) @binding(6) 
var<storage, read_write> left: type_40;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_40;
@group(0) @binding(0) 
var<storage> params: type_31;
@group(0) @binding(2) 
var<storage> positions: type_11;
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
    var phi_9173_: type_9;
    var phi_9174_: type_9;
    var phi_9175_: type_9;
    var phi_9176_: type_9;
    var phi_9177_: type_9;
    var phi_9178_: bool;

    let _e24 = ((param_27[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_27[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_28);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_9177_ = type_9();
        phi_9178_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_9176_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_9175_ = type_9((param_27[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_9174_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_27[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_27[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_9173_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_27[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_9173_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_9173_;
                    phi_9174_ = _e67;
                }
                let _e83 = phi_9174_;
                phi_9175_ = _e83;
            }
            let _e89 = phi_9175_;
            phi_9176_ = _e89;
        }
        let _e91 = phi_9176_;
        phi_9177_ = _e91;
        phi_9178_ = _e37;
    }
    let _e93 = phi_9177_;
    let _e95 = phi_9178_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_27[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_11(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
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
    var local_31: array<type_9, 3>;
    var local_32: array<u32, 4>;
    var local_33: array<array<f32, 3>, 4>;
    var local_34: array<array<f32, 3>, 4>;
    var local_35: type_27;
    var phi_314_: u32;
    var phi_360_: u32;
    var phi_363_: type_9;
    var phi_538_: type_20;
    var phi_952_: type_26;
    var phi_2655_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3202_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_4506_: array<type_9, 4>;
    var phi_4509_: bool;
    var phi_4511_: bool;
    var phi_4513_: bool;
    var phi_4515_: bool;
    var phi_4517_: type_17;
    var phi_4521_: u32;
    var phi_4523_: u32;
    var phi_4525_: u32;
    var phi_4527_: u32;
    var phi_4529_: u32;
    var phi_4538_: array<type_9, 4>;
    var phi_4541_: bool;
    var phi_4543_: bool;
    var phi_4547_: bool;
    var phi_4549_: bool;
    var phi_4551_: bool;
    var phi_4553_: bool;
    var phi_4555_: u32;
    var phi_4557_: u32;
    var phi_4559_: u32;
    var phi_4561_: u32;
    var phi_4563_: u32;
    var phi_4768_: bool;
    var phi_4769_: bool;
    var phi_4770_: bool;
    var phi_5412_: array<type_9, 4>;
    var phi_5413_: bool;
    var phi_5414_: u32;
    var phi_5415_: array<type_9, 4>;
    var phi_5416_: bool;
    var phi_5417_: bool;
    var phi_5419_: u32;
    var phi_5420_: u32;
    var phi_5421_: array<type_9, 4>;
    var phi_5422_: bool;
    var phi_5423_: bool;
    var phi_5425_: u32;
    var phi_5426_: u32;
    var phi_5427_: array<type_9, 4>;
    var phi_5428_: bool;
    var phi_5429_: bool;
    var phi_5431_: bool;
    var phi_5432_: bool;
    var phi_5433_: bool;
    var phi_5434_: bool;
    var phi_5435_: u32;
    var phi_5436_: u32;
    var phi_5437_: u32;
    var phi_5438_: u32;
    var phi_5439_: u32;
    var phi_5440_: bool;
    var phi_5441_: array<type_9, 4>;
    var phi_5442_: bool;
    var phi_5443_: bool;
    var phi_5445_: bool;
    var phi_5446_: bool;
    var phi_5447_: bool;
    var phi_5448_: bool;
    var phi_5449_: u32;
    var phi_5450_: u32;
    var phi_5451_: u32;
    var phi_5452_: u32;
    var phi_5453_: u32;
    var phi_5454_: bool;
    var phi_4539_: array<type_9, 4>;
    var phi_4542_: bool;
    var phi_4544_: bool;
    var phi_4548_: bool;
    var phi_4550_: bool;
    var phi_4552_: bool;
    var phi_4554_: bool;
    var phi_4556_: u32;
    var phi_4558_: u32;
    var phi_4560_: u32;
    var phi_4562_: u32;
    var phi_4564_: u32;
    var phi_5455_: bool;
    var local_36: bool;
    var local_37: bool;
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
    var local_48: array<type_9, 4>;
    var local_49: array<type_9, 4>;
    var local_50: u32;
    var local_51: u32;
    var local_52: u32;
    var local_53: u32;
    var local_54: array<type_9, 4>;
    var local_55: array<type_9, 4>;
    var local_56: array<type_9, 4>;
    var local_57: array<type_9, 4>;
    var local_58: array<type_9, 4>;
    var local_59: array<type_9, 4>;
    var local_60: bool;
    var local_61: bool;
    var local_62: u32;
    var local_63: bool;
    var local_64: u32;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var local_68: u32;
    var local_69: u32;
    var local_70: array<type_9, 4>;
    var local_71: array<type_9, 4>;
    var local_72: array<type_9, 4>;
    var phi_6039_: bool;
    var phi_6040_: bool;
    var phi_6041_: type_17;
    var phi_6042_: bool;
    var phi_6043_: type_17;
    var phi_6044_: bool;
    var phi_6045_: type_17;
    var phi_6046_: bool;
    var phi_6047_: type_17;
    var phi_6048_: bool;
    var phi_6049_: bool;
    var phi_6050_: type_17;
    var phi_6051_: bool;
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
    var phi_6092_: type_14;
    var phi_6095_: f32;
    var phi_6097_: f32;
    var phi_6099_: f32;
    var phi_6093_: type_14;
    var phi_6140_: type_15;
    var phi_6096_: f32;
    var phi_6098_: f32;
    var phi_6100_: f32;
    var local_83: f32;
    var local_84: u32;
    var local_85: u32;
    var local_86: u32;
    var phi_6558_: bool;
    var phi_6559_: bool;
    var phi_6560_: bool;
    var phi_6561_: type_17;
    var phi_6562_: type_17;
    var local_87: u32;
    var local_88: u32;
    var phi_6563_: bool;
    var phi_6564_: bool;
    var phi_6565_: bool;
    var phi_6566_: type_17;
    var phi_6567_: type_17;
    var phi_7714_: array<type_9, 2>;
    var phi_7743_: array<type_9, 2>;
    var phi_7772_: array<type_9, 2>;
    var phi_7786_: type_9;
    var phi_8108_: type_9;
    var phi_8109_: type_9;
    var phi_8110_: type_9;
    var phi_8111_: type_9;
    var phi_8225_: bool;
    var phi_8226_: bool;
    var phi_8227_: bool;
    var phi_8232_: u32;
    var phi_8233_: u32;
    var phi_8234_: bool;
    var phi_8235_: u32;
    var phi_8236_: bool;
    var phi_8237_: u32;
    var phi_8238_: bool;
    var phi_8243_: u32;
    var local_89: bool;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: bool;
    var phi_8319_: bool;
    var phi_8326_: bool;
    var phi_8327_: bool;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var phi_8330_: type_17;
    var phi_8331_: bool;
    var phi_8332_: bool;
    var phi_8333_: type_17;
    var phi_8334_: bool;
    var phi_8335_: bool;
    var phi_8336_: bool;
    var phi_8337_: bool;
    var phi_8338_: bool;
    var phi_8339_: bool;
    var phi_8340_: bool;
    var phi_8341_: bool;
    var phi_8342_: type_17;
    var phi_8343_: bool;
    var phi_8344_: bool;
    var phi_8345_: type_17;
    var phi_8346_: bool;
    var phi_8347_: bool;
    var phi_8348_: bool;
    var phi_8349_: bool;
    var local_90: u32;
    var local_91: u32;
    var local_92: u32;
    var local_93: u32;
    var local_94: u32;
    var local_95: u32;
    var phi_8400_: u32;
    var phi_8401_: u32;
    var phi_8402_: bool;
    var phi_8403_: bool;
    var phi_8404_: u32;
    var phi_8405_: u32;
    var phi_8406_: bool;
    var phi_8407_: bool;
    var phi_8408_: bool;
    var phi_8409_: bool;
    var phi_8410_: u32;
    var phi_8411_: u32;
    var phi_8412_: bool;
    var phi_8413_: bool;
    var phi_8414_: bool;
    var phi_8681_: array<type_9, 4>;
    var phi_8682_: array<type_9, 4>;
    var phi_8683_: bool;
    var phi_8684_: bool;
    var phi_8685_: array<type_9, 4>;
    var phi_8686_: bool;
    var phi_8687_: bool;
    var phi_8688_: bool;
    var phi_8689_: bool;
    var phi_8690_: u32;
    var phi_8691_: u32;
    var phi_8692_: bool;
    var phi_8693_: bool;
    var phi_8694_: bool;
    var phi_8695_: bool;
    var phi_8696_: bool;
    var phi_8697_: bool;
    var phi_4507_: array<type_9, 4>;
    var phi_4510_: bool;
    var phi_4512_: bool;
    var phi_4514_: bool;
    var phi_4516_: bool;
    var phi_4518_: type_17;
    var phi_4522_: u32;
    var phi_4524_: u32;
    var phi_4526_: u32;
    var phi_4528_: u32;
    var phi_4530_: u32;
    var phi_8698_: bool;
    var phi_8699_: type_17;
    var phi_8700_: bool;
    var phi_8701_: bool;
    var phi_8702_: bool;
    var phi_8703_: bool;
    var phi_8704_: bool;
    var phi_8705_: bool;
    var phi_8706_: bool;
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
    var local_108: bool;
    var local_109: bool;
    var phi_8748_: type_9;
    var phi_8749_: bool;
    var phi_8750_: bool;
    var phi_8751_: bool;
    var local_110: type_17;
    var phi_8787_: type_9;
    var phi_8791_: type_9;
    var phi_8792_: type_9;
    var phi_8826_: array<u32, 2>;
    var phi_8829_: type_27;
    var phi_8830_: bool;
    var phi_8834_: type_27;
    var phi_8874_: bool;
    var phi_8875_: bool;
    var phi_8876_: bool;
    var phi_8877_: bool;
    var phi_8882_: bool;
    var phi_8938_: bool;
    var phi_8939_: bool;
    var phi_8982_: u32;
    var phi_9064_: u32;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var local_116: bool;
    var local_117: bool;
    var local_118: u32;
    var local_119: u32;
    var local_120: array<type_9, 4>;
    var local_121: u32;
    var local_122: u32;
    var local_123: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e115 = id_2;
    let _e116 = n_2;
    let _e117 = lane_2;
    let _e130 = ((_e115.y * _e116.x) + _e115.x);
    let _e133 = (_e116.x * _e116.y);
    let _e136 = params.member.member_1.member_2;
    let _e138 = input.member[0u];
    let _e140 = select(_e138, _e136, (_e136 < _e138));
    let _e142 = params.member.member_1.member_1;
    if (_e140 > _e142) {
        let _e145 = params.member.member_1.member_1;
        phi_314_ = (_e140 - _e145);
    } else {
        phi_314_ = 0u;
    }
    let _e148 = phi_314_;
    let _e150 = params.member.member_1.member;
    let _e152 = select(_e148, _e150, (_e150 < _e148));
    let _e154 = (_e152 / 64u);
    let _e158 = select(_e154, (_e154 + 1u), ((_e152 % 64u) > 0u));
    if (_e158 > _e130) {
        let _e160 = (_e158 - _e130);
        if (_e133 == 0u) {
            return;
        }
        let _e162 = (_e160 / _e133);
        if (_e133 == 0u) {
            return;
        }
        phi_360_ = select(_e162, (_e162 + 1u), ((_e160 % _e133) > 0u));
    } else {
        phi_360_ = 0u;
    }
    let _e169 = phi_360_;
    phi_363_ = type_9(0u, _e169);
    loop {
        let _e172 = phi_363_;
        let _e175 = (_e172.member < _e172.member_1);
        let _e188 = (bitcast<i32>(select(0u, 1u, _e175)) != 0i);
        if _e188 {
            let _e192 = (((_e130 + (select(type_9().member_1, _e172.member, _e175) * _e133)) * 64u) + _e117);
            if (_e192 < _e152) {
                let _e197 = params.member.member_1.member_1;
                let _e199 = (2u * (_e197 + _e192));
                let _e202 = input.member[(4u + _e199)];
                let _e205 = input.member[(_e199 + 5u)];
                let _e210 = (_e205 & 2147483647u);
                if (select(1u, 0u, ((_e205 & 2147483648u) == 0u)) == 0u) {
                    let _e229 = params.member.member.member[1u];
                    let _e232 = ((2u * _e229) + (3u * _e210));
                    let _e234 = elements.member[_e232];
                    let _e237 = elements.member[(_e232 + 1u)];
                    let _e240 = elements.member[(_e232 + 2u)];
                    phi_538_ = type_20(0u, array<u32, 4>(_e202, _e234, _e237, _e240));
                } else {
                    let _e213 = (2u * _e202);
                    let _e215 = elements.member[_e213];
                    let _e218 = elements.member[(_e213 + 1u)];
                    let _e219 = (2u * _e210);
                    let _e221 = elements.member[_e219];
                    let _e224 = elements.member[(_e219 + 1u)];
                    phi_538_ = type_20(1u, array<u32, 4>(_e215, _e218, _e221, _e224));
                }
                let _e244 = phi_538_;
                local_32 = array<u32, 4>(_e244.member_1[0], _e244.member_1[1], _e244.member_1[2], _e244.member_1[3]);
                let _e253 = paths.member[_e244.member_1[0]];
                let _e267 = paths.member[_e244.member_1[1]];
                let _e281 = paths.member[_e244.member_1[2]];
                let _e295 = paths.member[_e244.member_1[3]];
                local_33 = array<array<f32, 3>, 4>(array<f32, 3>(_e253.member.x, _e253.member.y, _e253.member.z), array<f32, 3>(_e267.member.x, _e267.member.y, _e267.member.z), array<f32, 3>(_e281.member.x, _e281.member.y, _e281.member.z), array<f32, 3>(_e295.member.x, _e295.member.y, _e295.member.z));
                local_34 = array<array<f32, 3>, 4>(array<f32, 3>(_e253.member_1.x, _e253.member_1.y, _e253.member_1.z), array<f32, 3>(_e267.member_1.x, _e267.member_1.y, _e267.member_1.z), array<f32, 3>(_e281.member_1.x, _e281.member_1.y, _e281.member_1.z), array<f32, 3>(_e295.member_1.x, _e295.member_1.y, _e295.member_1.z));
                let _e319 = params.member.member.member_4;
                if (_e244.member != 0u) {
                    let _e410 = local_33;
                    let _e415 = local_33;
                    let _e424 = local_34;
                    let _e429 = local_34;
                    let _e439 = local_33;
                    let _e444 = local_33;
                    let _e453 = local_34;
                    let _e458 = local_34;
                    let _e468 = local_33;
                    let _e473 = local_33;
                    let _e482 = local_34;
                    let _e487 = local_34;
                    phi_952_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e410[2][0] - _e415[0][0]), (_e410[2][1] - _e415[0][1]), (_e410[2][2] - _e415[0][2])), array<f32, 3>((_e424[2][0] - _e429[0][0]), (_e424[2][1] - _e429[0][1]), (_e424[2][2] - _e429[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e439[1][0] - _e444[0][0]), (_e439[1][1] - _e444[0][1]), (_e439[1][2] - _e444[0][2])), array<f32, 3>((_e453[1][0] - _e458[0][0]), (_e453[1][1] - _e458[0][1]), (_e453[1][2] - _e458[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e468[2][0] - _e473[3][0]), (_e468[2][1] - _e473[3][1]), (_e468[2][2] - _e473[3][2])), array<f32, 3>((_e482[2][0] - _e487[3][0]), (_e482[2][1] - _e487[3][1]), (_e482[2][2] - _e487[3][2]))), (_e319 + _e319));
                } else {
                    let _e321 = local_33;
                    let _e326 = local_33;
                    let _e335 = local_34;
                    let _e340 = local_34;
                    let _e350 = local_33;
                    let _e355 = local_33;
                    let _e364 = local_34;
                    let _e369 = local_34;
                    let _e379 = local_33;
                    let _e384 = local_33;
                    let _e393 = local_34;
                    let _e398 = local_34;
                    phi_952_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e321[0][0] - _e326[1][0]), (_e321[0][1] - _e326[1][1]), (_e321[0][2] - _e326[1][2])), array<f32, 3>((_e335[0][0] - _e340[1][0]), (_e335[0][1] - _e340[1][1]), (_e335[0][2] - _e340[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e350[2][0] - _e355[1][0]), (_e350[2][1] - _e355[1][1]), (_e350[2][2] - _e355[1][2])), array<f32, 3>((_e364[2][0] - _e369[1][0]), (_e364[2][1] - _e369[1][1]), (_e364[2][2] - _e369[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e379[3][0] - _e384[1][0]), (_e379[3][1] - _e384[1][1]), (_e379[3][2] - _e384[1][2])), array<f32, 3>((_e393[3][0] - _e398[1][0]), (_e393[3][1] - _e398[1][1]), (_e393[3][2] - _e398[1][2]))), (_e319 + _e319));
                }
                let _e500 = phi_952_;
                let _e506 = select(_e500.member[0][0], -(_e500.member[0][0]), (_e500.member[0][0] < 0f));
                let _e510 = select(_e500.member[0][1], -(_e500.member[0][1]), (_e500.member[0][1] < 0f));
                let _e512 = select(_e510, _e506, (_e506 > _e510));
                let _e516 = select(_e500.member[0][2], -(_e500.member[0][2]), (_e500.member[0][2] < 0f));
                let _e518 = select(_e516, _e512, (_e512 > _e516));
                let _e524 = select(_e500.member[1][0], -(_e500.member[1][0]), (_e500.member[1][0] < 0f));
                let _e528 = select(_e500.member[1][1], -(_e500.member[1][1]), (_e500.member[1][1] < 0f));
                let _e530 = select(_e528, _e524, (_e524 > _e528));
                let _e534 = select(_e500.member[1][2], -(_e500.member[1][2]), (_e500.member[1][2] < 0f));
                let _e536 = select(_e534, _e530, (_e530 > _e534));
                let _e546 = select(_e500.member_1[0][0], -(_e500.member_1[0][0]), (_e500.member_1[0][0] < 0f));
                let _e550 = select(_e500.member_1[0][1], -(_e500.member_1[0][1]), (_e500.member_1[0][1] < 0f));
                let _e552 = select(_e550, _e546, (_e546 > _e550));
                let _e556 = select(_e500.member_1[0][2], -(_e500.member_1[0][2]), (_e500.member_1[0][2] < 0f));
                let _e558 = select(_e556, _e552, (_e552 > _e556));
                let _e564 = select(_e500.member_1[1][0], -(_e500.member_1[1][0]), (_e500.member_1[1][0] < 0f));
                let _e568 = select(_e500.member_1[1][1], -(_e500.member_1[1][1]), (_e500.member_1[1][1] < 0f));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e574 = select(_e500.member_1[1][2], -(_e500.member_1[1][2]), (_e500.member_1[1][2] < 0f));
                let _e576 = select(_e574, _e570, (_e570 > _e574));
                let _e586 = select(_e500.member_2[0][0], -(_e500.member_2[0][0]), (_e500.member_2[0][0] < 0f));
                let _e590 = select(_e500.member_2[0][1], -(_e500.member_2[0][1]), (_e500.member_2[0][1] < 0f));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e596 = select(_e500.member_2[0][2], -(_e500.member_2[0][2]), (_e500.member_2[0][2] < 0f));
                let _e598 = select(_e596, _e592, (_e592 > _e596));
                let _e604 = select(_e500.member_2[1][0], -(_e500.member_2[1][0]), (_e500.member_2[1][0] < 0f));
                let _e608 = select(_e500.member_2[1][1], -(_e500.member_2[1][1]), (_e500.member_2[1][1] < 0f));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e614 = select(_e500.member_2[1][2], -(_e500.member_2[1][2]), (_e500.member_2[1][2] < 0f));
                let _e616 = select(_e614, _e610, (_e610 > _e614));
                let _e621 = function_((select(_e536, _e518, (_e518 > _e536)) + _e500.member_3), (select(_e576, _e558, (_e558 > _e576)) + _e500.member_3));
                let _e622 = function_(_e621, (select(_e616, _e598, (_e598 > _e616)) + _e500.member_3));
                let _e627 = bitcast<i32>(((bitcast<u32>(_e622) + 4u) >> bitcast<u32>(23i)));
                let _e628 = (_e627 >= 64i);
                let _e629 = (_e627 <= 190i);
                let _e635 = select(select(i32(), select(i32(), (_e627 - 126i), _e629), _e628), 2147483647i, select(true, select(true, false, _e629), _e628));
                if (_e635 == 2147483647i) {
                    phi_8787_ = type_9(2u, type_9().member_1);
                } else {
                    let _e638 = params.member.member.member_1;
                    if ((_e638 & 8u) != 0u) {
                        let _e878 = local_33;
                        let _e883 = bitcast<u32>(_e878[0][0]);
                        let _e884 = (_e883 & 2147483647u);
                        let _e885 = (_e884 < 8388608u);
                        let _e896 = function_10(array<u32, 2>(select((_e883 << bitcast<u32>(29i)), 0u, _e885), select(((_e883 ^ _e884) | ((_e884 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e885)), _e635);
                        let _e897 = bitcast<u32>(_e878[0][1]);
                        let _e898 = (_e897 & 2147483647u);
                        let _e899 = (_e898 < 8388608u);
                        let _e910 = function_10(array<u32, 2>(select((_e897 << bitcast<u32>(29i)), 0u, _e899), select(((_e897 ^ _e898) | ((_e898 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e899)), _e635);
                        let _e911 = bitcast<u32>(_e878[0][2]);
                        let _e912 = (_e911 & 2147483647u);
                        let _e913 = (_e912 < 8388608u);
                        let _e924 = function_10(array<u32, 2>(select((_e911 << bitcast<u32>(29i)), 0u, _e913), select(((_e911 ^ _e912) | ((_e912 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e913)), _e635);
                        let _e926 = local_34;
                        let _e931 = bitcast<u32>(_e926[0][0]);
                        let _e932 = (_e931 & 2147483647u);
                        let _e933 = (_e932 < 8388608u);
                        let _e944 = function_10(array<u32, 2>(select((_e931 << bitcast<u32>(29i)), 0u, _e933), select(((_e931 ^ _e932) | ((_e932 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e933)), _e635);
                        let _e945 = bitcast<u32>(_e926[0][1]);
                        let _e946 = (_e945 & 2147483647u);
                        let _e947 = (_e946 < 8388608u);
                        let _e958 = function_10(array<u32, 2>(select((_e945 << bitcast<u32>(29i)), 0u, _e947), select(((_e945 ^ _e946) | ((_e946 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e947)), _e635);
                        let _e959 = bitcast<u32>(_e926[0][2]);
                        let _e960 = (_e959 & 2147483647u);
                        let _e961 = (_e960 < 8388608u);
                        let _e972 = function_10(array<u32, 2>(select((_e959 << bitcast<u32>(29i)), 0u, _e961), select(((_e959 ^ _e960) | ((_e960 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e961)), _e635);
                        let _e975 = local_33;
                        let _e980 = bitcast<u32>(_e975[1][0]);
                        let _e981 = (_e980 & 2147483647u);
                        let _e982 = (_e981 < 8388608u);
                        let _e993 = function_10(array<u32, 2>(select((_e980 << bitcast<u32>(29i)), 0u, _e982), select(((_e980 ^ _e981) | ((_e981 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e982)), _e635);
                        let _e994 = bitcast<u32>(_e975[1][1]);
                        let _e995 = (_e994 & 2147483647u);
                        let _e996 = (_e995 < 8388608u);
                        let _e1007 = function_10(array<u32, 2>(select((_e994 << bitcast<u32>(29i)), 0u, _e996), select(((_e994 ^ _e995) | ((_e995 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e996)), _e635);
                        let _e1008 = bitcast<u32>(_e975[1][2]);
                        let _e1009 = (_e1008 & 2147483647u);
                        let _e1010 = (_e1009 < 8388608u);
                        let _e1021 = function_10(array<u32, 2>(select((_e1008 << bitcast<u32>(29i)), 0u, _e1010), select(((_e1008 ^ _e1009) | ((_e1009 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1010)), _e635);
                        let _e1023 = local_34;
                        let _e1028 = bitcast<u32>(_e1023[1][0]);
                        let _e1029 = (_e1028 & 2147483647u);
                        let _e1030 = (_e1029 < 8388608u);
                        let _e1041 = function_10(array<u32, 2>(select((_e1028 << bitcast<u32>(29i)), 0u, _e1030), select(((_e1028 ^ _e1029) | ((_e1029 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1030)), _e635);
                        let _e1042 = bitcast<u32>(_e1023[1][1]);
                        let _e1043 = (_e1042 & 2147483647u);
                        let _e1044 = (_e1043 < 8388608u);
                        let _e1055 = function_10(array<u32, 2>(select((_e1042 << bitcast<u32>(29i)), 0u, _e1044), select(((_e1042 ^ _e1043) | ((_e1043 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1044)), _e635);
                        let _e1056 = bitcast<u32>(_e1023[1][2]);
                        let _e1057 = (_e1056 & 2147483647u);
                        let _e1058 = (_e1057 < 8388608u);
                        let _e1069 = function_10(array<u32, 2>(select((_e1056 << bitcast<u32>(29i)), 0u, _e1058), select(((_e1056 ^ _e1057) | ((_e1057 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1058)), _e635);
                        let _e1072 = local_33;
                        let _e1077 = bitcast<u32>(_e1072[2][0]);
                        let _e1078 = (_e1077 & 2147483647u);
                        let _e1079 = (_e1078 < 8388608u);
                        let _e1090 = function_10(array<u32, 2>(select((_e1077 << bitcast<u32>(29i)), 0u, _e1079), select(((_e1077 ^ _e1078) | ((_e1078 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1079)), _e635);
                        let _e1091 = bitcast<u32>(_e1072[2][1]);
                        let _e1092 = (_e1091 & 2147483647u);
                        let _e1093 = (_e1092 < 8388608u);
                        let _e1104 = function_10(array<u32, 2>(select((_e1091 << bitcast<u32>(29i)), 0u, _e1093), select(((_e1091 ^ _e1092) | ((_e1092 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1093)), _e635);
                        let _e1105 = bitcast<u32>(_e1072[2][2]);
                        let _e1106 = (_e1105 & 2147483647u);
                        let _e1107 = (_e1106 < 8388608u);
                        let _e1118 = function_10(array<u32, 2>(select((_e1105 << bitcast<u32>(29i)), 0u, _e1107), select(((_e1105 ^ _e1106) | ((_e1106 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1107)), _e635);
                        let _e1120 = local_34;
                        let _e1125 = bitcast<u32>(_e1120[2][0]);
                        let _e1126 = (_e1125 & 2147483647u);
                        let _e1127 = (_e1126 < 8388608u);
                        let _e1138 = function_10(array<u32, 2>(select((_e1125 << bitcast<u32>(29i)), 0u, _e1127), select(((_e1125 ^ _e1126) | ((_e1126 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1127)), _e635);
                        let _e1139 = bitcast<u32>(_e1120[2][1]);
                        let _e1140 = (_e1139 & 2147483647u);
                        let _e1141 = (_e1140 < 8388608u);
                        let _e1152 = function_10(array<u32, 2>(select((_e1139 << bitcast<u32>(29i)), 0u, _e1141), select(((_e1139 ^ _e1140) | ((_e1140 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1141)), _e635);
                        let _e1153 = bitcast<u32>(_e1120[2][2]);
                        let _e1154 = (_e1153 & 2147483647u);
                        let _e1155 = (_e1154 < 8388608u);
                        let _e1166 = function_10(array<u32, 2>(select((_e1153 << bitcast<u32>(29i)), 0u, _e1155), select(((_e1153 ^ _e1154) | ((_e1154 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1155)), _e635);
                        let _e1169 = local_33;
                        let _e1174 = bitcast<u32>(_e1169[3][0]);
                        let _e1175 = (_e1174 & 2147483647u);
                        let _e1176 = (_e1175 < 8388608u);
                        let _e1187 = function_10(array<u32, 2>(select((_e1174 << bitcast<u32>(29i)), 0u, _e1176), select(((_e1174 ^ _e1175) | ((_e1175 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1176)), _e635);
                        let _e1188 = bitcast<u32>(_e1169[3][1]);
                        let _e1189 = (_e1188 & 2147483647u);
                        let _e1190 = (_e1189 < 8388608u);
                        let _e1201 = function_10(array<u32, 2>(select((_e1188 << bitcast<u32>(29i)), 0u, _e1190), select(((_e1188 ^ _e1189) | ((_e1189 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1190)), _e635);
                        let _e1202 = bitcast<u32>(_e1169[3][2]);
                        let _e1203 = (_e1202 & 2147483647u);
                        let _e1204 = (_e1203 < 8388608u);
                        let _e1215 = function_10(array<u32, 2>(select((_e1202 << bitcast<u32>(29i)), 0u, _e1204), select(((_e1202 ^ _e1203) | ((_e1203 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1204)), _e635);
                        let _e1217 = local_34;
                        let _e1222 = bitcast<u32>(_e1217[3][0]);
                        let _e1223 = (_e1222 & 2147483647u);
                        let _e1224 = (_e1223 < 8388608u);
                        let _e1235 = function_10(array<u32, 2>(select((_e1222 << bitcast<u32>(29i)), 0u, _e1224), select(((_e1222 ^ _e1223) | ((_e1223 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1224)), _e635);
                        let _e1236 = bitcast<u32>(_e1217[3][1]);
                        let _e1237 = (_e1236 & 2147483647u);
                        let _e1238 = (_e1237 < 8388608u);
                        let _e1249 = function_10(array<u32, 2>(select((_e1236 << bitcast<u32>(29i)), 0u, _e1238), select(((_e1236 ^ _e1237) | ((_e1237 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1238)), _e635);
                        let _e1250 = bitcast<u32>(_e1217[3][2]);
                        let _e1251 = (_e1250 & 2147483647u);
                        let _e1252 = (_e1251 < 8388608u);
                        let _e1263 = function_10(array<u32, 2>(select((_e1250 << bitcast<u32>(29i)), 0u, _e1252), select(((_e1250 ^ _e1251) | ((_e1251 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1252)), _e635);
                        phi_2655_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e896, _e910, _e924), array<type_9, 3>(_e944, _e958, _e972)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e993, _e1007, _e1021), array<type_9, 3>(_e1041, _e1055, _e1069)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1090, _e1104, _e1118), array<type_9, 3>(_e1138, _e1152, _e1166)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1187, _e1201, _e1215), array<type_9, 3>(_e1235, _e1249, _e1263)));
                    } else {
                        let _e643 = params.member.member.member_10[1u];
                        let _e648 = (_e635 - (bitcast<i32>((_e643 >> bitcast<u32>(20i))) - 1023i));
                        let _e649 = local_32;
                        let _e653 = params.member.member.member[0u];
                        let _e655 = (6u * (_e653 + _e649[0]));
                        let _e656 = (6u * _e649[0]);
                        let _e658 = positions.member[_e656];
                        let _e661 = positions.member[(_e656 + 1u)];
                        let _e663 = function_10(array<u32, 2>(_e658, _e661), _e648);
                        let _e666 = positions.member[(_e656 + 2u)];
                        let _e669 = positions.member[(_e656 + 3u)];
                        let _e671 = function_10(array<u32, 2>(_e666, _e669), _e648);
                        let _e674 = positions.member[(_e656 + 4u)];
                        let _e677 = positions.member[(_e656 + 5u)];
                        let _e679 = function_10(array<u32, 2>(_e674, _e677), _e648);
                        let _e682 = positions.member[_e655];
                        let _e685 = positions.member[(_e655 + 1u)];
                        let _e687 = function_10(array<u32, 2>(_e682, _e685), _e648);
                        let _e690 = positions.member[(_e655 + 2u)];
                        let _e693 = positions.member[(_e655 + 3u)];
                        let _e695 = function_10(array<u32, 2>(_e690, _e693), _e648);
                        let _e698 = positions.member[(_e655 + 4u)];
                        let _e701 = positions.member[(_e655 + 5u)];
                        let _e703 = function_10(array<u32, 2>(_e698, _e701), _e648);
                        let _e706 = local_32;
                        let _e710 = params.member.member.member[0u];
                        let _e712 = (6u * (_e710 + _e706[1]));
                        let _e713 = (6u * _e706[1]);
                        let _e715 = positions.member[_e713];
                        let _e718 = positions.member[(_e713 + 1u)];
                        let _e720 = function_10(array<u32, 2>(_e715, _e718), _e648);
                        let _e723 = positions.member[(_e713 + 2u)];
                        let _e726 = positions.member[(_e713 + 3u)];
                        let _e728 = function_10(array<u32, 2>(_e723, _e726), _e648);
                        let _e731 = positions.member[(_e713 + 4u)];
                        let _e734 = positions.member[(_e713 + 5u)];
                        let _e736 = function_10(array<u32, 2>(_e731, _e734), _e648);
                        let _e739 = positions.member[_e712];
                        let _e742 = positions.member[(_e712 + 1u)];
                        let _e744 = function_10(array<u32, 2>(_e739, _e742), _e648);
                        let _e747 = positions.member[(_e712 + 2u)];
                        let _e750 = positions.member[(_e712 + 3u)];
                        let _e752 = function_10(array<u32, 2>(_e747, _e750), _e648);
                        let _e755 = positions.member[(_e712 + 4u)];
                        let _e758 = positions.member[(_e712 + 5u)];
                        let _e760 = function_10(array<u32, 2>(_e755, _e758), _e648);
                        let _e763 = local_32;
                        let _e767 = params.member.member.member[0u];
                        let _e769 = (6u * (_e767 + _e763[2]));
                        let _e770 = (6u * _e763[2]);
                        let _e772 = positions.member[_e770];
                        let _e775 = positions.member[(_e770 + 1u)];
                        let _e777 = function_10(array<u32, 2>(_e772, _e775), _e648);
                        let _e780 = positions.member[(_e770 + 2u)];
                        let _e783 = positions.member[(_e770 + 3u)];
                        let _e785 = function_10(array<u32, 2>(_e780, _e783), _e648);
                        let _e788 = positions.member[(_e770 + 4u)];
                        let _e791 = positions.member[(_e770 + 5u)];
                        let _e793 = function_10(array<u32, 2>(_e788, _e791), _e648);
                        let _e796 = positions.member[_e769];
                        let _e799 = positions.member[(_e769 + 1u)];
                        let _e801 = function_10(array<u32, 2>(_e796, _e799), _e648);
                        let _e804 = positions.member[(_e769 + 2u)];
                        let _e807 = positions.member[(_e769 + 3u)];
                        let _e809 = function_10(array<u32, 2>(_e804, _e807), _e648);
                        let _e812 = positions.member[(_e769 + 4u)];
                        let _e815 = positions.member[(_e769 + 5u)];
                        let _e817 = function_10(array<u32, 2>(_e812, _e815), _e648);
                        let _e820 = local_32;
                        let _e824 = params.member.member.member[0u];
                        let _e826 = (6u * (_e824 + _e820[3]));
                        let _e827 = (6u * _e820[3]);
                        let _e829 = positions.member[_e827];
                        let _e832 = positions.member[(_e827 + 1u)];
                        let _e834 = function_10(array<u32, 2>(_e829, _e832), _e648);
                        let _e837 = positions.member[(_e827 + 2u)];
                        let _e840 = positions.member[(_e827 + 3u)];
                        let _e842 = function_10(array<u32, 2>(_e837, _e840), _e648);
                        let _e845 = positions.member[(_e827 + 4u)];
                        let _e848 = positions.member[(_e827 + 5u)];
                        let _e850 = function_10(array<u32, 2>(_e845, _e848), _e648);
                        let _e853 = positions.member[_e826];
                        let _e856 = positions.member[(_e826 + 1u)];
                        let _e858 = function_10(array<u32, 2>(_e853, _e856), _e648);
                        let _e861 = positions.member[(_e826 + 2u)];
                        let _e864 = positions.member[(_e826 + 3u)];
                        let _e866 = function_10(array<u32, 2>(_e861, _e864), _e648);
                        let _e869 = positions.member[(_e826 + 4u)];
                        let _e872 = positions.member[(_e826 + 5u)];
                        let _e874 = function_10(array<u32, 2>(_e869, _e872), _e648);
                        phi_2655_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e663, _e671, _e679), array<type_9, 3>(_e687, _e695, _e703)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e720, _e728, _e736), array<type_9, 3>(_e744, _e752, _e760)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e777, _e785, _e793), array<type_9, 3>(_e801, _e809, _e817)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e834, _e842, _e850), array<type_9, 3>(_e858, _e866, _e874)));
                    }
                    let _e1268 = phi_2655_;
                    let _e1270 = params.member.member_2.member_1;
                    let _e1272 = params.member.member_2.member_2;
                    let _e1274 = params.member.member_2.member_3;
                    if (_e244.member != 0u) {
                        phi_3202_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[2][0][0].member - _e1268[0][0][0].member) - select(0u, 1u, (_e1268[2][0][0].member_1 < _e1268[0][0][0].member_1))), (_e1268[2][0][0].member_1 - _e1268[0][0][0].member_1)), type_9(((_e1268[2][0][1].member - _e1268[0][0][1].member) - select(0u, 1u, (_e1268[2][0][1].member_1 < _e1268[0][0][1].member_1))), (_e1268[2][0][1].member_1 - _e1268[0][0][1].member_1)), type_9(((_e1268[2][0][2].member - _e1268[0][0][2].member) - select(0u, 1u, (_e1268[2][0][2].member_1 < _e1268[0][0][2].member_1))), (_e1268[2][0][2].member_1 - _e1268[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[2][1][0].member - _e1268[0][1][0].member) - select(0u, 1u, (_e1268[2][1][0].member_1 < _e1268[0][1][0].member_1))), (_e1268[2][1][0].member_1 - _e1268[0][1][0].member_1)), type_9(((_e1268[2][1][1].member - _e1268[0][1][1].member) - select(0u, 1u, (_e1268[2][1][1].member_1 < _e1268[0][1][1].member_1))), (_e1268[2][1][1].member_1 - _e1268[0][1][1].member_1)), type_9(((_e1268[2][1][2].member - _e1268[0][1][2].member) - select(0u, 1u, (_e1268[2][1][2].member_1 < _e1268[0][1][2].member_1))), (_e1268[2][1][2].member_1 - _e1268[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[1][0][0].member - _e1268[0][0][0].member) - select(0u, 1u, (_e1268[1][0][0].member_1 < _e1268[0][0][0].member_1))), (_e1268[1][0][0].member_1 - _e1268[0][0][0].member_1)), type_9(((_e1268[1][0][1].member - _e1268[0][0][1].member) - select(0u, 1u, (_e1268[1][0][1].member_1 < _e1268[0][0][1].member_1))), (_e1268[1][0][1].member_1 - _e1268[0][0][1].member_1)), type_9(((_e1268[1][0][2].member - _e1268[0][0][2].member) - select(0u, 1u, (_e1268[1][0][2].member_1 < _e1268[0][0][2].member_1))), (_e1268[1][0][2].member_1 - _e1268[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[1][1][0].member - _e1268[0][1][0].member) - select(0u, 1u, (_e1268[1][1][0].member_1 < _e1268[0][1][0].member_1))), (_e1268[1][1][0].member_1 - _e1268[0][1][0].member_1)), type_9(((_e1268[1][1][1].member - _e1268[0][1][1].member) - select(0u, 1u, (_e1268[1][1][1].member_1 < _e1268[0][1][1].member_1))), (_e1268[1][1][1].member_1 - _e1268[0][1][1].member_1)), type_9(((_e1268[1][1][2].member - _e1268[0][1][2].member) - select(0u, 1u, (_e1268[1][1][2].member_1 < _e1268[0][1][2].member_1))), (_e1268[1][1][2].member_1 - _e1268[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[2][0][0].member - _e1268[3][0][0].member) - select(0u, 1u, (_e1268[2][0][0].member_1 < _e1268[3][0][0].member_1))), (_e1268[2][0][0].member_1 - _e1268[3][0][0].member_1)), type_9(((_e1268[2][0][1].member - _e1268[3][0][1].member) - select(0u, 1u, (_e1268[2][0][1].member_1 < _e1268[3][0][1].member_1))), (_e1268[2][0][1].member_1 - _e1268[3][0][1].member_1)), type_9(((_e1268[2][0][2].member - _e1268[3][0][2].member) - select(0u, 1u, (_e1268[2][0][2].member_1 < _e1268[3][0][2].member_1))), (_e1268[2][0][2].member_1 - _e1268[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[2][1][0].member - _e1268[3][1][0].member) - select(0u, 1u, (_e1268[2][1][0].member_1 < _e1268[3][1][0].member_1))), (_e1268[2][1][0].member_1 - _e1268[3][1][0].member_1)), type_9(((_e1268[2][1][1].member - _e1268[3][1][1].member) - select(0u, 1u, (_e1268[2][1][1].member_1 < _e1268[3][1][1].member_1))), (_e1268[2][1][1].member_1 - _e1268[3][1][1].member_1)), type_9(((_e1268[2][1][2].member - _e1268[3][1][2].member) - select(0u, 1u, (_e1268[2][1][2].member_1 < _e1268[3][1][2].member_1))), (_e1268[2][1][2].member_1 - _e1268[3][1][2].member_1)))));
                    } else {
                        phi_3202_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[0][0][0].member - _e1268[1][0][0].member) - select(0u, 1u, (_e1268[0][0][0].member_1 < _e1268[1][0][0].member_1))), (_e1268[0][0][0].member_1 - _e1268[1][0][0].member_1)), type_9(((_e1268[0][0][1].member - _e1268[1][0][1].member) - select(0u, 1u, (_e1268[0][0][1].member_1 < _e1268[1][0][1].member_1))), (_e1268[0][0][1].member_1 - _e1268[1][0][1].member_1)), type_9(((_e1268[0][0][2].member - _e1268[1][0][2].member) - select(0u, 1u, (_e1268[0][0][2].member_1 < _e1268[1][0][2].member_1))), (_e1268[0][0][2].member_1 - _e1268[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[0][1][0].member - _e1268[1][1][0].member) - select(0u, 1u, (_e1268[0][1][0].member_1 < _e1268[1][1][0].member_1))), (_e1268[0][1][0].member_1 - _e1268[1][1][0].member_1)), type_9(((_e1268[0][1][1].member - _e1268[1][1][1].member) - select(0u, 1u, (_e1268[0][1][1].member_1 < _e1268[1][1][1].member_1))), (_e1268[0][1][1].member_1 - _e1268[1][1][1].member_1)), type_9(((_e1268[0][1][2].member - _e1268[1][1][2].member) - select(0u, 1u, (_e1268[0][1][2].member_1 < _e1268[1][1][2].member_1))), (_e1268[0][1][2].member_1 - _e1268[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[2][0][0].member - _e1268[1][0][0].member) - select(0u, 1u, (_e1268[2][0][0].member_1 < _e1268[1][0][0].member_1))), (_e1268[2][0][0].member_1 - _e1268[1][0][0].member_1)), type_9(((_e1268[2][0][1].member - _e1268[1][0][1].member) - select(0u, 1u, (_e1268[2][0][1].member_1 < _e1268[1][0][1].member_1))), (_e1268[2][0][1].member_1 - _e1268[1][0][1].member_1)), type_9(((_e1268[2][0][2].member - _e1268[1][0][2].member) - select(0u, 1u, (_e1268[2][0][2].member_1 < _e1268[1][0][2].member_1))), (_e1268[2][0][2].member_1 - _e1268[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[2][1][0].member - _e1268[1][1][0].member) - select(0u, 1u, (_e1268[2][1][0].member_1 < _e1268[1][1][0].member_1))), (_e1268[2][1][0].member_1 - _e1268[1][1][0].member_1)), type_9(((_e1268[2][1][1].member - _e1268[1][1][1].member) - select(0u, 1u, (_e1268[2][1][1].member_1 < _e1268[1][1][1].member_1))), (_e1268[2][1][1].member_1 - _e1268[1][1][1].member_1)), type_9(((_e1268[2][1][2].member - _e1268[1][1][2].member) - select(0u, 1u, (_e1268[2][1][2].member_1 < _e1268[1][1][2].member_1))), (_e1268[2][1][2].member_1 - _e1268[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1268[3][0][0].member - _e1268[1][0][0].member) - select(0u, 1u, (_e1268[3][0][0].member_1 < _e1268[1][0][0].member_1))), (_e1268[3][0][0].member_1 - _e1268[1][0][0].member_1)), type_9(((_e1268[3][0][1].member - _e1268[1][0][1].member) - select(0u, 1u, (_e1268[3][0][1].member_1 < _e1268[1][0][1].member_1))), (_e1268[3][0][1].member_1 - _e1268[1][0][1].member_1)), type_9(((_e1268[3][0][2].member - _e1268[1][0][2].member) - select(0u, 1u, (_e1268[3][0][2].member_1 < _e1268[1][0][2].member_1))), (_e1268[3][0][2].member_1 - _e1268[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1268[3][1][0].member - _e1268[1][1][0].member) - select(0u, 1u, (_e1268[3][1][0].member_1 < _e1268[1][1][0].member_1))), (_e1268[3][1][0].member_1 - _e1268[1][1][0].member_1)), type_9(((_e1268[3][1][1].member - _e1268[1][1][1].member) - select(0u, 1u, (_e1268[3][1][1].member_1 < _e1268[1][1][1].member_1))), (_e1268[3][1][1].member_1 - _e1268[1][1][1].member_1)), type_9(((_e1268[3][1][2].member - _e1268[1][1][2].member) - select(0u, 1u, (_e1268[3][1][2].member_1 < _e1268[1][1][2].member_1))), (_e1268[3][1][2].member_1 - _e1268[1][1][2].member_1)))));
                    }
                    let _e1849 = phi_3202_;
                    local_30 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_31 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e1882 = local_30[1u].member;
                    let _e1884 = local_30[1u].member_1;
                    let _e1887 = local_31[2u].member;
                    let _e1889 = local_31[2u].member_1;
                    let _e1890 = function_5(_e1882, _e1884, _e1887, _e1889);
                    let _e1895 = local_30[2u].member;
                    let _e1897 = local_30[2u].member_1;
                    let _e1900 = local_31[1u].member;
                    let _e1902 = local_31[1u].member_1;
                    let _e1903 = function_5(_e1895, _e1897, _e1900, _e1902);
                    let _e1909 = ((_e1890.member - _e1903.member) - select(0u, 1u, (_e1890.member_1 < _e1903.member_1)));
                    let _e1910 = (_e1890.member_1 - _e1903.member_1);
                    local_28 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_29 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e1939 = local_28[2u].member;
                    let _e1941 = local_28[2u].member_1;
                    let _e1944 = local_29[0u].member;
                    let _e1946 = local_29[0u].member_1;
                    let _e1947 = function_5(_e1939, _e1941, _e1944, _e1946);
                    let _e1952 = local_28[0u].member;
                    let _e1954 = local_28[0u].member_1;
                    let _e1957 = local_29[2u].member;
                    let _e1959 = local_29[2u].member_1;
                    let _e1960 = function_5(_e1952, _e1954, _e1957, _e1959);
                    let _e1966 = ((_e1947.member - _e1960.member) - select(0u, 1u, (_e1947.member_1 < _e1960.member_1)));
                    let _e1967 = (_e1947.member_1 - _e1960.member_1);
                    local_26 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_27 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e1996 = local_26[0u].member;
                    let _e1998 = local_26[0u].member_1;
                    let _e2001 = local_27[1u].member;
                    let _e2003 = local_27[1u].member_1;
                    let _e2004 = function_5(_e1996, _e1998, _e2001, _e2003);
                    let _e2009 = local_26[1u].member;
                    let _e2011 = local_26[1u].member_1;
                    let _e2014 = local_27[0u].member;
                    let _e2016 = local_27[0u].member_1;
                    let _e2017 = function_5(_e2009, _e2011, _e2014, _e2016);
                    let _e2023 = ((_e2004.member - _e2017.member) - select(0u, 1u, (_e2004.member_1 < _e2017.member_1)));
                    let _e2024 = (_e2004.member_1 - _e2017.member_1);
                    local_24 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_25 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2057 = local_24[1u].member;
                    let _e2059 = local_24[1u].member_1;
                    let _e2062 = local_25[2u].member;
                    let _e2064 = local_25[2u].member_1;
                    let _e2065 = function_5(_e2057, _e2059, _e2062, _e2064);
                    let _e2070 = local_24[2u].member;
                    let _e2072 = local_24[2u].member_1;
                    let _e2075 = local_25[1u].member;
                    let _e2077 = local_25[1u].member_1;
                    let _e2078 = function_5(_e2070, _e2072, _e2075, _e2077);
                    let _e2084 = ((_e2065.member - _e2078.member) - select(0u, 1u, (_e2065.member_1 < _e2078.member_1)));
                    let _e2085 = (_e2065.member_1 - _e2078.member_1);
                    local_22 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_23 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2114 = local_22[2u].member;
                    let _e2116 = local_22[2u].member_1;
                    let _e2119 = local_23[0u].member;
                    let _e2121 = local_23[0u].member_1;
                    let _e2122 = function_5(_e2114, _e2116, _e2119, _e2121);
                    let _e2127 = local_22[0u].member;
                    let _e2129 = local_22[0u].member_1;
                    let _e2132 = local_23[2u].member;
                    let _e2134 = local_23[2u].member_1;
                    let _e2135 = function_5(_e2127, _e2129, _e2132, _e2134);
                    let _e2141 = ((_e2122.member - _e2135.member) - select(0u, 1u, (_e2122.member_1 < _e2135.member_1)));
                    let _e2142 = (_e2122.member_1 - _e2135.member_1);
                    local_20 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_21 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2171 = local_20[0u].member;
                    let _e2173 = local_20[0u].member_1;
                    let _e2176 = local_21[1u].member;
                    let _e2178 = local_21[1u].member_1;
                    let _e2179 = function_5(_e2171, _e2173, _e2176, _e2178);
                    let _e2184 = local_20[1u].member;
                    let _e2186 = local_20[1u].member_1;
                    let _e2189 = local_21[0u].member;
                    let _e2191 = local_21[0u].member_1;
                    let _e2192 = function_5(_e2184, _e2186, _e2189, _e2191);
                    let _e2198 = ((_e2179.member - _e2192.member) - select(0u, 1u, (_e2179.member_1 < _e2192.member_1)));
                    let _e2199 = (_e2179.member_1 - _e2192.member_1);
                    local_18 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_19 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2232 = local_18[1u].member;
                    let _e2234 = local_18[1u].member_1;
                    let _e2237 = local_19[2u].member;
                    let _e2239 = local_19[2u].member_1;
                    let _e2240 = function_5(_e2232, _e2234, _e2237, _e2239);
                    let _e2245 = local_18[2u].member;
                    let _e2247 = local_18[2u].member_1;
                    let _e2250 = local_19[1u].member;
                    let _e2252 = local_19[1u].member_1;
                    let _e2253 = function_5(_e2245, _e2247, _e2250, _e2252);
                    let _e2260 = (_e2240.member_1 - _e2253.member_1);
                    local_16 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_17 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2289 = local_16[2u].member;
                    let _e2291 = local_16[2u].member_1;
                    let _e2294 = local_17[0u].member;
                    let _e2296 = local_17[0u].member_1;
                    let _e2297 = function_5(_e2289, _e2291, _e2294, _e2296);
                    let _e2302 = local_16[0u].member;
                    let _e2304 = local_16[0u].member_1;
                    let _e2307 = local_17[2u].member;
                    let _e2309 = local_17[2u].member_1;
                    let _e2310 = function_5(_e2302, _e2304, _e2307, _e2309);
                    let _e2317 = (_e2297.member_1 - _e2310.member_1);
                    local_14 = array<type_9, 3>(type_9(_e1849[1][0][0].member, _e1849[1][0][0].member_1), type_9(_e1849[1][0][1].member, _e1849[1][0][1].member_1), type_9(_e1849[1][0][2].member, _e1849[1][0][2].member_1));
                    local_15 = array<type_9, 3>(type_9(_e1849[2][1][0].member, _e1849[2][1][0].member_1), type_9(_e1849[2][1][1].member, _e1849[2][1][1].member_1), type_9(_e1849[2][1][2].member, _e1849[2][1][2].member_1));
                    let _e2346 = local_14[0u].member;
                    let _e2348 = local_14[0u].member_1;
                    let _e2351 = local_15[1u].member;
                    let _e2353 = local_15[1u].member_1;
                    let _e2354 = function_5(_e2346, _e2348, _e2351, _e2353);
                    let _e2359 = local_14[1u].member;
                    let _e2361 = local_14[1u].member_1;
                    let _e2364 = local_15[0u].member;
                    let _e2366 = local_15[0u].member_1;
                    let _e2367 = function_5(_e2359, _e2361, _e2364, _e2366);
                    let _e2374 = (_e2354.member_1 - _e2367.member_1);
                    local_12 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_13 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e2407 = local_12[1u].member;
                    let _e2409 = local_12[1u].member_1;
                    let _e2412 = local_13[2u].member;
                    let _e2414 = local_13[2u].member_1;
                    let _e2415 = function_5(_e2407, _e2409, _e2412, _e2414);
                    let _e2420 = local_12[2u].member;
                    let _e2422 = local_12[2u].member_1;
                    let _e2425 = local_13[1u].member;
                    let _e2427 = local_13[1u].member_1;
                    let _e2428 = function_5(_e2420, _e2422, _e2425, _e2427);
                    local_10 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_11 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e2464 = local_10[2u].member;
                    let _e2466 = local_10[2u].member_1;
                    let _e2469 = local_11[0u].member;
                    let _e2471 = local_11[0u].member_1;
                    let _e2472 = function_5(_e2464, _e2466, _e2469, _e2471);
                    let _e2477 = local_10[0u].member;
                    let _e2479 = local_10[0u].member_1;
                    let _e2482 = local_11[2u].member;
                    let _e2484 = local_11[2u].member_1;
                    let _e2485 = function_5(_e2477, _e2479, _e2482, _e2484);
                    local_8 = array<type_9, 3>(type_9(_e1849[1][1][0].member, _e1849[1][1][0].member_1), type_9(_e1849[1][1][1].member, _e1849[1][1][1].member_1), type_9(_e1849[1][1][2].member, _e1849[1][1][2].member_1));
                    local_9 = array<type_9, 3>(type_9(_e1849[2][0][0].member, _e1849[2][0][0].member_1), type_9(_e1849[2][0][1].member, _e1849[2][0][1].member_1), type_9(_e1849[2][0][2].member, _e1849[2][0][2].member_1));
                    let _e2521 = local_8[0u].member;
                    let _e2523 = local_8[0u].member_1;
                    let _e2526 = local_9[1u].member;
                    let _e2528 = local_9[1u].member_1;
                    let _e2529 = function_5(_e2521, _e2523, _e2526, _e2528);
                    let _e2534 = local_8[1u].member;
                    let _e2536 = local_8[1u].member_1;
                    let _e2539 = local_9[0u].member;
                    let _e2541 = local_9[0u].member_1;
                    let _e2542 = function_5(_e2534, _e2536, _e2539, _e2541);
                    let _e2550 = (_e2260 + (_e2415.member_1 - _e2428.member_1));
                    let _e2554 = ((((_e2240.member - _e2253.member) - select(0u, 1u, (_e2240.member_1 < _e2253.member_1))) + ((_e2415.member - _e2428.member) - select(0u, 1u, (_e2415.member_1 < _e2428.member_1)))) + select(0u, 1u, (_e2550 < _e2260)));
                    let _e2555 = (_e2317 + (_e2472.member_1 - _e2485.member_1));
                    let _e2559 = ((((_e2297.member - _e2310.member) - select(0u, 1u, (_e2297.member_1 < _e2310.member_1))) + ((_e2472.member - _e2485.member) - select(0u, 1u, (_e2472.member_1 < _e2485.member_1)))) + select(0u, 1u, (_e2555 < _e2317)));
                    let _e2560 = (_e2374 + (_e2529.member_1 - _e2542.member_1));
                    let _e2564 = ((((_e2354.member - _e2367.member) - select(0u, 1u, (_e2354.member_1 < _e2367.member_1))) + ((_e2529.member - _e2542.member) - select(0u, 1u, (_e2529.member_1 < _e2542.member_1)))) + select(0u, 1u, (_e2560 < _e2374)));
                    let _e2571 = function_5(_e1849[0][0][0].member, _e1849[0][0][0].member_1, _e1909, _e1910);
                    let _e2578 = function_5(_e1849[0][0][1].member, _e1849[0][0][1].member_1, _e1966, _e1967);
                    let _e2581 = (_e2571.member_1 + _e2578.member_1);
                    let _e2590 = function_5(_e1849[0][0][2].member, _e1849[0][0][2].member_1, _e2023, _e2024);
                    let _e2593 = (_e2581 + _e2590.member_1);
                    let _e2598 = function_9(((((_e2571.member + _e2578.member) + select(0u, 1u, (_e2581 < _e2571.member_1))) + _e2590.member) + select(0u, 1u, (_e2593 < _e2581))), _e2593);
                    let _e2607 = function_5(_e1849[0][1][0].member, _e1849[0][1][0].member_1, _e1909, _e1910);
                    let _e2614 = function_5(_e1849[0][1][1].member, _e1849[0][1][1].member_1, _e1966, _e1967);
                    let _e2617 = (_e2607.member_1 + _e2614.member_1);
                    let _e2626 = function_5(_e1849[0][1][2].member, _e1849[0][1][2].member_1, _e2023, _e2024);
                    let _e2629 = (_e2617 + _e2626.member_1);
                    let _e2640 = function_5(_e1849[0][0][0].member, _e1849[0][0][0].member_1, _e2554, _e2550);
                    let _e2647 = function_5(_e1849[0][0][1].member, _e1849[0][0][1].member_1, _e2559, _e2555);
                    let _e2650 = (_e2640.member_1 + _e2647.member_1);
                    let _e2659 = function_5(_e1849[0][0][2].member, _e1849[0][0][2].member_1, _e2564, _e2560);
                    let _e2662 = (_e2650 + _e2659.member_1);
                    let _e2667 = (_e2629 + _e2662);
                    let _e2671 = ((((((_e2607.member + _e2614.member) + select(0u, 1u, (_e2617 < _e2607.member_1))) + _e2626.member) + select(0u, 1u, (_e2629 < _e2617))) + ((((_e2640.member + _e2647.member) + select(0u, 1u, (_e2650 < _e2640.member_1))) + _e2659.member) + select(0u, 1u, (_e2662 < _e2650)))) + select(0u, 1u, (_e2667 < _e2629)));
                    let _e2678 = function_5(_e1849[0][0][0].member, _e1849[0][0][0].member_1, _e2084, _e2085);
                    let _e2685 = function_5(_e1849[0][0][1].member, _e1849[0][0][1].member_1, _e2141, _e2142);
                    let _e2688 = (_e2678.member_1 + _e2685.member_1);
                    let _e2697 = function_5(_e1849[0][0][2].member, _e1849[0][0][2].member_1, _e2198, _e2199);
                    let _e2700 = (_e2688 + _e2697.member_1);
                    let _e2711 = function_5(_e1849[0][1][0].member, _e1849[0][1][0].member_1, _e2554, _e2550);
                    let _e2718 = function_5(_e1849[0][1][1].member, _e1849[0][1][1].member_1, _e2559, _e2555);
                    let _e2721 = (_e2711.member_1 + _e2718.member_1);
                    let _e2730 = function_5(_e1849[0][1][2].member, _e1849[0][1][2].member_1, _e2564, _e2560);
                    let _e2733 = (_e2721 + _e2730.member_1);
                    let _e2738 = (_e2700 + _e2733);
                    let _e2742 = ((((((_e2678.member + _e2685.member) + select(0u, 1u, (_e2688 < _e2678.member_1))) + _e2697.member) + select(0u, 1u, (_e2700 < _e2688))) + ((((_e2711.member + _e2718.member) + select(0u, 1u, (_e2721 < _e2711.member_1))) + _e2730.member) + select(0u, 1u, (_e2733 < _e2721)))) + select(0u, 1u, (_e2738 < _e2700)));
                    let _e2749 = function_5(_e1849[0][1][0].member, _e1849[0][1][0].member_1, _e2084, _e2085);
                    let _e2756 = function_5(_e1849[0][1][1].member, _e1849[0][1][1].member_1, _e2141, _e2142);
                    let _e2759 = (_e2749.member_1 + _e2756.member_1);
                    let _e2768 = function_5(_e1849[0][1][2].member, _e1849[0][1][2].member_1, _e2198, _e2199);
                    let _e2771 = (_e2759 + _e2768.member_1);
                    let _e2776 = function_9(((((_e2749.member + _e2756.member) + select(0u, 1u, (_e2759 < _e2749.member_1))) + _e2768.member) + select(0u, 1u, (_e2771 < _e2759))), _e2771);
                    let _e2786 = select((bitcast<u32>(31i) - firstLeadingBit(_e1274)), 32u, (_e1274 == 0u));
                    let _e2788 = select(18u, _e2786, (18u < _e2786));
                    phi_4506_ = array<type_9, 4>(_e2598, type_9(_e2671, _e2667), type_9(_e2742, _e2738), _e2776);
                    phi_4509_ = false;
                    phi_4511_ = false;
                    phi_4513_ = false;
                    phi_4515_ = false;
                    phi_4517_ = type_17(0u, 0u, 0u);
                    phi_4521_ = 0u;
                    phi_4523_ = 0u;
                    phi_4525_ = 0u;
                    phi_4527_ = 0u;
                    phi_4529_ = 0u;
                    loop {
                        let _e2790 = phi_4506_;
                        let _e2792 = phi_4509_;
                        let _e2794 = phi_4511_;
                        let _e2796 = phi_4513_;
                        let _e2798 = phi_4515_;
                        let _e2800 = phi_4517_;
                        let _e2802 = phi_4521_;
                        let _e2804 = phi_4523_;
                        let _e2806 = phi_4525_;
                        let _e2808 = phi_4527_;
                        let _e2810 = phi_4529_;
                        if (_e2806 < 64u) {
                            phi_4538_ = _e2790;
                            phi_4541_ = _e2796;
                            phi_4543_ = _e2798;
                            phi_4547_ = _e2792;
                            phi_4549_ = false;
                            phi_4551_ = false;
                            phi_4553_ = false;
                            phi_4555_ = _e2802;
                            phi_4557_ = _e2804;
                            phi_4559_ = _e2806;
                            phi_4561_ = _e2808;
                            phi_4563_ = _e2810;
                            loop {
                                let _e2813 = phi_4538_;
                                let _e2815 = phi_4541_;
                                let _e2817 = phi_4543_;
                                let _e2819 = phi_4547_;
                                let _e2821 = phi_4549_;
                                let _e2823 = phi_4551_;
                                let _e2825 = phi_4553_;
                                let _e2827 = phi_4555_;
                                let _e2829 = phi_4557_;
                                let _e2831 = phi_4559_;
                                let _e2833 = phi_4561_;
                                let _e2835 = phi_4563_;
                                local_36 = _e2819;
                                local_37 = _e2825;
                                local_38 = _e2813;
                                local_39 = _e2813;
                                local_40 = _e2813;
                                local_41 = _e2813;
                                local_42 = _e2813;
                                local_43 = _e2813;
                                local_44 = _e2813;
                                local_45 = _e2813;
                                local_46 = _e2813;
                                local_47 = _e2813;
                                local_48 = _e2813;
                                local_49 = _e2813;
                                local_50 = _e2833;
                                local_51 = _e2829;
                                local_52 = _e2827;
                                local_53 = _e2833;
                                local_54 = _e2813;
                                local_55 = _e2813;
                                local_56 = _e2813;
                                local_57 = _e2813;
                                local_58 = _e2813;
                                local_59 = _e2813;
                                local_60 = _e2821;
                                local_61 = _e2821;
                                local_62 = _e2833;
                                local_63 = _e2823;
                                local_64 = _e2833;
                                local_65 = _e2813;
                                local_66 = _e2813;
                                local_67 = _e2813;
                                local_68 = _e2829;
                                local_69 = _e2829;
                                local_70 = _e2813;
                                local_71 = _e2813;
                                local_72 = _e2813;
                                local_73 = _e2829;
                                local_74 = _e2827;
                                local_75 = _e2813;
                                local_76 = _e2813;
                                local_77 = _e2813;
                                local_78 = _e2813;
                                local_79 = _e2813;
                                local_80 = _e2813;
                                local_81 = _e2813;
                                local_82 = _e2813;
                                local_84 = _e2829;
                                local_85 = _e2827;
                                local_86 = _e2833;
                                local_87 = _e2829;
                                local_88 = _e2829;
                                local_89 = _e2821;
                                local_111 = _e2825;
                                local_112 = _e2815;
                                local_113 = _e2817;
                                local_114 = _e2825;
                                local_115 = _e2815;
                                local_116 = _e2817;
                                local_117 = _e2825;
                                local_90 = _e2835;
                                local_91 = _e2835;
                                local_92 = _e2833;
                                local_93 = _e2833;
                                local_94 = _e2833;
                                local_95 = _e2829;
                                local_118 = _e2833;
                                local_119 = _e2835;
                                local_120 = _e2813;
                                local_121 = _e2827;
                                local_122 = _e2829;
                                local_123 = _e2831;
                                if (_e2831 < 64u) {
                                    if _e2825 {
                                        phi_5441_ = array<type_9, 4>();
                                        phi_5442_ = bool();
                                        phi_5443_ = bool();
                                        phi_5445_ = bool();
                                        phi_5446_ = bool();
                                        phi_5447_ = bool();
                                        phi_5448_ = bool();
                                        phi_5449_ = u32();
                                        phi_5450_ = u32();
                                        phi_5451_ = u32();
                                        phi_5452_ = u32();
                                        phi_5453_ = u32();
                                        phi_5454_ = false;
                                    } else {
                                        if _e2819 {
                                            phi_5427_ = array<type_9, 4>();
                                            phi_5428_ = bool();
                                            phi_5429_ = bool();
                                            phi_5431_ = bool();
                                            phi_5432_ = bool();
                                            phi_5433_ = bool();
                                            phi_5434_ = bool();
                                            phi_5435_ = u32();
                                            phi_5436_ = u32();
                                            phi_5437_ = u32();
                                            phi_5438_ = u32();
                                            phi_5439_ = u32();
                                            phi_5440_ = false;
                                        } else {
                                            let _e2838 = (31u - _e2833);
                                            let _e2841 = (_e2835 << bitcast<u32>((_e2838 & 31u)));
                                            let _e2845 = ((_e2835 + 1u) << bitcast<u32>((_e2838 & 31u)));
                                            if (_e2841 > _e1272) {
                                                phi_4769_ = bool();
                                                phi_4770_ = true;
                                            } else {
                                                let _e2847 = (_e2845 < _e1270);
                                                if _e2847 {
                                                    phi_4768_ = bool();
                                                } else {
                                                    let _e2852 = function_8(128u);
                                                    let _e2857 = ((_e2813[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2885 = function_8(128u);
                                                    let _e2890 = ((_e2813[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2919 = function_8(128u);
                                                    let _e2924 = ((_e2813[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2953 = function_8(128u);
                                                    let _e2958 = ((_e2813[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_4768_ = ((((select(0u, select(1u, 2u, ((_e2813[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2852.member - select(_e2813[0].member, (~(_e2813[0].member) + select(0u, 1u, (_e2813[0].member_1 == 0u))), _e2857)) - select(0u, 1u, (_e2852.member_1 < select(_e2813[0].member_1, (~(_e2813[0].member_1) + 1u), _e2857)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2813[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2885.member - select(_e2813[1].member, (~(_e2813[1].member) + select(0u, 1u, (_e2813[1].member_1 == 0u))), _e2890)) - select(0u, 1u, (_e2885.member_1 < select(_e2813[1].member_1, (~(_e2813[1].member_1) + 1u), _e2890)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2813[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2919.member - select(_e2813[2].member, (~(_e2813[2].member) + select(0u, 1u, (_e2813[2].member_1 == 0u))), _e2924)) - select(0u, 1u, (_e2919.member_1 < select(_e2813[2].member_1, (~(_e2813[2].member_1) + 1u), _e2924)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2813[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2953.member - select(_e2813[3].member, (~(_e2813[3].member) + select(0u, 1u, (_e2813[3].member_1 == 0u))), _e2958)) - select(0u, 1u, (_e2953.member_1 < select(_e2813[3].member_1, (~(_e2813[3].member_1) + 1u), _e2958)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e2985 = phi_4768_;
                                                phi_4769_ = _e2985;
                                                phi_4770_ = _e2847;
                                            }
                                            let _e2987 = phi_4769_;
                                            let _e2989 = phi_4770_;
                                            let _e2990 = select(_e2987, true, _e2989);
                                            let _e2995 = function_8(128u);
                                            let _e3000 = ((_e2813[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3023 = select(0u, select(1u, 2u, ((_e2813[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2995.member - select(_e2813[0].member, (~(_e2813[0].member) + select(0u, 1u, (_e2813[0].member_1 == 0u))), _e3000)) - select(0u, 1u, (_e2995.member_1 < select(_e2813[0].member_1, (~(_e2813[0].member_1) + 1u), _e3000)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3028 = function_8(128u);
                                            let _e3033 = ((_e2813[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3056 = select(0u, select(1u, 2u, ((_e2813[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3028.member - select(_e2813[1].member, (~(_e2813[1].member) + select(0u, 1u, (_e2813[1].member_1 == 0u))), _e3033)) - select(0u, 1u, (_e3028.member_1 < select(_e2813[1].member_1, (~(_e2813[1].member_1) + 1u), _e3033)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3061 = function_8(128u);
                                            let _e3066 = ((_e2813[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3089 = select(0u, select(1u, 2u, ((_e2813[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3061.member - select(_e2813[2].member, (~(_e2813[2].member) + select(0u, 1u, (_e2813[2].member_1 == 0u))), _e3066)) - select(0u, 1u, (_e3061.member_1 < select(_e2813[2].member_1, (~(_e2813[2].member_1) + 1u), _e3066)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3094 = function_8(128u);
                                            let _e3099 = ((_e2813[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3122 = select(0u, select(1u, 2u, ((_e2813[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3094.member - select(_e2813[3].member, (~(_e2813[3].member) + select(0u, 1u, (_e2813[3].member_1 == 0u))), _e3099)) - select(0u, 1u, (_e3094.member_1 < select(_e2813[3].member_1, (~(_e2813[3].member_1) + 1u), _e3099)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3132 = select(false, select(true, select(false, (_e3056 != 0u), (_e3089 == _e3122)), select(true, (_e3089 == 0u), (_e3056 == _e3023))), ((_e3023 | _e3122) == 3u));
                                            let _e3137 = function_8(128u);
                                            let _e3142 = ((_e2813[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3168 = select(false, (_e2841 >= _e1270), (select(0u, select(1u, 2u, ((_e2813[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3137.member - select(_e2813[0].member, (~(_e2813[0].member) + select(0u, 1u, (_e2813[0].member_1 == 0u))), _e3142)) - select(0u, 1u, (_e3137.member_1 < select(_e2813[0].member_1, (~(_e2813[0].member_1) + 1u), _e3142)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e3169 = (_e2833 == 3u);
                                            let _e3170 = (_e2833 == 8u);
                                            let _e3175 = select(select(select((_e2833 == 14u), bool(), _e3170), bool(), _e3169), true, select(_e3170, true, _e3169));
                                            let _e3177 = select(false, !(_e2815), _e3168);
                                            let _e3178 = (_e2833 == 31u);
                                            let _e3189 = select(select(false, !(_e2817), select(select(select(select(select(false, !(_e2794), _e3132), bool(), _e3168), bool(), _e3175), bool(), _e3178), true, select(select(_e3168, true, _e3175), true, _e3178))), true, _e3177);
                                            if _e2990 {
                                                phi_5421_ = _e2813;
                                                phi_5422_ = _e2815;
                                                phi_5423_ = _e2817;
                                                phi_5425_ = _e2833;
                                                phi_5426_ = _e2835;
                                            } else {
                                                if _e3189 {
                                                    phi_5415_ = _e2813;
                                                    phi_5416_ = _e2815;
                                                    phi_5417_ = _e2817;
                                                    phi_5419_ = _e2833;
                                                    phi_5420_ = _e2835;
                                                } else {
                                                    let _e3198 = (_e2813[0].member_1 + _e2813[1].member_1);
                                                    let _e3202 = ((_e2813[0].member + _e2813[1].member) + select(0u, 1u, (_e3198 < _e2813[0].member_1)));
                                                    let _e3210 = bitcast<u32>((bitcast<i32>(_e3202) >> bitcast<u32>(1u)));
                                                    let _e3213 = ((_e3198 >> bitcast<u32>(1u)) | ((_e3202 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3222 = (_e2813[1].member_1 + _e2813[2].member_1);
                                                    let _e3226 = ((_e2813[1].member + _e2813[2].member) + select(0u, 1u, (_e3222 < _e2813[1].member_1)));
                                                    let _e3234 = bitcast<u32>((bitcast<i32>(_e3226) >> bitcast<u32>(1u)));
                                                    let _e3237 = ((_e3222 >> bitcast<u32>(1u)) | ((_e3226 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3246 = (_e2813[2].member_1 + _e2813[3].member_1);
                                                    let _e3250 = ((_e2813[2].member + _e2813[3].member) + select(0u, 1u, (_e3246 < _e2813[2].member_1)));
                                                    let _e3258 = bitcast<u32>((bitcast<i32>(_e3250) >> bitcast<u32>(1u)));
                                                    let _e3261 = ((_e3246 >> bitcast<u32>(1u)) | ((_e3250 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3262 = (_e3213 + _e3237);
                                                    let _e3266 = ((_e3210 + _e3234) + select(0u, 1u, (_e3262 < _e3213)));
                                                    let _e3274 = bitcast<u32>((bitcast<i32>(_e3266) >> bitcast<u32>(1u)));
                                                    let _e3277 = ((_e3262 >> bitcast<u32>(1u)) | ((_e3266 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3278 = (_e3237 + _e3261);
                                                    let _e3282 = ((_e3234 + _e3258) + select(0u, 1u, (_e3278 < _e3237)));
                                                    let _e3290 = bitcast<u32>((bitcast<i32>(_e3282) >> bitcast<u32>(1u)));
                                                    let _e3293 = ((_e3278 >> bitcast<u32>(1u)) | ((_e3282 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3294 = (_e3277 + _e3293);
                                                    let _e3298 = ((_e3274 + _e3290) + select(0u, 1u, (_e3294 < _e3277)));
                                                    let _e3306 = bitcast<u32>((bitcast<i32>(_e3298) >> bitcast<u32>(1u)));
                                                    let _e3309 = ((_e3294 >> bitcast<u32>(1u)) | ((_e3298 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3310 = (2u * _e2835);
                                                    let _e3321 = function_8(128u);
                                                    let _e3326 = ((_e2813[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e3350 = function_8(128u);
                                                    let _e3355 = ((_e3210 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3377 = function_8(128u);
                                                    let _e3382 = ((_e3274 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3404 = function_8(128u);
                                                    let _e3409 = ((_e3306 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e2813[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3321.member - select(_e2813[0].member, (~(_e2813[0].member) + select(0u, 1u, (_e2813[0].member_1 == 0u))), _e3326)) - select(0u, 1u, (_e3321.member_1 < select(_e2813[0].member_1, (~(_e2813[0].member_1) + 1u), _e3326)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3210 >> bitcast<u32>(31i)) != 0u)), ((((_e3350.member - select(_e3210, (~(_e3210) + select(0u, 1u, (_e3213 == 0u))), _e3355)) - select(0u, 1u, (_e3350.member_1 < select(_e3213, (~(_e3213) + 1u), _e3355)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3274 >> bitcast<u32>(31i)) != 0u)), ((((_e3377.member - select(_e3274, (~(_e3274) + select(0u, 1u, (_e3277 == 0u))), _e3382)) - select(0u, 1u, (_e3377.member_1 < select(_e3277, (~(_e3277) + 1u), _e3382)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3306 >> bitcast<u32>(31i)) != 0u)), ((((_e3404.member - select(_e3306, (~(_e3306) + select(0u, 1u, (_e3309 == 0u))), _e3409)) - select(0u, 1u, (_e3404.member_1 < select(_e3309, (~(_e3309) + 1u), _e3409)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_5412_ = array<type_9, 4>(type_9(_e3306, _e3309), type_9(_e3290, _e3293), type_9(_e3258, _e3261), _e2813[3]);
                                                        phi_5413_ = false;
                                                        phi_5414_ = (_e3310 + 1u);
                                                    } else {
                                                        phi_5412_ = array<type_9, 4>(_e2813[0], type_9(_e3210, _e3213), type_9(_e3274, _e3277), type_9(_e3306, _e3309));
                                                        phi_5413_ = _e2815;
                                                        phi_5414_ = _e3310;
                                                    }
                                                    let _e3439 = phi_5412_;
                                                    let _e3441 = phi_5413_;
                                                    let _e3443 = phi_5414_;
                                                    phi_5415_ = _e3439;
                                                    phi_5416_ = _e3441;
                                                    phi_5417_ = false;
                                                    phi_5419_ = (_e2833 + 1u);
                                                    phi_5420_ = _e3443;
                                                }
                                                let _e3445 = phi_5415_;
                                                let _e3447 = phi_5416_;
                                                let _e3449 = phi_5417_;
                                                let _e3451 = phi_5419_;
                                                let _e3453 = phi_5420_;
                                                phi_5421_ = _e3445;
                                                phi_5422_ = _e3447;
                                                phi_5423_ = _e3449;
                                                phi_5425_ = _e3451;
                                                phi_5426_ = _e3453;
                                            }
                                            let _e3455 = phi_5421_;
                                            let _e3457 = phi_5422_;
                                            let _e3459 = phi_5423_;
                                            let _e3461 = phi_5425_;
                                            let _e3463 = phi_5426_;
                                            phi_5427_ = _e3455;
                                            phi_5428_ = _e3457;
                                            phi_5429_ = _e3459;
                                            phi_5431_ = _e3189;
                                            phi_5432_ = _e3177;
                                            phi_5433_ = _e3132;
                                            phi_5434_ = _e2990;
                                            phi_5435_ = _e2845;
                                            phi_5436_ = _e2841;
                                            phi_5437_ = (_e2831 + 1u);
                                            phi_5438_ = _e3461;
                                            phi_5439_ = _e3463;
                                            phi_5440_ = true;
                                        }
                                        let _e3465 = phi_5427_;
                                        let _e3467 = phi_5428_;
                                        let _e3469 = phi_5429_;
                                        let _e3471 = phi_5431_;
                                        let _e3473 = phi_5432_;
                                        let _e3475 = phi_5433_;
                                        let _e3477 = phi_5434_;
                                        let _e3479 = phi_5435_;
                                        let _e3481 = phi_5436_;
                                        let _e3483 = phi_5437_;
                                        let _e3485 = phi_5438_;
                                        let _e3487 = phi_5439_;
                                        let _e3489 = phi_5440_;
                                        phi_5441_ = _e3465;
                                        phi_5442_ = _e3467;
                                        phi_5443_ = _e3469;
                                        phi_5445_ = _e3471;
                                        phi_5446_ = _e3473;
                                        phi_5447_ = _e3475;
                                        phi_5448_ = _e3477;
                                        phi_5449_ = _e3479;
                                        phi_5450_ = _e3481;
                                        phi_5451_ = _e3483;
                                        phi_5452_ = _e3485;
                                        phi_5453_ = _e3487;
                                        phi_5454_ = _e3489;
                                    }
                                    let _e3491 = phi_5441_;
                                    let _e3493 = phi_5442_;
                                    let _e3495 = phi_5443_;
                                    let _e3497 = phi_5445_;
                                    let _e3499 = phi_5446_;
                                    let _e3501 = phi_5447_;
                                    let _e3503 = phi_5448_;
                                    let _e3505 = phi_5449_;
                                    let _e3507 = phi_5450_;
                                    let _e3509 = phi_5451_;
                                    let _e3511 = phi_5452_;
                                    let _e3513 = phi_5453_;
                                    let _e3515 = phi_5454_;
                                    phi_4539_ = _e3491;
                                    phi_4542_ = _e3493;
                                    phi_4544_ = _e3495;
                                    phi_4548_ = _e3497;
                                    phi_4550_ = _e3499;
                                    phi_4552_ = _e3501;
                                    phi_4554_ = _e3503;
                                    phi_4556_ = _e3505;
                                    phi_4558_ = _e3507;
                                    phi_4560_ = _e3509;
                                    phi_4562_ = _e3511;
                                    phi_4564_ = _e3513;
                                    phi_5455_ = _e3515;
                                } else {
                                    phi_4539_ = array<type_9, 4>();
                                    phi_4542_ = bool();
                                    phi_4544_ = bool();
                                    phi_4548_ = bool();
                                    phi_4550_ = bool();
                                    phi_4552_ = bool();
                                    phi_4554_ = bool();
                                    phi_4556_ = u32();
                                    phi_4558_ = u32();
                                    phi_4560_ = u32();
                                    phi_4562_ = u32();
                                    phi_4564_ = u32();
                                    phi_5455_ = false;
                                }
                                let _e3517 = phi_4539_;
                                let _e3519 = phi_4542_;
                                let _e3521 = phi_4544_;
                                let _e3523 = phi_4548_;
                                let _e3525 = phi_4550_;
                                let _e3527 = phi_4552_;
                                let _e3529 = phi_4554_;
                                let _e3531 = phi_4556_;
                                let _e3533 = phi_4558_;
                                let _e3535 = phi_4560_;
                                let _e3537 = phi_4562_;
                                let _e3539 = phi_4564_;
                                let _e3541 = phi_5455_;
                                continue;
                                continuing {
                                    phi_4538_ = _e3517;
                                    phi_4541_ = _e3519;
                                    phi_4543_ = _e3521;
                                    phi_4547_ = _e3523;
                                    phi_4549_ = _e3525;
                                    phi_4551_ = _e3527;
                                    phi_4553_ = _e3529;
                                    phi_4555_ = _e3531;
                                    phi_4557_ = _e3533;
                                    phi_4559_ = _e3535;
                                    phi_4561_ = _e3537;
                                    phi_4563_ = _e3539;
                                    break if !(_e3541);
                                }
                            }
                            let _e3544 = local_36;
                            if _e3544 {
                                let _e3546 = local_37;
                                if _e3546 {
                                    phi_8326_ = _e2792;
                                    phi_8327_ = _e2794;
                                    let _e6419 = local_112;
                                    phi_8328_ = _e6419;
                                    let _e6422 = local_113;
                                    phi_8329_ = _e6422;
                                    phi_8330_ = _e2800;
                                    let _e6426 = local_114;
                                    phi_8331_ = _e6426;
                                    phi_8332_ = bool();
                                    phi_8333_ = type_17();
                                    phi_8334_ = true;
                                    phi_8335_ = false;
                                    phi_8336_ = false;
                                    phi_8337_ = false;
                                } else {
                                    let _e3548 = local_38;
                                    let _e3552 = local_39;
                                    let _e3555 = function_8(128u);
                                    let _e3560 = ((_e3548[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3568 = local_40;
                                    let _e3587 = local_41;
                                    let _e3591 = local_42;
                                    let _e3594 = function_8(128u);
                                    let _e3599 = ((_e3587[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3607 = local_43;
                                    let _e3627 = local_44;
                                    let _e3631 = local_45;
                                    let _e3634 = function_8(128u);
                                    let _e3639 = ((_e3627[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3647 = local_46;
                                    let _e3667 = local_47;
                                    let _e3671 = local_48;
                                    let _e3674 = function_8(128u);
                                    let _e3679 = ((_e3667[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3687 = local_49;
                                    let _e3708 = local_50;
                                    let _e3713 = local_51;
                                    let _e3715 = local_52;
                                    let _e3717 = local_53;
                                    let _e3718 = type_17(_e3713, _e3715, _e3717);
                                    let _e3720 = local_54;
                                    let _e3724 = local_55;
                                    let _e3727 = function_8(128u);
                                    let _e3732 = ((_e3720[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3740 = local_56;
                                    let _e3759 = local_57;
                                    let _e3763 = local_58;
                                    let _e3766 = function_8(128u);
                                    let _e3771 = ((_e3759[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3779 = local_59;
                                    let _e3798 = ((select(0u, select(1u, 2u, ((_e3720[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3727.member - select(_e3740[0].member, (~(_e3720[0].member) + select(0u, 1u, (_e3724[0].member_1 == 0u))), _e3732)) - select(0u, 1u, (_e3727.member_1 < select(_e3740[0].member_1, (~(_e3724[0].member_1) + 1u), _e3732)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3759[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3766.member - select(_e3779[3].member, (~(_e3759[3].member) + select(0u, 1u, (_e3763[3].member_1 == 0u))), _e3771)) - select(0u, 1u, (_e3766.member_1 < select(_e3779[3].member_1, (~(_e3763[3].member_1) + 1u), _e3771)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e3800 = local_60;
                                    let _e3803 = local_61;
                                    if _e3803 {
                                        let _e4420 = local_87;
                                        let _e4423 = local_88;
                                        phi_6563_ = _e2792;
                                        phi_6564_ = _e2794;
                                        phi_6565_ = _e3798;
                                        phi_6566_ = type_17(_e4423, (_e4420 + 1u), 31u);
                                        phi_6567_ = _e2800;
                                    } else {
                                        if _e2792 {
                                            phi_6049_ = bool();
                                            phi_6050_ = type_17();
                                            phi_6051_ = true;
                                        } else {
                                            let _e3805 = local_62;
                                            let _e3809 = local_63;
                                            if select(true, select(true, false, (_e3805 < _e2788)), _e3809) {
                                                let _e3812 = local_64;
                                                if (_e3812 == 31u) {
                                                    if _e3798 {
                                                        phi_6042_ = _e3798;
                                                        phi_6043_ = _e3718;
                                                    } else {
                                                        let _e3815 = local_65;
                                                        let _e3819 = local_66;
                                                        let _e3822 = function_8(128u);
                                                        let _e3827 = ((_e3815[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3835 = local_67;
                                                        if (select(0u, select(1u, 2u, ((_e3815[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3822.member - select(_e3835[0].member, (~(_e3815[0].member) + select(0u, 1u, (_e3819[0].member_1 == 0u))), _e3827)) - select(0u, 1u, (_e3822.member_1 < select(_e3835[0].member_1, (~(_e3819[0].member_1) + 1u), _e3827)))) >> bitcast<u32>(31i)) != 0u)) == 0u) {
                                                            phi_6040_ = _e3798;
                                                            phi_6041_ = _e3718;
                                                        } else {
                                                            let _e3858 = select((bitcast<u32>(31i) - firstLeadingBit(_e1274)), 32u, (_e1274 == 0u));
                                                            let _e3864 = local_68;
                                                            let _e3865 = (_e3864 + (1u << bitcast<u32>(((31u - _e3858) & 31u))));
                                                            let _e3867 = local_69;
                                                            if (_e3865 <= 2147483648u) {
                                                                let _e3871 = local_70;
                                                                let _e3875 = local_71;
                                                                let _e3878 = function_8(128u);
                                                                let _e3883 = ((_e3871[0].member >> bitcast<u32>(31i)) != 0u);
                                                                let _e3891 = local_72;
                                                                let _e3914 = function_1(((_e2671 - _e2598.member) - select(0u, 1u, (_e2667 < _e2598.member_1))), (_e2667 - _e2598.member_1), _e3865);
                                                                let _e3917 = (_e2598.member_1 + _e3914.member_1);
                                                                let _e3921 = ((_e2598.member + _e3914.member) + select(0u, 1u, (_e3917 < _e2598.member_1)));
                                                                let _e3927 = function_1(((_e2742 - _e2671) - select(0u, 1u, (_e2738 < _e2667))), (_e2738 - _e2667), _e3865);
                                                                let _e3930 = (_e2667 + _e3927.member_1);
                                                                let _e3934 = ((_e2671 + _e3927.member) + select(0u, 1u, (_e3930 < _e2667)));
                                                                let _e3940 = function_1(((_e2776.member - _e2742) - select(0u, 1u, (_e2776.member_1 < _e2738))), (_e2776.member_1 - _e2738), _e3865);
                                                                let _e3943 = (_e2738 + _e3940.member_1);
                                                                let _e3953 = function_1(((_e3934 - _e3921) - select(0u, 1u, (_e3930 < _e3917))), (_e3930 - _e3917), _e3865);
                                                                let _e3956 = (_e3917 + _e3953.member_1);
                                                                let _e3960 = ((_e3921 + _e3953.member) + select(0u, 1u, (_e3956 < _e3917)));
                                                                let _e3966 = function_1(((((_e2742 + _e3940.member) + select(0u, 1u, (_e3943 < _e2738))) - _e3934) - select(0u, 1u, (_e3943 < _e3930))), (_e3943 - _e3930), _e3865);
                                                                let _e3969 = (_e3930 + _e3966.member_1);
                                                                let _e3979 = function_1(((((_e3934 + _e3966.member) + select(0u, 1u, (_e3969 < _e3930))) - _e3960) - select(0u, 1u, (_e3969 < _e3956))), (_e3969 - _e3956), _e3865);
                                                                let _e3982 = (_e3956 + _e3979.member_1);
                                                                let _e3986 = ((_e3960 + _e3979.member) + select(0u, 1u, (_e3982 < _e3956)));
                                                                let _e3987 = function_8(128u);
                                                                let _e3992 = ((_e3986 >> bitcast<u32>(31i)) != 0u);
                                                                phi_6039_ = ((select(0u, select(1u, 2u, ((_e3871[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3878.member - select(_e3891[0].member, (~(_e3871[0].member) + select(0u, 1u, (_e3875[0].member_1 == 0u))), _e3883)) - select(0u, 1u, (_e3878.member_1 < select(_e3891[0].member_1, (~(_e3875[0].member_1) + 1u), _e3883)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3986 >> bitcast<u32>(31i)) != 0u)), ((((_e3987.member - select(_e3986, (~(_e3986) + select(0u, 1u, (_e3982 == 0u))), _e3992)) - select(0u, 1u, (_e3987.member_1 < select(_e3982, (~(_e3982) + 1u), _e3992)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                            } else {
                                                                phi_6039_ = false;
                                                            }
                                                            let _e4016 = phi_6039_;
                                                            phi_6040_ = _e4016;
                                                            phi_6041_ = type_17(_e3867, _e3865, _e3858);
                                                        }
                                                        let _e4018 = phi_6040_;
                                                        let _e4020 = phi_6041_;
                                                        phi_6042_ = _e4018;
                                                        phi_6043_ = _e4020;
                                                    }
                                                    let _e4022 = phi_6042_;
                                                    let _e4024 = phi_6043_;
                                                    phi_6044_ = _e4022;
                                                    phi_6045_ = _e4024;
                                                } else {
                                                    phi_6044_ = _e3798;
                                                    phi_6045_ = _e3718;
                                                }
                                                let _e4026 = phi_6044_;
                                                let _e4028 = phi_6045_;
                                                phi_6046_ = _e4026;
                                                phi_6047_ = _e4028;
                                                phi_6048_ = false;
                                            } else {
                                                phi_6046_ = bool();
                                                phi_6047_ = type_17();
                                                phi_6048_ = true;
                                            }
                                            let _e4030 = phi_6046_;
                                            let _e4032 = phi_6047_;
                                            let _e4034 = phi_6048_;
                                            phi_6049_ = _e4030;
                                            phi_6050_ = _e4032;
                                            phi_6051_ = _e4034;
                                        }
                                        let _e4036 = phi_6049_;
                                        let _e4038 = phi_6050_;
                                        let _e4040 = phi_6051_;
                                        if _e4040 {
                                            let _e4041 = select(_e2788, 31u, _e2792);
                                            let _e4044 = local_73;
                                            let _e4045 = select(_e4044, _e2800.member, _e2792);
                                            let _e4048 = local_74;
                                            let _e4049 = select(_e4048, _e2800.member_1, _e2792);
                                            let _e4051 = local_75;
                                            let _e4055 = local_76;
                                            let _e4062 = ((f32(bitcast<i32>(_e4051[0].member)) * 4294967300f) + f32(_e4055[0].member_1));
                                            let _e4064 = local_77;
                                            let _e4068 = local_78;
                                            let _e4075 = ((f32(bitcast<i32>(_e4064[1].member)) * 4294967300f) + f32(_e4068[1].member_1));
                                            let _e4077 = local_79;
                                            let _e4081 = local_80;
                                            let _e4088 = ((f32(bitcast<i32>(_e4077[2].member)) * 4294967300f) + f32(_e4081[2].member_1));
                                            let _e4090 = local_81;
                                            let _e4094 = local_82;
                                            let _e4101 = ((f32(bitcast<i32>(_e4090[3].member)) * 4294967300f) + f32(_e4094[3].member_1));
                                            phi_6092_ = type_14(0i, 6i);
                                            phi_6095_ = 1f;
                                            phi_6097_ = 0f;
                                            phi_6099_ = (_e4062 / (_e4062 - _e4101));
                                            loop {
                                                let _e4105 = phi_6092_;
                                                let _e4107 = phi_6095_;
                                                let _e4109 = phi_6097_;
                                                let _e4111 = phi_6099_;
                                                local_83 = _e4111;
                                                if (_e4105.member < _e4105.member_1) {
                                                    let _e4118 = (_e4105.member + 1i);
                                                    phi_6093_ = type_14(select(_e4118, type_15().member_1, select(false, true, ((false == (_e4118 > _e4105.member)) != false))), _e4105.member_1);
                                                    phi_6140_ = type_15(1u, _e4105.member);
                                                } else {
                                                    phi_6093_ = _e4105;
                                                    phi_6140_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e4129 = phi_6093_;
                                                let _e4131 = phi_6140_;
                                                let _e4134 = (bitcast<i32>(_e4131.member) != 0i);
                                                if _e4134 {
                                                    let _e4135 = function_7(_e4062, _e4075, _e4111);
                                                    let _e4136 = function_7(_e4075, _e4088, _e4111);
                                                    let _e4137 = function_7(_e4088, _e4101, _e4111);
                                                    let _e4138 = function_7(_e4135, _e4136, _e4111);
                                                    let _e4139 = function_7(_e4136, _e4137, _e4111);
                                                    let _e4140 = function_7(_e4138, _e4139, _e4111);
                                                    let _e4143 = ((_e4140 < 0f) == (_e4062 < 0f));
                                                    let _e4144 = select(_e4111, _e4107, _e4143);
                                                    let _e4145 = select(_e4109, _e4111, _e4143);
                                                    let _e4149 = (_e4111 - (_e4140 / (3f * (_e4139 - _e4138))));
                                                    phi_6096_ = _e4144;
                                                    phi_6098_ = _e4145;
                                                    phi_6100_ = select(_e4149, (0.5f * (_e4145 + _e4144)), select(true, select(true, false, (_e4149 <= _e4144)), (_e4149 >= _e4145)));
                                                } else {
                                                    phi_6096_ = f32();
                                                    phi_6098_ = f32();
                                                    phi_6100_ = f32();
                                                }
                                                let _e4158 = phi_6096_;
                                                let _e4160 = phi_6098_;
                                                let _e4162 = phi_6100_;
                                                continue;
                                                continuing {
                                                    phi_6092_ = _e4129;
                                                    phi_6095_ = _e4158;
                                                    phi_6097_ = _e4160;
                                                    phi_6099_ = _e4162;
                                                    break if !(_e4134);
                                                }
                                            }
                                            let _e4167 = (1u << bitcast<u32>(((31u - _e4041) & 31u)));
                                            let _e4168 = (_e4049 - _e4045);
                                            let _e4171 = local_83;
                                            let _e4172 = (_e4171 * f32(_e4168));
                                            let _e4177 = select(select(u32(_e4172), 0u, (_e4172 < 0f)), 4294967295u, (_e4172 > 4294967000f));
                                            let _e4179 = select(_e4177, _e4168, (_e4168 < _e4177));
                                            let _e4181 = (_e4167 / 2u);
                                            let _e4184 = ((_e4045 + _e4179) - select(_e4181, _e4179, (_e4179 < _e4181)));
                                            let _e4185 = (_e4184 + _e4167);
                                            let _e4187 = select(_e4185, _e4049, (_e4049 < _e4185));
                                            let _e4193 = function_1(((_e2671 - _e2598.member) - select(0u, 1u, (_e2667 < _e2598.member_1))), (_e2667 - _e2598.member_1), _e4184);
                                            let _e4196 = (_e2598.member_1 + _e4193.member_1);
                                            let _e4200 = ((_e2598.member + _e4193.member) + select(0u, 1u, (_e4196 < _e2598.member_1)));
                                            let _e4206 = function_1(((_e2742 - _e2671) - select(0u, 1u, (_e2738 < _e2667))), (_e2738 - _e2667), _e4184);
                                            let _e4209 = (_e2667 + _e4206.member_1);
                                            let _e4213 = ((_e2671 + _e4206.member) + select(0u, 1u, (_e4209 < _e2667)));
                                            let _e4219 = function_1(((_e2776.member - _e2742) - select(0u, 1u, (_e2776.member_1 < _e2738))), (_e2776.member_1 - _e2738), _e4184);
                                            let _e4222 = (_e2738 + _e4219.member_1);
                                            let _e4232 = function_1(((_e4213 - _e4200) - select(0u, 1u, (_e4209 < _e4196))), (_e4209 - _e4196), _e4184);
                                            let _e4235 = (_e4196 + _e4232.member_1);
                                            let _e4239 = ((_e4200 + _e4232.member) + select(0u, 1u, (_e4235 < _e4196)));
                                            let _e4245 = function_1(((((_e2742 + _e4219.member) + select(0u, 1u, (_e4222 < _e2738))) - _e4213) - select(0u, 1u, (_e4222 < _e4209))), (_e4222 - _e4209), _e4184);
                                            let _e4248 = (_e4209 + _e4245.member_1);
                                            let _e4258 = function_1(((((_e4213 + _e4245.member) + select(0u, 1u, (_e4248 < _e4209))) - _e4239) - select(0u, 1u, (_e4248 < _e4235))), (_e4248 - _e4235), _e4184);
                                            let _e4261 = (_e4235 + _e4258.member_1);
                                            let _e4265 = ((_e4239 + _e4258.member) + select(0u, 1u, (_e4261 < _e4235)));
                                            let _e4266 = function_8(128u);
                                            let _e4271 = ((_e4265 >> bitcast<u32>(31i)) != 0u);
                                            let _e4297 = function_1(((_e2671 - _e2598.member) - select(0u, 1u, (_e2667 < _e2598.member_1))), (_e2667 - _e2598.member_1), _e4187);
                                            let _e4300 = (_e2598.member_1 + _e4297.member_1);
                                            let _e4304 = ((_e2598.member + _e4297.member) + select(0u, 1u, (_e4300 < _e2598.member_1)));
                                            let _e4310 = function_1(((_e2742 - _e2671) - select(0u, 1u, (_e2738 < _e2667))), (_e2738 - _e2667), _e4187);
                                            let _e4313 = (_e2667 + _e4310.member_1);
                                            let _e4317 = ((_e2671 + _e4310.member) + select(0u, 1u, (_e4313 < _e2667)));
                                            let _e4323 = function_1(((_e2776.member - _e2742) - select(0u, 1u, (_e2776.member_1 < _e2738))), (_e2776.member_1 - _e2738), _e4187);
                                            let _e4326 = (_e2738 + _e4323.member_1);
                                            let _e4336 = function_1(((_e4317 - _e4304) - select(0u, 1u, (_e4313 < _e4300))), (_e4313 - _e4300), _e4187);
                                            let _e4339 = (_e4300 + _e4336.member_1);
                                            let _e4343 = ((_e4304 + _e4336.member) + select(0u, 1u, (_e4339 < _e4300)));
                                            let _e4349 = function_1(((((_e2742 + _e4323.member) + select(0u, 1u, (_e4326 < _e2738))) - _e4317) - select(0u, 1u, (_e4326 < _e4313))), (_e4326 - _e4313), _e4187);
                                            let _e4352 = (_e4313 + _e4349.member_1);
                                            let _e4362 = function_1(((((_e4317 + _e4349.member) + select(0u, 1u, (_e4352 < _e4313))) - _e4343) - select(0u, 1u, (_e4352 < _e4339))), (_e4352 - _e4339), _e4187);
                                            let _e4365 = (_e4339 + _e4362.member_1);
                                            let _e4369 = ((_e4343 + _e4362.member) + select(0u, 1u, (_e4365 < _e4339)));
                                            let _e4370 = function_8(128u);
                                            let _e4375 = ((_e4369 >> bitcast<u32>(31i)) != 0u);
                                            let _e4397 = ((select(0u, select(1u, 2u, ((_e4265 >> bitcast<u32>(31i)) != 0u)), ((((_e4266.member - select(_e4265, (~(_e4265) + select(0u, 1u, (_e4261 == 0u))), _e4271)) - select(0u, 1u, (_e4266.member_1 < select(_e4261, (~(_e4261) + 1u), _e4271)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4369 >> bitcast<u32>(31i)) != 0u)), ((((_e4370.member - select(_e4369, (~(_e4369) + select(0u, 1u, (_e4365 == 0u))), _e4375)) - select(0u, 1u, (_e4370.member_1 < select(_e4365, (~(_e4365) + 1u), _e4375)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e4400 = local_84;
                                            let _e4403 = local_85;
                                            let _e4406 = local_86;
                                            phi_6558_ = _e4397;
                                            phi_6559_ = true;
                                            phi_6560_ = _e4397;
                                            phi_6561_ = type_17(select(_e4400, _e4184, _e4397), select(_e4403, _e4187, _e4397), select(_e4406, _e4041, _e4397));
                                            phi_6562_ = type_17(_e4184, _e4187, _e4041);
                                        } else {
                                            phi_6558_ = _e2792;
                                            phi_6559_ = _e2794;
                                            phi_6560_ = _e4036;
                                            phi_6561_ = _e4038;
                                            phi_6562_ = _e2800;
                                        }
                                        let _e4410 = phi_6558_;
                                        let _e4412 = phi_6559_;
                                        let _e4414 = phi_6560_;
                                        let _e4416 = phi_6561_;
                                        let _e4418 = phi_6562_;
                                        phi_6563_ = _e4410;
                                        phi_6564_ = _e4412;
                                        phi_6565_ = _e4414;
                                        phi_6566_ = _e4416;
                                        phi_6567_ = _e4418;
                                    }
                                    let _e4426 = phi_6563_;
                                    let _e4428 = phi_6564_;
                                    let _e4430 = phi_6565_;
                                    let _e4432 = phi_6566_;
                                    let _e4434 = phi_6567_;
                                    let _e4453 = ((_e1849[0][1][0].member - _e1849[0][0][0].member) - select(0u, 1u, (_e1849[0][1][0].member_1 < _e1849[0][0][0].member_1)));
                                    let _e4454 = (_e1849[0][1][0].member_1 - _e1849[0][0][0].member_1);
                                    let _e4466 = ((_e1849[0][1][1].member - _e1849[0][0][1].member) - select(0u, 1u, (_e1849[0][1][1].member_1 < _e1849[0][0][1].member_1)));
                                    let _e4467 = (_e1849[0][1][1].member_1 - _e1849[0][0][1].member_1);
                                    let _e4479 = ((_e1849[0][1][2].member - _e1849[0][0][2].member) - select(0u, 1u, (_e1849[0][1][2].member_1 < _e1849[0][0][2].member_1)));
                                    let _e4480 = (_e1849[0][1][2].member_1 - _e1849[0][0][2].member_1);
                                    let _e4483 = ((_e4453 >> bitcast<u32>(31i)) != 0u);
                                    let _e4490 = select(_e4453, (~(_e4453) + select(0u, 1u, (_e4454 == 0u))), _e4483);
                                    let _e4491 = select(_e4454, (~(_e4454) + 1u), _e4483);
                                    let _e4494 = ((_e4466 >> bitcast<u32>(31i)) != 0u);
                                    let _e4501 = select(_e4466, (~(_e4466) + select(0u, 1u, (_e4467 == 0u))), _e4494);
                                    let _e4502 = select(_e4467, (~(_e4467) + 1u), _e4494);
                                    let _e4509 = ((((_e4501 - _e4490) - select(0u, 1u, (_e4502 < _e4491))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4510 = select(_e4501, _e4490, _e4509);
                                    let _e4511 = select(_e4502, _e4491, _e4509);
                                    let _e4514 = ((_e4479 >> bitcast<u32>(31i)) != 0u);
                                    let _e4521 = select(_e4479, (~(_e4479) + select(0u, 1u, (_e4480 == 0u))), _e4514);
                                    let _e4522 = select(_e4480, (~(_e4480) + 1u), _e4514);
                                    let _e4529 = ((((_e4521 - _e4510) - select(0u, 1u, (_e4522 < _e4511))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4531 = select(_e4522, _e4511, _e4529);
                                    let _e4532 = function_8(4u);
                                    let _e4535 = (_e4531 + _e4532.member_1);
                                    let _e4539 = ((select(_e4521, _e4510, _e4529) + _e4532.member) + select(0u, 1u, (_e4535 < _e4531)));
                                    let _e4554 = ((_e4535 >> bitcast<u32>((_e4432.member_2 & 31u))) | ((_e4539 << bitcast<u32>(((31u - _e4432.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4555 = function_8(4u);
                                    let _e4558 = (_e4554 + _e4555.member_1);
                                    let _e4576 = ((_e1849[1][1][0].member - _e1849[1][0][0].member) - select(0u, 1u, (_e1849[1][1][0].member_1 < _e1849[1][0][0].member_1)));
                                    let _e4577 = (_e1849[1][1][0].member_1 - _e1849[1][0][0].member_1);
                                    let _e4589 = ((_e1849[1][1][1].member - _e1849[1][0][1].member) - select(0u, 1u, (_e1849[1][1][1].member_1 < _e1849[1][0][1].member_1)));
                                    let _e4590 = (_e1849[1][1][1].member_1 - _e1849[1][0][1].member_1);
                                    let _e4602 = ((_e1849[1][1][2].member - _e1849[1][0][2].member) - select(0u, 1u, (_e1849[1][1][2].member_1 < _e1849[1][0][2].member_1)));
                                    let _e4603 = (_e1849[1][1][2].member_1 - _e1849[1][0][2].member_1);
                                    let _e4606 = ((_e4576 >> bitcast<u32>(31i)) != 0u);
                                    let _e4613 = select(_e4576, (~(_e4576) + select(0u, 1u, (_e4577 == 0u))), _e4606);
                                    let _e4614 = select(_e4577, (~(_e4577) + 1u), _e4606);
                                    let _e4617 = ((_e4589 >> bitcast<u32>(31i)) != 0u);
                                    let _e4624 = select(_e4589, (~(_e4589) + select(0u, 1u, (_e4590 == 0u))), _e4617);
                                    let _e4625 = select(_e4590, (~(_e4590) + 1u), _e4617);
                                    let _e4632 = ((((_e4624 - _e4613) - select(0u, 1u, (_e4625 < _e4614))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4633 = select(_e4624, _e4613, _e4632);
                                    let _e4634 = select(_e4625, _e4614, _e4632);
                                    let _e4637 = ((_e4602 >> bitcast<u32>(31i)) != 0u);
                                    let _e4644 = select(_e4602, (~(_e4602) + select(0u, 1u, (_e4603 == 0u))), _e4637);
                                    let _e4645 = select(_e4603, (~(_e4603) + 1u), _e4637);
                                    let _e4652 = ((((_e4644 - _e4633) - select(0u, 1u, (_e4645 < _e4634))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4654 = select(_e4645, _e4634, _e4652);
                                    let _e4655 = function_8(4u);
                                    let _e4658 = (_e4654 + _e4655.member_1);
                                    let _e4662 = ((select(_e4644, _e4633, _e4652) + _e4655.member) + select(0u, 1u, (_e4658 < _e4654)));
                                    let _e4677 = ((_e4658 >> bitcast<u32>((_e4432.member_2 & 31u))) | ((_e4662 << bitcast<u32>(((31u - _e4432.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4678 = function_8(4u);
                                    let _e4681 = (_e4677 + _e4678.member_1);
                                    let _e4699 = ((_e1849[2][1][0].member - _e1849[2][0][0].member) - select(0u, 1u, (_e1849[2][1][0].member_1 < _e1849[2][0][0].member_1)));
                                    let _e4700 = (_e1849[2][1][0].member_1 - _e1849[2][0][0].member_1);
                                    let _e4712 = ((_e1849[2][1][1].member - _e1849[2][0][1].member) - select(0u, 1u, (_e1849[2][1][1].member_1 < _e1849[2][0][1].member_1)));
                                    let _e4713 = (_e1849[2][1][1].member_1 - _e1849[2][0][1].member_1);
                                    let _e4725 = ((_e1849[2][1][2].member - _e1849[2][0][2].member) - select(0u, 1u, (_e1849[2][1][2].member_1 < _e1849[2][0][2].member_1)));
                                    let _e4726 = (_e1849[2][1][2].member_1 - _e1849[2][0][2].member_1);
                                    let _e4729 = ((_e4699 >> bitcast<u32>(31i)) != 0u);
                                    let _e4736 = select(_e4699, (~(_e4699) + select(0u, 1u, (_e4700 == 0u))), _e4729);
                                    let _e4737 = select(_e4700, (~(_e4700) + 1u), _e4729);
                                    let _e4740 = ((_e4712 >> bitcast<u32>(31i)) != 0u);
                                    let _e4747 = select(_e4712, (~(_e4712) + select(0u, 1u, (_e4713 == 0u))), _e4740);
                                    let _e4748 = select(_e4713, (~(_e4713) + 1u), _e4740);
                                    let _e4755 = ((((_e4747 - _e4736) - select(0u, 1u, (_e4748 < _e4737))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4756 = select(_e4747, _e4736, _e4755);
                                    let _e4757 = select(_e4748, _e4737, _e4755);
                                    let _e4760 = ((_e4725 >> bitcast<u32>(31i)) != 0u);
                                    let _e4767 = select(_e4725, (~(_e4725) + select(0u, 1u, (_e4726 == 0u))), _e4760);
                                    let _e4768 = select(_e4726, (~(_e4726) + 1u), _e4760);
                                    let _e4775 = ((((_e4767 - _e4756) - select(0u, 1u, (_e4768 < _e4757))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4777 = select(_e4768, _e4757, _e4775);
                                    let _e4778 = function_8(4u);
                                    let _e4781 = (_e4777 + _e4778.member_1);
                                    let _e4785 = ((select(_e4767, _e4756, _e4775) + _e4778.member) + select(0u, 1u, (_e4781 < _e4777)));
                                    let _e4800 = ((_e4781 >> bitcast<u32>((_e4432.member_2 & 31u))) | ((_e4785 << bitcast<u32>(((31u - _e4432.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4801 = function_8(4u);
                                    let _e4804 = (_e4800 + _e4801.member_1);
                                    local_7[0u].member = ((bitcast<u32>((bitcast<i32>(_e4539) >> bitcast<u32>((_e4432.member_2 & 31u)))) + _e4555.member) + select(0u, 1u, (_e4558 < _e4554)));
                                    local_7[0u].member_1 = _e4558;
                                    local_7[1u].member = ((bitcast<u32>((bitcast<i32>(_e4662) >> bitcast<u32>((_e4432.member_2 & 31u)))) + _e4678.member) + select(0u, 1u, (_e4681 < _e4677)));
                                    local_7[1u].member_1 = _e4681;
                                    local_7[2u].member = ((bitcast<u32>((bitcast<i32>(_e4785) >> bitcast<u32>((_e4432.member_2 & 31u)))) + _e4801.member) + select(0u, 1u, (_e4804 < _e4800)));
                                    local_7[2u].member_1 = _e4804;
                                    let _e4834 = function_1(((_e1849[0][1][0].member - _e1849[0][0][0].member) - select(0u, 1u, (_e1849[0][1][0].member_1 < _e1849[0][0][0].member_1))), (_e1849[0][1][0].member_1 - _e1849[0][0][0].member_1), _e4432.member);
                                    let _e4837 = (_e1849[0][0][0].member_1 + _e4834.member_1);
                                    let _e4841 = ((_e1849[0][0][0].member + _e4834.member) + select(0u, 1u, (_e4837 < _e1849[0][0][0].member_1)));
                                    let _e4855 = function_1(((_e1849[0][1][1].member - _e1849[0][0][1].member) - select(0u, 1u, (_e1849[0][1][1].member_1 < _e1849[0][0][1].member_1))), (_e1849[0][1][1].member_1 - _e1849[0][0][1].member_1), _e4432.member);
                                    let _e4858 = (_e1849[0][0][1].member_1 + _e4855.member_1);
                                    let _e4862 = ((_e1849[0][0][1].member + _e4855.member) + select(0u, 1u, (_e4858 < _e1849[0][0][1].member_1)));
                                    let _e4876 = function_1(((_e1849[0][1][2].member - _e1849[0][0][2].member) - select(0u, 1u, (_e1849[0][1][2].member_1 < _e1849[0][0][2].member_1))), (_e1849[0][1][2].member_1 - _e1849[0][0][2].member_1), _e4432.member);
                                    let _e4879 = (_e1849[0][0][2].member_1 + _e4876.member_1);
                                    let _e4883 = ((_e1849[0][0][2].member + _e4876.member) + select(0u, 1u, (_e4879 < _e1849[0][0][2].member_1)));
                                    let _e4899 = function_1(((_e1849[1][1][0].member - _e1849[1][0][0].member) - select(0u, 1u, (_e1849[1][1][0].member_1 < _e1849[1][0][0].member_1))), (_e1849[1][1][0].member_1 - _e1849[1][0][0].member_1), _e4432.member);
                                    let _e4902 = (_e1849[1][0][0].member_1 + _e4899.member_1);
                                    let _e4906 = ((_e1849[1][0][0].member + _e4899.member) + select(0u, 1u, (_e4902 < _e1849[1][0][0].member_1)));
                                    let _e4920 = function_1(((_e1849[1][1][1].member - _e1849[1][0][1].member) - select(0u, 1u, (_e1849[1][1][1].member_1 < _e1849[1][0][1].member_1))), (_e1849[1][1][1].member_1 - _e1849[1][0][1].member_1), _e4432.member);
                                    let _e4923 = (_e1849[1][0][1].member_1 + _e4920.member_1);
                                    let _e4927 = ((_e1849[1][0][1].member + _e4920.member) + select(0u, 1u, (_e4923 < _e1849[1][0][1].member_1)));
                                    let _e4941 = function_1(((_e1849[1][1][2].member - _e1849[1][0][2].member) - select(0u, 1u, (_e1849[1][1][2].member_1 < _e1849[1][0][2].member_1))), (_e1849[1][1][2].member_1 - _e1849[1][0][2].member_1), _e4432.member);
                                    let _e4944 = (_e1849[1][0][2].member_1 + _e4941.member_1);
                                    let _e4948 = ((_e1849[1][0][2].member + _e4941.member) + select(0u, 1u, (_e4944 < _e1849[1][0][2].member_1)));
                                    let _e4964 = function_1(((_e1849[2][1][0].member - _e1849[2][0][0].member) - select(0u, 1u, (_e1849[2][1][0].member_1 < _e1849[2][0][0].member_1))), (_e1849[2][1][0].member_1 - _e1849[2][0][0].member_1), _e4432.member);
                                    let _e4967 = (_e1849[2][0][0].member_1 + _e4964.member_1);
                                    let _e4971 = ((_e1849[2][0][0].member + _e4964.member) + select(0u, 1u, (_e4967 < _e1849[2][0][0].member_1)));
                                    let _e4985 = function_1(((_e1849[2][1][1].member - _e1849[2][0][1].member) - select(0u, 1u, (_e1849[2][1][1].member_1 < _e1849[2][0][1].member_1))), (_e1849[2][1][1].member_1 - _e1849[2][0][1].member_1), _e4432.member);
                                    let _e4988 = (_e1849[2][0][1].member_1 + _e4985.member_1);
                                    let _e4992 = ((_e1849[2][0][1].member + _e4985.member) + select(0u, 1u, (_e4988 < _e1849[2][0][1].member_1)));
                                    let _e5006 = function_1(((_e1849[2][1][2].member - _e1849[2][0][2].member) - select(0u, 1u, (_e1849[2][1][2].member_1 < _e1849[2][0][2].member_1))), (_e1849[2][1][2].member_1 - _e1849[2][0][2].member_1), _e4432.member);
                                    let _e5009 = (_e1849[2][0][2].member_1 + _e5006.member_1);
                                    let _e5013 = ((_e1849[2][0][2].member + _e5006.member) + select(0u, 1u, (_e5009 < _e1849[2][0][2].member_1)));
                                    local_5 = array<type_9, 3>(type_9(_e4906, _e4902), type_9(_e4927, _e4923), type_9(_e4948, _e4944));
                                    local_6 = array<type_9, 3>(type_9(_e4971, _e4967), type_9(_e4992, _e4988), type_9(_e5013, _e5009));
                                    let _e5024 = local_5[1u].member;
                                    let _e5026 = local_5[1u].member_1;
                                    let _e5029 = local_6[2u].member;
                                    let _e5031 = local_6[2u].member_1;
                                    let _e5032 = function_5(_e5024, _e5026, _e5029, _e5031);
                                    let _e5037 = local_5[2u].member;
                                    let _e5039 = local_5[2u].member_1;
                                    let _e5042 = local_6[1u].member;
                                    let _e5044 = local_6[1u].member_1;
                                    let _e5045 = function_5(_e5037, _e5039, _e5042, _e5044);
                                    let _e5051 = ((_e5032.member - _e5045.member) - select(0u, 1u, (_e5032.member_1 < _e5045.member_1)));
                                    let _e5052 = (_e5032.member_1 - _e5045.member_1);
                                    local_3 = array<type_9, 3>(type_9(_e4906, _e4902), type_9(_e4927, _e4923), type_9(_e4948, _e4944));
                                    local_4 = array<type_9, 3>(type_9(_e4971, _e4967), type_9(_e4992, _e4988), type_9(_e5013, _e5009));
                                    let _e5063 = local_3[2u].member;
                                    let _e5065 = local_3[2u].member_1;
                                    let _e5068 = local_4[0u].member;
                                    let _e5070 = local_4[0u].member_1;
                                    let _e5071 = function_5(_e5063, _e5065, _e5068, _e5070);
                                    let _e5076 = local_3[0u].member;
                                    let _e5078 = local_3[0u].member_1;
                                    let _e5081 = local_4[2u].member;
                                    let _e5083 = local_4[2u].member_1;
                                    let _e5084 = function_5(_e5076, _e5078, _e5081, _e5083);
                                    let _e5090 = ((_e5071.member - _e5084.member) - select(0u, 1u, (_e5071.member_1 < _e5084.member_1)));
                                    let _e5091 = (_e5071.member_1 - _e5084.member_1);
                                    local_1 = array<type_9, 3>(type_9(_e4906, _e4902), type_9(_e4927, _e4923), type_9(_e4948, _e4944));
                                    local_2 = array<type_9, 3>(type_9(_e4971, _e4967), type_9(_e4992, _e4988), type_9(_e5013, _e5009));
                                    let _e5102 = local_1[0u].member;
                                    let _e5104 = local_1[0u].member_1;
                                    let _e5107 = local_2[1u].member;
                                    let _e5109 = local_2[1u].member_1;
                                    let _e5110 = function_5(_e5102, _e5104, _e5107, _e5109);
                                    let _e5115 = local_1[1u].member;
                                    let _e5117 = local_1[1u].member_1;
                                    let _e5120 = local_2[0u].member;
                                    let _e5122 = local_2[0u].member_1;
                                    let _e5123 = function_5(_e5115, _e5117, _e5120, _e5122);
                                    let _e5129 = ((_e5110.member - _e5123.member) - select(0u, 1u, (_e5110.member_1 < _e5123.member_1)));
                                    let _e5130 = (_e5110.member_1 - _e5123.member_1);
                                    let _e5133 = ((_e5051 >> bitcast<u32>(31i)) != 0u);
                                    let _e5140 = select(_e5051, (~(_e5051) + select(0u, 1u, (_e5052 == 0u))), _e5133);
                                    let _e5141 = select(_e5052, (~(_e5052) + 1u), _e5133);
                                    let _e5144 = ((_e5090 >> bitcast<u32>(31i)) != 0u);
                                    let _e5151 = select(_e5090, (~(_e5090) + select(0u, 1u, (_e5091 == 0u))), _e5144);
                                    let _e5152 = select(_e5091, (~(_e5091) + 1u), _e5144);
                                    let _e5155 = ((_e5129 >> bitcast<u32>(31i)) != 0u);
                                    let _e5162 = select(_e5129, (~(_e5129) + select(0u, 1u, (_e5130 == 0u))), _e5155);
                                    let _e5163 = select(_e5130, (~(_e5130) + 1u), _e5155);
                                    let _e5188 = select(0i, select(2i, 1i, ((((_e5162 - _e5151) - select(0u, 1u, (_e5163 < _e5152))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e5162 - _e5140) - select(0u, 1u, (_e5163 < _e5141))) >> bitcast<u32>(31i)) != 0u)), ((((_e5151 - _e5140) - select(0u, 1u, (_e5152 < _e5141))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e5188 {
                                        case 0: {
                                            phi_7714_ = array<type_9, 2>(type_9(_e4862, _e4858), type_9(_e4883, _e4879));
                                            break;
                                        }
                                        case 1: {
                                            phi_7714_ = array<type_9, 2>(type_9(_e4883, _e4879), type_9(_e4841, _e4837));
                                            break;
                                        }
                                        default: {
                                            phi_7714_ = array<type_9, 2>(type_9(_e4841, _e4837), type_9(_e4862, _e4858));
                                            break;
                                        }
                                    }
                                    let _e5199 = phi_7714_;
                                    switch _e5188 {
                                        case 0: {
                                            phi_7743_ = array<type_9, 2>(type_9(_e4927, _e4923), type_9(_e4948, _e4944));
                                            break;
                                        }
                                        case 1: {
                                            phi_7743_ = array<type_9, 2>(type_9(_e4948, _e4944), type_9(_e4906, _e4902));
                                            break;
                                        }
                                        default: {
                                            phi_7743_ = array<type_9, 2>(type_9(_e4906, _e4902), type_9(_e4927, _e4923));
                                            break;
                                        }
                                    }
                                    let _e5210 = phi_7743_;
                                    switch _e5188 {
                                        case 0: {
                                            phi_7772_ = array<type_9, 2>(type_9(_e4992, _e4988), type_9(_e5013, _e5009));
                                            break;
                                        }
                                        case 1: {
                                            phi_7772_ = array<type_9, 2>(type_9(_e5013, _e5009), type_9(_e4971, _e4967));
                                            break;
                                        }
                                        default: {
                                            phi_7772_ = array<type_9, 2>(type_9(_e4971, _e4967), type_9(_e4992, _e4988));
                                            break;
                                        }
                                    }
                                    let _e5221 = phi_7772_;
                                    switch _e5188 {
                                        case 0: {
                                            phi_7786_ = type_9(_e5051, _e5052);
                                            break;
                                        }
                                        case 1: {
                                            phi_7786_ = type_9(_e5090, _e5091);
                                            break;
                                        }
                                        default: {
                                            phi_7786_ = type_9(_e5129, _e5130);
                                            break;
                                        }
                                    }
                                    let _e5226 = phi_7786_;
                                    let _e5229 = local_7[1u].member;
                                    let _e5231 = local_7[1u].member_1;
                                    let _e5234 = local_7[2u].member;
                                    let _e5236 = local_7[2u].member_1;
                                    let _e5237 = (_e5231 + _e5236);
                                    let _e5241 = ((_e5229 + _e5234) + select(0u, 1u, (_e5237 < _e5231)));
                                    let _e5252 = ((_e5237 >> bitcast<u32>(1u)) | ((_e5241 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5253 = function_8(17u);
                                    let _e5256 = (_e5252 + _e5253.member_1);
                                    let _e5260 = ((bitcast<u32>((bitcast<i32>(_e5241) >> bitcast<u32>(1u))) + _e5253.member) + select(0u, 1u, (_e5256 < _e5252)));
                                    let _e5263 = local_7[0u].member;
                                    let _e5265 = local_7[0u].member_1;
                                    let _e5268 = local_7[2u].member;
                                    let _e5270 = local_7[2u].member_1;
                                    let _e5271 = (_e5265 + _e5270);
                                    let _e5275 = ((_e5263 + _e5268) + select(0u, 1u, (_e5271 < _e5265)));
                                    let _e5286 = ((_e5271 >> bitcast<u32>(1u)) | ((_e5275 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5287 = function_8(17u);
                                    let _e5290 = (_e5286 + _e5287.member_1);
                                    let _e5294 = ((bitcast<u32>((bitcast<i32>(_e5275) >> bitcast<u32>(1u))) + _e5287.member) + select(0u, 1u, (_e5290 < _e5286)));
                                    let _e5297 = local_7[0u].member;
                                    let _e5299 = local_7[0u].member_1;
                                    let _e5302 = local_7[1u].member;
                                    let _e5304 = local_7[1u].member_1;
                                    let _e5305 = (_e5299 + _e5304);
                                    let _e5309 = ((_e5297 + _e5302) + select(0u, 1u, (_e5305 < _e5299)));
                                    let _e5320 = ((_e5305 >> bitcast<u32>(1u)) | ((_e5309 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5321 = function_8(17u);
                                    let _e5324 = (_e5320 + _e5321.member_1);
                                    let _e5328 = ((bitcast<u32>((bitcast<i32>(_e5309) >> bitcast<u32>(1u))) + _e5321.member) + select(0u, 1u, (_e5324 < _e5320)));
                                    let _e5333 = ((_e5226.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e5260 - select(_e5226.member, (~(_e5226.member) + select(0u, 1u, (_e5226.member_1 == 0u))), _e5333)) - select(0u, 1u, (_e5256 < select(_e5226.member_1, (~(_e5226.member_1) + 1u), _e5333)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e5354 = ((_e5226.member >> bitcast<u32>(31i)) != 0u);
                                        let _e5364 = select(_e5226.member, (~(_e5226.member) + select(0u, 1u, (_e5226.member_1 == 0u))), _e5354);
                                        let _e5366 = select(_e5226.member_1, (~(_e5226.member_1) + 1u), _e5354);
                                        let _e5367 = function_6(_e5199, _e5221);
                                        let _e5377 = select(_e5367.member, (~(_e5367.member) + select(0u, 1u, (_e5367.member_1 == 0u))), _e5354);
                                        let _e5379 = select(_e5367.member_1, (~(_e5367.member_1) + 1u), _e5354);
                                        let _e5380 = function_6(_e5210, _e5199);
                                        let _e5390 = select(_e5380.member, (~(_e5380.member) + select(0u, 1u, (_e5380.member_1 == 0u))), _e5354);
                                        let _e5392 = select(_e5380.member_1, (~(_e5380.member_1) + 1u), _e5354);
                                        if (_e244.member != 0u) {
                                            let _e5424 = (_e5256 + _e5290);
                                            let _e5436 = (_e5256 + _e5324);
                                            phi_8108_ = type_9(((_e5260 + _e5328) + select(0u, 1u, (_e5436 < _e5256))), _e5436);
                                            phi_8109_ = type_9(((_e5364 - _e5390) - select(0u, 1u, (_e5366 < _e5392))), (_e5366 - _e5392));
                                            phi_8110_ = type_9(((_e5260 + _e5294) + select(0u, 1u, (_e5424 < _e5256))), _e5424);
                                            phi_8111_ = type_9(((_e5364 - _e5377) - select(0u, 1u, (_e5366 < _e5379))), (_e5366 - _e5379));
                                        } else {
                                            let _e5398 = (_e5366 - _e5379);
                                            let _e5402 = ((((_e5364 - _e5377) - select(0u, 1u, (_e5366 < _e5379))) - _e5390) - select(0u, 1u, (_e5398 < _e5392)));
                                            let _e5403 = (_e5398 - _e5392);
                                            let _e5405 = (_e5256 + _e5290);
                                            let _e5410 = (_e5405 + _e5324);
                                            let _e5414 = ((((_e5260 + _e5294) + select(0u, 1u, (_e5405 < _e5256))) + _e5328) + select(0u, 1u, (_e5410 < _e5405)));
                                            phi_8108_ = type_9(_e5414, _e5410);
                                            phi_8109_ = type_9(_e5402, _e5403);
                                            phi_8110_ = type_9(_e5414, _e5410);
                                            phi_8111_ = type_9(_e5402, _e5403);
                                        }
                                        let _e5443 = phi_8108_;
                                        let _e5445 = phi_8109_;
                                        let _e5447 = phi_8110_;
                                        let _e5449 = phi_8111_;
                                        let _e5450 = function_4(_e5377, _e5379, _e5294, _e5290);
                                        if _e5450 {
                                            phi_8237_ = u32();
                                            phi_8238_ = true;
                                        } else {
                                            let _e5451 = function_4(_e5390, _e5392, _e5328, _e5324);
                                            if _e5451 {
                                                phi_8235_ = u32();
                                                phi_8236_ = true;
                                            } else {
                                                let _e5456 = function_4(_e5449.member, _e5449.member_1, _e5447.member, _e5447.member_1);
                                                if _e5456 {
                                                    phi_8233_ = u32();
                                                    phi_8234_ = true;
                                                } else {
                                                    let _e5461 = function_4(_e5445.member, _e5445.member_1, _e5443.member, _e5443.member_1);
                                                    if _e5461 {
                                                        phi_8232_ = u32();
                                                    } else {
                                                        let _e5462 = function_3(_e5377, _e5379, _e5294, _e5290);
                                                        if _e5462 {
                                                            let _e5463 = function_3(_e5390, _e5392, _e5328, _e5324);
                                                            if _e5463 {
                                                                let _e5468 = function_3(_e5449.member, _e5449.member_1, _e5447.member, _e5447.member_1);
                                                                if _e5468 {
                                                                    let _e5473 = function_3(_e5445.member, _e5445.member_1, _e5443.member, _e5443.member_1);
                                                                    phi_8225_ = select(true, false, _e5473);
                                                                } else {
                                                                    phi_8225_ = true;
                                                                }
                                                                let _e5476 = phi_8225_;
                                                                phi_8226_ = _e5476;
                                                            } else {
                                                                phi_8226_ = true;
                                                            }
                                                            let _e5478 = phi_8226_;
                                                            phi_8227_ = _e5478;
                                                        } else {
                                                            phi_8227_ = true;
                                                        }
                                                        let _e5480 = phi_8227_;
                                                        phi_8232_ = select(0u, 2u, _e5480);
                                                    }
                                                    let _e5483 = phi_8232_;
                                                    phi_8233_ = _e5483;
                                                    phi_8234_ = _e5461;
                                                }
                                                let _e5485 = phi_8233_;
                                                let _e5487 = phi_8234_;
                                                phi_8235_ = _e5485;
                                                phi_8236_ = _e5487;
                                            }
                                            let _e5489 = phi_8235_;
                                            let _e5491 = phi_8236_;
                                            phi_8237_ = _e5489;
                                            phi_8238_ = _e5491;
                                        }
                                        let _e5493 = phi_8237_;
                                        let _e5495 = phi_8238_;
                                        phi_8243_ = select(_e5493, 1u, _e5495);
                                    } else {
                                        phi_8243_ = 2u;
                                    }
                                    let _e5498 = phi_8243_;
                                    let _e5499 = (_e5498 == 1u);
                                    let _e5500 = (_e5498 == 0u);
                                    let _e5516 = local_89;
                                    if _e5516 {
                                        let _e6410 = local_111;
                                        phi_8315_ = _e6410;
                                        phi_8316_ = _e5499;
                                        phi_8317_ = select(true, false, _e5499);
                                        phi_8318_ = false;
                                        phi_8319_ = false;
                                    } else {
                                        let _e5520 = select(true, select(true, select(true, select(true, false, ((_e4432.member_1 - _e4432.member) <= _e1274)), select(false, (_e4432.member_1 <= _e1272), (_e4432.member >= _e1270))), _e4430), _e5500);
                                        let _e5522 = select(select(false, select((_e4432.member > _e1272), true, (_e4432.member_1 < _e1270)), _e4426), true, _e5499);
                                        let _e5523 = select(true, _e5522, select(((((select(0u, select(1u, 2u, ((_e3548[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3555.member - select(_e3568[0].member, (~(_e3548[0].member) + select(0u, 1u, (_e3552[0].member_1 == 0u))), _e3560)) - select(0u, 1u, (_e3555.member_1 < select(_e3568[0].member_1, (~(_e3552[0].member_1) + 1u), _e3560)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3587[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3594.member - select(_e3607[1].member, (~(_e3587[1].member) + select(0u, 1u, (_e3591[1].member_1 == 0u))), _e3599)) - select(0u, 1u, (_e3594.member_1 < select(_e3607[1].member_1, (~(_e3591[1].member_1) + 1u), _e3599)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3627[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3634.member - select(_e3647[2].member, (~(_e3627[2].member) + select(0u, 1u, (_e3631[2].member_1 == 0u))), _e3639)) - select(0u, 1u, (_e3634.member_1 < select(_e3647[2].member_1, (~(_e3631[2].member_1) + 1u), _e3639)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3667[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3674.member - select(_e3687[3].member, (~(_e3667[3].member) + select(0u, 1u, (_e3671[3].member_1 == 0u))), _e3679)) - select(0u, 1u, (_e3674.member_1 < select(_e3687[3].member_1, (~(_e3671[3].member_1) + 1u), _e3679)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e3708 == 31u), true, _e2792)));
                                        phi_8315_ = select(bool(), _e5522, _e5520);
                                        phi_8316_ = select(false, _e5523, _e5520);
                                        phi_8317_ = false;
                                        phi_8318_ = select(false, select(true, false, _e5523), _e5520);
                                        phi_8319_ = select(true, false, _e5520);
                                    }
                                    let _e5531 = phi_8315_;
                                    let _e5533 = phi_8316_;
                                    let _e5535 = phi_8317_;
                                    let _e5537 = phi_8318_;
                                    let _e5539 = phi_8319_;
                                    phi_8326_ = _e4426;
                                    phi_8327_ = _e4428;
                                    phi_8328_ = true;
                                    phi_8329_ = !(_e3800);
                                    phi_8330_ = _e4434;
                                    phi_8331_ = _e5531;
                                    phi_8332_ = _e5500;
                                    phi_8333_ = _e4432;
                                    phi_8334_ = _e5533;
                                    phi_8335_ = select(_e5535, false, _e5533);
                                    phi_8336_ = select(_e5537, false, _e5533);
                                    phi_8337_ = select(_e5539, false, _e5533);
                                }
                                let _e5544 = phi_8326_;
                                let _e5546 = phi_8327_;
                                let _e5548 = phi_8328_;
                                let _e5550 = phi_8329_;
                                let _e5552 = phi_8330_;
                                let _e5554 = phi_8331_;
                                let _e5556 = phi_8332_;
                                let _e5558 = phi_8333_;
                                let _e5560 = phi_8334_;
                                let _e5562 = phi_8335_;
                                let _e5564 = phi_8336_;
                                let _e5566 = phi_8337_;
                                phi_8338_ = _e5544;
                                phi_8339_ = _e5546;
                                phi_8340_ = _e5548;
                                phi_8341_ = _e5550;
                                phi_8342_ = _e5552;
                                phi_8343_ = _e5554;
                                phi_8344_ = _e5556;
                                phi_8345_ = _e5558;
                                phi_8346_ = _e5560;
                                phi_8347_ = _e5562;
                                phi_8348_ = _e5564;
                                phi_8349_ = _e5566;
                            } else {
                                phi_8338_ = _e2792;
                                phi_8339_ = _e2794;
                                let _e6437 = local_115;
                                phi_8340_ = _e6437;
                                let _e6440 = local_116;
                                phi_8341_ = _e6440;
                                phi_8342_ = _e2800;
                                let _e6444 = local_117;
                                phi_8343_ = _e6444;
                                phi_8344_ = bool();
                                phi_8345_ = type_17();
                                phi_8346_ = true;
                                phi_8347_ = false;
                                phi_8348_ = false;
                                phi_8349_ = false;
                            }
                            let _e5568 = phi_8338_;
                            let _e5570 = phi_8339_;
                            let _e5572 = phi_8340_;
                            let _e5574 = phi_8341_;
                            let _e5576 = phi_8342_;
                            let _e5578 = phi_8343_;
                            let _e5580 = phi_8344_;
                            let _e5582 = phi_8345_;
                            let _e5584 = phi_8346_;
                            let _e5586 = phi_8347_;
                            let _e5588 = phi_8348_;
                            let _e5590 = phi_8349_;
                            if _e5584 {
                                if _e5578 {
                                    let _e5594 = local_90;
                                    let _e5595 = (_e5594 + 1u);
                                    let _e5597 = local_91;
                                    let _e5599 = (_e5595 & (4294967295u - _e5597));
                                    let _e5605 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5599)), 32u, (_e5599 == 0u)));
                                    let _e5607 = local_92;
                                    let _e5610 = local_93;
                                    let _e5611 = select(_e5605, _e5610, (_e5607 < _e5605));
                                    let _e5614 = (_e5595 >> bitcast<u32>((_e5611 & 31u)));
                                    let _e5616 = local_94;
                                    let _e5617 = (_e5616 - _e5611);
                                    let _e5619 = local_95;
                                    let _e5620 = (_e5619 > _e1272);
                                    if _e5620 {
                                        phi_8400_ = u32();
                                        phi_8401_ = u32();
                                        phi_8402_ = false;
                                        phi_8403_ = false;
                                    } else {
                                        let _e5624 = select(true, select(true, false, (_e5617 == 0u)), (_e5614 == 1u));
                                        let _e5625 = (31u - _e5617);
                                        phi_8400_ = select(u32(), ((_e5614 + 1u) << bitcast<u32>((_e5625 & 31u))), _e5624);
                                        phi_8401_ = select(u32(), (_e5614 << bitcast<u32>((_e5625 & 31u))), _e5624);
                                        phi_8402_ = _e5624;
                                        phi_8403_ = select(true, false, _e5624);
                                    }
                                    let _e5637 = phi_8400_;
                                    let _e5639 = phi_8401_;
                                    let _e5641 = phi_8402_;
                                    let _e5643 = phi_8403_;
                                    phi_8404_ = _e5637;
                                    phi_8405_ = _e5639;
                                    phi_8406_ = false;
                                    phi_8407_ = false;
                                    phi_8408_ = false;
                                    phi_8409_ = false;
                                    phi_8410_ = _e5617;
                                    phi_8411_ = _e5614;
                                    phi_8412_ = _e5641;
                                    phi_8413_ = _e5620;
                                    phi_8414_ = _e5643;
                                } else {
                                    phi_8404_ = _e5576.member_1;
                                    phi_8405_ = _e5576.member;
                                    phi_8406_ = _e5568;
                                    phi_8407_ = _e5570;
                                    phi_8408_ = _e5572;
                                    phi_8409_ = _e5574;
                                    let _e6469 = local_118;
                                    phi_8410_ = _e6469;
                                    let _e6472 = local_119;
                                    phi_8411_ = _e6472;
                                    phi_8412_ = true;
                                    phi_8413_ = false;
                                    phi_8414_ = false;
                                }
                                let _e5645 = phi_8404_;
                                let _e5647 = phi_8405_;
                                let _e5649 = phi_8406_;
                                let _e5651 = phi_8407_;
                                let _e5653 = phi_8408_;
                                let _e5655 = phi_8409_;
                                let _e5657 = phi_8410_;
                                let _e5659 = phi_8411_;
                                let _e5661 = phi_8412_;
                                let _e5663 = phi_8413_;
                                let _e5665 = phi_8414_;
                                if _e5661 {
                                    if select(_e5649, true, _e5578) {
                                        let _e5672 = function_1(((_e2671 - _e2598.member) - select(0u, 1u, (_e2667 < _e2598.member_1))), (_e2667 - _e2598.member_1), _e5647);
                                        let _e5675 = (_e2598.member_1 + _e5672.member_1);
                                        let _e5685 = function_1(((_e2742 - _e2671) - select(0u, 1u, (_e2738 < _e2667))), (_e2738 - _e2667), _e5647);
                                        let _e5688 = (_e2667 + _e5685.member_1);
                                        let _e5698 = function_1(((_e2776.member - _e2742) - select(0u, 1u, (_e2776.member_1 < _e2738))), (_e2776.member_1 - _e2738), _e5647);
                                        let _e5701 = (_e2738 + _e5698.member_1);
                                        let _e5709 = array<type_9, 3>(type_9(((_e2598.member + _e5672.member) + select(0u, 1u, (_e5675 < _e2598.member_1))), _e5675), type_9(((_e2671 + _e5685.member) + select(0u, 1u, (_e5688 < _e2667))), _e5688), type_9(((_e2742 + _e5698.member) + select(0u, 1u, (_e5701 < _e2738))), _e5701));
                                        let _e5715 = function_1(((_e2671 - _e2598.member) - select(0u, 1u, (_e2667 < _e2598.member_1))), (_e2667 - _e2598.member_1), _e5645);
                                        let _e5718 = (_e2598.member_1 + _e5715.member_1);
                                        let _e5728 = function_1(((_e2742 - _e2671) - select(0u, 1u, (_e2738 < _e2667))), (_e2738 - _e2667), _e5645);
                                        let _e5731 = (_e2667 + _e5728.member_1);
                                        let _e5741 = function_1(((_e2776.member - _e2742) - select(0u, 1u, (_e2776.member_1 < _e2738))), (_e2776.member_1 - _e2738), _e5645);
                                        let _e5744 = (_e2738 + _e5741.member_1);
                                        let _e5753 = function_2(_e5709, _e5647);
                                        let _e5754 = function_2(_e5709, _e5645);
                                        let _e5755 = function_2(array<type_9, 3>(type_9(((_e2598.member + _e5715.member) + select(0u, 1u, (_e5718 < _e2598.member_1))), _e5718), type_9(((_e2671 + _e5728.member) + select(0u, 1u, (_e5731 < _e2667))), _e5731), type_9(((_e2742 + _e5741.member) + select(0u, 1u, (_e5744 < _e2738))), _e5744)), _e5645);
                                        let _e5769 = function_1(((_e5753[1].member - _e5753[0].member) - select(0u, 1u, (_e5753[1].member_1 < _e5753[0].member_1))), (_e5753[1].member_1 - _e5753[0].member_1), _e5647);
                                        let _e5772 = (_e5753[0].member_1 + _e5769.member_1);
                                        let _e5790 = function_1(((_e5753[1].member - _e5753[0].member) - select(0u, 1u, (_e5753[1].member_1 < _e5753[0].member_1))), (_e5753[1].member_1 - _e5753[0].member_1), _e5645);
                                        let _e5793 = (_e5753[0].member_1 + _e5790.member_1);
                                        let _e5811 = function_1(((_e5754[1].member - _e5754[0].member) - select(0u, 1u, (_e5754[1].member_1 < _e5754[0].member_1))), (_e5754[1].member_1 - _e5754[0].member_1), _e5645);
                                        let _e5814 = (_e5754[0].member_1 + _e5811.member_1);
                                        let _e5832 = function_1(((_e5755[1].member - _e5755[0].member) - select(0u, 1u, (_e5755[1].member_1 < _e5755[0].member_1))), (_e5755[1].member_1 - _e5755[0].member_1), _e5645);
                                        let _e5835 = (_e5755[0].member_1 + _e5832.member_1);
                                        phi_8681_ = array<type_9, 4>(type_9(((_e5753[0].member + _e5769.member) + select(0u, 1u, (_e5772 < _e5753[0].member_1))), _e5772), type_9(((_e5753[0].member + _e5790.member) + select(0u, 1u, (_e5793 < _e5753[0].member_1))), _e5793), type_9(((_e5754[0].member + _e5811.member) + select(0u, 1u, (_e5814 < _e5754[0].member_1))), _e5814), type_9(((_e5755[0].member + _e5832.member) + select(0u, 1u, (_e5835 < _e5755[0].member_1))), _e5835));
                                    } else {
                                        let _e6478 = local_120;
                                        phi_8681_ = _e6478;
                                    }
                                    let _e5846 = phi_8681_;
                                    phi_8682_ = _e5846;
                                    phi_8683_ = false;
                                    phi_8684_ = false;
                                } else {
                                    phi_8682_ = array<type_9, 4>();
                                    phi_8683_ = _e5663;
                                    phi_8684_ = _e5665;
                                }
                                let _e5848 = phi_8682_;
                                let _e5850 = phi_8683_;
                                let _e5852 = phi_8684_;
                                phi_8685_ = _e5848;
                                phi_8686_ = _e5649;
                                phi_8687_ = _e5651;
                                phi_8688_ = _e5653;
                                phi_8689_ = _e5655;
                                phi_8690_ = _e5657;
                                phi_8691_ = _e5659;
                                phi_8692_ = _e5661;
                                phi_8693_ = _e5850;
                                phi_8694_ = _e5852;
                                phi_8695_ = false;
                                phi_8696_ = false;
                                phi_8697_ = false;
                            } else {
                                phi_8685_ = array<type_9, 4>();
                                phi_8686_ = bool();
                                phi_8687_ = bool();
                                phi_8688_ = bool();
                                phi_8689_ = bool();
                                phi_8690_ = u32();
                                phi_8691_ = u32();
                                phi_8692_ = false;
                                phi_8693_ = false;
                                phi_8694_ = false;
                                phi_8695_ = _e5586;
                                phi_8696_ = _e5588;
                                phi_8697_ = _e5590;
                            }
                            let _e5854 = phi_8685_;
                            let _e5856 = phi_8686_;
                            let _e5858 = phi_8687_;
                            let _e5860 = phi_8688_;
                            let _e5862 = phi_8689_;
                            let _e5864 = phi_8690_;
                            let _e5866 = phi_8691_;
                            let _e5868 = phi_8692_;
                            let _e5870 = phi_8693_;
                            let _e5872 = phi_8694_;
                            let _e5874 = phi_8695_;
                            let _e5876 = phi_8696_;
                            let _e5878 = phi_8697_;
                            phi_4507_ = _e5854;
                            phi_4510_ = _e5856;
                            phi_4512_ = _e5858;
                            phi_4514_ = _e5860;
                            phi_4516_ = _e5862;
                            phi_4518_ = _e5576;
                            let _e6503 = local_121;
                            phi_4522_ = _e6503;
                            let _e6506 = local_122;
                            phi_4524_ = _e6506;
                            let _e6509 = local_123;
                            phi_4526_ = _e6509;
                            phi_4528_ = _e5864;
                            phi_4530_ = _e5866;
                            phi_8698_ = _e5580;
                            phi_8699_ = _e5582;
                            phi_8700_ = _e5868;
                            phi_8701_ = false;
                            phi_8702_ = _e5870;
                            phi_8703_ = _e5872;
                            phi_8704_ = _e5874;
                            phi_8705_ = _e5876;
                            phi_8706_ = _e5878;
                        } else {
                            phi_4507_ = array<type_9, 4>();
                            phi_4510_ = bool();
                            phi_4512_ = bool();
                            phi_4514_ = bool();
                            phi_4516_ = bool();
                            phi_4518_ = type_17();
                            phi_4522_ = u32();
                            phi_4524_ = u32();
                            phi_4526_ = u32();
                            phi_4528_ = u32();
                            phi_4530_ = u32();
                            phi_8698_ = bool();
                            phi_8699_ = type_17();
                            phi_8700_ = false;
                            phi_8701_ = true;
                            phi_8702_ = false;
                            phi_8703_ = false;
                            phi_8704_ = false;
                            phi_8705_ = false;
                            phi_8706_ = false;
                        }
                        let _e5880 = phi_4507_;
                        let _e5882 = phi_4510_;
                        let _e5884 = phi_4512_;
                        let _e5886 = phi_4514_;
                        let _e5888 = phi_4516_;
                        let _e5890 = phi_4518_;
                        let _e5892 = phi_4522_;
                        let _e5894 = phi_4524_;
                        let _e5896 = phi_4526_;
                        let _e5898 = phi_4528_;
                        let _e5900 = phi_4530_;
                        let _e5902 = phi_8698_;
                        let _e5904 = phi_8699_;
                        let _e5906 = phi_8700_;
                        let _e5908 = phi_8701_;
                        let _e5910 = phi_8702_;
                        let _e5912 = phi_8703_;
                        let _e5914 = phi_8704_;
                        let _e5916 = phi_8705_;
                        let _e5918 = phi_8706_;
                        local_96 = _e5908;
                        local_97 = _e5908;
                        local_98 = _e5908;
                        local_99 = _e5910;
                        local_100 = _e5908;
                        local_101 = _e5912;
                        local_102 = _e5908;
                        local_103 = _e5914;
                        local_104 = _e5908;
                        local_105 = _e5916;
                        local_106 = _e5908;
                        local_107 = _e5918;
                        local_108 = _e5902;
                        local_109 = _e5902;
                        local_110 = _e5904;
                        continue;
                        continuing {
                            phi_4506_ = _e5880;
                            phi_4509_ = _e5882;
                            phi_4511_ = _e5884;
                            phi_4513_ = _e5886;
                            phi_4515_ = _e5888;
                            phi_4517_ = _e5890;
                            phi_4521_ = _e5892;
                            phi_4523_ = _e5894;
                            phi_4525_ = _e5896;
                            phi_4527_ = _e5898;
                            phi_4529_ = _e5900;
                            break if !(_e5906);
                        }
                    }
                    let _e5922 = local_96;
                    let _e5927 = local_97;
                    let _e5930 = local_98;
                    let _e5932 = local_99;
                    let _e5933 = select(_e5932, false, _e5930);
                    let _e5935 = local_100;
                    let _e5937 = local_101;
                    let _e5940 = local_102;
                    let _e5942 = local_103;
                    let _e5945 = local_104;
                    let _e5947 = local_105;
                    let _e5950 = local_106;
                    let _e5952 = local_107;
                    let _e5954 = select(select(_e5937, false, _e5935), false, _e5933);
                    let _e5958 = select(_e5933, true, _e5954);
                    let _e5967 = select(select(select(select(_e5942, false, _e5940), false, _e5933), false, _e5954), false, _e5958);
                    if _e5967 {
                        let _e5971 = local_108;
                        let _e5976 = local_109;
                        phi_8748_ = type_9(select(2u, 3u, _e5971), select(type_9().member_1, type_9().member_1, _e5976));
                        phi_8749_ = false;
                        phi_8750_ = false;
                        phi_8751_ = false;
                    } else {
                        phi_8748_ = type_9();
                        phi_8749_ = select(select(select(select(_e5947, false, _e5945), false, _e5933), false, _e5954), false, _e5958);
                        phi_8750_ = select(select(select(select(_e5952, false, _e5950), false, _e5933), false, _e5954), false, _e5958);
                        phi_8751_ = _e5958;
                    }
                    let _e5980 = phi_8748_;
                    let _e5982 = phi_8749_;
                    let _e5984 = phi_8750_;
                    let _e5986 = phi_8751_;
                    let _e5992 = select(_e5984, false, _e5982);
                    let _e5996 = local_110;
                    let _e6000 = select(_e5982, true, _e5992);
                    let _e6007 = select(select(select(_e5967, false, _e5982), false, _e5992), true, _e6000);
                    let _e6011 = select(select(select(select(_e5986, false, _e5982), false, _e5992), false, _e6000), true, _e6007);
                    phi_8787_ = type_9(select(select(type_9().member, 2u, _e5922), select(select(type_9().member, 0u, _e5958), select(_e5980.member, select(select(type_9().member, 2u, _e5982), 1u, _e5992), _e6000), _e6007), _e6011), select(select(type_9().member_1, type_9().member_1, _e5927), select(select(type_9().member_1, type_9().member_1, _e5958), select(_e5980.member_1, select(select(type_9().member_1, type_9().member_1, _e5982), _e5996.member, _e5992), _e6000), _e6007), _e6011));
                }
                let _e6018 = phi_8787_;
                phi_8791_ = _e6018;
                phi_8792_ = type_9(_e202, _e205);
            } else {
                phi_8791_ = type_9(0u, u32());
                phi_8792_ = type_9(0u, 0u);
            }
            let _e6020 = phi_8791_;
            let _e6022 = phi_8792_;
            let _e6026 = params.member.member_2.member_1;
            switch bitcast<i32>(_e6020.member) {
                case 0: {
                    phi_8829_ = type_27(0u, 0u, array<u32, 2>(0u, 0u), false);
                    phi_8830_ = false;
                    break;
                }
                case 1: {
                    if (_e6020.member_1 == 0u) {
                        phi_8826_ = array<u32, 2>(0u, 0u);
                    } else {
                        let _e6035 = select((bitcast<u32>(31i) - firstLeadingBit(_e6020.member_1)), 32u, (_e6020.member_1 == 0u));
                        let _e6040 = ((_e6020.member_1 << bitcast<u32>((_e6035 & 31u))) << bitcast<u32>(1i));
                        phi_8826_ = array<u32, 2>((_e6040 << bitcast<u32>(20i)), (((1023u - _e6035) << bitcast<u32>(20i)) | (_e6040 >> bitcast<u32>(12i))));
                    }
                    let _e6051 = phi_8826_;
                    phi_8829_ = type_27(0u, select(0u, 1u, (_e6020.member_1 > _e6026)), _e6051, true);
                    phi_8830_ = false;
                    break;
                }
                case 2: {
                    phi_8829_ = type_27();
                    phi_8830_ = true;
                    break;
                }
                case 3: {
                    phi_8829_ = type_27();
                    phi_8830_ = true;
                    break;
                }
                default: {
                    phi_8829_ = type_27();
                    phi_8830_ = bool();
                    break;
                }
            }
            let _e6054 = phi_8829_;
            let _e6056 = phi_8830_;
            if _e6056 {
                phi_8834_ = type_27(1u, 0u, array<u32, 2>(0u, 0u), true);
            } else {
                phi_8834_ = _e6054;
            }
            let _e6058 = phi_8834_;
            local_35 = type_27(_e6058.member, _e6058.member_1, array<u32, 2>(_e6058.member_2[0], _e6058.member_2[1]), _e6058.member_3);
            let _e6071 = global.member;
            if (bitcast<i32>(_e6020.member) == bitcast<i32>(_e6071)) {
                if (bitcast<i32>(_e6020.member) == 1i) {
                    let _e6078 = global.member;
                    if (bitcast<i32>(_e6078) == 1i) {
                        let _e6083 = global.member_1;
                        phi_8874_ = (_e6020.member_1 == _e6083);
                        phi_8875_ = false;
                    } else {
                        phi_8874_ = bool();
                        phi_8875_ = true;
                    }
                    let _e6086 = phi_8874_;
                    let _e6088 = phi_8875_;
                    phi_8876_ = _e6086;
                    phi_8877_ = _e6088;
                } else {
                    phi_8876_ = bool();
                    phi_8877_ = true;
                }
                let _e6090 = phi_8876_;
                let _e6092 = phi_8877_;
                phi_8882_ = select(_e6090, true, _e6092);
            } else {
                phi_8882_ = false;
            }
            let _e6095 = phi_8882_;
            let _e6100 = params.member.member_2.member.member;
            let _e6103 = local_35.member;
            let _e6104 = (_e6103 == 0u);
            let _e6109 = select(select(select((_e6100 > 0u), bool(), _e6095), bool(), _e6104), false, select(_e6095, true, _e6104));
            if _e6109 {
                local = type_27(0u, 0u, array<u32, 2>(0u, 0u), false);
            } else {
                let _e6110 = local_35;
                local = _e6110;
            }
            let _e6112 = local.member;
            let _e6114 = select(true, false, (_e6112 == 0u));
            let _e6116 = local.member_3;
            if _e6116 {
                if _e6114 {
                    phi_8938_ = true;
                } else {
                    let _e6118 = params.member.member.member_1;
                    phi_8938_ = ((_e6118 & 16u) != 0u);
                }
                let _e6122 = phi_8938_;
                phi_8939_ = _e6122;
            } else {
                phi_8939_ = false;
            }
            let _e6124 = phi_8939_;
            let _e6126 = local.member_3;
            if _e6126 {
                if _e6114 {
                } else {
                    let _e6128 = local.member_2;
                    let _e6132 = (_e6128[1] >> bitcast<u32>(20i));
                    let _e6146 = atomicMin((&earliest.member[0u]), select(((((_e6132 - 896u) << bitcast<u32>(23i)) | ((_e6128[1] & 1048575u) << bitcast<u32>(3i))) | (_e6128[0] >> bitcast<u32>(29i))), 0u, (_e6132 <= 896u)));
                }
            }
            if (_e117 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6124 {
                let _e6150 = atomicAdd((&counters[0u]), 1u);
                phi_8982_ = _e6150;
            } else {
                phi_8982_ = 0u;
            }
            let _e6152 = phi_8982_;
            workgroupBarrier();
            if (_e117 == 0u) {
                let _e6155 = atomicLoad((&counters[0u]));
                if (_e6155 > 0u) {
                    let _e6158 = atomicAdd((&contacts.member[0u]), _e6155);
                    atomicStore((&counters[1u]), _e6158);
                }
            }
            workgroupBarrier();
            let _e6161 = atomicLoad((&counters[1u]));
            let _e6162 = (_e6161 + _e6152);
            if _e6124 {
                let _e6164 = params.member.member_1.member_3;
                if (_e6162 < _e6164) {
                    let _e6170 = (7u * _e6162);
                    atomicStore((&contacts.member[(4u + _e6170)]), select(1u, 0u, ((_e6022.member_1 & 2147483648u) == 0u)));
                    let _e6175 = local.member;
                    atomicStore((&contacts.member[(_e6170 + 5u)]), _e6175);
                    atomicStore((&contacts.member[(_e6170 + 6u)]), _e6022.member);
                    atomicStore((&contacts.member[(_e6170 + 7u)]), (_e6022.member_1 & 2147483647u));
                    let _e6184 = local.member_2[0u];
                    atomicStore((&contacts.member[(_e6170 + 8u)]), _e6184);
                    let _e6189 = local.member_2[1u];
                    atomicStore((&contacts.member[(_e6170 + 9u)]), _e6189);
                    let _e6193 = local.member_1;
                    atomicStore((&contacts.member[(_e6170 + 10u)]), _e6193);
                }
            }
            workgroupBarrier();
            if (_e117 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6109 {
                let _e6198 = atomicAdd((&counters[0u]), 1u);
                phi_9064_ = _e6198;
            } else {
                phi_9064_ = 0u;
            }
            let _e6200 = phi_9064_;
            workgroupBarrier();
            if (_e117 == 0u) {
                let _e6203 = atomicLoad((&counters[0u]));
                if (_e6203 > 0u) {
                    let _e6206 = atomicAdd((&left.member[0u]), _e6203);
                    atomicStore((&counters[1u]), _e6206);
                }
            }
            workgroupBarrier();
            let _e6209 = atomicLoad((&counters[1u]));
            let _e6210 = (_e6209 + _e6200);
            if _e6109 {
                if (_e6210 < _e6100) {
                    let _e6212 = (2u * _e6210);
                    atomicStore((&left.member[(4u + _e6212)]), _e6022.member);
                    atomicStore((&left.member[(_e6212 + 5u)]), _e6022.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_363_ = type_9(select(_e172.member, (_e172.member + 1u), _e175), select(_e172.member_1, _e172.member_1, _e175));
            break if !(_e188);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
