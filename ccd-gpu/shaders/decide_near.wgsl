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
    member: type_27,
    member_1: f32,
}

struct type_32 {
    member: u32,
    member_1: f32,
}

struct type_33 {
    member: type_32,
    member_1: u32,
}

struct type_34 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
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
    var phi_8380_: array<array<f32, 3>, 4>;

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
        phi_8380_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8380_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8380_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8008_: bool;
    var phi_8041_: array<f32, 3>;
    var phi_8042_: bool;
    var phi_8043_: array<f32, 3>;
    var phi_8044_: bool;
    var phi_8049_: array<f32, 3>;

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
        phi_8008_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8008_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8008_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8041_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8042_ = false;
        } else {
            phi_8041_ = array<f32, 3>();
            phi_8042_ = true;
        }
        let _e129 = phi_8041_;
        let _e131 = phi_8042_;
        phi_8043_ = _e129;
        phi_8044_ = _e131;
    } else {
        phi_8043_ = array<f32, 3>();
        phi_8044_ = true;
    }
    let _e133 = phi_8043_;
    let _e135 = phi_8044_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8049_ = _e136;
    } else {
        phi_8049_ = _e133;
    }
    let _e138 = phi_8049_;
    return _e138;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_29;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_27;
    var phi_224_: u32;
    var phi_270_: u32;
    var phi_273_: type_9;
    var phi_430_: type_21;
    var phi_565_: type_27;
    var phi_594_: bool;
    var phi_842_: bool;
    var phi_936_: type_31;
    var phi_937_: bool;
    var phi_938_: type_31;
    var phi_939_: bool;
    var phi_940_: type_31;
    var phi_941_: bool;
    var phi_946_: type_31;
    var phi_1116_: type_16;
    var phi_1119_: f32;
    var phi_1117_: type_16;
    var phi_1160_: type_17;
    var phi_1120_: f32;
    var local_6: f32;
    var phi_1173_: f32;
    var phi_2082_: type_33;
    var phi_2083_: bool;
    var phi_2084_: type_33;
    var phi_2085_: bool;
    var phi_2091_: type_16;
    var phi_2094_: f32;
    var phi_2096_: u32;
    var phi_2098_: f32;
    var phi_2092_: type_16;
    var phi_2139_: type_17;
    var phi_2576_: type_9;
    var phi_2579_: f32;
    var phi_2581_: f32;
    var phi_2583_: f32;
    var phi_2585_: f32;
    var phi_2587_: bool;
    var phi_2589_: u32;
    var phi_2740_: array<f32, 3>;
    var phi_2806_: type_16;
    var phi_2809_: f32;
    var phi_2807_: type_16;
    var phi_2850_: type_17;
    var phi_2810_: f32;
    var local_7: f32;
    var phi_2863_: f32;
    var phi_2986_: type_30;
    var phi_2987_: bool;
    var phi_2988_: type_30;
    var phi_2989_: bool;
    var phi_2997_: type_30;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3474_: bool;
    var phi_3475_: bool;
    var phi_3476_: bool;
    var phi_3477_: bool;
    var phi_3478_: bool;
    var phi_3479_: bool;
    var phi_3487_: bool;
    var phi_3594_: f32;
    var phi_3595_: bool;
    var phi_3596_: f32;
    var phi_3597_: bool;
    var phi_3598_: f32;
    var phi_3599_: bool;
    var phi_3600_: bool;
    var phi_3662_: f32;
    var phi_3663_: bool;
    var phi_3664_: f32;
    var phi_3665_: bool;
    var phi_3666_: f32;
    var phi_3667_: bool;
    var phi_3668_: bool;
    var phi_3735_: f32;
    var phi_3736_: bool;
    var phi_3737_: f32;
    var phi_3738_: bool;
    var phi_3739_: f32;
    var phi_3740_: bool;
    var phi_3741_: bool;
    var phi_3803_: f32;
    var phi_3804_: bool;
    var phi_3805_: f32;
    var phi_3806_: bool;
    var phi_3807_: f32;
    var phi_3808_: bool;
    var phi_3809_: bool;
    var phi_3983_: type_16;
    var phi_3986_: f32;
    var phi_3984_: type_16;
    var phi_4027_: type_17;
    var phi_3987_: f32;
    var local_8: f32;
    var phi_4040_: f32;
    var phi_4311_: bool;
    var phi_4312_: bool;
    var phi_4338_: f32;
    var phi_4339_: f32;
    var phi_4340_: bool;
    var phi_4341_: bool;
    var phi_4342_: f32;
    var phi_4343_: f32;
    var phi_4344_: f32;
    var phi_4345_: f32;
    var phi_4346_: bool;
    var phi_4347_: bool;
    var phi_4348_: bool;
    var phi_4349_: bool;
    var phi_4350_: f32;
    var phi_4351_: f32;
    var phi_4352_: f32;
    var phi_4353_: f32;
    var phi_4354_: bool;
    var phi_4355_: bool;
    var phi_4356_: bool;
    var phi_4357_: bool;
    var phi_4358_: bool;
    var phi_4359_: f32;
    var phi_4360_: f32;
    var phi_4361_: f32;
    var phi_4362_: f32;
    var phi_4363_: bool;
    var phi_4364_: bool;
    var phi_4365_: bool;
    var phi_4366_: bool;
    var phi_4367_: bool;
    var phi_4700_: f32;
    var phi_4702_: u32;
    var phi_4703_: f32;
    var phi_4704_: bool;
    var phi_4705_: bool;
    var phi_4706_: bool;
    var phi_4707_: u32;
    var phi_4708_: f32;
    var phi_4709_: f32;
    var phi_4710_: f32;
    var phi_4711_: f32;
    var phi_4712_: bool;
    var phi_4713_: u32;
    var phi_4714_: bool;
    var phi_4715_: bool;
    var phi_4716_: bool;
    var phi_4717_: bool;
    var phi_4718_: bool;
    var phi_4719_: bool;
    var phi_4747_: f32;
    var phi_4748_: f32;
    var phi_4749_: f32;
    var phi_4750_: f32;
    var phi_4751_: bool;
    var phi_4752_: u32;
    var phi_4753_: bool;
    var phi_4754_: bool;
    var phi_4755_: bool;
    var phi_4756_: bool;
    var phi_4757_: bool;
    var phi_4758_: bool;
    var phi_2580_: f32;
    var phi_2582_: f32;
    var phi_2584_: f32;
    var phi_2586_: f32;
    var phi_2588_: bool;
    var phi_2590_: u32;
    var phi_4759_: f32;
    var phi_4760_: f32;
    var phi_4761_: bool;
    var phi_4762_: bool;
    var phi_4763_: bool;
    var phi_4764_: bool;
    var phi_4765_: bool;
    var phi_4766_: bool;
    var phi_4767_: bool;
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
    var phi_4834_: f32;
    var phi_4835_: bool;
    var phi_5455_: type_16;
    var phi_5458_: f32;
    var phi_5456_: type_16;
    var phi_5499_: type_17;
    var phi_5459_: f32;
    var local_24: f32;
    var phi_5512_: f32;
    var phi_5747_: type_16;
    var phi_5750_: f32;
    var phi_5748_: type_16;
    var phi_5791_: type_17;
    var phi_5751_: f32;
    var local_25: f32;
    var phi_5804_: f32;
    var phi_5836_: type_16;
    var phi_5839_: f32;
    var phi_5837_: type_16;
    var phi_5880_: type_17;
    var phi_5840_: f32;
    var local_26: f32;
    var phi_5893_: f32;
    var phi_6201_: type_9;
    var phi_6204_: f32;
    var phi_6205_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_6303_: type_16;
    var phi_6306_: f32;
    var phi_6304_: type_16;
    var phi_6347_: type_17;
    var phi_6307_: f32;
    var local_29: f32;
    var phi_6360_: f32;
    var phi_6365_: type_9;
    var phi_6368_: f32;
    var phi_6370_: bool;
    var phi_6372_: bool;
    var phi_6602_: f32;
    var phi_6603_: f32;
    var phi_6369_: f32;
    var phi_6371_: bool;
    var phi_6373_: bool;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_6618_: type_34;
    var phi_6619_: bool;
    var local_36: bool;
    var phi_6640_: type_9;
    var phi_6643_: f32;
    var phi_6645_: f32;
    var phi_6752_: f32;
    var phi_6753_: f32;
    var phi_6754_: f32;
    var phi_6755_: f32;
    var phi_6644_: f32;
    var phi_6646_: f32;
    var local_37: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6916_: bool;
    var phi_6917_: bool;
    var phi_6918_: bool;
    var phi_6919_: bool;
    var phi_6920_: bool;
    var phi_6921_: bool;
    var phi_6930_: bool;
    var phi_6931_: bool;
    var phi_6938_: type_34;
    var phi_6939_: type_34;
    var phi_6940_: bool;
    var phi_6941_: type_34;
    var phi_6942_: type_34;
    var phi_6943_: bool;
    var phi_6948_: type_34;
    var phi_6949_: type_34;
    var phi_6950_: bool;
    var phi_6954_: type_34;
    var phi_6955_: type_34;
    var phi_6956_: bool;
    var phi_6957_: bool;
    var phi_6958_: type_34;
    var phi_6959_: type_34;
    var phi_6960_: bool;
    var phi_6961_: bool;
    var phi_6995_: f32;
    var phi_6996_: f32;
    var phi_6997_: bool;
    var phi_6998_: bool;
    var phi_6999_: bool;
    var phi_7000_: f32;
    var phi_7001_: u32;
    var phi_7002_: f32;
    var phi_7003_: type_34;
    var phi_7004_: u32;
    var phi_7005_: u32;
    var phi_7006_: bool;
    var phi_7007_: bool;
    var phi_7008_: bool;
    var phi_7009_: f32;
    var phi_7010_: u32;
    var phi_7011_: f32;
    var phi_7012_: type_34;
    var phi_7013_: u32;
    var phi_7014_: u32;
    var phi_7015_: bool;
    var phi_7016_: bool;
    var phi_7017_: bool;
    var phi_7018_: bool;
    var phi_7019_: bool;
    var phi_7020_: f32;
    var phi_2095_: f32;
    var phi_2097_: u32;
    var phi_2099_: f32;
    var phi_7021_: type_34;
    var phi_7022_: u32;
    var phi_7023_: f32;
    var phi_7024_: u32;
    var phi_7025_: bool;
    var phi_7026_: bool;
    var phi_7027_: bool;
    var phi_7028_: bool;
    var phi_7029_: bool;
    var phi_7030_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_34;
    var local_49: type_34;
    var local_50: u32;
    var local_51: type_34;
    var phi_7059_: type_33;
    var phi_7060_: type_33;
    var phi_7061_: bool;
    var phi_7062_: bool;
    var phi_7063_: bool;
    var phi_7064_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: u32;
    var phi_7096_: type_9;
    var phi_7271_: type_16;
    var phi_7274_: f32;
    var phi_7272_: type_16;
    var phi_7315_: type_17;
    var phi_7275_: f32;
    var local_58: f32;
    var phi_7328_: f32;
    var phi_7599_: bool;
    var phi_7600_: bool;
    var local_59: bool;
    var phi_7612_: type_33;
    var phi_7613_: bool;
    var phi_7625_: type_33;
    var phi_7626_: type_33;
    var phi_7627_: bool;
    var phi_7628_: bool;
    var phi_7635_: type_33;
    var phi_7636_: bool;
    var phi_7640_: type_33;
    var phi_7641_: type_33;
    var phi_7642_: bool;
    var phi_7646_: type_33;
    var phi_7664_: type_35;
    var phi_7704_: bool;
    var phi_7720_: bool;
    var phi_7739_: type_35;
    var phi_7740_: type_9;
    var phi_7770_: u32;
    var phi_7792_: u32;
    var phi_7858_: u32;
    var local_60: bool;
    var local_61: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e113 = ((_e99.y * _e100.x) + _e99.x);
    let _e116 = (_e100.x * _e100.y);
    let _e119 = params.member.member_1.member_2;
    let _e121 = input.member[0u];
    let _e123 = select(_e121, _e119, (_e119 < _e121));
    let _e125 = params.member.member_1.member_1;
    if (_e123 > _e125) {
        let _e128 = params.member.member_1.member_1;
        phi_224_ = (_e123 - _e128);
    } else {
        phi_224_ = 0u;
    }
    let _e131 = phi_224_;
    let _e133 = params.member.member_1.member;
    let _e135 = select(_e131, _e133, (_e133 < _e131));
    let _e137 = (_e135 / 64u);
    let _e141 = select(_e137, (_e137 + 1u), ((_e135 % 64u) > 0u));
    if (_e141 > _e113) {
        let _e143 = (_e141 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e145 = (_e143 / _e116);
        if (_e116 == 0u) {
            return;
        }
        phi_270_ = select(_e145, (_e145 + 1u), ((_e143 % _e116) > 0u));
    } else {
        phi_270_ = 0u;
    }
    let _e152 = phi_270_;
    phi_273_ = type_9(0u, _e152);
    loop {
        let _e155 = phi_273_;
        let _e158 = (_e155.member < _e155.member_1);
        let _e171 = (bitcast<i32>(select(0u, 1u, _e158)) != 0i);
        if _e171 {
            let _e175 = (((_e113 + (select(type_9().member_1, _e155.member, _e158) * _e116)) * 64u) + _e101);
            if (_e175 < _e135) {
                let _e179 = params.member.member_1.member_1;
                let _e181 = (2u * (_e179 + _e175));
                let _e184 = input.member[(4u + _e181)];
                let _e187 = input.member[(_e181 + 5u)];
                let _e190 = params.member.member_2.member;
                if (_e190 == 0u) {
                    let _e207 = (3u * _e187);
                    let _e209 = elements.member[_e207];
                    let _e212 = elements.member[(_e207 + 1u)];
                    let _e215 = elements.member[(_e207 + 2u)];
                    phi_430_ = type_21(0u, array<u32, 4>(_e184, _e209, _e212, _e215));
                } else {
                    let _e193 = (2u * _e184);
                    let _e194 = (2u * _e187);
                    let _e196 = elements.member[_e193];
                    let _e198 = elements.member[_e194];
                    let _e201 = elements.member[(_e193 + 1u)];
                    let _e204 = elements.member[(_e194 + 1u)];
                    phi_430_ = type_21(1u, array<u32, 4>(_e196, _e201, _e198, _e204));
                }
                let _e219 = phi_430_;
                let _e224 = paths.member[_e219.member_1[0]];
                let _e239 = paths.member[_e219.member_1[1]];
                let _e254 = paths.member[_e219.member_1[2]];
                let _e269 = paths.member[_e219.member_1[3]];
                let _e283 = params.member.member.member_4;
                if (_e219.member != 0u) {
                    phi_565_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e254.member.x - _e224.member.x), (_e254.member.y - _e224.member.y), (_e254.member.z - _e224.member.z)), array<f32, 3>((_e254.member_1.x - _e224.member_1.x), (_e254.member_1.y - _e224.member_1.y), (_e254.member_1.z - _e224.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e239.member.x - _e224.member.x), (_e239.member.y - _e224.member.y), (_e239.member.z - _e224.member.z)), array<f32, 3>((_e239.member_1.x - _e224.member_1.x), (_e239.member_1.y - _e224.member_1.y), (_e239.member_1.z - _e224.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e254.member.x - _e269.member.x), (_e254.member.y - _e269.member.y), (_e254.member.z - _e269.member.z)), array<f32, 3>((_e254.member_1.x - _e269.member_1.x), (_e254.member_1.y - _e269.member_1.y), (_e254.member_1.z - _e269.member_1.z))), (_e283 + _e283));
                } else {
                    phi_565_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e224.member.x - _e239.member.x), (_e224.member.y - _e239.member.y), (_e224.member.z - _e239.member.z)), array<f32, 3>((_e224.member_1.x - _e239.member_1.x), (_e224.member_1.y - _e239.member_1.y), (_e224.member_1.z - _e239.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e254.member.x - _e239.member.x), (_e254.member.y - _e239.member.y), (_e254.member.z - _e239.member.z)), array<f32, 3>((_e254.member_1.x - _e239.member_1.x), (_e254.member_1.y - _e239.member_1.y), (_e254.member_1.z - _e239.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e269.member.x - _e239.member.x), (_e269.member.y - _e239.member.y), (_e269.member.z - _e239.member.z)), array<f32, 3>((_e269.member_1.x - _e239.member_1.x), (_e269.member_1.y - _e239.member_1.y), (_e269.member_1.z - _e239.member_1.z))), (_e283 + _e283));
                }
                let _e344 = phi_565_;
                let _e346 = params.member.member.member_12;
                let _e347 = bitcast<u32>(_e346);
                let _e348 = (_e347 & 2147483647u);
                let _e349 = (_e348 < 8388608u);
                let _e361 = params.member.member.member_15[0u];
                if (select((_e347 << bitcast<u32>(29i)), 0u, _e349) == _e361) {
                    let _e365 = params.member.member.member_15[1u];
                    phi_594_ = (select(((_e347 ^ _e348) | ((_e348 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e349) == _e365);
                } else {
                    phi_594_ = false;
                }
                let _e368 = phi_594_;
                let _e370 = params.member.member.member_5;
                let _e372 = params.member.member.member_11;
                let _e374 = params.member.member.member_12;
                let _e376 = params.member.member.member_13;
                let _e378 = params.member.member.member_1;
                let _e387 = select(_e344.member[0][0], -(_e344.member[0][0]), (_e344.member[0][0] < 0f));
                let _e391 = select(_e344.member[0][1], -(_e344.member[0][1]), (_e344.member[0][1] < 0f));
                let _e393 = select(_e391, _e387, (_e387 > _e391));
                let _e397 = select(_e344.member[0][2], -(_e344.member[0][2]), (_e344.member[0][2] < 0f));
                let _e399 = select(_e397, _e393, (_e393 > _e397));
                let _e405 = select(_e344.member[1][0], -(_e344.member[1][0]), (_e344.member[1][0] < 0f));
                let _e409 = select(_e344.member[1][1], -(_e344.member[1][1]), (_e344.member[1][1] < 0f));
                let _e411 = select(_e409, _e405, (_e405 > _e409));
                let _e415 = select(_e344.member[1][2], -(_e344.member[1][2]), (_e344.member[1][2] < 0f));
                let _e417 = select(_e415, _e411, (_e411 > _e415));
                let _e421 = (select(_e417, _e399, (_e399 > _e417)) + _e344.member_3);
                let _e427 = select(_e344.member_1[0][0], -(_e344.member_1[0][0]), (_e344.member_1[0][0] < 0f));
                let _e431 = select(_e344.member_1[0][1], -(_e344.member_1[0][1]), (_e344.member_1[0][1] < 0f));
                let _e433 = select(_e431, _e427, (_e427 > _e431));
                let _e437 = select(_e344.member_1[0][2], -(_e344.member_1[0][2]), (_e344.member_1[0][2] < 0f));
                let _e439 = select(_e437, _e433, (_e433 > _e437));
                let _e445 = select(_e344.member_1[1][0], -(_e344.member_1[1][0]), (_e344.member_1[1][0] < 0f));
                let _e449 = select(_e344.member_1[1][1], -(_e344.member_1[1][1]), (_e344.member_1[1][1] < 0f));
                let _e451 = select(_e449, _e445, (_e445 > _e449));
                let _e455 = select(_e344.member_1[1][2], -(_e344.member_1[1][2]), (_e344.member_1[1][2] < 0f));
                let _e457 = select(_e455, _e451, (_e451 > _e455));
                let _e461 = (select(_e457, _e439, (_e439 > _e457)) + _e344.member_3);
                let _e467 = select(_e344.member_2[0][0], -(_e344.member_2[0][0]), (_e344.member_2[0][0] < 0f));
                let _e471 = select(_e344.member_2[0][1], -(_e344.member_2[0][1]), (_e344.member_2[0][1] < 0f));
                let _e473 = select(_e471, _e467, (_e467 > _e471));
                let _e477 = select(_e344.member_2[0][2], -(_e344.member_2[0][2]), (_e344.member_2[0][2] < 0f));
                let _e479 = select(_e477, _e473, (_e473 > _e477));
                let _e485 = select(_e344.member_2[1][0], -(_e344.member_2[1][0]), (_e344.member_2[1][0] < 0f));
                let _e489 = select(_e344.member_2[1][1], -(_e344.member_2[1][1]), (_e344.member_2[1][1] < 0f));
                let _e491 = select(_e489, _e485, (_e485 > _e489));
                let _e495 = select(_e344.member_2[1][2], -(_e344.member_2[1][2]), (_e344.member_2[1][2] < 0f));
                let _e497 = select(_e495, _e491, (_e491 > _e495));
                let _e501 = (select(_e497, _e479, (_e479 > _e497)) + _e344.member_3);
                let _e503 = select(_e461, _e421, (_e421 > _e461));
                let _e505 = select(_e501, _e503, (_e503 > _e501));
                if (_e505 <= 65536f) {
                    phi_842_ = (_e505 >= (1f / 65536f));
                } else {
                    phi_842_ = false;
                }
                let _e510 = phi_842_;
                if _e510 {
                    phi_940_ = type_31();
                    phi_941_ = true;
                } else {
                    if (_e505 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e505) & 2139095040u) != 2139095040u) {
                            let _e517 = (2130706432u - (bitcast<u32>(_e505) & 2139095040u));
                            let _e520 = bitcast<f32>(select(8388608u, _e517, (_e517 > 8388608u)));
                            let _e521 = (_e370 * _e520);
                            phi_936_ = type_31(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e344.member[0][0] * _e520), (_e344.member[0][1] * _e520), (_e344.member[0][2] * _e520)), array<f32, 3>((_e344.member[1][0] * _e520), (_e344.member[1][1] * _e520), (_e344.member[1][2] * _e520))), array<array<f32, 3>, 2>(array<f32, 3>((_e344.member_1[0][0] * _e520), (_e344.member_1[0][1] * _e520), (_e344.member_1[0][2] * _e520)), array<f32, 3>((_e344.member_1[1][0] * _e520), (_e344.member_1[1][1] * _e520), (_e344.member_1[1][2] * _e520))), array<array<f32, 3>, 2>(array<f32, 3>((_e344.member_2[0][0] * _e520), (_e344.member_2[0][1] * _e520), (_e344.member_2[0][2] * _e520)), array<f32, 3>((_e344.member_2[1][0] * _e520), (_e344.member_2[1][1] * _e520), (_e344.member_2[1][2] * _e520))), ((_e344.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e520)), select(_e521, select(0.000000000000000000000000000000000000011754944f, _e521, (_e521 > 0.000000000000000000000000000000000000011754944f)), (_e370 > 0f)));
                            phi_937_ = false;
                        } else {
                            phi_936_ = type_31();
                            phi_937_ = true;
                        }
                        let _e590 = phi_936_;
                        let _e592 = phi_937_;
                        phi_938_ = _e590;
                        phi_939_ = _e592;
                    } else {
                        phi_938_ = type_31();
                        phi_939_ = true;
                    }
                    let _e594 = phi_938_;
                    let _e596 = phi_939_;
                    phi_940_ = _e594;
                    phi_941_ = _e596;
                }
                let _e598 = phi_940_;
                let _e600 = phi_941_;
                if _e600 {
                    phi_946_ = type_31(_e344, _e370);
                } else {
                    phi_946_ = _e598;
                }
                let _e603 = phi_946_;
                local_5 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e603.member.member[0][0], _e603.member.member[0][1], _e603.member.member[0][2]), array<f32, 3>(_e603.member.member[1][0], _e603.member.member[1][1], _e603.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e603.member.member_1[0][0], _e603.member.member_1[0][1], _e603.member.member_1[0][2]), array<f32, 3>(_e603.member.member_1[1][0], _e603.member.member_1[1][1], _e603.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e603.member.member_2[0][0], _e603.member.member_2[0][1], _e603.member.member_2[0][2]), array<f32, 3>(_e603.member.member_2[1][0], _e603.member.member_2[1][1], _e603.member.member_2[1][2])), _e603.member.member_3);
                let _e646 = local_5.member[0u];
                let _e652 = local_5.member[1u];
                let _e668 = local_5.member_1[0u];
                let _e674 = local_5.member_1[1u];
                let _e690 = local_5.member_2[0u];
                let _e696 = local_5.member_2[1u];
                let _e710 = function_3(array<f32, 3>((_e646[0] + ((_e652[0] - _e646[0]) * _e374)), (_e646[1] + ((_e652[1] - _e646[1]) * _e374)), (_e646[2] + ((_e652[2] - _e646[2]) * _e374))), array<f32, 3>((_e668[0] + ((_e674[0] - _e668[0]) * _e374)), (_e668[1] + ((_e674[1] - _e668[1]) * _e374)), (_e668[2] + ((_e674[2] - _e668[2]) * _e374))), array<f32, 3>((_e690[0] + ((_e696[0] - _e690[0]) * _e374)), (_e690[1] + ((_e696[1] - _e690[1]) * _e374)), (_e690[2] + ((_e696[2] - _e690[2]) * _e374))), _e219.member);
                let _e721 = (((_e710[0] * _e710[0]) + (_e710[1] * _e710[1])) + (_e710[2] * _e710[2]));
                if (_e721 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1173_ = select(0f, (0.000000000000000000106433627f * 2f), (_e721 > 0f));
                } else {
                    phi_1116_ = type_16(0i, 5i);
                    phi_1119_ = bitcast<f32>(((bitcast<u32>(_e721) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e729 = phi_1116_;
                        let _e731 = phi_1119_;
                        local_6 = _e731;
                        if (_e729.member < _e729.member_1) {
                            let _e738 = (_e729.member + 1i);
                            phi_1117_ = type_16(select(_e738, type_17().member_1, select(false, true, ((false == (_e738 > _e729.member)) != false))), _e729.member_1);
                            phi_1160_ = type_17(1u, _e729.member);
                        } else {
                            phi_1117_ = _e729;
                            phi_1160_ = type_17(0u, type_17().member_1);
                        }
                        let _e749 = phi_1117_;
                        let _e751 = phi_1160_;
                        let _e754 = (bitcast<i32>(_e751.member) != 0i);
                        if _e754 {
                            phi_1120_ = (0.5f * (_e731 + (_e721 / _e731)));
                        } else {
                            phi_1120_ = f32();
                        }
                        let _e759 = phi_1120_;
                        continue;
                        continuing {
                            phi_1116_ = _e749;
                            phi_1119_ = _e759;
                            break if !(_e754);
                        }
                    }
                    let _e764 = local_6;
                    phi_1173_ = (_e764 * (1f + (8f * 0.000000059604645f)));
                }
                let _e770 = phi_1173_;
                let _e776 = local_5.member[0u];
                let _e782 = select(_e776[0], -(_e776[0]), (_e776[0] < 0f));
                let _e785 = select(_e776[1], -(_e776[1]), (_e776[1] < 0f));
                let _e787 = select(_e785, _e782, (_e782 > _e785));
                let _e790 = select(_e776[2], -(_e776[2]), (_e776[2] < 0f));
                let _e792 = select(_e790, _e787, (_e787 > _e790));
                let _e795 = local_5.member[1u];
                let _e801 = select(_e795[0], -(_e795[0]), (_e795[0] < 0f));
                let _e804 = select(_e795[1], -(_e795[1]), (_e795[1] < 0f));
                let _e806 = select(_e804, _e801, (_e801 > _e804));
                let _e809 = select(_e795[2], -(_e795[2]), (_e795[2] < 0f));
                let _e811 = select(_e809, _e806, (_e806 > _e809));
                let _e815 = local_5.member_3;
                let _e819 = local_5.member_1[0u];
                let _e825 = select(_e819[0], -(_e819[0]), (_e819[0] < 0f));
                let _e828 = select(_e819[1], -(_e819[1]), (_e819[1] < 0f));
                let _e830 = select(_e828, _e825, (_e825 > _e828));
                let _e833 = select(_e819[2], -(_e819[2]), (_e819[2] < 0f));
                let _e835 = select(_e833, _e830, (_e830 > _e833));
                let _e838 = local_5.member_1[1u];
                let _e844 = select(_e838[0], -(_e838[0]), (_e838[0] < 0f));
                let _e847 = select(_e838[1], -(_e838[1]), (_e838[1] < 0f));
                let _e849 = select(_e847, _e844, (_e844 > _e847));
                let _e852 = select(_e838[2], -(_e838[2]), (_e838[2] < 0f));
                let _e854 = select(_e852, _e849, (_e849 > _e852));
                let _e858 = local_5.member_3;
                let _e862 = local_5.member_2[0u];
                let _e868 = select(_e862[0], -(_e862[0]), (_e862[0] < 0f));
                let _e871 = select(_e862[1], -(_e862[1]), (_e862[1] < 0f));
                let _e873 = select(_e871, _e868, (_e868 > _e871));
                let _e876 = select(_e862[2], -(_e862[2]), (_e862[2] < 0f));
                let _e878 = select(_e876, _e873, (_e873 > _e876));
                let _e881 = local_5.member_2[1u];
                let _e887 = select(_e881[0], -(_e881[0]), (_e881[0] < 0f));
                let _e890 = select(_e881[1], -(_e881[1]), (_e881[1] < 0f));
                let _e892 = select(_e890, _e887, (_e887 > _e890));
                let _e895 = select(_e881[2], -(_e881[2]), (_e881[2] < 0f));
                let _e897 = select(_e895, _e892, (_e892 > _e895));
                let _e901 = local_5.member_3;
                let _e908 = local_5.member_3;
                let _e915 = (((_e770 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e811, _e792, (_e792 > _e811)) + _e815) + (select(_e854, _e835, (_e835 > _e854)) + _e858)) + (select(_e897, _e878, (_e878 > _e897)) + _e901)) * (0.000000059604645f * 16f)) + (_e908 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e603.member_1);
                if _e915 {
                    phi_2084_ = type_33();
                    phi_2085_ = true;
                } else {
                    let _e918 = local_5.member_1[0u];
                    let _e924 = local_5.member_2[0u];
                    let _e930 = ((_e918[1] * _e924[2]) - (_e918[2] * _e924[1]));
                    let _e933 = ((_e918[2] * _e924[0]) - (_e918[0] * _e924[2]));
                    let _e936 = ((_e918[0] * _e924[1]) - (_e918[1] * _e924[0]));
                    let _e939 = local_5.member_1[1u];
                    let _e945 = local_5.member_2[1u];
                    let _e951 = ((_e939[1] * _e945[2]) - (_e939[2] * _e945[1]));
                    let _e954 = ((_e939[2] * _e945[0]) - (_e939[0] * _e945[2]));
                    let _e957 = ((_e939[0] * _e945[1]) - (_e939[1] * _e945[0]));
                    let _e960 = local_5.member_1[0u];
                    let _e966 = local_5.member_2[1u];
                    let _e981 = local_5.member_1[1u];
                    let _e987 = local_5.member_2[0u];
                    let _e1000 = (((_e960[1] * _e966[2]) - (_e960[2] * _e966[1])) + ((_e981[1] * _e987[2]) - (_e981[2] * _e987[1])));
                    let _e1001 = (((_e960[2] * _e966[0]) - (_e960[0] * _e966[2])) + ((_e981[2] * _e987[0]) - (_e981[0] * _e987[2])));
                    let _e1002 = (((_e960[0] * _e966[1]) - (_e960[1] * _e966[0])) + ((_e981[0] * _e987[1]) - (_e981[1] * _e987[0])));
                    let _e1005 = local_5.member[0u];
                    let _e1016 = local_5.member[1u];
                    let _e1027 = local_5.member[0u];
                    let _e1036 = ((((_e1016[0] * _e930) + (_e1016[1] * _e933)) + (_e1016[2] * _e936)) + (((_e1027[0] * _e1000) + (_e1027[1] * _e1001)) + (_e1027[2] * _e1002)));
                    let _e1039 = local_5.member[0u];
                    let _e1050 = local_5.member[1u];
                    let _e1059 = ((((_e1039[0] * _e951) + (_e1039[1] * _e954)) + (_e1039[2] * _e957)) + (((_e1050[0] * _e1000) + (_e1050[1] * _e1001)) + (_e1050[2] * _e1002)));
                    let _e1062 = local_5.member[1u];
                    let _e1073 = local_5.member[0u];
                    let _e1079 = select(_e1073[0], -(_e1073[0]), (_e1073[0] < 0f));
                    let _e1082 = select(_e1073[1], -(_e1073[1]), (_e1073[1] < 0f));
                    let _e1084 = select(_e1082, _e1079, (_e1079 > _e1082));
                    let _e1087 = select(_e1073[2], -(_e1073[2]), (_e1073[2] < 0f));
                    let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                    let _e1092 = local_5.member[1u];
                    let _e1098 = select(_e1092[0], -(_e1092[0]), (_e1092[0] < 0f));
                    let _e1101 = select(_e1092[1], -(_e1092[1]), (_e1092[1] < 0f));
                    let _e1103 = select(_e1101, _e1098, (_e1098 > _e1101));
                    let _e1106 = select(_e1092[2], -(_e1092[2]), (_e1092[2] < 0f));
                    let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                    let _e1112 = local_5.member_3;
                    let _e1113 = (select(_e1108, _e1089, (_e1089 > _e1108)) + _e1112);
                    let _e1116 = local_5.member_1[0u];
                    let _e1122 = select(_e1116[0], -(_e1116[0]), (_e1116[0] < 0f));
                    let _e1125 = select(_e1116[1], -(_e1116[1]), (_e1116[1] < 0f));
                    let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                    let _e1130 = select(_e1116[2], -(_e1116[2]), (_e1116[2] < 0f));
                    let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                    let _e1135 = local_5.member_1[1u];
                    let _e1141 = select(_e1135[0], -(_e1135[0]), (_e1135[0] < 0f));
                    let _e1144 = select(_e1135[1], -(_e1135[1]), (_e1135[1] < 0f));
                    let _e1146 = select(_e1144, _e1141, (_e1141 > _e1144));
                    let _e1149 = select(_e1135[2], -(_e1135[2]), (_e1135[2] < 0f));
                    let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                    let _e1155 = local_5.member_3;
                    let _e1156 = (select(_e1151, _e1132, (_e1132 > _e1151)) + _e1155);
                    let _e1159 = local_5.member_2[0u];
                    let _e1165 = select(_e1159[0], -(_e1159[0]), (_e1159[0] < 0f));
                    let _e1168 = select(_e1159[1], -(_e1159[1]), (_e1159[1] < 0f));
                    let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                    let _e1173 = select(_e1159[2], -(_e1159[2]), (_e1159[2] < 0f));
                    let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                    let _e1178 = local_5.member_2[1u];
                    let _e1184 = select(_e1178[0], -(_e1178[0]), (_e1178[0] < 0f));
                    let _e1187 = select(_e1178[1], -(_e1178[1]), (_e1178[1] < 0f));
                    let _e1189 = select(_e1187, _e1184, (_e1184 > _e1187));
                    let _e1192 = select(_e1178[2], -(_e1178[2]), (_e1178[2] < 0f));
                    let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                    let _e1198 = local_5.member_3;
                    let _e1199 = (select(_e1194, _e1175, (_e1175 > _e1194)) + _e1198);
                    let _e1201 = ((_e1156 * 8f) * _e1199);
                    let _e1208 = local_5.member_3;
                    let _e1232 = ((select(_e930, -(_e930), (_e930 < 0f)) + select(_e933, -(_e933), (_e933 < 0f))) + select(_e936, -(_e936), (_e936 < 0f)));
                    let _e1243 = ((select(_e951, -(_e951), (_e951 < 0f)) + select(_e954, -(_e954), (_e954 < 0f))) + select(_e957, -(_e957), (_e957 < 0f)));
                    let _e1245 = select(_e1243, _e1232, (_e1232 > _e1243));
                    let _e1257 = (((select(_e1000, -(_e1000), (_e1000 < 0f)) + select(_e1001, -(_e1001), (_e1001 < 0f))) + select(_e1002, -(_e1002), (_e1002 < 0f))) * 0.5f);
                    let _e1264 = local_5.member_3;
                    let _e1277 = ((((_e1005[0] * _e930) + (_e1005[1] * _e933)) + (_e1005[2] * _e936)) * 3f);
                    let _e1278 = ((((_e1062[0] * _e951) + (_e1062[1] * _e954)) + (_e1062[2] * _e957)) * 3f);
                    let _e1280 = select(_e1278, _e1277, (_e1277 < _e1278));
                    let _e1282 = select(_e1059, _e1036, (_e1036 < _e1059));
                    let _e1284 = select(_e1282, _e1280, (_e1280 < _e1282));
                    let _e1286 = select(_e1278, _e1277, (_e1277 > _e1278));
                    let _e1288 = select(_e1059, _e1036, (_e1036 > _e1059));
                    let _e1295 = -(select(_e1288, _e1286, (_e1286 > _e1288)));
                    if ((select(_e1295, _e1284, (_e1284 > _e1295)) - ((((((_e1113 * 8f) * _e1201) * (0.000000059604645f * (524f / 64f))) + ((_e1208 * 19f) * ((_e1113 * (_e1156 + _e1199)) + (_e1156 * _e1199)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1113) * ((1f + _e1156) * (1f + _e1199))))) + ((_e603.member_1 * (((select(_e1257, _e1245, (_e1245 > _e1257)) + (_e1201 * (0.000000059604645f * 8f))) + ((_e1264 * 6f) * (_e1156 + _e1199))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1156) * (1f + _e1199))))) * (3f * 1.0001f)))) > 0f) {
                        phi_2082_ = type_33(type_32(0u, f32()), 0u);
                        phi_2083_ = false;
                    } else {
                        phi_2082_ = type_33();
                        phi_2083_ = true;
                    }
                    let _e1303 = phi_2082_;
                    let _e1305 = phi_2083_;
                    phi_2084_ = _e1303;
                    phi_2085_ = _e1305;
                }
                let _e1307 = phi_2084_;
                let _e1309 = phi_2085_;
                if _e1309 {
                    phi_2091_ = type_16(0i, 2i);
                    phi_2094_ = _e374;
                    phi_2096_ = 0u;
                    phi_2098_ = _e374;
                    loop {
                        let _e1311 = phi_2091_;
                        let _e1313 = phi_2094_;
                        let _e1315 = phi_2096_;
                        let _e1317 = phi_2098_;
                        local_53 = _e1315;
                        local_56 = _e1313;
                        local_57 = _e1315;
                        if (_e1311.member < _e1311.member_1) {
                            let _e1324 = (_e1311.member + 1i);
                            phi_2092_ = type_16(select(_e1324, type_17().member_1, select(false, true, ((false == (_e1324 > _e1311.member)) != false))), _e1311.member_1);
                            phi_2139_ = type_17(1u, _e1311.member);
                        } else {
                            phi_2092_ = _e1311;
                            phi_2139_ = type_17(0u, type_17().member_1);
                        }
                        let _e1335 = phi_2092_;
                        let _e1337 = phi_2139_;
                        if (bitcast<i32>(_e1337.member) != 0i) {
                            if select(select(true, false, _e915), true, (_e1337.member_1 > 0i)) {
                                let _e1347 = local_5.member[0u];
                                let _e1353 = local_5.member_1[0u];
                                let _e1359 = local_5.member_2[0u];
                                let _e1363 = (_e1347[0] - _e1353[0]);
                                let _e1364 = (_e1347[1] - _e1353[1]);
                                let _e1365 = (_e1347[2] - _e1353[2]);
                                let _e1366 = (_e219.member == 0u);
                                let _e1378 = local_5.member[1u];
                                let _e1384 = local_5.member_1[1u];
                                let _e1390 = local_5.member_2[1u];
                                let _e1394 = (_e1378[0] - _e1384[0]);
                                let _e1395 = (_e1378[1] - _e1384[1]);
                                let _e1396 = (_e1378[2] - _e1384[2]);
                                let _e1397 = (_e219.member == 0u);
                                let _e1409 = local_5.member[0u];
                                let _e1415 = select(_e1409[0], -(_e1409[0]), (_e1409[0] < 0f));
                                let _e1418 = select(_e1409[1], -(_e1409[1]), (_e1409[1] < 0f));
                                let _e1420 = select(_e1418, _e1415, (_e1415 > _e1418));
                                let _e1423 = select(_e1409[2], -(_e1409[2]), (_e1409[2] < 0f));
                                let _e1425 = select(_e1423, _e1420, (_e1420 > _e1423));
                                let _e1428 = local_5.member[1u];
                                let _e1434 = select(_e1428[0], -(_e1428[0]), (_e1428[0] < 0f));
                                let _e1437 = select(_e1428[1], -(_e1428[1]), (_e1428[1] < 0f));
                                let _e1439 = select(_e1437, _e1434, (_e1434 > _e1437));
                                let _e1442 = select(_e1428[2], -(_e1428[2]), (_e1428[2] < 0f));
                                let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                let _e1448 = local_5.member_3;
                                let _e1452 = local_5.member_1[0u];
                                let _e1458 = select(_e1452[0], -(_e1452[0]), (_e1452[0] < 0f));
                                let _e1461 = select(_e1452[1], -(_e1452[1]), (_e1452[1] < 0f));
                                let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                let _e1466 = select(_e1452[2], -(_e1452[2]), (_e1452[2] < 0f));
                                let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                let _e1471 = local_5.member_1[1u];
                                let _e1477 = select(_e1471[0], -(_e1471[0]), (_e1471[0] < 0f));
                                let _e1480 = select(_e1471[1], -(_e1471[1]), (_e1471[1] < 0f));
                                let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                                let _e1485 = select(_e1471[2], -(_e1471[2]), (_e1471[2] < 0f));
                                let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                let _e1491 = local_5.member_3;
                                let _e1495 = local_5.member_2[0u];
                                let _e1501 = select(_e1495[0], -(_e1495[0]), (_e1495[0] < 0f));
                                let _e1504 = select(_e1495[1], -(_e1495[1]), (_e1495[1] < 0f));
                                let _e1506 = select(_e1504, _e1501, (_e1501 > _e1504));
                                let _e1509 = select(_e1495[2], -(_e1495[2]), (_e1495[2] < 0f));
                                let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                let _e1514 = local_5.member_2[1u];
                                let _e1520 = select(_e1514[0], -(_e1514[0]), (_e1514[0] < 0f));
                                let _e1523 = select(_e1514[1], -(_e1514[1]), (_e1514[1] < 0f));
                                let _e1525 = select(_e1523, _e1520, (_e1520 > _e1523));
                                let _e1528 = select(_e1514[2], -(_e1514[2]), (_e1514[2] < 0f));
                                let _e1530 = select(_e1528, _e1525, (_e1525 > _e1528));
                                let _e1534 = local_5.member_3;
                                let _e1541 = local_5.member_3;
                                let _e1546 = (_e372 * 0.00390625f);
                                local_3 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_2576_ = type_9(0u, 96u);
                                phi_2579_ = _e1317;
                                phi_2581_ = _e1317;
                                phi_2583_ = (_e376 - _e1317);
                                phi_2585_ = _e1317;
                                phi_2587_ = false;
                                phi_2589_ = 0u;
                                loop {
                                    let _e1549 = phi_2576_;
                                    let _e1551 = phi_2579_;
                                    let _e1553 = phi_2581_;
                                    let _e1555 = phi_2583_;
                                    let _e1557 = phi_2585_;
                                    let _e1559 = phi_2587_;
                                    let _e1561 = phi_2589_;
                                    local_19 = _e1551;
                                    local_23 = _e1553;
                                    let _e1564 = (_e1549.member < _e1549.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1564)) != 0i) {
                                        let _e1578 = local_5.member[0u];
                                        let _e1584 = local_5.member[1u];
                                        let _e1600 = local_5.member_1[0u];
                                        let _e1606 = local_5.member_1[1u];
                                        let _e1622 = local_5.member_2[0u];
                                        let _e1628 = local_5.member_2[1u];
                                        let _e1642 = function_3(array<f32, 3>((_e1578[0] + ((_e1584[0] - _e1578[0]) * _e1551)), (_e1578[1] + ((_e1584[1] - _e1578[1]) * _e1551)), (_e1578[2] + ((_e1584[2] - _e1578[2]) * _e1551))), array<f32, 3>((_e1600[0] + ((_e1606[0] - _e1600[0]) * _e1551)), (_e1600[1] + ((_e1606[1] - _e1600[1]) * _e1551)), (_e1600[2] + ((_e1606[2] - _e1600[2]) * _e1551))), array<f32, 3>((_e1622[0] + ((_e1628[0] - _e1622[0]) * _e1551)), (_e1622[1] + ((_e1628[1] - _e1622[1]) * _e1551)), (_e1622[2] + ((_e1628[2] - _e1622[2]) * _e1551))), _e219.member);
                                        if (_e1561 == 0u) {
                                            phi_2740_ = _e1642;
                                        } else {
                                            phi_2740_ = array<f32, 3>(select(0f, _e1642[0], (_e1561 == 1u)), select(0f, _e1642[1], (_e1561 == 2u)), select(0f, _e1642[2], (_e1561 == 3u)));
                                        }
                                        let _e1655 = phi_2740_;
                                        let _e1669 = ((select(_e1655[0], -(_e1655[0]), (_e1655[0] < 0f)) + select(_e1655[1], -(_e1655[1]), (_e1655[1] < 0f))) + select(_e1655[2], -(_e1655[2]), (_e1655[2] < 0f)));
                                        if (_e1669 > 0f) {
                                            if ((bitcast<u32>(_e1669) & 2139095040u) != 2139095040u) {
                                                let _e1674 = (1f / _e1669);
                                                let _e1676 = (_e1655[0] * _e1674);
                                                let _e1678 = (_e1655[1] * _e1674);
                                                let _e1680 = (_e1655[2] * _e1674);
                                                let _e1685 = (((_e1676 * _e1676) + (_e1678 * _e1678)) + (_e1680 * _e1680));
                                                if (_e1685 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_2863_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1685 > 0f));
                                                } else {
                                                    phi_2806_ = type_16(0i, 5i);
                                                    phi_2809_ = bitcast<f32>(((bitcast<u32>(_e1685) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1693 = phi_2806_;
                                                        let _e1695 = phi_2809_;
                                                        local_7 = _e1695;
                                                        if (_e1693.member < _e1693.member_1) {
                                                            let _e1702 = (_e1693.member + 1i);
                                                            phi_2807_ = type_16(select(_e1702, type_17().member_1, select(false, true, ((false == (_e1702 > _e1693.member)) != false))), _e1693.member_1);
                                                            phi_2850_ = type_17(1u, _e1693.member);
                                                        } else {
                                                            phi_2807_ = _e1693;
                                                            phi_2850_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e1713 = phi_2807_;
                                                        let _e1715 = phi_2850_;
                                                        let _e1718 = (bitcast<i32>(_e1715.member) != 0i);
                                                        if _e1718 {
                                                            phi_2810_ = (0.5f * (_e1695 + (_e1685 / _e1695)));
                                                        } else {
                                                            phi_2810_ = f32();
                                                        }
                                                        let _e1723 = phi_2810_;
                                                        continue;
                                                        continuing {
                                                            phi_2806_ = _e1713;
                                                            phi_2809_ = _e1723;
                                                            break if !(_e1718);
                                                        }
                                                    }
                                                    let _e1728 = local_7;
                                                    phi_2863_ = (_e1728 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1734 = phi_2863_;
                                                let _e1735 = (0.000000059604645f * 12f);
                                                let _e1740 = ((((((((select(_e1444, _e1425, (_e1425 > _e1444)) + _e1448) + (select(_e1487, _e1468, (_e1468 > _e1487)) + _e1491)) + (select(_e1530, _e1511, (_e1511 > _e1530)) + _e1534)) * (0.000000059604645f * 16f)) + (_e1541 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e603.member_1 * _e1734) * (1f + _e1735)));
                                                let _e1745 = (((_e1676 * _e1347[0]) + (_e1678 * _e1347[1])) + (_e1680 * _e1347[2]));
                                                let _e1750 = (((_e1676 * _e1363) + (_e1678 * _e1364)) + (_e1680 * _e1365));
                                                let _e1755 = (((_e1676 * (_e1347[0] - _e1359[0])) + (_e1678 * (_e1347[1] - _e1359[1]))) + (_e1680 * (_e1347[2] - _e1359[2])));
                                                let _e1760 = (((_e1676 * select((_e1363 - _e1359[0]), _e1347[0], _e1366)) + (_e1678 * select((_e1364 - _e1359[1]), _e1347[1], _e1366))) + (_e1680 * select((_e1365 - _e1359[2]), _e1347[2], _e1366)));
                                                let _e1766 = (((_e1676 * _e1378[0]) + (_e1678 * _e1378[1])) + (_e1680 * _e1378[2]));
                                                let _e1771 = (((_e1676 * _e1394) + (_e1678 * _e1395)) + (_e1680 * _e1396));
                                                let _e1776 = (((_e1676 * (_e1378[0] - _e1390[0])) + (_e1678 * (_e1378[1] - _e1390[1]))) + (_e1680 * (_e1378[2] - _e1390[2])));
                                                let _e1781 = (((_e1676 * select((_e1394 - _e1390[0]), _e1378[0], _e1397)) + (_e1678 * select((_e1395 - _e1390[1]), _e1378[1], _e1397))) + (_e1680 * select((_e1396 - _e1390[2]), _e1378[2], _e1397)));
                                                phi_2986_ = type_30(array<f32, 4>(_e1745, _e1750, _e1755, _e1760), array<f32, 4>(_e1766, _e1771, _e1776, _e1781), array<f32, 4>((_e1740 + ((select(_e1745, -(_e1745), (_e1745 < 0f)) + select(_e1766, -(_e1766), (_e1766 < 0f))) * _e1735)), (_e1740 + ((select(_e1750, -(_e1750), (_e1750 < 0f)) + select(_e1771, -(_e1771), (_e1771 < 0f))) * _e1735)), (_e1740 + ((select(_e1755, -(_e1755), (_e1755 < 0f)) + select(_e1776, -(_e1776), (_e1776 < 0f))) * _e1735)), (_e1740 + ((select(_e1760, -(_e1760), (_e1760 < 0f)) + select(_e1781, -(_e1781), (_e1781 < 0f))) * _e1735))));
                                                phi_2987_ = false;
                                            } else {
                                                phi_2986_ = type_30();
                                                phi_2987_ = true;
                                            }
                                            let _e1822 = phi_2986_;
                                            let _e1824 = phi_2987_;
                                            phi_2988_ = _e1822;
                                            phi_2989_ = _e1824;
                                        } else {
                                            phi_2988_ = type_30();
                                            phi_2989_ = true;
                                        }
                                        let _e1826 = phi_2988_;
                                        let _e1828 = phi_2989_;
                                        if _e1828 {
                                            phi_2997_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_2997_ = _e1826;
                                        }
                                        let _e1830 = phi_2997_;
                                        local_4 = type_30(array<f32, 4>(_e1830.member[0], _e1830.member[1], _e1830.member[2], _e1830.member[3]), array<f32, 4>(_e1830.member_1[0], _e1830.member_1[1], _e1830.member_1[2], _e1830.member_1[3]), array<f32, 4>(_e1830.member_2[0], _e1830.member_2[1], _e1830.member_2[2], _e1830.member_2[3]));
                                        let _e1850 = (_e1551 - _e1557);
                                        let _e1854 = local_4.member[0u];
                                        let _e1857 = local_4.member_1[0u];
                                        let _e1860 = local_4.member[0u];
                                        let _e1866 = local_4.member_2[0u];
                                        if (((_e1854 + ((_e1857 - _e1860) * _e1551)) - _e1866) > 0f) {
                                            let _e1871 = local_4.member[1u];
                                            let _e1874 = local_4.member_1[1u];
                                            let _e1877 = local_4.member[1u];
                                            let _e1883 = local_4.member_2[1u];
                                            if (((_e1871 + ((_e1874 - _e1877) * _e1551)) - _e1883) > 0f) {
                                                let _e1888 = local_4.member[2u];
                                                let _e1891 = local_4.member_1[2u];
                                                let _e1894 = local_4.member[2u];
                                                let _e1900 = local_4.member_2[2u];
                                                if (((_e1888 + ((_e1891 - _e1894) * _e1551)) - _e1900) > 0f) {
                                                    let _e1905 = local_4.member[3u];
                                                    let _e1908 = local_4.member_1[3u];
                                                    let _e1911 = local_4.member[3u];
                                                    let _e1917 = local_4.member_2[3u];
                                                    phi_3168_ = (((_e1905 + ((_e1908 - _e1911) * _e1551)) - _e1917) > 0f);
                                                    phi_3169_ = false;
                                                } else {
                                                    phi_3168_ = bool();
                                                    phi_3169_ = true;
                                                }
                                                let _e1921 = phi_3168_;
                                                let _e1923 = phi_3169_;
                                                phi_3170_ = _e1921;
                                                phi_3171_ = _e1923;
                                            } else {
                                                phi_3170_ = bool();
                                                phi_3171_ = true;
                                            }
                                            let _e1925 = phi_3170_;
                                            let _e1927 = phi_3171_;
                                            phi_3172_ = _e1925;
                                            phi_3173_ = _e1927;
                                        } else {
                                            phi_3172_ = bool();
                                            phi_3173_ = true;
                                        }
                                        let _e1929 = phi_3172_;
                                        let _e1931 = phi_3173_;
                                        if select(_e1929, false, _e1931) {
                                            if (_e1551 <= _e1553) {
                                                phi_3487_ = true;
                                            } else {
                                                let _e1936 = local_3.member[0u];
                                                let _e1939 = local_3.member_1[0u];
                                                let _e1942 = local_3.member[0u];
                                                let _e1948 = local_3.member_2[0u];
                                                let _e1952 = local_4.member[0u];
                                                let _e1955 = local_4.member_1[0u];
                                                let _e1958 = local_4.member[0u];
                                                let _e1964 = local_4.member_2[0u];
                                                if ((((_e1936 + ((_e1939 - _e1942) * _e1551)) - _e1948) + ((_e1952 + ((_e1955 - _e1958) * _e1557)) - _e1964)) > 0f) {
                                                    let _e1970 = local_3.member[1u];
                                                    let _e1973 = local_3.member_1[1u];
                                                    let _e1976 = local_3.member[1u];
                                                    let _e1982 = local_3.member_2[1u];
                                                    let _e1986 = local_4.member[1u];
                                                    let _e1989 = local_4.member_1[1u];
                                                    let _e1992 = local_4.member[1u];
                                                    let _e1998 = local_4.member_2[1u];
                                                    if ((((_e1970 + ((_e1973 - _e1976) * _e1551)) - _e1982) + ((_e1986 + ((_e1989 - _e1992) * _e1557)) - _e1998)) > 0f) {
                                                        let _e2004 = local_3.member[2u];
                                                        let _e2007 = local_3.member_1[2u];
                                                        let _e2010 = local_3.member[2u];
                                                        let _e2016 = local_3.member_2[2u];
                                                        let _e2020 = local_4.member[2u];
                                                        let _e2023 = local_4.member_1[2u];
                                                        let _e2026 = local_4.member[2u];
                                                        let _e2032 = local_4.member_2[2u];
                                                        if ((((_e2004 + ((_e2007 - _e2010) * _e1551)) - _e2016) + ((_e2020 + ((_e2023 - _e2026) * _e1557)) - _e2032)) > 0f) {
                                                            let _e2038 = local_3.member[3u];
                                                            let _e2041 = local_3.member_1[3u];
                                                            let _e2044 = local_3.member[3u];
                                                            let _e2050 = local_3.member_2[3u];
                                                            let _e2054 = local_4.member[3u];
                                                            let _e2057 = local_4.member_1[3u];
                                                            let _e2060 = local_4.member[3u];
                                                            let _e2066 = local_4.member_2[3u];
                                                            phi_3474_ = ((((_e2038 + ((_e2041 - _e2044) * _e1551)) - _e2050) + ((_e2054 + ((_e2057 - _e2060) * _e1557)) - _e2066)) > 0f);
                                                            phi_3475_ = false;
                                                        } else {
                                                            phi_3474_ = bool();
                                                            phi_3475_ = true;
                                                        }
                                                        let _e2071 = phi_3474_;
                                                        let _e2073 = phi_3475_;
                                                        phi_3476_ = _e2071;
                                                        phi_3477_ = _e2073;
                                                    } else {
                                                        phi_3476_ = bool();
                                                        phi_3477_ = true;
                                                    }
                                                    let _e2075 = phi_3476_;
                                                    let _e2077 = phi_3477_;
                                                    phi_3478_ = _e2075;
                                                    phi_3479_ = _e2077;
                                                } else {
                                                    phi_3478_ = bool();
                                                    phi_3479_ = true;
                                                }
                                                let _e2079 = phi_3478_;
                                                let _e2081 = phi_3479_;
                                                phi_3487_ = select(_e2079, false, _e2081);
                                            }
                                            let _e2084 = phi_3487_;
                                            if _e2084 {
                                                if select(true, select(true, false, (_e1551 >= _e376)), _e1559) {
                                                    local_3 = type_30(array<f32, 4>(_e1830.member[0], _e1830.member[1], _e1830.member[2], _e1830.member[3]), array<f32, 4>(_e1830.member_1[0], _e1830.member_1[1], _e1830.member_1[2], _e1830.member_1[3]), array<f32, 4>(_e1830.member_2[0], _e1830.member_2[1], _e1830.member_2[2], _e1830.member_2[3]));
                                                    let _e2109 = local_3.member[0u];
                                                    let _e2112 = local_3.member_1[0u];
                                                    let _e2115 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2112 > _e2115)), (_e2109 > _e2115)) {
                                                        let _e2120 = (_e2112 >= _e2109);
                                                        if _e2120 {
                                                            phi_3596_ = f32();
                                                            phi_3597_ = false;
                                                        } else {
                                                            if ((_e2109 - _e2112) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3594_ = (((_e2109 - _e2115) / (_e2109 - _e2112)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3595_ = false;
                                                            } else {
                                                                phi_3594_ = f32();
                                                                phi_3595_ = true;
                                                            }
                                                            let _e2131 = phi_3594_;
                                                            let _e2133 = phi_3595_;
                                                            phi_3596_ = _e2131;
                                                            phi_3597_ = _e2133;
                                                        }
                                                        let _e2135 = phi_3596_;
                                                        let _e2137 = phi_3597_;
                                                        phi_3598_ = _e2135;
                                                        phi_3599_ = _e2120;
                                                        phi_3600_ = _e2137;
                                                    } else {
                                                        phi_3598_ = f32();
                                                        phi_3599_ = true;
                                                        phi_3600_ = false;
                                                    }
                                                    let _e2139 = phi_3598_;
                                                    let _e2141 = phi_3599_;
                                                    let _e2143 = phi_3600_;
                                                    let _e2146 = select(_e2139, select(_e1551, 2f, _e2141), select(_e2143, true, _e2141));
                                                    let _e2149 = local_3.member[1u];
                                                    let _e2152 = local_3.member_1[1u];
                                                    let _e2155 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2152 > _e2155)), (_e2149 > _e2155)) {
                                                        let _e2160 = (_e2152 >= _e2149);
                                                        if _e2160 {
                                                            phi_3664_ = f32();
                                                            phi_3665_ = false;
                                                        } else {
                                                            if ((_e2149 - _e2152) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3662_ = (((_e2149 - _e2155) / (_e2149 - _e2152)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3663_ = false;
                                                            } else {
                                                                phi_3662_ = f32();
                                                                phi_3663_ = true;
                                                            }
                                                            let _e2171 = phi_3662_;
                                                            let _e2173 = phi_3663_;
                                                            phi_3664_ = _e2171;
                                                            phi_3665_ = _e2173;
                                                        }
                                                        let _e2175 = phi_3664_;
                                                        let _e2177 = phi_3665_;
                                                        phi_3666_ = _e2175;
                                                        phi_3667_ = _e2160;
                                                        phi_3668_ = _e2177;
                                                    } else {
                                                        phi_3666_ = f32();
                                                        phi_3667_ = true;
                                                        phi_3668_ = false;
                                                    }
                                                    let _e2179 = phi_3666_;
                                                    let _e2181 = phi_3667_;
                                                    let _e2183 = phi_3668_;
                                                    let _e2186 = select(_e2179, select(_e1551, 2f, _e2181), select(_e2183, true, _e2181));
                                                    let _e2188 = select(_e2186, _e2146, (_e2146 < _e2186));
                                                    let _e2191 = local_3.member[2u];
                                                    let _e2194 = local_3.member_1[2u];
                                                    let _e2197 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2194 > _e2197)), (_e2191 > _e2197)) {
                                                        let _e2202 = (_e2194 >= _e2191);
                                                        if _e2202 {
                                                            phi_3737_ = f32();
                                                            phi_3738_ = false;
                                                        } else {
                                                            if ((_e2191 - _e2194) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3735_ = (((_e2191 - _e2197) / (_e2191 - _e2194)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3736_ = false;
                                                            } else {
                                                                phi_3735_ = f32();
                                                                phi_3736_ = true;
                                                            }
                                                            let _e2213 = phi_3735_;
                                                            let _e2215 = phi_3736_;
                                                            phi_3737_ = _e2213;
                                                            phi_3738_ = _e2215;
                                                        }
                                                        let _e2217 = phi_3737_;
                                                        let _e2219 = phi_3738_;
                                                        phi_3739_ = _e2217;
                                                        phi_3740_ = _e2202;
                                                        phi_3741_ = _e2219;
                                                    } else {
                                                        phi_3739_ = f32();
                                                        phi_3740_ = true;
                                                        phi_3741_ = false;
                                                    }
                                                    let _e2221 = phi_3739_;
                                                    let _e2223 = phi_3740_;
                                                    let _e2225 = phi_3741_;
                                                    let _e2228 = select(_e2221, select(_e1551, 2f, _e2223), select(_e2225, true, _e2223));
                                                    let _e2231 = local_3.member[3u];
                                                    let _e2234 = local_3.member_1[3u];
                                                    let _e2237 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2234 > _e2237)), (_e2231 > _e2237)) {
                                                        let _e2242 = (_e2234 >= _e2231);
                                                        if _e2242 {
                                                            phi_3805_ = f32();
                                                            phi_3806_ = false;
                                                        } else {
                                                            if ((_e2231 - _e2234) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3803_ = (((_e2231 - _e2237) / (_e2231 - _e2234)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3804_ = false;
                                                            } else {
                                                                phi_3803_ = f32();
                                                                phi_3804_ = true;
                                                            }
                                                            let _e2253 = phi_3803_;
                                                            let _e2255 = phi_3804_;
                                                            phi_3805_ = _e2253;
                                                            phi_3806_ = _e2255;
                                                        }
                                                        let _e2257 = phi_3805_;
                                                        let _e2259 = phi_3806_;
                                                        phi_3807_ = _e2257;
                                                        phi_3808_ = _e2242;
                                                        phi_3809_ = _e2259;
                                                    } else {
                                                        phi_3807_ = f32();
                                                        phi_3808_ = true;
                                                        phi_3809_ = false;
                                                    }
                                                    let _e2261 = phi_3807_;
                                                    let _e2263 = phi_3808_;
                                                    let _e2265 = phi_3809_;
                                                    let _e2268 = select(_e2261, select(_e1551, 2f, _e2263), select(_e2265, true, _e2263));
                                                    let _e2270 = select(_e2268, _e2228, (_e2228 < _e2268));
                                                    let _e2272 = select(_e2270, _e2188, (_e2188 < _e2270));
                                                    let _e2274 = select(_e1551, _e2272, (_e2272 > _e1551));
                                                    let _e2275 = (_e2274 > _e376);
                                                    if _e2275 {
                                                        phi_4338_ = f32();
                                                        phi_4339_ = f32();
                                                        phi_4340_ = false;
                                                        phi_4341_ = false;
                                                    } else {
                                                        let _e2276 = (_e2274 - _e1551);
                                                        let _e2277 = (_e2276 <= _e1546);
                                                        let _e2279 = (_e2274 + (_e372 * 0.01f));
                                                        let _e2281 = select(_e376, _e2279, (_e2279 < _e376));
                                                        if _e2277 {
                                                            if (_e603.member_1 > 0f) {
                                                                let _e2285 = local_5.member[0u];
                                                                let _e2291 = local_5.member[1u];
                                                                let _e2307 = local_5.member_1[0u];
                                                                let _e2313 = local_5.member_1[1u];
                                                                let _e2329 = local_5.member_2[0u];
                                                                let _e2335 = local_5.member_2[1u];
                                                                let _e2349 = function_3(array<f32, 3>((_e2285[0] + ((_e2291[0] - _e2285[0]) * _e2281)), (_e2285[1] + ((_e2291[1] - _e2285[1]) * _e2281)), (_e2285[2] + ((_e2291[2] - _e2285[2]) * _e2281))), array<f32, 3>((_e2307[0] + ((_e2313[0] - _e2307[0]) * _e2281)), (_e2307[1] + ((_e2313[1] - _e2307[1]) * _e2281)), (_e2307[2] + ((_e2313[2] - _e2307[2]) * _e2281))), array<f32, 3>((_e2329[0] + ((_e2335[0] - _e2329[0]) * _e2281)), (_e2329[1] + ((_e2335[1] - _e2329[1]) * _e2281)), (_e2329[2] + ((_e2335[2] - _e2329[2]) * _e2281))), _e219.member);
                                                                let _e2360 = (((_e2349[0] * _e2349[0]) + (_e2349[1] * _e2349[1])) + (_e2349[2] * _e2349[2]));
                                                                if (_e2360 <= 0.000000000000000000000000000000000000011754944f) {
                                                                    phi_4040_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2360 > 0f));
                                                                } else {
                                                                    phi_3983_ = type_16(0i, 5i);
                                                                    phi_3986_ = bitcast<f32>(((bitcast<u32>(_e2360) >> bitcast<u32>(1i)) + 532369198u));
                                                                    loop {
                                                                        let _e2368 = phi_3983_;
                                                                        let _e2370 = phi_3986_;
                                                                        local_8 = _e2370;
                                                                        if (_e2368.member < _e2368.member_1) {
                                                                            let _e2377 = (_e2368.member + 1i);
                                                                            phi_3984_ = type_16(select(_e2377, type_17().member_1, select(false, true, ((false == (_e2377 > _e2368.member)) != false))), _e2368.member_1);
                                                                            phi_4027_ = type_17(1u, _e2368.member);
                                                                        } else {
                                                                            phi_3984_ = _e2368;
                                                                            phi_4027_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e2388 = phi_3984_;
                                                                        let _e2390 = phi_4027_;
                                                                        let _e2393 = (bitcast<i32>(_e2390.member) != 0i);
                                                                        if _e2393 {
                                                                            phi_3987_ = (0.5f * (_e2370 + (_e2360 / _e2370)));
                                                                        } else {
                                                                            phi_3987_ = f32();
                                                                        }
                                                                        let _e2398 = phi_3987_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_3983_ = _e2388;
                                                                            phi_3986_ = _e2398;
                                                                            break if !(_e2393);
                                                                        }
                                                                    }
                                                                    let _e2403 = local_8;
                                                                    phi_4040_ = (_e2403 * (1f + (8f * 0.000000059604645f)));
                                                                }
                                                                let _e2409 = phi_4040_;
                                                                let _e2415 = local_5.member[0u];
                                                                let _e2421 = select(_e2415[0], -(_e2415[0]), (_e2415[0] < 0f));
                                                                let _e2424 = select(_e2415[1], -(_e2415[1]), (_e2415[1] < 0f));
                                                                let _e2426 = select(_e2424, _e2421, (_e2421 > _e2424));
                                                                let _e2429 = select(_e2415[2], -(_e2415[2]), (_e2415[2] < 0f));
                                                                let _e2431 = select(_e2429, _e2426, (_e2426 > _e2429));
                                                                let _e2434 = local_5.member[1u];
                                                                let _e2440 = select(_e2434[0], -(_e2434[0]), (_e2434[0] < 0f));
                                                                let _e2443 = select(_e2434[1], -(_e2434[1]), (_e2434[1] < 0f));
                                                                let _e2445 = select(_e2443, _e2440, (_e2440 > _e2443));
                                                                let _e2448 = select(_e2434[2], -(_e2434[2]), (_e2434[2] < 0f));
                                                                let _e2450 = select(_e2448, _e2445, (_e2445 > _e2448));
                                                                let _e2454 = local_5.member_3;
                                                                let _e2458 = local_5.member_1[0u];
                                                                let _e2464 = select(_e2458[0], -(_e2458[0]), (_e2458[0] < 0f));
                                                                let _e2467 = select(_e2458[1], -(_e2458[1]), (_e2458[1] < 0f));
                                                                let _e2469 = select(_e2467, _e2464, (_e2464 > _e2467));
                                                                let _e2472 = select(_e2458[2], -(_e2458[2]), (_e2458[2] < 0f));
                                                                let _e2474 = select(_e2472, _e2469, (_e2469 > _e2472));
                                                                let _e2477 = local_5.member_1[1u];
                                                                let _e2483 = select(_e2477[0], -(_e2477[0]), (_e2477[0] < 0f));
                                                                let _e2486 = select(_e2477[1], -(_e2477[1]), (_e2477[1] < 0f));
                                                                let _e2488 = select(_e2486, _e2483, (_e2483 > _e2486));
                                                                let _e2491 = select(_e2477[2], -(_e2477[2]), (_e2477[2] < 0f));
                                                                let _e2493 = select(_e2491, _e2488, (_e2488 > _e2491));
                                                                let _e2497 = local_5.member_3;
                                                                let _e2501 = local_5.member_2[0u];
                                                                let _e2507 = select(_e2501[0], -(_e2501[0]), (_e2501[0] < 0f));
                                                                let _e2510 = select(_e2501[1], -(_e2501[1]), (_e2501[1] < 0f));
                                                                let _e2512 = select(_e2510, _e2507, (_e2507 > _e2510));
                                                                let _e2515 = select(_e2501[2], -(_e2501[2]), (_e2501[2] < 0f));
                                                                let _e2517 = select(_e2515, _e2512, (_e2512 > _e2515));
                                                                let _e2520 = local_5.member_2[1u];
                                                                let _e2526 = select(_e2520[0], -(_e2520[0]), (_e2520[0] < 0f));
                                                                let _e2529 = select(_e2520[1], -(_e2520[1]), (_e2520[1] < 0f));
                                                                let _e2531 = select(_e2529, _e2526, (_e2526 > _e2529));
                                                                let _e2534 = select(_e2520[2], -(_e2520[2]), (_e2520[2] < 0f));
                                                                let _e2536 = select(_e2534, _e2531, (_e2531 > _e2534));
                                                                let _e2540 = local_5.member_3;
                                                                let _e2547 = local_5.member_3;
                                                                phi_4311_ = select(true, false, (((_e2409 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2450, _e2431, (_e2431 > _e2450)) + _e2454) + (select(_e2493, _e2474, (_e2474 > _e2493)) + _e2497)) + (select(_e2536, _e2517, (_e2517 > _e2536)) + _e2540)) * (0.000000059604645f * 16f)) + (_e2547 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e603.member_1));
                                                            } else {
                                                                phi_4311_ = true;
                                                            }
                                                            let _e2557 = phi_4311_;
                                                            phi_4312_ = _e2557;
                                                        } else {
                                                            phi_4312_ = true;
                                                        }
                                                        let _e2559 = phi_4312_;
                                                        phi_4338_ = select(f32(), select((_e376 - _e1551), select(0f, (_e1850 + _e1850), select(select(true, false, (_e2276 <= (_e1555 * 0.25f))), true, _e2277)), _e1559), _e2559);
                                                        phi_4339_ = _e2276;
                                                        phi_4340_ = _e2559;
                                                        phi_4341_ = select(true, false, _e2559);
                                                    }
                                                    let _e2571 = phi_4338_;
                                                    let _e2573 = phi_4339_;
                                                    let _e2575 = phi_4340_;
                                                    let _e2577 = phi_4341_;
                                                    phi_4342_ = _e2274;
                                                    phi_4343_ = _e2571;
                                                    phi_4344_ = _e2573;
                                                    phi_4345_ = _e2274;
                                                    phi_4346_ = _e2575;
                                                    phi_4347_ = _e2275;
                                                    phi_4348_ = _e2577;
                                                    phi_4349_ = false;
                                                } else {
                                                    phi_4342_ = f32();
                                                    phi_4343_ = f32();
                                                    phi_4344_ = f32();
                                                    phi_4345_ = f32();
                                                    phi_4346_ = false;
                                                    phi_4347_ = false;
                                                    phi_4348_ = false;
                                                    phi_4349_ = true;
                                                }
                                                let _e2579 = phi_4342_;
                                                let _e2581 = phi_4343_;
                                                let _e2583 = phi_4344_;
                                                let _e2585 = phi_4345_;
                                                let _e2587 = phi_4346_;
                                                let _e2589 = phi_4347_;
                                                let _e2591 = phi_4348_;
                                                let _e2593 = phi_4349_;
                                                phi_4350_ = _e2579;
                                                phi_4351_ = _e2581;
                                                phi_4352_ = _e2583;
                                                phi_4353_ = _e2585;
                                                phi_4354_ = false;
                                                phi_4355_ = _e2587;
                                                phi_4356_ = _e2589;
                                                phi_4357_ = _e2591;
                                                phi_4358_ = _e2593;
                                            } else {
                                                phi_4350_ = f32();
                                                phi_4351_ = f32();
                                                phi_4352_ = f32();
                                                phi_4353_ = f32();
                                                phi_4354_ = true;
                                                phi_4355_ = false;
                                                phi_4356_ = false;
                                                phi_4357_ = false;
                                                phi_4358_ = false;
                                            }
                                            let _e2595 = phi_4350_;
                                            let _e2597 = phi_4351_;
                                            let _e2599 = phi_4352_;
                                            let _e2601 = phi_4353_;
                                            let _e2603 = phi_4354_;
                                            let _e2605 = phi_4355_;
                                            let _e2607 = phi_4356_;
                                            let _e2609 = phi_4357_;
                                            let _e2611 = phi_4358_;
                                            phi_4359_ = _e2595;
                                            phi_4360_ = _e2597;
                                            phi_4361_ = _e2599;
                                            phi_4362_ = _e2601;
                                            phi_4363_ = _e2603;
                                            phi_4364_ = _e2605;
                                            phi_4365_ = _e2607;
                                            phi_4366_ = _e2609;
                                            phi_4367_ = _e2611;
                                        } else {
                                            phi_4359_ = f32();
                                            phi_4360_ = f32();
                                            phi_4361_ = f32();
                                            phi_4362_ = f32();
                                            phi_4363_ = true;
                                            phi_4364_ = false;
                                            phi_4365_ = false;
                                            phi_4366_ = false;
                                            phi_4367_ = false;
                                        }
                                        let _e2613 = phi_4359_;
                                        let _e2615 = phi_4360_;
                                        let _e2617 = phi_4361_;
                                        let _e2619 = phi_4362_;
                                        let _e2621 = phi_4363_;
                                        let _e2623 = phi_4364_;
                                        let _e2625 = phi_4365_;
                                        let _e2627 = phi_4366_;
                                        let _e2629 = phi_4367_;
                                        if _e2621 {
                                            if (_e1551 <= _e1553) {
                                                let _e2782 = (_e1561 + 1u);
                                                let _e2783 = (_e2782 > 3u);
                                                phi_4702_ = _e2782;
                                                phi_4703_ = f32();
                                                phi_4704_ = false;
                                                phi_4705_ = select(true, false, _e2783);
                                                phi_4706_ = _e2783;
                                            } else {
                                                let _e2633 = local_3.member[0u];
                                                let _e2636 = local_3.member_1[0u];
                                                let _e2639 = local_3.member[0u];
                                                let _e2645 = local_3.member_2[0u];
                                                let _e2646 = ((_e2633 + ((_e2636 - _e2639) * _e1557)) - _e2645);
                                                let _e2649 = local_3.member[1u];
                                                let _e2652 = local_3.member_1[1u];
                                                let _e2655 = local_3.member[1u];
                                                let _e2661 = local_3.member_2[1u];
                                                let _e2662 = ((_e2649 + ((_e2652 - _e2655) * _e1557)) - _e2661);
                                                let _e2664 = select(_e2662, _e2646, (_e2646 < _e2662));
                                                let _e2667 = local_3.member[2u];
                                                let _e2670 = local_3.member_1[2u];
                                                let _e2673 = local_3.member[2u];
                                                let _e2679 = local_3.member_2[2u];
                                                let _e2680 = ((_e2667 + ((_e2670 - _e2673) * _e1557)) - _e2679);
                                                let _e2683 = local_3.member[3u];
                                                let _e2686 = local_3.member_1[3u];
                                                let _e2689 = local_3.member[3u];
                                                let _e2695 = local_3.member_2[3u];
                                                let _e2696 = ((_e2683 + ((_e2686 - _e2689) * _e1557)) - _e2695);
                                                let _e2698 = select(_e2696, _e2680, (_e2680 < _e2696));
                                                let _e2700 = select(_e2698, _e2664, (_e2664 < _e2698));
                                                let _e2703 = local_4.member[0u];
                                                let _e2706 = local_4.member_1[0u];
                                                let _e2709 = local_4.member[0u];
                                                let _e2715 = local_4.member_2[0u];
                                                let _e2716 = ((_e2703 + ((_e2706 - _e2709) * _e1551)) - _e2715);
                                                let _e2719 = local_4.member[1u];
                                                let _e2722 = local_4.member_1[1u];
                                                let _e2725 = local_4.member[1u];
                                                let _e2731 = local_4.member_2[1u];
                                                let _e2732 = ((_e2719 + ((_e2722 - _e2725) * _e1551)) - _e2731);
                                                let _e2734 = select(_e2732, _e2716, (_e2716 < _e2732));
                                                let _e2737 = local_4.member[2u];
                                                let _e2740 = local_4.member_1[2u];
                                                let _e2743 = local_4.member[2u];
                                                let _e2749 = local_4.member_2[2u];
                                                let _e2750 = ((_e2737 + ((_e2740 - _e2743) * _e1551)) - _e2749);
                                                let _e2753 = local_4.member[3u];
                                                let _e2756 = local_4.member_1[3u];
                                                let _e2759 = local_4.member[3u];
                                                let _e2765 = local_4.member_2[3u];
                                                let _e2766 = ((_e2753 + ((_e2756 - _e2759) * _e1551)) - _e2765);
                                                let _e2768 = select(_e2766, _e2750, (_e2750 < _e2766));
                                                let _e2770 = select(_e2768, _e2734, (_e2734 < _e2768));
                                                if (_e2770 > 0f) {
                                                    phi_4700_ = 0.5f;
                                                } else {
                                                    let _e2774 = (0.95f * (_e2700 / (_e2700 - _e2770)));
                                                    phi_4700_ = select(0.0625f, select(0.9f, _e2774, (_e2774 < 0.9f)), (_e2774 > 0.0625f));
                                                }
                                                let _e2780 = phi_4700_;
                                                phi_4702_ = u32();
                                                phi_4703_ = (_e1850 * _e2780);
                                                phi_4704_ = true;
                                                phi_4705_ = false;
                                                phi_4706_ = false;
                                            }
                                            let _e2786 = phi_4702_;
                                            let _e2788 = phi_4703_;
                                            let _e2790 = phi_4704_;
                                            let _e2792 = phi_4705_;
                                            let _e2794 = phi_4706_;
                                            phi_4707_ = _e2786;
                                            phi_4708_ = _e1553;
                                            phi_4709_ = _e2788;
                                            phi_4710_ = _e1555;
                                            phi_4711_ = _e1557;
                                            phi_4712_ = _e1559;
                                            phi_4713_ = _e1561;
                                            phi_4714_ = _e2790;
                                            phi_4715_ = _e2792;
                                            phi_4716_ = _e2794;
                                            phi_4717_ = false;
                                            phi_4718_ = false;
                                            phi_4719_ = false;
                                        } else {
                                            phi_4707_ = u32();
                                            phi_4708_ = _e2613;
                                            phi_4709_ = _e2615;
                                            phi_4710_ = _e2617;
                                            phi_4711_ = _e1551;
                                            phi_4712_ = true;
                                            phi_4713_ = 0u;
                                            phi_4714_ = _e2623;
                                            phi_4715_ = false;
                                            phi_4716_ = false;
                                            phi_4717_ = _e2625;
                                            phi_4718_ = _e2627;
                                            phi_4719_ = _e2629;
                                        }
                                        let _e2796 = phi_4707_;
                                        let _e2798 = phi_4708_;
                                        let _e2800 = phi_4709_;
                                        let _e2802 = phi_4710_;
                                        let _e2804 = phi_4711_;
                                        let _e2806 = phi_4712_;
                                        let _e2808 = phi_4713_;
                                        let _e2810 = phi_4714_;
                                        let _e2812 = phi_4715_;
                                        let _e2814 = phi_4716_;
                                        let _e2816 = phi_4717_;
                                        let _e2818 = phi_4718_;
                                        let _e2820 = phi_4719_;
                                        if _e2810 {
                                            let _e2821 = (_e2804 + _e2800);
                                            let _e2823 = select(_e2798, _e2821, (_e2821 > _e2798));
                                            let _e2825 = select(_e376, _e2823, (_e2823 < _e376));
                                            let _e2828 = select(((_e2825 - _e2804) > _e1546), true, !(_e1559));
                                            phi_4747_ = _e2825;
                                            phi_4748_ = _e2798;
                                            phi_4749_ = _e2802;
                                            phi_4750_ = _e2804;
                                            phi_4751_ = _e2806;
                                            phi_4752_ = _e2808;
                                            phi_4753_ = _e2828;
                                            phi_4754_ = select(true, false, _e2828);
                                            phi_4755_ = false;
                                            phi_4756_ = false;
                                            phi_4757_ = false;
                                            phi_4758_ = false;
                                        } else {
                                            phi_4747_ = _e1551;
                                            phi_4748_ = _e1553;
                                            phi_4749_ = _e1555;
                                            phi_4750_ = _e1557;
                                            phi_4751_ = _e1559;
                                            phi_4752_ = _e2796;
                                            phi_4753_ = _e2812;
                                            phi_4754_ = false;
                                            phi_4755_ = _e2814;
                                            phi_4756_ = _e2816;
                                            phi_4757_ = _e2818;
                                            phi_4758_ = _e2820;
                                        }
                                        let _e2831 = phi_4747_;
                                        let _e2833 = phi_4748_;
                                        let _e2835 = phi_4749_;
                                        let _e2837 = phi_4750_;
                                        let _e2839 = phi_4751_;
                                        let _e2841 = phi_4752_;
                                        let _e2843 = phi_4753_;
                                        let _e2845 = phi_4754_;
                                        let _e2847 = phi_4755_;
                                        let _e2849 = phi_4756_;
                                        let _e2851 = phi_4757_;
                                        let _e2853 = phi_4758_;
                                        phi_2580_ = _e2831;
                                        phi_2582_ = _e2833;
                                        phi_2584_ = _e2835;
                                        phi_2586_ = _e2837;
                                        phi_2588_ = _e2839;
                                        phi_2590_ = _e2841;
                                        phi_4759_ = _e2798;
                                        phi_4760_ = _e2619;
                                        phi_4761_ = _e2843;
                                        phi_4762_ = _e2845;
                                        phi_4763_ = _e2847;
                                        phi_4764_ = _e2849;
                                        phi_4765_ = _e2851;
                                        phi_4766_ = false;
                                        phi_4767_ = _e2853;
                                    } else {
                                        phi_2580_ = f32();
                                        phi_2582_ = f32();
                                        phi_2584_ = f32();
                                        phi_2586_ = f32();
                                        phi_2588_ = bool();
                                        phi_2590_ = u32();
                                        phi_4759_ = f32();
                                        phi_4760_ = f32();
                                        phi_4761_ = false;
                                        phi_4762_ = false;
                                        phi_4763_ = false;
                                        phi_4764_ = false;
                                        phi_4765_ = false;
                                        phi_4766_ = true;
                                        phi_4767_ = false;
                                    }
                                    let _e2855 = phi_2580_;
                                    let _e2857 = phi_2582_;
                                    let _e2859 = phi_2584_;
                                    let _e2861 = phi_2586_;
                                    let _e2863 = phi_2588_;
                                    let _e2865 = phi_2590_;
                                    let _e2867 = phi_4759_;
                                    let _e2869 = phi_4760_;
                                    let _e2871 = phi_4761_;
                                    let _e2873 = phi_4762_;
                                    let _e2875 = phi_4763_;
                                    let _e2877 = phi_4764_;
                                    let _e2879 = phi_4765_;
                                    let _e2881 = phi_4766_;
                                    let _e2883 = phi_4767_;
                                    local_9 = _e2873;
                                    local_10 = _e2875;
                                    local_11 = _e2873;
                                    local_12 = _e2877;
                                    local_13 = _e2873;
                                    local_14 = _e2879;
                                    local_15 = _e2873;
                                    local_16 = _e2881;
                                    local_17 = _e2873;
                                    local_18 = _e2883;
                                    local_20 = _e2873;
                                    local_21 = _e2869;
                                    local_22 = _e2867;
                                    continue;
                                    continuing {
                                        phi_2576_ = type_9(select(_e1549.member, (_e1549.member + 1u), _e1564), select(_e1549.member_1, _e1549.member_1, _e1564));
                                        phi_2579_ = _e2855;
                                        phi_2581_ = _e2857;
                                        phi_2583_ = _e2859;
                                        phi_2585_ = _e2861;
                                        phi_2587_ = _e2863;
                                        phi_2589_ = _e2865;
                                        break if !(_e2871);
                                    }
                                }
                                let _e2886 = local_9;
                                let _e2888 = local_10;
                                let _e2889 = select(_e2888, false, _e2886);
                                let _e2891 = local_11;
                                let _e2893 = local_12;
                                let _e2896 = local_13;
                                let _e2898 = local_14;
                                let _e2901 = local_15;
                                let _e2903 = local_16;
                                let _e2906 = local_17;
                                let _e2908 = local_18;
                                let _e2914 = local_19;
                                let _e2916 = select(select(_e2893, false, _e2891), false, _e2889);
                                let _e2919 = local_20;
                                let _e2926 = select(select(select(_e2898, false, _e2896), false, _e2889), false, _e2916);
                                let _e2932 = local_21;
                                let _e2934 = local_22;
                                let _e2936 = select(select(select(_e2919, false, _e2889), false, _e2916), true, _e2926);
                                let _e2941 = local_23;
                                let _e2943 = select(select(select(select(select(_e2903, false, _e2901), false, _e2889), false, _e2916), false, _e2926), true, _e2936);
                                let _e2950 = select(select(select(select(select(select(_e2908, false, _e2906), false, _e2889), false, _e2916), false, _e2926), false, _e2936), false, _e2943);
                                let _e2955 = select(select(select(select(select(_e2889, true, _e2916), false, _e2926), false, _e2936), false, _e2943), true, _e2950);
                                phi_4834_ = select(select(type_32().member_1, select(_e2941, select(_e2934, _e2932, _e2926), _e2936), _e2943), select(select(select(type_32().member_1, _e2914, _e2889), type_32().member_1, _e2916), type_32().member_1, _e2950), _e2955);
                                phi_4835_ = (select(select(type_32().member, 1u, _e2943), select(select(select(type_32().member, 1u, _e2889), 0u, _e2916), 0u, _e2950), _e2955) != 0u);
                            } else {
                                phi_4834_ = _e1313;
                                phi_4835_ = true;
                            }
                            let _e2960 = phi_4834_;
                            let _e2962 = phi_4835_;
                            if _e2962 {
                                let _e2963 = (_e2960 > _e374);
                                if _e2963 {
                                    phi_7000_ = f32();
                                    phi_7001_ = u32();
                                    phi_7002_ = f32();
                                    phi_7003_ = type_34();
                                    phi_7004_ = u32();
                                    phi_7005_ = u32();
                                    phi_7006_ = false;
                                    phi_7007_ = false;
                                    phi_7008_ = false;
                                } else {
                                    let _e2966 = local_5.member[0u];
                                    let _e2972 = local_5.member[1u];
                                    let _e2988 = local_5.member_1[0u];
                                    let _e2994 = local_5.member_1[1u];
                                    let _e3010 = local_5.member_2[0u];
                                    let _e3016 = local_5.member_2[1u];
                                    let _e3030 = function_3(array<f32, 3>((_e2966[0] + ((_e2972[0] - _e2966[0]) * _e1317)), (_e2966[1] + ((_e2972[1] - _e2966[1]) * _e1317)), (_e2966[2] + ((_e2972[2] - _e2966[2]) * _e1317))), array<f32, 3>((_e2988[0] + ((_e2994[0] - _e2988[0]) * _e1317)), (_e2988[1] + ((_e2994[1] - _e2988[1]) * _e1317)), (_e2988[2] + ((_e2994[2] - _e2988[2]) * _e1317))), array<f32, 3>((_e3010[0] + ((_e3016[0] - _e3010[0]) * _e1317)), (_e3010[1] + ((_e3016[1] - _e3010[1]) * _e1317)), (_e3010[2] + ((_e3016[2] - _e3010[2]) * _e1317))), _e219.member);
                                    let _e3044 = ((select(_e3030[0], -(_e3030[0]), (_e3030[0] < 0f)) + select(_e3030[1], -(_e3030[1]), (_e3030[1] < 0f))) + select(_e3030[2], -(_e3030[2]), (_e3030[2] < 0f)));
                                    let _e3047 = local_5.member[0u];
                                    let _e3053 = local_5.member_1[0u];
                                    let _e3059 = local_5.member_2[0u];
                                    let _e3063 = (_e3047[0] - _e3053[0]);
                                    let _e3064 = (_e3047[1] - _e3053[1]);
                                    let _e3065 = (_e3047[2] - _e3053[2]);
                                    let _e3066 = (_e219.member == 0u);
                                    let _e3078 = local_5.member[1u];
                                    let _e3084 = local_5.member_1[1u];
                                    let _e3090 = local_5.member_2[1u];
                                    let _e3094 = (_e3078[0] - _e3084[0]);
                                    let _e3095 = (_e3078[1] - _e3084[1]);
                                    let _e3096 = (_e3078[2] - _e3084[2]);
                                    let _e3097 = (_e219.member == 0u);
                                    let _e3109 = local_5.member[0u];
                                    let _e3115 = select(_e3109[0], -(_e3109[0]), (_e3109[0] < 0f));
                                    let _e3118 = select(_e3109[1], -(_e3109[1]), (_e3109[1] < 0f));
                                    let _e3120 = select(_e3118, _e3115, (_e3115 > _e3118));
                                    let _e3123 = select(_e3109[2], -(_e3109[2]), (_e3109[2] < 0f));
                                    let _e3125 = select(_e3123, _e3120, (_e3120 > _e3123));
                                    let _e3128 = local_5.member[1u];
                                    let _e3134 = select(_e3128[0], -(_e3128[0]), (_e3128[0] < 0f));
                                    let _e3137 = select(_e3128[1], -(_e3128[1]), (_e3128[1] < 0f));
                                    let _e3139 = select(_e3137, _e3134, (_e3134 > _e3137));
                                    let _e3142 = select(_e3128[2], -(_e3128[2]), (_e3128[2] < 0f));
                                    let _e3144 = select(_e3142, _e3139, (_e3139 > _e3142));
                                    let _e3148 = local_5.member_3;
                                    let _e3152 = local_5.member_1[0u];
                                    let _e3158 = select(_e3152[0], -(_e3152[0]), (_e3152[0] < 0f));
                                    let _e3161 = select(_e3152[1], -(_e3152[1]), (_e3152[1] < 0f));
                                    let _e3163 = select(_e3161, _e3158, (_e3158 > _e3161));
                                    let _e3166 = select(_e3152[2], -(_e3152[2]), (_e3152[2] < 0f));
                                    let _e3168 = select(_e3166, _e3163, (_e3163 > _e3166));
                                    let _e3171 = local_5.member_1[1u];
                                    let _e3177 = select(_e3171[0], -(_e3171[0]), (_e3171[0] < 0f));
                                    let _e3180 = select(_e3171[1], -(_e3171[1]), (_e3171[1] < 0f));
                                    let _e3182 = select(_e3180, _e3177, (_e3177 > _e3180));
                                    let _e3185 = select(_e3171[2], -(_e3171[2]), (_e3171[2] < 0f));
                                    let _e3187 = select(_e3185, _e3182, (_e3182 > _e3185));
                                    let _e3191 = local_5.member_3;
                                    let _e3195 = local_5.member_2[0u];
                                    let _e3201 = select(_e3195[0], -(_e3195[0]), (_e3195[0] < 0f));
                                    let _e3204 = select(_e3195[1], -(_e3195[1]), (_e3195[1] < 0f));
                                    let _e3206 = select(_e3204, _e3201, (_e3201 > _e3204));
                                    let _e3209 = select(_e3195[2], -(_e3195[2]), (_e3195[2] < 0f));
                                    let _e3211 = select(_e3209, _e3206, (_e3206 > _e3209));
                                    let _e3214 = local_5.member_2[1u];
                                    let _e3220 = select(_e3214[0], -(_e3214[0]), (_e3214[0] < 0f));
                                    let _e3223 = select(_e3214[1], -(_e3214[1]), (_e3214[1] < 0f));
                                    let _e3225 = select(_e3223, _e3220, (_e3220 > _e3223));
                                    let _e3228 = select(_e3214[2], -(_e3214[2]), (_e3214[2] < 0f));
                                    let _e3230 = select(_e3228, _e3225, (_e3225 > _e3228));
                                    let _e3234 = local_5.member_3;
                                    let _e3241 = local_5.member_3;
                                    local_1 = type_29(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3047, array<f32, 3>(_e3063, _e3064, _e3065), array<f32, 3>((_e3047[0] - _e3059[0]), (_e3047[1] - _e3059[1]), (_e3047[2] - _e3059[2])), array<f32, 3>(select((_e3063 - _e3059[0]), _e3047[0], _e3066), select((_e3064 - _e3059[1]), _e3047[1], _e3066), select((_e3065 - _e3059[2]), _e3047[2], _e3066))), array<array<f32, 3>, 4>(_e3078, array<f32, 3>(_e3094, _e3095, _e3096), array<f32, 3>((_e3078[0] - _e3090[0]), (_e3078[1] - _e3090[1]), (_e3078[2] - _e3090[2])), array<f32, 3>(select((_e3094 - _e3090[0]), _e3078[0], _e3097), select((_e3095 - _e3090[1]), _e3078[1], _e3097), select((_e3096 - _e3090[2]), _e3078[2], _e3097)))), ((((((select(_e3144, _e3125, (_e3125 > _e3144)) + _e3148) + (select(_e3187, _e3168, (_e3168 > _e3187)) + _e3191)) + (select(_e3230, _e3211, (_e3211 > _e3230)) + _e3234)) * (0.000000059604645f * 16f)) + (_e3241 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e603.member_1);
                                    let _e3257 = local_1.member_1;
                                    if (_e3044 > _e3257) {
                                        if ((bitcast<u32>(_e3044) & 2139095040u) != 2139095040u) {
                                            let _e3262 = (1f / _e3044);
                                            let _e3264 = (_e3030[0] * _e3262);
                                            let _e3266 = (_e3030[1] * _e3262);
                                            let _e3268 = (_e3030[2] * _e3262);
                                            let _e3273 = (((_e3264 * _e3264) + (_e3266 * _e3266)) + (_e3268 * _e3268));
                                            if (_e3273 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5512_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3273 > 0f));
                                            } else {
                                                phi_5455_ = type_16(0i, 5i);
                                                phi_5458_ = bitcast<f32>(((bitcast<u32>(_e3273) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3281 = phi_5455_;
                                                    let _e3283 = phi_5458_;
                                                    local_24 = _e3283;
                                                    if (_e3281.member < _e3281.member_1) {
                                                        let _e3290 = (_e3281.member + 1i);
                                                        phi_5456_ = type_16(select(_e3290, type_17().member_1, select(false, true, ((false == (_e3290 > _e3281.member)) != false))), _e3281.member_1);
                                                        phi_5499_ = type_17(1u, _e3281.member);
                                                    } else {
                                                        phi_5456_ = _e3281;
                                                        phi_5499_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3301 = phi_5456_;
                                                    let _e3303 = phi_5499_;
                                                    let _e3306 = (bitcast<i32>(_e3303.member) != 0i);
                                                    if _e3306 {
                                                        phi_5459_ = (0.5f * (_e3283 + (_e3273 / _e3283)));
                                                    } else {
                                                        phi_5459_ = f32();
                                                    }
                                                    let _e3311 = phi_5459_;
                                                    continue;
                                                    continuing {
                                                        phi_5455_ = _e3301;
                                                        phi_5458_ = _e3311;
                                                        break if !(_e3306);
                                                    }
                                                }
                                                let _e3316 = local_24;
                                                phi_5512_ = (_e3316 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3322 = phi_5512_;
                                            let _e3323 = (0.000000059604645f * 12f);
                                            let _e3325 = local_1.member_1;
                                            let _e3328 = local_1.member_2;
                                            let _e3332 = ((_e3325 * 1.01f) + ((_e3328 * _e3322) * (1f + _e3323)));
                                            let _e3336 = local_1.member[0u][0u];
                                            let _e3344 = (((_e3264 * _e3336[0]) + (_e3266 * _e3336[1])) + (_e3268 * _e3336[2]));
                                            let _e3348 = local_1.member[0u][1u];
                                            let _e3356 = (((_e3264 * _e3348[0]) + (_e3266 * _e3348[1])) + (_e3268 * _e3348[2]));
                                            let _e3360 = local_1.member[0u][2u];
                                            let _e3368 = (((_e3264 * _e3360[0]) + (_e3266 * _e3360[1])) + (_e3268 * _e3360[2]));
                                            let _e3372 = local_1.member[0u][3u];
                                            let _e3380 = (((_e3264 * _e3372[0]) + (_e3266 * _e3372[1])) + (_e3268 * _e3372[2]));
                                            let _e3384 = local_1.member[1u][0u];
                                            let _e3392 = (((_e3264 * _e3384[0]) + (_e3266 * _e3384[1])) + (_e3268 * _e3384[2]));
                                            let _e3396 = local_1.member[1u][1u];
                                            let _e3404 = (((_e3264 * _e3396[0]) + (_e3266 * _e3396[1])) + (_e3268 * _e3396[2]));
                                            let _e3408 = local_1.member[1u][2u];
                                            let _e3416 = (((_e3264 * _e3408[0]) + (_e3266 * _e3408[1])) + (_e3268 * _e3408[2]));
                                            let _e3420 = local_1.member[1u][3u];
                                            let _e3428 = (((_e3264 * _e3420[0]) + (_e3266 * _e3420[1])) + (_e3268 * _e3420[2]));
                                            local_2 = type_30(array<f32, 4>(_e3344, _e3356, _e3368, _e3380), array<f32, 4>(_e3392, _e3404, _e3416, _e3428), array<f32, 4>((_e3332 + ((select(_e3344, -(_e3344), (_e3344 < 0f)) + select(_e3392, -(_e3392), (_e3392 < 0f))) * _e3323)), (_e3332 + ((select(_e3356, -(_e3356), (_e3356 < 0f)) + select(_e3404, -(_e3404), (_e3404 < 0f))) * _e3323)), (_e3332 + ((select(_e3368, -(_e3368), (_e3368 < 0f)) + select(_e3416, -(_e3416), (_e3416 < 0f))) * _e3323)), (_e3332 + ((select(_e3380, -(_e3380), (_e3380 < 0f)) + select(_e3428, -(_e3428), (_e3428 < 0f))) * _e3323))));
                                            let _e3473 = (((_e3264 * _e3264) + (_e3266 * _e3266)) + (_e3268 * _e3268));
                                            if (_e3473 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5804_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3473 > 0f));
                                            } else {
                                                phi_5747_ = type_16(0i, 5i);
                                                phi_5750_ = bitcast<f32>(((bitcast<u32>(_e3473) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3481 = phi_5747_;
                                                    let _e3483 = phi_5750_;
                                                    local_25 = _e3483;
                                                    if (_e3481.member < _e3481.member_1) {
                                                        let _e3490 = (_e3481.member + 1i);
                                                        phi_5748_ = type_16(select(_e3490, type_17().member_1, select(false, true, ((false == (_e3490 > _e3481.member)) != false))), _e3481.member_1);
                                                        phi_5791_ = type_17(1u, _e3481.member);
                                                    } else {
                                                        phi_5748_ = _e3481;
                                                        phi_5791_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3501 = phi_5748_;
                                                    let _e3503 = phi_5791_;
                                                    let _e3506 = (bitcast<i32>(_e3503.member) != 0i);
                                                    if _e3506 {
                                                        phi_5751_ = (0.5f * (_e3483 + (_e3473 / _e3483)));
                                                    } else {
                                                        phi_5751_ = f32();
                                                    }
                                                    let _e3511 = phi_5751_;
                                                    continue;
                                                    continuing {
                                                        phi_5747_ = _e3501;
                                                        phi_5750_ = _e3511;
                                                        break if !(_e3506);
                                                    }
                                                }
                                                let _e3516 = local_25;
                                                phi_5804_ = (_e3516 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3522 = phi_5804_;
                                            let _e3533 = (((_e3030[0] * _e3030[0]) + (_e3030[1] * _e3030[1])) + (_e3030[2] * _e3030[2]));
                                            if (_e3533 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5893_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3533 > 0f));
                                            } else {
                                                phi_5836_ = type_16(0i, 5i);
                                                phi_5839_ = bitcast<f32>(((bitcast<u32>(_e3533) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3541 = phi_5836_;
                                                    let _e3543 = phi_5839_;
                                                    local_26 = _e3543;
                                                    if (_e3541.member < _e3541.member_1) {
                                                        let _e3550 = (_e3541.member + 1i);
                                                        phi_5837_ = type_16(select(_e3550, type_17().member_1, select(false, true, ((false == (_e3550 > _e3541.member)) != false))), _e3541.member_1);
                                                        phi_5880_ = type_17(1u, _e3541.member);
                                                    } else {
                                                        phi_5837_ = _e3541;
                                                        phi_5880_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3561 = phi_5837_;
                                                    let _e3563 = phi_5880_;
                                                    let _e3566 = (bitcast<i32>(_e3563.member) != 0i);
                                                    if _e3566 {
                                                        phi_5840_ = (0.5f * (_e3543 + (_e3533 / _e3543)));
                                                    } else {
                                                        phi_5840_ = f32();
                                                    }
                                                    let _e3571 = phi_5840_;
                                                    continue;
                                                    continuing {
                                                        phi_5836_ = _e3561;
                                                        phi_5839_ = _e3571;
                                                        break if !(_e3566);
                                                    }
                                                }
                                                let _e3576 = local_26;
                                                phi_5893_ = (_e3576 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3582 = phi_5893_;
                                            let _e3588 = local_5.member[0u];
                                            let _e3594 = select(_e3588[0], -(_e3588[0]), (_e3588[0] < 0f));
                                            let _e3597 = select(_e3588[1], -(_e3588[1]), (_e3588[1] < 0f));
                                            let _e3599 = select(_e3597, _e3594, (_e3594 > _e3597));
                                            let _e3602 = select(_e3588[2], -(_e3588[2]), (_e3588[2] < 0f));
                                            let _e3604 = select(_e3602, _e3599, (_e3599 > _e3602));
                                            let _e3607 = local_5.member[1u];
                                            let _e3613 = select(_e3607[0], -(_e3607[0]), (_e3607[0] < 0f));
                                            let _e3616 = select(_e3607[1], -(_e3607[1]), (_e3607[1] < 0f));
                                            let _e3618 = select(_e3616, _e3613, (_e3613 > _e3616));
                                            let _e3621 = select(_e3607[2], -(_e3607[2]), (_e3607[2] < 0f));
                                            let _e3623 = select(_e3621, _e3618, (_e3618 > _e3621));
                                            let _e3627 = local_5.member_3;
                                            let _e3631 = local_5.member_1[0u];
                                            let _e3637 = select(_e3631[0], -(_e3631[0]), (_e3631[0] < 0f));
                                            let _e3640 = select(_e3631[1], -(_e3631[1]), (_e3631[1] < 0f));
                                            let _e3642 = select(_e3640, _e3637, (_e3637 > _e3640));
                                            let _e3645 = select(_e3631[2], -(_e3631[2]), (_e3631[2] < 0f));
                                            let _e3647 = select(_e3645, _e3642, (_e3642 > _e3645));
                                            let _e3650 = local_5.member_1[1u];
                                            let _e3656 = select(_e3650[0], -(_e3650[0]), (_e3650[0] < 0f));
                                            let _e3659 = select(_e3650[1], -(_e3650[1]), (_e3650[1] < 0f));
                                            let _e3661 = select(_e3659, _e3656, (_e3656 > _e3659));
                                            let _e3664 = select(_e3650[2], -(_e3650[2]), (_e3650[2] < 0f));
                                            let _e3666 = select(_e3664, _e3661, (_e3661 > _e3664));
                                            let _e3670 = local_5.member_3;
                                            let _e3674 = local_5.member_2[0u];
                                            let _e3680 = select(_e3674[0], -(_e3674[0]), (_e3674[0] < 0f));
                                            let _e3683 = select(_e3674[1], -(_e3674[1]), (_e3674[1] < 0f));
                                            let _e3685 = select(_e3683, _e3680, (_e3680 > _e3683));
                                            let _e3688 = select(_e3674[2], -(_e3674[2]), (_e3674[2] < 0f));
                                            let _e3690 = select(_e3688, _e3685, (_e3685 > _e3688));
                                            let _e3693 = local_5.member_2[1u];
                                            let _e3699 = select(_e3693[0], -(_e3693[0]), (_e3693[0] < 0f));
                                            let _e3702 = select(_e3693[1], -(_e3693[1]), (_e3693[1] < 0f));
                                            let _e3704 = select(_e3702, _e3699, (_e3699 > _e3702));
                                            let _e3707 = select(_e3693[2], -(_e3693[2]), (_e3693[2] < 0f));
                                            let _e3709 = select(_e3707, _e3704, (_e3704 > _e3707));
                                            let _e3713 = local_5.member_3;
                                            let _e3720 = local_5.member_3;
                                            let _e3730 = ((((_e3582 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3623, _e3604, (_e3604 > _e3623)) + _e3627) + (select(_e3666, _e3647, (_e3647 > _e3666)) + _e3670)) + (select(_e3709, _e3690, (_e3690 > _e3709)) + _e3713)) * (0.000000059604645f * 16f)) + (_e3720 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3522) * (1f + (0.000000059604645f * 64f)));
                                            let _e3733 = local_2.member[0u];
                                            let _e3736 = local_2.member_1[0u];
                                            phi_6201_ = type_9(1u, 4u);
                                            phi_6204_ = ((_e3733 + ((_e3736 - _e3733) * _e1317)) - ((_e3257 * 1.01f) + ((select(_e3733, -(_e3733), (_e3733 < 0f)) + select(_e3736, -(_e3736), (_e3736 < 0f))) * (0.000000059604645f * 12f))));
                                            loop {
                                                let _e3753 = phi_6201_;
                                                let _e3755 = phi_6204_;
                                                local_27 = _e3755;
                                                local_28 = _e3755;
                                                let _e3758 = (_e3753.member < _e3753.member_1);
                                                let _e3769 = select(type_9().member_1, _e3753.member, _e3758);
                                                let _e3771 = (bitcast<i32>(select(0u, 1u, _e3758)) != 0i);
                                                if _e3771 {
                                                    let _e3774 = local_2.member[_e3769];
                                                    let _e3777 = local_2.member_1[_e3769];
                                                    let _e3792 = ((_e3774 + ((_e3777 - _e3774) * _e1317)) - ((_e3257 * 1.01f) + ((select(_e3774, -(_e3774), (_e3774 < 0f)) + select(_e3777, -(_e3777), (_e3777 < 0f))) * (0.000000059604645f * 12f))));
                                                    phi_6205_ = select(_e3792, _e3755, (_e3755 < _e3792));
                                                } else {
                                                    phi_6205_ = f32();
                                                }
                                                let _e3796 = phi_6205_;
                                                continue;
                                                continuing {
                                                    phi_6201_ = type_9(select(_e3753.member, (_e3753.member + 1u), _e3758), select(_e3753.member_1, _e3753.member_1, _e3758));
                                                    phi_6204_ = _e3796;
                                                    break if !(_e3771);
                                                }
                                            }
                                            let _e3799 = local_27;
                                            if (_e3799 > 0f) {
                                                let _e3803 = local_28;
                                                let _e3806 = (((_e3730 - _e3803) / _e3730) * 2.02f);
                                                if (_e3806 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_6360_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3806 > 0f));
                                                } else {
                                                    phi_6303_ = type_16(0i, 5i);
                                                    phi_6306_ = bitcast<f32>(((bitcast<u32>(_e3806) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3814 = phi_6303_;
                                                        let _e3816 = phi_6306_;
                                                        local_29 = _e3816;
                                                        if (_e3814.member < _e3814.member_1) {
                                                            let _e3823 = (_e3814.member + 1i);
                                                            phi_6304_ = type_16(select(_e3823, type_17().member_1, select(false, true, ((false == (_e3823 > _e3814.member)) != false))), _e3814.member_1);
                                                            phi_6347_ = type_17(1u, _e3814.member);
                                                        } else {
                                                            phi_6304_ = _e3814;
                                                            phi_6347_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e3834 = phi_6304_;
                                                        let _e3836 = phi_6347_;
                                                        let _e3839 = (bitcast<i32>(_e3836.member) != 0i);
                                                        if _e3839 {
                                                            phi_6307_ = (0.5f * (_e3816 + (_e3806 / _e3816)));
                                                        } else {
                                                            phi_6307_ = f32();
                                                        }
                                                        let _e3844 = phi_6307_;
                                                        continue;
                                                        continuing {
                                                            phi_6303_ = _e3834;
                                                            phi_6306_ = _e3844;
                                                            break if !(_e3839);
                                                        }
                                                    }
                                                    let _e3849 = local_29;
                                                    phi_6360_ = (_e3849 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3855 = phi_6360_;
                                                let _e3857 = ((_e3855 * _e3522) * 1.01f);
                                                phi_6365_ = type_9(0u, 4u);
                                                phi_6368_ = 2f;
                                                phi_6370_ = true;
                                                phi_6372_ = true;
                                                loop {
                                                    let _e3859 = phi_6365_;
                                                    let _e3861 = phi_6368_;
                                                    let _e3863 = phi_6370_;
                                                    let _e3865 = phi_6372_;
                                                    local_30 = _e3861;
                                                    local_31 = _e3861;
                                                    local_32 = _e3863;
                                                    local_33 = _e3865;
                                                    local_34 = _e3865;
                                                    local_35 = _e3865;
                                                    local_60 = _e3865;
                                                    local_36 = _e3865;
                                                    let _e3868 = (_e3859.member < _e3859.member_1);
                                                    let _e3879 = select(type_9().member_1, _e3859.member, _e3868);
                                                    let _e3881 = (bitcast<i32>(select(0u, 1u, _e3868)) != 0i);
                                                    if _e3881 {
                                                        let _e3885 = local_1.member[0u][_e3879];
                                                        let _e3892 = local_1.member[1u][_e3879];
                                                        let _e3906 = ((select(_e3885[0], -(_e3885[0]), (_e3885[0] < 0f)) + select(_e3885[1], -(_e3885[1]), (_e3885[1] < 0f))) + select(_e3885[2], -(_e3885[2]), (_e3885[2] < 0f)));
                                                        let _e3917 = ((select(_e3892[0], -(_e3892[0]), (_e3892[0] < 0f)) + select(_e3892[1], -(_e3892[1]), (_e3892[1] < 0f))) + select(_e3892[2], -(_e3892[2]), (_e3892[2] < 0f)));
                                                        let _e3923 = (_e3892[0] - _e3885[0]);
                                                        let _e3924 = (_e3892[1] - _e3885[1]);
                                                        let _e3925 = (_e3892[2] - _e3885[2]);
                                                        let _e3942 = local_2.member[_e3879];
                                                        let _e3945 = local_2.member_1[_e3879];
                                                        let _e3956 = ((_e3257 * 1.01f) + ((select(_e3942, -(_e3942), (_e3942 < 0f)) + select(_e3945, -(_e3945), (_e3945 < 0f))) * (0.000000059604645f * 12f)));
                                                        let _e3963 = local_2.member_1[_e3879];
                                                        let _e3966 = local_2.member[_e3879];
                                                        let _e3967 = (_e3963 - _e3966);
                                                        let _e3970 = ((_e3956 + _e3956) + (_e3857 * ((((select(_e3923, -(_e3923), (_e3923 < 0f)) + select(_e3924, -(_e3924), (_e3924 < 0f))) + select(_e3925, -(_e3925), (_e3925 < 0f))) + (_e3257 * 6f)) * 1.01f)));
                                                        let _e3973 = ((((_e3942 + ((_e3945 - _e3942) * _e1317)) - _e3956) - (_e3857 * ((select(_e3917, _e3906, (_e3906 > _e3917)) + (_e3257 * 3f)) * 1.01f))) - _e3730);
                                                        let _e3974 = (_e3973 > 0.000000000000000000000000000000000000011754944f);
                                                        let _e3975 = (_e3967 > _e3970);
                                                        if _e3975 {
                                                            phi_6603_ = _e3861;
                                                        } else {
                                                            if _e3974 {
                                                                let _e3982 = (_e3970 - _e3967);
                                                                let _e3985 = (_e3973 / select(0.000000000000000000000000000000000000011754944f, _e3982, (_e3982 > 0.000000000000000000000000000000000000011754944f)));
                                                                phi_6602_ = select(_e3985, _e3861, (_e3861 < _e3985));
                                                            } else {
                                                                phi_6602_ = _e3861;
                                                            }
                                                            let _e3989 = phi_6602_;
                                                            phi_6603_ = _e3989;
                                                        }
                                                        let _e3991 = phi_6603_;
                                                        phi_6369_ = _e3991;
                                                        phi_6371_ = (_e3863 && select(_e3974, true, (_e3967 < -(_e3970))));
                                                        phi_6373_ = (_e3865 && select(_e3974, true, _e3975));
                                                    } else {
                                                        phi_6369_ = f32();
                                                        phi_6371_ = bool();
                                                        phi_6373_ = bool();
                                                    }
                                                    let _e3993 = phi_6369_;
                                                    let _e3995 = phi_6371_;
                                                    let _e3997 = phi_6373_;
                                                    continue;
                                                    continuing {
                                                        phi_6365_ = type_9(select(_e3859.member, (_e3859.member + 1u), _e3868), select(_e3859.member_1, _e3859.member_1, _e3868));
                                                        phi_6368_ = _e3993;
                                                        phi_6370_ = _e3995;
                                                        phi_6372_ = _e3997;
                                                        break if !(_e3881);
                                                    }
                                                }
                                                let _e4000 = local_30;
                                                let _e4003 = local_31;
                                                let _e4005 = (select(2f, _e4003, (_e4000 < 2f)) * 0.999f);
                                                let _e4007 = local_32;
                                                if _e4007 {
                                                    let _e4010 = local_33;
                                                    let _e4014 = local_34;
                                                    let _e4018 = local_35;
                                                    phi_6618_ = type_34(select(1u, type_34().member, _e4010), select(_e1317, type_34().member_1, _e4014), select(2f, type_34().member_2, _e4018));
                                                    let _e5168 = local_60;
                                                    phi_6619_ = _e5168;
                                                } else {
                                                    phi_6618_ = type_34();
                                                    phi_6619_ = true;
                                                }
                                                let _e4022 = phi_6618_;
                                                let _e4024 = phi_6619_;
                                                if _e4024 {
                                                    let _e4026 = local_36;
                                                    if _e4026 {
                                                        let _e4030 = (_e1317 + _e4005);
                                                        let _e4033 = select(_e1317, select(_e376, _e4030, (_e4030 < _e376)), (_e4005 > (0.000000059604645f * 4096f)));
                                                        phi_6640_ = type_9(0u, 4u);
                                                        phi_6643_ = _e4033;
                                                        phi_6645_ = _e1317;
                                                        loop {
                                                            let _e4035 = phi_6640_;
                                                            let _e4037 = phi_6643_;
                                                            let _e4039 = phi_6645_;
                                                            local_37 = _e4037;
                                                            local_38 = _e4039;
                                                            local_39 = _e4039;
                                                            let _e4042 = (_e4035.member < _e4035.member_1);
                                                            let _e4053 = select(type_9().member_1, _e4035.member, _e4042);
                                                            let _e4055 = (bitcast<i32>(select(0u, 1u, _e4042)) != 0i);
                                                            if _e4055 {
                                                                let _e4058 = local_2.member[_e4053];
                                                                let _e4061 = local_2.member_1[_e4053];
                                                                let _e4064 = local_2.member[_e4053];
                                                                let _e4070 = local_2.member_2[_e4053];
                                                                let _e4071 = ((_e4058 + ((_e4061 - _e4064) * _e1317)) - _e4070);
                                                                let _e4074 = local_2.member_1[_e4053];
                                                                let _e4077 = local_2.member[_e4053];
                                                                let _e4078 = (_e4074 - _e4077);
                                                                if (_e4078 > 0f) {
                                                                    let _e4091 = (_e1317 - (_e4071 / _e4078));
                                                                    phi_6754_ = _e4037;
                                                                    phi_6755_ = select(_e4091, _e4039, (_e4039 > _e4091));
                                                                } else {
                                                                    if (_e4071 > 0f) {
                                                                        if (_e4078 < 0f) {
                                                                            let _e4083 = (_e1317 - (_e4071 / _e4078));
                                                                            phi_6752_ = select(_e4083, _e4037, (_e4037 < _e4083));
                                                                        } else {
                                                                            phi_6752_ = _e4037;
                                                                        }
                                                                        let _e4087 = phi_6752_;
                                                                        phi_6753_ = _e4087;
                                                                    } else {
                                                                        phi_6753_ = _e4037;
                                                                    }
                                                                    let _e4089 = phi_6753_;
                                                                    phi_6754_ = _e4089;
                                                                    phi_6755_ = _e4039;
                                                                }
                                                                let _e4095 = phi_6754_;
                                                                let _e4097 = phi_6755_;
                                                                phi_6644_ = _e4095;
                                                                phi_6646_ = _e4097;
                                                            } else {
                                                                phi_6644_ = f32();
                                                                phi_6646_ = f32();
                                                            }
                                                            let _e4099 = phi_6644_;
                                                            let _e4101 = phi_6646_;
                                                            continue;
                                                            continuing {
                                                                phi_6640_ = type_9(select(_e4035.member, (_e4035.member + 1u), _e4042), select(_e4035.member_1, _e4035.member_1, _e4042));
                                                                phi_6643_ = _e4099;
                                                                phi_6645_ = _e4101;
                                                                break if !(_e4055);
                                                            }
                                                        }
                                                        let _e4104 = local_37;
                                                        let _e4106 = local_38;
                                                        let _e4110 = local_39;
                                                        let _e4111 = (_e4110 + ((_e4104 - _e4106) * 0.5f));
                                                        if (_e4111 > _e1317) {
                                                            if (_e4111 <= _e4033) {
                                                                let _e4116 = local_2.member[0u];
                                                                let _e4119 = local_2.member_1[0u];
                                                                let _e4122 = local_2.member[0u];
                                                                let _e4128 = local_2.member_2[0u];
                                                                if (((_e4116 + ((_e4119 - _e4122) * _e4111)) - _e4128) > 0f) {
                                                                    let _e4133 = local_2.member[1u];
                                                                    let _e4136 = local_2.member_1[1u];
                                                                    let _e4139 = local_2.member[1u];
                                                                    let _e4145 = local_2.member_2[1u];
                                                                    if (((_e4133 + ((_e4136 - _e4139) * _e4111)) - _e4145) > 0f) {
                                                                        let _e4150 = local_2.member[2u];
                                                                        let _e4153 = local_2.member_1[2u];
                                                                        let _e4156 = local_2.member[2u];
                                                                        let _e4162 = local_2.member_2[2u];
                                                                        if (((_e4150 + ((_e4153 - _e4156) * _e4111)) - _e4162) > 0f) {
                                                                            let _e4167 = local_2.member[3u];
                                                                            let _e4170 = local_2.member_1[3u];
                                                                            let _e4173 = local_2.member[3u];
                                                                            let _e4179 = local_2.member_2[3u];
                                                                            phi_6916_ = (((_e4167 + ((_e4170 - _e4173) * _e4111)) - _e4179) > 0f);
                                                                            phi_6917_ = false;
                                                                        } else {
                                                                            phi_6916_ = bool();
                                                                            phi_6917_ = true;
                                                                        }
                                                                        let _e4183 = phi_6916_;
                                                                        let _e4185 = phi_6917_;
                                                                        phi_6918_ = _e4183;
                                                                        phi_6919_ = _e4185;
                                                                    } else {
                                                                        phi_6918_ = bool();
                                                                        phi_6919_ = true;
                                                                    }
                                                                    let _e4187 = phi_6918_;
                                                                    let _e4189 = phi_6919_;
                                                                    phi_6920_ = _e4187;
                                                                    phi_6921_ = _e4189;
                                                                } else {
                                                                    phi_6920_ = bool();
                                                                    phi_6921_ = true;
                                                                }
                                                                let _e4191 = phi_6920_;
                                                                let _e4193 = phi_6921_;
                                                                phi_6930_ = select(true, false, select(_e4191, false, _e4193));
                                                            } else {
                                                                phi_6930_ = true;
                                                            }
                                                            let _e4197 = phi_6930_;
                                                            phi_6931_ = _e4197;
                                                        } else {
                                                            phi_6931_ = true;
                                                        }
                                                        let _e4199 = phi_6931_;
                                                        phi_6938_ = type_34(2u, _e4033, select(_e4111, 2f, _e4199));
                                                        phi_6939_ = type_34();
                                                        phi_6940_ = false;
                                                    } else {
                                                        phi_6938_ = type_34();
                                                        phi_6939_ = type_34(0u, _e1317, 2f);
                                                        phi_6940_ = true;
                                                    }
                                                    let _e4203 = phi_6938_;
                                                    let _e4205 = phi_6939_;
                                                    let _e4207 = phi_6940_;
                                                    phi_6941_ = _e4203;
                                                    phi_6942_ = _e4205;
                                                    phi_6943_ = _e4207;
                                                } else {
                                                    phi_6941_ = type_34();
                                                    phi_6942_ = _e4022;
                                                    phi_6943_ = true;
                                                }
                                                let _e4209 = phi_6941_;
                                                let _e4211 = phi_6942_;
                                                let _e4213 = phi_6943_;
                                                phi_6948_ = _e4211;
                                                phi_6949_ = _e4209;
                                                phi_6950_ = _e4213;
                                            } else {
                                                phi_6948_ = type_34(0u, _e1317, 2f);
                                                phi_6949_ = type_34();
                                                phi_6950_ = true;
                                            }
                                            let _e4215 = phi_6948_;
                                            let _e4217 = phi_6949_;
                                            let _e4219 = phi_6950_;
                                            phi_6954_ = _e4215;
                                            phi_6955_ = _e4217;
                                            phi_6956_ = false;
                                            phi_6957_ = _e4219;
                                        } else {
                                            phi_6954_ = type_34();
                                            phi_6955_ = type_34();
                                            phi_6956_ = true;
                                            phi_6957_ = false;
                                        }
                                        let _e4221 = phi_6954_;
                                        let _e4223 = phi_6955_;
                                        let _e4225 = phi_6956_;
                                        let _e4227 = phi_6957_;
                                        phi_6958_ = _e4221;
                                        phi_6959_ = _e4223;
                                        phi_6960_ = _e4225;
                                        phi_6961_ = _e4227;
                                    } else {
                                        phi_6958_ = type_34();
                                        phi_6959_ = type_34();
                                        phi_6960_ = true;
                                        phi_6961_ = false;
                                    }
                                    let _e4229 = phi_6958_;
                                    let _e4231 = phi_6959_;
                                    let _e4233 = phi_6960_;
                                    let _e4235 = phi_6961_;
                                    let _e4242 = select(_e4235, true, _e4233);
                                    let _e4244 = select(_e4231.member, select(_e4229.member, 0u, _e4233), _e4242);
                                    let _e4248 = select(_e4231.member_2, select(_e4229.member_2, 2f, _e4233), _e4242);
                                    if select(false, _e368, ((_e378 & 64u) != 0u)) {
                                        let _e4250 = (_e4244 == 2u);
                                        let _e4251 = (_e4248 <= _e376);
                                        phi_6995_ = select(f32(), select(f32(), _e4248, _e4251), _e4250);
                                        phi_6996_ = select(f32(), select(f32(), _e4248, _e4251), _e4250);
                                        phi_6997_ = select(false, _e4251, _e4250);
                                        phi_6998_ = select(false, select(true, false, _e4251), _e4250);
                                        phi_6999_ = select(true, false, _e4250);
                                    } else {
                                        phi_6995_ = f32();
                                        phi_6996_ = f32();
                                        phi_6997_ = false;
                                        phi_6998_ = false;
                                        phi_6999_ = true;
                                    }
                                    let _e4261 = phi_6995_;
                                    let _e4263 = phi_6996_;
                                    let _e4265 = phi_6997_;
                                    let _e4267 = phi_6998_;
                                    let _e4269 = phi_6999_;
                                    phi_7000_ = _e4261;
                                    phi_7001_ = _e4244;
                                    phi_7002_ = _e4263;
                                    phi_7003_ = type_34(_e4244, select(_e4231.member_1, select(_e4229.member_1, _e1317, _e4233), _e4242), _e4248);
                                    phi_7004_ = _e4244;
                                    phi_7005_ = _e4244;
                                    phi_7006_ = _e4265;
                                    phi_7007_ = _e4267;
                                    phi_7008_ = _e4269;
                                }
                                let _e4271 = phi_7000_;
                                let _e4273 = phi_7001_;
                                let _e4275 = phi_7002_;
                                let _e4277 = phi_7003_;
                                let _e4279 = phi_7004_;
                                let _e4281 = phi_7005_;
                                let _e4283 = phi_7006_;
                                let _e4285 = phi_7007_;
                                let _e4287 = phi_7008_;
                                phi_7009_ = _e4271;
                                phi_7010_ = _e4273;
                                phi_7011_ = _e4275;
                                phi_7012_ = _e4277;
                                phi_7013_ = _e4279;
                                phi_7014_ = _e4281;
                                phi_7015_ = _e4283;
                                phi_7016_ = _e2963;
                                phi_7017_ = _e4285;
                                phi_7018_ = _e4287;
                                phi_7019_ = false;
                            } else {
                                phi_7009_ = f32();
                                phi_7010_ = u32();
                                phi_7011_ = f32();
                                phi_7012_ = type_34();
                                phi_7013_ = u32();
                                phi_7014_ = u32();
                                phi_7015_ = false;
                                phi_7016_ = false;
                                phi_7017_ = false;
                                phi_7018_ = false;
                                phi_7019_ = true;
                            }
                            let _e4289 = phi_7009_;
                            let _e4291 = phi_7010_;
                            let _e4293 = phi_7011_;
                            let _e4295 = phi_7012_;
                            let _e4297 = phi_7013_;
                            let _e4299 = phi_7014_;
                            let _e4301 = phi_7015_;
                            let _e4303 = phi_7016_;
                            let _e4305 = phi_7017_;
                            let _e4307 = phi_7018_;
                            let _e4309 = phi_7019_;
                            phi_7020_ = _e2960;
                            phi_2095_ = _e4289;
                            phi_2097_ = _e4291;
                            phi_2099_ = _e4293;
                            phi_7021_ = _e4295;
                            phi_7022_ = _e4297;
                            phi_7023_ = _e2960;
                            phi_7024_ = _e4299;
                            phi_7025_ = _e4301;
                            phi_7026_ = _e4303;
                            phi_7027_ = _e4305;
                            phi_7028_ = _e4307;
                            phi_7029_ = false;
                            phi_7030_ = _e4309;
                        } else {
                            phi_7020_ = f32();
                            phi_2095_ = f32();
                            phi_2097_ = u32();
                            phi_2099_ = f32();
                            phi_7021_ = type_34();
                            phi_7022_ = u32();
                            phi_7023_ = f32();
                            phi_7024_ = u32();
                            phi_7025_ = false;
                            phi_7026_ = false;
                            phi_7027_ = false;
                            phi_7028_ = false;
                            phi_7029_ = true;
                            phi_7030_ = false;
                        }
                        let _e4311 = phi_7020_;
                        let _e4313 = phi_2095_;
                        let _e4315 = phi_2097_;
                        let _e4317 = phi_2099_;
                        let _e4319 = phi_7021_;
                        let _e4321 = phi_7022_;
                        let _e4323 = phi_7023_;
                        let _e4325 = phi_7024_;
                        let _e4327 = phi_7025_;
                        let _e4329 = phi_7026_;
                        let _e4331 = phi_7027_;
                        let _e4333 = phi_7028_;
                        let _e4335 = phi_7029_;
                        let _e4337 = phi_7030_;
                        local_40 = _e4329;
                        local_41 = _e4331;
                        local_42 = _e4329;
                        local_43 = _e4333;
                        local_44 = _e4329;
                        local_45 = _e4335;
                        local_46 = _e4329;
                        local_47 = _e4337;
                        local_48 = _e4319;
                        local_49 = _e4319;
                        local_50 = _e4321;
                        local_51 = _e4319;
                        local_61 = _e4329;
                        local_52 = _e4325;
                        local_54 = _e4323;
                        local_55 = _e4311;
                        continue;
                        continuing {
                            phi_2091_ = _e1335;
                            phi_2094_ = _e4313;
                            phi_2096_ = _e4315;
                            phi_2098_ = _e4317;
                            break if !(_e4327);
                        }
                    }
                    let _e4340 = local_40;
                    let _e4342 = local_41;
                    let _e4343 = select(_e4342, false, _e4340);
                    let _e4345 = local_42;
                    let _e4347 = local_43;
                    let _e4350 = local_44;
                    let _e4352 = local_45;
                    let _e4355 = local_46;
                    let _e4357 = local_47;
                    if _e4343 {
                        let _e4360 = local_48;
                        if (_e4360.member_1 >= _e376) {
                            phi_7059_ = type_33(type_32(0u, f32()), 0u);
                        } else {
                            let _e4364 = local_49;
                            let _e4368 = local_50;
                            let _e4371 = local_51;
                            phi_7059_ = type_33(type_32(2u, _e4371.member_1), select(_e4368, 0u, (_e4364.member_1 > _e374)));
                        }
                        let _e4378 = phi_7059_;
                        phi_7060_ = _e4378;
                        phi_7061_ = false;
                        phi_7062_ = false;
                        phi_7063_ = false;
                        phi_7064_ = false;
                    } else {
                        phi_7060_ = type_33();
                        phi_7061_ = select(_e4347, false, _e4345);
                        let _e5263 = local_61;
                        phi_7062_ = _e5263;
                        phi_7063_ = select(_e4352, false, _e4350);
                        phi_7064_ = select(_e4357, false, _e4355);
                    }
                    let _e4380 = phi_7060_;
                    let _e4382 = phi_7061_;
                    let _e4384 = phi_7062_;
                    let _e4386 = phi_7063_;
                    let _e4388 = phi_7064_;
                    let _e4390 = local_52;
                    let _e4392 = local_53;
                    let _e4395 = local_54;
                    let _e4397 = local_55;
                    let _e4399 = select(_e4384, true, _e4382);
                    let _e4404 = local_56;
                    let _e4405 = select(_e4404, select(_e4397, _e4395, _e4382), _e4399);
                    let _e4407 = local_57;
                    let _e4408 = select(_e4407, select(_e4392, _e4390, _e4382), _e4399);
                    if select(select(_e4386, false, _e4382), true, _e4399) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_7096_ = type_9(0u, 3u);
                        loop {
                            let _e4419 = phi_7096_;
                            let _e4422 = (_e4419.member < _e4419.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4422)) != 0i) {
                                let _e4437 = local[select(type_9().member_1, _e4419.member, _e4422)];
                                let _e4439 = (_e4405 + (select(0f, _e372, (_e372 >= (0.000000059604645f * 8f))) * _e4437));
                                let _e4441 = select(_e376, _e4439, (_e4439 < _e376));
                                let _e4444 = local_5.member[0u];
                                let _e4450 = local_5.member[1u];
                                let _e4466 = local_5.member_1[0u];
                                let _e4472 = local_5.member_1[1u];
                                let _e4488 = local_5.member_2[0u];
                                let _e4494 = local_5.member_2[1u];
                                let _e4508 = function_3(array<f32, 3>((_e4444[0] + ((_e4450[0] - _e4444[0]) * _e4441)), (_e4444[1] + ((_e4450[1] - _e4444[1]) * _e4441)), (_e4444[2] + ((_e4450[2] - _e4444[2]) * _e4441))), array<f32, 3>((_e4466[0] + ((_e4472[0] - _e4466[0]) * _e4441)), (_e4466[1] + ((_e4472[1] - _e4466[1]) * _e4441)), (_e4466[2] + ((_e4472[2] - _e4466[2]) * _e4441))), array<f32, 3>((_e4488[0] + ((_e4494[0] - _e4488[0]) * _e4441)), (_e4488[1] + ((_e4494[1] - _e4488[1]) * _e4441)), (_e4488[2] + ((_e4494[2] - _e4488[2]) * _e4441))), _e219.member);
                                let _e4519 = (((_e4508[0] * _e4508[0]) + (_e4508[1] * _e4508[1])) + (_e4508[2] * _e4508[2]));
                                if (_e4519 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_7328_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4519 > 0f));
                                } else {
                                    phi_7271_ = type_16(0i, 5i);
                                    phi_7274_ = bitcast<f32>(((bitcast<u32>(_e4519) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e4527 = phi_7271_;
                                        let _e4529 = phi_7274_;
                                        local_58 = _e4529;
                                        if (_e4527.member < _e4527.member_1) {
                                            let _e4536 = (_e4527.member + 1i);
                                            phi_7272_ = type_16(select(_e4536, type_17().member_1, select(false, true, ((false == (_e4536 > _e4527.member)) != false))), _e4527.member_1);
                                            phi_7315_ = type_17(1u, _e4527.member);
                                        } else {
                                            phi_7272_ = _e4527;
                                            phi_7315_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e4547 = phi_7272_;
                                        let _e4549 = phi_7315_;
                                        let _e4552 = (bitcast<i32>(_e4549.member) != 0i);
                                        if _e4552 {
                                            phi_7275_ = (0.5f * (_e4529 + (_e4519 / _e4529)));
                                        } else {
                                            phi_7275_ = f32();
                                        }
                                        let _e4557 = phi_7275_;
                                        continue;
                                        continuing {
                                            phi_7271_ = _e4547;
                                            phi_7274_ = _e4557;
                                            break if !(_e4552);
                                        }
                                    }
                                    let _e4562 = local_58;
                                    phi_7328_ = (_e4562 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e4568 = phi_7328_;
                                let _e4574 = local_5.member[0u];
                                let _e4580 = select(_e4574[0], -(_e4574[0]), (_e4574[0] < 0f));
                                let _e4583 = select(_e4574[1], -(_e4574[1]), (_e4574[1] < 0f));
                                let _e4585 = select(_e4583, _e4580, (_e4580 > _e4583));
                                let _e4588 = select(_e4574[2], -(_e4574[2]), (_e4574[2] < 0f));
                                let _e4590 = select(_e4588, _e4585, (_e4585 > _e4588));
                                let _e4593 = local_5.member[1u];
                                let _e4599 = select(_e4593[0], -(_e4593[0]), (_e4593[0] < 0f));
                                let _e4602 = select(_e4593[1], -(_e4593[1]), (_e4593[1] < 0f));
                                let _e4604 = select(_e4602, _e4599, (_e4599 > _e4602));
                                let _e4607 = select(_e4593[2], -(_e4593[2]), (_e4593[2] < 0f));
                                let _e4609 = select(_e4607, _e4604, (_e4604 > _e4607));
                                let _e4613 = local_5.member_3;
                                let _e4617 = local_5.member_1[0u];
                                let _e4623 = select(_e4617[0], -(_e4617[0]), (_e4617[0] < 0f));
                                let _e4626 = select(_e4617[1], -(_e4617[1]), (_e4617[1] < 0f));
                                let _e4628 = select(_e4626, _e4623, (_e4623 > _e4626));
                                let _e4631 = select(_e4617[2], -(_e4617[2]), (_e4617[2] < 0f));
                                let _e4633 = select(_e4631, _e4628, (_e4628 > _e4631));
                                let _e4636 = local_5.member_1[1u];
                                let _e4642 = select(_e4636[0], -(_e4636[0]), (_e4636[0] < 0f));
                                let _e4645 = select(_e4636[1], -(_e4636[1]), (_e4636[1] < 0f));
                                let _e4647 = select(_e4645, _e4642, (_e4642 > _e4645));
                                let _e4650 = select(_e4636[2], -(_e4636[2]), (_e4636[2] < 0f));
                                let _e4652 = select(_e4650, _e4647, (_e4647 > _e4650));
                                let _e4656 = local_5.member_3;
                                let _e4660 = local_5.member_2[0u];
                                let _e4666 = select(_e4660[0], -(_e4660[0]), (_e4660[0] < 0f));
                                let _e4669 = select(_e4660[1], -(_e4660[1]), (_e4660[1] < 0f));
                                let _e4671 = select(_e4669, _e4666, (_e4666 > _e4669));
                                let _e4674 = select(_e4660[2], -(_e4660[2]), (_e4660[2] < 0f));
                                let _e4676 = select(_e4674, _e4671, (_e4671 > _e4674));
                                let _e4679 = local_5.member_2[1u];
                                let _e4685 = select(_e4679[0], -(_e4679[0]), (_e4679[0] < 0f));
                                let _e4688 = select(_e4679[1], -(_e4679[1]), (_e4679[1] < 0f));
                                let _e4690 = select(_e4688, _e4685, (_e4685 > _e4688));
                                let _e4693 = select(_e4679[2], -(_e4679[2]), (_e4679[2] < 0f));
                                let _e4695 = select(_e4693, _e4690, (_e4690 > _e4693));
                                let _e4699 = local_5.member_3;
                                let _e4706 = local_5.member_3;
                                let _e4713 = (((_e4568 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4609, _e4590, (_e4590 > _e4609)) + _e4613) + (select(_e4652, _e4633, (_e4633 > _e4652)) + _e4656)) + (select(_e4695, _e4676, (_e4676 > _e4695)) + _e4699)) * (0.000000059604645f * 16f)) + (_e4706 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e603.member_1);
                                phi_7599_ = select(true, false, _e4713);
                                phi_7600_ = _e4713;
                            } else {
                                phi_7599_ = false;
                                phi_7600_ = false;
                            }
                            let _e4716 = phi_7599_;
                            let _e4718 = phi_7600_;
                            local_59 = _e4718;
                            continue;
                            continuing {
                                phi_7096_ = type_9(select(_e4419.member, (_e4419.member + 1u), _e4422), select(_e4419.member_1, _e4419.member_1, _e4422));
                                break if !(_e4716);
                            }
                        }
                        let _e4721 = local_59;
                        if _e4721 {
                            phi_7612_ = type_33(type_32(1u, _e4405), select(_e4408, 1u, (_e4405 > _e374)));
                            phi_7613_ = false;
                        } else {
                            phi_7612_ = type_33();
                            phi_7613_ = true;
                        }
                        let _e4727 = phi_7612_;
                        let _e4729 = phi_7613_;
                        if _e4729 {
                            phi_7625_ = type_33(type_32(2u, _e4405), select(_e4408, 0u, (_e4405 > _e374)));
                        } else {
                            phi_7625_ = _e4727;
                        }
                        let _e4735 = phi_7625_;
                        phi_7626_ = _e4735;
                        phi_7627_ = false;
                        phi_7628_ = false;
                    } else {
                        phi_7626_ = type_33();
                        phi_7627_ = select(select(_e4388, false, _e4382), false, _e4399);
                        phi_7628_ = select(select(_e4343, false, _e4382), false, _e4399);
                    }
                    let _e4737 = phi_7626_;
                    let _e4739 = phi_7627_;
                    let _e4741 = phi_7628_;
                    if _e4739 {
                        phi_7635_ = type_33(type_32(0u, f32()), 0u);
                        phi_7636_ = true;
                    } else {
                        phi_7635_ = _e4380;
                        phi_7636_ = _e4741;
                    }
                    let _e4745 = phi_7635_;
                    let _e4747 = phi_7636_;
                    phi_7640_ = _e4745;
                    phi_7641_ = _e4737;
                    phi_7642_ = _e4747;
                } else {
                    phi_7640_ = _e1307;
                    phi_7641_ = type_33();
                    phi_7642_ = true;
                }
                let _e4749 = phi_7640_;
                let _e4751 = phi_7641_;
                let _e4753 = phi_7642_;
                if _e4753 {
                    phi_7646_ = _e4749;
                } else {
                    phi_7646_ = _e4751;
                }
                let _e4755 = phi_7646_;
                switch bitcast<i32>(_e4755.member.member) {
                    case 0: {
                        phi_7664_ = type_35(0u, _e4755.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4766 = function_(_e4755.member.member_1);
                        phi_7664_ = type_35(0u, _e4755.member_1, _e4766, true);
                        break;
                    }
                    case 2: {
                        let _e4762 = function_(_e4755.member.member_1);
                        phi_7664_ = type_35(1u, _e4755.member_1, _e4762, true);
                        break;
                    }
                    default: {
                        phi_7664_ = type_35();
                        break;
                    }
                }
                let _e4770 = phi_7664_;
                let _e4774 = params.member.member.member_12;
                let _e4775 = bitcast<u32>(_e4774);
                if (_e4770.member_2[0] == select((_e4775 << bitcast<u32>(29i)), 0u, ((_e4775 & 2147483647u) < 8388608u))) {
                    let _e4785 = params.member.member.member_12;
                    let _e4786 = bitcast<u32>(_e4785);
                    let _e4787 = (_e4786 & 2147483647u);
                    phi_7704_ = (_e4770.member_2[1] == select(((_e4786 ^ _e4787) | ((_e4787 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4787 < 8388608u)));
                } else {
                    phi_7704_ = false;
                }
                let _e4797 = phi_7704_;
                let _e4799 = params.member.member.member_1;
                if ((_e4799 & 128u) != 0u) {
                    phi_7720_ = true;
                } else {
                    let _e4803 = params.member.member.member_1;
                    phi_7720_ = select(false, _e4797, ((_e4803 & 64u) != 0u));
                }
                let _e4808 = phi_7720_;
                phi_7739_ = type_35(select(1u, _e4770.member, select(true, select(true, false, _e4808), _e4770.member_3)), _e4770.member_1, _e4770.member_2, _e4770.member_3);
                phi_7740_ = type_9(_e184, _e187);
            } else {
                phi_7739_ = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_7740_ = type_9(0u, 0u);
            }
            let _e4819 = phi_7739_;
            let _e4821 = phi_7740_;
            let _e4825 = (_e4819.member != 0u);
            let _e4828 = select(false, !(_e4825), _e4819.member_3);
            if _e4828 {
                let _e4832 = (_e4819.member_2[1] >> bitcast<u32>(20i));
                if (_e4832 <= 896u) {
                    phi_7770_ = 0u;
                } else {
                    phi_7770_ = ((((_e4832 - 896u) << bitcast<u32>(23i)) | ((_e4819.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4819.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e4847 = phi_7770_;
                let _e4849 = atomicMin((&earliest.member[0u]), _e4847);
            }
            let _e4852 = params.member.member.member_1;
            if ((_e4852 & 16u) != 0u) {
                if (_e101 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4828 {
                    let _e4858 = atomicAdd((&counters[0u]), 1u);
                    phi_7792_ = _e4858;
                } else {
                    phi_7792_ = 0u;
                }
                let _e4860 = phi_7792_;
                workgroupBarrier();
                if (_e101 == 0u) {
                    let _e4863 = atomicLoad((&counters[0u]));
                    if (_e4863 > 0u) {
                        let _e4866 = atomicAdd((&contacts.member[0u]), _e4863);
                        atomicStore((&counters[1u]), _e4866);
                    }
                }
                workgroupBarrier();
                let _e4869 = atomicLoad((&counters[1u]));
                let _e4870 = (_e4869 + _e4860);
                if _e4828 {
                    let _e4873 = params.member.member_1.member_3;
                    let _e4875 = params.member.member_2.member;
                    if (_e4870 < _e4873) {
                        let _e4877 = (7u * _e4870);
                        atomicStore((&contacts.member[(4u + _e4877)]), _e4875);
                        atomicStore((&contacts.member[(_e4877 + 5u)]), _e4819.member);
                        atomicStore((&contacts.member[(_e4877 + 6u)]), _e4821.member);
                        atomicStore((&contacts.member[(_e4877 + 7u)]), _e4821.member_1);
                        atomicStore((&contacts.member[(_e4877 + 8u)]), _e4819.member_2[0]);
                        atomicStore((&contacts.member[(_e4877 + 9u)]), _e4819.member_2[1]);
                        atomicStore((&contacts.member[(_e4877 + 10u)]), _e4819.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4825 {
                let _e4901 = atomicAdd((&counters[0u]), 1u);
                phi_7858_ = _e4901;
            } else {
                phi_7858_ = 0u;
            }
            let _e4903 = phi_7858_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e4906 = atomicLoad((&counters[0u]));
                if (_e4906 > 0u) {
                    let _e4909 = atomicAdd((&undecided.member[0u]), _e4906);
                    atomicStore((&counters[1u]), _e4909);
                }
            }
            workgroupBarrier();
            let _e4912 = atomicLoad((&counters[1u]));
            let _e4913 = (_e4912 + _e4903);
            if _e4825 {
                let _e4915 = params.member.member_2.member_1;
                if (_e4913 < _e4915) {
                    let _e4917 = (2u * _e4913);
                    atomicStore((&undecided.member[(4u + _e4917)]), _e4821.member);
                    atomicStore((&undecided.member[(_e4917 + 5u)]), _e4821.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_273_ = type_9(select(_e155.member, (_e155.member + 1u), _e158), select(_e155.member_1, _e155.member_1, _e158));
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
