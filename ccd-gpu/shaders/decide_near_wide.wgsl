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

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
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

struct type_30 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_33 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_36 {
    member: type_33,
    member_1: f64,
}

struct type_37 {
    member: u32,
    member_1: f64,
}

struct type_38 {
    member: type_37,
    member_1: u32,
}

struct type_39 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_41 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_42 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage> positions: type_30;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_245_: f64;
    var phi_288_: f64;
    var phi_331_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_245_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_245_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_245_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_288_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_288_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_288_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_331_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_331_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_331_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f64, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_859_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e163 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_4[0] - param_6[0]);
        let _e272 = (param_4[1] - param_6[1]);
        let _e275 = (param_4[2] - param_6[2]);
        let _e295 = ((((_e269 * param_5[0]) + (_e272 * param_5[1])) + (_e275 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_859_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_859_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_859_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_458_: bool;
    var phi_492_: array<f64, 3>;
    var phi_493_: bool;
    var phi_494_: array<f64, 3>;
    var phi_495_: bool;
    var phi_500_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_458_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_458_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_458_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_492_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_493_ = false;
        } else {
            phi_492_ = array<f64, 3>();
            phi_493_ = true;
        }
        let _e132 = phi_492_;
        let _e134 = phi_493_;
        phi_494_ = _e132;
        phi_495_ = _e134;
    } else {
        phi_494_ = array<f64, 3>();
        phi_495_ = true;
    }
    let _e136 = phi_494_;
    let _e138 = phi_495_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_500_ = _e139;
    } else {
        phi_500_ = _e136;
    }
    let _e141 = phi_500_;
    return _e141;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_41;
    var local_2: type_39;
    var local_3: type_39;
    var local_4: type_39;
    var local_5: type_33;
    var local_6: type_35;
    var phi_954_: u32;
    var phi_999_: u32;
    var phi_1002_: type_9;
    var phi_1176_: type_23;
    var phi_1372_: type_31;
    var phi_1533_: type_33;
    var phi_2030_: bool;
    var phi_2126_: type_36;
    var phi_2127_: bool;
    var phi_2128_: type_36;
    var phi_2129_: bool;
    var phi_2130_: type_36;
    var phi_2131_: bool;
    var phi_2136_: type_36;
    var phi_2306_: type_16;
    var phi_2309_: f64;
    var phi_2307_: type_16;
    var phi_2350_: type_17;
    var phi_2310_: f64;
    var local_7: f64;
    var phi_2363_: f64;
    var phi_3290_: type_38;
    var phi_3291_: bool;
    var phi_3292_: type_38;
    var phi_3293_: bool;
    var phi_3299_: type_16;
    var phi_3302_: f64;
    var phi_3304_: u32;
    var phi_3306_: f64;
    var phi_3300_: type_16;
    var phi_3347_: type_17;
    var phi_3790_: type_9;
    var phi_3793_: f64;
    var phi_3795_: f64;
    var phi_3797_: f64;
    var phi_3799_: f64;
    var phi_3801_: bool;
    var phi_3803_: u32;
    var phi_3955_: array<f64, 3>;
    var phi_4023_: type_16;
    var phi_4026_: f64;
    var phi_4024_: type_16;
    var phi_4067_: type_17;
    var phi_4027_: f64;
    var local_8: f64;
    var phi_4080_: f64;
    var phi_4206_: type_39;
    var phi_4207_: bool;
    var phi_4208_: type_39;
    var phi_4209_: bool;
    var phi_4219_: type_39;
    var phi_4391_: bool;
    var phi_4392_: bool;
    var phi_4393_: bool;
    var phi_4394_: bool;
    var phi_4395_: bool;
    var phi_4396_: bool;
    var phi_4698_: bool;
    var phi_4699_: bool;
    var phi_4700_: bool;
    var phi_4701_: bool;
    var phi_4702_: bool;
    var phi_4703_: bool;
    var phi_4711_: bool;
    var phi_4821_: f64;
    var phi_4822_: bool;
    var phi_4823_: f64;
    var phi_4824_: bool;
    var phi_4825_: f64;
    var phi_4826_: bool;
    var phi_4827_: bool;
    var phi_4893_: f64;
    var phi_4894_: bool;
    var phi_4895_: f64;
    var phi_4896_: bool;
    var phi_4897_: f64;
    var phi_4898_: bool;
    var phi_4899_: bool;
    var phi_4970_: f64;
    var phi_4971_: bool;
    var phi_4972_: f64;
    var phi_4973_: bool;
    var phi_4974_: f64;
    var phi_4975_: bool;
    var phi_4976_: bool;
    var phi_5042_: f64;
    var phi_5043_: bool;
    var phi_5044_: f64;
    var phi_5045_: bool;
    var phi_5046_: f64;
    var phi_5047_: bool;
    var phi_5048_: bool;
    var phi_5225_: type_16;
    var phi_5228_: f64;
    var phi_5226_: type_16;
    var phi_5269_: type_17;
    var phi_5229_: f64;
    var local_9: f64;
    var phi_5282_: f64;
    var phi_5559_: bool;
    var phi_5560_: bool;
    var phi_5587_: f64;
    var phi_5588_: f64;
    var phi_5589_: bool;
    var phi_5590_: f64;
    var phi_5591_: f64;
    var phi_5592_: bool;
    var phi_5593_: bool;
    var phi_5594_: f64;
    var phi_5595_: f64;
    var phi_5596_: f64;
    var phi_5597_: f64;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_5601_: bool;
    var phi_5602_: f64;
    var phi_5603_: f64;
    var phi_5604_: f64;
    var phi_5605_: f64;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5609_: bool;
    var phi_5610_: bool;
    var phi_5611_: f64;
    var phi_5612_: f64;
    var phi_5613_: f64;
    var phi_5614_: f64;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: bool;
    var phi_5618_: bool;
    var phi_5619_: bool;
    var phi_5957_: f64;
    var phi_5959_: u32;
    var phi_5960_: f64;
    var phi_5961_: bool;
    var phi_5962_: bool;
    var phi_5963_: bool;
    var phi_5964_: u32;
    var phi_5965_: f64;
    var phi_5966_: f64;
    var phi_5967_: f64;
    var phi_5968_: f64;
    var phi_5969_: bool;
    var phi_5970_: u32;
    var phi_5971_: bool;
    var phi_5972_: bool;
    var phi_5973_: bool;
    var phi_5974_: bool;
    var phi_5975_: bool;
    var phi_5976_: bool;
    var phi_6004_: f64;
    var phi_6005_: f64;
    var phi_6006_: f64;
    var phi_6007_: f64;
    var phi_6008_: bool;
    var phi_6009_: u32;
    var phi_6010_: bool;
    var phi_6011_: bool;
    var phi_6012_: bool;
    var phi_6013_: bool;
    var phi_6014_: bool;
    var phi_6015_: bool;
    var phi_3794_: f64;
    var phi_3796_: f64;
    var phi_3798_: f64;
    var phi_3800_: f64;
    var phi_3802_: bool;
    var phi_3804_: u32;
    var phi_6016_: f64;
    var phi_6017_: f64;
    var phi_6018_: bool;
    var phi_6019_: bool;
    var phi_6020_: bool;
    var phi_6021_: bool;
    var phi_6022_: bool;
    var phi_6023_: bool;
    var phi_6024_: bool;
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
    var local_20: f64;
    var local_21: bool;
    var local_22: f64;
    var local_23: f64;
    var local_24: f64;
    var phi_6091_: f64;
    var phi_6092_: bool;
    var phi_6717_: type_16;
    var phi_6720_: f64;
    var phi_6718_: type_16;
    var phi_6761_: type_17;
    var phi_6721_: f64;
    var local_25: f64;
    var phi_6774_: f64;
    var phi_7012_: type_16;
    var phi_7015_: f64;
    var phi_7013_: type_16;
    var phi_7056_: type_17;
    var phi_7016_: f64;
    var local_26: f64;
    var phi_7069_: f64;
    var phi_7101_: type_16;
    var phi_7104_: f64;
    var phi_7102_: type_16;
    var phi_7145_: type_17;
    var phi_7105_: f64;
    var local_27: f64;
    var phi_7158_: f64;
    var phi_7476_: type_9;
    var phi_7479_: f64;
    var phi_7480_: f64;
    var local_28: f64;
    var local_29: f64;
    var phi_7581_: type_16;
    var phi_7584_: f64;
    var phi_7582_: type_16;
    var phi_7625_: type_17;
    var phi_7585_: f64;
    var local_30: f64;
    var phi_7638_: f64;
    var phi_7645_: type_9;
    var phi_7648_: f64;
    var phi_7650_: bool;
    var phi_7652_: bool;
    var phi_7888_: f64;
    var phi_7889_: f64;
    var phi_7649_: f64;
    var phi_7651_: bool;
    var phi_7653_: bool;
    var local_31: f64;
    var local_32: f64;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_7907_: type_42;
    var phi_7908_: bool;
    var local_37: bool;
    var phi_7930_: type_9;
    var phi_7933_: f64;
    var phi_7935_: f64;
    var phi_8045_: f64;
    var phi_8046_: f64;
    var phi_8047_: f64;
    var phi_8048_: f64;
    var phi_7934_: f64;
    var phi_7936_: f64;
    var local_38: f64;
    var local_39: f64;
    var local_40: f64;
    var phi_8211_: bool;
    var phi_8212_: bool;
    var phi_8213_: bool;
    var phi_8214_: bool;
    var phi_8215_: bool;
    var phi_8216_: bool;
    var phi_8225_: bool;
    var phi_8226_: bool;
    var phi_8235_: type_42;
    var phi_8236_: type_42;
    var phi_8237_: bool;
    var phi_8238_: type_42;
    var phi_8239_: type_42;
    var phi_8240_: bool;
    var phi_8246_: type_42;
    var phi_8247_: type_42;
    var phi_8248_: bool;
    var phi_8252_: type_42;
    var phi_8253_: type_42;
    var phi_8254_: bool;
    var phi_8255_: bool;
    var phi_8256_: type_42;
    var phi_8257_: type_42;
    var phi_8258_: bool;
    var phi_8259_: bool;
    var phi_8294_: f64;
    var phi_8295_: f64;
    var phi_8296_: bool;
    var phi_8297_: bool;
    var phi_8298_: bool;
    var phi_8299_: f64;
    var phi_8300_: u32;
    var phi_8301_: f64;
    var phi_8302_: type_42;
    var phi_8303_: u32;
    var phi_8304_: u32;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8307_: bool;
    var phi_8308_: f64;
    var phi_8309_: u32;
    var phi_8310_: f64;
    var phi_8311_: type_42;
    var phi_8312_: u32;
    var phi_8313_: u32;
    var phi_8314_: bool;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: bool;
    var phi_8319_: f64;
    var phi_3303_: f64;
    var phi_3305_: u32;
    var phi_3307_: f64;
    var phi_8320_: type_42;
    var phi_8321_: u32;
    var phi_8322_: f64;
    var phi_8323_: u32;
    var phi_8324_: bool;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: bool;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: type_42;
    var local_50: type_42;
    var local_51: u32;
    var local_52: type_42;
    var phi_8358_: type_38;
    var phi_8359_: type_38;
    var phi_8360_: bool;
    var phi_8361_: bool;
    var phi_8362_: bool;
    var phi_8363_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var local_58: u32;
    var phi_8397_: type_9;
    var phi_8573_: type_16;
    var phi_8576_: f64;
    var phi_8574_: type_16;
    var phi_8617_: type_17;
    var phi_8577_: f64;
    var local_59: f64;
    var phi_8630_: f64;
    var phi_8907_: bool;
    var phi_8908_: bool;
    var local_60: bool;
    var phi_8920_: type_38;
    var phi_8921_: bool;
    var phi_8933_: type_38;
    var phi_8934_: type_38;
    var phi_8935_: bool;
    var phi_8936_: bool;
    var phi_8943_: type_38;
    var phi_8944_: bool;
    var phi_8948_: type_38;
    var phi_8949_: type_38;
    var phi_8950_: bool;
    var phi_8954_: type_38;
    var phi_8972_: type_35;
    var phi_8981_: type_9;
    var phi_9006_: bool;
    var phi_9050_: u32;
    var local_61: bool;
    var local_62: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e105 = id_2;
    let _e106 = n_2;
    let _e107 = lane_2;
    let _e119 = ((_e105.y * _e106.x) + _e105.x);
    let _e122 = (_e106.x * _e106.y);
    let _e125 = params.member.member_1.member_2;
    let _e127 = input.member[0u];
    let _e129 = select(_e127, _e125, (_e125 < _e127));
    let _e131 = params.member.member_1.member_1;
    if (_e129 > _e131) {
        let _e134 = params.member.member_1.member_1;
        phi_954_ = (_e129 - _e134);
    } else {
        phi_954_ = 0u;
    }
    let _e137 = phi_954_;
    let _e139 = params.member.member_1.member;
    let _e141 = select(_e137, _e139, (_e139 < _e137));
    let _e142 = (_e141 / 64u);
    let _e146 = select(_e142, (_e142 + 1u), ((_e141 % 64u) > 0u));
    if (_e146 > _e119) {
        let _e148 = (_e146 - _e119);
        if (_e122 == 0u) {
            return;
        }
        let _e150 = (_e148 / _e122);
        if (_e122 == 0u) {
            return;
        }
        phi_999_ = select(_e150, (_e150 + 1u), ((_e148 % _e122) > 0u));
    } else {
        phi_999_ = 0u;
    }
    let _e157 = phi_999_;
    phi_1002_ = type_9(0u, _e157);
    loop {
        let _e160 = phi_1002_;
        let _e163 = (_e160.member < _e160.member_1);
        let _e176 = (bitcast<i32>(select(0u, 1u, _e163)) != 0i);
        if _e176 {
            let _e180 = (((_e119 + (select(type_9().member_1, _e160.member, _e163) * _e122)) * 64u) + _e107);
            local_6 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e180 < _e141) {
                let _e184 = params.member.member_1.member_1;
                let _e186 = (2u * (_e184 + _e180));
                let _e189 = input.member[(4u + _e186)];
                let _e192 = input.member[(_e186 + 5u)];
                let _e197 = (_e192 & 2147483647u);
                if (select(1u, 0u, ((_e192 & 2147483648u) == 0u)) == 0u) {
                    let _e216 = params.member.member.member[1u];
                    let _e219 = ((2u * _e216) + (3u * _e197));
                    let _e221 = elements.member[_e219];
                    let _e224 = elements.member[(_e219 + 1u)];
                    let _e227 = elements.member[(_e219 + 2u)];
                    phi_1176_ = type_23(0u, array<u32, 4>(_e189, _e221, _e224, _e227));
                } else {
                    let _e200 = (2u * _e189);
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    let _e206 = (2u * _e197);
                    let _e208 = elements.member[_e206];
                    let _e211 = elements.member[(_e206 + 1u)];
                    phi_1176_ = type_23(1u, array<u32, 4>(_e202, _e205, _e208, _e211));
                }
                let _e231 = phi_1176_;
                let _e235 = params.member.member.member_1;
                if ((_e235 & 8u) != 0u) {
                    let _e279 = paths.member[_e231.member_1[0]];
                    let _e294 = paths.member[_e231.member_1[1]];
                    let _e309 = paths.member[_e231.member_1[2]];
                    let _e324 = paths.member[_e231.member_1[3]];
                    let _e345 = function_(array<f32, 3>(_e279.member.x, _e279.member.y, _e279.member.z));
                    let _e346 = function_(array<f32, 3>(_e294.member.x, _e294.member.y, _e294.member.z));
                    let _e347 = function_(array<f32, 3>(_e309.member.x, _e309.member.y, _e309.member.z));
                    let _e348 = function_(array<f32, 3>(_e324.member.x, _e324.member.y, _e324.member.z));
                    let _e350 = function_(array<f32, 3>(_e279.member_1.x, _e279.member_1.y, _e279.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e294.member_1.x, _e294.member_1.y, _e294.member_1.z));
                    let _e352 = function_(array<f32, 3>(_e309.member_1.x, _e309.member_1.y, _e309.member_1.z));
                    let _e353 = function_(array<f32, 3>(_e324.member_1.x, _e324.member_1.y, _e324.member_1.z));
                    phi_1372_ = type_31(array<array<f64, 3>, 4>(_e345, _e346, _e347, _e348), array<array<f64, 3>, 4>(_e350, _e351, _e352, _e353));
                } else {
                    let _e240 = positions.member[_e231.member_1[0]];
                    let _e243 = params.member.member.member[0u];
                    let _e246 = positions.member[(_e243 + _e231.member_1[0])];
                    let _e249 = positions.member[_e231.member_1[1]];
                    let _e252 = params.member.member.member[0u];
                    let _e255 = positions.member[(_e252 + _e231.member_1[1])];
                    let _e258 = positions.member[_e231.member_1[2]];
                    let _e261 = params.member.member.member[0u];
                    let _e264 = positions.member[(_e261 + _e231.member_1[2])];
                    let _e267 = positions.member[_e231.member_1[3]];
                    let _e270 = params.member.member.member[0u];
                    let _e273 = positions.member[(_e270 + _e231.member_1[3])];
                    phi_1372_ = type_31(array<array<f64, 3>, 4>(_e240, _e249, _e258, _e267), array<array<f64, 3>, 4>(_e246, _e255, _e264, _e273));
                }
                let _e357 = phi_1372_;
                if (_e231.member != 0u) {
                    phi_1533_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[0][0]), (_e357.member[2][1] - _e357.member[0][1]), (_e357.member[2][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[0][0]), (_e357.member_1[2][1] - _e357.member_1[0][1]), (_e357.member_1[2][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[1][0] - _e357.member[0][0]), (_e357.member[1][1] - _e357.member[0][1]), (_e357.member[1][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[1][0] - _e357.member_1[0][0]), (_e357.member_1[1][1] - _e357.member_1[0][1]), (_e357.member_1[1][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[3][0]), (_e357.member[2][1] - _e357.member[3][1]), (_e357.member[2][2] - _e357.member[3][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[3][0]), (_e357.member_1[2][1] - _e357.member_1[3][1]), (_e357.member_1[2][2] - _e357.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1533_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[0][0] - _e357.member[1][0]), (_e357.member[0][1] - _e357.member[1][1]), (_e357.member[0][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[0][0] - _e357.member_1[1][0]), (_e357.member_1[0][1] - _e357.member_1[1][1]), (_e357.member_1[0][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[1][0]), (_e357.member[2][1] - _e357.member[1][1]), (_e357.member[2][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[1][0]), (_e357.member_1[2][1] - _e357.member_1[1][1]), (_e357.member_1[2][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[3][0] - _e357.member[1][0]), (_e357.member[3][1] - _e357.member[1][1]), (_e357.member[3][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[3][0] - _e357.member_1[1][0]), (_e357.member_1[3][1] - _e357.member_1[1][1]), (_e357.member_1[3][2] - _e357.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e516 = phi_1533_;
                let _e518 = params.member.member.member_7;
                let _e525 = bitcast<f64>(((u64(_e518[1]) * 4294967296lu) + u64(_e518[0])));
                let _e527 = params.member.member.member_14;
                let _e534 = bitcast<f64>(((u64(_e527[1]) * 4294967296lu) + u64(_e527[0])));
                let _e536 = params.member.member.member_15;
                let _e543 = bitcast<f64>(((u64(_e536[1]) * 4294967296lu) + u64(_e536[0])));
                let _e545 = params.member.member.member_16;
                let _e552 = bitcast<f64>(((u64(_e545[1]) * 4294967296lu) + u64(_e545[0])));
                let _e554 = params.member.member.member_1;
                let _e562 = select(_e516.member[0][0], -(_e516.member[0][0]), (_e516.member[0][0] < 0.0lf));
                let _e566 = select(_e516.member[0][1], -(_e516.member[0][1]), (_e516.member[0][1] < 0.0lf));
                let _e568 = select(_e566, _e562, (_e562 > _e566));
                let _e572 = select(_e516.member[0][2], -(_e516.member[0][2]), (_e516.member[0][2] < 0.0lf));
                let _e574 = select(_e572, _e568, (_e568 > _e572));
                let _e580 = select(_e516.member[1][0], -(_e516.member[1][0]), (_e516.member[1][0] < 0.0lf));
                let _e584 = select(_e516.member[1][1], -(_e516.member[1][1]), (_e516.member[1][1] < 0.0lf));
                let _e586 = select(_e584, _e580, (_e580 > _e584));
                let _e590 = select(_e516.member[1][2], -(_e516.member[1][2]), (_e516.member[1][2] < 0.0lf));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e596 = (select(_e592, _e574, (_e574 > _e592)) + _e516.member_3);
                let _e602 = select(_e516.member_1[0][0], -(_e516.member_1[0][0]), (_e516.member_1[0][0] < 0.0lf));
                let _e606 = select(_e516.member_1[0][1], -(_e516.member_1[0][1]), (_e516.member_1[0][1] < 0.0lf));
                let _e608 = select(_e606, _e602, (_e602 > _e606));
                let _e612 = select(_e516.member_1[0][2], -(_e516.member_1[0][2]), (_e516.member_1[0][2] < 0.0lf));
                let _e614 = select(_e612, _e608, (_e608 > _e612));
                let _e620 = select(_e516.member_1[1][0], -(_e516.member_1[1][0]), (_e516.member_1[1][0] < 0.0lf));
                let _e624 = select(_e516.member_1[1][1], -(_e516.member_1[1][1]), (_e516.member_1[1][1] < 0.0lf));
                let _e626 = select(_e624, _e620, (_e620 > _e624));
                let _e630 = select(_e516.member_1[1][2], -(_e516.member_1[1][2]), (_e516.member_1[1][2] < 0.0lf));
                let _e632 = select(_e630, _e626, (_e626 > _e630));
                let _e636 = (select(_e632, _e614, (_e614 > _e632)) + _e516.member_3);
                let _e642 = select(_e516.member_2[0][0], -(_e516.member_2[0][0]), (_e516.member_2[0][0] < 0.0lf));
                let _e646 = select(_e516.member_2[0][1], -(_e516.member_2[0][1]), (_e516.member_2[0][1] < 0.0lf));
                let _e648 = select(_e646, _e642, (_e642 > _e646));
                let _e652 = select(_e516.member_2[0][2], -(_e516.member_2[0][2]), (_e516.member_2[0][2] < 0.0lf));
                let _e654 = select(_e652, _e648, (_e648 > _e652));
                let _e660 = select(_e516.member_2[1][0], -(_e516.member_2[1][0]), (_e516.member_2[1][0] < 0.0lf));
                let _e664 = select(_e516.member_2[1][1], -(_e516.member_2[1][1]), (_e516.member_2[1][1] < 0.0lf));
                let _e666 = select(_e664, _e660, (_e660 > _e664));
                let _e670 = select(_e516.member_2[1][2], -(_e516.member_2[1][2]), (_e516.member_2[1][2] < 0.0lf));
                let _e672 = select(_e670, _e666, (_e666 > _e670));
                let _e676 = (select(_e672, _e654, (_e654 > _e672)) + _e516.member_3);
                let _e678 = select(_e636, _e596, (_e596 > _e636));
                let _e680 = select(_e676, _e678, (_e678 > _e676));
                let _e686 = select(_e516.member[0][0], -(_e516.member[0][0]), (_e516.member[0][0] < 0.0lf));
                let _e690 = select(_e516.member[0][1], -(_e516.member[0][1]), (_e516.member[0][1] < 0.0lf));
                let _e692 = select(_e690, _e686, (_e686 > _e690));
                let _e696 = select(_e516.member[0][2], -(_e516.member[0][2]), (_e516.member[0][2] < 0.0lf));
                let _e698 = select(_e696, _e692, (_e692 > _e696));
                let _e704 = select(_e516.member[1][0], -(_e516.member[1][0]), (_e516.member[1][0] < 0.0lf));
                let _e708 = select(_e516.member[1][1], -(_e516.member[1][1]), (_e516.member[1][1] < 0.0lf));
                let _e710 = select(_e708, _e704, (_e704 > _e708));
                let _e714 = select(_e516.member[1][2], -(_e516.member[1][2]), (_e516.member[1][2] < 0.0lf));
                let _e716 = select(_e714, _e710, (_e710 > _e714));
                let _e720 = (select(_e716, _e698, (_e698 > _e716)) + _e516.member_3);
                let _e726 = select(_e516.member_1[0][0], -(_e516.member_1[0][0]), (_e516.member_1[0][0] < 0.0lf));
                let _e730 = select(_e516.member_1[0][1], -(_e516.member_1[0][1]), (_e516.member_1[0][1] < 0.0lf));
                let _e732 = select(_e730, _e726, (_e726 > _e730));
                let _e736 = select(_e516.member_1[0][2], -(_e516.member_1[0][2]), (_e516.member_1[0][2] < 0.0lf));
                let _e738 = select(_e736, _e732, (_e732 > _e736));
                let _e744 = select(_e516.member_1[1][0], -(_e516.member_1[1][0]), (_e516.member_1[1][0] < 0.0lf));
                let _e748 = select(_e516.member_1[1][1], -(_e516.member_1[1][1]), (_e516.member_1[1][1] < 0.0lf));
                let _e750 = select(_e748, _e744, (_e744 > _e748));
                let _e754 = select(_e516.member_1[1][2], -(_e516.member_1[1][2]), (_e516.member_1[1][2] < 0.0lf));
                let _e756 = select(_e754, _e750, (_e750 > _e754));
                let _e760 = (select(_e756, _e738, (_e738 > _e756)) + _e516.member_3);
                let _e766 = select(_e516.member_2[0][0], -(_e516.member_2[0][0]), (_e516.member_2[0][0] < 0.0lf));
                let _e770 = select(_e516.member_2[0][1], -(_e516.member_2[0][1]), (_e516.member_2[0][1] < 0.0lf));
                let _e772 = select(_e770, _e766, (_e766 > _e770));
                let _e776 = select(_e516.member_2[0][2], -(_e516.member_2[0][2]), (_e516.member_2[0][2] < 0.0lf));
                let _e778 = select(_e776, _e772, (_e772 > _e776));
                let _e784 = select(_e516.member_2[1][0], -(_e516.member_2[1][0]), (_e516.member_2[1][0] < 0.0lf));
                let _e788 = select(_e516.member_2[1][1], -(_e516.member_2[1][1]), (_e516.member_2[1][1] < 0.0lf));
                let _e790 = select(_e788, _e784, (_e784 > _e788));
                let _e794 = select(_e516.member_2[1][2], -(_e516.member_2[1][2]), (_e516.member_2[1][2] < 0.0lf));
                let _e796 = select(_e794, _e790, (_e790 > _e794));
                let _e800 = (select(_e796, _e778, (_e778 > _e796)) + _e516.member_3);
                let _e802 = select(_e760, _e720, (_e720 > _e760));
                let _e804 = select(_e800, _e802, (_e802 > _e800));
                if (_e804 <= f64(65536f)) {
                    phi_2030_ = (_e804 >= f64((1f / 65536f)));
                } else {
                    phi_2030_ = false;
                }
                let _e811 = phi_2030_;
                if _e811 {
                    phi_2130_ = type_36();
                    phi_2131_ = true;
                } else {
                    if (_e680 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e680) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e818 = (9214364837600034816lu - (bitcast<u64>(_e680) & 9218868437227405312lu));
                            let _e821 = bitcast<f64>(select(4503599627370496lu, _e818, (_e818 > 4503599627370496lu)));
                            let _e822 = (_e525 * _e821);
                            phi_2126_ = type_36(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e516.member[0][0] * _e821), (_e516.member[0][1] * _e821), (_e516.member[0][2] * _e821)), array<f64, 3>((_e516.member[1][0] * _e821), (_e516.member[1][1] * _e821), (_e516.member[1][2] * _e821))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_1[0][0] * _e821), (_e516.member_1[0][1] * _e821), (_e516.member_1[0][2] * _e821)), array<f64, 3>((_e516.member_1[1][0] * _e821), (_e516.member_1[1][1] * _e821), (_e516.member_1[1][2] * _e821))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_2[0][0] * _e821), (_e516.member_2[0][1] * _e821), (_e516.member_2[0][2] * _e821)), array<f64, 3>((_e516.member_2[1][0] * _e821), (_e516.member_2[1][1] * _e821), (_e516.member_2[1][2] * _e821))), ((_e516.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e821)), select(_e822, select(2.2250738585072014e-308lf, _e822, (_e822 > 2.2250738585072014e-308lf)), (_e525 > f64(0f))));
                            phi_2127_ = false;
                        } else {
                            phi_2126_ = type_36();
                            phi_2127_ = true;
                        }
                        let _e893 = phi_2126_;
                        let _e895 = phi_2127_;
                        phi_2128_ = _e893;
                        phi_2129_ = _e895;
                    } else {
                        phi_2128_ = type_36();
                        phi_2129_ = true;
                    }
                    let _e897 = phi_2128_;
                    let _e899 = phi_2129_;
                    phi_2130_ = _e897;
                    phi_2131_ = _e899;
                }
                let _e901 = phi_2130_;
                let _e903 = phi_2131_;
                if _e903 {
                    phi_2136_ = type_36(_e516, _e525);
                } else {
                    phi_2136_ = _e901;
                }
                let _e906 = phi_2136_;
                local_5 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e906.member.member[0][0], _e906.member.member[0][1], _e906.member.member[0][2]), array<f64, 3>(_e906.member.member[1][0], _e906.member.member[1][1], _e906.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e906.member.member_1[0][0], _e906.member.member_1[0][1], _e906.member.member_1[0][2]), array<f64, 3>(_e906.member.member_1[1][0], _e906.member.member_1[1][1], _e906.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e906.member.member_2[0][0], _e906.member.member_2[0][1], _e906.member.member_2[0][2]), array<f64, 3>(_e906.member.member_2[1][0], _e906.member.member_2[1][1], _e906.member.member_2[1][2])), _e906.member.member_3);
                let _e949 = local_5.member[0u];
                let _e955 = local_5.member[1u];
                let _e971 = local_5.member_1[0u];
                let _e977 = local_5.member_1[1u];
                let _e993 = local_5.member_2[0u];
                let _e999 = local_5.member_2[1u];
                let _e1013 = function_4(array<f64, 3>((_e949[0] + ((_e955[0] - _e949[0]) * _e543)), (_e949[1] + ((_e955[1] - _e949[1]) * _e543)), (_e949[2] + ((_e955[2] - _e949[2]) * _e543))), array<f64, 3>((_e971[0] + ((_e977[0] - _e971[0]) * _e543)), (_e971[1] + ((_e977[1] - _e971[1]) * _e543)), (_e971[2] + ((_e977[2] - _e971[2]) * _e543))), array<f64, 3>((_e993[0] + ((_e999[0] - _e993[0]) * _e543)), (_e993[1] + ((_e999[1] - _e993[1]) * _e543)), (_e993[2] + ((_e999[2] - _e993[2]) * _e543))), _e231.member);
                let _e1024 = (((_e1013[0] * _e1013[0]) + (_e1013[1] * _e1013[1])) + (_e1013[2] * _e1013[2]));
                if (_e1024 <= 2.2250738585072014e-308lf) {
                    phi_2363_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1024 > 0.0lf));
                } else {
                    phi_2306_ = type_16(0i, 5i);
                    phi_2309_ = bitcast<f64>(((bitcast<u64>(_e1024) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e1031 = phi_2306_;
                        let _e1033 = phi_2309_;
                        local_7 = _e1033;
                        if (_e1031.member < _e1031.member_1) {
                            let _e1040 = (_e1031.member + 1i);
                            phi_2307_ = type_16(select(_e1040, type_17().member_1, select(false, true, ((false == (_e1040 > _e1031.member)) != false))), _e1031.member_1);
                            phi_2350_ = type_17(1u, _e1031.member);
                        } else {
                            phi_2307_ = _e1031;
                            phi_2350_ = type_17(0u, type_17().member_1);
                        }
                        let _e1051 = phi_2307_;
                        let _e1053 = phi_2350_;
                        let _e1056 = (bitcast<i32>(_e1053.member) != 0i);
                        if _e1056 {
                            phi_2310_ = (0.5lf * (_e1033 + (_e1024 / _e1033)));
                        } else {
                            phi_2310_ = f64();
                        }
                        let _e1061 = phi_2310_;
                        continue;
                        continuing {
                            phi_2306_ = _e1051;
                            phi_2309_ = _e1061;
                            break if !(_e1056);
                        }
                    }
                    let _e1066 = local_7;
                    phi_2363_ = (_e1066 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e1072 = phi_2363_;
                let _e1080 = local_5.member[0u];
                let _e1086 = select(_e1080[0], -(_e1080[0]), (_e1080[0] < 0.0lf));
                let _e1089 = select(_e1080[1], -(_e1080[1]), (_e1080[1] < 0.0lf));
                let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                let _e1094 = select(_e1080[2], -(_e1080[2]), (_e1080[2] < 0.0lf));
                let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                let _e1099 = local_5.member[1u];
                let _e1105 = select(_e1099[0], -(_e1099[0]), (_e1099[0] < 0.0lf));
                let _e1108 = select(_e1099[1], -(_e1099[1]), (_e1099[1] < 0.0lf));
                let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                let _e1113 = select(_e1099[2], -(_e1099[2]), (_e1099[2] < 0.0lf));
                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                let _e1119 = local_5.member_3;
                let _e1123 = local_5.member_1[0u];
                let _e1129 = select(_e1123[0], -(_e1123[0]), (_e1123[0] < 0.0lf));
                let _e1132 = select(_e1123[1], -(_e1123[1]), (_e1123[1] < 0.0lf));
                let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                let _e1137 = select(_e1123[2], -(_e1123[2]), (_e1123[2] < 0.0lf));
                let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                let _e1142 = local_5.member_1[1u];
                let _e1148 = select(_e1142[0], -(_e1142[0]), (_e1142[0] < 0.0lf));
                let _e1151 = select(_e1142[1], -(_e1142[1]), (_e1142[1] < 0.0lf));
                let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                let _e1156 = select(_e1142[2], -(_e1142[2]), (_e1142[2] < 0.0lf));
                let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                let _e1162 = local_5.member_3;
                let _e1166 = local_5.member_2[0u];
                let _e1172 = select(_e1166[0], -(_e1166[0]), (_e1166[0] < 0.0lf));
                let _e1175 = select(_e1166[1], -(_e1166[1]), (_e1166[1] < 0.0lf));
                let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                let _e1180 = select(_e1166[2], -(_e1166[2]), (_e1166[2] < 0.0lf));
                let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                let _e1185 = local_5.member_2[1u];
                let _e1191 = select(_e1185[0], -(_e1185[0]), (_e1185[0] < 0.0lf));
                let _e1194 = select(_e1185[1], -(_e1185[1]), (_e1185[1] < 0.0lf));
                let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                let _e1199 = select(_e1185[2], -(_e1185[2]), (_e1185[2] < 0.0lf));
                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                let _e1205 = local_5.member_3;
                let _e1213 = local_5.member_3;
                let _e1223 = (((_e1072 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e1115, _e1096, (_e1096 > _e1115)) + _e1119) + (select(_e1158, _e1139, (_e1139 > _e1158)) + _e1162)) + (select(_e1201, _e1182, (_e1182 > _e1201)) + _e1205)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1213 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e906.member_1);
                if _e1223 {
                    phi_3292_ = type_38();
                    phi_3293_ = true;
                } else {
                    let _e1226 = local_5.member_1[0u];
                    let _e1232 = local_5.member_2[0u];
                    let _e1238 = ((_e1226[1] * _e1232[2]) - (_e1226[2] * _e1232[1]));
                    let _e1241 = ((_e1226[2] * _e1232[0]) - (_e1226[0] * _e1232[2]));
                    let _e1244 = ((_e1226[0] * _e1232[1]) - (_e1226[1] * _e1232[0]));
                    let _e1247 = local_5.member_1[1u];
                    let _e1253 = local_5.member_2[1u];
                    let _e1259 = ((_e1247[1] * _e1253[2]) - (_e1247[2] * _e1253[1]));
                    let _e1262 = ((_e1247[2] * _e1253[0]) - (_e1247[0] * _e1253[2]));
                    let _e1265 = ((_e1247[0] * _e1253[1]) - (_e1247[1] * _e1253[0]));
                    let _e1268 = local_5.member_1[0u];
                    let _e1274 = local_5.member_2[1u];
                    let _e1289 = local_5.member_1[1u];
                    let _e1295 = local_5.member_2[0u];
                    let _e1308 = (((_e1268[1] * _e1274[2]) - (_e1268[2] * _e1274[1])) + ((_e1289[1] * _e1295[2]) - (_e1289[2] * _e1295[1])));
                    let _e1309 = (((_e1268[2] * _e1274[0]) - (_e1268[0] * _e1274[2])) + ((_e1289[2] * _e1295[0]) - (_e1289[0] * _e1295[2])));
                    let _e1310 = (((_e1268[0] * _e1274[1]) - (_e1268[1] * _e1274[0])) + ((_e1289[0] * _e1295[1]) - (_e1289[1] * _e1295[0])));
                    let _e1313 = local_5.member[0u];
                    let _e1324 = local_5.member[1u];
                    let _e1335 = local_5.member[0u];
                    let _e1344 = ((((_e1324[0] * _e1238) + (_e1324[1] * _e1241)) + (_e1324[2] * _e1244)) + (((_e1335[0] * _e1308) + (_e1335[1] * _e1309)) + (_e1335[2] * _e1310)));
                    let _e1347 = local_5.member[0u];
                    let _e1358 = local_5.member[1u];
                    let _e1367 = ((((_e1347[0] * _e1259) + (_e1347[1] * _e1262)) + (_e1347[2] * _e1265)) + (((_e1358[0] * _e1308) + (_e1358[1] * _e1309)) + (_e1358[2] * _e1310)));
                    let _e1370 = local_5.member[1u];
                    let _e1381 = local_5.member[0u];
                    let _e1387 = select(_e1381[0], -(_e1381[0]), (_e1381[0] < 0.0lf));
                    let _e1390 = select(_e1381[1], -(_e1381[1]), (_e1381[1] < 0.0lf));
                    let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                    let _e1395 = select(_e1381[2], -(_e1381[2]), (_e1381[2] < 0.0lf));
                    let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                    let _e1400 = local_5.member[1u];
                    let _e1406 = select(_e1400[0], -(_e1400[0]), (_e1400[0] < 0.0lf));
                    let _e1409 = select(_e1400[1], -(_e1400[1]), (_e1400[1] < 0.0lf));
                    let _e1411 = select(_e1409, _e1406, (_e1406 > _e1409));
                    let _e1414 = select(_e1400[2], -(_e1400[2]), (_e1400[2] < 0.0lf));
                    let _e1416 = select(_e1414, _e1411, (_e1411 > _e1414));
                    let _e1420 = local_5.member_3;
                    let _e1421 = (select(_e1416, _e1397, (_e1397 > _e1416)) + _e1420);
                    let _e1424 = local_5.member_1[0u];
                    let _e1430 = select(_e1424[0], -(_e1424[0]), (_e1424[0] < 0.0lf));
                    let _e1433 = select(_e1424[1], -(_e1424[1]), (_e1424[1] < 0.0lf));
                    let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                    let _e1438 = select(_e1424[2], -(_e1424[2]), (_e1424[2] < 0.0lf));
                    let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                    let _e1443 = local_5.member_1[1u];
                    let _e1449 = select(_e1443[0], -(_e1443[0]), (_e1443[0] < 0.0lf));
                    let _e1452 = select(_e1443[1], -(_e1443[1]), (_e1443[1] < 0.0lf));
                    let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                    let _e1457 = select(_e1443[2], -(_e1443[2]), (_e1443[2] < 0.0lf));
                    let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                    let _e1463 = local_5.member_3;
                    let _e1464 = (select(_e1459, _e1440, (_e1440 > _e1459)) + _e1463);
                    let _e1467 = local_5.member_2[0u];
                    let _e1473 = select(_e1467[0], -(_e1467[0]), (_e1467[0] < 0.0lf));
                    let _e1476 = select(_e1467[1], -(_e1467[1]), (_e1467[1] < 0.0lf));
                    let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                    let _e1481 = select(_e1467[2], -(_e1467[2]), (_e1467[2] < 0.0lf));
                    let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                    let _e1486 = local_5.member_2[1u];
                    let _e1492 = select(_e1486[0], -(_e1486[0]), (_e1486[0] < 0.0lf));
                    let _e1495 = select(_e1486[1], -(_e1486[1]), (_e1486[1] < 0.0lf));
                    let _e1497 = select(_e1495, _e1492, (_e1492 > _e1495));
                    let _e1500 = select(_e1486[2], -(_e1486[2]), (_e1486[2] < 0.0lf));
                    let _e1502 = select(_e1500, _e1497, (_e1497 > _e1500));
                    let _e1506 = local_5.member_3;
                    let _e1507 = (select(_e1502, _e1483, (_e1483 > _e1502)) + _e1506);
                    let _e1508 = f64(1f);
                    let _e1509 = f64(8f);
                    let _e1511 = ((_e1464 * _e1509) * _e1507);
                    let _e1519 = local_5.member_3;
                    let _e1546 = ((select(_e1238, -(_e1238), (_e1238 < 0.0lf)) + select(_e1241, -(_e1241), (_e1241 < 0.0lf))) + select(_e1244, -(_e1244), (_e1244 < 0.0lf)));
                    let _e1557 = ((select(_e1259, -(_e1259), (_e1259 < 0.0lf)) + select(_e1262, -(_e1262), (_e1262 < 0.0lf))) + select(_e1265, -(_e1265), (_e1265 < 0.0lf)));
                    let _e1559 = select(_e1557, _e1546, (_e1546 > _e1557));
                    let _e1571 = (((select(_e1308, -(_e1308), (_e1308 < 0.0lf)) + select(_e1309, -(_e1309), (_e1309 < 0.0lf))) + select(_e1310, -(_e1310), (_e1310 < 0.0lf))) * f64(0.5f));
                    let _e1579 = local_5.member_3;
                    let _e1594 = f64(3f);
                    let _e1595 = ((((_e1313[0] * _e1238) + (_e1313[1] * _e1241)) + (_e1313[2] * _e1244)) * _e1594);
                    let _e1596 = ((((_e1370[0] * _e1259) + (_e1370[1] * _e1262)) + (_e1370[2] * _e1265)) * _e1594);
                    let _e1598 = select(_e1596, _e1595, (_e1595 < _e1596));
                    let _e1600 = select(_e1367, _e1344, (_e1344 < _e1367));
                    let _e1602 = select(_e1600, _e1598, (_e1598 < _e1600));
                    let _e1604 = select(_e1596, _e1595, (_e1595 > _e1596));
                    let _e1606 = select(_e1367, _e1344, (_e1344 > _e1367));
                    let _e1609 = -(select(_e1606, _e1604, (_e1604 > _e1606)));
                    if ((select(_e1609, _e1602, (_e1602 > _e1609)) - ((((((_e1421 * _e1509) * _e1511) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1519 * f64(19f)) * ((_e1421 * (_e1464 + _e1507)) + (_e1464 * _e1507)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1508 + _e1421) * ((_e1508 + _e1464) * (_e1508 + _e1507))))) + ((_e906.member_1 * (((select(_e1571, _e1559, (_e1559 > _e1571)) + (_e1511 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1579 * f64(6f)) * (_e1464 + _e1507))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1508 + _e1464) * (_e1508 + _e1507))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3290_ = type_38(type_37(0u, f64()), 0u);
                        phi_3291_ = false;
                    } else {
                        phi_3290_ = type_38();
                        phi_3291_ = true;
                    }
                    let _e1623 = phi_3290_;
                    let _e1625 = phi_3291_;
                    phi_3292_ = _e1623;
                    phi_3293_ = _e1625;
                }
                let _e1627 = phi_3292_;
                let _e1629 = phi_3293_;
                if _e1629 {
                    phi_3299_ = type_16(0i, 2i);
                    phi_3302_ = _e543;
                    phi_3304_ = 0u;
                    phi_3306_ = _e543;
                    loop {
                        let _e1631 = phi_3299_;
                        let _e1633 = phi_3302_;
                        let _e1635 = phi_3304_;
                        let _e1637 = phi_3306_;
                        local_54 = _e1635;
                        local_57 = _e1633;
                        local_58 = _e1635;
                        if (_e1631.member < _e1631.member_1) {
                            let _e1644 = (_e1631.member + 1i);
                            phi_3300_ = type_16(select(_e1644, type_17().member_1, select(false, true, ((false == (_e1644 > _e1631.member)) != false))), _e1631.member_1);
                            phi_3347_ = type_17(1u, _e1631.member);
                        } else {
                            phi_3300_ = _e1631;
                            phi_3347_ = type_17(0u, type_17().member_1);
                        }
                        let _e1655 = phi_3300_;
                        let _e1657 = phi_3347_;
                        if (bitcast<i32>(_e1657.member) != 0i) {
                            if select(select(true, false, _e1223), true, (_e1657.member_1 > 0i)) {
                                let _e1667 = local_5.member[0u];
                                let _e1673 = local_5.member_1[0u];
                                let _e1679 = local_5.member_2[0u];
                                let _e1683 = (_e1667[0] - _e1673[0]);
                                let _e1684 = (_e1667[1] - _e1673[1]);
                                let _e1685 = (_e1667[2] - _e1673[2]);
                                let _e1686 = (_e231.member == 0u);
                                let _e1698 = local_5.member[1u];
                                let _e1704 = local_5.member_1[1u];
                                let _e1710 = local_5.member_2[1u];
                                let _e1714 = (_e1698[0] - _e1704[0]);
                                let _e1715 = (_e1698[1] - _e1704[1]);
                                let _e1716 = (_e1698[2] - _e1704[2]);
                                let _e1717 = (_e231.member == 0u);
                                let _e1729 = local_5.member[0u];
                                let _e1735 = select(_e1729[0], -(_e1729[0]), (_e1729[0] < 0.0lf));
                                let _e1738 = select(_e1729[1], -(_e1729[1]), (_e1729[1] < 0.0lf));
                                let _e1740 = select(_e1738, _e1735, (_e1735 > _e1738));
                                let _e1743 = select(_e1729[2], -(_e1729[2]), (_e1729[2] < 0.0lf));
                                let _e1745 = select(_e1743, _e1740, (_e1740 > _e1743));
                                let _e1748 = local_5.member[1u];
                                let _e1754 = select(_e1748[0], -(_e1748[0]), (_e1748[0] < 0.0lf));
                                let _e1757 = select(_e1748[1], -(_e1748[1]), (_e1748[1] < 0.0lf));
                                let _e1759 = select(_e1757, _e1754, (_e1754 > _e1757));
                                let _e1762 = select(_e1748[2], -(_e1748[2]), (_e1748[2] < 0.0lf));
                                let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                let _e1768 = local_5.member_3;
                                let _e1772 = local_5.member_1[0u];
                                let _e1778 = select(_e1772[0], -(_e1772[0]), (_e1772[0] < 0.0lf));
                                let _e1781 = select(_e1772[1], -(_e1772[1]), (_e1772[1] < 0.0lf));
                                let _e1783 = select(_e1781, _e1778, (_e1778 > _e1781));
                                let _e1786 = select(_e1772[2], -(_e1772[2]), (_e1772[2] < 0.0lf));
                                let _e1788 = select(_e1786, _e1783, (_e1783 > _e1786));
                                let _e1791 = local_5.member_1[1u];
                                let _e1797 = select(_e1791[0], -(_e1791[0]), (_e1791[0] < 0.0lf));
                                let _e1800 = select(_e1791[1], -(_e1791[1]), (_e1791[1] < 0.0lf));
                                let _e1802 = select(_e1800, _e1797, (_e1797 > _e1800));
                                let _e1805 = select(_e1791[2], -(_e1791[2]), (_e1791[2] < 0.0lf));
                                let _e1807 = select(_e1805, _e1802, (_e1802 > _e1805));
                                let _e1811 = local_5.member_3;
                                let _e1815 = local_5.member_2[0u];
                                let _e1821 = select(_e1815[0], -(_e1815[0]), (_e1815[0] < 0.0lf));
                                let _e1824 = select(_e1815[1], -(_e1815[1]), (_e1815[1] < 0.0lf));
                                let _e1826 = select(_e1824, _e1821, (_e1821 > _e1824));
                                let _e1829 = select(_e1815[2], -(_e1815[2]), (_e1815[2] < 0.0lf));
                                let _e1831 = select(_e1829, _e1826, (_e1826 > _e1829));
                                let _e1834 = local_5.member_2[1u];
                                let _e1840 = select(_e1834[0], -(_e1834[0]), (_e1834[0] < 0.0lf));
                                let _e1843 = select(_e1834[1], -(_e1834[1]), (_e1834[1] < 0.0lf));
                                let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                let _e1848 = select(_e1834[2], -(_e1834[2]), (_e1834[2] < 0.0lf));
                                let _e1850 = select(_e1848, _e1845, (_e1845 > _e1848));
                                let _e1854 = local_5.member_3;
                                let _e1862 = local_5.member_3;
                                let _e1870 = (_e534 * f64(0.00390625f));
                                let _e1871 = f64(0f);
                                let _e1872 = f64(1f);
                                local_3 = type_39(array<f64, 4>(_e1871, _e1871, _e1871, _e1871), array<f64, 4>(_e1871, _e1871, _e1871, _e1871), array<f64, 4>(_e1872, _e1872, _e1872, _e1872));
                                phi_3790_ = type_9(0u, 96u);
                                phi_3793_ = _e1637;
                                phi_3795_ = _e1637;
                                phi_3797_ = (_e552 - _e1637);
                                phi_3799_ = _e1637;
                                phi_3801_ = false;
                                phi_3803_ = 0u;
                                loop {
                                    let _e1879 = phi_3790_;
                                    let _e1881 = phi_3793_;
                                    let _e1883 = phi_3795_;
                                    let _e1885 = phi_3797_;
                                    let _e1887 = phi_3799_;
                                    let _e1889 = phi_3801_;
                                    let _e1891 = phi_3803_;
                                    local_20 = _e1881;
                                    local_24 = _e1883;
                                    let _e1894 = (_e1879.member < _e1879.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1894)) != 0i) {
                                        let _e1908 = local_5.member[0u];
                                        let _e1914 = local_5.member[1u];
                                        let _e1930 = local_5.member_1[0u];
                                        let _e1936 = local_5.member_1[1u];
                                        let _e1952 = local_5.member_2[0u];
                                        let _e1958 = local_5.member_2[1u];
                                        let _e1972 = function_4(array<f64, 3>((_e1908[0] + ((_e1914[0] - _e1908[0]) * _e1881)), (_e1908[1] + ((_e1914[1] - _e1908[1]) * _e1881)), (_e1908[2] + ((_e1914[2] - _e1908[2]) * _e1881))), array<f64, 3>((_e1930[0] + ((_e1936[0] - _e1930[0]) * _e1881)), (_e1930[1] + ((_e1936[1] - _e1930[1]) * _e1881)), (_e1930[2] + ((_e1936[2] - _e1930[2]) * _e1881))), array<f64, 3>((_e1952[0] + ((_e1958[0] - _e1952[0]) * _e1881)), (_e1952[1] + ((_e1958[1] - _e1952[1]) * _e1881)), (_e1952[2] + ((_e1958[2] - _e1952[2]) * _e1881))), _e231.member);
                                        if (_e1891 == 0u) {
                                            phi_3955_ = _e1972;
                                        } else {
                                            let _e1974 = f64(0f);
                                            phi_3955_ = array<f64, 3>(select(_e1974, _e1972[0], (_e1891 == 1u)), select(_e1974, _e1972[1], (_e1891 == 2u)), select(_e1974, _e1972[2], (_e1891 == 3u)));
                                        }
                                        let _e1986 = phi_3955_;
                                        let _e2000 = ((select(_e1986[0], -(_e1986[0]), (_e1986[0] < 0.0lf)) + select(_e1986[1], -(_e1986[1]), (_e1986[1] < 0.0lf))) + select(_e1986[2], -(_e1986[2]), (_e1986[2] < 0.0lf)));
                                        if (_e2000 > f64(0f)) {
                                            if ((bitcast<u64>(_e2000) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2007 = (f64(1f) / _e2000);
                                                let _e2009 = (_e1986[0] * _e2007);
                                                let _e2011 = (_e1986[1] * _e2007);
                                                let _e2013 = (_e1986[2] * _e2007);
                                                let _e2018 = (((_e2009 * _e2009) + (_e2011 * _e2011)) + (_e2013 * _e2013));
                                                if (_e2018 <= 2.2250738585072014e-308lf) {
                                                    phi_4080_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2018 > 0.0lf));
                                                } else {
                                                    phi_4023_ = type_16(0i, 5i);
                                                    phi_4026_ = bitcast<f64>(((bitcast<u64>(_e2018) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2025 = phi_4023_;
                                                        let _e2027 = phi_4026_;
                                                        local_8 = _e2027;
                                                        if (_e2025.member < _e2025.member_1) {
                                                            let _e2034 = (_e2025.member + 1i);
                                                            phi_4024_ = type_16(select(_e2034, type_17().member_1, select(false, true, ((false == (_e2034 > _e2025.member)) != false))), _e2025.member_1);
                                                            phi_4067_ = type_17(1u, _e2025.member);
                                                        } else {
                                                            phi_4024_ = _e2025;
                                                            phi_4067_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2045 = phi_4024_;
                                                        let _e2047 = phi_4067_;
                                                        let _e2050 = (bitcast<i32>(_e2047.member) != 0i);
                                                        if _e2050 {
                                                            phi_4027_ = (0.5lf * (_e2027 + (_e2018 / _e2027)));
                                                        } else {
                                                            phi_4027_ = f64();
                                                        }
                                                        let _e2055 = phi_4027_;
                                                        continue;
                                                        continuing {
                                                            phi_4023_ = _e2045;
                                                            phi_4026_ = _e2055;
                                                            break if !(_e2050);
                                                        }
                                                    }
                                                    let _e2060 = local_8;
                                                    phi_4080_ = (_e2060 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2066 = phi_4080_;
                                                let _e2068 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2075 = ((((((((select(_e1764, _e1745, (_e1745 > _e1764)) + _e1768) + (select(_e1807, _e1788, (_e1788 > _e1807)) + _e1811)) + (select(_e1850, _e1831, (_e1831 > _e1850)) + _e1854)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1862 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e906.member_1 * _e2066) * (f64(1f) + _e2068)));
                                                let _e2080 = (((_e2009 * _e1667[0]) + (_e2011 * _e1667[1])) + (_e2013 * _e1667[2]));
                                                let _e2085 = (((_e2009 * _e1683) + (_e2011 * _e1684)) + (_e2013 * _e1685));
                                                let _e2090 = (((_e2009 * (_e1667[0] - _e1679[0])) + (_e2011 * (_e1667[1] - _e1679[1]))) + (_e2013 * (_e1667[2] - _e1679[2])));
                                                let _e2095 = (((_e2009 * select((_e1683 - _e1679[0]), _e1667[0], _e1686)) + (_e2011 * select((_e1684 - _e1679[1]), _e1667[1], _e1686))) + (_e2013 * select((_e1685 - _e1679[2]), _e1667[2], _e1686)));
                                                let _e2101 = (((_e2009 * _e1698[0]) + (_e2011 * _e1698[1])) + (_e2013 * _e1698[2]));
                                                let _e2106 = (((_e2009 * _e1714) + (_e2011 * _e1715)) + (_e2013 * _e1716));
                                                let _e2111 = (((_e2009 * (_e1698[0] - _e1710[0])) + (_e2011 * (_e1698[1] - _e1710[1]))) + (_e2013 * (_e1698[2] - _e1710[2])));
                                                let _e2116 = (((_e2009 * select((_e1714 - _e1710[0]), _e1698[0], _e1717)) + (_e2011 * select((_e1715 - _e1710[1]), _e1698[1], _e1717))) + (_e2013 * select((_e1716 - _e1710[2]), _e1698[2], _e1717)));
                                                phi_4206_ = type_39(array<f64, 4>(_e2080, _e2085, _e2090, _e2095), array<f64, 4>(_e2101, _e2106, _e2111, _e2116), array<f64, 4>((_e2075 + ((select(_e2080, -(_e2080), (_e2080 < 0.0lf)) + select(_e2101, -(_e2101), (_e2101 < 0.0lf))) * _e2068)), (_e2075 + ((select(_e2085, -(_e2085), (_e2085 < 0.0lf)) + select(_e2106, -(_e2106), (_e2106 < 0.0lf))) * _e2068)), (_e2075 + ((select(_e2090, -(_e2090), (_e2090 < 0.0lf)) + select(_e2111, -(_e2111), (_e2111 < 0.0lf))) * _e2068)), (_e2075 + ((select(_e2095, -(_e2095), (_e2095 < 0.0lf)) + select(_e2116, -(_e2116), (_e2116 < 0.0lf))) * _e2068))));
                                                phi_4207_ = false;
                                            } else {
                                                phi_4206_ = type_39();
                                                phi_4207_ = true;
                                            }
                                            let _e2157 = phi_4206_;
                                            let _e2159 = phi_4207_;
                                            phi_4208_ = _e2157;
                                            phi_4209_ = _e2159;
                                        } else {
                                            phi_4208_ = type_39();
                                            phi_4209_ = true;
                                        }
                                        let _e2161 = phi_4208_;
                                        let _e2163 = phi_4209_;
                                        if _e2163 {
                                            let _e2164 = f64(0f);
                                            let _e2165 = f64(1f);
                                            phi_4219_ = type_39(array<f64, 4>(_e2164, _e2164, _e2164, _e2164), array<f64, 4>(_e2164, _e2164, _e2164, _e2164), array<f64, 4>(_e2165, _e2165, _e2165, _e2165));
                                        } else {
                                            phi_4219_ = _e2161;
                                        }
                                        let _e2171 = phi_4219_;
                                        local_4 = type_39(array<f64, 4>(_e2171.member[0], _e2171.member[1], _e2171.member[2], _e2171.member[3]), array<f64, 4>(_e2171.member_1[0], _e2171.member_1[1], _e2171.member_1[2], _e2171.member_1[3]), array<f64, 4>(_e2171.member_2[0], _e2171.member_2[1], _e2171.member_2[2], _e2171.member_2[3]));
                                        let _e2191 = (_e1881 - _e1887);
                                        let _e2193 = f64(0f);
                                        let _e2196 = local_4.member[0u];
                                        let _e2199 = local_4.member_1[0u];
                                        let _e2202 = local_4.member[0u];
                                        let _e2208 = local_4.member_2[0u];
                                        if (((_e2196 + ((_e2199 - _e2202) * _e1881)) - _e2208) > _e2193) {
                                            let _e2213 = local_4.member[1u];
                                            let _e2216 = local_4.member_1[1u];
                                            let _e2219 = local_4.member[1u];
                                            let _e2225 = local_4.member_2[1u];
                                            if (((_e2213 + ((_e2216 - _e2219) * _e1881)) - _e2225) > _e2193) {
                                                let _e2230 = local_4.member[2u];
                                                let _e2233 = local_4.member_1[2u];
                                                let _e2236 = local_4.member[2u];
                                                let _e2242 = local_4.member_2[2u];
                                                if (((_e2230 + ((_e2233 - _e2236) * _e1881)) - _e2242) > _e2193) {
                                                    let _e2247 = local_4.member[3u];
                                                    let _e2250 = local_4.member_1[3u];
                                                    let _e2253 = local_4.member[3u];
                                                    let _e2259 = local_4.member_2[3u];
                                                    phi_4391_ = (((_e2247 + ((_e2250 - _e2253) * _e1881)) - _e2259) > _e2193);
                                                    phi_4392_ = false;
                                                } else {
                                                    phi_4391_ = bool();
                                                    phi_4392_ = true;
                                                }
                                                let _e2263 = phi_4391_;
                                                let _e2265 = phi_4392_;
                                                phi_4393_ = _e2263;
                                                phi_4394_ = _e2265;
                                            } else {
                                                phi_4393_ = bool();
                                                phi_4394_ = true;
                                            }
                                            let _e2267 = phi_4393_;
                                            let _e2269 = phi_4394_;
                                            phi_4395_ = _e2267;
                                            phi_4396_ = _e2269;
                                        } else {
                                            phi_4395_ = bool();
                                            phi_4396_ = true;
                                        }
                                        let _e2271 = phi_4395_;
                                        let _e2273 = phi_4396_;
                                        if select(_e2271, false, _e2273) {
                                            if (_e1881 <= _e1883) {
                                                phi_4711_ = true;
                                            } else {
                                                let _e2276 = f64(0f);
                                                let _e2279 = local_3.member[0u];
                                                let _e2282 = local_3.member_1[0u];
                                                let _e2285 = local_3.member[0u];
                                                let _e2291 = local_3.member_2[0u];
                                                let _e2295 = local_4.member[0u];
                                                let _e2298 = local_4.member_1[0u];
                                                let _e2301 = local_4.member[0u];
                                                let _e2307 = local_4.member_2[0u];
                                                if ((((_e2279 + ((_e2282 - _e2285) * _e1881)) - _e2291) + ((_e2295 + ((_e2298 - _e2301) * _e1887)) - _e2307)) > _e2276) {
                                                    let _e2313 = local_3.member[1u];
                                                    let _e2316 = local_3.member_1[1u];
                                                    let _e2319 = local_3.member[1u];
                                                    let _e2325 = local_3.member_2[1u];
                                                    let _e2329 = local_4.member[1u];
                                                    let _e2332 = local_4.member_1[1u];
                                                    let _e2335 = local_4.member[1u];
                                                    let _e2341 = local_4.member_2[1u];
                                                    if ((((_e2313 + ((_e2316 - _e2319) * _e1881)) - _e2325) + ((_e2329 + ((_e2332 - _e2335) * _e1887)) - _e2341)) > _e2276) {
                                                        let _e2347 = local_3.member[2u];
                                                        let _e2350 = local_3.member_1[2u];
                                                        let _e2353 = local_3.member[2u];
                                                        let _e2359 = local_3.member_2[2u];
                                                        let _e2363 = local_4.member[2u];
                                                        let _e2366 = local_4.member_1[2u];
                                                        let _e2369 = local_4.member[2u];
                                                        let _e2375 = local_4.member_2[2u];
                                                        if ((((_e2347 + ((_e2350 - _e2353) * _e1881)) - _e2359) + ((_e2363 + ((_e2366 - _e2369) * _e1887)) - _e2375)) > _e2276) {
                                                            let _e2381 = local_3.member[3u];
                                                            let _e2384 = local_3.member_1[3u];
                                                            let _e2387 = local_3.member[3u];
                                                            let _e2393 = local_3.member_2[3u];
                                                            let _e2397 = local_4.member[3u];
                                                            let _e2400 = local_4.member_1[3u];
                                                            let _e2403 = local_4.member[3u];
                                                            let _e2409 = local_4.member_2[3u];
                                                            phi_4698_ = ((((_e2381 + ((_e2384 - _e2387) * _e1881)) - _e2393) + ((_e2397 + ((_e2400 - _e2403) * _e1887)) - _e2409)) > _e2276);
                                                            phi_4699_ = false;
                                                        } else {
                                                            phi_4698_ = bool();
                                                            phi_4699_ = true;
                                                        }
                                                        let _e2414 = phi_4698_;
                                                        let _e2416 = phi_4699_;
                                                        phi_4700_ = _e2414;
                                                        phi_4701_ = _e2416;
                                                    } else {
                                                        phi_4700_ = bool();
                                                        phi_4701_ = true;
                                                    }
                                                    let _e2418 = phi_4700_;
                                                    let _e2420 = phi_4701_;
                                                    phi_4702_ = _e2418;
                                                    phi_4703_ = _e2420;
                                                } else {
                                                    phi_4702_ = bool();
                                                    phi_4703_ = true;
                                                }
                                                let _e2422 = phi_4702_;
                                                let _e2424 = phi_4703_;
                                                phi_4711_ = select(_e2422, false, _e2424);
                                            }
                                            let _e2427 = phi_4711_;
                                            if _e2427 {
                                                if select(true, select(true, false, (_e1881 >= _e552)), _e1889) {
                                                    local_3 = type_39(array<f64, 4>(_e2171.member[0], _e2171.member[1], _e2171.member[2], _e2171.member[3]), array<f64, 4>(_e2171.member_1[0], _e2171.member_1[1], _e2171.member_1[2], _e2171.member_1[3]), array<f64, 4>(_e2171.member_2[0], _e2171.member_2[1], _e2171.member_2[2], _e2171.member_2[3]));
                                                    let _e2452 = local_3.member[0u];
                                                    let _e2455 = local_3.member_1[0u];
                                                    let _e2458 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2455 > _e2458)), (_e2452 > _e2458)) {
                                                        let _e2463 = (_e2455 >= _e2452);
                                                        if _e2463 {
                                                            phi_4823_ = f64();
                                                            phi_4824_ = false;
                                                        } else {
                                                            if ((_e2452 - _e2455) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4821_ = (((_e2452 - _e2458) / (_e2452 - _e2455)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4822_ = false;
                                                            } else {
                                                                phi_4821_ = f64();
                                                                phi_4822_ = true;
                                                            }
                                                            let _e2477 = phi_4821_;
                                                            let _e2479 = phi_4822_;
                                                            phi_4823_ = _e2477;
                                                            phi_4824_ = _e2479;
                                                        }
                                                        let _e2481 = phi_4823_;
                                                        let _e2483 = phi_4824_;
                                                        phi_4825_ = _e2481;
                                                        phi_4826_ = _e2463;
                                                        phi_4827_ = _e2483;
                                                    } else {
                                                        phi_4825_ = f64();
                                                        phi_4826_ = true;
                                                        phi_4827_ = false;
                                                    }
                                                    let _e2485 = phi_4825_;
                                                    let _e2487 = phi_4826_;
                                                    let _e2489 = phi_4827_;
                                                    let _e2493 = select(_e2485, select(_e1881, f64(2f), _e2487), select(_e2489, true, _e2487));
                                                    let _e2496 = local_3.member[1u];
                                                    let _e2499 = local_3.member_1[1u];
                                                    let _e2502 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2499 > _e2502)), (_e2496 > _e2502)) {
                                                        let _e2507 = (_e2499 >= _e2496);
                                                        if _e2507 {
                                                            phi_4895_ = f64();
                                                            phi_4896_ = false;
                                                        } else {
                                                            if ((_e2496 - _e2499) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4893_ = (((_e2496 - _e2502) / (_e2496 - _e2499)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4894_ = false;
                                                            } else {
                                                                phi_4893_ = f64();
                                                                phi_4894_ = true;
                                                            }
                                                            let _e2521 = phi_4893_;
                                                            let _e2523 = phi_4894_;
                                                            phi_4895_ = _e2521;
                                                            phi_4896_ = _e2523;
                                                        }
                                                        let _e2525 = phi_4895_;
                                                        let _e2527 = phi_4896_;
                                                        phi_4897_ = _e2525;
                                                        phi_4898_ = _e2507;
                                                        phi_4899_ = _e2527;
                                                    } else {
                                                        phi_4897_ = f64();
                                                        phi_4898_ = true;
                                                        phi_4899_ = false;
                                                    }
                                                    let _e2529 = phi_4897_;
                                                    let _e2531 = phi_4898_;
                                                    let _e2533 = phi_4899_;
                                                    let _e2537 = select(_e2529, select(_e1881, f64(2f), _e2531), select(_e2533, true, _e2531));
                                                    let _e2539 = select(_e2537, _e2493, (_e2493 < _e2537));
                                                    let _e2542 = local_3.member[2u];
                                                    let _e2545 = local_3.member_1[2u];
                                                    let _e2548 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2545 > _e2548)), (_e2542 > _e2548)) {
                                                        let _e2553 = (_e2545 >= _e2542);
                                                        if _e2553 {
                                                            phi_4972_ = f64();
                                                            phi_4973_ = false;
                                                        } else {
                                                            if ((_e2542 - _e2545) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4970_ = (((_e2542 - _e2548) / (_e2542 - _e2545)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4971_ = false;
                                                            } else {
                                                                phi_4970_ = f64();
                                                                phi_4971_ = true;
                                                            }
                                                            let _e2567 = phi_4970_;
                                                            let _e2569 = phi_4971_;
                                                            phi_4972_ = _e2567;
                                                            phi_4973_ = _e2569;
                                                        }
                                                        let _e2571 = phi_4972_;
                                                        let _e2573 = phi_4973_;
                                                        phi_4974_ = _e2571;
                                                        phi_4975_ = _e2553;
                                                        phi_4976_ = _e2573;
                                                    } else {
                                                        phi_4974_ = f64();
                                                        phi_4975_ = true;
                                                        phi_4976_ = false;
                                                    }
                                                    let _e2575 = phi_4974_;
                                                    let _e2577 = phi_4975_;
                                                    let _e2579 = phi_4976_;
                                                    let _e2583 = select(_e2575, select(_e1881, f64(2f), _e2577), select(_e2579, true, _e2577));
                                                    let _e2586 = local_3.member[3u];
                                                    let _e2589 = local_3.member_1[3u];
                                                    let _e2592 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2589 > _e2592)), (_e2586 > _e2592)) {
                                                        let _e2597 = (_e2589 >= _e2586);
                                                        if _e2597 {
                                                            phi_5044_ = f64();
                                                            phi_5045_ = false;
                                                        } else {
                                                            if ((_e2586 - _e2589) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5042_ = (((_e2586 - _e2592) / (_e2586 - _e2589)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5043_ = false;
                                                            } else {
                                                                phi_5042_ = f64();
                                                                phi_5043_ = true;
                                                            }
                                                            let _e2611 = phi_5042_;
                                                            let _e2613 = phi_5043_;
                                                            phi_5044_ = _e2611;
                                                            phi_5045_ = _e2613;
                                                        }
                                                        let _e2615 = phi_5044_;
                                                        let _e2617 = phi_5045_;
                                                        phi_5046_ = _e2615;
                                                        phi_5047_ = _e2597;
                                                        phi_5048_ = _e2617;
                                                    } else {
                                                        phi_5046_ = f64();
                                                        phi_5047_ = true;
                                                        phi_5048_ = false;
                                                    }
                                                    let _e2619 = phi_5046_;
                                                    let _e2621 = phi_5047_;
                                                    let _e2623 = phi_5048_;
                                                    let _e2627 = select(_e2619, select(_e1881, f64(2f), _e2621), select(_e2623, true, _e2621));
                                                    let _e2629 = select(_e2627, _e2583, (_e2583 < _e2627));
                                                    let _e2631 = select(_e2629, _e2539, (_e2539 < _e2629));
                                                    let _e2633 = select(_e1881, _e2631, (_e2631 > _e1881));
                                                    let _e2634 = (_e2633 > _e552);
                                                    if _e2634 {
                                                        phi_5590_ = f64();
                                                        phi_5591_ = f64();
                                                        phi_5592_ = false;
                                                        phi_5593_ = false;
                                                    } else {
                                                        let _e2635 = (_e2633 - _e1881);
                                                        let _e2636 = (_e2635 <= _e1870);
                                                        let _e2639 = (_e2633 + (_e534 * f64(0.01f)));
                                                        let _e2641 = select(_e552, _e2639, (_e2639 < _e552));
                                                        if _e2636 {
                                                            if (_e906.member_1 > f64(0f)) {
                                                                let _e2646 = local_5.member[0u];
                                                                let _e2652 = local_5.member[1u];
                                                                let _e2668 = local_5.member_1[0u];
                                                                let _e2674 = local_5.member_1[1u];
                                                                let _e2690 = local_5.member_2[0u];
                                                                let _e2696 = local_5.member_2[1u];
                                                                let _e2710 = function_4(array<f64, 3>((_e2646[0] + ((_e2652[0] - _e2646[0]) * _e2641)), (_e2646[1] + ((_e2652[1] - _e2646[1]) * _e2641)), (_e2646[2] + ((_e2652[2] - _e2646[2]) * _e2641))), array<f64, 3>((_e2668[0] + ((_e2674[0] - _e2668[0]) * _e2641)), (_e2668[1] + ((_e2674[1] - _e2668[1]) * _e2641)), (_e2668[2] + ((_e2674[2] - _e2668[2]) * _e2641))), array<f64, 3>((_e2690[0] + ((_e2696[0] - _e2690[0]) * _e2641)), (_e2690[1] + ((_e2696[1] - _e2690[1]) * _e2641)), (_e2690[2] + ((_e2696[2] - _e2690[2]) * _e2641))), _e231.member);
                                                                let _e2721 = (((_e2710[0] * _e2710[0]) + (_e2710[1] * _e2710[1])) + (_e2710[2] * _e2710[2]));
                                                                if (_e2721 <= 2.2250738585072014e-308lf) {
                                                                    phi_5282_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2721 > 0.0lf));
                                                                } else {
                                                                    phi_5225_ = type_16(0i, 5i);
                                                                    phi_5228_ = bitcast<f64>(((bitcast<u64>(_e2721) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2728 = phi_5225_;
                                                                        let _e2730 = phi_5228_;
                                                                        local_9 = _e2730;
                                                                        if (_e2728.member < _e2728.member_1) {
                                                                            let _e2737 = (_e2728.member + 1i);
                                                                            phi_5226_ = type_16(select(_e2737, type_17().member_1, select(false, true, ((false == (_e2737 > _e2728.member)) != false))), _e2728.member_1);
                                                                            phi_5269_ = type_17(1u, _e2728.member);
                                                                        } else {
                                                                            phi_5226_ = _e2728;
                                                                            phi_5269_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e2748 = phi_5226_;
                                                                        let _e2750 = phi_5269_;
                                                                        let _e2753 = (bitcast<i32>(_e2750.member) != 0i);
                                                                        if _e2753 {
                                                                            phi_5229_ = (0.5lf * (_e2730 + (_e2721 / _e2730)));
                                                                        } else {
                                                                            phi_5229_ = f64();
                                                                        }
                                                                        let _e2758 = phi_5229_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5225_ = _e2748;
                                                                            phi_5228_ = _e2758;
                                                                            break if !(_e2753);
                                                                        }
                                                                    }
                                                                    let _e2763 = local_9;
                                                                    phi_5282_ = (_e2763 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2769 = phi_5282_;
                                                                let _e2777 = local_5.member[0u];
                                                                let _e2783 = select(_e2777[0], -(_e2777[0]), (_e2777[0] < 0.0lf));
                                                                let _e2786 = select(_e2777[1], -(_e2777[1]), (_e2777[1] < 0.0lf));
                                                                let _e2788 = select(_e2786, _e2783, (_e2783 > _e2786));
                                                                let _e2791 = select(_e2777[2], -(_e2777[2]), (_e2777[2] < 0.0lf));
                                                                let _e2793 = select(_e2791, _e2788, (_e2788 > _e2791));
                                                                let _e2796 = local_5.member[1u];
                                                                let _e2802 = select(_e2796[0], -(_e2796[0]), (_e2796[0] < 0.0lf));
                                                                let _e2805 = select(_e2796[1], -(_e2796[1]), (_e2796[1] < 0.0lf));
                                                                let _e2807 = select(_e2805, _e2802, (_e2802 > _e2805));
                                                                let _e2810 = select(_e2796[2], -(_e2796[2]), (_e2796[2] < 0.0lf));
                                                                let _e2812 = select(_e2810, _e2807, (_e2807 > _e2810));
                                                                let _e2816 = local_5.member_3;
                                                                let _e2820 = local_5.member_1[0u];
                                                                let _e2826 = select(_e2820[0], -(_e2820[0]), (_e2820[0] < 0.0lf));
                                                                let _e2829 = select(_e2820[1], -(_e2820[1]), (_e2820[1] < 0.0lf));
                                                                let _e2831 = select(_e2829, _e2826, (_e2826 > _e2829));
                                                                let _e2834 = select(_e2820[2], -(_e2820[2]), (_e2820[2] < 0.0lf));
                                                                let _e2836 = select(_e2834, _e2831, (_e2831 > _e2834));
                                                                let _e2839 = local_5.member_1[1u];
                                                                let _e2845 = select(_e2839[0], -(_e2839[0]), (_e2839[0] < 0.0lf));
                                                                let _e2848 = select(_e2839[1], -(_e2839[1]), (_e2839[1] < 0.0lf));
                                                                let _e2850 = select(_e2848, _e2845, (_e2845 > _e2848));
                                                                let _e2853 = select(_e2839[2], -(_e2839[2]), (_e2839[2] < 0.0lf));
                                                                let _e2855 = select(_e2853, _e2850, (_e2850 > _e2853));
                                                                let _e2859 = local_5.member_3;
                                                                let _e2863 = local_5.member_2[0u];
                                                                let _e2869 = select(_e2863[0], -(_e2863[0]), (_e2863[0] < 0.0lf));
                                                                let _e2872 = select(_e2863[1], -(_e2863[1]), (_e2863[1] < 0.0lf));
                                                                let _e2874 = select(_e2872, _e2869, (_e2869 > _e2872));
                                                                let _e2877 = select(_e2863[2], -(_e2863[2]), (_e2863[2] < 0.0lf));
                                                                let _e2879 = select(_e2877, _e2874, (_e2874 > _e2877));
                                                                let _e2882 = local_5.member_2[1u];
                                                                let _e2888 = select(_e2882[0], -(_e2882[0]), (_e2882[0] < 0.0lf));
                                                                let _e2891 = select(_e2882[1], -(_e2882[1]), (_e2882[1] < 0.0lf));
                                                                let _e2893 = select(_e2891, _e2888, (_e2888 > _e2891));
                                                                let _e2896 = select(_e2882[2], -(_e2882[2]), (_e2882[2] < 0.0lf));
                                                                let _e2898 = select(_e2896, _e2893, (_e2893 > _e2896));
                                                                let _e2902 = local_5.member_3;
                                                                let _e2910 = local_5.member_3;
                                                                phi_5559_ = select(true, false, (((_e2769 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2812, _e2793, (_e2793 > _e2812)) + _e2816) + (select(_e2855, _e2836, (_e2836 > _e2855)) + _e2859)) + (select(_e2898, _e2879, (_e2879 > _e2898)) + _e2902)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2910 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e906.member_1));
                                                            } else {
                                                                phi_5559_ = true;
                                                            }
                                                            let _e2923 = phi_5559_;
                                                            phi_5560_ = _e2923;
                                                        } else {
                                                            phi_5560_ = true;
                                                        }
                                                        let _e2925 = phi_5560_;
                                                        if _e2925 {
                                                            if _e1889 {
                                                                let _e2929 = (_e2635 <= (_e1885 * f64(0.25f)));
                                                                phi_5587_ = select(select(select(f64(), f64(0f), _e2929), f64(), _e2636), (_e2191 + _e2191), select(select(true, false, _e2929), true, _e2636));
                                                            } else {
                                                                phi_5587_ = (_e552 - _e1881);
                                                            }
                                                            let _e2938 = phi_5587_;
                                                            phi_5588_ = _e2938;
                                                            phi_5589_ = false;
                                                        } else {
                                                            phi_5588_ = f64();
                                                            phi_5589_ = true;
                                                        }
                                                        let _e2940 = phi_5588_;
                                                        let _e2942 = phi_5589_;
                                                        phi_5590_ = _e2940;
                                                        phi_5591_ = _e2635;
                                                        phi_5592_ = _e2925;
                                                        phi_5593_ = _e2942;
                                                    }
                                                    let _e2944 = phi_5590_;
                                                    let _e2946 = phi_5591_;
                                                    let _e2948 = phi_5592_;
                                                    let _e2950 = phi_5593_;
                                                    phi_5594_ = _e2633;
                                                    phi_5595_ = _e2944;
                                                    phi_5596_ = _e2946;
                                                    phi_5597_ = _e2633;
                                                    phi_5598_ = _e2948;
                                                    phi_5599_ = _e2634;
                                                    phi_5600_ = _e2950;
                                                    phi_5601_ = false;
                                                } else {
                                                    phi_5594_ = f64();
                                                    phi_5595_ = f64();
                                                    phi_5596_ = f64();
                                                    phi_5597_ = f64();
                                                    phi_5598_ = false;
                                                    phi_5599_ = false;
                                                    phi_5600_ = false;
                                                    phi_5601_ = true;
                                                }
                                                let _e2952 = phi_5594_;
                                                let _e2954 = phi_5595_;
                                                let _e2956 = phi_5596_;
                                                let _e2958 = phi_5597_;
                                                let _e2960 = phi_5598_;
                                                let _e2962 = phi_5599_;
                                                let _e2964 = phi_5600_;
                                                let _e2966 = phi_5601_;
                                                phi_5602_ = _e2952;
                                                phi_5603_ = _e2954;
                                                phi_5604_ = _e2956;
                                                phi_5605_ = _e2958;
                                                phi_5606_ = false;
                                                phi_5607_ = _e2960;
                                                phi_5608_ = _e2962;
                                                phi_5609_ = _e2964;
                                                phi_5610_ = _e2966;
                                            } else {
                                                phi_5602_ = f64();
                                                phi_5603_ = f64();
                                                phi_5604_ = f64();
                                                phi_5605_ = f64();
                                                phi_5606_ = true;
                                                phi_5607_ = false;
                                                phi_5608_ = false;
                                                phi_5609_ = false;
                                                phi_5610_ = false;
                                            }
                                            let _e2968 = phi_5602_;
                                            let _e2970 = phi_5603_;
                                            let _e2972 = phi_5604_;
                                            let _e2974 = phi_5605_;
                                            let _e2976 = phi_5606_;
                                            let _e2978 = phi_5607_;
                                            let _e2980 = phi_5608_;
                                            let _e2982 = phi_5609_;
                                            let _e2984 = phi_5610_;
                                            phi_5611_ = _e2968;
                                            phi_5612_ = _e2970;
                                            phi_5613_ = _e2972;
                                            phi_5614_ = _e2974;
                                            phi_5615_ = _e2976;
                                            phi_5616_ = _e2978;
                                            phi_5617_ = _e2980;
                                            phi_5618_ = _e2982;
                                            phi_5619_ = _e2984;
                                        } else {
                                            phi_5611_ = f64();
                                            phi_5612_ = f64();
                                            phi_5613_ = f64();
                                            phi_5614_ = f64();
                                            phi_5615_ = true;
                                            phi_5616_ = false;
                                            phi_5617_ = false;
                                            phi_5618_ = false;
                                            phi_5619_ = false;
                                        }
                                        let _e2986 = phi_5611_;
                                        let _e2988 = phi_5612_;
                                        let _e2990 = phi_5613_;
                                        let _e2992 = phi_5614_;
                                        let _e2994 = phi_5615_;
                                        let _e2996 = phi_5616_;
                                        let _e2998 = phi_5617_;
                                        let _e3000 = phi_5618_;
                                        let _e3002 = phi_5619_;
                                        if _e2994 {
                                            if (_e1881 <= _e1883) {
                                                let _e3160 = (_e1891 + 1u);
                                                let _e3161 = (_e3160 > 3u);
                                                phi_5959_ = _e3160;
                                                phi_5960_ = f64();
                                                phi_5961_ = false;
                                                phi_5962_ = select(true, false, _e3161);
                                                phi_5963_ = _e3161;
                                            } else {
                                                let _e3006 = local_3.member[0u];
                                                let _e3009 = local_3.member_1[0u];
                                                let _e3012 = local_3.member[0u];
                                                let _e3018 = local_3.member_2[0u];
                                                let _e3019 = ((_e3006 + ((_e3009 - _e3012) * _e1887)) - _e3018);
                                                let _e3022 = local_3.member[1u];
                                                let _e3025 = local_3.member_1[1u];
                                                let _e3028 = local_3.member[1u];
                                                let _e3034 = local_3.member_2[1u];
                                                let _e3035 = ((_e3022 + ((_e3025 - _e3028) * _e1887)) - _e3034);
                                                let _e3037 = select(_e3035, _e3019, (_e3019 < _e3035));
                                                let _e3040 = local_3.member[2u];
                                                let _e3043 = local_3.member_1[2u];
                                                let _e3046 = local_3.member[2u];
                                                let _e3052 = local_3.member_2[2u];
                                                let _e3053 = ((_e3040 + ((_e3043 - _e3046) * _e1887)) - _e3052);
                                                let _e3056 = local_3.member[3u];
                                                let _e3059 = local_3.member_1[3u];
                                                let _e3062 = local_3.member[3u];
                                                let _e3068 = local_3.member_2[3u];
                                                let _e3069 = ((_e3056 + ((_e3059 - _e3062) * _e1887)) - _e3068);
                                                let _e3071 = select(_e3069, _e3053, (_e3053 < _e3069));
                                                let _e3073 = select(_e3071, _e3037, (_e3037 < _e3071));
                                                let _e3076 = local_4.member[0u];
                                                let _e3079 = local_4.member_1[0u];
                                                let _e3082 = local_4.member[0u];
                                                let _e3088 = local_4.member_2[0u];
                                                let _e3089 = ((_e3076 + ((_e3079 - _e3082) * _e1881)) - _e3088);
                                                let _e3092 = local_4.member[1u];
                                                let _e3095 = local_4.member_1[1u];
                                                let _e3098 = local_4.member[1u];
                                                let _e3104 = local_4.member_2[1u];
                                                let _e3105 = ((_e3092 + ((_e3095 - _e3098) * _e1881)) - _e3104);
                                                let _e3107 = select(_e3105, _e3089, (_e3089 < _e3105));
                                                let _e3110 = local_4.member[2u];
                                                let _e3113 = local_4.member_1[2u];
                                                let _e3116 = local_4.member[2u];
                                                let _e3122 = local_4.member_2[2u];
                                                let _e3123 = ((_e3110 + ((_e3113 - _e3116) * _e1881)) - _e3122);
                                                let _e3126 = local_4.member[3u];
                                                let _e3129 = local_4.member_1[3u];
                                                let _e3132 = local_4.member[3u];
                                                let _e3138 = local_4.member_2[3u];
                                                let _e3139 = ((_e3126 + ((_e3129 - _e3132) * _e1881)) - _e3138);
                                                let _e3141 = select(_e3139, _e3123, (_e3123 < _e3139));
                                                let _e3143 = select(_e3141, _e3107, (_e3107 < _e3141));
                                                let _e3144 = f64(0.0625f);
                                                let _e3146 = f64(0.9f);
                                                if (_e3143 > f64(0f)) {
                                                    phi_5957_ = f64(0.5f);
                                                } else {
                                                    let _e3152 = (f64(0.95f) * (_e3073 / (_e3073 - _e3143)));
                                                    phi_5957_ = select(_e3144, select(_e3146, _e3152, (_e3152 < _e3146)), (_e3152 > _e3144));
                                                }
                                                let _e3158 = phi_5957_;
                                                phi_5959_ = u32();
                                                phi_5960_ = (_e2191 * _e3158);
                                                phi_5961_ = true;
                                                phi_5962_ = false;
                                                phi_5963_ = false;
                                            }
                                            let _e3164 = phi_5959_;
                                            let _e3166 = phi_5960_;
                                            let _e3168 = phi_5961_;
                                            let _e3170 = phi_5962_;
                                            let _e3172 = phi_5963_;
                                            phi_5964_ = _e3164;
                                            phi_5965_ = _e1883;
                                            phi_5966_ = _e3166;
                                            phi_5967_ = _e1885;
                                            phi_5968_ = _e1887;
                                            phi_5969_ = _e1889;
                                            phi_5970_ = _e1891;
                                            phi_5971_ = _e3168;
                                            phi_5972_ = _e3170;
                                            phi_5973_ = _e3172;
                                            phi_5974_ = false;
                                            phi_5975_ = false;
                                            phi_5976_ = false;
                                        } else {
                                            phi_5964_ = u32();
                                            phi_5965_ = _e2986;
                                            phi_5966_ = _e2988;
                                            phi_5967_ = _e2990;
                                            phi_5968_ = _e1881;
                                            phi_5969_ = true;
                                            phi_5970_ = 0u;
                                            phi_5971_ = _e2996;
                                            phi_5972_ = false;
                                            phi_5973_ = false;
                                            phi_5974_ = _e2998;
                                            phi_5975_ = _e3000;
                                            phi_5976_ = _e3002;
                                        }
                                        let _e3174 = phi_5964_;
                                        let _e3176 = phi_5965_;
                                        let _e3178 = phi_5966_;
                                        let _e3180 = phi_5967_;
                                        let _e3182 = phi_5968_;
                                        let _e3184 = phi_5969_;
                                        let _e3186 = phi_5970_;
                                        let _e3188 = phi_5971_;
                                        let _e3190 = phi_5972_;
                                        let _e3192 = phi_5973_;
                                        let _e3194 = phi_5974_;
                                        let _e3196 = phi_5975_;
                                        let _e3198 = phi_5976_;
                                        if _e3188 {
                                            let _e3199 = (_e3182 + _e3178);
                                            let _e3201 = select(_e3176, _e3199, (_e3199 > _e3176));
                                            let _e3203 = select(_e552, _e3201, (_e3201 < _e552));
                                            let _e3206 = select(((_e3203 - _e3182) > _e1870), true, !(_e1889));
                                            phi_6004_ = _e3203;
                                            phi_6005_ = _e3176;
                                            phi_6006_ = _e3180;
                                            phi_6007_ = _e3182;
                                            phi_6008_ = _e3184;
                                            phi_6009_ = _e3186;
                                            phi_6010_ = _e3206;
                                            phi_6011_ = select(true, false, _e3206);
                                            phi_6012_ = false;
                                            phi_6013_ = false;
                                            phi_6014_ = false;
                                            phi_6015_ = false;
                                        } else {
                                            phi_6004_ = _e1881;
                                            phi_6005_ = _e1883;
                                            phi_6006_ = _e1885;
                                            phi_6007_ = _e1887;
                                            phi_6008_ = _e1889;
                                            phi_6009_ = _e3174;
                                            phi_6010_ = _e3190;
                                            phi_6011_ = false;
                                            phi_6012_ = _e3192;
                                            phi_6013_ = _e3194;
                                            phi_6014_ = _e3196;
                                            phi_6015_ = _e3198;
                                        }
                                        let _e3209 = phi_6004_;
                                        let _e3211 = phi_6005_;
                                        let _e3213 = phi_6006_;
                                        let _e3215 = phi_6007_;
                                        let _e3217 = phi_6008_;
                                        let _e3219 = phi_6009_;
                                        let _e3221 = phi_6010_;
                                        let _e3223 = phi_6011_;
                                        let _e3225 = phi_6012_;
                                        let _e3227 = phi_6013_;
                                        let _e3229 = phi_6014_;
                                        let _e3231 = phi_6015_;
                                        phi_3794_ = _e3209;
                                        phi_3796_ = _e3211;
                                        phi_3798_ = _e3213;
                                        phi_3800_ = _e3215;
                                        phi_3802_ = _e3217;
                                        phi_3804_ = _e3219;
                                        phi_6016_ = _e3176;
                                        phi_6017_ = _e2992;
                                        phi_6018_ = _e3221;
                                        phi_6019_ = _e3223;
                                        phi_6020_ = _e3225;
                                        phi_6021_ = _e3227;
                                        phi_6022_ = _e3229;
                                        phi_6023_ = false;
                                        phi_6024_ = _e3231;
                                    } else {
                                        phi_3794_ = f64();
                                        phi_3796_ = f64();
                                        phi_3798_ = f64();
                                        phi_3800_ = f64();
                                        phi_3802_ = bool();
                                        phi_3804_ = u32();
                                        phi_6016_ = f64();
                                        phi_6017_ = f64();
                                        phi_6018_ = false;
                                        phi_6019_ = false;
                                        phi_6020_ = false;
                                        phi_6021_ = false;
                                        phi_6022_ = false;
                                        phi_6023_ = true;
                                        phi_6024_ = false;
                                    }
                                    let _e3233 = phi_3794_;
                                    let _e3235 = phi_3796_;
                                    let _e3237 = phi_3798_;
                                    let _e3239 = phi_3800_;
                                    let _e3241 = phi_3802_;
                                    let _e3243 = phi_3804_;
                                    let _e3245 = phi_6016_;
                                    let _e3247 = phi_6017_;
                                    let _e3249 = phi_6018_;
                                    let _e3251 = phi_6019_;
                                    let _e3253 = phi_6020_;
                                    let _e3255 = phi_6021_;
                                    let _e3257 = phi_6022_;
                                    let _e3259 = phi_6023_;
                                    let _e3261 = phi_6024_;
                                    local_10 = _e3251;
                                    local_11 = _e3253;
                                    local_12 = _e3251;
                                    local_13 = _e3255;
                                    local_14 = _e3251;
                                    local_15 = _e3257;
                                    local_16 = _e3251;
                                    local_17 = _e3259;
                                    local_18 = _e3251;
                                    local_19 = _e3261;
                                    local_21 = _e3251;
                                    local_22 = _e3247;
                                    local_23 = _e3245;
                                    continue;
                                    continuing {
                                        phi_3790_ = type_9(select(_e1879.member, (_e1879.member + 1u), _e1894), select(_e1879.member_1, _e1879.member_1, _e1894));
                                        phi_3793_ = _e3233;
                                        phi_3795_ = _e3235;
                                        phi_3797_ = _e3237;
                                        phi_3799_ = _e3239;
                                        phi_3801_ = _e3241;
                                        phi_3803_ = _e3243;
                                        break if !(_e3249);
                                    }
                                }
                                let _e3264 = local_10;
                                let _e3266 = local_11;
                                let _e3267 = select(_e3266, false, _e3264);
                                let _e3269 = local_12;
                                let _e3271 = local_13;
                                let _e3274 = local_14;
                                let _e3276 = local_15;
                                let _e3279 = local_16;
                                let _e3281 = local_17;
                                let _e3284 = local_18;
                                let _e3286 = local_19;
                                let _e3292 = local_20;
                                let _e3294 = select(select(_e3271, false, _e3269), false, _e3267);
                                let _e3297 = local_21;
                                let _e3304 = select(select(select(_e3276, false, _e3274), false, _e3267), false, _e3294);
                                let _e3310 = local_22;
                                let _e3312 = local_23;
                                let _e3314 = select(select(select(_e3297, false, _e3267), false, _e3294), true, _e3304);
                                let _e3319 = local_24;
                                let _e3321 = select(select(select(select(select(_e3281, false, _e3279), false, _e3267), false, _e3294), false, _e3304), true, _e3314);
                                let _e3328 = select(select(select(select(select(select(_e3286, false, _e3284), false, _e3267), false, _e3294), false, _e3304), false, _e3314), false, _e3321);
                                let _e3333 = select(select(select(select(select(_e3267, true, _e3294), false, _e3304), false, _e3314), false, _e3321), true, _e3328);
                                phi_6091_ = select(select(type_37().member_1, select(_e3319, select(_e3312, _e3310, _e3304), _e3314), _e3321), select(select(select(type_37().member_1, _e3292, _e3267), type_37().member_1, _e3294), type_37().member_1, _e3328), _e3333);
                                phi_6092_ = (select(select(type_37().member, 1u, _e3321), select(select(select(type_37().member, 1u, _e3267), 0u, _e3294), 0u, _e3328), _e3333) != 0u);
                            } else {
                                phi_6091_ = _e1633;
                                phi_6092_ = true;
                            }
                            let _e3338 = phi_6091_;
                            let _e3340 = phi_6092_;
                            if _e3340 {
                                let _e3341 = (_e3338 > _e543);
                                if _e3341 {
                                    phi_8299_ = f64();
                                    phi_8300_ = u32();
                                    phi_8301_ = f64();
                                    phi_8302_ = type_42();
                                    phi_8303_ = u32();
                                    phi_8304_ = u32();
                                    phi_8305_ = false;
                                    phi_8306_ = false;
                                    phi_8307_ = false;
                                } else {
                                    let _e3345 = local_5.member[0u];
                                    let _e3351 = local_5.member[1u];
                                    let _e3367 = local_5.member_1[0u];
                                    let _e3373 = local_5.member_1[1u];
                                    let _e3389 = local_5.member_2[0u];
                                    let _e3395 = local_5.member_2[1u];
                                    let _e3409 = function_4(array<f64, 3>((_e3345[0] + ((_e3351[0] - _e3345[0]) * _e1637)), (_e3345[1] + ((_e3351[1] - _e3345[1]) * _e1637)), (_e3345[2] + ((_e3351[2] - _e3345[2]) * _e1637))), array<f64, 3>((_e3367[0] + ((_e3373[0] - _e3367[0]) * _e1637)), (_e3367[1] + ((_e3373[1] - _e3367[1]) * _e1637)), (_e3367[2] + ((_e3373[2] - _e3367[2]) * _e1637))), array<f64, 3>((_e3389[0] + ((_e3395[0] - _e3389[0]) * _e1637)), (_e3389[1] + ((_e3395[1] - _e3389[1]) * _e1637)), (_e3389[2] + ((_e3395[2] - _e3389[2]) * _e1637))), _e231.member);
                                    let _e3423 = ((select(_e3409[0], -(_e3409[0]), (_e3409[0] < 0.0lf)) + select(_e3409[1], -(_e3409[1]), (_e3409[1] < 0.0lf))) + select(_e3409[2], -(_e3409[2]), (_e3409[2] < 0.0lf)));
                                    let _e3426 = local_5.member[0u];
                                    let _e3432 = local_5.member_1[0u];
                                    let _e3438 = local_5.member_2[0u];
                                    let _e3442 = (_e3426[0] - _e3432[0]);
                                    let _e3443 = (_e3426[1] - _e3432[1]);
                                    let _e3444 = (_e3426[2] - _e3432[2]);
                                    let _e3445 = (_e231.member == 0u);
                                    let _e3457 = local_5.member[1u];
                                    let _e3463 = local_5.member_1[1u];
                                    let _e3469 = local_5.member_2[1u];
                                    let _e3473 = (_e3457[0] - _e3463[0]);
                                    let _e3474 = (_e3457[1] - _e3463[1]);
                                    let _e3475 = (_e3457[2] - _e3463[2]);
                                    let _e3476 = (_e231.member == 0u);
                                    let _e3488 = local_5.member[0u];
                                    let _e3494 = select(_e3488[0], -(_e3488[0]), (_e3488[0] < 0.0lf));
                                    let _e3497 = select(_e3488[1], -(_e3488[1]), (_e3488[1] < 0.0lf));
                                    let _e3499 = select(_e3497, _e3494, (_e3494 > _e3497));
                                    let _e3502 = select(_e3488[2], -(_e3488[2]), (_e3488[2] < 0.0lf));
                                    let _e3504 = select(_e3502, _e3499, (_e3499 > _e3502));
                                    let _e3507 = local_5.member[1u];
                                    let _e3513 = select(_e3507[0], -(_e3507[0]), (_e3507[0] < 0.0lf));
                                    let _e3516 = select(_e3507[1], -(_e3507[1]), (_e3507[1] < 0.0lf));
                                    let _e3518 = select(_e3516, _e3513, (_e3513 > _e3516));
                                    let _e3521 = select(_e3507[2], -(_e3507[2]), (_e3507[2] < 0.0lf));
                                    let _e3523 = select(_e3521, _e3518, (_e3518 > _e3521));
                                    let _e3527 = local_5.member_3;
                                    let _e3531 = local_5.member_1[0u];
                                    let _e3537 = select(_e3531[0], -(_e3531[0]), (_e3531[0] < 0.0lf));
                                    let _e3540 = select(_e3531[1], -(_e3531[1]), (_e3531[1] < 0.0lf));
                                    let _e3542 = select(_e3540, _e3537, (_e3537 > _e3540));
                                    let _e3545 = select(_e3531[2], -(_e3531[2]), (_e3531[2] < 0.0lf));
                                    let _e3547 = select(_e3545, _e3542, (_e3542 > _e3545));
                                    let _e3550 = local_5.member_1[1u];
                                    let _e3556 = select(_e3550[0], -(_e3550[0]), (_e3550[0] < 0.0lf));
                                    let _e3559 = select(_e3550[1], -(_e3550[1]), (_e3550[1] < 0.0lf));
                                    let _e3561 = select(_e3559, _e3556, (_e3556 > _e3559));
                                    let _e3564 = select(_e3550[2], -(_e3550[2]), (_e3550[2] < 0.0lf));
                                    let _e3566 = select(_e3564, _e3561, (_e3561 > _e3564));
                                    let _e3570 = local_5.member_3;
                                    let _e3574 = local_5.member_2[0u];
                                    let _e3580 = select(_e3574[0], -(_e3574[0]), (_e3574[0] < 0.0lf));
                                    let _e3583 = select(_e3574[1], -(_e3574[1]), (_e3574[1] < 0.0lf));
                                    let _e3585 = select(_e3583, _e3580, (_e3580 > _e3583));
                                    let _e3588 = select(_e3574[2], -(_e3574[2]), (_e3574[2] < 0.0lf));
                                    let _e3590 = select(_e3588, _e3585, (_e3585 > _e3588));
                                    let _e3593 = local_5.member_2[1u];
                                    let _e3599 = select(_e3593[0], -(_e3593[0]), (_e3593[0] < 0.0lf));
                                    let _e3602 = select(_e3593[1], -(_e3593[1]), (_e3593[1] < 0.0lf));
                                    let _e3604 = select(_e3602, _e3599, (_e3599 > _e3602));
                                    let _e3607 = select(_e3593[2], -(_e3593[2]), (_e3593[2] < 0.0lf));
                                    let _e3609 = select(_e3607, _e3604, (_e3604 > _e3607));
                                    let _e3613 = local_5.member_3;
                                    let _e3621 = local_5.member_3;
                                    local_1 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3426, array<f64, 3>(_e3442, _e3443, _e3444), array<f64, 3>((_e3426[0] - _e3438[0]), (_e3426[1] - _e3438[1]), (_e3426[2] - _e3438[2])), array<f64, 3>(select((_e3442 - _e3438[0]), _e3426[0], _e3445), select((_e3443 - _e3438[1]), _e3426[1], _e3445), select((_e3444 - _e3438[2]), _e3426[2], _e3445))), array<array<f64, 3>, 4>(_e3457, array<f64, 3>(_e3473, _e3474, _e3475), array<f64, 3>((_e3457[0] - _e3469[0]), (_e3457[1] - _e3469[1]), (_e3457[2] - _e3469[2])), array<f64, 3>(select((_e3473 - _e3469[0]), _e3457[0], _e3476), select((_e3474 - _e3469[1]), _e3457[1], _e3476), select((_e3475 - _e3469[2]), _e3457[2], _e3476)))), ((((((select(_e3523, _e3504, (_e3504 > _e3523)) + _e3527) + (select(_e3566, _e3547, (_e3547 > _e3566)) + _e3570)) + (select(_e3609, _e3590, (_e3590 > _e3609)) + _e3613)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3621 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e906.member_1);
                                    let _e3639 = local_1.member_1;
                                    if (_e3423 > _e3639) {
                                        if ((bitcast<u64>(_e3423) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3645 = (f64(1f) / _e3423);
                                            let _e3647 = (_e3409[0] * _e3645);
                                            let _e3649 = (_e3409[1] * _e3645);
                                            let _e3651 = (_e3409[2] * _e3645);
                                            let _e3656 = (((_e3647 * _e3647) + (_e3649 * _e3649)) + (_e3651 * _e3651));
                                            if (_e3656 <= 2.2250738585072014e-308lf) {
                                                phi_6774_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3656 > 0.0lf));
                                            } else {
                                                phi_6717_ = type_16(0i, 5i);
                                                phi_6720_ = bitcast<f64>(((bitcast<u64>(_e3656) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3663 = phi_6717_;
                                                    let _e3665 = phi_6720_;
                                                    local_25 = _e3665;
                                                    if (_e3663.member < _e3663.member_1) {
                                                        let _e3672 = (_e3663.member + 1i);
                                                        phi_6718_ = type_16(select(_e3672, type_17().member_1, select(false, true, ((false == (_e3672 > _e3663.member)) != false))), _e3663.member_1);
                                                        phi_6761_ = type_17(1u, _e3663.member);
                                                    } else {
                                                        phi_6718_ = _e3663;
                                                        phi_6761_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3683 = phi_6718_;
                                                    let _e3685 = phi_6761_;
                                                    let _e3688 = (bitcast<i32>(_e3685.member) != 0i);
                                                    if _e3688 {
                                                        phi_6721_ = (0.5lf * (_e3665 + (_e3656 / _e3665)));
                                                    } else {
                                                        phi_6721_ = f64();
                                                    }
                                                    let _e3693 = phi_6721_;
                                                    continue;
                                                    continuing {
                                                        phi_6717_ = _e3683;
                                                        phi_6720_ = _e3693;
                                                        break if !(_e3688);
                                                    }
                                                }
                                                let _e3698 = local_25;
                                                phi_6774_ = (_e3698 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3704 = phi_6774_;
                                            let _e3706 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3708 = local_1.member_1;
                                            let _e3712 = local_1.member_2;
                                            let _e3717 = ((_e3708 * f64(1.01f)) + ((_e3712 * _e3704) * (f64(1f) + _e3706)));
                                            let _e3721 = local_1.member[0u][0u];
                                            let _e3729 = (((_e3647 * _e3721[0]) + (_e3649 * _e3721[1])) + (_e3651 * _e3721[2]));
                                            let _e3733 = local_1.member[0u][1u];
                                            let _e3741 = (((_e3647 * _e3733[0]) + (_e3649 * _e3733[1])) + (_e3651 * _e3733[2]));
                                            let _e3745 = local_1.member[0u][2u];
                                            let _e3753 = (((_e3647 * _e3745[0]) + (_e3649 * _e3745[1])) + (_e3651 * _e3745[2]));
                                            let _e3757 = local_1.member[0u][3u];
                                            let _e3765 = (((_e3647 * _e3757[0]) + (_e3649 * _e3757[1])) + (_e3651 * _e3757[2]));
                                            let _e3769 = local_1.member[1u][0u];
                                            let _e3777 = (((_e3647 * _e3769[0]) + (_e3649 * _e3769[1])) + (_e3651 * _e3769[2]));
                                            let _e3781 = local_1.member[1u][1u];
                                            let _e3789 = (((_e3647 * _e3781[0]) + (_e3649 * _e3781[1])) + (_e3651 * _e3781[2]));
                                            let _e3793 = local_1.member[1u][2u];
                                            let _e3801 = (((_e3647 * _e3793[0]) + (_e3649 * _e3793[1])) + (_e3651 * _e3793[2]));
                                            let _e3805 = local_1.member[1u][3u];
                                            let _e3813 = (((_e3647 * _e3805[0]) + (_e3649 * _e3805[1])) + (_e3651 * _e3805[2]));
                                            local_2 = type_39(array<f64, 4>(_e3729, _e3741, _e3753, _e3765), array<f64, 4>(_e3777, _e3789, _e3801, _e3813), array<f64, 4>((_e3717 + ((select(_e3729, -(_e3729), (_e3729 < 0.0lf)) + select(_e3777, -(_e3777), (_e3777 < 0.0lf))) * _e3706)), (_e3717 + ((select(_e3741, -(_e3741), (_e3741 < 0.0lf)) + select(_e3789, -(_e3789), (_e3789 < 0.0lf))) * _e3706)), (_e3717 + ((select(_e3753, -(_e3753), (_e3753 < 0.0lf)) + select(_e3801, -(_e3801), (_e3801 < 0.0lf))) * _e3706)), (_e3717 + ((select(_e3765, -(_e3765), (_e3765 < 0.0lf)) + select(_e3813, -(_e3813), (_e3813 < 0.0lf))) * _e3706))));
                                            let _e3858 = (((_e3647 * _e3647) + (_e3649 * _e3649)) + (_e3651 * _e3651));
                                            if (_e3858 <= 2.2250738585072014e-308lf) {
                                                phi_7069_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3858 > 0.0lf));
                                            } else {
                                                phi_7012_ = type_16(0i, 5i);
                                                phi_7015_ = bitcast<f64>(((bitcast<u64>(_e3858) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3865 = phi_7012_;
                                                    let _e3867 = phi_7015_;
                                                    local_26 = _e3867;
                                                    if (_e3865.member < _e3865.member_1) {
                                                        let _e3874 = (_e3865.member + 1i);
                                                        phi_7013_ = type_16(select(_e3874, type_17().member_1, select(false, true, ((false == (_e3874 > _e3865.member)) != false))), _e3865.member_1);
                                                        phi_7056_ = type_17(1u, _e3865.member);
                                                    } else {
                                                        phi_7013_ = _e3865;
                                                        phi_7056_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3885 = phi_7013_;
                                                    let _e3887 = phi_7056_;
                                                    let _e3890 = (bitcast<i32>(_e3887.member) != 0i);
                                                    if _e3890 {
                                                        phi_7016_ = (0.5lf * (_e3867 + (_e3858 / _e3867)));
                                                    } else {
                                                        phi_7016_ = f64();
                                                    }
                                                    let _e3895 = phi_7016_;
                                                    continue;
                                                    continuing {
                                                        phi_7012_ = _e3885;
                                                        phi_7015_ = _e3895;
                                                        break if !(_e3890);
                                                    }
                                                }
                                                let _e3900 = local_26;
                                                phi_7069_ = (_e3900 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3906 = phi_7069_;
                                            let _e3917 = (((_e3409[0] * _e3409[0]) + (_e3409[1] * _e3409[1])) + (_e3409[2] * _e3409[2]));
                                            if (_e3917 <= 2.2250738585072014e-308lf) {
                                                phi_7158_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3917 > 0.0lf));
                                            } else {
                                                phi_7101_ = type_16(0i, 5i);
                                                phi_7104_ = bitcast<f64>(((bitcast<u64>(_e3917) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3924 = phi_7101_;
                                                    let _e3926 = phi_7104_;
                                                    local_27 = _e3926;
                                                    if (_e3924.member < _e3924.member_1) {
                                                        let _e3933 = (_e3924.member + 1i);
                                                        phi_7102_ = type_16(select(_e3933, type_17().member_1, select(false, true, ((false == (_e3933 > _e3924.member)) != false))), _e3924.member_1);
                                                        phi_7145_ = type_17(1u, _e3924.member);
                                                    } else {
                                                        phi_7102_ = _e3924;
                                                        phi_7145_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3944 = phi_7102_;
                                                    let _e3946 = phi_7145_;
                                                    let _e3949 = (bitcast<i32>(_e3946.member) != 0i);
                                                    if _e3949 {
                                                        phi_7105_ = (0.5lf * (_e3926 + (_e3917 / _e3926)));
                                                    } else {
                                                        phi_7105_ = f64();
                                                    }
                                                    let _e3954 = phi_7105_;
                                                    continue;
                                                    continuing {
                                                        phi_7101_ = _e3944;
                                                        phi_7104_ = _e3954;
                                                        break if !(_e3949);
                                                    }
                                                }
                                                let _e3959 = local_27;
                                                phi_7158_ = (_e3959 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3965 = phi_7158_;
                                            let _e3973 = local_5.member[0u];
                                            let _e3979 = select(_e3973[0], -(_e3973[0]), (_e3973[0] < 0.0lf));
                                            let _e3982 = select(_e3973[1], -(_e3973[1]), (_e3973[1] < 0.0lf));
                                            let _e3984 = select(_e3982, _e3979, (_e3979 > _e3982));
                                            let _e3987 = select(_e3973[2], -(_e3973[2]), (_e3973[2] < 0.0lf));
                                            let _e3989 = select(_e3987, _e3984, (_e3984 > _e3987));
                                            let _e3992 = local_5.member[1u];
                                            let _e3998 = select(_e3992[0], -(_e3992[0]), (_e3992[0] < 0.0lf));
                                            let _e4001 = select(_e3992[1], -(_e3992[1]), (_e3992[1] < 0.0lf));
                                            let _e4003 = select(_e4001, _e3998, (_e3998 > _e4001));
                                            let _e4006 = select(_e3992[2], -(_e3992[2]), (_e3992[2] < 0.0lf));
                                            let _e4008 = select(_e4006, _e4003, (_e4003 > _e4006));
                                            let _e4012 = local_5.member_3;
                                            let _e4016 = local_5.member_1[0u];
                                            let _e4022 = select(_e4016[0], -(_e4016[0]), (_e4016[0] < 0.0lf));
                                            let _e4025 = select(_e4016[1], -(_e4016[1]), (_e4016[1] < 0.0lf));
                                            let _e4027 = select(_e4025, _e4022, (_e4022 > _e4025));
                                            let _e4030 = select(_e4016[2], -(_e4016[2]), (_e4016[2] < 0.0lf));
                                            let _e4032 = select(_e4030, _e4027, (_e4027 > _e4030));
                                            let _e4035 = local_5.member_1[1u];
                                            let _e4041 = select(_e4035[0], -(_e4035[0]), (_e4035[0] < 0.0lf));
                                            let _e4044 = select(_e4035[1], -(_e4035[1]), (_e4035[1] < 0.0lf));
                                            let _e4046 = select(_e4044, _e4041, (_e4041 > _e4044));
                                            let _e4049 = select(_e4035[2], -(_e4035[2]), (_e4035[2] < 0.0lf));
                                            let _e4051 = select(_e4049, _e4046, (_e4046 > _e4049));
                                            let _e4055 = local_5.member_3;
                                            let _e4059 = local_5.member_2[0u];
                                            let _e4065 = select(_e4059[0], -(_e4059[0]), (_e4059[0] < 0.0lf));
                                            let _e4068 = select(_e4059[1], -(_e4059[1]), (_e4059[1] < 0.0lf));
                                            let _e4070 = select(_e4068, _e4065, (_e4065 > _e4068));
                                            let _e4073 = select(_e4059[2], -(_e4059[2]), (_e4059[2] < 0.0lf));
                                            let _e4075 = select(_e4073, _e4070, (_e4070 > _e4073));
                                            let _e4078 = local_5.member_2[1u];
                                            let _e4084 = select(_e4078[0], -(_e4078[0]), (_e4078[0] < 0.0lf));
                                            let _e4087 = select(_e4078[1], -(_e4078[1]), (_e4078[1] < 0.0lf));
                                            let _e4089 = select(_e4087, _e4084, (_e4084 > _e4087));
                                            let _e4092 = select(_e4078[2], -(_e4078[2]), (_e4078[2] < 0.0lf));
                                            let _e4094 = select(_e4092, _e4089, (_e4089 > _e4092));
                                            let _e4098 = local_5.member_3;
                                            let _e4106 = local_5.member_3;
                                            let _e4121 = ((((_e3965 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4008, _e3989, (_e3989 > _e4008)) + _e4012) + (select(_e4051, _e4032, (_e4032 > _e4051)) + _e4055)) + (select(_e4094, _e4075, (_e4075 > _e4094)) + _e4098)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4106 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3906) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e4124 = local_2.member[0u];
                                            let _e4127 = local_2.member_1[0u];
                                            phi_7476_ = type_9(1u, 4u);
                                            phi_7479_ = ((_e4124 + ((_e4127 - _e4124) * _e1637)) - ((_e3639 * f64(1.01f)) + ((select(_e4124, -(_e4124), (_e4124 < 0.0lf)) + select(_e4127, -(_e4127), (_e4127 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4146 = phi_7476_;
                                                let _e4148 = phi_7479_;
                                                local_28 = _e4148;
                                                local_29 = _e4148;
                                                let _e4151 = (_e4146.member < _e4146.member_1);
                                                let _e4162 = select(type_9().member_1, _e4146.member, _e4151);
                                                let _e4164 = (bitcast<i32>(select(0u, 1u, _e4151)) != 0i);
                                                if _e4164 {
                                                    let _e4167 = local_2.member[_e4162];
                                                    let _e4170 = local_2.member_1[_e4162];
                                                    let _e4187 = ((_e4167 + ((_e4170 - _e4167) * _e1637)) - ((_e3639 * f64(1.01f)) + ((select(_e4167, -(_e4167), (_e4167 < 0.0lf)) + select(_e4170, -(_e4170), (_e4170 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7480_ = select(_e4187, _e4148, (_e4148 < _e4187));
                                                } else {
                                                    phi_7480_ = f64();
                                                }
                                                let _e4191 = phi_7480_;
                                                continue;
                                                continuing {
                                                    phi_7476_ = type_9(select(_e4146.member, (_e4146.member + 1u), _e4151), select(_e4146.member_1, _e4146.member_1, _e4151));
                                                    phi_7479_ = _e4191;
                                                    break if !(_e4164);
                                                }
                                            }
                                            let _e4194 = local_28;
                                            if (_e4194 > f64(0f)) {
                                                let _e4199 = local_29;
                                                let _e4203 = (((_e4121 - _e4199) / _e4121) * f64(2.02f));
                                                if (_e4203 <= 2.2250738585072014e-308lf) {
                                                    phi_7638_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4203 > 0.0lf));
                                                } else {
                                                    phi_7581_ = type_16(0i, 5i);
                                                    phi_7584_ = bitcast<f64>(((bitcast<u64>(_e4203) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4210 = phi_7581_;
                                                        let _e4212 = phi_7584_;
                                                        local_30 = _e4212;
                                                        if (_e4210.member < _e4210.member_1) {
                                                            let _e4219 = (_e4210.member + 1i);
                                                            phi_7582_ = type_16(select(_e4219, type_17().member_1, select(false, true, ((false == (_e4219 > _e4210.member)) != false))), _e4210.member_1);
                                                            phi_7625_ = type_17(1u, _e4210.member);
                                                        } else {
                                                            phi_7582_ = _e4210;
                                                            phi_7625_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e4230 = phi_7582_;
                                                        let _e4232 = phi_7625_;
                                                        let _e4235 = (bitcast<i32>(_e4232.member) != 0i);
                                                        if _e4235 {
                                                            phi_7585_ = (0.5lf * (_e4212 + (_e4203 / _e4212)));
                                                        } else {
                                                            phi_7585_ = f64();
                                                        }
                                                        let _e4240 = phi_7585_;
                                                        continue;
                                                        continuing {
                                                            phi_7581_ = _e4230;
                                                            phi_7584_ = _e4240;
                                                            break if !(_e4235);
                                                        }
                                                    }
                                                    let _e4245 = local_30;
                                                    phi_7638_ = (_e4245 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4251 = phi_7638_;
                                                let _e4254 = ((_e4251 * _e3906) * f64(1.01f));
                                                phi_7645_ = type_9(0u, 4u);
                                                phi_7648_ = f64(2f);
                                                phi_7650_ = true;
                                                phi_7652_ = true;
                                                loop {
                                                    let _e4257 = phi_7645_;
                                                    let _e4259 = phi_7648_;
                                                    let _e4261 = phi_7650_;
                                                    let _e4263 = phi_7652_;
                                                    local_31 = _e4259;
                                                    local_32 = _e4259;
                                                    local_33 = _e4261;
                                                    local_34 = _e4263;
                                                    local_35 = _e4263;
                                                    local_36 = _e4263;
                                                    local_61 = _e4263;
                                                    local_37 = _e4263;
                                                    let _e4266 = (_e4257.member < _e4257.member_1);
                                                    let _e4277 = select(type_9().member_1, _e4257.member, _e4266);
                                                    let _e4279 = (bitcast<i32>(select(0u, 1u, _e4266)) != 0i);
                                                    if _e4279 {
                                                        let _e4283 = local_1.member[0u][_e4277];
                                                        let _e4290 = local_1.member[1u][_e4277];
                                                        let _e4304 = ((select(_e4283[0], -(_e4283[0]), (_e4283[0] < 0.0lf)) + select(_e4283[1], -(_e4283[1]), (_e4283[1] < 0.0lf))) + select(_e4283[2], -(_e4283[2]), (_e4283[2] < 0.0lf)));
                                                        let _e4315 = ((select(_e4290[0], -(_e4290[0]), (_e4290[0] < 0.0lf)) + select(_e4290[1], -(_e4290[1]), (_e4290[1] < 0.0lf))) + select(_e4290[2], -(_e4290[2]), (_e4290[2] < 0.0lf)));
                                                        let _e4323 = (_e4290[0] - _e4283[0]);
                                                        let _e4324 = (_e4290[1] - _e4283[1]);
                                                        let _e4325 = (_e4290[2] - _e4283[2]);
                                                        let _e4344 = local_2.member[_e4277];
                                                        let _e4347 = local_2.member_1[_e4277];
                                                        let _e4360 = ((_e3639 * f64(1.01f)) + ((select(_e4344, -(_e4344), (_e4344 < 0.0lf)) + select(_e4347, -(_e4347), (_e4347 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4367 = local_2.member_1[_e4277];
                                                        let _e4370 = local_2.member[_e4277];
                                                        let _e4371 = (_e4367 - _e4370);
                                                        let _e4374 = ((_e4360 + _e4360) + (_e4254 * ((((select(_e4323, -(_e4323), (_e4323 < 0.0lf)) + select(_e4324, -(_e4324), (_e4324 < 0.0lf))) + select(_e4325, -(_e4325), (_e4325 < 0.0lf))) + (_e3639 * f64(6f))) * f64(1.01f))));
                                                        let _e4377 = ((((_e4344 + ((_e4347 - _e4344) * _e1637)) - _e4360) - (_e4254 * ((select(_e4315, _e4304, (_e4304 > _e4315)) + (_e3639 * f64(3f))) * f64(1.01f)))) - _e4121);
                                                        let _e4378 = (_e4377 > 2.2250738585072014e-308lf);
                                                        let _e4379 = (_e4371 > _e4374);
                                                        if _e4379 {
                                                            phi_7889_ = _e4259;
                                                        } else {
                                                            if _e4378 {
                                                                let _e4386 = (_e4374 - _e4371);
                                                                let _e4389 = (_e4377 / select(2.2250738585072014e-308lf, _e4386, (_e4386 > 2.2250738585072014e-308lf)));
                                                                phi_7888_ = select(_e4389, _e4259, (_e4259 < _e4389));
                                                            } else {
                                                                phi_7888_ = _e4259;
                                                            }
                                                            let _e4393 = phi_7888_;
                                                            phi_7889_ = _e4393;
                                                        }
                                                        let _e4395 = phi_7889_;
                                                        phi_7649_ = _e4395;
                                                        phi_7651_ = (_e4261 && select(_e4378, true, (_e4371 < -(_e4374))));
                                                        phi_7653_ = (_e4263 && select(_e4378, true, _e4379));
                                                    } else {
                                                        phi_7649_ = f64();
                                                        phi_7651_ = bool();
                                                        phi_7653_ = bool();
                                                    }
                                                    let _e4397 = phi_7649_;
                                                    let _e4399 = phi_7651_;
                                                    let _e4401 = phi_7653_;
                                                    continue;
                                                    continuing {
                                                        phi_7645_ = type_9(select(_e4257.member, (_e4257.member + 1u), _e4266), select(_e4257.member_1, _e4257.member_1, _e4266));
                                                        phi_7648_ = _e4397;
                                                        phi_7650_ = _e4399;
                                                        phi_7652_ = _e4401;
                                                        break if !(_e4279);
                                                    }
                                                }
                                                let _e4403 = f64(2f);
                                                let _e4405 = local_31;
                                                let _e4408 = local_32;
                                                let _e4411 = (select(_e4403, _e4408, (_e4405 < _e4403)) * f64(0.999f));
                                                let _e4413 = local_33;
                                                if _e4413 {
                                                    let _e4417 = local_34;
                                                    let _e4421 = local_35;
                                                    let _e4425 = local_36;
                                                    phi_7907_ = type_42(select(_e1637, type_42().member, _e4417), select(f64(2f), type_42().member_1, _e4421), select(1u, type_42().member_2, _e4425));
                                                    let _e5537 = local_61;
                                                    phi_7908_ = _e5537;
                                                } else {
                                                    phi_7907_ = type_42();
                                                    phi_7908_ = true;
                                                }
                                                let _e4429 = phi_7907_;
                                                let _e4431 = phi_7908_;
                                                if _e4431 {
                                                    let _e4433 = local_37;
                                                    if _e4433 {
                                                        let _e4439 = (_e1637 + _e4411);
                                                        let _e4442 = select(_e1637, select(_e552, _e4439, (_e4439 < _e552)), (_e4411 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7930_ = type_9(0u, 4u);
                                                        phi_7933_ = _e4442;
                                                        phi_7935_ = _e1637;
                                                        loop {
                                                            let _e4444 = phi_7930_;
                                                            let _e4446 = phi_7933_;
                                                            let _e4448 = phi_7935_;
                                                            local_38 = _e4446;
                                                            local_39 = _e4448;
                                                            local_40 = _e4448;
                                                            let _e4451 = (_e4444.member < _e4444.member_1);
                                                            let _e4462 = select(type_9().member_1, _e4444.member, _e4451);
                                                            let _e4464 = (bitcast<i32>(select(0u, 1u, _e4451)) != 0i);
                                                            if _e4464 {
                                                                let _e4467 = local_2.member[_e4462];
                                                                let _e4470 = local_2.member_1[_e4462];
                                                                let _e4473 = local_2.member[_e4462];
                                                                let _e4479 = local_2.member_2[_e4462];
                                                                let _e4480 = ((_e4467 + ((_e4470 - _e4473) * _e1637)) - _e4479);
                                                                let _e4483 = local_2.member_1[_e4462];
                                                                let _e4486 = local_2.member[_e4462];
                                                                let _e4487 = (_e4483 - _e4486);
                                                                if (_e4487 > f64(0f)) {
                                                                    let _e4503 = (_e1637 - (_e4480 / _e4487));
                                                                    phi_8047_ = _e4446;
                                                                    phi_8048_ = select(_e4503, _e4448, (_e4448 > _e4503));
                                                                } else {
                                                                    if (_e4480 > f64(0f)) {
                                                                        if (_e4487 < f64(0f)) {
                                                                            let _e4495 = (_e1637 - (_e4480 / _e4487));
                                                                            phi_8045_ = select(_e4495, _e4446, (_e4446 < _e4495));
                                                                        } else {
                                                                            phi_8045_ = _e4446;
                                                                        }
                                                                        let _e4499 = phi_8045_;
                                                                        phi_8046_ = _e4499;
                                                                    } else {
                                                                        phi_8046_ = _e4446;
                                                                    }
                                                                    let _e4501 = phi_8046_;
                                                                    phi_8047_ = _e4501;
                                                                    phi_8048_ = _e4448;
                                                                }
                                                                let _e4507 = phi_8047_;
                                                                let _e4509 = phi_8048_;
                                                                phi_7934_ = _e4507;
                                                                phi_7936_ = _e4509;
                                                            } else {
                                                                phi_7934_ = f64();
                                                                phi_7936_ = f64();
                                                            }
                                                            let _e4511 = phi_7934_;
                                                            let _e4513 = phi_7936_;
                                                            continue;
                                                            continuing {
                                                                phi_7930_ = type_9(select(_e4444.member, (_e4444.member + 1u), _e4451), select(_e4444.member_1, _e4444.member_1, _e4451));
                                                                phi_7933_ = _e4511;
                                                                phi_7935_ = _e4513;
                                                                break if !(_e4464);
                                                            }
                                                        }
                                                        let _e4516 = local_38;
                                                        let _e4518 = local_39;
                                                        let _e4523 = local_40;
                                                        let _e4524 = (_e4523 + ((_e4516 - _e4518) * f64(0.5f)));
                                                        if (_e4524 > _e1637) {
                                                            if (_e4524 <= _e4442) {
                                                                let _e4527 = f64(0f);
                                                                let _e4530 = local_2.member[0u];
                                                                let _e4533 = local_2.member_1[0u];
                                                                let _e4536 = local_2.member[0u];
                                                                let _e4542 = local_2.member_2[0u];
                                                                if (((_e4530 + ((_e4533 - _e4536) * _e4524)) - _e4542) > _e4527) {
                                                                    let _e4547 = local_2.member[1u];
                                                                    let _e4550 = local_2.member_1[1u];
                                                                    let _e4553 = local_2.member[1u];
                                                                    let _e4559 = local_2.member_2[1u];
                                                                    if (((_e4547 + ((_e4550 - _e4553) * _e4524)) - _e4559) > _e4527) {
                                                                        let _e4564 = local_2.member[2u];
                                                                        let _e4567 = local_2.member_1[2u];
                                                                        let _e4570 = local_2.member[2u];
                                                                        let _e4576 = local_2.member_2[2u];
                                                                        if (((_e4564 + ((_e4567 - _e4570) * _e4524)) - _e4576) > _e4527) {
                                                                            let _e4581 = local_2.member[3u];
                                                                            let _e4584 = local_2.member_1[3u];
                                                                            let _e4587 = local_2.member[3u];
                                                                            let _e4593 = local_2.member_2[3u];
                                                                            phi_8211_ = (((_e4581 + ((_e4584 - _e4587) * _e4524)) - _e4593) > _e4527);
                                                                            phi_8212_ = false;
                                                                        } else {
                                                                            phi_8211_ = bool();
                                                                            phi_8212_ = true;
                                                                        }
                                                                        let _e4597 = phi_8211_;
                                                                        let _e4599 = phi_8212_;
                                                                        phi_8213_ = _e4597;
                                                                        phi_8214_ = _e4599;
                                                                    } else {
                                                                        phi_8213_ = bool();
                                                                        phi_8214_ = true;
                                                                    }
                                                                    let _e4601 = phi_8213_;
                                                                    let _e4603 = phi_8214_;
                                                                    phi_8215_ = _e4601;
                                                                    phi_8216_ = _e4603;
                                                                } else {
                                                                    phi_8215_ = bool();
                                                                    phi_8216_ = true;
                                                                }
                                                                let _e4605 = phi_8215_;
                                                                let _e4607 = phi_8216_;
                                                                phi_8225_ = select(true, false, select(_e4605, false, _e4607));
                                                            } else {
                                                                phi_8225_ = true;
                                                            }
                                                            let _e4611 = phi_8225_;
                                                            phi_8226_ = _e4611;
                                                        } else {
                                                            phi_8226_ = true;
                                                        }
                                                        let _e4613 = phi_8226_;
                                                        phi_8235_ = type_42(_e4442, select(_e4524, f64(2f), _e4613), 2u);
                                                        phi_8236_ = type_42();
                                                        phi_8237_ = false;
                                                    } else {
                                                        phi_8235_ = type_42();
                                                        phi_8236_ = type_42(_e1637, f64(2f), 0u);
                                                        phi_8237_ = true;
                                                    }
                                                    let _e4618 = phi_8235_;
                                                    let _e4620 = phi_8236_;
                                                    let _e4622 = phi_8237_;
                                                    phi_8238_ = _e4618;
                                                    phi_8239_ = _e4620;
                                                    phi_8240_ = _e4622;
                                                } else {
                                                    phi_8238_ = type_42();
                                                    phi_8239_ = _e4429;
                                                    phi_8240_ = true;
                                                }
                                                let _e4624 = phi_8238_;
                                                let _e4626 = phi_8239_;
                                                let _e4628 = phi_8240_;
                                                phi_8246_ = _e4626;
                                                phi_8247_ = _e4624;
                                                phi_8248_ = _e4628;
                                            } else {
                                                phi_8246_ = type_42(_e1637, f64(2f), 0u);
                                                phi_8247_ = type_42();
                                                phi_8248_ = true;
                                            }
                                            let _e4630 = phi_8246_;
                                            let _e4632 = phi_8247_;
                                            let _e4634 = phi_8248_;
                                            phi_8252_ = _e4630;
                                            phi_8253_ = _e4632;
                                            phi_8254_ = false;
                                            phi_8255_ = _e4634;
                                        } else {
                                            phi_8252_ = type_42();
                                            phi_8253_ = type_42();
                                            phi_8254_ = true;
                                            phi_8255_ = false;
                                        }
                                        let _e4636 = phi_8252_;
                                        let _e4638 = phi_8253_;
                                        let _e4640 = phi_8254_;
                                        let _e4642 = phi_8255_;
                                        phi_8256_ = _e4636;
                                        phi_8257_ = _e4638;
                                        phi_8258_ = _e4640;
                                        phi_8259_ = _e4642;
                                    } else {
                                        phi_8256_ = type_42();
                                        phi_8257_ = type_42();
                                        phi_8258_ = true;
                                        phi_8259_ = false;
                                    }
                                    let _e4644 = phi_8256_;
                                    let _e4646 = phi_8257_;
                                    let _e4648 = phi_8258_;
                                    let _e4650 = phi_8259_;
                                    let _e4658 = select(_e4650, true, _e4648);
                                    let _e4662 = select(_e4646.member_1, select(_e4644.member_1, f64(2f), _e4648), _e4658);
                                    let _e4664 = select(_e4646.member_2, select(_e4644.member_2, 0u, _e4648), _e4658);
                                    if ((_e554 & 64u) != 0u) {
                                        let _e4666 = (_e4664 == 2u);
                                        let _e4667 = (_e4662 <= _e552);
                                        phi_8294_ = select(f64(), select(f64(), _e4662, _e4667), _e4666);
                                        phi_8295_ = select(f64(), select(f64(), _e4662, _e4667), _e4666);
                                        phi_8296_ = select(false, _e4667, _e4666);
                                        phi_8297_ = select(false, select(true, false, _e4667), _e4666);
                                        phi_8298_ = select(true, false, _e4666);
                                    } else {
                                        phi_8294_ = f64();
                                        phi_8295_ = f64();
                                        phi_8296_ = false;
                                        phi_8297_ = false;
                                        phi_8298_ = true;
                                    }
                                    let _e4677 = phi_8294_;
                                    let _e4679 = phi_8295_;
                                    let _e4681 = phi_8296_;
                                    let _e4683 = phi_8297_;
                                    let _e4685 = phi_8298_;
                                    phi_8299_ = _e4677;
                                    phi_8300_ = _e4664;
                                    phi_8301_ = _e4679;
                                    phi_8302_ = type_42(select(_e4646.member, select(_e4644.member, _e1637, _e4648), _e4658), _e4662, _e4664);
                                    phi_8303_ = _e4664;
                                    phi_8304_ = _e4664;
                                    phi_8305_ = _e4681;
                                    phi_8306_ = _e4683;
                                    phi_8307_ = _e4685;
                                }
                                let _e4687 = phi_8299_;
                                let _e4689 = phi_8300_;
                                let _e4691 = phi_8301_;
                                let _e4693 = phi_8302_;
                                let _e4695 = phi_8303_;
                                let _e4697 = phi_8304_;
                                let _e4699 = phi_8305_;
                                let _e4701 = phi_8306_;
                                let _e4703 = phi_8307_;
                                phi_8308_ = _e4687;
                                phi_8309_ = _e4689;
                                phi_8310_ = _e4691;
                                phi_8311_ = _e4693;
                                phi_8312_ = _e4695;
                                phi_8313_ = _e4697;
                                phi_8314_ = _e4699;
                                phi_8315_ = _e3341;
                                phi_8316_ = _e4701;
                                phi_8317_ = _e4703;
                                phi_8318_ = false;
                            } else {
                                phi_8308_ = f64();
                                phi_8309_ = u32();
                                phi_8310_ = f64();
                                phi_8311_ = type_42();
                                phi_8312_ = u32();
                                phi_8313_ = u32();
                                phi_8314_ = false;
                                phi_8315_ = false;
                                phi_8316_ = false;
                                phi_8317_ = false;
                                phi_8318_ = true;
                            }
                            let _e4705 = phi_8308_;
                            let _e4707 = phi_8309_;
                            let _e4709 = phi_8310_;
                            let _e4711 = phi_8311_;
                            let _e4713 = phi_8312_;
                            let _e4715 = phi_8313_;
                            let _e4717 = phi_8314_;
                            let _e4719 = phi_8315_;
                            let _e4721 = phi_8316_;
                            let _e4723 = phi_8317_;
                            let _e4725 = phi_8318_;
                            phi_8319_ = _e3338;
                            phi_3303_ = _e4705;
                            phi_3305_ = _e4707;
                            phi_3307_ = _e4709;
                            phi_8320_ = _e4711;
                            phi_8321_ = _e4713;
                            phi_8322_ = _e3338;
                            phi_8323_ = _e4715;
                            phi_8324_ = _e4717;
                            phi_8325_ = _e4719;
                            phi_8326_ = _e4721;
                            phi_8327_ = _e4723;
                            phi_8328_ = false;
                            phi_8329_ = _e4725;
                        } else {
                            phi_8319_ = f64();
                            phi_3303_ = f64();
                            phi_3305_ = u32();
                            phi_3307_ = f64();
                            phi_8320_ = type_42();
                            phi_8321_ = u32();
                            phi_8322_ = f64();
                            phi_8323_ = u32();
                            phi_8324_ = false;
                            phi_8325_ = false;
                            phi_8326_ = false;
                            phi_8327_ = false;
                            phi_8328_ = true;
                            phi_8329_ = false;
                        }
                        let _e4727 = phi_8319_;
                        let _e4729 = phi_3303_;
                        let _e4731 = phi_3305_;
                        let _e4733 = phi_3307_;
                        let _e4735 = phi_8320_;
                        let _e4737 = phi_8321_;
                        let _e4739 = phi_8322_;
                        let _e4741 = phi_8323_;
                        let _e4743 = phi_8324_;
                        let _e4745 = phi_8325_;
                        let _e4747 = phi_8326_;
                        let _e4749 = phi_8327_;
                        let _e4751 = phi_8328_;
                        let _e4753 = phi_8329_;
                        local_41 = _e4745;
                        local_42 = _e4747;
                        local_43 = _e4745;
                        local_44 = _e4749;
                        local_45 = _e4745;
                        local_46 = _e4751;
                        local_47 = _e4745;
                        local_48 = _e4753;
                        local_49 = _e4735;
                        local_50 = _e4735;
                        local_51 = _e4737;
                        local_52 = _e4735;
                        local_62 = _e4745;
                        local_53 = _e4741;
                        local_55 = _e4739;
                        local_56 = _e4727;
                        continue;
                        continuing {
                            phi_3299_ = _e1655;
                            phi_3302_ = _e4729;
                            phi_3304_ = _e4731;
                            phi_3306_ = _e4733;
                            break if !(_e4743);
                        }
                    }
                    let _e4756 = local_41;
                    let _e4758 = local_42;
                    let _e4759 = select(_e4758, false, _e4756);
                    let _e4761 = local_43;
                    let _e4763 = local_44;
                    let _e4766 = local_45;
                    let _e4768 = local_46;
                    let _e4771 = local_47;
                    let _e4773 = local_48;
                    if _e4759 {
                        let _e4776 = local_49;
                        if (_e4776.member >= _e552) {
                            phi_8358_ = type_38(type_37(0u, f64()), 0u);
                        } else {
                            let _e4780 = local_50;
                            let _e4784 = local_51;
                            let _e4787 = local_52;
                            phi_8358_ = type_38(type_37(2u, _e4787.member), select(_e4784, 0u, (_e4780.member > _e543)));
                        }
                        let _e4794 = phi_8358_;
                        phi_8359_ = _e4794;
                        phi_8360_ = false;
                        phi_8361_ = false;
                        phi_8362_ = false;
                        phi_8363_ = false;
                    } else {
                        phi_8359_ = type_38();
                        phi_8360_ = select(_e4763, false, _e4761);
                        let _e5632 = local_62;
                        phi_8361_ = _e5632;
                        phi_8362_ = select(_e4768, false, _e4766);
                        phi_8363_ = select(_e4773, false, _e4771);
                    }
                    let _e4796 = phi_8359_;
                    let _e4798 = phi_8360_;
                    let _e4800 = phi_8361_;
                    let _e4802 = phi_8362_;
                    let _e4804 = phi_8363_;
                    let _e4806 = local_53;
                    let _e4808 = local_54;
                    let _e4811 = local_55;
                    let _e4813 = local_56;
                    let _e4815 = select(_e4800, true, _e4798);
                    let _e4820 = local_57;
                    let _e4821 = select(_e4820, select(_e4813, _e4811, _e4798), _e4815);
                    let _e4823 = local_58;
                    let _e4824 = select(_e4823, select(_e4808, _e4806, _e4798), _e4815);
                    if select(select(_e4802, false, _e4798), true, _e4815) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8397_ = type_9(0u, 3u);
                        loop {
                            let _e4837 = phi_8397_;
                            let _e4840 = (_e4837.member < _e4837.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4840)) != 0i) {
                                let _e4855 = local[select(type_9().member_1, _e4837.member, _e4840)];
                                let _e4858 = (_e4821 + (select(f64(0f), _e534, (_e534 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4855)));
                                let _e4860 = select(_e552, _e4858, (_e4858 < _e552));
                                let _e4863 = local_5.member[0u];
                                let _e4869 = local_5.member[1u];
                                let _e4885 = local_5.member_1[0u];
                                let _e4891 = local_5.member_1[1u];
                                let _e4907 = local_5.member_2[0u];
                                let _e4913 = local_5.member_2[1u];
                                let _e4927 = function_4(array<f64, 3>((_e4863[0] + ((_e4869[0] - _e4863[0]) * _e4860)), (_e4863[1] + ((_e4869[1] - _e4863[1]) * _e4860)), (_e4863[2] + ((_e4869[2] - _e4863[2]) * _e4860))), array<f64, 3>((_e4885[0] + ((_e4891[0] - _e4885[0]) * _e4860)), (_e4885[1] + ((_e4891[1] - _e4885[1]) * _e4860)), (_e4885[2] + ((_e4891[2] - _e4885[2]) * _e4860))), array<f64, 3>((_e4907[0] + ((_e4913[0] - _e4907[0]) * _e4860)), (_e4907[1] + ((_e4913[1] - _e4907[1]) * _e4860)), (_e4907[2] + ((_e4913[2] - _e4907[2]) * _e4860))), _e231.member);
                                let _e4938 = (((_e4927[0] * _e4927[0]) + (_e4927[1] * _e4927[1])) + (_e4927[2] * _e4927[2]));
                                if (_e4938 <= 2.2250738585072014e-308lf) {
                                    phi_8630_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4938 > 0.0lf));
                                } else {
                                    phi_8573_ = type_16(0i, 5i);
                                    phi_8576_ = bitcast<f64>(((bitcast<u64>(_e4938) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4945 = phi_8573_;
                                        let _e4947 = phi_8576_;
                                        local_59 = _e4947;
                                        if (_e4945.member < _e4945.member_1) {
                                            let _e4954 = (_e4945.member + 1i);
                                            phi_8574_ = type_16(select(_e4954, type_17().member_1, select(false, true, ((false == (_e4954 > _e4945.member)) != false))), _e4945.member_1);
                                            phi_8617_ = type_17(1u, _e4945.member);
                                        } else {
                                            phi_8574_ = _e4945;
                                            phi_8617_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e4965 = phi_8574_;
                                        let _e4967 = phi_8617_;
                                        let _e4970 = (bitcast<i32>(_e4967.member) != 0i);
                                        if _e4970 {
                                            phi_8577_ = (0.5lf * (_e4947 + (_e4938 / _e4947)));
                                        } else {
                                            phi_8577_ = f64();
                                        }
                                        let _e4975 = phi_8577_;
                                        continue;
                                        continuing {
                                            phi_8573_ = _e4965;
                                            phi_8576_ = _e4975;
                                            break if !(_e4970);
                                        }
                                    }
                                    let _e4980 = local_59;
                                    phi_8630_ = (_e4980 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4986 = phi_8630_;
                                let _e4994 = local_5.member[0u];
                                let _e5000 = select(_e4994[0], -(_e4994[0]), (_e4994[0] < 0.0lf));
                                let _e5003 = select(_e4994[1], -(_e4994[1]), (_e4994[1] < 0.0lf));
                                let _e5005 = select(_e5003, _e5000, (_e5000 > _e5003));
                                let _e5008 = select(_e4994[2], -(_e4994[2]), (_e4994[2] < 0.0lf));
                                let _e5010 = select(_e5008, _e5005, (_e5005 > _e5008));
                                let _e5013 = local_5.member[1u];
                                let _e5019 = select(_e5013[0], -(_e5013[0]), (_e5013[0] < 0.0lf));
                                let _e5022 = select(_e5013[1], -(_e5013[1]), (_e5013[1] < 0.0lf));
                                let _e5024 = select(_e5022, _e5019, (_e5019 > _e5022));
                                let _e5027 = select(_e5013[2], -(_e5013[2]), (_e5013[2] < 0.0lf));
                                let _e5029 = select(_e5027, _e5024, (_e5024 > _e5027));
                                let _e5033 = local_5.member_3;
                                let _e5037 = local_5.member_1[0u];
                                let _e5043 = select(_e5037[0], -(_e5037[0]), (_e5037[0] < 0.0lf));
                                let _e5046 = select(_e5037[1], -(_e5037[1]), (_e5037[1] < 0.0lf));
                                let _e5048 = select(_e5046, _e5043, (_e5043 > _e5046));
                                let _e5051 = select(_e5037[2], -(_e5037[2]), (_e5037[2] < 0.0lf));
                                let _e5053 = select(_e5051, _e5048, (_e5048 > _e5051));
                                let _e5056 = local_5.member_1[1u];
                                let _e5062 = select(_e5056[0], -(_e5056[0]), (_e5056[0] < 0.0lf));
                                let _e5065 = select(_e5056[1], -(_e5056[1]), (_e5056[1] < 0.0lf));
                                let _e5067 = select(_e5065, _e5062, (_e5062 > _e5065));
                                let _e5070 = select(_e5056[2], -(_e5056[2]), (_e5056[2] < 0.0lf));
                                let _e5072 = select(_e5070, _e5067, (_e5067 > _e5070));
                                let _e5076 = local_5.member_3;
                                let _e5080 = local_5.member_2[0u];
                                let _e5086 = select(_e5080[0], -(_e5080[0]), (_e5080[0] < 0.0lf));
                                let _e5089 = select(_e5080[1], -(_e5080[1]), (_e5080[1] < 0.0lf));
                                let _e5091 = select(_e5089, _e5086, (_e5086 > _e5089));
                                let _e5094 = select(_e5080[2], -(_e5080[2]), (_e5080[2] < 0.0lf));
                                let _e5096 = select(_e5094, _e5091, (_e5091 > _e5094));
                                let _e5099 = local_5.member_2[1u];
                                let _e5105 = select(_e5099[0], -(_e5099[0]), (_e5099[0] < 0.0lf));
                                let _e5108 = select(_e5099[1], -(_e5099[1]), (_e5099[1] < 0.0lf));
                                let _e5110 = select(_e5108, _e5105, (_e5105 > _e5108));
                                let _e5113 = select(_e5099[2], -(_e5099[2]), (_e5099[2] < 0.0lf));
                                let _e5115 = select(_e5113, _e5110, (_e5110 > _e5113));
                                let _e5119 = local_5.member_3;
                                let _e5127 = local_5.member_3;
                                let _e5137 = (((_e4986 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e5029, _e5010, (_e5010 > _e5029)) + _e5033) + (select(_e5072, _e5053, (_e5053 > _e5072)) + _e5076)) + (select(_e5115, _e5096, (_e5096 > _e5115)) + _e5119)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5127 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e906.member_1);
                                phi_8907_ = select(true, false, _e5137);
                                phi_8908_ = _e5137;
                            } else {
                                phi_8907_ = false;
                                phi_8908_ = false;
                            }
                            let _e5140 = phi_8907_;
                            let _e5142 = phi_8908_;
                            local_60 = _e5142;
                            continue;
                            continuing {
                                phi_8397_ = type_9(select(_e4837.member, (_e4837.member + 1u), _e4840), select(_e4837.member_1, _e4837.member_1, _e4840));
                                break if !(_e5140);
                            }
                        }
                        let _e5145 = local_60;
                        if _e5145 {
                            phi_8920_ = type_38(type_37(1u, _e4821), select(_e4824, 1u, (_e4821 > _e543)));
                            phi_8921_ = false;
                        } else {
                            phi_8920_ = type_38();
                            phi_8921_ = true;
                        }
                        let _e5151 = phi_8920_;
                        let _e5153 = phi_8921_;
                        if _e5153 {
                            phi_8933_ = type_38(type_37(2u, _e4821), select(_e4824, 0u, (_e4821 > _e543)));
                        } else {
                            phi_8933_ = _e5151;
                        }
                        let _e5159 = phi_8933_;
                        phi_8934_ = _e5159;
                        phi_8935_ = false;
                        phi_8936_ = false;
                    } else {
                        phi_8934_ = type_38();
                        phi_8935_ = select(select(_e4804, false, _e4798), false, _e4815);
                        phi_8936_ = select(select(_e4759, false, _e4798), false, _e4815);
                    }
                    let _e5161 = phi_8934_;
                    let _e5163 = phi_8935_;
                    let _e5165 = phi_8936_;
                    if _e5163 {
                        phi_8943_ = type_38(type_37(0u, f64()), 0u);
                        phi_8944_ = true;
                    } else {
                        phi_8943_ = _e4796;
                        phi_8944_ = _e5165;
                    }
                    let _e5169 = phi_8943_;
                    let _e5171 = phi_8944_;
                    phi_8948_ = _e5169;
                    phi_8949_ = _e5161;
                    phi_8950_ = _e5171;
                } else {
                    phi_8948_ = _e1627;
                    phi_8949_ = type_38();
                    phi_8950_ = true;
                }
                let _e5173 = phi_8948_;
                let _e5175 = phi_8949_;
                let _e5177 = phi_8950_;
                if _e5177 {
                    phi_8954_ = _e5173;
                } else {
                    phi_8954_ = _e5175;
                }
                let _e5179 = phi_8954_;
                switch bitcast<i32>(_e5179.member.member) {
                    case 0: {
                        phi_8972_ = type_35(0u, _e5179.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5190 = function_1(_e5179.member.member_1);
                        phi_8972_ = type_35(0u, _e5179.member_1, _e5190, true);
                        break;
                    }
                    case 2: {
                        let _e5186 = function_1(_e5179.member.member_1);
                        phi_8972_ = type_35(1u, _e5179.member_1, _e5186, true);
                        break;
                    }
                    default: {
                        phi_8972_ = type_35();
                        break;
                    }
                }
                let _e5194 = phi_8972_;
                local_6 = type_35(_e5194.member, _e5194.member_1, array<u32, 2>(_e5194.member_2[0], _e5194.member_2[1]), _e5194.member_3);
                phi_8981_ = type_9(_e189, _e192);
            } else {
                phi_8981_ = type_9(0u, 0u);
            }
            let _e5204 = phi_8981_;
            let _e5210 = local_6.member_3;
            if _e5210 {
                let _e5212 = params.member.member.member_1;
                phi_9006_ = ((_e5212 & 16u) != 0u);
            } else {
                phi_9006_ = false;
            }
            let _e5216 = phi_9006_;
            let _e5218 = local_6.member_3;
            if _e5218 {
                let _e5220 = local_6.member_2;
                let _e5225 = ((_e5220[1] >> bitcast<u32>(20i)) & 2047u);
                let _e5239 = atomicMin((&earliest.member[0u]), select(((((_e5225 - 896u) << bitcast<u32>(23i)) | ((_e5220[1] & 1048575u) << bitcast<u32>(3i))) | (_e5220[0] >> bitcast<u32>(29i))), 0u, (_e5225 <= 896u)));
            }
            if (_e107 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5216 {
                let _e5243 = atomicAdd((&counters[0u]), 1u);
                phi_9050_ = _e5243;
            } else {
                phi_9050_ = 0u;
            }
            let _e5245 = phi_9050_;
            workgroupBarrier();
            if (_e107 == 0u) {
                let _e5248 = atomicLoad((&counters[0u]));
                if (_e5248 > 0u) {
                    let _e5251 = atomicAdd((&contacts.member[0u]), _e5248);
                    atomicStore((&counters[1u]), _e5251);
                }
            }
            workgroupBarrier();
            let _e5254 = atomicLoad((&counters[1u]));
            let _e5255 = (_e5254 + _e5245);
            if _e5216 {
                let _e5257 = params.member.member_1.member_3;
                if (_e5255 < _e5257) {
                    let _e5263 = (7u * _e5255);
                    atomicStore((&contacts.member[(4u + _e5263)]), select(1u, 0u, ((_e5204.member_1 & 2147483648u) == 0u)));
                    let _e5268 = local_6.member;
                    atomicStore((&contacts.member[(_e5263 + 5u)]), _e5268);
                    atomicStore((&contacts.member[(_e5263 + 6u)]), _e5204.member);
                    atomicStore((&contacts.member[(_e5263 + 7u)]), (_e5204.member_1 & 2147483647u));
                    let _e5277 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e5263 + 8u)]), _e5277);
                    let _e5282 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e5263 + 9u)]), _e5282);
                    let _e5286 = local_6.member_1;
                    atomicStore((&contacts.member[(_e5263 + 10u)]), _e5286);
                }
            }
        }
        continue;
        continuing {
            phi_1002_ = type_9(select(_e160.member, (_e160.member + 1u), _e163), select(_e160.member_1, _e160.member_1, _e163));
            break if !(_e176);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
