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
@group(0) @binding(0) 
var<storage> params: type_31;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> left: type_40;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_40;
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
    var phi_9103_: type_9;
    var phi_9104_: type_9;
    var phi_9105_: type_9;
    var phi_9106_: type_9;
    var phi_9107_: type_9;
    var phi_9108_: bool;

    let _e24 = ((param_27[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_27[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_28);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_9107_ = type_9();
        phi_9108_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_9106_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_9105_ = type_9((param_27[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_9104_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_27[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_27[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_9103_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_27[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_9103_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_9103_;
                    phi_9104_ = _e67;
                }
                let _e83 = phi_9104_;
                phi_9105_ = _e83;
            }
            let _e89 = phi_9105_;
            phi_9106_ = _e89;
        }
        let _e91 = phi_9106_;
        phi_9107_ = _e91;
        phi_9108_ = _e37;
    }
    let _e93 = phi_9107_;
    let _e95 = phi_9108_;
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
    var phi_302_: u32;
    var phi_348_: u32;
    var phi_351_: type_9;
    var phi_523_: type_20;
    var phi_937_: type_26;
    var phi_2640_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3187_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_4491_: array<type_9, 4>;
    var phi_4494_: bool;
    var phi_4496_: bool;
    var phi_4498_: bool;
    var phi_4500_: bool;
    var phi_4502_: type_17;
    var phi_4506_: u32;
    var phi_4508_: u32;
    var phi_4510_: u32;
    var phi_4512_: u32;
    var phi_4514_: u32;
    var phi_4523_: array<type_9, 4>;
    var phi_4526_: bool;
    var phi_4528_: bool;
    var phi_4532_: bool;
    var phi_4534_: bool;
    var phi_4536_: bool;
    var phi_4538_: bool;
    var phi_4540_: u32;
    var phi_4542_: u32;
    var phi_4544_: u32;
    var phi_4546_: u32;
    var phi_4548_: u32;
    var phi_4753_: bool;
    var phi_4754_: bool;
    var phi_4755_: bool;
    var phi_5397_: array<type_9, 4>;
    var phi_5398_: bool;
    var phi_5399_: u32;
    var phi_5400_: array<type_9, 4>;
    var phi_5401_: bool;
    var phi_5402_: bool;
    var phi_5404_: u32;
    var phi_5405_: u32;
    var phi_5406_: array<type_9, 4>;
    var phi_5407_: bool;
    var phi_5408_: bool;
    var phi_5410_: u32;
    var phi_5411_: u32;
    var phi_5412_: array<type_9, 4>;
    var phi_5413_: bool;
    var phi_5414_: bool;
    var phi_5416_: bool;
    var phi_5417_: bool;
    var phi_5418_: bool;
    var phi_5419_: bool;
    var phi_5420_: u32;
    var phi_5421_: u32;
    var phi_5422_: u32;
    var phi_5423_: u32;
    var phi_5424_: u32;
    var phi_5425_: bool;
    var phi_5426_: array<type_9, 4>;
    var phi_5427_: bool;
    var phi_5428_: bool;
    var phi_5430_: bool;
    var phi_5431_: bool;
    var phi_5432_: bool;
    var phi_5433_: bool;
    var phi_5434_: u32;
    var phi_5435_: u32;
    var phi_5436_: u32;
    var phi_5437_: u32;
    var phi_5438_: u32;
    var phi_5439_: bool;
    var phi_4524_: array<type_9, 4>;
    var phi_4527_: bool;
    var phi_4529_: bool;
    var phi_4533_: bool;
    var phi_4535_: bool;
    var phi_4537_: bool;
    var phi_4539_: bool;
    var phi_4541_: u32;
    var phi_4543_: u32;
    var phi_4545_: u32;
    var phi_4547_: u32;
    var phi_4549_: u32;
    var phi_5440_: bool;
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
    var phi_6024_: bool;
    var phi_6025_: bool;
    var phi_6026_: type_17;
    var phi_6027_: bool;
    var phi_6028_: type_17;
    var phi_6029_: bool;
    var phi_6030_: type_17;
    var phi_6031_: bool;
    var phi_6032_: type_17;
    var phi_6033_: bool;
    var phi_6034_: bool;
    var phi_6035_: type_17;
    var phi_6036_: bool;
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
    var phi_6077_: type_14;
    var phi_6080_: f32;
    var phi_6082_: f32;
    var phi_6084_: f32;
    var phi_6078_: type_14;
    var phi_6125_: type_15;
    var phi_6081_: f32;
    var phi_6083_: f32;
    var phi_6085_: f32;
    var local_81: f32;
    var local_82: u32;
    var local_83: u32;
    var local_84: u32;
    var phi_6543_: bool;
    var phi_6544_: bool;
    var phi_6545_: bool;
    var phi_6546_: type_17;
    var phi_6547_: type_17;
    var local_85: u32;
    var local_86: u32;
    var phi_6548_: bool;
    var phi_6549_: bool;
    var phi_6550_: bool;
    var phi_6551_: type_17;
    var phi_6552_: type_17;
    var phi_7699_: array<type_9, 2>;
    var phi_7728_: array<type_9, 2>;
    var phi_7757_: array<type_9, 2>;
    var phi_7771_: type_9;
    var phi_8093_: type_9;
    var phi_8094_: type_9;
    var phi_8095_: type_9;
    var phi_8096_: type_9;
    var phi_8210_: bool;
    var phi_8211_: bool;
    var phi_8212_: bool;
    var phi_8217_: u32;
    var phi_8218_: u32;
    var phi_8219_: bool;
    var phi_8220_: u32;
    var phi_8221_: bool;
    var phi_8222_: u32;
    var phi_8223_: bool;
    var phi_8228_: u32;
    var local_87: bool;
    var phi_8300_: bool;
    var phi_8301_: bool;
    var phi_8302_: bool;
    var phi_8303_: bool;
    var phi_8304_: bool;
    var phi_8311_: bool;
    var phi_8312_: bool;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: type_17;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: type_17;
    var phi_8319_: bool;
    var phi_8320_: bool;
    var phi_8321_: bool;
    var phi_8322_: bool;
    var phi_8323_: bool;
    var phi_8324_: bool;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: type_17;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var phi_8330_: type_17;
    var phi_8331_: bool;
    var phi_8332_: bool;
    var phi_8333_: bool;
    var phi_8334_: bool;
    var local_88: u32;
    var local_89: u32;
    var local_90: u32;
    var local_91: u32;
    var local_92: u32;
    var local_93: u32;
    var phi_8385_: u32;
    var phi_8386_: u32;
    var phi_8387_: bool;
    var phi_8388_: bool;
    var phi_8389_: u32;
    var phi_8390_: u32;
    var phi_8391_: bool;
    var phi_8392_: bool;
    var phi_8393_: bool;
    var phi_8394_: bool;
    var phi_8395_: u32;
    var phi_8396_: u32;
    var phi_8397_: bool;
    var phi_8398_: bool;
    var phi_8399_: bool;
    var phi_8666_: array<type_9, 4>;
    var phi_8667_: array<type_9, 4>;
    var phi_8668_: bool;
    var phi_8669_: bool;
    var phi_8670_: array<type_9, 4>;
    var phi_8671_: bool;
    var phi_8672_: bool;
    var phi_8673_: bool;
    var phi_8674_: bool;
    var phi_8675_: u32;
    var phi_8676_: u32;
    var phi_8677_: bool;
    var phi_8678_: bool;
    var phi_8679_: bool;
    var phi_8680_: bool;
    var phi_8681_: bool;
    var phi_8682_: bool;
    var phi_4492_: array<type_9, 4>;
    var phi_4495_: bool;
    var phi_4497_: bool;
    var phi_4499_: bool;
    var phi_4501_: bool;
    var phi_4503_: type_17;
    var phi_4507_: u32;
    var phi_4509_: u32;
    var phi_4511_: u32;
    var phi_4513_: u32;
    var phi_4515_: u32;
    var phi_8683_: bool;
    var phi_8684_: type_17;
    var phi_8685_: bool;
    var phi_8686_: bool;
    var phi_8687_: bool;
    var phi_8688_: bool;
    var phi_8689_: bool;
    var phi_8690_: bool;
    var phi_8691_: bool;
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
    var phi_8733_: type_9;
    var phi_8734_: bool;
    var phi_8735_: bool;
    var phi_8736_: bool;
    var local_108: type_17;
    var phi_8772_: type_9;
    var phi_8806_: array<u32, 2>;
    var phi_8809_: type_27;
    var phi_8810_: bool;
    var phi_8814_: type_27;
    var phi_8842_: bool;
    var phi_8843_: bool;
    var phi_8844_: bool;
    var phi_8845_: bool;
    var phi_8850_: bool;
    var phi_8861_: type_27;
    var phi_8862_: type_9;
    var phi_8893_: u32;
    var phi_8915_: u32;
    var phi_8992_: u32;
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
        phi_302_ = (_e137 - _e142);
    } else {
        phi_302_ = 0u;
    }
    let _e145 = phi_302_;
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
        phi_348_ = select(_e159, (_e159 + 1u), ((_e157 % _e130) > 0u));
    } else {
        phi_348_ = 0u;
    }
    let _e166 = phi_348_;
    phi_351_ = type_9(0u, _e166);
    loop {
        let _e169 = phi_351_;
        let _e172 = (_e169.member < _e169.member_1);
        let _e185 = (bitcast<i32>(select(0u, 1u, _e172)) != 0i);
        if _e185 {
            let _e189 = (((_e127 + (select(type_9().member_1, _e169.member, _e172) * _e130)) * 64u) + _e114);
            if (_e189 < _e149) {
                let _e193 = params.member.member_1.member_1;
                let _e195 = (2u * (_e193 + _e189));
                let _e198 = input.member[(4u + _e195)];
                let _e201 = input.member[(_e195 + 5u)];
                let _e206 = (_e201 & 2147483647u);
                if (select(1u, 0u, ((_e201 & 2147483648u) == 0u)) == 0u) {
                    let _e225 = params.member.member.member[1u];
                    let _e228 = ((2u * _e225) + (3u * _e206));
                    let _e230 = elements.member[_e228];
                    let _e233 = elements.member[(_e228 + 1u)];
                    let _e236 = elements.member[(_e228 + 2u)];
                    phi_523_ = type_20(0u, array<u32, 4>(_e198, _e230, _e233, _e236));
                } else {
                    let _e209 = (2u * _e198);
                    let _e211 = elements.member[_e209];
                    let _e214 = elements.member[(_e209 + 1u)];
                    let _e215 = (2u * _e206);
                    let _e217 = elements.member[_e215];
                    let _e220 = elements.member[(_e215 + 1u)];
                    phi_523_ = type_20(1u, array<u32, 4>(_e211, _e214, _e217, _e220));
                }
                let _e240 = phi_523_;
                local_31 = array<u32, 4>(_e240.member_1[0], _e240.member_1[1], _e240.member_1[2], _e240.member_1[3]);
                let _e249 = paths.member[_e240.member_1[0]];
                let _e263 = paths.member[_e240.member_1[1]];
                let _e277 = paths.member[_e240.member_1[2]];
                let _e291 = paths.member[_e240.member_1[3]];
                local_32 = array<array<f32, 3>, 4>(array<f32, 3>(_e249.member.x, _e249.member.y, _e249.member.z), array<f32, 3>(_e263.member.x, _e263.member.y, _e263.member.z), array<f32, 3>(_e277.member.x, _e277.member.y, _e277.member.z), array<f32, 3>(_e291.member.x, _e291.member.y, _e291.member.z));
                local_33 = array<array<f32, 3>, 4>(array<f32, 3>(_e249.member_1.x, _e249.member_1.y, _e249.member_1.z), array<f32, 3>(_e263.member_1.x, _e263.member_1.y, _e263.member_1.z), array<f32, 3>(_e277.member_1.x, _e277.member_1.y, _e277.member_1.z), array<f32, 3>(_e291.member_1.x, _e291.member_1.y, _e291.member_1.z));
                let _e315 = params.member.member.member_4;
                if (_e240.member != 0u) {
                    let _e406 = local_32;
                    let _e411 = local_32;
                    let _e420 = local_33;
                    let _e425 = local_33;
                    let _e435 = local_32;
                    let _e440 = local_32;
                    let _e449 = local_33;
                    let _e454 = local_33;
                    let _e464 = local_32;
                    let _e469 = local_32;
                    let _e478 = local_33;
                    let _e483 = local_33;
                    phi_937_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e406[2][0] - _e411[0][0]), (_e406[2][1] - _e411[0][1]), (_e406[2][2] - _e411[0][2])), array<f32, 3>((_e420[2][0] - _e425[0][0]), (_e420[2][1] - _e425[0][1]), (_e420[2][2] - _e425[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e435[1][0] - _e440[0][0]), (_e435[1][1] - _e440[0][1]), (_e435[1][2] - _e440[0][2])), array<f32, 3>((_e449[1][0] - _e454[0][0]), (_e449[1][1] - _e454[0][1]), (_e449[1][2] - _e454[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e464[2][0] - _e469[3][0]), (_e464[2][1] - _e469[3][1]), (_e464[2][2] - _e469[3][2])), array<f32, 3>((_e478[2][0] - _e483[3][0]), (_e478[2][1] - _e483[3][1]), (_e478[2][2] - _e483[3][2]))), (_e315 + _e315));
                } else {
                    let _e317 = local_32;
                    let _e322 = local_32;
                    let _e331 = local_33;
                    let _e336 = local_33;
                    let _e346 = local_32;
                    let _e351 = local_32;
                    let _e360 = local_33;
                    let _e365 = local_33;
                    let _e375 = local_32;
                    let _e380 = local_32;
                    let _e389 = local_33;
                    let _e394 = local_33;
                    phi_937_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e317[0][0] - _e322[1][0]), (_e317[0][1] - _e322[1][1]), (_e317[0][2] - _e322[1][2])), array<f32, 3>((_e331[0][0] - _e336[1][0]), (_e331[0][1] - _e336[1][1]), (_e331[0][2] - _e336[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e346[2][0] - _e351[1][0]), (_e346[2][1] - _e351[1][1]), (_e346[2][2] - _e351[1][2])), array<f32, 3>((_e360[2][0] - _e365[1][0]), (_e360[2][1] - _e365[1][1]), (_e360[2][2] - _e365[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e375[3][0] - _e380[1][0]), (_e375[3][1] - _e380[1][1]), (_e375[3][2] - _e380[1][2])), array<f32, 3>((_e389[3][0] - _e394[1][0]), (_e389[3][1] - _e394[1][1]), (_e389[3][2] - _e394[1][2]))), (_e315 + _e315));
                }
                let _e496 = phi_937_;
                let _e502 = select(_e496.member[0][0], -(_e496.member[0][0]), (_e496.member[0][0] < 0f));
                let _e506 = select(_e496.member[0][1], -(_e496.member[0][1]), (_e496.member[0][1] < 0f));
                let _e508 = select(_e506, _e502, (_e502 > _e506));
                let _e512 = select(_e496.member[0][2], -(_e496.member[0][2]), (_e496.member[0][2] < 0f));
                let _e514 = select(_e512, _e508, (_e508 > _e512));
                let _e520 = select(_e496.member[1][0], -(_e496.member[1][0]), (_e496.member[1][0] < 0f));
                let _e524 = select(_e496.member[1][1], -(_e496.member[1][1]), (_e496.member[1][1] < 0f));
                let _e526 = select(_e524, _e520, (_e520 > _e524));
                let _e530 = select(_e496.member[1][2], -(_e496.member[1][2]), (_e496.member[1][2] < 0f));
                let _e532 = select(_e530, _e526, (_e526 > _e530));
                let _e542 = select(_e496.member_1[0][0], -(_e496.member_1[0][0]), (_e496.member_1[0][0] < 0f));
                let _e546 = select(_e496.member_1[0][1], -(_e496.member_1[0][1]), (_e496.member_1[0][1] < 0f));
                let _e548 = select(_e546, _e542, (_e542 > _e546));
                let _e552 = select(_e496.member_1[0][2], -(_e496.member_1[0][2]), (_e496.member_1[0][2] < 0f));
                let _e554 = select(_e552, _e548, (_e548 > _e552));
                let _e560 = select(_e496.member_1[1][0], -(_e496.member_1[1][0]), (_e496.member_1[1][0] < 0f));
                let _e564 = select(_e496.member_1[1][1], -(_e496.member_1[1][1]), (_e496.member_1[1][1] < 0f));
                let _e566 = select(_e564, _e560, (_e560 > _e564));
                let _e570 = select(_e496.member_1[1][2], -(_e496.member_1[1][2]), (_e496.member_1[1][2] < 0f));
                let _e572 = select(_e570, _e566, (_e566 > _e570));
                let _e582 = select(_e496.member_2[0][0], -(_e496.member_2[0][0]), (_e496.member_2[0][0] < 0f));
                let _e586 = select(_e496.member_2[0][1], -(_e496.member_2[0][1]), (_e496.member_2[0][1] < 0f));
                let _e588 = select(_e586, _e582, (_e582 > _e586));
                let _e592 = select(_e496.member_2[0][2], -(_e496.member_2[0][2]), (_e496.member_2[0][2] < 0f));
                let _e594 = select(_e592, _e588, (_e588 > _e592));
                let _e600 = select(_e496.member_2[1][0], -(_e496.member_2[1][0]), (_e496.member_2[1][0] < 0f));
                let _e604 = select(_e496.member_2[1][1], -(_e496.member_2[1][1]), (_e496.member_2[1][1] < 0f));
                let _e606 = select(_e604, _e600, (_e600 > _e604));
                let _e610 = select(_e496.member_2[1][2], -(_e496.member_2[1][2]), (_e496.member_2[1][2] < 0f));
                let _e612 = select(_e610, _e606, (_e606 > _e610));
                let _e617 = function_((select(_e532, _e514, (_e514 > _e532)) + _e496.member_3), (select(_e572, _e554, (_e554 > _e572)) + _e496.member_3));
                let _e618 = function_(_e617, (select(_e612, _e594, (_e594 > _e612)) + _e496.member_3));
                let _e623 = bitcast<i32>(((bitcast<u32>(_e618) + 4u) >> bitcast<u32>(23i)));
                let _e624 = (_e623 >= 64i);
                let _e625 = (_e623 <= 190i);
                let _e631 = select(select(i32(), select(i32(), (_e623 - 126i), _e625), _e624), 2147483647i, select(true, select(true, false, _e625), _e624));
                if (_e631 == 2147483647i) {
                    phi_8772_ = type_9(2u, type_9().member_1);
                } else {
                    let _e634 = params.member.member.member_1;
                    if ((_e634 & 8u) != 0u) {
                        let _e874 = local_32;
                        let _e879 = bitcast<u32>(_e874[0][0]);
                        let _e880 = (_e879 & 2147483647u);
                        let _e881 = (_e880 < 8388608u);
                        let _e892 = function_10(array<u32, 2>(select((_e879 << bitcast<u32>(29i)), 0u, _e881), select(((_e879 ^ _e880) | ((_e880 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e881)), _e631);
                        let _e893 = bitcast<u32>(_e874[0][1]);
                        let _e894 = (_e893 & 2147483647u);
                        let _e895 = (_e894 < 8388608u);
                        let _e906 = function_10(array<u32, 2>(select((_e893 << bitcast<u32>(29i)), 0u, _e895), select(((_e893 ^ _e894) | ((_e894 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e895)), _e631);
                        let _e907 = bitcast<u32>(_e874[0][2]);
                        let _e908 = (_e907 & 2147483647u);
                        let _e909 = (_e908 < 8388608u);
                        let _e920 = function_10(array<u32, 2>(select((_e907 << bitcast<u32>(29i)), 0u, _e909), select(((_e907 ^ _e908) | ((_e908 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e909)), _e631);
                        let _e922 = local_33;
                        let _e927 = bitcast<u32>(_e922[0][0]);
                        let _e928 = (_e927 & 2147483647u);
                        let _e929 = (_e928 < 8388608u);
                        let _e940 = function_10(array<u32, 2>(select((_e927 << bitcast<u32>(29i)), 0u, _e929), select(((_e927 ^ _e928) | ((_e928 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e929)), _e631);
                        let _e941 = bitcast<u32>(_e922[0][1]);
                        let _e942 = (_e941 & 2147483647u);
                        let _e943 = (_e942 < 8388608u);
                        let _e954 = function_10(array<u32, 2>(select((_e941 << bitcast<u32>(29i)), 0u, _e943), select(((_e941 ^ _e942) | ((_e942 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e943)), _e631);
                        let _e955 = bitcast<u32>(_e922[0][2]);
                        let _e956 = (_e955 & 2147483647u);
                        let _e957 = (_e956 < 8388608u);
                        let _e968 = function_10(array<u32, 2>(select((_e955 << bitcast<u32>(29i)), 0u, _e957), select(((_e955 ^ _e956) | ((_e956 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e957)), _e631);
                        let _e971 = local_32;
                        let _e976 = bitcast<u32>(_e971[1][0]);
                        let _e977 = (_e976 & 2147483647u);
                        let _e978 = (_e977 < 8388608u);
                        let _e989 = function_10(array<u32, 2>(select((_e976 << bitcast<u32>(29i)), 0u, _e978), select(((_e976 ^ _e977) | ((_e977 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e978)), _e631);
                        let _e990 = bitcast<u32>(_e971[1][1]);
                        let _e991 = (_e990 & 2147483647u);
                        let _e992 = (_e991 < 8388608u);
                        let _e1003 = function_10(array<u32, 2>(select((_e990 << bitcast<u32>(29i)), 0u, _e992), select(((_e990 ^ _e991) | ((_e991 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e992)), _e631);
                        let _e1004 = bitcast<u32>(_e971[1][2]);
                        let _e1005 = (_e1004 & 2147483647u);
                        let _e1006 = (_e1005 < 8388608u);
                        let _e1017 = function_10(array<u32, 2>(select((_e1004 << bitcast<u32>(29i)), 0u, _e1006), select(((_e1004 ^ _e1005) | ((_e1005 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1006)), _e631);
                        let _e1019 = local_33;
                        let _e1024 = bitcast<u32>(_e1019[1][0]);
                        let _e1025 = (_e1024 & 2147483647u);
                        let _e1026 = (_e1025 < 8388608u);
                        let _e1037 = function_10(array<u32, 2>(select((_e1024 << bitcast<u32>(29i)), 0u, _e1026), select(((_e1024 ^ _e1025) | ((_e1025 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1026)), _e631);
                        let _e1038 = bitcast<u32>(_e1019[1][1]);
                        let _e1039 = (_e1038 & 2147483647u);
                        let _e1040 = (_e1039 < 8388608u);
                        let _e1051 = function_10(array<u32, 2>(select((_e1038 << bitcast<u32>(29i)), 0u, _e1040), select(((_e1038 ^ _e1039) | ((_e1039 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1040)), _e631);
                        let _e1052 = bitcast<u32>(_e1019[1][2]);
                        let _e1053 = (_e1052 & 2147483647u);
                        let _e1054 = (_e1053 < 8388608u);
                        let _e1065 = function_10(array<u32, 2>(select((_e1052 << bitcast<u32>(29i)), 0u, _e1054), select(((_e1052 ^ _e1053) | ((_e1053 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1054)), _e631);
                        let _e1068 = local_32;
                        let _e1073 = bitcast<u32>(_e1068[2][0]);
                        let _e1074 = (_e1073 & 2147483647u);
                        let _e1075 = (_e1074 < 8388608u);
                        let _e1086 = function_10(array<u32, 2>(select((_e1073 << bitcast<u32>(29i)), 0u, _e1075), select(((_e1073 ^ _e1074) | ((_e1074 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1075)), _e631);
                        let _e1087 = bitcast<u32>(_e1068[2][1]);
                        let _e1088 = (_e1087 & 2147483647u);
                        let _e1089 = (_e1088 < 8388608u);
                        let _e1100 = function_10(array<u32, 2>(select((_e1087 << bitcast<u32>(29i)), 0u, _e1089), select(((_e1087 ^ _e1088) | ((_e1088 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1089)), _e631);
                        let _e1101 = bitcast<u32>(_e1068[2][2]);
                        let _e1102 = (_e1101 & 2147483647u);
                        let _e1103 = (_e1102 < 8388608u);
                        let _e1114 = function_10(array<u32, 2>(select((_e1101 << bitcast<u32>(29i)), 0u, _e1103), select(((_e1101 ^ _e1102) | ((_e1102 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1103)), _e631);
                        let _e1116 = local_33;
                        let _e1121 = bitcast<u32>(_e1116[2][0]);
                        let _e1122 = (_e1121 & 2147483647u);
                        let _e1123 = (_e1122 < 8388608u);
                        let _e1134 = function_10(array<u32, 2>(select((_e1121 << bitcast<u32>(29i)), 0u, _e1123), select(((_e1121 ^ _e1122) | ((_e1122 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1123)), _e631);
                        let _e1135 = bitcast<u32>(_e1116[2][1]);
                        let _e1136 = (_e1135 & 2147483647u);
                        let _e1137 = (_e1136 < 8388608u);
                        let _e1148 = function_10(array<u32, 2>(select((_e1135 << bitcast<u32>(29i)), 0u, _e1137), select(((_e1135 ^ _e1136) | ((_e1136 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1137)), _e631);
                        let _e1149 = bitcast<u32>(_e1116[2][2]);
                        let _e1150 = (_e1149 & 2147483647u);
                        let _e1151 = (_e1150 < 8388608u);
                        let _e1162 = function_10(array<u32, 2>(select((_e1149 << bitcast<u32>(29i)), 0u, _e1151), select(((_e1149 ^ _e1150) | ((_e1150 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1151)), _e631);
                        let _e1165 = local_32;
                        let _e1170 = bitcast<u32>(_e1165[3][0]);
                        let _e1171 = (_e1170 & 2147483647u);
                        let _e1172 = (_e1171 < 8388608u);
                        let _e1183 = function_10(array<u32, 2>(select((_e1170 << bitcast<u32>(29i)), 0u, _e1172), select(((_e1170 ^ _e1171) | ((_e1171 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1172)), _e631);
                        let _e1184 = bitcast<u32>(_e1165[3][1]);
                        let _e1185 = (_e1184 & 2147483647u);
                        let _e1186 = (_e1185 < 8388608u);
                        let _e1197 = function_10(array<u32, 2>(select((_e1184 << bitcast<u32>(29i)), 0u, _e1186), select(((_e1184 ^ _e1185) | ((_e1185 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1186)), _e631);
                        let _e1198 = bitcast<u32>(_e1165[3][2]);
                        let _e1199 = (_e1198 & 2147483647u);
                        let _e1200 = (_e1199 < 8388608u);
                        let _e1211 = function_10(array<u32, 2>(select((_e1198 << bitcast<u32>(29i)), 0u, _e1200), select(((_e1198 ^ _e1199) | ((_e1199 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1200)), _e631);
                        let _e1213 = local_33;
                        let _e1218 = bitcast<u32>(_e1213[3][0]);
                        let _e1219 = (_e1218 & 2147483647u);
                        let _e1220 = (_e1219 < 8388608u);
                        let _e1231 = function_10(array<u32, 2>(select((_e1218 << bitcast<u32>(29i)), 0u, _e1220), select(((_e1218 ^ _e1219) | ((_e1219 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1220)), _e631);
                        let _e1232 = bitcast<u32>(_e1213[3][1]);
                        let _e1233 = (_e1232 & 2147483647u);
                        let _e1234 = (_e1233 < 8388608u);
                        let _e1245 = function_10(array<u32, 2>(select((_e1232 << bitcast<u32>(29i)), 0u, _e1234), select(((_e1232 ^ _e1233) | ((_e1233 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1234)), _e631);
                        let _e1246 = bitcast<u32>(_e1213[3][2]);
                        let _e1247 = (_e1246 & 2147483647u);
                        let _e1248 = (_e1247 < 8388608u);
                        let _e1259 = function_10(array<u32, 2>(select((_e1246 << bitcast<u32>(29i)), 0u, _e1248), select(((_e1246 ^ _e1247) | ((_e1247 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1248)), _e631);
                        phi_2640_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e892, _e906, _e920), array<type_9, 3>(_e940, _e954, _e968)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e989, _e1003, _e1017), array<type_9, 3>(_e1037, _e1051, _e1065)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1086, _e1100, _e1114), array<type_9, 3>(_e1134, _e1148, _e1162)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1183, _e1197, _e1211), array<type_9, 3>(_e1231, _e1245, _e1259)));
                    } else {
                        let _e639 = params.member.member.member_10[1u];
                        let _e644 = (_e631 - (bitcast<i32>((_e639 >> bitcast<u32>(20i))) - 1023i));
                        let _e645 = local_31;
                        let _e649 = params.member.member.member[0u];
                        let _e651 = (6u * (_e649 + _e645[0]));
                        let _e652 = (6u * _e645[0]);
                        let _e654 = positions.member[_e652];
                        let _e657 = positions.member[(_e652 + 1u)];
                        let _e659 = function_10(array<u32, 2>(_e654, _e657), _e644);
                        let _e662 = positions.member[(_e652 + 2u)];
                        let _e665 = positions.member[(_e652 + 3u)];
                        let _e667 = function_10(array<u32, 2>(_e662, _e665), _e644);
                        let _e670 = positions.member[(_e652 + 4u)];
                        let _e673 = positions.member[(_e652 + 5u)];
                        let _e675 = function_10(array<u32, 2>(_e670, _e673), _e644);
                        let _e678 = positions.member[_e651];
                        let _e681 = positions.member[(_e651 + 1u)];
                        let _e683 = function_10(array<u32, 2>(_e678, _e681), _e644);
                        let _e686 = positions.member[(_e651 + 2u)];
                        let _e689 = positions.member[(_e651 + 3u)];
                        let _e691 = function_10(array<u32, 2>(_e686, _e689), _e644);
                        let _e694 = positions.member[(_e651 + 4u)];
                        let _e697 = positions.member[(_e651 + 5u)];
                        let _e699 = function_10(array<u32, 2>(_e694, _e697), _e644);
                        let _e702 = local_31;
                        let _e706 = params.member.member.member[0u];
                        let _e708 = (6u * (_e706 + _e702[1]));
                        let _e709 = (6u * _e702[1]);
                        let _e711 = positions.member[_e709];
                        let _e714 = positions.member[(_e709 + 1u)];
                        let _e716 = function_10(array<u32, 2>(_e711, _e714), _e644);
                        let _e719 = positions.member[(_e709 + 2u)];
                        let _e722 = positions.member[(_e709 + 3u)];
                        let _e724 = function_10(array<u32, 2>(_e719, _e722), _e644);
                        let _e727 = positions.member[(_e709 + 4u)];
                        let _e730 = positions.member[(_e709 + 5u)];
                        let _e732 = function_10(array<u32, 2>(_e727, _e730), _e644);
                        let _e735 = positions.member[_e708];
                        let _e738 = positions.member[(_e708 + 1u)];
                        let _e740 = function_10(array<u32, 2>(_e735, _e738), _e644);
                        let _e743 = positions.member[(_e708 + 2u)];
                        let _e746 = positions.member[(_e708 + 3u)];
                        let _e748 = function_10(array<u32, 2>(_e743, _e746), _e644);
                        let _e751 = positions.member[(_e708 + 4u)];
                        let _e754 = positions.member[(_e708 + 5u)];
                        let _e756 = function_10(array<u32, 2>(_e751, _e754), _e644);
                        let _e759 = local_31;
                        let _e763 = params.member.member.member[0u];
                        let _e765 = (6u * (_e763 + _e759[2]));
                        let _e766 = (6u * _e759[2]);
                        let _e768 = positions.member[_e766];
                        let _e771 = positions.member[(_e766 + 1u)];
                        let _e773 = function_10(array<u32, 2>(_e768, _e771), _e644);
                        let _e776 = positions.member[(_e766 + 2u)];
                        let _e779 = positions.member[(_e766 + 3u)];
                        let _e781 = function_10(array<u32, 2>(_e776, _e779), _e644);
                        let _e784 = positions.member[(_e766 + 4u)];
                        let _e787 = positions.member[(_e766 + 5u)];
                        let _e789 = function_10(array<u32, 2>(_e784, _e787), _e644);
                        let _e792 = positions.member[_e765];
                        let _e795 = positions.member[(_e765 + 1u)];
                        let _e797 = function_10(array<u32, 2>(_e792, _e795), _e644);
                        let _e800 = positions.member[(_e765 + 2u)];
                        let _e803 = positions.member[(_e765 + 3u)];
                        let _e805 = function_10(array<u32, 2>(_e800, _e803), _e644);
                        let _e808 = positions.member[(_e765 + 4u)];
                        let _e811 = positions.member[(_e765 + 5u)];
                        let _e813 = function_10(array<u32, 2>(_e808, _e811), _e644);
                        let _e816 = local_31;
                        let _e820 = params.member.member.member[0u];
                        let _e822 = (6u * (_e820 + _e816[3]));
                        let _e823 = (6u * _e816[3]);
                        let _e825 = positions.member[_e823];
                        let _e828 = positions.member[(_e823 + 1u)];
                        let _e830 = function_10(array<u32, 2>(_e825, _e828), _e644);
                        let _e833 = positions.member[(_e823 + 2u)];
                        let _e836 = positions.member[(_e823 + 3u)];
                        let _e838 = function_10(array<u32, 2>(_e833, _e836), _e644);
                        let _e841 = positions.member[(_e823 + 4u)];
                        let _e844 = positions.member[(_e823 + 5u)];
                        let _e846 = function_10(array<u32, 2>(_e841, _e844), _e644);
                        let _e849 = positions.member[_e822];
                        let _e852 = positions.member[(_e822 + 1u)];
                        let _e854 = function_10(array<u32, 2>(_e849, _e852), _e644);
                        let _e857 = positions.member[(_e822 + 2u)];
                        let _e860 = positions.member[(_e822 + 3u)];
                        let _e862 = function_10(array<u32, 2>(_e857, _e860), _e644);
                        let _e865 = positions.member[(_e822 + 4u)];
                        let _e868 = positions.member[(_e822 + 5u)];
                        let _e870 = function_10(array<u32, 2>(_e865, _e868), _e644);
                        phi_2640_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e659, _e667, _e675), array<type_9, 3>(_e683, _e691, _e699)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e716, _e724, _e732), array<type_9, 3>(_e740, _e748, _e756)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e773, _e781, _e789), array<type_9, 3>(_e797, _e805, _e813)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e830, _e838, _e846), array<type_9, 3>(_e854, _e862, _e870)));
                    }
                    let _e1264 = phi_2640_;
                    let _e1266 = params.member.member_2.member_1;
                    let _e1268 = params.member.member_2.member_2;
                    let _e1270 = params.member.member_2.member_3;
                    if (_e240.member != 0u) {
                        phi_3187_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[2][0][0].member - _e1264[0][0][0].member) - select(0u, 1u, (_e1264[2][0][0].member_1 < _e1264[0][0][0].member_1))), (_e1264[2][0][0].member_1 - _e1264[0][0][0].member_1)), type_9(((_e1264[2][0][1].member - _e1264[0][0][1].member) - select(0u, 1u, (_e1264[2][0][1].member_1 < _e1264[0][0][1].member_1))), (_e1264[2][0][1].member_1 - _e1264[0][0][1].member_1)), type_9(((_e1264[2][0][2].member - _e1264[0][0][2].member) - select(0u, 1u, (_e1264[2][0][2].member_1 < _e1264[0][0][2].member_1))), (_e1264[2][0][2].member_1 - _e1264[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[2][1][0].member - _e1264[0][1][0].member) - select(0u, 1u, (_e1264[2][1][0].member_1 < _e1264[0][1][0].member_1))), (_e1264[2][1][0].member_1 - _e1264[0][1][0].member_1)), type_9(((_e1264[2][1][1].member - _e1264[0][1][1].member) - select(0u, 1u, (_e1264[2][1][1].member_1 < _e1264[0][1][1].member_1))), (_e1264[2][1][1].member_1 - _e1264[0][1][1].member_1)), type_9(((_e1264[2][1][2].member - _e1264[0][1][2].member) - select(0u, 1u, (_e1264[2][1][2].member_1 < _e1264[0][1][2].member_1))), (_e1264[2][1][2].member_1 - _e1264[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[1][0][0].member - _e1264[0][0][0].member) - select(0u, 1u, (_e1264[1][0][0].member_1 < _e1264[0][0][0].member_1))), (_e1264[1][0][0].member_1 - _e1264[0][0][0].member_1)), type_9(((_e1264[1][0][1].member - _e1264[0][0][1].member) - select(0u, 1u, (_e1264[1][0][1].member_1 < _e1264[0][0][1].member_1))), (_e1264[1][0][1].member_1 - _e1264[0][0][1].member_1)), type_9(((_e1264[1][0][2].member - _e1264[0][0][2].member) - select(0u, 1u, (_e1264[1][0][2].member_1 < _e1264[0][0][2].member_1))), (_e1264[1][0][2].member_1 - _e1264[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[1][1][0].member - _e1264[0][1][0].member) - select(0u, 1u, (_e1264[1][1][0].member_1 < _e1264[0][1][0].member_1))), (_e1264[1][1][0].member_1 - _e1264[0][1][0].member_1)), type_9(((_e1264[1][1][1].member - _e1264[0][1][1].member) - select(0u, 1u, (_e1264[1][1][1].member_1 < _e1264[0][1][1].member_1))), (_e1264[1][1][1].member_1 - _e1264[0][1][1].member_1)), type_9(((_e1264[1][1][2].member - _e1264[0][1][2].member) - select(0u, 1u, (_e1264[1][1][2].member_1 < _e1264[0][1][2].member_1))), (_e1264[1][1][2].member_1 - _e1264[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[2][0][0].member - _e1264[3][0][0].member) - select(0u, 1u, (_e1264[2][0][0].member_1 < _e1264[3][0][0].member_1))), (_e1264[2][0][0].member_1 - _e1264[3][0][0].member_1)), type_9(((_e1264[2][0][1].member - _e1264[3][0][1].member) - select(0u, 1u, (_e1264[2][0][1].member_1 < _e1264[3][0][1].member_1))), (_e1264[2][0][1].member_1 - _e1264[3][0][1].member_1)), type_9(((_e1264[2][0][2].member - _e1264[3][0][2].member) - select(0u, 1u, (_e1264[2][0][2].member_1 < _e1264[3][0][2].member_1))), (_e1264[2][0][2].member_1 - _e1264[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[2][1][0].member - _e1264[3][1][0].member) - select(0u, 1u, (_e1264[2][1][0].member_1 < _e1264[3][1][0].member_1))), (_e1264[2][1][0].member_1 - _e1264[3][1][0].member_1)), type_9(((_e1264[2][1][1].member - _e1264[3][1][1].member) - select(0u, 1u, (_e1264[2][1][1].member_1 < _e1264[3][1][1].member_1))), (_e1264[2][1][1].member_1 - _e1264[3][1][1].member_1)), type_9(((_e1264[2][1][2].member - _e1264[3][1][2].member) - select(0u, 1u, (_e1264[2][1][2].member_1 < _e1264[3][1][2].member_1))), (_e1264[2][1][2].member_1 - _e1264[3][1][2].member_1)))));
                    } else {
                        phi_3187_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[0][0][0].member - _e1264[1][0][0].member) - select(0u, 1u, (_e1264[0][0][0].member_1 < _e1264[1][0][0].member_1))), (_e1264[0][0][0].member_1 - _e1264[1][0][0].member_1)), type_9(((_e1264[0][0][1].member - _e1264[1][0][1].member) - select(0u, 1u, (_e1264[0][0][1].member_1 < _e1264[1][0][1].member_1))), (_e1264[0][0][1].member_1 - _e1264[1][0][1].member_1)), type_9(((_e1264[0][0][2].member - _e1264[1][0][2].member) - select(0u, 1u, (_e1264[0][0][2].member_1 < _e1264[1][0][2].member_1))), (_e1264[0][0][2].member_1 - _e1264[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[0][1][0].member - _e1264[1][1][0].member) - select(0u, 1u, (_e1264[0][1][0].member_1 < _e1264[1][1][0].member_1))), (_e1264[0][1][0].member_1 - _e1264[1][1][0].member_1)), type_9(((_e1264[0][1][1].member - _e1264[1][1][1].member) - select(0u, 1u, (_e1264[0][1][1].member_1 < _e1264[1][1][1].member_1))), (_e1264[0][1][1].member_1 - _e1264[1][1][1].member_1)), type_9(((_e1264[0][1][2].member - _e1264[1][1][2].member) - select(0u, 1u, (_e1264[0][1][2].member_1 < _e1264[1][1][2].member_1))), (_e1264[0][1][2].member_1 - _e1264[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[2][0][0].member - _e1264[1][0][0].member) - select(0u, 1u, (_e1264[2][0][0].member_1 < _e1264[1][0][0].member_1))), (_e1264[2][0][0].member_1 - _e1264[1][0][0].member_1)), type_9(((_e1264[2][0][1].member - _e1264[1][0][1].member) - select(0u, 1u, (_e1264[2][0][1].member_1 < _e1264[1][0][1].member_1))), (_e1264[2][0][1].member_1 - _e1264[1][0][1].member_1)), type_9(((_e1264[2][0][2].member - _e1264[1][0][2].member) - select(0u, 1u, (_e1264[2][0][2].member_1 < _e1264[1][0][2].member_1))), (_e1264[2][0][2].member_1 - _e1264[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[2][1][0].member - _e1264[1][1][0].member) - select(0u, 1u, (_e1264[2][1][0].member_1 < _e1264[1][1][0].member_1))), (_e1264[2][1][0].member_1 - _e1264[1][1][0].member_1)), type_9(((_e1264[2][1][1].member - _e1264[1][1][1].member) - select(0u, 1u, (_e1264[2][1][1].member_1 < _e1264[1][1][1].member_1))), (_e1264[2][1][1].member_1 - _e1264[1][1][1].member_1)), type_9(((_e1264[2][1][2].member - _e1264[1][1][2].member) - select(0u, 1u, (_e1264[2][1][2].member_1 < _e1264[1][1][2].member_1))), (_e1264[2][1][2].member_1 - _e1264[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1264[3][0][0].member - _e1264[1][0][0].member) - select(0u, 1u, (_e1264[3][0][0].member_1 < _e1264[1][0][0].member_1))), (_e1264[3][0][0].member_1 - _e1264[1][0][0].member_1)), type_9(((_e1264[3][0][1].member - _e1264[1][0][1].member) - select(0u, 1u, (_e1264[3][0][1].member_1 < _e1264[1][0][1].member_1))), (_e1264[3][0][1].member_1 - _e1264[1][0][1].member_1)), type_9(((_e1264[3][0][2].member - _e1264[1][0][2].member) - select(0u, 1u, (_e1264[3][0][2].member_1 < _e1264[1][0][2].member_1))), (_e1264[3][0][2].member_1 - _e1264[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1264[3][1][0].member - _e1264[1][1][0].member) - select(0u, 1u, (_e1264[3][1][0].member_1 < _e1264[1][1][0].member_1))), (_e1264[3][1][0].member_1 - _e1264[1][1][0].member_1)), type_9(((_e1264[3][1][1].member - _e1264[1][1][1].member) - select(0u, 1u, (_e1264[3][1][1].member_1 < _e1264[1][1][1].member_1))), (_e1264[3][1][1].member_1 - _e1264[1][1][1].member_1)), type_9(((_e1264[3][1][2].member - _e1264[1][1][2].member) - select(0u, 1u, (_e1264[3][1][2].member_1 < _e1264[1][1][2].member_1))), (_e1264[3][1][2].member_1 - _e1264[1][1][2].member_1)))));
                    }
                    let _e1845 = phi_3187_;
                    local_29 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_30 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e1878 = local_29[1u].member;
                    let _e1880 = local_29[1u].member_1;
                    let _e1883 = local_30[2u].member;
                    let _e1885 = local_30[2u].member_1;
                    let _e1886 = function_5(_e1878, _e1880, _e1883, _e1885);
                    let _e1891 = local_29[2u].member;
                    let _e1893 = local_29[2u].member_1;
                    let _e1896 = local_30[1u].member;
                    let _e1898 = local_30[1u].member_1;
                    let _e1899 = function_5(_e1891, _e1893, _e1896, _e1898);
                    let _e1905 = ((_e1886.member - _e1899.member) - select(0u, 1u, (_e1886.member_1 < _e1899.member_1)));
                    let _e1906 = (_e1886.member_1 - _e1899.member_1);
                    local_27 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_28 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e1935 = local_27[2u].member;
                    let _e1937 = local_27[2u].member_1;
                    let _e1940 = local_28[0u].member;
                    let _e1942 = local_28[0u].member_1;
                    let _e1943 = function_5(_e1935, _e1937, _e1940, _e1942);
                    let _e1948 = local_27[0u].member;
                    let _e1950 = local_27[0u].member_1;
                    let _e1953 = local_28[2u].member;
                    let _e1955 = local_28[2u].member_1;
                    let _e1956 = function_5(_e1948, _e1950, _e1953, _e1955);
                    let _e1962 = ((_e1943.member - _e1956.member) - select(0u, 1u, (_e1943.member_1 < _e1956.member_1)));
                    let _e1963 = (_e1943.member_1 - _e1956.member_1);
                    local_25 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_26 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e1992 = local_25[0u].member;
                    let _e1994 = local_25[0u].member_1;
                    let _e1997 = local_26[1u].member;
                    let _e1999 = local_26[1u].member_1;
                    let _e2000 = function_5(_e1992, _e1994, _e1997, _e1999);
                    let _e2005 = local_25[1u].member;
                    let _e2007 = local_25[1u].member_1;
                    let _e2010 = local_26[0u].member;
                    let _e2012 = local_26[0u].member_1;
                    let _e2013 = function_5(_e2005, _e2007, _e2010, _e2012);
                    let _e2019 = ((_e2000.member - _e2013.member) - select(0u, 1u, (_e2000.member_1 < _e2013.member_1)));
                    let _e2020 = (_e2000.member_1 - _e2013.member_1);
                    local_23 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_24 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2053 = local_23[1u].member;
                    let _e2055 = local_23[1u].member_1;
                    let _e2058 = local_24[2u].member;
                    let _e2060 = local_24[2u].member_1;
                    let _e2061 = function_5(_e2053, _e2055, _e2058, _e2060);
                    let _e2066 = local_23[2u].member;
                    let _e2068 = local_23[2u].member_1;
                    let _e2071 = local_24[1u].member;
                    let _e2073 = local_24[1u].member_1;
                    let _e2074 = function_5(_e2066, _e2068, _e2071, _e2073);
                    let _e2080 = ((_e2061.member - _e2074.member) - select(0u, 1u, (_e2061.member_1 < _e2074.member_1)));
                    let _e2081 = (_e2061.member_1 - _e2074.member_1);
                    local_21 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_22 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2110 = local_21[2u].member;
                    let _e2112 = local_21[2u].member_1;
                    let _e2115 = local_22[0u].member;
                    let _e2117 = local_22[0u].member_1;
                    let _e2118 = function_5(_e2110, _e2112, _e2115, _e2117);
                    let _e2123 = local_21[0u].member;
                    let _e2125 = local_21[0u].member_1;
                    let _e2128 = local_22[2u].member;
                    let _e2130 = local_22[2u].member_1;
                    let _e2131 = function_5(_e2123, _e2125, _e2128, _e2130);
                    let _e2137 = ((_e2118.member - _e2131.member) - select(0u, 1u, (_e2118.member_1 < _e2131.member_1)));
                    let _e2138 = (_e2118.member_1 - _e2131.member_1);
                    local_19 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_20 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2167 = local_19[0u].member;
                    let _e2169 = local_19[0u].member_1;
                    let _e2172 = local_20[1u].member;
                    let _e2174 = local_20[1u].member_1;
                    let _e2175 = function_5(_e2167, _e2169, _e2172, _e2174);
                    let _e2180 = local_19[1u].member;
                    let _e2182 = local_19[1u].member_1;
                    let _e2185 = local_20[0u].member;
                    let _e2187 = local_20[0u].member_1;
                    let _e2188 = function_5(_e2180, _e2182, _e2185, _e2187);
                    let _e2194 = ((_e2175.member - _e2188.member) - select(0u, 1u, (_e2175.member_1 < _e2188.member_1)));
                    let _e2195 = (_e2175.member_1 - _e2188.member_1);
                    local_17 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_18 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2228 = local_17[1u].member;
                    let _e2230 = local_17[1u].member_1;
                    let _e2233 = local_18[2u].member;
                    let _e2235 = local_18[2u].member_1;
                    let _e2236 = function_5(_e2228, _e2230, _e2233, _e2235);
                    let _e2241 = local_17[2u].member;
                    let _e2243 = local_17[2u].member_1;
                    let _e2246 = local_18[1u].member;
                    let _e2248 = local_18[1u].member_1;
                    let _e2249 = function_5(_e2241, _e2243, _e2246, _e2248);
                    let _e2256 = (_e2236.member_1 - _e2249.member_1);
                    local_15 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_16 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2285 = local_15[2u].member;
                    let _e2287 = local_15[2u].member_1;
                    let _e2290 = local_16[0u].member;
                    let _e2292 = local_16[0u].member_1;
                    let _e2293 = function_5(_e2285, _e2287, _e2290, _e2292);
                    let _e2298 = local_15[0u].member;
                    let _e2300 = local_15[0u].member_1;
                    let _e2303 = local_16[2u].member;
                    let _e2305 = local_16[2u].member_1;
                    let _e2306 = function_5(_e2298, _e2300, _e2303, _e2305);
                    let _e2313 = (_e2293.member_1 - _e2306.member_1);
                    local_13 = array<type_9, 3>(type_9(_e1845[1][0][0].member, _e1845[1][0][0].member_1), type_9(_e1845[1][0][1].member, _e1845[1][0][1].member_1), type_9(_e1845[1][0][2].member, _e1845[1][0][2].member_1));
                    local_14 = array<type_9, 3>(type_9(_e1845[2][1][0].member, _e1845[2][1][0].member_1), type_9(_e1845[2][1][1].member, _e1845[2][1][1].member_1), type_9(_e1845[2][1][2].member, _e1845[2][1][2].member_1));
                    let _e2342 = local_13[0u].member;
                    let _e2344 = local_13[0u].member_1;
                    let _e2347 = local_14[1u].member;
                    let _e2349 = local_14[1u].member_1;
                    let _e2350 = function_5(_e2342, _e2344, _e2347, _e2349);
                    let _e2355 = local_13[1u].member;
                    let _e2357 = local_13[1u].member_1;
                    let _e2360 = local_14[0u].member;
                    let _e2362 = local_14[0u].member_1;
                    let _e2363 = function_5(_e2355, _e2357, _e2360, _e2362);
                    let _e2370 = (_e2350.member_1 - _e2363.member_1);
                    local_11 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_12 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e2403 = local_11[1u].member;
                    let _e2405 = local_11[1u].member_1;
                    let _e2408 = local_12[2u].member;
                    let _e2410 = local_12[2u].member_1;
                    let _e2411 = function_5(_e2403, _e2405, _e2408, _e2410);
                    let _e2416 = local_11[2u].member;
                    let _e2418 = local_11[2u].member_1;
                    let _e2421 = local_12[1u].member;
                    let _e2423 = local_12[1u].member_1;
                    let _e2424 = function_5(_e2416, _e2418, _e2421, _e2423);
                    local_9 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_10 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e2460 = local_9[2u].member;
                    let _e2462 = local_9[2u].member_1;
                    let _e2465 = local_10[0u].member;
                    let _e2467 = local_10[0u].member_1;
                    let _e2468 = function_5(_e2460, _e2462, _e2465, _e2467);
                    let _e2473 = local_9[0u].member;
                    let _e2475 = local_9[0u].member_1;
                    let _e2478 = local_10[2u].member;
                    let _e2480 = local_10[2u].member_1;
                    let _e2481 = function_5(_e2473, _e2475, _e2478, _e2480);
                    local_7 = array<type_9, 3>(type_9(_e1845[1][1][0].member, _e1845[1][1][0].member_1), type_9(_e1845[1][1][1].member, _e1845[1][1][1].member_1), type_9(_e1845[1][1][2].member, _e1845[1][1][2].member_1));
                    local_8 = array<type_9, 3>(type_9(_e1845[2][0][0].member, _e1845[2][0][0].member_1), type_9(_e1845[2][0][1].member, _e1845[2][0][1].member_1), type_9(_e1845[2][0][2].member, _e1845[2][0][2].member_1));
                    let _e2517 = local_7[0u].member;
                    let _e2519 = local_7[0u].member_1;
                    let _e2522 = local_8[1u].member;
                    let _e2524 = local_8[1u].member_1;
                    let _e2525 = function_5(_e2517, _e2519, _e2522, _e2524);
                    let _e2530 = local_7[1u].member;
                    let _e2532 = local_7[1u].member_1;
                    let _e2535 = local_8[0u].member;
                    let _e2537 = local_8[0u].member_1;
                    let _e2538 = function_5(_e2530, _e2532, _e2535, _e2537);
                    let _e2546 = (_e2256 + (_e2411.member_1 - _e2424.member_1));
                    let _e2550 = ((((_e2236.member - _e2249.member) - select(0u, 1u, (_e2236.member_1 < _e2249.member_1))) + ((_e2411.member - _e2424.member) - select(0u, 1u, (_e2411.member_1 < _e2424.member_1)))) + select(0u, 1u, (_e2546 < _e2256)));
                    let _e2551 = (_e2313 + (_e2468.member_1 - _e2481.member_1));
                    let _e2555 = ((((_e2293.member - _e2306.member) - select(0u, 1u, (_e2293.member_1 < _e2306.member_1))) + ((_e2468.member - _e2481.member) - select(0u, 1u, (_e2468.member_1 < _e2481.member_1)))) + select(0u, 1u, (_e2551 < _e2313)));
                    let _e2556 = (_e2370 + (_e2525.member_1 - _e2538.member_1));
                    let _e2560 = ((((_e2350.member - _e2363.member) - select(0u, 1u, (_e2350.member_1 < _e2363.member_1))) + ((_e2525.member - _e2538.member) - select(0u, 1u, (_e2525.member_1 < _e2538.member_1)))) + select(0u, 1u, (_e2556 < _e2370)));
                    let _e2567 = function_5(_e1845[0][0][0].member, _e1845[0][0][0].member_1, _e1905, _e1906);
                    let _e2574 = function_5(_e1845[0][0][1].member, _e1845[0][0][1].member_1, _e1962, _e1963);
                    let _e2577 = (_e2567.member_1 + _e2574.member_1);
                    let _e2586 = function_5(_e1845[0][0][2].member, _e1845[0][0][2].member_1, _e2019, _e2020);
                    let _e2589 = (_e2577 + _e2586.member_1);
                    let _e2594 = function_9(((((_e2567.member + _e2574.member) + select(0u, 1u, (_e2577 < _e2567.member_1))) + _e2586.member) + select(0u, 1u, (_e2589 < _e2577))), _e2589);
                    let _e2603 = function_5(_e1845[0][1][0].member, _e1845[0][1][0].member_1, _e1905, _e1906);
                    let _e2610 = function_5(_e1845[0][1][1].member, _e1845[0][1][1].member_1, _e1962, _e1963);
                    let _e2613 = (_e2603.member_1 + _e2610.member_1);
                    let _e2622 = function_5(_e1845[0][1][2].member, _e1845[0][1][2].member_1, _e2019, _e2020);
                    let _e2625 = (_e2613 + _e2622.member_1);
                    let _e2636 = function_5(_e1845[0][0][0].member, _e1845[0][0][0].member_1, _e2550, _e2546);
                    let _e2643 = function_5(_e1845[0][0][1].member, _e1845[0][0][1].member_1, _e2555, _e2551);
                    let _e2646 = (_e2636.member_1 + _e2643.member_1);
                    let _e2655 = function_5(_e1845[0][0][2].member, _e1845[0][0][2].member_1, _e2560, _e2556);
                    let _e2658 = (_e2646 + _e2655.member_1);
                    let _e2663 = (_e2625 + _e2658);
                    let _e2667 = ((((((_e2603.member + _e2610.member) + select(0u, 1u, (_e2613 < _e2603.member_1))) + _e2622.member) + select(0u, 1u, (_e2625 < _e2613))) + ((((_e2636.member + _e2643.member) + select(0u, 1u, (_e2646 < _e2636.member_1))) + _e2655.member) + select(0u, 1u, (_e2658 < _e2646)))) + select(0u, 1u, (_e2663 < _e2625)));
                    let _e2674 = function_5(_e1845[0][0][0].member, _e1845[0][0][0].member_1, _e2080, _e2081);
                    let _e2681 = function_5(_e1845[0][0][1].member, _e1845[0][0][1].member_1, _e2137, _e2138);
                    let _e2684 = (_e2674.member_1 + _e2681.member_1);
                    let _e2693 = function_5(_e1845[0][0][2].member, _e1845[0][0][2].member_1, _e2194, _e2195);
                    let _e2696 = (_e2684 + _e2693.member_1);
                    let _e2707 = function_5(_e1845[0][1][0].member, _e1845[0][1][0].member_1, _e2550, _e2546);
                    let _e2714 = function_5(_e1845[0][1][1].member, _e1845[0][1][1].member_1, _e2555, _e2551);
                    let _e2717 = (_e2707.member_1 + _e2714.member_1);
                    let _e2726 = function_5(_e1845[0][1][2].member, _e1845[0][1][2].member_1, _e2560, _e2556);
                    let _e2729 = (_e2717 + _e2726.member_1);
                    let _e2734 = (_e2696 + _e2729);
                    let _e2738 = ((((((_e2674.member + _e2681.member) + select(0u, 1u, (_e2684 < _e2674.member_1))) + _e2693.member) + select(0u, 1u, (_e2696 < _e2684))) + ((((_e2707.member + _e2714.member) + select(0u, 1u, (_e2717 < _e2707.member_1))) + _e2726.member) + select(0u, 1u, (_e2729 < _e2717)))) + select(0u, 1u, (_e2734 < _e2696)));
                    let _e2745 = function_5(_e1845[0][1][0].member, _e1845[0][1][0].member_1, _e2080, _e2081);
                    let _e2752 = function_5(_e1845[0][1][1].member, _e1845[0][1][1].member_1, _e2137, _e2138);
                    let _e2755 = (_e2745.member_1 + _e2752.member_1);
                    let _e2764 = function_5(_e1845[0][1][2].member, _e1845[0][1][2].member_1, _e2194, _e2195);
                    let _e2767 = (_e2755 + _e2764.member_1);
                    let _e2772 = function_9(((((_e2745.member + _e2752.member) + select(0u, 1u, (_e2755 < _e2745.member_1))) + _e2764.member) + select(0u, 1u, (_e2767 < _e2755))), _e2767);
                    let _e2782 = select((bitcast<u32>(31i) - firstLeadingBit(_e1270)), 32u, (_e1270 == 0u));
                    let _e2784 = select(18u, _e2782, (18u < _e2782));
                    phi_4491_ = array<type_9, 4>(_e2594, type_9(_e2667, _e2663), type_9(_e2738, _e2734), _e2772);
                    phi_4494_ = false;
                    phi_4496_ = false;
                    phi_4498_ = false;
                    phi_4500_ = false;
                    phi_4502_ = type_17(0u, 0u, 0u);
                    phi_4506_ = 0u;
                    phi_4508_ = 0u;
                    phi_4510_ = 0u;
                    phi_4512_ = 0u;
                    phi_4514_ = 0u;
                    loop {
                        let _e2786 = phi_4491_;
                        let _e2788 = phi_4494_;
                        let _e2790 = phi_4496_;
                        let _e2792 = phi_4498_;
                        let _e2794 = phi_4500_;
                        let _e2796 = phi_4502_;
                        let _e2798 = phi_4506_;
                        let _e2800 = phi_4508_;
                        let _e2802 = phi_4510_;
                        let _e2804 = phi_4512_;
                        let _e2806 = phi_4514_;
                        if (_e2802 < 64u) {
                            phi_4523_ = _e2786;
                            phi_4526_ = _e2792;
                            phi_4528_ = _e2794;
                            phi_4532_ = _e2788;
                            phi_4534_ = false;
                            phi_4536_ = false;
                            phi_4538_ = false;
                            phi_4540_ = _e2798;
                            phi_4542_ = _e2800;
                            phi_4544_ = _e2802;
                            phi_4546_ = _e2804;
                            phi_4548_ = _e2806;
                            loop {
                                let _e2809 = phi_4523_;
                                let _e2811 = phi_4526_;
                                let _e2813 = phi_4528_;
                                let _e2815 = phi_4532_;
                                let _e2817 = phi_4534_;
                                let _e2819 = phi_4536_;
                                let _e2821 = phi_4538_;
                                let _e2823 = phi_4540_;
                                let _e2825 = phi_4542_;
                                let _e2827 = phi_4544_;
                                let _e2829 = phi_4546_;
                                let _e2831 = phi_4548_;
                                local_34 = _e2815;
                                local_35 = _e2821;
                                local_36 = _e2809;
                                local_37 = _e2809;
                                local_38 = _e2809;
                                local_39 = _e2809;
                                local_40 = _e2809;
                                local_41 = _e2809;
                                local_42 = _e2809;
                                local_43 = _e2809;
                                local_44 = _e2809;
                                local_45 = _e2809;
                                local_46 = _e2809;
                                local_47 = _e2809;
                                local_48 = _e2829;
                                local_49 = _e2825;
                                local_50 = _e2823;
                                local_51 = _e2829;
                                local_52 = _e2809;
                                local_53 = _e2809;
                                local_54 = _e2809;
                                local_55 = _e2809;
                                local_56 = _e2809;
                                local_57 = _e2809;
                                local_58 = _e2817;
                                local_59 = _e2817;
                                local_60 = _e2829;
                                local_61 = _e2819;
                                local_62 = _e2829;
                                local_63 = _e2809;
                                local_64 = _e2809;
                                local_65 = _e2809;
                                local_66 = _e2825;
                                local_67 = _e2825;
                                local_68 = _e2809;
                                local_69 = _e2809;
                                local_70 = _e2809;
                                local_71 = _e2825;
                                local_72 = _e2823;
                                local_73 = _e2809;
                                local_74 = _e2809;
                                local_75 = _e2809;
                                local_76 = _e2809;
                                local_77 = _e2809;
                                local_78 = _e2809;
                                local_79 = _e2809;
                                local_80 = _e2809;
                                local_82 = _e2825;
                                local_83 = _e2823;
                                local_84 = _e2829;
                                local_85 = _e2825;
                                local_86 = _e2825;
                                local_87 = _e2817;
                                local_109 = _e2821;
                                local_110 = _e2811;
                                local_111 = _e2813;
                                local_112 = _e2821;
                                local_113 = _e2811;
                                local_114 = _e2813;
                                local_115 = _e2821;
                                local_88 = _e2831;
                                local_89 = _e2831;
                                local_90 = _e2829;
                                local_91 = _e2829;
                                local_92 = _e2829;
                                local_93 = _e2825;
                                local_116 = _e2829;
                                local_117 = _e2831;
                                local_118 = _e2809;
                                local_119 = _e2823;
                                local_120 = _e2825;
                                local_121 = _e2827;
                                if (_e2827 < 64u) {
                                    if _e2821 {
                                        phi_5426_ = array<type_9, 4>();
                                        phi_5427_ = bool();
                                        phi_5428_ = bool();
                                        phi_5430_ = bool();
                                        phi_5431_ = bool();
                                        phi_5432_ = bool();
                                        phi_5433_ = bool();
                                        phi_5434_ = u32();
                                        phi_5435_ = u32();
                                        phi_5436_ = u32();
                                        phi_5437_ = u32();
                                        phi_5438_ = u32();
                                        phi_5439_ = false;
                                    } else {
                                        if _e2815 {
                                            phi_5412_ = array<type_9, 4>();
                                            phi_5413_ = bool();
                                            phi_5414_ = bool();
                                            phi_5416_ = bool();
                                            phi_5417_ = bool();
                                            phi_5418_ = bool();
                                            phi_5419_ = bool();
                                            phi_5420_ = u32();
                                            phi_5421_ = u32();
                                            phi_5422_ = u32();
                                            phi_5423_ = u32();
                                            phi_5424_ = u32();
                                            phi_5425_ = false;
                                        } else {
                                            let _e2834 = (31u - _e2829);
                                            let _e2837 = (_e2831 << bitcast<u32>((_e2834 & 31u)));
                                            let _e2841 = ((_e2831 + 1u) << bitcast<u32>((_e2834 & 31u)));
                                            if (_e2837 > _e1268) {
                                                phi_4754_ = bool();
                                                phi_4755_ = true;
                                            } else {
                                                let _e2843 = (_e2841 < _e1266);
                                                if _e2843 {
                                                    phi_4753_ = bool();
                                                } else {
                                                    let _e2848 = function_8(128u);
                                                    let _e2853 = ((_e2809[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2881 = function_8(128u);
                                                    let _e2886 = ((_e2809[1].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2915 = function_8(128u);
                                                    let _e2920 = ((_e2809[2].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e2949 = function_8(128u);
                                                    let _e2954 = ((_e2809[3].member >> bitcast<u32>(31i)) != 0u);
                                                    phi_4753_ = ((((select(0u, select(1u, 2u, ((_e2809[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2848.member - select(_e2809[0].member, (~(_e2809[0].member) + select(0u, 1u, (_e2809[0].member_1 == 0u))), _e2853)) - select(0u, 1u, (_e2848.member_1 < select(_e2809[0].member_1, (~(_e2809[0].member_1) + 1u), _e2853)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2809[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2881.member - select(_e2809[1].member, (~(_e2809[1].member) + select(0u, 1u, (_e2809[1].member_1 == 0u))), _e2886)) - select(0u, 1u, (_e2881.member_1 < select(_e2809[1].member_1, (~(_e2809[1].member_1) + 1u), _e2886)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2809[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2915.member - select(_e2809[2].member, (~(_e2809[2].member) + select(0u, 1u, (_e2809[2].member_1 == 0u))), _e2920)) - select(0u, 1u, (_e2915.member_1 < select(_e2809[2].member_1, (~(_e2809[2].member_1) + 1u), _e2920)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2809[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2949.member - select(_e2809[3].member, (~(_e2809[3].member) + select(0u, 1u, (_e2809[3].member_1 == 0u))), _e2954)) - select(0u, 1u, (_e2949.member_1 < select(_e2809[3].member_1, (~(_e2809[3].member_1) + 1u), _e2954)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                }
                                                let _e2981 = phi_4753_;
                                                phi_4754_ = _e2981;
                                                phi_4755_ = _e2843;
                                            }
                                            let _e2983 = phi_4754_;
                                            let _e2985 = phi_4755_;
                                            let _e2986 = select(_e2983, true, _e2985);
                                            let _e2991 = function_8(128u);
                                            let _e2996 = ((_e2809[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3019 = select(0u, select(1u, 2u, ((_e2809[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2991.member - select(_e2809[0].member, (~(_e2809[0].member) + select(0u, 1u, (_e2809[0].member_1 == 0u))), _e2996)) - select(0u, 1u, (_e2991.member_1 < select(_e2809[0].member_1, (~(_e2809[0].member_1) + 1u), _e2996)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3024 = function_8(128u);
                                            let _e3029 = ((_e2809[1].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3052 = select(0u, select(1u, 2u, ((_e2809[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3024.member - select(_e2809[1].member, (~(_e2809[1].member) + select(0u, 1u, (_e2809[1].member_1 == 0u))), _e3029)) - select(0u, 1u, (_e3024.member_1 < select(_e2809[1].member_1, (~(_e2809[1].member_1) + 1u), _e3029)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3057 = function_8(128u);
                                            let _e3062 = ((_e2809[2].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3085 = select(0u, select(1u, 2u, ((_e2809[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3057.member - select(_e2809[2].member, (~(_e2809[2].member) + select(0u, 1u, (_e2809[2].member_1 == 0u))), _e3062)) - select(0u, 1u, (_e3057.member_1 < select(_e2809[2].member_1, (~(_e2809[2].member_1) + 1u), _e3062)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3090 = function_8(128u);
                                            let _e3095 = ((_e2809[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3118 = select(0u, select(1u, 2u, ((_e2809[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3090.member - select(_e2809[3].member, (~(_e2809[3].member) + select(0u, 1u, (_e2809[3].member_1 == 0u))), _e3095)) - select(0u, 1u, (_e3090.member_1 < select(_e2809[3].member_1, (~(_e2809[3].member_1) + 1u), _e3095)))) >> bitcast<u32>(31i)) != 0u));
                                            let _e3128 = select(false, select(true, select(false, (_e3052 != 0u), (_e3085 == _e3118)), select(true, (_e3085 == 0u), (_e3052 == _e3019))), ((_e3019 | _e3118) == 3u));
                                            let _e3133 = function_8(128u);
                                            let _e3138 = ((_e2809[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3164 = select(false, (_e2837 >= _e1266), (select(0u, select(1u, 2u, ((_e2809[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3133.member - select(_e2809[0].member, (~(_e2809[0].member) + select(0u, 1u, (_e2809[0].member_1 == 0u))), _e3138)) - select(0u, 1u, (_e3133.member_1 < select(_e2809[0].member_1, (~(_e2809[0].member_1) + 1u), _e3138)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                            let _e3165 = (_e2829 == 3u);
                                            let _e3166 = (_e2829 == 8u);
                                            let _e3171 = select(select(select((_e2829 == 14u), bool(), _e3166), bool(), _e3165), true, select(_e3166, true, _e3165));
                                            let _e3173 = select(false, !(_e2811), _e3164);
                                            let _e3174 = (_e2829 == 31u);
                                            let _e3185 = select(select(false, !(_e2813), select(select(select(select(select(false, !(_e2790), _e3128), bool(), _e3164), bool(), _e3171), bool(), _e3174), true, select(select(_e3164, true, _e3171), true, _e3174))), true, _e3173);
                                            if _e2986 {
                                                phi_5406_ = _e2809;
                                                phi_5407_ = _e2811;
                                                phi_5408_ = _e2813;
                                                phi_5410_ = _e2829;
                                                phi_5411_ = _e2831;
                                            } else {
                                                if _e3185 {
                                                    phi_5400_ = _e2809;
                                                    phi_5401_ = _e2811;
                                                    phi_5402_ = _e2813;
                                                    phi_5404_ = _e2829;
                                                    phi_5405_ = _e2831;
                                                } else {
                                                    let _e3194 = (_e2809[0].member_1 + _e2809[1].member_1);
                                                    let _e3198 = ((_e2809[0].member + _e2809[1].member) + select(0u, 1u, (_e3194 < _e2809[0].member_1)));
                                                    let _e3206 = bitcast<u32>((bitcast<i32>(_e3198) >> bitcast<u32>(1u)));
                                                    let _e3209 = ((_e3194 >> bitcast<u32>(1u)) | ((_e3198 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3218 = (_e2809[1].member_1 + _e2809[2].member_1);
                                                    let _e3222 = ((_e2809[1].member + _e2809[2].member) + select(0u, 1u, (_e3218 < _e2809[1].member_1)));
                                                    let _e3230 = bitcast<u32>((bitcast<i32>(_e3222) >> bitcast<u32>(1u)));
                                                    let _e3233 = ((_e3218 >> bitcast<u32>(1u)) | ((_e3222 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3242 = (_e2809[2].member_1 + _e2809[3].member_1);
                                                    let _e3246 = ((_e2809[2].member + _e2809[3].member) + select(0u, 1u, (_e3242 < _e2809[2].member_1)));
                                                    let _e3254 = bitcast<u32>((bitcast<i32>(_e3246) >> bitcast<u32>(1u)));
                                                    let _e3257 = ((_e3242 >> bitcast<u32>(1u)) | ((_e3246 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3258 = (_e3209 + _e3233);
                                                    let _e3262 = ((_e3206 + _e3230) + select(0u, 1u, (_e3258 < _e3209)));
                                                    let _e3270 = bitcast<u32>((bitcast<i32>(_e3262) >> bitcast<u32>(1u)));
                                                    let _e3273 = ((_e3258 >> bitcast<u32>(1u)) | ((_e3262 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3274 = (_e3233 + _e3257);
                                                    let _e3278 = ((_e3230 + _e3254) + select(0u, 1u, (_e3274 < _e3233)));
                                                    let _e3286 = bitcast<u32>((bitcast<i32>(_e3278) >> bitcast<u32>(1u)));
                                                    let _e3289 = ((_e3274 >> bitcast<u32>(1u)) | ((_e3278 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3290 = (_e3273 + _e3289);
                                                    let _e3294 = ((_e3270 + _e3286) + select(0u, 1u, (_e3290 < _e3273)));
                                                    let _e3302 = bitcast<u32>((bitcast<i32>(_e3294) >> bitcast<u32>(1u)));
                                                    let _e3305 = ((_e3290 >> bitcast<u32>(1u)) | ((_e3294 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                    let _e3306 = (2u * _e2831);
                                                    let _e3317 = function_8(128u);
                                                    let _e3322 = ((_e2809[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e3346 = function_8(128u);
                                                    let _e3351 = ((_e3206 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3373 = function_8(128u);
                                                    let _e3378 = ((_e3270 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3400 = function_8(128u);
                                                    let _e3405 = ((_e3302 >> bitcast<u32>(31i)) != 0u);
                                                    if ((((select(0u, select(1u, 2u, ((_e2809[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3317.member - select(_e2809[0].member, (~(_e2809[0].member) + select(0u, 1u, (_e2809[0].member_1 == 0u))), _e3322)) - select(0u, 1u, (_e3317.member_1 < select(_e2809[0].member_1, (~(_e2809[0].member_1) + 1u), _e3322)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3206 >> bitcast<u32>(31i)) != 0u)), ((((_e3346.member - select(_e3206, (~(_e3206) + select(0u, 1u, (_e3209 == 0u))), _e3351)) - select(0u, 1u, (_e3346.member_1 < select(_e3209, (~(_e3209) + 1u), _e3351)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3270 >> bitcast<u32>(31i)) != 0u)), ((((_e3373.member - select(_e3270, (~(_e3270) + select(0u, 1u, (_e3273 == 0u))), _e3378)) - select(0u, 1u, (_e3373.member_1 < select(_e3273, (~(_e3273) + 1u), _e3378)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3302 >> bitcast<u32>(31i)) != 0u)), ((((_e3400.member - select(_e3302, (~(_e3302) + select(0u, 1u, (_e3305 == 0u))), _e3405)) - select(0u, 1u, (_e3400.member_1 < select(_e3305, (~(_e3305) + 1u), _e3405)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                        phi_5397_ = array<type_9, 4>(type_9(_e3302, _e3305), type_9(_e3286, _e3289), type_9(_e3254, _e3257), _e2809[3]);
                                                        phi_5398_ = false;
                                                        phi_5399_ = (_e3306 + 1u);
                                                    } else {
                                                        phi_5397_ = array<type_9, 4>(_e2809[0], type_9(_e3206, _e3209), type_9(_e3270, _e3273), type_9(_e3302, _e3305));
                                                        phi_5398_ = _e2811;
                                                        phi_5399_ = _e3306;
                                                    }
                                                    let _e3435 = phi_5397_;
                                                    let _e3437 = phi_5398_;
                                                    let _e3439 = phi_5399_;
                                                    phi_5400_ = _e3435;
                                                    phi_5401_ = _e3437;
                                                    phi_5402_ = false;
                                                    phi_5404_ = (_e2829 + 1u);
                                                    phi_5405_ = _e3439;
                                                }
                                                let _e3441 = phi_5400_;
                                                let _e3443 = phi_5401_;
                                                let _e3445 = phi_5402_;
                                                let _e3447 = phi_5404_;
                                                let _e3449 = phi_5405_;
                                                phi_5406_ = _e3441;
                                                phi_5407_ = _e3443;
                                                phi_5408_ = _e3445;
                                                phi_5410_ = _e3447;
                                                phi_5411_ = _e3449;
                                            }
                                            let _e3451 = phi_5406_;
                                            let _e3453 = phi_5407_;
                                            let _e3455 = phi_5408_;
                                            let _e3457 = phi_5410_;
                                            let _e3459 = phi_5411_;
                                            phi_5412_ = _e3451;
                                            phi_5413_ = _e3453;
                                            phi_5414_ = _e3455;
                                            phi_5416_ = _e3185;
                                            phi_5417_ = _e3173;
                                            phi_5418_ = _e3128;
                                            phi_5419_ = _e2986;
                                            phi_5420_ = _e2841;
                                            phi_5421_ = _e2837;
                                            phi_5422_ = (_e2827 + 1u);
                                            phi_5423_ = _e3457;
                                            phi_5424_ = _e3459;
                                            phi_5425_ = true;
                                        }
                                        let _e3461 = phi_5412_;
                                        let _e3463 = phi_5413_;
                                        let _e3465 = phi_5414_;
                                        let _e3467 = phi_5416_;
                                        let _e3469 = phi_5417_;
                                        let _e3471 = phi_5418_;
                                        let _e3473 = phi_5419_;
                                        let _e3475 = phi_5420_;
                                        let _e3477 = phi_5421_;
                                        let _e3479 = phi_5422_;
                                        let _e3481 = phi_5423_;
                                        let _e3483 = phi_5424_;
                                        let _e3485 = phi_5425_;
                                        phi_5426_ = _e3461;
                                        phi_5427_ = _e3463;
                                        phi_5428_ = _e3465;
                                        phi_5430_ = _e3467;
                                        phi_5431_ = _e3469;
                                        phi_5432_ = _e3471;
                                        phi_5433_ = _e3473;
                                        phi_5434_ = _e3475;
                                        phi_5435_ = _e3477;
                                        phi_5436_ = _e3479;
                                        phi_5437_ = _e3481;
                                        phi_5438_ = _e3483;
                                        phi_5439_ = _e3485;
                                    }
                                    let _e3487 = phi_5426_;
                                    let _e3489 = phi_5427_;
                                    let _e3491 = phi_5428_;
                                    let _e3493 = phi_5430_;
                                    let _e3495 = phi_5431_;
                                    let _e3497 = phi_5432_;
                                    let _e3499 = phi_5433_;
                                    let _e3501 = phi_5434_;
                                    let _e3503 = phi_5435_;
                                    let _e3505 = phi_5436_;
                                    let _e3507 = phi_5437_;
                                    let _e3509 = phi_5438_;
                                    let _e3511 = phi_5439_;
                                    phi_4524_ = _e3487;
                                    phi_4527_ = _e3489;
                                    phi_4529_ = _e3491;
                                    phi_4533_ = _e3493;
                                    phi_4535_ = _e3495;
                                    phi_4537_ = _e3497;
                                    phi_4539_ = _e3499;
                                    phi_4541_ = _e3501;
                                    phi_4543_ = _e3503;
                                    phi_4545_ = _e3505;
                                    phi_4547_ = _e3507;
                                    phi_4549_ = _e3509;
                                    phi_5440_ = _e3511;
                                } else {
                                    phi_4524_ = array<type_9, 4>();
                                    phi_4527_ = bool();
                                    phi_4529_ = bool();
                                    phi_4533_ = bool();
                                    phi_4535_ = bool();
                                    phi_4537_ = bool();
                                    phi_4539_ = bool();
                                    phi_4541_ = u32();
                                    phi_4543_ = u32();
                                    phi_4545_ = u32();
                                    phi_4547_ = u32();
                                    phi_4549_ = u32();
                                    phi_5440_ = false;
                                }
                                let _e3513 = phi_4524_;
                                let _e3515 = phi_4527_;
                                let _e3517 = phi_4529_;
                                let _e3519 = phi_4533_;
                                let _e3521 = phi_4535_;
                                let _e3523 = phi_4537_;
                                let _e3525 = phi_4539_;
                                let _e3527 = phi_4541_;
                                let _e3529 = phi_4543_;
                                let _e3531 = phi_4545_;
                                let _e3533 = phi_4547_;
                                let _e3535 = phi_4549_;
                                let _e3537 = phi_5440_;
                                continue;
                                continuing {
                                    phi_4523_ = _e3513;
                                    phi_4526_ = _e3515;
                                    phi_4528_ = _e3517;
                                    phi_4532_ = _e3519;
                                    phi_4534_ = _e3521;
                                    phi_4536_ = _e3523;
                                    phi_4538_ = _e3525;
                                    phi_4540_ = _e3527;
                                    phi_4542_ = _e3529;
                                    phi_4544_ = _e3531;
                                    phi_4546_ = _e3533;
                                    phi_4548_ = _e3535;
                                    break if !(_e3537);
                                }
                            }
                            let _e3540 = local_34;
                            if _e3540 {
                                let _e3542 = local_35;
                                if _e3542 {
                                    phi_8311_ = _e2788;
                                    phi_8312_ = _e2790;
                                    let _e6388 = local_110;
                                    phi_8313_ = _e6388;
                                    let _e6391 = local_111;
                                    phi_8314_ = _e6391;
                                    phi_8315_ = _e2796;
                                    let _e6395 = local_112;
                                    phi_8316_ = _e6395;
                                    phi_8317_ = bool();
                                    phi_8318_ = type_17();
                                    phi_8319_ = true;
                                    phi_8320_ = false;
                                    phi_8321_ = false;
                                    phi_8322_ = false;
                                } else {
                                    let _e3544 = local_36;
                                    let _e3548 = local_37;
                                    let _e3551 = function_8(128u);
                                    let _e3556 = ((_e3544[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3564 = local_38;
                                    let _e3583 = local_39;
                                    let _e3587 = local_40;
                                    let _e3590 = function_8(128u);
                                    let _e3595 = ((_e3583[1].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3603 = local_41;
                                    let _e3623 = local_42;
                                    let _e3627 = local_43;
                                    let _e3630 = function_8(128u);
                                    let _e3635 = ((_e3623[2].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3643 = local_44;
                                    let _e3663 = local_45;
                                    let _e3667 = local_46;
                                    let _e3670 = function_8(128u);
                                    let _e3675 = ((_e3663[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3683 = local_47;
                                    let _e3704 = local_48;
                                    let _e3709 = local_49;
                                    let _e3711 = local_50;
                                    let _e3713 = local_51;
                                    let _e3714 = type_17(_e3709, _e3711, _e3713);
                                    let _e3716 = local_52;
                                    let _e3720 = local_53;
                                    let _e3723 = function_8(128u);
                                    let _e3728 = ((_e3716[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3736 = local_54;
                                    let _e3755 = local_55;
                                    let _e3759 = local_56;
                                    let _e3762 = function_8(128u);
                                    let _e3767 = ((_e3755[3].member >> bitcast<u32>(31i)) != 0u);
                                    let _e3775 = local_57;
                                    let _e3794 = ((select(0u, select(1u, 2u, ((_e3716[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3723.member - select(_e3736[0].member, (~(_e3716[0].member) + select(0u, 1u, (_e3720[0].member_1 == 0u))), _e3728)) - select(0u, 1u, (_e3723.member_1 < select(_e3736[0].member_1, (~(_e3720[0].member_1) + 1u), _e3728)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3755[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3762.member - select(_e3775[3].member, (~(_e3755[3].member) + select(0u, 1u, (_e3759[3].member_1 == 0u))), _e3767)) - select(0u, 1u, (_e3762.member_1 < select(_e3775[3].member_1, (~(_e3759[3].member_1) + 1u), _e3767)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    let _e3796 = local_58;
                                    let _e3799 = local_59;
                                    if _e3799 {
                                        let _e4416 = local_85;
                                        let _e4419 = local_86;
                                        phi_6548_ = _e2788;
                                        phi_6549_ = _e2790;
                                        phi_6550_ = _e3794;
                                        phi_6551_ = type_17(_e4419, (_e4416 + 1u), 31u);
                                        phi_6552_ = _e2796;
                                    } else {
                                        if _e2788 {
                                            phi_6034_ = bool();
                                            phi_6035_ = type_17();
                                            phi_6036_ = true;
                                        } else {
                                            let _e3801 = local_60;
                                            let _e3805 = local_61;
                                            if select(true, select(true, false, (_e3801 < _e2784)), _e3805) {
                                                let _e3808 = local_62;
                                                if (_e3808 == 31u) {
                                                    if _e3794 {
                                                        phi_6027_ = _e3794;
                                                        phi_6028_ = _e3714;
                                                    } else {
                                                        let _e3811 = local_63;
                                                        let _e3815 = local_64;
                                                        let _e3818 = function_8(128u);
                                                        let _e3823 = ((_e3811[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3831 = local_65;
                                                        if (select(0u, select(1u, 2u, ((_e3811[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3818.member - select(_e3831[0].member, (~(_e3811[0].member) + select(0u, 1u, (_e3815[0].member_1 == 0u))), _e3823)) - select(0u, 1u, (_e3818.member_1 < select(_e3831[0].member_1, (~(_e3815[0].member_1) + 1u), _e3823)))) >> bitcast<u32>(31i)) != 0u)) == 0u) {
                                                            phi_6025_ = _e3794;
                                                            phi_6026_ = _e3714;
                                                        } else {
                                                            let _e3854 = select((bitcast<u32>(31i) - firstLeadingBit(_e1270)), 32u, (_e1270 == 0u));
                                                            let _e3860 = local_66;
                                                            let _e3861 = (_e3860 + (1u << bitcast<u32>(((31u - _e3854) & 31u))));
                                                            let _e3863 = local_67;
                                                            if (_e3861 <= 2147483648u) {
                                                                let _e3867 = local_68;
                                                                let _e3871 = local_69;
                                                                let _e3874 = function_8(128u);
                                                                let _e3879 = ((_e3867[0].member >> bitcast<u32>(31i)) != 0u);
                                                                let _e3887 = local_70;
                                                                let _e3910 = function_1(((_e2667 - _e2594.member) - select(0u, 1u, (_e2663 < _e2594.member_1))), (_e2663 - _e2594.member_1), _e3861);
                                                                let _e3913 = (_e2594.member_1 + _e3910.member_1);
                                                                let _e3917 = ((_e2594.member + _e3910.member) + select(0u, 1u, (_e3913 < _e2594.member_1)));
                                                                let _e3923 = function_1(((_e2738 - _e2667) - select(0u, 1u, (_e2734 < _e2663))), (_e2734 - _e2663), _e3861);
                                                                let _e3926 = (_e2663 + _e3923.member_1);
                                                                let _e3930 = ((_e2667 + _e3923.member) + select(0u, 1u, (_e3926 < _e2663)));
                                                                let _e3936 = function_1(((_e2772.member - _e2738) - select(0u, 1u, (_e2772.member_1 < _e2734))), (_e2772.member_1 - _e2734), _e3861);
                                                                let _e3939 = (_e2734 + _e3936.member_1);
                                                                let _e3949 = function_1(((_e3930 - _e3917) - select(0u, 1u, (_e3926 < _e3913))), (_e3926 - _e3913), _e3861);
                                                                let _e3952 = (_e3913 + _e3949.member_1);
                                                                let _e3956 = ((_e3917 + _e3949.member) + select(0u, 1u, (_e3952 < _e3913)));
                                                                let _e3962 = function_1(((((_e2738 + _e3936.member) + select(0u, 1u, (_e3939 < _e2734))) - _e3930) - select(0u, 1u, (_e3939 < _e3926))), (_e3939 - _e3926), _e3861);
                                                                let _e3965 = (_e3926 + _e3962.member_1);
                                                                let _e3975 = function_1(((((_e3930 + _e3962.member) + select(0u, 1u, (_e3965 < _e3926))) - _e3956) - select(0u, 1u, (_e3965 < _e3952))), (_e3965 - _e3952), _e3861);
                                                                let _e3978 = (_e3952 + _e3975.member_1);
                                                                let _e3982 = ((_e3956 + _e3975.member) + select(0u, 1u, (_e3978 < _e3952)));
                                                                let _e3983 = function_8(128u);
                                                                let _e3988 = ((_e3982 >> bitcast<u32>(31i)) != 0u);
                                                                phi_6024_ = ((select(0u, select(1u, 2u, ((_e3867[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3874.member - select(_e3887[0].member, (~(_e3867[0].member) + select(0u, 1u, (_e3871[0].member_1 == 0u))), _e3879)) - select(0u, 1u, (_e3874.member_1 < select(_e3887[0].member_1, (~(_e3871[0].member_1) + 1u), _e3879)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3982 >> bitcast<u32>(31i)) != 0u)), ((((_e3983.member - select(_e3982, (~(_e3982) + select(0u, 1u, (_e3978 == 0u))), _e3988)) - select(0u, 1u, (_e3983.member_1 < select(_e3978, (~(_e3978) + 1u), _e3988)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                            } else {
                                                                phi_6024_ = false;
                                                            }
                                                            let _e4012 = phi_6024_;
                                                            phi_6025_ = _e4012;
                                                            phi_6026_ = type_17(_e3863, _e3861, _e3854);
                                                        }
                                                        let _e4014 = phi_6025_;
                                                        let _e4016 = phi_6026_;
                                                        phi_6027_ = _e4014;
                                                        phi_6028_ = _e4016;
                                                    }
                                                    let _e4018 = phi_6027_;
                                                    let _e4020 = phi_6028_;
                                                    phi_6029_ = _e4018;
                                                    phi_6030_ = _e4020;
                                                } else {
                                                    phi_6029_ = _e3794;
                                                    phi_6030_ = _e3714;
                                                }
                                                let _e4022 = phi_6029_;
                                                let _e4024 = phi_6030_;
                                                phi_6031_ = _e4022;
                                                phi_6032_ = _e4024;
                                                phi_6033_ = false;
                                            } else {
                                                phi_6031_ = bool();
                                                phi_6032_ = type_17();
                                                phi_6033_ = true;
                                            }
                                            let _e4026 = phi_6031_;
                                            let _e4028 = phi_6032_;
                                            let _e4030 = phi_6033_;
                                            phi_6034_ = _e4026;
                                            phi_6035_ = _e4028;
                                            phi_6036_ = _e4030;
                                        }
                                        let _e4032 = phi_6034_;
                                        let _e4034 = phi_6035_;
                                        let _e4036 = phi_6036_;
                                        if _e4036 {
                                            let _e4037 = select(_e2784, 31u, _e2788);
                                            let _e4040 = local_71;
                                            let _e4041 = select(_e4040, _e2796.member, _e2788);
                                            let _e4044 = local_72;
                                            let _e4045 = select(_e4044, _e2796.member_1, _e2788);
                                            let _e4047 = local_73;
                                            let _e4051 = local_74;
                                            let _e4058 = ((f32(bitcast<i32>(_e4047[0].member)) * 4294967300f) + f32(_e4051[0].member_1));
                                            let _e4060 = local_75;
                                            let _e4064 = local_76;
                                            let _e4071 = ((f32(bitcast<i32>(_e4060[1].member)) * 4294967300f) + f32(_e4064[1].member_1));
                                            let _e4073 = local_77;
                                            let _e4077 = local_78;
                                            let _e4084 = ((f32(bitcast<i32>(_e4073[2].member)) * 4294967300f) + f32(_e4077[2].member_1));
                                            let _e4086 = local_79;
                                            let _e4090 = local_80;
                                            let _e4097 = ((f32(bitcast<i32>(_e4086[3].member)) * 4294967300f) + f32(_e4090[3].member_1));
                                            phi_6077_ = type_14(0i, 6i);
                                            phi_6080_ = 1f;
                                            phi_6082_ = 0f;
                                            phi_6084_ = (_e4058 / (_e4058 - _e4097));
                                            loop {
                                                let _e4101 = phi_6077_;
                                                let _e4103 = phi_6080_;
                                                let _e4105 = phi_6082_;
                                                let _e4107 = phi_6084_;
                                                local_81 = _e4107;
                                                if (_e4101.member < _e4101.member_1) {
                                                    let _e4114 = (_e4101.member + 1i);
                                                    phi_6078_ = type_14(select(_e4114, type_15().member_1, select(false, true, ((false == (_e4114 > _e4101.member)) != false))), _e4101.member_1);
                                                    phi_6125_ = type_15(1u, _e4101.member);
                                                } else {
                                                    phi_6078_ = _e4101;
                                                    phi_6125_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e4125 = phi_6078_;
                                                let _e4127 = phi_6125_;
                                                let _e4130 = (bitcast<i32>(_e4127.member) != 0i);
                                                if _e4130 {
                                                    let _e4131 = function_7(_e4058, _e4071, _e4107);
                                                    let _e4132 = function_7(_e4071, _e4084, _e4107);
                                                    let _e4133 = function_7(_e4084, _e4097, _e4107);
                                                    let _e4134 = function_7(_e4131, _e4132, _e4107);
                                                    let _e4135 = function_7(_e4132, _e4133, _e4107);
                                                    let _e4136 = function_7(_e4134, _e4135, _e4107);
                                                    let _e4139 = ((_e4136 < 0f) == (_e4058 < 0f));
                                                    let _e4140 = select(_e4107, _e4103, _e4139);
                                                    let _e4141 = select(_e4105, _e4107, _e4139);
                                                    let _e4145 = (_e4107 - (_e4136 / (3f * (_e4135 - _e4134))));
                                                    phi_6081_ = _e4140;
                                                    phi_6083_ = _e4141;
                                                    phi_6085_ = select(_e4145, (0.5f * (_e4141 + _e4140)), select(true, select(true, false, (_e4145 <= _e4140)), (_e4145 >= _e4141)));
                                                } else {
                                                    phi_6081_ = f32();
                                                    phi_6083_ = f32();
                                                    phi_6085_ = f32();
                                                }
                                                let _e4154 = phi_6081_;
                                                let _e4156 = phi_6083_;
                                                let _e4158 = phi_6085_;
                                                continue;
                                                continuing {
                                                    phi_6077_ = _e4125;
                                                    phi_6080_ = _e4154;
                                                    phi_6082_ = _e4156;
                                                    phi_6084_ = _e4158;
                                                    break if !(_e4130);
                                                }
                                            }
                                            let _e4163 = (1u << bitcast<u32>(((31u - _e4037) & 31u)));
                                            let _e4164 = (_e4045 - _e4041);
                                            let _e4167 = local_81;
                                            let _e4168 = (_e4167 * f32(_e4164));
                                            let _e4173 = select(select(u32(_e4168), 0u, (_e4168 < 0f)), 4294967295u, (_e4168 > 4294967000f));
                                            let _e4175 = select(_e4173, _e4164, (_e4164 < _e4173));
                                            let _e4177 = (_e4163 / 2u);
                                            let _e4180 = ((_e4041 + _e4175) - select(_e4177, _e4175, (_e4175 < _e4177)));
                                            let _e4181 = (_e4180 + _e4163);
                                            let _e4183 = select(_e4181, _e4045, (_e4045 < _e4181));
                                            let _e4189 = function_1(((_e2667 - _e2594.member) - select(0u, 1u, (_e2663 < _e2594.member_1))), (_e2663 - _e2594.member_1), _e4180);
                                            let _e4192 = (_e2594.member_1 + _e4189.member_1);
                                            let _e4196 = ((_e2594.member + _e4189.member) + select(0u, 1u, (_e4192 < _e2594.member_1)));
                                            let _e4202 = function_1(((_e2738 - _e2667) - select(0u, 1u, (_e2734 < _e2663))), (_e2734 - _e2663), _e4180);
                                            let _e4205 = (_e2663 + _e4202.member_1);
                                            let _e4209 = ((_e2667 + _e4202.member) + select(0u, 1u, (_e4205 < _e2663)));
                                            let _e4215 = function_1(((_e2772.member - _e2738) - select(0u, 1u, (_e2772.member_1 < _e2734))), (_e2772.member_1 - _e2734), _e4180);
                                            let _e4218 = (_e2734 + _e4215.member_1);
                                            let _e4228 = function_1(((_e4209 - _e4196) - select(0u, 1u, (_e4205 < _e4192))), (_e4205 - _e4192), _e4180);
                                            let _e4231 = (_e4192 + _e4228.member_1);
                                            let _e4235 = ((_e4196 + _e4228.member) + select(0u, 1u, (_e4231 < _e4192)));
                                            let _e4241 = function_1(((((_e2738 + _e4215.member) + select(0u, 1u, (_e4218 < _e2734))) - _e4209) - select(0u, 1u, (_e4218 < _e4205))), (_e4218 - _e4205), _e4180);
                                            let _e4244 = (_e4205 + _e4241.member_1);
                                            let _e4254 = function_1(((((_e4209 + _e4241.member) + select(0u, 1u, (_e4244 < _e4205))) - _e4235) - select(0u, 1u, (_e4244 < _e4231))), (_e4244 - _e4231), _e4180);
                                            let _e4257 = (_e4231 + _e4254.member_1);
                                            let _e4261 = ((_e4235 + _e4254.member) + select(0u, 1u, (_e4257 < _e4231)));
                                            let _e4262 = function_8(128u);
                                            let _e4267 = ((_e4261 >> bitcast<u32>(31i)) != 0u);
                                            let _e4293 = function_1(((_e2667 - _e2594.member) - select(0u, 1u, (_e2663 < _e2594.member_1))), (_e2663 - _e2594.member_1), _e4183);
                                            let _e4296 = (_e2594.member_1 + _e4293.member_1);
                                            let _e4300 = ((_e2594.member + _e4293.member) + select(0u, 1u, (_e4296 < _e2594.member_1)));
                                            let _e4306 = function_1(((_e2738 - _e2667) - select(0u, 1u, (_e2734 < _e2663))), (_e2734 - _e2663), _e4183);
                                            let _e4309 = (_e2663 + _e4306.member_1);
                                            let _e4313 = ((_e2667 + _e4306.member) + select(0u, 1u, (_e4309 < _e2663)));
                                            let _e4319 = function_1(((_e2772.member - _e2738) - select(0u, 1u, (_e2772.member_1 < _e2734))), (_e2772.member_1 - _e2734), _e4183);
                                            let _e4322 = (_e2734 + _e4319.member_1);
                                            let _e4332 = function_1(((_e4313 - _e4300) - select(0u, 1u, (_e4309 < _e4296))), (_e4309 - _e4296), _e4183);
                                            let _e4335 = (_e4296 + _e4332.member_1);
                                            let _e4339 = ((_e4300 + _e4332.member) + select(0u, 1u, (_e4335 < _e4296)));
                                            let _e4345 = function_1(((((_e2738 + _e4319.member) + select(0u, 1u, (_e4322 < _e2734))) - _e4313) - select(0u, 1u, (_e4322 < _e4309))), (_e4322 - _e4309), _e4183);
                                            let _e4348 = (_e4309 + _e4345.member_1);
                                            let _e4358 = function_1(((((_e4313 + _e4345.member) + select(0u, 1u, (_e4348 < _e4309))) - _e4339) - select(0u, 1u, (_e4348 < _e4335))), (_e4348 - _e4335), _e4183);
                                            let _e4361 = (_e4335 + _e4358.member_1);
                                            let _e4365 = ((_e4339 + _e4358.member) + select(0u, 1u, (_e4361 < _e4335)));
                                            let _e4366 = function_8(128u);
                                            let _e4371 = ((_e4365 >> bitcast<u32>(31i)) != 0u);
                                            let _e4393 = ((select(0u, select(1u, 2u, ((_e4261 >> bitcast<u32>(31i)) != 0u)), ((((_e4262.member - select(_e4261, (~(_e4261) + select(0u, 1u, (_e4257 == 0u))), _e4267)) - select(0u, 1u, (_e4262.member_1 < select(_e4257, (~(_e4257) + 1u), _e4267)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4365 >> bitcast<u32>(31i)) != 0u)), ((((_e4366.member - select(_e4365, (~(_e4365) + select(0u, 1u, (_e4361 == 0u))), _e4371)) - select(0u, 1u, (_e4366.member_1 < select(_e4361, (~(_e4361) + 1u), _e4371)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e4396 = local_82;
                                            let _e4399 = local_83;
                                            let _e4402 = local_84;
                                            phi_6543_ = _e4393;
                                            phi_6544_ = true;
                                            phi_6545_ = _e4393;
                                            phi_6546_ = type_17(select(_e4396, _e4180, _e4393), select(_e4399, _e4183, _e4393), select(_e4402, _e4037, _e4393));
                                            phi_6547_ = type_17(_e4180, _e4183, _e4037);
                                        } else {
                                            phi_6543_ = _e2788;
                                            phi_6544_ = _e2790;
                                            phi_6545_ = _e4032;
                                            phi_6546_ = _e4034;
                                            phi_6547_ = _e2796;
                                        }
                                        let _e4406 = phi_6543_;
                                        let _e4408 = phi_6544_;
                                        let _e4410 = phi_6545_;
                                        let _e4412 = phi_6546_;
                                        let _e4414 = phi_6547_;
                                        phi_6548_ = _e4406;
                                        phi_6549_ = _e4408;
                                        phi_6550_ = _e4410;
                                        phi_6551_ = _e4412;
                                        phi_6552_ = _e4414;
                                    }
                                    let _e4422 = phi_6548_;
                                    let _e4424 = phi_6549_;
                                    let _e4426 = phi_6550_;
                                    let _e4428 = phi_6551_;
                                    let _e4430 = phi_6552_;
                                    let _e4449 = ((_e1845[0][1][0].member - _e1845[0][0][0].member) - select(0u, 1u, (_e1845[0][1][0].member_1 < _e1845[0][0][0].member_1)));
                                    let _e4450 = (_e1845[0][1][0].member_1 - _e1845[0][0][0].member_1);
                                    let _e4462 = ((_e1845[0][1][1].member - _e1845[0][0][1].member) - select(0u, 1u, (_e1845[0][1][1].member_1 < _e1845[0][0][1].member_1)));
                                    let _e4463 = (_e1845[0][1][1].member_1 - _e1845[0][0][1].member_1);
                                    let _e4475 = ((_e1845[0][1][2].member - _e1845[0][0][2].member) - select(0u, 1u, (_e1845[0][1][2].member_1 < _e1845[0][0][2].member_1)));
                                    let _e4476 = (_e1845[0][1][2].member_1 - _e1845[0][0][2].member_1);
                                    let _e4479 = ((_e4449 >> bitcast<u32>(31i)) != 0u);
                                    let _e4486 = select(_e4449, (~(_e4449) + select(0u, 1u, (_e4450 == 0u))), _e4479);
                                    let _e4487 = select(_e4450, (~(_e4450) + 1u), _e4479);
                                    let _e4490 = ((_e4462 >> bitcast<u32>(31i)) != 0u);
                                    let _e4497 = select(_e4462, (~(_e4462) + select(0u, 1u, (_e4463 == 0u))), _e4490);
                                    let _e4498 = select(_e4463, (~(_e4463) + 1u), _e4490);
                                    let _e4505 = ((((_e4497 - _e4486) - select(0u, 1u, (_e4498 < _e4487))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4506 = select(_e4497, _e4486, _e4505);
                                    let _e4507 = select(_e4498, _e4487, _e4505);
                                    let _e4510 = ((_e4475 >> bitcast<u32>(31i)) != 0u);
                                    let _e4517 = select(_e4475, (~(_e4475) + select(0u, 1u, (_e4476 == 0u))), _e4510);
                                    let _e4518 = select(_e4476, (~(_e4476) + 1u), _e4510);
                                    let _e4525 = ((((_e4517 - _e4506) - select(0u, 1u, (_e4518 < _e4507))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4527 = select(_e4518, _e4507, _e4525);
                                    let _e4528 = function_8(4u);
                                    let _e4531 = (_e4527 + _e4528.member_1);
                                    let _e4535 = ((select(_e4517, _e4506, _e4525) + _e4528.member) + select(0u, 1u, (_e4531 < _e4527)));
                                    let _e4550 = ((_e4531 >> bitcast<u32>((_e4428.member_2 & 31u))) | ((_e4535 << bitcast<u32>(((31u - _e4428.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4551 = function_8(4u);
                                    let _e4554 = (_e4550 + _e4551.member_1);
                                    let _e4572 = ((_e1845[1][1][0].member - _e1845[1][0][0].member) - select(0u, 1u, (_e1845[1][1][0].member_1 < _e1845[1][0][0].member_1)));
                                    let _e4573 = (_e1845[1][1][0].member_1 - _e1845[1][0][0].member_1);
                                    let _e4585 = ((_e1845[1][1][1].member - _e1845[1][0][1].member) - select(0u, 1u, (_e1845[1][1][1].member_1 < _e1845[1][0][1].member_1)));
                                    let _e4586 = (_e1845[1][1][1].member_1 - _e1845[1][0][1].member_1);
                                    let _e4598 = ((_e1845[1][1][2].member - _e1845[1][0][2].member) - select(0u, 1u, (_e1845[1][1][2].member_1 < _e1845[1][0][2].member_1)));
                                    let _e4599 = (_e1845[1][1][2].member_1 - _e1845[1][0][2].member_1);
                                    let _e4602 = ((_e4572 >> bitcast<u32>(31i)) != 0u);
                                    let _e4609 = select(_e4572, (~(_e4572) + select(0u, 1u, (_e4573 == 0u))), _e4602);
                                    let _e4610 = select(_e4573, (~(_e4573) + 1u), _e4602);
                                    let _e4613 = ((_e4585 >> bitcast<u32>(31i)) != 0u);
                                    let _e4620 = select(_e4585, (~(_e4585) + select(0u, 1u, (_e4586 == 0u))), _e4613);
                                    let _e4621 = select(_e4586, (~(_e4586) + 1u), _e4613);
                                    let _e4628 = ((((_e4620 - _e4609) - select(0u, 1u, (_e4621 < _e4610))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4629 = select(_e4620, _e4609, _e4628);
                                    let _e4630 = select(_e4621, _e4610, _e4628);
                                    let _e4633 = ((_e4598 >> bitcast<u32>(31i)) != 0u);
                                    let _e4640 = select(_e4598, (~(_e4598) + select(0u, 1u, (_e4599 == 0u))), _e4633);
                                    let _e4641 = select(_e4599, (~(_e4599) + 1u), _e4633);
                                    let _e4648 = ((((_e4640 - _e4629) - select(0u, 1u, (_e4641 < _e4630))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4650 = select(_e4641, _e4630, _e4648);
                                    let _e4651 = function_8(4u);
                                    let _e4654 = (_e4650 + _e4651.member_1);
                                    let _e4658 = ((select(_e4640, _e4629, _e4648) + _e4651.member) + select(0u, 1u, (_e4654 < _e4650)));
                                    let _e4673 = ((_e4654 >> bitcast<u32>((_e4428.member_2 & 31u))) | ((_e4658 << bitcast<u32>(((31u - _e4428.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4674 = function_8(4u);
                                    let _e4677 = (_e4673 + _e4674.member_1);
                                    let _e4695 = ((_e1845[2][1][0].member - _e1845[2][0][0].member) - select(0u, 1u, (_e1845[2][1][0].member_1 < _e1845[2][0][0].member_1)));
                                    let _e4696 = (_e1845[2][1][0].member_1 - _e1845[2][0][0].member_1);
                                    let _e4708 = ((_e1845[2][1][1].member - _e1845[2][0][1].member) - select(0u, 1u, (_e1845[2][1][1].member_1 < _e1845[2][0][1].member_1)));
                                    let _e4709 = (_e1845[2][1][1].member_1 - _e1845[2][0][1].member_1);
                                    let _e4721 = ((_e1845[2][1][2].member - _e1845[2][0][2].member) - select(0u, 1u, (_e1845[2][1][2].member_1 < _e1845[2][0][2].member_1)));
                                    let _e4722 = (_e1845[2][1][2].member_1 - _e1845[2][0][2].member_1);
                                    let _e4725 = ((_e4695 >> bitcast<u32>(31i)) != 0u);
                                    let _e4732 = select(_e4695, (~(_e4695) + select(0u, 1u, (_e4696 == 0u))), _e4725);
                                    let _e4733 = select(_e4696, (~(_e4696) + 1u), _e4725);
                                    let _e4736 = ((_e4708 >> bitcast<u32>(31i)) != 0u);
                                    let _e4743 = select(_e4708, (~(_e4708) + select(0u, 1u, (_e4709 == 0u))), _e4736);
                                    let _e4744 = select(_e4709, (~(_e4709) + 1u), _e4736);
                                    let _e4751 = ((((_e4743 - _e4732) - select(0u, 1u, (_e4744 < _e4733))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4752 = select(_e4743, _e4732, _e4751);
                                    let _e4753 = select(_e4744, _e4733, _e4751);
                                    let _e4756 = ((_e4721 >> bitcast<u32>(31i)) != 0u);
                                    let _e4763 = select(_e4721, (~(_e4721) + select(0u, 1u, (_e4722 == 0u))), _e4756);
                                    let _e4764 = select(_e4722, (~(_e4722) + 1u), _e4756);
                                    let _e4771 = ((((_e4763 - _e4752) - select(0u, 1u, (_e4764 < _e4753))) >> bitcast<u32>(31i)) != 0u);
                                    let _e4773 = select(_e4764, _e4753, _e4771);
                                    let _e4774 = function_8(4u);
                                    let _e4777 = (_e4773 + _e4774.member_1);
                                    let _e4781 = ((select(_e4763, _e4752, _e4771) + _e4774.member) + select(0u, 1u, (_e4777 < _e4773)));
                                    let _e4796 = ((_e4777 >> bitcast<u32>((_e4428.member_2 & 31u))) | ((_e4781 << bitcast<u32>(((31u - _e4428.member_2) & 31u))) << bitcast<u32>(1i)));
                                    let _e4797 = function_8(4u);
                                    let _e4800 = (_e4796 + _e4797.member_1);
                                    local_6[0u].member = ((bitcast<u32>((bitcast<i32>(_e4535) >> bitcast<u32>((_e4428.member_2 & 31u)))) + _e4551.member) + select(0u, 1u, (_e4554 < _e4550)));
                                    local_6[0u].member_1 = _e4554;
                                    local_6[1u].member = ((bitcast<u32>((bitcast<i32>(_e4658) >> bitcast<u32>((_e4428.member_2 & 31u)))) + _e4674.member) + select(0u, 1u, (_e4677 < _e4673)));
                                    local_6[1u].member_1 = _e4677;
                                    local_6[2u].member = ((bitcast<u32>((bitcast<i32>(_e4781) >> bitcast<u32>((_e4428.member_2 & 31u)))) + _e4797.member) + select(0u, 1u, (_e4800 < _e4796)));
                                    local_6[2u].member_1 = _e4800;
                                    let _e4830 = function_1(((_e1845[0][1][0].member - _e1845[0][0][0].member) - select(0u, 1u, (_e1845[0][1][0].member_1 < _e1845[0][0][0].member_1))), (_e1845[0][1][0].member_1 - _e1845[0][0][0].member_1), _e4428.member);
                                    let _e4833 = (_e1845[0][0][0].member_1 + _e4830.member_1);
                                    let _e4837 = ((_e1845[0][0][0].member + _e4830.member) + select(0u, 1u, (_e4833 < _e1845[0][0][0].member_1)));
                                    let _e4851 = function_1(((_e1845[0][1][1].member - _e1845[0][0][1].member) - select(0u, 1u, (_e1845[0][1][1].member_1 < _e1845[0][0][1].member_1))), (_e1845[0][1][1].member_1 - _e1845[0][0][1].member_1), _e4428.member);
                                    let _e4854 = (_e1845[0][0][1].member_1 + _e4851.member_1);
                                    let _e4858 = ((_e1845[0][0][1].member + _e4851.member) + select(0u, 1u, (_e4854 < _e1845[0][0][1].member_1)));
                                    let _e4872 = function_1(((_e1845[0][1][2].member - _e1845[0][0][2].member) - select(0u, 1u, (_e1845[0][1][2].member_1 < _e1845[0][0][2].member_1))), (_e1845[0][1][2].member_1 - _e1845[0][0][2].member_1), _e4428.member);
                                    let _e4875 = (_e1845[0][0][2].member_1 + _e4872.member_1);
                                    let _e4879 = ((_e1845[0][0][2].member + _e4872.member) + select(0u, 1u, (_e4875 < _e1845[0][0][2].member_1)));
                                    let _e4895 = function_1(((_e1845[1][1][0].member - _e1845[1][0][0].member) - select(0u, 1u, (_e1845[1][1][0].member_1 < _e1845[1][0][0].member_1))), (_e1845[1][1][0].member_1 - _e1845[1][0][0].member_1), _e4428.member);
                                    let _e4898 = (_e1845[1][0][0].member_1 + _e4895.member_1);
                                    let _e4902 = ((_e1845[1][0][0].member + _e4895.member) + select(0u, 1u, (_e4898 < _e1845[1][0][0].member_1)));
                                    let _e4916 = function_1(((_e1845[1][1][1].member - _e1845[1][0][1].member) - select(0u, 1u, (_e1845[1][1][1].member_1 < _e1845[1][0][1].member_1))), (_e1845[1][1][1].member_1 - _e1845[1][0][1].member_1), _e4428.member);
                                    let _e4919 = (_e1845[1][0][1].member_1 + _e4916.member_1);
                                    let _e4923 = ((_e1845[1][0][1].member + _e4916.member) + select(0u, 1u, (_e4919 < _e1845[1][0][1].member_1)));
                                    let _e4937 = function_1(((_e1845[1][1][2].member - _e1845[1][0][2].member) - select(0u, 1u, (_e1845[1][1][2].member_1 < _e1845[1][0][2].member_1))), (_e1845[1][1][2].member_1 - _e1845[1][0][2].member_1), _e4428.member);
                                    let _e4940 = (_e1845[1][0][2].member_1 + _e4937.member_1);
                                    let _e4944 = ((_e1845[1][0][2].member + _e4937.member) + select(0u, 1u, (_e4940 < _e1845[1][0][2].member_1)));
                                    let _e4960 = function_1(((_e1845[2][1][0].member - _e1845[2][0][0].member) - select(0u, 1u, (_e1845[2][1][0].member_1 < _e1845[2][0][0].member_1))), (_e1845[2][1][0].member_1 - _e1845[2][0][0].member_1), _e4428.member);
                                    let _e4963 = (_e1845[2][0][0].member_1 + _e4960.member_1);
                                    let _e4967 = ((_e1845[2][0][0].member + _e4960.member) + select(0u, 1u, (_e4963 < _e1845[2][0][0].member_1)));
                                    let _e4981 = function_1(((_e1845[2][1][1].member - _e1845[2][0][1].member) - select(0u, 1u, (_e1845[2][1][1].member_1 < _e1845[2][0][1].member_1))), (_e1845[2][1][1].member_1 - _e1845[2][0][1].member_1), _e4428.member);
                                    let _e4984 = (_e1845[2][0][1].member_1 + _e4981.member_1);
                                    let _e4988 = ((_e1845[2][0][1].member + _e4981.member) + select(0u, 1u, (_e4984 < _e1845[2][0][1].member_1)));
                                    let _e5002 = function_1(((_e1845[2][1][2].member - _e1845[2][0][2].member) - select(0u, 1u, (_e1845[2][1][2].member_1 < _e1845[2][0][2].member_1))), (_e1845[2][1][2].member_1 - _e1845[2][0][2].member_1), _e4428.member);
                                    let _e5005 = (_e1845[2][0][2].member_1 + _e5002.member_1);
                                    let _e5009 = ((_e1845[2][0][2].member + _e5002.member) + select(0u, 1u, (_e5005 < _e1845[2][0][2].member_1)));
                                    local_4 = array<type_9, 3>(type_9(_e4902, _e4898), type_9(_e4923, _e4919), type_9(_e4944, _e4940));
                                    local_5 = array<type_9, 3>(type_9(_e4967, _e4963), type_9(_e4988, _e4984), type_9(_e5009, _e5005));
                                    let _e5020 = local_4[1u].member;
                                    let _e5022 = local_4[1u].member_1;
                                    let _e5025 = local_5[2u].member;
                                    let _e5027 = local_5[2u].member_1;
                                    let _e5028 = function_5(_e5020, _e5022, _e5025, _e5027);
                                    let _e5033 = local_4[2u].member;
                                    let _e5035 = local_4[2u].member_1;
                                    let _e5038 = local_5[1u].member;
                                    let _e5040 = local_5[1u].member_1;
                                    let _e5041 = function_5(_e5033, _e5035, _e5038, _e5040);
                                    let _e5047 = ((_e5028.member - _e5041.member) - select(0u, 1u, (_e5028.member_1 < _e5041.member_1)));
                                    let _e5048 = (_e5028.member_1 - _e5041.member_1);
                                    local_2 = array<type_9, 3>(type_9(_e4902, _e4898), type_9(_e4923, _e4919), type_9(_e4944, _e4940));
                                    local_3 = array<type_9, 3>(type_9(_e4967, _e4963), type_9(_e4988, _e4984), type_9(_e5009, _e5005));
                                    let _e5059 = local_2[2u].member;
                                    let _e5061 = local_2[2u].member_1;
                                    let _e5064 = local_3[0u].member;
                                    let _e5066 = local_3[0u].member_1;
                                    let _e5067 = function_5(_e5059, _e5061, _e5064, _e5066);
                                    let _e5072 = local_2[0u].member;
                                    let _e5074 = local_2[0u].member_1;
                                    let _e5077 = local_3[2u].member;
                                    let _e5079 = local_3[2u].member_1;
                                    let _e5080 = function_5(_e5072, _e5074, _e5077, _e5079);
                                    let _e5086 = ((_e5067.member - _e5080.member) - select(0u, 1u, (_e5067.member_1 < _e5080.member_1)));
                                    let _e5087 = (_e5067.member_1 - _e5080.member_1);
                                    local = array<type_9, 3>(type_9(_e4902, _e4898), type_9(_e4923, _e4919), type_9(_e4944, _e4940));
                                    local_1 = array<type_9, 3>(type_9(_e4967, _e4963), type_9(_e4988, _e4984), type_9(_e5009, _e5005));
                                    let _e5098 = local[0u].member;
                                    let _e5100 = local[0u].member_1;
                                    let _e5103 = local_1[1u].member;
                                    let _e5105 = local_1[1u].member_1;
                                    let _e5106 = function_5(_e5098, _e5100, _e5103, _e5105);
                                    let _e5111 = local[1u].member;
                                    let _e5113 = local[1u].member_1;
                                    let _e5116 = local_1[0u].member;
                                    let _e5118 = local_1[0u].member_1;
                                    let _e5119 = function_5(_e5111, _e5113, _e5116, _e5118);
                                    let _e5125 = ((_e5106.member - _e5119.member) - select(0u, 1u, (_e5106.member_1 < _e5119.member_1)));
                                    let _e5126 = (_e5106.member_1 - _e5119.member_1);
                                    let _e5129 = ((_e5047 >> bitcast<u32>(31i)) != 0u);
                                    let _e5136 = select(_e5047, (~(_e5047) + select(0u, 1u, (_e5048 == 0u))), _e5129);
                                    let _e5137 = select(_e5048, (~(_e5048) + 1u), _e5129);
                                    let _e5140 = ((_e5086 >> bitcast<u32>(31i)) != 0u);
                                    let _e5147 = select(_e5086, (~(_e5086) + select(0u, 1u, (_e5087 == 0u))), _e5140);
                                    let _e5148 = select(_e5087, (~(_e5087) + 1u), _e5140);
                                    let _e5151 = ((_e5125 >> bitcast<u32>(31i)) != 0u);
                                    let _e5158 = select(_e5125, (~(_e5125) + select(0u, 1u, (_e5126 == 0u))), _e5151);
                                    let _e5159 = select(_e5126, (~(_e5126) + 1u), _e5151);
                                    let _e5184 = select(0i, select(2i, 1i, ((((_e5158 - _e5147) - select(0u, 1u, (_e5159 < _e5148))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e5158 - _e5136) - select(0u, 1u, (_e5159 < _e5137))) >> bitcast<u32>(31i)) != 0u)), ((((_e5147 - _e5136) - select(0u, 1u, (_e5148 < _e5137))) >> bitcast<u32>(31i)) != 0u)));
                                    switch _e5184 {
                                        case 0: {
                                            phi_7699_ = array<type_9, 2>(type_9(_e4858, _e4854), type_9(_e4879, _e4875));
                                            break;
                                        }
                                        case 1: {
                                            phi_7699_ = array<type_9, 2>(type_9(_e4879, _e4875), type_9(_e4837, _e4833));
                                            break;
                                        }
                                        default: {
                                            phi_7699_ = array<type_9, 2>(type_9(_e4837, _e4833), type_9(_e4858, _e4854));
                                            break;
                                        }
                                    }
                                    let _e5195 = phi_7699_;
                                    switch _e5184 {
                                        case 0: {
                                            phi_7728_ = array<type_9, 2>(type_9(_e4923, _e4919), type_9(_e4944, _e4940));
                                            break;
                                        }
                                        case 1: {
                                            phi_7728_ = array<type_9, 2>(type_9(_e4944, _e4940), type_9(_e4902, _e4898));
                                            break;
                                        }
                                        default: {
                                            phi_7728_ = array<type_9, 2>(type_9(_e4902, _e4898), type_9(_e4923, _e4919));
                                            break;
                                        }
                                    }
                                    let _e5206 = phi_7728_;
                                    switch _e5184 {
                                        case 0: {
                                            phi_7757_ = array<type_9, 2>(type_9(_e4988, _e4984), type_9(_e5009, _e5005));
                                            break;
                                        }
                                        case 1: {
                                            phi_7757_ = array<type_9, 2>(type_9(_e5009, _e5005), type_9(_e4967, _e4963));
                                            break;
                                        }
                                        default: {
                                            phi_7757_ = array<type_9, 2>(type_9(_e4967, _e4963), type_9(_e4988, _e4984));
                                            break;
                                        }
                                    }
                                    let _e5217 = phi_7757_;
                                    switch _e5184 {
                                        case 0: {
                                            phi_7771_ = type_9(_e5047, _e5048);
                                            break;
                                        }
                                        case 1: {
                                            phi_7771_ = type_9(_e5086, _e5087);
                                            break;
                                        }
                                        default: {
                                            phi_7771_ = type_9(_e5125, _e5126);
                                            break;
                                        }
                                    }
                                    let _e5222 = phi_7771_;
                                    let _e5225 = local_6[1u].member;
                                    let _e5227 = local_6[1u].member_1;
                                    let _e5230 = local_6[2u].member;
                                    let _e5232 = local_6[2u].member_1;
                                    let _e5233 = (_e5227 + _e5232);
                                    let _e5237 = ((_e5225 + _e5230) + select(0u, 1u, (_e5233 < _e5227)));
                                    let _e5248 = ((_e5233 >> bitcast<u32>(1u)) | ((_e5237 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5249 = function_8(17u);
                                    let _e5252 = (_e5248 + _e5249.member_1);
                                    let _e5256 = ((bitcast<u32>((bitcast<i32>(_e5237) >> bitcast<u32>(1u))) + _e5249.member) + select(0u, 1u, (_e5252 < _e5248)));
                                    let _e5259 = local_6[0u].member;
                                    let _e5261 = local_6[0u].member_1;
                                    let _e5264 = local_6[2u].member;
                                    let _e5266 = local_6[2u].member_1;
                                    let _e5267 = (_e5261 + _e5266);
                                    let _e5271 = ((_e5259 + _e5264) + select(0u, 1u, (_e5267 < _e5261)));
                                    let _e5282 = ((_e5267 >> bitcast<u32>(1u)) | ((_e5271 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5283 = function_8(17u);
                                    let _e5286 = (_e5282 + _e5283.member_1);
                                    let _e5290 = ((bitcast<u32>((bitcast<i32>(_e5271) >> bitcast<u32>(1u))) + _e5283.member) + select(0u, 1u, (_e5286 < _e5282)));
                                    let _e5293 = local_6[0u].member;
                                    let _e5295 = local_6[0u].member_1;
                                    let _e5298 = local_6[1u].member;
                                    let _e5300 = local_6[1u].member_1;
                                    let _e5301 = (_e5295 + _e5300);
                                    let _e5305 = ((_e5293 + _e5298) + select(0u, 1u, (_e5301 < _e5295)));
                                    let _e5316 = ((_e5301 >> bitcast<u32>(1u)) | ((_e5305 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                    let _e5317 = function_8(17u);
                                    let _e5320 = (_e5316 + _e5317.member_1);
                                    let _e5324 = ((bitcast<u32>((bitcast<i32>(_e5305) >> bitcast<u32>(1u))) + _e5317.member) + select(0u, 1u, (_e5320 < _e5316)));
                                    let _e5329 = ((_e5222.member >> bitcast<u32>(31i)) != 0u);
                                    if ((((_e5256 - select(_e5222.member, (~(_e5222.member) + select(0u, 1u, (_e5222.member_1 == 0u))), _e5329)) - select(0u, 1u, (_e5252 < select(_e5222.member_1, (~(_e5222.member_1) + 1u), _e5329)))) >> bitcast<u32>(31i)) != 0u) {
                                        let _e5350 = ((_e5222.member >> bitcast<u32>(31i)) != 0u);
                                        let _e5360 = select(_e5222.member, (~(_e5222.member) + select(0u, 1u, (_e5222.member_1 == 0u))), _e5350);
                                        let _e5362 = select(_e5222.member_1, (~(_e5222.member_1) + 1u), _e5350);
                                        let _e5363 = function_6(_e5195, _e5217);
                                        let _e5373 = select(_e5363.member, (~(_e5363.member) + select(0u, 1u, (_e5363.member_1 == 0u))), _e5350);
                                        let _e5375 = select(_e5363.member_1, (~(_e5363.member_1) + 1u), _e5350);
                                        let _e5376 = function_6(_e5206, _e5195);
                                        let _e5386 = select(_e5376.member, (~(_e5376.member) + select(0u, 1u, (_e5376.member_1 == 0u))), _e5350);
                                        let _e5388 = select(_e5376.member_1, (~(_e5376.member_1) + 1u), _e5350);
                                        if (_e240.member != 0u) {
                                            let _e5420 = (_e5252 + _e5286);
                                            let _e5432 = (_e5252 + _e5320);
                                            phi_8093_ = type_9(((_e5256 + _e5324) + select(0u, 1u, (_e5432 < _e5252))), _e5432);
                                            phi_8094_ = type_9(((_e5360 - _e5386) - select(0u, 1u, (_e5362 < _e5388))), (_e5362 - _e5388));
                                            phi_8095_ = type_9(((_e5256 + _e5290) + select(0u, 1u, (_e5420 < _e5252))), _e5420);
                                            phi_8096_ = type_9(((_e5360 - _e5373) - select(0u, 1u, (_e5362 < _e5375))), (_e5362 - _e5375));
                                        } else {
                                            let _e5394 = (_e5362 - _e5375);
                                            let _e5398 = ((((_e5360 - _e5373) - select(0u, 1u, (_e5362 < _e5375))) - _e5386) - select(0u, 1u, (_e5394 < _e5388)));
                                            let _e5399 = (_e5394 - _e5388);
                                            let _e5401 = (_e5252 + _e5286);
                                            let _e5406 = (_e5401 + _e5320);
                                            let _e5410 = ((((_e5256 + _e5290) + select(0u, 1u, (_e5401 < _e5252))) + _e5324) + select(0u, 1u, (_e5406 < _e5401)));
                                            phi_8093_ = type_9(_e5410, _e5406);
                                            phi_8094_ = type_9(_e5398, _e5399);
                                            phi_8095_ = type_9(_e5410, _e5406);
                                            phi_8096_ = type_9(_e5398, _e5399);
                                        }
                                        let _e5439 = phi_8093_;
                                        let _e5441 = phi_8094_;
                                        let _e5443 = phi_8095_;
                                        let _e5445 = phi_8096_;
                                        let _e5446 = function_4(_e5373, _e5375, _e5290, _e5286);
                                        if _e5446 {
                                            phi_8222_ = u32();
                                            phi_8223_ = true;
                                        } else {
                                            let _e5447 = function_4(_e5386, _e5388, _e5324, _e5320);
                                            if _e5447 {
                                                phi_8220_ = u32();
                                                phi_8221_ = true;
                                            } else {
                                                let _e5452 = function_4(_e5445.member, _e5445.member_1, _e5443.member, _e5443.member_1);
                                                if _e5452 {
                                                    phi_8218_ = u32();
                                                    phi_8219_ = true;
                                                } else {
                                                    let _e5457 = function_4(_e5441.member, _e5441.member_1, _e5439.member, _e5439.member_1);
                                                    if _e5457 {
                                                        phi_8217_ = u32();
                                                    } else {
                                                        let _e5458 = function_3(_e5373, _e5375, _e5290, _e5286);
                                                        if _e5458 {
                                                            let _e5459 = function_3(_e5386, _e5388, _e5324, _e5320);
                                                            if _e5459 {
                                                                let _e5464 = function_3(_e5445.member, _e5445.member_1, _e5443.member, _e5443.member_1);
                                                                if _e5464 {
                                                                    let _e5469 = function_3(_e5441.member, _e5441.member_1, _e5439.member, _e5439.member_1);
                                                                    phi_8210_ = select(true, false, _e5469);
                                                                } else {
                                                                    phi_8210_ = true;
                                                                }
                                                                let _e5472 = phi_8210_;
                                                                phi_8211_ = _e5472;
                                                            } else {
                                                                phi_8211_ = true;
                                                            }
                                                            let _e5474 = phi_8211_;
                                                            phi_8212_ = _e5474;
                                                        } else {
                                                            phi_8212_ = true;
                                                        }
                                                        let _e5476 = phi_8212_;
                                                        phi_8217_ = select(0u, 2u, _e5476);
                                                    }
                                                    let _e5479 = phi_8217_;
                                                    phi_8218_ = _e5479;
                                                    phi_8219_ = _e5457;
                                                }
                                                let _e5481 = phi_8218_;
                                                let _e5483 = phi_8219_;
                                                phi_8220_ = _e5481;
                                                phi_8221_ = _e5483;
                                            }
                                            let _e5485 = phi_8220_;
                                            let _e5487 = phi_8221_;
                                            phi_8222_ = _e5485;
                                            phi_8223_ = _e5487;
                                        }
                                        let _e5489 = phi_8222_;
                                        let _e5491 = phi_8223_;
                                        phi_8228_ = select(_e5489, 1u, _e5491);
                                    } else {
                                        phi_8228_ = 2u;
                                    }
                                    let _e5494 = phi_8228_;
                                    let _e5495 = (_e5494 == 1u);
                                    let _e5496 = (_e5494 == 0u);
                                    let _e5512 = local_87;
                                    if _e5512 {
                                        let _e6379 = local_109;
                                        phi_8300_ = _e6379;
                                        phi_8301_ = _e5495;
                                        phi_8302_ = select(true, false, _e5495);
                                        phi_8303_ = false;
                                        phi_8304_ = false;
                                    } else {
                                        let _e5516 = select(true, select(true, select(true, select(true, false, ((_e4428.member_1 - _e4428.member) <= _e1270)), select(false, (_e4428.member_1 <= _e1268), (_e4428.member >= _e1266))), _e4426), _e5496);
                                        let _e5518 = select(select(false, select((_e4428.member > _e1268), true, (_e4428.member_1 < _e1266)), _e4422), true, _e5495);
                                        let _e5519 = select(true, _e5518, select(((((select(0u, select(1u, 2u, ((_e3544[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3551.member - select(_e3564[0].member, (~(_e3544[0].member) + select(0u, 1u, (_e3548[0].member_1 == 0u))), _e3556)) - select(0u, 1u, (_e3551.member_1 < select(_e3564[0].member_1, (~(_e3548[0].member_1) + 1u), _e3556)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3583[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3590.member - select(_e3603[1].member, (~(_e3583[1].member) + select(0u, 1u, (_e3587[1].member_1 == 0u))), _e3595)) - select(0u, 1u, (_e3590.member_1 < select(_e3603[1].member_1, (~(_e3587[1].member_1) + 1u), _e3595)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3623[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3630.member - select(_e3643[2].member, (~(_e3623[2].member) + select(0u, 1u, (_e3627[2].member_1 == 0u))), _e3635)) - select(0u, 1u, (_e3630.member_1 < select(_e3643[2].member_1, (~(_e3627[2].member_1) + 1u), _e3635)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3663[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3670.member - select(_e3683[3].member, (~(_e3663[3].member) + select(0u, 1u, (_e3667[3].member_1 == 0u))), _e3675)) - select(0u, 1u, (_e3670.member_1 < select(_e3683[3].member_1, (~(_e3667[3].member_1) + 1u), _e3675)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e3704 == 31u), true, _e2788)));
                                        phi_8300_ = select(bool(), _e5518, _e5516);
                                        phi_8301_ = select(false, _e5519, _e5516);
                                        phi_8302_ = false;
                                        phi_8303_ = select(false, select(true, false, _e5519), _e5516);
                                        phi_8304_ = select(true, false, _e5516);
                                    }
                                    let _e5527 = phi_8300_;
                                    let _e5529 = phi_8301_;
                                    let _e5531 = phi_8302_;
                                    let _e5533 = phi_8303_;
                                    let _e5535 = phi_8304_;
                                    phi_8311_ = _e4422;
                                    phi_8312_ = _e4424;
                                    phi_8313_ = true;
                                    phi_8314_ = !(_e3796);
                                    phi_8315_ = _e4430;
                                    phi_8316_ = _e5527;
                                    phi_8317_ = _e5496;
                                    phi_8318_ = _e4428;
                                    phi_8319_ = _e5529;
                                    phi_8320_ = select(_e5531, false, _e5529);
                                    phi_8321_ = select(_e5533, false, _e5529);
                                    phi_8322_ = select(_e5535, false, _e5529);
                                }
                                let _e5540 = phi_8311_;
                                let _e5542 = phi_8312_;
                                let _e5544 = phi_8313_;
                                let _e5546 = phi_8314_;
                                let _e5548 = phi_8315_;
                                let _e5550 = phi_8316_;
                                let _e5552 = phi_8317_;
                                let _e5554 = phi_8318_;
                                let _e5556 = phi_8319_;
                                let _e5558 = phi_8320_;
                                let _e5560 = phi_8321_;
                                let _e5562 = phi_8322_;
                                phi_8323_ = _e5540;
                                phi_8324_ = _e5542;
                                phi_8325_ = _e5544;
                                phi_8326_ = _e5546;
                                phi_8327_ = _e5548;
                                phi_8328_ = _e5550;
                                phi_8329_ = _e5552;
                                phi_8330_ = _e5554;
                                phi_8331_ = _e5556;
                                phi_8332_ = _e5558;
                                phi_8333_ = _e5560;
                                phi_8334_ = _e5562;
                            } else {
                                phi_8323_ = _e2788;
                                phi_8324_ = _e2790;
                                let _e6406 = local_113;
                                phi_8325_ = _e6406;
                                let _e6409 = local_114;
                                phi_8326_ = _e6409;
                                phi_8327_ = _e2796;
                                let _e6413 = local_115;
                                phi_8328_ = _e6413;
                                phi_8329_ = bool();
                                phi_8330_ = type_17();
                                phi_8331_ = true;
                                phi_8332_ = false;
                                phi_8333_ = false;
                                phi_8334_ = false;
                            }
                            let _e5564 = phi_8323_;
                            let _e5566 = phi_8324_;
                            let _e5568 = phi_8325_;
                            let _e5570 = phi_8326_;
                            let _e5572 = phi_8327_;
                            let _e5574 = phi_8328_;
                            let _e5576 = phi_8329_;
                            let _e5578 = phi_8330_;
                            let _e5580 = phi_8331_;
                            let _e5582 = phi_8332_;
                            let _e5584 = phi_8333_;
                            let _e5586 = phi_8334_;
                            if _e5580 {
                                if _e5574 {
                                    let _e5590 = local_88;
                                    let _e5591 = (_e5590 + 1u);
                                    let _e5593 = local_89;
                                    let _e5595 = (_e5591 & (4294967295u - _e5593));
                                    let _e5601 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5595)), 32u, (_e5595 == 0u)));
                                    let _e5603 = local_90;
                                    let _e5606 = local_91;
                                    let _e5607 = select(_e5601, _e5606, (_e5603 < _e5601));
                                    let _e5610 = (_e5591 >> bitcast<u32>((_e5607 & 31u)));
                                    let _e5612 = local_92;
                                    let _e5613 = (_e5612 - _e5607);
                                    let _e5615 = local_93;
                                    let _e5616 = (_e5615 > _e1268);
                                    if _e5616 {
                                        phi_8385_ = u32();
                                        phi_8386_ = u32();
                                        phi_8387_ = false;
                                        phi_8388_ = false;
                                    } else {
                                        let _e5620 = select(true, select(true, false, (_e5613 == 0u)), (_e5610 == 1u));
                                        let _e5621 = (31u - _e5613);
                                        phi_8385_ = select(u32(), ((_e5610 + 1u) << bitcast<u32>((_e5621 & 31u))), _e5620);
                                        phi_8386_ = select(u32(), (_e5610 << bitcast<u32>((_e5621 & 31u))), _e5620);
                                        phi_8387_ = _e5620;
                                        phi_8388_ = select(true, false, _e5620);
                                    }
                                    let _e5633 = phi_8385_;
                                    let _e5635 = phi_8386_;
                                    let _e5637 = phi_8387_;
                                    let _e5639 = phi_8388_;
                                    phi_8389_ = _e5633;
                                    phi_8390_ = _e5635;
                                    phi_8391_ = false;
                                    phi_8392_ = false;
                                    phi_8393_ = false;
                                    phi_8394_ = false;
                                    phi_8395_ = _e5613;
                                    phi_8396_ = _e5610;
                                    phi_8397_ = _e5637;
                                    phi_8398_ = _e5616;
                                    phi_8399_ = _e5639;
                                } else {
                                    phi_8389_ = _e5572.member_1;
                                    phi_8390_ = _e5572.member;
                                    phi_8391_ = _e5564;
                                    phi_8392_ = _e5566;
                                    phi_8393_ = _e5568;
                                    phi_8394_ = _e5570;
                                    let _e6438 = local_116;
                                    phi_8395_ = _e6438;
                                    let _e6441 = local_117;
                                    phi_8396_ = _e6441;
                                    phi_8397_ = true;
                                    phi_8398_ = false;
                                    phi_8399_ = false;
                                }
                                let _e5641 = phi_8389_;
                                let _e5643 = phi_8390_;
                                let _e5645 = phi_8391_;
                                let _e5647 = phi_8392_;
                                let _e5649 = phi_8393_;
                                let _e5651 = phi_8394_;
                                let _e5653 = phi_8395_;
                                let _e5655 = phi_8396_;
                                let _e5657 = phi_8397_;
                                let _e5659 = phi_8398_;
                                let _e5661 = phi_8399_;
                                if _e5657 {
                                    if select(_e5645, true, _e5574) {
                                        let _e5668 = function_1(((_e2667 - _e2594.member) - select(0u, 1u, (_e2663 < _e2594.member_1))), (_e2663 - _e2594.member_1), _e5643);
                                        let _e5671 = (_e2594.member_1 + _e5668.member_1);
                                        let _e5681 = function_1(((_e2738 - _e2667) - select(0u, 1u, (_e2734 < _e2663))), (_e2734 - _e2663), _e5643);
                                        let _e5684 = (_e2663 + _e5681.member_1);
                                        let _e5694 = function_1(((_e2772.member - _e2738) - select(0u, 1u, (_e2772.member_1 < _e2734))), (_e2772.member_1 - _e2734), _e5643);
                                        let _e5697 = (_e2734 + _e5694.member_1);
                                        let _e5705 = array<type_9, 3>(type_9(((_e2594.member + _e5668.member) + select(0u, 1u, (_e5671 < _e2594.member_1))), _e5671), type_9(((_e2667 + _e5681.member) + select(0u, 1u, (_e5684 < _e2663))), _e5684), type_9(((_e2738 + _e5694.member) + select(0u, 1u, (_e5697 < _e2734))), _e5697));
                                        let _e5711 = function_1(((_e2667 - _e2594.member) - select(0u, 1u, (_e2663 < _e2594.member_1))), (_e2663 - _e2594.member_1), _e5641);
                                        let _e5714 = (_e2594.member_1 + _e5711.member_1);
                                        let _e5724 = function_1(((_e2738 - _e2667) - select(0u, 1u, (_e2734 < _e2663))), (_e2734 - _e2663), _e5641);
                                        let _e5727 = (_e2663 + _e5724.member_1);
                                        let _e5737 = function_1(((_e2772.member - _e2738) - select(0u, 1u, (_e2772.member_1 < _e2734))), (_e2772.member_1 - _e2734), _e5641);
                                        let _e5740 = (_e2734 + _e5737.member_1);
                                        let _e5749 = function_2(_e5705, _e5643);
                                        let _e5750 = function_2(_e5705, _e5641);
                                        let _e5751 = function_2(array<type_9, 3>(type_9(((_e2594.member + _e5711.member) + select(0u, 1u, (_e5714 < _e2594.member_1))), _e5714), type_9(((_e2667 + _e5724.member) + select(0u, 1u, (_e5727 < _e2663))), _e5727), type_9(((_e2738 + _e5737.member) + select(0u, 1u, (_e5740 < _e2734))), _e5740)), _e5641);
                                        let _e5765 = function_1(((_e5749[1].member - _e5749[0].member) - select(0u, 1u, (_e5749[1].member_1 < _e5749[0].member_1))), (_e5749[1].member_1 - _e5749[0].member_1), _e5643);
                                        let _e5768 = (_e5749[0].member_1 + _e5765.member_1);
                                        let _e5786 = function_1(((_e5749[1].member - _e5749[0].member) - select(0u, 1u, (_e5749[1].member_1 < _e5749[0].member_1))), (_e5749[1].member_1 - _e5749[0].member_1), _e5641);
                                        let _e5789 = (_e5749[0].member_1 + _e5786.member_1);
                                        let _e5807 = function_1(((_e5750[1].member - _e5750[0].member) - select(0u, 1u, (_e5750[1].member_1 < _e5750[0].member_1))), (_e5750[1].member_1 - _e5750[0].member_1), _e5641);
                                        let _e5810 = (_e5750[0].member_1 + _e5807.member_1);
                                        let _e5828 = function_1(((_e5751[1].member - _e5751[0].member) - select(0u, 1u, (_e5751[1].member_1 < _e5751[0].member_1))), (_e5751[1].member_1 - _e5751[0].member_1), _e5641);
                                        let _e5831 = (_e5751[0].member_1 + _e5828.member_1);
                                        phi_8666_ = array<type_9, 4>(type_9(((_e5749[0].member + _e5765.member) + select(0u, 1u, (_e5768 < _e5749[0].member_1))), _e5768), type_9(((_e5749[0].member + _e5786.member) + select(0u, 1u, (_e5789 < _e5749[0].member_1))), _e5789), type_9(((_e5750[0].member + _e5807.member) + select(0u, 1u, (_e5810 < _e5750[0].member_1))), _e5810), type_9(((_e5751[0].member + _e5828.member) + select(0u, 1u, (_e5831 < _e5751[0].member_1))), _e5831));
                                    } else {
                                        let _e6447 = local_118;
                                        phi_8666_ = _e6447;
                                    }
                                    let _e5842 = phi_8666_;
                                    phi_8667_ = _e5842;
                                    phi_8668_ = false;
                                    phi_8669_ = false;
                                } else {
                                    phi_8667_ = array<type_9, 4>();
                                    phi_8668_ = _e5659;
                                    phi_8669_ = _e5661;
                                }
                                let _e5844 = phi_8667_;
                                let _e5846 = phi_8668_;
                                let _e5848 = phi_8669_;
                                phi_8670_ = _e5844;
                                phi_8671_ = _e5645;
                                phi_8672_ = _e5647;
                                phi_8673_ = _e5649;
                                phi_8674_ = _e5651;
                                phi_8675_ = _e5653;
                                phi_8676_ = _e5655;
                                phi_8677_ = _e5657;
                                phi_8678_ = _e5846;
                                phi_8679_ = _e5848;
                                phi_8680_ = false;
                                phi_8681_ = false;
                                phi_8682_ = false;
                            } else {
                                phi_8670_ = array<type_9, 4>();
                                phi_8671_ = bool();
                                phi_8672_ = bool();
                                phi_8673_ = bool();
                                phi_8674_ = bool();
                                phi_8675_ = u32();
                                phi_8676_ = u32();
                                phi_8677_ = false;
                                phi_8678_ = false;
                                phi_8679_ = false;
                                phi_8680_ = _e5582;
                                phi_8681_ = _e5584;
                                phi_8682_ = _e5586;
                            }
                            let _e5850 = phi_8670_;
                            let _e5852 = phi_8671_;
                            let _e5854 = phi_8672_;
                            let _e5856 = phi_8673_;
                            let _e5858 = phi_8674_;
                            let _e5860 = phi_8675_;
                            let _e5862 = phi_8676_;
                            let _e5864 = phi_8677_;
                            let _e5866 = phi_8678_;
                            let _e5868 = phi_8679_;
                            let _e5870 = phi_8680_;
                            let _e5872 = phi_8681_;
                            let _e5874 = phi_8682_;
                            phi_4492_ = _e5850;
                            phi_4495_ = _e5852;
                            phi_4497_ = _e5854;
                            phi_4499_ = _e5856;
                            phi_4501_ = _e5858;
                            phi_4503_ = _e5572;
                            let _e6472 = local_119;
                            phi_4507_ = _e6472;
                            let _e6475 = local_120;
                            phi_4509_ = _e6475;
                            let _e6478 = local_121;
                            phi_4511_ = _e6478;
                            phi_4513_ = _e5860;
                            phi_4515_ = _e5862;
                            phi_8683_ = _e5576;
                            phi_8684_ = _e5578;
                            phi_8685_ = _e5864;
                            phi_8686_ = false;
                            phi_8687_ = _e5866;
                            phi_8688_ = _e5868;
                            phi_8689_ = _e5870;
                            phi_8690_ = _e5872;
                            phi_8691_ = _e5874;
                        } else {
                            phi_4492_ = array<type_9, 4>();
                            phi_4495_ = bool();
                            phi_4497_ = bool();
                            phi_4499_ = bool();
                            phi_4501_ = bool();
                            phi_4503_ = type_17();
                            phi_4507_ = u32();
                            phi_4509_ = u32();
                            phi_4511_ = u32();
                            phi_4513_ = u32();
                            phi_4515_ = u32();
                            phi_8683_ = bool();
                            phi_8684_ = type_17();
                            phi_8685_ = false;
                            phi_8686_ = true;
                            phi_8687_ = false;
                            phi_8688_ = false;
                            phi_8689_ = false;
                            phi_8690_ = false;
                            phi_8691_ = false;
                        }
                        let _e5876 = phi_4492_;
                        let _e5878 = phi_4495_;
                        let _e5880 = phi_4497_;
                        let _e5882 = phi_4499_;
                        let _e5884 = phi_4501_;
                        let _e5886 = phi_4503_;
                        let _e5888 = phi_4507_;
                        let _e5890 = phi_4509_;
                        let _e5892 = phi_4511_;
                        let _e5894 = phi_4513_;
                        let _e5896 = phi_4515_;
                        let _e5898 = phi_8683_;
                        let _e5900 = phi_8684_;
                        let _e5902 = phi_8685_;
                        let _e5904 = phi_8686_;
                        let _e5906 = phi_8687_;
                        let _e5908 = phi_8688_;
                        let _e5910 = phi_8689_;
                        let _e5912 = phi_8690_;
                        let _e5914 = phi_8691_;
                        local_94 = _e5904;
                        local_95 = _e5904;
                        local_96 = _e5904;
                        local_97 = _e5906;
                        local_98 = _e5904;
                        local_99 = _e5908;
                        local_100 = _e5904;
                        local_101 = _e5910;
                        local_102 = _e5904;
                        local_103 = _e5912;
                        local_104 = _e5904;
                        local_105 = _e5914;
                        local_106 = _e5898;
                        local_107 = _e5898;
                        local_108 = _e5900;
                        continue;
                        continuing {
                            phi_4491_ = _e5876;
                            phi_4494_ = _e5878;
                            phi_4496_ = _e5880;
                            phi_4498_ = _e5882;
                            phi_4500_ = _e5884;
                            phi_4502_ = _e5886;
                            phi_4506_ = _e5888;
                            phi_4508_ = _e5890;
                            phi_4510_ = _e5892;
                            phi_4512_ = _e5894;
                            phi_4514_ = _e5896;
                            break if !(_e5902);
                        }
                    }
                    let _e5918 = local_94;
                    let _e5923 = local_95;
                    let _e5926 = local_96;
                    let _e5928 = local_97;
                    let _e5929 = select(_e5928, false, _e5926);
                    let _e5931 = local_98;
                    let _e5933 = local_99;
                    let _e5936 = local_100;
                    let _e5938 = local_101;
                    let _e5941 = local_102;
                    let _e5943 = local_103;
                    let _e5946 = local_104;
                    let _e5948 = local_105;
                    let _e5950 = select(select(_e5933, false, _e5931), false, _e5929);
                    let _e5954 = select(_e5929, true, _e5950);
                    let _e5963 = select(select(select(select(_e5938, false, _e5936), false, _e5929), false, _e5950), false, _e5954);
                    if _e5963 {
                        let _e5967 = local_106;
                        let _e5972 = local_107;
                        phi_8733_ = type_9(select(2u, 3u, _e5967), select(type_9().member_1, type_9().member_1, _e5972));
                        phi_8734_ = false;
                        phi_8735_ = false;
                        phi_8736_ = false;
                    } else {
                        phi_8733_ = type_9();
                        phi_8734_ = select(select(select(select(_e5943, false, _e5941), false, _e5929), false, _e5950), false, _e5954);
                        phi_8735_ = select(select(select(select(_e5948, false, _e5946), false, _e5929), false, _e5950), false, _e5954);
                        phi_8736_ = _e5954;
                    }
                    let _e5976 = phi_8733_;
                    let _e5978 = phi_8734_;
                    let _e5980 = phi_8735_;
                    let _e5982 = phi_8736_;
                    let _e5988 = select(_e5980, false, _e5978);
                    let _e5992 = local_108;
                    let _e5996 = select(_e5978, true, _e5988);
                    let _e6003 = select(select(select(_e5963, false, _e5978), false, _e5988), true, _e5996);
                    let _e6007 = select(select(select(select(_e5982, false, _e5978), false, _e5988), false, _e5996), true, _e6003);
                    phi_8772_ = type_9(select(select(type_9().member, 2u, _e5918), select(select(type_9().member, 0u, _e5954), select(_e5976.member, select(select(type_9().member, 2u, _e5978), 1u, _e5988), _e5996), _e6003), _e6007), select(select(type_9().member_1, type_9().member_1, _e5923), select(select(type_9().member_1, type_9().member_1, _e5954), select(_e5976.member_1, select(select(type_9().member_1, type_9().member_1, _e5978), _e5992.member, _e5988), _e5996), _e6003), _e6007));
                }
                let _e6014 = phi_8772_;
                let _e6018 = params.member.member_2.member_1;
                switch bitcast<i32>(_e6014.member) {
                    case 0: {
                        phi_8809_ = type_27(0u, 0u, array<u32, 2>(0u, 0u), false);
                        phi_8810_ = false;
                        break;
                    }
                    case 1: {
                        if (_e6014.member_1 == 0u) {
                            phi_8806_ = array<u32, 2>(0u, 0u);
                        } else {
                            let _e6027 = select((bitcast<u32>(31i) - firstLeadingBit(_e6014.member_1)), 32u, (_e6014.member_1 == 0u));
                            let _e6032 = ((_e6014.member_1 << bitcast<u32>((_e6027 & 31u))) << bitcast<u32>(1i));
                            phi_8806_ = array<u32, 2>((_e6032 << bitcast<u32>(20i)), (((1023u - _e6027) << bitcast<u32>(20i)) | (_e6032 >> bitcast<u32>(12i))));
                        }
                        let _e6043 = phi_8806_;
                        phi_8809_ = type_27(0u, select(0u, 1u, (_e6014.member_1 > _e6018)), _e6043, true);
                        phi_8810_ = false;
                        break;
                    }
                    case 2: {
                        phi_8809_ = type_27();
                        phi_8810_ = true;
                        break;
                    }
                    case 3: {
                        phi_8809_ = type_27();
                        phi_8810_ = true;
                        break;
                    }
                    default: {
                        phi_8809_ = type_27();
                        phi_8810_ = bool();
                        break;
                    }
                }
                let _e6046 = phi_8809_;
                let _e6048 = phi_8810_;
                if _e6048 {
                    phi_8814_ = type_27(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    phi_8814_ = _e6046;
                }
                let _e6050 = phi_8814_;
                let _e6053 = global.member;
                if (bitcast<i32>(_e6014.member) == bitcast<i32>(_e6053)) {
                    if (bitcast<i32>(_e6014.member) == 1i) {
                        let _e6059 = global.member;
                        if (bitcast<i32>(_e6059) == 1i) {
                            let _e6063 = global.member_1;
                            phi_8842_ = (_e6014.member_1 == _e6063);
                            phi_8843_ = false;
                        } else {
                            phi_8842_ = bool();
                            phi_8843_ = true;
                        }
                        let _e6066 = phi_8842_;
                        let _e6068 = phi_8843_;
                        phi_8844_ = _e6066;
                        phi_8845_ = _e6068;
                    } else {
                        phi_8844_ = bool();
                        phi_8845_ = true;
                    }
                    let _e6070 = phi_8844_;
                    let _e6072 = phi_8845_;
                    phi_8850_ = select(_e6070, true, _e6072);
                } else {
                    phi_8850_ = false;
                }
                let _e6075 = phi_8850_;
                phi_8861_ = _e6050;
                phi_8862_ = type_9(select(_e198, (_e198 | 2147483648u), _e6075), _e201);
            } else {
                phi_8861_ = type_27(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_8862_ = type_9(0u, 0u);
            }
            let _e6080 = phi_8861_;
            let _e6082 = phi_8862_;
            let _e6087 = (_e6080.member != 0u);
            let _e6090 = select(false, !(_e6087), _e6080.member_3);
            if _e6090 {
                let _e6094 = (_e6080.member_2[1] >> bitcast<u32>(20i));
                if (_e6094 <= 896u) {
                    phi_8893_ = 0u;
                } else {
                    phi_8893_ = ((((_e6094 - 896u) << bitcast<u32>(23i)) | ((_e6080.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e6080.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e6109 = phi_8893_;
                let _e6111 = atomicMin((&earliest.member[0u]), _e6109);
            }
            let _e6114 = params.member.member.member_1;
            if ((_e6114 & 16u) != 0u) {
                if (_e114 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e6090 {
                    let _e6120 = atomicAdd((&counters[0u]), 1u);
                    phi_8915_ = _e6120;
                } else {
                    phi_8915_ = 0u;
                }
                let _e6122 = phi_8915_;
                workgroupBarrier();
                if (_e114 == 0u) {
                    let _e6125 = atomicLoad((&counters[0u]));
                    if (_e6125 > 0u) {
                        let _e6128 = atomicAdd((&contacts.member[0u]), _e6125);
                        atomicStore((&counters[1u]), _e6128);
                    }
                }
                workgroupBarrier();
                let _e6131 = atomicLoad((&counters[1u]));
                let _e6132 = (_e6131 + _e6122);
                if _e6090 {
                    let _e6135 = params.member.member_1.member_3;
                    if (_e6132 < _e6135) {
                        let _e6141 = (7u * _e6132);
                        atomicStore((&contacts.member[(4u + _e6141)]), select(1u, 0u, ((_e6082.member_1 & 2147483648u) == 0u)));
                        atomicStore((&contacts.member[(_e6141 + 5u)]), _e6080.member);
                        atomicStore((&contacts.member[(_e6141 + 6u)]), _e6082.member);
                        atomicStore((&contacts.member[(_e6141 + 7u)]), (_e6082.member_1 & 2147483647u));
                        atomicStore((&contacts.member[(_e6141 + 8u)]), _e6080.member_2[0]);
                        atomicStore((&contacts.member[(_e6141 + 9u)]), _e6080.member_2[1]);
                        atomicStore((&contacts.member[(_e6141 + 10u)]), _e6080.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e114 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e6087 {
                let _e6165 = atomicAdd((&counters[0u]), 1u);
                phi_8992_ = _e6165;
            } else {
                phi_8992_ = 0u;
            }
            let _e6167 = phi_8992_;
            workgroupBarrier();
            if (_e114 == 0u) {
                let _e6170 = atomicLoad((&counters[0u]));
                if (_e6170 > 0u) {
                    let _e6173 = atomicAdd((&left.member[0u]), _e6170);
                    atomicStore((&counters[1u]), _e6173);
                }
            }
            workgroupBarrier();
            let _e6176 = atomicLoad((&counters[1u]));
            let _e6177 = (_e6176 + _e6167);
            if _e6087 {
                let _e6179 = params.member.member_2.member.member;
                if (_e6177 < _e6179) {
                    let _e6181 = (2u * _e6177);
                    atomicStore((&left.member[(4u + _e6181)]), _e6082.member);
                    atomicStore((&left.member[(_e6181 + 5u)]), _e6082.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_351_ = type_9(select(_e169.member, (_e169.member + 1u), _e172), select(_e169.member_1, _e169.member_1, _e172));
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_integers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_11(id, n, lane);
}
