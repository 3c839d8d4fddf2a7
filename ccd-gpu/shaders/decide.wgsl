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

struct type_16 {
    member: f32,
    member_1: f32,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
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
    member: type_29,
    member_1: f32,
}

struct type_33 {
    member: u32,
    member_1: f32,
}

struct type_36 {
    member: array<f32, 4>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> earliest: type_42;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2])));
    return array<f32, 3>(select(param[0], param_1[0], _e24), select(param[1], param_1[1], _e24), select(param[2], param_1[2], _e24));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_675_: array<array<f32, 3>, 4>;

    let _e9 = (param_2[0] - param_3[0]);
    let _e12 = (param_2[1] - param_3[1]);
    let _e15 = (param_2[2] - param_3[2]);
    if (param_5 != 0u) {
        let _e151 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        let _e155 = select(0f, select(1f, _e151, (_e151 < 1f)), (_e151 > 0f));
        let _e191 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e195 = select(0f, select(1f, _e191, (_e191 < 1f)), (_e191 > 0f));
        let _e228 = ((((_e9 * param_4[0]) + (_e12 * param_4[1])) + (_e15 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e232 = select(0f, select(1f, _e228, (_e228 < 1f)), (_e228 > 0f));
        let _e245 = (param_2[0] - param_4[0]);
        let _e248 = (param_2[1] - param_4[1]);
        let _e251 = (param_2[2] - param_4[2]);
        let _e271 = ((((_e245 * param_3[0]) + (_e248 * param_3[1])) + (_e251 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        let _e275 = select(0f, select(1f, _e271, (_e271 < 1f)), (_e271 > 0f));
        phi_675_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
    } else {
        let _e19 = (param_4[0] - param_3[0]);
        let _e22 = (param_4[1] - param_3[1]);
        let _e25 = (param_4[2] - param_3[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e40 = select(0f, select(1f, _e36, (_e36 < 1f)), (_e36 > 0f));
        let _e47 = array<f32, 3>((_e9 - (_e19 * _e40)), (_e12 - (_e22 * _e40)), (_e15 - (_e25 * _e40)));
        let _e70 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        let _e74 = select(0f, select(1f, _e70, (_e70 < 1f)), (_e70 > 0f));
        let _e110 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e114 = select(0f, select(1f, _e110, (_e110 < 1f)), (_e110 > 0f));
        phi_675_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_675_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_303_: bool;
    var phi_336_: array<f32, 3>;
    var phi_337_: bool;
    var phi_338_: array<f32, 3>;
    var phi_339_: bool;
    var phi_344_: array<f32, 3>;

    let _e23 = (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2]));
    let _e34 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e45 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e56 = (((param_6[0] * param_7[0]) + (param_6[1] * param_7[1])) + (param_6[2] * param_7[2]));
    let _e67 = (((param_6[0] * param_8[0]) + (param_6[1] * param_8[1])) + (param_6[2] * param_8[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_9 != 0u) {
        let _e89 = (_e74 >= 0f);
        let _e90 = (_e78 >= 0f);
        let _e91 = (_e74 <= 1f);
        phi_303_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_303_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_303_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_336_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_337_ = false;
        } else {
            phi_336_ = array<f32, 3>();
            phi_337_ = true;
        }
        let _e129 = phi_336_;
        let _e131 = phi_337_;
        phi_338_ = _e129;
        phi_339_ = _e131;
    } else {
        phi_338_ = array<f32, 3>();
        phi_339_ = true;
    }
    let _e133 = phi_338_;
    let _e135 = phi_339_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_344_ = _e136;
    } else {
        phi_344_ = _e133;
    }
    let _e138 = phi_344_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_36>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7298_: bool;

    let _e14 = (*param_11).member_3;
    let _e16 = (*param_11).member_3;
    let _e18 = (param_12 + (_e14 + _e16));
    if (_e18 < param_14) {
        let _e20 = (1f - param_13);
        let _e23 = (*param_11).member[0u];
        let _e26 = (*param_11).member[1u];
        let _e29 = (*param_11).member[2u];
        let _e32 = (*param_11).member[3u];
        let _e43 = ((((_e23 * _e20) + (_e26 * param_13)) * (_e20 * _e20)) + (((_e29 * _e20) + (_e32 * param_13)) * (param_13 * param_13)));
        let _e45 = select(param_13, _e18, (_e18 > param_13));
        let _e46 = (1f - _e45);
        let _e49 = (*param_11).member[0u];
        let _e52 = (*param_11).member[1u];
        let _e55 = (*param_11).member[2u];
        let _e58 = (*param_11).member[3u];
        let _e69 = ((((_e49 * _e46) + (_e52 * _e45)) * (_e46 * _e46)) + (((_e55 * _e46) + (_e58 * _e45)) * (_e45 * _e45)));
        let _e71 = (*param_11).member_1;
        let _e73 = (*param_11).member_1;
        let _e79 = (*param_11).member_1;
        if (select(_e43, -(_e43), (_e43 < 0f)) > _e79) {
            let _e84 = (select(_e69, -(_e69), (_e69 < 0f)) > (_e71 + _e73));
            phi_7292_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7293_ = select(true, false, _e84);
        } else {
            phi_7292_ = bool();
            phi_7293_ = true;
        }
        let _e91 = phi_7292_;
        let _e93 = phi_7293_;
        phi_7298_ = select(_e91, false, _e93);
    } else {
        phi_7298_ = false;
    }
    let _e96 = phi_7298_;
    return _e96;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: array<type_16, 4>;
    var local_3: array<f32, 4>;
    var local_4: array<f32, 2>;
    var local_5: type_36;
    var local_6: array<f32, 4>;
    var local_7: type_29;
    var local_8: type_31;
    var phi_785_: u32;
    var phi_830_: u32;
    var phi_833_: type_9;
    var phi_1007_: type_23;
    var phi_1142_: type_29;
    var phi_1633_: bool;
    var phi_1727_: type_32;
    var phi_1728_: bool;
    var phi_1729_: type_32;
    var phi_1730_: bool;
    var phi_1731_: type_32;
    var phi_1732_: bool;
    var phi_1737_: type_32;
    var phi_2429_: bool;
    var phi_2441_: f32;
    var phi_2512_: type_14;
    var phi_2515_: f32;
    var phi_2513_: type_14;
    var phi_2556_: type_15;
    var phi_2516_: f32;
    var local_9: f32;
    var phi_2569_: f32;
    var phi_2600_: type_9;
    var phi_2603_: u32;
    var phi_2670_: u32;
    var phi_2671_: u32;
    var phi_2604_: u32;
    var phi_2672_: u32;
    var phi_2728_: type_9;
    var phi_2884_: type_38;
    var phi_2885_: bool;
    var phi_2886_: type_38;
    var phi_2887_: bool;
    var phi_2918_: type_9;
    var phi_2921_: f32;
    var phi_2923_: f32;
    var phi_2925_: f32;
    var phi_3035_: bool;
    var phi_3042_: f32;
    var phi_3043_: bool;
    var phi_2922_: f32;
    var phi_2924_: f32;
    var phi_2926_: f32;
    var phi_3044_: f32;
    var phi_3045_: bool;
    var phi_3046_: bool;
    var local_10: bool;
    var local_11: f32;
    var local_12: f32;
    var phi_3051_: f32;
    var phi_3067_: type_9;
    var phi_3070_: f32;
    var phi_3135_: f32;
    var phi_3136_: bool;
    var phi_3137_: bool;
    var phi_3138_: bool;
    var phi_3139_: f32;
    var phi_3071_: f32;
    var phi_3140_: bool;
    var phi_3141_: bool;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f32;
    var phi_3157_: f32;
    var phi_3159_: type_38;
    var phi_3996_: array<type_16, 4>;
    var phi_4016_: type_9;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4071_: bool;
    var phi_4072_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_4086_: u32;
    var phi_4087_: u32;
    var phi_4088_: bool;
    var phi_4119_: bool;
    var phi_4120_: bool;
    var phi_4121_: bool;
    var phi_4122_: bool;
    var phi_4123_: bool;
    var phi_4124_: bool;
    var phi_4125_: bool;
    var phi_4126_: bool;
    var phi_4127_: bool;
    var phi_4128_: bool;
    var phi_4129_: bool;
    var phi_4130_: bool;
    var phi_4131_: type_38;
    var phi_4132_: bool;
    var phi_4133_: type_38;
    var phi_4134_: bool;
    var phi_4135_: bool;
    var phi_4136_: bool;
    var phi_4137_: bool;
    var phi_4138_: type_38;
    var phi_4139_: bool;
    var phi_4140_: type_38;
    var phi_4141_: bool;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var phi_4153_: type_38;
    var phi_4154_: bool;
    var phi_4155_: type_38;
    var phi_4156_: bool;
    var phi_4157_: bool;
    var phi_4158_: bool;
    var phi_4159_: bool;
    var phi_4160_: bool;
    var phi_4583_: type_9;
    var phi_4586_: f32;
    var phi_4588_: f32;
    var phi_4590_: f32;
    var phi_4592_: f32;
    var phi_4594_: bool;
    var phi_4596_: u32;
    var phi_4747_: array<f32, 3>;
    var phi_4813_: type_14;
    var phi_4816_: f32;
    var phi_4814_: type_14;
    var phi_4857_: type_15;
    var phi_4817_: f32;
    var local_20: f32;
    var phi_4870_: f32;
    var phi_4993_: type_30;
    var phi_4994_: bool;
    var phi_4995_: type_30;
    var phi_4996_: bool;
    var phi_5004_: type_30;
    var phi_5175_: bool;
    var phi_5176_: bool;
    var phi_5177_: bool;
    var phi_5178_: bool;
    var phi_5179_: bool;
    var phi_5180_: bool;
    var phi_5481_: bool;
    var phi_5482_: bool;
    var phi_5483_: bool;
    var phi_5484_: bool;
    var phi_5485_: bool;
    var phi_5486_: bool;
    var phi_5494_: bool;
    var phi_5601_: f32;
    var phi_5602_: bool;
    var phi_5603_: f32;
    var phi_5604_: bool;
    var phi_5605_: f32;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5669_: f32;
    var phi_5670_: bool;
    var phi_5671_: f32;
    var phi_5672_: bool;
    var phi_5673_: f32;
    var phi_5674_: bool;
    var phi_5675_: bool;
    var phi_5742_: f32;
    var phi_5743_: bool;
    var phi_5744_: f32;
    var phi_5745_: bool;
    var phi_5746_: f32;
    var phi_5747_: bool;
    var phi_5748_: bool;
    var phi_5810_: f32;
    var phi_5811_: bool;
    var phi_5812_: f32;
    var phi_5813_: bool;
    var phi_5814_: f32;
    var phi_5815_: bool;
    var phi_5816_: bool;
    var phi_6345_: f32;
    var phi_6346_: f32;
    var phi_6347_: bool;
    var phi_6349_: f32;
    var phi_6350_: f32;
    var phi_6351_: f32;
    var phi_6353_: bool;
    var phi_6354_: bool;
    var phi_6356_: bool;
    var phi_6357_: f32;
    var phi_6358_: f32;
    var phi_6359_: f32;
    var phi_6361_: bool;
    var phi_6362_: bool;
    var phi_6363_: bool;
    var phi_6365_: bool;
    var phi_6366_: f32;
    var phi_6367_: f32;
    var phi_6368_: f32;
    var phi_6370_: bool;
    var phi_6371_: bool;
    var phi_6372_: bool;
    var phi_6374_: bool;
    var phi_6707_: f32;
    var phi_6709_: u32;
    var phi_6710_: f32;
    var phi_6711_: bool;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var phi_6714_: u32;
    var phi_6715_: f32;
    var phi_6716_: f32;
    var phi_6717_: f32;
    var phi_6718_: f32;
    var phi_6719_: bool;
    var phi_6720_: u32;
    var phi_6721_: bool;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var phi_6726_: bool;
    var phi_6754_: f32;
    var phi_6755_: f32;
    var phi_6756_: f32;
    var phi_6757_: f32;
    var phi_6758_: bool;
    var phi_6759_: u32;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var phi_6763_: bool;
    var phi_6765_: bool;
    var phi_4587_: f32;
    var phi_4589_: f32;
    var phi_4591_: f32;
    var phi_4593_: f32;
    var phi_4595_: bool;
    var phi_4597_: u32;
    var phi_6766_: f32;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6773_: bool;
    var phi_6774_: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: bool;
    var local_29: f32;
    var local_30: bool;
    var local_31: f32;
    var local_32: f32;
    var phi_6842_: f32;
    var phi_6843_: bool;
    var phi_6844_: bool;
    var phi_6845_: bool;
    var phi_6846_: bool;
    var phi_6847_: bool;
    var phi_6848_: type_38;
    var phi_6849_: bool;
    var phi_6850_: f32;
    var phi_6851_: type_38;
    var phi_6852_: bool;
    var phi_6853_: bool;
    var phi_6854_: bool;
    var phi_6855_: bool;
    var phi_6856_: bool;
    var phi_6857_: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: type_38;
    var local_36: f32;
    var local_37: f32;
    var phi_6873_: type_33;
    var phi_6874_: bool;
    var local_38: f32;
    var phi_6880_: type_33;
    var phi_6881_: bool;
    var phi_6882_: bool;
    var phi_6883_: bool;
    var phi_6884_: bool;
    var local_39: bool;
    var local_40: type_38;
    var phi_6926_: type_33;
    var phi_6927_: type_33;
    var phi_6928_: bool;
    var phi_6972_: type_31;
    var phi_7012_: bool;
    var phi_7028_: bool;
    var phi_7055_: type_9;
    var phi_7084_: bool;
    var phi_7085_: bool;
    var phi_7128_: u32;
    var local_41: u32;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e112 = ((_e99.y * _e100.x) + _e99.x);
    let _e115 = (_e100.x * _e100.y);
    let _e118 = params.member.member_1.member_2;
    let _e120 = input.member[0u];
    let _e122 = select(_e120, _e118, (_e118 < _e120));
    let _e124 = params.member.member_1.member_1;
    if (_e122 > _e124) {
        let _e127 = params.member.member_1.member_1;
        phi_785_ = (_e122 - _e127);
    } else {
        phi_785_ = 0u;
    }
    let _e130 = phi_785_;
    let _e132 = params.member.member_1.member;
    let _e134 = select(_e130, _e132, (_e132 < _e130));
    let _e135 = (_e134 / 64u);
    let _e139 = select(_e135, (_e135 + 1u), ((_e134 % 64u) > 0u));
    if (_e139 > _e112) {
        let _e141 = (_e139 - _e112);
        if (_e115 == 0u) {
            return;
        }
        let _e143 = (_e141 / _e115);
        if (_e115 == 0u) {
            return;
        }
        phi_830_ = select(_e143, (_e143 + 1u), ((_e141 % _e115) > 0u));
    } else {
        phi_830_ = 0u;
    }
    let _e150 = phi_830_;
    phi_833_ = type_9(0u, _e150);
    loop {
        let _e153 = phi_833_;
        let _e156 = (_e153.member < _e153.member_1);
        let _e169 = (bitcast<i32>(select(0u, 1u, _e156)) != 0i);
        if _e169 {
            let _e173 = (((_e112 + (select(type_9().member_1, _e153.member, _e156) * _e115)) * 64u) + _e101);
            local_8 = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e173 < _e134) {
                let _e177 = params.member.member_1.member_1;
                let _e179 = (2u * (_e177 + _e173));
                let _e182 = input.member[(4u + _e179)];
                let _e185 = input.member[(_e179 + 5u)];
                let _e190 = (_e185 & 2147483647u);
                if (select(1u, 0u, ((_e185 & 2147483648u) == 0u)) == 0u) {
                    let _e209 = params.member.member.member[1u];
                    let _e212 = ((2u * _e209) + (3u * _e190));
                    let _e214 = elements.member[_e212];
                    let _e217 = elements.member[(_e212 + 1u)];
                    let _e220 = elements.member[(_e212 + 2u)];
                    phi_1007_ = type_23(0u, array<u32, 4>(_e182, _e214, _e217, _e220));
                } else {
                    let _e193 = (2u * _e182);
                    let _e195 = elements.member[_e193];
                    let _e198 = elements.member[(_e193 + 1u)];
                    let _e199 = (2u * _e190);
                    let _e201 = elements.member[_e199];
                    let _e204 = elements.member[(_e199 + 1u)];
                    phi_1007_ = type_23(1u, array<u32, 4>(_e195, _e198, _e201, _e204));
                }
                let _e224 = phi_1007_;
                let _e229 = paths.member[_e224.member_1[0]];
                let _e244 = paths.member[_e224.member_1[1]];
                let _e259 = paths.member[_e224.member_1[2]];
                let _e274 = paths.member[_e224.member_1[3]];
                let _e288 = params.member.member.member_4;
                if (_e224.member != 0u) {
                    phi_1142_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e229.member.x), (_e259.member.y - _e229.member.y), (_e259.member.z - _e229.member.z)), array<f32, 3>((_e259.member_1.x - _e229.member_1.x), (_e259.member_1.y - _e229.member_1.y), (_e259.member_1.z - _e229.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e244.member.x - _e229.member.x), (_e244.member.y - _e229.member.y), (_e244.member.z - _e229.member.z)), array<f32, 3>((_e244.member_1.x - _e229.member_1.x), (_e244.member_1.y - _e229.member_1.y), (_e244.member_1.z - _e229.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e274.member.x), (_e259.member.y - _e274.member.y), (_e259.member.z - _e274.member.z)), array<f32, 3>((_e259.member_1.x - _e274.member_1.x), (_e259.member_1.y - _e274.member_1.y), (_e259.member_1.z - _e274.member_1.z))), (_e288 + _e288));
                } else {
                    phi_1142_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e229.member.x - _e244.member.x), (_e229.member.y - _e244.member.y), (_e229.member.z - _e244.member.z)), array<f32, 3>((_e229.member_1.x - _e244.member_1.x), (_e229.member_1.y - _e244.member_1.y), (_e229.member_1.z - _e244.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e259.member.x - _e244.member.x), (_e259.member.y - _e244.member.y), (_e259.member.z - _e244.member.z)), array<f32, 3>((_e259.member_1.x - _e244.member_1.x), (_e259.member_1.y - _e244.member_1.y), (_e259.member_1.z - _e244.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e274.member.x - _e244.member.x), (_e274.member.y - _e244.member.y), (_e274.member.z - _e244.member.z)), array<f32, 3>((_e274.member_1.x - _e244.member_1.x), (_e274.member_1.y - _e244.member_1.y), (_e274.member_1.z - _e244.member_1.z))), (_e288 + _e288));
                }
                let _e349 = phi_1142_;
                let _e351 = params.member.member.member_11;
                let _e353 = params.member.member.member_12;
                let _e355 = params.member.member.member_13;
                let _e357 = params.member.member.member_13;
                let _e363 = select(_e349.member[0][0], -(_e349.member[0][0]), (_e349.member[0][0] < 0f));
                let _e367 = select(_e349.member[0][1], -(_e349.member[0][1]), (_e349.member[0][1] < 0f));
                let _e369 = select(_e367, _e363, (_e363 > _e367));
                let _e373 = select(_e349.member[0][2], -(_e349.member[0][2]), (_e349.member[0][2] < 0f));
                let _e375 = select(_e373, _e369, (_e369 > _e373));
                let _e381 = select(_e349.member[1][0], -(_e349.member[1][0]), (_e349.member[1][0] < 0f));
                let _e385 = select(_e349.member[1][1], -(_e349.member[1][1]), (_e349.member[1][1] < 0f));
                let _e387 = select(_e385, _e381, (_e381 > _e385));
                let _e391 = select(_e349.member[1][2], -(_e349.member[1][2]), (_e349.member[1][2] < 0f));
                let _e393 = select(_e391, _e387, (_e387 > _e391));
                let _e397 = (select(_e393, _e375, (_e375 > _e393)) + _e349.member_3);
                let _e403 = select(_e349.member_1[0][0], -(_e349.member_1[0][0]), (_e349.member_1[0][0] < 0f));
                let _e407 = select(_e349.member_1[0][1], -(_e349.member_1[0][1]), (_e349.member_1[0][1] < 0f));
                let _e409 = select(_e407, _e403, (_e403 > _e407));
                let _e413 = select(_e349.member_1[0][2], -(_e349.member_1[0][2]), (_e349.member_1[0][2] < 0f));
                let _e415 = select(_e413, _e409, (_e409 > _e413));
                let _e421 = select(_e349.member_1[1][0], -(_e349.member_1[1][0]), (_e349.member_1[1][0] < 0f));
                let _e425 = select(_e349.member_1[1][1], -(_e349.member_1[1][1]), (_e349.member_1[1][1] < 0f));
                let _e427 = select(_e425, _e421, (_e421 > _e425));
                let _e431 = select(_e349.member_1[1][2], -(_e349.member_1[1][2]), (_e349.member_1[1][2] < 0f));
                let _e433 = select(_e431, _e427, (_e427 > _e431));
                let _e437 = (select(_e433, _e415, (_e415 > _e433)) + _e349.member_3);
                let _e443 = select(_e349.member_2[0][0], -(_e349.member_2[0][0]), (_e349.member_2[0][0] < 0f));
                let _e447 = select(_e349.member_2[0][1], -(_e349.member_2[0][1]), (_e349.member_2[0][1] < 0f));
                let _e449 = select(_e447, _e443, (_e443 > _e447));
                let _e453 = select(_e349.member_2[0][2], -(_e349.member_2[0][2]), (_e349.member_2[0][2] < 0f));
                let _e455 = select(_e453, _e449, (_e449 > _e453));
                let _e461 = select(_e349.member_2[1][0], -(_e349.member_2[1][0]), (_e349.member_2[1][0] < 0f));
                let _e465 = select(_e349.member_2[1][1], -(_e349.member_2[1][1]), (_e349.member_2[1][1] < 0f));
                let _e467 = select(_e465, _e461, (_e461 > _e465));
                let _e471 = select(_e349.member_2[1][2], -(_e349.member_2[1][2]), (_e349.member_2[1][2] < 0f));
                let _e473 = select(_e471, _e467, (_e467 > _e471));
                let _e477 = (select(_e473, _e455, (_e455 > _e473)) + _e349.member_3);
                let _e479 = select(_e437, _e397, (_e397 > _e437));
                let _e481 = select(_e477, _e479, (_e479 > _e477));
                let _e487 = select(_e349.member[0][0], -(_e349.member[0][0]), (_e349.member[0][0] < 0f));
                let _e491 = select(_e349.member[0][1], -(_e349.member[0][1]), (_e349.member[0][1] < 0f));
                let _e493 = select(_e491, _e487, (_e487 > _e491));
                let _e497 = select(_e349.member[0][2], -(_e349.member[0][2]), (_e349.member[0][2] < 0f));
                let _e499 = select(_e497, _e493, (_e493 > _e497));
                let _e505 = select(_e349.member[1][0], -(_e349.member[1][0]), (_e349.member[1][0] < 0f));
                let _e509 = select(_e349.member[1][1], -(_e349.member[1][1]), (_e349.member[1][1] < 0f));
                let _e511 = select(_e509, _e505, (_e505 > _e509));
                let _e515 = select(_e349.member[1][2], -(_e349.member[1][2]), (_e349.member[1][2] < 0f));
                let _e517 = select(_e515, _e511, (_e511 > _e515));
                let _e521 = (select(_e517, _e499, (_e499 > _e517)) + _e349.member_3);
                let _e527 = select(_e349.member_1[0][0], -(_e349.member_1[0][0]), (_e349.member_1[0][0] < 0f));
                let _e531 = select(_e349.member_1[0][1], -(_e349.member_1[0][1]), (_e349.member_1[0][1] < 0f));
                let _e533 = select(_e531, _e527, (_e527 > _e531));
                let _e537 = select(_e349.member_1[0][2], -(_e349.member_1[0][2]), (_e349.member_1[0][2] < 0f));
                let _e539 = select(_e537, _e533, (_e533 > _e537));
                let _e545 = select(_e349.member_1[1][0], -(_e349.member_1[1][0]), (_e349.member_1[1][0] < 0f));
                let _e549 = select(_e349.member_1[1][1], -(_e349.member_1[1][1]), (_e349.member_1[1][1] < 0f));
                let _e551 = select(_e549, _e545, (_e545 > _e549));
                let _e555 = select(_e349.member_1[1][2], -(_e349.member_1[1][2]), (_e349.member_1[1][2] < 0f));
                let _e557 = select(_e555, _e551, (_e551 > _e555));
                let _e561 = (select(_e557, _e539, (_e539 > _e557)) + _e349.member_3);
                let _e567 = select(_e349.member_2[0][0], -(_e349.member_2[0][0]), (_e349.member_2[0][0] < 0f));
                let _e571 = select(_e349.member_2[0][1], -(_e349.member_2[0][1]), (_e349.member_2[0][1] < 0f));
                let _e573 = select(_e571, _e567, (_e567 > _e571));
                let _e577 = select(_e349.member_2[0][2], -(_e349.member_2[0][2]), (_e349.member_2[0][2] < 0f));
                let _e579 = select(_e577, _e573, (_e573 > _e577));
                let _e585 = select(_e349.member_2[1][0], -(_e349.member_2[1][0]), (_e349.member_2[1][0] < 0f));
                let _e589 = select(_e349.member_2[1][1], -(_e349.member_2[1][1]), (_e349.member_2[1][1] < 0f));
                let _e591 = select(_e589, _e585, (_e585 > _e589));
                let _e595 = select(_e349.member_2[1][2], -(_e349.member_2[1][2]), (_e349.member_2[1][2] < 0f));
                let _e597 = select(_e595, _e591, (_e591 > _e595));
                let _e601 = (select(_e597, _e579, (_e579 > _e597)) + _e349.member_3);
                let _e603 = select(_e561, _e521, (_e521 > _e561));
                let _e605 = select(_e601, _e603, (_e603 > _e601));
                if (_e605 <= 65536f) {
                    phi_1633_ = (_e605 >= (1f / 65536f));
                } else {
                    phi_1633_ = false;
                }
                let _e610 = phi_1633_;
                if _e610 {
                    phi_1731_ = type_32();
                    phi_1732_ = true;
                } else {
                    if (_e481 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e481) & 2139095040u) != 2139095040u) {
                            let _e617 = (2130706432u - (bitcast<u32>(_e481) & 2139095040u));
                            let _e620 = bitcast<f32>(select(8388608u, _e617, (_e617 > 8388608u)));
                            phi_1727_ = type_32(type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e349.member[0][0] * _e620), (_e349.member[0][1] * _e620), (_e349.member[0][2] * _e620)), array<f32, 3>((_e349.member[1][0] * _e620), (_e349.member[1][1] * _e620), (_e349.member[1][2] * _e620))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_1[0][0] * _e620), (_e349.member_1[0][1] * _e620), (_e349.member_1[0][2] * _e620)), array<f32, 3>((_e349.member_1[1][0] * _e620), (_e349.member_1[1][1] * _e620), (_e349.member_1[1][2] * _e620))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_2[0][0] * _e620), (_e349.member_2[0][1] * _e620), (_e349.member_2[0][2] * _e620)), array<f32, 3>((_e349.member_2[1][0] * _e620), (_e349.member_2[1][1] * _e620), (_e349.member_2[1][2] * _e620))), ((_e349.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e620)), (0f * _e620));
                            phi_1728_ = false;
                        } else {
                            phi_1727_ = type_32();
                            phi_1728_ = true;
                        }
                        let _e686 = phi_1727_;
                        let _e688 = phi_1728_;
                        phi_1729_ = _e686;
                        phi_1730_ = _e688;
                    } else {
                        phi_1729_ = type_32();
                        phi_1730_ = true;
                    }
                    let _e690 = phi_1729_;
                    let _e692 = phi_1730_;
                    phi_1731_ = _e690;
                    phi_1732_ = _e692;
                }
                let _e694 = phi_1731_;
                let _e696 = phi_1732_;
                if _e696 {
                    phi_1737_ = type_32(_e349, 0f);
                } else {
                    phi_1737_ = _e694;
                }
                let _e699 = phi_1737_;
                local_7 = type_29(array<array<f32, 3>, 2>(array<f32, 3>(_e699.member.member[0][0], _e699.member.member[0][1], _e699.member.member[0][2]), array<f32, 3>(_e699.member.member[1][0], _e699.member.member[1][1], _e699.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e699.member.member_1[0][0], _e699.member.member_1[0][1], _e699.member.member_1[0][2]), array<f32, 3>(_e699.member.member_1[1][0], _e699.member.member_1[1][1], _e699.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e699.member.member_2[0][0], _e699.member.member_2[0][1], _e699.member.member_2[0][2]), array<f32, 3>(_e699.member.member_2[1][0], _e699.member.member_2[1][1], _e699.member.member_2[1][2])), _e699.member.member_3);
                let _e741 = local_7.member_1[0u];
                let _e747 = local_7.member_2[0u];
                let _e753 = ((_e741[1] * _e747[2]) - (_e741[2] * _e747[1]));
                let _e756 = ((_e741[2] * _e747[0]) - (_e741[0] * _e747[2]));
                let _e759 = ((_e741[0] * _e747[1]) - (_e741[1] * _e747[0]));
                let _e762 = local_7.member_1[1u];
                let _e768 = local_7.member_2[1u];
                let _e774 = ((_e762[1] * _e768[2]) - (_e762[2] * _e768[1]));
                let _e777 = ((_e762[2] * _e768[0]) - (_e762[0] * _e768[2]));
                let _e780 = ((_e762[0] * _e768[1]) - (_e762[1] * _e768[0]));
                let _e783 = local_7.member_1[0u];
                let _e789 = local_7.member_2[1u];
                let _e804 = local_7.member_1[1u];
                let _e810 = local_7.member_2[0u];
                let _e823 = (((_e783[1] * _e789[2]) - (_e783[2] * _e789[1])) + ((_e804[1] * _e810[2]) - (_e804[2] * _e810[1])));
                let _e824 = (((_e783[2] * _e789[0]) - (_e783[0] * _e789[2])) + ((_e804[2] * _e810[0]) - (_e804[0] * _e810[2])));
                let _e825 = (((_e783[0] * _e789[1]) - (_e783[1] * _e789[0])) + ((_e804[0] * _e810[1]) - (_e804[1] * _e810[0])));
                let _e828 = local_7.member[0u];
                let _e836 = (((_e828[0] * _e753) + (_e828[1] * _e756)) + (_e828[2] * _e759));
                let _e839 = local_7.member[1u];
                let _e850 = local_7.member[0u];
                let _e859 = ((((_e839[0] * _e753) + (_e839[1] * _e756)) + (_e839[2] * _e759)) + (((_e850[0] * _e823) + (_e850[1] * _e824)) + (_e850[2] * _e825)));
                let _e862 = local_7.member[0u];
                let _e873 = local_7.member[1u];
                let _e882 = ((((_e862[0] * _e774) + (_e862[1] * _e777)) + (_e862[2] * _e780)) + (((_e873[0] * _e823) + (_e873[1] * _e824)) + (_e873[2] * _e825)));
                let _e885 = local_7.member[1u];
                let _e893 = (((_e885[0] * _e774) + (_e885[1] * _e777)) + (_e885[2] * _e780));
                let _e896 = local_7.member[0u];
                let _e902 = select(_e896[0], -(_e896[0]), (_e896[0] < 0f));
                let _e905 = select(_e896[1], -(_e896[1]), (_e896[1] < 0f));
                let _e907 = select(_e905, _e902, (_e902 > _e905));
                let _e910 = select(_e896[2], -(_e896[2]), (_e896[2] < 0f));
                let _e912 = select(_e910, _e907, (_e907 > _e910));
                let _e915 = local_7.member[1u];
                let _e921 = select(_e915[0], -(_e915[0]), (_e915[0] < 0f));
                let _e924 = select(_e915[1], -(_e915[1]), (_e915[1] < 0f));
                let _e926 = select(_e924, _e921, (_e921 > _e924));
                let _e929 = select(_e915[2], -(_e915[2]), (_e915[2] < 0f));
                let _e931 = select(_e929, _e926, (_e926 > _e929));
                let _e935 = local_7.member_3;
                let _e936 = (select(_e931, _e912, (_e912 > _e931)) + _e935);
                let _e939 = local_7.member_1[0u];
                let _e945 = select(_e939[0], -(_e939[0]), (_e939[0] < 0f));
                let _e948 = select(_e939[1], -(_e939[1]), (_e939[1] < 0f));
                let _e950 = select(_e948, _e945, (_e945 > _e948));
                let _e953 = select(_e939[2], -(_e939[2]), (_e939[2] < 0f));
                let _e955 = select(_e953, _e950, (_e950 > _e953));
                let _e958 = local_7.member_1[1u];
                let _e964 = select(_e958[0], -(_e958[0]), (_e958[0] < 0f));
                let _e967 = select(_e958[1], -(_e958[1]), (_e958[1] < 0f));
                let _e969 = select(_e967, _e964, (_e964 > _e967));
                let _e972 = select(_e958[2], -(_e958[2]), (_e958[2] < 0f));
                let _e974 = select(_e972, _e969, (_e969 > _e972));
                let _e978 = local_7.member_3;
                let _e979 = (select(_e974, _e955, (_e955 > _e974)) + _e978);
                let _e982 = local_7.member_2[0u];
                let _e988 = select(_e982[0], -(_e982[0]), (_e982[0] < 0f));
                let _e991 = select(_e982[1], -(_e982[1]), (_e982[1] < 0f));
                let _e993 = select(_e991, _e988, (_e988 > _e991));
                let _e996 = select(_e982[2], -(_e982[2]), (_e982[2] < 0f));
                let _e998 = select(_e996, _e993, (_e993 > _e996));
                let _e1001 = local_7.member_2[1u];
                let _e1007 = select(_e1001[0], -(_e1001[0]), (_e1001[0] < 0f));
                let _e1010 = select(_e1001[1], -(_e1001[1]), (_e1001[1] < 0f));
                let _e1012 = select(_e1010, _e1007, (_e1007 > _e1010));
                let _e1015 = select(_e1001[2], -(_e1001[2]), (_e1001[2] < 0f));
                let _e1017 = select(_e1015, _e1012, (_e1012 > _e1015));
                let _e1021 = local_7.member_3;
                let _e1022 = (select(_e1017, _e998, (_e998 > _e1017)) + _e1021);
                let _e1031 = local_7.member_3;
                let _e1046 = (((((_e936 * 8f) * ((_e979 * 8f) * _e1022)) * (0.000000059604645f * (524f / 64f))) + ((_e1031 * 19f) * ((_e936 * (_e979 + _e1022)) + (_e979 * _e1022)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e936) * ((1f + _e979) * (1f + _e1022)))));
                let _e1047 = (_e836 * 3f);
                let _e1048 = (_e893 * 3f);
                let _e1050 = select(_e1048, _e1047, (_e1047 < _e1048));
                let _e1052 = select(_e882, _e859, (_e859 < _e882));
                let _e1054 = select(_e1052, _e1050, (_e1050 < _e1052));
                let _e1056 = select(_e1048, _e1047, (_e1047 > _e1048));
                let _e1058 = select(_e882, _e859, (_e859 > _e882));
                let _e1061 = -(select(_e1058, _e1056, (_e1056 > _e1058)));
                if (select(_e1061, _e1054, (_e1054 > _e1061)) > _e1046) {
                    phi_6926_ = type_33(0u, type_33().member_1);
                    phi_6927_ = type_33();
                    phi_6928_ = true;
                } else {
                    let _e1068 = select(_e836, -(_e836), (_e836 < 0f));
                    let _e1071 = select(_e859, -(_e859), (_e859 < 0f));
                    let _e1073 = select(_e1071, _e1068, (_e1068 > _e1071));
                    let _e1076 = select(_e882, -(_e882), (_e882 < 0f));
                    let _e1079 = select(_e893, -(_e893), (_e893 < 0f));
                    let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                    let _e1083 = select(_e1081, _e1073, (_e1073 > _e1081));
                    let _e1084 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                    if (_e1083 >= _e1084) {
                        phi_2429_ = (_e1083 <= (1f / _e1084));
                    } else {
                        phi_2429_ = false;
                    }
                    let _e1089 = phi_2429_;
                    if _e1089 {
                        phi_2441_ = (1f / _e1083);
                    } else {
                        phi_2441_ = 0f;
                    }
                    let _e1096 = phi_2441_;
                    let _e1097 = (_e351 * 0.0625f);
                    local_5 = type_36(array<f32, 4>(_e836, _e859, _e882, _e893), ((_e1046 * 0.34f) + (_e1083 * select(2f, (0.000000059604645f * 256f), _e1089))), _e1096, select(_e1097, 0.00000000000022737368f, (0.00000000000022737368f < _e1097)));
                    let _e1104 = local_5.member[0u];
                    let _e1107 = local_5.member[1u];
                    let _e1110 = local_5.member[2u];
                    let _e1113 = local_5.member[3u];
                    let _e1120 = local_5.member_2;
                    let _e1121 = ((_e1107 - (3f * _e1104)) * _e1120);
                    let _e1123 = local_5.member_2;
                    let _e1124 = ((_e1110 - _e1107) * _e1123);
                    let _e1126 = local_5.member_2;
                    let _e1127 = (((3f * _e1113) - _e1110) * _e1126);
                    local_3[0u] = 0f;
                    local_3[1u] = 1f;
                    local_3[2u] = 1f;
                    local_3[3u] = 1f;
                    let _e1134 = ((_e1124 * _e1124) - (_e1121 * _e1127));
                    if (_e1134 > 0f) {
                        if (_e1134 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2569_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1134 > 0f));
                        } else {
                            phi_2512_ = type_14(0i, 5i);
                            phi_2515_ = bitcast<f32>(((bitcast<u32>(_e1134) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1143 = phi_2512_;
                                let _e1145 = phi_2515_;
                                local_9 = _e1145;
                                if (_e1143.member < _e1143.member_1) {
                                    let _e1152 = (_e1143.member + 1i);
                                    phi_2513_ = type_14(select(_e1152, type_15().member_1, select(false, true, ((false == (_e1152 > _e1143.member)) != false))), _e1143.member_1);
                                    phi_2556_ = type_15(1u, _e1143.member);
                                } else {
                                    phi_2513_ = _e1143;
                                    phi_2556_ = type_15(0u, type_15().member_1);
                                }
                                let _e1163 = phi_2513_;
                                let _e1165 = phi_2556_;
                                let _e1168 = (bitcast<i32>(_e1165.member) != 0i);
                                if _e1168 {
                                    phi_2516_ = (0.5f * (_e1145 + (_e1134 / _e1145)));
                                } else {
                                    phi_2516_ = f32();
                                }
                                let _e1173 = phi_2516_;
                                continue;
                                continuing {
                                    phi_2512_ = _e1163;
                                    phi_2515_ = _e1173;
                                    break if !(_e1168);
                                }
                            }
                            let _e1178 = local_9;
                            phi_2569_ = (_e1178 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1184 = phi_2569_;
                        let _e1189 = -((_e1124 + select(_e1184, -(_e1184), (_e1124 < 0f))));
                        local_4[0u] = (_e1189 / (_e1189 + _e1127));
                        local_4[1u] = (_e1121 / (_e1121 + _e1189));
                        let _e1198 = local_4[1u];
                        let _e1199 = local_4[0u];
                        if (_e1198 < _e1199) {
                            let _e1202 = local_4[1u];
                            let _e1204 = local_4[0u];
                            local_4[0u] = _e1202;
                            local_4[1u] = _e1204;
                        }
                        phi_2600_ = type_9(0u, 2u);
                        phi_2603_ = 1u;
                        loop {
                            let _e1208 = phi_2600_;
                            let _e1210 = phi_2603_;
                            local_41 = _e1210;
                            let _e1213 = (_e1208.member < _e1208.member_1);
                            let _e1224 = select(type_9().member_1, _e1208.member, _e1213);
                            let _e1226 = (bitcast<i32>(select(0u, 1u, _e1213)) != 0i);
                            if _e1226 {
                                let _e1228 = local_4[_e1224];
                                if (_e1228 > 0f) {
                                    let _e1231 = local_4[_e1224];
                                    if (_e1231 < 1f) {
                                        let _e1234 = local_4[_e1224];
                                        local_3[_e1210] = _e1234;
                                        phi_2670_ = (_e1210 + 1u);
                                    } else {
                                        phi_2670_ = _e1210;
                                    }
                                    let _e1238 = phi_2670_;
                                    phi_2671_ = _e1238;
                                } else {
                                    phi_2671_ = _e1210;
                                }
                                let _e1240 = phi_2671_;
                                phi_2604_ = _e1240;
                            } else {
                                phi_2604_ = u32();
                            }
                            let _e1242 = phi_2604_;
                            continue;
                            continuing {
                                phi_2600_ = type_9(select(_e1208.member, (_e1208.member + 1u), _e1213), select(_e1208.member_1, _e1208.member_1, _e1213));
                                phi_2603_ = _e1242;
                                break if !(_e1226);
                            }
                        }
                        let _e3884 = local_41;
                        phi_2672_ = _e3884;
                    } else {
                        phi_2672_ = 1u;
                    }
                    let _e1245 = phi_2672_;
                    local_3[_e1245] = 1f;
                    let _e1247 = local_3;
                    local_6 = _e1247;
                    let _e1248 = (_e351 * 0.99f);
                    let _e1249 = (1f - _e353);
                    let _e1252 = local_5.member[0u];
                    let _e1255 = local_5.member[1u];
                    let _e1258 = local_5.member[2u];
                    let _e1261 = local_5.member[3u];
                    let _e1272 = ((((_e1252 * _e1249) + (_e1255 * _e353)) * (_e1249 * _e1249)) + (((_e1258 * _e1249) + (_e1261 * _e353)) * (_e353 * _e353)));
                    let _e1277 = local_5.member_1;
                    phi_2728_ = type_9(select(1u, 0u, !((select(_e1272, -(_e1272), (_e1272 < 0f)) > _e1277))), (_e1245 + 1u));
                    loop {
                        let _e1284 = phi_2728_;
                        let _e1287 = (_e1284.member < _e1284.member_1);
                        let _e1298 = select(type_9().member_1, _e1284.member, _e1287);
                        if (bitcast<i32>(select(0u, 1u, _e1287)) != 0i) {
                            if (_e1298 > 0u) {
                                let _e1305 = local_6[(_e1298 - 1u)];
                                let _e1307 = select(_e353, _e1305, (_e1305 > _e353));
                                let _e1309 = local_6[_e1298];
                                let _e1311 = select(_e355, _e1309, (_e1309 < _e355));
                                if (_e1307 <= _e1311) {
                                    let _e1313 = function_4((&local_5), _e357, _e1307, _e1311);
                                    if _e1313 {
                                        phi_4131_ = type_38();
                                        phi_4132_ = bool();
                                        phi_4133_ = type_38();
                                        phi_4134_ = false;
                                        phi_4135_ = false;
                                        phi_4136_ = false;
                                        phi_4137_ = false;
                                    } else {
                                        let _e1314 = (1f - _e1307);
                                        let _e1317 = local_5.member[0u];
                                        let _e1320 = local_5.member[1u];
                                        let _e1323 = local_5.member[2u];
                                        let _e1326 = local_5.member[3u];
                                        let _e1337 = ((((_e1317 * _e1314) + (_e1320 * _e1307)) * (_e1314 * _e1314)) + (((_e1323 * _e1314) + (_e1326 * _e1307)) * (_e1307 * _e1307)));
                                        let _e1338 = (1f - _e1311);
                                        let _e1341 = local_5.member[0u];
                                        let _e1344 = local_5.member[1u];
                                        let _e1347 = local_5.member[2u];
                                        let _e1350 = local_5.member[3u];
                                        let _e1361 = ((((_e1341 * _e1338) + (_e1344 * _e1311)) * (_e1338 * _e1338)) + (((_e1347 * _e1338) + (_e1350 * _e1311)) * (_e1311 * _e1311)));
                                        let _e1366 = local_5.member_1;
                                        let _e1367 = (select(_e1337, -(_e1337), (_e1337 < 0f)) > _e1366);
                                        let _e1372 = local_5.member_1;
                                        let _e1373 = (select(_e1361, -(_e1361), (_e1361 < 0f)) > _e1372);
                                        let _e1381 = select(select(bool(), select(bool(), ((_e1337 > 0f) != (_e1361 > 0f)), _e1373), _e1367), false, select(true, select(true, false, _e1373), _e1367));
                                        if _e1367 {
                                            if _e1373 {
                                                phi_2884_ = type_38(select(1f, type_38().member, _e1381), select(0f, type_38().member_1, _e1381), select(_e1381, type_38().member_2, _e1381));
                                                phi_2885_ = _e1381;
                                            } else {
                                                phi_2884_ = type_38();
                                                phi_2885_ = true;
                                            }
                                            let _e1390 = phi_2884_;
                                            let _e1392 = phi_2885_;
                                            phi_2886_ = _e1390;
                                            phi_2887_ = _e1392;
                                        } else {
                                            phi_2886_ = type_38();
                                            phi_2887_ = true;
                                        }
                                        let _e1394 = phi_2886_;
                                        let _e1396 = phi_2887_;
                                        if _e1396 {
                                            if _e1367 {
                                                let _e1398 = select(1f, -1f, (_e1337 < 0f));
                                                let _e1400 = local_5.member_3;
                                                let _e1403 = local_5.member[0u];
                                                let _e1406 = local_5.member[1u];
                                                let _e1409 = local_5.member[2u];
                                                let _e1412 = local_5.member[3u];
                                                let _e1415 = (_e1409 - _e1406);
                                                phi_2918_ = type_9(0u, 64u);
                                                phi_2921_ = _e1311;
                                                phi_2923_ = _e1307;
                                                phi_2925_ = (0.5f * (_e1307 + _e1311));
                                                loop {
                                                    let _e1421 = phi_2918_;
                                                    let _e1423 = phi_2921_;
                                                    let _e1425 = phi_2923_;
                                                    let _e1427 = phi_2925_;
                                                    local_12 = _e1425;
                                                    let _e1430 = (_e1421.member < _e1421.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1430)) != 0i) {
                                                        let _e1442 = (1f - _e1427);
                                                        let _e1445 = local_5.member[0u];
                                                        let _e1448 = local_5.member[1u];
                                                        let _e1451 = local_5.member[2u];
                                                        let _e1454 = local_5.member[3u];
                                                        let _e1468 = local_5.member_1;
                                                        let _e1469 = ((_e1398 * ((((_e1445 * _e1442) + (_e1448 * _e1427)) * (_e1442 * _e1442)) + (((_e1451 * _e1442) + (_e1454 * _e1427)) * (_e1427 * _e1427)))) - _e1468);
                                                        let _e1470 = (_e1469 > 0f);
                                                        let _e1471 = select(_e1427, _e1423, _e1470);
                                                        let _e1472 = select(_e1425, _e1427, _e1470);
                                                        let _e1474 = ((_e1471 - _e1472) > _e1400);
                                                        if _e1474 {
                                                            let _e1475 = (1f - _e1427);
                                                            let _e1487 = (-(_e1469) / (_e1398 * (((((_e1406 - (3f * _e1403)) * _e1475) + (_e1415 * _e1427)) * _e1475) + (((_e1415 * _e1475) + (((3f * _e1412) - _e1409) * _e1427)) * _e1427))));
                                                            let _e1494 = ((_e1427 + _e1487) + select(-((0.5f * _e1400)), (0.5f * _e1400), (_e1469 > 0f)));
                                                            if (_e1494 > _e1472) {
                                                                phi_3035_ = select(true, select(true, false, (select(_e1487, -(_e1487), (_e1487 < 0f)) < (0.5f * (_e1471 - _e1472)))), (_e1494 < _e1471));
                                                            } else {
                                                                phi_3035_ = true;
                                                            }
                                                            let _e1506 = phi_3035_;
                                                            phi_3042_ = select(_e1494, (0.5f * (_e1472 + _e1471)), _e1506);
                                                            phi_3043_ = false;
                                                        } else {
                                                            phi_3042_ = f32();
                                                            phi_3043_ = true;
                                                        }
                                                        let _e1511 = phi_3042_;
                                                        let _e1513 = phi_3043_;
                                                        phi_2922_ = _e1471;
                                                        phi_2924_ = _e1472;
                                                        phi_2926_ = _e1511;
                                                        phi_3044_ = _e1472;
                                                        phi_3045_ = _e1474;
                                                        phi_3046_ = _e1513;
                                                    } else {
                                                        phi_2922_ = f32();
                                                        phi_2924_ = f32();
                                                        phi_2926_ = f32();
                                                        phi_3044_ = f32();
                                                        phi_3045_ = false;
                                                        phi_3046_ = false;
                                                    }
                                                    let _e1515 = phi_2922_;
                                                    let _e1517 = phi_2924_;
                                                    let _e1519 = phi_2926_;
                                                    let _e1521 = phi_3044_;
                                                    let _e1523 = phi_3045_;
                                                    let _e1525 = phi_3046_;
                                                    local_10 = _e1525;
                                                    local_11 = _e1521;
                                                    continue;
                                                    continuing {
                                                        phi_2918_ = type_9(select(_e1421.member, (_e1421.member + 1u), _e1430), select(_e1421.member_1, _e1421.member_1, _e1430));
                                                        phi_2921_ = _e1515;
                                                        phi_2923_ = _e1517;
                                                        phi_2925_ = _e1519;
                                                        break if !(_e1523);
                                                    }
                                                }
                                                let _e1528 = local_10;
                                                let _e1530 = local_11;
                                                let _e1532 = local_12;
                                                phi_3051_ = select(_e1532, _e1530, _e1528);
                                            } else {
                                                phi_3051_ = _e1307;
                                            }
                                            let _e1535 = phi_3051_;
                                            if _e1373 {
                                                let _e1539 = local_5.member_3;
                                                let _e1541 = local_5.member_3;
                                                phi_3067_ = type_9(0u, 64u);
                                                phi_3070_ = (_e1539 + _e1541);
                                                loop {
                                                    let _e1544 = phi_3067_;
                                                    let _e1546 = phi_3070_;
                                                    let _e1549 = (_e1544.member < _e1544.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1549)) != 0i) {
                                                        let _e1561 = (_e1535 + _e1546);
                                                        if (_e1561 < _e1311) {
                                                            let _e1563 = (1f - _e1561);
                                                            let _e1566 = local_5.member[0u];
                                                            let _e1569 = local_5.member[1u];
                                                            let _e1572 = local_5.member[2u];
                                                            let _e1575 = local_5.member[3u];
                                                            let _e1589 = local_5.member_1;
                                                            let _e1590 = ((select(1f, -1f, (_e1361 < 0f)) * ((((_e1566 * _e1563) + (_e1569 * _e1561)) * (_e1563 * _e1563)) + (((_e1572 * _e1563) + (_e1575 * _e1561)) * (_e1561 * _e1561)))) > _e1589);
                                                            phi_3135_ = select((_e1546 + _e1546), f32(), _e1590);
                                                            phi_3136_ = select(true, false, _e1590);
                                                            phi_3137_ = _e1590;
                                                            phi_3138_ = false;
                                                        } else {
                                                            phi_3135_ = f32();
                                                            phi_3136_ = false;
                                                            phi_3137_ = false;
                                                            phi_3138_ = true;
                                                        }
                                                        let _e1595 = phi_3135_;
                                                        let _e1597 = phi_3136_;
                                                        let _e1599 = phi_3137_;
                                                        let _e1601 = phi_3138_;
                                                        phi_3139_ = _e1561;
                                                        phi_3071_ = _e1595;
                                                        phi_3140_ = _e1597;
                                                        phi_3141_ = _e1599;
                                                        phi_3142_ = _e1601;
                                                        phi_3143_ = false;
                                                    } else {
                                                        phi_3139_ = f32();
                                                        phi_3071_ = f32();
                                                        phi_3140_ = false;
                                                        phi_3141_ = false;
                                                        phi_3142_ = false;
                                                        phi_3143_ = true;
                                                    }
                                                    let _e1603 = phi_3139_;
                                                    let _e1605 = phi_3071_;
                                                    let _e1607 = phi_3140_;
                                                    let _e1609 = phi_3141_;
                                                    let _e1611 = phi_3142_;
                                                    let _e1613 = phi_3143_;
                                                    local_13 = _e1609;
                                                    local_14 = _e1611;
                                                    local_15 = _e1609;
                                                    local_16 = _e1613;
                                                    local_17 = _e1603;
                                                    continue;
                                                    continuing {
                                                        phi_3067_ = type_9(select(_e1544.member, (_e1544.member + 1u), _e1549), select(_e1544.member_1, _e1544.member_1, _e1549));
                                                        phi_3070_ = _e1605;
                                                        break if !(_e1607);
                                                    }
                                                }
                                                let _e1616 = local_13;
                                                let _e1618 = local_14;
                                                let _e1621 = local_15;
                                                let _e1623 = local_16;
                                                let _e1627 = local_17;
                                                phi_3157_ = select(_e1627, _e1311, select(select(_e1623, false, _e1621), true, select(_e1618, false, _e1616)));
                                            } else {
                                                phi_3157_ = _e1311;
                                            }
                                            let _e1630 = phi_3157_;
                                            phi_3159_ = type_38(_e1535, _e1630, _e1381);
                                        } else {
                                            phi_3159_ = _e1394;
                                        }
                                        let _e1633 = phi_3159_;
                                        if (_e1633.member > _e1633.member_1) {
                                            phi_4126_ = bool();
                                            phi_4127_ = true;
                                            phi_4128_ = false;
                                            phi_4129_ = false;
                                            phi_4130_ = false;
                                        } else {
                                            let _e1638 = (_e1633.member > _e357);
                                            if _e1638 {
                                                phi_4122_ = bool();
                                                phi_4123_ = false;
                                                phi_4124_ = false;
                                                phi_4125_ = false;
                                            } else {
                                                let _e1642 = ((_e1633.member_1 - _e1633.member) * 0.5f);
                                                let _e1643 = (_e1633.member + _e1642);
                                                let _e1645 = (_e1642 + (0.000000059604645f * 4f));
                                                let _e1647 = local_7.member_3;
                                                let _e1650 = local_7.member[0u];
                                                let _e1656 = select(_e1650[0], -(_e1650[0]), (_e1650[0] < 0f));
                                                let _e1659 = select(_e1650[1], -(_e1650[1]), (_e1650[1] < 0f));
                                                let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                let _e1664 = select(_e1650[2], -(_e1650[2]), (_e1650[2] < 0f));
                                                let _e1666 = select(_e1664, _e1661, (_e1661 > _e1664));
                                                let _e1668 = local_7.member[1u];
                                                let _e1674 = select(_e1668[0], -(_e1668[0]), (_e1668[0] < 0f));
                                                let _e1677 = select(_e1668[1], -(_e1668[1]), (_e1668[1] < 0f));
                                                let _e1679 = select(_e1677, _e1674, (_e1674 > _e1677));
                                                let _e1682 = select(_e1668[2], -(_e1668[2]), (_e1668[2] < 0f));
                                                let _e1684 = select(_e1682, _e1679, (_e1679 > _e1682));
                                                let _e1689 = local_7.member[0u];
                                                let _e1694 = local_7.member[1u];
                                                let _e1704 = (_e1689[0] + ((_e1694[0] - _e1689[0]) * _e1643));
                                                let _e1705 = (_e1689[1] + ((_e1694[1] - _e1689[1]) * _e1643));
                                                let _e1706 = (_e1689[2] + ((_e1694[2] - _e1689[2]) * _e1643));
                                                let _e1708 = local_7.member[1u];
                                                let _e1713 = local_7.member[0u];
                                                let _e1717 = (_e1708[0] - _e1713[0]);
                                                let _e1718 = (_e1708[1] - _e1713[1]);
                                                let _e1719 = (_e1708[2] - _e1713[2]);
                                                let _e1722 = select(_e1717, -(_e1717), (_e1717 < 0f));
                                                let _e1725 = select(_e1718, -(_e1718), (_e1718 < 0f));
                                                let _e1727 = select(_e1725, _e1722, (_e1722 > _e1725));
                                                let _e1730 = select(_e1719, -(_e1719), (_e1719 < 0f));
                                                let _e1738 = ((((_e1645 * select(_e1730, _e1727, (_e1727 > _e1730))) * 1.01f) + ((select(_e1684, _e1666, (_e1666 > _e1684)) + _e1647) * (0.000000059604645f * 8f))) + _e1647);
                                                let _e1741 = select(_e1704, -(_e1704), (_e1704 < 0f));
                                                let _e1744 = select(_e1705, -(_e1705), (_e1705 < 0f));
                                                let _e1746 = select(_e1744, _e1741, (_e1741 > _e1744));
                                                let _e1749 = select(_e1706, -(_e1706), (_e1706 < 0f));
                                                let _e1752 = (select(_e1749, _e1746, (_e1746 > _e1749)) + _e1738);
                                                let _e1755 = local_7.member_3;
                                                let _e1757 = local_7.member_1[0u];
                                                let _e1763 = select(_e1757[0], -(_e1757[0]), (_e1757[0] < 0f));
                                                let _e1766 = select(_e1757[1], -(_e1757[1]), (_e1757[1] < 0f));
                                                let _e1768 = select(_e1766, _e1763, (_e1763 > _e1766));
                                                let _e1771 = select(_e1757[2], -(_e1757[2]), (_e1757[2] < 0f));
                                                let _e1773 = select(_e1771, _e1768, (_e1768 > _e1771));
                                                let _e1775 = local_7.member_1[1u];
                                                let _e1781 = select(_e1775[0], -(_e1775[0]), (_e1775[0] < 0f));
                                                let _e1784 = select(_e1775[1], -(_e1775[1]), (_e1775[1] < 0f));
                                                let _e1786 = select(_e1784, _e1781, (_e1781 > _e1784));
                                                let _e1789 = select(_e1775[2], -(_e1775[2]), (_e1775[2] < 0f));
                                                let _e1791 = select(_e1789, _e1786, (_e1786 > _e1789));
                                                let _e1796 = local_7.member_1[0u];
                                                let _e1801 = local_7.member_1[1u];
                                                let _e1811 = (_e1796[0] + ((_e1801[0] - _e1796[0]) * _e1643));
                                                let _e1812 = (_e1796[1] + ((_e1801[1] - _e1796[1]) * _e1643));
                                                let _e1813 = (_e1796[2] + ((_e1801[2] - _e1796[2]) * _e1643));
                                                let _e1815 = local_7.member_1[1u];
                                                let _e1820 = local_7.member_1[0u];
                                                let _e1824 = (_e1815[0] - _e1820[0]);
                                                let _e1825 = (_e1815[1] - _e1820[1]);
                                                let _e1826 = (_e1815[2] - _e1820[2]);
                                                let _e1829 = select(_e1824, -(_e1824), (_e1824 < 0f));
                                                let _e1832 = select(_e1825, -(_e1825), (_e1825 < 0f));
                                                let _e1834 = select(_e1832, _e1829, (_e1829 > _e1832));
                                                let _e1837 = select(_e1826, -(_e1826), (_e1826 < 0f));
                                                let _e1845 = ((((_e1645 * select(_e1837, _e1834, (_e1834 > _e1837))) * 1.01f) + ((select(_e1791, _e1773, (_e1773 > _e1791)) + _e1755) * (0.000000059604645f * 8f))) + _e1755);
                                                let _e1848 = select(_e1811, -(_e1811), (_e1811 < 0f));
                                                let _e1851 = select(_e1812, -(_e1812), (_e1812 < 0f));
                                                let _e1853 = select(_e1851, _e1848, (_e1848 > _e1851));
                                                let _e1856 = select(_e1813, -(_e1813), (_e1813 < 0f));
                                                let _e1859 = (select(_e1856, _e1853, (_e1853 > _e1856)) + _e1845);
                                                let _e1862 = local_7.member_3;
                                                let _e1864 = local_7.member_2[0u];
                                                let _e1870 = select(_e1864[0], -(_e1864[0]), (_e1864[0] < 0f));
                                                let _e1873 = select(_e1864[1], -(_e1864[1]), (_e1864[1] < 0f));
                                                let _e1875 = select(_e1873, _e1870, (_e1870 > _e1873));
                                                let _e1878 = select(_e1864[2], -(_e1864[2]), (_e1864[2] < 0f));
                                                let _e1880 = select(_e1878, _e1875, (_e1875 > _e1878));
                                                let _e1882 = local_7.member_2[1u];
                                                let _e1888 = select(_e1882[0], -(_e1882[0]), (_e1882[0] < 0f));
                                                let _e1891 = select(_e1882[1], -(_e1882[1]), (_e1882[1] < 0f));
                                                let _e1893 = select(_e1891, _e1888, (_e1888 > _e1891));
                                                let _e1896 = select(_e1882[2], -(_e1882[2]), (_e1882[2] < 0f));
                                                let _e1898 = select(_e1896, _e1893, (_e1893 > _e1896));
                                                let _e1903 = local_7.member_2[0u];
                                                let _e1908 = local_7.member_2[1u];
                                                let _e1918 = (_e1903[0] + ((_e1908[0] - _e1903[0]) * _e1643));
                                                let _e1919 = (_e1903[1] + ((_e1908[1] - _e1903[1]) * _e1643));
                                                let _e1920 = (_e1903[2] + ((_e1908[2] - _e1903[2]) * _e1643));
                                                let _e1922 = local_7.member_2[1u];
                                                let _e1927 = local_7.member_2[0u];
                                                let _e1931 = (_e1922[0] - _e1927[0]);
                                                let _e1932 = (_e1922[1] - _e1927[1]);
                                                let _e1933 = (_e1922[2] - _e1927[2]);
                                                let _e1936 = select(_e1931, -(_e1931), (_e1931 < 0f));
                                                let _e1939 = select(_e1932, -(_e1932), (_e1932 < 0f));
                                                let _e1941 = select(_e1939, _e1936, (_e1936 > _e1939));
                                                let _e1944 = select(_e1933, -(_e1933), (_e1933 < 0f));
                                                let _e1952 = ((((_e1645 * select(_e1944, _e1941, (_e1941 > _e1944))) * 1.01f) + ((select(_e1898, _e1880, (_e1880 > _e1898)) + _e1862) * (0.000000059604645f * 8f))) + _e1862);
                                                let _e1955 = select(_e1918, -(_e1918), (_e1918 < 0f));
                                                let _e1958 = select(_e1919, -(_e1919), (_e1919 < 0f));
                                                let _e1960 = select(_e1958, _e1955, (_e1955 > _e1958));
                                                let _e1963 = select(_e1920, -(_e1920), (_e1920 < 0f));
                                                let _e1966 = (select(_e1963, _e1960, (_e1960 > _e1963)) + _e1952);
                                                let _e1969 = ((_e1812 * _e1920) - (_e1813 * _e1919));
                                                let _e1972 = ((_e1813 * _e1918) - (_e1811 * _e1920));
                                                let _e1975 = ((_e1811 * _e1919) - (_e1812 * _e1918));
                                                let _e1990 = select(false, (select(_e1969, -(_e1969), (_e1969 < 0f)) > select(_e1975, -(_e1975), (_e1975 < 0f))), (select(_e1969, -(_e1969), (_e1969 < 0f)) > select(_e1972, -(_e1972), (_e1972 < 0f))));
                                                let _e2005 = select((select(_e1972, -(_e1972), (_e1972 < 0f)) > select(_e1975, -(_e1975), (_e1975 < 0f))), false, (select(_e1969, -(_e1969), (_e1969 < 0f)) > select(_e1972, -(_e1972), (_e1972 < 0f))));
                                                let _e2008 = select(select(_e1704, _e1705, _e1990), _e1706, _e2005);
                                                let _e2009 = select(select(_e1705, _e1706, _e1990), _e1704, _e2005);
                                                let _e2012 = select(select(_e1811, _e1812, _e1990), _e1813, _e2005);
                                                let _e2013 = select(select(_e1812, _e1813, _e1990), _e1811, _e2005);
                                                let _e2016 = select(select(_e1918, _e1919, _e1990), _e1920, _e2005);
                                                let _e2017 = select(select(_e1919, _e1920, _e1990), _e1918, _e2005);
                                                let _e2020 = ((_e2012 * _e2017) - (_e2013 * _e2016));
                                                let _e2036 = (((((_e1845 * _e1966) + (_e1859 * _e1952)) * 2.01f) + (((_e1859 * 2f) * (_e1966 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1859) * (1f + _e1966))));
                                                if (select(_e2020, -(_e2020), (_e2020 < 0f)) > _e2036) {
                                                    let _e2042 = select(1f, -1f, (_e2020 < 0f));
                                                    let _e2061 = (((((_e1738 * _e1966) + (_e1752 * _e1952)) * 2.01f) + (((_e1752 * 2f) * (_e1966 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1752) * (1f + _e1966))));
                                                    let _e2080 = (((((_e1845 * _e1752) + (_e1859 * _e1738)) * 2.01f) + (((_e1859 * 2f) * (_e1752 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1859) * (1f + _e1752))));
                                                    let _e2081 = (_e2020 * _e2042);
                                                    let _e2082 = (((_e2008 * _e2017) - (_e2009 * _e2016)) * _e2042);
                                                    let _e2083 = (((_e2012 * _e2009) - (_e2013 * _e2008)) * _e2042);
                                                    let _e2096 = (((select(_e2081, -(_e2081), (_e2081 < 0f)) + select(_e2082, -(_e2082), (_e2082 < 0f))) + select(_e2083, -(_e2083), (_e2083 < 0f))) * (0.000000059604645f * 4f));
                                                    if (_e224.member != 0u) {
                                                        phi_3996_ = array<type_16, 4>(type_16(_e2082, _e2061), type_16(_e2083, _e2080), type_16((_e2081 - _e2082), ((_e2036 + _e2061) + _e2096)), type_16((_e2081 - _e2083), ((_e2036 + _e2080) + _e2096)));
                                                    } else {
                                                        let _e2099 = ((_e2081 - _e2082) - _e2083);
                                                        let _e2102 = (((_e2036 + _e2061) + _e2080) + _e2096);
                                                        phi_3996_ = array<type_16, 4>(type_16(_e2082, _e2061), type_16(_e2083, _e2080), type_16(_e2099, _e2102), type_16(_e2099, _e2102));
                                                    }
                                                    let _e2120 = phi_3996_;
                                                    local_2 = array<type_16, 4>(type_16(_e2120[0].member, _e2120[0].member_1), type_16(_e2120[1].member, _e2120[1].member_1), type_16(_e2120[2].member, _e2120[2].member_1), type_16(_e2120[3].member, _e2120[3].member_1));
                                                    phi_4016_ = type_9(0u, 4u);
                                                    phi_4019_ = true;
                                                    loop {
                                                        let _e2139 = phi_4016_;
                                                        let _e2141 = phi_4019_;
                                                        local_19 = _e2141;
                                                        let _e2144 = (_e2139.member < _e2139.member_1);
                                                        let _e2155 = select(type_9().member_1, _e2139.member, _e2144);
                                                        if (bitcast<i32>(select(0u, 1u, _e2144)) != 0i) {
                                                            let _e2160 = local_2[_e2155].member;
                                                            let _e2163 = local_2[_e2155].member_1;
                                                            let _e2165 = (_e2160 < -(_e2163));
                                                            phi_4020_ = select((_e2141 && (_e2160 > _e2163)), bool(), _e2165);
                                                            phi_4071_ = select(true, false, _e2165);
                                                            phi_4072_ = _e2165;
                                                        } else {
                                                            phi_4020_ = bool();
                                                            phi_4071_ = false;
                                                            phi_4072_ = false;
                                                        }
                                                        let _e2171 = phi_4020_;
                                                        let _e2173 = phi_4071_;
                                                        let _e2175 = phi_4072_;
                                                        local_18 = _e2175;
                                                        continue;
                                                        continuing {
                                                            phi_4016_ = type_9(select(_e2139.member, (_e2139.member + 1u), _e2144), select(_e2139.member_1, _e2139.member_1, _e2144));
                                                            phi_4019_ = _e2171;
                                                            break if !(_e2173);
                                                        }
                                                    }
                                                    let _e2178 = local_18;
                                                    let _e2179 = select(true, false, _e2178);
                                                    let _e2181 = local_19;
                                                    phi_4086_ = select(u32(), select(2u, 1u, _e2181), _e2179);
                                                    phi_4087_ = 0u;
                                                    phi_4088_ = select(true, false, _e2179);
                                                } else {
                                                    phi_4086_ = u32();
                                                    phi_4087_ = 2u;
                                                    phi_4088_ = true;
                                                }
                                                let _e2186 = phi_4086_;
                                                let _e2188 = phi_4087_;
                                                let _e2190 = phi_4088_;
                                                let _e2191 = select(_e2186, _e2188, _e2190);
                                                let _e2192 = (_e2191 == 0u);
                                                if _e2192 {
                                                    phi_4119_ = bool();
                                                    phi_4120_ = false;
                                                    phi_4121_ = false;
                                                } else {
                                                    let _e2195 = select(false, _e1633.member_2, (_e2191 == 1u));
                                                    let _e2201 = select(true, select(true, false, ((_e1633.member_1 - _e1633.member) <= _e1248)), _e2195);
                                                    phi_4119_ = _e2195;
                                                    phi_4120_ = _e2201;
                                                    phi_4121_ = select(true, false, _e2201);
                                                }
                                                let _e2204 = phi_4119_;
                                                let _e2206 = phi_4120_;
                                                let _e2208 = phi_4121_;
                                                phi_4122_ = _e2204;
                                                phi_4123_ = _e2192;
                                                phi_4124_ = _e2206;
                                                phi_4125_ = _e2208;
                                            }
                                            let _e2210 = phi_4122_;
                                            let _e2212 = phi_4123_;
                                            let _e2214 = phi_4124_;
                                            let _e2216 = phi_4125_;
                                            phi_4126_ = _e2210;
                                            phi_4127_ = _e2212;
                                            phi_4128_ = _e2214;
                                            phi_4129_ = _e1638;
                                            phi_4130_ = _e2216;
                                        }
                                        let _e2218 = phi_4126_;
                                        let _e2220 = phi_4127_;
                                        let _e2222 = phi_4128_;
                                        let _e2224 = phi_4129_;
                                        let _e2226 = phi_4130_;
                                        phi_4131_ = _e1633;
                                        phi_4132_ = _e2218;
                                        phi_4133_ = _e1633;
                                        phi_4134_ = _e2220;
                                        phi_4135_ = _e2222;
                                        phi_4136_ = _e2224;
                                        phi_4137_ = _e2226;
                                    }
                                    let _e2228 = phi_4131_;
                                    let _e2230 = phi_4132_;
                                    let _e2232 = phi_4133_;
                                    let _e2234 = phi_4134_;
                                    let _e2236 = phi_4135_;
                                    let _e2238 = phi_4136_;
                                    let _e2240 = phi_4137_;
                                    phi_4138_ = _e2228;
                                    phi_4139_ = _e2230;
                                    phi_4140_ = _e2232;
                                    phi_4141_ = _e2234;
                                    phi_4142_ = _e2236;
                                    phi_4143_ = _e1313;
                                    phi_4144_ = _e2238;
                                    phi_4145_ = _e2240;
                                } else {
                                    phi_4138_ = type_38();
                                    phi_4139_ = bool();
                                    phi_4140_ = type_38();
                                    phi_4141_ = true;
                                    phi_4142_ = false;
                                    phi_4143_ = false;
                                    phi_4144_ = false;
                                    phi_4145_ = false;
                                }
                                let _e2242 = phi_4138_;
                                let _e2244 = phi_4139_;
                                let _e2246 = phi_4140_;
                                let _e2248 = phi_4141_;
                                let _e2250 = phi_4142_;
                                let _e2252 = phi_4143_;
                                let _e2254 = phi_4144_;
                                let _e2256 = phi_4145_;
                                phi_4153_ = _e2242;
                                phi_4154_ = _e2244;
                                phi_4155_ = _e2246;
                                phi_4156_ = select(_e2250, false, _e2248);
                                phi_4157_ = _e2248;
                                phi_4158_ = select(_e2252, false, _e2248);
                                phi_4159_ = select(_e2254, false, _e2248);
                                phi_4160_ = select(_e2256, false, _e2248);
                            } else {
                                phi_4153_ = type_38(_e353, _e353, false);
                                phi_4154_ = false;
                                phi_4155_ = type_38();
                                phi_4156_ = true;
                                phi_4157_ = false;
                                phi_4158_ = false;
                                phi_4159_ = false;
                                phi_4160_ = false;
                            }
                            let _e2262 = phi_4153_;
                            let _e2264 = phi_4154_;
                            let _e2266 = phi_4155_;
                            let _e2268 = phi_4156_;
                            let _e2270 = phi_4157_;
                            let _e2272 = phi_4158_;
                            let _e2274 = phi_4159_;
                            let _e2276 = phi_4160_;
                            if _e2268 {
                                let _e2281 = local_7.member[0u];
                                let _e2287 = local_7.member_1[0u];
                                let _e2293 = local_7.member_2[0u];
                                let _e2297 = (_e2281[0] - _e2287[0]);
                                let _e2298 = (_e2281[1] - _e2287[1]);
                                let _e2299 = (_e2281[2] - _e2287[2]);
                                let _e2300 = (_e224.member == 0u);
                                let _e2312 = local_7.member[1u];
                                let _e2318 = local_7.member_1[1u];
                                let _e2324 = local_7.member_2[1u];
                                let _e2328 = (_e2312[0] - _e2318[0]);
                                let _e2329 = (_e2312[1] - _e2318[1]);
                                let _e2330 = (_e2312[2] - _e2318[2]);
                                let _e2331 = (_e224.member == 0u);
                                let _e2343 = local_7.member[0u];
                                let _e2349 = select(_e2343[0], -(_e2343[0]), (_e2343[0] < 0f));
                                let _e2352 = select(_e2343[1], -(_e2343[1]), (_e2343[1] < 0f));
                                let _e2354 = select(_e2352, _e2349, (_e2349 > _e2352));
                                let _e2357 = select(_e2343[2], -(_e2343[2]), (_e2343[2] < 0f));
                                let _e2359 = select(_e2357, _e2354, (_e2354 > _e2357));
                                let _e2362 = local_7.member[1u];
                                let _e2368 = select(_e2362[0], -(_e2362[0]), (_e2362[0] < 0f));
                                let _e2371 = select(_e2362[1], -(_e2362[1]), (_e2362[1] < 0f));
                                let _e2373 = select(_e2371, _e2368, (_e2368 > _e2371));
                                let _e2376 = select(_e2362[2], -(_e2362[2]), (_e2362[2] < 0f));
                                let _e2378 = select(_e2376, _e2373, (_e2373 > _e2376));
                                let _e2382 = local_7.member_3;
                                let _e2386 = local_7.member_1[0u];
                                let _e2392 = select(_e2386[0], -(_e2386[0]), (_e2386[0] < 0f));
                                let _e2395 = select(_e2386[1], -(_e2386[1]), (_e2386[1] < 0f));
                                let _e2397 = select(_e2395, _e2392, (_e2392 > _e2395));
                                let _e2400 = select(_e2386[2], -(_e2386[2]), (_e2386[2] < 0f));
                                let _e2402 = select(_e2400, _e2397, (_e2397 > _e2400));
                                let _e2405 = local_7.member_1[1u];
                                let _e2411 = select(_e2405[0], -(_e2405[0]), (_e2405[0] < 0f));
                                let _e2414 = select(_e2405[1], -(_e2405[1]), (_e2405[1] < 0f));
                                let _e2416 = select(_e2414, _e2411, (_e2411 > _e2414));
                                let _e2419 = select(_e2405[2], -(_e2405[2]), (_e2405[2] < 0f));
                                let _e2421 = select(_e2419, _e2416, (_e2416 > _e2419));
                                let _e2425 = local_7.member_3;
                                let _e2429 = local_7.member_2[0u];
                                let _e2435 = select(_e2429[0], -(_e2429[0]), (_e2429[0] < 0f));
                                let _e2438 = select(_e2429[1], -(_e2429[1]), (_e2429[1] < 0f));
                                let _e2440 = select(_e2438, _e2435, (_e2435 > _e2438));
                                let _e2443 = select(_e2429[2], -(_e2429[2]), (_e2429[2] < 0f));
                                let _e2445 = select(_e2443, _e2440, (_e2440 > _e2443));
                                let _e2448 = local_7.member_2[1u];
                                let _e2454 = select(_e2448[0], -(_e2448[0]), (_e2448[0] < 0f));
                                let _e2457 = select(_e2448[1], -(_e2448[1]), (_e2448[1] < 0f));
                                let _e2459 = select(_e2457, _e2454, (_e2454 > _e2457));
                                let _e2462 = select(_e2448[2], -(_e2448[2]), (_e2448[2] < 0f));
                                let _e2464 = select(_e2462, _e2459, (_e2459 > _e2462));
                                let _e2468 = local_7.member_3;
                                let _e2475 = local_7.member_3;
                                let _e2480 = (_e351 * 0.00390625f);
                                local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_4583_ = type_9(0u, 96u);
                                phi_4586_ = _e2262.member;
                                phi_4588_ = _e2262.member;
                                phi_4590_ = (_e2262.member_1 - _e2262.member);
                                phi_4592_ = _e2262.member;
                                phi_4594_ = false;
                                phi_4596_ = 0u;
                                loop {
                                    let _e2483 = phi_4583_;
                                    let _e2485 = phi_4586_;
                                    let _e2487 = phi_4588_;
                                    let _e2489 = phi_4590_;
                                    let _e2491 = phi_4592_;
                                    let _e2493 = phi_4594_;
                                    let _e2495 = phi_4596_;
                                    local_29 = _e2485;
                                    local_32 = _e2487;
                                    let _e2498 = (_e2483.member < _e2483.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2498)) != 0i) {
                                        let _e2512 = local_7.member[0u];
                                        let _e2518 = local_7.member[1u];
                                        let _e2534 = local_7.member_1[0u];
                                        let _e2540 = local_7.member_1[1u];
                                        let _e2556 = local_7.member_2[0u];
                                        let _e2562 = local_7.member_2[1u];
                                        let _e2576 = function_2(array<f32, 3>((_e2512[0] + ((_e2518[0] - _e2512[0]) * _e2485)), (_e2512[1] + ((_e2518[1] - _e2512[1]) * _e2485)), (_e2512[2] + ((_e2518[2] - _e2512[2]) * _e2485))), array<f32, 3>((_e2534[0] + ((_e2540[0] - _e2534[0]) * _e2485)), (_e2534[1] + ((_e2540[1] - _e2534[1]) * _e2485)), (_e2534[2] + ((_e2540[2] - _e2534[2]) * _e2485))), array<f32, 3>((_e2556[0] + ((_e2562[0] - _e2556[0]) * _e2485)), (_e2556[1] + ((_e2562[1] - _e2556[1]) * _e2485)), (_e2556[2] + ((_e2562[2] - _e2556[2]) * _e2485))), _e224.member);
                                        if (_e2495 == 0u) {
                                            phi_4747_ = _e2576;
                                        } else {
                                            phi_4747_ = array<f32, 3>(select(0f, _e2576[0], (_e2495 == 1u)), select(0f, _e2576[1], (_e2495 == 2u)), select(0f, _e2576[2], (_e2495 == 3u)));
                                        }
                                        let _e2589 = phi_4747_;
                                        let _e2603 = ((select(_e2589[0], -(_e2589[0]), (_e2589[0] < 0f)) + select(_e2589[1], -(_e2589[1]), (_e2589[1] < 0f))) + select(_e2589[2], -(_e2589[2]), (_e2589[2] < 0f)));
                                        if (_e2603 > 0f) {
                                            if ((bitcast<u32>(_e2603) & 2139095040u) != 2139095040u) {
                                                let _e2608 = (1f / _e2603);
                                                let _e2610 = (_e2589[0] * _e2608);
                                                let _e2612 = (_e2589[1] * _e2608);
                                                let _e2614 = (_e2589[2] * _e2608);
                                                let _e2619 = (((_e2610 * _e2610) + (_e2612 * _e2612)) + (_e2614 * _e2614));
                                                if (_e2619 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4870_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2619 > 0f));
                                                } else {
                                                    phi_4813_ = type_14(0i, 5i);
                                                    phi_4816_ = bitcast<f32>(((bitcast<u32>(_e2619) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2627 = phi_4813_;
                                                        let _e2629 = phi_4816_;
                                                        local_20 = _e2629;
                                                        if (_e2627.member < _e2627.member_1) {
                                                            let _e2636 = (_e2627.member + 1i);
                                                            phi_4814_ = type_14(select(_e2636, type_15().member_1, select(false, true, ((false == (_e2636 > _e2627.member)) != false))), _e2627.member_1);
                                                            phi_4857_ = type_15(1u, _e2627.member);
                                                        } else {
                                                            phi_4814_ = _e2627;
                                                            phi_4857_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2647 = phi_4814_;
                                                        let _e2649 = phi_4857_;
                                                        let _e2652 = (bitcast<i32>(_e2649.member) != 0i);
                                                        if _e2652 {
                                                            phi_4817_ = (0.5f * (_e2629 + (_e2619 / _e2629)));
                                                        } else {
                                                            phi_4817_ = f32();
                                                        }
                                                        let _e2657 = phi_4817_;
                                                        continue;
                                                        continuing {
                                                            phi_4813_ = _e2647;
                                                            phi_4816_ = _e2657;
                                                            break if !(_e2652);
                                                        }
                                                    }
                                                    let _e2662 = local_20;
                                                    phi_4870_ = (_e2662 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2668 = phi_4870_;
                                                let _e2669 = (0.000000059604645f * 12f);
                                                let _e2674 = ((((((((select(_e2378, _e2359, (_e2359 > _e2378)) + _e2382) + (select(_e2421, _e2402, (_e2402 > _e2421)) + _e2425)) + (select(_e2464, _e2445, (_e2445 > _e2464)) + _e2468)) * (0.000000059604645f * 16f)) + (_e2475 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2668) * (1f + _e2669)));
                                                let _e2679 = (((_e2610 * _e2281[0]) + (_e2612 * _e2281[1])) + (_e2614 * _e2281[2]));
                                                let _e2684 = (((_e2610 * _e2297) + (_e2612 * _e2298)) + (_e2614 * _e2299));
                                                let _e2689 = (((_e2610 * (_e2281[0] - _e2293[0])) + (_e2612 * (_e2281[1] - _e2293[1]))) + (_e2614 * (_e2281[2] - _e2293[2])));
                                                let _e2694 = (((_e2610 * select((_e2297 - _e2293[0]), _e2281[0], _e2300)) + (_e2612 * select((_e2298 - _e2293[1]), _e2281[1], _e2300))) + (_e2614 * select((_e2299 - _e2293[2]), _e2281[2], _e2300)));
                                                let _e2700 = (((_e2610 * _e2312[0]) + (_e2612 * _e2312[1])) + (_e2614 * _e2312[2]));
                                                let _e2705 = (((_e2610 * _e2328) + (_e2612 * _e2329)) + (_e2614 * _e2330));
                                                let _e2710 = (((_e2610 * (_e2312[0] - _e2324[0])) + (_e2612 * (_e2312[1] - _e2324[1]))) + (_e2614 * (_e2312[2] - _e2324[2])));
                                                let _e2715 = (((_e2610 * select((_e2328 - _e2324[0]), _e2312[0], _e2331)) + (_e2612 * select((_e2329 - _e2324[1]), _e2312[1], _e2331))) + (_e2614 * select((_e2330 - _e2324[2]), _e2312[2], _e2331)));
                                                phi_4993_ = type_30(array<f32, 4>(_e2679, _e2684, _e2689, _e2694), array<f32, 4>(_e2700, _e2705, _e2710, _e2715), array<f32, 4>((_e2674 + ((select(_e2679, -(_e2679), (_e2679 < 0f)) + select(_e2700, -(_e2700), (_e2700 < 0f))) * _e2669)), (_e2674 + ((select(_e2684, -(_e2684), (_e2684 < 0f)) + select(_e2705, -(_e2705), (_e2705 < 0f))) * _e2669)), (_e2674 + ((select(_e2689, -(_e2689), (_e2689 < 0f)) + select(_e2710, -(_e2710), (_e2710 < 0f))) * _e2669)), (_e2674 + ((select(_e2694, -(_e2694), (_e2694 < 0f)) + select(_e2715, -(_e2715), (_e2715 < 0f))) * _e2669))));
                                                phi_4994_ = false;
                                            } else {
                                                phi_4993_ = type_30();
                                                phi_4994_ = true;
                                            }
                                            let _e2756 = phi_4993_;
                                            let _e2758 = phi_4994_;
                                            phi_4995_ = _e2756;
                                            phi_4996_ = _e2758;
                                        } else {
                                            phi_4995_ = type_30();
                                            phi_4996_ = true;
                                        }
                                        let _e2760 = phi_4995_;
                                        let _e2762 = phi_4996_;
                                        if _e2762 {
                                            phi_5004_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_5004_ = _e2760;
                                        }
                                        let _e2764 = phi_5004_;
                                        local_1 = type_30(array<f32, 4>(_e2764.member[0], _e2764.member[1], _e2764.member[2], _e2764.member[3]), array<f32, 4>(_e2764.member_1[0], _e2764.member_1[1], _e2764.member_1[2], _e2764.member_1[3]), array<f32, 4>(_e2764.member_2[0], _e2764.member_2[1], _e2764.member_2[2], _e2764.member_2[3]));
                                        let _e2784 = (_e2485 - _e2491);
                                        let _e2788 = local_1.member[0u];
                                        let _e2791 = local_1.member_1[0u];
                                        let _e2794 = local_1.member[0u];
                                        let _e2800 = local_1.member_2[0u];
                                        if (((_e2788 + ((_e2791 - _e2794) * _e2485)) - _e2800) > 0f) {
                                            let _e2805 = local_1.member[1u];
                                            let _e2808 = local_1.member_1[1u];
                                            let _e2811 = local_1.member[1u];
                                            let _e2817 = local_1.member_2[1u];
                                            if (((_e2805 + ((_e2808 - _e2811) * _e2485)) - _e2817) > 0f) {
                                                let _e2822 = local_1.member[2u];
                                                let _e2825 = local_1.member_1[2u];
                                                let _e2828 = local_1.member[2u];
                                                let _e2834 = local_1.member_2[2u];
                                                if (((_e2822 + ((_e2825 - _e2828) * _e2485)) - _e2834) > 0f) {
                                                    let _e2839 = local_1.member[3u];
                                                    let _e2842 = local_1.member_1[3u];
                                                    let _e2845 = local_1.member[3u];
                                                    let _e2851 = local_1.member_2[3u];
                                                    phi_5175_ = (((_e2839 + ((_e2842 - _e2845) * _e2485)) - _e2851) > 0f);
                                                    phi_5176_ = false;
                                                } else {
                                                    phi_5175_ = bool();
                                                    phi_5176_ = true;
                                                }
                                                let _e2855 = phi_5175_;
                                                let _e2857 = phi_5176_;
                                                phi_5177_ = _e2855;
                                                phi_5178_ = _e2857;
                                            } else {
                                                phi_5177_ = bool();
                                                phi_5178_ = true;
                                            }
                                            let _e2859 = phi_5177_;
                                            let _e2861 = phi_5178_;
                                            phi_5179_ = _e2859;
                                            phi_5180_ = _e2861;
                                        } else {
                                            phi_5179_ = bool();
                                            phi_5180_ = true;
                                        }
                                        let _e2863 = phi_5179_;
                                        let _e2865 = phi_5180_;
                                        if select(_e2863, false, _e2865) {
                                            if (_e2485 <= _e2487) {
                                                phi_5494_ = true;
                                            } else {
                                                let _e2870 = local.member[0u];
                                                let _e2873 = local.member_1[0u];
                                                let _e2876 = local.member[0u];
                                                let _e2882 = local.member_2[0u];
                                                let _e2886 = local_1.member[0u];
                                                let _e2889 = local_1.member_1[0u];
                                                let _e2892 = local_1.member[0u];
                                                let _e2898 = local_1.member_2[0u];
                                                if ((((_e2870 + ((_e2873 - _e2876) * _e2485)) - _e2882) + ((_e2886 + ((_e2889 - _e2892) * _e2491)) - _e2898)) > 0f) {
                                                    let _e2904 = local.member[1u];
                                                    let _e2907 = local.member_1[1u];
                                                    let _e2910 = local.member[1u];
                                                    let _e2916 = local.member_2[1u];
                                                    let _e2920 = local_1.member[1u];
                                                    let _e2923 = local_1.member_1[1u];
                                                    let _e2926 = local_1.member[1u];
                                                    let _e2932 = local_1.member_2[1u];
                                                    if ((((_e2904 + ((_e2907 - _e2910) * _e2485)) - _e2916) + ((_e2920 + ((_e2923 - _e2926) * _e2491)) - _e2932)) > 0f) {
                                                        let _e2938 = local.member[2u];
                                                        let _e2941 = local.member_1[2u];
                                                        let _e2944 = local.member[2u];
                                                        let _e2950 = local.member_2[2u];
                                                        let _e2954 = local_1.member[2u];
                                                        let _e2957 = local_1.member_1[2u];
                                                        let _e2960 = local_1.member[2u];
                                                        let _e2966 = local_1.member_2[2u];
                                                        if ((((_e2938 + ((_e2941 - _e2944) * _e2485)) - _e2950) + ((_e2954 + ((_e2957 - _e2960) * _e2491)) - _e2966)) > 0f) {
                                                            let _e2972 = local.member[3u];
                                                            let _e2975 = local.member_1[3u];
                                                            let _e2978 = local.member[3u];
                                                            let _e2984 = local.member_2[3u];
                                                            let _e2988 = local_1.member[3u];
                                                            let _e2991 = local_1.member_1[3u];
                                                            let _e2994 = local_1.member[3u];
                                                            let _e3000 = local_1.member_2[3u];
                                                            phi_5481_ = ((((_e2972 + ((_e2975 - _e2978) * _e2485)) - _e2984) + ((_e2988 + ((_e2991 - _e2994) * _e2491)) - _e3000)) > 0f);
                                                            phi_5482_ = false;
                                                        } else {
                                                            phi_5481_ = bool();
                                                            phi_5482_ = true;
                                                        }
                                                        let _e3005 = phi_5481_;
                                                        let _e3007 = phi_5482_;
                                                        phi_5483_ = _e3005;
                                                        phi_5484_ = _e3007;
                                                    } else {
                                                        phi_5483_ = bool();
                                                        phi_5484_ = true;
                                                    }
                                                    let _e3009 = phi_5483_;
                                                    let _e3011 = phi_5484_;
                                                    phi_5485_ = _e3009;
                                                    phi_5486_ = _e3011;
                                                } else {
                                                    phi_5485_ = bool();
                                                    phi_5486_ = true;
                                                }
                                                let _e3013 = phi_5485_;
                                                let _e3015 = phi_5486_;
                                                phi_5494_ = select(_e3013, false, _e3015);
                                            }
                                            let _e3018 = phi_5494_;
                                            if _e3018 {
                                                if select(true, select(true, false, (_e2485 >= _e2262.member_1)), _e2493) {
                                                    local = type_30(array<f32, 4>(_e2764.member[0], _e2764.member[1], _e2764.member[2], _e2764.member[3]), array<f32, 4>(_e2764.member_1[0], _e2764.member_1[1], _e2764.member_1[2], _e2764.member_1[3]), array<f32, 4>(_e2764.member_2[0], _e2764.member_2[1], _e2764.member_2[2], _e2764.member_2[3]));
                                                    let _e3043 = local.member[0u];
                                                    let _e3046 = local.member_1[0u];
                                                    let _e3049 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3046 > _e3049)), (_e3043 > _e3049)) {
                                                        let _e3054 = (_e3046 >= _e3043);
                                                        if _e3054 {
                                                            phi_5603_ = f32();
                                                            phi_5604_ = false;
                                                        } else {
                                                            if ((_e3043 - _e3046) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5601_ = (((_e3043 - _e3049) / (_e3043 - _e3046)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5602_ = false;
                                                            } else {
                                                                phi_5601_ = f32();
                                                                phi_5602_ = true;
                                                            }
                                                            let _e3065 = phi_5601_;
                                                            let _e3067 = phi_5602_;
                                                            phi_5603_ = _e3065;
                                                            phi_5604_ = _e3067;
                                                        }
                                                        let _e3069 = phi_5603_;
                                                        let _e3071 = phi_5604_;
                                                        phi_5605_ = _e3069;
                                                        phi_5606_ = _e3054;
                                                        phi_5607_ = _e3071;
                                                    } else {
                                                        phi_5605_ = f32();
                                                        phi_5606_ = true;
                                                        phi_5607_ = false;
                                                    }
                                                    let _e3073 = phi_5605_;
                                                    let _e3075 = phi_5606_;
                                                    let _e3077 = phi_5607_;
                                                    let _e3080 = select(_e3073, select(_e2485, 2f, _e3075), select(_e3077, true, _e3075));
                                                    let _e3083 = local.member[1u];
                                                    let _e3086 = local.member_1[1u];
                                                    let _e3089 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3086 > _e3089)), (_e3083 > _e3089)) {
                                                        let _e3094 = (_e3086 >= _e3083);
                                                        if _e3094 {
                                                            phi_5671_ = f32();
                                                            phi_5672_ = false;
                                                        } else {
                                                            if ((_e3083 - _e3086) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5669_ = (((_e3083 - _e3089) / (_e3083 - _e3086)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5670_ = false;
                                                            } else {
                                                                phi_5669_ = f32();
                                                                phi_5670_ = true;
                                                            }
                                                            let _e3105 = phi_5669_;
                                                            let _e3107 = phi_5670_;
                                                            phi_5671_ = _e3105;
                                                            phi_5672_ = _e3107;
                                                        }
                                                        let _e3109 = phi_5671_;
                                                        let _e3111 = phi_5672_;
                                                        phi_5673_ = _e3109;
                                                        phi_5674_ = _e3094;
                                                        phi_5675_ = _e3111;
                                                    } else {
                                                        phi_5673_ = f32();
                                                        phi_5674_ = true;
                                                        phi_5675_ = false;
                                                    }
                                                    let _e3113 = phi_5673_;
                                                    let _e3115 = phi_5674_;
                                                    let _e3117 = phi_5675_;
                                                    let _e3120 = select(_e3113, select(_e2485, 2f, _e3115), select(_e3117, true, _e3115));
                                                    let _e3122 = select(_e3120, _e3080, (_e3080 < _e3120));
                                                    let _e3125 = local.member[2u];
                                                    let _e3128 = local.member_1[2u];
                                                    let _e3131 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3128 > _e3131)), (_e3125 > _e3131)) {
                                                        let _e3136 = (_e3128 >= _e3125);
                                                        if _e3136 {
                                                            phi_5744_ = f32();
                                                            phi_5745_ = false;
                                                        } else {
                                                            if ((_e3125 - _e3128) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5742_ = (((_e3125 - _e3131) / (_e3125 - _e3128)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5743_ = false;
                                                            } else {
                                                                phi_5742_ = f32();
                                                                phi_5743_ = true;
                                                            }
                                                            let _e3147 = phi_5742_;
                                                            let _e3149 = phi_5743_;
                                                            phi_5744_ = _e3147;
                                                            phi_5745_ = _e3149;
                                                        }
                                                        let _e3151 = phi_5744_;
                                                        let _e3153 = phi_5745_;
                                                        phi_5746_ = _e3151;
                                                        phi_5747_ = _e3136;
                                                        phi_5748_ = _e3153;
                                                    } else {
                                                        phi_5746_ = f32();
                                                        phi_5747_ = true;
                                                        phi_5748_ = false;
                                                    }
                                                    let _e3155 = phi_5746_;
                                                    let _e3157 = phi_5747_;
                                                    let _e3159 = phi_5748_;
                                                    let _e3162 = select(_e3155, select(_e2485, 2f, _e3157), select(_e3159, true, _e3157));
                                                    let _e3165 = local.member[3u];
                                                    let _e3168 = local.member_1[3u];
                                                    let _e3171 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3168 > _e3171)), (_e3165 > _e3171)) {
                                                        let _e3176 = (_e3168 >= _e3165);
                                                        if _e3176 {
                                                            phi_5812_ = f32();
                                                            phi_5813_ = false;
                                                        } else {
                                                            if ((_e3165 - _e3168) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5810_ = (((_e3165 - _e3171) / (_e3165 - _e3168)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5811_ = false;
                                                            } else {
                                                                phi_5810_ = f32();
                                                                phi_5811_ = true;
                                                            }
                                                            let _e3187 = phi_5810_;
                                                            let _e3189 = phi_5811_;
                                                            phi_5812_ = _e3187;
                                                            phi_5813_ = _e3189;
                                                        }
                                                        let _e3191 = phi_5812_;
                                                        let _e3193 = phi_5813_;
                                                        phi_5814_ = _e3191;
                                                        phi_5815_ = _e3176;
                                                        phi_5816_ = _e3193;
                                                    } else {
                                                        phi_5814_ = f32();
                                                        phi_5815_ = true;
                                                        phi_5816_ = false;
                                                    }
                                                    let _e3195 = phi_5814_;
                                                    let _e3197 = phi_5815_;
                                                    let _e3199 = phi_5816_;
                                                    let _e3202 = select(_e3195, select(_e2485, 2f, _e3197), select(_e3199, true, _e3197));
                                                    let _e3204 = select(_e3202, _e3162, (_e3162 < _e3202));
                                                    let _e3206 = select(_e3204, _e3122, (_e3122 < _e3204));
                                                    let _e3208 = select(_e2485, _e3206, (_e3206 > _e2485));
                                                    let _e3209 = (_e3208 > _e2262.member_1);
                                                    if _e3209 {
                                                        phi_6345_ = f32();
                                                        phi_6346_ = f32();
                                                        phi_6347_ = false;
                                                    } else {
                                                        let _e3210 = (_e3208 - _e2485);
                                                        phi_6345_ = select((_e2262.member_1 - _e2485), select(0f, (_e2784 + _e2784), select(select(true, false, (_e3210 <= (_e2489 * 0.25f))), true, (_e3210 <= _e2480))), _e2493);
                                                        phi_6346_ = _e3210;
                                                        phi_6347_ = true;
                                                    }
                                                    let _e3221 = phi_6345_;
                                                    let _e3223 = phi_6346_;
                                                    let _e3225 = phi_6347_;
                                                    phi_6349_ = _e3208;
                                                    phi_6350_ = _e3221;
                                                    phi_6351_ = _e3223;
                                                    phi_6353_ = _e3225;
                                                    phi_6354_ = _e3209;
                                                    phi_6356_ = false;
                                                } else {
                                                    phi_6349_ = f32();
                                                    phi_6350_ = f32();
                                                    phi_6351_ = f32();
                                                    phi_6353_ = false;
                                                    phi_6354_ = false;
                                                    phi_6356_ = true;
                                                }
                                                let _e3227 = phi_6349_;
                                                let _e3229 = phi_6350_;
                                                let _e3231 = phi_6351_;
                                                let _e3233 = phi_6353_;
                                                let _e3235 = phi_6354_;
                                                let _e3237 = phi_6356_;
                                                phi_6357_ = _e3227;
                                                phi_6358_ = _e3229;
                                                phi_6359_ = _e3231;
                                                phi_6361_ = false;
                                                phi_6362_ = _e3233;
                                                phi_6363_ = _e3235;
                                                phi_6365_ = _e3237;
                                            } else {
                                                phi_6357_ = f32();
                                                phi_6358_ = f32();
                                                phi_6359_ = f32();
                                                phi_6361_ = true;
                                                phi_6362_ = false;
                                                phi_6363_ = false;
                                                phi_6365_ = false;
                                            }
                                            let _e3239 = phi_6357_;
                                            let _e3241 = phi_6358_;
                                            let _e3243 = phi_6359_;
                                            let _e3245 = phi_6361_;
                                            let _e3247 = phi_6362_;
                                            let _e3249 = phi_6363_;
                                            let _e3251 = phi_6365_;
                                            phi_6366_ = _e3239;
                                            phi_6367_ = _e3241;
                                            phi_6368_ = _e3243;
                                            phi_6370_ = _e3245;
                                            phi_6371_ = _e3247;
                                            phi_6372_ = _e3249;
                                            phi_6374_ = _e3251;
                                        } else {
                                            phi_6366_ = f32();
                                            phi_6367_ = f32();
                                            phi_6368_ = f32();
                                            phi_6370_ = true;
                                            phi_6371_ = false;
                                            phi_6372_ = false;
                                            phi_6374_ = false;
                                        }
                                        let _e3253 = phi_6366_;
                                        let _e3255 = phi_6367_;
                                        let _e3257 = phi_6368_;
                                        let _e3259 = phi_6370_;
                                        let _e3261 = phi_6371_;
                                        let _e3263 = phi_6372_;
                                        let _e3265 = phi_6374_;
                                        if _e3259 {
                                            if (_e2485 <= _e2487) {
                                                let _e3418 = (_e2495 + 1u);
                                                let _e3419 = (_e3418 > 3u);
                                                phi_6709_ = _e3418;
                                                phi_6710_ = f32();
                                                phi_6711_ = false;
                                                phi_6712_ = select(true, false, _e3419);
                                                phi_6713_ = _e3419;
                                            } else {
                                                let _e3269 = local.member[0u];
                                                let _e3272 = local.member_1[0u];
                                                let _e3275 = local.member[0u];
                                                let _e3281 = local.member_2[0u];
                                                let _e3282 = ((_e3269 + ((_e3272 - _e3275) * _e2491)) - _e3281);
                                                let _e3285 = local.member[1u];
                                                let _e3288 = local.member_1[1u];
                                                let _e3291 = local.member[1u];
                                                let _e3297 = local.member_2[1u];
                                                let _e3298 = ((_e3285 + ((_e3288 - _e3291) * _e2491)) - _e3297);
                                                let _e3300 = select(_e3298, _e3282, (_e3282 < _e3298));
                                                let _e3303 = local.member[2u];
                                                let _e3306 = local.member_1[2u];
                                                let _e3309 = local.member[2u];
                                                let _e3315 = local.member_2[2u];
                                                let _e3316 = ((_e3303 + ((_e3306 - _e3309) * _e2491)) - _e3315);
                                                let _e3319 = local.member[3u];
                                                let _e3322 = local.member_1[3u];
                                                let _e3325 = local.member[3u];
                                                let _e3331 = local.member_2[3u];
                                                let _e3332 = ((_e3319 + ((_e3322 - _e3325) * _e2491)) - _e3331);
                                                let _e3334 = select(_e3332, _e3316, (_e3316 < _e3332));
                                                let _e3336 = select(_e3334, _e3300, (_e3300 < _e3334));
                                                let _e3339 = local_1.member[0u];
                                                let _e3342 = local_1.member_1[0u];
                                                let _e3345 = local_1.member[0u];
                                                let _e3351 = local_1.member_2[0u];
                                                let _e3352 = ((_e3339 + ((_e3342 - _e3345) * _e2485)) - _e3351);
                                                let _e3355 = local_1.member[1u];
                                                let _e3358 = local_1.member_1[1u];
                                                let _e3361 = local_1.member[1u];
                                                let _e3367 = local_1.member_2[1u];
                                                let _e3368 = ((_e3355 + ((_e3358 - _e3361) * _e2485)) - _e3367);
                                                let _e3370 = select(_e3368, _e3352, (_e3352 < _e3368));
                                                let _e3373 = local_1.member[2u];
                                                let _e3376 = local_1.member_1[2u];
                                                let _e3379 = local_1.member[2u];
                                                let _e3385 = local_1.member_2[2u];
                                                let _e3386 = ((_e3373 + ((_e3376 - _e3379) * _e2485)) - _e3385);
                                                let _e3389 = local_1.member[3u];
                                                let _e3392 = local_1.member_1[3u];
                                                let _e3395 = local_1.member[3u];
                                                let _e3401 = local_1.member_2[3u];
                                                let _e3402 = ((_e3389 + ((_e3392 - _e3395) * _e2485)) - _e3401);
                                                let _e3404 = select(_e3402, _e3386, (_e3386 < _e3402));
                                                let _e3406 = select(_e3404, _e3370, (_e3370 < _e3404));
                                                if (_e3406 > 0f) {
                                                    phi_6707_ = 0.5f;
                                                } else {
                                                    let _e3410 = (0.95f * (_e3336 / (_e3336 - _e3406)));
                                                    phi_6707_ = select(0.0625f, select(0.9f, _e3410, (_e3410 < 0.9f)), (_e3410 > 0.0625f));
                                                }
                                                let _e3416 = phi_6707_;
                                                phi_6709_ = u32();
                                                phi_6710_ = (_e2784 * _e3416);
                                                phi_6711_ = true;
                                                phi_6712_ = false;
                                                phi_6713_ = false;
                                            }
                                            let _e3422 = phi_6709_;
                                            let _e3424 = phi_6710_;
                                            let _e3426 = phi_6711_;
                                            let _e3428 = phi_6712_;
                                            let _e3430 = phi_6713_;
                                            phi_6714_ = _e3422;
                                            phi_6715_ = _e2487;
                                            phi_6716_ = _e3424;
                                            phi_6717_ = _e2489;
                                            phi_6718_ = _e2491;
                                            phi_6719_ = _e2493;
                                            phi_6720_ = _e2495;
                                            phi_6721_ = _e3426;
                                            phi_6722_ = _e3428;
                                            phi_6723_ = _e3430;
                                            phi_6724_ = false;
                                            phi_6726_ = false;
                                        } else {
                                            phi_6714_ = u32();
                                            phi_6715_ = _e3253;
                                            phi_6716_ = _e3255;
                                            phi_6717_ = _e3257;
                                            phi_6718_ = _e2485;
                                            phi_6719_ = true;
                                            phi_6720_ = 0u;
                                            phi_6721_ = _e3261;
                                            phi_6722_ = false;
                                            phi_6723_ = false;
                                            phi_6724_ = _e3263;
                                            phi_6726_ = _e3265;
                                        }
                                        let _e3432 = phi_6714_;
                                        let _e3434 = phi_6715_;
                                        let _e3436 = phi_6716_;
                                        let _e3438 = phi_6717_;
                                        let _e3440 = phi_6718_;
                                        let _e3442 = phi_6719_;
                                        let _e3444 = phi_6720_;
                                        let _e3446 = phi_6721_;
                                        let _e3448 = phi_6722_;
                                        let _e3450 = phi_6723_;
                                        let _e3452 = phi_6724_;
                                        let _e3454 = phi_6726_;
                                        if _e3446 {
                                            let _e3455 = (_e3440 + _e3436);
                                            let _e3457 = select(_e3434, _e3455, (_e3455 > _e3434));
                                            let _e3459 = select(_e2262.member_1, _e3457, (_e3457 < _e2262.member_1));
                                            let _e3462 = select(((_e3459 - _e3440) > _e2480), true, !(_e2493));
                                            phi_6754_ = _e3459;
                                            phi_6755_ = _e3434;
                                            phi_6756_ = _e3438;
                                            phi_6757_ = _e3440;
                                            phi_6758_ = _e3442;
                                            phi_6759_ = _e3444;
                                            phi_6760_ = _e3462;
                                            phi_6761_ = select(true, false, _e3462);
                                            phi_6762_ = false;
                                            phi_6763_ = false;
                                            phi_6765_ = false;
                                        } else {
                                            phi_6754_ = _e2485;
                                            phi_6755_ = _e2487;
                                            phi_6756_ = _e2489;
                                            phi_6757_ = _e2491;
                                            phi_6758_ = _e2493;
                                            phi_6759_ = _e3432;
                                            phi_6760_ = _e3448;
                                            phi_6761_ = false;
                                            phi_6762_ = _e3450;
                                            phi_6763_ = _e3452;
                                            phi_6765_ = _e3454;
                                        }
                                        let _e3465 = phi_6754_;
                                        let _e3467 = phi_6755_;
                                        let _e3469 = phi_6756_;
                                        let _e3471 = phi_6757_;
                                        let _e3473 = phi_6758_;
                                        let _e3475 = phi_6759_;
                                        let _e3477 = phi_6760_;
                                        let _e3479 = phi_6761_;
                                        let _e3481 = phi_6762_;
                                        let _e3483 = phi_6763_;
                                        let _e3485 = phi_6765_;
                                        phi_4587_ = _e3465;
                                        phi_4589_ = _e3467;
                                        phi_4591_ = _e3469;
                                        phi_4593_ = _e3471;
                                        phi_4595_ = _e3473;
                                        phi_4597_ = _e3475;
                                        phi_6766_ = _e3434;
                                        phi_6768_ = _e3477;
                                        phi_6769_ = _e3479;
                                        phi_6770_ = _e3481;
                                        phi_6771_ = _e3483;
                                        phi_6773_ = false;
                                        phi_6774_ = _e3485;
                                    } else {
                                        phi_4587_ = f32();
                                        phi_4589_ = f32();
                                        phi_4591_ = f32();
                                        phi_4593_ = f32();
                                        phi_4595_ = bool();
                                        phi_4597_ = u32();
                                        phi_6766_ = f32();
                                        phi_6768_ = false;
                                        phi_6769_ = false;
                                        phi_6770_ = false;
                                        phi_6771_ = false;
                                        phi_6773_ = true;
                                        phi_6774_ = false;
                                    }
                                    let _e3487 = phi_4587_;
                                    let _e3489 = phi_4589_;
                                    let _e3491 = phi_4591_;
                                    let _e3493 = phi_4593_;
                                    let _e3495 = phi_4595_;
                                    let _e3497 = phi_4597_;
                                    let _e3499 = phi_6766_;
                                    let _e3501 = phi_6768_;
                                    let _e3503 = phi_6769_;
                                    let _e3505 = phi_6770_;
                                    let _e3507 = phi_6771_;
                                    let _e3509 = phi_6773_;
                                    let _e3511 = phi_6774_;
                                    local_21 = _e3503;
                                    local_22 = _e3505;
                                    local_23 = _e3503;
                                    local_24 = _e3507;
                                    local_25 = _e3503;
                                    local_26 = _e3509;
                                    local_27 = _e3503;
                                    local_28 = _e3511;
                                    local_30 = _e3503;
                                    local_31 = _e3499;
                                    continue;
                                    continuing {
                                        phi_4583_ = type_9(select(_e2483.member, (_e2483.member + 1u), _e2498), select(_e2483.member_1, _e2483.member_1, _e2498));
                                        phi_4586_ = _e3487;
                                        phi_4588_ = _e3489;
                                        phi_4590_ = _e3491;
                                        phi_4592_ = _e3493;
                                        phi_4594_ = _e3495;
                                        phi_4596_ = _e3497;
                                        break if !(_e3501);
                                    }
                                }
                                let _e3514 = local_21;
                                let _e3516 = local_22;
                                let _e3517 = select(_e3516, false, _e3514);
                                let _e3519 = local_23;
                                let _e3521 = local_24;
                                let _e3524 = local_25;
                                let _e3526 = local_26;
                                let _e3529 = local_27;
                                let _e3531 = local_28;
                                let _e3537 = local_29;
                                let _e3539 = select(select(_e3521, false, _e3519), false, _e3517);
                                let _e3541 = local_30;
                                let _e3548 = select(select(_e3541, false, _e3517), false, _e3539);
                                let _e3553 = local_31;
                                let _e3555 = local_32;
                                let _e3557 = select(select(select(select(_e3526, false, _e3524), false, _e3517), false, _e3539), true, _e3548);
                                let _e3564 = select(select(select(select(select(_e3531, false, _e3529), false, _e3517), false, _e3539), false, _e3548), false, _e3557);
                                let _e3569 = select(select(select(select(_e3517, true, _e3539), false, _e3548), false, _e3557), true, _e3564);
                                let _e3572 = (select(select(type_33().member, 1u, _e3557), select(select(select(type_33().member, 1u, _e3517), 0u, _e3539), 0u, _e3564), _e3569) != 0u);
                                phi_6842_ = select(select(type_33().member_1, select(_e3555, _e3553, _e3548), _e3557), select(select(select(type_33().member_1, _e3537, _e3517), type_33().member_1, _e3539), type_33().member_1, _e3564), _e3569);
                                phi_6843_ = select(true, false, _e3572);
                                phi_6844_ = _e3572;
                                phi_6845_ = false;
                                phi_6846_ = false;
                                phi_6847_ = false;
                            } else {
                                phi_6842_ = f32();
                                phi_6843_ = _e2270;
                                phi_6844_ = false;
                                phi_6845_ = _e2272;
                                phi_6846_ = _e2274;
                                phi_6847_ = _e2276;
                            }
                            let _e3575 = phi_6842_;
                            let _e3577 = phi_6843_;
                            let _e3579 = phi_6844_;
                            let _e3581 = phi_6845_;
                            let _e3583 = phi_6846_;
                            let _e3585 = phi_6847_;
                            phi_6848_ = _e2262;
                            phi_6849_ = _e2264;
                            phi_6850_ = _e3575;
                            phi_6851_ = _e2266;
                            phi_6852_ = _e3577;
                            phi_6853_ = _e3579;
                            phi_6854_ = false;
                            phi_6855_ = _e3581;
                            phi_6856_ = _e3583;
                            phi_6857_ = _e3585;
                        } else {
                            phi_6848_ = type_38();
                            phi_6849_ = bool();
                            phi_6850_ = f32();
                            phi_6851_ = type_38();
                            phi_6852_ = false;
                            phi_6853_ = false;
                            phi_6854_ = true;
                            phi_6855_ = false;
                            phi_6856_ = false;
                            phi_6857_ = false;
                        }
                        let _e3587 = phi_6848_;
                        let _e3589 = phi_6849_;
                        let _e3591 = phi_6850_;
                        let _e3593 = phi_6851_;
                        let _e3595 = phi_6852_;
                        let _e3597 = phi_6853_;
                        let _e3599 = phi_6854_;
                        let _e3601 = phi_6855_;
                        let _e3603 = phi_6856_;
                        let _e3605 = phi_6857_;
                        local_33 = _e3597;
                        local_34 = _e3589;
                        local_35 = _e3587;
                        local_36 = _e3591;
                        local_37 = _e3591;
                        local_38 = _e3591;
                        local_42 = _e3599;
                        local_43 = _e3601;
                        local_44 = _e3603;
                        local_45 = _e3605;
                        local_39 = _e3597;
                        local_40 = _e3593;
                        continue;
                        continuing {
                            phi_2728_ = type_9(select(_e1284.member, (_e1284.member + 1u), _e1287), select(_e1284.member_1, _e1284.member_1, _e1287));
                            break if !(_e3595);
                        }
                    }
                    let _e3608 = local_33;
                    if _e3608 {
                        let _e3610 = local_34;
                        if _e3610 {
                            let _e3612 = local_35;
                            let _e3615 = local_36;
                            let _e3617 = ((_e3612.member_1 - _e3615) <= _e1248);
                            let _e3622 = local_37;
                            phi_6873_ = type_33(select(type_33().member, 1u, _e3617), select(type_33().member_1, _e3622, _e3617));
                            phi_6874_ = select(true, false, _e3617);
                        } else {
                            phi_6873_ = type_33();
                            phi_6874_ = true;
                        }
                        let _e3627 = phi_6873_;
                        let _e3629 = phi_6874_;
                        let _e3634 = local_38;
                        phi_6880_ = type_33(select(_e3627.member, 2u, _e3629), select(_e3627.member_1, _e3634, _e3629));
                        phi_6881_ = false;
                        phi_6882_ = false;
                        phi_6883_ = false;
                        phi_6884_ = false;
                    } else {
                        phi_6880_ = type_33();
                        let _e4137 = local_42;
                        phi_6881_ = _e4137;
                        let _e4140 = local_43;
                        phi_6882_ = _e4140;
                        let _e4143 = local_44;
                        phi_6883_ = _e4143;
                        let _e4146 = local_45;
                        phi_6884_ = _e4146;
                    }
                    let _e3638 = phi_6880_;
                    let _e3640 = phi_6881_;
                    let _e3642 = phi_6882_;
                    let _e3644 = phi_6883_;
                    let _e3646 = phi_6884_;
                    let _e3653 = select(_e3642, false, _e3640);
                    let _e3657 = local_39;
                    let _e3664 = select(select(_e3644, false, _e3640), false, _e3653);
                    let _e3670 = select(select(select(_e3646, false, _e3640), false, _e3653), false, _e3664);
                    let _e3674 = local_40;
                    let _e3678 = select(select(_e3653, true, _e3664), true, _e3670);
                    phi_6926_ = type_33(select(_e3638.member, select(select(select(type_33().member, 0u, _e3653), 0u, _e3664), 1u, _e3670), _e3678), select(_e3638.member_1, select(select(select(type_33().member_1, type_33().member_1, _e3653), type_33().member_1, _e3664), _e3674.member, _e3670), _e3678));
                    phi_6927_ = type_33(select(type_33().member, 0u, _e3640), select(type_33().member_1, type_33().member_1, _e3640));
                    phi_6928_ = select(select(select(select(select(_e3657, false, _e3640), false, _e3653), false, _e3664), false, _e3670), true, _e3678);
                }
                let _e3689 = phi_6926_;
                let _e3691 = phi_6927_;
                let _e3693 = phi_6928_;
                let _e3696 = select(_e3691.member, _e3689.member, _e3693);
                let _e3699 = select(_e3691.member_1, _e3689.member_1, _e3693);
                let _e3705 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3699 > _e353)), (_e3696 == 1u))));
                switch bitcast<i32>(_e3696) {
                    case 0: {
                        phi_6972_ = type_31(0u, _e3705, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3709 = function_3(_e3699);
                        phi_6972_ = type_31(0u, _e3705, _e3709, true);
                        break;
                    }
                    case 2: {
                        let _e3707 = function_3(_e3699);
                        phi_6972_ = type_31(1u, _e3705, _e3707, true);
                        break;
                    }
                    default: {
                        phi_6972_ = type_31();
                        break;
                    }
                }
                let _e3713 = phi_6972_;
                let _e3717 = params.member.member.member_12;
                let _e3718 = bitcast<u32>(_e3717);
                if (_e3713.member_2[0] == select((_e3718 << bitcast<u32>(29i)), 0u, ((_e3718 & 2147483647u) < 8388608u))) {
                    let _e3728 = params.member.member.member_12;
                    let _e3729 = bitcast<u32>(_e3728);
                    let _e3730 = (_e3729 & 2147483647u);
                    phi_7012_ = (_e3713.member_2[1] == select(((_e3729 ^ _e3730) | ((_e3730 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3730 < 8388608u)));
                } else {
                    phi_7012_ = false;
                }
                let _e3740 = phi_7012_;
                let _e3742 = params.member.member.member_1;
                if ((_e3742 & 128u) != 0u) {
                    phi_7028_ = true;
                } else {
                    let _e3746 = params.member.member.member_1;
                    phi_7028_ = select(false, _e3740, ((_e3746 & 64u) != 0u));
                }
                let _e3751 = phi_7028_;
                local_8 = type_31(select(1u, _e3713.member, select(true, select(true, false, _e3751), _e3713.member_3)), _e3713.member_1, array<u32, 2>(_e3713.member_2[0], _e3713.member_2[1]), _e3713.member_3);
                phi_7055_ = type_9(_e182, _e185);
            } else {
                phi_7055_ = type_9(0u, 0u);
            }
            let _e3765 = phi_7055_;
            let _e3771 = local_8.member;
            let _e3773 = select(true, false, (_e3771 == 0u));
            let _e3775 = local_8.member_3;
            if _e3775 {
                if _e3773 {
                    phi_7084_ = true;
                } else {
                    let _e3777 = params.member.member.member_1;
                    phi_7084_ = ((_e3777 & 16u) != 0u);
                }
                let _e3781 = phi_7084_;
                phi_7085_ = _e3781;
            } else {
                phi_7085_ = false;
            }
            let _e3783 = phi_7085_;
            let _e3785 = local_8.member_3;
            if _e3785 {
                if _e3773 {
                } else {
                    let _e3787 = local_8.member_2;
                    let _e3791 = (_e3787[1] >> bitcast<u32>(20i));
                    let _e3805 = atomicMin((&earliest.member[0u]), select(((((_e3791 - 896u) << bitcast<u32>(23i)) | ((_e3787[1] & 1048575u) << bitcast<u32>(3i))) | (_e3787[0] >> bitcast<u32>(29i))), 0u, (_e3791 <= 896u)));
                }
            }
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3783 {
                let _e3809 = atomicAdd((&counters[0u]), 1u);
                phi_7128_ = _e3809;
            } else {
                phi_7128_ = 0u;
            }
            let _e3811 = phi_7128_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e3814 = atomicLoad((&counters[0u]));
                if (_e3814 > 0u) {
                    let _e3817 = atomicAdd((&contacts.member[0u]), _e3814);
                    atomicStore((&counters[1u]), _e3817);
                }
            }
            workgroupBarrier();
            let _e3820 = atomicLoad((&counters[1u]));
            let _e3821 = (_e3820 + _e3811);
            if _e3783 {
                let _e3823 = params.member.member_1.member_3;
                if (_e3821 < _e3823) {
                    let _e3829 = (7u * _e3821);
                    atomicStore((&contacts.member[(4u + _e3829)]), select(1u, 0u, ((_e3765.member_1 & 2147483648u) == 0u)));
                    let _e3834 = local_8.member;
                    atomicStore((&contacts.member[(_e3829 + 5u)]), _e3834);
                    atomicStore((&contacts.member[(_e3829 + 6u)]), _e3765.member);
                    atomicStore((&contacts.member[(_e3829 + 7u)]), (_e3765.member_1 & 2147483647u));
                    let _e3843 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e3829 + 8u)]), _e3843);
                    let _e3848 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e3829 + 9u)]), _e3848);
                    let _e3852 = local_8.member_1;
                    atomicStore((&contacts.member[(_e3829 + 10u)]), _e3852);
                }
            }
        }
        continue;
        continuing {
            phi_833_ = type_9(select(_e153.member, (_e153.member + 1u), _e156), select(_e153.member_1, _e153.member_1, _e156));
            break if !(_e169);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
