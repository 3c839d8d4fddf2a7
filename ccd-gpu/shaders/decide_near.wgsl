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
    var phi_8631_: array<array<f32, 3>, 4>;

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
        phi_8631_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8631_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8631_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8259_: bool;
    var phi_8292_: array<f32, 3>;
    var phi_8293_: bool;
    var phi_8294_: array<f32, 3>;
    var phi_8295_: bool;
    var phi_8300_: array<f32, 3>;

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
        phi_8259_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8259_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8259_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8292_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8293_ = false;
        } else {
            phi_8292_ = array<f32, 3>();
            phi_8293_ = true;
        }
        let _e129 = phi_8292_;
        let _e131 = phi_8293_;
        phi_8294_ = _e129;
        phi_8295_ = _e131;
    } else {
        phi_8294_ = array<f32, 3>();
        phi_8295_ = true;
    }
    let _e133 = phi_8294_;
    let _e135 = phi_8295_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8300_ = _e136;
    } else {
        phi_8300_ = _e133;
    }
    let _e138 = phi_8300_;
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
    var phi_1093_: bool;
    var phi_1187_: type_33;
    var phi_1188_: bool;
    var phi_1189_: type_33;
    var phi_1190_: bool;
    var phi_1191_: type_33;
    var phi_1192_: bool;
    var phi_1197_: type_33;
    var phi_1367_: type_14;
    var phi_1370_: f32;
    var phi_1368_: type_14;
    var phi_1411_: type_15;
    var phi_1371_: f32;
    var local_7: f32;
    var phi_1424_: f32;
    var phi_2333_: type_35;
    var phi_2334_: bool;
    var phi_2335_: type_35;
    var phi_2336_: bool;
    var phi_2342_: type_14;
    var phi_2345_: f32;
    var phi_2347_: u32;
    var phi_2349_: f32;
    var phi_2343_: type_14;
    var phi_2390_: type_15;
    var phi_2827_: type_9;
    var phi_2830_: f32;
    var phi_2832_: f32;
    var phi_2834_: f32;
    var phi_2836_: f32;
    var phi_2838_: bool;
    var phi_2840_: u32;
    var phi_2991_: array<f32, 3>;
    var phi_3057_: type_14;
    var phi_3060_: f32;
    var phi_3058_: type_14;
    var phi_3101_: type_15;
    var phi_3061_: f32;
    var local_8: f32;
    var phi_3114_: f32;
    var phi_3237_: type_31;
    var phi_3238_: bool;
    var phi_3239_: type_31;
    var phi_3240_: bool;
    var phi_3248_: type_31;
    var phi_3419_: bool;
    var phi_3420_: bool;
    var phi_3421_: bool;
    var phi_3422_: bool;
    var phi_3423_: bool;
    var phi_3424_: bool;
    var phi_3725_: bool;
    var phi_3726_: bool;
    var phi_3727_: bool;
    var phi_3728_: bool;
    var phi_3729_: bool;
    var phi_3730_: bool;
    var phi_3738_: bool;
    var phi_3845_: f32;
    var phi_3846_: bool;
    var phi_3847_: f32;
    var phi_3848_: bool;
    var phi_3849_: f32;
    var phi_3850_: bool;
    var phi_3851_: bool;
    var phi_3913_: f32;
    var phi_3914_: bool;
    var phi_3915_: f32;
    var phi_3916_: bool;
    var phi_3917_: f32;
    var phi_3918_: bool;
    var phi_3919_: bool;
    var phi_3986_: f32;
    var phi_3987_: bool;
    var phi_3988_: f32;
    var phi_3989_: bool;
    var phi_3990_: f32;
    var phi_3991_: bool;
    var phi_3992_: bool;
    var phi_4054_: f32;
    var phi_4055_: bool;
    var phi_4056_: f32;
    var phi_4057_: bool;
    var phi_4058_: f32;
    var phi_4059_: bool;
    var phi_4060_: bool;
    var phi_4234_: type_14;
    var phi_4237_: f32;
    var phi_4235_: type_14;
    var phi_4278_: type_15;
    var phi_4238_: f32;
    var local_9: f32;
    var phi_4291_: f32;
    var phi_4562_: bool;
    var phi_4563_: bool;
    var phi_4589_: f32;
    var phi_4590_: f32;
    var phi_4591_: bool;
    var phi_4592_: bool;
    var phi_4593_: f32;
    var phi_4594_: f32;
    var phi_4595_: f32;
    var phi_4596_: f32;
    var phi_4597_: bool;
    var phi_4598_: bool;
    var phi_4599_: bool;
    var phi_4600_: bool;
    var phi_4601_: f32;
    var phi_4602_: f32;
    var phi_4603_: f32;
    var phi_4604_: f32;
    var phi_4605_: bool;
    var phi_4606_: bool;
    var phi_4607_: bool;
    var phi_4608_: bool;
    var phi_4609_: bool;
    var phi_4610_: f32;
    var phi_4611_: f32;
    var phi_4612_: f32;
    var phi_4613_: f32;
    var phi_4614_: bool;
    var phi_4615_: bool;
    var phi_4616_: bool;
    var phi_4617_: bool;
    var phi_4618_: bool;
    var phi_4951_: f32;
    var phi_4953_: u32;
    var phi_4954_: f32;
    var phi_4955_: bool;
    var phi_4956_: bool;
    var phi_4957_: bool;
    var phi_4958_: u32;
    var phi_4959_: f32;
    var phi_4960_: f32;
    var phi_4961_: f32;
    var phi_4962_: f32;
    var phi_4963_: bool;
    var phi_4964_: u32;
    var phi_4965_: bool;
    var phi_4966_: bool;
    var phi_4967_: bool;
    var phi_4968_: bool;
    var phi_4969_: bool;
    var phi_4970_: bool;
    var phi_4998_: f32;
    var phi_4999_: f32;
    var phi_5000_: f32;
    var phi_5001_: f32;
    var phi_5002_: bool;
    var phi_5003_: u32;
    var phi_5004_: bool;
    var phi_5005_: bool;
    var phi_5006_: bool;
    var phi_5007_: bool;
    var phi_5008_: bool;
    var phi_5009_: bool;
    var phi_2831_: f32;
    var phi_2833_: f32;
    var phi_2835_: f32;
    var phi_2837_: f32;
    var phi_2839_: bool;
    var phi_2841_: u32;
    var phi_5010_: f32;
    var phi_5011_: f32;
    var phi_5012_: bool;
    var phi_5013_: bool;
    var phi_5014_: bool;
    var phi_5015_: bool;
    var phi_5016_: bool;
    var phi_5017_: bool;
    var phi_5018_: bool;
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
    var phi_5085_: f32;
    var phi_5086_: bool;
    var phi_5706_: type_14;
    var phi_5709_: f32;
    var phi_5707_: type_14;
    var phi_5750_: type_15;
    var phi_5710_: f32;
    var local_25: f32;
    var phi_5763_: f32;
    var phi_5998_: type_14;
    var phi_6001_: f32;
    var phi_5999_: type_14;
    var phi_6042_: type_15;
    var phi_6002_: f32;
    var local_26: f32;
    var phi_6055_: f32;
    var phi_6087_: type_14;
    var phi_6090_: f32;
    var phi_6088_: type_14;
    var phi_6131_: type_15;
    var phi_6091_: f32;
    var local_27: f32;
    var phi_6144_: f32;
    var phi_6452_: type_9;
    var phi_6455_: f32;
    var phi_6456_: f32;
    var local_28: f32;
    var local_29: f32;
    var phi_6554_: type_14;
    var phi_6557_: f32;
    var phi_6555_: type_14;
    var phi_6598_: type_15;
    var phi_6558_: f32;
    var local_30: f32;
    var phi_6611_: f32;
    var phi_6616_: type_9;
    var phi_6619_: f32;
    var phi_6621_: bool;
    var phi_6623_: bool;
    var phi_6853_: f32;
    var phi_6854_: f32;
    var phi_6620_: f32;
    var phi_6622_: bool;
    var phi_6624_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_6869_: type_36;
    var phi_6870_: bool;
    var local_37: bool;
    var phi_6891_: type_9;
    var phi_6894_: f32;
    var phi_6896_: f32;
    var phi_7003_: f32;
    var phi_7004_: f32;
    var phi_7005_: f32;
    var phi_7006_: f32;
    var phi_6895_: f32;
    var phi_6897_: f32;
    var local_38: f32;
    var local_39: f32;
    var local_40: f32;
    var phi_7167_: bool;
    var phi_7168_: bool;
    var phi_7169_: bool;
    var phi_7170_: bool;
    var phi_7171_: bool;
    var phi_7172_: bool;
    var phi_7181_: bool;
    var phi_7182_: bool;
    var phi_7189_: type_36;
    var phi_7190_: type_36;
    var phi_7191_: bool;
    var phi_7192_: type_36;
    var phi_7193_: type_36;
    var phi_7194_: bool;
    var phi_7199_: type_36;
    var phi_7200_: type_36;
    var phi_7201_: bool;
    var phi_7205_: type_36;
    var phi_7206_: type_36;
    var phi_7207_: bool;
    var phi_7208_: bool;
    var phi_7209_: type_36;
    var phi_7210_: type_36;
    var phi_7211_: bool;
    var phi_7212_: bool;
    var phi_7246_: f32;
    var phi_7247_: f32;
    var phi_7248_: bool;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var phi_7251_: f32;
    var phi_7252_: u32;
    var phi_7253_: f32;
    var phi_7254_: type_36;
    var phi_7255_: u32;
    var phi_7256_: u32;
    var phi_7257_: bool;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: f32;
    var phi_7261_: u32;
    var phi_7262_: f32;
    var phi_7263_: type_36;
    var phi_7264_: u32;
    var phi_7265_: u32;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: f32;
    var phi_2346_: f32;
    var phi_2348_: u32;
    var phi_2350_: f32;
    var phi_7272_: type_36;
    var phi_7273_: u32;
    var phi_7274_: f32;
    var phi_7275_: u32;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
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
    var phi_7310_: type_35;
    var phi_7311_: type_35;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;
    var local_58: u32;
    var phi_7347_: type_9;
    var phi_7522_: type_14;
    var phi_7525_: f32;
    var phi_7523_: type_14;
    var phi_7566_: type_15;
    var phi_7526_: f32;
    var local_59: f32;
    var phi_7579_: f32;
    var phi_7850_: bool;
    var phi_7851_: bool;
    var local_60: bool;
    var phi_7863_: type_35;
    var phi_7864_: bool;
    var phi_7876_: type_35;
    var phi_7877_: type_35;
    var phi_7878_: bool;
    var phi_7879_: bool;
    var phi_7886_: type_35;
    var phi_7887_: bool;
    var phi_7891_: type_35;
    var phi_7892_: type_35;
    var phi_7893_: bool;
    var phi_7897_: type_35;
    var phi_7915_: type_32;
    var phi_7955_: bool;
    var phi_7971_: bool;
    var phi_7998_: type_9;
    var phi_8027_: bool;
    var phi_8028_: bool;
    var phi_8071_: u32;
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
                let _e517 = select(_e350.member[0][0], -(_e350.member[0][0]), (_e350.member[0][0] < 0f));
                let _e521 = select(_e350.member[0][1], -(_e350.member[0][1]), (_e350.member[0][1] < 0f));
                let _e523 = select(_e521, _e517, (_e517 > _e521));
                let _e527 = select(_e350.member[0][2], -(_e350.member[0][2]), (_e350.member[0][2] < 0f));
                let _e529 = select(_e527, _e523, (_e523 > _e527));
                let _e535 = select(_e350.member[1][0], -(_e350.member[1][0]), (_e350.member[1][0] < 0f));
                let _e539 = select(_e350.member[1][1], -(_e350.member[1][1]), (_e350.member[1][1] < 0f));
                let _e541 = select(_e539, _e535, (_e535 > _e539));
                let _e545 = select(_e350.member[1][2], -(_e350.member[1][2]), (_e350.member[1][2] < 0f));
                let _e547 = select(_e545, _e541, (_e541 > _e545));
                let _e551 = (select(_e547, _e529, (_e529 > _e547)) + _e350.member_3);
                let _e557 = select(_e350.member_1[0][0], -(_e350.member_1[0][0]), (_e350.member_1[0][0] < 0f));
                let _e561 = select(_e350.member_1[0][1], -(_e350.member_1[0][1]), (_e350.member_1[0][1] < 0f));
                let _e563 = select(_e561, _e557, (_e557 > _e561));
                let _e567 = select(_e350.member_1[0][2], -(_e350.member_1[0][2]), (_e350.member_1[0][2] < 0f));
                let _e569 = select(_e567, _e563, (_e563 > _e567));
                let _e575 = select(_e350.member_1[1][0], -(_e350.member_1[1][0]), (_e350.member_1[1][0] < 0f));
                let _e579 = select(_e350.member_1[1][1], -(_e350.member_1[1][1]), (_e350.member_1[1][1] < 0f));
                let _e581 = select(_e579, _e575, (_e575 > _e579));
                let _e585 = select(_e350.member_1[1][2], -(_e350.member_1[1][2]), (_e350.member_1[1][2] < 0f));
                let _e587 = select(_e585, _e581, (_e581 > _e585));
                let _e591 = (select(_e587, _e569, (_e569 > _e587)) + _e350.member_3);
                let _e597 = select(_e350.member_2[0][0], -(_e350.member_2[0][0]), (_e350.member_2[0][0] < 0f));
                let _e601 = select(_e350.member_2[0][1], -(_e350.member_2[0][1]), (_e350.member_2[0][1] < 0f));
                let _e603 = select(_e601, _e597, (_e597 > _e601));
                let _e607 = select(_e350.member_2[0][2], -(_e350.member_2[0][2]), (_e350.member_2[0][2] < 0f));
                let _e609 = select(_e607, _e603, (_e603 > _e607));
                let _e615 = select(_e350.member_2[1][0], -(_e350.member_2[1][0]), (_e350.member_2[1][0] < 0f));
                let _e619 = select(_e350.member_2[1][1], -(_e350.member_2[1][1]), (_e350.member_2[1][1] < 0f));
                let _e621 = select(_e619, _e615, (_e615 > _e619));
                let _e625 = select(_e350.member_2[1][2], -(_e350.member_2[1][2]), (_e350.member_2[1][2] < 0f));
                let _e627 = select(_e625, _e621, (_e621 > _e625));
                let _e631 = (select(_e627, _e609, (_e609 > _e627)) + _e350.member_3);
                let _e633 = select(_e591, _e551, (_e551 > _e591));
                let _e635 = select(_e631, _e633, (_e633 > _e631));
                if (_e635 <= 65536f) {
                    phi_1093_ = (_e635 >= (1f / 65536f));
                } else {
                    phi_1093_ = false;
                }
                let _e640 = phi_1093_;
                if _e640 {
                    phi_1191_ = type_33();
                    phi_1192_ = true;
                } else {
                    if (_e511 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e511) & 2139095040u) != 2139095040u) {
                            let _e647 = (2130706432u - (bitcast<u32>(_e511) & 2139095040u));
                            let _e650 = bitcast<f32>(select(8388608u, _e647, (_e647 > 8388608u)));
                            let _e651 = (_e376 * _e650);
                            phi_1187_ = type_33(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e350.member[0][0] * _e650), (_e350.member[0][1] * _e650), (_e350.member[0][2] * _e650)), array<f32, 3>((_e350.member[1][0] * _e650), (_e350.member[1][1] * _e650), (_e350.member[1][2] * _e650))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_1[0][0] * _e650), (_e350.member_1[0][1] * _e650), (_e350.member_1[0][2] * _e650)), array<f32, 3>((_e350.member_1[1][0] * _e650), (_e350.member_1[1][1] * _e650), (_e350.member_1[1][2] * _e650))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_2[0][0] * _e650), (_e350.member_2[0][1] * _e650), (_e350.member_2[0][2] * _e650)), array<f32, 3>((_e350.member_2[1][0] * _e650), (_e350.member_2[1][1] * _e650), (_e350.member_2[1][2] * _e650))), ((_e350.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e650)), select(_e651, select(0.000000000000000000000000000000000000011754944f, _e651, (_e651 > 0.000000000000000000000000000000000000011754944f)), (_e376 > 0f)));
                            phi_1188_ = false;
                        } else {
                            phi_1187_ = type_33();
                            phi_1188_ = true;
                        }
                        let _e720 = phi_1187_;
                        let _e722 = phi_1188_;
                        phi_1189_ = _e720;
                        phi_1190_ = _e722;
                    } else {
                        phi_1189_ = type_33();
                        phi_1190_ = true;
                    }
                    let _e724 = phi_1189_;
                    let _e726 = phi_1190_;
                    phi_1191_ = _e724;
                    phi_1192_ = _e726;
                }
                let _e728 = phi_1191_;
                let _e730 = phi_1192_;
                if _e730 {
                    phi_1197_ = type_33(_e350, _e376);
                } else {
                    phi_1197_ = _e728;
                }
                let _e733 = phi_1197_;
                local_5 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e733.member.member[0][0], _e733.member.member[0][1], _e733.member.member[0][2]), array<f32, 3>(_e733.member.member[1][0], _e733.member.member[1][1], _e733.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e733.member.member_1[0][0], _e733.member.member_1[0][1], _e733.member.member_1[0][2]), array<f32, 3>(_e733.member.member_1[1][0], _e733.member.member_1[1][1], _e733.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e733.member.member_2[0][0], _e733.member.member_2[0][1], _e733.member.member_2[0][2]), array<f32, 3>(_e733.member.member_2[1][0], _e733.member.member_2[1][1], _e733.member.member_2[1][2])), _e733.member.member_3);
                let _e776 = local_5.member[0u];
                let _e782 = local_5.member[1u];
                let _e798 = local_5.member_1[0u];
                let _e804 = local_5.member_1[1u];
                let _e820 = local_5.member_2[0u];
                let _e826 = local_5.member_2[1u];
                let _e840 = function_3(array<f32, 3>((_e776[0] + ((_e782[0] - _e776[0]) * _e380)), (_e776[1] + ((_e782[1] - _e776[1]) * _e380)), (_e776[2] + ((_e782[2] - _e776[2]) * _e380))), array<f32, 3>((_e798[0] + ((_e804[0] - _e798[0]) * _e380)), (_e798[1] + ((_e804[1] - _e798[1]) * _e380)), (_e798[2] + ((_e804[2] - _e798[2]) * _e380))), array<f32, 3>((_e820[0] + ((_e826[0] - _e820[0]) * _e380)), (_e820[1] + ((_e826[1] - _e820[1]) * _e380)), (_e820[2] + ((_e826[2] - _e820[2]) * _e380))), _e225.member);
                let _e851 = (((_e840[0] * _e840[0]) + (_e840[1] * _e840[1])) + (_e840[2] * _e840[2]));
                if (_e851 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1424_ = select(0f, (0.000000000000000000106433627f * 2f), (_e851 > 0f));
                } else {
                    phi_1367_ = type_14(0i, 5i);
                    phi_1370_ = bitcast<f32>(((bitcast<u32>(_e851) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e859 = phi_1367_;
                        let _e861 = phi_1370_;
                        local_7 = _e861;
                        if (_e859.member < _e859.member_1) {
                            let _e868 = (_e859.member + 1i);
                            phi_1368_ = type_14(select(_e868, type_15().member_1, select(false, true, ((false == (_e868 > _e859.member)) != false))), _e859.member_1);
                            phi_1411_ = type_15(1u, _e859.member);
                        } else {
                            phi_1368_ = _e859;
                            phi_1411_ = type_15(0u, type_15().member_1);
                        }
                        let _e879 = phi_1368_;
                        let _e881 = phi_1411_;
                        let _e884 = (bitcast<i32>(_e881.member) != 0i);
                        if _e884 {
                            phi_1371_ = (0.5f * (_e861 + (_e851 / _e861)));
                        } else {
                            phi_1371_ = f32();
                        }
                        let _e889 = phi_1371_;
                        continue;
                        continuing {
                            phi_1367_ = _e879;
                            phi_1370_ = _e889;
                            break if !(_e884);
                        }
                    }
                    let _e894 = local_7;
                    phi_1424_ = (_e894 * (1f + (8f * 0.000000059604645f)));
                }
                let _e900 = phi_1424_;
                let _e906 = local_5.member[0u];
                let _e912 = select(_e906[0], -(_e906[0]), (_e906[0] < 0f));
                let _e915 = select(_e906[1], -(_e906[1]), (_e906[1] < 0f));
                let _e917 = select(_e915, _e912, (_e912 > _e915));
                let _e920 = select(_e906[2], -(_e906[2]), (_e906[2] < 0f));
                let _e922 = select(_e920, _e917, (_e917 > _e920));
                let _e925 = local_5.member[1u];
                let _e931 = select(_e925[0], -(_e925[0]), (_e925[0] < 0f));
                let _e934 = select(_e925[1], -(_e925[1]), (_e925[1] < 0f));
                let _e936 = select(_e934, _e931, (_e931 > _e934));
                let _e939 = select(_e925[2], -(_e925[2]), (_e925[2] < 0f));
                let _e941 = select(_e939, _e936, (_e936 > _e939));
                let _e945 = local_5.member_3;
                let _e949 = local_5.member_1[0u];
                let _e955 = select(_e949[0], -(_e949[0]), (_e949[0] < 0f));
                let _e958 = select(_e949[1], -(_e949[1]), (_e949[1] < 0f));
                let _e960 = select(_e958, _e955, (_e955 > _e958));
                let _e963 = select(_e949[2], -(_e949[2]), (_e949[2] < 0f));
                let _e965 = select(_e963, _e960, (_e960 > _e963));
                let _e968 = local_5.member_1[1u];
                let _e974 = select(_e968[0], -(_e968[0]), (_e968[0] < 0f));
                let _e977 = select(_e968[1], -(_e968[1]), (_e968[1] < 0f));
                let _e979 = select(_e977, _e974, (_e974 > _e977));
                let _e982 = select(_e968[2], -(_e968[2]), (_e968[2] < 0f));
                let _e984 = select(_e982, _e979, (_e979 > _e982));
                let _e988 = local_5.member_3;
                let _e992 = local_5.member_2[0u];
                let _e998 = select(_e992[0], -(_e992[0]), (_e992[0] < 0f));
                let _e1001 = select(_e992[1], -(_e992[1]), (_e992[1] < 0f));
                let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                let _e1006 = select(_e992[2], -(_e992[2]), (_e992[2] < 0f));
                let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                let _e1011 = local_5.member_2[1u];
                let _e1017 = select(_e1011[0], -(_e1011[0]), (_e1011[0] < 0f));
                let _e1020 = select(_e1011[1], -(_e1011[1]), (_e1011[1] < 0f));
                let _e1022 = select(_e1020, _e1017, (_e1017 > _e1020));
                let _e1025 = select(_e1011[2], -(_e1011[2]), (_e1011[2] < 0f));
                let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                let _e1031 = local_5.member_3;
                let _e1038 = local_5.member_3;
                let _e1045 = (((_e900 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e941, _e922, (_e922 > _e941)) + _e945) + (select(_e984, _e965, (_e965 > _e984)) + _e988)) + (select(_e1027, _e1008, (_e1008 > _e1027)) + _e1031)) * (0.000000059604645f * 16f)) + (_e1038 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e733.member_1);
                if _e1045 {
                    phi_2335_ = type_35();
                    phi_2336_ = true;
                } else {
                    let _e1048 = local_5.member_1[0u];
                    let _e1054 = local_5.member_2[0u];
                    let _e1060 = ((_e1048[1] * _e1054[2]) - (_e1048[2] * _e1054[1]));
                    let _e1063 = ((_e1048[2] * _e1054[0]) - (_e1048[0] * _e1054[2]));
                    let _e1066 = ((_e1048[0] * _e1054[1]) - (_e1048[1] * _e1054[0]));
                    let _e1069 = local_5.member_1[1u];
                    let _e1075 = local_5.member_2[1u];
                    let _e1081 = ((_e1069[1] * _e1075[2]) - (_e1069[2] * _e1075[1]));
                    let _e1084 = ((_e1069[2] * _e1075[0]) - (_e1069[0] * _e1075[2]));
                    let _e1087 = ((_e1069[0] * _e1075[1]) - (_e1069[1] * _e1075[0]));
                    let _e1090 = local_5.member_1[0u];
                    let _e1096 = local_5.member_2[1u];
                    let _e1111 = local_5.member_1[1u];
                    let _e1117 = local_5.member_2[0u];
                    let _e1130 = (((_e1090[1] * _e1096[2]) - (_e1090[2] * _e1096[1])) + ((_e1111[1] * _e1117[2]) - (_e1111[2] * _e1117[1])));
                    let _e1131 = (((_e1090[2] * _e1096[0]) - (_e1090[0] * _e1096[2])) + ((_e1111[2] * _e1117[0]) - (_e1111[0] * _e1117[2])));
                    let _e1132 = (((_e1090[0] * _e1096[1]) - (_e1090[1] * _e1096[0])) + ((_e1111[0] * _e1117[1]) - (_e1111[1] * _e1117[0])));
                    let _e1135 = local_5.member[0u];
                    let _e1146 = local_5.member[1u];
                    let _e1157 = local_5.member[0u];
                    let _e1166 = ((((_e1146[0] * _e1060) + (_e1146[1] * _e1063)) + (_e1146[2] * _e1066)) + (((_e1157[0] * _e1130) + (_e1157[1] * _e1131)) + (_e1157[2] * _e1132)));
                    let _e1169 = local_5.member[0u];
                    let _e1180 = local_5.member[1u];
                    let _e1189 = ((((_e1169[0] * _e1081) + (_e1169[1] * _e1084)) + (_e1169[2] * _e1087)) + (((_e1180[0] * _e1130) + (_e1180[1] * _e1131)) + (_e1180[2] * _e1132)));
                    let _e1192 = local_5.member[1u];
                    let _e1203 = local_5.member[0u];
                    let _e1209 = select(_e1203[0], -(_e1203[0]), (_e1203[0] < 0f));
                    let _e1212 = select(_e1203[1], -(_e1203[1]), (_e1203[1] < 0f));
                    let _e1214 = select(_e1212, _e1209, (_e1209 > _e1212));
                    let _e1217 = select(_e1203[2], -(_e1203[2]), (_e1203[2] < 0f));
                    let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                    let _e1222 = local_5.member[1u];
                    let _e1228 = select(_e1222[0], -(_e1222[0]), (_e1222[0] < 0f));
                    let _e1231 = select(_e1222[1], -(_e1222[1]), (_e1222[1] < 0f));
                    let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                    let _e1236 = select(_e1222[2], -(_e1222[2]), (_e1222[2] < 0f));
                    let _e1238 = select(_e1236, _e1233, (_e1233 > _e1236));
                    let _e1242 = local_5.member_3;
                    let _e1243 = (select(_e1238, _e1219, (_e1219 > _e1238)) + _e1242);
                    let _e1246 = local_5.member_1[0u];
                    let _e1252 = select(_e1246[0], -(_e1246[0]), (_e1246[0] < 0f));
                    let _e1255 = select(_e1246[1], -(_e1246[1]), (_e1246[1] < 0f));
                    let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                    let _e1260 = select(_e1246[2], -(_e1246[2]), (_e1246[2] < 0f));
                    let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                    let _e1265 = local_5.member_1[1u];
                    let _e1271 = select(_e1265[0], -(_e1265[0]), (_e1265[0] < 0f));
                    let _e1274 = select(_e1265[1], -(_e1265[1]), (_e1265[1] < 0f));
                    let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                    let _e1279 = select(_e1265[2], -(_e1265[2]), (_e1265[2] < 0f));
                    let _e1281 = select(_e1279, _e1276, (_e1276 > _e1279));
                    let _e1285 = local_5.member_3;
                    let _e1286 = (select(_e1281, _e1262, (_e1262 > _e1281)) + _e1285);
                    let _e1289 = local_5.member_2[0u];
                    let _e1295 = select(_e1289[0], -(_e1289[0]), (_e1289[0] < 0f));
                    let _e1298 = select(_e1289[1], -(_e1289[1]), (_e1289[1] < 0f));
                    let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                    let _e1303 = select(_e1289[2], -(_e1289[2]), (_e1289[2] < 0f));
                    let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                    let _e1308 = local_5.member_2[1u];
                    let _e1314 = select(_e1308[0], -(_e1308[0]), (_e1308[0] < 0f));
                    let _e1317 = select(_e1308[1], -(_e1308[1]), (_e1308[1] < 0f));
                    let _e1319 = select(_e1317, _e1314, (_e1314 > _e1317));
                    let _e1322 = select(_e1308[2], -(_e1308[2]), (_e1308[2] < 0f));
                    let _e1324 = select(_e1322, _e1319, (_e1319 > _e1322));
                    let _e1328 = local_5.member_3;
                    let _e1329 = (select(_e1324, _e1305, (_e1305 > _e1324)) + _e1328);
                    let _e1331 = ((_e1286 * 8f) * _e1329);
                    let _e1338 = local_5.member_3;
                    let _e1362 = ((select(_e1060, -(_e1060), (_e1060 < 0f)) + select(_e1063, -(_e1063), (_e1063 < 0f))) + select(_e1066, -(_e1066), (_e1066 < 0f)));
                    let _e1373 = ((select(_e1081, -(_e1081), (_e1081 < 0f)) + select(_e1084, -(_e1084), (_e1084 < 0f))) + select(_e1087, -(_e1087), (_e1087 < 0f)));
                    let _e1375 = select(_e1373, _e1362, (_e1362 > _e1373));
                    let _e1387 = (((select(_e1130, -(_e1130), (_e1130 < 0f)) + select(_e1131, -(_e1131), (_e1131 < 0f))) + select(_e1132, -(_e1132), (_e1132 < 0f))) * 0.5f);
                    let _e1394 = local_5.member_3;
                    let _e1407 = ((((_e1135[0] * _e1060) + (_e1135[1] * _e1063)) + (_e1135[2] * _e1066)) * 3f);
                    let _e1408 = ((((_e1192[0] * _e1081) + (_e1192[1] * _e1084)) + (_e1192[2] * _e1087)) * 3f);
                    let _e1410 = select(_e1408, _e1407, (_e1407 < _e1408));
                    let _e1412 = select(_e1189, _e1166, (_e1166 < _e1189));
                    let _e1414 = select(_e1412, _e1410, (_e1410 < _e1412));
                    let _e1416 = select(_e1408, _e1407, (_e1407 > _e1408));
                    let _e1418 = select(_e1189, _e1166, (_e1166 > _e1189));
                    let _e1421 = -(select(_e1418, _e1416, (_e1416 > _e1418)));
                    if ((select(_e1421, _e1414, (_e1414 > _e1421)) - ((((((_e1243 * 8f) * _e1331) * (0.000000059604645f * (524f / 64f))) + ((_e1338 * 19f) * ((_e1243 * (_e1286 + _e1329)) + (_e1286 * _e1329)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1243) * ((1f + _e1286) * (1f + _e1329))))) + ((_e733.member_1 * (((select(_e1387, _e1375, (_e1375 > _e1387)) + (_e1331 * (0.000000059604645f * 8f))) + ((_e1394 * 6f) * (_e1286 + _e1329))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1286) * (1f + _e1329))))) * (3f * 1.0001f)))) > 0f) {
                        phi_2333_ = type_35(type_34(0u, f32()), 0u);
                        phi_2334_ = false;
                    } else {
                        phi_2333_ = type_35();
                        phi_2334_ = true;
                    }
                    let _e1433 = phi_2333_;
                    let _e1435 = phi_2334_;
                    phi_2335_ = _e1433;
                    phi_2336_ = _e1435;
                }
                let _e1437 = phi_2335_;
                let _e1439 = phi_2336_;
                if _e1439 {
                    phi_2342_ = type_14(0i, 2i);
                    phi_2345_ = _e380;
                    phi_2347_ = 0u;
                    phi_2349_ = _e380;
                    loop {
                        let _e1441 = phi_2342_;
                        let _e1443 = phi_2345_;
                        let _e1445 = phi_2347_;
                        let _e1447 = phi_2349_;
                        local_54 = _e1445;
                        local_57 = _e1443;
                        local_58 = _e1445;
                        if (_e1441.member < _e1441.member_1) {
                            let _e1454 = (_e1441.member + 1i);
                            phi_2343_ = type_14(select(_e1454, type_15().member_1, select(false, true, ((false == (_e1454 > _e1441.member)) != false))), _e1441.member_1);
                            phi_2390_ = type_15(1u, _e1441.member);
                        } else {
                            phi_2343_ = _e1441;
                            phi_2390_ = type_15(0u, type_15().member_1);
                        }
                        let _e1465 = phi_2343_;
                        let _e1467 = phi_2390_;
                        if (bitcast<i32>(_e1467.member) != 0i) {
                            if select(select(true, false, _e1045), true, (_e1467.member_1 > 0i)) {
                                let _e1477 = local_5.member[0u];
                                let _e1483 = local_5.member_1[0u];
                                let _e1489 = local_5.member_2[0u];
                                let _e1493 = (_e1477[0] - _e1483[0]);
                                let _e1494 = (_e1477[1] - _e1483[1]);
                                let _e1495 = (_e1477[2] - _e1483[2]);
                                let _e1496 = (_e225.member == 0u);
                                let _e1508 = local_5.member[1u];
                                let _e1514 = local_5.member_1[1u];
                                let _e1520 = local_5.member_2[1u];
                                let _e1524 = (_e1508[0] - _e1514[0]);
                                let _e1525 = (_e1508[1] - _e1514[1]);
                                let _e1526 = (_e1508[2] - _e1514[2]);
                                let _e1527 = (_e225.member == 0u);
                                let _e1539 = local_5.member[0u];
                                let _e1545 = select(_e1539[0], -(_e1539[0]), (_e1539[0] < 0f));
                                let _e1548 = select(_e1539[1], -(_e1539[1]), (_e1539[1] < 0f));
                                let _e1550 = select(_e1548, _e1545, (_e1545 > _e1548));
                                let _e1553 = select(_e1539[2], -(_e1539[2]), (_e1539[2] < 0f));
                                let _e1555 = select(_e1553, _e1550, (_e1550 > _e1553));
                                let _e1558 = local_5.member[1u];
                                let _e1564 = select(_e1558[0], -(_e1558[0]), (_e1558[0] < 0f));
                                let _e1567 = select(_e1558[1], -(_e1558[1]), (_e1558[1] < 0f));
                                let _e1569 = select(_e1567, _e1564, (_e1564 > _e1567));
                                let _e1572 = select(_e1558[2], -(_e1558[2]), (_e1558[2] < 0f));
                                let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                let _e1578 = local_5.member_3;
                                let _e1582 = local_5.member_1[0u];
                                let _e1588 = select(_e1582[0], -(_e1582[0]), (_e1582[0] < 0f));
                                let _e1591 = select(_e1582[1], -(_e1582[1]), (_e1582[1] < 0f));
                                let _e1593 = select(_e1591, _e1588, (_e1588 > _e1591));
                                let _e1596 = select(_e1582[2], -(_e1582[2]), (_e1582[2] < 0f));
                                let _e1598 = select(_e1596, _e1593, (_e1593 > _e1596));
                                let _e1601 = local_5.member_1[1u];
                                let _e1607 = select(_e1601[0], -(_e1601[0]), (_e1601[0] < 0f));
                                let _e1610 = select(_e1601[1], -(_e1601[1]), (_e1601[1] < 0f));
                                let _e1612 = select(_e1610, _e1607, (_e1607 > _e1610));
                                let _e1615 = select(_e1601[2], -(_e1601[2]), (_e1601[2] < 0f));
                                let _e1617 = select(_e1615, _e1612, (_e1612 > _e1615));
                                let _e1621 = local_5.member_3;
                                let _e1625 = local_5.member_2[0u];
                                let _e1631 = select(_e1625[0], -(_e1625[0]), (_e1625[0] < 0f));
                                let _e1634 = select(_e1625[1], -(_e1625[1]), (_e1625[1] < 0f));
                                let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                let _e1639 = select(_e1625[2], -(_e1625[2]), (_e1625[2] < 0f));
                                let _e1641 = select(_e1639, _e1636, (_e1636 > _e1639));
                                let _e1644 = local_5.member_2[1u];
                                let _e1650 = select(_e1644[0], -(_e1644[0]), (_e1644[0] < 0f));
                                let _e1653 = select(_e1644[1], -(_e1644[1]), (_e1644[1] < 0f));
                                let _e1655 = select(_e1653, _e1650, (_e1650 > _e1653));
                                let _e1658 = select(_e1644[2], -(_e1644[2]), (_e1644[2] < 0f));
                                let _e1660 = select(_e1658, _e1655, (_e1655 > _e1658));
                                let _e1664 = local_5.member_3;
                                let _e1671 = local_5.member_3;
                                let _e1676 = (_e378 * 0.00390625f);
                                local_3 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_2827_ = type_9(0u, 96u);
                                phi_2830_ = _e1447;
                                phi_2832_ = _e1447;
                                phi_2834_ = (_e382 - _e1447);
                                phi_2836_ = _e1447;
                                phi_2838_ = false;
                                phi_2840_ = 0u;
                                loop {
                                    let _e1679 = phi_2827_;
                                    let _e1681 = phi_2830_;
                                    let _e1683 = phi_2832_;
                                    let _e1685 = phi_2834_;
                                    let _e1687 = phi_2836_;
                                    let _e1689 = phi_2838_;
                                    let _e1691 = phi_2840_;
                                    local_20 = _e1681;
                                    local_24 = _e1683;
                                    let _e1694 = (_e1679.member < _e1679.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1694)) != 0i) {
                                        let _e1708 = local_5.member[0u];
                                        let _e1714 = local_5.member[1u];
                                        let _e1730 = local_5.member_1[0u];
                                        let _e1736 = local_5.member_1[1u];
                                        let _e1752 = local_5.member_2[0u];
                                        let _e1758 = local_5.member_2[1u];
                                        let _e1772 = function_3(array<f32, 3>((_e1708[0] + ((_e1714[0] - _e1708[0]) * _e1681)), (_e1708[1] + ((_e1714[1] - _e1708[1]) * _e1681)), (_e1708[2] + ((_e1714[2] - _e1708[2]) * _e1681))), array<f32, 3>((_e1730[0] + ((_e1736[0] - _e1730[0]) * _e1681)), (_e1730[1] + ((_e1736[1] - _e1730[1]) * _e1681)), (_e1730[2] + ((_e1736[2] - _e1730[2]) * _e1681))), array<f32, 3>((_e1752[0] + ((_e1758[0] - _e1752[0]) * _e1681)), (_e1752[1] + ((_e1758[1] - _e1752[1]) * _e1681)), (_e1752[2] + ((_e1758[2] - _e1752[2]) * _e1681))), _e225.member);
                                        if (_e1691 == 0u) {
                                            phi_2991_ = _e1772;
                                        } else {
                                            phi_2991_ = array<f32, 3>(select(0f, _e1772[0], (_e1691 == 1u)), select(0f, _e1772[1], (_e1691 == 2u)), select(0f, _e1772[2], (_e1691 == 3u)));
                                        }
                                        let _e1785 = phi_2991_;
                                        let _e1799 = ((select(_e1785[0], -(_e1785[0]), (_e1785[0] < 0f)) + select(_e1785[1], -(_e1785[1]), (_e1785[1] < 0f))) + select(_e1785[2], -(_e1785[2]), (_e1785[2] < 0f)));
                                        if (_e1799 > 0f) {
                                            if ((bitcast<u32>(_e1799) & 2139095040u) != 2139095040u) {
                                                let _e1804 = (1f / _e1799);
                                                let _e1806 = (_e1785[0] * _e1804);
                                                let _e1808 = (_e1785[1] * _e1804);
                                                let _e1810 = (_e1785[2] * _e1804);
                                                let _e1815 = (((_e1806 * _e1806) + (_e1808 * _e1808)) + (_e1810 * _e1810));
                                                if (_e1815 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_3114_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1815 > 0f));
                                                } else {
                                                    phi_3057_ = type_14(0i, 5i);
                                                    phi_3060_ = bitcast<f32>(((bitcast<u32>(_e1815) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1823 = phi_3057_;
                                                        let _e1825 = phi_3060_;
                                                        local_8 = _e1825;
                                                        if (_e1823.member < _e1823.member_1) {
                                                            let _e1832 = (_e1823.member + 1i);
                                                            phi_3058_ = type_14(select(_e1832, type_15().member_1, select(false, true, ((false == (_e1832 > _e1823.member)) != false))), _e1823.member_1);
                                                            phi_3101_ = type_15(1u, _e1823.member);
                                                        } else {
                                                            phi_3058_ = _e1823;
                                                            phi_3101_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1843 = phi_3058_;
                                                        let _e1845 = phi_3101_;
                                                        let _e1848 = (bitcast<i32>(_e1845.member) != 0i);
                                                        if _e1848 {
                                                            phi_3061_ = (0.5f * (_e1825 + (_e1815 / _e1825)));
                                                        } else {
                                                            phi_3061_ = f32();
                                                        }
                                                        let _e1853 = phi_3061_;
                                                        continue;
                                                        continuing {
                                                            phi_3057_ = _e1843;
                                                            phi_3060_ = _e1853;
                                                            break if !(_e1848);
                                                        }
                                                    }
                                                    let _e1858 = local_8;
                                                    phi_3114_ = (_e1858 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1864 = phi_3114_;
                                                let _e1865 = (0.000000059604645f * 12f);
                                                let _e1870 = ((((((((select(_e1574, _e1555, (_e1555 > _e1574)) + _e1578) + (select(_e1617, _e1598, (_e1598 > _e1617)) + _e1621)) + (select(_e1660, _e1641, (_e1641 > _e1660)) + _e1664)) * (0.000000059604645f * 16f)) + (_e1671 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e733.member_1 * _e1864) * (1f + _e1865)));
                                                let _e1875 = (((_e1806 * _e1477[0]) + (_e1808 * _e1477[1])) + (_e1810 * _e1477[2]));
                                                let _e1880 = (((_e1806 * _e1493) + (_e1808 * _e1494)) + (_e1810 * _e1495));
                                                let _e1885 = (((_e1806 * (_e1477[0] - _e1489[0])) + (_e1808 * (_e1477[1] - _e1489[1]))) + (_e1810 * (_e1477[2] - _e1489[2])));
                                                let _e1890 = (((_e1806 * select((_e1493 - _e1489[0]), _e1477[0], _e1496)) + (_e1808 * select((_e1494 - _e1489[1]), _e1477[1], _e1496))) + (_e1810 * select((_e1495 - _e1489[2]), _e1477[2], _e1496)));
                                                let _e1896 = (((_e1806 * _e1508[0]) + (_e1808 * _e1508[1])) + (_e1810 * _e1508[2]));
                                                let _e1901 = (((_e1806 * _e1524) + (_e1808 * _e1525)) + (_e1810 * _e1526));
                                                let _e1906 = (((_e1806 * (_e1508[0] - _e1520[0])) + (_e1808 * (_e1508[1] - _e1520[1]))) + (_e1810 * (_e1508[2] - _e1520[2])));
                                                let _e1911 = (((_e1806 * select((_e1524 - _e1520[0]), _e1508[0], _e1527)) + (_e1808 * select((_e1525 - _e1520[1]), _e1508[1], _e1527))) + (_e1810 * select((_e1526 - _e1520[2]), _e1508[2], _e1527)));
                                                phi_3237_ = type_31(array<f32, 4>(_e1875, _e1880, _e1885, _e1890), array<f32, 4>(_e1896, _e1901, _e1906, _e1911), array<f32, 4>((_e1870 + ((select(_e1875, -(_e1875), (_e1875 < 0f)) + select(_e1896, -(_e1896), (_e1896 < 0f))) * _e1865)), (_e1870 + ((select(_e1880, -(_e1880), (_e1880 < 0f)) + select(_e1901, -(_e1901), (_e1901 < 0f))) * _e1865)), (_e1870 + ((select(_e1885, -(_e1885), (_e1885 < 0f)) + select(_e1906, -(_e1906), (_e1906 < 0f))) * _e1865)), (_e1870 + ((select(_e1890, -(_e1890), (_e1890 < 0f)) + select(_e1911, -(_e1911), (_e1911 < 0f))) * _e1865))));
                                                phi_3238_ = false;
                                            } else {
                                                phi_3237_ = type_31();
                                                phi_3238_ = true;
                                            }
                                            let _e1952 = phi_3237_;
                                            let _e1954 = phi_3238_;
                                            phi_3239_ = _e1952;
                                            phi_3240_ = _e1954;
                                        } else {
                                            phi_3239_ = type_31();
                                            phi_3240_ = true;
                                        }
                                        let _e1956 = phi_3239_;
                                        let _e1958 = phi_3240_;
                                        if _e1958 {
                                            phi_3248_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_3248_ = _e1956;
                                        }
                                        let _e1960 = phi_3248_;
                                        local_4 = type_31(array<f32, 4>(_e1960.member[0], _e1960.member[1], _e1960.member[2], _e1960.member[3]), array<f32, 4>(_e1960.member_1[0], _e1960.member_1[1], _e1960.member_1[2], _e1960.member_1[3]), array<f32, 4>(_e1960.member_2[0], _e1960.member_2[1], _e1960.member_2[2], _e1960.member_2[3]));
                                        let _e1980 = (_e1681 - _e1687);
                                        let _e1984 = local_4.member[0u];
                                        let _e1987 = local_4.member_1[0u];
                                        let _e1990 = local_4.member[0u];
                                        let _e1996 = local_4.member_2[0u];
                                        if (((_e1984 + ((_e1987 - _e1990) * _e1681)) - _e1996) > 0f) {
                                            let _e2001 = local_4.member[1u];
                                            let _e2004 = local_4.member_1[1u];
                                            let _e2007 = local_4.member[1u];
                                            let _e2013 = local_4.member_2[1u];
                                            if (((_e2001 + ((_e2004 - _e2007) * _e1681)) - _e2013) > 0f) {
                                                let _e2018 = local_4.member[2u];
                                                let _e2021 = local_4.member_1[2u];
                                                let _e2024 = local_4.member[2u];
                                                let _e2030 = local_4.member_2[2u];
                                                if (((_e2018 + ((_e2021 - _e2024) * _e1681)) - _e2030) > 0f) {
                                                    let _e2035 = local_4.member[3u];
                                                    let _e2038 = local_4.member_1[3u];
                                                    let _e2041 = local_4.member[3u];
                                                    let _e2047 = local_4.member_2[3u];
                                                    phi_3419_ = (((_e2035 + ((_e2038 - _e2041) * _e1681)) - _e2047) > 0f);
                                                    phi_3420_ = false;
                                                } else {
                                                    phi_3419_ = bool();
                                                    phi_3420_ = true;
                                                }
                                                let _e2051 = phi_3419_;
                                                let _e2053 = phi_3420_;
                                                phi_3421_ = _e2051;
                                                phi_3422_ = _e2053;
                                            } else {
                                                phi_3421_ = bool();
                                                phi_3422_ = true;
                                            }
                                            let _e2055 = phi_3421_;
                                            let _e2057 = phi_3422_;
                                            phi_3423_ = _e2055;
                                            phi_3424_ = _e2057;
                                        } else {
                                            phi_3423_ = bool();
                                            phi_3424_ = true;
                                        }
                                        let _e2059 = phi_3423_;
                                        let _e2061 = phi_3424_;
                                        if select(_e2059, false, _e2061) {
                                            if (_e1681 <= _e1683) {
                                                phi_3738_ = true;
                                            } else {
                                                let _e2066 = local_3.member[0u];
                                                let _e2069 = local_3.member_1[0u];
                                                let _e2072 = local_3.member[0u];
                                                let _e2078 = local_3.member_2[0u];
                                                let _e2082 = local_4.member[0u];
                                                let _e2085 = local_4.member_1[0u];
                                                let _e2088 = local_4.member[0u];
                                                let _e2094 = local_4.member_2[0u];
                                                if ((((_e2066 + ((_e2069 - _e2072) * _e1681)) - _e2078) + ((_e2082 + ((_e2085 - _e2088) * _e1687)) - _e2094)) > 0f) {
                                                    let _e2100 = local_3.member[1u];
                                                    let _e2103 = local_3.member_1[1u];
                                                    let _e2106 = local_3.member[1u];
                                                    let _e2112 = local_3.member_2[1u];
                                                    let _e2116 = local_4.member[1u];
                                                    let _e2119 = local_4.member_1[1u];
                                                    let _e2122 = local_4.member[1u];
                                                    let _e2128 = local_4.member_2[1u];
                                                    if ((((_e2100 + ((_e2103 - _e2106) * _e1681)) - _e2112) + ((_e2116 + ((_e2119 - _e2122) * _e1687)) - _e2128)) > 0f) {
                                                        let _e2134 = local_3.member[2u];
                                                        let _e2137 = local_3.member_1[2u];
                                                        let _e2140 = local_3.member[2u];
                                                        let _e2146 = local_3.member_2[2u];
                                                        let _e2150 = local_4.member[2u];
                                                        let _e2153 = local_4.member_1[2u];
                                                        let _e2156 = local_4.member[2u];
                                                        let _e2162 = local_4.member_2[2u];
                                                        if ((((_e2134 + ((_e2137 - _e2140) * _e1681)) - _e2146) + ((_e2150 + ((_e2153 - _e2156) * _e1687)) - _e2162)) > 0f) {
                                                            let _e2168 = local_3.member[3u];
                                                            let _e2171 = local_3.member_1[3u];
                                                            let _e2174 = local_3.member[3u];
                                                            let _e2180 = local_3.member_2[3u];
                                                            let _e2184 = local_4.member[3u];
                                                            let _e2187 = local_4.member_1[3u];
                                                            let _e2190 = local_4.member[3u];
                                                            let _e2196 = local_4.member_2[3u];
                                                            phi_3725_ = ((((_e2168 + ((_e2171 - _e2174) * _e1681)) - _e2180) + ((_e2184 + ((_e2187 - _e2190) * _e1687)) - _e2196)) > 0f);
                                                            phi_3726_ = false;
                                                        } else {
                                                            phi_3725_ = bool();
                                                            phi_3726_ = true;
                                                        }
                                                        let _e2201 = phi_3725_;
                                                        let _e2203 = phi_3726_;
                                                        phi_3727_ = _e2201;
                                                        phi_3728_ = _e2203;
                                                    } else {
                                                        phi_3727_ = bool();
                                                        phi_3728_ = true;
                                                    }
                                                    let _e2205 = phi_3727_;
                                                    let _e2207 = phi_3728_;
                                                    phi_3729_ = _e2205;
                                                    phi_3730_ = _e2207;
                                                } else {
                                                    phi_3729_ = bool();
                                                    phi_3730_ = true;
                                                }
                                                let _e2209 = phi_3729_;
                                                let _e2211 = phi_3730_;
                                                phi_3738_ = select(_e2209, false, _e2211);
                                            }
                                            let _e2214 = phi_3738_;
                                            if _e2214 {
                                                if select(true, select(true, false, (_e1681 >= _e382)), _e1689) {
                                                    local_3 = type_31(array<f32, 4>(_e1960.member[0], _e1960.member[1], _e1960.member[2], _e1960.member[3]), array<f32, 4>(_e1960.member_1[0], _e1960.member_1[1], _e1960.member_1[2], _e1960.member_1[3]), array<f32, 4>(_e1960.member_2[0], _e1960.member_2[1], _e1960.member_2[2], _e1960.member_2[3]));
                                                    let _e2239 = local_3.member[0u];
                                                    let _e2242 = local_3.member_1[0u];
                                                    let _e2245 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2242 > _e2245)), (_e2239 > _e2245)) {
                                                        let _e2250 = (_e2242 >= _e2239);
                                                        if _e2250 {
                                                            phi_3847_ = f32();
                                                            phi_3848_ = false;
                                                        } else {
                                                            if ((_e2239 - _e2242) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3845_ = (((_e2239 - _e2245) / (_e2239 - _e2242)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3846_ = false;
                                                            } else {
                                                                phi_3845_ = f32();
                                                                phi_3846_ = true;
                                                            }
                                                            let _e2261 = phi_3845_;
                                                            let _e2263 = phi_3846_;
                                                            phi_3847_ = _e2261;
                                                            phi_3848_ = _e2263;
                                                        }
                                                        let _e2265 = phi_3847_;
                                                        let _e2267 = phi_3848_;
                                                        phi_3849_ = _e2265;
                                                        phi_3850_ = _e2250;
                                                        phi_3851_ = _e2267;
                                                    } else {
                                                        phi_3849_ = f32();
                                                        phi_3850_ = true;
                                                        phi_3851_ = false;
                                                    }
                                                    let _e2269 = phi_3849_;
                                                    let _e2271 = phi_3850_;
                                                    let _e2273 = phi_3851_;
                                                    let _e2276 = select(_e2269, select(_e1681, 2f, _e2271), select(_e2273, true, _e2271));
                                                    let _e2279 = local_3.member[1u];
                                                    let _e2282 = local_3.member_1[1u];
                                                    let _e2285 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2282 > _e2285)), (_e2279 > _e2285)) {
                                                        let _e2290 = (_e2282 >= _e2279);
                                                        if _e2290 {
                                                            phi_3915_ = f32();
                                                            phi_3916_ = false;
                                                        } else {
                                                            if ((_e2279 - _e2282) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3913_ = (((_e2279 - _e2285) / (_e2279 - _e2282)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3914_ = false;
                                                            } else {
                                                                phi_3913_ = f32();
                                                                phi_3914_ = true;
                                                            }
                                                            let _e2301 = phi_3913_;
                                                            let _e2303 = phi_3914_;
                                                            phi_3915_ = _e2301;
                                                            phi_3916_ = _e2303;
                                                        }
                                                        let _e2305 = phi_3915_;
                                                        let _e2307 = phi_3916_;
                                                        phi_3917_ = _e2305;
                                                        phi_3918_ = _e2290;
                                                        phi_3919_ = _e2307;
                                                    } else {
                                                        phi_3917_ = f32();
                                                        phi_3918_ = true;
                                                        phi_3919_ = false;
                                                    }
                                                    let _e2309 = phi_3917_;
                                                    let _e2311 = phi_3918_;
                                                    let _e2313 = phi_3919_;
                                                    let _e2316 = select(_e2309, select(_e1681, 2f, _e2311), select(_e2313, true, _e2311));
                                                    let _e2318 = select(_e2316, _e2276, (_e2276 < _e2316));
                                                    let _e2321 = local_3.member[2u];
                                                    let _e2324 = local_3.member_1[2u];
                                                    let _e2327 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2324 > _e2327)), (_e2321 > _e2327)) {
                                                        let _e2332 = (_e2324 >= _e2321);
                                                        if _e2332 {
                                                            phi_3988_ = f32();
                                                            phi_3989_ = false;
                                                        } else {
                                                            if ((_e2321 - _e2324) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3986_ = (((_e2321 - _e2327) / (_e2321 - _e2324)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3987_ = false;
                                                            } else {
                                                                phi_3986_ = f32();
                                                                phi_3987_ = true;
                                                            }
                                                            let _e2343 = phi_3986_;
                                                            let _e2345 = phi_3987_;
                                                            phi_3988_ = _e2343;
                                                            phi_3989_ = _e2345;
                                                        }
                                                        let _e2347 = phi_3988_;
                                                        let _e2349 = phi_3989_;
                                                        phi_3990_ = _e2347;
                                                        phi_3991_ = _e2332;
                                                        phi_3992_ = _e2349;
                                                    } else {
                                                        phi_3990_ = f32();
                                                        phi_3991_ = true;
                                                        phi_3992_ = false;
                                                    }
                                                    let _e2351 = phi_3990_;
                                                    let _e2353 = phi_3991_;
                                                    let _e2355 = phi_3992_;
                                                    let _e2358 = select(_e2351, select(_e1681, 2f, _e2353), select(_e2355, true, _e2353));
                                                    let _e2361 = local_3.member[3u];
                                                    let _e2364 = local_3.member_1[3u];
                                                    let _e2367 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2364 > _e2367)), (_e2361 > _e2367)) {
                                                        let _e2372 = (_e2364 >= _e2361);
                                                        if _e2372 {
                                                            phi_4056_ = f32();
                                                            phi_4057_ = false;
                                                        } else {
                                                            if ((_e2361 - _e2364) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_4054_ = (((_e2361 - _e2367) / (_e2361 - _e2364)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_4055_ = false;
                                                            } else {
                                                                phi_4054_ = f32();
                                                                phi_4055_ = true;
                                                            }
                                                            let _e2383 = phi_4054_;
                                                            let _e2385 = phi_4055_;
                                                            phi_4056_ = _e2383;
                                                            phi_4057_ = _e2385;
                                                        }
                                                        let _e2387 = phi_4056_;
                                                        let _e2389 = phi_4057_;
                                                        phi_4058_ = _e2387;
                                                        phi_4059_ = _e2372;
                                                        phi_4060_ = _e2389;
                                                    } else {
                                                        phi_4058_ = f32();
                                                        phi_4059_ = true;
                                                        phi_4060_ = false;
                                                    }
                                                    let _e2391 = phi_4058_;
                                                    let _e2393 = phi_4059_;
                                                    let _e2395 = phi_4060_;
                                                    let _e2398 = select(_e2391, select(_e1681, 2f, _e2393), select(_e2395, true, _e2393));
                                                    let _e2400 = select(_e2398, _e2358, (_e2358 < _e2398));
                                                    let _e2402 = select(_e2400, _e2318, (_e2318 < _e2400));
                                                    let _e2404 = select(_e1681, _e2402, (_e2402 > _e1681));
                                                    let _e2405 = (_e2404 > _e382);
                                                    if _e2405 {
                                                        phi_4589_ = f32();
                                                        phi_4590_ = f32();
                                                        phi_4591_ = false;
                                                        phi_4592_ = false;
                                                    } else {
                                                        let _e2406 = (_e2404 - _e1681);
                                                        let _e2407 = (_e2406 <= _e1676);
                                                        let _e2409 = (_e2404 + (_e378 * 0.01f));
                                                        let _e2411 = select(_e382, _e2409, (_e2409 < _e382));
                                                        if _e2407 {
                                                            if (_e733.member_1 > 0f) {
                                                                let _e2415 = local_5.member[0u];
                                                                let _e2421 = local_5.member[1u];
                                                                let _e2437 = local_5.member_1[0u];
                                                                let _e2443 = local_5.member_1[1u];
                                                                let _e2459 = local_5.member_2[0u];
                                                                let _e2465 = local_5.member_2[1u];
                                                                let _e2479 = function_3(array<f32, 3>((_e2415[0] + ((_e2421[0] - _e2415[0]) * _e2411)), (_e2415[1] + ((_e2421[1] - _e2415[1]) * _e2411)), (_e2415[2] + ((_e2421[2] - _e2415[2]) * _e2411))), array<f32, 3>((_e2437[0] + ((_e2443[0] - _e2437[0]) * _e2411)), (_e2437[1] + ((_e2443[1] - _e2437[1]) * _e2411)), (_e2437[2] + ((_e2443[2] - _e2437[2]) * _e2411))), array<f32, 3>((_e2459[0] + ((_e2465[0] - _e2459[0]) * _e2411)), (_e2459[1] + ((_e2465[1] - _e2459[1]) * _e2411)), (_e2459[2] + ((_e2465[2] - _e2459[2]) * _e2411))), _e225.member);
                                                                let _e2490 = (((_e2479[0] * _e2479[0]) + (_e2479[1] * _e2479[1])) + (_e2479[2] * _e2479[2]));
                                                                if (_e2490 <= 0.000000000000000000000000000000000000011754944f) {
                                                                    phi_4291_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2490 > 0f));
                                                                } else {
                                                                    phi_4234_ = type_14(0i, 5i);
                                                                    phi_4237_ = bitcast<f32>(((bitcast<u32>(_e2490) >> bitcast<u32>(1i)) + 532369198u));
                                                                    loop {
                                                                        let _e2498 = phi_4234_;
                                                                        let _e2500 = phi_4237_;
                                                                        local_9 = _e2500;
                                                                        if (_e2498.member < _e2498.member_1) {
                                                                            let _e2507 = (_e2498.member + 1i);
                                                                            phi_4235_ = type_14(select(_e2507, type_15().member_1, select(false, true, ((false == (_e2507 > _e2498.member)) != false))), _e2498.member_1);
                                                                            phi_4278_ = type_15(1u, _e2498.member);
                                                                        } else {
                                                                            phi_4235_ = _e2498;
                                                                            phi_4278_ = type_15(0u, type_15().member_1);
                                                                        }
                                                                        let _e2518 = phi_4235_;
                                                                        let _e2520 = phi_4278_;
                                                                        let _e2523 = (bitcast<i32>(_e2520.member) != 0i);
                                                                        if _e2523 {
                                                                            phi_4238_ = (0.5f * (_e2500 + (_e2490 / _e2500)));
                                                                        } else {
                                                                            phi_4238_ = f32();
                                                                        }
                                                                        let _e2528 = phi_4238_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4234_ = _e2518;
                                                                            phi_4237_ = _e2528;
                                                                            break if !(_e2523);
                                                                        }
                                                                    }
                                                                    let _e2533 = local_9;
                                                                    phi_4291_ = (_e2533 * (1f + (8f * 0.000000059604645f)));
                                                                }
                                                                let _e2539 = phi_4291_;
                                                                let _e2545 = local_5.member[0u];
                                                                let _e2551 = select(_e2545[0], -(_e2545[0]), (_e2545[0] < 0f));
                                                                let _e2554 = select(_e2545[1], -(_e2545[1]), (_e2545[1] < 0f));
                                                                let _e2556 = select(_e2554, _e2551, (_e2551 > _e2554));
                                                                let _e2559 = select(_e2545[2], -(_e2545[2]), (_e2545[2] < 0f));
                                                                let _e2561 = select(_e2559, _e2556, (_e2556 > _e2559));
                                                                let _e2564 = local_5.member[1u];
                                                                let _e2570 = select(_e2564[0], -(_e2564[0]), (_e2564[0] < 0f));
                                                                let _e2573 = select(_e2564[1], -(_e2564[1]), (_e2564[1] < 0f));
                                                                let _e2575 = select(_e2573, _e2570, (_e2570 > _e2573));
                                                                let _e2578 = select(_e2564[2], -(_e2564[2]), (_e2564[2] < 0f));
                                                                let _e2580 = select(_e2578, _e2575, (_e2575 > _e2578));
                                                                let _e2584 = local_5.member_3;
                                                                let _e2588 = local_5.member_1[0u];
                                                                let _e2594 = select(_e2588[0], -(_e2588[0]), (_e2588[0] < 0f));
                                                                let _e2597 = select(_e2588[1], -(_e2588[1]), (_e2588[1] < 0f));
                                                                let _e2599 = select(_e2597, _e2594, (_e2594 > _e2597));
                                                                let _e2602 = select(_e2588[2], -(_e2588[2]), (_e2588[2] < 0f));
                                                                let _e2604 = select(_e2602, _e2599, (_e2599 > _e2602));
                                                                let _e2607 = local_5.member_1[1u];
                                                                let _e2613 = select(_e2607[0], -(_e2607[0]), (_e2607[0] < 0f));
                                                                let _e2616 = select(_e2607[1], -(_e2607[1]), (_e2607[1] < 0f));
                                                                let _e2618 = select(_e2616, _e2613, (_e2613 > _e2616));
                                                                let _e2621 = select(_e2607[2], -(_e2607[2]), (_e2607[2] < 0f));
                                                                let _e2623 = select(_e2621, _e2618, (_e2618 > _e2621));
                                                                let _e2627 = local_5.member_3;
                                                                let _e2631 = local_5.member_2[0u];
                                                                let _e2637 = select(_e2631[0], -(_e2631[0]), (_e2631[0] < 0f));
                                                                let _e2640 = select(_e2631[1], -(_e2631[1]), (_e2631[1] < 0f));
                                                                let _e2642 = select(_e2640, _e2637, (_e2637 > _e2640));
                                                                let _e2645 = select(_e2631[2], -(_e2631[2]), (_e2631[2] < 0f));
                                                                let _e2647 = select(_e2645, _e2642, (_e2642 > _e2645));
                                                                let _e2650 = local_5.member_2[1u];
                                                                let _e2656 = select(_e2650[0], -(_e2650[0]), (_e2650[0] < 0f));
                                                                let _e2659 = select(_e2650[1], -(_e2650[1]), (_e2650[1] < 0f));
                                                                let _e2661 = select(_e2659, _e2656, (_e2656 > _e2659));
                                                                let _e2664 = select(_e2650[2], -(_e2650[2]), (_e2650[2] < 0f));
                                                                let _e2666 = select(_e2664, _e2661, (_e2661 > _e2664));
                                                                let _e2670 = local_5.member_3;
                                                                let _e2677 = local_5.member_3;
                                                                phi_4562_ = select(true, false, (((_e2539 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2580, _e2561, (_e2561 > _e2580)) + _e2584) + (select(_e2623, _e2604, (_e2604 > _e2623)) + _e2627)) + (select(_e2666, _e2647, (_e2647 > _e2666)) + _e2670)) * (0.000000059604645f * 16f)) + (_e2677 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e733.member_1));
                                                            } else {
                                                                phi_4562_ = true;
                                                            }
                                                            let _e2687 = phi_4562_;
                                                            phi_4563_ = _e2687;
                                                        } else {
                                                            phi_4563_ = true;
                                                        }
                                                        let _e2689 = phi_4563_;
                                                        phi_4589_ = select(f32(), select((_e382 - _e1681), select(0f, (_e1980 + _e1980), select(select(true, false, (_e2406 <= (_e1685 * 0.25f))), true, _e2407)), _e1689), _e2689);
                                                        phi_4590_ = _e2406;
                                                        phi_4591_ = _e2689;
                                                        phi_4592_ = select(true, false, _e2689);
                                                    }
                                                    let _e2701 = phi_4589_;
                                                    let _e2703 = phi_4590_;
                                                    let _e2705 = phi_4591_;
                                                    let _e2707 = phi_4592_;
                                                    phi_4593_ = _e2404;
                                                    phi_4594_ = _e2701;
                                                    phi_4595_ = _e2703;
                                                    phi_4596_ = _e2404;
                                                    phi_4597_ = _e2705;
                                                    phi_4598_ = _e2405;
                                                    phi_4599_ = _e2707;
                                                    phi_4600_ = false;
                                                } else {
                                                    phi_4593_ = f32();
                                                    phi_4594_ = f32();
                                                    phi_4595_ = f32();
                                                    phi_4596_ = f32();
                                                    phi_4597_ = false;
                                                    phi_4598_ = false;
                                                    phi_4599_ = false;
                                                    phi_4600_ = true;
                                                }
                                                let _e2709 = phi_4593_;
                                                let _e2711 = phi_4594_;
                                                let _e2713 = phi_4595_;
                                                let _e2715 = phi_4596_;
                                                let _e2717 = phi_4597_;
                                                let _e2719 = phi_4598_;
                                                let _e2721 = phi_4599_;
                                                let _e2723 = phi_4600_;
                                                phi_4601_ = _e2709;
                                                phi_4602_ = _e2711;
                                                phi_4603_ = _e2713;
                                                phi_4604_ = _e2715;
                                                phi_4605_ = false;
                                                phi_4606_ = _e2717;
                                                phi_4607_ = _e2719;
                                                phi_4608_ = _e2721;
                                                phi_4609_ = _e2723;
                                            } else {
                                                phi_4601_ = f32();
                                                phi_4602_ = f32();
                                                phi_4603_ = f32();
                                                phi_4604_ = f32();
                                                phi_4605_ = true;
                                                phi_4606_ = false;
                                                phi_4607_ = false;
                                                phi_4608_ = false;
                                                phi_4609_ = false;
                                            }
                                            let _e2725 = phi_4601_;
                                            let _e2727 = phi_4602_;
                                            let _e2729 = phi_4603_;
                                            let _e2731 = phi_4604_;
                                            let _e2733 = phi_4605_;
                                            let _e2735 = phi_4606_;
                                            let _e2737 = phi_4607_;
                                            let _e2739 = phi_4608_;
                                            let _e2741 = phi_4609_;
                                            phi_4610_ = _e2725;
                                            phi_4611_ = _e2727;
                                            phi_4612_ = _e2729;
                                            phi_4613_ = _e2731;
                                            phi_4614_ = _e2733;
                                            phi_4615_ = _e2735;
                                            phi_4616_ = _e2737;
                                            phi_4617_ = _e2739;
                                            phi_4618_ = _e2741;
                                        } else {
                                            phi_4610_ = f32();
                                            phi_4611_ = f32();
                                            phi_4612_ = f32();
                                            phi_4613_ = f32();
                                            phi_4614_ = true;
                                            phi_4615_ = false;
                                            phi_4616_ = false;
                                            phi_4617_ = false;
                                            phi_4618_ = false;
                                        }
                                        let _e2743 = phi_4610_;
                                        let _e2745 = phi_4611_;
                                        let _e2747 = phi_4612_;
                                        let _e2749 = phi_4613_;
                                        let _e2751 = phi_4614_;
                                        let _e2753 = phi_4615_;
                                        let _e2755 = phi_4616_;
                                        let _e2757 = phi_4617_;
                                        let _e2759 = phi_4618_;
                                        if _e2751 {
                                            if (_e1681 <= _e1683) {
                                                let _e2912 = (_e1691 + 1u);
                                                let _e2913 = (_e2912 > 3u);
                                                phi_4953_ = _e2912;
                                                phi_4954_ = f32();
                                                phi_4955_ = false;
                                                phi_4956_ = select(true, false, _e2913);
                                                phi_4957_ = _e2913;
                                            } else {
                                                let _e2763 = local_3.member[0u];
                                                let _e2766 = local_3.member_1[0u];
                                                let _e2769 = local_3.member[0u];
                                                let _e2775 = local_3.member_2[0u];
                                                let _e2776 = ((_e2763 + ((_e2766 - _e2769) * _e1687)) - _e2775);
                                                let _e2779 = local_3.member[1u];
                                                let _e2782 = local_3.member_1[1u];
                                                let _e2785 = local_3.member[1u];
                                                let _e2791 = local_3.member_2[1u];
                                                let _e2792 = ((_e2779 + ((_e2782 - _e2785) * _e1687)) - _e2791);
                                                let _e2794 = select(_e2792, _e2776, (_e2776 < _e2792));
                                                let _e2797 = local_3.member[2u];
                                                let _e2800 = local_3.member_1[2u];
                                                let _e2803 = local_3.member[2u];
                                                let _e2809 = local_3.member_2[2u];
                                                let _e2810 = ((_e2797 + ((_e2800 - _e2803) * _e1687)) - _e2809);
                                                let _e2813 = local_3.member[3u];
                                                let _e2816 = local_3.member_1[3u];
                                                let _e2819 = local_3.member[3u];
                                                let _e2825 = local_3.member_2[3u];
                                                let _e2826 = ((_e2813 + ((_e2816 - _e2819) * _e1687)) - _e2825);
                                                let _e2828 = select(_e2826, _e2810, (_e2810 < _e2826));
                                                let _e2830 = select(_e2828, _e2794, (_e2794 < _e2828));
                                                let _e2833 = local_4.member[0u];
                                                let _e2836 = local_4.member_1[0u];
                                                let _e2839 = local_4.member[0u];
                                                let _e2845 = local_4.member_2[0u];
                                                let _e2846 = ((_e2833 + ((_e2836 - _e2839) * _e1681)) - _e2845);
                                                let _e2849 = local_4.member[1u];
                                                let _e2852 = local_4.member_1[1u];
                                                let _e2855 = local_4.member[1u];
                                                let _e2861 = local_4.member_2[1u];
                                                let _e2862 = ((_e2849 + ((_e2852 - _e2855) * _e1681)) - _e2861);
                                                let _e2864 = select(_e2862, _e2846, (_e2846 < _e2862));
                                                let _e2867 = local_4.member[2u];
                                                let _e2870 = local_4.member_1[2u];
                                                let _e2873 = local_4.member[2u];
                                                let _e2879 = local_4.member_2[2u];
                                                let _e2880 = ((_e2867 + ((_e2870 - _e2873) * _e1681)) - _e2879);
                                                let _e2883 = local_4.member[3u];
                                                let _e2886 = local_4.member_1[3u];
                                                let _e2889 = local_4.member[3u];
                                                let _e2895 = local_4.member_2[3u];
                                                let _e2896 = ((_e2883 + ((_e2886 - _e2889) * _e1681)) - _e2895);
                                                let _e2898 = select(_e2896, _e2880, (_e2880 < _e2896));
                                                let _e2900 = select(_e2898, _e2864, (_e2864 < _e2898));
                                                if (_e2900 > 0f) {
                                                    phi_4951_ = 0.5f;
                                                } else {
                                                    let _e2904 = (0.95f * (_e2830 / (_e2830 - _e2900)));
                                                    phi_4951_ = select(0.0625f, select(0.9f, _e2904, (_e2904 < 0.9f)), (_e2904 > 0.0625f));
                                                }
                                                let _e2910 = phi_4951_;
                                                phi_4953_ = u32();
                                                phi_4954_ = (_e1980 * _e2910);
                                                phi_4955_ = true;
                                                phi_4956_ = false;
                                                phi_4957_ = false;
                                            }
                                            let _e2916 = phi_4953_;
                                            let _e2918 = phi_4954_;
                                            let _e2920 = phi_4955_;
                                            let _e2922 = phi_4956_;
                                            let _e2924 = phi_4957_;
                                            phi_4958_ = _e2916;
                                            phi_4959_ = _e1683;
                                            phi_4960_ = _e2918;
                                            phi_4961_ = _e1685;
                                            phi_4962_ = _e1687;
                                            phi_4963_ = _e1689;
                                            phi_4964_ = _e1691;
                                            phi_4965_ = _e2920;
                                            phi_4966_ = _e2922;
                                            phi_4967_ = _e2924;
                                            phi_4968_ = false;
                                            phi_4969_ = false;
                                            phi_4970_ = false;
                                        } else {
                                            phi_4958_ = u32();
                                            phi_4959_ = _e2743;
                                            phi_4960_ = _e2745;
                                            phi_4961_ = _e2747;
                                            phi_4962_ = _e1681;
                                            phi_4963_ = true;
                                            phi_4964_ = 0u;
                                            phi_4965_ = _e2753;
                                            phi_4966_ = false;
                                            phi_4967_ = false;
                                            phi_4968_ = _e2755;
                                            phi_4969_ = _e2757;
                                            phi_4970_ = _e2759;
                                        }
                                        let _e2926 = phi_4958_;
                                        let _e2928 = phi_4959_;
                                        let _e2930 = phi_4960_;
                                        let _e2932 = phi_4961_;
                                        let _e2934 = phi_4962_;
                                        let _e2936 = phi_4963_;
                                        let _e2938 = phi_4964_;
                                        let _e2940 = phi_4965_;
                                        let _e2942 = phi_4966_;
                                        let _e2944 = phi_4967_;
                                        let _e2946 = phi_4968_;
                                        let _e2948 = phi_4969_;
                                        let _e2950 = phi_4970_;
                                        if _e2940 {
                                            let _e2951 = (_e2934 + _e2930);
                                            let _e2953 = select(_e2928, _e2951, (_e2951 > _e2928));
                                            let _e2955 = select(_e382, _e2953, (_e2953 < _e382));
                                            let _e2958 = select(((_e2955 - _e2934) > _e1676), true, !(_e1689));
                                            phi_4998_ = _e2955;
                                            phi_4999_ = _e2928;
                                            phi_5000_ = _e2932;
                                            phi_5001_ = _e2934;
                                            phi_5002_ = _e2936;
                                            phi_5003_ = _e2938;
                                            phi_5004_ = _e2958;
                                            phi_5005_ = select(true, false, _e2958);
                                            phi_5006_ = false;
                                            phi_5007_ = false;
                                            phi_5008_ = false;
                                            phi_5009_ = false;
                                        } else {
                                            phi_4998_ = _e1681;
                                            phi_4999_ = _e1683;
                                            phi_5000_ = _e1685;
                                            phi_5001_ = _e1687;
                                            phi_5002_ = _e1689;
                                            phi_5003_ = _e2926;
                                            phi_5004_ = _e2942;
                                            phi_5005_ = false;
                                            phi_5006_ = _e2944;
                                            phi_5007_ = _e2946;
                                            phi_5008_ = _e2948;
                                            phi_5009_ = _e2950;
                                        }
                                        let _e2961 = phi_4998_;
                                        let _e2963 = phi_4999_;
                                        let _e2965 = phi_5000_;
                                        let _e2967 = phi_5001_;
                                        let _e2969 = phi_5002_;
                                        let _e2971 = phi_5003_;
                                        let _e2973 = phi_5004_;
                                        let _e2975 = phi_5005_;
                                        let _e2977 = phi_5006_;
                                        let _e2979 = phi_5007_;
                                        let _e2981 = phi_5008_;
                                        let _e2983 = phi_5009_;
                                        phi_2831_ = _e2961;
                                        phi_2833_ = _e2963;
                                        phi_2835_ = _e2965;
                                        phi_2837_ = _e2967;
                                        phi_2839_ = _e2969;
                                        phi_2841_ = _e2971;
                                        phi_5010_ = _e2928;
                                        phi_5011_ = _e2749;
                                        phi_5012_ = _e2973;
                                        phi_5013_ = _e2975;
                                        phi_5014_ = _e2977;
                                        phi_5015_ = _e2979;
                                        phi_5016_ = _e2981;
                                        phi_5017_ = false;
                                        phi_5018_ = _e2983;
                                    } else {
                                        phi_2831_ = f32();
                                        phi_2833_ = f32();
                                        phi_2835_ = f32();
                                        phi_2837_ = f32();
                                        phi_2839_ = bool();
                                        phi_2841_ = u32();
                                        phi_5010_ = f32();
                                        phi_5011_ = f32();
                                        phi_5012_ = false;
                                        phi_5013_ = false;
                                        phi_5014_ = false;
                                        phi_5015_ = false;
                                        phi_5016_ = false;
                                        phi_5017_ = true;
                                        phi_5018_ = false;
                                    }
                                    let _e2985 = phi_2831_;
                                    let _e2987 = phi_2833_;
                                    let _e2989 = phi_2835_;
                                    let _e2991 = phi_2837_;
                                    let _e2993 = phi_2839_;
                                    let _e2995 = phi_2841_;
                                    let _e2997 = phi_5010_;
                                    let _e2999 = phi_5011_;
                                    let _e3001 = phi_5012_;
                                    let _e3003 = phi_5013_;
                                    let _e3005 = phi_5014_;
                                    let _e3007 = phi_5015_;
                                    let _e3009 = phi_5016_;
                                    let _e3011 = phi_5017_;
                                    let _e3013 = phi_5018_;
                                    local_10 = _e3003;
                                    local_11 = _e3005;
                                    local_12 = _e3003;
                                    local_13 = _e3007;
                                    local_14 = _e3003;
                                    local_15 = _e3009;
                                    local_16 = _e3003;
                                    local_17 = _e3011;
                                    local_18 = _e3003;
                                    local_19 = _e3013;
                                    local_21 = _e3003;
                                    local_22 = _e2999;
                                    local_23 = _e2997;
                                    continue;
                                    continuing {
                                        phi_2827_ = type_9(select(_e1679.member, (_e1679.member + 1u), _e1694), select(_e1679.member_1, _e1679.member_1, _e1694));
                                        phi_2830_ = _e2985;
                                        phi_2832_ = _e2987;
                                        phi_2834_ = _e2989;
                                        phi_2836_ = _e2991;
                                        phi_2838_ = _e2993;
                                        phi_2840_ = _e2995;
                                        break if !(_e3001);
                                    }
                                }
                                let _e3016 = local_10;
                                let _e3018 = local_11;
                                let _e3019 = select(_e3018, false, _e3016);
                                let _e3021 = local_12;
                                let _e3023 = local_13;
                                let _e3026 = local_14;
                                let _e3028 = local_15;
                                let _e3031 = local_16;
                                let _e3033 = local_17;
                                let _e3036 = local_18;
                                let _e3038 = local_19;
                                let _e3044 = local_20;
                                let _e3046 = select(select(_e3023, false, _e3021), false, _e3019);
                                let _e3049 = local_21;
                                let _e3056 = select(select(select(_e3028, false, _e3026), false, _e3019), false, _e3046);
                                let _e3062 = local_22;
                                let _e3064 = local_23;
                                let _e3066 = select(select(select(_e3049, false, _e3019), false, _e3046), true, _e3056);
                                let _e3071 = local_24;
                                let _e3073 = select(select(select(select(select(_e3033, false, _e3031), false, _e3019), false, _e3046), false, _e3056), true, _e3066);
                                let _e3080 = select(select(select(select(select(select(_e3038, false, _e3036), false, _e3019), false, _e3046), false, _e3056), false, _e3066), false, _e3073);
                                let _e3085 = select(select(select(select(select(_e3019, true, _e3046), false, _e3056), false, _e3066), false, _e3073), true, _e3080);
                                phi_5085_ = select(select(type_34().member_1, select(_e3071, select(_e3064, _e3062, _e3056), _e3066), _e3073), select(select(select(type_34().member_1, _e3044, _e3019), type_34().member_1, _e3046), type_34().member_1, _e3080), _e3085);
                                phi_5086_ = (select(select(type_34().member, 1u, _e3073), select(select(select(type_34().member, 1u, _e3019), 0u, _e3046), 0u, _e3080), _e3085) != 0u);
                            } else {
                                phi_5085_ = _e1443;
                                phi_5086_ = true;
                            }
                            let _e3090 = phi_5085_;
                            let _e3092 = phi_5086_;
                            if _e3092 {
                                let _e3093 = (_e3090 > _e380);
                                if _e3093 {
                                    phi_7251_ = f32();
                                    phi_7252_ = u32();
                                    phi_7253_ = f32();
                                    phi_7254_ = type_36();
                                    phi_7255_ = u32();
                                    phi_7256_ = u32();
                                    phi_7257_ = false;
                                    phi_7258_ = false;
                                    phi_7259_ = false;
                                } else {
                                    let _e3096 = local_5.member[0u];
                                    let _e3102 = local_5.member[1u];
                                    let _e3118 = local_5.member_1[0u];
                                    let _e3124 = local_5.member_1[1u];
                                    let _e3140 = local_5.member_2[0u];
                                    let _e3146 = local_5.member_2[1u];
                                    let _e3160 = function_3(array<f32, 3>((_e3096[0] + ((_e3102[0] - _e3096[0]) * _e1447)), (_e3096[1] + ((_e3102[1] - _e3096[1]) * _e1447)), (_e3096[2] + ((_e3102[2] - _e3096[2]) * _e1447))), array<f32, 3>((_e3118[0] + ((_e3124[0] - _e3118[0]) * _e1447)), (_e3118[1] + ((_e3124[1] - _e3118[1]) * _e1447)), (_e3118[2] + ((_e3124[2] - _e3118[2]) * _e1447))), array<f32, 3>((_e3140[0] + ((_e3146[0] - _e3140[0]) * _e1447)), (_e3140[1] + ((_e3146[1] - _e3140[1]) * _e1447)), (_e3140[2] + ((_e3146[2] - _e3140[2]) * _e1447))), _e225.member);
                                    let _e3174 = ((select(_e3160[0], -(_e3160[0]), (_e3160[0] < 0f)) + select(_e3160[1], -(_e3160[1]), (_e3160[1] < 0f))) + select(_e3160[2], -(_e3160[2]), (_e3160[2] < 0f)));
                                    let _e3177 = local_5.member[0u];
                                    let _e3183 = local_5.member_1[0u];
                                    let _e3189 = local_5.member_2[0u];
                                    let _e3193 = (_e3177[0] - _e3183[0]);
                                    let _e3194 = (_e3177[1] - _e3183[1]);
                                    let _e3195 = (_e3177[2] - _e3183[2]);
                                    let _e3196 = (_e225.member == 0u);
                                    let _e3208 = local_5.member[1u];
                                    let _e3214 = local_5.member_1[1u];
                                    let _e3220 = local_5.member_2[1u];
                                    let _e3224 = (_e3208[0] - _e3214[0]);
                                    let _e3225 = (_e3208[1] - _e3214[1]);
                                    let _e3226 = (_e3208[2] - _e3214[2]);
                                    let _e3227 = (_e225.member == 0u);
                                    let _e3239 = local_5.member[0u];
                                    let _e3245 = select(_e3239[0], -(_e3239[0]), (_e3239[0] < 0f));
                                    let _e3248 = select(_e3239[1], -(_e3239[1]), (_e3239[1] < 0f));
                                    let _e3250 = select(_e3248, _e3245, (_e3245 > _e3248));
                                    let _e3253 = select(_e3239[2], -(_e3239[2]), (_e3239[2] < 0f));
                                    let _e3255 = select(_e3253, _e3250, (_e3250 > _e3253));
                                    let _e3258 = local_5.member[1u];
                                    let _e3264 = select(_e3258[0], -(_e3258[0]), (_e3258[0] < 0f));
                                    let _e3267 = select(_e3258[1], -(_e3258[1]), (_e3258[1] < 0f));
                                    let _e3269 = select(_e3267, _e3264, (_e3264 > _e3267));
                                    let _e3272 = select(_e3258[2], -(_e3258[2]), (_e3258[2] < 0f));
                                    let _e3274 = select(_e3272, _e3269, (_e3269 > _e3272));
                                    let _e3278 = local_5.member_3;
                                    let _e3282 = local_5.member_1[0u];
                                    let _e3288 = select(_e3282[0], -(_e3282[0]), (_e3282[0] < 0f));
                                    let _e3291 = select(_e3282[1], -(_e3282[1]), (_e3282[1] < 0f));
                                    let _e3293 = select(_e3291, _e3288, (_e3288 > _e3291));
                                    let _e3296 = select(_e3282[2], -(_e3282[2]), (_e3282[2] < 0f));
                                    let _e3298 = select(_e3296, _e3293, (_e3293 > _e3296));
                                    let _e3301 = local_5.member_1[1u];
                                    let _e3307 = select(_e3301[0], -(_e3301[0]), (_e3301[0] < 0f));
                                    let _e3310 = select(_e3301[1], -(_e3301[1]), (_e3301[1] < 0f));
                                    let _e3312 = select(_e3310, _e3307, (_e3307 > _e3310));
                                    let _e3315 = select(_e3301[2], -(_e3301[2]), (_e3301[2] < 0f));
                                    let _e3317 = select(_e3315, _e3312, (_e3312 > _e3315));
                                    let _e3321 = local_5.member_3;
                                    let _e3325 = local_5.member_2[0u];
                                    let _e3331 = select(_e3325[0], -(_e3325[0]), (_e3325[0] < 0f));
                                    let _e3334 = select(_e3325[1], -(_e3325[1]), (_e3325[1] < 0f));
                                    let _e3336 = select(_e3334, _e3331, (_e3331 > _e3334));
                                    let _e3339 = select(_e3325[2], -(_e3325[2]), (_e3325[2] < 0f));
                                    let _e3341 = select(_e3339, _e3336, (_e3336 > _e3339));
                                    let _e3344 = local_5.member_2[1u];
                                    let _e3350 = select(_e3344[0], -(_e3344[0]), (_e3344[0] < 0f));
                                    let _e3353 = select(_e3344[1], -(_e3344[1]), (_e3344[1] < 0f));
                                    let _e3355 = select(_e3353, _e3350, (_e3350 > _e3353));
                                    let _e3358 = select(_e3344[2], -(_e3344[2]), (_e3344[2] < 0f));
                                    let _e3360 = select(_e3358, _e3355, (_e3355 > _e3358));
                                    let _e3364 = local_5.member_3;
                                    let _e3371 = local_5.member_3;
                                    local_1 = type_30(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3177, array<f32, 3>(_e3193, _e3194, _e3195), array<f32, 3>((_e3177[0] - _e3189[0]), (_e3177[1] - _e3189[1]), (_e3177[2] - _e3189[2])), array<f32, 3>(select((_e3193 - _e3189[0]), _e3177[0], _e3196), select((_e3194 - _e3189[1]), _e3177[1], _e3196), select((_e3195 - _e3189[2]), _e3177[2], _e3196))), array<array<f32, 3>, 4>(_e3208, array<f32, 3>(_e3224, _e3225, _e3226), array<f32, 3>((_e3208[0] - _e3220[0]), (_e3208[1] - _e3220[1]), (_e3208[2] - _e3220[2])), array<f32, 3>(select((_e3224 - _e3220[0]), _e3208[0], _e3227), select((_e3225 - _e3220[1]), _e3208[1], _e3227), select((_e3226 - _e3220[2]), _e3208[2], _e3227)))), ((((((select(_e3274, _e3255, (_e3255 > _e3274)) + _e3278) + (select(_e3317, _e3298, (_e3298 > _e3317)) + _e3321)) + (select(_e3360, _e3341, (_e3341 > _e3360)) + _e3364)) * (0.000000059604645f * 16f)) + (_e3371 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e733.member_1);
                                    let _e3387 = local_1.member_1;
                                    if (_e3174 > _e3387) {
                                        if ((bitcast<u32>(_e3174) & 2139095040u) != 2139095040u) {
                                            let _e3392 = (1f / _e3174);
                                            let _e3394 = (_e3160[0] * _e3392);
                                            let _e3396 = (_e3160[1] * _e3392);
                                            let _e3398 = (_e3160[2] * _e3392);
                                            let _e3403 = (((_e3394 * _e3394) + (_e3396 * _e3396)) + (_e3398 * _e3398));
                                            if (_e3403 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5763_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3403 > 0f));
                                            } else {
                                                phi_5706_ = type_14(0i, 5i);
                                                phi_5709_ = bitcast<f32>(((bitcast<u32>(_e3403) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3411 = phi_5706_;
                                                    let _e3413 = phi_5709_;
                                                    local_25 = _e3413;
                                                    if (_e3411.member < _e3411.member_1) {
                                                        let _e3420 = (_e3411.member + 1i);
                                                        phi_5707_ = type_14(select(_e3420, type_15().member_1, select(false, true, ((false == (_e3420 > _e3411.member)) != false))), _e3411.member_1);
                                                        phi_5750_ = type_15(1u, _e3411.member);
                                                    } else {
                                                        phi_5707_ = _e3411;
                                                        phi_5750_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3431 = phi_5707_;
                                                    let _e3433 = phi_5750_;
                                                    let _e3436 = (bitcast<i32>(_e3433.member) != 0i);
                                                    if _e3436 {
                                                        phi_5710_ = (0.5f * (_e3413 + (_e3403 / _e3413)));
                                                    } else {
                                                        phi_5710_ = f32();
                                                    }
                                                    let _e3441 = phi_5710_;
                                                    continue;
                                                    continuing {
                                                        phi_5706_ = _e3431;
                                                        phi_5709_ = _e3441;
                                                        break if !(_e3436);
                                                    }
                                                }
                                                let _e3446 = local_25;
                                                phi_5763_ = (_e3446 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3452 = phi_5763_;
                                            let _e3453 = (0.000000059604645f * 12f);
                                            let _e3455 = local_1.member_1;
                                            let _e3458 = local_1.member_2;
                                            let _e3462 = ((_e3455 * 1.01f) + ((_e3458 * _e3452) * (1f + _e3453)));
                                            let _e3466 = local_1.member[0u][0u];
                                            let _e3474 = (((_e3394 * _e3466[0]) + (_e3396 * _e3466[1])) + (_e3398 * _e3466[2]));
                                            let _e3478 = local_1.member[0u][1u];
                                            let _e3486 = (((_e3394 * _e3478[0]) + (_e3396 * _e3478[1])) + (_e3398 * _e3478[2]));
                                            let _e3490 = local_1.member[0u][2u];
                                            let _e3498 = (((_e3394 * _e3490[0]) + (_e3396 * _e3490[1])) + (_e3398 * _e3490[2]));
                                            let _e3502 = local_1.member[0u][3u];
                                            let _e3510 = (((_e3394 * _e3502[0]) + (_e3396 * _e3502[1])) + (_e3398 * _e3502[2]));
                                            let _e3514 = local_1.member[1u][0u];
                                            let _e3522 = (((_e3394 * _e3514[0]) + (_e3396 * _e3514[1])) + (_e3398 * _e3514[2]));
                                            let _e3526 = local_1.member[1u][1u];
                                            let _e3534 = (((_e3394 * _e3526[0]) + (_e3396 * _e3526[1])) + (_e3398 * _e3526[2]));
                                            let _e3538 = local_1.member[1u][2u];
                                            let _e3546 = (((_e3394 * _e3538[0]) + (_e3396 * _e3538[1])) + (_e3398 * _e3538[2]));
                                            let _e3550 = local_1.member[1u][3u];
                                            let _e3558 = (((_e3394 * _e3550[0]) + (_e3396 * _e3550[1])) + (_e3398 * _e3550[2]));
                                            local_2 = type_31(array<f32, 4>(_e3474, _e3486, _e3498, _e3510), array<f32, 4>(_e3522, _e3534, _e3546, _e3558), array<f32, 4>((_e3462 + ((select(_e3474, -(_e3474), (_e3474 < 0f)) + select(_e3522, -(_e3522), (_e3522 < 0f))) * _e3453)), (_e3462 + ((select(_e3486, -(_e3486), (_e3486 < 0f)) + select(_e3534, -(_e3534), (_e3534 < 0f))) * _e3453)), (_e3462 + ((select(_e3498, -(_e3498), (_e3498 < 0f)) + select(_e3546, -(_e3546), (_e3546 < 0f))) * _e3453)), (_e3462 + ((select(_e3510, -(_e3510), (_e3510 < 0f)) + select(_e3558, -(_e3558), (_e3558 < 0f))) * _e3453))));
                                            let _e3603 = (((_e3394 * _e3394) + (_e3396 * _e3396)) + (_e3398 * _e3398));
                                            if (_e3603 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_6055_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3603 > 0f));
                                            } else {
                                                phi_5998_ = type_14(0i, 5i);
                                                phi_6001_ = bitcast<f32>(((bitcast<u32>(_e3603) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3611 = phi_5998_;
                                                    let _e3613 = phi_6001_;
                                                    local_26 = _e3613;
                                                    if (_e3611.member < _e3611.member_1) {
                                                        let _e3620 = (_e3611.member + 1i);
                                                        phi_5999_ = type_14(select(_e3620, type_15().member_1, select(false, true, ((false == (_e3620 > _e3611.member)) != false))), _e3611.member_1);
                                                        phi_6042_ = type_15(1u, _e3611.member);
                                                    } else {
                                                        phi_5999_ = _e3611;
                                                        phi_6042_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3631 = phi_5999_;
                                                    let _e3633 = phi_6042_;
                                                    let _e3636 = (bitcast<i32>(_e3633.member) != 0i);
                                                    if _e3636 {
                                                        phi_6002_ = (0.5f * (_e3613 + (_e3603 / _e3613)));
                                                    } else {
                                                        phi_6002_ = f32();
                                                    }
                                                    let _e3641 = phi_6002_;
                                                    continue;
                                                    continuing {
                                                        phi_5998_ = _e3631;
                                                        phi_6001_ = _e3641;
                                                        break if !(_e3636);
                                                    }
                                                }
                                                let _e3646 = local_26;
                                                phi_6055_ = (_e3646 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3652 = phi_6055_;
                                            let _e3663 = (((_e3160[0] * _e3160[0]) + (_e3160[1] * _e3160[1])) + (_e3160[2] * _e3160[2]));
                                            if (_e3663 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_6144_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3663 > 0f));
                                            } else {
                                                phi_6087_ = type_14(0i, 5i);
                                                phi_6090_ = bitcast<f32>(((bitcast<u32>(_e3663) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3671 = phi_6087_;
                                                    let _e3673 = phi_6090_;
                                                    local_27 = _e3673;
                                                    if (_e3671.member < _e3671.member_1) {
                                                        let _e3680 = (_e3671.member + 1i);
                                                        phi_6088_ = type_14(select(_e3680, type_15().member_1, select(false, true, ((false == (_e3680 > _e3671.member)) != false))), _e3671.member_1);
                                                        phi_6131_ = type_15(1u, _e3671.member);
                                                    } else {
                                                        phi_6088_ = _e3671;
                                                        phi_6131_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3691 = phi_6088_;
                                                    let _e3693 = phi_6131_;
                                                    let _e3696 = (bitcast<i32>(_e3693.member) != 0i);
                                                    if _e3696 {
                                                        phi_6091_ = (0.5f * (_e3673 + (_e3663 / _e3673)));
                                                    } else {
                                                        phi_6091_ = f32();
                                                    }
                                                    let _e3701 = phi_6091_;
                                                    continue;
                                                    continuing {
                                                        phi_6087_ = _e3691;
                                                        phi_6090_ = _e3701;
                                                        break if !(_e3696);
                                                    }
                                                }
                                                let _e3706 = local_27;
                                                phi_6144_ = (_e3706 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3712 = phi_6144_;
                                            let _e3718 = local_5.member[0u];
                                            let _e3724 = select(_e3718[0], -(_e3718[0]), (_e3718[0] < 0f));
                                            let _e3727 = select(_e3718[1], -(_e3718[1]), (_e3718[1] < 0f));
                                            let _e3729 = select(_e3727, _e3724, (_e3724 > _e3727));
                                            let _e3732 = select(_e3718[2], -(_e3718[2]), (_e3718[2] < 0f));
                                            let _e3734 = select(_e3732, _e3729, (_e3729 > _e3732));
                                            let _e3737 = local_5.member[1u];
                                            let _e3743 = select(_e3737[0], -(_e3737[0]), (_e3737[0] < 0f));
                                            let _e3746 = select(_e3737[1], -(_e3737[1]), (_e3737[1] < 0f));
                                            let _e3748 = select(_e3746, _e3743, (_e3743 > _e3746));
                                            let _e3751 = select(_e3737[2], -(_e3737[2]), (_e3737[2] < 0f));
                                            let _e3753 = select(_e3751, _e3748, (_e3748 > _e3751));
                                            let _e3757 = local_5.member_3;
                                            let _e3761 = local_5.member_1[0u];
                                            let _e3767 = select(_e3761[0], -(_e3761[0]), (_e3761[0] < 0f));
                                            let _e3770 = select(_e3761[1], -(_e3761[1]), (_e3761[1] < 0f));
                                            let _e3772 = select(_e3770, _e3767, (_e3767 > _e3770));
                                            let _e3775 = select(_e3761[2], -(_e3761[2]), (_e3761[2] < 0f));
                                            let _e3777 = select(_e3775, _e3772, (_e3772 > _e3775));
                                            let _e3780 = local_5.member_1[1u];
                                            let _e3786 = select(_e3780[0], -(_e3780[0]), (_e3780[0] < 0f));
                                            let _e3789 = select(_e3780[1], -(_e3780[1]), (_e3780[1] < 0f));
                                            let _e3791 = select(_e3789, _e3786, (_e3786 > _e3789));
                                            let _e3794 = select(_e3780[2], -(_e3780[2]), (_e3780[2] < 0f));
                                            let _e3796 = select(_e3794, _e3791, (_e3791 > _e3794));
                                            let _e3800 = local_5.member_3;
                                            let _e3804 = local_5.member_2[0u];
                                            let _e3810 = select(_e3804[0], -(_e3804[0]), (_e3804[0] < 0f));
                                            let _e3813 = select(_e3804[1], -(_e3804[1]), (_e3804[1] < 0f));
                                            let _e3815 = select(_e3813, _e3810, (_e3810 > _e3813));
                                            let _e3818 = select(_e3804[2], -(_e3804[2]), (_e3804[2] < 0f));
                                            let _e3820 = select(_e3818, _e3815, (_e3815 > _e3818));
                                            let _e3823 = local_5.member_2[1u];
                                            let _e3829 = select(_e3823[0], -(_e3823[0]), (_e3823[0] < 0f));
                                            let _e3832 = select(_e3823[1], -(_e3823[1]), (_e3823[1] < 0f));
                                            let _e3834 = select(_e3832, _e3829, (_e3829 > _e3832));
                                            let _e3837 = select(_e3823[2], -(_e3823[2]), (_e3823[2] < 0f));
                                            let _e3839 = select(_e3837, _e3834, (_e3834 > _e3837));
                                            let _e3843 = local_5.member_3;
                                            let _e3850 = local_5.member_3;
                                            let _e3860 = ((((_e3712 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3753, _e3734, (_e3734 > _e3753)) + _e3757) + (select(_e3796, _e3777, (_e3777 > _e3796)) + _e3800)) + (select(_e3839, _e3820, (_e3820 > _e3839)) + _e3843)) * (0.000000059604645f * 16f)) + (_e3850 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3652) * (1f + (0.000000059604645f * 64f)));
                                            let _e3863 = local_2.member[0u];
                                            let _e3866 = local_2.member_1[0u];
                                            phi_6452_ = type_9(1u, 4u);
                                            phi_6455_ = ((_e3863 + ((_e3866 - _e3863) * _e1447)) - ((_e3387 * 1.01f) + ((select(_e3863, -(_e3863), (_e3863 < 0f)) + select(_e3866, -(_e3866), (_e3866 < 0f))) * (0.000000059604645f * 12f))));
                                            loop {
                                                let _e3883 = phi_6452_;
                                                let _e3885 = phi_6455_;
                                                local_28 = _e3885;
                                                local_29 = _e3885;
                                                let _e3888 = (_e3883.member < _e3883.member_1);
                                                let _e3899 = select(type_9().member_1, _e3883.member, _e3888);
                                                let _e3901 = (bitcast<i32>(select(0u, 1u, _e3888)) != 0i);
                                                if _e3901 {
                                                    let _e3904 = local_2.member[_e3899];
                                                    let _e3907 = local_2.member_1[_e3899];
                                                    let _e3922 = ((_e3904 + ((_e3907 - _e3904) * _e1447)) - ((_e3387 * 1.01f) + ((select(_e3904, -(_e3904), (_e3904 < 0f)) + select(_e3907, -(_e3907), (_e3907 < 0f))) * (0.000000059604645f * 12f))));
                                                    phi_6456_ = select(_e3922, _e3885, (_e3885 < _e3922));
                                                } else {
                                                    phi_6456_ = f32();
                                                }
                                                let _e3926 = phi_6456_;
                                                continue;
                                                continuing {
                                                    phi_6452_ = type_9(select(_e3883.member, (_e3883.member + 1u), _e3888), select(_e3883.member_1, _e3883.member_1, _e3888));
                                                    phi_6455_ = _e3926;
                                                    break if !(_e3901);
                                                }
                                            }
                                            let _e3929 = local_28;
                                            if (_e3929 > 0f) {
                                                let _e3933 = local_29;
                                                let _e3936 = (((_e3860 - _e3933) / _e3860) * 2.02f);
                                                if (_e3936 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_6611_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3936 > 0f));
                                                } else {
                                                    phi_6554_ = type_14(0i, 5i);
                                                    phi_6557_ = bitcast<f32>(((bitcast<u32>(_e3936) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3944 = phi_6554_;
                                                        let _e3946 = phi_6557_;
                                                        local_30 = _e3946;
                                                        if (_e3944.member < _e3944.member_1) {
                                                            let _e3953 = (_e3944.member + 1i);
                                                            phi_6555_ = type_14(select(_e3953, type_15().member_1, select(false, true, ((false == (_e3953 > _e3944.member)) != false))), _e3944.member_1);
                                                            phi_6598_ = type_15(1u, _e3944.member);
                                                        } else {
                                                            phi_6555_ = _e3944;
                                                            phi_6598_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3964 = phi_6555_;
                                                        let _e3966 = phi_6598_;
                                                        let _e3969 = (bitcast<i32>(_e3966.member) != 0i);
                                                        if _e3969 {
                                                            phi_6558_ = (0.5f * (_e3946 + (_e3936 / _e3946)));
                                                        } else {
                                                            phi_6558_ = f32();
                                                        }
                                                        let _e3974 = phi_6558_;
                                                        continue;
                                                        continuing {
                                                            phi_6554_ = _e3964;
                                                            phi_6557_ = _e3974;
                                                            break if !(_e3969);
                                                        }
                                                    }
                                                    let _e3979 = local_30;
                                                    phi_6611_ = (_e3979 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3985 = phi_6611_;
                                                let _e3987 = ((_e3985 * _e3652) * 1.01f);
                                                phi_6616_ = type_9(0u, 4u);
                                                phi_6619_ = 2f;
                                                phi_6621_ = true;
                                                phi_6623_ = true;
                                                loop {
                                                    let _e3989 = phi_6616_;
                                                    let _e3991 = phi_6619_;
                                                    let _e3993 = phi_6621_;
                                                    let _e3995 = phi_6623_;
                                                    local_31 = _e3991;
                                                    local_32 = _e3991;
                                                    local_33 = _e3993;
                                                    local_34 = _e3995;
                                                    local_35 = _e3995;
                                                    local_36 = _e3995;
                                                    local_61 = _e3995;
                                                    local_37 = _e3995;
                                                    let _e3998 = (_e3989.member < _e3989.member_1);
                                                    let _e4009 = select(type_9().member_1, _e3989.member, _e3998);
                                                    let _e4011 = (bitcast<i32>(select(0u, 1u, _e3998)) != 0i);
                                                    if _e4011 {
                                                        let _e4015 = local_1.member[0u][_e4009];
                                                        let _e4022 = local_1.member[1u][_e4009];
                                                        let _e4036 = ((select(_e4015[0], -(_e4015[0]), (_e4015[0] < 0f)) + select(_e4015[1], -(_e4015[1]), (_e4015[1] < 0f))) + select(_e4015[2], -(_e4015[2]), (_e4015[2] < 0f)));
                                                        let _e4047 = ((select(_e4022[0], -(_e4022[0]), (_e4022[0] < 0f)) + select(_e4022[1], -(_e4022[1]), (_e4022[1] < 0f))) + select(_e4022[2], -(_e4022[2]), (_e4022[2] < 0f)));
                                                        let _e4053 = (_e4022[0] - _e4015[0]);
                                                        let _e4054 = (_e4022[1] - _e4015[1]);
                                                        let _e4055 = (_e4022[2] - _e4015[2]);
                                                        let _e4072 = local_2.member[_e4009];
                                                        let _e4075 = local_2.member_1[_e4009];
                                                        let _e4086 = ((_e3387 * 1.01f) + ((select(_e4072, -(_e4072), (_e4072 < 0f)) + select(_e4075, -(_e4075), (_e4075 < 0f))) * (0.000000059604645f * 12f)));
                                                        let _e4093 = local_2.member_1[_e4009];
                                                        let _e4096 = local_2.member[_e4009];
                                                        let _e4097 = (_e4093 - _e4096);
                                                        let _e4100 = ((_e4086 + _e4086) + (_e3987 * ((((select(_e4053, -(_e4053), (_e4053 < 0f)) + select(_e4054, -(_e4054), (_e4054 < 0f))) + select(_e4055, -(_e4055), (_e4055 < 0f))) + (_e3387 * 6f)) * 1.01f)));
                                                        let _e4103 = ((((_e4072 + ((_e4075 - _e4072) * _e1447)) - _e4086) - (_e3987 * ((select(_e4047, _e4036, (_e4036 > _e4047)) + (_e3387 * 3f)) * 1.01f))) - _e3860);
                                                        let _e4104 = (_e4103 > 0.000000000000000000000000000000000000011754944f);
                                                        let _e4105 = (_e4097 > _e4100);
                                                        if _e4105 {
                                                            phi_6854_ = _e3991;
                                                        } else {
                                                            if _e4104 {
                                                                let _e4112 = (_e4100 - _e4097);
                                                                let _e4115 = (_e4103 / select(0.000000000000000000000000000000000000011754944f, _e4112, (_e4112 > 0.000000000000000000000000000000000000011754944f)));
                                                                phi_6853_ = select(_e4115, _e3991, (_e3991 < _e4115));
                                                            } else {
                                                                phi_6853_ = _e3991;
                                                            }
                                                            let _e4119 = phi_6853_;
                                                            phi_6854_ = _e4119;
                                                        }
                                                        let _e4121 = phi_6854_;
                                                        phi_6620_ = _e4121;
                                                        phi_6622_ = (_e3993 && select(_e4104, true, (_e4097 < -(_e4100))));
                                                        phi_6624_ = (_e3995 && select(_e4104, true, _e4105));
                                                    } else {
                                                        phi_6620_ = f32();
                                                        phi_6622_ = bool();
                                                        phi_6624_ = bool();
                                                    }
                                                    let _e4123 = phi_6620_;
                                                    let _e4125 = phi_6622_;
                                                    let _e4127 = phi_6624_;
                                                    continue;
                                                    continuing {
                                                        phi_6616_ = type_9(select(_e3989.member, (_e3989.member + 1u), _e3998), select(_e3989.member_1, _e3989.member_1, _e3998));
                                                        phi_6619_ = _e4123;
                                                        phi_6621_ = _e4125;
                                                        phi_6623_ = _e4127;
                                                        break if !(_e4011);
                                                    }
                                                }
                                                let _e4130 = local_31;
                                                let _e4133 = local_32;
                                                let _e4135 = (select(2f, _e4133, (_e4130 < 2f)) * 0.999f);
                                                let _e4137 = local_33;
                                                if _e4137 {
                                                    let _e4140 = local_34;
                                                    let _e4144 = local_35;
                                                    let _e4148 = local_36;
                                                    phi_6869_ = type_36(select(1u, type_36().member, _e4140), select(_e1447, type_36().member_1, _e4144), select(2f, type_36().member_2, _e4148));
                                                    let _e5287 = local_61;
                                                    phi_6870_ = _e5287;
                                                } else {
                                                    phi_6869_ = type_36();
                                                    phi_6870_ = true;
                                                }
                                                let _e4152 = phi_6869_;
                                                let _e4154 = phi_6870_;
                                                if _e4154 {
                                                    let _e4156 = local_37;
                                                    if _e4156 {
                                                        let _e4160 = (_e1447 + _e4135);
                                                        let _e4163 = select(_e1447, select(_e382, _e4160, (_e4160 < _e382)), (_e4135 > (0.000000059604645f * 4096f)));
                                                        phi_6891_ = type_9(0u, 4u);
                                                        phi_6894_ = _e4163;
                                                        phi_6896_ = _e1447;
                                                        loop {
                                                            let _e4165 = phi_6891_;
                                                            let _e4167 = phi_6894_;
                                                            let _e4169 = phi_6896_;
                                                            local_38 = _e4167;
                                                            local_39 = _e4169;
                                                            local_40 = _e4169;
                                                            let _e4172 = (_e4165.member < _e4165.member_1);
                                                            let _e4183 = select(type_9().member_1, _e4165.member, _e4172);
                                                            let _e4185 = (bitcast<i32>(select(0u, 1u, _e4172)) != 0i);
                                                            if _e4185 {
                                                                let _e4188 = local_2.member[_e4183];
                                                                let _e4191 = local_2.member_1[_e4183];
                                                                let _e4194 = local_2.member[_e4183];
                                                                let _e4200 = local_2.member_2[_e4183];
                                                                let _e4201 = ((_e4188 + ((_e4191 - _e4194) * _e1447)) - _e4200);
                                                                let _e4204 = local_2.member_1[_e4183];
                                                                let _e4207 = local_2.member[_e4183];
                                                                let _e4208 = (_e4204 - _e4207);
                                                                if (_e4208 > 0f) {
                                                                    let _e4221 = (_e1447 - (_e4201 / _e4208));
                                                                    phi_7005_ = _e4167;
                                                                    phi_7006_ = select(_e4221, _e4169, (_e4169 > _e4221));
                                                                } else {
                                                                    if (_e4201 > 0f) {
                                                                        if (_e4208 < 0f) {
                                                                            let _e4213 = (_e1447 - (_e4201 / _e4208));
                                                                            phi_7003_ = select(_e4213, _e4167, (_e4167 < _e4213));
                                                                        } else {
                                                                            phi_7003_ = _e4167;
                                                                        }
                                                                        let _e4217 = phi_7003_;
                                                                        phi_7004_ = _e4217;
                                                                    } else {
                                                                        phi_7004_ = _e4167;
                                                                    }
                                                                    let _e4219 = phi_7004_;
                                                                    phi_7005_ = _e4219;
                                                                    phi_7006_ = _e4169;
                                                                }
                                                                let _e4225 = phi_7005_;
                                                                let _e4227 = phi_7006_;
                                                                phi_6895_ = _e4225;
                                                                phi_6897_ = _e4227;
                                                            } else {
                                                                phi_6895_ = f32();
                                                                phi_6897_ = f32();
                                                            }
                                                            let _e4229 = phi_6895_;
                                                            let _e4231 = phi_6897_;
                                                            continue;
                                                            continuing {
                                                                phi_6891_ = type_9(select(_e4165.member, (_e4165.member + 1u), _e4172), select(_e4165.member_1, _e4165.member_1, _e4172));
                                                                phi_6894_ = _e4229;
                                                                phi_6896_ = _e4231;
                                                                break if !(_e4185);
                                                            }
                                                        }
                                                        let _e4234 = local_38;
                                                        let _e4236 = local_39;
                                                        let _e4240 = local_40;
                                                        let _e4241 = (_e4240 + ((_e4234 - _e4236) * 0.5f));
                                                        if (_e4241 > _e1447) {
                                                            if (_e4241 <= _e4163) {
                                                                let _e4246 = local_2.member[0u];
                                                                let _e4249 = local_2.member_1[0u];
                                                                let _e4252 = local_2.member[0u];
                                                                let _e4258 = local_2.member_2[0u];
                                                                if (((_e4246 + ((_e4249 - _e4252) * _e4241)) - _e4258) > 0f) {
                                                                    let _e4263 = local_2.member[1u];
                                                                    let _e4266 = local_2.member_1[1u];
                                                                    let _e4269 = local_2.member[1u];
                                                                    let _e4275 = local_2.member_2[1u];
                                                                    if (((_e4263 + ((_e4266 - _e4269) * _e4241)) - _e4275) > 0f) {
                                                                        let _e4280 = local_2.member[2u];
                                                                        let _e4283 = local_2.member_1[2u];
                                                                        let _e4286 = local_2.member[2u];
                                                                        let _e4292 = local_2.member_2[2u];
                                                                        if (((_e4280 + ((_e4283 - _e4286) * _e4241)) - _e4292) > 0f) {
                                                                            let _e4297 = local_2.member[3u];
                                                                            let _e4300 = local_2.member_1[3u];
                                                                            let _e4303 = local_2.member[3u];
                                                                            let _e4309 = local_2.member_2[3u];
                                                                            phi_7167_ = (((_e4297 + ((_e4300 - _e4303) * _e4241)) - _e4309) > 0f);
                                                                            phi_7168_ = false;
                                                                        } else {
                                                                            phi_7167_ = bool();
                                                                            phi_7168_ = true;
                                                                        }
                                                                        let _e4313 = phi_7167_;
                                                                        let _e4315 = phi_7168_;
                                                                        phi_7169_ = _e4313;
                                                                        phi_7170_ = _e4315;
                                                                    } else {
                                                                        phi_7169_ = bool();
                                                                        phi_7170_ = true;
                                                                    }
                                                                    let _e4317 = phi_7169_;
                                                                    let _e4319 = phi_7170_;
                                                                    phi_7171_ = _e4317;
                                                                    phi_7172_ = _e4319;
                                                                } else {
                                                                    phi_7171_ = bool();
                                                                    phi_7172_ = true;
                                                                }
                                                                let _e4321 = phi_7171_;
                                                                let _e4323 = phi_7172_;
                                                                phi_7181_ = select(true, false, select(_e4321, false, _e4323));
                                                            } else {
                                                                phi_7181_ = true;
                                                            }
                                                            let _e4327 = phi_7181_;
                                                            phi_7182_ = _e4327;
                                                        } else {
                                                            phi_7182_ = true;
                                                        }
                                                        let _e4329 = phi_7182_;
                                                        phi_7189_ = type_36(2u, _e4163, select(_e4241, 2f, _e4329));
                                                        phi_7190_ = type_36();
                                                        phi_7191_ = false;
                                                    } else {
                                                        phi_7189_ = type_36();
                                                        phi_7190_ = type_36(0u, _e1447, 2f);
                                                        phi_7191_ = true;
                                                    }
                                                    let _e4333 = phi_7189_;
                                                    let _e4335 = phi_7190_;
                                                    let _e4337 = phi_7191_;
                                                    phi_7192_ = _e4333;
                                                    phi_7193_ = _e4335;
                                                    phi_7194_ = _e4337;
                                                } else {
                                                    phi_7192_ = type_36();
                                                    phi_7193_ = _e4152;
                                                    phi_7194_ = true;
                                                }
                                                let _e4339 = phi_7192_;
                                                let _e4341 = phi_7193_;
                                                let _e4343 = phi_7194_;
                                                phi_7199_ = _e4341;
                                                phi_7200_ = _e4339;
                                                phi_7201_ = _e4343;
                                            } else {
                                                phi_7199_ = type_36(0u, _e1447, 2f);
                                                phi_7200_ = type_36();
                                                phi_7201_ = true;
                                            }
                                            let _e4345 = phi_7199_;
                                            let _e4347 = phi_7200_;
                                            let _e4349 = phi_7201_;
                                            phi_7205_ = _e4345;
                                            phi_7206_ = _e4347;
                                            phi_7207_ = false;
                                            phi_7208_ = _e4349;
                                        } else {
                                            phi_7205_ = type_36();
                                            phi_7206_ = type_36();
                                            phi_7207_ = true;
                                            phi_7208_ = false;
                                        }
                                        let _e4351 = phi_7205_;
                                        let _e4353 = phi_7206_;
                                        let _e4355 = phi_7207_;
                                        let _e4357 = phi_7208_;
                                        phi_7209_ = _e4351;
                                        phi_7210_ = _e4353;
                                        phi_7211_ = _e4355;
                                        phi_7212_ = _e4357;
                                    } else {
                                        phi_7209_ = type_36();
                                        phi_7210_ = type_36();
                                        phi_7211_ = true;
                                        phi_7212_ = false;
                                    }
                                    let _e4359 = phi_7209_;
                                    let _e4361 = phi_7210_;
                                    let _e4363 = phi_7211_;
                                    let _e4365 = phi_7212_;
                                    let _e4372 = select(_e4365, true, _e4363);
                                    let _e4374 = select(_e4361.member, select(_e4359.member, 0u, _e4363), _e4372);
                                    let _e4378 = select(_e4361.member_2, select(_e4359.member_2, 2f, _e4363), _e4372);
                                    if select(false, _e374, ((_e384 & 64u) != 0u)) {
                                        let _e4380 = (_e4374 == 2u);
                                        let _e4381 = (_e4378 <= _e382);
                                        phi_7246_ = select(f32(), select(f32(), _e4378, _e4381), _e4380);
                                        phi_7247_ = select(f32(), select(f32(), _e4378, _e4381), _e4380);
                                        phi_7248_ = select(false, _e4381, _e4380);
                                        phi_7249_ = select(false, select(true, false, _e4381), _e4380);
                                        phi_7250_ = select(true, false, _e4380);
                                    } else {
                                        phi_7246_ = f32();
                                        phi_7247_ = f32();
                                        phi_7248_ = false;
                                        phi_7249_ = false;
                                        phi_7250_ = true;
                                    }
                                    let _e4391 = phi_7246_;
                                    let _e4393 = phi_7247_;
                                    let _e4395 = phi_7248_;
                                    let _e4397 = phi_7249_;
                                    let _e4399 = phi_7250_;
                                    phi_7251_ = _e4391;
                                    phi_7252_ = _e4374;
                                    phi_7253_ = _e4393;
                                    phi_7254_ = type_36(_e4374, select(_e4361.member_1, select(_e4359.member_1, _e1447, _e4363), _e4372), _e4378);
                                    phi_7255_ = _e4374;
                                    phi_7256_ = _e4374;
                                    phi_7257_ = _e4395;
                                    phi_7258_ = _e4397;
                                    phi_7259_ = _e4399;
                                }
                                let _e4401 = phi_7251_;
                                let _e4403 = phi_7252_;
                                let _e4405 = phi_7253_;
                                let _e4407 = phi_7254_;
                                let _e4409 = phi_7255_;
                                let _e4411 = phi_7256_;
                                let _e4413 = phi_7257_;
                                let _e4415 = phi_7258_;
                                let _e4417 = phi_7259_;
                                phi_7260_ = _e4401;
                                phi_7261_ = _e4403;
                                phi_7262_ = _e4405;
                                phi_7263_ = _e4407;
                                phi_7264_ = _e4409;
                                phi_7265_ = _e4411;
                                phi_7266_ = _e4413;
                                phi_7267_ = _e3093;
                                phi_7268_ = _e4415;
                                phi_7269_ = _e4417;
                                phi_7270_ = false;
                            } else {
                                phi_7260_ = f32();
                                phi_7261_ = u32();
                                phi_7262_ = f32();
                                phi_7263_ = type_36();
                                phi_7264_ = u32();
                                phi_7265_ = u32();
                                phi_7266_ = false;
                                phi_7267_ = false;
                                phi_7268_ = false;
                                phi_7269_ = false;
                                phi_7270_ = true;
                            }
                            let _e4419 = phi_7260_;
                            let _e4421 = phi_7261_;
                            let _e4423 = phi_7262_;
                            let _e4425 = phi_7263_;
                            let _e4427 = phi_7264_;
                            let _e4429 = phi_7265_;
                            let _e4431 = phi_7266_;
                            let _e4433 = phi_7267_;
                            let _e4435 = phi_7268_;
                            let _e4437 = phi_7269_;
                            let _e4439 = phi_7270_;
                            phi_7271_ = _e3090;
                            phi_2346_ = _e4419;
                            phi_2348_ = _e4421;
                            phi_2350_ = _e4423;
                            phi_7272_ = _e4425;
                            phi_7273_ = _e4427;
                            phi_7274_ = _e3090;
                            phi_7275_ = _e4429;
                            phi_7276_ = _e4431;
                            phi_7277_ = _e4433;
                            phi_7278_ = _e4435;
                            phi_7279_ = _e4437;
                            phi_7280_ = false;
                            phi_7281_ = _e4439;
                        } else {
                            phi_7271_ = f32();
                            phi_2346_ = f32();
                            phi_2348_ = u32();
                            phi_2350_ = f32();
                            phi_7272_ = type_36();
                            phi_7273_ = u32();
                            phi_7274_ = f32();
                            phi_7275_ = u32();
                            phi_7276_ = false;
                            phi_7277_ = false;
                            phi_7278_ = false;
                            phi_7279_ = false;
                            phi_7280_ = true;
                            phi_7281_ = false;
                        }
                        let _e4441 = phi_7271_;
                        let _e4443 = phi_2346_;
                        let _e4445 = phi_2348_;
                        let _e4447 = phi_2350_;
                        let _e4449 = phi_7272_;
                        let _e4451 = phi_7273_;
                        let _e4453 = phi_7274_;
                        let _e4455 = phi_7275_;
                        let _e4457 = phi_7276_;
                        let _e4459 = phi_7277_;
                        let _e4461 = phi_7278_;
                        let _e4463 = phi_7279_;
                        let _e4465 = phi_7280_;
                        let _e4467 = phi_7281_;
                        local_41 = _e4459;
                        local_42 = _e4461;
                        local_43 = _e4459;
                        local_44 = _e4463;
                        local_45 = _e4459;
                        local_46 = _e4465;
                        local_47 = _e4459;
                        local_48 = _e4467;
                        local_49 = _e4449;
                        local_50 = _e4449;
                        local_51 = _e4451;
                        local_52 = _e4449;
                        local_62 = _e4459;
                        local_53 = _e4455;
                        local_55 = _e4453;
                        local_56 = _e4441;
                        continue;
                        continuing {
                            phi_2342_ = _e1465;
                            phi_2345_ = _e4443;
                            phi_2347_ = _e4445;
                            phi_2349_ = _e4447;
                            break if !(_e4457);
                        }
                    }
                    let _e4470 = local_41;
                    let _e4472 = local_42;
                    let _e4473 = select(_e4472, false, _e4470);
                    let _e4475 = local_43;
                    let _e4477 = local_44;
                    let _e4480 = local_45;
                    let _e4482 = local_46;
                    let _e4485 = local_47;
                    let _e4487 = local_48;
                    if _e4473 {
                        let _e4490 = local_49;
                        if (_e4490.member_1 >= _e382) {
                            phi_7310_ = type_35(type_34(0u, f32()), 0u);
                        } else {
                            let _e4494 = local_50;
                            let _e4498 = local_51;
                            let _e4501 = local_52;
                            phi_7310_ = type_35(type_34(2u, _e4501.member_1), select(_e4498, 0u, (_e4494.member_1 > _e380)));
                        }
                        let _e4508 = phi_7310_;
                        phi_7311_ = _e4508;
                        phi_7312_ = false;
                        phi_7313_ = false;
                        phi_7314_ = false;
                        phi_7315_ = false;
                    } else {
                        phi_7311_ = type_35();
                        phi_7312_ = select(_e4477, false, _e4475);
                        let _e5382 = local_62;
                        phi_7313_ = _e5382;
                        phi_7314_ = select(_e4482, false, _e4480);
                        phi_7315_ = select(_e4487, false, _e4485);
                    }
                    let _e4510 = phi_7311_;
                    let _e4512 = phi_7312_;
                    let _e4514 = phi_7313_;
                    let _e4516 = phi_7314_;
                    let _e4518 = phi_7315_;
                    let _e4520 = local_53;
                    let _e4522 = local_54;
                    let _e4525 = local_55;
                    let _e4527 = local_56;
                    let _e4529 = select(_e4514, true, _e4512);
                    let _e4534 = local_57;
                    let _e4535 = select(_e4534, select(_e4527, _e4525, _e4512), _e4529);
                    let _e4537 = local_58;
                    let _e4538 = select(_e4537, select(_e4522, _e4520, _e4512), _e4529);
                    if select(select(_e4516, false, _e4512), true, _e4529) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_7347_ = type_9(0u, 3u);
                        loop {
                            let _e4549 = phi_7347_;
                            let _e4552 = (_e4549.member < _e4549.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4552)) != 0i) {
                                let _e4567 = local[select(type_9().member_1, _e4549.member, _e4552)];
                                let _e4569 = (_e4535 + (select(0f, _e378, (_e378 >= (0.000000059604645f * 8f))) * _e4567));
                                let _e4571 = select(_e382, _e4569, (_e4569 < _e382));
                                let _e4574 = local_5.member[0u];
                                let _e4580 = local_5.member[1u];
                                let _e4596 = local_5.member_1[0u];
                                let _e4602 = local_5.member_1[1u];
                                let _e4618 = local_5.member_2[0u];
                                let _e4624 = local_5.member_2[1u];
                                let _e4638 = function_3(array<f32, 3>((_e4574[0] + ((_e4580[0] - _e4574[0]) * _e4571)), (_e4574[1] + ((_e4580[1] - _e4574[1]) * _e4571)), (_e4574[2] + ((_e4580[2] - _e4574[2]) * _e4571))), array<f32, 3>((_e4596[0] + ((_e4602[0] - _e4596[0]) * _e4571)), (_e4596[1] + ((_e4602[1] - _e4596[1]) * _e4571)), (_e4596[2] + ((_e4602[2] - _e4596[2]) * _e4571))), array<f32, 3>((_e4618[0] + ((_e4624[0] - _e4618[0]) * _e4571)), (_e4618[1] + ((_e4624[1] - _e4618[1]) * _e4571)), (_e4618[2] + ((_e4624[2] - _e4618[2]) * _e4571))), _e225.member);
                                let _e4649 = (((_e4638[0] * _e4638[0]) + (_e4638[1] * _e4638[1])) + (_e4638[2] * _e4638[2]));
                                if (_e4649 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_7579_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4649 > 0f));
                                } else {
                                    phi_7522_ = type_14(0i, 5i);
                                    phi_7525_ = bitcast<f32>(((bitcast<u32>(_e4649) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e4657 = phi_7522_;
                                        let _e4659 = phi_7525_;
                                        local_59 = _e4659;
                                        if (_e4657.member < _e4657.member_1) {
                                            let _e4666 = (_e4657.member + 1i);
                                            phi_7523_ = type_14(select(_e4666, type_15().member_1, select(false, true, ((false == (_e4666 > _e4657.member)) != false))), _e4657.member_1);
                                            phi_7566_ = type_15(1u, _e4657.member);
                                        } else {
                                            phi_7523_ = _e4657;
                                            phi_7566_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e4677 = phi_7523_;
                                        let _e4679 = phi_7566_;
                                        let _e4682 = (bitcast<i32>(_e4679.member) != 0i);
                                        if _e4682 {
                                            phi_7526_ = (0.5f * (_e4659 + (_e4649 / _e4659)));
                                        } else {
                                            phi_7526_ = f32();
                                        }
                                        let _e4687 = phi_7526_;
                                        continue;
                                        continuing {
                                            phi_7522_ = _e4677;
                                            phi_7525_ = _e4687;
                                            break if !(_e4682);
                                        }
                                    }
                                    let _e4692 = local_59;
                                    phi_7579_ = (_e4692 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e4698 = phi_7579_;
                                let _e4704 = local_5.member[0u];
                                let _e4710 = select(_e4704[0], -(_e4704[0]), (_e4704[0] < 0f));
                                let _e4713 = select(_e4704[1], -(_e4704[1]), (_e4704[1] < 0f));
                                let _e4715 = select(_e4713, _e4710, (_e4710 > _e4713));
                                let _e4718 = select(_e4704[2], -(_e4704[2]), (_e4704[2] < 0f));
                                let _e4720 = select(_e4718, _e4715, (_e4715 > _e4718));
                                let _e4723 = local_5.member[1u];
                                let _e4729 = select(_e4723[0], -(_e4723[0]), (_e4723[0] < 0f));
                                let _e4732 = select(_e4723[1], -(_e4723[1]), (_e4723[1] < 0f));
                                let _e4734 = select(_e4732, _e4729, (_e4729 > _e4732));
                                let _e4737 = select(_e4723[2], -(_e4723[2]), (_e4723[2] < 0f));
                                let _e4739 = select(_e4737, _e4734, (_e4734 > _e4737));
                                let _e4743 = local_5.member_3;
                                let _e4747 = local_5.member_1[0u];
                                let _e4753 = select(_e4747[0], -(_e4747[0]), (_e4747[0] < 0f));
                                let _e4756 = select(_e4747[1], -(_e4747[1]), (_e4747[1] < 0f));
                                let _e4758 = select(_e4756, _e4753, (_e4753 > _e4756));
                                let _e4761 = select(_e4747[2], -(_e4747[2]), (_e4747[2] < 0f));
                                let _e4763 = select(_e4761, _e4758, (_e4758 > _e4761));
                                let _e4766 = local_5.member_1[1u];
                                let _e4772 = select(_e4766[0], -(_e4766[0]), (_e4766[0] < 0f));
                                let _e4775 = select(_e4766[1], -(_e4766[1]), (_e4766[1] < 0f));
                                let _e4777 = select(_e4775, _e4772, (_e4772 > _e4775));
                                let _e4780 = select(_e4766[2], -(_e4766[2]), (_e4766[2] < 0f));
                                let _e4782 = select(_e4780, _e4777, (_e4777 > _e4780));
                                let _e4786 = local_5.member_3;
                                let _e4790 = local_5.member_2[0u];
                                let _e4796 = select(_e4790[0], -(_e4790[0]), (_e4790[0] < 0f));
                                let _e4799 = select(_e4790[1], -(_e4790[1]), (_e4790[1] < 0f));
                                let _e4801 = select(_e4799, _e4796, (_e4796 > _e4799));
                                let _e4804 = select(_e4790[2], -(_e4790[2]), (_e4790[2] < 0f));
                                let _e4806 = select(_e4804, _e4801, (_e4801 > _e4804));
                                let _e4809 = local_5.member_2[1u];
                                let _e4815 = select(_e4809[0], -(_e4809[0]), (_e4809[0] < 0f));
                                let _e4818 = select(_e4809[1], -(_e4809[1]), (_e4809[1] < 0f));
                                let _e4820 = select(_e4818, _e4815, (_e4815 > _e4818));
                                let _e4823 = select(_e4809[2], -(_e4809[2]), (_e4809[2] < 0f));
                                let _e4825 = select(_e4823, _e4820, (_e4820 > _e4823));
                                let _e4829 = local_5.member_3;
                                let _e4836 = local_5.member_3;
                                let _e4843 = (((_e4698 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4739, _e4720, (_e4720 > _e4739)) + _e4743) + (select(_e4782, _e4763, (_e4763 > _e4782)) + _e4786)) + (select(_e4825, _e4806, (_e4806 > _e4825)) + _e4829)) * (0.000000059604645f * 16f)) + (_e4836 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e733.member_1);
                                phi_7850_ = select(true, false, _e4843);
                                phi_7851_ = _e4843;
                            } else {
                                phi_7850_ = false;
                                phi_7851_ = false;
                            }
                            let _e4846 = phi_7850_;
                            let _e4848 = phi_7851_;
                            local_60 = _e4848;
                            continue;
                            continuing {
                                phi_7347_ = type_9(select(_e4549.member, (_e4549.member + 1u), _e4552), select(_e4549.member_1, _e4549.member_1, _e4552));
                                break if !(_e4846);
                            }
                        }
                        let _e4851 = local_60;
                        if _e4851 {
                            phi_7863_ = type_35(type_34(1u, _e4535), select(_e4538, 1u, (_e4535 > _e380)));
                            phi_7864_ = false;
                        } else {
                            phi_7863_ = type_35();
                            phi_7864_ = true;
                        }
                        let _e4857 = phi_7863_;
                        let _e4859 = phi_7864_;
                        if _e4859 {
                            phi_7876_ = type_35(type_34(2u, _e4535), select(_e4538, 0u, (_e4535 > _e380)));
                        } else {
                            phi_7876_ = _e4857;
                        }
                        let _e4865 = phi_7876_;
                        phi_7877_ = _e4865;
                        phi_7878_ = false;
                        phi_7879_ = false;
                    } else {
                        phi_7877_ = type_35();
                        phi_7878_ = select(select(_e4518, false, _e4512), false, _e4529);
                        phi_7879_ = select(select(_e4473, false, _e4512), false, _e4529);
                    }
                    let _e4867 = phi_7877_;
                    let _e4869 = phi_7878_;
                    let _e4871 = phi_7879_;
                    if _e4869 {
                        phi_7886_ = type_35(type_34(0u, f32()), 0u);
                        phi_7887_ = true;
                    } else {
                        phi_7886_ = _e4510;
                        phi_7887_ = _e4871;
                    }
                    let _e4875 = phi_7886_;
                    let _e4877 = phi_7887_;
                    phi_7891_ = _e4875;
                    phi_7892_ = _e4867;
                    phi_7893_ = _e4877;
                } else {
                    phi_7891_ = _e1437;
                    phi_7892_ = type_35();
                    phi_7893_ = true;
                }
                let _e4879 = phi_7891_;
                let _e4881 = phi_7892_;
                let _e4883 = phi_7893_;
                if _e4883 {
                    phi_7897_ = _e4879;
                } else {
                    phi_7897_ = _e4881;
                }
                let _e4885 = phi_7897_;
                switch bitcast<i32>(_e4885.member.member) {
                    case 0: {
                        phi_7915_ = type_32(0u, _e4885.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4896 = function_(_e4885.member.member_1);
                        phi_7915_ = type_32(0u, _e4885.member_1, _e4896, true);
                        break;
                    }
                    case 2: {
                        let _e4892 = function_(_e4885.member.member_1);
                        phi_7915_ = type_32(1u, _e4885.member_1, _e4892, true);
                        break;
                    }
                    default: {
                        phi_7915_ = type_32();
                        break;
                    }
                }
                let _e4900 = phi_7915_;
                let _e4904 = params.member.member.member_12;
                let _e4905 = bitcast<u32>(_e4904);
                if (_e4900.member_2[0] == select((_e4905 << bitcast<u32>(29i)), 0u, ((_e4905 & 2147483647u) < 8388608u))) {
                    let _e4915 = params.member.member.member_12;
                    let _e4916 = bitcast<u32>(_e4915);
                    let _e4917 = (_e4916 & 2147483647u);
                    phi_7955_ = (_e4900.member_2[1] == select(((_e4916 ^ _e4917) | ((_e4917 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4917 < 8388608u)));
                } else {
                    phi_7955_ = false;
                }
                let _e4927 = phi_7955_;
                let _e4929 = params.member.member.member_1;
                if ((_e4929 & 128u) != 0u) {
                    phi_7971_ = true;
                } else {
                    let _e4933 = params.member.member.member_1;
                    phi_7971_ = select(false, _e4927, ((_e4933 & 64u) != 0u));
                }
                let _e4938 = phi_7971_;
                local_6 = type_32(select(1u, _e4900.member, select(true, select(true, false, _e4938), _e4900.member_3)), _e4900.member_1, array<u32, 2>(_e4900.member_2[0], _e4900.member_2[1]), _e4900.member_3);
                phi_7998_ = type_9(_e183, _e186);
            } else {
                phi_7998_ = type_9(0u, 0u);
            }
            let _e4952 = phi_7998_;
            let _e4958 = local_6.member;
            let _e4960 = select(true, false, (_e4958 == 0u));
            let _e4962 = local_6.member_3;
            if _e4962 {
                if _e4960 {
                    phi_8027_ = true;
                } else {
                    let _e4964 = params.member.member.member_1;
                    phi_8027_ = ((_e4964 & 16u) != 0u);
                }
                let _e4968 = phi_8027_;
                phi_8028_ = _e4968;
            } else {
                phi_8028_ = false;
            }
            let _e4970 = phi_8028_;
            let _e4972 = local_6.member_3;
            if _e4972 {
                if _e4960 {
                } else {
                    let _e4974 = local_6.member_2;
                    let _e4978 = (_e4974[1] >> bitcast<u32>(20i));
                    let _e4992 = atomicMin((&earliest.member[0u]), select(((((_e4978 - 896u) << bitcast<u32>(23i)) | ((_e4974[1] & 1048575u) << bitcast<u32>(3i))) | (_e4974[0] >> bitcast<u32>(29i))), 0u, (_e4978 <= 896u)));
                }
            }
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4970 {
                let _e4996 = atomicAdd((&counters[0u]), 1u);
                phi_8071_ = _e4996;
            } else {
                phi_8071_ = 0u;
            }
            let _e4998 = phi_8071_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e5001 = atomicLoad((&counters[0u]));
                if (_e5001 > 0u) {
                    let _e5004 = atomicAdd((&contacts.member[0u]), _e5001);
                    atomicStore((&counters[1u]), _e5004);
                }
            }
            workgroupBarrier();
            let _e5007 = atomicLoad((&counters[1u]));
            let _e5008 = (_e5007 + _e4998);
            if _e4970 {
                let _e5010 = params.member.member_1.member_3;
                if (_e5008 < _e5010) {
                    let _e5016 = (7u * _e5008);
                    atomicStore((&contacts.member[(4u + _e5016)]), select(1u, 0u, ((_e4952.member_1 & 2147483648u) == 0u)));
                    let _e5021 = local_6.member;
                    atomicStore((&contacts.member[(_e5016 + 5u)]), _e5021);
                    atomicStore((&contacts.member[(_e5016 + 6u)]), _e4952.member);
                    atomicStore((&contacts.member[(_e5016 + 7u)]), (_e4952.member_1 & 2147483647u));
                    let _e5030 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e5016 + 8u)]), _e5030);
                    let _e5035 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e5016 + 9u)]), _e5035);
                    let _e5039 = local_6.member_1;
                    atomicStore((&contacts.member[(_e5016 + 10u)]), _e5039);
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
