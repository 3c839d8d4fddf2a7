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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_37 {
    member: type_33,
    member_1: f64,
}

struct type_38 {
    member: u32,
    member_1: f64,
}

struct type_39 {
    member: type_38,
    member_1: u32,
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
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_235_: f64;
    var phi_278_: f64;
    var phi_321_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_235_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_235_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_235_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_278_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_278_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_278_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_321_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_321_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_321_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])));
    return array<f64, 3>(select(param_1[0], param_2[0], _e24), select(param_1[1], param_2[1], _e24), select(param_1[2], param_2[2], _e24));
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_842_: array<array<f64, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e163 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_3[0] - param_5[0]);
        let _e272 = (param_3[1] - param_5[1]);
        let _e275 = (param_3[2] - param_5[2]);
        let _e295 = ((((_e269 * param_4[0]) + (_e272 * param_4[1])) + (_e275 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_842_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e171)), (param_3[1] - (param_4[1] * _e171)), (param_3[2] - (param_4[2] * _e171))), array<f64, 3>((param_3[0] - (param_5[0] * _e215)), (param_3[1] - (param_5[1] * _e215)), (param_3[2] - (param_5[2] * _e215))), array<f64, 3>((_e9 - (param_5[0] * _e256)), (_e12 - (param_5[1] * _e256)), (_e15 - (param_5[2] * _e256))), array<f64, 3>((_e269 - (param_4[0] * _e303)), (_e272 - (param_4[1] * _e303)), (_e275 - (param_4[2] * _e303))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_842_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e82)), (param_3[1] - (param_4[1] * _e82)), (param_3[2] - (param_4[2] * _e82))), array<f64, 3>((param_3[0] - (param_5[0] * _e126)), (param_3[1] - (param_5[1] * _e126)), (param_3[2] - (param_5[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_842_;
    let _e319 = function_1(_e316[0], _e316[1]);
    let _e321 = function_1(_e319, _e316[2]);
    let _e323 = function_1(_e321, _e316[3]);
    return _e323;
}

fn function_3(param_7: array<f64, 3>, param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: u32) -> array<f64, 3> {
    var phi_441_: bool;
    var phi_475_: array<f64, 3>;
    var phi_476_: bool;
    var phi_477_: array<f64, 3>;
    var phi_478_: bool;
    var phi_483_: array<f64, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_441_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_441_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_441_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_475_ = array<f64, 3>((param_7[0] - ((param_8[0] * _e76) + (param_9[0] * _e80))), (param_7[1] - ((param_8[1] * _e76) + (param_9[1] * _e80))), (param_7[2] - ((param_8[2] * _e76) + (param_9[2] * _e80))));
            phi_476_ = false;
        } else {
            phi_475_ = array<f64, 3>();
            phi_476_ = true;
        }
        let _e132 = phi_475_;
        let _e134 = phi_476_;
        phi_477_ = _e132;
        phi_478_ = _e134;
    } else {
        phi_477_ = array<f64, 3>();
        phi_478_ = true;
    }
    let _e136 = phi_477_;
    let _e138 = phi_478_;
    if _e138 {
        let _e139 = function_2(param_7, param_8, param_9, param_10);
        phi_483_ = _e139;
    } else {
        phi_483_ = _e136;
    }
    let _e141 = phi_483_;
    return _e141;
}

fn function_4(param_11: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_11);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_41;
    var local_2: type_36;
    var local_3: type_36;
    var local_4: type_36;
    var local_5: type_33;
    var phi_943_: u32;
    var phi_988_: u32;
    var phi_991_: type_9;
    var phi_1163_: type_23;
    var phi_1359_: type_31;
    var phi_1520_: type_33;
    var phi_1794_: bool;
    var phi_1890_: type_37;
    var phi_1891_: bool;
    var phi_1892_: type_37;
    var phi_1893_: bool;
    var phi_1894_: type_37;
    var phi_1895_: bool;
    var phi_1900_: type_37;
    var phi_2070_: type_16;
    var phi_2073_: f64;
    var phi_2071_: type_16;
    var phi_2114_: type_17;
    var phi_2074_: f64;
    var local_6: f64;
    var phi_2127_: f64;
    var phi_3054_: type_39;
    var phi_3055_: bool;
    var phi_3056_: type_39;
    var phi_3057_: bool;
    var phi_3063_: type_16;
    var phi_3066_: f64;
    var phi_3068_: u32;
    var phi_3070_: f64;
    var phi_3064_: type_16;
    var phi_3111_: type_17;
    var phi_3554_: type_9;
    var phi_3557_: f64;
    var phi_3559_: f64;
    var phi_3561_: f64;
    var phi_3563_: f64;
    var phi_3565_: bool;
    var phi_3567_: u32;
    var phi_3719_: array<f64, 3>;
    var phi_3787_: type_16;
    var phi_3790_: f64;
    var phi_3788_: type_16;
    var phi_3831_: type_17;
    var phi_3791_: f64;
    var local_7: f64;
    var phi_3844_: f64;
    var phi_3970_: type_36;
    var phi_3971_: bool;
    var phi_3972_: type_36;
    var phi_3973_: bool;
    var phi_3983_: type_36;
    var phi_4155_: bool;
    var phi_4156_: bool;
    var phi_4157_: bool;
    var phi_4158_: bool;
    var phi_4159_: bool;
    var phi_4160_: bool;
    var phi_4462_: bool;
    var phi_4463_: bool;
    var phi_4464_: bool;
    var phi_4465_: bool;
    var phi_4466_: bool;
    var phi_4467_: bool;
    var phi_4475_: bool;
    var phi_4585_: f64;
    var phi_4586_: bool;
    var phi_4587_: f64;
    var phi_4588_: bool;
    var phi_4589_: f64;
    var phi_4590_: bool;
    var phi_4591_: bool;
    var phi_4657_: f64;
    var phi_4658_: bool;
    var phi_4659_: f64;
    var phi_4660_: bool;
    var phi_4661_: f64;
    var phi_4662_: bool;
    var phi_4663_: bool;
    var phi_4734_: f64;
    var phi_4735_: bool;
    var phi_4736_: f64;
    var phi_4737_: bool;
    var phi_4738_: f64;
    var phi_4739_: bool;
    var phi_4740_: bool;
    var phi_4806_: f64;
    var phi_4807_: bool;
    var phi_4808_: f64;
    var phi_4809_: bool;
    var phi_4810_: f64;
    var phi_4811_: bool;
    var phi_4812_: bool;
    var phi_4989_: type_16;
    var phi_4992_: f64;
    var phi_4990_: type_16;
    var phi_5033_: type_17;
    var phi_4993_: f64;
    var local_8: f64;
    var phi_5046_: f64;
    var phi_5323_: bool;
    var phi_5324_: bool;
    var phi_5351_: f64;
    var phi_5352_: f64;
    var phi_5353_: bool;
    var phi_5354_: f64;
    var phi_5355_: f64;
    var phi_5356_: bool;
    var phi_5357_: bool;
    var phi_5358_: f64;
    var phi_5359_: f64;
    var phi_5360_: f64;
    var phi_5361_: f64;
    var phi_5362_: bool;
    var phi_5363_: bool;
    var phi_5364_: bool;
    var phi_5365_: bool;
    var phi_5366_: f64;
    var phi_5367_: f64;
    var phi_5368_: f64;
    var phi_5369_: f64;
    var phi_5370_: bool;
    var phi_5371_: bool;
    var phi_5372_: bool;
    var phi_5373_: bool;
    var phi_5374_: bool;
    var phi_5375_: f64;
    var phi_5376_: f64;
    var phi_5377_: f64;
    var phi_5378_: f64;
    var phi_5379_: bool;
    var phi_5380_: bool;
    var phi_5381_: bool;
    var phi_5382_: bool;
    var phi_5383_: bool;
    var phi_5721_: f64;
    var phi_5723_: u32;
    var phi_5724_: f64;
    var phi_5725_: bool;
    var phi_5726_: bool;
    var phi_5727_: bool;
    var phi_5728_: u32;
    var phi_5729_: f64;
    var phi_5730_: f64;
    var phi_5731_: f64;
    var phi_5732_: f64;
    var phi_5733_: bool;
    var phi_5734_: u32;
    var phi_5735_: bool;
    var phi_5736_: bool;
    var phi_5737_: bool;
    var phi_5738_: bool;
    var phi_5739_: bool;
    var phi_5740_: bool;
    var phi_5768_: f64;
    var phi_5769_: f64;
    var phi_5770_: f64;
    var phi_5771_: f64;
    var phi_5772_: bool;
    var phi_5773_: u32;
    var phi_5774_: bool;
    var phi_5775_: bool;
    var phi_5776_: bool;
    var phi_5777_: bool;
    var phi_5778_: bool;
    var phi_5779_: bool;
    var phi_3558_: f64;
    var phi_3560_: f64;
    var phi_3562_: f64;
    var phi_3564_: f64;
    var phi_3566_: bool;
    var phi_3568_: u32;
    var phi_5780_: f64;
    var phi_5781_: f64;
    var phi_5782_: bool;
    var phi_5783_: bool;
    var phi_5784_: bool;
    var phi_5785_: bool;
    var phi_5786_: bool;
    var phi_5787_: bool;
    var phi_5788_: bool;
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
    var local_19: f64;
    var local_20: bool;
    var local_21: f64;
    var local_22: f64;
    var local_23: f64;
    var phi_5855_: f64;
    var phi_5856_: bool;
    var phi_6481_: type_16;
    var phi_6484_: f64;
    var phi_6482_: type_16;
    var phi_6525_: type_17;
    var phi_6485_: f64;
    var local_24: f64;
    var phi_6538_: f64;
    var phi_6776_: type_16;
    var phi_6779_: f64;
    var phi_6777_: type_16;
    var phi_6820_: type_17;
    var phi_6780_: f64;
    var local_25: f64;
    var phi_6833_: f64;
    var phi_6865_: type_16;
    var phi_6868_: f64;
    var phi_6866_: type_16;
    var phi_6909_: type_17;
    var phi_6869_: f64;
    var local_26: f64;
    var phi_6922_: f64;
    var phi_7240_: type_9;
    var phi_7243_: f64;
    var phi_7244_: f64;
    var local_27: f64;
    var local_28: f64;
    var phi_7345_: type_16;
    var phi_7348_: f64;
    var phi_7346_: type_16;
    var phi_7389_: type_17;
    var phi_7349_: f64;
    var local_29: f64;
    var phi_7402_: f64;
    var phi_7409_: type_9;
    var phi_7412_: f64;
    var phi_7414_: bool;
    var phi_7416_: bool;
    var phi_7652_: f64;
    var phi_7653_: f64;
    var phi_7413_: f64;
    var phi_7415_: bool;
    var phi_7417_: bool;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_7671_: type_42;
    var phi_7672_: bool;
    var local_36: bool;
    var phi_7694_: type_9;
    var phi_7697_: f64;
    var phi_7699_: f64;
    var phi_7809_: f64;
    var phi_7810_: f64;
    var phi_7811_: f64;
    var phi_7812_: f64;
    var phi_7698_: f64;
    var phi_7700_: f64;
    var local_37: f64;
    var local_38: f64;
    var local_39: f64;
    var phi_7975_: bool;
    var phi_7976_: bool;
    var phi_7977_: bool;
    var phi_7978_: bool;
    var phi_7979_: bool;
    var phi_7980_: bool;
    var phi_7989_: bool;
    var phi_7990_: bool;
    var phi_7999_: type_42;
    var phi_8000_: type_42;
    var phi_8001_: bool;
    var phi_8002_: type_42;
    var phi_8003_: type_42;
    var phi_8004_: bool;
    var phi_8010_: type_42;
    var phi_8011_: type_42;
    var phi_8012_: bool;
    var phi_8016_: type_42;
    var phi_8017_: type_42;
    var phi_8018_: bool;
    var phi_8019_: bool;
    var phi_8020_: type_42;
    var phi_8021_: type_42;
    var phi_8022_: bool;
    var phi_8023_: bool;
    var phi_8058_: f64;
    var phi_8059_: f64;
    var phi_8060_: bool;
    var phi_8061_: bool;
    var phi_8062_: bool;
    var phi_8063_: f64;
    var phi_8064_: u32;
    var phi_8065_: f64;
    var phi_8066_: type_42;
    var phi_8067_: u32;
    var phi_8068_: u32;
    var phi_8069_: bool;
    var phi_8070_: bool;
    var phi_8071_: bool;
    var phi_8072_: f64;
    var phi_8073_: u32;
    var phi_8074_: f64;
    var phi_8075_: type_42;
    var phi_8076_: u32;
    var phi_8077_: u32;
    var phi_8078_: bool;
    var phi_8079_: bool;
    var phi_8080_: bool;
    var phi_8081_: bool;
    var phi_8082_: bool;
    var phi_8083_: f64;
    var phi_3067_: f64;
    var phi_3069_: u32;
    var phi_3071_: f64;
    var phi_8084_: type_42;
    var phi_8085_: u32;
    var phi_8086_: f64;
    var phi_8087_: u32;
    var phi_8088_: bool;
    var phi_8089_: bool;
    var phi_8090_: bool;
    var phi_8091_: bool;
    var phi_8092_: bool;
    var phi_8093_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_42;
    var local_49: type_42;
    var local_50: u32;
    var local_51: type_42;
    var phi_8122_: type_39;
    var phi_8123_: type_39;
    var phi_8124_: bool;
    var phi_8125_: bool;
    var phi_8126_: bool;
    var phi_8127_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: u32;
    var phi_8161_: type_9;
    var phi_8337_: type_16;
    var phi_8340_: f64;
    var phi_8338_: type_16;
    var phi_8381_: type_17;
    var phi_8341_: f64;
    var local_58: f64;
    var phi_8394_: f64;
    var phi_8671_: bool;
    var phi_8672_: bool;
    var local_59: bool;
    var phi_8684_: type_39;
    var phi_8685_: bool;
    var phi_8697_: type_39;
    var phi_8698_: type_39;
    var phi_8699_: bool;
    var phi_8700_: bool;
    var phi_8707_: type_39;
    var phi_8708_: bool;
    var phi_8712_: type_39;
    var phi_8713_: type_39;
    var phi_8714_: bool;
    var phi_8718_: type_39;
    var phi_8736_: type_35;
    var phi_8737_: type_35;
    var phi_8738_: type_9;
    var phi_8778_: u32;
    var phi_8792_: u32;
    var phi_8862_: bool;
    var phi_8863_: bool;
    var local_60: bool;
    var local_61: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e103 = id_2;
    let _e104 = n_2;
    let _e105 = lane_2;
    let _e117 = ((_e103.y * _e104.x) + _e103.x);
    let _e120 = (_e104.x * _e104.y);
    let _e123 = params.member.member_1.member_2;
    let _e125 = input.member[0u];
    let _e127 = select(_e125, _e123, (_e123 < _e125));
    let _e129 = params.member.member_1.member_1;
    if (_e127 > _e129) {
        let _e132 = params.member.member_1.member_1;
        phi_943_ = (_e127 - _e132);
    } else {
        phi_943_ = 0u;
    }
    let _e135 = phi_943_;
    let _e137 = params.member.member_1.member;
    let _e139 = select(_e135, _e137, (_e137 < _e135));
    let _e140 = (_e139 / 64u);
    let _e144 = select(_e140, (_e140 + 1u), ((_e139 % 64u) > 0u));
    if (_e144 > _e117) {
        let _e146 = (_e144 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e148 = (_e146 / _e120);
        if (_e120 == 0u) {
            return;
        }
        phi_988_ = select(_e148, (_e148 + 1u), ((_e146 % _e120) > 0u));
    } else {
        phi_988_ = 0u;
    }
    let _e155 = phi_988_;
    phi_991_ = type_9(0u, _e155);
    loop {
        let _e158 = phi_991_;
        let _e161 = (_e158.member < _e158.member_1);
        let _e174 = (bitcast<i32>(select(0u, 1u, _e161)) != 0i);
        if _e174 {
            let _e178 = (((_e117 + (select(type_9().member_1, _e158.member, _e161) * _e120)) * 64u) + _e105);
            if (_e178 < _e139) {
                let _e182 = params.member.member_1.member_1;
                let _e184 = (2u * (_e182 + _e178));
                let _e187 = input.member[(4u + _e184)];
                let _e190 = input.member[(_e184 + 5u)];
                let _e195 = (_e190 & 2147483647u);
                if (select(1u, 0u, ((_e190 & 2147483648u) == 0u)) == 0u) {
                    let _e214 = params.member.member.member[1u];
                    let _e217 = ((2u * _e214) + (3u * _e195));
                    let _e219 = elements.member[_e217];
                    let _e222 = elements.member[(_e217 + 1u)];
                    let _e225 = elements.member[(_e217 + 2u)];
                    phi_1163_ = type_23(0u, array<u32, 4>(_e187, _e219, _e222, _e225));
                } else {
                    let _e198 = (2u * _e187);
                    let _e200 = elements.member[_e198];
                    let _e203 = elements.member[(_e198 + 1u)];
                    let _e204 = (2u * _e195);
                    let _e206 = elements.member[_e204];
                    let _e209 = elements.member[(_e204 + 1u)];
                    phi_1163_ = type_23(1u, array<u32, 4>(_e200, _e203, _e206, _e209));
                }
                let _e229 = phi_1163_;
                let _e233 = params.member.member.member_1;
                if ((_e233 & 8u) != 0u) {
                    let _e277 = paths.member[_e229.member_1[0]];
                    let _e292 = paths.member[_e229.member_1[1]];
                    let _e307 = paths.member[_e229.member_1[2]];
                    let _e322 = paths.member[_e229.member_1[3]];
                    let _e343 = function_(array<f32, 3>(_e277.member.x, _e277.member.y, _e277.member.z));
                    let _e344 = function_(array<f32, 3>(_e292.member.x, _e292.member.y, _e292.member.z));
                    let _e345 = function_(array<f32, 3>(_e307.member.x, _e307.member.y, _e307.member.z));
                    let _e346 = function_(array<f32, 3>(_e322.member.x, _e322.member.y, _e322.member.z));
                    let _e348 = function_(array<f32, 3>(_e277.member_1.x, _e277.member_1.y, _e277.member_1.z));
                    let _e349 = function_(array<f32, 3>(_e292.member_1.x, _e292.member_1.y, _e292.member_1.z));
                    let _e350 = function_(array<f32, 3>(_e307.member_1.x, _e307.member_1.y, _e307.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e322.member_1.x, _e322.member_1.y, _e322.member_1.z));
                    phi_1359_ = type_31(array<array<f64, 3>, 4>(_e343, _e344, _e345, _e346), array<array<f64, 3>, 4>(_e348, _e349, _e350, _e351));
                } else {
                    let _e238 = positions.member[_e229.member_1[0]];
                    let _e241 = params.member.member.member[0u];
                    let _e244 = positions.member[(_e241 + _e229.member_1[0])];
                    let _e247 = positions.member[_e229.member_1[1]];
                    let _e250 = params.member.member.member[0u];
                    let _e253 = positions.member[(_e250 + _e229.member_1[1])];
                    let _e256 = positions.member[_e229.member_1[2]];
                    let _e259 = params.member.member.member[0u];
                    let _e262 = positions.member[(_e259 + _e229.member_1[2])];
                    let _e265 = positions.member[_e229.member_1[3]];
                    let _e268 = params.member.member.member[0u];
                    let _e271 = positions.member[(_e268 + _e229.member_1[3])];
                    phi_1359_ = type_31(array<array<f64, 3>, 4>(_e238, _e247, _e256, _e265), array<array<f64, 3>, 4>(_e244, _e253, _e262, _e271));
                }
                let _e355 = phi_1359_;
                if (_e229.member != 0u) {
                    phi_1520_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[0][0]), (_e355.member[2][1] - _e355.member[0][1]), (_e355.member[2][2] - _e355.member[0][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[0][0]), (_e355.member_1[2][1] - _e355.member_1[0][1]), (_e355.member_1[2][2] - _e355.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[1][0] - _e355.member[0][0]), (_e355.member[1][1] - _e355.member[0][1]), (_e355.member[1][2] - _e355.member[0][2])), array<f64, 3>((_e355.member_1[1][0] - _e355.member_1[0][0]), (_e355.member_1[1][1] - _e355.member_1[0][1]), (_e355.member_1[1][2] - _e355.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[3][0]), (_e355.member[2][1] - _e355.member[3][1]), (_e355.member[2][2] - _e355.member[3][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[3][0]), (_e355.member_1[2][1] - _e355.member_1[3][1]), (_e355.member_1[2][2] - _e355.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1520_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[0][0] - _e355.member[1][0]), (_e355.member[0][1] - _e355.member[1][1]), (_e355.member[0][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[0][0] - _e355.member_1[1][0]), (_e355.member_1[0][1] - _e355.member_1[1][1]), (_e355.member_1[0][2] - _e355.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[1][0]), (_e355.member[2][1] - _e355.member[1][1]), (_e355.member[2][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[1][0]), (_e355.member_1[2][1] - _e355.member_1[1][1]), (_e355.member_1[2][2] - _e355.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[3][0] - _e355.member[1][0]), (_e355.member[3][1] - _e355.member[1][1]), (_e355.member[3][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[3][0] - _e355.member_1[1][0]), (_e355.member_1[3][1] - _e355.member_1[1][1]), (_e355.member_1[3][2] - _e355.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e514 = phi_1520_;
                let _e516 = params.member.member.member_7;
                let _e523 = bitcast<f64>(((u64(_e516[1]) * 4294967296lu) + u64(_e516[0])));
                let _e525 = params.member.member.member_14;
                let _e532 = bitcast<f64>(((u64(_e525[1]) * 4294967296lu) + u64(_e525[0])));
                let _e534 = params.member.member.member_15;
                let _e541 = bitcast<f64>(((u64(_e534[1]) * 4294967296lu) + u64(_e534[0])));
                let _e543 = params.member.member.member_16;
                let _e550 = bitcast<f64>(((u64(_e543[1]) * 4294967296lu) + u64(_e543[0])));
                let _e552 = params.member.member.member_1;
                let _e560 = select(_e514.member[0][0], -(_e514.member[0][0]), (_e514.member[0][0] < 0.0lf));
                let _e564 = select(_e514.member[0][1], -(_e514.member[0][1]), (_e514.member[0][1] < 0.0lf));
                let _e566 = select(_e564, _e560, (_e560 > _e564));
                let _e570 = select(_e514.member[0][2], -(_e514.member[0][2]), (_e514.member[0][2] < 0.0lf));
                let _e572 = select(_e570, _e566, (_e566 > _e570));
                let _e578 = select(_e514.member[1][0], -(_e514.member[1][0]), (_e514.member[1][0] < 0.0lf));
                let _e582 = select(_e514.member[1][1], -(_e514.member[1][1]), (_e514.member[1][1] < 0.0lf));
                let _e584 = select(_e582, _e578, (_e578 > _e582));
                let _e588 = select(_e514.member[1][2], -(_e514.member[1][2]), (_e514.member[1][2] < 0.0lf));
                let _e590 = select(_e588, _e584, (_e584 > _e588));
                let _e594 = (select(_e590, _e572, (_e572 > _e590)) + _e514.member_3);
                let _e600 = select(_e514.member_1[0][0], -(_e514.member_1[0][0]), (_e514.member_1[0][0] < 0.0lf));
                let _e604 = select(_e514.member_1[0][1], -(_e514.member_1[0][1]), (_e514.member_1[0][1] < 0.0lf));
                let _e606 = select(_e604, _e600, (_e600 > _e604));
                let _e610 = select(_e514.member_1[0][2], -(_e514.member_1[0][2]), (_e514.member_1[0][2] < 0.0lf));
                let _e612 = select(_e610, _e606, (_e606 > _e610));
                let _e618 = select(_e514.member_1[1][0], -(_e514.member_1[1][0]), (_e514.member_1[1][0] < 0.0lf));
                let _e622 = select(_e514.member_1[1][1], -(_e514.member_1[1][1]), (_e514.member_1[1][1] < 0.0lf));
                let _e624 = select(_e622, _e618, (_e618 > _e622));
                let _e628 = select(_e514.member_1[1][2], -(_e514.member_1[1][2]), (_e514.member_1[1][2] < 0.0lf));
                let _e630 = select(_e628, _e624, (_e624 > _e628));
                let _e634 = (select(_e630, _e612, (_e612 > _e630)) + _e514.member_3);
                let _e640 = select(_e514.member_2[0][0], -(_e514.member_2[0][0]), (_e514.member_2[0][0] < 0.0lf));
                let _e644 = select(_e514.member_2[0][1], -(_e514.member_2[0][1]), (_e514.member_2[0][1] < 0.0lf));
                let _e646 = select(_e644, _e640, (_e640 > _e644));
                let _e650 = select(_e514.member_2[0][2], -(_e514.member_2[0][2]), (_e514.member_2[0][2] < 0.0lf));
                let _e652 = select(_e650, _e646, (_e646 > _e650));
                let _e658 = select(_e514.member_2[1][0], -(_e514.member_2[1][0]), (_e514.member_2[1][0] < 0.0lf));
                let _e662 = select(_e514.member_2[1][1], -(_e514.member_2[1][1]), (_e514.member_2[1][1] < 0.0lf));
                let _e664 = select(_e662, _e658, (_e658 > _e662));
                let _e668 = select(_e514.member_2[1][2], -(_e514.member_2[1][2]), (_e514.member_2[1][2] < 0.0lf));
                let _e670 = select(_e668, _e664, (_e664 > _e668));
                let _e674 = (select(_e670, _e652, (_e652 > _e670)) + _e514.member_3);
                let _e676 = select(_e634, _e594, (_e594 > _e634));
                let _e678 = select(_e674, _e676, (_e676 > _e674));
                if (_e678 <= f64(65536f)) {
                    phi_1794_ = (_e678 >= f64((1f / 65536f)));
                } else {
                    phi_1794_ = false;
                }
                let _e685 = phi_1794_;
                if _e685 {
                    phi_1894_ = type_37();
                    phi_1895_ = true;
                } else {
                    if (_e678 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e678) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e692 = (9214364837600034816lu - (bitcast<u64>(_e678) & 9218868437227405312lu));
                            let _e695 = bitcast<f64>(select(4503599627370496lu, _e692, (_e692 > 4503599627370496lu)));
                            let _e696 = (_e523 * _e695);
                            phi_1890_ = type_37(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e514.member[0][0] * _e695), (_e514.member[0][1] * _e695), (_e514.member[0][2] * _e695)), array<f64, 3>((_e514.member[1][0] * _e695), (_e514.member[1][1] * _e695), (_e514.member[1][2] * _e695))), array<array<f64, 3>, 2>(array<f64, 3>((_e514.member_1[0][0] * _e695), (_e514.member_1[0][1] * _e695), (_e514.member_1[0][2] * _e695)), array<f64, 3>((_e514.member_1[1][0] * _e695), (_e514.member_1[1][1] * _e695), (_e514.member_1[1][2] * _e695))), array<array<f64, 3>, 2>(array<f64, 3>((_e514.member_2[0][0] * _e695), (_e514.member_2[0][1] * _e695), (_e514.member_2[0][2] * _e695)), array<f64, 3>((_e514.member_2[1][0] * _e695), (_e514.member_2[1][1] * _e695), (_e514.member_2[1][2] * _e695))), ((_e514.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e695)), select(_e696, select(2.2250738585072014e-308lf, _e696, (_e696 > 2.2250738585072014e-308lf)), (_e523 > f64(0f))));
                            phi_1891_ = false;
                        } else {
                            phi_1890_ = type_37();
                            phi_1891_ = true;
                        }
                        let _e767 = phi_1890_;
                        let _e769 = phi_1891_;
                        phi_1892_ = _e767;
                        phi_1893_ = _e769;
                    } else {
                        phi_1892_ = type_37();
                        phi_1893_ = true;
                    }
                    let _e771 = phi_1892_;
                    let _e773 = phi_1893_;
                    phi_1894_ = _e771;
                    phi_1895_ = _e773;
                }
                let _e775 = phi_1894_;
                let _e777 = phi_1895_;
                if _e777 {
                    phi_1900_ = type_37(_e514, _e523);
                } else {
                    phi_1900_ = _e775;
                }
                let _e780 = phi_1900_;
                local_5 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member[0][0], _e780.member.member[0][1], _e780.member.member[0][2]), array<f64, 3>(_e780.member.member[1][0], _e780.member.member[1][1], _e780.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member_1[0][0], _e780.member.member_1[0][1], _e780.member.member_1[0][2]), array<f64, 3>(_e780.member.member_1[1][0], _e780.member.member_1[1][1], _e780.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member_2[0][0], _e780.member.member_2[0][1], _e780.member.member_2[0][2]), array<f64, 3>(_e780.member.member_2[1][0], _e780.member.member_2[1][1], _e780.member.member_2[1][2])), _e780.member.member_3);
                let _e823 = local_5.member[0u];
                let _e829 = local_5.member[1u];
                let _e845 = local_5.member_1[0u];
                let _e851 = local_5.member_1[1u];
                let _e867 = local_5.member_2[0u];
                let _e873 = local_5.member_2[1u];
                let _e887 = function_3(array<f64, 3>((_e823[0] + ((_e829[0] - _e823[0]) * _e541)), (_e823[1] + ((_e829[1] - _e823[1]) * _e541)), (_e823[2] + ((_e829[2] - _e823[2]) * _e541))), array<f64, 3>((_e845[0] + ((_e851[0] - _e845[0]) * _e541)), (_e845[1] + ((_e851[1] - _e845[1]) * _e541)), (_e845[2] + ((_e851[2] - _e845[2]) * _e541))), array<f64, 3>((_e867[0] + ((_e873[0] - _e867[0]) * _e541)), (_e867[1] + ((_e873[1] - _e867[1]) * _e541)), (_e867[2] + ((_e873[2] - _e867[2]) * _e541))), _e229.member);
                let _e898 = (((_e887[0] * _e887[0]) + (_e887[1] * _e887[1])) + (_e887[2] * _e887[2]));
                if (_e898 <= 2.2250738585072014e-308lf) {
                    phi_2127_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e898 > 0.0lf));
                } else {
                    phi_2070_ = type_16(0i, 5i);
                    phi_2073_ = bitcast<f64>(((bitcast<u64>(_e898) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e905 = phi_2070_;
                        let _e907 = phi_2073_;
                        local_6 = _e907;
                        if (_e905.member < _e905.member_1) {
                            let _e914 = (_e905.member + 1i);
                            phi_2071_ = type_16(select(_e914, type_17().member_1, select(false, true, ((false == (_e914 > _e905.member)) != false))), _e905.member_1);
                            phi_2114_ = type_17(1u, _e905.member);
                        } else {
                            phi_2071_ = _e905;
                            phi_2114_ = type_17(0u, type_17().member_1);
                        }
                        let _e925 = phi_2071_;
                        let _e927 = phi_2114_;
                        let _e930 = (bitcast<i32>(_e927.member) != 0i);
                        if _e930 {
                            phi_2074_ = (0.5lf * (_e907 + (_e898 / _e907)));
                        } else {
                            phi_2074_ = f64();
                        }
                        let _e935 = phi_2074_;
                        continue;
                        continuing {
                            phi_2070_ = _e925;
                            phi_2073_ = _e935;
                            break if !(_e930);
                        }
                    }
                    let _e940 = local_6;
                    phi_2127_ = (_e940 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e946 = phi_2127_;
                let _e954 = local_5.member[0u];
                let _e960 = select(_e954[0], -(_e954[0]), (_e954[0] < 0.0lf));
                let _e963 = select(_e954[1], -(_e954[1]), (_e954[1] < 0.0lf));
                let _e965 = select(_e963, _e960, (_e960 > _e963));
                let _e968 = select(_e954[2], -(_e954[2]), (_e954[2] < 0.0lf));
                let _e970 = select(_e968, _e965, (_e965 > _e968));
                let _e973 = local_5.member[1u];
                let _e979 = select(_e973[0], -(_e973[0]), (_e973[0] < 0.0lf));
                let _e982 = select(_e973[1], -(_e973[1]), (_e973[1] < 0.0lf));
                let _e984 = select(_e982, _e979, (_e979 > _e982));
                let _e987 = select(_e973[2], -(_e973[2]), (_e973[2] < 0.0lf));
                let _e989 = select(_e987, _e984, (_e984 > _e987));
                let _e993 = local_5.member_3;
                let _e997 = local_5.member_1[0u];
                let _e1003 = select(_e997[0], -(_e997[0]), (_e997[0] < 0.0lf));
                let _e1006 = select(_e997[1], -(_e997[1]), (_e997[1] < 0.0lf));
                let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                let _e1011 = select(_e997[2], -(_e997[2]), (_e997[2] < 0.0lf));
                let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                let _e1016 = local_5.member_1[1u];
                let _e1022 = select(_e1016[0], -(_e1016[0]), (_e1016[0] < 0.0lf));
                let _e1025 = select(_e1016[1], -(_e1016[1]), (_e1016[1] < 0.0lf));
                let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                let _e1030 = select(_e1016[2], -(_e1016[2]), (_e1016[2] < 0.0lf));
                let _e1032 = select(_e1030, _e1027, (_e1027 > _e1030));
                let _e1036 = local_5.member_3;
                let _e1040 = local_5.member_2[0u];
                let _e1046 = select(_e1040[0], -(_e1040[0]), (_e1040[0] < 0.0lf));
                let _e1049 = select(_e1040[1], -(_e1040[1]), (_e1040[1] < 0.0lf));
                let _e1051 = select(_e1049, _e1046, (_e1046 > _e1049));
                let _e1054 = select(_e1040[2], -(_e1040[2]), (_e1040[2] < 0.0lf));
                let _e1056 = select(_e1054, _e1051, (_e1051 > _e1054));
                let _e1059 = local_5.member_2[1u];
                let _e1065 = select(_e1059[0], -(_e1059[0]), (_e1059[0] < 0.0lf));
                let _e1068 = select(_e1059[1], -(_e1059[1]), (_e1059[1] < 0.0lf));
                let _e1070 = select(_e1068, _e1065, (_e1065 > _e1068));
                let _e1073 = select(_e1059[2], -(_e1059[2]), (_e1059[2] < 0.0lf));
                let _e1075 = select(_e1073, _e1070, (_e1070 > _e1073));
                let _e1079 = local_5.member_3;
                let _e1087 = local_5.member_3;
                let _e1097 = (((_e946 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e989, _e970, (_e970 > _e989)) + _e993) + (select(_e1032, _e1013, (_e1013 > _e1032)) + _e1036)) + (select(_e1075, _e1056, (_e1056 > _e1075)) + _e1079)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1087 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e780.member_1);
                if _e1097 {
                    phi_3056_ = type_39();
                    phi_3057_ = true;
                } else {
                    let _e1100 = local_5.member_1[0u];
                    let _e1106 = local_5.member_2[0u];
                    let _e1112 = ((_e1100[1] * _e1106[2]) - (_e1100[2] * _e1106[1]));
                    let _e1115 = ((_e1100[2] * _e1106[0]) - (_e1100[0] * _e1106[2]));
                    let _e1118 = ((_e1100[0] * _e1106[1]) - (_e1100[1] * _e1106[0]));
                    let _e1121 = local_5.member_1[1u];
                    let _e1127 = local_5.member_2[1u];
                    let _e1133 = ((_e1121[1] * _e1127[2]) - (_e1121[2] * _e1127[1]));
                    let _e1136 = ((_e1121[2] * _e1127[0]) - (_e1121[0] * _e1127[2]));
                    let _e1139 = ((_e1121[0] * _e1127[1]) - (_e1121[1] * _e1127[0]));
                    let _e1142 = local_5.member_1[0u];
                    let _e1148 = local_5.member_2[1u];
                    let _e1163 = local_5.member_1[1u];
                    let _e1169 = local_5.member_2[0u];
                    let _e1182 = (((_e1142[1] * _e1148[2]) - (_e1142[2] * _e1148[1])) + ((_e1163[1] * _e1169[2]) - (_e1163[2] * _e1169[1])));
                    let _e1183 = (((_e1142[2] * _e1148[0]) - (_e1142[0] * _e1148[2])) + ((_e1163[2] * _e1169[0]) - (_e1163[0] * _e1169[2])));
                    let _e1184 = (((_e1142[0] * _e1148[1]) - (_e1142[1] * _e1148[0])) + ((_e1163[0] * _e1169[1]) - (_e1163[1] * _e1169[0])));
                    let _e1187 = local_5.member[0u];
                    let _e1198 = local_5.member[1u];
                    let _e1209 = local_5.member[0u];
                    let _e1218 = ((((_e1198[0] * _e1112) + (_e1198[1] * _e1115)) + (_e1198[2] * _e1118)) + (((_e1209[0] * _e1182) + (_e1209[1] * _e1183)) + (_e1209[2] * _e1184)));
                    let _e1221 = local_5.member[0u];
                    let _e1232 = local_5.member[1u];
                    let _e1241 = ((((_e1221[0] * _e1133) + (_e1221[1] * _e1136)) + (_e1221[2] * _e1139)) + (((_e1232[0] * _e1182) + (_e1232[1] * _e1183)) + (_e1232[2] * _e1184)));
                    let _e1244 = local_5.member[1u];
                    let _e1255 = local_5.member[0u];
                    let _e1261 = select(_e1255[0], -(_e1255[0]), (_e1255[0] < 0.0lf));
                    let _e1264 = select(_e1255[1], -(_e1255[1]), (_e1255[1] < 0.0lf));
                    let _e1266 = select(_e1264, _e1261, (_e1261 > _e1264));
                    let _e1269 = select(_e1255[2], -(_e1255[2]), (_e1255[2] < 0.0lf));
                    let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                    let _e1274 = local_5.member[1u];
                    let _e1280 = select(_e1274[0], -(_e1274[0]), (_e1274[0] < 0.0lf));
                    let _e1283 = select(_e1274[1], -(_e1274[1]), (_e1274[1] < 0.0lf));
                    let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                    let _e1288 = select(_e1274[2], -(_e1274[2]), (_e1274[2] < 0.0lf));
                    let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                    let _e1294 = local_5.member_3;
                    let _e1295 = (select(_e1290, _e1271, (_e1271 > _e1290)) + _e1294);
                    let _e1298 = local_5.member_1[0u];
                    let _e1304 = select(_e1298[0], -(_e1298[0]), (_e1298[0] < 0.0lf));
                    let _e1307 = select(_e1298[1], -(_e1298[1]), (_e1298[1] < 0.0lf));
                    let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                    let _e1312 = select(_e1298[2], -(_e1298[2]), (_e1298[2] < 0.0lf));
                    let _e1314 = select(_e1312, _e1309, (_e1309 > _e1312));
                    let _e1317 = local_5.member_1[1u];
                    let _e1323 = select(_e1317[0], -(_e1317[0]), (_e1317[0] < 0.0lf));
                    let _e1326 = select(_e1317[1], -(_e1317[1]), (_e1317[1] < 0.0lf));
                    let _e1328 = select(_e1326, _e1323, (_e1323 > _e1326));
                    let _e1331 = select(_e1317[2], -(_e1317[2]), (_e1317[2] < 0.0lf));
                    let _e1333 = select(_e1331, _e1328, (_e1328 > _e1331));
                    let _e1337 = local_5.member_3;
                    let _e1338 = (select(_e1333, _e1314, (_e1314 > _e1333)) + _e1337);
                    let _e1341 = local_5.member_2[0u];
                    let _e1347 = select(_e1341[0], -(_e1341[0]), (_e1341[0] < 0.0lf));
                    let _e1350 = select(_e1341[1], -(_e1341[1]), (_e1341[1] < 0.0lf));
                    let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                    let _e1355 = select(_e1341[2], -(_e1341[2]), (_e1341[2] < 0.0lf));
                    let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                    let _e1360 = local_5.member_2[1u];
                    let _e1366 = select(_e1360[0], -(_e1360[0]), (_e1360[0] < 0.0lf));
                    let _e1369 = select(_e1360[1], -(_e1360[1]), (_e1360[1] < 0.0lf));
                    let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                    let _e1374 = select(_e1360[2], -(_e1360[2]), (_e1360[2] < 0.0lf));
                    let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                    let _e1380 = local_5.member_3;
                    let _e1381 = (select(_e1376, _e1357, (_e1357 > _e1376)) + _e1380);
                    let _e1382 = f64(1f);
                    let _e1383 = f64(8f);
                    let _e1385 = ((_e1338 * _e1383) * _e1381);
                    let _e1393 = local_5.member_3;
                    let _e1420 = ((select(_e1112, -(_e1112), (_e1112 < 0.0lf)) + select(_e1115, -(_e1115), (_e1115 < 0.0lf))) + select(_e1118, -(_e1118), (_e1118 < 0.0lf)));
                    let _e1431 = ((select(_e1133, -(_e1133), (_e1133 < 0.0lf)) + select(_e1136, -(_e1136), (_e1136 < 0.0lf))) + select(_e1139, -(_e1139), (_e1139 < 0.0lf)));
                    let _e1433 = select(_e1431, _e1420, (_e1420 > _e1431));
                    let _e1445 = (((select(_e1182, -(_e1182), (_e1182 < 0.0lf)) + select(_e1183, -(_e1183), (_e1183 < 0.0lf))) + select(_e1184, -(_e1184), (_e1184 < 0.0lf))) * f64(0.5f));
                    let _e1453 = local_5.member_3;
                    let _e1468 = f64(3f);
                    let _e1469 = ((((_e1187[0] * _e1112) + (_e1187[1] * _e1115)) + (_e1187[2] * _e1118)) * _e1468);
                    let _e1470 = ((((_e1244[0] * _e1133) + (_e1244[1] * _e1136)) + (_e1244[2] * _e1139)) * _e1468);
                    let _e1472 = select(_e1470, _e1469, (_e1469 < _e1470));
                    let _e1474 = select(_e1241, _e1218, (_e1218 < _e1241));
                    let _e1476 = select(_e1474, _e1472, (_e1472 < _e1474));
                    let _e1478 = select(_e1470, _e1469, (_e1469 > _e1470));
                    let _e1480 = select(_e1241, _e1218, (_e1218 > _e1241));
                    let _e1483 = -(select(_e1480, _e1478, (_e1478 > _e1480)));
                    if ((select(_e1483, _e1476, (_e1476 > _e1483)) - ((((((_e1295 * _e1383) * _e1385) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1393 * f64(19f)) * ((_e1295 * (_e1338 + _e1381)) + (_e1338 * _e1381)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1382 + _e1295) * ((_e1382 + _e1338) * (_e1382 + _e1381))))) + ((_e780.member_1 * (((select(_e1445, _e1433, (_e1433 > _e1445)) + (_e1385 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1453 * f64(6f)) * (_e1338 + _e1381))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1382 + _e1338) * (_e1382 + _e1381))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3054_ = type_39(type_38(0u, f64()), 0u);
                        phi_3055_ = false;
                    } else {
                        phi_3054_ = type_39();
                        phi_3055_ = true;
                    }
                    let _e1497 = phi_3054_;
                    let _e1499 = phi_3055_;
                    phi_3056_ = _e1497;
                    phi_3057_ = _e1499;
                }
                let _e1501 = phi_3056_;
                let _e1503 = phi_3057_;
                if _e1503 {
                    phi_3063_ = type_16(0i, 2i);
                    phi_3066_ = _e541;
                    phi_3068_ = 0u;
                    phi_3070_ = _e541;
                    loop {
                        let _e1505 = phi_3063_;
                        let _e1507 = phi_3066_;
                        let _e1509 = phi_3068_;
                        let _e1511 = phi_3070_;
                        local_53 = _e1509;
                        local_56 = _e1507;
                        local_57 = _e1509;
                        if (_e1505.member < _e1505.member_1) {
                            let _e1518 = (_e1505.member + 1i);
                            phi_3064_ = type_16(select(_e1518, type_17().member_1, select(false, true, ((false == (_e1518 > _e1505.member)) != false))), _e1505.member_1);
                            phi_3111_ = type_17(1u, _e1505.member);
                        } else {
                            phi_3064_ = _e1505;
                            phi_3111_ = type_17(0u, type_17().member_1);
                        }
                        let _e1529 = phi_3064_;
                        let _e1531 = phi_3111_;
                        if (bitcast<i32>(_e1531.member) != 0i) {
                            if select(select(true, false, _e1097), true, (_e1531.member_1 > 0i)) {
                                let _e1541 = local_5.member[0u];
                                let _e1547 = local_5.member_1[0u];
                                let _e1553 = local_5.member_2[0u];
                                let _e1557 = (_e1541[0] - _e1547[0]);
                                let _e1558 = (_e1541[1] - _e1547[1]);
                                let _e1559 = (_e1541[2] - _e1547[2]);
                                let _e1560 = (_e229.member == 0u);
                                let _e1572 = local_5.member[1u];
                                let _e1578 = local_5.member_1[1u];
                                let _e1584 = local_5.member_2[1u];
                                let _e1588 = (_e1572[0] - _e1578[0]);
                                let _e1589 = (_e1572[1] - _e1578[1]);
                                let _e1590 = (_e1572[2] - _e1578[2]);
                                let _e1591 = (_e229.member == 0u);
                                let _e1603 = local_5.member[0u];
                                let _e1609 = select(_e1603[0], -(_e1603[0]), (_e1603[0] < 0.0lf));
                                let _e1612 = select(_e1603[1], -(_e1603[1]), (_e1603[1] < 0.0lf));
                                let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                let _e1617 = select(_e1603[2], -(_e1603[2]), (_e1603[2] < 0.0lf));
                                let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                let _e1622 = local_5.member[1u];
                                let _e1628 = select(_e1622[0], -(_e1622[0]), (_e1622[0] < 0.0lf));
                                let _e1631 = select(_e1622[1], -(_e1622[1]), (_e1622[1] < 0.0lf));
                                let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                let _e1636 = select(_e1622[2], -(_e1622[2]), (_e1622[2] < 0.0lf));
                                let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                let _e1642 = local_5.member_3;
                                let _e1646 = local_5.member_1[0u];
                                let _e1652 = select(_e1646[0], -(_e1646[0]), (_e1646[0] < 0.0lf));
                                let _e1655 = select(_e1646[1], -(_e1646[1]), (_e1646[1] < 0.0lf));
                                let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                let _e1660 = select(_e1646[2], -(_e1646[2]), (_e1646[2] < 0.0lf));
                                let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                let _e1665 = local_5.member_1[1u];
                                let _e1671 = select(_e1665[0], -(_e1665[0]), (_e1665[0] < 0.0lf));
                                let _e1674 = select(_e1665[1], -(_e1665[1]), (_e1665[1] < 0.0lf));
                                let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                let _e1679 = select(_e1665[2], -(_e1665[2]), (_e1665[2] < 0.0lf));
                                let _e1681 = select(_e1679, _e1676, (_e1676 > _e1679));
                                let _e1685 = local_5.member_3;
                                let _e1689 = local_5.member_2[0u];
                                let _e1695 = select(_e1689[0], -(_e1689[0]), (_e1689[0] < 0.0lf));
                                let _e1698 = select(_e1689[1], -(_e1689[1]), (_e1689[1] < 0.0lf));
                                let _e1700 = select(_e1698, _e1695, (_e1695 > _e1698));
                                let _e1703 = select(_e1689[2], -(_e1689[2]), (_e1689[2] < 0.0lf));
                                let _e1705 = select(_e1703, _e1700, (_e1700 > _e1703));
                                let _e1708 = local_5.member_2[1u];
                                let _e1714 = select(_e1708[0], -(_e1708[0]), (_e1708[0] < 0.0lf));
                                let _e1717 = select(_e1708[1], -(_e1708[1]), (_e1708[1] < 0.0lf));
                                let _e1719 = select(_e1717, _e1714, (_e1714 > _e1717));
                                let _e1722 = select(_e1708[2], -(_e1708[2]), (_e1708[2] < 0.0lf));
                                let _e1724 = select(_e1722, _e1719, (_e1719 > _e1722));
                                let _e1728 = local_5.member_3;
                                let _e1736 = local_5.member_3;
                                let _e1744 = (_e532 * f64(0.00390625f));
                                let _e1745 = f64(0f);
                                let _e1746 = f64(1f);
                                local_3 = type_36(array<f64, 4>(_e1745, _e1745, _e1745, _e1745), array<f64, 4>(_e1745, _e1745, _e1745, _e1745), array<f64, 4>(_e1746, _e1746, _e1746, _e1746));
                                phi_3554_ = type_9(0u, 96u);
                                phi_3557_ = _e1511;
                                phi_3559_ = _e1511;
                                phi_3561_ = (_e550 - _e1511);
                                phi_3563_ = _e1511;
                                phi_3565_ = false;
                                phi_3567_ = 0u;
                                loop {
                                    let _e1753 = phi_3554_;
                                    let _e1755 = phi_3557_;
                                    let _e1757 = phi_3559_;
                                    let _e1759 = phi_3561_;
                                    let _e1761 = phi_3563_;
                                    let _e1763 = phi_3565_;
                                    let _e1765 = phi_3567_;
                                    local_19 = _e1755;
                                    local_23 = _e1757;
                                    let _e1768 = (_e1753.member < _e1753.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1768)) != 0i) {
                                        let _e1782 = local_5.member[0u];
                                        let _e1788 = local_5.member[1u];
                                        let _e1804 = local_5.member_1[0u];
                                        let _e1810 = local_5.member_1[1u];
                                        let _e1826 = local_5.member_2[0u];
                                        let _e1832 = local_5.member_2[1u];
                                        let _e1846 = function_3(array<f64, 3>((_e1782[0] + ((_e1788[0] - _e1782[0]) * _e1755)), (_e1782[1] + ((_e1788[1] - _e1782[1]) * _e1755)), (_e1782[2] + ((_e1788[2] - _e1782[2]) * _e1755))), array<f64, 3>((_e1804[0] + ((_e1810[0] - _e1804[0]) * _e1755)), (_e1804[1] + ((_e1810[1] - _e1804[1]) * _e1755)), (_e1804[2] + ((_e1810[2] - _e1804[2]) * _e1755))), array<f64, 3>((_e1826[0] + ((_e1832[0] - _e1826[0]) * _e1755)), (_e1826[1] + ((_e1832[1] - _e1826[1]) * _e1755)), (_e1826[2] + ((_e1832[2] - _e1826[2]) * _e1755))), _e229.member);
                                        if (_e1765 == 0u) {
                                            phi_3719_ = _e1846;
                                        } else {
                                            let _e1848 = f64(0f);
                                            phi_3719_ = array<f64, 3>(select(_e1848, _e1846[0], (_e1765 == 1u)), select(_e1848, _e1846[1], (_e1765 == 2u)), select(_e1848, _e1846[2], (_e1765 == 3u)));
                                        }
                                        let _e1860 = phi_3719_;
                                        let _e1874 = ((select(_e1860[0], -(_e1860[0]), (_e1860[0] < 0.0lf)) + select(_e1860[1], -(_e1860[1]), (_e1860[1] < 0.0lf))) + select(_e1860[2], -(_e1860[2]), (_e1860[2] < 0.0lf)));
                                        if (_e1874 > f64(0f)) {
                                            if ((bitcast<u64>(_e1874) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e1881 = (f64(1f) / _e1874);
                                                let _e1883 = (_e1860[0] * _e1881);
                                                let _e1885 = (_e1860[1] * _e1881);
                                                let _e1887 = (_e1860[2] * _e1881);
                                                let _e1892 = (((_e1883 * _e1883) + (_e1885 * _e1885)) + (_e1887 * _e1887));
                                                if (_e1892 <= 2.2250738585072014e-308lf) {
                                                    phi_3844_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1892 > 0.0lf));
                                                } else {
                                                    phi_3787_ = type_16(0i, 5i);
                                                    phi_3790_ = bitcast<f64>(((bitcast<u64>(_e1892) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e1899 = phi_3787_;
                                                        let _e1901 = phi_3790_;
                                                        local_7 = _e1901;
                                                        if (_e1899.member < _e1899.member_1) {
                                                            let _e1908 = (_e1899.member + 1i);
                                                            phi_3788_ = type_16(select(_e1908, type_17().member_1, select(false, true, ((false == (_e1908 > _e1899.member)) != false))), _e1899.member_1);
                                                            phi_3831_ = type_17(1u, _e1899.member);
                                                        } else {
                                                            phi_3788_ = _e1899;
                                                            phi_3831_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e1919 = phi_3788_;
                                                        let _e1921 = phi_3831_;
                                                        let _e1924 = (bitcast<i32>(_e1921.member) != 0i);
                                                        if _e1924 {
                                                            phi_3791_ = (0.5lf * (_e1901 + (_e1892 / _e1901)));
                                                        } else {
                                                            phi_3791_ = f64();
                                                        }
                                                        let _e1929 = phi_3791_;
                                                        continue;
                                                        continuing {
                                                            phi_3787_ = _e1919;
                                                            phi_3790_ = _e1929;
                                                            break if !(_e1924);
                                                        }
                                                    }
                                                    let _e1934 = local_7;
                                                    phi_3844_ = (_e1934 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e1940 = phi_3844_;
                                                let _e1942 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e1949 = ((((((((select(_e1638, _e1619, (_e1619 > _e1638)) + _e1642) + (select(_e1681, _e1662, (_e1662 > _e1681)) + _e1685)) + (select(_e1724, _e1705, (_e1705 > _e1724)) + _e1728)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1736 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e780.member_1 * _e1940) * (f64(1f) + _e1942)));
                                                let _e1954 = (((_e1883 * _e1541[0]) + (_e1885 * _e1541[1])) + (_e1887 * _e1541[2]));
                                                let _e1959 = (((_e1883 * _e1557) + (_e1885 * _e1558)) + (_e1887 * _e1559));
                                                let _e1964 = (((_e1883 * (_e1541[0] - _e1553[0])) + (_e1885 * (_e1541[1] - _e1553[1]))) + (_e1887 * (_e1541[2] - _e1553[2])));
                                                let _e1969 = (((_e1883 * select((_e1557 - _e1553[0]), _e1541[0], _e1560)) + (_e1885 * select((_e1558 - _e1553[1]), _e1541[1], _e1560))) + (_e1887 * select((_e1559 - _e1553[2]), _e1541[2], _e1560)));
                                                let _e1975 = (((_e1883 * _e1572[0]) + (_e1885 * _e1572[1])) + (_e1887 * _e1572[2]));
                                                let _e1980 = (((_e1883 * _e1588) + (_e1885 * _e1589)) + (_e1887 * _e1590));
                                                let _e1985 = (((_e1883 * (_e1572[0] - _e1584[0])) + (_e1885 * (_e1572[1] - _e1584[1]))) + (_e1887 * (_e1572[2] - _e1584[2])));
                                                let _e1990 = (((_e1883 * select((_e1588 - _e1584[0]), _e1572[0], _e1591)) + (_e1885 * select((_e1589 - _e1584[1]), _e1572[1], _e1591))) + (_e1887 * select((_e1590 - _e1584[2]), _e1572[2], _e1591)));
                                                phi_3970_ = type_36(array<f64, 4>(_e1954, _e1959, _e1964, _e1969), array<f64, 4>(_e1975, _e1980, _e1985, _e1990), array<f64, 4>((_e1949 + ((select(_e1954, -(_e1954), (_e1954 < 0.0lf)) + select(_e1975, -(_e1975), (_e1975 < 0.0lf))) * _e1942)), (_e1949 + ((select(_e1959, -(_e1959), (_e1959 < 0.0lf)) + select(_e1980, -(_e1980), (_e1980 < 0.0lf))) * _e1942)), (_e1949 + ((select(_e1964, -(_e1964), (_e1964 < 0.0lf)) + select(_e1985, -(_e1985), (_e1985 < 0.0lf))) * _e1942)), (_e1949 + ((select(_e1969, -(_e1969), (_e1969 < 0.0lf)) + select(_e1990, -(_e1990), (_e1990 < 0.0lf))) * _e1942))));
                                                phi_3971_ = false;
                                            } else {
                                                phi_3970_ = type_36();
                                                phi_3971_ = true;
                                            }
                                            let _e2031 = phi_3970_;
                                            let _e2033 = phi_3971_;
                                            phi_3972_ = _e2031;
                                            phi_3973_ = _e2033;
                                        } else {
                                            phi_3972_ = type_36();
                                            phi_3973_ = true;
                                        }
                                        let _e2035 = phi_3972_;
                                        let _e2037 = phi_3973_;
                                        if _e2037 {
                                            let _e2038 = f64(0f);
                                            let _e2039 = f64(1f);
                                            phi_3983_ = type_36(array<f64, 4>(_e2038, _e2038, _e2038, _e2038), array<f64, 4>(_e2038, _e2038, _e2038, _e2038), array<f64, 4>(_e2039, _e2039, _e2039, _e2039));
                                        } else {
                                            phi_3983_ = _e2035;
                                        }
                                        let _e2045 = phi_3983_;
                                        local_4 = type_36(array<f64, 4>(_e2045.member[0], _e2045.member[1], _e2045.member[2], _e2045.member[3]), array<f64, 4>(_e2045.member_1[0], _e2045.member_1[1], _e2045.member_1[2], _e2045.member_1[3]), array<f64, 4>(_e2045.member_2[0], _e2045.member_2[1], _e2045.member_2[2], _e2045.member_2[3]));
                                        let _e2065 = (_e1755 - _e1761);
                                        let _e2067 = f64(0f);
                                        let _e2070 = local_4.member[0u];
                                        let _e2073 = local_4.member_1[0u];
                                        let _e2076 = local_4.member[0u];
                                        let _e2082 = local_4.member_2[0u];
                                        if (((_e2070 + ((_e2073 - _e2076) * _e1755)) - _e2082) > _e2067) {
                                            let _e2087 = local_4.member[1u];
                                            let _e2090 = local_4.member_1[1u];
                                            let _e2093 = local_4.member[1u];
                                            let _e2099 = local_4.member_2[1u];
                                            if (((_e2087 + ((_e2090 - _e2093) * _e1755)) - _e2099) > _e2067) {
                                                let _e2104 = local_4.member[2u];
                                                let _e2107 = local_4.member_1[2u];
                                                let _e2110 = local_4.member[2u];
                                                let _e2116 = local_4.member_2[2u];
                                                if (((_e2104 + ((_e2107 - _e2110) * _e1755)) - _e2116) > _e2067) {
                                                    let _e2121 = local_4.member[3u];
                                                    let _e2124 = local_4.member_1[3u];
                                                    let _e2127 = local_4.member[3u];
                                                    let _e2133 = local_4.member_2[3u];
                                                    phi_4155_ = (((_e2121 + ((_e2124 - _e2127) * _e1755)) - _e2133) > _e2067);
                                                    phi_4156_ = false;
                                                } else {
                                                    phi_4155_ = bool();
                                                    phi_4156_ = true;
                                                }
                                                let _e2137 = phi_4155_;
                                                let _e2139 = phi_4156_;
                                                phi_4157_ = _e2137;
                                                phi_4158_ = _e2139;
                                            } else {
                                                phi_4157_ = bool();
                                                phi_4158_ = true;
                                            }
                                            let _e2141 = phi_4157_;
                                            let _e2143 = phi_4158_;
                                            phi_4159_ = _e2141;
                                            phi_4160_ = _e2143;
                                        } else {
                                            phi_4159_ = bool();
                                            phi_4160_ = true;
                                        }
                                        let _e2145 = phi_4159_;
                                        let _e2147 = phi_4160_;
                                        if select(_e2145, false, _e2147) {
                                            if (_e1755 <= _e1757) {
                                                phi_4475_ = true;
                                            } else {
                                                let _e2150 = f64(0f);
                                                let _e2153 = local_3.member[0u];
                                                let _e2156 = local_3.member_1[0u];
                                                let _e2159 = local_3.member[0u];
                                                let _e2165 = local_3.member_2[0u];
                                                let _e2169 = local_4.member[0u];
                                                let _e2172 = local_4.member_1[0u];
                                                let _e2175 = local_4.member[0u];
                                                let _e2181 = local_4.member_2[0u];
                                                if ((((_e2153 + ((_e2156 - _e2159) * _e1755)) - _e2165) + ((_e2169 + ((_e2172 - _e2175) * _e1761)) - _e2181)) > _e2150) {
                                                    let _e2187 = local_3.member[1u];
                                                    let _e2190 = local_3.member_1[1u];
                                                    let _e2193 = local_3.member[1u];
                                                    let _e2199 = local_3.member_2[1u];
                                                    let _e2203 = local_4.member[1u];
                                                    let _e2206 = local_4.member_1[1u];
                                                    let _e2209 = local_4.member[1u];
                                                    let _e2215 = local_4.member_2[1u];
                                                    if ((((_e2187 + ((_e2190 - _e2193) * _e1755)) - _e2199) + ((_e2203 + ((_e2206 - _e2209) * _e1761)) - _e2215)) > _e2150) {
                                                        let _e2221 = local_3.member[2u];
                                                        let _e2224 = local_3.member_1[2u];
                                                        let _e2227 = local_3.member[2u];
                                                        let _e2233 = local_3.member_2[2u];
                                                        let _e2237 = local_4.member[2u];
                                                        let _e2240 = local_4.member_1[2u];
                                                        let _e2243 = local_4.member[2u];
                                                        let _e2249 = local_4.member_2[2u];
                                                        if ((((_e2221 + ((_e2224 - _e2227) * _e1755)) - _e2233) + ((_e2237 + ((_e2240 - _e2243) * _e1761)) - _e2249)) > _e2150) {
                                                            let _e2255 = local_3.member[3u];
                                                            let _e2258 = local_3.member_1[3u];
                                                            let _e2261 = local_3.member[3u];
                                                            let _e2267 = local_3.member_2[3u];
                                                            let _e2271 = local_4.member[3u];
                                                            let _e2274 = local_4.member_1[3u];
                                                            let _e2277 = local_4.member[3u];
                                                            let _e2283 = local_4.member_2[3u];
                                                            phi_4462_ = ((((_e2255 + ((_e2258 - _e2261) * _e1755)) - _e2267) + ((_e2271 + ((_e2274 - _e2277) * _e1761)) - _e2283)) > _e2150);
                                                            phi_4463_ = false;
                                                        } else {
                                                            phi_4462_ = bool();
                                                            phi_4463_ = true;
                                                        }
                                                        let _e2288 = phi_4462_;
                                                        let _e2290 = phi_4463_;
                                                        phi_4464_ = _e2288;
                                                        phi_4465_ = _e2290;
                                                    } else {
                                                        phi_4464_ = bool();
                                                        phi_4465_ = true;
                                                    }
                                                    let _e2292 = phi_4464_;
                                                    let _e2294 = phi_4465_;
                                                    phi_4466_ = _e2292;
                                                    phi_4467_ = _e2294;
                                                } else {
                                                    phi_4466_ = bool();
                                                    phi_4467_ = true;
                                                }
                                                let _e2296 = phi_4466_;
                                                let _e2298 = phi_4467_;
                                                phi_4475_ = select(_e2296, false, _e2298);
                                            }
                                            let _e2301 = phi_4475_;
                                            if _e2301 {
                                                if select(true, select(true, false, (_e1755 >= _e550)), _e1763) {
                                                    local_3 = type_36(array<f64, 4>(_e2045.member[0], _e2045.member[1], _e2045.member[2], _e2045.member[3]), array<f64, 4>(_e2045.member_1[0], _e2045.member_1[1], _e2045.member_1[2], _e2045.member_1[3]), array<f64, 4>(_e2045.member_2[0], _e2045.member_2[1], _e2045.member_2[2], _e2045.member_2[3]));
                                                    let _e2326 = local_3.member[0u];
                                                    let _e2329 = local_3.member_1[0u];
                                                    let _e2332 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2329 > _e2332)), (_e2326 > _e2332)) {
                                                        let _e2337 = (_e2329 >= _e2326);
                                                        if _e2337 {
                                                            phi_4587_ = f64();
                                                            phi_4588_ = false;
                                                        } else {
                                                            if ((_e2326 - _e2329) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4585_ = (((_e2326 - _e2332) / (_e2326 - _e2329)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4586_ = false;
                                                            } else {
                                                                phi_4585_ = f64();
                                                                phi_4586_ = true;
                                                            }
                                                            let _e2351 = phi_4585_;
                                                            let _e2353 = phi_4586_;
                                                            phi_4587_ = _e2351;
                                                            phi_4588_ = _e2353;
                                                        }
                                                        let _e2355 = phi_4587_;
                                                        let _e2357 = phi_4588_;
                                                        phi_4589_ = _e2355;
                                                        phi_4590_ = _e2337;
                                                        phi_4591_ = _e2357;
                                                    } else {
                                                        phi_4589_ = f64();
                                                        phi_4590_ = true;
                                                        phi_4591_ = false;
                                                    }
                                                    let _e2359 = phi_4589_;
                                                    let _e2361 = phi_4590_;
                                                    let _e2363 = phi_4591_;
                                                    let _e2367 = select(_e2359, select(_e1755, f64(2f), _e2361), select(_e2363, true, _e2361));
                                                    let _e2370 = local_3.member[1u];
                                                    let _e2373 = local_3.member_1[1u];
                                                    let _e2376 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2373 > _e2376)), (_e2370 > _e2376)) {
                                                        let _e2381 = (_e2373 >= _e2370);
                                                        if _e2381 {
                                                            phi_4659_ = f64();
                                                            phi_4660_ = false;
                                                        } else {
                                                            if ((_e2370 - _e2373) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4657_ = (((_e2370 - _e2376) / (_e2370 - _e2373)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4658_ = false;
                                                            } else {
                                                                phi_4657_ = f64();
                                                                phi_4658_ = true;
                                                            }
                                                            let _e2395 = phi_4657_;
                                                            let _e2397 = phi_4658_;
                                                            phi_4659_ = _e2395;
                                                            phi_4660_ = _e2397;
                                                        }
                                                        let _e2399 = phi_4659_;
                                                        let _e2401 = phi_4660_;
                                                        phi_4661_ = _e2399;
                                                        phi_4662_ = _e2381;
                                                        phi_4663_ = _e2401;
                                                    } else {
                                                        phi_4661_ = f64();
                                                        phi_4662_ = true;
                                                        phi_4663_ = false;
                                                    }
                                                    let _e2403 = phi_4661_;
                                                    let _e2405 = phi_4662_;
                                                    let _e2407 = phi_4663_;
                                                    let _e2411 = select(_e2403, select(_e1755, f64(2f), _e2405), select(_e2407, true, _e2405));
                                                    let _e2413 = select(_e2411, _e2367, (_e2367 < _e2411));
                                                    let _e2416 = local_3.member[2u];
                                                    let _e2419 = local_3.member_1[2u];
                                                    let _e2422 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2419 > _e2422)), (_e2416 > _e2422)) {
                                                        let _e2427 = (_e2419 >= _e2416);
                                                        if _e2427 {
                                                            phi_4736_ = f64();
                                                            phi_4737_ = false;
                                                        } else {
                                                            if ((_e2416 - _e2419) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4734_ = (((_e2416 - _e2422) / (_e2416 - _e2419)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4735_ = false;
                                                            } else {
                                                                phi_4734_ = f64();
                                                                phi_4735_ = true;
                                                            }
                                                            let _e2441 = phi_4734_;
                                                            let _e2443 = phi_4735_;
                                                            phi_4736_ = _e2441;
                                                            phi_4737_ = _e2443;
                                                        }
                                                        let _e2445 = phi_4736_;
                                                        let _e2447 = phi_4737_;
                                                        phi_4738_ = _e2445;
                                                        phi_4739_ = _e2427;
                                                        phi_4740_ = _e2447;
                                                    } else {
                                                        phi_4738_ = f64();
                                                        phi_4739_ = true;
                                                        phi_4740_ = false;
                                                    }
                                                    let _e2449 = phi_4738_;
                                                    let _e2451 = phi_4739_;
                                                    let _e2453 = phi_4740_;
                                                    let _e2457 = select(_e2449, select(_e1755, f64(2f), _e2451), select(_e2453, true, _e2451));
                                                    let _e2460 = local_3.member[3u];
                                                    let _e2463 = local_3.member_1[3u];
                                                    let _e2466 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2463 > _e2466)), (_e2460 > _e2466)) {
                                                        let _e2471 = (_e2463 >= _e2460);
                                                        if _e2471 {
                                                            phi_4808_ = f64();
                                                            phi_4809_ = false;
                                                        } else {
                                                            if ((_e2460 - _e2463) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4806_ = (((_e2460 - _e2466) / (_e2460 - _e2463)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4807_ = false;
                                                            } else {
                                                                phi_4806_ = f64();
                                                                phi_4807_ = true;
                                                            }
                                                            let _e2485 = phi_4806_;
                                                            let _e2487 = phi_4807_;
                                                            phi_4808_ = _e2485;
                                                            phi_4809_ = _e2487;
                                                        }
                                                        let _e2489 = phi_4808_;
                                                        let _e2491 = phi_4809_;
                                                        phi_4810_ = _e2489;
                                                        phi_4811_ = _e2471;
                                                        phi_4812_ = _e2491;
                                                    } else {
                                                        phi_4810_ = f64();
                                                        phi_4811_ = true;
                                                        phi_4812_ = false;
                                                    }
                                                    let _e2493 = phi_4810_;
                                                    let _e2495 = phi_4811_;
                                                    let _e2497 = phi_4812_;
                                                    let _e2501 = select(_e2493, select(_e1755, f64(2f), _e2495), select(_e2497, true, _e2495));
                                                    let _e2503 = select(_e2501, _e2457, (_e2457 < _e2501));
                                                    let _e2505 = select(_e2503, _e2413, (_e2413 < _e2503));
                                                    let _e2507 = select(_e1755, _e2505, (_e2505 > _e1755));
                                                    let _e2508 = (_e2507 > _e550);
                                                    if _e2508 {
                                                        phi_5354_ = f64();
                                                        phi_5355_ = f64();
                                                        phi_5356_ = false;
                                                        phi_5357_ = false;
                                                    } else {
                                                        let _e2509 = (_e2507 - _e1755);
                                                        let _e2510 = (_e2509 <= _e1744);
                                                        let _e2513 = (_e2507 + (_e532 * f64(0.01f)));
                                                        let _e2515 = select(_e550, _e2513, (_e2513 < _e550));
                                                        if _e2510 {
                                                            if (_e780.member_1 > f64(0f)) {
                                                                let _e2520 = local_5.member[0u];
                                                                let _e2526 = local_5.member[1u];
                                                                let _e2542 = local_5.member_1[0u];
                                                                let _e2548 = local_5.member_1[1u];
                                                                let _e2564 = local_5.member_2[0u];
                                                                let _e2570 = local_5.member_2[1u];
                                                                let _e2584 = function_3(array<f64, 3>((_e2520[0] + ((_e2526[0] - _e2520[0]) * _e2515)), (_e2520[1] + ((_e2526[1] - _e2520[1]) * _e2515)), (_e2520[2] + ((_e2526[2] - _e2520[2]) * _e2515))), array<f64, 3>((_e2542[0] + ((_e2548[0] - _e2542[0]) * _e2515)), (_e2542[1] + ((_e2548[1] - _e2542[1]) * _e2515)), (_e2542[2] + ((_e2548[2] - _e2542[2]) * _e2515))), array<f64, 3>((_e2564[0] + ((_e2570[0] - _e2564[0]) * _e2515)), (_e2564[1] + ((_e2570[1] - _e2564[1]) * _e2515)), (_e2564[2] + ((_e2570[2] - _e2564[2]) * _e2515))), _e229.member);
                                                                let _e2595 = (((_e2584[0] * _e2584[0]) + (_e2584[1] * _e2584[1])) + (_e2584[2] * _e2584[2]));
                                                                if (_e2595 <= 2.2250738585072014e-308lf) {
                                                                    phi_5046_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2595 > 0.0lf));
                                                                } else {
                                                                    phi_4989_ = type_16(0i, 5i);
                                                                    phi_4992_ = bitcast<f64>(((bitcast<u64>(_e2595) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2602 = phi_4989_;
                                                                        let _e2604 = phi_4992_;
                                                                        local_8 = _e2604;
                                                                        if (_e2602.member < _e2602.member_1) {
                                                                            let _e2611 = (_e2602.member + 1i);
                                                                            phi_4990_ = type_16(select(_e2611, type_17().member_1, select(false, true, ((false == (_e2611 > _e2602.member)) != false))), _e2602.member_1);
                                                                            phi_5033_ = type_17(1u, _e2602.member);
                                                                        } else {
                                                                            phi_4990_ = _e2602;
                                                                            phi_5033_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e2622 = phi_4990_;
                                                                        let _e2624 = phi_5033_;
                                                                        let _e2627 = (bitcast<i32>(_e2624.member) != 0i);
                                                                        if _e2627 {
                                                                            phi_4993_ = (0.5lf * (_e2604 + (_e2595 / _e2604)));
                                                                        } else {
                                                                            phi_4993_ = f64();
                                                                        }
                                                                        let _e2632 = phi_4993_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4989_ = _e2622;
                                                                            phi_4992_ = _e2632;
                                                                            break if !(_e2627);
                                                                        }
                                                                    }
                                                                    let _e2637 = local_8;
                                                                    phi_5046_ = (_e2637 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2643 = phi_5046_;
                                                                let _e2651 = local_5.member[0u];
                                                                let _e2657 = select(_e2651[0], -(_e2651[0]), (_e2651[0] < 0.0lf));
                                                                let _e2660 = select(_e2651[1], -(_e2651[1]), (_e2651[1] < 0.0lf));
                                                                let _e2662 = select(_e2660, _e2657, (_e2657 > _e2660));
                                                                let _e2665 = select(_e2651[2], -(_e2651[2]), (_e2651[2] < 0.0lf));
                                                                let _e2667 = select(_e2665, _e2662, (_e2662 > _e2665));
                                                                let _e2670 = local_5.member[1u];
                                                                let _e2676 = select(_e2670[0], -(_e2670[0]), (_e2670[0] < 0.0lf));
                                                                let _e2679 = select(_e2670[1], -(_e2670[1]), (_e2670[1] < 0.0lf));
                                                                let _e2681 = select(_e2679, _e2676, (_e2676 > _e2679));
                                                                let _e2684 = select(_e2670[2], -(_e2670[2]), (_e2670[2] < 0.0lf));
                                                                let _e2686 = select(_e2684, _e2681, (_e2681 > _e2684));
                                                                let _e2690 = local_5.member_3;
                                                                let _e2694 = local_5.member_1[0u];
                                                                let _e2700 = select(_e2694[0], -(_e2694[0]), (_e2694[0] < 0.0lf));
                                                                let _e2703 = select(_e2694[1], -(_e2694[1]), (_e2694[1] < 0.0lf));
                                                                let _e2705 = select(_e2703, _e2700, (_e2700 > _e2703));
                                                                let _e2708 = select(_e2694[2], -(_e2694[2]), (_e2694[2] < 0.0lf));
                                                                let _e2710 = select(_e2708, _e2705, (_e2705 > _e2708));
                                                                let _e2713 = local_5.member_1[1u];
                                                                let _e2719 = select(_e2713[0], -(_e2713[0]), (_e2713[0] < 0.0lf));
                                                                let _e2722 = select(_e2713[1], -(_e2713[1]), (_e2713[1] < 0.0lf));
                                                                let _e2724 = select(_e2722, _e2719, (_e2719 > _e2722));
                                                                let _e2727 = select(_e2713[2], -(_e2713[2]), (_e2713[2] < 0.0lf));
                                                                let _e2729 = select(_e2727, _e2724, (_e2724 > _e2727));
                                                                let _e2733 = local_5.member_3;
                                                                let _e2737 = local_5.member_2[0u];
                                                                let _e2743 = select(_e2737[0], -(_e2737[0]), (_e2737[0] < 0.0lf));
                                                                let _e2746 = select(_e2737[1], -(_e2737[1]), (_e2737[1] < 0.0lf));
                                                                let _e2748 = select(_e2746, _e2743, (_e2743 > _e2746));
                                                                let _e2751 = select(_e2737[2], -(_e2737[2]), (_e2737[2] < 0.0lf));
                                                                let _e2753 = select(_e2751, _e2748, (_e2748 > _e2751));
                                                                let _e2756 = local_5.member_2[1u];
                                                                let _e2762 = select(_e2756[0], -(_e2756[0]), (_e2756[0] < 0.0lf));
                                                                let _e2765 = select(_e2756[1], -(_e2756[1]), (_e2756[1] < 0.0lf));
                                                                let _e2767 = select(_e2765, _e2762, (_e2762 > _e2765));
                                                                let _e2770 = select(_e2756[2], -(_e2756[2]), (_e2756[2] < 0.0lf));
                                                                let _e2772 = select(_e2770, _e2767, (_e2767 > _e2770));
                                                                let _e2776 = local_5.member_3;
                                                                let _e2784 = local_5.member_3;
                                                                phi_5323_ = select(true, false, (((_e2643 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2686, _e2667, (_e2667 > _e2686)) + _e2690) + (select(_e2729, _e2710, (_e2710 > _e2729)) + _e2733)) + (select(_e2772, _e2753, (_e2753 > _e2772)) + _e2776)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2784 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e780.member_1));
                                                            } else {
                                                                phi_5323_ = true;
                                                            }
                                                            let _e2797 = phi_5323_;
                                                            phi_5324_ = _e2797;
                                                        } else {
                                                            phi_5324_ = true;
                                                        }
                                                        let _e2799 = phi_5324_;
                                                        if _e2799 {
                                                            if _e1763 {
                                                                let _e2803 = (_e2509 <= (_e1759 * f64(0.25f)));
                                                                phi_5351_ = select(select(select(f64(), f64(0f), _e2803), f64(), _e2510), (_e2065 + _e2065), select(select(true, false, _e2803), true, _e2510));
                                                            } else {
                                                                phi_5351_ = (_e550 - _e1755);
                                                            }
                                                            let _e2812 = phi_5351_;
                                                            phi_5352_ = _e2812;
                                                            phi_5353_ = false;
                                                        } else {
                                                            phi_5352_ = f64();
                                                            phi_5353_ = true;
                                                        }
                                                        let _e2814 = phi_5352_;
                                                        let _e2816 = phi_5353_;
                                                        phi_5354_ = _e2814;
                                                        phi_5355_ = _e2509;
                                                        phi_5356_ = _e2799;
                                                        phi_5357_ = _e2816;
                                                    }
                                                    let _e2818 = phi_5354_;
                                                    let _e2820 = phi_5355_;
                                                    let _e2822 = phi_5356_;
                                                    let _e2824 = phi_5357_;
                                                    phi_5358_ = _e2507;
                                                    phi_5359_ = _e2818;
                                                    phi_5360_ = _e2820;
                                                    phi_5361_ = _e2507;
                                                    phi_5362_ = _e2822;
                                                    phi_5363_ = _e2508;
                                                    phi_5364_ = _e2824;
                                                    phi_5365_ = false;
                                                } else {
                                                    phi_5358_ = f64();
                                                    phi_5359_ = f64();
                                                    phi_5360_ = f64();
                                                    phi_5361_ = f64();
                                                    phi_5362_ = false;
                                                    phi_5363_ = false;
                                                    phi_5364_ = false;
                                                    phi_5365_ = true;
                                                }
                                                let _e2826 = phi_5358_;
                                                let _e2828 = phi_5359_;
                                                let _e2830 = phi_5360_;
                                                let _e2832 = phi_5361_;
                                                let _e2834 = phi_5362_;
                                                let _e2836 = phi_5363_;
                                                let _e2838 = phi_5364_;
                                                let _e2840 = phi_5365_;
                                                phi_5366_ = _e2826;
                                                phi_5367_ = _e2828;
                                                phi_5368_ = _e2830;
                                                phi_5369_ = _e2832;
                                                phi_5370_ = false;
                                                phi_5371_ = _e2834;
                                                phi_5372_ = _e2836;
                                                phi_5373_ = _e2838;
                                                phi_5374_ = _e2840;
                                            } else {
                                                phi_5366_ = f64();
                                                phi_5367_ = f64();
                                                phi_5368_ = f64();
                                                phi_5369_ = f64();
                                                phi_5370_ = true;
                                                phi_5371_ = false;
                                                phi_5372_ = false;
                                                phi_5373_ = false;
                                                phi_5374_ = false;
                                            }
                                            let _e2842 = phi_5366_;
                                            let _e2844 = phi_5367_;
                                            let _e2846 = phi_5368_;
                                            let _e2848 = phi_5369_;
                                            let _e2850 = phi_5370_;
                                            let _e2852 = phi_5371_;
                                            let _e2854 = phi_5372_;
                                            let _e2856 = phi_5373_;
                                            let _e2858 = phi_5374_;
                                            phi_5375_ = _e2842;
                                            phi_5376_ = _e2844;
                                            phi_5377_ = _e2846;
                                            phi_5378_ = _e2848;
                                            phi_5379_ = _e2850;
                                            phi_5380_ = _e2852;
                                            phi_5381_ = _e2854;
                                            phi_5382_ = _e2856;
                                            phi_5383_ = _e2858;
                                        } else {
                                            phi_5375_ = f64();
                                            phi_5376_ = f64();
                                            phi_5377_ = f64();
                                            phi_5378_ = f64();
                                            phi_5379_ = true;
                                            phi_5380_ = false;
                                            phi_5381_ = false;
                                            phi_5382_ = false;
                                            phi_5383_ = false;
                                        }
                                        let _e2860 = phi_5375_;
                                        let _e2862 = phi_5376_;
                                        let _e2864 = phi_5377_;
                                        let _e2866 = phi_5378_;
                                        let _e2868 = phi_5379_;
                                        let _e2870 = phi_5380_;
                                        let _e2872 = phi_5381_;
                                        let _e2874 = phi_5382_;
                                        let _e2876 = phi_5383_;
                                        if _e2868 {
                                            if (_e1755 <= _e1757) {
                                                let _e3034 = (_e1765 + 1u);
                                                let _e3035 = (_e3034 > 3u);
                                                phi_5723_ = _e3034;
                                                phi_5724_ = f64();
                                                phi_5725_ = false;
                                                phi_5726_ = select(true, false, _e3035);
                                                phi_5727_ = _e3035;
                                            } else {
                                                let _e2880 = local_3.member[0u];
                                                let _e2883 = local_3.member_1[0u];
                                                let _e2886 = local_3.member[0u];
                                                let _e2892 = local_3.member_2[0u];
                                                let _e2893 = ((_e2880 + ((_e2883 - _e2886) * _e1761)) - _e2892);
                                                let _e2896 = local_3.member[1u];
                                                let _e2899 = local_3.member_1[1u];
                                                let _e2902 = local_3.member[1u];
                                                let _e2908 = local_3.member_2[1u];
                                                let _e2909 = ((_e2896 + ((_e2899 - _e2902) * _e1761)) - _e2908);
                                                let _e2911 = select(_e2909, _e2893, (_e2893 < _e2909));
                                                let _e2914 = local_3.member[2u];
                                                let _e2917 = local_3.member_1[2u];
                                                let _e2920 = local_3.member[2u];
                                                let _e2926 = local_3.member_2[2u];
                                                let _e2927 = ((_e2914 + ((_e2917 - _e2920) * _e1761)) - _e2926);
                                                let _e2930 = local_3.member[3u];
                                                let _e2933 = local_3.member_1[3u];
                                                let _e2936 = local_3.member[3u];
                                                let _e2942 = local_3.member_2[3u];
                                                let _e2943 = ((_e2930 + ((_e2933 - _e2936) * _e1761)) - _e2942);
                                                let _e2945 = select(_e2943, _e2927, (_e2927 < _e2943));
                                                let _e2947 = select(_e2945, _e2911, (_e2911 < _e2945));
                                                let _e2950 = local_4.member[0u];
                                                let _e2953 = local_4.member_1[0u];
                                                let _e2956 = local_4.member[0u];
                                                let _e2962 = local_4.member_2[0u];
                                                let _e2963 = ((_e2950 + ((_e2953 - _e2956) * _e1755)) - _e2962);
                                                let _e2966 = local_4.member[1u];
                                                let _e2969 = local_4.member_1[1u];
                                                let _e2972 = local_4.member[1u];
                                                let _e2978 = local_4.member_2[1u];
                                                let _e2979 = ((_e2966 + ((_e2969 - _e2972) * _e1755)) - _e2978);
                                                let _e2981 = select(_e2979, _e2963, (_e2963 < _e2979));
                                                let _e2984 = local_4.member[2u];
                                                let _e2987 = local_4.member_1[2u];
                                                let _e2990 = local_4.member[2u];
                                                let _e2996 = local_4.member_2[2u];
                                                let _e2997 = ((_e2984 + ((_e2987 - _e2990) * _e1755)) - _e2996);
                                                let _e3000 = local_4.member[3u];
                                                let _e3003 = local_4.member_1[3u];
                                                let _e3006 = local_4.member[3u];
                                                let _e3012 = local_4.member_2[3u];
                                                let _e3013 = ((_e3000 + ((_e3003 - _e3006) * _e1755)) - _e3012);
                                                let _e3015 = select(_e3013, _e2997, (_e2997 < _e3013));
                                                let _e3017 = select(_e3015, _e2981, (_e2981 < _e3015));
                                                let _e3018 = f64(0.0625f);
                                                let _e3020 = f64(0.9f);
                                                if (_e3017 > f64(0f)) {
                                                    phi_5721_ = f64(0.5f);
                                                } else {
                                                    let _e3026 = (f64(0.95f) * (_e2947 / (_e2947 - _e3017)));
                                                    phi_5721_ = select(_e3018, select(_e3020, _e3026, (_e3026 < _e3020)), (_e3026 > _e3018));
                                                }
                                                let _e3032 = phi_5721_;
                                                phi_5723_ = u32();
                                                phi_5724_ = (_e2065 * _e3032);
                                                phi_5725_ = true;
                                                phi_5726_ = false;
                                                phi_5727_ = false;
                                            }
                                            let _e3038 = phi_5723_;
                                            let _e3040 = phi_5724_;
                                            let _e3042 = phi_5725_;
                                            let _e3044 = phi_5726_;
                                            let _e3046 = phi_5727_;
                                            phi_5728_ = _e3038;
                                            phi_5729_ = _e1757;
                                            phi_5730_ = _e3040;
                                            phi_5731_ = _e1759;
                                            phi_5732_ = _e1761;
                                            phi_5733_ = _e1763;
                                            phi_5734_ = _e1765;
                                            phi_5735_ = _e3042;
                                            phi_5736_ = _e3044;
                                            phi_5737_ = _e3046;
                                            phi_5738_ = false;
                                            phi_5739_ = false;
                                            phi_5740_ = false;
                                        } else {
                                            phi_5728_ = u32();
                                            phi_5729_ = _e2860;
                                            phi_5730_ = _e2862;
                                            phi_5731_ = _e2864;
                                            phi_5732_ = _e1755;
                                            phi_5733_ = true;
                                            phi_5734_ = 0u;
                                            phi_5735_ = _e2870;
                                            phi_5736_ = false;
                                            phi_5737_ = false;
                                            phi_5738_ = _e2872;
                                            phi_5739_ = _e2874;
                                            phi_5740_ = _e2876;
                                        }
                                        let _e3048 = phi_5728_;
                                        let _e3050 = phi_5729_;
                                        let _e3052 = phi_5730_;
                                        let _e3054 = phi_5731_;
                                        let _e3056 = phi_5732_;
                                        let _e3058 = phi_5733_;
                                        let _e3060 = phi_5734_;
                                        let _e3062 = phi_5735_;
                                        let _e3064 = phi_5736_;
                                        let _e3066 = phi_5737_;
                                        let _e3068 = phi_5738_;
                                        let _e3070 = phi_5739_;
                                        let _e3072 = phi_5740_;
                                        if _e3062 {
                                            let _e3073 = (_e3056 + _e3052);
                                            let _e3075 = select(_e3050, _e3073, (_e3073 > _e3050));
                                            let _e3077 = select(_e550, _e3075, (_e3075 < _e550));
                                            let _e3080 = select(((_e3077 - _e3056) > _e1744), true, !(_e1763));
                                            phi_5768_ = _e3077;
                                            phi_5769_ = _e3050;
                                            phi_5770_ = _e3054;
                                            phi_5771_ = _e3056;
                                            phi_5772_ = _e3058;
                                            phi_5773_ = _e3060;
                                            phi_5774_ = _e3080;
                                            phi_5775_ = select(true, false, _e3080);
                                            phi_5776_ = false;
                                            phi_5777_ = false;
                                            phi_5778_ = false;
                                            phi_5779_ = false;
                                        } else {
                                            phi_5768_ = _e1755;
                                            phi_5769_ = _e1757;
                                            phi_5770_ = _e1759;
                                            phi_5771_ = _e1761;
                                            phi_5772_ = _e1763;
                                            phi_5773_ = _e3048;
                                            phi_5774_ = _e3064;
                                            phi_5775_ = false;
                                            phi_5776_ = _e3066;
                                            phi_5777_ = _e3068;
                                            phi_5778_ = _e3070;
                                            phi_5779_ = _e3072;
                                        }
                                        let _e3083 = phi_5768_;
                                        let _e3085 = phi_5769_;
                                        let _e3087 = phi_5770_;
                                        let _e3089 = phi_5771_;
                                        let _e3091 = phi_5772_;
                                        let _e3093 = phi_5773_;
                                        let _e3095 = phi_5774_;
                                        let _e3097 = phi_5775_;
                                        let _e3099 = phi_5776_;
                                        let _e3101 = phi_5777_;
                                        let _e3103 = phi_5778_;
                                        let _e3105 = phi_5779_;
                                        phi_3558_ = _e3083;
                                        phi_3560_ = _e3085;
                                        phi_3562_ = _e3087;
                                        phi_3564_ = _e3089;
                                        phi_3566_ = _e3091;
                                        phi_3568_ = _e3093;
                                        phi_5780_ = _e3050;
                                        phi_5781_ = _e2866;
                                        phi_5782_ = _e3095;
                                        phi_5783_ = _e3097;
                                        phi_5784_ = _e3099;
                                        phi_5785_ = _e3101;
                                        phi_5786_ = _e3103;
                                        phi_5787_ = false;
                                        phi_5788_ = _e3105;
                                    } else {
                                        phi_3558_ = f64();
                                        phi_3560_ = f64();
                                        phi_3562_ = f64();
                                        phi_3564_ = f64();
                                        phi_3566_ = bool();
                                        phi_3568_ = u32();
                                        phi_5780_ = f64();
                                        phi_5781_ = f64();
                                        phi_5782_ = false;
                                        phi_5783_ = false;
                                        phi_5784_ = false;
                                        phi_5785_ = false;
                                        phi_5786_ = false;
                                        phi_5787_ = true;
                                        phi_5788_ = false;
                                    }
                                    let _e3107 = phi_3558_;
                                    let _e3109 = phi_3560_;
                                    let _e3111 = phi_3562_;
                                    let _e3113 = phi_3564_;
                                    let _e3115 = phi_3566_;
                                    let _e3117 = phi_3568_;
                                    let _e3119 = phi_5780_;
                                    let _e3121 = phi_5781_;
                                    let _e3123 = phi_5782_;
                                    let _e3125 = phi_5783_;
                                    let _e3127 = phi_5784_;
                                    let _e3129 = phi_5785_;
                                    let _e3131 = phi_5786_;
                                    let _e3133 = phi_5787_;
                                    let _e3135 = phi_5788_;
                                    local_9 = _e3125;
                                    local_10 = _e3127;
                                    local_11 = _e3125;
                                    local_12 = _e3129;
                                    local_13 = _e3125;
                                    local_14 = _e3131;
                                    local_15 = _e3125;
                                    local_16 = _e3133;
                                    local_17 = _e3125;
                                    local_18 = _e3135;
                                    local_20 = _e3125;
                                    local_21 = _e3121;
                                    local_22 = _e3119;
                                    continue;
                                    continuing {
                                        phi_3554_ = type_9(select(_e1753.member, (_e1753.member + 1u), _e1768), select(_e1753.member_1, _e1753.member_1, _e1768));
                                        phi_3557_ = _e3107;
                                        phi_3559_ = _e3109;
                                        phi_3561_ = _e3111;
                                        phi_3563_ = _e3113;
                                        phi_3565_ = _e3115;
                                        phi_3567_ = _e3117;
                                        break if !(_e3123);
                                    }
                                }
                                let _e3138 = local_9;
                                let _e3140 = local_10;
                                let _e3141 = select(_e3140, false, _e3138);
                                let _e3143 = local_11;
                                let _e3145 = local_12;
                                let _e3148 = local_13;
                                let _e3150 = local_14;
                                let _e3153 = local_15;
                                let _e3155 = local_16;
                                let _e3158 = local_17;
                                let _e3160 = local_18;
                                let _e3166 = local_19;
                                let _e3168 = select(select(_e3145, false, _e3143), false, _e3141);
                                let _e3171 = local_20;
                                let _e3178 = select(select(select(_e3150, false, _e3148), false, _e3141), false, _e3168);
                                let _e3184 = local_21;
                                let _e3186 = local_22;
                                let _e3188 = select(select(select(_e3171, false, _e3141), false, _e3168), true, _e3178);
                                let _e3193 = local_23;
                                let _e3195 = select(select(select(select(select(_e3155, false, _e3153), false, _e3141), false, _e3168), false, _e3178), true, _e3188);
                                let _e3202 = select(select(select(select(select(select(_e3160, false, _e3158), false, _e3141), false, _e3168), false, _e3178), false, _e3188), false, _e3195);
                                let _e3207 = select(select(select(select(select(_e3141, true, _e3168), false, _e3178), false, _e3188), false, _e3195), true, _e3202);
                                phi_5855_ = select(select(type_38().member_1, select(_e3193, select(_e3186, _e3184, _e3178), _e3188), _e3195), select(select(select(type_38().member_1, _e3166, _e3141), type_38().member_1, _e3168), type_38().member_1, _e3202), _e3207);
                                phi_5856_ = (select(select(type_38().member, 1u, _e3195), select(select(select(type_38().member, 1u, _e3141), 0u, _e3168), 0u, _e3202), _e3207) != 0u);
                            } else {
                                phi_5855_ = _e1507;
                                phi_5856_ = true;
                            }
                            let _e3212 = phi_5855_;
                            let _e3214 = phi_5856_;
                            if _e3214 {
                                let _e3215 = (_e3212 > _e541);
                                if _e3215 {
                                    phi_8063_ = f64();
                                    phi_8064_ = u32();
                                    phi_8065_ = f64();
                                    phi_8066_ = type_42();
                                    phi_8067_ = u32();
                                    phi_8068_ = u32();
                                    phi_8069_ = false;
                                    phi_8070_ = false;
                                    phi_8071_ = false;
                                } else {
                                    let _e3219 = local_5.member[0u];
                                    let _e3225 = local_5.member[1u];
                                    let _e3241 = local_5.member_1[0u];
                                    let _e3247 = local_5.member_1[1u];
                                    let _e3263 = local_5.member_2[0u];
                                    let _e3269 = local_5.member_2[1u];
                                    let _e3283 = function_3(array<f64, 3>((_e3219[0] + ((_e3225[0] - _e3219[0]) * _e1511)), (_e3219[1] + ((_e3225[1] - _e3219[1]) * _e1511)), (_e3219[2] + ((_e3225[2] - _e3219[2]) * _e1511))), array<f64, 3>((_e3241[0] + ((_e3247[0] - _e3241[0]) * _e1511)), (_e3241[1] + ((_e3247[1] - _e3241[1]) * _e1511)), (_e3241[2] + ((_e3247[2] - _e3241[2]) * _e1511))), array<f64, 3>((_e3263[0] + ((_e3269[0] - _e3263[0]) * _e1511)), (_e3263[1] + ((_e3269[1] - _e3263[1]) * _e1511)), (_e3263[2] + ((_e3269[2] - _e3263[2]) * _e1511))), _e229.member);
                                    let _e3297 = ((select(_e3283[0], -(_e3283[0]), (_e3283[0] < 0.0lf)) + select(_e3283[1], -(_e3283[1]), (_e3283[1] < 0.0lf))) + select(_e3283[2], -(_e3283[2]), (_e3283[2] < 0.0lf)));
                                    let _e3300 = local_5.member[0u];
                                    let _e3306 = local_5.member_1[0u];
                                    let _e3312 = local_5.member_2[0u];
                                    let _e3316 = (_e3300[0] - _e3306[0]);
                                    let _e3317 = (_e3300[1] - _e3306[1]);
                                    let _e3318 = (_e3300[2] - _e3306[2]);
                                    let _e3319 = (_e229.member == 0u);
                                    let _e3331 = local_5.member[1u];
                                    let _e3337 = local_5.member_1[1u];
                                    let _e3343 = local_5.member_2[1u];
                                    let _e3347 = (_e3331[0] - _e3337[0]);
                                    let _e3348 = (_e3331[1] - _e3337[1]);
                                    let _e3349 = (_e3331[2] - _e3337[2]);
                                    let _e3350 = (_e229.member == 0u);
                                    let _e3362 = local_5.member[0u];
                                    let _e3368 = select(_e3362[0], -(_e3362[0]), (_e3362[0] < 0.0lf));
                                    let _e3371 = select(_e3362[1], -(_e3362[1]), (_e3362[1] < 0.0lf));
                                    let _e3373 = select(_e3371, _e3368, (_e3368 > _e3371));
                                    let _e3376 = select(_e3362[2], -(_e3362[2]), (_e3362[2] < 0.0lf));
                                    let _e3378 = select(_e3376, _e3373, (_e3373 > _e3376));
                                    let _e3381 = local_5.member[1u];
                                    let _e3387 = select(_e3381[0], -(_e3381[0]), (_e3381[0] < 0.0lf));
                                    let _e3390 = select(_e3381[1], -(_e3381[1]), (_e3381[1] < 0.0lf));
                                    let _e3392 = select(_e3390, _e3387, (_e3387 > _e3390));
                                    let _e3395 = select(_e3381[2], -(_e3381[2]), (_e3381[2] < 0.0lf));
                                    let _e3397 = select(_e3395, _e3392, (_e3392 > _e3395));
                                    let _e3401 = local_5.member_3;
                                    let _e3405 = local_5.member_1[0u];
                                    let _e3411 = select(_e3405[0], -(_e3405[0]), (_e3405[0] < 0.0lf));
                                    let _e3414 = select(_e3405[1], -(_e3405[1]), (_e3405[1] < 0.0lf));
                                    let _e3416 = select(_e3414, _e3411, (_e3411 > _e3414));
                                    let _e3419 = select(_e3405[2], -(_e3405[2]), (_e3405[2] < 0.0lf));
                                    let _e3421 = select(_e3419, _e3416, (_e3416 > _e3419));
                                    let _e3424 = local_5.member_1[1u];
                                    let _e3430 = select(_e3424[0], -(_e3424[0]), (_e3424[0] < 0.0lf));
                                    let _e3433 = select(_e3424[1], -(_e3424[1]), (_e3424[1] < 0.0lf));
                                    let _e3435 = select(_e3433, _e3430, (_e3430 > _e3433));
                                    let _e3438 = select(_e3424[2], -(_e3424[2]), (_e3424[2] < 0.0lf));
                                    let _e3440 = select(_e3438, _e3435, (_e3435 > _e3438));
                                    let _e3444 = local_5.member_3;
                                    let _e3448 = local_5.member_2[0u];
                                    let _e3454 = select(_e3448[0], -(_e3448[0]), (_e3448[0] < 0.0lf));
                                    let _e3457 = select(_e3448[1], -(_e3448[1]), (_e3448[1] < 0.0lf));
                                    let _e3459 = select(_e3457, _e3454, (_e3454 > _e3457));
                                    let _e3462 = select(_e3448[2], -(_e3448[2]), (_e3448[2] < 0.0lf));
                                    let _e3464 = select(_e3462, _e3459, (_e3459 > _e3462));
                                    let _e3467 = local_5.member_2[1u];
                                    let _e3473 = select(_e3467[0], -(_e3467[0]), (_e3467[0] < 0.0lf));
                                    let _e3476 = select(_e3467[1], -(_e3467[1]), (_e3467[1] < 0.0lf));
                                    let _e3478 = select(_e3476, _e3473, (_e3473 > _e3476));
                                    let _e3481 = select(_e3467[2], -(_e3467[2]), (_e3467[2] < 0.0lf));
                                    let _e3483 = select(_e3481, _e3478, (_e3478 > _e3481));
                                    let _e3487 = local_5.member_3;
                                    let _e3495 = local_5.member_3;
                                    local_1 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3300, array<f64, 3>(_e3316, _e3317, _e3318), array<f64, 3>((_e3300[0] - _e3312[0]), (_e3300[1] - _e3312[1]), (_e3300[2] - _e3312[2])), array<f64, 3>(select((_e3316 - _e3312[0]), _e3300[0], _e3319), select((_e3317 - _e3312[1]), _e3300[1], _e3319), select((_e3318 - _e3312[2]), _e3300[2], _e3319))), array<array<f64, 3>, 4>(_e3331, array<f64, 3>(_e3347, _e3348, _e3349), array<f64, 3>((_e3331[0] - _e3343[0]), (_e3331[1] - _e3343[1]), (_e3331[2] - _e3343[2])), array<f64, 3>(select((_e3347 - _e3343[0]), _e3331[0], _e3350), select((_e3348 - _e3343[1]), _e3331[1], _e3350), select((_e3349 - _e3343[2]), _e3331[2], _e3350)))), ((((((select(_e3397, _e3378, (_e3378 > _e3397)) + _e3401) + (select(_e3440, _e3421, (_e3421 > _e3440)) + _e3444)) + (select(_e3483, _e3464, (_e3464 > _e3483)) + _e3487)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3495 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e780.member_1);
                                    let _e3513 = local_1.member_1;
                                    if (_e3297 > _e3513) {
                                        if ((bitcast<u64>(_e3297) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3519 = (f64(1f) / _e3297);
                                            let _e3521 = (_e3283[0] * _e3519);
                                            let _e3523 = (_e3283[1] * _e3519);
                                            let _e3525 = (_e3283[2] * _e3519);
                                            let _e3530 = (((_e3521 * _e3521) + (_e3523 * _e3523)) + (_e3525 * _e3525));
                                            if (_e3530 <= 2.2250738585072014e-308lf) {
                                                phi_6538_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3530 > 0.0lf));
                                            } else {
                                                phi_6481_ = type_16(0i, 5i);
                                                phi_6484_ = bitcast<f64>(((bitcast<u64>(_e3530) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3537 = phi_6481_;
                                                    let _e3539 = phi_6484_;
                                                    local_24 = _e3539;
                                                    if (_e3537.member < _e3537.member_1) {
                                                        let _e3546 = (_e3537.member + 1i);
                                                        phi_6482_ = type_16(select(_e3546, type_17().member_1, select(false, true, ((false == (_e3546 > _e3537.member)) != false))), _e3537.member_1);
                                                        phi_6525_ = type_17(1u, _e3537.member);
                                                    } else {
                                                        phi_6482_ = _e3537;
                                                        phi_6525_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3557 = phi_6482_;
                                                    let _e3559 = phi_6525_;
                                                    let _e3562 = (bitcast<i32>(_e3559.member) != 0i);
                                                    if _e3562 {
                                                        phi_6485_ = (0.5lf * (_e3539 + (_e3530 / _e3539)));
                                                    } else {
                                                        phi_6485_ = f64();
                                                    }
                                                    let _e3567 = phi_6485_;
                                                    continue;
                                                    continuing {
                                                        phi_6481_ = _e3557;
                                                        phi_6484_ = _e3567;
                                                        break if !(_e3562);
                                                    }
                                                }
                                                let _e3572 = local_24;
                                                phi_6538_ = (_e3572 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3578 = phi_6538_;
                                            let _e3580 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3582 = local_1.member_1;
                                            let _e3586 = local_1.member_2;
                                            let _e3591 = ((_e3582 * f64(1.01f)) + ((_e3586 * _e3578) * (f64(1f) + _e3580)));
                                            let _e3595 = local_1.member[0u][0u];
                                            let _e3603 = (((_e3521 * _e3595[0]) + (_e3523 * _e3595[1])) + (_e3525 * _e3595[2]));
                                            let _e3607 = local_1.member[0u][1u];
                                            let _e3615 = (((_e3521 * _e3607[0]) + (_e3523 * _e3607[1])) + (_e3525 * _e3607[2]));
                                            let _e3619 = local_1.member[0u][2u];
                                            let _e3627 = (((_e3521 * _e3619[0]) + (_e3523 * _e3619[1])) + (_e3525 * _e3619[2]));
                                            let _e3631 = local_1.member[0u][3u];
                                            let _e3639 = (((_e3521 * _e3631[0]) + (_e3523 * _e3631[1])) + (_e3525 * _e3631[2]));
                                            let _e3643 = local_1.member[1u][0u];
                                            let _e3651 = (((_e3521 * _e3643[0]) + (_e3523 * _e3643[1])) + (_e3525 * _e3643[2]));
                                            let _e3655 = local_1.member[1u][1u];
                                            let _e3663 = (((_e3521 * _e3655[0]) + (_e3523 * _e3655[1])) + (_e3525 * _e3655[2]));
                                            let _e3667 = local_1.member[1u][2u];
                                            let _e3675 = (((_e3521 * _e3667[0]) + (_e3523 * _e3667[1])) + (_e3525 * _e3667[2]));
                                            let _e3679 = local_1.member[1u][3u];
                                            let _e3687 = (((_e3521 * _e3679[0]) + (_e3523 * _e3679[1])) + (_e3525 * _e3679[2]));
                                            local_2 = type_36(array<f64, 4>(_e3603, _e3615, _e3627, _e3639), array<f64, 4>(_e3651, _e3663, _e3675, _e3687), array<f64, 4>((_e3591 + ((select(_e3603, -(_e3603), (_e3603 < 0.0lf)) + select(_e3651, -(_e3651), (_e3651 < 0.0lf))) * _e3580)), (_e3591 + ((select(_e3615, -(_e3615), (_e3615 < 0.0lf)) + select(_e3663, -(_e3663), (_e3663 < 0.0lf))) * _e3580)), (_e3591 + ((select(_e3627, -(_e3627), (_e3627 < 0.0lf)) + select(_e3675, -(_e3675), (_e3675 < 0.0lf))) * _e3580)), (_e3591 + ((select(_e3639, -(_e3639), (_e3639 < 0.0lf)) + select(_e3687, -(_e3687), (_e3687 < 0.0lf))) * _e3580))));
                                            let _e3732 = (((_e3521 * _e3521) + (_e3523 * _e3523)) + (_e3525 * _e3525));
                                            if (_e3732 <= 2.2250738585072014e-308lf) {
                                                phi_6833_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3732 > 0.0lf));
                                            } else {
                                                phi_6776_ = type_16(0i, 5i);
                                                phi_6779_ = bitcast<f64>(((bitcast<u64>(_e3732) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3739 = phi_6776_;
                                                    let _e3741 = phi_6779_;
                                                    local_25 = _e3741;
                                                    if (_e3739.member < _e3739.member_1) {
                                                        let _e3748 = (_e3739.member + 1i);
                                                        phi_6777_ = type_16(select(_e3748, type_17().member_1, select(false, true, ((false == (_e3748 > _e3739.member)) != false))), _e3739.member_1);
                                                        phi_6820_ = type_17(1u, _e3739.member);
                                                    } else {
                                                        phi_6777_ = _e3739;
                                                        phi_6820_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3759 = phi_6777_;
                                                    let _e3761 = phi_6820_;
                                                    let _e3764 = (bitcast<i32>(_e3761.member) != 0i);
                                                    if _e3764 {
                                                        phi_6780_ = (0.5lf * (_e3741 + (_e3732 / _e3741)));
                                                    } else {
                                                        phi_6780_ = f64();
                                                    }
                                                    let _e3769 = phi_6780_;
                                                    continue;
                                                    continuing {
                                                        phi_6776_ = _e3759;
                                                        phi_6779_ = _e3769;
                                                        break if !(_e3764);
                                                    }
                                                }
                                                let _e3774 = local_25;
                                                phi_6833_ = (_e3774 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3780 = phi_6833_;
                                            let _e3791 = (((_e3283[0] * _e3283[0]) + (_e3283[1] * _e3283[1])) + (_e3283[2] * _e3283[2]));
                                            if (_e3791 <= 2.2250738585072014e-308lf) {
                                                phi_6922_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3791 > 0.0lf));
                                            } else {
                                                phi_6865_ = type_16(0i, 5i);
                                                phi_6868_ = bitcast<f64>(((bitcast<u64>(_e3791) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3798 = phi_6865_;
                                                    let _e3800 = phi_6868_;
                                                    local_26 = _e3800;
                                                    if (_e3798.member < _e3798.member_1) {
                                                        let _e3807 = (_e3798.member + 1i);
                                                        phi_6866_ = type_16(select(_e3807, type_17().member_1, select(false, true, ((false == (_e3807 > _e3798.member)) != false))), _e3798.member_1);
                                                        phi_6909_ = type_17(1u, _e3798.member);
                                                    } else {
                                                        phi_6866_ = _e3798;
                                                        phi_6909_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3818 = phi_6866_;
                                                    let _e3820 = phi_6909_;
                                                    let _e3823 = (bitcast<i32>(_e3820.member) != 0i);
                                                    if _e3823 {
                                                        phi_6869_ = (0.5lf * (_e3800 + (_e3791 / _e3800)));
                                                    } else {
                                                        phi_6869_ = f64();
                                                    }
                                                    let _e3828 = phi_6869_;
                                                    continue;
                                                    continuing {
                                                        phi_6865_ = _e3818;
                                                        phi_6868_ = _e3828;
                                                        break if !(_e3823);
                                                    }
                                                }
                                                let _e3833 = local_26;
                                                phi_6922_ = (_e3833 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3839 = phi_6922_;
                                            let _e3847 = local_5.member[0u];
                                            let _e3853 = select(_e3847[0], -(_e3847[0]), (_e3847[0] < 0.0lf));
                                            let _e3856 = select(_e3847[1], -(_e3847[1]), (_e3847[1] < 0.0lf));
                                            let _e3858 = select(_e3856, _e3853, (_e3853 > _e3856));
                                            let _e3861 = select(_e3847[2], -(_e3847[2]), (_e3847[2] < 0.0lf));
                                            let _e3863 = select(_e3861, _e3858, (_e3858 > _e3861));
                                            let _e3866 = local_5.member[1u];
                                            let _e3872 = select(_e3866[0], -(_e3866[0]), (_e3866[0] < 0.0lf));
                                            let _e3875 = select(_e3866[1], -(_e3866[1]), (_e3866[1] < 0.0lf));
                                            let _e3877 = select(_e3875, _e3872, (_e3872 > _e3875));
                                            let _e3880 = select(_e3866[2], -(_e3866[2]), (_e3866[2] < 0.0lf));
                                            let _e3882 = select(_e3880, _e3877, (_e3877 > _e3880));
                                            let _e3886 = local_5.member_3;
                                            let _e3890 = local_5.member_1[0u];
                                            let _e3896 = select(_e3890[0], -(_e3890[0]), (_e3890[0] < 0.0lf));
                                            let _e3899 = select(_e3890[1], -(_e3890[1]), (_e3890[1] < 0.0lf));
                                            let _e3901 = select(_e3899, _e3896, (_e3896 > _e3899));
                                            let _e3904 = select(_e3890[2], -(_e3890[2]), (_e3890[2] < 0.0lf));
                                            let _e3906 = select(_e3904, _e3901, (_e3901 > _e3904));
                                            let _e3909 = local_5.member_1[1u];
                                            let _e3915 = select(_e3909[0], -(_e3909[0]), (_e3909[0] < 0.0lf));
                                            let _e3918 = select(_e3909[1], -(_e3909[1]), (_e3909[1] < 0.0lf));
                                            let _e3920 = select(_e3918, _e3915, (_e3915 > _e3918));
                                            let _e3923 = select(_e3909[2], -(_e3909[2]), (_e3909[2] < 0.0lf));
                                            let _e3925 = select(_e3923, _e3920, (_e3920 > _e3923));
                                            let _e3929 = local_5.member_3;
                                            let _e3933 = local_5.member_2[0u];
                                            let _e3939 = select(_e3933[0], -(_e3933[0]), (_e3933[0] < 0.0lf));
                                            let _e3942 = select(_e3933[1], -(_e3933[1]), (_e3933[1] < 0.0lf));
                                            let _e3944 = select(_e3942, _e3939, (_e3939 > _e3942));
                                            let _e3947 = select(_e3933[2], -(_e3933[2]), (_e3933[2] < 0.0lf));
                                            let _e3949 = select(_e3947, _e3944, (_e3944 > _e3947));
                                            let _e3952 = local_5.member_2[1u];
                                            let _e3958 = select(_e3952[0], -(_e3952[0]), (_e3952[0] < 0.0lf));
                                            let _e3961 = select(_e3952[1], -(_e3952[1]), (_e3952[1] < 0.0lf));
                                            let _e3963 = select(_e3961, _e3958, (_e3958 > _e3961));
                                            let _e3966 = select(_e3952[2], -(_e3952[2]), (_e3952[2] < 0.0lf));
                                            let _e3968 = select(_e3966, _e3963, (_e3963 > _e3966));
                                            let _e3972 = local_5.member_3;
                                            let _e3980 = local_5.member_3;
                                            let _e3995 = ((((_e3839 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3882, _e3863, (_e3863 > _e3882)) + _e3886) + (select(_e3925, _e3906, (_e3906 > _e3925)) + _e3929)) + (select(_e3968, _e3949, (_e3949 > _e3968)) + _e3972)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3980 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3780) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e3998 = local_2.member[0u];
                                            let _e4001 = local_2.member_1[0u];
                                            phi_7240_ = type_9(1u, 4u);
                                            phi_7243_ = ((_e3998 + ((_e4001 - _e3998) * _e1511)) - ((_e3513 * f64(1.01f)) + ((select(_e3998, -(_e3998), (_e3998 < 0.0lf)) + select(_e4001, -(_e4001), (_e4001 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4020 = phi_7240_;
                                                let _e4022 = phi_7243_;
                                                local_27 = _e4022;
                                                local_28 = _e4022;
                                                let _e4025 = (_e4020.member < _e4020.member_1);
                                                let _e4036 = select(type_9().member_1, _e4020.member, _e4025);
                                                let _e4038 = (bitcast<i32>(select(0u, 1u, _e4025)) != 0i);
                                                if _e4038 {
                                                    let _e4041 = local_2.member[_e4036];
                                                    let _e4044 = local_2.member_1[_e4036];
                                                    let _e4061 = ((_e4041 + ((_e4044 - _e4041) * _e1511)) - ((_e3513 * f64(1.01f)) + ((select(_e4041, -(_e4041), (_e4041 < 0.0lf)) + select(_e4044, -(_e4044), (_e4044 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7244_ = select(_e4061, _e4022, (_e4022 < _e4061));
                                                } else {
                                                    phi_7244_ = f64();
                                                }
                                                let _e4065 = phi_7244_;
                                                continue;
                                                continuing {
                                                    phi_7240_ = type_9(select(_e4020.member, (_e4020.member + 1u), _e4025), select(_e4020.member_1, _e4020.member_1, _e4025));
                                                    phi_7243_ = _e4065;
                                                    break if !(_e4038);
                                                }
                                            }
                                            let _e4068 = local_27;
                                            if (_e4068 > f64(0f)) {
                                                let _e4073 = local_28;
                                                let _e4077 = (((_e3995 - _e4073) / _e3995) * f64(2.02f));
                                                if (_e4077 <= 2.2250738585072014e-308lf) {
                                                    phi_7402_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4077 > 0.0lf));
                                                } else {
                                                    phi_7345_ = type_16(0i, 5i);
                                                    phi_7348_ = bitcast<f64>(((bitcast<u64>(_e4077) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4084 = phi_7345_;
                                                        let _e4086 = phi_7348_;
                                                        local_29 = _e4086;
                                                        if (_e4084.member < _e4084.member_1) {
                                                            let _e4093 = (_e4084.member + 1i);
                                                            phi_7346_ = type_16(select(_e4093, type_17().member_1, select(false, true, ((false == (_e4093 > _e4084.member)) != false))), _e4084.member_1);
                                                            phi_7389_ = type_17(1u, _e4084.member);
                                                        } else {
                                                            phi_7346_ = _e4084;
                                                            phi_7389_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e4104 = phi_7346_;
                                                        let _e4106 = phi_7389_;
                                                        let _e4109 = (bitcast<i32>(_e4106.member) != 0i);
                                                        if _e4109 {
                                                            phi_7349_ = (0.5lf * (_e4086 + (_e4077 / _e4086)));
                                                        } else {
                                                            phi_7349_ = f64();
                                                        }
                                                        let _e4114 = phi_7349_;
                                                        continue;
                                                        continuing {
                                                            phi_7345_ = _e4104;
                                                            phi_7348_ = _e4114;
                                                            break if !(_e4109);
                                                        }
                                                    }
                                                    let _e4119 = local_29;
                                                    phi_7402_ = (_e4119 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4125 = phi_7402_;
                                                let _e4128 = ((_e4125 * _e3780) * f64(1.01f));
                                                phi_7409_ = type_9(0u, 4u);
                                                phi_7412_ = f64(2f);
                                                phi_7414_ = true;
                                                phi_7416_ = true;
                                                loop {
                                                    let _e4131 = phi_7409_;
                                                    let _e4133 = phi_7412_;
                                                    let _e4135 = phi_7414_;
                                                    let _e4137 = phi_7416_;
                                                    local_30 = _e4133;
                                                    local_31 = _e4133;
                                                    local_32 = _e4135;
                                                    local_33 = _e4137;
                                                    local_34 = _e4137;
                                                    local_35 = _e4137;
                                                    local_60 = _e4137;
                                                    local_36 = _e4137;
                                                    let _e4140 = (_e4131.member < _e4131.member_1);
                                                    let _e4151 = select(type_9().member_1, _e4131.member, _e4140);
                                                    let _e4153 = (bitcast<i32>(select(0u, 1u, _e4140)) != 0i);
                                                    if _e4153 {
                                                        let _e4157 = local_1.member[0u][_e4151];
                                                        let _e4164 = local_1.member[1u][_e4151];
                                                        let _e4178 = ((select(_e4157[0], -(_e4157[0]), (_e4157[0] < 0.0lf)) + select(_e4157[1], -(_e4157[1]), (_e4157[1] < 0.0lf))) + select(_e4157[2], -(_e4157[2]), (_e4157[2] < 0.0lf)));
                                                        let _e4189 = ((select(_e4164[0], -(_e4164[0]), (_e4164[0] < 0.0lf)) + select(_e4164[1], -(_e4164[1]), (_e4164[1] < 0.0lf))) + select(_e4164[2], -(_e4164[2]), (_e4164[2] < 0.0lf)));
                                                        let _e4197 = (_e4164[0] - _e4157[0]);
                                                        let _e4198 = (_e4164[1] - _e4157[1]);
                                                        let _e4199 = (_e4164[2] - _e4157[2]);
                                                        let _e4218 = local_2.member[_e4151];
                                                        let _e4221 = local_2.member_1[_e4151];
                                                        let _e4234 = ((_e3513 * f64(1.01f)) + ((select(_e4218, -(_e4218), (_e4218 < 0.0lf)) + select(_e4221, -(_e4221), (_e4221 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4241 = local_2.member_1[_e4151];
                                                        let _e4244 = local_2.member[_e4151];
                                                        let _e4245 = (_e4241 - _e4244);
                                                        let _e4248 = ((_e4234 + _e4234) + (_e4128 * ((((select(_e4197, -(_e4197), (_e4197 < 0.0lf)) + select(_e4198, -(_e4198), (_e4198 < 0.0lf))) + select(_e4199, -(_e4199), (_e4199 < 0.0lf))) + (_e3513 * f64(6f))) * f64(1.01f))));
                                                        let _e4251 = ((((_e4218 + ((_e4221 - _e4218) * _e1511)) - _e4234) - (_e4128 * ((select(_e4189, _e4178, (_e4178 > _e4189)) + (_e3513 * f64(3f))) * f64(1.01f)))) - _e3995);
                                                        let _e4252 = (_e4251 > 2.2250738585072014e-308lf);
                                                        let _e4253 = (_e4245 > _e4248);
                                                        if _e4253 {
                                                            phi_7653_ = _e4133;
                                                        } else {
                                                            if _e4252 {
                                                                let _e4260 = (_e4248 - _e4245);
                                                                let _e4263 = (_e4251 / select(2.2250738585072014e-308lf, _e4260, (_e4260 > 2.2250738585072014e-308lf)));
                                                                phi_7652_ = select(_e4263, _e4133, (_e4133 < _e4263));
                                                            } else {
                                                                phi_7652_ = _e4133;
                                                            }
                                                            let _e4267 = phi_7652_;
                                                            phi_7653_ = _e4267;
                                                        }
                                                        let _e4269 = phi_7653_;
                                                        phi_7413_ = _e4269;
                                                        phi_7415_ = (_e4135 && select(_e4252, true, (_e4245 < -(_e4248))));
                                                        phi_7417_ = (_e4137 && select(_e4252, true, _e4253));
                                                    } else {
                                                        phi_7413_ = f64();
                                                        phi_7415_ = bool();
                                                        phi_7417_ = bool();
                                                    }
                                                    let _e4271 = phi_7413_;
                                                    let _e4273 = phi_7415_;
                                                    let _e4275 = phi_7417_;
                                                    continue;
                                                    continuing {
                                                        phi_7409_ = type_9(select(_e4131.member, (_e4131.member + 1u), _e4140), select(_e4131.member_1, _e4131.member_1, _e4140));
                                                        phi_7412_ = _e4271;
                                                        phi_7414_ = _e4273;
                                                        phi_7416_ = _e4275;
                                                        break if !(_e4153);
                                                    }
                                                }
                                                let _e4277 = f64(2f);
                                                let _e4279 = local_30;
                                                let _e4282 = local_31;
                                                let _e4285 = (select(_e4277, _e4282, (_e4279 < _e4277)) * f64(0.999f));
                                                let _e4287 = local_32;
                                                if _e4287 {
                                                    let _e4291 = local_33;
                                                    let _e4295 = local_34;
                                                    let _e4299 = local_35;
                                                    phi_7671_ = type_42(select(_e1511, type_42().member, _e4291), select(f64(2f), type_42().member_1, _e4295), select(1u, type_42().member_2, _e4299));
                                                    let _e5412 = local_60;
                                                    phi_7672_ = _e5412;
                                                } else {
                                                    phi_7671_ = type_42();
                                                    phi_7672_ = true;
                                                }
                                                let _e4303 = phi_7671_;
                                                let _e4305 = phi_7672_;
                                                if _e4305 {
                                                    let _e4307 = local_36;
                                                    if _e4307 {
                                                        let _e4313 = (_e1511 + _e4285);
                                                        let _e4316 = select(_e1511, select(_e550, _e4313, (_e4313 < _e550)), (_e4285 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7694_ = type_9(0u, 4u);
                                                        phi_7697_ = _e4316;
                                                        phi_7699_ = _e1511;
                                                        loop {
                                                            let _e4318 = phi_7694_;
                                                            let _e4320 = phi_7697_;
                                                            let _e4322 = phi_7699_;
                                                            local_37 = _e4320;
                                                            local_38 = _e4322;
                                                            local_39 = _e4322;
                                                            let _e4325 = (_e4318.member < _e4318.member_1);
                                                            let _e4336 = select(type_9().member_1, _e4318.member, _e4325);
                                                            let _e4338 = (bitcast<i32>(select(0u, 1u, _e4325)) != 0i);
                                                            if _e4338 {
                                                                let _e4341 = local_2.member[_e4336];
                                                                let _e4344 = local_2.member_1[_e4336];
                                                                let _e4347 = local_2.member[_e4336];
                                                                let _e4353 = local_2.member_2[_e4336];
                                                                let _e4354 = ((_e4341 + ((_e4344 - _e4347) * _e1511)) - _e4353);
                                                                let _e4357 = local_2.member_1[_e4336];
                                                                let _e4360 = local_2.member[_e4336];
                                                                let _e4361 = (_e4357 - _e4360);
                                                                if (_e4361 > f64(0f)) {
                                                                    let _e4377 = (_e1511 - (_e4354 / _e4361));
                                                                    phi_7811_ = _e4320;
                                                                    phi_7812_ = select(_e4377, _e4322, (_e4322 > _e4377));
                                                                } else {
                                                                    if (_e4354 > f64(0f)) {
                                                                        if (_e4361 < f64(0f)) {
                                                                            let _e4369 = (_e1511 - (_e4354 / _e4361));
                                                                            phi_7809_ = select(_e4369, _e4320, (_e4320 < _e4369));
                                                                        } else {
                                                                            phi_7809_ = _e4320;
                                                                        }
                                                                        let _e4373 = phi_7809_;
                                                                        phi_7810_ = _e4373;
                                                                    } else {
                                                                        phi_7810_ = _e4320;
                                                                    }
                                                                    let _e4375 = phi_7810_;
                                                                    phi_7811_ = _e4375;
                                                                    phi_7812_ = _e4322;
                                                                }
                                                                let _e4381 = phi_7811_;
                                                                let _e4383 = phi_7812_;
                                                                phi_7698_ = _e4381;
                                                                phi_7700_ = _e4383;
                                                            } else {
                                                                phi_7698_ = f64();
                                                                phi_7700_ = f64();
                                                            }
                                                            let _e4385 = phi_7698_;
                                                            let _e4387 = phi_7700_;
                                                            continue;
                                                            continuing {
                                                                phi_7694_ = type_9(select(_e4318.member, (_e4318.member + 1u), _e4325), select(_e4318.member_1, _e4318.member_1, _e4325));
                                                                phi_7697_ = _e4385;
                                                                phi_7699_ = _e4387;
                                                                break if !(_e4338);
                                                            }
                                                        }
                                                        let _e4390 = local_37;
                                                        let _e4392 = local_38;
                                                        let _e4397 = local_39;
                                                        let _e4398 = (_e4397 + ((_e4390 - _e4392) * f64(0.5f)));
                                                        if (_e4398 > _e1511) {
                                                            if (_e4398 <= _e4316) {
                                                                let _e4401 = f64(0f);
                                                                let _e4404 = local_2.member[0u];
                                                                let _e4407 = local_2.member_1[0u];
                                                                let _e4410 = local_2.member[0u];
                                                                let _e4416 = local_2.member_2[0u];
                                                                if (((_e4404 + ((_e4407 - _e4410) * _e4398)) - _e4416) > _e4401) {
                                                                    let _e4421 = local_2.member[1u];
                                                                    let _e4424 = local_2.member_1[1u];
                                                                    let _e4427 = local_2.member[1u];
                                                                    let _e4433 = local_2.member_2[1u];
                                                                    if (((_e4421 + ((_e4424 - _e4427) * _e4398)) - _e4433) > _e4401) {
                                                                        let _e4438 = local_2.member[2u];
                                                                        let _e4441 = local_2.member_1[2u];
                                                                        let _e4444 = local_2.member[2u];
                                                                        let _e4450 = local_2.member_2[2u];
                                                                        if (((_e4438 + ((_e4441 - _e4444) * _e4398)) - _e4450) > _e4401) {
                                                                            let _e4455 = local_2.member[3u];
                                                                            let _e4458 = local_2.member_1[3u];
                                                                            let _e4461 = local_2.member[3u];
                                                                            let _e4467 = local_2.member_2[3u];
                                                                            phi_7975_ = (((_e4455 + ((_e4458 - _e4461) * _e4398)) - _e4467) > _e4401);
                                                                            phi_7976_ = false;
                                                                        } else {
                                                                            phi_7975_ = bool();
                                                                            phi_7976_ = true;
                                                                        }
                                                                        let _e4471 = phi_7975_;
                                                                        let _e4473 = phi_7976_;
                                                                        phi_7977_ = _e4471;
                                                                        phi_7978_ = _e4473;
                                                                    } else {
                                                                        phi_7977_ = bool();
                                                                        phi_7978_ = true;
                                                                    }
                                                                    let _e4475 = phi_7977_;
                                                                    let _e4477 = phi_7978_;
                                                                    phi_7979_ = _e4475;
                                                                    phi_7980_ = _e4477;
                                                                } else {
                                                                    phi_7979_ = bool();
                                                                    phi_7980_ = true;
                                                                }
                                                                let _e4479 = phi_7979_;
                                                                let _e4481 = phi_7980_;
                                                                phi_7989_ = select(true, false, select(_e4479, false, _e4481));
                                                            } else {
                                                                phi_7989_ = true;
                                                            }
                                                            let _e4485 = phi_7989_;
                                                            phi_7990_ = _e4485;
                                                        } else {
                                                            phi_7990_ = true;
                                                        }
                                                        let _e4487 = phi_7990_;
                                                        phi_7999_ = type_42(_e4316, select(_e4398, f64(2f), _e4487), 2u);
                                                        phi_8000_ = type_42();
                                                        phi_8001_ = false;
                                                    } else {
                                                        phi_7999_ = type_42();
                                                        phi_8000_ = type_42(_e1511, f64(2f), 0u);
                                                        phi_8001_ = true;
                                                    }
                                                    let _e4492 = phi_7999_;
                                                    let _e4494 = phi_8000_;
                                                    let _e4496 = phi_8001_;
                                                    phi_8002_ = _e4492;
                                                    phi_8003_ = _e4494;
                                                    phi_8004_ = _e4496;
                                                } else {
                                                    phi_8002_ = type_42();
                                                    phi_8003_ = _e4303;
                                                    phi_8004_ = true;
                                                }
                                                let _e4498 = phi_8002_;
                                                let _e4500 = phi_8003_;
                                                let _e4502 = phi_8004_;
                                                phi_8010_ = _e4500;
                                                phi_8011_ = _e4498;
                                                phi_8012_ = _e4502;
                                            } else {
                                                phi_8010_ = type_42(_e1511, f64(2f), 0u);
                                                phi_8011_ = type_42();
                                                phi_8012_ = true;
                                            }
                                            let _e4504 = phi_8010_;
                                            let _e4506 = phi_8011_;
                                            let _e4508 = phi_8012_;
                                            phi_8016_ = _e4504;
                                            phi_8017_ = _e4506;
                                            phi_8018_ = false;
                                            phi_8019_ = _e4508;
                                        } else {
                                            phi_8016_ = type_42();
                                            phi_8017_ = type_42();
                                            phi_8018_ = true;
                                            phi_8019_ = false;
                                        }
                                        let _e4510 = phi_8016_;
                                        let _e4512 = phi_8017_;
                                        let _e4514 = phi_8018_;
                                        let _e4516 = phi_8019_;
                                        phi_8020_ = _e4510;
                                        phi_8021_ = _e4512;
                                        phi_8022_ = _e4514;
                                        phi_8023_ = _e4516;
                                    } else {
                                        phi_8020_ = type_42();
                                        phi_8021_ = type_42();
                                        phi_8022_ = true;
                                        phi_8023_ = false;
                                    }
                                    let _e4518 = phi_8020_;
                                    let _e4520 = phi_8021_;
                                    let _e4522 = phi_8022_;
                                    let _e4524 = phi_8023_;
                                    let _e4532 = select(_e4524, true, _e4522);
                                    let _e4536 = select(_e4520.member_1, select(_e4518.member_1, f64(2f), _e4522), _e4532);
                                    let _e4538 = select(_e4520.member_2, select(_e4518.member_2, 0u, _e4522), _e4532);
                                    if ((_e552 & 64u) != 0u) {
                                        let _e4540 = (_e4538 == 2u);
                                        let _e4541 = (_e4536 <= _e550);
                                        phi_8058_ = select(f64(), select(f64(), _e4536, _e4541), _e4540);
                                        phi_8059_ = select(f64(), select(f64(), _e4536, _e4541), _e4540);
                                        phi_8060_ = select(false, _e4541, _e4540);
                                        phi_8061_ = select(false, select(true, false, _e4541), _e4540);
                                        phi_8062_ = select(true, false, _e4540);
                                    } else {
                                        phi_8058_ = f64();
                                        phi_8059_ = f64();
                                        phi_8060_ = false;
                                        phi_8061_ = false;
                                        phi_8062_ = true;
                                    }
                                    let _e4551 = phi_8058_;
                                    let _e4553 = phi_8059_;
                                    let _e4555 = phi_8060_;
                                    let _e4557 = phi_8061_;
                                    let _e4559 = phi_8062_;
                                    phi_8063_ = _e4551;
                                    phi_8064_ = _e4538;
                                    phi_8065_ = _e4553;
                                    phi_8066_ = type_42(select(_e4520.member, select(_e4518.member, _e1511, _e4522), _e4532), _e4536, _e4538);
                                    phi_8067_ = _e4538;
                                    phi_8068_ = _e4538;
                                    phi_8069_ = _e4555;
                                    phi_8070_ = _e4557;
                                    phi_8071_ = _e4559;
                                }
                                let _e4561 = phi_8063_;
                                let _e4563 = phi_8064_;
                                let _e4565 = phi_8065_;
                                let _e4567 = phi_8066_;
                                let _e4569 = phi_8067_;
                                let _e4571 = phi_8068_;
                                let _e4573 = phi_8069_;
                                let _e4575 = phi_8070_;
                                let _e4577 = phi_8071_;
                                phi_8072_ = _e4561;
                                phi_8073_ = _e4563;
                                phi_8074_ = _e4565;
                                phi_8075_ = _e4567;
                                phi_8076_ = _e4569;
                                phi_8077_ = _e4571;
                                phi_8078_ = _e4573;
                                phi_8079_ = _e3215;
                                phi_8080_ = _e4575;
                                phi_8081_ = _e4577;
                                phi_8082_ = false;
                            } else {
                                phi_8072_ = f64();
                                phi_8073_ = u32();
                                phi_8074_ = f64();
                                phi_8075_ = type_42();
                                phi_8076_ = u32();
                                phi_8077_ = u32();
                                phi_8078_ = false;
                                phi_8079_ = false;
                                phi_8080_ = false;
                                phi_8081_ = false;
                                phi_8082_ = true;
                            }
                            let _e4579 = phi_8072_;
                            let _e4581 = phi_8073_;
                            let _e4583 = phi_8074_;
                            let _e4585 = phi_8075_;
                            let _e4587 = phi_8076_;
                            let _e4589 = phi_8077_;
                            let _e4591 = phi_8078_;
                            let _e4593 = phi_8079_;
                            let _e4595 = phi_8080_;
                            let _e4597 = phi_8081_;
                            let _e4599 = phi_8082_;
                            phi_8083_ = _e3212;
                            phi_3067_ = _e4579;
                            phi_3069_ = _e4581;
                            phi_3071_ = _e4583;
                            phi_8084_ = _e4585;
                            phi_8085_ = _e4587;
                            phi_8086_ = _e3212;
                            phi_8087_ = _e4589;
                            phi_8088_ = _e4591;
                            phi_8089_ = _e4593;
                            phi_8090_ = _e4595;
                            phi_8091_ = _e4597;
                            phi_8092_ = false;
                            phi_8093_ = _e4599;
                        } else {
                            phi_8083_ = f64();
                            phi_3067_ = f64();
                            phi_3069_ = u32();
                            phi_3071_ = f64();
                            phi_8084_ = type_42();
                            phi_8085_ = u32();
                            phi_8086_ = f64();
                            phi_8087_ = u32();
                            phi_8088_ = false;
                            phi_8089_ = false;
                            phi_8090_ = false;
                            phi_8091_ = false;
                            phi_8092_ = true;
                            phi_8093_ = false;
                        }
                        let _e4601 = phi_8083_;
                        let _e4603 = phi_3067_;
                        let _e4605 = phi_3069_;
                        let _e4607 = phi_3071_;
                        let _e4609 = phi_8084_;
                        let _e4611 = phi_8085_;
                        let _e4613 = phi_8086_;
                        let _e4615 = phi_8087_;
                        let _e4617 = phi_8088_;
                        let _e4619 = phi_8089_;
                        let _e4621 = phi_8090_;
                        let _e4623 = phi_8091_;
                        let _e4625 = phi_8092_;
                        let _e4627 = phi_8093_;
                        local_40 = _e4619;
                        local_41 = _e4621;
                        local_42 = _e4619;
                        local_43 = _e4623;
                        local_44 = _e4619;
                        local_45 = _e4625;
                        local_46 = _e4619;
                        local_47 = _e4627;
                        local_48 = _e4609;
                        local_49 = _e4609;
                        local_50 = _e4611;
                        local_51 = _e4609;
                        local_61 = _e4619;
                        local_52 = _e4615;
                        local_54 = _e4613;
                        local_55 = _e4601;
                        continue;
                        continuing {
                            phi_3063_ = _e1529;
                            phi_3066_ = _e4603;
                            phi_3068_ = _e4605;
                            phi_3070_ = _e4607;
                            break if !(_e4617);
                        }
                    }
                    let _e4630 = local_40;
                    let _e4632 = local_41;
                    let _e4633 = select(_e4632, false, _e4630);
                    let _e4635 = local_42;
                    let _e4637 = local_43;
                    let _e4640 = local_44;
                    let _e4642 = local_45;
                    let _e4645 = local_46;
                    let _e4647 = local_47;
                    if _e4633 {
                        let _e4650 = local_48;
                        if (_e4650.member >= _e550) {
                            phi_8122_ = type_39(type_38(0u, f64()), 0u);
                        } else {
                            let _e4654 = local_49;
                            let _e4658 = local_50;
                            let _e4661 = local_51;
                            phi_8122_ = type_39(type_38(2u, _e4661.member), select(_e4658, 0u, (_e4654.member > _e541)));
                        }
                        let _e4668 = phi_8122_;
                        phi_8123_ = _e4668;
                        phi_8124_ = false;
                        phi_8125_ = false;
                        phi_8126_ = false;
                        phi_8127_ = false;
                    } else {
                        phi_8123_ = type_39();
                        phi_8124_ = select(_e4637, false, _e4635);
                        let _e5507 = local_61;
                        phi_8125_ = _e5507;
                        phi_8126_ = select(_e4642, false, _e4640);
                        phi_8127_ = select(_e4647, false, _e4645);
                    }
                    let _e4670 = phi_8123_;
                    let _e4672 = phi_8124_;
                    let _e4674 = phi_8125_;
                    let _e4676 = phi_8126_;
                    let _e4678 = phi_8127_;
                    let _e4680 = local_52;
                    let _e4682 = local_53;
                    let _e4685 = local_54;
                    let _e4687 = local_55;
                    let _e4689 = select(_e4674, true, _e4672);
                    let _e4694 = local_56;
                    let _e4695 = select(_e4694, select(_e4687, _e4685, _e4672), _e4689);
                    let _e4697 = local_57;
                    let _e4698 = select(_e4697, select(_e4682, _e4680, _e4672), _e4689);
                    if select(select(_e4676, false, _e4672), true, _e4689) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8161_ = type_9(0u, 3u);
                        loop {
                            let _e4711 = phi_8161_;
                            let _e4714 = (_e4711.member < _e4711.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4714)) != 0i) {
                                let _e4729 = local[select(type_9().member_1, _e4711.member, _e4714)];
                                let _e4732 = (_e4695 + (select(f64(0f), _e532, (_e532 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4729)));
                                let _e4734 = select(_e550, _e4732, (_e4732 < _e550));
                                let _e4737 = local_5.member[0u];
                                let _e4743 = local_5.member[1u];
                                let _e4759 = local_5.member_1[0u];
                                let _e4765 = local_5.member_1[1u];
                                let _e4781 = local_5.member_2[0u];
                                let _e4787 = local_5.member_2[1u];
                                let _e4801 = function_3(array<f64, 3>((_e4737[0] + ((_e4743[0] - _e4737[0]) * _e4734)), (_e4737[1] + ((_e4743[1] - _e4737[1]) * _e4734)), (_e4737[2] + ((_e4743[2] - _e4737[2]) * _e4734))), array<f64, 3>((_e4759[0] + ((_e4765[0] - _e4759[0]) * _e4734)), (_e4759[1] + ((_e4765[1] - _e4759[1]) * _e4734)), (_e4759[2] + ((_e4765[2] - _e4759[2]) * _e4734))), array<f64, 3>((_e4781[0] + ((_e4787[0] - _e4781[0]) * _e4734)), (_e4781[1] + ((_e4787[1] - _e4781[1]) * _e4734)), (_e4781[2] + ((_e4787[2] - _e4781[2]) * _e4734))), _e229.member);
                                let _e4812 = (((_e4801[0] * _e4801[0]) + (_e4801[1] * _e4801[1])) + (_e4801[2] * _e4801[2]));
                                if (_e4812 <= 2.2250738585072014e-308lf) {
                                    phi_8394_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4812 > 0.0lf));
                                } else {
                                    phi_8337_ = type_16(0i, 5i);
                                    phi_8340_ = bitcast<f64>(((bitcast<u64>(_e4812) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4819 = phi_8337_;
                                        let _e4821 = phi_8340_;
                                        local_58 = _e4821;
                                        if (_e4819.member < _e4819.member_1) {
                                            let _e4828 = (_e4819.member + 1i);
                                            phi_8338_ = type_16(select(_e4828, type_17().member_1, select(false, true, ((false == (_e4828 > _e4819.member)) != false))), _e4819.member_1);
                                            phi_8381_ = type_17(1u, _e4819.member);
                                        } else {
                                            phi_8338_ = _e4819;
                                            phi_8381_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e4839 = phi_8338_;
                                        let _e4841 = phi_8381_;
                                        let _e4844 = (bitcast<i32>(_e4841.member) != 0i);
                                        if _e4844 {
                                            phi_8341_ = (0.5lf * (_e4821 + (_e4812 / _e4821)));
                                        } else {
                                            phi_8341_ = f64();
                                        }
                                        let _e4849 = phi_8341_;
                                        continue;
                                        continuing {
                                            phi_8337_ = _e4839;
                                            phi_8340_ = _e4849;
                                            break if !(_e4844);
                                        }
                                    }
                                    let _e4854 = local_58;
                                    phi_8394_ = (_e4854 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4860 = phi_8394_;
                                let _e4868 = local_5.member[0u];
                                let _e4874 = select(_e4868[0], -(_e4868[0]), (_e4868[0] < 0.0lf));
                                let _e4877 = select(_e4868[1], -(_e4868[1]), (_e4868[1] < 0.0lf));
                                let _e4879 = select(_e4877, _e4874, (_e4874 > _e4877));
                                let _e4882 = select(_e4868[2], -(_e4868[2]), (_e4868[2] < 0.0lf));
                                let _e4884 = select(_e4882, _e4879, (_e4879 > _e4882));
                                let _e4887 = local_5.member[1u];
                                let _e4893 = select(_e4887[0], -(_e4887[0]), (_e4887[0] < 0.0lf));
                                let _e4896 = select(_e4887[1], -(_e4887[1]), (_e4887[1] < 0.0lf));
                                let _e4898 = select(_e4896, _e4893, (_e4893 > _e4896));
                                let _e4901 = select(_e4887[2], -(_e4887[2]), (_e4887[2] < 0.0lf));
                                let _e4903 = select(_e4901, _e4898, (_e4898 > _e4901));
                                let _e4907 = local_5.member_3;
                                let _e4911 = local_5.member_1[0u];
                                let _e4917 = select(_e4911[0], -(_e4911[0]), (_e4911[0] < 0.0lf));
                                let _e4920 = select(_e4911[1], -(_e4911[1]), (_e4911[1] < 0.0lf));
                                let _e4922 = select(_e4920, _e4917, (_e4917 > _e4920));
                                let _e4925 = select(_e4911[2], -(_e4911[2]), (_e4911[2] < 0.0lf));
                                let _e4927 = select(_e4925, _e4922, (_e4922 > _e4925));
                                let _e4930 = local_5.member_1[1u];
                                let _e4936 = select(_e4930[0], -(_e4930[0]), (_e4930[0] < 0.0lf));
                                let _e4939 = select(_e4930[1], -(_e4930[1]), (_e4930[1] < 0.0lf));
                                let _e4941 = select(_e4939, _e4936, (_e4936 > _e4939));
                                let _e4944 = select(_e4930[2], -(_e4930[2]), (_e4930[2] < 0.0lf));
                                let _e4946 = select(_e4944, _e4941, (_e4941 > _e4944));
                                let _e4950 = local_5.member_3;
                                let _e4954 = local_5.member_2[0u];
                                let _e4960 = select(_e4954[0], -(_e4954[0]), (_e4954[0] < 0.0lf));
                                let _e4963 = select(_e4954[1], -(_e4954[1]), (_e4954[1] < 0.0lf));
                                let _e4965 = select(_e4963, _e4960, (_e4960 > _e4963));
                                let _e4968 = select(_e4954[2], -(_e4954[2]), (_e4954[2] < 0.0lf));
                                let _e4970 = select(_e4968, _e4965, (_e4965 > _e4968));
                                let _e4973 = local_5.member_2[1u];
                                let _e4979 = select(_e4973[0], -(_e4973[0]), (_e4973[0] < 0.0lf));
                                let _e4982 = select(_e4973[1], -(_e4973[1]), (_e4973[1] < 0.0lf));
                                let _e4984 = select(_e4982, _e4979, (_e4979 > _e4982));
                                let _e4987 = select(_e4973[2], -(_e4973[2]), (_e4973[2] < 0.0lf));
                                let _e4989 = select(_e4987, _e4984, (_e4984 > _e4987));
                                let _e4993 = local_5.member_3;
                                let _e5001 = local_5.member_3;
                                let _e5011 = (((_e4860 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4903, _e4884, (_e4884 > _e4903)) + _e4907) + (select(_e4946, _e4927, (_e4927 > _e4946)) + _e4950)) + (select(_e4989, _e4970, (_e4970 > _e4989)) + _e4993)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5001 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e780.member_1);
                                phi_8671_ = select(true, false, _e5011);
                                phi_8672_ = _e5011;
                            } else {
                                phi_8671_ = false;
                                phi_8672_ = false;
                            }
                            let _e5014 = phi_8671_;
                            let _e5016 = phi_8672_;
                            local_59 = _e5016;
                            continue;
                            continuing {
                                phi_8161_ = type_9(select(_e4711.member, (_e4711.member + 1u), _e4714), select(_e4711.member_1, _e4711.member_1, _e4714));
                                break if !(_e5014);
                            }
                        }
                        let _e5019 = local_59;
                        if _e5019 {
                            phi_8684_ = type_39(type_38(1u, _e4695), select(_e4698, 1u, (_e4695 > _e541)));
                            phi_8685_ = false;
                        } else {
                            phi_8684_ = type_39();
                            phi_8685_ = true;
                        }
                        let _e5025 = phi_8684_;
                        let _e5027 = phi_8685_;
                        if _e5027 {
                            phi_8697_ = type_39(type_38(2u, _e4695), select(_e4698, 0u, (_e4695 > _e541)));
                        } else {
                            phi_8697_ = _e5025;
                        }
                        let _e5033 = phi_8697_;
                        phi_8698_ = _e5033;
                        phi_8699_ = false;
                        phi_8700_ = false;
                    } else {
                        phi_8698_ = type_39();
                        phi_8699_ = select(select(_e4678, false, _e4672), false, _e4689);
                        phi_8700_ = select(select(_e4633, false, _e4672), false, _e4689);
                    }
                    let _e5035 = phi_8698_;
                    let _e5037 = phi_8699_;
                    let _e5039 = phi_8700_;
                    if _e5037 {
                        phi_8707_ = type_39(type_38(0u, f64()), 0u);
                        phi_8708_ = true;
                    } else {
                        phi_8707_ = _e4670;
                        phi_8708_ = _e5039;
                    }
                    let _e5043 = phi_8707_;
                    let _e5045 = phi_8708_;
                    phi_8712_ = _e5043;
                    phi_8713_ = _e5035;
                    phi_8714_ = _e5045;
                } else {
                    phi_8712_ = _e1501;
                    phi_8713_ = type_39();
                    phi_8714_ = true;
                }
                let _e5047 = phi_8712_;
                let _e5049 = phi_8713_;
                let _e5051 = phi_8714_;
                if _e5051 {
                    phi_8718_ = _e5047;
                } else {
                    phi_8718_ = _e5049;
                }
                let _e5053 = phi_8718_;
                switch bitcast<i32>(_e5053.member.member) {
                    case 0: {
                        phi_8736_ = type_35(0u, _e5053.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5064 = function_4(_e5053.member.member_1);
                        phi_8736_ = type_35(0u, _e5053.member_1, _e5064, true);
                        break;
                    }
                    case 2: {
                        let _e5060 = function_4(_e5053.member.member_1);
                        phi_8736_ = type_35(1u, _e5053.member_1, _e5060, true);
                        break;
                    }
                    default: {
                        phi_8736_ = type_35();
                        break;
                    }
                }
                let _e5068 = phi_8736_;
                phi_8737_ = _e5068;
                phi_8738_ = type_9(_e187, _e190);
            } else {
                phi_8737_ = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_8738_ = type_9(0u, 0u);
            }
            let _e5070 = phi_8737_;
            let _e5072 = phi_8738_;
            let _e5077 = params.member.member.member_1;
            let _e5079 = ((_e5077 & 16u) != 0u);
            let _e5082 = select(false, select(false, true, _e5079), _e5070.member_3);
            if _e5070.member_3 {
                let _e5087 = (_e5070.member_2[1] >> bitcast<u32>(20i));
                if (_e5087 <= 896u) {
                    phi_8778_ = 0u;
                } else {
                    phi_8778_ = ((((_e5087 - 896u) << bitcast<u32>(23i)) | ((_e5070.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e5070.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e5102 = phi_8778_;
                let _e5104 = atomicMin((&earliest.member[0u]), _e5102);
            }
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5082 {
                let _e5108 = atomicAdd((&counters[0u]), 1u);
                phi_8792_ = _e5108;
            } else {
                phi_8792_ = 0u;
            }
            let _e5110 = phi_8792_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5113 = atomicLoad((&counters[0u]));
                if (_e5113 > 0u) {
                    let _e5116 = atomicAdd((&contacts.member[0u]), _e5113);
                    atomicStore((&counters[1u]), _e5116);
                }
            }
            workgroupBarrier();
            let _e5119 = atomicLoad((&counters[1u]));
            let _e5120 = (_e5119 + _e5110);
            if _e5082 {
                if _e5079 {
                    let _e5123 = params.member.member_1.member_3;
                    if (_e5120 < _e5123) {
                        let _e5129 = (7u * _e5120);
                        atomicStore((&contacts.member[(4u + _e5129)]), select(1u, 0u, ((_e5072.member_1 & 2147483648u) == 0u)));
                        atomicStore((&contacts.member[(_e5129 + 5u)]), _e5070.member);
                        atomicStore((&contacts.member[(_e5129 + 6u)]), _e5072.member);
                        atomicStore((&contacts.member[(_e5129 + 7u)]), (_e5072.member_1 & 2147483647u));
                        atomicStore((&contacts.member[(_e5129 + 8u)]), _e5070.member_2[0]);
                        atomicStore((&contacts.member[(_e5129 + 9u)]), _e5070.member_2[1]);
                        atomicStore((&contacts.member[(_e5129 + 10u)]), _e5070.member_1);
                    }
                    phi_8862_ = false;
                } else {
                    phi_8862_ = true;
                }
                let _e5151 = phi_8862_;
                phi_8863_ = _e5151;
            } else {
                phi_8863_ = true;
            }
            let _e5153 = phi_8863_;
            if _e5153 {
                if _e5082 {
                    let _e5156 = params.member.member_2.member;
                    if (_e5120 < _e5156) {
                        let _e5158 = (2u * _e5120);
                        atomicStore((&contacts.member[(4u + _e5158)]), _e5072.member);
                        atomicStore((&contacts.member[(_e5158 + 5u)]), _e5072.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_991_ = type_9(select(_e158.member, (_e158.member + 1u), _e161), select(_e158.member_1, _e158.member_1, _e161));
            break if !(_e174);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
