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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_21 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_22 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_29 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_30 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_31 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_32 {
    member: type_27,
    member_1: f32,
}

struct type_33 {
    member: u32,
    member_1: f32,
}

struct type_34 {
    member: type_33,
    member_1: u32,
}

struct type_35 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(3) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_13;
@group(0) @binding(1) 
var<storage> paths: type_24;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_39;

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
    var phi_8396_: array<array<f32, 3>, 4>;

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
        phi_8396_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8396_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8396_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8024_: bool;
    var phi_8057_: array<f32, 3>;
    var phi_8058_: bool;
    var phi_8059_: array<f32, 3>;
    var phi_8060_: bool;
    var phi_8065_: array<f32, 3>;

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
        phi_8024_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8024_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8024_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8057_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8058_ = false;
        } else {
            phi_8057_ = array<f32, 3>();
            phi_8058_ = true;
        }
        let _e129 = phi_8057_;
        let _e131 = phi_8058_;
        phi_8059_ = _e129;
        phi_8060_ = _e131;
    } else {
        phi_8059_ = array<f32, 3>();
        phi_8060_ = true;
    }
    let _e133 = phi_8059_;
    let _e135 = phi_8060_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8065_ = _e136;
    } else {
        phi_8065_ = _e133;
    }
    let _e138 = phi_8065_;
    return _e138;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_29;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_27;
    var phi_228_: u32;
    var phi_274_: u32;
    var phi_277_: type_9;
    var phi_445_: type_21;
    var phi_580_: type_27;
    var phi_609_: bool;
    var phi_857_: bool;
    var phi_951_: type_32;
    var phi_952_: bool;
    var phi_953_: type_32;
    var phi_954_: bool;
    var phi_955_: type_32;
    var phi_956_: bool;
    var phi_961_: type_32;
    var phi_1131_: type_16;
    var phi_1134_: f32;
    var phi_1132_: type_16;
    var phi_1175_: type_17;
    var phi_1135_: f32;
    var local_6: f32;
    var phi_1188_: f32;
    var phi_2097_: type_34;
    var phi_2098_: bool;
    var phi_2099_: type_34;
    var phi_2100_: bool;
    var phi_2106_: type_16;
    var phi_2109_: f32;
    var phi_2111_: u32;
    var phi_2113_: f32;
    var phi_2107_: type_16;
    var phi_2154_: type_17;
    var phi_2591_: type_9;
    var phi_2594_: f32;
    var phi_2596_: f32;
    var phi_2598_: f32;
    var phi_2600_: f32;
    var phi_2602_: bool;
    var phi_2604_: u32;
    var phi_2755_: array<f32, 3>;
    var phi_2821_: type_16;
    var phi_2824_: f32;
    var phi_2822_: type_16;
    var phi_2865_: type_17;
    var phi_2825_: f32;
    var local_7: f32;
    var phi_2878_: f32;
    var phi_3001_: type_30;
    var phi_3002_: bool;
    var phi_3003_: type_30;
    var phi_3004_: bool;
    var phi_3012_: type_30;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var phi_3489_: bool;
    var phi_3490_: bool;
    var phi_3491_: bool;
    var phi_3492_: bool;
    var phi_3493_: bool;
    var phi_3494_: bool;
    var phi_3502_: bool;
    var phi_3609_: f32;
    var phi_3610_: bool;
    var phi_3611_: f32;
    var phi_3612_: bool;
    var phi_3613_: f32;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3677_: f32;
    var phi_3678_: bool;
    var phi_3679_: f32;
    var phi_3680_: bool;
    var phi_3681_: f32;
    var phi_3682_: bool;
    var phi_3683_: bool;
    var phi_3750_: f32;
    var phi_3751_: bool;
    var phi_3752_: f32;
    var phi_3753_: bool;
    var phi_3754_: f32;
    var phi_3755_: bool;
    var phi_3756_: bool;
    var phi_3818_: f32;
    var phi_3819_: bool;
    var phi_3820_: f32;
    var phi_3821_: bool;
    var phi_3822_: f32;
    var phi_3823_: bool;
    var phi_3824_: bool;
    var phi_3998_: type_16;
    var phi_4001_: f32;
    var phi_3999_: type_16;
    var phi_4042_: type_17;
    var phi_4002_: f32;
    var local_8: f32;
    var phi_4055_: f32;
    var phi_4326_: bool;
    var phi_4327_: bool;
    var phi_4353_: f32;
    var phi_4354_: f32;
    var phi_4355_: bool;
    var phi_4356_: bool;
    var phi_4357_: f32;
    var phi_4358_: f32;
    var phi_4359_: f32;
    var phi_4360_: f32;
    var phi_4361_: bool;
    var phi_4362_: bool;
    var phi_4363_: bool;
    var phi_4364_: bool;
    var phi_4365_: f32;
    var phi_4366_: f32;
    var phi_4367_: f32;
    var phi_4368_: f32;
    var phi_4369_: bool;
    var phi_4370_: bool;
    var phi_4371_: bool;
    var phi_4372_: bool;
    var phi_4373_: bool;
    var phi_4374_: f32;
    var phi_4375_: f32;
    var phi_4376_: f32;
    var phi_4377_: f32;
    var phi_4378_: bool;
    var phi_4379_: bool;
    var phi_4380_: bool;
    var phi_4381_: bool;
    var phi_4382_: bool;
    var phi_4715_: f32;
    var phi_4717_: u32;
    var phi_4718_: f32;
    var phi_4719_: bool;
    var phi_4720_: bool;
    var phi_4721_: bool;
    var phi_4722_: u32;
    var phi_4723_: f32;
    var phi_4724_: f32;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4727_: bool;
    var phi_4728_: u32;
    var phi_4729_: bool;
    var phi_4730_: bool;
    var phi_4731_: bool;
    var phi_4732_: bool;
    var phi_4733_: bool;
    var phi_4734_: bool;
    var phi_4762_: f32;
    var phi_4763_: f32;
    var phi_4764_: f32;
    var phi_4765_: f32;
    var phi_4766_: bool;
    var phi_4767_: u32;
    var phi_4768_: bool;
    var phi_4769_: bool;
    var phi_4770_: bool;
    var phi_4771_: bool;
    var phi_4772_: bool;
    var phi_4773_: bool;
    var phi_2595_: f32;
    var phi_2597_: f32;
    var phi_2599_: f32;
    var phi_2601_: f32;
    var phi_2603_: bool;
    var phi_2605_: u32;
    var phi_4774_: f32;
    var phi_4775_: f32;
    var phi_4776_: bool;
    var phi_4777_: bool;
    var phi_4778_: bool;
    var phi_4779_: bool;
    var phi_4780_: bool;
    var phi_4781_: bool;
    var phi_4782_: bool;
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
    var phi_4849_: f32;
    var phi_4850_: bool;
    var phi_5470_: type_16;
    var phi_5473_: f32;
    var phi_5471_: type_16;
    var phi_5514_: type_17;
    var phi_5474_: f32;
    var local_24: f32;
    var phi_5527_: f32;
    var phi_5762_: type_16;
    var phi_5765_: f32;
    var phi_5763_: type_16;
    var phi_5806_: type_17;
    var phi_5766_: f32;
    var local_25: f32;
    var phi_5819_: f32;
    var phi_5851_: type_16;
    var phi_5854_: f32;
    var phi_5852_: type_16;
    var phi_5895_: type_17;
    var phi_5855_: f32;
    var local_26: f32;
    var phi_5908_: f32;
    var phi_6216_: type_9;
    var phi_6219_: f32;
    var phi_6220_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_6318_: type_16;
    var phi_6321_: f32;
    var phi_6319_: type_16;
    var phi_6362_: type_17;
    var phi_6322_: f32;
    var local_29: f32;
    var phi_6375_: f32;
    var phi_6380_: type_9;
    var phi_6383_: f32;
    var phi_6385_: bool;
    var phi_6387_: bool;
    var phi_6617_: f32;
    var phi_6618_: f32;
    var phi_6384_: f32;
    var phi_6386_: bool;
    var phi_6388_: bool;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_6633_: type_35;
    var phi_6634_: bool;
    var local_36: bool;
    var phi_6655_: type_9;
    var phi_6658_: f32;
    var phi_6660_: f32;
    var phi_6767_: f32;
    var phi_6768_: f32;
    var phi_6769_: f32;
    var phi_6770_: f32;
    var phi_6659_: f32;
    var phi_6661_: f32;
    var local_37: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6931_: bool;
    var phi_6932_: bool;
    var phi_6933_: bool;
    var phi_6934_: bool;
    var phi_6935_: bool;
    var phi_6936_: bool;
    var phi_6945_: bool;
    var phi_6946_: bool;
    var phi_6953_: type_35;
    var phi_6954_: type_35;
    var phi_6955_: bool;
    var phi_6956_: type_35;
    var phi_6957_: type_35;
    var phi_6958_: bool;
    var phi_6963_: type_35;
    var phi_6964_: type_35;
    var phi_6965_: bool;
    var phi_6969_: type_35;
    var phi_6970_: type_35;
    var phi_6971_: bool;
    var phi_6972_: bool;
    var phi_6973_: type_35;
    var phi_6974_: type_35;
    var phi_6975_: bool;
    var phi_6976_: bool;
    var phi_7010_: f32;
    var phi_7011_: f32;
    var phi_7012_: bool;
    var phi_7013_: bool;
    var phi_7014_: bool;
    var phi_7015_: f32;
    var phi_7016_: u32;
    var phi_7017_: f32;
    var phi_7018_: type_35;
    var phi_7019_: u32;
    var phi_7020_: u32;
    var phi_7021_: bool;
    var phi_7022_: bool;
    var phi_7023_: bool;
    var phi_7024_: f32;
    var phi_7025_: u32;
    var phi_7026_: f32;
    var phi_7027_: type_35;
    var phi_7028_: u32;
    var phi_7029_: u32;
    var phi_7030_: bool;
    var phi_7031_: bool;
    var phi_7032_: bool;
    var phi_7033_: bool;
    var phi_7034_: bool;
    var phi_7035_: f32;
    var phi_2110_: f32;
    var phi_2112_: u32;
    var phi_2114_: f32;
    var phi_7036_: type_35;
    var phi_7037_: u32;
    var phi_7038_: f32;
    var phi_7039_: u32;
    var phi_7040_: bool;
    var phi_7041_: bool;
    var phi_7042_: bool;
    var phi_7043_: bool;
    var phi_7044_: bool;
    var phi_7045_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_35;
    var local_49: type_35;
    var local_50: u32;
    var local_51: type_35;
    var phi_7074_: type_34;
    var phi_7075_: type_34;
    var phi_7076_: bool;
    var phi_7077_: bool;
    var phi_7078_: bool;
    var phi_7079_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: u32;
    var phi_7111_: type_9;
    var phi_7286_: type_16;
    var phi_7289_: f32;
    var phi_7287_: type_16;
    var phi_7330_: type_17;
    var phi_7290_: f32;
    var local_58: f32;
    var phi_7343_: f32;
    var phi_7614_: bool;
    var phi_7615_: bool;
    var local_59: bool;
    var phi_7627_: type_34;
    var phi_7628_: bool;
    var phi_7640_: type_34;
    var phi_7641_: type_34;
    var phi_7642_: bool;
    var phi_7643_: bool;
    var phi_7650_: type_34;
    var phi_7651_: bool;
    var phi_7655_: type_34;
    var phi_7656_: type_34;
    var phi_7657_: bool;
    var phi_7661_: type_34;
    var phi_7679_: type_31;
    var phi_7719_: bool;
    var phi_7735_: bool;
    var phi_7754_: type_31;
    var phi_7755_: type_31;
    var phi_7756_: type_9;
    var phi_7786_: u32;
    var phi_7808_: u32;
    var phi_7874_: u32;
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
        phi_228_ = (_e125 - _e130);
    } else {
        phi_228_ = 0u;
    }
    let _e133 = phi_228_;
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
        phi_274_ = select(_e147, (_e147 + 1u), ((_e145 % _e118) > 0u));
    } else {
        phi_274_ = 0u;
    }
    let _e154 = phi_274_;
    phi_277_ = type_9(0u, _e154);
    loop {
        let _e157 = phi_277_;
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
                    phi_7754_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    let _e195 = params.member.member_2.member;
                    if (_e195 == 0u) {
                        let _e212 = (3u * _e189);
                        let _e214 = elements.member[_e212];
                        let _e217 = elements.member[(_e212 + 1u)];
                        let _e220 = elements.member[(_e212 + 2u)];
                        phi_445_ = type_21(0u, array<u32, 4>(_e190, _e214, _e217, _e220));
                    } else {
                        let _e198 = (2u * _e190);
                        let _e199 = (2u * _e189);
                        let _e201 = elements.member[_e198];
                        let _e203 = elements.member[_e199];
                        let _e206 = elements.member[(_e198 + 1u)];
                        let _e209 = elements.member[(_e199 + 1u)];
                        phi_445_ = type_21(1u, array<u32, 4>(_e201, _e206, _e203, _e209));
                    }
                    let _e224 = phi_445_;
                    let _e229 = paths.member[_e224.member_1[0]];
                    let _e244 = paths.member[_e224.member_1[1]];
                    let _e259 = paths.member[_e224.member_1[2]];
                    let _e274 = paths.member[_e224.member_1[3]];
                    let _e288 = params.member.member.member_4;
                    if (_e224.member != 0u) {
                        phi_580_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e229.member.x), (_e259.member.y - _e229.member.y), (_e259.member.z - _e229.member.z)), array<f32, 3>((_e259.member_1.x - _e229.member_1.x), (_e259.member_1.y - _e229.member_1.y), (_e259.member_1.z - _e229.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e244.member.x - _e229.member.x), (_e244.member.y - _e229.member.y), (_e244.member.z - _e229.member.z)), array<f32, 3>((_e244.member_1.x - _e229.member_1.x), (_e244.member_1.y - _e229.member_1.y), (_e244.member_1.z - _e229.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e274.member.x), (_e259.member.y - _e274.member.y), (_e259.member.z - _e274.member.z)), array<f32, 3>((_e259.member_1.x - _e274.member_1.x), (_e259.member_1.y - _e274.member_1.y), (_e259.member_1.z - _e274.member_1.z))), (_e288 + _e288));
                    } else {
                        phi_580_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e229.member.x - _e244.member.x), (_e229.member.y - _e244.member.y), (_e229.member.z - _e244.member.z)), array<f32, 3>((_e229.member_1.x - _e244.member_1.x), (_e229.member_1.y - _e244.member_1.y), (_e229.member_1.z - _e244.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e244.member.x), (_e259.member.y - _e244.member.y), (_e259.member.z - _e244.member.z)), array<f32, 3>((_e259.member_1.x - _e244.member_1.x), (_e259.member_1.y - _e244.member_1.y), (_e259.member_1.z - _e244.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e274.member.x - _e244.member.x), (_e274.member.y - _e244.member.y), (_e274.member.z - _e244.member.z)), array<f32, 3>((_e274.member_1.x - _e244.member_1.x), (_e274.member_1.y - _e244.member_1.y), (_e274.member_1.z - _e244.member_1.z))), (_e288 + _e288));
                    }
                    let _e349 = phi_580_;
                    let _e351 = params.member.member.member_12;
                    let _e352 = bitcast<u32>(_e351);
                    let _e353 = (_e352 & 2147483647u);
                    let _e354 = (_e353 < 8388608u);
                    let _e366 = params.member.member.member_15[0u];
                    if (select((_e352 << bitcast<u32>(29i)), 0u, _e354) == _e366) {
                        let _e370 = params.member.member.member_15[1u];
                        phi_609_ = (select(((_e352 ^ _e353) | ((_e353 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e354) == _e370);
                    } else {
                        phi_609_ = false;
                    }
                    let _e373 = phi_609_;
                    let _e375 = params.member.member.member_5;
                    let _e377 = params.member.member.member_11;
                    let _e379 = params.member.member.member_12;
                    let _e381 = params.member.member.member_13;
                    let _e383 = params.member.member.member_1;
                    let _e392 = select(_e349.member[0][0], -(_e349.member[0][0]), (_e349.member[0][0] < 0f));
                    let _e396 = select(_e349.member[0][1], -(_e349.member[0][1]), (_e349.member[0][1] < 0f));
                    let _e398 = select(_e396, _e392, (_e392 > _e396));
                    let _e402 = select(_e349.member[0][2], -(_e349.member[0][2]), (_e349.member[0][2] < 0f));
                    let _e404 = select(_e402, _e398, (_e398 > _e402));
                    let _e410 = select(_e349.member[1][0], -(_e349.member[1][0]), (_e349.member[1][0] < 0f));
                    let _e414 = select(_e349.member[1][1], -(_e349.member[1][1]), (_e349.member[1][1] < 0f));
                    let _e416 = select(_e414, _e410, (_e410 > _e414));
                    let _e420 = select(_e349.member[1][2], -(_e349.member[1][2]), (_e349.member[1][2] < 0f));
                    let _e422 = select(_e420, _e416, (_e416 > _e420));
                    let _e426 = (select(_e422, _e404, (_e404 > _e422)) + _e349.member_3);
                    let _e432 = select(_e349.member_1[0][0], -(_e349.member_1[0][0]), (_e349.member_1[0][0] < 0f));
                    let _e436 = select(_e349.member_1[0][1], -(_e349.member_1[0][1]), (_e349.member_1[0][1] < 0f));
                    let _e438 = select(_e436, _e432, (_e432 > _e436));
                    let _e442 = select(_e349.member_1[0][2], -(_e349.member_1[0][2]), (_e349.member_1[0][2] < 0f));
                    let _e444 = select(_e442, _e438, (_e438 > _e442));
                    let _e450 = select(_e349.member_1[1][0], -(_e349.member_1[1][0]), (_e349.member_1[1][0] < 0f));
                    let _e454 = select(_e349.member_1[1][1], -(_e349.member_1[1][1]), (_e349.member_1[1][1] < 0f));
                    let _e456 = select(_e454, _e450, (_e450 > _e454));
                    let _e460 = select(_e349.member_1[1][2], -(_e349.member_1[1][2]), (_e349.member_1[1][2] < 0f));
                    let _e462 = select(_e460, _e456, (_e456 > _e460));
                    let _e466 = (select(_e462, _e444, (_e444 > _e462)) + _e349.member_3);
                    let _e472 = select(_e349.member_2[0][0], -(_e349.member_2[0][0]), (_e349.member_2[0][0] < 0f));
                    let _e476 = select(_e349.member_2[0][1], -(_e349.member_2[0][1]), (_e349.member_2[0][1] < 0f));
                    let _e478 = select(_e476, _e472, (_e472 > _e476));
                    let _e482 = select(_e349.member_2[0][2], -(_e349.member_2[0][2]), (_e349.member_2[0][2] < 0f));
                    let _e484 = select(_e482, _e478, (_e478 > _e482));
                    let _e490 = select(_e349.member_2[1][0], -(_e349.member_2[1][0]), (_e349.member_2[1][0] < 0f));
                    let _e494 = select(_e349.member_2[1][1], -(_e349.member_2[1][1]), (_e349.member_2[1][1] < 0f));
                    let _e496 = select(_e494, _e490, (_e490 > _e494));
                    let _e500 = select(_e349.member_2[1][2], -(_e349.member_2[1][2]), (_e349.member_2[1][2] < 0f));
                    let _e502 = select(_e500, _e496, (_e496 > _e500));
                    let _e506 = (select(_e502, _e484, (_e484 > _e502)) + _e349.member_3);
                    let _e508 = select(_e466, _e426, (_e426 > _e466));
                    let _e510 = select(_e506, _e508, (_e508 > _e506));
                    if (_e510 <= 65536f) {
                        phi_857_ = (_e510 >= (1f / 65536f));
                    } else {
                        phi_857_ = false;
                    }
                    let _e515 = phi_857_;
                    if _e515 {
                        phi_955_ = type_32();
                        phi_956_ = true;
                    } else {
                        if (_e510 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e510) & 2139095040u) != 2139095040u) {
                                let _e522 = (2130706432u - (bitcast<u32>(_e510) & 2139095040u));
                                let _e525 = bitcast<f32>(select(8388608u, _e522, (_e522 > 8388608u)));
                                let _e526 = (_e375 * _e525);
                                phi_951_ = type_32(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e349.member[0][0] * _e525), (_e349.member[0][1] * _e525), (_e349.member[0][2] * _e525)), array<f32, 3>((_e349.member[1][0] * _e525), (_e349.member[1][1] * _e525), (_e349.member[1][2] * _e525))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_1[0][0] * _e525), (_e349.member_1[0][1] * _e525), (_e349.member_1[0][2] * _e525)), array<f32, 3>((_e349.member_1[1][0] * _e525), (_e349.member_1[1][1] * _e525), (_e349.member_1[1][2] * _e525))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_2[0][0] * _e525), (_e349.member_2[0][1] * _e525), (_e349.member_2[0][2] * _e525)), array<f32, 3>((_e349.member_2[1][0] * _e525), (_e349.member_2[1][1] * _e525), (_e349.member_2[1][2] * _e525))), ((_e349.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e525)), select(_e526, select(0.000000000000000000000000000000000000011754944f, _e526, (_e526 > 0.000000000000000000000000000000000000011754944f)), (_e375 > 0f)));
                                phi_952_ = false;
                            } else {
                                phi_951_ = type_32();
                                phi_952_ = true;
                            }
                            let _e595 = phi_951_;
                            let _e597 = phi_952_;
                            phi_953_ = _e595;
                            phi_954_ = _e597;
                        } else {
                            phi_953_ = type_32();
                            phi_954_ = true;
                        }
                        let _e599 = phi_953_;
                        let _e601 = phi_954_;
                        phi_955_ = _e599;
                        phi_956_ = _e601;
                    }
                    let _e603 = phi_955_;
                    let _e605 = phi_956_;
                    if _e605 {
                        phi_961_ = type_32(_e349, _e375);
                    } else {
                        phi_961_ = _e603;
                    }
                    let _e608 = phi_961_;
                    local_5 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e608.member.member[0][0], _e608.member.member[0][1], _e608.member.member[0][2]), array<f32, 3>(_e608.member.member[1][0], _e608.member.member[1][1], _e608.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e608.member.member_1[0][0], _e608.member.member_1[0][1], _e608.member.member_1[0][2]), array<f32, 3>(_e608.member.member_1[1][0], _e608.member.member_1[1][1], _e608.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e608.member.member_2[0][0], _e608.member.member_2[0][1], _e608.member.member_2[0][2]), array<f32, 3>(_e608.member.member_2[1][0], _e608.member.member_2[1][1], _e608.member.member_2[1][2])), _e608.member.member_3);
                    let _e651 = local_5.member[0u];
                    let _e657 = local_5.member[1u];
                    let _e673 = local_5.member_1[0u];
                    let _e679 = local_5.member_1[1u];
                    let _e695 = local_5.member_2[0u];
                    let _e701 = local_5.member_2[1u];
                    let _e715 = function_3(array<f32, 3>((_e651[0] + ((_e657[0] - _e651[0]) * _e379)), (_e651[1] + ((_e657[1] - _e651[1]) * _e379)), (_e651[2] + ((_e657[2] - _e651[2]) * _e379))), array<f32, 3>((_e673[0] + ((_e679[0] - _e673[0]) * _e379)), (_e673[1] + ((_e679[1] - _e673[1]) * _e379)), (_e673[2] + ((_e679[2] - _e673[2]) * _e379))), array<f32, 3>((_e695[0] + ((_e701[0] - _e695[0]) * _e379)), (_e695[1] + ((_e701[1] - _e695[1]) * _e379)), (_e695[2] + ((_e701[2] - _e695[2]) * _e379))), _e224.member);
                    let _e726 = (((_e715[0] * _e715[0]) + (_e715[1] * _e715[1])) + (_e715[2] * _e715[2]));
                    if (_e726 <= 0.000000000000000000000000000000000000011754944f) {
                        phi_1188_ = select(0f, (0.000000000000000000106433627f * 2f), (_e726 > 0f));
                    } else {
                        phi_1131_ = type_16(0i, 5i);
                        phi_1134_ = bitcast<f32>(((bitcast<u32>(_e726) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e734 = phi_1131_;
                            let _e736 = phi_1134_;
                            local_6 = _e736;
                            if (_e734.member < _e734.member_1) {
                                let _e743 = (_e734.member + 1i);
                                phi_1132_ = type_16(select(_e743, type_17().member_1, select(false, true, ((false == (_e743 > _e734.member)) != false))), _e734.member_1);
                                phi_1175_ = type_17(1u, _e734.member);
                            } else {
                                phi_1132_ = _e734;
                                phi_1175_ = type_17(0u, type_17().member_1);
                            }
                            let _e754 = phi_1132_;
                            let _e756 = phi_1175_;
                            let _e759 = (bitcast<i32>(_e756.member) != 0i);
                            if _e759 {
                                phi_1135_ = (0.5f * (_e736 + (_e726 / _e736)));
                            } else {
                                phi_1135_ = f32();
                            }
                            let _e764 = phi_1135_;
                            continue;
                            continuing {
                                phi_1131_ = _e754;
                                phi_1134_ = _e764;
                                break if !(_e759);
                            }
                        }
                        let _e769 = local_6;
                        phi_1188_ = (_e769 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e775 = phi_1188_;
                    let _e781 = local_5.member[0u];
                    let _e787 = select(_e781[0], -(_e781[0]), (_e781[0] < 0f));
                    let _e790 = select(_e781[1], -(_e781[1]), (_e781[1] < 0f));
                    let _e792 = select(_e790, _e787, (_e787 > _e790));
                    let _e795 = select(_e781[2], -(_e781[2]), (_e781[2] < 0f));
                    let _e797 = select(_e795, _e792, (_e792 > _e795));
                    let _e800 = local_5.member[1u];
                    let _e806 = select(_e800[0], -(_e800[0]), (_e800[0] < 0f));
                    let _e809 = select(_e800[1], -(_e800[1]), (_e800[1] < 0f));
                    let _e811 = select(_e809, _e806, (_e806 > _e809));
                    let _e814 = select(_e800[2], -(_e800[2]), (_e800[2] < 0f));
                    let _e816 = select(_e814, _e811, (_e811 > _e814));
                    let _e820 = local_5.member_3;
                    let _e824 = local_5.member_1[0u];
                    let _e830 = select(_e824[0], -(_e824[0]), (_e824[0] < 0f));
                    let _e833 = select(_e824[1], -(_e824[1]), (_e824[1] < 0f));
                    let _e835 = select(_e833, _e830, (_e830 > _e833));
                    let _e838 = select(_e824[2], -(_e824[2]), (_e824[2] < 0f));
                    let _e840 = select(_e838, _e835, (_e835 > _e838));
                    let _e843 = local_5.member_1[1u];
                    let _e849 = select(_e843[0], -(_e843[0]), (_e843[0] < 0f));
                    let _e852 = select(_e843[1], -(_e843[1]), (_e843[1] < 0f));
                    let _e854 = select(_e852, _e849, (_e849 > _e852));
                    let _e857 = select(_e843[2], -(_e843[2]), (_e843[2] < 0f));
                    let _e859 = select(_e857, _e854, (_e854 > _e857));
                    let _e863 = local_5.member_3;
                    let _e867 = local_5.member_2[0u];
                    let _e873 = select(_e867[0], -(_e867[0]), (_e867[0] < 0f));
                    let _e876 = select(_e867[1], -(_e867[1]), (_e867[1] < 0f));
                    let _e878 = select(_e876, _e873, (_e873 > _e876));
                    let _e881 = select(_e867[2], -(_e867[2]), (_e867[2] < 0f));
                    let _e883 = select(_e881, _e878, (_e878 > _e881));
                    let _e886 = local_5.member_2[1u];
                    let _e892 = select(_e886[0], -(_e886[0]), (_e886[0] < 0f));
                    let _e895 = select(_e886[1], -(_e886[1]), (_e886[1] < 0f));
                    let _e897 = select(_e895, _e892, (_e892 > _e895));
                    let _e900 = select(_e886[2], -(_e886[2]), (_e886[2] < 0f));
                    let _e902 = select(_e900, _e897, (_e897 > _e900));
                    let _e906 = local_5.member_3;
                    let _e913 = local_5.member_3;
                    let _e920 = (((_e775 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e816, _e797, (_e797 > _e816)) + _e820) + (select(_e859, _e840, (_e840 > _e859)) + _e863)) + (select(_e902, _e883, (_e883 > _e902)) + _e906)) * (0.000000059604645f * 16f)) + (_e913 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e608.member_1);
                    if _e920 {
                        phi_2099_ = type_34();
                        phi_2100_ = true;
                    } else {
                        let _e923 = local_5.member_1[0u];
                        let _e929 = local_5.member_2[0u];
                        let _e935 = ((_e923[1] * _e929[2]) - (_e923[2] * _e929[1]));
                        let _e938 = ((_e923[2] * _e929[0]) - (_e923[0] * _e929[2]));
                        let _e941 = ((_e923[0] * _e929[1]) - (_e923[1] * _e929[0]));
                        let _e944 = local_5.member_1[1u];
                        let _e950 = local_5.member_2[1u];
                        let _e956 = ((_e944[1] * _e950[2]) - (_e944[2] * _e950[1]));
                        let _e959 = ((_e944[2] * _e950[0]) - (_e944[0] * _e950[2]));
                        let _e962 = ((_e944[0] * _e950[1]) - (_e944[1] * _e950[0]));
                        let _e965 = local_5.member_1[0u];
                        let _e971 = local_5.member_2[1u];
                        let _e986 = local_5.member_1[1u];
                        let _e992 = local_5.member_2[0u];
                        let _e1005 = (((_e965[1] * _e971[2]) - (_e965[2] * _e971[1])) + ((_e986[1] * _e992[2]) - (_e986[2] * _e992[1])));
                        let _e1006 = (((_e965[2] * _e971[0]) - (_e965[0] * _e971[2])) + ((_e986[2] * _e992[0]) - (_e986[0] * _e992[2])));
                        let _e1007 = (((_e965[0] * _e971[1]) - (_e965[1] * _e971[0])) + ((_e986[0] * _e992[1]) - (_e986[1] * _e992[0])));
                        let _e1010 = local_5.member[0u];
                        let _e1021 = local_5.member[1u];
                        let _e1032 = local_5.member[0u];
                        let _e1041 = ((((_e1021[0] * _e935) + (_e1021[1] * _e938)) + (_e1021[2] * _e941)) + (((_e1032[0] * _e1005) + (_e1032[1] * _e1006)) + (_e1032[2] * _e1007)));
                        let _e1044 = local_5.member[0u];
                        let _e1055 = local_5.member[1u];
                        let _e1064 = ((((_e1044[0] * _e956) + (_e1044[1] * _e959)) + (_e1044[2] * _e962)) + (((_e1055[0] * _e1005) + (_e1055[1] * _e1006)) + (_e1055[2] * _e1007)));
                        let _e1067 = local_5.member[1u];
                        let _e1078 = local_5.member[0u];
                        let _e1084 = select(_e1078[0], -(_e1078[0]), (_e1078[0] < 0f));
                        let _e1087 = select(_e1078[1], -(_e1078[1]), (_e1078[1] < 0f));
                        let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                        let _e1092 = select(_e1078[2], -(_e1078[2]), (_e1078[2] < 0f));
                        let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                        let _e1097 = local_5.member[1u];
                        let _e1103 = select(_e1097[0], -(_e1097[0]), (_e1097[0] < 0f));
                        let _e1106 = select(_e1097[1], -(_e1097[1]), (_e1097[1] < 0f));
                        let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                        let _e1111 = select(_e1097[2], -(_e1097[2]), (_e1097[2] < 0f));
                        let _e1113 = select(_e1111, _e1108, (_e1108 > _e1111));
                        let _e1117 = local_5.member_3;
                        let _e1118 = (select(_e1113, _e1094, (_e1094 > _e1113)) + _e1117);
                        let _e1121 = local_5.member_1[0u];
                        let _e1127 = select(_e1121[0], -(_e1121[0]), (_e1121[0] < 0f));
                        let _e1130 = select(_e1121[1], -(_e1121[1]), (_e1121[1] < 0f));
                        let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                        let _e1135 = select(_e1121[2], -(_e1121[2]), (_e1121[2] < 0f));
                        let _e1137 = select(_e1135, _e1132, (_e1132 > _e1135));
                        let _e1140 = local_5.member_1[1u];
                        let _e1146 = select(_e1140[0], -(_e1140[0]), (_e1140[0] < 0f));
                        let _e1149 = select(_e1140[1], -(_e1140[1]), (_e1140[1] < 0f));
                        let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                        let _e1154 = select(_e1140[2], -(_e1140[2]), (_e1140[2] < 0f));
                        let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                        let _e1160 = local_5.member_3;
                        let _e1161 = (select(_e1156, _e1137, (_e1137 > _e1156)) + _e1160);
                        let _e1164 = local_5.member_2[0u];
                        let _e1170 = select(_e1164[0], -(_e1164[0]), (_e1164[0] < 0f));
                        let _e1173 = select(_e1164[1], -(_e1164[1]), (_e1164[1] < 0f));
                        let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                        let _e1178 = select(_e1164[2], -(_e1164[2]), (_e1164[2] < 0f));
                        let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                        let _e1183 = local_5.member_2[1u];
                        let _e1189 = select(_e1183[0], -(_e1183[0]), (_e1183[0] < 0f));
                        let _e1192 = select(_e1183[1], -(_e1183[1]), (_e1183[1] < 0f));
                        let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                        let _e1197 = select(_e1183[2], -(_e1183[2]), (_e1183[2] < 0f));
                        let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                        let _e1203 = local_5.member_3;
                        let _e1204 = (select(_e1199, _e1180, (_e1180 > _e1199)) + _e1203);
                        let _e1206 = ((_e1161 * 8f) * _e1204);
                        let _e1213 = local_5.member_3;
                        let _e1237 = ((select(_e935, -(_e935), (_e935 < 0f)) + select(_e938, -(_e938), (_e938 < 0f))) + select(_e941, -(_e941), (_e941 < 0f)));
                        let _e1248 = ((select(_e956, -(_e956), (_e956 < 0f)) + select(_e959, -(_e959), (_e959 < 0f))) + select(_e962, -(_e962), (_e962 < 0f)));
                        let _e1250 = select(_e1248, _e1237, (_e1237 > _e1248));
                        let _e1262 = (((select(_e1005, -(_e1005), (_e1005 < 0f)) + select(_e1006, -(_e1006), (_e1006 < 0f))) + select(_e1007, -(_e1007), (_e1007 < 0f))) * 0.5f);
                        let _e1269 = local_5.member_3;
                        let _e1282 = ((((_e1010[0] * _e935) + (_e1010[1] * _e938)) + (_e1010[2] * _e941)) * 3f);
                        let _e1283 = ((((_e1067[0] * _e956) + (_e1067[1] * _e959)) + (_e1067[2] * _e962)) * 3f);
                        let _e1285 = select(_e1283, _e1282, (_e1282 < _e1283));
                        let _e1287 = select(_e1064, _e1041, (_e1041 < _e1064));
                        let _e1289 = select(_e1287, _e1285, (_e1285 < _e1287));
                        let _e1291 = select(_e1283, _e1282, (_e1282 > _e1283));
                        let _e1293 = select(_e1064, _e1041, (_e1041 > _e1064));
                        let _e1300 = -(select(_e1293, _e1291, (_e1291 > _e1293)));
                        if ((select(_e1300, _e1289, (_e1289 > _e1300)) - ((((((_e1118 * 8f) * _e1206) * (0.000000059604645f * (524f / 64f))) + ((_e1213 * 19f) * ((_e1118 * (_e1161 + _e1204)) + (_e1161 * _e1204)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1118) * ((1f + _e1161) * (1f + _e1204))))) + ((_e608.member_1 * (((select(_e1262, _e1250, (_e1250 > _e1262)) + (_e1206 * (0.000000059604645f * 8f))) + ((_e1269 * 6f) * (_e1161 + _e1204))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1161) * (1f + _e1204))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2097_ = type_34(type_33(0u, f32()), 0u);
                            phi_2098_ = false;
                        } else {
                            phi_2097_ = type_34();
                            phi_2098_ = true;
                        }
                        let _e1308 = phi_2097_;
                        let _e1310 = phi_2098_;
                        phi_2099_ = _e1308;
                        phi_2100_ = _e1310;
                    }
                    let _e1312 = phi_2099_;
                    let _e1314 = phi_2100_;
                    if _e1314 {
                        phi_2106_ = type_16(0i, 2i);
                        phi_2109_ = _e379;
                        phi_2111_ = 0u;
                        phi_2113_ = _e379;
                        loop {
                            let _e1316 = phi_2106_;
                            let _e1318 = phi_2109_;
                            let _e1320 = phi_2111_;
                            let _e1322 = phi_2113_;
                            local_53 = _e1320;
                            local_56 = _e1318;
                            local_57 = _e1320;
                            if (_e1316.member < _e1316.member_1) {
                                let _e1329 = (_e1316.member + 1i);
                                phi_2107_ = type_16(select(_e1329, type_17().member_1, select(false, true, ((false == (_e1329 > _e1316.member)) != false))), _e1316.member_1);
                                phi_2154_ = type_17(1u, _e1316.member);
                            } else {
                                phi_2107_ = _e1316;
                                phi_2154_ = type_17(0u, type_17().member_1);
                            }
                            let _e1340 = phi_2107_;
                            let _e1342 = phi_2154_;
                            if (bitcast<i32>(_e1342.member) != 0i) {
                                if select(select(true, false, _e920), true, (_e1342.member_1 > 0i)) {
                                    let _e1352 = local_5.member[0u];
                                    let _e1358 = local_5.member_1[0u];
                                    let _e1364 = local_5.member_2[0u];
                                    let _e1368 = (_e1352[0] - _e1358[0]);
                                    let _e1369 = (_e1352[1] - _e1358[1]);
                                    let _e1370 = (_e1352[2] - _e1358[2]);
                                    let _e1371 = (_e224.member == 0u);
                                    let _e1383 = local_5.member[1u];
                                    let _e1389 = local_5.member_1[1u];
                                    let _e1395 = local_5.member_2[1u];
                                    let _e1399 = (_e1383[0] - _e1389[0]);
                                    let _e1400 = (_e1383[1] - _e1389[1]);
                                    let _e1401 = (_e1383[2] - _e1389[2]);
                                    let _e1402 = (_e224.member == 0u);
                                    let _e1414 = local_5.member[0u];
                                    let _e1420 = select(_e1414[0], -(_e1414[0]), (_e1414[0] < 0f));
                                    let _e1423 = select(_e1414[1], -(_e1414[1]), (_e1414[1] < 0f));
                                    let _e1425 = select(_e1423, _e1420, (_e1420 > _e1423));
                                    let _e1428 = select(_e1414[2], -(_e1414[2]), (_e1414[2] < 0f));
                                    let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                    let _e1433 = local_5.member[1u];
                                    let _e1439 = select(_e1433[0], -(_e1433[0]), (_e1433[0] < 0f));
                                    let _e1442 = select(_e1433[1], -(_e1433[1]), (_e1433[1] < 0f));
                                    let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                    let _e1447 = select(_e1433[2], -(_e1433[2]), (_e1433[2] < 0f));
                                    let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                    let _e1453 = local_5.member_3;
                                    let _e1457 = local_5.member_1[0u];
                                    let _e1463 = select(_e1457[0], -(_e1457[0]), (_e1457[0] < 0f));
                                    let _e1466 = select(_e1457[1], -(_e1457[1]), (_e1457[1] < 0f));
                                    let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                    let _e1471 = select(_e1457[2], -(_e1457[2]), (_e1457[2] < 0f));
                                    let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                    let _e1476 = local_5.member_1[1u];
                                    let _e1482 = select(_e1476[0], -(_e1476[0]), (_e1476[0] < 0f));
                                    let _e1485 = select(_e1476[1], -(_e1476[1]), (_e1476[1] < 0f));
                                    let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                    let _e1490 = select(_e1476[2], -(_e1476[2]), (_e1476[2] < 0f));
                                    let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                    let _e1496 = local_5.member_3;
                                    let _e1500 = local_5.member_2[0u];
                                    let _e1506 = select(_e1500[0], -(_e1500[0]), (_e1500[0] < 0f));
                                    let _e1509 = select(_e1500[1], -(_e1500[1]), (_e1500[1] < 0f));
                                    let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                    let _e1514 = select(_e1500[2], -(_e1500[2]), (_e1500[2] < 0f));
                                    let _e1516 = select(_e1514, _e1511, (_e1511 > _e1514));
                                    let _e1519 = local_5.member_2[1u];
                                    let _e1525 = select(_e1519[0], -(_e1519[0]), (_e1519[0] < 0f));
                                    let _e1528 = select(_e1519[1], -(_e1519[1]), (_e1519[1] < 0f));
                                    let _e1530 = select(_e1528, _e1525, (_e1525 > _e1528));
                                    let _e1533 = select(_e1519[2], -(_e1519[2]), (_e1519[2] < 0f));
                                    let _e1535 = select(_e1533, _e1530, (_e1530 > _e1533));
                                    let _e1539 = local_5.member_3;
                                    let _e1546 = local_5.member_3;
                                    let _e1551 = (_e377 * 0.00390625f);
                                    local_3 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2591_ = type_9(0u, 96u);
                                    phi_2594_ = _e1322;
                                    phi_2596_ = _e1322;
                                    phi_2598_ = (_e381 - _e1322);
                                    phi_2600_ = _e1322;
                                    phi_2602_ = false;
                                    phi_2604_ = 0u;
                                    loop {
                                        let _e1554 = phi_2591_;
                                        let _e1556 = phi_2594_;
                                        let _e1558 = phi_2596_;
                                        let _e1560 = phi_2598_;
                                        let _e1562 = phi_2600_;
                                        let _e1564 = phi_2602_;
                                        let _e1566 = phi_2604_;
                                        local_19 = _e1556;
                                        local_23 = _e1558;
                                        let _e1569 = (_e1554.member < _e1554.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e1569)) != 0i) {
                                            let _e1583 = local_5.member[0u];
                                            let _e1589 = local_5.member[1u];
                                            let _e1605 = local_5.member_1[0u];
                                            let _e1611 = local_5.member_1[1u];
                                            let _e1627 = local_5.member_2[0u];
                                            let _e1633 = local_5.member_2[1u];
                                            let _e1647 = function_3(array<f32, 3>((_e1583[0] + ((_e1589[0] - _e1583[0]) * _e1556)), (_e1583[1] + ((_e1589[1] - _e1583[1]) * _e1556)), (_e1583[2] + ((_e1589[2] - _e1583[2]) * _e1556))), array<f32, 3>((_e1605[0] + ((_e1611[0] - _e1605[0]) * _e1556)), (_e1605[1] + ((_e1611[1] - _e1605[1]) * _e1556)), (_e1605[2] + ((_e1611[2] - _e1605[2]) * _e1556))), array<f32, 3>((_e1627[0] + ((_e1633[0] - _e1627[0]) * _e1556)), (_e1627[1] + ((_e1633[1] - _e1627[1]) * _e1556)), (_e1627[2] + ((_e1633[2] - _e1627[2]) * _e1556))), _e224.member);
                                            if (_e1566 == 0u) {
                                                phi_2755_ = _e1647;
                                            } else {
                                                phi_2755_ = array<f32, 3>(select(0f, _e1647[0], (_e1566 == 1u)), select(0f, _e1647[1], (_e1566 == 2u)), select(0f, _e1647[2], (_e1566 == 3u)));
                                            }
                                            let _e1660 = phi_2755_;
                                            let _e1674 = ((select(_e1660[0], -(_e1660[0]), (_e1660[0] < 0f)) + select(_e1660[1], -(_e1660[1]), (_e1660[1] < 0f))) + select(_e1660[2], -(_e1660[2]), (_e1660[2] < 0f)));
                                            if (_e1674 > 0f) {
                                                if ((bitcast<u32>(_e1674) & 2139095040u) != 2139095040u) {
                                                    let _e1679 = (1f / _e1674);
                                                    let _e1681 = (_e1660[0] * _e1679);
                                                    let _e1683 = (_e1660[1] * _e1679);
                                                    let _e1685 = (_e1660[2] * _e1679);
                                                    let _e1690 = (((_e1681 * _e1681) + (_e1683 * _e1683)) + (_e1685 * _e1685));
                                                    if (_e1690 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2878_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1690 > 0f));
                                                    } else {
                                                        phi_2821_ = type_16(0i, 5i);
                                                        phi_2824_ = bitcast<f32>(((bitcast<u32>(_e1690) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1698 = phi_2821_;
                                                            let _e1700 = phi_2824_;
                                                            local_7 = _e1700;
                                                            if (_e1698.member < _e1698.member_1) {
                                                                let _e1707 = (_e1698.member + 1i);
                                                                phi_2822_ = type_16(select(_e1707, type_17().member_1, select(false, true, ((false == (_e1707 > _e1698.member)) != false))), _e1698.member_1);
                                                                phi_2865_ = type_17(1u, _e1698.member);
                                                            } else {
                                                                phi_2822_ = _e1698;
                                                                phi_2865_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e1718 = phi_2822_;
                                                            let _e1720 = phi_2865_;
                                                            let _e1723 = (bitcast<i32>(_e1720.member) != 0i);
                                                            if _e1723 {
                                                                phi_2825_ = (0.5f * (_e1700 + (_e1690 / _e1700)));
                                                            } else {
                                                                phi_2825_ = f32();
                                                            }
                                                            let _e1728 = phi_2825_;
                                                            continue;
                                                            continuing {
                                                                phi_2821_ = _e1718;
                                                                phi_2824_ = _e1728;
                                                                break if !(_e1723);
                                                            }
                                                        }
                                                        let _e1733 = local_7;
                                                        phi_2878_ = (_e1733 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1739 = phi_2878_;
                                                    let _e1740 = (0.000000059604645f * 12f);
                                                    let _e1745 = ((((((((select(_e1449, _e1430, (_e1430 > _e1449)) + _e1453) + (select(_e1492, _e1473, (_e1473 > _e1492)) + _e1496)) + (select(_e1535, _e1516, (_e1516 > _e1535)) + _e1539)) * (0.000000059604645f * 16f)) + (_e1546 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e608.member_1 * _e1739) * (1f + _e1740)));
                                                    let _e1750 = (((_e1681 * _e1352[0]) + (_e1683 * _e1352[1])) + (_e1685 * _e1352[2]));
                                                    let _e1755 = (((_e1681 * _e1368) + (_e1683 * _e1369)) + (_e1685 * _e1370));
                                                    let _e1760 = (((_e1681 * (_e1352[0] - _e1364[0])) + (_e1683 * (_e1352[1] - _e1364[1]))) + (_e1685 * (_e1352[2] - _e1364[2])));
                                                    let _e1765 = (((_e1681 * select((_e1368 - _e1364[0]), _e1352[0], _e1371)) + (_e1683 * select((_e1369 - _e1364[1]), _e1352[1], _e1371))) + (_e1685 * select((_e1370 - _e1364[2]), _e1352[2], _e1371)));
                                                    let _e1771 = (((_e1681 * _e1383[0]) + (_e1683 * _e1383[1])) + (_e1685 * _e1383[2]));
                                                    let _e1776 = (((_e1681 * _e1399) + (_e1683 * _e1400)) + (_e1685 * _e1401));
                                                    let _e1781 = (((_e1681 * (_e1383[0] - _e1395[0])) + (_e1683 * (_e1383[1] - _e1395[1]))) + (_e1685 * (_e1383[2] - _e1395[2])));
                                                    let _e1786 = (((_e1681 * select((_e1399 - _e1395[0]), _e1383[0], _e1402)) + (_e1683 * select((_e1400 - _e1395[1]), _e1383[1], _e1402))) + (_e1685 * select((_e1401 - _e1395[2]), _e1383[2], _e1402)));
                                                    phi_3001_ = type_30(array<f32, 4>(_e1750, _e1755, _e1760, _e1765), array<f32, 4>(_e1771, _e1776, _e1781, _e1786), array<f32, 4>((_e1745 + ((select(_e1750, -(_e1750), (_e1750 < 0f)) + select(_e1771, -(_e1771), (_e1771 < 0f))) * _e1740)), (_e1745 + ((select(_e1755, -(_e1755), (_e1755 < 0f)) + select(_e1776, -(_e1776), (_e1776 < 0f))) * _e1740)), (_e1745 + ((select(_e1760, -(_e1760), (_e1760 < 0f)) + select(_e1781, -(_e1781), (_e1781 < 0f))) * _e1740)), (_e1745 + ((select(_e1765, -(_e1765), (_e1765 < 0f)) + select(_e1786, -(_e1786), (_e1786 < 0f))) * _e1740))));
                                                    phi_3002_ = false;
                                                } else {
                                                    phi_3001_ = type_30();
                                                    phi_3002_ = true;
                                                }
                                                let _e1827 = phi_3001_;
                                                let _e1829 = phi_3002_;
                                                phi_3003_ = _e1827;
                                                phi_3004_ = _e1829;
                                            } else {
                                                phi_3003_ = type_30();
                                                phi_3004_ = true;
                                            }
                                            let _e1831 = phi_3003_;
                                            let _e1833 = phi_3004_;
                                            if _e1833 {
                                                phi_3012_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3012_ = _e1831;
                                            }
                                            let _e1835 = phi_3012_;
                                            local_4 = type_30(array<f32, 4>(_e1835.member[0], _e1835.member[1], _e1835.member[2], _e1835.member[3]), array<f32, 4>(_e1835.member_1[0], _e1835.member_1[1], _e1835.member_1[2], _e1835.member_1[3]), array<f32, 4>(_e1835.member_2[0], _e1835.member_2[1], _e1835.member_2[2], _e1835.member_2[3]));
                                            let _e1855 = (_e1556 - _e1562);
                                            let _e1859 = local_4.member[0u];
                                            let _e1862 = local_4.member_1[0u];
                                            let _e1865 = local_4.member[0u];
                                            let _e1871 = local_4.member_2[0u];
                                            if (((_e1859 + ((_e1862 - _e1865) * _e1556)) - _e1871) > 0f) {
                                                let _e1876 = local_4.member[1u];
                                                let _e1879 = local_4.member_1[1u];
                                                let _e1882 = local_4.member[1u];
                                                let _e1888 = local_4.member_2[1u];
                                                if (((_e1876 + ((_e1879 - _e1882) * _e1556)) - _e1888) > 0f) {
                                                    let _e1893 = local_4.member[2u];
                                                    let _e1896 = local_4.member_1[2u];
                                                    let _e1899 = local_4.member[2u];
                                                    let _e1905 = local_4.member_2[2u];
                                                    if (((_e1893 + ((_e1896 - _e1899) * _e1556)) - _e1905) > 0f) {
                                                        let _e1910 = local_4.member[3u];
                                                        let _e1913 = local_4.member_1[3u];
                                                        let _e1916 = local_4.member[3u];
                                                        let _e1922 = local_4.member_2[3u];
                                                        phi_3183_ = (((_e1910 + ((_e1913 - _e1916) * _e1556)) - _e1922) > 0f);
                                                        phi_3184_ = false;
                                                    } else {
                                                        phi_3183_ = bool();
                                                        phi_3184_ = true;
                                                    }
                                                    let _e1926 = phi_3183_;
                                                    let _e1928 = phi_3184_;
                                                    phi_3185_ = _e1926;
                                                    phi_3186_ = _e1928;
                                                } else {
                                                    phi_3185_ = bool();
                                                    phi_3186_ = true;
                                                }
                                                let _e1930 = phi_3185_;
                                                let _e1932 = phi_3186_;
                                                phi_3187_ = _e1930;
                                                phi_3188_ = _e1932;
                                            } else {
                                                phi_3187_ = bool();
                                                phi_3188_ = true;
                                            }
                                            let _e1934 = phi_3187_;
                                            let _e1936 = phi_3188_;
                                            if select(_e1934, false, _e1936) {
                                                if (_e1556 <= _e1558) {
                                                    phi_3502_ = true;
                                                } else {
                                                    let _e1941 = local_3.member[0u];
                                                    let _e1944 = local_3.member_1[0u];
                                                    let _e1947 = local_3.member[0u];
                                                    let _e1953 = local_3.member_2[0u];
                                                    let _e1957 = local_4.member[0u];
                                                    let _e1960 = local_4.member_1[0u];
                                                    let _e1963 = local_4.member[0u];
                                                    let _e1969 = local_4.member_2[0u];
                                                    if ((((_e1941 + ((_e1944 - _e1947) * _e1556)) - _e1953) + ((_e1957 + ((_e1960 - _e1963) * _e1562)) - _e1969)) > 0f) {
                                                        let _e1975 = local_3.member[1u];
                                                        let _e1978 = local_3.member_1[1u];
                                                        let _e1981 = local_3.member[1u];
                                                        let _e1987 = local_3.member_2[1u];
                                                        let _e1991 = local_4.member[1u];
                                                        let _e1994 = local_4.member_1[1u];
                                                        let _e1997 = local_4.member[1u];
                                                        let _e2003 = local_4.member_2[1u];
                                                        if ((((_e1975 + ((_e1978 - _e1981) * _e1556)) - _e1987) + ((_e1991 + ((_e1994 - _e1997) * _e1562)) - _e2003)) > 0f) {
                                                            let _e2009 = local_3.member[2u];
                                                            let _e2012 = local_3.member_1[2u];
                                                            let _e2015 = local_3.member[2u];
                                                            let _e2021 = local_3.member_2[2u];
                                                            let _e2025 = local_4.member[2u];
                                                            let _e2028 = local_4.member_1[2u];
                                                            let _e2031 = local_4.member[2u];
                                                            let _e2037 = local_4.member_2[2u];
                                                            if ((((_e2009 + ((_e2012 - _e2015) * _e1556)) - _e2021) + ((_e2025 + ((_e2028 - _e2031) * _e1562)) - _e2037)) > 0f) {
                                                                let _e2043 = local_3.member[3u];
                                                                let _e2046 = local_3.member_1[3u];
                                                                let _e2049 = local_3.member[3u];
                                                                let _e2055 = local_3.member_2[3u];
                                                                let _e2059 = local_4.member[3u];
                                                                let _e2062 = local_4.member_1[3u];
                                                                let _e2065 = local_4.member[3u];
                                                                let _e2071 = local_4.member_2[3u];
                                                                phi_3489_ = ((((_e2043 + ((_e2046 - _e2049) * _e1556)) - _e2055) + ((_e2059 + ((_e2062 - _e2065) * _e1562)) - _e2071)) > 0f);
                                                                phi_3490_ = false;
                                                            } else {
                                                                phi_3489_ = bool();
                                                                phi_3490_ = true;
                                                            }
                                                            let _e2076 = phi_3489_;
                                                            let _e2078 = phi_3490_;
                                                            phi_3491_ = _e2076;
                                                            phi_3492_ = _e2078;
                                                        } else {
                                                            phi_3491_ = bool();
                                                            phi_3492_ = true;
                                                        }
                                                        let _e2080 = phi_3491_;
                                                        let _e2082 = phi_3492_;
                                                        phi_3493_ = _e2080;
                                                        phi_3494_ = _e2082;
                                                    } else {
                                                        phi_3493_ = bool();
                                                        phi_3494_ = true;
                                                    }
                                                    let _e2084 = phi_3493_;
                                                    let _e2086 = phi_3494_;
                                                    phi_3502_ = select(_e2084, false, _e2086);
                                                }
                                                let _e2089 = phi_3502_;
                                                if _e2089 {
                                                    if select(true, select(true, false, (_e1556 >= _e381)), _e1564) {
                                                        local_3 = type_30(array<f32, 4>(_e1835.member[0], _e1835.member[1], _e1835.member[2], _e1835.member[3]), array<f32, 4>(_e1835.member_1[0], _e1835.member_1[1], _e1835.member_1[2], _e1835.member_1[3]), array<f32, 4>(_e1835.member_2[0], _e1835.member_2[1], _e1835.member_2[2], _e1835.member_2[3]));
                                                        let _e2114 = local_3.member[0u];
                                                        let _e2117 = local_3.member_1[0u];
                                                        let _e2120 = local_3.member_2[0u];
                                                        if select(true, select(true, false, (_e2117 > _e2120)), (_e2114 > _e2120)) {
                                                            let _e2125 = (_e2117 >= _e2114);
                                                            if _e2125 {
                                                                phi_3611_ = f32();
                                                                phi_3612_ = false;
                                                            } else {
                                                                if ((_e2114 - _e2117) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3609_ = (((_e2114 - _e2120) / (_e2114 - _e2117)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3610_ = false;
                                                                } else {
                                                                    phi_3609_ = f32();
                                                                    phi_3610_ = true;
                                                                }
                                                                let _e2136 = phi_3609_;
                                                                let _e2138 = phi_3610_;
                                                                phi_3611_ = _e2136;
                                                                phi_3612_ = _e2138;
                                                            }
                                                            let _e2140 = phi_3611_;
                                                            let _e2142 = phi_3612_;
                                                            phi_3613_ = _e2140;
                                                            phi_3614_ = _e2125;
                                                            phi_3615_ = _e2142;
                                                        } else {
                                                            phi_3613_ = f32();
                                                            phi_3614_ = true;
                                                            phi_3615_ = false;
                                                        }
                                                        let _e2144 = phi_3613_;
                                                        let _e2146 = phi_3614_;
                                                        let _e2148 = phi_3615_;
                                                        let _e2151 = select(_e2144, select(_e1556, 2f, _e2146), select(_e2148, true, _e2146));
                                                        let _e2154 = local_3.member[1u];
                                                        let _e2157 = local_3.member_1[1u];
                                                        let _e2160 = local_3.member_2[1u];
                                                        if select(true, select(true, false, (_e2157 > _e2160)), (_e2154 > _e2160)) {
                                                            let _e2165 = (_e2157 >= _e2154);
                                                            if _e2165 {
                                                                phi_3679_ = f32();
                                                                phi_3680_ = false;
                                                            } else {
                                                                if ((_e2154 - _e2157) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3677_ = (((_e2154 - _e2160) / (_e2154 - _e2157)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3678_ = false;
                                                                } else {
                                                                    phi_3677_ = f32();
                                                                    phi_3678_ = true;
                                                                }
                                                                let _e2176 = phi_3677_;
                                                                let _e2178 = phi_3678_;
                                                                phi_3679_ = _e2176;
                                                                phi_3680_ = _e2178;
                                                            }
                                                            let _e2180 = phi_3679_;
                                                            let _e2182 = phi_3680_;
                                                            phi_3681_ = _e2180;
                                                            phi_3682_ = _e2165;
                                                            phi_3683_ = _e2182;
                                                        } else {
                                                            phi_3681_ = f32();
                                                            phi_3682_ = true;
                                                            phi_3683_ = false;
                                                        }
                                                        let _e2184 = phi_3681_;
                                                        let _e2186 = phi_3682_;
                                                        let _e2188 = phi_3683_;
                                                        let _e2191 = select(_e2184, select(_e1556, 2f, _e2186), select(_e2188, true, _e2186));
                                                        let _e2193 = select(_e2191, _e2151, (_e2151 < _e2191));
                                                        let _e2196 = local_3.member[2u];
                                                        let _e2199 = local_3.member_1[2u];
                                                        let _e2202 = local_3.member_2[2u];
                                                        if select(true, select(true, false, (_e2199 > _e2202)), (_e2196 > _e2202)) {
                                                            let _e2207 = (_e2199 >= _e2196);
                                                            if _e2207 {
                                                                phi_3752_ = f32();
                                                                phi_3753_ = false;
                                                            } else {
                                                                if ((_e2196 - _e2199) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3750_ = (((_e2196 - _e2202) / (_e2196 - _e2199)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3751_ = false;
                                                                } else {
                                                                    phi_3750_ = f32();
                                                                    phi_3751_ = true;
                                                                }
                                                                let _e2218 = phi_3750_;
                                                                let _e2220 = phi_3751_;
                                                                phi_3752_ = _e2218;
                                                                phi_3753_ = _e2220;
                                                            }
                                                            let _e2222 = phi_3752_;
                                                            let _e2224 = phi_3753_;
                                                            phi_3754_ = _e2222;
                                                            phi_3755_ = _e2207;
                                                            phi_3756_ = _e2224;
                                                        } else {
                                                            phi_3754_ = f32();
                                                            phi_3755_ = true;
                                                            phi_3756_ = false;
                                                        }
                                                        let _e2226 = phi_3754_;
                                                        let _e2228 = phi_3755_;
                                                        let _e2230 = phi_3756_;
                                                        let _e2233 = select(_e2226, select(_e1556, 2f, _e2228), select(_e2230, true, _e2228));
                                                        let _e2236 = local_3.member[3u];
                                                        let _e2239 = local_3.member_1[3u];
                                                        let _e2242 = local_3.member_2[3u];
                                                        if select(true, select(true, false, (_e2239 > _e2242)), (_e2236 > _e2242)) {
                                                            let _e2247 = (_e2239 >= _e2236);
                                                            if _e2247 {
                                                                phi_3820_ = f32();
                                                                phi_3821_ = false;
                                                            } else {
                                                                if ((_e2236 - _e2239) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3818_ = (((_e2236 - _e2242) / (_e2236 - _e2239)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3819_ = false;
                                                                } else {
                                                                    phi_3818_ = f32();
                                                                    phi_3819_ = true;
                                                                }
                                                                let _e2258 = phi_3818_;
                                                                let _e2260 = phi_3819_;
                                                                phi_3820_ = _e2258;
                                                                phi_3821_ = _e2260;
                                                            }
                                                            let _e2262 = phi_3820_;
                                                            let _e2264 = phi_3821_;
                                                            phi_3822_ = _e2262;
                                                            phi_3823_ = _e2247;
                                                            phi_3824_ = _e2264;
                                                        } else {
                                                            phi_3822_ = f32();
                                                            phi_3823_ = true;
                                                            phi_3824_ = false;
                                                        }
                                                        let _e2266 = phi_3822_;
                                                        let _e2268 = phi_3823_;
                                                        let _e2270 = phi_3824_;
                                                        let _e2273 = select(_e2266, select(_e1556, 2f, _e2268), select(_e2270, true, _e2268));
                                                        let _e2275 = select(_e2273, _e2233, (_e2233 < _e2273));
                                                        let _e2277 = select(_e2275, _e2193, (_e2193 < _e2275));
                                                        let _e2279 = select(_e1556, _e2277, (_e2277 > _e1556));
                                                        let _e2280 = (_e2279 > _e381);
                                                        if _e2280 {
                                                            phi_4353_ = f32();
                                                            phi_4354_ = f32();
                                                            phi_4355_ = false;
                                                            phi_4356_ = false;
                                                        } else {
                                                            let _e2281 = (_e2279 - _e1556);
                                                            let _e2282 = (_e2281 <= _e1551);
                                                            let _e2284 = (_e2279 + (_e377 * 0.01f));
                                                            let _e2286 = select(_e381, _e2284, (_e2284 < _e381));
                                                            if _e2282 {
                                                                if (_e608.member_1 > 0f) {
                                                                    let _e2290 = local_5.member[0u];
                                                                    let _e2296 = local_5.member[1u];
                                                                    let _e2312 = local_5.member_1[0u];
                                                                    let _e2318 = local_5.member_1[1u];
                                                                    let _e2334 = local_5.member_2[0u];
                                                                    let _e2340 = local_5.member_2[1u];
                                                                    let _e2354 = function_3(array<f32, 3>((_e2290[0] + ((_e2296[0] - _e2290[0]) * _e2286)), (_e2290[1] + ((_e2296[1] - _e2290[1]) * _e2286)), (_e2290[2] + ((_e2296[2] - _e2290[2]) * _e2286))), array<f32, 3>((_e2312[0] + ((_e2318[0] - _e2312[0]) * _e2286)), (_e2312[1] + ((_e2318[1] - _e2312[1]) * _e2286)), (_e2312[2] + ((_e2318[2] - _e2312[2]) * _e2286))), array<f32, 3>((_e2334[0] + ((_e2340[0] - _e2334[0]) * _e2286)), (_e2334[1] + ((_e2340[1] - _e2334[1]) * _e2286)), (_e2334[2] + ((_e2340[2] - _e2334[2]) * _e2286))), _e224.member);
                                                                    let _e2365 = (((_e2354[0] * _e2354[0]) + (_e2354[1] * _e2354[1])) + (_e2354[2] * _e2354[2]));
                                                                    if (_e2365 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_4055_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2365 > 0f));
                                                                    } else {
                                                                        phi_3998_ = type_16(0i, 5i);
                                                                        phi_4001_ = bitcast<f32>(((bitcast<u32>(_e2365) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e2373 = phi_3998_;
                                                                            let _e2375 = phi_4001_;
                                                                            local_8 = _e2375;
                                                                            if (_e2373.member < _e2373.member_1) {
                                                                                let _e2382 = (_e2373.member + 1i);
                                                                                phi_3999_ = type_16(select(_e2382, type_17().member_1, select(false, true, ((false == (_e2382 > _e2373.member)) != false))), _e2373.member_1);
                                                                                phi_4042_ = type_17(1u, _e2373.member);
                                                                            } else {
                                                                                phi_3999_ = _e2373;
                                                                                phi_4042_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e2393 = phi_3999_;
                                                                            let _e2395 = phi_4042_;
                                                                            let _e2398 = (bitcast<i32>(_e2395.member) != 0i);
                                                                            if _e2398 {
                                                                                phi_4002_ = (0.5f * (_e2375 + (_e2365 / _e2375)));
                                                                            } else {
                                                                                phi_4002_ = f32();
                                                                            }
                                                                            let _e2403 = phi_4002_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3998_ = _e2393;
                                                                                phi_4001_ = _e2403;
                                                                                break if !(_e2398);
                                                                            }
                                                                        }
                                                                        let _e2408 = local_8;
                                                                        phi_4055_ = (_e2408 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e2414 = phi_4055_;
                                                                    let _e2420 = local_5.member[0u];
                                                                    let _e2426 = select(_e2420[0], -(_e2420[0]), (_e2420[0] < 0f));
                                                                    let _e2429 = select(_e2420[1], -(_e2420[1]), (_e2420[1] < 0f));
                                                                    let _e2431 = select(_e2429, _e2426, (_e2426 > _e2429));
                                                                    let _e2434 = select(_e2420[2], -(_e2420[2]), (_e2420[2] < 0f));
                                                                    let _e2436 = select(_e2434, _e2431, (_e2431 > _e2434));
                                                                    let _e2439 = local_5.member[1u];
                                                                    let _e2445 = select(_e2439[0], -(_e2439[0]), (_e2439[0] < 0f));
                                                                    let _e2448 = select(_e2439[1], -(_e2439[1]), (_e2439[1] < 0f));
                                                                    let _e2450 = select(_e2448, _e2445, (_e2445 > _e2448));
                                                                    let _e2453 = select(_e2439[2], -(_e2439[2]), (_e2439[2] < 0f));
                                                                    let _e2455 = select(_e2453, _e2450, (_e2450 > _e2453));
                                                                    let _e2459 = local_5.member_3;
                                                                    let _e2463 = local_5.member_1[0u];
                                                                    let _e2469 = select(_e2463[0], -(_e2463[0]), (_e2463[0] < 0f));
                                                                    let _e2472 = select(_e2463[1], -(_e2463[1]), (_e2463[1] < 0f));
                                                                    let _e2474 = select(_e2472, _e2469, (_e2469 > _e2472));
                                                                    let _e2477 = select(_e2463[2], -(_e2463[2]), (_e2463[2] < 0f));
                                                                    let _e2479 = select(_e2477, _e2474, (_e2474 > _e2477));
                                                                    let _e2482 = local_5.member_1[1u];
                                                                    let _e2488 = select(_e2482[0], -(_e2482[0]), (_e2482[0] < 0f));
                                                                    let _e2491 = select(_e2482[1], -(_e2482[1]), (_e2482[1] < 0f));
                                                                    let _e2493 = select(_e2491, _e2488, (_e2488 > _e2491));
                                                                    let _e2496 = select(_e2482[2], -(_e2482[2]), (_e2482[2] < 0f));
                                                                    let _e2498 = select(_e2496, _e2493, (_e2493 > _e2496));
                                                                    let _e2502 = local_5.member_3;
                                                                    let _e2506 = local_5.member_2[0u];
                                                                    let _e2512 = select(_e2506[0], -(_e2506[0]), (_e2506[0] < 0f));
                                                                    let _e2515 = select(_e2506[1], -(_e2506[1]), (_e2506[1] < 0f));
                                                                    let _e2517 = select(_e2515, _e2512, (_e2512 > _e2515));
                                                                    let _e2520 = select(_e2506[2], -(_e2506[2]), (_e2506[2] < 0f));
                                                                    let _e2522 = select(_e2520, _e2517, (_e2517 > _e2520));
                                                                    let _e2525 = local_5.member_2[1u];
                                                                    let _e2531 = select(_e2525[0], -(_e2525[0]), (_e2525[0] < 0f));
                                                                    let _e2534 = select(_e2525[1], -(_e2525[1]), (_e2525[1] < 0f));
                                                                    let _e2536 = select(_e2534, _e2531, (_e2531 > _e2534));
                                                                    let _e2539 = select(_e2525[2], -(_e2525[2]), (_e2525[2] < 0f));
                                                                    let _e2541 = select(_e2539, _e2536, (_e2536 > _e2539));
                                                                    let _e2545 = local_5.member_3;
                                                                    let _e2552 = local_5.member_3;
                                                                    phi_4326_ = select(true, false, (((_e2414 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2455, _e2436, (_e2436 > _e2455)) + _e2459) + (select(_e2498, _e2479, (_e2479 > _e2498)) + _e2502)) + (select(_e2541, _e2522, (_e2522 > _e2541)) + _e2545)) * (0.000000059604645f * 16f)) + (_e2552 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e608.member_1));
                                                                } else {
                                                                    phi_4326_ = true;
                                                                }
                                                                let _e2562 = phi_4326_;
                                                                phi_4327_ = _e2562;
                                                            } else {
                                                                phi_4327_ = true;
                                                            }
                                                            let _e2564 = phi_4327_;
                                                            phi_4353_ = select(f32(), select((_e381 - _e1556), select(0f, (_e1855 + _e1855), select(select(true, false, (_e2281 <= (_e1560 * 0.25f))), true, _e2282)), _e1564), _e2564);
                                                            phi_4354_ = _e2281;
                                                            phi_4355_ = _e2564;
                                                            phi_4356_ = select(true, false, _e2564);
                                                        }
                                                        let _e2576 = phi_4353_;
                                                        let _e2578 = phi_4354_;
                                                        let _e2580 = phi_4355_;
                                                        let _e2582 = phi_4356_;
                                                        phi_4357_ = _e2279;
                                                        phi_4358_ = _e2576;
                                                        phi_4359_ = _e2578;
                                                        phi_4360_ = _e2279;
                                                        phi_4361_ = _e2580;
                                                        phi_4362_ = _e2280;
                                                        phi_4363_ = _e2582;
                                                        phi_4364_ = false;
                                                    } else {
                                                        phi_4357_ = f32();
                                                        phi_4358_ = f32();
                                                        phi_4359_ = f32();
                                                        phi_4360_ = f32();
                                                        phi_4361_ = false;
                                                        phi_4362_ = false;
                                                        phi_4363_ = false;
                                                        phi_4364_ = true;
                                                    }
                                                    let _e2584 = phi_4357_;
                                                    let _e2586 = phi_4358_;
                                                    let _e2588 = phi_4359_;
                                                    let _e2590 = phi_4360_;
                                                    let _e2592 = phi_4361_;
                                                    let _e2594 = phi_4362_;
                                                    let _e2596 = phi_4363_;
                                                    let _e2598 = phi_4364_;
                                                    phi_4365_ = _e2584;
                                                    phi_4366_ = _e2586;
                                                    phi_4367_ = _e2588;
                                                    phi_4368_ = _e2590;
                                                    phi_4369_ = false;
                                                    phi_4370_ = _e2592;
                                                    phi_4371_ = _e2594;
                                                    phi_4372_ = _e2596;
                                                    phi_4373_ = _e2598;
                                                } else {
                                                    phi_4365_ = f32();
                                                    phi_4366_ = f32();
                                                    phi_4367_ = f32();
                                                    phi_4368_ = f32();
                                                    phi_4369_ = true;
                                                    phi_4370_ = false;
                                                    phi_4371_ = false;
                                                    phi_4372_ = false;
                                                    phi_4373_ = false;
                                                }
                                                let _e2600 = phi_4365_;
                                                let _e2602 = phi_4366_;
                                                let _e2604 = phi_4367_;
                                                let _e2606 = phi_4368_;
                                                let _e2608 = phi_4369_;
                                                let _e2610 = phi_4370_;
                                                let _e2612 = phi_4371_;
                                                let _e2614 = phi_4372_;
                                                let _e2616 = phi_4373_;
                                                phi_4374_ = _e2600;
                                                phi_4375_ = _e2602;
                                                phi_4376_ = _e2604;
                                                phi_4377_ = _e2606;
                                                phi_4378_ = _e2608;
                                                phi_4379_ = _e2610;
                                                phi_4380_ = _e2612;
                                                phi_4381_ = _e2614;
                                                phi_4382_ = _e2616;
                                            } else {
                                                phi_4374_ = f32();
                                                phi_4375_ = f32();
                                                phi_4376_ = f32();
                                                phi_4377_ = f32();
                                                phi_4378_ = true;
                                                phi_4379_ = false;
                                                phi_4380_ = false;
                                                phi_4381_ = false;
                                                phi_4382_ = false;
                                            }
                                            let _e2618 = phi_4374_;
                                            let _e2620 = phi_4375_;
                                            let _e2622 = phi_4376_;
                                            let _e2624 = phi_4377_;
                                            let _e2626 = phi_4378_;
                                            let _e2628 = phi_4379_;
                                            let _e2630 = phi_4380_;
                                            let _e2632 = phi_4381_;
                                            let _e2634 = phi_4382_;
                                            if _e2626 {
                                                if (_e1556 <= _e1558) {
                                                    let _e2787 = (_e1566 + 1u);
                                                    let _e2788 = (_e2787 > 3u);
                                                    phi_4717_ = _e2787;
                                                    phi_4718_ = f32();
                                                    phi_4719_ = false;
                                                    phi_4720_ = select(true, false, _e2788);
                                                    phi_4721_ = _e2788;
                                                } else {
                                                    let _e2638 = local_3.member[0u];
                                                    let _e2641 = local_3.member_1[0u];
                                                    let _e2644 = local_3.member[0u];
                                                    let _e2650 = local_3.member_2[0u];
                                                    let _e2651 = ((_e2638 + ((_e2641 - _e2644) * _e1562)) - _e2650);
                                                    let _e2654 = local_3.member[1u];
                                                    let _e2657 = local_3.member_1[1u];
                                                    let _e2660 = local_3.member[1u];
                                                    let _e2666 = local_3.member_2[1u];
                                                    let _e2667 = ((_e2654 + ((_e2657 - _e2660) * _e1562)) - _e2666);
                                                    let _e2669 = select(_e2667, _e2651, (_e2651 < _e2667));
                                                    let _e2672 = local_3.member[2u];
                                                    let _e2675 = local_3.member_1[2u];
                                                    let _e2678 = local_3.member[2u];
                                                    let _e2684 = local_3.member_2[2u];
                                                    let _e2685 = ((_e2672 + ((_e2675 - _e2678) * _e1562)) - _e2684);
                                                    let _e2688 = local_3.member[3u];
                                                    let _e2691 = local_3.member_1[3u];
                                                    let _e2694 = local_3.member[3u];
                                                    let _e2700 = local_3.member_2[3u];
                                                    let _e2701 = ((_e2688 + ((_e2691 - _e2694) * _e1562)) - _e2700);
                                                    let _e2703 = select(_e2701, _e2685, (_e2685 < _e2701));
                                                    let _e2705 = select(_e2703, _e2669, (_e2669 < _e2703));
                                                    let _e2708 = local_4.member[0u];
                                                    let _e2711 = local_4.member_1[0u];
                                                    let _e2714 = local_4.member[0u];
                                                    let _e2720 = local_4.member_2[0u];
                                                    let _e2721 = ((_e2708 + ((_e2711 - _e2714) * _e1556)) - _e2720);
                                                    let _e2724 = local_4.member[1u];
                                                    let _e2727 = local_4.member_1[1u];
                                                    let _e2730 = local_4.member[1u];
                                                    let _e2736 = local_4.member_2[1u];
                                                    let _e2737 = ((_e2724 + ((_e2727 - _e2730) * _e1556)) - _e2736);
                                                    let _e2739 = select(_e2737, _e2721, (_e2721 < _e2737));
                                                    let _e2742 = local_4.member[2u];
                                                    let _e2745 = local_4.member_1[2u];
                                                    let _e2748 = local_4.member[2u];
                                                    let _e2754 = local_4.member_2[2u];
                                                    let _e2755 = ((_e2742 + ((_e2745 - _e2748) * _e1556)) - _e2754);
                                                    let _e2758 = local_4.member[3u];
                                                    let _e2761 = local_4.member_1[3u];
                                                    let _e2764 = local_4.member[3u];
                                                    let _e2770 = local_4.member_2[3u];
                                                    let _e2771 = ((_e2758 + ((_e2761 - _e2764) * _e1556)) - _e2770);
                                                    let _e2773 = select(_e2771, _e2755, (_e2755 < _e2771));
                                                    let _e2775 = select(_e2773, _e2739, (_e2739 < _e2773));
                                                    if (_e2775 > 0f) {
                                                        phi_4715_ = 0.5f;
                                                    } else {
                                                        let _e2779 = (0.95f * (_e2705 / (_e2705 - _e2775)));
                                                        phi_4715_ = select(0.0625f, select(0.9f, _e2779, (_e2779 < 0.9f)), (_e2779 > 0.0625f));
                                                    }
                                                    let _e2785 = phi_4715_;
                                                    phi_4717_ = u32();
                                                    phi_4718_ = (_e1855 * _e2785);
                                                    phi_4719_ = true;
                                                    phi_4720_ = false;
                                                    phi_4721_ = false;
                                                }
                                                let _e2791 = phi_4717_;
                                                let _e2793 = phi_4718_;
                                                let _e2795 = phi_4719_;
                                                let _e2797 = phi_4720_;
                                                let _e2799 = phi_4721_;
                                                phi_4722_ = _e2791;
                                                phi_4723_ = _e1558;
                                                phi_4724_ = _e2793;
                                                phi_4725_ = _e1560;
                                                phi_4726_ = _e1562;
                                                phi_4727_ = _e1564;
                                                phi_4728_ = _e1566;
                                                phi_4729_ = _e2795;
                                                phi_4730_ = _e2797;
                                                phi_4731_ = _e2799;
                                                phi_4732_ = false;
                                                phi_4733_ = false;
                                                phi_4734_ = false;
                                            } else {
                                                phi_4722_ = u32();
                                                phi_4723_ = _e2618;
                                                phi_4724_ = _e2620;
                                                phi_4725_ = _e2622;
                                                phi_4726_ = _e1556;
                                                phi_4727_ = true;
                                                phi_4728_ = 0u;
                                                phi_4729_ = _e2628;
                                                phi_4730_ = false;
                                                phi_4731_ = false;
                                                phi_4732_ = _e2630;
                                                phi_4733_ = _e2632;
                                                phi_4734_ = _e2634;
                                            }
                                            let _e2801 = phi_4722_;
                                            let _e2803 = phi_4723_;
                                            let _e2805 = phi_4724_;
                                            let _e2807 = phi_4725_;
                                            let _e2809 = phi_4726_;
                                            let _e2811 = phi_4727_;
                                            let _e2813 = phi_4728_;
                                            let _e2815 = phi_4729_;
                                            let _e2817 = phi_4730_;
                                            let _e2819 = phi_4731_;
                                            let _e2821 = phi_4732_;
                                            let _e2823 = phi_4733_;
                                            let _e2825 = phi_4734_;
                                            if _e2815 {
                                                let _e2826 = (_e2809 + _e2805);
                                                let _e2828 = select(_e2803, _e2826, (_e2826 > _e2803));
                                                let _e2830 = select(_e381, _e2828, (_e2828 < _e381));
                                                let _e2833 = select(((_e2830 - _e2809) > _e1551), true, !(_e1564));
                                                phi_4762_ = _e2830;
                                                phi_4763_ = _e2803;
                                                phi_4764_ = _e2807;
                                                phi_4765_ = _e2809;
                                                phi_4766_ = _e2811;
                                                phi_4767_ = _e2813;
                                                phi_4768_ = _e2833;
                                                phi_4769_ = select(true, false, _e2833);
                                                phi_4770_ = false;
                                                phi_4771_ = false;
                                                phi_4772_ = false;
                                                phi_4773_ = false;
                                            } else {
                                                phi_4762_ = _e1556;
                                                phi_4763_ = _e1558;
                                                phi_4764_ = _e1560;
                                                phi_4765_ = _e1562;
                                                phi_4766_ = _e1564;
                                                phi_4767_ = _e2801;
                                                phi_4768_ = _e2817;
                                                phi_4769_ = false;
                                                phi_4770_ = _e2819;
                                                phi_4771_ = _e2821;
                                                phi_4772_ = _e2823;
                                                phi_4773_ = _e2825;
                                            }
                                            let _e2836 = phi_4762_;
                                            let _e2838 = phi_4763_;
                                            let _e2840 = phi_4764_;
                                            let _e2842 = phi_4765_;
                                            let _e2844 = phi_4766_;
                                            let _e2846 = phi_4767_;
                                            let _e2848 = phi_4768_;
                                            let _e2850 = phi_4769_;
                                            let _e2852 = phi_4770_;
                                            let _e2854 = phi_4771_;
                                            let _e2856 = phi_4772_;
                                            let _e2858 = phi_4773_;
                                            phi_2595_ = _e2836;
                                            phi_2597_ = _e2838;
                                            phi_2599_ = _e2840;
                                            phi_2601_ = _e2842;
                                            phi_2603_ = _e2844;
                                            phi_2605_ = _e2846;
                                            phi_4774_ = _e2803;
                                            phi_4775_ = _e2624;
                                            phi_4776_ = _e2848;
                                            phi_4777_ = _e2850;
                                            phi_4778_ = _e2852;
                                            phi_4779_ = _e2854;
                                            phi_4780_ = _e2856;
                                            phi_4781_ = false;
                                            phi_4782_ = _e2858;
                                        } else {
                                            phi_2595_ = f32();
                                            phi_2597_ = f32();
                                            phi_2599_ = f32();
                                            phi_2601_ = f32();
                                            phi_2603_ = bool();
                                            phi_2605_ = u32();
                                            phi_4774_ = f32();
                                            phi_4775_ = f32();
                                            phi_4776_ = false;
                                            phi_4777_ = false;
                                            phi_4778_ = false;
                                            phi_4779_ = false;
                                            phi_4780_ = false;
                                            phi_4781_ = true;
                                            phi_4782_ = false;
                                        }
                                        let _e2860 = phi_2595_;
                                        let _e2862 = phi_2597_;
                                        let _e2864 = phi_2599_;
                                        let _e2866 = phi_2601_;
                                        let _e2868 = phi_2603_;
                                        let _e2870 = phi_2605_;
                                        let _e2872 = phi_4774_;
                                        let _e2874 = phi_4775_;
                                        let _e2876 = phi_4776_;
                                        let _e2878 = phi_4777_;
                                        let _e2880 = phi_4778_;
                                        let _e2882 = phi_4779_;
                                        let _e2884 = phi_4780_;
                                        let _e2886 = phi_4781_;
                                        let _e2888 = phi_4782_;
                                        local_9 = _e2878;
                                        local_10 = _e2880;
                                        local_11 = _e2878;
                                        local_12 = _e2882;
                                        local_13 = _e2878;
                                        local_14 = _e2884;
                                        local_15 = _e2878;
                                        local_16 = _e2886;
                                        local_17 = _e2878;
                                        local_18 = _e2888;
                                        local_20 = _e2878;
                                        local_21 = _e2874;
                                        local_22 = _e2872;
                                        continue;
                                        continuing {
                                            phi_2591_ = type_9(select(_e1554.member, (_e1554.member + 1u), _e1569), select(_e1554.member_1, _e1554.member_1, _e1569));
                                            phi_2594_ = _e2860;
                                            phi_2596_ = _e2862;
                                            phi_2598_ = _e2864;
                                            phi_2600_ = _e2866;
                                            phi_2602_ = _e2868;
                                            phi_2604_ = _e2870;
                                            break if !(_e2876);
                                        }
                                    }
                                    let _e2891 = local_9;
                                    let _e2893 = local_10;
                                    let _e2894 = select(_e2893, false, _e2891);
                                    let _e2896 = local_11;
                                    let _e2898 = local_12;
                                    let _e2901 = local_13;
                                    let _e2903 = local_14;
                                    let _e2906 = local_15;
                                    let _e2908 = local_16;
                                    let _e2911 = local_17;
                                    let _e2913 = local_18;
                                    let _e2919 = local_19;
                                    let _e2921 = select(select(_e2898, false, _e2896), false, _e2894);
                                    let _e2924 = local_20;
                                    let _e2931 = select(select(select(_e2903, false, _e2901), false, _e2894), false, _e2921);
                                    let _e2937 = local_21;
                                    let _e2939 = local_22;
                                    let _e2941 = select(select(select(_e2924, false, _e2894), false, _e2921), true, _e2931);
                                    let _e2946 = local_23;
                                    let _e2948 = select(select(select(select(select(_e2908, false, _e2906), false, _e2894), false, _e2921), false, _e2931), true, _e2941);
                                    let _e2955 = select(select(select(select(select(select(_e2913, false, _e2911), false, _e2894), false, _e2921), false, _e2931), false, _e2941), false, _e2948);
                                    let _e2960 = select(select(select(select(select(_e2894, true, _e2921), false, _e2931), false, _e2941), false, _e2948), true, _e2955);
                                    phi_4849_ = select(select(type_33().member_1, select(_e2946, select(_e2939, _e2937, _e2931), _e2941), _e2948), select(select(select(type_33().member_1, _e2919, _e2894), type_33().member_1, _e2921), type_33().member_1, _e2955), _e2960);
                                    phi_4850_ = (select(select(type_33().member, 1u, _e2948), select(select(select(type_33().member, 1u, _e2894), 0u, _e2921), 0u, _e2955), _e2960) != 0u);
                                } else {
                                    phi_4849_ = _e1318;
                                    phi_4850_ = true;
                                }
                                let _e2965 = phi_4849_;
                                let _e2967 = phi_4850_;
                                if _e2967 {
                                    let _e2968 = (_e2965 > _e379);
                                    if _e2968 {
                                        phi_7015_ = f32();
                                        phi_7016_ = u32();
                                        phi_7017_ = f32();
                                        phi_7018_ = type_35();
                                        phi_7019_ = u32();
                                        phi_7020_ = u32();
                                        phi_7021_ = false;
                                        phi_7022_ = false;
                                        phi_7023_ = false;
                                    } else {
                                        let _e2971 = local_5.member[0u];
                                        let _e2977 = local_5.member[1u];
                                        let _e2993 = local_5.member_1[0u];
                                        let _e2999 = local_5.member_1[1u];
                                        let _e3015 = local_5.member_2[0u];
                                        let _e3021 = local_5.member_2[1u];
                                        let _e3035 = function_3(array<f32, 3>((_e2971[0] + ((_e2977[0] - _e2971[0]) * _e1322)), (_e2971[1] + ((_e2977[1] - _e2971[1]) * _e1322)), (_e2971[2] + ((_e2977[2] - _e2971[2]) * _e1322))), array<f32, 3>((_e2993[0] + ((_e2999[0] - _e2993[0]) * _e1322)), (_e2993[1] + ((_e2999[1] - _e2993[1]) * _e1322)), (_e2993[2] + ((_e2999[2] - _e2993[2]) * _e1322))), array<f32, 3>((_e3015[0] + ((_e3021[0] - _e3015[0]) * _e1322)), (_e3015[1] + ((_e3021[1] - _e3015[1]) * _e1322)), (_e3015[2] + ((_e3021[2] - _e3015[2]) * _e1322))), _e224.member);
                                        let _e3049 = ((select(_e3035[0], -(_e3035[0]), (_e3035[0] < 0f)) + select(_e3035[1], -(_e3035[1]), (_e3035[1] < 0f))) + select(_e3035[2], -(_e3035[2]), (_e3035[2] < 0f)));
                                        let _e3052 = local_5.member[0u];
                                        let _e3058 = local_5.member_1[0u];
                                        let _e3064 = local_5.member_2[0u];
                                        let _e3068 = (_e3052[0] - _e3058[0]);
                                        let _e3069 = (_e3052[1] - _e3058[1]);
                                        let _e3070 = (_e3052[2] - _e3058[2]);
                                        let _e3071 = (_e224.member == 0u);
                                        let _e3083 = local_5.member[1u];
                                        let _e3089 = local_5.member_1[1u];
                                        let _e3095 = local_5.member_2[1u];
                                        let _e3099 = (_e3083[0] - _e3089[0]);
                                        let _e3100 = (_e3083[1] - _e3089[1]);
                                        let _e3101 = (_e3083[2] - _e3089[2]);
                                        let _e3102 = (_e224.member == 0u);
                                        let _e3114 = local_5.member[0u];
                                        let _e3120 = select(_e3114[0], -(_e3114[0]), (_e3114[0] < 0f));
                                        let _e3123 = select(_e3114[1], -(_e3114[1]), (_e3114[1] < 0f));
                                        let _e3125 = select(_e3123, _e3120, (_e3120 > _e3123));
                                        let _e3128 = select(_e3114[2], -(_e3114[2]), (_e3114[2] < 0f));
                                        let _e3130 = select(_e3128, _e3125, (_e3125 > _e3128));
                                        let _e3133 = local_5.member[1u];
                                        let _e3139 = select(_e3133[0], -(_e3133[0]), (_e3133[0] < 0f));
                                        let _e3142 = select(_e3133[1], -(_e3133[1]), (_e3133[1] < 0f));
                                        let _e3144 = select(_e3142, _e3139, (_e3139 > _e3142));
                                        let _e3147 = select(_e3133[2], -(_e3133[2]), (_e3133[2] < 0f));
                                        let _e3149 = select(_e3147, _e3144, (_e3144 > _e3147));
                                        let _e3153 = local_5.member_3;
                                        let _e3157 = local_5.member_1[0u];
                                        let _e3163 = select(_e3157[0], -(_e3157[0]), (_e3157[0] < 0f));
                                        let _e3166 = select(_e3157[1], -(_e3157[1]), (_e3157[1] < 0f));
                                        let _e3168 = select(_e3166, _e3163, (_e3163 > _e3166));
                                        let _e3171 = select(_e3157[2], -(_e3157[2]), (_e3157[2] < 0f));
                                        let _e3173 = select(_e3171, _e3168, (_e3168 > _e3171));
                                        let _e3176 = local_5.member_1[1u];
                                        let _e3182 = select(_e3176[0], -(_e3176[0]), (_e3176[0] < 0f));
                                        let _e3185 = select(_e3176[1], -(_e3176[1]), (_e3176[1] < 0f));
                                        let _e3187 = select(_e3185, _e3182, (_e3182 > _e3185));
                                        let _e3190 = select(_e3176[2], -(_e3176[2]), (_e3176[2] < 0f));
                                        let _e3192 = select(_e3190, _e3187, (_e3187 > _e3190));
                                        let _e3196 = local_5.member_3;
                                        let _e3200 = local_5.member_2[0u];
                                        let _e3206 = select(_e3200[0], -(_e3200[0]), (_e3200[0] < 0f));
                                        let _e3209 = select(_e3200[1], -(_e3200[1]), (_e3200[1] < 0f));
                                        let _e3211 = select(_e3209, _e3206, (_e3206 > _e3209));
                                        let _e3214 = select(_e3200[2], -(_e3200[2]), (_e3200[2] < 0f));
                                        let _e3216 = select(_e3214, _e3211, (_e3211 > _e3214));
                                        let _e3219 = local_5.member_2[1u];
                                        let _e3225 = select(_e3219[0], -(_e3219[0]), (_e3219[0] < 0f));
                                        let _e3228 = select(_e3219[1], -(_e3219[1]), (_e3219[1] < 0f));
                                        let _e3230 = select(_e3228, _e3225, (_e3225 > _e3228));
                                        let _e3233 = select(_e3219[2], -(_e3219[2]), (_e3219[2] < 0f));
                                        let _e3235 = select(_e3233, _e3230, (_e3230 > _e3233));
                                        let _e3239 = local_5.member_3;
                                        let _e3246 = local_5.member_3;
                                        local_1 = type_29(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3052, array<f32, 3>(_e3068, _e3069, _e3070), array<f32, 3>((_e3052[0] - _e3064[0]), (_e3052[1] - _e3064[1]), (_e3052[2] - _e3064[2])), array<f32, 3>(select((_e3068 - _e3064[0]), _e3052[0], _e3071), select((_e3069 - _e3064[1]), _e3052[1], _e3071), select((_e3070 - _e3064[2]), _e3052[2], _e3071))), array<array<f32, 3>, 4>(_e3083, array<f32, 3>(_e3099, _e3100, _e3101), array<f32, 3>((_e3083[0] - _e3095[0]), (_e3083[1] - _e3095[1]), (_e3083[2] - _e3095[2])), array<f32, 3>(select((_e3099 - _e3095[0]), _e3083[0], _e3102), select((_e3100 - _e3095[1]), _e3083[1], _e3102), select((_e3101 - _e3095[2]), _e3083[2], _e3102)))), ((((((select(_e3149, _e3130, (_e3130 > _e3149)) + _e3153) + (select(_e3192, _e3173, (_e3173 > _e3192)) + _e3196)) + (select(_e3235, _e3216, (_e3216 > _e3235)) + _e3239)) * (0.000000059604645f * 16f)) + (_e3246 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e608.member_1);
                                        let _e3262 = local_1.member_1;
                                        if (_e3049 > _e3262) {
                                            if ((bitcast<u32>(_e3049) & 2139095040u) != 2139095040u) {
                                                let _e3267 = (1f / _e3049);
                                                let _e3269 = (_e3035[0] * _e3267);
                                                let _e3271 = (_e3035[1] * _e3267);
                                                let _e3273 = (_e3035[2] * _e3267);
                                                let _e3278 = (((_e3269 * _e3269) + (_e3271 * _e3271)) + (_e3273 * _e3273));
                                                if (_e3278 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5527_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3278 > 0f));
                                                } else {
                                                    phi_5470_ = type_16(0i, 5i);
                                                    phi_5473_ = bitcast<f32>(((bitcast<u32>(_e3278) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3286 = phi_5470_;
                                                        let _e3288 = phi_5473_;
                                                        local_24 = _e3288;
                                                        if (_e3286.member < _e3286.member_1) {
                                                            let _e3295 = (_e3286.member + 1i);
                                                            phi_5471_ = type_16(select(_e3295, type_17().member_1, select(false, true, ((false == (_e3295 > _e3286.member)) != false))), _e3286.member_1);
                                                            phi_5514_ = type_17(1u, _e3286.member);
                                                        } else {
                                                            phi_5471_ = _e3286;
                                                            phi_5514_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e3306 = phi_5471_;
                                                        let _e3308 = phi_5514_;
                                                        let _e3311 = (bitcast<i32>(_e3308.member) != 0i);
                                                        if _e3311 {
                                                            phi_5474_ = (0.5f * (_e3288 + (_e3278 / _e3288)));
                                                        } else {
                                                            phi_5474_ = f32();
                                                        }
                                                        let _e3316 = phi_5474_;
                                                        continue;
                                                        continuing {
                                                            phi_5470_ = _e3306;
                                                            phi_5473_ = _e3316;
                                                            break if !(_e3311);
                                                        }
                                                    }
                                                    let _e3321 = local_24;
                                                    phi_5527_ = (_e3321 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3327 = phi_5527_;
                                                let _e3328 = (0.000000059604645f * 12f);
                                                let _e3330 = local_1.member_1;
                                                let _e3333 = local_1.member_2;
                                                let _e3337 = ((_e3330 * 1.01f) + ((_e3333 * _e3327) * (1f + _e3328)));
                                                let _e3341 = local_1.member[0u][0u];
                                                let _e3349 = (((_e3269 * _e3341[0]) + (_e3271 * _e3341[1])) + (_e3273 * _e3341[2]));
                                                let _e3353 = local_1.member[0u][1u];
                                                let _e3361 = (((_e3269 * _e3353[0]) + (_e3271 * _e3353[1])) + (_e3273 * _e3353[2]));
                                                let _e3365 = local_1.member[0u][2u];
                                                let _e3373 = (((_e3269 * _e3365[0]) + (_e3271 * _e3365[1])) + (_e3273 * _e3365[2]));
                                                let _e3377 = local_1.member[0u][3u];
                                                let _e3385 = (((_e3269 * _e3377[0]) + (_e3271 * _e3377[1])) + (_e3273 * _e3377[2]));
                                                let _e3389 = local_1.member[1u][0u];
                                                let _e3397 = (((_e3269 * _e3389[0]) + (_e3271 * _e3389[1])) + (_e3273 * _e3389[2]));
                                                let _e3401 = local_1.member[1u][1u];
                                                let _e3409 = (((_e3269 * _e3401[0]) + (_e3271 * _e3401[1])) + (_e3273 * _e3401[2]));
                                                let _e3413 = local_1.member[1u][2u];
                                                let _e3421 = (((_e3269 * _e3413[0]) + (_e3271 * _e3413[1])) + (_e3273 * _e3413[2]));
                                                let _e3425 = local_1.member[1u][3u];
                                                let _e3433 = (((_e3269 * _e3425[0]) + (_e3271 * _e3425[1])) + (_e3273 * _e3425[2]));
                                                local_2 = type_30(array<f32, 4>(_e3349, _e3361, _e3373, _e3385), array<f32, 4>(_e3397, _e3409, _e3421, _e3433), array<f32, 4>((_e3337 + ((select(_e3349, -(_e3349), (_e3349 < 0f)) + select(_e3397, -(_e3397), (_e3397 < 0f))) * _e3328)), (_e3337 + ((select(_e3361, -(_e3361), (_e3361 < 0f)) + select(_e3409, -(_e3409), (_e3409 < 0f))) * _e3328)), (_e3337 + ((select(_e3373, -(_e3373), (_e3373 < 0f)) + select(_e3421, -(_e3421), (_e3421 < 0f))) * _e3328)), (_e3337 + ((select(_e3385, -(_e3385), (_e3385 < 0f)) + select(_e3433, -(_e3433), (_e3433 < 0f))) * _e3328))));
                                                let _e3478 = (((_e3269 * _e3269) + (_e3271 * _e3271)) + (_e3273 * _e3273));
                                                if (_e3478 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5819_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3478 > 0f));
                                                } else {
                                                    phi_5762_ = type_16(0i, 5i);
                                                    phi_5765_ = bitcast<f32>(((bitcast<u32>(_e3478) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3486 = phi_5762_;
                                                        let _e3488 = phi_5765_;
                                                        local_25 = _e3488;
                                                        if (_e3486.member < _e3486.member_1) {
                                                            let _e3495 = (_e3486.member + 1i);
                                                            phi_5763_ = type_16(select(_e3495, type_17().member_1, select(false, true, ((false == (_e3495 > _e3486.member)) != false))), _e3486.member_1);
                                                            phi_5806_ = type_17(1u, _e3486.member);
                                                        } else {
                                                            phi_5763_ = _e3486;
                                                            phi_5806_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e3506 = phi_5763_;
                                                        let _e3508 = phi_5806_;
                                                        let _e3511 = (bitcast<i32>(_e3508.member) != 0i);
                                                        if _e3511 {
                                                            phi_5766_ = (0.5f * (_e3488 + (_e3478 / _e3488)));
                                                        } else {
                                                            phi_5766_ = f32();
                                                        }
                                                        let _e3516 = phi_5766_;
                                                        continue;
                                                        continuing {
                                                            phi_5762_ = _e3506;
                                                            phi_5765_ = _e3516;
                                                            break if !(_e3511);
                                                        }
                                                    }
                                                    let _e3521 = local_25;
                                                    phi_5819_ = (_e3521 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3527 = phi_5819_;
                                                let _e3538 = (((_e3035[0] * _e3035[0]) + (_e3035[1] * _e3035[1])) + (_e3035[2] * _e3035[2]));
                                                if (_e3538 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5908_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3538 > 0f));
                                                } else {
                                                    phi_5851_ = type_16(0i, 5i);
                                                    phi_5854_ = bitcast<f32>(((bitcast<u32>(_e3538) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3546 = phi_5851_;
                                                        let _e3548 = phi_5854_;
                                                        local_26 = _e3548;
                                                        if (_e3546.member < _e3546.member_1) {
                                                            let _e3555 = (_e3546.member + 1i);
                                                            phi_5852_ = type_16(select(_e3555, type_17().member_1, select(false, true, ((false == (_e3555 > _e3546.member)) != false))), _e3546.member_1);
                                                            phi_5895_ = type_17(1u, _e3546.member);
                                                        } else {
                                                            phi_5852_ = _e3546;
                                                            phi_5895_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e3566 = phi_5852_;
                                                        let _e3568 = phi_5895_;
                                                        let _e3571 = (bitcast<i32>(_e3568.member) != 0i);
                                                        if _e3571 {
                                                            phi_5855_ = (0.5f * (_e3548 + (_e3538 / _e3548)));
                                                        } else {
                                                            phi_5855_ = f32();
                                                        }
                                                        let _e3576 = phi_5855_;
                                                        continue;
                                                        continuing {
                                                            phi_5851_ = _e3566;
                                                            phi_5854_ = _e3576;
                                                            break if !(_e3571);
                                                        }
                                                    }
                                                    let _e3581 = local_26;
                                                    phi_5908_ = (_e3581 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3587 = phi_5908_;
                                                let _e3593 = local_5.member[0u];
                                                let _e3599 = select(_e3593[0], -(_e3593[0]), (_e3593[0] < 0f));
                                                let _e3602 = select(_e3593[1], -(_e3593[1]), (_e3593[1] < 0f));
                                                let _e3604 = select(_e3602, _e3599, (_e3599 > _e3602));
                                                let _e3607 = select(_e3593[2], -(_e3593[2]), (_e3593[2] < 0f));
                                                let _e3609 = select(_e3607, _e3604, (_e3604 > _e3607));
                                                let _e3612 = local_5.member[1u];
                                                let _e3618 = select(_e3612[0], -(_e3612[0]), (_e3612[0] < 0f));
                                                let _e3621 = select(_e3612[1], -(_e3612[1]), (_e3612[1] < 0f));
                                                let _e3623 = select(_e3621, _e3618, (_e3618 > _e3621));
                                                let _e3626 = select(_e3612[2], -(_e3612[2]), (_e3612[2] < 0f));
                                                let _e3628 = select(_e3626, _e3623, (_e3623 > _e3626));
                                                let _e3632 = local_5.member_3;
                                                let _e3636 = local_5.member_1[0u];
                                                let _e3642 = select(_e3636[0], -(_e3636[0]), (_e3636[0] < 0f));
                                                let _e3645 = select(_e3636[1], -(_e3636[1]), (_e3636[1] < 0f));
                                                let _e3647 = select(_e3645, _e3642, (_e3642 > _e3645));
                                                let _e3650 = select(_e3636[2], -(_e3636[2]), (_e3636[2] < 0f));
                                                let _e3652 = select(_e3650, _e3647, (_e3647 > _e3650));
                                                let _e3655 = local_5.member_1[1u];
                                                let _e3661 = select(_e3655[0], -(_e3655[0]), (_e3655[0] < 0f));
                                                let _e3664 = select(_e3655[1], -(_e3655[1]), (_e3655[1] < 0f));
                                                let _e3666 = select(_e3664, _e3661, (_e3661 > _e3664));
                                                let _e3669 = select(_e3655[2], -(_e3655[2]), (_e3655[2] < 0f));
                                                let _e3671 = select(_e3669, _e3666, (_e3666 > _e3669));
                                                let _e3675 = local_5.member_3;
                                                let _e3679 = local_5.member_2[0u];
                                                let _e3685 = select(_e3679[0], -(_e3679[0]), (_e3679[0] < 0f));
                                                let _e3688 = select(_e3679[1], -(_e3679[1]), (_e3679[1] < 0f));
                                                let _e3690 = select(_e3688, _e3685, (_e3685 > _e3688));
                                                let _e3693 = select(_e3679[2], -(_e3679[2]), (_e3679[2] < 0f));
                                                let _e3695 = select(_e3693, _e3690, (_e3690 > _e3693));
                                                let _e3698 = local_5.member_2[1u];
                                                let _e3704 = select(_e3698[0], -(_e3698[0]), (_e3698[0] < 0f));
                                                let _e3707 = select(_e3698[1], -(_e3698[1]), (_e3698[1] < 0f));
                                                let _e3709 = select(_e3707, _e3704, (_e3704 > _e3707));
                                                let _e3712 = select(_e3698[2], -(_e3698[2]), (_e3698[2] < 0f));
                                                let _e3714 = select(_e3712, _e3709, (_e3709 > _e3712));
                                                let _e3718 = local_5.member_3;
                                                let _e3725 = local_5.member_3;
                                                let _e3735 = ((((_e3587 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3628, _e3609, (_e3609 > _e3628)) + _e3632) + (select(_e3671, _e3652, (_e3652 > _e3671)) + _e3675)) + (select(_e3714, _e3695, (_e3695 > _e3714)) + _e3718)) * (0.000000059604645f * 16f)) + (_e3725 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3527) * (1f + (0.000000059604645f * 64f)));
                                                let _e3738 = local_2.member[0u];
                                                let _e3741 = local_2.member_1[0u];
                                                phi_6216_ = type_9(1u, 4u);
                                                phi_6219_ = ((_e3738 + ((_e3741 - _e3738) * _e1322)) - ((_e3262 * 1.01f) + ((select(_e3738, -(_e3738), (_e3738 < 0f)) + select(_e3741, -(_e3741), (_e3741 < 0f))) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e3758 = phi_6216_;
                                                    let _e3760 = phi_6219_;
                                                    local_27 = _e3760;
                                                    local_28 = _e3760;
                                                    let _e3763 = (_e3758.member < _e3758.member_1);
                                                    let _e3774 = select(type_9().member_1, _e3758.member, _e3763);
                                                    let _e3776 = (bitcast<i32>(select(0u, 1u, _e3763)) != 0i);
                                                    if _e3776 {
                                                        let _e3779 = local_2.member[_e3774];
                                                        let _e3782 = local_2.member_1[_e3774];
                                                        let _e3797 = ((_e3779 + ((_e3782 - _e3779) * _e1322)) - ((_e3262 * 1.01f) + ((select(_e3779, -(_e3779), (_e3779 < 0f)) + select(_e3782, -(_e3782), (_e3782 < 0f))) * (0.000000059604645f * 12f))));
                                                        phi_6220_ = select(_e3797, _e3760, (_e3760 < _e3797));
                                                    } else {
                                                        phi_6220_ = f32();
                                                    }
                                                    let _e3801 = phi_6220_;
                                                    continue;
                                                    continuing {
                                                        phi_6216_ = type_9(select(_e3758.member, (_e3758.member + 1u), _e3763), select(_e3758.member_1, _e3758.member_1, _e3763));
                                                        phi_6219_ = _e3801;
                                                        break if !(_e3776);
                                                    }
                                                }
                                                let _e3804 = local_27;
                                                if (_e3804 > 0f) {
                                                    let _e3808 = local_28;
                                                    let _e3811 = (((_e3735 - _e3808) / _e3735) * 2.02f);
                                                    if (_e3811 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_6375_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3811 > 0f));
                                                    } else {
                                                        phi_6318_ = type_16(0i, 5i);
                                                        phi_6321_ = bitcast<f32>(((bitcast<u32>(_e3811) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e3819 = phi_6318_;
                                                            let _e3821 = phi_6321_;
                                                            local_29 = _e3821;
                                                            if (_e3819.member < _e3819.member_1) {
                                                                let _e3828 = (_e3819.member + 1i);
                                                                phi_6319_ = type_16(select(_e3828, type_17().member_1, select(false, true, ((false == (_e3828 > _e3819.member)) != false))), _e3819.member_1);
                                                                phi_6362_ = type_17(1u, _e3819.member);
                                                            } else {
                                                                phi_6319_ = _e3819;
                                                                phi_6362_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e3839 = phi_6319_;
                                                            let _e3841 = phi_6362_;
                                                            let _e3844 = (bitcast<i32>(_e3841.member) != 0i);
                                                            if _e3844 {
                                                                phi_6322_ = (0.5f * (_e3821 + (_e3811 / _e3821)));
                                                            } else {
                                                                phi_6322_ = f32();
                                                            }
                                                            let _e3849 = phi_6322_;
                                                            continue;
                                                            continuing {
                                                                phi_6318_ = _e3839;
                                                                phi_6321_ = _e3849;
                                                                break if !(_e3844);
                                                            }
                                                        }
                                                        let _e3854 = local_29;
                                                        phi_6375_ = (_e3854 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e3860 = phi_6375_;
                                                    let _e3862 = ((_e3860 * _e3527) * 1.01f);
                                                    phi_6380_ = type_9(0u, 4u);
                                                    phi_6383_ = 2f;
                                                    phi_6385_ = true;
                                                    phi_6387_ = true;
                                                    loop {
                                                        let _e3864 = phi_6380_;
                                                        let _e3866 = phi_6383_;
                                                        let _e3868 = phi_6385_;
                                                        let _e3870 = phi_6387_;
                                                        local_30 = _e3866;
                                                        local_31 = _e3866;
                                                        local_32 = _e3868;
                                                        local_33 = _e3870;
                                                        local_34 = _e3870;
                                                        local_35 = _e3870;
                                                        local_60 = _e3870;
                                                        local_36 = _e3870;
                                                        let _e3873 = (_e3864.member < _e3864.member_1);
                                                        let _e3884 = select(type_9().member_1, _e3864.member, _e3873);
                                                        let _e3886 = (bitcast<i32>(select(0u, 1u, _e3873)) != 0i);
                                                        if _e3886 {
                                                            let _e3890 = local_1.member[0u][_e3884];
                                                            let _e3897 = local_1.member[1u][_e3884];
                                                            let _e3911 = ((select(_e3890[0], -(_e3890[0]), (_e3890[0] < 0f)) + select(_e3890[1], -(_e3890[1]), (_e3890[1] < 0f))) + select(_e3890[2], -(_e3890[2]), (_e3890[2] < 0f)));
                                                            let _e3922 = ((select(_e3897[0], -(_e3897[0]), (_e3897[0] < 0f)) + select(_e3897[1], -(_e3897[1]), (_e3897[1] < 0f))) + select(_e3897[2], -(_e3897[2]), (_e3897[2] < 0f)));
                                                            let _e3928 = (_e3897[0] - _e3890[0]);
                                                            let _e3929 = (_e3897[1] - _e3890[1]);
                                                            let _e3930 = (_e3897[2] - _e3890[2]);
                                                            let _e3947 = local_2.member[_e3884];
                                                            let _e3950 = local_2.member_1[_e3884];
                                                            let _e3961 = ((_e3262 * 1.01f) + ((select(_e3947, -(_e3947), (_e3947 < 0f)) + select(_e3950, -(_e3950), (_e3950 < 0f))) * (0.000000059604645f * 12f)));
                                                            let _e3968 = local_2.member_1[_e3884];
                                                            let _e3971 = local_2.member[_e3884];
                                                            let _e3972 = (_e3968 - _e3971);
                                                            let _e3975 = ((_e3961 + _e3961) + (_e3862 * ((((select(_e3928, -(_e3928), (_e3928 < 0f)) + select(_e3929, -(_e3929), (_e3929 < 0f))) + select(_e3930, -(_e3930), (_e3930 < 0f))) + (_e3262 * 6f)) * 1.01f)));
                                                            let _e3978 = ((((_e3947 + ((_e3950 - _e3947) * _e1322)) - _e3961) - (_e3862 * ((select(_e3922, _e3911, (_e3911 > _e3922)) + (_e3262 * 3f)) * 1.01f))) - _e3735);
                                                            let _e3979 = (_e3978 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e3980 = (_e3972 > _e3975);
                                                            if _e3980 {
                                                                phi_6618_ = _e3866;
                                                            } else {
                                                                if _e3979 {
                                                                    let _e3987 = (_e3975 - _e3972);
                                                                    let _e3990 = (_e3978 / select(0.000000000000000000000000000000000000011754944f, _e3987, (_e3987 > 0.000000000000000000000000000000000000011754944f)));
                                                                    phi_6617_ = select(_e3990, _e3866, (_e3866 < _e3990));
                                                                } else {
                                                                    phi_6617_ = _e3866;
                                                                }
                                                                let _e3994 = phi_6617_;
                                                                phi_6618_ = _e3994;
                                                            }
                                                            let _e3996 = phi_6618_;
                                                            phi_6384_ = _e3996;
                                                            phi_6386_ = (_e3868 && select(_e3979, true, (_e3972 < -(_e3975))));
                                                            phi_6388_ = (_e3870 && select(_e3979, true, _e3980));
                                                        } else {
                                                            phi_6384_ = f32();
                                                            phi_6386_ = bool();
                                                            phi_6388_ = bool();
                                                        }
                                                        let _e3998 = phi_6384_;
                                                        let _e4000 = phi_6386_;
                                                        let _e4002 = phi_6388_;
                                                        continue;
                                                        continuing {
                                                            phi_6380_ = type_9(select(_e3864.member, (_e3864.member + 1u), _e3873), select(_e3864.member_1, _e3864.member_1, _e3873));
                                                            phi_6383_ = _e3998;
                                                            phi_6385_ = _e4000;
                                                            phi_6387_ = _e4002;
                                                            break if !(_e3886);
                                                        }
                                                    }
                                                    let _e4005 = local_30;
                                                    let _e4008 = local_31;
                                                    let _e4010 = (select(2f, _e4008, (_e4005 < 2f)) * 0.999f);
                                                    let _e4012 = local_32;
                                                    if _e4012 {
                                                        let _e4015 = local_33;
                                                        let _e4019 = local_34;
                                                        let _e4023 = local_35;
                                                        phi_6633_ = type_35(select(1u, type_35().member, _e4015), select(_e1322, type_35().member_1, _e4019), select(2f, type_35().member_2, _e4023));
                                                        let _e5175 = local_60;
                                                        phi_6634_ = _e5175;
                                                    } else {
                                                        phi_6633_ = type_35();
                                                        phi_6634_ = true;
                                                    }
                                                    let _e4027 = phi_6633_;
                                                    let _e4029 = phi_6634_;
                                                    if _e4029 {
                                                        let _e4031 = local_36;
                                                        if _e4031 {
                                                            let _e4035 = (_e1322 + _e4010);
                                                            let _e4038 = select(_e1322, select(_e381, _e4035, (_e4035 < _e381)), (_e4010 > (0.000000059604645f * 4096f)));
                                                            phi_6655_ = type_9(0u, 4u);
                                                            phi_6658_ = _e4038;
                                                            phi_6660_ = _e1322;
                                                            loop {
                                                                let _e4040 = phi_6655_;
                                                                let _e4042 = phi_6658_;
                                                                let _e4044 = phi_6660_;
                                                                local_37 = _e4042;
                                                                local_38 = _e4044;
                                                                local_39 = _e4044;
                                                                let _e4047 = (_e4040.member < _e4040.member_1);
                                                                let _e4058 = select(type_9().member_1, _e4040.member, _e4047);
                                                                let _e4060 = (bitcast<i32>(select(0u, 1u, _e4047)) != 0i);
                                                                if _e4060 {
                                                                    let _e4063 = local_2.member[_e4058];
                                                                    let _e4066 = local_2.member_1[_e4058];
                                                                    let _e4069 = local_2.member[_e4058];
                                                                    let _e4075 = local_2.member_2[_e4058];
                                                                    let _e4076 = ((_e4063 + ((_e4066 - _e4069) * _e1322)) - _e4075);
                                                                    let _e4079 = local_2.member_1[_e4058];
                                                                    let _e4082 = local_2.member[_e4058];
                                                                    let _e4083 = (_e4079 - _e4082);
                                                                    if (_e4083 > 0f) {
                                                                        let _e4096 = (_e1322 - (_e4076 / _e4083));
                                                                        phi_6769_ = _e4042;
                                                                        phi_6770_ = select(_e4096, _e4044, (_e4044 > _e4096));
                                                                    } else {
                                                                        if (_e4076 > 0f) {
                                                                            if (_e4083 < 0f) {
                                                                                let _e4088 = (_e1322 - (_e4076 / _e4083));
                                                                                phi_6767_ = select(_e4088, _e4042, (_e4042 < _e4088));
                                                                            } else {
                                                                                phi_6767_ = _e4042;
                                                                            }
                                                                            let _e4092 = phi_6767_;
                                                                            phi_6768_ = _e4092;
                                                                        } else {
                                                                            phi_6768_ = _e4042;
                                                                        }
                                                                        let _e4094 = phi_6768_;
                                                                        phi_6769_ = _e4094;
                                                                        phi_6770_ = _e4044;
                                                                    }
                                                                    let _e4100 = phi_6769_;
                                                                    let _e4102 = phi_6770_;
                                                                    phi_6659_ = _e4100;
                                                                    phi_6661_ = _e4102;
                                                                } else {
                                                                    phi_6659_ = f32();
                                                                    phi_6661_ = f32();
                                                                }
                                                                let _e4104 = phi_6659_;
                                                                let _e4106 = phi_6661_;
                                                                continue;
                                                                continuing {
                                                                    phi_6655_ = type_9(select(_e4040.member, (_e4040.member + 1u), _e4047), select(_e4040.member_1, _e4040.member_1, _e4047));
                                                                    phi_6658_ = _e4104;
                                                                    phi_6660_ = _e4106;
                                                                    break if !(_e4060);
                                                                }
                                                            }
                                                            let _e4109 = local_37;
                                                            let _e4111 = local_38;
                                                            let _e4115 = local_39;
                                                            let _e4116 = (_e4115 + ((_e4109 - _e4111) * 0.5f));
                                                            if (_e4116 > _e1322) {
                                                                if (_e4116 <= _e4038) {
                                                                    let _e4121 = local_2.member[0u];
                                                                    let _e4124 = local_2.member_1[0u];
                                                                    let _e4127 = local_2.member[0u];
                                                                    let _e4133 = local_2.member_2[0u];
                                                                    if (((_e4121 + ((_e4124 - _e4127) * _e4116)) - _e4133) > 0f) {
                                                                        let _e4138 = local_2.member[1u];
                                                                        let _e4141 = local_2.member_1[1u];
                                                                        let _e4144 = local_2.member[1u];
                                                                        let _e4150 = local_2.member_2[1u];
                                                                        if (((_e4138 + ((_e4141 - _e4144) * _e4116)) - _e4150) > 0f) {
                                                                            let _e4155 = local_2.member[2u];
                                                                            let _e4158 = local_2.member_1[2u];
                                                                            let _e4161 = local_2.member[2u];
                                                                            let _e4167 = local_2.member_2[2u];
                                                                            if (((_e4155 + ((_e4158 - _e4161) * _e4116)) - _e4167) > 0f) {
                                                                                let _e4172 = local_2.member[3u];
                                                                                let _e4175 = local_2.member_1[3u];
                                                                                let _e4178 = local_2.member[3u];
                                                                                let _e4184 = local_2.member_2[3u];
                                                                                phi_6931_ = (((_e4172 + ((_e4175 - _e4178) * _e4116)) - _e4184) > 0f);
                                                                                phi_6932_ = false;
                                                                            } else {
                                                                                phi_6931_ = bool();
                                                                                phi_6932_ = true;
                                                                            }
                                                                            let _e4188 = phi_6931_;
                                                                            let _e4190 = phi_6932_;
                                                                            phi_6933_ = _e4188;
                                                                            phi_6934_ = _e4190;
                                                                        } else {
                                                                            phi_6933_ = bool();
                                                                            phi_6934_ = true;
                                                                        }
                                                                        let _e4192 = phi_6933_;
                                                                        let _e4194 = phi_6934_;
                                                                        phi_6935_ = _e4192;
                                                                        phi_6936_ = _e4194;
                                                                    } else {
                                                                        phi_6935_ = bool();
                                                                        phi_6936_ = true;
                                                                    }
                                                                    let _e4196 = phi_6935_;
                                                                    let _e4198 = phi_6936_;
                                                                    phi_6945_ = select(true, false, select(_e4196, false, _e4198));
                                                                } else {
                                                                    phi_6945_ = true;
                                                                }
                                                                let _e4202 = phi_6945_;
                                                                phi_6946_ = _e4202;
                                                            } else {
                                                                phi_6946_ = true;
                                                            }
                                                            let _e4204 = phi_6946_;
                                                            phi_6953_ = type_35(2u, _e4038, select(_e4116, 2f, _e4204));
                                                            phi_6954_ = type_35();
                                                            phi_6955_ = false;
                                                        } else {
                                                            phi_6953_ = type_35();
                                                            phi_6954_ = type_35(0u, _e1322, 2f);
                                                            phi_6955_ = true;
                                                        }
                                                        let _e4208 = phi_6953_;
                                                        let _e4210 = phi_6954_;
                                                        let _e4212 = phi_6955_;
                                                        phi_6956_ = _e4208;
                                                        phi_6957_ = _e4210;
                                                        phi_6958_ = _e4212;
                                                    } else {
                                                        phi_6956_ = type_35();
                                                        phi_6957_ = _e4027;
                                                        phi_6958_ = true;
                                                    }
                                                    let _e4214 = phi_6956_;
                                                    let _e4216 = phi_6957_;
                                                    let _e4218 = phi_6958_;
                                                    phi_6963_ = _e4216;
                                                    phi_6964_ = _e4214;
                                                    phi_6965_ = _e4218;
                                                } else {
                                                    phi_6963_ = type_35(0u, _e1322, 2f);
                                                    phi_6964_ = type_35();
                                                    phi_6965_ = true;
                                                }
                                                let _e4220 = phi_6963_;
                                                let _e4222 = phi_6964_;
                                                let _e4224 = phi_6965_;
                                                phi_6969_ = _e4220;
                                                phi_6970_ = _e4222;
                                                phi_6971_ = false;
                                                phi_6972_ = _e4224;
                                            } else {
                                                phi_6969_ = type_35();
                                                phi_6970_ = type_35();
                                                phi_6971_ = true;
                                                phi_6972_ = false;
                                            }
                                            let _e4226 = phi_6969_;
                                            let _e4228 = phi_6970_;
                                            let _e4230 = phi_6971_;
                                            let _e4232 = phi_6972_;
                                            phi_6973_ = _e4226;
                                            phi_6974_ = _e4228;
                                            phi_6975_ = _e4230;
                                            phi_6976_ = _e4232;
                                        } else {
                                            phi_6973_ = type_35();
                                            phi_6974_ = type_35();
                                            phi_6975_ = true;
                                            phi_6976_ = false;
                                        }
                                        let _e4234 = phi_6973_;
                                        let _e4236 = phi_6974_;
                                        let _e4238 = phi_6975_;
                                        let _e4240 = phi_6976_;
                                        let _e4247 = select(_e4240, true, _e4238);
                                        let _e4249 = select(_e4236.member, select(_e4234.member, 0u, _e4238), _e4247);
                                        let _e4253 = select(_e4236.member_2, select(_e4234.member_2, 2f, _e4238), _e4247);
                                        if select(false, _e373, ((_e383 & 64u) != 0u)) {
                                            let _e4255 = (_e4249 == 2u);
                                            let _e4256 = (_e4253 <= _e381);
                                            phi_7010_ = select(f32(), select(f32(), _e4253, _e4256), _e4255);
                                            phi_7011_ = select(f32(), select(f32(), _e4253, _e4256), _e4255);
                                            phi_7012_ = select(false, _e4256, _e4255);
                                            phi_7013_ = select(false, select(true, false, _e4256), _e4255);
                                            phi_7014_ = select(true, false, _e4255);
                                        } else {
                                            phi_7010_ = f32();
                                            phi_7011_ = f32();
                                            phi_7012_ = false;
                                            phi_7013_ = false;
                                            phi_7014_ = true;
                                        }
                                        let _e4266 = phi_7010_;
                                        let _e4268 = phi_7011_;
                                        let _e4270 = phi_7012_;
                                        let _e4272 = phi_7013_;
                                        let _e4274 = phi_7014_;
                                        phi_7015_ = _e4266;
                                        phi_7016_ = _e4249;
                                        phi_7017_ = _e4268;
                                        phi_7018_ = type_35(_e4249, select(_e4236.member_1, select(_e4234.member_1, _e1322, _e4238), _e4247), _e4253);
                                        phi_7019_ = _e4249;
                                        phi_7020_ = _e4249;
                                        phi_7021_ = _e4270;
                                        phi_7022_ = _e4272;
                                        phi_7023_ = _e4274;
                                    }
                                    let _e4276 = phi_7015_;
                                    let _e4278 = phi_7016_;
                                    let _e4280 = phi_7017_;
                                    let _e4282 = phi_7018_;
                                    let _e4284 = phi_7019_;
                                    let _e4286 = phi_7020_;
                                    let _e4288 = phi_7021_;
                                    let _e4290 = phi_7022_;
                                    let _e4292 = phi_7023_;
                                    phi_7024_ = _e4276;
                                    phi_7025_ = _e4278;
                                    phi_7026_ = _e4280;
                                    phi_7027_ = _e4282;
                                    phi_7028_ = _e4284;
                                    phi_7029_ = _e4286;
                                    phi_7030_ = _e4288;
                                    phi_7031_ = _e2968;
                                    phi_7032_ = _e4290;
                                    phi_7033_ = _e4292;
                                    phi_7034_ = false;
                                } else {
                                    phi_7024_ = f32();
                                    phi_7025_ = u32();
                                    phi_7026_ = f32();
                                    phi_7027_ = type_35();
                                    phi_7028_ = u32();
                                    phi_7029_ = u32();
                                    phi_7030_ = false;
                                    phi_7031_ = false;
                                    phi_7032_ = false;
                                    phi_7033_ = false;
                                    phi_7034_ = true;
                                }
                                let _e4294 = phi_7024_;
                                let _e4296 = phi_7025_;
                                let _e4298 = phi_7026_;
                                let _e4300 = phi_7027_;
                                let _e4302 = phi_7028_;
                                let _e4304 = phi_7029_;
                                let _e4306 = phi_7030_;
                                let _e4308 = phi_7031_;
                                let _e4310 = phi_7032_;
                                let _e4312 = phi_7033_;
                                let _e4314 = phi_7034_;
                                phi_7035_ = _e2965;
                                phi_2110_ = _e4294;
                                phi_2112_ = _e4296;
                                phi_2114_ = _e4298;
                                phi_7036_ = _e4300;
                                phi_7037_ = _e4302;
                                phi_7038_ = _e2965;
                                phi_7039_ = _e4304;
                                phi_7040_ = _e4306;
                                phi_7041_ = _e4308;
                                phi_7042_ = _e4310;
                                phi_7043_ = _e4312;
                                phi_7044_ = false;
                                phi_7045_ = _e4314;
                            } else {
                                phi_7035_ = f32();
                                phi_2110_ = f32();
                                phi_2112_ = u32();
                                phi_2114_ = f32();
                                phi_7036_ = type_35();
                                phi_7037_ = u32();
                                phi_7038_ = f32();
                                phi_7039_ = u32();
                                phi_7040_ = false;
                                phi_7041_ = false;
                                phi_7042_ = false;
                                phi_7043_ = false;
                                phi_7044_ = true;
                                phi_7045_ = false;
                            }
                            let _e4316 = phi_7035_;
                            let _e4318 = phi_2110_;
                            let _e4320 = phi_2112_;
                            let _e4322 = phi_2114_;
                            let _e4324 = phi_7036_;
                            let _e4326 = phi_7037_;
                            let _e4328 = phi_7038_;
                            let _e4330 = phi_7039_;
                            let _e4332 = phi_7040_;
                            let _e4334 = phi_7041_;
                            let _e4336 = phi_7042_;
                            let _e4338 = phi_7043_;
                            let _e4340 = phi_7044_;
                            let _e4342 = phi_7045_;
                            local_40 = _e4334;
                            local_41 = _e4336;
                            local_42 = _e4334;
                            local_43 = _e4338;
                            local_44 = _e4334;
                            local_45 = _e4340;
                            local_46 = _e4334;
                            local_47 = _e4342;
                            local_48 = _e4324;
                            local_49 = _e4324;
                            local_50 = _e4326;
                            local_51 = _e4324;
                            local_61 = _e4334;
                            local_52 = _e4330;
                            local_54 = _e4328;
                            local_55 = _e4316;
                            continue;
                            continuing {
                                phi_2106_ = _e1340;
                                phi_2109_ = _e4318;
                                phi_2111_ = _e4320;
                                phi_2113_ = _e4322;
                                break if !(_e4332);
                            }
                        }
                        let _e4345 = local_40;
                        let _e4347 = local_41;
                        let _e4348 = select(_e4347, false, _e4345);
                        let _e4350 = local_42;
                        let _e4352 = local_43;
                        let _e4355 = local_44;
                        let _e4357 = local_45;
                        let _e4360 = local_46;
                        let _e4362 = local_47;
                        if _e4348 {
                            let _e4365 = local_48;
                            if (_e4365.member_1 >= _e381) {
                                phi_7074_ = type_34(type_33(0u, f32()), 0u);
                            } else {
                                let _e4369 = local_49;
                                let _e4373 = local_50;
                                let _e4376 = local_51;
                                phi_7074_ = type_34(type_33(2u, _e4376.member_1), select(_e4373, 0u, (_e4369.member_1 > _e379)));
                            }
                            let _e4383 = phi_7074_;
                            phi_7075_ = _e4383;
                            phi_7076_ = false;
                            phi_7077_ = false;
                            phi_7078_ = false;
                            phi_7079_ = false;
                        } else {
                            phi_7075_ = type_34();
                            phi_7076_ = select(_e4352, false, _e4350);
                            let _e5270 = local_61;
                            phi_7077_ = _e5270;
                            phi_7078_ = select(_e4357, false, _e4355);
                            phi_7079_ = select(_e4362, false, _e4360);
                        }
                        let _e4385 = phi_7075_;
                        let _e4387 = phi_7076_;
                        let _e4389 = phi_7077_;
                        let _e4391 = phi_7078_;
                        let _e4393 = phi_7079_;
                        let _e4395 = local_52;
                        let _e4397 = local_53;
                        let _e4400 = local_54;
                        let _e4402 = local_55;
                        let _e4404 = select(_e4389, true, _e4387);
                        let _e4409 = local_56;
                        let _e4410 = select(_e4409, select(_e4402, _e4400, _e4387), _e4404);
                        let _e4412 = local_57;
                        let _e4413 = select(_e4412, select(_e4397, _e4395, _e4387), _e4404);
                        if select(select(_e4391, false, _e4387), true, _e4404) {
                            local[0u] = 0.01f;
                            local[1u] = 0f;
                            local[2u] = 0.8f;
                            phi_7111_ = type_9(0u, 3u);
                            loop {
                                let _e4424 = phi_7111_;
                                let _e4427 = (_e4424.member < _e4424.member_1);
                                if (bitcast<i32>(select(0u, 1u, _e4427)) != 0i) {
                                    let _e4442 = local[select(type_9().member_1, _e4424.member, _e4427)];
                                    let _e4444 = (_e4410 + (select(0f, _e377, (_e377 >= (0.000000059604645f * 8f))) * _e4442));
                                    let _e4446 = select(_e381, _e4444, (_e4444 < _e381));
                                    let _e4449 = local_5.member[0u];
                                    let _e4455 = local_5.member[1u];
                                    let _e4471 = local_5.member_1[0u];
                                    let _e4477 = local_5.member_1[1u];
                                    let _e4493 = local_5.member_2[0u];
                                    let _e4499 = local_5.member_2[1u];
                                    let _e4513 = function_3(array<f32, 3>((_e4449[0] + ((_e4455[0] - _e4449[0]) * _e4446)), (_e4449[1] + ((_e4455[1] - _e4449[1]) * _e4446)), (_e4449[2] + ((_e4455[2] - _e4449[2]) * _e4446))), array<f32, 3>((_e4471[0] + ((_e4477[0] - _e4471[0]) * _e4446)), (_e4471[1] + ((_e4477[1] - _e4471[1]) * _e4446)), (_e4471[2] + ((_e4477[2] - _e4471[2]) * _e4446))), array<f32, 3>((_e4493[0] + ((_e4499[0] - _e4493[0]) * _e4446)), (_e4493[1] + ((_e4499[1] - _e4493[1]) * _e4446)), (_e4493[2] + ((_e4499[2] - _e4493[2]) * _e4446))), _e224.member);
                                    let _e4524 = (((_e4513[0] * _e4513[0]) + (_e4513[1] * _e4513[1])) + (_e4513[2] * _e4513[2]));
                                    if (_e4524 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_7343_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4524 > 0f));
                                    } else {
                                        phi_7286_ = type_16(0i, 5i);
                                        phi_7289_ = bitcast<f32>(((bitcast<u32>(_e4524) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4532 = phi_7286_;
                                            let _e4534 = phi_7289_;
                                            local_58 = _e4534;
                                            if (_e4532.member < _e4532.member_1) {
                                                let _e4541 = (_e4532.member + 1i);
                                                phi_7287_ = type_16(select(_e4541, type_17().member_1, select(false, true, ((false == (_e4541 > _e4532.member)) != false))), _e4532.member_1);
                                                phi_7330_ = type_17(1u, _e4532.member);
                                            } else {
                                                phi_7287_ = _e4532;
                                                phi_7330_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e4552 = phi_7287_;
                                            let _e4554 = phi_7330_;
                                            let _e4557 = (bitcast<i32>(_e4554.member) != 0i);
                                            if _e4557 {
                                                phi_7290_ = (0.5f * (_e4534 + (_e4524 / _e4534)));
                                            } else {
                                                phi_7290_ = f32();
                                            }
                                            let _e4562 = phi_7290_;
                                            continue;
                                            continuing {
                                                phi_7286_ = _e4552;
                                                phi_7289_ = _e4562;
                                                break if !(_e4557);
                                            }
                                        }
                                        let _e4567 = local_58;
                                        phi_7343_ = (_e4567 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4573 = phi_7343_;
                                    let _e4579 = local_5.member[0u];
                                    let _e4585 = select(_e4579[0], -(_e4579[0]), (_e4579[0] < 0f));
                                    let _e4588 = select(_e4579[1], -(_e4579[1]), (_e4579[1] < 0f));
                                    let _e4590 = select(_e4588, _e4585, (_e4585 > _e4588));
                                    let _e4593 = select(_e4579[2], -(_e4579[2]), (_e4579[2] < 0f));
                                    let _e4595 = select(_e4593, _e4590, (_e4590 > _e4593));
                                    let _e4598 = local_5.member[1u];
                                    let _e4604 = select(_e4598[0], -(_e4598[0]), (_e4598[0] < 0f));
                                    let _e4607 = select(_e4598[1], -(_e4598[1]), (_e4598[1] < 0f));
                                    let _e4609 = select(_e4607, _e4604, (_e4604 > _e4607));
                                    let _e4612 = select(_e4598[2], -(_e4598[2]), (_e4598[2] < 0f));
                                    let _e4614 = select(_e4612, _e4609, (_e4609 > _e4612));
                                    let _e4618 = local_5.member_3;
                                    let _e4622 = local_5.member_1[0u];
                                    let _e4628 = select(_e4622[0], -(_e4622[0]), (_e4622[0] < 0f));
                                    let _e4631 = select(_e4622[1], -(_e4622[1]), (_e4622[1] < 0f));
                                    let _e4633 = select(_e4631, _e4628, (_e4628 > _e4631));
                                    let _e4636 = select(_e4622[2], -(_e4622[2]), (_e4622[2] < 0f));
                                    let _e4638 = select(_e4636, _e4633, (_e4633 > _e4636));
                                    let _e4641 = local_5.member_1[1u];
                                    let _e4647 = select(_e4641[0], -(_e4641[0]), (_e4641[0] < 0f));
                                    let _e4650 = select(_e4641[1], -(_e4641[1]), (_e4641[1] < 0f));
                                    let _e4652 = select(_e4650, _e4647, (_e4647 > _e4650));
                                    let _e4655 = select(_e4641[2], -(_e4641[2]), (_e4641[2] < 0f));
                                    let _e4657 = select(_e4655, _e4652, (_e4652 > _e4655));
                                    let _e4661 = local_5.member_3;
                                    let _e4665 = local_5.member_2[0u];
                                    let _e4671 = select(_e4665[0], -(_e4665[0]), (_e4665[0] < 0f));
                                    let _e4674 = select(_e4665[1], -(_e4665[1]), (_e4665[1] < 0f));
                                    let _e4676 = select(_e4674, _e4671, (_e4671 > _e4674));
                                    let _e4679 = select(_e4665[2], -(_e4665[2]), (_e4665[2] < 0f));
                                    let _e4681 = select(_e4679, _e4676, (_e4676 > _e4679));
                                    let _e4684 = local_5.member_2[1u];
                                    let _e4690 = select(_e4684[0], -(_e4684[0]), (_e4684[0] < 0f));
                                    let _e4693 = select(_e4684[1], -(_e4684[1]), (_e4684[1] < 0f));
                                    let _e4695 = select(_e4693, _e4690, (_e4690 > _e4693));
                                    let _e4698 = select(_e4684[2], -(_e4684[2]), (_e4684[2] < 0f));
                                    let _e4700 = select(_e4698, _e4695, (_e4695 > _e4698));
                                    let _e4704 = local_5.member_3;
                                    let _e4711 = local_5.member_3;
                                    let _e4718 = (((_e4573 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4614, _e4595, (_e4595 > _e4614)) + _e4618) + (select(_e4657, _e4638, (_e4638 > _e4657)) + _e4661)) + (select(_e4700, _e4681, (_e4681 > _e4700)) + _e4704)) * (0.000000059604645f * 16f)) + (_e4711 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e608.member_1);
                                    phi_7614_ = select(true, false, _e4718);
                                    phi_7615_ = _e4718;
                                } else {
                                    phi_7614_ = false;
                                    phi_7615_ = false;
                                }
                                let _e4721 = phi_7614_;
                                let _e4723 = phi_7615_;
                                local_59 = _e4723;
                                continue;
                                continuing {
                                    phi_7111_ = type_9(select(_e4424.member, (_e4424.member + 1u), _e4427), select(_e4424.member_1, _e4424.member_1, _e4427));
                                    break if !(_e4721);
                                }
                            }
                            let _e4726 = local_59;
                            if _e4726 {
                                phi_7627_ = type_34(type_33(1u, _e4410), select(_e4413, 1u, (_e4410 > _e379)));
                                phi_7628_ = false;
                            } else {
                                phi_7627_ = type_34();
                                phi_7628_ = true;
                            }
                            let _e4732 = phi_7627_;
                            let _e4734 = phi_7628_;
                            if _e4734 {
                                phi_7640_ = type_34(type_33(2u, _e4410), select(_e4413, 0u, (_e4410 > _e379)));
                            } else {
                                phi_7640_ = _e4732;
                            }
                            let _e4740 = phi_7640_;
                            phi_7641_ = _e4740;
                            phi_7642_ = false;
                            phi_7643_ = false;
                        } else {
                            phi_7641_ = type_34();
                            phi_7642_ = select(select(_e4393, false, _e4387), false, _e4404);
                            phi_7643_ = select(select(_e4348, false, _e4387), false, _e4404);
                        }
                        let _e4742 = phi_7641_;
                        let _e4744 = phi_7642_;
                        let _e4746 = phi_7643_;
                        if _e4744 {
                            phi_7650_ = type_34(type_33(0u, f32()), 0u);
                            phi_7651_ = true;
                        } else {
                            phi_7650_ = _e4385;
                            phi_7651_ = _e4746;
                        }
                        let _e4750 = phi_7650_;
                        let _e4752 = phi_7651_;
                        phi_7655_ = _e4750;
                        phi_7656_ = _e4742;
                        phi_7657_ = _e4752;
                    } else {
                        phi_7655_ = _e1312;
                        phi_7656_ = type_34();
                        phi_7657_ = true;
                    }
                    let _e4754 = phi_7655_;
                    let _e4756 = phi_7656_;
                    let _e4758 = phi_7657_;
                    if _e4758 {
                        phi_7661_ = _e4754;
                    } else {
                        phi_7661_ = _e4756;
                    }
                    let _e4760 = phi_7661_;
                    switch bitcast<i32>(_e4760.member.member) {
                        case 0: {
                            phi_7679_ = type_31(0u, _e4760.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e4771 = function_(_e4760.member.member_1);
                            phi_7679_ = type_31(0u, _e4760.member_1, _e4771, true);
                            break;
                        }
                        case 2: {
                            let _e4767 = function_(_e4760.member.member_1);
                            phi_7679_ = type_31(1u, _e4760.member_1, _e4767, true);
                            break;
                        }
                        default: {
                            phi_7679_ = type_31();
                            break;
                        }
                    }
                    let _e4775 = phi_7679_;
                    let _e4779 = params.member.member.member_12;
                    let _e4780 = bitcast<u32>(_e4779);
                    if (_e4775.member_2[0] == select((_e4780 << bitcast<u32>(29i)), 0u, ((_e4780 & 2147483647u) < 8388608u))) {
                        let _e4790 = params.member.member.member_12;
                        let _e4791 = bitcast<u32>(_e4790);
                        let _e4792 = (_e4791 & 2147483647u);
                        phi_7719_ = (_e4775.member_2[1] == select(((_e4791 ^ _e4792) | ((_e4792 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4792 < 8388608u)));
                    } else {
                        phi_7719_ = false;
                    }
                    let _e4802 = phi_7719_;
                    let _e4804 = params.member.member.member_1;
                    if ((_e4804 & 128u) != 0u) {
                        phi_7735_ = true;
                    } else {
                        let _e4808 = params.member.member.member_1;
                        phi_7735_ = select(false, _e4802, ((_e4808 & 64u) != 0u));
                    }
                    let _e4813 = phi_7735_;
                    phi_7754_ = type_31(select(1u, _e4775.member, select(true, select(true, false, _e4813), _e4775.member_3)), _e4775.member_1, _e4775.member_2, _e4775.member_3);
                }
                let _e4824 = phi_7754_;
                phi_7755_ = _e4824;
                phi_7756_ = type_9(_e190, _e189);
            } else {
                phi_7755_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_7756_ = type_9(0u, 0u);
            }
            let _e4826 = phi_7755_;
            let _e4828 = phi_7756_;
            let _e4832 = (_e4826.member != 0u);
            let _e4835 = select(false, !(_e4832), _e4826.member_3);
            if _e4835 {
                let _e4839 = (_e4826.member_2[1] >> bitcast<u32>(20i));
                if (_e4839 <= 896u) {
                    phi_7786_ = 0u;
                } else {
                    phi_7786_ = ((((_e4839 - 896u) << bitcast<u32>(23i)) | ((_e4826.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4826.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e4854 = phi_7786_;
                let _e4856 = atomicMin((&earliest.member[0u]), _e4854);
            }
            let _e4859 = params.member.member.member_1;
            if ((_e4859 & 16u) != 0u) {
                if (_e103 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4835 {
                    let _e4865 = atomicAdd((&counters[0u]), 1u);
                    phi_7808_ = _e4865;
                } else {
                    phi_7808_ = 0u;
                }
                let _e4867 = phi_7808_;
                workgroupBarrier();
                if (_e103 == 0u) {
                    let _e4870 = atomicLoad((&counters[0u]));
                    if (_e4870 > 0u) {
                        let _e4873 = atomicAdd((&contacts.member[0u]), _e4870);
                        atomicStore((&counters[1u]), _e4873);
                    }
                }
                workgroupBarrier();
                let _e4876 = atomicLoad((&counters[1u]));
                let _e4877 = (_e4876 + _e4867);
                if _e4835 {
                    let _e4880 = params.member.member_1.member_3;
                    let _e4882 = params.member.member_2.member;
                    if (_e4877 < _e4880) {
                        let _e4884 = (7u * _e4877);
                        atomicStore((&contacts.member[(4u + _e4884)]), _e4882);
                        atomicStore((&contacts.member[(_e4884 + 5u)]), _e4826.member);
                        atomicStore((&contacts.member[(_e4884 + 6u)]), _e4828.member);
                        atomicStore((&contacts.member[(_e4884 + 7u)]), _e4828.member_1);
                        atomicStore((&contacts.member[(_e4884 + 8u)]), _e4826.member_2[0]);
                        atomicStore((&contacts.member[(_e4884 + 9u)]), _e4826.member_2[1]);
                        atomicStore((&contacts.member[(_e4884 + 10u)]), _e4826.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e103 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4832 {
                let _e4908 = atomicAdd((&counters[0u]), 1u);
                phi_7874_ = _e4908;
            } else {
                phi_7874_ = 0u;
            }
            let _e4910 = phi_7874_;
            workgroupBarrier();
            if (_e103 == 0u) {
                let _e4913 = atomicLoad((&counters[0u]));
                if (_e4913 > 0u) {
                    let _e4916 = atomicAdd((&undecided.member[0u]), _e4913);
                    atomicStore((&counters[1u]), _e4916);
                }
            }
            workgroupBarrier();
            let _e4919 = atomicLoad((&counters[1u]));
            let _e4920 = (_e4919 + _e4910);
            if _e4832 {
                let _e4922 = params.member.member_2.member_1;
                if (_e4920 < _e4922) {
                    let _e4924 = (2u * _e4920);
                    atomicStore((&undecided.member[(4u + _e4924)]), _e4828.member);
                    atomicStore((&undecided.member[(_e4924 + 5u)]), _e4828.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_277_ = type_9(select(_e157.member, (_e157.member + 1u), _e160), select(_e157.member_1, _e157.member_1, _e160));
            break if !(_e173);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
