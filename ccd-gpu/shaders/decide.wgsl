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
    var phi_676_: array<array<f32, 3>, 4>;

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
        phi_676_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
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
        phi_676_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_676_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_304_: bool;
    var phi_337_: array<f32, 3>;
    var phi_338_: bool;
    var phi_339_: array<f32, 3>;
    var phi_340_: bool;
    var phi_345_: array<f32, 3>;

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
        phi_304_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_304_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_304_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_337_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_338_ = false;
        } else {
            phi_337_ = array<f32, 3>();
            phi_338_ = true;
        }
        let _e129 = phi_337_;
        let _e131 = phi_338_;
        phi_339_ = _e129;
        phi_340_ = _e131;
    } else {
        phi_339_ = array<f32, 3>();
        phi_340_ = true;
    }
    let _e133 = phi_339_;
    let _e135 = phi_340_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_345_ = _e136;
    } else {
        phi_345_ = _e133;
    }
    let _e138 = phi_345_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_36>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7294_: bool;
    var phi_7295_: bool;
    var phi_7300_: bool;

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
            phi_7294_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7295_ = select(true, false, _e84);
        } else {
            phi_7294_ = bool();
            phi_7295_ = true;
        }
        let _e91 = phi_7294_;
        let _e93 = phi_7295_;
        phi_7300_ = select(_e91, false, _e93);
    } else {
        phi_7300_ = false;
    }
    let _e96 = phi_7300_;
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
    var phi_786_: u32;
    var phi_831_: u32;
    var phi_834_: type_9;
    var phi_1008_: type_23;
    var phi_1143_: type_29;
    var phi_1634_: bool;
    var phi_1728_: type_32;
    var phi_1729_: bool;
    var phi_1730_: type_32;
    var phi_1731_: bool;
    var phi_1732_: type_32;
    var phi_1733_: bool;
    var phi_1738_: type_32;
    var phi_2430_: bool;
    var phi_2442_: f32;
    var phi_2513_: type_14;
    var phi_2516_: f32;
    var phi_2514_: type_14;
    var phi_2557_: type_15;
    var phi_2517_: f32;
    var local_9: f32;
    var phi_2570_: f32;
    var phi_2601_: type_9;
    var phi_2604_: u32;
    var phi_2671_: u32;
    var phi_2672_: u32;
    var phi_2605_: u32;
    var phi_2673_: u32;
    var phi_2729_: type_9;
    var phi_2885_: type_38;
    var phi_2886_: bool;
    var phi_2887_: type_38;
    var phi_2888_: bool;
    var phi_2919_: type_9;
    var phi_2922_: f32;
    var phi_2924_: f32;
    var phi_2926_: f32;
    var phi_3036_: bool;
    var phi_3043_: f32;
    var phi_3044_: bool;
    var phi_2923_: f32;
    var phi_2925_: f32;
    var phi_2927_: f32;
    var phi_3045_: f32;
    var phi_3046_: bool;
    var phi_3047_: bool;
    var local_10: bool;
    var local_11: f32;
    var local_12: f32;
    var phi_3052_: f32;
    var phi_3068_: type_9;
    var phi_3071_: f32;
    var phi_3136_: f32;
    var phi_3137_: bool;
    var phi_3138_: bool;
    var phi_3139_: bool;
    var phi_3140_: f32;
    var phi_3072_: f32;
    var phi_3141_: bool;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f32;
    var phi_3158_: f32;
    var phi_3160_: type_38;
    var phi_3997_: array<type_16, 4>;
    var phi_4017_: type_9;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var phi_4072_: bool;
    var phi_4073_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_4087_: u32;
    var phi_4088_: u32;
    var phi_4089_: bool;
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
    var phi_4131_: bool;
    var phi_4132_: type_38;
    var phi_4133_: bool;
    var phi_4134_: type_38;
    var phi_4135_: bool;
    var phi_4136_: bool;
    var phi_4137_: bool;
    var phi_4138_: bool;
    var phi_4139_: type_38;
    var phi_4140_: bool;
    var phi_4141_: type_38;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var phi_4146_: bool;
    var phi_4154_: type_38;
    var phi_4155_: bool;
    var phi_4156_: type_38;
    var phi_4157_: bool;
    var phi_4158_: bool;
    var phi_4159_: bool;
    var phi_4160_: bool;
    var phi_4161_: bool;
    var phi_4584_: type_9;
    var phi_4587_: f32;
    var phi_4589_: f32;
    var phi_4591_: f32;
    var phi_4593_: f32;
    var phi_4595_: bool;
    var phi_4597_: u32;
    var phi_4748_: array<f32, 3>;
    var phi_4814_: type_14;
    var phi_4817_: f32;
    var phi_4815_: type_14;
    var phi_4858_: type_15;
    var phi_4818_: f32;
    var local_20: f32;
    var phi_4871_: f32;
    var phi_4994_: type_30;
    var phi_4995_: bool;
    var phi_4996_: type_30;
    var phi_4997_: bool;
    var phi_5005_: type_30;
    var phi_5176_: bool;
    var phi_5177_: bool;
    var phi_5178_: bool;
    var phi_5179_: bool;
    var phi_5180_: bool;
    var phi_5181_: bool;
    var phi_5482_: bool;
    var phi_5483_: bool;
    var phi_5484_: bool;
    var phi_5485_: bool;
    var phi_5486_: bool;
    var phi_5487_: bool;
    var phi_5495_: bool;
    var phi_5602_: f32;
    var phi_5603_: bool;
    var phi_5604_: f32;
    var phi_5605_: bool;
    var phi_5606_: f32;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5670_: f32;
    var phi_5671_: bool;
    var phi_5672_: f32;
    var phi_5673_: bool;
    var phi_5674_: f32;
    var phi_5675_: bool;
    var phi_5676_: bool;
    var phi_5743_: f32;
    var phi_5744_: bool;
    var phi_5745_: f32;
    var phi_5746_: bool;
    var phi_5747_: f32;
    var phi_5748_: bool;
    var phi_5749_: bool;
    var phi_5811_: f32;
    var phi_5812_: bool;
    var phi_5813_: f32;
    var phi_5814_: bool;
    var phi_5815_: f32;
    var phi_5816_: bool;
    var phi_5817_: bool;
    var phi_6346_: f32;
    var phi_6347_: f32;
    var phi_6348_: bool;
    var phi_6350_: f32;
    var phi_6351_: f32;
    var phi_6352_: f32;
    var phi_6354_: bool;
    var phi_6355_: bool;
    var phi_6357_: bool;
    var phi_6358_: f32;
    var phi_6359_: f32;
    var phi_6360_: f32;
    var phi_6362_: bool;
    var phi_6363_: bool;
    var phi_6364_: bool;
    var phi_6366_: bool;
    var phi_6367_: f32;
    var phi_6368_: f32;
    var phi_6369_: f32;
    var phi_6371_: bool;
    var phi_6372_: bool;
    var phi_6373_: bool;
    var phi_6375_: bool;
    var phi_6708_: f32;
    var phi_6710_: u32;
    var phi_6711_: f32;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var phi_6714_: bool;
    var phi_6715_: u32;
    var phi_6716_: f32;
    var phi_6717_: f32;
    var phi_6718_: f32;
    var phi_6719_: f32;
    var phi_6720_: bool;
    var phi_6721_: u32;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var phi_6725_: bool;
    var phi_6727_: bool;
    var phi_6755_: f32;
    var phi_6756_: f32;
    var phi_6757_: f32;
    var phi_6758_: f32;
    var phi_6759_: bool;
    var phi_6760_: u32;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var phi_6763_: bool;
    var phi_6764_: bool;
    var phi_6766_: bool;
    var phi_4588_: f32;
    var phi_4590_: f32;
    var phi_4592_: f32;
    var phi_4594_: f32;
    var phi_4596_: bool;
    var phi_4598_: u32;
    var phi_6767_: f32;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6772_: bool;
    var phi_6774_: bool;
    var phi_6775_: bool;
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
    var phi_6843_: f32;
    var phi_6844_: bool;
    var phi_6845_: bool;
    var phi_6846_: bool;
    var phi_6847_: bool;
    var phi_6848_: bool;
    var phi_6849_: type_38;
    var phi_6850_: bool;
    var phi_6851_: f32;
    var phi_6852_: type_38;
    var phi_6853_: bool;
    var phi_6854_: bool;
    var phi_6855_: bool;
    var phi_6856_: bool;
    var phi_6857_: bool;
    var phi_6858_: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: type_38;
    var local_36: f32;
    var local_37: f32;
    var phi_6874_: type_33;
    var phi_6875_: bool;
    var local_38: f32;
    var phi_6881_: type_33;
    var phi_6882_: bool;
    var phi_6883_: bool;
    var phi_6884_: bool;
    var phi_6885_: bool;
    var local_39: bool;
    var local_40: type_38;
    var phi_6927_: type_33;
    var phi_6928_: type_33;
    var phi_6929_: bool;
    var phi_6973_: type_31;
    var phi_7013_: bool;
    var phi_7029_: bool;
    var phi_7056_: type_9;
    var phi_7085_: bool;
    var phi_7086_: bool;
    var phi_7130_: u32;
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
        phi_786_ = (_e123 - _e128);
    } else {
        phi_786_ = 0u;
    }
    let _e131 = phi_786_;
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
        phi_831_ = select(_e144, (_e144 + 1u), ((_e142 % _e116) > 0u));
    } else {
        phi_831_ = 0u;
    }
    let _e151 = phi_831_;
    phi_834_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_834_;
        let _e157 = (_e154.member < _e154.member_1);
        let _e170 = (bitcast<i32>(select(0u, 1u, _e157)) != 0i);
        if _e170 {
            let _e174 = (((_e113 + (select(type_9().member_1, _e154.member, _e157) * _e116)) * 64u) + _e102);
            local_8 = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
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
                    phi_1008_ = type_23(0u, array<u32, 4>(_e183, _e215, _e218, _e221));
                } else {
                    let _e194 = (2u * _e183);
                    let _e196 = elements.member[_e194];
                    let _e199 = elements.member[(_e194 + 1u)];
                    let _e200 = (2u * _e191);
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    phi_1008_ = type_23(1u, array<u32, 4>(_e196, _e199, _e202, _e205));
                }
                let _e225 = phi_1008_;
                let _e230 = paths.member[_e225.member_1[0]];
                let _e245 = paths.member[_e225.member_1[1]];
                let _e260 = paths.member[_e225.member_1[2]];
                let _e275 = paths.member[_e225.member_1[3]];
                let _e289 = params.member.member.member_4;
                if (_e225.member != 0u) {
                    phi_1143_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e230.member.x), (_e260.member.y - _e230.member.y), (_e260.member.z - _e230.member.z)), array<f32, 3>((_e260.member_1.x - _e230.member_1.x), (_e260.member_1.y - _e230.member_1.y), (_e260.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e245.member.x - _e230.member.x), (_e245.member.y - _e230.member.y), (_e245.member.z - _e230.member.z)), array<f32, 3>((_e245.member_1.x - _e230.member_1.x), (_e245.member_1.y - _e230.member_1.y), (_e245.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e275.member.x), (_e260.member.y - _e275.member.y), (_e260.member.z - _e275.member.z)), array<f32, 3>((_e260.member_1.x - _e275.member_1.x), (_e260.member_1.y - _e275.member_1.y), (_e260.member_1.z - _e275.member_1.z))), (_e289 + _e289));
                } else {
                    phi_1143_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e230.member.x - _e245.member.x), (_e230.member.y - _e245.member.y), (_e230.member.z - _e245.member.z)), array<f32, 3>((_e230.member_1.x - _e245.member_1.x), (_e230.member_1.y - _e245.member_1.y), (_e230.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e245.member.x), (_e260.member.y - _e245.member.y), (_e260.member.z - _e245.member.z)), array<f32, 3>((_e260.member_1.x - _e245.member_1.x), (_e260.member_1.y - _e245.member_1.y), (_e260.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e275.member.x - _e245.member.x), (_e275.member.y - _e245.member.y), (_e275.member.z - _e245.member.z)), array<f32, 3>((_e275.member_1.x - _e245.member_1.x), (_e275.member_1.y - _e245.member_1.y), (_e275.member_1.z - _e245.member_1.z))), (_e289 + _e289));
                }
                let _e350 = phi_1143_;
                let _e352 = params.member.member.member_11;
                let _e354 = params.member.member.member_12;
                let _e356 = params.member.member.member_13;
                let _e358 = params.member.member.member_13;
                let _e364 = select(_e350.member[0][0], -(_e350.member[0][0]), (_e350.member[0][0] < 0f));
                let _e368 = select(_e350.member[0][1], -(_e350.member[0][1]), (_e350.member[0][1] < 0f));
                let _e370 = select(_e368, _e364, (_e364 > _e368));
                let _e374 = select(_e350.member[0][2], -(_e350.member[0][2]), (_e350.member[0][2] < 0f));
                let _e376 = select(_e374, _e370, (_e370 > _e374));
                let _e382 = select(_e350.member[1][0], -(_e350.member[1][0]), (_e350.member[1][0] < 0f));
                let _e386 = select(_e350.member[1][1], -(_e350.member[1][1]), (_e350.member[1][1] < 0f));
                let _e388 = select(_e386, _e382, (_e382 > _e386));
                let _e392 = select(_e350.member[1][2], -(_e350.member[1][2]), (_e350.member[1][2] < 0f));
                let _e394 = select(_e392, _e388, (_e388 > _e392));
                let _e398 = (select(_e394, _e376, (_e376 > _e394)) + _e350.member_3);
                let _e404 = select(_e350.member_1[0][0], -(_e350.member_1[0][0]), (_e350.member_1[0][0] < 0f));
                let _e408 = select(_e350.member_1[0][1], -(_e350.member_1[0][1]), (_e350.member_1[0][1] < 0f));
                let _e410 = select(_e408, _e404, (_e404 > _e408));
                let _e414 = select(_e350.member_1[0][2], -(_e350.member_1[0][2]), (_e350.member_1[0][2] < 0f));
                let _e416 = select(_e414, _e410, (_e410 > _e414));
                let _e422 = select(_e350.member_1[1][0], -(_e350.member_1[1][0]), (_e350.member_1[1][0] < 0f));
                let _e426 = select(_e350.member_1[1][1], -(_e350.member_1[1][1]), (_e350.member_1[1][1] < 0f));
                let _e428 = select(_e426, _e422, (_e422 > _e426));
                let _e432 = select(_e350.member_1[1][2], -(_e350.member_1[1][2]), (_e350.member_1[1][2] < 0f));
                let _e434 = select(_e432, _e428, (_e428 > _e432));
                let _e438 = (select(_e434, _e416, (_e416 > _e434)) + _e350.member_3);
                let _e444 = select(_e350.member_2[0][0], -(_e350.member_2[0][0]), (_e350.member_2[0][0] < 0f));
                let _e448 = select(_e350.member_2[0][1], -(_e350.member_2[0][1]), (_e350.member_2[0][1] < 0f));
                let _e450 = select(_e448, _e444, (_e444 > _e448));
                let _e454 = select(_e350.member_2[0][2], -(_e350.member_2[0][2]), (_e350.member_2[0][2] < 0f));
                let _e456 = select(_e454, _e450, (_e450 > _e454));
                let _e462 = select(_e350.member_2[1][0], -(_e350.member_2[1][0]), (_e350.member_2[1][0] < 0f));
                let _e466 = select(_e350.member_2[1][1], -(_e350.member_2[1][1]), (_e350.member_2[1][1] < 0f));
                let _e468 = select(_e466, _e462, (_e462 > _e466));
                let _e472 = select(_e350.member_2[1][2], -(_e350.member_2[1][2]), (_e350.member_2[1][2] < 0f));
                let _e474 = select(_e472, _e468, (_e468 > _e472));
                let _e478 = (select(_e474, _e456, (_e456 > _e474)) + _e350.member_3);
                let _e480 = select(_e438, _e398, (_e398 > _e438));
                let _e482 = select(_e478, _e480, (_e480 > _e478));
                let _e488 = select(_e350.member[0][0], -(_e350.member[0][0]), (_e350.member[0][0] < 0f));
                let _e492 = select(_e350.member[0][1], -(_e350.member[0][1]), (_e350.member[0][1] < 0f));
                let _e494 = select(_e492, _e488, (_e488 > _e492));
                let _e498 = select(_e350.member[0][2], -(_e350.member[0][2]), (_e350.member[0][2] < 0f));
                let _e500 = select(_e498, _e494, (_e494 > _e498));
                let _e506 = select(_e350.member[1][0], -(_e350.member[1][0]), (_e350.member[1][0] < 0f));
                let _e510 = select(_e350.member[1][1], -(_e350.member[1][1]), (_e350.member[1][1] < 0f));
                let _e512 = select(_e510, _e506, (_e506 > _e510));
                let _e516 = select(_e350.member[1][2], -(_e350.member[1][2]), (_e350.member[1][2] < 0f));
                let _e518 = select(_e516, _e512, (_e512 > _e516));
                let _e522 = (select(_e518, _e500, (_e500 > _e518)) + _e350.member_3);
                let _e528 = select(_e350.member_1[0][0], -(_e350.member_1[0][0]), (_e350.member_1[0][0] < 0f));
                let _e532 = select(_e350.member_1[0][1], -(_e350.member_1[0][1]), (_e350.member_1[0][1] < 0f));
                let _e534 = select(_e532, _e528, (_e528 > _e532));
                let _e538 = select(_e350.member_1[0][2], -(_e350.member_1[0][2]), (_e350.member_1[0][2] < 0f));
                let _e540 = select(_e538, _e534, (_e534 > _e538));
                let _e546 = select(_e350.member_1[1][0], -(_e350.member_1[1][0]), (_e350.member_1[1][0] < 0f));
                let _e550 = select(_e350.member_1[1][1], -(_e350.member_1[1][1]), (_e350.member_1[1][1] < 0f));
                let _e552 = select(_e550, _e546, (_e546 > _e550));
                let _e556 = select(_e350.member_1[1][2], -(_e350.member_1[1][2]), (_e350.member_1[1][2] < 0f));
                let _e558 = select(_e556, _e552, (_e552 > _e556));
                let _e562 = (select(_e558, _e540, (_e540 > _e558)) + _e350.member_3);
                let _e568 = select(_e350.member_2[0][0], -(_e350.member_2[0][0]), (_e350.member_2[0][0] < 0f));
                let _e572 = select(_e350.member_2[0][1], -(_e350.member_2[0][1]), (_e350.member_2[0][1] < 0f));
                let _e574 = select(_e572, _e568, (_e568 > _e572));
                let _e578 = select(_e350.member_2[0][2], -(_e350.member_2[0][2]), (_e350.member_2[0][2] < 0f));
                let _e580 = select(_e578, _e574, (_e574 > _e578));
                let _e586 = select(_e350.member_2[1][0], -(_e350.member_2[1][0]), (_e350.member_2[1][0] < 0f));
                let _e590 = select(_e350.member_2[1][1], -(_e350.member_2[1][1]), (_e350.member_2[1][1] < 0f));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e596 = select(_e350.member_2[1][2], -(_e350.member_2[1][2]), (_e350.member_2[1][2] < 0f));
                let _e598 = select(_e596, _e592, (_e592 > _e596));
                let _e602 = (select(_e598, _e580, (_e580 > _e598)) + _e350.member_3);
                let _e604 = select(_e562, _e522, (_e522 > _e562));
                let _e606 = select(_e602, _e604, (_e604 > _e602));
                if (_e606 <= 65536f) {
                    phi_1634_ = (_e606 >= (1f / 65536f));
                } else {
                    phi_1634_ = false;
                }
                let _e611 = phi_1634_;
                if _e611 {
                    phi_1732_ = type_32();
                    phi_1733_ = true;
                } else {
                    if (_e482 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e482) & 2139095040u) != 2139095040u) {
                            let _e618 = (2130706432u - (bitcast<u32>(_e482) & 2139095040u));
                            let _e621 = bitcast<f32>(select(8388608u, _e618, (_e618 > 8388608u)));
                            phi_1728_ = type_32(type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e350.member[0][0] * _e621), (_e350.member[0][1] * _e621), (_e350.member[0][2] * _e621)), array<f32, 3>((_e350.member[1][0] * _e621), (_e350.member[1][1] * _e621), (_e350.member[1][2] * _e621))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_1[0][0] * _e621), (_e350.member_1[0][1] * _e621), (_e350.member_1[0][2] * _e621)), array<f32, 3>((_e350.member_1[1][0] * _e621), (_e350.member_1[1][1] * _e621), (_e350.member_1[1][2] * _e621))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_2[0][0] * _e621), (_e350.member_2[0][1] * _e621), (_e350.member_2[0][2] * _e621)), array<f32, 3>((_e350.member_2[1][0] * _e621), (_e350.member_2[1][1] * _e621), (_e350.member_2[1][2] * _e621))), ((_e350.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e621)), (0f * _e621));
                            phi_1729_ = false;
                        } else {
                            phi_1728_ = type_32();
                            phi_1729_ = true;
                        }
                        let _e687 = phi_1728_;
                        let _e689 = phi_1729_;
                        phi_1730_ = _e687;
                        phi_1731_ = _e689;
                    } else {
                        phi_1730_ = type_32();
                        phi_1731_ = true;
                    }
                    let _e691 = phi_1730_;
                    let _e693 = phi_1731_;
                    phi_1732_ = _e691;
                    phi_1733_ = _e693;
                }
                let _e695 = phi_1732_;
                let _e697 = phi_1733_;
                if _e697 {
                    phi_1738_ = type_32(_e350, 0f);
                } else {
                    phi_1738_ = _e695;
                }
                let _e700 = phi_1738_;
                local_7 = type_29(array<array<f32, 3>, 2>(array<f32, 3>(_e700.member.member[0][0], _e700.member.member[0][1], _e700.member.member[0][2]), array<f32, 3>(_e700.member.member[1][0], _e700.member.member[1][1], _e700.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e700.member.member_1[0][0], _e700.member.member_1[0][1], _e700.member.member_1[0][2]), array<f32, 3>(_e700.member.member_1[1][0], _e700.member.member_1[1][1], _e700.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e700.member.member_2[0][0], _e700.member.member_2[0][1], _e700.member.member_2[0][2]), array<f32, 3>(_e700.member.member_2[1][0], _e700.member.member_2[1][1], _e700.member.member_2[1][2])), _e700.member.member_3);
                let _e742 = local_7.member_1[0u];
                let _e748 = local_7.member_2[0u];
                let _e754 = ((_e742[1] * _e748[2]) - (_e742[2] * _e748[1]));
                let _e757 = ((_e742[2] * _e748[0]) - (_e742[0] * _e748[2]));
                let _e760 = ((_e742[0] * _e748[1]) - (_e742[1] * _e748[0]));
                let _e763 = local_7.member_1[1u];
                let _e769 = local_7.member_2[1u];
                let _e775 = ((_e763[1] * _e769[2]) - (_e763[2] * _e769[1]));
                let _e778 = ((_e763[2] * _e769[0]) - (_e763[0] * _e769[2]));
                let _e781 = ((_e763[0] * _e769[1]) - (_e763[1] * _e769[0]));
                let _e784 = local_7.member_1[0u];
                let _e790 = local_7.member_2[1u];
                let _e805 = local_7.member_1[1u];
                let _e811 = local_7.member_2[0u];
                let _e824 = (((_e784[1] * _e790[2]) - (_e784[2] * _e790[1])) + ((_e805[1] * _e811[2]) - (_e805[2] * _e811[1])));
                let _e825 = (((_e784[2] * _e790[0]) - (_e784[0] * _e790[2])) + ((_e805[2] * _e811[0]) - (_e805[0] * _e811[2])));
                let _e826 = (((_e784[0] * _e790[1]) - (_e784[1] * _e790[0])) + ((_e805[0] * _e811[1]) - (_e805[1] * _e811[0])));
                let _e829 = local_7.member[0u];
                let _e837 = (((_e829[0] * _e754) + (_e829[1] * _e757)) + (_e829[2] * _e760));
                let _e840 = local_7.member[1u];
                let _e851 = local_7.member[0u];
                let _e860 = ((((_e840[0] * _e754) + (_e840[1] * _e757)) + (_e840[2] * _e760)) + (((_e851[0] * _e824) + (_e851[1] * _e825)) + (_e851[2] * _e826)));
                let _e863 = local_7.member[0u];
                let _e874 = local_7.member[1u];
                let _e883 = ((((_e863[0] * _e775) + (_e863[1] * _e778)) + (_e863[2] * _e781)) + (((_e874[0] * _e824) + (_e874[1] * _e825)) + (_e874[2] * _e826)));
                let _e886 = local_7.member[1u];
                let _e894 = (((_e886[0] * _e775) + (_e886[1] * _e778)) + (_e886[2] * _e781));
                let _e897 = local_7.member[0u];
                let _e903 = select(_e897[0], -(_e897[0]), (_e897[0] < 0f));
                let _e906 = select(_e897[1], -(_e897[1]), (_e897[1] < 0f));
                let _e908 = select(_e906, _e903, (_e903 > _e906));
                let _e911 = select(_e897[2], -(_e897[2]), (_e897[2] < 0f));
                let _e913 = select(_e911, _e908, (_e908 > _e911));
                let _e916 = local_7.member[1u];
                let _e922 = select(_e916[0], -(_e916[0]), (_e916[0] < 0f));
                let _e925 = select(_e916[1], -(_e916[1]), (_e916[1] < 0f));
                let _e927 = select(_e925, _e922, (_e922 > _e925));
                let _e930 = select(_e916[2], -(_e916[2]), (_e916[2] < 0f));
                let _e932 = select(_e930, _e927, (_e927 > _e930));
                let _e936 = local_7.member_3;
                let _e937 = (select(_e932, _e913, (_e913 > _e932)) + _e936);
                let _e940 = local_7.member_1[0u];
                let _e946 = select(_e940[0], -(_e940[0]), (_e940[0] < 0f));
                let _e949 = select(_e940[1], -(_e940[1]), (_e940[1] < 0f));
                let _e951 = select(_e949, _e946, (_e946 > _e949));
                let _e954 = select(_e940[2], -(_e940[2]), (_e940[2] < 0f));
                let _e956 = select(_e954, _e951, (_e951 > _e954));
                let _e959 = local_7.member_1[1u];
                let _e965 = select(_e959[0], -(_e959[0]), (_e959[0] < 0f));
                let _e968 = select(_e959[1], -(_e959[1]), (_e959[1] < 0f));
                let _e970 = select(_e968, _e965, (_e965 > _e968));
                let _e973 = select(_e959[2], -(_e959[2]), (_e959[2] < 0f));
                let _e975 = select(_e973, _e970, (_e970 > _e973));
                let _e979 = local_7.member_3;
                let _e980 = (select(_e975, _e956, (_e956 > _e975)) + _e979);
                let _e983 = local_7.member_2[0u];
                let _e989 = select(_e983[0], -(_e983[0]), (_e983[0] < 0f));
                let _e992 = select(_e983[1], -(_e983[1]), (_e983[1] < 0f));
                let _e994 = select(_e992, _e989, (_e989 > _e992));
                let _e997 = select(_e983[2], -(_e983[2]), (_e983[2] < 0f));
                let _e999 = select(_e997, _e994, (_e994 > _e997));
                let _e1002 = local_7.member_2[1u];
                let _e1008 = select(_e1002[0], -(_e1002[0]), (_e1002[0] < 0f));
                let _e1011 = select(_e1002[1], -(_e1002[1]), (_e1002[1] < 0f));
                let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                let _e1016 = select(_e1002[2], -(_e1002[2]), (_e1002[2] < 0f));
                let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                let _e1022 = local_7.member_3;
                let _e1023 = (select(_e1018, _e999, (_e999 > _e1018)) + _e1022);
                let _e1032 = local_7.member_3;
                let _e1047 = (((((_e937 * 8f) * ((_e980 * 8f) * _e1023)) * (0.000000059604645f * (524f / 64f))) + ((_e1032 * 19f) * ((_e937 * (_e980 + _e1023)) + (_e980 * _e1023)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e937) * ((1f + _e980) * (1f + _e1023)))));
                let _e1048 = (_e837 * 3f);
                let _e1049 = (_e894 * 3f);
                let _e1051 = select(_e1049, _e1048, (_e1048 < _e1049));
                let _e1053 = select(_e883, _e860, (_e860 < _e883));
                let _e1055 = select(_e1053, _e1051, (_e1051 < _e1053));
                let _e1057 = select(_e1049, _e1048, (_e1048 > _e1049));
                let _e1059 = select(_e883, _e860, (_e860 > _e883));
                let _e1062 = -(select(_e1059, _e1057, (_e1057 > _e1059)));
                if (select(_e1062, _e1055, (_e1055 > _e1062)) > _e1047) {
                    phi_6927_ = type_33(0u, type_33().member_1);
                    phi_6928_ = type_33();
                    phi_6929_ = true;
                } else {
                    let _e1069 = select(_e837, -(_e837), (_e837 < 0f));
                    let _e1072 = select(_e860, -(_e860), (_e860 < 0f));
                    let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                    let _e1077 = select(_e883, -(_e883), (_e883 < 0f));
                    let _e1080 = select(_e894, -(_e894), (_e894 < 0f));
                    let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                    let _e1084 = select(_e1082, _e1074, (_e1074 > _e1082));
                    let _e1085 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                    if (_e1084 >= _e1085) {
                        phi_2430_ = (_e1084 <= (1f / _e1085));
                    } else {
                        phi_2430_ = false;
                    }
                    let _e1090 = phi_2430_;
                    if _e1090 {
                        phi_2442_ = (1f / _e1084);
                    } else {
                        phi_2442_ = 0f;
                    }
                    let _e1097 = phi_2442_;
                    let _e1098 = (_e352 * 0.0625f);
                    local_5 = type_36(array<f32, 4>(_e837, _e860, _e883, _e894), ((_e1047 * 0.34f) + (_e1084 * select(2f, (0.000000059604645f * 256f), _e1090))), _e1097, select(_e1098, 0.00000000000022737368f, (0.00000000000022737368f < _e1098)));
                    let _e1105 = local_5.member[0u];
                    let _e1108 = local_5.member[1u];
                    let _e1111 = local_5.member[2u];
                    let _e1114 = local_5.member[3u];
                    let _e1121 = local_5.member_2;
                    let _e1122 = ((_e1108 - (3f * _e1105)) * _e1121);
                    let _e1124 = local_5.member_2;
                    let _e1125 = ((_e1111 - _e1108) * _e1124);
                    let _e1127 = local_5.member_2;
                    let _e1128 = (((3f * _e1114) - _e1111) * _e1127);
                    local_3[0u] = 0f;
                    local_3[1u] = 1f;
                    local_3[2u] = 1f;
                    local_3[3u] = 1f;
                    let _e1135 = ((_e1125 * _e1125) - (_e1122 * _e1128));
                    if (_e1135 > 0f) {
                        if (_e1135 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2570_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1135 > 0f));
                        } else {
                            phi_2513_ = type_14(0i, 5i);
                            phi_2516_ = bitcast<f32>(((bitcast<u32>(_e1135) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1144 = phi_2513_;
                                let _e1146 = phi_2516_;
                                local_9 = _e1146;
                                if (_e1144.member < _e1144.member_1) {
                                    let _e1153 = (_e1144.member + 1i);
                                    phi_2514_ = type_14(select(_e1153, type_15().member_1, select(false, true, ((false == (_e1153 > _e1144.member)) != false))), _e1144.member_1);
                                    phi_2557_ = type_15(1u, _e1144.member);
                                } else {
                                    phi_2514_ = _e1144;
                                    phi_2557_ = type_15(0u, type_15().member_1);
                                }
                                let _e1164 = phi_2514_;
                                let _e1166 = phi_2557_;
                                let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                                if _e1169 {
                                    phi_2517_ = (0.5f * (_e1146 + (_e1135 / _e1146)));
                                } else {
                                    phi_2517_ = f32();
                                }
                                let _e1174 = phi_2517_;
                                continue;
                                continuing {
                                    phi_2513_ = _e1164;
                                    phi_2516_ = _e1174;
                                    break if !(_e1169);
                                }
                            }
                            let _e1179 = local_9;
                            phi_2570_ = (_e1179 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1185 = phi_2570_;
                        let _e1190 = -((_e1125 + select(_e1185, -(_e1185), (_e1125 < 0f))));
                        local_4[0u] = (_e1190 / (_e1190 + _e1128));
                        local_4[1u] = (_e1122 / (_e1122 + _e1190));
                        let _e1199 = local_4[1u];
                        let _e1200 = local_4[0u];
                        if (_e1199 < _e1200) {
                            let _e1203 = local_4[1u];
                            let _e1205 = local_4[0u];
                            local_4[0u] = _e1203;
                            local_4[1u] = _e1205;
                        }
                        phi_2601_ = type_9(0u, 2u);
                        phi_2604_ = 1u;
                        loop {
                            let _e1209 = phi_2601_;
                            let _e1211 = phi_2604_;
                            local_41 = _e1211;
                            let _e1214 = (_e1209.member < _e1209.member_1);
                            let _e1225 = select(type_9().member_1, _e1209.member, _e1214);
                            let _e1227 = (bitcast<i32>(select(0u, 1u, _e1214)) != 0i);
                            if _e1227 {
                                let _e1229 = local_4[_e1225];
                                if (_e1229 > 0f) {
                                    let _e1232 = local_4[_e1225];
                                    if (_e1232 < 1f) {
                                        let _e1235 = local_4[_e1225];
                                        local_3[_e1211] = _e1235;
                                        phi_2671_ = (_e1211 + 1u);
                                    } else {
                                        phi_2671_ = _e1211;
                                    }
                                    let _e1239 = phi_2671_;
                                    phi_2672_ = _e1239;
                                } else {
                                    phi_2672_ = _e1211;
                                }
                                let _e1241 = phi_2672_;
                                phi_2605_ = _e1241;
                            } else {
                                phi_2605_ = u32();
                            }
                            let _e1243 = phi_2605_;
                            continue;
                            continuing {
                                phi_2601_ = type_9(select(_e1209.member, (_e1209.member + 1u), _e1214), select(_e1209.member_1, _e1209.member_1, _e1214));
                                phi_2604_ = _e1243;
                                break if !(_e1227);
                            }
                        }
                        let _e3886 = local_41;
                        phi_2673_ = _e3886;
                    } else {
                        phi_2673_ = 1u;
                    }
                    let _e1246 = phi_2673_;
                    local_3[_e1246] = 1f;
                    let _e1248 = local_3;
                    local_6 = _e1248;
                    let _e1249 = (_e352 * 0.99f);
                    let _e1250 = (1f - _e354);
                    let _e1253 = local_5.member[0u];
                    let _e1256 = local_5.member[1u];
                    let _e1259 = local_5.member[2u];
                    let _e1262 = local_5.member[3u];
                    let _e1273 = ((((_e1253 * _e1250) + (_e1256 * _e354)) * (_e1250 * _e1250)) + (((_e1259 * _e1250) + (_e1262 * _e354)) * (_e354 * _e354)));
                    let _e1278 = local_5.member_1;
                    phi_2729_ = type_9(select(1u, 0u, !((select(_e1273, -(_e1273), (_e1273 < 0f)) > _e1278))), (_e1246 + 1u));
                    loop {
                        let _e1285 = phi_2729_;
                        let _e1288 = (_e1285.member < _e1285.member_1);
                        let _e1299 = select(type_9().member_1, _e1285.member, _e1288);
                        if (bitcast<i32>(select(0u, 1u, _e1288)) != 0i) {
                            if (_e1299 > 0u) {
                                let _e1306 = local_6[(_e1299 - 1u)];
                                let _e1308 = select(_e354, _e1306, (_e1306 > _e354));
                                let _e1310 = local_6[_e1299];
                                let _e1312 = select(_e356, _e1310, (_e1310 < _e356));
                                if (_e1308 <= _e1312) {
                                    let _e1314 = function_4((&local_5), _e358, _e1308, _e1312);
                                    if _e1314 {
                                        phi_4132_ = type_38();
                                        phi_4133_ = bool();
                                        phi_4134_ = type_38();
                                        phi_4135_ = false;
                                        phi_4136_ = false;
                                        phi_4137_ = false;
                                        phi_4138_ = false;
                                    } else {
                                        let _e1315 = (1f - _e1308);
                                        let _e1318 = local_5.member[0u];
                                        let _e1321 = local_5.member[1u];
                                        let _e1324 = local_5.member[2u];
                                        let _e1327 = local_5.member[3u];
                                        let _e1338 = ((((_e1318 * _e1315) + (_e1321 * _e1308)) * (_e1315 * _e1315)) + (((_e1324 * _e1315) + (_e1327 * _e1308)) * (_e1308 * _e1308)));
                                        let _e1339 = (1f - _e1312);
                                        let _e1342 = local_5.member[0u];
                                        let _e1345 = local_5.member[1u];
                                        let _e1348 = local_5.member[2u];
                                        let _e1351 = local_5.member[3u];
                                        let _e1362 = ((((_e1342 * _e1339) + (_e1345 * _e1312)) * (_e1339 * _e1339)) + (((_e1348 * _e1339) + (_e1351 * _e1312)) * (_e1312 * _e1312)));
                                        let _e1367 = local_5.member_1;
                                        let _e1368 = (select(_e1338, -(_e1338), (_e1338 < 0f)) > _e1367);
                                        let _e1373 = local_5.member_1;
                                        let _e1374 = (select(_e1362, -(_e1362), (_e1362 < 0f)) > _e1373);
                                        let _e1382 = select(select(bool(), select(bool(), ((_e1338 > 0f) != (_e1362 > 0f)), _e1374), _e1368), false, select(true, select(true, false, _e1374), _e1368));
                                        if _e1368 {
                                            if _e1374 {
                                                phi_2885_ = type_38(select(1f, type_38().member, _e1382), select(0f, type_38().member_1, _e1382), select(_e1382, type_38().member_2, _e1382));
                                                phi_2886_ = _e1382;
                                            } else {
                                                phi_2885_ = type_38();
                                                phi_2886_ = true;
                                            }
                                            let _e1391 = phi_2885_;
                                            let _e1393 = phi_2886_;
                                            phi_2887_ = _e1391;
                                            phi_2888_ = _e1393;
                                        } else {
                                            phi_2887_ = type_38();
                                            phi_2888_ = true;
                                        }
                                        let _e1395 = phi_2887_;
                                        let _e1397 = phi_2888_;
                                        if _e1397 {
                                            if _e1368 {
                                                let _e1399 = select(1f, -1f, (_e1338 < 0f));
                                                let _e1401 = local_5.member_3;
                                                let _e1404 = local_5.member[0u];
                                                let _e1407 = local_5.member[1u];
                                                let _e1410 = local_5.member[2u];
                                                let _e1413 = local_5.member[3u];
                                                let _e1416 = (_e1410 - _e1407);
                                                phi_2919_ = type_9(0u, 64u);
                                                phi_2922_ = _e1312;
                                                phi_2924_ = _e1308;
                                                phi_2926_ = (0.5f * (_e1308 + _e1312));
                                                loop {
                                                    let _e1422 = phi_2919_;
                                                    let _e1424 = phi_2922_;
                                                    let _e1426 = phi_2924_;
                                                    let _e1428 = phi_2926_;
                                                    local_12 = _e1426;
                                                    let _e1431 = (_e1422.member < _e1422.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1431)) != 0i) {
                                                        let _e1443 = (1f - _e1428);
                                                        let _e1446 = local_5.member[0u];
                                                        let _e1449 = local_5.member[1u];
                                                        let _e1452 = local_5.member[2u];
                                                        let _e1455 = local_5.member[3u];
                                                        let _e1469 = local_5.member_1;
                                                        let _e1470 = ((_e1399 * ((((_e1446 * _e1443) + (_e1449 * _e1428)) * (_e1443 * _e1443)) + (((_e1452 * _e1443) + (_e1455 * _e1428)) * (_e1428 * _e1428)))) - _e1469);
                                                        let _e1471 = (_e1470 > 0f);
                                                        let _e1472 = select(_e1428, _e1424, _e1471);
                                                        let _e1473 = select(_e1426, _e1428, _e1471);
                                                        let _e1475 = ((_e1472 - _e1473) > _e1401);
                                                        if _e1475 {
                                                            let _e1476 = (1f - _e1428);
                                                            let _e1488 = (-(_e1470) / (_e1399 * (((((_e1407 - (3f * _e1404)) * _e1476) + (_e1416 * _e1428)) * _e1476) + (((_e1416 * _e1476) + (((3f * _e1413) - _e1410) * _e1428)) * _e1428))));
                                                            let _e1495 = ((_e1428 + _e1488) + select(-((0.5f * _e1401)), (0.5f * _e1401), (_e1470 > 0f)));
                                                            if (_e1495 > _e1473) {
                                                                phi_3036_ = select(true, select(true, false, (select(_e1488, -(_e1488), (_e1488 < 0f)) < (0.5f * (_e1472 - _e1473)))), (_e1495 < _e1472));
                                                            } else {
                                                                phi_3036_ = true;
                                                            }
                                                            let _e1507 = phi_3036_;
                                                            phi_3043_ = select(_e1495, (0.5f * (_e1473 + _e1472)), _e1507);
                                                            phi_3044_ = false;
                                                        } else {
                                                            phi_3043_ = f32();
                                                            phi_3044_ = true;
                                                        }
                                                        let _e1512 = phi_3043_;
                                                        let _e1514 = phi_3044_;
                                                        phi_2923_ = _e1472;
                                                        phi_2925_ = _e1473;
                                                        phi_2927_ = _e1512;
                                                        phi_3045_ = _e1473;
                                                        phi_3046_ = _e1475;
                                                        phi_3047_ = _e1514;
                                                    } else {
                                                        phi_2923_ = f32();
                                                        phi_2925_ = f32();
                                                        phi_2927_ = f32();
                                                        phi_3045_ = f32();
                                                        phi_3046_ = false;
                                                        phi_3047_ = false;
                                                    }
                                                    let _e1516 = phi_2923_;
                                                    let _e1518 = phi_2925_;
                                                    let _e1520 = phi_2927_;
                                                    let _e1522 = phi_3045_;
                                                    let _e1524 = phi_3046_;
                                                    let _e1526 = phi_3047_;
                                                    local_10 = _e1526;
                                                    local_11 = _e1522;
                                                    continue;
                                                    continuing {
                                                        phi_2919_ = type_9(select(_e1422.member, (_e1422.member + 1u), _e1431), select(_e1422.member_1, _e1422.member_1, _e1431));
                                                        phi_2922_ = _e1516;
                                                        phi_2924_ = _e1518;
                                                        phi_2926_ = _e1520;
                                                        break if !(_e1524);
                                                    }
                                                }
                                                let _e1529 = local_10;
                                                let _e1531 = local_11;
                                                let _e1533 = local_12;
                                                phi_3052_ = select(_e1533, _e1531, _e1529);
                                            } else {
                                                phi_3052_ = _e1308;
                                            }
                                            let _e1536 = phi_3052_;
                                            if _e1374 {
                                                let _e1540 = local_5.member_3;
                                                let _e1542 = local_5.member_3;
                                                phi_3068_ = type_9(0u, 64u);
                                                phi_3071_ = (_e1540 + _e1542);
                                                loop {
                                                    let _e1545 = phi_3068_;
                                                    let _e1547 = phi_3071_;
                                                    let _e1550 = (_e1545.member < _e1545.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1550)) != 0i) {
                                                        let _e1562 = (_e1536 + _e1547);
                                                        if (_e1562 < _e1312) {
                                                            let _e1564 = (1f - _e1562);
                                                            let _e1567 = local_5.member[0u];
                                                            let _e1570 = local_5.member[1u];
                                                            let _e1573 = local_5.member[2u];
                                                            let _e1576 = local_5.member[3u];
                                                            let _e1590 = local_5.member_1;
                                                            let _e1591 = ((select(1f, -1f, (_e1362 < 0f)) * ((((_e1567 * _e1564) + (_e1570 * _e1562)) * (_e1564 * _e1564)) + (((_e1573 * _e1564) + (_e1576 * _e1562)) * (_e1562 * _e1562)))) > _e1590);
                                                            phi_3136_ = select((_e1547 + _e1547), f32(), _e1591);
                                                            phi_3137_ = select(true, false, _e1591);
                                                            phi_3138_ = _e1591;
                                                            phi_3139_ = false;
                                                        } else {
                                                            phi_3136_ = f32();
                                                            phi_3137_ = false;
                                                            phi_3138_ = false;
                                                            phi_3139_ = true;
                                                        }
                                                        let _e1596 = phi_3136_;
                                                        let _e1598 = phi_3137_;
                                                        let _e1600 = phi_3138_;
                                                        let _e1602 = phi_3139_;
                                                        phi_3140_ = _e1562;
                                                        phi_3072_ = _e1596;
                                                        phi_3141_ = _e1598;
                                                        phi_3142_ = _e1600;
                                                        phi_3143_ = _e1602;
                                                        phi_3144_ = false;
                                                    } else {
                                                        phi_3140_ = f32();
                                                        phi_3072_ = f32();
                                                        phi_3141_ = false;
                                                        phi_3142_ = false;
                                                        phi_3143_ = false;
                                                        phi_3144_ = true;
                                                    }
                                                    let _e1604 = phi_3140_;
                                                    let _e1606 = phi_3072_;
                                                    let _e1608 = phi_3141_;
                                                    let _e1610 = phi_3142_;
                                                    let _e1612 = phi_3143_;
                                                    let _e1614 = phi_3144_;
                                                    local_13 = _e1610;
                                                    local_14 = _e1612;
                                                    local_15 = _e1610;
                                                    local_16 = _e1614;
                                                    local_17 = _e1604;
                                                    continue;
                                                    continuing {
                                                        phi_3068_ = type_9(select(_e1545.member, (_e1545.member + 1u), _e1550), select(_e1545.member_1, _e1545.member_1, _e1550));
                                                        phi_3071_ = _e1606;
                                                        break if !(_e1608);
                                                    }
                                                }
                                                let _e1617 = local_13;
                                                let _e1619 = local_14;
                                                let _e1622 = local_15;
                                                let _e1624 = local_16;
                                                let _e1628 = local_17;
                                                phi_3158_ = select(_e1628, _e1312, select(select(_e1624, false, _e1622), true, select(_e1619, false, _e1617)));
                                            } else {
                                                phi_3158_ = _e1312;
                                            }
                                            let _e1631 = phi_3158_;
                                            phi_3160_ = type_38(_e1536, _e1631, _e1382);
                                        } else {
                                            phi_3160_ = _e1395;
                                        }
                                        let _e1634 = phi_3160_;
                                        if (_e1634.member > _e1634.member_1) {
                                            phi_4127_ = bool();
                                            phi_4128_ = true;
                                            phi_4129_ = false;
                                            phi_4130_ = false;
                                            phi_4131_ = false;
                                        } else {
                                            let _e1639 = (_e1634.member > _e358);
                                            if _e1639 {
                                                phi_4123_ = bool();
                                                phi_4124_ = false;
                                                phi_4125_ = false;
                                                phi_4126_ = false;
                                            } else {
                                                let _e1643 = ((_e1634.member_1 - _e1634.member) * 0.5f);
                                                let _e1644 = (_e1634.member + _e1643);
                                                let _e1646 = (_e1643 + (0.000000059604645f * 4f));
                                                let _e1648 = local_7.member_3;
                                                let _e1651 = local_7.member[0u];
                                                let _e1657 = select(_e1651[0], -(_e1651[0]), (_e1651[0] < 0f));
                                                let _e1660 = select(_e1651[1], -(_e1651[1]), (_e1651[1] < 0f));
                                                let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                let _e1665 = select(_e1651[2], -(_e1651[2]), (_e1651[2] < 0f));
                                                let _e1667 = select(_e1665, _e1662, (_e1662 > _e1665));
                                                let _e1669 = local_7.member[1u];
                                                let _e1675 = select(_e1669[0], -(_e1669[0]), (_e1669[0] < 0f));
                                                let _e1678 = select(_e1669[1], -(_e1669[1]), (_e1669[1] < 0f));
                                                let _e1680 = select(_e1678, _e1675, (_e1675 > _e1678));
                                                let _e1683 = select(_e1669[2], -(_e1669[2]), (_e1669[2] < 0f));
                                                let _e1685 = select(_e1683, _e1680, (_e1680 > _e1683));
                                                let _e1690 = local_7.member[0u];
                                                let _e1695 = local_7.member[1u];
                                                let _e1705 = (_e1690[0] + ((_e1695[0] - _e1690[0]) * _e1644));
                                                let _e1706 = (_e1690[1] + ((_e1695[1] - _e1690[1]) * _e1644));
                                                let _e1707 = (_e1690[2] + ((_e1695[2] - _e1690[2]) * _e1644));
                                                let _e1709 = local_7.member[1u];
                                                let _e1714 = local_7.member[0u];
                                                let _e1718 = (_e1709[0] - _e1714[0]);
                                                let _e1719 = (_e1709[1] - _e1714[1]);
                                                let _e1720 = (_e1709[2] - _e1714[2]);
                                                let _e1723 = select(_e1718, -(_e1718), (_e1718 < 0f));
                                                let _e1726 = select(_e1719, -(_e1719), (_e1719 < 0f));
                                                let _e1728 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                let _e1731 = select(_e1720, -(_e1720), (_e1720 < 0f));
                                                let _e1739 = ((((_e1646 * select(_e1731, _e1728, (_e1728 > _e1731))) * 1.01f) + ((select(_e1685, _e1667, (_e1667 > _e1685)) + _e1648) * (0.000000059604645f * 8f))) + _e1648);
                                                let _e1742 = select(_e1705, -(_e1705), (_e1705 < 0f));
                                                let _e1745 = select(_e1706, -(_e1706), (_e1706 < 0f));
                                                let _e1747 = select(_e1745, _e1742, (_e1742 > _e1745));
                                                let _e1750 = select(_e1707, -(_e1707), (_e1707 < 0f));
                                                let _e1753 = (select(_e1750, _e1747, (_e1747 > _e1750)) + _e1739);
                                                let _e1756 = local_7.member_3;
                                                let _e1758 = local_7.member_1[0u];
                                                let _e1764 = select(_e1758[0], -(_e1758[0]), (_e1758[0] < 0f));
                                                let _e1767 = select(_e1758[1], -(_e1758[1]), (_e1758[1] < 0f));
                                                let _e1769 = select(_e1767, _e1764, (_e1764 > _e1767));
                                                let _e1772 = select(_e1758[2], -(_e1758[2]), (_e1758[2] < 0f));
                                                let _e1774 = select(_e1772, _e1769, (_e1769 > _e1772));
                                                let _e1776 = local_7.member_1[1u];
                                                let _e1782 = select(_e1776[0], -(_e1776[0]), (_e1776[0] < 0f));
                                                let _e1785 = select(_e1776[1], -(_e1776[1]), (_e1776[1] < 0f));
                                                let _e1787 = select(_e1785, _e1782, (_e1782 > _e1785));
                                                let _e1790 = select(_e1776[2], -(_e1776[2]), (_e1776[2] < 0f));
                                                let _e1792 = select(_e1790, _e1787, (_e1787 > _e1790));
                                                let _e1797 = local_7.member_1[0u];
                                                let _e1802 = local_7.member_1[1u];
                                                let _e1812 = (_e1797[0] + ((_e1802[0] - _e1797[0]) * _e1644));
                                                let _e1813 = (_e1797[1] + ((_e1802[1] - _e1797[1]) * _e1644));
                                                let _e1814 = (_e1797[2] + ((_e1802[2] - _e1797[2]) * _e1644));
                                                let _e1816 = local_7.member_1[1u];
                                                let _e1821 = local_7.member_1[0u];
                                                let _e1825 = (_e1816[0] - _e1821[0]);
                                                let _e1826 = (_e1816[1] - _e1821[1]);
                                                let _e1827 = (_e1816[2] - _e1821[2]);
                                                let _e1830 = select(_e1825, -(_e1825), (_e1825 < 0f));
                                                let _e1833 = select(_e1826, -(_e1826), (_e1826 < 0f));
                                                let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                let _e1838 = select(_e1827, -(_e1827), (_e1827 < 0f));
                                                let _e1846 = ((((_e1646 * select(_e1838, _e1835, (_e1835 > _e1838))) * 1.01f) + ((select(_e1792, _e1774, (_e1774 > _e1792)) + _e1756) * (0.000000059604645f * 8f))) + _e1756);
                                                let _e1849 = select(_e1812, -(_e1812), (_e1812 < 0f));
                                                let _e1852 = select(_e1813, -(_e1813), (_e1813 < 0f));
                                                let _e1854 = select(_e1852, _e1849, (_e1849 > _e1852));
                                                let _e1857 = select(_e1814, -(_e1814), (_e1814 < 0f));
                                                let _e1860 = (select(_e1857, _e1854, (_e1854 > _e1857)) + _e1846);
                                                let _e1863 = local_7.member_3;
                                                let _e1865 = local_7.member_2[0u];
                                                let _e1871 = select(_e1865[0], -(_e1865[0]), (_e1865[0] < 0f));
                                                let _e1874 = select(_e1865[1], -(_e1865[1]), (_e1865[1] < 0f));
                                                let _e1876 = select(_e1874, _e1871, (_e1871 > _e1874));
                                                let _e1879 = select(_e1865[2], -(_e1865[2]), (_e1865[2] < 0f));
                                                let _e1881 = select(_e1879, _e1876, (_e1876 > _e1879));
                                                let _e1883 = local_7.member_2[1u];
                                                let _e1889 = select(_e1883[0], -(_e1883[0]), (_e1883[0] < 0f));
                                                let _e1892 = select(_e1883[1], -(_e1883[1]), (_e1883[1] < 0f));
                                                let _e1894 = select(_e1892, _e1889, (_e1889 > _e1892));
                                                let _e1897 = select(_e1883[2], -(_e1883[2]), (_e1883[2] < 0f));
                                                let _e1899 = select(_e1897, _e1894, (_e1894 > _e1897));
                                                let _e1904 = local_7.member_2[0u];
                                                let _e1909 = local_7.member_2[1u];
                                                let _e1919 = (_e1904[0] + ((_e1909[0] - _e1904[0]) * _e1644));
                                                let _e1920 = (_e1904[1] + ((_e1909[1] - _e1904[1]) * _e1644));
                                                let _e1921 = (_e1904[2] + ((_e1909[2] - _e1904[2]) * _e1644));
                                                let _e1923 = local_7.member_2[1u];
                                                let _e1928 = local_7.member_2[0u];
                                                let _e1932 = (_e1923[0] - _e1928[0]);
                                                let _e1933 = (_e1923[1] - _e1928[1]);
                                                let _e1934 = (_e1923[2] - _e1928[2]);
                                                let _e1937 = select(_e1932, -(_e1932), (_e1932 < 0f));
                                                let _e1940 = select(_e1933, -(_e1933), (_e1933 < 0f));
                                                let _e1942 = select(_e1940, _e1937, (_e1937 > _e1940));
                                                let _e1945 = select(_e1934, -(_e1934), (_e1934 < 0f));
                                                let _e1953 = ((((_e1646 * select(_e1945, _e1942, (_e1942 > _e1945))) * 1.01f) + ((select(_e1899, _e1881, (_e1881 > _e1899)) + _e1863) * (0.000000059604645f * 8f))) + _e1863);
                                                let _e1956 = select(_e1919, -(_e1919), (_e1919 < 0f));
                                                let _e1959 = select(_e1920, -(_e1920), (_e1920 < 0f));
                                                let _e1961 = select(_e1959, _e1956, (_e1956 > _e1959));
                                                let _e1964 = select(_e1921, -(_e1921), (_e1921 < 0f));
                                                let _e1967 = (select(_e1964, _e1961, (_e1961 > _e1964)) + _e1953);
                                                let _e1970 = ((_e1813 * _e1921) - (_e1814 * _e1920));
                                                let _e1973 = ((_e1814 * _e1919) - (_e1812 * _e1921));
                                                let _e1976 = ((_e1812 * _e1920) - (_e1813 * _e1919));
                                                let _e1991 = select(false, (select(_e1970, -(_e1970), (_e1970 < 0f)) > select(_e1976, -(_e1976), (_e1976 < 0f))), (select(_e1970, -(_e1970), (_e1970 < 0f)) > select(_e1973, -(_e1973), (_e1973 < 0f))));
                                                let _e2006 = select((select(_e1973, -(_e1973), (_e1973 < 0f)) > select(_e1976, -(_e1976), (_e1976 < 0f))), false, (select(_e1970, -(_e1970), (_e1970 < 0f)) > select(_e1973, -(_e1973), (_e1973 < 0f))));
                                                let _e2009 = select(select(_e1705, _e1706, _e1991), _e1707, _e2006);
                                                let _e2010 = select(select(_e1706, _e1707, _e1991), _e1705, _e2006);
                                                let _e2013 = select(select(_e1812, _e1813, _e1991), _e1814, _e2006);
                                                let _e2014 = select(select(_e1813, _e1814, _e1991), _e1812, _e2006);
                                                let _e2017 = select(select(_e1919, _e1920, _e1991), _e1921, _e2006);
                                                let _e2018 = select(select(_e1920, _e1921, _e1991), _e1919, _e2006);
                                                let _e2021 = ((_e2013 * _e2018) - (_e2014 * _e2017));
                                                let _e2037 = (((((_e1846 * _e1967) + (_e1860 * _e1953)) * 2.01f) + (((_e1860 * 2f) * (_e1967 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1860) * (1f + _e1967))));
                                                if (select(_e2021, -(_e2021), (_e2021 < 0f)) > _e2037) {
                                                    let _e2043 = select(1f, -1f, (_e2021 < 0f));
                                                    let _e2062 = (((((_e1739 * _e1967) + (_e1753 * _e1953)) * 2.01f) + (((_e1753 * 2f) * (_e1967 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1753) * (1f + _e1967))));
                                                    let _e2081 = (((((_e1846 * _e1753) + (_e1860 * _e1739)) * 2.01f) + (((_e1860 * 2f) * (_e1753 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1860) * (1f + _e1753))));
                                                    let _e2082 = (_e2021 * _e2043);
                                                    let _e2083 = (((_e2009 * _e2018) - (_e2010 * _e2017)) * _e2043);
                                                    let _e2084 = (((_e2013 * _e2010) - (_e2014 * _e2009)) * _e2043);
                                                    let _e2097 = (((select(_e2082, -(_e2082), (_e2082 < 0f)) + select(_e2083, -(_e2083), (_e2083 < 0f))) + select(_e2084, -(_e2084), (_e2084 < 0f))) * (0.000000059604645f * 4f));
                                                    if (_e225.member != 0u) {
                                                        phi_3997_ = array<type_16, 4>(type_16(_e2083, _e2062), type_16(_e2084, _e2081), type_16((_e2082 - _e2083), ((_e2037 + _e2062) + _e2097)), type_16((_e2082 - _e2084), ((_e2037 + _e2081) + _e2097)));
                                                    } else {
                                                        let _e2100 = ((_e2082 - _e2083) - _e2084);
                                                        let _e2103 = (((_e2037 + _e2062) + _e2081) + _e2097);
                                                        phi_3997_ = array<type_16, 4>(type_16(_e2083, _e2062), type_16(_e2084, _e2081), type_16(_e2100, _e2103), type_16(_e2100, _e2103));
                                                    }
                                                    let _e2121 = phi_3997_;
                                                    local_2 = array<type_16, 4>(type_16(_e2121[0].member, _e2121[0].member_1), type_16(_e2121[1].member, _e2121[1].member_1), type_16(_e2121[2].member, _e2121[2].member_1), type_16(_e2121[3].member, _e2121[3].member_1));
                                                    phi_4017_ = type_9(0u, 4u);
                                                    phi_4020_ = true;
                                                    loop {
                                                        let _e2140 = phi_4017_;
                                                        let _e2142 = phi_4020_;
                                                        local_19 = _e2142;
                                                        let _e2145 = (_e2140.member < _e2140.member_1);
                                                        let _e2156 = select(type_9().member_1, _e2140.member, _e2145);
                                                        if (bitcast<i32>(select(0u, 1u, _e2145)) != 0i) {
                                                            let _e2161 = local_2[_e2156].member;
                                                            let _e2164 = local_2[_e2156].member_1;
                                                            let _e2166 = (_e2161 < -(_e2164));
                                                            phi_4021_ = select((_e2142 && (_e2161 > _e2164)), bool(), _e2166);
                                                            phi_4072_ = select(true, false, _e2166);
                                                            phi_4073_ = _e2166;
                                                        } else {
                                                            phi_4021_ = bool();
                                                            phi_4072_ = false;
                                                            phi_4073_ = false;
                                                        }
                                                        let _e2172 = phi_4021_;
                                                        let _e2174 = phi_4072_;
                                                        let _e2176 = phi_4073_;
                                                        local_18 = _e2176;
                                                        continue;
                                                        continuing {
                                                            phi_4017_ = type_9(select(_e2140.member, (_e2140.member + 1u), _e2145), select(_e2140.member_1, _e2140.member_1, _e2145));
                                                            phi_4020_ = _e2172;
                                                            break if !(_e2174);
                                                        }
                                                    }
                                                    let _e2179 = local_18;
                                                    let _e2180 = select(true, false, _e2179);
                                                    let _e2182 = local_19;
                                                    phi_4087_ = select(u32(), select(2u, 1u, _e2182), _e2180);
                                                    phi_4088_ = 0u;
                                                    phi_4089_ = select(true, false, _e2180);
                                                } else {
                                                    phi_4087_ = u32();
                                                    phi_4088_ = 2u;
                                                    phi_4089_ = true;
                                                }
                                                let _e2187 = phi_4087_;
                                                let _e2189 = phi_4088_;
                                                let _e2191 = phi_4089_;
                                                let _e2192 = select(_e2187, _e2189, _e2191);
                                                let _e2193 = (_e2192 == 0u);
                                                if _e2193 {
                                                    phi_4120_ = bool();
                                                    phi_4121_ = false;
                                                    phi_4122_ = false;
                                                } else {
                                                    let _e2196 = select(false, _e1634.member_2, (_e2192 == 1u));
                                                    let _e2202 = select(true, select(true, false, ((_e1634.member_1 - _e1634.member) <= _e1249)), _e2196);
                                                    phi_4120_ = _e2196;
                                                    phi_4121_ = _e2202;
                                                    phi_4122_ = select(true, false, _e2202);
                                                }
                                                let _e2205 = phi_4120_;
                                                let _e2207 = phi_4121_;
                                                let _e2209 = phi_4122_;
                                                phi_4123_ = _e2205;
                                                phi_4124_ = _e2193;
                                                phi_4125_ = _e2207;
                                                phi_4126_ = _e2209;
                                            }
                                            let _e2211 = phi_4123_;
                                            let _e2213 = phi_4124_;
                                            let _e2215 = phi_4125_;
                                            let _e2217 = phi_4126_;
                                            phi_4127_ = _e2211;
                                            phi_4128_ = _e2213;
                                            phi_4129_ = _e2215;
                                            phi_4130_ = _e1639;
                                            phi_4131_ = _e2217;
                                        }
                                        let _e2219 = phi_4127_;
                                        let _e2221 = phi_4128_;
                                        let _e2223 = phi_4129_;
                                        let _e2225 = phi_4130_;
                                        let _e2227 = phi_4131_;
                                        phi_4132_ = _e1634;
                                        phi_4133_ = _e2219;
                                        phi_4134_ = _e1634;
                                        phi_4135_ = _e2221;
                                        phi_4136_ = _e2223;
                                        phi_4137_ = _e2225;
                                        phi_4138_ = _e2227;
                                    }
                                    let _e2229 = phi_4132_;
                                    let _e2231 = phi_4133_;
                                    let _e2233 = phi_4134_;
                                    let _e2235 = phi_4135_;
                                    let _e2237 = phi_4136_;
                                    let _e2239 = phi_4137_;
                                    let _e2241 = phi_4138_;
                                    phi_4139_ = _e2229;
                                    phi_4140_ = _e2231;
                                    phi_4141_ = _e2233;
                                    phi_4142_ = _e2235;
                                    phi_4143_ = _e2237;
                                    phi_4144_ = _e1314;
                                    phi_4145_ = _e2239;
                                    phi_4146_ = _e2241;
                                } else {
                                    phi_4139_ = type_38();
                                    phi_4140_ = bool();
                                    phi_4141_ = type_38();
                                    phi_4142_ = true;
                                    phi_4143_ = false;
                                    phi_4144_ = false;
                                    phi_4145_ = false;
                                    phi_4146_ = false;
                                }
                                let _e2243 = phi_4139_;
                                let _e2245 = phi_4140_;
                                let _e2247 = phi_4141_;
                                let _e2249 = phi_4142_;
                                let _e2251 = phi_4143_;
                                let _e2253 = phi_4144_;
                                let _e2255 = phi_4145_;
                                let _e2257 = phi_4146_;
                                phi_4154_ = _e2243;
                                phi_4155_ = _e2245;
                                phi_4156_ = _e2247;
                                phi_4157_ = select(_e2251, false, _e2249);
                                phi_4158_ = _e2249;
                                phi_4159_ = select(_e2253, false, _e2249);
                                phi_4160_ = select(_e2255, false, _e2249);
                                phi_4161_ = select(_e2257, false, _e2249);
                            } else {
                                phi_4154_ = type_38(_e354, _e354, false);
                                phi_4155_ = false;
                                phi_4156_ = type_38();
                                phi_4157_ = true;
                                phi_4158_ = false;
                                phi_4159_ = false;
                                phi_4160_ = false;
                                phi_4161_ = false;
                            }
                            let _e2263 = phi_4154_;
                            let _e2265 = phi_4155_;
                            let _e2267 = phi_4156_;
                            let _e2269 = phi_4157_;
                            let _e2271 = phi_4158_;
                            let _e2273 = phi_4159_;
                            let _e2275 = phi_4160_;
                            let _e2277 = phi_4161_;
                            if _e2269 {
                                let _e2282 = local_7.member[0u];
                                let _e2288 = local_7.member_1[0u];
                                let _e2294 = local_7.member_2[0u];
                                let _e2298 = (_e2282[0] - _e2288[0]);
                                let _e2299 = (_e2282[1] - _e2288[1]);
                                let _e2300 = (_e2282[2] - _e2288[2]);
                                let _e2301 = (_e225.member == 0u);
                                let _e2313 = local_7.member[1u];
                                let _e2319 = local_7.member_1[1u];
                                let _e2325 = local_7.member_2[1u];
                                let _e2329 = (_e2313[0] - _e2319[0]);
                                let _e2330 = (_e2313[1] - _e2319[1]);
                                let _e2331 = (_e2313[2] - _e2319[2]);
                                let _e2332 = (_e225.member == 0u);
                                let _e2344 = local_7.member[0u];
                                let _e2350 = select(_e2344[0], -(_e2344[0]), (_e2344[0] < 0f));
                                let _e2353 = select(_e2344[1], -(_e2344[1]), (_e2344[1] < 0f));
                                let _e2355 = select(_e2353, _e2350, (_e2350 > _e2353));
                                let _e2358 = select(_e2344[2], -(_e2344[2]), (_e2344[2] < 0f));
                                let _e2360 = select(_e2358, _e2355, (_e2355 > _e2358));
                                let _e2363 = local_7.member[1u];
                                let _e2369 = select(_e2363[0], -(_e2363[0]), (_e2363[0] < 0f));
                                let _e2372 = select(_e2363[1], -(_e2363[1]), (_e2363[1] < 0f));
                                let _e2374 = select(_e2372, _e2369, (_e2369 > _e2372));
                                let _e2377 = select(_e2363[2], -(_e2363[2]), (_e2363[2] < 0f));
                                let _e2379 = select(_e2377, _e2374, (_e2374 > _e2377));
                                let _e2383 = local_7.member_3;
                                let _e2387 = local_7.member_1[0u];
                                let _e2393 = select(_e2387[0], -(_e2387[0]), (_e2387[0] < 0f));
                                let _e2396 = select(_e2387[1], -(_e2387[1]), (_e2387[1] < 0f));
                                let _e2398 = select(_e2396, _e2393, (_e2393 > _e2396));
                                let _e2401 = select(_e2387[2], -(_e2387[2]), (_e2387[2] < 0f));
                                let _e2403 = select(_e2401, _e2398, (_e2398 > _e2401));
                                let _e2406 = local_7.member_1[1u];
                                let _e2412 = select(_e2406[0], -(_e2406[0]), (_e2406[0] < 0f));
                                let _e2415 = select(_e2406[1], -(_e2406[1]), (_e2406[1] < 0f));
                                let _e2417 = select(_e2415, _e2412, (_e2412 > _e2415));
                                let _e2420 = select(_e2406[2], -(_e2406[2]), (_e2406[2] < 0f));
                                let _e2422 = select(_e2420, _e2417, (_e2417 > _e2420));
                                let _e2426 = local_7.member_3;
                                let _e2430 = local_7.member_2[0u];
                                let _e2436 = select(_e2430[0], -(_e2430[0]), (_e2430[0] < 0f));
                                let _e2439 = select(_e2430[1], -(_e2430[1]), (_e2430[1] < 0f));
                                let _e2441 = select(_e2439, _e2436, (_e2436 > _e2439));
                                let _e2444 = select(_e2430[2], -(_e2430[2]), (_e2430[2] < 0f));
                                let _e2446 = select(_e2444, _e2441, (_e2441 > _e2444));
                                let _e2449 = local_7.member_2[1u];
                                let _e2455 = select(_e2449[0], -(_e2449[0]), (_e2449[0] < 0f));
                                let _e2458 = select(_e2449[1], -(_e2449[1]), (_e2449[1] < 0f));
                                let _e2460 = select(_e2458, _e2455, (_e2455 > _e2458));
                                let _e2463 = select(_e2449[2], -(_e2449[2]), (_e2449[2] < 0f));
                                let _e2465 = select(_e2463, _e2460, (_e2460 > _e2463));
                                let _e2469 = local_7.member_3;
                                let _e2476 = local_7.member_3;
                                let _e2481 = (_e352 * 0.00390625f);
                                local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_4584_ = type_9(0u, 96u);
                                phi_4587_ = _e2263.member;
                                phi_4589_ = _e2263.member;
                                phi_4591_ = (_e2263.member_1 - _e2263.member);
                                phi_4593_ = _e2263.member;
                                phi_4595_ = false;
                                phi_4597_ = 0u;
                                loop {
                                    let _e2484 = phi_4584_;
                                    let _e2486 = phi_4587_;
                                    let _e2488 = phi_4589_;
                                    let _e2490 = phi_4591_;
                                    let _e2492 = phi_4593_;
                                    let _e2494 = phi_4595_;
                                    let _e2496 = phi_4597_;
                                    local_29 = _e2486;
                                    local_32 = _e2488;
                                    let _e2499 = (_e2484.member < _e2484.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2499)) != 0i) {
                                        let _e2513 = local_7.member[0u];
                                        let _e2519 = local_7.member[1u];
                                        let _e2535 = local_7.member_1[0u];
                                        let _e2541 = local_7.member_1[1u];
                                        let _e2557 = local_7.member_2[0u];
                                        let _e2563 = local_7.member_2[1u];
                                        let _e2577 = function_2(array<f32, 3>((_e2513[0] + ((_e2519[0] - _e2513[0]) * _e2486)), (_e2513[1] + ((_e2519[1] - _e2513[1]) * _e2486)), (_e2513[2] + ((_e2519[2] - _e2513[2]) * _e2486))), array<f32, 3>((_e2535[0] + ((_e2541[0] - _e2535[0]) * _e2486)), (_e2535[1] + ((_e2541[1] - _e2535[1]) * _e2486)), (_e2535[2] + ((_e2541[2] - _e2535[2]) * _e2486))), array<f32, 3>((_e2557[0] + ((_e2563[0] - _e2557[0]) * _e2486)), (_e2557[1] + ((_e2563[1] - _e2557[1]) * _e2486)), (_e2557[2] + ((_e2563[2] - _e2557[2]) * _e2486))), _e225.member);
                                        if (_e2496 == 0u) {
                                            phi_4748_ = _e2577;
                                        } else {
                                            phi_4748_ = array<f32, 3>(select(0f, _e2577[0], (_e2496 == 1u)), select(0f, _e2577[1], (_e2496 == 2u)), select(0f, _e2577[2], (_e2496 == 3u)));
                                        }
                                        let _e2590 = phi_4748_;
                                        let _e2604 = ((select(_e2590[0], -(_e2590[0]), (_e2590[0] < 0f)) + select(_e2590[1], -(_e2590[1]), (_e2590[1] < 0f))) + select(_e2590[2], -(_e2590[2]), (_e2590[2] < 0f)));
                                        if (_e2604 > 0f) {
                                            if ((bitcast<u32>(_e2604) & 2139095040u) != 2139095040u) {
                                                let _e2609 = (1f / _e2604);
                                                let _e2611 = (_e2590[0] * _e2609);
                                                let _e2613 = (_e2590[1] * _e2609);
                                                let _e2615 = (_e2590[2] * _e2609);
                                                let _e2620 = (((_e2611 * _e2611) + (_e2613 * _e2613)) + (_e2615 * _e2615));
                                                if (_e2620 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4871_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2620 > 0f));
                                                } else {
                                                    phi_4814_ = type_14(0i, 5i);
                                                    phi_4817_ = bitcast<f32>(((bitcast<u32>(_e2620) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2628 = phi_4814_;
                                                        let _e2630 = phi_4817_;
                                                        local_20 = _e2630;
                                                        if (_e2628.member < _e2628.member_1) {
                                                            let _e2637 = (_e2628.member + 1i);
                                                            phi_4815_ = type_14(select(_e2637, type_15().member_1, select(false, true, ((false == (_e2637 > _e2628.member)) != false))), _e2628.member_1);
                                                            phi_4858_ = type_15(1u, _e2628.member);
                                                        } else {
                                                            phi_4815_ = _e2628;
                                                            phi_4858_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2648 = phi_4815_;
                                                        let _e2650 = phi_4858_;
                                                        let _e2653 = (bitcast<i32>(_e2650.member) != 0i);
                                                        if _e2653 {
                                                            phi_4818_ = (0.5f * (_e2630 + (_e2620 / _e2630)));
                                                        } else {
                                                            phi_4818_ = f32();
                                                        }
                                                        let _e2658 = phi_4818_;
                                                        continue;
                                                        continuing {
                                                            phi_4814_ = _e2648;
                                                            phi_4817_ = _e2658;
                                                            break if !(_e2653);
                                                        }
                                                    }
                                                    let _e2663 = local_20;
                                                    phi_4871_ = (_e2663 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2669 = phi_4871_;
                                                let _e2670 = (0.000000059604645f * 12f);
                                                let _e2675 = ((((((((select(_e2379, _e2360, (_e2360 > _e2379)) + _e2383) + (select(_e2422, _e2403, (_e2403 > _e2422)) + _e2426)) + (select(_e2465, _e2446, (_e2446 > _e2465)) + _e2469)) * (0.000000059604645f * 16f)) + (_e2476 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2669) * (1f + _e2670)));
                                                let _e2680 = (((_e2611 * _e2282[0]) + (_e2613 * _e2282[1])) + (_e2615 * _e2282[2]));
                                                let _e2685 = (((_e2611 * _e2298) + (_e2613 * _e2299)) + (_e2615 * _e2300));
                                                let _e2690 = (((_e2611 * (_e2282[0] - _e2294[0])) + (_e2613 * (_e2282[1] - _e2294[1]))) + (_e2615 * (_e2282[2] - _e2294[2])));
                                                let _e2695 = (((_e2611 * select((_e2298 - _e2294[0]), _e2282[0], _e2301)) + (_e2613 * select((_e2299 - _e2294[1]), _e2282[1], _e2301))) + (_e2615 * select((_e2300 - _e2294[2]), _e2282[2], _e2301)));
                                                let _e2701 = (((_e2611 * _e2313[0]) + (_e2613 * _e2313[1])) + (_e2615 * _e2313[2]));
                                                let _e2706 = (((_e2611 * _e2329) + (_e2613 * _e2330)) + (_e2615 * _e2331));
                                                let _e2711 = (((_e2611 * (_e2313[0] - _e2325[0])) + (_e2613 * (_e2313[1] - _e2325[1]))) + (_e2615 * (_e2313[2] - _e2325[2])));
                                                let _e2716 = (((_e2611 * select((_e2329 - _e2325[0]), _e2313[0], _e2332)) + (_e2613 * select((_e2330 - _e2325[1]), _e2313[1], _e2332))) + (_e2615 * select((_e2331 - _e2325[2]), _e2313[2], _e2332)));
                                                phi_4994_ = type_30(array<f32, 4>(_e2680, _e2685, _e2690, _e2695), array<f32, 4>(_e2701, _e2706, _e2711, _e2716), array<f32, 4>((_e2675 + ((select(_e2680, -(_e2680), (_e2680 < 0f)) + select(_e2701, -(_e2701), (_e2701 < 0f))) * _e2670)), (_e2675 + ((select(_e2685, -(_e2685), (_e2685 < 0f)) + select(_e2706, -(_e2706), (_e2706 < 0f))) * _e2670)), (_e2675 + ((select(_e2690, -(_e2690), (_e2690 < 0f)) + select(_e2711, -(_e2711), (_e2711 < 0f))) * _e2670)), (_e2675 + ((select(_e2695, -(_e2695), (_e2695 < 0f)) + select(_e2716, -(_e2716), (_e2716 < 0f))) * _e2670))));
                                                phi_4995_ = false;
                                            } else {
                                                phi_4994_ = type_30();
                                                phi_4995_ = true;
                                            }
                                            let _e2757 = phi_4994_;
                                            let _e2759 = phi_4995_;
                                            phi_4996_ = _e2757;
                                            phi_4997_ = _e2759;
                                        } else {
                                            phi_4996_ = type_30();
                                            phi_4997_ = true;
                                        }
                                        let _e2761 = phi_4996_;
                                        let _e2763 = phi_4997_;
                                        if _e2763 {
                                            phi_5005_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_5005_ = _e2761;
                                        }
                                        let _e2765 = phi_5005_;
                                        local_1 = type_30(array<f32, 4>(_e2765.member[0], _e2765.member[1], _e2765.member[2], _e2765.member[3]), array<f32, 4>(_e2765.member_1[0], _e2765.member_1[1], _e2765.member_1[2], _e2765.member_1[3]), array<f32, 4>(_e2765.member_2[0], _e2765.member_2[1], _e2765.member_2[2], _e2765.member_2[3]));
                                        let _e2785 = (_e2486 - _e2492);
                                        let _e2789 = local_1.member[0u];
                                        let _e2792 = local_1.member_1[0u];
                                        let _e2795 = local_1.member[0u];
                                        let _e2801 = local_1.member_2[0u];
                                        if (((_e2789 + ((_e2792 - _e2795) * _e2486)) - _e2801) > 0f) {
                                            let _e2806 = local_1.member[1u];
                                            let _e2809 = local_1.member_1[1u];
                                            let _e2812 = local_1.member[1u];
                                            let _e2818 = local_1.member_2[1u];
                                            if (((_e2806 + ((_e2809 - _e2812) * _e2486)) - _e2818) > 0f) {
                                                let _e2823 = local_1.member[2u];
                                                let _e2826 = local_1.member_1[2u];
                                                let _e2829 = local_1.member[2u];
                                                let _e2835 = local_1.member_2[2u];
                                                if (((_e2823 + ((_e2826 - _e2829) * _e2486)) - _e2835) > 0f) {
                                                    let _e2840 = local_1.member[3u];
                                                    let _e2843 = local_1.member_1[3u];
                                                    let _e2846 = local_1.member[3u];
                                                    let _e2852 = local_1.member_2[3u];
                                                    phi_5176_ = (((_e2840 + ((_e2843 - _e2846) * _e2486)) - _e2852) > 0f);
                                                    phi_5177_ = false;
                                                } else {
                                                    phi_5176_ = bool();
                                                    phi_5177_ = true;
                                                }
                                                let _e2856 = phi_5176_;
                                                let _e2858 = phi_5177_;
                                                phi_5178_ = _e2856;
                                                phi_5179_ = _e2858;
                                            } else {
                                                phi_5178_ = bool();
                                                phi_5179_ = true;
                                            }
                                            let _e2860 = phi_5178_;
                                            let _e2862 = phi_5179_;
                                            phi_5180_ = _e2860;
                                            phi_5181_ = _e2862;
                                        } else {
                                            phi_5180_ = bool();
                                            phi_5181_ = true;
                                        }
                                        let _e2864 = phi_5180_;
                                        let _e2866 = phi_5181_;
                                        if select(_e2864, false, _e2866) {
                                            if (_e2486 <= _e2488) {
                                                phi_5495_ = true;
                                            } else {
                                                let _e2871 = local.member[0u];
                                                let _e2874 = local.member_1[0u];
                                                let _e2877 = local.member[0u];
                                                let _e2883 = local.member_2[0u];
                                                let _e2887 = local_1.member[0u];
                                                let _e2890 = local_1.member_1[0u];
                                                let _e2893 = local_1.member[0u];
                                                let _e2899 = local_1.member_2[0u];
                                                if ((((_e2871 + ((_e2874 - _e2877) * _e2486)) - _e2883) + ((_e2887 + ((_e2890 - _e2893) * _e2492)) - _e2899)) > 0f) {
                                                    let _e2905 = local.member[1u];
                                                    let _e2908 = local.member_1[1u];
                                                    let _e2911 = local.member[1u];
                                                    let _e2917 = local.member_2[1u];
                                                    let _e2921 = local_1.member[1u];
                                                    let _e2924 = local_1.member_1[1u];
                                                    let _e2927 = local_1.member[1u];
                                                    let _e2933 = local_1.member_2[1u];
                                                    if ((((_e2905 + ((_e2908 - _e2911) * _e2486)) - _e2917) + ((_e2921 + ((_e2924 - _e2927) * _e2492)) - _e2933)) > 0f) {
                                                        let _e2939 = local.member[2u];
                                                        let _e2942 = local.member_1[2u];
                                                        let _e2945 = local.member[2u];
                                                        let _e2951 = local.member_2[2u];
                                                        let _e2955 = local_1.member[2u];
                                                        let _e2958 = local_1.member_1[2u];
                                                        let _e2961 = local_1.member[2u];
                                                        let _e2967 = local_1.member_2[2u];
                                                        if ((((_e2939 + ((_e2942 - _e2945) * _e2486)) - _e2951) + ((_e2955 + ((_e2958 - _e2961) * _e2492)) - _e2967)) > 0f) {
                                                            let _e2973 = local.member[3u];
                                                            let _e2976 = local.member_1[3u];
                                                            let _e2979 = local.member[3u];
                                                            let _e2985 = local.member_2[3u];
                                                            let _e2989 = local_1.member[3u];
                                                            let _e2992 = local_1.member_1[3u];
                                                            let _e2995 = local_1.member[3u];
                                                            let _e3001 = local_1.member_2[3u];
                                                            phi_5482_ = ((((_e2973 + ((_e2976 - _e2979) * _e2486)) - _e2985) + ((_e2989 + ((_e2992 - _e2995) * _e2492)) - _e3001)) > 0f);
                                                            phi_5483_ = false;
                                                        } else {
                                                            phi_5482_ = bool();
                                                            phi_5483_ = true;
                                                        }
                                                        let _e3006 = phi_5482_;
                                                        let _e3008 = phi_5483_;
                                                        phi_5484_ = _e3006;
                                                        phi_5485_ = _e3008;
                                                    } else {
                                                        phi_5484_ = bool();
                                                        phi_5485_ = true;
                                                    }
                                                    let _e3010 = phi_5484_;
                                                    let _e3012 = phi_5485_;
                                                    phi_5486_ = _e3010;
                                                    phi_5487_ = _e3012;
                                                } else {
                                                    phi_5486_ = bool();
                                                    phi_5487_ = true;
                                                }
                                                let _e3014 = phi_5486_;
                                                let _e3016 = phi_5487_;
                                                phi_5495_ = select(_e3014, false, _e3016);
                                            }
                                            let _e3019 = phi_5495_;
                                            if _e3019 {
                                                if select(true, select(true, false, (_e2486 >= _e2263.member_1)), _e2494) {
                                                    local = type_30(array<f32, 4>(_e2765.member[0], _e2765.member[1], _e2765.member[2], _e2765.member[3]), array<f32, 4>(_e2765.member_1[0], _e2765.member_1[1], _e2765.member_1[2], _e2765.member_1[3]), array<f32, 4>(_e2765.member_2[0], _e2765.member_2[1], _e2765.member_2[2], _e2765.member_2[3]));
                                                    let _e3044 = local.member[0u];
                                                    let _e3047 = local.member_1[0u];
                                                    let _e3050 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3047 > _e3050)), (_e3044 > _e3050)) {
                                                        let _e3055 = (_e3047 >= _e3044);
                                                        if _e3055 {
                                                            phi_5604_ = f32();
                                                            phi_5605_ = false;
                                                        } else {
                                                            if ((_e3044 - _e3047) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5602_ = (((_e3044 - _e3050) / (_e3044 - _e3047)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5603_ = false;
                                                            } else {
                                                                phi_5602_ = f32();
                                                                phi_5603_ = true;
                                                            }
                                                            let _e3066 = phi_5602_;
                                                            let _e3068 = phi_5603_;
                                                            phi_5604_ = _e3066;
                                                            phi_5605_ = _e3068;
                                                        }
                                                        let _e3070 = phi_5604_;
                                                        let _e3072 = phi_5605_;
                                                        phi_5606_ = _e3070;
                                                        phi_5607_ = _e3055;
                                                        phi_5608_ = _e3072;
                                                    } else {
                                                        phi_5606_ = f32();
                                                        phi_5607_ = true;
                                                        phi_5608_ = false;
                                                    }
                                                    let _e3074 = phi_5606_;
                                                    let _e3076 = phi_5607_;
                                                    let _e3078 = phi_5608_;
                                                    let _e3081 = select(_e3074, select(_e2486, 2f, _e3076), select(_e3078, true, _e3076));
                                                    let _e3084 = local.member[1u];
                                                    let _e3087 = local.member_1[1u];
                                                    let _e3090 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3087 > _e3090)), (_e3084 > _e3090)) {
                                                        let _e3095 = (_e3087 >= _e3084);
                                                        if _e3095 {
                                                            phi_5672_ = f32();
                                                            phi_5673_ = false;
                                                        } else {
                                                            if ((_e3084 - _e3087) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5670_ = (((_e3084 - _e3090) / (_e3084 - _e3087)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5671_ = false;
                                                            } else {
                                                                phi_5670_ = f32();
                                                                phi_5671_ = true;
                                                            }
                                                            let _e3106 = phi_5670_;
                                                            let _e3108 = phi_5671_;
                                                            phi_5672_ = _e3106;
                                                            phi_5673_ = _e3108;
                                                        }
                                                        let _e3110 = phi_5672_;
                                                        let _e3112 = phi_5673_;
                                                        phi_5674_ = _e3110;
                                                        phi_5675_ = _e3095;
                                                        phi_5676_ = _e3112;
                                                    } else {
                                                        phi_5674_ = f32();
                                                        phi_5675_ = true;
                                                        phi_5676_ = false;
                                                    }
                                                    let _e3114 = phi_5674_;
                                                    let _e3116 = phi_5675_;
                                                    let _e3118 = phi_5676_;
                                                    let _e3121 = select(_e3114, select(_e2486, 2f, _e3116), select(_e3118, true, _e3116));
                                                    let _e3123 = select(_e3121, _e3081, (_e3081 < _e3121));
                                                    let _e3126 = local.member[2u];
                                                    let _e3129 = local.member_1[2u];
                                                    let _e3132 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3129 > _e3132)), (_e3126 > _e3132)) {
                                                        let _e3137 = (_e3129 >= _e3126);
                                                        if _e3137 {
                                                            phi_5745_ = f32();
                                                            phi_5746_ = false;
                                                        } else {
                                                            if ((_e3126 - _e3129) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5743_ = (((_e3126 - _e3132) / (_e3126 - _e3129)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5744_ = false;
                                                            } else {
                                                                phi_5743_ = f32();
                                                                phi_5744_ = true;
                                                            }
                                                            let _e3148 = phi_5743_;
                                                            let _e3150 = phi_5744_;
                                                            phi_5745_ = _e3148;
                                                            phi_5746_ = _e3150;
                                                        }
                                                        let _e3152 = phi_5745_;
                                                        let _e3154 = phi_5746_;
                                                        phi_5747_ = _e3152;
                                                        phi_5748_ = _e3137;
                                                        phi_5749_ = _e3154;
                                                    } else {
                                                        phi_5747_ = f32();
                                                        phi_5748_ = true;
                                                        phi_5749_ = false;
                                                    }
                                                    let _e3156 = phi_5747_;
                                                    let _e3158 = phi_5748_;
                                                    let _e3160 = phi_5749_;
                                                    let _e3163 = select(_e3156, select(_e2486, 2f, _e3158), select(_e3160, true, _e3158));
                                                    let _e3166 = local.member[3u];
                                                    let _e3169 = local.member_1[3u];
                                                    let _e3172 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3169 > _e3172)), (_e3166 > _e3172)) {
                                                        let _e3177 = (_e3169 >= _e3166);
                                                        if _e3177 {
                                                            phi_5813_ = f32();
                                                            phi_5814_ = false;
                                                        } else {
                                                            if ((_e3166 - _e3169) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5811_ = (((_e3166 - _e3172) / (_e3166 - _e3169)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5812_ = false;
                                                            } else {
                                                                phi_5811_ = f32();
                                                                phi_5812_ = true;
                                                            }
                                                            let _e3188 = phi_5811_;
                                                            let _e3190 = phi_5812_;
                                                            phi_5813_ = _e3188;
                                                            phi_5814_ = _e3190;
                                                        }
                                                        let _e3192 = phi_5813_;
                                                        let _e3194 = phi_5814_;
                                                        phi_5815_ = _e3192;
                                                        phi_5816_ = _e3177;
                                                        phi_5817_ = _e3194;
                                                    } else {
                                                        phi_5815_ = f32();
                                                        phi_5816_ = true;
                                                        phi_5817_ = false;
                                                    }
                                                    let _e3196 = phi_5815_;
                                                    let _e3198 = phi_5816_;
                                                    let _e3200 = phi_5817_;
                                                    let _e3203 = select(_e3196, select(_e2486, 2f, _e3198), select(_e3200, true, _e3198));
                                                    let _e3205 = select(_e3203, _e3163, (_e3163 < _e3203));
                                                    let _e3207 = select(_e3205, _e3123, (_e3123 < _e3205));
                                                    let _e3209 = select(_e2486, _e3207, (_e3207 > _e2486));
                                                    let _e3210 = (_e3209 > _e2263.member_1);
                                                    if _e3210 {
                                                        phi_6346_ = f32();
                                                        phi_6347_ = f32();
                                                        phi_6348_ = false;
                                                    } else {
                                                        let _e3211 = (_e3209 - _e2486);
                                                        phi_6346_ = select((_e2263.member_1 - _e2486), select(0f, (_e2785 + _e2785), select(select(true, false, (_e3211 <= (_e2490 * 0.25f))), true, (_e3211 <= _e2481))), _e2494);
                                                        phi_6347_ = _e3211;
                                                        phi_6348_ = true;
                                                    }
                                                    let _e3222 = phi_6346_;
                                                    let _e3224 = phi_6347_;
                                                    let _e3226 = phi_6348_;
                                                    phi_6350_ = _e3209;
                                                    phi_6351_ = _e3222;
                                                    phi_6352_ = _e3224;
                                                    phi_6354_ = _e3226;
                                                    phi_6355_ = _e3210;
                                                    phi_6357_ = false;
                                                } else {
                                                    phi_6350_ = f32();
                                                    phi_6351_ = f32();
                                                    phi_6352_ = f32();
                                                    phi_6354_ = false;
                                                    phi_6355_ = false;
                                                    phi_6357_ = true;
                                                }
                                                let _e3228 = phi_6350_;
                                                let _e3230 = phi_6351_;
                                                let _e3232 = phi_6352_;
                                                let _e3234 = phi_6354_;
                                                let _e3236 = phi_6355_;
                                                let _e3238 = phi_6357_;
                                                phi_6358_ = _e3228;
                                                phi_6359_ = _e3230;
                                                phi_6360_ = _e3232;
                                                phi_6362_ = false;
                                                phi_6363_ = _e3234;
                                                phi_6364_ = _e3236;
                                                phi_6366_ = _e3238;
                                            } else {
                                                phi_6358_ = f32();
                                                phi_6359_ = f32();
                                                phi_6360_ = f32();
                                                phi_6362_ = true;
                                                phi_6363_ = false;
                                                phi_6364_ = false;
                                                phi_6366_ = false;
                                            }
                                            let _e3240 = phi_6358_;
                                            let _e3242 = phi_6359_;
                                            let _e3244 = phi_6360_;
                                            let _e3246 = phi_6362_;
                                            let _e3248 = phi_6363_;
                                            let _e3250 = phi_6364_;
                                            let _e3252 = phi_6366_;
                                            phi_6367_ = _e3240;
                                            phi_6368_ = _e3242;
                                            phi_6369_ = _e3244;
                                            phi_6371_ = _e3246;
                                            phi_6372_ = _e3248;
                                            phi_6373_ = _e3250;
                                            phi_6375_ = _e3252;
                                        } else {
                                            phi_6367_ = f32();
                                            phi_6368_ = f32();
                                            phi_6369_ = f32();
                                            phi_6371_ = true;
                                            phi_6372_ = false;
                                            phi_6373_ = false;
                                            phi_6375_ = false;
                                        }
                                        let _e3254 = phi_6367_;
                                        let _e3256 = phi_6368_;
                                        let _e3258 = phi_6369_;
                                        let _e3260 = phi_6371_;
                                        let _e3262 = phi_6372_;
                                        let _e3264 = phi_6373_;
                                        let _e3266 = phi_6375_;
                                        if _e3260 {
                                            if (_e2486 <= _e2488) {
                                                let _e3419 = (_e2496 + 1u);
                                                let _e3420 = (_e3419 > 3u);
                                                phi_6710_ = _e3419;
                                                phi_6711_ = f32();
                                                phi_6712_ = false;
                                                phi_6713_ = select(true, false, _e3420);
                                                phi_6714_ = _e3420;
                                            } else {
                                                let _e3270 = local.member[0u];
                                                let _e3273 = local.member_1[0u];
                                                let _e3276 = local.member[0u];
                                                let _e3282 = local.member_2[0u];
                                                let _e3283 = ((_e3270 + ((_e3273 - _e3276) * _e2492)) - _e3282);
                                                let _e3286 = local.member[1u];
                                                let _e3289 = local.member_1[1u];
                                                let _e3292 = local.member[1u];
                                                let _e3298 = local.member_2[1u];
                                                let _e3299 = ((_e3286 + ((_e3289 - _e3292) * _e2492)) - _e3298);
                                                let _e3301 = select(_e3299, _e3283, (_e3283 < _e3299));
                                                let _e3304 = local.member[2u];
                                                let _e3307 = local.member_1[2u];
                                                let _e3310 = local.member[2u];
                                                let _e3316 = local.member_2[2u];
                                                let _e3317 = ((_e3304 + ((_e3307 - _e3310) * _e2492)) - _e3316);
                                                let _e3320 = local.member[3u];
                                                let _e3323 = local.member_1[3u];
                                                let _e3326 = local.member[3u];
                                                let _e3332 = local.member_2[3u];
                                                let _e3333 = ((_e3320 + ((_e3323 - _e3326) * _e2492)) - _e3332);
                                                let _e3335 = select(_e3333, _e3317, (_e3317 < _e3333));
                                                let _e3337 = select(_e3335, _e3301, (_e3301 < _e3335));
                                                let _e3340 = local_1.member[0u];
                                                let _e3343 = local_1.member_1[0u];
                                                let _e3346 = local_1.member[0u];
                                                let _e3352 = local_1.member_2[0u];
                                                let _e3353 = ((_e3340 + ((_e3343 - _e3346) * _e2486)) - _e3352);
                                                let _e3356 = local_1.member[1u];
                                                let _e3359 = local_1.member_1[1u];
                                                let _e3362 = local_1.member[1u];
                                                let _e3368 = local_1.member_2[1u];
                                                let _e3369 = ((_e3356 + ((_e3359 - _e3362) * _e2486)) - _e3368);
                                                let _e3371 = select(_e3369, _e3353, (_e3353 < _e3369));
                                                let _e3374 = local_1.member[2u];
                                                let _e3377 = local_1.member_1[2u];
                                                let _e3380 = local_1.member[2u];
                                                let _e3386 = local_1.member_2[2u];
                                                let _e3387 = ((_e3374 + ((_e3377 - _e3380) * _e2486)) - _e3386);
                                                let _e3390 = local_1.member[3u];
                                                let _e3393 = local_1.member_1[3u];
                                                let _e3396 = local_1.member[3u];
                                                let _e3402 = local_1.member_2[3u];
                                                let _e3403 = ((_e3390 + ((_e3393 - _e3396) * _e2486)) - _e3402);
                                                let _e3405 = select(_e3403, _e3387, (_e3387 < _e3403));
                                                let _e3407 = select(_e3405, _e3371, (_e3371 < _e3405));
                                                if (_e3407 > 0f) {
                                                    phi_6708_ = 0.5f;
                                                } else {
                                                    let _e3411 = (0.95f * (_e3337 / (_e3337 - _e3407)));
                                                    phi_6708_ = select(0.0625f, select(0.9f, _e3411, (_e3411 < 0.9f)), (_e3411 > 0.0625f));
                                                }
                                                let _e3417 = phi_6708_;
                                                phi_6710_ = u32();
                                                phi_6711_ = (_e2785 * _e3417);
                                                phi_6712_ = true;
                                                phi_6713_ = false;
                                                phi_6714_ = false;
                                            }
                                            let _e3423 = phi_6710_;
                                            let _e3425 = phi_6711_;
                                            let _e3427 = phi_6712_;
                                            let _e3429 = phi_6713_;
                                            let _e3431 = phi_6714_;
                                            phi_6715_ = _e3423;
                                            phi_6716_ = _e2488;
                                            phi_6717_ = _e3425;
                                            phi_6718_ = _e2490;
                                            phi_6719_ = _e2492;
                                            phi_6720_ = _e2494;
                                            phi_6721_ = _e2496;
                                            phi_6722_ = _e3427;
                                            phi_6723_ = _e3429;
                                            phi_6724_ = _e3431;
                                            phi_6725_ = false;
                                            phi_6727_ = false;
                                        } else {
                                            phi_6715_ = u32();
                                            phi_6716_ = _e3254;
                                            phi_6717_ = _e3256;
                                            phi_6718_ = _e3258;
                                            phi_6719_ = _e2486;
                                            phi_6720_ = true;
                                            phi_6721_ = 0u;
                                            phi_6722_ = _e3262;
                                            phi_6723_ = false;
                                            phi_6724_ = false;
                                            phi_6725_ = _e3264;
                                            phi_6727_ = _e3266;
                                        }
                                        let _e3433 = phi_6715_;
                                        let _e3435 = phi_6716_;
                                        let _e3437 = phi_6717_;
                                        let _e3439 = phi_6718_;
                                        let _e3441 = phi_6719_;
                                        let _e3443 = phi_6720_;
                                        let _e3445 = phi_6721_;
                                        let _e3447 = phi_6722_;
                                        let _e3449 = phi_6723_;
                                        let _e3451 = phi_6724_;
                                        let _e3453 = phi_6725_;
                                        let _e3455 = phi_6727_;
                                        if _e3447 {
                                            let _e3456 = (_e3441 + _e3437);
                                            let _e3458 = select(_e3435, _e3456, (_e3456 > _e3435));
                                            let _e3460 = select(_e2263.member_1, _e3458, (_e3458 < _e2263.member_1));
                                            let _e3463 = select(((_e3460 - _e3441) > _e2481), true, !(_e2494));
                                            phi_6755_ = _e3460;
                                            phi_6756_ = _e3435;
                                            phi_6757_ = _e3439;
                                            phi_6758_ = _e3441;
                                            phi_6759_ = _e3443;
                                            phi_6760_ = _e3445;
                                            phi_6761_ = _e3463;
                                            phi_6762_ = select(true, false, _e3463);
                                            phi_6763_ = false;
                                            phi_6764_ = false;
                                            phi_6766_ = false;
                                        } else {
                                            phi_6755_ = _e2486;
                                            phi_6756_ = _e2488;
                                            phi_6757_ = _e2490;
                                            phi_6758_ = _e2492;
                                            phi_6759_ = _e2494;
                                            phi_6760_ = _e3433;
                                            phi_6761_ = _e3449;
                                            phi_6762_ = false;
                                            phi_6763_ = _e3451;
                                            phi_6764_ = _e3453;
                                            phi_6766_ = _e3455;
                                        }
                                        let _e3466 = phi_6755_;
                                        let _e3468 = phi_6756_;
                                        let _e3470 = phi_6757_;
                                        let _e3472 = phi_6758_;
                                        let _e3474 = phi_6759_;
                                        let _e3476 = phi_6760_;
                                        let _e3478 = phi_6761_;
                                        let _e3480 = phi_6762_;
                                        let _e3482 = phi_6763_;
                                        let _e3484 = phi_6764_;
                                        let _e3486 = phi_6766_;
                                        phi_4588_ = _e3466;
                                        phi_4590_ = _e3468;
                                        phi_4592_ = _e3470;
                                        phi_4594_ = _e3472;
                                        phi_4596_ = _e3474;
                                        phi_4598_ = _e3476;
                                        phi_6767_ = _e3435;
                                        phi_6769_ = _e3478;
                                        phi_6770_ = _e3480;
                                        phi_6771_ = _e3482;
                                        phi_6772_ = _e3484;
                                        phi_6774_ = false;
                                        phi_6775_ = _e3486;
                                    } else {
                                        phi_4588_ = f32();
                                        phi_4590_ = f32();
                                        phi_4592_ = f32();
                                        phi_4594_ = f32();
                                        phi_4596_ = bool();
                                        phi_4598_ = u32();
                                        phi_6767_ = f32();
                                        phi_6769_ = false;
                                        phi_6770_ = false;
                                        phi_6771_ = false;
                                        phi_6772_ = false;
                                        phi_6774_ = true;
                                        phi_6775_ = false;
                                    }
                                    let _e3488 = phi_4588_;
                                    let _e3490 = phi_4590_;
                                    let _e3492 = phi_4592_;
                                    let _e3494 = phi_4594_;
                                    let _e3496 = phi_4596_;
                                    let _e3498 = phi_4598_;
                                    let _e3500 = phi_6767_;
                                    let _e3502 = phi_6769_;
                                    let _e3504 = phi_6770_;
                                    let _e3506 = phi_6771_;
                                    let _e3508 = phi_6772_;
                                    let _e3510 = phi_6774_;
                                    let _e3512 = phi_6775_;
                                    local_21 = _e3504;
                                    local_22 = _e3506;
                                    local_23 = _e3504;
                                    local_24 = _e3508;
                                    local_25 = _e3504;
                                    local_26 = _e3510;
                                    local_27 = _e3504;
                                    local_28 = _e3512;
                                    local_30 = _e3504;
                                    local_31 = _e3500;
                                    continue;
                                    continuing {
                                        phi_4584_ = type_9(select(_e2484.member, (_e2484.member + 1u), _e2499), select(_e2484.member_1, _e2484.member_1, _e2499));
                                        phi_4587_ = _e3488;
                                        phi_4589_ = _e3490;
                                        phi_4591_ = _e3492;
                                        phi_4593_ = _e3494;
                                        phi_4595_ = _e3496;
                                        phi_4597_ = _e3498;
                                        break if !(_e3502);
                                    }
                                }
                                let _e3515 = local_21;
                                let _e3517 = local_22;
                                let _e3518 = select(_e3517, false, _e3515);
                                let _e3520 = local_23;
                                let _e3522 = local_24;
                                let _e3525 = local_25;
                                let _e3527 = local_26;
                                let _e3530 = local_27;
                                let _e3532 = local_28;
                                let _e3538 = local_29;
                                let _e3540 = select(select(_e3522, false, _e3520), false, _e3518);
                                let _e3542 = local_30;
                                let _e3549 = select(select(_e3542, false, _e3518), false, _e3540);
                                let _e3554 = local_31;
                                let _e3556 = local_32;
                                let _e3558 = select(select(select(select(_e3527, false, _e3525), false, _e3518), false, _e3540), true, _e3549);
                                let _e3565 = select(select(select(select(select(_e3532, false, _e3530), false, _e3518), false, _e3540), false, _e3549), false, _e3558);
                                let _e3570 = select(select(select(select(_e3518, true, _e3540), false, _e3549), false, _e3558), true, _e3565);
                                let _e3573 = (select(select(type_33().member, 1u, _e3558), select(select(select(type_33().member, 1u, _e3518), 0u, _e3540), 0u, _e3565), _e3570) != 0u);
                                phi_6843_ = select(select(type_33().member_1, select(_e3556, _e3554, _e3549), _e3558), select(select(select(type_33().member_1, _e3538, _e3518), type_33().member_1, _e3540), type_33().member_1, _e3565), _e3570);
                                phi_6844_ = select(true, false, _e3573);
                                phi_6845_ = _e3573;
                                phi_6846_ = false;
                                phi_6847_ = false;
                                phi_6848_ = false;
                            } else {
                                phi_6843_ = f32();
                                phi_6844_ = _e2271;
                                phi_6845_ = false;
                                phi_6846_ = _e2273;
                                phi_6847_ = _e2275;
                                phi_6848_ = _e2277;
                            }
                            let _e3576 = phi_6843_;
                            let _e3578 = phi_6844_;
                            let _e3580 = phi_6845_;
                            let _e3582 = phi_6846_;
                            let _e3584 = phi_6847_;
                            let _e3586 = phi_6848_;
                            phi_6849_ = _e2263;
                            phi_6850_ = _e2265;
                            phi_6851_ = _e3576;
                            phi_6852_ = _e2267;
                            phi_6853_ = _e3578;
                            phi_6854_ = _e3580;
                            phi_6855_ = false;
                            phi_6856_ = _e3582;
                            phi_6857_ = _e3584;
                            phi_6858_ = _e3586;
                        } else {
                            phi_6849_ = type_38();
                            phi_6850_ = bool();
                            phi_6851_ = f32();
                            phi_6852_ = type_38();
                            phi_6853_ = false;
                            phi_6854_ = false;
                            phi_6855_ = true;
                            phi_6856_ = false;
                            phi_6857_ = false;
                            phi_6858_ = false;
                        }
                        let _e3588 = phi_6849_;
                        let _e3590 = phi_6850_;
                        let _e3592 = phi_6851_;
                        let _e3594 = phi_6852_;
                        let _e3596 = phi_6853_;
                        let _e3598 = phi_6854_;
                        let _e3600 = phi_6855_;
                        let _e3602 = phi_6856_;
                        let _e3604 = phi_6857_;
                        let _e3606 = phi_6858_;
                        local_33 = _e3598;
                        local_34 = _e3590;
                        local_35 = _e3588;
                        local_36 = _e3592;
                        local_37 = _e3592;
                        local_38 = _e3592;
                        local_42 = _e3600;
                        local_43 = _e3602;
                        local_44 = _e3604;
                        local_45 = _e3606;
                        local_39 = _e3598;
                        local_40 = _e3594;
                        continue;
                        continuing {
                            phi_2729_ = type_9(select(_e1285.member, (_e1285.member + 1u), _e1288), select(_e1285.member_1, _e1285.member_1, _e1288));
                            break if !(_e3596);
                        }
                    }
                    let _e3609 = local_33;
                    if _e3609 {
                        let _e3611 = local_34;
                        if _e3611 {
                            let _e3613 = local_35;
                            let _e3616 = local_36;
                            let _e3618 = ((_e3613.member_1 - _e3616) <= _e1249);
                            let _e3623 = local_37;
                            phi_6874_ = type_33(select(type_33().member, 1u, _e3618), select(type_33().member_1, _e3623, _e3618));
                            phi_6875_ = select(true, false, _e3618);
                        } else {
                            phi_6874_ = type_33();
                            phi_6875_ = true;
                        }
                        let _e3628 = phi_6874_;
                        let _e3630 = phi_6875_;
                        let _e3635 = local_38;
                        phi_6881_ = type_33(select(_e3628.member, 2u, _e3630), select(_e3628.member_1, _e3635, _e3630));
                        phi_6882_ = false;
                        phi_6883_ = false;
                        phi_6884_ = false;
                        phi_6885_ = false;
                    } else {
                        phi_6881_ = type_33();
                        let _e4139 = local_42;
                        phi_6882_ = _e4139;
                        let _e4142 = local_43;
                        phi_6883_ = _e4142;
                        let _e4145 = local_44;
                        phi_6884_ = _e4145;
                        let _e4148 = local_45;
                        phi_6885_ = _e4148;
                    }
                    let _e3639 = phi_6881_;
                    let _e3641 = phi_6882_;
                    let _e3643 = phi_6883_;
                    let _e3645 = phi_6884_;
                    let _e3647 = phi_6885_;
                    let _e3654 = select(_e3643, false, _e3641);
                    let _e3658 = local_39;
                    let _e3665 = select(select(_e3645, false, _e3641), false, _e3654);
                    let _e3671 = select(select(select(_e3647, false, _e3641), false, _e3654), false, _e3665);
                    let _e3675 = local_40;
                    let _e3679 = select(select(_e3654, true, _e3665), true, _e3671);
                    phi_6927_ = type_33(select(_e3639.member, select(select(select(type_33().member, 0u, _e3654), 0u, _e3665), 1u, _e3671), _e3679), select(_e3639.member_1, select(select(select(type_33().member_1, type_33().member_1, _e3654), type_33().member_1, _e3665), _e3675.member, _e3671), _e3679));
                    phi_6928_ = type_33(select(type_33().member, 0u, _e3641), select(type_33().member_1, type_33().member_1, _e3641));
                    phi_6929_ = select(select(select(select(select(_e3658, false, _e3641), false, _e3654), false, _e3665), false, _e3671), true, _e3679);
                }
                let _e3690 = phi_6927_;
                let _e3692 = phi_6928_;
                let _e3694 = phi_6929_;
                let _e3697 = select(_e3692.member, _e3690.member, _e3694);
                let _e3700 = select(_e3692.member_1, _e3690.member_1, _e3694);
                let _e3706 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3700 > _e354)), (_e3697 == 1u))));
                switch bitcast<i32>(_e3697) {
                    case 0: {
                        phi_6973_ = type_31(0u, _e3706, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3710 = function_3(_e3700);
                        phi_6973_ = type_31(0u, _e3706, _e3710, true);
                        break;
                    }
                    case 2: {
                        let _e3708 = function_3(_e3700);
                        phi_6973_ = type_31(1u, _e3706, _e3708, true);
                        break;
                    }
                    default: {
                        phi_6973_ = type_31();
                        break;
                    }
                }
                let _e3714 = phi_6973_;
                let _e3718 = params.member.member.member_12;
                let _e3719 = bitcast<u32>(_e3718);
                if (_e3714.member_2[0] == select((_e3719 << bitcast<u32>(29i)), 0u, ((_e3719 & 2147483647u) < 8388608u))) {
                    let _e3729 = params.member.member.member_12;
                    let _e3730 = bitcast<u32>(_e3729);
                    let _e3731 = (_e3730 & 2147483647u);
                    phi_7013_ = (_e3714.member_2[1] == select(((_e3730 ^ _e3731) | ((_e3731 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3731 < 8388608u)));
                } else {
                    phi_7013_ = false;
                }
                let _e3741 = phi_7013_;
                let _e3743 = params.member.member.member_1;
                if ((_e3743 & 128u) != 0u) {
                    phi_7029_ = true;
                } else {
                    let _e3747 = params.member.member.member_1;
                    phi_7029_ = select(false, _e3741, ((_e3747 & 64u) != 0u));
                }
                let _e3752 = phi_7029_;
                local_8 = type_31(select(1u, _e3714.member, select(true, select(true, false, _e3752), _e3714.member_3)), _e3714.member_1, array<u32, 2>(_e3714.member_2[0], _e3714.member_2[1]), _e3714.member_3);
                phi_7056_ = type_9(_e183, _e186);
            } else {
                phi_7056_ = type_9(0u, 0u);
            }
            let _e3766 = phi_7056_;
            let _e3772 = local_8.member;
            let _e3774 = select(true, false, (_e3772 == 0u));
            let _e3776 = local_8.member_3;
            if _e3776 {
                if _e3774 {
                    phi_7085_ = true;
                } else {
                    let _e3778 = params.member.member.member_1;
                    phi_7085_ = ((_e3778 & 16u) != 0u);
                }
                let _e3782 = phi_7085_;
                phi_7086_ = _e3782;
            } else {
                phi_7086_ = false;
            }
            let _e3784 = phi_7086_;
            let _e3786 = local_8.member_3;
            if _e3786 {
                if _e3774 {
                } else {
                    let _e3788 = local_8.member_2;
                    let _e3793 = ((_e3788[1] >> bitcast<u32>(20i)) & 2047u);
                    let _e3807 = atomicMin((&earliest.member[0u]), select(((((_e3793 - 896u) << bitcast<u32>(23i)) | ((_e3788[1] & 1048575u) << bitcast<u32>(3i))) | (_e3788[0] >> bitcast<u32>(29i))), 0u, (_e3793 <= 896u)));
                }
            }
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3784 {
                let _e3811 = atomicAdd((&counters[0u]), 1u);
                phi_7130_ = _e3811;
            } else {
                phi_7130_ = 0u;
            }
            let _e3813 = phi_7130_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e3816 = atomicLoad((&counters[0u]));
                if (_e3816 > 0u) {
                    let _e3819 = atomicAdd((&contacts.member[0u]), _e3816);
                    atomicStore((&counters[1u]), _e3819);
                }
            }
            workgroupBarrier();
            let _e3822 = atomicLoad((&counters[1u]));
            let _e3823 = (_e3822 + _e3813);
            if _e3784 {
                let _e3825 = params.member.member_1.member_3;
                if (_e3823 < _e3825) {
                    let _e3831 = (7u * _e3823);
                    atomicStore((&contacts.member[(4u + _e3831)]), select(1u, 0u, ((_e3766.member_1 & 2147483648u) == 0u)));
                    let _e3836 = local_8.member;
                    atomicStore((&contacts.member[(_e3831 + 5u)]), _e3836);
                    atomicStore((&contacts.member[(_e3831 + 6u)]), _e3766.member);
                    atomicStore((&contacts.member[(_e3831 + 7u)]), (_e3766.member_1 & 2147483647u));
                    let _e3845 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e3831 + 8u)]), _e3845);
                    let _e3850 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e3831 + 9u)]), _e3850);
                    let _e3854 = local_8.member_1;
                    atomicStore((&contacts.member[(_e3831 + 10u)]), _e3854);
                }
            }
        }
        continue;
        continuing {
            phi_834_ = type_9(select(_e154.member, (_e154.member + 1u), _e157), select(_e154.member_1, _e154.member_1, _e157));
            break if !(_e170);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
