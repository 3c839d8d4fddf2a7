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
    var phi_8408_: array<array<f32, 3>, 4>;

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
        phi_8408_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8408_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8408_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8036_: bool;
    var phi_8069_: array<f32, 3>;
    var phi_8070_: bool;
    var phi_8071_: array<f32, 3>;
    var phi_8072_: bool;
    var phi_8077_: array<f32, 3>;

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
        phi_8036_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8036_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8036_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8069_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8070_ = false;
        } else {
            phi_8069_ = array<f32, 3>();
            phi_8070_ = true;
        }
        let _e129 = phi_8069_;
        let _e131 = phi_8070_;
        phi_8071_ = _e129;
        phi_8072_ = _e131;
    } else {
        phi_8071_ = array<f32, 3>();
        phi_8072_ = true;
    }
    let _e133 = phi_8071_;
    let _e135 = phi_8072_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8077_ = _e136;
    } else {
        phi_8077_ = _e133;
    }
    let _e138 = phi_8077_;
    return _e138;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_30;
    var local_2: type_31;
    var local_3: type_31;
    var local_4: type_31;
    var local_5: type_28;
    var local_6: type_32;
    var phi_236_: u32;
    var phi_281_: u32;
    var phi_284_: type_9;
    var phi_458_: type_22;
    var phi_593_: type_28;
    var phi_622_: bool;
    var phi_870_: bool;
    var phi_964_: type_33;
    var phi_965_: bool;
    var phi_966_: type_33;
    var phi_967_: bool;
    var phi_968_: type_33;
    var phi_969_: bool;
    var phi_974_: type_33;
    var phi_1144_: type_14;
    var phi_1147_: f32;
    var phi_1145_: type_14;
    var phi_1188_: type_15;
    var phi_1148_: f32;
    var local_7: f32;
    var phi_1201_: f32;
    var phi_2110_: type_35;
    var phi_2111_: bool;
    var phi_2112_: type_35;
    var phi_2113_: bool;
    var phi_2119_: type_14;
    var phi_2122_: f32;
    var phi_2124_: u32;
    var phi_2126_: f32;
    var phi_2120_: type_14;
    var phi_2167_: type_15;
    var phi_2604_: type_9;
    var phi_2607_: f32;
    var phi_2609_: f32;
    var phi_2611_: f32;
    var phi_2613_: f32;
    var phi_2615_: bool;
    var phi_2617_: u32;
    var phi_2768_: array<f32, 3>;
    var phi_2834_: type_14;
    var phi_2837_: f32;
    var phi_2835_: type_14;
    var phi_2878_: type_15;
    var phi_2838_: f32;
    var local_8: f32;
    var phi_2891_: f32;
    var phi_3014_: type_31;
    var phi_3015_: bool;
    var phi_3016_: type_31;
    var phi_3017_: bool;
    var phi_3025_: type_31;
    var phi_3196_: bool;
    var phi_3197_: bool;
    var phi_3198_: bool;
    var phi_3199_: bool;
    var phi_3200_: bool;
    var phi_3201_: bool;
    var phi_3502_: bool;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3505_: bool;
    var phi_3506_: bool;
    var phi_3507_: bool;
    var phi_3515_: bool;
    var phi_3622_: f32;
    var phi_3623_: bool;
    var phi_3624_: f32;
    var phi_3625_: bool;
    var phi_3626_: f32;
    var phi_3627_: bool;
    var phi_3628_: bool;
    var phi_3690_: f32;
    var phi_3691_: bool;
    var phi_3692_: f32;
    var phi_3693_: bool;
    var phi_3694_: f32;
    var phi_3695_: bool;
    var phi_3696_: bool;
    var phi_3763_: f32;
    var phi_3764_: bool;
    var phi_3765_: f32;
    var phi_3766_: bool;
    var phi_3767_: f32;
    var phi_3768_: bool;
    var phi_3769_: bool;
    var phi_3831_: f32;
    var phi_3832_: bool;
    var phi_3833_: f32;
    var phi_3834_: bool;
    var phi_3835_: f32;
    var phi_3836_: bool;
    var phi_3837_: bool;
    var phi_4011_: type_14;
    var phi_4014_: f32;
    var phi_4012_: type_14;
    var phi_4055_: type_15;
    var phi_4015_: f32;
    var local_9: f32;
    var phi_4068_: f32;
    var phi_4339_: bool;
    var phi_4340_: bool;
    var phi_4366_: f32;
    var phi_4367_: f32;
    var phi_4368_: bool;
    var phi_4369_: bool;
    var phi_4370_: f32;
    var phi_4371_: f32;
    var phi_4372_: f32;
    var phi_4373_: f32;
    var phi_4374_: bool;
    var phi_4375_: bool;
    var phi_4376_: bool;
    var phi_4377_: bool;
    var phi_4378_: f32;
    var phi_4379_: f32;
    var phi_4380_: f32;
    var phi_4381_: f32;
    var phi_4382_: bool;
    var phi_4383_: bool;
    var phi_4384_: bool;
    var phi_4385_: bool;
    var phi_4386_: bool;
    var phi_4387_: f32;
    var phi_4388_: f32;
    var phi_4389_: f32;
    var phi_4390_: f32;
    var phi_4391_: bool;
    var phi_4392_: bool;
    var phi_4393_: bool;
    var phi_4394_: bool;
    var phi_4395_: bool;
    var phi_4728_: f32;
    var phi_4730_: u32;
    var phi_4731_: f32;
    var phi_4732_: bool;
    var phi_4733_: bool;
    var phi_4734_: bool;
    var phi_4735_: u32;
    var phi_4736_: f32;
    var phi_4737_: f32;
    var phi_4738_: f32;
    var phi_4739_: f32;
    var phi_4740_: bool;
    var phi_4741_: u32;
    var phi_4742_: bool;
    var phi_4743_: bool;
    var phi_4744_: bool;
    var phi_4745_: bool;
    var phi_4746_: bool;
    var phi_4747_: bool;
    var phi_4775_: f32;
    var phi_4776_: f32;
    var phi_4777_: f32;
    var phi_4778_: f32;
    var phi_4779_: bool;
    var phi_4780_: u32;
    var phi_4781_: bool;
    var phi_4782_: bool;
    var phi_4783_: bool;
    var phi_4784_: bool;
    var phi_4785_: bool;
    var phi_4786_: bool;
    var phi_2608_: f32;
    var phi_2610_: f32;
    var phi_2612_: f32;
    var phi_2614_: f32;
    var phi_2616_: bool;
    var phi_2618_: u32;
    var phi_4787_: f32;
    var phi_4788_: f32;
    var phi_4789_: bool;
    var phi_4790_: bool;
    var phi_4791_: bool;
    var phi_4792_: bool;
    var phi_4793_: bool;
    var phi_4794_: bool;
    var phi_4795_: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: f32;
    var local_21: bool;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_4862_: f32;
    var phi_4863_: bool;
    var phi_5483_: type_14;
    var phi_5486_: f32;
    var phi_5484_: type_14;
    var phi_5527_: type_15;
    var phi_5487_: f32;
    var local_25: f32;
    var phi_5540_: f32;
    var phi_5775_: type_14;
    var phi_5778_: f32;
    var phi_5776_: type_14;
    var phi_5819_: type_15;
    var phi_5779_: f32;
    var local_26: f32;
    var phi_5832_: f32;
    var phi_5864_: type_14;
    var phi_5867_: f32;
    var phi_5865_: type_14;
    var phi_5908_: type_15;
    var phi_5868_: f32;
    var local_27: f32;
    var phi_5921_: f32;
    var phi_6229_: type_9;
    var phi_6232_: f32;
    var phi_6233_: f32;
    var local_28: f32;
    var local_29: f32;
    var phi_6331_: type_14;
    var phi_6334_: f32;
    var phi_6332_: type_14;
    var phi_6375_: type_15;
    var phi_6335_: f32;
    var local_30: f32;
    var phi_6388_: f32;
    var phi_6393_: type_9;
    var phi_6396_: f32;
    var phi_6398_: bool;
    var phi_6400_: bool;
    var phi_6630_: f32;
    var phi_6631_: f32;
    var phi_6397_: f32;
    var phi_6399_: bool;
    var phi_6401_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_6646_: type_36;
    var phi_6647_: bool;
    var local_37: bool;
    var phi_6668_: type_9;
    var phi_6671_: f32;
    var phi_6673_: f32;
    var phi_6780_: f32;
    var phi_6781_: f32;
    var phi_6782_: f32;
    var phi_6783_: f32;
    var phi_6672_: f32;
    var phi_6674_: f32;
    var local_38: f32;
    var local_39: f32;
    var local_40: f32;
    var phi_6944_: bool;
    var phi_6945_: bool;
    var phi_6946_: bool;
    var phi_6947_: bool;
    var phi_6948_: bool;
    var phi_6949_: bool;
    var phi_6958_: bool;
    var phi_6959_: bool;
    var phi_6966_: type_36;
    var phi_6967_: type_36;
    var phi_6968_: bool;
    var phi_6969_: type_36;
    var phi_6970_: type_36;
    var phi_6971_: bool;
    var phi_6976_: type_36;
    var phi_6977_: type_36;
    var phi_6978_: bool;
    var phi_6982_: type_36;
    var phi_6983_: type_36;
    var phi_6984_: bool;
    var phi_6985_: bool;
    var phi_6986_: type_36;
    var phi_6987_: type_36;
    var phi_6988_: bool;
    var phi_6989_: bool;
    var phi_7023_: f32;
    var phi_7024_: f32;
    var phi_7025_: bool;
    var phi_7026_: bool;
    var phi_7027_: bool;
    var phi_7028_: f32;
    var phi_7029_: u32;
    var phi_7030_: f32;
    var phi_7031_: type_36;
    var phi_7032_: u32;
    var phi_7033_: u32;
    var phi_7034_: bool;
    var phi_7035_: bool;
    var phi_7036_: bool;
    var phi_7037_: f32;
    var phi_7038_: u32;
    var phi_7039_: f32;
    var phi_7040_: type_36;
    var phi_7041_: u32;
    var phi_7042_: u32;
    var phi_7043_: bool;
    var phi_7044_: bool;
    var phi_7045_: bool;
    var phi_7046_: bool;
    var phi_7047_: bool;
    var phi_7048_: f32;
    var phi_2123_: f32;
    var phi_2125_: u32;
    var phi_2127_: f32;
    var phi_7049_: type_36;
    var phi_7050_: u32;
    var phi_7051_: f32;
    var phi_7052_: u32;
    var phi_7053_: bool;
    var phi_7054_: bool;
    var phi_7055_: bool;
    var phi_7056_: bool;
    var phi_7057_: bool;
    var phi_7058_: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: type_36;
    var local_50: type_36;
    var local_51: u32;
    var local_52: type_36;
    var phi_7087_: type_35;
    var phi_7088_: type_35;
    var phi_7089_: bool;
    var phi_7090_: bool;
    var phi_7091_: bool;
    var phi_7092_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;
    var local_58: u32;
    var phi_7124_: type_9;
    var phi_7299_: type_14;
    var phi_7302_: f32;
    var phi_7300_: type_14;
    var phi_7343_: type_15;
    var phi_7303_: f32;
    var local_59: f32;
    var phi_7356_: f32;
    var phi_7627_: bool;
    var phi_7628_: bool;
    var local_60: bool;
    var phi_7640_: type_35;
    var phi_7641_: bool;
    var phi_7653_: type_35;
    var phi_7654_: type_35;
    var phi_7655_: bool;
    var phi_7656_: bool;
    var phi_7663_: type_35;
    var phi_7664_: bool;
    var phi_7668_: type_35;
    var phi_7669_: type_35;
    var phi_7670_: bool;
    var phi_7674_: type_35;
    var phi_7692_: type_32;
    var phi_7732_: bool;
    var phi_7748_: bool;
    var phi_7775_: type_9;
    var phi_7804_: bool;
    var phi_7805_: bool;
    var phi_7848_: u32;
    var local_61: bool;
    var local_62: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e100 = id_2;
    let _e101 = n_2;
    let _e102 = lane_2;
    let _e113 = ((_e100.y * _e101.x) + _e100.x);
    let _e116 = (_e101.x * _e101.y);
    let _e119 = params.member.member_1.member_2;
    let _e121 = input.member[0u];
    let _e123 = select(_e121, _e119, (_e119 < _e121));
    let _e125 = params.member.member_1.member_1;
    if (_e123 > _e125) {
        let _e128 = params.member.member_1.member_1;
        phi_236_ = (_e123 - _e128);
    } else {
        phi_236_ = 0u;
    }
    let _e131 = phi_236_;
    let _e133 = params.member.member_1.member;
    let _e135 = select(_e131, _e133, (_e133 < _e131));
    let _e136 = (_e135 / 64u);
    let _e140 = select(_e136, (_e136 + 1u), ((_e135 % 64u) > 0u));
    if (_e140 > _e113) {
        let _e142 = (_e140 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e144 = (_e142 / _e116);
        if (_e116 == 0u) {
            return;
        }
        phi_281_ = select(_e144, (_e144 + 1u), ((_e142 % _e116) > 0u));
    } else {
        phi_281_ = 0u;
    }
    let _e151 = phi_281_;
    phi_284_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_284_;
        let _e157 = (_e154.member < _e154.member_1);
        let _e170 = (bitcast<i32>(select(0u, 1u, _e157)) != 0i);
        if _e170 {
            let _e174 = (((_e113 + (select(type_9().member_1, _e154.member, _e157) * _e116)) * 64u) + _e102);
            local_6 = type_32(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e174 < _e135) {
                let _e178 = params.member.member_1.member_1;
                let _e180 = (2u * (_e178 + _e174));
                let _e183 = input.member[(4u + _e180)];
                let _e186 = input.member[(_e180 + 5u)];
                let _e191 = (_e186 & 2147483647u);
                if (select(1u, 0u, ((_e186 & 2147483648u) == 0u)) == 0u) {
                    let _e210 = params.member.member.member[1u];
                    let _e213 = ((2u * _e210) + (3u * _e191));
                    let _e215 = elements.member[_e213];
                    let _e218 = elements.member[(_e213 + 1u)];
                    let _e221 = elements.member[(_e213 + 2u)];
                    phi_458_ = type_22(0u, array<u32, 4>(_e183, _e215, _e218, _e221));
                } else {
                    let _e194 = (2u * _e183);
                    let _e196 = elements.member[_e194];
                    let _e199 = elements.member[(_e194 + 1u)];
                    let _e200 = (2u * _e191);
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    phi_458_ = type_22(1u, array<u32, 4>(_e196, _e199, _e202, _e205));
                }
                let _e225 = phi_458_;
                let _e230 = paths.member[_e225.member_1[0]];
                let _e245 = paths.member[_e225.member_1[1]];
                let _e260 = paths.member[_e225.member_1[2]];
                let _e275 = paths.member[_e225.member_1[3]];
                let _e289 = params.member.member.member_4;
                if (_e225.member != 0u) {
                    phi_593_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e230.member.x), (_e260.member.y - _e230.member.y), (_e260.member.z - _e230.member.z)), array<f32, 3>((_e260.member_1.x - _e230.member_1.x), (_e260.member_1.y - _e230.member_1.y), (_e260.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e245.member.x - _e230.member.x), (_e245.member.y - _e230.member.y), (_e245.member.z - _e230.member.z)), array<f32, 3>((_e245.member_1.x - _e230.member_1.x), (_e245.member_1.y - _e230.member_1.y), (_e245.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e275.member.x), (_e260.member.y - _e275.member.y), (_e260.member.z - _e275.member.z)), array<f32, 3>((_e260.member_1.x - _e275.member_1.x), (_e260.member_1.y - _e275.member_1.y), (_e260.member_1.z - _e275.member_1.z))), (_e289 + _e289));
                } else {
                    phi_593_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e230.member.x - _e245.member.x), (_e230.member.y - _e245.member.y), (_e230.member.z - _e245.member.z)), array<f32, 3>((_e230.member_1.x - _e245.member_1.x), (_e230.member_1.y - _e245.member_1.y), (_e230.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e245.member.x), (_e260.member.y - _e245.member.y), (_e260.member.z - _e245.member.z)), array<f32, 3>((_e260.member_1.x - _e245.member_1.x), (_e260.member_1.y - _e245.member_1.y), (_e260.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e275.member.x - _e245.member.x), (_e275.member.y - _e245.member.y), (_e275.member.z - _e245.member.z)), array<f32, 3>((_e275.member_1.x - _e245.member_1.x), (_e275.member_1.y - _e245.member_1.y), (_e275.member_1.z - _e245.member_1.z))), (_e289 + _e289));
                }
                let _e350 = phi_593_;
                let _e352 = params.member.member.member_12;
                let _e353 = bitcast<u32>(_e352);
                let _e354 = (_e353 & 2147483647u);
                let _e355 = (_e354 < 8388608u);
                let _e367 = params.member.member.member_15[0u];
                if (select((_e353 << bitcast<u32>(29i)), 0u, _e355) == _e367) {
                    let _e371 = params.member.member.member_15[1u];
                    phi_622_ = (select(((_e353 ^ _e354) | ((_e354 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e355) == _e371);
                } else {
                    phi_622_ = false;
                }
                let _e374 = phi_622_;
                let _e376 = params.member.member.member_5;
                let _e378 = params.member.member.member_11;
                let _e380 = params.member.member.member_12;
                let _e382 = params.member.member.member_13;
                let _e384 = params.member.member.member_1;
                let _e393 = select(_e350.member[0][0], -(_e350.member[0][0]), (_e350.member[0][0] < 0f));
                let _e397 = select(_e350.member[0][1], -(_e350.member[0][1]), (_e350.member[0][1] < 0f));
                let _e399 = select(_e397, _e393, (_e393 > _e397));
                let _e403 = select(_e350.member[0][2], -(_e350.member[0][2]), (_e350.member[0][2] < 0f));
                let _e405 = select(_e403, _e399, (_e399 > _e403));
                let _e411 = select(_e350.member[1][0], -(_e350.member[1][0]), (_e350.member[1][0] < 0f));
                let _e415 = select(_e350.member[1][1], -(_e350.member[1][1]), (_e350.member[1][1] < 0f));
                let _e417 = select(_e415, _e411, (_e411 > _e415));
                let _e421 = select(_e350.member[1][2], -(_e350.member[1][2]), (_e350.member[1][2] < 0f));
                let _e423 = select(_e421, _e417, (_e417 > _e421));
                let _e427 = (select(_e423, _e405, (_e405 > _e423)) + _e350.member_3);
                let _e433 = select(_e350.member_1[0][0], -(_e350.member_1[0][0]), (_e350.member_1[0][0] < 0f));
                let _e437 = select(_e350.member_1[0][1], -(_e350.member_1[0][1]), (_e350.member_1[0][1] < 0f));
                let _e439 = select(_e437, _e433, (_e433 > _e437));
                let _e443 = select(_e350.member_1[0][2], -(_e350.member_1[0][2]), (_e350.member_1[0][2] < 0f));
                let _e445 = select(_e443, _e439, (_e439 > _e443));
                let _e451 = select(_e350.member_1[1][0], -(_e350.member_1[1][0]), (_e350.member_1[1][0] < 0f));
                let _e455 = select(_e350.member_1[1][1], -(_e350.member_1[1][1]), (_e350.member_1[1][1] < 0f));
                let _e457 = select(_e455, _e451, (_e451 > _e455));
                let _e461 = select(_e350.member_1[1][2], -(_e350.member_1[1][2]), (_e350.member_1[1][2] < 0f));
                let _e463 = select(_e461, _e457, (_e457 > _e461));
                let _e467 = (select(_e463, _e445, (_e445 > _e463)) + _e350.member_3);
                let _e473 = select(_e350.member_2[0][0], -(_e350.member_2[0][0]), (_e350.member_2[0][0] < 0f));
                let _e477 = select(_e350.member_2[0][1], -(_e350.member_2[0][1]), (_e350.member_2[0][1] < 0f));
                let _e479 = select(_e477, _e473, (_e473 > _e477));
                let _e483 = select(_e350.member_2[0][2], -(_e350.member_2[0][2]), (_e350.member_2[0][2] < 0f));
                let _e485 = select(_e483, _e479, (_e479 > _e483));
                let _e491 = select(_e350.member_2[1][0], -(_e350.member_2[1][0]), (_e350.member_2[1][0] < 0f));
                let _e495 = select(_e350.member_2[1][1], -(_e350.member_2[1][1]), (_e350.member_2[1][1] < 0f));
                let _e497 = select(_e495, _e491, (_e491 > _e495));
                let _e501 = select(_e350.member_2[1][2], -(_e350.member_2[1][2]), (_e350.member_2[1][2] < 0f));
                let _e503 = select(_e501, _e497, (_e497 > _e501));
                let _e507 = (select(_e503, _e485, (_e485 > _e503)) + _e350.member_3);
                let _e509 = select(_e467, _e427, (_e427 > _e467));
                let _e511 = select(_e507, _e509, (_e509 > _e507));
                if (_e511 <= 65536f) {
                    phi_870_ = (_e511 >= (1f / 65536f));
                } else {
                    phi_870_ = false;
                }
                let _e516 = phi_870_;
                if _e516 {
                    phi_968_ = type_33();
                    phi_969_ = true;
                } else {
                    if (_e511 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e511) & 2139095040u) != 2139095040u) {
                            let _e523 = (2130706432u - (bitcast<u32>(_e511) & 2139095040u));
                            let _e526 = bitcast<f32>(select(8388608u, _e523, (_e523 > 8388608u)));
                            let _e527 = (_e376 * _e526);
                            phi_964_ = type_33(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e350.member[0][0] * _e526), (_e350.member[0][1] * _e526), (_e350.member[0][2] * _e526)), array<f32, 3>((_e350.member[1][0] * _e526), (_e350.member[1][1] * _e526), (_e350.member[1][2] * _e526))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_1[0][0] * _e526), (_e350.member_1[0][1] * _e526), (_e350.member_1[0][2] * _e526)), array<f32, 3>((_e350.member_1[1][0] * _e526), (_e350.member_1[1][1] * _e526), (_e350.member_1[1][2] * _e526))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_2[0][0] * _e526), (_e350.member_2[0][1] * _e526), (_e350.member_2[0][2] * _e526)), array<f32, 3>((_e350.member_2[1][0] * _e526), (_e350.member_2[1][1] * _e526), (_e350.member_2[1][2] * _e526))), ((_e350.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e526)), select(_e527, select(0.000000000000000000000000000000000000011754944f, _e527, (_e527 > 0.000000000000000000000000000000000000011754944f)), (_e376 > 0f)));
                            phi_965_ = false;
                        } else {
                            phi_964_ = type_33();
                            phi_965_ = true;
                        }
                        let _e596 = phi_964_;
                        let _e598 = phi_965_;
                        phi_966_ = _e596;
                        phi_967_ = _e598;
                    } else {
                        phi_966_ = type_33();
                        phi_967_ = true;
                    }
                    let _e600 = phi_966_;
                    let _e602 = phi_967_;
                    phi_968_ = _e600;
                    phi_969_ = _e602;
                }
                let _e604 = phi_968_;
                let _e606 = phi_969_;
                if _e606 {
                    phi_974_ = type_33(_e350, _e376);
                } else {
                    phi_974_ = _e604;
                }
                let _e609 = phi_974_;
                local_5 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e609.member.member[0][0], _e609.member.member[0][1], _e609.member.member[0][2]), array<f32, 3>(_e609.member.member[1][0], _e609.member.member[1][1], _e609.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e609.member.member_1[0][0], _e609.member.member_1[0][1], _e609.member.member_1[0][2]), array<f32, 3>(_e609.member.member_1[1][0], _e609.member.member_1[1][1], _e609.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e609.member.member_2[0][0], _e609.member.member_2[0][1], _e609.member.member_2[0][2]), array<f32, 3>(_e609.member.member_2[1][0], _e609.member.member_2[1][1], _e609.member.member_2[1][2])), _e609.member.member_3);
                let _e652 = local_5.member[0u];
                let _e658 = local_5.member[1u];
                let _e674 = local_5.member_1[0u];
                let _e680 = local_5.member_1[1u];
                let _e696 = local_5.member_2[0u];
                let _e702 = local_5.member_2[1u];
                let _e716 = function_3(array<f32, 3>((_e652[0] + ((_e658[0] - _e652[0]) * _e380)), (_e652[1] + ((_e658[1] - _e652[1]) * _e380)), (_e652[2] + ((_e658[2] - _e652[2]) * _e380))), array<f32, 3>((_e674[0] + ((_e680[0] - _e674[0]) * _e380)), (_e674[1] + ((_e680[1] - _e674[1]) * _e380)), (_e674[2] + ((_e680[2] - _e674[2]) * _e380))), array<f32, 3>((_e696[0] + ((_e702[0] - _e696[0]) * _e380)), (_e696[1] + ((_e702[1] - _e696[1]) * _e380)), (_e696[2] + ((_e702[2] - _e696[2]) * _e380))), _e225.member);
                let _e727 = (((_e716[0] * _e716[0]) + (_e716[1] * _e716[1])) + (_e716[2] * _e716[2]));
                if (_e727 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1201_ = select(0f, (0.000000000000000000106433627f * 2f), (_e727 > 0f));
                } else {
                    phi_1144_ = type_14(0i, 5i);
                    phi_1147_ = bitcast<f32>(((bitcast<u32>(_e727) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e735 = phi_1144_;
                        let _e737 = phi_1147_;
                        local_7 = _e737;
                        if (_e735.member < _e735.member_1) {
                            let _e744 = (_e735.member + 1i);
                            phi_1145_ = type_14(select(_e744, type_15().member_1, select(false, true, ((false == (_e744 > _e735.member)) != false))), _e735.member_1);
                            phi_1188_ = type_15(1u, _e735.member);
                        } else {
                            phi_1145_ = _e735;
                            phi_1188_ = type_15(0u, type_15().member_1);
                        }
                        let _e755 = phi_1145_;
                        let _e757 = phi_1188_;
                        let _e760 = (bitcast<i32>(_e757.member) != 0i);
                        if _e760 {
                            phi_1148_ = (0.5f * (_e737 + (_e727 / _e737)));
                        } else {
                            phi_1148_ = f32();
                        }
                        let _e765 = phi_1148_;
                        continue;
                        continuing {
                            phi_1144_ = _e755;
                            phi_1147_ = _e765;
                            break if !(_e760);
                        }
                    }
                    let _e770 = local_7;
                    phi_1201_ = (_e770 * (1f + (8f * 0.000000059604645f)));
                }
                let _e776 = phi_1201_;
                let _e782 = local_5.member[0u];
                let _e788 = select(_e782[0], -(_e782[0]), (_e782[0] < 0f));
                let _e791 = select(_e782[1], -(_e782[1]), (_e782[1] < 0f));
                let _e793 = select(_e791, _e788, (_e788 > _e791));
                let _e796 = select(_e782[2], -(_e782[2]), (_e782[2] < 0f));
                let _e798 = select(_e796, _e793, (_e793 > _e796));
                let _e801 = local_5.member[1u];
                let _e807 = select(_e801[0], -(_e801[0]), (_e801[0] < 0f));
                let _e810 = select(_e801[1], -(_e801[1]), (_e801[1] < 0f));
                let _e812 = select(_e810, _e807, (_e807 > _e810));
                let _e815 = select(_e801[2], -(_e801[2]), (_e801[2] < 0f));
                let _e817 = select(_e815, _e812, (_e812 > _e815));
                let _e821 = local_5.member_3;
                let _e825 = local_5.member_1[0u];
                let _e831 = select(_e825[0], -(_e825[0]), (_e825[0] < 0f));
                let _e834 = select(_e825[1], -(_e825[1]), (_e825[1] < 0f));
                let _e836 = select(_e834, _e831, (_e831 > _e834));
                let _e839 = select(_e825[2], -(_e825[2]), (_e825[2] < 0f));
                let _e841 = select(_e839, _e836, (_e836 > _e839));
                let _e844 = local_5.member_1[1u];
                let _e850 = select(_e844[0], -(_e844[0]), (_e844[0] < 0f));
                let _e853 = select(_e844[1], -(_e844[1]), (_e844[1] < 0f));
                let _e855 = select(_e853, _e850, (_e850 > _e853));
                let _e858 = select(_e844[2], -(_e844[2]), (_e844[2] < 0f));
                let _e860 = select(_e858, _e855, (_e855 > _e858));
                let _e864 = local_5.member_3;
                let _e868 = local_5.member_2[0u];
                let _e874 = select(_e868[0], -(_e868[0]), (_e868[0] < 0f));
                let _e877 = select(_e868[1], -(_e868[1]), (_e868[1] < 0f));
                let _e879 = select(_e877, _e874, (_e874 > _e877));
                let _e882 = select(_e868[2], -(_e868[2]), (_e868[2] < 0f));
                let _e884 = select(_e882, _e879, (_e879 > _e882));
                let _e887 = local_5.member_2[1u];
                let _e893 = select(_e887[0], -(_e887[0]), (_e887[0] < 0f));
                let _e896 = select(_e887[1], -(_e887[1]), (_e887[1] < 0f));
                let _e898 = select(_e896, _e893, (_e893 > _e896));
                let _e901 = select(_e887[2], -(_e887[2]), (_e887[2] < 0f));
                let _e903 = select(_e901, _e898, (_e898 > _e901));
                let _e907 = local_5.member_3;
                let _e914 = local_5.member_3;
                let _e921 = (((_e776 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e817, _e798, (_e798 > _e817)) + _e821) + (select(_e860, _e841, (_e841 > _e860)) + _e864)) + (select(_e903, _e884, (_e884 > _e903)) + _e907)) * (0.000000059604645f * 16f)) + (_e914 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e609.member_1);
                if _e921 {
                    phi_2112_ = type_35();
                    phi_2113_ = true;
                } else {
                    let _e924 = local_5.member_1[0u];
                    let _e930 = local_5.member_2[0u];
                    let _e936 = ((_e924[1] * _e930[2]) - (_e924[2] * _e930[1]));
                    let _e939 = ((_e924[2] * _e930[0]) - (_e924[0] * _e930[2]));
                    let _e942 = ((_e924[0] * _e930[1]) - (_e924[1] * _e930[0]));
                    let _e945 = local_5.member_1[1u];
                    let _e951 = local_5.member_2[1u];
                    let _e957 = ((_e945[1] * _e951[2]) - (_e945[2] * _e951[1]));
                    let _e960 = ((_e945[2] * _e951[0]) - (_e945[0] * _e951[2]));
                    let _e963 = ((_e945[0] * _e951[1]) - (_e945[1] * _e951[0]));
                    let _e966 = local_5.member_1[0u];
                    let _e972 = local_5.member_2[1u];
                    let _e987 = local_5.member_1[1u];
                    let _e993 = local_5.member_2[0u];
                    let _e1006 = (((_e966[1] * _e972[2]) - (_e966[2] * _e972[1])) + ((_e987[1] * _e993[2]) - (_e987[2] * _e993[1])));
                    let _e1007 = (((_e966[2] * _e972[0]) - (_e966[0] * _e972[2])) + ((_e987[2] * _e993[0]) - (_e987[0] * _e993[2])));
                    let _e1008 = (((_e966[0] * _e972[1]) - (_e966[1] * _e972[0])) + ((_e987[0] * _e993[1]) - (_e987[1] * _e993[0])));
                    let _e1011 = local_5.member[0u];
                    let _e1022 = local_5.member[1u];
                    let _e1033 = local_5.member[0u];
                    let _e1042 = ((((_e1022[0] * _e936) + (_e1022[1] * _e939)) + (_e1022[2] * _e942)) + (((_e1033[0] * _e1006) + (_e1033[1] * _e1007)) + (_e1033[2] * _e1008)));
                    let _e1045 = local_5.member[0u];
                    let _e1056 = local_5.member[1u];
                    let _e1065 = ((((_e1045[0] * _e957) + (_e1045[1] * _e960)) + (_e1045[2] * _e963)) + (((_e1056[0] * _e1006) + (_e1056[1] * _e1007)) + (_e1056[2] * _e1008)));
                    let _e1068 = local_5.member[1u];
                    let _e1079 = local_5.member[0u];
                    let _e1085 = select(_e1079[0], -(_e1079[0]), (_e1079[0] < 0f));
                    let _e1088 = select(_e1079[1], -(_e1079[1]), (_e1079[1] < 0f));
                    let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                    let _e1093 = select(_e1079[2], -(_e1079[2]), (_e1079[2] < 0f));
                    let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                    let _e1098 = local_5.member[1u];
                    let _e1104 = select(_e1098[0], -(_e1098[0]), (_e1098[0] < 0f));
                    let _e1107 = select(_e1098[1], -(_e1098[1]), (_e1098[1] < 0f));
                    let _e1109 = select(_e1107, _e1104, (_e1104 > _e1107));
                    let _e1112 = select(_e1098[2], -(_e1098[2]), (_e1098[2] < 0f));
                    let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                    let _e1118 = local_5.member_3;
                    let _e1119 = (select(_e1114, _e1095, (_e1095 > _e1114)) + _e1118);
                    let _e1122 = local_5.member_1[0u];
                    let _e1128 = select(_e1122[0], -(_e1122[0]), (_e1122[0] < 0f));
                    let _e1131 = select(_e1122[1], -(_e1122[1]), (_e1122[1] < 0f));
                    let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                    let _e1136 = select(_e1122[2], -(_e1122[2]), (_e1122[2] < 0f));
                    let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                    let _e1141 = local_5.member_1[1u];
                    let _e1147 = select(_e1141[0], -(_e1141[0]), (_e1141[0] < 0f));
                    let _e1150 = select(_e1141[1], -(_e1141[1]), (_e1141[1] < 0f));
                    let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                    let _e1155 = select(_e1141[2], -(_e1141[2]), (_e1141[2] < 0f));
                    let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                    let _e1161 = local_5.member_3;
                    let _e1162 = (select(_e1157, _e1138, (_e1138 > _e1157)) + _e1161);
                    let _e1165 = local_5.member_2[0u];
                    let _e1171 = select(_e1165[0], -(_e1165[0]), (_e1165[0] < 0f));
                    let _e1174 = select(_e1165[1], -(_e1165[1]), (_e1165[1] < 0f));
                    let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                    let _e1179 = select(_e1165[2], -(_e1165[2]), (_e1165[2] < 0f));
                    let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                    let _e1184 = local_5.member_2[1u];
                    let _e1190 = select(_e1184[0], -(_e1184[0]), (_e1184[0] < 0f));
                    let _e1193 = select(_e1184[1], -(_e1184[1]), (_e1184[1] < 0f));
                    let _e1195 = select(_e1193, _e1190, (_e1190 > _e1193));
                    let _e1198 = select(_e1184[2], -(_e1184[2]), (_e1184[2] < 0f));
                    let _e1200 = select(_e1198, _e1195, (_e1195 > _e1198));
                    let _e1204 = local_5.member_3;
                    let _e1205 = (select(_e1200, _e1181, (_e1181 > _e1200)) + _e1204);
                    let _e1207 = ((_e1162 * 8f) * _e1205);
                    let _e1214 = local_5.member_3;
                    let _e1238 = ((select(_e936, -(_e936), (_e936 < 0f)) + select(_e939, -(_e939), (_e939 < 0f))) + select(_e942, -(_e942), (_e942 < 0f)));
                    let _e1249 = ((select(_e957, -(_e957), (_e957 < 0f)) + select(_e960, -(_e960), (_e960 < 0f))) + select(_e963, -(_e963), (_e963 < 0f)));
                    let _e1251 = select(_e1249, _e1238, (_e1238 > _e1249));
                    let _e1263 = (((select(_e1006, -(_e1006), (_e1006 < 0f)) + select(_e1007, -(_e1007), (_e1007 < 0f))) + select(_e1008, -(_e1008), (_e1008 < 0f))) * 0.5f);
                    let _e1270 = local_5.member_3;
                    let _e1283 = ((((_e1011[0] * _e936) + (_e1011[1] * _e939)) + (_e1011[2] * _e942)) * 3f);
                    let _e1284 = ((((_e1068[0] * _e957) + (_e1068[1] * _e960)) + (_e1068[2] * _e963)) * 3f);
                    let _e1286 = select(_e1284, _e1283, (_e1283 < _e1284));
                    let _e1288 = select(_e1065, _e1042, (_e1042 < _e1065));
                    let _e1290 = select(_e1288, _e1286, (_e1286 < _e1288));
                    let _e1292 = select(_e1284, _e1283, (_e1283 > _e1284));
                    let _e1294 = select(_e1065, _e1042, (_e1042 > _e1065));
                    let _e1297 = -(select(_e1294, _e1292, (_e1292 > _e1294)));
                    if ((select(_e1297, _e1290, (_e1290 > _e1297)) - ((((((_e1119 * 8f) * _e1207) * (0.000000059604645f * (524f / 64f))) + ((_e1214 * 19f) * ((_e1119 * (_e1162 + _e1205)) + (_e1162 * _e1205)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1119) * ((1f + _e1162) * (1f + _e1205))))) + ((_e609.member_1 * (((select(_e1263, _e1251, (_e1251 > _e1263)) + (_e1207 * (0.000000059604645f * 8f))) + ((_e1270 * 6f) * (_e1162 + _e1205))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1162) * (1f + _e1205))))) * (3f * 1.0001f)))) > 0f) {
                        phi_2110_ = type_35(type_34(0u, f32()), 0u);
                        phi_2111_ = false;
                    } else {
                        phi_2110_ = type_35();
                        phi_2111_ = true;
                    }
                    let _e1309 = phi_2110_;
                    let _e1311 = phi_2111_;
                    phi_2112_ = _e1309;
                    phi_2113_ = _e1311;
                }
                let _e1313 = phi_2112_;
                let _e1315 = phi_2113_;
                if _e1315 {
                    phi_2119_ = type_14(0i, 2i);
                    phi_2122_ = _e380;
                    phi_2124_ = 0u;
                    phi_2126_ = _e380;
                    loop {
                        let _e1317 = phi_2119_;
                        let _e1319 = phi_2122_;
                        let _e1321 = phi_2124_;
                        let _e1323 = phi_2126_;
                        local_54 = _e1321;
                        local_57 = _e1319;
                        local_58 = _e1321;
                        if (_e1317.member < _e1317.member_1) {
                            let _e1330 = (_e1317.member + 1i);
                            phi_2120_ = type_14(select(_e1330, type_15().member_1, select(false, true, ((false == (_e1330 > _e1317.member)) != false))), _e1317.member_1);
                            phi_2167_ = type_15(1u, _e1317.member);
                        } else {
                            phi_2120_ = _e1317;
                            phi_2167_ = type_15(0u, type_15().member_1);
                        }
                        let _e1341 = phi_2120_;
                        let _e1343 = phi_2167_;
                        if (bitcast<i32>(_e1343.member) != 0i) {
                            if select(select(true, false, _e921), true, (_e1343.member_1 > 0i)) {
                                let _e1353 = local_5.member[0u];
                                let _e1359 = local_5.member_1[0u];
                                let _e1365 = local_5.member_2[0u];
                                let _e1369 = (_e1353[0] - _e1359[0]);
                                let _e1370 = (_e1353[1] - _e1359[1]);
                                let _e1371 = (_e1353[2] - _e1359[2]);
                                let _e1372 = (_e225.member == 0u);
                                let _e1384 = local_5.member[1u];
                                let _e1390 = local_5.member_1[1u];
                                let _e1396 = local_5.member_2[1u];
                                let _e1400 = (_e1384[0] - _e1390[0]);
                                let _e1401 = (_e1384[1] - _e1390[1]);
                                let _e1402 = (_e1384[2] - _e1390[2]);
                                let _e1403 = (_e225.member == 0u);
                                let _e1415 = local_5.member[0u];
                                let _e1421 = select(_e1415[0], -(_e1415[0]), (_e1415[0] < 0f));
                                let _e1424 = select(_e1415[1], -(_e1415[1]), (_e1415[1] < 0f));
                                let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                let _e1429 = select(_e1415[2], -(_e1415[2]), (_e1415[2] < 0f));
                                let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                let _e1434 = local_5.member[1u];
                                let _e1440 = select(_e1434[0], -(_e1434[0]), (_e1434[0] < 0f));
                                let _e1443 = select(_e1434[1], -(_e1434[1]), (_e1434[1] < 0f));
                                let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                let _e1448 = select(_e1434[2], -(_e1434[2]), (_e1434[2] < 0f));
                                let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                let _e1454 = local_5.member_3;
                                let _e1458 = local_5.member_1[0u];
                                let _e1464 = select(_e1458[0], -(_e1458[0]), (_e1458[0] < 0f));
                                let _e1467 = select(_e1458[1], -(_e1458[1]), (_e1458[1] < 0f));
                                let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                let _e1472 = select(_e1458[2], -(_e1458[2]), (_e1458[2] < 0f));
                                let _e1474 = select(_e1472, _e1469, (_e1469 > _e1472));
                                let _e1477 = local_5.member_1[1u];
                                let _e1483 = select(_e1477[0], -(_e1477[0]), (_e1477[0] < 0f));
                                let _e1486 = select(_e1477[1], -(_e1477[1]), (_e1477[1] < 0f));
                                let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                let _e1491 = select(_e1477[2], -(_e1477[2]), (_e1477[2] < 0f));
                                let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                let _e1497 = local_5.member_3;
                                let _e1501 = local_5.member_2[0u];
                                let _e1507 = select(_e1501[0], -(_e1501[0]), (_e1501[0] < 0f));
                                let _e1510 = select(_e1501[1], -(_e1501[1]), (_e1501[1] < 0f));
                                let _e1512 = select(_e1510, _e1507, (_e1507 > _e1510));
                                let _e1515 = select(_e1501[2], -(_e1501[2]), (_e1501[2] < 0f));
                                let _e1517 = select(_e1515, _e1512, (_e1512 > _e1515));
                                let _e1520 = local_5.member_2[1u];
                                let _e1526 = select(_e1520[0], -(_e1520[0]), (_e1520[0] < 0f));
                                let _e1529 = select(_e1520[1], -(_e1520[1]), (_e1520[1] < 0f));
                                let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                let _e1534 = select(_e1520[2], -(_e1520[2]), (_e1520[2] < 0f));
                                let _e1536 = select(_e1534, _e1531, (_e1531 > _e1534));
                                let _e1540 = local_5.member_3;
                                let _e1547 = local_5.member_3;
                                let _e1552 = (_e378 * 0.00390625f);
                                local_3 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_2604_ = type_9(0u, 96u);
                                phi_2607_ = _e1323;
                                phi_2609_ = _e1323;
                                phi_2611_ = (_e382 - _e1323);
                                phi_2613_ = _e1323;
                                phi_2615_ = false;
                                phi_2617_ = 0u;
                                loop {
                                    let _e1555 = phi_2604_;
                                    let _e1557 = phi_2607_;
                                    let _e1559 = phi_2609_;
                                    let _e1561 = phi_2611_;
                                    let _e1563 = phi_2613_;
                                    let _e1565 = phi_2615_;
                                    let _e1567 = phi_2617_;
                                    local_20 = _e1557;
                                    local_24 = _e1559;
                                    let _e1570 = (_e1555.member < _e1555.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1570)) != 0i) {
                                        let _e1584 = local_5.member[0u];
                                        let _e1590 = local_5.member[1u];
                                        let _e1606 = local_5.member_1[0u];
                                        let _e1612 = local_5.member_1[1u];
                                        let _e1628 = local_5.member_2[0u];
                                        let _e1634 = local_5.member_2[1u];
                                        let _e1648 = function_3(array<f32, 3>((_e1584[0] + ((_e1590[0] - _e1584[0]) * _e1557)), (_e1584[1] + ((_e1590[1] - _e1584[1]) * _e1557)), (_e1584[2] + ((_e1590[2] - _e1584[2]) * _e1557))), array<f32, 3>((_e1606[0] + ((_e1612[0] - _e1606[0]) * _e1557)), (_e1606[1] + ((_e1612[1] - _e1606[1]) * _e1557)), (_e1606[2] + ((_e1612[2] - _e1606[2]) * _e1557))), array<f32, 3>((_e1628[0] + ((_e1634[0] - _e1628[0]) * _e1557)), (_e1628[1] + ((_e1634[1] - _e1628[1]) * _e1557)), (_e1628[2] + ((_e1634[2] - _e1628[2]) * _e1557))), _e225.member);
                                        if (_e1567 == 0u) {
                                            phi_2768_ = _e1648;
                                        } else {
                                            phi_2768_ = array<f32, 3>(select(0f, _e1648[0], (_e1567 == 1u)), select(0f, _e1648[1], (_e1567 == 2u)), select(0f, _e1648[2], (_e1567 == 3u)));
                                        }
                                        let _e1661 = phi_2768_;
                                        let _e1675 = ((select(_e1661[0], -(_e1661[0]), (_e1661[0] < 0f)) + select(_e1661[1], -(_e1661[1]), (_e1661[1] < 0f))) + select(_e1661[2], -(_e1661[2]), (_e1661[2] < 0f)));
                                        if (_e1675 > 0f) {
                                            if ((bitcast<u32>(_e1675) & 2139095040u) != 2139095040u) {
                                                let _e1680 = (1f / _e1675);
                                                let _e1682 = (_e1661[0] * _e1680);
                                                let _e1684 = (_e1661[1] * _e1680);
                                                let _e1686 = (_e1661[2] * _e1680);
                                                let _e1691 = (((_e1682 * _e1682) + (_e1684 * _e1684)) + (_e1686 * _e1686));
                                                if (_e1691 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_2891_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1691 > 0f));
                                                } else {
                                                    phi_2834_ = type_14(0i, 5i);
                                                    phi_2837_ = bitcast<f32>(((bitcast<u32>(_e1691) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1699 = phi_2834_;
                                                        let _e1701 = phi_2837_;
                                                        local_8 = _e1701;
                                                        if (_e1699.member < _e1699.member_1) {
                                                            let _e1708 = (_e1699.member + 1i);
                                                            phi_2835_ = type_14(select(_e1708, type_15().member_1, select(false, true, ((false == (_e1708 > _e1699.member)) != false))), _e1699.member_1);
                                                            phi_2878_ = type_15(1u, _e1699.member);
                                                        } else {
                                                            phi_2835_ = _e1699;
                                                            phi_2878_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1719 = phi_2835_;
                                                        let _e1721 = phi_2878_;
                                                        let _e1724 = (bitcast<i32>(_e1721.member) != 0i);
                                                        if _e1724 {
                                                            phi_2838_ = (0.5f * (_e1701 + (_e1691 / _e1701)));
                                                        } else {
                                                            phi_2838_ = f32();
                                                        }
                                                        let _e1729 = phi_2838_;
                                                        continue;
                                                        continuing {
                                                            phi_2834_ = _e1719;
                                                            phi_2837_ = _e1729;
                                                            break if !(_e1724);
                                                        }
                                                    }
                                                    let _e1734 = local_8;
                                                    phi_2891_ = (_e1734 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1740 = phi_2891_;
                                                let _e1741 = (0.000000059604645f * 12f);
                                                let _e1746 = ((((((((select(_e1450, _e1431, (_e1431 > _e1450)) + _e1454) + (select(_e1493, _e1474, (_e1474 > _e1493)) + _e1497)) + (select(_e1536, _e1517, (_e1517 > _e1536)) + _e1540)) * (0.000000059604645f * 16f)) + (_e1547 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e609.member_1 * _e1740) * (1f + _e1741)));
                                                let _e1751 = (((_e1682 * _e1353[0]) + (_e1684 * _e1353[1])) + (_e1686 * _e1353[2]));
                                                let _e1756 = (((_e1682 * _e1369) + (_e1684 * _e1370)) + (_e1686 * _e1371));
                                                let _e1761 = (((_e1682 * (_e1353[0] - _e1365[0])) + (_e1684 * (_e1353[1] - _e1365[1]))) + (_e1686 * (_e1353[2] - _e1365[2])));
                                                let _e1766 = (((_e1682 * select((_e1369 - _e1365[0]), _e1353[0], _e1372)) + (_e1684 * select((_e1370 - _e1365[1]), _e1353[1], _e1372))) + (_e1686 * select((_e1371 - _e1365[2]), _e1353[2], _e1372)));
                                                let _e1772 = (((_e1682 * _e1384[0]) + (_e1684 * _e1384[1])) + (_e1686 * _e1384[2]));
                                                let _e1777 = (((_e1682 * _e1400) + (_e1684 * _e1401)) + (_e1686 * _e1402));
                                                let _e1782 = (((_e1682 * (_e1384[0] - _e1396[0])) + (_e1684 * (_e1384[1] - _e1396[1]))) + (_e1686 * (_e1384[2] - _e1396[2])));
                                                let _e1787 = (((_e1682 * select((_e1400 - _e1396[0]), _e1384[0], _e1403)) + (_e1684 * select((_e1401 - _e1396[1]), _e1384[1], _e1403))) + (_e1686 * select((_e1402 - _e1396[2]), _e1384[2], _e1403)));
                                                phi_3014_ = type_31(array<f32, 4>(_e1751, _e1756, _e1761, _e1766), array<f32, 4>(_e1772, _e1777, _e1782, _e1787), array<f32, 4>((_e1746 + ((select(_e1751, -(_e1751), (_e1751 < 0f)) + select(_e1772, -(_e1772), (_e1772 < 0f))) * _e1741)), (_e1746 + ((select(_e1756, -(_e1756), (_e1756 < 0f)) + select(_e1777, -(_e1777), (_e1777 < 0f))) * _e1741)), (_e1746 + ((select(_e1761, -(_e1761), (_e1761 < 0f)) + select(_e1782, -(_e1782), (_e1782 < 0f))) * _e1741)), (_e1746 + ((select(_e1766, -(_e1766), (_e1766 < 0f)) + select(_e1787, -(_e1787), (_e1787 < 0f))) * _e1741))));
                                                phi_3015_ = false;
                                            } else {
                                                phi_3014_ = type_31();
                                                phi_3015_ = true;
                                            }
                                            let _e1828 = phi_3014_;
                                            let _e1830 = phi_3015_;
                                            phi_3016_ = _e1828;
                                            phi_3017_ = _e1830;
                                        } else {
                                            phi_3016_ = type_31();
                                            phi_3017_ = true;
                                        }
                                        let _e1832 = phi_3016_;
                                        let _e1834 = phi_3017_;
                                        if _e1834 {
                                            phi_3025_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_3025_ = _e1832;
                                        }
                                        let _e1836 = phi_3025_;
                                        local_4 = type_31(array<f32, 4>(_e1836.member[0], _e1836.member[1], _e1836.member[2], _e1836.member[3]), array<f32, 4>(_e1836.member_1[0], _e1836.member_1[1], _e1836.member_1[2], _e1836.member_1[3]), array<f32, 4>(_e1836.member_2[0], _e1836.member_2[1], _e1836.member_2[2], _e1836.member_2[3]));
                                        let _e1856 = (_e1557 - _e1563);
                                        let _e1860 = local_4.member[0u];
                                        let _e1863 = local_4.member_1[0u];
                                        let _e1866 = local_4.member[0u];
                                        let _e1872 = local_4.member_2[0u];
                                        if (((_e1860 + ((_e1863 - _e1866) * _e1557)) - _e1872) > 0f) {
                                            let _e1877 = local_4.member[1u];
                                            let _e1880 = local_4.member_1[1u];
                                            let _e1883 = local_4.member[1u];
                                            let _e1889 = local_4.member_2[1u];
                                            if (((_e1877 + ((_e1880 - _e1883) * _e1557)) - _e1889) > 0f) {
                                                let _e1894 = local_4.member[2u];
                                                let _e1897 = local_4.member_1[2u];
                                                let _e1900 = local_4.member[2u];
                                                let _e1906 = local_4.member_2[2u];
                                                if (((_e1894 + ((_e1897 - _e1900) * _e1557)) - _e1906) > 0f) {
                                                    let _e1911 = local_4.member[3u];
                                                    let _e1914 = local_4.member_1[3u];
                                                    let _e1917 = local_4.member[3u];
                                                    let _e1923 = local_4.member_2[3u];
                                                    phi_3196_ = (((_e1911 + ((_e1914 - _e1917) * _e1557)) - _e1923) > 0f);
                                                    phi_3197_ = false;
                                                } else {
                                                    phi_3196_ = bool();
                                                    phi_3197_ = true;
                                                }
                                                let _e1927 = phi_3196_;
                                                let _e1929 = phi_3197_;
                                                phi_3198_ = _e1927;
                                                phi_3199_ = _e1929;
                                            } else {
                                                phi_3198_ = bool();
                                                phi_3199_ = true;
                                            }
                                            let _e1931 = phi_3198_;
                                            let _e1933 = phi_3199_;
                                            phi_3200_ = _e1931;
                                            phi_3201_ = _e1933;
                                        } else {
                                            phi_3200_ = bool();
                                            phi_3201_ = true;
                                        }
                                        let _e1935 = phi_3200_;
                                        let _e1937 = phi_3201_;
                                        if select(_e1935, false, _e1937) {
                                            if (_e1557 <= _e1559) {
                                                phi_3515_ = true;
                                            } else {
                                                let _e1942 = local_3.member[0u];
                                                let _e1945 = local_3.member_1[0u];
                                                let _e1948 = local_3.member[0u];
                                                let _e1954 = local_3.member_2[0u];
                                                let _e1958 = local_4.member[0u];
                                                let _e1961 = local_4.member_1[0u];
                                                let _e1964 = local_4.member[0u];
                                                let _e1970 = local_4.member_2[0u];
                                                if ((((_e1942 + ((_e1945 - _e1948) * _e1557)) - _e1954) + ((_e1958 + ((_e1961 - _e1964) * _e1563)) - _e1970)) > 0f) {
                                                    let _e1976 = local_3.member[1u];
                                                    let _e1979 = local_3.member_1[1u];
                                                    let _e1982 = local_3.member[1u];
                                                    let _e1988 = local_3.member_2[1u];
                                                    let _e1992 = local_4.member[1u];
                                                    let _e1995 = local_4.member_1[1u];
                                                    let _e1998 = local_4.member[1u];
                                                    let _e2004 = local_4.member_2[1u];
                                                    if ((((_e1976 + ((_e1979 - _e1982) * _e1557)) - _e1988) + ((_e1992 + ((_e1995 - _e1998) * _e1563)) - _e2004)) > 0f) {
                                                        let _e2010 = local_3.member[2u];
                                                        let _e2013 = local_3.member_1[2u];
                                                        let _e2016 = local_3.member[2u];
                                                        let _e2022 = local_3.member_2[2u];
                                                        let _e2026 = local_4.member[2u];
                                                        let _e2029 = local_4.member_1[2u];
                                                        let _e2032 = local_4.member[2u];
                                                        let _e2038 = local_4.member_2[2u];
                                                        if ((((_e2010 + ((_e2013 - _e2016) * _e1557)) - _e2022) + ((_e2026 + ((_e2029 - _e2032) * _e1563)) - _e2038)) > 0f) {
                                                            let _e2044 = local_3.member[3u];
                                                            let _e2047 = local_3.member_1[3u];
                                                            let _e2050 = local_3.member[3u];
                                                            let _e2056 = local_3.member_2[3u];
                                                            let _e2060 = local_4.member[3u];
                                                            let _e2063 = local_4.member_1[3u];
                                                            let _e2066 = local_4.member[3u];
                                                            let _e2072 = local_4.member_2[3u];
                                                            phi_3502_ = ((((_e2044 + ((_e2047 - _e2050) * _e1557)) - _e2056) + ((_e2060 + ((_e2063 - _e2066) * _e1563)) - _e2072)) > 0f);
                                                            phi_3503_ = false;
                                                        } else {
                                                            phi_3502_ = bool();
                                                            phi_3503_ = true;
                                                        }
                                                        let _e2077 = phi_3502_;
                                                        let _e2079 = phi_3503_;
                                                        phi_3504_ = _e2077;
                                                        phi_3505_ = _e2079;
                                                    } else {
                                                        phi_3504_ = bool();
                                                        phi_3505_ = true;
                                                    }
                                                    let _e2081 = phi_3504_;
                                                    let _e2083 = phi_3505_;
                                                    phi_3506_ = _e2081;
                                                    phi_3507_ = _e2083;
                                                } else {
                                                    phi_3506_ = bool();
                                                    phi_3507_ = true;
                                                }
                                                let _e2085 = phi_3506_;
                                                let _e2087 = phi_3507_;
                                                phi_3515_ = select(_e2085, false, _e2087);
                                            }
                                            let _e2090 = phi_3515_;
                                            if _e2090 {
                                                if select(true, select(true, false, (_e1557 >= _e382)), _e1565) {
                                                    local_3 = type_31(array<f32, 4>(_e1836.member[0], _e1836.member[1], _e1836.member[2], _e1836.member[3]), array<f32, 4>(_e1836.member_1[0], _e1836.member_1[1], _e1836.member_1[2], _e1836.member_1[3]), array<f32, 4>(_e1836.member_2[0], _e1836.member_2[1], _e1836.member_2[2], _e1836.member_2[3]));
                                                    let _e2115 = local_3.member[0u];
                                                    let _e2118 = local_3.member_1[0u];
                                                    let _e2121 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2118 > _e2121)), (_e2115 > _e2121)) {
                                                        let _e2126 = (_e2118 >= _e2115);
                                                        if _e2126 {
                                                            phi_3624_ = f32();
                                                            phi_3625_ = false;
                                                        } else {
                                                            if ((_e2115 - _e2118) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3622_ = (((_e2115 - _e2121) / (_e2115 - _e2118)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3623_ = false;
                                                            } else {
                                                                phi_3622_ = f32();
                                                                phi_3623_ = true;
                                                            }
                                                            let _e2137 = phi_3622_;
                                                            let _e2139 = phi_3623_;
                                                            phi_3624_ = _e2137;
                                                            phi_3625_ = _e2139;
                                                        }
                                                        let _e2141 = phi_3624_;
                                                        let _e2143 = phi_3625_;
                                                        phi_3626_ = _e2141;
                                                        phi_3627_ = _e2126;
                                                        phi_3628_ = _e2143;
                                                    } else {
                                                        phi_3626_ = f32();
                                                        phi_3627_ = true;
                                                        phi_3628_ = false;
                                                    }
                                                    let _e2145 = phi_3626_;
                                                    let _e2147 = phi_3627_;
                                                    let _e2149 = phi_3628_;
                                                    let _e2152 = select(_e2145, select(_e1557, 2f, _e2147), select(_e2149, true, _e2147));
                                                    let _e2155 = local_3.member[1u];
                                                    let _e2158 = local_3.member_1[1u];
                                                    let _e2161 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2158 > _e2161)), (_e2155 > _e2161)) {
                                                        let _e2166 = (_e2158 >= _e2155);
                                                        if _e2166 {
                                                            phi_3692_ = f32();
                                                            phi_3693_ = false;
                                                        } else {
                                                            if ((_e2155 - _e2158) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3690_ = (((_e2155 - _e2161) / (_e2155 - _e2158)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3691_ = false;
                                                            } else {
                                                                phi_3690_ = f32();
                                                                phi_3691_ = true;
                                                            }
                                                            let _e2177 = phi_3690_;
                                                            let _e2179 = phi_3691_;
                                                            phi_3692_ = _e2177;
                                                            phi_3693_ = _e2179;
                                                        }
                                                        let _e2181 = phi_3692_;
                                                        let _e2183 = phi_3693_;
                                                        phi_3694_ = _e2181;
                                                        phi_3695_ = _e2166;
                                                        phi_3696_ = _e2183;
                                                    } else {
                                                        phi_3694_ = f32();
                                                        phi_3695_ = true;
                                                        phi_3696_ = false;
                                                    }
                                                    let _e2185 = phi_3694_;
                                                    let _e2187 = phi_3695_;
                                                    let _e2189 = phi_3696_;
                                                    let _e2192 = select(_e2185, select(_e1557, 2f, _e2187), select(_e2189, true, _e2187));
                                                    let _e2194 = select(_e2192, _e2152, (_e2152 < _e2192));
                                                    let _e2197 = local_3.member[2u];
                                                    let _e2200 = local_3.member_1[2u];
                                                    let _e2203 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2200 > _e2203)), (_e2197 > _e2203)) {
                                                        let _e2208 = (_e2200 >= _e2197);
                                                        if _e2208 {
                                                            phi_3765_ = f32();
                                                            phi_3766_ = false;
                                                        } else {
                                                            if ((_e2197 - _e2200) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3763_ = (((_e2197 - _e2203) / (_e2197 - _e2200)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3764_ = false;
                                                            } else {
                                                                phi_3763_ = f32();
                                                                phi_3764_ = true;
                                                            }
                                                            let _e2219 = phi_3763_;
                                                            let _e2221 = phi_3764_;
                                                            phi_3765_ = _e2219;
                                                            phi_3766_ = _e2221;
                                                        }
                                                        let _e2223 = phi_3765_;
                                                        let _e2225 = phi_3766_;
                                                        phi_3767_ = _e2223;
                                                        phi_3768_ = _e2208;
                                                        phi_3769_ = _e2225;
                                                    } else {
                                                        phi_3767_ = f32();
                                                        phi_3768_ = true;
                                                        phi_3769_ = false;
                                                    }
                                                    let _e2227 = phi_3767_;
                                                    let _e2229 = phi_3768_;
                                                    let _e2231 = phi_3769_;
                                                    let _e2234 = select(_e2227, select(_e1557, 2f, _e2229), select(_e2231, true, _e2229));
                                                    let _e2237 = local_3.member[3u];
                                                    let _e2240 = local_3.member_1[3u];
                                                    let _e2243 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2240 > _e2243)), (_e2237 > _e2243)) {
                                                        let _e2248 = (_e2240 >= _e2237);
                                                        if _e2248 {
                                                            phi_3833_ = f32();
                                                            phi_3834_ = false;
                                                        } else {
                                                            if ((_e2237 - _e2240) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3831_ = (((_e2237 - _e2243) / (_e2237 - _e2240)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3832_ = false;
                                                            } else {
                                                                phi_3831_ = f32();
                                                                phi_3832_ = true;
                                                            }
                                                            let _e2259 = phi_3831_;
                                                            let _e2261 = phi_3832_;
                                                            phi_3833_ = _e2259;
                                                            phi_3834_ = _e2261;
                                                        }
                                                        let _e2263 = phi_3833_;
                                                        let _e2265 = phi_3834_;
                                                        phi_3835_ = _e2263;
                                                        phi_3836_ = _e2248;
                                                        phi_3837_ = _e2265;
                                                    } else {
                                                        phi_3835_ = f32();
                                                        phi_3836_ = true;
                                                        phi_3837_ = false;
                                                    }
                                                    let _e2267 = phi_3835_;
                                                    let _e2269 = phi_3836_;
                                                    let _e2271 = phi_3837_;
                                                    let _e2274 = select(_e2267, select(_e1557, 2f, _e2269), select(_e2271, true, _e2269));
                                                    let _e2276 = select(_e2274, _e2234, (_e2234 < _e2274));
                                                    let _e2278 = select(_e2276, _e2194, (_e2194 < _e2276));
                                                    let _e2280 = select(_e1557, _e2278, (_e2278 > _e1557));
                                                    let _e2281 = (_e2280 > _e382);
                                                    if _e2281 {
                                                        phi_4366_ = f32();
                                                        phi_4367_ = f32();
                                                        phi_4368_ = false;
                                                        phi_4369_ = false;
                                                    } else {
                                                        let _e2282 = (_e2280 - _e1557);
                                                        let _e2283 = (_e2282 <= _e1552);
                                                        let _e2285 = (_e2280 + (_e378 * 0.01f));
                                                        let _e2287 = select(_e382, _e2285, (_e2285 < _e382));
                                                        if _e2283 {
                                                            if (_e609.member_1 > 0f) {
                                                                let _e2291 = local_5.member[0u];
                                                                let _e2297 = local_5.member[1u];
                                                                let _e2313 = local_5.member_1[0u];
                                                                let _e2319 = local_5.member_1[1u];
                                                                let _e2335 = local_5.member_2[0u];
                                                                let _e2341 = local_5.member_2[1u];
                                                                let _e2355 = function_3(array<f32, 3>((_e2291[0] + ((_e2297[0] - _e2291[0]) * _e2287)), (_e2291[1] + ((_e2297[1] - _e2291[1]) * _e2287)), (_e2291[2] + ((_e2297[2] - _e2291[2]) * _e2287))), array<f32, 3>((_e2313[0] + ((_e2319[0] - _e2313[0]) * _e2287)), (_e2313[1] + ((_e2319[1] - _e2313[1]) * _e2287)), (_e2313[2] + ((_e2319[2] - _e2313[2]) * _e2287))), array<f32, 3>((_e2335[0] + ((_e2341[0] - _e2335[0]) * _e2287)), (_e2335[1] + ((_e2341[1] - _e2335[1]) * _e2287)), (_e2335[2] + ((_e2341[2] - _e2335[2]) * _e2287))), _e225.member);
                                                                let _e2366 = (((_e2355[0] * _e2355[0]) + (_e2355[1] * _e2355[1])) + (_e2355[2] * _e2355[2]));
                                                                if (_e2366 <= 0.000000000000000000000000000000000000011754944f) {
                                                                    phi_4068_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2366 > 0f));
                                                                } else {
                                                                    phi_4011_ = type_14(0i, 5i);
                                                                    phi_4014_ = bitcast<f32>(((bitcast<u32>(_e2366) >> bitcast<u32>(1i)) + 532369198u));
                                                                    loop {
                                                                        let _e2374 = phi_4011_;
                                                                        let _e2376 = phi_4014_;
                                                                        local_9 = _e2376;
                                                                        if (_e2374.member < _e2374.member_1) {
                                                                            let _e2383 = (_e2374.member + 1i);
                                                                            phi_4012_ = type_14(select(_e2383, type_15().member_1, select(false, true, ((false == (_e2383 > _e2374.member)) != false))), _e2374.member_1);
                                                                            phi_4055_ = type_15(1u, _e2374.member);
                                                                        } else {
                                                                            phi_4012_ = _e2374;
                                                                            phi_4055_ = type_15(0u, type_15().member_1);
                                                                        }
                                                                        let _e2394 = phi_4012_;
                                                                        let _e2396 = phi_4055_;
                                                                        let _e2399 = (bitcast<i32>(_e2396.member) != 0i);
                                                                        if _e2399 {
                                                                            phi_4015_ = (0.5f * (_e2376 + (_e2366 / _e2376)));
                                                                        } else {
                                                                            phi_4015_ = f32();
                                                                        }
                                                                        let _e2404 = phi_4015_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4011_ = _e2394;
                                                                            phi_4014_ = _e2404;
                                                                            break if !(_e2399);
                                                                        }
                                                                    }
                                                                    let _e2409 = local_9;
                                                                    phi_4068_ = (_e2409 * (1f + (8f * 0.000000059604645f)));
                                                                }
                                                                let _e2415 = phi_4068_;
                                                                let _e2421 = local_5.member[0u];
                                                                let _e2427 = select(_e2421[0], -(_e2421[0]), (_e2421[0] < 0f));
                                                                let _e2430 = select(_e2421[1], -(_e2421[1]), (_e2421[1] < 0f));
                                                                let _e2432 = select(_e2430, _e2427, (_e2427 > _e2430));
                                                                let _e2435 = select(_e2421[2], -(_e2421[2]), (_e2421[2] < 0f));
                                                                let _e2437 = select(_e2435, _e2432, (_e2432 > _e2435));
                                                                let _e2440 = local_5.member[1u];
                                                                let _e2446 = select(_e2440[0], -(_e2440[0]), (_e2440[0] < 0f));
                                                                let _e2449 = select(_e2440[1], -(_e2440[1]), (_e2440[1] < 0f));
                                                                let _e2451 = select(_e2449, _e2446, (_e2446 > _e2449));
                                                                let _e2454 = select(_e2440[2], -(_e2440[2]), (_e2440[2] < 0f));
                                                                let _e2456 = select(_e2454, _e2451, (_e2451 > _e2454));
                                                                let _e2460 = local_5.member_3;
                                                                let _e2464 = local_5.member_1[0u];
                                                                let _e2470 = select(_e2464[0], -(_e2464[0]), (_e2464[0] < 0f));
                                                                let _e2473 = select(_e2464[1], -(_e2464[1]), (_e2464[1] < 0f));
                                                                let _e2475 = select(_e2473, _e2470, (_e2470 > _e2473));
                                                                let _e2478 = select(_e2464[2], -(_e2464[2]), (_e2464[2] < 0f));
                                                                let _e2480 = select(_e2478, _e2475, (_e2475 > _e2478));
                                                                let _e2483 = local_5.member_1[1u];
                                                                let _e2489 = select(_e2483[0], -(_e2483[0]), (_e2483[0] < 0f));
                                                                let _e2492 = select(_e2483[1], -(_e2483[1]), (_e2483[1] < 0f));
                                                                let _e2494 = select(_e2492, _e2489, (_e2489 > _e2492));
                                                                let _e2497 = select(_e2483[2], -(_e2483[2]), (_e2483[2] < 0f));
                                                                let _e2499 = select(_e2497, _e2494, (_e2494 > _e2497));
                                                                let _e2503 = local_5.member_3;
                                                                let _e2507 = local_5.member_2[0u];
                                                                let _e2513 = select(_e2507[0], -(_e2507[0]), (_e2507[0] < 0f));
                                                                let _e2516 = select(_e2507[1], -(_e2507[1]), (_e2507[1] < 0f));
                                                                let _e2518 = select(_e2516, _e2513, (_e2513 > _e2516));
                                                                let _e2521 = select(_e2507[2], -(_e2507[2]), (_e2507[2] < 0f));
                                                                let _e2523 = select(_e2521, _e2518, (_e2518 > _e2521));
                                                                let _e2526 = local_5.member_2[1u];
                                                                let _e2532 = select(_e2526[0], -(_e2526[0]), (_e2526[0] < 0f));
                                                                let _e2535 = select(_e2526[1], -(_e2526[1]), (_e2526[1] < 0f));
                                                                let _e2537 = select(_e2535, _e2532, (_e2532 > _e2535));
                                                                let _e2540 = select(_e2526[2], -(_e2526[2]), (_e2526[2] < 0f));
                                                                let _e2542 = select(_e2540, _e2537, (_e2537 > _e2540));
                                                                let _e2546 = local_5.member_3;
                                                                let _e2553 = local_5.member_3;
                                                                phi_4339_ = select(true, false, (((_e2415 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2456, _e2437, (_e2437 > _e2456)) + _e2460) + (select(_e2499, _e2480, (_e2480 > _e2499)) + _e2503)) + (select(_e2542, _e2523, (_e2523 > _e2542)) + _e2546)) * (0.000000059604645f * 16f)) + (_e2553 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e609.member_1));
                                                            } else {
                                                                phi_4339_ = true;
                                                            }
                                                            let _e2563 = phi_4339_;
                                                            phi_4340_ = _e2563;
                                                        } else {
                                                            phi_4340_ = true;
                                                        }
                                                        let _e2565 = phi_4340_;
                                                        phi_4366_ = select(f32(), select((_e382 - _e1557), select(0f, (_e1856 + _e1856), select(select(true, false, (_e2282 <= (_e1561 * 0.25f))), true, _e2283)), _e1565), _e2565);
                                                        phi_4367_ = _e2282;
                                                        phi_4368_ = _e2565;
                                                        phi_4369_ = select(true, false, _e2565);
                                                    }
                                                    let _e2577 = phi_4366_;
                                                    let _e2579 = phi_4367_;
                                                    let _e2581 = phi_4368_;
                                                    let _e2583 = phi_4369_;
                                                    phi_4370_ = _e2280;
                                                    phi_4371_ = _e2577;
                                                    phi_4372_ = _e2579;
                                                    phi_4373_ = _e2280;
                                                    phi_4374_ = _e2581;
                                                    phi_4375_ = _e2281;
                                                    phi_4376_ = _e2583;
                                                    phi_4377_ = false;
                                                } else {
                                                    phi_4370_ = f32();
                                                    phi_4371_ = f32();
                                                    phi_4372_ = f32();
                                                    phi_4373_ = f32();
                                                    phi_4374_ = false;
                                                    phi_4375_ = false;
                                                    phi_4376_ = false;
                                                    phi_4377_ = true;
                                                }
                                                let _e2585 = phi_4370_;
                                                let _e2587 = phi_4371_;
                                                let _e2589 = phi_4372_;
                                                let _e2591 = phi_4373_;
                                                let _e2593 = phi_4374_;
                                                let _e2595 = phi_4375_;
                                                let _e2597 = phi_4376_;
                                                let _e2599 = phi_4377_;
                                                phi_4378_ = _e2585;
                                                phi_4379_ = _e2587;
                                                phi_4380_ = _e2589;
                                                phi_4381_ = _e2591;
                                                phi_4382_ = false;
                                                phi_4383_ = _e2593;
                                                phi_4384_ = _e2595;
                                                phi_4385_ = _e2597;
                                                phi_4386_ = _e2599;
                                            } else {
                                                phi_4378_ = f32();
                                                phi_4379_ = f32();
                                                phi_4380_ = f32();
                                                phi_4381_ = f32();
                                                phi_4382_ = true;
                                                phi_4383_ = false;
                                                phi_4384_ = false;
                                                phi_4385_ = false;
                                                phi_4386_ = false;
                                            }
                                            let _e2601 = phi_4378_;
                                            let _e2603 = phi_4379_;
                                            let _e2605 = phi_4380_;
                                            let _e2607 = phi_4381_;
                                            let _e2609 = phi_4382_;
                                            let _e2611 = phi_4383_;
                                            let _e2613 = phi_4384_;
                                            let _e2615 = phi_4385_;
                                            let _e2617 = phi_4386_;
                                            phi_4387_ = _e2601;
                                            phi_4388_ = _e2603;
                                            phi_4389_ = _e2605;
                                            phi_4390_ = _e2607;
                                            phi_4391_ = _e2609;
                                            phi_4392_ = _e2611;
                                            phi_4393_ = _e2613;
                                            phi_4394_ = _e2615;
                                            phi_4395_ = _e2617;
                                        } else {
                                            phi_4387_ = f32();
                                            phi_4388_ = f32();
                                            phi_4389_ = f32();
                                            phi_4390_ = f32();
                                            phi_4391_ = true;
                                            phi_4392_ = false;
                                            phi_4393_ = false;
                                            phi_4394_ = false;
                                            phi_4395_ = false;
                                        }
                                        let _e2619 = phi_4387_;
                                        let _e2621 = phi_4388_;
                                        let _e2623 = phi_4389_;
                                        let _e2625 = phi_4390_;
                                        let _e2627 = phi_4391_;
                                        let _e2629 = phi_4392_;
                                        let _e2631 = phi_4393_;
                                        let _e2633 = phi_4394_;
                                        let _e2635 = phi_4395_;
                                        if _e2627 {
                                            if (_e1557 <= _e1559) {
                                                let _e2788 = (_e1567 + 1u);
                                                let _e2789 = (_e2788 > 3u);
                                                phi_4730_ = _e2788;
                                                phi_4731_ = f32();
                                                phi_4732_ = false;
                                                phi_4733_ = select(true, false, _e2789);
                                                phi_4734_ = _e2789;
                                            } else {
                                                let _e2639 = local_3.member[0u];
                                                let _e2642 = local_3.member_1[0u];
                                                let _e2645 = local_3.member[0u];
                                                let _e2651 = local_3.member_2[0u];
                                                let _e2652 = ((_e2639 + ((_e2642 - _e2645) * _e1563)) - _e2651);
                                                let _e2655 = local_3.member[1u];
                                                let _e2658 = local_3.member_1[1u];
                                                let _e2661 = local_3.member[1u];
                                                let _e2667 = local_3.member_2[1u];
                                                let _e2668 = ((_e2655 + ((_e2658 - _e2661) * _e1563)) - _e2667);
                                                let _e2670 = select(_e2668, _e2652, (_e2652 < _e2668));
                                                let _e2673 = local_3.member[2u];
                                                let _e2676 = local_3.member_1[2u];
                                                let _e2679 = local_3.member[2u];
                                                let _e2685 = local_3.member_2[2u];
                                                let _e2686 = ((_e2673 + ((_e2676 - _e2679) * _e1563)) - _e2685);
                                                let _e2689 = local_3.member[3u];
                                                let _e2692 = local_3.member_1[3u];
                                                let _e2695 = local_3.member[3u];
                                                let _e2701 = local_3.member_2[3u];
                                                let _e2702 = ((_e2689 + ((_e2692 - _e2695) * _e1563)) - _e2701);
                                                let _e2704 = select(_e2702, _e2686, (_e2686 < _e2702));
                                                let _e2706 = select(_e2704, _e2670, (_e2670 < _e2704));
                                                let _e2709 = local_4.member[0u];
                                                let _e2712 = local_4.member_1[0u];
                                                let _e2715 = local_4.member[0u];
                                                let _e2721 = local_4.member_2[0u];
                                                let _e2722 = ((_e2709 + ((_e2712 - _e2715) * _e1557)) - _e2721);
                                                let _e2725 = local_4.member[1u];
                                                let _e2728 = local_4.member_1[1u];
                                                let _e2731 = local_4.member[1u];
                                                let _e2737 = local_4.member_2[1u];
                                                let _e2738 = ((_e2725 + ((_e2728 - _e2731) * _e1557)) - _e2737);
                                                let _e2740 = select(_e2738, _e2722, (_e2722 < _e2738));
                                                let _e2743 = local_4.member[2u];
                                                let _e2746 = local_4.member_1[2u];
                                                let _e2749 = local_4.member[2u];
                                                let _e2755 = local_4.member_2[2u];
                                                let _e2756 = ((_e2743 + ((_e2746 - _e2749) * _e1557)) - _e2755);
                                                let _e2759 = local_4.member[3u];
                                                let _e2762 = local_4.member_1[3u];
                                                let _e2765 = local_4.member[3u];
                                                let _e2771 = local_4.member_2[3u];
                                                let _e2772 = ((_e2759 + ((_e2762 - _e2765) * _e1557)) - _e2771);
                                                let _e2774 = select(_e2772, _e2756, (_e2756 < _e2772));
                                                let _e2776 = select(_e2774, _e2740, (_e2740 < _e2774));
                                                if (_e2776 > 0f) {
                                                    phi_4728_ = 0.5f;
                                                } else {
                                                    let _e2780 = (0.95f * (_e2706 / (_e2706 - _e2776)));
                                                    phi_4728_ = select(0.0625f, select(0.9f, _e2780, (_e2780 < 0.9f)), (_e2780 > 0.0625f));
                                                }
                                                let _e2786 = phi_4728_;
                                                phi_4730_ = u32();
                                                phi_4731_ = (_e1856 * _e2786);
                                                phi_4732_ = true;
                                                phi_4733_ = false;
                                                phi_4734_ = false;
                                            }
                                            let _e2792 = phi_4730_;
                                            let _e2794 = phi_4731_;
                                            let _e2796 = phi_4732_;
                                            let _e2798 = phi_4733_;
                                            let _e2800 = phi_4734_;
                                            phi_4735_ = _e2792;
                                            phi_4736_ = _e1559;
                                            phi_4737_ = _e2794;
                                            phi_4738_ = _e1561;
                                            phi_4739_ = _e1563;
                                            phi_4740_ = _e1565;
                                            phi_4741_ = _e1567;
                                            phi_4742_ = _e2796;
                                            phi_4743_ = _e2798;
                                            phi_4744_ = _e2800;
                                            phi_4745_ = false;
                                            phi_4746_ = false;
                                            phi_4747_ = false;
                                        } else {
                                            phi_4735_ = u32();
                                            phi_4736_ = _e2619;
                                            phi_4737_ = _e2621;
                                            phi_4738_ = _e2623;
                                            phi_4739_ = _e1557;
                                            phi_4740_ = true;
                                            phi_4741_ = 0u;
                                            phi_4742_ = _e2629;
                                            phi_4743_ = false;
                                            phi_4744_ = false;
                                            phi_4745_ = _e2631;
                                            phi_4746_ = _e2633;
                                            phi_4747_ = _e2635;
                                        }
                                        let _e2802 = phi_4735_;
                                        let _e2804 = phi_4736_;
                                        let _e2806 = phi_4737_;
                                        let _e2808 = phi_4738_;
                                        let _e2810 = phi_4739_;
                                        let _e2812 = phi_4740_;
                                        let _e2814 = phi_4741_;
                                        let _e2816 = phi_4742_;
                                        let _e2818 = phi_4743_;
                                        let _e2820 = phi_4744_;
                                        let _e2822 = phi_4745_;
                                        let _e2824 = phi_4746_;
                                        let _e2826 = phi_4747_;
                                        if _e2816 {
                                            let _e2827 = (_e2810 + _e2806);
                                            let _e2829 = select(_e2804, _e2827, (_e2827 > _e2804));
                                            let _e2831 = select(_e382, _e2829, (_e2829 < _e382));
                                            let _e2834 = select(((_e2831 - _e2810) > _e1552), true, !(_e1565));
                                            phi_4775_ = _e2831;
                                            phi_4776_ = _e2804;
                                            phi_4777_ = _e2808;
                                            phi_4778_ = _e2810;
                                            phi_4779_ = _e2812;
                                            phi_4780_ = _e2814;
                                            phi_4781_ = _e2834;
                                            phi_4782_ = select(true, false, _e2834);
                                            phi_4783_ = false;
                                            phi_4784_ = false;
                                            phi_4785_ = false;
                                            phi_4786_ = false;
                                        } else {
                                            phi_4775_ = _e1557;
                                            phi_4776_ = _e1559;
                                            phi_4777_ = _e1561;
                                            phi_4778_ = _e1563;
                                            phi_4779_ = _e1565;
                                            phi_4780_ = _e2802;
                                            phi_4781_ = _e2818;
                                            phi_4782_ = false;
                                            phi_4783_ = _e2820;
                                            phi_4784_ = _e2822;
                                            phi_4785_ = _e2824;
                                            phi_4786_ = _e2826;
                                        }
                                        let _e2837 = phi_4775_;
                                        let _e2839 = phi_4776_;
                                        let _e2841 = phi_4777_;
                                        let _e2843 = phi_4778_;
                                        let _e2845 = phi_4779_;
                                        let _e2847 = phi_4780_;
                                        let _e2849 = phi_4781_;
                                        let _e2851 = phi_4782_;
                                        let _e2853 = phi_4783_;
                                        let _e2855 = phi_4784_;
                                        let _e2857 = phi_4785_;
                                        let _e2859 = phi_4786_;
                                        phi_2608_ = _e2837;
                                        phi_2610_ = _e2839;
                                        phi_2612_ = _e2841;
                                        phi_2614_ = _e2843;
                                        phi_2616_ = _e2845;
                                        phi_2618_ = _e2847;
                                        phi_4787_ = _e2804;
                                        phi_4788_ = _e2625;
                                        phi_4789_ = _e2849;
                                        phi_4790_ = _e2851;
                                        phi_4791_ = _e2853;
                                        phi_4792_ = _e2855;
                                        phi_4793_ = _e2857;
                                        phi_4794_ = false;
                                        phi_4795_ = _e2859;
                                    } else {
                                        phi_2608_ = f32();
                                        phi_2610_ = f32();
                                        phi_2612_ = f32();
                                        phi_2614_ = f32();
                                        phi_2616_ = bool();
                                        phi_2618_ = u32();
                                        phi_4787_ = f32();
                                        phi_4788_ = f32();
                                        phi_4789_ = false;
                                        phi_4790_ = false;
                                        phi_4791_ = false;
                                        phi_4792_ = false;
                                        phi_4793_ = false;
                                        phi_4794_ = true;
                                        phi_4795_ = false;
                                    }
                                    let _e2861 = phi_2608_;
                                    let _e2863 = phi_2610_;
                                    let _e2865 = phi_2612_;
                                    let _e2867 = phi_2614_;
                                    let _e2869 = phi_2616_;
                                    let _e2871 = phi_2618_;
                                    let _e2873 = phi_4787_;
                                    let _e2875 = phi_4788_;
                                    let _e2877 = phi_4789_;
                                    let _e2879 = phi_4790_;
                                    let _e2881 = phi_4791_;
                                    let _e2883 = phi_4792_;
                                    let _e2885 = phi_4793_;
                                    let _e2887 = phi_4794_;
                                    let _e2889 = phi_4795_;
                                    local_10 = _e2879;
                                    local_11 = _e2881;
                                    local_12 = _e2879;
                                    local_13 = _e2883;
                                    local_14 = _e2879;
                                    local_15 = _e2885;
                                    local_16 = _e2879;
                                    local_17 = _e2887;
                                    local_18 = _e2879;
                                    local_19 = _e2889;
                                    local_21 = _e2879;
                                    local_22 = _e2875;
                                    local_23 = _e2873;
                                    continue;
                                    continuing {
                                        phi_2604_ = type_9(select(_e1555.member, (_e1555.member + 1u), _e1570), select(_e1555.member_1, _e1555.member_1, _e1570));
                                        phi_2607_ = _e2861;
                                        phi_2609_ = _e2863;
                                        phi_2611_ = _e2865;
                                        phi_2613_ = _e2867;
                                        phi_2615_ = _e2869;
                                        phi_2617_ = _e2871;
                                        break if !(_e2877);
                                    }
                                }
                                let _e2892 = local_10;
                                let _e2894 = local_11;
                                let _e2895 = select(_e2894, false, _e2892);
                                let _e2897 = local_12;
                                let _e2899 = local_13;
                                let _e2902 = local_14;
                                let _e2904 = local_15;
                                let _e2907 = local_16;
                                let _e2909 = local_17;
                                let _e2912 = local_18;
                                let _e2914 = local_19;
                                let _e2920 = local_20;
                                let _e2922 = select(select(_e2899, false, _e2897), false, _e2895);
                                let _e2925 = local_21;
                                let _e2932 = select(select(select(_e2904, false, _e2902), false, _e2895), false, _e2922);
                                let _e2938 = local_22;
                                let _e2940 = local_23;
                                let _e2942 = select(select(select(_e2925, false, _e2895), false, _e2922), true, _e2932);
                                let _e2947 = local_24;
                                let _e2949 = select(select(select(select(select(_e2909, false, _e2907), false, _e2895), false, _e2922), false, _e2932), true, _e2942);
                                let _e2956 = select(select(select(select(select(select(_e2914, false, _e2912), false, _e2895), false, _e2922), false, _e2932), false, _e2942), false, _e2949);
                                let _e2961 = select(select(select(select(select(_e2895, true, _e2922), false, _e2932), false, _e2942), false, _e2949), true, _e2956);
                                phi_4862_ = select(select(type_34().member_1, select(_e2947, select(_e2940, _e2938, _e2932), _e2942), _e2949), select(select(select(type_34().member_1, _e2920, _e2895), type_34().member_1, _e2922), type_34().member_1, _e2956), _e2961);
                                phi_4863_ = (select(select(type_34().member, 1u, _e2949), select(select(select(type_34().member, 1u, _e2895), 0u, _e2922), 0u, _e2956), _e2961) != 0u);
                            } else {
                                phi_4862_ = _e1319;
                                phi_4863_ = true;
                            }
                            let _e2966 = phi_4862_;
                            let _e2968 = phi_4863_;
                            if _e2968 {
                                let _e2969 = (_e2966 > _e380);
                                if _e2969 {
                                    phi_7028_ = f32();
                                    phi_7029_ = u32();
                                    phi_7030_ = f32();
                                    phi_7031_ = type_36();
                                    phi_7032_ = u32();
                                    phi_7033_ = u32();
                                    phi_7034_ = false;
                                    phi_7035_ = false;
                                    phi_7036_ = false;
                                } else {
                                    let _e2972 = local_5.member[0u];
                                    let _e2978 = local_5.member[1u];
                                    let _e2994 = local_5.member_1[0u];
                                    let _e3000 = local_5.member_1[1u];
                                    let _e3016 = local_5.member_2[0u];
                                    let _e3022 = local_5.member_2[1u];
                                    let _e3036 = function_3(array<f32, 3>((_e2972[0] + ((_e2978[0] - _e2972[0]) * _e1323)), (_e2972[1] + ((_e2978[1] - _e2972[1]) * _e1323)), (_e2972[2] + ((_e2978[2] - _e2972[2]) * _e1323))), array<f32, 3>((_e2994[0] + ((_e3000[0] - _e2994[0]) * _e1323)), (_e2994[1] + ((_e3000[1] - _e2994[1]) * _e1323)), (_e2994[2] + ((_e3000[2] - _e2994[2]) * _e1323))), array<f32, 3>((_e3016[0] + ((_e3022[0] - _e3016[0]) * _e1323)), (_e3016[1] + ((_e3022[1] - _e3016[1]) * _e1323)), (_e3016[2] + ((_e3022[2] - _e3016[2]) * _e1323))), _e225.member);
                                    let _e3050 = ((select(_e3036[0], -(_e3036[0]), (_e3036[0] < 0f)) + select(_e3036[1], -(_e3036[1]), (_e3036[1] < 0f))) + select(_e3036[2], -(_e3036[2]), (_e3036[2] < 0f)));
                                    let _e3053 = local_5.member[0u];
                                    let _e3059 = local_5.member_1[0u];
                                    let _e3065 = local_5.member_2[0u];
                                    let _e3069 = (_e3053[0] - _e3059[0]);
                                    let _e3070 = (_e3053[1] - _e3059[1]);
                                    let _e3071 = (_e3053[2] - _e3059[2]);
                                    let _e3072 = (_e225.member == 0u);
                                    let _e3084 = local_5.member[1u];
                                    let _e3090 = local_5.member_1[1u];
                                    let _e3096 = local_5.member_2[1u];
                                    let _e3100 = (_e3084[0] - _e3090[0]);
                                    let _e3101 = (_e3084[1] - _e3090[1]);
                                    let _e3102 = (_e3084[2] - _e3090[2]);
                                    let _e3103 = (_e225.member == 0u);
                                    let _e3115 = local_5.member[0u];
                                    let _e3121 = select(_e3115[0], -(_e3115[0]), (_e3115[0] < 0f));
                                    let _e3124 = select(_e3115[1], -(_e3115[1]), (_e3115[1] < 0f));
                                    let _e3126 = select(_e3124, _e3121, (_e3121 > _e3124));
                                    let _e3129 = select(_e3115[2], -(_e3115[2]), (_e3115[2] < 0f));
                                    let _e3131 = select(_e3129, _e3126, (_e3126 > _e3129));
                                    let _e3134 = local_5.member[1u];
                                    let _e3140 = select(_e3134[0], -(_e3134[0]), (_e3134[0] < 0f));
                                    let _e3143 = select(_e3134[1], -(_e3134[1]), (_e3134[1] < 0f));
                                    let _e3145 = select(_e3143, _e3140, (_e3140 > _e3143));
                                    let _e3148 = select(_e3134[2], -(_e3134[2]), (_e3134[2] < 0f));
                                    let _e3150 = select(_e3148, _e3145, (_e3145 > _e3148));
                                    let _e3154 = local_5.member_3;
                                    let _e3158 = local_5.member_1[0u];
                                    let _e3164 = select(_e3158[0], -(_e3158[0]), (_e3158[0] < 0f));
                                    let _e3167 = select(_e3158[1], -(_e3158[1]), (_e3158[1] < 0f));
                                    let _e3169 = select(_e3167, _e3164, (_e3164 > _e3167));
                                    let _e3172 = select(_e3158[2], -(_e3158[2]), (_e3158[2] < 0f));
                                    let _e3174 = select(_e3172, _e3169, (_e3169 > _e3172));
                                    let _e3177 = local_5.member_1[1u];
                                    let _e3183 = select(_e3177[0], -(_e3177[0]), (_e3177[0] < 0f));
                                    let _e3186 = select(_e3177[1], -(_e3177[1]), (_e3177[1] < 0f));
                                    let _e3188 = select(_e3186, _e3183, (_e3183 > _e3186));
                                    let _e3191 = select(_e3177[2], -(_e3177[2]), (_e3177[2] < 0f));
                                    let _e3193 = select(_e3191, _e3188, (_e3188 > _e3191));
                                    let _e3197 = local_5.member_3;
                                    let _e3201 = local_5.member_2[0u];
                                    let _e3207 = select(_e3201[0], -(_e3201[0]), (_e3201[0] < 0f));
                                    let _e3210 = select(_e3201[1], -(_e3201[1]), (_e3201[1] < 0f));
                                    let _e3212 = select(_e3210, _e3207, (_e3207 > _e3210));
                                    let _e3215 = select(_e3201[2], -(_e3201[2]), (_e3201[2] < 0f));
                                    let _e3217 = select(_e3215, _e3212, (_e3212 > _e3215));
                                    let _e3220 = local_5.member_2[1u];
                                    let _e3226 = select(_e3220[0], -(_e3220[0]), (_e3220[0] < 0f));
                                    let _e3229 = select(_e3220[1], -(_e3220[1]), (_e3220[1] < 0f));
                                    let _e3231 = select(_e3229, _e3226, (_e3226 > _e3229));
                                    let _e3234 = select(_e3220[2], -(_e3220[2]), (_e3220[2] < 0f));
                                    let _e3236 = select(_e3234, _e3231, (_e3231 > _e3234));
                                    let _e3240 = local_5.member_3;
                                    let _e3247 = local_5.member_3;
                                    local_1 = type_30(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3053, array<f32, 3>(_e3069, _e3070, _e3071), array<f32, 3>((_e3053[0] - _e3065[0]), (_e3053[1] - _e3065[1]), (_e3053[2] - _e3065[2])), array<f32, 3>(select((_e3069 - _e3065[0]), _e3053[0], _e3072), select((_e3070 - _e3065[1]), _e3053[1], _e3072), select((_e3071 - _e3065[2]), _e3053[2], _e3072))), array<array<f32, 3>, 4>(_e3084, array<f32, 3>(_e3100, _e3101, _e3102), array<f32, 3>((_e3084[0] - _e3096[0]), (_e3084[1] - _e3096[1]), (_e3084[2] - _e3096[2])), array<f32, 3>(select((_e3100 - _e3096[0]), _e3084[0], _e3103), select((_e3101 - _e3096[1]), _e3084[1], _e3103), select((_e3102 - _e3096[2]), _e3084[2], _e3103)))), ((((((select(_e3150, _e3131, (_e3131 > _e3150)) + _e3154) + (select(_e3193, _e3174, (_e3174 > _e3193)) + _e3197)) + (select(_e3236, _e3217, (_e3217 > _e3236)) + _e3240)) * (0.000000059604645f * 16f)) + (_e3247 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e609.member_1);
                                    let _e3263 = local_1.member_1;
                                    if (_e3050 > _e3263) {
                                        if ((bitcast<u32>(_e3050) & 2139095040u) != 2139095040u) {
                                            let _e3268 = (1f / _e3050);
                                            let _e3270 = (_e3036[0] * _e3268);
                                            let _e3272 = (_e3036[1] * _e3268);
                                            let _e3274 = (_e3036[2] * _e3268);
                                            let _e3279 = (((_e3270 * _e3270) + (_e3272 * _e3272)) + (_e3274 * _e3274));
                                            if (_e3279 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5540_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3279 > 0f));
                                            } else {
                                                phi_5483_ = type_14(0i, 5i);
                                                phi_5486_ = bitcast<f32>(((bitcast<u32>(_e3279) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3287 = phi_5483_;
                                                    let _e3289 = phi_5486_;
                                                    local_25 = _e3289;
                                                    if (_e3287.member < _e3287.member_1) {
                                                        let _e3296 = (_e3287.member + 1i);
                                                        phi_5484_ = type_14(select(_e3296, type_15().member_1, select(false, true, ((false == (_e3296 > _e3287.member)) != false))), _e3287.member_1);
                                                        phi_5527_ = type_15(1u, _e3287.member);
                                                    } else {
                                                        phi_5484_ = _e3287;
                                                        phi_5527_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3307 = phi_5484_;
                                                    let _e3309 = phi_5527_;
                                                    let _e3312 = (bitcast<i32>(_e3309.member) != 0i);
                                                    if _e3312 {
                                                        phi_5487_ = (0.5f * (_e3289 + (_e3279 / _e3289)));
                                                    } else {
                                                        phi_5487_ = f32();
                                                    }
                                                    let _e3317 = phi_5487_;
                                                    continue;
                                                    continuing {
                                                        phi_5483_ = _e3307;
                                                        phi_5486_ = _e3317;
                                                        break if !(_e3312);
                                                    }
                                                }
                                                let _e3322 = local_25;
                                                phi_5540_ = (_e3322 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3328 = phi_5540_;
                                            let _e3329 = (0.000000059604645f * 12f);
                                            let _e3331 = local_1.member_1;
                                            let _e3334 = local_1.member_2;
                                            let _e3338 = ((_e3331 * 1.01f) + ((_e3334 * _e3328) * (1f + _e3329)));
                                            let _e3342 = local_1.member[0u][0u];
                                            let _e3350 = (((_e3270 * _e3342[0]) + (_e3272 * _e3342[1])) + (_e3274 * _e3342[2]));
                                            let _e3354 = local_1.member[0u][1u];
                                            let _e3362 = (((_e3270 * _e3354[0]) + (_e3272 * _e3354[1])) + (_e3274 * _e3354[2]));
                                            let _e3366 = local_1.member[0u][2u];
                                            let _e3374 = (((_e3270 * _e3366[0]) + (_e3272 * _e3366[1])) + (_e3274 * _e3366[2]));
                                            let _e3378 = local_1.member[0u][3u];
                                            let _e3386 = (((_e3270 * _e3378[0]) + (_e3272 * _e3378[1])) + (_e3274 * _e3378[2]));
                                            let _e3390 = local_1.member[1u][0u];
                                            let _e3398 = (((_e3270 * _e3390[0]) + (_e3272 * _e3390[1])) + (_e3274 * _e3390[2]));
                                            let _e3402 = local_1.member[1u][1u];
                                            let _e3410 = (((_e3270 * _e3402[0]) + (_e3272 * _e3402[1])) + (_e3274 * _e3402[2]));
                                            let _e3414 = local_1.member[1u][2u];
                                            let _e3422 = (((_e3270 * _e3414[0]) + (_e3272 * _e3414[1])) + (_e3274 * _e3414[2]));
                                            let _e3426 = local_1.member[1u][3u];
                                            let _e3434 = (((_e3270 * _e3426[0]) + (_e3272 * _e3426[1])) + (_e3274 * _e3426[2]));
                                            local_2 = type_31(array<f32, 4>(_e3350, _e3362, _e3374, _e3386), array<f32, 4>(_e3398, _e3410, _e3422, _e3434), array<f32, 4>((_e3338 + ((select(_e3350, -(_e3350), (_e3350 < 0f)) + select(_e3398, -(_e3398), (_e3398 < 0f))) * _e3329)), (_e3338 + ((select(_e3362, -(_e3362), (_e3362 < 0f)) + select(_e3410, -(_e3410), (_e3410 < 0f))) * _e3329)), (_e3338 + ((select(_e3374, -(_e3374), (_e3374 < 0f)) + select(_e3422, -(_e3422), (_e3422 < 0f))) * _e3329)), (_e3338 + ((select(_e3386, -(_e3386), (_e3386 < 0f)) + select(_e3434, -(_e3434), (_e3434 < 0f))) * _e3329))));
                                            let _e3479 = (((_e3270 * _e3270) + (_e3272 * _e3272)) + (_e3274 * _e3274));
                                            if (_e3479 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5832_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3479 > 0f));
                                            } else {
                                                phi_5775_ = type_14(0i, 5i);
                                                phi_5778_ = bitcast<f32>(((bitcast<u32>(_e3479) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3487 = phi_5775_;
                                                    let _e3489 = phi_5778_;
                                                    local_26 = _e3489;
                                                    if (_e3487.member < _e3487.member_1) {
                                                        let _e3496 = (_e3487.member + 1i);
                                                        phi_5776_ = type_14(select(_e3496, type_15().member_1, select(false, true, ((false == (_e3496 > _e3487.member)) != false))), _e3487.member_1);
                                                        phi_5819_ = type_15(1u, _e3487.member);
                                                    } else {
                                                        phi_5776_ = _e3487;
                                                        phi_5819_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3507 = phi_5776_;
                                                    let _e3509 = phi_5819_;
                                                    let _e3512 = (bitcast<i32>(_e3509.member) != 0i);
                                                    if _e3512 {
                                                        phi_5779_ = (0.5f * (_e3489 + (_e3479 / _e3489)));
                                                    } else {
                                                        phi_5779_ = f32();
                                                    }
                                                    let _e3517 = phi_5779_;
                                                    continue;
                                                    continuing {
                                                        phi_5775_ = _e3507;
                                                        phi_5778_ = _e3517;
                                                        break if !(_e3512);
                                                    }
                                                }
                                                let _e3522 = local_26;
                                                phi_5832_ = (_e3522 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3528 = phi_5832_;
                                            let _e3539 = (((_e3036[0] * _e3036[0]) + (_e3036[1] * _e3036[1])) + (_e3036[2] * _e3036[2]));
                                            if (_e3539 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5921_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3539 > 0f));
                                            } else {
                                                phi_5864_ = type_14(0i, 5i);
                                                phi_5867_ = bitcast<f32>(((bitcast<u32>(_e3539) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3547 = phi_5864_;
                                                    let _e3549 = phi_5867_;
                                                    local_27 = _e3549;
                                                    if (_e3547.member < _e3547.member_1) {
                                                        let _e3556 = (_e3547.member + 1i);
                                                        phi_5865_ = type_14(select(_e3556, type_15().member_1, select(false, true, ((false == (_e3556 > _e3547.member)) != false))), _e3547.member_1);
                                                        phi_5908_ = type_15(1u, _e3547.member);
                                                    } else {
                                                        phi_5865_ = _e3547;
                                                        phi_5908_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3567 = phi_5865_;
                                                    let _e3569 = phi_5908_;
                                                    let _e3572 = (bitcast<i32>(_e3569.member) != 0i);
                                                    if _e3572 {
                                                        phi_5868_ = (0.5f * (_e3549 + (_e3539 / _e3549)));
                                                    } else {
                                                        phi_5868_ = f32();
                                                    }
                                                    let _e3577 = phi_5868_;
                                                    continue;
                                                    continuing {
                                                        phi_5864_ = _e3567;
                                                        phi_5867_ = _e3577;
                                                        break if !(_e3572);
                                                    }
                                                }
                                                let _e3582 = local_27;
                                                phi_5921_ = (_e3582 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3588 = phi_5921_;
                                            let _e3594 = local_5.member[0u];
                                            let _e3600 = select(_e3594[0], -(_e3594[0]), (_e3594[0] < 0f));
                                            let _e3603 = select(_e3594[1], -(_e3594[1]), (_e3594[1] < 0f));
                                            let _e3605 = select(_e3603, _e3600, (_e3600 > _e3603));
                                            let _e3608 = select(_e3594[2], -(_e3594[2]), (_e3594[2] < 0f));
                                            let _e3610 = select(_e3608, _e3605, (_e3605 > _e3608));
                                            let _e3613 = local_5.member[1u];
                                            let _e3619 = select(_e3613[0], -(_e3613[0]), (_e3613[0] < 0f));
                                            let _e3622 = select(_e3613[1], -(_e3613[1]), (_e3613[1] < 0f));
                                            let _e3624 = select(_e3622, _e3619, (_e3619 > _e3622));
                                            let _e3627 = select(_e3613[2], -(_e3613[2]), (_e3613[2] < 0f));
                                            let _e3629 = select(_e3627, _e3624, (_e3624 > _e3627));
                                            let _e3633 = local_5.member_3;
                                            let _e3637 = local_5.member_1[0u];
                                            let _e3643 = select(_e3637[0], -(_e3637[0]), (_e3637[0] < 0f));
                                            let _e3646 = select(_e3637[1], -(_e3637[1]), (_e3637[1] < 0f));
                                            let _e3648 = select(_e3646, _e3643, (_e3643 > _e3646));
                                            let _e3651 = select(_e3637[2], -(_e3637[2]), (_e3637[2] < 0f));
                                            let _e3653 = select(_e3651, _e3648, (_e3648 > _e3651));
                                            let _e3656 = local_5.member_1[1u];
                                            let _e3662 = select(_e3656[0], -(_e3656[0]), (_e3656[0] < 0f));
                                            let _e3665 = select(_e3656[1], -(_e3656[1]), (_e3656[1] < 0f));
                                            let _e3667 = select(_e3665, _e3662, (_e3662 > _e3665));
                                            let _e3670 = select(_e3656[2], -(_e3656[2]), (_e3656[2] < 0f));
                                            let _e3672 = select(_e3670, _e3667, (_e3667 > _e3670));
                                            let _e3676 = local_5.member_3;
                                            let _e3680 = local_5.member_2[0u];
                                            let _e3686 = select(_e3680[0], -(_e3680[0]), (_e3680[0] < 0f));
                                            let _e3689 = select(_e3680[1], -(_e3680[1]), (_e3680[1] < 0f));
                                            let _e3691 = select(_e3689, _e3686, (_e3686 > _e3689));
                                            let _e3694 = select(_e3680[2], -(_e3680[2]), (_e3680[2] < 0f));
                                            let _e3696 = select(_e3694, _e3691, (_e3691 > _e3694));
                                            let _e3699 = local_5.member_2[1u];
                                            let _e3705 = select(_e3699[0], -(_e3699[0]), (_e3699[0] < 0f));
                                            let _e3708 = select(_e3699[1], -(_e3699[1]), (_e3699[1] < 0f));
                                            let _e3710 = select(_e3708, _e3705, (_e3705 > _e3708));
                                            let _e3713 = select(_e3699[2], -(_e3699[2]), (_e3699[2] < 0f));
                                            let _e3715 = select(_e3713, _e3710, (_e3710 > _e3713));
                                            let _e3719 = local_5.member_3;
                                            let _e3726 = local_5.member_3;
                                            let _e3736 = ((((_e3588 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3629, _e3610, (_e3610 > _e3629)) + _e3633) + (select(_e3672, _e3653, (_e3653 > _e3672)) + _e3676)) + (select(_e3715, _e3696, (_e3696 > _e3715)) + _e3719)) * (0.000000059604645f * 16f)) + (_e3726 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3528) * (1f + (0.000000059604645f * 64f)));
                                            let _e3739 = local_2.member[0u];
                                            let _e3742 = local_2.member_1[0u];
                                            phi_6229_ = type_9(1u, 4u);
                                            phi_6232_ = ((_e3739 + ((_e3742 - _e3739) * _e1323)) - ((_e3263 * 1.01f) + ((select(_e3739, -(_e3739), (_e3739 < 0f)) + select(_e3742, -(_e3742), (_e3742 < 0f))) * (0.000000059604645f * 12f))));
                                            loop {
                                                let _e3759 = phi_6229_;
                                                let _e3761 = phi_6232_;
                                                local_28 = _e3761;
                                                local_29 = _e3761;
                                                let _e3764 = (_e3759.member < _e3759.member_1);
                                                let _e3775 = select(type_9().member_1, _e3759.member, _e3764);
                                                let _e3777 = (bitcast<i32>(select(0u, 1u, _e3764)) != 0i);
                                                if _e3777 {
                                                    let _e3780 = local_2.member[_e3775];
                                                    let _e3783 = local_2.member_1[_e3775];
                                                    let _e3798 = ((_e3780 + ((_e3783 - _e3780) * _e1323)) - ((_e3263 * 1.01f) + ((select(_e3780, -(_e3780), (_e3780 < 0f)) + select(_e3783, -(_e3783), (_e3783 < 0f))) * (0.000000059604645f * 12f))));
                                                    phi_6233_ = select(_e3798, _e3761, (_e3761 < _e3798));
                                                } else {
                                                    phi_6233_ = f32();
                                                }
                                                let _e3802 = phi_6233_;
                                                continue;
                                                continuing {
                                                    phi_6229_ = type_9(select(_e3759.member, (_e3759.member + 1u), _e3764), select(_e3759.member_1, _e3759.member_1, _e3764));
                                                    phi_6232_ = _e3802;
                                                    break if !(_e3777);
                                                }
                                            }
                                            let _e3805 = local_28;
                                            if (_e3805 > 0f) {
                                                let _e3809 = local_29;
                                                let _e3812 = (((_e3736 - _e3809) / _e3736) * 2.02f);
                                                if (_e3812 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_6388_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3812 > 0f));
                                                } else {
                                                    phi_6331_ = type_14(0i, 5i);
                                                    phi_6334_ = bitcast<f32>(((bitcast<u32>(_e3812) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3820 = phi_6331_;
                                                        let _e3822 = phi_6334_;
                                                        local_30 = _e3822;
                                                        if (_e3820.member < _e3820.member_1) {
                                                            let _e3829 = (_e3820.member + 1i);
                                                            phi_6332_ = type_14(select(_e3829, type_15().member_1, select(false, true, ((false == (_e3829 > _e3820.member)) != false))), _e3820.member_1);
                                                            phi_6375_ = type_15(1u, _e3820.member);
                                                        } else {
                                                            phi_6332_ = _e3820;
                                                            phi_6375_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3840 = phi_6332_;
                                                        let _e3842 = phi_6375_;
                                                        let _e3845 = (bitcast<i32>(_e3842.member) != 0i);
                                                        if _e3845 {
                                                            phi_6335_ = (0.5f * (_e3822 + (_e3812 / _e3822)));
                                                        } else {
                                                            phi_6335_ = f32();
                                                        }
                                                        let _e3850 = phi_6335_;
                                                        continue;
                                                        continuing {
                                                            phi_6331_ = _e3840;
                                                            phi_6334_ = _e3850;
                                                            break if !(_e3845);
                                                        }
                                                    }
                                                    let _e3855 = local_30;
                                                    phi_6388_ = (_e3855 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3861 = phi_6388_;
                                                let _e3863 = ((_e3861 * _e3528) * 1.01f);
                                                phi_6393_ = type_9(0u, 4u);
                                                phi_6396_ = 2f;
                                                phi_6398_ = true;
                                                phi_6400_ = true;
                                                loop {
                                                    let _e3865 = phi_6393_;
                                                    let _e3867 = phi_6396_;
                                                    let _e3869 = phi_6398_;
                                                    let _e3871 = phi_6400_;
                                                    local_31 = _e3867;
                                                    local_32 = _e3867;
                                                    local_33 = _e3869;
                                                    local_34 = _e3871;
                                                    local_35 = _e3871;
                                                    local_36 = _e3871;
                                                    local_61 = _e3871;
                                                    local_37 = _e3871;
                                                    let _e3874 = (_e3865.member < _e3865.member_1);
                                                    let _e3885 = select(type_9().member_1, _e3865.member, _e3874);
                                                    let _e3887 = (bitcast<i32>(select(0u, 1u, _e3874)) != 0i);
                                                    if _e3887 {
                                                        let _e3891 = local_1.member[0u][_e3885];
                                                        let _e3898 = local_1.member[1u][_e3885];
                                                        let _e3912 = ((select(_e3891[0], -(_e3891[0]), (_e3891[0] < 0f)) + select(_e3891[1], -(_e3891[1]), (_e3891[1] < 0f))) + select(_e3891[2], -(_e3891[2]), (_e3891[2] < 0f)));
                                                        let _e3923 = ((select(_e3898[0], -(_e3898[0]), (_e3898[0] < 0f)) + select(_e3898[1], -(_e3898[1]), (_e3898[1] < 0f))) + select(_e3898[2], -(_e3898[2]), (_e3898[2] < 0f)));
                                                        let _e3929 = (_e3898[0] - _e3891[0]);
                                                        let _e3930 = (_e3898[1] - _e3891[1]);
                                                        let _e3931 = (_e3898[2] - _e3891[2]);
                                                        let _e3948 = local_2.member[_e3885];
                                                        let _e3951 = local_2.member_1[_e3885];
                                                        let _e3962 = ((_e3263 * 1.01f) + ((select(_e3948, -(_e3948), (_e3948 < 0f)) + select(_e3951, -(_e3951), (_e3951 < 0f))) * (0.000000059604645f * 12f)));
                                                        let _e3969 = local_2.member_1[_e3885];
                                                        let _e3972 = local_2.member[_e3885];
                                                        let _e3973 = (_e3969 - _e3972);
                                                        let _e3976 = ((_e3962 + _e3962) + (_e3863 * ((((select(_e3929, -(_e3929), (_e3929 < 0f)) + select(_e3930, -(_e3930), (_e3930 < 0f))) + select(_e3931, -(_e3931), (_e3931 < 0f))) + (_e3263 * 6f)) * 1.01f)));
                                                        let _e3979 = ((((_e3948 + ((_e3951 - _e3948) * _e1323)) - _e3962) - (_e3863 * ((select(_e3923, _e3912, (_e3912 > _e3923)) + (_e3263 * 3f)) * 1.01f))) - _e3736);
                                                        let _e3980 = (_e3979 > 0.000000000000000000000000000000000000011754944f);
                                                        let _e3981 = (_e3973 > _e3976);
                                                        if _e3981 {
                                                            phi_6631_ = _e3867;
                                                        } else {
                                                            if _e3980 {
                                                                let _e3988 = (_e3976 - _e3973);
                                                                let _e3991 = (_e3979 / select(0.000000000000000000000000000000000000011754944f, _e3988, (_e3988 > 0.000000000000000000000000000000000000011754944f)));
                                                                phi_6630_ = select(_e3991, _e3867, (_e3867 < _e3991));
                                                            } else {
                                                                phi_6630_ = _e3867;
                                                            }
                                                            let _e3995 = phi_6630_;
                                                            phi_6631_ = _e3995;
                                                        }
                                                        let _e3997 = phi_6631_;
                                                        phi_6397_ = _e3997;
                                                        phi_6399_ = (_e3869 && select(_e3980, true, (_e3973 < -(_e3976))));
                                                        phi_6401_ = (_e3871 && select(_e3980, true, _e3981));
                                                    } else {
                                                        phi_6397_ = f32();
                                                        phi_6399_ = bool();
                                                        phi_6401_ = bool();
                                                    }
                                                    let _e3999 = phi_6397_;
                                                    let _e4001 = phi_6399_;
                                                    let _e4003 = phi_6401_;
                                                    continue;
                                                    continuing {
                                                        phi_6393_ = type_9(select(_e3865.member, (_e3865.member + 1u), _e3874), select(_e3865.member_1, _e3865.member_1, _e3874));
                                                        phi_6396_ = _e3999;
                                                        phi_6398_ = _e4001;
                                                        phi_6400_ = _e4003;
                                                        break if !(_e3887);
                                                    }
                                                }
                                                let _e4006 = local_31;
                                                let _e4009 = local_32;
                                                let _e4011 = (select(2f, _e4009, (_e4006 < 2f)) * 0.999f);
                                                let _e4013 = local_33;
                                                if _e4013 {
                                                    let _e4016 = local_34;
                                                    let _e4020 = local_35;
                                                    let _e4024 = local_36;
                                                    phi_6646_ = type_36(select(1u, type_36().member, _e4016), select(_e1323, type_36().member_1, _e4020), select(2f, type_36().member_2, _e4024));
                                                    let _e5163 = local_61;
                                                    phi_6647_ = _e5163;
                                                } else {
                                                    phi_6646_ = type_36();
                                                    phi_6647_ = true;
                                                }
                                                let _e4028 = phi_6646_;
                                                let _e4030 = phi_6647_;
                                                if _e4030 {
                                                    let _e4032 = local_37;
                                                    if _e4032 {
                                                        let _e4036 = (_e1323 + _e4011);
                                                        let _e4039 = select(_e1323, select(_e382, _e4036, (_e4036 < _e382)), (_e4011 > (0.000000059604645f * 4096f)));
                                                        phi_6668_ = type_9(0u, 4u);
                                                        phi_6671_ = _e4039;
                                                        phi_6673_ = _e1323;
                                                        loop {
                                                            let _e4041 = phi_6668_;
                                                            let _e4043 = phi_6671_;
                                                            let _e4045 = phi_6673_;
                                                            local_38 = _e4043;
                                                            local_39 = _e4045;
                                                            local_40 = _e4045;
                                                            let _e4048 = (_e4041.member < _e4041.member_1);
                                                            let _e4059 = select(type_9().member_1, _e4041.member, _e4048);
                                                            let _e4061 = (bitcast<i32>(select(0u, 1u, _e4048)) != 0i);
                                                            if _e4061 {
                                                                let _e4064 = local_2.member[_e4059];
                                                                let _e4067 = local_2.member_1[_e4059];
                                                                let _e4070 = local_2.member[_e4059];
                                                                let _e4076 = local_2.member_2[_e4059];
                                                                let _e4077 = ((_e4064 + ((_e4067 - _e4070) * _e1323)) - _e4076);
                                                                let _e4080 = local_2.member_1[_e4059];
                                                                let _e4083 = local_2.member[_e4059];
                                                                let _e4084 = (_e4080 - _e4083);
                                                                if (_e4084 > 0f) {
                                                                    let _e4097 = (_e1323 - (_e4077 / _e4084));
                                                                    phi_6782_ = _e4043;
                                                                    phi_6783_ = select(_e4097, _e4045, (_e4045 > _e4097));
                                                                } else {
                                                                    if (_e4077 > 0f) {
                                                                        if (_e4084 < 0f) {
                                                                            let _e4089 = (_e1323 - (_e4077 / _e4084));
                                                                            phi_6780_ = select(_e4089, _e4043, (_e4043 < _e4089));
                                                                        } else {
                                                                            phi_6780_ = _e4043;
                                                                        }
                                                                        let _e4093 = phi_6780_;
                                                                        phi_6781_ = _e4093;
                                                                    } else {
                                                                        phi_6781_ = _e4043;
                                                                    }
                                                                    let _e4095 = phi_6781_;
                                                                    phi_6782_ = _e4095;
                                                                    phi_6783_ = _e4045;
                                                                }
                                                                let _e4101 = phi_6782_;
                                                                let _e4103 = phi_6783_;
                                                                phi_6672_ = _e4101;
                                                                phi_6674_ = _e4103;
                                                            } else {
                                                                phi_6672_ = f32();
                                                                phi_6674_ = f32();
                                                            }
                                                            let _e4105 = phi_6672_;
                                                            let _e4107 = phi_6674_;
                                                            continue;
                                                            continuing {
                                                                phi_6668_ = type_9(select(_e4041.member, (_e4041.member + 1u), _e4048), select(_e4041.member_1, _e4041.member_1, _e4048));
                                                                phi_6671_ = _e4105;
                                                                phi_6673_ = _e4107;
                                                                break if !(_e4061);
                                                            }
                                                        }
                                                        let _e4110 = local_38;
                                                        let _e4112 = local_39;
                                                        let _e4116 = local_40;
                                                        let _e4117 = (_e4116 + ((_e4110 - _e4112) * 0.5f));
                                                        if (_e4117 > _e1323) {
                                                            if (_e4117 <= _e4039) {
                                                                let _e4122 = local_2.member[0u];
                                                                let _e4125 = local_2.member_1[0u];
                                                                let _e4128 = local_2.member[0u];
                                                                let _e4134 = local_2.member_2[0u];
                                                                if (((_e4122 + ((_e4125 - _e4128) * _e4117)) - _e4134) > 0f) {
                                                                    let _e4139 = local_2.member[1u];
                                                                    let _e4142 = local_2.member_1[1u];
                                                                    let _e4145 = local_2.member[1u];
                                                                    let _e4151 = local_2.member_2[1u];
                                                                    if (((_e4139 + ((_e4142 - _e4145) * _e4117)) - _e4151) > 0f) {
                                                                        let _e4156 = local_2.member[2u];
                                                                        let _e4159 = local_2.member_1[2u];
                                                                        let _e4162 = local_2.member[2u];
                                                                        let _e4168 = local_2.member_2[2u];
                                                                        if (((_e4156 + ((_e4159 - _e4162) * _e4117)) - _e4168) > 0f) {
                                                                            let _e4173 = local_2.member[3u];
                                                                            let _e4176 = local_2.member_1[3u];
                                                                            let _e4179 = local_2.member[3u];
                                                                            let _e4185 = local_2.member_2[3u];
                                                                            phi_6944_ = (((_e4173 + ((_e4176 - _e4179) * _e4117)) - _e4185) > 0f);
                                                                            phi_6945_ = false;
                                                                        } else {
                                                                            phi_6944_ = bool();
                                                                            phi_6945_ = true;
                                                                        }
                                                                        let _e4189 = phi_6944_;
                                                                        let _e4191 = phi_6945_;
                                                                        phi_6946_ = _e4189;
                                                                        phi_6947_ = _e4191;
                                                                    } else {
                                                                        phi_6946_ = bool();
                                                                        phi_6947_ = true;
                                                                    }
                                                                    let _e4193 = phi_6946_;
                                                                    let _e4195 = phi_6947_;
                                                                    phi_6948_ = _e4193;
                                                                    phi_6949_ = _e4195;
                                                                } else {
                                                                    phi_6948_ = bool();
                                                                    phi_6949_ = true;
                                                                }
                                                                let _e4197 = phi_6948_;
                                                                let _e4199 = phi_6949_;
                                                                phi_6958_ = select(true, false, select(_e4197, false, _e4199));
                                                            } else {
                                                                phi_6958_ = true;
                                                            }
                                                            let _e4203 = phi_6958_;
                                                            phi_6959_ = _e4203;
                                                        } else {
                                                            phi_6959_ = true;
                                                        }
                                                        let _e4205 = phi_6959_;
                                                        phi_6966_ = type_36(2u, _e4039, select(_e4117, 2f, _e4205));
                                                        phi_6967_ = type_36();
                                                        phi_6968_ = false;
                                                    } else {
                                                        phi_6966_ = type_36();
                                                        phi_6967_ = type_36(0u, _e1323, 2f);
                                                        phi_6968_ = true;
                                                    }
                                                    let _e4209 = phi_6966_;
                                                    let _e4211 = phi_6967_;
                                                    let _e4213 = phi_6968_;
                                                    phi_6969_ = _e4209;
                                                    phi_6970_ = _e4211;
                                                    phi_6971_ = _e4213;
                                                } else {
                                                    phi_6969_ = type_36();
                                                    phi_6970_ = _e4028;
                                                    phi_6971_ = true;
                                                }
                                                let _e4215 = phi_6969_;
                                                let _e4217 = phi_6970_;
                                                let _e4219 = phi_6971_;
                                                phi_6976_ = _e4217;
                                                phi_6977_ = _e4215;
                                                phi_6978_ = _e4219;
                                            } else {
                                                phi_6976_ = type_36(0u, _e1323, 2f);
                                                phi_6977_ = type_36();
                                                phi_6978_ = true;
                                            }
                                            let _e4221 = phi_6976_;
                                            let _e4223 = phi_6977_;
                                            let _e4225 = phi_6978_;
                                            phi_6982_ = _e4221;
                                            phi_6983_ = _e4223;
                                            phi_6984_ = false;
                                            phi_6985_ = _e4225;
                                        } else {
                                            phi_6982_ = type_36();
                                            phi_6983_ = type_36();
                                            phi_6984_ = true;
                                            phi_6985_ = false;
                                        }
                                        let _e4227 = phi_6982_;
                                        let _e4229 = phi_6983_;
                                        let _e4231 = phi_6984_;
                                        let _e4233 = phi_6985_;
                                        phi_6986_ = _e4227;
                                        phi_6987_ = _e4229;
                                        phi_6988_ = _e4231;
                                        phi_6989_ = _e4233;
                                    } else {
                                        phi_6986_ = type_36();
                                        phi_6987_ = type_36();
                                        phi_6988_ = true;
                                        phi_6989_ = false;
                                    }
                                    let _e4235 = phi_6986_;
                                    let _e4237 = phi_6987_;
                                    let _e4239 = phi_6988_;
                                    let _e4241 = phi_6989_;
                                    let _e4248 = select(_e4241, true, _e4239);
                                    let _e4250 = select(_e4237.member, select(_e4235.member, 0u, _e4239), _e4248);
                                    let _e4254 = select(_e4237.member_2, select(_e4235.member_2, 2f, _e4239), _e4248);
                                    if select(false, _e374, ((_e384 & 64u) != 0u)) {
                                        let _e4256 = (_e4250 == 2u);
                                        let _e4257 = (_e4254 <= _e382);
                                        phi_7023_ = select(f32(), select(f32(), _e4254, _e4257), _e4256);
                                        phi_7024_ = select(f32(), select(f32(), _e4254, _e4257), _e4256);
                                        phi_7025_ = select(false, _e4257, _e4256);
                                        phi_7026_ = select(false, select(true, false, _e4257), _e4256);
                                        phi_7027_ = select(true, false, _e4256);
                                    } else {
                                        phi_7023_ = f32();
                                        phi_7024_ = f32();
                                        phi_7025_ = false;
                                        phi_7026_ = false;
                                        phi_7027_ = true;
                                    }
                                    let _e4267 = phi_7023_;
                                    let _e4269 = phi_7024_;
                                    let _e4271 = phi_7025_;
                                    let _e4273 = phi_7026_;
                                    let _e4275 = phi_7027_;
                                    phi_7028_ = _e4267;
                                    phi_7029_ = _e4250;
                                    phi_7030_ = _e4269;
                                    phi_7031_ = type_36(_e4250, select(_e4237.member_1, select(_e4235.member_1, _e1323, _e4239), _e4248), _e4254);
                                    phi_7032_ = _e4250;
                                    phi_7033_ = _e4250;
                                    phi_7034_ = _e4271;
                                    phi_7035_ = _e4273;
                                    phi_7036_ = _e4275;
                                }
                                let _e4277 = phi_7028_;
                                let _e4279 = phi_7029_;
                                let _e4281 = phi_7030_;
                                let _e4283 = phi_7031_;
                                let _e4285 = phi_7032_;
                                let _e4287 = phi_7033_;
                                let _e4289 = phi_7034_;
                                let _e4291 = phi_7035_;
                                let _e4293 = phi_7036_;
                                phi_7037_ = _e4277;
                                phi_7038_ = _e4279;
                                phi_7039_ = _e4281;
                                phi_7040_ = _e4283;
                                phi_7041_ = _e4285;
                                phi_7042_ = _e4287;
                                phi_7043_ = _e4289;
                                phi_7044_ = _e2969;
                                phi_7045_ = _e4291;
                                phi_7046_ = _e4293;
                                phi_7047_ = false;
                            } else {
                                phi_7037_ = f32();
                                phi_7038_ = u32();
                                phi_7039_ = f32();
                                phi_7040_ = type_36();
                                phi_7041_ = u32();
                                phi_7042_ = u32();
                                phi_7043_ = false;
                                phi_7044_ = false;
                                phi_7045_ = false;
                                phi_7046_ = false;
                                phi_7047_ = true;
                            }
                            let _e4295 = phi_7037_;
                            let _e4297 = phi_7038_;
                            let _e4299 = phi_7039_;
                            let _e4301 = phi_7040_;
                            let _e4303 = phi_7041_;
                            let _e4305 = phi_7042_;
                            let _e4307 = phi_7043_;
                            let _e4309 = phi_7044_;
                            let _e4311 = phi_7045_;
                            let _e4313 = phi_7046_;
                            let _e4315 = phi_7047_;
                            phi_7048_ = _e2966;
                            phi_2123_ = _e4295;
                            phi_2125_ = _e4297;
                            phi_2127_ = _e4299;
                            phi_7049_ = _e4301;
                            phi_7050_ = _e4303;
                            phi_7051_ = _e2966;
                            phi_7052_ = _e4305;
                            phi_7053_ = _e4307;
                            phi_7054_ = _e4309;
                            phi_7055_ = _e4311;
                            phi_7056_ = _e4313;
                            phi_7057_ = false;
                            phi_7058_ = _e4315;
                        } else {
                            phi_7048_ = f32();
                            phi_2123_ = f32();
                            phi_2125_ = u32();
                            phi_2127_ = f32();
                            phi_7049_ = type_36();
                            phi_7050_ = u32();
                            phi_7051_ = f32();
                            phi_7052_ = u32();
                            phi_7053_ = false;
                            phi_7054_ = false;
                            phi_7055_ = false;
                            phi_7056_ = false;
                            phi_7057_ = true;
                            phi_7058_ = false;
                        }
                        let _e4317 = phi_7048_;
                        let _e4319 = phi_2123_;
                        let _e4321 = phi_2125_;
                        let _e4323 = phi_2127_;
                        let _e4325 = phi_7049_;
                        let _e4327 = phi_7050_;
                        let _e4329 = phi_7051_;
                        let _e4331 = phi_7052_;
                        let _e4333 = phi_7053_;
                        let _e4335 = phi_7054_;
                        let _e4337 = phi_7055_;
                        let _e4339 = phi_7056_;
                        let _e4341 = phi_7057_;
                        let _e4343 = phi_7058_;
                        local_41 = _e4335;
                        local_42 = _e4337;
                        local_43 = _e4335;
                        local_44 = _e4339;
                        local_45 = _e4335;
                        local_46 = _e4341;
                        local_47 = _e4335;
                        local_48 = _e4343;
                        local_49 = _e4325;
                        local_50 = _e4325;
                        local_51 = _e4327;
                        local_52 = _e4325;
                        local_62 = _e4335;
                        local_53 = _e4331;
                        local_55 = _e4329;
                        local_56 = _e4317;
                        continue;
                        continuing {
                            phi_2119_ = _e1341;
                            phi_2122_ = _e4319;
                            phi_2124_ = _e4321;
                            phi_2126_ = _e4323;
                            break if !(_e4333);
                        }
                    }
                    let _e4346 = local_41;
                    let _e4348 = local_42;
                    let _e4349 = select(_e4348, false, _e4346);
                    let _e4351 = local_43;
                    let _e4353 = local_44;
                    let _e4356 = local_45;
                    let _e4358 = local_46;
                    let _e4361 = local_47;
                    let _e4363 = local_48;
                    if _e4349 {
                        let _e4366 = local_49;
                        if (_e4366.member_1 >= _e382) {
                            phi_7087_ = type_35(type_34(0u, f32()), 0u);
                        } else {
                            let _e4370 = local_50;
                            let _e4374 = local_51;
                            let _e4377 = local_52;
                            phi_7087_ = type_35(type_34(2u, _e4377.member_1), select(_e4374, 0u, (_e4370.member_1 > _e380)));
                        }
                        let _e4384 = phi_7087_;
                        phi_7088_ = _e4384;
                        phi_7089_ = false;
                        phi_7090_ = false;
                        phi_7091_ = false;
                        phi_7092_ = false;
                    } else {
                        phi_7088_ = type_35();
                        phi_7089_ = select(_e4353, false, _e4351);
                        let _e5258 = local_62;
                        phi_7090_ = _e5258;
                        phi_7091_ = select(_e4358, false, _e4356);
                        phi_7092_ = select(_e4363, false, _e4361);
                    }
                    let _e4386 = phi_7088_;
                    let _e4388 = phi_7089_;
                    let _e4390 = phi_7090_;
                    let _e4392 = phi_7091_;
                    let _e4394 = phi_7092_;
                    let _e4396 = local_53;
                    let _e4398 = local_54;
                    let _e4401 = local_55;
                    let _e4403 = local_56;
                    let _e4405 = select(_e4390, true, _e4388);
                    let _e4410 = local_57;
                    let _e4411 = select(_e4410, select(_e4403, _e4401, _e4388), _e4405);
                    let _e4413 = local_58;
                    let _e4414 = select(_e4413, select(_e4398, _e4396, _e4388), _e4405);
                    if select(select(_e4392, false, _e4388), true, _e4405) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_7124_ = type_9(0u, 3u);
                        loop {
                            let _e4425 = phi_7124_;
                            let _e4428 = (_e4425.member < _e4425.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4428)) != 0i) {
                                let _e4443 = local[select(type_9().member_1, _e4425.member, _e4428)];
                                let _e4445 = (_e4411 + (select(0f, _e378, (_e378 >= (0.000000059604645f * 8f))) * _e4443));
                                let _e4447 = select(_e382, _e4445, (_e4445 < _e382));
                                let _e4450 = local_5.member[0u];
                                let _e4456 = local_5.member[1u];
                                let _e4472 = local_5.member_1[0u];
                                let _e4478 = local_5.member_1[1u];
                                let _e4494 = local_5.member_2[0u];
                                let _e4500 = local_5.member_2[1u];
                                let _e4514 = function_3(array<f32, 3>((_e4450[0] + ((_e4456[0] - _e4450[0]) * _e4447)), (_e4450[1] + ((_e4456[1] - _e4450[1]) * _e4447)), (_e4450[2] + ((_e4456[2] - _e4450[2]) * _e4447))), array<f32, 3>((_e4472[0] + ((_e4478[0] - _e4472[0]) * _e4447)), (_e4472[1] + ((_e4478[1] - _e4472[1]) * _e4447)), (_e4472[2] + ((_e4478[2] - _e4472[2]) * _e4447))), array<f32, 3>((_e4494[0] + ((_e4500[0] - _e4494[0]) * _e4447)), (_e4494[1] + ((_e4500[1] - _e4494[1]) * _e4447)), (_e4494[2] + ((_e4500[2] - _e4494[2]) * _e4447))), _e225.member);
                                let _e4525 = (((_e4514[0] * _e4514[0]) + (_e4514[1] * _e4514[1])) + (_e4514[2] * _e4514[2]));
                                if (_e4525 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_7356_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4525 > 0f));
                                } else {
                                    phi_7299_ = type_14(0i, 5i);
                                    phi_7302_ = bitcast<f32>(((bitcast<u32>(_e4525) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e4533 = phi_7299_;
                                        let _e4535 = phi_7302_;
                                        local_59 = _e4535;
                                        if (_e4533.member < _e4533.member_1) {
                                            let _e4542 = (_e4533.member + 1i);
                                            phi_7300_ = type_14(select(_e4542, type_15().member_1, select(false, true, ((false == (_e4542 > _e4533.member)) != false))), _e4533.member_1);
                                            phi_7343_ = type_15(1u, _e4533.member);
                                        } else {
                                            phi_7300_ = _e4533;
                                            phi_7343_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e4553 = phi_7300_;
                                        let _e4555 = phi_7343_;
                                        let _e4558 = (bitcast<i32>(_e4555.member) != 0i);
                                        if _e4558 {
                                            phi_7303_ = (0.5f * (_e4535 + (_e4525 / _e4535)));
                                        } else {
                                            phi_7303_ = f32();
                                        }
                                        let _e4563 = phi_7303_;
                                        continue;
                                        continuing {
                                            phi_7299_ = _e4553;
                                            phi_7302_ = _e4563;
                                            break if !(_e4558);
                                        }
                                    }
                                    let _e4568 = local_59;
                                    phi_7356_ = (_e4568 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e4574 = phi_7356_;
                                let _e4580 = local_5.member[0u];
                                let _e4586 = select(_e4580[0], -(_e4580[0]), (_e4580[0] < 0f));
                                let _e4589 = select(_e4580[1], -(_e4580[1]), (_e4580[1] < 0f));
                                let _e4591 = select(_e4589, _e4586, (_e4586 > _e4589));
                                let _e4594 = select(_e4580[2], -(_e4580[2]), (_e4580[2] < 0f));
                                let _e4596 = select(_e4594, _e4591, (_e4591 > _e4594));
                                let _e4599 = local_5.member[1u];
                                let _e4605 = select(_e4599[0], -(_e4599[0]), (_e4599[0] < 0f));
                                let _e4608 = select(_e4599[1], -(_e4599[1]), (_e4599[1] < 0f));
                                let _e4610 = select(_e4608, _e4605, (_e4605 > _e4608));
                                let _e4613 = select(_e4599[2], -(_e4599[2]), (_e4599[2] < 0f));
                                let _e4615 = select(_e4613, _e4610, (_e4610 > _e4613));
                                let _e4619 = local_5.member_3;
                                let _e4623 = local_5.member_1[0u];
                                let _e4629 = select(_e4623[0], -(_e4623[0]), (_e4623[0] < 0f));
                                let _e4632 = select(_e4623[1], -(_e4623[1]), (_e4623[1] < 0f));
                                let _e4634 = select(_e4632, _e4629, (_e4629 > _e4632));
                                let _e4637 = select(_e4623[2], -(_e4623[2]), (_e4623[2] < 0f));
                                let _e4639 = select(_e4637, _e4634, (_e4634 > _e4637));
                                let _e4642 = local_5.member_1[1u];
                                let _e4648 = select(_e4642[0], -(_e4642[0]), (_e4642[0] < 0f));
                                let _e4651 = select(_e4642[1], -(_e4642[1]), (_e4642[1] < 0f));
                                let _e4653 = select(_e4651, _e4648, (_e4648 > _e4651));
                                let _e4656 = select(_e4642[2], -(_e4642[2]), (_e4642[2] < 0f));
                                let _e4658 = select(_e4656, _e4653, (_e4653 > _e4656));
                                let _e4662 = local_5.member_3;
                                let _e4666 = local_5.member_2[0u];
                                let _e4672 = select(_e4666[0], -(_e4666[0]), (_e4666[0] < 0f));
                                let _e4675 = select(_e4666[1], -(_e4666[1]), (_e4666[1] < 0f));
                                let _e4677 = select(_e4675, _e4672, (_e4672 > _e4675));
                                let _e4680 = select(_e4666[2], -(_e4666[2]), (_e4666[2] < 0f));
                                let _e4682 = select(_e4680, _e4677, (_e4677 > _e4680));
                                let _e4685 = local_5.member_2[1u];
                                let _e4691 = select(_e4685[0], -(_e4685[0]), (_e4685[0] < 0f));
                                let _e4694 = select(_e4685[1], -(_e4685[1]), (_e4685[1] < 0f));
                                let _e4696 = select(_e4694, _e4691, (_e4691 > _e4694));
                                let _e4699 = select(_e4685[2], -(_e4685[2]), (_e4685[2] < 0f));
                                let _e4701 = select(_e4699, _e4696, (_e4696 > _e4699));
                                let _e4705 = local_5.member_3;
                                let _e4712 = local_5.member_3;
                                let _e4719 = (((_e4574 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4615, _e4596, (_e4596 > _e4615)) + _e4619) + (select(_e4658, _e4639, (_e4639 > _e4658)) + _e4662)) + (select(_e4701, _e4682, (_e4682 > _e4701)) + _e4705)) * (0.000000059604645f * 16f)) + (_e4712 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e609.member_1);
                                phi_7627_ = select(true, false, _e4719);
                                phi_7628_ = _e4719;
                            } else {
                                phi_7627_ = false;
                                phi_7628_ = false;
                            }
                            let _e4722 = phi_7627_;
                            let _e4724 = phi_7628_;
                            local_60 = _e4724;
                            continue;
                            continuing {
                                phi_7124_ = type_9(select(_e4425.member, (_e4425.member + 1u), _e4428), select(_e4425.member_1, _e4425.member_1, _e4428));
                                break if !(_e4722);
                            }
                        }
                        let _e4727 = local_60;
                        if _e4727 {
                            phi_7640_ = type_35(type_34(1u, _e4411), select(_e4414, 1u, (_e4411 > _e380)));
                            phi_7641_ = false;
                        } else {
                            phi_7640_ = type_35();
                            phi_7641_ = true;
                        }
                        let _e4733 = phi_7640_;
                        let _e4735 = phi_7641_;
                        if _e4735 {
                            phi_7653_ = type_35(type_34(2u, _e4411), select(_e4414, 0u, (_e4411 > _e380)));
                        } else {
                            phi_7653_ = _e4733;
                        }
                        let _e4741 = phi_7653_;
                        phi_7654_ = _e4741;
                        phi_7655_ = false;
                        phi_7656_ = false;
                    } else {
                        phi_7654_ = type_35();
                        phi_7655_ = select(select(_e4394, false, _e4388), false, _e4405);
                        phi_7656_ = select(select(_e4349, false, _e4388), false, _e4405);
                    }
                    let _e4743 = phi_7654_;
                    let _e4745 = phi_7655_;
                    let _e4747 = phi_7656_;
                    if _e4745 {
                        phi_7663_ = type_35(type_34(0u, f32()), 0u);
                        phi_7664_ = true;
                    } else {
                        phi_7663_ = _e4386;
                        phi_7664_ = _e4747;
                    }
                    let _e4751 = phi_7663_;
                    let _e4753 = phi_7664_;
                    phi_7668_ = _e4751;
                    phi_7669_ = _e4743;
                    phi_7670_ = _e4753;
                } else {
                    phi_7668_ = _e1313;
                    phi_7669_ = type_35();
                    phi_7670_ = true;
                }
                let _e4755 = phi_7668_;
                let _e4757 = phi_7669_;
                let _e4759 = phi_7670_;
                if _e4759 {
                    phi_7674_ = _e4755;
                } else {
                    phi_7674_ = _e4757;
                }
                let _e4761 = phi_7674_;
                switch bitcast<i32>(_e4761.member.member) {
                    case 0: {
                        phi_7692_ = type_32(0u, _e4761.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4772 = function_(_e4761.member.member_1);
                        phi_7692_ = type_32(0u, _e4761.member_1, _e4772, true);
                        break;
                    }
                    case 2: {
                        let _e4768 = function_(_e4761.member.member_1);
                        phi_7692_ = type_32(1u, _e4761.member_1, _e4768, true);
                        break;
                    }
                    default: {
                        phi_7692_ = type_32();
                        break;
                    }
                }
                let _e4776 = phi_7692_;
                let _e4780 = params.member.member.member_12;
                let _e4781 = bitcast<u32>(_e4780);
                if (_e4776.member_2[0] == select((_e4781 << bitcast<u32>(29i)), 0u, ((_e4781 & 2147483647u) < 8388608u))) {
                    let _e4791 = params.member.member.member_12;
                    let _e4792 = bitcast<u32>(_e4791);
                    let _e4793 = (_e4792 & 2147483647u);
                    phi_7732_ = (_e4776.member_2[1] == select(((_e4792 ^ _e4793) | ((_e4793 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4793 < 8388608u)));
                } else {
                    phi_7732_ = false;
                }
                let _e4803 = phi_7732_;
                let _e4805 = params.member.member.member_1;
                if ((_e4805 & 128u) != 0u) {
                    phi_7748_ = true;
                } else {
                    let _e4809 = params.member.member.member_1;
                    phi_7748_ = select(false, _e4803, ((_e4809 & 64u) != 0u));
                }
                let _e4814 = phi_7748_;
                local_6 = type_32(select(1u, _e4776.member, select(true, select(true, false, _e4814), _e4776.member_3)), _e4776.member_1, array<u32, 2>(_e4776.member_2[0], _e4776.member_2[1]), _e4776.member_3);
                phi_7775_ = type_9(_e183, _e186);
            } else {
                phi_7775_ = type_9(0u, 0u);
            }
            let _e4828 = phi_7775_;
            let _e4834 = local_6.member;
            let _e4836 = select(true, false, (_e4834 == 0u));
            let _e4838 = local_6.member_3;
            if _e4838 {
                if _e4836 {
                    phi_7804_ = true;
                } else {
                    let _e4840 = params.member.member.member_1;
                    phi_7804_ = ((_e4840 & 16u) != 0u);
                }
                let _e4844 = phi_7804_;
                phi_7805_ = _e4844;
            } else {
                phi_7805_ = false;
            }
            let _e4846 = phi_7805_;
            let _e4848 = local_6.member_3;
            if _e4848 {
                if _e4836 {
                } else {
                    let _e4850 = local_6.member_2;
                    let _e4854 = (_e4850[1] >> bitcast<u32>(20i));
                    let _e4868 = atomicMin((&earliest.member[0u]), select(((((_e4854 - 896u) << bitcast<u32>(23i)) | ((_e4850[1] & 1048575u) << bitcast<u32>(3i))) | (_e4850[0] >> bitcast<u32>(29i))), 0u, (_e4854 <= 896u)));
                }
            }
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4846 {
                let _e4872 = atomicAdd((&counters[0u]), 1u);
                phi_7848_ = _e4872;
            } else {
                phi_7848_ = 0u;
            }
            let _e4874 = phi_7848_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e4877 = atomicLoad((&counters[0u]));
                if (_e4877 > 0u) {
                    let _e4880 = atomicAdd((&contacts.member[0u]), _e4877);
                    atomicStore((&counters[1u]), _e4880);
                }
            }
            workgroupBarrier();
            let _e4883 = atomicLoad((&counters[1u]));
            let _e4884 = (_e4883 + _e4874);
            if _e4846 {
                let _e4886 = params.member.member_1.member_3;
                if (_e4884 < _e4886) {
                    let _e4892 = (7u * _e4884);
                    atomicStore((&contacts.member[(4u + _e4892)]), select(1u, 0u, ((_e4828.member_1 & 2147483648u) == 0u)));
                    let _e4897 = local_6.member;
                    atomicStore((&contacts.member[(_e4892 + 5u)]), _e4897);
                    atomicStore((&contacts.member[(_e4892 + 6u)]), _e4828.member);
                    atomicStore((&contacts.member[(_e4892 + 7u)]), (_e4828.member_1 & 2147483647u));
                    let _e4906 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e4892 + 8u)]), _e4906);
                    let _e4911 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e4892 + 9u)]), _e4911);
                    let _e4915 = local_6.member_1;
                    atomicStore((&contacts.member[(_e4892 + 10u)]), _e4915);
                }
            }
        }
        continue;
        continuing {
            phi_284_ = type_9(select(_e154.member, (_e154.member + 1u), _e157), select(_e154.member_1, _e154.member_1, _e157));
            break if !(_e170);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
