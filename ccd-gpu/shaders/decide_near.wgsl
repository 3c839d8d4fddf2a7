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
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
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

struct type_28 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_29 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_30 {
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_31 {
    member: type_7,
    member_1: type_8,
    member_2: type_30,
}

struct type_32 {
    member: type_31,
}

struct type_33 {
    member: type_26,
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

struct type_37 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_41 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_32;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_41;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_41;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_41;

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
    var phi_8384_: array<array<f32, 3>, 4>;

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
        phi_8384_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8384_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8384_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8012_: bool;
    var phi_8045_: array<f32, 3>;
    var phi_8046_: bool;
    var phi_8047_: array<f32, 3>;
    var phi_8048_: bool;
    var phi_8053_: array<f32, 3>;

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
        phi_8012_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8012_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8012_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8045_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8046_ = false;
        } else {
            phi_8045_ = array<f32, 3>();
            phi_8046_ = true;
        }
        let _e129 = phi_8045_;
        let _e131 = phi_8046_;
        phi_8047_ = _e129;
        phi_8048_ = _e131;
    } else {
        phi_8047_ = array<f32, 3>();
        phi_8048_ = true;
    }
    let _e133 = phi_8047_;
    let _e135 = phi_8048_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8053_ = _e136;
    } else {
        phi_8053_ = _e133;
    }
    let _e138 = phi_8053_;
    return _e138;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_28;
    var local_2: type_29;
    var local_3: type_29;
    var local_4: type_29;
    var local_5: type_26;
    var phi_226_: u32;
    var phi_271_: u32;
    var phi_274_: type_9;
    var phi_434_: type_20;
    var phi_569_: type_26;
    var phi_598_: bool;
    var phi_846_: bool;
    var phi_940_: type_33;
    var phi_941_: bool;
    var phi_942_: type_33;
    var phi_943_: bool;
    var phi_944_: type_33;
    var phi_945_: bool;
    var phi_950_: type_33;
    var phi_1120_: type_14;
    var phi_1123_: f32;
    var phi_1121_: type_14;
    var phi_1164_: type_15;
    var phi_1124_: f32;
    var local_6: f32;
    var phi_1177_: f32;
    var phi_2086_: type_35;
    var phi_2087_: bool;
    var phi_2088_: type_35;
    var phi_2089_: bool;
    var phi_2095_: type_14;
    var phi_2098_: f32;
    var phi_2100_: u32;
    var phi_2102_: f32;
    var phi_2096_: type_14;
    var phi_2143_: type_15;
    var phi_2580_: type_9;
    var phi_2583_: f32;
    var phi_2585_: f32;
    var phi_2587_: f32;
    var phi_2589_: f32;
    var phi_2591_: bool;
    var phi_2593_: u32;
    var phi_2744_: array<f32, 3>;
    var phi_2810_: type_14;
    var phi_2813_: f32;
    var phi_2811_: type_14;
    var phi_2854_: type_15;
    var phi_2814_: f32;
    var local_7: f32;
    var phi_2867_: f32;
    var phi_2990_: type_29;
    var phi_2991_: bool;
    var phi_2992_: type_29;
    var phi_2993_: bool;
    var phi_3001_: type_29;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3478_: bool;
    var phi_3479_: bool;
    var phi_3480_: bool;
    var phi_3481_: bool;
    var phi_3482_: bool;
    var phi_3483_: bool;
    var phi_3491_: bool;
    var phi_3598_: f32;
    var phi_3599_: bool;
    var phi_3600_: f32;
    var phi_3601_: bool;
    var phi_3602_: f32;
    var phi_3603_: bool;
    var phi_3604_: bool;
    var phi_3666_: f32;
    var phi_3667_: bool;
    var phi_3668_: f32;
    var phi_3669_: bool;
    var phi_3670_: f32;
    var phi_3671_: bool;
    var phi_3672_: bool;
    var phi_3739_: f32;
    var phi_3740_: bool;
    var phi_3741_: f32;
    var phi_3742_: bool;
    var phi_3743_: f32;
    var phi_3744_: bool;
    var phi_3745_: bool;
    var phi_3807_: f32;
    var phi_3808_: bool;
    var phi_3809_: f32;
    var phi_3810_: bool;
    var phi_3811_: f32;
    var phi_3812_: bool;
    var phi_3813_: bool;
    var phi_3987_: type_14;
    var phi_3990_: f32;
    var phi_3988_: type_14;
    var phi_4031_: type_15;
    var phi_3991_: f32;
    var local_8: f32;
    var phi_4044_: f32;
    var phi_4315_: bool;
    var phi_4316_: bool;
    var phi_4342_: f32;
    var phi_4343_: f32;
    var phi_4344_: bool;
    var phi_4345_: bool;
    var phi_4346_: f32;
    var phi_4347_: f32;
    var phi_4348_: f32;
    var phi_4349_: f32;
    var phi_4350_: bool;
    var phi_4351_: bool;
    var phi_4352_: bool;
    var phi_4353_: bool;
    var phi_4354_: f32;
    var phi_4355_: f32;
    var phi_4356_: f32;
    var phi_4357_: f32;
    var phi_4358_: bool;
    var phi_4359_: bool;
    var phi_4360_: bool;
    var phi_4361_: bool;
    var phi_4362_: bool;
    var phi_4363_: f32;
    var phi_4364_: f32;
    var phi_4365_: f32;
    var phi_4366_: f32;
    var phi_4367_: bool;
    var phi_4368_: bool;
    var phi_4369_: bool;
    var phi_4370_: bool;
    var phi_4371_: bool;
    var phi_4704_: f32;
    var phi_4706_: u32;
    var phi_4707_: f32;
    var phi_4708_: bool;
    var phi_4709_: bool;
    var phi_4710_: bool;
    var phi_4711_: u32;
    var phi_4712_: f32;
    var phi_4713_: f32;
    var phi_4714_: f32;
    var phi_4715_: f32;
    var phi_4716_: bool;
    var phi_4717_: u32;
    var phi_4718_: bool;
    var phi_4719_: bool;
    var phi_4720_: bool;
    var phi_4721_: bool;
    var phi_4722_: bool;
    var phi_4723_: bool;
    var phi_4751_: f32;
    var phi_4752_: f32;
    var phi_4753_: f32;
    var phi_4754_: f32;
    var phi_4755_: bool;
    var phi_4756_: u32;
    var phi_4757_: bool;
    var phi_4758_: bool;
    var phi_4759_: bool;
    var phi_4760_: bool;
    var phi_4761_: bool;
    var phi_4762_: bool;
    var phi_2584_: f32;
    var phi_2586_: f32;
    var phi_2588_: f32;
    var phi_2590_: f32;
    var phi_2592_: bool;
    var phi_2594_: u32;
    var phi_4763_: f32;
    var phi_4764_: f32;
    var phi_4765_: bool;
    var phi_4766_: bool;
    var phi_4767_: bool;
    var phi_4768_: bool;
    var phi_4769_: bool;
    var phi_4770_: bool;
    var phi_4771_: bool;
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
    var phi_4838_: f32;
    var phi_4839_: bool;
    var phi_5459_: type_14;
    var phi_5462_: f32;
    var phi_5460_: type_14;
    var phi_5503_: type_15;
    var phi_5463_: f32;
    var local_24: f32;
    var phi_5516_: f32;
    var phi_5751_: type_14;
    var phi_5754_: f32;
    var phi_5752_: type_14;
    var phi_5795_: type_15;
    var phi_5755_: f32;
    var local_25: f32;
    var phi_5808_: f32;
    var phi_5840_: type_14;
    var phi_5843_: f32;
    var phi_5841_: type_14;
    var phi_5884_: type_15;
    var phi_5844_: f32;
    var local_26: f32;
    var phi_5897_: f32;
    var phi_6205_: type_9;
    var phi_6208_: f32;
    var phi_6209_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_6307_: type_14;
    var phi_6310_: f32;
    var phi_6308_: type_14;
    var phi_6351_: type_15;
    var phi_6311_: f32;
    var local_29: f32;
    var phi_6364_: f32;
    var phi_6369_: type_9;
    var phi_6372_: f32;
    var phi_6374_: bool;
    var phi_6376_: bool;
    var phi_6606_: f32;
    var phi_6607_: f32;
    var phi_6373_: f32;
    var phi_6375_: bool;
    var phi_6377_: bool;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_6622_: type_36;
    var phi_6623_: bool;
    var local_36: bool;
    var phi_6644_: type_9;
    var phi_6647_: f32;
    var phi_6649_: f32;
    var phi_6756_: f32;
    var phi_6757_: f32;
    var phi_6758_: f32;
    var phi_6759_: f32;
    var phi_6648_: f32;
    var phi_6650_: f32;
    var local_37: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6920_: bool;
    var phi_6921_: bool;
    var phi_6922_: bool;
    var phi_6923_: bool;
    var phi_6924_: bool;
    var phi_6925_: bool;
    var phi_6934_: bool;
    var phi_6935_: bool;
    var phi_6942_: type_36;
    var phi_6943_: type_36;
    var phi_6944_: bool;
    var phi_6945_: type_36;
    var phi_6946_: type_36;
    var phi_6947_: bool;
    var phi_6952_: type_36;
    var phi_6953_: type_36;
    var phi_6954_: bool;
    var phi_6958_: type_36;
    var phi_6959_: type_36;
    var phi_6960_: bool;
    var phi_6961_: bool;
    var phi_6962_: type_36;
    var phi_6963_: type_36;
    var phi_6964_: bool;
    var phi_6965_: bool;
    var phi_6999_: f32;
    var phi_7000_: f32;
    var phi_7001_: bool;
    var phi_7002_: bool;
    var phi_7003_: bool;
    var phi_7004_: f32;
    var phi_7005_: u32;
    var phi_7006_: f32;
    var phi_7007_: type_36;
    var phi_7008_: u32;
    var phi_7009_: u32;
    var phi_7010_: bool;
    var phi_7011_: bool;
    var phi_7012_: bool;
    var phi_7013_: f32;
    var phi_7014_: u32;
    var phi_7015_: f32;
    var phi_7016_: type_36;
    var phi_7017_: u32;
    var phi_7018_: u32;
    var phi_7019_: bool;
    var phi_7020_: bool;
    var phi_7021_: bool;
    var phi_7022_: bool;
    var phi_7023_: bool;
    var phi_7024_: f32;
    var phi_2099_: f32;
    var phi_2101_: u32;
    var phi_2103_: f32;
    var phi_7025_: type_36;
    var phi_7026_: u32;
    var phi_7027_: f32;
    var phi_7028_: u32;
    var phi_7029_: bool;
    var phi_7030_: bool;
    var phi_7031_: bool;
    var phi_7032_: bool;
    var phi_7033_: bool;
    var phi_7034_: bool;
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
    var phi_7063_: type_35;
    var phi_7064_: type_35;
    var phi_7065_: bool;
    var phi_7066_: bool;
    var phi_7067_: bool;
    var phi_7068_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: u32;
    var phi_7100_: type_9;
    var phi_7275_: type_14;
    var phi_7278_: f32;
    var phi_7276_: type_14;
    var phi_7319_: type_15;
    var phi_7279_: f32;
    var local_58: f32;
    var phi_7332_: f32;
    var phi_7603_: bool;
    var phi_7604_: bool;
    var local_59: bool;
    var phi_7616_: type_35;
    var phi_7617_: bool;
    var phi_7629_: type_35;
    var phi_7630_: type_35;
    var phi_7631_: bool;
    var phi_7632_: bool;
    var phi_7639_: type_35;
    var phi_7640_: bool;
    var phi_7644_: type_35;
    var phi_7645_: type_35;
    var phi_7646_: bool;
    var phi_7650_: type_35;
    var phi_7668_: type_37;
    var phi_7708_: bool;
    var phi_7724_: bool;
    var phi_7767_: u32;
    var phi_7771_: type_17;
    var phi_7772_: bool;
    var phi_7773_: bool;
    var phi_7792_: u32;
    var phi_7859_: u32;
    var local_60: bool;
    var local_61: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e97 = id_2;
    let _e98 = n_2;
    let _e99 = lane_2;
    let _e111 = ((_e97.y * _e98.x) + _e97.x);
    let _e114 = (_e98.x * _e98.y);
    let _e117 = params.member.member_1.member_2;
    let _e119 = input.member[0u];
    let _e121 = select(_e119, _e117, (_e117 < _e119));
    let _e123 = params.member.member_1.member_1;
    if (_e121 > _e123) {
        let _e126 = params.member.member_1.member_1;
        phi_226_ = (_e121 - _e126);
    } else {
        phi_226_ = 0u;
    }
    let _e129 = phi_226_;
    let _e131 = params.member.member_1.member;
    let _e133 = select(_e129, _e131, (_e131 < _e129));
    let _e134 = (_e133 / 64u);
    let _e138 = select(_e134, (_e134 + 1u), ((_e133 % 64u) > 0u));
    if (_e138 > _e111) {
        let _e140 = (_e138 - _e111);
        if (_e114 == 0u) {
            return;
        }
        let _e142 = (_e140 / _e114);
        if (_e114 == 0u) {
            return;
        }
        phi_271_ = select(_e142, (_e142 + 1u), ((_e140 % _e114) > 0u));
    } else {
        phi_271_ = 0u;
    }
    let _e149 = phi_271_;
    phi_274_ = type_9(0u, _e149);
    loop {
        let _e152 = phi_274_;
        let _e155 = (_e152.member < _e152.member_1);
        let _e168 = (bitcast<i32>(select(0u, 1u, _e155)) != 0i);
        if _e168 {
            let _e172 = (((_e111 + (select(type_9().member_1, _e152.member, _e155) * _e114)) * 64u) + _e99);
            let _e176 = params.member.member_2.member.member;
            if (_e172 < _e133) {
                let _e181 = params.member.member_1.member_1;
                let _e183 = (2u * (_e181 + _e172));
                let _e186 = input.member[(4u + _e183)];
                let _e189 = input.member[(_e183 + 5u)];
                let _e194 = params.member.member_2.member.member;
                if (_e194 == 0u) {
                    let _e210 = (3u * _e189);
                    let _e212 = elements.member[_e210];
                    let _e215 = elements.member[(_e210 + 1u)];
                    let _e218 = elements.member[(_e210 + 2u)];
                    phi_434_ = type_20(0u, array<u32, 4>(_e186, _e212, _e215, _e218));
                } else {
                    let _e196 = (2u * _e186);
                    let _e197 = (2u * _e189);
                    let _e199 = elements.member[_e196];
                    let _e201 = elements.member[_e197];
                    let _e204 = elements.member[(_e196 + 1u)];
                    let _e207 = elements.member[(_e197 + 1u)];
                    phi_434_ = type_20(1u, array<u32, 4>(_e199, _e204, _e201, _e207));
                }
                let _e222 = phi_434_;
                let _e227 = paths.member[_e222.member_1[0]];
                let _e242 = paths.member[_e222.member_1[1]];
                let _e257 = paths.member[_e222.member_1[2]];
                let _e272 = paths.member[_e222.member_1[3]];
                let _e286 = params.member.member.member_4;
                if (_e222.member != 0u) {
                    phi_569_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e257.member.x - _e227.member.x), (_e257.member.y - _e227.member.y), (_e257.member.z - _e227.member.z)), array<f32, 3>((_e257.member_1.x - _e227.member_1.x), (_e257.member_1.y - _e227.member_1.y), (_e257.member_1.z - _e227.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e242.member.x - _e227.member.x), (_e242.member.y - _e227.member.y), (_e242.member.z - _e227.member.z)), array<f32, 3>((_e242.member_1.x - _e227.member_1.x), (_e242.member_1.y - _e227.member_1.y), (_e242.member_1.z - _e227.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e257.member.x - _e272.member.x), (_e257.member.y - _e272.member.y), (_e257.member.z - _e272.member.z)), array<f32, 3>((_e257.member_1.x - _e272.member_1.x), (_e257.member_1.y - _e272.member_1.y), (_e257.member_1.z - _e272.member_1.z))), (_e286 + _e286));
                } else {
                    phi_569_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e227.member.x - _e242.member.x), (_e227.member.y - _e242.member.y), (_e227.member.z - _e242.member.z)), array<f32, 3>((_e227.member_1.x - _e242.member_1.x), (_e227.member_1.y - _e242.member_1.y), (_e227.member_1.z - _e242.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e257.member.x - _e242.member.x), (_e257.member.y - _e242.member.y), (_e257.member.z - _e242.member.z)), array<f32, 3>((_e257.member_1.x - _e242.member_1.x), (_e257.member_1.y - _e242.member_1.y), (_e257.member_1.z - _e242.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e272.member.x - _e242.member.x), (_e272.member.y - _e242.member.y), (_e272.member.z - _e242.member.z)), array<f32, 3>((_e272.member_1.x - _e242.member_1.x), (_e272.member_1.y - _e242.member_1.y), (_e272.member_1.z - _e242.member_1.z))), (_e286 + _e286));
                }
                let _e347 = phi_569_;
                let _e349 = params.member.member.member_12;
                let _e350 = bitcast<u32>(_e349);
                let _e351 = (_e350 & 2147483647u);
                let _e352 = (_e351 < 8388608u);
                let _e364 = params.member.member.member_15[0u];
                if (select((_e350 << bitcast<u32>(29i)), 0u, _e352) == _e364) {
                    let _e368 = params.member.member.member_15[1u];
                    phi_598_ = (select(((_e350 ^ _e351) | ((_e351 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e352) == _e368);
                } else {
                    phi_598_ = false;
                }
                let _e371 = phi_598_;
                let _e373 = params.member.member.member_5;
                let _e375 = params.member.member.member_11;
                let _e377 = params.member.member.member_12;
                let _e379 = params.member.member.member_13;
                let _e381 = params.member.member.member_1;
                let _e390 = select(_e347.member[0][0], -(_e347.member[0][0]), (_e347.member[0][0] < 0f));
                let _e394 = select(_e347.member[0][1], -(_e347.member[0][1]), (_e347.member[0][1] < 0f));
                let _e396 = select(_e394, _e390, (_e390 > _e394));
                let _e400 = select(_e347.member[0][2], -(_e347.member[0][2]), (_e347.member[0][2] < 0f));
                let _e402 = select(_e400, _e396, (_e396 > _e400));
                let _e408 = select(_e347.member[1][0], -(_e347.member[1][0]), (_e347.member[1][0] < 0f));
                let _e412 = select(_e347.member[1][1], -(_e347.member[1][1]), (_e347.member[1][1] < 0f));
                let _e414 = select(_e412, _e408, (_e408 > _e412));
                let _e418 = select(_e347.member[1][2], -(_e347.member[1][2]), (_e347.member[1][2] < 0f));
                let _e420 = select(_e418, _e414, (_e414 > _e418));
                let _e424 = (select(_e420, _e402, (_e402 > _e420)) + _e347.member_3);
                let _e430 = select(_e347.member_1[0][0], -(_e347.member_1[0][0]), (_e347.member_1[0][0] < 0f));
                let _e434 = select(_e347.member_1[0][1], -(_e347.member_1[0][1]), (_e347.member_1[0][1] < 0f));
                let _e436 = select(_e434, _e430, (_e430 > _e434));
                let _e440 = select(_e347.member_1[0][2], -(_e347.member_1[0][2]), (_e347.member_1[0][2] < 0f));
                let _e442 = select(_e440, _e436, (_e436 > _e440));
                let _e448 = select(_e347.member_1[1][0], -(_e347.member_1[1][0]), (_e347.member_1[1][0] < 0f));
                let _e452 = select(_e347.member_1[1][1], -(_e347.member_1[1][1]), (_e347.member_1[1][1] < 0f));
                let _e454 = select(_e452, _e448, (_e448 > _e452));
                let _e458 = select(_e347.member_1[1][2], -(_e347.member_1[1][2]), (_e347.member_1[1][2] < 0f));
                let _e460 = select(_e458, _e454, (_e454 > _e458));
                let _e464 = (select(_e460, _e442, (_e442 > _e460)) + _e347.member_3);
                let _e470 = select(_e347.member_2[0][0], -(_e347.member_2[0][0]), (_e347.member_2[0][0] < 0f));
                let _e474 = select(_e347.member_2[0][1], -(_e347.member_2[0][1]), (_e347.member_2[0][1] < 0f));
                let _e476 = select(_e474, _e470, (_e470 > _e474));
                let _e480 = select(_e347.member_2[0][2], -(_e347.member_2[0][2]), (_e347.member_2[0][2] < 0f));
                let _e482 = select(_e480, _e476, (_e476 > _e480));
                let _e488 = select(_e347.member_2[1][0], -(_e347.member_2[1][0]), (_e347.member_2[1][0] < 0f));
                let _e492 = select(_e347.member_2[1][1], -(_e347.member_2[1][1]), (_e347.member_2[1][1] < 0f));
                let _e494 = select(_e492, _e488, (_e488 > _e492));
                let _e498 = select(_e347.member_2[1][2], -(_e347.member_2[1][2]), (_e347.member_2[1][2] < 0f));
                let _e500 = select(_e498, _e494, (_e494 > _e498));
                let _e504 = (select(_e500, _e482, (_e482 > _e500)) + _e347.member_3);
                let _e506 = select(_e464, _e424, (_e424 > _e464));
                let _e508 = select(_e504, _e506, (_e506 > _e504));
                if (_e508 <= 65536f) {
                    phi_846_ = (_e508 >= (1f / 65536f));
                } else {
                    phi_846_ = false;
                }
                let _e513 = phi_846_;
                if _e513 {
                    phi_944_ = type_33();
                    phi_945_ = true;
                } else {
                    if (_e508 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e508) & 2139095040u) != 2139095040u) {
                            let _e520 = (2130706432u - (bitcast<u32>(_e508) & 2139095040u));
                            let _e523 = bitcast<f32>(select(8388608u, _e520, (_e520 > 8388608u)));
                            let _e524 = (_e373 * _e523);
                            phi_940_ = type_33(type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e347.member[0][0] * _e523), (_e347.member[0][1] * _e523), (_e347.member[0][2] * _e523)), array<f32, 3>((_e347.member[1][0] * _e523), (_e347.member[1][1] * _e523), (_e347.member[1][2] * _e523))), array<array<f32, 3>, 2>(array<f32, 3>((_e347.member_1[0][0] * _e523), (_e347.member_1[0][1] * _e523), (_e347.member_1[0][2] * _e523)), array<f32, 3>((_e347.member_1[1][0] * _e523), (_e347.member_1[1][1] * _e523), (_e347.member_1[1][2] * _e523))), array<array<f32, 3>, 2>(array<f32, 3>((_e347.member_2[0][0] * _e523), (_e347.member_2[0][1] * _e523), (_e347.member_2[0][2] * _e523)), array<f32, 3>((_e347.member_2[1][0] * _e523), (_e347.member_2[1][1] * _e523), (_e347.member_2[1][2] * _e523))), ((_e347.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e523)), select(_e524, select(0.000000000000000000000000000000000000011754944f, _e524, (_e524 > 0.000000000000000000000000000000000000011754944f)), (_e373 > 0f)));
                            phi_941_ = false;
                        } else {
                            phi_940_ = type_33();
                            phi_941_ = true;
                        }
                        let _e593 = phi_940_;
                        let _e595 = phi_941_;
                        phi_942_ = _e593;
                        phi_943_ = _e595;
                    } else {
                        phi_942_ = type_33();
                        phi_943_ = true;
                    }
                    let _e597 = phi_942_;
                    let _e599 = phi_943_;
                    phi_944_ = _e597;
                    phi_945_ = _e599;
                }
                let _e601 = phi_944_;
                let _e603 = phi_945_;
                if _e603 {
                    phi_950_ = type_33(_e347, _e373);
                } else {
                    phi_950_ = _e601;
                }
                let _e606 = phi_950_;
                local_5 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e606.member.member[0][0], _e606.member.member[0][1], _e606.member.member[0][2]), array<f32, 3>(_e606.member.member[1][0], _e606.member.member[1][1], _e606.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e606.member.member_1[0][0], _e606.member.member_1[0][1], _e606.member.member_1[0][2]), array<f32, 3>(_e606.member.member_1[1][0], _e606.member.member_1[1][1], _e606.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e606.member.member_2[0][0], _e606.member.member_2[0][1], _e606.member.member_2[0][2]), array<f32, 3>(_e606.member.member_2[1][0], _e606.member.member_2[1][1], _e606.member.member_2[1][2])), _e606.member.member_3);
                let _e649 = local_5.member[0u];
                let _e655 = local_5.member[1u];
                let _e671 = local_5.member_1[0u];
                let _e677 = local_5.member_1[1u];
                let _e693 = local_5.member_2[0u];
                let _e699 = local_5.member_2[1u];
                let _e713 = function_3(array<f32, 3>((_e649[0] + ((_e655[0] - _e649[0]) * _e377)), (_e649[1] + ((_e655[1] - _e649[1]) * _e377)), (_e649[2] + ((_e655[2] - _e649[2]) * _e377))), array<f32, 3>((_e671[0] + ((_e677[0] - _e671[0]) * _e377)), (_e671[1] + ((_e677[1] - _e671[1]) * _e377)), (_e671[2] + ((_e677[2] - _e671[2]) * _e377))), array<f32, 3>((_e693[0] + ((_e699[0] - _e693[0]) * _e377)), (_e693[1] + ((_e699[1] - _e693[1]) * _e377)), (_e693[2] + ((_e699[2] - _e693[2]) * _e377))), _e222.member);
                let _e724 = (((_e713[0] * _e713[0]) + (_e713[1] * _e713[1])) + (_e713[2] * _e713[2]));
                if (_e724 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1177_ = select(0f, (0.000000000000000000106433627f * 2f), (_e724 > 0f));
                } else {
                    phi_1120_ = type_14(0i, 5i);
                    phi_1123_ = bitcast<f32>(((bitcast<u32>(_e724) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e732 = phi_1120_;
                        let _e734 = phi_1123_;
                        local_6 = _e734;
                        if (_e732.member < _e732.member_1) {
                            let _e741 = (_e732.member + 1i);
                            phi_1121_ = type_14(select(_e741, type_15().member_1, select(false, true, ((false == (_e741 > _e732.member)) != false))), _e732.member_1);
                            phi_1164_ = type_15(1u, _e732.member);
                        } else {
                            phi_1121_ = _e732;
                            phi_1164_ = type_15(0u, type_15().member_1);
                        }
                        let _e752 = phi_1121_;
                        let _e754 = phi_1164_;
                        let _e757 = (bitcast<i32>(_e754.member) != 0i);
                        if _e757 {
                            phi_1124_ = (0.5f * (_e734 + (_e724 / _e734)));
                        } else {
                            phi_1124_ = f32();
                        }
                        let _e762 = phi_1124_;
                        continue;
                        continuing {
                            phi_1120_ = _e752;
                            phi_1123_ = _e762;
                            break if !(_e757);
                        }
                    }
                    let _e767 = local_6;
                    phi_1177_ = (_e767 * (1f + (8f * 0.000000059604645f)));
                }
                let _e773 = phi_1177_;
                let _e779 = local_5.member[0u];
                let _e785 = select(_e779[0], -(_e779[0]), (_e779[0] < 0f));
                let _e788 = select(_e779[1], -(_e779[1]), (_e779[1] < 0f));
                let _e790 = select(_e788, _e785, (_e785 > _e788));
                let _e793 = select(_e779[2], -(_e779[2]), (_e779[2] < 0f));
                let _e795 = select(_e793, _e790, (_e790 > _e793));
                let _e798 = local_5.member[1u];
                let _e804 = select(_e798[0], -(_e798[0]), (_e798[0] < 0f));
                let _e807 = select(_e798[1], -(_e798[1]), (_e798[1] < 0f));
                let _e809 = select(_e807, _e804, (_e804 > _e807));
                let _e812 = select(_e798[2], -(_e798[2]), (_e798[2] < 0f));
                let _e814 = select(_e812, _e809, (_e809 > _e812));
                let _e818 = local_5.member_3;
                let _e822 = local_5.member_1[0u];
                let _e828 = select(_e822[0], -(_e822[0]), (_e822[0] < 0f));
                let _e831 = select(_e822[1], -(_e822[1]), (_e822[1] < 0f));
                let _e833 = select(_e831, _e828, (_e828 > _e831));
                let _e836 = select(_e822[2], -(_e822[2]), (_e822[2] < 0f));
                let _e838 = select(_e836, _e833, (_e833 > _e836));
                let _e841 = local_5.member_1[1u];
                let _e847 = select(_e841[0], -(_e841[0]), (_e841[0] < 0f));
                let _e850 = select(_e841[1], -(_e841[1]), (_e841[1] < 0f));
                let _e852 = select(_e850, _e847, (_e847 > _e850));
                let _e855 = select(_e841[2], -(_e841[2]), (_e841[2] < 0f));
                let _e857 = select(_e855, _e852, (_e852 > _e855));
                let _e861 = local_5.member_3;
                let _e865 = local_5.member_2[0u];
                let _e871 = select(_e865[0], -(_e865[0]), (_e865[0] < 0f));
                let _e874 = select(_e865[1], -(_e865[1]), (_e865[1] < 0f));
                let _e876 = select(_e874, _e871, (_e871 > _e874));
                let _e879 = select(_e865[2], -(_e865[2]), (_e865[2] < 0f));
                let _e881 = select(_e879, _e876, (_e876 > _e879));
                let _e884 = local_5.member_2[1u];
                let _e890 = select(_e884[0], -(_e884[0]), (_e884[0] < 0f));
                let _e893 = select(_e884[1], -(_e884[1]), (_e884[1] < 0f));
                let _e895 = select(_e893, _e890, (_e890 > _e893));
                let _e898 = select(_e884[2], -(_e884[2]), (_e884[2] < 0f));
                let _e900 = select(_e898, _e895, (_e895 > _e898));
                let _e904 = local_5.member_3;
                let _e911 = local_5.member_3;
                let _e918 = (((_e773 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e814, _e795, (_e795 > _e814)) + _e818) + (select(_e857, _e838, (_e838 > _e857)) + _e861)) + (select(_e900, _e881, (_e881 > _e900)) + _e904)) * (0.000000059604645f * 16f)) + (_e911 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e606.member_1);
                if _e918 {
                    phi_2088_ = type_35();
                    phi_2089_ = true;
                } else {
                    let _e921 = local_5.member_1[0u];
                    let _e927 = local_5.member_2[0u];
                    let _e933 = ((_e921[1] * _e927[2]) - (_e921[2] * _e927[1]));
                    let _e936 = ((_e921[2] * _e927[0]) - (_e921[0] * _e927[2]));
                    let _e939 = ((_e921[0] * _e927[1]) - (_e921[1] * _e927[0]));
                    let _e942 = local_5.member_1[1u];
                    let _e948 = local_5.member_2[1u];
                    let _e954 = ((_e942[1] * _e948[2]) - (_e942[2] * _e948[1]));
                    let _e957 = ((_e942[2] * _e948[0]) - (_e942[0] * _e948[2]));
                    let _e960 = ((_e942[0] * _e948[1]) - (_e942[1] * _e948[0]));
                    let _e963 = local_5.member_1[0u];
                    let _e969 = local_5.member_2[1u];
                    let _e984 = local_5.member_1[1u];
                    let _e990 = local_5.member_2[0u];
                    let _e1003 = (((_e963[1] * _e969[2]) - (_e963[2] * _e969[1])) + ((_e984[1] * _e990[2]) - (_e984[2] * _e990[1])));
                    let _e1004 = (((_e963[2] * _e969[0]) - (_e963[0] * _e969[2])) + ((_e984[2] * _e990[0]) - (_e984[0] * _e990[2])));
                    let _e1005 = (((_e963[0] * _e969[1]) - (_e963[1] * _e969[0])) + ((_e984[0] * _e990[1]) - (_e984[1] * _e990[0])));
                    let _e1008 = local_5.member[0u];
                    let _e1019 = local_5.member[1u];
                    let _e1030 = local_5.member[0u];
                    let _e1039 = ((((_e1019[0] * _e933) + (_e1019[1] * _e936)) + (_e1019[2] * _e939)) + (((_e1030[0] * _e1003) + (_e1030[1] * _e1004)) + (_e1030[2] * _e1005)));
                    let _e1042 = local_5.member[0u];
                    let _e1053 = local_5.member[1u];
                    let _e1062 = ((((_e1042[0] * _e954) + (_e1042[1] * _e957)) + (_e1042[2] * _e960)) + (((_e1053[0] * _e1003) + (_e1053[1] * _e1004)) + (_e1053[2] * _e1005)));
                    let _e1065 = local_5.member[1u];
                    let _e1076 = local_5.member[0u];
                    let _e1082 = select(_e1076[0], -(_e1076[0]), (_e1076[0] < 0f));
                    let _e1085 = select(_e1076[1], -(_e1076[1]), (_e1076[1] < 0f));
                    let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                    let _e1090 = select(_e1076[2], -(_e1076[2]), (_e1076[2] < 0f));
                    let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                    let _e1095 = local_5.member[1u];
                    let _e1101 = select(_e1095[0], -(_e1095[0]), (_e1095[0] < 0f));
                    let _e1104 = select(_e1095[1], -(_e1095[1]), (_e1095[1] < 0f));
                    let _e1106 = select(_e1104, _e1101, (_e1101 > _e1104));
                    let _e1109 = select(_e1095[2], -(_e1095[2]), (_e1095[2] < 0f));
                    let _e1111 = select(_e1109, _e1106, (_e1106 > _e1109));
                    let _e1115 = local_5.member_3;
                    let _e1116 = (select(_e1111, _e1092, (_e1092 > _e1111)) + _e1115);
                    let _e1119 = local_5.member_1[0u];
                    let _e1125 = select(_e1119[0], -(_e1119[0]), (_e1119[0] < 0f));
                    let _e1128 = select(_e1119[1], -(_e1119[1]), (_e1119[1] < 0f));
                    let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                    let _e1133 = select(_e1119[2], -(_e1119[2]), (_e1119[2] < 0f));
                    let _e1135 = select(_e1133, _e1130, (_e1130 > _e1133));
                    let _e1138 = local_5.member_1[1u];
                    let _e1144 = select(_e1138[0], -(_e1138[0]), (_e1138[0] < 0f));
                    let _e1147 = select(_e1138[1], -(_e1138[1]), (_e1138[1] < 0f));
                    let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                    let _e1152 = select(_e1138[2], -(_e1138[2]), (_e1138[2] < 0f));
                    let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                    let _e1158 = local_5.member_3;
                    let _e1159 = (select(_e1154, _e1135, (_e1135 > _e1154)) + _e1158);
                    let _e1162 = local_5.member_2[0u];
                    let _e1168 = select(_e1162[0], -(_e1162[0]), (_e1162[0] < 0f));
                    let _e1171 = select(_e1162[1], -(_e1162[1]), (_e1162[1] < 0f));
                    let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                    let _e1176 = select(_e1162[2], -(_e1162[2]), (_e1162[2] < 0f));
                    let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                    let _e1181 = local_5.member_2[1u];
                    let _e1187 = select(_e1181[0], -(_e1181[0]), (_e1181[0] < 0f));
                    let _e1190 = select(_e1181[1], -(_e1181[1]), (_e1181[1] < 0f));
                    let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                    let _e1195 = select(_e1181[2], -(_e1181[2]), (_e1181[2] < 0f));
                    let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                    let _e1201 = local_5.member_3;
                    let _e1202 = (select(_e1197, _e1178, (_e1178 > _e1197)) + _e1201);
                    let _e1204 = ((_e1159 * 8f) * _e1202);
                    let _e1211 = local_5.member_3;
                    let _e1235 = ((select(_e933, -(_e933), (_e933 < 0f)) + select(_e936, -(_e936), (_e936 < 0f))) + select(_e939, -(_e939), (_e939 < 0f)));
                    let _e1246 = ((select(_e954, -(_e954), (_e954 < 0f)) + select(_e957, -(_e957), (_e957 < 0f))) + select(_e960, -(_e960), (_e960 < 0f)));
                    let _e1248 = select(_e1246, _e1235, (_e1235 > _e1246));
                    let _e1260 = (((select(_e1003, -(_e1003), (_e1003 < 0f)) + select(_e1004, -(_e1004), (_e1004 < 0f))) + select(_e1005, -(_e1005), (_e1005 < 0f))) * 0.5f);
                    let _e1267 = local_5.member_3;
                    let _e1280 = ((((_e1008[0] * _e933) + (_e1008[1] * _e936)) + (_e1008[2] * _e939)) * 3f);
                    let _e1281 = ((((_e1065[0] * _e954) + (_e1065[1] * _e957)) + (_e1065[2] * _e960)) * 3f);
                    let _e1283 = select(_e1281, _e1280, (_e1280 < _e1281));
                    let _e1285 = select(_e1062, _e1039, (_e1039 < _e1062));
                    let _e1287 = select(_e1285, _e1283, (_e1283 < _e1285));
                    let _e1289 = select(_e1281, _e1280, (_e1280 > _e1281));
                    let _e1291 = select(_e1062, _e1039, (_e1039 > _e1062));
                    let _e1298 = -(select(_e1291, _e1289, (_e1289 > _e1291)));
                    if ((select(_e1298, _e1287, (_e1287 > _e1298)) - ((((((_e1116 * 8f) * _e1204) * (0.000000059604645f * (524f / 64f))) + ((_e1211 * 19f) * ((_e1116 * (_e1159 + _e1202)) + (_e1159 * _e1202)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1116) * ((1f + _e1159) * (1f + _e1202))))) + ((_e606.member_1 * (((select(_e1260, _e1248, (_e1248 > _e1260)) + (_e1204 * (0.000000059604645f * 8f))) + ((_e1267 * 6f) * (_e1159 + _e1202))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1159) * (1f + _e1202))))) * (3f * 1.0001f)))) > 0f) {
                        phi_2086_ = type_35(type_34(0u, f32()), 0u);
                        phi_2087_ = false;
                    } else {
                        phi_2086_ = type_35();
                        phi_2087_ = true;
                    }
                    let _e1306 = phi_2086_;
                    let _e1308 = phi_2087_;
                    phi_2088_ = _e1306;
                    phi_2089_ = _e1308;
                }
                let _e1310 = phi_2088_;
                let _e1312 = phi_2089_;
                if _e1312 {
                    phi_2095_ = type_14(0i, 2i);
                    phi_2098_ = _e377;
                    phi_2100_ = 0u;
                    phi_2102_ = _e377;
                    loop {
                        let _e1314 = phi_2095_;
                        let _e1316 = phi_2098_;
                        let _e1318 = phi_2100_;
                        let _e1320 = phi_2102_;
                        local_53 = _e1318;
                        local_56 = _e1316;
                        local_57 = _e1318;
                        if (_e1314.member < _e1314.member_1) {
                            let _e1327 = (_e1314.member + 1i);
                            phi_2096_ = type_14(select(_e1327, type_15().member_1, select(false, true, ((false == (_e1327 > _e1314.member)) != false))), _e1314.member_1);
                            phi_2143_ = type_15(1u, _e1314.member);
                        } else {
                            phi_2096_ = _e1314;
                            phi_2143_ = type_15(0u, type_15().member_1);
                        }
                        let _e1338 = phi_2096_;
                        let _e1340 = phi_2143_;
                        if (bitcast<i32>(_e1340.member) != 0i) {
                            if select(select(true, false, _e918), true, (_e1340.member_1 > 0i)) {
                                let _e1350 = local_5.member[0u];
                                let _e1356 = local_5.member_1[0u];
                                let _e1362 = local_5.member_2[0u];
                                let _e1366 = (_e1350[0] - _e1356[0]);
                                let _e1367 = (_e1350[1] - _e1356[1]);
                                let _e1368 = (_e1350[2] - _e1356[2]);
                                let _e1369 = (_e222.member == 0u);
                                let _e1381 = local_5.member[1u];
                                let _e1387 = local_5.member_1[1u];
                                let _e1393 = local_5.member_2[1u];
                                let _e1397 = (_e1381[0] - _e1387[0]);
                                let _e1398 = (_e1381[1] - _e1387[1]);
                                let _e1399 = (_e1381[2] - _e1387[2]);
                                let _e1400 = (_e222.member == 0u);
                                let _e1412 = local_5.member[0u];
                                let _e1418 = select(_e1412[0], -(_e1412[0]), (_e1412[0] < 0f));
                                let _e1421 = select(_e1412[1], -(_e1412[1]), (_e1412[1] < 0f));
                                let _e1423 = select(_e1421, _e1418, (_e1418 > _e1421));
                                let _e1426 = select(_e1412[2], -(_e1412[2]), (_e1412[2] < 0f));
                                let _e1428 = select(_e1426, _e1423, (_e1423 > _e1426));
                                let _e1431 = local_5.member[1u];
                                let _e1437 = select(_e1431[0], -(_e1431[0]), (_e1431[0] < 0f));
                                let _e1440 = select(_e1431[1], -(_e1431[1]), (_e1431[1] < 0f));
                                let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                let _e1445 = select(_e1431[2], -(_e1431[2]), (_e1431[2] < 0f));
                                let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                let _e1451 = local_5.member_3;
                                let _e1455 = local_5.member_1[0u];
                                let _e1461 = select(_e1455[0], -(_e1455[0]), (_e1455[0] < 0f));
                                let _e1464 = select(_e1455[1], -(_e1455[1]), (_e1455[1] < 0f));
                                let _e1466 = select(_e1464, _e1461, (_e1461 > _e1464));
                                let _e1469 = select(_e1455[2], -(_e1455[2]), (_e1455[2] < 0f));
                                let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                let _e1474 = local_5.member_1[1u];
                                let _e1480 = select(_e1474[0], -(_e1474[0]), (_e1474[0] < 0f));
                                let _e1483 = select(_e1474[1], -(_e1474[1]), (_e1474[1] < 0f));
                                let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                let _e1488 = select(_e1474[2], -(_e1474[2]), (_e1474[2] < 0f));
                                let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                let _e1494 = local_5.member_3;
                                let _e1498 = local_5.member_2[0u];
                                let _e1504 = select(_e1498[0], -(_e1498[0]), (_e1498[0] < 0f));
                                let _e1507 = select(_e1498[1], -(_e1498[1]), (_e1498[1] < 0f));
                                let _e1509 = select(_e1507, _e1504, (_e1504 > _e1507));
                                let _e1512 = select(_e1498[2], -(_e1498[2]), (_e1498[2] < 0f));
                                let _e1514 = select(_e1512, _e1509, (_e1509 > _e1512));
                                let _e1517 = local_5.member_2[1u];
                                let _e1523 = select(_e1517[0], -(_e1517[0]), (_e1517[0] < 0f));
                                let _e1526 = select(_e1517[1], -(_e1517[1]), (_e1517[1] < 0f));
                                let _e1528 = select(_e1526, _e1523, (_e1523 > _e1526));
                                let _e1531 = select(_e1517[2], -(_e1517[2]), (_e1517[2] < 0f));
                                let _e1533 = select(_e1531, _e1528, (_e1528 > _e1531));
                                let _e1537 = local_5.member_3;
                                let _e1544 = local_5.member_3;
                                let _e1549 = (_e375 * 0.00390625f);
                                local_3 = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_2580_ = type_9(0u, 96u);
                                phi_2583_ = _e1320;
                                phi_2585_ = _e1320;
                                phi_2587_ = (_e379 - _e1320);
                                phi_2589_ = _e1320;
                                phi_2591_ = false;
                                phi_2593_ = 0u;
                                loop {
                                    let _e1552 = phi_2580_;
                                    let _e1554 = phi_2583_;
                                    let _e1556 = phi_2585_;
                                    let _e1558 = phi_2587_;
                                    let _e1560 = phi_2589_;
                                    let _e1562 = phi_2591_;
                                    let _e1564 = phi_2593_;
                                    local_19 = _e1554;
                                    local_23 = _e1556;
                                    let _e1567 = (_e1552.member < _e1552.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1567)) != 0i) {
                                        let _e1581 = local_5.member[0u];
                                        let _e1587 = local_5.member[1u];
                                        let _e1603 = local_5.member_1[0u];
                                        let _e1609 = local_5.member_1[1u];
                                        let _e1625 = local_5.member_2[0u];
                                        let _e1631 = local_5.member_2[1u];
                                        let _e1645 = function_3(array<f32, 3>((_e1581[0] + ((_e1587[0] - _e1581[0]) * _e1554)), (_e1581[1] + ((_e1587[1] - _e1581[1]) * _e1554)), (_e1581[2] + ((_e1587[2] - _e1581[2]) * _e1554))), array<f32, 3>((_e1603[0] + ((_e1609[0] - _e1603[0]) * _e1554)), (_e1603[1] + ((_e1609[1] - _e1603[1]) * _e1554)), (_e1603[2] + ((_e1609[2] - _e1603[2]) * _e1554))), array<f32, 3>((_e1625[0] + ((_e1631[0] - _e1625[0]) * _e1554)), (_e1625[1] + ((_e1631[1] - _e1625[1]) * _e1554)), (_e1625[2] + ((_e1631[2] - _e1625[2]) * _e1554))), _e222.member);
                                        if (_e1564 == 0u) {
                                            phi_2744_ = _e1645;
                                        } else {
                                            phi_2744_ = array<f32, 3>(select(0f, _e1645[0], (_e1564 == 1u)), select(0f, _e1645[1], (_e1564 == 2u)), select(0f, _e1645[2], (_e1564 == 3u)));
                                        }
                                        let _e1658 = phi_2744_;
                                        let _e1672 = ((select(_e1658[0], -(_e1658[0]), (_e1658[0] < 0f)) + select(_e1658[1], -(_e1658[1]), (_e1658[1] < 0f))) + select(_e1658[2], -(_e1658[2]), (_e1658[2] < 0f)));
                                        if (_e1672 > 0f) {
                                            if ((bitcast<u32>(_e1672) & 2139095040u) != 2139095040u) {
                                                let _e1677 = (1f / _e1672);
                                                let _e1679 = (_e1658[0] * _e1677);
                                                let _e1681 = (_e1658[1] * _e1677);
                                                let _e1683 = (_e1658[2] * _e1677);
                                                let _e1688 = (((_e1679 * _e1679) + (_e1681 * _e1681)) + (_e1683 * _e1683));
                                                if (_e1688 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_2867_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1688 > 0f));
                                                } else {
                                                    phi_2810_ = type_14(0i, 5i);
                                                    phi_2813_ = bitcast<f32>(((bitcast<u32>(_e1688) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1696 = phi_2810_;
                                                        let _e1698 = phi_2813_;
                                                        local_7 = _e1698;
                                                        if (_e1696.member < _e1696.member_1) {
                                                            let _e1705 = (_e1696.member + 1i);
                                                            phi_2811_ = type_14(select(_e1705, type_15().member_1, select(false, true, ((false == (_e1705 > _e1696.member)) != false))), _e1696.member_1);
                                                            phi_2854_ = type_15(1u, _e1696.member);
                                                        } else {
                                                            phi_2811_ = _e1696;
                                                            phi_2854_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1716 = phi_2811_;
                                                        let _e1718 = phi_2854_;
                                                        let _e1721 = (bitcast<i32>(_e1718.member) != 0i);
                                                        if _e1721 {
                                                            phi_2814_ = (0.5f * (_e1698 + (_e1688 / _e1698)));
                                                        } else {
                                                            phi_2814_ = f32();
                                                        }
                                                        let _e1726 = phi_2814_;
                                                        continue;
                                                        continuing {
                                                            phi_2810_ = _e1716;
                                                            phi_2813_ = _e1726;
                                                            break if !(_e1721);
                                                        }
                                                    }
                                                    let _e1731 = local_7;
                                                    phi_2867_ = (_e1731 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1737 = phi_2867_;
                                                let _e1738 = (0.000000059604645f * 12f);
                                                let _e1743 = ((((((((select(_e1447, _e1428, (_e1428 > _e1447)) + _e1451) + (select(_e1490, _e1471, (_e1471 > _e1490)) + _e1494)) + (select(_e1533, _e1514, (_e1514 > _e1533)) + _e1537)) * (0.000000059604645f * 16f)) + (_e1544 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e606.member_1 * _e1737) * (1f + _e1738)));
                                                let _e1748 = (((_e1679 * _e1350[0]) + (_e1681 * _e1350[1])) + (_e1683 * _e1350[2]));
                                                let _e1753 = (((_e1679 * _e1366) + (_e1681 * _e1367)) + (_e1683 * _e1368));
                                                let _e1758 = (((_e1679 * (_e1350[0] - _e1362[0])) + (_e1681 * (_e1350[1] - _e1362[1]))) + (_e1683 * (_e1350[2] - _e1362[2])));
                                                let _e1763 = (((_e1679 * select((_e1366 - _e1362[0]), _e1350[0], _e1369)) + (_e1681 * select((_e1367 - _e1362[1]), _e1350[1], _e1369))) + (_e1683 * select((_e1368 - _e1362[2]), _e1350[2], _e1369)));
                                                let _e1769 = (((_e1679 * _e1381[0]) + (_e1681 * _e1381[1])) + (_e1683 * _e1381[2]));
                                                let _e1774 = (((_e1679 * _e1397) + (_e1681 * _e1398)) + (_e1683 * _e1399));
                                                let _e1779 = (((_e1679 * (_e1381[0] - _e1393[0])) + (_e1681 * (_e1381[1] - _e1393[1]))) + (_e1683 * (_e1381[2] - _e1393[2])));
                                                let _e1784 = (((_e1679 * select((_e1397 - _e1393[0]), _e1381[0], _e1400)) + (_e1681 * select((_e1398 - _e1393[1]), _e1381[1], _e1400))) + (_e1683 * select((_e1399 - _e1393[2]), _e1381[2], _e1400)));
                                                phi_2990_ = type_29(array<f32, 4>(_e1748, _e1753, _e1758, _e1763), array<f32, 4>(_e1769, _e1774, _e1779, _e1784), array<f32, 4>((_e1743 + ((select(_e1748, -(_e1748), (_e1748 < 0f)) + select(_e1769, -(_e1769), (_e1769 < 0f))) * _e1738)), (_e1743 + ((select(_e1753, -(_e1753), (_e1753 < 0f)) + select(_e1774, -(_e1774), (_e1774 < 0f))) * _e1738)), (_e1743 + ((select(_e1758, -(_e1758), (_e1758 < 0f)) + select(_e1779, -(_e1779), (_e1779 < 0f))) * _e1738)), (_e1743 + ((select(_e1763, -(_e1763), (_e1763 < 0f)) + select(_e1784, -(_e1784), (_e1784 < 0f))) * _e1738))));
                                                phi_2991_ = false;
                                            } else {
                                                phi_2990_ = type_29();
                                                phi_2991_ = true;
                                            }
                                            let _e1825 = phi_2990_;
                                            let _e1827 = phi_2991_;
                                            phi_2992_ = _e1825;
                                            phi_2993_ = _e1827;
                                        } else {
                                            phi_2992_ = type_29();
                                            phi_2993_ = true;
                                        }
                                        let _e1829 = phi_2992_;
                                        let _e1831 = phi_2993_;
                                        if _e1831 {
                                            phi_3001_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_3001_ = _e1829;
                                        }
                                        let _e1833 = phi_3001_;
                                        local_4 = type_29(array<f32, 4>(_e1833.member[0], _e1833.member[1], _e1833.member[2], _e1833.member[3]), array<f32, 4>(_e1833.member_1[0], _e1833.member_1[1], _e1833.member_1[2], _e1833.member_1[3]), array<f32, 4>(_e1833.member_2[0], _e1833.member_2[1], _e1833.member_2[2], _e1833.member_2[3]));
                                        let _e1853 = (_e1554 - _e1560);
                                        let _e1857 = local_4.member[0u];
                                        let _e1860 = local_4.member_1[0u];
                                        let _e1863 = local_4.member[0u];
                                        let _e1869 = local_4.member_2[0u];
                                        if (((_e1857 + ((_e1860 - _e1863) * _e1554)) - _e1869) > 0f) {
                                            let _e1874 = local_4.member[1u];
                                            let _e1877 = local_4.member_1[1u];
                                            let _e1880 = local_4.member[1u];
                                            let _e1886 = local_4.member_2[1u];
                                            if (((_e1874 + ((_e1877 - _e1880) * _e1554)) - _e1886) > 0f) {
                                                let _e1891 = local_4.member[2u];
                                                let _e1894 = local_4.member_1[2u];
                                                let _e1897 = local_4.member[2u];
                                                let _e1903 = local_4.member_2[2u];
                                                if (((_e1891 + ((_e1894 - _e1897) * _e1554)) - _e1903) > 0f) {
                                                    let _e1908 = local_4.member[3u];
                                                    let _e1911 = local_4.member_1[3u];
                                                    let _e1914 = local_4.member[3u];
                                                    let _e1920 = local_4.member_2[3u];
                                                    phi_3172_ = (((_e1908 + ((_e1911 - _e1914) * _e1554)) - _e1920) > 0f);
                                                    phi_3173_ = false;
                                                } else {
                                                    phi_3172_ = bool();
                                                    phi_3173_ = true;
                                                }
                                                let _e1924 = phi_3172_;
                                                let _e1926 = phi_3173_;
                                                phi_3174_ = _e1924;
                                                phi_3175_ = _e1926;
                                            } else {
                                                phi_3174_ = bool();
                                                phi_3175_ = true;
                                            }
                                            let _e1928 = phi_3174_;
                                            let _e1930 = phi_3175_;
                                            phi_3176_ = _e1928;
                                            phi_3177_ = _e1930;
                                        } else {
                                            phi_3176_ = bool();
                                            phi_3177_ = true;
                                        }
                                        let _e1932 = phi_3176_;
                                        let _e1934 = phi_3177_;
                                        if select(_e1932, false, _e1934) {
                                            if (_e1554 <= _e1556) {
                                                phi_3491_ = true;
                                            } else {
                                                let _e1939 = local_3.member[0u];
                                                let _e1942 = local_3.member_1[0u];
                                                let _e1945 = local_3.member[0u];
                                                let _e1951 = local_3.member_2[0u];
                                                let _e1955 = local_4.member[0u];
                                                let _e1958 = local_4.member_1[0u];
                                                let _e1961 = local_4.member[0u];
                                                let _e1967 = local_4.member_2[0u];
                                                if ((((_e1939 + ((_e1942 - _e1945) * _e1554)) - _e1951) + ((_e1955 + ((_e1958 - _e1961) * _e1560)) - _e1967)) > 0f) {
                                                    let _e1973 = local_3.member[1u];
                                                    let _e1976 = local_3.member_1[1u];
                                                    let _e1979 = local_3.member[1u];
                                                    let _e1985 = local_3.member_2[1u];
                                                    let _e1989 = local_4.member[1u];
                                                    let _e1992 = local_4.member_1[1u];
                                                    let _e1995 = local_4.member[1u];
                                                    let _e2001 = local_4.member_2[1u];
                                                    if ((((_e1973 + ((_e1976 - _e1979) * _e1554)) - _e1985) + ((_e1989 + ((_e1992 - _e1995) * _e1560)) - _e2001)) > 0f) {
                                                        let _e2007 = local_3.member[2u];
                                                        let _e2010 = local_3.member_1[2u];
                                                        let _e2013 = local_3.member[2u];
                                                        let _e2019 = local_3.member_2[2u];
                                                        let _e2023 = local_4.member[2u];
                                                        let _e2026 = local_4.member_1[2u];
                                                        let _e2029 = local_4.member[2u];
                                                        let _e2035 = local_4.member_2[2u];
                                                        if ((((_e2007 + ((_e2010 - _e2013) * _e1554)) - _e2019) + ((_e2023 + ((_e2026 - _e2029) * _e1560)) - _e2035)) > 0f) {
                                                            let _e2041 = local_3.member[3u];
                                                            let _e2044 = local_3.member_1[3u];
                                                            let _e2047 = local_3.member[3u];
                                                            let _e2053 = local_3.member_2[3u];
                                                            let _e2057 = local_4.member[3u];
                                                            let _e2060 = local_4.member_1[3u];
                                                            let _e2063 = local_4.member[3u];
                                                            let _e2069 = local_4.member_2[3u];
                                                            phi_3478_ = ((((_e2041 + ((_e2044 - _e2047) * _e1554)) - _e2053) + ((_e2057 + ((_e2060 - _e2063) * _e1560)) - _e2069)) > 0f);
                                                            phi_3479_ = false;
                                                        } else {
                                                            phi_3478_ = bool();
                                                            phi_3479_ = true;
                                                        }
                                                        let _e2074 = phi_3478_;
                                                        let _e2076 = phi_3479_;
                                                        phi_3480_ = _e2074;
                                                        phi_3481_ = _e2076;
                                                    } else {
                                                        phi_3480_ = bool();
                                                        phi_3481_ = true;
                                                    }
                                                    let _e2078 = phi_3480_;
                                                    let _e2080 = phi_3481_;
                                                    phi_3482_ = _e2078;
                                                    phi_3483_ = _e2080;
                                                } else {
                                                    phi_3482_ = bool();
                                                    phi_3483_ = true;
                                                }
                                                let _e2082 = phi_3482_;
                                                let _e2084 = phi_3483_;
                                                phi_3491_ = select(_e2082, false, _e2084);
                                            }
                                            let _e2087 = phi_3491_;
                                            if _e2087 {
                                                if select(true, select(true, false, (_e1554 >= _e379)), _e1562) {
                                                    local_3 = type_29(array<f32, 4>(_e1833.member[0], _e1833.member[1], _e1833.member[2], _e1833.member[3]), array<f32, 4>(_e1833.member_1[0], _e1833.member_1[1], _e1833.member_1[2], _e1833.member_1[3]), array<f32, 4>(_e1833.member_2[0], _e1833.member_2[1], _e1833.member_2[2], _e1833.member_2[3]));
                                                    let _e2112 = local_3.member[0u];
                                                    let _e2115 = local_3.member_1[0u];
                                                    let _e2118 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2115 > _e2118)), (_e2112 > _e2118)) {
                                                        let _e2123 = (_e2115 >= _e2112);
                                                        if _e2123 {
                                                            phi_3600_ = f32();
                                                            phi_3601_ = false;
                                                        } else {
                                                            if ((_e2112 - _e2115) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3598_ = (((_e2112 - _e2118) / (_e2112 - _e2115)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3599_ = false;
                                                            } else {
                                                                phi_3598_ = f32();
                                                                phi_3599_ = true;
                                                            }
                                                            let _e2134 = phi_3598_;
                                                            let _e2136 = phi_3599_;
                                                            phi_3600_ = _e2134;
                                                            phi_3601_ = _e2136;
                                                        }
                                                        let _e2138 = phi_3600_;
                                                        let _e2140 = phi_3601_;
                                                        phi_3602_ = _e2138;
                                                        phi_3603_ = _e2123;
                                                        phi_3604_ = _e2140;
                                                    } else {
                                                        phi_3602_ = f32();
                                                        phi_3603_ = true;
                                                        phi_3604_ = false;
                                                    }
                                                    let _e2142 = phi_3602_;
                                                    let _e2144 = phi_3603_;
                                                    let _e2146 = phi_3604_;
                                                    let _e2149 = select(_e2142, select(_e1554, 2f, _e2144), select(_e2146, true, _e2144));
                                                    let _e2152 = local_3.member[1u];
                                                    let _e2155 = local_3.member_1[1u];
                                                    let _e2158 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2155 > _e2158)), (_e2152 > _e2158)) {
                                                        let _e2163 = (_e2155 >= _e2152);
                                                        if _e2163 {
                                                            phi_3668_ = f32();
                                                            phi_3669_ = false;
                                                        } else {
                                                            if ((_e2152 - _e2155) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3666_ = (((_e2152 - _e2158) / (_e2152 - _e2155)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3667_ = false;
                                                            } else {
                                                                phi_3666_ = f32();
                                                                phi_3667_ = true;
                                                            }
                                                            let _e2174 = phi_3666_;
                                                            let _e2176 = phi_3667_;
                                                            phi_3668_ = _e2174;
                                                            phi_3669_ = _e2176;
                                                        }
                                                        let _e2178 = phi_3668_;
                                                        let _e2180 = phi_3669_;
                                                        phi_3670_ = _e2178;
                                                        phi_3671_ = _e2163;
                                                        phi_3672_ = _e2180;
                                                    } else {
                                                        phi_3670_ = f32();
                                                        phi_3671_ = true;
                                                        phi_3672_ = false;
                                                    }
                                                    let _e2182 = phi_3670_;
                                                    let _e2184 = phi_3671_;
                                                    let _e2186 = phi_3672_;
                                                    let _e2189 = select(_e2182, select(_e1554, 2f, _e2184), select(_e2186, true, _e2184));
                                                    let _e2191 = select(_e2189, _e2149, (_e2149 < _e2189));
                                                    let _e2194 = local_3.member[2u];
                                                    let _e2197 = local_3.member_1[2u];
                                                    let _e2200 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2197 > _e2200)), (_e2194 > _e2200)) {
                                                        let _e2205 = (_e2197 >= _e2194);
                                                        if _e2205 {
                                                            phi_3741_ = f32();
                                                            phi_3742_ = false;
                                                        } else {
                                                            if ((_e2194 - _e2197) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3739_ = (((_e2194 - _e2200) / (_e2194 - _e2197)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3740_ = false;
                                                            } else {
                                                                phi_3739_ = f32();
                                                                phi_3740_ = true;
                                                            }
                                                            let _e2216 = phi_3739_;
                                                            let _e2218 = phi_3740_;
                                                            phi_3741_ = _e2216;
                                                            phi_3742_ = _e2218;
                                                        }
                                                        let _e2220 = phi_3741_;
                                                        let _e2222 = phi_3742_;
                                                        phi_3743_ = _e2220;
                                                        phi_3744_ = _e2205;
                                                        phi_3745_ = _e2222;
                                                    } else {
                                                        phi_3743_ = f32();
                                                        phi_3744_ = true;
                                                        phi_3745_ = false;
                                                    }
                                                    let _e2224 = phi_3743_;
                                                    let _e2226 = phi_3744_;
                                                    let _e2228 = phi_3745_;
                                                    let _e2231 = select(_e2224, select(_e1554, 2f, _e2226), select(_e2228, true, _e2226));
                                                    let _e2234 = local_3.member[3u];
                                                    let _e2237 = local_3.member_1[3u];
                                                    let _e2240 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2237 > _e2240)), (_e2234 > _e2240)) {
                                                        let _e2245 = (_e2237 >= _e2234);
                                                        if _e2245 {
                                                            phi_3809_ = f32();
                                                            phi_3810_ = false;
                                                        } else {
                                                            if ((_e2234 - _e2237) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3807_ = (((_e2234 - _e2240) / (_e2234 - _e2237)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3808_ = false;
                                                            } else {
                                                                phi_3807_ = f32();
                                                                phi_3808_ = true;
                                                            }
                                                            let _e2256 = phi_3807_;
                                                            let _e2258 = phi_3808_;
                                                            phi_3809_ = _e2256;
                                                            phi_3810_ = _e2258;
                                                        }
                                                        let _e2260 = phi_3809_;
                                                        let _e2262 = phi_3810_;
                                                        phi_3811_ = _e2260;
                                                        phi_3812_ = _e2245;
                                                        phi_3813_ = _e2262;
                                                    } else {
                                                        phi_3811_ = f32();
                                                        phi_3812_ = true;
                                                        phi_3813_ = false;
                                                    }
                                                    let _e2264 = phi_3811_;
                                                    let _e2266 = phi_3812_;
                                                    let _e2268 = phi_3813_;
                                                    let _e2271 = select(_e2264, select(_e1554, 2f, _e2266), select(_e2268, true, _e2266));
                                                    let _e2273 = select(_e2271, _e2231, (_e2231 < _e2271));
                                                    let _e2275 = select(_e2273, _e2191, (_e2191 < _e2273));
                                                    let _e2277 = select(_e1554, _e2275, (_e2275 > _e1554));
                                                    let _e2278 = (_e2277 > _e379);
                                                    if _e2278 {
                                                        phi_4342_ = f32();
                                                        phi_4343_ = f32();
                                                        phi_4344_ = false;
                                                        phi_4345_ = false;
                                                    } else {
                                                        let _e2279 = (_e2277 - _e1554);
                                                        let _e2280 = (_e2279 <= _e1549);
                                                        let _e2282 = (_e2277 + (_e375 * 0.01f));
                                                        let _e2284 = select(_e379, _e2282, (_e2282 < _e379));
                                                        if _e2280 {
                                                            if (_e606.member_1 > 0f) {
                                                                let _e2288 = local_5.member[0u];
                                                                let _e2294 = local_5.member[1u];
                                                                let _e2310 = local_5.member_1[0u];
                                                                let _e2316 = local_5.member_1[1u];
                                                                let _e2332 = local_5.member_2[0u];
                                                                let _e2338 = local_5.member_2[1u];
                                                                let _e2352 = function_3(array<f32, 3>((_e2288[0] + ((_e2294[0] - _e2288[0]) * _e2284)), (_e2288[1] + ((_e2294[1] - _e2288[1]) * _e2284)), (_e2288[2] + ((_e2294[2] - _e2288[2]) * _e2284))), array<f32, 3>((_e2310[0] + ((_e2316[0] - _e2310[0]) * _e2284)), (_e2310[1] + ((_e2316[1] - _e2310[1]) * _e2284)), (_e2310[2] + ((_e2316[2] - _e2310[2]) * _e2284))), array<f32, 3>((_e2332[0] + ((_e2338[0] - _e2332[0]) * _e2284)), (_e2332[1] + ((_e2338[1] - _e2332[1]) * _e2284)), (_e2332[2] + ((_e2338[2] - _e2332[2]) * _e2284))), _e222.member);
                                                                let _e2363 = (((_e2352[0] * _e2352[0]) + (_e2352[1] * _e2352[1])) + (_e2352[2] * _e2352[2]));
                                                                if (_e2363 <= 0.000000000000000000000000000000000000011754944f) {
                                                                    phi_4044_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2363 > 0f));
                                                                } else {
                                                                    phi_3987_ = type_14(0i, 5i);
                                                                    phi_3990_ = bitcast<f32>(((bitcast<u32>(_e2363) >> bitcast<u32>(1i)) + 532369198u));
                                                                    loop {
                                                                        let _e2371 = phi_3987_;
                                                                        let _e2373 = phi_3990_;
                                                                        local_8 = _e2373;
                                                                        if (_e2371.member < _e2371.member_1) {
                                                                            let _e2380 = (_e2371.member + 1i);
                                                                            phi_3988_ = type_14(select(_e2380, type_15().member_1, select(false, true, ((false == (_e2380 > _e2371.member)) != false))), _e2371.member_1);
                                                                            phi_4031_ = type_15(1u, _e2371.member);
                                                                        } else {
                                                                            phi_3988_ = _e2371;
                                                                            phi_4031_ = type_15(0u, type_15().member_1);
                                                                        }
                                                                        let _e2391 = phi_3988_;
                                                                        let _e2393 = phi_4031_;
                                                                        let _e2396 = (bitcast<i32>(_e2393.member) != 0i);
                                                                        if _e2396 {
                                                                            phi_3991_ = (0.5f * (_e2373 + (_e2363 / _e2373)));
                                                                        } else {
                                                                            phi_3991_ = f32();
                                                                        }
                                                                        let _e2401 = phi_3991_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_3987_ = _e2391;
                                                                            phi_3990_ = _e2401;
                                                                            break if !(_e2396);
                                                                        }
                                                                    }
                                                                    let _e2406 = local_8;
                                                                    phi_4044_ = (_e2406 * (1f + (8f * 0.000000059604645f)));
                                                                }
                                                                let _e2412 = phi_4044_;
                                                                let _e2418 = local_5.member[0u];
                                                                let _e2424 = select(_e2418[0], -(_e2418[0]), (_e2418[0] < 0f));
                                                                let _e2427 = select(_e2418[1], -(_e2418[1]), (_e2418[1] < 0f));
                                                                let _e2429 = select(_e2427, _e2424, (_e2424 > _e2427));
                                                                let _e2432 = select(_e2418[2], -(_e2418[2]), (_e2418[2] < 0f));
                                                                let _e2434 = select(_e2432, _e2429, (_e2429 > _e2432));
                                                                let _e2437 = local_5.member[1u];
                                                                let _e2443 = select(_e2437[0], -(_e2437[0]), (_e2437[0] < 0f));
                                                                let _e2446 = select(_e2437[1], -(_e2437[1]), (_e2437[1] < 0f));
                                                                let _e2448 = select(_e2446, _e2443, (_e2443 > _e2446));
                                                                let _e2451 = select(_e2437[2], -(_e2437[2]), (_e2437[2] < 0f));
                                                                let _e2453 = select(_e2451, _e2448, (_e2448 > _e2451));
                                                                let _e2457 = local_5.member_3;
                                                                let _e2461 = local_5.member_1[0u];
                                                                let _e2467 = select(_e2461[0], -(_e2461[0]), (_e2461[0] < 0f));
                                                                let _e2470 = select(_e2461[1], -(_e2461[1]), (_e2461[1] < 0f));
                                                                let _e2472 = select(_e2470, _e2467, (_e2467 > _e2470));
                                                                let _e2475 = select(_e2461[2], -(_e2461[2]), (_e2461[2] < 0f));
                                                                let _e2477 = select(_e2475, _e2472, (_e2472 > _e2475));
                                                                let _e2480 = local_5.member_1[1u];
                                                                let _e2486 = select(_e2480[0], -(_e2480[0]), (_e2480[0] < 0f));
                                                                let _e2489 = select(_e2480[1], -(_e2480[1]), (_e2480[1] < 0f));
                                                                let _e2491 = select(_e2489, _e2486, (_e2486 > _e2489));
                                                                let _e2494 = select(_e2480[2], -(_e2480[2]), (_e2480[2] < 0f));
                                                                let _e2496 = select(_e2494, _e2491, (_e2491 > _e2494));
                                                                let _e2500 = local_5.member_3;
                                                                let _e2504 = local_5.member_2[0u];
                                                                let _e2510 = select(_e2504[0], -(_e2504[0]), (_e2504[0] < 0f));
                                                                let _e2513 = select(_e2504[1], -(_e2504[1]), (_e2504[1] < 0f));
                                                                let _e2515 = select(_e2513, _e2510, (_e2510 > _e2513));
                                                                let _e2518 = select(_e2504[2], -(_e2504[2]), (_e2504[2] < 0f));
                                                                let _e2520 = select(_e2518, _e2515, (_e2515 > _e2518));
                                                                let _e2523 = local_5.member_2[1u];
                                                                let _e2529 = select(_e2523[0], -(_e2523[0]), (_e2523[0] < 0f));
                                                                let _e2532 = select(_e2523[1], -(_e2523[1]), (_e2523[1] < 0f));
                                                                let _e2534 = select(_e2532, _e2529, (_e2529 > _e2532));
                                                                let _e2537 = select(_e2523[2], -(_e2523[2]), (_e2523[2] < 0f));
                                                                let _e2539 = select(_e2537, _e2534, (_e2534 > _e2537));
                                                                let _e2543 = local_5.member_3;
                                                                let _e2550 = local_5.member_3;
                                                                phi_4315_ = select(true, false, (((_e2412 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2453, _e2434, (_e2434 > _e2453)) + _e2457) + (select(_e2496, _e2477, (_e2477 > _e2496)) + _e2500)) + (select(_e2539, _e2520, (_e2520 > _e2539)) + _e2543)) * (0.000000059604645f * 16f)) + (_e2550 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e606.member_1));
                                                            } else {
                                                                phi_4315_ = true;
                                                            }
                                                            let _e2560 = phi_4315_;
                                                            phi_4316_ = _e2560;
                                                        } else {
                                                            phi_4316_ = true;
                                                        }
                                                        let _e2562 = phi_4316_;
                                                        phi_4342_ = select(f32(), select((_e379 - _e1554), select(0f, (_e1853 + _e1853), select(select(true, false, (_e2279 <= (_e1558 * 0.25f))), true, _e2280)), _e1562), _e2562);
                                                        phi_4343_ = _e2279;
                                                        phi_4344_ = _e2562;
                                                        phi_4345_ = select(true, false, _e2562);
                                                    }
                                                    let _e2574 = phi_4342_;
                                                    let _e2576 = phi_4343_;
                                                    let _e2578 = phi_4344_;
                                                    let _e2580 = phi_4345_;
                                                    phi_4346_ = _e2277;
                                                    phi_4347_ = _e2574;
                                                    phi_4348_ = _e2576;
                                                    phi_4349_ = _e2277;
                                                    phi_4350_ = _e2578;
                                                    phi_4351_ = _e2278;
                                                    phi_4352_ = _e2580;
                                                    phi_4353_ = false;
                                                } else {
                                                    phi_4346_ = f32();
                                                    phi_4347_ = f32();
                                                    phi_4348_ = f32();
                                                    phi_4349_ = f32();
                                                    phi_4350_ = false;
                                                    phi_4351_ = false;
                                                    phi_4352_ = false;
                                                    phi_4353_ = true;
                                                }
                                                let _e2582 = phi_4346_;
                                                let _e2584 = phi_4347_;
                                                let _e2586 = phi_4348_;
                                                let _e2588 = phi_4349_;
                                                let _e2590 = phi_4350_;
                                                let _e2592 = phi_4351_;
                                                let _e2594 = phi_4352_;
                                                let _e2596 = phi_4353_;
                                                phi_4354_ = _e2582;
                                                phi_4355_ = _e2584;
                                                phi_4356_ = _e2586;
                                                phi_4357_ = _e2588;
                                                phi_4358_ = false;
                                                phi_4359_ = _e2590;
                                                phi_4360_ = _e2592;
                                                phi_4361_ = _e2594;
                                                phi_4362_ = _e2596;
                                            } else {
                                                phi_4354_ = f32();
                                                phi_4355_ = f32();
                                                phi_4356_ = f32();
                                                phi_4357_ = f32();
                                                phi_4358_ = true;
                                                phi_4359_ = false;
                                                phi_4360_ = false;
                                                phi_4361_ = false;
                                                phi_4362_ = false;
                                            }
                                            let _e2598 = phi_4354_;
                                            let _e2600 = phi_4355_;
                                            let _e2602 = phi_4356_;
                                            let _e2604 = phi_4357_;
                                            let _e2606 = phi_4358_;
                                            let _e2608 = phi_4359_;
                                            let _e2610 = phi_4360_;
                                            let _e2612 = phi_4361_;
                                            let _e2614 = phi_4362_;
                                            phi_4363_ = _e2598;
                                            phi_4364_ = _e2600;
                                            phi_4365_ = _e2602;
                                            phi_4366_ = _e2604;
                                            phi_4367_ = _e2606;
                                            phi_4368_ = _e2608;
                                            phi_4369_ = _e2610;
                                            phi_4370_ = _e2612;
                                            phi_4371_ = _e2614;
                                        } else {
                                            phi_4363_ = f32();
                                            phi_4364_ = f32();
                                            phi_4365_ = f32();
                                            phi_4366_ = f32();
                                            phi_4367_ = true;
                                            phi_4368_ = false;
                                            phi_4369_ = false;
                                            phi_4370_ = false;
                                            phi_4371_ = false;
                                        }
                                        let _e2616 = phi_4363_;
                                        let _e2618 = phi_4364_;
                                        let _e2620 = phi_4365_;
                                        let _e2622 = phi_4366_;
                                        let _e2624 = phi_4367_;
                                        let _e2626 = phi_4368_;
                                        let _e2628 = phi_4369_;
                                        let _e2630 = phi_4370_;
                                        let _e2632 = phi_4371_;
                                        if _e2624 {
                                            if (_e1554 <= _e1556) {
                                                let _e2785 = (_e1564 + 1u);
                                                let _e2786 = (_e2785 > 3u);
                                                phi_4706_ = _e2785;
                                                phi_4707_ = f32();
                                                phi_4708_ = false;
                                                phi_4709_ = select(true, false, _e2786);
                                                phi_4710_ = _e2786;
                                            } else {
                                                let _e2636 = local_3.member[0u];
                                                let _e2639 = local_3.member_1[0u];
                                                let _e2642 = local_3.member[0u];
                                                let _e2648 = local_3.member_2[0u];
                                                let _e2649 = ((_e2636 + ((_e2639 - _e2642) * _e1560)) - _e2648);
                                                let _e2652 = local_3.member[1u];
                                                let _e2655 = local_3.member_1[1u];
                                                let _e2658 = local_3.member[1u];
                                                let _e2664 = local_3.member_2[1u];
                                                let _e2665 = ((_e2652 + ((_e2655 - _e2658) * _e1560)) - _e2664);
                                                let _e2667 = select(_e2665, _e2649, (_e2649 < _e2665));
                                                let _e2670 = local_3.member[2u];
                                                let _e2673 = local_3.member_1[2u];
                                                let _e2676 = local_3.member[2u];
                                                let _e2682 = local_3.member_2[2u];
                                                let _e2683 = ((_e2670 + ((_e2673 - _e2676) * _e1560)) - _e2682);
                                                let _e2686 = local_3.member[3u];
                                                let _e2689 = local_3.member_1[3u];
                                                let _e2692 = local_3.member[3u];
                                                let _e2698 = local_3.member_2[3u];
                                                let _e2699 = ((_e2686 + ((_e2689 - _e2692) * _e1560)) - _e2698);
                                                let _e2701 = select(_e2699, _e2683, (_e2683 < _e2699));
                                                let _e2703 = select(_e2701, _e2667, (_e2667 < _e2701));
                                                let _e2706 = local_4.member[0u];
                                                let _e2709 = local_4.member_1[0u];
                                                let _e2712 = local_4.member[0u];
                                                let _e2718 = local_4.member_2[0u];
                                                let _e2719 = ((_e2706 + ((_e2709 - _e2712) * _e1554)) - _e2718);
                                                let _e2722 = local_4.member[1u];
                                                let _e2725 = local_4.member_1[1u];
                                                let _e2728 = local_4.member[1u];
                                                let _e2734 = local_4.member_2[1u];
                                                let _e2735 = ((_e2722 + ((_e2725 - _e2728) * _e1554)) - _e2734);
                                                let _e2737 = select(_e2735, _e2719, (_e2719 < _e2735));
                                                let _e2740 = local_4.member[2u];
                                                let _e2743 = local_4.member_1[2u];
                                                let _e2746 = local_4.member[2u];
                                                let _e2752 = local_4.member_2[2u];
                                                let _e2753 = ((_e2740 + ((_e2743 - _e2746) * _e1554)) - _e2752);
                                                let _e2756 = local_4.member[3u];
                                                let _e2759 = local_4.member_1[3u];
                                                let _e2762 = local_4.member[3u];
                                                let _e2768 = local_4.member_2[3u];
                                                let _e2769 = ((_e2756 + ((_e2759 - _e2762) * _e1554)) - _e2768);
                                                let _e2771 = select(_e2769, _e2753, (_e2753 < _e2769));
                                                let _e2773 = select(_e2771, _e2737, (_e2737 < _e2771));
                                                if (_e2773 > 0f) {
                                                    phi_4704_ = 0.5f;
                                                } else {
                                                    let _e2777 = (0.95f * (_e2703 / (_e2703 - _e2773)));
                                                    phi_4704_ = select(0.0625f, select(0.9f, _e2777, (_e2777 < 0.9f)), (_e2777 > 0.0625f));
                                                }
                                                let _e2783 = phi_4704_;
                                                phi_4706_ = u32();
                                                phi_4707_ = (_e1853 * _e2783);
                                                phi_4708_ = true;
                                                phi_4709_ = false;
                                                phi_4710_ = false;
                                            }
                                            let _e2789 = phi_4706_;
                                            let _e2791 = phi_4707_;
                                            let _e2793 = phi_4708_;
                                            let _e2795 = phi_4709_;
                                            let _e2797 = phi_4710_;
                                            phi_4711_ = _e2789;
                                            phi_4712_ = _e1556;
                                            phi_4713_ = _e2791;
                                            phi_4714_ = _e1558;
                                            phi_4715_ = _e1560;
                                            phi_4716_ = _e1562;
                                            phi_4717_ = _e1564;
                                            phi_4718_ = _e2793;
                                            phi_4719_ = _e2795;
                                            phi_4720_ = _e2797;
                                            phi_4721_ = false;
                                            phi_4722_ = false;
                                            phi_4723_ = false;
                                        } else {
                                            phi_4711_ = u32();
                                            phi_4712_ = _e2616;
                                            phi_4713_ = _e2618;
                                            phi_4714_ = _e2620;
                                            phi_4715_ = _e1554;
                                            phi_4716_ = true;
                                            phi_4717_ = 0u;
                                            phi_4718_ = _e2626;
                                            phi_4719_ = false;
                                            phi_4720_ = false;
                                            phi_4721_ = _e2628;
                                            phi_4722_ = _e2630;
                                            phi_4723_ = _e2632;
                                        }
                                        let _e2799 = phi_4711_;
                                        let _e2801 = phi_4712_;
                                        let _e2803 = phi_4713_;
                                        let _e2805 = phi_4714_;
                                        let _e2807 = phi_4715_;
                                        let _e2809 = phi_4716_;
                                        let _e2811 = phi_4717_;
                                        let _e2813 = phi_4718_;
                                        let _e2815 = phi_4719_;
                                        let _e2817 = phi_4720_;
                                        let _e2819 = phi_4721_;
                                        let _e2821 = phi_4722_;
                                        let _e2823 = phi_4723_;
                                        if _e2813 {
                                            let _e2824 = (_e2807 + _e2803);
                                            let _e2826 = select(_e2801, _e2824, (_e2824 > _e2801));
                                            let _e2828 = select(_e379, _e2826, (_e2826 < _e379));
                                            let _e2831 = select(((_e2828 - _e2807) > _e1549), true, !(_e1562));
                                            phi_4751_ = _e2828;
                                            phi_4752_ = _e2801;
                                            phi_4753_ = _e2805;
                                            phi_4754_ = _e2807;
                                            phi_4755_ = _e2809;
                                            phi_4756_ = _e2811;
                                            phi_4757_ = _e2831;
                                            phi_4758_ = select(true, false, _e2831);
                                            phi_4759_ = false;
                                            phi_4760_ = false;
                                            phi_4761_ = false;
                                            phi_4762_ = false;
                                        } else {
                                            phi_4751_ = _e1554;
                                            phi_4752_ = _e1556;
                                            phi_4753_ = _e1558;
                                            phi_4754_ = _e1560;
                                            phi_4755_ = _e1562;
                                            phi_4756_ = _e2799;
                                            phi_4757_ = _e2815;
                                            phi_4758_ = false;
                                            phi_4759_ = _e2817;
                                            phi_4760_ = _e2819;
                                            phi_4761_ = _e2821;
                                            phi_4762_ = _e2823;
                                        }
                                        let _e2834 = phi_4751_;
                                        let _e2836 = phi_4752_;
                                        let _e2838 = phi_4753_;
                                        let _e2840 = phi_4754_;
                                        let _e2842 = phi_4755_;
                                        let _e2844 = phi_4756_;
                                        let _e2846 = phi_4757_;
                                        let _e2848 = phi_4758_;
                                        let _e2850 = phi_4759_;
                                        let _e2852 = phi_4760_;
                                        let _e2854 = phi_4761_;
                                        let _e2856 = phi_4762_;
                                        phi_2584_ = _e2834;
                                        phi_2586_ = _e2836;
                                        phi_2588_ = _e2838;
                                        phi_2590_ = _e2840;
                                        phi_2592_ = _e2842;
                                        phi_2594_ = _e2844;
                                        phi_4763_ = _e2801;
                                        phi_4764_ = _e2622;
                                        phi_4765_ = _e2846;
                                        phi_4766_ = _e2848;
                                        phi_4767_ = _e2850;
                                        phi_4768_ = _e2852;
                                        phi_4769_ = _e2854;
                                        phi_4770_ = false;
                                        phi_4771_ = _e2856;
                                    } else {
                                        phi_2584_ = f32();
                                        phi_2586_ = f32();
                                        phi_2588_ = f32();
                                        phi_2590_ = f32();
                                        phi_2592_ = bool();
                                        phi_2594_ = u32();
                                        phi_4763_ = f32();
                                        phi_4764_ = f32();
                                        phi_4765_ = false;
                                        phi_4766_ = false;
                                        phi_4767_ = false;
                                        phi_4768_ = false;
                                        phi_4769_ = false;
                                        phi_4770_ = true;
                                        phi_4771_ = false;
                                    }
                                    let _e2858 = phi_2584_;
                                    let _e2860 = phi_2586_;
                                    let _e2862 = phi_2588_;
                                    let _e2864 = phi_2590_;
                                    let _e2866 = phi_2592_;
                                    let _e2868 = phi_2594_;
                                    let _e2870 = phi_4763_;
                                    let _e2872 = phi_4764_;
                                    let _e2874 = phi_4765_;
                                    let _e2876 = phi_4766_;
                                    let _e2878 = phi_4767_;
                                    let _e2880 = phi_4768_;
                                    let _e2882 = phi_4769_;
                                    let _e2884 = phi_4770_;
                                    let _e2886 = phi_4771_;
                                    local_9 = _e2876;
                                    local_10 = _e2878;
                                    local_11 = _e2876;
                                    local_12 = _e2880;
                                    local_13 = _e2876;
                                    local_14 = _e2882;
                                    local_15 = _e2876;
                                    local_16 = _e2884;
                                    local_17 = _e2876;
                                    local_18 = _e2886;
                                    local_20 = _e2876;
                                    local_21 = _e2872;
                                    local_22 = _e2870;
                                    continue;
                                    continuing {
                                        phi_2580_ = type_9(select(_e1552.member, (_e1552.member + 1u), _e1567), select(_e1552.member_1, _e1552.member_1, _e1567));
                                        phi_2583_ = _e2858;
                                        phi_2585_ = _e2860;
                                        phi_2587_ = _e2862;
                                        phi_2589_ = _e2864;
                                        phi_2591_ = _e2866;
                                        phi_2593_ = _e2868;
                                        break if !(_e2874);
                                    }
                                }
                                let _e2889 = local_9;
                                let _e2891 = local_10;
                                let _e2892 = select(_e2891, false, _e2889);
                                let _e2894 = local_11;
                                let _e2896 = local_12;
                                let _e2899 = local_13;
                                let _e2901 = local_14;
                                let _e2904 = local_15;
                                let _e2906 = local_16;
                                let _e2909 = local_17;
                                let _e2911 = local_18;
                                let _e2917 = local_19;
                                let _e2919 = select(select(_e2896, false, _e2894), false, _e2892);
                                let _e2922 = local_20;
                                let _e2929 = select(select(select(_e2901, false, _e2899), false, _e2892), false, _e2919);
                                let _e2935 = local_21;
                                let _e2937 = local_22;
                                let _e2939 = select(select(select(_e2922, false, _e2892), false, _e2919), true, _e2929);
                                let _e2944 = local_23;
                                let _e2946 = select(select(select(select(select(_e2906, false, _e2904), false, _e2892), false, _e2919), false, _e2929), true, _e2939);
                                let _e2953 = select(select(select(select(select(select(_e2911, false, _e2909), false, _e2892), false, _e2919), false, _e2929), false, _e2939), false, _e2946);
                                let _e2958 = select(select(select(select(select(_e2892, true, _e2919), false, _e2929), false, _e2939), false, _e2946), true, _e2953);
                                phi_4838_ = select(select(type_34().member_1, select(_e2944, select(_e2937, _e2935, _e2929), _e2939), _e2946), select(select(select(type_34().member_1, _e2917, _e2892), type_34().member_1, _e2919), type_34().member_1, _e2953), _e2958);
                                phi_4839_ = (select(select(type_34().member, 1u, _e2946), select(select(select(type_34().member, 1u, _e2892), 0u, _e2919), 0u, _e2953), _e2958) != 0u);
                            } else {
                                phi_4838_ = _e1316;
                                phi_4839_ = true;
                            }
                            let _e2963 = phi_4838_;
                            let _e2965 = phi_4839_;
                            if _e2965 {
                                let _e2966 = (_e2963 > _e377);
                                if _e2966 {
                                    phi_7004_ = f32();
                                    phi_7005_ = u32();
                                    phi_7006_ = f32();
                                    phi_7007_ = type_36();
                                    phi_7008_ = u32();
                                    phi_7009_ = u32();
                                    phi_7010_ = false;
                                    phi_7011_ = false;
                                    phi_7012_ = false;
                                } else {
                                    let _e2969 = local_5.member[0u];
                                    let _e2975 = local_5.member[1u];
                                    let _e2991 = local_5.member_1[0u];
                                    let _e2997 = local_5.member_1[1u];
                                    let _e3013 = local_5.member_2[0u];
                                    let _e3019 = local_5.member_2[1u];
                                    let _e3033 = function_3(array<f32, 3>((_e2969[0] + ((_e2975[0] - _e2969[0]) * _e1320)), (_e2969[1] + ((_e2975[1] - _e2969[1]) * _e1320)), (_e2969[2] + ((_e2975[2] - _e2969[2]) * _e1320))), array<f32, 3>((_e2991[0] + ((_e2997[0] - _e2991[0]) * _e1320)), (_e2991[1] + ((_e2997[1] - _e2991[1]) * _e1320)), (_e2991[2] + ((_e2997[2] - _e2991[2]) * _e1320))), array<f32, 3>((_e3013[0] + ((_e3019[0] - _e3013[0]) * _e1320)), (_e3013[1] + ((_e3019[1] - _e3013[1]) * _e1320)), (_e3013[2] + ((_e3019[2] - _e3013[2]) * _e1320))), _e222.member);
                                    let _e3047 = ((select(_e3033[0], -(_e3033[0]), (_e3033[0] < 0f)) + select(_e3033[1], -(_e3033[1]), (_e3033[1] < 0f))) + select(_e3033[2], -(_e3033[2]), (_e3033[2] < 0f)));
                                    let _e3050 = local_5.member[0u];
                                    let _e3056 = local_5.member_1[0u];
                                    let _e3062 = local_5.member_2[0u];
                                    let _e3066 = (_e3050[0] - _e3056[0]);
                                    let _e3067 = (_e3050[1] - _e3056[1]);
                                    let _e3068 = (_e3050[2] - _e3056[2]);
                                    let _e3069 = (_e222.member == 0u);
                                    let _e3081 = local_5.member[1u];
                                    let _e3087 = local_5.member_1[1u];
                                    let _e3093 = local_5.member_2[1u];
                                    let _e3097 = (_e3081[0] - _e3087[0]);
                                    let _e3098 = (_e3081[1] - _e3087[1]);
                                    let _e3099 = (_e3081[2] - _e3087[2]);
                                    let _e3100 = (_e222.member == 0u);
                                    let _e3112 = local_5.member[0u];
                                    let _e3118 = select(_e3112[0], -(_e3112[0]), (_e3112[0] < 0f));
                                    let _e3121 = select(_e3112[1], -(_e3112[1]), (_e3112[1] < 0f));
                                    let _e3123 = select(_e3121, _e3118, (_e3118 > _e3121));
                                    let _e3126 = select(_e3112[2], -(_e3112[2]), (_e3112[2] < 0f));
                                    let _e3128 = select(_e3126, _e3123, (_e3123 > _e3126));
                                    let _e3131 = local_5.member[1u];
                                    let _e3137 = select(_e3131[0], -(_e3131[0]), (_e3131[0] < 0f));
                                    let _e3140 = select(_e3131[1], -(_e3131[1]), (_e3131[1] < 0f));
                                    let _e3142 = select(_e3140, _e3137, (_e3137 > _e3140));
                                    let _e3145 = select(_e3131[2], -(_e3131[2]), (_e3131[2] < 0f));
                                    let _e3147 = select(_e3145, _e3142, (_e3142 > _e3145));
                                    let _e3151 = local_5.member_3;
                                    let _e3155 = local_5.member_1[0u];
                                    let _e3161 = select(_e3155[0], -(_e3155[0]), (_e3155[0] < 0f));
                                    let _e3164 = select(_e3155[1], -(_e3155[1]), (_e3155[1] < 0f));
                                    let _e3166 = select(_e3164, _e3161, (_e3161 > _e3164));
                                    let _e3169 = select(_e3155[2], -(_e3155[2]), (_e3155[2] < 0f));
                                    let _e3171 = select(_e3169, _e3166, (_e3166 > _e3169));
                                    let _e3174 = local_5.member_1[1u];
                                    let _e3180 = select(_e3174[0], -(_e3174[0]), (_e3174[0] < 0f));
                                    let _e3183 = select(_e3174[1], -(_e3174[1]), (_e3174[1] < 0f));
                                    let _e3185 = select(_e3183, _e3180, (_e3180 > _e3183));
                                    let _e3188 = select(_e3174[2], -(_e3174[2]), (_e3174[2] < 0f));
                                    let _e3190 = select(_e3188, _e3185, (_e3185 > _e3188));
                                    let _e3194 = local_5.member_3;
                                    let _e3198 = local_5.member_2[0u];
                                    let _e3204 = select(_e3198[0], -(_e3198[0]), (_e3198[0] < 0f));
                                    let _e3207 = select(_e3198[1], -(_e3198[1]), (_e3198[1] < 0f));
                                    let _e3209 = select(_e3207, _e3204, (_e3204 > _e3207));
                                    let _e3212 = select(_e3198[2], -(_e3198[2]), (_e3198[2] < 0f));
                                    let _e3214 = select(_e3212, _e3209, (_e3209 > _e3212));
                                    let _e3217 = local_5.member_2[1u];
                                    let _e3223 = select(_e3217[0], -(_e3217[0]), (_e3217[0] < 0f));
                                    let _e3226 = select(_e3217[1], -(_e3217[1]), (_e3217[1] < 0f));
                                    let _e3228 = select(_e3226, _e3223, (_e3223 > _e3226));
                                    let _e3231 = select(_e3217[2], -(_e3217[2]), (_e3217[2] < 0f));
                                    let _e3233 = select(_e3231, _e3228, (_e3228 > _e3231));
                                    let _e3237 = local_5.member_3;
                                    let _e3244 = local_5.member_3;
                                    local_1 = type_28(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3050, array<f32, 3>(_e3066, _e3067, _e3068), array<f32, 3>((_e3050[0] - _e3062[0]), (_e3050[1] - _e3062[1]), (_e3050[2] - _e3062[2])), array<f32, 3>(select((_e3066 - _e3062[0]), _e3050[0], _e3069), select((_e3067 - _e3062[1]), _e3050[1], _e3069), select((_e3068 - _e3062[2]), _e3050[2], _e3069))), array<array<f32, 3>, 4>(_e3081, array<f32, 3>(_e3097, _e3098, _e3099), array<f32, 3>((_e3081[0] - _e3093[0]), (_e3081[1] - _e3093[1]), (_e3081[2] - _e3093[2])), array<f32, 3>(select((_e3097 - _e3093[0]), _e3081[0], _e3100), select((_e3098 - _e3093[1]), _e3081[1], _e3100), select((_e3099 - _e3093[2]), _e3081[2], _e3100)))), ((((((select(_e3147, _e3128, (_e3128 > _e3147)) + _e3151) + (select(_e3190, _e3171, (_e3171 > _e3190)) + _e3194)) + (select(_e3233, _e3214, (_e3214 > _e3233)) + _e3237)) * (0.000000059604645f * 16f)) + (_e3244 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e606.member_1);
                                    let _e3260 = local_1.member_1;
                                    if (_e3047 > _e3260) {
                                        if ((bitcast<u32>(_e3047) & 2139095040u) != 2139095040u) {
                                            let _e3265 = (1f / _e3047);
                                            let _e3267 = (_e3033[0] * _e3265);
                                            let _e3269 = (_e3033[1] * _e3265);
                                            let _e3271 = (_e3033[2] * _e3265);
                                            let _e3276 = (((_e3267 * _e3267) + (_e3269 * _e3269)) + (_e3271 * _e3271));
                                            if (_e3276 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5516_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3276 > 0f));
                                            } else {
                                                phi_5459_ = type_14(0i, 5i);
                                                phi_5462_ = bitcast<f32>(((bitcast<u32>(_e3276) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3284 = phi_5459_;
                                                    let _e3286 = phi_5462_;
                                                    local_24 = _e3286;
                                                    if (_e3284.member < _e3284.member_1) {
                                                        let _e3293 = (_e3284.member + 1i);
                                                        phi_5460_ = type_14(select(_e3293, type_15().member_1, select(false, true, ((false == (_e3293 > _e3284.member)) != false))), _e3284.member_1);
                                                        phi_5503_ = type_15(1u, _e3284.member);
                                                    } else {
                                                        phi_5460_ = _e3284;
                                                        phi_5503_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3304 = phi_5460_;
                                                    let _e3306 = phi_5503_;
                                                    let _e3309 = (bitcast<i32>(_e3306.member) != 0i);
                                                    if _e3309 {
                                                        phi_5463_ = (0.5f * (_e3286 + (_e3276 / _e3286)));
                                                    } else {
                                                        phi_5463_ = f32();
                                                    }
                                                    let _e3314 = phi_5463_;
                                                    continue;
                                                    continuing {
                                                        phi_5459_ = _e3304;
                                                        phi_5462_ = _e3314;
                                                        break if !(_e3309);
                                                    }
                                                }
                                                let _e3319 = local_24;
                                                phi_5516_ = (_e3319 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3325 = phi_5516_;
                                            let _e3326 = (0.000000059604645f * 12f);
                                            let _e3328 = local_1.member_1;
                                            let _e3331 = local_1.member_2;
                                            let _e3335 = ((_e3328 * 1.01f) + ((_e3331 * _e3325) * (1f + _e3326)));
                                            let _e3339 = local_1.member[0u][0u];
                                            let _e3347 = (((_e3267 * _e3339[0]) + (_e3269 * _e3339[1])) + (_e3271 * _e3339[2]));
                                            let _e3351 = local_1.member[0u][1u];
                                            let _e3359 = (((_e3267 * _e3351[0]) + (_e3269 * _e3351[1])) + (_e3271 * _e3351[2]));
                                            let _e3363 = local_1.member[0u][2u];
                                            let _e3371 = (((_e3267 * _e3363[0]) + (_e3269 * _e3363[1])) + (_e3271 * _e3363[2]));
                                            let _e3375 = local_1.member[0u][3u];
                                            let _e3383 = (((_e3267 * _e3375[0]) + (_e3269 * _e3375[1])) + (_e3271 * _e3375[2]));
                                            let _e3387 = local_1.member[1u][0u];
                                            let _e3395 = (((_e3267 * _e3387[0]) + (_e3269 * _e3387[1])) + (_e3271 * _e3387[2]));
                                            let _e3399 = local_1.member[1u][1u];
                                            let _e3407 = (((_e3267 * _e3399[0]) + (_e3269 * _e3399[1])) + (_e3271 * _e3399[2]));
                                            let _e3411 = local_1.member[1u][2u];
                                            let _e3419 = (((_e3267 * _e3411[0]) + (_e3269 * _e3411[1])) + (_e3271 * _e3411[2]));
                                            let _e3423 = local_1.member[1u][3u];
                                            let _e3431 = (((_e3267 * _e3423[0]) + (_e3269 * _e3423[1])) + (_e3271 * _e3423[2]));
                                            local_2 = type_29(array<f32, 4>(_e3347, _e3359, _e3371, _e3383), array<f32, 4>(_e3395, _e3407, _e3419, _e3431), array<f32, 4>((_e3335 + ((select(_e3347, -(_e3347), (_e3347 < 0f)) + select(_e3395, -(_e3395), (_e3395 < 0f))) * _e3326)), (_e3335 + ((select(_e3359, -(_e3359), (_e3359 < 0f)) + select(_e3407, -(_e3407), (_e3407 < 0f))) * _e3326)), (_e3335 + ((select(_e3371, -(_e3371), (_e3371 < 0f)) + select(_e3419, -(_e3419), (_e3419 < 0f))) * _e3326)), (_e3335 + ((select(_e3383, -(_e3383), (_e3383 < 0f)) + select(_e3431, -(_e3431), (_e3431 < 0f))) * _e3326))));
                                            let _e3476 = (((_e3267 * _e3267) + (_e3269 * _e3269)) + (_e3271 * _e3271));
                                            if (_e3476 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5808_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3476 > 0f));
                                            } else {
                                                phi_5751_ = type_14(0i, 5i);
                                                phi_5754_ = bitcast<f32>(((bitcast<u32>(_e3476) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3484 = phi_5751_;
                                                    let _e3486 = phi_5754_;
                                                    local_25 = _e3486;
                                                    if (_e3484.member < _e3484.member_1) {
                                                        let _e3493 = (_e3484.member + 1i);
                                                        phi_5752_ = type_14(select(_e3493, type_15().member_1, select(false, true, ((false == (_e3493 > _e3484.member)) != false))), _e3484.member_1);
                                                        phi_5795_ = type_15(1u, _e3484.member);
                                                    } else {
                                                        phi_5752_ = _e3484;
                                                        phi_5795_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3504 = phi_5752_;
                                                    let _e3506 = phi_5795_;
                                                    let _e3509 = (bitcast<i32>(_e3506.member) != 0i);
                                                    if _e3509 {
                                                        phi_5755_ = (0.5f * (_e3486 + (_e3476 / _e3486)));
                                                    } else {
                                                        phi_5755_ = f32();
                                                    }
                                                    let _e3514 = phi_5755_;
                                                    continue;
                                                    continuing {
                                                        phi_5751_ = _e3504;
                                                        phi_5754_ = _e3514;
                                                        break if !(_e3509);
                                                    }
                                                }
                                                let _e3519 = local_25;
                                                phi_5808_ = (_e3519 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3525 = phi_5808_;
                                            let _e3536 = (((_e3033[0] * _e3033[0]) + (_e3033[1] * _e3033[1])) + (_e3033[2] * _e3033[2]));
                                            if (_e3536 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5897_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3536 > 0f));
                                            } else {
                                                phi_5840_ = type_14(0i, 5i);
                                                phi_5843_ = bitcast<f32>(((bitcast<u32>(_e3536) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3544 = phi_5840_;
                                                    let _e3546 = phi_5843_;
                                                    local_26 = _e3546;
                                                    if (_e3544.member < _e3544.member_1) {
                                                        let _e3553 = (_e3544.member + 1i);
                                                        phi_5841_ = type_14(select(_e3553, type_15().member_1, select(false, true, ((false == (_e3553 > _e3544.member)) != false))), _e3544.member_1);
                                                        phi_5884_ = type_15(1u, _e3544.member);
                                                    } else {
                                                        phi_5841_ = _e3544;
                                                        phi_5884_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3564 = phi_5841_;
                                                    let _e3566 = phi_5884_;
                                                    let _e3569 = (bitcast<i32>(_e3566.member) != 0i);
                                                    if _e3569 {
                                                        phi_5844_ = (0.5f * (_e3546 + (_e3536 / _e3546)));
                                                    } else {
                                                        phi_5844_ = f32();
                                                    }
                                                    let _e3574 = phi_5844_;
                                                    continue;
                                                    continuing {
                                                        phi_5840_ = _e3564;
                                                        phi_5843_ = _e3574;
                                                        break if !(_e3569);
                                                    }
                                                }
                                                let _e3579 = local_26;
                                                phi_5897_ = (_e3579 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3585 = phi_5897_;
                                            let _e3591 = local_5.member[0u];
                                            let _e3597 = select(_e3591[0], -(_e3591[0]), (_e3591[0] < 0f));
                                            let _e3600 = select(_e3591[1], -(_e3591[1]), (_e3591[1] < 0f));
                                            let _e3602 = select(_e3600, _e3597, (_e3597 > _e3600));
                                            let _e3605 = select(_e3591[2], -(_e3591[2]), (_e3591[2] < 0f));
                                            let _e3607 = select(_e3605, _e3602, (_e3602 > _e3605));
                                            let _e3610 = local_5.member[1u];
                                            let _e3616 = select(_e3610[0], -(_e3610[0]), (_e3610[0] < 0f));
                                            let _e3619 = select(_e3610[1], -(_e3610[1]), (_e3610[1] < 0f));
                                            let _e3621 = select(_e3619, _e3616, (_e3616 > _e3619));
                                            let _e3624 = select(_e3610[2], -(_e3610[2]), (_e3610[2] < 0f));
                                            let _e3626 = select(_e3624, _e3621, (_e3621 > _e3624));
                                            let _e3630 = local_5.member_3;
                                            let _e3634 = local_5.member_1[0u];
                                            let _e3640 = select(_e3634[0], -(_e3634[0]), (_e3634[0] < 0f));
                                            let _e3643 = select(_e3634[1], -(_e3634[1]), (_e3634[1] < 0f));
                                            let _e3645 = select(_e3643, _e3640, (_e3640 > _e3643));
                                            let _e3648 = select(_e3634[2], -(_e3634[2]), (_e3634[2] < 0f));
                                            let _e3650 = select(_e3648, _e3645, (_e3645 > _e3648));
                                            let _e3653 = local_5.member_1[1u];
                                            let _e3659 = select(_e3653[0], -(_e3653[0]), (_e3653[0] < 0f));
                                            let _e3662 = select(_e3653[1], -(_e3653[1]), (_e3653[1] < 0f));
                                            let _e3664 = select(_e3662, _e3659, (_e3659 > _e3662));
                                            let _e3667 = select(_e3653[2], -(_e3653[2]), (_e3653[2] < 0f));
                                            let _e3669 = select(_e3667, _e3664, (_e3664 > _e3667));
                                            let _e3673 = local_5.member_3;
                                            let _e3677 = local_5.member_2[0u];
                                            let _e3683 = select(_e3677[0], -(_e3677[0]), (_e3677[0] < 0f));
                                            let _e3686 = select(_e3677[1], -(_e3677[1]), (_e3677[1] < 0f));
                                            let _e3688 = select(_e3686, _e3683, (_e3683 > _e3686));
                                            let _e3691 = select(_e3677[2], -(_e3677[2]), (_e3677[2] < 0f));
                                            let _e3693 = select(_e3691, _e3688, (_e3688 > _e3691));
                                            let _e3696 = local_5.member_2[1u];
                                            let _e3702 = select(_e3696[0], -(_e3696[0]), (_e3696[0] < 0f));
                                            let _e3705 = select(_e3696[1], -(_e3696[1]), (_e3696[1] < 0f));
                                            let _e3707 = select(_e3705, _e3702, (_e3702 > _e3705));
                                            let _e3710 = select(_e3696[2], -(_e3696[2]), (_e3696[2] < 0f));
                                            let _e3712 = select(_e3710, _e3707, (_e3707 > _e3710));
                                            let _e3716 = local_5.member_3;
                                            let _e3723 = local_5.member_3;
                                            let _e3733 = ((((_e3585 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3626, _e3607, (_e3607 > _e3626)) + _e3630) + (select(_e3669, _e3650, (_e3650 > _e3669)) + _e3673)) + (select(_e3712, _e3693, (_e3693 > _e3712)) + _e3716)) * (0.000000059604645f * 16f)) + (_e3723 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3525) * (1f + (0.000000059604645f * 64f)));
                                            let _e3736 = local_2.member[0u];
                                            let _e3739 = local_2.member_1[0u];
                                            phi_6205_ = type_9(1u, 4u);
                                            phi_6208_ = ((_e3736 + ((_e3739 - _e3736) * _e1320)) - ((_e3260 * 1.01f) + ((select(_e3736, -(_e3736), (_e3736 < 0f)) + select(_e3739, -(_e3739), (_e3739 < 0f))) * (0.000000059604645f * 12f))));
                                            loop {
                                                let _e3756 = phi_6205_;
                                                let _e3758 = phi_6208_;
                                                local_27 = _e3758;
                                                local_28 = _e3758;
                                                let _e3761 = (_e3756.member < _e3756.member_1);
                                                let _e3772 = select(type_9().member_1, _e3756.member, _e3761);
                                                let _e3774 = (bitcast<i32>(select(0u, 1u, _e3761)) != 0i);
                                                if _e3774 {
                                                    let _e3777 = local_2.member[_e3772];
                                                    let _e3780 = local_2.member_1[_e3772];
                                                    let _e3795 = ((_e3777 + ((_e3780 - _e3777) * _e1320)) - ((_e3260 * 1.01f) + ((select(_e3777, -(_e3777), (_e3777 < 0f)) + select(_e3780, -(_e3780), (_e3780 < 0f))) * (0.000000059604645f * 12f))));
                                                    phi_6209_ = select(_e3795, _e3758, (_e3758 < _e3795));
                                                } else {
                                                    phi_6209_ = f32();
                                                }
                                                let _e3799 = phi_6209_;
                                                continue;
                                                continuing {
                                                    phi_6205_ = type_9(select(_e3756.member, (_e3756.member + 1u), _e3761), select(_e3756.member_1, _e3756.member_1, _e3761));
                                                    phi_6208_ = _e3799;
                                                    break if !(_e3774);
                                                }
                                            }
                                            let _e3802 = local_27;
                                            if (_e3802 > 0f) {
                                                let _e3806 = local_28;
                                                let _e3809 = (((_e3733 - _e3806) / _e3733) * 2.02f);
                                                if (_e3809 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_6364_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3809 > 0f));
                                                } else {
                                                    phi_6307_ = type_14(0i, 5i);
                                                    phi_6310_ = bitcast<f32>(((bitcast<u32>(_e3809) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3817 = phi_6307_;
                                                        let _e3819 = phi_6310_;
                                                        local_29 = _e3819;
                                                        if (_e3817.member < _e3817.member_1) {
                                                            let _e3826 = (_e3817.member + 1i);
                                                            phi_6308_ = type_14(select(_e3826, type_15().member_1, select(false, true, ((false == (_e3826 > _e3817.member)) != false))), _e3817.member_1);
                                                            phi_6351_ = type_15(1u, _e3817.member);
                                                        } else {
                                                            phi_6308_ = _e3817;
                                                            phi_6351_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3837 = phi_6308_;
                                                        let _e3839 = phi_6351_;
                                                        let _e3842 = (bitcast<i32>(_e3839.member) != 0i);
                                                        if _e3842 {
                                                            phi_6311_ = (0.5f * (_e3819 + (_e3809 / _e3819)));
                                                        } else {
                                                            phi_6311_ = f32();
                                                        }
                                                        let _e3847 = phi_6311_;
                                                        continue;
                                                        continuing {
                                                            phi_6307_ = _e3837;
                                                            phi_6310_ = _e3847;
                                                            break if !(_e3842);
                                                        }
                                                    }
                                                    let _e3852 = local_29;
                                                    phi_6364_ = (_e3852 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3858 = phi_6364_;
                                                let _e3860 = ((_e3858 * _e3525) * 1.01f);
                                                phi_6369_ = type_9(0u, 4u);
                                                phi_6372_ = 2f;
                                                phi_6374_ = true;
                                                phi_6376_ = true;
                                                loop {
                                                    let _e3862 = phi_6369_;
                                                    let _e3864 = phi_6372_;
                                                    let _e3866 = phi_6374_;
                                                    let _e3868 = phi_6376_;
                                                    local_30 = _e3864;
                                                    local_31 = _e3864;
                                                    local_32 = _e3866;
                                                    local_33 = _e3868;
                                                    local_34 = _e3868;
                                                    local_35 = _e3868;
                                                    local_60 = _e3868;
                                                    local_36 = _e3868;
                                                    let _e3871 = (_e3862.member < _e3862.member_1);
                                                    let _e3882 = select(type_9().member_1, _e3862.member, _e3871);
                                                    let _e3884 = (bitcast<i32>(select(0u, 1u, _e3871)) != 0i);
                                                    if _e3884 {
                                                        let _e3888 = local_1.member[0u][_e3882];
                                                        let _e3895 = local_1.member[1u][_e3882];
                                                        let _e3909 = ((select(_e3888[0], -(_e3888[0]), (_e3888[0] < 0f)) + select(_e3888[1], -(_e3888[1]), (_e3888[1] < 0f))) + select(_e3888[2], -(_e3888[2]), (_e3888[2] < 0f)));
                                                        let _e3920 = ((select(_e3895[0], -(_e3895[0]), (_e3895[0] < 0f)) + select(_e3895[1], -(_e3895[1]), (_e3895[1] < 0f))) + select(_e3895[2], -(_e3895[2]), (_e3895[2] < 0f)));
                                                        let _e3926 = (_e3895[0] - _e3888[0]);
                                                        let _e3927 = (_e3895[1] - _e3888[1]);
                                                        let _e3928 = (_e3895[2] - _e3888[2]);
                                                        let _e3945 = local_2.member[_e3882];
                                                        let _e3948 = local_2.member_1[_e3882];
                                                        let _e3959 = ((_e3260 * 1.01f) + ((select(_e3945, -(_e3945), (_e3945 < 0f)) + select(_e3948, -(_e3948), (_e3948 < 0f))) * (0.000000059604645f * 12f)));
                                                        let _e3966 = local_2.member_1[_e3882];
                                                        let _e3969 = local_2.member[_e3882];
                                                        let _e3970 = (_e3966 - _e3969);
                                                        let _e3973 = ((_e3959 + _e3959) + (_e3860 * ((((select(_e3926, -(_e3926), (_e3926 < 0f)) + select(_e3927, -(_e3927), (_e3927 < 0f))) + select(_e3928, -(_e3928), (_e3928 < 0f))) + (_e3260 * 6f)) * 1.01f)));
                                                        let _e3976 = ((((_e3945 + ((_e3948 - _e3945) * _e1320)) - _e3959) - (_e3860 * ((select(_e3920, _e3909, (_e3909 > _e3920)) + (_e3260 * 3f)) * 1.01f))) - _e3733);
                                                        let _e3977 = (_e3976 > 0.000000000000000000000000000000000000011754944f);
                                                        let _e3978 = (_e3970 > _e3973);
                                                        if _e3978 {
                                                            phi_6607_ = _e3864;
                                                        } else {
                                                            if _e3977 {
                                                                let _e3985 = (_e3973 - _e3970);
                                                                let _e3988 = (_e3976 / select(0.000000000000000000000000000000000000011754944f, _e3985, (_e3985 > 0.000000000000000000000000000000000000011754944f)));
                                                                phi_6606_ = select(_e3988, _e3864, (_e3864 < _e3988));
                                                            } else {
                                                                phi_6606_ = _e3864;
                                                            }
                                                            let _e3992 = phi_6606_;
                                                            phi_6607_ = _e3992;
                                                        }
                                                        let _e3994 = phi_6607_;
                                                        phi_6373_ = _e3994;
                                                        phi_6375_ = (_e3866 && select(_e3977, true, (_e3970 < -(_e3973))));
                                                        phi_6377_ = (_e3868 && select(_e3977, true, _e3978));
                                                    } else {
                                                        phi_6373_ = f32();
                                                        phi_6375_ = bool();
                                                        phi_6377_ = bool();
                                                    }
                                                    let _e3996 = phi_6373_;
                                                    let _e3998 = phi_6375_;
                                                    let _e4000 = phi_6377_;
                                                    continue;
                                                    continuing {
                                                        phi_6369_ = type_9(select(_e3862.member, (_e3862.member + 1u), _e3871), select(_e3862.member_1, _e3862.member_1, _e3871));
                                                        phi_6372_ = _e3996;
                                                        phi_6374_ = _e3998;
                                                        phi_6376_ = _e4000;
                                                        break if !(_e3884);
                                                    }
                                                }
                                                let _e4003 = local_30;
                                                let _e4006 = local_31;
                                                let _e4008 = (select(2f, _e4006, (_e4003 < 2f)) * 0.999f);
                                                let _e4010 = local_32;
                                                if _e4010 {
                                                    let _e4013 = local_33;
                                                    let _e4017 = local_34;
                                                    let _e4021 = local_35;
                                                    phi_6622_ = type_36(select(1u, type_36().member, _e4013), select(_e1320, type_36().member_1, _e4017), select(2f, type_36().member_2, _e4021));
                                                    let _e5173 = local_60;
                                                    phi_6623_ = _e5173;
                                                } else {
                                                    phi_6622_ = type_36();
                                                    phi_6623_ = true;
                                                }
                                                let _e4025 = phi_6622_;
                                                let _e4027 = phi_6623_;
                                                if _e4027 {
                                                    let _e4029 = local_36;
                                                    if _e4029 {
                                                        let _e4033 = (_e1320 + _e4008);
                                                        let _e4036 = select(_e1320, select(_e379, _e4033, (_e4033 < _e379)), (_e4008 > (0.000000059604645f * 4096f)));
                                                        phi_6644_ = type_9(0u, 4u);
                                                        phi_6647_ = _e4036;
                                                        phi_6649_ = _e1320;
                                                        loop {
                                                            let _e4038 = phi_6644_;
                                                            let _e4040 = phi_6647_;
                                                            let _e4042 = phi_6649_;
                                                            local_37 = _e4040;
                                                            local_38 = _e4042;
                                                            local_39 = _e4042;
                                                            let _e4045 = (_e4038.member < _e4038.member_1);
                                                            let _e4056 = select(type_9().member_1, _e4038.member, _e4045);
                                                            let _e4058 = (bitcast<i32>(select(0u, 1u, _e4045)) != 0i);
                                                            if _e4058 {
                                                                let _e4061 = local_2.member[_e4056];
                                                                let _e4064 = local_2.member_1[_e4056];
                                                                let _e4067 = local_2.member[_e4056];
                                                                let _e4073 = local_2.member_2[_e4056];
                                                                let _e4074 = ((_e4061 + ((_e4064 - _e4067) * _e1320)) - _e4073);
                                                                let _e4077 = local_2.member_1[_e4056];
                                                                let _e4080 = local_2.member[_e4056];
                                                                let _e4081 = (_e4077 - _e4080);
                                                                if (_e4081 > 0f) {
                                                                    let _e4094 = (_e1320 - (_e4074 / _e4081));
                                                                    phi_6758_ = _e4040;
                                                                    phi_6759_ = select(_e4094, _e4042, (_e4042 > _e4094));
                                                                } else {
                                                                    if (_e4074 > 0f) {
                                                                        if (_e4081 < 0f) {
                                                                            let _e4086 = (_e1320 - (_e4074 / _e4081));
                                                                            phi_6756_ = select(_e4086, _e4040, (_e4040 < _e4086));
                                                                        } else {
                                                                            phi_6756_ = _e4040;
                                                                        }
                                                                        let _e4090 = phi_6756_;
                                                                        phi_6757_ = _e4090;
                                                                    } else {
                                                                        phi_6757_ = _e4040;
                                                                    }
                                                                    let _e4092 = phi_6757_;
                                                                    phi_6758_ = _e4092;
                                                                    phi_6759_ = _e4042;
                                                                }
                                                                let _e4098 = phi_6758_;
                                                                let _e4100 = phi_6759_;
                                                                phi_6648_ = _e4098;
                                                                phi_6650_ = _e4100;
                                                            } else {
                                                                phi_6648_ = f32();
                                                                phi_6650_ = f32();
                                                            }
                                                            let _e4102 = phi_6648_;
                                                            let _e4104 = phi_6650_;
                                                            continue;
                                                            continuing {
                                                                phi_6644_ = type_9(select(_e4038.member, (_e4038.member + 1u), _e4045), select(_e4038.member_1, _e4038.member_1, _e4045));
                                                                phi_6647_ = _e4102;
                                                                phi_6649_ = _e4104;
                                                                break if !(_e4058);
                                                            }
                                                        }
                                                        let _e4107 = local_37;
                                                        let _e4109 = local_38;
                                                        let _e4113 = local_39;
                                                        let _e4114 = (_e4113 + ((_e4107 - _e4109) * 0.5f));
                                                        if (_e4114 > _e1320) {
                                                            if (_e4114 <= _e4036) {
                                                                let _e4119 = local_2.member[0u];
                                                                let _e4122 = local_2.member_1[0u];
                                                                let _e4125 = local_2.member[0u];
                                                                let _e4131 = local_2.member_2[0u];
                                                                if (((_e4119 + ((_e4122 - _e4125) * _e4114)) - _e4131) > 0f) {
                                                                    let _e4136 = local_2.member[1u];
                                                                    let _e4139 = local_2.member_1[1u];
                                                                    let _e4142 = local_2.member[1u];
                                                                    let _e4148 = local_2.member_2[1u];
                                                                    if (((_e4136 + ((_e4139 - _e4142) * _e4114)) - _e4148) > 0f) {
                                                                        let _e4153 = local_2.member[2u];
                                                                        let _e4156 = local_2.member_1[2u];
                                                                        let _e4159 = local_2.member[2u];
                                                                        let _e4165 = local_2.member_2[2u];
                                                                        if (((_e4153 + ((_e4156 - _e4159) * _e4114)) - _e4165) > 0f) {
                                                                            let _e4170 = local_2.member[3u];
                                                                            let _e4173 = local_2.member_1[3u];
                                                                            let _e4176 = local_2.member[3u];
                                                                            let _e4182 = local_2.member_2[3u];
                                                                            phi_6920_ = (((_e4170 + ((_e4173 - _e4176) * _e4114)) - _e4182) > 0f);
                                                                            phi_6921_ = false;
                                                                        } else {
                                                                            phi_6920_ = bool();
                                                                            phi_6921_ = true;
                                                                        }
                                                                        let _e4186 = phi_6920_;
                                                                        let _e4188 = phi_6921_;
                                                                        phi_6922_ = _e4186;
                                                                        phi_6923_ = _e4188;
                                                                    } else {
                                                                        phi_6922_ = bool();
                                                                        phi_6923_ = true;
                                                                    }
                                                                    let _e4190 = phi_6922_;
                                                                    let _e4192 = phi_6923_;
                                                                    phi_6924_ = _e4190;
                                                                    phi_6925_ = _e4192;
                                                                } else {
                                                                    phi_6924_ = bool();
                                                                    phi_6925_ = true;
                                                                }
                                                                let _e4194 = phi_6924_;
                                                                let _e4196 = phi_6925_;
                                                                phi_6934_ = select(true, false, select(_e4194, false, _e4196));
                                                            } else {
                                                                phi_6934_ = true;
                                                            }
                                                            let _e4200 = phi_6934_;
                                                            phi_6935_ = _e4200;
                                                        } else {
                                                            phi_6935_ = true;
                                                        }
                                                        let _e4202 = phi_6935_;
                                                        phi_6942_ = type_36(2u, _e4036, select(_e4114, 2f, _e4202));
                                                        phi_6943_ = type_36();
                                                        phi_6944_ = false;
                                                    } else {
                                                        phi_6942_ = type_36();
                                                        phi_6943_ = type_36(0u, _e1320, 2f);
                                                        phi_6944_ = true;
                                                    }
                                                    let _e4206 = phi_6942_;
                                                    let _e4208 = phi_6943_;
                                                    let _e4210 = phi_6944_;
                                                    phi_6945_ = _e4206;
                                                    phi_6946_ = _e4208;
                                                    phi_6947_ = _e4210;
                                                } else {
                                                    phi_6945_ = type_36();
                                                    phi_6946_ = _e4025;
                                                    phi_6947_ = true;
                                                }
                                                let _e4212 = phi_6945_;
                                                let _e4214 = phi_6946_;
                                                let _e4216 = phi_6947_;
                                                phi_6952_ = _e4214;
                                                phi_6953_ = _e4212;
                                                phi_6954_ = _e4216;
                                            } else {
                                                phi_6952_ = type_36(0u, _e1320, 2f);
                                                phi_6953_ = type_36();
                                                phi_6954_ = true;
                                            }
                                            let _e4218 = phi_6952_;
                                            let _e4220 = phi_6953_;
                                            let _e4222 = phi_6954_;
                                            phi_6958_ = _e4218;
                                            phi_6959_ = _e4220;
                                            phi_6960_ = false;
                                            phi_6961_ = _e4222;
                                        } else {
                                            phi_6958_ = type_36();
                                            phi_6959_ = type_36();
                                            phi_6960_ = true;
                                            phi_6961_ = false;
                                        }
                                        let _e4224 = phi_6958_;
                                        let _e4226 = phi_6959_;
                                        let _e4228 = phi_6960_;
                                        let _e4230 = phi_6961_;
                                        phi_6962_ = _e4224;
                                        phi_6963_ = _e4226;
                                        phi_6964_ = _e4228;
                                        phi_6965_ = _e4230;
                                    } else {
                                        phi_6962_ = type_36();
                                        phi_6963_ = type_36();
                                        phi_6964_ = true;
                                        phi_6965_ = false;
                                    }
                                    let _e4232 = phi_6962_;
                                    let _e4234 = phi_6963_;
                                    let _e4236 = phi_6964_;
                                    let _e4238 = phi_6965_;
                                    let _e4245 = select(_e4238, true, _e4236);
                                    let _e4247 = select(_e4234.member, select(_e4232.member, 0u, _e4236), _e4245);
                                    let _e4251 = select(_e4234.member_2, select(_e4232.member_2, 2f, _e4236), _e4245);
                                    if select(false, _e371, ((_e381 & 64u) != 0u)) {
                                        let _e4253 = (_e4247 == 2u);
                                        let _e4254 = (_e4251 <= _e379);
                                        phi_6999_ = select(f32(), select(f32(), _e4251, _e4254), _e4253);
                                        phi_7000_ = select(f32(), select(f32(), _e4251, _e4254), _e4253);
                                        phi_7001_ = select(false, _e4254, _e4253);
                                        phi_7002_ = select(false, select(true, false, _e4254), _e4253);
                                        phi_7003_ = select(true, false, _e4253);
                                    } else {
                                        phi_6999_ = f32();
                                        phi_7000_ = f32();
                                        phi_7001_ = false;
                                        phi_7002_ = false;
                                        phi_7003_ = true;
                                    }
                                    let _e4264 = phi_6999_;
                                    let _e4266 = phi_7000_;
                                    let _e4268 = phi_7001_;
                                    let _e4270 = phi_7002_;
                                    let _e4272 = phi_7003_;
                                    phi_7004_ = _e4264;
                                    phi_7005_ = _e4247;
                                    phi_7006_ = _e4266;
                                    phi_7007_ = type_36(_e4247, select(_e4234.member_1, select(_e4232.member_1, _e1320, _e4236), _e4245), _e4251);
                                    phi_7008_ = _e4247;
                                    phi_7009_ = _e4247;
                                    phi_7010_ = _e4268;
                                    phi_7011_ = _e4270;
                                    phi_7012_ = _e4272;
                                }
                                let _e4274 = phi_7004_;
                                let _e4276 = phi_7005_;
                                let _e4278 = phi_7006_;
                                let _e4280 = phi_7007_;
                                let _e4282 = phi_7008_;
                                let _e4284 = phi_7009_;
                                let _e4286 = phi_7010_;
                                let _e4288 = phi_7011_;
                                let _e4290 = phi_7012_;
                                phi_7013_ = _e4274;
                                phi_7014_ = _e4276;
                                phi_7015_ = _e4278;
                                phi_7016_ = _e4280;
                                phi_7017_ = _e4282;
                                phi_7018_ = _e4284;
                                phi_7019_ = _e4286;
                                phi_7020_ = _e2966;
                                phi_7021_ = _e4288;
                                phi_7022_ = _e4290;
                                phi_7023_ = false;
                            } else {
                                phi_7013_ = f32();
                                phi_7014_ = u32();
                                phi_7015_ = f32();
                                phi_7016_ = type_36();
                                phi_7017_ = u32();
                                phi_7018_ = u32();
                                phi_7019_ = false;
                                phi_7020_ = false;
                                phi_7021_ = false;
                                phi_7022_ = false;
                                phi_7023_ = true;
                            }
                            let _e4292 = phi_7013_;
                            let _e4294 = phi_7014_;
                            let _e4296 = phi_7015_;
                            let _e4298 = phi_7016_;
                            let _e4300 = phi_7017_;
                            let _e4302 = phi_7018_;
                            let _e4304 = phi_7019_;
                            let _e4306 = phi_7020_;
                            let _e4308 = phi_7021_;
                            let _e4310 = phi_7022_;
                            let _e4312 = phi_7023_;
                            phi_7024_ = _e2963;
                            phi_2099_ = _e4292;
                            phi_2101_ = _e4294;
                            phi_2103_ = _e4296;
                            phi_7025_ = _e4298;
                            phi_7026_ = _e4300;
                            phi_7027_ = _e2963;
                            phi_7028_ = _e4302;
                            phi_7029_ = _e4304;
                            phi_7030_ = _e4306;
                            phi_7031_ = _e4308;
                            phi_7032_ = _e4310;
                            phi_7033_ = false;
                            phi_7034_ = _e4312;
                        } else {
                            phi_7024_ = f32();
                            phi_2099_ = f32();
                            phi_2101_ = u32();
                            phi_2103_ = f32();
                            phi_7025_ = type_36();
                            phi_7026_ = u32();
                            phi_7027_ = f32();
                            phi_7028_ = u32();
                            phi_7029_ = false;
                            phi_7030_ = false;
                            phi_7031_ = false;
                            phi_7032_ = false;
                            phi_7033_ = true;
                            phi_7034_ = false;
                        }
                        let _e4314 = phi_7024_;
                        let _e4316 = phi_2099_;
                        let _e4318 = phi_2101_;
                        let _e4320 = phi_2103_;
                        let _e4322 = phi_7025_;
                        let _e4324 = phi_7026_;
                        let _e4326 = phi_7027_;
                        let _e4328 = phi_7028_;
                        let _e4330 = phi_7029_;
                        let _e4332 = phi_7030_;
                        let _e4334 = phi_7031_;
                        let _e4336 = phi_7032_;
                        let _e4338 = phi_7033_;
                        let _e4340 = phi_7034_;
                        local_40 = _e4332;
                        local_41 = _e4334;
                        local_42 = _e4332;
                        local_43 = _e4336;
                        local_44 = _e4332;
                        local_45 = _e4338;
                        local_46 = _e4332;
                        local_47 = _e4340;
                        local_48 = _e4322;
                        local_49 = _e4322;
                        local_50 = _e4324;
                        local_51 = _e4322;
                        local_61 = _e4332;
                        local_52 = _e4328;
                        local_54 = _e4326;
                        local_55 = _e4314;
                        continue;
                        continuing {
                            phi_2095_ = _e1338;
                            phi_2098_ = _e4316;
                            phi_2100_ = _e4318;
                            phi_2102_ = _e4320;
                            break if !(_e4330);
                        }
                    }
                    let _e4343 = local_40;
                    let _e4345 = local_41;
                    let _e4346 = select(_e4345, false, _e4343);
                    let _e4348 = local_42;
                    let _e4350 = local_43;
                    let _e4353 = local_44;
                    let _e4355 = local_45;
                    let _e4358 = local_46;
                    let _e4360 = local_47;
                    if _e4346 {
                        let _e4363 = local_48;
                        if (_e4363.member_1 >= _e379) {
                            phi_7063_ = type_35(type_34(0u, f32()), 0u);
                        } else {
                            let _e4367 = local_49;
                            let _e4371 = local_50;
                            let _e4374 = local_51;
                            phi_7063_ = type_35(type_34(2u, _e4374.member_1), select(_e4371, 0u, (_e4367.member_1 > _e377)));
                        }
                        let _e4381 = phi_7063_;
                        phi_7064_ = _e4381;
                        phi_7065_ = false;
                        phi_7066_ = false;
                        phi_7067_ = false;
                        phi_7068_ = false;
                    } else {
                        phi_7064_ = type_35();
                        phi_7065_ = select(_e4350, false, _e4348);
                        let _e5268 = local_61;
                        phi_7066_ = _e5268;
                        phi_7067_ = select(_e4355, false, _e4353);
                        phi_7068_ = select(_e4360, false, _e4358);
                    }
                    let _e4383 = phi_7064_;
                    let _e4385 = phi_7065_;
                    let _e4387 = phi_7066_;
                    let _e4389 = phi_7067_;
                    let _e4391 = phi_7068_;
                    let _e4393 = local_52;
                    let _e4395 = local_53;
                    let _e4398 = local_54;
                    let _e4400 = local_55;
                    let _e4402 = select(_e4387, true, _e4385);
                    let _e4407 = local_56;
                    let _e4408 = select(_e4407, select(_e4400, _e4398, _e4385), _e4402);
                    let _e4410 = local_57;
                    let _e4411 = select(_e4410, select(_e4395, _e4393, _e4385), _e4402);
                    if select(select(_e4389, false, _e4385), true, _e4402) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_7100_ = type_9(0u, 3u);
                        loop {
                            let _e4422 = phi_7100_;
                            let _e4425 = (_e4422.member < _e4422.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4425)) != 0i) {
                                let _e4440 = local[select(type_9().member_1, _e4422.member, _e4425)];
                                let _e4442 = (_e4408 + (select(0f, _e375, (_e375 >= (0.000000059604645f * 8f))) * _e4440));
                                let _e4444 = select(_e379, _e4442, (_e4442 < _e379));
                                let _e4447 = local_5.member[0u];
                                let _e4453 = local_5.member[1u];
                                let _e4469 = local_5.member_1[0u];
                                let _e4475 = local_5.member_1[1u];
                                let _e4491 = local_5.member_2[0u];
                                let _e4497 = local_5.member_2[1u];
                                let _e4511 = function_3(array<f32, 3>((_e4447[0] + ((_e4453[0] - _e4447[0]) * _e4444)), (_e4447[1] + ((_e4453[1] - _e4447[1]) * _e4444)), (_e4447[2] + ((_e4453[2] - _e4447[2]) * _e4444))), array<f32, 3>((_e4469[0] + ((_e4475[0] - _e4469[0]) * _e4444)), (_e4469[1] + ((_e4475[1] - _e4469[1]) * _e4444)), (_e4469[2] + ((_e4475[2] - _e4469[2]) * _e4444))), array<f32, 3>((_e4491[0] + ((_e4497[0] - _e4491[0]) * _e4444)), (_e4491[1] + ((_e4497[1] - _e4491[1]) * _e4444)), (_e4491[2] + ((_e4497[2] - _e4491[2]) * _e4444))), _e222.member);
                                let _e4522 = (((_e4511[0] * _e4511[0]) + (_e4511[1] * _e4511[1])) + (_e4511[2] * _e4511[2]));
                                if (_e4522 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_7332_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4522 > 0f));
                                } else {
                                    phi_7275_ = type_14(0i, 5i);
                                    phi_7278_ = bitcast<f32>(((bitcast<u32>(_e4522) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e4530 = phi_7275_;
                                        let _e4532 = phi_7278_;
                                        local_58 = _e4532;
                                        if (_e4530.member < _e4530.member_1) {
                                            let _e4539 = (_e4530.member + 1i);
                                            phi_7276_ = type_14(select(_e4539, type_15().member_1, select(false, true, ((false == (_e4539 > _e4530.member)) != false))), _e4530.member_1);
                                            phi_7319_ = type_15(1u, _e4530.member);
                                        } else {
                                            phi_7276_ = _e4530;
                                            phi_7319_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e4550 = phi_7276_;
                                        let _e4552 = phi_7319_;
                                        let _e4555 = (bitcast<i32>(_e4552.member) != 0i);
                                        if _e4555 {
                                            phi_7279_ = (0.5f * (_e4532 + (_e4522 / _e4532)));
                                        } else {
                                            phi_7279_ = f32();
                                        }
                                        let _e4560 = phi_7279_;
                                        continue;
                                        continuing {
                                            phi_7275_ = _e4550;
                                            phi_7278_ = _e4560;
                                            break if !(_e4555);
                                        }
                                    }
                                    let _e4565 = local_58;
                                    phi_7332_ = (_e4565 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e4571 = phi_7332_;
                                let _e4577 = local_5.member[0u];
                                let _e4583 = select(_e4577[0], -(_e4577[0]), (_e4577[0] < 0f));
                                let _e4586 = select(_e4577[1], -(_e4577[1]), (_e4577[1] < 0f));
                                let _e4588 = select(_e4586, _e4583, (_e4583 > _e4586));
                                let _e4591 = select(_e4577[2], -(_e4577[2]), (_e4577[2] < 0f));
                                let _e4593 = select(_e4591, _e4588, (_e4588 > _e4591));
                                let _e4596 = local_5.member[1u];
                                let _e4602 = select(_e4596[0], -(_e4596[0]), (_e4596[0] < 0f));
                                let _e4605 = select(_e4596[1], -(_e4596[1]), (_e4596[1] < 0f));
                                let _e4607 = select(_e4605, _e4602, (_e4602 > _e4605));
                                let _e4610 = select(_e4596[2], -(_e4596[2]), (_e4596[2] < 0f));
                                let _e4612 = select(_e4610, _e4607, (_e4607 > _e4610));
                                let _e4616 = local_5.member_3;
                                let _e4620 = local_5.member_1[0u];
                                let _e4626 = select(_e4620[0], -(_e4620[0]), (_e4620[0] < 0f));
                                let _e4629 = select(_e4620[1], -(_e4620[1]), (_e4620[1] < 0f));
                                let _e4631 = select(_e4629, _e4626, (_e4626 > _e4629));
                                let _e4634 = select(_e4620[2], -(_e4620[2]), (_e4620[2] < 0f));
                                let _e4636 = select(_e4634, _e4631, (_e4631 > _e4634));
                                let _e4639 = local_5.member_1[1u];
                                let _e4645 = select(_e4639[0], -(_e4639[0]), (_e4639[0] < 0f));
                                let _e4648 = select(_e4639[1], -(_e4639[1]), (_e4639[1] < 0f));
                                let _e4650 = select(_e4648, _e4645, (_e4645 > _e4648));
                                let _e4653 = select(_e4639[2], -(_e4639[2]), (_e4639[2] < 0f));
                                let _e4655 = select(_e4653, _e4650, (_e4650 > _e4653));
                                let _e4659 = local_5.member_3;
                                let _e4663 = local_5.member_2[0u];
                                let _e4669 = select(_e4663[0], -(_e4663[0]), (_e4663[0] < 0f));
                                let _e4672 = select(_e4663[1], -(_e4663[1]), (_e4663[1] < 0f));
                                let _e4674 = select(_e4672, _e4669, (_e4669 > _e4672));
                                let _e4677 = select(_e4663[2], -(_e4663[2]), (_e4663[2] < 0f));
                                let _e4679 = select(_e4677, _e4674, (_e4674 > _e4677));
                                let _e4682 = local_5.member_2[1u];
                                let _e4688 = select(_e4682[0], -(_e4682[0]), (_e4682[0] < 0f));
                                let _e4691 = select(_e4682[1], -(_e4682[1]), (_e4682[1] < 0f));
                                let _e4693 = select(_e4691, _e4688, (_e4688 > _e4691));
                                let _e4696 = select(_e4682[2], -(_e4682[2]), (_e4682[2] < 0f));
                                let _e4698 = select(_e4696, _e4693, (_e4693 > _e4696));
                                let _e4702 = local_5.member_3;
                                let _e4709 = local_5.member_3;
                                let _e4716 = (((_e4571 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4612, _e4593, (_e4593 > _e4612)) + _e4616) + (select(_e4655, _e4636, (_e4636 > _e4655)) + _e4659)) + (select(_e4698, _e4679, (_e4679 > _e4698)) + _e4702)) * (0.000000059604645f * 16f)) + (_e4709 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e606.member_1);
                                phi_7603_ = select(true, false, _e4716);
                                phi_7604_ = _e4716;
                            } else {
                                phi_7603_ = false;
                                phi_7604_ = false;
                            }
                            let _e4719 = phi_7603_;
                            let _e4721 = phi_7604_;
                            local_59 = _e4721;
                            continue;
                            continuing {
                                phi_7100_ = type_9(select(_e4422.member, (_e4422.member + 1u), _e4425), select(_e4422.member_1, _e4422.member_1, _e4425));
                                break if !(_e4719);
                            }
                        }
                        let _e4724 = local_59;
                        if _e4724 {
                            phi_7616_ = type_35(type_34(1u, _e4408), select(_e4411, 1u, (_e4408 > _e377)));
                            phi_7617_ = false;
                        } else {
                            phi_7616_ = type_35();
                            phi_7617_ = true;
                        }
                        let _e4730 = phi_7616_;
                        let _e4732 = phi_7617_;
                        if _e4732 {
                            phi_7629_ = type_35(type_34(2u, _e4408), select(_e4411, 0u, (_e4408 > _e377)));
                        } else {
                            phi_7629_ = _e4730;
                        }
                        let _e4738 = phi_7629_;
                        phi_7630_ = _e4738;
                        phi_7631_ = false;
                        phi_7632_ = false;
                    } else {
                        phi_7630_ = type_35();
                        phi_7631_ = select(select(_e4391, false, _e4385), false, _e4402);
                        phi_7632_ = select(select(_e4346, false, _e4385), false, _e4402);
                    }
                    let _e4740 = phi_7630_;
                    let _e4742 = phi_7631_;
                    let _e4744 = phi_7632_;
                    if _e4742 {
                        phi_7639_ = type_35(type_34(0u, f32()), 0u);
                        phi_7640_ = true;
                    } else {
                        phi_7639_ = _e4383;
                        phi_7640_ = _e4744;
                    }
                    let _e4748 = phi_7639_;
                    let _e4750 = phi_7640_;
                    phi_7644_ = _e4748;
                    phi_7645_ = _e4740;
                    phi_7646_ = _e4750;
                } else {
                    phi_7644_ = _e1310;
                    phi_7645_ = type_35();
                    phi_7646_ = true;
                }
                let _e4752 = phi_7644_;
                let _e4754 = phi_7645_;
                let _e4756 = phi_7646_;
                if _e4756 {
                    phi_7650_ = _e4752;
                } else {
                    phi_7650_ = _e4754;
                }
                let _e4758 = phi_7650_;
                switch bitcast<i32>(_e4758.member.member) {
                    case 0: {
                        phi_7668_ = type_37(0u, _e4758.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4769 = function_(_e4758.member.member_1);
                        phi_7668_ = type_37(0u, _e4758.member_1, _e4769, true);
                        break;
                    }
                    case 2: {
                        let _e4765 = function_(_e4758.member.member_1);
                        phi_7668_ = type_37(1u, _e4758.member_1, _e4765, true);
                        break;
                    }
                    default: {
                        phi_7668_ = type_37();
                        break;
                    }
                }
                let _e4773 = phi_7668_;
                let _e4777 = params.member.member.member_12;
                let _e4778 = bitcast<u32>(_e4777);
                if (_e4773.member_2[0] == select((_e4778 << bitcast<u32>(29i)), 0u, ((_e4778 & 2147483647u) < 8388608u))) {
                    let _e4788 = params.member.member.member_12;
                    let _e4789 = bitcast<u32>(_e4788);
                    let _e4790 = (_e4789 & 2147483647u);
                    phi_7708_ = (_e4773.member_2[1] == select(((_e4789 ^ _e4790) | ((_e4790 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4790 < 8388608u)));
                } else {
                    phi_7708_ = false;
                }
                let _e4800 = phi_7708_;
                let _e4802 = params.member.member.member_1;
                if ((_e4802 & 128u) != 0u) {
                    phi_7724_ = true;
                } else {
                    let _e4806 = params.member.member.member_1;
                    phi_7724_ = select(false, _e4800, ((_e4806 & 64u) != 0u));
                }
                let _e4811 = phi_7724_;
                let _e4816 = select(1u, _e4773.member, select(true, select(true, false, _e4811), _e4773.member_3));
                let _e4821 = select(false, (_e4816 == 0u), _e4773.member_3);
                if _e4821 {
                    let _e4826 = (_e4773.member_2[1] >> bitcast<u32>(20i));
                    if (_e4826 <= 896u) {
                        phi_7767_ = 0u;
                    } else {
                        phi_7767_ = ((((_e4826 - 896u) << bitcast<u32>(23i)) | ((_e4773.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4773.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e4841 = phi_7767_;
                    let _e4843 = atomicMin((&earliest.member[0u]), _e4841);
                }
                phi_7771_ = type_17(_e176, 0u, _e186, _e189, _e4773.member_2, _e4773.member_1);
                phi_7772_ = _e4821;
                phi_7773_ = (_e4816 != 0u);
            } else {
                phi_7771_ = type_17(_e176, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_7772_ = false;
                phi_7773_ = false;
            }
            let _e4845 = phi_7771_;
            let _e4847 = phi_7772_;
            let _e4849 = phi_7773_;
            let _e4852 = params.member.member.member_1;
            if ((_e4852 & 16u) != 0u) {
                if (_e99 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4847 {
                    let _e4858 = atomicAdd((&counters[0u]), 1u);
                    phi_7792_ = _e4858;
                } else {
                    phi_7792_ = 0u;
                }
                let _e4860 = phi_7792_;
                workgroupBarrier();
                if (_e99 == 0u) {
                    let _e4863 = atomicLoad((&counters[0u]));
                    if (_e4863 > 0u) {
                        let _e4866 = atomicAdd((&contacts.member[0u]), _e4863);
                        atomicStore((&counters[1u]), _e4866);
                    }
                }
                workgroupBarrier();
                let _e4869 = atomicLoad((&counters[1u]));
                let _e4870 = (_e4869 + _e4860);
                if _e4847 {
                    let _e4873 = params.member.member_1.member_3;
                    if (_e4870 < _e4873) {
                        let _e4875 = (7u * _e4870);
                        atomicStore((&contacts.member[(4u + _e4875)]), _e4845.member);
                        atomicStore((&contacts.member[(_e4875 + 5u)]), _e4845.member_1);
                        atomicStore((&contacts.member[(_e4875 + 6u)]), _e4845.member_2);
                        atomicStore((&contacts.member[(_e4875 + 7u)]), _e4845.member_3);
                        atomicStore((&contacts.member[(_e4875 + 8u)]), _e4845.member_4[0]);
                        atomicStore((&contacts.member[(_e4875 + 9u)]), _e4845.member_4[1]);
                        atomicStore((&contacts.member[(_e4875 + 10u)]), _e4845.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e99 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4849 {
                let _e4902 = atomicAdd((&counters[0u]), 1u);
                phi_7859_ = _e4902;
            } else {
                phi_7859_ = 0u;
            }
            let _e4904 = phi_7859_;
            workgroupBarrier();
            if (_e99 == 0u) {
                let _e4907 = atomicLoad((&counters[0u]));
                if (_e4907 > 0u) {
                    let _e4910 = atomicAdd((&undecided.member[0u]), _e4907);
                    atomicStore((&counters[1u]), _e4910);
                }
            }
            workgroupBarrier();
            let _e4913 = atomicLoad((&counters[1u]));
            let _e4914 = (_e4913 + _e4904);
            if _e4849 {
                let _e4920 = params.member.member_2.member.member_1;
                if (_e4914 < _e4920) {
                    let _e4922 = (2u * _e4914);
                    atomicStore((&undecided.member[(4u + _e4922)]), _e4845.member_2);
                    atomicStore((&undecided.member[(_e4922 + 5u)]), _e4845.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_274_ = type_9(select(_e152.member, (_e152.member + 1u), _e155), select(_e152.member_1, _e152.member_1, _e155));
            break if !(_e168);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
