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
    var phi_8633_: array<array<f32, 3>, 4>;

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
        phi_8633_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e155)), (param_3[1] - (param_4[1] * _e155)), (param_3[2] - (param_4[2] * _e155))), array<f32, 3>((param_3[0] - (param_5[0] * _e195)), (param_3[1] - (param_5[1] * _e195)), (param_3[2] - (param_5[2] * _e195))), array<f32, 3>((_e9 - (param_5[0] * _e232)), (_e12 - (param_5[1] * _e232)), (_e15 - (param_5[2] * _e232))), array<f32, 3>((_e245 - (param_4[0] * _e275)), (_e248 - (param_4[1] * _e275)), (_e251 - (param_4[2] * _e275))));
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
        phi_8633_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e74)), (param_3[1] - (param_4[1] * _e74)), (param_3[2] - (param_4[2] * _e74))), array<f32, 3>((param_3[0] - (param_5[0] * _e114)), (param_3[1] - (param_5[1] * _e114)), (param_3[2] - (param_5[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_8633_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_8261_: bool;
    var phi_8294_: array<f32, 3>;
    var phi_8295_: bool;
    var phi_8296_: array<f32, 3>;
    var phi_8297_: bool;
    var phi_8302_: array<f32, 3>;

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
        phi_8261_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_8261_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_8261_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_8294_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_8295_ = false;
        } else {
            phi_8294_ = array<f32, 3>();
            phi_8295_ = true;
        }
        let _e129 = phi_8294_;
        let _e131 = phi_8295_;
        phi_8296_ = _e129;
        phi_8297_ = _e131;
    } else {
        phi_8296_ = array<f32, 3>();
        phi_8297_ = true;
    }
    let _e133 = phi_8296_;
    let _e135 = phi_8297_;
    if _e135 {
        let _e136 = function_2(param_7, param_8, param_9, param_10);
        phi_8302_ = _e136;
    } else {
        phi_8302_ = _e133;
    }
    let _e138 = phi_8302_;
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
    var phi_237_: u32;
    var phi_282_: u32;
    var phi_285_: type_9;
    var phi_459_: type_22;
    var phi_594_: type_28;
    var phi_623_: bool;
    var phi_1094_: bool;
    var phi_1188_: type_33;
    var phi_1189_: bool;
    var phi_1190_: type_33;
    var phi_1191_: bool;
    var phi_1192_: type_33;
    var phi_1193_: bool;
    var phi_1198_: type_33;
    var phi_1368_: type_14;
    var phi_1371_: f32;
    var phi_1369_: type_14;
    var phi_1412_: type_15;
    var phi_1372_: f32;
    var local_7: f32;
    var phi_1425_: f32;
    var phi_2334_: type_35;
    var phi_2335_: bool;
    var phi_2336_: type_35;
    var phi_2337_: bool;
    var phi_2343_: type_14;
    var phi_2346_: f32;
    var phi_2348_: u32;
    var phi_2350_: f32;
    var phi_2344_: type_14;
    var phi_2391_: type_15;
    var phi_2828_: type_9;
    var phi_2831_: f32;
    var phi_2833_: f32;
    var phi_2835_: f32;
    var phi_2837_: f32;
    var phi_2839_: bool;
    var phi_2841_: u32;
    var phi_2992_: array<f32, 3>;
    var phi_3058_: type_14;
    var phi_3061_: f32;
    var phi_3059_: type_14;
    var phi_3102_: type_15;
    var phi_3062_: f32;
    var local_8: f32;
    var phi_3115_: f32;
    var phi_3238_: type_31;
    var phi_3239_: bool;
    var phi_3240_: type_31;
    var phi_3241_: bool;
    var phi_3249_: type_31;
    var phi_3420_: bool;
    var phi_3421_: bool;
    var phi_3422_: bool;
    var phi_3423_: bool;
    var phi_3424_: bool;
    var phi_3425_: bool;
    var phi_3726_: bool;
    var phi_3727_: bool;
    var phi_3728_: bool;
    var phi_3729_: bool;
    var phi_3730_: bool;
    var phi_3731_: bool;
    var phi_3739_: bool;
    var phi_3846_: f32;
    var phi_3847_: bool;
    var phi_3848_: f32;
    var phi_3849_: bool;
    var phi_3850_: f32;
    var phi_3851_: bool;
    var phi_3852_: bool;
    var phi_3914_: f32;
    var phi_3915_: bool;
    var phi_3916_: f32;
    var phi_3917_: bool;
    var phi_3918_: f32;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3987_: f32;
    var phi_3988_: bool;
    var phi_3989_: f32;
    var phi_3990_: bool;
    var phi_3991_: f32;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_4055_: f32;
    var phi_4056_: bool;
    var phi_4057_: f32;
    var phi_4058_: bool;
    var phi_4059_: f32;
    var phi_4060_: bool;
    var phi_4061_: bool;
    var phi_4235_: type_14;
    var phi_4238_: f32;
    var phi_4236_: type_14;
    var phi_4279_: type_15;
    var phi_4239_: f32;
    var local_9: f32;
    var phi_4292_: f32;
    var phi_4563_: bool;
    var phi_4564_: bool;
    var phi_4590_: f32;
    var phi_4591_: f32;
    var phi_4592_: bool;
    var phi_4593_: bool;
    var phi_4594_: f32;
    var phi_4595_: f32;
    var phi_4596_: f32;
    var phi_4597_: f32;
    var phi_4598_: bool;
    var phi_4599_: bool;
    var phi_4600_: bool;
    var phi_4601_: bool;
    var phi_4602_: f32;
    var phi_4603_: f32;
    var phi_4604_: f32;
    var phi_4605_: f32;
    var phi_4606_: bool;
    var phi_4607_: bool;
    var phi_4608_: bool;
    var phi_4609_: bool;
    var phi_4610_: bool;
    var phi_4611_: f32;
    var phi_4612_: f32;
    var phi_4613_: f32;
    var phi_4614_: f32;
    var phi_4615_: bool;
    var phi_4616_: bool;
    var phi_4617_: bool;
    var phi_4618_: bool;
    var phi_4619_: bool;
    var phi_4952_: f32;
    var phi_4954_: u32;
    var phi_4955_: f32;
    var phi_4956_: bool;
    var phi_4957_: bool;
    var phi_4958_: bool;
    var phi_4959_: u32;
    var phi_4960_: f32;
    var phi_4961_: f32;
    var phi_4962_: f32;
    var phi_4963_: f32;
    var phi_4964_: bool;
    var phi_4965_: u32;
    var phi_4966_: bool;
    var phi_4967_: bool;
    var phi_4968_: bool;
    var phi_4969_: bool;
    var phi_4970_: bool;
    var phi_4971_: bool;
    var phi_4999_: f32;
    var phi_5000_: f32;
    var phi_5001_: f32;
    var phi_5002_: f32;
    var phi_5003_: bool;
    var phi_5004_: u32;
    var phi_5005_: bool;
    var phi_5006_: bool;
    var phi_5007_: bool;
    var phi_5008_: bool;
    var phi_5009_: bool;
    var phi_5010_: bool;
    var phi_2832_: f32;
    var phi_2834_: f32;
    var phi_2836_: f32;
    var phi_2838_: f32;
    var phi_2840_: bool;
    var phi_2842_: u32;
    var phi_5011_: f32;
    var phi_5012_: f32;
    var phi_5013_: bool;
    var phi_5014_: bool;
    var phi_5015_: bool;
    var phi_5016_: bool;
    var phi_5017_: bool;
    var phi_5018_: bool;
    var phi_5019_: bool;
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
    var phi_5086_: f32;
    var phi_5087_: bool;
    var phi_5707_: type_14;
    var phi_5710_: f32;
    var phi_5708_: type_14;
    var phi_5751_: type_15;
    var phi_5711_: f32;
    var local_25: f32;
    var phi_5764_: f32;
    var phi_5999_: type_14;
    var phi_6002_: f32;
    var phi_6000_: type_14;
    var phi_6043_: type_15;
    var phi_6003_: f32;
    var local_26: f32;
    var phi_6056_: f32;
    var phi_6088_: type_14;
    var phi_6091_: f32;
    var phi_6089_: type_14;
    var phi_6132_: type_15;
    var phi_6092_: f32;
    var local_27: f32;
    var phi_6145_: f32;
    var phi_6453_: type_9;
    var phi_6456_: f32;
    var phi_6457_: f32;
    var local_28: f32;
    var local_29: f32;
    var phi_6555_: type_14;
    var phi_6558_: f32;
    var phi_6556_: type_14;
    var phi_6599_: type_15;
    var phi_6559_: f32;
    var local_30: f32;
    var phi_6612_: f32;
    var phi_6617_: type_9;
    var phi_6620_: f32;
    var phi_6622_: bool;
    var phi_6624_: bool;
    var phi_6854_: f32;
    var phi_6855_: f32;
    var phi_6621_: f32;
    var phi_6623_: bool;
    var phi_6625_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_6870_: type_36;
    var phi_6871_: bool;
    var local_37: bool;
    var phi_6892_: type_9;
    var phi_6895_: f32;
    var phi_6897_: f32;
    var phi_7004_: f32;
    var phi_7005_: f32;
    var phi_7006_: f32;
    var phi_7007_: f32;
    var phi_6896_: f32;
    var phi_6898_: f32;
    var local_38: f32;
    var local_39: f32;
    var local_40: f32;
    var phi_7168_: bool;
    var phi_7169_: bool;
    var phi_7170_: bool;
    var phi_7171_: bool;
    var phi_7172_: bool;
    var phi_7173_: bool;
    var phi_7182_: bool;
    var phi_7183_: bool;
    var phi_7190_: type_36;
    var phi_7191_: type_36;
    var phi_7192_: bool;
    var phi_7193_: type_36;
    var phi_7194_: type_36;
    var phi_7195_: bool;
    var phi_7200_: type_36;
    var phi_7201_: type_36;
    var phi_7202_: bool;
    var phi_7206_: type_36;
    var phi_7207_: type_36;
    var phi_7208_: bool;
    var phi_7209_: bool;
    var phi_7210_: type_36;
    var phi_7211_: type_36;
    var phi_7212_: bool;
    var phi_7213_: bool;
    var phi_7247_: f32;
    var phi_7248_: f32;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var phi_7251_: bool;
    var phi_7252_: f32;
    var phi_7253_: u32;
    var phi_7254_: f32;
    var phi_7255_: type_36;
    var phi_7256_: u32;
    var phi_7257_: u32;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: f32;
    var phi_7262_: u32;
    var phi_7263_: f32;
    var phi_7264_: type_36;
    var phi_7265_: u32;
    var phi_7266_: u32;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: f32;
    var phi_2347_: f32;
    var phi_2349_: u32;
    var phi_2351_: f32;
    var phi_7273_: type_36;
    var phi_7274_: u32;
    var phi_7275_: f32;
    var phi_7276_: u32;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
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
    var phi_7311_: type_35;
    var phi_7312_: type_35;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;
    var local_58: u32;
    var phi_7348_: type_9;
    var phi_7523_: type_14;
    var phi_7526_: f32;
    var phi_7524_: type_14;
    var phi_7567_: type_15;
    var phi_7527_: f32;
    var local_59: f32;
    var phi_7580_: f32;
    var phi_7851_: bool;
    var phi_7852_: bool;
    var local_60: bool;
    var phi_7864_: type_35;
    var phi_7865_: bool;
    var phi_7877_: type_35;
    var phi_7878_: type_35;
    var phi_7879_: bool;
    var phi_7880_: bool;
    var phi_7887_: type_35;
    var phi_7888_: bool;
    var phi_7892_: type_35;
    var phi_7893_: type_35;
    var phi_7894_: bool;
    var phi_7898_: type_35;
    var phi_7916_: type_32;
    var phi_7956_: bool;
    var phi_7972_: bool;
    var phi_7999_: type_9;
    var phi_8028_: bool;
    var phi_8029_: bool;
    var phi_8073_: u32;
    var local_61: bool;
    var local_62: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e101 = id_2;
    let _e102 = n_2;
    let _e103 = lane_2;
    let _e114 = ((_e101.y * _e102.x) + _e101.x);
    let _e117 = (_e102.x * _e102.y);
    let _e120 = params.member.member_1.member_2;
    let _e122 = input.member[0u];
    let _e124 = select(_e122, _e120, (_e120 < _e122));
    let _e126 = params.member.member_1.member_1;
    if (_e124 > _e126) {
        let _e129 = params.member.member_1.member_1;
        phi_237_ = (_e124 - _e129);
    } else {
        phi_237_ = 0u;
    }
    let _e132 = phi_237_;
    let _e134 = params.member.member_1.member;
    let _e136 = select(_e132, _e134, (_e134 < _e132));
    let _e137 = (_e136 / 64u);
    let _e141 = select(_e137, (_e137 + 1u), ((_e136 % 64u) > 0u));
    if (_e141 > _e114) {
        let _e143 = (_e141 - _e114);
        if (_e117 == 0u) {
            return;
        }
        let _e145 = (_e143 / _e117);
        if (_e117 == 0u) {
            return;
        }
        phi_282_ = select(_e145, (_e145 + 1u), ((_e143 % _e117) > 0u));
    } else {
        phi_282_ = 0u;
    }
    let _e152 = phi_282_;
    phi_285_ = type_9(0u, _e152);
    loop {
        let _e155 = phi_285_;
        let _e158 = (_e155.member < _e155.member_1);
        let _e171 = (bitcast<i32>(select(0u, 1u, _e158)) != 0i);
        if _e171 {
            let _e175 = (((_e114 + (select(type_9().member_1, _e155.member, _e158) * _e117)) * 64u) + _e103);
            local_6 = type_32(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e175 < _e136) {
                let _e179 = params.member.member_1.member_1;
                let _e181 = (2u * (_e179 + _e175));
                let _e184 = input.member[(4u + _e181)];
                let _e187 = input.member[(_e181 + 5u)];
                let _e192 = (_e187 & 2147483647u);
                if (select(1u, 0u, ((_e187 & 2147483648u) == 0u)) == 0u) {
                    let _e211 = params.member.member.member[1u];
                    let _e214 = ((2u * _e211) + (3u * _e192));
                    let _e216 = elements.member[_e214];
                    let _e219 = elements.member[(_e214 + 1u)];
                    let _e222 = elements.member[(_e214 + 2u)];
                    phi_459_ = type_22(0u, array<u32, 4>(_e184, _e216, _e219, _e222));
                } else {
                    let _e195 = (2u * _e184);
                    let _e197 = elements.member[_e195];
                    let _e200 = elements.member[(_e195 + 1u)];
                    let _e201 = (2u * _e192);
                    let _e203 = elements.member[_e201];
                    let _e206 = elements.member[(_e201 + 1u)];
                    phi_459_ = type_22(1u, array<u32, 4>(_e197, _e200, _e203, _e206));
                }
                let _e226 = phi_459_;
                let _e231 = paths.member[_e226.member_1[0]];
                let _e246 = paths.member[_e226.member_1[1]];
                let _e261 = paths.member[_e226.member_1[2]];
                let _e276 = paths.member[_e226.member_1[3]];
                let _e290 = params.member.member.member_4;
                if (_e226.member != 0u) {
                    phi_594_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e231.member.x), (_e261.member.y - _e231.member.y), (_e261.member.z - _e231.member.z)), array<f32, 3>((_e261.member_1.x - _e231.member_1.x), (_e261.member_1.y - _e231.member_1.y), (_e261.member_1.z - _e231.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e246.member.x - _e231.member.x), (_e246.member.y - _e231.member.y), (_e246.member.z - _e231.member.z)), array<f32, 3>((_e246.member_1.x - _e231.member_1.x), (_e246.member_1.y - _e231.member_1.y), (_e246.member_1.z - _e231.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e276.member.x), (_e261.member.y - _e276.member.y), (_e261.member.z - _e276.member.z)), array<f32, 3>((_e261.member_1.x - _e276.member_1.x), (_e261.member_1.y - _e276.member_1.y), (_e261.member_1.z - _e276.member_1.z))), (_e290 + _e290));
                } else {
                    phi_594_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e231.member.x - _e246.member.x), (_e231.member.y - _e246.member.y), (_e231.member.z - _e246.member.z)), array<f32, 3>((_e231.member_1.x - _e246.member_1.x), (_e231.member_1.y - _e246.member_1.y), (_e231.member_1.z - _e246.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e246.member.x), (_e261.member.y - _e246.member.y), (_e261.member.z - _e246.member.z)), array<f32, 3>((_e261.member_1.x - _e246.member_1.x), (_e261.member_1.y - _e246.member_1.y), (_e261.member_1.z - _e246.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e276.member.x - _e246.member.x), (_e276.member.y - _e246.member.y), (_e276.member.z - _e246.member.z)), array<f32, 3>((_e276.member_1.x - _e246.member_1.x), (_e276.member_1.y - _e246.member_1.y), (_e276.member_1.z - _e246.member_1.z))), (_e290 + _e290));
                }
                let _e351 = phi_594_;
                let _e353 = params.member.member.member_12;
                let _e354 = bitcast<u32>(_e353);
                let _e355 = (_e354 & 2147483647u);
                let _e356 = (_e355 < 8388608u);
                let _e368 = params.member.member.member_15[0u];
                if (select((_e354 << bitcast<u32>(29i)), 0u, _e356) == _e368) {
                    let _e372 = params.member.member.member_15[1u];
                    phi_623_ = (select(((_e354 ^ _e355) | ((_e355 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e356) == _e372);
                } else {
                    phi_623_ = false;
                }
                let _e375 = phi_623_;
                let _e377 = params.member.member.member_5;
                let _e379 = params.member.member.member_11;
                let _e381 = params.member.member.member_12;
                let _e383 = params.member.member.member_13;
                let _e385 = params.member.member.member_1;
                let _e394 = select(_e351.member[0][0], -(_e351.member[0][0]), (_e351.member[0][0] < 0f));
                let _e398 = select(_e351.member[0][1], -(_e351.member[0][1]), (_e351.member[0][1] < 0f));
                let _e400 = select(_e398, _e394, (_e394 > _e398));
                let _e404 = select(_e351.member[0][2], -(_e351.member[0][2]), (_e351.member[0][2] < 0f));
                let _e406 = select(_e404, _e400, (_e400 > _e404));
                let _e412 = select(_e351.member[1][0], -(_e351.member[1][0]), (_e351.member[1][0] < 0f));
                let _e416 = select(_e351.member[1][1], -(_e351.member[1][1]), (_e351.member[1][1] < 0f));
                let _e418 = select(_e416, _e412, (_e412 > _e416));
                let _e422 = select(_e351.member[1][2], -(_e351.member[1][2]), (_e351.member[1][2] < 0f));
                let _e424 = select(_e422, _e418, (_e418 > _e422));
                let _e428 = (select(_e424, _e406, (_e406 > _e424)) + _e351.member_3);
                let _e434 = select(_e351.member_1[0][0], -(_e351.member_1[0][0]), (_e351.member_1[0][0] < 0f));
                let _e438 = select(_e351.member_1[0][1], -(_e351.member_1[0][1]), (_e351.member_1[0][1] < 0f));
                let _e440 = select(_e438, _e434, (_e434 > _e438));
                let _e444 = select(_e351.member_1[0][2], -(_e351.member_1[0][2]), (_e351.member_1[0][2] < 0f));
                let _e446 = select(_e444, _e440, (_e440 > _e444));
                let _e452 = select(_e351.member_1[1][0], -(_e351.member_1[1][0]), (_e351.member_1[1][0] < 0f));
                let _e456 = select(_e351.member_1[1][1], -(_e351.member_1[1][1]), (_e351.member_1[1][1] < 0f));
                let _e458 = select(_e456, _e452, (_e452 > _e456));
                let _e462 = select(_e351.member_1[1][2], -(_e351.member_1[1][2]), (_e351.member_1[1][2] < 0f));
                let _e464 = select(_e462, _e458, (_e458 > _e462));
                let _e468 = (select(_e464, _e446, (_e446 > _e464)) + _e351.member_3);
                let _e474 = select(_e351.member_2[0][0], -(_e351.member_2[0][0]), (_e351.member_2[0][0] < 0f));
                let _e478 = select(_e351.member_2[0][1], -(_e351.member_2[0][1]), (_e351.member_2[0][1] < 0f));
                let _e480 = select(_e478, _e474, (_e474 > _e478));
                let _e484 = select(_e351.member_2[0][2], -(_e351.member_2[0][2]), (_e351.member_2[0][2] < 0f));
                let _e486 = select(_e484, _e480, (_e480 > _e484));
                let _e492 = select(_e351.member_2[1][0], -(_e351.member_2[1][0]), (_e351.member_2[1][0] < 0f));
                let _e496 = select(_e351.member_2[1][1], -(_e351.member_2[1][1]), (_e351.member_2[1][1] < 0f));
                let _e498 = select(_e496, _e492, (_e492 > _e496));
                let _e502 = select(_e351.member_2[1][2], -(_e351.member_2[1][2]), (_e351.member_2[1][2] < 0f));
                let _e504 = select(_e502, _e498, (_e498 > _e502));
                let _e508 = (select(_e504, _e486, (_e486 > _e504)) + _e351.member_3);
                let _e510 = select(_e468, _e428, (_e428 > _e468));
                let _e512 = select(_e508, _e510, (_e510 > _e508));
                let _e518 = select(_e351.member[0][0], -(_e351.member[0][0]), (_e351.member[0][0] < 0f));
                let _e522 = select(_e351.member[0][1], -(_e351.member[0][1]), (_e351.member[0][1] < 0f));
                let _e524 = select(_e522, _e518, (_e518 > _e522));
                let _e528 = select(_e351.member[0][2], -(_e351.member[0][2]), (_e351.member[0][2] < 0f));
                let _e530 = select(_e528, _e524, (_e524 > _e528));
                let _e536 = select(_e351.member[1][0], -(_e351.member[1][0]), (_e351.member[1][0] < 0f));
                let _e540 = select(_e351.member[1][1], -(_e351.member[1][1]), (_e351.member[1][1] < 0f));
                let _e542 = select(_e540, _e536, (_e536 > _e540));
                let _e546 = select(_e351.member[1][2], -(_e351.member[1][2]), (_e351.member[1][2] < 0f));
                let _e548 = select(_e546, _e542, (_e542 > _e546));
                let _e552 = (select(_e548, _e530, (_e530 > _e548)) + _e351.member_3);
                let _e558 = select(_e351.member_1[0][0], -(_e351.member_1[0][0]), (_e351.member_1[0][0] < 0f));
                let _e562 = select(_e351.member_1[0][1], -(_e351.member_1[0][1]), (_e351.member_1[0][1] < 0f));
                let _e564 = select(_e562, _e558, (_e558 > _e562));
                let _e568 = select(_e351.member_1[0][2], -(_e351.member_1[0][2]), (_e351.member_1[0][2] < 0f));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e576 = select(_e351.member_1[1][0], -(_e351.member_1[1][0]), (_e351.member_1[1][0] < 0f));
                let _e580 = select(_e351.member_1[1][1], -(_e351.member_1[1][1]), (_e351.member_1[1][1] < 0f));
                let _e582 = select(_e580, _e576, (_e576 > _e580));
                let _e586 = select(_e351.member_1[1][2], -(_e351.member_1[1][2]), (_e351.member_1[1][2] < 0f));
                let _e588 = select(_e586, _e582, (_e582 > _e586));
                let _e592 = (select(_e588, _e570, (_e570 > _e588)) + _e351.member_3);
                let _e598 = select(_e351.member_2[0][0], -(_e351.member_2[0][0]), (_e351.member_2[0][0] < 0f));
                let _e602 = select(_e351.member_2[0][1], -(_e351.member_2[0][1]), (_e351.member_2[0][1] < 0f));
                let _e604 = select(_e602, _e598, (_e598 > _e602));
                let _e608 = select(_e351.member_2[0][2], -(_e351.member_2[0][2]), (_e351.member_2[0][2] < 0f));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e616 = select(_e351.member_2[1][0], -(_e351.member_2[1][0]), (_e351.member_2[1][0] < 0f));
                let _e620 = select(_e351.member_2[1][1], -(_e351.member_2[1][1]), (_e351.member_2[1][1] < 0f));
                let _e622 = select(_e620, _e616, (_e616 > _e620));
                let _e626 = select(_e351.member_2[1][2], -(_e351.member_2[1][2]), (_e351.member_2[1][2] < 0f));
                let _e628 = select(_e626, _e622, (_e622 > _e626));
                let _e632 = (select(_e628, _e610, (_e610 > _e628)) + _e351.member_3);
                let _e634 = select(_e592, _e552, (_e552 > _e592));
                let _e636 = select(_e632, _e634, (_e634 > _e632));
                if (_e636 <= 65536f) {
                    phi_1094_ = (_e636 >= (1f / 65536f));
                } else {
                    phi_1094_ = false;
                }
                let _e641 = phi_1094_;
                if _e641 {
                    phi_1192_ = type_33();
                    phi_1193_ = true;
                } else {
                    if (_e512 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e512) & 2139095040u) != 2139095040u) {
                            let _e648 = (2130706432u - (bitcast<u32>(_e512) & 2139095040u));
                            let _e651 = bitcast<f32>(select(8388608u, _e648, (_e648 > 8388608u)));
                            let _e652 = (_e377 * _e651);
                            phi_1188_ = type_33(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e351.member[0][0] * _e651), (_e351.member[0][1] * _e651), (_e351.member[0][2] * _e651)), array<f32, 3>((_e351.member[1][0] * _e651), (_e351.member[1][1] * _e651), (_e351.member[1][2] * _e651))), array<array<f32, 3>, 2>(array<f32, 3>((_e351.member_1[0][0] * _e651), (_e351.member_1[0][1] * _e651), (_e351.member_1[0][2] * _e651)), array<f32, 3>((_e351.member_1[1][0] * _e651), (_e351.member_1[1][1] * _e651), (_e351.member_1[1][2] * _e651))), array<array<f32, 3>, 2>(array<f32, 3>((_e351.member_2[0][0] * _e651), (_e351.member_2[0][1] * _e651), (_e351.member_2[0][2] * _e651)), array<f32, 3>((_e351.member_2[1][0] * _e651), (_e351.member_2[1][1] * _e651), (_e351.member_2[1][2] * _e651))), ((_e351.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e651)), select(_e652, select(0.000000000000000000000000000000000000011754944f, _e652, (_e652 > 0.000000000000000000000000000000000000011754944f)), (_e377 > 0f)));
                            phi_1189_ = false;
                        } else {
                            phi_1188_ = type_33();
                            phi_1189_ = true;
                        }
                        let _e721 = phi_1188_;
                        let _e723 = phi_1189_;
                        phi_1190_ = _e721;
                        phi_1191_ = _e723;
                    } else {
                        phi_1190_ = type_33();
                        phi_1191_ = true;
                    }
                    let _e725 = phi_1190_;
                    let _e727 = phi_1191_;
                    phi_1192_ = _e725;
                    phi_1193_ = _e727;
                }
                let _e729 = phi_1192_;
                let _e731 = phi_1193_;
                if _e731 {
                    phi_1198_ = type_33(_e351, _e377);
                } else {
                    phi_1198_ = _e729;
                }
                let _e734 = phi_1198_;
                local_5 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e734.member.member[0][0], _e734.member.member[0][1], _e734.member.member[0][2]), array<f32, 3>(_e734.member.member[1][0], _e734.member.member[1][1], _e734.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e734.member.member_1[0][0], _e734.member.member_1[0][1], _e734.member.member_1[0][2]), array<f32, 3>(_e734.member.member_1[1][0], _e734.member.member_1[1][1], _e734.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e734.member.member_2[0][0], _e734.member.member_2[0][1], _e734.member.member_2[0][2]), array<f32, 3>(_e734.member.member_2[1][0], _e734.member.member_2[1][1], _e734.member.member_2[1][2])), _e734.member.member_3);
                let _e777 = local_5.member[0u];
                let _e783 = local_5.member[1u];
                let _e799 = local_5.member_1[0u];
                let _e805 = local_5.member_1[1u];
                let _e821 = local_5.member_2[0u];
                let _e827 = local_5.member_2[1u];
                let _e841 = function_3(array<f32, 3>((_e777[0] + ((_e783[0] - _e777[0]) * _e381)), (_e777[1] + ((_e783[1] - _e777[1]) * _e381)), (_e777[2] + ((_e783[2] - _e777[2]) * _e381))), array<f32, 3>((_e799[0] + ((_e805[0] - _e799[0]) * _e381)), (_e799[1] + ((_e805[1] - _e799[1]) * _e381)), (_e799[2] + ((_e805[2] - _e799[2]) * _e381))), array<f32, 3>((_e821[0] + ((_e827[0] - _e821[0]) * _e381)), (_e821[1] + ((_e827[1] - _e821[1]) * _e381)), (_e821[2] + ((_e827[2] - _e821[2]) * _e381))), _e226.member);
                let _e852 = (((_e841[0] * _e841[0]) + (_e841[1] * _e841[1])) + (_e841[2] * _e841[2]));
                if (_e852 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1425_ = select(0f, (0.000000000000000000106433627f * 2f), (_e852 > 0f));
                } else {
                    phi_1368_ = type_14(0i, 5i);
                    phi_1371_ = bitcast<f32>(((bitcast<u32>(_e852) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e860 = phi_1368_;
                        let _e862 = phi_1371_;
                        local_7 = _e862;
                        if (_e860.member < _e860.member_1) {
                            let _e869 = (_e860.member + 1i);
                            phi_1369_ = type_14(select(_e869, type_15().member_1, select(false, true, ((false == (_e869 > _e860.member)) != false))), _e860.member_1);
                            phi_1412_ = type_15(1u, _e860.member);
                        } else {
                            phi_1369_ = _e860;
                            phi_1412_ = type_15(0u, type_15().member_1);
                        }
                        let _e880 = phi_1369_;
                        let _e882 = phi_1412_;
                        let _e885 = (bitcast<i32>(_e882.member) != 0i);
                        if _e885 {
                            phi_1372_ = (0.5f * (_e862 + (_e852 / _e862)));
                        } else {
                            phi_1372_ = f32();
                        }
                        let _e890 = phi_1372_;
                        continue;
                        continuing {
                            phi_1368_ = _e880;
                            phi_1371_ = _e890;
                            break if !(_e885);
                        }
                    }
                    let _e895 = local_7;
                    phi_1425_ = (_e895 * (1f + (8f * 0.000000059604645f)));
                }
                let _e901 = phi_1425_;
                let _e907 = local_5.member[0u];
                let _e913 = select(_e907[0], -(_e907[0]), (_e907[0] < 0f));
                let _e916 = select(_e907[1], -(_e907[1]), (_e907[1] < 0f));
                let _e918 = select(_e916, _e913, (_e913 > _e916));
                let _e921 = select(_e907[2], -(_e907[2]), (_e907[2] < 0f));
                let _e923 = select(_e921, _e918, (_e918 > _e921));
                let _e926 = local_5.member[1u];
                let _e932 = select(_e926[0], -(_e926[0]), (_e926[0] < 0f));
                let _e935 = select(_e926[1], -(_e926[1]), (_e926[1] < 0f));
                let _e937 = select(_e935, _e932, (_e932 > _e935));
                let _e940 = select(_e926[2], -(_e926[2]), (_e926[2] < 0f));
                let _e942 = select(_e940, _e937, (_e937 > _e940));
                let _e946 = local_5.member_3;
                let _e950 = local_5.member_1[0u];
                let _e956 = select(_e950[0], -(_e950[0]), (_e950[0] < 0f));
                let _e959 = select(_e950[1], -(_e950[1]), (_e950[1] < 0f));
                let _e961 = select(_e959, _e956, (_e956 > _e959));
                let _e964 = select(_e950[2], -(_e950[2]), (_e950[2] < 0f));
                let _e966 = select(_e964, _e961, (_e961 > _e964));
                let _e969 = local_5.member_1[1u];
                let _e975 = select(_e969[0], -(_e969[0]), (_e969[0] < 0f));
                let _e978 = select(_e969[1], -(_e969[1]), (_e969[1] < 0f));
                let _e980 = select(_e978, _e975, (_e975 > _e978));
                let _e983 = select(_e969[2], -(_e969[2]), (_e969[2] < 0f));
                let _e985 = select(_e983, _e980, (_e980 > _e983));
                let _e989 = local_5.member_3;
                let _e993 = local_5.member_2[0u];
                let _e999 = select(_e993[0], -(_e993[0]), (_e993[0] < 0f));
                let _e1002 = select(_e993[1], -(_e993[1]), (_e993[1] < 0f));
                let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                let _e1007 = select(_e993[2], -(_e993[2]), (_e993[2] < 0f));
                let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                let _e1012 = local_5.member_2[1u];
                let _e1018 = select(_e1012[0], -(_e1012[0]), (_e1012[0] < 0f));
                let _e1021 = select(_e1012[1], -(_e1012[1]), (_e1012[1] < 0f));
                let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                let _e1026 = select(_e1012[2], -(_e1012[2]), (_e1012[2] < 0f));
                let _e1028 = select(_e1026, _e1023, (_e1023 > _e1026));
                let _e1032 = local_5.member_3;
                let _e1039 = local_5.member_3;
                let _e1046 = (((_e901 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e942, _e923, (_e923 > _e942)) + _e946) + (select(_e985, _e966, (_e966 > _e985)) + _e989)) + (select(_e1028, _e1009, (_e1009 > _e1028)) + _e1032)) * (0.000000059604645f * 16f)) + (_e1039 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e734.member_1);
                if _e1046 {
                    phi_2336_ = type_35();
                    phi_2337_ = true;
                } else {
                    let _e1049 = local_5.member_1[0u];
                    let _e1055 = local_5.member_2[0u];
                    let _e1061 = ((_e1049[1] * _e1055[2]) - (_e1049[2] * _e1055[1]));
                    let _e1064 = ((_e1049[2] * _e1055[0]) - (_e1049[0] * _e1055[2]));
                    let _e1067 = ((_e1049[0] * _e1055[1]) - (_e1049[1] * _e1055[0]));
                    let _e1070 = local_5.member_1[1u];
                    let _e1076 = local_5.member_2[1u];
                    let _e1082 = ((_e1070[1] * _e1076[2]) - (_e1070[2] * _e1076[1]));
                    let _e1085 = ((_e1070[2] * _e1076[0]) - (_e1070[0] * _e1076[2]));
                    let _e1088 = ((_e1070[0] * _e1076[1]) - (_e1070[1] * _e1076[0]));
                    let _e1091 = local_5.member_1[0u];
                    let _e1097 = local_5.member_2[1u];
                    let _e1112 = local_5.member_1[1u];
                    let _e1118 = local_5.member_2[0u];
                    let _e1131 = (((_e1091[1] * _e1097[2]) - (_e1091[2] * _e1097[1])) + ((_e1112[1] * _e1118[2]) - (_e1112[2] * _e1118[1])));
                    let _e1132 = (((_e1091[2] * _e1097[0]) - (_e1091[0] * _e1097[2])) + ((_e1112[2] * _e1118[0]) - (_e1112[0] * _e1118[2])));
                    let _e1133 = (((_e1091[0] * _e1097[1]) - (_e1091[1] * _e1097[0])) + ((_e1112[0] * _e1118[1]) - (_e1112[1] * _e1118[0])));
                    let _e1136 = local_5.member[0u];
                    let _e1147 = local_5.member[1u];
                    let _e1158 = local_5.member[0u];
                    let _e1167 = ((((_e1147[0] * _e1061) + (_e1147[1] * _e1064)) + (_e1147[2] * _e1067)) + (((_e1158[0] * _e1131) + (_e1158[1] * _e1132)) + (_e1158[2] * _e1133)));
                    let _e1170 = local_5.member[0u];
                    let _e1181 = local_5.member[1u];
                    let _e1190 = ((((_e1170[0] * _e1082) + (_e1170[1] * _e1085)) + (_e1170[2] * _e1088)) + (((_e1181[0] * _e1131) + (_e1181[1] * _e1132)) + (_e1181[2] * _e1133)));
                    let _e1193 = local_5.member[1u];
                    let _e1204 = local_5.member[0u];
                    let _e1210 = select(_e1204[0], -(_e1204[0]), (_e1204[0] < 0f));
                    let _e1213 = select(_e1204[1], -(_e1204[1]), (_e1204[1] < 0f));
                    let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                    let _e1218 = select(_e1204[2], -(_e1204[2]), (_e1204[2] < 0f));
                    let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                    let _e1223 = local_5.member[1u];
                    let _e1229 = select(_e1223[0], -(_e1223[0]), (_e1223[0] < 0f));
                    let _e1232 = select(_e1223[1], -(_e1223[1]), (_e1223[1] < 0f));
                    let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                    let _e1237 = select(_e1223[2], -(_e1223[2]), (_e1223[2] < 0f));
                    let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                    let _e1243 = local_5.member_3;
                    let _e1244 = (select(_e1239, _e1220, (_e1220 > _e1239)) + _e1243);
                    let _e1247 = local_5.member_1[0u];
                    let _e1253 = select(_e1247[0], -(_e1247[0]), (_e1247[0] < 0f));
                    let _e1256 = select(_e1247[1], -(_e1247[1]), (_e1247[1] < 0f));
                    let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                    let _e1261 = select(_e1247[2], -(_e1247[2]), (_e1247[2] < 0f));
                    let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                    let _e1266 = local_5.member_1[1u];
                    let _e1272 = select(_e1266[0], -(_e1266[0]), (_e1266[0] < 0f));
                    let _e1275 = select(_e1266[1], -(_e1266[1]), (_e1266[1] < 0f));
                    let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                    let _e1280 = select(_e1266[2], -(_e1266[2]), (_e1266[2] < 0f));
                    let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                    let _e1286 = local_5.member_3;
                    let _e1287 = (select(_e1282, _e1263, (_e1263 > _e1282)) + _e1286);
                    let _e1290 = local_5.member_2[0u];
                    let _e1296 = select(_e1290[0], -(_e1290[0]), (_e1290[0] < 0f));
                    let _e1299 = select(_e1290[1], -(_e1290[1]), (_e1290[1] < 0f));
                    let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                    let _e1304 = select(_e1290[2], -(_e1290[2]), (_e1290[2] < 0f));
                    let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                    let _e1309 = local_5.member_2[1u];
                    let _e1315 = select(_e1309[0], -(_e1309[0]), (_e1309[0] < 0f));
                    let _e1318 = select(_e1309[1], -(_e1309[1]), (_e1309[1] < 0f));
                    let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                    let _e1323 = select(_e1309[2], -(_e1309[2]), (_e1309[2] < 0f));
                    let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                    let _e1329 = local_5.member_3;
                    let _e1330 = (select(_e1325, _e1306, (_e1306 > _e1325)) + _e1329);
                    let _e1332 = ((_e1287 * 8f) * _e1330);
                    let _e1339 = local_5.member_3;
                    let _e1363 = ((select(_e1061, -(_e1061), (_e1061 < 0f)) + select(_e1064, -(_e1064), (_e1064 < 0f))) + select(_e1067, -(_e1067), (_e1067 < 0f)));
                    let _e1374 = ((select(_e1082, -(_e1082), (_e1082 < 0f)) + select(_e1085, -(_e1085), (_e1085 < 0f))) + select(_e1088, -(_e1088), (_e1088 < 0f)));
                    let _e1376 = select(_e1374, _e1363, (_e1363 > _e1374));
                    let _e1388 = (((select(_e1131, -(_e1131), (_e1131 < 0f)) + select(_e1132, -(_e1132), (_e1132 < 0f))) + select(_e1133, -(_e1133), (_e1133 < 0f))) * 0.5f);
                    let _e1395 = local_5.member_3;
                    let _e1408 = ((((_e1136[0] * _e1061) + (_e1136[1] * _e1064)) + (_e1136[2] * _e1067)) * 3f);
                    let _e1409 = ((((_e1193[0] * _e1082) + (_e1193[1] * _e1085)) + (_e1193[2] * _e1088)) * 3f);
                    let _e1411 = select(_e1409, _e1408, (_e1408 < _e1409));
                    let _e1413 = select(_e1190, _e1167, (_e1167 < _e1190));
                    let _e1415 = select(_e1413, _e1411, (_e1411 < _e1413));
                    let _e1417 = select(_e1409, _e1408, (_e1408 > _e1409));
                    let _e1419 = select(_e1190, _e1167, (_e1167 > _e1190));
                    let _e1422 = -(select(_e1419, _e1417, (_e1417 > _e1419)));
                    if ((select(_e1422, _e1415, (_e1415 > _e1422)) - ((((((_e1244 * 8f) * _e1332) * (0.000000059604645f * (524f / 64f))) + ((_e1339 * 19f) * ((_e1244 * (_e1287 + _e1330)) + (_e1287 * _e1330)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1244) * ((1f + _e1287) * (1f + _e1330))))) + ((_e734.member_1 * (((select(_e1388, _e1376, (_e1376 > _e1388)) + (_e1332 * (0.000000059604645f * 8f))) + ((_e1395 * 6f) * (_e1287 + _e1330))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1287) * (1f + _e1330))))) * (3f * 1.0001f)))) > 0f) {
                        phi_2334_ = type_35(type_34(0u, f32()), 0u);
                        phi_2335_ = false;
                    } else {
                        phi_2334_ = type_35();
                        phi_2335_ = true;
                    }
                    let _e1434 = phi_2334_;
                    let _e1436 = phi_2335_;
                    phi_2336_ = _e1434;
                    phi_2337_ = _e1436;
                }
                let _e1438 = phi_2336_;
                let _e1440 = phi_2337_;
                if _e1440 {
                    phi_2343_ = type_14(0i, 2i);
                    phi_2346_ = _e381;
                    phi_2348_ = 0u;
                    phi_2350_ = _e381;
                    loop {
                        let _e1442 = phi_2343_;
                        let _e1444 = phi_2346_;
                        let _e1446 = phi_2348_;
                        let _e1448 = phi_2350_;
                        local_54 = _e1446;
                        local_57 = _e1444;
                        local_58 = _e1446;
                        if (_e1442.member < _e1442.member_1) {
                            let _e1455 = (_e1442.member + 1i);
                            phi_2344_ = type_14(select(_e1455, type_15().member_1, select(false, true, ((false == (_e1455 > _e1442.member)) != false))), _e1442.member_1);
                            phi_2391_ = type_15(1u, _e1442.member);
                        } else {
                            phi_2344_ = _e1442;
                            phi_2391_ = type_15(0u, type_15().member_1);
                        }
                        let _e1466 = phi_2344_;
                        let _e1468 = phi_2391_;
                        if (bitcast<i32>(_e1468.member) != 0i) {
                            if select(select(true, false, _e1046), true, (_e1468.member_1 > 0i)) {
                                let _e1478 = local_5.member[0u];
                                let _e1484 = local_5.member_1[0u];
                                let _e1490 = local_5.member_2[0u];
                                let _e1494 = (_e1478[0] - _e1484[0]);
                                let _e1495 = (_e1478[1] - _e1484[1]);
                                let _e1496 = (_e1478[2] - _e1484[2]);
                                let _e1497 = (_e226.member == 0u);
                                let _e1509 = local_5.member[1u];
                                let _e1515 = local_5.member_1[1u];
                                let _e1521 = local_5.member_2[1u];
                                let _e1525 = (_e1509[0] - _e1515[0]);
                                let _e1526 = (_e1509[1] - _e1515[1]);
                                let _e1527 = (_e1509[2] - _e1515[2]);
                                let _e1528 = (_e226.member == 0u);
                                let _e1540 = local_5.member[0u];
                                let _e1546 = select(_e1540[0], -(_e1540[0]), (_e1540[0] < 0f));
                                let _e1549 = select(_e1540[1], -(_e1540[1]), (_e1540[1] < 0f));
                                let _e1551 = select(_e1549, _e1546, (_e1546 > _e1549));
                                let _e1554 = select(_e1540[2], -(_e1540[2]), (_e1540[2] < 0f));
                                let _e1556 = select(_e1554, _e1551, (_e1551 > _e1554));
                                let _e1559 = local_5.member[1u];
                                let _e1565 = select(_e1559[0], -(_e1559[0]), (_e1559[0] < 0f));
                                let _e1568 = select(_e1559[1], -(_e1559[1]), (_e1559[1] < 0f));
                                let _e1570 = select(_e1568, _e1565, (_e1565 > _e1568));
                                let _e1573 = select(_e1559[2], -(_e1559[2]), (_e1559[2] < 0f));
                                let _e1575 = select(_e1573, _e1570, (_e1570 > _e1573));
                                let _e1579 = local_5.member_3;
                                let _e1583 = local_5.member_1[0u];
                                let _e1589 = select(_e1583[0], -(_e1583[0]), (_e1583[0] < 0f));
                                let _e1592 = select(_e1583[1], -(_e1583[1]), (_e1583[1] < 0f));
                                let _e1594 = select(_e1592, _e1589, (_e1589 > _e1592));
                                let _e1597 = select(_e1583[2], -(_e1583[2]), (_e1583[2] < 0f));
                                let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                let _e1602 = local_5.member_1[1u];
                                let _e1608 = select(_e1602[0], -(_e1602[0]), (_e1602[0] < 0f));
                                let _e1611 = select(_e1602[1], -(_e1602[1]), (_e1602[1] < 0f));
                                let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                let _e1616 = select(_e1602[2], -(_e1602[2]), (_e1602[2] < 0f));
                                let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                let _e1622 = local_5.member_3;
                                let _e1626 = local_5.member_2[0u];
                                let _e1632 = select(_e1626[0], -(_e1626[0]), (_e1626[0] < 0f));
                                let _e1635 = select(_e1626[1], -(_e1626[1]), (_e1626[1] < 0f));
                                let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                let _e1640 = select(_e1626[2], -(_e1626[2]), (_e1626[2] < 0f));
                                let _e1642 = select(_e1640, _e1637, (_e1637 > _e1640));
                                let _e1645 = local_5.member_2[1u];
                                let _e1651 = select(_e1645[0], -(_e1645[0]), (_e1645[0] < 0f));
                                let _e1654 = select(_e1645[1], -(_e1645[1]), (_e1645[1] < 0f));
                                let _e1656 = select(_e1654, _e1651, (_e1651 > _e1654));
                                let _e1659 = select(_e1645[2], -(_e1645[2]), (_e1645[2] < 0f));
                                let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                let _e1665 = local_5.member_3;
                                let _e1672 = local_5.member_3;
                                let _e1677 = (_e379 * 0.00390625f);
                                local_3 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_2828_ = type_9(0u, 96u);
                                phi_2831_ = _e1448;
                                phi_2833_ = _e1448;
                                phi_2835_ = (_e383 - _e1448);
                                phi_2837_ = _e1448;
                                phi_2839_ = false;
                                phi_2841_ = 0u;
                                loop {
                                    let _e1680 = phi_2828_;
                                    let _e1682 = phi_2831_;
                                    let _e1684 = phi_2833_;
                                    let _e1686 = phi_2835_;
                                    let _e1688 = phi_2837_;
                                    let _e1690 = phi_2839_;
                                    let _e1692 = phi_2841_;
                                    local_20 = _e1682;
                                    local_24 = _e1684;
                                    let _e1695 = (_e1680.member < _e1680.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1695)) != 0i) {
                                        let _e1709 = local_5.member[0u];
                                        let _e1715 = local_5.member[1u];
                                        let _e1731 = local_5.member_1[0u];
                                        let _e1737 = local_5.member_1[1u];
                                        let _e1753 = local_5.member_2[0u];
                                        let _e1759 = local_5.member_2[1u];
                                        let _e1773 = function_3(array<f32, 3>((_e1709[0] + ((_e1715[0] - _e1709[0]) * _e1682)), (_e1709[1] + ((_e1715[1] - _e1709[1]) * _e1682)), (_e1709[2] + ((_e1715[2] - _e1709[2]) * _e1682))), array<f32, 3>((_e1731[0] + ((_e1737[0] - _e1731[0]) * _e1682)), (_e1731[1] + ((_e1737[1] - _e1731[1]) * _e1682)), (_e1731[2] + ((_e1737[2] - _e1731[2]) * _e1682))), array<f32, 3>((_e1753[0] + ((_e1759[0] - _e1753[0]) * _e1682)), (_e1753[1] + ((_e1759[1] - _e1753[1]) * _e1682)), (_e1753[2] + ((_e1759[2] - _e1753[2]) * _e1682))), _e226.member);
                                        if (_e1692 == 0u) {
                                            phi_2992_ = _e1773;
                                        } else {
                                            phi_2992_ = array<f32, 3>(select(0f, _e1773[0], (_e1692 == 1u)), select(0f, _e1773[1], (_e1692 == 2u)), select(0f, _e1773[2], (_e1692 == 3u)));
                                        }
                                        let _e1786 = phi_2992_;
                                        let _e1800 = ((select(_e1786[0], -(_e1786[0]), (_e1786[0] < 0f)) + select(_e1786[1], -(_e1786[1]), (_e1786[1] < 0f))) + select(_e1786[2], -(_e1786[2]), (_e1786[2] < 0f)));
                                        if (_e1800 > 0f) {
                                            if ((bitcast<u32>(_e1800) & 2139095040u) != 2139095040u) {
                                                let _e1805 = (1f / _e1800);
                                                let _e1807 = (_e1786[0] * _e1805);
                                                let _e1809 = (_e1786[1] * _e1805);
                                                let _e1811 = (_e1786[2] * _e1805);
                                                let _e1816 = (((_e1807 * _e1807) + (_e1809 * _e1809)) + (_e1811 * _e1811));
                                                if (_e1816 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_3115_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1816 > 0f));
                                                } else {
                                                    phi_3058_ = type_14(0i, 5i);
                                                    phi_3061_ = bitcast<f32>(((bitcast<u32>(_e1816) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1824 = phi_3058_;
                                                        let _e1826 = phi_3061_;
                                                        local_8 = _e1826;
                                                        if (_e1824.member < _e1824.member_1) {
                                                            let _e1833 = (_e1824.member + 1i);
                                                            phi_3059_ = type_14(select(_e1833, type_15().member_1, select(false, true, ((false == (_e1833 > _e1824.member)) != false))), _e1824.member_1);
                                                            phi_3102_ = type_15(1u, _e1824.member);
                                                        } else {
                                                            phi_3059_ = _e1824;
                                                            phi_3102_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e1844 = phi_3059_;
                                                        let _e1846 = phi_3102_;
                                                        let _e1849 = (bitcast<i32>(_e1846.member) != 0i);
                                                        if _e1849 {
                                                            phi_3062_ = (0.5f * (_e1826 + (_e1816 / _e1826)));
                                                        } else {
                                                            phi_3062_ = f32();
                                                        }
                                                        let _e1854 = phi_3062_;
                                                        continue;
                                                        continuing {
                                                            phi_3058_ = _e1844;
                                                            phi_3061_ = _e1854;
                                                            break if !(_e1849);
                                                        }
                                                    }
                                                    let _e1859 = local_8;
                                                    phi_3115_ = (_e1859 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1865 = phi_3115_;
                                                let _e1866 = (0.000000059604645f * 12f);
                                                let _e1871 = ((((((((select(_e1575, _e1556, (_e1556 > _e1575)) + _e1579) + (select(_e1618, _e1599, (_e1599 > _e1618)) + _e1622)) + (select(_e1661, _e1642, (_e1642 > _e1661)) + _e1665)) * (0.000000059604645f * 16f)) + (_e1672 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e734.member_1 * _e1865) * (1f + _e1866)));
                                                let _e1876 = (((_e1807 * _e1478[0]) + (_e1809 * _e1478[1])) + (_e1811 * _e1478[2]));
                                                let _e1881 = (((_e1807 * _e1494) + (_e1809 * _e1495)) + (_e1811 * _e1496));
                                                let _e1886 = (((_e1807 * (_e1478[0] - _e1490[0])) + (_e1809 * (_e1478[1] - _e1490[1]))) + (_e1811 * (_e1478[2] - _e1490[2])));
                                                let _e1891 = (((_e1807 * select((_e1494 - _e1490[0]), _e1478[0], _e1497)) + (_e1809 * select((_e1495 - _e1490[1]), _e1478[1], _e1497))) + (_e1811 * select((_e1496 - _e1490[2]), _e1478[2], _e1497)));
                                                let _e1897 = (((_e1807 * _e1509[0]) + (_e1809 * _e1509[1])) + (_e1811 * _e1509[2]));
                                                let _e1902 = (((_e1807 * _e1525) + (_e1809 * _e1526)) + (_e1811 * _e1527));
                                                let _e1907 = (((_e1807 * (_e1509[0] - _e1521[0])) + (_e1809 * (_e1509[1] - _e1521[1]))) + (_e1811 * (_e1509[2] - _e1521[2])));
                                                let _e1912 = (((_e1807 * select((_e1525 - _e1521[0]), _e1509[0], _e1528)) + (_e1809 * select((_e1526 - _e1521[1]), _e1509[1], _e1528))) + (_e1811 * select((_e1527 - _e1521[2]), _e1509[2], _e1528)));
                                                phi_3238_ = type_31(array<f32, 4>(_e1876, _e1881, _e1886, _e1891), array<f32, 4>(_e1897, _e1902, _e1907, _e1912), array<f32, 4>((_e1871 + ((select(_e1876, -(_e1876), (_e1876 < 0f)) + select(_e1897, -(_e1897), (_e1897 < 0f))) * _e1866)), (_e1871 + ((select(_e1881, -(_e1881), (_e1881 < 0f)) + select(_e1902, -(_e1902), (_e1902 < 0f))) * _e1866)), (_e1871 + ((select(_e1886, -(_e1886), (_e1886 < 0f)) + select(_e1907, -(_e1907), (_e1907 < 0f))) * _e1866)), (_e1871 + ((select(_e1891, -(_e1891), (_e1891 < 0f)) + select(_e1912, -(_e1912), (_e1912 < 0f))) * _e1866))));
                                                phi_3239_ = false;
                                            } else {
                                                phi_3238_ = type_31();
                                                phi_3239_ = true;
                                            }
                                            let _e1953 = phi_3238_;
                                            let _e1955 = phi_3239_;
                                            phi_3240_ = _e1953;
                                            phi_3241_ = _e1955;
                                        } else {
                                            phi_3240_ = type_31();
                                            phi_3241_ = true;
                                        }
                                        let _e1957 = phi_3240_;
                                        let _e1959 = phi_3241_;
                                        if _e1959 {
                                            phi_3249_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_3249_ = _e1957;
                                        }
                                        let _e1961 = phi_3249_;
                                        local_4 = type_31(array<f32, 4>(_e1961.member[0], _e1961.member[1], _e1961.member[2], _e1961.member[3]), array<f32, 4>(_e1961.member_1[0], _e1961.member_1[1], _e1961.member_1[2], _e1961.member_1[3]), array<f32, 4>(_e1961.member_2[0], _e1961.member_2[1], _e1961.member_2[2], _e1961.member_2[3]));
                                        let _e1981 = (_e1682 - _e1688);
                                        let _e1985 = local_4.member[0u];
                                        let _e1988 = local_4.member_1[0u];
                                        let _e1991 = local_4.member[0u];
                                        let _e1997 = local_4.member_2[0u];
                                        if (((_e1985 + ((_e1988 - _e1991) * _e1682)) - _e1997) > 0f) {
                                            let _e2002 = local_4.member[1u];
                                            let _e2005 = local_4.member_1[1u];
                                            let _e2008 = local_4.member[1u];
                                            let _e2014 = local_4.member_2[1u];
                                            if (((_e2002 + ((_e2005 - _e2008) * _e1682)) - _e2014) > 0f) {
                                                let _e2019 = local_4.member[2u];
                                                let _e2022 = local_4.member_1[2u];
                                                let _e2025 = local_4.member[2u];
                                                let _e2031 = local_4.member_2[2u];
                                                if (((_e2019 + ((_e2022 - _e2025) * _e1682)) - _e2031) > 0f) {
                                                    let _e2036 = local_4.member[3u];
                                                    let _e2039 = local_4.member_1[3u];
                                                    let _e2042 = local_4.member[3u];
                                                    let _e2048 = local_4.member_2[3u];
                                                    phi_3420_ = (((_e2036 + ((_e2039 - _e2042) * _e1682)) - _e2048) > 0f);
                                                    phi_3421_ = false;
                                                } else {
                                                    phi_3420_ = bool();
                                                    phi_3421_ = true;
                                                }
                                                let _e2052 = phi_3420_;
                                                let _e2054 = phi_3421_;
                                                phi_3422_ = _e2052;
                                                phi_3423_ = _e2054;
                                            } else {
                                                phi_3422_ = bool();
                                                phi_3423_ = true;
                                            }
                                            let _e2056 = phi_3422_;
                                            let _e2058 = phi_3423_;
                                            phi_3424_ = _e2056;
                                            phi_3425_ = _e2058;
                                        } else {
                                            phi_3424_ = bool();
                                            phi_3425_ = true;
                                        }
                                        let _e2060 = phi_3424_;
                                        let _e2062 = phi_3425_;
                                        if select(_e2060, false, _e2062) {
                                            if (_e1682 <= _e1684) {
                                                phi_3739_ = true;
                                            } else {
                                                let _e2067 = local_3.member[0u];
                                                let _e2070 = local_3.member_1[0u];
                                                let _e2073 = local_3.member[0u];
                                                let _e2079 = local_3.member_2[0u];
                                                let _e2083 = local_4.member[0u];
                                                let _e2086 = local_4.member_1[0u];
                                                let _e2089 = local_4.member[0u];
                                                let _e2095 = local_4.member_2[0u];
                                                if ((((_e2067 + ((_e2070 - _e2073) * _e1682)) - _e2079) + ((_e2083 + ((_e2086 - _e2089) * _e1688)) - _e2095)) > 0f) {
                                                    let _e2101 = local_3.member[1u];
                                                    let _e2104 = local_3.member_1[1u];
                                                    let _e2107 = local_3.member[1u];
                                                    let _e2113 = local_3.member_2[1u];
                                                    let _e2117 = local_4.member[1u];
                                                    let _e2120 = local_4.member_1[1u];
                                                    let _e2123 = local_4.member[1u];
                                                    let _e2129 = local_4.member_2[1u];
                                                    if ((((_e2101 + ((_e2104 - _e2107) * _e1682)) - _e2113) + ((_e2117 + ((_e2120 - _e2123) * _e1688)) - _e2129)) > 0f) {
                                                        let _e2135 = local_3.member[2u];
                                                        let _e2138 = local_3.member_1[2u];
                                                        let _e2141 = local_3.member[2u];
                                                        let _e2147 = local_3.member_2[2u];
                                                        let _e2151 = local_4.member[2u];
                                                        let _e2154 = local_4.member_1[2u];
                                                        let _e2157 = local_4.member[2u];
                                                        let _e2163 = local_4.member_2[2u];
                                                        if ((((_e2135 + ((_e2138 - _e2141) * _e1682)) - _e2147) + ((_e2151 + ((_e2154 - _e2157) * _e1688)) - _e2163)) > 0f) {
                                                            let _e2169 = local_3.member[3u];
                                                            let _e2172 = local_3.member_1[3u];
                                                            let _e2175 = local_3.member[3u];
                                                            let _e2181 = local_3.member_2[3u];
                                                            let _e2185 = local_4.member[3u];
                                                            let _e2188 = local_4.member_1[3u];
                                                            let _e2191 = local_4.member[3u];
                                                            let _e2197 = local_4.member_2[3u];
                                                            phi_3726_ = ((((_e2169 + ((_e2172 - _e2175) * _e1682)) - _e2181) + ((_e2185 + ((_e2188 - _e2191) * _e1688)) - _e2197)) > 0f);
                                                            phi_3727_ = false;
                                                        } else {
                                                            phi_3726_ = bool();
                                                            phi_3727_ = true;
                                                        }
                                                        let _e2202 = phi_3726_;
                                                        let _e2204 = phi_3727_;
                                                        phi_3728_ = _e2202;
                                                        phi_3729_ = _e2204;
                                                    } else {
                                                        phi_3728_ = bool();
                                                        phi_3729_ = true;
                                                    }
                                                    let _e2206 = phi_3728_;
                                                    let _e2208 = phi_3729_;
                                                    phi_3730_ = _e2206;
                                                    phi_3731_ = _e2208;
                                                } else {
                                                    phi_3730_ = bool();
                                                    phi_3731_ = true;
                                                }
                                                let _e2210 = phi_3730_;
                                                let _e2212 = phi_3731_;
                                                phi_3739_ = select(_e2210, false, _e2212);
                                            }
                                            let _e2215 = phi_3739_;
                                            if _e2215 {
                                                if select(true, select(true, false, (_e1682 >= _e383)), _e1690) {
                                                    local_3 = type_31(array<f32, 4>(_e1961.member[0], _e1961.member[1], _e1961.member[2], _e1961.member[3]), array<f32, 4>(_e1961.member_1[0], _e1961.member_1[1], _e1961.member_1[2], _e1961.member_1[3]), array<f32, 4>(_e1961.member_2[0], _e1961.member_2[1], _e1961.member_2[2], _e1961.member_2[3]));
                                                    let _e2240 = local_3.member[0u];
                                                    let _e2243 = local_3.member_1[0u];
                                                    let _e2246 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2243 > _e2246)), (_e2240 > _e2246)) {
                                                        let _e2251 = (_e2243 >= _e2240);
                                                        if _e2251 {
                                                            phi_3848_ = f32();
                                                            phi_3849_ = false;
                                                        } else {
                                                            if ((_e2240 - _e2243) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3846_ = (((_e2240 - _e2246) / (_e2240 - _e2243)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3847_ = false;
                                                            } else {
                                                                phi_3846_ = f32();
                                                                phi_3847_ = true;
                                                            }
                                                            let _e2262 = phi_3846_;
                                                            let _e2264 = phi_3847_;
                                                            phi_3848_ = _e2262;
                                                            phi_3849_ = _e2264;
                                                        }
                                                        let _e2266 = phi_3848_;
                                                        let _e2268 = phi_3849_;
                                                        phi_3850_ = _e2266;
                                                        phi_3851_ = _e2251;
                                                        phi_3852_ = _e2268;
                                                    } else {
                                                        phi_3850_ = f32();
                                                        phi_3851_ = true;
                                                        phi_3852_ = false;
                                                    }
                                                    let _e2270 = phi_3850_;
                                                    let _e2272 = phi_3851_;
                                                    let _e2274 = phi_3852_;
                                                    let _e2277 = select(_e2270, select(_e1682, 2f, _e2272), select(_e2274, true, _e2272));
                                                    let _e2280 = local_3.member[1u];
                                                    let _e2283 = local_3.member_1[1u];
                                                    let _e2286 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2283 > _e2286)), (_e2280 > _e2286)) {
                                                        let _e2291 = (_e2283 >= _e2280);
                                                        if _e2291 {
                                                            phi_3916_ = f32();
                                                            phi_3917_ = false;
                                                        } else {
                                                            if ((_e2280 - _e2283) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3914_ = (((_e2280 - _e2286) / (_e2280 - _e2283)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3915_ = false;
                                                            } else {
                                                                phi_3914_ = f32();
                                                                phi_3915_ = true;
                                                            }
                                                            let _e2302 = phi_3914_;
                                                            let _e2304 = phi_3915_;
                                                            phi_3916_ = _e2302;
                                                            phi_3917_ = _e2304;
                                                        }
                                                        let _e2306 = phi_3916_;
                                                        let _e2308 = phi_3917_;
                                                        phi_3918_ = _e2306;
                                                        phi_3919_ = _e2291;
                                                        phi_3920_ = _e2308;
                                                    } else {
                                                        phi_3918_ = f32();
                                                        phi_3919_ = true;
                                                        phi_3920_ = false;
                                                    }
                                                    let _e2310 = phi_3918_;
                                                    let _e2312 = phi_3919_;
                                                    let _e2314 = phi_3920_;
                                                    let _e2317 = select(_e2310, select(_e1682, 2f, _e2312), select(_e2314, true, _e2312));
                                                    let _e2319 = select(_e2317, _e2277, (_e2277 < _e2317));
                                                    let _e2322 = local_3.member[2u];
                                                    let _e2325 = local_3.member_1[2u];
                                                    let _e2328 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2325 > _e2328)), (_e2322 > _e2328)) {
                                                        let _e2333 = (_e2325 >= _e2322);
                                                        if _e2333 {
                                                            phi_3989_ = f32();
                                                            phi_3990_ = false;
                                                        } else {
                                                            if ((_e2322 - _e2325) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_3987_ = (((_e2322 - _e2328) / (_e2322 - _e2325)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_3988_ = false;
                                                            } else {
                                                                phi_3987_ = f32();
                                                                phi_3988_ = true;
                                                            }
                                                            let _e2344 = phi_3987_;
                                                            let _e2346 = phi_3988_;
                                                            phi_3989_ = _e2344;
                                                            phi_3990_ = _e2346;
                                                        }
                                                        let _e2348 = phi_3989_;
                                                        let _e2350 = phi_3990_;
                                                        phi_3991_ = _e2348;
                                                        phi_3992_ = _e2333;
                                                        phi_3993_ = _e2350;
                                                    } else {
                                                        phi_3991_ = f32();
                                                        phi_3992_ = true;
                                                        phi_3993_ = false;
                                                    }
                                                    let _e2352 = phi_3991_;
                                                    let _e2354 = phi_3992_;
                                                    let _e2356 = phi_3993_;
                                                    let _e2359 = select(_e2352, select(_e1682, 2f, _e2354), select(_e2356, true, _e2354));
                                                    let _e2362 = local_3.member[3u];
                                                    let _e2365 = local_3.member_1[3u];
                                                    let _e2368 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2365 > _e2368)), (_e2362 > _e2368)) {
                                                        let _e2373 = (_e2365 >= _e2362);
                                                        if _e2373 {
                                                            phi_4057_ = f32();
                                                            phi_4058_ = false;
                                                        } else {
                                                            if ((_e2362 - _e2365) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_4055_ = (((_e2362 - _e2368) / (_e2362 - _e2365)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_4056_ = false;
                                                            } else {
                                                                phi_4055_ = f32();
                                                                phi_4056_ = true;
                                                            }
                                                            let _e2384 = phi_4055_;
                                                            let _e2386 = phi_4056_;
                                                            phi_4057_ = _e2384;
                                                            phi_4058_ = _e2386;
                                                        }
                                                        let _e2388 = phi_4057_;
                                                        let _e2390 = phi_4058_;
                                                        phi_4059_ = _e2388;
                                                        phi_4060_ = _e2373;
                                                        phi_4061_ = _e2390;
                                                    } else {
                                                        phi_4059_ = f32();
                                                        phi_4060_ = true;
                                                        phi_4061_ = false;
                                                    }
                                                    let _e2392 = phi_4059_;
                                                    let _e2394 = phi_4060_;
                                                    let _e2396 = phi_4061_;
                                                    let _e2399 = select(_e2392, select(_e1682, 2f, _e2394), select(_e2396, true, _e2394));
                                                    let _e2401 = select(_e2399, _e2359, (_e2359 < _e2399));
                                                    let _e2403 = select(_e2401, _e2319, (_e2319 < _e2401));
                                                    let _e2405 = select(_e1682, _e2403, (_e2403 > _e1682));
                                                    let _e2406 = (_e2405 > _e383);
                                                    if _e2406 {
                                                        phi_4590_ = f32();
                                                        phi_4591_ = f32();
                                                        phi_4592_ = false;
                                                        phi_4593_ = false;
                                                    } else {
                                                        let _e2407 = (_e2405 - _e1682);
                                                        let _e2408 = (_e2407 <= _e1677);
                                                        let _e2410 = (_e2405 + (_e379 * 0.01f));
                                                        let _e2412 = select(_e383, _e2410, (_e2410 < _e383));
                                                        if _e2408 {
                                                            if (_e734.member_1 > 0f) {
                                                                let _e2416 = local_5.member[0u];
                                                                let _e2422 = local_5.member[1u];
                                                                let _e2438 = local_5.member_1[0u];
                                                                let _e2444 = local_5.member_1[1u];
                                                                let _e2460 = local_5.member_2[0u];
                                                                let _e2466 = local_5.member_2[1u];
                                                                let _e2480 = function_3(array<f32, 3>((_e2416[0] + ((_e2422[0] - _e2416[0]) * _e2412)), (_e2416[1] + ((_e2422[1] - _e2416[1]) * _e2412)), (_e2416[2] + ((_e2422[2] - _e2416[2]) * _e2412))), array<f32, 3>((_e2438[0] + ((_e2444[0] - _e2438[0]) * _e2412)), (_e2438[1] + ((_e2444[1] - _e2438[1]) * _e2412)), (_e2438[2] + ((_e2444[2] - _e2438[2]) * _e2412))), array<f32, 3>((_e2460[0] + ((_e2466[0] - _e2460[0]) * _e2412)), (_e2460[1] + ((_e2466[1] - _e2460[1]) * _e2412)), (_e2460[2] + ((_e2466[2] - _e2460[2]) * _e2412))), _e226.member);
                                                                let _e2491 = (((_e2480[0] * _e2480[0]) + (_e2480[1] * _e2480[1])) + (_e2480[2] * _e2480[2]));
                                                                if (_e2491 <= 0.000000000000000000000000000000000000011754944f) {
                                                                    phi_4292_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2491 > 0f));
                                                                } else {
                                                                    phi_4235_ = type_14(0i, 5i);
                                                                    phi_4238_ = bitcast<f32>(((bitcast<u32>(_e2491) >> bitcast<u32>(1i)) + 532369198u));
                                                                    loop {
                                                                        let _e2499 = phi_4235_;
                                                                        let _e2501 = phi_4238_;
                                                                        local_9 = _e2501;
                                                                        if (_e2499.member < _e2499.member_1) {
                                                                            let _e2508 = (_e2499.member + 1i);
                                                                            phi_4236_ = type_14(select(_e2508, type_15().member_1, select(false, true, ((false == (_e2508 > _e2499.member)) != false))), _e2499.member_1);
                                                                            phi_4279_ = type_15(1u, _e2499.member);
                                                                        } else {
                                                                            phi_4236_ = _e2499;
                                                                            phi_4279_ = type_15(0u, type_15().member_1);
                                                                        }
                                                                        let _e2519 = phi_4236_;
                                                                        let _e2521 = phi_4279_;
                                                                        let _e2524 = (bitcast<i32>(_e2521.member) != 0i);
                                                                        if _e2524 {
                                                                            phi_4239_ = (0.5f * (_e2501 + (_e2491 / _e2501)));
                                                                        } else {
                                                                            phi_4239_ = f32();
                                                                        }
                                                                        let _e2529 = phi_4239_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4235_ = _e2519;
                                                                            phi_4238_ = _e2529;
                                                                            break if !(_e2524);
                                                                        }
                                                                    }
                                                                    let _e2534 = local_9;
                                                                    phi_4292_ = (_e2534 * (1f + (8f * 0.000000059604645f)));
                                                                }
                                                                let _e2540 = phi_4292_;
                                                                let _e2546 = local_5.member[0u];
                                                                let _e2552 = select(_e2546[0], -(_e2546[0]), (_e2546[0] < 0f));
                                                                let _e2555 = select(_e2546[1], -(_e2546[1]), (_e2546[1] < 0f));
                                                                let _e2557 = select(_e2555, _e2552, (_e2552 > _e2555));
                                                                let _e2560 = select(_e2546[2], -(_e2546[2]), (_e2546[2] < 0f));
                                                                let _e2562 = select(_e2560, _e2557, (_e2557 > _e2560));
                                                                let _e2565 = local_5.member[1u];
                                                                let _e2571 = select(_e2565[0], -(_e2565[0]), (_e2565[0] < 0f));
                                                                let _e2574 = select(_e2565[1], -(_e2565[1]), (_e2565[1] < 0f));
                                                                let _e2576 = select(_e2574, _e2571, (_e2571 > _e2574));
                                                                let _e2579 = select(_e2565[2], -(_e2565[2]), (_e2565[2] < 0f));
                                                                let _e2581 = select(_e2579, _e2576, (_e2576 > _e2579));
                                                                let _e2585 = local_5.member_3;
                                                                let _e2589 = local_5.member_1[0u];
                                                                let _e2595 = select(_e2589[0], -(_e2589[0]), (_e2589[0] < 0f));
                                                                let _e2598 = select(_e2589[1], -(_e2589[1]), (_e2589[1] < 0f));
                                                                let _e2600 = select(_e2598, _e2595, (_e2595 > _e2598));
                                                                let _e2603 = select(_e2589[2], -(_e2589[2]), (_e2589[2] < 0f));
                                                                let _e2605 = select(_e2603, _e2600, (_e2600 > _e2603));
                                                                let _e2608 = local_5.member_1[1u];
                                                                let _e2614 = select(_e2608[0], -(_e2608[0]), (_e2608[0] < 0f));
                                                                let _e2617 = select(_e2608[1], -(_e2608[1]), (_e2608[1] < 0f));
                                                                let _e2619 = select(_e2617, _e2614, (_e2614 > _e2617));
                                                                let _e2622 = select(_e2608[2], -(_e2608[2]), (_e2608[2] < 0f));
                                                                let _e2624 = select(_e2622, _e2619, (_e2619 > _e2622));
                                                                let _e2628 = local_5.member_3;
                                                                let _e2632 = local_5.member_2[0u];
                                                                let _e2638 = select(_e2632[0], -(_e2632[0]), (_e2632[0] < 0f));
                                                                let _e2641 = select(_e2632[1], -(_e2632[1]), (_e2632[1] < 0f));
                                                                let _e2643 = select(_e2641, _e2638, (_e2638 > _e2641));
                                                                let _e2646 = select(_e2632[2], -(_e2632[2]), (_e2632[2] < 0f));
                                                                let _e2648 = select(_e2646, _e2643, (_e2643 > _e2646));
                                                                let _e2651 = local_5.member_2[1u];
                                                                let _e2657 = select(_e2651[0], -(_e2651[0]), (_e2651[0] < 0f));
                                                                let _e2660 = select(_e2651[1], -(_e2651[1]), (_e2651[1] < 0f));
                                                                let _e2662 = select(_e2660, _e2657, (_e2657 > _e2660));
                                                                let _e2665 = select(_e2651[2], -(_e2651[2]), (_e2651[2] < 0f));
                                                                let _e2667 = select(_e2665, _e2662, (_e2662 > _e2665));
                                                                let _e2671 = local_5.member_3;
                                                                let _e2678 = local_5.member_3;
                                                                phi_4563_ = select(true, false, (((_e2540 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e2581, _e2562, (_e2562 > _e2581)) + _e2585) + (select(_e2624, _e2605, (_e2605 > _e2624)) + _e2628)) + (select(_e2667, _e2648, (_e2648 > _e2667)) + _e2671)) * (0.000000059604645f * 16f)) + (_e2678 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e734.member_1));
                                                            } else {
                                                                phi_4563_ = true;
                                                            }
                                                            let _e2688 = phi_4563_;
                                                            phi_4564_ = _e2688;
                                                        } else {
                                                            phi_4564_ = true;
                                                        }
                                                        let _e2690 = phi_4564_;
                                                        phi_4590_ = select(f32(), select((_e383 - _e1682), select(0f, (_e1981 + _e1981), select(select(true, false, (_e2407 <= (_e1686 * 0.25f))), true, _e2408)), _e1690), _e2690);
                                                        phi_4591_ = _e2407;
                                                        phi_4592_ = _e2690;
                                                        phi_4593_ = select(true, false, _e2690);
                                                    }
                                                    let _e2702 = phi_4590_;
                                                    let _e2704 = phi_4591_;
                                                    let _e2706 = phi_4592_;
                                                    let _e2708 = phi_4593_;
                                                    phi_4594_ = _e2405;
                                                    phi_4595_ = _e2702;
                                                    phi_4596_ = _e2704;
                                                    phi_4597_ = _e2405;
                                                    phi_4598_ = _e2706;
                                                    phi_4599_ = _e2406;
                                                    phi_4600_ = _e2708;
                                                    phi_4601_ = false;
                                                } else {
                                                    phi_4594_ = f32();
                                                    phi_4595_ = f32();
                                                    phi_4596_ = f32();
                                                    phi_4597_ = f32();
                                                    phi_4598_ = false;
                                                    phi_4599_ = false;
                                                    phi_4600_ = false;
                                                    phi_4601_ = true;
                                                }
                                                let _e2710 = phi_4594_;
                                                let _e2712 = phi_4595_;
                                                let _e2714 = phi_4596_;
                                                let _e2716 = phi_4597_;
                                                let _e2718 = phi_4598_;
                                                let _e2720 = phi_4599_;
                                                let _e2722 = phi_4600_;
                                                let _e2724 = phi_4601_;
                                                phi_4602_ = _e2710;
                                                phi_4603_ = _e2712;
                                                phi_4604_ = _e2714;
                                                phi_4605_ = _e2716;
                                                phi_4606_ = false;
                                                phi_4607_ = _e2718;
                                                phi_4608_ = _e2720;
                                                phi_4609_ = _e2722;
                                                phi_4610_ = _e2724;
                                            } else {
                                                phi_4602_ = f32();
                                                phi_4603_ = f32();
                                                phi_4604_ = f32();
                                                phi_4605_ = f32();
                                                phi_4606_ = true;
                                                phi_4607_ = false;
                                                phi_4608_ = false;
                                                phi_4609_ = false;
                                                phi_4610_ = false;
                                            }
                                            let _e2726 = phi_4602_;
                                            let _e2728 = phi_4603_;
                                            let _e2730 = phi_4604_;
                                            let _e2732 = phi_4605_;
                                            let _e2734 = phi_4606_;
                                            let _e2736 = phi_4607_;
                                            let _e2738 = phi_4608_;
                                            let _e2740 = phi_4609_;
                                            let _e2742 = phi_4610_;
                                            phi_4611_ = _e2726;
                                            phi_4612_ = _e2728;
                                            phi_4613_ = _e2730;
                                            phi_4614_ = _e2732;
                                            phi_4615_ = _e2734;
                                            phi_4616_ = _e2736;
                                            phi_4617_ = _e2738;
                                            phi_4618_ = _e2740;
                                            phi_4619_ = _e2742;
                                        } else {
                                            phi_4611_ = f32();
                                            phi_4612_ = f32();
                                            phi_4613_ = f32();
                                            phi_4614_ = f32();
                                            phi_4615_ = true;
                                            phi_4616_ = false;
                                            phi_4617_ = false;
                                            phi_4618_ = false;
                                            phi_4619_ = false;
                                        }
                                        let _e2744 = phi_4611_;
                                        let _e2746 = phi_4612_;
                                        let _e2748 = phi_4613_;
                                        let _e2750 = phi_4614_;
                                        let _e2752 = phi_4615_;
                                        let _e2754 = phi_4616_;
                                        let _e2756 = phi_4617_;
                                        let _e2758 = phi_4618_;
                                        let _e2760 = phi_4619_;
                                        if _e2752 {
                                            if (_e1682 <= _e1684) {
                                                let _e2913 = (_e1692 + 1u);
                                                let _e2914 = (_e2913 > 3u);
                                                phi_4954_ = _e2913;
                                                phi_4955_ = f32();
                                                phi_4956_ = false;
                                                phi_4957_ = select(true, false, _e2914);
                                                phi_4958_ = _e2914;
                                            } else {
                                                let _e2764 = local_3.member[0u];
                                                let _e2767 = local_3.member_1[0u];
                                                let _e2770 = local_3.member[0u];
                                                let _e2776 = local_3.member_2[0u];
                                                let _e2777 = ((_e2764 + ((_e2767 - _e2770) * _e1688)) - _e2776);
                                                let _e2780 = local_3.member[1u];
                                                let _e2783 = local_3.member_1[1u];
                                                let _e2786 = local_3.member[1u];
                                                let _e2792 = local_3.member_2[1u];
                                                let _e2793 = ((_e2780 + ((_e2783 - _e2786) * _e1688)) - _e2792);
                                                let _e2795 = select(_e2793, _e2777, (_e2777 < _e2793));
                                                let _e2798 = local_3.member[2u];
                                                let _e2801 = local_3.member_1[2u];
                                                let _e2804 = local_3.member[2u];
                                                let _e2810 = local_3.member_2[2u];
                                                let _e2811 = ((_e2798 + ((_e2801 - _e2804) * _e1688)) - _e2810);
                                                let _e2814 = local_3.member[3u];
                                                let _e2817 = local_3.member_1[3u];
                                                let _e2820 = local_3.member[3u];
                                                let _e2826 = local_3.member_2[3u];
                                                let _e2827 = ((_e2814 + ((_e2817 - _e2820) * _e1688)) - _e2826);
                                                let _e2829 = select(_e2827, _e2811, (_e2811 < _e2827));
                                                let _e2831 = select(_e2829, _e2795, (_e2795 < _e2829));
                                                let _e2834 = local_4.member[0u];
                                                let _e2837 = local_4.member_1[0u];
                                                let _e2840 = local_4.member[0u];
                                                let _e2846 = local_4.member_2[0u];
                                                let _e2847 = ((_e2834 + ((_e2837 - _e2840) * _e1682)) - _e2846);
                                                let _e2850 = local_4.member[1u];
                                                let _e2853 = local_4.member_1[1u];
                                                let _e2856 = local_4.member[1u];
                                                let _e2862 = local_4.member_2[1u];
                                                let _e2863 = ((_e2850 + ((_e2853 - _e2856) * _e1682)) - _e2862);
                                                let _e2865 = select(_e2863, _e2847, (_e2847 < _e2863));
                                                let _e2868 = local_4.member[2u];
                                                let _e2871 = local_4.member_1[2u];
                                                let _e2874 = local_4.member[2u];
                                                let _e2880 = local_4.member_2[2u];
                                                let _e2881 = ((_e2868 + ((_e2871 - _e2874) * _e1682)) - _e2880);
                                                let _e2884 = local_4.member[3u];
                                                let _e2887 = local_4.member_1[3u];
                                                let _e2890 = local_4.member[3u];
                                                let _e2896 = local_4.member_2[3u];
                                                let _e2897 = ((_e2884 + ((_e2887 - _e2890) * _e1682)) - _e2896);
                                                let _e2899 = select(_e2897, _e2881, (_e2881 < _e2897));
                                                let _e2901 = select(_e2899, _e2865, (_e2865 < _e2899));
                                                if (_e2901 > 0f) {
                                                    phi_4952_ = 0.5f;
                                                } else {
                                                    let _e2905 = (0.95f * (_e2831 / (_e2831 - _e2901)));
                                                    phi_4952_ = select(0.0625f, select(0.9f, _e2905, (_e2905 < 0.9f)), (_e2905 > 0.0625f));
                                                }
                                                let _e2911 = phi_4952_;
                                                phi_4954_ = u32();
                                                phi_4955_ = (_e1981 * _e2911);
                                                phi_4956_ = true;
                                                phi_4957_ = false;
                                                phi_4958_ = false;
                                            }
                                            let _e2917 = phi_4954_;
                                            let _e2919 = phi_4955_;
                                            let _e2921 = phi_4956_;
                                            let _e2923 = phi_4957_;
                                            let _e2925 = phi_4958_;
                                            phi_4959_ = _e2917;
                                            phi_4960_ = _e1684;
                                            phi_4961_ = _e2919;
                                            phi_4962_ = _e1686;
                                            phi_4963_ = _e1688;
                                            phi_4964_ = _e1690;
                                            phi_4965_ = _e1692;
                                            phi_4966_ = _e2921;
                                            phi_4967_ = _e2923;
                                            phi_4968_ = _e2925;
                                            phi_4969_ = false;
                                            phi_4970_ = false;
                                            phi_4971_ = false;
                                        } else {
                                            phi_4959_ = u32();
                                            phi_4960_ = _e2744;
                                            phi_4961_ = _e2746;
                                            phi_4962_ = _e2748;
                                            phi_4963_ = _e1682;
                                            phi_4964_ = true;
                                            phi_4965_ = 0u;
                                            phi_4966_ = _e2754;
                                            phi_4967_ = false;
                                            phi_4968_ = false;
                                            phi_4969_ = _e2756;
                                            phi_4970_ = _e2758;
                                            phi_4971_ = _e2760;
                                        }
                                        let _e2927 = phi_4959_;
                                        let _e2929 = phi_4960_;
                                        let _e2931 = phi_4961_;
                                        let _e2933 = phi_4962_;
                                        let _e2935 = phi_4963_;
                                        let _e2937 = phi_4964_;
                                        let _e2939 = phi_4965_;
                                        let _e2941 = phi_4966_;
                                        let _e2943 = phi_4967_;
                                        let _e2945 = phi_4968_;
                                        let _e2947 = phi_4969_;
                                        let _e2949 = phi_4970_;
                                        let _e2951 = phi_4971_;
                                        if _e2941 {
                                            let _e2952 = (_e2935 + _e2931);
                                            let _e2954 = select(_e2929, _e2952, (_e2952 > _e2929));
                                            let _e2956 = select(_e383, _e2954, (_e2954 < _e383));
                                            let _e2959 = select(((_e2956 - _e2935) > _e1677), true, !(_e1690));
                                            phi_4999_ = _e2956;
                                            phi_5000_ = _e2929;
                                            phi_5001_ = _e2933;
                                            phi_5002_ = _e2935;
                                            phi_5003_ = _e2937;
                                            phi_5004_ = _e2939;
                                            phi_5005_ = _e2959;
                                            phi_5006_ = select(true, false, _e2959);
                                            phi_5007_ = false;
                                            phi_5008_ = false;
                                            phi_5009_ = false;
                                            phi_5010_ = false;
                                        } else {
                                            phi_4999_ = _e1682;
                                            phi_5000_ = _e1684;
                                            phi_5001_ = _e1686;
                                            phi_5002_ = _e1688;
                                            phi_5003_ = _e1690;
                                            phi_5004_ = _e2927;
                                            phi_5005_ = _e2943;
                                            phi_5006_ = false;
                                            phi_5007_ = _e2945;
                                            phi_5008_ = _e2947;
                                            phi_5009_ = _e2949;
                                            phi_5010_ = _e2951;
                                        }
                                        let _e2962 = phi_4999_;
                                        let _e2964 = phi_5000_;
                                        let _e2966 = phi_5001_;
                                        let _e2968 = phi_5002_;
                                        let _e2970 = phi_5003_;
                                        let _e2972 = phi_5004_;
                                        let _e2974 = phi_5005_;
                                        let _e2976 = phi_5006_;
                                        let _e2978 = phi_5007_;
                                        let _e2980 = phi_5008_;
                                        let _e2982 = phi_5009_;
                                        let _e2984 = phi_5010_;
                                        phi_2832_ = _e2962;
                                        phi_2834_ = _e2964;
                                        phi_2836_ = _e2966;
                                        phi_2838_ = _e2968;
                                        phi_2840_ = _e2970;
                                        phi_2842_ = _e2972;
                                        phi_5011_ = _e2929;
                                        phi_5012_ = _e2750;
                                        phi_5013_ = _e2974;
                                        phi_5014_ = _e2976;
                                        phi_5015_ = _e2978;
                                        phi_5016_ = _e2980;
                                        phi_5017_ = _e2982;
                                        phi_5018_ = false;
                                        phi_5019_ = _e2984;
                                    } else {
                                        phi_2832_ = f32();
                                        phi_2834_ = f32();
                                        phi_2836_ = f32();
                                        phi_2838_ = f32();
                                        phi_2840_ = bool();
                                        phi_2842_ = u32();
                                        phi_5011_ = f32();
                                        phi_5012_ = f32();
                                        phi_5013_ = false;
                                        phi_5014_ = false;
                                        phi_5015_ = false;
                                        phi_5016_ = false;
                                        phi_5017_ = false;
                                        phi_5018_ = true;
                                        phi_5019_ = false;
                                    }
                                    let _e2986 = phi_2832_;
                                    let _e2988 = phi_2834_;
                                    let _e2990 = phi_2836_;
                                    let _e2992 = phi_2838_;
                                    let _e2994 = phi_2840_;
                                    let _e2996 = phi_2842_;
                                    let _e2998 = phi_5011_;
                                    let _e3000 = phi_5012_;
                                    let _e3002 = phi_5013_;
                                    let _e3004 = phi_5014_;
                                    let _e3006 = phi_5015_;
                                    let _e3008 = phi_5016_;
                                    let _e3010 = phi_5017_;
                                    let _e3012 = phi_5018_;
                                    let _e3014 = phi_5019_;
                                    local_10 = _e3004;
                                    local_11 = _e3006;
                                    local_12 = _e3004;
                                    local_13 = _e3008;
                                    local_14 = _e3004;
                                    local_15 = _e3010;
                                    local_16 = _e3004;
                                    local_17 = _e3012;
                                    local_18 = _e3004;
                                    local_19 = _e3014;
                                    local_21 = _e3004;
                                    local_22 = _e3000;
                                    local_23 = _e2998;
                                    continue;
                                    continuing {
                                        phi_2828_ = type_9(select(_e1680.member, (_e1680.member + 1u), _e1695), select(_e1680.member_1, _e1680.member_1, _e1695));
                                        phi_2831_ = _e2986;
                                        phi_2833_ = _e2988;
                                        phi_2835_ = _e2990;
                                        phi_2837_ = _e2992;
                                        phi_2839_ = _e2994;
                                        phi_2841_ = _e2996;
                                        break if !(_e3002);
                                    }
                                }
                                let _e3017 = local_10;
                                let _e3019 = local_11;
                                let _e3020 = select(_e3019, false, _e3017);
                                let _e3022 = local_12;
                                let _e3024 = local_13;
                                let _e3027 = local_14;
                                let _e3029 = local_15;
                                let _e3032 = local_16;
                                let _e3034 = local_17;
                                let _e3037 = local_18;
                                let _e3039 = local_19;
                                let _e3045 = local_20;
                                let _e3047 = select(select(_e3024, false, _e3022), false, _e3020);
                                let _e3050 = local_21;
                                let _e3057 = select(select(select(_e3029, false, _e3027), false, _e3020), false, _e3047);
                                let _e3063 = local_22;
                                let _e3065 = local_23;
                                let _e3067 = select(select(select(_e3050, false, _e3020), false, _e3047), true, _e3057);
                                let _e3072 = local_24;
                                let _e3074 = select(select(select(select(select(_e3034, false, _e3032), false, _e3020), false, _e3047), false, _e3057), true, _e3067);
                                let _e3081 = select(select(select(select(select(select(_e3039, false, _e3037), false, _e3020), false, _e3047), false, _e3057), false, _e3067), false, _e3074);
                                let _e3086 = select(select(select(select(select(_e3020, true, _e3047), false, _e3057), false, _e3067), false, _e3074), true, _e3081);
                                phi_5086_ = select(select(type_34().member_1, select(_e3072, select(_e3065, _e3063, _e3057), _e3067), _e3074), select(select(select(type_34().member_1, _e3045, _e3020), type_34().member_1, _e3047), type_34().member_1, _e3081), _e3086);
                                phi_5087_ = (select(select(type_34().member, 1u, _e3074), select(select(select(type_34().member, 1u, _e3020), 0u, _e3047), 0u, _e3081), _e3086) != 0u);
                            } else {
                                phi_5086_ = _e1444;
                                phi_5087_ = true;
                            }
                            let _e3091 = phi_5086_;
                            let _e3093 = phi_5087_;
                            if _e3093 {
                                let _e3094 = (_e3091 > _e381);
                                if _e3094 {
                                    phi_7252_ = f32();
                                    phi_7253_ = u32();
                                    phi_7254_ = f32();
                                    phi_7255_ = type_36();
                                    phi_7256_ = u32();
                                    phi_7257_ = u32();
                                    phi_7258_ = false;
                                    phi_7259_ = false;
                                    phi_7260_ = false;
                                } else {
                                    let _e3097 = local_5.member[0u];
                                    let _e3103 = local_5.member[1u];
                                    let _e3119 = local_5.member_1[0u];
                                    let _e3125 = local_5.member_1[1u];
                                    let _e3141 = local_5.member_2[0u];
                                    let _e3147 = local_5.member_2[1u];
                                    let _e3161 = function_3(array<f32, 3>((_e3097[0] + ((_e3103[0] - _e3097[0]) * _e1448)), (_e3097[1] + ((_e3103[1] - _e3097[1]) * _e1448)), (_e3097[2] + ((_e3103[2] - _e3097[2]) * _e1448))), array<f32, 3>((_e3119[0] + ((_e3125[0] - _e3119[0]) * _e1448)), (_e3119[1] + ((_e3125[1] - _e3119[1]) * _e1448)), (_e3119[2] + ((_e3125[2] - _e3119[2]) * _e1448))), array<f32, 3>((_e3141[0] + ((_e3147[0] - _e3141[0]) * _e1448)), (_e3141[1] + ((_e3147[1] - _e3141[1]) * _e1448)), (_e3141[2] + ((_e3147[2] - _e3141[2]) * _e1448))), _e226.member);
                                    let _e3175 = ((select(_e3161[0], -(_e3161[0]), (_e3161[0] < 0f)) + select(_e3161[1], -(_e3161[1]), (_e3161[1] < 0f))) + select(_e3161[2], -(_e3161[2]), (_e3161[2] < 0f)));
                                    let _e3178 = local_5.member[0u];
                                    let _e3184 = local_5.member_1[0u];
                                    let _e3190 = local_5.member_2[0u];
                                    let _e3194 = (_e3178[0] - _e3184[0]);
                                    let _e3195 = (_e3178[1] - _e3184[1]);
                                    let _e3196 = (_e3178[2] - _e3184[2]);
                                    let _e3197 = (_e226.member == 0u);
                                    let _e3209 = local_5.member[1u];
                                    let _e3215 = local_5.member_1[1u];
                                    let _e3221 = local_5.member_2[1u];
                                    let _e3225 = (_e3209[0] - _e3215[0]);
                                    let _e3226 = (_e3209[1] - _e3215[1]);
                                    let _e3227 = (_e3209[2] - _e3215[2]);
                                    let _e3228 = (_e226.member == 0u);
                                    let _e3240 = local_5.member[0u];
                                    let _e3246 = select(_e3240[0], -(_e3240[0]), (_e3240[0] < 0f));
                                    let _e3249 = select(_e3240[1], -(_e3240[1]), (_e3240[1] < 0f));
                                    let _e3251 = select(_e3249, _e3246, (_e3246 > _e3249));
                                    let _e3254 = select(_e3240[2], -(_e3240[2]), (_e3240[2] < 0f));
                                    let _e3256 = select(_e3254, _e3251, (_e3251 > _e3254));
                                    let _e3259 = local_5.member[1u];
                                    let _e3265 = select(_e3259[0], -(_e3259[0]), (_e3259[0] < 0f));
                                    let _e3268 = select(_e3259[1], -(_e3259[1]), (_e3259[1] < 0f));
                                    let _e3270 = select(_e3268, _e3265, (_e3265 > _e3268));
                                    let _e3273 = select(_e3259[2], -(_e3259[2]), (_e3259[2] < 0f));
                                    let _e3275 = select(_e3273, _e3270, (_e3270 > _e3273));
                                    let _e3279 = local_5.member_3;
                                    let _e3283 = local_5.member_1[0u];
                                    let _e3289 = select(_e3283[0], -(_e3283[0]), (_e3283[0] < 0f));
                                    let _e3292 = select(_e3283[1], -(_e3283[1]), (_e3283[1] < 0f));
                                    let _e3294 = select(_e3292, _e3289, (_e3289 > _e3292));
                                    let _e3297 = select(_e3283[2], -(_e3283[2]), (_e3283[2] < 0f));
                                    let _e3299 = select(_e3297, _e3294, (_e3294 > _e3297));
                                    let _e3302 = local_5.member_1[1u];
                                    let _e3308 = select(_e3302[0], -(_e3302[0]), (_e3302[0] < 0f));
                                    let _e3311 = select(_e3302[1], -(_e3302[1]), (_e3302[1] < 0f));
                                    let _e3313 = select(_e3311, _e3308, (_e3308 > _e3311));
                                    let _e3316 = select(_e3302[2], -(_e3302[2]), (_e3302[2] < 0f));
                                    let _e3318 = select(_e3316, _e3313, (_e3313 > _e3316));
                                    let _e3322 = local_5.member_3;
                                    let _e3326 = local_5.member_2[0u];
                                    let _e3332 = select(_e3326[0], -(_e3326[0]), (_e3326[0] < 0f));
                                    let _e3335 = select(_e3326[1], -(_e3326[1]), (_e3326[1] < 0f));
                                    let _e3337 = select(_e3335, _e3332, (_e3332 > _e3335));
                                    let _e3340 = select(_e3326[2], -(_e3326[2]), (_e3326[2] < 0f));
                                    let _e3342 = select(_e3340, _e3337, (_e3337 > _e3340));
                                    let _e3345 = local_5.member_2[1u];
                                    let _e3351 = select(_e3345[0], -(_e3345[0]), (_e3345[0] < 0f));
                                    let _e3354 = select(_e3345[1], -(_e3345[1]), (_e3345[1] < 0f));
                                    let _e3356 = select(_e3354, _e3351, (_e3351 > _e3354));
                                    let _e3359 = select(_e3345[2], -(_e3345[2]), (_e3345[2] < 0f));
                                    let _e3361 = select(_e3359, _e3356, (_e3356 > _e3359));
                                    let _e3365 = local_5.member_3;
                                    let _e3372 = local_5.member_3;
                                    local_1 = type_30(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e3178, array<f32, 3>(_e3194, _e3195, _e3196), array<f32, 3>((_e3178[0] - _e3190[0]), (_e3178[1] - _e3190[1]), (_e3178[2] - _e3190[2])), array<f32, 3>(select((_e3194 - _e3190[0]), _e3178[0], _e3197), select((_e3195 - _e3190[1]), _e3178[1], _e3197), select((_e3196 - _e3190[2]), _e3178[2], _e3197))), array<array<f32, 3>, 4>(_e3209, array<f32, 3>(_e3225, _e3226, _e3227), array<f32, 3>((_e3209[0] - _e3221[0]), (_e3209[1] - _e3221[1]), (_e3209[2] - _e3221[2])), array<f32, 3>(select((_e3225 - _e3221[0]), _e3209[0], _e3228), select((_e3226 - _e3221[1]), _e3209[1], _e3228), select((_e3227 - _e3221[2]), _e3209[2], _e3228)))), ((((((select(_e3275, _e3256, (_e3256 > _e3275)) + _e3279) + (select(_e3318, _e3299, (_e3299 > _e3318)) + _e3322)) + (select(_e3361, _e3342, (_e3342 > _e3361)) + _e3365)) * (0.000000059604645f * 16f)) + (_e3372 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e734.member_1);
                                    let _e3388 = local_1.member_1;
                                    if (_e3175 > _e3388) {
                                        if ((bitcast<u32>(_e3175) & 2139095040u) != 2139095040u) {
                                            let _e3393 = (1f / _e3175);
                                            let _e3395 = (_e3161[0] * _e3393);
                                            let _e3397 = (_e3161[1] * _e3393);
                                            let _e3399 = (_e3161[2] * _e3393);
                                            let _e3404 = (((_e3395 * _e3395) + (_e3397 * _e3397)) + (_e3399 * _e3399));
                                            if (_e3404 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5764_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3404 > 0f));
                                            } else {
                                                phi_5707_ = type_14(0i, 5i);
                                                phi_5710_ = bitcast<f32>(((bitcast<u32>(_e3404) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3412 = phi_5707_;
                                                    let _e3414 = phi_5710_;
                                                    local_25 = _e3414;
                                                    if (_e3412.member < _e3412.member_1) {
                                                        let _e3421 = (_e3412.member + 1i);
                                                        phi_5708_ = type_14(select(_e3421, type_15().member_1, select(false, true, ((false == (_e3421 > _e3412.member)) != false))), _e3412.member_1);
                                                        phi_5751_ = type_15(1u, _e3412.member);
                                                    } else {
                                                        phi_5708_ = _e3412;
                                                        phi_5751_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3432 = phi_5708_;
                                                    let _e3434 = phi_5751_;
                                                    let _e3437 = (bitcast<i32>(_e3434.member) != 0i);
                                                    if _e3437 {
                                                        phi_5711_ = (0.5f * (_e3414 + (_e3404 / _e3414)));
                                                    } else {
                                                        phi_5711_ = f32();
                                                    }
                                                    let _e3442 = phi_5711_;
                                                    continue;
                                                    continuing {
                                                        phi_5707_ = _e3432;
                                                        phi_5710_ = _e3442;
                                                        break if !(_e3437);
                                                    }
                                                }
                                                let _e3447 = local_25;
                                                phi_5764_ = (_e3447 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3453 = phi_5764_;
                                            let _e3454 = (0.000000059604645f * 12f);
                                            let _e3456 = local_1.member_1;
                                            let _e3459 = local_1.member_2;
                                            let _e3463 = ((_e3456 * 1.01f) + ((_e3459 * _e3453) * (1f + _e3454)));
                                            let _e3467 = local_1.member[0u][0u];
                                            let _e3475 = (((_e3395 * _e3467[0]) + (_e3397 * _e3467[1])) + (_e3399 * _e3467[2]));
                                            let _e3479 = local_1.member[0u][1u];
                                            let _e3487 = (((_e3395 * _e3479[0]) + (_e3397 * _e3479[1])) + (_e3399 * _e3479[2]));
                                            let _e3491 = local_1.member[0u][2u];
                                            let _e3499 = (((_e3395 * _e3491[0]) + (_e3397 * _e3491[1])) + (_e3399 * _e3491[2]));
                                            let _e3503 = local_1.member[0u][3u];
                                            let _e3511 = (((_e3395 * _e3503[0]) + (_e3397 * _e3503[1])) + (_e3399 * _e3503[2]));
                                            let _e3515 = local_1.member[1u][0u];
                                            let _e3523 = (((_e3395 * _e3515[0]) + (_e3397 * _e3515[1])) + (_e3399 * _e3515[2]));
                                            let _e3527 = local_1.member[1u][1u];
                                            let _e3535 = (((_e3395 * _e3527[0]) + (_e3397 * _e3527[1])) + (_e3399 * _e3527[2]));
                                            let _e3539 = local_1.member[1u][2u];
                                            let _e3547 = (((_e3395 * _e3539[0]) + (_e3397 * _e3539[1])) + (_e3399 * _e3539[2]));
                                            let _e3551 = local_1.member[1u][3u];
                                            let _e3559 = (((_e3395 * _e3551[0]) + (_e3397 * _e3551[1])) + (_e3399 * _e3551[2]));
                                            local_2 = type_31(array<f32, 4>(_e3475, _e3487, _e3499, _e3511), array<f32, 4>(_e3523, _e3535, _e3547, _e3559), array<f32, 4>((_e3463 + ((select(_e3475, -(_e3475), (_e3475 < 0f)) + select(_e3523, -(_e3523), (_e3523 < 0f))) * _e3454)), (_e3463 + ((select(_e3487, -(_e3487), (_e3487 < 0f)) + select(_e3535, -(_e3535), (_e3535 < 0f))) * _e3454)), (_e3463 + ((select(_e3499, -(_e3499), (_e3499 < 0f)) + select(_e3547, -(_e3547), (_e3547 < 0f))) * _e3454)), (_e3463 + ((select(_e3511, -(_e3511), (_e3511 < 0f)) + select(_e3559, -(_e3559), (_e3559 < 0f))) * _e3454))));
                                            let _e3604 = (((_e3395 * _e3395) + (_e3397 * _e3397)) + (_e3399 * _e3399));
                                            if (_e3604 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_6056_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3604 > 0f));
                                            } else {
                                                phi_5999_ = type_14(0i, 5i);
                                                phi_6002_ = bitcast<f32>(((bitcast<u32>(_e3604) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3612 = phi_5999_;
                                                    let _e3614 = phi_6002_;
                                                    local_26 = _e3614;
                                                    if (_e3612.member < _e3612.member_1) {
                                                        let _e3621 = (_e3612.member + 1i);
                                                        phi_6000_ = type_14(select(_e3621, type_15().member_1, select(false, true, ((false == (_e3621 > _e3612.member)) != false))), _e3612.member_1);
                                                        phi_6043_ = type_15(1u, _e3612.member);
                                                    } else {
                                                        phi_6000_ = _e3612;
                                                        phi_6043_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3632 = phi_6000_;
                                                    let _e3634 = phi_6043_;
                                                    let _e3637 = (bitcast<i32>(_e3634.member) != 0i);
                                                    if _e3637 {
                                                        phi_6003_ = (0.5f * (_e3614 + (_e3604 / _e3614)));
                                                    } else {
                                                        phi_6003_ = f32();
                                                    }
                                                    let _e3642 = phi_6003_;
                                                    continue;
                                                    continuing {
                                                        phi_5999_ = _e3632;
                                                        phi_6002_ = _e3642;
                                                        break if !(_e3637);
                                                    }
                                                }
                                                let _e3647 = local_26;
                                                phi_6056_ = (_e3647 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3653 = phi_6056_;
                                            let _e3664 = (((_e3161[0] * _e3161[0]) + (_e3161[1] * _e3161[1])) + (_e3161[2] * _e3161[2]));
                                            if (_e3664 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_6145_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3664 > 0f));
                                            } else {
                                                phi_6088_ = type_14(0i, 5i);
                                                phi_6091_ = bitcast<f32>(((bitcast<u32>(_e3664) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e3672 = phi_6088_;
                                                    let _e3674 = phi_6091_;
                                                    local_27 = _e3674;
                                                    if (_e3672.member < _e3672.member_1) {
                                                        let _e3681 = (_e3672.member + 1i);
                                                        phi_6089_ = type_14(select(_e3681, type_15().member_1, select(false, true, ((false == (_e3681 > _e3672.member)) != false))), _e3672.member_1);
                                                        phi_6132_ = type_15(1u, _e3672.member);
                                                    } else {
                                                        phi_6089_ = _e3672;
                                                        phi_6132_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3692 = phi_6089_;
                                                    let _e3694 = phi_6132_;
                                                    let _e3697 = (bitcast<i32>(_e3694.member) != 0i);
                                                    if _e3697 {
                                                        phi_6092_ = (0.5f * (_e3674 + (_e3664 / _e3674)));
                                                    } else {
                                                        phi_6092_ = f32();
                                                    }
                                                    let _e3702 = phi_6092_;
                                                    continue;
                                                    continuing {
                                                        phi_6088_ = _e3692;
                                                        phi_6091_ = _e3702;
                                                        break if !(_e3697);
                                                    }
                                                }
                                                let _e3707 = local_27;
                                                phi_6145_ = (_e3707 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e3713 = phi_6145_;
                                            let _e3719 = local_5.member[0u];
                                            let _e3725 = select(_e3719[0], -(_e3719[0]), (_e3719[0] < 0f));
                                            let _e3728 = select(_e3719[1], -(_e3719[1]), (_e3719[1] < 0f));
                                            let _e3730 = select(_e3728, _e3725, (_e3725 > _e3728));
                                            let _e3733 = select(_e3719[2], -(_e3719[2]), (_e3719[2] < 0f));
                                            let _e3735 = select(_e3733, _e3730, (_e3730 > _e3733));
                                            let _e3738 = local_5.member[1u];
                                            let _e3744 = select(_e3738[0], -(_e3738[0]), (_e3738[0] < 0f));
                                            let _e3747 = select(_e3738[1], -(_e3738[1]), (_e3738[1] < 0f));
                                            let _e3749 = select(_e3747, _e3744, (_e3744 > _e3747));
                                            let _e3752 = select(_e3738[2], -(_e3738[2]), (_e3738[2] < 0f));
                                            let _e3754 = select(_e3752, _e3749, (_e3749 > _e3752));
                                            let _e3758 = local_5.member_3;
                                            let _e3762 = local_5.member_1[0u];
                                            let _e3768 = select(_e3762[0], -(_e3762[0]), (_e3762[0] < 0f));
                                            let _e3771 = select(_e3762[1], -(_e3762[1]), (_e3762[1] < 0f));
                                            let _e3773 = select(_e3771, _e3768, (_e3768 > _e3771));
                                            let _e3776 = select(_e3762[2], -(_e3762[2]), (_e3762[2] < 0f));
                                            let _e3778 = select(_e3776, _e3773, (_e3773 > _e3776));
                                            let _e3781 = local_5.member_1[1u];
                                            let _e3787 = select(_e3781[0], -(_e3781[0]), (_e3781[0] < 0f));
                                            let _e3790 = select(_e3781[1], -(_e3781[1]), (_e3781[1] < 0f));
                                            let _e3792 = select(_e3790, _e3787, (_e3787 > _e3790));
                                            let _e3795 = select(_e3781[2], -(_e3781[2]), (_e3781[2] < 0f));
                                            let _e3797 = select(_e3795, _e3792, (_e3792 > _e3795));
                                            let _e3801 = local_5.member_3;
                                            let _e3805 = local_5.member_2[0u];
                                            let _e3811 = select(_e3805[0], -(_e3805[0]), (_e3805[0] < 0f));
                                            let _e3814 = select(_e3805[1], -(_e3805[1]), (_e3805[1] < 0f));
                                            let _e3816 = select(_e3814, _e3811, (_e3811 > _e3814));
                                            let _e3819 = select(_e3805[2], -(_e3805[2]), (_e3805[2] < 0f));
                                            let _e3821 = select(_e3819, _e3816, (_e3816 > _e3819));
                                            let _e3824 = local_5.member_2[1u];
                                            let _e3830 = select(_e3824[0], -(_e3824[0]), (_e3824[0] < 0f));
                                            let _e3833 = select(_e3824[1], -(_e3824[1]), (_e3824[1] < 0f));
                                            let _e3835 = select(_e3833, _e3830, (_e3830 > _e3833));
                                            let _e3838 = select(_e3824[2], -(_e3824[2]), (_e3824[2] < 0f));
                                            let _e3840 = select(_e3838, _e3835, (_e3835 > _e3838));
                                            let _e3844 = local_5.member_3;
                                            let _e3851 = local_5.member_3;
                                            let _e3861 = ((((_e3713 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e3754, _e3735, (_e3735 > _e3754)) + _e3758) + (select(_e3797, _e3778, (_e3778 > _e3797)) + _e3801)) + (select(_e3840, _e3821, (_e3821 > _e3840)) + _e3844)) * (0.000000059604645f * 16f)) + (_e3851 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e3653) * (1f + (0.000000059604645f * 64f)));
                                            let _e3864 = local_2.member[0u];
                                            let _e3867 = local_2.member_1[0u];
                                            phi_6453_ = type_9(1u, 4u);
                                            phi_6456_ = ((_e3864 + ((_e3867 - _e3864) * _e1448)) - ((_e3388 * 1.01f) + ((select(_e3864, -(_e3864), (_e3864 < 0f)) + select(_e3867, -(_e3867), (_e3867 < 0f))) * (0.000000059604645f * 12f))));
                                            loop {
                                                let _e3884 = phi_6453_;
                                                let _e3886 = phi_6456_;
                                                local_28 = _e3886;
                                                local_29 = _e3886;
                                                let _e3889 = (_e3884.member < _e3884.member_1);
                                                let _e3900 = select(type_9().member_1, _e3884.member, _e3889);
                                                let _e3902 = (bitcast<i32>(select(0u, 1u, _e3889)) != 0i);
                                                if _e3902 {
                                                    let _e3905 = local_2.member[_e3900];
                                                    let _e3908 = local_2.member_1[_e3900];
                                                    let _e3923 = ((_e3905 + ((_e3908 - _e3905) * _e1448)) - ((_e3388 * 1.01f) + ((select(_e3905, -(_e3905), (_e3905 < 0f)) + select(_e3908, -(_e3908), (_e3908 < 0f))) * (0.000000059604645f * 12f))));
                                                    phi_6457_ = select(_e3923, _e3886, (_e3886 < _e3923));
                                                } else {
                                                    phi_6457_ = f32();
                                                }
                                                let _e3927 = phi_6457_;
                                                continue;
                                                continuing {
                                                    phi_6453_ = type_9(select(_e3884.member, (_e3884.member + 1u), _e3889), select(_e3884.member_1, _e3884.member_1, _e3889));
                                                    phi_6456_ = _e3927;
                                                    break if !(_e3902);
                                                }
                                            }
                                            let _e3930 = local_28;
                                            if (_e3930 > 0f) {
                                                let _e3934 = local_29;
                                                let _e3937 = (((_e3861 - _e3934) / _e3861) * 2.02f);
                                                if (_e3937 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_6612_ = select(0f, (0.000000000000000000106433627f * 2f), (_e3937 > 0f));
                                                } else {
                                                    phi_6555_ = type_14(0i, 5i);
                                                    phi_6558_ = bitcast<f32>(((bitcast<u32>(_e3937) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e3945 = phi_6555_;
                                                        let _e3947 = phi_6558_;
                                                        local_30 = _e3947;
                                                        if (_e3945.member < _e3945.member_1) {
                                                            let _e3954 = (_e3945.member + 1i);
                                                            phi_6556_ = type_14(select(_e3954, type_15().member_1, select(false, true, ((false == (_e3954 > _e3945.member)) != false))), _e3945.member_1);
                                                            phi_6599_ = type_15(1u, _e3945.member);
                                                        } else {
                                                            phi_6556_ = _e3945;
                                                            phi_6599_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3965 = phi_6556_;
                                                        let _e3967 = phi_6599_;
                                                        let _e3970 = (bitcast<i32>(_e3967.member) != 0i);
                                                        if _e3970 {
                                                            phi_6559_ = (0.5f * (_e3947 + (_e3937 / _e3947)));
                                                        } else {
                                                            phi_6559_ = f32();
                                                        }
                                                        let _e3975 = phi_6559_;
                                                        continue;
                                                        continuing {
                                                            phi_6555_ = _e3965;
                                                            phi_6558_ = _e3975;
                                                            break if !(_e3970);
                                                        }
                                                    }
                                                    let _e3980 = local_30;
                                                    phi_6612_ = (_e3980 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e3986 = phi_6612_;
                                                let _e3988 = ((_e3986 * _e3653) * 1.01f);
                                                phi_6617_ = type_9(0u, 4u);
                                                phi_6620_ = 2f;
                                                phi_6622_ = true;
                                                phi_6624_ = true;
                                                loop {
                                                    let _e3990 = phi_6617_;
                                                    let _e3992 = phi_6620_;
                                                    let _e3994 = phi_6622_;
                                                    let _e3996 = phi_6624_;
                                                    local_31 = _e3992;
                                                    local_32 = _e3992;
                                                    local_33 = _e3994;
                                                    local_34 = _e3996;
                                                    local_35 = _e3996;
                                                    local_36 = _e3996;
                                                    local_61 = _e3996;
                                                    local_37 = _e3996;
                                                    let _e3999 = (_e3990.member < _e3990.member_1);
                                                    let _e4010 = select(type_9().member_1, _e3990.member, _e3999);
                                                    let _e4012 = (bitcast<i32>(select(0u, 1u, _e3999)) != 0i);
                                                    if _e4012 {
                                                        let _e4016 = local_1.member[0u][_e4010];
                                                        let _e4023 = local_1.member[1u][_e4010];
                                                        let _e4037 = ((select(_e4016[0], -(_e4016[0]), (_e4016[0] < 0f)) + select(_e4016[1], -(_e4016[1]), (_e4016[1] < 0f))) + select(_e4016[2], -(_e4016[2]), (_e4016[2] < 0f)));
                                                        let _e4048 = ((select(_e4023[0], -(_e4023[0]), (_e4023[0] < 0f)) + select(_e4023[1], -(_e4023[1]), (_e4023[1] < 0f))) + select(_e4023[2], -(_e4023[2]), (_e4023[2] < 0f)));
                                                        let _e4054 = (_e4023[0] - _e4016[0]);
                                                        let _e4055 = (_e4023[1] - _e4016[1]);
                                                        let _e4056 = (_e4023[2] - _e4016[2]);
                                                        let _e4073 = local_2.member[_e4010];
                                                        let _e4076 = local_2.member_1[_e4010];
                                                        let _e4087 = ((_e3388 * 1.01f) + ((select(_e4073, -(_e4073), (_e4073 < 0f)) + select(_e4076, -(_e4076), (_e4076 < 0f))) * (0.000000059604645f * 12f)));
                                                        let _e4094 = local_2.member_1[_e4010];
                                                        let _e4097 = local_2.member[_e4010];
                                                        let _e4098 = (_e4094 - _e4097);
                                                        let _e4101 = ((_e4087 + _e4087) + (_e3988 * ((((select(_e4054, -(_e4054), (_e4054 < 0f)) + select(_e4055, -(_e4055), (_e4055 < 0f))) + select(_e4056, -(_e4056), (_e4056 < 0f))) + (_e3388 * 6f)) * 1.01f)));
                                                        let _e4104 = ((((_e4073 + ((_e4076 - _e4073) * _e1448)) - _e4087) - (_e3988 * ((select(_e4048, _e4037, (_e4037 > _e4048)) + (_e3388 * 3f)) * 1.01f))) - _e3861);
                                                        let _e4105 = (_e4104 > 0.000000000000000000000000000000000000011754944f);
                                                        let _e4106 = (_e4098 > _e4101);
                                                        if _e4106 {
                                                            phi_6855_ = _e3992;
                                                        } else {
                                                            if _e4105 {
                                                                let _e4113 = (_e4101 - _e4098);
                                                                let _e4116 = (_e4104 / select(0.000000000000000000000000000000000000011754944f, _e4113, (_e4113 > 0.000000000000000000000000000000000000011754944f)));
                                                                phi_6854_ = select(_e4116, _e3992, (_e3992 < _e4116));
                                                            } else {
                                                                phi_6854_ = _e3992;
                                                            }
                                                            let _e4120 = phi_6854_;
                                                            phi_6855_ = _e4120;
                                                        }
                                                        let _e4122 = phi_6855_;
                                                        phi_6621_ = _e4122;
                                                        phi_6623_ = (_e3994 && select(_e4105, true, (_e4098 < -(_e4101))));
                                                        phi_6625_ = (_e3996 && select(_e4105, true, _e4106));
                                                    } else {
                                                        phi_6621_ = f32();
                                                        phi_6623_ = bool();
                                                        phi_6625_ = bool();
                                                    }
                                                    let _e4124 = phi_6621_;
                                                    let _e4126 = phi_6623_;
                                                    let _e4128 = phi_6625_;
                                                    continue;
                                                    continuing {
                                                        phi_6617_ = type_9(select(_e3990.member, (_e3990.member + 1u), _e3999), select(_e3990.member_1, _e3990.member_1, _e3999));
                                                        phi_6620_ = _e4124;
                                                        phi_6622_ = _e4126;
                                                        phi_6624_ = _e4128;
                                                        break if !(_e4012);
                                                    }
                                                }
                                                let _e4131 = local_31;
                                                let _e4134 = local_32;
                                                let _e4136 = (select(2f, _e4134, (_e4131 < 2f)) * 0.999f);
                                                let _e4138 = local_33;
                                                if _e4138 {
                                                    let _e4141 = local_34;
                                                    let _e4145 = local_35;
                                                    let _e4149 = local_36;
                                                    phi_6870_ = type_36(select(1u, type_36().member, _e4141), select(_e1448, type_36().member_1, _e4145), select(2f, type_36().member_2, _e4149));
                                                    let _e5289 = local_61;
                                                    phi_6871_ = _e5289;
                                                } else {
                                                    phi_6870_ = type_36();
                                                    phi_6871_ = true;
                                                }
                                                let _e4153 = phi_6870_;
                                                let _e4155 = phi_6871_;
                                                if _e4155 {
                                                    let _e4157 = local_37;
                                                    if _e4157 {
                                                        let _e4161 = (_e1448 + _e4136);
                                                        let _e4164 = select(_e1448, select(_e383, _e4161, (_e4161 < _e383)), (_e4136 > (0.000000059604645f * 4096f)));
                                                        phi_6892_ = type_9(0u, 4u);
                                                        phi_6895_ = _e4164;
                                                        phi_6897_ = _e1448;
                                                        loop {
                                                            let _e4166 = phi_6892_;
                                                            let _e4168 = phi_6895_;
                                                            let _e4170 = phi_6897_;
                                                            local_38 = _e4168;
                                                            local_39 = _e4170;
                                                            local_40 = _e4170;
                                                            let _e4173 = (_e4166.member < _e4166.member_1);
                                                            let _e4184 = select(type_9().member_1, _e4166.member, _e4173);
                                                            let _e4186 = (bitcast<i32>(select(0u, 1u, _e4173)) != 0i);
                                                            if _e4186 {
                                                                let _e4189 = local_2.member[_e4184];
                                                                let _e4192 = local_2.member_1[_e4184];
                                                                let _e4195 = local_2.member[_e4184];
                                                                let _e4201 = local_2.member_2[_e4184];
                                                                let _e4202 = ((_e4189 + ((_e4192 - _e4195) * _e1448)) - _e4201);
                                                                let _e4205 = local_2.member_1[_e4184];
                                                                let _e4208 = local_2.member[_e4184];
                                                                let _e4209 = (_e4205 - _e4208);
                                                                if (_e4209 > 0f) {
                                                                    let _e4222 = (_e1448 - (_e4202 / _e4209));
                                                                    phi_7006_ = _e4168;
                                                                    phi_7007_ = select(_e4222, _e4170, (_e4170 > _e4222));
                                                                } else {
                                                                    if (_e4202 > 0f) {
                                                                        if (_e4209 < 0f) {
                                                                            let _e4214 = (_e1448 - (_e4202 / _e4209));
                                                                            phi_7004_ = select(_e4214, _e4168, (_e4168 < _e4214));
                                                                        } else {
                                                                            phi_7004_ = _e4168;
                                                                        }
                                                                        let _e4218 = phi_7004_;
                                                                        phi_7005_ = _e4218;
                                                                    } else {
                                                                        phi_7005_ = _e4168;
                                                                    }
                                                                    let _e4220 = phi_7005_;
                                                                    phi_7006_ = _e4220;
                                                                    phi_7007_ = _e4170;
                                                                }
                                                                let _e4226 = phi_7006_;
                                                                let _e4228 = phi_7007_;
                                                                phi_6896_ = _e4226;
                                                                phi_6898_ = _e4228;
                                                            } else {
                                                                phi_6896_ = f32();
                                                                phi_6898_ = f32();
                                                            }
                                                            let _e4230 = phi_6896_;
                                                            let _e4232 = phi_6898_;
                                                            continue;
                                                            continuing {
                                                                phi_6892_ = type_9(select(_e4166.member, (_e4166.member + 1u), _e4173), select(_e4166.member_1, _e4166.member_1, _e4173));
                                                                phi_6895_ = _e4230;
                                                                phi_6897_ = _e4232;
                                                                break if !(_e4186);
                                                            }
                                                        }
                                                        let _e4235 = local_38;
                                                        let _e4237 = local_39;
                                                        let _e4241 = local_40;
                                                        let _e4242 = (_e4241 + ((_e4235 - _e4237) * 0.5f));
                                                        if (_e4242 > _e1448) {
                                                            if (_e4242 <= _e4164) {
                                                                let _e4247 = local_2.member[0u];
                                                                let _e4250 = local_2.member_1[0u];
                                                                let _e4253 = local_2.member[0u];
                                                                let _e4259 = local_2.member_2[0u];
                                                                if (((_e4247 + ((_e4250 - _e4253) * _e4242)) - _e4259) > 0f) {
                                                                    let _e4264 = local_2.member[1u];
                                                                    let _e4267 = local_2.member_1[1u];
                                                                    let _e4270 = local_2.member[1u];
                                                                    let _e4276 = local_2.member_2[1u];
                                                                    if (((_e4264 + ((_e4267 - _e4270) * _e4242)) - _e4276) > 0f) {
                                                                        let _e4281 = local_2.member[2u];
                                                                        let _e4284 = local_2.member_1[2u];
                                                                        let _e4287 = local_2.member[2u];
                                                                        let _e4293 = local_2.member_2[2u];
                                                                        if (((_e4281 + ((_e4284 - _e4287) * _e4242)) - _e4293) > 0f) {
                                                                            let _e4298 = local_2.member[3u];
                                                                            let _e4301 = local_2.member_1[3u];
                                                                            let _e4304 = local_2.member[3u];
                                                                            let _e4310 = local_2.member_2[3u];
                                                                            phi_7168_ = (((_e4298 + ((_e4301 - _e4304) * _e4242)) - _e4310) > 0f);
                                                                            phi_7169_ = false;
                                                                        } else {
                                                                            phi_7168_ = bool();
                                                                            phi_7169_ = true;
                                                                        }
                                                                        let _e4314 = phi_7168_;
                                                                        let _e4316 = phi_7169_;
                                                                        phi_7170_ = _e4314;
                                                                        phi_7171_ = _e4316;
                                                                    } else {
                                                                        phi_7170_ = bool();
                                                                        phi_7171_ = true;
                                                                    }
                                                                    let _e4318 = phi_7170_;
                                                                    let _e4320 = phi_7171_;
                                                                    phi_7172_ = _e4318;
                                                                    phi_7173_ = _e4320;
                                                                } else {
                                                                    phi_7172_ = bool();
                                                                    phi_7173_ = true;
                                                                }
                                                                let _e4322 = phi_7172_;
                                                                let _e4324 = phi_7173_;
                                                                phi_7182_ = select(true, false, select(_e4322, false, _e4324));
                                                            } else {
                                                                phi_7182_ = true;
                                                            }
                                                            let _e4328 = phi_7182_;
                                                            phi_7183_ = _e4328;
                                                        } else {
                                                            phi_7183_ = true;
                                                        }
                                                        let _e4330 = phi_7183_;
                                                        phi_7190_ = type_36(2u, _e4164, select(_e4242, 2f, _e4330));
                                                        phi_7191_ = type_36();
                                                        phi_7192_ = false;
                                                    } else {
                                                        phi_7190_ = type_36();
                                                        phi_7191_ = type_36(0u, _e1448, 2f);
                                                        phi_7192_ = true;
                                                    }
                                                    let _e4334 = phi_7190_;
                                                    let _e4336 = phi_7191_;
                                                    let _e4338 = phi_7192_;
                                                    phi_7193_ = _e4334;
                                                    phi_7194_ = _e4336;
                                                    phi_7195_ = _e4338;
                                                } else {
                                                    phi_7193_ = type_36();
                                                    phi_7194_ = _e4153;
                                                    phi_7195_ = true;
                                                }
                                                let _e4340 = phi_7193_;
                                                let _e4342 = phi_7194_;
                                                let _e4344 = phi_7195_;
                                                phi_7200_ = _e4342;
                                                phi_7201_ = _e4340;
                                                phi_7202_ = _e4344;
                                            } else {
                                                phi_7200_ = type_36(0u, _e1448, 2f);
                                                phi_7201_ = type_36();
                                                phi_7202_ = true;
                                            }
                                            let _e4346 = phi_7200_;
                                            let _e4348 = phi_7201_;
                                            let _e4350 = phi_7202_;
                                            phi_7206_ = _e4346;
                                            phi_7207_ = _e4348;
                                            phi_7208_ = false;
                                            phi_7209_ = _e4350;
                                        } else {
                                            phi_7206_ = type_36();
                                            phi_7207_ = type_36();
                                            phi_7208_ = true;
                                            phi_7209_ = false;
                                        }
                                        let _e4352 = phi_7206_;
                                        let _e4354 = phi_7207_;
                                        let _e4356 = phi_7208_;
                                        let _e4358 = phi_7209_;
                                        phi_7210_ = _e4352;
                                        phi_7211_ = _e4354;
                                        phi_7212_ = _e4356;
                                        phi_7213_ = _e4358;
                                    } else {
                                        phi_7210_ = type_36();
                                        phi_7211_ = type_36();
                                        phi_7212_ = true;
                                        phi_7213_ = false;
                                    }
                                    let _e4360 = phi_7210_;
                                    let _e4362 = phi_7211_;
                                    let _e4364 = phi_7212_;
                                    let _e4366 = phi_7213_;
                                    let _e4373 = select(_e4366, true, _e4364);
                                    let _e4375 = select(_e4362.member, select(_e4360.member, 0u, _e4364), _e4373);
                                    let _e4379 = select(_e4362.member_2, select(_e4360.member_2, 2f, _e4364), _e4373);
                                    if select(false, _e375, ((_e385 & 64u) != 0u)) {
                                        let _e4381 = (_e4375 == 2u);
                                        let _e4382 = (_e4379 <= _e383);
                                        phi_7247_ = select(f32(), select(f32(), _e4379, _e4382), _e4381);
                                        phi_7248_ = select(f32(), select(f32(), _e4379, _e4382), _e4381);
                                        phi_7249_ = select(false, _e4382, _e4381);
                                        phi_7250_ = select(false, select(true, false, _e4382), _e4381);
                                        phi_7251_ = select(true, false, _e4381);
                                    } else {
                                        phi_7247_ = f32();
                                        phi_7248_ = f32();
                                        phi_7249_ = false;
                                        phi_7250_ = false;
                                        phi_7251_ = true;
                                    }
                                    let _e4392 = phi_7247_;
                                    let _e4394 = phi_7248_;
                                    let _e4396 = phi_7249_;
                                    let _e4398 = phi_7250_;
                                    let _e4400 = phi_7251_;
                                    phi_7252_ = _e4392;
                                    phi_7253_ = _e4375;
                                    phi_7254_ = _e4394;
                                    phi_7255_ = type_36(_e4375, select(_e4362.member_1, select(_e4360.member_1, _e1448, _e4364), _e4373), _e4379);
                                    phi_7256_ = _e4375;
                                    phi_7257_ = _e4375;
                                    phi_7258_ = _e4396;
                                    phi_7259_ = _e4398;
                                    phi_7260_ = _e4400;
                                }
                                let _e4402 = phi_7252_;
                                let _e4404 = phi_7253_;
                                let _e4406 = phi_7254_;
                                let _e4408 = phi_7255_;
                                let _e4410 = phi_7256_;
                                let _e4412 = phi_7257_;
                                let _e4414 = phi_7258_;
                                let _e4416 = phi_7259_;
                                let _e4418 = phi_7260_;
                                phi_7261_ = _e4402;
                                phi_7262_ = _e4404;
                                phi_7263_ = _e4406;
                                phi_7264_ = _e4408;
                                phi_7265_ = _e4410;
                                phi_7266_ = _e4412;
                                phi_7267_ = _e4414;
                                phi_7268_ = _e3094;
                                phi_7269_ = _e4416;
                                phi_7270_ = _e4418;
                                phi_7271_ = false;
                            } else {
                                phi_7261_ = f32();
                                phi_7262_ = u32();
                                phi_7263_ = f32();
                                phi_7264_ = type_36();
                                phi_7265_ = u32();
                                phi_7266_ = u32();
                                phi_7267_ = false;
                                phi_7268_ = false;
                                phi_7269_ = false;
                                phi_7270_ = false;
                                phi_7271_ = true;
                            }
                            let _e4420 = phi_7261_;
                            let _e4422 = phi_7262_;
                            let _e4424 = phi_7263_;
                            let _e4426 = phi_7264_;
                            let _e4428 = phi_7265_;
                            let _e4430 = phi_7266_;
                            let _e4432 = phi_7267_;
                            let _e4434 = phi_7268_;
                            let _e4436 = phi_7269_;
                            let _e4438 = phi_7270_;
                            let _e4440 = phi_7271_;
                            phi_7272_ = _e3091;
                            phi_2347_ = _e4420;
                            phi_2349_ = _e4422;
                            phi_2351_ = _e4424;
                            phi_7273_ = _e4426;
                            phi_7274_ = _e4428;
                            phi_7275_ = _e3091;
                            phi_7276_ = _e4430;
                            phi_7277_ = _e4432;
                            phi_7278_ = _e4434;
                            phi_7279_ = _e4436;
                            phi_7280_ = _e4438;
                            phi_7281_ = false;
                            phi_7282_ = _e4440;
                        } else {
                            phi_7272_ = f32();
                            phi_2347_ = f32();
                            phi_2349_ = u32();
                            phi_2351_ = f32();
                            phi_7273_ = type_36();
                            phi_7274_ = u32();
                            phi_7275_ = f32();
                            phi_7276_ = u32();
                            phi_7277_ = false;
                            phi_7278_ = false;
                            phi_7279_ = false;
                            phi_7280_ = false;
                            phi_7281_ = true;
                            phi_7282_ = false;
                        }
                        let _e4442 = phi_7272_;
                        let _e4444 = phi_2347_;
                        let _e4446 = phi_2349_;
                        let _e4448 = phi_2351_;
                        let _e4450 = phi_7273_;
                        let _e4452 = phi_7274_;
                        let _e4454 = phi_7275_;
                        let _e4456 = phi_7276_;
                        let _e4458 = phi_7277_;
                        let _e4460 = phi_7278_;
                        let _e4462 = phi_7279_;
                        let _e4464 = phi_7280_;
                        let _e4466 = phi_7281_;
                        let _e4468 = phi_7282_;
                        local_41 = _e4460;
                        local_42 = _e4462;
                        local_43 = _e4460;
                        local_44 = _e4464;
                        local_45 = _e4460;
                        local_46 = _e4466;
                        local_47 = _e4460;
                        local_48 = _e4468;
                        local_49 = _e4450;
                        local_50 = _e4450;
                        local_51 = _e4452;
                        local_52 = _e4450;
                        local_62 = _e4460;
                        local_53 = _e4456;
                        local_55 = _e4454;
                        local_56 = _e4442;
                        continue;
                        continuing {
                            phi_2343_ = _e1466;
                            phi_2346_ = _e4444;
                            phi_2348_ = _e4446;
                            phi_2350_ = _e4448;
                            break if !(_e4458);
                        }
                    }
                    let _e4471 = local_41;
                    let _e4473 = local_42;
                    let _e4474 = select(_e4473, false, _e4471);
                    let _e4476 = local_43;
                    let _e4478 = local_44;
                    let _e4481 = local_45;
                    let _e4483 = local_46;
                    let _e4486 = local_47;
                    let _e4488 = local_48;
                    if _e4474 {
                        let _e4491 = local_49;
                        if (_e4491.member_1 >= _e383) {
                            phi_7311_ = type_35(type_34(0u, f32()), 0u);
                        } else {
                            let _e4495 = local_50;
                            let _e4499 = local_51;
                            let _e4502 = local_52;
                            phi_7311_ = type_35(type_34(2u, _e4502.member_1), select(_e4499, 0u, (_e4495.member_1 > _e381)));
                        }
                        let _e4509 = phi_7311_;
                        phi_7312_ = _e4509;
                        phi_7313_ = false;
                        phi_7314_ = false;
                        phi_7315_ = false;
                        phi_7316_ = false;
                    } else {
                        phi_7312_ = type_35();
                        phi_7313_ = select(_e4478, false, _e4476);
                        let _e5384 = local_62;
                        phi_7314_ = _e5384;
                        phi_7315_ = select(_e4483, false, _e4481);
                        phi_7316_ = select(_e4488, false, _e4486);
                    }
                    let _e4511 = phi_7312_;
                    let _e4513 = phi_7313_;
                    let _e4515 = phi_7314_;
                    let _e4517 = phi_7315_;
                    let _e4519 = phi_7316_;
                    let _e4521 = local_53;
                    let _e4523 = local_54;
                    let _e4526 = local_55;
                    let _e4528 = local_56;
                    let _e4530 = select(_e4515, true, _e4513);
                    let _e4535 = local_57;
                    let _e4536 = select(_e4535, select(_e4528, _e4526, _e4513), _e4530);
                    let _e4538 = local_58;
                    let _e4539 = select(_e4538, select(_e4523, _e4521, _e4513), _e4530);
                    if select(select(_e4517, false, _e4513), true, _e4530) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_7348_ = type_9(0u, 3u);
                        loop {
                            let _e4550 = phi_7348_;
                            let _e4553 = (_e4550.member < _e4550.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4553)) != 0i) {
                                let _e4568 = local[select(type_9().member_1, _e4550.member, _e4553)];
                                let _e4570 = (_e4536 + (select(0f, _e379, (_e379 >= (0.000000059604645f * 8f))) * _e4568));
                                let _e4572 = select(_e383, _e4570, (_e4570 < _e383));
                                let _e4575 = local_5.member[0u];
                                let _e4581 = local_5.member[1u];
                                let _e4597 = local_5.member_1[0u];
                                let _e4603 = local_5.member_1[1u];
                                let _e4619 = local_5.member_2[0u];
                                let _e4625 = local_5.member_2[1u];
                                let _e4639 = function_3(array<f32, 3>((_e4575[0] + ((_e4581[0] - _e4575[0]) * _e4572)), (_e4575[1] + ((_e4581[1] - _e4575[1]) * _e4572)), (_e4575[2] + ((_e4581[2] - _e4575[2]) * _e4572))), array<f32, 3>((_e4597[0] + ((_e4603[0] - _e4597[0]) * _e4572)), (_e4597[1] + ((_e4603[1] - _e4597[1]) * _e4572)), (_e4597[2] + ((_e4603[2] - _e4597[2]) * _e4572))), array<f32, 3>((_e4619[0] + ((_e4625[0] - _e4619[0]) * _e4572)), (_e4619[1] + ((_e4625[1] - _e4619[1]) * _e4572)), (_e4619[2] + ((_e4625[2] - _e4619[2]) * _e4572))), _e226.member);
                                let _e4650 = (((_e4639[0] * _e4639[0]) + (_e4639[1] * _e4639[1])) + (_e4639[2] * _e4639[2]));
                                if (_e4650 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_7580_ = select(0f, (0.000000000000000000106433627f * 2f), (_e4650 > 0f));
                                } else {
                                    phi_7523_ = type_14(0i, 5i);
                                    phi_7526_ = bitcast<f32>(((bitcast<u32>(_e4650) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e4658 = phi_7523_;
                                        let _e4660 = phi_7526_;
                                        local_59 = _e4660;
                                        if (_e4658.member < _e4658.member_1) {
                                            let _e4667 = (_e4658.member + 1i);
                                            phi_7524_ = type_14(select(_e4667, type_15().member_1, select(false, true, ((false == (_e4667 > _e4658.member)) != false))), _e4658.member_1);
                                            phi_7567_ = type_15(1u, _e4658.member);
                                        } else {
                                            phi_7524_ = _e4658;
                                            phi_7567_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e4678 = phi_7524_;
                                        let _e4680 = phi_7567_;
                                        let _e4683 = (bitcast<i32>(_e4680.member) != 0i);
                                        if _e4683 {
                                            phi_7527_ = (0.5f * (_e4660 + (_e4650 / _e4660)));
                                        } else {
                                            phi_7527_ = f32();
                                        }
                                        let _e4688 = phi_7527_;
                                        continue;
                                        continuing {
                                            phi_7523_ = _e4678;
                                            phi_7526_ = _e4688;
                                            break if !(_e4683);
                                        }
                                    }
                                    let _e4693 = local_59;
                                    phi_7580_ = (_e4693 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e4699 = phi_7580_;
                                let _e4705 = local_5.member[0u];
                                let _e4711 = select(_e4705[0], -(_e4705[0]), (_e4705[0] < 0f));
                                let _e4714 = select(_e4705[1], -(_e4705[1]), (_e4705[1] < 0f));
                                let _e4716 = select(_e4714, _e4711, (_e4711 > _e4714));
                                let _e4719 = select(_e4705[2], -(_e4705[2]), (_e4705[2] < 0f));
                                let _e4721 = select(_e4719, _e4716, (_e4716 > _e4719));
                                let _e4724 = local_5.member[1u];
                                let _e4730 = select(_e4724[0], -(_e4724[0]), (_e4724[0] < 0f));
                                let _e4733 = select(_e4724[1], -(_e4724[1]), (_e4724[1] < 0f));
                                let _e4735 = select(_e4733, _e4730, (_e4730 > _e4733));
                                let _e4738 = select(_e4724[2], -(_e4724[2]), (_e4724[2] < 0f));
                                let _e4740 = select(_e4738, _e4735, (_e4735 > _e4738));
                                let _e4744 = local_5.member_3;
                                let _e4748 = local_5.member_1[0u];
                                let _e4754 = select(_e4748[0], -(_e4748[0]), (_e4748[0] < 0f));
                                let _e4757 = select(_e4748[1], -(_e4748[1]), (_e4748[1] < 0f));
                                let _e4759 = select(_e4757, _e4754, (_e4754 > _e4757));
                                let _e4762 = select(_e4748[2], -(_e4748[2]), (_e4748[2] < 0f));
                                let _e4764 = select(_e4762, _e4759, (_e4759 > _e4762));
                                let _e4767 = local_5.member_1[1u];
                                let _e4773 = select(_e4767[0], -(_e4767[0]), (_e4767[0] < 0f));
                                let _e4776 = select(_e4767[1], -(_e4767[1]), (_e4767[1] < 0f));
                                let _e4778 = select(_e4776, _e4773, (_e4773 > _e4776));
                                let _e4781 = select(_e4767[2], -(_e4767[2]), (_e4767[2] < 0f));
                                let _e4783 = select(_e4781, _e4778, (_e4778 > _e4781));
                                let _e4787 = local_5.member_3;
                                let _e4791 = local_5.member_2[0u];
                                let _e4797 = select(_e4791[0], -(_e4791[0]), (_e4791[0] < 0f));
                                let _e4800 = select(_e4791[1], -(_e4791[1]), (_e4791[1] < 0f));
                                let _e4802 = select(_e4800, _e4797, (_e4797 > _e4800));
                                let _e4805 = select(_e4791[2], -(_e4791[2]), (_e4791[2] < 0f));
                                let _e4807 = select(_e4805, _e4802, (_e4802 > _e4805));
                                let _e4810 = local_5.member_2[1u];
                                let _e4816 = select(_e4810[0], -(_e4810[0]), (_e4810[0] < 0f));
                                let _e4819 = select(_e4810[1], -(_e4810[1]), (_e4810[1] < 0f));
                                let _e4821 = select(_e4819, _e4816, (_e4816 > _e4819));
                                let _e4824 = select(_e4810[2], -(_e4810[2]), (_e4810[2] < 0f));
                                let _e4826 = select(_e4824, _e4821, (_e4821 > _e4824));
                                let _e4830 = local_5.member_3;
                                let _e4837 = local_5.member_3;
                                let _e4844 = (((_e4699 * (1f + (0.000000059604645f * 8f))) + (((((((select(_e4740, _e4721, (_e4721 > _e4740)) + _e4744) + (select(_e4783, _e4764, (_e4764 > _e4783)) + _e4787)) + (select(_e4826, _e4807, (_e4807 > _e4826)) + _e4830)) * (0.000000059604645f * 16f)) + (_e4837 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e734.member_1);
                                phi_7851_ = select(true, false, _e4844);
                                phi_7852_ = _e4844;
                            } else {
                                phi_7851_ = false;
                                phi_7852_ = false;
                            }
                            let _e4847 = phi_7851_;
                            let _e4849 = phi_7852_;
                            local_60 = _e4849;
                            continue;
                            continuing {
                                phi_7348_ = type_9(select(_e4550.member, (_e4550.member + 1u), _e4553), select(_e4550.member_1, _e4550.member_1, _e4553));
                                break if !(_e4847);
                            }
                        }
                        let _e4852 = local_60;
                        if _e4852 {
                            phi_7864_ = type_35(type_34(1u, _e4536), select(_e4539, 1u, (_e4536 > _e381)));
                            phi_7865_ = false;
                        } else {
                            phi_7864_ = type_35();
                            phi_7865_ = true;
                        }
                        let _e4858 = phi_7864_;
                        let _e4860 = phi_7865_;
                        if _e4860 {
                            phi_7877_ = type_35(type_34(2u, _e4536), select(_e4539, 0u, (_e4536 > _e381)));
                        } else {
                            phi_7877_ = _e4858;
                        }
                        let _e4866 = phi_7877_;
                        phi_7878_ = _e4866;
                        phi_7879_ = false;
                        phi_7880_ = false;
                    } else {
                        phi_7878_ = type_35();
                        phi_7879_ = select(select(_e4519, false, _e4513), false, _e4530);
                        phi_7880_ = select(select(_e4474, false, _e4513), false, _e4530);
                    }
                    let _e4868 = phi_7878_;
                    let _e4870 = phi_7879_;
                    let _e4872 = phi_7880_;
                    if _e4870 {
                        phi_7887_ = type_35(type_34(0u, f32()), 0u);
                        phi_7888_ = true;
                    } else {
                        phi_7887_ = _e4511;
                        phi_7888_ = _e4872;
                    }
                    let _e4876 = phi_7887_;
                    let _e4878 = phi_7888_;
                    phi_7892_ = _e4876;
                    phi_7893_ = _e4868;
                    phi_7894_ = _e4878;
                } else {
                    phi_7892_ = _e1438;
                    phi_7893_ = type_35();
                    phi_7894_ = true;
                }
                let _e4880 = phi_7892_;
                let _e4882 = phi_7893_;
                let _e4884 = phi_7894_;
                if _e4884 {
                    phi_7898_ = _e4880;
                } else {
                    phi_7898_ = _e4882;
                }
                let _e4886 = phi_7898_;
                switch bitcast<i32>(_e4886.member.member) {
                    case 0: {
                        phi_7916_ = type_32(0u, _e4886.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4897 = function_(_e4886.member.member_1);
                        phi_7916_ = type_32(0u, _e4886.member_1, _e4897, true);
                        break;
                    }
                    case 2: {
                        let _e4893 = function_(_e4886.member.member_1);
                        phi_7916_ = type_32(1u, _e4886.member_1, _e4893, true);
                        break;
                    }
                    default: {
                        phi_7916_ = type_32();
                        break;
                    }
                }
                let _e4901 = phi_7916_;
                let _e4905 = params.member.member.member_12;
                let _e4906 = bitcast<u32>(_e4905);
                if (_e4901.member_2[0] == select((_e4906 << bitcast<u32>(29i)), 0u, ((_e4906 & 2147483647u) < 8388608u))) {
                    let _e4916 = params.member.member.member_12;
                    let _e4917 = bitcast<u32>(_e4916);
                    let _e4918 = (_e4917 & 2147483647u);
                    phi_7956_ = (_e4901.member_2[1] == select(((_e4917 ^ _e4918) | ((_e4918 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e4918 < 8388608u)));
                } else {
                    phi_7956_ = false;
                }
                let _e4928 = phi_7956_;
                let _e4930 = params.member.member.member_1;
                if ((_e4930 & 128u) != 0u) {
                    phi_7972_ = true;
                } else {
                    let _e4934 = params.member.member.member_1;
                    phi_7972_ = select(false, _e4928, ((_e4934 & 64u) != 0u));
                }
                let _e4939 = phi_7972_;
                local_6 = type_32(select(1u, _e4901.member, select(true, select(true, false, _e4939), _e4901.member_3)), _e4901.member_1, array<u32, 2>(_e4901.member_2[0], _e4901.member_2[1]), _e4901.member_3);
                phi_7999_ = type_9(_e184, _e187);
            } else {
                phi_7999_ = type_9(0u, 0u);
            }
            let _e4953 = phi_7999_;
            let _e4959 = local_6.member;
            let _e4961 = select(true, false, (_e4959 == 0u));
            let _e4963 = local_6.member_3;
            if _e4963 {
                if _e4961 {
                    phi_8028_ = true;
                } else {
                    let _e4965 = params.member.member.member_1;
                    phi_8028_ = ((_e4965 & 16u) != 0u);
                }
                let _e4969 = phi_8028_;
                phi_8029_ = _e4969;
            } else {
                phi_8029_ = false;
            }
            let _e4971 = phi_8029_;
            let _e4973 = local_6.member_3;
            if _e4973 {
                if _e4961 {
                } else {
                    let _e4975 = local_6.member_2;
                    let _e4980 = ((_e4975[1] >> bitcast<u32>(20i)) & 2047u);
                    let _e4994 = atomicMin((&earliest.member[0u]), select(((((_e4980 - 896u) << bitcast<u32>(23i)) | ((_e4975[1] & 1048575u) << bitcast<u32>(3i))) | (_e4975[0] >> bitcast<u32>(29i))), 0u, (_e4980 <= 896u)));
                }
            }
            if (_e103 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4971 {
                let _e4998 = atomicAdd((&counters[0u]), 1u);
                phi_8073_ = _e4998;
            } else {
                phi_8073_ = 0u;
            }
            let _e5000 = phi_8073_;
            workgroupBarrier();
            if (_e103 == 0u) {
                let _e5003 = atomicLoad((&counters[0u]));
                if (_e5003 > 0u) {
                    let _e5006 = atomicAdd((&contacts.member[0u]), _e5003);
                    atomicStore((&counters[1u]), _e5006);
                }
            }
            workgroupBarrier();
            let _e5009 = atomicLoad((&counters[1u]));
            let _e5010 = (_e5009 + _e5000);
            if _e4971 {
                let _e5012 = params.member.member_1.member_3;
                if (_e5010 < _e5012) {
                    let _e5018 = (7u * _e5010);
                    atomicStore((&contacts.member[(4u + _e5018)]), select(1u, 0u, ((_e4953.member_1 & 2147483648u) == 0u)));
                    let _e5023 = local_6.member;
                    atomicStore((&contacts.member[(_e5018 + 5u)]), _e5023);
                    atomicStore((&contacts.member[(_e5018 + 6u)]), _e4953.member);
                    atomicStore((&contacts.member[(_e5018 + 7u)]), (_e4953.member_1 & 2147483647u));
                    let _e5032 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e5018 + 8u)]), _e5032);
                    let _e5037 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e5018 + 9u)]), _e5037);
                    let _e5041 = local_6.member_1;
                    atomicStore((&contacts.member[(_e5018 + 10u)]), _e5041);
                }
            }
        }
        continue;
        continuing {
            phi_285_ = type_9(select(_e155.member, (_e155.member + 1u), _e158), select(_e155.member_1, _e155.member_1, _e158));
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
