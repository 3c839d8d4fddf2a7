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
    var phi_7069_: bool;
    var phi_7070_: bool;
    var phi_7075_: bool;

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
            phi_7069_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7070_ = select(true, false, _e84);
        } else {
            phi_7069_ = bool();
            phi_7070_ = true;
        }
        let _e91 = phi_7069_;
        let _e93 = phi_7070_;
        phi_7075_ = select(_e91, false, _e93);
    } else {
        phi_7075_ = false;
    }
    let _e96 = phi_7075_;
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
    var phi_1410_: bool;
    var phi_1504_: type_32;
    var phi_1505_: bool;
    var phi_1506_: type_32;
    var phi_1507_: bool;
    var phi_1508_: type_32;
    var phi_1509_: bool;
    var phi_1514_: type_32;
    var phi_2206_: bool;
    var phi_2218_: f32;
    var phi_2289_: type_14;
    var phi_2292_: f32;
    var phi_2290_: type_14;
    var phi_2333_: type_15;
    var phi_2293_: f32;
    var local_9: f32;
    var phi_2346_: f32;
    var phi_2377_: type_9;
    var phi_2380_: u32;
    var phi_2447_: u32;
    var phi_2448_: u32;
    var phi_2381_: u32;
    var phi_2449_: u32;
    var phi_2505_: type_9;
    var phi_2661_: type_38;
    var phi_2662_: bool;
    var phi_2663_: type_38;
    var phi_2664_: bool;
    var phi_2695_: type_9;
    var phi_2698_: f32;
    var phi_2700_: f32;
    var phi_2702_: f32;
    var phi_2812_: bool;
    var phi_2819_: f32;
    var phi_2820_: bool;
    var phi_2699_: f32;
    var phi_2701_: f32;
    var phi_2703_: f32;
    var phi_2821_: f32;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var local_10: bool;
    var local_11: f32;
    var local_12: f32;
    var phi_2828_: f32;
    var phi_2844_: type_9;
    var phi_2847_: f32;
    var phi_2912_: f32;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: f32;
    var phi_2848_: f32;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f32;
    var phi_2934_: f32;
    var phi_2936_: type_38;
    var phi_3773_: array<type_16, 4>;
    var phi_3793_: type_9;
    var phi_3796_: bool;
    var phi_3797_: bool;
    var phi_3848_: bool;
    var phi_3849_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_3863_: u32;
    var phi_3864_: u32;
    var phi_3865_: bool;
    var phi_3896_: bool;
    var phi_3897_: bool;
    var phi_3898_: bool;
    var phi_3899_: bool;
    var phi_3900_: bool;
    var phi_3901_: bool;
    var phi_3902_: bool;
    var phi_3903_: bool;
    var phi_3904_: bool;
    var phi_3905_: bool;
    var phi_3906_: bool;
    var phi_3907_: bool;
    var phi_3908_: type_38;
    var phi_3909_: bool;
    var phi_3910_: type_38;
    var phi_3911_: bool;
    var phi_3912_: bool;
    var phi_3913_: bool;
    var phi_3914_: bool;
    var phi_3915_: type_38;
    var phi_3916_: bool;
    var phi_3917_: type_38;
    var phi_3918_: bool;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3921_: bool;
    var phi_3922_: bool;
    var phi_3930_: type_38;
    var phi_3931_: bool;
    var phi_3932_: type_38;
    var phi_3933_: bool;
    var phi_3934_: bool;
    var phi_3935_: bool;
    var phi_3936_: bool;
    var phi_3937_: bool;
    var phi_4360_: type_9;
    var phi_4363_: f32;
    var phi_4365_: f32;
    var phi_4367_: f32;
    var phi_4369_: f32;
    var phi_4371_: bool;
    var phi_4373_: u32;
    var phi_4524_: array<f32, 3>;
    var phi_4590_: type_14;
    var phi_4593_: f32;
    var phi_4591_: type_14;
    var phi_4634_: type_15;
    var phi_4594_: f32;
    var local_20: f32;
    var phi_4647_: f32;
    var phi_4770_: type_30;
    var phi_4771_: bool;
    var phi_4772_: type_30;
    var phi_4773_: bool;
    var phi_4781_: type_30;
    var phi_4952_: bool;
    var phi_4953_: bool;
    var phi_4954_: bool;
    var phi_4955_: bool;
    var phi_4956_: bool;
    var phi_4957_: bool;
    var phi_5258_: bool;
    var phi_5259_: bool;
    var phi_5260_: bool;
    var phi_5261_: bool;
    var phi_5262_: bool;
    var phi_5263_: bool;
    var phi_5271_: bool;
    var phi_5378_: f32;
    var phi_5379_: bool;
    var phi_5380_: f32;
    var phi_5381_: bool;
    var phi_5382_: f32;
    var phi_5383_: bool;
    var phi_5384_: bool;
    var phi_5446_: f32;
    var phi_5447_: bool;
    var phi_5448_: f32;
    var phi_5449_: bool;
    var phi_5450_: f32;
    var phi_5451_: bool;
    var phi_5452_: bool;
    var phi_5519_: f32;
    var phi_5520_: bool;
    var phi_5521_: f32;
    var phi_5522_: bool;
    var phi_5523_: f32;
    var phi_5524_: bool;
    var phi_5525_: bool;
    var phi_5587_: f32;
    var phi_5588_: bool;
    var phi_5589_: f32;
    var phi_5590_: bool;
    var phi_5591_: f32;
    var phi_5592_: bool;
    var phi_5593_: bool;
    var phi_6122_: f32;
    var phi_6123_: f32;
    var phi_6124_: bool;
    var phi_6126_: f32;
    var phi_6127_: f32;
    var phi_6128_: f32;
    var phi_6130_: bool;
    var phi_6131_: bool;
    var phi_6133_: bool;
    var phi_6134_: f32;
    var phi_6135_: f32;
    var phi_6136_: f32;
    var phi_6138_: bool;
    var phi_6139_: bool;
    var phi_6140_: bool;
    var phi_6142_: bool;
    var phi_6143_: f32;
    var phi_6144_: f32;
    var phi_6145_: f32;
    var phi_6147_: bool;
    var phi_6148_: bool;
    var phi_6149_: bool;
    var phi_6151_: bool;
    var phi_6484_: f32;
    var phi_6486_: u32;
    var phi_6487_: f32;
    var phi_6488_: bool;
    var phi_6489_: bool;
    var phi_6490_: bool;
    var phi_6491_: u32;
    var phi_6492_: f32;
    var phi_6493_: f32;
    var phi_6494_: f32;
    var phi_6495_: f32;
    var phi_6496_: bool;
    var phi_6497_: u32;
    var phi_6498_: bool;
    var phi_6499_: bool;
    var phi_6500_: bool;
    var phi_6501_: bool;
    var phi_6503_: bool;
    var phi_6531_: f32;
    var phi_6532_: f32;
    var phi_6533_: f32;
    var phi_6534_: f32;
    var phi_6535_: bool;
    var phi_6536_: u32;
    var phi_6537_: bool;
    var phi_6538_: bool;
    var phi_6539_: bool;
    var phi_6540_: bool;
    var phi_6542_: bool;
    var phi_4364_: f32;
    var phi_4366_: f32;
    var phi_4368_: f32;
    var phi_4370_: f32;
    var phi_4372_: bool;
    var phi_4374_: u32;
    var phi_6543_: f32;
    var phi_6545_: bool;
    var phi_6546_: bool;
    var phi_6547_: bool;
    var phi_6548_: bool;
    var phi_6550_: bool;
    var phi_6551_: bool;
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
    var phi_6619_: f32;
    var phi_6620_: bool;
    var phi_6621_: bool;
    var phi_6622_: bool;
    var phi_6623_: bool;
    var phi_6624_: bool;
    var phi_6625_: type_38;
    var phi_6626_: bool;
    var phi_6627_: f32;
    var phi_6628_: type_38;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6631_: bool;
    var phi_6632_: bool;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: type_38;
    var local_36: f32;
    var local_37: f32;
    var phi_6650_: type_33;
    var phi_6651_: bool;
    var local_38: f32;
    var phi_6657_: type_33;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: bool;
    var phi_6661_: bool;
    var local_39: bool;
    var local_40: type_38;
    var phi_6703_: type_33;
    var phi_6704_: type_33;
    var phi_6705_: bool;
    var phi_6749_: type_31;
    var phi_6789_: bool;
    var phi_6805_: bool;
    var phi_6832_: type_9;
    var phi_6861_: bool;
    var phi_6862_: bool;
    var phi_6905_: u32;
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
                if (_e481 <= 65536f) {
                    phi_1410_ = (_e481 >= (1f / 65536f));
                } else {
                    phi_1410_ = false;
                }
                let _e486 = phi_1410_;
                if _e486 {
                    phi_1508_ = type_32();
                    phi_1509_ = true;
                } else {
                    if (_e481 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e481) & 2139095040u) != 2139095040u) {
                            let _e493 = (2130706432u - (bitcast<u32>(_e481) & 2139095040u));
                            let _e496 = bitcast<f32>(select(8388608u, _e493, (_e493 > 8388608u)));
                            phi_1504_ = type_32(type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e349.member[0][0] * _e496), (_e349.member[0][1] * _e496), (_e349.member[0][2] * _e496)), array<f32, 3>((_e349.member[1][0] * _e496), (_e349.member[1][1] * _e496), (_e349.member[1][2] * _e496))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_1[0][0] * _e496), (_e349.member_1[0][1] * _e496), (_e349.member_1[0][2] * _e496)), array<f32, 3>((_e349.member_1[1][0] * _e496), (_e349.member_1[1][1] * _e496), (_e349.member_1[1][2] * _e496))), array<array<f32, 3>, 2>(array<f32, 3>((_e349.member_2[0][0] * _e496), (_e349.member_2[0][1] * _e496), (_e349.member_2[0][2] * _e496)), array<f32, 3>((_e349.member_2[1][0] * _e496), (_e349.member_2[1][1] * _e496), (_e349.member_2[1][2] * _e496))), ((_e349.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e496)), (0f * _e496));
                            phi_1505_ = false;
                        } else {
                            phi_1504_ = type_32();
                            phi_1505_ = true;
                        }
                        let _e562 = phi_1504_;
                        let _e564 = phi_1505_;
                        phi_1506_ = _e562;
                        phi_1507_ = _e564;
                    } else {
                        phi_1506_ = type_32();
                        phi_1507_ = true;
                    }
                    let _e566 = phi_1506_;
                    let _e568 = phi_1507_;
                    phi_1508_ = _e566;
                    phi_1509_ = _e568;
                }
                let _e570 = phi_1508_;
                let _e572 = phi_1509_;
                if _e572 {
                    phi_1514_ = type_32(_e349, 0f);
                } else {
                    phi_1514_ = _e570;
                }
                let _e575 = phi_1514_;
                local_7 = type_29(array<array<f32, 3>, 2>(array<f32, 3>(_e575.member.member[0][0], _e575.member.member[0][1], _e575.member.member[0][2]), array<f32, 3>(_e575.member.member[1][0], _e575.member.member[1][1], _e575.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e575.member.member_1[0][0], _e575.member.member_1[0][1], _e575.member.member_1[0][2]), array<f32, 3>(_e575.member.member_1[1][0], _e575.member.member_1[1][1], _e575.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e575.member.member_2[0][0], _e575.member.member_2[0][1], _e575.member.member_2[0][2]), array<f32, 3>(_e575.member.member_2[1][0], _e575.member.member_2[1][1], _e575.member.member_2[1][2])), _e575.member.member_3);
                let _e617 = local_7.member_1[0u];
                let _e623 = local_7.member_2[0u];
                let _e629 = ((_e617[1] * _e623[2]) - (_e617[2] * _e623[1]));
                let _e632 = ((_e617[2] * _e623[0]) - (_e617[0] * _e623[2]));
                let _e635 = ((_e617[0] * _e623[1]) - (_e617[1] * _e623[0]));
                let _e638 = local_7.member_1[1u];
                let _e644 = local_7.member_2[1u];
                let _e650 = ((_e638[1] * _e644[2]) - (_e638[2] * _e644[1]));
                let _e653 = ((_e638[2] * _e644[0]) - (_e638[0] * _e644[2]));
                let _e656 = ((_e638[0] * _e644[1]) - (_e638[1] * _e644[0]));
                let _e659 = local_7.member_1[0u];
                let _e665 = local_7.member_2[1u];
                let _e680 = local_7.member_1[1u];
                let _e686 = local_7.member_2[0u];
                let _e699 = (((_e659[1] * _e665[2]) - (_e659[2] * _e665[1])) + ((_e680[1] * _e686[2]) - (_e680[2] * _e686[1])));
                let _e700 = (((_e659[2] * _e665[0]) - (_e659[0] * _e665[2])) + ((_e680[2] * _e686[0]) - (_e680[0] * _e686[2])));
                let _e701 = (((_e659[0] * _e665[1]) - (_e659[1] * _e665[0])) + ((_e680[0] * _e686[1]) - (_e680[1] * _e686[0])));
                let _e704 = local_7.member[0u];
                let _e712 = (((_e704[0] * _e629) + (_e704[1] * _e632)) + (_e704[2] * _e635));
                let _e715 = local_7.member[1u];
                let _e726 = local_7.member[0u];
                let _e735 = ((((_e715[0] * _e629) + (_e715[1] * _e632)) + (_e715[2] * _e635)) + (((_e726[0] * _e699) + (_e726[1] * _e700)) + (_e726[2] * _e701)));
                let _e738 = local_7.member[0u];
                let _e749 = local_7.member[1u];
                let _e758 = ((((_e738[0] * _e650) + (_e738[1] * _e653)) + (_e738[2] * _e656)) + (((_e749[0] * _e699) + (_e749[1] * _e700)) + (_e749[2] * _e701)));
                let _e761 = local_7.member[1u];
                let _e769 = (((_e761[0] * _e650) + (_e761[1] * _e653)) + (_e761[2] * _e656));
                let _e772 = local_7.member[0u];
                let _e778 = select(_e772[0], -(_e772[0]), (_e772[0] < 0f));
                let _e781 = select(_e772[1], -(_e772[1]), (_e772[1] < 0f));
                let _e783 = select(_e781, _e778, (_e778 > _e781));
                let _e786 = select(_e772[2], -(_e772[2]), (_e772[2] < 0f));
                let _e788 = select(_e786, _e783, (_e783 > _e786));
                let _e791 = local_7.member[1u];
                let _e797 = select(_e791[0], -(_e791[0]), (_e791[0] < 0f));
                let _e800 = select(_e791[1], -(_e791[1]), (_e791[1] < 0f));
                let _e802 = select(_e800, _e797, (_e797 > _e800));
                let _e805 = select(_e791[2], -(_e791[2]), (_e791[2] < 0f));
                let _e807 = select(_e805, _e802, (_e802 > _e805));
                let _e811 = local_7.member_3;
                let _e812 = (select(_e807, _e788, (_e788 > _e807)) + _e811);
                let _e815 = local_7.member_1[0u];
                let _e821 = select(_e815[0], -(_e815[0]), (_e815[0] < 0f));
                let _e824 = select(_e815[1], -(_e815[1]), (_e815[1] < 0f));
                let _e826 = select(_e824, _e821, (_e821 > _e824));
                let _e829 = select(_e815[2], -(_e815[2]), (_e815[2] < 0f));
                let _e831 = select(_e829, _e826, (_e826 > _e829));
                let _e834 = local_7.member_1[1u];
                let _e840 = select(_e834[0], -(_e834[0]), (_e834[0] < 0f));
                let _e843 = select(_e834[1], -(_e834[1]), (_e834[1] < 0f));
                let _e845 = select(_e843, _e840, (_e840 > _e843));
                let _e848 = select(_e834[2], -(_e834[2]), (_e834[2] < 0f));
                let _e850 = select(_e848, _e845, (_e845 > _e848));
                let _e854 = local_7.member_3;
                let _e855 = (select(_e850, _e831, (_e831 > _e850)) + _e854);
                let _e858 = local_7.member_2[0u];
                let _e864 = select(_e858[0], -(_e858[0]), (_e858[0] < 0f));
                let _e867 = select(_e858[1], -(_e858[1]), (_e858[1] < 0f));
                let _e869 = select(_e867, _e864, (_e864 > _e867));
                let _e872 = select(_e858[2], -(_e858[2]), (_e858[2] < 0f));
                let _e874 = select(_e872, _e869, (_e869 > _e872));
                let _e877 = local_7.member_2[1u];
                let _e883 = select(_e877[0], -(_e877[0]), (_e877[0] < 0f));
                let _e886 = select(_e877[1], -(_e877[1]), (_e877[1] < 0f));
                let _e888 = select(_e886, _e883, (_e883 > _e886));
                let _e891 = select(_e877[2], -(_e877[2]), (_e877[2] < 0f));
                let _e893 = select(_e891, _e888, (_e888 > _e891));
                let _e897 = local_7.member_3;
                let _e898 = (select(_e893, _e874, (_e874 > _e893)) + _e897);
                let _e907 = local_7.member_3;
                let _e922 = (((((_e812 * 8f) * ((_e855 * 8f) * _e898)) * (0.000000059604645f * (524f / 64f))) + ((_e907 * 19f) * ((_e812 * (_e855 + _e898)) + (_e855 * _e898)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e812) * ((1f + _e855) * (1f + _e898)))));
                let _e923 = (_e712 * 3f);
                let _e924 = (_e769 * 3f);
                let _e926 = select(_e924, _e923, (_e923 < _e924));
                let _e928 = select(_e758, _e735, (_e735 < _e758));
                let _e930 = select(_e928, _e926, (_e926 < _e928));
                let _e932 = select(_e924, _e923, (_e923 > _e924));
                let _e934 = select(_e758, _e735, (_e735 > _e758));
                let _e937 = -(select(_e934, _e932, (_e932 > _e934)));
                if (select(_e937, _e930, (_e930 > _e937)) > _e922) {
                    phi_6703_ = type_33(0u, type_33().member_1);
                    phi_6704_ = type_33();
                    phi_6705_ = true;
                } else {
                    let _e944 = select(_e712, -(_e712), (_e712 < 0f));
                    let _e947 = select(_e735, -(_e735), (_e735 < 0f));
                    let _e949 = select(_e947, _e944, (_e944 > _e947));
                    let _e952 = select(_e758, -(_e758), (_e758 < 0f));
                    let _e955 = select(_e769, -(_e769), (_e769 < 0f));
                    let _e957 = select(_e955, _e952, (_e952 > _e955));
                    let _e959 = select(_e957, _e949, (_e949 > _e957));
                    let _e960 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                    if (_e959 >= _e960) {
                        phi_2206_ = (_e959 <= (1f / _e960));
                    } else {
                        phi_2206_ = false;
                    }
                    let _e965 = phi_2206_;
                    if _e965 {
                        phi_2218_ = (1f / _e959);
                    } else {
                        phi_2218_ = 0f;
                    }
                    let _e972 = phi_2218_;
                    let _e973 = (_e351 * 0.0625f);
                    local_5 = type_36(array<f32, 4>(_e712, _e735, _e758, _e769), ((_e922 * 0.34f) + (_e959 * select(2f, (0.000000059604645f * 256f), _e965))), _e972, select(_e973, 0.00000000000022737368f, (0.00000000000022737368f < _e973)));
                    let _e980 = local_5.member[0u];
                    let _e983 = local_5.member[1u];
                    let _e986 = local_5.member[2u];
                    let _e989 = local_5.member[3u];
                    let _e996 = local_5.member_2;
                    let _e997 = ((_e983 - (3f * _e980)) * _e996);
                    let _e999 = local_5.member_2;
                    let _e1000 = ((_e986 - _e983) * _e999);
                    let _e1002 = local_5.member_2;
                    let _e1003 = (((3f * _e989) - _e986) * _e1002);
                    local_3[0u] = 0f;
                    local_3[1u] = 1f;
                    local_3[2u] = 1f;
                    local_3[3u] = 1f;
                    let _e1010 = ((_e1000 * _e1000) - (_e997 * _e1003));
                    if (_e1010 > 0f) {
                        if (_e1010 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2346_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1010 > 0f));
                        } else {
                            phi_2289_ = type_14(0i, 5i);
                            phi_2292_ = bitcast<f32>(((bitcast<u32>(_e1010) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1019 = phi_2289_;
                                let _e1021 = phi_2292_;
                                local_9 = _e1021;
                                if (_e1019.member < _e1019.member_1) {
                                    let _e1028 = (_e1019.member + 1i);
                                    phi_2290_ = type_14(select(_e1028, type_15().member_1, select(false, true, ((false == (_e1028 > _e1019.member)) != false))), _e1019.member_1);
                                    phi_2333_ = type_15(1u, _e1019.member);
                                } else {
                                    phi_2290_ = _e1019;
                                    phi_2333_ = type_15(0u, type_15().member_1);
                                }
                                let _e1039 = phi_2290_;
                                let _e1041 = phi_2333_;
                                let _e1044 = (bitcast<i32>(_e1041.member) != 0i);
                                if _e1044 {
                                    phi_2293_ = (0.5f * (_e1021 + (_e1010 / _e1021)));
                                } else {
                                    phi_2293_ = f32();
                                }
                                let _e1049 = phi_2293_;
                                continue;
                                continuing {
                                    phi_2289_ = _e1039;
                                    phi_2292_ = _e1049;
                                    break if !(_e1044);
                                }
                            }
                            let _e1054 = local_9;
                            phi_2346_ = (_e1054 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1060 = phi_2346_;
                        let _e1065 = -((_e1000 + select(_e1060, -(_e1060), (_e1000 < 0f))));
                        local_4[0u] = (_e1065 / (_e1065 + _e1003));
                        local_4[1u] = (_e997 / (_e997 + _e1065));
                        let _e1074 = local_4[1u];
                        let _e1075 = local_4[0u];
                        if (_e1074 < _e1075) {
                            let _e1078 = local_4[1u];
                            let _e1080 = local_4[0u];
                            local_4[0u] = _e1078;
                            local_4[1u] = _e1080;
                        }
                        phi_2377_ = type_9(0u, 2u);
                        phi_2380_ = 1u;
                        loop {
                            let _e1084 = phi_2377_;
                            let _e1086 = phi_2380_;
                            local_41 = _e1086;
                            let _e1089 = (_e1084.member < _e1084.member_1);
                            let _e1100 = select(type_9().member_1, _e1084.member, _e1089);
                            let _e1102 = (bitcast<i32>(select(0u, 1u, _e1089)) != 0i);
                            if _e1102 {
                                let _e1104 = local_4[_e1100];
                                if (_e1104 > 0f) {
                                    let _e1107 = local_4[_e1100];
                                    if (_e1107 < 1f) {
                                        let _e1110 = local_4[_e1100];
                                        local_3[_e1086] = _e1110;
                                        phi_2447_ = (_e1086 + 1u);
                                    } else {
                                        phi_2447_ = _e1086;
                                    }
                                    let _e1114 = phi_2447_;
                                    phi_2448_ = _e1114;
                                } else {
                                    phi_2448_ = _e1086;
                                }
                                let _e1116 = phi_2448_;
                                phi_2381_ = _e1116;
                            } else {
                                phi_2381_ = u32();
                            }
                            let _e1118 = phi_2381_;
                            continue;
                            continuing {
                                phi_2377_ = type_9(select(_e1084.member, (_e1084.member + 1u), _e1089), select(_e1084.member_1, _e1084.member_1, _e1089));
                                phi_2380_ = _e1118;
                                break if !(_e1102);
                            }
                        }
                        let _e3760 = local_41;
                        phi_2449_ = _e3760;
                    } else {
                        phi_2449_ = 1u;
                    }
                    let _e1121 = phi_2449_;
                    local_3[_e1121] = 1f;
                    let _e1123 = local_3;
                    local_6 = _e1123;
                    let _e1124 = (_e351 * 0.99f);
                    let _e1125 = (1f - _e353);
                    let _e1128 = local_5.member[0u];
                    let _e1131 = local_5.member[1u];
                    let _e1134 = local_5.member[2u];
                    let _e1137 = local_5.member[3u];
                    let _e1148 = ((((_e1128 * _e1125) + (_e1131 * _e353)) * (_e1125 * _e1125)) + (((_e1134 * _e1125) + (_e1137 * _e353)) * (_e353 * _e353)));
                    let _e1153 = local_5.member_1;
                    phi_2505_ = type_9(select(1u, 0u, !((select(_e1148, -(_e1148), (_e1148 < 0f)) > _e1153))), (_e1121 + 1u));
                    loop {
                        let _e1160 = phi_2505_;
                        let _e1163 = (_e1160.member < _e1160.member_1);
                        let _e1174 = select(type_9().member_1, _e1160.member, _e1163);
                        if (bitcast<i32>(select(0u, 1u, _e1163)) != 0i) {
                            if (_e1174 > 0u) {
                                let _e1181 = local_6[(_e1174 - 1u)];
                                let _e1183 = select(_e353, _e1181, (_e1181 > _e353));
                                let _e1185 = local_6[_e1174];
                                let _e1187 = select(_e355, _e1185, (_e1185 < _e355));
                                if (_e1183 <= _e1187) {
                                    let _e1189 = function_4((&local_5), _e357, _e1183, _e1187);
                                    if _e1189 {
                                        phi_3908_ = type_38();
                                        phi_3909_ = bool();
                                        phi_3910_ = type_38();
                                        phi_3911_ = false;
                                        phi_3912_ = false;
                                        phi_3913_ = false;
                                        phi_3914_ = false;
                                    } else {
                                        let _e1190 = (1f - _e1183);
                                        let _e1193 = local_5.member[0u];
                                        let _e1196 = local_5.member[1u];
                                        let _e1199 = local_5.member[2u];
                                        let _e1202 = local_5.member[3u];
                                        let _e1213 = ((((_e1193 * _e1190) + (_e1196 * _e1183)) * (_e1190 * _e1190)) + (((_e1199 * _e1190) + (_e1202 * _e1183)) * (_e1183 * _e1183)));
                                        let _e1214 = (1f - _e1187);
                                        let _e1217 = local_5.member[0u];
                                        let _e1220 = local_5.member[1u];
                                        let _e1223 = local_5.member[2u];
                                        let _e1226 = local_5.member[3u];
                                        let _e1237 = ((((_e1217 * _e1214) + (_e1220 * _e1187)) * (_e1214 * _e1214)) + (((_e1223 * _e1214) + (_e1226 * _e1187)) * (_e1187 * _e1187)));
                                        let _e1242 = local_5.member_1;
                                        let _e1243 = (select(_e1213, -(_e1213), (_e1213 < 0f)) > _e1242);
                                        let _e1248 = local_5.member_1;
                                        let _e1249 = (select(_e1237, -(_e1237), (_e1237 < 0f)) > _e1248);
                                        let _e1257 = select(select(bool(), select(bool(), ((_e1213 > 0f) != (_e1237 > 0f)), _e1249), _e1243), false, select(true, select(true, false, _e1249), _e1243));
                                        if _e1243 {
                                            if _e1249 {
                                                phi_2661_ = type_38(select(1f, type_38().member, _e1257), select(0f, type_38().member_1, _e1257), select(_e1257, type_38().member_2, _e1257));
                                                phi_2662_ = _e1257;
                                            } else {
                                                phi_2661_ = type_38();
                                                phi_2662_ = true;
                                            }
                                            let _e1266 = phi_2661_;
                                            let _e1268 = phi_2662_;
                                            phi_2663_ = _e1266;
                                            phi_2664_ = _e1268;
                                        } else {
                                            phi_2663_ = type_38();
                                            phi_2664_ = true;
                                        }
                                        let _e1270 = phi_2663_;
                                        let _e1272 = phi_2664_;
                                        if _e1272 {
                                            if _e1243 {
                                                let _e1274 = select(1f, -1f, (_e1213 < 0f));
                                                let _e1276 = local_5.member_3;
                                                let _e1279 = local_5.member[0u];
                                                let _e1282 = local_5.member[1u];
                                                let _e1285 = local_5.member[2u];
                                                let _e1288 = local_5.member[3u];
                                                let _e1291 = (_e1285 - _e1282);
                                                phi_2695_ = type_9(0u, 64u);
                                                phi_2698_ = _e1187;
                                                phi_2700_ = _e1183;
                                                phi_2702_ = (0.5f * (_e1183 + _e1187));
                                                loop {
                                                    let _e1297 = phi_2695_;
                                                    let _e1299 = phi_2698_;
                                                    let _e1301 = phi_2700_;
                                                    let _e1303 = phi_2702_;
                                                    local_12 = _e1301;
                                                    let _e1306 = (_e1297.member < _e1297.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1306)) != 0i) {
                                                        let _e1318 = (1f - _e1303);
                                                        let _e1321 = local_5.member[0u];
                                                        let _e1324 = local_5.member[1u];
                                                        let _e1327 = local_5.member[2u];
                                                        let _e1330 = local_5.member[3u];
                                                        let _e1344 = local_5.member_1;
                                                        let _e1345 = ((_e1274 * ((((_e1321 * _e1318) + (_e1324 * _e1303)) * (_e1318 * _e1318)) + (((_e1327 * _e1318) + (_e1330 * _e1303)) * (_e1303 * _e1303)))) - _e1344);
                                                        let _e1346 = (_e1345 > 0f);
                                                        let _e1347 = select(_e1303, _e1299, _e1346);
                                                        let _e1348 = select(_e1301, _e1303, _e1346);
                                                        let _e1350 = ((_e1347 - _e1348) > _e1276);
                                                        if _e1350 {
                                                            let _e1351 = (1f - _e1303);
                                                            let _e1363 = (-(_e1345) / (_e1274 * (((((_e1282 - (3f * _e1279)) * _e1351) + (_e1291 * _e1303)) * _e1351) + (((_e1291 * _e1351) + (((3f * _e1288) - _e1285) * _e1303)) * _e1303))));
                                                            let _e1370 = ((_e1303 + _e1363) + select(-((0.5f * _e1276)), (0.5f * _e1276), (_e1345 > 0f)));
                                                            if (_e1370 > _e1348) {
                                                                phi_2812_ = select(true, select(true, false, (select(_e1363, -(_e1363), (_e1363 < 0f)) < (0.5f * (_e1347 - _e1348)))), (_e1370 < _e1347));
                                                            } else {
                                                                phi_2812_ = true;
                                                            }
                                                            let _e1382 = phi_2812_;
                                                            phi_2819_ = select(_e1370, (0.5f * (_e1348 + _e1347)), _e1382);
                                                            phi_2820_ = false;
                                                        } else {
                                                            phi_2819_ = f32();
                                                            phi_2820_ = true;
                                                        }
                                                        let _e1387 = phi_2819_;
                                                        let _e1389 = phi_2820_;
                                                        phi_2699_ = _e1347;
                                                        phi_2701_ = _e1348;
                                                        phi_2703_ = _e1387;
                                                        phi_2821_ = _e1348;
                                                        phi_2822_ = _e1350;
                                                        phi_2823_ = _e1389;
                                                    } else {
                                                        phi_2699_ = f32();
                                                        phi_2701_ = f32();
                                                        phi_2703_ = f32();
                                                        phi_2821_ = f32();
                                                        phi_2822_ = false;
                                                        phi_2823_ = false;
                                                    }
                                                    let _e1391 = phi_2699_;
                                                    let _e1393 = phi_2701_;
                                                    let _e1395 = phi_2703_;
                                                    let _e1397 = phi_2821_;
                                                    let _e1399 = phi_2822_;
                                                    let _e1401 = phi_2823_;
                                                    local_10 = _e1401;
                                                    local_11 = _e1397;
                                                    continue;
                                                    continuing {
                                                        phi_2695_ = type_9(select(_e1297.member, (_e1297.member + 1u), _e1306), select(_e1297.member_1, _e1297.member_1, _e1306));
                                                        phi_2698_ = _e1391;
                                                        phi_2700_ = _e1393;
                                                        phi_2702_ = _e1395;
                                                        break if !(_e1399);
                                                    }
                                                }
                                                let _e1404 = local_10;
                                                let _e1406 = local_11;
                                                let _e1408 = local_12;
                                                phi_2828_ = select(_e1408, _e1406, _e1404);
                                            } else {
                                                phi_2828_ = _e1183;
                                            }
                                            let _e1411 = phi_2828_;
                                            if _e1249 {
                                                let _e1415 = local_5.member_3;
                                                let _e1417 = local_5.member_3;
                                                phi_2844_ = type_9(0u, 64u);
                                                phi_2847_ = (_e1415 + _e1417);
                                                loop {
                                                    let _e1420 = phi_2844_;
                                                    let _e1422 = phi_2847_;
                                                    let _e1425 = (_e1420.member < _e1420.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1425)) != 0i) {
                                                        let _e1437 = (_e1411 + _e1422);
                                                        if (_e1437 < _e1187) {
                                                            let _e1439 = (1f - _e1437);
                                                            let _e1442 = local_5.member[0u];
                                                            let _e1445 = local_5.member[1u];
                                                            let _e1448 = local_5.member[2u];
                                                            let _e1451 = local_5.member[3u];
                                                            let _e1465 = local_5.member_1;
                                                            let _e1466 = ((select(1f, -1f, (_e1237 < 0f)) * ((((_e1442 * _e1439) + (_e1445 * _e1437)) * (_e1439 * _e1439)) + (((_e1448 * _e1439) + (_e1451 * _e1437)) * (_e1437 * _e1437)))) > _e1465);
                                                            phi_2912_ = select((_e1422 + _e1422), f32(), _e1466);
                                                            phi_2913_ = select(true, false, _e1466);
                                                            phi_2914_ = _e1466;
                                                            phi_2915_ = false;
                                                        } else {
                                                            phi_2912_ = f32();
                                                            phi_2913_ = false;
                                                            phi_2914_ = false;
                                                            phi_2915_ = true;
                                                        }
                                                        let _e1471 = phi_2912_;
                                                        let _e1473 = phi_2913_;
                                                        let _e1475 = phi_2914_;
                                                        let _e1477 = phi_2915_;
                                                        phi_2916_ = _e1437;
                                                        phi_2848_ = _e1471;
                                                        phi_2917_ = _e1473;
                                                        phi_2918_ = _e1475;
                                                        phi_2919_ = _e1477;
                                                        phi_2920_ = false;
                                                    } else {
                                                        phi_2916_ = f32();
                                                        phi_2848_ = f32();
                                                        phi_2917_ = false;
                                                        phi_2918_ = false;
                                                        phi_2919_ = false;
                                                        phi_2920_ = true;
                                                    }
                                                    let _e1479 = phi_2916_;
                                                    let _e1481 = phi_2848_;
                                                    let _e1483 = phi_2917_;
                                                    let _e1485 = phi_2918_;
                                                    let _e1487 = phi_2919_;
                                                    let _e1489 = phi_2920_;
                                                    local_13 = _e1485;
                                                    local_14 = _e1487;
                                                    local_15 = _e1485;
                                                    local_16 = _e1489;
                                                    local_17 = _e1479;
                                                    continue;
                                                    continuing {
                                                        phi_2844_ = type_9(select(_e1420.member, (_e1420.member + 1u), _e1425), select(_e1420.member_1, _e1420.member_1, _e1425));
                                                        phi_2847_ = _e1481;
                                                        break if !(_e1483);
                                                    }
                                                }
                                                let _e1492 = local_13;
                                                let _e1494 = local_14;
                                                let _e1497 = local_15;
                                                let _e1499 = local_16;
                                                let _e1503 = local_17;
                                                phi_2934_ = select(_e1503, _e1187, select(select(_e1499, false, _e1497), true, select(_e1494, false, _e1492)));
                                            } else {
                                                phi_2934_ = _e1187;
                                            }
                                            let _e1506 = phi_2934_;
                                            phi_2936_ = type_38(_e1411, _e1506, _e1257);
                                        } else {
                                            phi_2936_ = _e1270;
                                        }
                                        let _e1509 = phi_2936_;
                                        if (_e1509.member > _e1509.member_1) {
                                            phi_3903_ = bool();
                                            phi_3904_ = true;
                                            phi_3905_ = false;
                                            phi_3906_ = false;
                                            phi_3907_ = false;
                                        } else {
                                            let _e1514 = (_e1509.member > _e357);
                                            if _e1514 {
                                                phi_3899_ = bool();
                                                phi_3900_ = false;
                                                phi_3901_ = false;
                                                phi_3902_ = false;
                                            } else {
                                                let _e1518 = ((_e1509.member_1 - _e1509.member) * 0.5f);
                                                let _e1519 = (_e1509.member + _e1518);
                                                let _e1521 = (_e1518 + (0.000000059604645f * 4f));
                                                let _e1523 = local_7.member_3;
                                                let _e1526 = local_7.member[0u];
                                                let _e1532 = select(_e1526[0], -(_e1526[0]), (_e1526[0] < 0f));
                                                let _e1535 = select(_e1526[1], -(_e1526[1]), (_e1526[1] < 0f));
                                                let _e1537 = select(_e1535, _e1532, (_e1532 > _e1535));
                                                let _e1540 = select(_e1526[2], -(_e1526[2]), (_e1526[2] < 0f));
                                                let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                                let _e1544 = local_7.member[1u];
                                                let _e1550 = select(_e1544[0], -(_e1544[0]), (_e1544[0] < 0f));
                                                let _e1553 = select(_e1544[1], -(_e1544[1]), (_e1544[1] < 0f));
                                                let _e1555 = select(_e1553, _e1550, (_e1550 > _e1553));
                                                let _e1558 = select(_e1544[2], -(_e1544[2]), (_e1544[2] < 0f));
                                                let _e1560 = select(_e1558, _e1555, (_e1555 > _e1558));
                                                let _e1565 = local_7.member[0u];
                                                let _e1570 = local_7.member[1u];
                                                let _e1580 = (_e1565[0] + ((_e1570[0] - _e1565[0]) * _e1519));
                                                let _e1581 = (_e1565[1] + ((_e1570[1] - _e1565[1]) * _e1519));
                                                let _e1582 = (_e1565[2] + ((_e1570[2] - _e1565[2]) * _e1519));
                                                let _e1584 = local_7.member[1u];
                                                let _e1589 = local_7.member[0u];
                                                let _e1593 = (_e1584[0] - _e1589[0]);
                                                let _e1594 = (_e1584[1] - _e1589[1]);
                                                let _e1595 = (_e1584[2] - _e1589[2]);
                                                let _e1598 = select(_e1593, -(_e1593), (_e1593 < 0f));
                                                let _e1601 = select(_e1594, -(_e1594), (_e1594 < 0f));
                                                let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                let _e1606 = select(_e1595, -(_e1595), (_e1595 < 0f));
                                                let _e1614 = ((((_e1521 * select(_e1606, _e1603, (_e1603 > _e1606))) * 1.01f) + ((select(_e1560, _e1542, (_e1542 > _e1560)) + _e1523) * (0.000000059604645f * 8f))) + _e1523);
                                                let _e1617 = select(_e1580, -(_e1580), (_e1580 < 0f));
                                                let _e1620 = select(_e1581, -(_e1581), (_e1581 < 0f));
                                                let _e1622 = select(_e1620, _e1617, (_e1617 > _e1620));
                                                let _e1625 = select(_e1582, -(_e1582), (_e1582 < 0f));
                                                let _e1628 = (select(_e1625, _e1622, (_e1622 > _e1625)) + _e1614);
                                                let _e1631 = local_7.member_3;
                                                let _e1633 = local_7.member_1[0u];
                                                let _e1639 = select(_e1633[0], -(_e1633[0]), (_e1633[0] < 0f));
                                                let _e1642 = select(_e1633[1], -(_e1633[1]), (_e1633[1] < 0f));
                                                let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                let _e1647 = select(_e1633[2], -(_e1633[2]), (_e1633[2] < 0f));
                                                let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                let _e1651 = local_7.member_1[1u];
                                                let _e1657 = select(_e1651[0], -(_e1651[0]), (_e1651[0] < 0f));
                                                let _e1660 = select(_e1651[1], -(_e1651[1]), (_e1651[1] < 0f));
                                                let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                let _e1665 = select(_e1651[2], -(_e1651[2]), (_e1651[2] < 0f));
                                                let _e1667 = select(_e1665, _e1662, (_e1662 > _e1665));
                                                let _e1672 = local_7.member_1[0u];
                                                let _e1677 = local_7.member_1[1u];
                                                let _e1687 = (_e1672[0] + ((_e1677[0] - _e1672[0]) * _e1519));
                                                let _e1688 = (_e1672[1] + ((_e1677[1] - _e1672[1]) * _e1519));
                                                let _e1689 = (_e1672[2] + ((_e1677[2] - _e1672[2]) * _e1519));
                                                let _e1691 = local_7.member_1[1u];
                                                let _e1696 = local_7.member_1[0u];
                                                let _e1700 = (_e1691[0] - _e1696[0]);
                                                let _e1701 = (_e1691[1] - _e1696[1]);
                                                let _e1702 = (_e1691[2] - _e1696[2]);
                                                let _e1705 = select(_e1700, -(_e1700), (_e1700 < 0f));
                                                let _e1708 = select(_e1701, -(_e1701), (_e1701 < 0f));
                                                let _e1710 = select(_e1708, _e1705, (_e1705 > _e1708));
                                                let _e1713 = select(_e1702, -(_e1702), (_e1702 < 0f));
                                                let _e1721 = ((((_e1521 * select(_e1713, _e1710, (_e1710 > _e1713))) * 1.01f) + ((select(_e1667, _e1649, (_e1649 > _e1667)) + _e1631) * (0.000000059604645f * 8f))) + _e1631);
                                                let _e1724 = select(_e1687, -(_e1687), (_e1687 < 0f));
                                                let _e1727 = select(_e1688, -(_e1688), (_e1688 < 0f));
                                                let _e1729 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                let _e1732 = select(_e1689, -(_e1689), (_e1689 < 0f));
                                                let _e1735 = (select(_e1732, _e1729, (_e1729 > _e1732)) + _e1721);
                                                let _e1738 = local_7.member_3;
                                                let _e1740 = local_7.member_2[0u];
                                                let _e1746 = select(_e1740[0], -(_e1740[0]), (_e1740[0] < 0f));
                                                let _e1749 = select(_e1740[1], -(_e1740[1]), (_e1740[1] < 0f));
                                                let _e1751 = select(_e1749, _e1746, (_e1746 > _e1749));
                                                let _e1754 = select(_e1740[2], -(_e1740[2]), (_e1740[2] < 0f));
                                                let _e1756 = select(_e1754, _e1751, (_e1751 > _e1754));
                                                let _e1758 = local_7.member_2[1u];
                                                let _e1764 = select(_e1758[0], -(_e1758[0]), (_e1758[0] < 0f));
                                                let _e1767 = select(_e1758[1], -(_e1758[1]), (_e1758[1] < 0f));
                                                let _e1769 = select(_e1767, _e1764, (_e1764 > _e1767));
                                                let _e1772 = select(_e1758[2], -(_e1758[2]), (_e1758[2] < 0f));
                                                let _e1774 = select(_e1772, _e1769, (_e1769 > _e1772));
                                                let _e1779 = local_7.member_2[0u];
                                                let _e1784 = local_7.member_2[1u];
                                                let _e1794 = (_e1779[0] + ((_e1784[0] - _e1779[0]) * _e1519));
                                                let _e1795 = (_e1779[1] + ((_e1784[1] - _e1779[1]) * _e1519));
                                                let _e1796 = (_e1779[2] + ((_e1784[2] - _e1779[2]) * _e1519));
                                                let _e1798 = local_7.member_2[1u];
                                                let _e1803 = local_7.member_2[0u];
                                                let _e1807 = (_e1798[0] - _e1803[0]);
                                                let _e1808 = (_e1798[1] - _e1803[1]);
                                                let _e1809 = (_e1798[2] - _e1803[2]);
                                                let _e1812 = select(_e1807, -(_e1807), (_e1807 < 0f));
                                                let _e1815 = select(_e1808, -(_e1808), (_e1808 < 0f));
                                                let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
                                                let _e1820 = select(_e1809, -(_e1809), (_e1809 < 0f));
                                                let _e1828 = ((((_e1521 * select(_e1820, _e1817, (_e1817 > _e1820))) * 1.01f) + ((select(_e1774, _e1756, (_e1756 > _e1774)) + _e1738) * (0.000000059604645f * 8f))) + _e1738);
                                                let _e1831 = select(_e1794, -(_e1794), (_e1794 < 0f));
                                                let _e1834 = select(_e1795, -(_e1795), (_e1795 < 0f));
                                                let _e1836 = select(_e1834, _e1831, (_e1831 > _e1834));
                                                let _e1839 = select(_e1796, -(_e1796), (_e1796 < 0f));
                                                let _e1842 = (select(_e1839, _e1836, (_e1836 > _e1839)) + _e1828);
                                                let _e1845 = ((_e1688 * _e1796) - (_e1689 * _e1795));
                                                let _e1848 = ((_e1689 * _e1794) - (_e1687 * _e1796));
                                                let _e1851 = ((_e1687 * _e1795) - (_e1688 * _e1794));
                                                let _e1866 = select(false, (select(_e1845, -(_e1845), (_e1845 < 0f)) > select(_e1851, -(_e1851), (_e1851 < 0f))), (select(_e1845, -(_e1845), (_e1845 < 0f)) > select(_e1848, -(_e1848), (_e1848 < 0f))));
                                                let _e1881 = select((select(_e1848, -(_e1848), (_e1848 < 0f)) > select(_e1851, -(_e1851), (_e1851 < 0f))), false, (select(_e1845, -(_e1845), (_e1845 < 0f)) > select(_e1848, -(_e1848), (_e1848 < 0f))));
                                                let _e1884 = select(select(_e1580, _e1581, _e1866), _e1582, _e1881);
                                                let _e1885 = select(select(_e1581, _e1582, _e1866), _e1580, _e1881);
                                                let _e1888 = select(select(_e1687, _e1688, _e1866), _e1689, _e1881);
                                                let _e1889 = select(select(_e1688, _e1689, _e1866), _e1687, _e1881);
                                                let _e1892 = select(select(_e1794, _e1795, _e1866), _e1796, _e1881);
                                                let _e1893 = select(select(_e1795, _e1796, _e1866), _e1794, _e1881);
                                                let _e1896 = ((_e1888 * _e1893) - (_e1889 * _e1892));
                                                let _e1912 = (((((_e1721 * _e1842) + (_e1735 * _e1828)) * 2.01f) + (((_e1735 * 2f) * (_e1842 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1735) * (1f + _e1842))));
                                                if (select(_e1896, -(_e1896), (_e1896 < 0f)) > _e1912) {
                                                    let _e1918 = select(1f, -1f, (_e1896 < 0f));
                                                    let _e1937 = (((((_e1614 * _e1842) + (_e1628 * _e1828)) * 2.01f) + (((_e1628 * 2f) * (_e1842 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1628) * (1f + _e1842))));
                                                    let _e1956 = (((((_e1721 * _e1628) + (_e1735 * _e1614)) * 2.01f) + (((_e1735 * 2f) * (_e1628 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1735) * (1f + _e1628))));
                                                    let _e1957 = (_e1896 * _e1918);
                                                    let _e1958 = (((_e1884 * _e1893) - (_e1885 * _e1892)) * _e1918);
                                                    let _e1959 = (((_e1888 * _e1885) - (_e1889 * _e1884)) * _e1918);
                                                    let _e1972 = (((select(_e1957, -(_e1957), (_e1957 < 0f)) + select(_e1958, -(_e1958), (_e1958 < 0f))) + select(_e1959, -(_e1959), (_e1959 < 0f))) * (0.000000059604645f * 4f));
                                                    if (_e224.member != 0u) {
                                                        phi_3773_ = array<type_16, 4>(type_16(_e1958, _e1937), type_16(_e1959, _e1956), type_16((_e1957 - _e1958), ((_e1912 + _e1937) + _e1972)), type_16((_e1957 - _e1959), ((_e1912 + _e1956) + _e1972)));
                                                    } else {
                                                        let _e1975 = ((_e1957 - _e1958) - _e1959);
                                                        let _e1978 = (((_e1912 + _e1937) + _e1956) + _e1972);
                                                        phi_3773_ = array<type_16, 4>(type_16(_e1958, _e1937), type_16(_e1959, _e1956), type_16(_e1975, _e1978), type_16(_e1975, _e1978));
                                                    }
                                                    let _e1996 = phi_3773_;
                                                    local_2 = array<type_16, 4>(type_16(_e1996[0].member, _e1996[0].member_1), type_16(_e1996[1].member, _e1996[1].member_1), type_16(_e1996[2].member, _e1996[2].member_1), type_16(_e1996[3].member, _e1996[3].member_1));
                                                    phi_3793_ = type_9(0u, 4u);
                                                    phi_3796_ = true;
                                                    loop {
                                                        let _e2015 = phi_3793_;
                                                        let _e2017 = phi_3796_;
                                                        local_19 = _e2017;
                                                        let _e2020 = (_e2015.member < _e2015.member_1);
                                                        let _e2031 = select(type_9().member_1, _e2015.member, _e2020);
                                                        if (bitcast<i32>(select(0u, 1u, _e2020)) != 0i) {
                                                            let _e2036 = local_2[_e2031].member;
                                                            let _e2039 = local_2[_e2031].member_1;
                                                            let _e2041 = (_e2036 < -(_e2039));
                                                            phi_3797_ = select((_e2017 && (_e2036 > _e2039)), bool(), _e2041);
                                                            phi_3848_ = select(true, false, _e2041);
                                                            phi_3849_ = _e2041;
                                                        } else {
                                                            phi_3797_ = bool();
                                                            phi_3848_ = false;
                                                            phi_3849_ = false;
                                                        }
                                                        let _e2047 = phi_3797_;
                                                        let _e2049 = phi_3848_;
                                                        let _e2051 = phi_3849_;
                                                        local_18 = _e2051;
                                                        continue;
                                                        continuing {
                                                            phi_3793_ = type_9(select(_e2015.member, (_e2015.member + 1u), _e2020), select(_e2015.member_1, _e2015.member_1, _e2020));
                                                            phi_3796_ = _e2047;
                                                            break if !(_e2049);
                                                        }
                                                    }
                                                    let _e2054 = local_18;
                                                    let _e2055 = select(true, false, _e2054);
                                                    let _e2057 = local_19;
                                                    phi_3863_ = select(u32(), select(2u, 1u, _e2057), _e2055);
                                                    phi_3864_ = 0u;
                                                    phi_3865_ = select(true, false, _e2055);
                                                } else {
                                                    phi_3863_ = u32();
                                                    phi_3864_ = 2u;
                                                    phi_3865_ = true;
                                                }
                                                let _e2062 = phi_3863_;
                                                let _e2064 = phi_3864_;
                                                let _e2066 = phi_3865_;
                                                let _e2067 = select(_e2062, _e2064, _e2066);
                                                let _e2068 = (_e2067 == 0u);
                                                if _e2068 {
                                                    phi_3896_ = bool();
                                                    phi_3897_ = false;
                                                    phi_3898_ = false;
                                                } else {
                                                    let _e2071 = select(false, _e1509.member_2, (_e2067 == 1u));
                                                    let _e2077 = select(true, select(true, false, ((_e1509.member_1 - _e1509.member) <= _e1124)), _e2071);
                                                    phi_3896_ = _e2071;
                                                    phi_3897_ = _e2077;
                                                    phi_3898_ = select(true, false, _e2077);
                                                }
                                                let _e2080 = phi_3896_;
                                                let _e2082 = phi_3897_;
                                                let _e2084 = phi_3898_;
                                                phi_3899_ = _e2080;
                                                phi_3900_ = _e2068;
                                                phi_3901_ = _e2082;
                                                phi_3902_ = _e2084;
                                            }
                                            let _e2086 = phi_3899_;
                                            let _e2088 = phi_3900_;
                                            let _e2090 = phi_3901_;
                                            let _e2092 = phi_3902_;
                                            phi_3903_ = _e2086;
                                            phi_3904_ = _e2088;
                                            phi_3905_ = _e2090;
                                            phi_3906_ = _e1514;
                                            phi_3907_ = _e2092;
                                        }
                                        let _e2094 = phi_3903_;
                                        let _e2096 = phi_3904_;
                                        let _e2098 = phi_3905_;
                                        let _e2100 = phi_3906_;
                                        let _e2102 = phi_3907_;
                                        phi_3908_ = _e1509;
                                        phi_3909_ = _e2094;
                                        phi_3910_ = _e1509;
                                        phi_3911_ = _e2096;
                                        phi_3912_ = _e2098;
                                        phi_3913_ = _e2100;
                                        phi_3914_ = _e2102;
                                    }
                                    let _e2104 = phi_3908_;
                                    let _e2106 = phi_3909_;
                                    let _e2108 = phi_3910_;
                                    let _e2110 = phi_3911_;
                                    let _e2112 = phi_3912_;
                                    let _e2114 = phi_3913_;
                                    let _e2116 = phi_3914_;
                                    phi_3915_ = _e2104;
                                    phi_3916_ = _e2106;
                                    phi_3917_ = _e2108;
                                    phi_3918_ = _e2110;
                                    phi_3919_ = _e2112;
                                    phi_3920_ = _e1189;
                                    phi_3921_ = _e2114;
                                    phi_3922_ = _e2116;
                                } else {
                                    phi_3915_ = type_38();
                                    phi_3916_ = bool();
                                    phi_3917_ = type_38();
                                    phi_3918_ = true;
                                    phi_3919_ = false;
                                    phi_3920_ = false;
                                    phi_3921_ = false;
                                    phi_3922_ = false;
                                }
                                let _e2118 = phi_3915_;
                                let _e2120 = phi_3916_;
                                let _e2122 = phi_3917_;
                                let _e2124 = phi_3918_;
                                let _e2126 = phi_3919_;
                                let _e2128 = phi_3920_;
                                let _e2130 = phi_3921_;
                                let _e2132 = phi_3922_;
                                phi_3930_ = _e2118;
                                phi_3931_ = _e2120;
                                phi_3932_ = _e2122;
                                phi_3933_ = select(_e2126, false, _e2124);
                                phi_3934_ = _e2124;
                                phi_3935_ = select(_e2128, false, _e2124);
                                phi_3936_ = select(_e2130, false, _e2124);
                                phi_3937_ = select(_e2132, false, _e2124);
                            } else {
                                phi_3930_ = type_38(_e353, _e353, false);
                                phi_3931_ = false;
                                phi_3932_ = type_38();
                                phi_3933_ = true;
                                phi_3934_ = false;
                                phi_3935_ = false;
                                phi_3936_ = false;
                                phi_3937_ = false;
                            }
                            let _e2138 = phi_3930_;
                            let _e2140 = phi_3931_;
                            let _e2142 = phi_3932_;
                            let _e2144 = phi_3933_;
                            let _e2146 = phi_3934_;
                            let _e2148 = phi_3935_;
                            let _e2150 = phi_3936_;
                            let _e2152 = phi_3937_;
                            if _e2144 {
                                let _e2157 = local_7.member[0u];
                                let _e2163 = local_7.member_1[0u];
                                let _e2169 = local_7.member_2[0u];
                                let _e2173 = (_e2157[0] - _e2163[0]);
                                let _e2174 = (_e2157[1] - _e2163[1]);
                                let _e2175 = (_e2157[2] - _e2163[2]);
                                let _e2176 = (_e224.member == 0u);
                                let _e2188 = local_7.member[1u];
                                let _e2194 = local_7.member_1[1u];
                                let _e2200 = local_7.member_2[1u];
                                let _e2204 = (_e2188[0] - _e2194[0]);
                                let _e2205 = (_e2188[1] - _e2194[1]);
                                let _e2206 = (_e2188[2] - _e2194[2]);
                                let _e2207 = (_e224.member == 0u);
                                let _e2219 = local_7.member[0u];
                                let _e2225 = select(_e2219[0], -(_e2219[0]), (_e2219[0] < 0f));
                                let _e2228 = select(_e2219[1], -(_e2219[1]), (_e2219[1] < 0f));
                                let _e2230 = select(_e2228, _e2225, (_e2225 > _e2228));
                                let _e2233 = select(_e2219[2], -(_e2219[2]), (_e2219[2] < 0f));
                                let _e2235 = select(_e2233, _e2230, (_e2230 > _e2233));
                                let _e2238 = local_7.member[1u];
                                let _e2244 = select(_e2238[0], -(_e2238[0]), (_e2238[0] < 0f));
                                let _e2247 = select(_e2238[1], -(_e2238[1]), (_e2238[1] < 0f));
                                let _e2249 = select(_e2247, _e2244, (_e2244 > _e2247));
                                let _e2252 = select(_e2238[2], -(_e2238[2]), (_e2238[2] < 0f));
                                let _e2254 = select(_e2252, _e2249, (_e2249 > _e2252));
                                let _e2258 = local_7.member_3;
                                let _e2262 = local_7.member_1[0u];
                                let _e2268 = select(_e2262[0], -(_e2262[0]), (_e2262[0] < 0f));
                                let _e2271 = select(_e2262[1], -(_e2262[1]), (_e2262[1] < 0f));
                                let _e2273 = select(_e2271, _e2268, (_e2268 > _e2271));
                                let _e2276 = select(_e2262[2], -(_e2262[2]), (_e2262[2] < 0f));
                                let _e2278 = select(_e2276, _e2273, (_e2273 > _e2276));
                                let _e2281 = local_7.member_1[1u];
                                let _e2287 = select(_e2281[0], -(_e2281[0]), (_e2281[0] < 0f));
                                let _e2290 = select(_e2281[1], -(_e2281[1]), (_e2281[1] < 0f));
                                let _e2292 = select(_e2290, _e2287, (_e2287 > _e2290));
                                let _e2295 = select(_e2281[2], -(_e2281[2]), (_e2281[2] < 0f));
                                let _e2297 = select(_e2295, _e2292, (_e2292 > _e2295));
                                let _e2301 = local_7.member_3;
                                let _e2305 = local_7.member_2[0u];
                                let _e2311 = select(_e2305[0], -(_e2305[0]), (_e2305[0] < 0f));
                                let _e2314 = select(_e2305[1], -(_e2305[1]), (_e2305[1] < 0f));
                                let _e2316 = select(_e2314, _e2311, (_e2311 > _e2314));
                                let _e2319 = select(_e2305[2], -(_e2305[2]), (_e2305[2] < 0f));
                                let _e2321 = select(_e2319, _e2316, (_e2316 > _e2319));
                                let _e2324 = local_7.member_2[1u];
                                let _e2330 = select(_e2324[0], -(_e2324[0]), (_e2324[0] < 0f));
                                let _e2333 = select(_e2324[1], -(_e2324[1]), (_e2324[1] < 0f));
                                let _e2335 = select(_e2333, _e2330, (_e2330 > _e2333));
                                let _e2338 = select(_e2324[2], -(_e2324[2]), (_e2324[2] < 0f));
                                let _e2340 = select(_e2338, _e2335, (_e2335 > _e2338));
                                let _e2344 = local_7.member_3;
                                let _e2351 = local_7.member_3;
                                let _e2356 = (_e351 * 0.00390625f);
                                local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_4360_ = type_9(0u, 96u);
                                phi_4363_ = _e2138.member;
                                phi_4365_ = _e2138.member;
                                phi_4367_ = (_e2138.member_1 - _e2138.member);
                                phi_4369_ = _e2138.member;
                                phi_4371_ = false;
                                phi_4373_ = 0u;
                                loop {
                                    let _e2359 = phi_4360_;
                                    let _e2361 = phi_4363_;
                                    let _e2363 = phi_4365_;
                                    let _e2365 = phi_4367_;
                                    let _e2367 = phi_4369_;
                                    let _e2369 = phi_4371_;
                                    let _e2371 = phi_4373_;
                                    local_29 = _e2361;
                                    local_32 = _e2363;
                                    let _e2374 = (_e2359.member < _e2359.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2374)) != 0i) {
                                        let _e2388 = local_7.member[0u];
                                        let _e2394 = local_7.member[1u];
                                        let _e2410 = local_7.member_1[0u];
                                        let _e2416 = local_7.member_1[1u];
                                        let _e2432 = local_7.member_2[0u];
                                        let _e2438 = local_7.member_2[1u];
                                        let _e2452 = function_2(array<f32, 3>((_e2388[0] + ((_e2394[0] - _e2388[0]) * _e2361)), (_e2388[1] + ((_e2394[1] - _e2388[1]) * _e2361)), (_e2388[2] + ((_e2394[2] - _e2388[2]) * _e2361))), array<f32, 3>((_e2410[0] + ((_e2416[0] - _e2410[0]) * _e2361)), (_e2410[1] + ((_e2416[1] - _e2410[1]) * _e2361)), (_e2410[2] + ((_e2416[2] - _e2410[2]) * _e2361))), array<f32, 3>((_e2432[0] + ((_e2438[0] - _e2432[0]) * _e2361)), (_e2432[1] + ((_e2438[1] - _e2432[1]) * _e2361)), (_e2432[2] + ((_e2438[2] - _e2432[2]) * _e2361))), _e224.member);
                                        if (_e2371 == 0u) {
                                            phi_4524_ = _e2452;
                                        } else {
                                            phi_4524_ = array<f32, 3>(select(0f, _e2452[0], (_e2371 == 1u)), select(0f, _e2452[1], (_e2371 == 2u)), select(0f, _e2452[2], (_e2371 == 3u)));
                                        }
                                        let _e2465 = phi_4524_;
                                        let _e2479 = ((select(_e2465[0], -(_e2465[0]), (_e2465[0] < 0f)) + select(_e2465[1], -(_e2465[1]), (_e2465[1] < 0f))) + select(_e2465[2], -(_e2465[2]), (_e2465[2] < 0f)));
                                        if (_e2479 > 0f) {
                                            if ((bitcast<u32>(_e2479) & 2139095040u) != 2139095040u) {
                                                let _e2484 = (1f / _e2479);
                                                let _e2486 = (_e2465[0] * _e2484);
                                                let _e2488 = (_e2465[1] * _e2484);
                                                let _e2490 = (_e2465[2] * _e2484);
                                                let _e2495 = (((_e2486 * _e2486) + (_e2488 * _e2488)) + (_e2490 * _e2490));
                                                if (_e2495 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4647_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2495 > 0f));
                                                } else {
                                                    phi_4590_ = type_14(0i, 5i);
                                                    phi_4593_ = bitcast<f32>(((bitcast<u32>(_e2495) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2503 = phi_4590_;
                                                        let _e2505 = phi_4593_;
                                                        local_20 = _e2505;
                                                        if (_e2503.member < _e2503.member_1) {
                                                            let _e2512 = (_e2503.member + 1i);
                                                            phi_4591_ = type_14(select(_e2512, type_15().member_1, select(false, true, ((false == (_e2512 > _e2503.member)) != false))), _e2503.member_1);
                                                            phi_4634_ = type_15(1u, _e2503.member);
                                                        } else {
                                                            phi_4591_ = _e2503;
                                                            phi_4634_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2523 = phi_4591_;
                                                        let _e2525 = phi_4634_;
                                                        let _e2528 = (bitcast<i32>(_e2525.member) != 0i);
                                                        if _e2528 {
                                                            phi_4594_ = (0.5f * (_e2505 + (_e2495 / _e2505)));
                                                        } else {
                                                            phi_4594_ = f32();
                                                        }
                                                        let _e2533 = phi_4594_;
                                                        continue;
                                                        continuing {
                                                            phi_4590_ = _e2523;
                                                            phi_4593_ = _e2533;
                                                            break if !(_e2528);
                                                        }
                                                    }
                                                    let _e2538 = local_20;
                                                    phi_4647_ = (_e2538 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2544 = phi_4647_;
                                                let _e2545 = (0.000000059604645f * 12f);
                                                let _e2550 = ((((((((select(_e2254, _e2235, (_e2235 > _e2254)) + _e2258) + (select(_e2297, _e2278, (_e2278 > _e2297)) + _e2301)) + (select(_e2340, _e2321, (_e2321 > _e2340)) + _e2344)) * (0.000000059604645f * 16f)) + (_e2351 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2544) * (1f + _e2545)));
                                                let _e2555 = (((_e2486 * _e2157[0]) + (_e2488 * _e2157[1])) + (_e2490 * _e2157[2]));
                                                let _e2560 = (((_e2486 * _e2173) + (_e2488 * _e2174)) + (_e2490 * _e2175));
                                                let _e2565 = (((_e2486 * (_e2157[0] - _e2169[0])) + (_e2488 * (_e2157[1] - _e2169[1]))) + (_e2490 * (_e2157[2] - _e2169[2])));
                                                let _e2570 = (((_e2486 * select((_e2173 - _e2169[0]), _e2157[0], _e2176)) + (_e2488 * select((_e2174 - _e2169[1]), _e2157[1], _e2176))) + (_e2490 * select((_e2175 - _e2169[2]), _e2157[2], _e2176)));
                                                let _e2576 = (((_e2486 * _e2188[0]) + (_e2488 * _e2188[1])) + (_e2490 * _e2188[2]));
                                                let _e2581 = (((_e2486 * _e2204) + (_e2488 * _e2205)) + (_e2490 * _e2206));
                                                let _e2586 = (((_e2486 * (_e2188[0] - _e2200[0])) + (_e2488 * (_e2188[1] - _e2200[1]))) + (_e2490 * (_e2188[2] - _e2200[2])));
                                                let _e2591 = (((_e2486 * select((_e2204 - _e2200[0]), _e2188[0], _e2207)) + (_e2488 * select((_e2205 - _e2200[1]), _e2188[1], _e2207))) + (_e2490 * select((_e2206 - _e2200[2]), _e2188[2], _e2207)));
                                                phi_4770_ = type_30(array<f32, 4>(_e2555, _e2560, _e2565, _e2570), array<f32, 4>(_e2576, _e2581, _e2586, _e2591), array<f32, 4>((_e2550 + ((select(_e2555, -(_e2555), (_e2555 < 0f)) + select(_e2576, -(_e2576), (_e2576 < 0f))) * _e2545)), (_e2550 + ((select(_e2560, -(_e2560), (_e2560 < 0f)) + select(_e2581, -(_e2581), (_e2581 < 0f))) * _e2545)), (_e2550 + ((select(_e2565, -(_e2565), (_e2565 < 0f)) + select(_e2586, -(_e2586), (_e2586 < 0f))) * _e2545)), (_e2550 + ((select(_e2570, -(_e2570), (_e2570 < 0f)) + select(_e2591, -(_e2591), (_e2591 < 0f))) * _e2545))));
                                                phi_4771_ = false;
                                            } else {
                                                phi_4770_ = type_30();
                                                phi_4771_ = true;
                                            }
                                            let _e2632 = phi_4770_;
                                            let _e2634 = phi_4771_;
                                            phi_4772_ = _e2632;
                                            phi_4773_ = _e2634;
                                        } else {
                                            phi_4772_ = type_30();
                                            phi_4773_ = true;
                                        }
                                        let _e2636 = phi_4772_;
                                        let _e2638 = phi_4773_;
                                        if _e2638 {
                                            phi_4781_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_4781_ = _e2636;
                                        }
                                        let _e2640 = phi_4781_;
                                        local_1 = type_30(array<f32, 4>(_e2640.member[0], _e2640.member[1], _e2640.member[2], _e2640.member[3]), array<f32, 4>(_e2640.member_1[0], _e2640.member_1[1], _e2640.member_1[2], _e2640.member_1[3]), array<f32, 4>(_e2640.member_2[0], _e2640.member_2[1], _e2640.member_2[2], _e2640.member_2[3]));
                                        let _e2660 = (_e2361 - _e2367);
                                        let _e2664 = local_1.member[0u];
                                        let _e2667 = local_1.member_1[0u];
                                        let _e2670 = local_1.member[0u];
                                        let _e2676 = local_1.member_2[0u];
                                        if (((_e2664 + ((_e2667 - _e2670) * _e2361)) - _e2676) > 0f) {
                                            let _e2681 = local_1.member[1u];
                                            let _e2684 = local_1.member_1[1u];
                                            let _e2687 = local_1.member[1u];
                                            let _e2693 = local_1.member_2[1u];
                                            if (((_e2681 + ((_e2684 - _e2687) * _e2361)) - _e2693) > 0f) {
                                                let _e2698 = local_1.member[2u];
                                                let _e2701 = local_1.member_1[2u];
                                                let _e2704 = local_1.member[2u];
                                                let _e2710 = local_1.member_2[2u];
                                                if (((_e2698 + ((_e2701 - _e2704) * _e2361)) - _e2710) > 0f) {
                                                    let _e2715 = local_1.member[3u];
                                                    let _e2718 = local_1.member_1[3u];
                                                    let _e2721 = local_1.member[3u];
                                                    let _e2727 = local_1.member_2[3u];
                                                    phi_4952_ = (((_e2715 + ((_e2718 - _e2721) * _e2361)) - _e2727) > 0f);
                                                    phi_4953_ = false;
                                                } else {
                                                    phi_4952_ = bool();
                                                    phi_4953_ = true;
                                                }
                                                let _e2731 = phi_4952_;
                                                let _e2733 = phi_4953_;
                                                phi_4954_ = _e2731;
                                                phi_4955_ = _e2733;
                                            } else {
                                                phi_4954_ = bool();
                                                phi_4955_ = true;
                                            }
                                            let _e2735 = phi_4954_;
                                            let _e2737 = phi_4955_;
                                            phi_4956_ = _e2735;
                                            phi_4957_ = _e2737;
                                        } else {
                                            phi_4956_ = bool();
                                            phi_4957_ = true;
                                        }
                                        let _e2739 = phi_4956_;
                                        let _e2741 = phi_4957_;
                                        if select(_e2739, false, _e2741) {
                                            if (_e2361 <= _e2363) {
                                                phi_5271_ = true;
                                            } else {
                                                let _e2746 = local.member[0u];
                                                let _e2749 = local.member_1[0u];
                                                let _e2752 = local.member[0u];
                                                let _e2758 = local.member_2[0u];
                                                let _e2762 = local_1.member[0u];
                                                let _e2765 = local_1.member_1[0u];
                                                let _e2768 = local_1.member[0u];
                                                let _e2774 = local_1.member_2[0u];
                                                if ((((_e2746 + ((_e2749 - _e2752) * _e2361)) - _e2758) + ((_e2762 + ((_e2765 - _e2768) * _e2367)) - _e2774)) > 0f) {
                                                    let _e2780 = local.member[1u];
                                                    let _e2783 = local.member_1[1u];
                                                    let _e2786 = local.member[1u];
                                                    let _e2792 = local.member_2[1u];
                                                    let _e2796 = local_1.member[1u];
                                                    let _e2799 = local_1.member_1[1u];
                                                    let _e2802 = local_1.member[1u];
                                                    let _e2808 = local_1.member_2[1u];
                                                    if ((((_e2780 + ((_e2783 - _e2786) * _e2361)) - _e2792) + ((_e2796 + ((_e2799 - _e2802) * _e2367)) - _e2808)) > 0f) {
                                                        let _e2814 = local.member[2u];
                                                        let _e2817 = local.member_1[2u];
                                                        let _e2820 = local.member[2u];
                                                        let _e2826 = local.member_2[2u];
                                                        let _e2830 = local_1.member[2u];
                                                        let _e2833 = local_1.member_1[2u];
                                                        let _e2836 = local_1.member[2u];
                                                        let _e2842 = local_1.member_2[2u];
                                                        if ((((_e2814 + ((_e2817 - _e2820) * _e2361)) - _e2826) + ((_e2830 + ((_e2833 - _e2836) * _e2367)) - _e2842)) > 0f) {
                                                            let _e2848 = local.member[3u];
                                                            let _e2851 = local.member_1[3u];
                                                            let _e2854 = local.member[3u];
                                                            let _e2860 = local.member_2[3u];
                                                            let _e2864 = local_1.member[3u];
                                                            let _e2867 = local_1.member_1[3u];
                                                            let _e2870 = local_1.member[3u];
                                                            let _e2876 = local_1.member_2[3u];
                                                            phi_5258_ = ((((_e2848 + ((_e2851 - _e2854) * _e2361)) - _e2860) + ((_e2864 + ((_e2867 - _e2870) * _e2367)) - _e2876)) > 0f);
                                                            phi_5259_ = false;
                                                        } else {
                                                            phi_5258_ = bool();
                                                            phi_5259_ = true;
                                                        }
                                                        let _e2881 = phi_5258_;
                                                        let _e2883 = phi_5259_;
                                                        phi_5260_ = _e2881;
                                                        phi_5261_ = _e2883;
                                                    } else {
                                                        phi_5260_ = bool();
                                                        phi_5261_ = true;
                                                    }
                                                    let _e2885 = phi_5260_;
                                                    let _e2887 = phi_5261_;
                                                    phi_5262_ = _e2885;
                                                    phi_5263_ = _e2887;
                                                } else {
                                                    phi_5262_ = bool();
                                                    phi_5263_ = true;
                                                }
                                                let _e2889 = phi_5262_;
                                                let _e2891 = phi_5263_;
                                                phi_5271_ = select(_e2889, false, _e2891);
                                            }
                                            let _e2894 = phi_5271_;
                                            if _e2894 {
                                                if select(true, select(true, false, (_e2361 >= _e2138.member_1)), _e2369) {
                                                    local = type_30(array<f32, 4>(_e2640.member[0], _e2640.member[1], _e2640.member[2], _e2640.member[3]), array<f32, 4>(_e2640.member_1[0], _e2640.member_1[1], _e2640.member_1[2], _e2640.member_1[3]), array<f32, 4>(_e2640.member_2[0], _e2640.member_2[1], _e2640.member_2[2], _e2640.member_2[3]));
                                                    let _e2919 = local.member[0u];
                                                    let _e2922 = local.member_1[0u];
                                                    let _e2925 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e2922 > _e2925)), (_e2919 > _e2925)) {
                                                        let _e2930 = (_e2922 >= _e2919);
                                                        if _e2930 {
                                                            phi_5380_ = f32();
                                                            phi_5381_ = false;
                                                        } else {
                                                            if ((_e2919 - _e2922) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5378_ = (((_e2919 - _e2925) / (_e2919 - _e2922)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5379_ = false;
                                                            } else {
                                                                phi_5378_ = f32();
                                                                phi_5379_ = true;
                                                            }
                                                            let _e2941 = phi_5378_;
                                                            let _e2943 = phi_5379_;
                                                            phi_5380_ = _e2941;
                                                            phi_5381_ = _e2943;
                                                        }
                                                        let _e2945 = phi_5380_;
                                                        let _e2947 = phi_5381_;
                                                        phi_5382_ = _e2945;
                                                        phi_5383_ = _e2930;
                                                        phi_5384_ = _e2947;
                                                    } else {
                                                        phi_5382_ = f32();
                                                        phi_5383_ = true;
                                                        phi_5384_ = false;
                                                    }
                                                    let _e2949 = phi_5382_;
                                                    let _e2951 = phi_5383_;
                                                    let _e2953 = phi_5384_;
                                                    let _e2956 = select(_e2949, select(_e2361, 2f, _e2951), select(_e2953, true, _e2951));
                                                    let _e2959 = local.member[1u];
                                                    let _e2962 = local.member_1[1u];
                                                    let _e2965 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e2962 > _e2965)), (_e2959 > _e2965)) {
                                                        let _e2970 = (_e2962 >= _e2959);
                                                        if _e2970 {
                                                            phi_5448_ = f32();
                                                            phi_5449_ = false;
                                                        } else {
                                                            if ((_e2959 - _e2962) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5446_ = (((_e2959 - _e2965) / (_e2959 - _e2962)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5447_ = false;
                                                            } else {
                                                                phi_5446_ = f32();
                                                                phi_5447_ = true;
                                                            }
                                                            let _e2981 = phi_5446_;
                                                            let _e2983 = phi_5447_;
                                                            phi_5448_ = _e2981;
                                                            phi_5449_ = _e2983;
                                                        }
                                                        let _e2985 = phi_5448_;
                                                        let _e2987 = phi_5449_;
                                                        phi_5450_ = _e2985;
                                                        phi_5451_ = _e2970;
                                                        phi_5452_ = _e2987;
                                                    } else {
                                                        phi_5450_ = f32();
                                                        phi_5451_ = true;
                                                        phi_5452_ = false;
                                                    }
                                                    let _e2989 = phi_5450_;
                                                    let _e2991 = phi_5451_;
                                                    let _e2993 = phi_5452_;
                                                    let _e2996 = select(_e2989, select(_e2361, 2f, _e2991), select(_e2993, true, _e2991));
                                                    let _e2998 = select(_e2996, _e2956, (_e2956 < _e2996));
                                                    let _e3001 = local.member[2u];
                                                    let _e3004 = local.member_1[2u];
                                                    let _e3007 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3004 > _e3007)), (_e3001 > _e3007)) {
                                                        let _e3012 = (_e3004 >= _e3001);
                                                        if _e3012 {
                                                            phi_5521_ = f32();
                                                            phi_5522_ = false;
                                                        } else {
                                                            if ((_e3001 - _e3004) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5519_ = (((_e3001 - _e3007) / (_e3001 - _e3004)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5520_ = false;
                                                            } else {
                                                                phi_5519_ = f32();
                                                                phi_5520_ = true;
                                                            }
                                                            let _e3023 = phi_5519_;
                                                            let _e3025 = phi_5520_;
                                                            phi_5521_ = _e3023;
                                                            phi_5522_ = _e3025;
                                                        }
                                                        let _e3027 = phi_5521_;
                                                        let _e3029 = phi_5522_;
                                                        phi_5523_ = _e3027;
                                                        phi_5524_ = _e3012;
                                                        phi_5525_ = _e3029;
                                                    } else {
                                                        phi_5523_ = f32();
                                                        phi_5524_ = true;
                                                        phi_5525_ = false;
                                                    }
                                                    let _e3031 = phi_5523_;
                                                    let _e3033 = phi_5524_;
                                                    let _e3035 = phi_5525_;
                                                    let _e3038 = select(_e3031, select(_e2361, 2f, _e3033), select(_e3035, true, _e3033));
                                                    let _e3041 = local.member[3u];
                                                    let _e3044 = local.member_1[3u];
                                                    let _e3047 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3044 > _e3047)), (_e3041 > _e3047)) {
                                                        let _e3052 = (_e3044 >= _e3041);
                                                        if _e3052 {
                                                            phi_5589_ = f32();
                                                            phi_5590_ = false;
                                                        } else {
                                                            if ((_e3041 - _e3044) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5587_ = (((_e3041 - _e3047) / (_e3041 - _e3044)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5588_ = false;
                                                            } else {
                                                                phi_5587_ = f32();
                                                                phi_5588_ = true;
                                                            }
                                                            let _e3063 = phi_5587_;
                                                            let _e3065 = phi_5588_;
                                                            phi_5589_ = _e3063;
                                                            phi_5590_ = _e3065;
                                                        }
                                                        let _e3067 = phi_5589_;
                                                        let _e3069 = phi_5590_;
                                                        phi_5591_ = _e3067;
                                                        phi_5592_ = _e3052;
                                                        phi_5593_ = _e3069;
                                                    } else {
                                                        phi_5591_ = f32();
                                                        phi_5592_ = true;
                                                        phi_5593_ = false;
                                                    }
                                                    let _e3071 = phi_5591_;
                                                    let _e3073 = phi_5592_;
                                                    let _e3075 = phi_5593_;
                                                    let _e3078 = select(_e3071, select(_e2361, 2f, _e3073), select(_e3075, true, _e3073));
                                                    let _e3080 = select(_e3078, _e3038, (_e3038 < _e3078));
                                                    let _e3082 = select(_e3080, _e2998, (_e2998 < _e3080));
                                                    let _e3084 = select(_e2361, _e3082, (_e3082 > _e2361));
                                                    let _e3085 = (_e3084 > _e2138.member_1);
                                                    if _e3085 {
                                                        phi_6122_ = f32();
                                                        phi_6123_ = f32();
                                                        phi_6124_ = false;
                                                    } else {
                                                        let _e3086 = (_e3084 - _e2361);
                                                        phi_6122_ = select((_e2138.member_1 - _e2361), select(0f, (_e2660 + _e2660), select(select(true, false, (_e3086 <= (_e2365 * 0.25f))), true, (_e3086 <= _e2356))), _e2369);
                                                        phi_6123_ = _e3086;
                                                        phi_6124_ = true;
                                                    }
                                                    let _e3097 = phi_6122_;
                                                    let _e3099 = phi_6123_;
                                                    let _e3101 = phi_6124_;
                                                    phi_6126_ = _e3084;
                                                    phi_6127_ = _e3097;
                                                    phi_6128_ = _e3099;
                                                    phi_6130_ = _e3101;
                                                    phi_6131_ = _e3085;
                                                    phi_6133_ = false;
                                                } else {
                                                    phi_6126_ = f32();
                                                    phi_6127_ = f32();
                                                    phi_6128_ = f32();
                                                    phi_6130_ = false;
                                                    phi_6131_ = false;
                                                    phi_6133_ = true;
                                                }
                                                let _e3103 = phi_6126_;
                                                let _e3105 = phi_6127_;
                                                let _e3107 = phi_6128_;
                                                let _e3109 = phi_6130_;
                                                let _e3111 = phi_6131_;
                                                let _e3113 = phi_6133_;
                                                phi_6134_ = _e3103;
                                                phi_6135_ = _e3105;
                                                phi_6136_ = _e3107;
                                                phi_6138_ = false;
                                                phi_6139_ = _e3109;
                                                phi_6140_ = _e3111;
                                                phi_6142_ = _e3113;
                                            } else {
                                                phi_6134_ = f32();
                                                phi_6135_ = f32();
                                                phi_6136_ = f32();
                                                phi_6138_ = true;
                                                phi_6139_ = false;
                                                phi_6140_ = false;
                                                phi_6142_ = false;
                                            }
                                            let _e3115 = phi_6134_;
                                            let _e3117 = phi_6135_;
                                            let _e3119 = phi_6136_;
                                            let _e3121 = phi_6138_;
                                            let _e3123 = phi_6139_;
                                            let _e3125 = phi_6140_;
                                            let _e3127 = phi_6142_;
                                            phi_6143_ = _e3115;
                                            phi_6144_ = _e3117;
                                            phi_6145_ = _e3119;
                                            phi_6147_ = _e3121;
                                            phi_6148_ = _e3123;
                                            phi_6149_ = _e3125;
                                            phi_6151_ = _e3127;
                                        } else {
                                            phi_6143_ = f32();
                                            phi_6144_ = f32();
                                            phi_6145_ = f32();
                                            phi_6147_ = true;
                                            phi_6148_ = false;
                                            phi_6149_ = false;
                                            phi_6151_ = false;
                                        }
                                        let _e3129 = phi_6143_;
                                        let _e3131 = phi_6144_;
                                        let _e3133 = phi_6145_;
                                        let _e3135 = phi_6147_;
                                        let _e3137 = phi_6148_;
                                        let _e3139 = phi_6149_;
                                        let _e3141 = phi_6151_;
                                        if _e3135 {
                                            if (_e2361 <= _e2363) {
                                                let _e3294 = (_e2371 + 1u);
                                                let _e3295 = (_e3294 > 3u);
                                                phi_6486_ = _e3294;
                                                phi_6487_ = f32();
                                                phi_6488_ = false;
                                                phi_6489_ = select(true, false, _e3295);
                                                phi_6490_ = _e3295;
                                            } else {
                                                let _e3145 = local.member[0u];
                                                let _e3148 = local.member_1[0u];
                                                let _e3151 = local.member[0u];
                                                let _e3157 = local.member_2[0u];
                                                let _e3158 = ((_e3145 + ((_e3148 - _e3151) * _e2367)) - _e3157);
                                                let _e3161 = local.member[1u];
                                                let _e3164 = local.member_1[1u];
                                                let _e3167 = local.member[1u];
                                                let _e3173 = local.member_2[1u];
                                                let _e3174 = ((_e3161 + ((_e3164 - _e3167) * _e2367)) - _e3173);
                                                let _e3176 = select(_e3174, _e3158, (_e3158 < _e3174));
                                                let _e3179 = local.member[2u];
                                                let _e3182 = local.member_1[2u];
                                                let _e3185 = local.member[2u];
                                                let _e3191 = local.member_2[2u];
                                                let _e3192 = ((_e3179 + ((_e3182 - _e3185) * _e2367)) - _e3191);
                                                let _e3195 = local.member[3u];
                                                let _e3198 = local.member_1[3u];
                                                let _e3201 = local.member[3u];
                                                let _e3207 = local.member_2[3u];
                                                let _e3208 = ((_e3195 + ((_e3198 - _e3201) * _e2367)) - _e3207);
                                                let _e3210 = select(_e3208, _e3192, (_e3192 < _e3208));
                                                let _e3212 = select(_e3210, _e3176, (_e3176 < _e3210));
                                                let _e3215 = local_1.member[0u];
                                                let _e3218 = local_1.member_1[0u];
                                                let _e3221 = local_1.member[0u];
                                                let _e3227 = local_1.member_2[0u];
                                                let _e3228 = ((_e3215 + ((_e3218 - _e3221) * _e2361)) - _e3227);
                                                let _e3231 = local_1.member[1u];
                                                let _e3234 = local_1.member_1[1u];
                                                let _e3237 = local_1.member[1u];
                                                let _e3243 = local_1.member_2[1u];
                                                let _e3244 = ((_e3231 + ((_e3234 - _e3237) * _e2361)) - _e3243);
                                                let _e3246 = select(_e3244, _e3228, (_e3228 < _e3244));
                                                let _e3249 = local_1.member[2u];
                                                let _e3252 = local_1.member_1[2u];
                                                let _e3255 = local_1.member[2u];
                                                let _e3261 = local_1.member_2[2u];
                                                let _e3262 = ((_e3249 + ((_e3252 - _e3255) * _e2361)) - _e3261);
                                                let _e3265 = local_1.member[3u];
                                                let _e3268 = local_1.member_1[3u];
                                                let _e3271 = local_1.member[3u];
                                                let _e3277 = local_1.member_2[3u];
                                                let _e3278 = ((_e3265 + ((_e3268 - _e3271) * _e2361)) - _e3277);
                                                let _e3280 = select(_e3278, _e3262, (_e3262 < _e3278));
                                                let _e3282 = select(_e3280, _e3246, (_e3246 < _e3280));
                                                if (_e3282 > 0f) {
                                                    phi_6484_ = 0.5f;
                                                } else {
                                                    let _e3286 = (0.95f * (_e3212 / (_e3212 - _e3282)));
                                                    phi_6484_ = select(0.0625f, select(0.9f, _e3286, (_e3286 < 0.9f)), (_e3286 > 0.0625f));
                                                }
                                                let _e3292 = phi_6484_;
                                                phi_6486_ = u32();
                                                phi_6487_ = (_e2660 * _e3292);
                                                phi_6488_ = true;
                                                phi_6489_ = false;
                                                phi_6490_ = false;
                                            }
                                            let _e3298 = phi_6486_;
                                            let _e3300 = phi_6487_;
                                            let _e3302 = phi_6488_;
                                            let _e3304 = phi_6489_;
                                            let _e3306 = phi_6490_;
                                            phi_6491_ = _e3298;
                                            phi_6492_ = _e2363;
                                            phi_6493_ = _e3300;
                                            phi_6494_ = _e2365;
                                            phi_6495_ = _e2367;
                                            phi_6496_ = _e2369;
                                            phi_6497_ = _e2371;
                                            phi_6498_ = _e3302;
                                            phi_6499_ = _e3304;
                                            phi_6500_ = _e3306;
                                            phi_6501_ = false;
                                            phi_6503_ = false;
                                        } else {
                                            phi_6491_ = u32();
                                            phi_6492_ = _e3129;
                                            phi_6493_ = _e3131;
                                            phi_6494_ = _e3133;
                                            phi_6495_ = _e2361;
                                            phi_6496_ = true;
                                            phi_6497_ = 0u;
                                            phi_6498_ = _e3137;
                                            phi_6499_ = false;
                                            phi_6500_ = false;
                                            phi_6501_ = _e3139;
                                            phi_6503_ = _e3141;
                                        }
                                        let _e3308 = phi_6491_;
                                        let _e3310 = phi_6492_;
                                        let _e3312 = phi_6493_;
                                        let _e3314 = phi_6494_;
                                        let _e3316 = phi_6495_;
                                        let _e3318 = phi_6496_;
                                        let _e3320 = phi_6497_;
                                        let _e3322 = phi_6498_;
                                        let _e3324 = phi_6499_;
                                        let _e3326 = phi_6500_;
                                        let _e3328 = phi_6501_;
                                        let _e3330 = phi_6503_;
                                        if _e3322 {
                                            let _e3331 = (_e3316 + _e3312);
                                            let _e3333 = select(_e3310, _e3331, (_e3331 > _e3310));
                                            let _e3335 = select(_e2138.member_1, _e3333, (_e3333 < _e2138.member_1));
                                            let _e3338 = select(((_e3335 - _e3316) > _e2356), true, !(_e2369));
                                            phi_6531_ = _e3335;
                                            phi_6532_ = _e3310;
                                            phi_6533_ = _e3314;
                                            phi_6534_ = _e3316;
                                            phi_6535_ = _e3318;
                                            phi_6536_ = _e3320;
                                            phi_6537_ = _e3338;
                                            phi_6538_ = select(true, false, _e3338);
                                            phi_6539_ = false;
                                            phi_6540_ = false;
                                            phi_6542_ = false;
                                        } else {
                                            phi_6531_ = _e2361;
                                            phi_6532_ = _e2363;
                                            phi_6533_ = _e2365;
                                            phi_6534_ = _e2367;
                                            phi_6535_ = _e2369;
                                            phi_6536_ = _e3308;
                                            phi_6537_ = _e3324;
                                            phi_6538_ = false;
                                            phi_6539_ = _e3326;
                                            phi_6540_ = _e3328;
                                            phi_6542_ = _e3330;
                                        }
                                        let _e3341 = phi_6531_;
                                        let _e3343 = phi_6532_;
                                        let _e3345 = phi_6533_;
                                        let _e3347 = phi_6534_;
                                        let _e3349 = phi_6535_;
                                        let _e3351 = phi_6536_;
                                        let _e3353 = phi_6537_;
                                        let _e3355 = phi_6538_;
                                        let _e3357 = phi_6539_;
                                        let _e3359 = phi_6540_;
                                        let _e3361 = phi_6542_;
                                        phi_4364_ = _e3341;
                                        phi_4366_ = _e3343;
                                        phi_4368_ = _e3345;
                                        phi_4370_ = _e3347;
                                        phi_4372_ = _e3349;
                                        phi_4374_ = _e3351;
                                        phi_6543_ = _e3310;
                                        phi_6545_ = _e3353;
                                        phi_6546_ = _e3355;
                                        phi_6547_ = _e3357;
                                        phi_6548_ = _e3359;
                                        phi_6550_ = false;
                                        phi_6551_ = _e3361;
                                    } else {
                                        phi_4364_ = f32();
                                        phi_4366_ = f32();
                                        phi_4368_ = f32();
                                        phi_4370_ = f32();
                                        phi_4372_ = bool();
                                        phi_4374_ = u32();
                                        phi_6543_ = f32();
                                        phi_6545_ = false;
                                        phi_6546_ = false;
                                        phi_6547_ = false;
                                        phi_6548_ = false;
                                        phi_6550_ = true;
                                        phi_6551_ = false;
                                    }
                                    let _e3363 = phi_4364_;
                                    let _e3365 = phi_4366_;
                                    let _e3367 = phi_4368_;
                                    let _e3369 = phi_4370_;
                                    let _e3371 = phi_4372_;
                                    let _e3373 = phi_4374_;
                                    let _e3375 = phi_6543_;
                                    let _e3377 = phi_6545_;
                                    let _e3379 = phi_6546_;
                                    let _e3381 = phi_6547_;
                                    let _e3383 = phi_6548_;
                                    let _e3385 = phi_6550_;
                                    let _e3387 = phi_6551_;
                                    local_21 = _e3379;
                                    local_22 = _e3381;
                                    local_23 = _e3379;
                                    local_24 = _e3383;
                                    local_25 = _e3379;
                                    local_26 = _e3385;
                                    local_27 = _e3379;
                                    local_28 = _e3387;
                                    local_30 = _e3379;
                                    local_31 = _e3375;
                                    continue;
                                    continuing {
                                        phi_4360_ = type_9(select(_e2359.member, (_e2359.member + 1u), _e2374), select(_e2359.member_1, _e2359.member_1, _e2374));
                                        phi_4363_ = _e3363;
                                        phi_4365_ = _e3365;
                                        phi_4367_ = _e3367;
                                        phi_4369_ = _e3369;
                                        phi_4371_ = _e3371;
                                        phi_4373_ = _e3373;
                                        break if !(_e3377);
                                    }
                                }
                                let _e3390 = local_21;
                                let _e3392 = local_22;
                                let _e3393 = select(_e3392, false, _e3390);
                                let _e3395 = local_23;
                                let _e3397 = local_24;
                                let _e3400 = local_25;
                                let _e3402 = local_26;
                                let _e3405 = local_27;
                                let _e3407 = local_28;
                                let _e3413 = local_29;
                                let _e3415 = select(select(_e3397, false, _e3395), false, _e3393);
                                let _e3417 = local_30;
                                let _e3424 = select(select(_e3417, false, _e3393), false, _e3415);
                                let _e3429 = local_31;
                                let _e3431 = local_32;
                                let _e3433 = select(select(select(select(_e3402, false, _e3400), false, _e3393), false, _e3415), true, _e3424);
                                let _e3440 = select(select(select(select(select(_e3407, false, _e3405), false, _e3393), false, _e3415), false, _e3424), false, _e3433);
                                let _e3445 = select(select(select(select(_e3393, true, _e3415), false, _e3424), false, _e3433), true, _e3440);
                                let _e3448 = (select(select(type_33().member, 1u, _e3433), select(select(select(type_33().member, 1u, _e3393), 0u, _e3415), 0u, _e3440), _e3445) != 0u);
                                phi_6619_ = select(select(type_33().member_1, select(_e3431, _e3429, _e3424), _e3433), select(select(select(type_33().member_1, _e3413, _e3393), type_33().member_1, _e3415), type_33().member_1, _e3440), _e3445);
                                phi_6620_ = select(true, false, _e3448);
                                phi_6621_ = _e3448;
                                phi_6622_ = false;
                                phi_6623_ = false;
                                phi_6624_ = false;
                            } else {
                                phi_6619_ = f32();
                                phi_6620_ = _e2146;
                                phi_6621_ = false;
                                phi_6622_ = _e2148;
                                phi_6623_ = _e2150;
                                phi_6624_ = _e2152;
                            }
                            let _e3451 = phi_6619_;
                            let _e3453 = phi_6620_;
                            let _e3455 = phi_6621_;
                            let _e3457 = phi_6622_;
                            let _e3459 = phi_6623_;
                            let _e3461 = phi_6624_;
                            phi_6625_ = _e2138;
                            phi_6626_ = _e2140;
                            phi_6627_ = _e3451;
                            phi_6628_ = _e2142;
                            phi_6629_ = _e3453;
                            phi_6630_ = _e3455;
                            phi_6631_ = false;
                            phi_6632_ = _e3457;
                            phi_6633_ = _e3459;
                            phi_6634_ = _e3461;
                        } else {
                            phi_6625_ = type_38();
                            phi_6626_ = bool();
                            phi_6627_ = f32();
                            phi_6628_ = type_38();
                            phi_6629_ = false;
                            phi_6630_ = false;
                            phi_6631_ = true;
                            phi_6632_ = false;
                            phi_6633_ = false;
                            phi_6634_ = false;
                        }
                        let _e3463 = phi_6625_;
                        let _e3465 = phi_6626_;
                        let _e3467 = phi_6627_;
                        let _e3469 = phi_6628_;
                        let _e3471 = phi_6629_;
                        let _e3473 = phi_6630_;
                        let _e3475 = phi_6631_;
                        let _e3477 = phi_6632_;
                        let _e3479 = phi_6633_;
                        let _e3481 = phi_6634_;
                        local_33 = _e3473;
                        local_34 = _e3465;
                        local_35 = _e3463;
                        local_36 = _e3467;
                        local_37 = _e3467;
                        local_38 = _e3467;
                        local_42 = _e3475;
                        local_43 = _e3477;
                        local_44 = _e3479;
                        local_45 = _e3481;
                        local_39 = _e3473;
                        local_40 = _e3469;
                        continue;
                        continuing {
                            phi_2505_ = type_9(select(_e1160.member, (_e1160.member + 1u), _e1163), select(_e1160.member_1, _e1160.member_1, _e1163));
                            break if !(_e3471);
                        }
                    }
                    let _e3484 = local_33;
                    if _e3484 {
                        let _e3486 = local_34;
                        if _e3486 {
                            let _e3488 = local_35;
                            let _e3491 = local_36;
                            let _e3493 = ((_e3488.member_1 - _e3491) <= _e1124);
                            let _e3498 = local_37;
                            phi_6650_ = type_33(select(type_33().member, 1u, _e3493), select(type_33().member_1, _e3498, _e3493));
                            phi_6651_ = select(true, false, _e3493);
                        } else {
                            phi_6650_ = type_33();
                            phi_6651_ = true;
                        }
                        let _e3503 = phi_6650_;
                        let _e3505 = phi_6651_;
                        let _e3510 = local_38;
                        phi_6657_ = type_33(select(_e3503.member, 2u, _e3505), select(_e3503.member_1, _e3510, _e3505));
                        phi_6658_ = false;
                        phi_6659_ = false;
                        phi_6660_ = false;
                        phi_6661_ = false;
                    } else {
                        phi_6657_ = type_33();
                        let _e4013 = local_42;
                        phi_6658_ = _e4013;
                        let _e4016 = local_43;
                        phi_6659_ = _e4016;
                        let _e4019 = local_44;
                        phi_6660_ = _e4019;
                        let _e4022 = local_45;
                        phi_6661_ = _e4022;
                    }
                    let _e3514 = phi_6657_;
                    let _e3516 = phi_6658_;
                    let _e3518 = phi_6659_;
                    let _e3520 = phi_6660_;
                    let _e3522 = phi_6661_;
                    let _e3529 = select(_e3518, false, _e3516);
                    let _e3533 = local_39;
                    let _e3540 = select(select(_e3520, false, _e3516), false, _e3529);
                    let _e3546 = select(select(select(_e3522, false, _e3516), false, _e3529), false, _e3540);
                    let _e3550 = local_40;
                    let _e3554 = select(select(_e3529, true, _e3540), true, _e3546);
                    phi_6703_ = type_33(select(_e3514.member, select(select(select(type_33().member, 0u, _e3529), 0u, _e3540), 1u, _e3546), _e3554), select(_e3514.member_1, select(select(select(type_33().member_1, type_33().member_1, _e3529), type_33().member_1, _e3540), _e3550.member, _e3546), _e3554));
                    phi_6704_ = type_33(select(type_33().member, 0u, _e3516), select(type_33().member_1, type_33().member_1, _e3516));
                    phi_6705_ = select(select(select(select(select(_e3533, false, _e3516), false, _e3529), false, _e3540), false, _e3546), true, _e3554);
                }
                let _e3565 = phi_6703_;
                let _e3567 = phi_6704_;
                let _e3569 = phi_6705_;
                let _e3572 = select(_e3567.member, _e3565.member, _e3569);
                let _e3575 = select(_e3567.member_1, _e3565.member_1, _e3569);
                let _e3581 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3575 > _e353)), (_e3572 == 1u))));
                switch bitcast<i32>(_e3572) {
                    case 0: {
                        phi_6749_ = type_31(0u, _e3581, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3585 = function_3(_e3575);
                        phi_6749_ = type_31(0u, _e3581, _e3585, true);
                        break;
                    }
                    case 2: {
                        let _e3583 = function_3(_e3575);
                        phi_6749_ = type_31(1u, _e3581, _e3583, true);
                        break;
                    }
                    default: {
                        phi_6749_ = type_31();
                        break;
                    }
                }
                let _e3589 = phi_6749_;
                let _e3593 = params.member.member.member_12;
                let _e3594 = bitcast<u32>(_e3593);
                if (_e3589.member_2[0] == select((_e3594 << bitcast<u32>(29i)), 0u, ((_e3594 & 2147483647u) < 8388608u))) {
                    let _e3604 = params.member.member.member_12;
                    let _e3605 = bitcast<u32>(_e3604);
                    let _e3606 = (_e3605 & 2147483647u);
                    phi_6789_ = (_e3589.member_2[1] == select(((_e3605 ^ _e3606) | ((_e3606 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3606 < 8388608u)));
                } else {
                    phi_6789_ = false;
                }
                let _e3616 = phi_6789_;
                let _e3618 = params.member.member.member_1;
                if ((_e3618 & 128u) != 0u) {
                    phi_6805_ = true;
                } else {
                    let _e3622 = params.member.member.member_1;
                    phi_6805_ = select(false, _e3616, ((_e3622 & 64u) != 0u));
                }
                let _e3627 = phi_6805_;
                local_8 = type_31(select(1u, _e3589.member, select(true, select(true, false, _e3627), _e3589.member_3)), _e3589.member_1, array<u32, 2>(_e3589.member_2[0], _e3589.member_2[1]), _e3589.member_3);
                phi_6832_ = type_9(_e182, _e185);
            } else {
                phi_6832_ = type_9(0u, 0u);
            }
            let _e3641 = phi_6832_;
            let _e3647 = local_8.member;
            let _e3649 = select(true, false, (_e3647 == 0u));
            let _e3651 = local_8.member_3;
            if _e3651 {
                if _e3649 {
                    phi_6861_ = true;
                } else {
                    let _e3653 = params.member.member.member_1;
                    phi_6861_ = ((_e3653 & 16u) != 0u);
                }
                let _e3657 = phi_6861_;
                phi_6862_ = _e3657;
            } else {
                phi_6862_ = false;
            }
            let _e3659 = phi_6862_;
            let _e3661 = local_8.member_3;
            if _e3661 {
                if _e3649 {
                } else {
                    let _e3663 = local_8.member_2;
                    let _e3667 = (_e3663[1] >> bitcast<u32>(20i));
                    let _e3681 = atomicMin((&earliest.member[0u]), select(((((_e3667 - 896u) << bitcast<u32>(23i)) | ((_e3663[1] & 1048575u) << bitcast<u32>(3i))) | (_e3663[0] >> bitcast<u32>(29i))), 0u, (_e3667 <= 896u)));
                }
            }
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3659 {
                let _e3685 = atomicAdd((&counters[0u]), 1u);
                phi_6905_ = _e3685;
            } else {
                phi_6905_ = 0u;
            }
            let _e3687 = phi_6905_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e3690 = atomicLoad((&counters[0u]));
                if (_e3690 > 0u) {
                    let _e3693 = atomicAdd((&contacts.member[0u]), _e3690);
                    atomicStore((&counters[1u]), _e3693);
                }
            }
            workgroupBarrier();
            let _e3696 = atomicLoad((&counters[1u]));
            let _e3697 = (_e3696 + _e3687);
            if _e3659 {
                let _e3699 = params.member.member_1.member_3;
                if (_e3697 < _e3699) {
                    let _e3705 = (7u * _e3697);
                    atomicStore((&contacts.member[(4u + _e3705)]), select(1u, 0u, ((_e3641.member_1 & 2147483648u) == 0u)));
                    let _e3710 = local_8.member;
                    atomicStore((&contacts.member[(_e3705 + 5u)]), _e3710);
                    atomicStore((&contacts.member[(_e3705 + 6u)]), _e3641.member);
                    atomicStore((&contacts.member[(_e3705 + 7u)]), (_e3641.member_1 & 2147483647u));
                    let _e3719 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e3705 + 8u)]), _e3719);
                    let _e3724 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e3705 + 9u)]), _e3724);
                    let _e3728 = local_8.member_1;
                    atomicStore((&contacts.member[(_e3705 + 10u)]), _e3728);
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
