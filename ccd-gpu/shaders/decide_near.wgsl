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

struct type_19 {
    member: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_30 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_31 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_32 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_33 {
    member: type_28,
    member_1: f32,
}

struct type_34 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: type_34,
    member_1: u32,
}

struct type_36 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_25;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_40;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_40;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_40;

fn function_(param: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])));
    return array<f32, 3>(select(param_1[0], param_2[0], _e24), select(param_1[1], param_2[1], _e24), select(param_1[2], param_2[2], _e24));
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_8425_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e151 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e155 = select(0f, select(1f, _e151, (_e151 < 1f)), (_e151 > 0f));
        let _e191 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e195 = select(0f, select(1f, _e191, (_e191 < 1f)), (_e191 > 0f));
        let _e228 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e232 = select(0f, select(1f, _e228, (_e228 < 1f)), (_e228 > 0f));
        let _e245 = (param_3[0] - param_5[0]);
        let _e248 = (param_3[1] - param_5[1]);
        let _e251 = (param_3[2] - param_5[2]);
        let _e271 = ((((_e245 * param_4[0]) + (_e248 * param_4[1])) + (_e251 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e275 = select(0f, select(1f, _e271, (_e271 < 1f)), (_e271 > 0f));
        phi_8425_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e40 = select(0f, select(1f, _e36, (_e36 < 1f)), (_e36 > 0f));
        let _e47 = array<f32, 3>((_e9 - (_e19 * _e40)), (_e12 - (_e22 * _e40)), (_e15 - (_e25 * _e40)));
        let _e70 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e74 = select(0f, select(1f, _e70, (_e70 < 1f)), (_e70 > 0f));
        let _e110 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e114 = select(0f, select(1f, _e110, (_e110 < 1f)), (_e110 > 0f));
        phi_8425_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8425_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8053_: bool;
    var phi_8086_: array<f32, 3>;
    var phi_8087_: bool;
    var phi_8088_: array<f32, 3>;
    var phi_8089_: bool;
    var phi_8094_: array<f32, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        let _e89 = (_e74 >= 0f);
        let _e90 = (_e78 >= 0f);
        let _e91 = (_e74 <= 1f);
        phi_8053_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8053_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8053_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8086_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8087_ = false;
        } else {
            phi_8086_ = array<f32, 3>();
            phi_8087_ = true;
        }
        let _e129 = phi_8086_;
        let _e131 = phi_8087_;
        phi_8088_ = _e129;
        phi_8089_ = _e131;
    } else {
        phi_8088_ = array<f32, 3>();
        phi_8089_ = true;
    }
    let _e133 = phi_8088_;
    let _e135 = phi_8089_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8094_ = _e136;
    } else {
        phi_8094_ = _e133;
    }
    let _e138 = phi_8094_;
    return _e138;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_30;
    var local_2: type_31;
    var local_3: type_31;
    var local_4: type_31;
    var local_5: type_28;
    var phi_231_: u32;
    var phi_277_: u32;
    var phi_280_: type_9;
    var phi_463_: type_22;
    var phi_598_: type_28;
    var phi_627_: bool;
    var phi_875_: bool;
    var phi_969_: type_33;
    var phi_970_: bool;
    var phi_971_: type_33;
    var phi_972_: bool;
    var phi_973_: type_33;
    var phi_974_: bool;
    var phi_979_: type_33;
    var phi_1149_: type_14;
    var phi_1152_: f32;
    var phi_1150_: type_14;
    var phi_1193_: type_15;
    var phi_1153_: f32;
    var local_6: f32;
    var phi_1206_: f32;
    var phi_2115_: type_35;
    var phi_2116_: bool;
    var phi_2117_: type_35;
    var phi_2118_: bool;
    var phi_2124_: type_14;
    var phi_2127_: f32;
    var phi_2129_: u32;
    var phi_2131_: f32;
    var phi_2125_: type_14;
    var phi_2172_: type_15;
    var phi_2609_: type_9;
    var phi_2612_: f32;
    var phi_2614_: f32;
    var phi_2616_: f32;
    var phi_2618_: f32;
    var phi_2620_: bool;
    var phi_2622_: u32;
    var phi_2773_: array<f32, 3>;
    var phi_2839_: type_14;
    var phi_2842_: f32;
    var phi_2840_: type_14;
    var phi_2883_: type_15;
    var phi_2843_: f32;
    var local_7: f32;
    var phi_2896_: f32;
    var phi_3019_: type_31;
    var phi_3020_: bool;
    var phi_3021_: type_31;
    var phi_3022_: bool;
    var phi_3030_: type_31;
    var phi_3201_: bool;
    var phi_3202_: bool;
    var phi_3203_: bool;
    var phi_3204_: bool;
    var phi_3205_: bool;
    var phi_3206_: bool;
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var phi_3510_: bool;
    var phi_3511_: bool;
    var phi_3512_: bool;
    var phi_3520_: bool;
    var phi_3627_: f32;
    var phi_3628_: bool;
    var phi_3629_: f32;
    var phi_3630_: bool;
    var phi_3631_: f32;
    var phi_3632_: bool;
    var phi_3633_: bool;
    var phi_3695_: f32;
    var phi_3696_: bool;
    var phi_3697_: f32;
    var phi_3698_: bool;
    var phi_3699_: f32;
    var phi_3700_: bool;
    var phi_3701_: bool;
    var phi_3768_: f32;
    var phi_3769_: bool;
    var phi_3770_: f32;
    var phi_3771_: bool;
    var phi_3772_: f32;
    var phi_3773_: bool;
    var phi_3774_: bool;
    var phi_3836_: f32;
    var phi_3837_: bool;
    var phi_3838_: f32;
    var phi_3839_: bool;
    var phi_3840_: f32;
    var phi_3841_: bool;
    var phi_3842_: bool;
    var phi_4016_: type_14;
    var phi_4019_: f32;
    var phi_4017_: type_14;
    var phi_4060_: type_15;
    var phi_4020_: f32;
    var local_8: f32;
    var phi_4073_: f32;
    var phi_4344_: bool;
    var phi_4345_: bool;
    var phi_4371_: f32;
    var phi_4372_: f32;
    var phi_4373_: bool;
    var phi_4374_: bool;
    var phi_4375_: f32;
    var phi_4376_: f32;
    var phi_4377_: f32;
    var phi_4378_: f32;
    var phi_4379_: bool;
    var phi_4380_: bool;
    var phi_4381_: bool;
    var phi_4382_: bool;
    var phi_4383_: f32;
    var phi_4384_: f32;
    var phi_4385_: f32;
    var phi_4386_: f32;
    var phi_4387_: bool;
    var phi_4388_: bool;
    var phi_4389_: bool;
    var phi_4390_: bool;
    var phi_4391_: bool;
    var phi_4392_: f32;
    var phi_4393_: f32;
    var phi_4394_: f32;
    var phi_4395_: f32;
    var phi_4396_: bool;
    var phi_4397_: bool;
    var phi_4398_: bool;
    var phi_4399_: bool;
    var phi_4400_: bool;
    var phi_4733_: f32;
    var phi_4735_: u32;
    var phi_4736_: f32;
    var phi_4737_: bool;
    var phi_4738_: bool;
    var phi_4739_: bool;
    var phi_4740_: u32;
    var phi_4741_: f32;
    var phi_4742_: f32;
    var phi_4743_: f32;
    var phi_4744_: f32;
    var phi_4745_: bool;
    var phi_4746_: u32;
    var phi_4747_: bool;
    var phi_4748_: bool;
    var phi_4749_: bool;
    var phi_4750_: bool;
    var phi_4751_: bool;
    var phi_4752_: bool;
    var phi_4780_: f32;
    var phi_4781_: f32;
    var phi_4782_: f32;
    var phi_4783_: f32;
    var phi_4784_: bool;
    var phi_4785_: u32;
    var phi_4786_: bool;
    var phi_4787_: bool;
    var phi_4788_: bool;
    var phi_4789_: bool;
    var phi_4790_: bool;
    var phi_4791_: bool;
    var phi_2613_: f32;
    var phi_2615_: f32;
    var phi_2617_: f32;
    var phi_2619_: f32;
    var phi_2621_: bool;
    var phi_2623_: u32;
    var phi_4792_: f32;
    var phi_4793_: f32;
    var phi_4794_: bool;
    var phi_4795_: bool;
    var phi_4796_: bool;
    var phi_4797_: bool;
    var phi_4798_: bool;
    var phi_4799_: bool;
    var phi_4800_: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: f32;
    var local_20: bool;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var phi_4867_: f32;
    var phi_4868_: bool;
    var phi_5488_: type_14;
    var phi_5491_: f32;
    var phi_5489_: type_14;
    var phi_5532_: type_15;
    var phi_5492_: f32;
    var local_24: f32;
    var phi_5545_: f32;
    var phi_5780_: type_14;
    var phi_5783_: f32;
    var phi_5781_: type_14;
    var phi_5824_: type_15;
    var phi_5784_: f32;
    var local_25: f32;
    var phi_5837_: f32;
    var phi_5869_: type_14;
    var phi_5872_: f32;
    var phi_5870_: type_14;
    var phi_5913_: type_15;
    var phi_5873_: f32;
    var local_26: f32;
    var phi_5926_: f32;
    var phi_6234_: type_9;
    var phi_6237_: f32;
    var phi_6238_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_6336_: type_14;
    var phi_6339_: f32;
    var phi_6337_: type_14;
    var phi_6380_: type_15;
    var phi_6340_: f32;
    var local_29: f32;
    var phi_6393_: f32;
    var phi_6398_: type_9;
    var phi_6401_: f32;
    var phi_6403_: bool;
    var phi_6405_: bool;
    var phi_6635_: f32;
    var phi_6636_: f32;
    var phi_6402_: f32;
    var phi_6404_: bool;
    var phi_6406_: bool;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_6651_: type_36;
    var phi_6652_: bool;
    var local_36: bool;
    var phi_6673_: type_9;
    var phi_6676_: f32;
    var phi_6678_: f32;
    var phi_6785_: f32;
    var phi_6786_: f32;
    var phi_6787_: f32;
    var phi_6788_: f32;
    var phi_6677_: f32;
    var phi_6679_: f32;
    var local_37: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6949_: bool;
    var phi_6950_: bool;
    var phi_6951_: bool;
    var phi_6952_: bool;
    var phi_6953_: bool;
    var phi_6954_: bool;
    var phi_6963_: bool;
    var phi_6964_: bool;
    var phi_6971_: type_36;
    var phi_6972_: type_36;
    var phi_6973_: bool;
    var phi_6974_: type_36;
    var phi_6975_: type_36;
    var phi_6976_: bool;
    var phi_6981_: type_36;
    var phi_6982_: type_36;
    var phi_6983_: bool;
    var phi_6987_: type_36;
    var phi_6988_: type_36;
    var phi_6989_: bool;
    var phi_6990_: bool;
    var phi_6991_: type_36;
    var phi_6992_: type_36;
    var phi_6993_: bool;
    var phi_6994_: bool;
    var phi_7028_: f32;
    var phi_7029_: f32;
    var phi_7030_: bool;
    var phi_7031_: bool;
    var phi_7032_: bool;
    var phi_7033_: f32;
    var phi_7034_: u32;
    var phi_7035_: f32;
    var phi_7036_: type_36;
    var phi_7037_: u32;
    var phi_7038_: u32;
    var phi_7039_: bool;
    var phi_7040_: bool;
    var phi_7041_: bool;
    var phi_7042_: f32;
    var phi_7043_: u32;
    var phi_7044_: f32;
    var phi_7045_: type_36;
    var phi_7046_: u32;
    var phi_7047_: u32;
    var phi_7048_: bool;
    var phi_7049_: bool;
    var phi_7050_: bool;
    var phi_7051_: bool;
    var phi_7052_: bool;
    var phi_7053_: f32;
    var phi_2128_: f32;
    var phi_2130_: u32;
    var phi_2132_: f32;
    var phi_7054_: type_36;
    var phi_7055_: u32;
    var phi_7056_: f32;
    var phi_7057_: u32;
    var phi_7058_: bool;
    var phi_7059_: bool;
    var phi_7060_: bool;
    var phi_7061_: bool;
    var phi_7062_: bool;
    var phi_7063_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_36;
    var local_49: type_36;
    var local_50: u32;
    var local_51: type_36;
    var phi_7092_: type_35;
    var phi_7093_: type_35;
    var phi_7094_: bool;
    var phi_7095_: bool;
    var phi_7096_: bool;
    var phi_7097_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: u32;
    var phi_7129_: type_9;
    var phi_7304_: type_14;
    var phi_7307_: f32;
    var phi_7305_: type_14;
    var phi_7348_: type_15;
    var phi_7308_: f32;
    var local_58: f32;
    var phi_7361_: f32;
    var phi_7632_: bool;
    var phi_7633_: bool;
    var local_59: bool;
    var phi_7645_: type_35;
    var phi_7646_: bool;
    var phi_7658_: type_35;
    var phi_7659_: type_35;
    var phi_7660_: bool;
    var phi_7661_: bool;
    var phi_7668_: type_35;
    var phi_7669_: bool;
    var phi_7673_: type_35;
    var phi_7674_: type_35;
    var phi_7675_: bool;
    var phi_7679_: type_35;
    var phi_7697_: type_32;
    var phi_7737_: bool;
    var phi_7753_: bool;
    var phi_7772_: type_32;
    var phi_7773_: type_32;
    var phi_7774_: type_9;
    var phi_7804_: u32;
    var phi_7826_: u32;
    var phi_7903_: u32;
    var local_60: bool;
    var local_61: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e101 = id_2;
    let _e102 = n_2;
    let _e103 = lane_2;
    let _e115 = ((_e101.y * _e102.x) + _e101.x);
    let _e118 = (_e102.x * _e102.y);
    let _e121 = params.member.member_1.member_2;
    let _e123 = input.member[0u];
    let _e125 = select(_e123, _e121, (_e121 < _e123));
    let _e127 = params.member.member_1.member_1;
    if (_e125 > _e127) {
        let _e130 = params.member.member_1.member_1;
        phi_231_ = (_e125 - _e130);
    } else {
        phi_231_ = 0u;
    }
    let _e133 = phi_231_;
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
        phi_277_ = select(_e147, (_e147 + 1u), ((_e145 % _e118) > 0u));
    } else {
        phi_277_ = 0u;
    }
    let _e154 = phi_277_;
    phi_280_ = type_9(0u, _e154);
    loop {
        let _e157 = phi_280_;
        let _e160 = (_e157.member < _e157.member_1);
        let _e173 = (bitcast<i32>(select(0u, 1u, _e160)) != 0i);
        if _e173 {
            let _e177 = (((_e115 + (select(type_9().member_1, _e157.member, _e160) * _e118)) * 64u) + _e103);
            if (_e177 < _e137) {
                let _e181 = params.member.member_1.member_1;
                let _e183 = (2u * (_e181 + _e177));
                let _e186 = input.member[(4u + _e183)];
                let _e189 = input.member[(_e183 + 5u)];
                let _e190 = (_e186 & 2147483647u);
                if ((_e186 & 2147483648u) != 0u) {
                    phi_7772_ = type_32(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    let _e197 = (_e189 & 2147483647u);
                    if (select(1u, 0u, ((_e189 & 2147483648u) == 0u)) == 0u) {
                        let _e216 = params.member.member.member[1u];
                        let _e219 = ((2u * _e216) + (3u * _e197));
                        let _e221 = elements.member[_e219];
                        let _e224 = elements.member[(_e219 + 1u)];
                        let _e227 = elements.member[(_e219 + 2u)];
                        phi_463_ = type_22(0u, array<u32, 4>(_e190, _e221, _e224, _e227));
                    } else {
                        let _e200 = (2u * _e190);
                        let _e202 = elements.member[_e200];
                        let _e205 = elements.member[(_e200 + 1u)];
                        let _e206 = (2u * _e197);
                        let _e208 = elements.member[_e206];
                        let _e211 = elements.member[(_e206 + 1u)];
                        phi_463_ = type_22(1u, array<u32, 4>(_e202, _e205, _e208, _e211));
                    }
                    let _e231 = phi_463_;
                    let _e236 = paths.member[_e231.member_1[0]];
                    let _e251 = paths.member[_e231.member_1[1]];
                    let _e266 = paths.member[_e231.member_1[2]];
                    let _e281 = paths.member[_e231.member_1[3]];
                    let _e295 = params.member.member.member_4;
                    if (_e231.member != 0u) {
                        phi_598_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e266.member.x - _e236.member.x), (_e266.member.y - _e236.member.y), (_e266.member.z - _e236.member.z)), array<f32, 3>((_e266.member_1.x - _e236.member_1.x), (_e266.member_1.y - _e236.member_1.y), (_e266.member_1.z - _e236.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e251.member.x - _e236.member.x), (_e251.member.y - _e236.member.y), (_e251.member.z - _e236.member.z)), array<f32, 3>((_e251.member_1.x - _e236.member_1.x), (_e251.member_1.y - _e236.member_1.y), (_e251.member_1.z - _e236.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e266.member.x - _e281.member.x), (_e266.member.y - _e281.member.y), (_e266.member.z - _e281.member.z)), array<f32, 3>((_e266.member_1.x - _e281.member_1.x), (_e266.member_1.y - _e281.member_1.y), (_e266.member_1.z - _e281.member_1.z))), (_e295 + _e295));
                    } else {
                        phi_598_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e236.member.x - _e251.member.x), (_e236.member.y - _e251.member.y), (_e236.member.z - _e251.member.z)), array<f32, 3>((_e236.member_1.x - _e251.member_1.x), (_e236.member_1.y - _e251.member_1.y), (_e236.member_1.z - _e251.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e266.member.x - _e251.member.x), (_e266.member.y - _e251.member.y), (_e266.member.z - _e251.member.z)), array<f32, 3>((_e266.member_1.x - _e251.member_1.x), (_e266.member_1.y - _e251.member_1.y), (_e266.member_1.z - _e251.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e281.member.x - _e251.member.x), (_e281.member.y - _e251.member.y), (_e281.member.z - _e251.member.z)), array<f32, 3>((_e281.member_1.x - _e251.member_1.x), (_e281.member_1.y - _e251.member_1.y), (_e281.member_1.z - _e251.member_1.z))), (_e295 + _e295));
                    }
                    let _e356 = phi_598_;
                    let _e358 = params.member.member.member_12;
                    let _e359 = bitcast<u32>(_e358);
                    let _e360 = (_e359 & 2147483647u);
                    let _e361 = (_e360 < 8388608u);
                    let _e373 = params.member.member.member_15[0u];
                    if (select((_e359 << bitcast<u32>(29i)), 0u, _e361) == _e373) {
                        let _e377 = params.member.member.member_15[1u];
                        phi_627_ = (select(((_e359 ^ _e360) | ((_e360 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e361) == _e377);
                    } else {
                        phi_627_ = false;
                    }
                    let _e380 = phi_627_;
                    let _e382 = params.member.member.member_5;
                    let _e384 = params.member.member.member_11;
                    let _e386 = params.member.member.member_12;
                    let _e388 = params.member.member.member_13;
                    let _e390 = params.member.member.member_1;
                    let _e399 = select(_e356.member[0][0], -(_e356.member[0][0]), (_e356.member[0][0] < 0f));
                    let _e403 = select(_e356.member[0][1], -(_e356.member[0][1]), (_e356.member[0][1] < 0f));
                    let _e405 = select(_e403, _e399, (_e399 > _e403));
                    let _e409 = select(_e356.member[0][2], -(_e356.member[0][2]), (_e356.member[0][2] < 0f));
                    let _e411 = select(_e409, _e405, (_e405 > _e409));
                    let _e417 = select(_e356.member[1][0], -(_e356.member[1][0]), (_e356.member[1][0] < 0f));
                    let _e421 = select(_e356.member[1][1], -(_e356.member[1][1]), (_e356.member[1][1] < 0f));
                    let _e423 = select(_e421, _e417, (_e417 > _e421));
                    let _e427 = select(_e356.member[1][2], -(_e356.member[1][2]), (_e356.member[1][2] < 0f));
                    let _e429 = select(_e427, _e423, (_e423 > _e427));
                    let _e433 = (select(_e429, _e411, (_e411 > _e429)) + _e356.member_3);
                    let _e439 = select(_e356.member_1[0][0], -(_e356.member_1[0][0]), (_e356.member_1[0][0] < 0f));
                    let _e443 = select(_e356.member_1[0][1], -(_e356.member_1[0][1]), (_e356.member_1[0][1] < 0f));
                    let _e445 = select(_e443, _e439, (_e439 > _e443));
                    let _e449 = select(_e356.member_1[0][2], -(_e356.member_1[0][2]), (_e356.member_1[0][2] < 0f));
                    let _e451 = select(_e449, _e445, (_e445 > _e449));
                    let _e457 = select(_e356.member_1[1][0], -(_e356.member_1[1][0]), (_e356.member_1[1][0] < 0f));
                    let _e461 = select(_e356.member_1[1][1], -(_e356.member_1[1][1]), (_e356.member_1[1][1] < 0f));
                    let _e463 = select(_e461, _e457, (_e457 > _e461));
                    let _e467 = select(_e356.member_1[1][2], -(_e356.member_1[1][2]), (_e356.member_1[1][2] < 0f));
                    let _e469 = select(_e467, _e463, (_e463 > _e467));
                    let _e473 = (select(_e469, _e451, (_e451 > _e469)) + _e356.member_3);
                    let _e479 = select(_e356.member_2[0][0], -(_e356.member_2[0][0]), (_e356.member_2[0][0] < 0f));
                    let _e483 = select(_e356.member_2[0][1], -(_e356.member_2[0][1]), (_e356.member_2[0][1] < 0f));
                    let _e485 = select(_e483, _e479, (_e479 > _e483));
                    let _e489 = select(_e356.member_2[0][2], -(_e356.member_2[0][2]), (_e356.member_2[0][2] < 0f));
                    let _e491 = select(_e489, _e485, (_e485 > _e489));
                    let _e497 = select(_e356.member_2[1][0], -(_e356.member_2[1][0]), (_e356.member_2[1][0] < 0f));
                    let _e501 = select(_e356.member_2[1][1], -(_e356.member_2[1][1]), (_e356.member_2[1][1] < 0f));
                    let _e503 = select(_e501, _e497, (_e497 > _e501));
                    let _e507 = select(_e356.member_2[1][2], -(_e356.member_2[1][2]), (_e356.member_2[1][2] < 0f));
                    let _e509 = select(_e507, _e503, (_e503 > _e507));
                    let _e513 = (select(_e509, _e491, (_e491 > _e509)) + _e356.member_3);
                    let _e515 = select(_e473, _e433, (_e433 > _e473));
                    let _e517 = select(_e513, _e515, (_e515 > _e513));
                    if (_e517 <= 65536f) {
                        phi_875_ = (_e517 >= (1f / 65536f));
                    } else {
                        phi_875_ = false;
                    }
                    let _e522 = phi_875_;
                    if _e522 {
                        phi_973_ = type_33();
                        phi_974_ = true;
                    } else {
                        if (_e517 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e517) & 2139095040u) != 2139095040u) {
                                let _e529 = (2130706432u - (bitcast<u32>(_e517) & 2139095040u));
                                let _e532 = bitcast<f32>(select(8388608u, _e529, (_e529 > 8388608u)));
                                let _e533 = (_e382 * _e532);
                                phi_969_ = type_33(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e356.member[0][0] * _e532), (_e356.member[0][1] * _e532), (_e356.member[0][2] * _e532)), array<f32, 3>((_e356.member[1][0] * _e532), (_e356.member[1][1] * _e532), (_e356.member[1][2] * _e532))), array<array<f32, 3>, 2>(array<f32, 3>((_e356.member_1[0][0] * _e532), (_e356.member_1[0][1] * _e532), (_e356.member_1[0][2] * _e532)), array<f32, 3>((_e356.member_1[1][0] * _e532), (_e356.member_1[1][1] * _e532), (_e356.member_1[1][2] * _e532))), array<array<f32, 3>, 2>(array<f32, 3>((_e356.member_2[0][0] * _e532), (_e356.member_2[0][1] * _e532), (_e356.member_2[0][2] * _e532)), array<f32, 3>((_e356.member_2[1][0] * _e532), (_e356.member_2[1][1] * _e532), (_e356.member_2[1][2] * _e532))), ((_e356.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e532)), select(_e533, select(0.000000000000000000000000000000000000011754944f, _e533, (_e533 > 0.000000000000000000000000000000000000011754944f)), (_e382 > 0f)));
                                phi_970_ = false;
                            } else {
                                phi_969_ = type_33();
                                phi_970_ = true;
                            }
                            let _e602 = phi_969_;
                            let _e604 = phi_970_;
                            phi_971_ = _e602;
                            phi_972_ = _e604;
                        } else {
                            phi_971_ = type_33();
                            phi_972_ = true;
                        }
                        let _e606 = phi_971_;
                        let _e608 = phi_972_;
                        phi_973_ = _e606;
                        phi_974_ = _e608;
                    }
                    let _e610 = phi_973_;
                    let _e612 = phi_974_;
                    if _e612 {
                        phi_979_ = type_33(_e356, _e382);
                    } else {
                        phi_979_ = _e610;
                    }
                    let _e615 = phi_979_;
                    local_5 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e615.member.member[0][0], _e615.member.member[0][1], _e615.member.member[0][2]), array<f32, 3>(_e615.member.member[1][0], _e615.member.member[1][1], _e615.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e615.member.member_1[0][0], _e615.member.member_1[0][1], _e615.member.member_1[0][2]), array<f32, 3>(_e615.member.member_1[1][0], _e615.member.member_1[1][1], _e615.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e615.member.member_2[0][0], _e615.member.member_2[0][1], _e615.member.member_2[0][2]), array<f32, 3>(_e615.member.member_2[1][0], _e615.member.member_2[1][1], _e615.member.member_2[1][2])), _e615.member.member_3);
                    let _e658 = local_5.member[0u];
                    let _e664 = local_5.member[1u];
                    let _e680 = local_5.member_1[0u];
                    let _e686 = local_5.member_1[1u];
                    let _e702 = local_5.member_2[0u];
                    let _e708 = local_5.member_2[1u];
                    let _e722 = function_3(array<f32, 3>((_e658[0] + ((_e664[0] - _e658[0]) * _e386)), (_e658[1] + ((_e664[1] - _e658[1]) * _e386)), (_e658[2] + ((_e664[2] - _e658[2]) * _e386))), array<f32, 3>((_e680[0] + ((_e686[0] - _e680[0]) * _e386)), (_e680[1] + ((_e686[1] - _e680[1]) * _e386)), (_e680[2] + ((_e686[2] - _e680[2]) * _e386))), array<f32, 3>((_e702[0] + ((_e708[0] - _e702[0]) * _e386)), (_e702[1] + ((_e708[1] - _e702[1]) * _e386)), (_e702[2] + ((_e708[2] - _e702[2]) * _e386))), _e231.member);
                    let _e733 = (((_e722[0] * _e722[0]) + (_e722[1] * _e722[1])) + (_e722[2] * _e722[2]));
                    if (_e733 <= 0.000000000000000000000000000000000000011754944f) {
                        phi_1206_ = select(0f, (0.000000000000000000106433627f * 2f), (_e733 > 0f));
                    } else {
                        phi_1149_ = type_14(0i, 5i);
                        phi_1152_ = bitcast<f32>(((bitcast<u32>(_e733) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e741 = phi_1149_;
                            let _e743 = phi_1152_;
                            local_6 = _e743;
                            if (_e741.member < _e741.member_1) {
                                let _e750 = (_e741.member + 1i);
                                phi_1150_ = type_14(select(_e750, type_15().member_1, select(false, true, ((false == (_e750 > _e741.member)) != false))), _e741.member_1);
                                phi_1193_ = type_15(1u, _e741.member);
                            } else {
                                phi_1150_ = _e741;
                                phi_1193_ = type_15(0u, type_15().member_1);
                            }
                            let _e761 = phi_1150_;
                            let _e763 = phi_1193_;
                            let _e766 = (bitcast<i32>(_e763.member) != 0i);
                            if _e766 {
                                phi_1153_ = (0.5f * (_e743 + (_e733 / _e743)));
                            } else {
                                phi_1153_ = f32();
                            }
                            let _e771 = phi_1153_;
                            continue;
                            continuing {
                                phi_1149_ = _e761;
                                phi_1152_ = _e771;
                                break if !(_e766);
                            }
                        }
                        let _e776 = local_6;
                        phi_1206_ = (_e776 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e782 = phi_1206_;
                    let _e788 = local_5.member[0u];
                    let _e794 = select(_e788[0], -(_e788[0]), (_e788[0] < 0f));
                    let _e797 = select(_e788[1], -(_e788[1]), (_e788[1] < 0f));
                    let _e799 = select(_e797, _e794, (_e794 > _e797));
                    let _e802 = select(_e788[2], -(_e788[2]), (_e788[2] < 0f));
                    let _e804 = select(_e802, _e799, (_e799 > _e802));
                    let _e807 = local_5.member[1u];
                    let _e813 = select(_e807[0], -(_e807[0]), (_e807[0] < 0f));
                    let _e816 = select(_e807[1], -(_e807[1]), (_e807[1] < 0f));
                    let _e818 = select(_e816, _e813, (_e813 > _e816));
                    let _e821 = select(_e807[2], -(_e807[2]), (_e807[2] < 0f));
                    let _e823 = select(_e821, _e818, (_e818 > _e821));
                    let _e827 = local_5.member_3;
                    let _e831 = local_5.member_1[0u];
                    let _e837 = select(_e831[0], -(_e831[0]), (_e831[0] < 0f));
                    let _e840 = select(_e831[1], -(_e831[1]), (_e831[1] < 0f));
                    let _e842 = select(_e840, _e837, (_e837 > _e840));
                    let _e845 = select(_e831[2], -(_e831[2]), (_e831[2] < 0f));
                    let _e847 = select(_e845, _e842, (_e842 > _e845));
                    let _e850 = local_5.member_1[1u];
                    let _e856 = select(_e850[0], -(_e850[0]), (_e850[0] < 0f));
                    let _e859 = select(_e850[1], -(_e850[1]), (_e850[1] < 0f));
                    let _e861 = select(_e859, _e856, (_e856 > _e859));
                    let _e864 = select(_e850[2], -(_e850[2]), (_e850[2] < 0f));
                    let _e866 = select(_e864, _e861, (_e861 > _e864));
                    let _e870 = local_5.member_3;
                    let _e874 = local_5.member_2[0u];
                    let _e880 = select(_e874[0], -(_e874[0]), (_e874[0] < 0f));
                    let _e883 = select(_e874[1], -(_e874[1]), (_e874[1] < 0f));
                    let _e885 = select(_e883, _e880, (_e880 > _e883));
                    let _e888 = select(_e874[2], -(_e874[2]), (_e874[2] < 0f));
                    let _e890 = select(_e888, _e885, (_e885 > _e888));
                    let _e893 = local_5.member_2[1u];
                    let _e899 = select(_e893[0], -(_e893[0]), (_e893[0] < 0f));
                    let _e902 = select(_e893[1], -(_e893[1]), (_e893[1] < 0f));
                    let _e904 = select(_e902, _e899, (_e899 > _e902));
                    let _e907 = select(_e893[2], -(_e893[2]), (_e893[2] < 0f));
                    let _e909 = select(_e907, _e904, (_e904 > _e907));
                    let _e913 = local_5.member_3;
                    let _e920 = local_5.member_3;
                    let _e927 = (((_e782 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e823, _e804, (_e804 > _e823)) + _e827) + (select(_e866, _e847, (_e847 > _e866)) + _e870)) + (select(_e909, _e890, (_e890 > _e909)) + _e913)) * (0.000000059604645f * 16f)) + (_e920 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e615.member_1);
                    if _e927 {
                        phi_2117_ = type_35();
                        phi_2118_ = true;
                    } else {
                        let _e930 = local_5.member_1[0u];
                        let _e936 = local_5.member_2[0u];
                        let _e942 = ((_e930[1] * _e936[2]) - (_e930[2] * _e936[1]));
                        let _e945 = ((_e930[2] * _e936[0]) - (_e930[0] * _e936[2]));
                        let _e948 = ((_e930[0] * _e936[1]) - (_e930[1] * _e936[0]));
                        let _e951 = local_5.member_1[1u];
                        let _e957 = local_5.member_2[1u];
                        let _e963 = ((_e951[1] * _e957[2]) - (_e951[2] * _e957[1]));
                        let _e966 = ((_e951[2] * _e957[0]) - (_e951[0] * _e957[2]));
                        let _e969 = ((_e951[0] * _e957[1]) - (_e951[1] * _e957[0]));
                        let _e972 = local_5.member_1[0u];
                        let _e978 = local_5.member_2[1u];
                        let _e993 = local_5.member_1[1u];
                        let _e999 = local_5.member_2[0u];
                        let _e1012 = (((_e972[1] * _e978[2]) - (_e972[2] * _e978[1])) + ((_e993[1] * _e999[2]) - (_e993[2] * _e999[1])));
                        let _e1013 = (((_e972[2] * _e978[0]) - (_e972[0] * _e978[2])) + ((_e993[2] * _e999[0]) - (_e993[0] * _e999[2])));
                        let _e1014 = (((_e972[0] * _e978[1]) - (_e972[1] * _e978[0])) + ((_e993[0] * _e999[1]) - (_e993[1] * _e999[0])));
                        let _e1017 = local_5.member[0u];
                        let _e1028 = local_5.member[1u];
                        let _e1039 = local_5.member[0u];
                        let _e1048 = ((((_e1028[0] * _e942) + (_e1028[1] * _e945)) + (_e1028[2] * _e948)) + (((_e1039[0] * _e1012) + (_e1039[1] * _e1013)) + (_e1039[2] * _e1014)));
                        let _e1051 = local_5.member[0u];
                        let _e1062 = local_5.member[1u];
                        let _e1071 = ((((_e1051[0] * _e963) + (_e1051[1] * _e966)) + (_e1051[2] * _e969)) + (((_e1062[0] * _e1012) + (_e1062[1] * _e1013)) + (_e1062[2] * _e1014)));
                        let _e1074 = local_5.member[1u];
                        let _e1085 = local_5.member[0u];
                        let _e1091 = select(_e1085[0], -(_e1085[0]), (_e1085[0] < 0f));
                        let _e1094 = select(_e1085[1], -(_e1085[1]), (_e1085[1] < 0f));
                        let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                        let _e1099 = select(_e1085[2], -(_e1085[2]), (_e1085[2] < 0f));
                        let _e1101 = select(_e1099, _e1096, (_e1096 > _e1099));
                        let _e1104 = local_5.member[1u];
                        let _e1110 = select(_e1104[0], -(_e1104[0]), (_e1104[0] < 0f));
                        let _e1113 = select(_e1104[1], -(_e1104[1]), (_e1104[1] < 0f));
                        let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                        let _e1118 = select(_e1104[2], -(_e1104[2]), (_e1104[2] < 0f));
                        let _e1120 = select(_e1118, _e1115, (_e1115 > _e1118));
                        let _e1124 = local_5.member_3;
                        let _e1125 = (select(_e1120, _e1101, (_e1101 > _e1120)) + _e1124);
                        let _e1128 = local_5.member_1[0u];
                        let _e1134 = select(_e1128[0], -(_e1128[0]), (_e1128[0] < 0f));
                        let _e1137 = select(_e1128[1], -(_e1128[1]), (_e1128[1] < 0f));
                        let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                        let _e1142 = select(_e1128[2], -(_e1128[2]), (_e1128[2] < 0f));
                        let _e1144 = select(_e1142, _e1139, (_e1139 > _e1142));
                        let _e1147 = local_5.member_1[1u];
                        let _e1153 = select(_e1147[0], -(_e1147[0]), (_e1147[0] < 0f));
                        let _e1156 = select(_e1147[1], -(_e1147[1]), (_e1147[1] < 0f));
                        let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                        let _e1161 = select(_e1147[2], -(_e1147[2]), (_e1147[2] < 0f));
                        let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                        let _e1167 = local_5.member_3;
                        let _e1168 = (select(_e1163, _e1144, (_e1144 > _e1163)) + _e1167);
                        let _e1171 = local_5.member_2[0u];
                        let _e1177 = select(_e1171[0], -(_e1171[0]), (_e1171[0] < 0f));
                        let _e1180 = select(_e1171[1], -(_e1171[1]), (_e1171[1] < 0f));
                        let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                        let _e1185 = select(_e1171[2], -(_e1171[2]), (_e1171[2] < 0f));
                        let _e1187 = select(_e1185, _e1182, (_e1182 > _e1185));
                        let _e1190 = local_5.member_2[1u];
                        let _e1196 = select(_e1190[0], -(_e1190[0]), (_e1190[0] < 0f));
                        let _e1199 = select(_e1190[1], -(_e1190[1]), (_e1190[1] < 0f));
                        let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                        let _e1204 = select(_e1190[2], -(_e1190[2]), (_e1190[2] < 0f));
                        let _e1206 = select(_e1204, _e1201, (_e1201 > _e1204));
                        let _e1210 = local_5.member_3;
                        let _e1211 = (select(_e1206, _e1187, (_e1187 > _e1206)) + _e1210);
                        let _e1213 = ((_e1168 * 8f) * _e1211);
                        let _e1220 = local_5.member_3;
                        let _e1244 = ((select(_e942, -(_e942), (_e942 < 0f)) + select(_e945, -(_e945), (_e945 < 0f))) + select(_e948, -(_e948), (_e948 < 0f)));
                        let _e1255 = ((select(_e963, -(_e963), (_e963 < 0f)) + select(_e966, -(_e966), (_e966 < 0f))) + select(_e969, -(_e969), (_e969 < 0f)));
                        let _e1257 = select(_e1255, _e1244, (_e1244 > _e1255));
                        let _e1269 = (((select(_e1012, -(_e1012), (_e1012 < 0f)) + select(_e1013, -(_e1013), (_e1013 < 0f))) + select(_e1014, -(_e1014), (_e1014 < 0f))) * 0.5f);
                        let _e1276 = local_5.member_3;
                        let _e1289 = ((((_e1017[0] * _e942) + (_e1017[1] * _e945)) + (_e1017[2] * _e948)) * 3f);
                        let _e1290 = ((((_e1074[0] * _e963) + (_e1074[1] * _e966)) + (_e1074[2] * _e969)) * 3f);
                        let _e1292 = select(_e1290, _e1289, (_e1289 < _e1290));
                        let _e1294 = select(_e1071, _e1048, (_e1048 < _e1071));
                        let _e1296 = select(_e1294, _e1292, (_e1292 < _e1294));
                        let _e1298 = select(_e1290, _e1289, (_e1289 > _e1290));
                        let _e1300 = select(_e1071, _e1048, (_e1048 > _e1071));
                        let _e1303 = -(select(_e1300, _e1298, (_e1298 > _e1300)));
                        if ((select(_e1303, _e1296, (_e1296 > _e1303)) - ((((((_e1125 * 8f) * _e1213) * (0.000000059604645f * (524f / 64f))) + ((_e1220 * 19f) * ((_e1125 * (_e1168 + _e1211)) + (_e1168 * _e1211)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1125) * ((1f + _e1168) * (1f + _e1211))))) + ((_e615.member_1 * (((select(_e1269, _e1257, (_e1257 > _e1269)) + (_e1213 * (0.000000059604645f * 8f))) + ((_e1276 * 6f) * (_e1168 + _e1211))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1168) * (1f + _e1211))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2115_ = type_35(type_34(0u, f32()), 0u);
                            phi_2116_ = false;
                        } else {
                            phi_2115_ = type_35();
                            phi_2116_ = true;
                        }
                        let _e1315 = phi_2115_;
                        let _e1317 = phi_2116_;
                        phi_2117_ = _e1315;
                        phi_2118_ = _e1317;
                    }
                    let _e1319 = phi_2117_;
                    let _e1321 = phi_2118_;
                    if _e1321 {
                        phi_2124_ = type_14(0i, 2i);
                        phi_2127_ = _e386;
                        phi_2129_ = 0u;
                        phi_2131_ = _e386;
                        loop {
                            let _e1323 = phi_2124_;
                            let _e1325 = phi_2127_;
                            let _e1327 = phi_2129_;
                            let _e1329 = phi_2131_;
                            local_53 = _e1327;
                            local_56 = _e1325;
                            local_57 = _e1327;
                            if (_e1323.member < _e1323.member_1) {
                                let _e1336 = (_e1323.member + 1i);
                                phi_2125_ = type_14(select(_e1336, type_15().member_1, select(false, true, ((false == (_e1336 > _e1323.member)) != false))), _e1323.member_1);
                                phi_2172_ = type_15(1u, _e1323.member);
                            } else {
                                phi_2125_ = _e1323;
                                phi_2172_ = type_15(0u, type_15().member_1);
                            }
                            let _e1347 = phi_2125_;
                            let _e1349 = phi_2172_;
                            if (bitcast<i32>(_e1349.member) != 0i) {
                                if select(select(true, false, _e927), true, (_e1349.member_1 > 0i)) {
                                    let _e1359 = local_5.member[0u];
                                    let _e1365 = local_5.member_1[0u];
                                    let _e1371 = local_5.member_2[0u];
                                    let _e1375 = (_e1359[0] - _e1365[0]);
                                    let _e1376 = (_e1359[1] - _e1365[1]);
                                    let _e1377 = (_e1359[2] - _e1365[2]);
                                    let _e1378 = (_e231.member == 0u);
                                    let _e1390 = local_5.member[1u];
                                    let _e1396 = local_5.member_1[1u];
                                    let _e1402 = local_5.member_2[1u];
                                    let _e1406 = (_e1390[0] - _e1396[0]);
                                    let _e1407 = (_e1390[1] - _e1396[1]);
                                    let _e1408 = (_e1390[2] - _e1396[2]);
                                    let _e1409 = (_e231.member == 0u);
                                    let _e1421 = local_5.member[0u];
                                    let _e1427 = select(_e1421[0], -(_e1421[0]), (_e1421[0] < 0f));
                                    let _e1430 = select(_e1421[1], -(_e1421[1]), (_e1421[1] < 0f));
                                    let _e1432 = select(_e1430, _e1427, (_e1427 > _e1430));
                                    let _e1435 = select(_e1421[2], -(_e1421[2]), (_e1421[2] < 0f));
                                    let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                    let _e1440 = local_5.member[1u];
                                    let _e1446 = select(_e1440[0], -(_e1440[0]), (_e1440[0] < 0f));
                                    let _e1449 = select(_e1440[1], -(_e1440[1]), (_e1440[1] < 0f));
                                    let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                    let _e1454 = select(_e1440[2], -(_e1440[2]), (_e1440[2] < 0f));
                                    let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                    let _e1460 = local_5.member_3;
                                    let _e1464 = local_5.member_1[0u];
                                    let _e1470 = select(_e1464[0], -(_e1464[0]), (_e1464[0] < 0f));
                                    let _e1473 = select(_e1464[1], -(_e1464[1]), (_e1464[1] < 0f));
                                    let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                    let _e1478 = select(_e1464[2], -(_e1464[2]), (_e1464[2] < 0f));
                                    let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                    let _e1483 = local_5.member_1[1u];
                                    let _e1489 = select(_e1483[0], -(_e1483[0]), (_e1483[0] < 0f));
                                    let _e1492 = select(_e1483[1], -(_e1483[1]), (_e1483[1] < 0f));
                                    let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                    let _e1497 = select(_e1483[2], -(_e1483[2]), (_e1483[2] < 0f));
                                    let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                    let _e1503 = local_5.member_3;
                                    let _e1507 = local_5.member_2[0u];
                                    let _e1513 = select(_e1507[0], -(_e1507[0]), (_e1507[0] < 0f));
                                    let _e1516 = select(_e1507[1], -(_e1507[1]), (_e1507[1] < 0f));
                                    let _e1518 = select(_e1516, _e1513, (_e1513 > _e1516));
                                    let _e1521 = select(_e1507[2], -(_e1507[2]), (_e1507[2] < 0f));
                                    let _e1523 = select(_e1521, _e1518, (_e1518 > _e1521));
                                    let _e1526 = local_5.member_2[1u];
                                    let _e1532 = select(_e1526[0], -(_e1526[0]), (_e1526[0] < 0f));
                                    let _e1535 = select(_e1526[1], -(_e1526[1]), (_e1526[1] < 0f));
                                    let _e1537 = select(_e1535, _e1532, (_e1532 > _e1535));
                                    let _e1540 = select(_e1526[2], -(_e1526[2]), (_e1526[2] < 0f));
                                    let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                    let _e1546 = local_5.member_3;
                                    let _e1553 = local_5.member_3;
                                    let _e1558 = (_e384 * 0.00390625f);
                                    local_3 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2609_ = type_9(0u, 96u);
                                    phi_2612_ = _e1329;
                                    phi_2614_ = _e1329;
                                    phi_2616_ = (_e388 - _e1329);
                                    phi_2618_ = _e1329;
                                    phi_2620_ = false;
                                    phi_2622_ = 0u;
                                    loop {
                                        let _e1561 = phi_2609_;
                                        let _e1563 = phi_2612_;
                                        let _e1565 = phi_2614_;
                                        let _e1567 = phi_2616_;
                                        let _e1569 = phi_2618_;
                                        let _e1571 = phi_2620_;
                                        let _e1573 = phi_2622_;
                                        local_19 = _e1563;
                                        local_23 = _e1565;
                                        let _e1576 = (_e1561.member < _e1561.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e1576)) != 0i) {
                                            let _e1590 = local_5.member[0u];
                                            let _e1596 = local_5.member[1u];
                                            let _e1612 = local_5.member_1[0u];
                                            let _e1618 = local_5.member_1[1u];
                                            let _e1634 = local_5.member_2[0u];
                                            let _e1640 = local_5.member_2[1u];
                                            let _e1654 = function_3(array<f32, 3>((_e1590[0] + ((_e1596[0] - _e1590[0]) * _e1563)), (_e1590[1] + ((_e1596[1] - _e1590[1]) * _e1563)), (_e1590[2] + ((_e1596[2] - _e1590[2]) * _e1563))), array<f32, 3>((_e1612[0] + ((_e1618[0] - _e1612[0]) * _e1563)), (_e1612[1] + ((_e1618[1] - _e1612[1]) * _e1563)), (_e1612[2] + ((_e1618[2] - _e1612[2]) * _e1563))), array<f32, 3>((_e1634[0] + ((_e1640[0] - _e1634[0]) * _e1563)), (_e1634[1] + ((_e1640[1] - _e1634[1]) * _e1563)), (_e1634[2] + ((_e1640[2] - _e1634[2]) * _e1563))), _e231.member);
                                            if (_e1573 == 0u) {
                                                phi_2773_ = _e1654;
                                            } else {
                                                phi_2773_ = array<f32, 3>(select(0f, _e1654[0], (_e1573 == 1u)), select(0f, _e1654[1], (_e1573 == 2u)), select(0f, _e1654[2], (_e1573 == 3u)));
                                            }
                                            let _e1667 = phi_2773_;
                                            let _e1681 = ((select(_e1667[0], -(_e1667[0]), (_e1667[0] < 0f)) + select(_e1667[1], -(_e1667[1]), (_e1667[1] < 0f))) + select(_e1667[2], -(_e1667[2]), (_e1667[2] < 0f)));
                                            if (_e1681 > 0f) {
                                                if ((bitcast<u32>(_e1681) & 2139095040u) != 2139095040u) {
                                                    let _e1686 = (1f / _e1681);
                                                    let _e1688 = (_e1667[0] * _e1686);
                                                    let _e1690 = (_e1667[1] * _e1686);
                                                    let _e1692 = (_e1667[2] * _e1686);
                                                    let _e1697 = (((_e1688 * _e1688) + (_e1690 * _e1690)) + (_e1692 * _e1692));
                                                    if (_e1697 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2896_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1697 > 0f));
                                                    } else {
                                                        phi_2839_ = type_14(0i, 5i);
                                                        phi_2842_ = bitcast<f32>(((bitcast<u32>(_e1697) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1705 = phi_2839_;
                                                            let _e1707 = phi_2842_;
                                                            local_7 = _e1707;
                                                            if (_e1705.member < _e1705.member_1) {
                                                                let _e1714 = (_e1705.member + 1i);
                                                                phi_2840_ = type_14(select(_e1714, type_15().member_1, select(false, true, ((false == (_e1714 > _e1705.member)) != false))), _e1705.member_1);
                                                                phi_2883_ = type_15(1u, _e1705.member);
                                                            } else {
                                                                phi_2840_ = _e1705;
                                                                phi_2883_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e1725 = phi_2840_;
                                                            let _e1727 = phi_2883_;
                                                            let _e1730 = (bitcast<i32>(_e1727.member) != 0i);
                                                            if _e1730 {
                                                                phi_2843_ = (0.5f * (_e1707 + (_e1697 / _e1707)));
                                                            } else {
                                                                phi_2843_ = f32();
                                                            }
                                                            let _e1735 = phi_2843_;
                                                            continue;
                                                            continuing {
                                                                phi_2839_ = _e1725;
                                                                phi_2842_ = _e1735;
                                                                break if !(_e1730);
                                                            }
                                                        }
                                                        let _e1740 = local_7;
                                                        phi_2896_ = (_e1740 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1746 = phi_2896_;
                                                    let _e1747 = (0.000000059604645f * 12f);
                                                    let _e1752 = ((((((((select(_e1456, _e1437, (_e1437 > _e1456)) + _e1460) + (select(_e1499, _e1480, (_e1480 > _e1499)) + _e1503)) + (select(_e1542, _e1523, (_e1523 > _e1542)) + _e1546)) * (0.000000059604645f * 16f)) + (_e1553 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e615.member_1 * _e1746) * (1f + _e1747)));
                                                    let _e1757 = (((_e1688 * _e1359[0]) + (_e1690 * _e1359[1])) + (_e1692 * _e1359[2]));
                                                    let _e1762 = (((_e1688 * _e1375) + (_e1690 * _e1376)) + (_e1692 * _e1377));
                                                    let _e1767 = (((_e1688 * (_e1359[0] - _e1371[0])) + (_e1690 * (_e1359[1] - _e1371[1]))) + (_e1692 * (_e1359[2] - _e1371[2])));
                                                    let _e1772 = (((_e1688 * select((_e1375 - _e1371[0]), _e1359[0], _e1378)) + (_e1690 * select((_e1376 - _e1371[1]), _e1359[1], _e1378))) + (_e1692 * select((_e1377 - _e1371[2]), _e1359[2], _e1378)));
                                                    let _e1778 = (((_e1688 * _e1390[0]) + (_e1690 * _e1390[1])) + (_e1692 * _e1390[2]));
                                                    let _e1783 = (((_e1688 * _e1406) + (_e1690 * _e1407)) + (_e1692 * _e1408));
                                                    let _e1788 = (((_e1688 * (_e1390[0] - _e1402[0])) + (_e1690 * (_e1390[1] - _e1402[1]))) + (_e1692 * (_e1390[2] - _e1402[2])));
                                                    let _e1793 = (((_e1688 * select((_e1406 - _e1402[0]), _e1390[0], _e1409)) + (_e1690 * select((_e1407 - _e1402[1]), _e1390[1], _e1409))) + (_e1692 * select((_e1408 - _e1402[2]), _e1390[2], _e1409)));
                                                    phi_3019_ = type_31(array<f32, 4>(_e1757, _e1762, _e1767, _e1772), array<f32, 4>(_e1778, _e1783, _e1788, _e1793), array<f32, 4>((_e1752 + ((select(_e1757, -(_e1757), (_e1757 < 0f)) + select(_e1778, -(_e1778), (_e1778 < 0f))) * _e1747)), (_e1752 + ((select(_e1762, -(_e1762), (_e1762 < 0f)) + select(_e1783, -(_e1783), (_e1783 < 0f))) * _e1747)), (_e1752 + ((select(_e1767, -(_e1767), (_e1767 < 0f)) + select(_e1788, -(_e1788), (_e1788 < 0f))) * _e1747)), (_e1752 + ((select(_e1772, -(_e1772), (_e1772 < 0f)) + select(_e1793, -(_e1793), (_e1793 < 0f))) * _e1747))));
                                                    phi_3020_ = false;
                                                } else {
                                                    phi_3019_ = type_31();
                                                    phi_3020_ = true;
                                                }
                                                let _e1834 = phi_3019_;
                                                let _e1836 = phi_3020_;
                                                phi_3021_ = _e1834;
                                                phi_3022_ = _e1836;
                                            } else {
                                                phi_3021_ = type_31();
                                                phi_3022_ = true;
                                            }
                                            let _e1838 = phi_3021_;
                                            let _e1840 = phi_3022_;
                                            if _e1840 {
                                                phi_3030_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3030_ = _e1838;
                                            }
                                            let _e1842 = phi_3030_;
                                            local_4 = type_31(array<f32, 4>(_e1842.member[0], _e1842.member[1], _e1842.member[2], _e1842.member[3]), array<f32, 4>(_e1842.member_1[0], _e1842.member_1[1], _e1842.member_1[2], _e1842.member_1[3]), array<f32, 4>(_e1842.member_2[0], _e1842.member_2[1], _e1842.member_2[2], _e1842.member_2[3]));
                                            let _e1862 = (_e1563 - _e1569);
                                            let _e1866 = local_4.member[0u];
                                            let _e1869 = local_4.member_1[0u];
                                            let _e1872 = local_4.member[0u];
                                            let _e1878 = local_4.member_2[0u];
                                            if (((_e1866 + ((_e1869 - _e1872) * _e1563)) - _e1878) > 0f) {
                                                let _e1883 = local_4.member[1u];
                                                let _e1886 = local_4.member_1[1u];
                                                let _e1889 = local_4.member[1u];
                                                let _e1895 = local_4.member_2[1u];
                                                if (((_e1883 + ((_e1886 - _e1889) * _e1563)) - _e1895) > 0f) {
                                                    let _e1900 = local_4.member[2u];
                                                    let _e1903 = local_4.member_1[2u];
                                                    let _e1906 = local_4.member[2u];
                                                    let _e1912 = local_4.member_2[2u];
                                                    if (((_e1900 + ((_e1903 - _e1906) * _e1563)) - _e1912) > 0f) {
                                                        let _e1917 = local_4.member[3u];
                                                        let _e1920 = local_4.member_1[3u];
                                                        let _e1923 = local_4.member[3u];
                                                        let _e1929 = local_4.member_2[3u];
                                                        phi_3201_ = (((_e1917 + ((_e1920 - _e1923) * _e1563)) - _e1929) > 0f);
                                                        phi_3202_ = false;
                                                    } else {
                                                        phi_3201_ = bool();
                                                        phi_3202_ = true;
                                                    }
                                                    let _e1933 = phi_3201_;
                                                    let _e1935 = phi_3202_;
                                                    phi_3203_ = _e1933;
                                                    phi_3204_ = _e1935;
                                                } else {
                                                    phi_3203_ = bool();
                                                    phi_3204_ = true;
                                                }
                                                let _e1937 = phi_3203_;
                                                let _e1939 = phi_3204_;
                                                phi_3205_ = _e1937;
                                                phi_3206_ = _e1939;
                                            } else {
                                                phi_3205_ = bool();
                                                phi_3206_ = true;
                                            }
                                            let _e1941 = phi_3205_;
                                            let _e1943 = phi_3206_;
                                            if select(_e1941, false, _e1943) {
                                                if (_e1563 <= _e1565) {
                                                    phi_3520_ = true;
                                                } else {
                                                    let _e1948 = local_3.member[0u];
                                                    let _e1951 = local_3.member_1[0u];
                                                    let _e1954 = local_3.member[0u];
                                                    let _e1960 = local_3.member_2[0u];
                                                    let _e1964 = local_4.member[0u];
                                                    let _e1967 = local_4.member_1[0u];
                                                    let _e1970 = local_4.member[0u];
                                                    let _e1976 = local_4.member_2[0u];
                                                    if ((((_e1948 + ((_e1951 - _e1954) * _e1563)) - _e1960) + ((_e1964 + ((_e1967 - _e1970) * _e1569)) - _e1976)) > 0f) {
                                                        let _e1982 = local_3.member[1u];
                                                        let _e1985 = local_3.member_1[1u];
                                                        let _e1988 = local_3.member[1u];
                                                        let _e1994 = local_3.member_2[1u];
                                                        let _e1998 = local_4.member[1u];
                                                        let _e2001 = local_4.member_1[1u];
                                                        let _e2004 = local_4.member[1u];
                                                        let _e2010 = local_4.member_2[1u];
                                                        if ((((_e1982 + ((_e1985 - _e1988) * _e1563)) - _e1994) + ((_e1998 + ((_e2001 - _e2004) * _e1569)) - _e2010)) > 0f) {
                                                            let _e2016 = local_3.member[2u];
                                                            let _e2019 = local_3.member_1[2u];
                                                            let _e2022 = local_3.member[2u];
                                                            let _e2028 = local_3.member_2[2u];
                                                            let _e2032 = local_4.member[2u];
                                                            let _e2035 = local_4.member_1[2u];
                                                            let _e2038 = local_4.member[2u];
                                                            let _e2044 = local_4.member_2[2u];
                                                            if ((((_e2016 + ((_e2019 - _e2022) * _e1563)) - _e2028) + ((_e2032 + ((_e2035 - _e2038) * _e1569)) - _e2044)) > 0f) {
                                                                let _e2050 = local_3.member[3u];
                                                                let _e2053 = local_3.member_1[3u];
                                                                let _e2056 = local_3.member[3u];
                                                                let _e2062 = local_3.member_2[3u];
                                                                let _e2066 = local_4.member[3u];
                                                                let _e2069 = local_4.member_1[3u];
                                                                let _e2072 = local_4.member[3u];
                                                                let _e2078 = local_4.member_2[3u];
                                                                phi_3507_ = ((((_e2050 + ((_e2053 - _e2056) * _e1563)) - _e2062) + ((_e2066 + ((_e2069 - _e2072) * _e1569)) - _e2078)) > 0f);
                                                                phi_3508_ = false;
                                                            } else {
                                                                phi_3507_ = bool();
                                                                phi_3508_ = true;
                                                            }
                                                            let _e2083 = phi_3507_;
                                                            let _e2085 = phi_3508_;
                                                            phi_3509_ = _e2083;
                                                            phi_3510_ = _e2085;
                                                        } else {
                                                            phi_3509_ = bool();
                                                            phi_3510_ = true;
                                                        }
                                                        let _e2087 = phi_3509_;
                                                        let _e2089 = phi_3510_;
                                                        phi_3511_ = _e2087;
                                                        phi_3512_ = _e2089;
                                                    } else {
                                                        phi_3511_ = bool();
                                                        phi_3512_ = true;
                                                    }
                                                    let _e2091 = phi_3511_;
                                                    let _e2093 = phi_3512_;
                                                    phi_3520_ = select(_e2091, false, _e2093);
                                                }
                                                let _e2096 = phi_3520_;
                                                if _e2096 {
                                                    if select(true, select(true, false, (_e1563 >= _e388)), _e1571) {
                                                        local_3 = type_31(array<f32, 4>(_e1842.member[0], _e1842.member[1], _e1842.member[2], _e1842.member[3]), array<f32, 4>(_e1842.member_1[0], _e1842.member_1[1], _e1842.member_1[2], _e1842.member_1[3]), array<f32, 4>(_e1842.member_2[0], _e1842.member_2[1], _e1842.member_2[2], _e1842.member_2[3]));
                                                        let _e2121 = local_3.member[0u];
                                                        let _e2124 = local_3.member_1[0u];
                                                        let _e2127 = local_3.member_2[0u];
                                                        if select(true, select(true, false, (_e2124 > _e2127)), (_e2121 > _e2127)) {
                                                            let _e2132 = (_e2124 >= _e2121);
                                                            if _e2132 {
                                                                phi_3629_ = f32();
                                                                phi_3630_ = false;
                                                            } else {
                                                                if ((_e2121 - _e2124) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3627_ = (((_e2121 - _e2127) / (_e2121 - _e2124)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3628_ = false;
                                                                } else {
                                                                    phi_3627_ = f32();
                                                                    phi_3628_ = true;
                                                                }
                                                                let _e2143 = phi_3627_;
                                                                let _e2145 = phi_3628_;
                                                                phi_3629_ = _e2143;
                                                                phi_3630_ = _e2145;
                                                            }
                                                            let _e2147 = phi_3629_;
                                                            let _e2149 = phi_3630_;
                                                            phi_3631_ = _e2147;
                                                            phi_3632_ = _e2132;
                                                            phi_3633_ = _e2149;
                                                        } else {
                                                            phi_3631_ = f32();
                                                            phi_3632_ = true;
                                                            phi_3633_ = false;
                                                        }
                                                        let _e2151 = phi_3631_;
                                                        let _e2153 = phi_3632_;
                                                        let _e2155 = phi_3633_;
                                                        let _e2158 = select(_e2151, select(_e1563, 2f, _e2153), select(_e2155, true, _e2153));
                                                        let _e2161 = local_3.member[1u];
                                                        let _e2164 = local_3.member_1[1u];
                                                        let _e2167 = local_3.member_2[1u];
                                                        if select(true, select(true, false, (_e2164 > _e2167)), (_e2161 > _e2167)) {
                                                            let _e2172 = (_e2164 >= _e2161);
                                                            if _e2172 {
                                                                phi_3697_ = f32();
                                                                phi_3698_ = false;
                                                            } else {
                                                                if ((_e2161 - _e2164) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3695_ = (((_e2161 - _e2167) / (_e2161 - _e2164)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3696_ = false;
                                                                } else {
                                                                    phi_3695_ = f32();
                                                                    phi_3696_ = true;
                                                                }
                                                                let _e2183 = phi_3695_;
                                                                let _e2185 = phi_3696_;
                                                                phi_3697_ = _e2183;
                                                                phi_3698_ = _e2185;
                                                            }
                                                            let _e2187 = phi_3697_;
                                                            let _e2189 = phi_3698_;
                                                            phi_3699_ = _e2187;
                                                            phi_3700_ = _e2172;
                                                            phi_3701_ = _e2189;
                                                        } else {
                                                            phi_3699_ = f32();
                                                            phi_3700_ = true;
                                                            phi_3701_ = false;
                                                        }
                                                        let _e2191 = phi_3699_;
                                                        let _e2193 = phi_3700_;
                                                        let _e2195 = phi_3701_;
                                                        let _e2198 = select(_e2191, select(_e1563, 2f, _e2193), select(_e2195, true, _e2193));
                                                        let _e2200 = select(_e2198, _e2158, (_e2158 < _e2198));
                                                        let _e2203 = local_3.member[2u];
                                                        let _e2206 = local_3.member_1[2u];
                                                        let _e2209 = local_3.member_2[2u];
                                                        if select(true, select(true, false, (_e2206 > _e2209)), (_e2203 > _e2209)) {
                                                            let _e2214 = (_e2206 >= _e2203);
                                                            if _e2214 {
                                                                phi_3770_ = f32();
                                                                phi_3771_ = false;
                                                            } else {
                                                                if ((_e2203 - _e2206) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3768_ = (((_e2203 - _e2209) / (_e2203 - _e2206)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3769_ = false;
                                                                } else {
                                                                    phi_3768_ = f32();
                                                                    phi_3769_ = true;
                                                                }
                                                                let _e2225 = phi_3768_;
                                                                let _e2227 = phi_3769_;
                                                                phi_3770_ = _e2225;
                                                                phi_3771_ = _e2227;
                                                            }
                                                            let _e2229 = phi_3770_;
                                                            let _e2231 = phi_3771_;
                                                            phi_3772_ = _e2229;
                                                            phi_3773_ = _e2214;
                                                            phi_3774_ = _e2231;
                                                        } else {
                                                            phi_3772_ = f32();
                                                            phi_3773_ = true;
                                                            phi_3774_ = false;
                                                        }
                                                        let _e2233 = phi_3772_;
                                                        let _e2235 = phi_3773_;
                                                        let _e2237 = phi_3774_;
                                                        let _e2240 = select(_e2233, select(_e1563, 2f, _e2235), select(_e2237, true, _e2235));
                                                        let _e2243 = local_3.member[3u];
                                                        let _e2246 = local_3.member_1[3u];
                                                        let _e2249 = local_3.member_2[3u];
                                                        if select(true, select(true, false, (_e2246 > _e2249)), (_e2243 > _e2249)) {
                                                            let _e2254 = (_e2246 >= _e2243);
                                                            if _e2254 {
                                                                phi_3838_ = f32();
                                                                phi_3839_ = false;
                                                            } else {
                                                                if ((_e2243 - _e2246) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3836_ = (((_e2243 - _e2249) / (_e2243 - _e2246)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3837_ = false;
                                                                } else {
                                                                    phi_3836_ = f32();
                                                                    phi_3837_ = true;
                                                                }
                                                                let _e2265 = phi_3836_;
                                                                let _e2267 = phi_3837_;
                                                                phi_3838_ = _e2265;
                                                                phi_3839_ = _e2267;
                                                            }
                                                            let _e2269 = phi_3838_;
                                                            let _e2271 = phi_3839_;
                                                            phi_3840_ = _e2269;
                                                            phi_3841_ = _e2254;
                                                            phi_3842_ = _e2271;
                                                        } else {
                                                            phi_3840_ = f32();
                                                            phi_3841_ = true;
                                                            phi_3842_ = false;
                                                        }
                                                        let _e2273 = phi_3840_;
                                                        let _e2275 = phi_3841_;
                                                        let _e2277 = phi_3842_;
                                                        let _e2280 = select(_e2273, select(_e1563, 2f, _e2275), select(_e2277, true, _e2275));
                                                        let _e2282 = select(_e2280, _e2240, (_e2240 < _e2280));
                                                        let _e2284 = select(_e2282, _e2200, (_e2200 < _e2282));
                                                        let _e2286 = select(_e1563, _e2284, (_e2284 > _e1563));
                                                        let _e2287 = (_e2286 > _e388);
                                                        if _e2287 {
                                                            phi_4371_ = f32();
                                                            phi_4372_ = f32();
                                                            phi_4373_ = false;
                                                            phi_4374_ = false;
                                                        } else {
                                                            let _e2288 = (_e2286 - _e1563);
                                                            let _e2289 = (_e2288 <= _e1558);
                                                            let _e2291 = (_e2286 + (_e384 * 0.01f));
                                                            let _e2293 = select(_e388, _e2291, (_e2291 < _e388));
                                                            if _e2289 {
                                                                if (_e615.member_1 > 0f) {
                                                                    let _e2297 = local_5.member[0u];
                                                                    let _e2303 = local_5.member[1u];
                                                                    let _e2319 = local_5.member_1[0u];
                                                                    let _e2325 = local_5.member_1[1u];
                                                                    let _e2341 = local_5.member_2[0u];
                                                                    let _e2347 = local_5.member_2[1u];
                                                                    let _e2361 = function_3(array<f32, 3>((_e2297[0] + ((_e2303[0] - _e2297[0]) * _e2293)), (_e2297[1] + ((_e2303[1] - _e2297[1]) * _e2293)), (_e2297[2] + ((_e2303[2] - _e2297[2]) * _e2293))), array<f32, 3>((_e2319[0] + ((_e2325[0] - _e2319[0]) * _e2293)), (_e2319[1] + ((_e2325[1] - _e2319[1]) * _e2293)), (_e2319[2] + ((_e2325[2] - _e2319[2]) * _e2293))), array<f32, 3>((_e2341[0] + ((_e2347[0] - _e2341[0]) * _e2293)), (_e2341[1] + ((_e2347[1] - _e2341[1]) * _e2293)), (_e2341[2] + ((_e2347[2] - _e2341[2]) * _e2293))), _e231.member);
                                                                    let _e2372 = (((_e2361[0] * _e2361[0]) + (_e2361[1] * _e2361[1])) + (_e2361[2] * _e2361[2]));
                                                                    if (_e2372 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_4073_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2372 > 0f));
                                                                    } else {
                                                                        phi_4016_ = type_14(0i, 5i);
                                                                        phi_4019_ = bitcast<f32>(((bitcast<u32>(_e2372) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e2380 = phi_4016_;
                                                                            let _e2382 = phi_4019_;
                                                                            local_8 = _e2382;
                                                                            if (_e2380.member < _e2380.member_1) {
                                                                                let _e2389 = (_e2380.member + 1i);
                                                                                phi_4017_ = type_14(select(_e2389, type_15().member_1, select(false, true, ((false == (_e2389 > _e2380.member)) != false))), _e2380.member_1);
                                                                                phi_4060_ = type_15(1u, _e2380.member);
                                                                            } else {
                                                                                phi_4017_ = _e2380;
                                                                                phi_4060_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e2400 = phi_4017_;
                                                                            let _e2402 = phi_4060_;
                                                                            let _e2405 = (bitcast<i32>(_e2402.member) != 0i);
                                                                            if _e2405 {
                                                                                phi_4020_ = (0.5f * (_e2382 + (_e2372 / _e2382)));
                                                                            } else {
                                                                                phi_4020_ = f32();
                                                                            }
                                                                            let _e2410 = phi_4020_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4016_ = _e2400;
                                                                                phi_4019_ = _e2410;
                                                                                break if !(_e2405);
                                                                            }
                                                                        }
                                                                        let _e2415 = local_8;
                                                                        phi_4073_ = (_e2415 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e2421 = phi_4073_;
                                                                    let _e2427 = local_5.member[0u];
                                                                    let _e2433 = select(_e2427[0], -(_e2427[0]), (_e2427[0] < 0f));
                                                                    let _e2436 = select(_e2427[1], -(_e2427[1]), (_e2427[1] < 0f));
                                                                    let _e2438 = select(_e2436, _e2433, (_e2433 > _e2436));
                                                                    let _e2441 = select(_e2427[2], -(_e2427[2]), (_e2427[2] < 0f));
                                                                    let _e2443 = select(_e2441, _e2438, (_e2438 > _e2441));
                                                                    let _e2446 = local_5.member[1u];
                                                                    let _e2452 = select(_e2446[0], -(_e2446[0]), (_e2446[0] < 0f));
                                                                    let _e2455 = select(_e2446[1], -(_e2446[1]), (_e2446[1] < 0f));
                                                                    let _e2457 = select(_e2455, _e2452, (_e2452 > _e2455));
                                                                    let _e2460 = select(_e2446[2], -(_e2446[2]), (_e2446[2] < 0f));
                                                                    let _e2462 = select(_e2460, _e2457, (_e2457 > _e2460));
                                                                    let _e2466 = local_5.member_3;
                                                                    let _e2470 = local_5.member_1[0u];
                                                                    let _e2476 = select(_e2470[0], -(_e2470[0]), (_e2470[0] < 0f));
                                                                    let _e2479 = select(_e2470[1], -(_e2470[1]), (_e2470[1] < 0f));
                                                                    let _e2481 = select(_e2479, _e2476, (_e2476 > _e2479));
                                                                    let _e2484 = select(_e2470[2], -(_e2470[2]), (_e2470[2] < 0f));
                                                                    let _e2486 = select(_e2484, _e2481, (_e2481 > _e2484));
                                                                    let _e2489 = local_5.member_1[1u];
                                                                    let _e2495 = select(_e2489[0], -(_e2489[0]), (_e2489[0] < 0f));
                                                                    let _e2498 = select(_e2489[1], -(_e2489[1]), (_e2489[1] < 0f));
                                                                    let _e2500 = select(_e2498, _e2495, (_e2495 > _e2498));
                                                                    let _e2503 = select(_e2489[2], -(_e2489[2]), (_e2489[2] < 0f));
                                                                    let _e2505 = select(_e2503, _e2500, (_e2500 > _e2503));
                                                                    let _e2509 = local_5.member_3;
                                                                    let _e2513 = local_5.member_2[0u];
                                                                    let _e2519 = select(_e2513[0], -(_e2513[0]), (_e2513[0] < 0f));
                                                                    let _e2522 = select(_e2513[1], -(_e2513[1]), (_e2513[1] < 0f));
                                                                    let _e2524 = select(_e2522, _e2519, (_e2519 > _e2522));
                                                                    let _e2527 = select(_e2513[2], -(_e2513[2]), (_e2513[2] < 0f));
                                                                    let _e2529 = select(_e2527, _e2524, (_e2524 > _e2527));
                                                                    let _e2532 = local_5.member_2[1u];
                                                                    let _e2538 = select(_e2532[0], -(_e2532[0]), (_e2532[0] < 0f));
                                                                    let _e2541 = select(_e2532[1], -(_e2532[1]), (_e2532[1] < 0f));
                                                                    let _e2543 = select(_e2541, _e2538, (_e2538 > _e2541));
                                                                    let _e2546 = select(_e2532[2], -(_e2532[2]), (_e2532[2] < 0f));
                                                                    let _e2548 = select(_e2546, _e2543, (_e2543 > _e2546));
                                                                    let _e2552 = local_5.member_3;
                                                                    let _e2559 = local_5.member_3;
                                                                    phi_4344_ = select(true, false, (((_e2421 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2462, _e2443, (_e2443 > _e2462)) + _e2466) + (select(_e2505, _e2486, (_e2486 > _e2505)) + _e2509)) + (select(_e2548, _e2529, (_e2529 > _e2548)) + _e2552)) * (0.000000059604645f * 16f)) + (_e2559 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e615.member_1));
                                                                } else {
                                                                    phi_4344_ = true;
                                                                }
                                                                let _e2569 = phi_4344_;
                                                                phi_4345_ = _e2569;
                                                            } else {
                                                                phi_4345_ = true;
                                                            }
                                                            let _e2571 = phi_4345_;
                                                            phi_4371_ = select(f32(), select((_e388 - _e1563), select(0f, (_e1862 + _e1862), select(select(true, false, (_e2288 <= (_e1567 * 0.25f))), true, _e2289)), _e1571), _e2571);
                                                            phi_4372_ = _e2288;
                                                            phi_4373_ = _e2571;
                                                            phi_4374_ = select(true, false, _e2571);
                                                        }
                                                        let _e2583 = phi_4371_;
                                                        let _e2585 = phi_4372_;
                                                        let _e2587 = phi_4373_;
                                                        let _e2589 = phi_4374_;
                                                        phi_4375_ = _e2286;
                                                        phi_4376_ = _e2583;
                                                        phi_4377_ = _e2585;
                                                        phi_4378_ = _e2286;
                                                        phi_4379_ = _e2587;
                                                        phi_4380_ = _e2287;
                                                        phi_4381_ = _e2589;
                                                        phi_4382_ = false;
                                                    } else {
                                                        phi_4375_ = f32();
                                                        phi_4376_ = f32();
                                                        phi_4377_ = f32();
                                                        phi_4378_ = f32();
                                                        phi_4379_ = false;
                                                        phi_4380_ = false;
                                                        phi_4381_ = false;
                                                        phi_4382_ = true;
                                                    }
                                                    let _e2591 = phi_4375_;
                                                    let _e2593 = phi_4376_;
                                                    let _e2595 = phi_4377_;
                                                    let _e2597 = phi_4378_;
                                                    let _e2599 = phi_4379_;
                                                    let _e2601 = phi_4380_;
                                                    let _e2603 = phi_4381_;
                                                    let _e2605 = phi_4382_;
                                                    phi_4383_ = _e2591;
                                                    phi_4384_ = _e2593;
                                                    phi_4385_ = _e2595;
                                                    phi_4386_ = _e2597;
                                                    phi_4387_ = false;
                                                    phi_4388_ = _e2599;
                                                    phi_4389_ = _e2601;
                                                    phi_4390_ = _e2603;
                                                    phi_4391_ = _e2605;
                                                } else {
                                                    phi_4383_ = f32();
                                                    phi_4384_ = f32();
                                                    phi_4385_ = f32();
                                                    phi_4386_ = f32();
                                                    phi_4387_ = true;
                                                    phi_4388_ = false;
                                                    phi_4389_ = false;
                                                    phi_4390_ = false;
                                                    phi_4391_ = false;
                                                }
                                                let _e2607 = phi_4383_;
                                                let _e2609 = phi_4384_;
                                                let _e2611 = phi_4385_;
                                                let _e2613 = phi_4386_;
                                                let _e2615 = phi_4387_;
                                                let _e2617 = phi_4388_;
                                                let _e2619 = phi_4389_;
                                                let _e2621 = phi_4390_;
                                                let _e2623 = phi_4391_;
                                                phi_4392_ = _e2607;
                                                phi_4393_ = _e2609;
                                                phi_4394_ = _e2611;
                                                phi_4395_ = _e2613;
                                                phi_4396_ = _e2615;
                                                phi_4397_ = _e2617;
                                                phi_4398_ = _e2619;
                                                phi_4399_ = _e2621;
                                                phi_4400_ = _e2623;
                                            } else {
                                                phi_4392_ = f32();
                                                phi_4393_ = f32();
                                                phi_4394_ = f32();
                                                phi_4395_ = f32();
                                                phi_4396_ = true;
                                                phi_4397_ = false;
                                                phi_4398_ = false;
                                                phi_4399_ = false;
                                                phi_4400_ = false;
                                            }
                                            let _e2625 = phi_4392_;
                                            let _e2627 = phi_4393_;
                                            let _e2629 = phi_4394_;
                                            let _e2631 = phi_4395_;
                                            let _e2633 = phi_4396_;
                                            let _e2635 = phi_4397_;
                                            let _e2637 = phi_4398_;
                                            let _e2639 = phi_4399_;
                                            let _e2641 = phi_4400_;
                                            if _e2633 {
                                                if (_e1563 <= _e1565) {
                                                    let _e2794 = (_e1573 + 1u);
                                                    let _e2795 = (_e2794 > 3u);
                                                    phi_4735_ = _e2794;
                                                    phi_4736_ = f32();
                                                    phi_4737_ = false;
                                                    phi_4738_ = select(true, false, _e2795);
                                                    phi_4739_ = _e2795;
                                                } else {
                                                    let _e2645 = local_3.member[0u];
                                                    let _e2648 = local_3.member_1[0u];
                                                    let _e2651 = local_3.member[0u];
                                                    let _e2657 = local_3.member_2[0u];
                                                    let _e2658 = ((_e2645 + ((_e2648 - _e2651) * _e1569)) - _e2657);
                                                    let _e2661 = local_3.member[1u];
                                                    let _e2664 = local_3.member_1[1u];
                                                    let _e2667 = local_3.member[1u];
                                                    let _e2673 = local_3.member_2[1u];
                                                    let _e2674 = ((_e2661 + ((_e2664 - _e2667) * _e1569)) - _e2673);
                                                    let _e2676 = select(_e2674, _e2658, (_e2658 < _e2674));
                                                    let _e2679 = local_3.member[2u];
                                                    let _e2682 = local_3.member_1[2u];
                                                    let _e2685 = local_3.member[2u];
                                                    let _e2691 = local_3.member_2[2u];
                                                    let _e2692 = ((_e2679 + ((_e2682 - _e2685) * _e1569)) - _e2691);
                                                    let _e2695 = local_3.member[3u];
                                                    let _e2698 = local_3.member_1[3u];
                                                    let _e2701 = local_3.member[3u];
                                                    let _e2707 = local_3.member_2[3u];
                                                    let _e2708 = ((_e2695 + ((_e2698 - _e2701) * _e1569)) - _e2707);
                                                    let _e2710 = select(_e2708, _e2692, (_e2692 < _e2708));
                                                    let _e2712 = select(_e2710, _e2676, (_e2676 < _e2710));
                                                    let _e2715 = local_4.member[0u];
                                                    let _e2718 = local_4.member_1[0u];
                                                    let _e2721 = local_4.member[0u];
                                                    let _e2727 = local_4.member_2[0u];
                                                    let _e2728 = ((_e2715 + ((_e2718 - _e2721) * _e1563)) - _e2727);
                                                    let _e2731 = local_4.member[1u];
                                                    let _e2734 = local_4.member_1[1u];
                                                    let _e2737 = local_4.member[1u];
                                                    let _e2743 = local_4.member_2[1u];
                                                    let _e2744 = ((_e2731 + ((_e2734 - _e2737) * _e1563)) - _e2743);
                                                    let _e2746 = select(_e2744, _e2728, (_e2728 < _e2744));
                                                    let _e2749 = local_4.member[2u];
                                                    let _e2752 = local_4.member_1[2u];
                                                    let _e2755 = local_4.member[2u];
                                                    let _e2761 = local_4.member_2[2u];
                                                    let _e2762 = ((_e2749 + ((_e2752 - _e2755) * _e1563)) - _e2761);
                                                    let _e2765 = local_4.member[3u];
                                                    let _e2768 = local_4.member_1[3u];
                                                    let _e2771 = local_4.member[3u];
                                                    let _e2777 = local_4.member_2[3u];
                                                    let _e2778 = ((_e2765 + ((_e2768 - _e2771) * _e1563)) - _e2777);
                                                    let _e2780 = select(_e2778, _e2762, (_e2762 < _e2778));
                                                    let _e2782 = select(_e2780, _e2746, (_e2746 < _e2780));
                                                    if (_e2782 > 0f) {
                                                        phi_4733_ = 0.5f;
                                                    } else {
                                                        let _e2786 = (0.95f * (_e2712 / (_e2712 - _e2782)));
                                                        phi_4733_ = select(0.0625f, select(0.9f, _e2786, (_e2786 < 0.9f)), (_e2786 > 0.0625f));
                                                    }
                                                    let _e2792 = phi_4733_;
                                                    phi_4735_ = u32();
                                                    phi_4736_ = (_e1862 * _e2792);
                                                    phi_4737_ = true;
                                                    phi_4738_ = false;
                                                    phi_4739_ = false;
                                                }
                                                let _e2798 = phi_4735_;
                                                let _e2800 = phi_4736_;
                                                let _e2802 = phi_4737_;
                                                let _e2804 = phi_4738_;
                                                let _e2806 = phi_4739_;
                                                phi_4740_ = _e2798;
                                                phi_4741_ = _e1565;
                                                phi_4742_ = _e2800;
                                                phi_4743_ = _e1567;
                                                phi_4744_ = _e1569;
                                                phi_4745_ = _e1571;
                                                phi_4746_ = _e1573;
                                                phi_4747_ = _e2802;
                                                phi_4748_ = _e2804;
                                                phi_4749_ = _e2806;
                                                phi_4750_ = false;
                                                phi_4751_ = false;
                                                phi_4752_ = false;
                                            } else {
                                                phi_4740_ = u32();
                                                phi_4741_ = _e2625;
                                                phi_4742_ = _e2627;
                                                phi_4743_ = _e2629;
                                                phi_4744_ = _e1563;
                                                phi_4745_ = true;
                                                phi_4746_ = 0u;
                                                phi_4747_ = _e2635;
                                                phi_4748_ = false;
                                                phi_4749_ = false;
                                                phi_4750_ = _e2637;
                                                phi_4751_ = _e2639;
                                                phi_4752_ = _e2641;
                                            }
                                            let _e2808 = phi_4740_;
                                            let _e2810 = phi_4741_;
                                            let _e2812 = phi_4742_;
                                            let _e2814 = phi_4743_;
                                            let _e2816 = phi_4744_;
                                            let _e2818 = phi_4745_;
                                            let _e2820 = phi_4746_;
                                            let _e2822 = phi_4747_;
                                            let _e2824 = phi_4748_;
                                            let _e2826 = phi_4749_;
                                            let _e2828 = phi_4750_;
                                            let _e2830 = phi_4751_;
                                            let _e2832 = phi_4752_;
                                            if _e2822 {
                                                let _e2833 = (_e2816 + _e2812);
                                                let _e2835 = select(_e2810, _e2833, (_e2833 > _e2810));
                                                let _e2837 = select(_e388, _e2835, (_e2835 < _e388));
                                                let _e2840 = select(((_e2837 - _e2816) > _e1558), true, !(_e1571));
                                                phi_4780_ = _e2837;
                                                phi_4781_ = _e2810;
                                                phi_4782_ = _e2814;
                                                phi_4783_ = _e2816;
                                                phi_4784_ = _e2818;
                                                phi_4785_ = _e2820;
                                                phi_4786_ = _e2840;
                                                phi_4787_ = select(true, false, _e2840);
                                                phi_4788_ = false;
                                                phi_4789_ = false;
                                                phi_4790_ = false;
                                                phi_4791_ = false;
                                            } else {
                                                phi_4780_ = _e1563;
                                                phi_4781_ = _e1565;
                                                phi_4782_ = _e1567;
                                                phi_4783_ = _e1569;
                                                phi_4784_ = _e1571;
                                                phi_4785_ = _e2808;
                                                phi_4786_ = _e2824;
                                                phi_4787_ = false;
                                                phi_4788_ = _e2826;
                                                phi_4789_ = _e2828;
                                                phi_4790_ = _e2830;
                                                phi_4791_ = _e2832;
                                            }
                                            let _e2843 = phi_4780_;
                                            let _e2845 = phi_4781_;
                                            let _e2847 = phi_4782_;
                                            let _e2849 = phi_4783_;
                                            let _e2851 = phi_4784_;
                                            let _e2853 = phi_4785_;
                                            let _e2855 = phi_4786_;
                                            let _e2857 = phi_4787_;
                                            let _e2859 = phi_4788_;
                                            let _e2861 = phi_4789_;
                                            let _e2863 = phi_4790_;
                                            let _e2865 = phi_4791_;
                                            phi_2613_ = _e2843;
                                            phi_2615_ = _e2845;
                                            phi_2617_ = _e2847;
                                            phi_2619_ = _e2849;
                                            phi_2621_ = _e2851;
                                            phi_2623_ = _e2853;
                                            phi_4792_ = _e2810;
                                            phi_4793_ = _e2631;
                                            phi_4794_ = _e2855;
                                            phi_4795_ = _e2857;
                                            phi_4796_ = _e2859;
                                            phi_4797_ = _e2861;
                                            phi_4798_ = _e2863;
                                            phi_4799_ = false;
                                            phi_4800_ = _e2865;
                                        } else {
                                            phi_2613_ = f32();
                                            phi_2615_ = f32();
                                            phi_2617_ = f32();
                                            phi_2619_ = f32();
                                            phi_2621_ = bool();
                                            phi_2623_ = u32();
                                            phi_4792_ = f32();
                                            phi_4793_ = f32();
                                            phi_4794_ = false;
                                            phi_4795_ = false;
                                            phi_4796_ = false;
                                            phi_4797_ = false;
                                            phi_4798_ = false;
                                            phi_4799_ = true;
                                            phi_4800_ = false;
                                        }
                                        let _e2867 = phi_2613_;
                                        let _e2869 = phi_2615_;
                                        let _e2871 = phi_2617_;
                                        let _e2873 = phi_2619_;
                                        let _e2875 = phi_2621_;
                                        let _e2877 = phi_2623_;
                                        let _e2879 = phi_4792_;
                                        let _e2881 = phi_4793_;
                                        let _e2883 = phi_4794_;
                                        let _e2885 = phi_4795_;
                                        let _e2887 = phi_4796_;
                                        let _e2889 = phi_4797_;
                                        let _e2891 = phi_4798_;
                                        let _e2893 = phi_4799_;
                                        let _e2895 = phi_4800_;
                                        local_9 = _e2885;
                                        local_10 = _e2887;
                                        local_11 = _e2885;
                                        local_12 = _e2889;
                                        local_13 = _e2885;
                                        local_14 = _e2891;
                                        local_15 = _e2885;
                                        local_16 = _e2893;
                                        local_17 = _e2885;
                                        local_18 = _e2895;
                                        local_20 = _e2885;
                                        local_21 = _e2881;
                                        local_22 = _e2879;
                                        continue;
                                        continuing {
                                            phi_2609_ = type_9(select(_e1561.member, (_e1561.member + 1u), _e1576), select(_e1561.member_1, _e1561.member_1, _e1576));
                                            phi_2612_ = _e2867;
                                            phi_2614_ = _e2869;
                                            phi_2616_ = _e2871;
                                            phi_2618_ = _e2873;
                                            phi_2620_ = _e2875;
                                            phi_2622_ = _e2877;
                                            break if !(_e2883);
                                        }
                                    }
                                    let _e2898 = local_9;
                                    let _e2900 = local_10;
                                    let _e2901 = select(_e2900, false, _e2898);
                                    let _e2903 = local_11;
                                    let _e2905 = local_12;
                                    let _e2908 = local_13;
                                    let _e2910 = local_14;
                                    let _e2913 = local_15;
                                    let _e2915 = local_16;
                                    let _e2918 = local_17;
                                    let _e2920 = local_18;
                                    let _e2926 = local_19;
                                    let _e2928 = select(select(_e2905, false, _e2903), false, _e2901);
                                    let _e2931 = local_20;
                                    let _e2938 = select(select(select(_e2910, false, _e2908), false, _e2901), false, _e2928);
                                    let _e2944 = local_21;
                                    let _e2946 = local_22;
                                    let _e2948 = select(select(select(_e2931, false, _e2901), false, _e2928), true, _e2938);
                                    let _e2953 = local_23;
                                    let _e2955 = select(select(select(select(select(_e2915, false, _e2913), false, _e2901), false, _e2928), false, _e2938), true, _e2948);
                                    let _e2962 = select(select(select(select(select(select(_e2920, false, _e2918), false, _e2901), false, _e2928), false, _e2938), false, _e2948), false, _e2955);
                                    let _e2967 = select(select(select(select(select(_e2901, true, _e2928), false, _e2938), false, _e2948), false, _e2955), true, _e2962);
                                    phi_4867_ = select(select(type_34().member_1, select(_e2953, select(_e2946, _e2944, _e2938), _e2948), _e2955), select(select(select(type_34().member_1, _e2926, _e2901), type_34().member_1, _e2928), type_34().member_1, _e2962), _e2967);
                                    phi_4868_ = (select(select(type_34().member, 1u, _e2955), select(select(select(type_34().member, 1u, _e2901), 0u, _e2928), 0u, _e2962), _e2967) != 0u);
                                } else {
                                    phi_4867_ = _e1325;
                                    phi_4868_ = true;
                                }
                                let _e2972 = phi_4867_;
                                let _e2974 = phi_4868_;
                                if _e2974 {
                                    let _e2975 = (_e2972 > _e386);
                                    if _e2975 {
                                        phi_7033_ = f32();
                                        phi_7034_ = u32();
                                        phi_7035_ = f32();
                                        phi_7036_ = type_36();
                                        phi_7037_ = u32();
                                        phi_7038_ = u32();
                                        phi_7039_ = false;
                                        phi_7040_ = false;
                                        phi_7041_ = false;
                                    } else {
                                        let _e2978 = local_5.member[0u];
                                        let _e2984 = local_5.member[1u];
                                        let _e3000 = local_5.member_1[0u];
                                        let _e3006 = local_5.member_1[1u];
                                        let _e3022 = local_5.member_2[0u];
                                        let _e3028 = local_5.member_2[1u];
                                        let _e3042 = function_3(array<f32, 3>((_e2978[0] + ((_e2984[0] - _e2978[0]) * _e1329)), (_e2978[1] + ((_e2984[1] - _e2978[1]) * _e1329)), (_e2978[2] + ((_e2984[2] - _e2978[2]) * _e1329))), array<f32, 3>((_e3000[0] + ((_e3006[0] - _e3000[0]) * _e1329)), (_e3000[1] + ((_e3006[1] - _e3000[1]) * _e1329)), (_e3000[2] + ((_e3006[2] - _e3000[2]) * _e1329))), array<f32, 3>((_e3022[0] + ((_e3028[0] - _e3022[0]) * _e1329)), (_e3022[1] + ((_e3028[1] - _e3022[1]) * _e1329)), (_e3022[2] + ((_e3028[2] - _e3022[2]) * _e1329))), _e231.member);
                                        let _e3056 = ((select(_e3042[0], -(_e3042[0]), (_e3042[0] < 0f)) + select(_e3042[1], -(_e3042[1]), (_e3042[1] < 0f))) + select(_e3042[2], -(_e3042[2]), (_e3042[2] < 0f)));
                                        let _e3059 = local_5.member[0u];
                                        let _e3065 = local_5.member_1[0u];
                                        let _e3071 = local_5.member_2[0u];
                                        let _e3075 = (_e3059[0] - _e3065[0]);
                                        let _e3076 = (_e3059[1] - _e3065[1]);
                                        let _e3077 = (_e3059[2] - _e3065[2]);
                                        let _e3078 = (_e231.member == 0u);
                                        let _e3090 = local_5.member[1u];
                                        let _e3096 = local_5.member_1[1u];
                                        let _e3102 = local_5.member_2[1u];
                                        let _e3106 = (_e3090[0] - _e3096[0]);
                                        let _e3107 = (_e3090[1] - _e3096[1]);
                                        let _e3108 = (_e3090[2] - _e3096[2]);
                                        let _e3109 = (_e231.member == 0u);
                                        let _e3121 = local_5.member[0u];
                                        let _e3127 = select(_e3121[0], -(_e3121[0]), (_e3121[0] < 0f));
                                        let _e3130 = select(_e3121[1], -(_e3121[1]), (_e3121[1] < 0f));
                                        let _e3132 = select(_e3130, _e3127, (_e3127 > _e3130));
                                        let _e3135 = select(_e3121[2], -(_e3121[2]), (_e3121[2] < 0f));
                                        let _e3137 = select(_e3135, _e3132, (_e3132 > _e3135));
                                        let _e3140 = local_5.member[1u];
                                        let _e3146 = select(_e3140[0], -(_e3140[0]), (_e3140[0] < 0f));
                                        let _e3149 = select(_e3140[1], -(_e3140[1]), (_e3140[1] < 0f));
                                        let _e3151 = select(_e3149, _e3146, (_e3146 > _e3149));
                                        let _e3154 = select(_e3140[2], -(_e3140[2]), (_e3140[2] < 0f));
                                        let _e3156 = select(_e3154, _e3151, (_e3151 > _e3154));
                                        let _e3160 = local_5.member_3;
                                        let _e3164 = local_5.member_1[0u];
                                        let _e3170 = select(_e3164[0], -(_e3164[0]), (_e3164[0] < 0f));
                                        let _e3173 = select(_e3164[1], -(_e3164[1]), (_e3164[1] < 0f));
                                        let _e3175 = select(_e3173, _e3170, (_e3170 > _e3173));
                                        let _e3178 = select(_e3164[2], -(_e3164[2]), (_e3164[2] < 0f));
                                        let _e3180 = select(_e3178, _e3175, (_e3175 > _e3178));
                                        let _e3183 = local_5.member_1[1u];
                                        let _e3189 = select(_e3183[0], -(_e3183[0]), (_e3183[0] < 0f));
                                        let _e3192 = select(_e3183[1], -(_e3183[1]), (_e3183[1] < 0f));
                                        let _e3194 = select(_e3192, _e3189, (_e3189 > _e3192));
                                        let _e3197 = select(_e3183[2], -(_e3183[2]), (_e3183[2] < 0f));
                                        let _e3199 = select(_e3197, _e3194, (_e3194 > _e3197));
                                        let _e3203 = local_5.member_3;
                                        let _e3207 = local_5.member_2[0u];
                                        let _e3213 = select(_e3207[0], -(_e3207[0]), (_e3207[0] < 0f));
                                        let _e3216 = select(_e3207[1], -(_e3207[1]), (_e3207[1] < 0f));
                                        let _e3218 = select(_e3216, _e3213, (_e3213 > _e3216));
                                        let _e3221 = select(_e3207[2], -(_e3207[2]), (_e3207[2] < 0f));
                                        let _e3223 = select(_e3221, _e3218, (_e3218 > _e3221));
                                        let _e3226 = local_5.member_2[1u];
                                        let _e3232 = select(_e3226[0], -(_e3226[0]), (_e3226[0] < 0f));
                                        let _e3235 = select(_e3226[1], -(_e3226[1]), (_e3226[1] < 0f));
                                        let _e3237 = select(_e3235, _e3232, (_e3232 > _e3235));
                                        let _e3240 = select(_e3226[2], -(_e3226[2]), (_e3226[2] < 0f));
                                        let _e3242 = select(_e3240, _e3237, (_e3237 > _e3240));
                                        let _e3246 = local_5.member_3;
                                        let _e3253 = local_5.member_3;
                                        local_1 = type_30(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3059, array<f32, 3>(_e3075, _e3076, _e3077), array<f32, 3>((_e3059[0] - _e3071[0]), (_e3059[1] - _e3071[1]), (_e3059[2] - _e3071[2])), array<f32, 3>(select((_e3075 - _e3071[0]), _e3059[0], _e3078), select((_e3076 - _e3071[1]), _e3059[1], _e3078), select((_e3077 - _e3071[2]), _e3059[2], _e3078))), array<array<f32, 3>, 4>(_e3090, array<f32, 3>(_e3106, _e3107, _e3108), array<f32, 3>((_e3090[0] - _e3102[0]), (_e3090[1] - _e3102[1]), (_e3090[2] - _e3102[2])), array<f32, 3>(select((_e3106 - _e3102[0]), _e3090[0], _e3109), select((_e3107 - _e3102[1]), _e3090[1], _e3109), select((_e3108 - _e3102[2]), _e3090[2], _e3109)))), ((((((select(_e3156, _e3137, (_e3137 > _e3156)) + _e3160) + (select(_e3199, _e3180, (_e3180 > _e3199)) + _e3203)) + (select(_e3242, _e3223, (_e3223 > _e3242)) + _e3246)) * (0.000000059604645f * 16f)) + (_e3253 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e615.member_1);
                                        let _e3269 = local_1.member_1;
                                        if (_e3056 > _e3269) {
                                            if ((bitcast<u32>(_e3056) & 2139095040u) != 2139095040u) {
                                                let _e3274 = (1f / _e3056);
                                                let _e3276 = (_e3042[0] * _e3274);
                                                let _e3278 = (_e3042[1] * _e3274);
                                                let _e3280 = (_e3042[2] * _e3274);
                                                let _e3285 = (((_e3276 * _e3276) + (_e3278 * _e3278)) + (_e3280 * _e3280));
                                                if (_e3285 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5545_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3285 > 0f));
                                                } else {
                                                    phi_5488_ = type_14(0i, 5i);
                                                    phi_5491_ = bitcast<f32>(((bitcast<u32>(_e3285) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3293 = phi_5488_;
                                                        let _e3295 = phi_5491_;
                                                        local_24 = _e3295;
                                                        if (_e3293.member < _e3293.member_1) {
                                                            let _e3302 = (_e3293.member + 1i);
                                                            phi_5489_ = type_14(select(_e3302, type_15().member_1, select(false, true, ((false == (_e3302 > _e3293.member)) != false))), _e3293.member_1);
                                                            phi_5532_ = type_15(1u, _e3293.member);
                                                        } else {
                                                            phi_5489_ = _e3293;
                                                            phi_5532_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3313 = phi_5489_;
                                                        let _e3315 = phi_5532_;
                                                        let _e3318 = (bitcast<i32>(_e3315.member) != 0i);
                                                        if _e3318 {
                                                            phi_5492_ = (0.5f * (_e3295 + (_e3285 / _e3295)));
                                                        } else {
                                                            phi_5492_ = f32();
                                                        }
                                                        let _e3323 = phi_5492_;
                                                        continue;
                                                        continuing {
                                                            phi_5488_ = _e3313;
                                                            phi_5491_ = _e3323;
                                                            break if !(_e3318);
                                                        }
                                                    }
                                                    let _e3328 = local_24;
                                                    phi_5545_ = (_e3328 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3334 = phi_5545_;
                                                let _e3335 = (0.000000059604645f * 12f);
                                                let _e3337 = local_1.member_1;
                                                let _e3340 = local_1.member_2;
                                                let _e3344 = ((_e3337 * 1.01f) + ((_e3340 * _e3334) * (1f + _e3335)));
                                                let _e3348 = local_1.member[0u][0u];
                                                let _e3356 = (((_e3276 * _e3348[0]) + (_e3278 * _e3348[1])) + (_e3280 * _e3348[2]));
                                                let _e3360 = local_1.member[0u][1u];
                                                let _e3368 = (((_e3276 * _e3360[0]) + (_e3278 * _e3360[1])) + (_e3280 * _e3360[2]));
                                                let _e3372 = local_1.member[0u][2u];
                                                let _e3380 = (((_e3276 * _e3372[0]) + (_e3278 * _e3372[1])) + (_e3280 * _e3372[2]));
                                                let _e3384 = local_1.member[0u][3u];
                                                let _e3392 = (((_e3276 * _e3384[0]) + (_e3278 * _e3384[1])) + (_e3280 * _e3384[2]));
                                                let _e3396 = local_1.member[1u][0u];
                                                let _e3404 = (((_e3276 * _e3396[0]) + (_e3278 * _e3396[1])) + (_e3280 * _e3396[2]));
                                                let _e3408 = local_1.member[1u][1u];
                                                let _e3416 = (((_e3276 * _e3408[0]) + (_e3278 * _e3408[1])) + (_e3280 * _e3408[2]));
                                                let _e3420 = local_1.member[1u][2u];
                                                let _e3428 = (((_e3276 * _e3420[0]) + (_e3278 * _e3420[1])) + (_e3280 * _e3420[2]));
                                                let _e3432 = local_1.member[1u][3u];
                                                let _e3440 = (((_e3276 * _e3432[0]) + (_e3278 * _e3432[1])) + (_e3280 * _e3432[2]));
                                                local_2 = type_31(array<f32, 4>(_e3356, _e3368, _e3380, _e3392), array<f32, 4>(_e3404, _e3416, _e3428, _e3440), array<f32, 4>((_e3344 + ((select(_e3356, -(_e3356), (_e3356 < 0f)) + select(_e3404, -(_e3404), (_e3404 < 0f))) * _e3335)), (_e3344 + ((select(_e3368, -(_e3368), (_e3368 < 0f)) + select(_e3416, -(_e3416), (_e3416 < 0f))) * _e3335)), (_e3344 + ((select(_e3380, -(_e3380), (_e3380 < 0f)) + select(_e3428, -(_e3428), (_e3428 < 0f))) * _e3335)), (_e3344 + ((select(_e3392, -(_e3392), (_e3392 < 0f)) + select(_e3440, -(_e3440), (_e3440 < 0f))) * _e3335))));
                                                let _e3485 = (((_e3276 * _e3276) + (_e3278 * _e3278)) + (_e3280 * _e3280));
                                                if (_e3485 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5837_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3485 > 0f));
                                                } else {
                                                    phi_5780_ = type_14(0i, 5i);
                                                    phi_5783_ = bitcast<f32>(((bitcast<u32>(_e3485) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3493 = phi_5780_;
                                                        let _e3495 = phi_5783_;
                                                        local_25 = _e3495;
                                                        if (_e3493.member < _e3493.member_1) {
                                                            let _e3502 = (_e3493.member + 1i);
                                                            phi_5781_ = type_14(select(_e3502, type_15().member_1, select(false, true, ((false == (_e3502 > _e3493.member)) != false))), _e3493.member_1);
                                                            phi_5824_ = type_15(1u, _e3493.member);
                                                        } else {
                                                            phi_5781_ = _e3493;
                                                            phi_5824_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3513 = phi_5781_;
                                                        let _e3515 = phi_5824_;
                                                        let _e3518 = (bitcast<i32>(_e3515.member) != 0i);
                                                        if _e3518 {
                                                            phi_5784_ = (0.5f * (_e3495 + (_e3485 / _e3495)));
                                                        } else {
                                                            phi_5784_ = f32();
                                                        }
                                                        let _e3523 = phi_5784_;
                                                        continue;
                                                        continuing {
                                                            phi_5780_ = _e3513;
                                                            phi_5783_ = _e3523;
                                                            break if !(_e3518);
                                                        }
                                                    }
                                                    let _e3528 = local_25;
                                                    phi_5837_ = (_e3528 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3534 = phi_5837_;
                                                let _e3545 = (((_e3042[0] * _e3042[0]) + (_e3042[1] * _e3042[1])) + (_e3042[2] * _e3042[2]));
                                                if (_e3545 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5926_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3545 > 0f));
                                                } else {
                                                    phi_5869_ = type_14(0i, 5i);
                                                    phi_5872_ = bitcast<f32>(((bitcast<u32>(_e3545) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3553 = phi_5869_;
                                                        let _e3555 = phi_5872_;
                                                        local_26 = _e3555;
                                                        if (_e3553.member < _e3553.member_1) {
                                                            let _e3562 = (_e3553.member + 1i);
                                                            phi_5870_ = type_14(select(_e3562, type_15().member_1, select(false, true, ((false == (_e3562 > _e3553.member)) != false))), _e3553.member_1);
                                                            phi_5913_ = type_15(1u, _e3553.member);
                                                        } else {
                                                            phi_5870_ = _e3553;
                                                            phi_5913_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3573 = phi_5870_;
                                                        let _e3575 = phi_5913_;
                                                        let _e3578 = (bitcast<i32>(_e3575.member) != 0i);
                                                        if _e3578 {
                                                            phi_5873_ = (0.5f * (_e3555 + (_e3545 / _e3555)));
                                                        } else {
                                                            phi_5873_ = f32();
                                                        }
                                                        let _e3583 = phi_5873_;
                                                        continue;
                                                        continuing {
                                                            phi_5869_ = _e3573;
                                                            phi_5872_ = _e3583;
                                                            break if !(_e3578);
                                                        }
                                                    }
                                                    let _e3588 = local_26;
                                                    phi_5926_ = (_e3588 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3594 = phi_5926_;
                                                let _e3600 = local_5.member[0u];
                                                let _e3606 = select(_e3600[0], -(_e3600[0]), (_e3600[0] < 0f));
                                                let _e3609 = select(_e3600[1], -(_e3600[1]), (_e3600[1] < 0f));
                                                let _e3611 = select(_e3609, _e3606, (_e3606 > _e3609));
                                                let _e3614 = select(_e3600[2], -(_e3600[2]), (_e3600[2] < 0f));
                                                let _e3616 = select(_e3614, _e3611, (_e3611 > _e3614));
                                                let _e3619 = local_5.member[1u];
                                                let _e3625 = select(_e3619[0], -(_e3619[0]), (_e3619[0] < 0f));
                                                let _e3628 = select(_e3619[1], -(_e3619[1]), (_e3619[1] < 0f));
                                                let _e3630 = select(_e3628, _e3625, (_e3625 > _e3628));
                                                let _e3633 = select(_e3619[2], -(_e3619[2]), (_e3619[2] < 0f));
                                                let _e3635 = select(_e3633, _e3630, (_e3630 > _e3633));
                                                let _e3639 = local_5.member_3;
                                                let _e3643 = local_5.member_1[0u];
                                                let _e3649 = select(_e3643[0], -(_e3643[0]), (_e3643[0] < 0f));
                                                let _e3652 = select(_e3643[1], -(_e3643[1]), (_e3643[1] < 0f));
                                                let _e3654 = select(_e3652, _e3649, (_e3649 > _e3652));
                                                let _e3657 = select(_e3643[2], -(_e3643[2]), (_e3643[2] < 0f));
                                                let _e3659 = select(_e3657, _e3654, (_e3654 > _e3657));
                                                let _e3662 = local_5.member_1[1u];
                                                let _e3668 = select(_e3662[0], -(_e3662[0]), (_e3662[0] < 0f));
                                                let _e3671 = select(_e3662[1], -(_e3662[1]), (_e3662[1] < 0f));
                                                let _e3673 = select(_e3671, _e3668, (_e3668 > _e3671));
                                                let _e3676 = select(_e3662[2], -(_e3662[2]), (_e3662[2] < 0f));
                                                let _e3678 = select(_e3676, _e3673, (_e3673 > _e3676));
                                                let _e3682 = local_5.member_3;
                                                let _e3686 = local_5.member_2[0u];
                                                let _e3692 = select(_e3686[0], -(_e3686[0]), (_e3686[0] < 0f));
                                                let _e3695 = select(_e3686[1], -(_e3686[1]), (_e3686[1] < 0f));
                                                let _e3697 = select(_e3695, _e3692, (_e3692 > _e3695));
                                                let _e3700 = select(_e3686[2], -(_e3686[2]), (_e3686[2] < 0f));
                                                let _e3702 = select(_e3700, _e3697, (_e3697 > _e3700));
                                                let _e3705 = local_5.member_2[1u];
                                                let _e3711 = select(_e3705[0], -(_e3705[0]), (_e3705[0] < 0f));
                                                let _e3714 = select(_e3705[1], -(_e3705[1]), (_e3705[1] < 0f));
                                                let _e3716 = select(_e3714, _e3711, (_e3711 > _e3714));
                                                let _e3719 = select(_e3705[2], -(_e3705[2]), (_e3705[2] < 0f));
                                                let _e3721 = select(_e3719, _e3716, (_e3716 > _e3719));
                                                let _e3725 = local_5.member_3;
                                                let _e3732 = local_5.member_3;
                                                let _e3742 = ((((_e3594 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3635, _e3616, (_e3616 > _e3635)) + _e3639) + (select(_e3678, _e3659, (_e3659 > _e3678)) + _e3682)) + (select(_e3721, _e3702, (_e3702 > _e3721)) + _e3725)) * (0.000000059604645f * 16f)) + (_e3732 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3534) * (1f + (0.000000059604645f * 64f)));
                                                let _e3745 = local_2.member[0u];
                                                let _e3748 = local_2.member_1[0u];
                                                phi_6234_ = type_9(1u, 4u);
                                                phi_6237_ = ((_e3745 + ((_e3748 - _e3745) * _e1329)) - ((_e3269 * 1.01f) + ((select(_e3745, -(_e3745), (_e3745 < 0f)) + select(_e3748, -(_e3748), (_e3748 < 0f))) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e3765 = phi_6234_;
                                                    let _e3767 = phi_6237_;
                                                    local_27 = _e3767;
                                                    local_28 = _e3767;
                                                    let _e3770 = (_e3765.member < _e3765.member_1);
                                                    let _e3781 = select(type_9().member_1, _e3765.member, _e3770);
                                                    let _e3783 = (bitcast<i32>(select(0u, 1u, _e3770)) != 0i);
                                                    if _e3783 {
                                                        let _e3786 = local_2.member[_e3781];
                                                        let _e3789 = local_2.member_1[_e3781];
                                                        let _e3804 = ((_e3786 + ((_e3789 - _e3786) * _e1329)) - ((_e3269 * 1.01f) + ((select(_e3786, -(_e3786), (_e3786 < 0f)) + select(_e3789, -(_e3789), (_e3789 < 0f))) * (0.000000059604645f * 12f))));
                                                        phi_6238_ = select(_e3804, _e3767, (_e3767 < _e3804));
                                                    } else {
                                                        phi_6238_ = f32();
                                                    }
                                                    let _e3808 = phi_6238_;
                                                    continue;
                                                    continuing {
                                                        phi_6234_ = type_9(select(_e3765.member, (_e3765.member + 1u), _e3770), select(_e3765.member_1, _e3765.member_1, _e3770));
                                                        phi_6237_ = _e3808;
                                                        break if !(_e3783);
                                                    }
                                                }
                                                let _e3811 = local_27;
                                                if (_e3811 > 0f) {
                                                    let _e3815 = local_28;
                                                    let _e3818 = (((_e3742 - _e3815) / _e3742) * 2.02f);
                                                    if (_e3818 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_6393_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3818 > 0f));
                                                    } else {
                                                        phi_6336_ = type_14(0i, 5i);
                                                        phi_6339_ = bitcast<f32>(((bitcast<u32>(_e3818) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e3826 = phi_6336_;
                                                            let _e3828 = phi_6339_;
                                                            local_29 = _e3828;
                                                            if (_e3826.member < _e3826.member_1) {
                                                                let _e3835 = (_e3826.member + 1i);
                                                                phi_6337_ = type_14(select(_e3835, type_15().member_1, select(false, true, ((false == (_e3835 > _e3826.member)) != false))), _e3826.member_1);
                                                                phi_6380_ = type_15(1u, _e3826.member);
                                                            } else {
                                                                phi_6337_ = _e3826;
                                                                phi_6380_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e3846 = phi_6337_;
                                                            let _e3848 = phi_6380_;
                                                            let _e3851 = (bitcast<i32>(_e3848.member) != 0i);
                                                            if _e3851 {
                                                                phi_6340_ = (0.5f * (_e3828 + (_e3818 / _e3828)));
                                                            } else {
                                                                phi_6340_ = f32();
                                                            }
                                                            let _e3856 = phi_6340_;
                                                            continue;
                                                            continuing {
                                                                phi_6336_ = _e3846;
                                                                phi_6339_ = _e3856;
                                                                break if !(_e3851);
                                                            }
                                                        }
                                                        let _e3861 = local_29;
                                                        phi_6393_ = (_e3861 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e3867 = phi_6393_;
                                                    let _e3869 = ((_e3867 * _e3534) * 1.01f);
                                                    phi_6398_ = type_9(0u, 4u);
                                                    phi_6401_ = 2f;
                                                    phi_6403_ = true;
                                                    phi_6405_ = true;
                                                    loop {
                                                        let _e3871 = phi_6398_;
                                                        let _e3873 = phi_6401_;
                                                        let _e3875 = phi_6403_;
                                                        let _e3877 = phi_6405_;
                                                        local_30 = _e3873;
                                                        local_31 = _e3873;
                                                        local_32 = _e3875;
                                                        local_33 = _e3877;
                                                        local_34 = _e3877;
                                                        local_35 = _e3877;
                                                        local_60 = _e3877;
                                                        local_36 = _e3877;
                                                        let _e3880 = (_e3871.member < _e3871.member_1);
                                                        let _e3891 = select(type_9().member_1, _e3871.member, _e3880);
                                                        let _e3893 = (bitcast<i32>(select(0u, 1u, _e3880)) != 0i);
                                                        if _e3893 {
                                                            let _e3897 = local_1.member[0u][_e3891];
                                                            let _e3904 = local_1.member[1u][_e3891];
                                                            let _e3918 = ((select(_e3897[0], -(_e3897[0]), (_e3897[0] < 0f)) + select(_e3897[1], -(_e3897[1]), (_e3897[1] < 0f))) + select(_e3897[2], -(_e3897[2]), (_e3897[2] < 0f)));
                                                            let _e3929 = ((select(_e3904[0], -(_e3904[0]), (_e3904[0] < 0f)) + select(_e3904[1], -(_e3904[1]), (_e3904[1] < 0f))) + select(_e3904[2], -(_e3904[2]), (_e3904[2] < 0f)));
                                                            let _e3935 = (_e3904[0] - _e3897[0]);
                                                            let _e3936 = (_e3904[1] - _e3897[1]);
                                                            let _e3937 = (_e3904[2] - _e3897[2]);
                                                            let _e3954 = local_2.member[_e3891];
                                                            let _e3957 = local_2.member_1[_e3891];
                                                            let _e3968 = ((_e3269 * 1.01f) + ((select(_e3954, -(_e3954), (_e3954 < 0f)) + select(_e3957, -(_e3957), (_e3957 < 0f))) * (0.000000059604645f * 12f)));
                                                            let _e3975 = local_2.member_1[_e3891];
                                                            let _e3978 = local_2.member[_e3891];
                                                            let _e3979 = (_e3975 - _e3978);
                                                            let _e3982 = ((_e3968 + _e3968) + (_e3869 * ((((select(_e3935, -(_e3935), (_e3935 < 0f)) + select(_e3936, -(_e3936), (_e3936 < 0f))) + select(_e3937, -(_e3937), (_e3937 < 0f))) + (_e3269 * 6f)) * 1.01f)));
                                                            let _e3985 = ((((_e3954 + ((_e3957 - _e3954) * _e1329)) - _e3968) - (_e3869 * ((select(_e3929, _e3918, (_e3918 > _e3929)) + (_e3269 * 3f)) * 1.01f))) - _e3742);
                                                            let _e3986 = (_e3985 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e3987 = (_e3979 > _e3982);
                                                            if _e3987 {
                                                                phi_6636_ = _e3873;
                                                            } else {
                                                                if _e3986 {
                                                                    let _e3994 = (_e3982 - _e3979);
                                                                    let _e3997 = (_e3985 / select(0.000000000000000000000000000000000000011754944f, _e3994, (_e3994 > 0.000000000000000000000000000000000000011754944f)));
                                                                    phi_6635_ = select(_e3997, _e3873, (_e3873 < _e3997));
                                                                } else {
                                                                    phi_6635_ = _e3873;
                                                                }
                                                                let _e4001 = phi_6635_;
                                                                phi_6636_ = _e4001;
                                                            }
                                                            let _e4003 = phi_6636_;
                                                            phi_6402_ = _e4003;
                                                            phi_6404_ = (_e3875 && select(_e3986, true, (_e3979 < -(_e3982))));
                                                            phi_6406_ = (_e3877 && select(_e3986, true, _e3987));
                                                        } else {
                                                            phi_6402_ = f32();
                                                            phi_6404_ = bool();
                                                            phi_6406_ = bool();
                                                        }
                                                        let _e4005 = phi_6402_;
                                                        let _e4007 = phi_6404_;
                                                        let _e4009 = phi_6406_;
                                                        continue;
                                                        continuing {
                                                            phi_6398_ = type_9(select(_e3871.member, (_e3871.member + 1u), _e3880), select(_e3871.member_1, _e3871.member_1, _e3880));
                                                            phi_6401_ = _e4005;
                                                            phi_6403_ = _e4007;
                                                            phi_6405_ = _e4009;
                                                            break if !(_e3893);
                                                        }
                                                    }
                                                    let _e4012 = local_30;
                                                    let _e4015 = local_31;
                                                    let _e4017 = (select(2f, _e4015, (_e4012 < 2f)) * 0.999f);
                                                    let _e4019 = local_32;
                                                    if _e4019 {
                                                        let _e4022 = local_33;
                                                        let _e4026 = local_34;
                                                        let _e4030 = local_35;
                                                        phi_6651_ = type_36(select(1u, type_36().member, _e4022), select(_e1329, type_36().member_1, _e4026), select(2f, type_36().member_2, _e4030));
                                                        let _e5184 = local_60;
                                                        phi_6652_ = _e5184;
                                                    } else {
                                                        phi_6651_ = type_36();
                                                        phi_6652_ = true;
                                                    }
                                                    let _e4034 = phi_6651_;
                                                    let _e4036 = phi_6652_;
                                                    if _e4036 {
                                                        let _e4038 = local_36;
                                                        if _e4038 {
                                                            let _e4042 = (_e1329 + _e4017);
                                                            let _e4045 = select(_e1329, select(_e388, _e4042, (_e4042 < _e388)), (_e4017 > (0.000000059604645f * 4096f)));
                                                            phi_6673_ = type_9(0u, 4u);
                                                            phi_6676_ = _e4045;
                                                            phi_6678_ = _e1329;
                                                            loop {
                                                                let _e4047 = phi_6673_;
                                                                let _e4049 = phi_6676_;
                                                                let _e4051 = phi_6678_;
                                                                local_37 = _e4049;
                                                                local_38 = _e4051;
                                                                local_39 = _e4051;
                                                                let _e4054 = (_e4047.member < _e4047.member_1);
                                                                let _e4065 = select(type_9().member_1, _e4047.member, _e4054);
                                                                let _e4067 = (bitcast<i32>(select(0u, 1u, _e4054)) != 0i);
                                                                if _e4067 {
                                                                    let _e4070 = local_2.member[_e4065];
                                                                    let _e4073 = local_2.member_1[_e4065];
                                                                    let _e4076 = local_2.member[_e4065];
                                                                    let _e4082 = local_2.member_2[_e4065];
                                                                    let _e4083 = ((_e4070 + ((_e4073 - _e4076) * _e1329)) - _e4082);
                                                                    let _e4086 = local_2.member_1[_e4065];
                                                                    let _e4089 = local_2.member[_e4065];
                                                                    let _e4090 = (_e4086 - _e4089);
                                                                    if (_e4090 > 0f) {
                                                                        let _e4103 = (_e1329 - (_e4083 / _e4090));
                                                                        phi_6787_ = _e4049;
                                                                        phi_6788_ = select(_e4103, _e4051, (_e4051 > _e4103));
                                                                    } else {
                                                                        if (_e4083 > 0f) {
                                                                            if (_e4090 < 0f) {
                                                                                let _e4095 = (_e1329 - (_e4083 / _e4090));
                                                                                phi_6785_ = select(_e4095, _e4049, (_e4049 < _e4095));
                                                                            } else {
                                                                                phi_6785_ = _e4049;
                                                                            }
                                                                            let _e4099 = phi_6785_;
                                                                            phi_6786_ = _e4099;
                                                                        } else {
                                                                            phi_6786_ = _e4049;
                                                                        }
                                                                        let _e4101 = phi_6786_;
                                                                        phi_6787_ = _e4101;
                                                                        phi_6788_ = _e4051;
                                                                    }
                                                                    let _e4107 = phi_6787_;
                                                                    let _e4109 = phi_6788_;
                                                                    phi_6677_ = _e4107;
                                                                    phi_6679_ = _e4109;
                                                                } else {
                                                                    phi_6677_ = f32();
                                                                    phi_6679_ = f32();
                                                                }
                                                                let _e4111 = phi_6677_;
                                                                let _e4113 = phi_6679_;
                                                                continue;
                                                                continuing {
                                                                    phi_6673_ = type_9(select(_e4047.member, (_e4047.member + 1u), _e4054), select(_e4047.member_1, _e4047.member_1, _e4054));
                                                                    phi_6676_ = _e4111;
                                                                    phi_6678_ = _e4113;
                                                                    break if !(_e4067);
                                                                }
                                                            }
                                                            let _e4116 = local_37;
                                                            let _e4118 = local_38;
                                                            let _e4122 = local_39;
                                                            let _e4123 = (_e4122 + ((_e4116 - _e4118) * 0.5f));
                                                            if (_e4123 > _e1329) {
                                                                if (_e4123 <= _e4045) {
                                                                    let _e4128 = local_2.member[0u];
                                                                    let _e4131 = local_2.member_1[0u];
                                                                    let _e4134 = local_2.member[0u];
                                                                    let _e4140 = local_2.member_2[0u];
                                                                    if (((_e4128 + ((_e4131 - _e4134) * _e4123)) - _e4140) > 0f) {
                                                                        let _e4145 = local_2.member[1u];
                                                                        let _e4148 = local_2.member_1[1u];
                                                                        let _e4151 = local_2.member[1u];
                                                                        let _e4157 = local_2.member_2[1u];
                                                                        if (((_e4145 + ((_e4148 - _e4151) * _e4123)) - _e4157) > 0f) {
                                                                            let _e4162 = local_2.member[2u];
                                                                            let _e4165 = local_2.member_1[2u];
                                                                            let _e4168 = local_2.member[2u];
                                                                            let _e4174 = local_2.member_2[2u];
                                                                            if (((_e4162 + ((_e4165 - _e4168) * _e4123)) - _e4174) > 0f) {
                                                                                let _e4179 = local_2.member[3u];
                                                                                let _e4182 = local_2.member_1[3u];
                                                                                let _e4185 = local_2.member[3u];
                                                                                let _e4191 = local_2.member_2[3u];
                                                                                phi_6949_ = (((_e4179 + ((_e4182 - _e4185) * _e4123)) - _e4191) > 0f);
                                                                                phi_6950_ = false;
                                                                            } else {
                                                                                phi_6949_ = bool();
                                                                                phi_6950_ = true;
                                                                            }
                                                                            let _e4195 = phi_6949_;
                                                                            let _e4197 = phi_6950_;
                                                                            phi_6951_ = _e4195;
                                                                            phi_6952_ = _e4197;
                                                                        } else {
                                                                            phi_6951_ = bool();
                                                                            phi_6952_ = true;
                                                                        }
                                                                        let _e4199 = phi_6951_;
                                                                        let _e4201 = phi_6952_;
                                                                        phi_6953_ = _e4199;
                                                                        phi_6954_ = _e4201;
                                                                    } else {
                                                                        phi_6953_ = bool();
                                                                        phi_6954_ = true;
                                                                    }
                                                                    let _e4203 = phi_6953_;
                                                                    let _e4205 = phi_6954_;
                                                                    phi_6963_ = select(true, false, select(_e4203, false, _e4205));
                                                                } else {
                                                                    phi_6963_ = true;
                                                                }
                                                                let _e4209 = phi_6963_;
                                                                phi_6964_ = _e4209;
                                                            } else {
                                                                phi_6964_ = true;
                                                            }
                                                            let _e4211 = phi_6964_;
                                                            phi_6971_ = type_36(2u, _e4045, select(_e4123, 2f, _e4211));
                                                            phi_6972_ = type_36();
                                                            phi_6973_ = false;
                                                        } else {
                                                            phi_6971_ = type_36();
                                                            phi_6972_ = type_36(0u, _e1329, 2f);
                                                            phi_6973_ = true;
                                                        }
                                                        let _e4215 = phi_6971_;
                                                        let _e4217 = phi_6972_;
                                                        let _e4219 = phi_6973_;
                                                        phi_6974_ = _e4215;
                                                        phi_6975_ = _e4217;
                                                        phi_6976_ = _e4219;
                                                    } else {
                                                        phi_6974_ = type_36();
                                                        phi_6975_ = _e4034;
                                                        phi_6976_ = true;
                                                    }
                                                    let _e4221 = phi_6974_;
                                                    let _e4223 = phi_6975_;
                                                    let _e4225 = phi_6976_;
                                                    phi_6981_ = _e4223;
                                                    phi_6982_ = _e4221;
                                                    phi_6983_ = _e4225;
                                                } else {
                                                    phi_6981_ = type_36(0u, _e1329, 2f);
                                                    phi_6982_ = type_36();
                                                    phi_6983_ = true;
                                                }
                                                let _e4227 = phi_6981_;
                                                let _e4229 = phi_6982_;
                                                let _e4231 = phi_6983_;
                                                phi_6987_ = _e4227;
                                                phi_6988_ = _e4229;
                                                phi_6989_ = false;
                                                phi_6990_ = _e4231;
                                            } else {
                                                phi_6987_ = type_36();
                                                phi_6988_ = type_36();
                                                phi_6989_ = true;
                                                phi_6990_ = false;
                                            }
                                            let _e4233 = phi_6987_;
                                            let _e4235 = phi_6988_;
                                            let _e4237 = phi_6989_;
                                            let _e4239 = phi_6990_;
                                            phi_6991_ = _e4233;
                                            phi_6992_ = _e4235;
                                            phi_6993_ = _e4237;
                                            phi_6994_ = _e4239;
                                        } else {
                                            phi_6991_ = type_36();
                                            phi_6992_ = type_36();
                                            phi_6993_ = true;
                                            phi_6994_ = false;
                                        }
                                        let _e4241 = phi_6991_;
                                        let _e4243 = phi_6992_;
                                        let _e4245 = phi_6993_;
                                        let _e4247 = phi_6994_;
                                        let _e4254 = select(_e4247, true, _e4245);
                                        let _e4256 = select(_e4243.member, select(_e4241.member, 0u, _e4245), _e4254);
                                        let _e4260 = select(_e4243.member_2, select(_e4241.member_2, 2f, _e4245), _e4254);
                                        if select(false, _e380, ((_e390 & 64u) != 0u)) {
                                            let _e4262 = (_e4256 == 2u);
                                            let _e4263 = (_e4260 <= _e388);
                                            phi_7028_ = select(f32(), select(f32(), _e4260, _e4263), _e4262);
                                            phi_7029_ = select(f32(), select(f32(), _e4260, _e4263), _e4262);
                                            phi_7030_ = select(false, _e4263, _e4262);
                                            phi_7031_ = select(false, select(true, false, _e4263), _e4262);
                                            phi_7032_ = select(true, false, _e4262);
                                        } else {
                                            phi_7028_ = f32();
                                            phi_7029_ = f32();
                                            phi_7030_ = false;
                                            phi_7031_ = false;
                                            phi_7032_ = true;
                                        }
                                        let _e4273 = phi_7028_;
                                        let _e4275 = phi_7029_;
                                        let _e4277 = phi_7030_;
                                        let _e4279 = phi_7031_;
                                        let _e4281 = phi_7032_;
                                        phi_7033_ = _e4273;
                                        phi_7034_ = _e4256;
                                        phi_7035_ = _e4275;
                                        phi_7036_ = type_36(_e4256, select(_e4243.member_1, select(_e4241.member_1, _e1329, _e4245), _e4254), _e4260);
                                        phi_7037_ = _e4256;
                                        phi_7038_ = _e4256;
                                        phi_7039_ = _e4277;
                                        phi_7040_ = _e4279;
                                        phi_7041_ = _e4281;
                                    }
                                    let _e4283 = phi_7033_;
                                    let _e4285 = phi_7034_;
                                    let _e4287 = phi_7035_;
                                    let _e4289 = phi_7036_;
                                    let _e4291 = phi_7037_;
                                    let _e4293 = phi_7038_;
                                    let _e4295 = phi_7039_;
                                    let _e4297 = phi_7040_;
                                    let _e4299 = phi_7041_;
                                    phi_7042_ = _e4283;
                                    phi_7043_ = _e4285;
                                    phi_7044_ = _e4287;
                                    phi_7045_ = _e4289;
                                    phi_7046_ = _e4291;
                                    phi_7047_ = _e4293;
                                    phi_7048_ = _e4295;
                                    phi_7049_ = _e2975;
                                    phi_7050_ = _e4297;
                                    phi_7051_ = _e4299;
                                    phi_7052_ = false;
                                } else {
                                    phi_7042_ = f32();
                                    phi_7043_ = u32();
                                    phi_7044_ = f32();
                                    phi_7045_ = type_36();
                                    phi_7046_ = u32();
                                    phi_7047_ = u32();
                                    phi_7048_ = false;
                                    phi_7049_ = false;
                                    phi_7050_ = false;
                                    phi_7051_ = false;
                                    phi_7052_ = true;
                                }
                                let _e4301 = phi_7042_;
                                let _e4303 = phi_7043_;
                                let _e4305 = phi_7044_;
                                let _e4307 = phi_7045_;
                                let _e4309 = phi_7046_;
                                let _e4311 = phi_7047_;
                                let _e4313 = phi_7048_;
                                let _e4315 = phi_7049_;
                                let _e4317 = phi_7050_;
                                let _e4319 = phi_7051_;
                                let _e4321 = phi_7052_;
                                phi_7053_ = _e2972;
                                phi_2128_ = _e4301;
                                phi_2130_ = _e4303;
                                phi_2132_ = _e4305;
                                phi_7054_ = _e4307;
                                phi_7055_ = _e4309;
                                phi_7056_ = _e2972;
                                phi_7057_ = _e4311;
                                phi_7058_ = _e4313;
                                phi_7059_ = _e4315;
                                phi_7060_ = _e4317;
                                phi_7061_ = _e4319;
                                phi_7062_ = false;
                                phi_7063_ = _e4321;
                            } else {
                                phi_7053_ = f32();
                                phi_2128_ = f32();
                                phi_2130_ = u32();
                                phi_2132_ = f32();
                                phi_7054_ = type_36();
                                phi_7055_ = u32();
                                phi_7056_ = f32();
                                phi_7057_ = u32();
                                phi_7058_ = false;
                                phi_7059_ = false;
                                phi_7060_ = false;
                                phi_7061_ = false;
                                phi_7062_ = true;
                                phi_7063_ = false;
                            }
                            let _e4323 = phi_7053_;
                            let _e4325 = phi_2128_;
                            let _e4327 = phi_2130_;
                            let _e4329 = phi_2132_;
                            let _e4331 = phi_7054_;
                            let _e4333 = phi_7055_;
                            let _e4335 = phi_7056_;
                            let _e4337 = phi_7057_;
                            let _e4339 = phi_7058_;
                            let _e4341 = phi_7059_;
                            let _e4343 = phi_7060_;
                            let _e4345 = phi_7061_;
                            let _e4347 = phi_7062_;
                            let _e4349 = phi_7063_;
                            local_40 = _e4341;
                            local_41 = _e4343;
                            local_42 = _e4341;
                            local_43 = _e4345;
                            local_44 = _e4341;
                            local_45 = _e4347;
                            local_46 = _e4341;
                            local_47 = _e4349;
                            local_48 = _e4331;
                            local_49 = _e4331;
                            local_50 = _e4333;
                            local_51 = _e4331;
                            local_61 = _e4341;
                            local_52 = _e4337;
                            local_54 = _e4335;
                            local_55 = _e4323;
                            continue;
                            continuing {
                                phi_2124_ = _e1347;
                                phi_2127_ = _e4325;
                                phi_2129_ = _e4327;
                                phi_2131_ = _e4329;
                                break if !(_e4339);
                            }
                        }
                        let _e4352 = local_40;
                        let _e4354 = local_41;
                        let _e4355 = select(_e4354, false, _e4352);
                        let _e4357 = local_42;
                        let _e4359 = local_43;
                        let _e4362 = local_44;
                        let _e4364 = local_45;
                        let _e4367 = local_46;
                        let _e4369 = local_47;
                        if _e4355 {
                            let _e4372 = local_48;
                            if (_e4372.member_1 >= _e388) {
                                phi_7092_ = type_35(type_34(0u, f32()), 0u);
                            } else {
                                let _e4376 = local_49;
                                let _e4380 = local_50;
                                let _e4383 = local_51;
                                phi_7092_ = type_35(type_34(2u, _e4383.member_1), select(_e4380, 0u, (_e4376.member_1 > _e386)));
                            }
                            let _e4390 = phi_7092_;
                            phi_7093_ = _e4390;
                            phi_7094_ = false;
                            phi_7095_ = false;
                            phi_7096_ = false;
                            phi_7097_ = false;
                        } else {
                            phi_7093_ = type_35();
                            phi_7094_ = select(_e4359, false, _e4357);
                            let _e5279 = local_61;
                            phi_7095_ = _e5279;
                            phi_7096_ = select(_e4364, false, _e4362);
                            phi_7097_ = select(_e4369, false, _e4367);
                        }
                        let _e4392 = phi_7093_;
                        let _e4394 = phi_7094_;
                        let _e4396 = phi_7095_;
                        let _e4398 = phi_7096_;
                        let _e4400 = phi_7097_;
                        let _e4402 = local_52;
                        let _e4404 = local_53;
                        let _e4407 = local_54;
                        let _e4409 = local_55;
                        let _e4411 = select(_e4396, true, _e4394);
                        let _e4416 = local_56;
                        let _e4417 = select(_e4416, select(_e4409, _e4407, _e4394), _e4411);
                        let _e4419 = local_57;
                        let _e4420 = select(_e4419, select(_e4404, _e4402, _e4394), _e4411);
                        if select(select(_e4398, false, _e4394), true, _e4411) {
                            local[0u] = 0.01f;
                            local[1u] = 0f;
                            local[2u] = 0.8f;
                            phi_7129_ = type_9(0u, 3u);
                            loop {
                                let _e4431 = phi_7129_;
                                let _e4434 = (_e4431.member < _e4431.member_1);
                                if (bitcast<i32>(select(0u, 1u, _e4434)) != 0i) {
                                    let _e4449 = local[select(type_9().member_1, _e4431.member, _e4434)];
                                    let _e4451 = (_e4417 + (select(0f, _e384, (_e384 >= (0.000000059604645f * 8f))) * _e4449));
                                    let _e4453 = select(_e388, _e4451, (_e4451 < _e388));
                                    let _e4456 = local_5.member[0u];
                                    let _e4462 = local_5.member[1u];
                                    let _e4478 = local_5.member_1[0u];
                                    let _e4484 = local_5.member_1[1u];
                                    let _e4500 = local_5.member_2[0u];
                                    let _e4506 = local_5.member_2[1u];
                                    let _e4520 = function_3(array<f32, 3>((_e4456[0] + ((_e4462[0] - _e4456[0]) * _e4453)), (_e4456[1] + ((_e4462[1] - _e4456[1]) * _e4453)), (_e4456[2] + ((_e4462[2] - _e4456[2]) * _e4453))), array<f32, 3>((_e4478[0] + ((_e4484[0] - _e4478[0]) * _e4453)), (_e4478[1] + ((_e4484[1] - _e4478[1]) * _e4453)), (_e4478[2] + ((_e4484[2] - _e4478[2]) * _e4453))), array<f32, 3>((_e4500[0] + ((_e4506[0] - _e4500[0]) * _e4453)), (_e4500[1] + ((_e4506[1] - _e4500[1]) * _e4453)), (_e4500[2] + ((_e4506[2] - _e4500[2]) * _e4453))), _e231.member);
                                    let _e4531 = (((_e4520[0] * _e4520[0]) + (_e4520[1] * _e4520[1])) + (_e4520[2] * _e4520[2]));
                                    if (_e4531 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_7361_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4531 > 0f));
                                    } else {
                                        phi_7304_ = type_14(0i, 5i);
                                        phi_7307_ = bitcast<f32>(((bitcast<u32>(_e4531) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4539 = phi_7304_;
                                            let _e4541 = phi_7307_;
                                            local_58 = _e4541;
                                            if (_e4539.member < _e4539.member_1) {
                                                let _e4548 = (_e4539.member + 1i);
                                                phi_7305_ = type_14(select(_e4548, type_15().member_1, select(false, true, ((false == (_e4548 > _e4539.member)) != false))), _e4539.member_1);
                                                phi_7348_ = type_15(1u, _e4539.member);
                                            } else {
                                                phi_7305_ = _e4539;
                                                phi_7348_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e4559 = phi_7305_;
                                            let _e4561 = phi_7348_;
                                            let _e4564 = (bitcast<i32>(_e4561.member) != 0i);
                                            if _e4564 {
                                                phi_7308_ = (0.5f * (_e4541 + (_e4531 / _e4541)));
                                            } else {
                                                phi_7308_ = f32();
                                            }
                                            let _e4569 = phi_7308_;
                                            continue;
                                            continuing {
                                                phi_7304_ = _e4559;
                                                phi_7307_ = _e4569;
                                                break if !(_e4564);
                                            }
                                        }
                                        let _e4574 = local_58;
                                        phi_7361_ = (_e4574 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4580 = phi_7361_;
                                    let _e4586 = local_5.member[0u];
                                    let _e4592 = select(_e4586[0], -(_e4586[0]), (_e4586[0] < 0f));
                                    let _e4595 = select(_e4586[1], -(_e4586[1]), (_e4586[1] < 0f));
                                    let _e4597 = select(_e4595, _e4592, (_e4592 > _e4595));
                                    let _e4600 = select(_e4586[2], -(_e4586[2]), (_e4586[2] < 0f));
                                    let _e4602 = select(_e4600, _e4597, (_e4597 > _e4600));
                                    let _e4605 = local_5.member[1u];
                                    let _e4611 = select(_e4605[0], -(_e4605[0]), (_e4605[0] < 0f));
                                    let _e4614 = select(_e4605[1], -(_e4605[1]), (_e4605[1] < 0f));
                                    let _e4616 = select(_e4614, _e4611, (_e4611 > _e4614));
                                    let _e4619 = select(_e4605[2], -(_e4605[2]), (_e4605[2] < 0f));
                                    let _e4621 = select(_e4619, _e4616, (_e4616 > _e4619));
                                    let _e4625 = local_5.member_3;
                                    let _e4629 = local_5.member_1[0u];
                                    let _e4635 = select(_e4629[0], -(_e4629[0]), (_e4629[0] < 0f));
                                    let _e4638 = select(_e4629[1], -(_e4629[1]), (_e4629[1] < 0f));
                                    let _e4640 = select(_e4638, _e4635, (_e4635 > _e4638));
                                    let _e4643 = select(_e4629[2], -(_e4629[2]), (_e4629[2] < 0f));
                                    let _e4645 = select(_e4643, _e4640, (_e4640 > _e4643));
                                    let _e4648 = local_5.member_1[1u];
                                    let _e4654 = select(_e4648[0], -(_e4648[0]), (_e4648[0] < 0f));
                                    let _e4657 = select(_e4648[1], -(_e4648[1]), (_e4648[1] < 0f));
                                    let _e4659 = select(_e4657, _e4654, (_e4654 > _e4657));
                                    let _e4662 = select(_e4648[2], -(_e4648[2]), (_e4648[2] < 0f));
                                    let _e4664 = select(_e4662, _e4659, (_e4659 > _e4662));
                                    let _e4668 = local_5.member_3;
                                    let _e4672 = local_5.member_2[0u];
                                    let _e4678 = select(_e4672[0], -(_e4672[0]), (_e4672[0] < 0f));
                                    let _e4681 = select(_e4672[1], -(_e4672[1]), (_e4672[1] < 0f));
                                    let _e4683 = select(_e4681, _e4678, (_e4678 > _e4681));
                                    let _e4686 = select(_e4672[2], -(_e4672[2]), (_e4672[2] < 0f));
                                    let _e4688 = select(_e4686, _e4683, (_e4683 > _e4686));
                                    let _e4691 = local_5.member_2[1u];
                                    let _e4697 = select(_e4691[0], -(_e4691[0]), (_e4691[0] < 0f));
                                    let _e4700 = select(_e4691[1], -(_e4691[1]), (_e4691[1] < 0f));
                                    let _e4702 = select(_e4700, _e4697, (_e4697 > _e4700));
                                    let _e4705 = select(_e4691[2], -(_e4691[2]), (_e4691[2] < 0f));
                                    let _e4707 = select(_e4705, _e4702, (_e4702 > _e4705));
                                    let _e4711 = local_5.member_3;
                                    let _e4718 = local_5.member_3;
                                    let _e4725 = (((_e4580 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4621, _e4602, (_e4602 > _e4621)) + _e4625) + (select(_e4664, _e4645, (_e4645 > _e4664)) + _e4668)) + (select(_e4707, _e4688, (_e4688 > _e4707)) + _e4711)) * (0.000000059604645f * 16f)) + (_e4718 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e615.member_1);
                                    phi_7632_ = select(true, false, _e4725);
                                    phi_7633_ = _e4725;
                                } else {
                                    phi_7632_ = false;
                                    phi_7633_ = false;
                                }
                                let _e4728 = phi_7632_;
                                let _e4730 = phi_7633_;
                                local_59 = _e4730;
                                continue;
                                continuing {
                                    phi_7129_ = type_9(select(_e4431.member, (_e4431.member + 1u), _e4434), select(_e4431.member_1, _e4431.member_1, _e4434));
                                    break if !(_e4728);
                                }
                            }
                            let _e4733 = local_59;
                            if _e4733 {
                                phi_7645_ = type_35(type_34(1u, _e4417), select(_e4420, 1u, (_e4417 > _e386)));
                                phi_7646_ = false;
                            } else {
                                phi_7645_ = type_35();
                                phi_7646_ = true;
                            }
                            let _e4739 = phi_7645_;
                            let _e4741 = phi_7646_;
                            if _e4741 {
                                phi_7658_ = type_35(type_34(2u, _e4417), select(_e4420, 0u, (_e4417 > _e386)));
                            } else {
                                phi_7658_ = _e4739;
                            }
                            let _e4747 = phi_7658_;
                            phi_7659_ = _e4747;
                            phi_7660_ = false;
                            phi_7661_ = false;
                        } else {
                            phi_7659_ = type_35();
                            phi_7660_ = select(select(_e4400, false, _e4394), false, _e4411);
                            phi_7661_ = select(select(_e4355, false, _e4394), false, _e4411);
                        }
                        let _e4749 = phi_7659_;
                        let _e4751 = phi_7660_;
                        let _e4753 = phi_7661_;
                        if _e4751 {
                            phi_7668_ = type_35(type_34(0u, f32()), 0u);
                            phi_7669_ = true;
                        } else {
                            phi_7668_ = _e4392;
                            phi_7669_ = _e4753;
                        }
                        let _e4757 = phi_7668_;
                        let _e4759 = phi_7669_;
                        phi_7673_ = _e4757;
                        phi_7674_ = _e4749;
                        phi_7675_ = _e4759;
                    } else {
                        phi_7673_ = _e1319;
                        phi_7674_ = type_35();
                        phi_7675_ = true;
                    }
                    let _e4761 = phi_7673_;
                    let _e4763 = phi_7674_;
                    let _e4765 = phi_7675_;
                    if _e4765 {
                        phi_7679_ = _e4761;
                    } else {
                        phi_7679_ = _e4763;
                    }
                    let _e4767 = phi_7679_;
                    switch bitcast<i32>(_e4767.member.member) {
                        case 0: {
                            phi_7697_ = type_32(0u, _e4767.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e4778 = function_(_e4767.member.member_1);
                            phi_7697_ = type_32(0u, _e4767.member_1, _e4778, true);
                            break;
                        }
                        case 2: {
                            let _e4774 = function_(_e4767.member.member_1);
                            phi_7697_ = type_32(1u, _e4767.member_1, _e4774, true);
                            break;
                        }
                        default: {
                            phi_7697_ = type_32();
                            break;
                        }
                    }
                    let _e4782 = phi_7697_;
                    let _e4786 = params.member.member.member_12;
                    let _e4787 = bitcast<u32>(_e4786);
                    if (_e4782.member_2[0] == select((_e4787 << bitcast<u32>(29i)), 0u, ((_e4787 & 2147483647u) < 8388608u))) {
                        let _e4797 = params.member.member.member_12;
                        let _e4798 = bitcast<u32>(_e4797);
                        let _e4799 = (_e4798 & 2147483647u);
                        phi_7737_ = (_e4782.member_2[1] == select(((_e4798 ^ _e4799) | ((_e4799 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4799 < 8388608u)));
                    } else {
                        phi_7737_ = false;
                    }
                    let _e4809 = phi_7737_;
                    let _e4811 = params.member.member.member_1;
                    if ((_e4811 & 128u) != 0u) {
                        phi_7753_ = true;
                    } else {
                        let _e4815 = params.member.member.member_1;
                        phi_7753_ = select(false, _e4809, ((_e4815 & 64u) != 0u));
                    }
                    let _e4820 = phi_7753_;
                    phi_7772_ = type_32(select(1u, _e4782.member, select(true, select(true, false, _e4820), _e4782.member_3)), _e4782.member_1, _e4782.member_2, _e4782.member_3);
                }
                let _e4831 = phi_7772_;
                phi_7773_ = _e4831;
                phi_7774_ = type_9(_e190, _e189);
            } else {
                phi_7773_ = type_32(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_7774_ = type_9(0u, 0u);
            }
            let _e4833 = phi_7773_;
            let _e4835 = phi_7774_;
            let _e4839 = (_e4833.member != 0u);
            let _e4842 = select(false, !(_e4839), _e4833.member_3);
            if _e4842 {
                let _e4846 = (_e4833.member_2[1] >> bitcast<u32>(20i));
                if (_e4846 <= 896u) {
                    phi_7804_ = 0u;
                } else {
                    phi_7804_ = ((((_e4846 - 896u) << bitcast<u32>(23i)) | ((_e4833.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4833.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e4861 = phi_7804_;
                let _e4863 = atomicMin((&earliest.member[0u]), _e4861);
            }
            let _e4866 = params.member.member.member_1;
            if ((_e4866 & 16u) != 0u) {
                if (_e103 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4842 {
                    let _e4872 = atomicAdd((&counters[0u]), 1u);
                    phi_7826_ = _e4872;
                } else {
                    phi_7826_ = 0u;
                }
                let _e4874 = phi_7826_;
                workgroupBarrier();
                if (_e103 == 0u) {
                    let _e4877 = atomicLoad((&counters[0u]));
                    if (_e4877 > 0u) {
                        let _e4880 = atomicAdd((&contacts.member[0u]), _e4877);
                        atomicStore((&counters[1u]), _e4880);
                    }
                }
                workgroupBarrier();
                let _e4883 = atomicLoad((&counters[1u]));
                let _e4884 = (_e4883 + _e4874);
                if _e4842 {
                    let _e4887 = params.member.member_1.member_3;
                    if (_e4884 < _e4887) {
                        let _e4893 = (7u * _e4884);
                        atomicStore((&contacts.member[(4u + _e4893)]), select(1u, 0u, ((_e4835.member_1 & 2147483648u) == 0u)));
                        atomicStore((&contacts.member[(_e4893 + 5u)]), _e4833.member);
                        atomicStore((&contacts.member[(_e4893 + 6u)]), _e4835.member);
                        atomicStore((&contacts.member[(_e4893 + 7u)]), (_e4835.member_1 & 2147483647u));
                        atomicStore((&contacts.member[(_e4893 + 8u)]), _e4833.member_2[0]);
                        atomicStore((&contacts.member[(_e4893 + 9u)]), _e4833.member_2[1]);
                        atomicStore((&contacts.member[(_e4893 + 10u)]), _e4833.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e103 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4839 {
                let _e4917 = atomicAdd((&counters[0u]), 1u);
                phi_7903_ = _e4917;
            } else {
                phi_7903_ = 0u;
            }
            let _e4919 = phi_7903_;
            workgroupBarrier();
            if (_e103 == 0u) {
                let _e4922 = atomicLoad((&counters[0u]));
                if (_e4922 > 0u) {
                    let _e4925 = atomicAdd((&undecided.member[0u]), _e4922);
                    atomicStore((&counters[1u]), _e4925);
                }
            }
            workgroupBarrier();
            let _e4928 = atomicLoad((&counters[1u]));
            let _e4929 = (_e4928 + _e4919);
            if _e4839 {
                let _e4931 = params.member.member_2.member;
                if (_e4929 < _e4931) {
                    let _e4933 = (2u * _e4929);
                    atomicStore((&undecided.member[(4u + _e4933)]), _e4835.member);
                    atomicStore((&undecided.member[(_e4933 + 5u)]), _e4835.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_280_ = type_9(select(_e157.member, (_e157.member + 1u), _e160), select(_e157.member_1, _e157.member_1, _e160));
            break if !(_e173);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
